// What Kass's notes claim, what was measured, and what their misprints would have done.
#include <cmath>

#include "chain_runner.hpp"
#include "format.hpp"
#include "modes.hpp"
#include "report.hpp"
#include "textbook.hpp"

namespace report {
namespace {

const double kFrame = 1.0 / 60;

// ---- what no other part of the report measures ----

// The energy of a chain stretched evenly by 2 m, over k 2^2 / 2, for the worst of several n: less 1.
double total_stiffness_error() {
    double worst = 0;
    for (std::size_t springs : {1, 10, 1000}) {
        Chain chain(springs, 1, precisions().front());
        std::vector<double> x;
        for (std::size_t i = 0; i <= springs; ++i) x.push_back(2 * double(i) / double(springs));
        check(cd_chain_set_stiffness(chain.get(), 3));
        chain.write(CD_POSITION, x);
        double elastic = 0;
        check(cd_chain_get_energy(chain.get(), nullptr, &elastic, nullptr));
        worst = std::fmax(worst, std::fabs(elastic / 6 - 1));
    }
    return worst;
}

// Of the longest stable step against n.
double exponent_of_stable_dt() {
    auto limit = [](std::size_t springs) {
        Problem problem;
        problem.springs = springs;
        return stable_dt(problem);
    };
    return std::log(limit(10000) / limit(100)) / std::log(100);
}

// How much higher a wave stands after 1 s of forward Euler at that limit than at the start, for 100 springs.
double forward_euler_growth() {
    Problem problem;
    problem.springs = 100;
    problem.pin_first = problem.pin_last = true;
    for (std::size_t i = 0; i <= 100; ++i) problem.position.push_back(std::sin(double(i % 100) * M_PI / 100));
    const double dt = stable_dt(problem);
    std::unique_ptr<Runner> runner = make_runner(problem, method(Way::forward_euler), precisions().front());
    if (!runner->step(dt, std::size_t(1 / dt))) return INFINITY;
    double most = 0;
    for (double x : runner->positions()) most = std::fmax(most, std::fabs(x));
    return most;
}

// A free chain of stiffness 1e30, one node of it pushed: how far apart velocities are after a step, over their mean.
double spread_when_rigid(Way way) {
    Problem problem;
    problem.springs = 100;
    problem.stiffness = 1e30;
    problem.position.assign(101, 0), problem.velocity.assign(101, 0);
    problem.velocity[0] = 101;
    std::unique_ptr<Runner> runner = make_runner(problem, method(way), precisions().back());
    if (!runner->step(kFrame, 1)) return INFINITY;
    const std::vector<double> v = runner->velocities();
    double low = INFINITY, high = -INFINITY;
    for (double speed : v) low = std::fmin(low, speed), high = std::fmax(high, speed);
    return std::isfinite(high - low) ? std::fmax(high - low, std::fabs(v[0] - 1)) : INFINITY;
}

// When a wave whose period is 1 s is half as high, by lambda = 1 at 60 steps a second.
double half_life(double lambda) {
    Problem problem;
    problem.springs = 2;
    problem.pin_first = problem.pin_last = true;
    problem.mass = 3, problem.stiffness = M_PI * M_PI; // one node of 1 kg between two springs: omega = 2 pi
    problem.position = {0, 1, 0};
    std::unique_ptr<Runner> runner =
        make_runner(problem, method(lambda == 1 ? Way::backward : Way::half), precisions().front());
    for (std::size_t step = 1; step <= 6000; ++step) {
        runner->step(kFrame, 1);
        if (std::hypot(runner->positions()[1], runner->velocities()[1] / (2 * M_PI)) < 0.5)
            return double(step) * kFrame;
    }
    return INFINITY;
}

// The frequency of a hinged beam's slowest motion over that of the continuum, pi^2 sqrt(b / m), by its energy in that
// shape: bend (i - 1, i, i + 1) of n^power b a node.
double beam_frequency(std::size_t springs, int power) {
    Chain chain(springs, 1, precisions().front());
    const double n = double(springs);
    check(cd_chain_set_stiffness(chain.get(), 0));
    check(cd_chain_set_bend(chain.get(), std::pow(n, power - 3))); // the library multiplies by n^3
    std::vector<double> x;
    for (std::size_t i = 0; i <= springs; ++i) x.push_back(std::sin(double(i) * M_PI / n));
    chain.write(CD_POSITION, x);
    double elastic = 0, squares = 0;
    check(cd_chain_get_energy(chain.get(), nullptr, &elastic, nullptr));
    for (double at : x) squares += at * at / (n + 1);
    return std::sqrt(2 * elastic / squares) / (M_PI * M_PI);
}

// How high a bump of height 1 stands after a second, if forces push the way that eq. 9 and 14 print.
double growth_of_wrong_sign() {
    Problem problem;
    problem.springs = 100;
    problem.pin_first = problem.pin_last = true;
    TextbookChain<double> chain(101, problem.mass_of_node(), -problem.stiffness_of_spring());
    chain.pin_first = chain.pin_last = true;
    for (std::size_t i = 1; i < 100; ++i)
        chain.x[i] = std::sin(double(i) * M_PI / 100) + 1e-9 * std::sin(double(37 * i));
    const double dt = 0.5 * stable_dt(problem);
    for (std::size_t step = 0; step < std::size_t(1 / dt); ++step) chain.explicit_step(dt, true);
    double most = 0;
    for (double x : chain.x) most = std::fmax(most, std::fabs(x));
    return most;
}

// The frequency of the slowest motion of 100 springs over the right one, if A's Hessian lacks its -dt/m: a stiffness
// of m / dt times the right one.
double frequency_without_factor(double mass) {
    Problem problem;
    problem.springs = 100;
    problem.mass = problem.stiffness = mass;
    return std::sqrt(problem.mass_of_node() / kFrame);
}

bool negative_stiffness_is_refused() {
    Chain chain(2, 1, precisions().front());
    return cd_chain_set_stiffness(chain.get(), -1) == CD_ERROR_VALUE;
}

// ---- the table ----

class Claims {
public:
    explicit Claims(Report& report) : report_(report) {}

