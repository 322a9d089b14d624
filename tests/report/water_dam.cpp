// Dam breaks: Stoker's over wet ground, Ritter's over dry ground, refined.
#include <cmath>

#include "format.hpp"
#include "plot.hpp"
#include "water_parts.hpp"
#include "water_waves.hpp"

namespace report {
namespace {

const double kLength = 10, kTime = 6, kLeft = 0.005;

struct Dam {
    std::string key, title;
    DamBreak exact;
};

std::vector<double> exact_depths(const Dam& dam, std::size_t n) {
    return along_x(n, kLength / double(n), [&](double x) { return dam.exact.depth(x - kLength / 2, kTime); });
}

// After kTime, in steps in which the fastest wave crosses half a cell.
std::unique_ptr<Runner> broken(const Dam& dam, std::size_t n, Way way) {
    WaterProblem problem;
    problem.nx = n;
    problem.dx = kLength / double(n);
    problem.depth = along_x(n, problem.dx, [&](double x) { return x < kLength / 2 ? kLeft : dam.exact.right; });
    std::unique_ptr<Runner> runner = make_runner(problem, method(way), precisions().front());
    const std::size_t steps = std::size_t(std::ceil(kTime * std::sqrt(kEarth * kLeft) / (0.5 * problem.dx)));
    runner->step(kTime / double(steps), steps);
    return runner;
}

// Where the depth falls through half of what stands behind the shock, or through 1% of the dam's for a dry front.
double front_of(const Dam& dam, const std::vector<double>& depth) {
    const double level = dam.exact.right > 0 ? (dam.exact.plateau + dam.exact.right) / 2 : 0.01 * kLeft;
    const double dx = kLength / double(depth.size());
    for (std::size_t i = depth.size() - 1; i-- > 0;)
        if (depth[i] >= level)
            return (double(i) + 0.5 + (depth[i] - level) / (depth[i] - depth[i + 1])) * dx - kLength / 2;
    return NAN;
}

std::string profile(const Dam& dam, std::size_t n) {
    Plot plot;
    plot.title = dam.title + " after " + number(kTime, 1) + " s, " + std::to_string(n) + " cells";
    plot.x = {"distance from the dam [m]", Scale::linear, "", -2, 3};
    plot.y = {"depth", Scale::linear, "m"};
    const double dx = kLength / double(n);
    const std::vector<double> x = along_x(n, dx, [](double at) { return at - kLength / 2; });
    plot.series.push_back({"exact", {7, Marker::none, Dash::dashed, false, true, 1.4}, x, exact_depths(dam, n), {}});
    for (Way way : {Way::water_advected, Way::water_linear, Way::water_textbook_put_back}) {
        Style style = method(way).style;
        style.marker = Marker::none;
        plot.series.push_back({method(way).name, style, x, broken(dam, n, way)->positions(), {}});
    }
    return render(plot);
}

} // namespace

void report_water_dam(Report& report) {
    report.page.section("water-dam", "Water: dam breaks");
    const std::vector<Dam> dams = {{"stoker", "over water 1 mm deep (Stoker)", DamBreak(kLeft, 0.001)},
                                   {"ritter", "over dry ground (Ritter)", DamBreak(kLeft, 0)}};
    report.page.paragraph(
        "A dam 5 mm high breaks, over water 1 mm deep and over dry ground; 6 s later, in steps in which its fastest "
        "wave crosses half a cell. The exact answers are those of the full shallow-water equations, which the advected "
        "mode solves; the linear mode and the notes do not claim them.");
    std::vector<std::size_t> sizes = {100, 200, 400, 800, 1600};
    if (report.extent == Extent::brief) sizes = {100, 200, 400, 800};
    Plot refined;
    refined.title = "error against cells";
    refined.x = {"cells", Scale::log};
    refined.y = {"L1 error of the depth, relative to the volume", Scale::log};
    Csv csv("case,method,cells,error,front_m,exact_front_m,middle_depth_m,exact_middle_depth_m,hash");
    Table table{
        {"dam break", "cells", "error in L1", "front at", "exactly", "halfway to it: depth", "exactly"}, {}, {}};
    std::vector<std::string> orders, panels;
    for (const Dam& dam : dams) {
        const bool wet = dam.exact.right > 0;
        Series series{dam.title, {wet ? 1 : 2, wet ? Marker::circle : Marker::square}, {}, {}, {}};
        double first = 0, last = 0;
        for (std::size_t n : sizes) {
            const std::unique_ptr<Runner> runner = broken(dam, n, Way::water_advected);
            const std::vector<double> depth = runner->positions();
            const double error = depth_error(depth, exact_depths(dam, n)), front = front_of(dam, depth);
            const double exact_front =
                wet ? dam.exact.shock * kTime : (2 - 3 * std::sqrt(0.01)) * std::sqrt(kEarth * kLeft) * kTime;
            const std::size_t middle = std::size_t((0.5 + 0.5 * dam.exact.front() * kTime / kLength) * double(n));
            const double exact_middle =
                dam.exact.depth((double(middle) + 0.5) * kLength / double(n) - kLength / 2, kTime);
            series.x.push_back(double(n)), series.y.push_back(error);
            (first > 0 ? last : first) = error;
            report.outcome("water.dam " + dam.key + " " + std::to_string(n), hex(runner->hash()));
            csv.row(dam.key, "advected", n, error, front, exact_front, depth[middle], exact_middle,
                    hex(runner->hash()));
            table.rows.push_back({dam.title, count(double(n)), percent(error, 2), si(front, "m", 4),
                                  si(exact_front, "m", 4), si(depth[middle], "m", 4), si(exact_middle, "m", 4)});
            if (n == 800 || n == sizes.back()) {
                const std::string key = "water." + dam.key + ".n" + std::to_string(n);
                report.summary(key + ".error", error * 100, "%");
                report.summary(key + ".front_off", (front / exact_front - 1) * 100, "%");
                report.summary(key + ".middle_depth_off", (depth[middle] / exact_middle - 1) * 100, "%");
            }
        }
        const double order = std::log(first / last) / std::log(double(sizes.back()) / double(sizes.front()));
        report.summary("water." + dam.key + ".order", order);
        orders.push_back(number(order, 2) + " " + dam.title);
        refined.series.push_back(series);
        panels.push_back(profile(dam, report.by_extent<std::size_t>(100, 200, 200)));
    }
    panels.push_back(render(refined));
    std::vector<Series> all = {{"exact", {7, Marker::none, Dash::dashed}, {}, {}, {}}};
    for (Way way : {Way::water_advected, Way::water_linear, Way::water_textbook_put_back}) {
        Style style = method(way).style;
        style.marker = Marker::none;
        all.push_back({method(way).name, style, {}, {}, {}});
    }
    all.insert(all.end(), refined.series.begin(), refined.series.end());
    report.page.figure(panels, legend(all),
                       "The advected mode runs into the exact dam breaks as cells get smaller, with order " +
                           list_words(orders) +
                           ". At the shock a spike one or two cells wide stands out. Without advection the wave comes "
                           "late and piles up, in the linear mode as in the notes'. "
                           "Take the advected mode for floods.");
    report.page.table(table,
                      "The shock and the depth behind it come out right; the tip of a dry front, thin as a "
                      "film, comes late and slowly nearer. The shock's place is where the depth is halfway down "
                      "it; the dry front's where it is 1% of the dam's.");
    report.save("water_dam.csv", csv);
    report.progress("water: dam breaks");
}

} // namespace report
