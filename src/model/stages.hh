// The stages that a step of a chain or membrane consists of. Every implicit method is one or two stages of one form;
// with h the stage's share of dt and C = drag M + Z + damping K (model.md, 4, 8 and 9),
//
//      (M + h C + h^2 K) w = M v + h [f + M g - K x],     v = w + overshoot (w - v_old),     x += move w
//
//   lambda   h = lambda dt: w = v + lambda dv, overshoot 1 / lambda - 1, move dt (model.md, 10 and 11)
//   stiff    h = gamma dt, gamma = 1 - 1/sqrt(2): a backward Euler step of h carried on to 1 + sqrt(2) times its
//            length, then another. SDIRK2 written so: with the state Y_1 after the first stage, the second starts from
//            Y + (1 - gamma) / gamma (Y_1 - Y), and (1 - gamma) / gamma = 1 + sqrt(2).
//
// Z holds matched ends and attachments. lambda = 0 is forward Euler, and so, to every digit, is a lambda below 1e-100.
#pragma once

#include "model/body.hh"

namespace cd {

constexpr double kSqrt2 = 1.4142135623730951;

inline bool steps_explicitly(cd_method method, double lambda) {
    return is_explicit(method) || (method == CD_METHOD_IMPLICIT && lambda < 1e-100);
}
inline bool steps_explicitly(const Body& b) { return steps_explicitly(b.method, b.lambda); }

// h; of an explicit step dt itself.
inline double stage_share(const Body& b, double dt) {
    return steps_explicitly(b) ? dt : b.method == CD_METHOD_STIFF_SECOND ? (1 - kSqrt2 / 2) * dt : b.lambda * dt;
}

struct StageMoves {
    int count;
    double overshoot[2], move[2];

    StageMoves(const Body& b, double dt) {
        const bool two = b.method == CD_METHOD_STIFF_SECOND;
        const double h = stage_share(b, dt);
        count = two ? 2 : 1;
        overshoot[0] = two ? kSqrt2 : 1 / b.lambda - 1, overshoot[1] = 0;
        move[0] = two ? (1 + kSqrt2) * h : dt, move[1] = two ? h : 0;
    }
};

} // namespace cd
