/* contdyn: a chain of nodes joined by springs: massive spring, rope, hair, spline.
 *
 * A chain has `springs` springs and nodes = springs + 1 nodes; spring i joins node i to node i + 1. A ring has one
 * spring more, number `springs`, from the last node to the first. A node has 1 to 4 components that never mix. One
 * handle holds one or many strands, each with its own positions, velocities, forces and targets. Strands share masses,
 * stiffnesses, pins and attachments, and so one factorization; only ropes' strands have their own of these too.
 *
 * Energy    E = 1/2 sum k_i |x_{i+1} - x_i|^2 + 1/2 sum b_i |x_{i+1} - 2 x_i + x_{i-1}|^2      (Kass 1997, eq. 2 and 5)
 * Motion    M x'' + C x' + K x = M g + f,  K = the Hessian of E,  C = drag M + stiffness_damping K
 *
 * Rest length is zero, unless cd_chain_set_rest_length makes the chain a rope: a free chain draws together, and one
 * stretched evenly is held by its ends. A new chain lies with every node at the origin, at rest, all nodes free, mass
 * 1, stiffness 1, no bend, no gravity, no damping, CD_METHOD_IMPLICIT with lambda 1/2.
 *
 * All computing is done in double precision; CD_FLOAT32 is what positions, velocities, forces and targets are stored
 * in. (Steps of symplectic Euler on uniform chains without damping and forces compute in float32 and are as exact.)
 * Numbers smaller than 2^-80 (float32) or 2^-500 (float64), in those steps velocities, are taken for 0 where a step
 * stores them, so that a scene at rest is never slow. Parameters may be as large as 1e60, masses as small as 1e-60.
 *
 * Every function returns CD_ERROR_NULL for a null pointer and CD_ERROR_HANDLE for a handle of another kind; the
 * comments name the other errors. */
#ifndef CONTDYN_CHAIN_H
#define CONTDYN_CHAIN_H

#include "base.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct cd_chain cd_chain;

/* The two ends of a chain. */
typedef int32_t cd_end;
enum { CD_END_FIRST = 0, CD_END_LAST = 1 };

/* ---- life ------------------------------------------------------------------------------------------------------ */

/* Makes a chain. strands >= 1; springs >= 0 (0: a single node); components 1 to 4. allocator may be null (malloc).
 * The caller owns *out_chain and releases it with cd_chain_destroy; on failure *out_chain is left alone.
 * Errors: CD_ERROR_VALUE, CD_ERROR_ENUM, CD_ERROR_SIZE, CD_ERROR_MEMORY; CD_ERROR_UNSUPPORTED for a precision that
 * this build leaves out. */
CD_API cd_status cd_chain_create(size_t strands, size_t springs, size_t components, cd_precision precision,
                                 const cd_allocator* allocator, cd_chain** out_chain);

/* Releases a chain and all its memory. Null does nothing; a handle of another kind is left alone. */
CD_API void cd_chain_destroy(cd_chain* chain);

/* What cd_chain_create was given. Each output may be null. */
CD_API cd_status cd_chain_get_shape(const cd_chain* chain, size_t* out_strands, size_t* out_springs,
                                    size_t* out_components, cd_precision* out_precision);

/* ---- method ------------------------------------------------------------------------------------------------------ */

/* How steps are made. Methods differ in the memory they need: implicit ones a factorization and a row of scratch,
 * CD_METHOD_STIFF_SECOND a second row. Errors: CD_ERROR_ENUM; CD_ERROR_MEMORY. */
CD_API cd_status cd_chain_set_method(cd_chain* chain, cd_method method);
CD_API cd_status cd_chain_get_method(const cd_chain* chain, cd_method* out_method);

/* lambda of CD_METHOD_IMPLICIT, in [0, 1]; default 1/2. Errors: CD_ERROR_VALUE. */
CD_API cd_status cd_chain_set_lambda(cd_chain* chain, double lambda);
CD_API cd_status cd_chain_get_lambda(const cd_chain* chain, double* out_lambda);

/* Spreads the strands of a step over the caller's threads. Null: none. Errors: CD_ERROR_NULL for a table without run. */
CD_API cd_status cd_chain_set_parallel(cd_chain* chain, const cd_parallel* parallel);

/* The instructions that steps are made of, from here on: for tests and measurements, as all give the same bits and a
 * new chain has the fastest that its processor runs. Not part of the saved state.
 * Errors: CD_ERROR_ENUM; CD_ERROR_UNSUPPORTED for kernels that are not among cd_runnable_kernels. */
CD_API cd_status cd_chain_set_kernels(cd_chain* chain, cd_kernels kernels);
CD_API cd_status cd_chain_get_kernels(const cd_chain* chain, cd_kernels* out_kernels);

/* ---- parameters -------------------------------------------------------------------------------------------------- */
/* Totals of one strand. A change takes effect at the next step and costs it one refactorization. Where the field of
 * the same name is switched on, setting the total writes the whole field anew. A getter tells the total last set.
 * Errors of all setters: CD_ERROR_VALUE for a number that is NaN, infinite or out of range; CD_ERROR_ENUM. */

