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

// Nodes whose normals are made together, and the cells between them and beside.
constexpr size_t kCells = 64, kBlock = kCells - 1;

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

    // Whether no ring leads on from `count` nodes from (u, v) on, no node near them is absent, and no cell open.
    bool is_plain(size_t u, size_t v, size_t count) const {
        if ((m.ring[kU] && (u == 0 || u + count == m.columns)) || (m.ring[kV] && (v == 0 || v + 1 == m.rows)))
            return false;
        const size_t first = u > 0 ? u - 1 : 0, last = u + count < m.columns ? u + count : m.columns - 1; // near them
        const size_t top = v > 0 ? v - 1 : 0, bottom = v + 1 < m.rows ? v + 1 : v;
        for (size_t row = top; m.mask && row <= bottom; ++row)
            if (memchr(m.mask.data + node_at(m, first, row), 0, last - first + 1)) return false;
        for (size_t row = top; may_open(m) && row < bottom; ++row)
            for (size_t i = first; i < last; ++i)
                if (is_open(m, i, row)) return false;
        return true;
    }

    // A row of nodes from u - 1 on; those that are not there count as 0, as do components that are not drawn.
    struct Row {
        double x[3][kCells + kGroup];
    };
    void take_row(size_t u, size_t v, size_t count, Row& out) const {
        const size_t from = u > 0 ? 0 : 1, to = u + count < m.columns ? count + 2 : count + 1;
        for (int k = 0; k < 3; ++k) {
            const T* const row = axis[k] ? axis[k] + v * m.pitch + (u + from - 1) : nullptr;
            for (size_t c = from; row && c < to; ++c) out.x[k][c] = double(row[c - from]);
        }
    }

    // What add_cell adds, of count + 1 cells side by side from (u - 1, v) on: nothing where there is none.
    struct Cells {
        double sum[3][kCells], size[3][kCells];
    };
    void look_at_cells(size_t u, size_t count, const Row& low, const Row& high, Cells& out) const {
        double p[3][kCells], q[3][kCells];
        for (int k = 0; k < 3; ++k) {
            const double along_p = axis[k] ? 0 : spacing[k], along_q = k == kU ? -along_p : along_p;
            in_groups(count + 1, [&](size_t c) {
                p[k][c] = (high.x[k][c + 1] - low.x[k][c]) + along_p;
                q[k][c] = (high.x[k][c] - low.x[k][c + 1]) + along_q;
            });
        }
        for (int k = 0; k < 3; ++k) {
            const int i = (k + 1) % 3, j = (k + 2) % 3;
            in_groups(count + 1, [&](size_t c) {
                const double plus = p[i][c] * q[j][c], minus = p[j][c] * q[i][c];
                out.sum[k][c] = plus - minus;
                out.size[k][c] = fabs(plus) + fabs(minus);
            });
            if (u == 0) out.sum[k][0] = out.size[k][0] = 0;
            if (u + count == m.columns) out.sum[k][count] = out.size[k][count] = 0;
        }
    }
    // Normals of the nodes from (u, v) on, between two rows of cells.
    void write_plain(size_t u, size_t v, size_t count, const Cells& above, const Cells& below, unsigned char* out,
                     size_t stride) const {
        double sum[kCells + kGroup] = {}, size[kCells + kGroup] = {}; // of the two cells in a column
        double n[3][kCells], whole[kCells] = {}, square[kCells], scale[kCells];
        for (int k = 0; k < 3; ++k) {
            in_groups(count + 1, [&](size_t c) {
                sum[c] = above.sum[k][c] + below.sum[k][c];
                size[c] = above.size[k][c] + below.size[k][c];
            });
            in_groups(count, [&](size_t c) {
                const double both = size[c] + size[c + 1];
                n[k][c] = beyond_rounding(sum[c] + sum[c + 1], both);
                whole[c] += both;
            });
        }
        in_groups(count, [&](size_t c) {
            square[c] = n[0][c] * n[0][c] + n[1][c] * n[1][c] + n[2][c] * n[2][c];
            scale[c] = 1 / sqrt(square[c]);
        });
        for (auto& along : n) in_groups(count, [&](size_t c) { along[c] *= scale[c]; });
        for (size_t c = 0; c < count; ++c, out += stride) {
            const bool in_range = square[c] > 0x1p-900 && square[c] < 0x1p900 && whole[c] < INFINITY;
            put(in_range ? Vector{n[0][c], n[1][c], n[2][c]} : normal(node(u + c, v)), out);
        }
    }

    static Node node(size_t u, size_t v) { return {{ptrdiff_t(u), ptrdiff_t(v)}}; }
    void write_positions(unsigned char* out, size_t stride) const {
        for (size_t v = 0; v < m.rows; ++v, out += m.columns * stride)
            for (int k = 0; k < 3; ++k)
                for (size_t u = 0; u < m.columns; ++u) {
                    const float x = axis[k] ? float(axis[k][v * m.pitch + u])
                                            : float(k < 2 ? double(k == kU ? u : v) * spacing[k] : 0);
                    memcpy(out + u * stride + size_t(k) * sizeof x, &x, sizeof x);
                }
    }
    // In blocks of columns, row by row, so that each row of cells is looked at once for the nodes before it and behind.
    void write_normals(unsigned char* out, size_t stride) const {
        Row nodes[2] = {};
        Cells cells[2];
        for (size_t u = 0, count; u < m.columns; u += count) {
            const size_t left = m.columns - u, closes = m.ring[kU] ? 1 : 0; // a ring's ends are looked at one by one
            count = closes && (u == 0 || left == 1) ? 1 : left - closes < kBlock ? left - closes : kBlock;
            bool looked = false; // at the cells before this row, in cells[v % 2]
            for (size_t v = 0; v < m.rows; ++v) {
                unsigned char* const here = out + node_at(m, u, v) * stride;
                const bool plain = is_plain(u, v, count);
                if (plain) {
                    const size_t now = v % 2, next = 1 - now;
                    if (!looked && v > 0) {
                        take_row(u, v - 1, count, nodes[next]);
                        take_row(u, v, count, nodes[now]);
                        look_at_cells(u, count, nodes[next], nodes[now], cells[now]);
                    }
                    if (v == 0) take_row(u, v, count, nodes[now]), cells[now] = {};
                    if (v + 1 < m.rows) {
                        take_row(u, v + 1, count, nodes[next]);
                        look_at_cells(u, count, nodes[now], nodes[next], cells[next]);
                    } else cells[next] = {};
                    write_plain(u, v, count, cells[now], cells[next], here, stride);
                }
                for (size_t c = 0; !plain && c < count; ++c) put(normal(node(u + c, v)), here + c * stride);
                looked = plain;
            }
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
