/* Small waves on a current that goes on for ever: they do not grow. */
#include <math.h>

#include "basin.h"
#include "check.h"
#include "reference.h"

enum { N = 24 };

/* The largest height over many steps, over that of the start. waves, along, across: how many cells waves, and the
 * current, cross in a step. */
static double growth(const struct way* way, double waves, double along, double across, int steps) {
    const double height = 1e-9, dt = waves / sqrt(9.81);
    uint64_t seed = 7;
    double start = 0, most = 0, depth[N * N];
    cd_water* w = basin(N, N, 1, 1, CD_FLOAT64);
    basin_set_way(w, way);
    ok(cd_water_set_side(w, CD_SIDE_X_FIRST, CD_BORDER_PERIODIC, 0, 0));
    ok(cd_water_set_side(w, CD_SIDE_Y_FIRST, CD_BORDER_PERIODIC, 0, 0));
    for (size_t k = 0; k < N * N; ++k) depth[k] = 1 + height * random_number(&seed);
    basin_write(w, CD_DEPTH, depth);
    for (size_t j = 0; j < N; ++j)
        for (size_t i = 0; i < N; ++i) {
            basin_set(w, CD_VELOCITY_X, i, j, along / dt);
            basin_set(w, CD_VELOCITY_Y, i, j, across / dt);
        }
    for (size_t k = 0; k < N * N; ++k) start = fmax(start, fabs(depth[k] - 1));
    for (int s = 0; s < steps && most < 1e6 * start; ++s) {
        basin_step(w, dt, 1);
        basin_read(w, CD_DEPTH, depth);
        for (size_t k = 0; k < N * N; ++k) most = fmax(most, fabs(depth[k] - 1));
    }
    cd_water_destroy(w);
    return most / start;
}

static void small_waves_do_not_grow_on_a_current(void** state) {
    (void)state;
    static const double waves[] = {0.1, 0.2, 0.4, 0.6};
    static const double currents[][2] = {{0.05, 0}, {0, 0.2}, {0.05, -0.05}, {0.2, 0.1}};
    for (size_t k = 0; k < WAYS; ++k) {
        /* whose flow does not know yet what the momentum carried across will make of it */
        const size_t count = k == EXPLICIT_ADVECTED ? 2 : COUNT(waves);
        double worst = 0;
        for (size_t c = 0; c < count; ++c)
            for (size_t u = 0; u < COUNT(currents); ++u)
                worst = fmax(worst, growth(&ways[k], waves[c], currents[u][0], currents[u][1], 1000));
        print_message("%-17s %.2f times as high at most\n", ways[k].name, worst);
        assert_true(worst < 2.5);
    }
}

static void nor_on_a_stream_that_runs_further_than_a_cell_in_a_step(void** state) {
    (void)state;
    static const int which[] = {LINEAR, LINEAR_HALF, LINEAR_ONE, ADVECTED, LARGE_2};
    static const double waves[] = {0.4, 0.8, 3, 12, 100}, runs[] = {1.5, 3, 30};
    for (size_t k = 0; k < COUNT(which); ++k) {
        const size_t count = ways[which[k]].momentum == CD_MOMENTUM_LINEAR ? 2 : COUNT(waves);
        double worst = 0;
        for (size_t c = 0; c < count; ++c)
            for (size_t u = 0; u < COUNT(runs); ++u)
                worst = fmax(worst, growth(&ways[which[k]], waves[c], runs[u], 0, 1000));
        print_message("%-17s %.2f times as high at most\n", ways[which[k]].name, worst);
        assert_true(worst < 2.5);
    }
}

/* Coupled steps look ahead with the velocities before the step, since their system has to be symmetric: they want
 * lambda above 1/2, and a slower current. */
static void nor_where_waves_cross_many_cells(void** state) {
    (void)state;
    static const double waves[] = {2.6, 5, 12, 100};
    static const double currents[][2] = {{0.05, 0}, {0, 0.2}, {0.05, -0.05}, {0.2, 0.1}, {0.5, -0.4}, {0.9, 0.9}};
    for (size_t k = 0; k < WAYS; ++k) {
        if (basin_is_explicit(&ways[k])) continue;
        struct way way = ways[k];
        const int coupled = way.solver == CD_SOLVER_COUPLED;
        if (coupled) way.lambda = 0.55;
        double worst = 0;
        for (size_t c = 0; c < COUNT(waves); ++c)
            for (size_t u = 0; u < (coupled ? 4 : COUNT(currents)); ++u)
                worst = fmax(worst, growth(&way, waves[c], currents[u][0], currents[u][1], 1000));
        print_message("%-17s %.2f times as high at most\n", way.name, worst);
        assert_true(worst < 2.5);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(small_waves_do_not_grow_on_a_current),
        cmocka_unit_test(nor_on_a_stream_that_runs_further_than_a_cell_in_a_step),
        cmocka_unit_test(nor_where_waves_cross_many_cells),
    };
    return cmocka_run_group_tests_name("water currents", tests, NULL, NULL);
}
