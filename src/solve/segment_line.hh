// A long line in segments, for lanes: series-spring elimination (spring_line.hh) of eight parts side by side.
//
//      head       segment 0         segment 1     ...     segment 7
//      o-o-o   o-o-o-o-o-o-o-o   o-o-o-o-o-o-o-o       o-o-o-o-o-o-o-o
//
// Going right every segment starts at once, as if the one before it left it at 0. What is missing then is as much of
// the true start as the carries let through,
//      y_j = y'_j + reach_j start,        reach_j = carry_0 ... carry_j,
// so the last nodes, one after the other, tell the true starts. (A better guess than 0, such as what the first node
// would do by itself, leaves its rounding in all that follows: 50 times the error of a stiff random state in float64.)
// Going left, a segment's first node would follow
//      w_0 = sum over its nodes of weight_j (y_j - F_j)  +  pass (w_next - F_next),
//      weight_j = pull_0 ... pull_{j-1} (1 - pull_j),    pass = pull_0 ... pull_last,
// with F_j what the springs between it and node j wish in all. The sum is gathered while going right; of the start it
// takes up `reply`. One after the other, from the right, the first nodes are then known, and all segments go left at
// once. Weights, reaches and passes are products and sums of what lies in [0, 1], all blends stay blends, and with
// kSegments fixed the result is the same whatever number of lanes a register holds. (model.md, 16 and 17)
#pragma once

#include "kernel/segment_sweep.hh"
#include "solve/spring_line.hh"

namespace cd {

struct SegmentRows { // one number per node, where Segments says
    double *carry, *pull, *share, *reach;
    double *reply, *pass; // one per segment
};

// The places of nodes that are asked for in turn: as Segments says, or in the nodes' order, as if all were the head. One
// text of each factorization serves both.
struct PlacesInTurn {
    const size_t length, head;
    size_t k = 0, j = 0; // the segment, and the node in it, that come next

    explicit PlacesInTurn(const Segments& segments) : length(segments.length), head(segments.head) {}
    explicit PlacesInTurn(size_t nodes) : length(0), head(nodes) {}

    size_t operator()(size_t node) {
        if (node < head) return kSegments * length + node;
        const size_t at = kSegments * j + k;
        if (++j == length) j = 0, ++k;
        return at;
    }
};

// So many segments are factored side by side: two registers of SSE2, more have to be taken to memory and back.
constexpr int kSegmentsTogether = 4;

// For gains see factor_spring_line.
template <class System, class Gains>
void factor_segment_line(size_t nodes, const System& system, const SegmentRows& out, Gains gains) {
    const Segments segments(nodes);
    factor_spring_line(nodes, system, PlacesInTurn(segments), out.carry, out.pull, gains);
    out.pull[segments.place(nodes - 1)] = 0;

    // Numbers as small as that do not matter, and could make subnormal ones.
    constexpr double kLeast = 0x1p-400;
    using L = Lanes<kSegmentsTogether>;
    for (size_t k = 0; k < kSegments; k += kSegmentsTogether) {
        const L one = L::splat(1);
        L reach = one, left = one, gathered{}, reply{}; // left: the weight of all that is further right
        for (size_t at = k; at < kSegments * segments.length; at += kSegments) {
            // A fraction with its sign bit set stands for 1 more.
            const L carry = L::load(out.carry + at), pull = L::load(out.pull + at);
            const L of_carry = by_sign(carry, one, L{}), of_pull = by_sign(pull, one, L{});
            reach = settled(reach * (carry + of_carry), kLeast);
            const L weight = settled(left * ((one - of_pull) - pull), kLeast);
            left = settled(left * (pull + of_pull), kLeast);
            const L share = Beside<kSegmentsTogether>(weight, gathered).fraction();
            reply = between(reply, reach, L{}, share);
            gathered = gathered + weight;
            reach.store(out.reach + at), share.store(out.share + at);
        }
        reply.store(out.reply + k);
        Beside<kSegmentsTogether>(left, gathered).fraction().store(out.pass + k);
    }
}

} // namespace cd
