// Moves a bundle of lines by what rod_sweep left behind, and closes rings.
#pragma once

#include "kernel/lanes.hh"
#include "kernel/lines.hh"

namespace cd {

// A ring is an open line and the constraints that close it (solve/ring_closure.hh): the spring from the last node to
// the first and, with bend, the bend terms at the last node and the first. The open line's w misses the wish of
// constraint r by some velocity; w += sum over r of response[r] force[r], force = inverse miss.
struct RingClosure {
    int constraints = 0; // 0: an open line; 1; 3 with bend
    const double* response[3] = {};
    double compliance[3][3] = {}; // C: what the constraints yield to their forces
    double inverse[3][3] = {};    // of C; rows and columns of what is absent or cut are 0
    double closing_rate = 0;      // of the closing spring: the stage's, or 0 for a weld
};

constexpr int kClosureRefinements = 2; // of the closing forces in a step

namespace CD_ISA {

// The constraints' forces f of C f = miss, given the positions of nodes n - 2, n - 1, 0 and 1 and the open line's w
// there. A piece of the line that is free to turn makes C as ill-conditioned as the step is long, so f is refined.
template <int N> inline void ring_forces(const RingClosure& ring, const Stage& stage, const Lanes<N>* x,
                                         const Lanes<N>* w, Lanes<N>* out) {
    using L = Lanes<N>;
    const auto turn = [](L a, L b, L c) { return (b - a) - (c - b); };
    L miss[3] = {ring.closing_rate * (x[1] - x[2]) + (w[1] - w[2])};
    for (int k = 1; k < ring.constraints; ++k)
        miss[k] = stage.closing_rate * turn(x[k - 1], x[k], x[k + 1]) + turn(w[k - 1], w[k], w[k + 1]);
    for (int r = 0; r < ring.constraints; ++r) out[r] = L{};
    for (int pass = 0; pass <= kClosureRefinements; ++pass) {
        L rest[3];
#pragma GCC unroll 1
        for (int r = 0; r < ring.constraints; ++r) {
            rest[r] = miss[r];
            for (int s = 0; s < ring.constraints; ++s) rest[r] = rest[r] - ring.compliance[r][s] * out[s];
        }
#pragma GCC unroll 1
        for (int r = 0; r < ring.constraints; ++r)
            for (int s = 0; s < ring.constraints; ++s) out[r] = out[r] + ring.inverse[r][s] * rest[s];
    }
}

// answer: what rod_sweep left, from the same start. With `keep`, leaves w there instead of moving. False if a number
// left the finite range.
bool advance(const Lines& lines, const Stage& stage, const Start& start, const RingClosure& ring, double* answer,
             bool keep, size_t first, size_t count);

} // namespace CD_ISA
} // namespace cd
