/* contdyn: a membrane: nodes joined by springs in two directions: drum, balloon, plate, and with rest lengths cloth.
 *
 * A membrane has `nu` springs along u and `nv` along v, and (nu + 1) (nv + 1) nodes; node (u, v) has the number
 * v (nu + 1) + u wherever nodes are listed. A node has 1 to 4 components that never mix. A direction can be closed to a
 * ring: its last nodes are then joined to the first by one spring more.
 *
 * Energy    E = 1/2 sum k_u |x_{u+1,v} - x_{u,v}|^2 + 1/2 sum k_v |x_{u,v+1} - x_{u,v}|^2
 *             + 1/2 sum b (|x_uu|^2 + 2 |x_uv|^2 + |x_vv|^2)           (Kass 1997, section 8; the thin plate's energy)
 * Motion    M x'' + C x' + K x = M g + f + pressure along the normal,  K = the Hessian of E,
 *           C = drag M + stiffness_damping K
 *
 * Rest length is zero, unless cd_membrane_set_rest_length makes the membrane cloth: a free sheet draws together, and
 * one stretched evenly is held by its edges. A new membrane lies at the origin, at rest, all nodes free, mass 1,
 * stiffness 1 both ways, no bend, gravity and damping, CD_METHOD_IMPLICIT with lambda 1/2, CD_SOLVER_AUTO.
 *
 * Which solver? An implicit step of a sheet without rest lengths has a two-dimensional system to solve, here with h =
 * lambda dt. Leave that to CD_SOLVER_AUTO, or take CD_SOLVER_ALTERNATING for a fixed cost and less memory. A sheet is
 * uniform here if its masses and stiffnesses are the totals dealt out and no node is absent; if nothing holds it but
 * whole rows and columns and at most 16 single nodes, held or attached, these while h (h + damping) (2 k + 16 b) is at
 * most 1e4 times a node's mass; and if with bend each direction is held at both edges or a ring, not both a ring.
 *   CD_SOLVER_ALTERNATING  rows, then columns (Kass 1997, section 9). Uniform sheets are stable at any stiffness and
 *      any dt that stays the same. A motion of the angular frequencies w_u and w_v along the two directions is slowed
 *      down as if it were 1 + (w_u h)^2 (w_v h)^2 times as heavy; where the sheet comes to rest does not depend on dt.
 *      Other sheets, a plate that is a ring both ways among them, would blow up: their step, not quite linear and at
 *      six times the cost, is the best, in energy, of sums of the lines' answers, the velocity and common motion. It
 *      leaves slow motions anywhere where fast ones have energy: a plate with a hole was off by all that it swung.
 *   CD_SOLVER_COUPLED      the system itself, to a tolerance, by conjugate gradients: nothing is slowed down. Uniform
 *      sheets without bend and rings take one or two iterations of some ten alternating solves each, others multigrid,
 *      4 to 100 times the cost. It comes to rest where alternating does. Take it where stiff sheets must move in time,
 *      or stiff parts against each other: alternating finds only their common motion. It needs many iterations where
 *      springs or masses vary at random by decades, plates with free edges hardly stretch or many nodes are tied.
 *   CD_SOLVER_AUTO         of uniform sheets, for each dt, alternating where the slowest motion (half a wave along each
 *      direction, round a ring a whole one, with the kinks at held or attached nodes) is made at most 5% heavier. Else
 *      coupled; and so, until cd_membrane_reset, uniform sheets that have been coupled once, whose steps have differed
 *      in dt, method, lambda, damping or solver, or of which moving nodes were pinned. At that bound a kick of one of
 *      33 x 33 nodes goes 31 times as far as it should, of a radius of an eighth of the sheet 3.5, of a quarter 1.4. It
 *      holds some 300 bytes a node; alternating takes 36 where edges hold it. Builds without coupled solver alternate.
 * Steps are of second order in time, those of alternating plates with stiffness damping of first. Without rest lengths:
 *   Energy: lambda = 1/2 keeps it, and lambda > 1/2 never adds any, whatever the tolerance of coupled solves.
 *   Momentum: of a free sheet, and of each part of a torn one, it is kept however stiff they are; alternating, up to a
 *      stiffness of 1e19 mass / h^2 of uniform sheets, and a bend of 1e13 mass / h^2 of plates with one ring.
 *   Unlike steps: alternating, the energy that a uniform sheet keeps counts the extra mass, which depends on dt, lambda
 *      and damping. If these keep changing it grows without bound: with lambda = 1/2 or CD_METHOD_STIFF_SECOND by up to
 *      an eighth a step where 16 and 17 ms take turns, with lambda = 1 by a quarter where some steps are twice as long.
 *   CD_FLOAT32: alternating, the rounding of a velocity is a kick whose energy is so many times larger as the motion is
 *      heavier: where (w_u h) (w_v h) is beyond 1e4, take CD_FLOAT64 or the coupled solver.
 *   CD_METHOD_STIFF_SECOND: adds no energy where coupled solves meet the default tolerance; a step that ended short of
 *      its own has added a third, one that alternates on a sheet that is not uniform a twentieth.
 * What chain.h says of precision and of numbers that are too small holds for sheets too. Parameters may be as large as
 * 1e60, masses as small as 1e-60. Every function returns CD_ERROR_NULL for a null pointer and CD_ERROR_HANDLE for a
 * handle of another kind; the comments name the other errors. Functions that the chain has too mean the same here. */
#ifndef CONTDYN_MEMBRANE_H
#define CONTDYN_MEMBRANE_H

