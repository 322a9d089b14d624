// Bodies that sleep once they have come to rest: see cd_chain_set_sleep. A body consists of parts, of each of which
// `calm` tells for how long it has been slow [s]: ropes of their strands, all else of one.
#pragma once

#include "model/body.hh"

namespace cd {

inline bool sleeps(const Body& b, size_t part) { return CD_WITH_SLEEP && b.calm && b.calm[part] >= b.sleep_seconds; }
inline size_t sleeping_parts(const Body& b) {
    size_t count = 0;
    for (size_t part = 0; part < b.calm.count; ++part) count += sleeps(b, part);
    return count;
}
inline bool may_sleep(const Body& b) { return CD_WITH_SLEEP && b.calm; }

// Whether an obstacle may touch what rests: it moves, or only its callback knows.
inline bool is_active(const Obstacle& it) {
    return it.callback || it.velocity[0] != 0 || it.velocity[1] != 0 || it.velocity[2] != 0;
}

// What is around a body in a step of dt that ends at this time.
struct Surroundings {
    const Body& b;
    double thickness, dt, time;
    bool active = false; // some obstacle is

    Surroundings(const Body& body, double thickness_, double dt_, double time_)
        : b(body), thickness(thickness_), dt(dt_), time(time_) {
        each_obstacle(b, thickness, [&](const Obstacle& it) { active |= is_active(it); });
    }
    // Whether an active obstacle may touch x in the next step, or none can tell.
    bool may_touch(const Obstacle& it, const double* x) const;
    // Whether something keeps a part awake: what only its callback knows, or what moves and comes near.
    template <class Part> bool keep_awake(const Part& part) const {
        if (!active) return false;
        bool touched = false;
        each_obstacle(b, thickness, [&](const Obstacle& it) {
            for (size_t i = 0; is_active(it) && !touched && i < part.nodes; ++i) {
                double x[3] = {};
                for (size_t k = 0; k < b.components; ++k)
                    x[k] = get_number(b, b.position, part.place(i) + k * part.step);
                touched = may_touch(it, x);
            }
        });
        return touched;
    }
};

// Part: one of a body; it has a number and nodes, of which place(i) tells where the first component lies, and held(i)
// whether it is held; components lie `step` numbers apart.
template <class Part> bool is_slow(const Body& b, const Part& part) {
    const double most = b.sleep_speed * b.sleep_speed;
    for (size_t i = 0; i < part.nodes; ++i) {
        double square = 0;
        for (size_t k = 0; k < b.components; ++k) {
            const double v = get_number(b, b.velocity, part.place(i) + k * part.step);
            square += v * v;
        }
        if (!(square <= (part.held(i) ? 0 : most))) return false;
    }
    return true;
}

// Before a step, whether it leaves a part as it is: one that sleeps and that nothing keeps awake.
template <class Part> bool goes_on_sleeping(Body& b, const Part& part, const Surroundings& around) {
    if (!sleeps(b, part.number)) return false;
    if (!around.keep_awake(part)) return true;
    wake(b, part.number, 1);
    return false;
}

// After it: a part that has been slow for long enough stops, and sleeps.
template <class Part> void fall_asleep(Body& b, const Part& part, const Surroundings& around) {
    double& calm = b.calm[part.number];
    if (!is_slow(b, part) || around.keep_awake(part)) {
        calm = kStirred;
        return;
    }
    calm = calm < 0 ? 0 : fmin(calm + around.dt, b.sleep_seconds);
    for (size_t i = 0; i < part.nodes && sleeps(b, part.number); ++i)
        for (size_t k = 0; k < b.components; ++k) set_number(b, b.velocity, part.place(i) + k * part.step, 0);
}

} // namespace cd
