/* What pushes and slows water: friction, wind, air pressure, beds that rise. */
#include <math.h>
#include <stdlib.h>

#include "basin.h"
#include "check.h"
#include "reference.h"

static const double gravity = 9.81;

/* ---- friction ---------------------------------------------------------------------------------------------------- */

/* A channel that runs on and on, all wet to one depth; its water never goes as far as a cell in a step. */
static cd_water* channel(const struct way* way, int along_y, size_t n, double depth, double speed) {
    double values[200];
    cd_water* w = line_basin(along_y, n, 3, 2e4, CD_FLOAT64);
    basin_set_way(w, way);
    ok(cd_water_set_side(w, line_side(along_y, 0), CD_BORDER_PERIODIC, 0, 0));
    for (size_t i = 0; i <= n; ++i) values[i] = depth;
    line_write(w, along_y, CD_DEPTH, values);
    for (size_t i = 0; i <= n; ++i) values[i] = speed;
    line_write(w, along_y, CD_VELOCITY_X, values);
    return w;
}

static double speed_of(const cd_water* w, int along_y) {
    double values[200];
    line_read(w, along_y, CD_VELOCITY_X, 1e-12, values);
    return values[1];
}

/* A force of g S for a slope of S: d^(2/3) sqrt(S) / manning, whatever the step. */
static void water_settles_at_mannings_speed(void** state) {
    (void)state;
    static const double depths[] = {0.01, 1, 30}, steps[] = {0.1, 10, 1000};
    const double manning = 0.03, slope = 1e-3;
    for (size_t k = 0; k < WAYS; ++k)
        for (size_t d = 0; d < COUNT(depths); ++d)
            for (size_t s = 0; s < COUNT(steps); ++s) {
                const int along_y = (int)((d + s) % 2);
                double push[11];
                if (basin_is_explicit(&ways[k]) && s > 0) continue;
                if (s == 0 && d == 2) continue; /* takes too long */
                cd_water* w = channel(&ways[k], along_y, 10, depths[d], 0);
                const cd_field force = line_field(along_y, CD_FORCE_X);
                ok(cd_water_set_manning(w, manning));
                ok(cd_water_enable_field(w, force));
                for (size_t i = 0; i <= 10; ++i) push[i] = gravity * slope;
                line_write(w, along_y, CD_FORCE_X, push);
                for (int n = 0; n < 20000 && (s == 0 || n < 1000); ++n) ok(cd_water_step(w, steps[s], 1));
                const double expected = pow(depths[d], 2.0 / 3) * sqrt(slope) / manning;
                assert_near(speed_of(w, along_y), expected, 1e-7, 0);
                cd_water_destroy(w);
            }
}

/* The same down a bed that slopes, fed from its upper end, in the middle of its length. */
static void a_stream_runs_down_a_slope_at_mannings_speed(void** state) {
    (void)state;
    enum { N = 100 };
    const double manning = 0.03, slope = 2e-3, depth = 0.8;
    const double speed = pow(depth, 2.0 / 3) * sqrt(slope) / manning;
    for (size_t k = 0; k < WAYS; ++k)
        for (int along_y = 0; along_y < 2; ++along_y) {
            double values[N + 1];
            cd_water* w = line_basin(along_y, N, 1, 50, CD_FLOAT64);
            basin_set_way(w, &ways[k]);
            ok(cd_water_set_manning(w, manning));
            for (size_t i = 0; i < N; ++i) values[i] = 10 - slope * 50 * ((double)i + 0.5);
            line_write(w, along_y, CD_BED, values);
            ok(cd_water_set_side(w, line_side(along_y, 0), CD_BORDER_INFLOW, depth * speed, 0));
            ok(cd_water_set_side(w, line_side(along_y, 1), CD_BORDER_OPEN,
                                 values[N - 1] + depth - speed * sqrt(depth / gravity), 0));
            const double dt = 10;
            for (int s = 0; s < 4000; ++s) basin_step(w, dt, 1);
            line_read(w, along_y, CD_DEPTH, 0, values);
            const double there = values[N / 2];
            line_read(w, along_y, CD_VELOCITY_X, 0, values);
            if (!along_y)
                print_message("%-17s depth x %.6f, speed x %.6f of Manning's\n", ways[k].name, there / depth,
                              values[N / 2] / speed);
            assert_near(there, depth, 1e-4, 0);
            assert_near(values[N / 2], speed, 1e-4, 0);
            assert_true(basin_volume_off(w) <= 1e-12);
            cd_water_destroy(w);
        }
}

