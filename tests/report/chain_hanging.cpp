// A rope of 10 m let fall from its unstretched length: how far it stretches at 60 steps a second, against the exact
// static stretch. Positions are displacements from the unstretched layout, downwards.
#include <algorithm>
#include <cmath>

#include "chain_parts.hpp"
#include "format.hpp"
#include "plot.hpp"
#include "textbook.hpp"
#include "timing.hpp"

namespace report {
namespace {

const double kLength = 10, kGravity = 9.81, kFrame = 1.0 / 60;
const std::size_t kFrames = 600;  // 10 s, of which 5 s are drawn

Problem rope(std::size_t springs) {
    Problem problem;
    problem.springs = springs;
    problem.stiffness = problem.mass * kGravity / (0.02 * kLength);
    problem.pin_first = true;
    problem.gravity = kGravity;
    return problem;
}

// Eight periods of the slowest mode, (pi/2) sqrt(k/m) in angular frequency, in frames.
std::size_t averaging_frames(const Problem& p) {
    return std::size_t(std::lround(8 * 4 / std::sqrt(p.stiffness / p.mass) / kFrame));
}

// m g / (2 k), whatever the number of springs: spring i carries the nodes below it.
double exact_stretch(const Problem& p) { return p.mass * p.gravity / (2 * p.stiffness) / kLength; }

// What a game engine's position-based solver (XPBD) makes of the same rope: substeps of one sweep over the springs.
class PositionBasedRope {
public:
    explicit PositionBasedRope(const Problem& p)
        : x(p.springs + 1),
          v(p.springs + 1),
          before_(p.springs + 1),
          weight_(p.springs + 1, float(1 / p.mass_of_node())),
          compliance_(float(1 / p.stiffness_of_spring())),
          gravity_(float(p.gravity)) {
        weight_[0] = 0;
    }

    void step(float dt, int substeps) {
        const float h = dt / float(substeps), softness = compliance_ / (h * h);
        for (int s = 0; s < substeps; ++s) {
            before_ = x;
            for (std::size_t i = 1; i < x.size(); ++i) v[i] += h * gravity_, x[i] += h * v[i];
            for (std::size_t i = 0; i + 1 < x.size(); ++i) {
                float pull = (x[i + 1] - x[i]) / (weight_[i] + weight_[i + 1] + softness);
                x[i] += weight_[i] * pull;
                x[i + 1] -= weight_[i + 1] * pull;
            }
            for (std::size_t i = 1; i < x.size(); ++i) v[i] = (x[i] - before_[i]) / h;
        }
    }

    std::vector<float> x, v;

private:
    std::vector<float> before_, weight_;
    float compliance_, gravity_;
};

struct Trace {
    std::string key, name;
    Style style;
    std::vector<double> stretch;       // after every frame
    double nanoseconds = NAN;          // per node and frame

    double mean(std::size_t frames) const {  // over the last frames
        double sum = 0;
        for (std::size_t i = stretch.size() - frames; i < stretch.size(); ++i) sum += stretch[i];
        return sum / double(frames);
    }

