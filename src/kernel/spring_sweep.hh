// One implicit stage of a bundle of lines held together by springs: forward and backward filter of
// solve/spring_line.hh.
#pragma once

#include "kernel/lanes.hh"
#include "kernel/lines.hh"

namespace cd {

struct SpringCoefficients {
    const double* carry;   // how far node i goes over to what hangs on its left, a fraction for between()
    const double* pull;    // how far it follows its right neighbour, likewise
    const double* closing; // 1 for each spring, 0 for a weld; null: 1 for all
    NodeGains gains;
};

namespace CD_ISA {

// Solves lines [first, first + count) from `start` and moves them; with `keep`, leaves w in y instead. y: scratch laid
// out like the positions, not that of start. False if a number left the finite range.
bool spring_sweep(const Lines& lines, const SpringCoefficients& c, const Stage& stage, const Start& start, double* y,
                  bool keep, size_t first, size_t count);

} // namespace CD_ISA
} // namespace cd
