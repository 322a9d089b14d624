/* contdyn: water: a height field of columns over a bed: pool, river, tide, flood.
 *
 * A water has nx x ny cells of dx x dy metres; ny = 1 is a slice. A cell holds a column of water of depth d >= 0 over
 * its bed b; its surface is h = b + d. Velocities live on the faces between cells: x-face (i, j) lies between the cells
 * (i - 1, j) and (i, j), so that there are nx + 1 of them in a row; y-face (i, j) between (i, j - 1) and (i, j). Cell
 * (i, j) has its centre at ((i + 1/2) dx, (j + 1/2) dy).
 *
 * Motion    d_t + (d u)_x + (d v)_y = source
 *           u_t [+ u u_x + v u_y] = -g h_x - p_x / density + force - friction u,     and v likewise
 *           friction = drag + g manning^2 |u| / d^(4/3)         (Kass 1997, eq. 32-33; the bracket: shallow water)
 *
 * CD_MOMENTUM_LINEAR    without the bracket: waves, splashes, tides, floods that creep.
 * CD_MOMENTUM_ADVECTED  with it: moving shores, dam breaks, bores, whirls. Momentum goes with the water that leaves a
 *                       cell, upwind, of second order where depths are even.
 *
 * What to set: the momentum by this list; lambda as cd_water_set_momentum sets it; one step a frame, which is never too
 * long to be stable, or more where waves must run at their speed (cd_water_get_courant at most 1). lambda = 1/2 is of
 * second order in time and keeps the energy of small waves; above 1/2 short waves die out, and linear water, whose shores
 * are steep, needs a little more. Right for waves much longer than the water is deep and for surfaces that do not turn
 * over: there is no dispersion, and there are no ship wakes.
 *
 * A step sweeps along all rows, then along all columns, and the next step the other way round. Along such a line the
 * fluxes and the changes of the surface are solved for together, by the theta scheme, theta = lambda, in time in
 * proportion to its cells. The depth at a face is the mean of its two cells'; where these differ a lot, it is nearer to
 * that of the cell which the water leaves. No cell gives more than it has and gets: cd_water_get_limited tells how much
 * that holds back. So no depth is negative, a lake lies still on any bed, and cd_water_get_account tells all changes of
 * volume. Explicit methods differ in that no surface is solved for: half of the slope pushes, the water moves, then the
 * other half pushes (velocity Verlet).
 *
 * What goes wrong, and by how much. "From n cells on": in steps, or parts of fast water's, in which waves cross as many.
 *   Long steps: from 1 cell on waves run too slowly, short ones most, and slantwise more than along the axes. Make
 *      them shorter: to solve for the whole plane, a system that streams make neither symmetric nor definite, cost tens
 *      of times as much, and gained and lost water.
 *   Fast water: a line whose water would run more than half a cell makes its step in 2, 4, ... 64 parts, at so many
 *      times the cost, none of which begins with faster water. Water that runs more than 32 cells is carried less
 *      exactly, and ripples on it may grow; on slower water only those of linear momentum, lambda 1/2, uneven beds do.
 *   Bores, linear: momentum is not carried on, so that a shore moves with the slope of the surface there, and a bore a
 *      tenth, half, twice as high as the depth before it is 2, 9, 22% too slow, against a stream as much too fast.
 *   Bores, advected: within 1.2% of their speed, also against streams, until water runs over 32 cells; from 2 cells
 *      on those a tenth of the depth high are spread over 2 to 6 times as many. Waves behind a bore: with lambda = 1/2
 *      up to its own height (linear: 1.6), with 0.6 up to 0.3 (1.3), all along its way where the water behind it rests.
 *   Energy, linear: where water deepens it gains h_t u^2 / 2, at random shores some hundredths in all (and see hulls).
 *      From 2 cells on waves in the plane, with lambda = 1/2, grow in thousands of steps to a ninth of the depth.
 *   Energy, advected: from 1 cell on it does not rise by itself. Below 1 cell up to 0.005 of it is won among cliffs, far
 *      below also at shores, and 0.01 in the first step after velocities are written there.
 *   Energy, both: from 1 cell on no face gains more than its water loses by falling: linear over uneven depths,
 *      advected where a depth changes by half; from 1e12 on rounding may add any amount. Air that presses water dry
 *      adds 1.4 times what it has to give where momentum is linear, half of it where advected, any amount if explicit.
 *   Dry land: what pushes water away from it gives the face at the water's edge a velocity that no water follows.
 *
 * A new water is dry, over a bed at 0, at rest, walled in, gravity 9.81, density 1000, no drag, CD_MOMENTUM_LINEAR,
 * CD_METHOD_IMPLICIT with lambda 0.55.
 * All computing is in double precision; CD_FLOAT32 is what depth, bed, velocities and the fields are stored in. Steps
 * store 0 for depths below 2^-80 m and velocities below 2^-80 (float32), 2^-500 m/s. Parameters may be as large as 1e60.
 *
 * Every function returns CD_ERROR_NULL for a null pointer and CD_ERROR_HANDLE for a handle of another kind; the
 * comments name the other errors. Functions that chain and membrane have too mean the same here. */
