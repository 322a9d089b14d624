// What surrounds ropes and cloth: air, and colliders. Each function is written once, as those of shared.hh are;
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
inline cd_status is_vector(const char* function, const char* name, const double* vector, size_t count) {
    CD_CHECK(not_null(function, name, vector));
    return are_numbers(function, name, vector, count, kMost);
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

// Makes a collider one of this shape, here and now, with room for so many numbers of a bed; its velocity stays.
template <class X> cd_status reshape(const char* function, X& x, size_t index, cd_shape shape, size_t numbers = 0) {
    Collider& to = collider(x, index);
    const size_t before = bed_numbers(x, index), old = bed_of(x, index).numbers(), rest = x.beds.count - before - old;
    Array<double> beds = x.beds;
    size_t all;
    if (numbers != old && !(add(before + rest, numbers, all) && allocate(x.memory, all, beds)))
        return fail(CD_ERROR_MEMORY, function, "no memory for a bed of %zu numbers", numbers);
    auto wanted = features(x);
    wanted.colliders.callbacks += size_t(shape == CD_SHAPE_CALLBACK) - size_t(to.shape == CD_SHAPE_CALLBACK);
    if (!set_features(x, wanted)) {
        if (numbers != old) release(x.memory, beds);
        return fail(CD_ERROR_MEMORY, function, "no memory for a collider");
    }
    if (numbers != old) {
        if (before > 0) memcpy(beds.data, x.beds.data, before * sizeof(double));
        if (rest > 0) memcpy(beds.data + before + numbers, x.beds.data + before + old, rest * sizeof(double));
        release(x.memory, x.beds);
        x.beds = beds;
    }
    Collider made = {};
    made.shape = shape, made.since = x.clock.time();
    for (int k = 0; k < 3; ++k) made.velocity[k] = to.velocity[k];
    to = made;
    forget_callbacks(x);
    wake(x);
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
    CD_CHECK(reshape(function, x, index, CD_SHAPE_PLANE));
    Collider& to = collider(x, index);
    to.friction = friction;
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
    CD_CHECK(reshape(function, x, index, CD_SHAPE_CAPSULE));
    Collider& to = collider(x, index);
    to.radius = radius, to.friction = friction;
    for (size_t k = 0; k < count; ++k) to.point[k] = first[k], to.way[k] = last[k] - first[k];
    return CD_OK;
}

inline cd_status is_lattice(const char* function, size_t components, size_t columns, size_t rows, size_t count) {
    if (components < 2)
        return fail(CD_ERROR_UNSUPPORTED, function, "a bed needs 2 or 3 components, there are %zu", components);
    if (columns < 2) return fail(CD_ERROR_VALUE, function, "columns is %zu, must be at least 2", columns);
    if (components == 2 ? rows != 1 : rows < 2)
        return fail(CD_ERROR_VALUE, function, "rows is %zu, must be %s with %zu components", rows,
                    components == 2 ? "1" : "at least 2", components);
    size_t heights;
    if (multiply(columns, rows, heights) && count == heights) return CD_OK;
    return fail(CD_ERROR_RANGE, function, "height_count is %zu, must be %zu columns times %zu rows", count, columns,
                rows);
}

template <class X>
cd_status set_bed(const char* function, X& x, size_t index, const double* origin, size_t count, size_t columns,
                  size_t rows, double column_spacing, double row_spacing, const double* heights, size_t height_count,
                  double friction) {
    CD_CHECK(is_collider(function, x, index, count));
    CD_CHECK(is_vector(function, "origin", origin, count));
    CD_CHECK(is_lattice(function, count, columns, rows, height_count));
    CD_CHECK(in_range(function, "column_spacing", column_spacing, kLeastMass, kMost));
    if (rows > 1) CD_CHECK(in_range(function, "row_spacing", row_spacing, kLeastMass, kMost));
    CD_CHECK(is_vector(function, "heights", heights, height_count));
    CD_CHECK(in_range(function, "friction", friction, 0, kMost));
    size_t numbers;
    if (!add(height_count, kBedHead, numbers))
        return fail(CD_ERROR_MEMORY, function, "no memory for a bed of %zu heights", height_count);
    CD_CHECK(reshape(function, x, index, CD_SHAPE_BED, numbers));
    Collider& to = collider(x, index);
    to.friction = friction, to.way[0] = column_spacing, to.way[1] = rows > 1 ? row_spacing : 0;
    for (size_t k = 0; k < count; ++k) to.point[k] = origin[k];
    const Bed bed{x.beds.data + bed_numbers(x, index)};
    bed.at[0] = double(columns), bed.at[1] = double(rows);
    for (size_t i = 0; i < height_count; ++i) bed.heights()[i] = heights[i];
    return CD_OK;
}

template <class X> cd_status get_bed(const char* function, const X& x, size_t index, size_t* out_columns,
                                     size_t* out_rows, double* out_heights, size_t height_count) {
    CD_CHECK(has_collider(function, x, index));
    const Bed bed = bed_of(x, index);
    const size_t columns = bed ? bed.columns() : 0, rows = bed ? bed.rows() : 0;
    if (out_heights) CD_CHECK(is_count(function, "height_count", height_count, columns * rows));
    for (size_t i = 0; out_heights && i < height_count; ++i) out_heights[i] = bed.heights()[i];
    if (out_columns) *out_columns = columns;
    if (out_rows) *out_rows = rows;
    return CD_OK;
}

template <class X> cd_status set_callback(const char* function, X& x, size_t index, const cd_distance* distance,
                                          const double* origin, size_t count, double friction) {
    CD_CHECK(is_collider(function, x, index, origin ? count : x.components));
    CD_CHECK(not_null(function, "distance", distance));
    if (!distance->distance) return fail(CD_ERROR_NULL, function, "distance->distance is null");
    if (origin || collider(x, index).shape != CD_SHAPE_CALLBACK) {
        CD_CHECK(is_vector(function, "origin", origin, count));
        CD_CHECK(in_range(function, "friction", friction, 0, kMost));
        CD_CHECK(reshape(function, x, index, CD_SHAPE_CALLBACK));
        Collider& to = collider(x, index);
        to.friction = friction;
        for (size_t k = 0; k < count; ++k) to.point[k] = origin[k];
    }
    x.callbacks[index] = *distance;
    return CD_OK;
}

template <class X> cd_status remove_collider(const char* function, X& x, size_t index) {
    CD_CHECK(is_collider(function, x, index, x.components));
    CD_CHECK(reshape(function, x, index, CD_SHAPE_NONE));
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
    wake(x);
    return CD_OK;
}

template <class X> cd_status get_collider(const char* function, const X& x, size_t index, cd_shape* out_shape,
                                          double* out_first, double* out_second, double* out_velocity, size_t count,
                                          double* out_radius, double* out_friction) {
    CD_CHECK(has_collider(function, x, index));
    CD_CHECK(is_count(function, "count", count, x.components));
    const Collider& of = collider(x, index);
    for (size_t k = 0; k < count; ++k) {
        const double place = of.shape == CD_SHAPE_NONE ? 0 : of.place(int(k), x.clock.time());
        if (out_first) out_first[k] = place;
        if (out_second) out_second[k] = of.way[k] + (of.shape == CD_SHAPE_CAPSULE ? place : 0);
        if (out_velocity) out_velocity[k] = of.velocity[k];
    }
    if (out_shape) *out_shape = cd_shape(of.shape);
    if (out_radius) *out_radius = of.radius;
    if (out_friction) *out_friction = of.friction;
    return CD_OK;
}

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

// Of the collider `index`. Where nothing in this build can touch one the check says so, and `value` takes no code.
#define CD_COLLIDER_FUNCTION(object, name, parameters, value)                                                          \
    CD_FUNCTION(object, , name, parameters,                                                                            \
                (can_touch(x) ? value : shared::is_collider(__func__, x, index, x.components)))

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
                shared::set_plane(__func__, x, index, point, normal, count, friction))                                 \
    CD_COLLIDER_FUNCTION(object, set_capsule,                                                                          \
                (size_t index, const double* first, const double* last, size_t count, double radius, double friction), \
                shared::set_capsule(__func__, x, index, first, last, count, radius, friction))                         \
    CD_COLLIDER_FUNCTION(object, set_bed,                                                                              \
                (size_t index, const double* origin, size_t count, size_t columns, size_t rows, double column_spacing, \
                 double row_spacing, const double* heights, size_t height_count, double friction),                     \
                shared::set_bed(__func__, x, index, origin, count, columns, rows, column_spacing, row_spacing,         \
                                heights, height_count, friction))                                                      \
    CD_FUNCTION(object, const, get_bed,                                                                                \
                (size_t index, size_t * out_columns, size_t* out_rows, double* out_heights, size_t height_count),      \
                shared::get_bed(__func__, x, index, out_columns, out_rows, out_heights, height_count))                 \
    CD_COLLIDER_FUNCTION(object, set_callback,                                                                         \
                (size_t index, const cd_distance* distance, const double* origin, size_t count, double friction),      \
                shared::set_callback(__func__, x, index, distance, origin, count, friction))                           \
    CD_COLLIDER_FUNCTION(object, remove_collider, (size_t index), shared::remove_collider(__func__, x, index))         \
    CD_COLLIDER_FUNCTION(object, set_collider_velocity, (size_t index, const double* velocity, size_t count),          \
                shared::set_collider_velocity(__func__, x, index, velocity, count))                                    \
    CD_FUNCTION(object, const, get_collider,                                                                           \
                (size_t index, cd_shape * out_shape, double* out_first, double* out_second, double* out_velocity,      \
                 size_t count, double* out_radius, double* out_friction),                                              \
                shared::get_collider(__func__, x, index, out_shape, out_first, out_second, out_velocity, count,        \
                                     out_radius, out_friction))                                                        \
    CD_FUNCTION(object, , set_loads, (int32_t loads), shared::set_loads(__func__, x, loads))                           \
    CD_GETTER(object, get_loads, int32_t, out_loads, bool(x.loads))                                                    \
    CD_FUNCTION(object, const, get_collider_load, (size_t index, double* out_load, size_t count),                      \
                shared::get_load(__func__, x, "cd_" #object "_set_loads", index, out_load, count))
