// The membrane's parameters and memory.
#include "model/membrane.hh"

#include "base/status.hh"
#include "solve/planes.hh"

namespace cd {

// ---- what the totals come to ----------------------------------------------------------------------------------------

static bool has_half_ends(const Membrane& m, Direction d) {
    return m.mass_rule == CD_MASS_HALF_ENDS && m.springs[d] > 0 && !m.ring[d];
}

double line_weight(const Membrane& m, Direction d, size_t i) {
    return has_half_ends(m, d) && (i == 0 || i == m.springs[d]) ? 0.5 : 1;
}

// The weights of all lines that are counted by their node along d.
static double weight_across(const Membrane& m, Direction d) {
    return double(has_half_ends(m, d) ? m.springs[d] : nodes_along(m, d));
}

double uniform_mass(const Membrane& m) { return m.mass / (weight_across(m, kU) * weight_across(m, kV)); }

double per_spring(const Membrane& m, Direction d, double stiffness) {
    return stiffness * double(springs_along(m, d)) / weight_across(m, other(d));
}
double uniform_stiffness(const Membrane& m, Direction d) { return per_spring(m, d, m.stiffness[d]); }

double uniform_bend(const Membrane& m, Direction d) {
    const double n = double(springs_along(m, d));
    return m.bend * (n * n * n) / weight_across(m, other(d));
}

double uniform_twist(const Membrane& m) { return 2 * sqrt(uniform_bend(m, kU) * uniform_bend(m, kV)); }

size_t inside_matched(const Membrane& m, Direction d, size_t i) {
    const auto matched = [&](bool at_last) { return m.edge[edge_of(d, at_last)] == CD_NODE_MATCHED; };
    if (m.springs[d] == 0) return i;
    return i == 0 && matched(false) ? 1 : i == m.springs[d] && matched(true) ? i - 1 : i;
}

// ---- nodes, springs, cells ------------------------------------------------------------------------------------------

namespace {

struct Node {
    size_t at[2];

