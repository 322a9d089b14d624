// What surrounds ropes and cloth: air, and colliders. Each function is written once, as those of shared.hh are, and those
// that need nothing of ropes or cloth but that they have colliders are compiled once, too (colliders.cpp);
// CD_SURROUNDINGS_FUNCTIONS at the end makes an object's public functions of them. An object says by feels_air and
// touches whether it has any, by has_collider whether that one, by can_touch whether this build has any for it, and by
// air_of where its settings of the air are.
#pragma once

#include "api/shared.hh"

namespace cd {
namespace shared {

// ---- air ------------------------------------------------------------------------------------------------------------

template <class X> cd_status set_air(const char* function, X& x, double along, double across) {
    CD_CHECK(in_range(function, "along", along, 0, kMost));
    CD_CHECK(in_range(function, "across", across, 0, kMost));
    CD_CHECK(feels_air(function, x));
    auto wanted = features(x);
    wanted.air = along > 0 || across > 0;
    CD_CHECK(change_features(function, x, wanted));
    air_of(x).along = along + 0.0; // not -0
    air_of(x).across = across + 0.0;
    return CD_OK;
}

template <class X> cd_status get_air(const char* function, const X& x, double* out_along, double* out_across) {
    CD_CHECK(not_null(function, "out_along", out_along));
    CD_CHECK(tell(function, "out_across", out_across, air_of(x).across));
    *out_along = air_of(x).along;
    return CD_OK;
}

template <class X> cd_status set_wind(const char* function, X& x, const double* velocity, size_t count) {
    CD_CHECK(not_null(function, "velocity", velocity));
    CD_CHECK(is_count(function, "count", count, x.components));
    CD_CHECK(are_numbers(function, "velocity", velocity, count, most_of(x)));
    CD_CHECK(feels_air(function, x));
    for (size_t k = 0; k < count; ++k) air_of(x).wind[k] = velocity[k] + 0.0; // not -0
    fill_uniform(x, CD_WIND);
    wake(x);
    return CD_OK;
}

template <class X> cd_status get_wind(const char* function, const X& x, double* out_velocity, size_t count) {
    CD_CHECK(not_null(function, "out_velocity", out_velocity));
    CD_CHECK(is_count(function, "count", count, x.components));
    for (size_t k = 0; k < count; ++k) out_velocity[k] = k < 3 ? air_of(x).wind[k] : 0;
    return CD_OK;
}

// ---- colliders ------------------------------------------------------------------------------------------------------

template <class X> cd_status is_collider(const char* function, const X& x, size_t index, size_t count) {
    CD_CHECK(touches(function, x));
    CD_CHECK(has_collider(function, x, index));
    return is_count(function, "count", count, x.components);
}
template <class X> cd_status set_colliders(const char* function, X& x, size_t count) {
    if (count > kMostColliders)
        return fail(CD_ERROR_VALUE, function, "count is %zu, must be at most %zu", count, kMostColliders);
    if (!CD_WITH_CONTACT && count > 0) return is_built(function, "colliders are");
    CD_CHECK(touches(function, x));
    auto wanted = features(x);
    const size_t had = wanted.colliders.count;
    wanted.colliders = collider_sizes(x, count < had ? count : had);
    wanted.colliders.count = count;
    return change_features(function, x, wanted);
}

// name: what the distance is called
template <class X>
cd_status set_thickness(const char* function, X& x, const char* name, double distance, double& thickness) {
    CD_CHECK(in_range(function, name, distance, 0, kMost));
    CD_CHECK(touches(function, x));
    thickness = distance + 0.0; // not -0
    wake(x);
    return CD_OK;
}

// A rope or cloth whose colliders are known to be asked for rightly, and how it gets memory for others.
struct Touching {
    Body& body;
    bool (*take)(Body& body, const ColliderSizes& colliders);
};
template <class X> Touching touching(X& x) {
    return {x, [](Body& body, const ColliderSizes& colliders) {
                X& of = static_cast<X&>(body);
                auto wanted = features(of);
                wanted.colliders = colliders;
                return set_features(of, wanted);
            }};
}

// What is done with a collider that is there, and told of it (colliders.cpp).
cd_status set_plane(const char* function, const Touching& x, size_t index, const double* point, const double* normal,
                    size_t count, double friction);
cd_status set_capsule(const char* function, const Touching& x, size_t index, const double* first, const double* last,
                      size_t count, double radius, double friction);
cd_status set_bed(const char* function, const Touching& x, size_t index, const double* origin, size_t count,
                  size_t columns, size_t rows, double column_spacing, double row_spacing, const double* heights,
                  size_t height_count, double friction);
cd_status set_callback(const char* function, const Touching& x, size_t index, const cd_distance* distance,
                       const double* origin, size_t count, double friction);
cd_status remove_collider(const char* function, const Touching& x, size_t index);
cd_status set_collider_velocity(const char* function, const Touching& x, size_t index, const double* velocity,
                                size_t count);
cd_status get_collider(const char* function, const Body& b, size_t index, cd_shape* out_shape, double* out_first,
                       double* out_second, double* out_velocity, size_t count, double* out_radius,
                       double* out_friction);
cd_status get_bed(const char* function, const Body& b, size_t index, size_t* out_columns, size_t* out_rows,
                  double* out_heights, size_t height_count);

// Whether what colliders bear is told.
template <class X> cd_status set_loads(const char* function, X& x, int32_t loads) {
    if (loads != 0 && loads != 1) return fail(CD_ERROR_VALUE, function, "loads is %d, must be 0 or 1", int(loads));
    CD_CHECK(touches(function, x));
    auto wanted = features(x);
    wanted.loads = loads != 0;
    return change_features(function, x, wanted);
}

template <class X>
cd_status get_load(const char* function, const X& x, const char* setter, size_t index, double* out, size_t count) {
    CD_CHECK(not_null(function, "out_load", out));
    CD_CHECK(has_collider(function, x, index));
    CD_CHECK(is_count(function, "count", count, kLoadNumbers));
    if (!x.loads) return fail(CD_ERROR_DISABLED, function, "loads are not told: see %s", setter);
    sum_loads(x, index, out);
    return CD_OK;
}

} // namespace shared
} // namespace cd

