// A stage of a uniform sheet in two passes over memory, where planes would be read and written a dozen times.
//
// Down: row by row what acts on the nodes, from a few rows of what springs look at; then, a block of rows at a time,
// while they are in the cache, the filters along them. For these a tile of N x N numbers is turned over in registers,
// so that lanes are rows, and put down as it lies, turned, in its own place; on the way back along the rows it is
// turned back. Up: the filters along the columns, which began on the way down, and every node moves at once.
//
// The same operations as gather, push_separable, pull_separable, filter_lines and move_nodes, and so the same bits.
#include "kernel/line_lanes.hh"
#include "kernel/sheet_rows.hh"
#include "kernel/tile.hh"

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

template <class S, class T> struct DownSweep {
    const StageRows<S, T> rows;
    double* plane;

    // Filters `count` rows from `row` on, N side by side and kBlock / N times that at once, since each waits for itself.
    template <int N> void filter(size_t row, size_t count) const {
        const Grid& grid = rows.grid;
        const UniformStage<T>& stage = rows.stage;
        Lanes<N> moving[kBlock / N]{};
        const size_t bundles = count / size_t(N), tiles = (grid.columns + size_t(N) - 1) / size_t(N);
        const size_t pitch = grid.pitch;
        const double *const carry = stage.along_u.carry, *const pull = stage.along_u.pull;
        double* const to = plane + row * pitch;
        const auto settles = [](size_t tile) { return tile * size_t(N) % kSettleEvery == 0; };
        for (size_t t = 0; t < tiles; ++t)
            for (size_t k = 0; k < bundles; ++k)
                forward(to + k * size_t(N) * pitch + t * size_t(N), pitch, carry + t * size_t(N), settles(t),
                        moving[k]);
        for (Lanes<N>& lanes : moving) lanes = Lanes<N>{};
        for (size_t t = tiles; t-- > 0;)
            for (size_t k = 0; k < bundles; ++k)
                back(to + k * size_t(N) * pitch + t * size_t(N), pitch, pull + t * size_t(N), settles(t), moving[k]);
    }

    void block(size_t row, size_t count) const {
        const Grid& grid = rows.grid;
        for (size_t r = row; r < row + count; ++r) {
            if (r + 1 < rows.end) rows.look(r + 1, rows.at(r + 1));
            double* const to = plane + r * grid.pitch;
            along_row(0, grid.columns, rows.acting(r, to));
            for (size_t u = grid.columns; u % size_t(kNative) != 0; ++u) to[u] = 0; // in the last tile
        }
        const size_t whole = count - count % size_t(kNative);
        if (whole > 0) filter<kNative>(row, whole);
        if (whole < count) filter<1>(row + whole, count - whole);
        for (size_t r = row; r < row + count && rows.stage.carries; ++r)
            if (r > 0) along_row(0, grid.columns, CarryDown(grid, rows.stage.along_v, plane, r));
    }
};

// On the way up: the filter, and then every node moves. All pointers to where a row starts.
template <class S, class T> struct MoveUp {
    bool first; // no row lies below
    double pull;
    const double* change;
    double* below; // the answer there, and then here
    const S *x, *v;
    T *to_x, *to_v;
    bool settles;
    double overshoot, move;
    Probe probe{};

    template <int N> void bundle(size_t u) {
        using L = Lanes<N>;
        L dw = L::load(change + u);
        if (!first) dw = between(dw, L::load(below + u), &pull);
        if (settles && !first) dw = settled(dw, Limits<double>::least);
        dw.store(below + u);
        const L from = L::load(v + u), new_v = from + overshoot * dw, new_x = L::load(x + u) + move * (from + dw);
        store_settled(new_v, to_v + u, probe.of<N>());
        store_settled(new_x, to_x + u, probe.of<N>());
    }
};

} // namespace

template <class S, class T> void sweep_down(const Grid& grid, const UniformStage<T>& stage, const S* x, const S* v,
                                            double* plane, double* looked, size_t first, size_t count) {
    const DownSweep<S, T> sweep{{grid, stage, x, v, looked, first, first + count}, plane};
    sweep.rows.look_beyond();
    sweep.rows.look(first, sweep.rows.at(first));
    for (size_t done = 0; done < count; done += kBlock)
        sweep.block(first + done, count - done < kBlock ? count - done : kBlock);
}

template <class S, class T> bool sweep_up(const Grid& grid, const SharedFilter& filter, bool carried,
                                          const SheetMove& move, double* plane, double* below, const S* x, const S* v,
                                          T* to_x, T* to_v, size_t first, size_t count) {
    bool finite = true;
    for (size_t r = 1; r < grid.rows && !carried; ++r) along_row(first, count, CarryDown(grid, filter, plane, r));
    for (size_t r = grid.rows; r-- > 0;) {
        const size_t row = r * grid.pitch;
        MoveUp<S, T> step{r + 1 == grid.rows, filter.pull[r], plane + row,           below,          x + row,  v + row,
                          to_x + row,         to_v + row,     r % kSettleEvery == 0, move.overshoot, move.move};
        along_row(first, count, step);
        finite &= step.probe.finite();
    }
    return finite;
}

#define CD_DOWN(S, T) \
    template void sweep_down(const Grid&, const UniformStage<T>&, const S*, const S*, double*, double*, size_t, size_t);
#define CD_UP(S, T)                                                                                              \
    template bool sweep_up(const Grid&, const SharedFilter&, bool, const SheetMove&, double*, double*, const S*, \
                           const S*, T*, T*, size_t, size_t);
#if CD_WITH_FLOAT32
CD_DOWN(float, float)
CD_DOWN(double, float)
CD_UP(float, float)
CD_UP(float, double)
CD_UP(double, float)
#endif
#if CD_WITH_FLOAT64
CD_DOWN(double, double)
CD_UP(double, double)
#endif

} // namespace CD_ISA
} // namespace cd
