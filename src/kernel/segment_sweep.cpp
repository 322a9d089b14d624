#include "kernel/segment_sweep.hh"

#include "kernel/line_lanes.hh"
#include "kernel/tiles.hh"

namespace cd {
namespace CD_ISA {

namespace {

static_assert(kSegments == size_t(kTile), "a tile holds as many streams as there are segments");

// One line, segment by segment: what going right leaves, and what going left needs.
struct Ends {
    double x_first[kSegments], v_first[kSegments], x_last[kSegments], v_last[kSegments]; // nodes of the segment
    double y_last[kSegments], gathered[kSegments], start[kSegments];
    double next[kSegments]; // the answer at the node after the segment, at last at its first one

    StateLanes<1> first(size_t k) const { return {{x_first[k]}, {v_first[k]}}; }
    StateLanes<1> last(size_t k) const { return {{x_last[k]}, {v_last[k]}}; }
};

template <int N> inline Lanes<N> wish_of(const Stage& stage, const StateLanes<N>& left, const StateLanes<N>& right) {
    return stage.closing_rate * (left.x - right.x) + stage.of_change * (left.v - right.v);
}

// The true starts of the segments, and the answers at their first nodes. before, y: the head's last node, if any.
void join_segments(const SegmentCoefficients& c, const Stage& stage, const Segments& segments, StateLanes<1> before,
                   Lanes<1> y, Ends& e) {
    using One = Lanes<1>;
    const double* const reach_last = c.reach + kSegments * (segments.length - 1);
    for (size_t k = 0; k < kSegments; ++k) {
        const bool begins = k == 0 && segments.head == 0;
        const One start = begins ? One{} : y + wish_of<1>(stage, before, e.first(k));
        e.start[k] = settled(start, Limits<double>::least).v;
        before = e.last(k);
        y = One{e.y_last[k]} + One{reach_last[k]} * One{e.start[k]};
    }
    One answer{};
    for (size_t k = kSegments; k-- > 0;) {
        const One gathered = One{e.gathered[k]} + One{c.reply[k]} * One{e.start[k]};
        e.next[k] = answer.v;
        if (k + 1 == kSegments) answer = gathered;
        else answer = between(gathered, answer, -wish_of<1>(stage, e.first(k), e.first(k + 1)), c.pass[k]);
    }
}

// The nodes that the segments leave over, one after the other.
struct Head {
    const Lines& lines;
    const SegmentCoefficients& c;
    const Stage& stage;
    const Start& start;
    double* y; // its scratch and that of start begin with the segments'
    bool keep;
    Segments segments;
    size_t line;

    size_t scratch(size_t i) const { return (kSegments * segments.length + i) * lines.pitch + line; }
    StateLanes<1> state(size_t i) const {
        Start here = start;
        const size_t at = i * lines.pitch + line;
        if (here.w) here.w += scratch(i) - at;
        return load_start<1>(lines, here, at);
    }

