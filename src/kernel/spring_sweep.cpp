#include "kernel/spring_sweep.hh"

namespace cd {

namespace {

// e_i, the difference delta_{i+1} - delta_i at which spring i would be closed after the stage.
template <class L, class T> inline L wish(L x, L v, L x_next, L v_next, T rate) {
    return rate * (x - x_next) + (v - v_next);
}

// y_i: what node i and all that hangs on its left would do without the rest.
//     y_i = carry_i (y_{i-1} + e_{i-1}) + what acts on it from outside
template <class T, int N, bool kPlain>
void forward(const Lines<T>& lines, const SpringCoefficients<T>& c, const Stage<T>& stage, T* y, size_t first) {
    using L = Lanes<T, N>;
    const L gravity = lane_gravity<N>(lines, stage.gravity, first);
    L x_last{}, v_last{}, sum{};
    for (size_t i = 0; i < lines.nodes; ++i) {
        const size_t at = i * lines.pitch + first;
        const L x = L::load(lines.position + at), v = L::load(lines.velocity + at);
        const L own = kPlain ? c.gains.gravity[i] * gravity : outside<N>(lines, c.gains, i, at, gravity, x, v);
        if (i == 0) {
            sum = own;
        } else {
            const T rate = kPlain || !c.closing_rate ? stage.closing_rate : c.closing_rate[i - 1];
            sum = c.carry[i] * (sum + wish(x_last, v_last, x, v, rate)) + own;
        }
        if (i % kSettleEvery == 0) sum = settled(sum, Rest<T>::least);
        sum.store(y + at);
        x_last = x;
        v_last = v;
    }
}

// delta_i = y_i + pull_i (delta_{i+1} - e_i - y_i), and the node moves.
template <class T, int N, bool kPlain>
bool backward(const Lines<T>& lines, const SpringCoefficients<T>& c, const Stage<T>& stage, const T* y, size_t first) {
    using L = Lanes<T, N>;
    L x_next{}, v_next{}, delta{}, finite{};
    for (size_t i = lines.nodes; i-- > 0;) {
        const size_t at = i * lines.pitch + first;
        const L x = L::load(lines.position + at), v = L::load(lines.velocity + at), sum = L::load(y + at);
        if (i + 1 == lines.nodes) {
            delta = sum;
        } else {
            const T rate = kPlain || !c.closing_rate ? stage.closing_rate : c.closing_rate[i];
            delta = sum + c.pull[i] * (delta - wish(x, v, x_next, v_next, rate) - sum);
        }
        if (i % kSettleEvery == 0) delta = settled(delta, Rest<T>::least);
        x_next = x;
        v_next = v;
        const L v_new = settled(v + stage.velocity_gain * delta, Rest<T>::least);
        const L x_new = settled(x + stage.position_gain * (v + delta), Rest<T>::least);
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
    const bool plain = !c.gains.force && !c.gains.drag && !c.gains.attach && !c.closing_rate;
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
