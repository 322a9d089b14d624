// Which springs of cloth tear after a step: see cd_membrane_set_breaking_strain.
#include "model/membrane_cloth.hh"

namespace cd {

namespace {

// A spring is looked at closely once the square of its length is this part of that at which it tears.
constexpr double kNear = 1 - 1e-6;

// The springs along one direction.
struct Tear {
    Membrane& m;
    Direction d;
    // Of each line, a `stride` apart: the largest load of its springs if beyond 1, else 1, and 0 once it is cut; and
    // which spring bears it.
    double *worst, *place;
    size_t stride;

    // How many times its breaking strain a spring is strained: of number i of a line.
    double load(size_t i, size_t line) const {
        const size_t u = d == kU ? i : line, v = d == kU ? line : i;
        return stiffness_of(m, d, u, v) > 0 ? strain_of(m, d, u, v) / breaking_strain_of(m, d, u, v) : 0;
    }

    // Cuts number i of a line, and of those beside it, one after the other, as far as they are overloaded too.
    size_t run(size_t i, size_t line) const {
        const auto cut = [&](size_t at) {
            m.spring_stiffness[d][d == kU ? node_at(m, i, at) : node_at(m, at, i)] = 0;
            worst[at * stride] = 0;
        };
        const auto goes_on = [&](size_t at) { return worst[at * stride] > 1 && load(i, at) > 1; };
        const Direction across = other(d);
        size_t torn = 1;
        cut(line);
        for (size_t at = after(m, across, line); goes_on(at); at = after(m, across, at)) cut(at), ++torn;
        for (size_t at = line; at > 0 || m.ring[across];) {
            at = before(m, across, at);
            if (!goes_on(at)) break;
            cut(at), ++torn;
        }
        return torn;
    }

    // Of each line what run() and all() go by. To see that a spring is far from tearing takes no root and no division.
    void find_worst() const {
        for (size_t line = 0; line < nodes_along(m, other(d)); ++line) worst[line * stride] = 1;
        const StateNumbers x = state_of(m, m.position);
        const size_t columns = d == kU ? springs_along(m, kU) : m.columns,
                     rows = d == kV ? springs_along(m, kV) : m.rows;
        const double length = uniform_length(m, d);
        for (size_t v = 0; v < rows; ++v)
            for (size_t u = 0; u < columns; ++u) {
                const size_t at = node_at(m, u, v), i = d == kU ? u : v, line = d == kU ? v : u;
                const double rest = m.spring_length[d] ? m.spring_length[d][at] : length;
                const double strain = m.breaking_strain[d] ? m.breaking_strain[d][at] : m.cloth.breaking_strain;
                const size_t from = cd::place(m, u, v, 0);
                const size_t to = cd::place(m, d == kU ? after(m, kU, u) : u, d == kV ? after(m, kV, v) : v, 0);
                double square = 0;
                for (size_t k = 0; k < 3; ++k) {
                    const double way = x[to + k * m.plane] - x[from + k * m.plane];
                    square += way * way;
                }
                const double reach = rest * (1 + strain);
                if (!(square > kNear * (reach * reach))) continue;
                const double now = load(i, line);
                if (now > worst[line * stride]) worst[line * stride] = now, place[line * stride] = double(i);
            }
    }

    size_t all() const {
        find_worst();
        const size_t lines = nodes_along(m, other(d));
        size_t torn = 0;
        for (;;) {
            size_t first = 0;
            for (size_t line = 1; line < lines; ++line)
                if (worst[line * stride] > worst[first * stride]) first = line;
            if (!(worst[first * stride] > 1)) return torn;
            torn += run(size_t(place[first * stride]), first);
        }
    }
};

} // namespace

size_t tear_springs(Membrane& m, ClothWork& w) {
    size_t torn = 0;
    for (Direction d : {kU, kV}) // in planes that the next step fills anew, at the lines' first nodes
        if (can_tear(m, d)) torn += Tear{m, d, w.rhs[0], w.rhs[1], d == kU ? w.grid.pitch : 1}.all();
    if (torn > 0) m.prepared_dt = 0;
    return torn;
}

} // namespace cd
