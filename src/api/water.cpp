// water.h: life, method, parameters, time, measuring, keeping. Fields are in water_fields.cpp, acting and samples in
// water_act.cpp, drawing in water_draw.cpp.
#include "api/water_handle.hh"

using namespace cd;

CD_OBJECT_FUNCTIONS(water)

// ---- life -----------------------------------------------------------------------------------------------------------

cd_status cd_water_create(size_t nx, size_t ny, double dx, double dy, cd_precision precision,
                          const cd_allocator* allocator, cd_water** out_water) {
    CD_NOT_NULL(out_water);
    CD_CHECK(shared::can_make(__func__, 1, precision, allocator));
    if (nx < 1) return fail(CD_ERROR_VALUE, __func__, "nx is 0, must be at least 1");
    if (ny < 1) return fail(CD_ERROR_VALUE, __func__, "ny is 0, must be at least 1");
    CD_CHECK(in_range(__func__, "dx", dx, kLeastCell, kMostCell));
    CD_CHECK(in_range(__func__, "dy", dy, kLeastCell, kMostCell));
    Water* w = nullptr;
    CD_CHECK(create_water(__func__, nx, ny, dx, dy, precision, allocator ? *allocator : default_allocator(), w));
    *out_water = reinterpret_cast<cd_water*>(w);
    return CD_OK;
}

cd_status cd_water_get_shape(const cd_water* water, size_t* out_nx, size_t* out_ny, double* out_dx, double* out_dy,
                             cd_precision* out_precision) {
    CD_OPEN(water, w);
    if (out_nx) *out_nx = w.cells[kX];
    if (out_ny) *out_ny = w.cells[kY];
    if (out_dx) *out_dx = w.size[kX];
    if (out_dy) *out_dy = w.size[kY];
    if (out_precision) *out_precision = w.precision;
    return CD_OK;
}

// ---- method ---------------------------------------------------------------------------------------------------------

CD_GETTER(water, get_momentum, cd_momentum, out_momentum, x.momentum)
CD_GETTER(water, get_first, int32_t, out_along_y, x.first)

cd_status cd_water_set_momentum(cd_water* water, cd_momentum momentum) {
    CD_OPEN(water, w);
    CD_CHECK(is_enum(__func__, "momentum", momentum, CD_MOMENTUM_ADVECTED));
    WaterFeatures wanted = features(w);
    wanted.momentum = momentum;
    CD_CHECK(shared::change_features(__func__, w, wanted));
    w.lambda = momentum == CD_MOMENTUM_LINEAR ? kLinearLambda : 0.5;
    w.prepared_dt = 0;
    return CD_OK;
}

cd_status cd_water_set_first(cd_water* water, int32_t along_y) {
    CD_OPEN(water, w);
    if (along_y != 0 && along_y != 1)
        return fail(CD_ERROR_VALUE, __func__, "along_y is %d, must be 0 or 1", int(along_y));
    w.first = along_y;
    return CD_OK;
}

// ---- parameters -----------------------------------------------------------------------------------------------------

cd_status cd_water_set_gravity(cd_water* water, double gravity) {
    CD_OPEN(water, w);
    if (gravity != 0) CD_CHECK(in_range(__func__, "gravity", gravity, kLeastGravity, kMostGravity, kOrZero));
    return shared::set_parameter(__func__, w, "gravity", gravity, w.gravity, 0, kMostGravity);
}
CD_GETTER(water, get_gravity, double, out_gravity, x.gravity)
CD_FUNCTION(water, , set_density, (double density),
            shared::set_parameter(__func__, x, "density", density, x.density, kLeastDensity, kMostDensity))
CD_GETTER(water, get_density, double, out_density, x.density)
CD_FUNCTION(water, , set_drag, (double drag), shared::set_parameter(__func__, x, "drag", drag, x.drag))
CD_GETTER(water, get_drag, double, out_drag, x.drag)
CD_FUNCTION(water, , set_manning, (double manning),
            shared::set_parameter(__func__, x, "manning", manning, x.manning, 0, kMostManning))
CD_GETTER(water, get_manning, double, out_manning, x.manning)
CD_GETTER(water, get_bed_rule, cd_bed_rule, out_rule, x.bed_rule)

cd_status cd_water_set_bed_rule(cd_water* water, cd_bed_rule rule) {
    CD_OPEN(water, w);
    CD_CHECK(is_enum(__func__, "rule", rule, CD_BED_KEEPS_SURFACE));
    w.bed_rule = rule;
    return CD_OK;
}

