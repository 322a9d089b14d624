// Steps of strands whose springs have a length. Unlike the lines of the other sweeps, the components of a strand move
// together: a spring acts along the direction that it has. (model.md, 20 to 23)
//
// With x0, v0 the state, w the velocity that moves the nodes, h = lambda dt and D0, D1 a spring's vector before and
// after, D1 = D0 + dt (w_{i+1} - w_i):
//      G_i (w_i - b_i) = phi_i - phi_{i-1},      phi_i = h T_i z_i / |z_i|,     z = D0 + theta dt (w_{i+1} - w_i)
//      |D1| = L + T / k   where the spring is taut; T = 0 and |D1| <= L + T / k where it is slack
//      x1 = x0 + dt w,    v1 = v0 + (w - v0) / lambda
// G = M + h C + h^2 A and b, what the node would do alone, hold drag C and attachments A. theta is lambda where the
// spring pulls and 1/2 where it pushes; then the step changes the energy of a rope with 1 / k = 0 by
//      -(lambda - 1/2) (|v1 - v0|_M^2 + sum over what pulls of T / |z| |D1 - D0|^2).
// Air adds the impulse B (u - w) to a node: u is the wind's velocity, B = h s (along t t^T + across (1 - t t^T)), s the
// node's share of the rope's length, and t the rope's way there at x0 + h v0, which does not depend on w.
#pragma once

#include <stddef.h>
#include <stdint.h>

#include "kernel/collider.hh"
#include "kernel/lines.hh"

namespace cd {

// The state of all strands. The number of a node's component lies at node * pitch + strand * components + component, a
// tension at spring * strands + strand.
struct Ropes {
    size_t nodes, strands, components, pitch;
    StateNumbers position, velocity, force, target, wind;
    double* tension;
    double* taken; // how many iterations each strand's last step took
    double* loads; // of strand after strand, each with every collider: see kLoadNumbers; null: none are told
    size_t collider_count;
};

// Numbers per node or spring and strand, with steps from one to the next: 0 where they are the same.
template <class T> struct RopeNumbers {
    const T* data;
    size_t of_item, of_strand;

    double at(size_t item, size_t strand) const { return double(data[item * of_item + strand * of_strand]); }
};
struct RopeParameters {
    RopeNumbers<double> mass, tie, tie_damping; // [kg], of attachments [N/m], [N s/m]
    RopeNumbers<double> length, stiffness;      // [m], [N/m]: 0: cut, INFINITY: of fixed length
    RopeNumbers<double> bend, angle;            // [N/m], [rad], of nodes with two springs
    RopeNumbers<uint8_t> pin;                   // cd_node
    double drag;                                // [1/s]
};

// A strand is solved from both ends at once: its halves go side by side, each from its end to the middle, and meet
// there. So one long rope has two lanes, and the bits of a strand do not depend on how many others there are. A rod
// passes on more than meets easily, and goes through one lane, from the end that is held. rope_lane_room: nodes of a
// lane, and the one that the spring in the middle leads to.
inline bool rope_has_halves(bool bends) { return !bends; }
inline size_t rope_lane_nodes(size_t nodes, bool halved) { return halved ? (nodes + 1) / 2 : nodes; }
inline size_t rope_lane_room(size_t nodes, bool halved) { return rope_lane_nodes(nodes, halved) + (halved ? 1 : 0); }

struct RopeStage {
    double dt, lambda;
    double gravity[3];
    double along, across, wind[3]; // of the air; wind: where a node has none of its own
    bool push;                     // springs push as well
    bool bends, curls;             // whether any node has a bend stiffness, and a rest angle
    double tolerance;              // of the length that a spring should have, over its rest length
    size_t most_iterations;
    const Obstacle* colliders;
    size_t collider_count, callback_count;
    double time_before, time_after; // of the step [s]

    bool has_air() const { return along > 0 || across > 0; }
    bool has_halves() const { return rope_has_halves(bends); }
};

struct RopeResult {
    size_t iterations = 0; // of the strand that took most
    double error = 0;      // of the worst length, over the rest length
    bool finite = true;
    BadAnswer bad;

    void add(const RopeResult& other) {
        if (other.iterations > iterations) iterations = other.iterations;
        if (other.error > error) error = other.error;
        finite &= other.finite;
        if (bad.collider == SIZE_MAX) bad = other.bad;
    }
};

// The most lanes, whatever the kernels, those of a call with one strand, and the doubles of scratch per lane and node
// of its room: always, for the air, for each collider, for each callback and for any; of rods, and there for the air
// and for each collider; kPushNumbers for each collider where loads are told.
constexpr size_t kRopeLanes = 8, kLanesAlone = 2, kRopeScratch = 63, kAirScratch = 15, kContactScratch = 34;
constexpr size_t kAnswerScratch = 4, kQuestionScratch = 7;
constexpr size_t kJointScratch = 65, kLinkScratch = 9;

namespace CD_ISA {

RopeResult rope_step(const Ropes& ropes, const RopeParameters& c, const RopeStage& stage, double* scratch,
                     const size_t* strands, size_t count);

} // namespace CD_ISA

namespace plain {
// All sets of kernels step a strand that is alone by this one: it has two lanes, which no set makes faster.
RopeResult rope_step(const Ropes& ropes, const RopeParameters& c, const RopeStage& stage, double* scratch,
                     const size_t* strands, size_t count);
} // namespace plain
} // namespace cd
