// The functions that objects share, each written once; CD_OBJECT_FUNCTIONS and CD_BODY_FUNCTIONS at the end make an
// object's public functions of them. A function here takes the name of the public one, the object, and its arguments.
// An object that one does not fit has an overload of its own: api/water_handle.hh.
#pragma once

#include "api/fields.hh"
#include "api/handle.hh"

namespace cd {
namespace shared {

constexpr double kMostSkew = 1e-6; // of a rotation: how far products of its rows may be from 0 and 1

// ---- life -----------------------------------------------------------------------------------------------------------

// What every create is given beside sizes.
inline cd_status can_make(const char* function, size_t components, cd_precision precision,
                          const cd_allocator* allocator) {
    CD_CHECK(is_enum(function, "precision", precision, CD_FLOAT64));
    if (components < 1 || components > 4)
        return fail(CD_ERROR_VALUE, function, "components is %zu, must be 1 to 4", components);
    if (allocator && (!allocator->allocate || !allocator->release))
        return fail(CD_ERROR_NULL, function, "allocator has a null allocate or release");
    if ((precision == CD_FLOAT32 && !CD_WITH_FLOAT32) || (precision == CD_FLOAT64 && !CD_WITH_FLOAT64))
        return fail(CD_ERROR_UNSUPPORTED, function, "precision is %d, which is left out of this build", int(precision));
    return CD_OK;
}

// ---- method and parameters ------------------------------------------------------------------------------------------

template <class N> cd_status tell(const char* function, const char* name, N* out, N value) {
    CD_CHECK(not_null(function, name, out));
    *out = value;
    return CD_OK;
}

template <class X, class F> cd_status change_features(const char* function, X& x, const F& wanted) {
    CD_CHECK(is_built(function, left_out(wanted)));
    if (!set_features(x, wanted)) return fail(CD_ERROR_MEMORY, function, "no memory");
    wake(x);
    return CD_OK;
}

template <class X> cd_status set_method(const char* function, X& x, cd_method method) {
    CD_CHECK(is_enum(function, "method", method, CD_METHOD_STIFF_SECOND));
    auto wanted = features(x);
    wanted.method = method;
    return change_features(function, x, wanted);
}

// Of objects with coupled solves.
template <class X> cd_status set_tolerance(const char* function, X& x, double tolerance, size_t most_iterations) {
    CD_CHECK(in_range(function, "tolerance", tolerance, kLeastTolerance, kMostTolerance));
    if (most_iterations < 1) return fail(CD_ERROR_VALUE, function, "most_iterations is 0, must be at least 1");
    x.tolerance = tolerance;
    x.most_iterations = most_iterations;
    return CD_OK;
}
template <class X>
cd_status get_tolerance(const char* function, const X& x, double* out_tolerance, size_t* out_most_iterations) {
    CD_CHECK(not_null(function, "out_most_iterations", out_most_iterations));
    CD_CHECK(tell(function, "out_tolerance", out_tolerance, x.tolerance));
    *out_most_iterations = x.most_iterations;
    return CD_OK;
}
template <class X> cd_status get_convergence(const X& x, size_t* out_iterations, double* out_residual) {
    if (out_iterations) *out_iterations = x.iterations;
    if (out_residual) *out_residual = x.residual;
    return CD_OK;
}

inline cd_status set_parameter(const char* function, Object& o, const char* name, double value, double& parameter,
                               double least = 0, double most = kMost) {
    CD_CHECK(in_range(function, name, value, least, most));
    parameter = value;
    changed(o);
    return CD_OK;
}

inline cd_status set_parallel(const char* function, Object& o, const cd_parallel* parallel) {
    if (parallel && !parallel->run) return fail(CD_ERROR_NULL, function, "parallel->run is null");
    o.parallel = parallel ? *parallel : cd_parallel{};
    return CD_OK;
}

template <class Table> cd_status set_kernels(const char* function, const Table*& of_object, cd_kernels kernels) {
    CD_CHECK(is_enum(function, "kernels", kernels, CD_KERNELS_AVX512));
    const Table* const wanted = kernels_of<Table>(kernels);
    if (!wanted)
        return fail(CD_ERROR_UNSUPPORTED, function, "kernels is %d, %s: not in this build, or not for this processor",
                    int(kernels), cd_kernels_name(kernels));
    of_object = wanted;
    return CD_OK;
}

template <class X> cd_status set_mass(const char* function, X& x, double mass) {
    CD_CHECK(set_parameter(function, x, "mass", mass, x.mass, kLeastMass));
    fill_uniform(x, CD_MASS);
    return CD_OK;
}

template <class X> cd_status set_mass_rule(const char* function, X& x, cd_mass_rule rule) {
    CD_CHECK(is_enum(function, "rule", rule, CD_MASS_HALF_ENDS));
    x.mass_rule = rule;
    for (cd_field field : {CD_MASS, CD_STIFFNESS_U, CD_STIFFNESS_V}) fill_uniform(x, field);
    changed(x);
    return CD_OK;
}

template <class X> cd_status set_bend(const char* function, X& x, double bend) {
    CD_CHECK(in_range(function, "bend", bend, 0, kMost));
    auto wanted = features(x);
    wanted.bend = bend > 0;
    CD_CHECK(change_features(function, x, wanted));
    x.bend = bend;
    fill_uniform(x, CD_BEND);
    changed(x);
    return CD_OK;
}

inline cd_status set_gravity(const char* function, Body& b, const double* gravity, size_t count) {
    CD_CHECK(not_null(function, "gravity", gravity));
    CD_CHECK(is_count(function, "count", count, b.components));
    CD_CHECK(are_numbers(function, "gravity", gravity, count, is_wide(b) ? kMost : 1e30));
    memcpy(b.gravity, gravity, count * sizeof(double));
    wake(b);
    return CD_OK;
}

inline cd_status get_gravity(const char* function, const Body& b, double* out_gravity, size_t count) {
    CD_CHECK(not_null(function, "out_gravity", out_gravity));
    CD_CHECK(is_count(function, "count", count, b.components));
    memcpy(out_gravity, b.gravity, count * sizeof(double));
    return CD_OK;
}

template <class X> cd_status set_sleep(const char* function, X& x, double speed, double seconds) {
    CD_CHECK(in_range(function, "speed", speed, 0, kMost));
    if (speed > 0) CD_CHECK(in_range(function, "seconds", seconds, kLeastStep, kMost));
    auto wanted = features(x);
    wanted.sleep = speed > 0;
    CD_CHECK(change_features(function, x, wanted));
    x.sleep_speed = speed + 0.0; // not -0
    x.sleep_seconds = speed > 0 ? seconds : 0;
    return CD_OK;
}
inline cd_status get_sleep(const char* function, const Body& b, double* out_speed, double* out_seconds) {
    CD_CHECK(not_null(function, "out_seconds", out_seconds));
    CD_CHECK(tell(function, "out_speed", out_speed, b.sleep_speed));
    *out_seconds = b.sleep_seconds;
    return CD_OK;
}

// Whether the state is finite, as it is but after a step that diverged.
template <class X> cd_status is_finite(const char* function, const X& x) {
    if (!x.diverged || all_finite(x)) return CD_OK;
    return fail(CD_ERROR_DIVERGED, function, "the state after step %llu is not finite: reset, load or write it",
                (unsigned long long)x.clock.steps);
}

// ---- fields: an object says by is_field, is_always_on and switch_own what it has ------------------------------------

// What every body has, and what is no body has not.
inline void switch_body(BodyFeatures* wanted, cd_field field, bool on) {
    if (field == CD_FORCE) wanted->force = on;
    if (field == CD_MASS) wanted->node_mass = on;
    if (field == CD_TARGET) wanted->target = on;
}
inline void switch_body(void*, cd_field, bool) {}

template <class X> cd_status switch_field(const char* function, X& x, cd_field field, bool on) {
    auto wanted = features(x);
    switch_body(&wanted, field, on);
    switch_own(wanted, field, on);
    CD_CHECK(is_built(function, left_out(wanted)));
    return set_features(x, wanted) ? CD_OK : fail(CD_ERROR_MEMORY, function, "no memory for %s", field_name(field));
}

template <class X> cd_status enable_field(const char* function, X& x, cd_field field) {
    CD_CHECK(is_field(function, x, field));
    CD_CHECK(has_length(function, x, field));
    if (field == CD_TARGET) CD_CHECK(is_finite(function, x)); // targets start as the present positions
    return switch_field(function, x, field, true);
}

template <class X> cd_status disable_field(const char* function, X& x, cd_field field) {
    CD_CHECK(is_field(function, x, field));
    if (is_always_on(x, field))
        return fail(CD_ERROR_UNSUPPORTED, function, "field is %d, %s, which is always on", int(field),
                    field_name(field));
    CD_CHECK(switch_field(function, x, field, false));
    wake(x);
    return CD_OK;
}

// ---- attachments ----------------------------------------------------------------------------------------------------

// node: where a field per node has its number; each_place(f) makes f(component, place) for every number that the node
// has in an array of the state.
template <class X, class EachPlace> cd_status attach(const char* function, X& x, size_t node, double stiffness,
                                                     double damping, const double* target, size_t count,
                                                     EachPlace each_place) {
    CD_CHECK(in_range(function, "stiffness", stiffness, 0, kMost));
    CD_CHECK(in_range(function, "damping", damping, 0, kMost));
    if (target) CD_CHECK(is_count(function, "count", count, x.components));
    if (target) CD_CHECK(are_numbers(function, "target", target, count, most_of(x)));
    if (!target || !x.target) CD_CHECK(is_finite(function, x)); // some target will be the present position
    CD_CHECK(switch_field(function, x, CD_TARGET, true));
    x.attach_stiffness[node] = stiffness;
    x.attach_damping[node] = damping;
    each_place([&](size_t component, size_t at) {
        set_number(x, x.target, at, target ? target[component] : get_number(x, x.position, at));
    });
    x.prepared_dt = 0;
    wake(x, node, 1);
    return CD_OK;
}

inline cd_status detach(Body& b, size_t node) {
    if (!b.target) return CD_OK;
    b.attach_stiffness[node] = b.attach_damping[node] = 0;
    b.prepared_dt = 0;
    wake(b, node, 1);
    return CD_OK;
}

inline cd_status get_attachment(const char* function, const Body& b, size_t node, double* out_stiffness,
                                double* out_damping) {
    CD_CHECK(not_null(function, "out_stiffness", out_stiffness));
    CD_CHECK(not_null(function, "out_damping", out_damping));
    *out_stiffness = tie_of(b, node);
    *out_damping = tie_damping_of(b, node);
    return CD_OK;
}

// ---- moving all at once ---------------------------------------------------------------------------------------------

inline cd_status is_rotation(const char* function, const double* rotation, size_t n) {
    CD_CHECK(are_numbers(function, "rotation", rotation, n * n, 2));
    for (size_t i = 0; i < n; ++i)
        for (size_t j = 0; j <= i; ++j) {
            double product = i == j ? -1 : 0;
            for (size_t k = 0; k < n; ++k) product += rotation[i * n + k] * rotation[j * n + k];
            if (!(fabs(product) <= kMostSkew))
                return fail(CD_ERROR_VALUE, function,
                            "rotation is not orthogonal: the product of rows %zu and %zu is off by %g", j, i, product);
        }
    return CD_OK;
}

// change: of velocities, or empty; it turns as they do. each_node(f) makes f(place) for every node that moves; its
// components lie `stride` numbers apart.
template <class X, class EachNode> cd_status teleport(const char* function, X& x, const Array<char>& change,
                                                      const double* rotation, const double* offset, size_t count,
                                                      size_t stride, EachNode each_node) {
    CD_CHECK(not_null(function, "offset", offset));
    CD_CHECK(is_count(function, "count", count, x.components));
    CD_CHECK(are_numbers(function, "offset", offset, count, most_of(x)));
    if (rotation) CD_CHECK(is_rotation(function, rotation, count));
    CD_CHECK(is_finite(function, x));
    const auto moved = [&](const Array<char>& array, size_t at, size_t k) {
        double sum = rotation ? 0 : get_number(x, array, at + k * stride);
        for (size_t j = 0; j < count && rotation; ++j)
            sum += rotation[k * count + j] * get_number(x, array, at + j * stride);
        return &array == &x.velocity || &array == &change ? sum : sum + offset[k];
    };
    bool fits = true;
    const Array<char>* const arrays[] = {&x.position, &x.velocity, &x.target, &change};
    for (bool put : {false, true}) { // all or none
        for (const Array<char>* array : arrays)
            if (*array)
                each_node([&](size_t at) {
                    double to[4];
                    for (size_t k = 0; k < count; ++k) to[k] = moved(*array, at, k), fits &= fabs(to[k]) <= most_of(x);
                    for (size_t k = 0; put && k < count; ++k) set_number(x, *array, at + k * stride, to[k]);
                });
        if (!fits)
            return fail(CD_ERROR_VALUE, function, "rotation and offset would move a number out of the finite range");
    }
    return CD_OK;
}

// ---- time -----------------------------------------------------------------------------------------------------------

// Whether the object can make steps of dt: with 0 it makes none.
template <class X> cd_status can_step(const char* function, const X& x, double dt, size_t& count) {
    if (dt == 0) count = 0;
    else if (!(dt >= kLeastStep && dt <= kMostStep))
        return fail(CD_ERROR_VALUE, function, "dt is %g, must be 0 or in [%g, %g]", dt, kLeastStep, kMostStep);
    return count > 0 ? is_finite(function, x) : CD_OK;
}
inline cd_status diverged_at(const char* function, uint64_t step) {
    return fail(CD_ERROR_DIVERGED, function, "a number left the finite range at step %llu", (unsigned long long)step);
}

// Whether springs that have a length can make their next step; lack: what they have that they do not take, or null.
inline cd_status takes_all(const char* function, const char* lack) {
    return lack ? fail(CD_ERROR_UNSUPPORTED, function, "springs that have a length take no %s", lack) : CD_OK;
}

// Before steps, whether all colliders are known; and after them, whether their callbacks told distances.
inline cd_status knows_colliders(const char* function, const Body& b) {
    const size_t index = unanswered(b);
    if (index == SIZE_MAX) return CD_OK;
    return fail(CD_ERROR_UNSUPPORTED, function, "collider %zu has lost its callback: set it again", index);
}
inline cd_status was_told_distances(const char* function, const Body& b) {
    const BadAnswer& bad = b.bad_answer;
    if (bad.collider == SIZE_MAX) return CD_OK;
    return fail(CD_ERROR_CALLBACK, function,
                "the callback of collider %zu gave a distance of %g and a normal of length %g: taken for nothing there",
                bad.collider, bad.distance, bad.length);
}

template <class X> cd_status tell_stable_dt(const char* function, const X& x, double* out) {
    CD_CHECK(not_null(function, "out_dt", out));
    if (has_lengths(x))
        return fail(CD_ERROR_UNSUPPORTED, function, "no explicit method steps springs that have a length");
    return tell(function, "out_dt", out, stable_dt(x));
}

template <class X> cd_status reset(X& x) {
    clear_state(x);
    x.diverged = false;
    return CD_OK;
}

// ---- measuring ------------------------------------------------------------------------------------------------------

template <class X> cd_status get_energy(const X& x, double* out_kinetic, double* out_elastic, double* out_gravity) {
    double kinetic, elastic, gravity;
    energy(x, kinetic, elastic, gravity);
    if (out_kinetic) *out_kinetic = kinetic;
    if (out_elastic) *out_elastic = elastic;
    if (out_gravity) *out_gravity = gravity;
    return CD_OK;
}

template <class X> cd_status get_momentum(const char* function, const X& x, double* out_momentum, size_t count) {
    CD_CHECK(not_null(function, "out_momentum", out_momentum));
    CD_CHECK(is_count(function, "count", count, x.components));
    momentum(x, out_momentum);
    return CD_OK;
}

// ---- keeping --------------------------------------------------------------------------------------------------------

inline cd_status can_save(const char* function) {
    return is_built(function, CD_WITH_SAVE ? nullptr : "saved states are");
}

template <class X> cd_status tell_save_size(const char* function, const X& x, size_t* out_size) {
    CD_CHECK(not_null(function, "out_size", out_size));
    CD_CHECK(can_save(function));
    if constexpr (CD_WITH_SAVE) *out_size = save_size(x);
    return CD_OK;
}

template <class X>
cd_status write_saved(const char* function, const X& x, void* buffer, size_t size, size_t* out_written) {
    CD_CHECK(not_null(function, "buffer", buffer));
    CD_CHECK(not_null(function, "out_written", out_written));
    CD_CHECK(can_save(function));
    if constexpr (CD_WITH_SAVE) {
        const size_t needed = save_size(x);
        if (size < needed) return fail(CD_ERROR_RANGE, function, "size is %zu, must be at least %zu", size, needed);
        save(x, static_cast<unsigned char*>(buffer));
        *out_written = needed;
    }
    return CD_OK;
}

template <class X> cd_status load_saved(const char* function, X& x, const void* bytes, size_t size) {
    CD_CHECK(not_null(function, "bytes", bytes));
    CD_CHECK(can_save(function));
    if constexpr (CD_WITH_SAVE) return load(function, x, static_cast<const unsigned char*>(bytes), size);
    return CD_OK;
}

template <class X, class Handle> cd_status copy_state(const char* function, X& x, const Handle* source) {
    CD_CHECK(is_living(function, source, "source"));
    const X& from = behind(source);
    return &x == &from ? CD_OK : copy(function, x, from);
}

} // namespace shared
} // namespace cd

