// One implicit stage of a bundle of lines with springs and bend: the two filters of solve/rod_line.hh.
#pragma once

#include "kernel/lanes.hh"
#include "kernel/lines.hh"

namespace cd {

struct RodCoefficients {
    const double *keep, *close, *turn; // what the difference into node i is blended from
    const double *lever, *follow;      // and the value there
    const double *lean, *bend;         // going back: difference into node i from its value, and from the next one
    const double* closing;             // 1 for each spring, 0 for a weld; null: 1 for all
    const double* has_bend;            // 1 at nodes with a bend term, else 0
    NodeGains gains;
    const unsigned char* pin; // cd_node: what is held keeps its velocity
};

namespace CD_ISA {

// Going right, to node i: (u, d), where the value at node i - 1 and the difference into it rest, become those of node
// i. hold: the difference that the bend at node i - 1 wishes for; wish: the spring's; own: the node's own value.
template <class L, class Rows>
__attribute__((always_inline)) inline void rod_reach(const Rows& c, size_t i, L hold, L wish, L own, L& u, L& d) {
    d = c.keep[i] * hold + c.close[i] * wish + c.turn[i] * (own - u);
    u = between(own, u, d + c.lever[i] * (d - hold), c.follow[i]);
}

// Going left, at node i: the difference into it, given its answer, where (u, d) rested, and by how much the difference
// that the bend there takes over from the right exceeds d.
template <class L, class Rows>
__attribute__((always_inline)) inline L rod_leave(const Rows& c, size_t i, L answer, L u, L d, L excess) {
    return d + c.lean[i] * (answer - u) + c.bend[i] * excess;
}

// Solves from `start`, leaves the answer in `value` and moves nothing. slope: scratch. Both are laid out like the
// positions, and neither is that of start.
void rod_sweep(const Lines& lines, const RodCoefficients& c, const Stage& stage, const Start& start, double* value,
               double* slope, size_t first, size_t count);

// The same, and moves the lines; with `keep`, leaves w in `value` instead. False if a number left the finite range.
bool rod_step(const Lines& lines, const RodCoefficients& c, const Stage& stage, const Start& start, double* value,
              double* slope, bool keep, size_t first, size_t count);

} // namespace CD_ISA
} // namespace cd
