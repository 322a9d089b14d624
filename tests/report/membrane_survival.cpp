// The membrane's extremes, with both solvers, against the same method in exact arithmetic.
#include <cmath>
#include <memory>
#include <random>

#include "format.hpp"
#include "membrane_parts.hpp"
#include "survival.hpp"
#include "vibrations.hpp"

namespace report {
namespace {

const std::size_t kSide = 12, kLine = kSide + 1, kSteps = 200;
const double kFrame = 1.0 / 60;

struct Extreme {
    std::string name;
    double stiffness = 1e4; // of a spring, over the mass of a node
    double dt = kFrame;
    double odd_mass = 1, odd_spring = 1; // one in the middle, over the others

    bool uniform() const { return odd_mass == 1 && odd_spring == 1; }
};

// All edges held, random positions and velocities that float32 holds, alike in energy.
struct Cloth {
    Lattice lattice;
    std::vector<double> x, v;
    std::vector<Vibration> modes;

    explicit Cloth(const Extreme& extreme) {
        const std::size_t nodes = kLine * kLine, middle = nodes / 2;
        std::mt19937 random(5);
        auto any = [&] { return double(random()) / 2147483648.0 - 1; };
        x.assign(nodes, 0), v.assign(nodes, 0);
        for (std::size_t k = 0; k < nodes; ++k) {
            const std::size_t i = k % kLine, j = k / kLine;
            lattice.mass.push_back(k == middle ? extreme.odd_mass : 1);
            lattice.held.push_back(i == 0 || j == 0 || i == kSide || j == kSide);
            if (i < kSide)
                lattice.springs.push_back({k, k + 1, extreme.stiffness * (k == middle ? extreme.odd_spring : 1)});
            if (j < kSide) lattice.springs.push_back({k, k + kLine, extreme.stiffness});
            if (!lattice.held[k])
                x[k] = double(float(any())), v[k] = double(float(std::sqrt(extreme.stiffness) * any()));
        }
        if (extreme.odd_spring > 1) x[middle + 1] = x[middle], v[middle + 1] = v[middle];
        modes = extreme.uniform()         ? waves(extreme.stiffness)
                : extreme.odd_spring == 1 ? lattice.vibrations(x, v)
                                          : welded(middle, middle + 1);
    }

private:
    // With a spring 1e12 times stiffer its two nodes move as one, to 1e-12.
    std::vector<Vibration> welded(std::size_t a, std::size_t b) const {
        Lattice one = lattice;
        one.mass[a] += one.mass[b];
        one.held[b] = true;
        one.springs.clear();
        for (Lattice::Spring spring : lattice.springs) {
            if (spring.a == b) spring.a = a;
            if (spring.b == b) spring.b = a;
            if (spring.a != spring.b) one.springs.push_back(spring);
        }
        std::vector<Vibration> modes = one.vibrations(x, v);
        for (Vibration& mode : modes) mode.shape[b] = mode.shape[a];
        return modes;
    }

