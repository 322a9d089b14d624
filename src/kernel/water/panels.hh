// Lines of a water in and out of panels, side by side.
#pragma once

#include "kernel/tiles.hh"
#include "kernel/water/sweep.hh"

namespace cd {
namespace CD_ISA {

// Lines that are worked on side by side: two registers of the narrowest, which it has few of.
constexpr int kLines = kNative < 4 ? 4 : kWaterLanes;
using L = Lanes<kLines>;

// Numbers of lines side by side: number i of lane k lies at i * kLines + k.
struct Panel {
    double* first;

    explicit operator bool() const { return first != nullptr; }
    L operator[](size_t i) const { return L::load(first + i * kLines); }
    void put(size_t i, L a) const { a.store(first + i * kLines); }
};

// Donor cells: all_i x_i = own_i + from_l_i x_{i-1} + from_r_i x_{i+1} on a line or round a ring, where between two
// neighbours only one takes from the other. One pass each way solves it. At first `before` is x_{-1} of a line, 0 of a
// ring, and what comes round a ring follows from its sum: it is linear in itself.
struct Donors {
    Panel x, pull, around; // around: of a ring
    bool ring;
    L before{}, share = L::splat(1);

    void row(size_t i, L own, L from_l, L from_r, L inverse) { // of `all`
        before = (own + from_l * before) * inverse;
        x.put(i, before);
        pull.put(i, from_r * inverse);
        if (!ring) return;
        share = share * (from_l * inverse);
        around.put(i, share);
    }
    static L round(L once, L share) {
        const L rest = L::splat(1) - share;
        return select(rest, once / rest, L{});
    }
    // set(i, x_i), the last of m first; x_m of a line is `behind`.
    template <class Set> void solve(size_t m, L behind, Set set) const {
        if (ring) {
            const L comes = round(before, share);
            L once{}, all = L::splat(1);
            for (size_t i = m; i-- > 0;) {
                x.put(i, x[i] + around[i] * comes);
                once = x[i] + pull[i] * once, all = all * pull[i];
            }
            behind = round(once, all);
        }
        for (size_t i = m; i-- > 0;) set(i, behind = x[i] + pull[i] * behind);
    }
};

// Takes a panel for lines of so many cells from the memory to work in.
inline Panel take_panel(double*& work, size_t cells) {
    const Panel own{work};
    work += (cells + kWaterRoom) * kLines;
    return own;
}

// Where number i of a lane lies. Lanes beyond those that there are repeat the last one.
struct Place {
    size_t start, along, across, lanes;

    size_t at(size_t i, size_t lane) const { return start + i * along + (lane < lanes ? lane : lanes - 1) * across; }
};
inline Place place_of(const WaterSweep& sweep, const Strides& s, size_t line, size_t lanes) {
    return {sweep.first * s.along + line * s.across, s.along, s.across, lanes};
}

// The least of some numbers and 1, and the largest of them and 0.
struct Reach {
    L least = L::splat(1), largest{};

    void see(L a) { least = smaller(a, least), largest = larger(a, largest); }
};

template <class T> inline Reach fetch_stored(const Place p, size_t count, const T* from, Panel to) {
    Reach reach;
    const auto take = [&](size_t i, L numbers) { to.put(i, numbers), reach.see(numbers); };
    size_t i = 0;
    if (p.across == 1 && p.lanes == kLines)
        for (; i < count; ++i) take(i, L::load(from + p.at(i, 0)));
    if constexpr (kLines == kTile)
        if (p.along == 1 && p.lanes == kLines)
            for (; i + kTile <= count; i += kTile) {
                L numbers[kTile];
                load_tile(from + p.at(i, 0), p.across, numbers);
                for (size_t k = 0; k < kTile; ++k) take(i + k, numbers[k]);
            }
    for (; i < count; ++i) {
        double numbers[kLines];
        for (size_t lane = 0; lane < kLines; ++lane) numbers[lane] = double(from[p.at(i, lane)]);
        take(i, L::load(numbers));
    }
    return reach;
}
__attribute__((noinline)) inline Reach fetch(const Place& p, size_t count, const StateNumbers& from, Panel to) {
    return from.stored([&](const auto* numbers) { return fetch_stored(p, count, numbers, to); });
}

// Numbers smaller than `least` are put down as 0. NaN where one is too large to be stored, else 0.
template <class T> inline L put_stored(const Place p, size_t count, Panel from, T* to, double least) {
    L probe{};
    const auto storable = [&](size_t i) {
        probe = probe + 0.0 * (Limits<T>::to_overflow * from[i]);
        return settled(from[i], least);
    };
    size_t i = 0;
    if (p.across == 1 && p.lanes == kLines)
        for (; i < count; ++i) storable(i).store(to + p.at(i, 0));
    if constexpr (kLines == kTile)
        if (p.along == 1 && p.lanes == kLines)
            for (; i + kTile <= count; i += kTile) {
                L numbers[kTile];
                for (size_t k = 0; k < kTile; ++k) numbers[k] = storable(i + k);
                store_tile(numbers, to + p.at(i, 0), p.across);
            }
    for (; i < count; ++i) {
        double numbers[kLines];
        storable(i).store(numbers);
        for (size_t lane = 0; lane < p.lanes; ++lane) to[p.at(i, lane)] = T(numbers[lane]);
    }
    return probe;
}
__attribute__((noinline)) inline L put(const Place& p, size_t count, Panel from, const StateNumbers& to,
                                       double least = 0) {
    return to.stored([&](auto* numbers) { return put_stored(p, count, from, numbers, least); });
}

// What lets water cross the faces of lines of cells: 1, or 0 beside cells that are not there and on walls.
__attribute__((noinline)) inline void fetch_openings(const Place& bytes, const WaterLines& lines, Neighbours cells,
                                                     Panel to) {
    const size_t n = cells.count;
    for (size_t lane = 0; lane < kLines; ++lane) {
        size_t at = bytes.at(0, lane);
        double* const out = to.first + lane;
        bool before = lines.there(bytes.at(cells.before(0), lane));
        for (size_t i = 0; i < n; ++i, at += bytes.along) {
            const bool there = lines.there(at);
            out[i * kLines] = before && there && !lines.walled(at) ? 1 : 0;
            before = there;
        }
        if (!cells.ring) out[0] = lines.there(bytes.at(0, lane)) ? 1 : 0; // sides are no walls of a line
        out[n * kLines] = cells.ring ? out[0] : before ? 1 : 0;
    }
}

// work.bundle(first line, lanes) for the lines in packs [first, first + count); whether all came out finite.
template <class Work> bool in_bundles(const Work& work, size_t lines, size_t first, size_t count) {
    const size_t end = (first + count) * kWaterPack < lines ? (first + count) * kWaterPack : lines;
    bool finite = true;
    for (size_t line = first * kWaterPack; line < end; line += kLines)
        finite &= work.bundle(line, lines - line < kLines ? lines - line : kLines);
    return finite;
}

} // namespace CD_ISA
} // namespace cd
