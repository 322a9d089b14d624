// Calls of membranes whose springs have a length.
#include <math.h>

#include "membrane.hpp"
#include "random.hpp"

namespace fuzz {

void Membrane::act() {
    if (has_lengths() && lacks_something() && chance(0.4)) return get_ready();
    if (likes_lengths && !has_lengths() && chance(0.1)) return set_rest_length();
    if (likes_things && has_lengths() && chance(0.08)) {
        if (things().empty()) return set_colliders();
        if (chance(0.3)) return chance(0.5) ? set_bed() : set_callback();
        return chance(0.4) ? set_plane() : set_capsule();
    }
    Body<MembraneApi>::act();
}

void Membrane::get_ready() {
    const double lambda = chance(0.5) ? 1 : chance(0.5) ? 0.5 : 0.75;
    both("set_method 0", 0,
         [&](cd_membrane* membrane, int) { return cd_membrane_set_method(membrane, CD_METHOD_IMPLICIT); });
    both(text("set_lambda %g", lambda), kNoMemory,
         [&](cd_membrane* membrane, int) { return cd_membrane_set_lambda(membrane, lambda); });
    both("set_stiffness_damping 0", kNoMemory,
         [&](cd_membrane* membrane, int) { return cd_membrane_set_stiffness_damping(membrane, 0); });
    for (cd_edge edge = CD_EDGE_U_FIRST; edge <= CD_EDGE_V_LAST; ++edge) {
        cd_node kind = CD_NODE_FREE;
        cd_membrane_get_edge(first(), edge, &kind);
        if (kind != CD_NODE_MATCHED) continue;
        both(text("set_edge %d 0", int(edge)), 0,
             [&](cd_membrane* membrane, int) { return cd_membrane_set_edge(membrane, edge, CD_NODE_FREE); });
    }
}

void Membrane::set_rest_length() {
    static const double hostile[] = {1e-60, 1e60, 9e-61, 1.1e60, -0.0, 5e-324};
    double length[2];
    const bool none = chance(0.15);
    for (double& l : length)
        l = none                       ? 0
            : !run.sane && chance(0.1) ? hostile[below(6)]
            : chance(0.05)             ? pick_number(-60, 60)
                                       : pick_number(-2, 2);
    if (chance(run.bad)) length[below(2)] = 0;
    const bool before = has_lengths();
    const cd_status status =
        both(text("set_rest_length %.17g %.17g", length[0], length[1]), 0,
             [&](cd_membrane* membrane, int) { return cd_membrane_set_rest_length(membrane, length[0], length[1]); });
    if (status != CD_OK || run.broken) return;
    double lambda = 0, air[2] = {};
    cd_membrane_get_lambda(first(), &lambda);
    cd_membrane_get_air(first(), &air[0], &air[1]);
    if (has_lengths() != (length[0] > 0)) return problem("set_rest_length: cloth now: %d", int(has_lengths()));
    for (double l : length)
        if (has_lengths() && !(l >= 1e-3 && l <= 1e3)) past.moderate = false;
    if (has_lengths() && (components != 3 || nu == 0 || nv == 0)) problem("cloth: it can't be");
    if (has_lengths() && !before && lambda != 1) problem("cloth: begins with lambda %g", lambda);
    if (!has_lengths() && (air[0] != 0 || air[1] != 0 || !things().empty()))
        problem("set_rest_length 0: air %g %g and %zu colliders stay", air[0], air[1], things().size());
}

void Membrane::set_shear() {
    const bool can = has_lengths();
    set_number("set_shear", cd_membrane_set_shear, chance(0.3) ? 0 : pick_number(-2, 5), {0, 1e7});
    double shear = 0;
    cd_membrane_get_shear(first(), &shear);
    if (!can && shear != 0) problem("set_shear: no cloth, but it is taken");
}

void Membrane::set_compression() {
    set_number("set_compression", cd_membrane_set_compression, chance(0.3) ? 0 : pick_number(-1, 4), {0, 1e6});
}

void Membrane::set_breaking_strain() {
    const double strain = chance(0.4) ? double(INFINITY) : pick_number(-3, 2);
    const cd_status status = both(text("set_breaking_strain %.17g", strain), 0, [&](cd_membrane* membrane, int) {
        return cd_membrane_set_breaking_strain(membrane, strain);
    });
    if (status == CD_OK && !has_lengths()) problem("set_breaking_strain: no cloth, but it is taken");
    if (status == CD_OK && strain < HUGE_VAL && (all_of(CD_STIFFNESS_U).empty() || all_of(CD_STIFFNESS_V).empty()))
        problem("set_breaking_strain: springs may tear, but have no stiffness of their own");
}

void Membrane::set_effort() {
    const size_t newton = chance(run.bad) ? wild_size(3) : 1 + below(4);
    const size_t gradient = chance(run.bad) ? wild_size(3) : below(25);
    const bool good = newton >= 1 && newton <= 1000 && gradient <= 10000;
    const bool can = has_lengths();
    const cd_status status =
        both(text("set_effort %zu %zu", newton, gradient), kNoMemory,
             [&](cd_membrane* membrane, int) { return cd_membrane_set_effort(membrane, newton, gradient); });
    if (!run.broken && (status == CD_OK) != (good && can)) problem("set_effort: %s", cd_status_name(status));
}

void Membrane::set_air() {
    const double along = chance(0.4) ? 0 : pick_number(-3, 3), across = chance(0.2) ? 0 : pick_number(-3, 3);
    const cd_status status = both(text("set_air %.17g %.17g", along, across), 0, [&](cd_membrane* membrane, int) {
        return cd_membrane_set_air(membrane, along, across);
    });
    if (status == CD_OK && !(along < 1e6 && across < 1e6)) past.moderate = false;
    if (status == CD_OK && !has_lengths()) problem("set_air: no cloth, but it is taken");
}

void Membrane::set_wind() {
    double wind[4];
    bool moderate = true;
    const bool none = chance(0.4);
    for (double& v : wind) {
        v = none || chance(0.3) ? 0 : pick_number(-1, 1.5);
        moderate &= fabs(v) < 1e3;
    }
    const size_t count = pick_count(components);
    const bool null = pick_null();
    const cd_status status =
        both(text("set_wind %.17g %.17g %.17g, count %zu%s", wind[0], wind[1], wind[2], count, null ? ", null" : ""),
             kNoMemory,
             [&](cd_membrane* membrane, int) { return cd_membrane_set_wind(membrane, null ? nullptr : wind, count); });
    if (status == CD_OK && !moderate) past.moderate = false;
}

void Membrane::get_of_cloth() {
    double pair[2][4] = {};
    size_t effort[2][2] = {};
    switch (below(11)) {
    case 10: get("get_loads", cd_membrane_get_loads); break;
    case 8: get("get_breaking_strain", cd_membrane_get_breaking_strain); break;
    case 9: get("get_broken", cd_membrane_get_broken, false); break; // a copy may not have stepped yet
    case 0: get("get_shear", cd_membrane_get_shear); break;
    case 1: get("get_compression", cd_membrane_get_compression); break;
    case 2: get("get_thickness", cd_membrane_get_thickness); break;
    case 3: get("get_colliders", cd_membrane_get_colliders); break;
    case 4:
        both("get_rest_length", kReads, [&](cd_membrane* membrane, int which) {
            return cd_membrane_get_rest_length(membrane, &pair[which][0], &pair[which][1]);
        });
        return must_agree("get_rest_length", pair[0], pair[1], 2);
    case 5:
        both("get_air", kReads, [&](cd_membrane* membrane, int which) {
            return cd_membrane_get_air(membrane, &pair[which][0], &pair[which][1]);
        });
        return must_agree("get_air", pair[0], pair[1], 2);
    case 6: {
        const size_t count = pick_count(components);
        both("get_wind", kReads,
             [&](cd_membrane* membrane, int which) { return cd_membrane_get_wind(membrane, pair[which], count); });
        return must_agree("get_wind", pair[0], pair[1], 4);
    }
    default:
        both("get_effort", kReads, [&](cd_membrane* membrane, int which) {
            return cd_membrane_get_effort(membrane, &effort[which][0], &effort[which][1]);
        });
        return must_agree("get_effort", effort[0], effort[1], 2);
    }
}

} // namespace fuzz
