// The force of a pressure: its product with the gradient of the volume under the sheet. With the volume the mean over
// both triangulations of every cell, a node a of the cell a, b, c, d gets a sixth of
//      A(a, b, c, d) + A(a, b, d),    A(a, b, c, d) = (c - a) x (d - b) / 2,    A(a, b, d) = (b - a) x (d - a) / 2,
// which is the gradient wherever the node's cells surround it, and adds up to the cell's area vector.
#include <initializer_list>

#include "model/membrane_work.hh"
#include "model/vector.hh"

namespace cd {

namespace {

struct Presser {
    const Membrane& m;
    StateNumbers x = state_of(m, m.position);

    Vector place(size_t u, size_t v) const {
        const size_t at = v * m.pitch + u;
        return {x[at], x[at + m.plane], x[at + 2 * m.plane]};
    }
    // The neighbour one step away along d, round a ring; false if there is none.
    bool step(Direction d, int by, size_t& u, size_t& v) const {
        size_t& i = d == kU ? u : v;
        if (!m.ring[d] && i == (by > 0 ? m.springs[d] : 0)) return false;
        i = by > 0 ? after(m, d, i) : before(m, d, i);
        return true;
    }
    // Adds the share of a cell to the node (u, v) of it, which lies at a, the cell's other nodes at by_u and by_v.
    void add_cell(size_t u, size_t v, const Vector& a, int by_u, int by_v, Vector& sum) const {
        size_t b[2] = {u, v}, d[2] = {u, v};
        if (!step(kU, by_u, b[0], b[1]) || !step(kV, by_v, d[0], d[1])) return;
        if (by_u * by_v < 0) { // keep the order round the cell
            for (int k = 0; k < 2; ++k) {
                const size_t other = b[k];
                b[k] = d[k];
                d[k] = other;
            }
        }
        size_t c[2] = {u, v};
        step(kU, by_u, c[0], c[1]);
        step(kV, by_v, c[0], c[1]);
        if (!present(m, b[0], b[1]) || !present(m, c[0], c[1]) || !present(m, d[0], d[1])) return;
        if (is_open(m, by_u > 0 ? u : before(m, kU, u), by_v > 0 ? v : before(m, kV, v))) return;
        const Vector pb = place(b[0], b[1]), pc = place(c[0], c[1]), pd = place(d[0], d[1]);
        sum = sum + (cross(pc - a, pd - pb) / 2 + cross(pb - a, pd - a) / 2) / 6;
    }
    void row(size_t v) const {
        for (size_t u = 0; u < m.columns; ++u) {
            Vector sum;
            const Vector here = place(u, v);
            if (present(m, u, v))
                for (int by_v : {-1, 1})
                    for (int by_u : {-1, 1}) add_cell(u, v, here, by_u, by_v, sum);
            double* const out = m.pressed.data + v * m.pitch + u;
            out[0] = m.pressure * sum.x;
            out[m.plane] = m.pressure * sum.y;
            out[2 * m.plane] = m.pressure * sum.z;
        }
    }
};

} // namespace

void press(Membrane& m) {
    const Presser presser{m};
    in_parts(m.parallel, m.rows, m.columns, [&](size_t first, size_t count) {
        for (size_t v = first; v < first + count; ++v) presser.row(v);
    });
}

} // namespace cd
