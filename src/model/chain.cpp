// The chain's parameters and memory.
#include "model/chain.hh"

#include <math.h>

#include "base/status.hh"

namespace cd {

// ---- shape and parameters -------------------------------------------------------------------------------------------

// Of (model.md, 1) as the lattice has them (model.md, 2 and 3).
double uniform_mass(const Chain& c, size_t node) {
    if (c.mass_rule == CD_MASS_EQUAL || c.ring || c.springs == 0) return c.mass / double(c.nodes);
    const bool end = node == 0 || node + 1 == c.nodes;
    return c.mass / double(c.springs) * (end ? 0.5 : 1.0);
}

double uniform_stiffness(const Chain& c) { return c.stiffness * double(springs_in_all(c)); }

double uniform_bend(const Chain& c) {
    const double n = double(springs_in_all(c));
    return c.bend * (n * n * n);
}

double bend_of(const Chain& c, size_t node, size_t at) {
    if (!c.ring && (node == 0 || node + 1 >= c.nodes)) return 0;
    return c.node_bend ? c.node_bend[at] : uniform_bend(c);
}

Joint joint_of(const Chain& c, size_t strand, size_t node) {
    const double bend = bend_of(c, node, own_place(c, strand, node));
    if (!has_lengths(c) || bend == 0) return {bend, 1, 1};
    const size_t left = own_place(c, strand, node > 0 ? node - 1 : c.springs), right = own_place(c, strand, node);
    if (stiffness_of(c, left) == 0 || stiffness_of(c, right) == 0) return {0, 1, 1};
    const double mean = 0.5 * (length_of(c, left) + length_of(c, right));
    Joint joint{bend, mean / length_of(c, left), mean / length_of(c, right)};
    if (curls(c)) joint.turn = turn_by(angle_of(c, right), 1.0);
    return joint;
}

// sqrt(stiffness mass) of a matched end, 0 of every other node [N s/m]; ropes have none.
static double impedance(const Chain& c, size_t node) {
    if (c.pin[node] != CD_NODE_MATCHED || c.springs == 0 || has_lengths(c)) return 0;
    const bool first = node == 0;
    size_t i = first ? 0 : c.springs - 1;
    while (welded(c, i) && i != (first ? c.springs - 1 : 0))
        i = first ? i + 1 : i - 1; // beyond what is welded to the end
    const size_t inside = first ? i + 1 : i;
    return welded(c, i) ? 0 : sqrt(stiffness_of(c, i) * mass_of(c, inside));
}

double drag_of(const Chain& c, size_t at) { return c.drag * mass_of(c, at) + impedance(c, at) + tie_damping_of(c, at); }

// ---- memory ---------------------------------------------------------------------------------------------------------

// Nodes whose numbers lie a multiple of 4096 bytes apart share one set of the cache: keep the pitch odd in cache lines.
static bool line_pitch(size_t lines, size_t number, size_t& out) {
    const size_t per_cache_line = kAlignment / number;
    out = lines;
    if (lines < 2 * per_cache_line) return true;
    size_t rows = (lines + per_cache_line - 1) / per_cache_line;
    if (rows % 2 == 0) ++rows;
    return multiply(rows, per_cache_line, out);
}

Features features(const Chain& c) {
    return {{c.method, bool(c.node_mass), bool(c.force), bool(c.target), c.bend > 0, c.air.resists(), bool(c.wind),
             c.sleep_speed > 0, bool(c.loads), collider_sizes(c, collider_count(c))},
            bool(c.spring_stiffness),
            bool(c.node_bend),
            c.ring != 0,
            has_lengths(c),
            bool(c.spring_length),
            bool(c.spring_strength),
            c.rope.angle != 0,
            bool(c.node_angle)};
}

namespace {

// Memory that a set of features needs beside the fields: the step's coefficients and scratch.
struct Needs {
    size_t coefficients, scratch, ring_response;
};

// How many rows of one number per node the sweeps read (chain_step.cpp hands them out), and how many they leave between
// their two ways.
Needs needs_of(const Chain& c, const Features& f) {
    const bool bends = f.bend || f.node_bend, rod = bends || f.ring;
    if (CD_WITH_ROPE && f.length)
        return {rope_coefficients(c, f.colliders.count), rope_scratch(c, {bends, f.air, f.loads, f.colliders}), 0};
    const size_t gains = 2 + size_t(f.force) + size_t(f.target), stages = f.method == CD_METHOD_STIFF_SECOND ? 2 : 1;
    if (is_explicit(f.method)) return {(gains + 2 + size_t(bends)) * row_length(c), 0, 0};
    const bool segments = takes_segments(c, rod);
    const size_t rows = gains + (rod ? segments ? 11 : 8 : segments ? 4 : 2) + size_t(f.spring_stiffness);
    const size_t scratch_rows = stages + (rod ? segments ? 2 : 1 : 0);
    const size_t of_segments = !segments ? 0 : rod ? numbers_of<RodSegment>(kSegments) : 2 * kSegments;
    return {rows * row_length(c) + of_segments, scratch_rows * c.nodes * c.pitch, f.ring ? 4 * c.nodes : 0};
}

} // namespace

bool set_features(Chain& c, const Features& wanted) {
    const Needs needs = needs_of(c, wanted);
    const size_t springs = c.springs + (wanted.ring ? 1 : 0);
    const size_t own = wanted.length ? c.strands : 1;
    BodyChanges body(c, wanted, c.nodes * own, own, needs.coefficients, needs.scratch);
    Change pin{body, c.pin, c.nodes * own};
    Change stiffness{body, c.spring_stiffness, wanted.spring_stiffness ? springs * own : 0};
    Change bend{body, c.node_bend, wanted.node_bend ? c.nodes * own : 0};
    Change ring_response{body, c.ring_response, needs.ring_response};
    Change length{body, c.spring_length, wanted.spring_length ? springs * own : 0};
    Change tension{body, c.tension, wanted.length ? springs * c.strands : 0};
    Change strength{body, c.spring_strength, wanted.spring_strength ? springs * own : 0};
    Change angle{body, c.node_angle, wanted.node_angle ? c.nodes * own : 0};

    if (wanted.method == c.method && wanted.ring == (c.ring != 0) && body.keep_all()) return true;
    if (!body.take_all(c.memory)) return false;
    pin.spread(c.nodes), body.attach_stiffness.spread(c.nodes), body.attach_damping.spread(c.nodes);
    const bool has_mass = body.mass.spread(c.nodes), has_bend = bend.spread(c.nodes);
    const bool has_stiffness = wanted.ring == (c.ring != 0) && stiffness.spread(springs);
    body.carry_over();
    body.put_all(c.memory);
    c.ring = wanted.ring;
    c.method = wanted.method;
    if (!has_mass) fill_uniform(c, CD_MASS);
    if (!has_stiffness) fill_uniform(c, CD_STIFFNESS);
    if (!has_bend) fill_uniform(c, CD_BEND);
    if (CD_WITH_ROPE) {
        if (length.is_new()) fill_uniform(c, CD_REST_LENGTH);
        if (tension.is_new()) memset(c.tension.data, 0, c.tension.bytes());
        if (strength.is_new()) fill_uniform(c, CD_STRENGTH);
        if (angle.is_new()) fill_uniform(c, CD_REST_ANGLE);
        if (body.wind.is_new()) fill_uniform(c, CD_WIND);
    }
    body.fill(c);
    c.prepared_dt = 0;
    return true;
}

void fill_uniform(Chain& c, cd_field field) {
    if (field == CD_MASS && c.node_mass)
        for (size_t i = 0; i < c.node_mass.count; ++i)
            c.node_mass[i] = uniform_mass(c, i / (c.node_mass.count / c.nodes));
    if (field == CD_STIFFNESS && c.spring_stiffness)
        for (size_t i = 0; i < c.spring_stiffness.count; ++i) c.spring_stiffness[i] = uniform_stiffness(c);
    if (CD_WITH_BEND && field == CD_BEND && c.node_bend)
        for (size_t i = 0; i < c.node_bend.count; ++i) c.node_bend[i] = uniform_bend(c);
    if (!CD_WITH_ROPE) return;
    if (field == CD_REST_LENGTH && c.spring_length)
        for (size_t i = 0; i < c.spring_length.count; ++i) c.spring_length[i] = uniform_length(c);
    if (field == CD_STRENGTH && c.spring_strength)
        for (size_t i = 0; i < c.spring_strength.count; ++i) c.spring_strength[i] = c.rope.strength;
    if (field == CD_REST_ANGLE && c.node_angle)
        for (size_t i = 0; i < c.node_angle.count; ++i) c.node_angle[i] = uniform_angle(c);
    if (field == CD_WIND && c.wind)
        for (size_t i = 0; i < c.nodes; ++i)
            for (size_t line = 0; line < c.pitch; ++line)
                set_number(c, c.wind, i * c.pitch + line, line < c.lines ? c.air.wind[line % c.components] : 0);
}

// ---- life -----------------------------------------------------------------------------------------------------------

cd_status create_chain(const char* function, size_t strands, size_t springs, size_t components, cd_precision precision,
                       const cd_allocator& allocator, Chain*& out) {
    Chain shape{};
    shape.memory.allocator = allocator;
    shape.kernels = &best_kernels<ChainKernels>();
    shape.strands = strands;
    shape.springs = springs;
    shape.components = components;
    shape.precision = precision;
    // The largest run of memory is the two rows of doubles per line and node that bend needs.
    size_t lines_bytes, all;
    if (!add(springs, 1, shape.nodes) || !multiply(strands, components, shape.lines) ||
        !line_pitch(shape.lines, number_size(shape), shape.pitch) ||
        !multiply(shape.pitch, 16 * sizeof(double), lines_bytes) || !multiply(shape.nodes, lines_bytes, all))
        return fail(CD_ERROR_SIZE, function, "%zu strands of %zu springs with %zu components do not fit in memory",
                    strands, springs, components);
    shape.lambda = 0.5;
    shape.mass = 1;
    shape.stiffness = 1;
    shape.rope = {};

    out = make(shape, kChainTag, shape.nodes * shape.pitch * number_size(shape));
    if (!out)
        return fail(CD_ERROR_MEMORY, function, "no memory for %zu strands of %zu springs with %zu components", strands,
                    springs, components);
    return CD_OK;
}

SleepingPart sleeping_part(const Chain& c, size_t part) {
    const size_t width = has_lengths(c) ? 1 : c.strands;
    return {part,
            c.nodes * width,
            place(c, part, 0, 0),
            width,
            c.pitch,
            c.components,
            1,
            [](const Body& b, const SleepingPart& of, size_t i) {
                const Chain& chain = static_cast<const Chain&>(b);
                return held(chain, own_place(chain, of.number, i / of.width));
            }};
}

} // namespace cd
