/* Fields of a water: what is written is what is read, wherever it lies, and what follows from a write. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "check.h"
#include "pool.h"
#include "scene.h"

enum { NX = 7, NY = 5, MOST = (NX + 1) * (NY + 1) };

static const cd_field numbers[] = {CD_DEPTH,  CD_BED,      CD_VELOCITY_X, CD_VELOCITY_Y,
                                   CD_SOURCE, CD_PRESSURE, CD_FORCE_X,    CD_FORCE_Y};
static const cd_field bits[] = {CD_MASK, CD_WALL_X, CD_WALL_Y};

/* All sides open, so that every face moves, and every field on. */
static cd_water* open_pool(cd_precision precision) {
    cd_water* w = pool(NX, NY, precision);
    for (cd_side side = CD_SIDE_X_FIRST; side <= CD_SIDE_Y_LAST; ++side)
        ok(cd_water_set_side(w, side, CD_BORDER_OPEN, 0, 0));
    for (cd_field field = CD_MASK; field <= CD_WALL_Y; ++field) ok(cd_water_enable_field(w, field));
    return w;
}

static double good_value(cd_field field, uint64_t* seed) {
    const double noise = scene_noise(seed);
    return field == CD_DEPTH ? fabs(noise) : noise;
}

static double rounded(double value, cd_precision precision) {
    return precision == CD_FLOAT32 ? (double)(float)value : value;
}

static void what_is_written_over_any_rectangle_is_read_and_nothing_beside_it_changes(void** state) {
    (void)state;
    uint64_t seed = 1;
    for (cd_precision precision = CD_FLOAT32; precision <= CD_FLOAT64; ++precision)
        for (size_t f = 0; f < COUNT(numbers); ++f) {
            cd_water* w = open_pool(precision);
            const cd_field field = numbers[f];
            const struct pool_extent all = pool_extent(w, field);
            double wanted[MOST] = {0}, got[MOST];
            for (int round = 0; round < 60; ++round) {
                const size_t x = (size_t)round % all.columns, y = (size_t)round * 7 % all.rows;
                const size_t n_x = 1 + (size_t)round * 5 % (all.columns - x), n_y = 1 + (size_t)round % (all.rows - y);
                double doubles[MOST];
                float floats[MOST];
                for (size_t k = 0; k < n_x * n_y; ++k) {
                    doubles[k] = good_value(field, &seed);
                    floats[k] = (float)doubles[k];
                    wanted[(y + k / n_x) * all.columns + x + k % n_x] =
                        round % 2 ? rounded(doubles[k], precision) : (double)floats[k];
                }
                if (round % 2) ok(cd_water_write_f64(w, field, x, y, n_x, n_y, doubles, n_x * n_y));
                else ok(cd_water_write_f32(w, field, x, y, n_x, n_y, floats, n_x * n_y));
                pool_read(w, field, got);
                assert_same_bits(got, wanted, all.count);
                ok(cd_water_read_f32(w, field, x, y, n_x, n_y, floats, n_x * n_y));
                for (size_t k = 0; k < n_x * n_y; ++k)
                    assert_true(floats[k] == (float)wanted[(y + k / n_x) * all.columns + x + k % n_x]);
            }
            cd_water_destroy(w);
        }
}

static void bits_are_written_and_read_like_numbers(void** state) {
    (void)state;
    for (size_t f = 0; f < COUNT(bits); ++f) {
        cd_water* w = open_pool(CD_FLOAT32);
        const struct pool_extent all = pool_extent(w, bits[f]);
        double wanted[MOST], got[MOST];
        for (size_t k = 0; k < all.count; ++k) wanted[k] = k * k % 7 < 4;
        pool_write(w, bits[f], wanted);
        pool_read(w, bits[f], got);
        assert_same_bits(got, wanted, all.count);
        const float three[3] = {1, 0, 1};
        float back[3];
        ok(cd_water_write_f32(w, bits[f], 2, 1, 1, 3, three, 3));
        ok(cd_water_read_f32(w, bits[f], 2, 1, 1, 3, back, 3));
        assert_same_bits(back, three, 3);
        cd_water_destroy(w);
    }
}

