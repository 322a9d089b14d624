/* Small waves of the continuum: their speed, how they grow towards shores, what a step of the bed sends back, how they
 * turn when they come in aslant. Each is closer on a finer mesh. */
#include <complex.h>
#include <math.h>
#include <stdlib.h>

#include "basin.h"
#include "check.h"
#include "modes.h"

static const double gravity = 9.81;

/* A hump that runs along the line towards its end, from x = `from`. */
static void launch(cd_water* w, int along_y, size_t n, double dx, double from, double width, double height,
                   double depth) {
    double* values = calloc(n + 1, sizeof *values);
    assert_non_null(values);
    line_read(w, along_y, CD_SURFACE, INFINITY, values);
    for (size_t i = 0; i < n; ++i) values[i] += height * exp(-pow((((double)i + 0.5) * dx - from) / width, 2) / 2);
    line_write(w, along_y, CD_SURFACE, values);
    for (size_t i = 0; i <= n; ++i)
        values[i] = sqrt(gravity / depth) * height * exp(-pow(((double)i * dx - from) / width, 2) / 2);
    values[0] = values[n] = 0;
    line_write(w, along_y, CD_VELOCITY_X, values);
    free(values);
}

/* Fastest and slowest first: linear 0.55 damps short waves. */
static const int kinds[] = {LINEAR, LINEAR_HALF, ADVECTED, EXPLICIT, EXPLICIT_ADVECTED};

/* ---- speed ------------------------------------------------------------------------------------------------------- */

struct travel {
    double speed, shape; /* over sqrt(g d); L1 from the hump shifted, over its own */
};

static struct travel travel(const struct way* way, int along_y, size_t n) {
    const double length = 4e5, depth = 4000, dx = length / (double)n, from = 1e5, width = 2e4, height = 1e-3;
    const double c = sqrt(gravity * depth), time = 2e5 / c;
    const size_t steps = n / 2;
    double* d = calloc(n + 1, sizeof *d);
    assert_non_null(d);
    cd_water* w = line_basin(along_y, n, 2, dx, CD_FLOAT64);
    basin_set_way(w, way);
    for (size_t i = 0; i < n; ++i) d[i] = depth;
    line_write(w, along_y, CD_DEPTH, d);
    launch(w, along_y, n, dx, from, width, height, depth);
    for (size_t k = 0; k < steps; ++k) basin_step(w, time / (double)steps, 1);
    line_read(w, along_y, CD_DEPTH, 1e-9, d);
    double sum = 0, moment = 0, off = 0;
    for (size_t i = 0; i < n; ++i) {
        const double x = ((double)i + 0.5) * dx, hump = exp(-pow((x - from - c * time) / width, 2) / 2);
        sum += d[i] - depth, moment += x * (d[i] - depth), off += fabs((d[i] - depth) / height - hump);
    }
    const struct travel t = {(moment / sum - from) / time / c, off * dx / (width * sqrt(2 * (double)PI))};
    free(d);
    cd_water_destroy(w);
    return t;
}

static void waves_run_with_the_root_of_g_d(void** state) {
    (void)state;
    for (size_t k = 0; k < COUNT(kinds); ++k) {
        const int exact = ways[kinds[k]].lambda == 0.5 && !basin_is_explicit(&ways[kinds[k]]);
        struct travel before = {0, 0};
        for (size_t n = 100; n <= 400; n *= 2) {
            const struct travel t = travel(&ways[kinds[k]], n == 200, n);
            print_message("%-17s %zu cells: speed x %.6f, hump off by %.1e\n", ways[kinds[k]].name, n, t.speed,
                          t.shape);
            /* explicit: velocities are those of half a step before */
            assert_near(t.speed, 1, basin_is_explicit(&ways[kinds[k]]) ? 1.1 / (double)n : 1e-4, 0);
            if (n > 100) assert_true(t.shape < (exact ? 0.3 : 0.6) * before.shape);
            before = t;
        }
    }
}

/* ---- Green's law ------------------------------------------------------------------------------------------------- */

