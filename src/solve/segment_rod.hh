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

#include "kernel/segment_rod.hh"
#include "solve/rod_line.hh"
#include "solve/segment_line.hh"

namespace cd {

struct SegmentRodRows { // one number per node, where Segments says
    RodRows rod;
    double* influence[4];
    RodSegment* segment; // kSegments
};

template <class System> void factor_segment_rod(size_t nodes, const System& system, const SegmentRodRows& out) {
    const RodRows& rod = out.rod;
    const Segments segments(nodes);
    const auto place = [&](size_t i) { return segments.place(i); };
    const size_t first = place(0), last = place(nodes - 1);
    for (double* row : {rod.keep, rod.close, rod.turn, rod.lever, rod.follow, rod.lean, rod.bend}) row[first] = 0;
    rod.bend[last] = 0;
    factor_rod_line(nodes, system, rod, PlacesInTurn{segments});
    for (size_t i = 0; i < nodes; ++i)
        if (i + 1 == nodes || system.ground(i) - system.ground(i) != 0) rod.lean[place(i)] = -0.0;

    // A lane for each of the four. Numbers as small as kLeast do not matter, and could make subnormal ones.
    using Four = Lanes<4>;
    constexpr double kLeast = 0x1p-400, units[4][4] = {{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}};
    const size_t end = kSegments * segments.length;
    for (size_t k = 0; k < kSegments; ++k) {
        if (repeats(segments, k, {rod.keep, rod.close, rod.turn, rod.lever, rod.follow, rod.lean, rod.bend})) {
            for (double* row : out.influence)
                for (size_t at = k; at < end; at += kSegments) row[at] = row[at - 1];
            out.segment[k] = out.segment[k - 1];
            continue;
        }
        Four u = Four::load(units[0]), d = Four::load(units[1]);
        double now[2][4] = {};
        for (size_t j = 0; j < segments.length; ++j) {
            const size_t at = kSegments * j + k;
            rod_reach(rod, at, d, Four{}, Four{}, u, d);
            u = settled(u, kLeast), d = settled(d, kLeast);
            u.store(now[0]), d.store(now[1]);
            for (int s = 0; s < 4; ++s) out.influence[s][at] = now[s / 2][s % 2]; // until the way back
        }
        RodSegment& segment = out.segment[k];
        for (int s = 0; s < 4; ++s) segment.reach[s / 2][s % 2] = now[s / 2][s % 2];

        u = Four::load(units[2]), d = Four::load(units[3]);
        for (size_t j = segments.length; j-- > 0;) {
            const size_t at = kSegments * j + k;
            const double rested[2][4] = {{out.influence[0][at], out.influence[1][at]},
                                         {out.influence[2][at], out.influence[3][at]}};
            const Four u_here = Four::load(rested[0]), d_here = Four::load(rested[1]);
            u = __builtin_signbit(rod.lean[at]) ? u_here : u - d;
            d = rod_leave(rod, at, u, u_here, d_here, d - d_here);
            u = settled(u, kLeast), d = settled(d, kLeast);
            u.store(now[0]), d.store(now[1]);
            for (int s = 0; s < 4; ++s) out.influence[s][at] = now[0][s];
        }
        for (int s = 0; s < 4; ++s) segment.reply[0][s] = now[0][s], segment.reply[1][s] = now[1][s];
    }
}

} // namespace cd
