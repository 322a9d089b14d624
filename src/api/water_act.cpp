// water.h: acting on the water, and what it is at places.
#include "api/water_handle.hh"
#include "model/water_shares.hh"

using namespace cd;

namespace {

cd_status is_disc(const char* function, const Water& w, const Disc& disc) {
    CD_CHECK(in_range(function, "x", disc.x, 0, length_of(w, kX)));
    CD_CHECK(in_range(function, "y", disc.y, 0, length_of(w, kY)));
    return in_range(function, "radius", disc.radius, 0, kMost);
}

cd_status is_rectangle(const char* function, const Water& w, const CellRectangle& part) {
    CD_CHECK(is_part(function, "first_x", part.first_x, "n_x", part.n_x, w.cells[kX], "cells along x"));
    return is_part(function, "first_y", part.first_y, "n_y", part.n_y, w.cells[kY], "cells along y");
}

cd_status is_amount(const char* function, const char* name, double value) {
    return in_range(function, name, value, -kMost, kMost);
}

cd_status out_of_range(const char* function, const char* name, double value, const char* what) {
    return fail(CD_ERROR_VALUE, function, "%s is %g: a %s would leave the range of the water's precision", name, value,
                what);
}

cd_status add(const char* function, Water& w, const Shares& shares, double volume, double* out_added) {
    CD_CHECK(shared::is_finite(function, w));
    double added;
    if (!add_volume(w, shares, volume, added)) return out_of_range(function, "volume", volume, "depth");
    if (out_added) *out_added = added;
    return CD_OK;
}

cd_status add_rate(const char* function, Water& w, const Shares& shares, double rate) {
    if (!can_add_source(w, shares, rate)) return out_of_range(function, "rate", rate, "source");
    CD_CHECK(shared::switch_field(function, w, CD_SOURCE, true));
    add_source(w, shares, rate);
    return CD_OK;
}

} // namespace

// ---- acting on it ---------------------------------------------------------------------------------------------------

cd_status cd_water_add_volume(cd_water* water, double x, double y, double radius, double volume, double* out_added) {
    CD_OPEN_QUIETLY(water, w);
    const Disc disc{x, y, radius};
    CD_CHECK(is_disc(__func__, w, disc));
    CD_CHECK(is_amount(__func__, "volume", volume));
    return add(__func__, w, Shares(w, disc), volume, out_added);
}

cd_status cd_water_add_volume_rectangle(cd_water* water, size_t first_x, size_t first_y, size_t n_x, size_t n_y,
                                        double volume, double* out_added) {
    CD_OPEN_QUIETLY(water, w);
    const CellRectangle part{first_x, first_y, n_x, n_y};
    CD_CHECK(is_rectangle(__func__, w, part));
    CD_CHECK(is_amount(__func__, "volume", volume));
    return add(__func__, w, Shares(w, part), volume, out_added);
}

cd_status cd_water_add_source(cd_water* water, double x, double y, double radius, double rate) {
    CD_OPEN(water, w);
    const Disc disc{x, y, radius};
    CD_CHECK(is_disc(__func__, w, disc));
    CD_CHECK(is_amount(__func__, "rate", rate));
    return add_rate(__func__, w, Shares(w, disc), rate);
}

cd_status cd_water_add_source_rectangle(cd_water* water, size_t first_x, size_t first_y, size_t n_x, size_t n_y,
                                        double rate) {
    CD_OPEN(water, w);
    const CellRectangle part{first_x, first_y, n_x, n_y};
    CD_CHECK(is_rectangle(__func__, w, part));
    CD_CHECK(is_amount(__func__, "rate", rate));
    return add_rate(__func__, w, Shares(w, part), rate);
}

cd_status cd_water_splash(cd_water* water, double x, double y, double radius, double height) {
    CD_OPEN_QUIETLY(water, w);
    const Disc disc{x, y, radius};
    CD_CHECK(is_disc(__func__, w, disc));
    CD_CHECK(in_range(__func__, "height", height, 0, kMost));
    CD_CHECK(shared::is_finite(__func__, w));
    return splash(w, disc, height) ? CD_OK : out_of_range(__func__, "height", height, "depth");
}

cd_status cd_water_impulse(cd_water* water, double x, double y, double radius, double impulse_x, double impulse_y) {
    CD_OPEN_QUIETLY(water, w);
    const Disc disc{x, y, radius};
    CD_CHECK(is_disc(__func__, w, disc));
    CD_CHECK(is_amount(__func__, "impulse_x", impulse_x));
    CD_CHECK(is_amount(__func__, "impulse_y", impulse_y));
    CD_CHECK(shared::is_finite(__func__, w));
    if (impulse(w, disc, impulse_x, impulse_y)) return CD_OK;
    const bool larger_x = fabs(impulse_x) > fabs(impulse_y);
    return out_of_range(__func__, larger_x ? "impulse_x" : "impulse_y", larger_x ? impulse_x : impulse_y, "velocity");
}

// ---- at places ------------------------------------------------------------------------------------------------------

cd_status cd_water_sample(const cd_water* water, const double* at, size_t n, cd_outside outside, double* out_surface,
                          double* out_depth, double* out_normal, double* out_velocity) {
    CD_OPEN(water, w);
    CD_CHECK(are_places(__func__, w, at, n, outside));
    for (size_t k = 0; k < n; ++k) {
        const double x = nearest(at[2 * k], length_of(w, kX)), y = nearest(at[2 * k + 1], length_of(w, kY));
        const WaterSample here = sample(w, x, y);
        if (out_surface) out_surface[k] = here.surface;
        if (out_depth) out_depth[k] = here.depth;
        if (out_normal) memcpy(out_normal + 3 * k, here.normal, sizeof here.normal);
        if (out_velocity) memcpy(out_velocity + 2 * k, here.velocity, sizeof here.velocity);
    }
    return CD_OK;
}
