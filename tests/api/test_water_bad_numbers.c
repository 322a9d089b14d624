/* Numbers of water.h that are out of range together with others, or in a state of the water. What each may be by itself
 * is tried by tests/bindings/check_ranges.py; for the fields see test_water_bad_fields.c. */
#include <math.h>

#include "check.h"
#include "heap.h"
#include "pool.h"
#include "refusals.h"

enum { NX = 7, NY = 5 };

static cd_water* w;

static int set_up(void** state) {
    (void)state;
    w = pool_of(POOL_EVERYTHING, NX, NY, CD_FLOAT32, 2);
    ok(cd_water_set_hulls(w, 2, 2, 1));
    ok(cd_water_set_hull(w, 0, 100, 1, 1, NULL, 0));
    return 0;
}

static int tear_down(void** state) {
    (void)state;
    cd_water_destroy(w);
    return 0;
}

static void no_time_is_too_short_for_no_steps(void** state) {
    (void)state;
    refuses_each(w, cd_water_step(w, bad, 0), "dt", not_finite);
    refuses(w, cd_water_step(w, -1, 1), CD_ERROR_VALUE, "dt is -1|0 or in [1e-30, 1e+30]");
}

static void no_side_takes_a_level_or_a_discharge_that_is_no_number(void** state) {
    (void)state;
    static const struct bad_number too_high[] = {{1.0625e30, "1.0625e+30"}, {-1e300, "-1e+300"}};
    for (cd_border kind = CD_BORDER_OPEN; kind <= CD_BORDER_INFLOW; ++kind)
        for (cd_side side = CD_SIDE_X_FIRST; side <= CD_SIDE_Y_LAST; ++side) {
            refuses_each(w, cd_water_set_side(w, side, kind, bad, 0), "value", not_finite);
            refuses_each(w, cd_water_set_side(w, side, kind, 0, bad), "rate", not_finite);
            refuses_each(w, cd_water_set_side(w, side, kind, bad, 0), "value", too_high);
            refuses_each(w, cd_water_set_side(w, side, kind, 0, bad), "rate", too_high);
        }
}

static void no_inflow_takes_a_depth_that_is_none(void** state) {
    (void)state;
    static const struct bad_number bad_depths[] = {{-1, "-1"}, {5e-7, "5e-07"}, {1.0625e30, "1.0625e+30"}};
    for (cd_side side = CD_SIDE_X_FIRST; side <= CD_SIDE_Y_LAST; ++side) {
        refuses_each(w, cd_water_set_inflow_depth(w, side, bad), "depth", not_finite);
        refuses_each(w, cd_water_set_inflow_depth(w, side, bad), "depth", bad_depths);
    }
}

static void a_wall_and_a_periodic_side_take_any_value(void** state) {
    (void)state;
    cd_water* other = pool(3, 3, CD_FLOAT64);
    ok(cd_water_set_side(other, CD_SIDE_X_FIRST, CD_BORDER_PERIODIC, NAN, -INFINITY));
    ok(cd_water_set_side(other, CD_SIDE_Y_FIRST, CD_BORDER_WALL, 1e300, NAN));
    for (cd_side side = CD_SIDE_X_FIRST; side <= CD_SIDE_Y_LAST; ++side) {
        double value = 1, rate = 1;
        ok(cd_water_get_side(other, side, NULL, &value, &rate));
        assert_true(value == 0 && rate == 0);
    }
    cd_water_destroy(other);
}

