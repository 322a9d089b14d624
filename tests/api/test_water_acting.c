/* Acting on a water: volumes, sources, splashes and impulses do to it what they say, exactly, and nothing else. */
#include <math.h>
#include <string.h>

#include "check.h"
#include "heap.h"
#include "pool.h"

enum { NX = 9, NY = 7, CELLS = NX * NY, MOST = (NX + 1) * (NY + 1) };
#define AREA (POOL_DX * POOL_DY)

struct account {
    double initial, in, out, error;
};

static struct account account_of(const cd_water* w) {
    struct account a;
    ok(cd_water_get_account(w, &a.initial, &a.in, &a.out, &a.error));
    return a;
}

static cd_water* lake(cd_precision precision, double depth) {
    cd_water* w = pool(NX, NY, precision);
    pool_fill(w, CD_DEPTH, depth);
    return w;
}

/* (1 - (distance / radius)^2)^2 of a point. */
static double weight(double x, double y, double at_x, double at_y, double radius) {
    const double square = ((x - at_x) * (x - at_x) + (y - at_y) * (y - at_y)) / (radius * radius);
    return square < 1 ? (1 - square) * (1 - square) : 0;
}

static double centre_weight(size_t k, double at_x, double at_y, double radius) {
    return weight(((double)(k % NX) + 0.5) * POOL_DX, ((double)(k / NX) + 0.5) * POOL_DY, at_x, at_y, radius);
}

/* ---- volumes ---- */

static void a_disc_shares_a_volume_out_by_its_weights(void** state) {
    (void)state;
    static const double discs[][3] = {{2.1, 2.6, 1.3}, {0, 0, 2}, {4.5, 5.25, 1}, {2, 3, 1e60}, {0.3, 5.2, 0.9}};
    for (cd_precision precision = CD_FLOAT32; precision <= CD_FLOAT64; ++precision)
        for (size_t d = 0; d < COUNT(discs); ++d) {
            const double x = discs[d][0], y = discs[d][1], radius = discs[d][2], exactly = precision ? 1e-14 : 1e-6;
            cd_water* w = lake(precision, 0.5);
            double sum = 0, added = -1;
            for (size_t k = 0; k < CELLS; ++k) sum += centre_weight(k, x, y, radius);
            assert_true(sum > 0);
            ok(cd_water_add_volume(w, x, y, radius, 3.5, &added));
            for (size_t k = 0; k < CELLS; ++k)
                assert_near(pool_get(w, CD_DEPTH, k % NX, k / NX),
                            0.5 + 3.5 / AREA * centre_weight(k, x, y, radius) / sum, exactly, 0);
            assert_near(added, 3.5, exactly, 0);
            assert_near(pool_volume(w), CELLS * 0.5 * AREA + added, 1e-15, 0);
            const struct account a = account_of(w);
            assert_true(a.in == added && a.out == 0 && a.initial == CELLS * 0.5 * AREA);
            assert_true(fabs(a.error) <= 1e-14 * a.initial);
            cd_water_destroy(w);
        }
}

static void a_disc_between_the_centres_is_the_cell_at_its_place(void** state) {
    (void)state;
    static const double radii[] = {0, 1e-300, 0.05};
    for (size_t r = 0; r < COUNT(radii); ++r)
        for (size_t j = 0; j < NY; ++j)
            for (size_t i = 0; i < NX; ++i) {
                cd_water* w = pool(NX, NY, CD_FLOAT64);
                double added;
                ok(cd_water_add_volume(w, ((double)i + 0.8) * POOL_DX, ((double)j + 0.2) * POOL_DY, radii[r], 2,
                                       &added));
                assert_near(added, 2, 1e-15, 0);
                assert_near(pool_get(w, CD_DEPTH, i, j), 2 / AREA, 1e-15, 0);
                assert_near(pool_volume(w), 2, 1e-15, 0);
                cd_water_destroy(w);
            }
}

