// The water as triangles between the centres of its cells, on its surface, which is the bed where it is dry. Slopes are
// those from neighbour to neighbour, and to the one that is there where there is but one.
#include "kernel/draw.hh"

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

static void write_positions(const Water& w, unsigned char* out, size_t stride) {
    state_of(w, w.depth).stored_state([&](const auto* depth) {
        const auto* const bed = reinterpret_cast<decltype(depth)>(w.bed.data);
        each_cell(w, [&](size_t i, size_t j) {
            const size_t at = place(w, i, j);
            put({(double(i) + 0.5) * w.size[kX], (double(j) + 0.5) * w.size[kY], double(bed[at]) + double(depth[at])},
                out);
            out += stride;
        });
    });
}
// In blocks of columns; where a cell is absent, and in rows with a normal beyond range, cell by cell.
static void write_normals(const Water& w, unsigned char* out, size_t stride) {
    const DrawnWater water{state_of(w, w.depth),       state_of(w, w.bed),
                           {w.cells[kX], w.cells[kY]}, w.pitch,
                           {w.size[kX], w.size[kY]},   {periodic(w, kX), periodic(w, kY)}};
    const size_t columns = w.cells[kX], rows = w.cells[kY];
    for (size_t i = 0, count; i < columns; i += count) {
        count = columns - i < kDrawnTogether ? columns - i : kDrawnTogether;
        for (size_t j = 0; j < rows; ++j) {
            unsigned char* const here = out + (j * columns + i) * stride;
            if (!w.mask) j += w.kernels->draw(water, {i, count, j, rows, here, stride});
            for (size_t c = i; j < rows && c < i + count; ++c)
                put(present(w, c, j) ? normal_of(slope_at(w, kX, c, j), slope_at(w, kY, c, j)) : Vector{0, 0, 1},
                    out + (j * columns + c) * stride);
        }
    }
}

void write_vertices(const Water& w, unsigned char* out, const WaterVertexFormat& format) {
    write_positions(w, out + format.position_offset, format.stride);
    if (format.normal_offset != SIZE_MAX) write_normals(w, out + format.normal_offset, format.stride);
    if (format.depth_offset == SIZE_MAX) return;
    unsigned char* to = out + format.depth_offset;
    each_cell(w, [&](size_t i, size_t j) {
        put(present(w, i, j) ? depth_at(w, i, j) : -1, to);
        to += format.stride;
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
