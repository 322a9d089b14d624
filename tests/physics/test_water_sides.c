/* What is at the sides: open water that waves leave into, tides, streams, and the opposite side. */
#include <math.h>
#include <stdlib.h>

#include "basin.h"
#include "check.h"
#include "modes.h"
#include "reference.h"

static const double gravity = 9.81;

/* ---- echoes ------------------------------------------------------------------------------------------------------ */

/* The largest height of what comes back of a hump of height 1 that runs into a side of water 2 m deep. */
static double echo(const struct way* way, cd_side side, cd_border kind, size_t n) {
    const int along_y = side >= CD_SIDE_Y_FIRST, last = side % 2;
    const double deep = 2, dx = 10.0 / (double)n, height = 1e-4, c = sqrt(gravity * deep), width = 0.5;
    double* values = calloc(n + 1, sizeof *values);
    assert_non_null(values);
    cd_water* w = line_basin(along_y, n, 2, dx, CD_FLOAT64);
    basin_set_way(w, way);
    ok(cd_water_set_tolerance(w, 1e-9, 200));
    ok(cd_water_set_side(w, side, kind, kind == CD_BORDER_OPEN ? deep : 0, 0));
    for (size_t i = 0; i < n; ++i) values[i] = deep + height * exp(-pow((((double)i + 0.5) * dx - 5) / width, 2) / 2);
    line_write(w, along_y, CD_DEPTH, values);
    for (size_t i = 0; i <= n; ++i)
        values[i] = (last ? 1 : -1) * c / deep * height * exp(-pow(((double)i * dx - 5) / width, 2) / 2);
    values[0] = values[n] = 0;
    line_write(w, along_y, CD_VELOCITY_X, values);
    const size_t steps = 2 * n; /* half a cell each */
    for (size_t k = 0; k < steps; ++k) basin_step(w, 0.5 * dx / c, 1);
    line_read(w, along_y, CD_DEPTH, 1e-9 * height, values);
    double largest = 0;
    for (size_t i = 0; i < n; ++i) largest = fmax(largest, fabs(values[i] - deep) / height);
    free(values);
    cd_water_destroy(w);
    return largest;
}

static void a_wave_leaves_through_an_open_side(void** state) {
    (void)state;
    static const int which[] = {LINEAR, LINEAR_HALF, ADVECTED, LARGE_2, COUPLED, EXPLICIT, EXPLICIT_ADVECTED};
    for (size_t k = 0; k < COUNT(which); ++k)
        for (cd_side side = CD_SIDE_X_FIRST; side <= CD_SIDE_Y_LAST; ++side) {
            double before = INFINITY;
            if (side > CD_SIDE_X_FIRST && k % 2) continue;
            for (size_t n = 100; n <= 400; n *= 2) {
                const double open = echo(&ways[which[k]], side, CD_BORDER_OPEN, n);
                const double wall = echo(&ways[which[k]], side, CD_BORDER_WALL, n);
                if (side == CD_SIDE_X_FIRST)
                    print_message("%-17s %zu cells: %.1e comes back of an open side, %.2f of a wall\n",
                                  ways[which[k]].name, n, open, wall);
                assert_true(wall > 0.7);
                assert_true(open <
                            (ways[which[k]].lambda > 0.5 || basin_is_explicit(&ways[which[k]]) ? 0.6 : 0.3) * before);
                before = open;
            }
            assert_true(before < (basin_is_explicit(&ways[which[k]]) ? 5e-3
                                  : ways[which[k]].lambda > 0.5      ? 5e-4
                                                                     : 2e-4));
        }
}

/* ---- tides ------------------------------------------------------------------------------------------------------- */

/* An outside level of a sin(w t) sends in waves of half its height; what the wall at the end sends back leaves again:
 * a cos(w (L - x) / c) sin(w (t - L / c)). */
