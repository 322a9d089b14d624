/* The water at places: surface, depth, normal and velocity, on lakes, slopes, beaches, at edges and round sides. */
#include <math.h>

#include "check.h"
#include "pool.h"
#include "scene.h"

enum { NX = 9, NY = 7, CELLS = NX * NY, PLACES = 400 };
#define LENGTH (NX * POOL_DX)
#define WIDTH (NY * POOL_DY)

/* Places all over the water, its edges and corners among them. */
static double at[2 * PLACES];
static double surface[PLACES], depth[PLACES], normal[3 * PLACES], velocity[2 * PLACES];

static int set_up(void** state) {
    (void)state;
    uint64_t seed = 77;
    for (size_t k = 0; k < PLACES; ++k) {
        at[2 * k] = (scene_noise(&seed) + 1) / 2 * LENGTH;
        at[2 * k + 1] = (scene_noise(&seed) + 1) / 2 * WIDTH;
        if (k % 8 == 0) at[2 * k] = k % 16 ? 0 : LENGTH;
        if (k % 12 == 0) at[2 * k + 1] = k % 24 ? 0 : WIDTH;
    }
    return 0;
}

static void sample(const cd_water* w) {
    ok(cd_water_sample(w, at, PLACES, CD_OUTSIDE_REFUSED, surface, depth, normal, velocity));
}

static double centre_x(size_t i) { return ((double)i + 0.5) * POOL_DX; }
static double centre_y(size_t j) { return ((double)j + 0.5) * POOL_DY; }

/* Level beyond the outermost centres. */
static double inside(double place, double size, size_t n) {
    return fmin(fmax(place, size / 2), ((double)n - 0.5) * size);
}

static void a_lake_is_level_over_any_bed(void** state) {
    (void)state;
    for (cd_precision precision = CD_FLOAT32; precision <= CD_FLOAT64; ++precision) {
        cd_water* w = pool(NX, NY, precision);
        for (size_t k = 0; k < CELLS; ++k) pool_set(w, CD_BED, k % NX, k / NX, -0.5 * (double)(1 + k % 4));
        pool_fill(w, CD_SURFACE, 0.25);
        sample(w);
        for (size_t k = 0; k < PLACES; ++k) {
            assert_near(surface[k], 0.25, 1e-15, 0);
            assert_true(depth[k] >= 0.75 && depth[k] <= 2.25);
            assert_true(normal[3 * k] == 0 && normal[3 * k + 1] == 0 && normal[3 * k + 2] == 1);
            assert_true(velocity[2 * k] == 0 && velocity[2 * k + 1] == 0);
        }
        cd_water_destroy(w);
    }
}

static void a_slope_is_met_exactly(void** state) {
    (void)state;
    for (int wet = 0; wet <= 1; ++wet) {
        cd_water* w = pool(NX, NY, CD_FLOAT64);
        for (size_t k = 0; k < CELLS; ++k) {
            pool_set(w, CD_BED, k % NX, k / NX, 0.25 * centre_x(k % NX) - 0.5 * centre_y(k / NX));
            if (wet) pool_set(w, CD_DEPTH, k % NX, k / NX, 2);
        }
        sample(w);
        for (size_t k = 0; k < PLACES; ++k) {
            const double x = at[2 * k], y = at[2 * k + 1];
            const double there = 0.25 * inside(x, POOL_DX, NX) - 0.5 * inside(y, POOL_DY, NY) + (wet ? 2 : 0);
            assert_near(surface[k], there, 1e-14, 1);
            assert_near(depth[k], wet ? 2 : 0, 1e-15, 0);
            if (x != inside(x, POOL_DX, NX) || y != inside(y, POOL_DY, NY)) continue;
            const double length = sqrt(1 + 0.25 * 0.25 + 0.5 * 0.5);
            assert_near(normal[3 * k], -0.25 / length, 1e-13, 1);
            assert_near(normal[3 * k + 1], 0.5 / length, 1e-13, 1);
            assert_near(normal[3 * k + 2], 1 / length, 1e-13, 1);
        }
        cd_water_destroy(w);
    }
}

static void at_a_centre_the_numbers_are_those_of_the_cell(void** state) {
    (void)state;
    for (size_t scene = 0; scene < POOLS; ++scene) {
        cd_water* w = pool_of(scene, NX, NY, CD_FLOAT64, 5);
        for (size_t k = 0; k < CELLS; ++k) {
            const double place[2] = {centre_x(k % NX), centre_y(k / NX)};
            double h, d;
            if (pool_has(w, CD_MASK) && pool_get(w, CD_MASK, k % NX, k / NX) == 0) continue;
            ok(cd_water_sample(w, place, 1, CD_OUTSIDE_REFUSED, &h, &d, NULL, NULL));
            assert_near(h, pool_get(w, CD_SURFACE, k % NX, k / NX), 1e-12, 1);
            assert_near(d, pool_get(w, CD_DEPTH, k % NX, k / NX), 1e-12, 1);
        }
        cd_water_destroy(w);
    }
}

