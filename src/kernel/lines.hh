// What the sweeps along lines share: a line is one component of one strand, `nodes` numbers `pitch` apart, with its
// neighbours side by side in memory. Steps reach the sweeps as stages of one form (model/stages.hh).
//
// Sweeps compute in double, whatever the state is stored in, but for explicit steps of uniform lattices, see
// plain_step.hh. In float32 the sums along a line would lose what a stiff chain's mean motion is made of (measured:
// 2e-3 of the position after 1000 steps, against 1e-5), and every constant of a step, rounded the same way each time,
// would give its energy a trend (2% in 1e6 steps).
#pragma once

#include <stddef.h>

namespace cd {

// Numbers smaller than this are put to 0 where they leave a sweep, and every 16th node inside one, so that a scene that
// decays never reaches the subnormal numbers, on which processors are up to 150 times slower. At the other end,
// to_overflow times a number is infinite exactly when the number rounds to infinity in T.
template <class T> struct Limits;
template <> struct Limits<float> {
    static constexpr float least = 0x1p-80f; // 8e-25
    static constexpr double to_overflow = 0x1.0000008p896;
};
template <> struct Limits<double> {
    static constexpr double least = 0x1p-500; // 3e-151
    static constexpr double to_overflow = 1;
};
constexpr size_t kSettleEvery = 16;

// The same of a precision that is known when the program runs.
struct StoredRange {
    double least, to_overflow, epsilon; // epsilon: from 1 to the next number
};

// Numbers of the state in either precision, for kernels that would be twice as large with a text for each.
struct StateNumbers {
    void* data; // null: there are none
    bool is_float64;

    // A precision that is left out takes no code, but that some numbers besides the state are double: a membrane's
    // planes, and what hulls press with.
    static constexpr bool kMayBeWide = CD_WITH_FLOAT64 || CD_WITH_MEMBRANE || CD_WITH_HULL;
    bool wide() const { return kMayBeWide && (!CD_WITH_FLOAT32 || is_float64); }
    explicit operator bool() const { return data != nullptr; }
    StateNumbers from(size_t at) const { return {static_cast<char*>(data) + at * number_size(), is_float64}; }
    size_t number_size() const { return wide() ? sizeof(double) : sizeof(float); }
    // f of the numbers as they are stored.
    template <bool kMayBeDouble, class F> auto by_width(F f) const {
        if constexpr (!kMayBeDouble) return f(static_cast<float*>(data));
        else if constexpr (!CD_WITH_FLOAT32) return f(static_cast<double*>(data));
        else return is_float64 ? f(static_cast<double*>(data)) : f(static_cast<float*>(data));
    }
    template <class F> auto stored(F f) const { return by_width<kMayBeWide>(f); }
    // The same of what can only be the state.
    template <class F> auto stored_state(F f) const { return by_width<CD_WITH_FLOAT64>(f); }
    double operator[](size_t at) const {
        return stored([at](auto* numbers) { return double(numbers[at]); });
    }
    void put(size_t at, double number) const {
        stored([at, number](auto* numbers) { store(number, numbers[at]); });
    }
    StoredRange range() const {
        return wide() ? StoredRange{Limits<double>::least, Limits<double>::to_overflow, 0x1p-52}
                      : StoredRange{double(Limits<float>::least), Limits<float>::to_overflow, 0x1p-23};
    }

private:
    template <class T> static void store(double number, T& to) { to = T(number); }
};

// The lines of an object. force and target are null where there are none.
struct Lines {
    size_t nodes, pitch, components;
    StateNumbers position, velocity, force, target;
};

// One implicit stage, from a start (x, v). It solves for w, the velocity that moves the positions,
//     (M (1 + h drag) + h (h + damping) K) w = M v + h [f + M g - K x],     then    v <- w + overshoot (w - v),
//     x <- x + move w.
struct Stage {
    double closing_rate; // 1 / (h + damping) [1/s]: how fast a spring wants to close
    double overshoot;
    double move;       // [s]
    double gravity[4]; // h g [m/s]
    // What the sweeps solve for. 0: w; 1: its change w - v. Of a stiff spring's velocity only a small part moves
    // anything, which v + change would lose in rounding; where hardly anything changes, as in soft rods and with a
    // lambda near 0, w - v would lose the change.
    double of_change;
};

// Where a stage starts: at the state (w null), or where the stage before it, whose answer is w, leads. What lies
// between two stages is never rounded to the state's precision.
struct Start {
    const double* w;
    double overshoot, move;
};

// What acts on a node from outside, as gains per node; null where nothing of the kind does. Held nodes have gain 0.
struct NodeGains {
    const double* gravity; // of h g
    const double* force;   // of the force [s/kg]
    const double* drag;    // of the velocity
    const double* attach;  // of the distance from the target [1/s]
};

} // namespace cd