/* Mass [kg], > 0. Per node, CD_MASS_EQUAL: mass / nodes; CD_MASS_HALF_ENDS: mass / springs, half of it at the two
 * ends (in a ring, and with no spring, the rules agree). Kass 1997, eq. 6. */
CD_API cd_status cd_chain_set_mass(cd_chain* chain, double mass);
CD_API cd_status cd_chain_get_mass(const cd_chain* chain, double* out_mass);
CD_API cd_status cd_chain_set_mass_rule(cd_chain* chain, cd_mass_rule rule);
CD_API cd_status cd_chain_get_mass_rule(const cd_chain* chain, cd_mass_rule* out_rule);

/* Stretch stiffness k [N/m], >= 0, of ropes up to INFINITY. Per spring: k times the number of springs. Kass 1997,
 * eq. 7. Waves run along the chain in sqrt(mass / k) seconds. */
CD_API cd_status cd_chain_set_stiffness(cd_chain* chain, double stiffness);
CD_API cd_status cd_chain_get_stiffness(const cd_chain* chain, double* out_stiffness);

/* Bend stiffness b [N/m], >= 0. Per node with two neighbours: b times the cube of the number of springs (Kass 1997,
 * eq. 5; eq. 8 prints the square). With b = E I / L^3, L the length of all its springs, held ones too, a rope bends
 * as a beam of the rigidity E I [N m^2]. Errors: CD_ERROR_MEMORY when bend is switched on. */
CD_API cd_status cd_chain_set_bend(cd_chain* chain, double bend);
CD_API cd_status cd_chain_get_bend(const cd_chain* chain, double* out_bend);

/* Drag [1/s], >= 0: every node loses velocity at this rate. */
CD_API cd_status cd_chain_set_drag(cd_chain* chain, double drag);
CD_API cd_status cd_chain_get_drag(const cd_chain* chain, double* out_drag);

/* Stiffness damping [s], >= 0: stretch and bend damp at this time constant; a mode of angular frequency w loses
 * amplitude at the rate (drag + stiffness_damping w^2) / 2. Ropes take none. */
CD_API cd_status cd_chain_set_stiffness_damping(cd_chain* chain, double seconds);
CD_API cd_status cd_chain_get_stiffness_damping(const cd_chain* chain, double* out_seconds);

/* Gravity [m/s^2], one number per component, at most 1e60 in size, in CD_FLOAT32 1e30.
 * Errors: CD_ERROR_RANGE if count is not the number of components. */
CD_API cd_status cd_chain_set_gravity(cd_chain* chain, const double* gravity, size_t count);
CD_API cd_status cd_chain_get_gravity(const cd_chain* chain, double* out_gravity, size_t count);

/* What holds an end: the same as writing the field CD_PIN at the first or last node of every strand; the getter tells
 * that of the first strand. Pinning stops the node; driving leaves its velocity, which is then written through
 * CD_VELOCITY; posing switches CD_TARGET on and sets the end's target to where it is: write the next one there.
 * Errors: CD_ERROR_ENUM; CD_ERROR_MEMORY; CD_ERROR_UNSUPPORTED for CD_NODE_MATCHED on a ring; CD_ERROR_DIVERGED for
 * CD_NODE_POSED where the state is not finite. */
CD_API cd_status cd_chain_set_end(cd_chain* chain, cd_end end, cd_node kind);
CD_API cd_status cd_chain_get_end(const cd_chain* chain, cd_end end, cd_node* out_kind);

/* Joins the last node to the first (1) or opens the ring (0). A ring has as many springs as nodes, and with bend a
 * bend term at every node; totals are dealt out anew, and a per-spring stiffness field gets the uniform value.
 * Needs 3 nodes. A ring with bend whose springs are cut, or some far softer than others, gains energy by rounding in
 * steps longer than some 1e6 times its fastest swing. Errors: CD_ERROR_VALUE for anything but 0 and 1;
 * CD_ERROR_UNSUPPORTED with fewer than 3 nodes or a matched end; CD_ERROR_MEMORY. */
CD_API cd_status cd_chain_set_ring(cd_chain* chain, int32_t ring);
CD_API cd_status cd_chain_get_ring(const cd_chain* chain, int32_t* out_ring);

/* Lets what has come to rest sleep: steps leave it as it is, at hardly any cost. Strands of a rope do so one by one,
 * others together. One stops, and sleeps, once for some `seconds` [s], in [1e-30, 1e60], no step left a free node of it
 * faster than `speed` [m/s], in [0, 1e60], nor a held one moving. Energy is lost and none gained.
 * Neglected is a mean acceleration of up to 2 speed / seconds: let that be little beside gravity, or what is thrown may
 * stay in the air. speed 0, the default: nothing sleeps, and seconds means nothing and is 0.
 * A plane or capsule that moves wakes what it could touch in the next step; a bed that moves, or a callback, keeps all
 * awake. What changes a strand wakes it, with whatever numbers: a write, an impulse, a teleport, an attachment, a cut;
 * what is set wakes all, but for the hook, the kernels and the tolerance. Who sleeps is part of the state.
 * Errors: CD_ERROR_VALUE; CD_ERROR_MEMORY. */
