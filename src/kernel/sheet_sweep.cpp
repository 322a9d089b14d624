// A stage of a uniform sheet in two passes over memory, where planes would be read and written a dozen times.
//
// Down: row by row what acts on the nodes, from a few rows of what springs look at; then, a block of rows at a time,
// while they are in the cache, the filters along them. Up: the filters along the columns, which began on the way down,
// and every node moves at once.
//
// What is left, with AVX-512 on a Zen 5: 3.6 cycles a node in the cache (looking at it, its right side and the filter
// down 1.3, the filters along rows 1.1, up and the move 1.2), 4.3 at 1024 nodes a side in float32, and 48 bytes to and
// from where plane and state lie, of which 16 are reading and writing the state. A step of a small sheet takes 130 ns
// whatever its size, half of that once a call, and of 10 x 10 nodes 220 ns more: rows are 16 nodes then and filters 16
// rows, each of which waits for the one before it.
//
// The same operations as gather, push_separable, pull_separable, filter_lines and move_nodes, and so the same bits.
#include "kernel/packed.hh"
#include "kernel/sheet_filters.hh"
#include "kernel/sheet_rows.hh"

namespace cd {
namespace CD_ISA {

namespace {

// Going up, and in strips, rows lie too far apart for processors to see them coming. So many rows ahead are fetched; 0
// where all stays in the cache.
inline size_t rows_ahead(const Grid& grid, size_t count) {
    constexpr size_t kFetched = 1536; // numbers
    if (!leaves_cache(grid)) return 0;
    return count < kFetched ? kFetched / count : 1;
}
// Nearly all of it is written too: asked for as such, what another thread wrote last comes over once and not twice.
template <class S> inline void fetch(const S* from, size_t count) {
    for (size_t i = 0; i < count; i += 64 / sizeof(S)) __builtin_prefetch(from + i, 1);
}

struct DownSweep {
    const StageRows rows;
    double* plane;

    void block(size_t row, size_t count) const {
        const Grid& grid = rows.grid;
        for (size_t r = row; r < row + count; ++r) {
            // on threads the plane was last written in strips, half of it by others
            if (!rows.stage.carries && r + 2 < rows.end) fetch(plane + (r + 2) * grid.pitch, grid.columns);
            if (r + 1 < rows.end) rows.look(r + 1, rows.at(r + 1));
            along_springs(grid.columns, rows.acting(r, plane + r * grid.pitch));
        }
        for (size_t i = 0; i < rows.stage.singles; ++i) {
            const size_t place = rows.stage.single[i];
            const bool here = place >= row * grid.pitch && place < (row + count) * grid.pitch;
            if (here && rows.stage.compliance[i] == 0) plane[place] = 0;
        }
        const double* const inverse_mass = rows.stage.sheet.inverse_mass[0];
        if (rows.stage.flatten) rows.stage.flatten(grid, inverse_mass, plane, row, count);
        filter_rows(grid, rows.stage.along_u, plane, row, count);
        if (rows.stage.flatten) rows.stage.flatten(grid, inverse_mass, plane, row, count);
        for (size_t r = row; r < row + count && rows.stage.carries; ++r)
            if (r > 0) along_whole_row(0, grid.columns, CarryDown(grid, rows.stage.along_v, plane, r));
    }
};

// On the way up: the filter, and then every node moves. All pointers to where a row starts.
template <class S, class T> struct MoveUp {
    bool first; // no row lies below
    double pull;
    const double* change;
    double of_row; // added to it all along the row
    double* below; // the answer there, and then here
    const S *x, *v;
    T *to_x, *to_v;
    bool settles;
    double overshoot, move;
    size_t ahead; // numbers back to what is fetched
    PlainProbe<T>& probe;

    template <class V> void bundles(size_t& u, size_t end) {
        constexpr int n = kCountOf<V, T>;
        V seen{};
        for (; u + size_t(n) <= end; u += size_t(n)) {
            if (ahead > 0) fetch(u, size_t(n));
            bundle<n>(u, seen);
        }
        probe.add(seen);
    }
    void fetch(size_t u, size_t count) const {
        for (size_t i = 0; i < count; i += 8) __builtin_prefetch(change + u + i - ahead, 1);
        __builtin_prefetch(x + u - ahead, 1);
        __builtin_prefetch(v + u - ahead, 1);
    }
    template <int N, class V> void bundle(size_t u, V& seen) {
        using L = Lanes<N>;
        L dw = L::load(change + u);
        if (!first) dw = between(dw, L::load(below + u), &pull);
        if (settles && !first) dw = settled(dw, Limits<double>::least);
        dw.store(below + u);
        dw = dw + L::splat(of_row);
        const L from = L::load(v + u), new_v = from + overshoot * dw, new_x = L::load(x + u) + move * (from + dw);
        put_settled(packed<V, T>(new_v), to_v + u, seen);
        put_settled(packed<V, T>(new_x), to_x + u, seen);
    }
};

} // namespace

void sweep_down(const Grid& grid, const UniformStage& stage, const StateNumbers& x, const StateNumbers& v,
                double* plane, double* looked, size_t first, size_t count) {
    const DownSweep sweep{{grid, stage, x, v, looked, first, first + count}, plane};
    sweep.rows.look_beyond();
    sweep.rows.look(first, sweep.rows.at(first));
    for (size_t done = 0; done < count; done += kBlock)
        sweep.block(first + done, count - done < kBlock ? count - done : kBlock);
}

template <class S, class T> static bool move_up(const Grid& grid, const SharedFilter& filter, const SheetMove& move,
                                                const double* of_row, const double* plane, double* below, const S* x,
                                                const S* v, T* to_x, T* to_v, size_t first, size_t count) {
    PlainProbe<T> probe; // of all rows: looking into it takes as long as a short one
    const size_t ahead = rows_ahead(grid, count);
    const size_t end = first + (count + kWidest - 1) / kWidest * kWidest; // see along_whole_row
    for (size_t r = grid.rows; r-- > 0;) {
        const size_t row = r * grid.pitch;
        MoveUp<S, T> step{r + 1 == grid.rows,
                          filter.pull[r],
                          plane + row,
                          of_row ? of_row[r] : 0,
                          below,
                          x + row,
                          v + row,
                          to_x + row,
                          to_v + row,
                          r % kSettleEvery == 0,
                          move.overshoot,
                          move.move,
                          ahead * grid.pitch,
                          probe};
        size_t u = first;
        step.template bundles<Wide<T>>(u, end);
        if constexpr (kCountOf < Wide<T>, T >> kWidest) step.template bundles<Half<T>>(u, end);
    }
    return probe.finite();
}

bool sweep_up(const Grid& grid, const SharedFilter& filter, bool carried, const SheetMove& move, const double* of_row,
              double* plane, double* below, const StateNumbers& x, const StateNumbers& v, const StateNumbers& to_x,
              const StateNumbers& to_v, size_t first, size_t count) {
    const size_t ahead = rows_ahead(grid, count);
    for (size_t r = 1; r < grid.rows && !carried; ++r) {
        if (ahead > 0 && r + ahead < grid.rows) fetch(plane + (r + ahead) * grid.pitch + first, count);
        along_whole_row(first, count, CarryDown(grid, filter, plane, r));
    }
    return x.stored([&](auto* from_x) {
        return to_x.stored([&](auto* into_x) {
            const auto from_v = static_cast<decltype(from_x)>(v.data);
            const auto into_v = static_cast<decltype(into_x)>(to_v.data);
            return move_up(grid, filter, move, of_row, plane, below, from_x, from_v, into_x, into_v, first, count);
        });
    });
}

} // namespace CD_ISA
} // namespace cd
