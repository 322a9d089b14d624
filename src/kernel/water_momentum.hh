// A line of water (water_line.hh): momentum goes with the water, and what velocity a face keeps.
#pragma once

#include "kernel/water_line.hh"

namespace cd {
namespace CD_ISA {

// What a dry face carries is the velocity of the nearest water, pushed as that was: the slope of dry land is no slope
// of water. In large steps, but for very long ones, so too what a face carries that the step ran dry: a film ran down
// the land there.
template <int N> void WaterLine<N>::follow_water() const {
    double* const wet = share; // streams are done with it
    L dry{};
    const bool ebb = any_positive(ebbs);
    if (ebb) measure_faces(after, wet);
    for (size_t i = first_inside(); i < n; ++i) {
        const L was = at(face, i), is = ebb ? select(smaller(was, ebbs), at(wet, i), was) : was;
        put(wet, i, is);
        dry = larger(dry, select(is, L{}, L::splat(1)));
    }
    if (any_positive(dry)) carry_to_dry_faces(wet, after, guess);
}

// Velocities are carried upwind with the transfers of the step: exactly as much momentum comes in at a face as goes
// out at the one before. Where the step shows a wave's course, what the surface at its end pushes acts after that,
// the rest before: so the push of the surface is in balance with what is carried, and shocks run at their right
// speed. Elsewhere, on thin and rushing water and where depths differ much, as at shores, it all acts before, which is
// the more stable. Where the two meet, but not at a shock, a face takes what the other would carry if it were pushed
// when the face itself is: water that moves alike goes on doing so.
template <int N> void WaterLine<N>::carry() const {
    const size_t begin = first_inside();
    const L one = L::splat(1);
    double* const turn = share; // the push acts before: -1; after: 1, or at a shock 0
    L turns{}, last{};
    const auto through = [&](size_t cell) { return 0.5 * (at(transfer, cell) + at(transfer, cell + 1)); };
    for (size_t i = begin; i < n; ++i) {
        const size_t l = left_of(i), far_l = ring ? l : i - 1, far_r = i + 1;
        const L u = at(velocity, i), w = at(guess, i), d_l = at(depth, l), d_r = at(depth, i);
        const L calm = smaller(akin(d_l, d_r), axis.gravity * smaller(d_l, d_r) - w * w);
        const L beside = smaller(ring || far_l > 0 ? at(face, far_l) : one, ring || far_r < n ? at(face, far_r) : one);
        const L closing = axis.courant * (at(velocity, far_l) - at(velocity, far_r)) - L::splat(0.02);
        const L shock = smaller(beside, closing);
        const L passing = positive(through(l)) + positive(-through(i)), volume = 0.5 * (d_l + d_r);
        const L short_step = smaller(one - wave() * larger(d_l, d_r), volume - passing);
        const L resolved = smaller(smaller(at(face, i), short_step), larger(calm, shock));
        const L later = select(resolved, axis.push_after * (w - u), L{}),
                now = select(resolved, select(shock, L{}, one), -one);
        put(gain, i, later);
        put(guess, i, w - later);
        put(turn, i, now);
        turns = larger(turns, -(now * last));
        last = now;
    }
    if (ring) turns = larger(turns, -(at(turn, 0) * last));
    else put(turn, 0, L{}), put(turn, n, L{});
    for (double* panel : {guess, gain, turn}) close(panel);
    const bool meet = any_positive(turns);
    // What the face `from` would carry besides, if it were pushed when face i is.
    const auto turned = [&](size_t i, size_t from) {
        const L there = at(turn, from),
                push = axis.push_after * ((at(guess, from) + at(gain, from)) - at(velocity, from));
        return select(-(at(turn, i) * there), there * push, L{});
    };
    const auto row = [&](size_t i) {
        const size_t l = left_of(i);
        const L volume = 0.5 * (at(depth, l) + at(depth, i)), is_open = opening(i);
        const L left = is_open * positive(through(l)), right = is_open * positive(-through(i));
        L load = is_open * (volume * at(guess, i));
        if (meet) {
            const L more = left * turned(i, ring ? l : i - 1) + right * turned(i, i + 1);
            load = select(size_of(more), load + more, load);
        }
        return RowLanes<N>{select(is_open, volume, one), left, right, left, right, load};
    };
    if (ring) solve_round<N>(n, row, x, rest, pull);
    else solve_rows<N>(1, n, row, at(guess, 0), at(guess, n), x, pull);
    for (size_t i = begin; i < n; ++i) put(guess, i, opening(i) * (at(x, i) + at(gain, i)));
    close(guess);
}

// The velocity with which an inflow comes in, for what carries it on: as if the side were as deep as the cell, or
// as deep as water at the speed of its own waves.
template <int N> void WaterLine<N>::set_inflow_velocity(size_t i) const {
    const WaterEnd& end = axis.end[i == 0 ? 0 : 1];
    if (ring || end.kind != End::kInflow) return;
    const L q = (1 / axis.courant) * at(transfer, i);
    const L critical = critical_depth(q, axis.gravity);
    const size_t cell = i == 0 ? 0 : n - 1;
    const L h = larger(0.5 * (at(depth, cell) + at(after, cell)), critical);
    put(guess, i, select(h, q / h, L{}));
}

// A face through which less went than its velocity would have moved is as slow as what went. Not so where momentum
// is advected in short steps: there what waits at a shore goes on as fast; but no faster than by a fall from the face
// behind and a step's push, lest a film speed up for ever above a lake.
template <int N> void WaterLine<N>::slow_held_back(size_t i) const {
    const size_t l = left_of(i);
    const L w = at(guess, i), went = at(transfer, i);
    const L moves = axis.courant * at(face, i), now = axis.lambda * w, then = (1 - axis.lambda) * at(velocity, i);
    const L more = streamed(i), wanted = moves * (now + then) + more;
    const L noise = 0x1p-40 * (moves * (size_of(now) + size_of(then)) + size_of(more));
    const L held_back = (size_of(wanted) - size_of(went)) - noise;
    L goes_on = w * positive(went / wanted);
    if (axis.advected) {
        const L long_wave = wave() * larger(at(depth, l), at(depth, i)) - L::splat(1);
        goes_on = select(larger(thins, long_wave), goes_on, no_faster_than_a_fall(i, w));
    }
    put(guess, i, select(smaller(held_back, strained), goes_on, w));
}

template <int N> Lanes<N> WaterLine<N>::no_faster_than_a_fall(size_t i, L w) const {
    const size_t l = left_of(i);
    const L behind = select(w, at(velocity, ring ? l : i - 1), at(velocity, i + 1));
    const L drop = (at(bed, l) + at(depth, l)) - (at(bed, i) + at(depth, i));
    const L fall = 2 * axis.gravity * positive(select(w, drop, -drop));
    const L bound = smaller(size_of(w), root(behind * behind + fall) + size_of(w - at(velocity, i)));
    return select(w, bound, -bound);
}

// Where a step is too long for waves or water to stay in a cell's reach, water gets no faster than by a fall from the
// highest head of its line, surface and speed, beside what pushes it: what the surface solved for may call for more has
// no water behind it. A shore that sets out loses some of its first push so, and only more than half a speed counts.
template <int N> void WaterLine<N>::bound_speeds() {
    if (!(axis.gravity > 0)) return;
    const double fall = 2 * axis.gravity;
    L head = L::splat(-1e300), over{};
    for (size_t i = 0; i < n; ++i) {
        const L before = at(velocity, i), behind = at(velocity, i + 1), d = at(depth, i);
        const L speed = (1 / fall) * larger(before * before, behind * behind);
        head = select(d, larger(head, (at(bed, i) + d) + speed), head);
    }
    for (const WaterEnd& end : axis.end)
        if (end.kind == End::kOpen) head = larger(head, L::splat(end.level));
    const auto excess = [&](size_t i) { // of the speed's square; none where the step is short
        const size_t l = left_of(i);
        const L fastest = fall * positive(head - smaller(at(bed, l), at(bed, i))), w = at(guess, i);
        const L deepest = larger(larger(at(depth, l), at(depth, i)), larger(at(after, l), at(after, i)));
        const L cells = larger(wave() * deepest, axis.courant * size_of(w));
        return select(smaller(cells - L::splat(1), strained), w * w - fastest, L{});
    };
    for (size_t i = first_inside(); i < n; ++i) over = larger(over, excess(i));
    if (!any_positive(over)) return;
    for (size_t i = first_inside(); i < n; ++i) {
        const L w = at(guess, i), too_much = excess(i), most = root(positive(w * w - too_much));
        const L bound = smaller(size_of(w), most + (push ? size_of(at(push, i)) : L{}));
        const L slowed = select(too_much, select(w, bound, -bound), w);
        const L moved = size_of(at(transfer, i)) - 0x1p-20 * (at(depth, i) + at(depth, left_of(i)));
        const L counts = smaller(moved, size_of(w) - 2 * size_of(slowed));
        tally[kLimited] = tally[kLimited] + select(counts, L::splat(1), L{});
        put(guess, i, slowed);
    }
    close(guess);
}

// The velocity that a face keeps: none where the cells on both sides are dry, nor, of linear momentum, where the
// face was.
template <int N> void WaterLine<N>::settle_face(size_t i) const {
    const bool inside = ring || (i > 0 && i < n);
    L water{}, u = at(guess, i);
    if (i > 0 || ring) water = larger(water, at(after, left_of(i)));
    if (i < n || ring) water = larger(water, at(after, right_of(i)));
    if (!axis.advected) u = select(at(face, i) + size_of(at(transfer, i)), u, at(velocity, i));
    if (!axis.advected && inside) u = slowed_by_newcomers(i, u);
    put(velocity, i, select(water, u, L{}));
}

// Linear momentum lets water that comes to a face take on the velocity there, which makes energy out of nothing.
// Waves do not show it; but where a step is too long for the waves and water rushes, at more than a third of what
// waves carry, it would feed on itself. There newcomers are at rest.
template <int N> Lanes<N> WaterLine<N>::slowed_by_newcomers(size_t i, L u) const {
    const size_t l = left_of(i), r = right_of(i);
    const L was = at(depth, l) + at(depth, r), is = at(after, l) + at(after, r);
    const L waves = axis.gravity * larger(at(after, l), at(after, r));
    const L too_long = (axis.courant * axis.courant) * waves - L::splat(1), rushes = u * u - (1.0 / 3) * waves;
    return select(smaller(smaller(too_long, rushes), is - was), u * (was / is), u);
}

} // namespace CD_ISA
} // namespace cd
