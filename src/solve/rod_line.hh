// Elimination for a line with springs and bend, without a subtraction: series springs for two unknowns at a time.
//
// The unknowns of the part already eliminated are the value u = w_i at its last node and the difference
// d = w_i - w_{i-1} into it. Its energy is kept as a sum of squares,
//      V(u, d) = 1/2 A (u - u^ - q (d - d^))^2 + 1/2 T (d - d^)^2,        A, q, T >= 0:
// a mass A on a lever of length q and a spring T that holds the lever. (u^, d^) is where it rests. A new node is reached
// in four moves, each of which keeps the form and the signs:
//   bend b at node i  the lever's end is joined to the next difference d' by b. Eliminating d, three springs meet in it
//                     (A q^2 to the value, T to rest, b to d'): with P = A q^2 + T + b
//                         A <- A (T + b) / P,  q <- q b / (T + b),  T <- T b / (T + b),  d^ <- d^ + e_bend,
//                     and, going back,  d = d^ + lean (u - u^) + bend (d' - e_bend - d^),  lean = A q / P, bend = b / P.
//   step right        u' = u + d':  q <- q + 1,  u^ <- u^ + d^.
//   spring s          acts on d alone:  T <- T + s;  d^ moves by s / T towards the spring's wish, u^ by q times as much.
//   ground m at u     A' = A + m,  q' = q A / A',  T' = T + q^2 A m / A'. Towards the node's own wish
//                     d^ moves by ground = q (A m / A') / T', u^ by q' ground + m / A'.
// A pentadiagonal LDL^T subtracts, and loses a free rod's mass once b exceeds it by 1e16 (this library's tests show it);
// here stiffness may be anything, infinity included (s = infinity: a weld; m = infinity: a held node).
#pragma once

#include <stddef.h>

#include "solve/series.hh"

namespace cd {

struct RodRows { // what the sweeps need, one number per node each
    double *stretch, *stretch_lift, *ground, *ground_lift, *lean, *bend;
};

// System: double ground(i), spring(i), bend(i).
template <class System> void factor_rod_line(size_t nodes, const System& system, const RodRows& out) {
    double mass = system.ground(0), lever = 0, hold = 0; // A, q, T
    for (size_t i = 1; i < nodes; ++i) {
        if (i > 1) {
            const double b = system.bend(i - 1), held = hold + b;
            const double on_lever = lever > 0 ? mass * lever * lever : 0;
            out.bend[i - 1] = share(b, hold + on_lever);
            out.lean[i - 1] = lever > 0 ? share(on_lever, held) / lever : 0;
            mass = lever > 0 ? series(mass, held / (lever * lever)) : mass;
            lever *= share(b, hold);
            hold = series(hold, b);
        }
        lever += 1;
        const double s = system.spring(i - 1);
        out.stretch[i] = share(s, hold);
        out.stretch_lift[i] = lever * out.stretch[i];
        hold += s;
        const double m = system.ground(i), between = series(mass, m);
        const double turning = lever * lever * between; // what the node adds to the hold on the lever
        const double longer = lever;
        lever *= share(mass, m);
        out.ground[i] = share(turning, hold) / longer;
        out.ground_lift[i] = lever * out.ground[i] + (m - m == 0 ? share(m, mass) : 1);
        mass += m;
        hold += turning;
    }
}

} // namespace cd
