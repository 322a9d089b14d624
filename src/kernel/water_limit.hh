// A line of water (water_line.hh): no cell gives more than it has and gets.
#pragma once

#include "kernel/water_line.hh"

namespace cd {
namespace CD_ISA {

// A cell with two outflows shares out what it has; then along each direction, downstream, a cell passes on at most
// what it has and gets. Downstream cells see what upstream ones could really give, so one pass each way is enough.
template <int N> void WaterLine<N>::limit() {
    L least, deepest;
    fill_cells(least, deepest);
    const double wave = axis.gravity * axis.courant * axis.courant;
    strained = axis.corrections > 0 ? L::splat(1) : larger(-least, wave * deepest - L::splat(1e4));
    if (axis.corrections == 0 && !any_positive(-least)) return;
    for (size_t i = 0; i <= n; ++i) put(rest, i, at(transfer, i));
    if (ring) settle_seam();
    const auto shares = [&](size_t i) { return !ring || (i > 0 && i + 1 < n); };
    for (size_t i = 0; i < n; ++i) {
        const L in = at(transfer, i), out = at(transfer, i + 1), d = at(depth, i);
        const L all = d + positive(in), on = select(runs_dry(i), select(out, all, out), smaller(out, all));
        if (shares(i)) share_out(i);
        if (!ring || i + 1 < n) put(transfer, i + 1, select(-in, at(transfer, i + 1), on));
    }
    for (size_t i = n; i-- > 0;) {
        const L in = at(transfer, i), out = at(transfer, i + 1), d = at(depth, i);
        const L all = out - d, on = select(runs_dry(i), select(-in, all, in), larger(in, all));
        if (!ring || i > 0) put(transfer, i, select(out, in, on));
    }
    count_held_back();
    fill_cells(least, deepest);
}

// after = what is left in the cells; and the least and the most of it.
template <int N> void WaterLine<N>::fill_cells(L& least, L& deepest) const {
    least = L::splat(1), deepest = L{};
    for (size_t i = 0; i < n; ++i) {
        const L left = left_in(i);
        put(after, i, left);
        least = smaller(left, least), deepest = larger(left, deepest);
    }
}

// Where a ring closes, the cell that gives counts on what it has alone.
template <int N> void WaterLine<N>::settle_seam() const {
    share_out(0);
    share_out(n - 1);
    const L back = larger(at(transfer, 0), -at(depth, 0)), on = smaller(at(transfer, n), at(depth, n - 1));
    const L seam = select(on, on, smaller(back, L{}));
    for (size_t i : {size_t(0), n}) put(transfer, i, seam);
}

// Of a cell with two outflows that are more than it has.
template <int N> void WaterLine<N>::share_out(size_t i) const {
    const L in = at(transfer, i), out = at(transfer, i + 1), d = at(depth, i);
    const L both = smaller(-in, out), over = select(both, larger(-((d - out) + in), runs_dry(i)), L{});
    const L right = smaller(d * (out / (out - in)), d);
    put(transfer, i, select(over, -(d - right), in));
    put(transfer, i + 1, select(over, right, out));
}

// Rounding is not worth a mention.
template <int N> void WaterLine<N>::count_held_back() {
    for (size_t i = 0; i < n; ++i) {
        const L wanted = left_in(at(depth, i), at(rest, i), at(rest, i + 1));
        const L lacking = -wanted, noise = 0x1p-40 * (at(face, i) + (at(face, i + 1) + at(depth, i)));
        tally[kLimited] = tally[kLimited] + select(lacking - noise, L::splat(1), L{});
    }
    for (size_t i = ring ? 1 : 0; i <= n; ++i) {
        const L held = size_of(at(rest, i) - at(transfer, i)), noise = 0x1p-40 * at(face, i);
        tally[kHeldBack] = tally[kHeldBack] + select(held - noise, held, L{});
    }
}

} // namespace CD_ISA
} // namespace cd
