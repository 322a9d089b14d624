/* A lake at rest stays at rest, whatever islands, beaches and dry basins are in it. The notes' depth of faces, the mean
 * of the two columns everywhere, does not: it is kept here as the counter-example. */
#include <math.h>
#include <stdlib.h>

#include "basin.h"
#include "check.h"
#include "reference.h"

enum { NX = 11, NY = 9, CELLS = NX * NY };

/* Level 0.5 among beds of 0 to 1, smooth or cell by cell; columns that stand alone in dry basins are left dry. */
static cd_water* lake(const struct way* way, double length, uint64_t seed, cd_precision precision) {
    double surface[CELLS];
    cd_water* w = basin(NX, NY, 1, 1, precision);
    basin_set_way(w, way);
    basin_random_bed(w, 1, length, seed);
    for (size_t c = 0; c < CELLS; ++c) surface[c] = 0.5;
    basin_write(w, CD_SURFACE, surface);
    if (seed % 2) /* a basin of dry land below the level, walled off by land */
        for (size_t j = 3; j < 8; ++j)
            for (size_t i = 3; i < 8; ++i) {
                const int rim = i == 3 || i == 7 || j == 3 || j == 7;
                if (rim) basin_set(w, CD_BED, i, j, 0.9);
                basin_set(w, CD_DEPTH, i, j, 0);
            }
    ok(cd_water_restart_account(w));
    return w;
}

static void lakes_stay_at_rest_for_a_hundred_thousand_steps(void** state) {
    (void)state;
    for (size_t k = 0; k < WAYS; ++k)
        for (int p = 0; p < 2; ++p)
            for (uint64_t seed = 1; seed <= 3; ++seed) {
                cd_water* w = lake(&ways[k], seed == 2 ? 0 : 2, seed, p ? CD_FLOAT64 : CD_FLOAT32);
                const size_t all = seed == 1 && is_taken(k + (size_t)p, 3) ? 100000 : 10000;
                const double start = basin_volume(w), dt = basin_is_explicit(&ways[k]) ? 0.1 : seed == 3 ? 20 : 0.3;
                double fastest = 0, before[CELLS], after[CELLS], moved = 0;
                basin_read(w, CD_DEPTH, before);
                for (int part = 0; part < 10; ++part) {
                    basin_step(w, dt, all / 10);
                    fastest = fmax(fastest, fmax(basin_largest(w, CD_VELOCITY_X), basin_largest(w, CD_VELOCITY_Y)));
                }
                basin_read(w, CD_DEPTH, after);
                for (size_t c = 0; c < CELLS; ++c) moved = fmax(moved, fabs(after[c] - before[c]));
                const double off = fabs(basin_volume(w) / start - 1);
                if (seed == 1)
                    print_message("%-17s %s: %6zu steps, at most %.1e m/s, depths moved by %.1e, volume by %.1e\n",
                                  ways[k].name, p ? "float64" : "float32", all, fastest, moved, off);
                assert_true(fastest <= (p ? 1e-10 : 1e-4));
                assert_true(moved <= (p ? 2e-13 : 3e-5));
                assert_true(off <= (p ? 1e-12 : 4e-6));
                assert_true(basin_least(w, CD_DEPTH) >= 0);
                for (size_t c = 0; c < CELLS && p; ++c) assert_true((before[c] > 0) == (after[c] > 1e-13));
                cd_water_destroy(w);
            }
}

/* ---- ponds ---- */

/* Four waters that land parts, or walls, all of which swing: one to the right of column 4, but for cell (8, 6); that cell
 * alone; one above row 4 to the left, one below. */
static int pond_of(size_t i, size_t j) {
    const int rim = i >= 7 && i <= 9 && j >= 5 && j <= 7;
    if (i == 8 && j == 6) return 1;
    if (i == 4 || rim || (i < 4 && j == 4)) return -1;
    return i > 4 ? 0 : j < 4 ? 2 : 3;
}
static void measure_ponds(const cd_water* w, double* volume) {
    for (int k = 0; k < 4; ++k) volume[k] = 0;
    for (size_t j = 0; j < NY; ++j)
        for (size_t i = 0; i < NX; ++i)
            if (pond_of(i, j) >= 0) volume[pond_of(i, j)] += basin_get(w, CD_DEPTH, i, j);
}

/* What float32 rounds in one water is made up for there. */
static void waters_that_land_parts_keep_their_own(void** state) {
    (void)state;
    for (size_t k = 0; k < WAYS; ++k)
        for (int longer = 0; longer < 2; ++longer) {
            cd_water* w = basin(NX, NY, 1, 1, CD_FLOAT32);
            double start[4], now[4], worst = 0, land = 0;
            uint64_t seed = 7 + k;
            if (longer && basin_is_explicit(&ways[k])) continue;
            basin_set_way(w, &ways[k]);
            for (size_t j = 0; j < NY; ++j)
                for (size_t i = 0; i < NX; ++i) {
                    const int pond = pond_of(i, j);
                    basin_set(w, CD_BED, i, j, pond < 0 ? 3 : 0.3 * random_number(&seed));
                    basin_set(w, CD_DEPTH, i, j, pond < 0 ? 0 : 0.3 * pond + 0.4 + 0.1 * random_number(&seed));
                }
            measure_ponds(w, start);
            basin_step(w, longer ? 4 : 0.1, 2000);
            measure_ponds(w, now);
            for (int i = 0; i < 4; ++i) worst = fmax(worst, fabs(now[i] / start[i] - 1));
            for (size_t j = 0; j < NY; ++j)
                for (size_t i = 0; i < NX; ++i)
                    if (pond_of(i, j) < 0) land = fmax(land, basin_get(w, CD_DEPTH, i, j));
            print_message("%-17s %s steps: ponds gain or lose at most %.1e\n", ways[k].name, longer ? "long" : "short",
                          worst);
            assert_true(worst <= 3e-7 && land == 0);
            cd_water_destroy(w);
        }
}