#include "base.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct cd_membrane cd_membrane;

/* The four edges of a membrane. A corner belongs to two. */
typedef int32_t cd_edge;
enum {
    CD_EDGE_U_FIRST = 0, /* the nodes with u = 0 */
    CD_EDGE_U_LAST = 1,  /* u = nu */
    CD_EDGE_V_FIRST = 2, /* v = 0 */
    CD_EDGE_V_LAST = 3   /* v = nv */
};

/* ---- life ------------------------------------------------------------------------------------------------------ */

/* Makes a membrane. nu, nv >= 0 (0: a single row or column of nodes); components 1 to 4. allocator may be null
 * (malloc). The caller owns *out_membrane and releases it with cd_membrane_destroy; on failure *out_membrane is left
 * alone. Errors: CD_ERROR_VALUE, CD_ERROR_ENUM, CD_ERROR_SIZE, CD_ERROR_MEMORY; CD_ERROR_UNSUPPORTED for a precision
 * that this build leaves out. */
CD_API cd_status cd_membrane_create(size_t nu, size_t nv, size_t components, cd_precision precision,
                                    const cd_allocator* allocator, cd_membrane** out_membrane);

/* Releases a membrane and all its memory. Null does nothing; a handle of another kind is left alone. */
CD_API void cd_membrane_destroy(cd_membrane* membrane);

/* What cd_membrane_create was given. Each output may be null. */
CD_API cd_status cd_membrane_get_shape(const cd_membrane* membrane, size_t* out_nu, size_t* out_nv,
                                       size_t* out_components, cd_precision* out_precision);

/* ---- method ------------------------------------------------------------------------------------------------------ */

/* How steps are made. Methods and solvers differ in the memory they need. Errors: CD_ERROR_ENUM; CD_ERROR_MEMORY. */
CD_API cd_status cd_membrane_set_method(cd_membrane* membrane, cd_method method);
CD_API cd_status cd_membrane_get_method(const cd_membrane* membrane, cd_method* out_method);

/* lambda of CD_METHOD_IMPLICIT, in [0, 1]; default 1/2. Errors: CD_ERROR_VALUE. */
CD_API cd_status cd_membrane_set_lambda(cd_membrane* membrane, double lambda);
CD_API cd_status cd_membrane_get_lambda(const cd_membrane* membrane, double* out_lambda);

/* How implicit steps solve their system; see above. Errors: CD_ERROR_ENUM; CD_ERROR_MEMORY. */
CD_API cd_status cd_membrane_set_solver(cd_membrane* membrane, cd_solver solver);
CD_API cd_status cd_membrane_get_solver(const cd_membrane* membrane, cd_solver* out_solver);
/* Which of the two the last step took that found it awake; CD_SOLVER_AUTO: neither. Not part of the saved state. */
CD_API cd_status cd_membrane_get_solver_taken(const cd_membrane* membrane, cd_solver* out_solver);

/* When CD_SOLVER_COUPLED is content: a residual of `tolerance` times the one it starts from, in [1e-14, 1/2], default
 * 1e-6. Each component's is the Euclidean norm of its nodes', each over its diagonal entry of the system. It may take
 * most_iterations, >= 1, default 100, and ends when 500 have not halved the residual, which rounding may keep from
 * falling. cd_membrane_step says CD_ERROR_TOLERANCE where it ends short of the tolerance. Errors: CD_ERROR_VALUE. */
CD_API cd_status cd_membrane_set_tolerance(cd_membrane* membrane, double tolerance, size_t most_iterations);
CD_API cd_status cd_membrane_get_tolerance(const cd_membrane* membrane, double* out_tolerance,
                                           size_t* out_most_iterations);
/* What the last call of cd_membrane_step did when it took CD_SOLVER_COUPLED: the most iterations that a solve needed,
 * and the largest residual it ended with, as a fraction of the one it started from: INFINITY where its square is. 0 and
 * 0 if there was no such solve. Soft motions beside stiff ones may be off by more. Each output may be null. */
CD_API cd_status cd_membrane_get_convergence(const cd_membrane* membrane, size_t* out_iterations, double* out_residual);

/* Spreads a step over the caller's threads. Null turns it off. Errors: CD_ERROR_NULL for a table without run. */
CD_API cd_status cd_membrane_set_parallel(cd_membrane* membrane, const cd_parallel* parallel);

/* The instructions that steps are made of, as cd_chain_set_kernels says. Not part of the saved state.
 * Errors: CD_ERROR_ENUM; CD_ERROR_UNSUPPORTED for kernels that are not among cd_runnable_kernels. */
CD_API cd_status cd_membrane_set_kernels(cd_membrane* membrane, cd_kernels kernels);
CD_API cd_status cd_membrane_get_kernels(const cd_membrane* membrane, cd_kernels* out_kernels);

/* ---- parameters -------------------------------------------------------------------------------------------------- */
/* Totals of the sheet. A change takes effect at the next step and costs it one refactorization. Where the field of
 * the same name is switched on, setting the total writes the whole field anew. A getter tells the total last set.
 * Errors of all setters: CD_ERROR_VALUE for a number that is NaN, infinite or out of range; CD_ERROR_ENUM. */

/* Mass [kg], > 0. CD_MASS_EQUAL: mass / ((nu + 1) (nv + 1)) per node. CD_MASS_HALF_ENDS: an edge line counts half, in
 * its masses and in the springs and bends along it: mass / (nu nv) per node inside, half of it on an edge, a quarter at
 * a corner. In a direction that is a ring or has no spring the rules agree, and in what follows its nu + 1 and nu (or
 * nv + 1 and nv) are both the number of its nodes. The rule deals out mass and stiffness anew. */
