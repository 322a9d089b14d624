#include "kernel/segment_rod.hh"

#include "kernel/line_lanes.hh"
#include "kernel/tiles.hh"

namespace cd {
namespace CD_ISA {

namespace {

static_assert(kSegments == size_t(kTile), "a tile holds as many streams as there are segments");

// A value and the difference into it, of every segment of one line.
struct Pairs {
    double value[kSegments], slope[kSegments];
};

// A row of which each segment has its own number.
struct LaneRow {
    const double* data;
    Lanes<kTile> operator[](size_t j) const { return Lanes<kTile>::load(data + kTile * j); }
};
struct LaneRows {
    LaneRow keep, close, turn, lever, follow, lean, bend;

    explicit LaneRows(const SegmentRodCoefficients& c)
        : keep{c.keep}, close{c.close}, turn{c.turn}, lever{c.lever}, follow{c.follow}, lean{c.lean}, bend{c.bend} {}
};

// By how much two states differ; of the differences into two springs, by how much they turn.
template <int N> inline StateLanes<N> difference(const StateLanes<N>& a, const StateLanes<N>& b) {
    return {a.x - b.x, a.v - b.v};
}

// Up to kMostSegmentLines lines, which alternate in memory; a lane is a segment. kAlone: one line. kPlain: open lines on
// which nothing acts but springs, bend and gravity, and the stage is for w, from the state.
template <bool kAlone, bool kPlain> struct Sweep {
    static constexpr int kMost = kAlone ? 1 : int(kMostSegmentLines), N = kTile;
    using L = Lanes<N>;
    using One = Lanes<1>;
    using Nodes = L[N * kMost]; // of a tile: line l of node i at [i * count + l]

    const Lines lines; // values, which stores to scratch cannot be taken to change
    const SegmentRodCoefficients c;
    const Stage stage;
    const Start start;
    const RingClosure ring;
    double *const value, *const slope, *const hold;
    const bool keep;
    const Segments segments{lines.nodes};
    const bool fetches = lines.nodes * lines.pitch >= kFetchedNumbers;
    double gravity[kMost] = {}, guess[kMost] = {};
    double pull[kMost][3] = {};                  // of a ring's constraints
    Pairs first[kMost] = {}, last[kMost] = {};   // nodes of the segments
    Pairs before[kMost] = {}, after[kMost] = {}; // what the nodes beside the segments miss

    // ---- where things lie -------------------------------------------------------------------------------------------

    size_t count() const { return kAlone ? 1 : lines.pitch; }
    size_t stride() const { return segments.length * count(); }
    size_t at_node(size_t j) const { return (segments.head + j) * count(); }
    // Line by line within a tile, as sweeps go: of node j and line l.
    size_t scratch(size_t j, size_t l) const {
        const size_t i = j % N, left = segments.length - (j - i);
        return ((j - i) * count() + l * (left < N ? left : N) + i) * N;
    }
    size_t scratch_of(size_t node, size_t l) const {
        const size_t row = segments.place(node);
        if (node < segments.head) return row * count() + l;
        return scratch(row / N, l) + row % N;
    }

    // ---- states -----------------------------------------------------------------------------------------------------

    // Around a call all registers are saved: it pays only where tiles take much code.
    static constexpr bool kTurnsHere = kPlain && kNative > 2;

    size_t nodes_from(size_t j) const { return segments.length - j < N ? segments.length - j : N; }
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
    // at: its place in scratch.
    StateLanes<N> begin(L x, L v, size_t at) const {
        if (kPlain || !start.w) return {x, v};
        const L w = L::load(start.w + at);
        return {x + start.move * w, w + start.overshoot * (w - v)};
    }
    StateLanes<1> state(size_t node, size_t l) const {
        Start here = start;
        const size_t at = node * count() + l;
        if (here.w) here.w += ptrdiff_t(scratch_of(node, l)) - ptrdiff_t(at);
        return load_start<1>(lines, here, at);
    }
    // Of the nodes so many places before the segments' first ones; where there is none, of the line's first one.
    StateLanes<N> states_before(size_t by, size_t l) const {
        double x[N], v[N];
        for (size_t k = 0; k < kSegments; ++k) {
            const size_t node = segments.head + k * segments.length;
            const StateLanes<1> there = state(node < by ? 0 : node - by, l);
            x[k] = there.x.v, v[k] = there.v.v;
        }
        return {L::load(x), L::load(v)};
    }

    // ---- what nodes do, and what joins them -------------------------------------------------------------------------

    // Alone. row: of the coefficients. force, target: where these act.
    template <int K>
    Lanes<K> own(const StateLanes<K>& here, size_t row, const Lanes<K>& force, const Lanes<K>& target, size_t l) const {
        const auto gain = [row](const double* of) { return Lanes<K>::load(of + row); };
        Lanes<K> sum = gravity[l] * gain(c.gains.gravity);
        if (!kPlain && c.gains.force) sum = sum + gain(c.gains.force) * force;
        if (!kPlain && c.gains.drag) sum = sum - gain(c.gains.drag) * here.v;
        if (!kPlain && c.gains.attach) sum = sum - gain(c.gains.attach) * (here.x - target);
        return (kPlain ? here.v : (1 - stage.of_change) * here.v) + sum;
    }
    // What a spring wishes that is so far open, or a bend that turns so much.
    template <int K> Lanes<K> wish(const StateLanes<K>& open) const {
        if (kPlain) return stage.closing_rate * open.x;
        return stage.closing_rate * open.x + stage.of_change * open.v;
    }
    // The mean over some nodes of what each would do alone: exactly that, if all would do the same.
    void make_guesses() {
        const size_t nodes = nodes_from(0);
        Nodes x, v, force, target;
        const auto load = [&](const StateNumbers& of, L* out) {
            of.stored([&](const auto* numbers) { load_numbers(numbers + at_node(0), stride(), nodes * count(), out); });
        };
        load(lines.velocity, v);
        if (!kPlain) load(lines.position, x);
        if (!kPlain && c.gains.force) load(lines.force, force);
        if (!kPlain && c.gains.attach) load(lines.target, target);
        for (size_t l = 0; l < count(); ++l) {
            gravity[l] = stage.gravity[l % lines.components];
            const auto alone = [&](size_t i) {
                const size_t m = i * count() + l;
                return own(begin(kPlain ? v[m] : x[m], v[m], scratch(i, l)), N * i, force[m], target[m], l);
            };
            double one[N], excess[N];
            alone(0).store(one);
            L sum{};
            for (size_t i = 0; i < nodes; ++i) sum = sum + 1.0 / double(N * N) * (alone(i) - L::splat(one[0]));
            sum.store(excess);
            guess[l] = one[0];
            for (double part : excess) guess[l] += part;
        }
    }

    // ---- going right ------------------------------------------------------------------------------------------------

    // A line on its way. gap: from the node before the left one to that.
    struct Right {
        StateLanes<N> left, gap;
        L u, d;
    };

    void go_right() {
        make_guesses();
        Right going[kMost];
        for (size_t l = 0; l < count(); ++l) {
            const StateLanes<N> left = states_before(1, l);
            going[l] = {left, difference(states_before(2, l), left), L::splat(guess[l]), L{}};
        }
        Nodes x, v, force, target;
        for (size_t j = 0, nodes; j < segments.length; j += nodes) {
            nodes = nodes_from(j);
            load_nodes(lines.position, j, nodes, x);
            load_nodes(lines.velocity, j, nodes, v);
            if (!kPlain && c.gains.force) load_nodes(lines.force, j, nodes, force);
            if (!kPlain && c.gains.attach) load_nodes(lines.target, j, nodes, target);
            if (fetches && j + 3 * N <= segments.length)
                for (const double* row : {c.keep, c.close, c.turn, c.lever, c.follow, c.gains.gravity})
                    fetch_tile(row + N * (j + 2 * N));
            for (size_t l = 0; l < count(); ++l) tile_right(going[l], j, nodes, l, x + l, v + l, force + l, target + l);
        }
        for (size_t l = 0; l < count(); ++l) going[l].u.store(last[l].value), going[l].d.store(last[l].slope);
    }
    // The nodes of a tile, one line after the other. What goes from node to node has a name for each register: GCC 12
    // leaves a copy of the structure in memory.
    CD_INLINED void tile_right(Right& line, size_t j, size_t nodes, size_t l, const L* x, const L* v, const L* force,
                               const L* target) const {
        L x_left = line.left.x, v_left = line.left.v, x_gap = line.gap.x, v_gap = line.gap.v, u = line.u, d = line.d;
        const LaneRows rows(c);
        const size_t step = count(), tile = scratch(j, l);
        for (size_t i = 0; i < nodes; ++i) {
            const size_t m = i * step, at = tile + i * N;
            const StateLanes<N> here = begin(x[m], v[m], at), into = difference<N>({x_left, v_left}, here);
            const L held = d + wish(difference<N>(into, {x_gap, v_gap}));
            rod_reach(rows, j + i, held, wish(into), own(here, N * (j + i), force[m], target[m], l), u, d);
            held.store(hold + at), u.store(value + at), d.store(slope + at);
            x_left = here.x, v_left = here.v, x_gap = into.x, v_gap = into.v;
        }
        line.left = {x_left, v_left}, line.gap = {x_gap, v_gap};
        line.u = settled(u, Limits<double>::least), line.d = settled(d, Limits<double>::least);
    }
    // The head: nodes that the segments leave over, one after the other. u, d: of its last one.
    void head_right(size_t l, One& u, One& d) const {
        StateLanes<1> left = state(0, l), gap{};
        u = {guess[l]}, d = {};
        for (size_t i = 0; i < segments.head; ++i) {
            const StateLanes<1> here = state(i, l);
            const size_t row = segments.place(i), at = i * count() + l, to = scratch_of(i, l);
            const One force{c.gains.force ? lines.force[at] : 0};
            const One target{c.gains.attach ? lines.target[at] : 0};
            const StateLanes<1> into = difference(left, here);
            const One held = d + wish(difference(into, gap));
            rod_reach(c, row, held, wish(into), own(here, row, force, target, l), u, d);
            held.store(hold + to), u.store(value + to), d.store(slope + to);
            left = here, gap = into;
        }
    }

    // ---- going left; answers replace what u rested at ---------------------------------------------------------------

    struct Left {
        L answer, d, held;
    };

    void go_left() {
        Left going[kMost];
        for (size_t l = 0; l < count(); ++l) {
            // What the bend at a segment's last node holds: its wish is what the next one began with.
            double wish_there[N] = {};
            for (size_t k = 0; k + 1 < kSegments; ++k) wish_there[k] = hold[scratch(0, l) + k + 1];
            going[l] = {L::splat(guess[l]), L{}, L::load(last[l].slope) + L::load(wish_there)};
        }
        for (size_t end = segments.length, nodes; end > 0; end -= nodes) {
            nodes = end % N ? end % N : size_t(N);
            if (fetches && end - nodes >= 2 * N) {
                const size_t j = end - nodes - 2 * N;
                for (const double* row : {c.lean, c.bend}) fetch_tile(row + N * j);
                for (const double* tile : {value, slope, hold}) fetch_tile(tile + scratch(j, 0), N * N * count());
            }
            for (size_t l = 0; l < count(); ++l) tile_left(going[l], end - nodes, nodes, l);
        }
        for (size_t l = 0; l < count(); ++l) going[l].answer.store(first[l].value), going[l].d.store(first[l].slope);
    }
    CD_INLINED void tile_left(Left& line, size_t j, size_t nodes, size_t l) const {
        L answer = line.answer, d = line.d, held = line.held;
        const LaneRows rows(c);
        const size_t tile = scratch(j, l);
        for (size_t i = j + nodes; i-- > j;) {
            const size_t at = tile + (i - j) * N;
            const L u_here = L::load(value + at), d_here = L::load(slope + at);
            answer = by_sign(rows.lean[i], u_here, answer - d);
            d = rod_leave(rows, i, answer, u_here, d_here, d - held);
            held = L::load(hold + at);
            answer.store(value + at);
        }
        line.answer = settled(answer, Limits<double>::least), line.d = settled(d, Limits<double>::least);
        line.held = held;
    }
    void head_left(size_t l) const {
        if (segments.head == 0) return;
        One answer{first[l].value[0]}, d{first[l].slope[0]};
        One held = One{before[l].slope[0]} + One{hold[scratch_of(segments.head, l)]};
        for (size_t i = segments.head; i-- > 0;) {
            const size_t row = segments.place(i), at = scratch_of(i, l);
            const One u_here{value[at]}, d_here{slope[at]};
            answer = by_sign(One{c.lean[row]}, u_here, answer - d);
            d = rod_leave(c, row, answer, u_here, d_here, d - held);
            held = One{hold[at]};
            answer.store(value + at);
        }
    }

    // ---- what was missing -------------------------------------------------------------------------------------------

    // From the heads' (u, d), what the nodes beside the segments miss, and the true answers at the first nodes.
    void join(One* u, One* d) {
        const auto small = [](One a) { return settled(a, Limits<double>::least).v; };
        for (size_t k = 0; k < kSegments; ++k) {
            const auto& reach = c.segment[k].reach;
            for (size_t l = 0; l < count(); ++l) {
                const double a = before[l].value[k] = small(u[l] - One{guess[l]});
                const double b = before[l].slope[k] = small(d[l]);
                u[l].v = last[l].value[k] + (reach[0][0] * a + reach[0][1] * b);
                d[l].v = last[l].slope[k] + (reach[1][0] * a + reach[1][1] * b);
            }
        }
        for (size_t l = 0; l < count(); ++l) u[l].v = guess[l], d[l].v = 0;
        for (size_t k = kSegments; k-- > 0;) {
            const auto& reply = c.segment[k].reply;
            for (size_t l = 0; l < count(); ++l) {
                const double a = before[l].value[k], b = before[l].slope[k];
                const double e = after[l].value[k] = small(u[l] - One{guess[l]});
                const double f = after[l].slope[k] = small(d[l]);
                u[l].v =
                    (first[l].value[k] + (reply[0][0] * a + reply[0][1] * b)) + (reply[0][2] * e + reply[0][3] * f);
                d[l].v =
                    (first[l].slope[k] + (reply[1][0] * a + reply[1][1] * b)) + (reply[1][2] * e + reply[1][3] * f);
            }
        }
        for (size_t l = 0; l < count(); ++l) first[l].value[0] = u[l].v, first[l].slope[0] = d[l].v;
    }
    // The open line's answer.
    double answer_at(size_t node, size_t l) const {
        const double alone = value[scratch_of(node, l)];
        if (node < segments.head) return alone;
        const size_t row = segments.place(node), k = row % N;
        return (alone + (c.influence[0][row] * before[l].value[k] + c.influence[1][row] * before[l].slope[k])) +
               (c.influence[2][row] * after[l].value[k] + c.influence[3][row] * after[l].slope[k]);
    }
    void close_ring(size_t l) {
        const size_t z = lines.nodes - 1, nodes[4] = {z - 1, z, 0, 1};
        One x[4], w[4], force[3];
        for (int k = 0; k < 4; ++k) {
            const StateLanes<1> here = state(nodes[k], l);
            x[k] = here.x;
            w[k] = One{answer_at(nodes[k], l)} + stage.of_change * here.v;
        }
        ring_forces<1>(ring, stage, x, w, force);
        for (int r = 0; r < ring.constraints; ++r) pull[l][r] = force[r].v;
    }

    bool finish() {
        const StoredRange range = lines.position.range();
        Nodes x, v;
        L probe{};
        for (size_t j = 0, nodes; j < segments.length; j += nodes) {
            nodes = nodes_from(j);
            load_nodes(lines.position, j, nodes, x);
            load_nodes(lines.velocity, j, nodes, v);
            if (fetches && j + 3 * N <= segments.length) {
                for (const double* row : c.influence) fetch_tile(row + N * (j + 2 * N));
                fetch_tile(value + scratch(j + 2 * N, 0), N * N * count());
            }
            for (size_t l = 0; l < count(); ++l) probe = probe + move_tile(j, nodes, l, range, x + l, v + l);
            if (!kPlain && keep) continue;
            store_nodes(x, lines.position, j, nodes);
            store_nodes(v, lines.velocity, j, nodes);
        }
        return !probe.any_nan();
    }
    // The nodes of a tile of one line move, unless `value` keeps what they would move by. NaN if one moves too far.
    CD_INLINED L move_tile(size_t j, size_t nodes, size_t l, const StoredRange& range, L* x, L* v) const {
        const L u = L::load(before[l].value), d = L::load(before[l].slope);
        const L next = L::load(after[l].value), into_next = L::load(after[l].slope);
        const LaneRow by[4] = {{c.influence[0]}, {c.influence[1]}, {c.influence[2]}, {c.influence[3]}};
        const size_t step = count(), tile = scratch(j, l);
        L probe{};
        for (size_t i = 0; i < nodes; ++i) {
            const size_t m = i * step, at = tile + i * N;
            const StateLanes<N> here = begin(x[m], v[m], at);
            L answer = (L::load(value + at) + (by[0][j + i] * u + by[1][j + i] * d)) +
                       (by[2][j + i] * next + by[3][j + i] * into_next);
            for (int r = 0; !kPlain && r < ring.constraints; ++r)
                answer = answer + pull[l][r] * LaneRow{ring.response[r]}[j + i];
            const L w = kPlain ? answer : answer + stage.of_change * here.v;
            const L change = kPlain ? w - here.v : answer - (1 - stage.of_change) * here.v;
            if (!kPlain && keep) {
                w.store(value + at);
                continue;
            }
            v[m] = settle_and_probe(w + stage.overshoot * change, range, probe);
            x[m] = settle_and_probe(here.x + stage.move * w, range, probe);
        }
        return probe;
    }
    bool finish_head(size_t l) const {
        One probe{};
        for (size_t i = 0; i < segments.head; ++i) {
            const size_t at = i * count() + l, from = scratch_of(i, l);
            One answer{value[from]};
            for (int r = 0; r < ring.constraints; ++r)
                answer = answer + One{pull[l][r] * ring.response[r][segments.place(i)]};
            double* const row = keep ? value + (ptrdiff_t(from) - ptrdiff_t(at)) : nullptr;
            end_stage(lines, stage, state(i, l), answer, row, at, probe);
        }
        return !probe.any_nan();
    }

    bool run() {
        go_right();
        go_left();
        One u[kMost], d[kMost];
        for (size_t l = 0; l < count(); ++l) head_right(l, u[l], d[l]);
        join(u, d);
        for (size_t l = 0; l < count(); ++l) {
            head_left(l);
            if (!kPlain && ring.constraints > 0) close_ring(l);
        }
        bool finite = true;
        for (size_t l = 0; l < count(); ++l) finite &= finish_head(l);
        return finish() && finite;
    }
};

} // namespace

bool segment_rod_step(const Lines& lines, const SegmentRodCoefficients& c, const Stage& stage, const Start& start,
                      const RingClosure& ring, double* value, double* slope, double* hold, bool keep) {
    const bool plain = !c.gains.force && !c.gains.drag && !c.gains.attach && !start.w && !keep &&
                       stage.of_change == 0 && ring.constraints == 0;
    if (plain && lines.pitch == 1)
        return Sweep<true, true>{lines, c, stage, start, ring, value, slope, hold, keep}.run();
    if (plain) return Sweep<false, true>{lines, c, stage, start, ring, value, slope, hold, keep}.run();
    return Sweep<false, false>{lines, c, stage, start, ring, value, slope, hold, keep}.run();
}

} // namespace CD_ISA
} // namespace cd
