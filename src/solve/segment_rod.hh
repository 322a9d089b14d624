// A long rod in segments, for lanes: the elimination of rod_line.hh of eight parts side by side.
//
// All segments go right at once, each as if the part before it rested at (u, d) = (guess, 0), and left, as if the node
// after it were held at the guess and the difference into it at 0. What is missing then is linear in the misses of
// both, of the true start (u, d) and the true answer (w, d) there,
//      w_j = w'_j + influence_j . (u - guess, d, w_next - guess, d_next):
// four numbers per node, found by eliminating with a unit of each and nothing else. The last nodes' (u, d), one segment
// after the other, tell the true starts; the first nodes' (w, d), from the right, the true answers; and a last way adds
// what was missing, all nodes at once. The guess is one for the line, near the mean of what its nodes would do alone: a
// line that moves as one keeps doing so to the bit. With kSegments fixed the result is the same whatever number of
// lanes a register holds.
//
// Nothing that is added is larger than what would have been passed on from node to node: a stiff segment follows its
// neighbours as a rigid body, and in a soft one influences die out within a few nodes.
#pragma once

#include <initializer_list>

#include "kernel/segment_rod.hh"
#include "solve/rod_line.hh"
#include "solve/segment_line.hh"

namespace cd {

struct SegmentRodRows { // one number per node, where Segments says
    RodRows rod;
    double* influence[4];
    RodSegment* segment; // kSegments
};

// Rows of which segments beside each other have their own numbers.
struct RowOfSegments {
    const double* data;
    Lanes<kSegmentsTogether> operator[](size_t at) const { return Lanes<kSegmentsTogether>::load(data + at); }
};
struct RodRowsOfSegments {
    RowOfSegments keep, close, turn, lever, follow, lean, bend;
};

template <class System> void factor_segment_rod(size_t nodes, const System& system, const SegmentRodRows& out) {
    const RodRows& rod = out.rod;
    const Segments segments(nodes);
    const auto place = [&](size_t i) { return segments.place(i); };
    const size_t first = place(0), last = place(nodes - 1);
    for (double* row : {rod.keep, rod.close, rod.turn, rod.lever, rod.follow, rod.lean, rod.bend}) row[first] = 0;
    rod.bend[last] = 0;
    factor_rod_line(nodes, system, rod, PlacesInTurn(segments));
    bool held = false;
    for (size_t i = 0; i < nodes; ++i) {
        if (i == 0 || !system.repeats(i)) held = system.ground(i) - system.ground(i) != 0;
        if (held || i + 1 == nodes) rod.lean[place(i)] = -0.0;
    }

    // Each of the four for itself; two stand on the left. Numbers as small as kLeast do not matter, and could make
    // subnormal ones.
    constexpr double kLeast = 0x1p-400;
    constexpr int N = kSegmentsTogether;
    using L = Lanes<N>;
    const RodRowsOfSegments rows{{rod.keep},   {rod.close}, {rod.turn}, {rod.lever},
                                 {rod.follow}, {rod.lean},  {rod.bend}};
    const size_t end = kSegments * segments.length;
    for (size_t k = 0; k < kSegments; k += N) {
        RodSegment* const segment = out.segment + k;
        const auto store = [](const L& numbers, double* first) {
            double number[N];
            numbers.store(number);
            for (int n = 0; n < N; ++n) first[n * ptrdiff_t(sizeof(RodSegment) / sizeof(double))] = number[n];
        };
        const L zero{}, one = L::splat(1);
        L u[4] = {one, zero}, d[4] = {zero, one};
        for (size_t at = k; at < end; at += kSegments) {
#pragma GCC unroll 2
            for (int s = 0; s < 2; ++s) {
                rod_reach(rows, at, d[s], zero, zero, u[s], d[s]);
                u[s] = settled(u[s], kLeast), d[s] = settled(d[s], kLeast);
                u[s].store(out.influence[s] + at), d[s].store(out.influence[2 + s] + at); // until the way back
            }
        }
        for (int s = 0; s < 2; ++s) store(u[s], &segment->reach[0][s]), store(d[s], &segment->reach[1][s]);

        u[0] = u[1] = u[3] = d[0] = d[1] = d[2] = zero, u[2] = d[3] = one;
        for (size_t at = end - kSegments + k; at < end; at -= kSegments) {
            const L rested[2][4] = {{L::load(out.influence[0] + at), L::load(out.influence[1] + at)},
                                    {L::load(out.influence[2] + at), L::load(out.influence[3] + at)}};
#pragma GCC unroll 4
            for (int s = 0; s < 4; ++s) {
                u[s] = by_sign(rows.lean[at], rested[0][s], u[s] - d[s]);
                d[s] = rod_leave(rows, at, u[s], rested[0][s], rested[1][s], d[s] - rested[1][s]);
                u[s] = settled(u[s], kLeast), d[s] = settled(d[s], kLeast);
                u[s].store(out.influence[s] + at);
            }
        }
        for (int s = 0; s < 4; ++s) store(u[s], &segment->reply[0][s]), store(d[s], &segment->reply[1][s]);
    }
}

} // namespace cd