// ---- the public functions -------------------------------------------------------------------------------------------

#define CD_UNWRAP(...) __VA_ARGS__

// cd_<object>_<name>(object, parameters): checks the handle and gives `value`, in which x is the object.
#define CD_FUNCTION(object, constant, name, parameters, value)                           \
    cd_status cd_##object##_##name(constant cd_##object* object, CD_UNWRAP parameters) { \
        CD_OPEN(object, x);                                                              \
        return value;                                                                    \
    }
// cd_<object>_<name>(object, type* out): tells `value`.
#define CD_GETTER(object, name, type, out, value) \
    CD_FUNCTION(object, const, name, (type * out), (shared::tell<type>(__func__, #out, out, value)))

// What any object has.
#define CD_OBJECT_FUNCTIONS(object)                                                                                 \
    void cd_##object##_destroy(cd_##object* object) {                                                               \
        if (object && ::cd::is_living(__func__, object) == CD_OK) destroy(&::cd::behind(object));                   \
    }                                                                                                               \
    CD_FUNCTION(object, , set_method, (cd_method method), shared::set_method(__func__, x, method))                  \
    CD_GETTER(object, get_method, cd_method, out_method, x.method)                                                  \
    CD_FUNCTION(object, , set_lambda, (double lambda),                                                              \
                shared::set_parameter(__func__, x, "lambda", lambda, x.lambda, 0, 1))                               \
    CD_GETTER(object, get_lambda, double, out_lambda, x.lambda)                                                     \
    CD_FUNCTION(object, , set_parallel, (const cd_parallel* parallel), shared::set_parallel(__func__, x, parallel)) \
    CD_FUNCTION(object, , set_kernels, (cd_kernels kernels), shared::set_kernels(__func__, x.kernels, kernels))     \
    CD_GETTER(object, get_kernels, cd_kernels, out_kernels, x.kernels->set)                                         \
    CD_FUNCTION(object, , enable_field, (cd_field field), shared::enable_field(__func__, x, field))                 \
    CD_FUNCTION(object, , disable_field, (cd_field field), shared::disable_field(__func__, x, field))               \
    CD_FUNCTION(object, const, stable_dt, (double* out_dt), shared::tell_stable_dt(__func__, x, out_dt))            \
    CD_GETTER(object, get_time, double, out_time, x.clock.time())                                                   \
    CD_GETTER(object, get_steps, uint64_t, out_steps, x.clock.steps)                                                \
    CD_GETTER(object, get_factorizations, uint64_t, out_count, x.factorizations)                                    \
    CD_GETTER(object, get_memory, size_t, out_bytes, x.memory.bytes)                                                \
    CD_GETTER(object, hash, uint64_t, out_hash, hash(x))                                                            \
    CD_FUNCTION(object, const, save_size, (size_t * out_size), shared::tell_save_size(__func__, x, out_size))       \
    CD_FUNCTION(object, const, save, (void* buffer, size_t size, size_t* out_written),                              \
                shared::write_saved(__func__, x, buffer, size, out_written))                                        \
    CD_FUNCTION(object, , load, (const void* bytes, size_t size), shared::load_saved(__func__, x, bytes, size))     \
    CD_FUNCTION(object, , copy_state, (const cd_##object* source), shared::copy_state(__func__, x, source))         \
    cd_status cd_##object##_reset(cd_##object* object) {                                                            \
        CD_OPEN(object, x);                                                                                         \
        return shared::reset(x);                                                                                    \
    }

// And what a body has.
#define CD_BODY_FUNCTIONS(object)                                                                                    \
    CD_FUNCTION(object, , set_mass, (double mass), shared::set_mass(__func__, x, mass))                              \
    CD_GETTER(object, get_mass, double, out_mass, x.mass)                                                            \
    CD_FUNCTION(object, , set_mass_rule, (cd_mass_rule rule), shared::set_mass_rule(__func__, x, rule))              \
    CD_GETTER(object, get_mass_rule, cd_mass_rule, out_rule, x.mass_rule)                                            \
    CD_FUNCTION(object, , set_bend, (double bend), shared::set_bend(__func__, x, bend))                              \
    CD_GETTER(object, get_bend, double, out_bend, x.bend)                                                            \
    CD_FUNCTION(object, , set_drag, (double drag), shared::set_parameter(__func__, x, "drag", drag, x.drag))         \
    CD_GETTER(object, get_drag, double, out_drag, x.drag)                                                            \
    CD_FUNCTION(object, , set_stiffness_damping, (double seconds),                                                   \
                shared::set_parameter(__func__, x, "seconds", seconds, x.damping))                                   \
    CD_GETTER(object, get_stiffness_damping, double, out_seconds, x.damping)                                         \
    CD_FUNCTION(object, , set_gravity, (const double* gravity, size_t count),                                        \
                shared::set_gravity(__func__, x, gravity, count))                                                    \
    CD_FUNCTION(object, const, get_gravity, (double* out_gravity, size_t count),                                     \
                shared::get_gravity(__func__, x, out_gravity, count))                                                \
    CD_FUNCTION(object, , set_sleep, (double speed, double seconds), shared::set_sleep(__func__, x, speed, seconds)) \
    CD_FUNCTION(object, const, get_sleep, (double* out_speed, double* out_seconds),                                  \
                shared::get_sleep(__func__, x, out_speed, out_seconds))                                              \
    CD_GETTER(object, get_awake, size_t, out_nodes, awake_nodes(x))                                                  \
    CD_FUNCTION(object, const, get_energy, (double* out_kinetic, double* out_elastic, double* out_gravity),          \
                shared::get_energy(x, out_kinetic, out_elastic, out_gravity))                                        \
    CD_FUNCTION(object, const, get_momentum, (double* out_momentum, size_t count),                                   \
                shared::get_momentum(__func__, x, out_momentum, count))
