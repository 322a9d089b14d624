// Calls that read water: what it tells, samples and drawings.
#include <string.h>

#include <algorithm>

#include "random.hpp"
#include "water.hpp"

namespace fuzz {

void Water::get_measures() {
    get("get_volume", cd_water_get_volume);
    get("get_wet_area", cd_water_get_wet_area);
    double energy[2][2] = {}, courant[2] = {};
    const double dt = chance(run.bad) ? wild_number() : 0.1;
    both("get_energy", kReads,
         [&](cd_water* water, int which) { return cd_water_get_energy(water, &energy[which][0], &energy[which][1]); });
    must_agree("get_energy", energy[0], energy[1], 2);
    both(text("get_courant %.17g", dt), kReads,
         [&](cd_water* water, int which) { return cd_water_get_courant(water, dt, &courant[which]); });
    must_agree("get_courant", &courant[0], &courant[1]);
}

void Water::get_account() {
    double out[2][4] = {};
    const bool some = chance(0.2);
    both("get_account", kReads, [&](cd_water* water, int which) {
        double* const o = out[which];
        return cd_water_get_account(water, &o[0], some ? nullptr : &o[1], some ? nullptr : &o[2], &o[3]);
    });
    must_agree("get_account", out[0], out[1], 4);
}

// The twin may be a copy that has not stepped yet: they need not agree.
void Water::get_limited() {
    uint64_t cells = 0;
    double volume = 0;
    const bool some = chance(0.2);
    both("get_limited", kReads,
         [&](cd_water* water, int) { return cd_water_get_limited(water, some ? nullptr : &cells, &volume); });
    if (volume < 0) problem("get_limited tells %g m^3", volume); // NaN of a call that diverged
    size_t awake = 0;
    both("get_awake", kReads, [&](cd_water* water, int) { return cd_water_get_awake(water, &awake); });
    if (awake > nx * ny) problem("get_awake tells %zu of %zu cells", awake, nx * ny);
}

void Water::get_side() {
    const cd_side side = pick_enum(CD_SIDE_Y_LAST);
    cd_border kinds[2] = {};
    double out[2][2] = {};
    both("get_side", kReads, [&](cd_water* water, int which) {
        return cd_water_get_side(water, side, &kinds[which], &out[which][0], &out[which][1]);
    });
    must_agree("get_side", &kinds[0], &kinds[1]);
    must_agree("get_side", out[0], out[1], 2);
    both("get_inflow_depth", kReads,
         [&](cd_water* water, int which) { return cd_water_get_inflow_depth(water, side, &out[which][0]); });
    must_agree("get_inflow_depth", out[0], out[1], 1);
}

void Water::get_shape() {
    size_t cells[2] = {nx, ny};
    double sizes[2][2] = {};
    cd_precision stored = precision;
    const bool some = chance(0.5);
    const cd_status status = both("get_shape", kReads, [&](cd_water* water, int which) {
        return cd_water_get_shape(water, &cells[0], some ? nullptr : &cells[1], &sizes[which][0], &sizes[which][1],
                                  some ? nullptr : &stored);
    });
    must_agree("get_shape", sizes[0], sizes[1], 2);
    if (status != CD_OK || cells[0] != nx || cells[1] != ny || stored != precision)
        problem("get_shape tells another shape");
}

void Water::get_parameter() {
    switch (below(7)) {
    case 6: get("get_sleep", cd_water_get_sleep); break;
    case 0: get("get_gravity", cd_water_get_gravity); break;
    case 1: get("get_density", cd_water_get_density); break;
    case 2: get("get_manning", cd_water_get_manning); break;
    case 3: get("get_momentum", cd_water_get_momentum); break;
    case 4: get("get_first", cd_water_get_first); break;
    default: get("get_bed_rule", cd_water_get_bed_rule);
    }
}

void Water::sample() {
    const size_t n = below(9), told = chance(0.02) ? SIZE_MAX / 4 + 1 + below(9) : n;
    const cd_outside outside = pick_enum(CD_OUTSIDE_NEAREST);
    Doubles at(2 * n);
    for (size_t i = 0; i < n; ++i) at[2 * i] = pick_between(0, whole().x), at[2 * i + 1] = pick_between(0, whole().y);
    const bool some = chance(0.2);
    struct Outputs {
        Doubles surface, depth, normal, velocity;
    };
    const Outputs untouched = {Doubles(n + 1, 7), Doubles(n + 1, 7), Doubles(3 * n + 1, 7), Doubles(2 * n + 1, 7)};
    Outputs outputs[2] = {untouched, untouched};
    const cd_status status = both(text("sample %zu", told), kReads, [&](cd_water* water, int which) {
        Outputs& o = outputs[which];
        return cd_water_sample(water, at.data(), told, outside, some ? nullptr : o.surface.data(), o.depth.data(),
                               some ? nullptr : o.normal.data(), o.velocity.data());
    });
    const Outputs &a = outputs[0], &b = outputs[1];
    if (a.surface.back() != 7 || a.depth.back() != 7 || a.normal.back() != 7 || a.velocity.back() != 7)
        problem("sample wrote past its end");
    if (status != CD_OK) return;
    must_agree("sample of the surface", a.surface.data(), b.surface.data(), n);
    must_agree("sample of depth", a.depth.data(), b.depth.data(), n);
    must_agree("sample of the normal", a.normal.data(), b.normal.data(), 3 * n);
    must_agree("sample of velocity", a.velocity.data(), b.velocity.data(), 2 * n);
}

void Water::write_vertices() {
    size_t stride = 28 + below(30), position = below(3), normal = chance(0.2) ? SIZE_MAX : 14 + below(4);
    size_t depth = chance(0.2) ? SIZE_MAX : 26 + below(6), size = nx * ny * stride;
    if (chance(run.bad)) position = wild_size(12);
    if (chance(run.bad)) normal = wild_size(12);
    if (chance(run.bad)) depth = wild_size(12);
    if (chance(run.bad)) size -= 1;
    if (chance(run.bad)) stride = wild_size(24), size = std::min(size, size_t(100));
    Bytes buffer(size, 0x77), twin_buffer = buffer;
    const cd_status status =
        both(text("write_vertices size %zu, stride %zu, position at %zu, normal at %zu, depth at %zu", size, stride,
                  position, normal, depth),
             kReads, [&](cd_water* water, int which) {
                 Bytes& to = which ? twin_buffer : buffer;
                 return cd_water_write_vertices(water, to.data(), size, stride, position, normal, depth);
             });
    if (status == CD_OK && !past.diverged) must_agree("write_vertices", buffer.data(), twin_buffer.data(), size);
    for (unsigned char byte : buffer)
        if (status != CD_OK && byte != 0x77) return problem("write_vertices failed, but wrote its output");
}

void Water::write_indices() {
    const int32_t skip_dry = pick_enum(1);
    size_t count[2] = {};
    both(text("get_index_count %d", int(skip_dry)), kReads,
         [&](cd_water* water, int which) { return cd_water_get_index_count(water, skip_dry, &count[which]); });
    must_agree("get_index_count", &count[0], &count[1]);
    const size_t width = chance(run.bad) ? wild_size(4) : chance(0.5) ? 2 : 4;
    size_t size = count[0] * (width == 2 ? 2 : 4);
    const bool too_small = chance(0.1) && size > 0;
    if (too_small) size -= 1 + below(size);
    Bytes buffer(size);
    const cd_status status =
        both(text("write_indices size %zu, index_size %zu", size, width), kReads,
             [&](cd_water* water, int) { return cd_water_write_indices(water, skip_dry, buffer.data(), size, width); });
    if (status != CD_OK || run.broken) return;
    if (too_small) return problem("write_indices fits into too small a buffer");
    for (size_t i = 0; i < count[0]; ++i) {
        uint32_t index = 0;
        memcpy(&index, &buffer[i * width], width);
        if (index >= nx * ny) return problem("write_indices: index %u of %zu cells", unsigned(index), nx * ny);
    }
}

} // namespace fuzz