    // A measured number within [low, high] makes the claim hold.
    void check_range(const std::string& claim, const std::string& where, const std::string& key, double measured,
                     const std::string& words, double low, double high, const std::string& holds,
                     const std::string& fails) {
        const bool known = !std::isnan(measured), good = measured >= low && measured <= high;
        table_.rows.push_back({claim, where, known ? words : "not measured in this run",
                               !known ? ""
                               : good ? holds
                                      : fails});
        if (!known) return;
        csv_.row(key, measured, low, high, int(good));
        report_.summary("notes." + key, measured);
    }

    void finish(const std::string& name, const std::string& caption) {
        report_.page.table(table_, caption);
        table_.rows.clear();
        report_.save(name, csv_);
    }

private:
    Report& report_;
    Table table_{{"claim", "where", "measured", "verdict"}, {}, {1, 2, 3}, true};
    Csv csv_{"claim,measured,low,high,within"};
};

} // namespace

void report_notes(Report& report) {
    report.page.section("notes", "Theory: the claims of Kass's notes, checked");
    report.page.paragraph(
        "Michael Kass, An Introduction to Continuum Dynamics for Computer Graphics (1997). What the notes say of their "
        "methods, and what this report measured of it. Figures of other parts of this page are taken from there.");
    auto printed = [&](const std::string& key) { return report.figure(key); };
    auto n = [](double value, int digits = 3) { return number(value, digits); };
    Claims claims(report);

    double value = total_stiffness_error();
    claims.check_range("n springs of n k each are together as stiff as one of k", "eq. 7", "total_stiffness", value,
                       "energy of an even stretch within " + n(value, 1) + " for n = 1, 10, 1000", 0, 1e-12, "holds",
                       "does not hold");
    value = exponent_of_stable_dt();
    claims.check_range("explicit steps must shrink as 1/n", "eq. 13", "stable_dt_exponent", value,
                       "longest stable step ~ n^" + n(value), -1.02, -0.98, "holds, of symplectic Euler",
                       "does not hold");
    value = forward_euler_growth();
    claims.check_range("steps so short make Euler's method stable", "eq. 13", "forward_euler_growth", value,
                       "a wave of height 1 stands " + n(value, 2) + " high after 1 s", 0, 1.5, "holds",
                       "does not hold: information keeps up, but forward Euler grows at every step");
    value = printed("chain.crossing.n100.forward_euler");
    claims.check_range(
        "a disturbance crosses n springs in 2n Euler steps", "after eq. 13", "steps_to_cross_100", value,
        plain(value) + " steps for n = 100; symplectic Euler " + plain(printed("chain.crossing.n100.symplectic_euler")),
        199, 201, "holds, of forward Euler", "does not hold");
    value = printed("chain.crossing.n100.implicit_half");
    claims.check_range("one implicit step crosses any number of springs", "eq. 21", "implicit_steps_to_cross", value,
                       plain(value) + " step for n = 100 and 300", 1, 1, "holds", "does not hold");
    const std::string wide = name_of(precisions().front());
    value = printed("chain.growth.exponent.symplectic_euler." + wide);
    claims.check_range("an explicit second costs n²", "after eq. 13", "explicit_exponent", value, "n^" + n(value), 1.7,
                       2.3, "holds", "not seen in this run: sizes too small, or a busy machine");
    value = printed("chain.growth.exponent.implicit_half." + wide);
    claims.check_range("an implicit second costs n", "eq. 29-31", "implicit_exponent", value, "n^" + n(value), 0.85,
                       1.2, "holds, at fixed error", "not seen in this run: sizes too small, or a busy machine");
    value = printed("chain.atlas.differ_unexplained") + printed("membrane.atlas.differ_unexplained");
    claims.check_range("implicit steps are stable at any stiffness and step", "eq. 21", "atlas_cells_that_differ",
                       value,
                       plain(value) + " cells of the chain's and the membrane's atlas differ from theory unexplained",
                       0, 0, "holds for λ of 1/2 and more", "see the atlas");
    value = half_life(1);
    claims.check_range("λ = 1 damps, λ = 1/2 does not", "eq. 18-21", "half_life_of_1_s_wave", value,
                       "60 steps a second: a wave of period 1 s is half as high after " + n(value) + " s with λ = 1, " +
                           (std::isinf(half_life(0.5)) ? "not in 100 s" : n(half_life(0.5)) + " s") + " with 1/2",
                       2.0, 2.2, "holds, and is much: λ = 1/2 is the library's default", "does not hold");
    value = printed("chain.figure2.largest_relative_error");
    claims.check_range("a step is a low-pass filter run forward and back", "eq. 31, figure 2", "figure2_error", value,
                       "the exact filter within " + n(value, 2), 0, 1e-12, "holds", "does not hold");
    value = spread_when_rigid(Way::backward);
    const double lost = spread_when_rigid(Way::textbook_backward);
    claims.check_range(
        "in the limit all mass points move together", "after eq. 31", "spread_when_rigid", value,
        "stiffness 10³⁰, " + std::string(name_of(precisions().back())) + ": velocities within " + n(value, 2) +
            " of their mean; the notes' elimination in plain loops: " + (std::isfinite(lost) ? n(lost, 2) : "lost"),
        0, 1e-6, "holds; it takes an elimination without subtractions", "does not hold");
    value = printed("membrane.growth.exponent.alternating_half." + wide) / 2;
    claims.check_range("rows, then columns: a sheet costs as many operations as it has nodes", "section 9",
                       "sheet_exponent_per_node", value, "(nodes)^" + n(value), 0.85, 1.25, "holds",
                       "not seen in this run: sizes too small, or a busy machine");
    value = printed("membrane.safe.textbook_growth_of_speed.two_corners.k10000");
    claims.check_range("rows, then columns, is as stable as each", "section 9", "growth_by_two_factors", value,
                       "cloth held at two corners: speeds grow " + n(value, 2) + " times in 600 steps; the library's " +
                           n(printed("membrane.safe.library_greatest_growth_of_speed"), 2) + " times",
                       0, 10, "holds", "only where whole edges are held");
    value = printed("water.lake.textbook_gained") / 100;
    claims.check_range("water keeps its volume", "eq. 32-33", "textbook_lake_gained", value,
                       "a lake beside a dry bank, 10 s: " + percent(value, 2) + " gained by the scheme as printed, " +
                           n(printed("water.lake.contdyn_gained"), 1) + " by the library",
                       -1e-6, 1e-6, "holds", "does not hold at a shore");
    value = printed("water.any_step.highest_water_over_first");
    claims.check_range("water is stable at large steps", "section 10", "highest_water", value,
                       "Courant numbers to 5000: water at most " + n(value) +
                           " times as high as at first; the printed scheme's volume off by up to " +
                           n(printed("water.any_step.textbook_worst_volume_error"), 2) + "%",
                       0, 2, "holds for waves, and for streams up to 32 cells a step", "see the table");
    value = printed("water.growth.per_cell_exponent.linear_half");
    claims.check_range("a step of water costs as many operations as there are cells", "section 10",
                       "water_exponent_per_cell", value, "(cells)^" + n(value), 0.85, 1.25, "holds",
                       "not seen in this run: sizes too small, or a busy machine");
    claims.finish("notes_claims.csv",
                  "The notes' claims hold for waves and smooth motion; what they do not say is where "
                  "forward Euler, two factors and shores fail. Exponents come from this run's "
                  "timings.");

    Claims misprints(report);
    value = beam_frequency(100, 3);
    const double soft = beam_frequency(100, 2);
    misprints.check_range("bend of n² b a node", "eq. 8", "beam_frequency_of_n3", value,
                          "a hinged beam of 100 springs swings at " + n(value, 4) + " of its frequency with n³, at " +
                              n(soft) + " with n², and at " + n(beam_frequency(1000, 2)) + " with 1000 springs",
                          0.99, 1.01, "misprint: n³ it must be; finer beams would be ever softer", "not understood");
    value = growth_of_wrong_sign();
    misprints.check_range("forces of the sign printed", "eq. 9, 14", "wrong_sign_growth", value,
                          "a bump of height 1 stands " + n(value, 2) + " high after 1 s; the library " +
                              (negative_stiffness_is_refused() ? "refuses" : "takes") + " a negative stiffness",
                          1e3, INFINITY, "misprint: F = −∂E/∂x", "not understood");
    value = frequency_without_factor(1);
    misprints.check_range("A without −dt/m on the Hessian", "eq. 26-28", "frequency_without_factor", value,
                          "100 springs at 60 steps a second swing at " + n(value) +
                              " of their frequency if they weigh "
                              "1 kg, at " +
                              n(frequency_without_factor(100)) + " if 100 kg, at the same k/m",
                          0.01, 0.99, "misprint: units disagree too", "not understood");
    value = printed("water.lake.textbook_gained") / 100;
    misprints.check_range(
        "faces as deep as the mean of their cells, everywhere", "section 10", "mean_depth_gained", value,
        "water runs out of dry banks: the lake gains " + percent(value, 2) +
            " in 10 s; with the gate between wet and dry " + n(printed("water.lake.contdyn_gained"), 1),
        0.01, 1, "not a misprint, but must not stand at a shore", "not understood");
    misprints.finish("notes_misprints.csv", "What the notes misprint, and what each misprint would have done.");
    double cells = 0, differ = 0;
    for (const char* object : {"chain", "membrane", "water"}) {
        cells += printed(std::string(object) + ".atlas.cells");
        differ += printed(std::string(object) + ".atlas.differ_from_theory");
    }
    if (!std::isnan(cells))
        report.page.headline(count(cells), "scenes of every stiffness, depth, mass and step stood beside theory; " +
                                               count(differ) +
                                               " of them differ, nearly all of them streams of water that run "
                                               "more than 32 cells in a step");
    report.progress("the notes' claims");
}

} // namespace report