static void an_empty_rectangle_changes_nothing(void** state) {
    (void)state;
    cd_water* w = pool_of(POOL_EVERYTHING, NX, NY, CD_FLOAT64, 3);
    const uint64_t before = hash_of(w);
    for (cd_field field = CD_MASK; field <= CD_WALL_Y; ++field) {
        const struct pool_extent all = pool_extent(w, field);
        ok(cd_water_write_f64(w, field, 0, 0, 0, all.rows, NULL, 0));
        ok(cd_water_write_f32(w, field, all.columns, all.rows, 0, 0, NULL, 0));
        ok(cd_water_read_f64(w, field, 1, all.rows, all.columns - 1, 0, NULL, 0));
    }
    assert_int_equal(hash_of(w), before);
    cd_water_destroy(w);
}

static void minus_zero_is_no_depth(void** state) {
    (void)state;
    cd_water* w = pool(NX, NY, CD_FLOAT64);
    const double minus = -0.0;
    ok(cd_water_write_f64(w, CD_DEPTH, 1, 1, 1, 1, &minus, 1));
    ok(cd_water_write_f64(w, CD_SURFACE, 2, 1, 1, 1, &minus, 1));
    assert_false(signbit(pool_get(w, CD_DEPTH, 1, 1)));
    assert_false(signbit(pool_get(w, CD_DEPTH, 2, 1)));
    cd_water_destroy(w);
}

/* ---- views ---- */

static void a_view_shows_what_a_read_gives_and_follows_writes_and_steps(void** state) {
    (void)state;
    for (size_t scene = POOL_EVERYTHING; scene < POOL_EVERYTHING + 2; ++scene) /* and its long steps */
        for (cd_precision precision = CD_FLOAT32; precision <= CD_FLOAT64; ++precision) {
            cd_water* w = pool_of(scene, NX, NY, precision, 2);
            for (size_t f = 0; f < COUNT(numbers); ++f) {
                const struct pool_extent all = pool_extent(w, numbers[f]);
                const void *data = NULL, *again = NULL;
                size_t x_stride, y_stride;
                ok(cd_water_view(w, numbers[f], &data, &x_stride, &y_stride));
                assert_true(x_stride >= (precision ? sizeof(double) : sizeof(float)));
                for (int round = 0; round < 2; ++round) {
                    double values[MOST];
                    pool_read(w, numbers[f], values);
                    for (size_t k = 0; k < all.count; ++k) {
                        const char* at = (const char*)data + k % all.columns * x_stride + k / all.columns * y_stride;
                        const double seen =
                            precision ? *(const double*)(const void*)at : (double)*(const float*)(const void*)at;
                        assert_true(seen == values[k]);
                    }
                    pool_step(w, pools[scene].dt, 1);
                }
                ok(cd_water_enable_field(w, CD_SOURCE)); /* on already */
                ok(cd_water_view(w, numbers[f], &again, &x_stride, &y_stride));
                assert_ptr_equal(again, data);
            }
            cd_water_destroy(w);
        }
}

/* ---- surface ---- */

static void the_surface_is_bed_and_depth(void** state) {
    (void)state;
    for (cd_precision precision = CD_FLOAT32; precision <= CD_FLOAT64; ++precision) {
        cd_water* w = pool_of(0, NX, NY, precision, 3);
        double bed[MOST], depth[MOST], surface[MOST];
        pool_read(w, CD_BED, bed);
        pool_read(w, CD_DEPTH, depth);
        pool_read(w, CD_SURFACE, surface);
        for (size_t k = 0; k < NX * NY; ++k) assert_true(surface[k] == bed[k] + depth[k]);
        cd_water_destroy(w);
    }
}

static void a_surface_that_is_written_becomes_depth_or_leaves_the_bed_dry(void** state) {
    (void)state;
    for (cd_precision precision = CD_FLOAT32; precision <= CD_FLOAT64; ++precision) {
        cd_water* w = pool_of(0, NX, NY, precision, 3);
        double bed[MOST], before[MOST], velocity[2][MOST];
        ok(cd_water_enable_field(w, CD_MASK));
        pool_set(w, CD_MASK, 1, 1, 0);
        pool_read(w, CD_BED, bed);
        pool_read(w, CD_DEPTH, before);
        pool_read(w, CD_VELOCITY_X, velocity[0]);
        double level[6 * 4];
        for (size_t k = 0; k < 24; ++k) level[k] = -0.25 + 0.01 * (double)k;
        ok(cd_water_write_f64(w, CD_SURFACE, 1, 1, 6, 4, level, 24));
        for (size_t j = 0; j < NY; ++j)
            for (size_t i = 0; i < NX; ++i) {
                const size_t k = j * NX + i;
                double depth = before[k];
                if (i >= 1 && j >= 1) depth = fmax(0, level[(j - 1) * 6 + i - 1] - bed[k]);
                if (i == 1 && j == 1) depth = 0;
                assert_true(pool_get(w, CD_DEPTH, i, j) == rounded(depth, precision));
            }
        pool_read(w, CD_VELOCITY_X, velocity[1]);
        assert_same_bits(velocity[0], velocity[1], (NX + 1) * NY);
        cd_water_destroy(w);
    }
}

