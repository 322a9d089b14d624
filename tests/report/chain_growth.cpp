// How the cost of one simulated second grows with the number of springs.
#include <algorithm>
#include <cmath>

#include "chain_parts.hpp"
#include "format.hpp"
#include "growth.hpp"
#include "modes.hpp"

namespace report {
namespace {

std::vector<std::size_t> sizes(const Report& report) {
    if (report.extent == Extent::sample) return {100, 300, 1000};
    return {100, 300, 1000, 3000, 10000, 30000, 100000};
}

Sized smooth_wave(const Report& report, std::size_t springs) {
    Problem problem;
    problem.springs = springs;
    problem.pin_first = problem.pin_last = true;
    problem.position = gaussian_bump(springs);
    const SineModes modes(springs, 1, problem.position, 150);
    const double affordable = report.by_extent(1e6, 2e7) / double(springs);  // so many node steps
    return {springs, springs + 1, runners_of(problem), modes.at(1),
            std::size_t(std::ceil(1 / (0.9999 * stable_dt(problem)))),
            [modes](const Method& how, std::size_t steps) { return modes.expected_error(how, 1, steps); },
            [affordable](const Method&) { return std::max<std::size_t>(16, std::size_t(affordable)); }};
}

}  // namespace

void report_chain_growth(Report& report) {
    report.page.section("chain-growth", "Chains: run time as nodes become more");
    report.page.paragraph(
        "The same smooth wave on finer and finer chains, 1 s simulated. Explicit steps are the longest stable ones, "
        "and shorten as 1/n; implicit steps are the longest that keep the error within 1%, and hardly depend on n. "
        "The notes expect a cost that grows as n² for the one and as n for the other.");
    std::vector<Growth> growths;
    for (Way way : {Way::symplectic_euler, Way::half, Way::stiff_second, Way::backward})
        for (cd_precision precision : precisions()) {
            if (precision == CD_FLOAT32 && (way == Way::backward || way == Way::stiff_second)) continue;
            growths.push_back({&method(way), precision, {}});
        }
    for (Way way : {Way::textbook_symplectic, Way::textbook_half})
        growths.push_back({&method(way), precisions().front(), {}});
    for (std::size_t springs : sizes(report)) measure_size(report, smooth_wave(report, springs), growths);

    GrowthView shown = view(report, growths, {"chain.growth", "springs", "number of springs n", 2, {1000}});
    const Growth &implicit = find(growths, Way::half), &explicit_steps = find(growths, Way::symplectic_euler);
    auto by_cost = [](const Cost& a, const Cost& b) { return a.per_node_step() < b.per_node_step(); };
    auto least_most = std::minmax_element(implicit.costs.begin(), implicit.costs.end(), by_cost);
    const std::string range = si(least_most.first->per_node_step(), "s", 2) + " at the least and " +
                              si(least_most.second->per_node_step(), "s", 2) + " at the most";
    const std::string implicit_exponent = number(implicit.exponent(), 3),
                      explicit_exponent = number(explicit_steps.exponent(), 3);
    report.page.headline(implicit_exponent,
                         "is the exponent of n in the cost of a second at 1% error with λ = 1/2; with explicit "
                         "steps it is " + explicit_exponent);
    report.page.figure(shown.panels, legend(shown.series),
                       "The cost of one second grows with exponent " + explicit_exponent + " with explicit steps and " +
                       implicit_exponent + " with λ = 1/2 at 1% error. " + crossing(explicit_steps, implicit) +
                       " One node and step of λ = 1/2 costs " + range + "." +
                       (shown.scaled ? " The longest runs were timed over their first part and scaled up; "
                                       "chain_growth.csv says which." : ""));
    report.page.table(shown.table, "Exponents fitted over n = " + count(double(sizes(report).front())) + " to " +
                                       count(double(sizes(report).back())) + ". At its stability limit symplectic "
                                       "Euler is off by about 10/n, so that at n = 100 it is not within 1%.");
    report.save("chain_growth.csv", shown.csv);
}

}  // namespace report
