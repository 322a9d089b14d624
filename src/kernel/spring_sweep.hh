// One implicit stage of a bundle of lines held together by springs: forward and backward filter of solve/spring_line.hh.
#pragma once

#include "kernel/lines.hh"

namespace cd {

template <class T> struct SpringCoefficients {
    const T* carry;        // [0, 1]: how much node i takes over of what hangs on its left
    const T* pull;         // [0, 1]: how much node i follows its right neighbour
    const T* closing_rate; // of each spring, 0 for a weld; null: the stage's for all
    NodeGains<T> gains;
};

// Solves and moves lines [first, first + count). y: scratch like the positions. False if a number left the finite range.
template <class T>
bool spring_sweep(const Lines<T>& lines, const SpringCoefficients<T>& c, const Stage<T>& stage, T* y,
                  size_t first, size_t count);

} // namespace cd
