// Error against run time on a smooth wave: every method, both precisions, step sizes over three decades.
#include <algorithm>
#include <cmath>

#include "chain_parts.hpp"
#include "format.hpp"
#include "modes.hpp"
#include "work_precision.hpp"

namespace report {
namespace {

Study smooth_wave(const Report& report, std::size_t springs) {
    Study study;
    study.key = "chain.wave.n" + std::to_string(springs);
    study.title = "n = " + std::to_string(springs) + " springs";
    study.time = 1;
    Problem problem;
    problem.springs = springs;
    problem.pin_first = problem.pin_last = true;
    problem.position = gaussian_bump(springs);
    study.make = runners_of(problem);
    SineModes modes(springs, 1, problem.position, 200);
    study.exact = modes.at(study.time);

    const std::size_t limit = std::size_t(std::ceil(study.time / (0.9999 * stable_dt(problem))));
    std::vector<Way> ways = library_ways();
    ways.insert(ways.end(), {Way::textbook_symplectic, Way::textbook_half});
    for (Way way : ways) {
        const Method& how = method(way);
        double node_steps = how.method == CD_METHOD_FORWARD_EULER ? report.by_extent(1e7, 2.5e8, 2e9)
                                                                  : report.by_extent(2e6, 2.5e7, 6e8);
        std::size_t affordable = std::size_t(std::fmin(node_steps / double(springs), report.by_extent(1e5, 3e5, 2e6)));
        for (cd_precision precision : precisions()) {
            if (how.textbook && precision != precisions().front()) continue;
            study.curves.push_back({&how, precision,
                                    points_between(how.is_explicit() ? limit : 8, std::max(4 * limit, affordable),
                                                   [&](std::size_t steps) {
                                                       return modes.expected_error(how, study.time, steps);
                                                   })});
        }
    }
    return study;
}

void headline(Report& report, const Study& study) {
    Best implicit = cheapest(study, 1e-2, Kind::implicit_steps), textbook = cheapest(study, 1e-2, Kind::textbook);
    Best explicit_steps = cheapest(study, 1e-2, Kind::explicit_steps);
    if (!implicit || !explicit_steps || !textbook) return;
    const Best& best = implicit.seconds() < explicit_steps.seconds() ? implicit : explicit_steps;
    report.page.headline(si(best.seconds(), "s", 2),
                         "simulates one second of a wave on 1000 springs to 1% (" + best.curve->name() +
                             "); the textbook takes " + si(textbook.seconds(), "s", 2));
}

}  // namespace

void report_chain_precision(Report& report) {
    report.page.section("chain-precision", "Chain: error against run time");
    report.page.paragraph(
        "A smooth wave: a Gaussian bump of standard deviation 1/20, let go from rest on a chain with both ends held, "
        "mass and stiffness 1, simulated for 1 s in which it splits, turns round at both ends and meets again upside "
        "down. The error is the greatest over all nodes, relative to the greatest displacement, against the exact "
        "motion of the same chain by its sine modes: the error of the time steps alone, not of the lattice. Every "
        "point is one step size. Times are the least of several runs that take turns, the first left out, and include "
        "the factorization. The textbook is the notes as anyone would write them: plain loops, Numerical Recipes' "
        "elimination.");
    WorkTables tables;
    std::vector<std::string> panels, findings;
    std::vector<Series> series;
    for (std::size_t springs : {100, 1000}) {
        Study study = smooth_wave(report, springs);
        measure(report, study);
        tables.add(report, study, "n = " + std::to_string(springs));
        panels.push_back(draw(study, "run time of 1 simulated second", series));
        Best implicit = cheapest(study, 1e-2, Kind::implicit_steps);
        Best explicit_steps = cheapest(study, 1e-2, Kind::explicit_steps);
        findings.push_back("at n = " + std::to_string(springs) + " " + verdict(implicit, explicit_steps));
        if (springs == 1000) headline(report, study);
    }
    report.page.figure(panels, legend(series),
                       "Cheapest to 1%: " + list_words(findings) + ". Left and down is better. A curve bends upwards "
                       "on the left where the rounding of its precision is met. Forward Euler is shown only where it "
                       "has not yet grown past the size of the wave.");
    report.page.table(tables.table, "The cheapest run that reaches each error. Explicit steps may not be longer than "
                                    "their stability limit, however little accuracy is asked for.");
    report.save("chain_work_precision.csv", tables.points);
    report.save("chain_cheapest.csv", tables.cheapest);
}

}  // namespace report