/* Slanting to the axes too: friction goes by the speed, not by what of it runs along an axis. */
static void what_runs_slantwise_settles_at_mannings_speed(void** state) {
    (void)state;
    enum { N = 4 };
    static const double steps[] = {0.1, 10, 1000};
    const double manning = 0.03, slope = 1e-3;
    for (size_t k = 0; k < WAYS; ++k)
        for (size_t s = 0; s < (basin_is_explicit(&ways[k]) ? 1 : COUNT(steps)); ++s)
            for (int degrees = 10; degrees < 90; degrees += 25) {
                double push[2][N * (N + 1)], depth[N * N];
                const double way[2] = {cos(degrees * acos(-1.0) / 180), sin(degrees * acos(-1.0) / 180)};
                cd_water* w = basin(N, N, 2e4, 2e4, CD_FLOAT64);
                basin_set_way(w, &ways[k]);
                ok(cd_water_set_manning(w, manning));
                ok(cd_water_set_side(w, CD_SIDE_X_FIRST, CD_BORDER_PERIODIC, 0, 0));
                ok(cd_water_set_side(w, CD_SIDE_Y_FIRST, CD_BORDER_PERIODIC, 0, 0));
                for (size_t i = 0; i < N * N; ++i) depth[i] = 1;
                basin_write(w, CD_DEPTH, depth);
                for (int axis = 0; axis < 2; ++axis) {
                    const cd_field force = axis ? CD_FORCE_Y : CD_FORCE_X;
                    ok(cd_water_enable_field(w, force));
                    for (size_t i = 0; i < N * (N + 1); ++i) push[axis][i] = gravity * slope * way[axis];
                    basin_write(w, force, push[axis]);
                }
                ok(cd_water_step(w, steps[s], s == 0 ? 20000 : 1000));
                const double u = basin_get(w, CD_VELOCITY_X, 1, 1), v = basin_get(w, CD_VELOCITY_Y, 1, 1);
                const double expected = sqrt(slope) / manning;
                assert_near(u, expected * way[0], 2e-6, 0);
                assert_near(v, expected * way[1], 2e-6, 0);
                cd_water_destroy(w);
            }
}

/* Rivers a kilometre long, of 2 m^2/s, on beds over which they are steady in the depths that are given (MacDonald,
 * Baines, Nichols and Samuels 1997; also in Delestre and others' library of exact solutions, 2013): slower than waves, and
 * from slower to faster. */
static double depth_of_river(int turns_fast, double x) {
    const double critical = cbrt(4 / gravity), s = x / 1000 - 0.5;
    if (!turns_fast) return critical * (1 + 0.5 * exp(-16 * s * s));
    return critical * (1 - (s < 0 ? tanh(3 * s) / 3 : tanh(6 * s) / 6));
}
static double fall_of_river(int turns_fast, double manning, double x) { /* -db/dx */
    const double h = depth_of_river(turns_fast, x), little = 1e-3, q = 2;
    const double rises =
        (depth_of_river(turns_fast, x + little) - depth_of_river(turns_fast, x - little)) / (2 * little);
    return (1 - q * q / (gravity * h * h * h)) * rises + manning * manning * q * q / pow(h, 10.0 / 3);
}

