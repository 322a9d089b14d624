// Calls of chains whose springs have a length.
#include <math.h>

#include "chain.hpp"
#include "random.hpp"

namespace fuzz {

void Chain::act() {
    if (is_rope() && lacks_something() && chance(0.4)) return get_ready();
    if (likes_lengths && !is_rope() && chance(0.1)) return set_rest_length();
    if (likes_things && is_rope() && chance(0.12)) {
        if (things().empty()) return set_colliders();
        if (chance(0.3)) return chance(0.5) ? set_bed() : set_callback();
        return chance(0.4) ? set_plane() : set_capsule();
    }
    Body<ChainApi>::act();
}

void Chain::get_ready() {
    const double lambda = chance(0.5) ? 0.5 : chance(0.5) ? 1 : 0.75;
    both("set_method 0", 0, [&](cd_chain* chain, int) { return cd_chain_set_method(chain, CD_METHOD_IMPLICIT); });
    both(text("set_lambda %g", lambda), kNoMemory,
         [&](cd_chain* chain, int) { return cd_chain_set_lambda(chain, lambda); });
    both("set_stiffness_damping 0", kNoMemory,
         [&](cd_chain* chain, int) { return cd_chain_set_stiffness_damping(chain, 0); });
    both("set_ring 0", 0, [&](cd_chain* chain, int) { return cd_chain_set_ring(chain, 0); });
    for (cd_end end = CD_END_FIRST; end <= CD_END_LAST && has_matched(); ++end)
        both(text("set_end %d 0", int(end)), kNoMemory,
             [&](cd_chain* chain, int) { return cd_chain_set_end(chain, end, CD_NODE_FREE); });
}

void Chain::set_rest_length() {
    static const double hostile[] = {1e-60, 1e60, 9e-61, 1.1e60, -0.0, 5e-324};
    const double length = chance(0.15)               ? 0
                          : !run.sane && chance(0.1) ? hostile[below(6)]
                          : chance(0.05)             ? pick_number(-60, 60)
                                                     : pick_number(-2, 2);
    const bool was_rope = is_rope();
    set_number("set_rest_length", cd_chain_set_rest_length, length, {length == 0 ? 0 : 1e-3, 1e3}, 0);
    if (!run.broken && is_rope() && (components > 3 || springs == 0)) problem("rope: it can't be one");
    Doubles tension;
    const bool has_tension = on_part<ChainApi>(cd_chain_read_f64, first(), CD_TENSION, {0, strands, 0, 0, 0},
                                               static_cast<double*>(nullptr)) == CD_OK;
    if (!run.broken && has_tension != is_rope()) problem("rope: has a tension: %d", int(has_tension));
    if (!was_rope && is_rope())
        for (double t : all_of(CD_TENSION))
            if (t != 0) return problem("rope: begins with a tension of %g", t);
}

void Chain::set_tolerance() {
    const double tolerance = chance(run.bad) ? wild_number() : chance(0.1) ? 0.5 : decades(-13.9, -0.4);
    const size_t most = chance(run.bad) ? below(2) : 1 + below(chance(0.3) ? 3 : 300);
    both(text("set_tolerance %.17g %zu", tolerance, most), kNoMemory,
         [&](cd_chain* chain, int) { return cd_chain_set_tolerance(chain, tolerance, most); });
}

void Chain::get_tolerance() {
    double tolerance[2] = {};
    size_t most[2] = {};
    const bool null = pick_null();
    both("get_tolerance", kReads, [&](cd_chain* chain, int which) {
        return cd_chain_get_tolerance(chain, &tolerance[which], null ? nullptr : &most[which]);
    });
    must_agree("get_tolerance", &tolerance[0], &tolerance[1]);
    must_agree("get_tolerance", &most[0], &most[1]);
}

void Chain::set_air() {
    const double along = chance(0.4) ? 0 : pick_number(-3, 3), across = chance(0.2) ? 0 : pick_number(-3, 3);
    const cd_status status = both(text("set_air %.17g %.17g", along, across), 0,
                                  [&](cd_chain* chain, int) { return cd_chain_set_air(chain, along, across); });
    if (status == CD_OK && !(along < 1e6 && across < 1e6)) past.moderate = false;
    if (status == CD_OK && !is_rope()) problem("set_air: no rope, but it is taken");
}

void Chain::get_air() {
    double air[2][2] = {}, wind[2][4] = {};
    both("get_air", kReads,
         [&](cd_chain* chain, int which) { return cd_chain_get_air(chain, &air[which][0], &air[which][1]); });
    must_agree("get_air", air[0], air[1], 2);
    const size_t count = pick_count(components);
    both("get_wind", kReads, [&](cd_chain* chain, int which) { return cd_chain_get_wind(chain, wind[which], count); });
    must_agree("get_wind", wind[0], wind[1], 4);
}

void Chain::set_wind() {
    double wind[4];
    bool moderate = true;
    for (double& v : wind) {
        v = chance(0.5) ? 0 : pick_number(-1, 1.5);
        moderate &= fabs(v) < 1e3;
    }
    const size_t count = pick_count(components);
    const bool null = pick_null();
    const cd_status status =
        both(text("set_wind %.17g %.17g %.17g, count %zu%s", wind[0], wind[1], wind[2], count, null ? ", null" : ""),
             kNoMemory, [&](cd_chain* chain, int) { return cd_chain_set_wind(chain, null ? nullptr : wind, count); });
    if (status == CD_OK && !moderate) past.moderate = false;
}

void Chain::set_rest_angle() {
    const double most = 3.141592653589793 * (springs > 1 ? double(springs - 1) : 0);
    const double angle = chance(0.2) ? 0 : chance(0.2) ? pick_number(-2, 2) : uniform(-1, 1) * most;
    const cd_status status = both(text("set_rest_angle %.17g", angle), 0,
                                  [&](cd_chain* chain, int) { return cd_chain_set_rest_angle(chain, angle); });
    if (status == CD_OK && !(is_rope() && (components == 2 || angle == 0) && fabs(angle) <= most))
        problem("set_rest_angle: it is taken");
}

void Chain::set_strength() {
    const double strength = chance(0.4) ? double(INFINITY) : pick_number(-2, 5);
    const cd_status status = both(text("set_strength %.17g", strength), 0,
                                  [&](cd_chain* chain, int) { return cd_chain_set_strength(chain, strength); });
    if (status == CD_OK && !is_rope()) problem("set_strength: no rope, but it is taken");
    if (status == CD_OK && strength < HUGE_VAL && all_of(CD_STIFFNESS).empty())
        problem("set_strength: springs may break, but have no stiffness of their own");
}

void Chain::get_reaction() {
    const size_t strand = pick_index(strands), node = pick_index(springs + 1), count = pick_count(components);
    double force[2][4] = {};
    const cd_status status = both("get_reaction", kReads, [&](cd_chain* chain, int which) {
        return cd_chain_get_reaction(chain, strand, node, force[which], count);
    });
    must_agree("get_reaction", force[0], force[1], 4);
    double most = 0;
    for (double t : all_of(CD_TENSION)) most += fabs(t);
    most += stiffest() * 8 * largest_of({CD_POSITION}); // of bend
    for (double f : force[0])
        if (status == CD_OK && past.moderate && !past.crafted && is_finite() && !(fabs(f) <= 1.01 * most))
            problem("get_reaction tells %g, tensions are %g together", f, most);
}

// The twin may be a copy that has not stepped yet: they need not agree.
void Chain::get_convergence() {
    size_t iterations = 0;
    double error = 0;
    const bool only_one = chance(0.1);
    both("get_convergence", kReads, [&](cd_chain* chain, int) {
        return cd_chain_get_convergence(chain, only_one ? nullptr : &iterations, &error);
    });
    if (!(error >= 0) && !past.diverged && !past.crafted && past.moderate)
        problem("get_convergence tells an error of %g", error);
}

} // namespace fuzz