cd_status cd_water_set_side(cd_water* water, cd_side side, cd_border kind, double value, double rate) {
    CD_OPEN(water, w);
    CD_CHECK(is_enum(__func__, "side", side, CD_SIDE_Y_LAST));
    CD_CHECK(is_enum(__func__, "kind", kind, CD_BORDER_LEVEL));
    WaterSide wanted{kind, 0, 0};
    if (has_value(kind)) {
        const double most = is_wide(w) ? kMost : 1e30;
        CD_CHECK(in_range(__func__, "value", value, -most, most));
        CD_CHECK(in_range(__func__, "rate", rate, -most, most));
        wanted = {kind, value - rate * w.clock.time(), rate};
    }
    set_side(w, side, wanted);
    return CD_OK;
}

cd_status cd_water_get_side(const cd_water* water, cd_side side, cd_border* out_kind, double* out_value,
                            double* out_rate) {
    CD_OPEN(water, w);
    CD_CHECK(is_enum(__func__, "side", side, CD_SIDE_Y_LAST));
    if (out_kind) *out_kind = w.side[side].kind;
    if (out_value) *out_value = side_value(w.side[side], w.clock.time());
    if (out_rate) *out_rate = w.side[side].rate;
    return CD_OK;
}

cd_status cd_water_set_inflow_depth(cd_water* water, cd_side side, double depth) {
    CD_OPEN(water, w);
    CD_CHECK(is_enum(__func__, "side", side, CD_SIDE_Y_LAST));
    if (depth != 0) CD_CHECK(in_range(__func__, "depth", depth, kLeastInflowDepth, kMostInflowDepth, kOrZero));
    w.inflow_depth[side] = depth;
    return CD_OK;
}

cd_status cd_water_get_inflow_depth(const cd_water* water, cd_side side, double* out_depth) {
    CD_OPEN(water, w);
    CD_CHECK(is_enum(__func__, "side", side, CD_SIDE_Y_LAST));
    return shared::tell(__func__, "out_depth", out_depth, w.inflow_depth[side]);
}

// ---- sleep ----------------------------------------------------------------------------------------------------------

CD_GETTER(water, get_sleep, double, out_height, x.sleep)
CD_GETTER(water, get_awake, size_t, out_cells, x.sleep > 0 ? x.awake : x.cells[kX] * x.cells[kY])

cd_status cd_water_set_sleep(cd_water* water, double height) {
    CD_OPEN(water, w);
    CD_CHECK(in_range(__func__, "height", height, 0, kMost));
    WaterFeatures wanted = features(w);
    wanted.sleep = height > 0;
    CD_CHECK(shared::change_features(__func__, w, wanted));
    w.sleep = height;
    return CD_OK;
}

// ---- time -----------------------------------------------------------------------------------------------------------

cd_status cd_water_step(cd_water* water, double dt, size_t count) {
    CD_OPEN_QUIETLY(water, w);
    CD_CHECK(shared::can_step(__func__, w, dt, count));
    if (count == 0) return CD_OK;
    const uint64_t diverged_at = step_water(w, dt, count);
    return diverged_at ? shared::diverged_at(__func__, diverged_at) : CD_OK;
}

cd_status cd_water_get_limited(const cd_water* water, uint64_t* out_cells, double* out_volume) {
    CD_OPEN(water, w);
    if (out_cells) *out_cells = w.limited_cells;
    if (out_volume) *out_volume = w.limited_volume;
    return CD_OK;
}

// ---- measuring ------------------------------------------------------------------------------------------------------

CD_GETTER(water, get_volume, double, out_volume, volume(x))
CD_GETTER(water, get_wet_area, double, out_area, wet_area(x))

cd_status cd_water_get_account(const cd_water* water, double* out_initial, double* out_in, double* out_out,
                               double* out_error) {
    CD_OPEN(water, w);
    if (out_initial) *out_initial = w.account.initial;
    if (out_in) *out_in = w.account.in;
    if (out_out) *out_out = w.account.out;
    if (out_error) *out_error = volume(w) - (w.account.initial + w.account.in - w.account.out);
    return CD_OK;
}

cd_status cd_water_restart_account(cd_water* water) {
    CD_OPEN(water, w);
    restart_account(w);
    return CD_OK;
}

cd_status cd_water_get_energy(const cd_water* water, double* out_kinetic, double* out_potential) {
    CD_OPEN(water, w);
    double kinetic, potential;
    energy(w, kinetic, potential);
    if (out_kinetic) *out_kinetic = kinetic;
    if (out_potential) *out_potential = potential;
    return CD_OK;
}

cd_status cd_water_get_courant(const cd_water* water, double dt, double* out_courant) {
    CD_OPEN(water, w);
    CD_NOT_NULL(out_courant);
    CD_CHECK(in_range(__func__, "dt", dt, 0, 1e30));
    *out_courant = courant(w, dt);
    return CD_OK;
}
