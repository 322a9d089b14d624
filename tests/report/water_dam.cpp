// Dam breaks: Stoker's over wet ground, Ritter's over dry ground, refined, in steps of three lengths.
#include <cmath>

#include "format.hpp"
#include "plot.hpp"
#include "water_parts.hpp"
#include "water_waves.hpp"

namespace report {
namespace {

struct Dam {
    std::string key, title;
    DamBreak exact;
};

std::unique_ptr<Runner> broken(const Dam& dam, std::size_t n, Way way, double courant) {
    std::unique_ptr<Runner> runner = make_runner(dam.exact.problem(n), method(way), precisions().front());
    const std::size_t steps = dam.exact.steps(n, courant);
    runner->step(DamBreak::kTime / double(steps), steps);
    return runner;
}

// Where the depth falls through half of what stands behind the shock, or through 1% of the dam's for a dry front.
double front_of(const Dam& dam, const std::vector<double>& depth) {
    const DamBreak& exact = dam.exact;
    const double level = exact.right > 0 ? (exact.plateau + exact.right) / 2 : 0.01 * exact.left;
    const double dx = DamBreak::kLength / double(depth.size());
    for (std::size_t i = depth.size() - 1; i-- > 0;)
        if (depth[i] >= level)
            return (double(i) + 0.5 + (depth[i] - level) / (depth[i] - depth[i + 1])) * dx - DamBreak::kLength / 2;
    return NAN;
}

struct Line {
    Way way;
    double courant;
    std::string name;
    Style style;
};

std::vector<Line> lines() {
    std::vector<Line> all;
    int colour = 3;
    for (double courant : kCourants) {
        const std::string name = "advected, Courant " + plain(courant);
        all.push_back({Way::water_advected, courant, name, {colour++, Marker::none}});
    }
    for (Way way : {Way::water_linear, Way::water_textbook_put_back}) {
        Style style = method(way).style;
        style.marker = Marker::none;
        all.push_back({way, 0.5, method(way).name + ", Courant 0.5", style});
    }
    return all;
}

std::string profile(const Dam& dam, std::size_t n) {
    Plot plot;
    plot.title = dam.title + " after " + number(DamBreak::kTime, 1) + " s, " + std::to_string(n) + " cells";
    plot.x = {"distance from the dam [m]", Scale::linear, "", -2, 3};
    plot.y = {"depth", Scale::linear, "m"};
    const std::vector<double> x =
        along_x(n, DamBreak::kLength / double(n), [](double at) { return at - DamBreak::kLength / 2; });
    plot.series.push_back({"exact", {7, Marker::none, Dash::dashed, false, true, 1.4}, x, dam.exact.depths(n), {}});
    for (const Line& line : lines())
        plot.series.push_back({line.name, line.style, x, broken(dam, n, line.way, line.courant)->positions(), {}});
    return render(plot);
}

} // namespace

void report_water_dam(Report& report) {
    report.page.section("water-dam", "Water: dam breaks");
    const double high = 0.005;
    const std::vector<Dam> dams = {{"stoker", "over water 1 mm deep (Stoker)", DamBreak(high, 0.001)},
                                   {"ritter", "over dry ground (Ritter)", DamBreak(high, 0)}};
    report.page.paragraph(
        "A dam 5 mm high breaks, over water 1 mm deep and over dry ground; 6 s later, in steps in which its fastest "
        "wave crosses half a cell, 2 cells and 8. The exact answers are those of the full shallow-water equations, "
        "which the advected mode solves; the linear mode and the notes do not claim them.");
    std::vector<std::size_t> sizes = {100, 200, 400, 800, 1600};
    if (report.extent == Extent::sample) sizes = {100, 200, 400, 800};
    Plot refined;
    refined.title = "error against cells";
    refined.x = {"cells", Scale::log};
    refined.y = {"L1 error of the depth, relative to the volume", Scale::log};
    Csv csv("case,method,cells,courant,error,front_m,exact_front_m,middle_depth_m,exact_middle_depth_m,hash");
    Table table{{"dam break", "cells"}, {}, {}};
    for (const char* of : {"error", "front off by", "depth halfway to it off by"})
        for (double courant : kCourants)
            table.head.push_back(std::string(of) + (courant < 1 ? ", Courant " : ", ") + plain(courant));
    std::vector<std::string> orders, panels;
    for (const Dam& dam : dams) {
        const bool wet = dam.exact.right > 0;
        const double exact_front =
            DamBreak::kTime * (wet ? dam.exact.shock : (2 - 3 * std::sqrt(0.01)) * std::sqrt(kEarth * high));
        std::vector<Series> series;
        for (const Line& line : lines())
            if (line.way == Way::water_advected) {
                Style style = line.style;
                style.marker = wet ? Marker::circle : Marker::square, style.hollow = !wet;
                series.push_back({dam.title + ", Courant " + plain(line.courant), style, {}, {}, {}});
            }
        for (std::size_t n : sizes) {
            const std::size_t middle =
                std::size_t((0.5 + 0.5 * dam.exact.front() * DamBreak::kTime / DamBreak::kLength) * double(n));
            const std::vector<double> exact = dam.exact.depths(n);
            std::vector<std::string> errors, fronts, depths;
            for (std::size_t k = 0; k < kCourants.size(); ++k) {
                const std::unique_ptr<Runner> runner = broken(dam, n, Way::water_advected, kCourants[k]);
                const std::vector<double> depth = runner->positions();
                const double error = depth_error(depth, exact), front = front_of(dam, depth),
                             front_off = front / exact_front - 1, depth_off = depth[middle] / exact[middle] - 1;
                series[k].x.push_back(double(n)), series[k].y.push_back(error);
                errors.push_back(percent(error, 2));
                fronts.push_back(percent(front_off, 2)), depths.push_back(percent(depth_off, 2));
                const std::string key =
                    "water." + dam.key + ".n" + std::to_string(n) + ".courant_" + plain(kCourants[k]);
                report.outcome(key, hex(runner->hash()));
                csv.row(dam.key, "advected", n, kCourants[k], error, front, exact_front, depth[middle], exact[middle],
                        hex(runner->hash()));
                report.summary(key + ".error", error * 100, "%");
                report.summary(key + ".front_off", front_off * 100, "%");
                report.summary(key + ".middle_depth_off", depth_off * 100, "%");
            }
            std::vector<std::string> cells = {dam.title, count(double(n))};
            for (const auto* more : {&errors, &fronts, &depths}) cells.insert(cells.end(), more->begin(), more->end());
            table.rows.push_back(cells);
        }
        const double order =
            std::log(series[0].y.front() / series[0].y.back()) / std::log(double(sizes.back()) / double(sizes.front()));
        report.summary("water." + dam.key + ".order", order);
        orders.push_back(number(order, 2) + " " + dam.title);
        refined.series.insert(refined.series.end(), series.begin(), series.end());
        panels.push_back(profile(dam, report.by_extent<std::size_t>(100, 200)));
    }
    panels.push_back(render(refined));
    std::vector<Series> all = {{"exact", {7, Marker::none, Dash::dashed}, {}, {}, {}}};
    for (const Line& line : lines()) all.push_back({line.name, line.style, {}, {}, {}});
    all.insert(all.end(), refined.series.begin(), refined.series.end());
    report.page.figure(panels, legend(all),
                       "The advected mode runs into the exact dam breaks as cells get smaller, with order " +
                           list_words(orders) +
                           " at Courant 0.5. Longer steps draw the shock out, and leave it where it is but for some "
                           "hundredths. Without advection the wave comes late and piles up, in the linear mode as in "
                           "the notes'. Take the advected mode for floods.");
    report.page.table(table,
                      "The shock and the depth behind it come out right; the tip of a dry front, thin as a "
                      "film, comes late and slowly nearer. The shock's place is where the depth is halfway down "
                      "it; the dry front's where it is 1% of the dam's.");
    report.save("water_dam.csv", csv);
    report.progress("water: dam breaks");
}

} // namespace report