/* ---- rain -------------------------------------------------------------------------------------------------------- */

/* Rain on a lake and its beach runs down the beach, and the lake rises as a whole. */
static void rain_on_a_beach_does_not_disturb_a_lake(void** state) {
    (void)state;
    enum { N = 60 };
    const double dx = 1, rain = 1e-5;
    for (size_t k = 0; k < WAYS; ++k) {
        double values[N], low = INFINITY, high = 0;
        cd_water* w = basin(N, 1, dx, dx, CD_FLOAT64);
        basin_set_way(w, &ways[k]);
        ok(cd_water_set_manning(w, 0.03));
        for (size_t i = 0; i < N; ++i) values[i] = fmax(0, 0.05 * ((double)i - 30));
        basin_write(w, CD_BED, values);
        for (size_t i = 0; i < N; ++i) values[i] = 0.5;
        basin_write(w, CD_SURFACE, values);
        const double start = basin_volume(w);
        for (size_t i = 0; i < N; ++i) values[i] = rain;
        ok(cd_water_enable_field(w, CD_SOURCE));
        basin_write(w, CD_SOURCE, values);
        for (int s = 0; s < 5000; ++s) basin_step(w, 0.2, 1);
        basin_read(w, CD_SURFACE, values);
        for (size_t i = 0; i < 30; ++i) low = fmin(low, values[i]), high = fmax(high, values[i]);
        const double lifted = low - 0.5, over_all = rain * 1000 * N;
        print_message("%-17s the lake has risen by %.5f m and is uneven by %.1e m\n", ways[k].name, lifted, high - low);
        assert_near(basin_volume(w) - start, over_all, 1e-9, 0);
        assert_true(high - low < 1e-3);
        assert_true(lifted > 0.8 * over_all / 41); /* most of it is down in the lake */
        assert_true(basin_volume_off(w) <= 1e-12);
        cd_water_destroy(w);
    }
}

/* ---- the notes' faces -------------------------------------------------------------------------------------------- */

/* A step of Kass (1997), eq. 37 with lambda 1, of a line between walls: the surface h solves
 *      h_i + sum over faces g dt^2 / dx^2 D_f (h_i - h_j) = h_i(now) + its rate, with D the mean of the two depths
 * everywhere, dry or not, and a depth that comes out negative counted as 0. */
static void kass_step(size_t n, double dt, double dx, const double* bed, double* h, double* h_before) {
    double d[128], lower[128], right[128], now[128];
    for (size_t i = 0; i < n; ++i) d[i] = fmax(0, h[i] - bed[i]);
    for (size_t i = 0; i < n; ++i) {
        const double s = 9.81 * dt * dt / (dx * dx);
        const double e_l = i > 0 ? s * (d[i - 1] + d[i]) / 2 : 0, e_r = i + 1 < n ? s * (d[i] + d[i + 1]) / 2 : 0;
        double own = 1 + e_l + e_r, load = 2 * h[i] - h_before[i];
        if (i > 0) own += -e_l * lower[i - 1], load += e_l * right[i - 1];
        lower[i] = e_r / own, right[i] = load / own;
    }
    for (size_t i = n; i-- > 0;) now[i] = right[i] + (i + 1 < n ? lower[i] * now[i + 1] : 0);
    for (size_t i = 0; i < n; ++i) h_before[i] = h[i], h[i] = now[i];
}

static double volume_over(size_t n, double dx, const double* bed, const double* h) {
    double volume = 0;
    for (size_t i = 0; i < n; ++i) volume += fmax(0, h[i] - bed[i]) * dx;
    return volume;
}

/* A lake beside a dry bank, 100 cells, ten seconds of 1/60 s. */
static void mean_depths_at_dry_banks_would_make_water(void** state) {
    (void)state;
    enum { N = 100 };
    const double dx = 0.1, dt = 1.0 / 60;
    double bed[N], h[N], before[N];
    for (size_t i = 0; i < N; ++i) bed[i] = i < N / 2 ? 0 : 3, h[i] = before[i] = fmax(bed[i], 1);
    const double start = volume_over(N, dx, bed, h);
    for (int s = 0; s < 600; ++s) kass_step(N, dt, dx, bed, h, before);
    const double gain = volume_over(N, dx, bed, h) / start - 1;
    print_message("the notes' mean depth everywhere: a lake gains %.1f%% in ten seconds\n", 100 * gain);
    assert_true(gain > 0.03 && gain < 0.06);
    for (size_t k = 0; k < WAYS; ++k) {
        cd_water* w = basin(N, 1, dx, dx, CD_FLOAT64);
        basin_set_way(w, &ways[k]);
        basin_write(w, CD_BED, bed);
        for (size_t i = 0; i < N; ++i) h[i] = 1;
        basin_write(w, CD_SURFACE, h);
        const double volume = basin_volume(w);
        for (int s = 0; s < 600; ++s) basin_step(w, dt, 1);
        assert_near(basin_volume(w), volume, 1e-14, 0);
        assert_true(basin_largest(w, CD_VELOCITY_X) <= 1e-13);
        cd_water_destroy(w);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(lakes_stay_at_rest_for_a_hundred_thousand_steps),
        cmocka_unit_test(waters_that_land_parts_keep_their_own),
        cmocka_unit_test(rain_on_a_beach_does_not_disturb_a_lake),
        cmocka_unit_test(mean_depths_at_dry_banks_would_make_water),
    };
    return cmocka_run_group_tests_name("water lake", tests, NULL, NULL);
}