CD_API cd_status cd_membrane_set_mass(cd_membrane* membrane, double mass);
CD_API cd_status cd_membrane_get_mass(const cd_membrane* membrane, double* out_mass);
CD_API cd_status cd_membrane_set_mass_rule(cd_membrane* membrane, cd_mass_rule rule);
CD_API cd_status cd_membrane_get_mass_rule(const cd_membrane* membrane, cd_mass_rule* out_rule);

/* Stretch stiffness along u and along v [N/m], >= 0: a sheet stretched evenly along u by the length d holds the energy
 * k_u d^2 / 2. Per spring along u: nu k_u / (nv + 1), half edges: nu k_u / nv and half of it along the edges; along v
 * likewise. Waves run across the sheet along u in sqrt(mass / k_u) seconds. A sheet of 1 component has no size of its
 * own: with the sides L_u and L_v under the tension S [N/m] k_u = S L_v / L_u and k_v = S L_u / L_v, a square one S. */
CD_API cd_status cd_membrane_set_stiffness(cd_membrane* membrane, double along_u, double along_v);
CD_API cd_status cd_membrane_get_stiffness(const cd_membrane* membrane, double* out_along_u, double* out_along_v);

/* Bend stiffness b [N/m], >= 0, of E = b/2 times the integral of |x_uu|^2 + 2 |x_uv|^2 + |x_vv|^2 over the unit square
 * of u and v. Per node with two neighbours along u: b nu^3 / (nv + 1), half edges: b nu^3 / nv and half of it along the
 * edges; along v likewise; per cell, on the squared twist: twice their geometric mean. A square plate of side L with b
 * = D / L^2 has the flexural rigidity D [N m]; one of L_u by L_v has b L_u^3 / L_v along u, b L_v^3 / L_u along v and b
 * L_u L_v in twist. Cut springs do not cut it, but CD_MASK. Errors: CD_ERROR_MEMORY when bend is switched on. */
CD_API cd_status cd_membrane_set_bend(cd_membrane* membrane, double bend);
CD_API cd_status cd_membrane_get_bend(const cd_membrane* membrane, double* out_bend);

/* Drag [1/s], >= 0: every node loses velocity at this rate. */
CD_API cd_status cd_membrane_set_drag(cd_membrane* membrane, double drag);
CD_API cd_status cd_membrane_get_drag(const cd_membrane* membrane, double* out_drag);

/* Stiffness damping [s], >= 0: stretch and bend damp at this time constant; a mode of angular frequency w loses
 * amplitude at the rate (drag + stiffness_damping w^2) / 2. Cloth takes none. */
CD_API cd_status cd_membrane_set_stiffness_damping(cd_membrane* membrane, double seconds);
CD_API cd_status cd_membrane_get_stiffness_damping(const cd_membrane* membrane, double* out_seconds);

/* Gravity [m/s^2], one number per component, at most 1e60 in size, in CD_FLOAT32 1e30.
 * Errors: CD_ERROR_RANGE if count is not the number of components. */
CD_API cd_status cd_membrane_set_gravity(cd_membrane* membrane, const double* gravity, size_t count);
CD_API cd_status cd_membrane_get_gravity(const cd_membrane* membrane, double* out_gravity, size_t count);

/* Pressure [Pa] on the sheet along its normal x_u x x_v, of either sign, at most 1e60 in size: the force on a node is
 * pressure times the gradient of the volume under the sheet, at an edge its part of the cells' areas, at the positions
 * a step starts from. It grows with the sheet, beyond some half of stiffness / side without end. 3 components only;
 * costs memory while not 0. Errors: CD_ERROR_UNSUPPORTED for other components unless 0; CD_ERROR_MEMORY. */
CD_API cd_status cd_membrane_set_pressure(cd_membrane* membrane, double pressure);
CD_API cd_status cd_membrane_get_pressure(const cd_membrane* membrane, double* out_pressure);

/* What holds an edge; a corner is pinned if either of its edges is, else driven, else posed if either is. Pinning
 * stops the nodes; driving leaves their velocity, which is then written through CD_VELOCITY; posing switches CD_TARGET
 * on and sets the edge's targets to where it is: write the next ones there. CD_NODE_MATCHED leaves the edge free, with
 * the impedance that sends no echo back to a wave that runs straight at it. Where CD_PIN is switched on, all but
 * matched are written to it along the edge. The getter tells what was set last, whatever was written to CD_PIN since.
 * Errors: CD_ERROR_ENUM; CD_ERROR_UNSUPPORTED for CD_NODE_MATCHED in the direction of a ring; CD_ERROR_MEMORY;
 * CD_ERROR_DIVERGED for CD_NODE_POSED where the state is not finite. */
CD_API cd_status cd_membrane_set_edge(cd_membrane* membrane, cd_edge edge, cd_node kind);
CD_API cd_status cd_membrane_get_edge(const cd_membrane* membrane, cd_edge edge, cd_node* out_kind);

/* Joins the last nodes along u (along v) to the first (1), or opens them (0). Totals are dealt out anew, and fields of
 * masses and stiffnesses get the uniform values. A ring needs 3 nodes. Errors: CD_ERROR_VALUE for anything but 0 and
 * 1; CD_ERROR_UNSUPPORTED with fewer than 3 nodes or a matched edge; CD_ERROR_MEMORY. */
