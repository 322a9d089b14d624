// Error against run time on a smooth wave: every method, both precisions, step sizes over three decades.
#include <algorithm>
#include <cmath>

#include "chain_parts.hpp"
#include "format.hpp"
#include "modes.hpp"
#include "work_precision.hpp"

namespace report {
namespace {

// A chain with both ends held, let go in a shape that so many modes make up.
Study string_study(const Report& report, const std::string& key, const std::vector<double>& shape,
                   std::size_t mode_count) {
    const std::size_t springs = shape.size() - 1;
    Study study;
    study.key = "chain." + key + ".n" + std::to_string(springs);
    study.title = (key == "wave" ? "smooth wave, n = " : "sharp pluck, n = ") + std::to_string(springs);
    study.time = 1;
    Problem problem;
    problem.springs = springs;
    problem.pin_first = problem.pin_last = true;
    problem.position = shape;
    study.make = runners_of(problem);
    SineModes modes(springs, 1, problem.position, mode_count);
    study.exact = modes.at(study.time);

    const std::size_t limit = std::size_t(std::ceil(study.time / (0.9999 * stable_dt(problem))));
    std::vector<Way> ways = library_ways();
    ways.insert(ways.end(), {Way::textbook_symplectic, Way::textbook_half});
    for (Way way : ways) {
        const Method& how = method(way);
        double node_steps = how.method == CD_METHOD_FORWARD_EULER ? report.by_extent(1e7, 2.5e8)
                                                                  : report.by_extent(2e6, 2.5e7);
        std::size_t affordable = std::size_t(std::fmin(node_steps / double(springs), report.by_extent(1e5, 3e5)));
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

// Drawn to a point at three tenths.
std::vector<double> pluck(std::size_t springs) {
    std::vector<double> x;
    for (std::size_t i = 0; i <= springs; ++i) {
        const double s = double(i) / double(springs);
        x.push_back(s < 0.3 ? s / 0.3 : (1 - s) / 0.7);
    }
    x.back() = 0;
    return x;
}

// A rope let fall from its unstretched length that settles by drag. Positions are displacements downwards. What is left
// to the static stretch is a sum of the modes sin((2j - 1) pi i / (2n + 1)), each of which dies out as it swings.
Study settling_rope(const Report& report) {
    const std::size_t n = 100;
    Study study;
    study.key = "chain.settling.n100";
    study.title = "hanging rope, settling, n = 100";
    study.time = 2;
    Problem problem;
    problem.springs = n;
    problem.pin_first = true;
    problem.gravity = 9.81;
    problem.stiffness = 9.81 / 0.2;  // 10 m of rope and 1% of stretch, 0.1 m
    problem.drag = 2;
    study.make = runners_of(problem);
    const double m = problem.mass_of_node(), k = problem.stiffness_of_spring();
    std::vector<double> rest(n + 1);
    for (std::size_t i = 1; i <= n; ++i) rest[i] = rest[i - 1] + m * problem.gravity * double(n + 1 - i) / k;
    study.exact = rest;
    for (std::size_t j = 1; j <= n; ++j) {
        const double a = double(2 * j - 1) * M_PI / double(2 * n + 1), omega = 2 * std::sqrt(k / m) * std::sin(a / 2);
        const double decay = problem.drag / 2, swing = std::sqrt(omega * omega - decay * decay), t = study.time;
        double share = 0, squares = 0;
        for (std::size_t i = 1; i <= n; ++i)
            share -= rest[i] * std::sin(a * double(i)), squares += std::pow(std::sin(a * double(i)), 2);
        const double now = share / squares * std::exp(-decay * t) *
                           (std::cos(swing * t) + decay / swing * std::sin(swing * t));
        for (std::size_t i = 1; i <= n; ++i) study.exact[i] += now * std::sin(a * double(i));
    }
    const std::size_t limit = std::size_t(std::ceil(study.time / (0.999 * stable_dt(problem))));
    std::vector<Way> ways = library_ways();
    ways.insert(ways.end(), {Way::textbook_symplectic, Way::textbook_half, Way::textbook_backward});
    for (Way way : ways)
        for (cd_precision precision : precisions()) {
            const Method& how = method(way);
            if (how.textbook && precision != precisions().front()) continue;
            const std::size_t most = how.method == CD_METHOD_FORWARD_EULER
                                         ? report.by_extent<std::size_t>(100, 1000) * limit
                                         : report.by_extent<std::size_t>(16, 64) * limit;
            study.curves.push_back({&how, precision, points_between(how.is_explicit() ? limit : 8, most,
                                                                    [](std::size_t) { return INFINITY; })});
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
    report.page.section("chain-precision", "Chains: error against run time");
    report.page.paragraph(
        "A smooth wave: a Gaussian bump of standard deviation 1/20, let go from rest on a chain with both ends held, "
        "mass and stiffness 1, simulated for 1 s in which it splits, turns round at both ends and meets again upside "
        "down. The error is the greatest over all nodes, relative to the greatest displacement, against the exact "
        "motion of the same chain by its sine modes: the error of the time steps alone, not of the lattice. Every "
        "point is one step size. Times are the least of several runs that take turns, the first left out, and include "
        "the factorization. A pluck: the chain drawn to a point at three tenths and let go, whose kinks every step "
        "rounds off. And a rope that falls from its unstretched length and settles by a drag of 2/s, after 2 s. The "
        "textbook is the notes as anyone would write them: plain loops, Numerical Recipes' elimination.");
    WorkTables tables;
    std::vector<std::string> panels, findings;
    std::vector<Series> series;
    std::vector<Study> studies = {string_study(report, "wave", gaussian_bump(100), 200),
                                  string_study(report, "wave", gaussian_bump(1000), 200),
                                  string_study(report, "pluck", pluck(300), 299), settling_rope(report)};
    for (Study& study : studies) {
        measure(report, study);
        tables.add(report, study, study.title);
        panels.push_back(draw(study, "run time of " + number(study.time, 1) + " simulated seconds", series));
        const Best implicit = cheapest(study, 1e-2, Kind::implicit_steps);
        const Best explicit_steps = cheapest(study, 1e-2, Kind::explicit_steps);
        findings.push_back(study.title + " " + verdict(implicit, explicit_steps));
        if (study.key == "chain.wave.n1000") headline(report, study);
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
