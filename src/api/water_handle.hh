// From the opaque handle to the water behind it, and what the files of its functions use.
#pragma once

#include "api/shared.hh"
#include "model/water.hh"

namespace cd {

template <> struct Behind<cd_water> {
    using Object = Water;
    static constexpr uint64_t tag = kWaterTag;
    static constexpr const char* name = "water";
};

// Any call that may change a water may wake all of it, but for those that open it quietly: they tell themselves which
// cells they change, or change none.
inline Water& quiet(cd_water* water) { return *reinterpret_cast<Water*>(water); }
inline Water& behind(cd_water* water) {
    disturb(quiet(water));
    return quiet(water);
}
#define CD_OPEN_QUIETLY(water, name)      \
    CD_CHECK(is_living(__func__, water)); \
    Water& name = quiet(water)

inline cd_status is_field(const char* function, const Water&, cd_field field) {
    CD_CHECK(is_enum(function, "field", field, CD_WALL_Y));
    if (field >= CD_MASK) return CD_OK;
    return fail(CD_ERROR_UNSUPPORTED, function, "field is %d, %s, which no water has%s", int(field), field_name(field),
                field == CD_VELOCITY ? ": it has CD_VELOCITY_X and CD_VELOCITY_Y"
                : field == CD_FORCE  ? ": it has CD_FORCE_X and CD_FORCE_Y"
                                     : "");
}
inline bool has_lengths(const Water&) { return false; } // of springs, which there are none of
inline bool needs_length(const Water&, cd_field) { return false; }
inline bool is_always_on(const Water&, cd_field field) { return field >= CD_DEPTH && field <= CD_VELOCITY_Y; }
inline void switch_own(WaterFeatures& wanted, cd_field field, bool on) {
    if (field == CD_SOURCE) wanted.source = on;
    if (field == CD_PRESSURE) wanted.pressure = on;
    if (field == CD_FORCE_X) wanted.force[kX] = on;
    if (field == CD_FORCE_Y) wanted.force[kY] = on;
    if (field == CD_MASK) wanted.mask = on;
    if (field == CD_WALL_X) wanted.wall[kX] = on;
    if (field == CD_WALL_Y) wanted.wall[kY] = on;
}

inline double length_of(const Water& w, Axis a) { return double(w.cells[a]) * w.size[a]; }
// Whether n places are in the scene, or may be outside.
inline cd_status are_places(const char* function, const Water& w, const double* at, size_t n, cd_outside outside) {
    CD_CHECK(can_sample(function, at, n, outside));
    for (size_t k = 0; k < 2 * n; ++k) CD_CHECK(is_place(function, at, k, length_of(w, k % 2 == 0 ? kX : kY), outside));
    return CD_OK;
}

namespace shared {

inline cd_status set_method(const char* function, Water& w, cd_method method) {
    CD_CHECK(is_enum(function, "method", method, CD_METHOD_STIFF_SECOND));
    if (method == CD_METHOD_STIFF_SECOND)
        return fail(CD_ERROR_UNSUPPORTED, function, "method is 3, CD_METHOD_STIFF_SECOND, which no water has");
    WaterFeatures wanted = features(w);
    wanted.method = method;
    return change_features(function, w, wanted);
}

inline cd_status set_parallel(const char* function, Water& w, const cd_parallel* parallel) {
    if (parallel && !parallel->run) return fail(CD_ERROR_NULL, function, "parallel->run is null");
    WaterFeatures wanted = features(w);
    wanted.parallel = parallel != nullptr;
    CD_CHECK(change_features(function, w, wanted));
    return set_parallel(function, static_cast<Object&>(w), parallel);
}

} // namespace shared
} // namespace cd