#ifndef CONTDYN_WATER_H
#define CONTDYN_WATER_H

#include "base.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct cd_water cd_water;

/* The four sides. */
typedef int32_t cd_side;
enum {
    CD_SIDE_X_FIRST = 0, /* x = 0 */
    CD_SIDE_X_LAST = 1,  /* x = nx dx */
    CD_SIDE_Y_FIRST = 2, /* y = 0 */
    CD_SIDE_Y_LAST = 3   /* y = ny dy */
};

/* What is at a side. */
typedef int32_t cd_border;
enum {
    CD_BORDER_WALL = 0,
    CD_BORDER_OPEN = 1,     /* water of a given level outside, into which waves run without an echo */
    CD_BORDER_INFLOW = 2,   /* a given discharge comes in; if negative, leaves as far as there is water */
    CD_BORDER_PERIODIC = 3, /* goes on at the opposite side */
    CD_BORDER_LEVEL = 4     /* holds a given level for what flows out slower than its waves: a lake, a weir */
};

/* Whether water carries its momentum along. */
typedef int32_t cd_momentum;
enum { CD_MOMENTUM_LINEAR = 0, CD_MOMENTUM_ADVECTED = 1 };

/* What a write to CD_BED leaves as it is. */
typedef int32_t cd_bed_rule;
enum {
    CD_BED_LIFTS_WATER = 0,  /* the depth: water rides on the bed, volume is kept */
    CD_BED_KEEPS_SURFACE = 1 /* the surface of wet cells: the account tells the volume that a write brings or takes */
};

/* ---- life ------------------------------------------------------------------------------------------------------ */

/* Makes a water. nx, ny >= 1; dx, dy [m] in [1e-30, 1e30]. allocator may be null (malloc). The caller owns *out_water
 * and releases it with cd_water_destroy; on failure *out_water is left alone. Errors: CD_ERROR_VALUE, CD_ERROR_ENUM,
 * CD_ERROR_SIZE, CD_ERROR_MEMORY; CD_ERROR_UNSUPPORTED for a precision that this build leaves out. */
CD_API cd_status cd_water_create(size_t nx, size_t ny, double dx, double dy, cd_precision precision,
                                 const cd_allocator* allocator, cd_water** out_water);

/* Releases a water and all its memory. Null does nothing; a handle of another kind is left alone. */
CD_API void cd_water_destroy(cd_water* water);

/* What cd_water_create was given, or what has been loaded since. Each output may be null. */
CD_API cd_status cd_water_get_shape(const cd_water* water, size_t* out_nx, size_t* out_ny, double* out_dx,
                                    double* out_dy, cd_precision* out_precision);

/* ---- method ------------------------------------------------------------------------------------------------------ */

/* How steps are made: CD_METHOD_IMPLICIT; CD_METHOD_SYMPLECTIC_EULER, here in its symmetric form, second order in time
 * and bounded up to cd_water_stable_dt; CD_METHOD_FORWARD_EULER, first order, bounded at no dt.
 * Errors: CD_ERROR_ENUM; CD_ERROR_UNSUPPORTED for CD_METHOD_STIFF_SECOND; CD_ERROR_MEMORY. */
CD_API cd_status cd_water_set_method(cd_water* water, cd_method method);
CD_API cd_status cd_water_get_method(const cd_water* water, cd_method* out_method);

/* lambda of CD_METHOD_IMPLICIT, in [0, 1]; below 1/2 it grows without bound at most dt. Errors: CD_ERROR_VALUE. */
CD_API cd_status cd_water_set_lambda(cd_water* water, double lambda);
CD_API cd_status cd_water_get_lambda(const cd_water* water, double* out_lambda);

/* Linear or advected momentum; see above. Sets lambda too, to what suits the mode: 0.55 for linear, 1/2 for advected.
 * Advected momentum costs memory. Errors: CD_ERROR_ENUM; CD_ERROR_MEMORY. */
CD_API cd_status cd_water_set_momentum(cd_water* water, cd_momentum momentum);
CD_API cd_status cd_water_get_momentum(const cd_water* water, cd_momentum* out_momentum);

/* Which way the next step sweeps first: along x (0, the default of a new water) or along y (1). Every step turns it
 * round. A scene and its transpose, begun opposite ways, stay each other's transpose to the bit.
 * Errors: CD_ERROR_VALUE for anything but 0 and 1. */
CD_API cd_status cd_water_set_first(cd_water* water, int32_t along_y);
CD_API cd_status cd_water_get_first(const cd_water* water, int32_t* out_along_y);

