// Calls that change water.
#include <math.h>

#include "random.hpp"
#include "water.hpp"

namespace fuzz {

void Water::act_by_kind() {
    switch (below(29)) {
    case 24: set_hulls(); break;
    case 25: set_hull(); break;
    case 26: place_hull(); break;
    case 27: drive_hull(); break;
    case 28: get_hull(); break;
    case 0:
        set_number("set_gravity", cd_water_set_gravity,
                   chance(0.1)   ? 0
                   : chance(0.5) ? 9.81
                                 : pick_number(-1, 2),
                   {0, 1e3});
        break;
    case 1: set_number("set_density", cd_water_set_density, pick_number(-2, 4), {1e-3, kHuge}); break;
    case 2: set_number("set_manning", cd_water_set_manning, chance(0.3) ? 0 : pick_number(-3, -1), {0, 10}); break;
    case 3:
    case 4: set_enum("set_momentum", cd_water_set_momentum, CD_MOMENTUM_ADVECTED); break;
    case 5: set_enum("set_first", cd_water_set_first, 1, kNoMemory); break;
    case 6: set_enum("set_bed_rule", cd_water_set_bed_rule, CD_BED_KEEPS_SURFACE, kNoMemory); break;
    case 7:
    case 8: chance(0.2) ? set_inflow_depth() : set_side(); break;
    case 9: add_volume(); break;
    case 10: add_volume_rectangle(); break;
    case 11: add_source(); break;
    case 12: add_source_rectangle(); break;
    case 13: splash(); break;
    case 14: impulse(); break;
    case 15: restart_account(); break;
    case 16: get_measures(); break;
    case 17: get_account(); break;
    case 18: chance(0.5) ? get_limited() : get_side(); break;
    case 19: get_shape(); break;
    case 20: sample(); break;
    case 21: write_vertices(); break;
    case 22: write_indices(); break;
    case 23: set_number("set_sleep", cd_water_set_sleep, chance(0.2) ? 0 : pick_number(-8, 0), {0, kHuge}, 0); break;
    default: get_parameter();
    }
}

Water::Disc Water::pick_disc() const {
    const double radius = chance(0.2) ? 0 : pick_between(0, whole().x);
    return {pick_between(0, whole().x), pick_between(0, whole().y), radius};
}

Water::Rectangle Water::pick_rectangle() const {
    Rectangle r = {below(nx), below(ny), 0, 0};
    r.columns = 1 + below(nx - r.x);
    r.rows = 1 + below(ny - r.y);
    size_t* const all[] = {&r.x, &r.y, &r.columns, &r.rows};
    if (chance(run.bad)) *all[below(4)] = wild_size(nx);
    return r;
}

double Water::pick_amount(double most) const {
    return run.sane || chance(0.8) ? uniform(-0.5, 1) * most * whole().x * whole().y : wild_number();
}

void Water::set_side() {
    const cd_side side = pick_enum(CD_SIDE_Y_LAST);
    const cd_border kind = pick_enum(CD_BORDER_LEVEL);
    const double value = !run.sane && chance(0.2) ? wild_number() : uniform(-1, 2);
    const double rate = chance(0.5) ? 0 : !run.sane && chance(0.2) ? wild_number() : uniform(-0.1, 0.1);
    const cd_status status =
        both(text("set_side %d %d %.17g %.17g", int(side), int(kind), value, rate), 0,
             [&](cd_water* water, int) { return cd_water_set_side(water, side, kind, value, rate); });
    if (status == CD_OK && !(fabs(value) < 10 && fabs(rate) < 10)) past.moderate = false;
}

void Water::set_inflow_depth() {
    const cd_side side = pick_enum(CD_SIDE_Y_LAST);
    const double depth = chance(0.2) ? 0 : !run.sane && chance(0.2) ? wild_number() : uniform(0.05, 2);
    const cd_status status = both(text("set_inflow_depth %d %.17g", int(side), depth), 0,
                                  [&](cd_water* water, int) { return cd_water_set_inflow_depth(water, side, depth); });
    if (status == CD_OK && depth != 0 && !(depth > 0.01)) past.moderate = false;
}

void Water::add_volume() {
    const Disc d = pick_disc();
    const double volume = pick_amount(1);
    double added[2] = {};
    const bool null = chance(0.2);
    const cd_status status =
        both(text("add_volume %.17g %.17g %.17g %.17g", d.x, d.y, d.radius, volume), kNoMemory,
             [&](cd_water* water, int which) {
                 return cd_water_add_volume(water, d.x, d.y, d.radius, volume, null ? nullptr : &added[which]);
             });
    must_agree("add_volume", &added[0], &added[1]);
    if (status == CD_OK && !run.sane) past.moderate = false;
}

void Water::add_volume_rectangle() {
    const Rectangle r = pick_rectangle();
    const double volume = pick_amount(1);
    double added[2] = {};
    const cd_status status =
        both(text("add_volume_rectangle %zu %zu %zu %zu %.17g", r.x, r.y, r.columns, r.rows, volume), kNoMemory,
             [&](cd_water* water, int which) {
                 return cd_water_add_volume_rectangle(water, r.x, r.y, r.columns, r.rows, volume, &added[which]);
             });
    must_agree("add_volume_rectangle", &added[0], &added[1]);
    if (status == CD_OK && !run.sane) past.moderate = false;
}

void Water::add_source() {
    const Disc d = pick_disc();
    const double rate = pick_amount(0.1);
    const cd_status status =
        both(text("add_source %.17g %.17g %.17g %.17g", d.x, d.y, d.radius, rate), 0,
             [&](cd_water* water, int) { return cd_water_add_source(water, d.x, d.y, d.radius, rate); });
    if (status == CD_OK && !run.sane) past.moderate = false;
}

void Water::add_source_rectangle() {
    const Rectangle r = pick_rectangle();
    const double rate = pick_amount(0.1);
    const cd_status status = both(
        text("add_source_rectangle %zu %zu %zu %zu %.17g", r.x, r.y, r.columns, r.rows, rate), 0,
        [&](cd_water* water, int) { return cd_water_add_source_rectangle(water, r.x, r.y, r.columns, r.rows, rate); });
    if (status == CD_OK && !run.sane) past.moderate = false;
}

void Water::splash() {
    const Disc d = pick_disc();
    const double height = run.sane || chance(0.8) ? uniform(0, 1) : wild_number();
    const double volume_before = account().volume;
    const cd_status status =
        both(text("splash %.17g %.17g %.17g %.17g", d.x, d.y, d.radius, height), kNoMemory,
             [&](cd_water* water, int) { return cd_water_splash(water, d.x, d.y, d.radius, height); });
    const double volume = account().volume, rounding = precision == CD_FLOAT64 ? 1e-12 : 1e-6;
    if (!run.broken && fabs(volume - volume_before) > rounding * volume_before && volume_before < kHuge)
        problem("splash: volume from %.17g to %.17g", volume_before, volume);
    if (status == CD_OK && !run.sane) past.moderate = false;
}

void Water::impulse() {
    const Disc d = pick_disc();
    const double x = pick_amount(1000), y = pick_amount(1000);
    const cd_status status =
        both(text("impulse %.17g %.17g %.17g %.17g %.17g", d.x, d.y, d.radius, x, y), kNoMemory,
             [&](cd_water* water, int) { return cd_water_impulse(water, d.x, d.y, d.radius, x, y); });
    if (status == CD_OK) past.moderate = false; // a thin film gets any velocity from it
}

void Water::restart_account() {
    both("restart_account", kNoMemory, [&](cd_water* water, int) { return cd_water_restart_account(water); });
    const Account now = account();
    if (!run.broken && now.volume < kHuge && !(now.initial == now.volume && now.in == 0 && now.out == 0))
        problem("restart_account: initial %.17g of %.17g, in %g, out %g", now.initial, now.volume, now.in, now.out);
}

} // namespace fuzz
