// water.h: what floats on the water.
#include "api/fields.hh"
#include "api/water_handle.hh"
#include "model/water_hull.hh"

using namespace cd;

namespace {

constexpr size_t kPose = 7, kWays = 6;
constexpr double kMostPose = 1e15;

cd_status is_hull(const char* function, const Water& w, size_t index) {
    return is_index(function, index, w.hull_shape.count, "hulls", "cd_water_set_hulls");
}

cd_status is_vector(const char* function, const char* name, const double* values, size_t count, size_t wanted,
                    double most) {
    CD_CHECK(not_null(function, name, values));
    CD_CHECK(is_count(function, "count", count, wanted));
    return are_numbers(function, name, values, count, most);
}

// Numbers are taken over without the sign of a zero.
void take(double* to, const double* from, size_t count) {
    for (size_t k = 0; k < count; ++k) to[k] = from[k] + 0.0;
}

cd_status give(const char* function, const char* name, double* out, size_t count, const double* from, size_t wanted) {
    CD_CHECK(not_null(function, name, out));
    CD_CHECK(is_count(function, "count", count, wanted));
    memcpy(out, from, wanted * sizeof(double));
    return CD_OK;
}

cd_status is_place(const char* function, const Water& w, double x, double y) {
    CD_CHECK(in_range(function, "x", x, 0, length_of(w, kX)));
    return in_range(function, "y", y, 0, length_of(w, kY));
}

cd_status set_bow(const char* function, const char* name, Hull& h, double x, double y) {
    const double most = fabs(x) > fabs(y) ? fabs(x) : fabs(y);
    if (!(most > 0)) return fail(CD_ERROR_VALUE, function, "%s are 0: the bow has no direction", name);
    const double a = x / most, b = y / most, size = sqrt(a * a + b * b);
    h.heading[0] = a / size + 0.0, h.heading[1] = b / size + 0.0;
    return CD_OK;
}

double most_size(const Water& w) { return kMostHullCells * cell_size(w.size, w.cells); }

cd_status is_size(const char* function, const Water& w, const char* name, double size) {
    const double most = most_size(w);
    if (size >= kLeastHullSize && size <= most) return CD_OK;
    return fail(CD_ERROR_VALUE, function, "%s is %g, must be in [%g, %g], which is %g cells", name, size,
                kLeastHullSize, most, kMostHullCells);
}

void set_body(Hull& h, double mass, double length, double width) {
    if (is_off(h)) h.heading[0] = h.heading[0] == 0 && h.heading[1] == 0 ? 1 : h.heading[0];
    h.mass = mass, h.length = length, h.width = width, h.owed = 0;
}

} // namespace

cd_status cd_water_set_hulls(cd_water* water, size_t count, size_t n_along, size_t n_across) {
    CD_OPEN(water, w);
    if (count > kMostHulls)
        return fail(CD_ERROR_VALUE, __func__, "count is %zu, must be at most %zu", count, kMostHulls);
    if (count > 0 && (n_along < 1 || n_along > kMostPlates))
        return fail(CD_ERROR_VALUE, __func__, "n_along is %zu, must be 1 to %zu", n_along, kMostPlates);
    if (count > 0 && (n_across < 1 || n_across > kMostPlates))
        return fail(CD_ERROR_VALUE, __func__, "n_across is %zu, must be 1 to %zu", n_across, kMostPlates);
    WaterFeatures wanted = features(w);
    wanted.hulls = count > 0 ? HullShape{count, n_along, n_across} : HullShape{};
    return shared::change_features(__func__, w, wanted);
}

cd_status cd_water_get_hulls(const cd_water* water, size_t* out_count, size_t* out_n_along, size_t* out_n_across) {
    CD_OPEN(water, w);
    if (out_count) *out_count = w.hull_shape.count;
    if (out_n_along) *out_n_along = w.hull_shape.along;
    if (out_n_across) *out_n_across = w.hull_shape.across;
    return CD_OK;
}

cd_status cd_water_set_hull(cd_water* water, size_t index, double mass, double length, double width,
                            const double* heights, size_t count) {
    CD_OPEN_QUIETLY(water, w);
    CD_CHECK(is_hull(__func__, w, index));
    CD_CHECK(in_range(__func__, "mass", mass, kLeastHull, kMostHull));
    CD_CHECK(is_size(__func__, w, "length", length));
    CD_CHECK(is_size(__func__, w, "width", width));
    const size_t plates = w.hull_shape.plates();
    if (heights) {
        CD_CHECK(is_count(__func__, "count", count, plates));
        bool any = false;
        for (size_t k = 0; k < count; ++k) {
            if (heights[k] != -1 && !(heights[k] >= 0 && heights[k] <= kMost))
                return fail(CD_ERROR_VALUE, __func__, "heights[%zu] is %g, must be in [0, %g], or -1 for no plate", k,
                            heights[k], kMost);
            any |= heights[k] >= 0;
        }
        if (!any) return fail(CD_ERROR_VALUE, __func__, "heights are all -1, but a hull needs a plate");
    }
    set_body(hull(w, index), mass, length, width);
    for (size_t k = 0; k < plates; ++k) plate_heights(w, index)[k] = heights ? heights[k] + 0.0 : 0;
    return CD_OK;
}

