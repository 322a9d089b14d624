/* Thacker's planar oscillation (1981): water that rocks to and fro in a parabola or a paraboloid with a plane surface,
 * its velocity the same everywhere and its shores running up and down. Exact in both modes of momentum. */
#include <math.h>
#include <stdlib.h>

#include "basin.h"
#include "check.h"
#include "modes.h"

static const double gravity = 9.81, curve = 0.25, slope = 0.2, half_width = 3;
static double omega(void) { return sqrt(2 * gravity * curve); }

struct canal {
    size_t steps;
    double error, volume_off; /* L1 of the depth and what was made of water, over the volume */
    uint64_t limited;
    double held_back;
};

/* Three periods, dt in units of dx / sqrt(g). Velocity and depth at the end, along the line. */
static struct canal rock(const struct way* way, int along_y, size_t n, size_t across, double step, double* out_depth) {
    const double dx = 2 * half_width / (double)n, dt = step * dx / sqrt(gravity), w = omega();
    const struct canal empty = {(size_t)lround(3 * 2 * (double)PI / w / dt), 0, 0, 0, 0};
    struct canal c = empty;
    cd_water* water = line_basin(along_y, n, across, dx, CD_FLOAT64);
    double* values = calloc(n, sizeof *values);
    assert_non_null(values);
    basin_set_way(water, way);
    ok(cd_water_set_first(water, along_y));
    for (size_t i = 0; i < n; ++i) values[i] = curve * pow(((double)i + 0.5) * dx - half_width, 2);
    line_write(water, along_y, CD_BED, values);
    const double lift = gravity * slope * slope / (4 * w * w);
    for (size_t i = 0; i < n; ++i) values[i] = 1 - lift + slope * (((double)i + 0.5) * dx - half_width);
    line_write(water, along_y, CD_SURFACE, values);
    const double start = basin_volume(water), time = (double)c.steps * dt;
    for (size_t k = 0; k < c.steps; ++k) {
        uint64_t limited;
        double held_back;
        ok(cd_water_step(water, dt, 1));
        ok(cd_water_get_limited(water, &limited, &held_back));
        c.limited += limited, c.held_back += held_back;
    }
    c.volume_off = fabs(basin_volume(water) / start - 1);
    line_read(water, along_y, CD_DEPTH, 0, values);
    double off = 0, all = 0;
    for (size_t i = 0; i < n; ++i) {
        const double x = ((double)i + 0.5) * dx - half_width, bed = curve * x * x;
        const double d = fmax(0, 1 - lift * cos(2 * w * time) + slope * x * cos(w * time) - bed);
        off += fabs(values[i] - d), all += d;
        if (out_depth) out_depth[i] = values[i];
    }
    c.error = off / all;
    free(values);
    cd_water_destroy(water);
    return c;
}

/* What each way comes to; a little above what was measured. */
static void water_rocks_in_a_parabola(void** state) {
    (void)state;
    static const struct {
        int way;
        size_t n;
        double step, most;
    } rows[] = {
        {LINEAR, 100, 0.5, 3.3e-2},   {LINEAR, 200, 0.5, 2.3e-2},     {LINEAR, 400, 0.5, 1.8e-2},
        {LINEAR, 200, 2, 2.9e-2},     {LINEAR_ONE, 100, 0.5, 7.8e-2}, {LINEAR_ONE, 200, 0.5, 4.8e-2},
        {LINEAR_ONE, 400, 0.5, 3e-2}, {ADVECTED, 100, 0.5, 8.5e-4},   {ADVECTED, 200, 0.5, 4.2e-4},
        {ADVECTED, 400, 0.5, 9.1e-5}, {ADVECTED, 100, 2, 1.2e-3},     {ADVECTED, 200, 2, 4.5e-4},
        {ADVECTED, 400, 2, 1.4e-4},   {ADVECTED, 200, 8, 7.0e-4},     {ADVECTED, 400, 8, 2.5e-4},
        {ADVECTED, 200, 16, 1.2e-3},  {EXPLICIT, 200, 0.4, 4.0e-2},   {EXPLICIT_ADVECTED, 200, 0.4, 5.0e-4},
    };
    for (size_t r = 0; r < COUNT(rows); ++r) {
        const struct way* way = &ways[rows[r].way];
        const struct canal c = rock(way, 0, rows[r].n, 1, rows[r].step, NULL);
        print_message("%-17s %zu cells, step %-3g: %5zu steps, L1 %.2e (at most %.1e), volume off %.0e, limited %zu\n",
                      way->name, rows[r].n, rows[r].step, c.steps, c.error, rows[r].most, c.volume_off,
                      (size_t)c.limited);
        assert_true(c.error <= rows[r].most);
        assert_true(c.volume_off <= 1e-14);
    }
}

