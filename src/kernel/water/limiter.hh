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

inline void WaterLine::limit(L need) {
    limits = need;
    const L one = L::splat(1), none{};
    if (!ring) { // no more comes in at a side than to a cell that has run dry
        const L first = side[0].flux + side[0].right * depth[0], last = side[1].flux - side[1].left * depth[n - 1];
        flux.put(0, select(smaller(need, side[0].right), smaller(flux[0], first), flux[0]));
        flux.put(n, select(smaller(need, side[1].left), larger(flux[n], last), flux[n]));
    }
    const Panel run = pull, low = spare[0], part = spare[1]; // run: cells a step
    constexpr double kFastest = 0x1p-40;
    for (size_t i = 0; i <= n; ++i) {
        const L q = flux[i], d_l = depth[left(i)], d_r = depth[right(i)];
        const L giver = larger(select(q, d_l, d_r), 0.5 * (d_l + d_r));
        const L deep = larger(giver, kFastest * size_of(q));
        run.put(i, select(deep, q / deep, none));
    }
    Donors donors{low, part, after, ring};
    for (size_t i = 0; i < n; ++i) {
        L own = depth[i]; // and what comes in at a side comes from no cell
        if (!ring && i == 0) own = own + positive(flux[0]);
        if (!ring && i + 1 == n) own = own + positive(-flux[n]);
        const L from_l = positive(run[i]), from_r = positive(-run[i + 1]);
        donors.row(i, own, from_l, from_r, one / ((one + positive(-run[i])) + positive(run[i + 1])));
    }
    donors.solve(n, none, [&](size_t i, L d) { low.put(i, d); });

    const Panel base = run; // the fluxes of first order; at a side what comes in
    for (size_t i = 0; i <= n; ++i) {
        const L s = run[i], inner = s * select(s, low[left(i)], low[right(i)]);
        const bool first = !ring && i == 0, last = !ring && i == n;
        base.put(i, first ? select(s, flux[i], inner) : last ? select(s, inner, flux[i]) : inner);
    }
    for (size_t i = 0; i < n; ++i) {
        const L more_before = flux[i] - base[i], more = flux[i + 1] - base[i + 1];
        const L comes_in = positive(base[i]) + positive(-base[i + 1]), keeps = (1 - kGives) * (depth[i] + comes_in);
        const L out = positive(-more_before) + positive(more);
        const L has = positive((depth[i] + (base[i] - base[i + 1])) - keeps);
        part.put(i, select(out - has, has / out, one));
        tally[kLimited] = tally[kLimited] + select(need, select(out - has, one, none), none);
    }
    for (size_t i = 0; i <= n; ++i) {
        const L q = flux[i], more = q - base[i];
        const L from_l = i > 0 || ring ? part[left(i)] : one, from_r = i < n || ring ? part[right(i)] : one;
        const L fits = select(more, from_l, from_r);
        const L now = select(need, select(one - fits, base[i] + fits * more, q), q);
        if (i < n || !ring) tally[kHeldBack] = tally[kHeldBack] + size_of(q - now);
        flux.put(i, now);
        pull.put(i, select(size_of(q), within(now / q, 0, 1), one)); // for set_velocities
    }
    fill_again();
}

} // namespace CD_ISA
} // namespace cd