CD_API cd_status cd_chain_set_sleep(cd_chain* chain, double speed, double seconds);
CD_API cd_status cd_chain_get_sleep(const cd_chain* chain, double* out_speed, double* out_seconds);
/* How many nodes are awake: those that the next step moves. */
CD_API cd_status cd_chain_get_awake(const cd_chain* chain, size_t* out_nodes);

/* ---- ropes: springs that have a length --------------------------------------------------------------------------- */
/* A rope is a chain with a rest length: the components of a node, 1 to 3, are directions of space, and a spring pulls
 * along itself by k_i (|x_{i+1} - x_i| - length_i) once it is longer than its length; shorter it is slack. k_i may be
 * anything up to INFINITY, which keeps its length.
 * Steps: a step solves this nonlinear system, to the tolerance, by Newton's method, as a rule in 1 to 3 iterations, each
 *    in time proportional to the nodes. lambda = 1/2 is second order and keeps the energy of a swing, but for the jerk
 *    when slack ends; lambda = 1 damps most. Stretching of springs of finite stiffness is damped at every lambda, with
 *    1/2 about half as much as with 1. What can't be solved with lambda < 1 is solved with 1. A spring that is longer
 *    than its tension makes it, because positions were written so, comes back within the step at any speed.
 * Momentum: a step that reaches its tolerance keeps it to rounding, at any dt, stiffness and masses.
 * Energy: such a step adds no more than errors of length within the tolerance are worth: for each spring, before the
 *    step and again after it, at most 2 T e + k e^2. e is tolerance * length; T is the spring's tension, or the mean
 *    force on the nodes where that is larger and the interior point was needed; k e^2 is left out where k is infinite.
 *    In CD_FLOAT32 e includes the rounding of positions, 6e-8 of their distance from the origin: a swinging rope gains
 *    up to 2e-4 of its energy at 1e5 times its springs' length from there, a fifth at 1e6 times. Where a rest length
 *    is reduced, tension times what it falls by, with 1/2 along the mean of the spring's directions before and after
 *    the step, is work, and not counted as energy added.
 * Ropes need CD_METHOD_IMPLICIT, lambda in [1/2, 1], no ring, matched end or stiffness damping, or cd_chain_step says
 * CD_ERROR_UNSUPPORTED.
 *
 * With bend a rope is a rod, or hair, straight at rest or, in a plane, curled: its bend energy at a node is
 * b_i / 2 |d r_i|^2. d r_i is the difference of the two spring vectors at the node, each divided by its rest length and
 * multiplied by the mean of both rest lengths, the first turned by the rest angle. Two pinned nodes at an end clamp it:
 * the inner one, at the clamp, should have twice the bend of the others. A rod whose springs only pull shortens under
 * pressure about as far as the same force across would bend it: hair that is to stand needs cd_chain_set_push. Any bend
 * is stable; but where pinned nodes hold a rod bent with more than 1e5 times the energy m g L (m: of nodes all as light as
 * its lightest), or where nodes lie a hundred of its lengths apart, rounding may let a step end short of its tolerance. */

/* Rest length of a strand [m], 0 or in [1e-60, 1e60]; default 0: no rope. Per spring: length / springs; nodes stay
 * where they are. A rope has the fields CD_TENSION, at first 0, and CD_STRAIN. Its strands are individuals: each has
 * its own pins, masses, stiffnesses, bends, rest lengths and attachments, at first those that they shared. Length 0
 * switches CD_TENSION off, and CD_REST_LENGTH, rest angles, strength, air, wind and colliders too. Reeled in or paid
 * out a little every step, it is a winch. Errors: CD_ERROR_VALUE; CD_ERROR_MEMORY; CD_ERROR_UNSUPPORTED with 4
 * components or no spring, and for 0 where strands differ in what they would share, or an infinite stiffness would weld
 * all springs or two held nodes. */
CD_API cd_status cd_chain_set_rest_length(cd_chain* chain, double length);
CD_API cd_status cd_chain_get_rest_length(const cd_chain* chain, double* out_length);

/* Rest angle of a strand [rad], by which its last spring is turned from its first at rest, from the first axis to the
 * second; default 0: straight. Per node with two neighbours: angle / (springs - 1), at most pi in size. It is what bend
 * bends about, so it does nothing without bend, and turns with the rope: curls, hooks, tentacles, blades of grass. The
 * field CD_REST_ANGLE has one for each node. Where springs push, a rod takes its shape by turning, else also by going
 * slack. Errors: CD_ERROR_VALUE; CD_ERROR_UNSUPPORTED of a chain that is no rope, or, but for 0, without 2 components: in
 * space a curl needs to know how its links are twisted, which nodes do not tell. */
CD_API cd_status cd_chain_set_rest_angle(cd_chain* chain, double angle);
CD_API cd_status cd_chain_get_rest_angle(const cd_chain* chain, double* out_angle);

/* Whether springs with a length push when shorter (1) or are slack (0, the default). Links that push are solved by
 * Newton's method alone, which may fail from a crumpled start, or where hardly any bend holds them at long steps: of
 * the first 15 steps of 20 or 50 links laid at random one in 700, which moves too little. Errors: CD_ERROR_VALUE. */
CD_API cd_status cd_chain_set_push(cd_chain* chain, int32_t push);
CD_API cd_status cd_chain_get_push(const cd_chain* chain, int32_t* out_push);

