// What ropes and cloth touch: calls of their colliders.
#include <math.h>

#include "body.hpp"
#include "random.hpp"

namespace fuzz {

template <class Api> std::vector<typename Body<Api>::Thing> Body<Api>::things() const {
    size_t count = 0;
    Colliders<Api>::get_colliders(this->first(), &count);
    std::vector<Thing> all(count);
    for (size_t i = 0; i < count; ++i) {
        Thing& thing = all[i] = {};
        Colliders<Api>::get_collider(this->first(), i, &thing.shape, thing.first, thing.second, thing.velocity,
                                     components, &thing.radius, &thing.friction);
    }
    return all;
}

template <class Api> bool Body<Api>::moves(const Thing& thing) {
    for (double v : thing.velocity)
        if (v != 0 && thing.shape != CD_SHAPE_NONE) return true;
    return has_hollows(thing); // energy comes of what is taken out of them
}

template <class Api> bool Body<Api>::has_hollows(const Thing& thing) {
    return thing.shape == CD_SHAPE_BED || thing.shape == CD_SHAPE_CALLBACK;
}

// A ball, or everything around one.
static void tell_distances(void* user, double, size_t count, size_t components, const double* positions,
                           double* distances, double* normals) {
    const double radius = *static_cast<const double*>(user), way = radius < 0 ? -1 : 1;
    for (size_t i = 0; i < count; ++i) {
        double square = 0;
        for (size_t c = 0; c < components; ++c) square += pow(positions[i * components + c], 2);
        const double r = sqrt(square);
        distances[i] = way * r - radius;
        for (size_t c = 0; c < components; ++c)
            normals[i * components + c] = r > 0 ? way * positions[i * components + c] / r : c == 0;
    }
}
static double ball = 0.75, bowl = -1.5;

template <class Api> void Body<Api>::set_callbacks_again() {
    const std::vector<Thing> all = things();
    const cd_distance table = {&ball, tell_distances};
    for (size_t i = 0; i < all.size(); ++i)
        for (Handle* handle : {this->first(), this->twin()})
            if (all[i].shape == CD_SHAPE_CALLBACK &&
                Colliders<Api>::set_callback(handle, i, &table, nullptr, 0, 0) != CD_OK)
                problem("set_callback: %s", cd_error_message());
}

template <class Api> bool Body<Api>::same(const Thing& a, const Thing& b) {
    bool same = a.shape == b.shape && a.radius == b.radius && a.friction == b.friction;
    for (size_t c = 0; c < 4; ++c)
        same &= a.first[c] == b.first[c] && a.second[c] == b.second[c] && a.velocity[c] == b.velocity[c];
    return same;
}

template <class Api> double Body<Api>::depth_in(const Thing& thing, const double* x) const {
    double thickness = 0, along = 0, square = 0, away = 0;
    Colliders<Api>::get_thickness(this->first(), &thickness);
    if (thing.shape == CD_SHAPE_NONE || has_hollows(thing)) return -HUGE_VAL;
    if (thing.shape == CD_SHAPE_PLANE) {
        for (size_t c = 0; c < components; ++c) away += (x[c] - thing.first[c]) * thing.second[c];
        return thickness - away;
    }
    for (size_t c = 0; c < components; ++c) {
        const double way = thing.second[c] - thing.first[c];
        along += way * (x[c] - thing.first[c]), square += way * way;
    }
    const double share = square > 0 ? fmin(fmax(along / square, 0), 1) : 0;
    for (size_t c = 0; c < components; ++c)
        away += pow(x[c] - thing.first[c] - share * (thing.second[c] - thing.first[c]), 2);
    return thing.radius + thickness - sqrt(away);
}

template <class Api> void Body<Api>::set_colliders() {
    const size_t count = pick_index(5);
    size_t before = 0, after = 0;
    Colliders<Api>::get_colliders(this->first(), &before);
    const std::vector<Thing> was = things();
    const cd_status status = this->both(text("set_colliders %zu", count), 0, [&](Handle* handle, int) {
        return Colliders<Api>::set_colliders(handle, count);
    });
    Colliders<Api>::get_colliders(this->first(), &after);
    if (status == CD_OK && !has_lengths()) return problem("set_colliders: it has no lengths, but it is taken");
    if (after != (status == CD_OK ? count : before)) return problem("set_colliders: %zu, not %zu", after, count);
    const std::vector<Thing> now = things();
    for (size_t i = 0; i < now.size(); ++i) {
        if (!same(now[i], i < was.size() ? was[i] : Thing())) return problem("set_colliders: another collider %zu", i);
    }
}

// Of the colliders there are, and sometimes of none.
template <class Api> size_t Body<Api>::pick_collider() const {
    size_t count = 0;
    Colliders<Api>::get_colliders(this->first(), &count);
    return count == 0 ? 0 : pick_index(count);
}

template <class Api> typename Body<Api>::Place Body<Api>::pick_place(double size) const {
    Place place = {{}, true, pick_count(components)};
    for (double& x : place.at) {
        const bool wild = chance(run.bad * 0.5) || (!run.sane && chance(0.05));
        x = wild ? wild_number() : chance(0.1) ? 0 : uniform(-size, size);
        place.moderate &= fabs(x) < 1e3;
    }
    return place;
}

template <class Api> void Body<Api>::set_plane() {
    const size_t index = pick_collider();
    const Place point = pick_place(decades(-2, 1)), normal = pick_place(1);
    const double friction = chance(0.3) ? 0 : pick_number(-2, 1);
    const bool null[2] = {pick_null(), pick_null()};
    const size_t count = point.count;
    const cd_status status =
        this->both(text("set_plane %zu, %.17g %.17g %.17g, %.17g %.17g %.17g, count %zu, %.17g%s", index, point.at[0],
                        point.at[1], point.at[2], normal.at[0], normal.at[1], normal.at[2], count, friction,
                        null[0] || null[1] ? ", null" : ""),
                   0, [&](Handle* handle, int) {
                       return Colliders<Api>::set_plane(handle, index, null[0] ? nullptr : point.at,
                                                        null[1] ? nullptr : normal.at, count, friction);
                   });
    if (status == CD_OK && !(point.moderate && friction < 1e3)) this->past.moderate = false;
    if (status != CD_OK || run.broken) return;
    const Thing now = things()[index];
    double square = 0;
    for (double n : now.second) square += n * n;
    if (now.shape != CD_SHAPE_PLANE) problem("set_plane: collider %zu is none", index);
    else if (!(fabs(square - 1) < 1e-14)) problem("set_plane: a normal %g long", sqrt(square));
}

template <class Api> void Body<Api>::set_capsule() {
    const size_t index = pick_collider();
    const double size = decades(-2, 1), radius = pick_number(-2, 0.5), friction = chance(0.3) ? 0 : pick_number(-2, 1);
    const Place first_end = pick_place(size), last_end = chance(0.3) ? first_end : pick_place(size);
    const bool null[2] = {pick_null(), pick_null()};
    const size_t count = first_end.count;
    const cd_status status =
        this->both(text("set_capsule %zu, %.17g %.17g %.17g, %.17g %.17g %.17g, count %zu, %.17g, %.17g%s", index,
                        first_end.at[0], first_end.at[1], first_end.at[2], last_end.at[0], last_end.at[1],
                        last_end.at[2], count, radius, friction, null[0] || null[1] ? ", null" : ""),
                   0, [&](Handle* handle, int) {
                       return Colliders<Api>::set_capsule(handle, index, null[0] ? nullptr : first_end.at,
                                                          null[1] ? nullptr : last_end.at, count, radius, friction);
                   });
    const bool moderate = first_end.moderate && last_end.moderate && radius > 1e-3 && radius < 1e3 && friction < 1e3;
    if (status == CD_OK && !moderate) this->past.moderate = false;
    if (status == CD_OK && !run.broken && things()[index].shape != CD_SHAPE_CAPSULE)
        problem("set_capsule: collider %zu is none", index);
}

template <class Api> void Body<Api>::set_bed() {
    const size_t index = pick_collider(), columns = chance(0.05) ? below(3) : 2 + below(6);
    const size_t rows = chance(0.05) ? below(3) : components == 3 ? 2 + below(6) : 1;
    const Place origin = pick_place(decades(-2, 1));
    const double spacing[2] = {pick_number(-2, 1), pick_number(-2, 1)}, high = pick_number(-2, 0);
    const double friction = chance(0.3) ? 0 : pick_number(-2, 1);
    constexpr size_t kMostHeights = 49;
    double heights[kMostHeights + 1] = {}; // also one that no bed has
    for (size_t k = 0; k < kMostHeights; ++k) heights[k] = high * uniform(-1, 1);
    if (chance(run.bad * 0.5)) heights[below(columns * rows + 1)] = wild_number();
    const size_t count = pick_count(columns * rows);
    const bool null[2] = {pick_null(), pick_null()};
    const cd_status status = this->both(
        text("set_bed %zu, %.17g %.17g %.17g, count %zu, %zu x %zu, %.17g %.17g, %.17g, %zu, %.17g%s", index,
             origin.at[0], origin.at[1], origin.at[2], origin.count, columns, rows, spacing[0], spacing[1], high, count,
             friction, null[0] || null[1] ? ", null" : ""),
        0, [&](Handle* handle, int) {
            return Colliders<Api>::set_bed(handle, index, null[0] ? nullptr : origin.at, origin.count, columns, rows,
                                           spacing[0], spacing[1], null[1] ? nullptr : heights, count, friction);
        });
    if (status != CD_OK || run.broken) return;
    for (double number : {spacing[0], spacing[1], high, friction}) this->past.moderate &= number < 1e3;
    this->past.moderate &= origin.moderate && spacing[0] > 1e-3 && spacing[1] > 1e-3;
    double told[kMostHeights];
    size_t extent[2] = {};
    if (things()[index].shape != CD_SHAPE_BED) return problem("set_bed: collider %zu is none", index);
    if (Colliders<Api>::get_bed(this->first(), index, &extent[0], &extent[1], told, count) != CD_OK ||
        extent[0] != columns || extent[1] != rows)
        return problem("set_bed: %zu x %zu, told are %zu x %zu", columns, rows, extent[0], extent[1]);
    for (size_t i = 0; i < count; ++i)
        if (told[i] != heights[i]) problem("set_bed: height %zu is %g, not %g", i, told[i], heights[i]);
}

template <class Api> void Body<Api>::get_bed() {
    const size_t index = pick_collider(), count = chance(0.5) ? 0 : below(49);
    double told[2][49] = {};
    size_t extent[2][2] = {};
    const bool some = chance(0.2), none = chance(0.5);
    this->both(text("get_bed %zu, count %zu", index, count), kReads, [&](Handle* handle, int which) {
        return Colliders<Api>::get_bed(handle, index, some ? nullptr : &extent[which][0], &extent[which][1],
                                       none ? nullptr : told[which], count);
    });
    this->must_agree("get_bed", told[0], told[1], 49);
    this->must_agree("get_bed", extent[0], extent[1], 2);
}

template <class Api> void Body<Api>::set_callback() {
    const size_t index = pick_collider();
    const Place origin = pick_place(decades(-2, 1));
    const double friction = chance(0.3) ? 0 : pick_number(-2, 1);
    const bool no_table = pick_null(), no_function = pick_null(), no_origin = chance(0.2);
    cd_distance table = {chance(0.5) ? &ball : &bowl, tell_distances};
    if (no_function) table.distance = nullptr;
    const cd_status status =
        this->both(text("set_callback %zu, %.17g %.17g %.17g, count %zu, %.17g%s", index, origin.at[0], origin.at[1],
                        origin.at[2], origin.count, friction, no_table || no_function || no_origin ? ", null" : ""),
                   0, [&](Handle* handle, int) {
                       return Colliders<Api>::set_callback(handle, index, no_table ? nullptr : &table,
                                                           no_origin ? nullptr : origin.at, origin.count, friction);
                   });
    if (status != CD_OK || run.broken) return;
    if (!no_origin) this->past.moderate &= origin.moderate && friction < 1e3;
    if (no_table || no_function) problem("set_callback: no function is taken");
    if (things()[index].shape != CD_SHAPE_CALLBACK) problem("set_callback: collider %zu is none", index);
}

template <class Api> void Body<Api>::remove_collider() {
    const size_t index = pick_collider();
    const cd_status status = this->both(text("remove_collider %zu", index), 0, [&](Handle* handle, int) {
        return Colliders<Api>::remove_collider(handle, index);
    });
    if (status != CD_OK || run.broken) return;
    if (!same(things()[index], Thing())) problem("remove_collider: collider %zu is still something", index);
}

template <class Api> void Body<Api>::set_collider_velocity() {
    const size_t index = pick_collider();
    const Place velocity = pick_place(chance(0.2) ? 0 : decades(-2, 1));
    const bool null = pick_null();
    const cd_status status = this->both(
        text("set_collider_velocity %zu, %.17g %.17g %.17g, count %zu%s", index, velocity.at[0], velocity.at[1],
             velocity.at[2], velocity.count, null ? ", null" : ""),
        kNoMemory, [&](Handle* handle, int) {
            return Colliders<Api>::set_collider_velocity(handle, index, null ? nullptr : velocity.at, velocity.count);
        });
    if (status == CD_OK && !velocity.moderate) this->past.moderate = false;
}

template <class Api> void Body<Api>::set_thickness() {
    const double radius = chance(0.3) ? 0 : pick_number(-4, 0);
    const cd_status status = this->both(text("set_thickness %.17g", radius), kNoMemory, [&](Handle* handle, int) {
        return Colliders<Api>::set_thickness(handle, radius);
    });
    if (status == CD_OK && !has_lengths()) problem("set_thickness: it has no lengths, but it is taken");
    if (status == CD_OK && !(radius < 1e3)) this->past.moderate = false;
}

template <class Api> void Body<Api>::get_collider() {
    const size_t index = pick_collider(), count = pick_count(components);
    Thing told[2] = {};
    const bool some = chance(0.2);
    const auto get = [&](Handle* handle, int which) {
        Thing& out = told[which];
        return Colliders<Api>::get_collider(handle, index, some ? nullptr : &out.shape, some ? nullptr : out.first,
                                            out.second, some ? nullptr : out.velocity, count, &out.radius,
                                            some ? nullptr : &out.friction);
    };
    const cd_status status = this->both(text("get_collider %zu, count %zu", index, count), kReads, get);
    this->must_agree("get_collider", &told[0].shape, &told[1].shape);
    this->must_agree("get_collider", told[0].first, told[1].first, 4);
    this->must_agree("get_collider", told[0].second, told[1].second, 4);
    this->must_agree("get_collider", told[0].velocity, told[1].velocity, 4);
    this->must_agree("get_collider", &told[0].radius, &told[1].radius);
    this->must_agree("get_collider", &told[0].friction, &told[1].friction);
    size_t all = 0;
    Colliders<Api>::get_colliders(this->first(), &all);
    if ((status == CD_OK) != (index < all && count == components))
        problem("get_collider: %s of collider %zu of %zu, count %zu", cd_status_name(status), index, all, count);
}

template <class Api> void Body<Api>::set_loads() {
    const int32_t loads = pick_enum(1);
    const cd_status status = this->both(text("set_loads %d", int(loads)), 0,
                                        [&](Handle* handle, int) { return Colliders<Api>::set_loads(handle, loads); });
    if (status == CD_OK && !(has_lengths() && (loads == 0 || loads == 1))) problem("set_loads: it is taken");
}

template <class Api> void Body<Api>::get_collider_load() {
    const size_t index = pick_collider(), count = pick_count(6);
    double told[2][6] = {};
    const cd_status status =
        this->both(text("get_collider_load %zu, count %zu", index, count), kReads, [&](Handle* handle, int which) {
            return Colliders<Api>::get_collider_load(handle, index, told[which], count);
        });
    this->must_agree("get_collider_load", told[0], told[1], 6);
    size_t all = 0;
    int32_t loads = 0;
    Colliders<Api>::get_colliders(this->first(), &all);
    Colliders<Api>::get_loads(this->first(), &loads);
    if ((status == CD_OK) != (index < all && count == 6 && loads == 1))
        problem("get_collider_load: %s of collider %zu of %zu, count %zu", cd_status_name(status), index, all, count);
    for (double number : told[0])
        if (!std::isfinite(number)) problem("get_collider_load tells %g", number);
}

template class Body<ChainApi>;
template class Body<MembraneApi>;

} // namespace fuzz
