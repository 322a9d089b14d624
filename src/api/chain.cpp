// chain.h: life, method, parameters, time, measuring, keeping. Fields and acting are in chain_fields.cpp.
#include "api/chain_handle.hh"

using namespace cd;

// ---- life -----------------------------------------------------------------------------------------------------------

cd_status cd_chain_create(size_t strands, size_t springs, size_t components, cd_precision precision,
                          const cd_allocator* allocator, cd_chain** out_chain) {
    CD_NOT_NULL(out_chain);
    CD_CHECK(is_enum(__func__, "precision", precision, CD_FLOAT64));
    if (strands < 1) return fail(CD_ERROR_VALUE, __func__, "strands is 0, must be at least 1");
    if (components < 1 || components > 4)
        return fail(CD_ERROR_VALUE, __func__, "components is %zu, must be 1 to 4", components);
    if (allocator && (!allocator->allocate || !allocator->release))
        return fail(CD_ERROR_NULL, __func__, "allocator has no allocate or no release");
    if ((precision == CD_FLOAT32 && !CD_WITH_FLOAT32) || (precision == CD_FLOAT64 && !CD_WITH_FLOAT64))
        return fail(CD_ERROR_UNSUPPORTED, __func__, "precision %d is left out of this build", int(precision));
    Chain* c = nullptr;
    CD_CHECK(create_chain(__func__, strands, springs, components, precision,
                          allocator ? *allocator : default_allocator(), c));
    *out_chain = reinterpret_cast<cd_chain*>(c);
    return CD_OK;
}

void cd_chain_destroy(cd_chain* chain) {
    if (chain && is_chain(__func__, chain) == CD_OK) destroy_chain(reinterpret_cast<Chain*>(chain));
}

cd_status cd_chain_get_shape(const cd_chain* chain, size_t* out_strands, size_t* out_springs, size_t* out_components,
                             cd_precision* out_precision) {
    CD_THE_CHAIN(const Chain);
    if (out_strands) *out_strands = c.strands;
    if (out_springs) *out_springs = c.springs;
    if (out_components) *out_components = c.components;
    if (out_precision) *out_precision = c.precision;
    return CD_OK;
}

// ---- method and parameters ------------------------------------------------------------------------------------------

static cd_status change_features(const char* function, Chain& c, const Features& wanted) {
    return set_features(c, wanted) ? CD_OK : fail(CD_ERROR_MEMORY, function, "no memory");
}

// Getters that hand out one number of the chain.
#define CD_GETTER(name, type, argument, value)                             \
    cd_status cd_chain_get_##name(const cd_chain* chain, type* argument) { \
        CD_THE_CHAIN(const Chain);                                         \
        CD_NOT_NULL(argument);                                             \
        *argument = value;                                                 \
        return CD_OK;                                                      \
    }
CD_GETTER(method, cd_method, out_method, c.method)
CD_GETTER(lambda, double, out_lambda, c.lambda)
CD_GETTER(mass, double, out_mass, c.mass)
CD_GETTER(mass_rule, cd_mass_rule, out_rule, c.mass_rule)
CD_GETTER(stiffness, double, out_stiffness, c.stiffness)
CD_GETTER(bend, double, out_bend, c.bend)
CD_GETTER(drag, double, out_drag, c.drag)
CD_GETTER(stiffness_damping, double, out_seconds, c.damping)
CD_GETTER(ring, int32_t, out_ring, c.ring)
CD_GETTER(time, double, out_time, time_of(c))
CD_GETTER(steps, uint64_t, out_steps, c.steps)
CD_GETTER(factorizations, uint64_t, out_count, c.factorizations)
CD_GETTER(memory, size_t, out_bytes, c.memory.bytes)

cd_status cd_chain_set_method(cd_chain* chain, cd_method method) {
    CD_THE_CHAIN(Chain);
    CD_CHECK(is_enum(__func__, "method", method, CD_METHOD_STIFF_SECOND));
    Features wanted = features(c);
    wanted.method = method;
    return change_features(__func__, c, wanted);
}

cd_status cd_chain_set_lambda(cd_chain* chain, double lambda) {
    CD_THE_CHAIN(Chain);
    CD_CHECK(in_range(__func__, "lambda", lambda, 0, 1));
    c.lambda = lambda;
    c.prepared_dt = 0;
    return CD_OK;
}

cd_status cd_chain_set_parallel(cd_chain* chain, const cd_parallel* parallel) {
    CD_THE_CHAIN(Chain);
    if (parallel && !parallel->run) return fail(CD_ERROR_NULL, __func__, "parallel has no run");
    c.parallel = parallel ? *parallel : cd_parallel{};
    return CD_OK;
}

