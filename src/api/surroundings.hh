// What surrounds ropes and cloth: air, and colliders. Each function is written once, as those of shared.hh are;
// CD_SURROUNDINGS_FUNCTIONS at the end makes an object's public functions of them. An object says by feels_air and
// touches whether it has any, and by air_of where its settings of the air are.
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
    CD_CHECK(is_index(function, "index", index, collider_count(x)));
    return is_count(function, "count", count, x.components);
}
inline cd_status is_vector(const char* function, const char* name, const double* vector, size_t count) {
    CD_CHECK(not_null(function, name, vector));
    return are_numbers(function, name, vector, count, kMost);
}

template <class X> cd_status set_colliders(const char* function, X& x, size_t count) {
    if (count > kMostColliders)
        return fail(CD_ERROR_VALUE, function, "count is %zu, must be at most %zu", count, kMostColliders);
    CD_CHECK(touches(function, x));
    auto wanted = features(x);
    wanted.colliders = count;
    return change_features(function, x, wanted);
}

// name: what the distance is called
template <class X>
cd_status set_thickness(const char* function, const X& x, const char* name, double distance, double& thickness) {
    CD_CHECK(in_range(function, name, distance, 0, kMost));
    CD_CHECK(touches(function, x));
    thickness = distance + 0.0; // not -0
    return CD_OK;
}

template <class X> cd_status set_plane(const char* function, X& x, size_t index, const double* point,
                                       const double* normal, size_t count, double friction) {
    CD_CHECK(is_collider(function, x, index, count));
    CD_CHECK(is_vector(function, "point", point, count));
    CD_CHECK(is_vector(function, "normal", normal, count));
    CD_CHECK(in_range(function, "friction", friction, 0, kMost));
    double largest = 0, square = 0;
    for (size_t k = 0; k < count; ++k)
        if (fabs(normal[k]) > largest) largest = fabs(normal[k]);
    if (!(largest > 0)) return fail(CD_ERROR_VALUE, function, "normal is 0: it has no direction");
    for (size_t k = 0; k < count; ++k) square += (normal[k] / largest) * (normal[k] / largest);
    Collider& to = collider(x, index);
    to.shape = CD_SHAPE_PLANE, to.radius = 0, to.friction = friction, to.since = x.clock.time();
    for (size_t k = 0; k < count; ++k) to.point[k] = point[k], to.way[k] = normal[k] / largest / sqrt(square);
    return CD_OK;
}

template <class X> cd_status set_capsule(const char* function, X& x, size_t index, const double* first,
                                         const double* last, size_t count, double radius, double friction) {
    CD_CHECK(is_collider(function, x, index, count));
    CD_CHECK(is_vector(function, "first", first, count));
    CD_CHECK(is_vector(function, "last", last, count));
    CD_CHECK(in_range(function, "radius", radius, kLeastMass, kMost));
    CD_CHECK(in_range(function, "friction", friction, 0, kMost));
    Collider& to = collider(x, index);
    to.shape = CD_SHAPE_CAPSULE, to.radius = radius, to.friction = friction, to.since = x.clock.time();
    for (size_t k = 0; k < count; ++k) to.point[k] = first[k], to.way[k] = last[k] - first[k];
    return CD_OK;
}

template <class X> cd_status remove_collider(const char* function, X& x, size_t index) {
    CD_CHECK(is_collider(function, x, index, x.components));
    collider(x, index) = {};
    return CD_OK;
}

template <class X>
cd_status set_collider_velocity(const char* function, X& x, size_t index, const double* velocity, size_t count) {
    CD_CHECK(is_collider(function, x, index, count));
    CD_CHECK(is_vector(function, "velocity", velocity, count));
    Collider& to = collider(x, index);
    const double now = x.clock.time();
    for (size_t k = 0; k < count; ++k) to.point[k] = to.place(int(k), now), to.velocity[k] = velocity[k];
    to.since = now;
    return CD_OK;
}

inline cd_status get_collider(const char* function, const Body& b, size_t index, cd_shape* out_shape, double* out_first,
                              double* out_second, double* out_velocity, size_t count, double* out_radius,
                              double* out_friction) {
    CD_CHECK(is_index(function, "index", index, collider_count(b)));
    CD_CHECK(is_count(function, "count", count, b.components));
    const Collider& of = collider(b, index);
    for (size_t k = 0; k < count; ++k) {
        const double place = of.shape == CD_SHAPE_NONE ? 0 : of.place(int(k), b.clock.time());
        if (out_first) out_first[k] = place;
        if (out_second) out_second[k] = of.way[k] + (of.shape == CD_SHAPE_CAPSULE ? place : 0);
        if (out_velocity) out_velocity[k] = of.velocity[k];
    }
    if (out_shape) *out_shape = cd_shape(of.shape);
    if (out_radius) *out_radius = of.radius;
    if (out_friction) *out_friction = of.friction;
    return CD_OK;
}

} // namespace shared
} // namespace cd

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
    CD_FUNCTION(object, , set_plane,                                                                                   \
                (size_t index, const double* point, const double* normal, size_t count, double friction),              \
                shared::set_plane(__func__, x, index, point, normal, count, friction))                                 \
    CD_FUNCTION(object, , set_capsule,                                                                                 \
                (size_t index, const double* first, const double* last, size_t count, double radius, double friction), \
                shared::set_capsule(__func__, x, index, first, last, count, radius, friction))                         \
    CD_FUNCTION(object, , remove_collider, (size_t index), shared::remove_collider(__func__, x, index))                \
    CD_FUNCTION(object, , set_collider_velocity, (size_t index, const double* velocity, size_t count),                 \
                shared::set_collider_velocity(__func__, x, index, velocity, count))                                    \
    CD_FUNCTION(object, const, get_collider,                                                                           \
                (size_t index, cd_shape * out_shape, double* out_first, double* out_second, double* out_velocity,      \
                 size_t count, double* out_radius, double* out_friction),                                              \
                shared::get_collider(__func__, x, index, out_shape, out_first, out_second, out_velocity, count,        \
                                     out_radius, out_friction))
