// A rope of fixed length that swings from level: how far it stretches, where its end is after a second, and what a
// frame costs, beside position-based dynamics, the usual solver of games, in the same program.
#include <algorithm>
#include <cmath>

#include "chain_parts.hpp"
#include "each_width.hpp"
#include "format.hpp"
#include "plot.hpp"
#include "timing.hpp"

namespace report {
namespace {

const double kLength = 10, kGravity = 9.81, kFrame = 1.0 / 60;
const std::size_t kFrames = 120, kSettled = 6,
                  kEnd = 60; // stretch counts from the one on, the end's place at the other

// Strand s starts turned by s / 10 from level.
double start(std::size_t strand, std::size_t component) {
    const double angle = 0.1 * double(strand);
    return component == 0 ? std::cos(angle) : component == 1 ? -std::sin(angle) : 0;
}

// What a run came to.
struct Outcome {
    double stretch = 0;      // of the longest spring
    std::vector<double> end; // of every strand, after kEnd frames
    double seconds = 0;      // a frame
};

class Rope {
public:
    Rope(std::size_t springs, std::size_t strands) : springs(springs), strands(strands) {}
    virtual ~Rope() = default;
    virtual void reset() = 0;
    virtual void frame() = 0;
    virtual double at(std::size_t strand, std::size_t node, std::size_t component) const = 0;

