#include "kernel/advance.hh"

#include "kernel/line_lanes.hh"

namespace cd {
namespace CD_NARROWER {
decltype(CD_ISA::advance) advance;
} // namespace CD_NARROWER
namespace CD_ISA {

namespace {

struct Mover {
    const Lines& lines;
    const Stage& stage;
    const Start& start;
    const RingClosure& ring;
    double *answer, *keep;
    bool finite = true;

    template <int N> StateLanes<N> state(size_t at) const { return load_start<N>(lines, start, at); }

    template <int N> void find_forces(size_t first, Lanes<N>* out) const {
        const size_t z = lines.nodes - 1, nodes[4] = {z - 1, z, 0, 1};
        Lanes<N> x[4], w[4];
        for (int k = 0; k < 4; ++k) {
            const size_t at = nodes[k] * lines.pitch + first;
            const StateLanes<N> here = state<N>(at);
            x[k] = here.x;
            w[k] = Lanes<N>::load(answer + at) + stage.of_change * here.v;
        }
        ring_forces<N>(ring, stage, x, w, out);
    }

    template <int N> void bundle(size_t first) {
        using L = Lanes<N>;
        L force[3] = {}, probe{};
        if (ring.constraints > 0) find_forces<N>(first, force);
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

bool advance(const Lines& lines, const Stage& stage, const Start& start, const RingClosure& ring, double* answer,
             bool keep, size_t first, size_t count) {
    Mover bundles{lines, stage, start, ring, answer, keep ? answer : nullptr};
    for_each_bundle(first, count, bundles, [&](size_t line, size_t left) {
        return CD_NARROWER::advance(lines, stage, start, ring, answer, keep, line, left);
    });
    return bundles.finite;
}

} // namespace CD_ISA
} // namespace cd
