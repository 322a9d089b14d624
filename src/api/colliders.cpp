// Colliders of ropes and cloth: what their functions have in common, once they know that the collider is there.
#include "api/surroundings.hh"

namespace cd {
namespace shared {

static cd_status is_vector(const char* function, const char* name, const double* vector, size_t count) {
    CD_CHECK(not_null(function, name, vector));
    return are_numbers(function, name, vector, count, kMost);
}

// Makes a collider one of this shape, here and now, with room for so many numbers of a bed; its velocity stays.
static cd_status reshape(const char* function, const Touching& x, size_t index, cd_shape shape, size_t numbers = 0) {
    Body& b = x.body;
    Collider& to = collider(b, index);
    const size_t before = bed_numbers(b, index), old = bed_of(b, index).numbers(), rest = b.beds.count - before - old;
    Array<double> beds = b.beds;
    size_t all;
    if (numbers != old && !(add(before + rest, numbers, all) && allocate(b.memory, all, beds)))
        return fail(CD_ERROR_MEMORY, function, "no memory for a bed of %zu numbers", numbers);
    ColliderSizes wanted = collider_sizes(b, collider_count(b));
    wanted.callbacks += size_t(shape == CD_SHAPE_CALLBACK) - size_t(to.shape == CD_SHAPE_CALLBACK);
    if (!x.take(b, wanted)) {
        if (numbers != old) release(b.memory, beds);
        return fail(CD_ERROR_MEMORY, function, "no memory for a collider");
    }
    if (numbers != old) {
        if (before > 0) memcpy(beds.data, b.beds.data, before * sizeof(double));
        if (rest > 0) memcpy(beds.data + before + numbers, b.beds.data + before + old, rest * sizeof(double));
        release(b.memory, b.beds);
        b.beds = beds;
    }
    Collider made = {};
    made.shape = shape, made.since = b.clock.time();
    for (int k = 0; k < 3; ++k) made.velocity[k] = to.velocity[k];
    to = made;
    forget_callbacks(b);
    wake(b);
    return CD_OK;
}

cd_status set_plane(const char* function, const Touching& x, size_t index, const double* point, const double* normal,
                    size_t count, double friction) {
    Body& b = x.body;
    CD_CHECK(is_vector(function, "point", point, count));
    CD_CHECK(is_vector(function, "normal", normal, count));
    CD_CHECK(in_range(function, "friction", friction, 0, kMost));
    double largest = 0, square = 0;
    for (size_t k = 0; k < count; ++k)
        if (fabs(normal[k]) > largest) largest = fabs(normal[k]);
    if (!(largest > 0)) return fail(CD_ERROR_VALUE, function, "normal is 0: it has no direction");
    for (size_t k = 0; k < count; ++k) square += (normal[k] / largest) * (normal[k] / largest);
    CD_CHECK(reshape(function, x, index, CD_SHAPE_PLANE));
    Collider& to = collider(b, index);
    to.friction = friction;
    for (size_t k = 0; k < count; ++k) to.point[k] = point[k], to.way[k] = normal[k] / largest / sqrt(square);
    return CD_OK;
}

cd_status set_capsule(const char* function, const Touching& x, size_t index, const double* first, const double* last,
                      size_t count, double radius, double friction) {
    Body& b = x.body;
    CD_CHECK(is_vector(function, "first", first, count));
    CD_CHECK(is_vector(function, "last", last, count));
    CD_CHECK(in_range(function, "radius", radius, kLeastMass, kMost));
    CD_CHECK(in_range(function, "friction", friction, 0, kMost));
    CD_CHECK(reshape(function, x, index, CD_SHAPE_CAPSULE));
    Collider& to = collider(b, index);
    to.radius = radius, to.friction = friction;
    for (size_t k = 0; k < count; ++k) to.point[k] = first[k], to.way[k] = last[k] - first[k];
    return CD_OK;
}

static cd_status is_lattice(const char* function, size_t components, size_t columns, size_t rows, size_t count) {
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

cd_status set_bed(const char* function, const Touching& x, size_t index, const double* origin, size_t count,
                  size_t columns, size_t rows, double column_spacing, double row_spacing, const double* heights,
                  size_t height_count, double friction) {
    Body& b = x.body;
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
    Collider& to = collider(b, index);
    to.friction = friction, to.way[0] = column_spacing, to.way[1] = rows > 1 ? row_spacing : 0;
    for (size_t k = 0; k < count; ++k) to.point[k] = origin[k];
    const Bed bed{b.beds.data + bed_numbers(b, index)};
    bed.at[0] = double(columns), bed.at[1] = double(rows);
    for (size_t i = 0; i < height_count; ++i) bed.heights()[i] = heights[i];
    return CD_OK;
}

cd_status get_bed(const char* function, const Body& b, size_t index, size_t* out_columns, size_t* out_rows,
                  double* out_heights, size_t height_count) {
    const Bed bed = bed_of(b, index);
    const size_t columns = bed ? bed.columns() : 0, rows = bed ? bed.rows() : 0;
    if (out_heights) CD_CHECK(is_count(function, "height_count", height_count, columns * rows));
    for (size_t i = 0; out_heights && i < height_count; ++i) out_heights[i] = bed.heights()[i];
    if (out_columns) *out_columns = columns;
    if (out_rows) *out_rows = rows;
    return CD_OK;
}

cd_status set_callback(const char* function, const Touching& x, size_t index, const cd_distance* distance,
                       const double* origin, size_t count, double friction) {
    Body& b = x.body;
    CD_CHECK(not_null(function, "distance", distance));
    if (!distance->distance) return fail(CD_ERROR_NULL, function, "distance->distance is null");
    if (origin || collider(b, index).shape != CD_SHAPE_CALLBACK) {
        CD_CHECK(is_vector(function, "origin", origin, count));
        CD_CHECK(in_range(function, "friction", friction, 0, kMost));
        CD_CHECK(reshape(function, x, index, CD_SHAPE_CALLBACK));
        Collider& to = collider(b, index);
        to.friction = friction;
        for (size_t k = 0; k < count; ++k) to.point[k] = origin[k];
    }
    b.callbacks[index] = *distance;
    return CD_OK;
}

cd_status remove_collider(const char* function, const Touching& x, size_t index) {
    Body& b = x.body;
    CD_CHECK(reshape(function, x, index, CD_SHAPE_NONE));
    collider(b, index) = {};
    return CD_OK;
}

cd_status set_collider_velocity(const char* function, const Touching& x, size_t index, const double* velocity,
                                size_t count) {
    Body& b = x.body;
    CD_CHECK(is_vector(function, "velocity", velocity, count));
    Collider& to = collider(b, index);
    const double now = b.clock.time();
    for (size_t k = 0; k < count; ++k) to.point[k] = to.place(int(k), now), to.velocity[k] = velocity[k];
    to.since = now;
    wake(b);
    return CD_OK;
}

cd_status get_collider(const char* function, const Body& b, size_t index, cd_shape* out_shape, double* out_first,
                       double* out_second, double* out_velocity, size_t count, double* out_radius,
                       double* out_friction) {
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