static void an_absent_cell_hands_its_place_to_the_nearest_one_there(void** state) {
    (void)state;
    cd_water* w = pool(NX, NY, CD_FLOAT64);
    ok(cd_water_enable_field(w, CD_MASK));
    pool_set(w, CD_MASK, 4, 3, 0);
    ok(cd_water_add_volume(w, 4.4 * POOL_DX, 3.5 * POOL_DY, 0, 2, NULL)); /* the left neighbour is nearer */
    assert_near(pool_get(w, CD_DEPTH, 3, 3), 2 / AREA, 1e-15, 0);
    ok(cd_water_add_source(w, 4.6 * POOL_DX, 3.5 * POOL_DY, 0, 3));
    assert_near(pool_get(w, CD_SOURCE, 5, 3), 3 / AREA, 1e-15, 0);
    assert_true(pool_get(w, CD_DEPTH, 4, 3) == 0 && pool_get(w, CD_SOURCE, 4, 3) == 0);
    pool_fill(w, CD_MASK, 0); /* nobody there at all */
    double added = -1;
    ok(cd_water_add_volume(w, 1, 1, 1, 2, &added));
    assert_true(added == 0 && pool_volume(w) == 0);
    ok(cd_water_add_source(w, 1, 1, 1, 2));
    ok(cd_water_splash(w, 1, 1, 1, 2));
    ok(cd_water_impulse(w, 1, 1, 1, 2, 2));
    cd_water_destroy(w);
}

static void a_rectangle_shares_a_volume_evenly_over_the_cells_there(void** state) {
    (void)state;
    for (cd_precision precision = CD_FLOAT32; precision <= CD_FLOAT64; ++precision) {
        const double exactly = precision ? 1e-14 : 1e-6;
        cd_water* w = lake(precision, 0.5);
        double added;
        ok(cd_water_enable_field(w, CD_MASK));
        pool_set(w, CD_MASK, 3, 2, 0);
        ok(cd_water_add_volume_rectangle(w, 2, 1, 4, 3, 11, &added));
        for (size_t k = 0; k < CELLS; ++k) {
            const size_t i = k % NX, j = k / NX;
            const int inside = i >= 2 && i < 6 && j >= 1 && j < 4;
            const double depth = i == 3 && j == 2 ? 0 : inside ? 0.5 + 1 / AREA : 0.5;
            assert_near(pool_get(w, CD_DEPTH, i, j), depth, exactly, 0);
        }
        assert_near(added, 11, exactly, 0);
        assert_true(account_of(w).in == added);
        const uint64_t before = hash_of(w);
        ok(cd_water_add_volume_rectangle(w, 0, 0, 0, NY, 11, &added)); /* nobody to take it */
        assert_true(added == 0);
        ok(cd_water_add_volume_rectangle(w, 3, 2, 1, 1, 11, &added));
        assert_true(added == 0);
        assert_int_equal(hash_of(w), before);
        cd_water_destroy(w);
    }
}

static void no_more_is_taken_than_there_is(void** state) {
    (void)state;
    for (cd_precision precision = CD_FLOAT32; precision <= CD_FLOAT64; ++precision)
        for (int rectangle = 0; rectangle <= 1; ++rectangle) {
            cd_water* w = lake(precision, 0);
            pool_vary(w, CD_DEPTH, 0.5, 0.5, 3);
            pool_set(w, CD_DEPTH, 3, 2, 0.01); /* less than its share */
            const double before = pool_volume(w);
            double taken[2];
            if (rectangle) ok(cd_water_add_volume_rectangle(w, 1, 1, 5, 4, -7, &taken[0]));
            else ok(cd_water_add_volume(w, 2, 2, 1.5, -7, &taken[0]));
            assert_true(taken[0] < 0 && taken[0] > -7);
            assert_near(pool_volume(w), before + taken[0], 1e-14, 0);
            assert_true(pool_get(w, CD_DEPTH, 3, 2) == 0);
            for (size_t k = 0; k < CELLS; ++k) assert_true(pool_get(w, CD_DEPTH, k % NX, k / NX) >= 0);
            ok(cd_water_add_volume(w, 2, 2, 1e60, -1e60, &taken[1])); /* all the rest */
            assert_true(pool_volume(w) == 0);
            const struct account a = account_of(w);
            assert_true(a.in == 0);
            assert_near(a.out, -(taken[0] + taken[1]), 1e-15, 0);
            assert_near(a.out, before, 1e-14, 0);
            cd_water_destroy(w);
        }
}

