// Steps 0 and 5: velocities of dry faces, those from the surface that there really is after the step (model.md, 39),
// and, in long steps, the energy that they may have.
//
// Water that a face moves by q loses the energy q fall, fall = -g [(1 - theta) rise before + theta rise after] and what
// pushes it; the sum over the faces is what the potential energy loses, or, with theta > 1/2, less, and what is done to
// the water from outside. So no energy is made where no face keeps more than V u^2 / 2 + q fall (model.md, 41), V the
// water at the face, and what some have too little to lift their water all of the line lose in the same proportion.
// Short steps make little without the bound, and shocks in them run at their right speed.
#pragma once

#include "kernel/water/line.hh"

namespace cd {
namespace CD_ISA {

// A long step is bounded where it is not smooth: some face is not as deep as the mean of its cells or lies at a shore,
// or some depth changes by more than this part of itself.
constexpr double kRoughChange = 0.05;

// Advected momentum has keep_energy(), too: there the bound is for faces beside which a depth changes by more than this
// part of itself, where a line fills or runs dry. At others it would slow bores down.
constexpr double kRoughFace = 0.5;

// What part of its energy a line may gain in a step, as rounding does.
constexpr double kNoGain = 0x1p-40;

// What lifting water over an inner face takes per flux [m^2/s^2], before the step and what its changes of the surface add.
CD_INLINED inline L WaterLine::lift(size_t i) const {
    const L lift = sweep.gravity * full_rise(i, beside(i));
    return acceleration ? lift - acceleration[i] / L::splat(sweep.courant) : lift; // is done from outside
}
CD_INLINED inline L WaterLine::more_lift(size_t i) const {
    const size_t l = left(i);
    L x_l = after[l] - depth[l], x_r = after[i] - depth[i];
    if (pressed()) x_l = x_l + stiff[l] * x_l, x_r = x_r + stiff[i] * x_r;
    return sweep.gravity * (x_r - x_l);
}
CD_INLINED inline L WaterLine::gained(size_t i) const { return flux[i] * -(lift(i) + sweep.theta * more_lift(i)); }

// The water of an inner face in a step, and whose motion has energy before it and after it. Linear water makes energy
// where it deepens: there it is the same.
inline L WaterLine::bounded_depth(size_t i) const {
    const L v0 = beside(i).mean_depth(), v1 = beside_after(i).mean_depth();
    return larger(0.5 * (v0 + v1), larger(v0, v1) - 0.5 * smaller(v0, v1));
}
inline L WaterLine::depth_before(size_t i) const {
    return sweep.advected() ? beside(i).mean_depth() : bounded_depth(i);
}
inline L WaterLine::depth_after(size_t i) const {
    return sweep.advected() ? beside_after(i).mean_depth() : bounded_depth(i);
}

// Which lines are bounded. Where closed ones move more than they have the energy to lift, all their fluxes are smaller
// in the same proportion.
inline void WaterLine::balance() {
    const L none{};
    for (size_t i = 0; i < n; ++i) rough = larger(rough, size_of(after[i] - depth[i]) - kRoughChange * depth[i]);
    bounds = smaller(rough, is_long);
    if (!any_positive(bounds) || !sweep.closed()) return;
    L moving = none, by_start = none, by_change = none; // what fluxes lose: by the surface before, by its change
    for (size_t i = first_face(); i < n; ++i) {
        moving = moving + 0.5 * (depth_before(i) * (velocity[i] * velocity[i]));
        by_start = by_start + flux[i] * lift(i);
        by_change = by_change + flux[i] * more_lift(i);
    }
    const L needs = by_start + sweep.theta * by_change - moving;
    const L lifts = select(bounds, smaller(needs, by_change), none);
    if (!any_positive(lifts)) return;
    const L a = sweep.theta * by_change;
    const L part = (root(positive(by_start * by_start + 4 * (a * moving))) - by_start) / (2 * a);
    const L scale = select(lifts, within(part, 0, 1), L::splat(1));
    for (size_t i = 0; i <= n; ++i) flux.put(i, scale * flux[i]);
    fill_again();
}

// A face's velocity w, with no more energy than it may have.
__attribute__((noinline)) inline L WaterLine::bounded(size_t i, L w) const {
    const L v = bounded_depth(i), u = velocity[i];
    L counts = bounds;
    if (sweep.advected()) {
        const size_t l = left(i);
        const L change_l = size_of(after[l] - depth[l]) - kRoughFace * depth[l];
        counts = smaller(counts, larger(change_l, size_of(after[i] - depth[i]) - kRoughFace * depth[i]));
    }
    const L most = select(v, root(positive(u * u + 2 * (gained(i) / v))), L{});
    return select(counts, larger(-most, smaller(most, w)), w);
}

// Writes velocities of faces, those of dry ones from the faces beside them: see kBeach. `out` may be `u`.
__attribute__((noinline)) inline void WaterLine::follow_water(L moves, Panel depths, Panel u, Panel out) const {
    const L none{};
    struct Seen {
        L open{}, speed{};
    };
    const auto see = [&](size_t i) {
        const L open = beside(i, depths).conducts();
        return Seen{open, select(open, u[i], L{})};
    };
    if (n <= first_face()) return;
    const Seen first = see(first_face());
    Seen before = ring ? see(n - 1) : Seen{}, here = first;
    for (size_t i = first_face(); i < n; ++i) {
        const Seen behind = i + 1 < n ? see(i + 1) : ring ? first : Seen{};
        L follows = u[i];
        if (!all_positive(here.open)) {
            const size_t l = left(i);
            const L is_l = depths[l], b_l = bed[l], b_r = bed[i], step = select(is_l, b_r - b_l, b_l - b_r);
            const L falls = select(is_l, b_l - bed[left(l)], b_r - bed[cells().behind(i)]);
            const L part = select(step, within(falls / (kBeach * step), 0, 1), L::splat(1));
            const L led = part * select(is_l, before.speed, select(depths[i], behind.speed, none));
            follows = select(moves, select(here.open, here.speed, sweep.advected() ? led : none), follows);
        }
        out.put(i, open(i) * follows);
        before = here, here = behind;
    }
    if (ring) out.put(n, out[0]);
}

// In a long step a line, of linear momentum one that is bounded, has no more energy after it than before, and than what
// pushes it and what comes in at its ends bring: what there is too much is taken from all velocities in the same
// proportion, round a ring of water, if it can, from how far they differ from their mean, so that momentum is kept. Faces
// that follow the water do so at once: lines across may fill the cells beside them, and then they have their velocity.
inline void WaterLine::keep_energy() {
    const L none{}, one = L::splat(1);
    L least = one;
    for (size_t i = 0; i < n; ++i) {
        after.put(i, settled(after[i], kDry)); // as the next part begins
        least = smaller(least, after[i]);
    }
    const bool dry = !all_positive(least);
    if (dry) follow_water(is_long, after, speed, speed);
    L mass = none, momentum = none, gap = none;
    L moving = none, most = none; // twice the energy, at first of what comes in at the ends
    if (!ring) most = positive(flux[0]) * (speed[0] * speed[0]) + positive(-flux[n]) * (speed[n] * speed[n]);
    for (size_t i = first_face(); i < n; ++i) {
        const L v = depth_after(i), u = speed[i], before = velocity[i], p = v * u;
        most = most + (depth_before(i) * (before * before) + 2 * gained(i));
        moving = moving + p * u;
        mass = mass + v;
        momentum = momentum + p;
        gap = larger(gap, select(size_of(u), none, one));
    }
    const L excess = moving - most, over = smaller(excess - kNoGain * moving, sweep.advected() ? is_long : bounds);
    if (!any_positive(over)) return;
    L mean = ring ? select(gap, none, momentum / mass) : none;
    mean = select((moving - mean * momentum) - excess, mean, none);
    const L differ = moving - mean * momentum,
            keep = select(smaller(over, differ), root(positive(differ - excess) / differ), one);
    for (size_t i = first_face(); i < n; ++i) speed.put(i, select(over, mean + keep * (speed[i] - mean), speed[i]));
}

// Of linear momentum.
inline void WaterLine::set_velocities() {
    const bool any_bounded = any_positive(bounds), any_limited = any_positive(limits);
    const WaterLine here = *this;
    for (size_t i = first_face(); i < n; ++i) {
        const Beside c = here.beside_after(i);
        const bool wet = all_positive(smaller(c.l.depth, c.r.depth));
        L w = here.speed[i] - here.late_push(i) * (wet ? here.full_rise(i, c) : here.pushing_rise(i, c));
        if (any_bounded) w = here.bounded(i, w);
        if (any_limited) w = select(limits, here.pull[i] * w, w);
        here.speed.put(i, wet ? w : select(c.conducts(), w, L{}));
    }
    if (any_bounded) keep_energy();
}

// What crosses a side runs as fast as its discharge in its depth, but no faster than it came or than its waves: more
// may cross a film than there is of it. What comes in in a given depth has its speed from that.
inline void WaterLine::end_velocities() {
    for (int e = 0; e < 2; ++e) {
        const size_t face = e ? n : 0, inside = e ? n - 1 : 0;
        const bool is_given = sweep.end[e].depth > 0;
        L d = side_depth[e], most = L::splat(__builtin_inf());
        if (!is_given) {
            d = larger(d, 0.5 * (depth[inside] + after[inside]));
            most = larger(size_of(velocity[e ? n - 1 : 1]), root(sweep.gravity * d));
        }
        const L run = courant * d; // 0 also of depths that have no digits left
        const L u = select(run, flux[face] / run, L{});
        speed.put(face, sweep.end[e].kind == End::kWall ? L{} : larger(-most, smaller(most, u)));
    }
}

} // namespace CD_ISA
} // namespace cd
