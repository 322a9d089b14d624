/* Which methods go together, what is at a water's sides, and how levels and discharges run on with time. */
#include <math.h>

#include "check.h"
#include "pool.h"

/* ---- methods ---- */

static void a_water_has_no_second_order_stiff_method(void** state) {
    (void)state;
    for (size_t scene = 0; scene < POOLS; ++scene) {
        cd_water* w = pool_of(scene, 5, 4, CD_FLOAT64, 1);
        refuses(w, cd_water_set_method(w, CD_METHOD_STIFF_SECOND), CD_ERROR_UNSUPPORTED, "method|3");
        cd_water_destroy(w);
    }
}

/* ---- sides ---- */

struct side {
    cd_border kind;
    double value, rate;
};

static struct side side_of(const cd_water* w, cd_side which) {
    struct side side = {-1, -1, -1};
    ok(cd_water_get_side(w, which, &side.kind, &side.value, &side.rate));
    return side;
}

static void sides_tell_what_was_set(void** state) {
    (void)state;
    cd_water* w = pool(5, 4, CD_FLOAT32);
    for (cd_side which = CD_SIDE_X_FIRST; which <= CD_SIDE_Y_LAST; ++which)
        for (cd_border kind = CD_BORDER_LEVEL; kind >= CD_BORDER_WALL; --kind) {
            if (kind == CD_BORDER_PERIODIC) continue;
            ok(cd_water_set_side(w, which, kind, -1.5, 0.25));
            const struct side side = side_of(w, which);
            assert_int_equal(side.kind, kind);
            assert_true(side.value == (kind == CD_BORDER_WALL ? 0 : -1.5));
            assert_true(side.rate == (kind == CD_BORDER_WALL ? 0 : 0.25));
            for (cd_side other = CD_SIDE_X_FIRST; other <= CD_SIDE_Y_LAST; ++other)
                if (other != which) assert_int_equal(side_of(w, other).kind, CD_BORDER_WALL);
        }
    cd_water_destroy(w);
}

/* Whatever is at a side, which may change. */
static void sides_keep_the_depth_of_an_inflow(void** state) {
    (void)state;
    static const double depths[] = {1e-6, 0.5, 1e30, 0};
    cd_water* w = pool(5, 4, CD_FLOAT32);
    for (size_t k = 0; k < COUNT(depths); ++k)
        for (cd_side which = CD_SIDE_X_FIRST; which <= CD_SIDE_Y_LAST; ++which) {
            ok(cd_water_set_inflow_depth(w, which, depths[k]));
            for (cd_border kind = CD_BORDER_WALL; kind <= CD_BORDER_LEVEL; ++kind) {
                ok(cd_water_set_side(w, which, kind, 1, 0));
                for (cd_side side = CD_SIDE_X_FIRST; side <= CD_SIDE_Y_LAST; ++side) {
                    double depth = -1;
                    ok(cd_water_get_inflow_depth(w, side, &depth));
                    assert_true(depth == (side <= which ? depths[k] : k > 0 ? depths[k - 1] : 0));
                }
            }
        }
    refuses(w, cd_water_set_inflow_depth(w, 4, 1), CD_ERROR_ENUM, "side|4");
    refuses(w, cd_water_get_inflow_depth(w, -1, &(double){0}), CD_ERROR_ENUM, "side|-1");
    refuses(w, cd_water_get_inflow_depth(w, 0, NULL), CD_ERROR_NULL, "out_depth");
    cd_water_destroy(w);
}

static void the_value_runs_on_with_its_rate_from_when_it_was_set(void** state) {
    (void)state;
    cd_water* w = pool(5, 4, CD_FLOAT64);
    ok(cd_water_step(w, 0.25, 3));
    ok(cd_water_set_side(w, CD_SIDE_X_LAST, CD_BORDER_OPEN, -3, 0.5));
    ok(cd_water_set_side(w, CD_SIDE_Y_FIRST, CD_BORDER_INFLOW, 0, -0.25));
    assert_true(side_of(w, CD_SIDE_X_LAST).value == -3);
    assert_true(side_of(w, CD_SIDE_Y_FIRST).value == 0);
    ok(cd_water_step(w, 0.25, 8));
    assert_true(side_of(w, CD_SIDE_X_LAST).value == -2);
    assert_true(side_of(w, CD_SIDE_Y_FIRST).value == -0.5);
    ok(cd_water_set_side(w, CD_SIDE_X_LAST, CD_BORDER_OPEN, -2, -1));
    ok(cd_water_step(w, 0.5, 2));
    assert_true(side_of(w, CD_SIDE_X_LAST).value == -3);
    cd_water_destroy(w);
}

