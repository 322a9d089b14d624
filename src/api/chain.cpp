// chain.h: life, method, parameters, time, measuring, keeping. Fields and acting are in chain_fields.cpp.
#include "api/chain_handle.hh"

using namespace cd;

CD_OBJECT_FUNCTIONS(chain)
CD_BODY_FUNCTIONS(chain)

// ---- life -----------------------------------------------------------------------------------------------------------

cd_status cd_chain_create(size_t strands, size_t springs, size_t components, cd_precision precision,
                          const cd_allocator* allocator, cd_chain** out_chain) {
    CD_NOT_NULL(out_chain);
    CD_CHECK(shared::can_make(__func__, components, precision, allocator));
    if (strands < 1) return fail(CD_ERROR_VALUE, __func__, "strands is 0, must be at least 1");
    Chain* c = nullptr;
    CD_CHECK(create_chain(__func__, strands, springs, components, precision,
                          allocator ? *allocator : default_allocator(), c));
    *out_chain = reinterpret_cast<cd_chain*>(c);
    return CD_OK;
}

cd_status cd_chain_get_shape(const cd_chain* chain, size_t* out_strands, size_t* out_springs, size_t* out_components,
                             cd_precision* out_precision) {
    CD_OPEN(chain, c);
    if (out_strands) *out_strands = c.strands;
    if (out_springs) *out_springs = c.springs;
    if (out_components) *out_components = c.components;
    if (out_precision) *out_precision = c.precision;
    return CD_OK;
}

// ---- parameters -----------------------------------------------------------------------------------------------------

CD_GETTER(chain, get_stiffness, double, out_stiffness, x.stiffness)
CD_GETTER(chain, get_ring, int32_t, out_ring, x.ring)

cd_status cd_chain_set_stiffness(cd_chain* chain, double stiffness) {
    CD_OPEN(chain, c);
    const bool rope = has_lengths(c), rigid = isinf(stiffness) && stiffness > 0;
    if (rigid && !rope)
        return fail(CD_ERROR_VALUE, __func__, "stiffness is inf, but there is no rest length: set one first");
    if (!rigid) CD_CHECK(in_range(__func__, "stiffness", stiffness, 0, kMost, rope ? kOrInfinity : ""));
    c.stiffness = stiffness;
    changed(c);
    fill_uniform(c, CD_STIFFNESS);
    return CD_OK;
}

cd_status cd_chain_get_end(const cd_chain* chain, cd_end end, cd_node* out_kind) {
    CD_OPEN(chain, c);
    CD_CHECK(is_enum(__func__, "end", end, CD_END_LAST));
    CD_NOT_NULL(out_kind);
    *out_kind = c.pin[own_place(c, 0, end == CD_END_FIRST ? 0 : c.springs)];
    return CD_OK;
}

cd_status cd_chain_set_ring(cd_chain* chain, int32_t ring) {
    CD_OPEN(chain, c);
    if (ring != 0 && ring != 1) return fail(CD_ERROR_VALUE, __func__, "ring is %d, must be 0 or 1", int(ring));
    if (ring && c.nodes < 3)
        return fail(CD_ERROR_UNSUPPORTED, __func__, "ring is 1, which needs 3 nodes: this chain has %zu", c.nodes);
    for (size_t at = 0; at < c.pin.count && ring; ++at)
        if (c.pin[at] == CD_NODE_MATCHED)
            return fail(CD_ERROR_UNSUPPORTED, __func__, "ring is 1, but node %zu is CD_NODE_MATCHED",
                        at / own_strands(c));
    if (ring == c.ring) return wake(c), CD_OK;
    Features wanted = features(c);
    wanted.ring = ring != 0;
    CD_CHECK(shared::change_features(__func__, c, wanted));
    fill_uniform(c, CD_MASS);
    fill_uniform(c, CD_BEND);
    return CD_OK;
}

// ---- springs that have a length -------------------------------------------------------------------------------------

CD_GETTER(chain, get_rest_length, double, out_length, x.rope.length)
CD_GETTER(chain, get_push, int32_t, out_push, x.rope.push)
CD_GETTER(chain, get_rest_angle, double, out_angle, x.rope.angle)
CD_GETTER(chain, get_strength, double, out_strength, x.rope.strength)
CD_GETTER(chain, get_broken, size_t, out_springs, x.broken)
CD_FUNCTION(chain, const, get_tolerance, (double* out_tolerance, size_t* out_most_iterations),
            shared::get_tolerance(__func__, x.rope, out_tolerance, out_most_iterations))
CD_FUNCTION(chain, const, get_convergence, (size_t * out_iterations, double* out_residual),
            shared::get_convergence(x, out_iterations, out_residual))

cd_status cd_chain_set_tolerance(cd_chain* chain, double tolerance, size_t most_iterations) {
    CD_OPEN(chain, c);
    if (most_iterations > kMostIterations)
        return fail(CD_ERROR_VALUE, __func__, "most_iterations is %zu, must be at most %zu", most_iterations,
                    size_t(kMostIterations));
    return shared::set_tolerance(__func__, c.rope, tolerance, most_iterations);
}

