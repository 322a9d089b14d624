/* Ripples on a current that goes round: they do not grow, whatever the step, on flat beds and on wavy ones. */
#include <math.h>
#include <stdlib.h>

#include "basin.h"
#include "check.h"
#include "modes.h"
#include "reference.h"

enum { N = 48 };
static const double gravity = 9.81, height = 1e-6;

/* A current over water a metre deep; waves, along and across: how many cells waves, and the current, cross in a step. */
struct current {
    size_t ny;
    double waves, along, across, bed; /* bed: the height of its waves [m] */
};

static cd_water* flow(const struct way* way, const struct current* at, int rippled) {
    const double dt = at->waves / sqrt(gravity);
    uint64_t seed = 7;
    cd_water* w = basin(N, at->ny, 1, 1, CD_FLOAT64);
    basin_set_way(w, way);
    ok(cd_water_set_side(w, CD_SIDE_X_FIRST, CD_BORDER_PERIODIC, 0, 0));
    ok(cd_water_set_side(w, CD_SIDE_Y_FIRST, CD_BORDER_PERIODIC, 0, 0));
    for (size_t j = 0; j < at->ny; ++j)
        for (size_t i = 0; i < N; ++i) {
            const double bed = at->bed * sin(2 * (double)PI * (double)i / N);
            basin_set(w, CD_BED, i, j, bed);
            basin_set(w, CD_DEPTH, i, j, 1 - bed + (rippled ? height * random_number(&seed) : 0));
            basin_set(w, CD_VELOCITY_X, i, j, at->along / dt);
            basin_set(w, CD_VELOCITY_Y, i, j, at->across / dt);
        }
    return w;
}

/* The largest difference from the same water without ripples in some steps, over the ripples' height. */
static double growth(const struct way* way, const struct current* at, int steps) {
    static double rippled[N * N], smooth[N * N];
    cd_water *w = flow(way, at, 1), *other = flow(way, at, 0);
    double most = 0;
    for (int s = 0; s < steps && most < 1e6 * height; ++s) {
        basin_step(w, at->waves / sqrt(gravity), 1), basin_step(other, at->waves / sqrt(gravity), 1);
        basin_read(w, CD_DEPTH, rippled), basin_read(other, CD_DEPTH, smooth);
        for (size_t k = 0; k < N * at->ny; ++k) most = fmax(most, fabs(rippled[k] - smooth[k]));
    }
    cd_water_destroy(w);
    cd_water_destroy(other);
    return most / height;
}

static void grows_little(const struct way* way, const struct current* at, int steps, double* worst) {
    const double most = growth(way, at, steps);
    *worst = fmax(*worst, most);
    if (most > 3)
        print_message("%s, waves %g, current (%g, %g) cells, bed %g: %.3g times as high\n", way->name, at->waves,
                      at->along, at->across, at->bed, most);
    /* over waves of the bed a line may take other parts for a while, where they begin to need more */
    assert_true(most <= (at->bed > 0 && at->along > 0.8 ? 10 : 3));
}

/* Over a wavy bed, linear momentum with lambda = 1/2 or in explicit steps damps nothing: see water.h. */
static int looks_at(const struct way* way, const struct current* at) {
    if (basin_is_explicit(way) && !(at->waves < (at->bed > 0 ? 0.8 : 1))) return 0; /* see cd_water_stable_dt */
    return at->bed == 0 || way->momentum || way->lambda > 0.5;
}

static void ripples_do_not_grow_at_any_froude_number(void** state) {
    (void)state;
    static const double waves[] = {0.1, 0.3, 0.6, 0.9, 1, 1.5, 2.5, 5, 10, 16},
                        froude[] = {0.1, 0.2, 0.5, 0.9, 1, 1.5, 2};
    for (size_t k = 0; k < WAYS; ++k)
        for (int wavy = 0; wavy < 2; ++wavy) {
            double worst = 0;
            for (size_t c = 0; c < COUNT(waves); ++c)
                for (size_t f = 0; f < COUNT(froude); ++f) {
                    const struct current at = {1, waves[c], froude[f] * waves[c], 0, wavy ? 0.1 : 0};
                    if (!is_taken(c + f + k, 3)) continue;
                    if (looks_at(&ways[k], &at)) grows_little(&ways[k], &at, 1000, &worst);
                }
            if (worst > 0)
                print_message("%-17s %s bed: %.2f times as high at most\n", ways[k].name, wavy ? "wavy" : "flat",
                              worst);
        }
}

/* Of streams whose water crosses about a cell in a step, and more, aslant too. */
static void nor_on_streams_of_a_cell_a_step_straight_and_slanting(void** state) {
    (void)state;
    static const double cells[] = {0.9, 1, 1.02, 1.1, 1.3, 2}, waves[] = {0.4, 0.95, 3, 12};
    static const double slants[] = {0, 0.3, -1};
    for (size_t k = 0; k < WAYS; ++k) {
        double worst = 0;
        for (size_t c = 0; c < COUNT(cells); ++c)
            for (size_t v = 0; v < COUNT(waves); ++v)
                for (size_t s = 0; s < COUNT(slants); ++s)
                    for (int wavy = 0; wavy < 2; ++wavy) {
                        const struct current at = {slants[s] != 0 ? 12 : 1, waves[v], cells[c], slants[s] * cells[c],
                                                   wavy ? 0.1 : 0};
                        if (!is_taken(c + v + s + k, 3)) continue;
                        if (wavy && cells[c] / waves[v] > 2.3) continue; /* a Froude number that no bed is wavy at */
                        if (looks_at(&ways[k], &at)) grows_little(&ways[k], &at, slants[s] != 0 ? 300 : 1000, &worst);
                    }
        print_message("%-17s streams: %.2f times as high at most\n", ways[k].name, worst);
    }
}

static void nor_where_waves_or_water_cross_very_many_cells(void** state) {
    (void)state;
    static const double waves[] = {30, 100, 1000}, cells[] = {0.05, 0.5, 3, 28};
    for (size_t k = 0; k < WAYS; ++k)
        for (size_t c = 0; c < COUNT(waves); ++c)
            for (size_t u = 0; u < COUNT(cells); ++u) {
                const struct current at = {12, waves[c], cells[u], 0.3 * cells[u], 0};
                double worst = 0;
                if (looks_at(&ways[k], &at)) grows_little(&ways[k], &at, 200, &worst);
            }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(ripples_do_not_grow_at_any_froude_number),
        cmocka_unit_test(nor_on_streams_of_a_cell_a_step_straight_and_slanting),
        cmocka_unit_test(nor_where_waves_or_water_cross_very_many_cells),
    };
    return cmocka_run_group_tests_name("water currents", tests, NULL, NULL);
}