    const std::size_t springs, strands;
};

double longest(const Rope& rope) {
    double most = 0;
    for (std::size_t s = 0; s < rope.strands; ++s)
        for (std::size_t i = 0; i < rope.springs; ++i) {
            double square = 0;
            for (std::size_t k = 0; k < 3; ++k) square += std::pow(rope.at(s, i + 1, k) - rope.at(s, i, k), 2);
            most = std::max(most, std::sqrt(square) * double(rope.springs) / kLength - 1);
        }
    return most;
}

Outcome run(Rope& rope) {
    Outcome outcome;
    rope.reset();
    double spent = 0;
    for (std::size_t f = 1; f <= kFrames; ++f) {
        const double begin = now();
        rope.frame();
        spent += now() - begin;
        if (f >= kSettled) outcome.stretch = std::max(outcome.stretch, longest(rope));
        for (std::size_t s = 0; s < rope.strands && f == kEnd; ++s)
            for (std::size_t k = 0; k < 3; ++k) outcome.end.push_back(rope.at(s, rope.springs, k));
    }
    std::vector<Job> jobs{{[&] { rope.reset(); },
                           [&] {
                               for (std::size_t f = 0; f < kFrames; ++f) rope.frame();
                           },
                           spent}};
    if (spent < 0.3) time_in_turns(jobs, 0.1, 3, 21);
    outcome.seconds = (spent < 0.3 ? jobs[0].least() : spent) / double(kFrames);
    return outcome;
}

class LibraryRope : public Rope {
public:
    LibraryRope(std::size_t springs, std::size_t strands, double lambda, double tolerance, std::size_t substeps = 1)
        : Rope(springs, strands), chain_(springs, 3, CD_FLOAT64, strands), substeps_(substeps) {
        const double gravity[3] = {0, -kGravity, 0};
        check(cd_chain_set_rest_length(chain_.get(), kLength));
        check(cd_chain_set_stiffness(chain_.get(), INFINITY));
        check(cd_chain_set_tolerance(chain_.get(), tolerance, 200));
        check(cd_chain_set_lambda(chain_.get(), lambda));
        check(cd_chain_set_gravity(chain_.get(), gravity, 3));
        check(cd_chain_set_end(chain_.get(), CD_END_FIRST, CD_NODE_PINNED));
    }
    void reset() override {
        std::vector<double> x;
        for (std::size_t s = 0; s < strands; ++s)
            for (std::size_t i = 0; i <= springs; ++i)
                for (std::size_t k = 0; k < 3; ++k) x.push_back(start(s, k) * kLength * double(i) / double(springs));
        check(cd_chain_reset(chain_.get()));
        chain_.write(CD_POSITION, x);
    }
    void frame() override { check(cd_chain_step(chain_.get(), kFrame / double(substeps_), substeps_)); }
    double at(std::size_t strand, std::size_t node, std::size_t component) const override {
        double x[3];
        check(cd_chain_read_f64(chain_.get(), CD_POSITION, strand, 1, node, 1, x, 3));
        return x[component];
    }

private:
    Chain chain_;
    std::size_t substeps_;
};

// Nodes of some strands side by side: number (node * 3 + component) * strands + strand.
struct State {
    std::vector<double> x, v, before;
};

// One substep: nodes fall, and `iterations` sweeps put one spring after the other right, by half the error of each of
// its nodes. It only pulls.
template <int Strands>
inline __attribute__((always_inline)) void substep(State& state, std::size_t springs, double h, int iterations) {
    const std::size_t numbers = (springs + 1) * 3 * Strands, first = 3 * Strands;
    const double length = kLength / double(springs), fall = kGravity * h;
    double *const x = state.x.data(), *const v = state.v.data(), *const before = state.before.data();
    for (std::size_t i = first; i < numbers; ++i) before[i] = x[i];
    for (std::size_t i = 1; i <= springs; ++i)
        for (int s = 0; s < Strands; ++s) v[(i * 3 + 1) * Strands + std::size_t(s)] -= fall;
    for (std::size_t i = first; i < numbers; ++i) x[i] += h * v[i];
    for (int round = 0; round < iterations; ++round)
        for (std::size_t i = 0; i < springs; ++i) {
            double *const left = x + i * first, *const right = left + first;
            const double own = i == 0 ? 0.0 : 0.5, other = 1 - own; // the first node is held
            for (std::size_t s = 0; s < Strands; ++s) {
                const double dx = right[s] - left[s], dy = right[Strands + s] - left[Strands + s],
                             dz = right[2 * Strands + s] - left[2 * Strands + s];
                const double now = std::sqrt(dx * dx + dy * dy + dz * dz), over = now - length;
                const double pull = over > 0 ? over / now : 0.0;
                left[s] += own * pull * dx, right[s] -= other * pull * dx;
                left[Strands + s] += own * pull * dy, right[Strands + s] -= other * pull * dy;
                left[2 * Strands + s] += own * pull * dz, right[2 * Strands + s] -= other * pull * dz;
            }
        }
    const double rate = 1 / h;
    for (std::size_t i = first; i < numbers; ++i) v[i] = rate * (x[i] - before[i]);
}
REPORT_EACH_WIDTH void substep_of_one(State& state, std::size_t springs, double h, int iterations) {
    substep<1>(state, springs, h, iterations);
}
REPORT_EACH_WIDTH void substep_of_eight(State& state, std::size_t springs, double h, int iterations) {
    substep<8>(state, springs, h, iterations);
}

class PositionBasedRope : public Rope {
public:
    PositionBasedRope(std::size_t springs, std::size_t strands, int substeps, int iterations)
        : Rope(springs, strands), substeps_(substeps), iterations_(iterations) {}
    void reset() override {
        state_.x.clear();
        for (std::size_t i = 0; i <= springs; ++i)
            for (std::size_t k = 0; k < 3; ++k)
                for (std::size_t s = 0; s < strands; ++s)
                    state_.x.push_back(start(s, k) * kLength * double(i) / double(springs));
        state_.before = state_.x;
        state_.v.assign(state_.x.size(), 0.0);
    }
    void frame() override {
        const double h = kFrame / substeps_;
        for (int s = 0; s < substeps_; ++s)
            if (strands == 1) substep_of_one(state_, springs, h, iterations_);
            else substep_of_eight(state_, springs, h, iterations_);
    }
    double at(std::size_t strand, std::size_t node, std::size_t component) const override {
        return state_.x[(node * 3 + component) * strands + strand];
    }

private:
    State state_;
    int substeps_, iterations_;
};

struct Setting {
    std::string key, name;
    bool library;
    double lambda, tolerance; // of the library
    int substeps, iterations; // of position-based dynamics
};

std::vector<Setting> settings(Extent extent) {
    std::vector<Setting> all;
    for (double lambda : {1.0, 0.5})
        for (const char* tolerance : {"1e-1", "1e-2", "1e-3", "1e-6"})
            all.push_back({std::string(lambda == 1 ? "one." : "half.") + tolerance,
                           "library, λ = " + std::string(lambda == 1 ? "1" : "1/2") + ", tolerance " + tolerance, true,
                           lambda, std::atof(tolerance), 0, 0});
    const std::vector<std::pair<int, int>> all_counts = {{1, 10}, {1, 100}, {20, 1}, {60, 10}, {300, 1}, {300, 10}};
    for (const auto& [substeps, iterations] : all_counts)
        if (extent == Extent::full || substeps * iterations < 600)
            all.push_back({"position_based." + std::to_string(substeps) + "x" + std::to_string(iterations),
                           "position-based, " + std::to_string(substeps) + " x " + std::to_string(iterations), false, 0,
                           0, substeps, iterations});
    return all;
}

std::unique_ptr<Rope> make(const Setting& way, std::size_t springs, std::size_t strands) {
    if (way.library) return std::make_unique<LibraryRope>(springs, strands, way.lambda, way.tolerance);
    return std::make_unique<PositionBasedRope>(springs, strands, way.substeps, way.iterations);
}

// The largest distance of an end from where it should be.
double missed(const Outcome& outcome, const Outcome& exact) {
    double most = 0;
    for (std::size_t i = 0; i < exact.end.size(); i += 3) {
        double square = 0;
        for (std::size_t k = 0; k < 3; ++k) square += std::pow(outcome.end[i + k] - exact.end[i + k], 2);
        most = std::max(most, std::sqrt(square));
    }
    return most;
}

} // namespace

void report_chain_swing(Report& report) {
    report.page.section("chain-swing", "Chains: a rope that keeps its length");
    report.page.paragraph(
        "A rope of 10 m, level, held at one end, is let go and swings for 2 s at 60 frames a second, in three "
        "dimensions, one strand and eight at once. It should not stretch at all. Position-based dynamics is written "
        "for "
        "this page and compiled for each width of vectors, in float64 as the library's ropes are; it is given by its "
        "substeps a frame and its sweeps over the springs a substep, without compliance. The library makes one step a "
        "frame. The end is compared with that of 32 steps a frame of λ = 1/2.");
    Csv rows("springs,strands,way,stretch,end_missed_m,us_per_frame,ns_per_node_and_frame");
    Table table{
        {"springs", "strands", "way", "longest spring", "end after 1 s missed by", "µs a frame", "ns a node"}, {}, {2}};
    std::vector<std::string> panels;
    std::vector<Series> all;
    std::string finding;
    for (std::size_t springs :
         report.extent == Extent::sample ? std::vector<std::size_t>{100} : std::vector<std::size_t>{20, 100, 1000}) {
        Plot plot;
        plot.title = "n = " + std::to_string(springs) + " springs";
        plot.x = {"time a node and frame", Scale::log, "s"};
        plot.y = {"stretch of the longest spring", Scale::log, "%"};
        for (std::size_t strands : {1, 8}) {
            LibraryRope fine(springs, strands, 0.5, 1e-9, 32);
            const Outcome exact = run(fine);
            Series series[3];
            for (int kind = 0; kind < 3; ++kind) {
                series[kind].name = std::string(kind == 0   ? "library, λ = 1"
                                                : kind == 1 ? "library, λ = 1/2"
                                                            : "position-based") +
                                    (strands == 1 ? ", one strand" : ", eight");
                series[kind].style = {kind, kind == 2 ? Marker::square : Marker::circle,
                                      strands == 1 ? Dash::solid : Dash::dashed, strands != 1};
            }
            double library_cost = NAN, other_cost = NAN, other_stretch = NAN;
            for (const Setting& way : settings(report.extent)) {
                const std::unique_ptr<Rope> rope = make(way, springs, strands);
                const Outcome outcome = run(*rope);
                const double nodes = double((springs + 1) * strands), end = missed(outcome, exact);
                const double each = outcome.seconds / nodes;
                rows.row(springs, strands, way.key, outcome.stretch, end, outcome.seconds * 1e6, each * 1e9);
                table.rows.push_back({std::to_string(springs), std::to_string(strands), way.name,
                                      percent(outcome.stretch, 2), number(end, 2) + " m", number(outcome.seconds * 1e6),
                                      number(each * 1e9)});
                const std::string key =
                    "chain.swing.n" + std::to_string(springs) + ".strands" + std::to_string(strands) + "." + way.key;
                report.summary(key + ".stretch", outcome.stretch * 100, "%");
                report.summary(key + ".end_missed", end, "m");
                report.summary(key + ".us_per_frame", outcome.seconds * 1e6, "us");
                if (way.library) report.outcome(key, plain(end) + " " + plain(outcome.stretch));
                Series& line = series[!way.library ? 2 : way.lambda == 1 ? 0 : 1];
                line.x.push_back(each), line.y.push_back(std::max(outcome.stretch, 1e-12));
                line.tips.push_back(way.name);
                if (way.key == "one.1e-3") library_cost = outcome.seconds;
                if (!way.library) other_cost = outcome.seconds, other_stretch = outcome.stretch;
            }
            for (const Series& line : series) plot.series.push_back(line);
            if (springs == 1000 && strands == 1)
                finding = "At n = 1000 a frame of λ = 1 to 0.1% takes " + si(library_cost, "s") + "; position-based " +
                          "dynamics takes " + si(other_cost, "s") + " for " + percent(other_stretch, 2) + ". ";
            report.progress("swing: " + std::to_string(springs) + " springs, " + std::to_string(strands) + " strands");
        }
        panels.push_back(render(plot));
        all.insert(all.end(), plot.series.begin(), plot.series.end());
    }
    report.page.figure(panels, legend(all),
                       finding + "Each marker is a tolerance of the library, or a number of substeps and sweeps.");
    report.page.table(table, "The rope that swings. Substeps x sweeps of position-based dynamics.");
    report.save("chain_swing.csv", rows);
}

} // namespace report