static void both_sides_of_a_direction_are_periodic_or_neither(void** state) {
    (void)state;
    cd_water* w = pool(5, 4, CD_FLOAT64);
    for (cd_side which = CD_SIDE_X_FIRST; which <= CD_SIDE_Y_LAST; ++which) {
        const cd_side opposite = which ^ 1;
        ok(cd_water_set_side(w, opposite, CD_BORDER_OPEN, 1, 1));
        ok(cd_water_set_side(w, which, CD_BORDER_PERIODIC, 0, 0));
        assert_int_equal(side_of(w, opposite).kind, CD_BORDER_PERIODIC);
        assert_true(side_of(w, opposite).value == 0 && side_of(w, opposite).rate == 0);
        assert_int_not_equal(side_of(w, which ^ 2).kind, CD_BORDER_PERIODIC);
        ok(cd_water_set_side(w, opposite, CD_BORDER_OPEN, 2, 0));
        assert_int_equal(side_of(w, which).kind, CD_BORDER_WALL);
        assert_int_equal(side_of(w, opposite).kind, CD_BORDER_OPEN);
        ok(cd_water_set_side(w, opposite, CD_BORDER_WALL, 0, 0));
    }
    cd_water_destroy(w);
}

static void a_side_that_becomes_a_wall_stops_the_water_at_it_and_no_other(void** state) {
    (void)state;
    for (cd_side which = CD_SIDE_X_FIRST; which <= CD_SIDE_Y_LAST; ++which) {
        cd_water* w = pool(5, 4, CD_FLOAT64);
        for (cd_side side = CD_SIDE_X_FIRST; side <= CD_SIDE_Y_LAST; ++side)
            ok(cd_water_set_side(w, side, CD_BORDER_OPEN, 1, 0));
        pool_fill(w, CD_VELOCITY_X, 0.5);
        pool_fill(w, CD_VELOCITY_Y, 0.25);
        ok(cd_water_set_side(w, which, CD_BORDER_INFLOW, 0, 0));
        assert_true(pool_get(w, CD_VELOCITY_X, 5, 0) == 0.5); /* water can still cross */
        ok(cd_water_set_side(w, which, CD_BORDER_WALL, 0, 0));
        for (size_t j = 0; j < 4; ++j)
            for (size_t i = 0; i <= 5; ++i) {
                const int closed = i == (which == CD_SIDE_X_FIRST ? 0 : which == CD_SIDE_X_LAST ? 5 : 99);
                assert_true(pool_get(w, CD_VELOCITY_X, i, j) == (closed ? 0 : 0.5));
            }
        for (size_t j = 0; j <= 4; ++j)
            for (size_t i = 0; i < 5; ++i) {
                const int closed = j == (which == CD_SIDE_Y_FIRST ? 0 : which == CD_SIDE_Y_LAST ? 4 : 99);
                assert_true(pool_get(w, CD_VELOCITY_Y, i, j) == (closed ? 0 : 0.25));
            }
        cd_water_destroy(w);
    }
}

static void the_ends_of_a_line_that_is_made_periodic_become_one_face(void** state) {
    (void)state;
    for (int along_y = 0; along_y <= 1; ++along_y) {
        cd_water* w = pool(4, 4, CD_FLOAT64);
        const cd_field velocity = along_y ? CD_VELOCITY_Y : CD_VELOCITY_X, force = along_y ? CD_FORCE_Y : CD_FORCE_X;
        const cd_side first = along_y ? CD_SIDE_Y_FIRST : CD_SIDE_X_FIRST;
        const size_t x = along_y ? 2 : 4, y = along_y ? 4 : 2;   /* the last face of line 2 */
        const size_t x0 = along_y ? 2 : 0, y0 = along_y ? 0 : 2; /* and its first */
        ok(cd_water_set_side(w, first, CD_BORDER_OPEN, 0, 0));
        ok(cd_water_set_side(w, first + 1, CD_BORDER_OPEN, 0, 0));
        ok(cd_water_enable_field(w, force));
        pool_set(w, velocity, x, y, 3);
        pool_set(w, velocity, x0, y0, 1);
        pool_set(w, force, x, y, 6);
        ok(cd_water_set_side(w, first, CD_BORDER_PERIODIC, 0, 0));
        assert_true(pool_get(w, velocity, x, y) == 2 && pool_get(w, velocity, x0, y0) == 2);
        assert_true(pool_get(w, force, x, y) == 3 && pool_get(w, force, x0, y0) == 3);
        cd_water_destroy(w);
    }
}

