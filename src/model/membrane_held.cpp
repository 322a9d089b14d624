// Sheets whose two directions separate, and the nodes that are held in them.
//
// Their masses and springs are uniform, no node is absent, and nodes are held by whole rows and columns, beside which a
// few single nodes may be held or tied; with bend, both ends of every line are held or joined to a ring, or there is a
// single line. Then a factorization of one row and one of one column serve all: B^-1 = F_v F_u. Where no line is held
// beside the edges they have no planes either: they are uniform.
//
// Single nodes are held, or tied, by impulses (solve/held_nodes.hh). The response of a separable system to an impulse
// at a node is the product of a row's and a column's, so these are found from lines alone: after the solves along u,
// those along v in the columns of the nodes tell how these would move; the impulses are then added along their rows.
#include <math.h>
#include <string.h>

#include <initializer_list>

#include "model/membrane_work.hh"
#include "solve/series.hh"

namespace cd {

namespace {

// Which columns and rows are held as a whole.
void find_lines(const Membrane& m, const Work& w) {
    const auto each_line = [&](auto f) {
        for (Direction d : {kU, kV})
            for (size_t i = 0; i < nodes_along(m, d); ++i) w.rows[d].holds[i] = f(d, i);
    };
    each_line([&](Direction d, size_t i) {
        return m.pin || (i == 0 && holds(m.edge[edge_of(d, false)])) ||
               (i == m.springs[d] && holds(m.edge[edge_of(d, true)]));
    });
    for (size_t v = 0; v < m.rows && m.pin; ++v)
        for (size_t u = 0; u < m.columns; ++u)
            if (!held(m, u, v)) w.rows[kU].holds[u] = w.rows[kV].holds[v] = 0;
}

bool is_tied(const Membrane& m, size_t node) { return tie_of(m, node) > 0 || tie_damping_of(m, node) > 0; }

// f(u, v) for each node that is tied, or held but not with its whole row or column.
template <class F> void each_single(const Membrane& m, const Work& w, const F& f) {
    for (size_t v = 0; v < m.rows && (m.pin || m.target); ++v)
        for (size_t u = 0; u < m.columns; ++u)
            if (!w.rows[kU].holds[u] && !w.rows[kV].holds[v] && (held(m, u, v) || is_tied(m, node_at(m, u, v))))
                f(u, v);
}

// Whether lines beside the edges are held as a whole.
bool holds_inside(const Membrane& m, const Work& w) {
    for (Direction d : {kU, kV})
        for (size_t i = 1; i + 1 < nodes_along(m, d); ++i)
            if (w.rows[d].holds[i]) return true;
    return false;
}

// What a tie resists with, as a mass.
double tie_mass(const Membrane& m, size_t node, double h) {
    return h * (h * tie_of(m, node) + tie_damping_of(m, node));
}

// Softer ones, as a part of a node's mass, have compliances that leave double's range on the way.
constexpr double kSoftestTie = 1e-100;

// But for single nodes.
bool separates(const Membrane& m, const Work& w, double h) {
    if (m.node_mass || m.spring_stiffness[kU] || m.spring_stiffness[kV]) return false;
    for (size_t i = 0; i < m.mask.count; ++i)
        if (!m.mask[i]) return false;
    for (size_t i = 0; i < m.attach_stiffness.count; ++i)
        if (is_tied(m, i) && tie_mass(m, i, h) < kSoftestTie * uniform_mass(m)) return false;
    if (!has_bend(m) || m.springs[kU] == 0 || m.springs[kV] == 0) return true;
    for (Direction d : {kU, kV})
        if (!m.ring[d] && !(w.rows[d].holds[0] && w.rows[d].holds[nodes_along(m, d) - 1])) return false;
    return !m.ring[kU] || !m.ring[kV];
}

// Springs from a node along d to nodes that move.
double moving_springs(const Membrane& m, Direction d, size_t u, size_t v) {
    const size_t i = d == kU ? u : v;
    double count = 0;
    for (size_t at : {before(m, d, i), after(m, d, i)}) {
        const size_t to_u = d == kU ? at : u, to_v = d == kU ? v : at;
        const bool joined = at != i && (m.ring[d] || at + 1 == i || at == i + 1);
        count += joined && present(m, to_u, to_v) && !held(m, to_u, to_v) ? 1 : 0;
    }
    return count;
}

} // namespace

bool is_too_stiff(const Membrane& m, double sigma) {
    double stiffest = 0;
    for (Direction d : {kU, kV})
        stiffest = fmax(stiffest, 2 * uniform_stiffness(m, d) + (has_bend(m) ? 16 * uniform_bend(m, d) : 0));
    return sigma * stiffest > kStiffSheet * uniform_mass(m);
}

namespace {

size_t line_of(const Work& w, Direction d, size_t place) {
    return d == kU ? place % w.grid.pitch : place / w.grid.pitch;
}

// Lines along d, one for each held node.
Grid lines_across(const Work& w, Direction d) { return {w.held.count, w.across[d].rows, w.across[d].pitch}; }

} // namespace

void choose_way(const Membrane& m, double dt, MembraneFeatures& with) {
    with.likeness = kUniform;
    Carver coefficients{m.coefficients.data}, scratch{m.scratch.data};
    const Work work(m, with, coefficients, scratch); // whatever the way, rows come first
    find_lines(m, work);
    size_t singles = 0;
    double kinks = 0; // about them: one on an edge is as an eighth of one inside, at a corner as a 64th
    each_single(m, work, [&](size_t u, size_t v) {
        const double part = moving_springs(m, kU, u, v) * moving_springs(m, kV, u, v) / 4;
        const double tie = tie_of(m, node_at(m, u, v)), springs = uniform_stiffness(m, kU) + uniform_stiffness(m, kV);
        ++singles;
        kinks += part * part * part * (held(m, u, v) ? 1 : share(tie, springs));
    });
    const double h = stage_share(m, dt);
    const bool apart = separates(m, work, h);
    const size_t alternating = is_too_stiff(m, h * (h + m.damping)) ? 0 : HeldNodes::kMost;
    with.solver = solver_for(m, dt, kinks, apart && singles <= alternating);
    const size_t most = steps_explicitly(m) ? 0 : with.solver == CD_SOLVER_COUPLED ? HeldNodes::kMost : alternating;
    if (singles > most || !apart) with.likeness = kDiffer;
    else if (holds_inside(m, work)) with.likeness = kSeparate;
}

void find_held(Membrane& m, Work& w, double h) {
    find_lines(m, w);
    m.held = 0;
    // Of the lines' systems the product is so many times the sheet's.
    const double scale = w.coupled ? 1 : uniform_mass(m) / (1 + h * m.drag);
    each_single(m, w, [&](size_t u, size_t v) {
        const size_t node = node_at(m, u, v);
        w.held.place[m.held] = v * w.grid.pitch + u;
        w.held.compliance[m.held] = held(m, u, v) ? 0 : scale / tie_mass(m, node, h);
        ++m.held;
    });
    w.held.count = m.held;
}

void prepare_held(const Membrane& m, const Work& w, double h) {
    const HeldNodes& held = w.held;
    for (Direction d : {kU, kV}) {
        const Grid lines = lines_across(w, d);
        double* const response = w.response[d];
        memset(response, 0, lines.rows * lines.pitch * sizeof(double));
        for (size_t a = 0; a < held.count; ++a) {
            const size_t i = line_of(w, d, held.place[a]);
            const double ground = line_weight(m, d, i) * (1 + h * m.drag + w.rows[d].drag[i]);
            w.grounded[d][a] = ground;
            response[i * lines.pitch + a] = 1 / ground;
        }
        w.shared[d].solve(*m.kernels, cd_parallel{}, lines, response, w.across_slope);
    }
    const auto answer = [&](Direction d, size_t a, size_t b) {
        return w.response[d][line_of(w, d, held.place[a]) * w.across[d].pitch + b];
    };
    held.factor([&](size_t a, size_t b) { return answer(kU, a, b) * answer(kV, a, b); });
}

void take_wishes(const Work& w, double* plane) {
    for (size_t a = 0; a < w.held.count; ++a) {
        double& own = plane[w.held.place[a]];
        w.wish[a] = w.held.compliance[a] * (w.grounded[kU][a] * w.grounded[kV][a] * own);
        own = 0;
    }
}

void hold(const Membrane& m, const Work& w, double* plane) {
    const HeldNodes& held = w.held;
    const Grid columns = lines_across(w, kV);
    double impulse[HeldNodes::kMost];
    for (size_t a = 0; a < held.count; ++a) {
        const double* const column = plane + line_of(w, kU, held.place[a]);
        for (size_t v = 0; v < columns.rows; ++v) w.across_plane[v * columns.pitch + a] = column[v * w.grid.pitch];
    }
    w.shared[kV].solve(*m.kernels, cd_parallel{}, columns, w.across_plane, w.across_slope);
    for (size_t a = 0; a < held.count; ++a)
        impulse[a] = w.wish[a] - w.across_plane[line_of(w, kV, held.place[a]) * columns.pitch + a];
    held.balance(impulse);
    for (size_t a = 0; a < held.count; ++a) {
        const double share = impulse[a] / w.grounded[kV][a];
        double* const row = plane + line_of(w, kV, held.place[a]) * w.grid.pitch;
        for (size_t u = 0; u < w.grid.columns; ++u) row[u] += share * w.response[kU][u * w.across[kU].pitch + a];
    }
}

} // namespace cd
