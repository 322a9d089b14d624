// The chain: what it consists of, and what is done with it. The equations are those of model.md, sections 1 to 3.
#pragma once

#include <string.h>

#include <initializer_list>

#include "base/memory.hh"
#include "contdyn/chain.h"
#include "kernel/kernels.hh"

namespace cd {

// Everything a chain is. Shared by its strands: all but the four fields of strand, node and component.
struct Chain {
    uint64_t tag;
    Memory memory;
    cd_parallel parallel;
    const Kernels* kernels;

    // shape
    size_t strands, springs, components;
    cd_precision precision;
    size_t nodes, lines, pitch; // lines: strands * components, side by side; pitch: numbers from one node to the next

    // parameters
    cd_method method;
    cd_mass_rule mass_rule;
    int32_t ring;
    double lambda, mass, stiffness, bend, drag, damping, gravity[4];

    // fields, empty where switched off: per node or spring
    Array<double> node_mass, spring_stiffness, node_bend, attach_stiffness, attach_damping;
    Array<uint8_t> pin; // always there
    // and per strand, node and component, in the chain's precision; position and velocity are always there
    Array<char> position, velocity, force, target;

    // time: clock_steps steps of clock_dt since clock_start, so that it does not depend on how steps share calls
    double clock_start, clock_dt;
    uint64_t clock_steps, steps;
    bool diverged;

    // what steps need, none of it state: see chain_step.cpp
    Array<double> coefficients, scratch, ring_response;
    RingClosure closure;
    bool has_welds;
    double of_change;   // see Stage
    double prepared_dt; // what those above are for; 0: out of date
    uint64_t factorizations;
};

constexpr uint64_t kChainTag = 0x316e696168436443; // "CdChain1"

// ---- shape and parameters -------------------------------------------------------------------------------------------

inline size_t number_size(const Chain& c) { return c.precision == CD_FLOAT64 ? sizeof(double) : sizeof(float); }
inline size_t springs_in_all(const Chain& c) { return c.springs + size_t(c.ring); }
inline bool held(const Chain& c, size_t node) { return c.pin[node] == CD_NODE_PINNED || c.pin[node] == CD_NODE_DRIVEN; }

// Parameters stay far enough inside double's range for products of four of them: see chain.h.
constexpr double kMost = 1e60, kLeastMass = 1e-60;
inline bool valid_parameter(double value) { return value >= 0 && value <= kMost; }
inline bool valid_mass(double value) { return value >= kLeastMass && value <= kMost; }

inline bool is_explicit(cd_method method) {
    return method == CD_METHOD_FORWARD_EULER || method == CD_METHOD_SYMPLECTIC_EULER;
}

// The uniform values that the totals come to.
double uniform_mass(const Chain& c, size_t node);
double uniform_stiffness(const Chain& c);
double uniform_bend(const Chain& c);

inline double mass_of(const Chain& c, size_t node) { return c.node_mass ? c.node_mass[node] : uniform_mass(c, node); }
inline double stiffness_of(const Chain& c, size_t spring) {
    return c.spring_stiffness ? c.spring_stiffness[spring] : uniform_stiffness(c);
}
double bend_of(const Chain& c, size_t node); // 0 at the ends of an open chain
bool has_bend(const Chain& c);
inline bool welded(const Chain& c, size_t spring) { return stiffness_of(c, spring) > 1.7976931348623157e308; }

// What drags a node back beside the springs' damping [N s/m]: drag, a matched end, an attachment. What ties it to its
// target [N/m].
double drag_of(const Chain& c, size_t node);
inline double tie_of(const Chain& c, size_t node) { return c.attach_stiffness ? c.attach_stiffness[node] : 0; }

// ---- life and features (chain.cpp) ----------------------------------------------------------------------------------

cd_status create_chain(const char* function, size_t strands, size_t springs, size_t components, cd_precision precision,
                       const cd_allocator& allocator, Chain*& out);
void destroy_chain(Chain* c);

// What a chain may have switched on, in one value, so that features change all together or not at all.
struct Features {
    bool node_mass, spring_stiffness, node_bend, force, target, ring, bend;
    cd_method method;
};
Features features(const Chain& c);

// Takes the memory that the features need and releases what they do not; new fields are filled with uniform values.
// False for want of memory: nothing has changed.
bool set_features(Chain& c, const Features& wanted);

// Fills a field that is switched on with the uniform values of the totals.
void fill_uniform(Chain& c, cd_field field);

// ---- fields and acting (chain_fields.cpp) ---------------------------------------------------------------------------

template <class T> T* numbers(const Array<char>& array) { return reinterpret_cast<T*>(array.data); }

// Whether a number may stand in a field: finite, and in the ranges of chain.h.
bool valid_number(const Chain& c, cd_field field, size_t node, double value);

double get_number(const Chain& c, const Array<char>& array, size_t strand, size_t node, size_t component);
void set_number(const Chain& c, const Array<char>& array, size_t strand, size_t node, size_t component, double value);

// The group of nodes that welded springs join to a node: `count` nodes from `first`, round a ring.
struct Group {
    size_t first, count;
};
Group group_of(const Chain& c, size_t node);
size_t held_in(const Chain& c, Group group);

// Gives the nodes of every welded group one velocity: that of the held node, or the mean by mass.
void merge_velocities(Chain& c, size_t first_line, size_t lines);

// Stops the nodes that have become pinned.
void stop_pinned(Chain& c);

// ---- time (chain_step.cpp) ------------------------------------------------------------------------------------------

// Returns the number of the first step at which a number left the finite range, or 0.
uint64_t step_chain(Chain& c, double dt, size_t count);
bool all_finite(const Chain& c);
inline double time_of(const Chain& c) { return c.clock_start + double(c.clock_steps) * c.clock_dt; }
double stable_dt(const Chain& c); // chain_limit.cpp

// ---- measuring (chain_measure.cpp) ----------------------------------------------------------------------------------

void energy(const Chain& c, double& kinetic, double& elastic, double& gravity);
void momentum(const Chain& c, double* out);

// ---- keeping (chain_keep.cpp) ---------------------------------------------------------------------------------------

uint64_t hash_chain(const Chain& c);
size_t saved_size(const Chain& c);
void save_chain(const Chain& c, unsigned char* out);
cd_status load_chain(const char* function, Chain& c, const unsigned char* bytes, size_t size);
cd_status copy_chain(const char* function, Chain& c, const Chain& source);

} // namespace cd
