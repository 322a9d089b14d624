// Normals of the water's surface, of which no cell is absent, by its slopes from neighbour to neighbour.
#include "kernel/draw_rows.hh"

namespace cd {
namespace CD_ISA {

namespace {

using L = DrawnLanes;

// Cells before and behind one along an axis, or itself where there is none, and over what its slope is taken.
struct Neighbours {
    size_t before, behind;
    double run; // [m]
};
Neighbours neighbours(const DrawnWater& w, int axis, size_t at) {
    const size_t last = w.cells[axis] - 1;
    const bool first = at == 0 && !w.ring[axis], ends = at == last && !w.ring[axis];
    return {first    ? at
            : at > 0 ? at - 1
                     : last,
            ends        ? at
            : at < last ? at + 1
                        : 0,
            first || ends ? w.size[axis] : 2 * w.size[axis]};
}

// The surface from one cell before the block to one behind it.
struct Row {
    double level[kDrawnNumbers];
};

struct Drawer {
    const DrawnWater& w;
    const DrawnBlock& b;

    double level_at(size_t i, size_t j) const { return w.bed[j * w.pitch + i] + w.depth[j * w.pitch + i]; }
    void take_row(size_t j, Row& row) const {
        double bed[kDrawnNumbers] = {};
        const size_t at = j * w.pitch + b.column;
        take_numbers(w.bed, at, b.count, bed);
        take_numbers(w.depth, at, b.count, row.level + 1);
        for (size_t c = 0; c < b.count; c += kDrawnWide)
            (L::load(bed + c) + L::load(row.level + 1 + c)).store(row.level + 1 + c);
    }
    // The normals of row j; whether all are in range.
    bool write(size_t j, const Row& low, Row& row, const Row& high, unsigned char* out) const {
        const size_t last = b.column + b.count - 1;
        const Neighbours left = neighbours(w, 0, b.column), right = neighbours(w, 0, last);
        row.level[0] = level_at(left.before, j), row.level[b.count + 1] = level_at(right.behind, j);
        double run[kDrawnNumbers];
        for (size_t c = 0; c < b.count; c += kDrawnWide) L::splat(2 * w.size[0]).store(run + c);
        run[0] = left.run, run[b.count - 1] = right.run;
        const L across = L::splat(neighbours(w, 1, j).run);
        bool in_range = true;
        for (size_t c = 0; c < b.count; c += kDrawnWide) {
            const L x = (L::load(&row.level[c + 2]) - L::load(&row.level[c])) / L::load(run + c);
            const L y = (L::load(&high.level[c + 1]) - L::load(&low.level[c + 1])) / across;
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
    Row rows[3] = {}; // the row's own, that before it, and that behind
    Row *low = &rows[0], *row = &rows[1], *high = &rows[2];
    drawer.take_row(neighbours(w, 1, b.first).before, *low);
    drawer.take_row(b.first, *row);
    for (size_t j = b.first; j < b.end; ++j) {
        drawer.take_row(neighbours(w, 1, j).behind, *high);
        if (!drawer.write(j, *low, *row, *high, b.out + (j - b.first) * w.cells[0] * b.stride)) return j - b.first;
        Row* const next = high;
        high = low, low = row, row = next;
    }
    return b.end - b.first;
}

} // namespace CD_ISA
} // namespace cd