/* How much higher a hump is after the depth has fallen from 4000 m to 250 m over 800 km: 16^(1/4) = 2. */
static double shoaling(const struct way* way, size_t n) {
    const double length = 1.2e6, dx = length / (double)n, height = 1e-3;
    double* bed = calloc(n + 1, sizeof *bed);
    assert_non_null(bed);
    cd_water* w = line_basin(0, n, 1, dx, CD_FLOAT64);
    basin_set_way(w, way);
    for (size_t i = 0; i < n; ++i) bed[i] = -4000 + 3750 * fmin(1, fmax(0, (((double)i + 0.5) * dx - 2.5e5) / 8e5));
    line_write(w, 0, CD_BED, bed);
    for (size_t i = 0; i < n; ++i) bed[i] = 0;
    line_write(w, 0, CD_SURFACE, bed);
    launch(w, 0, n, dx, 1.2e5, 2e4, height, 4000);
    double highest = 0;
    const double dt = 0.7 * dx / sqrt(gravity * 4000);
    /* 130 km at 198 m/s, the slope at 2 * 800 km / (198 + 49.5) m/s, then 60 km at 49.5 m/s */
    const double time =
        1.3e5 / sqrt(gravity * 4000) + 1.6e6 / (1.25 * sqrt(gravity * 4000)) + 6e4 / sqrt(gravity * 250);
    basin_step(w, dt, (size_t)lround(time / dt));
    line_read(w, 0, CD_SURFACE, 0, bed);
    for (size_t i = 0; i < n; ++i)
        if ((double)i * dx > 1.05e6) highest = fmax(highest, bed[i]);
    free(bed);
    cd_water_destroy(w);
    return highest / height;
}

static void waves_grow_towards_the_shore_as_green_says(void** state) {
    (void)state;
    static const int which[] = {LINEAR_HALF, ADVECTED, EXPLICIT};
    for (size_t k = 0; k < COUNT(which); ++k) {
        double before = 0;
        for (size_t n = 600; n <= 2400; n *= 2) {
            const double rise = shoaling(&ways[which[k]], n);
            print_message("%-17s %zu cells: the hump is %.4f times as high\n", ways[which[k]].name, n, rise);
            assert_near(rise, 2, n == 600 ? 0.09 : n == 1200 ? 0.02 : 0.008, 0);
            assert_true(fabs(rise - 2) < fabs(before - 2));
            before = rise;
        }
    }
}

/* ---- a step of the bed ------------------------------------------------------------------------------------------- */

struct parts {
    double on, back;
};

static struct parts over_a_step(const struct way* way, int along_y, size_t n, double d1, double d2) {
    const double dx = 100.0 / (double)n, height = 1e-4;
    const double c1 = sqrt(gravity * d1), c2 = sqrt(gravity * d2);
    double* h = calloc(n + 1, sizeof *h);
    assert_non_null(h);
    cd_water* w = line_basin(along_y, n, 1, dx, CD_FLOAT64);
    basin_set_way(w, way);
    for (size_t i = 0; i < n; ++i) h[i] = i < n / 2 ? -d1 : -d2;
    line_write(w, along_y, CD_BED, h);
    for (size_t i = 0; i < n; ++i) h[i] = 0;
    line_write(w, along_y, CD_SURFACE, h);
    launch(w, along_y, n, dx, 30, 3, height, d1);
    const double dt = 0.5 * dx / fmax(c1, c2), time = 20 / c1 + 20 / fmax(c1, c2);
    basin_step(w, dt, (size_t)lround(time / dt));
    line_read(w, along_y, CD_SURFACE, 0, h);
    struct parts p = {0, 0};
    for (size_t i = 0; i < n; ++i) {
        double* const side = i < n / 2 ? &p.back : &p.on;
        if (fabs(h[i] / height) > fabs(*side)) *side = h[i] / height;
    }
    free(h);
    cd_water_destroy(w);
    return p;
}

static void a_step_of_the_bed_splits_a_wave(void** state) {
    (void)state;
    static const double depths[][2] = {{4, 1}, {1, 4}, {2, 1.5}};
    for (size_t k = 0; k < COUNT(kinds); ++k)
        for (size_t d = 0; d < COUNT(depths); ++d) {
            const double root = sqrt(depths[d][1] / depths[d][0]), on = 2 / (1 + root), back = (1 - root) / (1 + root);
            double before = INFINITY;
            for (size_t n = 200; n <= 800; n *= 2) {
                const struct parts p = over_a_step(&ways[kinds[k]], n == 400, n, depths[d][0], depths[d][1]);
                const double off = fmax(fabs(p.on - on), fabs(p.back - back));
                if (d == 0)
                    print_message("%-17s %zu cells: %.4f goes on, %+.4f comes back (%.4f, %+.4f)\n",
                                  ways[kinds[k]].name, n, p.on, p.back, on, back);
                assert_true(off < (ways[kinds[k]].lambda > 0.5 ? 16 : 2.5) / (double)n);
                assert_true(off < before);
                before = off;
            }
        }
}

