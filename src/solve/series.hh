// Springs in series and in parallel, for stiffnesses from 0 to infinity: the only arithmetic of the line solvers'
// factorizations. Nothing is subtracted, so nothing is lost, however far apart the numbers are.
#pragma once

#include "kernel/lanes.hh"

namespace cd {

// a / (a + b): how much of a point between two springs belongs to a. 0 where both are 0 or both infinite. A stiffness of
// -0 is one of 0, and has a share of 0.
[[gnu::noinline]] inline double share(double a, double b) {
    if (a == b) return a - a == 0 && a > 0 ? 0.5 : 0.0;
    return a < b ? (a / b) / (1 + a / b) + 0.0 : 1 / (1 + b / a);
}

// The same as a fraction for between() (kernel/lanes.hh): a share above 1/2 as that of b, with its sign bit set.
[[gnu::noinline]] inline double fraction(double a, double b) { return a <= b ? share(a, b) : -share(b, a); }

// a b / (a + b): the stiffness of two springs one behind the other.
[[gnu::noinline]] inline double series(double a, double b) {
    if (a == b) return a / 2;
    return a < b ? a / (1 + a / b) : b / (1 + b / a);
}

// Share and series, whose divisors are the same.
struct ShareAndSeries {
    double share, series;
};
inline ShareAndSeries share_and_series(double a, double b) {
    if (a == b) return {share(a, b), a / 2};
    const double ratio = a < b ? a / b : b / a, whole = 1 + ratio;
    return a < b ? ShareAndSeries{ratio / whole + 0.0, a / whole} : ShareAndSeries{1 / whole, b / whole};
}

// Share and fraction of lanes, the same to the bit.
template <int N> struct Beside {
    using L = Lanes<N>;
    static constexpr double kLargest = 1.7976931348623157e308;
    const L excess;       // of a over b
    const L small, large; // of both; the former is finite
    const L ratio, whole; // of the smaller to the larger, 0 where both are 0 or infinite; and 1 more

    Beside(L a, L b)
        : excess(a - b),
          small(smaller(L::splat(kLargest), smaller(a, b))),
          large(larger(b, a)),
          ratio(select(large, small / large, large) + L{}),
          whole(L::splat(1) + ratio) {}

    L share() const { return select(excess, L::splat(1), ratio) / whole; }
    L fraction() const {
        const L less = ratio / whole;
        return select(excess, -1.0 * less, less);
    }
};
// a beside b, and c beside d.
inline Beside<2> beside(double a, double b, double c, double d) {
    const double left[2] = {a, c}, right[2] = {b, d};
    return {Lanes<2>::load(left), Lanes<2>::load(right)};
}

} // namespace cd
