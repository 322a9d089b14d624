// An explicit step of a uniform lattice on which nothing but springs and gravity acts, in the precision of the state: a
// register holds twice as many floats as doubles, and nothing is converted. At each node
//
//     v += rate ((x_after - x) - (x - x_before)) [of each direction] + dt g,     x += dt v
//
// Nothing adds up along a line here, and a node's x and v are rounded in every step whatever they are computed in. What
// must not be rounded are the rates: they would be off in every step alike, which shows as a wrong frequency
// (tests/physics/test_explicit.c). In float a rate has a head of 12 bits, whose products are nearly exact, and a tail.
// (With a head of 24 bits the tail's product is below the rounding of the head's, and lost.)
//
// Velocities settle (see Limits), and so positions, which move by them, do not come to be subnormal.
//
// What is left, with AVX-512 on a Zen 5: 11 cycles for 16 nodes of a sheet in the cache, and beyond it the memory: 1.0
// to 1.2 times a copy of the state for chains, 1.1 to 1.9 times for sheets.
#pragma once

#include <utility>

#include "kernel/packed.hh"

namespace cd {
namespace CD_ISA {

namespace {

// The numbers before those of `here`, which follows `last`.
template <class V, int... kPlaces> inline V before(V last, V here, std::integer_sequence<int, kPlaces...>) {
    return __builtin_shufflevector(last, here, int(sizeof...(kPlaces)) - 1 + kPlaces...);
}
template <class T, class V> inline V before(V last, V here) {
    if constexpr (kCountOf<V, T> == 1) return last;
    else return before(last, here, std::make_integer_sequence<int, kCountOf<V, T>>());
}
template <class T, class V> inline T last_of(V a) {
    if constexpr (kCountOf<V, T> == 1) return a;
    else return a[kCountOf<V, T> - 1];
}

// dt times a stiffness over a mass.
template <class T> struct Rate {
    T head, tail;

    explicit Rate(double rate) {
        constexpr double kHalf = 0x1p41; // what double adds to a number to round it to 12 bits
        head = T(sizeof(T) < sizeof(double) ? rate * kHalf - (rate * kHalf - rate) : rate);
        tail = T(rate - double(head));
    }
};

// x moves by dt as T has it; all rates are larger by what that lacks, so that frequencies are right.
template <class T> struct PlainTime {
    T dt;
    double exact;

    explicit PlainTime(double dt_) : dt(T(dt_)), exact(dt_ / double(dt)) {}
};

// Whether a rate, dt or dt g times numbers that Limits lets stand stays in the range in which T is precise and fast.
template <class T> inline bool in_plain_range(double rate) {
    const double least = sizeof(T) == sizeof(float) ? 0x1p-22 : 0x1p-400;
    const double most = sizeof(T) == sizeof(float) ? 0x1p40 : 0x1p400;
    return rate == 0 || (rate >= least && rate <= most);
}

// Moves nodes. heads and tails: the two parts of their rates times what pulls. A velocity that is too large takes the
// position with it, and that the probe.
template <class T, class V, class G>
inline void move_plainly(V heads, V tails, G gravity, T dt, V x, V v, T* to_x, T* to_v, V& probe) {
    V change;
    if constexpr (sizeof(T) < sizeof(double)) change = heads + (tails + gravity);
    else change = heads + gravity;
    const V new_v = without_small(v + change, Limits<T>::least), new_x = x + dt * new_v;
    probe = both_bits<T>(probe, T(0) * new_x);
    put(new_v, to_v);
    put(new_x, to_x);
}

} // namespace

} // namespace CD_ISA
} // namespace cd
