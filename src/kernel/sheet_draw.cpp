// Normals of sheets' nodes, of whole cells: the sums of the cells' area vectors, made unit vectors.
#include <math.h>

#include "kernel/draw_rows.hh"

namespace cd {
namespace CD_ISA {

namespace {

using L = DrawnLanes;

// Positions from one node before the block to one behind it. What is not there counts as 0, as do components that are
// not drawn.
struct Row {
    double x[3][kDrawnNumbers];
};
// Of the cells between two rows, from the one before the block's first node on: twice their area vectors, and the sizes
// of all products in these.
struct Cells {
    double sum[3][kDrawnNumbers], size[3][kDrawnNumbers];
};

struct Drawer {
    const DrawnSheet& s;
    const DrawnBlock& b;

    bool is_first() const { return b.column == 0; }
    bool is_last() const { return b.column + b.count == s.columns; }

    void take_row(size_t v, Row& row) const {
        const size_t from = is_first() ? 1 : 0, end = b.count + (is_last() ? 1 : 2);
        for (int k = 0; k < 3; ++k)
            if (s.axis[k]) take_numbers(s.axis[k], v * s.pitch + (b.column + from - 1), end - from, row.x[k] + from);
    }
    void look_at_cells(const Row& low, const Row& high, Cells& cells) const {
        const auto at = [](const double* numbers) { return L::load(numbers); };
        for (size_t c = 0; c <= b.count; c += kDrawnWide) {
            L p[3], q[3]; // of each cell the diagonals from its first corner on, and from its second
            for (int k = 0; k < 3; ++k) {
                const double along = s.axis[k] ? 0 : s.spacing[k];
                p[k] = (at(&high.x[k][c + 1]) - at(&low.x[k][c])) + L::splat(along);
                q[k] = (at(&high.x[k][c]) - at(&low.x[k][c + 1])) + L::splat(k == 0 ? -along : along);
            }
            for (int k = 0; k < 3; ++k) {
                const int i = (k + 1) % 3, j = (k + 2) % 3;
                const L plus = p[i] * q[j], minus = p[j] * q[i];
                (plus - minus).store(&cells.sum[k][c]);
                (size_of(plus) + size_of(minus)).store(&cells.size[k][c]);
            }
        }
        for (int k = 0; k < 3; ++k) {
            if (is_first()) cells.sum[k][0] = cells.size[k][0] = 0;
            if (is_last()) cells.sum[k][b.count] = cells.size[k][b.count] = 0;
        }
    }
    // The normals between two rows of cells; whether all are in range.
    bool write(const Cells& above, const Cells& below, unsigned char* out) const {
        const auto both = [](const double* a, const double* b) { // of the cells on the left, and on the right
            return (L::load(a) + L::load(b)) + (L::load(a + 1) + L::load(b + 1));
        };
        bool in_range = true;
        for (size_t c = 0; c < b.count; c += kDrawnWide) {
            L n[3], whole{};
            for (int k = 0; k < 3; ++k) {
                const L sum = both(&above.sum[k][c], &below.sum[k][c]),
                        size = both(&above.size[k][c], &below.size[k][c]);
                n[k] = select(size_of(sum) - kRoundedArea * size, sum, L{});
                whole = whole + size;
            }
            const L square = (n[0] * n[0] + n[1] * n[1]) + n[2] * n[2], scale = L::splat(1) / root(square);
            for (L& along : n) along = along * scale;
            const L finite = select(L::splat(INFINITY) - whole, L::splat(1), L{});
            const L good =
                select(square - L::splat(kLeastSquare), select(L::splat(kMostSquare) - square, finite, L{}), L{});
            in_range &= put_normals(n, good, c, b, out);
        }
        return in_range;
    }
};

} // namespace

// Row by row, so that each row of cells is looked at once for the nodes before it and behind.
size_t draw_sheet(const DrawnSheet& s, const DrawnBlock& b) {
    const Drawer drawer{s, b};
    Row rows[2] = {};
    Cells cells[2] = {}; // before a row of nodes and behind it, in turn
    drawer.take_row(b.first, rows[b.first % 2]);
    if (b.first > 0) {
        const size_t now = b.first % 2, last = 1 - now;
        drawer.take_row(b.first - 1, rows[last]);
        drawer.look_at_cells(rows[last], rows[now], cells[now]);
    }
    for (size_t v = b.first; v < b.end; ++v) {
        const size_t now = v % 2, next = 1 - now;
        if (v + 1 < s.rows) {
            drawer.take_row(v + 1, rows[next]);
            drawer.look_at_cells(rows[now], rows[next], cells[next]);
        } else cells[next] = {};
        if (!drawer.write(cells[now], cells[next], b.out + (v - b.first) * s.columns * b.stride)) return v - b.first;
    }
    return b.end - b.first;
}

} // namespace CD_ISA
} // namespace cd