static cd_status set_parameter(const char* function, Chain& c, const char* name, double value, double& parameter,
                               double least = 0) {
    CD_CHECK(in_range(function, name, value, least, kMost));
    parameter = value;
    c.prepared_dt = 0;
    return CD_OK;
}

cd_status cd_chain_set_mass(cd_chain* chain, double mass) {
    CD_THE_CHAIN(Chain);
    CD_CHECK(set_parameter(__func__, c, "mass", mass, c.mass, kLeastMass));
    fill_uniform(c, CD_MASS);
    return CD_OK;
}

cd_status cd_chain_set_mass_rule(cd_chain* chain, cd_mass_rule rule) {
    CD_THE_CHAIN(Chain);
    CD_CHECK(is_enum(__func__, "rule", rule, CD_MASS_HALF_ENDS));
    c.mass_rule = rule;
    fill_uniform(c, CD_MASS);
    c.prepared_dt = 0;
    return CD_OK;
}

cd_status cd_chain_set_stiffness(cd_chain* chain, double stiffness) {
    CD_THE_CHAIN(Chain);
    CD_CHECK(set_parameter(__func__, c, "stiffness", stiffness, c.stiffness));
    fill_uniform(c, CD_STIFFNESS);
    return CD_OK;
}

cd_status cd_chain_set_bend(cd_chain* chain, double bend) {
    CD_THE_CHAIN(Chain);
    CD_CHECK(in_range(__func__, "bend", bend, 0, kMost));
    Features wanted = features(c);
    wanted.bend = bend > 0;
    CD_CHECK(change_features(__func__, c, wanted));
    c.bend = bend;
    fill_uniform(c, CD_BEND);
    c.prepared_dt = 0;
    return CD_OK;
}

cd_status cd_chain_set_drag(cd_chain* chain, double drag) {
    CD_THE_CHAIN(Chain);
    return set_parameter(__func__, c, "drag", drag, c.drag);
}

cd_status cd_chain_set_stiffness_damping(cd_chain* chain, double seconds) {
    CD_THE_CHAIN(Chain);
    return set_parameter(__func__, c, "seconds", seconds, c.damping);
}

cd_status cd_chain_set_gravity(cd_chain* chain, const double* gravity, size_t count) {
    CD_THE_CHAIN(Chain);
    CD_NOT_NULL(gravity);
    CD_CHECK(is_count(__func__, "count", count, c.components));
    CD_CHECK(are_numbers(__func__, "gravity", gravity, count, c.precision == CD_FLOAT64 ? kMost : 1e30));
    memcpy(c.gravity, gravity, count * sizeof(double));
    return CD_OK;
}

cd_status cd_chain_get_gravity(const cd_chain* chain, double* out_gravity, size_t count) {
    CD_THE_CHAIN(const Chain);
    CD_NOT_NULL(out_gravity);
    CD_CHECK(is_count(__func__, "count", count, c.components));
    memcpy(out_gravity, c.gravity, count * sizeof(double));
    return CD_OK;
}

cd_status cd_chain_set_end(cd_chain* chain, cd_end end, cd_node kind) {
    CD_THE_CHAIN(Chain);
    CD_CHECK(is_enum(__func__, "end", end, CD_END_LAST));
    CD_CHECK(is_enum(__func__, "kind", kind, CD_NODE_MATCHED));
    if (kind == CD_NODE_MATCHED && c.ring)
        return fail(CD_ERROR_UNSUPPORTED, __func__, "kind is 3, matched: a ring has no end");
    const double value = kind;
    return cd_chain_write_f64(chain, CD_PIN, 0, 1, end == CD_END_FIRST ? 0 : c.springs, 1, &value, 1);
}

cd_status cd_chain_get_end(const cd_chain* chain, cd_end end, cd_node* out_kind) {
    CD_THE_CHAIN(const Chain);
    CD_CHECK(is_enum(__func__, "end", end, CD_END_LAST));
    CD_NOT_NULL(out_kind);
    *out_kind = c.pin[end == CD_END_FIRST ? 0 : c.springs];
    return CD_OK;
}