/* Spreads a step over the caller's threads. Null turns it off. It costs memory, for work that threads do not share.
 * Errors: CD_ERROR_NULL for a table without run; CD_ERROR_MEMORY. */
CD_API cd_status cd_water_set_parallel(cd_water* water, const cd_parallel* parallel);

/* The instructions that steps are made of, from here on: for tests and measurements, as all give the same bits and a
 * new water has the fastest that its processor runs. Not part of the saved state.
 * Errors: CD_ERROR_ENUM; CD_ERROR_UNSUPPORTED for kernels that are not among cd_runnable_kernels. */
CD_API cd_status cd_water_set_kernels(cd_water* water, cd_kernels kernels);
CD_API cd_status cd_water_get_kernels(const cd_water* water, cd_kernels* out_kernels);

/* ---- parameters -------------------------------------------------------------------------------------------------- */
/* Errors of all setters: CD_ERROR_VALUE for a number that is NaN, infinite or out of range. */

/* Gravity [m/s^2], 0 or in [1e-60, 1e6]; default 9.81. */
CD_API cd_status cd_water_set_gravity(cd_water* water, double gravity);
CD_API cd_status cd_water_get_gravity(const cd_water* water, double* out_gravity);

/* Density [kg/m^3], in [1e-6, 1e6]; default 1000. Only pressure, impulses and energies know it. */
CD_API cd_status cd_water_set_density(cd_water* water, double density);
CD_API cd_status cd_water_get_density(const cd_water* water, double* out_density);

/* Drag [1/s], >= 0: velocities die out by exp(-drag t). Default 0. */
CD_API cd_status cd_water_set_drag(cd_water* water, double drag);
CD_API cd_status cd_water_get_drag(const cd_water* water, double* out_drag);

/* Manning's roughness of the bed [s/m^(1/3)], in [0, 1e3]: 0.01 for glass, 0.03 for a river, 0.1 for a flooded wood.
 * Default 0. Water that runs down a slope S, any way, settles at d^(2/3) sqrt(S) / manning. */
CD_API cd_status cd_water_set_manning(cd_water* water, double manning);
CD_API cd_status cd_water_get_manning(const cd_water* water, double* out_manning);

/* What is at a side. `value` now, and how fast it changes, `rate` per second, from now on, both at most 1e60 in size,
 * in CD_FLOAT32 1e30:
 *   CD_BORDER_OPEN     level of the water outside [m], which is at rest: for a tide set level and rate anew as it goes.
 *                      Low waves leave without an echo; some hundredths of high ones come back. With d the depth in the
 *                      cell at the side, D the level's depth over the same bed, water leaves by u = 2 (sqrt(g d) -
 *                      sqrt(g D)), linear by u = sqrt(g d) (1 - D / d), and the discharge is u d. Where u is faster
 *                      than waves, as over a side that lies higher than the level, water falls off: a stream slower than
 *                      its waves leaves at critical depth, u = sqrt(g d), a faster one as it comes.
 *   CD_BORDER_LEVEL    level [m] that is held at the side itself: with D its depth over the bed of the cell there and q
 *                      the discharge one face inside, what leaves tends, as waves cross half a cell, to q + 2 D (sqrt(g
 *                      d) - sqrt(g D)), advected with q D / d for q where d < D. Advected water that comes in at U
 *                      stands U^2 / 2 g lower, at most D / 3. Waves are thrown back; with lambda = 1/2 some may grow,
 *                      slowly. What outruns its waves falls off as above.
 *   CD_BORDER_INFLOW   discharge per metre of the side [m^2/s] into the water, velocity times depth; into a cell below
 *                      critical depth it comes in at that. If negative it leaves, as far as there is water.
 *   CD_BORDER_WALL, CD_BORDER_PERIODIC   value and rate mean nothing
 * Both sides of a direction are periodic or neither is: setting one sets the other, and leaving it leaves both, the
 * opposite one as a wall. Errors: CD_ERROR_ENUM; CD_ERROR_VALUE. */
CD_API cd_status cd_water_set_side(cd_water* water, cd_side side, cd_border kind, double value, double rate);
/* Value and rate as of now; 0 where they mean nothing. Each output may be null. Errors: CD_ERROR_ENUM. */
CD_API cd_status cd_water_get_side(const cd_water* water, cd_side side, cd_border* out_kind, double* out_value,
                                   double* out_rate);

/* Depth of an inflow [m], 0 or in [1e-6, 1e30]; default 0: that of the cell at the side. Else advected water comes in at
 * the speed of its discharge in that depth, as under a gate so far open: faster than its waves, it has that depth in the
 * first cell; if slower, or if it drowns the gate, that of what comes after. Other sides, outflow and linear momentum do
 * not use it; cd_water_set_side keeps it. Errors: CD_ERROR_ENUM; CD_ERROR_VALUE. */
