// A bundle of lines at one node: what the sweeps load, add up and store there.
#pragma once

#include "kernel/lanes.hh"
#include "kernel/lines.hh"

namespace cd {
namespace CD_ISA {

// Lines that are swept together: two registers, or each operation would wait for the last.
constexpr int kLinesAtOnce = kNative < 8 ? kWidest : 2 * kNative;

// The state at one node.
template <int N> struct StateLanes { Lanes<N> x, v; };
// Register by register: GCC 12 takes what is larger through memory, in parts, where two ways meet.
template <int N> inline Lanes<N> load_lanes(const StateNumbers& numbers, size_t at) {
    using L = Lanes<N>;
    L a;
    if constexpr (lane_kind(N) == LaneKind::kPair) {
        a.a = load_lanes<L::kFirst>(numbers, at), a.b = load_lanes<N - L::kFirst>(numbers, at + L::kFirst);
    } else {
        if (numbers.wide()) a.v = L::load(static_cast<const double*>(numbers.data) + at).v;
        else a.v = L::load(static_cast<const float*>(numbers.data) + at).v;
    }
    return a;
}
template <int N> inline StateLanes<N> load_state(const Lines& lines, size_t at) {
    return {load_lanes<N>(lines.position, at), load_lanes<N>(lines.velocity, at)};
}
template <int N> inline StateLanes<N> load_start(const Lines& lines, const Start& start, size_t at) {
    const StateLanes<N> here = load_state<N>(lines, at);
    if (!start.w) return here;
    const Lanes<N> w = Lanes<N>::load(start.w + at);
    return {here.x + start.move * w, w + start.overshoot * (w - here.v)};
}

// Asks for what the next bundle needs at this node: its numbers are a few bytes on, but its nodes a page and more
// apart, where no processor looks ahead.
template <int N> inline void fetch_next_bundle(const Lines& lines, size_t at) {
    constexpr size_t kLine = 64;
    const size_t size = lines.position.number_size();
    const auto* const position = static_cast<const char*>(lines.position.data);
    const auto* const velocity = static_cast<const char*>(lines.velocity.data);
    for (size_t ahead = (at + N) * size; ahead < (at + 2 * N) * size; ahead += kLine) {
        __builtin_prefetch(position + ahead);
        __builtin_prefetch(velocity + ahead);
    }
}

// h g of each lane of the bundle that starts at a line.
template <int N> Lanes<N> lane_gravity(const Lines& lines, const double* gravity, size_t first) {
    double g[N];
    for (int j = 0; j < N; ++j) g[j] = gravity[(first + size_t(j)) % lines.components];
    return Lanes<N>::load(g);
}

// What acts on a node from outside. row: of its gains; at: the place of the bundle's numbers at that node.
template <int N> inline Lanes<N> outside(const Lines& lines, const NodeGains& gains, size_t row, size_t at,
                                         Lanes<N> gravity, Lanes<N> x, Lanes<N> v) {
    Lanes<N> sum = gains.gravity[row] * gravity;
    if (gains.force) sum = sum + gains.force[row] * load_lanes<N>(lines.force, at);
    if (gains.drag) sum = sum - gains.drag[row] * v;
    if (gains.attach) sum = sum - gains.attach[row] * (x - load_lanes<N>(lines.target, at));
    return sum;
}

// A number to be stored: settles to 0 if it is too small for the state's precision, and adds to the probe what is NaN
// if it is too large for it.
template <int N> inline Lanes<N> settle_and_probe(Lanes<N> a, const StoredRange& range, Lanes<N>& probe) {
    probe = probe + 0.0 * (range.to_overflow * a);
    return settled(a, range.least);
}
template <int N> inline void store_settled(Lanes<N> a, const StateNumbers& to, size_t at, Lanes<N>& probe) {
    const Lanes<N> settles = settle_and_probe(a, to.range(), probe);
    to.stored([&](auto* numbers) { settles.store(numbers + at); });
}
template <int N> inline void store_state(StateLanes<N> a, const Lines& lines, size_t at, Lanes<N>& probe) {
    const StoredRange range = lines.position.range();
    const Lanes<N> v = settle_and_probe(a.v, range, probe), x = settle_and_probe(a.x, range, probe);
    lines.position.stored([&](auto* position) {
        v.store(static_cast<decltype(position)>(lines.velocity.data) + at);
        x.store(position + at);
    });
}

// Ends a stage for the node at `at`, given the sweep's answer: either keeps w for the stage that follows, or moves.
template <int N> inline void end_stage(const Lines& lines, const Stage& stage, StateLanes<N> from, Lanes<N> answer,
                                       double* keep, size_t at, Lanes<N>& probe) {
    const Lanes<N> w = answer + stage.of_change * from.v, change = answer - (1 - stage.of_change) * from.v;
    if (keep) {
        w.store(keep + at);
        return;
    }
    store_state<N>({from.x + stage.move * w, w + stage.overshoot * change}, lines, at, probe);
}

} // namespace CD_ISA
} // namespace cd
