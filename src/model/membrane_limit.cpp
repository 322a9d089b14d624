// A bound for explicit steps of a membrane: symplectic Euler is bounded where
//      S(dt) = 4 M - 2 dt C - dt^2 K     is positive definite (chain_limit.cpp tells why).
// K is at most diagonal: k (a - b)^2 <= 2 k (a^2 + b^2), b (l - 2 c + r)^2 <= b (4 l^2 + 8 c^2 + 4 r^2) and
// t (a - b - c + d)^2 <= 4 t (a^2 + b^2 + c^2 + d^2), each with equality where nodes swing against their neighbours, as
// in the fastest mode of a uniform sheet. What remains is a quadratic per node; the least of their roots is the bound.
#include <math.h>

#include <initializer_list>

#include "model/membrane.hh"

namespace cd {

namespace {

struct Bound {
    const Membrane& m;

    bool moves(size_t u, size_t v) const { return present(m, u, v) && !held(m, u, v); }

    // The part of K's bound at a node that comes from one spring, to the node (u, v).
    double spring(double stiffness, size_t u, size_t v) const { return (moves(u, v) ? 2 : 1) * stiffness; }

    double diagonal(size_t u, size_t v) const {
        const size_t left = before(m, kU, u), right = after(m, kU, u);
        const size_t above = before(m, kV, v), below = after(m, kV, v);
        double sum = spring(stiffness_of(m, kU, u, v), right, v) + spring(stiffness_of(m, kU, left, v), left, v) +
                     spring(stiffness_of(m, kV, u, v), u, below) + spring(stiffness_of(m, kV, u, above), u, above);
        if (!has_bend(m)) return sum;
        sum += 8 * bend_of(m, kU, u, v) + 4 * bend_of(m, kU, left, v) + 4 * bend_of(m, kU, right, v);
        sum += 8 * bend_of(m, kV, u, v) + 4 * bend_of(m, kV, u, above) + 4 * bend_of(m, kV, u, below);
        for (size_t cell_u : {left, u})
            for (size_t cell_v : {above, v}) sum += 4 * twist_of(m, cell_u, cell_v);
        return sum;
    }
};

} // namespace

double stable_dt(const Membrane& m) {
    const Bound bound{m};
    double least = INFINITY;
    for (size_t v = 0; v < m.rows; ++v)
        for (size_t u = 0; u < m.columns; ++u) {
            if (!bound.moves(u, v)) continue;
            const double stiffness = bound.diagonal(u, v), drag = drag_of(m, u, v) + m.damping * stiffness;
            const double square = stiffness + tie_of(m, u, v), mass = mass_of(m, u, v);
            if (square > 0 || drag > 0) least = fmin(least, 4 * mass / (drag + sqrt(drag * drag + 4 * mass * square)));
        }
    return least;
}

} // namespace cd