/* The tension at which a spring breaks [N], 1e-60 to 1e60, or INFINITY, the default: springs hold. A rope's step ends
 * by cutting, of each strand, the spring whose tension is most beyond its strength: its stiffness and tension become
 * 0, and the next step shows what the others bear. Where a step ends short of its tolerance and leaves springs of fixed
 * length longer than that allows, as between held nodes that are driven apart, no tension is large enough: then, of the
 * springs between the held nodes on both sides of the longest one, the weakest breaks. Mend a spring by writing
 * CD_STIFFNESS, which a finite strength switches on and keeps on. The field CD_STRENGTH has one for each spring.
 * Errors: CD_ERROR_VALUE; CD_ERROR_MEMORY; CD_ERROR_UNSUPPORTED of a chain that is no rope. */
CD_API cd_status cd_chain_set_strength(cd_chain* chain, double strength);
CD_API cd_status cd_chain_get_strength(const cd_chain* chain, double* out_strength);
/* How many springs broke in the last call of cd_chain_step that made steps: those whose CD_STIFFNESS became 0. */
CD_API cd_status cd_chain_get_broken(const cd_chain* chain, size_t* out_springs);

/* The force [N], one number per component, with which the springs of a rope pull at a node, and its bend: of a held
 * node, what the rope does to whatever holds it. It is the sum of the springs' tensions, along their directions now (0
 * of a spring without length), and of the forces of the bend at the node and at the nodes beside it.
 * After a step that ended short of its tolerance tensions are a guess, 0 or at most the sum of the forces of springs on
 * each node in that step: a rope of fixed length has no tension that holds a driven end which would stretch it. To tie
 * a rope to a body of your own, give the last node its mass, in CD_MASS; or drive an end of a rope of finite stiffness.
 * Where tensions are read, or a strength is set, take lambda = 1. With 1/2 < lambda < 1 they miss up to a third of the
 * pull of hardly yielding springs where nodes swing; with 1/2 those can be twice the mean just after a jolt. With lambda
 * < 1 a load paid out by springs of infinite stiffness is let fall and caught by turns where dt^2 times gravity is less
 * than 5 tolerance * length: of 10 kg on 4 m of rope at dt = 1/960 s they are 6 N and 190 N; a smaller tolerance helps.
 * Errors: CD_ERROR_RANGE; CD_ERROR_UNSUPPORTED of a chain that is no rope. */
CD_API cd_status cd_chain_get_reaction(const cd_chain* chain, size_t strand, size_t node, double* out_force,
                                       size_t count);

/* Resistance of the air, per length of a rope [N s/m^2], in [0, 1e60], default 0: a piece of length s whose velocity
 * through the air is w, w_t along the rope and w_n across it, is pushed by -s (along w_t + across w_n). Implicit, so
 * that it only takes energy, as seen from the air, at any dt; the rope's direction is the one that it would have
 * lambda dt after the step began. A node bears half of its two springs' rest lengths, at most 1e10 m / dt [N s/m] where
 * its mass is m; cut springs feel no air. A round rope of diameter d has some across = 0.6 density d |w_n|, and along a
 * hundredth of that. Errors: CD_ERROR_VALUE; CD_ERROR_MEMORY; CD_ERROR_UNSUPPORTED of a chain that is no rope. */
CD_API cd_status cd_chain_set_air(cd_chain* chain, double along, double across);
CD_API cd_status cd_chain_get_air(const cd_chain* chain, double* out_along, double* out_across);

/* Velocity of that air [m/s], one number per component, default 0; the field CD_WIND has one for each node.
 * Errors: CD_ERROR_VALUE; CD_ERROR_RANGE if count is not the number of components; set: CD_ERROR_UNSUPPORTED of a chain
 * that is no rope. */
CD_API cd_status cd_chain_set_wind(cd_chain* chain, const double* velocity, size_t count);
CD_API cd_status cd_chain_get_wind(const cd_chain* chain, double* out_velocity, size_t count);

/* When a step of a rope ends: when every spring is as long as its tension makes it, but for `tolerance` times its rest
 * length, and springs gave no more energy than such errors are worth. A slack spring that is shorter by the fraction s
 * may keep a tension of tolerance / s times the mean force on the nodes, or the mean tension. In [1e-14, 1/2], default
 * 1e-6; above 1e-4 it costs more time, not less, since the next step must correct what one leaves. most_iterations, 1
 * to 10000, default 200, limits the slow and sure method, an interior point, which follows on at most 16 iterations of
 * Newton's; where springs push, it limits Newton's. Errors: CD_ERROR_VALUE. */
CD_API cd_status cd_chain_set_tolerance(cd_chain* chain, double tolerance, size_t most_iterations);
CD_API cd_status cd_chain_get_tolerance(const cd_chain* chain, double* out_tolerance, size_t* out_most_iterations);
/* What the last call of cd_chain_step did with ropes: the most iterations that a step of a strand took, and the largest
 * error it ended with, as the tolerance counts it, or INFINITY. 0 and 0 without ropes. Each output may be null. */
CD_API cd_status cd_chain_get_convergence(const cd_chain* chain, size_t* out_iterations, double* out_residual);