/* ---- bed ---- */

struct account {
    double initial, in, out, error;
};

static struct account account_of(const cd_water* w) {
    struct account a;
    ok(cd_water_get_account(w, &a.initial, &a.in, &a.out, &a.error));
    return a;
}

static void a_bed_lifts_the_water_and_the_account_stays(void** state) {
    (void)state;
    for (cd_precision precision = CD_FLOAT32; precision <= CD_FLOAT64; ++precision) {
        cd_water* w = pool_of(POOL_TIDE, NX, NY, precision, 3);
        double depth[2][MOST];
        const struct account before = account_of(w);
        pool_read(w, CD_DEPTH, depth[0]);
        pool_vary(w, CD_BED, 0.5, 3, 40);
        pool_read(w, CD_DEPTH, depth[1]);
        const struct account after = account_of(w);
        assert_same_bits(depth[0], depth[1], NX * NY);
        assert_memory_equal(&before, &after, sizeof before);
        cd_water_destroy(w);
    }
}

static void a_bed_that_keeps_the_surface_takes_or_makes_room_and_accounts_for_it(void** state) {
    (void)state;
    for (cd_precision precision = CD_FLOAT32; precision <= CD_FLOAT64; ++precision) {
        const double exactly = precision ? 1e-14 : 1e-6;
        cd_water* w = pool_of(POOL_TIDE, NX, NY, precision, 3);
        ok(cd_water_set_bed_rule(w, CD_BED_KEEPS_SURFACE));
        ok(cd_water_restart_account(w));
        double surface[2][MOST], depth[MOST], bed[MOST];
        const double volume = pool_volume(w);
        pool_read(w, CD_SURFACE, surface[0]);
        pool_read(w, CD_DEPTH, depth);
        pool_vary(w, CD_BED, -0.2, 0.5, 41); /* cell by cell */
        pool_read(w, CD_SURFACE, surface[1]);
        pool_read(w, CD_BED, bed);
        size_t dried = 0, wet = 0;
        for (size_t k = 0; k < NX * NY; ++k) {
            const double now = pool_get(w, CD_DEPTH, k % NX, k / NX);
            if (depth[k] == 0) assert_true(now == 0); /* dry cells stay dry */
            else if (bed[k] >= surface[0][k]) assert_true(now == 0), ++dried;
            else assert_near(surface[1][k], surface[0][k], exactly, 1), ++wet;
        }
        assert_true(dried > 0 && wet > 5);
        const struct account a = account_of(w);
        assert_true(a.initial == volume && a.in > 0 && a.out > 0);
        assert_near(a.initial + a.in - a.out, pool_volume(w), 1e-14, 0);
        assert_true(fabs(a.error) <= 1e-14 * volume * NX);
        cd_water_destroy(w);
    }
}

/* ---- account ---- */

static void writing_depth_surface_or_mask_starts_the_account_anew_and_nothing_else_does(void** state) {
    (void)state;
    for (cd_field field = CD_MASK; field <= CD_WALL_Y; ++field) {
        cd_water* w = pool_of(POOL_EVERYTHING, NX, NY, CD_FLOAT64, 5);
        ok(cd_water_set_bed_rule(w, CD_BED_LIFTS_WATER));
        const struct account before = account_of(w);
        assert_true(before.in > 0 && before.out > 0);
        pool_set(w, field, 3, 2, pool_get(w, field, 3, 2));
        const struct account after = account_of(w);
        if (field == CD_DEPTH || field == CD_SURFACE || field == CD_MASK) {
            assert_true(after.initial == pool_volume(w) && after.in == 0 && after.out == 0 && after.error == 0);
        } else {
            assert_memory_equal(&before, &after, sizeof before);
        }
        ok(cd_water_restart_account(w));
        const struct account anew = account_of(w);
        assert_true(anew.initial == pool_volume(w) && anew.in == 0 && anew.out == 0 && anew.error == 0);
        cd_water_destroy(w);
    }
}

