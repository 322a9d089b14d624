#include "kernel/rod_sweep.hh"

#include "base/node.hh"
#include "kernel/line_lanes.hh"

namespace cd {
namespace CD_NARROWER {
decltype(CD_ISA::rod_step) rod_step;
decltype(CD_ISA::rod_sweep) rod_sweep;
} // namespace CD_NARROWER
namespace CD_ISA {

namespace {

struct Sweep {
    const Lines& lines;
    const RodCoefficients& c;
    const Stage& stage;
    const Start& start;
    double *value, *slope;
    bool ends, keep; // ends: the way back ends the stage too
    bool finite = true;

    template <int N> StateLanes<N> state(size_t i, size_t first) const {
        return load_start<N>(lines, start, i * lines.pitch + first);
    }
    bool held(size_t i) const { return holds(c.pin[i]); }

    // The difference of the answer at which spring i, between two nodes, would be closed after the stage.
    template <int N> Lanes<N> spring_wish(size_t i, const StateLanes<N>& left, const StateLanes<N>& right) const {
        const double rate = c.closing ? c.closing[i] * stage.closing_rate : stage.closing_rate;
        return rate * (left.x - right.x) + stage.of_change * (left.v - right.v);
    }
    // The second difference of the answer at which the line would be straight at node i after the stage.
    template <int N> Lanes<N> bend_wish(size_t i, const StateLanes<N>& left, const StateLanes<N>& here,
                                        const StateLanes<N>& right) const {
        const auto turn = [](Lanes<N> a, Lanes<N> b, Lanes<N> z) { return (b - a) - (z - b); };
        return c.has_bend[i] *
               (stage.closing_rate * turn(left.x, here.x, right.x) + stage.of_change * turn(left.v, here.v, right.v));
    }

    // u and d: where the value at node i and the difference into it would rest without what is on their right.
    template <int N> CD_INLINED void forward(size_t first) const {
        using L = Lanes<N>;
        const L gravity = lane_gravity<N>(lines, stage.gravity, first);
        StateLanes<N> here{}, left{}, before{}; // nodes i, i - 1 and i - 2
        L u{}, d{};
        for (size_t i = 0; i < lines.nodes; ++i) {
            const size_t at = i * lines.pitch + first;
            before = left;
            left = here;
            here = state<N>(i, first);
            fetch_next_bundle<N>(lines, at);
            const L own = (1 - stage.of_change) * here.v + outside<N>(lines, c.gains, i, at, gravity, here.x, here.v);
            if (i == 0) {
                u = own;
            } else {
                const L hold = i > 1 ? d + bend_wish<N>(i - 1, before, left, here) : d;
                rod_reach(c, i, hold, spring_wish<N>(i - 1, left, here), own, u, d);
            }
            if (i % kSettleEvery == 0) {
                u = settled(u, Limits<double>::least);
                d = settled(d, Limits<double>::least);
            }
            u.store(value + at);
            d.store(slope + at);
        }
    }

    // The answer at node i is its right neighbour's less the difference between them, d.
    template <int N> CD_INLINED bool backward(size_t first) const {
        using L = Lanes<N>;
        StateLanes<N> left = state<N>(lines.nodes - 1, first), here{}, right{}; // nodes i - 1, i and i + 1
        L answer{}, d{}, probe{};
        for (size_t i = lines.nodes; i-- > 0;) {
            const size_t at = i * lines.pitch + first;
            right = here;
            here = left;
            if (i > 0) left = state<N>(i - 1, first);
            const L u_here = L::load(value + at), d_here = L::load(slope + at);
            const bool last = i + 1 == lines.nodes;
            answer = held(i) ? (1 - stage.of_change) * here.v : last ? u_here : answer - d;
            if (last) {
                d = d_here;
            } else if (i > 0) {
                d = rod_leave(c, i, answer, u_here, d_here, (d - bend_wish<N>(i, left, here, right)) - d_here);
            }
            if (i % kSettleEvery == 0) {
                answer = settled(answer, Limits<double>::least);
                d = settled(d, Limits<double>::least);
            }
            if (ends) end_stage<N>(lines, stage, here, answer, keep ? value : nullptr, at, probe);
            else answer.store(value + at);
        }
        return !probe.any_nan();
    }

    template <int N> void bundle(size_t first) {
        const Sweep here = *this; // a copy, which stores cannot be taken to change
        here.forward<N>(first);
        finite &= here.backward<N>(first);
    }
};

bool sweep(Sweep bundles, size_t first, size_t count) {
    for_each_bundle<kLinesAtOnce>(first, count, bundles, [&](size_t line, size_t left) {
        const auto& [lines, c, stage, start, value, slope, ends, keep, finite] = bundles;
        if (ends) return CD_NARROWER::rod_step(lines, c, stage, start, value, slope, keep, line, left);
        CD_NARROWER::rod_sweep(lines, c, stage, start, value, slope, line, left);
        return true;
    });
    return bundles.finite;
}

} // namespace

void rod_sweep(const Lines& lines, const RodCoefficients& c, const Stage& stage, const Start& start, double* value,
               double* slope, size_t first, size_t count) {
    sweep({lines, c, stage, start, value, slope, false, false}, first, count);
}

bool rod_step(const Lines& lines, const RodCoefficients& c, const Stage& stage, const Start& start, double* value,
              double* slope, bool keep, size_t first, size_t count) {
    return sweep({lines, c, stage, start, value, slope, true, keep}, first, count);
}

} // namespace CD_ISA
} // namespace cd
