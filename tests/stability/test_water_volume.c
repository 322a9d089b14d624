/* Water is what came in less what went out, and no column is less than empty, whatever storms, tides, sources, drains
 * and beaches there are. */
#include <math.h>
#include <stdlib.h>

#include "basin.h"
#include "check.h"
#include "reference.h"

static double in_range(uint64_t* seed, double least, double most) {
    return least + (most - least) * (random_number(seed) + 1) / 2;
}
static double in_decades(uint64_t* seed, double least, double most) {
    return least * pow(most / least, in_range(seed, 0, 1));
}
static size_t among(uint64_t* seed, size_t count) {
    const size_t k = (size_t)in_range(seed, 0, (double)count);
    return k < count ? k : count - 1;
}

static void assert_no_depth_below_0(const cd_water* w, double* depth) {
    const size_t count = basin_count(w, CD_DEPTH);
    basin_read(w, CD_DEPTH, depth);
    for (size_t k = 0; k < count; ++k)
        if (!(depth[k] >= 0 && isfinite(depth[k]))) assert_near(depth[k], 0, 0, 0);
}

/* ---- storms ------------------------------------------------------------------------------------------------------ */

enum { NX = 12, NY = 10, CELLS = NX * NY };

/* What happens every now and then on a beach, with a tide on one side and a stream from another. */
static void storm(cd_water* w, uint64_t* seed, size_t event) {
    double x = in_range(seed, 0, NX), y = in_range(seed, 0, NY), time, depth;
    ok(cd_water_get_time(w, &time));
    const double tide = 1 + 0.4 * sin(0.05 * time), rate = 0.02 * cos(0.05 * time);
    ok(cd_water_set_side(w, CD_SIDE_X_FIRST, CD_BORDER_OPEN, tide, rate));
    ok(cd_water_set_side(w, CD_SIDE_Y_LAST, CD_BORDER_INFLOW, 0.05 * sin(0.013 * time), 0));
    switch (event % 5) {
    case 0: ok(cd_water_splash(w, x, y, in_range(seed, 0, 3), 0.3)); break;
    case 1: /* some metres per second, not more where the water is thin */
        ok(cd_water_sample(w, (const double[]){x, y}, 1, CD_OUTSIDE_REFUSED, NULL, &depth, NULL, NULL));
        if (depth < 0.2) break;
        ok(cd_water_impulse(w, x, y, 1, 5000 * depth * random_number(seed), 5000 * depth * random_number(seed)));
        break;
    case 2: ok(cd_water_add_volume(w, x, y, in_range(seed, 0, 3), random_number(seed), NULL)); break;
    case 3: ok(cd_water_add_volume_rectangle(w, 2, 3, 5, 4, random_number(seed), NULL)); break;
    default: /* a source and a drain, elsewhere each time */
        ok(cd_water_disable_field(w, CD_SOURCE));
        ok(cd_water_add_source(w, x, y, 2, 0.3));
        ok(cd_water_add_source_rectangle(w, 8, 6, 3, 3, -0.4));
    }
}

static double stormy(const struct way* way, cd_precision precision, size_t steps, double* out_turned_over) {
    cd_water* w = basin(NX, NY, 1, 1, precision);
    double depth[CELLS], initial, in, out;
    uint64_t seed = 5;
    basin_random_bed(w, 2, 3, 7);
    basin_set_way(w, way);
    ok(cd_water_set_drag(w, 0.02));
    for (size_t k = 0; k < CELLS; ++k) depth[k] = fmax(0, random_number(&seed));
    basin_write(w, CD_DEPTH, depth);
    for (size_t k = 0; k < steps; ++k) {
        const double dt = basin_is_explicit(way) ? fmin(0.05, 0.5 * basin_stable_dt(w)) : 0.1;
        if (k % 50 == 0) storm(w, &seed, k / 50);
        basin_step(w, dt, 1);
        assert_no_depth_below_0(w, depth);
    }
    const double off = basin_volume_off(w);
    ok(cd_water_get_account(w, &initial, &in, &out, NULL));
    *out_turned_over = in / initial;
    cd_water_destroy(w);
    return off;
}