static void on_a_face_the_velocity_is_that_of_the_face(void** state) {
    (void)state;
    cd_water* w = pool_of(POOL_TORUS, NX, NY, CD_FLOAT64, 3); /* periodic both ways, so that all faces move */
    for (size_t j = 0; j < NY; ++j)
        for (size_t i = 0; i < NX; ++i) {
            const double on_x[2] = {(double)i * POOL_DX, centre_y(j)}, on_y[2] = {centre_x(i), (double)j * POOL_DY};
            double v[2];
            ok(cd_water_sample(w, on_x, 1, CD_OUTSIDE_REFUSED, NULL, NULL, NULL, v));
            assert_near(v[0], pool_get(w, CD_VELOCITY_X, i, j), 1e-12, 1);
            ok(cd_water_sample(w, on_y, 1, CD_OUTSIDE_REFUSED, NULL, NULL, NULL, v));
            assert_near(v[1], pool_get(w, CD_VELOCITY_Y, i, j), 1e-12, 1);
        }
    cd_water_destroy(w);
}

/* The surface of a lake stays level until it meets the beach, which is the surface from there on. */
static void up_to_a_beach_the_water_is_level_and_behind_it_is_the_bed(void** state) {
    (void)state;
    cd_water* w = pool(NX, NY, CD_FLOAT64);
    for (size_t k = 0; k < CELLS; ++k) pool_set(w, CD_BED, k % NX, k / NX, 0.5 * centre_x(k % NX) - 1.1);
    pool_fill(w, CD_SURFACE, 0);
    sample(w);
    size_t afloat = 0, ashore = 0;
    for (size_t k = 0; k < PLACES; ++k) {
        const double bed = 0.5 * inside(at[2 * k], POOL_DX, NX) - 1.1;
        assert_true(depth[k] >= 0);
        assert_near(normal[3 * k + 1], 0, 1e-15, 1);
        if (bed < 0 && depth[k] > 0) assert_near(surface[k], 0, 1e-14, 1), ++afloat;
        else if (bed >= 0) assert_near(surface[k], bed, 1e-14, 1), ++ashore;
    }
    assert_true(afloat > 100 && ashore > 100);
    cd_water_destroy(w);
}

static void nothing_is_told_of_cells_that_are_not_there(void** state) {
    (void)state;
    cd_water* w = pool(NX, NY, CD_FLOAT64);
    pool_fill(w, CD_DEPTH, 0.5);
    ok(cd_water_enable_field(w, CD_MASK));
    for (size_t k = 0; k < CELLS; ++k) {
        if ((k % NX + 2 * (k / NX)) % 5 != 1) continue; /* never two side by side */
        pool_set(w, CD_BED, k % NX, k / NX, 50);
        pool_set(w, CD_MASK, k % NX, k / NX, 0);
    }
    sample(w);
    for (size_t k = 0; k < PLACES; ++k) {
        assert_near(surface[k], 0.5, 1e-14, 0);
        assert_near(depth[k], 0.5, 1e-14, 0);
    }
    cd_water_destroy(w);
}

/* Of the four cells about a place one alone, each in its turn, lies in the water. */
static void one_cell_tells_what_is_about_it(void** state) {
    (void)state;
    for (size_t there = 0; there < 4; ++there) {
        cd_water* w = pool(2, 2, CD_FLOAT64);
        pool_fill(w, CD_BED, 3);
        pool_fill(w, CD_DEPTH, 0.5);
        ok(cd_water_enable_field(w, CD_MASK));
        for (size_t k = 0; k < 4; ++k)
            if (k != there) pool_set(w, CD_MASK, k % 2, k / 2, 0);
        const double place[2] = {0.9 * POOL_DX, 1.2 * POOL_DY};
        ok(cd_water_sample(w, place, 1, CD_OUTSIDE_REFUSED, surface, depth, normal, velocity));
        assert_near(surface[0], 3.5, 1e-14, 0);
        assert_near(depth[0], 0.5, 1e-14, 0);
        cd_water_destroy(w);
    }
}

