// Series-spring elimination: factors the system of a line of masses and springs.
//
//      ground     ground     ground          (D + L) w = b + what the springs wish
//       d_0        d_1        d_2
//        |          |          |             D: d_i >= 0 grounds node i (its mass, drag, ...; infinite: held)
//        o---s_0----o---s_1----o             L: s_i >= 0 joins node i to node i + 1 (0: cut; infinite: welded)
//
// The energy to minimise is 1/2 sum d_i (w_i - own_i)^2 + 1/2 sum s_i (w_{i+1} - w_i - e_i)^2. All that hangs on the
// left of node i acts on it like one spring r to ground: eliminating node i puts s_i in series with it,
//      g = r_i s_i / (r_i + s_i)         r_{i+1} = d_{i+1} + g,
// and that spring's rest position is y_i + e_i. So going right, node i + 1 settles between it and its own wish,
//      y_{i+1} = carry (y_i + e_i) + (1 - carry) own_{i+1},      carry = g / (d_{i+1} + g),
// and going left, node i settles between its left side and its right neighbour,
//      w_i = y_i + pull (w_{i+1} - e_i - y_i),           pull = s_i / (r_i + s_i).
// Nothing is subtracted, and the diagonal d_i + s_{i-1} + s_i, in which stiff springs drown the masses, is never
// formed. The springs' own forces enter as the wishes e_i and never as numbers of size s_i x_i, so that the right side
// keeps its digits too. Any carry and pull in [0, 1], rounded as they may be, are the exact elimination of some line of
// masses and springs: an undamped step with rounded coefficients conserves the energy of that line and has no trend.
// (model.md, 12 to 15. Both filters are Kass's of 1997, eq. 31.)
#pragma once

#include <stddef.h>

#include "solve/series.hh"

namespace cd {

// System: double ground(i), spring(i); bool repeats(i): whether node i > 0 and its spring are as those before, as far
// as that is known. Place: where in the rows node i's numbers go, asked of all nodes in turn. Gains: void operator()(i, r,
// place, repeated) is told what grounds node i in all, and whether all that is known of it is as of the node before.
template <class System, class Place, class Gains>
void factor_spring_line(size_t nodes, const System& system, Place place, double* carry, double* pull, Gains gains) {
    // The spring to ground that all nodes on the left of the next one amount to, of this one, and what follows from it.
    // Along a uniform part of a line it soon is the same from node to node.
    double next = 0, hanging = 0, ground = 0, spring = 0, grounded = 0, carry_and_pull[2] = {};
    for (size_t i = 0; i < nodes; ++i) {
        const size_t at = place(i);
        const bool alike = i > 0 && system.repeats(i), repeated = alike && next == hanging;
        hanging = next;
        if (!alike) ground = system.ground(i), spring = i + 1 < nodes ? system.spring(i) : 0;
        if (!repeated) {
            grounded = ground + hanging;
            beside(hanging, ground, spring, grounded).fraction().store(carry_and_pull);
            next = series(grounded, spring);
        }
        carry[at] = carry_and_pull[0];
        gains(i, grounded, at, repeated);
        if (i + 1 < nodes) pull[at] = carry_and_pull[1];
    }
}

// Of rows in the nodes' order, of whose gains nobody asks.
template <class System> void factor_spring_line(size_t nodes, const System& system, double* carry, double* pull) {
    factor_spring_line(
        nodes, system, [](size_t i) { return i; }, carry, pull, [](size_t, double, size_t, bool) {});
}

} // namespace cd
