// Elimination for a line with springs and bend, without a subtraction: series springs for two unknowns at a time.
//
// The unknowns of the part already eliminated are the value u = w_i at its last node and the difference
// d = w_i - w_{i-1} into it. Its energy is kept as a sum of squares (model.md, 18),
//      V(u, d) = 1/2 A (u - u^ - q (d - d^))^2 + 1/2 T (d - d^)^2,        A, q, T >= 0:
// a mass A on a lever of length q and a spring T that holds the lever. (u^, d^) is where it rests. A new node is
// reached in three moves, each of which keeps the form and the signs:
//
// Bend b at node i. The lever's end is joined to the next difference d' by b. Eliminating d, three springs meet in it,
// A q^2 to the value, T to rest and b to d'. With P = A q^2 + T + b
//      A <- A (T + b) / P,   q <- q b / (T + b),   T <- T b / (T + b),   t = d^ + e_bend,
// and, going back,  d = d^ + lean (u - u^) + bend (d' - e_bend - d^)  with  lean = A q / P,  bend = b / P.
//
// Step right. u' = u + d' makes the lever longer: q <- q + 1.
//
// Spring s and ground m. s acts on the difference alone, m on the value. Three things want the difference: the hold T
// wants t, the spring its own wish e, and the masses, with R = q^2 A m / (A + m), the difference at which both rest,
// (own - u^) / q + t (q - 1) / q. So
//      d^ <- keep t + close e + turn (own - u^), a blend by T : s : R,
//      u^ <- between own and u^ + d^ + (q - 1) (d^ - t) at A / (A + m),
//      T <- T + s + R,   q <- q A / (A + m),   A <- A + m.
//
// Every number is a blend of numbers of its own size: in a soft line, where wishes are large and answers small, nothing
// large is put in and taken out again. A pentadiagonal LDL^T subtracts, and loses a free rod's mass once b exceeds it
// by 1e16; here stiffness may be anything, infinity included (s = infinity: a weld; m = infinity: a held node).
#pragma once

#include <stddef.h>

#include "solve/series.hh"

namespace cd {

struct RodRows {                 // what the sweeps need, one number per node each
    double *keep, *close, *turn; // weights of the difference into a node
    double *lever, *follow;      // q - 1, and the fraction for between()
    double *lean, *bend;         // going back
};

// Where node i's numbers lie in the rows.
struct InOrder {
    size_t operator()(size_t i) const { return i; }
};

// System: double ground(i), spring(i), bend(i); bool repeats(i): whether node i > 0, its spring and its bend are as
// those before, as far as that is known. Place: size_t operator()(i).
template <class System, class Place = InOrder>
void factor_rod_line(size_t nodes, const System& system, const RodRows& out, Place place = {}) {
    double mass = system.ground(0), lever = 0, hold = 0; // A, q, T
    // Along a uniform part of a line they soon are the same from node to node, and all else with them.
    double mass_before = 0, lever_before = 0, hold_before = 0;
    double bend = 0, lean = 0, reached = 0, keep = 0, close = 0, turned = 0, follow = 0;
    double next_mass = mass, next_lever = 0, next_hold = 0;
    double b = 0, s = 0, m = mass;
    bool alike = false;
    size_t at = place(0);
    for (size_t i = 1; i < nodes; ++i) {
        mass_before = mass, lever_before = lever, hold_before = hold;
        mass = next_mass, lever = next_lever, hold = next_hold;
        const bool same = mass == mass_before && lever == lever_before && hold == hold_before;
        const bool before_alike = alike;
        alike = system.repeats(i);
        if (!before_alike || i == 2) b = i > 1 ? system.bend(i - 1) : 0;
        if (!before_alike) s = system.spring(i - 1);
        if (!alike) m = system.ground(i);
        if (!(same && i > 2 && before_alike && alike)) {
            double a = mass, q = lever, t = hold;
            if (i > 1) {
                const double held = t + b;
                const double on_lever = q > 0 ? a * q * q : 0;
                double part[2];
                beside(b, t + on_lever, on_lever, held).share().store(part);
                bend = part[0];
                lean = q > 0 ? part[1] / q : 0;
                a = q > 0 ? series(a, held / (q * q)) : a;
                const ShareAndSeries joined = share_and_series(b, t);
                q *= joined.share, t = joined.series;
            }
            const double longer = q + 1;
            const ShareAndSeries grounded = share_and_series(a, m);
            const double turning = longer * longer * grounded.series;
            double part[2];
            beside(turning, t + s, a <= m ? a : m, a <= m ? m : a).share().store(part);
            const double turn = part[0];
            follow = a <= m ? part[1] : -part[1];
            beside(t, s + turning, s, t + turning).share().store(part);
            reached = q;
            keep = part[0] + turn * q / longer;
            close = part[1];
            turned = turn / longer;
            next_hold = t + (s + turning);
            next_lever = longer * grounded.share;
            next_mass = a + m;
        }
        if (i > 1) out.bend[at] = bend, out.lean[at] = lean;
        at = place(i);
        out.lever[at] = reached, out.keep[at] = keep, out.close[at] = close, out.turn[at] = turned;
        out.follow[at] = follow;
    }
}

} // namespace cd
