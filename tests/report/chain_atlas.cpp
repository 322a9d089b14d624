// The chain's pages of the stability atlas: stiffness and step, one odd mass and step.
#include <cmath>
#include <map>
#include <random>

#include "atlas.hpp"
#include "chain_parts.hpp"

namespace report {
namespace {

const std::size_t kSprings = 16;

// Both ends held, all else at random: every mode moves.
Problem shaken(double stiffness, double odd_mass) {
    Problem problem;
    problem.springs = kSprings;
    problem.mass = double(kSprings + 1); // 1 a node
    problem.stiffness = stiffness * problem.mass;
    problem.pin_first = problem.pin_last = true;
    if (odd_mass != 1) problem.node_mass.assign(kSprings + 1, 1), problem.node_mass[kSprings / 2] = odd_mass;
    std::mt19937 random(7);
    auto any = [&] { return double(float(double(random()) / 2147483648.0 - 1)); };
    problem.position.assign(kSprings + 1, 0), problem.velocity.assign(kSprings + 1, 0);
    for (std::size_t i = 1; i < kSprings; ++i) {
        problem.position[i] = any();
        problem.velocity[i] = std::sqrt(stiffness) * any();
    }
    return problem;
}

Lattice lattice_of(const Problem& problem) {
    Lattice lattice{problem.node_mass, {}, {}};
    if (lattice.mass.empty()) lattice.mass.assign(kSprings + 1, problem.mass_of_node());
    lattice.held.assign(kSprings + 1, false);
    lattice.held.front() = lattice.held.back() = true;
    for (std::size_t i = 0; i < kSprings; ++i) lattice.springs.push_back({i, i + 1, problem.stiffness_of_spring()});
    return lattice;
}

Course run(const Problem& problem, const Method& how, cd_precision precision, double dt) {
    std::unique_ptr<Runner> runner = make_runner(problem, how, precision);
    const Lattice lattice = lattice_of(problem);
    Watch watch(lattice.energy(problem.position, problem.velocity));
    std::size_t made = 0;
    for (std::size_t look : looks()) {
        if (!runner->step(dt, look - made)) {
            watch.lose();
            break;
        }
        watch.see(lattice.energy(runner->positions(), runner->velocities()));
        made = look;
    }
    return watch.course();
}

AtlasCase chart(const std::string& sweep, const Method& how, cd_precision precision, const AtlasAxis& x,
                const AtlasAxis& y, const std::function<Problem(double)>& problem_at) {
    AtlasCase made{"chain", sweep, how, precision, x, y, {}, {}, {}, !how.textbook};
    std::map<double, std::pair<Problem, std::vector<Vibration>>> known;
    for (double value : x.values) {
        const Problem problem = problem_at(value);
        known[value] = {problem, lattice_of(problem).vibrations(problem.position, problem.velocity)};
    }
    made.practice = [=](double value, double dt) { return run(known.at(value).first, how, precision, dt); };
    made.theory = [=](double value, double dt) {
        return Expected(course_of(known.at(value).second, how, dt), precision);
    };
    return made;
}

Method quarter() {
    Method how = method(Way::half);
    how.key = "implicit_quarter", how.name = "λ = 1/4", how.lambda = 0.25;
    return how;
}

} // namespace

void report_chain_atlas(Report& report) {
    report.page.section("chain-atlas", "Chains: which steps are stable");
    report.page.paragraph(
        "A chain of 16 springs with both ends held, from random positions and velocities, 200 steps: what becomes of "
        "its energy, for every stiffness and every step. Growing: it is 1000 times that of the start at any of " +
        std::to_string(looks().size()) +
        " looks. Damped: it ends below a tenth. Not finite: the library reports that the "
        "state has left the range of its precision. Theory is the same run in exact arithmetic, the chain taken apart "
        "into its modes and each moved on by its 2 × 2 matrix; lines are where its verdict changes. A cell where the "
        "two disagree bears a cross and is listed.");
    Atlas atlas(report, "chain");
    const AtlasAxis stiffness{"stiffness", "stiffness over mass [1/s²]",
                              decades(-12, 30, report.by_extent(6.0, 1.5))},
        mass{"mass", "mass of one node / the others'", decades(-12, 12, report.by_extent(4.0, 1.0))},
        step{"dt", "time step [s]", decades(-9, 6, report.by_extent(1.5, 0.5))};
    std::vector<std::string> stiff, odd;
    for (const Method& how : {method(Way::forward_euler), method(Way::symplectic_euler), quarter(), method(Way::half),
                              method(Way::backward), method(Way::stiff_second), method(Way::textbook_half)})
        for (cd_precision precision : precisions()) {
            const std::string map =
                atlas.add(chart("stiffness", how, precision, stiffness, step, [](double k) { return shaken(k, 1); }));
            if (precision == precisions().back()) stiff.push_back(map);
        }
    for (const Method& how : {method(Way::forward_euler), method(Way::symplectic_euler), method(Way::half),
                              method(Way::backward), method(Way::stiff_second)})
        for (cd_precision precision : precisions()) {
            const std::string map =
                atlas.add(chart("mass ratio", how, precision, mass, step, [](double r) { return shaken(1, r); }));
            if (precision == precisions().back()) odd.push_back(map);
        }
    report.page.figure(
        stiff, fate_legend(),
        "Stiffness and step: " + atlas.agreement() + "; drawn is " + name_of(precisions().back()) +
            ". Symplectic Euler is bounded below dt = 2/ω of the fastest "
            "mode and lost above it. Forward Euler grows everywhere: below its line too slowly to be "
            "seen in 200 steps. With λ = 1/4 energy grows at most ninefold a step, but grows. λ = 1/2 is bounded "
            "everywhere; λ = 1 and the stiff second-order method damp what the step cannot resolve.",
        300);
    report.page.figure(odd, fate_legend(),
                       "One odd mass in the middle, stiffness over mass 1: a single light node sets the explicit "
                       "limit for all, dt ~ √mass, and does nothing to implicit steps. A heavy node changes nothing.",
                       300);
    atlas.finish();
}

} // namespace report
