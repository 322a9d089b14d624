// What the sweeps along lines share: a line is one component of one strand, `nodes` numbers `pitch` apart, with its
// neighbours side by side in memory. Steps reach the sweeps as stages of one form (model/chain_step.cpp).
#pragma once

#include "kernel/lanes.hh"

namespace cd {

// Numbers smaller than this are put to 0 where they leave a sweep, and every 16th node inside one, so that a scene that
// decays never reaches the subnormal numbers, on which processors are up to 150 times slower.
template <class T> struct Rest;
template <> struct Rest<float> {
    static constexpr float least = 0x1p-80f; // 8e-25
};
template <> struct Rest<double> {
    static constexpr double least = 0x1p-500; // 3e-151
};
constexpr size_t kSettleEvery = 16;

// The lines of an object. force and target are null where there are none.
template <class T> struct Lines {
    size_t nodes, pitch, components;
    T *position, *velocity;
    const T *force, *target;
};

// One implicit stage. It solves for w, the velocity that moves the positions,
//     (M (1 + h drag) + h (h + damping) K) w = M v + h [f + M g - K x],     then    v = w + overshoot (w - v_old),
//     x += move w.
// The whole velocity is solved for, not its change: of a stiff spring's velocity only a small part moves anything, and
// as the sum of v and a change it would be lost in their rounding.
template <class T> struct Stage {
    T closing_rate; // 1 / (h + damping) [1/s]: how fast a spring wants to close
    T overshoot;
    T move;       // [s]
    T gravity[4]; // h g [m/s]
};

// What acts on a node from outside, as gains; null where nothing of the kind does. Held nodes have gain 0.
template <class T> struct NodeGains {
    const T* gravity; // of h g
    const T* force;   // of the force [s/kg]
    const T* drag;    // of the velocity
    const T* attach;  // of the distance from the target [1/s]
};

// h g of each lane of the bundle that starts at a line.
template <int N, class T, class S> Lanes<S, N> lane_gravity(const Lines<T>& lines, const S* gravity, size_t first) {
    S g[N];
    for (int j = 0; j < N; ++j) g[j] = gravity[(first + size_t(j)) % lines.components];
    return Lanes<S, N>::load(g);
}

// What acts on node i from outside. `at` is the place of the bundle's numbers at that node.
template <int N, class T, class S>
inline Lanes<S, N> outside(const Lines<T>& lines, const NodeGains<S>& gains, size_t i, size_t at, Lanes<S, N> gravity,
                           Lanes<S, N> x, Lanes<S, N> v) {
    Lanes<S, N> sum = gains.gravity[i] * gravity;
    if (gains.force) sum = sum + gains.force[i] * Lanes<S, N>::load(lines.force + at);
    if (gains.drag) sum = sum - gains.drag[i] * v;
    if (gains.attach) sum = sum - gains.attach[i] * (x - Lanes<S, N>::load(lines.target + at));
    return sum;
}

} // namespace cd
