// Error against run time on a drum: every method and solver, both precisions, step sizes over three decades.
#include <algorithm>
#include <cmath>

#include "format.hpp"
#include "membrane_modes.hpp"
#include "membrane_parts.hpp"
#include "work_precision.hpp"

namespace report {
namespace {

// A curve of the plot: in float64 and, if `narrow`, in float32; its longest run takes about so many seconds.
struct Choice {
    Way way;
    bool narrow;
    double seconds;
};

std::vector<Choice> choices(std::size_t n) {
    if (n < 100)
        return {{Way::forward_euler, false, 0.1},       {Way::symplectic_euler, true, 0.1},
                {Way::alternating_half, true, 0.1},     {Way::alternating_backward, false, 0.1},
                {Way::alternating_stiff, true, 0.1},    {Way::coupled_half, true, 0.5},
                {Way::coupled_backward, false, 0.2},    {Way::coupled_stiff, false, 0.4},
                {Way::textbook_symplectic, false, 0.1}, {Way::textbook_half, false, 0.1}};
    return {{Way::symplectic_euler, true, 0.2},     {Way::alternating_half, true, 0.2},
            {Way::alternating_stiff, false, 0.2},   {Way::coupled_half, false, 1.6},
            {Way::textbook_symplectic, false, 0.2}, {Way::textbook_half, false, 0.2}};
}

// About what a node and step costs [s].
double guess(const Method& how) {
    const double stages = how.method == CD_METHOD_STIFF_SECOND ? 2 : 1;
    return 1e-9 * stages * (how.is_explicit() ? 2 : how.textbook ? 20 : how.solver == CD_SOLVER_COUPLED ? 150 : 4);
}

Study drum_study(const Report& report, std::size_t n) {
    Study study;
    study.key = "membrane.drum.n" + std::to_string(n);
    study.title = std::to_string(n) + " × " + std::to_string(n) + " springs";
    study.time = 1;
    const DrumModes modes(n);
    const SheetProblem problem = drum(n, modes);
    study.make = runners_of(problem);
    study.exact = modes.at(study.time);
    const std::size_t limit = std::size_t(std::ceil(study.time / (0.9999 * stable_dt(problem))));
    for (const Choice& choice : choices(n)) {
        const Method& how = method(choice.way);
        const double seconds = choice.seconds * report.by_extent(0.15, 1.0);
        const std::size_t affordable = std::size_t(seconds / (guess(how) * double(problem.nodes())));
        for (cd_precision precision : precisions()) {
            if (!choice.narrow && precision != precisions().front()) continue;
            study.curves.push_back(
                {&how, precision,
                 points_between(how.is_explicit() ? limit : 8,
                                how.is_explicit() ? std::max(4 * limit, affordable) : affordable,
                                [&](std::size_t steps) { return modes.expected_error(how, study.time, steps); })});
        }
    }
    return study;
}

// What the two solvers make of the same steps.
std::string compared(Report& report, const Study& study) {
    const std::size_t steps = 64;
    const Point *alternating = find_point(study, Way::alternating_half, steps),
                *coupled = find_point(study, Way::coupled_half, steps);
    if (!alternating || !coupled) return "";
    const double ratio = coupled->least_seconds / alternating->least_seconds;
    report.summary(study.key + ".error_at_64_steps.alternating_half", alternating->error * 100, "%");
    report.summary(study.key + ".error_at_64_steps.coupled_half", coupled->error * 100, "%");
    report.summary(study.key + ".coupled_over_alternating", ratio, "times the time");
    return "On a drum the coupled solve gains nothing: 64 steps of λ = 1/2 err by " + percent(coupled->error, 3) +
           " coupled and by " + percent(alternating->error, 3) + " alternating, which is " + number(ratio, 2) +
           " times cheaper.";
}

void headline(Report& report, const Study& study) {
    const Best implicit = cheapest(study, 1e-2, Kind::implicit_steps), textbook = cheapest(study, 1e-2, Kind::textbook),
               explicit_steps = cheapest(study, 1e-2, Kind::explicit_steps);
    if (!implicit || !explicit_steps || !textbook) return;
    const Best best = implicit.seconds() < explicit_steps.seconds() ? implicit : explicit_steps;
    report.page.headline(si(best.seconds(), "s", 2), "simulates one second of a drum of " + study.title + " to 1% (" +
                                                         best.curve->name() + "); the textbook takes " +
                                                         si(textbook.seconds(), "s", 2));
}

}  // namespace

void report_membrane_precision(Report& report) {
    report.page.section("membrane-precision", "Membranes and cloth: error against run time");
    report.page.paragraph(
        "A drum: a square sheet with all edges held, mass and stiffness 1, let go from rest as a bump of standard "
        "deviation 1/12 off its middle and simulated for 1 s, in which a wave crosses it once. The error is the "
        "greatest over all nodes, relative to the greatest displacement, against the exact motion of the same lattice "
        "by its 32 × 32 lowest modes, of which the bump is made: the error of the time steps alone. Alternating solves "
        "rows, then columns; coupled solves the whole system to a residual of 10⁻⁶. The textbook is the notes' section "
        "9 in plain loops with Numerical Recipes' elimination.");
    WorkTables tables;
    std::vector<std::string> panels, findings;
    std::vector<Series> series;
    std::string comparison;
    std::vector<std::size_t> sizes = {64, 256};
    if (report.extent == Extent::sample) sizes = {64};
    for (std::size_t n : sizes) {
        Study study = drum_study(report, n);
        measure(report, study);
        tables.add(report, study, "drum, n = " + std::to_string(n));
        panels.push_back(draw(study, "run time of 1 simulated second", series));
        const Best implicit = cheapest(study, 1e-2, Kind::implicit_steps),
                   explicit_steps = cheapest(study, 1e-2, Kind::explicit_steps);
        findings.push_back("at " + study.title + " " + verdict(implicit, explicit_steps));
        if (n == sizes.front()) comparison = compared(report, study);
        if (n == sizes.back()) headline(report, study);
    }
    report.page.figure(panels, legend(series),
                       "Cheapest to 1%: " + list_words(findings) +
                           ". Left and down is better. Symplectic Euler's error is of first order in the step. " +
                           comparison +
                           " The textbook's steps are the library's alternating ones, and err alike.");
    report.page.table(tables.table,
                      "The drum: the cheapest run that reaches each error. Explicit steps may not be longer than their "
                      "stability limit, however little accuracy is asked for.");
    report.save("membrane_work_precision.csv", tables.points);
    report.save("membrane_cheapest.csv", tables.cheapest);
}

}  // namespace report