/* ---- mask and walls ---- */

static void a_cell_that_is_taken_away_loses_its_water_and_closes_its_faces(void** state) {
    (void)state;
    cd_water* w = open_pool(CD_FLOAT64);
    pool_fill(w, CD_DEPTH, 0.5);
    pool_fill(w, CD_VELOCITY_X, 1);
    pool_fill(w, CD_VELOCITY_Y, 2);
    pool_set(w, CD_MASK, 3, 2, 0);
    assert_true(pool_get(w, CD_DEPTH, 3, 2) == 0);
    assert_near(pool_volume(w), (NX * NY - 1) * 0.5 * POOL_DX * POOL_DY, 1e-15, 0);
    for (size_t j = 0; j < NY; ++j)
        for (size_t i = 0; i <= NX; ++i)
            assert_true(pool_get(w, CD_VELOCITY_X, i, j) == (j == 2 && (i == 3 || i == 4) ? 0 : 1));
    for (size_t j = 0; j <= NY; ++j)
        for (size_t i = 0; i < NX; ++i)
            assert_true(pool_get(w, CD_VELOCITY_Y, i, j) == (i == 3 && (j == 2 || j == 3) ? 0 : 2));
    pool_set(w, CD_MASK, 3, 2, 1); /* back again, dry */
    assert_true(pool_get(w, CD_DEPTH, 3, 2) == 0 && pool_get(w, CD_VELOCITY_X, 3, 2) == 0);
    pool_set(w, CD_VELOCITY_X, 3, 2, 1);
    pool_set(w, CD_MASK, 0, 4, 0); /* at two sides */
    assert_true(pool_get(w, CD_VELOCITY_X, 0, 4) == 0 && pool_get(w, CD_VELOCITY_Y, 0, 5) == 0);
    cd_water_destroy(w);
}

static void a_wall_stops_the_water_that_crosses_it_and_none_counts_on_a_side(void** state) {
    (void)state;
    cd_water* w = open_pool(CD_FLOAT64);
    pool_fill(w, CD_VELOCITY_X, 1);
    pool_fill(w, CD_VELOCITY_Y, 2);
    for (size_t i = 0; i <= NX; ++i) pool_set(w, CD_WALL_X, i, 1, 1);
    for (size_t j = 0; j <= NY; ++j) pool_set(w, CD_WALL_Y, 1, j, 1);
    for (size_t i = 0; i <= NX; ++i) assert_true(pool_get(w, CD_VELOCITY_X, i, 1) == (i == 0 || i == NX ? 1 : 0));
    for (size_t j = 0; j <= NY; ++j) assert_true(pool_get(w, CD_VELOCITY_Y, 1, j) == (j == 0 || j == NY ? 2 : 0));
    assert_true(pool_get(w, CD_VELOCITY_X, 3, 2) == 1 && pool_get(w, CD_VELOCITY_Y, 3, 2) == 2);
    cd_water_destroy(w);
}

/* ---- periodic sides ---- */

static void the_first_and_the_last_face_of_a_periodic_line_are_one(void** state) {
    (void)state;
    static const cd_field along_x[] = {CD_VELOCITY_X, CD_FORCE_X, CD_WALL_X};
    static const cd_field along_y[] = {CD_VELOCITY_Y, CD_FORCE_Y, CD_WALL_Y};
    for (size_t f = 0; f < 3; ++f) {
        cd_water* w = open_pool(CD_FLOAT64);
        ok(cd_water_set_side(w, CD_SIDE_X_FIRST, CD_BORDER_PERIODIC, 0, 0));
        ok(cd_water_set_side(w, CD_SIDE_Y_FIRST, CD_BORDER_PERIODIC, 0, 0));
        pool_set(w, along_x[f], 0, 1, 1);
        pool_set(w, along_x[f], NX, 3, 1);
        pool_set(w, along_y[f], 2, 0, 1);
        pool_set(w, along_y[f], 4, NY, 1);
        for (size_t j = 0; j < NY; ++j) {
            const double wanted = j == 1 || j == 3;
            assert_true(pool_get(w, along_x[f], 0, j) == wanted && pool_get(w, along_x[f], NX, j) == wanted);
        }
        for (size_t i = 0; i < NX; ++i) {
            const double wanted = i == 2 || i == 4;
            assert_true(pool_get(w, along_y[f], i, 0) == wanted && pool_get(w, along_y[f], i, NY) == wanted);
        }
        double row[NX + 1]; /* of the two in one write, the last holds */
        for (size_t i = 0; i <= NX; ++i) row[i] = along_x[f] == CD_WALL_X ? i == 0 : (double)i;
        if (along_x[f] == CD_VELOCITY_X) row[0] = 9;
        ok(cd_water_write_f64(w, along_x[f], 0, 2, NX + 1, 1, row, NX + 1));
        assert_true(pool_get(w, along_x[f], 0, 2) == row[NX] && pool_get(w, along_x[f], NX, 2) == row[NX]);
        pool_step(w, 0.01, 3);
        assert_true(pool_get(w, along_x[f], 0, 2) == pool_get(w, along_x[f], NX, 2));
        cd_water_destroy(w);
    }
}

