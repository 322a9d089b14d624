// One implicit stage of a bundle of lines with springs and bend: the two filters of solve/rod_line.hh.
#pragma once

#include "kernel/lines.hh"

namespace cd {

struct RodCoefficients {
    const double *keep, *close, *turn;    // what the difference into node i is blended from
    const double *lever, *follow;         // and the value there
    const double *lean, *bend;            // going back: difference into node i from its value, and from the next one
    const double* closing;               // 1 for each spring, 0 for a weld; null: 1 for all
    const double* has_bend;               // 1 at nodes with a bend term, else 0
    NodeGains gains;
    double of_change;                     // 1: solve for the change w - v; 0: for w itself. See below
    const unsigned char* pin;             // cd_node: what is held keeps its velocity
};

// As spring_sweep, but leaves the answer in `value` and moves nothing. The answer is w or, with of_change, w - v. Going
// back, each node's value comes from its neighbour's and their difference, so an error travels on: soft lines, which
// should hardly change at all, are better solved for the change; stiff ones for w, of which v + change would lose the
// part that moves anything. value, slope: scratch like the positions.
template <class T>
void rod_sweep(const Lines<T>& lines, const RodCoefficients& c, const Stage& stage, double* value,
               double* slope, size_t first, size_t count);

} // namespace cd
