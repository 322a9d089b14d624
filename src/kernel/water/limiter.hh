// Step 4: no cell gives more than it has and gets. Fluxes of first order never leave a depth below 0: with s a face's
// speed in cells a step each face moves s d of the cell d that gives, counted at the end of the step, so that
//
//      d (1 + what leaves) = d before + what comes       (model.md, 38),
//
// a system in which water runs only one way through a face: one pass each way solves it. Of what the true fluxes are
// more or less each cell then gives as much as it has left, shared out alike (Zalesak's limiter, 1979, for depth 0).
#pragma once

#include "kernel/water/line.hh"

namespace cd {
namespace CD_ISA {

template <int N> void WaterLine<N>::limit(L need) {
    limits = need;
    const L one = L::splat(1), none{};
    if (!ring) { // no more comes in at a side than to a cell that has run dry
        const L first = side[0].flux + side[0].right * depth[0], last = side[1].flux - side[1].left * depth[n - 1];
        flux.put(0, select(smaller(need, side[0].right), smaller(flux[0], first), flux[0]));
        flux.put(n, select(smaller(need, side[1].left), larger(flux[n], last), flux[n]));
    }
    const Panel<N> run = pull, low = spare[0], part = spare[1]; // run: cells a step
    constexpr double kFastest = 0x1p-40;
    for (size_t i = 0; i <= n; ++i) {
        const L q = flux[i];
        const L d_l = i > 0 || ring ? depth[left(i)] : depth[0], d_r = i < n ? depth[i] : depth[ring ? 0 : n - 1];
        const L giver = larger(select(q, d_l, d_r), 0.5 * (d_l + d_r));
        const L deep = larger(giver, kFastest * size_of(q));
        run.put(i, select(deep, q / deep, none));
    }
    // What comes in at a side comes from no cell.
    const L in_first = ring ? none : positive(flux[0]), in_last = ring ? none : positive(-flux[n]);
    const auto comes = [&](size_t i) { return ring || i > 0 ? positive(run[i]) : none; };
    const auto returns = [&](size_t i) { return ring || i + 1 < n ? positive(-run[i + 1]) : none; };
    const auto forward = [&](L y) {
        for (size_t i = 0; i < n; ++i) {
            const L inverse = one / ((one + positive(-run[i])) + positive(run[i + 1]));
            L own = depth[i];
            if (i == 0) own = own + in_first;
            if (i + 1 == n) own = own + in_last;
            y = (own + comes(i) * y) * inverse;
            low.put(i, y);
            part.put(i, returns(i) * inverse);
        }
        return y;
    };
    L round = none, product = one;
    if (ring) { // from what comes round: linear in it, by the product of all shares
        const L once = forward(none);
        for (size_t i = 0; i < n; ++i)
            product = product * (comes(i) / ((one + positive(-run[i])) + positive(run[i + 1])));
        round = once / (one - product);
    }
    forward(round);
    L y = none;
    if (ring) {
        product = one;
        for (size_t i = n; i-- > 0;) y = low[i] + part[i] * y, product = product * part[i];
        y = y / (one - product);
    }
    for (size_t i = n; i-- > 0;) {
        y = low[i] + part[i] * y;
        low.put(i, y);
    }

    const auto low_flux = [&](size_t i) {
        const L s = run[i], q = flux[i];
        if (ring) return s * select(s, low[left(i)], low[i < n ? i : 0]);
        if (i == 0) return select(s, q, s * low[0]);
        if (i == n) return select(s, s * low[n - 1], q);
        return s * select(s, low[i - 1], low[i]);
    };
    L before = low_flux(0), more_before = flux[0] - before;
    for (size_t i = 0; i < n; ++i) {
        const L behind = low_flux(i + 1), more = flux[i + 1] - behind;
        const L comes_in = positive(before) + positive(-behind), keeps = (1 - kGives) * (depth[i] + comes_in);
        const L out = positive(-more_before) + positive(more);
        const L has = positive((depth[i] + (before - behind)) - keeps);
        part.put(i, select(out - has, has / out, one));
        limited = limited + select(need, select(out - has, one, none), none);
        before = behind, more_before = more;
    }
    for (size_t i = 0; i <= n; ++i) {
        const L q = flux[i], base_flux = low_flux(i), more = q - base_flux;
        const L from_l = i > 0 || ring ? part[left(i)] : one, from_r = i < n || ring ? part[i < n ? i : 0] : one;
        const L fits = select(more, from_l, from_r);
        const L now = select(need, select(one - fits, base_flux + fits * more, q), q);
        if (i < n || !ring) held_back = held_back + size_of(q - now);
        flux.put(i, now);
        pull.put(i, select(size_of(q), within(now / q, 0, 1), one)); // for set_velocities
    }
    L q = flux[0];
    for (size_t i = 0; i < n; ++i) {
        const L behind = flux[i + 1];
        after.put(i, select(need, larger(none, depth[i] + (q - behind)), after[i]));
        q = behind;
    }
}

} // namespace CD_ISA
} // namespace cd
