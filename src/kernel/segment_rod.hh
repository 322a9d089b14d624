// One implicit stage of a long rod, or ring, cut into eight segments that are swept side by side: the filters of
// solve/segment_rod.hh.
#pragma once

#include "kernel/advance.hh"
#include "kernel/rod_sweep.hh"
#include "kernel/segment_sweep.hh"

namespace cd {

// Of one segment: what becomes of the value, and of the difference, for each of what stands beside it.
struct RodSegment {
    double reach[2][2]; // at its last node going right, from its start's value and difference
    double reply[2][4]; // at its first node, from these and from the next segment's first node
};

struct SegmentRodCoefficients {
    const double *keep, *close, *turn, *lever, *follow; // of RodCoefficients
    const double *lean, *bend; // lean has its sign bit set where nothing on the right counts: at held nodes, at the end
    const double* influence[4]; // on a node, in the order of RodSegment::reply
    const RodSegment* segment;
    NodeGains gains;
};

namespace CD_ISA {

// Like rod_step, of all lines, 1 to 4 with no gaps between nodes; ring: its responses lie as Segments says. value,
// slope, hold: scratch, and what start has to offer, as of segment_sweep.
bool segment_rod_step(const Lines& lines, const SegmentRodCoefficients& c, const Stage& stage, const Start& start,
                      const RingClosure& ring, double* value, double* slope, double* hold, bool keep);

} // namespace CD_ISA
} // namespace cd