CD_API cd_status cd_membrane_set_ring(cd_membrane* membrane, int32_t along_u, int32_t along_v);
CD_API cd_status cd_membrane_get_ring(const cd_membrane* membrane, int32_t* out_along_u, int32_t* out_along_v);

/* Lets a sheet sleep, as a whole, once it has been slower than `speed` [m/s], in [0, 1e60], for some `seconds` [s], in
 * [1e-30, 1e60]: as cd_chain_set_sleep says; the effort wakes nothing. Errors: CD_ERROR_VALUE; CD_ERROR_MEMORY. */
CD_API cd_status cd_membrane_set_sleep(cd_membrane* membrane, double speed, double seconds);
CD_API cd_status cd_membrane_get_sleep(const cd_membrane* membrane, double* out_speed, double* out_seconds);
CD_API cd_status cd_membrane_get_awake(const cd_membrane* membrane, size_t* out_nodes);

/* ---- cloth: springs that have a length --------------------------------------------------------------------------- */
/* Cloth is a membrane with rest lengths. The 3 components of a node are directions of space, and a spring of stiffness
 * k and rest length L that is l long pulls by
 *     0 up to l = L,   k (l - L)^2 / 0.012 L up to l = 1.006 L,   k (l - 1.003 L) beyond,
 * so that cloth is slack where it is shorter and stretches by 0.3% before it has all of its stiffness; it does not
 * shrink. Springs that are shorter resist crumpling by cd_membrane_set_compression. A cell with its four springs has
 * shear and twist, a node between two springs of a line has bend; where one of those springs is cut they are cut too.
 *
 * Steps: a step minimizes a convex function of the velocities, by Newton's method with few iterations of conjugate
 *    gradients (cd_membrane_set_effort), and then scales the velocities. They are of first order in time. lambda = 1
 *    damps motion that a step does not resolve; lambda nearer 1/2 damps it less, and needs more effort.
 * Energy: at any dt, stiffness, masses and effort, what cd_membrane_get_energy tells rises only by the work of driven
 *    nodes, forces, pressure, wind and moving colliders. Free sheets, and free parts of torn ones, keep their momentum.
 * Stiff sheets, default effort: at 10 mass / dt^2 [N/m] they fall 2% too slowly, and stretch by 2% where two corners
 *    hold them; at 100 2%, at 1000 5%, at 1e4 20%; beyond, only along with what holds or pushes them: shorten steps.
 * Cloth needs CD_METHOD_IMPLICIT, lambda in [1/2, 1], no matched edge, no stiffness damping, or cd_membrane_step says
 * CD_ERROR_UNSUPPORTED; cd_membrane_set_solver and _set_tolerance do not matter to it. */

/* Rest lengths of the sheet along u and along v [m], 0 or in [1e-60, 1e60]; default 0: no cloth. Both are 0 or neither
 * is. Per spring: length / springs, in a ring as well; nodes stay where they are. Making cloth of a membrane sets
 * lambda to 1. Length 0 switches the fields of cloth off, and breaking strain, air, wind and colliders too. Errors:
 * CD_ERROR_VALUE; CD_ERROR_MEMORY; CD_ERROR_UNSUPPORTED without 3 components and springs along both directions. */
CD_API cd_status cd_membrane_set_rest_length(cd_membrane* membrane, double along_u, double along_v);
CD_API cd_status cd_membrane_get_rest_length(const cd_membrane* membrane, double* out_along_u, double* out_along_v);

/* Shear stiffness [N/m], >= 0, default 0, of a spring along each diagonal of every cell, with the law and the mean
 * rest lengths of the cell's springs. Of square cells the shear modulus is half of it [N/m].
 * Errors here and below: CD_ERROR_VALUE; CD_ERROR_UNSUPPORTED of a membrane that is no cloth. */
CD_API cd_status cd_membrane_set_shear(cd_membrane* membrane, double stiffness);
CD_API cd_status cd_membrane_get_shear(const cd_membrane* membrane, double* out_stiffness);

/* What keeps cloth from crumpling: springs along u and v that are shorter than their length push by c (L - l), longer
 * ones pull by as much, c dealt out as a stiffness of mass * rate. rate [1/s^2] >= 0, default 80: flags of a metre wave
 * in winds up to 12 m/s with 0.4% folded sharply at most; smaller ones want more. It damps folds from node to node. */
CD_API cd_status cd_membrane_set_compression(cd_membrane* membrane, double rate);
CD_API cd_status cd_membrane_get_compression(const cd_membrane* membrane, double* out_rate);

/* The strain, length over rest length less 1, at which a spring tears, whatever its stiffness: 1e-60 to 1e60, or
 * INFINITY, the default: springs hold. The fields CD_BREAKING_STRAIN_U and _V have one for each spring: a seam is a
 * line of springs that tear at less. A step ends by cutting springs beyond their breaking strains, in each row and each
 * column of springs at most one. First goes the spring whose strain is the largest multiple of its breaking strain;
 * then its neighbour in the next row, and so on from row to row, while that is beyond its breaking strain too; then the
 * same in the rows that are left. So tears go on from their ends, and jerked cloth parts without falling to pieces. A
 * cut spring's stiffness becomes 0, and adds no energy. Mend it by writing CD_STIFFNESS_U or _V, which finite breaking
 * strains switch on and keep on. A cell of cloth that lacks two or more springs is open: it is not drawn, it has no
 * volume, and air and pressure go through it. Errors: CD_ERROR_MEMORY too. */
