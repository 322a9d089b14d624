// Numbers side by side in the precision they are stored in: of floats a register holds twice as many as of doubles.
#pragma once

#include <utility>

#include "kernel/lanes.hh"
#include "kernel/lines.hh"

namespace cd {
namespace CD_ISA {

namespace {

// Numbers side by side that fill a register, half of it, and the smallest one. V below is one of these or a single T.
template <class T, size_t kBytes> struct Packed { typedef T Values __attribute__((vector_size(kBytes))); };
template <class T> using Wide = typename Packed<T, size_t(kNative) * sizeof(double)>::Values;
template <class T> using Half = typename Packed<T, sizeof(Wide<T>) / 2>::Values;
template <class T> using Narrow = typename Packed<T, 16>::Values;
template <class V, class T> constexpr int kCountOf = int(sizeof(V) / sizeof(T));

template <class V, class T> inline V get(const T* from) {
    V a;
    memcpy(&a, from, sizeof a);
    return a;
}
template <class V, class T> inline void put(V a, T* to) { memcpy(to, &a, sizeof a); }

template <class V, class Half, int... kPlaces> inline V joined(Half a, Half b, std::integer_sequence<int, kPlaces...>) {
    return __builtin_shufflevector(a, b, kPlaces...);
}
// Lanes, rounded to what is stored.
template <class V, class T, int N> inline V packed(Lanes<N> a) {
    static_assert(kCountOf<V, T> == N, "as many as there are");
    if constexpr (N == 1) return T(a.v);
    else if constexpr (lane_kind(N) == LaneKind::kVector) return converted<V>(a.v);
    else {
        typedef typename Packed<T, sizeof(V) / 2>::Values Half;
        return joined<V>(packed<Half, T>(a.a), packed<Half, T>(a.b), std::make_integer_sequence<int, N>());
    }
}

// Collects 0 times what is stored, which is NaN where that is too large.
template <class T> struct PlainProbe {
    Wide<T> wide{};
    Narrow<T> narrow{};
    T single = 0;

    template <class V> void add(V seen) {
        if constexpr (sizeof(V) == sizeof wide) wide += seen;
        else if constexpr (sizeof(V) == sizeof narrow) narrow += seen;
        else if constexpr (sizeof(V) > sizeof narrow)
            wide += joined<Wide<T>>(seen, V{}, std::make_integer_sequence<int, kCountOf<Wide<T>, T>>());
        else single += seen;
    }
    bool finite() const {
        T all = single;
        for (int j = 0; j < kCountOf<Wide<T>, T>; ++j) all += wide[j];
        for (int j = 0; j < kCountOf<Narrow<T>, T>; ++j) all += narrow[j];
        return all == 0;
    }
};
template <class T, class V> inline V both_bits(V a, V b) {
    if constexpr (sizeof(V) == sizeof(T)) return a + b;
    else {
        typedef decltype(a < a) Bits;
        return reinterpret_cast<V>(reinterpret_cast<Bits>(a) | reinterpret_cast<Bits>(b));
    }
}

// 0 where a number is smaller than `least`.
template <class T, class V> inline V without_small(V a, T least) {
    if constexpr (sizeof(V) == sizeof(T)) return (a < 0 ? -a : a) < least ? 0 : a;
    else {
        typedef decltype(a < a) Bits;
        const V size = reinterpret_cast<V>(reinterpret_cast<Bits>(a) & ~reinterpret_cast<Bits>(-V{}));
        return size < least ? V{} : a;
    }
}

// A number to be stored settles to 0 if it is too small, and adds NaN to the probe if it is too large.
template <class V, class T> inline void put_settled(V a, T* to, V& seen) {
    seen = both_bits<T>(seen, T(0) * a);
    put(without_small(a, Limits<T>::least), to);
}

} // namespace

} // namespace CD_ISA
} // namespace cd
