#include "kernel/advance.hh"

#include "kernel/line_lanes.hh"

namespace cd {
namespace CD_ISA {

namespace {

template <class T> struct Mover {
    const Lines<T>& lines;
    const Stage& stage;
    const Start& start;
    const RingClosure& ring;
    double *answer, *keep;
    bool finite = true;

    template <int N> StateLanes<N> state(size_t at) const { return load_start<N>(lines, start, at); }

    // By how much the open line's w misses the wish of each closing constraint.
    template <int N> void misses(size_t first, Lanes<N>* out) const {
        using L = Lanes<N>;
        const auto turn = [](L a, L b, L c) { return (b - a) - (c - b); };
        const size_t z = lines.nodes - 1, nodes[4] = {z - 1, z, 0, 1};
        L x[4], w[4];
        for (int k = 0; k < 4; ++k) {
            const size_t at = nodes[k] * lines.pitch + first;
            const StateLanes<N> here = state<N>(at);
            x[k] = here.x;
            w[k] = L::load(answer + at) + stage.of_change * here.v;
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
            L closed = L::load(answer + at);
            for (int r = 0; r < ring.constraints; ++r) closed = closed + ring.response[r][i] * force[r];
            end_stage<N>(lines, stage, state<N>(at), closed, keep, at, probe);
        }
        finite &= !probe.any_nan();
    }
};

} // namespace

template <class T> bool advance(const Lines<T>& lines, const Stage& stage, const Start& start, const RingClosure& ring,
                                double* answer, bool keep, size_t first, size_t count) {
    Mover<T> bundles{lines, stage, start, ring, answer, keep ? answer : nullptr};
    for_each_bundle(first, count, bundles);
    return bundles.finite;
}

#if CD_WITH_FLOAT32
template bool advance(const Lines<float>&, const Stage&, const Start&, const RingClosure&, double*, bool, size_t,
                      size_t);
#endif
#if CD_WITH_FLOAT64 || CD_WITH_MEMBRANE // a membrane's planes are double
template bool advance(const Lines<double>&, const Stage&, const Start&, const RingClosure&, double*, bool, size_t,
                      size_t);
#endif

} // namespace CD_ISA
} // namespace cd
