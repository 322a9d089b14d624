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

// Up to kMostSegmentLines lines, which alternate in memory; a lane is a segment. kAlone: one line. kPlain: nothing acts
// but springs and gravity, and the stage is for w, from the state.
template <bool kAlone, bool kPlain> struct Sweep {
    static constexpr int kMost = kAlone ? 1 : int(kMostSegmentLines), N = kTile;
    using L = Lanes<N>;
    using Nodes = L[N * kMost]; // of a tile: line l of node i at [i * count + l]

    const Lines lines; // values, which stores to y cannot be taken to change
    const SegmentCoefficients c;
    const Stage stage;
    const Start start;
    double* const y;
    const bool keep;
    const Segments segments{lines.nodes};
    const bool fetches = lines.nodes * lines.pitch >= kFetchedNumbers;
    Ends ends[kMost] = {};

    size_t count() const { return kAlone ? 1 : lines.pitch; }
    static L load(const double* row, size_t j) { return L::load(row + N * j); }
    // Line by line within a tile, as sweeps go: of node j and line l.
    size_t scratch(size_t j, size_t l) const {
        const size_t i = j % N, left = segments.length - (j - i);
        return ((j - i) * count() + l * (left < N ? left : N) + i) * N;
    }

    L wish(const StateLanes<N>& left, const StateLanes<N>& right) const {
        if (kPlain) return stage.closing_rate * (left.x - right.x);
        return wish_of<N>(stage, left, right);
    }
    // at: its place in scratch.
    StateLanes<N> begin(L x, L v, size_t at) const {
        if (kPlain || !start.w) return {x, v};
        const L w = L::load(start.w + at);
        return {x + start.move * w, w + start.overshoot * (w - v)};
    }

    // ---- nodes j to j + nodes of every segment, eight but at the segments' ends ---------------------------------

    size_t stride() const { return segments.length * count(); }
    size_t at_node(size_t j) const { return (segments.head + j) * count(); }
    // Around a call all registers are saved: it pays only where tiles take much code.
    static constexpr bool kTurnsHere = kPlain && kNative > 2;
    // Where a tile's numbers have room in the registers.
    static constexpr bool kUnrolls = kAlone && kPlain && kNative > 4;

    void load_nodes(const StateNumbers& of, size_t j, size_t nodes, L* out) const {
        of.stored([&](const auto* numbers) {
            const auto* const from = numbers + at_node(j);
            if (!kTurnsHere || nodes < N) return load_numbers(from, stride(), nodes * count(), out);
            for (size_t l = 0; l < count(); ++l) load_tile(from + l * N, stride(), out + l * N);
        });
    }
    void store_nodes(const L* in, const StateNumbers& of, size_t j, size_t nodes) const {
        of.stored([&](auto* numbers) {
            auto* const to = numbers + at_node(j);
            if (!kTurnsHere || nodes < N) return store_numbers(in, to, stride(), nodes * count());
            for (size_t l = 0; l < count(); ++l) store_tile(in + l * N, to + l * N, stride());
        });
    }

    // ---- going right --------------------------------------------------------------------------------------------

    // A line on its way: at the first node, at the one before, and what the sweep has come to.
    struct Right {
        StateLanes<N> first, left;
        L sum, gathered;
    };

    void go_right() {
        Right going[kMost] = {};
        Nodes x, v, force, target;
        for (size_t j = 0, nodes; j < segments.length; j += nodes) {
            nodes = segments.length - j < N ? segments.length - j : N;
            load_nodes(lines.position, j, nodes, x);
            load_nodes(lines.velocity, j, nodes, v);
            if (!kPlain && c.gains.force) load_nodes(lines.force, j, nodes, force);
            if (!kPlain && c.gains.attach) load_nodes(lines.target, j, nodes, target);
            if (fetches && j + 3 * N <= segments.length)
                for (const double* row : {c.carry, c.share, c.gains.gravity}) fetch_tile(row + N * (j + 2 * N));
            for (size_t l = 0; l < count(); ++l) tile_right(going[l], j, nodes, l, x + l, v + l, force + l, target + l);
        }
        for (size_t l = 0; l < count(); ++l) {
            const Right& end = going[l];
            end.first.x.store(ends[l].x_first), end.first.v.store(ends[l].v_first);
            end.left.x.store(ends[l].x_last), end.left.v.store(ends[l].v_last);
            end.sum.store(ends[l].y_last), end.gathered.store(ends[l].gathered);
        }
    }
    // The nodes of a tile, one line after the other. What goes from node to node has a name for each register: GCC 12
    // leaves a copy of the structure in memory.
    CD_INLINED void tile_right(Right& line, size_t j, size_t nodes, size_t l, const L* x, const L* v, const L* force,
                               const L* target) const {
        L first_x = line.first.x, first_v = line.first.v, x_left = line.left.x, v_left = line.left.v;
        L sum = line.sum, gathered = line.gathered;
        const double gravity = stage.gravity[l % lines.components];
        const bool falls = gravity != 0;
        const size_t step = count(), tile = scratch(j, l);
        const auto node = [&](size_t i) {
            const size_t m = i * step, at = tile + i * N;
            const StateLanes<N> here = begin(x[m], v[m], at);
            if (j + i == 0) first_x = x_left = here.x, first_v = v_left = here.v;
            L acting{};
            if (falls) acting = gravity * load(c.gains.gravity, j + i);
            if (!kPlain && c.gains.force) acting = acting + load(c.gains.force, j + i) * force[m];
            if (!kPlain && c.gains.drag) acting = acting - load(c.gains.drag, j + i) * here.v;
            if (!kPlain && c.gains.attach) acting = acting - load(c.gains.attach, j + i) * (here.x - target[m]);
            const L own = kPlain ? here.v : (1 - stage.of_change) * here.v;
            sum = between(own, sum, wish({x_left, v_left}, here), load(c.carry, j + i), acting);
            if (i == 0) sum = settled(sum, Limits<double>::least);
            sum.store(y + at);
            gathered = between(gathered, sum, -wish({first_x, first_v}, here), load(c.share, j + i));
            x_left = here.x, v_left = here.v;
        };
        if (kUnrolls && nodes == N) {
#pragma GCC unroll 8
            for (size_t i = 0; i < N; ++i) node(i);
        } else {
            for (size_t i = 0; i < nodes; ++i) node(i);
        }
        if (j == 0) line.first = {first_x, first_v};
        line.left = {x_left, v_left};
        line.sum = sum, line.gathered = gathered;
    }

    // ---- going left ---------------------------------------------------------------------------------------------

    struct Left {
        StateLanes<N> right;
        L answer, begun;
    };

    bool go_left() {
        Left going[kMost] = {};
        L probe{};
        for (size_t l = 0; l < count(); ++l) {
            const Ends& e = ends[l];
            double next_x[N], next_v[N];
            for (size_t k = 0; k < kSegments; ++k) {
                const bool is_last = k + 1 == kSegments;
                next_x[k] = is_last ? e.x_last[k] : e.x_first[k + 1];
                next_v[k] = is_last ? e.v_last[k] : e.v_first[k + 1];
            }
            going[l] = {{L::load(next_x), L::load(next_v)}, L::load(e.next), L::load(e.start)};
        }
        Nodes x, v;
        for (size_t end = segments.length; end > 0;) {
            const size_t nodes = end % N ? end % N : size_t(N), j = end -= nodes;
            load_nodes(lines.position, j, nodes, x);
            load_nodes(lines.velocity, j, nodes, v);
            if (fetches && j >= 2 * N) {
                for (const double* row : {c.pull, c.reach}) fetch_tile(row + N * (j - 2 * N));
                fetch_tile(y + scratch(j - 2 * N, 0), N * N * count());
            }
            for (size_t l = 0; l < count(); ++l) probe = probe + tile_left(going[l], j, nodes, l, x + l, v + l);
            if (!kPlain && keep) continue;
            store_nodes(x, lines.position, j, nodes);
            store_nodes(v, lines.velocity, j, nodes);
        }
        for (size_t l = 0; l < count(); ++l) going[l].answer.store(ends[l].next);
        return !probe.any_nan();
    }
    // The nodes of a tile of one line move, unless y keeps what they would move by. NaN if one moves too far, else 0.
    CD_INLINED L tile_left(Left& line, size_t j, size_t nodes, size_t l, L* x, L* v) const {
        L x_right = line.right.x, v_right = line.right.v, answer = line.answer, probe{};
        const L begun = line.begun;
        const StoredRange range = lines.position.range();
        const size_t step = count(), tile = scratch(j, l);
        const auto node = [&](size_t i) {
            const size_t m = i * step, at = tile + i * N;
            const StateLanes<N> here = begin(x[m], v[m], at);
            const L sum = L::load(y + at) + load(c.reach, j + i) * begun;
            answer = between(sum, answer, -wish(here, {x_right, v_right}), load(c.pull, j + i));
            if (i == 0) answer = settled(answer, Limits<double>::least);
            x_right = here.x, v_right = here.v;
            const L w = kPlain ? answer : answer + stage.of_change * here.v;
            const L change = kPlain ? w - here.v : answer - (1 - stage.of_change) * here.v;
            if (!kPlain && keep) {
                w.store(y + at);
                return;
            }
            v[m] = settle_and_probe(w + stage.overshoot * change, range, probe);
            x[m] = settle_and_probe(here.x + stage.move * w, range, probe);
        };
        if (kUnrolls && nodes == N) {
#pragma GCC unroll 8
            for (size_t left = 0; left < N; ++left) node(N - 1 - left);
        } else {
            for (size_t i = nodes; i-- > 0;) node(i);
        }
        line.right = {x_right, v_right};
        line.answer = answer;
        return probe;
    }

    bool run() {
        go_right();
        for (size_t l = 0; l < count(); ++l) {
            StateLanes<1> before{};
            const Lanes<1> sum = head(l).go_right(before);
            join_segments(c, stage, segments, before, sum, ends[l]);
        }
        StateLanes<1> first[kMost]; // as they were
        for (size_t l = 0; l < count(); ++l) first[l] = ends[l].first(0);
        bool finite = go_left();
        for (size_t l = 0; l < count(); ++l) finite &= head(l).go_left(first[l], {ends[l].next[0]});
        return finite;
    }
    Head head(size_t l) const { return {lines, c, stage, start, y, keep, segments, l}; }
};

} // namespace

bool segment_sweep(const Lines& lines, const SegmentCoefficients& c, const Stage& stage, const Start& start, double* y,
                   bool keep) {
    const bool plain = !c.gains.force && !c.gains.drag && !c.gains.attach && !start.w && !keep && stage.of_change == 0;
    if (plain && lines.pitch == 1) return Sweep<true, true>{lines, c, stage, start, y, keep}.run();
    if (plain) return Sweep<false, true>{lines, c, stage, start, y, keep}.run();
    return Sweep<false, false>{lines, c, stage, start, y, keep}.run();
}

} // namespace CD_ISA
} // namespace cd