static void a_wall_on_the_face_that_joins_a_periodic_line_closes_it(void** state) {
    (void)state;
    for (size_t end = 0; end <= NX; end += NX) {
        cd_water* w = open_pool(CD_FLOAT64);
        ok(cd_water_set_side(w, CD_SIDE_X_FIRST, CD_BORDER_PERIODIC, 0, 0));
        pool_fill(w, CD_VELOCITY_X, 1);
        pool_set(w, CD_WALL_X, end, 2, 1);
        assert_true(pool_get(w, CD_VELOCITY_X, 0, 2) == 0 && pool_get(w, CD_VELOCITY_X, NX, 2) == 0);
        assert_true(pool_get(w, CD_VELOCITY_X, 0, 1) == 1 && pool_get(w, CD_VELOCITY_X, NX, 1) == 1);
        cd_water_destroy(w);
    }
}

/* ---- switches ---- */

static void a_field_that_is_switched_on_does_nothing_yet_and_off_is_as_before(void** state) {
    (void)state;
    for (size_t scene = 0; scene < 4; ++scene)
        for (cd_field field = CD_MASK; field <= CD_WALL_Y; ++field) {
            if (field >= CD_DEPTH && field <= CD_VELOCITY_Y) continue;
            double depth[2][MOST];
            for (int with = 0; with <= 1; ++with) {
                cd_water* w = pool_of(scene, NX, NY, CD_FLOAT64, 2);
                const uint64_t before = hash_of(w);
                if (with) ok(cd_water_enable_field(w, field));
                if (with) assert_int_equal(pool_get(w, field, 1, 1), field == CD_MASK);
                pool_step(w, pools[scene].dt, 5);
                pool_read(w, CD_DEPTH, depth[with]);
                cd_water_destroy(w);

                cd_water* other = pool_of(scene, NX, NY, CD_FLOAT64, 2);
                ok(cd_water_enable_field(other, field));
                ok(cd_water_enable_field(other, field));
                assert_int_not_equal(hash_of(other), before);
                ok(cd_water_disable_field(other, field));
                ok(cd_water_disable_field(other, field));
                assert_int_equal(hash_of(other), before);
                cd_water_destroy(other);
            }
            assert_same_bits(depth[0], depth[1], NX * NY);
        }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_is_written_over_any_rectangle_is_read_and_nothing_beside_it_changes),
        cmocka_unit_test(bits_are_written_and_read_like_numbers),
        cmocka_unit_test(an_empty_rectangle_changes_nothing),
        cmocka_unit_test(minus_zero_is_no_depth),
        cmocka_unit_test(a_view_shows_what_a_read_gives_and_follows_writes_and_steps),
        cmocka_unit_test(the_surface_is_bed_and_depth),
        cmocka_unit_test(a_surface_that_is_written_becomes_depth_or_leaves_the_bed_dry),
        cmocka_unit_test(a_bed_lifts_the_water_and_the_account_stays),
        cmocka_unit_test(a_bed_that_keeps_the_surface_takes_or_makes_room_and_accounts_for_it),
        cmocka_unit_test(writing_depth_surface_or_mask_starts_the_account_anew_and_nothing_else_does),
        cmocka_unit_test(a_cell_that_is_taken_away_loses_its_water_and_closes_its_faces),
        cmocka_unit_test(a_wall_stops_the_water_that_crosses_it_and_none_counts_on_a_side),
        cmocka_unit_test(the_first_and_the_last_face_of_a_periodic_line_are_one),
        cmocka_unit_test(a_wall_on_the_face_that_joins_a_periodic_line_closes_it),
        cmocka_unit_test(a_field_that_is_switched_on_does_nothing_yet_and_off_is_as_before),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
