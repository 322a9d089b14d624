// What a cell and step of water costs, in time and in memory: each feature switched on, and two sizes beside the
// textbook.
#include <cmath>
#include <functional>

#include "format.hpp"
#include "textbook_water.hpp"
#include "timing.hpp"
#include "water_parts.hpp"

namespace report {
namespace {

const double kCell = 0.1, kFrame = 1.0 / 60;

struct Feature {
    std::string key, name;
    Way way;
    cd_precision precision;
    std::function<void(Water&, std::size_t)> add;
};

void nothing(Water&, std::size_t) {}

void switch_on(Water& water, cd_field field, std::size_t numbers, double value) {
    water.enable(field);
    water.write(field, std::vector<double>(numbers, value));
}

std::vector<Feature> features() {
    const cd_precision narrow = precisions().back();
    auto linear = [&](const char* key, const char* name, std::function<void(Water&, std::size_t)> add) {
        return Feature{key, name, Way::water_linear, narrow, std::move(add)};
    };
    std::vector<Feature> all = {
        linear("plain", "linear λ = 0.55, walled in, no fields", nothing),
        linear("friction", "with drag and Manning's friction",
               [](Water& w, std::size_t) {
                   check(cd_water_set_drag(w.get(), 0.01));
                   check(cd_water_set_manning(w.get(), 0.03));
               }),
        linear("open", "with four open sides",
               [](Water& w, std::size_t) {
                   for (cd_side side : {CD_SIDE_X_FIRST, CD_SIDE_X_LAST, CD_SIDE_Y_FIRST, CD_SIDE_Y_LAST})
                       check(cd_water_set_side(w.get(), side, CD_BORDER_OPEN, 0, 0));
               }),
        linear("sources", "with sources", [](Water& w, std::size_t n) { switch_on(w, CD_SOURCE, n * n, 1e-6); }),
        linear("pressure", "with pressure", [](Water& w, std::size_t n) { switch_on(w, CD_PRESSURE, n * n, 1); }),
        linear("force", "with forces along x and y",
               [](Water& w, std::size_t n) {
                   switch_on(w, CD_FORCE_X, n * (n + 1), 1e-3);
                   switch_on(w, CD_FORCE_Y, n * (n + 1), 1e-3);
               }),
        linear("mask", "with a mask, a round pool",
               [](Water& w, std::size_t n) {
                   w.enable(CD_MASK);
                   w.write(CD_MASK, over_cells(n, n, 1.0 / double(n), [](double x, double y) {
                               return std::hypot(x - 0.5, y - 0.5) < 0.49 ? 1.0 : 0.0;
                           }));
               }),
        linear("beach", "on a beach, half of it dry",
               [](Water& w, std::size_t n) {
                   w.write(CD_DEPTH, std::vector<double>(n * n, 0.0));
                   w.write(CD_BED, over_cells(n, n, 1.0 / double(n), [](double x, double) { return 2 * x - 1; }));
                   w.write(CD_SURFACE, over_cells(n, n, 1.0 / double(n), [](double x, double y) {
                               return 0.05 * std::cos(9 * y) * std::cos(3 * x);
                           }));
               }),
    };
    for (Way way : {Way::water_advected, Way::water_explicit, Way::water_explicit_advected})
        all.push_back({method(way).key, method(way).name, way, narrow, nothing});
    if (precisions().front() != narrow)
        for (Way way : {Way::water_linear, Way::water_advected})
            all.push_back({std::string(way == Way::water_linear ? "plain" : "advected") + ".float64",
                           method(way).name + ", float64", way, precisions().front(), nothing});
    return all;
}

// Waves 5 cm high on water 1 m deep, level with 0.
std::unique_ptr<Water> waves(std::size_t n, const Feature& feature) {
    auto water = std::make_unique<Water>(n, n, kCell, kCell, feature.precision);
    water->write(CD_BED, std::vector<double>(n * n, -1.0));
    water->write(CD_SURFACE, over_cells(n, n, 1.0 / double(n),
                                        [](double x, double y) { return 0.05 * std::cos(19 * x) * std::cos(13 * y); }));
    water->set(method(feature.way));
    feature.add(*water, n);
    return water;
}

double step_of(const Water& water, const Feature& feature) {
    double stable = kFrame;
    if (method(feature.way).is_explicit()) check(cd_water_stable_dt(water.get(), &stable));
    return std::fmin(kFrame, 0.7 * stable);
}

std::size_t steps_of(std::size_t n) { return std::max<std::size_t>(2, std::size_t(4e5 / double(n * n))); }

void cost_of_features(Report& report) {
    const std::size_t n = report.by_extent<std::size_t>(48, 256);
    const double cells = double(n * n);
    const std::vector<Feature> all = features();
    std::vector<std::unique_ptr<Water>> waters;
    std::vector<Job> jobs;
    for (const Feature& feature : all) {
        waters.push_back(waves(n, feature));
        Water* water = waters.back().get();
        const double dt = step_of(*water, feature);
        const std::size_t steps = steps_of(n);
        jobs.push_back({[] {}, [=] { check(cd_water_step(water->get(), dt, steps)); }});
    }
    time_in_turns(jobs, report.by_extent(1e-3, 0.1), report.by_extent<std::size_t>(1, 3), 15);
    Table table{{"feature", "ns per cell and step", "of the plain one", "bytes per cell"}, {}, {}};
    Csv csv("feature,ns_per_cell_step,of_plain,bytes_per_cell");
    auto nanoseconds = [&](std::size_t i) { return jobs[i].least() / double(steps_of(n)) / cells * 1e9; };
    for (std::size_t i = 0; i < all.size(); ++i) {
        std::size_t bytes = 0;
        check(cd_water_get_memory(waters[i]->get(), &bytes));
        const double each = double(bytes) / cells, ns = nanoseconds(i);
        table.rows.push_back({all[i].name, number(ns, 3) + spread_words(jobs[i].spread()),
                              number(ns / nanoseconds(0), 2) + "×", number(each, 3)});
        csv.row(all[i].key, ns, ns / nanoseconds(0), each);
        report.summary("water.cost.ns_per_cell_step." + all[i].key, ns, "ns");
        report.summary("water.cost.bytes_per_cell." + all[i].key, each, "bytes");
    }
    report.page.table(table, "A cell of the plain water takes " + number(nanoseconds(0), 2) +
                                 " ns a step, and a feature costs only where it is switched on. " + std::to_string(n) +
                                 " × " + std::to_string(n) + " cells of 0.1 m in " + name_of(all[0].precision) +
                                 " if nothing else is said, 1 m deep with waves of 5 cm, 60 steps a second (explicit: "
                                 "seven tenths of their limit if that is shorter); memory is all that the water holds. "
                                 "All in one process, in turns.");
    report.save("water_cost.csv", csv);
    report.progress("water: cost of features");
}

void cost_beside_the_textbook(Report& report) {
    std::vector<std::size_t> sides = {256, 1024};
    if (report.extent == Extent::sample) sides = {32, 64};
    std::vector<Feature> all;
    for (Way way : {Way::water_linear, Way::water_advected, Way::water_explicit})
        for (cd_precision precision : precisions())
            all.push_back({method(way).key + "." + name_of(precision), method(way).name + ", " + name_of(precision),
                           way, precision, nothing});
    Table table{{"method"}, {}, {}};
    for (const Feature& feature : all) table.rows.push_back({feature.name});
    table.rows.push_back({"textbook, float64"});
    table.rows.push_back({"textbook, float32"});
    Csv csv("side,method,ns_per_cell_step");
    std::vector<std::string> ratios, dearer;
    for (std::size_t n : sides) {
        const double cells = double(n * n);
        const std::size_t steps = steps_of(n);
        table.head.push_back("ns per cell and step, " + count(double(n)) + "²");
        std::vector<std::unique_ptr<Water>> waters;
        std::vector<Job> jobs;
        for (const Feature& feature : all) {
            waters.push_back(waves(n, feature));
            Water* water = waters.back().get();
            const double dt = step_of(*water, feature);
            jobs.push_back({[] {}, [=] { check(cd_water_step(water->get(), dt, steps)); }});
        }
        const std::vector<double> surface = waters.front()->read(CD_SURFACE);
        TextbookWater<double> wide(n, n, kCell, kCell, kEarth);
        TextbookWater<float> narrow(n, n, float(kCell), float(kCell), float(kEarth));
        wide.now = wide.before = surface;
        wide.bed.assign(n * n, -1), narrow.bed.assign(n * n, -1);
        narrow.now.assign(surface.begin(), surface.end()), narrow.before = narrow.now;
        jobs.push_back({[] {},
                        [&, steps] {
                            for (std::size_t i = 0; i < steps; ++i) wide.step(kFrame);
                        }});
        jobs.push_back({[] {},
                        [&, steps] {
                            for (std::size_t i = 0; i < steps; ++i) narrow.step(float(kFrame));
                        }});
        time_in_turns(jobs, report.by_extent(1e-3, 0.2), report.by_extent<std::size_t>(1, 3), 15);
        std::vector<double> ns;
        for (std::size_t i = 0; i < jobs.size(); ++i) {
            const std::string key = i < all.size()    ? all[i].key
                                    : i == all.size() ? "textbook.float64"
                                                      : "textbook.float32";
            ns.push_back(jobs[i].least() / double(steps) / cells * 1e9);
            table.rows[i].push_back(number(ns.back(), 3) + spread_words(jobs[i].spread()));
            csv.row(n, key, ns.back());
            report.summary("water.beside.ns_per_cell_step.n" + std::to_string(n) + "." + key, ns.back(), "ns");
        }
        const double ratio = ns[all.size()] / ns[0];
        report.summary("water.beside.textbook_over_library.n" + std::to_string(n), ratio, "times");
        for (std::size_t i = 0; i < all.size(); ++i)
            if (all[i].way == Way::water_explicit && all[i].precision == precisions().front())
                dearer.push_back(number(ns[i] / ns[0], 2) + " times at " + count(double(n)) + "²");
        ratios.push_back(number(ratio, 2) + " at " + count(double(n)) + "²");
    }
    report.page.table(table, "The textbook takes " + list_words(ratios) +
                                 " times as long as a linear implicit step, both in float64. The textbook computes in "
                                 "the precision it stores, the library in double always. An explicit step takes " +
                                 list_words(dearer) + " the time of an implicit one.");
    report.save("water_beside.csv", csv);
    report.progress("water: cost beside the textbook");
}

} // namespace

void report_water_cost(Report& report) {
    report.page.section("water-cost", "Water: what a cell and step costs");
    report.page.paragraph(
        "A square pool on one core: each feature switched on alone, and two sizes beside the notes' water in plain "
        "loops.");
    cost_of_features(report);
    cost_beside_the_textbook(report);
}

} // namespace report
