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
template <int N, class T> inline StateLanes<N> load_start(const Lines<T>& lines, const Start& start, size_t at) {
    using L = Lanes<N>;
    const L x = L::load(lines.position + at), v = L::load(lines.velocity + at);
    if (!start.w) return {x, v};
    const L w = L::load(start.w + at);
    return {x + start.move * w, w + start.overshoot * (w - v)};
}

inline StateLanes<1> load_start(const StateLines& lines, const Start& start, size_t at) {
    const Lanes<1> x{lines.position[at]}, v{lines.velocity[at]};
    if (!start.w) return {x, v};
    const Lanes<1> w{start.w[at]};
    return {x + start.move * w, w + start.overshoot * (w - v)};
}

// Asks for what the next bundle needs at this node: its numbers are a few bytes on, but its nodes a page and more
// apart, where no processor looks ahead.
template <int N, class T> inline void fetch_next_bundle(const Lines<T>& lines, size_t at) {
    constexpr size_t kLine = 64 / sizeof(T);
    for (size_t ahead = at + N; ahead < at + 2 * N; ahead += kLine) {
        __builtin_prefetch(lines.position + ahead);
        __builtin_prefetch(lines.velocity + ahead);
    }
}

// h g of each lane of the bundle that starts at a line.
template <int N, class T> Lanes<N> lane_gravity(const Lines<T>& lines, const double* gravity, size_t first) {
    double g[N];
    for (int j = 0; j < N; ++j) g[j] = gravity[(first + size_t(j)) % lines.components];
    return Lanes<N>::load(g);
}

// What acts on node i from outside. `at` is the place of the bundle's numbers at that node.
template <int N, class T> inline Lanes<N> outside(const Lines<T>& lines, const NodeGains& gains, size_t i, size_t at,
                                                  Lanes<N> gravity, Lanes<N> x, Lanes<N> v) {
    using L = Lanes<N>;
    L sum = gains.gravity[i] * gravity;
    if (gains.force) sum = sum + gains.force[i] * L::load(lines.force + at);
    if (gains.drag) sum = sum - gains.drag[i] * v;
    if (gains.attach) sum = sum - gains.attach[i] * (x - L::load(lines.target + at));
    return sum;
}

// Likewise of one line in either precision; row: of the gains.
inline Lanes<1> outside(const StateLines& lines, const NodeGains& gains, size_t row, size_t at, Lanes<1> gravity,
                        Lanes<1> x, Lanes<1> v) {
    Lanes<1> sum = gains.gravity[row] * gravity;
    if (gains.force) sum = sum + gains.force[row] * Lanes<1>{lines.force[at]};
    if (gains.drag) sum = sum - gains.drag[row] * v;
    if (gains.attach) sum = sum - gains.attach[row] * (x - Lanes<1>{lines.target[at]});
    return sum;
}

// A number to be stored: settles to 0 if it is too small for the state's precision, and adds to the probe what is NaN
// if it is too large for it.
template <class T, int N> inline Lanes<N> settle_and_probe(Lanes<N> a, Lanes<N>& probe) {
    probe = probe + 0.0 * (Limits<T>::to_overflow * a);
    return settled(a, double(Limits<T>::least));
}
template <int N> inline Lanes<N> settle_and_probe(Lanes<N> a, const StoredRange& range, Lanes<N>& probe) {
    probe = probe + 0.0 * (range.to_overflow * a);
    return settled(a, range.least);
}
template <class T, int N> inline void store_settled(Lanes<N> a, T* to, Lanes<N>& probe) {
    settle_and_probe<T>(a, probe).store(to);
}

// Ends a stage for the node at `at`, given the sweep's answer: either keeps w for the stage that follows, or moves.
template <int N, class T> inline void end_stage(const Lines<T>& lines, const Stage& stage, StateLanes<N> from,
                                                Lanes<N> answer, double* keep, size_t at, Lanes<N>& probe) {
    const Lanes<N> w = answer + stage.of_change * from.v, change = answer - (1 - stage.of_change) * from.v;
    if (keep) {
        w.store(keep + at);
        return;
    }
    store_settled(w + stage.overshoot * change, lines.velocity + at, probe);
    store_settled(from.x + stage.move * w, lines.position + at, probe);
}

inline void end_stage(const StateLines& lines, const Stage& stage, StateLanes<1> from, Lanes<1> answer, double* keep,
                      size_t at, Lanes<1>& probe) {
    const Lanes<1> w = answer + stage.of_change * from.v, change = answer - (1 - stage.of_change) * from.v;
    if (keep) {
        w.store(keep + at);
        return;
    }
    const StoredRange range = lines.position.range();
    lines.velocity.put(at, settle_and_probe(w + stage.overshoot * change, range, probe).v);
    lines.position.put(at, settle_and_probe(from.x + stage.move * w, range, probe).v);
}

} // namespace CD_ISA
} // namespace cd