static void many_small_volumes_are_accounted_for_in_both_precisions(void** state) {
    (void)state;
    for (cd_precision precision = CD_FLOAT32; precision <= CD_FLOAT64; ++precision) {
        cd_water* w = lake(precision, 1);
        double sum = 0, added;
        for (int k = 0; k < 1000; ++k) {
            ok(cd_water_add_volume(w, 0.004 * k, 5.2 - 0.005 * k, 1, k % 3 ? 1e-3 : -1.5e-3, &added));
            sum += added;
        }
        const struct account a = account_of(w);
        assert_near(a.in - a.out, sum, 1e-13, 1);
        assert_true(fabs(a.error) <= 1e-13 * a.initial);
        cd_water_destroy(w);
    }
}

/* ---- sources ---- */

static void a_source_is_added_to_the_field_and_runs_until_it_is_overwritten(void** state) {
    (void)state;
    for (cd_precision precision = CD_FLOAT32; precision <= CD_FLOAT64; ++precision) {
        const double exactly = precision ? 1e-14 : 1e-6;
        cd_water* w = lake(precision, 1);
        assert_false(pool_has(w, CD_SOURCE));
        ok(cd_water_add_source(w, 2, 2, 1.5, 0.25));
        ok(cd_water_add_source(w, 2, 2, 1.5, 0.5));
        ok(cd_water_add_source_rectangle(w, 7, 1, 2, 4, -0.125));
        double sum = 0, all = 0;
        for (size_t k = 0; k < CELLS; ++k) sum += centre_weight(k, 2, 2, 1.5);
        for (size_t k = 0; k < CELLS; ++k) {
            const size_t i = k % NX, j = k / NX;
            const double drain = i >= 7 && j >= 1 && j < 5 ? 0.125 / 8 : 0;
            const double source = pool_get(w, CD_SOURCE, i, j);
            assert_near(source, (0.75 * centre_weight(k, 2, 2, 1.5) / sum - drain) / AREA, exactly, 0);
            all += source * AREA;
        }
        assert_near(all, 0.625, exactly, 0);
        ok(cd_water_step(w, 0.05, 40));
        const struct account a = account_of(w);
        assert_near(a.in - a.out, 2 * all, 1e-12, 0);
        assert_near(a.in, 2 * 0.75, precision ? 1e-12 : 1e-6, 0);
        assert_true(fabs(a.error) <= (precision ? 1e-13 : 1e-5));
        pool_fill(w, CD_SOURCE, 0);
        ok(cd_water_step(w, 0.05, 40));
        assert_true(account_of(w).in == a.in && account_of(w).out == a.out);
        cd_water_destroy(w);
    }
}

static void a_drain_takes_what_is_there_and_no_more(void** state) {
    (void)state;
    for (cd_precision precision = CD_FLOAT32; precision <= CD_FLOAT64; ++precision) {
        cd_water* w = lake(precision, 0.25);
        ok(cd_water_add_source_rectangle(w, 0, 0, NX, NY, -100));
        ok(cd_water_step(w, 1, 3));
        assert_true(pool_volume(w) == 0);
        const struct account a = account_of(w);
        assert_near(a.out, CELLS * 0.25 * AREA, 1e-15, 0);
        assert_true(a.in == 0 && fabs(a.error) <= 1e-15);
        cd_water_destroy(w);
    }
}

