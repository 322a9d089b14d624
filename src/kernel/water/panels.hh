// Lines of a water in and out of panels, N side by side.
#pragma once

#include "kernel/tiles.hh"
#include "kernel/water/sweep.hh"

namespace cd {
namespace CD_ISA {

// Numbers of N lines: number i of lane k lies at i * N + k.
template <int N> struct Panel {
    double* first;

    explicit operator bool() const { return first != nullptr; }
    Lanes<N> operator[](size_t i) const { return Lanes<N>::load(first + i * N); }
    void put(size_t i, Lanes<N> a) const { a.store(first + i * N); }
};

// Panels of lines of as many cells, one after the other in memory.
template <int N> struct Panels {
    double* free;
    size_t cells;

    Panel<N> operator()() {
        double* const own = free;
        free += (cells + kWaterRoom) * N;
        return {own};
    }
};

// Where the numbers of N lines from `line` on lie: `along` apart on a line, lines `across`. Lanes beyond the last of
// the `lanes` lines that there are repeat that one.
struct Place {
    size_t along, across, line, lanes;

    size_t at(size_t i, size_t lane) const { return i * along + (line + (lane < lanes ? lane : lanes - 1)) * across; }
};
template <class Lines> Place place_of(const Lines& lines, size_t line, size_t most) {
    const size_t left = lines.lines - line;
    return {lines.along, lines.across, line, left < most ? left : most};
}

// The least and the largest of some numbers and of what this begins with.
template <int N> struct Reach {
    Lanes<N> least{}, largest{};

    void see(Lanes<N> a) { least = smaller(a, least), largest = larger(a, largest); }
};

template <int N, class T>
inline Reach<N> fetch_stored(const Place& p, size_t count, const T* from, Panel<N> to, Reach<N> reach) {
    const auto take = [&](size_t i, Lanes<N> numbers) { to.put(i, numbers), reach.see(numbers); };
    size_t i = 0;
    if (p.across == 1 && p.lanes == N)
        for (; i < count; ++i) take(i, Lanes<N>::load(from + p.at(i, 0)));
    if constexpr (N == kTile)
        if (p.along == 1 && p.lanes == N)
            for (; i + kTile <= count; i += kTile) {
                Lanes<N> numbers[kTile];
                load_tile(from + p.at(i, 0), p.across, numbers);
                for (size_t k = 0; k < kTile; ++k) take(i + k, numbers[k]);
            }
    for (; i < count; ++i) {
        double numbers[N];
        for (size_t lane = 0; lane < N; ++lane) numbers[lane] = double(from[p.at(i, lane)]);
        take(i, Lanes<N>::load(numbers));
    }
    return reach;
}
template <int N> __attribute__((noinline)) Reach<N> fetch(const Place& p, size_t count, const StateNumbers& from,
                                                          Panel<N> to, Reach<N> reach = {}) {
    return from.stored([&](const auto* numbers) { return fetch_stored(p, count, numbers, to, reach); });
}

// Numbers smaller than `least` are put down as 0. NaN where one is too large to be stored, else 0.
template <int N, class T> inline Lanes<N> put_stored(const Place& p, size_t count, Panel<N> from, T* to, double least) {
    Lanes<N> probe{};
    const auto storable = [&](size_t i) {
        probe = probe + 0.0 * (Limits<T>::to_overflow * from[i]);
        return settled(from[i], least);
    };
    size_t i = 0;
    if (p.across == 1 && p.lanes == N)
        for (; i < count; ++i) storable(i).store(to + p.at(i, 0));
    if constexpr (N == kTile)
        if (p.along == 1 && p.lanes == N)
            for (; i + kTile <= count; i += kTile) {
                Lanes<N> numbers[kTile];
                for (size_t k = 0; k < kTile; ++k) numbers[k] = storable(i + k);
                store_tile(numbers, to + p.at(i, 0), p.across);
            }
    for (; i < count; ++i) {
        double numbers[N];
        storable(i).store(numbers);
        for (size_t lane = 0; lane < p.lanes; ++lane) to[p.at(i, lane)] = T(numbers[lane]);
    }
    return probe;
}
template <int N> __attribute__((noinline)) Lanes<N> put(const Place& p, size_t count, Panel<N> from,
                                                        const StateNumbers& to, double least = 0) {
    return to.stored([&](auto* numbers) { return put_stored(p, count, from, numbers, least); });
}

// work.bundle<N>(its first line) for what lies in packs [first, first + count); whether all came out finite.
template <class Work> bool in_bundles(const Work& work, size_t lines, size_t first, size_t count) {
    const size_t end = (first + count) * kWaterPack < lines ? (first + count) * kWaterPack : lines;
    bool finite = true;
    constexpr int kLanes = kNative < 4 ? 4 : kWaterLanes; // two registers of the narrowest, which it has few of
    for (size_t line = first * kWaterPack; line < end; line += kLanes) finite &= work.template bundle<kLanes>(line);
    return finite;
}

} // namespace CD_ISA
} // namespace cd