/* ---- what ropes touch -------------------------------------------------------------------------------------------- */
/* The nodes of a rope stay outside of colliders, numbered from 0, which all strands meet: half spaces, and capsules,
 * spheres among them, beds of heights, and shapes that a callback tells the distance from, each with a velocity and a
 * friction of its own. Nodes collide; springs between them do not, nor do ropes with each other. A step that reaches
 * its tolerance leaves no free node deeper inside than the tolerance times the springs' length, and colliders at rest
 * give no energy. What falls on one does not bounce; what comes to rest stays. A node that lies inside when a step
 * begins comes out, and throws neither itself nor its strand. No node passes through a capsule that it meets by less
 * than a radius a step; faster ones may: take shorter steps. Where colliders overlap, a node may be caught between
 * them, and where a rope lies across a body, its nodes come out on both sides: CD_ERROR_TOLERANCE. A strand that
 * touches something makes that step with lambda = 1; sliding at the speed v round a body of the radius R, this brakes
 * it as friction of the coefficient v dt / R would. Friction is Coulomb's: the coefficient times the force that presses
 * a node on, times v / (v + 1e-4 m/s) at the speed v, to 1%; of the force after 50 iterations where a step is hard. So
 * what it holds creeps: under half of what it can hold by 1e-4 m/s. Errors of all that set: CD_ERROR_UNSUPPORTED
 * without a rest length; CD_ERROR_RANGE for an index that no collider has, or a count that is not the number of
 * components; CD_ERROR_VALUE; CD_ERROR_MEMORY where a bed or a callback becomes something else. */

/* How many colliders there are, 0 to 4096, default 0: new ones are CD_SHAPE_NONE, those that stay keep what they are.
 * Rest length 0 takes them away. Errors: CD_ERROR_MEMORY. */
CD_API cd_status cd_chain_set_colliders(cd_chain* chain, size_t count);
CD_API cd_status cd_chain_get_colliders(const cd_chain* chain, size_t* out_count);

/* Makes a collider the half space behind the plane through `point` [m] that `normal`, of any length but 0, points out
 * of; one number per component each, at most 1e60 in size. friction, 0 to 1e60, is Coulomb's coefficient. */
CD_API cd_status cd_chain_set_plane(cd_chain* chain, size_t index, const double* point, const double* normal,
                                    size_t count, double friction);

/* Makes a collider all that is less than `radius` [m], 1e-60 to 1e60, away from the line between two ends: a sphere
 * where they are the same. */
CD_API cd_status cd_chain_set_capsule(cd_chain* chain, size_t index, const double* first, const double* last,
                                      size_t count, double radius, double friction);

/* Makes a collider all that lies below a bed of heights [m], at most 1e60 in size, which are copied. The last component
 * is up. With 3 components heights[j * columns + i] is at the first two components origin + (i column_spacing,
 * j row_spacing), of at least 2 columns and rows; with 2 components a single row is along the first one, and row_spacing
 * means nothing. Heights count from the origin's own; spacings [m] are 1e-60 to 1e60. Between heights the bed is
 * bilinear, with creases rounded within a quarter of the spacing either side; beyond the border it goes on at the
 * border's height. How far outside a node is, is its height above the bed times the upward part of the bed's normal.
 * A step meets the bed at the plane that touches it there where it finds the node. What the bed rises above that plane
 * on the node's way the node may end inside of, and the next step takes it out; however fast, none falls through.
 * Errors: CD_ERROR_RANGE too, if height_count is not columns * rows; CD_ERROR_MEMORY; CD_ERROR_UNSUPPORTED with 1
 * component. */
CD_API cd_status cd_chain_set_bed(cd_chain* chain, size_t index, const double* origin, size_t count, size_t columns,
                                  size_t rows, double column_spacing, double row_spacing, const double* heights,
                                  size_t height_count, double friction);
/* Each output may be null; 0 columns and rows of what is no bed. Errors: CD_ERROR_RANGE for an index that no collider
 * has, and, with out_heights, if height_count is not columns * rows. */
CD_API cd_status cd_chain_get_bed(const cd_chain* chain, size_t index, size_t* out_columns, size_t* out_rows,
                                  double* out_heights, size_t height_count);

/* Makes a collider the shape that a callback tells the distances of, whose positions are relative to origin [m]. A step
 * asks for all nodes of a strand at once, at its start and then in each iteration where they would end. Where a shape
 * is hollow it is met as beds are. Where an answer is not what cd_distance says, that step takes it for nothing there,
 * and cd_chain_step says CD_ERROR_CALLBACK. The callback itself is no state: after a load, or a copied state, a collider
 * that was CD_SHAPE_CALLBACK before goes on with the one it had, and for any other cd_chain_step says
 * CD_ERROR_UNSUPPORTED until it is set again. origin may be null: a collider that is CD_SHAPE_CALLBACK stays as it is
 * and gets this callback; count and friction mean nothing then.
 * Errors: CD_ERROR_NULL too, for a table without a function; CD_ERROR_MEMORY. */
CD_API cd_status cd_chain_set_callback(cd_chain* chain, size_t index, const cd_distance* distance, const double* origin,
                                       size_t count, double friction);
/* Makes a collider CD_SHAPE_NONE, at rest: nothing touches it. */
CD_API cd_status cd_chain_remove_collider(cd_chain* chain, size_t index);