CD_API cd_status cd_membrane_set_breaking_strain(cd_membrane* membrane, double strain);
CD_API cd_status cd_membrane_get_breaking_strain(const cd_membrane* membrane, double* out_strain);
/* How many springs tore in the last call of cd_membrane_step that made steps: those whose stiffness became 0. Where
 * there are any, cd_membrane_write_indices may write other triangles than before. */
CD_API cd_status cd_membrane_get_broken(const cd_membrane* membrane, size_t* out_springs);

/* How much a step may do: iterations of Newton's method, `newton`, 1 to 1000, default 3, and in each those of conjugate
 * gradients, `gradient`, 1 to 10000, or 0, the default: until four bring less than 3% of the energy that all brought.
 * Up to 4 more of Newton's are made where it gains little, with gradient 0 also where it still gains much. After a step
 * get_convergence tells the most of conjugate gradients that a step took, and what gradient was left over the first. */
CD_API cd_status cd_membrane_set_effort(cd_membrane* membrane, size_t newton, size_t gradient);
CD_API cd_status cd_membrane_get_effort(const cd_membrane* membrane, size_t* out_newton, size_t* out_gradient);

/* Resistance of the air, per area of cloth [N s/m^3], in [0, 1e60], default 0: a piece of area a whose velocity
 * through the air is w, w_t along the cloth and w_n across it, is pushed by -a (along w_t + across w_n). Implicit, so
 * that it only takes energy, as seen from the air, at any dt; areas and directions are those that the step starts
 * from. Air of density 1.2 kg/m^3 that passes at the speed s has about across = 1.2 s and along = 0.02 s. A node
 * on an edge bears half the air: with CD_MASS_EQUAL, where it has the whole mass, a flat sheet folds as it falls;
 * with CD_MASS_HALF_ENDS it falls flat. Errors: CD_ERROR_MEMORY too. */
CD_API cd_status cd_membrane_set_air(cd_membrane* membrane, double along, double across);
CD_API cd_status cd_membrane_get_air(const cd_membrane* membrane, double* out_along, double* out_across);

/* Velocity of that air [m/s], one number per component, default 0; the field CD_WIND has one for each node.
 * Errors: CD_ERROR_RANGE too, if count is not the number of components. */
CD_API cd_status cd_membrane_set_wind(cd_membrane* membrane, const double* velocity, size_t count);
CD_API cd_status cd_membrane_get_wind(const cd_membrane* membrane, double* out_velocity, size_t count);

/* ---- what cloth touches ------------------------------------------------------------------------------------------ */
/* As ropes do, the nodes of cloth stay outside of colliders, numbered from 0: half spaces and capsules, spheres among
 * them, beds and callbacks, each with velocity and friction of its own. In a step a node meets the three that it would
 * be deepest in, or nearest to, at its velocity, as the planes that touch them where the step begins: it goes through
 * none of them, however fast. Nodes collide; what lies between them does not, nor does cloth with itself.
 * Depth: contacts yield by a node's force times dt^2 / (1e4 mass), some 1e-3 m where a sheet lands at 50 m/s; with the
 *    default effort nodes are now and then deeper, by up to 7e-3 m in steps that move them by 0.1 m. What lies inside
 *    comes out, and what that lifts or stretches gains energy: at 1e9 N/m 1e-3 of it a step.
 * Friction is Coulomb's, times v / (v + 1e-3 m/s) at the speed v, of the push that the step's iterations find. With the
 *    default effort, what begins to slide is up to a quarter too slow in its first half second. What friction holds
 *    creeps, at half of the largest force that it can hold by 1e-3 m/s.
 * Beds and callbacks are those of cd_chain, met at the plane that touches them where a step finds a node: what a hollow
 * rises above that plane a node may end inside of, and the next step takes it out. A callback is asked once a step, for
 * all nodes; answers that it may not give make cd_membrane_step say CD_ERROR_CALLBACK, and one that is missing after a
 * load CD_ERROR_UNSUPPORTED. Errors and ranges are those of the functions of cd_chain. */
CD_API cd_status cd_membrane_set_colliders(cd_membrane* membrane, size_t count);
CD_API cd_status cd_membrane_get_colliders(const cd_membrane* membrane, size_t* out_count);
CD_API cd_status cd_membrane_set_plane(cd_membrane* membrane, size_t index, const double* point, const double* normal,
                                       size_t count, double friction);
CD_API cd_status cd_membrane_set_capsule(cd_membrane* membrane, size_t index, const double* first, const double* last,
                                         size_t count, double radius, double friction);
CD_API cd_status cd_membrane_set_bed(cd_membrane* membrane, size_t index, const double* origin, size_t count,
                                     size_t columns, size_t rows, double column_spacing, double row_spacing,
                                     const double* heights, size_t height_count, double friction);
/* Each output may be null. */
CD_API cd_status cd_membrane_get_bed(const cd_membrane* membrane, size_t index, size_t* out_columns, size_t* out_rows,
                                     double* out_heights, size_t height_count);
/* origin may be null where the collider is CD_SHAPE_CALLBACK already: it stays as it is. */
CD_API cd_status cd_membrane_set_callback(cd_membrane* membrane, size_t index, const cd_distance* distance,
                                          const double* origin, size_t count, double friction);
CD_API cd_status cd_membrane_remove_collider(cd_membrane* membrane, size_t index);
CD_API cd_status cd_membrane_set_collider_velocity(cd_membrane* membrane, size_t index, const double* velocity,
                                                   size_t count);