CD_API cd_status cd_water_set_inflow_depth(cd_water* water, cd_side side, double depth);
CD_API cd_status cd_water_get_inflow_depth(const cd_water* water, cd_side side, double* out_depth);

/* What a write to CD_BED leaves as it is; default CD_BED_LIFTS_WATER. Errors: CD_ERROR_ENUM. */
CD_API cd_status cd_water_set_bed_rule(cd_water* water, cd_bed_rule rule);
CD_API cd_status cd_water_get_bed_rule(const cd_water* water, cd_bed_rule* out_rule);

/* ---- fields -------------------------------------------------------------------------------------------------------
 *  field            per           unit    values
 *  CD_DEPTH         cell          m       finite, >= 0; of an absent cell only 0
 *  CD_BED           cell          m       finite
 *  CD_SURFACE       cell          m       finite: bed + depth. Written: depth becomes surface - bed, or 0 where that is
 *                                         below the bed; of an absent cell nothing changes
 *  CD_VELOCITY_X    x-face        m/s     finite; of a face that no water can cross only 0. Along periodic x the faces
 *                                         i = 0 and nx are one
 *  CD_VELOCITY_Y    y-face        m/s     likewise
 *  CD_SOURCE        cell          m/s     finite: depth per second that comes in, or leaves as far as there is water;
 *                                         acts until it is overwritten
 *  CD_PRESSURE      cell          Pa      finite: on the surface
 *  CD_FORCE_X       x-face        m/s^2   finite: an acceleration; a wind's stress over density and depth
 *  CD_FORCE_Y       y-face        m/s^2   likewise
 *  CD_MASK          cell          -       1: there; 0: absent, walled off. Its water goes, as a write of depth
 *  CD_WALL_X        x-face        -       1: a wall stands there; 0: none. i from 1 to nx - 1 only count, and along
 *                                         periodic x 0, which is nx
 *  CD_WALL_Y        y-face        -       likewise
 * Depth, bed and velocities are always there, and the surface, which is made of them. The others cost memory and time
 * only once they are switched on. Writing CD_DEPTH, CD_SURFACE or CD_MASK starts the account anew. */

/* Switches a field on: no sources, pressure, force or walls yet, all cells there. On already: nothing happens.
 * Errors: CD_ERROR_ENUM; CD_ERROR_UNSUPPORTED for a field of other objects; CD_ERROR_MEMORY. */
CD_API cd_status cd_water_enable_field(cd_water* water, cd_field field);

/* Switches a field off and releases its memory. Errors: CD_ERROR_ENUM; CD_ERROR_UNSUPPORTED if it is always there. */
CD_API cd_status cd_water_disable_field(cd_water* water, cd_field field);

/* Writes or reads values[j][i], dense, of the rectangle of cells or faces [first_x, first_x + n_x) x [first_y,
 * first_y + n_y); `count` is n_x * n_y. There are nx + 1 x-faces in a row and ny + 1 rows of y-faces. Numbers are
 * rounded once, to the precision of the side that is narrower. Never allocates. Errors: CD_ERROR_ENUM,
 * CD_ERROR_UNSUPPORTED, CD_ERROR_DISABLED, CD_ERROR_RANGE; write: CD_ERROR_VALUE, with the first bad index. */
CD_API cd_status cd_water_write_f32(cd_water* water, cd_field field, size_t first_x, size_t first_y, size_t n_x,
                                    size_t n_y, const float* values, size_t count);
CD_API cd_status cd_water_write_f64(cd_water* water, cd_field field, size_t first_x, size_t first_y, size_t n_x,
                                    size_t n_y, const double* values, size_t count);
CD_API cd_status cd_water_read_f32(const cd_water* water, cd_field field, size_t first_x, size_t first_y, size_t n_x,
                                   size_t n_y, float* out_values, size_t count);
CD_API cd_status cd_water_read_f64(const cd_water* water, cd_field field, size_t first_x, size_t first_y, size_t n_x,
                                   size_t n_y, double* out_values, size_t count);

/* Where a field lies in the water's own memory, in its precision, to read without a copy: the value of (i, j) is at
 * byte *out_data + i * x_stride + j * y_stride. All but CD_SURFACE, CD_MASK and the walls. The pointer is good until
 * the field is switched off or the water released; the numbers change with every write and step. Do not write through
 * it. Errors: CD_ERROR_ENUM, CD_ERROR_DISABLED, CD_ERROR_UNSUPPORTED. */
CD_API cd_status cd_water_view(const cd_water* water, cd_field field, const void** out_data, size_t* out_x_stride,
                               size_t* out_y_stride);

/* ---- acting on it ------------------------------------------------------------------------------------------------ */
/* Discs have their centre at (x, y) [m] in the scene, x in [0, nx dx], y in [0, ny dy], and a radius [m] >= 0; where a
 * disc has no cell centre in it, it is the cell at (x, y), the nearest one that is there. Shares fall off as
 * (1 - (distance / radius)^2)^2 from the centre, and are not spread round a periodic side. */

