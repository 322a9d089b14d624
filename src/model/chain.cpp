// The chain's parameters and memory.
#include "model/chain.hh"

#include <math.h>

#include "base/status.hh"

namespace cd {

// ---- shape and parameters -------------------------------------------------------------------------------------------

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

double bend_of(const Chain& c, size_t node) {
    if (!c.ring && (node == 0 || node + 1 >= c.nodes)) return 0;
    return c.node_bend ? c.node_bend[node] : uniform_bend(c);
}

bool has_bend(const Chain& c) { return c.node_bend || c.bend > 0; }

// sqrt(stiffness mass) of a matched end, 0 of every other node [N s/m].
static double impedance(const Chain& c, size_t node) {
    if (c.pin[node] != CD_NODE_MATCHED || c.springs == 0) return 0;
    const bool first = node == 0;
    size_t i = first ? 0 : c.springs - 1;
    while (welded(c, i) && i != (first ? c.springs - 1 : 0))
        i = first ? i + 1 : i - 1; // beyond what is welded to the end
    const size_t inside = first ? i + 1 : i;
    return welded(c, i) ? 0 : sqrt(stiffness_of(c, i) * mass_of(c, inside));
}

double drag_of(const Chain& c, size_t node) {
    return c.drag * mass_of(c, node) + impedance(c, node) + (c.attach_damping ? c.attach_damping[node] : 0);
}

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
    return {bool(c.node_mass), bool(c.spring_stiffness),
            bool(c.node_bend), bool(c.force),
            bool(c.target),    c.ring != 0,
            c.bend > 0,        c.method};
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
    const size_t gains = 2 + size_t(f.force) + size_t(f.target), stages = f.method == CD_METHOD_STIFF_SECOND ? 2 : 1;
    if (is_explicit(f.method)) return {(gains + 2 + size_t(bends)) * c.nodes, 0, 0};
    const size_t rows = gains + (rod ? 8 : 2) + size_t(f.spring_stiffness), scratch_rows = stages + size_t(rod);
    return {rows * c.nodes, scratch_rows * c.nodes * c.pitch, f.ring ? 4 * c.nodes : 0};
}

// One array on its way from what it is to what it shall be.
template <class T> struct Change {
    Array<T>& array;
    size_t count;
    Array<T> fresh{};
    bool keep() const { return array.count == count; }
};

template <class T> bool take(Memory& memory, Change<T>& change) {
    return change.keep() || change.count == 0 || allocate(memory, change.count, change.fresh);
}
template <class T> void undo(Memory& memory, Change<T>& change) { release(memory, change.fresh); }
template <class T> bool put(Memory& memory, Change<T>& change) { // true if the array is new
    if (change.keep()) return false;
    release(memory, change.array);
    change.array = change.fresh;
    return change.count > 0;
}

} // namespace

bool set_features(Chain& c, const Features& wanted) {
    const Needs needs = needs_of(c, wanted);
    const size_t state = c.nodes * c.pitch * number_size(c), springs = c.springs + (wanted.ring ? 1 : 0);
    Change<double> mass{c.node_mass, wanted.node_mass ? c.nodes : 0};
    Change<double> stiffness{c.spring_stiffness, wanted.spring_stiffness ? springs : 0};
    Change<double> bend{c.node_bend, wanted.node_bend ? c.nodes : 0};
    Change<double> attach_stiffness{c.attach_stiffness, wanted.target ? c.nodes : 0};
    Change<double> attach_damping{c.attach_damping, wanted.target ? c.nodes : 0};
    Change<char> force{c.force, wanted.force ? state : 0}, target{c.target, wanted.target ? state : 0};
    Change<double> coefficients{c.coefficients, needs.coefficients}, scratch{c.scratch, needs.scratch};
    Change<double> ring_response{c.ring_response, needs.ring_response};

    const auto all = [&](auto f) {
        return f(mass) && f(stiffness) && f(bend) && f(attach_stiffness) && f(attach_damping) && f(force) &&
               f(target) && f(coefficients) && f(scratch) && f(ring_response);
    };
    if (wanted.method == c.method && wanted.ring == (c.ring != 0) && all([](auto& change) { return change.keep(); }))
        return true;
    if (!all([&](auto& change) { return take(c.memory, change); })) {
        all([&](auto& change) { return undo(c.memory, change), true; });
        return false;
    }
    c.ring = wanted.ring;
    c.method = wanted.method;
    if (put(c.memory, mass)) fill_uniform(c, CD_MASS);
    if (put(c.memory, stiffness)) fill_uniform(c, CD_STIFFNESS);
    if (put(c.memory, bend)) fill_uniform(c, CD_BEND);
    if (put(c.memory, target)) memcpy(c.target.data, c.position.data, c.target.count);
    put(c.memory, force);
    for (Change<double>* change : {&attach_stiffness, &attach_damping, &coefficients, &scratch, &ring_response})
        put(c.memory, *change);
    c.prepared_dt = 0;
    return true;
}

void fill_uniform(Chain& c, cd_field field) {
    if (field == CD_MASS && c.node_mass)
        for (size_t i = 0; i < c.nodes; ++i) c.node_mass[i] = uniform_mass(c, i);
    if (field == CD_STIFFNESS && c.spring_stiffness)
        for (size_t i = 0; i < c.spring_stiffness.count; ++i) c.spring_stiffness[i] = uniform_stiffness(c);
    if (field == CD_BEND && c.node_bend)
        for (size_t i = 0; i < c.nodes; ++i) c.node_bend[i] = uniform_bend(c);
}

// ---- life -----------------------------------------------------------------------------------------------------------

cd_status create_chain(const char* function, size_t strands, size_t springs, size_t components, cd_precision precision,
                       const cd_allocator& allocator, Chain*& out) {
    Chain shape{};
    shape.memory.allocator = allocator;
    shape.kernels = &best_kernels();
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

    Array<char> place;
    Memory& memory = shape.memory;
    const size_t state = shape.nodes * shape.pitch * number_size(shape);
    if (!allocate(memory, sizeof(Chain), place) || !allocate(memory, shape.nodes, shape.pin) ||
        !allocate(memory, state, shape.position) || !allocate(memory, state, shape.velocity) ||
        !set_features(shape, features(shape))) {
        release(memory, shape.velocity);
        release(memory, shape.position);
        release(memory, shape.pin);
        release(memory, place);
        return fail(CD_ERROR_MEMORY, function, "no memory for %zu strands of %zu springs with %zu components", strands,
                    springs, components);
    }
    out = reinterpret_cast<Chain*>(place.data);
    *out = shape;
    out->tag = kChainTag;
    return CD_OK;
}

void destroy_chain(Chain* c) {
    c->tag = 0;
    for (Array<double>* array : {&c->node_mass, &c->spring_stiffness, &c->node_bend, &c->attach_stiffness,
                                 &c->attach_damping, &c->coefficients, &c->scratch, &c->ring_response})
        release(c->memory, *array);
    for (Array<char>* array : {&c->position, &c->velocity, &c->force, &c->target}) release(c->memory, *array);
    release(c->memory, c->pin);
    Memory memory = c->memory;
    release(memory, c, sizeof(Chain));
}

} // namespace cd
