#include "kernel/advance.hh"

namespace cd {

namespace {

template <class T> struct Mover {
    const Lines<T>& lines;
    const Stage& stage;
    const RingClosure& ring;
    double of_change;
    const double* answer;
    bool finite = true;

    // By how much the open line's w misses the wish of each closing constraint.
    template <int N> void misses(size_t first, Lanes<N>* out) const {
        using L = Lanes<N>;
        const auto row = [&](const auto* data, size_t i) { return L::load(data + i * lines.pitch + first); };
        const auto turn = [](L a, L b, L c) { return (b - a) - (c - b); };
        const size_t z = lines.nodes - 1, nodes[4] = {z - 1, z, 0, 1};
        L x[4], w[4];
        for (int k = 0; k < 4; ++k) {
            x[k] = row(lines.position, nodes[k]);
            w[k] = row(answer, nodes[k]) + of_change * row(lines.velocity, nodes[k]);
        }
        out[0] = ring.closing_rate * (x[1] - x[2]) + (w[1] - w[2]);
        for (int k = 1; k < ring.constraints; ++k)
            out[k] = stage.closing_rate * turn(x[k - 1], x[k], x[k + 1]) + turn(w[k - 1], w[k], w[k + 1]);
    }

    template <int N> void bundle(size_t first) {
        using L = Lanes<N>;
        L miss[3] = {}, force[3] = {}, probe{};
        if (ring.constraints > 0) misses<N>(first, miss);
        for (int r = 0; r < ring.constraints; ++r)
            for (int s = 0; s < ring.constraints; ++s) force[r] = force[r] + ring.inverse[r][s] * miss[s];
        for (size_t i = 0; i < lines.nodes; ++i) {
            const size_t at = i * lines.pitch + first;
            const L x = L::load(lines.position + at), v = L::load(lines.velocity + at);
            L w = L::load(answer + at);
            for (int r = 0; r < ring.constraints; ++r) w = w + ring.response[r][i] * force[r];
            w = w + of_change * v;
            store_settled(w + stage.overshoot * (w - v), lines.velocity + at, probe);
            store_settled(x + stage.move * w, lines.position + at, probe);
        }
        finite &= !probe.any_nan();
    }
};

} // namespace

template <class T>
bool advance(const Lines<T>& lines, const Stage& stage, const RingClosure& ring, double of_change, const double* answer,
             size_t first, size_t count) {
    Mover<T> bundles{lines, stage, ring, of_change, answer};
    for_each_bundle(first, count, bundles);
    return bundles.finite;
}

#if CD_WITH_FLOAT32
template bool advance(const Lines<float>&, const Stage&, const RingClosure&, double, const double*, size_t,
                      size_t);
#endif
#if CD_WITH_FLOAT64
template bool advance(const Lines<double>&, const Stage&, const RingClosure&, double, const double*, size_t,
                      size_t);
#endif

} // namespace cd
