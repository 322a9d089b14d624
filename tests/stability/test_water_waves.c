/* Waves on a pool that nothing feeds, pushes or drains, and water that falls into it, gain no energy but what the header
 * says. */
#include <math.h>

#include "basin.h"
#include "check.h"
#include "modes.h"
#include "reference.h"

/* How much energy a pool that swings from rest ever has, over what it started with; height: of the depth, a metre. */
static double swing(const struct way* way, double height, double courant, int steps) {
    enum { CELLS_LONG = 40 };
    cd_water* w = basin(CELLS_LONG, 1, 1, 1, CD_FLOAT64);
    double depth[CELLS_LONG], most = 0;
    basin_set_way(w, way);
    for (size_t i = 0; i < CELLS_LONG; ++i) depth[i] = 1;
    basin_write(w, CD_DEPTH, depth);
    const double level = basin_energy(w);
    for (size_t i = 0; i < CELLS_LONG; ++i) depth[i] = 1 + height * cos((double)PI * ((double)i + 0.5) / CELLS_LONG);
    basin_write(w, CD_DEPTH, depth);
    const double start = basin_energy(w) - level;
    for (int k = 0; k < steps; ++k) {
        basin_step(w, courant / sqrt(9.81), 1);
        most = fmax(most, (basin_energy(w) - level) / start);
    }
    cd_water_destroy(w);
    return most;
}

static void a_seiche_from_rest_gains_no_energy(void** state) {
    (void)state;
    static const double heights[] = {0.05, 0.1, 0.2, 0.3}, courants[] = {0.5, 1, 2, 4, 8, 16, 32};
    const struct way half_or_more = {"linear 0.51", CD_METHOD_IMPLICIT, CD_MOMENTUM_LINEAR, 0.51};
    const struct way* const which[] = {&ways[LINEAR_HALF], &half_or_more, &ways[LINEAR], &ways[ADVECTED]};
    for (size_t k = 0; k < COUNT(which); ++k) {
        double most = 0;
        for (size_t h = 0; h < COUNT(heights); ++h)
            for (size_t c = 0; c < COUNT(courants); ++c)
                most = fmax(most, swing(which[k], heights[h], courants[c], 2000));
        print_message("%-17s seiches: at most %.4f of their energy\n", which[k]->name, most);
        assert_true(most <= (which[k] == &ways[LINEAR_HALF] ? 1.2 : which[k] == &ways[ADVECTED] ? 1 + 1e-7 : 1.02));
    }
}

/* Nor does a low one between a wall and a level that a side holds: it never stands higher than at first, nor do short
 * waves on it. */
static void a_seiche_beside_a_level_grows_no_higher(void** state) {
    (void)state;
    enum { CELLS_LONG = 25 };
    static const int which[] = {LINEAR_HALF, LINEAR, ADVECTED};
    static const double courants[] = {0.05, 0.25, 1, 2, 4, 8, 32}, height = 1e-4;
    for (size_t k = 0; k < COUNT(which); ++k)
        for (size_t c = 0; c < COUNT(courants); ++c) {
            double depth[CELLS_LONG], most = 0;
            cd_water* w = basin(CELLS_LONG, 1, 1, 1, CD_FLOAT64);
            basin_set_way(w, &ways[which[k]]);
            ok(cd_water_set_side(w, CD_SIDE_X_LAST, CD_BORDER_LEVEL, 1, 0));
            for (size_t i = 0; i < CELLS_LONG; ++i)
                depth[i] = 1 + height * cos((double)PI * ((double)i + 0.5) / (2 * CELLS_LONG));
            basin_write(w, CD_DEPTH, depth);
            for (int step = 0; step < 3000; ++step) {
                basin_step(w, courants[c] / sqrt(9.81), 1);
                basin_read(w, CD_DEPTH, depth);
                for (size_t i = 0; i < CELLS_LONG; ++i) most = fmax(most, fabs(depth[i] - 1) / height);
            }
            print_message("%-17s courant %4g: at most %.3f of its height\n", ways[which[k]].name, courants[c], most);
            assert_true(most < 1.01);
            cd_water_destroy(w);
        }
}

