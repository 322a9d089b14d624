// The chain: what it consists of, and what is done with it. The equations are those of contdyn/chain.h.
#pragma once

#include "contdyn/chain.h"
#include "base/turn.hh"
#include "model/sleep.hh"

namespace cd {

constexpr uint64_t kMostIterations = 10000;     // of a rope's step
constexpr double kHalfTurn = 3.141592653589793; // [rad], the largest rest angle

// Of chains whose springs have a length: see chain_rope.cpp.
struct RopeSettings {
    double length = 0; // [m], of a strand; 0: springs have none
    int32_t push = 0;
    double tolerance = 1e-6;
    uint64_t most_iterations = 200;
    double strength = INFINITY; // [N]
    double thickness = 0;       // [m]
    double angle = 0;           // [rad], of a strand

    bool breaks() const { return strength < INFINITY; }
    bool operator==(const RopeSettings& o) const {
        return length == o.length && push == o.push && tolerance == o.tolerance &&
               most_iterations == o.most_iterations && strength == o.strength && thickness == o.thickness &&
               angle == o.angle;
    }
};

struct ChainSettings {
    int32_t ring;
    double stiffness, bend;
    RopeSettings rope;
    AirSettings air;
};

// Shared by the strands: all but the fields of strand, node and component. In ropes every strand has its own pins,
// masses, stiffnesses, lengths and attachments too: see own_strands.
struct Chain : Body, ChainSettings {
    const ChainKernels* kernels;

    // shape
    size_t strands, springs;
    size_t lines, pitch; // lines: strands * components, side by side; pitch: numbers from one node to the next

    // fields of its own, per spring and per node; pin is always there
    Array<double> spring_stiffness, node_bend, spring_length, spring_strength, node_angle;
    Array<double> tension; // with lengths, per spring and strand: state

    // what steps need, none of it state: see chain_step.cpp
    Array<double> ring_response;
    RingClosure closure;
    bool has_welds, uniform; // uniform: see ExplicitCoefficients
    double of_change;        // see Stage

    // what the last call of cd_chain_step did
    size_t iterations, broken;
    double residual;

