// Stiffness over mass from 1e-12 to 1e30 and infinity: the library against extended precision, beside the textbook.
#include <algorithm>
#include <cmath>
#include <random>

#include "chain_parts.hpp"
#include "chain_reference.hpp"
#include "format.hpp"
#include "modes.hpp"
#include "plot.hpp"

namespace report {
namespace {

const double kFrame = 1.0 / 60;
const std::size_t kSprings = 1000;

Reference reference_of(const Problem& p, double spring) {
    return Reference(p.node_mass, std::vector<double>(p.springs, spring), p.position, p.velocity);
}

double relative(const std::vector<double>& got, const std::vector<long double>& right) {
    return relative_error(got, std::vector<double>(right.begin(), right.end()));
}

// A free chain of 1000 springs, node masses 1 to 10, at its rest length (all in one place), moving at random about a
// common drift; all numbers such that float32 holds them.
Problem random_chain(double spring) {
    Problem problem;
    problem.springs = kSprings;
    problem.stiffness = spring / double(kSprings);
    std::mt19937 random(1);
    auto between = [&](double low, double high) {
        return double(float(low + (high - low) * double(random()) / 4294967296.0));
    };
    for (std::size_t i = 0; i <= kSprings; ++i) {
        problem.node_mass.push_back(between(1, 10));
        problem.position.push_back(1);
        problem.velocity.push_back(between(0.5, 1.5));
    }
    return problem;
}

struct Outcome {
    double error[4];  // of position and velocity after the first step, and after the last
    std::string hash;
};

Outcome welded_outcome(const Problem& problem, const Method& how, cd_precision precision, std::size_t steps) {
    Chain chain(kSprings, 1, precision);
    check(cd_chain_enable_field(chain.get(), CD_MASS));
    chain.write(CD_MASS, problem.node_mass);
    chain.write(CD_POSITION, problem.position);
    chain.write(CD_VELOCITY, problem.velocity);
    check(cd_chain_set_method(chain.get(), how.method));
    if (how.method == CD_METHOD_IMPLICIT) check(cd_chain_set_lambda(chain.get(), how.lambda));
    for (std::size_t i = 0; i < kSprings; ++i) check(cd_chain_weld(chain.get(), 0, i));
    Reference reference = reference_of(problem, INFINITY);
    Outcome outcome;
    for (std::size_t done = 1; done <= steps; ++done) {
        check(cd_chain_step(chain.get(), kFrame, 1));
        reference.step(how, kFrame);
        if (done != 1 && done != steps) continue;
        outcome.error[done > 1 ? 2 : 0] = relative(chain.read(CD_POSITION), reference.x);
        outcome.error[done > 1 ? 3 : 1] = relative(chain.read(CD_VELOCITY), reference.v);
    }
    outcome.hash = hex(chain.hash());
    return outcome;
}

Outcome outcome_of(double spring, const Method& how, cd_precision precision, std::size_t steps) {
    Problem problem = random_chain(std::isinf(spring) ? 1 : spring);
    if (std::isinf(spring) && !how.textbook) return welded_outcome(problem, how, precision, steps);
    problem.stiffness = spring / double(kSprings);
    std::unique_ptr<Runner> runner = make_runner(problem, how, precision);
    Reference reference = reference_of(problem, spring);
    Outcome outcome;
    for (std::size_t done = 1; done <= steps; ++done) {
        runner->step(kFrame, 1);
        reference.step(how, kFrame);
        if (done != 1 && done != steps) continue;
        outcome.error[done > 1 ? 2 : 0] = relative(runner->positions(), reference.x);
        outcome.error[done > 1 ? 3 : 1] = relative(runner->velocities(), reference.v);
    }
    outcome.hash = hex(runner->hash());
    return outcome;
}

std::string short_name(double spring) {
    return std::isinf(spring) ? "∞" : nearest_power_of_ten(spring);
}

}  // namespace

void report_chain_extremes(Report& report) {
    const cd_precision precision = precisions().back();
    const std::size_t steps = report.by_extent<std::size_t>(50, 1000);
    std::vector<double> springs = {1e-12, 1e-6, 1, 1e4, 1e6, 1e8, 1e10, 1e12, 1e16, 1e20, 1e30, INFINITY};
    if (report.extent == Extent::sample) springs = {1e-12, 1, 1e4, 1e8, 1e12, 1e30, INFINITY};
    const Way ways[] = {Way::half, Way::backward, Way::stiff_second, Way::textbook_half, Way::textbook_backward};
    report.page.section("chain-extremes", "Chains: errors at any stiffness");
    report.page.paragraph(
        "A free chain of 1000 springs at its rest length, with random masses and random velocities about a common "
        "drift, 60 steps a second, in " + std::string(name_of(precision)) + ", against the same method in extended "
        "precision. Stiffness is that of one spring over a mass of 1: 1/s². Each cell is the greatest error over the "
        "nodes, relative to the greatest value; at ∞ every joint is welded.");

    HeatMap maps[4];
    for (int m = 0; m < 4; ++m) {
        maps[m].title = std::string(m % 2 == 0 ? "position" : "velocity") + " after " +
                        (m < 2 ? "1 step" : count(double(steps)) + " steps");
        maps[m].y_label = "stiffness over mass";
        maps[m].cell_width = 72, maps[m].row_label_width = 62;
        for (Way way : ways)
            maps[m].columns.push_back(method(way).textbook       ? "textbook\n" + method(way).name.substr(9)
                                      : way == Way::stiff_second ? "library\nstiff 2nd"
                                                                 : "library\n" + method(way).name);
    }
    Csv csv("stiffness_over_mass,method,textbook,steps,position_error,velocity_error,hash");
    double worst[4] = {0, 0, 0, 0}, warm = 0, calm = 0, warmest = 0, textbook_good_to = 0;
    bool textbook_failed = false;
    for (double spring : springs) {
        for (HeatMap& map : maps) map.rows.push_back(short_name(spring));
        for (Way way : ways) {
            const Method& how = method(way);
            const Outcome outcome = outcome_of(spring, how, precision, steps);
            const double* error = outcome.error;
            report.outcome("chain.extremes " + short_name(spring) + " " + how.key, outcome.hash);
            for (int m = 0; m < 4; ++m) {
                maps[m].shade.push_back(std::isfinite(error[m]) ? (std::log10(std::fmax(error[m], 1e-8)) + 7) / 7 : 1);
                maps[m].cells.push_back(error[m] < 1e-9 ? "<10⁻⁹" : error[m] < 1e4 ? number(error[m], 1) : "lost");
                if (!how.textbook) worst[m] = std::fmax(worst[m], error[m]);
            }
            csv.row(spring, how.key, int(how.textbook), std::size_t(1), error[0], error[1], outcome.hash);
            csv.row(spring, how.key, int(how.textbook), steps, error[2], error[3], outcome.hash);
            if (how.textbook && !(std::fmax(error[0], error[2]) < 1e-2)) textbook_failed = true;
            if (way == Way::half && error[3] > warm) warm = error[3], warmest = spring;
            if (!how.textbook && way != Way::half) calm = std::fmax(calm, error[3]);
        }
        if (!textbook_failed) textbook_good_to = spring;
        report.progress("extremes: stiffness over mass " + short_name(spring));
    }
    std::vector<std::string> panels;
    for (const HeatMap& map : maps) panels.push_back(render(map));
    std::string warmth = "λ = 1 and the stiff second-order method keep velocities within " + number(calm, 2) +
                         "; λ = 1/2 loses nothing, and so also keeps what the rounding of positions puts into stiff "
                         "springs: its velocities err by up to " + number(warm, 2) + ", at " + short_name(warmest);
    if (precision != precisions().front())
        warmth += " (in " + std::string(name_of(precisions().front())) + " by " +
                  number(outcome_of(warmest, method(Way::half), precisions().front(), steps).error[3], 2) + ")";
    report.page.figure(panels, "",
                       "From 10⁻¹² to 10³⁰ and welded, the library's positions err by no more than " +
                       number(worst[0], 2) + " after one step and " + number(worst[2], 2) + " after " +
                       count(double(steps)) + "; the textbook's stay within 1% up to " + short_name(textbook_good_to) +
                       ". The textbook adds stiffness to mass in one number and loses the mass. " + warmth + ".");
    report.save("chain_extremes.csv", csv);
    report.page.headline(number(worst[2], 2), "worst error of positions after " + count(double(steps)) + " steps in " +
                         name_of(precision) + ", for stiffness over mass from 10⁻¹² to 10³⁰ and infinity; the textbook "
                         "fails beyond " + short_name(textbook_good_to));
    const std::string key = "chain.extremes.library.worst_";
    report.summary(key + "position_error_after_1_step", worst[0]);
    report.summary(key + "velocity_error_after_1_step", worst[1]);
    report.summary(key + "position_error_after_" + std::to_string(steps) + "_steps", worst[2]);
    report.summary(key + "velocity_error_after_" + std::to_string(steps) + "_steps", worst[3]);
    report.summary("chain.extremes.textbook.position_within_1_percent_up_to", textbook_good_to, "1/s^2");
}

}  // namespace report