cd_status cd_water_set_disc(cd_water* water, size_t index, double mass, double radius) {
    CD_OPEN_QUIETLY(water, w);
    CD_CHECK(is_hull(__func__, w, index));
    CD_CHECK(in_range(__func__, "mass", mass, kLeastHull, kMostHull));
    CD_CHECK(is_size(__func__, w, "radius", radius));
    const HullShape& shape = w.hull_shape;
    const auto from_middle = [](size_t k, size_t n) { return (double(2 * k + 1) - double(n)) / double(n); };
    size_t there = 0;
    const auto each = [&](auto f) { // f(plate, whether it is in the disc)
        for (size_t k = 0; k < shape.plates(); ++k) {
            const double x = from_middle(k % shape.along, shape.along), y = from_middle(k / shape.along, shape.across);
            f(k, x * x + y * y <= 1);
        }
    };
    each([&](size_t, bool in) { there += in ? 1 : 0; });
    const double side = radius * sqrt(3.14159265358979323846 * double(shape.plates()) / double(there));
    if (side > most_size(w))
        return fail(CD_ERROR_VALUE, __func__,
                    "radius is %g: the plates' square is %g wide, must be at most %g, %g cells", radius, side,
                    most_size(w), kMostHullCells);
    set_body(hull(w, index), mass, side, side);
    each([&](size_t k, bool in) { plate_heights(w, index)[k] = in ? 0 : -1; });
    return CD_OK;
}

cd_status cd_water_get_hull(const cd_water* water, size_t index, double* out_mass, double* out_length,
                            double* out_width, double* out_area, double* out_heights, size_t count) {
    CD_OPEN(water, w);
    CD_CHECK(is_hull(__func__, w, index));
    const size_t plates = w.hull_shape.plates();
    if (out_heights) CD_CHECK(is_count(__func__, "count", count, plates));
    const Hull& h = hull(w, index);
    if (out_mass) *out_mass = h.mass;
    if (out_length) *out_length = h.length;
    if (out_width) *out_width = h.width;
    if constexpr (CD_WITH_HULL)
        if (out_area) *out_area = hull_area(w, index);
    if (out_heights) memcpy(out_heights, plate_heights(w, index), plates * sizeof(double));
    return CD_OK;
}

cd_status cd_water_remove_hull(cd_water* water, size_t index) {
    CD_OPEN_QUIETLY(water, w);
    CD_CHECK(is_hull(__func__, w, index));
    memset(&hull(w, index), 0, w.hull_shape.numbers() * sizeof(double));
    return CD_OK;
}

// ---- where they are, and what acts on them --------------------------------------------------------------------------

cd_status cd_water_launch_hull(cd_water* water, size_t index, double x, double y, double ahead_x, double ahead_y) {
    CD_OPEN(water, w);
    CD_CHECK(is_hull(__func__, w, index));
    CD_CHECK(is_place(__func__, w, x, y));
    CD_CHECK(shared::is_finite(__func__, w));
    Hull &h = hull(w, index), before = h;
    if (is_off(h))
        return fail(CD_ERROR_DISABLED, __func__, "index is %zu, a hull without mass: call cd_water_set_hull first",
                    index);
    CD_CHECK(in_range(__func__, "ahead_x", ahead_x, -kMost, kMost));
    CD_CHECK(in_range(__func__, "ahead_y", ahead_y, -kMost, kMost));
    CD_CHECK(set_bow(__func__, "ahead_x and ahead_y", h, ahead_x, ahead_y));
    h.x = x + 0.0, h.y = y + 0.0, h.owed = 0;
    for (size_t k = 0; k < kWays; ++k) h.velocity[k] = h.water[k] = 0;
    bool lies = false;
    if constexpr (CD_WITH_HULL) lies = launch(w, index, hull_work(w));
    if (lies) return CD_OK;
    h = before;
    return fail(CD_ERROR_DISABLED, __func__, w.gravity > 0 ? "x and y have no cell under hull %zu" : "gravity is 0",
                index);
}

cd_status cd_water_set_hull_pose(cd_water* water, size_t index, const double* pose, size_t count) {
    CD_OPEN_QUIETLY(water, w);
    CD_CHECK(is_hull(__func__, w, index));
    CD_CHECK(is_vector(__func__, "pose", pose, count, kPose, kMostPose));
    for (Axis a : {kX, kY}) CD_CHECK(in_range(__func__, a == kX ? "pose[0]" : "pose[1]", pose[a], 0, length_of(w, a)));
    Hull& h = hull(w, index);
    CD_CHECK(set_bow(__func__, "pose[3] and pose[4]", h, pose[3], pose[4]));
    take(&h.x, pose, 3);
    h.pitch = pose[5] + 0.0, h.roll = pose[6] + 0.0;
    h.lies[0] = h.z, h.lies[1] = h.pitch, h.lies[2] = h.roll;
    h.owed = 0;
    return CD_OK;
}

