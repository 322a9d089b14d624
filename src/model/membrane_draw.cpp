// A membrane as triangles with smooth normals. A cell (i, j) has the corners
//
//      d = (i, j + 1)    c = (i + 1, j + 1)
//      a = (i, j)        b = (i + 1, j)
//
// and is cut into a, b, c and a, c, d. Its area vector is (c - a) x (d - b) / 2 however it is cut; of a cell with three
// of its nodes there it is that of the triangle. A node's normal is the sum over its cells, made a unit vector. A
// component of the sum that rounding alone could have made counts as 0: a sheet that lies in a line has no normals.
#include "model/draw.hh"
#include "model/membrane.hh"

namespace cd {

namespace {

// The sum of twice the area vectors of some cells, and of the sizes of all products in it.
struct Area {
    Vector sum, size;

    void add_product(const Vector& p, const Vector& q) {
        const Vector plus{p.y * q.z, p.z * q.x, p.x * q.y}, minus{p.z * q.y, p.x * q.z, p.y * q.x};
        sum = sum + (plus - minus);
        size = size + Vector{fabs(plus.x) + fabs(minus.x), fabs(plus.y) + fabs(minus.y), fabs(plus.z) + fabs(minus.z)};
    }
    double whole_size() const { return size.x + size.y + size.z; }
};

// Differences err by 2^-53 of themselves, products of them by 2^-51 of their size, and three additions make it 2^-50.
double beyond_rounding(double sum, double size) { return fabs(sum) > 0x1p-50 * size ? sum : 0; }

Vector direction(const Area& area) {
    if (!isfinite(area.whole_size())) return {};
    const Vector n{beyond_rounding(area.sum.x, area.size.x), beyond_rounding(area.sum.y, area.size.y),
                   beyond_rounding(area.sum.z, area.size.z)};
    const double of_two = fabs(n.x) > fabs(n.y) ? fabs(n.x) : fabs(n.y);
    const double most = of_two > fabs(n.z) ? of_two : fabs(n.z);
    if (most == 0) return {};
    const Vector even = n / most; // whose squares stay in double's range
    return even * (1 / length(even));
}

// Powers of two: positions are multiplied by `before`, then subtracted, and the difference is multiplied by `after`.
// As they are; where areas leave double's range; where they sink below it.
struct Scale {
    double before, after;
};
constexpr Scale kAsTheyAre{1, 1}, kShrunk{0x1p-520, 1}, kGrown{1, 0x1p800};

// Nodes whose normals are made together.
constexpr size_t kBlock = 32;

template <class T> struct Drawer {
    const Membrane& m;
    const T* axis[3];  // null: no component is drawn along it
    double spacing[3]; // between nodes over the unit square; 0 along every other axis

    explicit Drawer(const Membrane& membrane) : m(membrane), axis{}, spacing{} {
        const T* const data = numbers<T>(m.position);
        if (m.components == 1) axis[2] = data;
        for (size_t k = 0; m.components > 1 && k < 3 && k < m.components; ++k) axis[k] = data + k * m.plane;
        for (Direction d : {kU, kV})
            if (!axis[d] && m.springs[d] > 0) spacing[d] = 1 / double(springs_along(m, d));
    }

    // A node of a sheet that goes on beyond both ends of a ring.
    struct Node {
        ptrdiff_t at[2];
    };
    size_t line(Direction d, const Node& n) const {
        const ptrdiff_t i = n.at[d], count = ptrdiff_t(nodes_along(m, d));
        return size_t(i < 0 ? i + count : i < count ? i : i - count);
    }
    Vector position(const Node& n) const {
        const size_t place = line(kV, n) * m.pitch + line(kU, n);
        double x[3];
        for (int k = 0; k < 3; ++k) x[k] = axis[k] ? double(axis[k][place]) : k < 2 ? double(n.at[k]) * spacing[k] : 0;
        return {x[0], x[1], x[2]};
    }
    bool is_there(const Node& n) const {
        for (Direction d : {kU, kV})
            if (!m.ring[d] && (n.at[d] < 0 || size_t(n.at[d]) >= nodes_along(m, d))) return false;
        return present(m, line(kU, n), line(kV, n));
    }

    void add_cell(ptrdiff_t i, ptrdiff_t j, Scale scale, Area& area) const {
        Vector corner[4];
        int corners = 0;
        for (const Node& n : {Node{{i, j}}, Node{{i + 1, j}}, Node{{i + 1, j + 1}}, Node{{i, j + 1}}})
            if (is_there(n)) corner[corners++] = position(n) * scale.before;
        if (corners < 3 || (corners == 4 && is_open(m, line(kU, {{i, j}}), line(kV, {{i, j}})))) return;
        area.add_product((corner[2] - corner[0]) * scale.after,
                         (corner[corners == 4 ? 3 : 0] - corner[1]) * scale.after);
    }
    Area around(const Node& n, Scale scale) const {
        Area area;
        for (ptrdiff_t i : {n.at[kU] - 1, n.at[kU]})
            for (ptrdiff_t j : {n.at[kV] - 1, n.at[kV]}) add_cell(i, j, scale, area);
        return area;
    }
    Vector normal(const Node& n, const Area& area) const {
        const double size = area.whole_size();
        if (size >= 0x1p-900 && isfinite(size)) return direction(area);
        return direction(around(n, isfinite(size) ? kGrown : kShrunk));
    }
    Vector normal(const Node& n) const { return is_there(n) ? normal(n, around(n, kAsTheyAre)) : Vector{}; }

    // Whether `count` nodes from (u, v) on have all their cells inside the sheet, none of them open, and no absent node
    // near.
    bool is_plain(size_t u, size_t v, size_t count) const {
        if (u == 0 || v == 0 || u + count >= m.columns || v + 1 >= m.rows) return false;
        for (size_t row = v - 1; m.mask && row <= v + 1; ++row)
            if (memchr(m.mask.data + node_at(m, u - 1, row), 0, count + 2)) return false;
        for (size_t i = u - 1; i < u + count; ++i)
            if (is_open(m, i, v - 1) || is_open(m, i, v)) return false;
        return true;
    }
    // What around() finds for them, in loops that compilers turn into vector instructions.
    void around_plain(size_t u, size_t v, size_t count, Area* out) const {
        double sum[3][kBlock + 1] = {}, size[3][kBlock + 1] = {}; // of the two cells that start in a column
        for (size_t row = v - 1; row <= v; ++row) {
            double p[3][kBlock + 1], q[3][kBlock + 1];
            for (int k = 0; k < 3; ++k) {
                const T* const low = axis[k] ? axis[k] + row * m.pitch + u - 1 : nullptr;
                const T* const high = low ? low + m.pitch : nullptr;
                for (size_t c = 0; low && c <= count; ++c) {
                    p[k][c] = double(high[c + 1]) - double(low[c]);
                    q[k][c] = double(high[c]) - double(low[c + 1]);
                }
                const double along_p = spacing[k], along_q = k == kU ? -along_p : along_p;
                for (size_t c = 0; !low && c <= count; ++c) {
                    p[k][c] = along_p;
                    q[k][c] = along_q;
                }
            }
            for (int k = 0; k < 3; ++k) {
                const int i = (k + 1) % 3, j = (k + 2) % 3;
                for (size_t c = 0; c <= count; ++c) {
                    const double plus = p[i][c] * q[j][c], minus = p[j][c] * q[i][c];
                    sum[k][c] += plus - minus;
                    size[k][c] += fabs(plus) + fabs(minus);
                }
            }
        }
        for (size_t c = 0; c < count; ++c)
            out[c] = {{sum[0][c] + sum[0][c + 1], sum[1][c] + sum[1][c + 1], sum[2][c] + sum[2][c + 1]},
                      {size[0][c] + size[0][c + 1], size[1][c] + size[1][c + 1], size[2][c] + size[2][c + 1]}};
    }

    static Node node(size_t u, size_t v) { return {{ptrdiff_t(u), ptrdiff_t(v)}}; }
    void write_positions(unsigned char* out, size_t stride) const {
        for (size_t v = 0; v < m.rows; ++v)
            for (size_t u = 0; u < m.columns; ++u, out += stride) put(position(node(u, v)), out);
    }
    void write_normals(unsigned char* out, size_t stride) const {
        Area area[kBlock];
        for (size_t v = 0; v < m.rows; ++v)
            for (size_t u = 0, count; u < m.columns; u += count) {
                const size_t inside = u > 0 && u + 1 < m.columns ? m.columns - 1 - u : 1;
                count = inside < kBlock ? inside : kBlock;
                const bool plain = is_plain(u, v, count);
                if (plain) around_plain(u, v, count, area);
                for (size_t c = 0; c < count; ++c, out += stride)
                    put(plain ? normal(node(u + c, v), area[c]) : normal(node(u + c, v)), out);
            }
    }
    void write(unsigned char* out, const VertexFormat& format) const {
        write_positions(out + format.position_offset, format.stride);
        if (format.normal_offset != SIZE_MAX) write_normals(out + format.normal_offset, format.stride);
    }
};

// Cells along d that are drawn: over the unit square those that close a ring would reach back across it.
size_t cells_along(const Membrane& m, Direction d) { return m.components == 1 ? m.springs[d] : springs_along(m, d); }

DrawnLattice drawn(const Membrane& m) { return {m.columns, m.rows, {cells_along(m, kU), cells_along(m, kV)}}; }

auto is_there(const Membrane& m) {
    return [&m](size_t node) { return !m.mask || m.mask[node] != 0; };
}

// See each_cell: a cell's first corner is the node at which it starts.
auto is_drawn(const Membrane& m) {
    return [&m](const size_t* corner, int corners) {
        return corners < 4 || !is_open(m, corner[0] % m.columns, corner[0] / m.columns);
    };
}

} // namespace

void write_vertices(const Membrane& m, unsigned char* out, const VertexFormat& format) {
    by_precision(m, [&](auto zero) { Drawer<decltype(zero)>(m).write(out, format); });
}

size_t index_count(const Membrane& m) {
    const DrawnLattice lattice = drawn(m);
    const bool whole = !m.mask && (!has_lengths(m) || (!m.spring_stiffness[kU] && !m.spring_stiffness[kV]));
    return whole ? 6 * lattice.cells[kU] * lattice.cells[kV] : index_count(lattice, is_there(m), is_drawn(m));
}

void write_indices(const Membrane& m, unsigned char* out, size_t index_size) {
    write_indices(drawn(m), is_there(m), out, index_size, is_drawn(m));
}

} // namespace cd
