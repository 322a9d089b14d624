// One implicit stage of a bundle of lines with springs and bend: the two filters of solve/rod_line.hh.
#pragma once

#include "kernel/lines.hh"

namespace cd {

struct RodCoefficients {
    const double *stretch, *stretch_lift; // spring i - 1 into difference and value at node i
    const double *ground, *ground_lift;   // what acts on node i into difference and value
    const double *lean, *bend;            // going back: difference into node i from its value, and from the next one
    const double* closing;               // 1 for each spring, 0 for a weld; null: 1 for all
    const double* has_bend;               // 1 at nodes with a bend term, else 0
    NodeGains gains;              // at a held node 0
    const unsigned char* pin;             // cd_node: what is held keeps its velocity
};

// As spring_sweep, but leaves w in `value` and moves nothing. value, slope: scratch like the positions.
template <class T>
void rod_sweep(const Lines<T>& lines, const RodCoefficients& c, const Stage& stage, double* value,
               double* slope, size_t first, size_t count);

} // namespace cd
