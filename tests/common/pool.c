#include "pool.h"

#include <math.h>
#include <stdlib.h>

#include "check.h"
#include "scene.h"

cd_water* pool_from(const cd_allocator* allocator, size_t nx, size_t ny, cd_precision precision) {
    cd_water* water = NULL;
    ok(cd_water_create(nx, ny, POOL_DX, POOL_DY, precision, allocator, &water));
    assert_non_null(water);
    return water;
}

cd_water* pool(size_t nx, size_t ny, cd_precision precision) { return pool_from(NULL, nx, ny, precision); }

struct pool_extent pool_extent(const cd_water* water, cd_field field) {
    struct pool_extent extent = {0};
    ok(cd_water_get_shape(water, &extent.columns, &extent.rows, NULL, NULL, NULL));
    if (field == CD_VELOCITY_X || field == CD_FORCE_X || field == CD_WALL_X) ++extent.columns;
    if (field == CD_VELOCITY_Y || field == CD_FORCE_Y || field == CD_WALL_Y) ++extent.rows;
    extent.count = extent.columns * extent.rows;
    return extent;
}

void pool_read(const cd_water* water, cd_field field, double* out_values) {
    const struct pool_extent all = pool_extent(water, field);
    ok(cd_water_read_f64(water, field, 0, 0, all.columns, all.rows, out_values, all.count));
}

void pool_write(cd_water* water, cd_field field, const double* values) {
    const struct pool_extent all = pool_extent(water, field);
    ok(cd_water_write_f64(water, field, 0, 0, all.columns, all.rows, values, all.count));
}

double pool_get(const cd_water* water, cd_field field, size_t i, size_t j) {
    double value = -77;
    ok(cd_water_read_f64(water, field, i, j, 1, 1, &value, 1));
    return value;
}

void pool_set(cd_water* water, cd_field field, size_t i, size_t j, double value) {
    ok(cd_water_write_f64(water, field, i, j, 1, 1, &value, 1));
}

static double* new_numbers(size_t count) {
    double* numbers = calloc(count, sizeof *numbers);
    assert_non_null(numbers);
    return numbers;
}

void pool_fill(cd_water* water, cd_field field, double value) {
    const size_t count = pool_extent(water, field).count;
    double* values = new_numbers(count);
    for (size_t k = 0; k < count; ++k) values[k] = value;
    pool_write(water, field, values);
    free(values);
}

int pool_has(const cd_water* water, cd_field field) {
    double value;
    return cd_water_read_f64(water, field, 0, 0, 1, 1, &value, 1) == CD_OK;
}

double pool_volume(const cd_water* water) {
    double volume = -77;
    ok(cd_water_get_volume(water, &volume));
    return volume;
}

void pool_vary(cd_water* water, cd_field field, double mean, double size, uint64_t seed) {
    const struct pool_extent all = pool_extent(water, field);
    ok(cd_water_enable_field(water, field));
    for (size_t k = 0; k < all.count; ++k) {
        const double value = mean + size * scene_noise(&seed);
        const cd_status status = cd_water_write_f64(water, field, k % all.columns, k / all.columns, 1, 1, &value, 1);
        if (field != CD_VELOCITY_X && field != CD_VELOCITY_Y) ok(status); /* those of closed faces are refused */
    }
}

void pool_step(cd_water* water, double dt, size_t count) { ok(cd_water_step(water, dt, count)); }

/* ---- scenes ---- */

/* A bed that climbs along x and y, unevenly, and water up to 0, of which the shore is dry. */
static void beach(cd_water* water, double depth, uint64_t seed) {
    const struct pool_extent all = pool_extent(water, CD_BED);
    double* bed = new_numbers(all.count);
    double* surface = new_numbers(all.count);
    for (size_t k = 0; k < all.count; ++k) {
        const double x = (0.5 + (double)(k % all.columns)) / (double)all.columns;
        const double y = (0.5 + (double)(k / all.columns)) / (double)all.rows;
        bed[k] = depth * (-1 + 1.25 * x + 0.25 * y + 0.0625 * scene_noise(&seed));
        surface[k] = depth * 0.125 * scene_noise(&seed);
    }
    pool_write(water, CD_BED, bed);
    pool_write(water, CD_SURFACE, surface);
    free(bed);
    free(surface);
}

static void dam(cd_water* water, double depth) {
    const struct pool_extent all = pool_extent(water, CD_DEPTH);
    pool_vary(water, CD_BED, 0, 0.03125 * depth, 21);
    for (size_t k = 0; k < all.count; ++k)
        if (k % all.columns + k / all.columns <= (all.columns + all.rows) / 3)
            pool_set(water, CD_DEPTH, k % all.columns, k / all.columns, depth);
}

static void stir(cd_water* water, double speed, uint64_t seed) {
    pool_vary(water, CD_VELOCITY_X, 0, speed, seed);
    pool_vary(water, CD_VELOCITY_Y, 0, speed, seed + 1);
}

