/* Explicit steps: bounded below cd_water_stable_dt, growing above it where the depth is the same everywhere. */
#include <math.h>

#include "basin.h"
#include "check.h"
#include "reference.h"

/* The largest height over many steps at `share` of the limit, over that of the start; waves so small that they stay
 * small while they grow by a thousand. */
static double growth(size_t nx, size_t ny, int ring, double share, size_t steps) {
    const double height = 1e-9;
    uint64_t seed = 3;
    double dx = 0.5, most = 0;
    cd_water* w = basin(nx, ny, dx, 0.8, CD_FLOAT64);
    basin_set_way(w, &ways[EXPLICIT]);
    if (ring) ok(cd_water_set_side(w, CD_SIDE_X_FIRST, CD_BORDER_PERIODIC, 0, 0));
    if (ring && ny > 1) ok(cd_water_set_side(w, CD_SIDE_Y_FIRST, CD_BORDER_PERIODIC, 0, 0));
    for (size_t j = 0; j < ny; ++j)
        for (size_t i = 0; i < nx; ++i) basin_set(w, CD_DEPTH, i, j, 2 + height * random_number(&seed));
    const double dt = share * basin_stable_dt(w);
    for (size_t s = 0; s < steps; ++s) {
        basin_step(w, dt, 1);
        most = fmax(most, fmax(basin_largest(w, CD_VELOCITY_X), basin_largest(w, CD_VELOCITY_Y)));
        if (most > 1e4 * height) break;
    }
    cd_water_destroy(w);
    return most / height;
}

static void the_limit_is_exact_for_one_depth(void** state) {
    (void)state;
    static const struct {
        size_t nx, ny;
        int ring;
    } shapes[] = {{200, 1, 0}, {1, 200, 0}, {60, 40, 0}, {200, 1, 1}, {40, 30, 1}};
    for (size_t k = 0; k < COUNT(shapes); ++k) {
        const double below = growth(shapes[k].nx, shapes[k].ny, shapes[k].ring, 0.99, 3000);
        const double above = growth(shapes[k].nx, shapes[k].ny, shapes[k].ring, 1.01, 3000);
        print_message("%3zu x %3zu %s: at most %.0f times as fast at 0.99, %.0e at 1.01\n", shapes[k].nx, shapes[k].ny,
                      shapes[k].ring ? "ring" : "", below, above);
        assert_true(below < 300);
        assert_true(above > 3000);
    }
}

/* Random beds, islands, open sides: velocities stay below what falling from the highest surface gives. */
static void it_is_safe_over_any_bed(void** state) {
    (void)state;
    double worst = 0;
    for (uint64_t seed = 1; seed <= 40; ++seed) {
        cd_water* w = basin(16, 12, 1, 0.6, CD_FLOAT64);
        basin_set_way(w, &ways[EXPLICIT]);
        basin_random_bed(w, 1, seed % 2 ? 3 : 0, seed);
        for (size_t c = 0; c < 16 * 12; ++c)
            basin_set(w, CD_SURFACE, c % 16, c / 16, 1.2 + 1e-3 * sin((double)(c * seed)));
        if (seed % 3 == 0) ok(cd_water_set_side(w, CD_SIDE_X_LAST, CD_BORDER_OPEN, 1.2, 0));
        for (int s = 0; s < 2000; ++s) basin_step(w, 0.99 * basin_stable_dt(w), 1);
        worst = fmax(worst, fmax(basin_largest(w, CD_VELOCITY_X), basin_largest(w, CD_VELOCITY_Y)));
        cd_water_destroy(w);
    }
    print_message("over 40 beds: at most %.1e m/s from waves of 1e-3 m\n", worst);
    assert_true(worst < 0.3);
}

static void dry_water_has_no_limit(void** state) {
    (void)state;
    cd_water* w = basin(5, 4, 1, 1, CD_FLOAT32);
    assert_true(isinf(basin_stable_dt(w)));
    basin_set(w, CD_DEPTH, 2, 2, 1e-12);
    assert_true(basin_stable_dt(w) > 1e4);
    ok(cd_water_set_gravity(w, 0));
    assert_true(isinf(basin_stable_dt(w)));
    cd_water_destroy(w);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_limit_is_exact_for_one_depth),
        cmocka_unit_test(it_is_safe_over_any_bed),
        cmocka_unit_test(dry_water_has_no_limit),
    };
    return cmocka_run_group_tests_name("water limits", tests, NULL, NULL);
}