/* Adds volume [m^3] over a disc, or takes it if negative, as far as there is water in each cell's share. out_added,
 * which may be null, tells what it came to. The account counts it. Errors: CD_ERROR_VALUE, CD_ERROR_DIVERGED. */
CD_API cd_status cd_water_add_volume(cd_water* water, double x, double y, double radius, double volume,
                                     double* out_added);

/* Adds volume [m^3] evenly over the cells there of a rectangle, or takes it; out_added as above.
 * Errors: CD_ERROR_RANGE; CD_ERROR_VALUE, CD_ERROR_DIVERGED. */
CD_API cd_status cd_water_add_volume_rectangle(cd_water* water, size_t first_x, size_t first_y, size_t n_x, size_t n_y,
                                               double volume, double* out_added);

/* Adds a source of rate [m^3/s] over a disc to CD_SOURCE, or a drain if negative, and switches that field on.
 * Errors: CD_ERROR_VALUE; CD_ERROR_MEMORY. */
CD_API cd_status cd_water_add_source(cd_water* water, double x, double y, double radius, double rate);

/* The same evenly over the cells there of a rectangle. Errors: CD_ERROR_RANGE; CD_ERROR_VALUE; CD_ERROR_MEMORY. */
CD_API cd_status cd_water_add_source_rectangle(cd_water* water, size_t first_x, size_t first_y, size_t n_x, size_t n_y,
                                               double rate);

/* A splash: water of the disc, down to `height` [m] >= 0 at its centre and as far as there is water, is heaped up on the
 * wet cells around it, out to twice the radius, if there are any; volume is kept. Errors: CD_ERROR_VALUE, _DIVERGED. */
CD_API cd_status cd_water_splash(cd_water* water, double x, double y, double radius, double height);

/* Adds an impulse (x, y) [N s] over a disc: a face's velocity changes by its share of it / the mass of water at it,
 * shares in proportion to that mass too; on dry faces nothing happens. Errors: CD_ERROR_VALUE, CD_ERROR_DIVERGED. */
CD_API cd_status cd_water_impulse(cd_water* water, double x, double y, double radius, double impulse_x,
                                  double impulse_y);

/* ---- what floats on it ------------------------------------------------------------------------------------------ */
/* Hulls float on the water, numbered from 0. Each is a rigid body whose floor is a rectangle of n_along x n_across
 * plates, at heights above its keel, with sides as high as it takes. What presses the water down makes waves; water
 * that rises, slopes or runs lifts, pushes and drags the hull; where the bed is higher it lies on that. Water only meets
 * a hull's floor, and hulls do not meet each other. At sides that are not periodic a hull stops, without turning, where
 * a cell's width of water is left before it, if there is room for that, and before walls and cells that are not there.
 *
 * A pose is {x, y, z, ahead_x, ahead_y, pitch, roll}: the middle, the height of the keel under it [m], the direction of
 * the bow, and small slopes: pitch is by how much the bow rises per metre ahead, roll the port side, to the left, per
 * metre to port. Velocities are {along x, along y, upward [m/s], yaw, pitch, roll [1/s]}, yaw counter-clockwise seen
 * from above. Mass is spread evenly over length and width; the righting moment is that of the waterline.
 *
 * Between body and water lies an elastic skin, three times as stiff as the water's surface: the keel of a hull of many
 * cells lies by a third of the draft below the floor that cd_water_get_hull_floor gives, to be drawn. At rest the floor
 * displaces the mass: draft = mass / (density area), if flat. Wedges displace 1.01 times as much, 3 cells wide 1.2 times.
 *
 * Energy: steps stay bounded at any dt, for hulls of any mass, and hulls and water together gain no energy but what the
 *    water itself does and up to a twentieth of what hulls move and press with, which they owe. The water's is much
 *    where a hull presses it dry, if linear, where waves cross 2.8 cells 13 times what was there; advected none.
 * Long steps, in which waves cross many cells or a hull its own length, slow hulls down.
 * Momentum: the water gets all that drag takes from a hull, less in long steps, and half or more of what its waves take.
 * Time: forces cost in proportion to the cells under hulls, and all cells of water with hulls a little more.
 * Errors of all: CD_ERROR_RANGE for an index that no hull has, or a count that is not what the comment says. */

/* How many hulls there are, `count`, 0 to 4096, default 0, and how many plates each has, `n_along` and `n_across`, 1 to
 * 256: new ones are none (mass 0), those that stay keep what they are unless the plates change. Without hulls n_along
 * and n_across mean nothing. Errors: CD_ERROR_VALUE; CD_ERROR_MEMORY. Each output may be null. */
CD_API cd_status cd_water_set_hulls(cd_water* water, size_t count, size_t n_along, size_t n_across);
CD_API cd_status cd_water_get_hulls(const cd_water* water, size_t* out_count, size_t* out_n_along,
                                    size_t* out_n_across);