/* Of second order, and the same whatever the step. The side holds the level of the last cell, over whose bed it counts. */
static void a_river_has_its_depths(void** state) {
    (void)state;
    static const double mannings[] = {0.033, 0.0218}, courants[] = {0.5, 4, 32};
    for (int turns_fast = 0; turns_fast < 2; ++turns_fast)
        for (size_t c = 0; c < COUNT(courants); ++c) {
            double before = INFINITY;
            for (size_t n = 50; n <= 200; n *= 2) {
                double bed[200], depth[200], error = 0, b = 0;
                const double dx = 1000 / (double)n, dt = courants[c] * dx / sqrt(gravity * 1.2);
                cd_water* w = line_basin((int)c % 2, n, 1, dx, CD_FLOAT64);
                basin_set_way(w, &ways[ADVECTED]);
                ok(cd_water_set_manning(w, mannings[turns_fast]));
                for (size_t i = n; i-- > 0;) { /* from the lower end up; by Simpson's rule over eighths of that */
                    const double x = dx * ((double)i + 0.5), part = i + 1 == n ? 0.5 * dx : dx;
                    for (int k = 0; k < 8; ++k) {
                        const double from = x + part * k / 8, to = x + part * (k + 1) / 8;
                        b += part / 48 *
                             (fall_of_river(turns_fast, mannings[turns_fast], from) +
                              4 * fall_of_river(turns_fast, mannings[turns_fast], (from + to) / 2) +
                              fall_of_river(turns_fast, mannings[turns_fast], to));
                    }
                    bed[i] = b, depth[i] = depth_of_river(turns_fast, x);
                }
                line_write(w, (int)c % 2, CD_BED, bed);
                line_write(w, (int)c % 2, CD_DEPTH, depth);
                ok(cd_water_set_side(w, line_side((int)c % 2, 0), CD_BORDER_INFLOW, 2, 0));
                ok(cd_water_set_side(w, line_side((int)c % 2, 1), CD_BORDER_LEVEL, bed[n - 1] + depth[n - 1], 0));
                basin_step(w, dt, (size_t)(3000 / dt));
                line_read(w, (int)c % 2, CD_DEPTH, 0, depth);
                for (size_t i = 0; i < n; ++i)
                    error += fabs(depth[i] - depth_of_river(turns_fast, dx * ((double)i + 0.5))) / (double)n;
                print_message("a river that %s, %3zu cells, courant %4.1f: off by %.1e m\n",
                              turns_fast ? "turns fast" : "stays slow", n, courants[c], error);
                assert_true(error <= 0.3 * before);
                before = error;
                cd_water_destroy(w);
            }
        }
}

/* exp(-drag t), as the trapezoidal rule comes to it up to z = drag dt = 2, where it is at rest. */
static void drag_stops_water_as_it_says(void** state) {
    (void)state;
    static const double steps[] = {1e-3, 1, 100};
    for (size_t k = 0; k < WAYS; ++k)
        for (size_t s = 0; s < COUNT(steps); ++s) {
            const double drag = 0.05, dt = steps[s], z = drag * dt;
            cd_water* w = channel(&ways[k], (int)s % 2, 12, 3, 0.7);
            ok(cd_water_set_drag(w, drag));
            for (int n = 0; n < 10; ++n) ok(cd_water_step(w, dt, 1));
            assert_near(speed_of(w, (int)s % 2), 0.7 * pow(z < 2 ? (1 - z / 2) / (1 + z / 2) : 0, 10), 1e-12, 1e-30);
            if (z < 0.1) assert_near(speed_of(w, (int)s % 2), 0.7 * exp(-drag * 10 * dt), z * z * z, 0);
            cd_water_destroy(w);
        }
}

/* However much of velocities it takes in a step, waves in a pool do not get back what they have lost. */
static void what_friction_has_taken_does_not_come_back(void** state) {
    (void)state;
    enum { NX = 12, NY = 9 };
    static const double drags[] = {1, 7, 100}, mannings[] = {0, 0.03, 3}, courants[] = {2, 10, 40, 500};
    uint64_t seed = 1;
    double worst = 0;
    for (int n = 0; n < 180; ++n) {
        const size_t nx = n % 5 ? NX : NX * NY, ny = n % 5 ? NY : 1;
        const double height = pow(10, -1.5 + random_number(&seed)), steep = 0.3 * fabs(random_number(&seed));
        double bed[NX * NY], surface[NX * NY], kinetic, potential;
        cd_water* w = basin(nx, ny, 1, 1, CD_FLOAT64);
        basin_set_way(w, &ways[ADVECTED]);
        ok(cd_water_set_drag(w, drags[n % 3]));
        ok(cd_water_set_manning(w, mannings[n / 3 % 3]));
        if (n / 9 % 2) ok(cd_water_set_side(w, CD_SIDE_X_FIRST, CD_BORDER_PERIODIC, 0, 0));
        for (size_t i = 0; i < nx * ny; ++i) {
            const double x = 2 * acos(-1.0) * (double)(i % nx) / (double)nx, y = (double)(i / nx);
            bed[i] = steep * sin(x + y), surface[i] = 1 + height * cos(x + 0.4 * y);
        }
        basin_write(w, CD_BED, bed), basin_write(w, CD_SURFACE, surface);
        ok(cd_water_get_energy(w, &kinetic, &potential));
        double start = kinetic + potential, least = start;
        for (int k = 0; k < 100; ++k) {
            basin_step(w, courants[n % 4] / sqrt(gravity), 1);
            ok(cd_water_get_energy(w, &kinetic, &potential));
            const double now = kinetic + potential, lost = fmax(start - least, 1e-9 * start);
            worst = fmax(worst, (now - least) / lost), least = fmin(least, now);
        }
        cd_water_destroy(w);
    }
    print_message("of what friction has taken %.1e comes back\n", worst);
    assert_true(worst <= 1e-9);
}

