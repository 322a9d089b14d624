// Springs in series and in parallel, for stiffnesses from 0 to infinity: the only arithmetic of the line solvers'
// factorizations. Nothing is subtracted, so nothing is lost, however far apart the numbers are.
#pragma once

#include <stdint.h>
#include <string.h>

namespace cd {

// a / (a + b): how much of a point between two springs belongs to a. 0 where both are 0 or both infinite.
[[gnu::noinline]] inline double share(double a, double b) {
    if (a == b) return a - a == 0 && a > 0 ? 0.5 : 0.0;
    return a < b ? (a / b) / (1 + a / b) : 1 / (1 + b / a);
}

// The same as a fraction for between() (kernel/lanes.hh): a share above 1/2 as that of b, with its sign bit set. A
// stiffness of -0 is one of 0, and its share not to be taken for the whole.
[[gnu::noinline]] inline double fraction(double a, double b) { return a <= b ? share(a, b) + 0.0 : -share(b, a); }

// As it is stored: +0 and -0 are not the same fraction.
inline uint64_t bits_of(double f) {
    uint64_t bits;
    memcpy(&bits, &f, sizeof bits);
    return bits;
}

// What such a fraction stands for, and what it leaves of 1.
inline double of_fraction(double f) { return __builtin_signbit(f) ? 1 + f : f; }
inline double rest_of_fraction(double f) { return __builtin_signbit(f) ? -f : 1 - f; }

// a b / (a + b): the stiffness of two springs one behind the other.
[[gnu::noinline]] inline double series(double a, double b) {
    if (a == b) return a / 2;
    return a < b ? a / (1 + a / b) : b / (1 + b / a);
}

} // namespace cd