cd_status cd_chain_set_ring(cd_chain* chain, int32_t ring) {
    CD_THE_CHAIN(Chain);
    if (ring != 0 && ring != 1) return fail(CD_ERROR_VALUE, __func__, "ring is %d, must be 0 or 1", int(ring));
    if (ring && c.nodes < 3)
        return fail(CD_ERROR_UNSUPPORTED, __func__, "ring is 1, but of %zu nodes, fewer than 3", c.nodes);
    for (size_t i : {size_t(0), c.springs})
        if (ring && c.pin[i] == CD_NODE_MATCHED)
            return fail(CD_ERROR_UNSUPPORTED, __func__, "ring is 1, but node %zu is a matched end", i);
    if (ring == c.ring) return CD_OK;
    Features wanted = features(c);
    wanted.ring = ring != 0;
    CD_CHECK(change_features(__func__, c, wanted));
    fill_uniform(c, CD_MASS);
    fill_uniform(c, CD_BEND);
    return CD_OK;
}

// ---- time -----------------------------------------------------------------------------------------------------------

cd_status cd_chain_step(cd_chain* chain, double dt, size_t count) {
    CD_THE_CHAIN(Chain);
    CD_CHECK(in_range(__func__, "dt", dt, 1e-30, 1e30));
    if (count == 0) return CD_OK;
    if (c.diverged && !all_finite(c))
        return fail(CD_ERROR_DIVERGED, __func__, "the state of step %llu is not finite", (unsigned long long)c.steps);
    if (const uint64_t bad = step_chain(c, dt, count))
        return fail(CD_ERROR_DIVERGED, __func__, "a number left the finite range at step %llu",
                    (unsigned long long)bad);
    return CD_OK;
}

cd_status cd_chain_stable_dt(const cd_chain* chain, double* out_dt) {
    CD_THE_CHAIN(const Chain);
    CD_NOT_NULL(out_dt);
    *out_dt = stable_dt(c);
    return CD_OK;
}

cd_status cd_chain_reset(cd_chain* chain) {
    CD_THE_CHAIN(Chain);
    memset(c.position.data, 0, c.position.bytes());
    memset(c.velocity.data, 0, c.velocity.bytes());
    c.clock_start = c.clock_dt = 0;
    c.clock_steps = c.steps = 0;
    c.diverged = false;
    return CD_OK;
}

// ---- measuring ------------------------------------------------------------------------------------------------------

cd_status cd_chain_get_energy(const cd_chain* chain, double* out_kinetic, double* out_elastic, double* out_gravity) {
    CD_THE_CHAIN(const Chain);
    double kinetic, elastic, gravity;
    energy(c, kinetic, elastic, gravity);
    if (out_kinetic) *out_kinetic = kinetic;
    if (out_elastic) *out_elastic = elastic;
    if (out_gravity) *out_gravity = gravity;
    return CD_OK;
}

cd_status cd_chain_get_momentum(const cd_chain* chain, double* out_momentum, size_t count) {
    CD_THE_CHAIN(const Chain);
    CD_NOT_NULL(out_momentum);
    CD_CHECK(is_count(__func__, "count", count, c.components));
    momentum(c, out_momentum);
    return CD_OK;
}

cd_status cd_chain_hash(const cd_chain* chain, uint64_t* out_hash) {
    CD_THE_CHAIN(const Chain);
    CD_NOT_NULL(out_hash);
    *out_hash = hash_chain(c);
    return CD_OK;
}

// ---- keeping --------------------------------------------------------------------------------------------------------

cd_status cd_chain_save_size(const cd_chain* chain, size_t* out_size) {
    CD_THE_CHAIN(const Chain);
    CD_NOT_NULL(out_size);
    *out_size = saved_size(c);
    return CD_OK;
}

cd_status cd_chain_save(const cd_chain* chain, void* buffer, size_t size, size_t* out_written) {
    CD_THE_CHAIN(const Chain);
    CD_NOT_NULL(buffer);
    CD_NOT_NULL(out_written);
    const size_t needed = saved_size(c);
    if (size < needed) return fail(CD_ERROR_RANGE, __func__, "size is %zu, must be at least %zu", size, needed);
    save_chain(c, static_cast<unsigned char*>(buffer));
    *out_written = needed;
    return CD_OK;
}

cd_status cd_chain_load(cd_chain* chain, const void* bytes, size_t size) {
    CD_THE_CHAIN(Chain);
    CD_NOT_NULL(bytes);
    return load_chain(__func__, c, static_cast<const unsigned char*>(bytes), size);
}

cd_status cd_chain_copy_state(cd_chain* chain, const cd_chain* source) {
    CD_THE_CHAIN(Chain);
    CD_CHECK(is_chain(__func__, source, "source"));
    return chain == source ? CD_OK : copy_chain(__func__, c, *reinterpret_cast<const Chain*>(source));
}