/* Velocity of a collider [m/s], default 0, one number per component, at most 1e60 in size: steps move it, and it
 * carries what it touches along. It keeps its velocity when it is made another shape. A capsule that turns: before each
 * step put it where it will be after it, less dt times its middle's velocity, and give it that: cloth on limbs that swing
 * at 3.6 rad/s ends up to 2e-3 m inside in steps of 1/30 s; put where the step begins, 3.5e-2 m. */
CD_API cd_status cd_chain_set_collider_velocity(cd_chain* chain, size_t index, const double* velocity, size_t count);

/* What a collider is, and where now: of a plane its point and its normal, of length 1; of a capsule its two ends; of a
 * bed its origin and its spacings, 0 upward; of a callback its origin; else zeros, but for its velocity. One number per
 * component in each array. Each output may be null.
 * Errors: CD_ERROR_RANGE for an index that no collider has, or a count that is not the number of components. */
CD_API cd_status cd_chain_get_collider(const cd_chain* chain, size_t index, cd_shape* out_shape, double* out_first,
                                       double* out_second, double* out_velocity, size_t count, double* out_radius,
                                       double* out_friction);

/* Whether steps note what ropes do to colliders: 1, or 0, the default. Errors: CD_ERROR_VALUE; CD_ERROR_MEMORY. */
CD_API cd_status cd_chain_set_loads(cd_chain* chain, int32_t loads);
CD_API cd_status cd_chain_get_loads(const cd_chain* chain, int32_t* out_loads);
/* What the nodes of all strands did to a collider, pushes and friction, in the last step, in the mean over its time: 6
 * numbers, the force along x, y and z [N] and its moment about the origin [N m]; about a point p it is less by p x force.
 * Momentum of ropes changes by what all else gives, less this, but 0 is told of a strand whose step ended short of its
 * tolerance. What a node forgets of the speed at which it came out of a collider is not given. A strand that sleeps bears
 * as in its last step. 0 before a step. Part of the state. Errors: CD_ERROR_RANGE for index, or if count is not 6;
 * CD_ERROR_DISABLED unless cd_chain_set_loads has asked for it. */
CD_API cd_status cd_chain_get_collider_load(const cd_chain* chain, size_t index, double* out_load, size_t count);

/* How thick ropes are, as a radius [m] in [0, 1e60], default 0: nodes stay this far outside of colliders. */
CD_API cd_status cd_chain_set_thickness(cd_chain* chain, double radius);
CD_API cd_status cd_chain_get_thickness(const cd_chain* chain, double* out_radius);

/* ---- fields -------------------------------------------------------------------------------------------------------
 *  field         per              unit    values
 *  CD_POSITION   strand, node     m       finite
 *  CD_VELOCITY   strand, node     m/s     finite; of a pinned node only 0
 *  CD_FORCE      strand, node     N       finite; acts until it is overwritten
 *  CD_TARGET     strand, node     m       finite; where cd_chain_attach pulls to, and where CD_NODE_POSED goes
 *  CD_MASS       (strand), node   kg      > 0
 *  CD_STIFFNESS  (strand), spring N/m     >= 0; 0: cut; INFINITY: welded, see cd_chain_weld; in ropes of fixed length
 *  CD_BEND       (strand), node   N/m     >= 0; that of the two ends of an open chain is kept and not used
 *  CD_PIN        (strand), node   -       a cd_node
 *  CD_REST_LENGTH strand, spring  m       1e-60 to 1e60; of ropes only; below 1e-11 of others steps may end short
 *  CD_TENSION    strand, spring   N       finite double; of ropes only: what the last step found and the next one starts
 *                                         from; how right it is, also after a step that ended short of its
 *                                         tolerance, see cd_chain_get_reaction
 *  CD_WIND       strand, node     m/s     finite; of ropes only
 *  CD_STRENGTH   strand, spring   N       1e-60 to 1e60, or INFINITY; of ropes only: see cd_chain_set_strength
 *  CD_REST_ANGLE strand, node     rad     at most 3.141592653589793 in size: pi; of ropes of 2 components only; see bend
 *  CD_STRAIN     strand, spring   -       of ropes, to read only: length now over rest length, less 1; -1 and more
 * (strand): per strand in ropes, shared by the strands of other chains.
 * Nodes joined by welded springs make a group, which may hold one held node: more is CD_ERROR_UNSUPPORTED.
 * Position, velocity and pin are always there, tension and strain in ropes. The others cost memory and time only once
 * they are switched on. */

/* Switches a field on, filled with the present uniform values (force 0, target the present position). On already:
 * nothing happens. CD_STRENGTH switches CD_STIFFNESS on too. Errors: CD_ERROR_ENUM, CD_ERROR_MEMORY; CD_ERROR_DIVERGED
 * for CD_TARGET where the state is not finite; here and below CD_ERROR_UNSUPPORTED for the fields of ropes of a chain
 * that is none. */
CD_API cd_status cd_chain_enable_field(cd_chain* chain, cd_field field);

/* Switches a field off and releases its memory: uniform values again, no forces, all attachments loosened.
 * Errors: CD_ERROR_ENUM; CD_ERROR_UNSUPPORTED for position, velocity, pin, tension and strain, and for stiffness where
 * springs may break. */
