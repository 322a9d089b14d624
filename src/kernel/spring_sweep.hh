// One implicit stage of a bundle of lines held together by springs: forward and backward filter of solve/spring_line.hh.
#pragma once

#include "kernel/lines.hh"

namespace cd {

template <class T> struct SpringCoefficients {
    const T* carry;   // how far node i goes over to what hangs on its left, a fraction for between()
    const T* pull;    // how far it follows its right neighbour, likewise
    const T* closing; // 1 for each spring, 0 for a weld; null: 1 for all
    NodeGains<T> gains;
};

// Solves and moves lines [first, first + count). y: scratch like the positions. False if a number left the finite range.
template <class T>
bool spring_sweep(const Lines<T>& lines, const SpringCoefficients<T>& c, const Stage<T>& stage, T* y,
                  size_t first, size_t count);

} // namespace cd
