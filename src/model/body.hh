// What chain and membrane have in common: nodes with masses, held together by springs and advanced in time.
#pragma once

#include <initializer_list>

#include "kernel/collider.hh"
#include "model/life.hh"
#include "model/object.hh"

namespace cd {

struct BodySettings : ObjectSettings {
    cd_mass_rule mass_rule;
    double mass, drag, damping, gravity[4];
    double sleep_speed, sleep_seconds; // see model/sleep.hh; both 0: no part may sleep
};

// The air around ropes and cloth.
struct AirSettings {
    double along = 0, across = 0; // what it resists: of ropes per length [N s/m^2], of cloth per area [N s/m^3]
    double wind[3] = {};          // [m/s]

    bool resists() const { return along > 0 || across > 0; }
    bool operator==(const AirSettings& o) const {
        return along == o.along && across == o.across && wind[0] == o.wind[0] && wind[1] == o.wind[1] &&
               wind[2] == o.wind[2];
    }
};

struct Body : Object, BodySettings {
    size_t components, nodes;

    // fields, empty where switched off: per node
    Array<double> node_mass, attach_stiffness, attach_damping;
    Array<uint8_t> pin;
    // and per node and component, in the object's precision and layout; position and velocity are always there
    Array<char> position, velocity, force, target, wind;

    Array<double> colliders;      // each a Collider
    Array<double> beds;           // of each CD_SHAPE_BED, in their order: columns, rows, heights
    Array<double> loads;          // of each part that may sleep: what it did to each collider in its last step,
                                  // kLoadNumbers each; empty where that is not told, else room for one at least
    Array<cd_distance> callbacks; // no state: of each collider, without a function where none is set
    BadAnswer bad_answer;         // of a callback, in the last call of step
};

inline double tie_of(const Body& b, size_t node) { return b.attach_stiffness ? b.attach_stiffness[node] : 0; }
inline double tie_damping_of(const Body& b, size_t node) { return b.attach_damping ? b.attach_damping[node] : 0; }

// Gives a number of a posed node the velocity that brings it to its target in `seconds`.
inline void pose(Body& b, size_t at, double seconds) {
    set_number(b, b.velocity, at, (get_number(b, b.target, at) - get_number(b, b.position, at)) / seconds);
}
// After that it is there, whatever rounding its steps went by: else it would never come to rest.
inline void arrive(Body& b, size_t at) { set_number(b, b.position, at, get_number(b, b.target, at)); }

// X: a body with a layout_of.
template <class X> bool all_finite(const X& x) {
    bool finite = true;
    for (const Array<char>* array : {&x.position, &x.velocity})
        each_number(x, layout_of(x), *array, [&](auto number) { finite &= isfinite(number) != 0; });
    return finite;
}

// ---- what ropes and cloth touch -------------------------------------------------------------------------------------

constexpr size_t kMostColliders = 4096;
constexpr size_t kColliderNumbers = sizeof(Collider) / sizeof(double);

inline size_t collider_count(const Body& b) {
    return CD_WITH_CONTACT && (CD_WITH_ROPE || CD_WITH_CLOTH) ? b.colliders.count / kColliderNumbers : 0;
}
inline Collider& collider(const Body& b, size_t index) { return reinterpret_cast<Collider*>(b.colliders.data)[index]; }

// A bed among a body's beds.
constexpr size_t kBedHead = 2;
struct Bed {
    double* at = nullptr; // null: none