/* Each output may be null. */
CD_API cd_status cd_membrane_get_collider(const cd_membrane* membrane, size_t index, cd_shape* out_shape,
                                          double* out_first, double* out_second, double* out_velocity, size_t count,
                                          double* out_radius, double* out_friction);
/* What cloth does to colliders, as cd_chain_get_collider_load says: what the momentum of each node that meets one lacks,
 * and of a part of the sheet that nothing holds that of all its nodes. So of free sheets the sum is right whatever the
 * effort; of held ones as right as the step's velocities are. */
CD_API cd_status cd_membrane_set_loads(cd_membrane* membrane, int32_t loads);
CD_API cd_status cd_membrane_get_loads(const cd_membrane* membrane, int32_t* out_loads);
CD_API cd_status cd_membrane_get_collider_load(const cd_membrane* membrane, size_t index, double* out_load,
                                               size_t count);
/* How thick cloth is, as a distance [m] in [0, 1e60], default 0, that nodes keep from colliders. */
CD_API cd_status cd_membrane_set_thickness(cd_membrane* membrane, double distance);
CD_API cd_status cd_membrane_get_thickness(const cd_membrane* membrane, double* out_distance);

/* ---- fields -------------------------------------------------------------------------------------------------------
 *  field                per       unit    values
 *  CD_POSITION          node      m       finite
 *  CD_VELOCITY          node      m/s     finite; of a pinned or absent node only 0
 *  CD_FORCE             node      N       finite; acts until it is overwritten
 *  CD_TARGET            node      m       finite; where cd_membrane_attach pulls to, and where CD_NODE_POSED goes
 *  CD_MASS              node      kg      > 0
 *  CD_STIFFNESS_U       spring    N/m     >= 0; 0: cut. Spring (u, v) joins node (u, v) to (u + 1, v)
 *  CD_STIFFNESS_V       spring    N/m     >= 0; 0: cut. Spring (u, v) joins node (u, v) to (u, v + 1)
 *  CD_PIN               node      -       any cd_node but CD_NODE_MATCHED; whole edges need it not, see
 *                                         cd_membrane_set_edge
 *  CD_MASK              node      -       1: there; 0: absent, with all that touches it: it stands still where it is
 *                                         and counts for nothing
 *  CD_REST_LENGTH_U     spring    m       1e-60 to 1e60; of cloth only, as are all that follow
 *  CD_REST_LENGTH_V     spring    m       likewise
 *  CD_BREAKING_STRAIN_U spring    -       1e-60 to 1e60, or INFINITY
 *  CD_BREAKING_STRAIN_V spring    -       likewise
 *  CD_WIND              node      m/s     finite
 *  CD_TENSION_U, _V     spring    N       to read only: what the spring pulls by now, less than 0 where it pushes
 *  CD_STRAIN_U, _V      spring    -       to read only: length now over rest length, less 1; -1 and more
 * Position and velocity are always there, tension and strain in cloth. The others cost memory and time only once they
 * are switched on; CD_MASS, the stiffnesses, CD_TARGET, CD_PIN and CD_MASK make a sheet that is no cloth one whose
 * lines differ, with factors for each of them. */

/* Switches a field on, filled with the present uniform values (force 0, target the present position, mask 1, pin
 * what the edges say). CD_BREAKING_STRAIN_U and _V switch CD_STIFFNESS_U and _V on too. On already: nothing happens.
 * Errors: CD_ERROR_ENUM, CD_ERROR_MEMORY; CD_ERROR_DIVERGED for CD_TARGET where the state is not finite; here and below
 * CD_ERROR_UNSUPPORTED for the fields of cloth of a membrane that is none. */
CD_API cd_status cd_membrane_enable_field(cd_membrane* membrane, cd_field field);

/* Switches a field off and releases its memory: uniform values again, no forces, all attachments loosened, all nodes
 * there, none held but on edges. Errors: CD_ERROR_ENUM; CD_ERROR_UNSUPPORTED for position, velocity,
 * tension and strain, and for the stiffness of springs that may tear. */
CD_API cd_status cd_membrane_disable_field(cd_membrane* membrane, cd_field field);

/* Writes or reads values[v][u][component], dense, of the rectangle of nodes (or springs) [first_u, first_u + n_u) x
 * [first_v, first_v + n_v). Fields without components have one value per node or spring; there are nu (ring: nu + 1)
 * springs along u and nv + 1 rows of them, and likewise along v. `count` is the number of values in the buffer:
 * n_u * n_v * components. Numbers are rounded once, to the precision of the side that is narrower. Never allocates.
 * Errors: CD_ERROR_ENUM, CD_ERROR_DISABLED, CD_ERROR_RANGE; write: CD_ERROR_VALUE, with the first bad index, and
 * CD_ERROR_UNSUPPORTED for tension and strain. */
CD_API cd_status cd_membrane_write_f32(cd_membrane* membrane, cd_field field, size_t first_u, size_t first_v,
                                       size_t n_u, size_t n_v, const float* values, size_t count);
CD_API cd_status cd_membrane_write_f64(cd_membrane* membrane, cd_field field, size_t first_u, size_t first_v,
                                       size_t n_u, size_t n_v, const double* values, size_t count);
CD_API cd_status cd_membrane_read_f32(const cd_membrane* membrane, cd_field field, size_t first_u, size_t first_v,
                                      size_t n_u, size_t n_v, float* out_values, size_t count);
