// The chain's extremes: every one that can be asked of it, against the same method in exact arithmetic.
#include <cmath>
#include <memory>
#include <random>

#include "chain_parts.hpp"
#include "chain_reference.hpp"
#include "format.hpp"
#include "survival.hpp"
#include "vibrations.hpp"

namespace report {
namespace {

const std::size_t kSprings = 63, kSteps = 1000;
const double kFrame = 1.0 / 60;

struct Extreme {
    std::string name;
    double stiffness = 1e4; // of a spring, over the mass of a node
    double dt = kFrame;
    double odd_mass = 1, odd_spring = 1; // one in the middle, over the others
};

struct Rope {
    Lattice lattice;
    std::vector<double> x, v;

    // Both ends held, random positions and velocities that float32 holds, alike in energy.
    explicit Rope(const Extreme& extreme) {
        const std::size_t nodes = kSprings + 1;
        lattice.mass.assign(nodes, 1);
        lattice.mass[nodes / 2] = extreme.odd_mass;
        lattice.held.assign(nodes, false);
        lattice.held.front() = lattice.held.back() = true;
        for (std::size_t i = 0; i < kSprings; ++i)
            lattice.springs.push_back({i, i + 1, extreme.stiffness * (i == kSprings / 3 ? extreme.odd_spring : 1)});
        std::mt19937 random(5);
        auto any = [&] { return double(random()) / 2147483648.0 - 1; };
        x.assign(nodes, 0), v.assign(nodes, 0);
        for (std::size_t i = 1; i + 1 < nodes; ++i) {
            x[i] = double(float(any()));
            v[i] = double(float(std::sqrt(extreme.stiffness) * any()));
        }
        const std::size_t stiff = kSprings / 3; // a spring 1e12 times as stiff is not stretched by as much as others
        if (extreme.odd_spring > 1) x[stiff + 1] = x[stiff], v[stiff + 1] = v[stiff];
    }
};

std::shared_ptr<Chain> chain_of(const Rope& rope, const Extreme& extreme, const Method& how, cd_precision precision) {
    auto chain = std::make_shared<Chain>(kSprings, 1, precision);
    check(cd_chain_set_mass(chain->get(), double(kSprings + 1)));
    check(cd_chain_set_stiffness(chain->get(), extreme.stiffness / double(kSprings)));
    for (cd_end end : {CD_END_FIRST, CD_END_LAST}) check(cd_chain_set_end(chain->get(), end, CD_NODE_PINNED));
    if (extreme.odd_mass != 1) {
        check(cd_chain_enable_field(chain->get(), CD_MASS));
        chain->write(CD_MASS, rope.lattice.mass);
    }
    if (extreme.odd_spring != 1) {
        std::vector<double> stiffness;
        for (const Lattice::Spring& spring : rope.lattice.springs) stiffness.push_back(spring.stiffness);
        check(cd_chain_enable_field(chain->get(), CD_STIFFNESS));
        chain->write(CD_STIFFNESS, stiffness);
    }
    chain->write(CD_POSITION, rope.x);
    chain->write(CD_VELOCITY, rope.v);
    check(cd_chain_set_method(chain->get(), how.method));
    if (how.method == CD_METHOD_IMPLICIT) check(cd_chain_set_lambda(chain->get(), how.lambda));
    return chain;
}

void time(Trial& trial, const std::shared_ptr<Chain>& chain, double dt, std::size_t nodes, std::size_t steps) {
    trial.node_steps = double(nodes * steps);
    trial.again = [=] { cd_chain_step(chain->get(), dt, steps); };
}

// By modes, which keep their accuracy at any uniform stiffness; with an odd mass or spring by elimination.
std::vector<double> exact_of(const Rope& rope, const Extreme& extreme, const Method& how) {
    if (extreme.odd_mass == 1 && extreme.odd_spring == 1)
        return positions_after(rope.lattice.vibrations(rope.x, rope.v), how, extreme.dt, kSteps);
    std::vector<double> springs;
    for (const Lattice::Spring& spring : rope.lattice.springs) springs.push_back(spring.stiffness);
    Reference reference(rope.lattice.mass, springs, rope.x, rope.v, true);
    for (std::size_t step = 0; step < kSteps; ++step) reference.step(how, extreme.dt);
    return {reference.x.begin(), reference.x.end()};
}

Trial run(const Extreme& extreme, const Method& how, cd_precision precision) {
    const Rope rope(extreme);
    std::shared_ptr<Chain> chain = chain_of(rope, extreme, how, precision);
    Trial trial{extreme.name, how.name, precision};
    trial.outcome = outcome_of(cd_chain_step(chain->get(), extreme.dt, kSteps));
    const std::vector<double> x = chain->read(CD_POSITION);
    const std::vector<double> exact = exact_of(rope, extreme, how);
    double apart = 0, size = 1;
    for (std::size_t i = 0; i < x.size(); ++i)
        apart = std::fmax(apart, std::fabs(x[i] - exact[i])), size = std::fmax(size, std::fabs(exact[i]));
    trial.error = apart / size;
    if (how.lambda == 0.5 && how.method == CD_METHOD_IMPLICIT)
        trial.drift = std::fabs(
            double(rope.lattice.energy(x, chain->read(CD_VELOCITY)) / rope.lattice.energy(rope.x, rope.v)) - 1);
    trial.hash = chain->hash();
    time(trial, chain, extreme.dt, kSprings + 1, 4000);
    return trial;
}

// Every joint welded: the chain moves as one body, for good.
Trial welded(cd_precision precision) {
    Trial trial{"stiffness infinite: welded", method(Way::half).name, precision};
    auto chain = std::make_shared<Chain>(kSprings, 1, precision);
    std::vector<double> x(kSprings + 1), v(kSprings + 1, 0.5);
    for (std::size_t i = 0; i <= kSprings; ++i) x[i] = double(i % 7) / 8;
    v[3] = 4.5;
    for (std::size_t i = 0; i < kSprings; ++i) check(cd_chain_weld(chain->get(), 0, i));
    chain->write(CD_POSITION, x);
    for (double& speed : v) speed = 0.5 + 4.0 / double(kSprings + 1); // what they then share
    chain->write(CD_VELOCITY, v);
    double before = 0, after = 0;
    check(cd_chain_get_momentum(chain->get(), &before, 1));
    trial.outcome = outcome_of(cd_chain_step(chain->get(), kFrame, kSteps));
    check(cd_chain_get_momentum(chain->get(), &after, 1));
    const std::vector<double> there = chain->read(CD_POSITION);
    const double gone = v[0] * kFrame * double(kSteps);
    trial.error = 0;
    for (std::size_t i = 0; i <= kSprings; ++i)
        trial.error = std::fmax(trial.error, std::fabs(there[i] - x[i] - gone) / gone);
    trial.drift = std::fabs(after / before - 1);
    trial.hash = chain->hash();
    time(trial, chain, kFrame, kSprings + 1, 4000);
    return trial;
}

// One node falls; two on a spring swing about each other.
Trial tiny(std::size_t nodes, cd_precision precision) {
    Trial trial{nodes == 1 ? "1 node" : "2 nodes", method(Way::half).name, precision};
    Chain chain(nodes - 1, 1, precision);
    const double gravity = -9.81;
    if (nodes == 1) check(cd_chain_set_gravity(chain.get(), &gravity, 1));
    else chain.write(CD_POSITION, {1, -1});
    trial.outcome = outcome_of(cd_chain_step(chain.get(), kFrame, kSteps));
    const double t = kFrame * double(kSteps), omega = std::sqrt(2 * 1 / 0.5); // two halves of 1 kg, 1 N/m
    const double exact = nodes == 1 ? gravity * t * t / 2 : mode_after(method(Way::half), omega, 0, kFrame, kSteps);
    trial.error = std::fabs(chain.read(CD_POSITION)[0] - exact) / std::fmax(1, std::fabs(exact));
    trial.hash = chain.hash();
    return trial;
}

// The slowest mode of a very long chain, a quarter of a period in 8 steps.
Trial huge(std::size_t springs, cd_precision precision) {
    Trial trial{count(double(springs)) + " springs", method(Way::half).name, precision};
    auto chain = std::make_shared<Chain>(springs, 1, precision);
    for (cd_end end : {CD_END_FIRST, CD_END_LAST}) check(cd_chain_set_end(chain->get(), end, CD_NODE_PINNED));
    std::vector<double> x(springs + 1);
    for (std::size_t i = 1; i < springs; ++i) x[i] = std::sin(double(i) * M_PI / double(springs));
    chain->write(CD_POSITION, x);
    const double n = double(springs), omega = 2 * std::sqrt(n * (n + 1)) * std::sin(M_PI / (2 * n)), dt = 0.2 / omega;
    trial.outcome = outcome_of(cd_chain_step(chain->get(), dt, 8));
    const double exact = mode_after(method(Way::half), omega, 0, dt, 8);
    const std::vector<double> there = chain->read(CD_POSITION);
    trial.error = 0;
    for (std::size_t i = 0; i <= springs; ++i) trial.error = std::fmax(trial.error, std::fabs(there[i] - exact * x[i]));
    trial.hash = chain->hash();
    time(trial, chain, dt, springs + 1, 1);
    return trial;
}

// Many steps: a scene that dies out may get no slower, one that keeps its energy may not drift.
Trial many(std::size_t steps, bool decays, cd_precision precision) {
    const Extreme ordinary{""};
    const Rope rope(ordinary);
    std::shared_ptr<Chain> chain = chain_of(rope, ordinary, method(Way::half), precision);
    Trial trial{count(double(steps)) + (decays ? " steps of dying out" : " steps"), method(Way::half).name, precision};
    if (decays) check(cd_chain_set_drag(chain->get(), 2));
    trial.outcome = outcome_of(cd_chain_step(chain->get(), kFrame, steps));
    const double energy = double(rope.lattice.energy(chain->read(CD_POSITION), chain->read(CD_VELOCITY)) /
                                 rope.lattice.energy(rope.x, rope.v));
    (decays ? trial.error : trial.drift) = decays ? energy : std::fabs(energy - 1);
    trial.hash = chain->hash();
    time(trial, chain, kFrame, kSprings + 1, 4000);
    return trial;
}

} // namespace

void report_chain_survival(Report& report) {
    report.page.section("chain-survival", "Chains: extreme masses, stiffness and steps");
    report.page.paragraph(
        "A chain of 63 springs with both ends held, stiffness over mass of a node 10⁴, 1000 steps at 60 a second from "
        "random positions and velocities, and then everything that can be unreasonable about it, one at a time.");
    SurvivalSheet sheet(report, "chain", "energy");
    const std::size_t large = report.by_extent<std::size_t>(100000, 10000000),
                      long_run = report.by_extent<std::size_t>(20000, 1000000);
    for (cd_precision precision : precisions()) {
        for (Way way : {Way::half, Way::backward, Way::stiff_second})
            for (const Extreme& extreme : std::vector<Extreme>{{"ordinary"},
                                                               {"stiffness over mass 10⁻¹²", 1e-12},
                                                               {"stiffness over mass 10¹⁵", 1e15},
                                                               {"stiffness over mass 10³⁰", 1e30},
                                                               {"steps of 10⁻⁹ s", 1e4, 1e-9},
                                                               {"steps of 10⁶ s", 1e4, 1e6},
                                                               {"one node 10⁶ times lighter", 1e4, kFrame, 1e-6},
                                                               {"one node 10⁶ times heavier", 1e4, kFrame, 1e6},
                                                               {"one spring 10¹² times stiffer", 1e4, kFrame, 1, 1e12}})
                if (way == Way::half || report.extent == Extent::full) sheet.add(run(extreme, method(way), precision));
        sheet.add(welded(precision));
        sheet.add(tiny(1, precision));
        sheet.add(tiny(2, precision));
        sheet.add(huge(large, precision));
        sheet.add(many(long_run, true, precision));
        sheet.add(many(long_run, false, precision));
    }
    sheet.finish(
        "Errors are of positions, the greatest over the nodes relative to the greatest, against the "
        "same method in extended precision; of what dies out, the energy that is left.",
        "Energy is kept by λ = 1/2 only; of the welded chain the column is its momentum.");
}

} // namespace report
