// How an impulse at a place of a membrane is spread over the nodes around it: those less than `radius` springs away, by
// the weights (1 - (distance / radius)^2)^2, scaled to sum to 1; where no node is that near, all on the nearest one.
#pragma once

#include "model/membrane.hh"

namespace cd {

struct Spread {
    double at[2], radius, sum;
    size_t first[2], last[2];

    Spread(const Membrane& m, double u, double v, double radius_) : at{u, v}, radius(radius_), sum(0) {
        for (Direction d : {kU, kV}) {
            const double low = at[d] - radius, high = at[d] + radius;
            first[d] = low > 0 ? size_t(low) : 0;
            last[d] = high < double(m.springs[d]) ? size_t(high) : m.springs[d];
        }
        each([&](size_t, size_t, double weight) { sum += weight; });
        if (sum > 0) return;
        for (Direction d : {kU, kV}) at[d] = double(first[d] = last[d] = size_t(at[d] + 0.5));
        radius = sum = 1;
    }

    // f(u, v, weight); weights sum to `sum`
    template <class F> void each(F f) const {
        for (size_t v = first[kV]; v <= last[kV]; ++v)
            for (size_t u = first[kU]; u <= last[kU]; ++u) {
                const double x = (double(u) - at[kU]) / radius, y = (double(v) - at[kV]) / radius;
                const double rest = 1 - (x * x + y * y);
                if (rest > 0) f(u, v, rest * rest);
            }
    }
};

} // namespace cd
