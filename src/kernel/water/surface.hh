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

#include "kernel/water/stream.hh"

namespace cd {
namespace CD_ISA {

// stream: what the stream adds to the velocity in the step times the face's depth, see stream.hh.
template <int N> __attribute__((always_inline)) inline FaceLanes<N> WaterLine<N>::inner_face(size_t i,
                                                                                             const StepKind<N>& kind,
                                                                                             L stream) {
    const double theta = sweep.theta;
    const Cell l = cell(left(i)), r = cell(i);
    const L none{}, u = velocity[i], gc = gravity_run(kind), mean = mean_depth(l, r);

    // Where the cells are wet, and less uneven than they are deep, all that follows is what it is in deep water.
    const L deeper = smaller(l.depth, r.depth) - (size_of(r.depth - l.depth) + size_of(r.bed - l.bed));
    const bool deep = all_positive(deeper);

    // 1. push
    const L force = acceleration ? kind.share * acceleration[i] : none;
    L rise = gc * (deep ? full_rise_at(i, l, r) : rise_at(i, l, r)), kept = u + force,
      answer = theta * gc; // of a rise after the step
    if (sweep.rubs()) {
        L z = sweep.drag * (sweep.dt * kind.share);
        if (sweep.manning > 0)
            z = z + manning_drag(mean, size_of(kept - rise), sweep.manning * (sweep.dt * kind.share));
        const FrictionLanes<N> friction(z);
        kept = friction.keep * u + friction.push * force;
        rise = friction.push * rise;
        answer = friction.push * answer;
    }
    const L w = kept - rise;

    // 2. depth
    const L run = theta * kind.courant, speed = theta * w + (1 - theta) * u;
    const L cells = smaller(larger(kind.courant * u, L::splat(-1)), L::splat(1)); // no more than a cell's change
    L depth = mean, k = theta * cells, half = 0.5 * k, advected = theta * stream;
    if (!deep) {
        const L along = select(size_of(speed), speed, w), head = (0.5 / (sweep.gravity + 0x1p-1000)) * (along * along);
        const FaceDepth<N> face(l, r, along, kind.any_long ? &kind.is_long : nullptr, run, run * gc, head);
        const L uneven = size_of(face.depth - mean);
        depth = face.depth;
        k = select(face.closed, none, k);
        half = select(uneven, none, 0.5 * k);
        advected = select(uneven, none, advected);
        rough = larger(rough, open(i) * select(smaller(l.depth, r.depth), uneven, mean)); // mean: at a shore
    }

    // 3. what the flux answers to
    const L s = sweep.implicit ? run * (answer * depth) : none;
    const L of_right = !sweep.implicit ? select(k, half, k - half) : select(k, smaller(half, s), k - larger(half, -s));
    L through = depth * speed;
    if (sweep.advected()) through = through + advected;
    const L of_left = k - of_right;
    L s_left = s, s_right = s;
    if (pressed()) s_left = s + s * stiff[left(i)], s_right = s + s * stiff[i]; // a hull's head answers too
    const FaceLanes<N> out{kind.courant * through, of_left + s_left, s_right - of_right, kept - (1 - theta) * rise,
                           answer};
    if (!opening) return out;
    const L is_open = opening[i];
    return {is_open * out.flux, is_open * out.left, is_open * out.right, is_open * out.base, is_open * out.push};
}

// A face at a side of the scene.
template <int N> FaceLanes<N> WaterLine<N>::end_face(size_t i, const StepKind<N>& kind) {
    const L none{};
    const bool at_last = i > 0;
    const WaterEnd& end = sweep.end[at_last ? 1 : 0];
    if (end.kind == End::kWall) return {none, none, none, none, none};
    const size_t inside = at_last ? n - 1 : 0, next = n == 1 ? n - i : at_last ? n - 1 : 1;
    const double outward = at_last ? 1 : -1, critical = critical_depth(end.discharge, sweep.gravity);
    const SideWaves waves{sweep.gravity, sweep.advected()};
    double d[N], b[N], u[N], discharge[N], slope[N], half_cell[N];
    depth[inside].store(d), bed[inside].store(b), (outward * velocity[next]).store(u);
    for (int k = 0; k < N; ++k) {
        const double outside = end.level > b[k] ? end.level - b[k] : 0;
        const SideFlow flow = end.kind == End::kInflow ? SideFlow{-end.discharge, 0, d[k] > critical ? d[k] : critical}
                              : end.kind == End::kOpen ? waves.open(d[k], outside, u[k])
                                                       : waves.level(d[k], outside, u[k]);
        discharge[k] = outward * flow.discharge, slope[k] = flow.slope, d[k] = flow.depth;
        half_cell[k] = n > 1 ? flow.half_cell : 0; // a single cell has one half on each side
    }
    const L answer = open(i) * (sweep.theta * (kind.courant * L::load(slope)) - L::load(half_cell));
    side_depth[at_last ? 1 : 0] = L::load(d);
    const L flow = kind.courant * L::load(discharge) + outward * (kind.share * (end.rise * L::load(half_cell)));
    return {open(i) * flow, at_last ? answer : none, at_last ? none : answer, none, none};
}

template <int N> void WaterLine<N>::solve_surface(StepKind<N> kind) {
    WaterLine<N> here = *this;
    const L one = L::splat(1), none{};
    StreamAcceleration<N> streams(here, kind);
    const auto set_out = [&](size_t i, const FaceLanes<N>& f) {
        here.speed.put(i, f.base);
        if (here.keeps_push()) here.push.put(i, f.push);
    };
    FaceLanes<N> first{none, none, none, none, none}; // of a ring
    // Of the row before: its answer, 1 - pull, and in a ring how it follows face 0 and what is left of 1.
    L y = none, rest = one, follow = one, whole = none;
    const auto eliminate = [&](size_t i, const FaceLanes<N>& f) {
        const L own = one + f.left * rest, inverse = one / (own + f.right);
        y = (f.flux + f.left * y) * inverse;
        rest = own * inverse;
        here.flux.put(i, y);
        here.pull.put(i, f.right * inverse);
        set_out(i, f);
        if (!here.ring) return;
        follow = (f.left * follow) * inverse;
        whole = (one + f.left * whole) * inverse;
        here.spare[0].put(i, follow);
        here.spare[1].put(i, whole);
    };
    if (!ring) eliminate(0, side[0] = end_face(0, kind));
    for (size_t i = here.first_face(); i < here.n; ++i) {
        const FaceLanes<N> face = here.inner_face(i, kind, here.sweep.advected() ? streams.next(i) : none);
        if (i > 0) eliminate(i, face);
        else set_out(0, first = face);
    }
    rough = here.rough;
    if (ring) close_ring(first);
    else eliminate(n, side[1] = end_face(n, kind));
}

// Face 0 stands back; the others answer its flux and their own.
template <int N> void WaterLine<N>::close_ring(const FaceLanes<N>& first) {
    const L one = L::splat(1), none{};
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
template <int N> Lanes<N> WaterLine<N>::fill() {
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