/* What float32 rounds off a source is handed on, to cells that are wet: on dry land it would be a film. */
static void rounding_of_a_source_does_not_wet_a_drain(void** state) {
    (void)state;
    cd_water* w = lake(CD_FLOAT32, 0.25);
    ok(cd_water_set_gravity(w, 0));
    ok(cd_water_enable_field(w, CD_SOURCE));
    pool_set(w, CD_SOURCE, 2, 3, 1e-9);
    pool_set(w, CD_SOURCE, 3, 3, -1), pool_set(w, CD_DEPTH, 3, 3, 0);
    ok(cd_water_step(w, 1, 1));
    assert_true(pool_get(w, CD_DEPTH, 2, 3) == 0.25 && pool_get(w, CD_DEPTH, 3, 3) == 0);
    cd_water_destroy(w);
}

/* ---- splashes ---- */

static void a_splash_heaps_up_around_what_it_digs_out_and_keeps_the_volume(void** state) {
    (void)state;
    static const double discs[][4] = {{2.2, 2.6, 0.9, 0.2}, {2.2, 2.6, 0, 0.2}, {0, 0, 1.2, 0.5},
                                      {4.5, 2, 1.1, 100},   {2, 2, 0.2, 0.5},   {2, 2, 3, 1e60}};
    for (cd_precision precision = CD_FLOAT32; precision <= CD_FLOAT64; ++precision)
        for (size_t d = 0; d < COUNT(discs); ++d) {
            cd_water* w = lake(precision, 0.5);
            const double x = discs[d][0], y = discs[d][1], radius = discs[d][2], height = discs[d][3];
            const double before = pool_volume(w);
            ok(cd_water_splash(w, x, y, radius, height));
            size_t lower = 0, higher = 0;
            for (size_t k = 0; k < CELLS; ++k) {
                const double depth = pool_get(w, CD_DEPTH, k % NX, k / NX), inside = centre_weight(k, x, y, radius);
                assert_true(depth >= 0);
                if (depth < 0.5) ++lower;
                if (depth > 0.5) ++higher;
                if (inside > 0)
                    assert_near(depth, fmax(0, 0.5 - inside * height), precision ? 1e-14 : 1e-6, precision ? 0 : 0.5);
                else assert_true(depth >= 0.5 || radius < 0.3);
                if (radius > 0.3 && centre_weight(k, x, y, 2 * radius) == 0) assert_true(depth == 0.5);
            }
            assert_true(lower > 0 && higher > 0);
            assert_near(pool_volume(w), before, precision ? 1e-15 : 1e-7, 0);
            const struct account a = account_of(w);
            assert_true(a.in == 0 && a.out == 0);
            cd_water_destroy(w);
        }
}

static void a_splash_without_wet_cells_around_does_nothing(void** state) {
    (void)state;
    cd_water* w = lake(CD_FLOAT64, 0);
    pool_set(w, CD_DEPTH, 4, 3, 1);
    const uint64_t before = hash_of(w);
    ok(cd_water_splash(w, 4.5 * POOL_DX, 3.5 * POOL_DY, 0, 1));
    ok(cd_water_splash(w, 4.5 * POOL_DX, 3.5 * POOL_DY, 0.7, 1));
    ok(cd_water_splash(w, 1, 1, 0.7, 1)); /* dry all round */
    assert_int_equal(hash_of(w), before);
    ok(cd_water_splash(w, 4.5 * POOL_DX, 3.5 * POOL_DY, 0.7, 0));
    assert_int_equal(hash_of(w), before);
    cd_water_destroy(w);
}

static void a_splash_that_would_overflow_is_refused(void** state) {
    (void)state;
    cd_water* w = lake(CD_FLOAT32, 3.4e38);
    refuses(w, cd_water_splash(w, 2.25, 2.625, 1, 3e38), CD_ERROR_VALUE, "height|3e+38");
    cd_water_destroy(w);
}

/* ---- impulses ---- */

/* density area depth dv, over the faces: which of a side that is not closed counts half is not known here, so that all
 * sides are walls or periodic. */
