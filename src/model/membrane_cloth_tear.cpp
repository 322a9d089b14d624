// Which springs of cloth tear after a step: see cd_membrane_set_breaking_strain.
#include "model/membrane_cloth.hh"

namespace cd {

namespace {

// The springs along one direction.
struct Tear {
    Membrane& m;
    Direction d;
    // Of each line, a `stride` apart: the largest load of its springs, or 0 once it is cut; and which spring bears it.
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
        for (size_t at = line; (at > 0 || m.ring[across]) && goes_on(at = before(m, across, at));) cut(at), ++torn;
        return torn;
    }

    size_t all() const {
        const size_t lines = nodes_along(m, other(d));
        for (size_t line = 0; line < lines; ++line) {
            double &most = worst[line * stride] = 1, &at = place[line * stride] = 0;
            for (size_t i = 0; i < springs_along(m, d); ++i) {
                const double now = load(i, line);
                if (now > most) most = now, at = double(i);
            }
        }
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
