/* What a water holds: no more than its planes need, and what each feature adds. And what is measured of it. */
#include <math.h>

#include "check.h"
#include "pool.h"

enum { NX = 127, NY = 127, FACES = (NX + 1) * (NY + 1), SLACK = 1 << 16 };

static size_t bytes_of(const cd_water* w) {
    size_t bytes = 0;
    ok(cd_water_get_memory(w, &bytes));
    return bytes;
}

/* Depth, bed and two velocities, and what the lines of a sweep that are worked on together need. */
static void a_plain_water_holds_four_planes_and_little_else(void** state) {
    (void)state;
    for (cd_precision precision = CD_FLOAT32; precision <= CD_FLOAT64; ++precision) {
        const size_t each = precision ? sizeof(double) : sizeof(float);
        cd_water* w = pool(NX, NY, precision);
        assert_true(bytes_of(w) >= 4 * FACES * each);
        assert_true(bytes_of(w) <= 4 * FACES * each * 5 / 4 + 4 * SLACK);
        cd_water_destroy(w);
    }
}

static void a_field_adds_a_plane_and_gives_it_back(void** state) {
    (void)state;
    for (cd_precision precision = CD_FLOAT32; precision <= CD_FLOAT64; ++precision) {
        cd_water* w = pool(NX, NY, precision);
        const size_t plain = bytes_of(w);
        for (cd_field field = CD_MASK; field <= CD_WALL_Y; ++field) {
            if (field >= CD_DEPTH && field <= CD_VELOCITY_Y) continue;
            const int is_bits = field == CD_MASK || field >= CD_WALL_X;
            const size_t each = is_bits ? 1 : precision ? sizeof(double) : sizeof(float);
            ok(cd_water_enable_field(w, field));
            assert_true(bytes_of(w) - plain >= FACES * each && bytes_of(w) - plain <= FACES * each * 5 / 4);
            ok(cd_water_disable_field(w, field));
            assert_int_equal(bytes_of(w), plain);
        }
        cd_water_destroy(w);
    }
}

static void what_a_choice_costs_is_given_back_with_it(void** state) {
    (void)state;
    cd_water* w = pool(NX, NY, CD_FLOAT32);
    const size_t plain = bytes_of(w);
    ok(cd_water_set_momentum(w, CD_MOMENTUM_ADVECTED));
    const size_t advected = bytes_of(w);
    assert_true(advected > plain);
    ok(cd_water_set_momentum(w, CD_MOMENTUM_LINEAR));
    assert_int_equal(bytes_of(w), plain);
    ok(cd_water_set_method(w, CD_METHOD_SYMPLECTIC_EULER));
    ok(cd_water_set_method(w, CD_METHOD_IMPLICIT));
    assert_int_equal(bytes_of(w), plain);
    cd_water_destroy(w);
}

static void dry_land_is_not_solved(void** state) {
    (void)state;
    for (cd_momentum momentum = CD_MOMENTUM_LINEAR; momentum <= CD_MOMENTUM_ADVECTED; ++momentum) {
        cd_water* w = pool(NX, NY, CD_FLOAT32);
        uint64_t count;
        ok(cd_water_set_momentum(w, momentum));
        ok(cd_water_step(w, 0.01, 5));
        ok(cd_water_get_factorizations(w, &count));
        assert_int_equal(count, 0);
        pool_set(w, CD_DEPTH, 3, 2, 1e-3);
        ok(cd_water_step(w, 0.01, 1));
        ok(cd_water_get_factorizations(w, &count));
        assert_int_equal(count, 2); /* along x and y */
        cd_water_destroy(w);
    }
}

/* ---- measuring ---- */

static void a_lake_is_measured_as_it_lies(void** state) {
    (void)state;
    enum { COLUMNS = 8, ROWS = 4 };
    const double area = POOL_DX * POOL_DY, speed = sqrt(9.81 * 0.5);
    cd_water* w = pool(COLUMNS, ROWS, CD_FLOAT64);
    double kinetic, potential, number;
    pool_fill(w, CD_BED, -2);
    pool_fill(w, CD_DEPTH, 0.5);
    assert_near(pool_volume(w), COLUMNS * ROWS * 0.5 * area, 1e-15, 0);
    ok(cd_water_get_wet_area(w, &number));
    assert_near(number, COLUMNS * ROWS * area, 1e-15, 0);
    ok(cd_water_get_energy(w, &kinetic, &potential));
    assert_true(kinetic == 0);
    assert_near(potential, 1000 * 9.81 * COLUMNS * ROWS * area * 0.5 * -1.75, 1e-14, 0);
    ok(cd_water_get_courant(w, 0.25, &number));
    assert_near(number, speed * 0.25 / POOL_DX, 1e-14, 0); /* along x, whose cells are shorter */
    ok(cd_water_stable_dt(w, &number));
    assert_near(number, POOL_DX / speed, 1e-14, 0);
    pool_set(w, CD_VELOCITY_X, 3, 2, -2);
    pool_set(w, CD_VELOCITY_Y, 3, 2, 1);
    ok(cd_water_get_energy(w, &kinetic, NULL));
    assert_near(kinetic, 500 * area * 0.5 * (4 + 1), 1e-14, 0);
    ok(cd_water_get_courant(w, 0.25, &number));
    assert_near(number, (2 + speed) * 0.25 / POOL_DX, 1e-14, 0);
    pool_set(w, CD_DEPTH, 0, 0, 0);
    ok(cd_water_get_wet_area(w, &number));
    assert_near(number, (COLUMNS * ROWS - 1) * area, 1e-15, 0);
    cd_water_destroy(w);
}

