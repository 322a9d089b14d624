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

// Solves from `start`, leaves the answer in `value` and moves nothing. slope: scratch. Both are laid out like the
// positions, and neither is that of start.
template <class T> void rod_sweep(const Lines<T>& lines, const RodCoefficients& c, const Stage& stage,
                                  const Start& start, double* value, double* slope, size_t first, size_t count);

} // namespace CD_ISA
} // namespace cd
