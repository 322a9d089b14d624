// How much the tiles of a water stir: see water_sleep.hh.
#include "base/parallel.hh"
#include "model/water.hh"

namespace cd {

namespace {

constexpr double kEndless = 1e300; // [m]: a bed that no water reaches
constexpr size_t kSideBySide = 4;
using Cells = Lanes<kSideBySide>;
Cells cells(const double* from) { return Cells::load(from); }

// A row of a tile, and of the cells before it and below.
struct RowOfTile {
    double bed[kTile + 1], surface[kTile + 1], head[kTile + 1]; // [0]: of the cell before the first

    // No cell, as if the bed were endlessly high.
    void clear(size_t k) { bed[k] = surface[k] = head[k] = kEndless; }
};

// Of the cells of a tile, column by column.
struct ColumnsOfTile {
    double stir[kTile] = {}, deepest[kTile] = {}, fastest[kTile] = {};
};

struct Survey {
    const Water& w;
    const StateNumbers depth = state_of(w, w.depth), bed = state_of(w, w.bed), pressure = state_of(w, w.pressure);
    const StateNumbers velocity[2] = {state_of(w, w.velocity[kX]), state_of(w, w.velocity[kY])};
    const StateNumbers acting[3] = {state_of(w, w.source), state_of(w, w.force[kX]), state_of(w, w.force[kY])};
    const double by_rise = w.gravity * double(kTile * kTile);
    const double by_pressure = w.gravity > 0 ? 1 / (w.density * w.gravity) : 0;

    static Cells stored(StateNumbers numbers, size_t at) {
        return numbers.stored_state([at](auto* from) { return Cells::load(from + at); });
    }
    // The line of cells before line k of an axis; SIZE_MAX: there is none.
    size_t before(Axis a, size_t k) const { return k > 0 ? k - 1 : periodic(w, a) ? w.cells[a] - 1 : SIZE_MAX; }
    // Cells [i, i + n) of a line j, into the row from k on.
    void fetch(size_t i, size_t n, size_t j, RowOfTile& row, size_t k) const {
        const size_t at = place(w, i, j);
        size_t c = 0;
        for (; c + kSideBySide <= n; c += kSideBySide) {
            const Cells b = stored(bed, at + c), s = b + stored(depth, at + c);
            b.store(row.bed + k + c), s.store(row.surface + k + c), s.store(row.head + k + c);
        }
        for (; c < n; ++c) {
            row.bed[k + c] = bed[at + c];
            row.head[k + c] = row.surface[k + c] = row.bed[k + c] + depth[at + c];
        }
        for (c = 0; pressure && c < n; ++c) row.head[k + c] += by_pressure * pressure[at + c];
        for (c = 0; w.mask && c < n; ++c)
            if (!present(w, i + c, j)) row.clear(k + c);
    }
    void fetch(size_t first, size_t columns, size_t j, RowOfTile& row) const {
        const size_t i = before(kX, first);
        const bool none = j == SIZE_MAX;
        for (size_t k = none ? 1 : columns + 1; k <= kTile; ++k) row.clear(k);
        if (none || i == SIZE_MAX) row.clear(0);
        if (none) return;
        if (i != SIZE_MAX) fetch(i, 1, j, row, 0);
        fetch(first, columns, j, row, 1);
    }
    // Of faces of an axis between the cells l[from + k] and r[k + 1] of two rows, or of one. Those from (i, j) on.
    void faces(Axis a, size_t i, size_t j, size_t columns, const RowOfTile& l, size_t from, const RowOfTile& r,
               ColumnsOfTile& most) const {
        double u[kTile] = {};
        const size_t at = place(w, i, j);
        size_t k = 0;
        for (; k + kSideBySide <= columns; k += kSideBySide) stored(velocity[a], at + k).store(u + k);
        for (; k < columns; ++k) u[k] = velocity[a][at + k];
        double closed[kTile] = {};
        for (k = 0; w.wall[a] && k < columns; ++k)
            if (w.wall[a][byte_place(w, i + k, j)] != 0) closed[k] = kEndless;
        const Cells least = Cells::splat(w.sleep);
        for (k = 0; k < kTile; k += kSideBySide) {
            const Cells deep = larger(cells(l.surface + from + k), cells(r.surface + k + 1)) -
                               larger(cells(l.bed + from + k), cells(r.bed + k + 1));
            const Cells rise = cells(r.head + k + 1) - cells(l.head + from + k), speed = size_of(cells(u + k));
            const Cells stir = larger(by_rise * (rise * rise), deep * (speed * speed));
            larger(select((deep - least) - cells(closed + k), stir, Cells{}), cells(most.stir + k))
                .store(most.stir + k);
            larger(speed, cells(most.fastest + k)).store(most.fastest + k);
        }
    }

    // The faces before and below each cell of a tile, and what the cells hold.
    TileStir tile(size_t x, size_t y) const {
        const size_t first_x = x * kTile, first_y = y * kTile;
        const size_t columns = first_x + kTile < w.cells[kX] ? kTile : w.cells[kX] - first_x;
        const size_t end_y = first_y + kTile < w.cells[kY] ? first_y + kTile : w.cells[kY];
        RowOfTile rows[2];
        ColumnsOfTile most;
        bool acts = false;
        fetch(first_x, columns, before(kY, first_y), rows[(first_y + 1) % 2]);
        for (size_t j = first_y; j < end_y; ++j) {
            RowOfTile& here = rows[j % 2];
            fetch(first_x, columns, j, here);
            faces(kX, first_x, j, columns, here, 0, here, most);
            faces(kY, first_x, j, columns, rows[(j + 1) % 2], 1, here, most);
            for (size_t k = 0; k < kTile; k += kSideBySide)
                larger(cells(here.surface + k + 1) - cells(here.bed + k + 1), cells(most.deepest + k))
                    .store(most.deepest + k);
            for (const StateNumbers& field : acting)
                for (size_t k = 0; field && k < columns; ++k) acts |= field[place(w, first_x + k, j)] != 0;
        }
        TileStir all{acts ? stir_of_acting(w) : 0, 0, 0};
        for (size_t k = 0; k < kTile; ++k) all.add({most.stir[k], most.deepest[k], most.fastest[k]});
        return all;
    }
};

// Looks at tiles that `wanted(x, y)` holds for.
template <class Wanted> void survey(const Water& w, Wanted wanted) {
    const Survey all{w};
    auto row = [&](size_t y) {
        for (size_t x = 0; x < w.tiles.count[kX]; ++x)
            if (wanted(x, y)) w.tiles.stir[w.tiles.at(kX, x, y)] = all.tile(x, y);
    };
    parallel_for(w.parallel, w.tiles.count[kY], row);
}

} // namespace

void survey_marked(const Water& w, uint8_t mark) {
    const WaterTiles& tiles = w.tiles;
    const auto marked = [&](size_t x, size_t y) { return (tiles.marks[tiles.at(kX, x, y)] & mark) != 0; };
    survey(w, [&](size_t x, size_t y) {
        const size_t x_before = x > 0 ? x - 1 : tiles.count[kX] - 1, y_before = y > 0 ? y - 1 : tiles.count[kY] - 1;
        return marked(x, y) || marked(x_before, y) || marked(x, y_before);
    });
}

} // namespace cd