static void what_the_precision_cannot_hold_changes_nothing(void** state) {
    (void)state;
    cd_water* small = pool(3, 3, CD_FLOAT32);
    pool_fill(small, CD_DEPTH, 1);
    ok(cd_water_enable_field(small, CD_SOURCE));
    refuses(small, cd_water_add_volume(small, 1, 1, 0, 1e40, out.number), CD_ERROR_VALUE, "volume|1e+40");
    refuses(small, cd_water_add_volume(small, 1, 1, 1, 1e41, out.number), CD_ERROR_VALUE, "volume|1e+41");
    refuses(small, cd_water_add_volume_rectangle(small, 0, 0, 3, 3, 1e41, out.number), CD_ERROR_VALUE, "volume|1e+41");
    refuses(small, cd_water_add_source(small, 1, 1, 1, -1e41), CD_ERROR_VALUE, "rate|-1e+41");
    refuses(small, cd_water_add_source_rectangle(small, 0, 0, 3, 3, 1e41), CD_ERROR_VALUE, "rate|1e+41");
    refuses(small, cd_water_impulse(small, 1, 1, 1, 1e45, 0), CD_ERROR_VALUE, "impulse_x|1e+45");
    refuses(small, cd_water_impulse(small, 1, 1, 1, 1, -1e45), CD_ERROR_VALUE, "impulse_y|-1e+45");
    ok(cd_water_disable_field(small, CD_SOURCE));
    refuses(small, cd_water_add_source(small, 1, 1, 1, 1e41), CD_ERROR_VALUE, "rate");
    assert_false(pool_has(small, CD_SOURCE)); /* nor is it switched on */
    ok(cd_water_add_volume(small, 1, 1, 0, 1e38, NULL));
    cd_water_destroy(small);
}

static void no_more_places_are_sampled_than_fit_in_memory(void** state) {
    (void)state;
    static const size_t most[] = {SIZE_MAX, SIZE_MAX / 2 + 3, SIZE_MAX / 4 + 1};
    const double places[2] = {0.5, 0.5};
    for (size_t i = 0; i < COUNT(most); ++i)
        refuses(w, cd_water_sample(w, places, most[i], CD_OUTSIDE_REFUSED, out.number, NULL, NULL, NULL),
                CD_ERROR_RANGE, name_and_size("n", most[i]));
}

static void no_shape_is_made_that_cannot_be(void** state) {
    (void)state;
    struct heap heap = {0}; /* refuses what is too large without trying the machine's memory */
    const cd_allocator allocator = heap_allocator(&heap);
    static const size_t big = (size_t)1 << (sizeof(size_t) == 8 ? 40 : 24);
    static const struct {
        size_t nx, ny;
        cd_status status;
        const char* argument;
        size_t shown;
    } bad[] = {
        {0, 1, CD_ERROR_VALUE, "nx", 0},
        {1, 0, CD_ERROR_VALUE, "ny", 0},
        {0, 0, CD_ERROR_VALUE, "nx", 0},
        {0, SIZE_MAX, CD_ERROR_VALUE, "nx", 0},
        {SIZE_MAX, 1, CD_ERROR_SIZE, "nx", SIZE_MAX},
        {SIZE_MAX - 1, 1, CD_ERROR_SIZE, "nx", SIZE_MAX - 1},
        {1, SIZE_MAX, CD_ERROR_SIZE, "ny", SIZE_MAX},
        {1, SIZE_MAX - 1, CD_ERROR_SIZE, "ny", SIZE_MAX - 1},
        {SIZE_MAX / 2 - 20, 1, CD_ERROR_SIZE, "nx", SIZE_MAX / 2 - 20},
        {SIZE_MAX, SIZE_MAX, CD_ERROR_SIZE, "nx", SIZE_MAX},
        {1, SIZE_MAX / 64, CD_ERROR_SIZE, "ny", SIZE_MAX / 64},
        {SIZE_MAX / 64, 1, CD_ERROR_SIZE, "nx", SIZE_MAX / 64},
    };
    for (cd_precision precision = CD_FLOAT32; precision <= CD_FLOAT64; ++precision) {
        for (size_t i = 0; i < COUNT(bad); ++i)
            refuses(w, cd_water_create(bad[i].nx, bad[i].ny, 1, 1, precision, &allocator, &out.water), bad[i].status,
                    name_and_size(bad[i].argument, bad[i].shown));
        refuses(w, cd_water_create(big, big, 1, 1, precision, &allocator, &out.water), CD_ERROR_SIZE,
                name_and_size("nx", big));
        refuses(w, cd_water_create(big, 1, 1, 1, precision, &allocator, &out.water), CD_ERROR_MEMORY, "");
        refuses(w, cd_water_create(1, big, 1, 1, precision, &allocator, &out.water), CD_ERROR_MEMORY, "");
    }
    heap_free(&heap);
}