static void a_wall_at_either_end_stands_on_the_face_that_they_become(void** state) {
    (void)state;
    for (size_t end = 0; end <= 4; end += 4) {
        cd_water* w = pool(4, 4, CD_FLOAT32);
        ok(cd_water_enable_field(w, CD_WALL_X));
        pool_set(w, CD_WALL_X, end, 1, 1);
        ok(cd_water_set_side(w, CD_SIDE_X_LAST, CD_BORDER_PERIODIC, 0, 0));
        assert_true(pool_get(w, CD_WALL_X, 0, 1) == 1 && pool_get(w, CD_WALL_X, 4, 1) == 1);
        assert_true(pool_get(w, CD_WALL_X, 0, 2) == 0 && pool_get(w, CD_WALL_X, 4, 2) == 0);
        const double one = 1;
        refuses(w, cd_water_write_f64(w, CD_VELOCITY_X, 4 - end, 1, 1, 1, &one, 1), CD_ERROR_VALUE, "values|0|1");
        cd_water_destroy(w);
    }
}

static void what_comes_in_and_goes_out_at_sides_is_accounted_for(void** state) {
    (void)state;
    for (cd_precision precision = CD_FLOAT32; precision <= CD_FLOAT64; ++precision)
        for (cd_side which = CD_SIDE_X_FIRST; which <= CD_SIDE_Y_LAST; ++which) {
            cd_water* w = pool(6, 4, precision);
            pool_fill(w, CD_DEPTH, 1);
            const double length = which < CD_SIDE_Y_FIRST ? 4 * POOL_DY : 6 * POOL_DX;
            double in, gone, error;
            ok(cd_water_set_side(w, which, CD_BORDER_INFLOW, 0.125, 0));
            ok(cd_water_step(w, 0.05, 40)); /* 2 s */
            ok(cd_water_get_account(w, NULL, &in, &gone, &error));
            assert_near(in, 0.125 * length * 2, 1e-12, 0);
            assert_true(gone == 0);
            assert_near(pool_volume(w), 18 * POOL_DX * POOL_DY + 6 * POOL_DX * POOL_DY + in, precision ? 1e-14 : 1e-6,
                        0);
            assert_true(fabs(error) <= (precision ? 1e-13 : 1e-5));
            ok(cd_water_set_side(w, which, CD_BORDER_INFLOW, -0.0625, 0));
            ok(cd_water_step(w, 0.05, 40));
            ok(cd_water_get_account(w, NULL, &in, &gone, &error));
            assert_near(in, 0.125 * length * 2, 1e-12, 0);
            assert_near(gone, 0.0625 * length * 2, 1e-12, 0);
            assert_true(fabs(error) <= (precision ? 1e-13 : 1e-5));
            cd_water_destroy(w);
        }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_water_has_no_second_order_stiff_method),
        cmocka_unit_test(sides_tell_what_was_set),
        cmocka_unit_test(sides_keep_the_depth_of_an_inflow),
        cmocka_unit_test(the_value_runs_on_with_its_rate_from_when_it_was_set),
        cmocka_unit_test(both_sides_of_a_direction_are_periodic_or_neither),
        cmocka_unit_test(a_side_that_becomes_a_wall_stops_the_water_at_it_and_no_other),
        cmocka_unit_test(the_ends_of_a_line_that_is_made_periodic_become_one_face),
        cmocka_unit_test(a_wall_at_either_end_stands_on_the_face_that_they_become),
        cmocka_unit_test(what_comes_in_and_goes_out_at_sides_is_accounted_for),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
