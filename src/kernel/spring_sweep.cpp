#include "kernel/spring_sweep.hh"

namespace cd {

namespace {

// y_i: what node i and all that hangs on its left would do without the rest; e_i: the difference w_{i+1} - w_i at which
// spring i would be closed after the stage.
//     y_i = between v_i and y_{i-1} + e_{i-1} at carry_i, and what acts on it from outside
template <class T, int N, bool kPlain>
void forward(const Lines<T>& lines, const SpringCoefficients<T>& c, const Stage<T>& stage, T* y, size_t first) {
    using L = Lanes<T, N>;
    const L gravity = lane_gravity<N>(lines, stage.gravity, first);
    L x_last{}, sum{};
    for (size_t i = 0; i < lines.nodes; ++i) {
        const size_t at = i * lines.pitch + first;
        const L x = L::load(lines.position + at), v = L::load(lines.velocity + at);
        const L own = kPlain ? c.gains.gravity[i] * gravity : outside<N>(lines, c.gains, i, at, gravity, x, v);
        if (i == 0) {
            sum = v + own;
        } else {
            const T rate = kPlain || !c.closing ? stage.closing_rate : c.closing[i - 1] * stage.closing_rate;
            sum = between(v, sum + rate * (x_last - x), c.carry[i]) + own;
        }
        if (i % kSettleEvery == 0) sum = settled(sum, Rest<T>::least);
        sum.store(y + at);
        x_last = x;
    }
}

// w_i = between y_i and w_{i+1} - e_i at pull_i, and the node moves.
template <class T, int N, bool kPlain>
bool backward(const Lines<T>& lines, const SpringCoefficients<T>& c, const Stage<T>& stage, const T* y, size_t first) {
    using L = Lanes<T, N>;
    L x_next{}, w{}, finite{};
    for (size_t i = lines.nodes; i-- > 0;) {
        const size_t at = i * lines.pitch + first;
        const L x = L::load(lines.position + at), v = L::load(lines.velocity + at), sum = L::load(y + at);
        if (i + 1 == lines.nodes) {
            w = sum;
        } else {
            const T rate = kPlain || !c.closing ? stage.closing_rate : c.closing[i] * stage.closing_rate;
            w = between(sum, w - rate * (x - x_next), c.pull[i]);
        }
        if (i % kSettleEvery == 0) w = settled(w, Rest<T>::least);
        x_next = x;
        const L v_new = settled(w + stage.overshoot * (w - v), Rest<T>::least);
        const L x_new = settled(x + stage.move * w, Rest<T>::least);
        v_new.store(lines.velocity + at);
        x_new.store(lines.position + at);
        finite = finite + T(0) * (x_new + v_new);
    }
    return !finite.any_nan();
}

template <class T, bool kPlain> struct Sweep {
    const Lines<T>& lines;
    const SpringCoefficients<T>& c;
    const Stage<T>& stage;
    T* y;
    bool finite = true;

    template <int N> void bundle(size_t first) {
        forward<T, N, kPlain>(lines, c, stage, y, first);
        finite &= backward<T, N, kPlain>(lines, c, stage, y, first);
    }
};

template <class T, bool kPlain>
bool sweep(const Lines<T>& lines, const SpringCoefficients<T>& c, const Stage<T>& stage, T* y, size_t first,
           size_t count) {
    Sweep<T, kPlain> bundles{lines, c, stage, y};
    for_each_bundle<T>(first, count, bundles);
    return bundles.finite;
}

} // namespace

template <class T>
bool spring_sweep(const Lines<T>& lines, const SpringCoefficients<T>& c, const Stage<T>& stage, T* y, size_t first,
                  size_t count) {
    const bool plain = !c.gains.force && !c.gains.drag && !c.gains.attach && !c.closing;
    return plain ? sweep<T, true>(lines, c, stage, y, first, count) : sweep<T, false>(lines, c, stage, y, first, count);
}

#if CD_WITH_FLOAT32
template bool spring_sweep(const Lines<float>&, const SpringCoefficients<float>&, const Stage<float>&, float*,
                           size_t, size_t);
#endif
#if CD_WITH_FLOAT64
template bool spring_sweep(const Lines<double>&, const SpringCoefficients<double>&, const Stage<double>&, double*,
                           size_t, size_t);
#endif

} // namespace cd