/* Makes a hull of a mass [kg] in [1e-12, 1e15] and length and width [m], >= 1e-60 and at most 512 cells. heights[j][i]:
 * of the floor's plate i along, j to port, above the keel [m], in [0, 1e60], or -1 where there is none; `count` is
 * n_along n_across; null: flat. Where it is, and how it moves, stays. Errors: CD_ERROR_VALUE, also for no plate. */
CD_API cd_status cd_water_set_hull(cd_water* water, size_t index, double mass, double length, double width,
                                   const double* heights, size_t count);

/* Makes a hull with a flat round floor: those plates of a square whose middles lie in the disc, all stretched so that
 * their area is the disc's. The radius [m] is >= 1e-60, the square at most 512 cells wide. Errors: CD_ERROR_VALUE. */
CD_API cd_status cd_water_set_disc(cd_water* water, size_t index, double mass, double radius);

/* What a hull is: mass (0: none), length, width, the area of its plates [m^2]. Each output may be null; heights:
 * `count` of them, or null and any count. */
CD_API cd_status cd_water_get_hull(const cd_water* water, size_t index, double* out_mass, double* out_length,
                                   double* out_width, double* out_area, double* out_heights, size_t count);
CD_API cd_status cd_water_remove_hull(cd_water* water, size_t index);

/* Launches a hull at (x, y) in the scene, its bow towards (ahead_x, ahead_y) of any length but 0, at rest. It lies as it
 * would in time. The water that it displaces goes, evenly, to all cells whose surface is within its draft of that under
 * it; where there is no such cell, or the bed bears it, it displaces none. What it displaced before is not given back:
 * to move a hull set its pose. Errors: CD_ERROR_VALUE; CD_ERROR_DISABLED if it has no mass, or no cell is under it, or
 * gravity is 0; CD_ERROR_DIVERGED of a water that did. */
CD_API cd_status cd_water_launch_hull(cd_water* water, size_t index, double x, double y, double ahead_x,
                                      double ahead_y);

/* The body's pose, 7 numbers, and its velocity, 6; see above. The middle lies in the scene, all others are at most 1e15
 * in size, and the direction of the bow is given back with length 1. New hulls lie at 0, heading along x. An obstacle
 * that moves through the water, as heavy as the water in its place or heavier, has both set before each step; with its
 * keel a third of the water's depth below the bed it presses all water away. Errors: CD_ERROR_VALUE. */
CD_API cd_status cd_water_set_hull_pose(cd_water* water, size_t index, const double* pose, size_t count);
CD_API cd_status cd_water_get_hull_pose(const cd_water* water, size_t index, double* out_pose, size_t count);
CD_API cd_status cd_water_set_hull_velocity(cd_water* water, size_t index, const double* velocity, size_t count);
CD_API cd_status cd_water_get_hull_velocity(const cd_water* water, size_t index, double* out_velocity, size_t count);

/* The pose in which the floor lies on the water since the last step or launch, to be drawn: 7 numbers. */
CD_API cd_status cd_water_get_hull_floor(const cd_water* water, size_t index, double* out_pose, size_t count);

/* What acts on a hull from outside until it is set anew, an engine: 6 numbers, forces ahead, to port and up [N] and
 * moments of yaw, pitch and roll [N m], at most 1e30 in size. Default 0. Errors: CD_ERROR_VALUE. */
CD_API cd_status cd_water_set_hull_force(cd_water* water, size_t index, const double* force, size_t count);
CD_API cd_status cd_water_get_hull_force(const cd_water* water, size_t index, double* out_force, size_t count);

/* Drag against the water under it, along the hull and across it [N s/m], which slows turning too, and Coulomb friction
 * on the bed; in [0, 1e30], default 0. Errors: CD_ERROR_VALUE. */
CD_API cd_status cd_water_set_hull_drag(cd_water* water, size_t index, double along, double across, double friction);
CD_API cd_status cd_water_get_hull_drag(const cd_water* water, size_t index, double* out_along, double* out_across,
                                        double* out_friction);

/* What a hull felt from water and bed in the last step: 6 numbers, forces x, y, up [N], moments yaw, pitch, roll [N m]. */
CD_API cd_status cd_water_get_hull_load(const cd_water* water, size_t index, double* out_load, size_t count);

/* Energies of all hulls [J]: of their motion; mass g z, and what their skins hold. Each output may be null. */
CD_API cd_status cd_water_get_hull_energy(const cd_water* water, double* out_kinetic, double* out_potential);

/* How high [m] the water would stand at n places, at[k] = {x, y}, with no hull pressing on it: its surface and the head
 * that hulls press with. Errors: CD_ERROR_ENUM; CD_ERROR_VALUE for a place outside; CD_ERROR_RANGE for more than fit
 * in memory. */