static void an_impulse_adds_up_to_what_was_given(void** state) {
    (void)state;
    static const double discs[][3] = {{2.1, 2.6, 1.3}, {0.1, 0.1, 2}, {4.5, 5.25, 1}, {2.2, 2.7, 0}, {2, 3, 1e60}};
    for (cd_precision precision = CD_FLOAT32; precision <= CD_FLOAT64; ++precision)
        for (int round = 0; round <= 1; ++round)
            for (size_t d = 0; d < COUNT(discs); ++d) {
                cd_water* w = lake(precision, 0);
                ok(cd_water_set_density(w, 800));
                pool_vary(w, CD_DEPTH, 0.5, 0.25, 5);
                if (round) {
                    ok(cd_water_set_side(w, CD_SIDE_X_FIRST, CD_BORDER_PERIODIC, 0, 0));
                    ok(cd_water_set_side(w, CD_SIDE_Y_FIRST, CD_BORDER_PERIODIC, 0, 0));
                }
                double depth[CELLS], momentum[2] = {0, 0}, area = POOL_DX * POOL_DY;
                pool_read(w, CD_DEPTH, depth);
                ok(cd_water_impulse(w, discs[d][0], discs[d][1], discs[d][2], 300, -200));
                for (size_t j = 0; j < NY; ++j)
                    for (size_t i = round ? 0 : 1; i < NX; ++i) {
                        const double mean = (depth[j * NX + i] + depth[j * NX + (i ? i - 1 : NX - 1)]) / 2;
                        momentum[0] += 800 * area * mean * pool_get(w, CD_VELOCITY_X, i, j);
                    }
                for (size_t j = round ? 0 : 1; j < NY; ++j)
                    for (size_t i = 0; i < NX; ++i) {
                        const double mean = (depth[j * NX + i] + depth[(j ? j - 1 : NY - 1) * NX + i]) / 2;
                        momentum[1] += 800 * area * mean * pool_get(w, CD_VELOCITY_Y, i, j);
                    }
                assert_near(momentum[0], 300, precision ? 1e-14 : 1e-6, 0);
                assert_near(momentum[1], -200, precision ? 1e-14 : 1e-6, 0);
                cd_water_destroy(w);
            }
}

static void an_impulse_falls_off_from_its_middle(void** state) {
    (void)state;
    cd_water* w = lake(CD_FLOAT64, 0.5);
    const double x = 2.1, y = 2.6, radius = 1.4;
    ok(cd_water_impulse(w, x, y, radius, 100, 50));
    double sum[2] = {0, 0};
    for (int round = 0; round < 2; ++round) {
        for (size_t j = 0; j < NY; ++j)
            for (size_t i = 1; i < NX; ++i) {
                const double own = weight((double)i * POOL_DX, ((double)j + 0.5) * POOL_DY, x, y, radius);
                if (!round) sum[0] += own;
                else assert_near(pool_get(w, CD_VELOCITY_X, i, j), 100 * own / sum[0] / (500 * AREA), 1e-14, 0);
            }
        for (size_t j = 1; j < NY; ++j)
            for (size_t i = 0; i < NX; ++i) {
                const double own = weight(((double)i + 0.5) * POOL_DX, (double)j * POOL_DY, x, y, radius);
                if (!round) sum[1] += own;
                else assert_near(pool_get(w, CD_VELOCITY_Y, i, j), 50 * own / sum[1] / (500 * AREA), 1e-14, 0);
            }
    }
    cd_water_destroy(w);
}

/* At a shore, too, where the water laps over by a hundredth of its depth: what moves there is half of the last wet cell,
 * as energies count it. */
static void an_impulse_moves_all_the_water_at_a_face(void** state) {
    (void)state;
    cd_water* w;
    double u, moving;
    ok(cd_water_create(2, 1, 1, 1, CD_FLOAT64, NULL, &w));
    pool_set(w, CD_BED, 1, 0, 1.98);
    pool_set(w, CD_DEPTH, 0, 0, 2);
    ok(cd_water_impulse(w, 1, 0.5, 0.5, 300, 0));
    ok(cd_water_read_f64(w, CD_VELOCITY_X, 1, 0, 1, 1, &u, 1));
    ok(cd_water_get_energy(w, &moving, NULL));
    assert_near(u, 300 / 1000.0, 1e-14, 0);
    assert_near(moving, 0.5 * 300 * u, 1e-14, 0);
    cd_water_destroy(w);
}

