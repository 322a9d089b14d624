// chain.h: what ropes touch.
#include "api/chain_handle.hh"

using namespace cd;

namespace {

cd_status is_collider(const char* function, const Chain& c, size_t index, size_t count) {
    CD_CHECK(is_rope(function, c, "only ropes touch things"));
    CD_CHECK(is_index(function, "index", index, collider_count(c)));
    return is_count(function, "count", count, c.components);
}
cd_status is_vector(const char* function, const char* name, const double* vector, size_t count) {
    CD_CHECK(not_null(function, name, vector));
    return are_numbers(function, name, vector, count, kMost);
}

} // namespace

cd_status cd_chain_set_colliders(cd_chain* chain, size_t count) {
    CD_OPEN(chain, c);
    if (count > kMostColliders)
        return fail(CD_ERROR_VALUE, __func__, "count is %zu, must be at most %zu", count, kMostColliders);
    CD_CHECK(is_rope(__func__, c, "only ropes touch things"));
    Features wanted = features(c);
    wanted.colliders = count;
    return shared::change_features(__func__, c, wanted);
}

CD_GETTER(chain, get_colliders, size_t, out_count, collider_count(x))
CD_GETTER(chain, get_thickness, double, out_radius, x.rope.thickness)

cd_status cd_chain_set_thickness(cd_chain* chain, double radius) {
    CD_OPEN(chain, c);
    CD_CHECK(in_range(__func__, "radius", radius, 0, kMost));
    CD_CHECK(is_rope(__func__, c, "only ropes touch things"));
    c.rope.thickness = radius + 0.0; // not -0
    return CD_OK;
}

cd_status cd_chain_set_plane(cd_chain* chain, size_t index, const double* point, const double* normal, size_t count,
                             double friction) {
    CD_OPEN(chain, c);
    CD_CHECK(is_collider(__func__, c, index, count));
    CD_CHECK(is_vector(__func__, "point", point, count));
    CD_CHECK(is_vector(__func__, "normal", normal, count));
    CD_CHECK(in_range(__func__, "friction", friction, 0, kMost));
    double largest = 0, square = 0;
    for (size_t k = 0; k < count; ++k)
        if (fabs(normal[k]) > largest) largest = fabs(normal[k]);
    if (!(largest > 0)) return fail(CD_ERROR_VALUE, __func__, "normal is 0: it has no direction");
    for (size_t k = 0; k < count; ++k) square += (normal[k] / largest) * (normal[k] / largest);
    Collider& to = collider(c, index);
    to.shape = CD_SHAPE_PLANE, to.radius = 0, to.friction = friction, to.since = c.clock.time();
    for (size_t k = 0; k < count; ++k) to.point[k] = point[k], to.way[k] = normal[k] / largest / sqrt(square);
    return CD_OK;
}

cd_status cd_chain_set_capsule(cd_chain* chain, size_t index, const double* first, const double* last, size_t count,
                               double radius, double friction) {
    CD_OPEN(chain, c);
    CD_CHECK(is_collider(__func__, c, index, count));
    CD_CHECK(is_vector(__func__, "first", first, count));
    CD_CHECK(is_vector(__func__, "last", last, count));
    CD_CHECK(in_range(__func__, "radius", radius, kLeastMass, kMost));
    CD_CHECK(in_range(__func__, "friction", friction, 0, kMost));
    Collider& to = collider(c, index);
    to.shape = CD_SHAPE_CAPSULE, to.radius = radius, to.friction = friction, to.since = c.clock.time();
    for (size_t k = 0; k < count; ++k) to.point[k] = first[k], to.way[k] = last[k] - first[k];
    return CD_OK;
}

cd_status cd_chain_remove_collider(cd_chain* chain, size_t index) {
    CD_OPEN(chain, c);
    CD_CHECK(is_collider(__func__, c, index, c.components));
    collider(c, index) = {};
    return CD_OK;
}

cd_status cd_chain_set_collider_velocity(cd_chain* chain, size_t index, const double* velocity, size_t count) {
    CD_OPEN(chain, c);
    CD_CHECK(is_collider(__func__, c, index, count));
    CD_CHECK(is_vector(__func__, "velocity", velocity, count));
    Collider& to = collider(c, index);
    const double now = c.clock.time();
    for (size_t k = 0; k < count; ++k) to.point[k] = to.place(int(k), now), to.velocity[k] = velocity[k];
    to.since = now;
    return CD_OK;
}

cd_status cd_chain_get_collider(const cd_chain* chain, size_t index, cd_shape* out_shape, double* out_first,
                                double* out_second, double* out_velocity, size_t count, double* out_radius,
                                double* out_friction) {
    CD_OPEN(chain, c);
    CD_CHECK(is_index(__func__, "index", index, collider_count(c)));
    CD_CHECK(is_count(__func__, "count", count, c.components));
    const Collider& of = collider(c, index);
    for (size_t k = 0; k < count; ++k) {
        const double place = of.shape == CD_SHAPE_NONE ? 0 : of.place(int(k), c.clock.time());
        if (out_first) out_first[k] = place;
        if (out_second) out_second[k] = of.way[k] + (of.shape == CD_SHAPE_CAPSULE ? place : 0);
        if (out_velocity) out_velocity[k] = of.velocity[k];
    }
    if (out_shape) *out_shape = cd_shape(of.shape);
    if (out_radius) *out_radius = of.radius;
    if (out_friction) *out_friction = of.friction;
    return CD_OK;
}