/* ---- refraction -------------------------------------------------------------------------------------------------- */

struct packet {
    double middle, width, kx, ky, u;
};
static double packet_depth(double x, double y, const void* user) {
    const struct packet* p = user;
    const double envelope = exp(-pow((x - p->middle) / p->width, 2) / 2);
    return (x < 80 ? 4 : 1) + 1e-5 * envelope * cos(p->kx * x + p->ky * y);
}
static double packet_velocity(double x, double y, const void* user) {
    const struct packet* p = user;
    const double envelope = exp(-pow((x - p->middle) / p->width, 2) / 2);
    return envelope < 1e-9 ? 0 : p->u * 1e-5 * envelope * cos(p->kx * x + p->ky * y);
}
static double step_bed(double x, double y, const void* user) {
    (void)y, (void)user;
    return x < 80 ? -4 : -1;
}

/* sin(angle) of the wave on the shallow side, whose fronts met the step at 45 degrees. */
static double bent(const struct way* way, size_t rows) {
    const double width = 10, dx = width / (double)rows, c1 = sqrt(gravity * 4);
    const size_t nx = 16 * rows;
    struct packet p = {40, 12, 2 * (double)PI / width, 2 * (double)PI / width, 0};
    cd_water* w = basin(nx, rows, dx, dx, CD_FLOAT64);
    basin_set_way(w, way);
    ok(cd_water_set_side(w, CD_SIDE_Y_FIRST, CD_BORDER_PERIODIC, 0, 0));
    ok(cd_water_set_side(w, CD_SIDE_X_FIRST, CD_BORDER_OPEN, 0, 0));
    basin_fill(w, CD_BED, step_bed, NULL);
    basin_fill(w, CD_DEPTH, packet_depth, &p);
    p.u = sqrt(gravity / 4) * sqrt(0.5);
    for (int axis = 0; axis < 2; ++axis) basin_fill(w, axis ? CD_VELOCITY_Y : CD_VELOCITY_X, packet_velocity, &p);
    for (size_t j = 0; j < rows; ++j) basin_set(w, CD_VELOCITY_X, nx, j, 0);
    const double dt = 0.4 * dx / c1;
    basin_step(w, dt, (size_t)lround(19 / dt));
    double complex turn = 0, last = 0;
    for (size_t i = 0; i < nx; ++i) {
        double complex a = 0;
        for (size_t j = 0; j < rows; ++j)
            a += basin_get(w, CD_SURFACE, i, j) * cexp(-I * p.ky * ((double)j + 0.5) * dx);
        if ((double)i * dx > 85) turn += conj(last) * a;
        last = a;
    }
    const double kx = carg(turn) / dx;
    cd_water_destroy(w);
    return p.ky / hypot(kx, p.ky);
}

static void waves_turn_towards_shallow_water_as_snell_says(void** state) {
    (void)state;
    static const int which[] = {LINEAR_HALF, ADVECTED, EXPLICIT};
    const double expected = sqrt(0.5) * sqrt(1.0 / 4);
    for (size_t k = 0; k < COUNT(which); ++k) {
        double before = INFINITY;
        for (size_t rows = 16; rows <= 32; rows *= 2) {
            const double sine = bent(&ways[which[k]], rows);
            print_message("%-17s %zu cells per wave's width: sin %.5f of %.5f\n", ways[which[k]].name, rows, sine,
                          expected);

            assert_near(sine, expected, rows == 16 ? 0.045 : 0.012, 0);
            assert_true(fabs(sine - expected) < 0.3 * before);
            before = fabs(sine - expected);
        }
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(waves_run_with_the_root_of_g_d),
        cmocka_unit_test(waves_grow_towards_the_shore_as_green_says),
        cmocka_unit_test(a_step_of_the_bed_splits_a_wave),
        cmocka_unit_test(waves_turn_towards_shallow_water_as_snell_says),
    };
    return cmocka_run_group_tests_name("water waves", tests, NULL, NULL);
}