// Of the collider `index`; numbers: how many components are given. Where nothing in this build can touch one the check
// says so, and `value` takes no code.
#define CD_COLLIDER_FUNCTION(object, name, parameters, numbers, value)          \
    cd_status cd_##object##_##name(cd_##object* object, CD_UNWRAP parameters) { \
        CD_OPEN(object, x);                                                     \
        CD_CHECK(shared::is_collider(__func__, x, index, numbers));             \
        return can_touch(x) ? shared::name value : CD_OK;                       \
    }
// Likewise, of what is told of it.
#define CD_COLLIDER_GETTER(object, name, parameters, value)                           \
    cd_status cd_##object##_##name(const cd_##object* object, CD_UNWRAP parameters) { \
        CD_OPEN(object, x);                                                           \
        CD_CHECK(has_collider(__func__, x, index));                                   \
        return can_touch(x) ? shared::value : CD_OK;                                  \
    }

#define CD_SURROUNDINGS_FUNCTIONS(object)                                                                              \
    CD_FUNCTION(object, , set_air, (double along, double across), shared::set_air(__func__, x, along, across))         \
    CD_FUNCTION(object, const, get_air, (double* out_along, double* out_across),                                       \
                shared::get_air(__func__, x, out_along, out_across))                                                   \
    CD_FUNCTION(object, , set_wind, (const double* velocity, size_t count),                                            \
                shared::set_wind(__func__, x, velocity, count))                                                        \
    CD_FUNCTION(object, const, get_wind, (double* out_velocity, size_t count),                                         \
                shared::get_wind(__func__, x, out_velocity, count))                                                    \
    CD_FUNCTION(object, , set_colliders, (size_t count), shared::set_colliders(__func__, x, count))                    \
    CD_GETTER(object, get_colliders, size_t, out_count, collider_count(x))                                             \
    CD_COLLIDER_FUNCTION(object, set_plane,                                                                            \
                (size_t index, const double* point, const double* normal, size_t count, double friction),              \
                count, (__func__, shared::touching(x), index, point, normal, count, friction))                         \
    CD_COLLIDER_FUNCTION(object, set_capsule,                                                                          \
                (size_t index, const double* first, const double* last, size_t count, double radius, double friction), \
                count, (__func__, shared::touching(x), index, first, last, count, radius, friction))                   \
    CD_COLLIDER_FUNCTION(object, set_bed,                                                                              \
                (size_t index, const double* origin, size_t count, size_t columns, size_t rows, double column_spacing, \
                 double row_spacing, const double* heights, size_t height_count, double friction),                     \
                count,                                                                                                 \
                (__func__, shared::touching(x), index, origin, count, columns, rows, column_spacing, row_spacing,      \
                 heights, height_count, friction))                                                                     \
    CD_COLLIDER_GETTER(object, get_bed,                                                                                \
                (size_t index, size_t * out_columns, size_t* out_rows, double* out_heights, size_t height_count),      \
                get_bed(__func__, x, index, out_columns, out_rows, out_heights, height_count))                         \
    CD_COLLIDER_FUNCTION(object, set_callback,                                                                         \
                (size_t index, const cd_distance* distance, const double* origin, size_t count, double friction),      \
                origin ? count : x.components,                                                                         \
                (__func__, shared::touching(x), index, distance, origin, count, friction))                             \
    CD_COLLIDER_FUNCTION(object, remove_collider, (size_t index), x.components,                                        \
                (__func__, shared::touching(x), index))                                                                \
    CD_COLLIDER_FUNCTION(object, set_collider_velocity, (size_t index, const double* velocity, size_t count),          \
                count, (__func__, shared::touching(x), index, velocity, count))                                        \
    CD_COLLIDER_GETTER(object, get_collider,                                                                           \
                (size_t index, cd_shape * out_shape, double* out_first, double* out_second, double* out_velocity,      \
                 size_t count, double* out_radius, double* out_friction),                                              \
                get_collider(__func__, x, index, out_shape, out_first, out_second, out_velocity, count, out_radius,    \
                             out_friction))                                                                            \
    CD_FUNCTION(object, , set_loads, (int32_t loads), shared::set_loads(__func__, x, loads))                           \
    CD_GETTER(object, get_loads, int32_t, out_loads, bool(x.loads))                                                    \
    CD_FUNCTION(object, const, get_collider_load, (size_t index, double* out_load, size_t count),                      \
                shared::get_load(__func__, x, "cd_" #object "_set_loads", index, out_load, count))