CD_API cd_status cd_chain_disable_field(cd_chain* chain, cd_field field);

/* Writes or reads values[strand][node][component], dense, of strands [first_strand, first_strand + strands) and nodes
 * (or springs) [first, first + n). Fields without components have one value per node; fields that the strands share
 * have the single strand 0. `count` is the number of values in the buffer: strands * n * components. Numbers are
 * rounded once, to the precision of the side that is narrower. Never allocates.
 * Errors: CD_ERROR_ENUM, CD_ERROR_DISABLED, CD_ERROR_RANGE; write: CD_ERROR_VALUE, with the first bad index, and
 * CD_ERROR_UNSUPPORTED for CD_STRAIN. */
CD_API cd_status cd_chain_write_f32(cd_chain* chain, cd_field field, size_t first_strand, size_t strands, size_t first,
                                    size_t n, const float* values, size_t count);
CD_API cd_status cd_chain_write_f64(cd_chain* chain, cd_field field, size_t first_strand, size_t strands, size_t first,
                                    size_t n, const double* values, size_t count);
CD_API cd_status cd_chain_read_f32(const cd_chain* chain, cd_field field, size_t first_strand, size_t strands,
                                   size_t first, size_t n, float* out_values, size_t count);
CD_API cd_status cd_chain_read_f64(const cd_chain* chain, cd_field field, size_t first_strand, size_t strands,
                                   size_t first, size_t n, double* out_values, size_t count);

/* Where a field lies in the chain's own memory, in the chain's precision, to read without a copy: the value of
 * (strand, node, component) is at byte *out_data + strand * strand_stride + node * node_stride + component *
 * component_stride. Position, velocity, force and target only. The pointer is good until the field is switched off or
 * the chain released; the numbers change with every write and step. Do not write through it.
 * Errors: CD_ERROR_ENUM, CD_ERROR_DISABLED, CD_ERROR_UNSUPPORTED. */
CD_API cd_status cd_chain_view(const cd_chain* chain, cd_field field, const void** out_data, size_t* out_strand_stride,
                               size_t* out_node_stride, size_t* out_component_stride);

/* ---- acting on it ------------------------------------------------------------------------------------------------ */

/* Adds impulse [N s], one number per component, to a node: its velocity changes by impulse / mass, in a welded group
 * by impulse / the group's mass; a held node takes none. Errors: CD_ERROR_RANGE, CD_ERROR_VALUE, CD_ERROR_DIVERGED. */
CD_API cd_status cd_chain_impulse(cd_chain* chain, size_t strand, size_t node, const double* impulse, size_t count);

/* Moves a strand as a whole, as if it had always been there: every position and target becomes rotation * x + offset,
 * every velocity rotation * v; tensions stay, and colliders stay where they are. rotation: components rows of as many
 * numbers, orthogonal to 1e-6, with rest angles no mirror image; null: none. offset [m]: one number per component,
 * which count counts. Errors: CD_ERROR_RANGE, CD_ERROR_VALUE; CD_ERROR_DIVERGED for a state that is not finite. */
CD_API cd_status cd_chain_teleport(cd_chain* chain, size_t strand, const double* rotation, const double* offset,
                                   size_t count);

/* Ties a node to its target by a spring of `stiffness` [N/m] >= 0 and `damping` [N s/m] >= 0, as a mouse drag does. In
 * a rope it is the node of this strand; in a chain that is no rope `strand` must be 0, and the node of every strand is
 * tied. target, one number per component, is given to every strand that is tied; null: the present position, and count
 * means nothing. Move it afterwards by writing CD_TARGET. Attaching again changes the numbers. Switches CD_TARGET on.
 * Errors: CD_ERROR_RANGE; attach: CD_ERROR_VALUE, CD_ERROR_MEMORY, and CD_ERROR_DIVERGED for a state that is not
 * finite. */
CD_API cd_status cd_chain_attach(cd_chain* chain, size_t strand, size_t node, double stiffness, double damping,
                                 const double* target, size_t count);
CD_API cd_status cd_chain_detach(cd_chain* chain, size_t strand, size_t node);
CD_API cd_status cd_chain_get_attachment(const cd_chain* chain, size_t strand, size_t node, double* out_stiffness,
                                         double* out_damping);

/* Cuts a spring (stiffness 0) or welds it (infinite stiffness), in a rope of this strand; in a chain that is no rope
 * `strand` must be 0, and it is done in every strand. From a weld on the two nodes share one velocity, the mean of
 * theirs by mass, so that momentum is kept, and their offset stays as it is. Welding to a held node gives that node's
 * velocity. A cut or welded spring gets a stiffness again by writing CD_STIFFNESS. Both switch CD_STIFFNESS on. Bend is
 * not cut with the spring: write CD_BEND. In a rope it is, as long as the stiffness is 0, and welding fixes the
 * spring's length only.
 * Errors: CD_ERROR_RANGE, CD_ERROR_MEMORY; weld: CD_ERROR_UNSUPPORTED if it would join two held nodes. */
CD_API cd_status cd_chain_cut(cd_chain* chain, size_t strand, size_t spring);
CD_API cd_status cd_chain_weld(cd_chain* chain, size_t strand, size_t spring);