CD_API cd_status cd_membrane_read_f64(const cd_membrane* membrane, cd_field field, size_t first_u, size_t first_v,
                                      size_t n_u, size_t n_v, double* out_values, size_t count);

/* Where a field lies in the membrane's own memory, in the membrane's precision, to read without a copy: the value of
 * (u, v, component) is at byte *out_data + u * u_stride + v * v_stride + component * component_stride. Position,
 * velocity, force and target only. The pointer is good until the field is switched off or the membrane released; the
 * numbers change with every write and step. Do not write through it.
 * Errors: CD_ERROR_ENUM, CD_ERROR_DISABLED, CD_ERROR_UNSUPPORTED. */
CD_API cd_status cd_membrane_view(const cd_membrane* membrane, cd_field field, const void** out_data,
                                  size_t* out_u_stride, size_t* out_v_stride, size_t* out_component_stride);

/* ---- acting on it ------------------------------------------------------------------------------------------------ */

/* Adds impulse [N s], one number per component, spread over the nodes less than `radius` springs away from the place
 * (u, v), counted on the lattice and not round a ring, by weights (1 - (distance / radius)^2)^2, scaled to sum to 1;
 * all on the nearest node if there is none. A node's velocity changes by its share / its mass; held and absent nodes
 * lose it. u in [0, nu], v in [0, nv], radius >= 0. Errors: CD_ERROR_RANGE, CD_ERROR_VALUE, CD_ERROR_DIVERGED. */
CD_API cd_status cd_membrane_impulse(cd_membrane* membrane, double u, double v, double radius, const double* impulse,
                                     size_t count);

/* Moves the sheet as a whole, as if it had always been there: every position and target becomes rotation * x + offset,
 * every velocity rotation * v; colliders stay where they are. rotation: components rows of as many numbers, orthogonal
 * to 1e-6; null: none. offset [m]: one number per component, which count counts.
 * Errors: CD_ERROR_RANGE, CD_ERROR_VALUE; CD_ERROR_DIVERGED for a state that is not finite. */
CD_API cd_status cd_membrane_teleport(cd_membrane* membrane, const double* rotation, const double* offset,
                                      size_t count);

/* Ties a node to its target by a spring of `stiffness` [N/m] >= 0 and `damping` [N s/m] >= 0, as a mouse drag does.
 * target: one number per component; null: the node's present position, and count means nothing. Move it afterwards by
 * writing CD_TARGET. Attaching again changes the numbers. Switches CD_TARGET on. Errors: CD_ERROR_RANGE; attach:
 * CD_ERROR_VALUE, CD_ERROR_MEMORY, and CD_ERROR_DIVERGED for a state that is not finite. */
CD_API cd_status cd_membrane_attach(cd_membrane* membrane, size_t u, size_t v, double stiffness, double damping,
                                    const double* target, size_t count);
CD_API cd_status cd_membrane_detach(cd_membrane* membrane, size_t u, size_t v);
CD_API cd_status cd_membrane_get_attachment(const cd_membrane* membrane, size_t u, size_t v, double* out_stiffness,
                                            double* out_damping);

/* ---- time ------------------------------------------------------------------------------------------------------- */

/* Makes `count` steps of dt [s] each, 0 or in [1e-30, 1e30]: with 0 no time passes, as with 0 steps.
 * Never allocates. Time is proportional to count * nodes * components, with CD_SOLVER_COUPLED to the iterations too.
 * Errors: CD_ERROR_VALUE; CD_ERROR_DIVERGED if a number leaves the finite range: all steps are made, the message gives
 * the first bad one, the membrane can be read, and steps again after cd_membrane_reset, a load, or once finite
 * positions and velocities have been written; CD_ERROR_TOLERANCE if a coupled solve ended short of its tolerance: all
 * steps are made, and good to the residual that cd_membrane_get_convergence tells. */
CD_API cd_status cd_membrane_step(cd_membrane* membrane, double dt, size_t count);

/* The longest dt at which CD_METHOD_SYMPLECTIC_EULER is sure to stay bounded, whatever method is set: the largest dt
 * with 4 M - 2 dt C - dt^2 K positive definite, by a bound on K that is exact in the limit of many nodes for uniform
 * sheets, and a safe lower bound otherwise. INFINITY if nothing can swing. Errors: CD_ERROR_UNSUPPORTED of cloth. */
CD_API cd_status cd_membrane_stable_dt(const cd_membrane* membrane, double* out_dt);

/* Simulated time [s] and steps made since create or reset, those before a load or a copied state included. */
CD_API cd_status cd_membrane_get_time(const cd_membrane* membrane, double* out_time);
CD_API cd_status cd_membrane_get_steps(const cd_membrane* membrane, uint64_t* out_steps);

/* How many factorizations the membrane has made: one at the first implicit step and one at the first after each change
 * of dt, lambda, method, solver or a parameter. Not part of the saved state. */
CD_API cd_status cd_membrane_get_factorizations(const cd_membrane* membrane, uint64_t* out_count);

/* ---- measuring --------------------------------------------------------------------------------------------------- */

/* Energies [J]; each output may be null. Kinetic: of the free nodes. Elastic: stretch, bend and attachments. Gravity:
 * -sum m g x of the free nodes. What of their sum lambda = 1/2 keeps is told above. */
CD_API cd_status cd_membrane_get_energy(const cd_membrane* membrane, double* out_kinetic, double* out_elastic,
                                        double* out_gravity);
/* Momentum of the free nodes [kg m/s], one number per component.
 * Errors: CD_ERROR_RANGE if count is not the number of components. */
