#include "model/sleep.hh"

#include "base/sum.hh"

namespace cd {

// Planes and capsules by the distance that is left at the step's end; beds, whose distances are of first order only,
// and callbacks are always near.
bool Surroundings::may_touch(const Obstacle& it, const double* x) const {
    if (!it.is_convex()) return true;
    double from[3], along = 0, length = 0, gap = 0, speed = 0;
    for (int k = 0; k < 3; ++k) {
        from[k] = x[k] - it.place(k, time);
        along += from[k] * it.way[k], length += it.way[k] * it.way[k], speed += it.velocity[k] * it.velocity[k];
    }
    if (it.shape == CD_SHAPE_PLANE) {
        gap = along;
    } else {
        const double share = length > 0 ? fmax(0, fmin(1, along / length)) : 0;
        for (int k = 0; k < 3; ++k) gap += (from[k] - share * it.way[k]) * (from[k] - share * it.way[k]);
        gap = sqrt(gap);
    }
    return !(gap - it.radius > sqrt(speed) * dt);
}

__attribute__((cold)) void sum_loads(const Body& b, size_t index, double* out) {
    const size_t of_part = load_numbers(collider_count(b), 1);
    for (size_t k = 0; k < kLoadNumbers; ++k) {
        Sum sum;
        for (size_t at = index * kLoadNumbers + k; at < b.loads.count; at += of_part) sum.add(b.loads[at]);
        out[k] = sum.value();
    }
}

} // namespace cd