    Node moved(Direction d, size_t i) const { return d == kU ? Node{{i, at[1]}} : Node{{at[0], i}}; }
};

bool present(const Membrane& m, Node n) { return present(m, n.at[0], n.at[1]); }

size_t last(const Membrane& m, Direction d) { return m.springs[d]; }
bool has_next(const Membrane& m, Direction d, size_t i) { return i < springs_along(m, d); }
bool has_both(const Membrane& m, Direction d, size_t i) { return m.ring[d] || (i > 0 && i < last(m, d)); }

bool on_edge(const Membrane& m, cd_edge edge, size_t u, size_t v) {
    const Direction d = direction_of(edge);
    return (d == kU ? u : v) == (edge == edge_of(d, true) ? last(m, d) : 0);
}

// What sends no echo back from a matched edge [N s/m].
double impedance(const Membrane& m, size_t u, size_t v) {
    double sum = 0;
    const Node n{{u, v}};
    for (Direction d : {kU, kV}) {
        const Node inside = n.moved(d, inside_matched(m, d, n.at[d])), start = inside.at[d] < n.at[d] ? inside : n;
        if (inside.at[d] == n.at[d]) continue;
        sum += sqrt(stiffness_of(m, d, start.at[0], start.at[1]) * mass_of(m, inside.at[0], inside.at[1]));
    }
    return sum;
}

} // namespace

cd_node kind_by_edges(const Membrane& m, const cd_node* edges, size_t u, size_t v) {
    bool pinned = false, driven = false, posed = false;
    for (cd_edge edge = CD_EDGE_U_FIRST; edge <= CD_EDGE_V_LAST; ++edge) {
        if (!on_edge(m, edge, u, v)) continue;
        pinned |= edges[edge] == CD_NODE_PINNED;
        driven |= edges[edge] == CD_NODE_DRIVEN;
        posed |= edges[edge] == CD_NODE_POSED;
    }
    return pinned ? CD_NODE_PINNED : driven ? CD_NODE_DRIVEN : posed ? CD_NODE_POSED : CD_NODE_FREE;
}

cd_node kind_of(const Membrane& m, size_t u, size_t v) {
    return m.pin ? cd_node(m.pin[node_at(m, u, v)]) : kind_by_edges(m, m.edge, u, v);
}

double mass_of(const Membrane& m, size_t u, size_t v) {
    if (m.node_mass) return m.node_mass[node_at(m, u, v)];
    return uniform_mass(m) * (line_weight(m, kU, u) * line_weight(m, kV, v));
}

// Of a spring, were its nodes there.
static double given_stiffness(const Membrane& m, Direction d, const Node& n) {
    if (!has_next(m, d, n.at[d])) return 0;
    return uniform_stiffness(m, d) * line_weight(m, other(d), n.at[other(d)]);
}

double stiffness_of(const Membrane& m, Direction d, size_t u, size_t v) {
    const Node n{{u, v}};
    if (!has_next(m, d, n.at[d]) || !present(m, n) || !present(m, n.moved(d, after(m, d, n.at[d])))) return 0;
    return m.spring_stiffness[d] ? m.spring_stiffness[d][node_at(m, u, v)] : given_stiffness(m, d, n);
}

double length_of(const Membrane& m, Direction d, size_t u, size_t v) {
    const bool own = m.spring_length[d] && has_next(m, d, d == kU ? u : v);
    return own ? m.spring_length[d][node_at(m, u, v)] : uniform_length(m, d);
}

double breaking_strain_of(const Membrane& m, Direction d, size_t u, size_t v) {
    return m.breaking_strain[d] ? m.breaking_strain[d][node_at(m, u, v)] : m.cloth.breaking_strain;
}

bool lacks_two_springs(const Membrane& m, size_t u, size_t v) {
    const auto is_cut = [&](Direction d, size_t i, size_t j) {
        return m.spring_stiffness[d] && !(m.spring_stiffness[d][node_at(m, i, j)] > 0);
    };
    const size_t next_u = after(m, kU, u), next_v = after(m, kV, v);
    return is_cut(kU, u, v) + is_cut(kU, u, next_v) + is_cut(kV, u, v) + is_cut(kV, next_u, v) >= 2;
}

double bend_of(const Membrane& m, Direction d, size_t u, size_t v) {
    const Node n{{u, v}};
    const size_t i = n.at[d];
    if (!has_bend(m) || !has_both(m, d, i) || !present(m, n) || !present(m, n.moved(d, before(m, d, i))) ||
        !present(m, n.moved(d, after(m, d, i))))
        return 0;
    return uniform_bend(m, d) * line_weight(m, other(d), n.at[other(d)]);
}

double twist_of(const Membrane& m, size_t u, size_t v) {
    if (!has_bend(m) || !has_next(m, kU, u) || !has_next(m, kV, v)) return 0;
    const size_t next_u = after(m, kU, u), next_v = after(m, kV, v);
    const bool whole = present(m, u, v) && present(m, next_u, v) && present(m, u, next_v) && present(m, next_u, next_v);
    return whole ? uniform_twist(m) : 0;
}

double drag_of(const Membrane& m, size_t u, size_t v) {
    return m.drag * mass_of(m, u, v) + impedance(m, u, v) + tie_damping_of(m, node_at(m, u, v));
}

// ---- memory ---------------------------------------------------------------------------------------------------------

MembraneFeatures features(const Membrane& m) {
    MembraneFeatures f{};
    static_cast<BodyFeatures&>(f) = {
        m.method,          bool(m.node_mass), bool(m.force),     bool(m.target), has_bend(m),
        m.cloth.resists(), bool(m.wind),      m.sleep_speed > 0, bool(m.loads),  collider_sizes(m, collider_count(m))};
    for (Direction d : {kU, kV}) {
        f.spring_stiffness[d] = bool(m.spring_stiffness[d]);
        f.spring_length[d] = bool(m.spring_length[d]);
        f.breaking_strain[d] = bool(m.breaking_strain[d]);
        f.ring[d] = m.ring[d] != 0;
    }
    f.pin = bool(m.pin);
    f.mask = bool(m.mask);
    f.pressure = m.pressure != 0;
    f.cloth = has_lengths(m);
    f.solver = m.solver;
    memcpy(f.edge, m.edge, sizeof f.edge);
    return f;
}

bool set_features(Membrane& m, const MembraneFeatures& wanted) {
    MembraneNeeds needs;
    if (!needs_of(m, wanted, needs)) return false;
    BodyChanges body(m, wanted, m.nodes, 1, needs.coefficients, needs.scratch);
    Change along_u{body, m.spring_stiffness[kU], wanted.spring_stiffness[kU] ? m.nodes : 0};
    Change along_v{body, m.spring_stiffness[kV], wanted.spring_stiffness[kV] ? m.nodes : 0};
    Change length_u{body, m.spring_length[kU], wanted.spring_length[kU] ? m.nodes : 0};
    Change length_v{body, m.spring_length[kV], wanted.spring_length[kV] ? m.nodes : 0};
    Change breaking_u{body, m.breaking_strain[kU], wanted.breaking_strain[kU] ? m.nodes : 0};
    Change breaking_v{body, m.breaking_strain[kV], wanted.breaking_strain[kV] ? m.nodes : 0};
    Change pressed{body, m.pressed, wanted.pressure ? m.components * m.plane : 0};
    Change change{body, m.change, wanted.cloth ? m.velocity.count : 0};
    Change pin{body, m.pin, wanted.pin ? m.nodes : 0}, mask{body, m.mask, wanted.mask ? m.nodes : 0};

    const bool same_ring = wanted.ring[kU] == (m.ring[kU] != 0) && wanted.ring[kV] == (m.ring[kV] != 0);
    const bool same_edges = memcmp(wanted.edge, m.edge, sizeof m.edge) == 0, same_pin = pin.keep();
    if (wanted.method == m.method && wanted.solver == m.solver && same_ring && same_edges && body.keep_all())
        return true;
    if (!body.take_all(m.memory)) return false;
    body.carry_over();
    body.put_all(m.memory);
    m.method = wanted.method;
    m.solver = wanted.solver;
    for (Direction d : {kU, kV}) m.ring[d] = wanted.ring[d];
    memcpy(m.edge, wanted.edge, sizeof m.edge);
    if (body.mass.is_new()) fill_uniform(m, CD_MASS);
    if (along_u.is_new()) fill_uniform(m, CD_STIFFNESS_U);
    if (along_v.is_new()) fill_uniform(m, CD_STIFFNESS_V);
    if (length_u.is_new()) fill_uniform(m, CD_REST_LENGTH_U);
    if (length_v.is_new()) fill_uniform(m, CD_REST_LENGTH_V);
    if (breaking_u.is_new()) fill_uniform(m, CD_BREAKING_STRAIN_U);
    if (breaking_v.is_new()) fill_uniform(m, CD_BREAKING_STRAIN_V);
    if (body.wind.is_new()) fill_uniform(m, CD_WIND);
    if (change.is_new()) memset(m.change.data, 0, m.change.bytes());
    if (mask.is_new()) memset(m.mask.data, 1, m.mask.bytes());
    for (size_t i = 0; pin.is_new() && i < m.nodes; ++i)
        m.pin[i] = uint8_t(kind_by_edges(m, m.edge, i % m.columns, i / m.columns));
    body.fill(m);
    if (!same_edges || !same_pin) stop_nodes(m);
    m.prepared_dt = 0;
    return true;
}

void fill_uniform(Membrane& m, cd_field field) {
    for (size_t v = 0, i = 0; v < m.rows; ++v)
        for (size_t u = 0; u < m.columns; ++u, ++i) {
            if (field == CD_MASS && m.node_mass)
                m.node_mass[i] = uniform_mass(m) * (line_weight(m, kU, u) * line_weight(m, kV, v));
            if (field == CD_STIFFNESS_U && m.spring_stiffness[kU])
                m.spring_stiffness[kU][i] = given_stiffness(m, kU, {{u, v}});
            if (field == CD_STIFFNESS_V && m.spring_stiffness[kV])
                m.spring_stiffness[kV][i] = given_stiffness(m, kV, {{u, v}});
            if (field == CD_REST_LENGTH_U && m.spring_length[kU])
                m.spring_length[kU][i] = has_next(m, kU, u) ? uniform_length(m, kU) : 0;
            if (field == CD_REST_LENGTH_V && m.spring_length[kV])
                m.spring_length[kV][i] = has_next(m, kV, v) ? uniform_length(m, kV) : 0;
            if (field == CD_BREAKING_STRAIN_U && m.breaking_strain[kU])
                m.breaking_strain[kU][i] = has_next(m, kU, u) ? m.cloth.breaking_strain : 0;
            if (field == CD_BREAKING_STRAIN_V && m.breaking_strain[kV])
                m.breaking_strain[kV][i] = has_next(m, kV, v) ? m.cloth.breaking_strain : 0;
            for (size_t k = 0; k < m.components && field == CD_WIND && m.wind; ++k)
                set_number(m, m.wind, place(m, u, v, k), m.cloth.wind[k]);
        }
}

void clear_state(Membrane& m) {
    if (!m.clock.all_alike(m.clock.dt)) m.prepared_dt = 0; // the solver is chosen anew
    clear_state(static_cast<Body&>(m));
    if (m.change) memset(m.change.data, 0, m.change.bytes());
}

void stop_nodes(Membrane& m) {
    for (size_t v = 0; v < m.rows; ++v)
        for (size_t u = 0; u < m.columns; ++u)
            if (kind_of(m, u, v) == CD_NODE_PINNED || !present(m, u, v))
                for (size_t k = 0; k < m.components; ++k) {
                    const size_t at = place(m, u, v, k);
                    if (get_number(m, m.velocity, at) != 0) make_unlike(m);
                    set_number(m, m.velocity, at, 0);
                }
}

bool set_edge(Membrane& m, cd_edge edge, cd_node kind) {
    MembraneFeatures wanted = features(m);
    wanted.edge[edge] = kind;
    wanted.target |= kind == CD_NODE_POSED;
    if (!set_features(m, wanted)) return false;
    for (size_t i = 0; m.pin && i < m.nodes; ++i) {
        const size_t u = i % m.columns, v = i / m.columns;
        if (on_edge(m, edge, u, v)) m.pin[i] = uint8_t(kind_by_edges(m, m.edge, u, v));
    }
    for (size_t i = 0; i < m.nodes && kind == CD_NODE_POSED; ++i) {
        const size_t u = i % m.columns, v = i / m.columns;
        for (size_t k = 0; k < m.components && on_edge(m, edge, u, v); ++k)
            set_number(m, m.target, place(m, u, v, k), get_number(m, m.position, place(m, u, v, k)));
    }
    stop_nodes(m);
    changed(m);
    return true;
}

bool set_ring(Membrane& m, bool along_u, bool along_v) {
    MembraneFeatures wanted = features(m);
    if (wanted.ring[kU] == along_u && wanted.ring[kV] == along_v) return true;
    wanted.ring[kU] = along_u;
    wanted.ring[kV] = along_v;
    if (!set_features(m, wanted)) return false;
    for (cd_field field : {CD_MASS, CD_STIFFNESS_U, CD_STIFFNESS_V, CD_REST_LENGTH_U, CD_REST_LENGTH_V,
                           CD_BREAKING_STRAIN_U, CD_BREAKING_STRAIN_V})
        fill_uniform(m, field);
    changed(m);
    return true;
}

// ---- life -----------------------------------------------------------------------------------------------------------

cd_status create_membrane(const char* function, size_t nu, size_t nv, size_t components, cd_precision precision,
                          const cd_allocator& allocator, Membrane*& out) {
    Membrane shape{};
    shape.memory.allocator = allocator;
    shape.kernels = &best_kernels<MembraneKernels>();
    shape.springs[kU] = nu;
    shape.springs[kV] = nv;
    shape.components = components;
    shape.precision = precision;
    // With everything switched on, a sheet of many rows and columns holds less than 80 planes of doubles for each
    // component. What narrow ones need beyond that is counted where it is taken.
    size_t all, state;
    Grid grid{}; // that of the planes which steps work on
    if (!add(nu, 1, shape.columns) || !add(nv, 1, shape.rows) || !grid_of(shape.columns, shape.rows, grid) ||
        !multiply(shape.rows, shape.pitch = grid.pitch, shape.plane) || !multiply(shape.plane, components, state) ||
        !multiply(state, 80 * sizeof(double), all))
        return fail(CD_ERROR_SIZE, function, "nu %zu and nv %zu springs with %zu components do not fit in memory", nu,
                    nv, components);
    shape.nodes = shape.columns * shape.rows;
    shape.lambda = 0.5;
    shape.tolerance = 1e-6;
    shape.most_iterations = 100;
    shape.mass = 1;
    shape.stiffness[kU] = shape.stiffness[kV] = 1;
    shape.solver = CD_WITH_COUPLED ? CD_SOLVER_AUTO : CD_SOLVER_ALTERNATING;
    shape.taken = CD_SOLVER_AUTO;

    out = make(shape, kMembraneTag, state * number_size(shape));
    if (!out)
        return fail(CD_ERROR_MEMORY, function, "no memory for nu %zu and nv %zu springs with %zu components", nu, nv,
                    components);
    return CD_OK;
}

} // namespace cd
