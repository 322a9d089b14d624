// The filters of lines that share one factorization (solve/spring_line.hh), along rows and columns of a plane.
//
// Along rows a tile of N x N numbers is turned over in registers, so that lanes are rows, and put down as it lies,
// turned, in its own place; on the way back along the rows it is turned back.
#pragma once

#include "kernel/line_lanes.hh"
#include "kernel/sheet.hh"
#include "kernel/tiles.hh"

namespace cd {
namespace CD_ISA {

namespace {

constexpr size_t kBlock = 32; // rows, at the most, that are filtered side by side

struct CarryDown {
    double carry;
    double* row;
    size_t pitch;
    bool settles;

    CarryDown(const Grid& grid, const SharedFilter& filter, double* plane, size_t r)
        : carry(filter.carry[r]), row(plane + r * grid.pitch), pitch(grid.pitch), settles(r % kSettleEvery == 0) {}

    template <int N> void bundle(size_t u) const {
        using L = Lanes<N>;
        const L sum = between(L::load(row + u), L::load(row + u - pitch), &carry);
        (settles ? settled(sum, Limits<double>::least) : sum).store(row + u);
    }
};

// N rows of N numbers turned over.
template <int N> inline void turn_tile(Lanes<N>* tile) {
    if constexpr (N > 1) {
        typename Square<double>::Row rows[N];
        for (int i = 0; i < N; ++i) rows[i] = tile[i].v;
        Square<double>::turn(rows);
        for (int i = 0; i < N; ++i) tile[i].v = rows[i];
    }
}

// A tile on its way along the rows. moving: the rows' numbers before the tile, in, and its last ones, out.
template <int N> inline void forward(double* to, size_t pitch, const double* carry, bool settles, Lanes<N>& moving) {
    Lanes<N> tile[N], last = moving;
#pragma GCC unroll 8
    for (size_t i = 0; i < size_t(N); ++i) tile[i] = Lanes<N>::load(to + i * pitch);
    turn_tile<N>(tile);
#pragma GCC unroll 8
    for (size_t i = 0; i < size_t(N); ++i) {
        last = between(tile[i], last, carry + i);
        if (i == 0 && settles) last = settled(last, Limits<double>::least);
        last.store(to + i * pitch);
    }
    moving = last;
}
// And back. moving: those after the tile, in, and its first ones, out.
template <int N> inline void back(double* to, size_t pitch, const double* pull, bool settles, Lanes<N>& moving) {
    Lanes<N> tile[N], last = moving;
#pragma GCC unroll 8
    for (size_t left = 0; left < size_t(N); ++left) {
        const size_t i = size_t(N) - 1 - left;
        last = between(Lanes<N>::load(to + i * pitch), last, pull + i);
        if (i == 0 && settles) last = settled(last, Limits<double>::least);
        tile[i] = last;
    }
    moving = last;
    turn_tile<N>(tile);
#pragma GCC unroll 8
    for (size_t i = 0; i < size_t(N); ++i) tile[i].store(to + i * pitch);
}

// Filters `count` <= kBlock rows from `row` on, N side by side and as many times that at once as there are, since each
// waits for itself.
template <int N>
inline void filter_bundles(const Grid& grid, const SharedFilter& filter, double* plane, size_t row, size_t count) {
    Lanes<N> moving[kBlock / N]{};
    const size_t bundles = count / size_t(N), tiles = (grid.columns + size_t(N) - 1) / size_t(N), pitch = grid.pitch;
    double* const to = plane + row * pitch;
    const auto settles = [](size_t tile) { return tile * size_t(N) % kSettleEvery == 0; };
    for (size_t t = 0; t < tiles; ++t)
        for (size_t k = 0; k < bundles; ++k)
            forward(to + (k * pitch + t) * size_t(N), pitch, filter.carry + t * size_t(N), settles(t), moving[k]);
    for (Lanes<N>& lanes : moving) lanes = Lanes<N>{};
    for (size_t t = tiles; t-- > 0;)
        for (size_t k = 0; k < bundles; ++k)
            back(to + (k * pitch + t) * size_t(N), pitch, filter.pull + t * size_t(N), settles(t), moving[k]);
}
// Rows of a plane with room for all of filtered_rows. What lies beyond their ends in the last tiles must be finite.
inline void filter_rows(const Grid& grid, const SharedFilter& filter, double* plane, size_t row, size_t count) {
    if (row + count == grid.rows) count = grid.filtered_rows() - row;
    const size_t whole = count - count % size_t(kNative);
    if (whole > 0) filter_bundles<kNative>(grid, filter, plane, row, whole);
    if (whole < count) filter_bundles<1>(grid, filter, plane, row + whole, count - whole);
}

} // namespace

} // namespace CD_ISA
} // namespace cd
