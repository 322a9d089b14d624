// N numbers that go through the same operations side by side: N lines of a lattice, which never mix.
//
// Powers of two are GCC/Clang vectors, other counts plain arrays; an operation rounds the same in both, so a line's
// result does not depend on how many neighbours it shared a register with. Vectors are naturally aligned and loaded
// through memcpy: GCC 12 sends under-aligned vector types through the stack.
#pragma once

#include <stddef.h>
#include <stdint.h>
#include <string.h>

namespace cd {

template <class T, int N, bool Vector = (N > 1 && (N & (N - 1)) == 0)> struct Lanes;

template <class T, int N> struct Lanes<T, N, true> {
    typedef T Values __attribute__((vector_size(N * sizeof(T))));
    Values v;

    static Lanes splat(T a) { return {a - Values{}}; }
    template <class S> static Lanes load(const S* from) {
        typedef S Stored __attribute__((vector_size(N * sizeof(S))));
        Stored stored;
        memcpy(&stored, from, sizeof stored);
        return {__builtin_convertvector(stored, Values)};
    }
    template <class S> void store(S* to) const {
        typedef S Stored __attribute__((vector_size(N * sizeof(S))));
        const Stored stored = __builtin_convertvector(v, Stored);
        memcpy(to, &stored, sizeof stored);
    }
    friend Lanes operator+(Lanes a, Lanes b) { return {a.v + b.v}; }
    friend Lanes operator-(Lanes a, Lanes b) { return {a.v - b.v}; }
    friend Lanes operator*(Lanes a, Lanes b) { return {a.v * b.v}; }
    friend Lanes operator*(T a, Lanes b) { return splat(a) * b; }

    // 0 where |a| < least
    friend Lanes settled(Lanes a, T least) {
        const auto small = (a.v < splat(least).v) & (a.v > splat(-least).v);
        return {reinterpret_cast<Values>(reinterpret_cast<decltype(a.v < a.v)>(a.v) & ~small)};
    }
    bool any_nan() const {
        for (int j = 0; j < N; ++j)
            if (v[j] != v[j]) return true;
        return false;
    }
};

template <class T, int N> struct Lanes<T, N, false> {
    T v[N];

    template <class F> static Lanes each(F f) {
        Lanes r;
        for (int j = 0; j < N; ++j) r.v[j] = f(j);
        return r;
    }
    static Lanes splat(T a) { return each([&](int) { return a; }); }
    template <class S> static Lanes load(const S* from) { return each([&](int j) { return T(from[j]); }); }
    template <class S> void store(S* to) const {
        for (int j = 0; j < N; ++j) to[j] = S(v[j]);
    }
    friend Lanes operator+(Lanes a, Lanes b) { return each([&](int j) { return a.v[j] + b.v[j]; }); }
    friend Lanes operator-(Lanes a, Lanes b) { return each([&](int j) { return a.v[j] - b.v[j]; }); }
    friend Lanes operator*(Lanes a, Lanes b) { return each([&](int j) { return a.v[j] * b.v[j]; }); }
    friend Lanes operator*(T a, Lanes b) { return each([&](int j) { return a * b.v[j]; }); }

    friend Lanes settled(Lanes a, T least) {
        return each([&](int j) { return a.v[j] < least && a.v[j] > -least ? T(0) : a.v[j]; });
    }
    bool any_nan() const {
        for (int j = 0; j < N; ++j)
            if (v[j] != v[j]) return true;
        return false;
    }
};

// The point between `here` and `there` at a fraction of the way. With the sign bit set, the fraction is measured from
// there: so both a fraction near 0 and one near 1 keep their digits, a weight of 0 leaves no trace of what it weighs, and
// equal ends give themselves, exactly.
template <class L, class T> inline L between(L here, L there, T fraction) {
    return __builtin_signbit(fraction) ? there - fraction * (here - there) : here + fraction * (there - here);
}

// Calls f.template bundle<N>(first) for bundles of lanes that together cover [first, first + count): eight, a cache line
// of doubles, while they last, then fewer; three stay together, for the three components of a single strand.
template <class F> void for_each_bundle(size_t first, size_t count, F& f) {
    while (count > 0) {
        int n;
        if (count >= 8) f.template bundle<8>(first), n = 8;
        else if (count >= 4) f.template bundle<4>(first), n = 4;
        else if (count == 3) f.template bundle<3>(first), n = 3;
        else if (count == 2) f.template bundle<2>(first), n = 2;
        else f.template bundle<1>(first), n = 1;
        first += size_t(n);
        count -= size_t(n);
    }
}

} // namespace cd
