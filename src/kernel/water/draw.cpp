// Normals of the water's surface, of which no cell is absent, by its slopes from neighbour to neighbour.
#include "kernel/draw_rows.hh"
#include "kernel/water/sweep.hh"

namespace cd {
namespace CD_ISA {

namespace {

using L = DrawnLanes;

// The surface from one cell before the block to one behind it.
using Row = double[kDrawnNumbers];

struct Drawer {
    const DrawnWater& w;
    const DrawnBlock& b;

    Neighbours cells(int axis) const { return {w.cells[axis], w.ring[axis]}; }
    // Over what the slope at a cell is taken [m].
    double run(int axis, size_t at) const {
        const Neighbours beside = cells(axis);
        return (beside.before(at) != at && beside.behind(at) != at ? 2 : 1) * w.size[axis];
    }
    double level_at(size_t i, size_t j) const { return w.bed[j * w.pitch + i] + w.depth[j * w.pitch + i]; }
    void take_row(size_t j, Row& row) const {
        double bed[kDrawnNumbers] = {};
        const size_t at = j * w.pitch + b.column;
        take_numbers(w.bed, at, b.count, bed);
        take_numbers(w.depth, at, b.count, row + 1);
        for (size_t c = 0; c < b.count; c += kDrawnWide) (L::load(bed + c) + L::load(row + 1 + c)).store(row + 1 + c);
    }
    // The normals of row j; whether all are in range.
    bool write(size_t j, const Row& low, Row& row, const Row& high, unsigned char* out) const {
        const size_t last = b.column + b.count - 1;
        row[0] = level_at(cells(0).before(b.column), j);
        row[b.count + 1] = level_at(cells(0).behind(last), j);
        double along[kDrawnNumbers];
        for (size_t c = 0; c < b.count; c += kDrawnWide) L::splat(2 * w.size[0]).store(along + c);
        along[0] = run(0, b.column), along[b.count - 1] = run(0, last);
        const L across = L::splat(run(1, j));
        bool in_range = true;
        for (size_t c = 0; c < b.count; c += kDrawnWide) {
            const L x = (L::load(&row[c + 2]) - L::load(&row[c])) / L::load(along + c);
            const L y = (L::load(&high[c + 1]) - L::load(&low[c + 1])) / across;
            const L square = (x * x + y * y) + L::splat(1), scale = L::splat(1) / root(square);
            const L n[3] = {L{} - x * scale, L{} - y * scale, scale};
            in_range &= put_normals(n, select(L::splat(kMostSquare) - square, L::splat(1), L{}), c, b, out);
        }
        return in_range;
    }
};

} // namespace

size_t draw_water(const DrawnWater& w, const DrawnBlock& b) {
    const Drawer drawer{w, b};
    Row rows[3] = {}; // j's is number j % 3, that before it j + 2, and that behind j + 1
    const Neighbours lines = drawer.cells(1);
    drawer.take_row(lines.before(b.first), rows[(b.first + 2) % 3]);
    drawer.take_row(b.first, rows[b.first % 3]);
    for (size_t j = b.first; j < b.end; ++j) {
        drawer.take_row(lines.behind(j), rows[(j + 1) % 3]);
        unsigned char* const out = b.out + (j - b.first) * w.cells[0] * b.stride;
        if (!drawer.write(j, rows[(j + 2) % 3], rows[j % 3], rows[(j + 1) % 3], out)) return j - b.first;
    }
    return b.end - b.first;
}

} // namespace CD_ISA
} // namespace cd