/* ---- time ------------------------------------------------------------------------------------------------------- */

/* Makes `count` steps of dt [s] each, 0 or in [1e-30, 1e30]: with 0 no time passes, as with 0 steps.
 * Never allocates. Time is proportional to count * strands * nodes * components.
 * Errors: CD_ERROR_VALUE; CD_ERROR_DIVERGED if a number leaves the finite range: all steps are made, the message gives
 * the first bad one, the chain can be read, and steps again after cd_chain_reset, a load, or once finite positions and
 * velocities have been written; of ropes CD_ERROR_UNSUPPORTED for what they can't have, CD_ERROR_CALLBACK as
 * cd_chain_set_callback says, and CD_ERROR_TOLERANCE if a step ended short of its tolerance: all steps are made, and
 * good to the error that cd_chain_get_convergence tells, but for tensions: see cd_chain_get_reaction. */
CD_API cd_status cd_chain_step(cd_chain* chain, double dt, size_t count);

/* The longest dt at which CD_METHOD_SYMPLECTIC_EULER stays bounded, whatever method is set: the largest dt with
 * 4 M - 2 dt C - dt^2 K positive definite. Exact for stretch with drag and stiffness damping; with bend a lower bound,
 * exact in the limit of many nodes; with matched ends and attachment damping a lower bound, and close. INFINITY if
 * nothing can swing. Errors: CD_ERROR_UNSUPPORTED of ropes. */
CD_API cd_status cd_chain_stable_dt(const cd_chain* chain, double* out_dt);

/* Simulated time [s] and steps made since create or reset, those before a load or a copied state included. */
CD_API cd_status cd_chain_get_time(const cd_chain* chain, double* out_time);
CD_API cd_status cd_chain_get_steps(const cd_chain* chain, uint64_t* out_steps);

/* How many factorizations the chain has made: one at the first implicit step and one at the first after each change of
 * dt, lambda, method or a parameter. Ropes make none. Not part of the saved state. */
CD_API cd_status cd_chain_get_factorizations(const cd_chain* chain, uint64_t* out_count);

/* ---- measuring --------------------------------------------------------------------------------------------------- */

/* Energies of all strands together [J]; each output may be null. Kinetic: of the free nodes. Elastic: stretch, bend
 * and attachments; a welded spring holds none. Gravity: -sum m g x of the free nodes. Undamped, lambda = 1/2
 * keeps their sum, of ropes but for what is told of them. */
CD_API cd_status cd_chain_get_energy(const cd_chain* chain, double* out_kinetic, double* out_elastic,
                                     double* out_gravity);

/* Momentum of the free nodes of all strands together [kg m/s], one number per component.
 * Errors: CD_ERROR_RANGE if count is not the number of components. */
CD_API cd_status cd_chain_get_momentum(const cd_chain* chain, double* out_momentum, size_t count);

/* Positions of one strand at places along it, linear between nodes: at[j] in [0, springs] (ring: to springs + 1),
 * out_positions[j][component], out_count = n * components. Errors: CD_ERROR_RANGE if there is no such strand or
 * out_count is another number; CD_ERROR_ENUM; CD_ERROR_VALUE for a place beyond the strand. */
CD_API cd_status cd_chain_sample(const cd_chain* chain, size_t strand, const double* at, size_t n,
                                 cd_outside outside, double* out_positions, size_t out_count);

/* Bytes the chain holds from its allocator. */
CD_API cd_status cd_chain_get_memory(const cd_chain* chain, size_t* out_bytes);

/* A 64-bit hash of everything cd_chain_save would write. Equal on every machine, compiler and vector width. */
CD_API cd_status cd_chain_hash(const cd_chain* chain, uint64_t* out_hash);

/* ---- keeping ----------------------------------------------------------------------------------------------------- */

/* The whole state as bytes: shape, parameters, fields, time: all the future depends on but the callbacks. Little-endian
 * on every machine, versioned, with a checksum. save needs size >= cd_chain_save_size and tells what it wrote.
 * load needs a chain of the same shape and precision; it switches fields on and off as they were. Bytes that are
 * damaged, cut short, of a later version or another kind are refused and change nothing.
 * Errors: save: CD_ERROR_RANGE. load: CD_ERROR_FORMAT, CD_ERROR_MISMATCH, CD_ERROR_MEMORY. */
CD_API cd_status cd_chain_save_size(const cd_chain* chain, size_t* out_size);
CD_API cd_status cd_chain_save(const cd_chain* chain, void* buffer, size_t size, size_t* out_written);
CD_API cd_status cd_chain_load(cd_chain* chain, const void* bytes, size_t size);

/* Makes `chain` what `source` is, as save and load would, without the bytes: the two must agree in shape and precision.
 * Allocates only if they differ in the fields switched on. Errors: CD_ERROR_MISMATCH, CD_ERROR_MEMORY. */
CD_API cd_status cd_chain_copy_state(cd_chain* chain, const cd_chain* source);

/* Positions, velocities, tensions, time and steps back to 0. Parameters, fields and pins stay; targets too. */
CD_API cd_status cd_chain_reset(cd_chain* chain);

#ifdef __cplusplus
}
#endif

#endif
