// Steps 0 and 5: velocities of dry faces, those from the surface that there really is after the step (model.md, 39),
// and, in long steps, the energy that they may have.
//
// Water that a face moves by q loses the energy q fall, fall = -g [(1 - theta) rise before + theta rise after] and what
// pushes it; the sum over the faces is what the potential energy loses, or, with theta > 1/2, less, and what is done to
// the water from outside. So no energy is made where no face keeps more than V u^2 / 2 + q fall (model.md, 41), V the
// water at the face. Faces that have less than it takes to lift their water take what is missing from what the others
// of the line gain, all of them in the same proportion. Short steps make none without the bound, and shocks in them run
// at their right speed.
#pragma once

#include "kernel/water/line.hh"

namespace cd {
namespace CD_ISA {

// A long step is bounded where it is not smooth: some face is not as deep as the mean of its cells or lies at a shore,
// or some depth changes by more than this part of itself.
constexpr double kRoughChange = 0.05;

// What lifting water over a face takes before the step, per flux [m^2/s^2], but for what pushes it from outside.
template <int N> Lanes<N> WaterLine<N>::lift(size_t i) const {
    const L rise = sweep.gravity * full_rise_at(i, cell(left(i)), cell(i));
    return acceleration ? rise - acceleration[i] / L::splat(sweep.courant) : rise;
}

// What the step's changes of the surface add to that.
template <int N> Lanes<N> WaterLine<N>::more_lift(size_t i) const {
    const size_t l = left(i);
    L x_l = after[l] - depth[l], x_r = after[i] - depth[i];
    if (pressed()) x_l = x_l + stiff[l] * x_l, x_r = x_r + stiff[i] * x_r;
    return sweep.gravity * (x_r - x_l);
}

template <int N> Lanes<N> WaterLine<N>::fall(size_t i) const { return -(lift(i) + sweep.theta * more_lift(i)); }

// The water at a face, when its energy counts.
template <int N> Lanes<N> WaterLine<N>::moving_depth(size_t i) const {
    const L v0 = mean_depth(cell(left(i)), cell(i)), v1 = mean_depth(cell_after(left(i)), cell_after(i));
    return larger(0.5 * (v0 + v1), larger(v0, v1) - 0.5 * smaller(v0, v1));
}

// What share of what its faces gain a line needs to lift its water; lines that the bound counts for.
template <int N> void WaterLine<N>::balance(const StepKind<N>& kind) {
    const L one = L::splat(1), none{};
    for (size_t i = 0; i < n; ++i) rough = larger(rough, size_of(after[i] - depth[i]) - kRoughChange * depth[i]);
    bounds = smaller(rough, kind.is_long);
    if (!any_positive(bounds)) return;
    // The energy of motion, and what fluxes lose: by the surface before, by its change. Where closed lines move more
    // than they have the energy to lift, all their fluxes are smaller in the same proportion.
    L moving = none, by_start = none, by_change = none;
    for (size_t i = first_face(); i < n; ++i) {
        const L u = velocity[i], q = flux[i];
        moving = moving + 0.5 * (moving_depth(i) * (u * u));
        by_start = by_start + q * lift(i);
        by_change = by_change + q * more_lift(i);
    }
    const L needs = by_start + sweep.theta * by_change - moving;
    const L lifts = sweep.closed() ? select(bounds, smaller(needs, by_change), none) : none;
    if (any_positive(lifts)) {
        const L a = sweep.theta * by_change;
        const L part = (root(positive(by_start * by_start + 4 * (a * moving))) - by_start) / (2 * a);
        const L scale = select(lifts, within(part, 0, 1), one);
        for (size_t i = 0; i <= n; ++i) flux.put(i, scale * flux[i]);
        for (size_t i = 0; i < n; ++i)
            after.put(i, select(lifts, larger(none, depth[i] + (flux[i] - flux[i + 1])), after[i]));
    }
    L lack = none, gain = none, rest = none;
    for (size_t i = first_face(); i < n; ++i) {
        const L u = velocity[i], gained = flux[i] * fall(i), x = 0.5 * (moving_depth(i) * (u * u)) + gained;
        lack = lack + positive(-x);
        gain = gain + positive(gained);
        rest = rest + (positive(x) - smaller(positive(x), positive(gained)));
    }
    lack = (1 / kGives) * lack; // where all energy is used up, rounding leaves none: its root would not be small
    taken = select(gain, smaller(one, lack / gain), none);
    keeps = select(rest, positive(one - positive(lack - gain) / rest), one);
}

// A face's velocity w, with no more energy than it may have.
template <int N> Lanes<N> WaterLine<N>::bounded(size_t i, L w) const {
    const L none{}, u = velocity[i], gained = flux[i] * fall(i), v = moving_depth(i);
    const L x = 0.5 * (v * (u * u)) + (gained - taken * positive(gained));
    const L most = select(v, root(positive((2 * keeps) * (x / v))), none);
    return select(bounds, larger(-most, smaller(most, w)), w);
}

// Faces that water cannot cross take the velocity of an open face beside them, for what comes to them in the step; of
// linear momentum they rest.
template <int N> void WaterLine<N>::follow_water(L moves) {
    const L none{};
    const auto is_open = [&](size_t i) { return conducts(cell(left(i)), cell(i)); };
    const size_t first = first_face();
    if (n <= first) return;
    L before = ring ? is_open(n - 1) : none, speed_before = ring ? velocity[n - 1] : none, here = is_open(first);
    const L first_open = here, first_speed = velocity[first];
    for (size_t i = first; i < n; ++i) {
        const bool at_end = i + 1 == n;
        const L u = velocity[i], behind = !at_end ? is_open(i + 1) : ring ? first_open : none;
        const L speed_behind = !at_end ? velocity[i + 1] : ring ? first_speed : none;
        const L both = 0.5 * (speed_before + speed_behind);
        const L near = select(before, select(behind, both, speed_before), select(behind, speed_behind, none));
        velocity.put(i, select(select(here, none, moves), sweep.advected() ? near : none, u));
        before = here, speed_before = u, here = behind;
    }
    if (ring) velocity.put(n, velocity[0]);
}

// Of linear momentum.
template <int N> void WaterLine<N>::set_velocities(StepKind<N> kind) {
    const L none{};
    const bool any_bounded = any_positive(bounds), any_limited = any_positive(limits);
    const WaterLine<N> here = *this;
    for (size_t i = first_face(); i < n; ++i) {
        const Cell l = here.cell_after(here.left(i)), r = here.cell_after(i);
        const bool wet = all_positive(smaller(l.depth, r.depth));
        const L rise = wet ? here.full_rise_at(i, l, r) : here.rise_at(i, l, r);
        L w = here.speed[i] - here.push_of(i, kind) * rise;
        if (any_bounded) w = here.bounded(i, w);
        if (any_limited) w = select(limits, here.pull[i] * w, w);
        here.speed.put(i, wet ? w : select(conducts(l, r), w, none));
    }
    if (ring) speed.put(n, speed[0]);
}

// What crosses a side runs as fast as its discharge in its depth, but no faster than it came or than its waves: more
// may cross a film than there is of it.
template <int N> void WaterLine<N>::end_velocities(const StepKind<N>& kind) {
    if (ring) return;
    for (int e = 0; e < 2; ++e) {
        const size_t face = e ? n : 0, inside = e ? n - 1 : 0;
        const L d = larger(side_depth[e], 0.5 * (depth[inside] + after[inside]));
        const L most = larger(size_of(velocity[e ? n - 1 : 1]), root(sweep.gravity * d));
        const L run = kind.courant * d; // 0 also of depths that have no digits left
        const L u = select(run, flux[face] / run, L{});
        speed.put(face, sweep.end[e].kind == End::kWall ? L{} : larger(-most, smaller(most, u)));
    }
}

} // namespace CD_ISA
} // namespace cd
