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

#include <initializer_list>

#include "kernel/segment_sweep.hh"
#include "solve/spring_line.hh"

namespace cd {

struct SegmentRows { // one number per node, where Segments says
    double *carry, *pull, *share, *reach;
    double *reply, *pass; // one per segment
};

// The places of nodes that are asked for in turn.
struct PlacesInTurn {
    const Segments segments;
    size_t k = 0, j = 0; // the segment, and the node in it, that come next

    size_t operator()(size_t node) {
        if (node < segments.head) return segments.place(node);
        const size_t at = kSegments * j + k;
        if (++j == segments.length) j = 0, ++k;
        return at;
    }
};

// Whether in these rows a segment has the numbers of the one before it, as most have along a uniform line.
inline bool repeats(const Segments& segments, size_t k, std::initializer_list<const double*> rows) {
    if (k == 0) return false;
    for (const double* row : rows)
        for (size_t at = k; at < kSegments * segments.length; at += kSegments)
            if (bits_of(row[at]) != bits_of(row[at - 1])) return false;
    return true;
}

// For gains see factor_spring_line.
template <class System, class Gains>
void factor_segment_line(size_t nodes, const System& system, const SegmentRows& out, Gains gains) {
    const Segments segments(nodes);
    factor_spring_line(nodes, system, PlacesInTurn{segments}, out.carry, out.pull, gains);
    out.pull[segments.place(nodes - 1)] = 0;

    // Numbers as small as that do not matter, and could make subnormal ones.
    const auto product = [](double a, double b) { return a * b < 0x1p-400 ? 0 : a * b; };
    // Segments that repeat the one before are told apart; the others go side by side, for each waits for itself.
    struct Going {
        size_t k;
        double reach = 1, left = 1, gathered = 0, reply = 0; // left: the weight of all that is further right
    } going[kSegments];
    const size_t end = kSegments * segments.length;
    size_t count = 0;
    for (size_t k = 0; k < kSegments; ++k)
        if (!repeats(segments, k, {out.carry, out.pull})) going[count++] = {k};
    for (size_t j = 0; j < segments.length; ++j)
        for (size_t n = 0; n < count; ++n) {
            Going& g = going[n];
            const size_t at = kSegments * j + g.k;
            g.reach = product(g.reach, of_fraction(out.carry[at]));
            const double weight = product(g.left, rest_of_fraction(out.pull[at]));
            g.left = product(g.left, of_fraction(out.pull[at]));
            const double share = fraction(weight, g.gathered);
            g.reply = between(Lanes<1>{g.reply}, Lanes<1>{g.reach}, Lanes<1>{0}, share).v;
            g.gathered += weight;
            out.reach[at] = g.reach, out.share[at] = share;
        }
    for (size_t n = 0; n < count; ++n) {
        const Going& g = going[n];
        const size_t past = n + 1 < count ? going[n + 1].k : kSegments;
        for (size_t k = g.k; k < past; ++k) out.reply[k] = g.reply, out.pass[k] = fraction(g.left, g.gathered);
        for (size_t from = g.k; from < end; from += kSegments)
            for (size_t at = from + 1; at < from - g.k + past; ++at)
                out.reach[at] = out.reach[from], out.share[at] = out.share[from];
    }
}

} // namespace cd