    // f(array, array of another chain...) for each field, in the order in which they are kept; and for every array.
    template <class F, class... C> static void each_field(F f, C&... c) {
        f(c.pin...), f(c.node_mass...), f(c.spring_stiffness...), f(c.node_bend...);
        if (CD_WITH_ROPE) f(c.spring_length...), f(c.spring_strength...), f(c.node_angle...);
        f(c.attach_stiffness...), f(c.attach_damping...), f(c.position...), f(c.velocity...), f(c.force...);
        f(c.target...);
        if (CD_WITH_ROPE) f(c.tension...), f(c.wind...), f(c.colliders...), f(c.beds...);
        if (CD_WITH_SLEEP) f(c.calm...);
        if (CD_WITH_ROPE) f(c.loads...);
    }
    template <class F> static void each_array(F f, Chain& c) {
        each_field(f, c);
        f(c.coefficients), f(c.scratch), f(c.ring_response);
        if (CD_WITH_ROPE) f(c.callbacks);
    }
};

constexpr uint64_t kChainTag = 0x316e696168436443; // "CdChain1"

// ---- shape and parameters -------------------------------------------------------------------------------------------

inline Layout layout_of(const Chain& c) { return {c.nodes, c.lines, c.pitch}; }
inline size_t place(const Chain& c, size_t strand, size_t node, size_t component) {
    return node * c.pitch + strand * c.components + component;
}
inline size_t springs_in_all(const Chain& c) { return c.springs + size_t(c.ring); }

inline bool can_have_lengths(const Chain& c) { return c.springs > 0 && c.components <= 3; }
inline bool has_lengths(const Chain& c) { return CD_WITH_ROPE && c.rope.length > 0; }

// How many strands have fields per node and spring of their own; and where in such a field the number of a node or
// spring stands, `at` in the functions below.
inline size_t own_strands(const Chain& c) { return has_lengths(c) ? c.strands : 1; }
inline size_t own_place(const Chain& c, size_t strand, size_t item) {
    return has_lengths(c) ? item * c.strands + strand : item;
}
inline bool held(const Chain& c, size_t at) { return holds(c.pin[at]); }

// Whether a line is solved in segments side by side, for want of lines to fill the lanes; unless some of it is welded.
// Four lines with bend, two registers at once, wait less for each other: cutting them up pays later.
inline bool takes_segments(const Chain& c, bool rod) {
    return c.lines <= kMostSegmentLines && c.nodes >= (rod && c.lines == kMostSegmentLines ? 16 : 8) * kSegments;
}
// How many doubles some things take that consist of nothing else.
template <class Thing> constexpr size_t numbers_of(size_t count) { return count * sizeof(Thing) / sizeof(double); }
// From one row of coefficients to the next: whole cache lines, but in small scenes.
inline size_t row_length(const Chain& c) { return c.nodes < 8 * kSegments ? c.nodes : (c.nodes + 7) / 8 * 8; }

// The uniform values that the totals come to.
double uniform_mass(const Chain& c, size_t node);
double uniform_stiffness(const Chain& c);
double uniform_bend(const Chain& c);

inline double mass_of(const Chain& c, size_t at) {
    return c.node_mass ? c.node_mass[at] : uniform_mass(c, has_lengths(c) ? at / c.strands : at);
}
inline double stiffness_of(const Chain& c, size_t at) {
    return c.spring_stiffness ? c.spring_stiffness[at] : uniform_stiffness(c);
}
inline double uniform_length(const Chain& c) { return c.rope.length / double(springs_in_all(c)); }
inline size_t collider_count(const Chain& c) { return CD_WITH_ROPE ? collider_count(static_cast<const Body&>(c)) : 0; }
inline double length_of(const Chain& c, size_t at) { return c.spring_length ? c.spring_length[at] : uniform_length(c); }
inline double strength_of(const Chain& c, size_t at) {
    return c.spring_strength ? c.spring_strength[at] : c.rope.strength;
}
inline bool can_break(const Chain& c) { return CD_WITH_ROPE && (c.spring_strength || c.rope.breaks()); }
// Of inner nodes, of which a rest angle other than 0 needs one. As many half turns as there are may round to more than
// one for each.
inline double uniform_angle(const Chain& c) {
    const double each = c.springs > 1 ? c.rope.angle / double(c.springs - 1) : 0;
    return fabs(each) < kHalfTurn ? each : copysign(kHalfTurn, each);
}
inline double angle_of(const Chain& c, size_t at) { return c.node_angle ? c.node_angle[at] : uniform_angle(c); }
inline double most_angle(const Chain& c) { return c.springs > 1 ? kHalfTurn * double(c.springs - 1) : 0; }
inline bool can_curl(const Chain& c) { return c.components == 2; }
inline bool curls(const Chain& c) { return CD_WITH_ROPE && CD_WITH_BEND && (c.node_angle || c.rope.angle != 0); }
double bend_of(const Chain& c, size_t node, size_t at); // 0 at the ends of an open chain
inline double bend_of(const Chain& c, size_t node) { return bend_of(c, node, node); }
inline bool has_bend(const Chain& c) { return CD_WITH_BEND && (c.node_bend || c.bend > 0); }
// The bend energy at a node is stiffness / 2 |right d_right - left R d_left|^2, d the vectors of the springs beside it,
// and R the turn by the rest angle.
struct Joint {
    double stiffness, left, right;
    CosineAndSine<double> turn = {1, 0};

