// What the sweeps along lines share: a line is one component of one strand, `nodes` numbers `pitch` apart, with its
// neighbours side by side in memory. Steps reach the sweeps as stages of one form (model/chain_step.cpp).
//
// T is what the state is stored in; sweeps compute in double. In float32 the sums along a line would lose what a stiff
// chain's mean motion is made of (measured: 2e-3 of the position after 1000 steps, against 1e-5), and every constant of
// a step, rounded the same way each time, would give its energy a trend (2% in 1e6 steps).
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

// One implicit stage, from a start (x, v). It solves for w, the velocity that moves the positions,
//     (M (1 + h drag) + h (h + damping) K) w = M v + h [f + M g - K x],     then    v <- w + overshoot (w - v),
//     x <- x + move w.
struct Stage {
    double closing_rate; // 1 / (h + damping) [1/s]: how fast a spring wants to close
    double overshoot;
    double move;       // [s]
    double gravity[4]; // h g [m/s]
    // What the sweeps solve for. 0: w; 1: its change w - v. Of a stiff spring's velocity only a small part moves anything,
    // which v + change would lose in rounding; where hardly anything changes, as in soft rods and with a lambda near 0,
    // w - v would lose the change.
    double of_change;
};

// Where a stage starts: at the state (w null), or where the stage before it, whose answer is w, leads. What lies between
// two stages is never rounded to the state's precision.
struct Start {
    const double* w;
    double overshoot, move;
};

template <int N> struct StateLanes {
    Lanes<N> x, v;
};
template <int N, class T> inline StateLanes<N> load_start(const Lines<T>& lines, const Start& start, size_t at) {
    using L = Lanes<N>;
    const L x = L::load(lines.position + at), v = L::load(lines.velocity + at);
    if (!start.w) return {x, v};
    const L w = L::load(start.w + at);
    return {x + start.move * w, w + start.overshoot * (w - v)};
}

// What acts on a node from outside, as gains per node; null where nothing of the kind does. Held nodes have gain 0.
struct NodeGains {
    const double* gravity; // of h g
    const double* force;   // of the force [s/kg]
    const double* drag;    // of the velocity
    const double* attach;  // of the distance from the target [1/s]
};

// h g of each lane of the bundle that starts at a line.
template <int N, class T> Lanes<N> lane_gravity(const Lines<T>& lines, const double* gravity, size_t first) {
    double g[N];
    for (int j = 0; j < N; ++j) g[j] = gravity[(first + size_t(j)) % lines.components];
    return Lanes<N>::load(g);
}

// What acts on node i from outside. `at` is the place of the bundle's numbers at that node.
template <int N, class T>
inline Lanes<N> outside(const Lines<T>& lines, const NodeGains& gains, size_t i, size_t at,
                                Lanes<N> gravity, Lanes<N> x, Lanes<N> v) {
    using L = Lanes<N>;
    L sum = gains.gravity[i] * gravity;
    if (gains.force) sum = sum + gains.force[i] * L::load(lines.force + at);
    if (gains.drag) sum = sum - gains.drag[i] * v;
    if (gains.attach) sum = sum - gains.attach[i] * (x - L::load(lines.target + at));
    return sum;
}

// Stores a number where it settles to 0 if it is too small for the state's precision, and adds to the probe what is NaN
// if it is too large for it.
template <class T, int N> inline void store_settled(Lanes<N> a, T* to, Lanes<N>& probe) {
    settled(a, double(Rest<T>::least)).store(to);
    probe = probe + 0.0 * Lanes<N>::load(to);
}

// Ends a stage for the node at `at`, given the sweep's answer: either keeps w for the stage that follows, or moves.
template <int N, class T>
inline void end_stage(const Lines<T>& lines, const Stage& stage, StateLanes<N> from, Lanes<N> answer, double* keep,
                      size_t at, Lanes<N>& probe) {
    const Lanes<N> w = answer + stage.of_change * from.v, change = answer - (1 - stage.of_change) * from.v;
    if (keep) {
        w.store(keep + at);
        return;
    }
    store_settled(w + stage.overshoot * change, lines.velocity + at, probe);
    store_settled(from.x + stage.move * w, lines.position + at, probe);
}

} // namespace cd