static double tide(const struct way* way, cd_side side, size_t n, int with_rate) {
    const int along_y = side >= CD_SIDE_Y_FIRST, last = side % 2;
    const double deep = 10, length = 1000, dx = length / (double)n, c = sqrt(gravity * deep), height = 1e-4;
    const double w = 0.6 * c / length, dt = dx / c;
    const size_t steps = (size_t)lround(12 * 2 * (double)PI / w / dt);
    double* values = calloc(n, sizeof *values);
    assert_non_null(values);
    cd_water* water = line_basin(along_y, n, 1, dx, CD_FLOAT64);
    basin_set_way(water, way);
    for (size_t i = 0; i < n; ++i) values[i] = deep;
    line_write(water, along_y, CD_DEPTH, values);
    for (size_t k = 0; k < steps; ++k) {
        const double t = (double)k * dt, now = height * sin(w * t), then = height * sin(w * (t + dt));
        ok(cd_water_set_side(water, side, CD_BORDER_OPEN, deep + now, with_rate ? (then - now) / dt : 0));
        basin_step(water, dt, 1);
    }
    line_read(water, along_y, CD_DEPTH, 0, values);
    double off = 0;
    const double t = (double)steps * dt;
    for (size_t i = 0; i < n; ++i) {
        const double x = ((double)i + 0.5) * dx, from_wall = last ? x : length - x;
        const double exact = cos(w * from_wall / c) * sin(w * (t - length / c));
        off = fmax(off, fabs((values[i] - deep) / height - exact));
    }
    assert_true(basin_volume_off(water) <= 1e-13);
    free(values);
    cd_water_destroy(water);
    return off;
}

static void a_tide_runs_into_a_basin_and_out_again(void** state) {
    (void)state;
    static const int which[] = {LINEAR_HALF, ADVECTED, LARGE_2};
    for (size_t k = 0; k < COUNT(which); ++k)
        for (cd_side side = CD_SIDE_X_FIRST; side <= CD_SIDE_Y_LAST; ++side) {
            double before = INFINITY;
            for (size_t n = 25; n <= 100; n *= 2) {
                const double off = tide(&ways[which[k]], side, n, 1);
                if (side == CD_SIDE_X_FIRST)
                    print_message("%-17s %zu cells: tide off by %.1e of its height (without a rate: %.1e)\n",
                                  ways[which[k]].name, n, off, tide(&ways[which[k]], side, n, 0));
                assert_true(off < 0.4 * before);
                before = off;
            }
            assert_true(before < 2e-5);
        }
}

/* A basin of beaches fills up to the level outside, and stays; it drains off a side that lies below its bed. */
static void a_basin_fills_to_the_level_outside_and_drains(void** state) {
    (void)state;
    enum { N = 12 };
    for (size_t k = 0; k < WAYS; ++k) {
        cd_water* w = basin(N, N, 1, 1, CD_FLOAT64);
        basin_set_way(w, &ways[k]);
        basin_random_bed(w, 0.8, 4, 3);
        ok(cd_water_set_drag(w, 0.2));
        ok(cd_water_set_side(w, CD_SIDE_Y_LAST, CD_BORDER_OPEN, 1, 0));
        const double dt = basin_is_explicit(&ways[k]) ? 0.1 : 0.25;
        for (int s = 0; s < 4000; ++s) basin_step(w, dt, 1);
        assert_near(basin_least(w, CD_SURFACE), 1, 1e-6, 0);
        assert_near(-basin_least(w, CD_SURFACE), -1, 1e-6, 0);
        assert_true(basin_largest(w, CD_VELOCITY_X) < 1e-6);
        const double full = basin_volume(w);
        ok(cd_water_set_side(w, CD_SIDE_Y_LAST, CD_BORDER_OPEN, -3, 0));
        for (int s = 0; s < 4000; ++s) basin_step(w, dt, 1);
        assert_true(basin_volume(w) < 0.5 * full); /* pools stay in the hollows */
        assert_true(basin_least(w, CD_DEPTH) >= 0);
        assert_true(basin_volume_off(w) <= 1e-12);
        cd_water_destroy(w);
    }
}

/* ---- streams ----------------------------------------------------------------------------------------------------- */

