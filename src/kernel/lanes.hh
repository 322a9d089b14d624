// N numbers that go through the same operations side by side: N lines of a lattice, which never mix.
//
// As many as a register of the instruction set holds are a GCC/Clang vector; more, or an odd number, are a pair of
// narrower lanes. An operation rounds the same in all, so a line's result does not depend on how many neighbours it
// shared a register with. Vectors are naturally aligned and loaded through memcpy: GCC 12 sends under-aligned vector
// types, and vectors wider than a register, through the stack (measured: ten and six times slower). What vectors cannot
// say is said with the compilers' built-in functions: the intrinsics' header takes longer to read than most kernels to
// compile.
//
// The kernels are compiled once per instruction set (kernels.hh), each into the namespace CD_ISA: the same inline
// function compiled with different flags under one name would be one of them at random.
#pragma once

#include <stddef.h>
#include <stdint.h>
#include <string.h>

// Of functions that wait for registers when they are called. WebAssembly is to be small, and lets the compiler decide.
#ifdef __wasm__
#define CD_INLINED
#else
#define CD_INLINED __attribute__((always_inline))
#endif

#ifndef CD_ISA
#define CD_ISA plain // of the code outside the kernels
#define CD_ISA_IS_PLAIN
#endif

namespace cd {
namespace CD_ISA {

#ifdef CD_ISA_IS_PLAIN
constexpr bool kIsPlain = true;
#else
constexpr bool kIsPlain = false;
#endif

// The set whose registers fewer lines fill than this one's; and how few it takes over. One line no set makes faster, and
// with fewer than AVX-512 holds the compiler makes of AVX-512 what it makes of AVX2.
#if !defined(CD_ISA_IS_PLAIN) && defined(__AVX512F__) && CD_WITH_AVX2
#define CD_NARROWER avx2
constexpr size_t kFewest = 8;
#else
#define CD_NARROWER plain
constexpr size_t kFewest = kIsPlain ? 1 : 2;
#endif

// Doubles in a register.
#if defined(__AVX512F__)
constexpr int kNative = 8;
#elif defined(__AVX__)
constexpr int kNative = 4;
#else
constexpr int kNative = 2;
#endif

constexpr int largest_power_below(int n) { return n <= 2 ? 1 : 2 * largest_power_below((n + 1) / 2); }

enum class LaneKind { kSingle, kVector, kPair };
constexpr LaneKind lane_kind(int n) {
    if (n == 1) return LaneKind::kSingle;
    const int width = n == 3 ? 4 : n; // three fill a register of four but for one
    return (width & (width - 1)) == 0 && width <= kNative ? LaneKind::kVector : LaneKind::kPair;
}

[[maybe_unused]] constexpr char kAllLanes = -1; // a mask argument of AVX-512's functions
[[maybe_unused]] constexpr int kRoundAsSet = 4; // and one of rounding: as the control register says

// Numbers of a vector in another precision. GCC 12 goes from four floats to four doubles, and from eight to eight and
// back, by halves.
template <class To, class From> inline To converted(From a) {
#if defined(__AVX__) && !defined(__clang__)
    if constexpr (sizeof(To) == 32 && sizeof(From) == 16) return __builtin_ia32_cvtps2pd256(a);
#endif
#if defined(__AVX512F__) && !defined(__clang__)
    if constexpr (sizeof(To) == 64 && sizeof(From) == 32)
        return __builtin_ia32_cvtps2pd512_mask(a, To{}, kAllLanes, kRoundAsSet);
    if constexpr (sizeof(To) == 32 && sizeof(From) == 64)
        return __builtin_ia32_cvtpd2ps512_mask(a, To{}, kAllLanes, kRoundAsSet);
#endif
    return __builtin_convertvector(a, To);
}

// The larger numbers of two vectors and the smaller ones, by the instruction: where one of them is a constant GCC 12 makes
// a comparison and a choice of it.
#if defined(__SSE2__) && !defined(__clang__)
typedef double Two __attribute__((vector_size(16)));
inline Two larger_numbers(Two a, Two b) { return __builtin_ia32_maxpd(a, b); }
inline Two smaller_numbers(Two a, Two b) { return __builtin_ia32_minpd(a, b); }
#ifdef __AVX__
typedef double Four __attribute__((vector_size(32)));
inline Four larger_numbers(Four a, Four b) { return __builtin_ia32_maxpd256(a, b); }
inline Four smaller_numbers(Four a, Four b) { return __builtin_ia32_minpd256(a, b); }
#endif
#ifdef __AVX512F__
typedef double Eight __attribute__((vector_size(64)));
inline Eight larger_numbers(Eight a, Eight b) {
    return __builtin_ia32_maxpd512_mask(a, b, Eight{}, kAllLanes, kRoundAsSet);
}
inline Eight smaller_numbers(Eight a, Eight b) {
    return __builtin_ia32_minpd512_mask(a, b, Eight{}, kAllLanes, kRoundAsSet);
}
#endif
#else
template <class Values> inline Values larger_numbers(Values a, Values b) { return a > b ? a : b; }
template <class Values> inline Values smaller_numbers(Values a, Values b) { return a < b ? a : b; }
#endif

// D is double: GCC 12 makes a vector of N of it only where its name depends on the template too.
template <int N, LaneKind = lane_kind(N), class D = double> struct Lanes;

template <> struct Lanes<1, LaneKind::kSingle, double> {
    double v;

    static Lanes splat(double a) { return {a}; }
    template <class S> static Lanes load(const S* from) { return {double(*from)}; }
    template <class S> void store(S* to) const { *to = S(v); }
    template <class S> Lanes rounded_to() const { return {double(S(v))}; } // what a stored number is
    friend Lanes operator+(Lanes a, Lanes b) { return {a.v + b.v}; }
    friend Lanes operator-(Lanes a, Lanes b) { return {a.v - b.v}; }
    friend Lanes operator*(Lanes a, Lanes b) { return {a.v * b.v}; }
    friend Lanes operator/(Lanes a, Lanes b) { return {a.v / b.v}; }
    friend Lanes settled(Lanes a, double least) { return {__builtin_fabs(a.v) < least ? 0 : a.v}; }
    friend Lanes select(Lanes by, Lanes a, Lanes b) { return by.v > 0 ? a : b; }
    friend Lanes by_sign(Lanes by, Lanes a, Lanes b) { return __builtin_signbit(by.v) ? a : b; }
    friend Lanes larger(Lanes a, Lanes b) { return {a.v > b.v ? a.v : b.v}; }
    friend Lanes smaller(Lanes a, Lanes b) { return {a.v < b.v ? a.v : b.v}; }
    friend Lanes size_of(Lanes a) { return {__builtin_fabs(a.v)}; }
    template <class F> friend Lanes each_lane(Lanes a, F f) { return {f(a.v)}; }
    friend Lanes root(Lanes a) { return {__builtin_sqrt(a.v)}; }
    bool any_nan() const { return v != v; }
    bool any_positive() const { return v > 0; }
    bool all_positive() const { return v > 0; }
};

template <int N, class D> struct Lanes<N, LaneKind::kVector, D> {
    static constexpr int kWidth = N == 3 ? 4 : N;
    typedef D Values __attribute__((vector_size(kWidth * sizeof(D))));
    Values v;

    static Lanes splat(double a) { return {a - Values{}}; }
    template <class S> static Lanes load(const S* from) {
        typedef S Stored __attribute__((vector_size(kWidth * sizeof(S))));
        Stored stored;
        if constexpr (N == 3) stored = Stored{from[0], from[1], from[2], 0};
        else memcpy(&stored, from, N * sizeof(S));
        return {converted<Values>(stored)};
    }
    template <class S> void store(S* to) const {
        typedef S Stored __attribute__((vector_size(kWidth * sizeof(S))));
        const Stored stored = converted<Stored>(v);
        if constexpr (N == 3) {
            for (int j = 0; j < 3; ++j) to[j] = stored[j];
            return;
        }
        memcpy(to, &stored, N * sizeof(S));
    }
    template <class S> Lanes rounded_to() const {
        typedef S Stored __attribute__((vector_size(kWidth * sizeof(S))));
        return {converted<Values>(converted<Stored>(v))};
    }
    friend Lanes operator+(Lanes a, Lanes b) { return {a.v + b.v}; }
    friend Lanes operator-(Lanes a, Lanes b) { return {a.v - b.v}; }
    friend Lanes operator*(Lanes a, Lanes b) { return {a.v * b.v}; }
    friend Lanes operator/(Lanes a, Lanes b) { return {a.v / b.v}; }

    // 0 where |a| < least. Of two comparisons GCC 12 makes a choice, with SSE2 lane by lane.
    friend Lanes settled(Lanes a, double least) {
        typedef decltype(a.v < a.v) Bits;
        const Bits small = size_of(a).v < splat(least).v;
        return {reinterpret_cast<Values>(reinterpret_cast<Bits>(a.v) & ~small)};
    }
    // a where by > 0, else b
    friend Lanes select(Lanes by, Lanes a, Lanes b) {
        typedef decltype(a.v < a.v) Bits;
        const Bits yes = by.v > splat(0).v;
        return {reinterpret_cast<Values>((reinterpret_cast<Bits>(a.v) & yes) | (reinterpret_cast<Bits>(b.v) & ~yes))};
    }
    // a where by has its sign bit set, else b
    friend Lanes by_sign(Lanes by, Lanes a, Lanes b) {
        typedef decltype(a.v < a.v) Bits;
#if defined(__SSE2__) && !defined(__SSE4_1__) && !defined(__clang__)
        const Bits yes = reinterpret_cast<Bits>(by.v) >> 63; // GCC 12 would go lane by lane
        return {reinterpret_cast<Values>((reinterpret_cast<Bits>(a.v) & yes) | (reinterpret_cast<Bits>(b.v) & ~yes))};
#else
        return {reinterpret_cast<Bits>(by.v) < 0 ? a.v : b.v};
#endif
    }
    // the second one where either is NaN
    friend Lanes larger(Lanes a, Lanes b) { return {larger_numbers(a.v, b.v)}; }
    friend Lanes smaller(Lanes a, Lanes b) { return {smaller_numbers(a.v, b.v)}; }
    friend Lanes size_of(Lanes a) {
        typedef decltype(a.v < a.v) Bits;
        return {reinterpret_cast<Values>(reinterpret_cast<Bits>(a.v) & INT64_MAX)};
    }
    template <class F> friend Lanes each_lane(Lanes a, F f) {
        for (int j = 0; j < N; ++j) a.v[j] = f(a.v[j]);
        return a;
    }
    friend Lanes root(Lanes a) {
#if !defined(__clang__) // Clang makes the same of the loop
#if defined(__AVX512F__)
        if constexpr (N == 8) return {__builtin_ia32_sqrtpd512_mask(a.v, Values{}, kAllLanes, kRoundAsSet)};
#endif
#if defined(__AVX__)
        if constexpr (kWidth == 4) return {__builtin_ia32_sqrtpd256(a.v)};
#endif
#if defined(__SSE2__)
        if constexpr (N == 2) return {__builtin_ia32_sqrtpd(a.v)};
#endif
#endif
        return each_lane(a, [](double x) { return __builtin_sqrt(x); });
    }
    // Lanes 0 and 1 exchanged, 2 and 3, and so on.
    friend Lanes pairs_exchanged(Lanes a) {
        if constexpr (N == 2) return {__builtin_shufflevector(a.v, a.v, 1, 0)};
        else if constexpr (N == 4) return {__builtin_shufflevector(a.v, a.v, 1, 0, 3, 2)};
        else return {__builtin_shufflevector(a.v, a.v, 1, 0, 3, 2, 5, 4, 7, 6)};
    }
    bool any_nan() const {
        for (int j = 0; j < N; ++j)
            if (v[j] != v[j]) return true;
        return false;
    }
    bool any_positive() const { return positive_lanes() != 0; }
    bool all_positive() const { return positive_lanes() == (1u << N) - 1; }

private:
    unsigned positive_lanes() const { // bit j: of lane j
#if defined(__AVX512F__)
        constexpr int kGreater = 30; // false where either is NaN
        if constexpr (N == 8) return __builtin_ia32_cmppd512_mask(v, Values{}, kGreater, kAllLanes, kRoundAsSet);
#endif
#if defined(__AVX__)
        if constexpr (N == 4) return unsigned(__builtin_ia32_movmskpd256(Values(v > Values{})));
#endif
#if defined(__SSE2__)
        if constexpr (N == 2) return unsigned(__builtin_ia32_movmskpd(Values(v > Values{})));
#endif
        unsigned lanes = 0;
        for (int j = 0; j < N; ++j) lanes |= unsigned(v[j] > 0) << j;
        return lanes;
    }
};

template <int N, class D> struct Lanes<N, LaneKind::kPair, D> {
    static constexpr int kFirst = largest_power_below(N);
    Lanes<kFirst> a;
    Lanes<N - kFirst> b;

    static Lanes splat(double s) { return {Lanes<kFirst>::splat(s), Lanes<N - kFirst>::splat(s)}; }
    template <class S> static Lanes load(const S* from) {
        return {Lanes<kFirst>::load(from), Lanes<N - kFirst>::load(from + kFirst)};
    }
    template <class S> void store(S* to) const {
        a.store(to);
        b.store(to + kFirst);
    }
    template <class S> Lanes rounded_to() const { return {a.template rounded_to<S>(), b.template rounded_to<S>()}; }
    friend Lanes operator+(Lanes x, Lanes y) { return {x.a + y.a, x.b + y.b}; }
    friend Lanes operator-(Lanes x, Lanes y) { return {x.a - y.a, x.b - y.b}; }
    friend Lanes operator*(Lanes x, Lanes y) { return {x.a * y.a, x.b * y.b}; }
    friend Lanes operator/(Lanes x, Lanes y) { return {x.a / y.a, x.b / y.b}; }
    friend Lanes settled(Lanes x, double least) { return {settled(x.a, least), settled(x.b, least)}; }
    friend Lanes select(Lanes by, Lanes x, Lanes y) { return {select(by.a, x.a, y.a), select(by.b, x.b, y.b)}; }
    friend Lanes by_sign(Lanes by, Lanes x, Lanes y) { return {by_sign(by.a, x.a, y.a), by_sign(by.b, x.b, y.b)}; }
    friend Lanes larger(Lanes x, Lanes y) { return {larger(x.a, y.a), larger(x.b, y.b)}; }
    friend Lanes smaller(Lanes x, Lanes y) { return {smaller(x.a, y.a), smaller(x.b, y.b)}; }
    friend Lanes size_of(Lanes x) { return {size_of(x.a), size_of(x.b)}; }
    template <class F> friend Lanes each_lane(Lanes x, F f) { return {each_lane(x.a, f), each_lane(x.b, f)}; }
    friend Lanes root(Lanes x) { return {root(x.a), root(x.b)}; }
    bool any_nan() const { return a.any_nan() || b.any_nan(); }
    bool any_positive() const { return a.any_positive() || b.any_positive(); }
    bool all_positive() const { return a.all_positive() && b.all_positive(); }
};

template <int N> inline Lanes<N> operator*(double s, Lanes<N> a) { return Lanes<N>::splat(s) * a; }
template <int N> inline Lanes<N> operator-(Lanes<N> a) { return Lanes<N>{} - a; }

template <int N> inline Lanes<N> positive(Lanes<N> a) { return larger(a, Lanes<N>{}); }
template <int N> inline Lanes<N> within(Lanes<N> a, double least, double most) {
    return smaller(larger(a, Lanes<N>::splat(least)), Lanes<N>::splat(most));
}
// The least of lanes that lie in different registers, and the largest: as many as one register holds.
template <int N> inline auto least_of(Lanes<N> a) {
    if constexpr (N > kNative) return least_of(smaller(a.a, a.b));
    else return a;
}
template <int N> inline auto largest_of(Lanes<N> a) {
    if constexpr (N > kNative) return largest_of(larger(a.a, a.b));
    else return a;
}
// Whether any lane is > 0, and whether all are.
template <int N> inline bool any_positive(Lanes<N> a) { return a.any_positive(); }
template <int N> inline bool all_positive(Lanes<N> a) { return a.all_positive(); }

// The least of all lanes, and the largest.
template <int N> inline double least_in(Lanes<N> a) {
    double lane[N], least;
    a.store(lane);
    least = lane[0];
    for (double x : lane) least = x < least ? x : least;
    return least;
}
template <int N> inline double largest_in(Lanes<N> a) { return -least_in(-a); }

// The point between `here` and `there` = moving + offset at a fraction of the way, and `extra` on top. With the sign
// bit set, the fraction is measured from there: so both a fraction near 0 and one near 1 keep their digits, a weight of
// 0 leaves no trace of what it weighs, and equal ends give themselves, exactly. `moving` is what the last node gave:
// only three operations wait for it.
template <class L> inline L between(L here, L moving, L offset, double fraction, L extra) {
    if (__builtin_signbit(fraction)) return (moving + (offset + extra)) - fraction * ((here - offset) - moving);
    return (here + extra) + fraction * (moving + (offset - here));
}
template <class L> inline L between(L here, L moving, L offset, double fraction) {
    if (__builtin_signbit(fraction)) return (moving + offset) - fraction * ((here - offset) - moving);
    return here + fraction * (moving + (offset - here));
}
// The same without an offset; the fraction in memory, from where it goes to all lanes at once and its sign to a branch.
template <class L> inline L between(L here, L moving, const double* fraction) {
    signed char sign;
    memcpy(&sign, reinterpret_cast<const char*>(fraction) + (__BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__ ? 7 : 0), 1);
    const L way = *fraction * (moving - here);
    return sign < 0 ? moving + way : here + way; // GCC 12 would have a choice of addends in memory
}

// The same to the bit, with a fraction for each lane.
template <class L> inline L between(L here, L moving, L offset, L fraction, L extra) {
    return by_sign(fraction, moving + (offset + extra), here + extra) + fraction * (moving + (offset - here));
}
template <class L> inline L between(L here, L moving, L offset, L fraction) {
    return by_sign(fraction, moving + offset, here) + fraction * (moving + (offset - here));
}

// The widest bundle: two registers at least, since a line's operations wait for each other.
constexpr int kWidest = kNative < 4 ? 4 : 8;

// Calls f.template bundle<N>(first) for bundles of lanes that together cover [first, first + count): the widest while
// they last, then narrower ones; three stay together, for the three components of a single strand. kMost: wider still.
// narrower(first, count): what the narrower set does with those that are left for it.
template <int kMost = kWidest, class F, class Narrower>
void for_each_bundle(size_t first, size_t count, F& f, const Narrower& narrower) {
    while (count > 0) {
        int n;
        if (count < kFewest) {
            f.finite &= narrower(first, count);
            return;
        }
        if constexpr (kMost > kWidest) {
            if (count >= size_t(kMost)) {
                f.template bundle<kMost>(first);
                first += size_t(kMost);
                count -= size_t(kMost);
                continue;
            }
        }
        if (kFewest == size_t(kWidest) || count >= size_t(kWidest)) f.template bundle<kWidest>(first), n = kWidest;
        else if (count >= 4) f.template bundle<4>(first), n = 4;
        else if (count == 3) f.template bundle<3>(first), n = 3;
        else if (!kIsPlain || count == 2) f.template bundle<2>(first), n = 2;
        else f.template bundle<1>(first), n = 1;
        first += size_t(n);
        count -= size_t(n);
    }
}

} // namespace CD_ISA

using namespace CD_ISA;

} // namespace cd