/* From 100 to 400 cells. */
static void advected_momentum_is_of_second_order_on_a_moving_shore(void** state) {
    (void)state;
    const double coarse = rock(&ways[ADVECTED], 0, 100, 1, 0.5, NULL).error;
    const double fine = rock(&ways[ADVECTED], 0, 400, 1, 0.5, NULL).error;
    const double order = log2(coarse / fine) / 2;
    print_message("order %.2f\n", order);
    assert_true(order > 1.6);
}

/* To the bit, with the other axis as narrow or wider. */
static void a_trough_along_y_rocks_like_one_along_x(void** state) {
    (void)state;
    for (size_t k = 0; k < WAYS; ++k) {
        enum { N = 60 };
        double depth[4][N];
        const double step = basin_is_explicit(&ways[k]) ? 0.4 : 1;
        rock(&ways[k], 0, N, 1, step, depth[0]);
        rock(&ways[k], 1, N, 1, step, depth[1]);
        rock(&ways[k], 0, N, 9, step, depth[2]);
        rock(&ways[k], 1, N, 9, step, depth[3]);
        for (int other = 1; other < 4; ++other) assert_same_bits(depth[0], depth[other], N);
    }
}

/* ---- a bowl ------------------------------------------------------------------------------------------------------ */

static double bowl_bed(double x, double y, const void* user) {
    (void)user;
    return curve * (pow(x - half_width, 2) + pow(y - half_width, 2));
}
/* The surface leans towards an angle that goes round. */
static double bowl_surface(double x, double y, const void* angle) {
    const double a = *(const double*)angle;
    return 1 - slope * slope / (4 * curve) + slope * ((x - half_width) * cos(a) + (y - half_width) * sin(a));
}

/* L1 of the depth over the volume after a period. */
static double whirl(const struct way* way, size_t n, double step) {
    const double dx = 2 * half_width / (double)n, dt = step * dx / sqrt(gravity), w = omega();
    const size_t steps = (size_t)lround(2 * (double)PI / w / dt);
    const double speed = gravity * slope / w;
    double angle = 0, off = 0, all = 0;
    cd_water* water = basin(n, n, dx, dx, CD_FLOAT64);
    basin_set_way(water, way);
    basin_fill(water, CD_BED, bowl_bed, NULL);
    basin_fill(water, CD_SURFACE, bowl_surface, &angle);
    for (size_t i = 0; i < n; ++i)
        for (size_t j = 1; j < n; ++j)
            if (basin_get(water, CD_DEPTH, i, j) > 0 || basin_get(water, CD_DEPTH, i, j - 1) > 0)
                basin_set(water, CD_VELOCITY_Y, i, j, speed);
    const double start = basin_volume(water);
    for (size_t k = 0; k < steps; ++k) basin_step(water, dt, 1);
    assert_near(basin_volume(water), start, 1e-13, 0);
    angle = w * (double)steps * dt;
    for (size_t j = 0; j < n; ++j)
        for (size_t i = 0; i < n; ++i) {
            const double x = ((double)i + 0.5) * dx, y = ((double)j + 0.5) * dx;
            const double d = fmax(0, bowl_surface(x, y, &angle) - bowl_bed(x, y, NULL));
            off += fabs(basin_get(water, CD_DEPTH, i, j) - d), all += d;
        }
    cd_water_destroy(water);
    return off / all;
}

static void water_goes_round_in_a_bowl(void** state) {
    (void)state;
    static const struct {
        int way;
        size_t n;
        double step, most;
    } rows[] = {
        {LINEAR, 50, 0.5, 6.2e-02},    {LINEAR, 100, 0.5, 4.9e-02},           {ADVECTED, 50, 0.5, 5.0e-03},
        {ADVECTED, 100, 0.5, 1.4e-03}, {ADVECTED, 200, 0.5, 4.1e-04},         {ADVECTED, 100, 2, 2.4e-03},
        {EXPLICIT, 50, 0.3, 8.8e-02},  {EXPLICIT_ADVECTED, 50, 0.3, 5.6e-03}, {EXPLICIT_ADVECTED, 100, 0.3, 1.77e-03},
    };
    for (size_t r = 0; r < COUNT(rows); ++r) {
        const double error = whirl(&ways[rows[r].way], rows[r].n, rows[r].step);
        print_message("%-17s %zu x %zu cells, step %-3g: L1 %.2e\n", ways[rows[r].way].name, rows[r].n, rows[r].n,
                      rows[r].step, error);
        assert_true(error <= rows[r].most);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(water_rocks_in_a_parabola),
        cmocka_unit_test(advected_momentum_is_of_second_order_on_a_moving_shore),
        cmocka_unit_test(a_trough_along_y_rocks_like_one_along_x),
        cmocka_unit_test(water_goes_round_in_a_bowl),
    };
    return cmocka_run_group_tests_name("water Thacker", tests, NULL, NULL);
}