/* A hump spreads over a flat bed, along a line and in the plane: nothing comes back of the energy that steps took. */
static void a_hump_gains_no_energy(void** state) {
    (void)state;
    static const double courants[] = {0.5, 1, 4, 10, 40, 200};
    enum { CELLS_LONG = 96 };
    double back = 0, above = 0;
    for (size_t c = 0; c < COUNT(courants); ++c)
        for (int plane = 0; plane < 2; ++plane)
            for (int high = 0; high < 3; ++high) {
                const size_t ny = plane ? CELLS_LONG / 2 : 1;
                const double height = high == 0 ? 0.01 : high == 1 ? 0.1 : 0.4;
                cd_water* w = basin(CELLS_LONG, ny, 0.5, 0.5, CD_FLOAT64);
                basin_set_way(w, &ways[ADVECTED]);
                for (size_t k = 0; k < CELLS_LONG * ny; ++k) {
                    const double x = 0.5 * (double)(k % CELLS_LONG) - 8;
                    basin_set(w, CD_DEPTH, k % CELLS_LONG, k / CELLS_LONG, 1 + height * exp(-x * x / 8));
                }
                const double start = basin_energy(w), mean = basin_volume(w) / (0.25 * CELLS_LONG * (double)ny);
                const double wave = start - 500 * 9.81 * mean * basin_volume(w);
                double lowest = start;
                for (int step = 0; step < 150; ++step) {
                    basin_step(w, courants[c] * 0.5 / sqrt(9.81), 1);
                    const double now = basin_energy(w);
                    back = fmax(back, (now - lowest) / wave), above = fmax(above, (now - start) / wave);
                    lowest = fmin(lowest, now);
                }
                cd_water_destroy(w);
            }
    print_message("humps: %.1e of their energy comes back, %.1e above the start\n", back, above);
    assert_true(back <= 1e-9 && above <= 1e-12);
}

/* Nor do low waves round a ring over an uneven bed, of which a step that lost momentum made a current. The bed has two
 * hollows. */
static void waves_round_a_ring_gain_no_energy(void** state) {
    (void)state;
    enum { ROUND = 64 };
    static const double lambdas[] = {0.5, 0.55}, courants[] = {20, 45, 270};
    double gain[COUNT(lambdas)] = {0, 0};
    for (size_t k = 0; k < COUNT(lambdas); ++k)
        for (size_t c = 0; c < COUNT(courants); ++c) {
            cd_water* w = basin(ROUND, 1, 1, 1, CD_FLOAT64);
            basin_set_way(w, &ways[ADVECTED]);
            ok(cd_water_set_lambda(w, lambdas[k]));
            ok(cd_water_set_side(w, CD_SIDE_X_FIRST, CD_BORDER_PERIODIC, 0, 0));
            double surface[ROUND];
            for (size_t i = 0; i < ROUND; ++i) {
                basin_set(w, CD_BED, i, 0, i < 21 ? -0.1 : i >= 32 && i < 48 ? -0.05 : 0);
                surface[i] = 1;
            }
            basin_write(w, CD_SURFACE, surface);
            const double level = basin_energy(w);
            for (size_t i = 0; i < ROUND; ++i) surface[i] += 0.027 * cos(2 * (double)PI * (double)i / ROUND + 2.5);
            basin_write(w, CD_SURFACE, surface);
            const double start = basin_energy(w);
            for (int step = 0; step < 600; ++step) {
                basin_step(w, courants[c] / sqrt(9.81), 1);
                gain[k] = fmax(gain[k], (basin_energy(w) - start) / (start - level));
            }
            cd_water_destroy(w);
        }
    print_message("waves round a ring: %.1e of their energy gained, with lambda 0.55 %.1e\n", gain[0], gain[1]);
    assert_true(gain[0] <= 1e-12 && gain[1] <= 1e-12);
}

