// Pictures: a wave that runs up a beach, a pool with a splash, a tide around an island.
#include <algorithm>
#include <cmath>

#include "format.hpp"
#include "plot.hpp"
#include "water_parts.hpp"

namespace report {
namespace {

// ---- a solitary wave on a beach of slope 1 : 5 ----

struct Beach {
    static constexpr double kFlat = 30, kEnd = 8, kSlope = 5, kHeight = 0.1, kCell = 0.05;
    const std::size_t n = std::size_t((kFlat + kEnd) / kCell + 0.5);
    Water water{n, 1, kCell, 1, precisions().front()};
    std::vector<double> x, bed;

    // The wave's crest is where a twentieth of its height has come to the beach's foot, at x = 0.
    Beach() {
        x = along_x(n, kCell, [](double at) { return at - kFlat; });
        for (double at : x) bed.push_back(-1 + std::fmax(0, at / kSlope));
        const double steep = std::sqrt(0.75 * kHeight), crest = -std::acosh(std::sqrt(20)) / steep,
                     speed = std::sqrt(kEarth * (1 + kHeight));
        auto wave = [=](double at) { return kHeight / std::pow(std::cosh(steep * (at - crest)), 2); };
        std::vector<double> depth, velocity;
        for (std::size_t i = 0; i < n; ++i) depth.push_back(std::fmax(0, (bed[i] < 0 ? wave(x[i]) : 0) - bed[i]));
        for (std::size_t i = 0; i <= n; ++i) {
            const double at = double(i) * kCell - kFlat, high = wave(at);
            velocity.push_back(i == 0 || at > 0 ? 0 : speed * high / (1 + high));
        }
        water.set(method(Way::water_advected));
        water.write(CD_BED, bed);
        water.write(CD_DEPTH, depth);
        water.write(CD_VELOCITY_X, velocity);
    }

    std::vector<double> surface() const {
        std::vector<double> depth = water.read(CD_DEPTH), h(n, NAN);
        for (std::size_t i = 0; i < n; ++i)
            if (depth[i] > 1e-3) h[i] = bed[i] + depth[i];
        return h;
    }

    double run_up() const {
        double highest = -1;
        for (double h : surface())
            if (!std::isnan(h)) highest = h;
        return highest;
    }
};

void beach(Report& report) {
    Beach beach;
    Plot plot;
    plot.title = "a solitary wave 10 cm high runs up a beach of slope 1 : 5";
    plot.x = {"from the beach's foot [m]", Scale::linear, "", -12, 7.5};
    plot.y = {"height", Scale::linear, "m", -0.45, 0.52};
    plot.width = 920, plot.height = 360;
    plot.series.push_back({"bed", {0, Marker::none, Dash::solid, false, true, 3}, beach.x, beach.bed, {}});
    const int colours[] = {7, 1, 3, 2, 4, 5};
    const Dash dashes[] = {Dash::dotted, Dash::solid, Dash::solid, Dash::solid, Dash::dashed, Dash::dashed};
    const double moments[] = {0, 2, 3.4, 4.4, 5.6, 8}, dt = 1.0 / 200;
    double highest = 0, when = 0;
    std::size_t shown = 0;
    for (std::size_t step = 0; shown < 6; ++step) {
        if (step > 0) check(cd_water_step(beach.water.get(), dt, 1));
        const double time = double(step) * dt, up = beach.run_up();
        if (up > highest) highest = up, when = time;
        if (time < moments[shown] - dt / 2) continue;
        plot.series.push_back({number(moments[shown], 2) + " s",
                               {colours[shown], Marker::none, dashes[shown], false, true, 2},
                               beach.x,
                               beach.surface(),
                               {}});
        ++shown;
    }
    const double law = 2.831 * std::sqrt(Beach::kSlope) * std::pow(Beach::kHeight, 1.25);
    report.summary("water.run_up.measured", highest, "m");
    report.summary("water.run_up.synolakis_law", law, "m");
    report.summary("water.run_up.off", (highest / law - 1) * 100, "%");
    report.outcome("water.scene.beach", hex(beach.water.hash()));
    report.page.figure({render(plot)}, legend(plot.series),
                       "The wave climbs to " + number(highest, 3) +
                           " m; the law of waves that do not break (Synolakis 1987) says " + number(law, 3) +
                           " m. It is at its highest after " + number(when, 2) +
                           " s, and then runs back. Advected mode, " + count(double(beach.n)) +
                           " cells of 5 cm, 200 steps a second; water less than 1 mm deep is not drawn.",
                       600);
}

// ---- a splash ----

std::string pool_picture(const Water& water, const std::string& title) {
    const double exaggerated = 3, height = 0.25;
    std::size_t nx = 0, ny = 0, indices = 0;
    check(cd_water_get_shape(water.get(), &nx, &ny, nullptr, nullptr, nullptr));
    check(cd_water_get_index_count(water.get(), 0, &indices));
    Surface surface{title, {}, {}, {}, {}, 0, 0, 0, 0, 0, 0};
    surface.vertices.resize(6 * nx * ny);
    surface.triangles.resize(indices);
    check(cd_water_write_vertices(water.get(), surface.vertices.data(), surface.vertices.size() * sizeof(float),
                                  6 * sizeof(float), 0, 3 * sizeof(float), std::size_t(-1)));
    check(cd_water_write_indices(water.get(), 0, surface.triangles.data(), indices * sizeof(std::uint32_t),
                                 sizeof(std::uint32_t)));
    for (std::size_t i = 0; i < surface.vertices.size(); i += 6) {
        surface.tint.push_back(std::clamp(surface.vertices[i + 2] / height, -1.0, 1.0));
        surface.vertices[i + 2] *= float(exaggerated);
        surface.vertices[i + 3] *= float(exaggerated), surface.vertices[i + 4] *= float(exaggerated);
    }
    surface.azimuth = 28, surface.elevation = 40;
    surface.x0 = -0.1, surface.x1 = 16.4, surface.y0 = -4.4, surface.y1 = 7.9;
    surface.width = 340;
    return render(surface);
}

void splash(Report& report) {
    const std::size_t n = 32;
    Water water(n, n, 12.0 / double(n), 12.0 / double(n), precisions().back());
    water.set(method(Way::water_advected));
    water.write(CD_BED, std::vector<double>(n * n, -1.0));
    water.write(CD_SURFACE, std::vector<double>(n * n, 0.0));
    check(cd_water_splash(water.get(), 4.6, 6.6, 1.1, 0.75));
    std::vector<std::string> panels;
    double time = 0;
    for (double moment : {0.9, 2.2}) {
        check(cd_water_step(water.get(), 1.0 / 100, std::size_t(std::lround((moment - time) * 100))));
        time = moment;
        panels.push_back(pool_picture(water, si(moment, "s", 2) + " after a splash"));
    }
    panels[0] = report.page.show(panels[0], "Rings of a splash in a pool");
    report.outcome("water.scene.splash", hex(water.hash()));
    report.page.figure(panels, "",
                       "A splash in a pool: the rings of a hole 75 cm deep run out and come back from the walls. "
                       "12 m × 12 m, 1 m deep, " +
                           std::to_string(n) + " × " + std::to_string(n) +
                           " cells, advected, 100 steps a second; heights are drawn three times as high, orange above "
                           "the level at rest, blue below. Triangles and normals are the library's own.",
                       220);
}

} // namespace

void report_water_scenes(Report& report) {
    report.page.section("water-scenes", "Water: pictures");
    beach(report);
    splash(report);
    draw_island(report);
    report.progress("water: pictures");
}

} // namespace report
