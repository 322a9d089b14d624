// What chain and membrane have in common: nodes with masses, held together by springs and advanced in time.
#pragma once

#include <initializer_list>

#include "model/life.hh"
#include "model/object.hh"

namespace cd {

struct BodySettings : ObjectSettings {
    cd_mass_rule mass_rule;
    double mass, drag, damping, gravity[4];
};

struct Body : Object, BodySettings {
    size_t components, nodes;

    // fields, empty where switched off: per node
    Array<double> node_mass, attach_stiffness, attach_damping;
    Array<uint8_t> pin;
    // and per node and component, in the object's precision and layout; position and velocity are always there
    Array<char> position, velocity, force, target;
};

inline double tie_of(const Body& b, size_t node) { return b.attach_stiffness ? b.attach_stiffness[node] : 0; }
inline double tie_damping_of(const Body& b, size_t node) { return b.attach_damping ? b.attach_damping[node] : 0; }

// Gives a number of a posed node the velocity that brings it to its target in `seconds`.
inline void pose(Body& b, size_t at, double seconds) {
    set_number(b, b.velocity, at, (get_number(b, b.target, at) - get_number(b, b.position, at)) / seconds);
}

// X: a body with a layout_of.
template <class X> bool all_finite(const X& x) {
    bool finite = true;
    for (const Array<char>* array : {&x.position, &x.velocity})
        each_number(x, layout_of(x), *array, [&](auto number) { finite &= isfinite(number) != 0; });
    return finite;
}

// Positions, velocities and time back to 0.
inline void clear_state(Body& b) {
    memset(b.position.data, 0, b.position.bytes());
    memset(b.velocity.data, 0, b.velocity.bytes());
    b.clock = {};
}

// What costs memory, in one value, so that features change all together or not at all.
struct BodyFeatures {
    cd_method method;
    bool node_mass, force, target, bend;
};

// The memory that such features change.
struct BodyChanges {
    Change<double> mass, attach_stiffness, attach_damping, coefficients, scratch;
    Change<char> force, target;

    // numbers: of a field that has one per node, or one per node and strand
    BodyChanges(Body& b, const BodyFeatures& wanted, size_t numbers, size_t coefficients_needed, size_t scratch_needed)
        : mass{b.node_mass, wanted.node_mass ? numbers : 0},
          attach_stiffness{b.attach_stiffness, wanted.target ? numbers : 0},
          attach_damping{b.attach_damping, wanted.target ? numbers : 0},
          coefficients{b.coefficients, coefficients_needed},
          scratch{b.scratch, scratch_needed},
          force{b.force, wanted.force ? b.position.count : 0},
          target{b.target, wanted.target ? b.position.count : 0} {}

    template <class F> bool all(F f) {
        return f(mass) && f(attach_stiffness) && f(attach_damping) && f(coefficients) && f(scratch) && f(force) &&
               f(target);
    }
    // A new target is the present position. New masses are for the object to fill.
    void fill(Body& b) const {
        if (target.is_new()) memcpy(b.target.data, b.position.data, b.target.count);
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
