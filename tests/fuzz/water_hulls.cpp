// Calls of the hulls that float on water.
#include <math.h>

#include "random.hpp"
#include "water.hpp"

namespace fuzz {

// Of hulls only whether they are finite counts.
double Water::state_size() const {
    size_t count = 0;
    cd_water_get_hulls(first(), &count, nullptr, nullptr);
    for (size_t i = 0; i < count; ++i) {
        double numbers[26] = {};
        cd_water_get_hull_pose(first(), i, numbers, 7);
        cd_water_get_hull_velocity(first(), i, numbers + 7, 6);
        cd_water_get_hull_floor(first(), i, numbers + 13, 7);
        cd_water_get_hull_load(first(), i, numbers + 20, 6);
        for (double x : numbers)
            if (!isfinite(x)) return HUGE_VAL;
    }
    return largest_of({CD_DEPTH, CD_VELOCITY_X, CD_VELOCITY_Y});
}

void Water::set_hulls() {
    const size_t count = below(4), along = pick_index(5) + 1, across = pick_index(4) + 1;
    both(text("set_hulls %zu %zu %zu", count, along, across), 0,
         [&](cd_water* water, int) { return cd_water_set_hulls(water, count, along, across); });
}

void Water::set_hull() {
    size_t count = 0, along = 0, across = 0;
    cd_water_get_hulls(first(), &count, &along, &across);
    const size_t index = pick_index(count ? count : 1);
    const double size = fmin(whole().x, whole().y);
    double mass = pick_number(-1, 4), length = size * uniform(0.05, 1), width = length * uniform(0.2, 1);
    if (!run.sane && chance(0.1)) (chance(0.5) ? mass : length) = wild_number();
    Doubles heights(along * across);
    for (double& height : heights) height = chance(0.1) ? -1 : uniform(0, 0.5);
    const size_t told = pick_count(heights.size());
    const bool disc = chance(0.3), flat = chance(0.3);
    const cd_status status =
        both(text("set_hull %zu %.17g %.17g %.17g", index, mass, length, width), 0, [&](cd_water* water, int) {
            return disc ? cd_water_set_disc(water, index, mass, length / 2)
                        : cd_water_set_hull(water, index, mass, length, width, flat ? nullptr : heights.data(),
                                            flat ? 0 : told > heights.size() ? SIZE_MAX : told);
        });
    if (status == CD_OK) past.moderate = false; // what it presses out has any speed
    if (chance(0.05))
        both(text("remove_hull %zu", index), kNoMemory,
             [&](cd_water* water, int) { return cd_water_remove_hull(water, index); });
}

void Water::place_hull() {
    size_t count = 0;
    cd_water_get_hulls(first(), &count, nullptr, nullptr);
    const size_t index = pick_index(count ? count : 1);
    const double x = pick_between(0, whole().x), y = pick_between(0, whole().y);
    const double ahead_x = uniform(-1, 1), ahead_y = uniform(-1, 1);
    if (chance(0.7)) {
        both(text("launch_hull %zu %.17g %.17g %.17g %.17g", index, x, y, ahead_x, ahead_y), kNoMemory,
             [&](cd_water* water, int) { return cd_water_launch_hull(water, index, x, y, ahead_x, ahead_y); });
        return;
    }
    double pose[7] = {x, y, uniform(-1, 2), ahead_x, ahead_y, uniform(-0.2, 0.2), uniform(-0.2, 0.2)};
    if (!run.sane && chance(0.2)) pose[below(7)] = wild_number();
    const size_t told = pick_count(7);
    both(text("set_hull_pose %zu", index), kNoMemory,
         [&](cd_water* water, int) { return cd_water_set_hull_pose(water, index, pose, told); });
}

void Water::drive_hull() {
    size_t count = 0;
    cd_water_get_hulls(first(), &count, nullptr, nullptr);
    const size_t index = pick_index(count ? count : 1), told = pick_count(6);
    double six[6];
    for (double& number : six) number = uniform(-1, 1);
    if (!run.sane && chance(0.2)) six[below(6)] = wild_number();
    const int which_call = int(below(3));
    const double drag = run.sane || chance(0.8) ? pick_number(-1, 4) : wild_number();
    both(text("drive_hull %d %zu %.17g", which_call, index, drag), kNoMemory, [&](cd_water* water, int) {
        return which_call == 0   ? cd_water_set_hull_velocity(water, index, six, told)
               : which_call == 1 ? cd_water_set_hull_force(water, index, six, told)
                                 : cd_water_set_hull_drag(water, index, drag, 2 * drag, 0.5);
    });
}

void Water::get_hull() {
    size_t count = 0;
    cd_water_get_hulls(first(), &count, nullptr, nullptr);
    const size_t index = pick_index(count ? count : 1), pose = pick_count(7), six = pick_count(6);
    double outputs[2][64] = {};
    const cd_outside outside = pick_enum(CD_OUTSIDE_NEAREST);
    const double at[2] = {pick_between(0, whole().x), pick_between(0, whole().y)};
    both("get_hull_energy", kReads, [&](cd_water* water, int which) {
        return cd_water_get_hull_energy(water, &outputs[which][0], &outputs[which][1]);
    });
    both("sample_heads", kReads,
         [&](cd_water* water, int which) { return cd_water_sample_heads(water, at, 1, outside, &outputs[which][2]); });
    both("get_hull", kReads, [&](cd_water* water, int which) {
        double* const out = outputs[which];
        return cd_water_get_hull(water, index, out + 3, out + 4, out + 5, out + 6, nullptr, 0);
    });
    both("get_hull_pose", kReads, [&](cd_water* water, int which) {
        return cd_water_get_hull_pose(water, index, &outputs[which][7], pose);
    });
    both("get_hull_floor", kReads, [&](cd_water* water, int which) {
        return cd_water_get_hull_floor(water, index, &outputs[which][14], pose);
    });
    both("get_hull_velocity", kReads, [&](cd_water* water, int which) {
        return cd_water_get_hull_velocity(water, index, &outputs[which][21], six);
    });
    both("get_hull_force", kReads, [&](cd_water* water, int which) {
        return cd_water_get_hull_force(water, index, &outputs[which][27], six);
    });
    both("get_hull_load", kReads, [&](cd_water* water, int which) {
        return cd_water_get_hull_load(water, index, &outputs[which][33], six);
    });
    both("get_hull_drag", kReads, [&](cd_water* water, int which) {
        double* const out = outputs[which];
        return cd_water_get_hull_drag(water, index, out + 39, out + 40, out + 41);
    });
    if (!past.diverged) must_agree("get_hull", outputs[0], outputs[1], size_t(64));
}

} // namespace fuzz