static void blow(cd_water* water, double x, double y) {
    pool_vary(water, CD_FORCE_X, x, 0.125, 31);
    pool_vary(water, CD_FORCE_Y, y, 0.125, 32);
}

/* Cells that are not there, and walls, some of them on borders. */
static void build_in(cd_water* water, size_t columns, size_t rows) {
    ok(cd_water_enable_field(water, CD_MASK));
    ok(cd_water_enable_field(water, CD_WALL_X));
    ok(cd_water_enable_field(water, CD_WALL_Y));
    for (size_t j = 0; j < rows; ++j)
        for (size_t i = 0; i < columns; ++i) {
            if ((3 * i + 5 * j) % 13 == 7) pool_set(water, CD_MASK, i, j, 0);
            if ((i + 2 * j) % 7 == 0) pool_set(water, CD_WALL_X, i, j, 1);
            if ((2 * i + j) % 9 == 0) pool_set(water, CD_WALL_Y, i, j, 1);
        }
}

void pool_beach(cd_water* water) {
    beach(water, 0.8, 1);
    stir(water, 0.1, 2);
}

void pool_dam(cd_water* water) {
    ok(cd_water_set_momentum(water, CD_MOMENTUM_ADVECTED));
    dam(water, 0.8);
}

void pool_flood(cd_water* water) {
    pool_dam(water);
    ok(cd_water_set_manning(water, 0.03));
}

void pool_weir(cd_water* water) {
    ok(cd_water_set_momentum(water, CD_MOMENTUM_ADVECTED));
    beach(water, -0.5, 3);
    stir(water, 0.1, 4);
    ok(cd_water_set_side(water, CD_SIDE_X_LAST, CD_BORDER_LEVEL, 0.2, -0.01));
    ok(cd_water_set_side(water, CD_SIDE_Y_FIRST, CD_BORDER_LEVEL, 0.1, 0));
}

void pool_explicit(cd_water* water) {
    ok(cd_water_set_method(water, CD_METHOD_SYMPLECTIC_EULER));
    beach(water, 0.8, 5);
    blow(water, 0.25, -0.125);
}

void pool_forward(cd_water* water) {
    ok(cd_water_set_method(water, CD_METHOD_FORWARD_EULER));
    ok(cd_water_set_drag(water, 0.5));
    pool_vary(water, CD_DEPTH, 0.5, 0.03, 6);
}

void pool_tide(cd_water* water) {
    beach(water, 0.6, 7);
    ok(cd_water_set_side(water, CD_SIDE_X_FIRST, CD_BORDER_OPEN, 0.05, 0.1));
    ok(cd_water_set_side(water, CD_SIDE_X_LAST, CD_BORDER_OPEN, -0.3, -0.02));
    ok(cd_water_set_drag(water, 0.05));
}

void pool_river(cd_water* water) {
    ok(cd_water_set_momentum(water, CD_MOMENTUM_ADVECTED));
    ok(cd_water_set_manning(water, 0.04));
    beach(water, -0.5, 8); /* downhill */
    ok(cd_water_set_side(water, CD_SIDE_X_FIRST, CD_BORDER_INFLOW, 0.2, 0.01));
    ok(cd_water_set_side(water, CD_SIDE_X_LAST, CD_BORDER_OPEN, -10, 0));
    ok(cd_water_set_side(water, CD_SIDE_Y_LAST, CD_BORDER_INFLOW, -0.01, 0));
}

void pool_torus(cd_water* water) {
    ok(cd_water_set_momentum(water, CD_MOMENTUM_ADVECTED));
    ok(cd_water_set_side(water, CD_SIDE_X_FIRST, CD_BORDER_PERIODIC, 0, 0));
    ok(cd_water_set_side(water, CD_SIDE_Y_LAST, CD_BORDER_PERIODIC, 0, 0));
    ok(cd_water_set_drag(water, 0.02));
    pool_vary(water, CD_DEPTH, 0.5, 0.05, 9);
    pool_vary(water, CD_VELOCITY_X, 0.3, 0.1, 10);
    pool_vary(water, CD_VELOCITY_Y, -0.2, 0.1, 11);
}

void pool_masked(cd_water* water) {
    const struct pool_extent all = pool_extent(water, CD_DEPTH);
    ok(cd_water_set_side(water, CD_SIDE_Y_FIRST, CD_BORDER_PERIODIC, 0, 0));
    beach(water, 0.8, 12);
    stir(water, 0.1, 13);
    build_in(water, all.columns, all.rows);
}

void pool_fed(cd_water* water) {
    const struct pool_extent all = pool_extent(water, CD_DEPTH);
    const double length = (double)all.columns * POOL_DX, width = (double)all.rows * POOL_DY;
    ok(cd_water_set_momentum(water, CD_MOMENTUM_ADVECTED));
    ok(cd_water_set_density(water, 1025));
    ok(cd_water_set_first(water, 1));
    dam(water, 0.4);
    ok(cd_water_add_source(water, length / 3, width / 3, 1, 0.25));
    ok(cd_water_add_source(water, length / 2, width / 2, 1.5, -0.5));
    ok(cd_water_add_source_rectangle(water, 0, 0, all.columns, 1, 0.125));
    pool_vary(water, CD_PRESSURE, 0, 50, 14);
    blow(water, 0.0625, 0.125);
}

