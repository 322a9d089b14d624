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

// Whether something keeps all parts awake: a collider that moves, or that only its callback knows.
inline bool is_kept_awake(const Body& b) {
    bool moves = false;
    each_collider(b, collider_count(b), [&](const Collider& it, Bed) {
        for (double v : it.velocity) moves |= it.shape != CD_SHAPE_NONE && v != 0;
        moves |= it.shape == CD_SHAPE_CALLBACK;
    });
    return moves;
}

// Whether parts may fall asleep in the steps that come next.
inline bool can_fall_asleep(const Body& b) { return CD_WITH_SLEEP && b.calm && !is_kept_awake(b); }

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

// After a step of dt: a part that has been slow for long enough stops, and sleeps.
template <class Part> void fall_asleep(Body& b, const Part& part, double dt) {
    double& calm = b.calm[part.number];
    if (!is_slow(b, part)) {
        calm = kStirred;
        return;
    }
    calm = calm < 0 ? 0 : fmin(calm + dt, b.sleep_seconds);
    for (size_t i = 0; i < part.nodes && sleeps(b, part.number); ++i)
        for (size_t k = 0; k < b.components; ++k) set_number(b, b.velocity, part.place(i) + k * part.step, 0);
}

} // namespace cd
