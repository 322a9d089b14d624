#include "kernel/spring_sweep.hh"

#include "kernel/line_lanes.hh"

namespace cd {
namespace CD_NARROWER {
decltype(CD_ISA::spring_sweep) spring_sweep;
} // namespace CD_NARROWER
namespace CD_ISA {

namespace {

// kPlain: nothing acts but springs and gravity, and the stage is for w, from the state.
template <bool kPlain> struct Sweep {
    const Lines& lines;
    const SpringCoefficients& c;
    const Stage& stage;
    const Start& start;
    double* y;
    double* keep;
    bool finite = true;

    template <int N> StateLanes<N> state(size_t at) const { return load_start<N>(lines, kPlain ? Start{} : start, at); }

    // e_i: the difference of the answer at which spring i would be closed after the stage.
    template <int N> Lanes<N> wish(size_t i, const StateLanes<N>& left, const StateLanes<N>& right) const {
        if (kPlain) return stage.closing_rate * (left.x - right.x);
        const double rate = c.closing ? c.closing[i] * stage.closing_rate : stage.closing_rate;
        return rate * (left.x - right.x) + stage.of_change * (left.v - right.v);
    }

    // y_i: what node i and all that hangs on its left would do without the rest.
    //     y_i = between v_i and y_{i-1} + e_{i-1} at carry_i, and what acts on it from outside
    template <int N> void forward(size_t first, double* sums, size_t step) const {
        using L = Lanes<N>;
        const L gravity = lane_gravity<N>(lines, stage.gravity, first);
        StateLanes<N> left{};
        L sum{};
        for (size_t i = 0; i < lines.nodes; ++i) {
            const size_t at = i * lines.pitch + first;
            const StateLanes<N> here = state<N>(at);
            fetch_next_bundle<N>(lines, at);
            const L v = kPlain ? here.v : (1 - stage.of_change) * here.v;
            const L own =
                kPlain ? c.gains.gravity[i] * gravity : outside<N>(lines, c.gains, i, at, gravity, here.x, here.v);
            sum = i == 0 ? v + own : between(v, sum, wish<N>(i - 1, left, here), c.carry[i], own);
            if (i % kSettleEvery == 0) sum = settled(sum, Limits<double>::least);
            sum.store(sums + i * step);
            left = here;
        }
    }

    // The answer at node i: between y_i and its right neighbour's less e_i at pull_i. Then the node moves.
    template <int N> void backward(size_t first, const double* sums, size_t step) {
        using L = Lanes<N>;
        StateLanes<N> right{};
        L answer{}, probe{};
        for (size_t i = lines.nodes; i-- > 0;) {
            const size_t at = i * lines.pitch + first;
            const StateLanes<N> here = state<N>(at);
            const L sum = L::load(sums + i * step), none{};
            answer = i + 1 == lines.nodes ? sum : between(sum, answer, none - wish<N>(i, here, right), c.pull[i]);
            if (i % kSettleEvery == 0) answer = settled(answer, Limits<double>::least);
            right = here;
            end_stage<N>(lines, stage, here, answer, kPlain ? nullptr : keep, at, probe);
        }
        finite &= !probe.any_nan();
    }

    template <int N> void bundle(size_t first) {
        // Nothing else reads y of a plain stage: a bundle's lies in one piece.
        double* const sums = kPlain ? y + first * lines.nodes : y + first;
        const size_t step = kPlain ? N : lines.pitch;
        forward<N>(first, sums, step);
        backward<N>(first, sums, step);
    }
};

} // namespace

bool spring_sweep(const Lines& lines, const SpringCoefficients& c, const Stage& stage, const Start& start, double* y,
                  bool keep, size_t first, size_t count) {
    const auto narrower = [&](size_t line, size_t left) {
        return CD_NARROWER::spring_sweep(lines, c, stage, start, y, keep, line, left);
    };
    if (count < kFewest) return narrower(first, count);
    const bool plain =
        !c.gains.force && !c.gains.drag && !c.gains.attach && !c.closing && !start.w && !keep && stage.of_change == 0;
    if (plain) {
        Sweep<true> bundles{lines, c, stage, start, y, nullptr};
        for_each_bundle<kLinesAtOnce>(first, count, bundles, narrower);
        return bundles.finite;
    }
    Sweep<false> bundles{lines, c, stage, start, y, keep ? y : nullptr};
    for_each_bundle<kLinesAtOnce>(first, count, bundles, narrower);
    return bundles.finite;
}

} // namespace CD_ISA
} // namespace cd
