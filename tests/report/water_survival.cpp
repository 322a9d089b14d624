// The water's extremes: depths, films, pits, islands, steps, sizes.
#include <cmath>
#include <memory>
#include <random>

#include "format.hpp"
#include "survival.hpp"
#include "water_parts.hpp"

namespace report {
namespace {

const std::size_t kSide = 24, kSteps = 1000;
const double kFrame = 1.0 / 60;

// What a trial is to do: fill the water, and tell afterwards how far it is from where it must be, if anyone knows.
struct Scene {
    std::string name;
    std::function<void(Water&)> fill;
    std::function<double(const Water&)> error = {};
    double dt = kFrame;
    std::size_t steps = kSteps, nx = kSide, ny = kSide;
    double cell = 1;
};

void level_at(Water& water, const std::vector<double>& bed, double surface) {
    water.write(CD_BED, bed);
    water.write(CD_SURFACE, std::vector<double>(bed.size(), surface));
}

// How far the surface of what is wet has moved from `surface`, over the greatest depth.
std::function<double(const Water&)> still(double surface) {
    return [surface](const Water& water) {
        const std::vector<double> depth = water.read(CD_DEPTH), there = water.read(CD_SURFACE);
        double off = 0, deepest = 0;
        for (std::size_t k = 0; k < depth.size(); ++k) {
            if (depth[k] > 0) off = std::fmax(off, std::fabs(there[k] - surface));
            deepest = std::fmax(deepest, depth[k]);
        }
        return off / deepest;
    };
}

std::function<void(Water&)> waves(double depth, double share, std::size_t nx = kSide, std::size_t ny = kSide) {
    return [=](Water& water) {
        water.write(CD_BED, std::vector<double>(nx * ny, -depth));
        water.write(CD_SURFACE, over_cells(nx, ny, 1.0 / double(nx), [=](double x, double y) {
                        return depth * share * std::cos(9 * x) * std::cos(5 * y);
                    }));
    };
}

Trial run(const Scene& scene, Way way, cd_precision precision) {
    Trial trial{scene.name, method(way).name, precision};
    auto water = std::make_shared<Water>(scene.nx, scene.ny, scene.cell, scene.cell, precision);
    water->set(method(way));
    scene.fill(*water);
    check(cd_water_restart_account(water->get()));
    trial.outcome = outcome_of(cd_water_step(water->get(), scene.dt, scene.steps));
    if (scene.error) trial.error = scene.error(*water);
    for (double d : water->read(CD_DEPTH))
        if (!(d >= 0)) trial.outcome = "a negative depth";
    double off = 0;
    check(cd_water_get_account(water->get(), nullptr, nullptr, nullptr, &off));
    trial.drift = std::fabs(off) / water->volume();
    trial.hash = water->hash();
    const std::size_t cells = scene.nx * scene.ny, steps = std::max<std::size_t>(1, 200000 / cells);
    trial.node_steps = double(cells * steps);
    const double dt = scene.dt;
    trial.again = [=] { cd_water_step(water->get(), dt, steps); };
    return trial;
}

std::vector<Scene> scenes(const Report& report) {
    std::vector<Scene> all = {{"ordinary", waves(1, 0.05)}};
    for (double depth : {1e-12, 1e-6, 1e4})
        all.push_back({"depth " + nearest_power_of_ten(depth) + " m", waves(depth, 0.05)});
    all.push_back({"steps of 10⁻⁹ s", waves(1, 0.05)});
    all.back().dt = 1e-9;
    all.push_back({"steps of 10⁶ s", waves(1, 0.05)});
    all.back().dt = 1e6;
    all.push_back({"film of 1 mm on a slope of 45°", [](Water& water) {
                       water.write(CD_BED, over_cells(kSide, kSide, 1, [](double x, double) { return x; }));
                       water.write(CD_DEPTH, std::vector<double>(kSide * kSide, 1e-3));
                   }});
    all.push_back({"level among random islands",
                   [](Water& water) {
                       std::mt19937 random(3);
                       std::vector<double> bed;
                       for (std::size_t k = 0; k < kSide * kSide; ++k)
                           bed.push_back(double(float(double(random()) / 1073741824.0 - 2)));
                       level_at(water, bed, 0);
                   },
                   still(0)});
    all.push_back({"level over a cell 10⁶ times as deep",
                   [](Water& water) {
                       std::vector<double> bed(kSide * kSide, -1);
                       bed[kSide * kSide / 2] = -1e6;
                       level_at(water, bed, 0);
                   },
                   still(0)});
    all.push_back({"waves over a cell 10⁶ times as deep", [](Water& water) {
                       waves(1, 0.05)(water);
                       const double deep = -1e6;
                       check(cd_water_set_bed_rule(water.get(), CD_BED_KEEPS_SURFACE));
                       check(cd_water_write_f64(water.get(), CD_BED, kSide / 2, kSide / 2, 1, 1, &deep, 1));
                   }});
    all.push_back({"1 cell", waves(1, 0.05, 1, 1), still(0.05 * std::cos(4.5) * std::cos(2.5))});
    all.back().nx = all.back().ny = 1;
    all.push_back({"1 row", waves(1, 0.05, 500, 1)});
    all.back().nx = 500, all.back().ny = 1;
    all.push_back({"1 column", waves(1, 0.05, 1, 500)});
    all.back().nx = 1, all.back().ny = 500;
    const std::size_t large = report.by_extent<std::size_t>(300, 3162);
    all.push_back({count(double(large)) + " × " + count(double(large)) + " cells", waves(1, 0.05, large, large)});
    all.back().nx = all.back().ny = large, all.back().steps = 2;
    const std::size_t many = report.by_extent<std::size_t>(2000, 1000000);
    for (bool decays : {true, false}) {
        all.push_back({count(double(many)) + (decays ? " steps of dying out" : " steps"), [decays](Water& water) {
                           waves(1, 0.05, 8, 8)(water);
                           if (decays) check(cd_water_set_drag(water.get(), 2));
                       }});
        all.back().steps = many, all.back().nx = all.back().ny = 8;
    }
    return all;
}

} // namespace

void report_water_survival(Report& report) {
    report.page.section("water-survival", "Water: extreme depths, streams and steps");
    report.page.paragraph(
        "A pool of 24 × 24 cells of 1 m with waves a twentieth of its depth, 1000 steps at 60 a second, and then "
        "everything that can be unreasonable about it, one at a time. To survive, no number may leave the finite range "
        "and no depth may be negative.");
    SurvivalSheet sheet(report, "water", "volume");
    for (cd_precision precision : precisions())
        for (Way way : {Way::water_linear, Way::water_advected})
            for (const Scene& scene : scenes(report)) sheet.add(run(scene, way, precision));
    sheet.finish(
        "Errors, where an exact answer is known, are of lakes that must stay level: the greatest change of the "
        "surface over the greatest depth.",
        "Volume is compared with the account. Rows, columns and small pools cost more a cell than squares.");
}

} // namespace report