    double swing(std::size_t frames) const {  // greatest less least of the last frames
        auto range = std::minmax_element(stretch.end() - std::ptrdiff_t(frames), stretch.end());
        return *range.second - *range.first;
    }
};

Trace run_position_based(const Problem& problem) {
    Trace trace{"position_based", "position-based (XPBD), 20 substeps", {0, Marker::none, Dash::dashed}, {}};
    PositionBasedRope rope(problem);
    for (std::size_t f = 0; f < kFrames; ++f) {
        rope.step(float(kFrame), 20);
        trace.stretch.push_back(rope.x.back() / kLength);
    }
    std::vector<Job> jobs{{[] {}, [&rope] { rope.step(float(kFrame), 20); }, {}}};
    time_in_turns(jobs, 0.02, 3, 21);
    trace.nanoseconds = jobs[0].least() / double(problem.springs + 1) * 1e9;
    return trace;
}

Trace run(const Problem& problem, Way way, cd_precision precision) {
    const Method& how = method(way);
    std::size_t substeps = how.is_explicit() ? std::size_t(std::ceil(kFrame / (0.999 * stable_dt(problem)))) : 1;
    Trace trace{how.key, how.name, how.style, {}};
    trace.style.marker = Marker::none;
    if (how.is_explicit()) trace.name += ", " + std::to_string(substeps) + " substeps";
    std::unique_ptr<Runner> runner = make_runner(problem, how, precision);
    for (std::size_t f = 0; f < kFrames; ++f) {
        runner->step(kFrame / double(substeps), substeps);
        trace.stretch.push_back(runner->positions().back() / kLength);
    }
    std::vector<Job> jobs{{[&] { runner->reset(); },
                           [&] { runner->step(kFrame / double(substeps), 60 * substeps); }, {}}};
    time_in_turns(jobs, 0.02, 3, 21);
    trace.nanoseconds = jobs[0].least() / (60 * double(problem.springs + 1)) * 1e9;
    return trace;
}

// The fewest backward Euler steps of 1 s after which the rope hangs within 1% of where it belongs.
std::size_t large_steps(const Problem& problem, cd_precision precision) {
    std::unique_ptr<Runner> runner = make_runner(problem, method(Way::backward), precision);
    for (std::size_t steps = 1; steps < 100; ++steps) {
        runner->step(1, 1);
        if (std::fabs(runner->positions().back() / kLength / exact_stretch(problem) - 1) < 0.01) return steps;
    }
    return 0;
}

double one_huge_step(const Problem& problem, cd_precision precision) {
    std::unique_ptr<Runner> runner = make_runner(problem, method(Way::backward), precision);
    runner->step(1e4, 1);
    return runner->positions().back() / kLength;
}

}  // namespace

void report_chain_hanging(Report& report) {
    const cd_precision precision = precisions().back();
    const std::size_t window = averaging_frames(rope(1));
    report.page.section("chain-hanging", "Chain: a hanging rope");
    report.page.paragraph(
        "A rope of 10 m and 1 kg that stretches by 1% under its own weight is let go unstretched and stepped at 60 "
        "steps a second, in " + std::string(name_of(precision)) + ". The exact static stretch is m g / (2 k), whatever "
        "the number of springs. What still bounces is averaged over the last eight of its periods. The position-based "
        "solver, the usual one in games, is a textbook XPBD written for this page, with 20 substeps a frame; explicit "
        "steps get as many substeps as their stability asks for.");
    Csv frames("springs,method,frame,stretch"),
        rows("springs,method,mean_stretch,swing,exact_stretch,ns_per_node_and_frame");
    Table table{{"n", "method", "mean stretch", "of the exact", "still swinging by", "ns per node and frame"}, {}, {1}};
    std::vector<std::string> panels;
    std::vector<Series> all;
    std::string finding;
    std::vector<std::string> settled, bouncing;
    for (std::size_t springs : {100, 1000}) {
        const Problem problem = rope(springs);
        const double exact = exact_stretch(problem);
        std::vector<Trace> traces = {run_position_based(problem)};
        for (Way way : {Way::textbook_backward, Way::symplectic_euler, Way::half, Way::stiff_second, Way::backward})
            traces.push_back(run(problem, way, precision));
        Plot plot;
        plot.title = "n = " + std::to_string(springs) + " springs";
        plot.x = {"time", Scale::linear, "s", 0, 5};
        plot.y = {"stretch of the rope", Scale::linear, "%"};
        plot.guides = {{NAN, exact, NAN, exact, ""}};
        for (const Trace& trace : traces) {
            Series series{trace.name, trace.style, {}, {}, {}};
            if (trace.key == "symplectic_euler") series.name = "symplectic Euler, substeps as needed";
            for (std::size_t f = 0; f < kFrames / 2; ++f) {
                series.x.push_back(double(f + 1) * kFrame);
                series.y.push_back(trace.stretch[f]);
                frames.row(springs, trace.key, f + 1, trace.stretch[f]);
            }
            if (trace.key != "textbook_one") plot.series.push_back(series);
            const double mean = trace.mean(window), swing = trace.swing(window);
            rows.row(springs, trace.key, mean, swing, exact, trace.nanoseconds);
            table.rows.push_back({std::to_string(springs), trace.name, percent(mean, 4), number(mean / exact, 4),
                                  percent(swing, 2), number(trace.nanoseconds)});
            if (springs == 1000 && trace.key != "textbook_one")
                (swing < 0.1 * exact ? settled : bouncing).push_back(trace.name);
            std::string key = "chain.hanging.n" + std::to_string(springs) + "." + trace.key;
            report.summary(key + ".stretch", mean * 100, "%");
            report.summary(key + ".ns_per_node_and_frame", trace.nanoseconds, "ns");
            report.outcome(key, plain(trace.stretch.back()));
        }
        std::size_t steps = large_steps(problem, precision);
        double huge = one_huge_step(problem, precision);
        table.rows.push_back({std::to_string(springs), "λ = 1, one step of 10 000 s", percent(huge, 4),
                              number(huge / exact, 4), "nothing", "one step"});
        rows.row(springs, "one_step_of_1e4_s", huge, 0.0, exact, NAN);
        report.summary("chain.hanging.n" + std::to_string(springs) + ".one_step_stretch", huge * 100, "%");
        report.summary("chain.hanging.n" + std::to_string(springs) + ".steps_of_1_s", double(steps), "steps");
        panels.push_back(render(plot));
        all.insert(all.end(), plot.series.begin(), plot.series.end());
        if (springs == 1000) {
            finding = "At n = 1000 the library with λ = 1 hangs at " + percent(traces.back().mean(window), 4) +
                      " (exact: " + percent(exact, 4) + "), position-based dynamics with 20 substeps at " +
                      percent(traces.front().mean(window), 2) + ". A single step of 10 000 s gives " +
                      percent(huge, 4) + ", and " + std::to_string(steps) +
                      (steps == 1 ? " step of 1 s comes" : " steps of 1 s come") + " within a hundredth of it.";
            report.page.headline(percent(traces.back().mean(window), 4),
                                 "stretch of a hanging rope of 1000 springs at 60 steps a second, exact " +
                                     percent(exact, 4) + "; position-based dynamics with 20 substeps: " +
                                     percent(traces.front().mean(window), 2));
        }
    }
    report.page.figure(panels, legend(all),
                       finding + " The thin dashed line is the exact stretch at rest. After 10 s " +
                           list_words(settled) + (settled.size() == 1 ? " has" : " have") + " settled; " +
                           list_words(bouncing) + " still bounce, as an undamped rope does.");
    report.page.table(table, "The rope in the end. Time per frame includes all substeps.");
    report.save("chain_hanging.csv", rows);
    report.save("chain_hanging_frames.csv", frames);
}

}  // namespace report