/* ---- wind and pressure ------------------------------------------------------------------------------------------- */

/* Steps a basin whose waves are stopped until it rests. With lambda = 1/2 the trapezoidal rule turns short waves round
 * in a long step and hardly lets drag at them: here the slowest lose a factor of 40 in 1000 steps. */
static void settle(cd_water* w, const struct way* way) {
    const double dt = basin_is_explicit(way) ? 0.02 : 0.5;
    ok(cd_water_set_drag(w, 1));
    for (int s = 0; s < (basin_is_explicit(way) ? 20000 : 8000); ++s) basin_step(w, dt, 1);
}

/* The surface leans by a / g; at its low end the basin falls dry. */
static void wind_heaps_up_water_by_a_over_g(void** state) {
    (void)state;
    enum { N = 16 };
    for (size_t k = 0; k < WAYS; ++k)
        for (int along_y = 0; along_y < 2; ++along_y)
            for (int dry = 0; dry < 2; ++dry) {
                double values[N + 1];
                cd_water* w = line_basin(along_y, N, 3, 0.5, CD_FLOAT64);
                basin_set_way(w, &ways[k]);
                for (size_t i = 0; i < N; ++i) values[i] = dry ? 0.1 : 1;
                line_write(w, along_y, CD_DEPTH, values);
                ok(cd_water_enable_field(w, line_field(along_y, CD_FORCE_X)));
                for (size_t i = 0; i <= N; ++i) values[i] = 0.5;
                line_write(w, along_y, CD_FORCE_X, values);
                settle(w, &ways[k]);
                const double step = 0.5 / gravity * 0.5,
                             tolerance = dry ? 1e-5 : 1e-7; /* films run down to the water */
                if (!dry) assert_true(basin_kinetic(w) < 1e-12);
                line_read(w, along_y, CD_DEPTH, 1e-7, values);
                for (size_t i = 1; i < N; ++i) {
                    if (values[i - 1] > 1e-9) assert_near(values[i] - values[i - 1], step, tolerance, 1);
                    else assert_true(values[i] <= step + tolerance);
                }
                if (dry) assert_true(values[0] < 1e-30);
                cd_water_destroy(w);
            }
}

/* surface + pressure / (density g) becomes level. */
static void water_stands_lower_where_air_presses(void** state) {
    (void)state;
    enum { N = 10 };
    for (size_t k = 0; k < WAYS; ++k) {
        double press[N * N], depth[N * N], most = -INFINITY, least = INFINITY;
        uint64_t seed = 12;
        cd_water* w = basin(N, N, 0.5, 0.7, CD_FLOAT64);
        basin_set_way(w, &ways[k]);
        ok(cd_water_set_density(w, 800));
        basin_random_bed(w, 1, 1, 4);
        for (size_t c = 0; c < N * N; ++c) press[c] = 2000 * random_number(&seed), depth[c] = 2;
        basin_write(w, CD_SURFACE, depth);
        ok(cd_water_enable_field(w, CD_PRESSURE));
        basin_write(w, CD_PRESSURE, press);
        settle(w, &ways[k]);
        assert_true(basin_largest(w, CD_VELOCITY_X) < 1e-8);
        assert_true(basin_largest(w, CD_VELOCITY_Y) < 1e-8);
        basin_read(w, CD_SURFACE, depth);
        for (size_t c = 0; c < N * N; ++c) {
            const double head = depth[c] + press[c] / (800 * gravity);
            most = fmax(most, head), least = fmin(least, head);
        }
        assert_near(most, least, 1e-8, 0);
        cd_water_destroy(w);
    }
}

/* ---- a bed that moves -------------------------------------------------------------------------------------------- */

