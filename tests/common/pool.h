/* Small waters that many tests share, and whole fields in one call; cloth.h does the same for membranes. Everything
 * here must succeed: if it does not, the test fails. */
#ifndef POOL_H
#define POOL_H

#include <contdyn/water.h>

#include <stddef.h>
#include <stdint.h>

/* Metres of a cell of a pool. */
#define POOL_DX 0.5
#define POOL_DY 0.75

/* A water as cd_water_create makes it, from malloc; and from an allocator, which may be null. */
cd_water* pool(size_t nx, size_t ny, cd_precision precision);
cd_water* pool_from(const cd_allocator* allocator, size_t nx, size_t ny, cd_precision precision);

/* The rectangle of a whole field: columns and rows of cells or faces. */
struct pool_extent {
    size_t columns, rows, count;
};
struct pool_extent pool_extent(const cd_water* water, cd_field field);

/* A whole field, in the order of the header. */
void pool_read(const cd_water* water, cd_field field, double* out_values);
void pool_write(cd_water* water, cd_field field, const double* values);

/* One number of a field, and the same one everywhere. */
double pool_get(const cd_water* water, cd_field field, size_t i, size_t j);
void pool_set(cd_water* water, cd_field field, size_t i, size_t j, double value);
void pool_fill(cd_water* water, cd_field field, double value);

/* Whether the field is switched on. */
int pool_has(const cd_water* water, cd_field field);

double pool_volume(const cd_water* water);

/* A different number within `size` of `mean` everywhere; the field is switched on if it can be. Velocities of faces
 * that no water can cross stay 0. */
void pool_vary(cd_water* water, cd_field field, double mean, double size, uint64_t seed);

/* Makes steps that must end well. */
void pool_step(cd_water* water, double dt, size_t count);

/* Scenes for a water that is new, of any shape. */
typedef void pool_build(cd_water* water);

pool_build pool_beach;           /* linear, walled in, partly dry */
pool_build pool_dam;             /* advected, breaks over a dry bed */
pool_build pool_flood;           /* the same over a rough bed, in long steps */
pool_build pool_weir;            /* advected, runs down to levels that two sides hold */
pool_build pool_explicit;        /* explicit, with wind */
pool_build pool_forward;         /* forward Euler, damped */
pool_build pool_tide;            /* linear, open along x, the level outside moves */
pool_build pool_river;           /* advected, rough, water comes in at one end and falls off the other */
pool_build pool_torus;           /* advected, periodic both ways, drag, a current */
pool_build pool_masked;          /* linear, periodic along y, islands and walls */
pool_build pool_fed;             /* advected, sources and drains, pressure, wind */
pool_build pool_everything;      /* every field and parameter at once */
pool_build pool_everything_long; /* the same in long steps, periodic along x */
pool_build pool_hulls;           /* linear, hulls on a beach and in a current */
pool_build pool_hulls_long;      /* advected, periodic along x, driven hulls in long steps */

struct pool_scene {
    const char* name;
    pool_build* build;
    double dt;
};
enum { POOLS = 15, POOL_TIDE = 6, POOL_TORUS = 8, POOL_EVERYTHING = 11 };
extern const struct pool_scene pools[POOLS];

/* A pool of a scene, after some steps. */
cd_water* pool_of(size_t scene, size_t nx, size_t ny, cd_precision precision, size_t steps);

#endif