    // y of the last node, whose state is left in `before`.
    Lanes<1> go_right(StateLanes<1>& before) const {
        Lanes<1> sum{};
        for (size_t i = 0; i < segments.head; ++i) {
            const StateLanes<1> here = state(i);
            const size_t row = segments.place(i), at = i * lines.pitch + line;
            const Lanes<1> gravity{stage.gravity[line % lines.components]};
            const Lanes<1> own = (1 - stage.of_change) * here.v;
            const Lanes<1> acting = outside<1>(lines, c.gains, row, at, gravity, here.x, here.v);
            sum = i == 0 ? own + acting : between(own, sum, wish_of<1>(stage, before, here), c.carry[row], acting);
            sum.store(y + scratch(i));
            before = here;
        }
        return sum;
    }
    // right, answer: of the node after it.
    bool go_left(StateLanes<1> right, Lanes<1> answer) const {
        Lanes<1> probe{};
        for (size_t i = segments.head; i-- > 0;) {
            const StateLanes<1> here = state(i);
            const size_t at = i * lines.pitch + line;
            const Lanes<1> sum = Lanes<1>::load(y + scratch(i));
            answer = between(sum, answer, -wish_of<1>(stage, here, right), c.pull[segments.place(i)]);
            right = here;
            end_stage(lines, stage, here, answer, keep ? y + scratch(i) - at : nullptr, at, probe);
        }
        return !probe.any_nan();
    }
};

// kLines lines side by side in memory, 0: any number; a lane is a segment. kPlain: nothing acts but springs and
// gravity, and the stage is for w, from the state.
template <int kLines, bool kPlain> struct Sweep {
    static constexpr int kMost = kLines > 0 ? kLines : int(kMostSegmentLines), N = kTile;
    using L = Lanes<N>;
    using Nodes = L[N * kMost]; // of a tile: line l of node i at [i * count + l]

    const Lines lines; // values, which stores to y cannot be taken to change
    const SegmentCoefficients c;
    const Stage stage;
    const Start start;
    double* const y;
    const bool keep;
    const Segments segments{lines.nodes};
    Ends ends[kMost] = {};

    int count() const { return kLines > 0 ? kLines : int(lines.pitch); }
    static L load(const double* row, size_t j) { return L::load(row + N * j); }
    size_t scratch(size_t j, int l) const { return (j * size_t(count()) + size_t(l)) * N; }

    L wish(const StateLanes<N>& left, const StateLanes<N>& right) const {
        if (kPlain) return stage.closing_rate * (left.x - right.x);
        return wish_of<N>(stage, left, right);
    }
    StateLanes<N> begin(L x, L v, size_t j, int l) const {
        if (kPlain || !start.w) return {x, v};
        const L w = L::load(start.w + scratch(j, l));
        return {x + start.move * w, w + start.overshoot * (w - v)};
    }

    // ---- nodes j to j + nodes of every segment, eight but at the segments' ends ---------------------------------

    size_t stride() const { return segments.length * size_t(count()); }
    size_t at_node(size_t j) const { return (segments.head + j) * size_t(count()); }
    // Around a call all registers are saved: it pays only where tiles take much code.
    static constexpr bool kTurnsHere = kPlain && kNative > 2;

    template <class T> void load_nodes(const T* of, size_t j, size_t nodes, L* out) const {
        const T* const from = of + at_node(j);
        if (!kTurnsHere || nodes < N) return load_numbers(from, stride(), nodes * size_t(count()), out);
        for (int l = 0; l < count(); ++l) load_tile(from + l * N, stride(), out + l * N);
    }
    void load_nodes(const StateNumbers& of, size_t j, size_t nodes, L* out) const {
        of.stored([&](const auto* numbers) { load_nodes(numbers, j, nodes, out); });
    }
    void load_state(size_t j, size_t nodes, L* x, L* v) const {
        lines.position.stored([&](const auto* position) {
            load_nodes(position, j, nodes, x);
            load_nodes(static_cast<decltype(position)>(lines.velocity.data), j, nodes, v);
        });
    }
    template <class T> void store_nodes(const L* in, T* of, size_t j, size_t nodes) const {
        T* const to = of + at_node(j);
        if (!kTurnsHere || nodes < N) return store_numbers(in, to, stride(), nodes * size_t(count()));
        for (int l = 0; l < count(); ++l) store_tile(in + l * N, to + l * N, stride());
    }
    void store_state(const L* x, const L* v, size_t j, size_t nodes) const {
        lines.position.stored([&](auto* position) {
            store_nodes(x, position, j, nodes);
            store_nodes(v, static_cast<decltype(position)>(lines.velocity.data), j, nodes);
        });
    }

    // ---- going right --------------------------------------------------------------------------------------------

    void go_right() {
        StateLanes<N> first[kMost] = {}, left[kMost] = {};
        L sum[kMost] = {}, gathered[kMost] = {};
        double gravity[kMost];
        bool falls = false;
        for (int l = 0; l < count(); ++l) {
            gravity[l] = stage.gravity[size_t(l) % lines.components];
            falls |= gravity[l] != 0;
        }
        Nodes x, v, force, target;
        for (size_t j = 0, nodes; j < segments.length; j += nodes) {
            nodes = segments.length - j < N ? segments.length - j : N;
            load_state(j, nodes, x, v);
            if (!kPlain && c.gains.force) load_nodes(lines.force, j, nodes, force);
            if (!kPlain && c.gains.attach) load_nodes(lines.target, j, nodes, target);
            for (size_t i = 0; i < nodes; ++i) {
                for (int l = 0; l < count(); ++l) {
                    const size_t m = i * size_t(count()) + size_t(l);
                    const StateLanes<N> here = begin(x[m], v[m], j + i, l);
                    if (j + i == 0) first[l] = left[l] = here;
                    L acting{};
                    if (falls) acting = gravity[l] * load(c.gains.gravity, j + i);
                    if (!kPlain && c.gains.force) acting = acting + load(c.gains.force, j + i) * force[m];
                    if (!kPlain && c.gains.drag) acting = acting - load(c.gains.drag, j + i) * here.v;
                    if (!kPlain && c.gains.attach) acting = acting - load(c.gains.attach, j + i) * (here.x - target[m]);
                    const L own = kPlain ? here.v : (1 - stage.of_change) * here.v;
                    sum[l] = between(own, sum[l], wish(left[l], here), load(c.carry, j + i), acting);
                    if (i == 0) sum[l] = settled(sum[l], Limits<double>::least);
                    sum[l].store(y + scratch(j + i, l));
                    gathered[l] = between(gathered[l], sum[l], -wish(first[l], here), load(c.share, j + i));
                    left[l] = here;
                }
            }
        }
        for (int l = 0; l < count(); ++l) {
            first[l].x.store(ends[l].x_first), first[l].v.store(ends[l].v_first);
            left[l].x.store(ends[l].x_last), left[l].v.store(ends[l].v_last);
            sum[l].store(ends[l].y_last), gathered[l].store(ends[l].gathered);
        }
    }

    // ---- going left ---------------------------------------------------------------------------------------------

    bool go_left() {
        StateLanes<N> right[kMost] = {};
        L answer[kMost] = {}, begun[kMost] = {}, probe{};
        for (int l = 0; l < count(); ++l) {
            const Ends& e = ends[l];
            double next_x[N], next_v[N];
            for (size_t k = 0; k < kSegments; ++k) {
                const bool is_last = k + 1 == kSegments;
                next_x[k] = is_last ? e.x_last[k] : e.x_first[k + 1];
                next_v[k] = is_last ? e.v_last[k] : e.v_first[k + 1];
            }
            right[l] = {L::load(next_x), L::load(next_v)};
            answer[l] = L::load(e.next);
            begun[l] = L::load(e.start);
        }
        const StoredRange range = lines.position.range();
        Nodes x, v;
        for (size_t end = segments.length; end > 0;) {
            const size_t nodes = end % N ? end % N : size_t(N), j = end -= nodes;
            load_state(j, nodes, x, v);
            for (size_t i = nodes; i-- > 0;) {
                for (int l = 0; l < count(); ++l) {
                    const size_t m = i * size_t(count()) + size_t(l);
                    const StateLanes<N> here = begin(x[m], v[m], j + i, l);
                    const L sum = L::load(y + scratch(j + i, l)) + load(c.reach, j + i) * begun[l];
                    answer[l] = between(sum, answer[l], -wish(here, right[l]), load(c.pull, j + i));
                    if (i == 0) answer[l] = settled(answer[l], Limits<double>::least);
                    right[l] = here;
                    const L w = kPlain ? answer[l] : answer[l] + stage.of_change * here.v;
                    const L change = kPlain ? w - here.v : answer[l] - (1 - stage.of_change) * here.v;
                    if (!kPlain && keep) {
                        w.store(y + scratch(j + i, l));
                        continue;
                    }
                    v[m] = settle_and_probe(w + stage.overshoot * change, range, probe);
                    x[m] = settle_and_probe(here.x + stage.move * w, range, probe);
                }
            }
            if (!kPlain && keep) continue;
            store_state(x, v, j, nodes);
        }
        for (int l = 0; l < count(); ++l) answer[l].store(ends[l].next);
        return !probe.any_nan();
    }

    bool run() {
        go_right();
        for (int l = 0; l < count(); ++l) {
            StateLanes<1> before{};
            const Lanes<1> sum = head(l).go_right(before);
            join_segments(c, stage, segments, before, sum, ends[l]);
        }
        StateLanes<1> first[kMost]; // as they were
        for (int l = 0; l < count(); ++l) first[l] = ends[l].first(0);
        bool finite = go_left();
        for (int l = 0; l < count(); ++l) finite &= head(l).go_left(first[l], {ends[l].next[0]});
        return finite;
    }
    Head head(int l) const { return {lines, c, stage, start, y, keep, segments, size_t(l)}; }
};

template <int kLines, bool kPlain> bool sweep(const Lines& lines, const SegmentCoefficients& c, const Stage& stage,
                                              const Start& start, double* y, bool keep) {
    return Sweep<kLines, kPlain>{lines, c, stage, start, y, keep}.run();
}

} // namespace

bool segment_sweep(const Lines& lines, const SegmentCoefficients& c, const Stage& stage, const Start& start, double* y,
                   bool keep) {
    const bool plain = !c.gains.force && !c.gains.drag && !c.gains.attach && !start.w && !keep && stage.of_change == 0;
    if (plain && lines.pitch == 1) return sweep<1, true>(lines, c, stage, start, y, keep);
    if (plain && lines.pitch == 2) return sweep<2, true>(lines, c, stage, start, y, keep);
    if (plain && lines.pitch == 3) return sweep<3, true>(lines, c, stage, start, y, keep);
    if (lines.pitch == 1) return sweep<1, false>(lines, c, stage, start, y, keep);
    if (lines.pitch == 3) return sweep<3, false>(lines, c, stage, start, y, keep);
    return sweep<0, false>(lines, c, stage, start, y, keep);
}

} // namespace CD_ISA
} // namespace cd