// Whether strands agree in a field that has numbers of their own.
template <class T> static bool strands_agree(const Chain& c, const Array<T>& field) {
    bool agree = true;
    for (size_t at = 0; at < field.count; ++at) agree &= field[at] == field[at - at % c.strands];
    return agree;
}
// Whether the chain can do without lengths: what strands will then share, and what will be welded.
static cd_status can_lose_lengths(const char* function, const Chain& c) {
    const bool agree = strands_agree(c, c.pin) && strands_agree(c, c.node_mass) &&
                       strands_agree(c, c.spring_stiffness) && strands_agree(c, c.node_bend) &&
                       strands_agree(c, c.attach_stiffness) && strands_agree(c, c.attach_damping);
    if (!agree)
        return fail(CD_ERROR_UNSUPPORTED, function,
                    "length is 0, but strands differ in pins, masses, stiffnesses, bends or attachments, which they "
                    "would share");
    if (isinf(c.stiffness))
        return fail(CD_ERROR_UNSUPPORTED, function,
                    "length is 0, but the stiffness is infinite, which only ropes take");
    if (groups_are_sound(
            c.nodes, c.ring != 0, [&](size_t i) { return is_rigid(c, own_place(c, 0, i)); },
            [&](size_t i) { return held(c, own_place(c, 0, i)); }))
        return CD_OK;
    return fail(CD_ERROR_UNSUPPORTED, function, "length is 0, but two held nodes would be welded together");
}

cd_status cd_chain_set_rest_length(cd_chain* chain, double length) {
    CD_OPEN(chain, c);
    if (length != 0) CD_CHECK(in_range(__func__, "length", length, kLeastMass, kMost, kOrZero));
    if (length > 0 && !can_have_lengths(c))
        return fail(CD_ERROR_UNSUPPORTED, __func__,
                    "length is %g, but the chain has %zu springs and %zu components: a rope needs a spring and 1 to 3 "
                    "components",
                    length, c.springs, c.components);
    if (length == 0 && has_lengths(c)) CD_CHECK(can_lose_lengths(__func__, c));
    Features wanted = features(c);
    wanted.length = length > 0;
    if (length == 0) wanted.spring_length = wanted.air = wanted.wind = wanted.spring_strength = false;
    if (length == 0) wanted.angle = wanted.node_angle = false;
    if (length == 0) wanted.colliders = {}, wanted.loads = false;
    CD_CHECK(shared::change_features(__func__, c, wanted));
    if (length == 0) c.air = {}, c.rope.strength = INFINITY, c.rope.thickness = c.rope.angle = 0;
    c.rope.length = length > 0 ? length : 0; // not -0
    changed(c);
    fill_uniform(c, CD_REST_LENGTH);
    merge_velocities(c, 0, c.lines);
    return CD_OK;
}

cd_status cd_chain_set_push(cd_chain* chain, int32_t push) {
    CD_OPEN(chain, c);
    if (push != 0 && push != 1) return fail(CD_ERROR_VALUE, __func__, "push is %d, must be 0 or 1", int(push));
    c.rope.push = push;
    wake(c);
    return CD_OK;
}

cd_status cd_chain_set_rest_angle(cd_chain* chain, double angle) {
    CD_OPEN(chain, c);
    CD_CHECK(in_range(__func__, "angle", angle, 0 - most_angle(c), most_angle(c))); // not -0
    CD_CHECK(angle != 0 ? can_curl(__func__, c) : is_rope(__func__, c, "only ropes have rest angles"));
    Features wanted = features(c);
    wanted.angle = angle != 0;
    CD_CHECK(shared::change_features(__func__, c, wanted));
    c.rope.angle = angle != 0 ? angle : 0; // not -0
    changed(c);
    fill_uniform(c, CD_REST_ANGLE);
    return CD_OK;
}

cd_status cd_chain_set_strength(cd_chain* chain, double strength) {
    CD_OPEN(chain, c);
    if (!(isinf(strength) && strength > 0))
        CD_CHECK(in_range(__func__, "strength", strength, kLeastMass, kMost, kOrInfinity));
    CD_CHECK(is_rope(__func__, c, "only ropes break"));
    if (strength < INFINITY) CD_CHECK(shared::switch_field(__func__, c, CD_STIFFNESS, true));
    c.rope.strength = strength;
    fill_uniform(c, CD_STRENGTH);
    wake(c);
    return CD_OK;
}

cd_status cd_chain_get_reaction(const cd_chain* chain, size_t strand, size_t node, double* out_force, size_t count) {
    CD_OPEN(chain, c);
    CD_CHECK(is_index(__func__, "strand", strand, c.strands));
    CD_CHECK(is_index(__func__, "node", node, c.nodes));
    CD_NOT_NULL(out_force);
    CD_CHECK(is_rope(__func__, c, "only ropes have tensions"));
    CD_CHECK(is_count(__func__, "count", count, c.components));
    reaction(c, strand, node, out_force);
    return CD_OK;
}

// ---- time -----------------------------------------------------------------------------------------------------------

cd_status cd_chain_step(cd_chain* chain, double dt, size_t count) {
    CD_OPEN(chain, c);
    CD_CHECK(shared::can_step(__func__, c, dt, count));
    if (count == 0) return CD_OK;
    if (has_lengths(c)) CD_CHECK(shared::takes_all(__func__, what_ropes_lack(c)));
    CD_CHECK(shared::knows_colliders(__func__, c));
    const uint64_t bad = step_chain(c, dt, count);
    if (bad) return shared::diverged_at(__func__, bad);
    CD_CHECK(shared::was_told_distances(__func__, c));
    if (c.residual <= c.rope.tolerance) return CD_OK;
    return fail(CD_ERROR_TOLERANCE, __func__,
                "the error is %g times a spring's rest length after %zu iterations, more than the tolerance of %g",
                c.residual, c.iterations, c.rope.tolerance);
}