static void no_hull_is_made_or_launched_of_numbers_that_do_not_go_together(void** state) {
    (void)state;
    cd_water* none = NULL;
    ok(cd_water_create(2, 2, 1, 1, CD_FLOAT32, NULL, &none));
    refuses(none, cd_water_set_disc(none, 0, 1, 1), CD_ERROR_RANGE, "index|0|no hulls yet|cd_water_set_hulls first");
    cd_water_destroy(none);
    refuses(w, cd_water_set_hull(w, 0, 1, 1, 1, (const double[]){0, -2}, 2), CD_ERROR_VALUE,
            "heights|[1]|-2|or -1 for no plate");
    refuses(w, cd_water_set_hull(w, 0, 1, 1, 1, (const double[]){-1, -1}, 2), CD_ERROR_VALUE, "heights");
    refuses(w, cd_water_set_disc(w, 0, 1, 200), CD_ERROR_VALUE, "radius|200|512 cells"); /* its square is wider */
    refuses(w, cd_water_set_disc(w, 0, 1, 0.9e-60), CD_ERROR_VALUE, "radius is 9e-61|in [1e-60, ");
    refuses(w, cd_water_set_hull(w, 0, 1, 1, 1e-300, NULL, 0), CD_ERROR_VALUE, "width is 1e-300|in [1e-60, ");
    refuses(w, cd_water_launch_hull(w, 0, 1, 1, 0, 0), CD_ERROR_VALUE, "ahead_x|0");
    refuses(w, cd_water_launch_hull(w, 1, 1, 1, 1, 0), CD_ERROR_DISABLED, "index|1|cd_water_set_hull");
    ok(cd_water_set_gravity(w, 0));
    refuses(w, cd_water_launch_hull(w, 0, 1, 1, 1, 0), CD_ERROR_DISABLED, "gravity is 0");
    ok(cd_water_set_gravity(w, 9.81));
    refuses(w, cd_water_set_hull_pose(w, 0, (const double[]){1, 1, 0, 0, 0, 0, 0}, 7), CD_ERROR_VALUE,
            "pose|direction");
}

/* The least and the heaviest hull that a setter takes makes steps, afloat and not. */
static void the_extremes_of_hulls_can_be_stepped(void** state) {
    (void)state;
    static const double gravities[] = {1e-60, 9.81, 1e6};
    refuses(w, cd_water_set_gravity(w, 5e-324), CD_ERROR_VALUE, "gravity|in [1e-60, 1e+06] or 0");
    for (cd_precision precision = CD_FLOAT32; precision <= CD_FLOAT64; ++precision)
        for (int i = 0; i < 6; ++i) {
            const bool heavy = i % 2 != 0;
            cd_water* other = pool(NX, NY, precision);
            pool_fill(other, CD_DEPTH, 1);
            ok(cd_water_set_gravity(other, gravities[i / 2]));
            ok(cd_water_set_hulls(other, 2, 2, 1));
            ok(cd_water_set_hull(other, 0, heavy ? 1e15 : 1e-12, 1e-60, 1e-60, NULL, 0));
            ok(cd_water_set_disc(other, 1, heavy ? 1e15 : 1e-12, 1e-60));
            ok(cd_water_step(other, 0.01, 2));
            ok(cd_water_launch_hull(other, 0, 1, 1, 1, 0));
            ok(cd_water_step(other, 0.01, 2));
            cd_water_destroy(other);
        }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(no_time_is_too_short_for_no_steps),
        cmocka_unit_test(no_side_takes_a_level_or_a_discharge_that_is_no_number),
        cmocka_unit_test(no_inflow_takes_a_depth_that_is_none),
        cmocka_unit_test(a_wall_and_a_periodic_side_take_any_value),
        cmocka_unit_test(what_the_precision_cannot_hold_changes_nothing),
        cmocka_unit_test(no_more_places_are_sampled_than_fit_in_memory),
        cmocka_unit_test(no_shape_is_made_that_cannot_be),
        cmocka_unit_test(no_hull_is_made_or_launched_of_numbers_that_do_not_go_together),
        cmocka_unit_test(the_extremes_of_hulls_can_be_stepped),
    };
    return cmocka_run_group_tests(tests, set_up, tear_down);
}
