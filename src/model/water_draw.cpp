// The water as triangles between the centres of its cells, on its surface, which is the bed where it is dry. Slopes are
// those from neighbour to neighbour, and to the one that is there where there is but one.
#include "model/draw.hh"
#include "model/water.hh"

namespace cd {

namespace {

double surface_at(const Water& w, size_t i, size_t j) { return bed_at(w, i, j) + depth_at(w, i, j); }

// Beside cell `at` of a line along an axis, before it or behind; round a periodic side too.
bool has_neighbour(const Water& w, Axis a, size_t at, bool behind) {
    return periodic(w, a) || at != (behind ? w.cells[a] - 1 : 0);
}
size_t neighbour(const Water& w, Axis a, size_t at, bool behind) { // or itself
    const size_t n = w.cells[a];
    if (!has_neighbour(w, a, at, behind)) return at;
    return behind ? (at + 1 < n ? at + 1 : 0) : (at > 0 ? at : n) - 1;
}

// How much the surface rises along an axis at a cell.
double slope_at(const Water& w, Axis a, size_t i, size_t j) {
    const size_t at = a == kX ? i : j;
    double ends[2];
    int steps = 0;
    for (bool behind : {false, true}) {
        double& end = ends[behind];
        end = surface_at(w, i, j);
        if (!has_neighbour(w, a, at, behind)) continue;
        const size_t next = neighbour(w, a, at, behind), x = a == kX ? next : i, y = a == kX ? j : next;
        if (!present(w, x, y)) continue;
        end = surface_at(w, x, y);
        ++steps;
    }
    return steps > 0 ? (ends[1] - ends[0]) / (steps * w.size[a]) : 0;
}

// Likewise of a line's cells side by side, of water without absent cells, and the normals that slopes make.
constexpr size_t kNormals = 64;
struct Normals {
    const Water& w;
    double slope[2][kNormals], square[kNormals], scale[kNormals];

    // Over what slopes are taken: two cells, one at a side, or any length where there is no neighbour.
    double run(Axis a, size_t at) const {
        return has_neighbour(w, a, at, false) && has_neighbour(w, a, at, true) ? 2 * w.size[a] : w.size[a];
    }

    // At `count` cells from (i, j) on, at most kNormals.
    void look(size_t i, size_t j, size_t count) {
        double along[kNormals + 2], rise[2][kNormals] = {}, by[kNormals] = {};
        const size_t low = neighbour(w, kY, j, false), high = neighbour(w, kY, j, true);
        for (size_t c = 0; c < count; ++c) {
            along[c + 1] = surface_at(w, i + c, j);
            rise[kY][c] = surface_at(w, i + c, high) - surface_at(w, i + c, low);
            by[c] = 2 * w.size[kX];
        }
        along[0] = surface_at(w, neighbour(w, kX, i, false), j);
        along[count + 1] = surface_at(w, neighbour(w, kX, i + count - 1, true), j);
        by[0] = run(kX, i), by[count - 1] = run(kX, i + count - 1);
        for (size_t c = 0; c < count; ++c) rise[kX][c] = along[c + 2] - along[c];
        const double by_y = run(kY, j);
        in_groups(count, [&](size_t c) {
            slope[kX][c] = rise[kX][c] / by[c];
            slope[kY][c] = rise[kY][c] / by_y;
            square[c] = (slope[kX][c] * slope[kX][c] + slope[kY][c] * slope[kY][c]) + 1;
        });
        in_groups(count, [&](size_t c) { scale[c] = 1 / sqrt(square[c]); });
    }
    Vector operator[](size_t c) const {
        if (!(square[c] < 0x1p900)) return cd::normal_of(slope[kX][c], slope[kY][c]);
        return {0 - slope[kX][c] * scale[c], 0 - slope[kY][c] * scale[c], scale[c]};
    }
};

void put(double number, unsigned char* out) {
    const float one = float(number);
    memcpy(out, &one, sizeof one);
}

DrawnLattice drawn(const Water& w) { return {w.cells[kX], w.cells[kY], {w.cells[kX] - 1, w.cells[kY] - 1}}; }

// f(whether a vertex is there, whether a square of such vertices is drawn), of which more often than not all are
template <class F> auto with_squares(const Water& w, bool skip_dry, F f) {
    const size_t columns = w.cells[kX];
    const auto is_there = [&w, columns](size_t n) { return !w.mask || present(w, n % columns, n / columns); };
    const auto is_drawn = [&w, columns, skip_dry](const size_t* corner, int corners) {
        bool wet = !skip_dry;
        for (int c = 0; c < corners && !wet; ++c) wet = depth_at(w, corner[c] % columns, corner[c] / columns) > 0;
        return wet;
    };
    return f(is_there, is_drawn);
}

} // namespace

void write_vertices(const Water& w, unsigned char* out, const WaterVertexFormat& format) {
    Normals normals{w, {}, {}, {}};
    const bool has_normals = format.normal_offset != SIZE_MAX, together = has_normals && !w.mask;
    each_cell(w, [&](size_t i, size_t j) {
        const size_t left = w.cells[kX] - i, at = i % kNormals;
        if (together && at == 0) normals.look(i, j, left < kNormals ? left : kNormals);
        const bool there = present(w, i, j);
        put({(double(i) + 0.5) * w.size[kX], (double(j) + 0.5) * w.size[kY], surface_at(w, i, j)},
            out + format.position_offset);
        if (has_normals)
            put(together ? normals[at]
                : there  ? normal_of(slope_at(w, kX, i, j), slope_at(w, kY, i, j))
                         : Vector{0, 0, 1},
                out + format.normal_offset);
        if (format.depth_offset != SIZE_MAX) put(there ? depth_at(w, i, j) : -1, out + format.depth_offset);
        out += format.stride;
    });
}

size_t index_count(const Water& w, bool skip_dry) {
    const DrawnLattice lattice = drawn(w);
    if (!w.mask && !skip_dry) return 6 * lattice.cells[kX] * lattice.cells[kY];
    return with_squares(w, skip_dry,
                        [&](auto is_there, auto is_drawn) { return index_count(lattice, is_there, is_drawn); });
}

void write_indices(const Water& w, bool skip_dry, unsigned char* out, size_t index_size) {
    with_squares(w, skip_dry,
                 [&](auto is_there, auto is_drawn) { write_indices(drawn(w), is_there, out, index_size, is_drawn); });
}

} // namespace cd
