// A line of water (water_line.hh): no cell gives more than it has and gets.
#pragma once

#include "kernel/water_line.hh"

namespace cd {
namespace CD_ISA {

// Limits the transfers of the step. What goes all the way round a ring changes no cell, and stays out of it: streams
// carry many times what a cell has, and the rounding of that would make or lose water.
template <int N> void WaterLine<N>::limit() {
    const L around = circulation();
    const bool circulates = any_positive(size_of(around));
    if (circulates) add_to_transfers(-around);
    limit_transfers();
    if (circulates) add_to_transfers(around);
}

template <int N> Lanes<N> WaterLine<N>::circulation() const {
    if (!ring) return L{};
    L least = at(transfer, 0), most = least;
    for (size_t i = 1; i < n; ++i) least = smaller(at(transfer, i), least), most = larger(at(transfer, i), most);
    return positive(least) - positive(-most);
}

template <int N> void WaterLine<N>::add_to_transfers(L more) const {
    for (size_t i = 0; i <= n; ++i) put(transfer, i, at(transfer, i) + more);
}

// A cell with two outflows shares out what it has; then along each direction, downstream, a cell passes on at most
// what it has and gets. Downstream cells see what upstream ones could really give, so one pass each way is enough;
// round a ring two, since what comes through its seam is known after the first.
template <int N> void WaterLine<N>::limit_transfers() {
    L least, deepest;
    fill_cells(least, deepest);
    strained = larger(larger(-least, thins), wave() * deepest - L::splat(kVeryLongStep));
    if (!any_positive(larger(-least, thins))) return;
    for (size_t i = 0; i <= n; ++i) put(rest, i, at(transfer, i));
    for (size_t i = 0; i < n; ++i) share_out(i);
    for (int turn = 0; turn <= int(ring); ++turn) {
        for (size_t i = 0; i < n; ++i) {
            const L in = at(transfer, i), out = at(transfer, i + 1), d = at(depth, i);
            const L all = d + positive(in), on = select(runs_dry(i), select(out, all, out), smaller(out, all));
            put(transfer, i + 1, select(-in, out, on));
        }
        if (ring) put(transfer, 0, at(transfer, n));
    }
    for (int turn = 0; turn <= int(ring); ++turn) {
        for (size_t i = n; i-- > 0;) {
            const L in = at(transfer, i), out = at(transfer, i + 1), d = at(depth, i);
            const L all = out - d, on = select(runs_dry(i), select(-in, all, in), larger(in, all));
            put(transfer, i, select(out, in, on));
        }
        close(transfer);
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

// Of a cell with two outflows that are more than it has.
template <int N> void WaterLine<N>::share_out(size_t i) const {
    const L in = at(transfer, i), out = at(transfer, i + 1), d = at(depth, i);
    const L both = smaller(-in, out), over = select(both, larger(-((d - out) + in), runs_dry(i)), L{});
    const L right = smaller(d * (out / (out - in)), d);
    put(transfer, i, select(over, -(d - right), in));
    put(transfer, i + 1, select(over, right, out));
    if (ring && i == 0) close(transfer);
    if (ring && i + 1 == n) put(transfer, 0, at(transfer, n));
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