    // sin(p pi i / n) sin(q pi j / n), of unit mass.
    std::vector<Vibration> waves(double stiffness) const {
        const double n = double(kSide), pull = 2 * std::sqrt(stiffness);
        std::vector<Vibration> modes;
        for (std::size_t q = 1; q < kSide; ++q)
            for (std::size_t p = 1; p < kSide; ++p) {
                Vibration mode{pull * std::sin(double(p) * M_PI / (2 * n)), pull * std::sin(double(q) * M_PI / (2 * n)),
                               0, 0, 1};
                for (std::size_t k = 0; k < x.size(); ++k) {
                    mode.shape.push_back(2 / n * std::sin(double(p * (k % kLine)) * M_PI / n) *
                                         std::sin(double(q * (k / kLine)) * M_PI / n));
                    mode.x += mode.shape[k] * x[k], mode.w += mode.shape[k] * v[k] / mode.omega();
                }
                modes.push_back(mode);
            }
        return modes;
    }
};

void time(Trial& trial, const std::shared_ptr<Sheet>& sheet, double dt, std::size_t nodes, std::size_t steps) {
    trial.node_steps = double(nodes * steps);
    trial.again = [=] { cd_membrane_step(sheet->get(), dt, steps); };
}

std::shared_ptr<Sheet> sheet_of(const Cloth& cloth, const Extreme& extreme, const Method& how, cd_precision precision) {
    auto sheet = std::make_shared<Sheet>(kSide, kSide, 1, precision);
    check(cd_membrane_set_mass(sheet->get(), double(kLine * kLine)));
    const double total = extreme.stiffness * double(kLine) / double(kSide);
    check(cd_membrane_set_stiffness(sheet->get(), total, total));
    sheet->pin_edges();
    if (extreme.odd_mass != 1) sheet->enable(CD_MASS), sheet->write(CD_MASS, cloth.lattice.mass);
    if (extreme.odd_spring != 1) {
        const double stiff = extreme.stiffness * extreme.odd_spring;
        sheet->enable(CD_STIFFNESS_U);
        check(cd_membrane_write_f64(sheet->get(), CD_STIFFNESS_U, kSide / 2, kSide / 2, 1, 1, &stiff, 1));
    }
    sheet->write(CD_POSITION, cloth.x);
    sheet->write(CD_VELOCITY, cloth.v);
    sheet->set(how);
    check(cd_membrane_set_tolerance(sheet->get(), 1e-12, 200));
    return sheet;
}

Trial run(const Extreme& extreme, const Method& how, cd_precision precision) {
    const Cloth cloth(extreme);
    std::shared_ptr<Sheet> sheet = sheet_of(cloth, extreme, how, precision);
    Trial trial{extreme.name, how.name, precision};
    trial.outcome = outcome_of(cd_membrane_step(sheet->get(), extreme.dt, kSteps));
    const std::vector<double> x = sheet->read(CD_POSITION);
    const bool coupled = how.solver == CD_SOLVER_COUPLED;
    if (coupled || extreme.uniform()) {
        const std::vector<double> exact = positions_after(cloth.modes, how, extreme.dt, kSteps);
        double apart = 0, size = 1;
        for (std::size_t k = 0; k < x.size(); ++k)
            apart = std::fmax(apart, std::fabs(x[k] - exact[k])), size = std::fmax(size, std::fabs(exact[k]));
        trial.error = apart / size;
    }
    if (coupled)
        trial.drift = std::fabs(
            double(cloth.lattice.energy(x, sheet->read(CD_VELOCITY)) / cloth.lattice.energy(cloth.x, cloth.v)) - 1);
    trial.hash = sheet->hash();
    time(trial, sheet, extreme.dt, kLine * kLine, coupled ? 20 : 1000);
    return trial;
}

// One node falls; a row and a column swing as the chain does, in their slowest mode.
Trial thin(std::size_t nu, std::size_t nv, cd_precision precision) {
    const std::size_t n = std::max(nu, nv);
    Trial trial{n == 0 ? "1 node" : nu == 0 ? "1 column" : "1 row", method(Way::alternating_half).name, precision};
    Sheet sheet(nu, nv, 1, precision);
    const double gravity = -9.81;
    std::vector<double> x(n + 1);
    if (n == 0) check(cd_membrane_set_gravity(sheet.get(), &gravity, 1));
    for (std::size_t i = 0; i <= n; ++i)
        if (n) x[i] = std::cos(M_PI * (double(i) + 0.5) / double(n + 1));
    sheet.write(CD_POSITION, x);
    trial.outcome = outcome_of(cd_membrane_step(sheet.get(), kFrame, kSteps));
    const double t = kFrame * double(kSteps), m = double(n),
                 omega = 2 * std::sqrt(m * (m + 1)) * std::sin(M_PI / (2 * (m + 1)));
    trial.error = 0;
    const double factor = n ? mode_after(method(Way::half), omega, 0, kFrame, kSteps) : 0;
    const std::vector<double> there = sheet.read(CD_POSITION);
    for (std::size_t i = 0; i <= n; ++i) {
        const double exact = n ? factor * x[i] : gravity * t * t / 2;
        trial.error = std::fmax(trial.error, std::fabs(there[i] - exact) / (n ? 1 : std::fabs(exact)));
    }
    trial.hash = sheet.hash();
    return trial;
}

// The slowest mode of a very large drum.
Trial huge(std::size_t n, cd_precision precision) {
    Trial trial{count(double(n)) + " × " + count(double(n)) + " springs", method(Way::alternating_half).name,
                precision};
    auto sheet = std::make_shared<Sheet>(n, n, 1, precision);
    sheet->pin_edges();
    std::vector<double> x((n + 1) * (n + 1));
    for (std::size_t k = 0; k < x.size(); ++k)
        x[k] = std::sin(double(k % (n + 1)) * M_PI / double(n)) * std::sin(double(k / (n + 1)) * M_PI / double(n));
    for (std::size_t k = 0; k < x.size(); ++k)
        if (k % (n + 1) == 0 || k % (n + 1) == n || k / (n + 1) == 0 || k / (n + 1) == n) x[k] = 0;
    sheet->write(CD_POSITION, x);
    const double m = double(n), omega = 2 * std::sqrt(m * (m + 1)) * std::sin(M_PI / (2 * m)), dt = 0.2 / omega;
    trial.outcome = outcome_of(cd_membrane_step(sheet->get(), dt, 8));
    const double factor = mode_after(method(Way::alternating_half), omega, omega, dt, 8);
    const std::vector<double> there = sheet->read(CD_POSITION);
    trial.error = 0;
    for (std::size_t k = 0; k < x.size(); ++k)
        trial.error = std::fmax(trial.error, std::fabs(there[k] - factor * x[k]));
    trial.hash = sheet->hash();
    time(trial, sheet, dt, x.size(), 1);
    return trial;
}

Trial many(std::size_t steps, bool decays, Way way, cd_precision precision) {
    Extreme ordinary{""};
    ordinary.stiffness = 100; // of motions slow enough for their energy to be the sheet's
    const Cloth cloth(ordinary);
    std::shared_ptr<Sheet> sheet = sheet_of(cloth, ordinary, method(way), precision);
    Trial trial{count(double(steps)) + (decays ? " steps of dying out" : " steps"), method(way).name, precision};
    if (decays) check(cd_membrane_set_drag(sheet->get(), 2));
    trial.outcome = outcome_of(cd_membrane_step(sheet->get(), kFrame, steps));
    const double energy = double(cloth.lattice.energy(sheet->read(CD_POSITION), sheet->read(CD_VELOCITY)) /
                                 cloth.lattice.energy(cloth.x, cloth.v));
    if (decays) trial.error = energy;
    else if (method(way).solver == CD_SOLVER_COUPLED) trial.drift = std::fabs(energy - 1);
    trial.hash = sheet->hash();
    time(trial, sheet, kFrame, kLine * kLine, method(way).solver == CD_SOLVER_COUPLED ? 20 : 1000);
    return trial;
}

} // namespace

void report_membrane_survival(Report& report) {
    report.page.section("membrane-survival", "Membranes and cloth: extreme masses, stiffness and steps");
    report.page.paragraph(
        "A sheet of 12 × 12 springs with all edges held, stiffness over mass of a node 10⁴, 200 steps of λ = 1/2 at 60 "
        "a second from random positions and velocities, and then everything that can be unreasonable about it, one at "
        "a time. Coupled solves go to a residual of 10⁻¹².");
    SurvivalSheet sheet(report, "membrane", "energy");
    const std::size_t large = report.by_extent<std::size_t>(300, 3162),
                      long_run = report.by_extent<std::size_t>(5000, 1000000);
    for (cd_precision precision : precisions()) {
        for (Way way : {Way::alternating_half, Way::coupled_half})
            for (const Extreme& extreme : std::vector<Extreme>{{"ordinary"},
                                                               {"stiffness over mass 10⁻¹²", 1e-12},
                                                               {"stiffness over mass 10¹⁵", 1e15},
                                                               {"stiffness over mass 10³⁰", 1e30},
                                                               {"steps of 10⁻⁹ s", 1e4, 1e-9},
                                                               {"steps of 10⁶ s", 1e4, 1e6},
                                                               {"one node 10⁶ times lighter", 1e4, kFrame, 1e-6},
                                                               {"one spring 10¹² times stiffer", 1e4, kFrame, 1, 1e12}})
                sheet.add(run(extreme, method(way), precision));
        for (const auto& [nu, nv] : std::vector<std::pair<std::size_t, std::size_t>>{{0, 0}, {40, 0}, {0, 40}})
            sheet.add(thin(nu, nv, precision));
        sheet.add(huge(large, precision));
        sheet.add(many(long_run, true, Way::alternating_half, precision));
        sheet.add(many(long_run / 50, false, Way::coupled_half, precision));
    }
    sheet.finish(
        "Errors are of positions, the greatest over the nodes, against the same method in exact arithmetic; "
        "alternating steps with an odd mass or spring have none to compare with; of what dies out, the energy "
        "that is left.",
        "Energy is kept by coupled λ = 1/2; alternating keeps another one, in which heavy modes count more.");
}

} // namespace report
