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

// A part of a body that sleeps as a whole. Its nodes lie in rows of `width`: the first components of those of a row
// `column` numbers apart, of those below each other `row`, and a node's components `step`.
struct SleepingPart {
    size_t number, nodes, first, width, row, column, step;
    bool (*held)(const Body& b, const SleepingPart& part, size_t i);

    // f(node, place of its first component), of one node after the other, until one is false: whether none was.
    template <class F> bool all(F f) const {
        for (size_t i = 0, from = first; i < nodes; from += row)
            for (size_t end = i + width, at = from; i < end; ++i, at += column)
                if (!f(i, at)) return false;
        return true;
    }
};

// What is around a body in a step of dt that ends at this time.
struct Surroundings {
    const Body& b;
    double thickness, dt, time;
    bool active = false; // some obstacle is

    Surroundings(const Body& body, double thickness_, double dt_, double time_);
    // Whether an active obstacle may touch x in the next step, or none can tell.
    bool may_touch(const Obstacle& it, const double* x) const;
    // Whether something keeps a part awake: what only its callback knows, or what moves and comes near.
    bool keep_awake(const SleepingPart& part) const;
};

// Before a step, whether it leaves a part as it is: one that sleeps and that nothing keeps awake.
inline bool goes_on_sleeping(Body& b, const SleepingPart& part, const Surroundings& around) {
    if (!sleeps(b, part.number)) return false;
    if (!around.keep_awake(part)) return true;
    wake(b, part.number, 1);
    return false;
}

// After it: a part that has been slow for long enough stops, and sleeps.
void fall_asleep(Body& b, const SleepingPart& part, const Surroundings& around);

} // namespace cd