/* A piece of sea floor rises: the surface with it, at once; then the hump runs apart in two of half its height. */
static void a_lifted_bed_sends_out_two_waves(void** state) {
    (void)state;
    enum { N = 400 };
    const double deep = 100, dx = 10, c = sqrt(gravity * deep), height = 1e-3;
    for (size_t k = 0; k < WAYS; ++k) {
        double bed[N], d[N], high = 0, middle;
        cd_water* w = basin(N, 1, dx, dx, CD_FLOAT64);
        basin_set_way(w, &ways[k]);
        for (size_t i = 0; i < N; ++i) bed[i] = -deep;
        basin_write(w, CD_BED, bed);
        for (size_t i = 0; i < N; ++i) d[i] = deep;
        basin_write(w, CD_DEPTH, d);
        for (size_t i = 0; i < N; ++i)
            bed[i] += height * exp(-pow(((double)i + 0.5) * dx - 2000, 2) / (2 * 150.0 * 150));
        const double volume = basin_volume(w);
        basin_write(w, CD_BED, bed);
        assert_true(basin_volume(w) == volume);
        assert_near(basin_get(w, CD_SURFACE, N / 2, 0), bed[N / 2] + deep, 1e-13, deep);
        const double dt = 0.5 * dx / c;
        for (int s = 0; s < 240; ++s) basin_step(w, dt, 1); /* 1200 m */
        basin_read(w, CD_SURFACE, d);
        size_t at = 0;
        for (size_t i = N / 2; i < N; ++i)
            if (d[i] > high) high = d[i], at = i;
        middle = d[N / 2];
        print_message("%-17s the wave is %.4f of the lift high, %.4f at %.4f of its way\n", ways[k].name, high / height,
                      middle / height, (((double)at + 0.5) * dx - 2000) / 1200);
        assert_near(high / height, 0.5, ways[k].lambda == 1 ? 0.3 : 0.05, 0);
        assert_near(((double)at + 0.5) * dx - 2000, 1200, 0.02, 0);
        assert_true(fabs(middle) < 1e-3 * height);
        assert_true(basin_volume_off(w) <= 1e-14);
        cd_water_destroy(w);
    }
}

/* A write that keeps the surface lets water in or out instead, and the account tells how much, of each write. */
static void a_bed_that_keeps_the_surface_is_in_the_account(void** state) {
    (void)state;
    enum { N = 9 };
    double in, out, initial, error, low = 0, high = 0;
    cd_water* w = basin(N, 1, 2, 3, CD_FLOAT64);
    uint64_t seed = 9;
    double bed[N], surface[N], after[N];
    basin_random_bed(w, 1, 0, 4);
    for (size_t i = 0; i < N; ++i) surface[i] = 0.6;
    basin_write(w, CD_SURFACE, surface);
    basin_read(w, CD_SURFACE, surface);
    basin_read(w, CD_BED, bed);
    ok(cd_water_set_bed_rule(w, CD_BED_KEEPS_SURFACE));
    for (size_t i = 0; i < N; ++i) {
        const double before = fmax(0, surface[i] - bed[i]), was = bed[i];
        bed[i] += 0.4 * random_number(&seed);
        const double now = surface[i] > was ? fmax(0, surface[i] - bed[i]) : 0;
        *(now > before ? &high : &low) += fabs(now - before) * 6;
        basin_set(w, CD_BED, i, 0, bed[i]);
    }
    basin_read(w, CD_SURFACE, after);
    for (size_t i = 0; i < N; ++i)
        if (basin_get(w, CD_DEPTH, i, 0) > 0) assert_near(after[i], surface[i], 1e-15, 1);
    ok(cd_water_get_account(w, &initial, &in, &out, &error));
    assert_near(in, high, 1e-13, 1);
    assert_near(out, low, 1e-13, 1);
    assert_true(in > 0 && out > 0 && fabs(error) <= 1e-13);
    cd_water_destroy(w);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(water_settles_at_mannings_speed),
        cmocka_unit_test(what_runs_slantwise_settles_at_mannings_speed),
        cmocka_unit_test(a_river_has_its_depths),
        cmocka_unit_test(a_stream_runs_down_a_slope_at_mannings_speed),
        cmocka_unit_test(drag_stops_water_as_it_says),
        cmocka_unit_test(what_friction_has_taken_does_not_come_back),
        cmocka_unit_test(wind_heaps_up_water_by_a_over_g),
        cmocka_unit_test(water_stands_lower_where_air_presses),
        cmocka_unit_test(a_lifted_bed_sends_out_two_waves),
        cmocka_unit_test(a_bed_that_keeps_the_surface_is_in_the_account),
    };
    return cmocka_run_group_tests_name("water forces", tests, NULL, NULL);
}
