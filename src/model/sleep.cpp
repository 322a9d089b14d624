#include "model/sleep.hh"

#include <math.h>

#include "base/sum.hh"

namespace cd {

Surroundings::Surroundings(const Body& body, double thickness_, double dt_, double time_)
    : b(body), thickness(thickness_), dt(dt_), time(time_) {
    each_obstacle(b, thickness, [&](const Obstacle& it) { active |= is_active(it); });
}

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

bool Surroundings::keep_awake(const SleepingPart& part) const {
    if (!active) return false;
    bool touched = false;
    each_obstacle(b, thickness, [&](const Obstacle& it) {
        if (touched || !is_active(it)) return;
        touched = !part.all([&](size_t, size_t at) {
            double x[3] = {};
            for (size_t k = 0; k < b.components; ++k) x[k] = get_number(b, b.position, at + k * part.step);
            return !may_touch(it, x);
        });
    });
    return touched;
}

static bool is_slow(const Body& b, const SleepingPart& part) {
    const double most = b.sleep_speed * b.sleep_speed;
    return part.all([&](size_t i, size_t at) {
        double square = 0;
        for (size_t k = 0; k < b.components; ++k) {
            const double v = get_number(b, b.velocity, at + k * part.step);
            square += v * v;
        }
        return square == 0 || (square <= most && !part.held(b, part, i));
    });
}

void fall_asleep(Body& b, const SleepingPart& part, const Surroundings& around) {
    double& calm = b.calm[part.number];
    if (!is_slow(b, part) || around.keep_awake(part)) {
        calm = kStirred;
        return;
    }
    calm = calm < 0 ? 0 : fmin(calm + around.dt, b.sleep_seconds);
    if (!sleeps(b, part.number)) return;
    part.all([&](size_t, size_t at) {
        for (size_t k = 0; k < b.components; ++k) set_number(b, b.velocity, at + k * part.step, 0);
        return true;
    });
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