static void a_hundred_thousand_steps_of_storms_lose_no_water(void** state) {
    (void)state;
    for (size_t k = 0; k < WAYS; ++k)
        for (int p = 0; p < 2; ++p) {
            if (!is_taken(k + (size_t)p, 3)) continue;
            const size_t steps = 100000;
            double turned_over;
            const double off = stormy(&ways[k], p ? CD_FLOAT64 : CD_FLOAT32, steps, &turned_over);
            print_message("%-17s %s: %6zu steps, %5.1f times the volume came in, off by %.1e\n", ways[k].name,
                          p ? "float64" : "float32", steps, turned_over, off);
            assert_true(off <= (p ? 1e-12 : 1e-6));
            assert_true(turned_over > 3);
        }
}

/* ---- anything ---------------------------------------------------------------------------------------------------- */

static void draw_sides(cd_water* w, uint64_t* seed, double height) {
    for (cd_side s = CD_SIDE_X_FIRST; s <= CD_SIDE_Y_LAST; ++s) {
        const cd_border kind = (cd_border)among(seed, 8); /* mostly walls */
        if (kind > CD_BORDER_LEVEL || (kind == CD_BORDER_PERIODIC && s % 2)) continue;
        ok(cd_water_set_side(w, s, kind, in_range(seed, -0.5, 1) * height, 0.1 * random_number(seed) * height));
    }
}

static void draw_extras(cd_water* w, uint64_t* seed, double height) {
    double values[32 * 32];
    static const cd_field fields[] = {CD_SOURCE, CD_PRESSURE, CD_FORCE_X, CD_FORCE_Y, CD_WALL_X, CD_WALL_Y, CD_MASK};
    for (size_t f = 0; f < COUNT(fields); ++f) {
        if (among(seed, 3)) continue;
        ok(cd_water_enable_field(w, fields[f]));
        const size_t count = basin_count(w, fields[f]);
        for (size_t k = 0; k < count; ++k) {
            const double r = random_number(seed);
            if (fields[f] == CD_WALL_X || fields[f] == CD_WALL_Y) values[k] = r > 0.7;
            else if (fields[f] == CD_MASK) values[k] = r < 0.7;
            else values[k] = fields[f] == CD_PRESSURE ? 1e4 * r * height : r * height;
        }
        basin_write(w, fields[f], values);
    }
    if (among(seed, 3) == 0) ok(cd_water_set_drag(w, in_decades(seed, 1e-3, 1e3)));
    if (among(seed, 3) == 0) ok(cd_water_set_manning(w, in_decades(seed, 1e-3, 1)));
}

/* Velocities of faces that water can cross; random, and large beside the waves' speed. */
static void draw_velocities(cd_water* w, uint64_t* seed, double speed) {
    for (int axis = 0; axis < 2; ++axis) {
        const cd_field field = axis ? CD_VELOCITY_Y : CD_VELOCITY_X;
        size_t nx, ny;
        ok(cd_water_get_shape(w, &nx, &ny, NULL, NULL, NULL));
        for (size_t j = 0; j < ny + (axis ? 1 : 0); ++j)
            for (size_t i = 0; i < nx + (axis ? 0 : 1); ++i) {
                const double u = speed * random_number(seed);
                (void)cd_water_write_f64(w, field, i, j, 1, 1, &u, 1); /* refused where a wall is */
            }
    }
}

