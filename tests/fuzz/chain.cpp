#include "chain.hpp"

#include <math.h>
#include "random.hpp"

namespace fuzz {

Chain::Chain() {
    strands = chance(0.5) ? 1 : 1 + below(20);
    springs = chance(0.25) ? below(4) : chance(0.5) ? below(40) : below(200);
    components = 1 + below(4);
    likes_lengths = chance(0.6);
    likes_things = likes_lengths && chance(0.5);
    nodes = strands * (springs + 1);
    precision = cd_precision(below(2));
    trace(text("chain_create %zu strands, %zu springs, %zu components, precision %d", strands, springs, components,
               int(precision)));
    create();
}

cd_status Chain::make(const cd_allocator* allocator, cd_chain** out) {
    return cd_chain_create(strands, springs, components, precision, allocator, out);
}

size_t Chain::springs_now() const {
    int32_t ring = 0;
    cd_chain_get_ring(first(), &ring);
    return springs + size_t(ring);
}

bool Chain::extent(cd_field field, Extent& out) const {
    switch (field) {
    case CD_POSITION:
    case CD_VELOCITY:
    case CD_FORCE:
    case CD_TARGET: out = {strands, springs + 1, components}; return true;
    case CD_WIND: out = {strands, springs + 1, components}; return is_rope();
    case CD_BEND:
    case CD_MASS:
    case CD_PIN: out = {own_strands(), springs + 1, 1}; return true;
    case CD_STIFFNESS: out = {own_strands(), springs_now(), 1}; return true;
    case CD_REST_LENGTH: out = {strands, springs_now(), 1}; return is_rope();
    case CD_TENSION:
    case CD_STRENGTH:
    case CD_STRAIN: out = {strands, springs_now(), 1}; return is_rope();
    case CD_REST_ANGLE: out = {strands, springs + 1, 1}; return is_rope() && components == 2;
    default: return false;
    }
}

cd_status Chain::view(cd_chain* handle, cd_field field, View& out) const {
    return cd_chain_view(handle, field, &out.data, &out.outer_stride, &out.inner_stride, &out.component_stride);
}

// ---- what must hold ------------------------------------------------------------------------------------------------

// Pinned nodes rest, welded ones move alike, no group of welded nodes is held twice, and time is finite.
void Chain::check_state() {
    double time = 0;
    cd_chain_get_time(first(), &time);
    if (!isfinite(time)) return problem("chain: time %g", time);
    if (run.broken || !is_finite()) return;
    const Doubles pin = all_of(CD_PIN), v = all_of(CD_VELOCITY), k = is_rope() ? Doubles() : all_of(CD_STIFFNESS);
    const size_t n = springs + 1;
    const auto velocity = [&](size_t strand, size_t node) { return &v[(strand * n + node) * components]; };
    const auto is_held = [&](size_t node) { return pin[node] != CD_NODE_FREE && pin[node] != CD_NODE_MATCHED; };
    for (size_t strand = 0; strand < strands; ++strand)
        for (size_t i = 0; i < n; ++i) {
            const double* const here = velocity(strand, i);
            const double kind = pin[own_strands() > 1 ? strand * n + i : i];
            for (size_t c = 0; c < components && kind == CD_NODE_PINNED; ++c)
                if (here[c] != 0) return problem("chain: pinned node %zu of strand %zu moves", i, strand);
            if (i >= k.size() || !isinf(k[i])) continue;
            const double* const next = velocity(strand, (i + 1) % n);
            for (size_t c = 0; c < components; ++c)
                if (here[c] != next[c])
                    return problem("chain: spring %zu of strand %zu is welded, but its nodes move at %g and %g", i,
                                   strand, here[c], next[c]);
        }
    std::vector<size_t> group(n), held(n); // a group has the number of its first node
    for (size_t i = 1; i < n; ++i) group[i] = i <= k.size() && isinf(k[i - 1]) ? group[i - 1] : i;
    if (k.size() == n && isinf(k[n - 1])) { // across the end of a ring
        const size_t last = group[n - 1];
        for (size_t& g : group) g = g == last ? group[0] : g;
    }
    for (size_t i = 0; i < n; ++i)
        if (is_held(i) && ++held[group[i]] > 1) return problem("chain: the welded group of node %zu is held twice", i);
}

double Chain::energy() const {
    double kinetic = 0, elastic = 0, gravity = 0;
    cd_chain_get_energy(first(), &kinetic, &elastic, &gravity);
    return kinetic + elastic + gravity;
}

double Chain::stiffest() const {
    double stretch = 0;
    cd_chain_get_stiffness(first(), &stretch);
    stretch = isinf(stretch) ? 0 : stretch * double(springs + 1);
    for (double k : all_of(CD_STIFFNESS)) stretch = isinf(k) ? stretch : fmax(stretch, k);
    return stretch + stiffest_joint() + stiffest_tie();
}

double Chain::stiffest_joint() const {
    const double count = double(springs + 1);
    double bend = 0;
    cd_chain_get_bend(first(), &bend);
    bend *= count * count * count;
    for (double b : all_of(CD_BEND)) bend = fmax(bend, b);
    return 16 * bend; // which is what a zigzag of 1 pushes back by
}

double Chain::stiffest_tie() const {
    double tie = 0;
    for (size_t strand = 0; strand < own_strands(); ++strand)
        for (size_t i = 0; i <= springs; ++i) {
            double stiffness = 0, damping;
            if (cd_chain_get_attachment(first(), strand, i, &stiffness, &damping) == CD_OK) tie = fmax(tie, stiffness);
        }
    return tie;
}

bool Chain::falls_astray() const {
    double bend = 0;
    cd_chain_get_bend(first(), &bend);
    return is_ring() || bend > 0 || !all_of(CD_BEND).empty();
}

double Chain::heaviest() const {
    double mass = 0;
    cd_chain_get_mass(first(), &mass);
    for (double m : all_of(CD_MASS)) mass = fmax(mass, m);
    return mass;
}

double Chain::gravity() const {
    double gravity[4] = {}, most = 0;
    cd_chain_get_gravity(first(), gravity, components);
    for (double g : gravity) most = fmax(most, fabs(g));
    return most;
}

bool Chain::is_driven() const {
    for (double force : all_of(CD_FORCE))
        if (force != 0) return true;
    for (double pin : all_of(CD_PIN))
        if (pin == CD_NODE_DRIVEN || pin == CD_NODE_POSED) return true;
    double wind[4] = {};
    cd_chain_get_wind(first(), wind, components);
    for (double v : wind)
        if (v != 0) return true;
    for (double v : all_of(CD_WIND))
        if (v != 0) return true;
    for (const Thing& thing : things())
        if (moves(thing)) return true;
    return began_inside;
}

// ---- calls ---------------------------------------------------------------------------------------------------------

void Chain::act_by_kind() {
    switch (below(is_rope() || likes_lengths ? 54 : 25)) {
    case 0: set_number("set_mass", cd_chain_set_mass, pick_number(-2, 3), {1e-3, 1e4}); break;
    case 1: set_stiffness(); break;
    case 2: set_number("set_bend", cd_chain_set_bend, chance(0.3) ? 0 : pick_number(-6, 1), {0, 1e2}, 0); break;
    case 3:
        set_number("set_stiffness_damping", cd_chain_set_stiffness_damping, chance(0.3) ? 0 : pick_number(-4, 0),
                   {0, 1e2});
        break;
    case 4: set_gravity(cd_chain_set_gravity); break;
    case 5: set_end(); break;
    case 6: set_enum("set_ring", cd_chain_set_ring, 1); break;
    case 7: set_enum("set_mass_rule", cd_chain_set_mass_rule, 1, kNoMemory); break;
    case 8:
    case 9: impulse(); break;
    case 10:
    case 11: attach(); break;
    case 12: detach(); break;
    case 13: get_attachment(); break;
    case 14:
    case 15:
    case 16: cut_or_weld(); break;
    case 17: get_energy(cd_chain_get_energy); break;
    case 18: get_momentum(cd_chain_get_momentum); break;
    case 19: sample(); break;
    case 20: get_shape(); break;
    case 21: get_end(); break;
    case 22: get_parameter(); break;
    case 23: teleport(); break;
    case 24: chance(0.5) ? set_sleep(cd_chain_set_sleep) : get_sleep(cd_chain_get_sleep); break;
    case 25:
    case 26:
    case 27: set_rest_length(); break;
    case 28: set_enum("set_push", cd_chain_set_push, 1, kNoMemory); break;
    case 29:
    case 30: set_tolerance(); break;
    case 31: get_tolerance(); break;
    case 32: set_air(); break;
    case 33: set_wind(); break;
    case 34: get_air(); break;
    case 35: set_strength(); break;
    case 53: set_rest_angle(); break;
    case 36: get_reaction(); break;
    case 37: set_colliders(); break;
    case 38:
    case 39: set_plane(); break;
    case 40:
    case 41:
    case 42: set_capsule(); break;
    case 43: remove_collider(); break;
    case 44: set_collider_velocity(); break;
    case 45: chance(0.5) ? set_thickness() : set_loads(); break;
    case 46: chance(0.5) ? get_collider() : get_collider_load(); break;
    case 47:
    case 48: set_bed(); break;
    case 49: get_bed(); break;
    case 50:
    case 51: set_callback(); break;
    default: get_convergence();
    }
}

void Chain::set_stiffness() {
    const bool rigid = chance(is_rope() ? 0.25 : 0.03); // of ropes as moderate a stiffness as any
    const double stiffness = rigid ? double(INFINITY) : chance(0.1) ? 0 : pick_number(-2, 6);
    set_number("set_stiffness", cd_chain_set_stiffness, stiffness, {0, rigid ? double(INFINITY) : 1e7});
}

void Chain::set_end() {
    const cd_end end = pick_enum(CD_END_LAST);
    const cd_node kind = pick_enum(CD_NODE_POSED);
    both(text("set_end %d %d", int(end), int(kind)), kind == CD_NODE_POSED ? 0u : unsigned(kNoMemory),
         [&](cd_chain* chain, int) { return cd_chain_set_end(chain, end, kind); });
}

void Chain::get_end() {
    const cd_end end = pick_enum(CD_END_LAST);
    cd_node kinds[2] = {};
    both("get_end", kReads, [&](cd_chain* chain, int which) { return cd_chain_get_end(chain, end, &kinds[which]); });
    must_agree("get_end", &kinds[0], &kinds[1]);
}

void Chain::impulse() {
    const Impulse push = pick_impulse();
    const size_t strand = pick_index(strands), node = pick_index(springs + 1);
    const cd_status status =
        both(text("impulse %zu %zu, %.17g.., count %zu", strand, node, push.size[0], push.count), kNoMemory,
             [&](cd_chain* chain, int) { return cd_chain_impulse(chain, strand, node, push.size, push.count); });
    if (status == CD_OK && !run.sane) past.moderate = false;
}

void Chain::teleport() {
    const size_t strand = pick_index(strands);
    const Move move = pick_move();
    const cd_status status = both(
        text("teleport %zu, by %.17g.., count %zu", strand, move.offset[0], move.count), kNoMemory,
        [&](cd_chain* chain, int) { return cd_chain_teleport(chain, strand, move.turn(), move.offset, move.count); });
    if (status == CD_OK && !(move.moderate && run.sane)) past.moderate = false;
}

void Chain::attach() {
    const Tie tie = pick_tie();
    const size_t strand = pick_index(own_strands()), node = pick_index(springs + 1);
    const cd_status status =
        both(text("attach %zu %zu, %.17g, %.17g%s", strand, node, tie.stiffness, tie.damping, tie.null ? ", null" : ""),
             0, [&](cd_chain* chain, int) {
                 return cd_chain_attach(chain, strand, node, tie.stiffness, tie.damping, tie.at(), tie.count);
             });
    has_tied(tie, status);
}

void Chain::detach() {
    const size_t strand = pick_index(own_strands()), node = pick_index(springs + 1);
    both(text("detach %zu %zu", strand, node), 0,
         [&](cd_chain* chain, int) { return cd_chain_detach(chain, strand, node); });
}

void Chain::get_attachment() {
    const size_t strand = pick_index(own_strands()), node = pick_index(springs + 1);
    double out[2][2] = {};
    both("get_attachment", kReads, [&](cd_chain* chain, int which) {
        return cd_chain_get_attachment(chain, strand, node, &out[which][0], &out[which][1]);
    });
    must_agree("get_attachment", out[0], out[1], 2);
}

void Chain::cut_or_weld() {
    const size_t strand = pick_index(own_strands()), spring = pick_index(springs_now());
    const bool cut = chance(0.4);
    both(text("%s %zu %zu", cut ? "cut" : "weld", strand, spring), 0, [&](cd_chain* chain, int) {
        return cut ? cd_chain_cut(chain, strand, spring) : cd_chain_weld(chain, strand, spring);
    });
}

void Chain::sample() {
    const size_t n = below(9), strand = pick_index(strands), count = pick_count(n * components);
    const cd_outside outside = pick_enum(CD_OUTSIDE_NEAREST);
    Doubles at(n), out[2] = {Doubles(n * components + 1, 7), Doubles(n * components + 1, 7)};
    for (double& place : at) place = pick_between(0, double(springs_now()));
    const cd_status status = both(text("sample %zu, count %zu", n, count), kReads, [&](cd_chain* chain, int which) {
        return cd_chain_sample(chain, strand, at.data(), n, outside, out[which].data(), count);
    });
    if (out[0][n * components] != 7) problem("sample wrote past its end");
    if (status == CD_OK) must_agree("sample", out[0].data(), out[1].data(), n * components);
}

void Chain::get_shape() {
    size_t out[3] = {strands, springs, components};
    cd_precision stored = precision;
    const bool some = chance(0.5);
    const cd_status status = both("get_shape", kReads, [&](cd_chain* chain, int) {
        return cd_chain_get_shape(chain, &out[0], some ? nullptr : &out[1], &out[2], some ? nullptr : &stored);
    });
    if (status != CD_OK || out[0] != strands || out[1] != springs || out[2] != components || stored != precision)
        problem("get_shape tells another shape");
}

void Chain::get_parameter() {
    switch (below(15)) {
    case 14: get("get_loads", cd_chain_get_loads); break;
    case 13: get("get_rest_angle", cd_chain_get_rest_angle); break;
    case 12: get("get_awake", cd_chain_get_awake); break;
    case 9: get("get_strength", cd_chain_get_strength); break;
    case 10: get("get_colliders", cd_chain_get_colliders); break;
    case 11: get("get_thickness", cd_chain_get_thickness); break;
    case 0: get("get_mass", cd_chain_get_mass); break;
    case 1: get("get_mass_rule", cd_chain_get_mass_rule); break;
    case 2: get("get_stiffness", cd_chain_get_stiffness); break;
    case 3: get("get_bend", cd_chain_get_bend); break;
    case 4: get("get_stiffness_damping", cd_chain_get_stiffness_damping); break;
    case 5: get("get_ring", cd_chain_get_ring); break;
    case 6: get("get_rest_length", cd_chain_get_rest_length); break;
    case 7: get("get_push", cd_chain_get_push); break;
    default: get_gravity(cd_chain_get_gravity);
    }
}

} // namespace fuzz