static cd_status give_pose(const char* function, const Hull& h, const double (&lies)[3], double* out, size_t count) {
    const double pose[kPose] = {h.x, h.y, lies[0], h.heading[0], h.heading[1], lies[1], lies[2]};
    return give(function, "out_pose", out, count, pose, kPose);
}

cd_status cd_water_get_hull_pose(const cd_water* water, size_t index, double* out_pose, size_t count) {
    CD_OPEN(water, w);
    CD_CHECK(is_hull(__func__, w, index));
    const Hull& h = hull(w, index);
    return give_pose(__func__, h, {h.z, h.pitch, h.roll}, out_pose, count);
}

cd_status cd_water_get_hull_floor(const cd_water* water, size_t index, double* out_pose, size_t count) {
    CD_OPEN(water, w);
    CD_CHECK(is_hull(__func__, w, index));
    const Hull& h = hull(w, index);
    return give_pose(__func__, h, h.lies, out_pose, count);
}

cd_status cd_water_set_hull_velocity(cd_water* water, size_t index, const double* velocity, size_t count) {
    CD_OPEN_QUIETLY(water, w);
    CD_CHECK(is_hull(__func__, w, index));
    CD_CHECK(is_vector(__func__, "velocity", velocity, count, kWays, kMostPose));
    take(hull(w, index).velocity, velocity, kWays);
    return CD_OK;
}

cd_status cd_water_set_hull_force(cd_water* water, size_t index, const double* force, size_t count) {
    CD_OPEN_QUIETLY(water, w);
    CD_CHECK(is_hull(__func__, w, index));
    CD_CHECK(is_vector(__func__, "force", force, count, kWays, kMostHullForce));
    take(hull(w, index).force, force, kWays);
    return CD_OK;
}

#define CD_HULL_NUMBERS(name, out, from)                                                                 \
    cd_status cd_water_get_hull_##name(const cd_water* water, size_t index, double* out, size_t count) { \
        CD_OPEN(water, w);                                                                               \
        CD_CHECK(is_hull(__func__, w, index));                                                           \
        return give(__func__, #out, out, count, hull(w, index).from, kWays);                             \
    }
CD_HULL_NUMBERS(velocity, out_velocity, velocity)
CD_HULL_NUMBERS(force, out_force, force)
CD_HULL_NUMBERS(load, out_load, water)

cd_status cd_water_set_hull_drag(cd_water* water, size_t index, double along, double across, double friction) {
    CD_OPEN_QUIETLY(water, w);
    CD_CHECK(is_hull(__func__, w, index));
    CD_CHECK(in_range(__func__, "along", along, 0, kMostHullForce));
    CD_CHECK(in_range(__func__, "across", across, 0, kMostHullForce));
    CD_CHECK(in_range(__func__, "friction", friction, 0, kMostHullForce));
    Hull& h = hull(w, index);
    h.drag[0] = along + 0.0, h.drag[1] = across + 0.0, h.friction = friction + 0.0;
    return CD_OK;
}

cd_status cd_water_get_hull_drag(const cd_water* water, size_t index, double* out_along, double* out_across,
                                 double* out_friction) {
    CD_OPEN(water, w);
    CD_CHECK(is_hull(__func__, w, index));
    CD_NOT_NULL(out_along);
    CD_NOT_NULL(out_across);
    CD_NOT_NULL(out_friction);
    const Hull& h = hull(w, index);
    *out_along = h.drag[0], *out_across = h.drag[1], *out_friction = h.friction;
    return CD_OK;
}

cd_status cd_water_get_hull_energy(const cd_water* water, double* out_kinetic, double* out_potential) {
    CD_OPEN(water, w);
    double kinetic = 0, potential = 0;
    if constexpr (CD_WITH_HULL) hull_energy(w, kinetic, potential);
    if (out_kinetic) *out_kinetic = kinetic;
    if (out_potential) *out_potential = potential;
    return CD_OK;
}

cd_status cd_water_sample_heads(const cd_water* water, const double* at, size_t n, cd_outside outside,
                                double* out_heads) {
    CD_OPEN(water, w);
    CD_CHECK(are_places(__func__, w, at, n, outside));
    if (n > 0) CD_NOT_NULL(out_heads);
    for (size_t k = 0; k < n; ++k) {
        const double x = nearest(at[2 * k], length_of(w, kX)), y = nearest(at[2 * k + 1], length_of(w, kY));
        if constexpr (CD_WITH_HULL) out_heads[k] = head_at(w, x, y);
        else out_heads[k] = sample(w, x, y).surface;
    }
    return CD_OK;
}
