// How the cost of one simulated second grows with the side of a square sheet.
#include <algorithm>
#include <cmath>

#include "format.hpp"
#include "growth.hpp"
#include "membrane_modes.hpp"
#include "membrane_parts.hpp"

namespace report {
namespace {

std::vector<std::size_t> sides(const Report& report) {
    if (report.extent == Extent::sample) return {32, 64, 128};
    return {32, 64, 128, 256, 512, 1024};
}

Sized drum_of_side(const Report& report, std::size_t n) {
    const DrumModes modes(n);
    const SheetProblem problem = drum(n, modes);
    const double nodes = double(problem.nodes()), node_steps = report.by_extent(1e6, 2e7);
    return {n,
            problem.nodes(),
            runners_of(problem),
            modes.at(1),
            std::size_t(std::ceil(1 / (0.9999 * stable_dt(problem)))),
            [modes](const Method& how, std::size_t steps) { return modes.expected_error(how, 1, steps); },
            [=](const Method& how) {
                const bool coupled = how.solver == CD_SOLVER_COUPLED;
                return std::max<std::size_t>(coupled ? 2 : 8, std::size_t((coupled ? 0.1 : 1) * node_steps / nodes));
            }};
}

}  // namespace

void report_membrane_growth(Report& report) {
    report.page.section("membrane-growth", "Membranes and cloth: run time as nodes become more");
    report.page.paragraph(
        "The same drum on finer and finer lattices of n × n springs, 1 s simulated. Explicit steps are the longest "
        "stable ones, and shorten as 1/n; implicit steps are the longest that keep the error within 1%, and hardly "
        "depend on n. With n² nodes that makes n³ for the one and n² for the other.");
    std::vector<Growth> growths;
    for (Way way : {Way::symplectic_euler, Way::alternating_half, Way::alternating_stiff, Way::alternating_backward,
                    Way::coupled_half})
        for (cd_precision precision : precisions()) {
            if (precision != precisions().front() && way != Way::symplectic_euler && way != Way::alternating_half)
                continue;
            growths.push_back({&method(way), precision, {}});
        }
    for (Way way : {Way::textbook_symplectic, Way::textbook_half})
        growths.push_back({&method(way), precisions().front(), {}});
    for (std::size_t n : sides(report)) measure_size(report, drum_of_side(report, n), growths);

    std::vector<std::size_t> at = {256, 1024};
    if (report.extent == Extent::sample) at = {64, 128};
    GrowthView shown = view(report, growths, {"membrane.growth", "side", "springs a side n", 3, at});
    const Growth &alternating = find(growths, Way::alternating_half), &coupled = find(growths, Way::coupled_half),
                 &explicit_steps = find(growths, Way::symplectic_euler);
    std::vector<std::string> iterations;
    for (const Cost& cost : coupled.costs) {
        iterations.push_back(std::to_string(cost.iterations));
        report.summary("membrane.growth.iterations.n" + std::to_string(cost.size), double(cost.iterations),
                       "iterations");
    }
    report.page.headline(number(alternating.exponent(), 3),
                         "is the exponent of the side n in the cost of a second of a drum at 1% error with λ = 1/2 "
                         "alternating; with explicit steps it is " +
                             number(explicit_steps.exponent(), 3));
    report.page.figure(shown.panels, legend(shown.series),
                       "The cost of one second grows with exponent " + number(explicit_steps.exponent(), 3) +
                           " with explicit steps, " + number(alternating.exponent(), 3) +
                           " with λ = 1/2 alternating and " + number(coupled.exponent(), 3) +
                           " coupled, at 1% error. " + crossing(explicit_steps, alternating) + " Coupled solves take " +
                           list_words(iterations) +
                           " iterations at the sides shown, at a step that an accurate wave allows." +
                           (shown.scaled ? " The longest runs were timed over their first part and scaled up; "
                                           "membrane_growth.csv says which."
                                         : ""));
    report.page.table(shown.table, "Exponents fitted over n = " + count(double(sides(report).front())) + " to " +
                                       count(double(sides(report).back())) +
                                       ". The time per node and step grows where the sheet no longer fits into a "
                                       "cache.");
    report.save("membrane_growth.csv", shown.csv);
}

}  // namespace report
