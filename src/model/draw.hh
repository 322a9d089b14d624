// What the drawing of all lattices has in common: vertices and triangles in the caller's buffers, aligned or not.
#pragma once

#include <stdint.h>
#include <string.h>

#include <initializer_list>

#include "model/vector.hh"

namespace cd {

// Where the floats of a vertex lie, in bytes; normal_offset SIZE_MAX: it has no normal.
struct VertexFormat {
    size_t stride, position_offset, normal_offset;
};

// As three floats.
inline void put(const Vector& vector, unsigned char* out) {
    const float three[3] = {float(vector.x), float(vector.y), float(vector.z)};
    memcpy(out, three, sizeof three);
}

// How many vertices indices of 2 or 4 bytes can number: the largest number, 65535 or 2^32 - 1, is left out, as graphics
// cards may take it for a restart.
constexpr size_t most_vertices(size_t index_size) { return index_size == 2 ? UINT16_MAX : UINT32_MAX; }

// Vertices in rows, numbered row by row, and how many cells between them are drawn along the rows and across: one less
// than there are vertices, or as many, the last one then leading back to the first vertices.
struct DrawnLattice {
    size_t columns, rows, cells[2];
};

struct EveryCell {
    bool operator()(const size_t*, int) const { return true; }
};

// A cell has the corners a, b, c, d, counter-clockwise from its first vertex on; it is cut into a, b, c and a, c, d, or
// drawn as the triangle of three that are there. f(the numbers of those that are there, how many) for each cell that is
// drawn; is_there(number), is_drawn(what f is given).
template <class IsThere, class IsDrawn, class F>
void each_cell(const DrawnLattice& lattice, IsThere is_there, IsDrawn is_drawn, F f) {
    for (size_t j = 0; j < lattice.cells[1]; ++j)
        for (size_t i = 0; i < lattice.cells[0]; ++i) {
            const size_t right = i + 1 < lattice.columns ? i + 1 : 0, above = j + 1 < lattice.rows ? j + 1 : 0;
            const size_t low = j * lattice.columns, high = above * lattice.columns;
            size_t there[4];
            int corners = 0;
            for (size_t n : {low + i, low + right, high + right, high + i})
                if (is_there(n)) there[corners++] = n;
            if (corners > 2 && is_drawn(there, corners)) f(there, corners);
        }
}

template <class IsThere, class IsDrawn = EveryCell>
size_t index_count(const DrawnLattice& lattice, IsThere is_there, IsDrawn is_drawn = {}) {
    size_t triangles = 0;
    each_cell(lattice, is_there, is_drawn, [&](const size_t*, int corners) { triangles += size_t(corners - 2); });
    return 3 * triangles;
}

template <class Index, class IsThere, class IsDrawn>
void write_triangles(const DrawnLattice& lattice, IsThere is_there, IsDrawn is_drawn, unsigned char* out) {
    each_cell(lattice, is_there, is_drawn, [&](const size_t* corner, int corners) {
        for (int last = 2; last < corners; ++last)
            for (size_t n : {corner[0], corner[last - 1], corner[last]}) {
                const Index index = Index(n);
                memcpy(out, &index, sizeof index);
                out += sizeof index;
            }
    });
}

template <class IsThere, class IsDrawn = EveryCell> void write_indices(const DrawnLattice& lattice, IsThere is_there,
                                                                       unsigned char* out, size_t index_size,
                                                                       IsDrawn is_drawn = {}) {
    if (index_size == 2) write_triangles<uint16_t>(lattice, is_there, is_drawn, out);
    else write_triangles<uint32_t>(lattice, is_there, is_drawn, out);
}

} // namespace cd