static void all_fields(cd_water* water) {
    const struct pool_extent all = pool_extent(water, CD_DEPTH);
    ok(cd_water_set_momentum(water, CD_MOMENTUM_ADVECTED));
    ok(cd_water_set_lambda(water, 0.625));
    ok(cd_water_set_gravity(water, 4.5));
    ok(cd_water_set_density(water, 800));
    ok(cd_water_set_drag(water, 0.1));
    ok(cd_water_set_manning(water, 0.02));
    ok(cd_water_set_bed_rule(water, CD_BED_KEEPS_SURFACE));
    ok(cd_water_set_side(water, CD_SIDE_Y_FIRST, CD_BORDER_OPEN, 0.05, 0.01));
    ok(cd_water_set_side(water, CD_SIDE_Y_LAST, CD_BORDER_INFLOW, 0.04, -0.001));
    ok(cd_water_set_inflow_depth(water, CD_SIDE_Y_LAST, 0.03125));
    beach(water, 0.7, 15);
    build_in(water, all.columns, all.rows);
    stir(water, 0.2, 16);
    pool_vary(water, CD_SOURCE, 0, 0.02, 18);
    pool_vary(water, CD_PRESSURE, 10, 50, 19);
    blow(water, -0.0625, 0.125);
}

void pool_everything(cd_water* water) {
    all_fields(water);
    ok(cd_water_set_side(water, CD_SIDE_X_LAST, CD_BORDER_OPEN, -0.1, 0));
}

void pool_everything_long(cd_water* water) {
    ok(cd_water_set_side(water, CD_SIDE_X_FIRST, CD_BORDER_PERIODIC, 0, 0));
    all_fields(water);
    ok(cd_water_set_side(water, CD_SIDE_Y_LAST, CD_BORDER_LEVEL, 0.1, 0));
    ok(cd_water_set_first(water, 1));
}

/* Three hulls, a disc, a flat one and one with a bow, one of which lies on what is dry; the first is driven. */
static void float_hulls(cd_water* water) {
    const struct pool_extent all = pool_extent(water, CD_DEPTH);
    const double length = (double)all.columns * POOL_DX, width = (double)all.rows * POOL_DY;
    static const double heights[8] = {0, 0, 0.125, -1, 0.0625, 0, 0.125, 0.25};
    ok(cd_water_set_hulls(water, 3, 4, 2));
    ok(cd_water_set_hull(water, 0, 150, 1.5, 1, heights, 8));
    ok(cd_water_set_disc(water, 1, 40, 0.75));
    ok(cd_water_set_hull(water, 2, 2000, 2, 0.75, NULL, 0));
    ok(cd_water_set_hull_drag(water, 0, 20, 200, 0.25));
    ok(cd_water_set_hull_drag(water, 2, 0, 500, 0.5));
    ok(cd_water_launch_hull(water, 0, length / 2, width / 2, 1, 1));
    ok(cd_water_launch_hull(water, 1, length / 4, width / 3, 1, 0));
    ok(cd_water_launch_hull(water, 2, length / 3, width / 4, 0, -1));
    ok(cd_water_set_hull_force(water, 0, (const double[6]){100, 0, 0, 10, 0, 0}, 6));
    ok(cd_water_set_hull_velocity(water, 1, (const double[6]){0.5, -0.25, 0.125, 0.5, 0.25, -0.125}, 6));
}

void pool_hulls(cd_water* water) {
    beach(water, 0.7, 30);
    stir(water, 0.2, 31);
    float_hulls(water);
}

void pool_hulls_long(cd_water* water) {
    ok(cd_water_set_side(water, CD_SIDE_X_FIRST, CD_BORDER_PERIODIC, 0, 0));
    ok(cd_water_set_momentum(water, CD_MOMENTUM_ADVECTED));
    dam(water, 0.6);
    float_hulls(water);
}

const struct pool_scene pools[POOLS] = {
    {"beach", pool_beach, 0.1},
    {"dam", pool_dam, 0.05},
    {"flood", pool_flood, 0.5},
    {"weir", pool_weir, 0.1},
    {"explicit", pool_explicit, 0.02},
    {"forward", pool_forward, 0.002},
    {"tide", pool_tide, 0.1},
    {"river", pool_river, 0.05},
    {"torus", pool_torus, 0.1},
    {"masked", pool_masked, 0.1},
    {"fed", pool_fed, 0.05},
    {"everything", pool_everything, 0.05},
    {"everything, long steps", pool_everything_long, 0.5},
    {"hulls", pool_hulls, 0.05},
    {"hulls, long steps", pool_hulls_long, 0.5},
};

cd_water* pool_of(size_t scene, size_t nx, size_t ny, cd_precision precision, size_t steps) {
    cd_water* water = pool(nx, ny, precision);
    pools[scene].build(water);
    pool_step(water, pools[scene].dt, steps);
    return water;
}
