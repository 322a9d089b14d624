// The explicit limit of a chain: the largest dt at which symplectic Euler is bounded.
//
// With A = dt^2 K and B = dt C, symplectic Euler is M (x'' - 2 x' + x) + B (x' - x) + A x' = 0. Splitting the one-sided
// difference of B into a centred one and half a second difference leaves a leapfrog step with the mass M - B / 2 and
// centred damping, bounded if and only if
//      S(dt) = 4 M - 2 dt C - dt^2 K     is positive definite (model.md, 7),
// (only if: where C is Rayleigh damping; otherwise it is safe, and close). S is tridiagonal, so one elimination tells,
// and bisection finds the dt. Bend enters as stretch: b (d_i - d_{i-1})^2 <= 2 b (d_i^2 + d_{i-1}^2), which the fastest
// mode, a zigzag, makes an equality.
#include <math.h>

#include "model/chain.hh"

namespace cd {

namespace {

struct Elimination {
    const Chain& c;
    double dt;

    size_t next(size_t i) const { return i + 1 < c.nodes ? i + 1 : 0; }
    bool has_spring(size_t i) const { return i < springs_in_all(c); }
    bool joined(size_t i) const { return has_spring(i) && welded(c, i); }
    double coupling(size_t i) const { // of spring i, which is no weld
        if (!has_spring(i)) return 0;
        const double k = stiffness_of(c, i) + 2 * (bend_of(c, i) + bend_of(c, next(i)));
        return (dt * dt + 2 * dt * c.damping) * k;
    }
    double own(size_t i) const { return 4 * mass_of(c, i) - 2 * dt * drag_of(c, i) - dt * dt * tie_of(c, i); }

    // Nodes joined by welds are one unknown. Returns its last node; adds up what is its own.
    size_t unknown(size_t i, size_t& seen, double& sum, bool& is_held) const {
        sum = 0;
        is_held = false;
        for (;; i = next(i)) {
            sum += own(i);
            is_held |= held(c, i);
            if (++seen == c.nodes || !joined(i)) return i;
        }
    }

    // Eliminates the unknowns in turn. The first one of a ring stands back: every other is coupled to it by fill-in,
    // and it comes last.
    bool positive() const {
        size_t start = 0, loose = 0; // of a ring: behind a spring that is no weld; how many of these there are
        for (size_t i = 0; c.ring && i < c.nodes; ++i)
            if (!joined(i)) start = next(i), ++loose;
        const bool one = c.ring && loose < 2; // welds join all nodes: none of their springs stretches
        double left = !c.ring || one ? 0 : coupling(start > 0 ? start - 1 : c.nodes - 1);
        double border = 1, fill = 0, drop = 0; // of the unknown that stands back; of the next unknown
        bool border_held = true;
        for (size_t seen = 0, i = start; seen < c.nodes; i = next(i)) {
            const bool first = seen == 0;
            double sum;
            bool is_held;
            i = unknown(i, seen, sum, is_held);
            const double right = one ? 0 : coupling(i), diagonal = sum - left - right;
            left = right;
            if (c.ring && first) {
                border_held = is_held;
                border = is_held ? 1 : diagonal;
                fill = is_held ? 0 : right;
            } else if (is_held) {
                fill = drop = 0;
            } else {
                const bool closes = c.ring && seen == c.nodes && !border_held;
                const double pivot = diagonal - drop, across = fill + (closes ? right : 0);
                if (!(pivot > 0)) return false;
                border -= across * across / pivot;
                fill = -right * across / pivot;
                drop = right * right / pivot;
            }
        }
        return border > 0;
    }
};

} // namespace

double stable_dt(const Chain& c) {
    constexpr double kShortest = 1e-150, kLongest = 1e150;
    const auto bounded = [&](double dt) { return Elimination{c, dt}.positive(); };
    double low = 1, high = 1;
    if (bounded(1)) {
        while (bounded(high)) {
            if (high > kLongest) return INFINITY;
            low = high;
            high *= 16;
        }
    } else {
        while (low > kShortest && !bounded(low)) {
            high = low;
            low /= 16;
        }
    }
    for (;;) {
        const double middle = low + (high - low) / 2;
        if (middle <= low || middle >= high) return low;
        (bounded(middle) ? low : high) = middle;
    }
}

} // namespace cd