/* Between levels that are the same, over any bed, ripples die out, and waves make no current: energy comes in at a side
 * only with what flows out at another. Of a few scenes, most of some cells only, some grow slowly. */
static void nothing_moves_by_itself_between_levels(void** state) {
    (void)state;
    enum { SCENES = 160 };
    uint64_t seed = 11 + other_scenes();
    double worst = 0;
    int gaining = 0;
    for (int scene = 0; scene < SCENES; ++scene) {
        const size_t nx = 1 + (size_t)(6 + 6 * random_number(&seed)), ny = 1 + (size_t)(2 + 2 * random_number(&seed));
        const double rough = 0.4 + 0.4 * random_number(&seed), height = scene % 2 ? 0.15 : 5e-4;
        const int linear = scene % 5 < 2;
        const double lambda = (double[]){0.55, 1, 0.5}[scene % 3], longest = lambda > 0.5 ? 30 : 1;
        const double courant = 0.1 * pow(10 * longest, 0.5 + 0.5 * random_number(&seed));
        cd_water* w = basin(nx, ny, 1, 1, CD_FLOAT64);
        basin_set_way(w, &ways[ADVECTED]);
        if (linear) ok(cd_water_set_momentum(w, CD_MOMENTUM_LINEAR));
        ok(cd_water_set_lambda(w, lambda));
        for (cd_side side = CD_SIDE_X_FIRST; side <= CD_SIDE_Y_LAST; ++side)
            if (side == CD_SIDE_X_FIRST || random_number(&seed) < 0)
                ok(cd_water_set_side(w, side, CD_BORDER_LEVEL, 0, 0));
        double surface[12 * 4], start = 0, most = 0;
        for (size_t k = 0; k < nx * ny; ++k) {
            surface[k] = height * random_number(&seed), start += 500 * 9.81 * surface[k] * surface[k];
            basin_set(w, CD_BED, k % nx, k / nx, -1 + rough * (0.3 + 0.5 * random_number(&seed)));
        }
        basin_write(w, CD_SURFACE, surface);
        for (int step = 0; step < 1200; ++step) {
            double moving, potential, above = 0;
            basin_step(w, courant / sqrt(9.81), 1);
            ok(cd_water_get_energy(w, &moving, &potential));
            basin_read(w, CD_SURFACE, surface);
            for (size_t k = 0; k < nx * ny; ++k) above += 500 * 9.81 * surface[k] * surface[k];
            most = fmax(most, (moving + above) / start);
        }
        gaining += most > 1.3, worst = fmax(worst, most);
        cd_water_destroy(w);
    }
    print_message("between levels: %d of %d gain a third of their energy, at most %.3g times\n", gaining, SCENES,
                  worst);
    assert_true(gaining <= 4);
}

/* ---- falls ------------------------------------------------------------------------------------------------------- */

/* A film that springs up there runs down a slope and falls into a lake, which rises to the slope's foot: the lake stays
 * calm, and not even the film runs much faster than by the fall. */
