// What the nodes of ropes and cloth do not go through.
#pragma once

#include <stddef.h>
#include <stdint.h>

#include "contdyn/base.h"

namespace cd {

struct Collider {
    double shape;    // a cd_shape
    double point[3]; // of the plane, the capsule's first end, the origin of a bed or callback [m]
    double way[3];   // the plane's outward normal, of length 1, from the capsule's first end to its last, of a bed the
                     // distances between its heights [m]
    double radius, friction;
    double velocity[3]; // [m/s]
    double since;       // the time at which it was there [s]

    double place(int k, double time) const { return point[k] + (time - since) * velocity[k]; }
};

// What is told of what a collider bears: force [N] and moment about the origin [N m].
constexpr size_t kLoadNumbers = 6;
// And what is kept of a push on a node while a rope is solved.
constexpr size_t kPushNumbers = 6;

// Adds a force at x to a load, where that stays finite.
void add_force(double* load, const double* force, const double* x);

// A collider that is not CD_SHAPE_NONE, as steps meet it: its radius has the thickness of what touches it.
struct Obstacle : Collider {
    size_t index;                // among the colliders
    size_t columns, rows;        // of a bed: one row where a node has two components
    const double* heights;       // row after row [m]
    const cd_distance* callback; // null: of no callback
    size_t question;             // its number among callbacks

    bool is_convex() const { return shape == CD_SHAPE_PLANE || shape == CD_SHAPE_CAPSULE; }
};

// How far outside of a bed x is at this time, to first order, and the unit vector out of it.
//
// Along one axis the bed goes linearly from height to height, h + s f where f is the distance from the nearest height,
// counted in spacings; within kRoundCrease of that height it is the parabola that goes on where the lines end:
//
//      h + (s_left + s_right) / 2 f + (s_right - s_left) (f^2 + r^2) / (4 r),      r = kRoundCrease
//
// With sharp creases what lies in one would be pushed from side to side for ever. Along two axes it is the product of
// both, and beyond the last height there are more of the same height.
constexpr double kRoundCrease = 0.25;
double gap_to_bed(const Obstacle& bed, const double* x, double time, double* normal);

// The unit vector out of a collider from a place on the line along `way`: at right angles to it, and any where that has
// no length, or there is but one axis.
void way_off_line(const double* way, size_t components, double* out);

// An answer of a callback that is no distance, or no unit vector.
struct BadAnswer {
    size_t collider = SIZE_MAX; // none
    double distance = 0, length = 0;
};

// A callback's distances, less the radius, and normals for `count` places, rows of `components` numbers, which become
// those relative to the collider. Where the answer is bad nothing is near.
void ask(const Obstacle& of, double time, size_t count, size_t components, double* places, double* distances,
         double* normals, BadAnswer& bad);

// What nodes of `lanes` strands touch: of their first contacts. Components are `lanes` apart, contacts contact_step.
struct Touching {
    const double *normal, *before, *on, *error; // error: what counts as none of a velocity [m/s]
    size_t contact_step, lanes, count;
    double rate; // 1 / dt [1/s]
};
// The least velocities that take them out of all of that in a step, as normals lie.
void least_ways_out(const Touching& of, double* out);

// What a strand of a rope has after a step: of its first node, and of that one's first contact, in its first lane. Numbers
// are `lanes` apart, those of a node node_step, of a contact contact_step, and of its push kPushNumbers times the lanes.
struct PushedStrand {
    const double *mass, *mobility, *w, *next, *y, *normal, *before, *on, *push;
    size_t node_step, contact_step, lanes, of_strand; // of_strand: its lanes, side by side
    size_t node_count, collider_count;
    double per_impulse, rate; // 1 / h, or 0 where nothing is known, and 1 / dt [1/s]
};
// Adds what it did to each collider to its loads.
void add_loads(const PushedStrand& of, const Obstacle* colliders, double* loads);

} // namespace cd
