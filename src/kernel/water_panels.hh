// Lines of a water in and out of panels (water_line.hh), N side by side.
#pragma once

#include "kernel/lines.hh"
#include "kernel/tiles.hh"
#include "kernel/water_line.hh"

namespace cd {
namespace CD_ISA {

// N lines, or the first `lanes` of them, from element (0, first) on: numbers lie `along` apart on a line, lines
// `across`.
struct Place {
    size_t along, across, first, lanes;

    size_t at(size_t i, size_t lane) const { return i * along + (first + lane) * across; }
};

// f(panel index, element index) for the numbers [first, end) of each line.
template <int N, class F> inline void each_element(const Place& p, size_t first, size_t end, const F& f) {
    for (size_t lane = 0; lane < p.lanes; ++lane)
        for (size_t i = first; i < end; ++i) f(i * N + lane, p.at(i, lane));
}

// Lines that lie along memory go through tiles as far as those reach.
template <int N> inline size_t in_tiles(const Place& p, size_t count) {
    return N == kTile && p.along == 1 && p.lanes == N ? count / kTile * kTile : 0;
}

template <int N, class T> void fetch(const Place& p, size_t count, const T* from, double* panel) {
    if (p.across == 1 && p.lanes == N) {
        for (size_t i = 0; i < count; ++i) Lanes<N>::load(from + p.at(i, 0)).store(panel + i * N);
        return;
    }
    const size_t tiled = in_tiles<N>(p, count);
    for (size_t i = 0; i < tiled; i += kTile) {
        Lanes<kTile> numbers[kTile];
        load_tile(from + p.at(i, 0), p.across, numbers);
        for (size_t k = 0; k < kTile; ++k) numbers[k].store(panel + (i + k) * N);
    }
    if (p.lanes < N) memset(panel, 0, count * N * sizeof(double));
    each_element<N>(p, tiled, count, [&](size_t in, size_t at) { panel[in] = double(from[at]); });
}

template <int N, class T> void put(const Place& p, size_t count, const double* panel, T* to) {
    if (p.across == 1 && p.lanes == N) {
        for (size_t i = 0; i < count; ++i) Lanes<N>::load(panel + i * N).store(to + p.at(i, 0));
        return;
    }
    const size_t tiled = in_tiles<N>(p, count);
    for (size_t i = 0; i < tiled; i += kTile) {
        Lanes<kTile> numbers[kTile];
        for (size_t k = 0; k < kTile; ++k) numbers[k] = Lanes<kTile>::load(panel + (i + k) * N);
        store_tile(numbers, to + p.at(i, 0), p.across);
    }
    each_element<N>(p, tiled, count, [&](size_t in, size_t at) { to[at] = T(panel[in]); });
}

// A number as it will be stored: 0 where it is too small. probe gets NaN for what is too large.
template <class T, int N> inline Lanes<N> settled_number(Lanes<N> a, Lanes<N>& probe) {
    probe = probe + 0.0 * (Limits<T>::to_overflow * a);
    return settled(a, double(Limits<T>::least));
}
template <int N, class T> void settle(size_t count, double* panel, Lanes<N>& probe) {
    for (size_t i = 0; i < count; ++i) settled_number<T>(Lanes<N>::load(panel + i * N), probe).store(panel + i * N);
}

// Depths as they will be stored, from the last cell of a line to the first. What rounding takes from a cell, the next
// wet one gets, and the other way round; what is left at the end goes back, until a cell is found that is as shallow as
// it takes. So a line that gains and loses nothing keeps its water to the last place of its shallowest cell.
template <int N, class T> struct Rounding;
template <int N> struct Rounding<N, double> {
    Lanes<N> operator()(Lanes<N> d) { return d; }
    template <class S> void hand_back(size_t, S*) {}
};
template <int N> struct Rounding<N, float> {
    using L = Lanes<N>;
    L owed{}, shallowest = L::splat(1e300); // of what is stored and wet

    static L deep(L d, L& owed) { // where all is deeper than what is owed
        const L exact = d + owed, stored = exact.template rounded_to<float>();
        owed = exact - stored;
        return stored;
    }
    L operator()(L d) {
        const L exact = d + owed, takes = select(d + (owed + owed), d, L{}); // > 0: wet, and deeper than what is owed
        const L stored = select(takes, exact, d).template rounded_to<float>();
        owed = select(takes, exact - stored, owed + (d - stored));
        shallowest = select(stored, smaller(stored, shallowest), shallowest);
        return stored;
    }
    template <class S> void hand_back(size_t cells, S* depth) {
        // Not where even the shallowest cell is too deep for it, as in most water.
        const L bit_more = (1 + 0x1p-20) * owed, d = shallowest;
        const L more = size_of((d + bit_more).template rounded_to<float>() - d);
        const L less = size_of((d - bit_more).template rounded_to<float>() - d);
        if (!any_positive(larger(more, less))) return;
        constexpr size_t kBlock = 16; // in which all lanes look for such a cell at once
        for (size_t first = 0; first < cells; first += kBlock) {
            const size_t end = first + kBlock < cells ? first + kBlock : cells;
            L takes{};
            for (size_t i = first; i < end; ++i) {
                const L here = L::load(depth + i * N);
                takes = larger(size_of((here + owed).template rounded_to<float>() - here), takes);
            }
            if (!any_positive(takes)) continue;
            const L before = owed; // of lanes in which none takes any, as they would be alone
            for (size_t i = first; i < end; ++i) {
                const L here = L::load(depth + i * N);
                select(takes, (*this)(here), here).store(depth + i * N);
            }
            owed = select(takes, owed, before);
            if (!any_positive(size_of(owed))) return;
        }
    }
};

// The state after a step, as it will be stored.
template <int N, class T> void settle_state(size_t cells, double* depth, double* velocity, Lanes<N>& probe) {
    Rounding<N, T> rounding;
    settle<N, T>(cells + 1, velocity, probe);
    for (size_t i = cells; i-- > 0;)
        rounding(settled_number<T>(Lanes<N>::load(depth + i * N), probe)).store(depth + i * N);
    rounding.hand_back(cells, depth);
}

// A bundle of a water's lines, between memory and panels.
template <class T> struct WaterBundles {
    const WaterAxis& axis;
    const WaterLines<T>& lines;
    double* work;

    template <int N> double* panel(size_t number) const { return work + number * (axis.cells + 2) * N; }
    template <int N> Place place_of(size_t first) const {
        const size_t left = lines.lines - first;
        return {lines.along, lines.across, first, left < N ? left : size_t(N)};
    }

    // A line with its places to work and what acts on it, but for its state. used: panels taken.
    template <int N> WaterLine<N> open_line(const Place& p, size_t& used) const {
        WaterLine<N> line{axis, axis.cells, axis.ring()};
        double** const panels[] = {&line.bed,  &line.depth,  &line.velocity, &line.face,  &line.start_face, &line.guess,
                                   &line.gain, &line.spring, &line.transfer, &line.after, &line.ground,     &line.x,
                                   &line.pull, &line.rest,   &line.share,    &line.stream};
        used = 0;
        for (double** one : panels) *one = panel<N>(used++);
        if (lines.mask || lines.wall || p.lanes < N) fetch_openings<N>(p, line.open = panel<N>(used++));
        return line;
    }
    template <int N> void fetch_state(const Place& p, WaterLine<N>& line, size_t used) const {
        const size_t n = axis.cells;
        if (lines.force || lines.pressure) fetch_push<N>(p, line.push = panel<N>(used++), line.x);
        fetch<N>(p, n, lines.bed, line.bed);
        fetch<N>(p, n, lines.depth, line.depth);
        fetch<N>(p, n + 1, lines.velocity, line.velocity);
    }
    template <int N> void put_tally(const Place& p, const WaterLine<N>& line) const {
        for (int t = 0; t < kTallies; ++t) {
            double sums[N];
            line.tally[t].store(sums);
            for (size_t k = 0; k < p.lanes; ++k) lines.tally[(p.first + k) * kTallies + size_t(t)] = sums[k];
        }
    }

    // What keeps water from crossing faces, 1 where nothing does.
    template <int N> void fetch_openings(const Place& p, double* open) const {
        const size_t n = axis.cells;
        const Place bytes{lines.byte_along, lines.byte_across, p.first, p.lanes};
        const auto there = [&](size_t i, size_t lane) { return !lines.mask || lines.mask[bytes.at(i, lane)] != 0; };
        for (size_t i = 0; i <= n; ++i)
            for (size_t lane = 0; lane < N; ++lane) {
                bool is_open = lane < p.lanes;
                if (is_open && (i > 0 || axis.ring())) is_open = there(i > 0 ? i - 1 : n - 1, lane);
                if (is_open && (i < n || axis.ring())) is_open = there(i < n ? i : 0, lane);
                const bool walled = lines.wall && ((i > 0 && i < n) || axis.ring());
                if (is_open && walled) is_open = lines.wall[bytes.at(i < n ? i : 0, lane)] == 0;
                open[i * N + lane] = is_open ? 1 : 0;
            }
    }

    // What forces and pressures add to velocities. pressure: scratch.
    template <int N> void fetch_push(const Place& p, double* push, double* pressure) const {
        using L = Lanes<N>;
        const size_t n = axis.cells;
        if (lines.force) fetch<N>(p, n + 1, lines.force, push);
        else memset(push, 0, (n + 1) * N * sizeof(double));
        for (size_t i = 0; i <= n && lines.force; ++i) (lines.force_share * L::load(push + i * N)).store(push + i * N);
        if (!lines.pressure) return;
        fetch<N>(p, n, lines.pressure, pressure);
        for (size_t i = axis.ring() ? 0 : 1; i < n; ++i) {
            const L rise = L::load(pressure + i * N) - L::load(pressure + (i > 0 ? i - 1 : n - 1) * N);
            (L::load(push + i * N) - lines.pressure_share * rise).store(push + i * N);
        }
        if (axis.ring()) L::load(push).store(push + n * N);
    }
};

// work.bundle<N>(its first line) for what lies in packs [first, first + count); whether all came out finite.
template <class Work> bool in_bundles(const Work& work, size_t lines, size_t first, size_t count) {
    if (lines == 1) return work.template bundle<1>(0);
    const size_t end = (first + count) * kWaterPack < lines ? (first + count) * kWaterPack : lines;
    bool finite = true;
    for (size_t line = first * kWaterPack; line < end; line += kWaterLanes)
        finite &= work.template bundle<int(kWaterLanes)>(line);
    return finite;
}

} // namespace CD_ISA
} // namespace cd