static void a_film_does_not_throw_the_lake_that_it_falls_into(void** state) {
    (void)state;
    enum { N = 12 };
    static const int which[] = {ADVECTED, EXPLICIT_ADVECTED};
    static const double bed[N] = {1, 0.98, 0.96, 0.94, 0.92, 0.9, 0.55, 0.1, 0.1, 0.1, 0.1, 0.1};
    for (size_t k = 0; k < COUNT(which); ++k)
        for (int down = 0; down < 2; ++down) {
            cd_water* w = basin(N, 1, 1, 1, CD_FLOAT64);
            double fastest = 0, lake = 0, depth[N], b[N], u[N + 1], source[N] = {0};
            basin_set_way(w, &ways[which[k]]);
            for (size_t i = 0; i < N; ++i) {
                const size_t at = down ? N - 1 - i : i;
                b[at] = bed[i], depth[at] = bed[i] < 0.5 ? 0.445 : bed[i] < 0.6 ? 0 : 1e-6;
                source[at] = bed[i] < 0.5 ? 1e-4 : i == 0 ? 1e-7 : 0;
            }
            ok(cd_water_enable_field(w, CD_SOURCE));
            basin_write(w, CD_BED, b), basin_write(w, CD_DEPTH, depth), basin_write(w, CD_SOURCE, source);
            for (int s = 0; s < 4000; ++s) {
                basin_step(w, 0.03, 1);
                basin_read(w, CD_VELOCITY_X, u), basin_read(w, CD_DEPTH, depth);
                for (size_t i = 1; i < N; ++i) {
                    const size_t place = down ? N - i : i; /* of the face, from the top of the slope */
                    if (depth[i - 1] > 0 && depth[i] > 0 && depth[i - 1] + depth[i] > 1e-9)
                        fastest = fmax(fastest, fabs(u[i]));
                    if (place > 7) lake = fmax(lake, fabs(u[i]));
                }
            }
            print_message("%-17s fastest %.2f m/s, in the lake %.1e m/s\n", ways[which[k]].name, fastest, lake);
            assert_true(fastest <= 2 * sqrt(2 * 9.81 * 0.9));
            assert_true(lake <= 0.1);
            cd_water_destroy(w);
        }
}

/* A layer of water on a ledge falls into a lake below it, or a pit of one cell: only what falls is pushed by the fall,
 * and not the lake's water at the same face. */
static void water_that_falls_over_a_ledge_makes_no_energy(void** state) {
    (void)state;
    static const struct {
        double drop, film, depth;
        size_t ledge, lake;
    } falls[] = {{1, 0.1, 0.5, 4, 6}, {0.3, 0.05, 0.2, 10, 30}, {5, 1, 3, 10, 30}, {0.1, 1e-3, 0.03, 2, 1}};
    static const double courants[] = {0.01, 0.05, 0.2, 0.6, 1, 2, 6, 30};
    static const int which[] = {ADVECTED, EXPLICIT_ADVECTED};
    for (size_t k = 0; k < COUNT(which); ++k)
        for (size_t f = 0; f < COUNT(falls); ++f)
            for (size_t c = 0; c < COUNT(courants); ++c)
                for (int down = 0; down < 2; ++down) {
                    if (k > 0 && courants[c] > 0.2) continue;
                    const size_t n = falls[f].ledge + falls[f].lake;
                    cd_water* w = basin(n, 1, 1, 1, CD_FLOAT64);
                    basin_set_way(w, &ways[which[k]]);
                    for (size_t i = 0; i < n; ++i) {
                        const size_t at = down ? n - 1 - i : i;
                        basin_set(w, CD_BED, at, 0, i < falls[f].ledge ? falls[f].drop : 0);
                        basin_set(w, CD_DEPTH, at, 0, i < falls[f].ledge ? falls[f].film : falls[f].depth);
                    }
                    const double start = basin_energy(w), dt = courants[c] / sqrt(9.81 * falls[f].depth);
                    for (int step = 0; step < 500; ++step) {
                        basin_step(w, dt, 1);
                        if (!(basin_energy(w) <= (1 + 1e-5) * start))
                            fail_msg("%s, fall %d, courant %g: %g of the energy after %d steps", ways[which[k]].name,
                                     (int)f, courants[c], basin_energy(w) / start, step + 1);
                    }
                    cd_water_destroy(w);
                }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_seiche_from_rest_gains_no_energy),
        cmocka_unit_test(a_seiche_beside_a_level_grows_no_higher),
        cmocka_unit_test(a_hump_gains_no_energy),
        cmocka_unit_test(waves_round_a_ring_gain_no_energy),
        cmocka_unit_test(nothing_moves_by_itself_between_levels),
        cmocka_unit_test(a_film_does_not_throw_the_lake_that_it_falls_into),
        cmocka_unit_test(water_that_falls_over_a_ledge_makes_no_energy),
    };
    return cmocka_run_group_tests_name("water waves", tests, NULL, NULL);
}