static void the_face_that_closes_a_ring_counts_once(void** state) {
    (void)state;
    cd_water* w = pool(5, 3, CD_FLOAT64);
    double kinetic;
    pool_fill(w, CD_DEPTH, 0.5);
    ok(cd_water_set_side(w, CD_SIDE_X_FIRST, CD_BORDER_PERIODIC, 0, 0));
    for (size_t face = 0; face < 5; face += 4) {
        pool_fill(w, CD_VELOCITY_X, 0);
        pool_set(w, CD_VELOCITY_X, face, 1, 3);
        ok(cd_water_get_energy(w, &kinetic, NULL));
        assert_near(kinetic, 500 * POOL_DX * POOL_DY * 0.5 * 9, 1e-14, 0);
    }
    cd_water_destroy(w);
}

static void an_open_side_is_as_deep_as_both_sides_in_the_mean(void** state) {
    (void)state;
    cd_water* w = pool(1, 1, CD_FLOAT64); /* a cell between two walls along y */
    double dt;
    pool_fill(w, CD_DEPTH, 0.5);
    for (double level = 0.1; level < 9; level *= 3) {
        ok(cd_water_set_side(w, CD_SIDE_X_FIRST, CD_BORDER_OPEN, level, 0));
        ok(cd_water_stable_dt(w, &dt));
        assert_near(dt, 2 * POOL_DX / sqrt(2 * 9.81 * (0.5 + level) / 2), 1e-14, 0);
    }
    cd_water_destroy(w);
}

static void without_gravity_nothing_swings(void** state) {
    (void)state;
    cd_water* w = pool_of(0, 8, 4, CD_FLOAT32, 2);
    double dt, courant;
    ok(cd_water_set_gravity(w, 0));
    ok(cd_water_stable_dt(w, &dt));
    assert_true(dt == INFINITY);
    pool_fill(w, CD_DEPTH, 1);
    ok(cd_water_get_courant(w, 0, &courant));
    assert_true(courant == 0);
    cd_water_destroy(w);
}

/* A single deep cell over a dry bed would give more than it has in one long step. */
static void what_was_held_back_is_told_of_the_last_call(void** state) {
    (void)state;
    cd_water* w = pool(8, 4, CD_FLOAT64);
    uint64_t cells;
    double volume, error;
    pool_fill(w, CD_DEPTH, 1);
    ok(cd_water_step(w, 0.01, 3));
    ok(cd_water_get_limited(w, &cells, &volume));
    assert_true(cells == 0 && volume == 0);
    pool_fill(w, CD_DEPTH, 0);
    pool_set(w, CD_DEPTH, 4, 2, 1);
    pool_set(w, CD_VELOCITY_X, 4, 2, -50);
    pool_set(w, CD_VELOCITY_X, 5, 2, 50);
    ok(cd_water_step(w, 0.5, 1));
    ok(cd_water_get_limited(w, &cells, &volume));
    assert_true(cells > 0 && volume > 0);
    ok(cd_water_get_account(w, NULL, NULL, NULL, &error));
    assert_true(fabs(error) < 1e-14);
    cd_water_destroy(w);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_plain_water_holds_four_planes_and_little_else),
        cmocka_unit_test(a_field_adds_a_plane_and_gives_it_back),
        cmocka_unit_test(what_a_choice_costs_is_given_back_with_it),
        cmocka_unit_test(dry_land_is_not_solved),
        cmocka_unit_test(a_lake_is_measured_as_it_lies),
        cmocka_unit_test(the_face_that_closes_a_ring_counts_once),
        cmocka_unit_test(an_open_side_is_as_deep_as_both_sides_in_the_mean),
        cmocka_unit_test(without_gravity_nothing_swings),
        cmocka_unit_test(what_was_held_back_is_told_of_the_last_call),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