/* What comes in by a discharge and its rate is known to rounding, and so is what leaves by a negative one. */
static void discharges_bring_in_what_they_say(void** state) {
    (void)state;
    for (size_t k = 0; k < WAYS; ++k)
        for (cd_side side = CD_SIDE_X_FIRST; side <= CD_SIDE_Y_LAST; ++side) {
            double in, out, q;
            cd_border kind;
            const double dt = 0.01, first = 0.3, rate = 0.05;
            cd_water* w = basin(8, 6, 0.5, 0.25, CD_FLOAT64);
            const double length = side < CD_SIDE_Y_FIRST ? 6 * 0.25 : 8 * 0.5, start = 1;
            basin_set_way(w, &ways[k]);
            for (size_t c = 0; c < 48; ++c) basin_set(w, CD_DEPTH, c % 8, c / 8, start);
            ok(cd_water_set_side(w, side, CD_BORDER_INFLOW, first, rate));
            for (int s = 0; s < 100; ++s) basin_step(w, dt, 1);
            ok(cd_water_get_account(w, NULL, &in, &out, NULL));
            /* taken at lambda of each step */
            const double lambda = basin_is_explicit(&ways[k]) ? 1 : ways[k].lambda;
            const double expected = (first * 1 + rate * (0.5 + (lambda - 0.5) * dt)) * length;
            assert_near(in, expected, 1e-12, 0);
            assert_true(out == 0);
            ok(cd_water_get_side(w, side, &kind, &q, NULL));
            assert_int_equal(kind, CD_BORDER_INFLOW);
            assert_near(q, first + rate, 1e-12, 0);
            ok(cd_water_set_side(w, side, CD_BORDER_INFLOW, -first, 0));
            for (int s = 0; s < 50; ++s) basin_step(w, dt, 1);
            ok(cd_water_get_account(w, NULL, NULL, &out, NULL));
            assert_near(out, first * 0.5 * length, 1e-12, 0);
            for (int s = 0; s < 4000; ++s) basin_step(w, dt, 1); /* it runs dry there, and no further */
            assert_true(basin_least(w, CD_DEPTH) >= 0);
            assert_true(basin_volume_off(w) <= 1e-12);
            cd_water_destroy(w);
        }
}

/* ---- periodic sides ---------------------------------------------------------------------------------------------- */

/* Where the seam is makes no difference to water that is wet all round. */
static void a_ring_does_not_know_where_it_begins(void** state) {
    (void)state;
    enum { NX = 13, NY = 9 };
    for (size_t k = 0; k < WAYS; ++k) {
        double bed[NX * NY], depth[NX * NY], u[NX * NY], v[NX * NY], worst = 0;
        cd_water* w[2];
        uint64_t seed = 3;
        for (size_t c = 0; c < NX * NY; ++c) {
            bed[c] = 0.3 * random_number(&seed), depth[c] = 2 + 0.3 * random_number(&seed);
            u[c] = 0.5 * random_number(&seed), v[c] = 0.5 * random_number(&seed);
        }
        for (int shifted = 0; shifted < 2; ++shifted) {
            const size_t by_x = shifted ? 5 : 0, by_y = shifted ? 4 : 0;
            w[shifted] = basin(NX, NY, 1, 1.5, CD_FLOAT64);
            basin_set_way(w[shifted], &ways[k]);
            ok(cd_water_set_tolerance(w[shifted], 1e-13, 300));
            ok(cd_water_set_side(w[shifted], CD_SIDE_X_FIRST, CD_BORDER_PERIODIC, 0, 0));
            ok(cd_water_set_side(w[shifted], CD_SIDE_Y_LAST, CD_BORDER_PERIODIC, 0, 0));
            for (size_t j = 0; j < NY; ++j)
                for (size_t i = 0; i < NX; ++i) {
                    const size_t x = (i + by_x) % NX, y = (j + by_y) % NY, c = j * NX + i;
                    basin_set(w[shifted], CD_BED, x, y, bed[c]);
                    basin_set(w[shifted], CD_DEPTH, x, y, depth[c]);
                    basin_set(w[shifted], CD_VELOCITY_X, x, y, u[c]);
                    basin_set(w[shifted], CD_VELOCITY_Y, x, y, v[c]);
                }
            for (int s = 0; s < 100; ++s) basin_step(w[shifted], 0.05, 1);
        }
        for (size_t j = 0; j < NY; ++j)
            for (size_t i = 0; i < NX; ++i) {
                const size_t x = (i + 5) % NX, y = (j + 4) % NY;
                for (cd_field f = CD_DEPTH; f <= CD_VELOCITY_Y; ++f)
                    worst = fmax(worst, fabs(basin_get(w[0], f, i, j) - basin_get(w[1], f, x, y)));
            }
        print_message("%-17s a ring elsewhere: apart by %.1e\n", ways[k].name, worst);
        assert_true(worst <= 1e-9);
        assert_true(basin_volume_off(w[0]) <= 1e-13);
        cd_water_destroy(w[0]);
        cd_water_destroy(w[1]);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_wave_leaves_through_an_open_side),
        cmocka_unit_test(a_tide_runs_into_a_basin_and_out_again),
        cmocka_unit_test(a_basin_fills_to_the_level_outside_and_drains),
        cmocka_unit_test(discharges_bring_in_what_they_say),
        cmocka_unit_test(a_ring_does_not_know_where_it_begins),
    };
    return cmocka_run_group_tests_name("water sides", tests, NULL, NULL);
}