CD_API cd_status cd_water_sample_heads(const cd_water* water, const double* at, size_t n, cd_outside outside,
                                       double* out_heads);

/* ---- time ------------------------------------------------------------------------------------------------------- */

/* Makes `count` steps of dt [s] each, 0 or in [1e-30, 1e30]: with 0 no time passes, as with 0 steps.
 * Never allocates. Time is proportional to count * cells, and to the parts that steps are made in (see above).
 * Errors: CD_ERROR_VALUE; CD_ERROR_DIVERGED if a number leaves the finite range: all steps are made, the message gives
 * the first bad one, the water can be read, and steps again after cd_water_reset, a load, or once finite depths and
 * velocities have been written. */
CD_API cd_status cd_water_step(cd_water* water, double dt, size_t count);

/* The longest dt at which CD_METHOD_SYMPLECTIC_EULER stays bounded for small waves on the water as it lies now,
 * whatever method is set: the least of both axes, each exact in the limit of many cells for water of one depth, a safe
 * lower bound otherwise; for a stream over an uneven bed take 0.8 of it. INFINITY if nothing can swing. */
CD_API cd_status cd_water_stable_dt(const cd_water* water, double* out_dt);

/* Simulated time [s] and steps made since create or reset, those before a load or a copied state included. */
CD_API cd_status cd_water_get_time(const cd_water* water, double* out_time);
CD_API cd_status cd_water_get_steps(const cd_water* water, uint64_t* out_steps);

/* How many times lines have been solved along a direction since the water was made: of every sweep the most parts that
 * a line made its step in, each a factorization of its own, since depths change. Not part of the saved state. */
CD_API cd_status cd_water_get_factorizations(const cd_water* water, uint64_t* out_count);

/* What the last call of cd_water_step had to hold back so that no cell gave more than it had and got: in how many
 * cells, counted once per sweep and part, and how much less water [m^3] went through faces. Each output may be null. */
CD_API cd_status cd_water_get_limited(const cd_water* water, uint64_t* out_cells, double* out_volume);

/* Lets water sleep where it hardly moves: steps leave parts of 16 x 16 cells as they are, at no cost, where all waves
 * are lower than `height` [m], in [0, 1e60], and so are all that a step could carry there. Default 0: nothing sleeps.
 * Neglected are, at each face, a rise of the surface below height / 16, a velocity below height sqrt(g / d), and water
 * that stands less than the height over the higher bed. What falls asleep stops, so energy is lost and none gained;
 * volume is kept. Waves lower than the height meet sleeping water as a wall. The energy bound of long steps, which is
 * one of whole lines, is then one of what is awake of a line.
 * Awake stay parts with sources or forces, under hulls, and at open, level and inflow sides; and all of the water
 * while there are higher waves at a periodic side. Which parts sleep follows from the state alone, whatever hook and
 * kernels; where all are awake a step has the bits of one of water that never sleeps.
 * A step's time is in proportion to the cells awake, each up to half as dear again. A splash, a volume, an impulse, a
 * write of cells or faces and what is set of a hull wake what they touch; after any other call that may change the
 * water the next step looks at all of it, in half a step's time. Costs a byte for ten cells. The height is kept with
 * the state. Errors: CD_ERROR_VALUE; CD_ERROR_MEMORY. */
CD_API cd_status cd_water_set_sleep(cd_water* water, double height);
CD_API cd_status cd_water_get_sleep(const cd_water* water, double* out_height);

/* How many cells were awake in the last step; all, before it and where nothing sleeps. Not part of the saved state. */
CD_API cd_status cd_water_get_awake(const cd_water* water, size_t* out_cells);

/* ---- measuring --------------------------------------------------------------------------------------------------- */

/* Volume [m^3]: the sum of all depths times the cells' area. */
CD_API cd_status cd_water_get_volume(const cd_water* water, double* out_volume);

/* The volume account [m^3], kept in double whatever the precision: what was there when it was started (by create,
 * reset, cd_water_restart_account, or a write of CD_DEPTH, CD_SURFACE or CD_MASK), what came in since then (sides,
 * sources, volumes added, beds that keep the surface), what went out, and what the present volume has above initial +
 * in - out, which is rounding. Each output may be null. */
CD_API cd_status cd_water_get_account(const cd_water* water, double* out_initial, double* out_in, double* out_out,
                                      double* out_error);
CD_API cd_status cd_water_restart_account(cd_water* water);

/* Energies [J]; each output may be null. Kinetic: density / 2 times area, mean depth of both cells and velocity^2 of
 * faces, at a shore as steps begin with it. Potential: density g times area, depth and height of the column's middle. */
CD_API cd_status cd_water_get_energy(const cd_water* water, double* out_kinetic, double* out_potential);

/* Area [m^2] of the cells with depth > 0. */
CD_API cd_status cd_water_get_wet_area(const cd_water* water, double* out_area);

