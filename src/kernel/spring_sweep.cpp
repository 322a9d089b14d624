#include "kernel/spring_sweep.hh"

namespace cd {

namespace {

// kPlain: nothing acts but springs and gravity.
template <class T, bool kPlain> struct Sweep {
    const Lines<T>& lines;
    const SpringCoefficients& c;
    const Stage& stage;
    double* y;
    bool finite = true;

    double rate(size_t spring) const {
        return kPlain || !c.closing ? stage.closing_rate : c.closing[spring] * stage.closing_rate;
    }

    // y_i: what node i and all that hangs on its left would do without the rest; e_i: the difference w_{i+1} - w_i at
    // which spring i would be closed after the stage.
    //     y_i = between v_i and y_{i-1} + e_{i-1} at carry_i, and what acts on it from outside
    template <int N> void forward(size_t first) const {
        using L = Lanes<N>;
        const L gravity = lane_gravity<N>(lines, stage.gravity, first);
        L x_last{}, sum{};
        for (size_t i = 0; i < lines.nodes; ++i) {
            const size_t at = i * lines.pitch + first;
            const L x = L::load(lines.position + at), v = L::load(lines.velocity + at);
            const L own = kPlain ? c.gains.gravity[i] * gravity : outside<N>(lines, c.gains, i, at, gravity, x, v);
            sum = i == 0 ? v + own : between(v, sum, rate(i - 1) * (x_last - x), c.carry[i], own);
            if (i % kSettleEvery == 0) sum = settled(sum, Rest<double>::least);
            sum.store(y + at);
            x_last = x;
        }
    }

    // w_i = between y_i and w_{i+1} - e_i at pull_i, and the node moves.
    template <int N> void backward(size_t first) {
        using L = Lanes<N>;
        L x_next{}, w{}, probe{};
        for (size_t i = lines.nodes; i-- > 0;) {
            const size_t at = i * lines.pitch + first;
            const L x = L::load(lines.position + at), v = L::load(lines.velocity + at), sum = L::load(y + at);
            w = i + 1 == lines.nodes ? sum : between(sum, w, rate(i) * (x_next - x), c.pull[i]);
            if (i % kSettleEvery == 0) w = settled(w, Rest<double>::least);
            x_next = x;
            store_settled(w + stage.overshoot * (w - v), lines.velocity + at, probe);
            store_settled(x + stage.move * w, lines.position + at, probe);
        }
        finite &= !probe.any_nan();
    }

    template <int N> void bundle(size_t first) {
        forward<N>(first);
        backward<N>(first);
    }
};

template <class T, bool kPlain>
bool sweep(const Lines<T>& lines, const SpringCoefficients& c, const Stage& stage, double* y, size_t first, size_t count) {
    Sweep<T, kPlain> bundles{lines, c, stage, y};
    for_each_bundle(first, count, bundles);
    return bundles.finite;
}

} // namespace

template <class T>
bool spring_sweep(const Lines<T>& lines, const SpringCoefficients& c, const Stage& stage, double* y, size_t first,
                  size_t count) {
    const bool plain = !c.gains.force && !c.gains.drag && !c.gains.attach && !c.closing;
    return plain ? sweep<T, true>(lines, c, stage, y, first, count) : sweep<T, false>(lines, c, stage, y, first, count);
}

#if CD_WITH_FLOAT32
template bool spring_sweep(const Lines<float>&, const SpringCoefficients&, const Stage&, double*, size_t, size_t);
#endif
#if CD_WITH_FLOAT64
template bool spring_sweep(const Lines<double>&, const SpringCoefficients&, const Stage&, double*, size_t, size_t);
#endif

} // namespace cd
