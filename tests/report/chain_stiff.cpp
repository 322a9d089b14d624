// A stiff chain with a slow motion of interest: a cord of stiffness over mass 1e8 that swings as one piece on a soft
// spring. Nobody wants to see the cord's own waves, yet they set the explicit step.
#include <algorithm>
#include <cmath>

#include "chain_parts.hpp"
#include "format.hpp"
#include "modes.hpp"
#include "work_precision.hpp"

namespace report {
namespace {

const std::size_t kSprings = 100;
const double kStiffness = 1e8, kTie = 50;

struct Mode {
    double omega;
    std::vector<double> shape;
};

// The slowest mode. From the free end on, x_i = cos((i + 1/2) a) with omega^2 = 4 (k/m) sin^2(a/2) meets every equation
// but the last node's, k (x_{n-1} - x_n) = (tie - m omega^2) x_n; a is found by bisection.
Mode slowest_mode(const Problem& problem) {
    const long double k = problem.stiffness_of_spring(), m = problem.mass_of_node();
    const std::size_t n = problem.springs;
    auto omega_squared = [&](long double a) { return 4 * k / m * std::sin(a / 2) * std::sin(a / 2); };
    auto missing = [&](long double a) {
        long double pull = 2 * k * std::sin((long double)n * a) * std::sin(a / 2);
        return pull - ((long double)problem.tie - m * omega_squared(a)) * std::cos(((long double)n + 0.5L) * a);
    };
    long double low = 0, high = 1 / (long double)n;
    for (int i = 0; i < 200; ++i) {
        long double middle = (low + high) / 2;
        (missing(middle) < 0 ? low : high) = middle;
    }
    Mode mode{double(std::sqrt(omega_squared(low))), {}};
    for (std::size_t i = 0; i <= n; ++i) mode.shape.push_back(double(std::cos(((long double)i + 0.5L) * low)));
    return mode;
}

// In the narrowest precision run.
double error_with(const Study& study, Way way, std::size_t steps) {
    double error = NAN;
    for (const Curve& curve : study.curves)
        for (const Point& point : curve.points)
            if (curve.how == &method(way) && point.steps == steps) error = point.error;
    return error;
}

}  // namespace

void report_chain_stiff(Report& report) {
    Study study;
    study.key = "chain.stiff";
    study.title = "n = 100, stiffness over mass 10⁸";
    study.time = 1;
    Problem problem;
    problem.springs = kSprings;
    problem.stiffness = kStiffness;
    problem.tie = kTie;
    const Mode mode = slowest_mode(problem);
    problem.position = study.exact = mode.shape;
    for (double& x : study.exact) x *= std::cos(mode.omega * study.time);
    study.make = runners_of(problem);

    const std::size_t limit = std::size_t(std::ceil(study.time / (0.9999 * stable_dt(problem))));
    const std::size_t most = report.by_extent<std::size_t>(4096, 65536);
    for (Way way : {Way::symplectic_euler, Way::half, Way::backward, Way::stiff_second, Way::textbook_symplectic,
                    Way::textbook_half})
        for (cd_precision precision : precisions()) {
            const Method& how = method(way);
            auto expected = [&](std::size_t steps) {
                double after = mode_after(how, mode.omega, 0, study.time / double(steps), steps);
                return std::fabs(after / std::cos(mode.omega * study.time) - 1);
            };
            bool with_limit = how.is_explicit();
            if (with_limit && precision == CD_FLOAT32 && precisions().size() > 1) continue;
            study.curves.push_back({&how, precision, points_between(with_limit ? limit : 4,
                                                                   with_limit ? limit : most, expected)});
        }

    report.page.section("chain-stiff", "Chains: stiff springs and a slow motion");
    report.page.paragraph(
        "A cord of 100 springs, stiffness over mass 10⁸ as a whole, is free at one end and hangs at the other on a "
        "soft spring, and swings in its slowest mode with a period of " + si(2 * M_PI / mode.omega, "s") +
        ". The cord's own waves cross it in " + si(1 / std::sqrt(kStiffness), "s") + " and are never excited, but an "
        "explicit step must be shorter than " + si(stable_dt(problem), "s") + " to survive them. The exact answer is "
        "that mode, its frequency found by bisection in extended precision.");
    measure(report, study);
    std::vector<Series> series;
    WorkTables tables;
    tables.add(report, study, "stiff cord");
    std::string panel = draw(study, "run time of 1 simulated second", series);
    Best implicit = cheapest(study, 1e-2, Kind::implicit_steps),
         explicit_steps = cheapest(study, 1e-2, Kind::explicit_steps);
    std::string finding = "No run reached 1%";
    if (implicit && explicit_steps) {
        double ratio = explicit_steps.seconds() / implicit.seconds();
        finding = "To 1%, " + implicit.curve->name() + " is " + number(ratio, 2) + " times cheaper than the best "
                  "explicit run: " + count(double(implicit.point->steps)) + " steps instead of " +
                  count(double(explicit_steps.point->steps));
        report.page.headline(number(ratio, 2) + "×", "cheaper than explicit steps on a stiff chain with a slow motion "
                                                     "of interest, at 1% error");
    }
    double library = error_with(study, Way::half, 64), textbook = error_with(study, Way::textbook_half, 64);
    report.page.figure({panel}, legend(series),
                       finding + ". The explicit runs stand at the one step their stability allows. With 64 steps in " +
                       name_of(study.curves.back().precision) + " λ = 1/2 errs by " + percent(library) +
                       " in the library" +
                       (std::isfinite(textbook) ? " and by " + percent(textbook) + " in" : ", and is lost in") +
                       " the textbook, whose elimination rounds the mass away beside the stiffness.");
    report.page.table(tables.table, "The stiff cord: the cheapest run that reaches each error.");
    report.save("chain_stiff_work_precision.csv", tables.points);
    report.save("chain_stiff_cheapest.csv", tables.cheapest);
    report.summary("chain.stiff.stable_dt", stable_dt(problem), "s");
}

}  // namespace report
