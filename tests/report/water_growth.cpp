// How the cost of one simulated minute grows with the cells of a pool of one size.
#include <algorithm>
#include <cctype>
#include <cmath>

#include "format.hpp"
#include "growth.hpp"
#include "modes.hpp"
#include "water_parts.hpp"
#include "water_waves.hpp"

namespace report {
namespace {

std::vector<std::size_t> sides(const Report& report) {
    if (report.extent == Extent::sample) return {32, 64, 128};
    return {32, 64, 128, 256, 512, 1024};
}

Sized pool_of_side(const Report& report, std::size_t n) {
    const double minute = 60, height = small_height();
    const Seiches seiches(n, n, 20, 20, 1, {{1, 0, height}, {0, 1, height / 2}, {1, 1, height}});
    const WaterProblem problem = seiches.problem();
    const double cells = double(problem.cells()), cell_steps = report.by_extent(5e5, 4e6);
    auto expected = [seiches](const Method& how, std::size_t steps) { return seiches.expected_error(how, 60, steps); };
    const Method& plain = method(Way::water_explicit);
    const std::size_t stable = std::size_t(std::ceil(minute / (0.9999 * stable_dt(problem)))),
                      accurate = fewest_steps([&](std::size_t steps) { return expected(plain, steps); },
                                              0.999 * kGrowthTolerance, 1u << 22);
    return {n,
            problem.cells(),
            runners_of(problem),
            seiches.at(minute),
            std::max(stable, accurate),
            expected,
            [=](const Method&) { return std::max<std::size_t>(4, std::size_t(cell_steps / cells)); },
            minute};
}

std::string capitalized(std::string text) {
    text[0] = char(std::toupper(static_cast<unsigned char>(text[0])));
    return text;
}

} // namespace

void report_water_growth(Report& report) {
    report.page.section("water-growth", "Water: run time as cells become more");
    report.page.paragraph(
        "One pool, 20 m × 20 m and 1 m deep, in finer and finer cells, n × n of them; its three slowest seiches swing "
        "for a minute, and must be right to 1% at its end. Explicit steps are the longest that are stable and reach "
        "that, and shorten as 1/n once the limit of stability binds; implicit ones are the longest that reach it, the "
        "same at every n. With n² cells that makes n³ for the one and n² for the other: run time is linear in cells.");
    std::vector<Growth> growths;
    for (Way way : {Way::water_explicit, Way::water_half, Way::water_linear, Way::water_advected, Way::water_textbook})
        growths.push_back({&method(way), precisions().front(), {}});
    for (std::size_t n : sides(report)) measure_size(report, pool_of_side(report, n), growths);

    std::vector<std::size_t> at = {256, 1024};
    if (report.extent == Extent::sample) at = {64, 128};
    GrowthView shown = view(report, growths, {"water.growth", "side", "cells a side n", 3, at, "cell", "minute"});
    const Growth &half = find(growths, Way::water_half), &explicit_steps = find(growths, Way::water_explicit),
                 &textbook = find(growths, Way::water_textbook);
    report.page.headline(number(half.exponent() / 2, 2),
                         "is the exponent of the number of cells in the cost of a minute of a pool at 1% error with "
                         "implicit steps; with explicit ones it is " +
                             number(explicit_steps.exponent() / 2, 3));
    report.summary("water.growth.per_cell_exponent.linear_half", half.exponent() / 2);
    report.summary("water.growth.per_cell_exponent.explicit", explicit_steps.exponent() / 2);
    const std::size_t last = half.costs.size() - 1;
    const double ratio = explicit_steps.costs[last].seconds / half.costs[last].seconds;
    report.summary("water.growth.explicit_over_implicit.n" + std::to_string(half.costs[last].size), ratio, "times");
    report.page.figure(
        shown.panels, legend(shown.series),
        "The cost of one minute grows with exponent " + number(explicit_steps.exponent(), 3) +
            " of the side with explicit steps and " + number(half.exponent(), 3) +
            " with linear λ = 1/2, at 1% error. " + capitalized(crossing(explicit_steps, half)) +
            " λ = 0.55, which makes short waves die out, takes " +
            number(double(find(growths, Way::water_linear).costs[last].steps) / double(half.costs[last].steps), 2) +
            " times as many steps as λ = 1/2, the textbook " +
            number(double(textbook.costs[last].steps) / double(half.costs[last].steps), 2) + " times." +
            (shown.scaled ? " The longest runs were timed over their first part and scaled up; "
                            "water_growth.csv says which."
                          : ""));
    report.page.table(shown.table, "Exponents of the side, fitted over n = " + count(double(sides(report).front())) +
                                       " to " + count(double(sides(report).back())) +
                                       ". The time per cell and step grows where the pool no longer fits into a "
                                       "cache.");
    report.save("water_growth.csv", shown.csv);
}

} // namespace report