static void round_a_periodic_side_there_is_no_edge(void** state) {
    (void)state;
    cd_water* w = pool_of(POOL_TORUS, NX, NY, CD_FLOAT64, 5);
    cd_water* moved = pool_of(POOL_TORUS, NX, NY, CD_FLOAT64, 5);
    double from[(NX + 1) * (NY + 1)], to[(NX + 1) * (NY + 1)];
    static const cd_field fields[] = {CD_DEPTH, CD_VELOCITY_X, CD_VELOCITY_Y};
    for (size_t f = 0; f < COUNT(fields); ++f) { /* by four cells along x and three along y */
        const struct pool_extent all = pool_extent(w, fields[f]);
        pool_read(w, fields[f], from);
        for (size_t k = 0; k < all.count; ++k)
            to[k] = from[(k / all.columns + 3) % NY * all.columns + (k % all.columns + 4) % NX];
        pool_write(moved, fields[f], to);
    }
    sample(w);
    for (size_t k = 0; k < PLACES; ++k) {
        const double there[2] = {fmod(at[2 * k] + (NX - 4) * POOL_DX, LENGTH),
                                 fmod(at[2 * k + 1] + (NY - 3) * POOL_DY, WIDTH)};
        double h, d, n[3], v[2];
        ok(cd_water_sample(moved, there, 1, CD_OUTSIDE_REFUSED, &h, &d, n, v));
        assert_near(h, surface[k], 1e-12, 1);
        assert_near(d, depth[k], 1e-12, 1);
        for (int c = 0; c < 2; ++c) assert_near(v[c], velocity[2 * k + (size_t)c], 1e-12, 1);
    }
    cd_water_destroy(w);
    cd_water_destroy(moved);
}

static void a_water_of_one_cell_is_the_same_everywhere(void** state) {
    (void)state;
    cd_water* w = pool(1, 1, CD_FLOAT32);
    pool_set(w, CD_BED, 0, 0, -1);
    pool_set(w, CD_DEPTH, 0, 0, 1.5);
    for (int k = 0; k < 9; ++k) {
        const double place[2] = {k % 3 * POOL_DX / 2, k / 3 * POOL_DY / 2};
        double h, d, n[3], v[2];
        ok(cd_water_sample(w, place, 1, CD_OUTSIDE_REFUSED, &h, &d, n, v));
        assert_true(h == 0.5 && d == 1.5 && n[0] == 0 && n[1] == 0 && n[2] == 1 && v[0] == 0 && v[1] == 0);
    }
    cd_water_destroy(w);
}

static void places_outside_are_the_nearest_or_refused(void** state) {
    (void)state;
    cd_water* w = pool_of(0, NX, NY, CD_FLOAT64, 5);
    const double outside[8] = {-1e300, 0.5, LENGTH + 1e-9, 2, 0.5, INFINITY, INFINITY, -INFINITY};
    const double nearest[8] = {0, 0.5, LENGTH, 2, 0.5, WIDTH, LENGTH, 0}, none[2] = {0.5, NAN};
    double h[2][4], d[2][4], n[2][12], v[2][8];
    ok(cd_water_sample(w, nearest, 4, CD_OUTSIDE_REFUSED, h[0], d[0], n[0], v[0]));
    ok(cd_water_sample(w, outside, 4, CD_OUTSIDE_NEAREST, h[1], d[1], n[1], v[1]));
    assert_memory_equal(h[0], h[1], sizeof h[0]);
    assert_memory_equal(d[0], d[1], sizeof d[0]);
    assert_memory_equal(n[0], n[1], sizeof n[0]);
    assert_memory_equal(v[0], v[1], sizeof v[0]);
    ok(cd_water_sample_heads(w, outside, 4, CD_OUTSIDE_NEAREST, h[1]));
    assert_memory_equal(h[0], h[1], sizeof h[0]); /* no hulls */
    for (int k = 0; k < 4; ++k) {
        refuses(w, cd_water_sample(w, outside + 2 * k, 1, CD_OUTSIDE_REFUSED, h[1], NULL, NULL, NULL), CD_ERROR_VALUE,
                "at");
        refuses(w, cd_water_sample_heads(w, outside + 2 * k, 1, CD_OUTSIDE_REFUSED, h[1]), CD_ERROR_VALUE, "at");
    }
    refuses(w, cd_water_sample(w, none, 1, CD_OUTSIDE_NEAREST, h[1], NULL, NULL, NULL), CD_ERROR_VALUE, "at[1]|nan");
    cd_water_destroy(w);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_lake_is_level_over_any_bed),
        cmocka_unit_test(a_slope_is_met_exactly),
        cmocka_unit_test(at_a_centre_the_numbers_are_those_of_the_cell),
        cmocka_unit_test(on_a_face_the_velocity_is_that_of_the_face),
        cmocka_unit_test(up_to_a_beach_the_water_is_level_and_behind_it_is_the_bed),
        cmocka_unit_test(nothing_is_told_of_cells_that_are_not_there),
        cmocka_unit_test(one_cell_tells_what_is_about_it),
        cmocka_unit_test(round_a_periodic_side_there_is_no_edge),
        cmocka_unit_test(a_water_of_one_cell_is_the_same_everywhere),
        cmocka_unit_test(places_outside_are_the_nearest_or_refused),
    };
    return cmocka_run_group_tests(tests, set_up, NULL);
}
