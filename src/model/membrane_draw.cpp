// A membrane as triangles with smooth normals. A cell (i, j) has the corners
//
//      d = (i, j + 1)    c = (i + 1, j + 1)
//      a = (i, j)        b = (i + 1, j)
//
// and is cut into a, b, c and a, c, d. Its area vector is (c - a) x (d - b) / 2 however it is cut; of a cell with three
// of its nodes there it is that of the triangle. A node's normal is the sum over its cells, made a unit vector. A
// component of the sum that rounding alone could have made counts as 0: a sheet that lies in a line has no normals.
#include "kernel/draw.hh"

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

double beyond_rounding(double sum, double size) { return fabs(sum) > kRoundedArea * size ? sum : 0; }

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

struct Drawer {
    const Membrane& m;
    DrawnSheet sheet;

    explicit Drawer(const Membrane& membrane)
        : m(membrane), sheet{{}, {}, membrane.columns, membrane.rows, membrane.pitch} {
        const StateNumbers data = state_of(m, m.position);
        if (m.components == 1) sheet.axis[2] = data;
        for (size_t k = 0; m.components > 1 && k < 3 && k < m.components; ++k) sheet.axis[k] = data.from(k * m.plane);
        for (Direction d : {kU, kV})
            if (!sheet.axis[d] && m.springs[d] > 0) sheet.spacing[d] = 1 / double(springs_along(m, d));
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
        for (int k = 0; k < 3; ++k)
            x[k] = sheet.axis[k] ? sheet.axis[k][place] : k < 2 ? double(n.at[k]) * sheet.spacing[k] : 0;
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
    [[gnu::noinline]] Area around(const Node& n, Scale scale) const {
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

    static Node node(size_t u, size_t v) { return {{ptrdiff_t(u), ptrdiff_t(v)}}; }
    void write_positions(unsigned char* out, size_t stride) const {
        const auto put_row = [&](unsigned char* to, auto number) {
            for (size_t u = 0; u < m.columns; ++u, to += stride) {
                const float x = float(number(u));
                memcpy(to, &x, sizeof x);
            }
        };
        for (size_t v = 0; v < m.rows; ++v, out += m.columns * stride)
            for (int k = 0; k < 3; ++k) {
                unsigned char* const to = out + size_t(k) * sizeof(float);
                if (sheet.axis[k])
                    sheet.axis[k].stored_state([&](const auto* numbers) {
                        put_row(to, [row = numbers + v * m.pitch](size_t u) { return row[u]; });
                    });
                else put_row(to, [&](size_t u) { return k < 2 ? double(k == kU ? u : v) * sheet.spacing[k] : 0; });
            }
    }
    // In blocks of columns: rows whose nodes have only whole cells about them together, others node by node.
    void write_normals(unsigned char* out, size_t stride) const {
        for (size_t u = 0, count; u < m.columns; u += count) {
            const size_t left = m.columns - u, closes = m.ring[kU] ? 1 : 0; // a ring's ends are looked at one by one
            count = closes && (u == 0 || left == 1)  ? 1
                    : left - closes < kDrawnTogether ? left - closes
                                                     : kDrawnTogether;
            for (size_t v = 0; v < m.rows; ++v) {
                size_t end = v;
                while (end < m.rows && is_plain(u, end, count)) ++end;
                if (end > v) v += m.kernels->draw(sheet, {u, count, v, end, out + node_at(m, u, v) * stride, stride});
                for (size_t c = 0; v < m.rows && c < count; ++c)
                    put(normal(node(u + c, v)), out + node_at(m, u + c, v) * stride);
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

void write_vertices(const Membrane& m, unsigned char* out, const VertexFormat& format) { Drawer(m).write(out, format); }

size_t index_count(const Membrane& m) {
    const DrawnLattice lattice = drawn(m);
    const bool whole = !m.mask && (!has_lengths(m) || (!m.spring_stiffness[kU] && !m.spring_stiffness[kV]));
    return whole ? 6 * lattice.cells[kU] * lattice.cells[kV] : index_count(lattice, is_there(m), is_drawn(m));
}

void write_indices(const Membrane& m, unsigned char* out, size_t index_size) {
    write_indices(drawn(m), is_there(m), out, index_size, is_drawn(m));
}

} // namespace cd