static void anything(uint64_t number, cd_precision precision, double* worst) {
    uint64_t seed = 77 + 1000 * number;
    double depth[32 * 32];
    const struct way* way = &ways[number % WAYS];
    const size_t nx = 1 + among(&seed, 20), ny = among(&seed, 3) ? 1 + among(&seed, 20) : 1;
    const double dx = in_decades(&seed, 0.01, 100), dy = dx * in_decades(&seed, 0.01, 100);
    const double height = in_decades(&seed, 1e-3, 1e3);
    cd_water* w = basin(nx, ny, dx, dy, precision);
    basin_set_way(w, way);
    if (!basin_is_explicit(way) && among(&seed, 2)) ok(cd_water_set_lambda(w, in_range(&seed, 0.5, 1)));
    basin_random_bed(w, height, among(&seed, 2) ? 3 * dx : 0, seed);
    draw_sides(w, &seed, height);
    draw_extras(w, &seed, height);
    const size_t count = basin_count(w, CD_DEPTH);
    for (size_t k = 0; k < count; ++k) {
        depth[k] = fmax(0, random_number(&seed)) * height * (among(&seed, 4) ? 1 : in_decades(&seed, 1e-12, 1));
        size_t i = k % nx, j = k / nx;
        if (cd_water_write_f64(w, CD_DEPTH, i, j, 1, 1, &depth[k], 1) != CD_OK) depth[k] = 0; /* absent */
    }
    draw_velocities(w, &seed, in_decades(&seed, 1e-2, 10) * sqrt(9.81 * height));
    ok(cd_water_restart_account(w));
    const double courant = in_decades(&seed, 0.1, 1e4);
    const double dt = courant * fmin(dx, dy) / sqrt(9.81 * height);
    for (int k = 0; k < 30; ++k) {
        const double stable = basin_stable_dt(w);
        basin_step(w, basin_is_explicit(way) ? fmin(0.5 * stable, 0.1 * dx / sqrt(9.81 * height)) : dt, 1);
        assert_no_depth_below_0(w, depth);
        (void)basin_largest(w, CD_VELOCITY_X); /* finite */
        (void)basin_largest(w, CD_VELOCITY_Y);
        const double off = basin_volume_off(w);
        if (!(off <= (precision ? 1e-13 : 4e-6)))
            print_message("number %zu, %s, step %d: off by %.1e\n", (size_t)number, way->name, k, off);
        *worst = fmax(*worst, off);
    }
    cd_water_destroy(w);
}

static void anything_at_all_keeps_its_account_and_no_column_is_less_than_empty(void** state) {
    (void)state;
    double worst[2] = {0, 0};
    const uint64_t count = is_long() ? 50000 : 1000;
    for (uint64_t number = 0; number < count; ++number)
        for (int p = 0; p < 2; ++p) anything(number, p ? CD_FLOAT64 : CD_FLOAT32, &worst[p]);
    print_message("%zu scenes: accounts off by %.1e (float32), %.1e (float64)\n", (size_t)count, worst[0], worst[1]);
    assert_true(worst[0] <= (count > 2000 ? 4e-6 : 1e-6)); /* far out in the sweep, all of it in a few cells */
    assert_true(worst[1] <= 1e-13);
}

/* ---- launches ---------------------------------------------------------------------------------------------------- */

/* What a hull displaces is far less than what rounding takes from deep cells, and so is the water in shallow ones. */
static void a_launch_hands_on_water_without_taking_more_than_there_is(void** state) {
    (void)state;
    enum { LINE = 64 };
    double depth[LINE];
    for (int length = 1; length <= 3; ++length) {
        cd_water* w = basin(LINE, 1, 1, 1, CD_FLOAT32);
        for (size_t i = 0; i < LINE; ++i) basin_set(w, CD_BED, i, 0, i % 8 ? -100 : -1e-7);
        for (size_t i = 0; i < LINE; ++i) basin_set(w, CD_SURFACE, i, 0, 0);
        ok(cd_water_restart_account(w));
        ok(cd_water_set_hulls(w, 1, 4, 2));
        ok(cd_water_set_hull(w, 0, 0.1, length, 1, NULL, 0));
        ok(cd_water_launch_hull(w, 0, 20.5, 0.5, 1, 0));
        assert_no_depth_below_0(w, depth);
        assert_true(basin_volume_off(w) <= 1e-15);
        cd_water_destroy(w);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_hundred_thousand_steps_of_storms_lose_no_water),
        cmocka_unit_test(anything_at_all_keeps_its_account_and_no_column_is_less_than_empty),
        cmocka_unit_test(a_launch_hands_on_water_without_taking_more_than_there_is),
    };
    return cmocka_run_group_tests_name("water volume", tests, NULL, NULL);
}