static void dry_and_closed_faces_take_no_impulse(void** state) {
    (void)state;
    cd_water* w = lake(CD_FLOAT64, 0);
    const uint64_t before = hash_of(w);
    ok(cd_water_impulse(w, 2, 2, 1, 100, 100));
    ok(cd_water_impulse(w, 2, 2, 0, 100, 100));
    assert_int_equal(hash_of(w), before);
    for (size_t j = 0; j < NY; ++j) pool_set(w, CD_DEPTH, 0, j, 1); /* deep by the wall of x */
    pool_fill(w, CD_BED, 2);
    for (size_t j = 0; j < NY; ++j) pool_set(w, CD_BED, 0, j, 0);
    ok(cd_water_impulse(w, 0, 2, 2, 100, 0));
    for (size_t j = 0; j < NY; ++j)
        for (size_t i = 0; i <= NX; ++i) assert_true(pool_get(w, CD_VELOCITY_X, i, j) == 0);
    cd_water_destroy(w);
}

static void acting_never_allocates_but_for_a_source_that_is_off(void** state) {
    (void)state;
    struct heap heap = {0};
    const cd_allocator allocator = heap_allocator(&heap);
    cd_water* w = pool_from(&allocator, NX, NY, CD_FLOAT32);
    pool_fill(w, CD_DEPTH, 1);
    size_t before = heap.allocations;
    ok(cd_water_add_volume(w, 1, 1, 1, 1, NULL));
    ok(cd_water_add_volume_rectangle(w, 1, 1, 2, 2, -1, NULL));
    ok(cd_water_splash(w, 1, 1, 1, 1));
    ok(cd_water_impulse(w, 1, 1, 1, 1, 1));
    assert_int_equal(heap.allocations, before);
    ok(cd_water_add_source(w, 1, 1, 1, 1));
    assert_true(heap.allocations > before);
    before = heap.allocations;
    ok(cd_water_add_source(w, 1, 1, 1, 1));
    ok(cd_water_add_source_rectangle(w, 1, 1, 2, 2, 1));
    assert_int_equal(heap.allocations, before);
    cd_water_destroy(w);
    heap_free(&heap);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_disc_shares_a_volume_out_by_its_weights),
        cmocka_unit_test(a_disc_between_the_centres_is_the_cell_at_its_place),
        cmocka_unit_test(an_absent_cell_hands_its_place_to_the_nearest_one_there),
        cmocka_unit_test(a_rectangle_shares_a_volume_evenly_over_the_cells_there),
        cmocka_unit_test(no_more_is_taken_than_there_is),
        cmocka_unit_test(many_small_volumes_are_accounted_for_in_both_precisions),
        cmocka_unit_test(a_source_is_added_to_the_field_and_runs_until_it_is_overwritten),
        cmocka_unit_test(a_drain_takes_what_is_there_and_no_more),
        cmocka_unit_test(rounding_of_a_source_does_not_wet_a_drain),
        cmocka_unit_test(a_splash_heaps_up_around_what_it_digs_out_and_keeps_the_volume),
        cmocka_unit_test(a_splash_without_wet_cells_around_does_nothing),
        cmocka_unit_test(a_splash_that_would_overflow_is_refused),
        cmocka_unit_test(an_impulse_adds_up_to_what_was_given),
        cmocka_unit_test(an_impulse_falls_off_from_its_middle),
        cmocka_unit_test(an_impulse_moves_all_the_water_at_a_face),
        cmocka_unit_test(dry_and_closed_faces_take_no_impulse),
        cmocka_unit_test(acting_never_allocates_but_for_a_source_that_is_off),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
