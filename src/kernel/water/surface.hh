// Steps 1 to 3 of a line: what faces are, and the fluxes of all of them at once (model.md, 34 to 37). With x the
// changes of depth,
//
//      q = flux + left x_l - right x_r,     x = q before a cell - q behind it,
//
// the fluxes of a line solve (1 + left + right) q - left q_{i-1} - right q_{i+1} = flux. The surface's rise takes
// S (x_r - x_l) off a flux, S = g (theta c)^2 D push, and a stream carries with it the change of depth of what it runs
// through: k (x_l + x_r) / 2 where the face is as deep as the mean of its cells, else k times the giver's change, with
// k = theta c u; of a stream that outruns the surface's answer as much is the giver's as keeps `left` and `right` from
// being negative. A row's sum is then 1, and the elimination makes 1 - pull without a subtraction: the fluxes are exact
// however stiff the surface is (the series-spring elimination of solve/spring_line.hh).
//
// On a uniform stream over a flat bed a step with theta = 1/2 keeps the energy of small waves whatever dt is, and with
// more it loses some.
#pragma once

#include "kernel/water/momentum.hh"

namespace cd {
namespace CD_ISA {

// stream: what the stream adds to the velocity in the step times the face's depth, see momentum.hh.
CD_INLINED inline Face WaterLine::inner_face(size_t i, L stream) {
    const Beside c = beside(i);
    const L none{}, one = L::splat(1), u = velocity[i], gc = sweep.gravity * courant, mean = c.mean_depth();

    // Where the cells are wet, and less uneven than they are deep, all that follows is what it is in deep water.
    const L shallower = smaller(c.l.depth, c.r.depth);
    const bool deep = all_positive(shallower - (size_of(c.r.depth - c.l.depth) + size_of(c.r.bed - c.l.bed)));

    // 1. push
    const L force = acceleration ? share * acceleration[i] : none;
    L rise = gc * (deep ? full_rise(i, c) : pushing_rise(i, c)), kept = u + force;
    L part = one; // that friction leaves of what changes a velocity
    L theta = L::splat(sweep.theta), rest = L::splat(1 - sweep.theta), answer = full_push;
    if (sweep.rubs()) {
        const L gains = select(size_of(stream), stream / mean, none), speed = size_of((kept - rise) + gains);
        L z = sweep.drag * (sweep.dt * share);
        if (sweep.manning > 0)
            z = z + manning_drag(mean, speed, size_of(0.5 * (across[left(i)] + across[i])),
                                 sweep.manning * (sweep.dt * share));
        // It takes z of velocities by the trapezoidal rule, and from z = 2 on, where that would turn them round, all;
        // of what the stream brings as much. What is at rest between push and friction stays so at any z.
        const L middle = one + 0.5 * z, keep = positive(one - 0.5 * z) / middle;
        part = one / larger(middle, z);
        kept = keep * u + part * force;
        rise = part * rise;
        theta = theta_of(part), rest = one - theta;
        answer = theta * (gc * part), stream = part * stream;
    }
    const L w = kept - rise;

    // 2. depth
    const L run = theta * courant, mid = theta * w + rest * u;
    const L cells = smaller(larger(courant * u, -one), one); // no more than a cell's change
    L face_depth = mean, k = theta * cells, half = 0.5 * k;
    if (!deep && any_positive(larger(size_of(u), mean))) { // else all is dry and at rest
        const L head = (0.5 / (sweep.gravity + 0x1p-1000)) * (mid * mid);
        const FaceDepth face(c, mid, any_long ? &is_long : nullptr, run, run * gc, head);
        const L uneven = size_of(face.depth - mean);
        face_depth = face.depth;
        k = select(face.closed, none, k);
        half = select(uneven, none, 0.5 * k);
        stream = select(uneven, none, stream);
        if (any_long) rough = larger(rough, open(i) * select(shallower, uneven, mean)); // mean: at a shore
    }

    // 3. what the flux answers to
    const L s = sweep.implicit ? run * (answer * face_depth) : none;
    const L of_right = !sweep.implicit ? select(k, half, k - half) : select(k, smaller(half, s), k - larger(half, -s));
    L through = face_depth * mid;
    if (sweep.advected()) through = through + theta * stream;
    const L of_left = k - of_right;
    L s_left = s, s_right = s;
    if (pressed()) s_left = s + s * stiff[left(i)], s_right = s + s * stiff[i]; // a hull's head answers too
    const auto let = [&](L a) { return opening ? opening[i] * a : a; };
    speed.put(i, let(kept - rest * rise));
    if (push) push.put(i, let(part));
    return {let(courant * through), let(of_left + s_left), let(s_right - of_right)};
}

// The depth in which the discharge at an end comes in beside a cell of that depth.
__attribute__((noinline)) inline L WaterLine::inflow_depth(const WaterEnd& end, L cell) const {
    if (end.depth > 0) return L::splat(end.depth);
    return larger(cell, L::splat(critical_depth(end.discharge, sweep.gravity)));
}

// A face at a side of the scene.
__attribute__((noinline)) inline Face WaterLine::end_face(int e) {
    const L none{};
    const WaterEnd& end = sweep.end[e];
    if (end.kind == End::kWall) return {none, none, none};
    const size_t face = e ? n : 0, inside = e ? n - 1 : 0, next = e ? n - 1 : 1; // next: face
    const double outward = e ? 1 : -1;
    if (end.kind == End::kInflow) {
        side_depth[e] = inflow_depth(end, depth[inside]);
        return {open(face) * (courant * L::splat(-outward * end.discharge)), none, none};
    }
    const bool is_shared = n == 1 && sweep.end[1 - e].kind != End::kWall; // the cell has one half on each side
    const SideWaves waves{sweep.gravity, sweep.advected()};
    double d[kLines], b[kLines], u[kLines], q[kLines], crossed[kLines], run[kLines];
    double discharge[kLines], slope[kLines], half_cell[kLines];
    depth[inside].store(d), bed[inside].store(b), (outward * velocity[next]).store(u);
    (outward * velocity[face]).store(crossed), courant.store(run);
    ((0.5 * outward) * (velocity[next] * (depth[left(next)] + depth[right(next)]))).store(q);
    for (int k = 0; k < kLines; ++k) {
        const SideCell cell{d[k], u[k], q[k], crossed[k]};
        const double outside = end.level > b[k] ? end.level - b[k] : 0;
        const SideFlow flow = end.kind == End::kOpen ? waves.open(cell, outside)
                                                     : waves.level(cell, outside, end.rise / sweep.courant,
                                                                   waves.follows(outside, run[k], sweep.theta));
        discharge[k] = outward * flow.discharge, slope[k] = flow.slope, d[k] = flow.depth;
        half_cell[k] = is_shared ? 0 : flow.half_cell;
    }
    const L answer = open(face) * (sweep.theta * (courant * L::load(slope)) - L::load(half_cell));
    side_depth[e] = L::load(d);
    const L flow = courant * L::load(discharge) + outward * (share * (end.rise * L::load(half_cell)));
    Face out{open(face) * flow, none, none};
    (e ? out.left : out.right) = answer;
    return out;
}

inline void WaterLine::solve_surface() {
    WaterLine here = *this;
    const L one = L::splat(1), none{};
    StreamAcceleration streams(here);
    if (!ring) side[0] = end_face(0), side[1] = end_face(1);
    // Of the row before: its answer, 1 - pull, and in a ring how it follows face 0 and what is left of 1.
    L y = none, rest = one, follow = one, whole = none;
    for (size_t i = 0; i < here.faces().count; ++i) {
        Face f;
        if (!here.ring && (i == 0 || i == here.n)) f = side[i > 0 ? 1 : 0];
        else f = here.inner_face(i, here.sweep.advected() ? streams.next(i) : none);
        if (here.ring && i == 0) { // stands back
            side[0] = f;
            continue;
        }
        const L own = one + f.left * rest, inverse = one / (own + f.right);
        y = (f.flux + f.left * y) * inverse;
        rest = own * inverse;
        here.flux.put(i, y);
        here.pull.put(i, f.right * inverse);
        if (!here.ring) continue;
        follow = (f.left * follow) * inverse;
        whole = (one + f.left * whole) * inverse;
        here.spare[0].put(i, follow);
        here.spare[1].put(i, whole);
    }
    rough = here.rough;
    if (ring) close_ring();
}

// Face 0 stands back; the others answer its flux and their own.
inline void WaterLine::close_ring() {
    const L one = L::splat(1), none{};
    const Face& first = side[0];
    L own = none, follow = one, left_out = none; // flux, its share of face 0's flux, and what is missing of 1 there
    L last_own = none, last_out = none;
    for (size_t i = n; i-- > 1;) {
        const L p = pull[i];
        own = flux[i] + p * own, follow = spare[0][i] + p * follow, left_out = spare[1][i] + p * left_out;
        flux.put(i, own);
        spare[0].put(i, follow);
        if (i + 1 == n) last_own = own, last_out = left_out;
    }
    // of a ring of one cell all that runs round comes in as it goes out
    const L around = n == 1 ? none
                            : (first.flux + first.left * last_own + first.right * own) /
                                  (one + first.left * last_out + first.right * left_out);
    for (size_t i = 1; i < n; ++i) flux.put(i, flux[i] + spare[0][i] * around);
    flux.put(0, around);
    flux.put(n, around);
}

// Ends the elimination and fills the cells; returns the least depth of each line.
inline L WaterLine::fill() {
    L q = flux[n], least = L::splat(1);
    for (size_t i = n; i-- > 0;) {
        const L before = ring ? flux[i] : flux[i] + pull[i] * q, d = depth[i] + (before - q);
        flux.put(i, before);
        after.put(i, d);
        least = smaller(least, d);
        q = before;
    }
    return least;
}

} // namespace CD_ISA
} // namespace cd
