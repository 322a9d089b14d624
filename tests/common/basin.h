/* Waters that many tests share: ways to step them, whole fields in one call, lines of cells along x or y. Everything
 * here must succeed: if it does not, the test fails. */
#ifndef BASIN_H
#define BASIN_H

#include <contdyn/water.h>

#include <stddef.h>
#include <stdint.h>

/* A way of stepping. */
struct way {
    const char* name;
    cd_method method;
    cd_momentum momentum;
    double lambda;
};
enum {
    LINEAR, /* as a new water is */
    LINEAR_HALF,
    LINEAR_ONE,
    ADVECTED,
    EXPLICIT, /* CD_METHOD_SYMPLECTIC_EULER */
    EXPLICIT_ADVECTED,
    WAYS
};
extern const struct way ways[WAYS];

cd_water* basin(size_t nx, size_t ny, double dx, double dy, cd_precision precision);
void basin_set_way(cd_water* water, const struct way* way);
int basin_is_explicit(const struct way* way);

/* A whole field; the buffer holds basin_count numbers, row by row. */
size_t basin_count(const cd_water* water, cd_field field);
void basin_read(const cd_water* water, cd_field field, double* out_values);
void basin_write(cd_water* water, cd_field field, const double* values);
double basin_get(const cd_water* water, cd_field field, size_t i, size_t j);
void basin_set(cd_water* water, cd_field field, size_t i, size_t j, double value);

/* A field from its value at every cell's or face's centre. */
typedef double basin_shape(double x, double y, const void* user);
void basin_fill(cd_water* water, cd_field field, basin_shape* shape, const void* user);

void basin_step(cd_water* water, double dt, size_t count);

double basin_volume(const cd_water* water);
double basin_volume_off(const cd_water* water); /* what the account cannot explain, over all that was ever there */
double basin_energy(const cd_water* water);     /* kinetic and potential */
double basin_kinetic(const cd_water* water);
double basin_largest(const cd_water* water, cd_field field); /* size */
double basin_least(const cd_water* water, cd_field field);
double basin_stable_dt(const cd_water* water);

/* Water of which every line along an axis is the same: 0: `n` cells along x and `across` rows; 1: transposed. Cells are
 * square unless the one size differs. A face field is named by what it is along the line: VELOCITY along it. */
cd_water* line_basin(int along_y, size_t n, size_t across, double size, cd_precision precision);
cd_field line_field(int along_y, cd_field of_x); /* CD_VELOCITY_X, CD_FORCE_X, CD_WALL_X, or a cell's field */
cd_side line_side(int along_y, int last);
void line_write(cd_water* water, int along_y, cd_field of_x, const double* values);
/* The line in the middle; the others must be the same, to rounding of `noise`. */
void line_read(const cd_water* water, int along_y, cd_field of_x, double noise, double* out_values);

/* A bed of bumps, islands, beaches and basins: heights [0, height], smooth over `length` metres (0: cell by cell). */
void basin_random_bed(cd_water* water, double height, double length, uint64_t seed);

#endif