    // Component k of R d, or, with `back`, of its inverse times d; of(k): a component of d.
    template <class F> double turned(size_t k, F of, bool back = false) const {
        if (turn.cosine == 1 && turn.sine == 0) return of(k); // of any number of components
        const double sine = (k == 0) == back ? turn.sine : -turn.sine;
        return turn.cosine * of(k) + sine * of(1 - k);
    }
};
Joint joint_of(const Chain& c, size_t strand, size_t node);
// An infinite stiffness welds the nodes of a spring that has no length; one that has it keeps it.
inline bool is_rigid(const Chain& c, size_t at) { return stiffness_of(c, at) > 1.7976931348623157e308; }
inline bool welded(const Chain& c, size_t spring) { return is_rigid(c, spring) && !has_lengths(c); }

// What drags a node back beside the springs' damping [N s/m]: drag, a matched end, an attachment.
double drag_of(const Chain& c, size_t at);

// ---- life and features (chain.cpp) ----------------------------------------------------------------------------------

cd_status create_chain(const char* function, size_t strands, size_t springs, size_t components, cd_precision precision,
                       const cd_allocator& allocator, Chain*& out);

struct Features : BodyFeatures {
    bool spring_stiffness, node_bend, ring, length, spring_length, spring_strength, angle, node_angle;
};
Features features(const Chain& c);
inline const char* left_out(const Features& f) {
    if (!CD_WITH_ROPE && f.length) return "ropes are";
    if (!CD_WITH_BEND && f.ring) return "rings are";
    if (!CD_WITH_BEND && (f.node_bend || f.angle || f.node_angle)) return "bend is";
    return left_out(static_cast<const BodyFeatures&>(f));
}

// Takes the memory that the features need and releases what they do not; new fields are filled with uniform values.
// False for want of memory: nothing has changed.
bool set_features(Chain& c, const Features& wanted);

// Fills a field that is switched on with the uniform values of the totals.
void fill_uniform(Chain& c, cd_field field);

// ---- fields and acting (chain_fields.cpp) ---------------------------------------------------------------------------

// Whether a number may stand in a field: finite, and in the ranges of chain.h.
bool valid_number(const Chain& c, cd_field field, size_t strand, size_t node, double value);

// The group of nodes that welded springs join to a node: `count` nodes from `first`, round a ring.
struct Group {
    size_t first, count;
};
Group group_of(const Chain& c, size_t node);
size_t held_in(const Chain& c, size_t strand, Group group);

// Whether every welded group of a chain, or ring, of `nodes` nodes would hold one held node at the most, if springs and
// nodes were as the functions of their numbers say.
template <class Welded, class Held> bool groups_are_sound(size_t nodes, bool ring, Welded is_welded, Held is_held) {
    const size_t springs = ring ? nodes : nodes - 1;
    size_t start = 0;
    while (ring && start < nodes && is_welded(start > 0 ? start - 1 : springs - 1)) ++start;
    if (start == nodes) start = 0;
    int held_here = 0;
    for (size_t k = 0, i = start; k < nodes; ++k, i = i + 1 < nodes ? i + 1 : 0) {
        held_here += is_held(i) ? 1 : 0;
        if (held_here > 1) return false;
        if (i >= springs || !is_welded(i)) held_here = 0;
    }
    return true;
}

// Gives the nodes of every welded group one velocity: that of the held node, or the mean by mass.
void merge_velocities(Chain& c, size_t first_line, size_t lines);

// Stops the nodes that have become pinned; and gives welded groups one velocity too.
void stop_pinned(Chain& c);
void hold_nodes(Chain& c);

// ---- time (chain_step.cpp) ------------------------------------------------------------------------------------------

// Returns the number of the first step at which a number left the finite range, or 0.
uint64_t step_chain(Chain& c, double dt, size_t count);
double stable_dt(const Chain& c); // chain_limit.cpp

// Part of a chain that sleeps as a whole, see model/sleep.hh: a strand, where strands are individuals, or all of them.
SleepingPart sleeping_part(const Chain& c, size_t part);

inline size_t awake_nodes(const Chain& c) { return (own_strands(c) - sleeping_parts(c)) * sleeping_part(c, 0).nodes; }

// ---- springs that have a length (chain_rope.cpp) --------------------------------------------------------------------

// Why such a chain can't make its next step, or null.
const char* what_ropes_lack(const Chain& c);
// Of strands that are stepped at once: the doubles of scratch; and of the coefficients.
struct RopeNeeds {
    bool bend, air, loads;
    ColliderSizes colliders;
};
size_t rope_scratch(const Chain& c, const RopeNeeds& needs);
size_t rope_coefficients(const Chain& c, size_t colliders);
// As step_chain; leaves `iterations`, `residual` and `broken`.
uint64_t step_ropes(Chain& c, double dt, size_t count);
// Positions, velocities, tensions and time back to 0.
void clear_state(Chain& c);

// ---- measuring (chain_measure.cpp) ----------------------------------------------------------------------------------

void energy(const Chain& c, double& kinetic, double& elastic, double& gravity);
void momentum(const Chain& c, double* out);
// Of ropes: a spring's strain, and the force with which springs pull at a node.
double strain_of(const Chain& c, size_t strand, size_t spring);
void reaction(const Chain& c, size_t strand, size_t node, double* out);

// ---- keeping (chain_keep.cpp) ---------------------------------------------------------------------------------------

uint64_t hash(const Chain& c);
size_t save_size(const Chain& c);
void save(const Chain& c, unsigned char* out);
cd_status load(const char* function, Chain& c, const unsigned char* bytes, size_t size);
cd_status copy(const char* function, Chain& c, const Chain& source);

} // namespace cd
