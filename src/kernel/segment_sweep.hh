// One implicit stage of a long line held together by springs, cut into eight segments that are swept side by side: the
// filters of solve/segment_line.hh.
#pragma once

#include "kernel/lanes.hh"
#include "kernel/lines.hh"

namespace cd {

constexpr size_t kSegments = 8;         // whatever the vector width, so that every width gives the same bits
constexpr size_t kMostSegmentLines = 4; // in a chain; more fill the lanes by themselves

// Where node i's coefficients and scratch lie: node j of every segment side by side, and last the head, the few nodes
// on the left that segments of one length leave over.
struct Segments {
    size_t length, head;

    explicit Segments(size_t nodes) : length(nodes / kSegments), head(nodes % kSegments) {}
    size_t place(size_t i) const {
        const size_t k = (i - head) / length, j = (i - head) % length;
        return i < head ? kSegments * length + i : kSegments * j + k;
    }
};

struct SegmentCoefficients {
    const double *carry, *pull; // of SpringCoefficients
    const double* share;        // of a node in what its segment's first one follows, a fraction for between()
    const double* reach;        // how much of the segment's start arrives at the node
    const double *reply, *pass; // of each segment: see solve/segment_line.hh
    NodeGains gains;
};

namespace CD_ISA {

// Like spring_sweep, of all lines, 1 to 4 with no gaps between nodes. y: scratch, and what start has to offer, as
// Segments says, of eight nodes of every segment line by line, and in the head node by node.
bool segment_sweep(const Lines& lines, const SegmentCoefficients& c, const Stage& stage, const Start& start, double* y,
                   bool keep);

} // namespace CD_ISA
} // namespace cd
