// A bound for explicit steps of a membrane: symplectic Euler is bounded where
//      S(dt) = 4 M - 2 dt C - dt^2 K     is positive definite (chain_limit.cpp tells why).
// K is at most diagonal: k (a - b)^2 <= 2 k (a^2 + b^2), b (l - 2 c + r)^2 <= b (4 l^2 + 8 c^2 + 4 r^2) and
// t (a - b - c + d)^2 <= 4 t (a^2 + b^2 + c^2 + d^2), each with equality where nodes swing against their neighbours, as
// in the fastest mode of a uniform sheet. What remains is a quadratic per node; the least of their roots is the bound.
//
// And a bound for alternating solves of separable sheets: their extra mass, (w_u h)^2 (w_v h)^2 times that of the motion
// (membrane.h), and what it is of the kink about a node that is held among others that move.
#include <math.h>

#include <initializer_list>

#include "model/membrane.hh"
#include "model/stages.hh"

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

// ---- which solver ---------------------------------------------------------------------------------------------------

namespace {

// Of a motion of half a wave along each direction, round a ring of a whole wave: what alternating may add to its mass.
constexpr double kMostExtraMass = 0.05;

struct Rate {
    double spring; // h (h + damping) k / m
    double motion; // (w h)^2 of the motion
};
Rate rate_along(const Membrane& m, Direction d, double sigma) {
    constexpr double kPi = 3.14159265358979323846;
    if (m.springs[d] == 0) return {0, 0};
    const double phase = (m.ring[d] ? 2 * kPi : kPi) / double(springs_along(m, d)), square = phase * phase;
    const double bend = has_bend(m) ? uniform_bend(m, d) : 0; // counted twice, see membrane_step.cpp
    const double spring = sigma * (uniform_stiffness(m, d) + 2 * bend * square) / uniform_mass(m);
    return {spring, spring * square};
}

} // namespace

cd_solver solver_for(const Membrane& m, double dt, double kinks, bool separates) {
    if (steps_explicitly(m)) return CD_SOLVER_AUTO;
    if (m.solver != CD_SOLVER_AUTO) return m.solver;
    // What lines that differ can answer is the best in energy, of which most may be that of fast motions: slow ones then
    // go anywhere.
    if (!separates) return CD_SOLVER_COUPLED;
    const double h = stage_share(m, dt), sigma = h * (h + m.damping);
    const Rate u = rate_along(m, kU, sigma), v = rate_along(m, kV, sigma);
    // The mean square of the motion is a quarter. The kink about a held node (the lattice's Green's function) adds 0.5
    // to 0.9 times the product of the two rates on 33 x 33 nodes, less on larger sheets.
    const double extra = u.motion * v.motion + kinks * u.spring * v.spring / (double(m.nodes) / 4);
    // The extra mass of factored lines depends on dt and more: the energy counts it, and so would change with these,
    // without bound. make_unlike is told of what else it depends on, but not of masses and springs, whose changes are
    // work however a step is solved; and of steps that keep the energy without it, and of velocities put to 0.
    const bool varies = extra > 0 && !m.clock.all_alike(dt);
    return extra <= kMostExtraMass && !varies ? CD_SOLVER_ALTERNATING : CD_SOLVER_COUPLED;
}

} // namespace cd
