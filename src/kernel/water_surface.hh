// A line of water (water_line.hh): the new surface, new velocities, and what they move.
#pragma once

#include "kernel/water_line.hh"

namespace cd {
namespace CD_ISA {

// What the slope of the present surface, forces and friction make of a face's velocity, what a unit of slope of the
// change will add, and what follows for the system. slope: of the surface, times g dt / distance.
template <int N> void WaterLine<N>::guess_face(size_t i, L slope, double wave_gain, L drag) const {
    const L u = at(velocity, i), h = at(face, i), pushed = push ? at(push, i) - slope : -slope;
    L gain = L::splat(wave_gain * axis.lambda);
    L w = u + pushed;
    if (axis.manning > 0) drag = drag + manning_drag(h, size_of(w), axis.manning);
    if (axis.rubs() || i == 0 || i == n) {
        const FrictionLanes<N> friction(drag);
        w = friction.keep * u + friction.push * pushed;
        gain = friction.push * gain;
    }
    put(guess, i, w);
    put(this->gain, i, gain);
    put(spring, i, (axis.courant * axis.lambda) * (gain * h));
    put(transfer, i, axis.courant * (h * (axis.lambda * w + (1 - axis.lambda) * u)));
}

template <int N> void WaterLine<N>::guess_faces() const {
    const double wave_gain = axis.gravity * axis.courant;
    const L drag = L::splat(axis.drag);
    for (size_t i = first_inside(); i < n; ++i) {
        const size_t l = left_of(i);
        const L slope = wave_gain * ((at(bed, i) - at(bed, l)) + (at(depth, i) - at(depth, l)));
        guess_face(i, slope, wave_gain, drag);
        for (double* panel : {gain, spring, transfer}) put(panel, i, select(gives(i), at(panel, i), L{}));
        if (!streams) continue;
        const L speed = mean_speed(i);
        // The mean of both cells is the one that gives, less half of what it has more: that comes off the spring.
        const L part = at(share, i), k = axis.courant * (size_of(part) * speed), stiff = at(spring, i);
        const L eased = select(-part, stiff - 0.5 * size_of(k), stiff);
        put(stream, i, select(-eased, L{}, k));
        put(spring, i, select(-eased, stiff, eased));
    }
    for (double* panel : {guess, gain, spring}) close(panel);
    if (streams) close(stream);
    close_transfers();
    for (size_t i : {size_t(0), n})
        if (!ring) guess_end(i, wave_gain, drag);
}

// Faces inside look ahead with the velocities that they will have, and so does what they move.
template <int N> void WaterLine<N>::look_late() {
    look_ahead(guess);
    streams = false;
    for (size_t i = first_inside(); i < n; ++i)
        put(transfer, i, select(gives(i), (axis.courant * at(guess, i)) * at(face, i), L{}));
    close_transfers();
}

// On an open side the surface half a cell further stands at the level outside plus what a wave that leaves with the
// face's velocity u carries, u sqrt(depth / g): a drag on it, and a spring to the outside. What rushes out goes on as
// fast as it comes.
template <int N> void WaterLine<N>::guess_end(size_t i, double wave_gain, L drag) const {
    const WaterEnd& end = axis.end[i == 0 ? 0 : 1];
    const size_t cell = i == 0 ? 0 : n - 1;
    for (double* panel : {guess, gain, spring, transfer, stream}) put(panel, i, L{});
    if (end.kind == End::kOpen) {
        const L rise = at(depth, cell) - outside(end, cell), h = at(face, i);
        const L slope = (2 * wave_gain) * (i == 0 ? rise : -rise);
        guess_face(i, slope, 2 * wave_gain, drag + (2 * axis.courant) * root(axis.gravity * h));
        const L rushes = rushes_out(i);
        put(guess, i, select(rushes, inside_end(i), at(guess, i)));
        for (double* panel : {gain, spring}) put(panel, i, select(rushes, L{}, at(panel, i)));
        put(transfer, i, select(rushes, axis.courant * (h * mean_speed(i)), at(transfer, i)));
        const L out = positive((i == 0 ? -1.0 : 1.0) * mean_speed(i)), k = axis.courant * (at(share, i) * out);
        if (streams) put(stream, i, i == 0 ? -k : k);
    } else if (end.kind == End::kInflow) {
        const L in = end.discharge * opening(i);
        put(transfer, i, i == 0 ? in : -in);
    }
}

// x = the change of the surface, from the guesses. Where it thins, only cells that stay wet store water.
template <int N> void WaterLine<N>::solve_surface() {
    const auto row_with = [&](size_t i, L ground) {
        const L load = at(transfer, i) - at(transfer, i + 1), l = at(spring, i), r = at(spring, i + 1), none{};
        const bool has_l = ring || i > 0, has_r = ring || i + 1 < n;
        if (!has_l) ground = ground + l;
        if (!has_r) ground = ground + r;
        if (streams && !has_l) ground = ground - at(stream, i);
        if (streams && !has_r) ground = ground + at(stream, i + 1);
        RowLanes<N> row{ground, has_l ? l : none, has_r ? r : none, has_l ? l : none, has_r ? r : none, load};
        if (streams && has_l) {
            const L k = at(stream, i);
            row.left = row.left + positive(k), row.to_left = row.to_left + positive(-k);
        }
        if (streams && has_r) {
            const L k = at(stream, i + 1);
            row.right = row.right + positive(-k), row.to_right = row.to_right + positive(k);
        }
        return row;
    };
    const auto row = [&](size_t i) { return row_with(i, L::splat(1)); };
    const auto storing_row = [&](size_t i) {
        const L stores = at(ground, i);
        RowLanes<N> r = row_with(i, stores);
        r.load = select(stores, r.load, r.load + at(depth, i));
        return r;
    };
    const auto solve = [&](const auto& rows) {
        if (axis.lambda > 0) tally[kSolves] = tally[kSolves] + L::splat(1);
        if (ring) solve_columns_round<N>(n, rows, x, rest, pull);
        else solve_rows<N>(0, n, rows, L{}, L{}, x, pull);
    };
    if (!any_positive(thins)) return solve(row);
    // Newton's method on a convex, piecewise linear system: from "all store" on, cells only ever drop out, but for
    // what rounding took out by mistake, which may return in the first 8. It ends after 2 passes mostly, n + 9 at most.
    const L all_store = L::splat(1) - thins;
    for (size_t i = 0; i < n; ++i) put(ground, i, L::splat(1));
    bool changed = true;
    for (size_t pass = 0; changed; ++pass) {
        solve(storing_row);
        L changes{};
        for (size_t i = 0; i < n; ++i) {
            const L stores = at(ground, i), stored = at(depth, i) + at(x, i);
            const L all = at(depth, i) + (at(face, i) + at(face, i + 1));
            const L least = select(stores, L{}, pass < 8 ? 0x1p-20 * all : L::splat(__builtin_inf()));
            const L now = select(larger(stored - least, all_store), L::splat(1), L{});
            changes = changes + size_of(stores - now);
            put(ground, i, now);
        }
        changed = any_positive(changes);
    }
}

template <int N> void WaterLine<N>::move_faces() const {
    const double lambda = axis.lambda, courant = axis.courant;
    const bool may_thin = any_positive(thins);
    const auto finish = [&](size_t i, L rise) {
        const L w = at(guess, i) - at(gain, i) * rise;
        const L now = lambda * w, then = (1 - lambda) * at(velocity, i);
        L speed = now + then;
        // Beside a cell that stays dry the two cancel: what is left is rounding, and must not wet it.
        if (may_thin) speed = select(size_of(speed) - 0x1p-40 * (thins * (size_of(now) + size_of(then))), speed, L{});
        put(guess, i, w);
        put(transfer, i, courant * (at(face, i) * speed));
    };
    for (size_t i = first_inside(); i < n; ++i) {
        finish(i, at(x, i) - at(x, left_of(i)));
        if (!streams) continue;
        const L still = at(transfer, i); // not even the sign of a zero changes where nothing streams
        put(transfer, i, select(size_of(at(stream, i)), still + streamed(i), still));
    }
    for (size_t i : {size_t(0), n}) {
        if (ring || axis.end[i ? 1 : 0].kind != End::kOpen) continue;
        finish(i, i == 0 ? at(x, 0) : -at(x, n - 1));
        if (streams) put(transfer, i, at(transfer, i) + streamed(i));
    }
    close(guess);
    close_transfers();
    hold_inflow();
}

// The water outside an open side comes in no faster than its waves run, though a surface that has been solved for
// may have sunk below the bed and call for more.
template <int N> void WaterLine<N>::hold_inflow() const {
    for (size_t i : {size_t(0), n}) {
        const WaterEnd& end = axis.end[i == 0 ? 0 : 1];
        if (end.kind != End::kOpen) continue;
        const L depth_outside = outside(end, i == 0 ? 0 : n - 1), t = at(transfer, i), in = i == 0 ? t : -t;
        const L most = axis.courant * (depth_outside * root(axis.gravity * depth_outside)), over = in - most;
        put(transfer, i, select(over, i == 0 ? most : -most, t));
        put(guess, i, select(over, at(guess, i) * (most / in), at(guess, i)));
    }
}

} // namespace CD_ISA
} // namespace cd