CD_API cd_status cd_membrane_get_momentum(const cd_membrane* membrane, double* out_momentum, size_t count);

/* The force [N], one number per component, with which springs, shear and bend pull at a node where it is now: of a held
 * node, what the sheet does to whatever holds it, but for weight, forces, attachment, pressure and wind of that node
 * itself. Errors: CD_ERROR_RANGE for count, or if there is no such node. */
CD_API cd_status cd_membrane_get_reaction(const cd_membrane* membrane, size_t u, size_t v, double* out_force,
                                          size_t count);

/* Volume between the sheet and the origin [m^3]: a third of the integral of x over the surface's normal, each cell the
 * mean of its two triangulations, cells with an absent node or torn open left out. Of a drum-head whose rim lies in a
 * plane through the origin it is the volume under it; of a closed surface, what it encloses. 3 components only.
 * Errors: CD_ERROR_UNSUPPORTED. */
CD_API cd_status cd_membrane_get_volume(const cd_membrane* membrane, double* out_volume);

/* Positions at n places on the sheet, bilinear between nodes: at[j] = {u, v}, u in [0, nu] (ring: to nu + 1), v
 * likewise; out_positions[j][component], out_count = n * components. Errors: CD_ERROR_RANGE, CD_ERROR_ENUM,
 * CD_ERROR_VALUE. */
CD_API cd_status cd_membrane_sample(const cd_membrane* membrane, const double* at, size_t n, cd_outside outside,
                                    double* out_positions, size_t out_count);
/* Bytes the membrane holds from its allocator. */
CD_API cd_status cd_membrane_get_memory(const cd_membrane* membrane, size_t* out_bytes);
/* A 64-bit hash of everything cd_membrane_save would write. Equal on every machine, compiler and vector width. */
CD_API cd_status cd_membrane_hash(const cd_membrane* membrane, uint64_t* out_hash);

/* ---- drawing ----------------------------------------------------------------------------------------------------- */

/* Writes a vertex for every node, in node order, into the caller's buffer: vertex i at byte i * stride, its position
 * as 3 floats at position_offset and its unit normal, smooth across the sheet, as 3 floats at normal_offset. A normal
 * points along x_u x x_v and is zero where the sheet has no area or is not finite. Components that are not there are
 * written as 0, and a fourth is not drawn; a membrane of 1 component is drawn as the height z over the unit square,
 * x = u / nu, y = v / nv (a direction without a spring: 0; a ring: u / (nu + 1), and for the normals the sheet goes on
 * beyond its ends). normal_offset SIZE_MAX: no normals. Bytes between are left alone; any offset and stride will do,
 * aligned or not, that keeps the vertices apart. Absent nodes get their vertex too, with a zero normal.
 * Errors: CD_ERROR_RANGE if size < nodes * stride, an offset and its 12 bytes reach past stride, or both overlap. */
CD_API cd_status cd_membrane_write_vertices(const cd_membrane* membrane, void* buffer, size_t size, size_t stride,
                                            size_t position_offset, size_t normal_offset);
/* How many indices cd_membrane_write_indices writes now: 6 per cell of four nodes that are there, of cloth 0 if it is
 * torn open, 3 per cell of which three are there. Cells that close a ring are among them, but not of 1 component: they
 * would reach back across the unit square. */
CD_API cd_status cd_membrane_get_index_count(const cd_membrane* membrane, size_t* out_count);

/* Writes the triangles as vertex numbers of index_size 2 or 4 bytes (unsigned, the machine's byte order),
 * counter-clockwise seen from where the normal points; a cell is cut from its node (u, v) to (u + 1, v + 1). `size` is
 * that of the buffer in bytes. The numbers change with CD_MASK, cd_membrane_set_ring and what is cut of cloth only.
 * 65535 with 2 bytes and 2^32 - 1 with 4, which graphics cards may take for a restart, are never written. Errors:
 * CD_ERROR_VALUE for another index_size; CD_ERROR_RANGE if size is too small; CD_ERROR_UNSUPPORTED for more nodes. */
CD_API cd_status cd_membrane_write_indices(const cd_membrane* membrane, void* buffer, size_t size, size_t index_size);

/* ---- keeping ----------------------------------------------------------------------------------------------------- */

/* The whole state as bytes, all the future depends on but the callbacks, as cd_chain_save says. load needs a membrane of
 * the same shape and precision; it switches fields on and off as they were.
 * Errors: save: CD_ERROR_RANGE. load: CD_ERROR_FORMAT, CD_ERROR_MISMATCH, CD_ERROR_MEMORY. */
CD_API cd_status cd_membrane_save_size(const cd_membrane* membrane, size_t* out_size);
CD_API cd_status cd_membrane_save(const cd_membrane* membrane, void* buffer, size_t size, size_t* out_written);
CD_API cd_status cd_membrane_load(cd_membrane* membrane, const void* bytes, size_t size);

/* Makes `membrane` what `source` is, as save and load would, without the bytes: the two must agree in shape and
 * precision. Allocates only if they differ in the fields switched on. Errors: CD_ERROR_MISMATCH, CD_ERROR_MEMORY. */
CD_API cd_status cd_membrane_copy_state(cd_membrane* membrane, const cd_membrane* source);

/* Positions, velocities, time and steps back to 0. Parameters, fields and pins stay; targets too. */
CD_API cd_status cd_membrane_reset(cd_membrane* membrane);

#ifdef __cplusplus
}
#endif

#endif