/* The largest Courant number of a step of dt [s], in [0, 1e30], over directions and wet faces: (|u| + sqrt(g d)) dt / dx.
 * Errors: CD_ERROR_VALUE. */
CD_API cd_status cd_water_get_courant(const cd_water* water, double dt, double* out_courant);

/* The water at n places, at[k] = {x, y} in metres inside the scene: surface [m] and depth [m], bilinear between cell
 * centres that are there, level beyond the outermost ones; normal of the surface (3 numbers, unit length, z up);
 * velocity [m/s] (2 numbers), bilinear between faces. A dry place has the bed for its surface. Each output may be null.
 * Errors: CD_ERROR_ENUM; CD_ERROR_VALUE for a place outside; CD_ERROR_RANGE for more than fit in memory. */
CD_API cd_status cd_water_sample(const cd_water* water, const double* at, size_t n, cd_outside outside,
                                 double* out_surface, double* out_depth, double* out_normal, double* out_velocity);

/* Bytes the water holds from its allocator. */
CD_API cd_status cd_water_get_memory(const cd_water* water, size_t* out_bytes);

/* A 64-bit hash of everything cd_water_save would write. Equal on every machine, compiler and vector width. */
CD_API cd_status cd_water_hash(const cd_water* water, uint64_t* out_hash);

/* ---- drawing ----------------------------------------------------------------------------------------------------- */

/* Writes a vertex for every cell, cell (i, j) as number j nx + i, into the caller's buffer: vertex k at byte k *
 * stride, its position, the cell's centre on the surface, as 3 floats at position_offset; its unit normal as 3 floats
 * at normal_offset; its depth as 1 float at depth_offset, 0 where it is dry and -1 where the cell is absent, for a
 * shader to fade out shores. normal_offset or depth_offset SIZE_MAX: none. Bytes between are left alone; any offset
 * and stride will do that keeps them apart. Errors: CD_ERROR_RANGE if size is less than cells * stride, or an offset
 * and its bytes reach past stride, or two overlap. */
CD_API cd_status cd_water_write_vertices(const cd_water* water, void* buffer, size_t size, size_t stride,
                                         size_t position_offset, size_t normal_offset, size_t depth_offset);

/* How many indices cd_water_write_indices writes now: 6 per square of four neighbouring cells that are there, 3 per
 * square of which three are. skip_dry 1: squares without a wet cell are left out, so that it changes with the water.
 * Errors: CD_ERROR_VALUE for a skip_dry neither 0 nor 1. */
CD_API cd_status cd_water_get_index_count(const cd_water* water, int32_t skip_dry, size_t* out_count);

/* Writes the triangles as vertex numbers of index_size 2 or 4 bytes (unsigned, the machine's byte order), counter-
 * clockwise seen from above. `size` is that of the buffer in bytes. 65535 with 2 bytes and 2^32 - 1 with 4 are never
 * written. Errors: CD_ERROR_VALUE for another index_size, or skip_dry neither 0 nor 1; CD_ERROR_RANGE if size is too
 * small; CD_ERROR_UNSUPPORTED for more than 65535 or 2^32 - 1 cells. */
CD_API cd_status cd_water_write_indices(const cd_water* water, int32_t skip_dry, void* buffer, size_t size,
                                        size_t index_size);

/* ---- keeping ----------------------------------------------------------------------------------------------------- */

/* The whole state as bytes: shape, parameters, fields, time, account: all the future depends on but the callbacks.
 * Little-endian on every machine, versioned, with a checksum. save needs size >= cd_water_save_size and tells what it
 * wrote. load needs a water of as many cells and the same precision, takes the cells' size over, and switches fields on
 * and off as they were. Bytes that are damaged, cut short, of a later version or another kind are refused.
 * Errors: save: CD_ERROR_RANGE. load: CD_ERROR_FORMAT, CD_ERROR_MISMATCH, CD_ERROR_MEMORY. */
CD_API cd_status cd_water_save_size(const cd_water* water, size_t* out_size);
CD_API cd_status cd_water_save(const cd_water* water, void* buffer, size_t size, size_t* out_written);
CD_API cd_status cd_water_load(cd_water* water, const void* bytes, size_t size);

/* Makes `water` what `source` is, as save and load would, without the bytes: the two must agree in cells and precision.
 * Allocates only if they differ in the fields switched on. Errors: CD_ERROR_MISMATCH, CD_ERROR_MEMORY. */
CD_API cd_status cd_water_copy_state(cd_water* water, const cd_water* source);

/* Depths, velocities, time, steps and account back to 0, hulls to where new ones lie, at rest. Bed, parameters and the
 * other fields stay, and what hulls are. What is at sides begins again with time: a level or discharge that changes is
 * what it was at time 0, or by its rate would have been if it was set later; then set it anew. */
CD_API cd_status cd_water_reset(cd_water* water);

#ifdef __cplusplus
}
#endif

#endif