    explicit operator bool() const { return at != nullptr; }
    size_t columns() const { return size_t(at[0]); }
    size_t rows() const { return size_t(at[1]); }
    double* heights() const { return at + kBedHead; }
    size_t numbers() const { return at ? kBedHead + columns() * rows() : 0; }
};

// f(collider, its bed) for the first `count` colliders; tells how many numbers all their beds have.
template <class F> size_t each_collider(const Body& b, size_t count, F f) {
    size_t numbers = 0;
    for (size_t i = 0; i < count; ++i) {
        const Collider& it = collider(b, i);
        const Bed bed = it.shape == CD_SHAPE_BED ? Bed{b.beds.data + numbers} : Bed();
        f(it, bed);
        numbers += bed.numbers();
    }
    return numbers;
}
inline size_t bed_numbers(const Body& b, size_t count) {
    return each_collider(b, count, [](const Collider&, Bed) {});
}
inline Bed bed_of(const Body& b, size_t index) {
    return collider(b, index).shape == CD_SHAPE_BED ? Bed{b.beds.data + bed_numbers(b, index)} : Bed();
}

// f(obstacle) for each collider that is not CD_SHAPE_NONE, thicker by the thickness of what touches it.
template <class F> void each_obstacle(const Body& b, double thickness, F f) {
    size_t questions = 0;
    each_collider(b, collider_count(b), [&](const Collider& it, Bed bed) {
        if (it.shape == CD_SHAPE_NONE) return;
        const size_t index = size_t(&it - &collider(b, 0));
        Obstacle to{it, index, 0, 0, nullptr, nullptr, 0};
        to.radius += thickness;
        if (bed) to.columns = bed.columns(), to.rows = bed.rows(), to.heights = bed.heights();
        if (it.shape == CD_SHAPE_CALLBACK) to.callback = &b.callbacks[index], to.question = questions++;
        f(to);
    });
}

// The memory that the first `count` colliders take.
struct ColliderSizes {
    size_t count, beds, callbacks; // numbers of all beds; how many are CD_SHAPE_CALLBACK
};
inline ColliderSizes collider_sizes(const Body& b, size_t count) {
    size_t callbacks = 0;
    const size_t beds =
        each_collider(b, count, [&](const Collider& it, Bed) { callbacks += it.shape == CD_SHAPE_CALLBACK; });
    return {count, beds, callbacks};
}

// How many numbers tell what so many colliders bear; SIZE_MAX: more than there is.
inline size_t load_numbers(size_t count, size_t parts) {
    size_t numbers;
    return multiply((count > 0 ? count : 1) * kLoadNumbers, parts, numbers) ? numbers : SIZE_MAX;
}
// What all parts do to a collider (sleep.cpp).
void sum_loads(const Body& b, size_t index, double* out);
inline void clear_loads(const Body& b) {
    if (b.loads) memset(b.loads.data, 0, b.loads.bytes());
}

// A collider by callback that has none, as after a load; or SIZE_MAX.
inline size_t unanswered(const Body& b) {
    for (size_t i = 0; i < collider_count(b); ++i)
        if (collider(b, i).shape == CD_SHAPE_CALLBACK && !b.callbacks[i].distance) return i;
    return SIZE_MAX;
}
// What is no longer CD_SHAPE_CALLBACK has no callback.
inline void forget_callbacks(Body& b) {
    for (size_t i = 0; i < b.callbacks.count; ++i)
        if (collider(b, i).shape != CD_SHAPE_CALLBACK) b.callbacks[i] = {};
}
inline void forget_callbacks(Object&) {}

// Colliders stay where they are when time begins anew.
inline void stop_clocks(Body& b) {
    const double now = b.clock.time();
    for (size_t i = 0; i < collider_count(b); ++i) {
        Collider& of = collider(b, i);
        for (int k = 0; k < 3; ++k) of.point[k] = of.place(k, now);
        of.since = 0;
    }
}

// ---- state and memory -----------------------------------------------------------------------------------------------

// Positions, velocities and time back to 0.
inline void clear_state(Body& b) {
    stop_clocks(b);
    memset(b.position.data, 0, b.position.bytes());
    memset(b.velocity.data, 0, b.velocity.bytes());
    clear_loads(b);
    b.clock = {};
    wake(b);
}

// What costs memory, in one value, so that features change all together or not at all.
struct BodyFeatures {
    cd_method method;
    bool node_mass, force, target, bend, air, wind, sleep, loads;
    ColliderSizes colliders;
};

// What of these features this build leaves out, or null. Every object adds its own.
inline const char* left_out(const BodyFeatures& f) {
    if (!CD_WITH_BEND && f.bend) return "bend is";
    if (!CD_WITH_CONTACT && (f.colliders.count > 0 || f.loads)) return "colliders are";
    if (!CD_WITH_SLEEP && f.sleep) return "sleep is";
    return nullptr;
}

// The memory that such features change.
struct BodyChanges : Changes {
    Change mass, attach_stiffness, attach_damping, coefficients, scratch, colliders, beds, callbacks, loads, calm,
        force, target, wind;

    // numbers: of a field that has one per node, or one per node and strand; parts: that may sleep
    BodyChanges(Body& b, const BodyFeatures& wanted, size_t numbers, size_t parts, size_t coefficients_needed,
                size_t scratch_needed)
        : mass{*this, b.node_mass, wanted.node_mass ? numbers : 0},
          attach_stiffness{*this, b.attach_stiffness, wanted.target ? numbers : 0},
          attach_damping{*this, b.attach_damping, wanted.target ? numbers : 0},
          coefficients{*this, b.coefficients, coefficients_needed},
          scratch{*this, b.scratch, scratch_needed},
          colliders{*this, b.colliders, wanted.colliders.count * kColliderNumbers},
          beds{*this, b.beds, wanted.colliders.beds},
          callbacks{*this, b.callbacks, wanted.colliders.callbacks > 0 ? wanted.colliders.count : 0},
          loads{*this, b.loads, wanted.loads ? load_numbers(wanted.colliders.count, parts) : 0},
          calm{*this, b.calm, wanted.sleep ? parts : 0},
          force{*this, b.force, wanted.force ? b.position.count : 0},
          target{*this, b.target, wanted.target ? b.position.count : 0},
          wind{*this, b.wind, wanted.wind ? b.position.count : 0} {}

    // Before they are put: what there is of colliders stays.
    void carry_over() const {
        if (CD_WITH_CONTACT) colliders.carry_over(), beds.carry_over(), callbacks.carry_over();
    }
    // A new target is the present position. New masses and winds are for the object to fill.
    void fill(Body& b) const {
        if (target.is_new()) memcpy(b.target.data, b.position.data, b.target.count);
        if (loads.is_new()) clear_loads(b);
    }
};

// A body as `start` has it, with positions and velocities of `state_bytes` each and what its features need, or null.
template <class X> X* make(X& start, uint64_t tag, size_t state_bytes) {
    if (allocate(start.memory, state_bytes, start.position) && allocate(start.memory, state_bytes, start.velocity))
        return make(start, tag);
    release_arrays(start);
    return nullptr;
}

} // namespace cd
