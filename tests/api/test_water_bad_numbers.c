/* Numbers that are no numbers, out of range, or none of an enumeration's: every argument of water.h that is passed by
 * value or as an array of numbers, but for the fields (test_water_bad_fields.c). */
#include <math.h>
#include <string.h>

#include "check.h"
#include "heap.h"
#include "pool.h"
#include "refusals.h"

enum { NX = 7, NY = 5 };
#define LENGTH (NX * POOL_DX) /* 3.5 */
#define WIDTH (NY * POOL_DY)  /* 3.75 */

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

static const struct bad_number no_gravity[] = {{1.0625e6, "1.0625e+06"}, {1e300, "1e+300"}};
static const struct bad_number no_density[] = {{1e-7, "1e-07"}, {1.0625e6, "1.0625e+06"}, {1e300, "1e+300"}};
static const struct bad_number no_manning[] = {{1000.5, "1000.5"}, {1e300, "1e+300"}};
static const struct bad_number no_cell[] = {{1e-31, "1e-31"}, {1e31, "1e+31"}, {-0.125, "-0.125"}};

static void no_parameter_takes_a_number_outside_its_range(void** state) {
    (void)state;
    refuses_each(w, cd_water_set_lambda(w, bad), "lambda", not_finite);
    refuses_each(w, cd_water_set_lambda(w, bad), "lambda", not_a_share);
    refuses_each(w, cd_water_set_gravity(w, bad), "gravity", not_finite);
    refuses_each(w, cd_water_set_gravity(w, bad), "gravity", negative);
    refuses_each(w, cd_water_set_gravity(w, bad), "gravity", no_gravity);
    refuses_each(w, cd_water_set_density(w, bad), "density", not_finite);
    refuses_each(w, cd_water_set_density(w, bad), "density", not_positive);
    refuses_each(w, cd_water_set_density(w, bad), "density", no_density);
    refuses_each(w, cd_water_set_drag(w, bad), "drag", not_finite);
    refuses_each(w, cd_water_set_drag(w, bad), "drag", negative);
    refuses_each(w, cd_water_set_drag(w, bad), "drag", too_large);
    refuses_each(w, cd_water_set_manning(w, bad), "manning", not_finite);
    refuses_each(w, cd_water_set_manning(w, bad), "manning", negative);
    refuses_each(w, cd_water_set_manning(w, bad), "manning", no_manning);
}

static void no_step_is_made_of_what_is_no_time(void** state) {
    (void)state;
    refuses_each(w, cd_water_step(w, bad, 1), "dt", not_finite);
    refuses_each(w, cd_water_step(w, bad, 1), "dt", not_positive);
    refuses_each(w, cd_water_step(w, bad, 1), "dt", not_a_step);
    refuses_each(w, cd_water_step(w, bad, 0), "dt", not_finite);
    refuses_each(w, cd_water_get_courant(w, bad, out.number), "dt", not_finite);
    refuses_each(w, cd_water_get_courant(w, bad, out.number), "dt", negative);
    static const struct bad_number no_time[] = {{1e31, "1e+31"}, {-0.125, "-0.125"}};
    refuses_each(w, cd_water_get_courant(w, bad, out.number), "dt", no_time);
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

/* One that takes x, y and radius, and is given them. */
#define refuses_discs(call_at_x, call_at_y, call_of_radius)                                       \
    do {                                                                                          \
        refuses_each(w, call_at_x, "x", not_finite) refuses_each(w, call_at_x, "x", beside_x)     \
            refuses_each(w, call_at_y, "y", not_finite) refuses_each(w, call_at_y, "y", beside_y) \
                refuses_each(w, call_of_radius, "radius", not_finite)                             \
                    refuses_each(w, call_of_radius, "radius", negative)                           \
                        refuses_each(w, call_of_radius, "radius", too_large)                      \
    } while (0)

static void nothing_is_done_beside_the_water(void** state) {
    (void)state;
    static const struct bad_number beside_x[] = {{-0.125, "-0.125"}, {LENGTH + 0.125, "3.625"}, {1e300, "1e+300"}};
    static const struct bad_number beside_y[] = {{-0.125, "-0.125"}, {WIDTH + 0.125, "3.875"}, {1e300, "1e+300"}};
    double* const n = out.number;
    refuses_discs(cd_water_add_volume(w, bad, 1, 1, 0.5, n), cd_water_add_volume(w, 1, bad, 1, 0.5, n),
                  cd_water_add_volume(w, 1, 1, bad, 0.5, n));
    refuses_discs(cd_water_add_source(w, bad, 1, 1, 0.5), cd_water_add_source(w, 1, bad, 1, 0.5),
                  cd_water_add_source(w, 1, 1, bad, 0.5));
    refuses_discs(cd_water_splash(w, bad, 1, 1, 0.5), cd_water_splash(w, 1, bad, 1, 0.5),
                  cd_water_splash(w, 1, 1, bad, 0.5));
    refuses_discs(cd_water_impulse(w, bad, 1, 1, 0.5, 0), cd_water_impulse(w, 1, bad, 1, 0.5, 0),
                  cd_water_impulse(w, 1, 1, bad, 0.5, 0));
}

static const struct bad_number too_much[] = {{1e61, "1e+61"}, {-1e300, "-1e+300"}};

static void no_amount_is_taken_that_is_no_number(void** state) {
    (void)state;
    double* const n = out.number;
    refuses_each(w, cd_water_add_volume(w, 1, 1, 1, bad, n), "volume", not_finite);
    refuses_each(w, cd_water_add_volume(w, 1, 1, 1, bad, n), "volume", too_much);
    refuses_each(w, cd_water_add_volume_rectangle(w, 0, 0, 2, 2, bad, n), "volume", not_finite);
    refuses_each(w, cd_water_add_volume_rectangle(w, 0, 0, 2, 2, bad, n), "volume", too_much);
    refuses_each(w, cd_water_add_source(w, 1, 1, 1, bad), "rate", not_finite);
    refuses_each(w, cd_water_add_source(w, 1, 1, 1, bad), "rate", too_much);
    refuses_each(w, cd_water_add_source_rectangle(w, 0, 0, 2, 2, bad), "rate", not_finite);
    refuses_each(w, cd_water_add_source_rectangle(w, 0, 0, 2, 2, bad), "rate", too_much);
    refuses_each(w, cd_water_splash(w, 1, 1, 1, bad), "height", not_finite);
    refuses_each(w, cd_water_splash(w, 1, 1, 1, bad), "height", negative);
    refuses_each(w, cd_water_splash(w, 1, 1, 1, bad), "height", too_large);
    refuses_each(w, cd_water_impulse(w, 1, 1, 1, bad, 0), "impulse_x", not_finite);
    refuses_each(w, cd_water_impulse(w, 1, 1, 1, 0, bad), "impulse_y", not_finite);
    refuses_each(w, cd_water_impulse(w, 1, 1, 1, bad, 0), "impulse_x", too_much);
    refuses_each(w, cd_water_impulse(w, 1, 1, 1, 0, bad), "impulse_y", too_much);
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

static void no_array_takes_a_place_outside(void** state) {
    (void)state;
    double* const n = out.number;
    for (size_t at = 0; at < 4; ++at)
        for (size_t i = 0; i < COUNT(not_finite); ++i) {
            double places[4] = {0.5, 0.5, 0.5, 0.5};
            places[at] = not_finite[i].value;
            refuses(w, cd_water_sample(w, places, 2, n, n + 2, n + 4, n + 10), CD_ERROR_VALUE,
                    text_of("at|[%zu]|%s", at, not_finite[i].shown));
        }
    const double before[] = {1, -0.125}, behind_x[] = {LENGTH + 0.125, 1}, behind_y[] = {1, WIDTH + 0.125};
    refuses(w, cd_water_sample(w, before, 1, n, NULL, NULL, NULL), CD_ERROR_VALUE, "at|[1]|-0.125");
    refuses(w, cd_water_sample(w, behind_x, 1, n, NULL, NULL, NULL), CD_ERROR_VALUE, "at|[0]|3.625");
    refuses(w, cd_water_sample(w, behind_y, 1, n, NULL, NULL, NULL), CD_ERROR_VALUE, "at|[1]|3.875");
    static const size_t most[] = {SIZE_MAX, SIZE_MAX / 2 + 3, SIZE_MAX / 4 + 1};
    for (size_t i = 0; i < COUNT(most); ++i)
        refuses(w, cd_water_sample(w, before, most[i], n, NULL, NULL, NULL), CD_ERROR_RANGE,
                name_and_size("n", most[i]));
}

static void no_number_is_taken_for_an_enumerator(void** state) {
    (void)state;
    static const int32_t none[] = {-1, 5, 99, INT32_MAX, INT32_MIN};
    for (size_t i = 0; i < COUNT(none); ++i) {
        const int bad = none[i];
        refuses(w, cd_water_create(1, 1, 1, 1, bad, NULL, &out.water), CD_ERROR_ENUM, text_of("precision|%d", bad));
        refuses(w, cd_water_set_method(w, bad), CD_ERROR_ENUM, text_of("method|%d", bad));
        refuses(w, cd_water_set_kernels(w, bad), CD_ERROR_ENUM, text_of("kernels|%d", bad));
        refuses(w, cd_water_set_momentum(w, bad), CD_ERROR_ENUM, text_of("momentum|%d", bad));
        refuses(w, cd_water_set_bed_rule(w, bad), CD_ERROR_ENUM, text_of("rule|%d", bad));
        refuses(w, cd_water_set_side(w, bad, CD_BORDER_WALL, 0, 0), CD_ERROR_ENUM, text_of("side|%d", bad));
        refuses(w, cd_water_set_side(w, CD_SIDE_X_LAST, bad, 0, 0), CD_ERROR_ENUM, text_of("kind|%d", bad));
        refuses(w, cd_water_get_side(w, bad, &out.i32, &out.number[0], &out.number[1]), CD_ERROR_ENUM,
                text_of("side|%d", bad));
        refuses(w, cd_water_set_first(w, bad), CD_ERROR_VALUE, text_of("along_y|%d", bad));
    }
    refuses(w, cd_water_create(1, 1, 1, 1, 2, NULL, &out.water), CD_ERROR_ENUM, "precision|2");
    refuses(w, cd_water_set_momentum(w, 2), CD_ERROR_ENUM, "momentum|2");
    refuses(w, cd_water_set_bed_rule(w, 2), CD_ERROR_ENUM, "rule|2");
    refuses(w, cd_water_set_first(w, 2), CD_ERROR_VALUE, "along_y|2");
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
        refuses_each(w, cd_water_create(2, 2, bad, 1, precision, &allocator, &out.water), "dx", not_finite);
        refuses_each(w, cd_water_create(2, 2, 1, bad, precision, &allocator, &out.water), "dy", not_finite);
        refuses_each(w, cd_water_create(2, 2, bad, 1, precision, &allocator, &out.water), "dx", not_positive);
        refuses_each(w, cd_water_create(2, 2, 1, bad, precision, &allocator, &out.water), "dy", not_positive);
        refuses_each(w, cd_water_create(2, 2, bad, 1, precision, &allocator, &out.water), "dx", no_cell);
        refuses_each(w, cd_water_create(2, 2, 1, bad, precision, &allocator, &out.water), "dy", no_cell);
    }
    heap_free(&heap);
}

static void no_rectangle_of_cells_beyond_the_end_is_taken(void** state) {
    (void)state;
    static const struct {
        size_t first_x, first_y, n_x, n_y;
        const char* text;
    } bad[] = {
        {NX, 0, 1, 1, "~first_x|along x from"}, {SIZE_MAX, 0, 2, 1, "~first_x|along x from"},
        {0, 0, NX + 1, 1, "~n_x|along x from"}, {1, 0, SIZE_MAX, 1, "~n_x|along x from"},
        {0, NY, 1, 1, "~first_y|along y from"}, {0, SIZE_MAX, 1, 2, "~first_y|along y from"},
        {0, 0, 1, NY + 1, "~n_y|along y from"}, {0, 1, 1, SIZE_MAX, "~n_y|along y from"},
    };
    for (size_t i = 0; i < COUNT(bad); ++i) {
        const size_t x = bad[i].first_x, y = bad[i].first_y, n_x = bad[i].n_x, n_y = bad[i].n_y;
        refuses(w, cd_water_add_volume_rectangle(w, x, y, n_x, n_y, 1, out.number), CD_ERROR_RANGE, bad[i].text);
        refuses(w, cd_water_add_source_rectangle(w, x, y, n_x, n_y, 1), CD_ERROR_RANGE, bad[i].text);
    }
}

#define refuses_index(call) refuses(w, call, CD_ERROR_RANGE, "index|2")
#define refuses_counts(call, ...)                                                                   \
    for (size_t i_ = 0; i_ < 3; ++i_) {                                                              \
        const size_t bad = (const size_t[]){0, 5, SIZE_MAX}[i_];                                     \
        refuses(w, call(w, 0, __VA_ARGS__, bad), CD_ERROR_RANGE, name_and_size("count", bad));       \
    }
/* Of an array: each number in turn. */
#define refuses_in(call, from, size, argument, table)                                                \
    for (size_t i_ = 0; i_ < COUNT(table); ++i_)                                                     \
        for (size_t k_ = 0; k_ < (size); ++k_) {                                                     \
            double values[8];                                                                        \
            memcpy(values, from, sizeof values);                                                     \
            values[k_] = (table)[i_].value;                                                          \
            refuses(w, call(w, 0, values, size), CD_ERROR_VALUE, text_of("%s|[%zu]|%s", argument, k_, (table)[i_].shown)); \
        }

static void no_hull_is_made_of_what_is_no_number(void** state) {
    (void)state;
    double* const n = out.number;
    static const double good[8] = {1, 1, 0.5, 1, 0, 0.1, 0};
    static const struct bad_number no_mass[] = {{1e-13, "1e-13"}, {1.0625e15, "1.0625e+15"}};
    static const struct bad_number no_length[] = {{256.5, "256.5"}, {1e300, "1e+300"}};
    static const struct bad_number no_height[] = {{-0.5, "-0.5"}, {-2, "-2"}, {1e61, "1e+61"}};
    static const struct bad_number no_place[] = {{-0.125, "-0.125"}, {4.5, "4.5"}};
    static const struct bad_number no_drag[] = {{1.0625e30, "1.0625e+30"}, {1e300, "1e+300"}};
    static const size_t no_plates[] = {0, 257, SIZE_MAX};
    refuses(w, cd_water_set_hulls(w, 4097, 1, 1), CD_ERROR_VALUE, "count|4097");
    refuses(w, cd_water_set_hulls(w, SIZE_MAX, 1, 1), CD_ERROR_VALUE, name_and_size("count", SIZE_MAX));
    for (size_t i = 0; i < COUNT(no_plates); ++i) {
        refuses(w, cd_water_set_hulls(w, 1, no_plates[i], 1), CD_ERROR_VALUE, name_and_size("n_along", no_plates[i]));
        refuses(w, cd_water_set_hulls(w, 1, 1, no_plates[i]), CD_ERROR_VALUE, name_and_size("n_across", no_plates[i]));
    }
    refuses_each(w, cd_water_set_hull(w, 0, bad, 1, 1, NULL, 0), "mass", not_finite);
    refuses_each(w, cd_water_set_hull(w, 0, bad, 1, 1, NULL, 0), "mass", no_mass);
    refuses_each(w, cd_water_set_hull(w, 0, 1, bad, 1, NULL, 0), "length", not_finite);
    refuses_each(w, cd_water_set_hull(w, 0, 1, bad, 1, NULL, 0), "length", not_positive);
    refuses_each(w, cd_water_set_hull(w, 0, 1, bad, 1, NULL, 0), "length", no_length);
    refuses_each(w, cd_water_set_hull(w, 0, 1, 1, bad, NULL, 0), "width", not_finite);
    refuses_each(w, cd_water_set_hull(w, 0, 1, 1, bad, NULL, 0), "width", not_positive);
    refuses_each(w, cd_water_set_hull(w, 0, 1, 1, bad, NULL, 0), "width", no_length);
    refuses_each(w, cd_water_set_hull(w, 0, 1, 1, 1, (const double[]){0, bad}, 2), "heights", not_finite);
    for (size_t i = 0; i < COUNT(no_height); ++i)
        for (size_t k = 0; k < 2; ++k) {
            const double heights[2] = {k == 0 ? no_height[i].value : 0, k == 1 ? no_height[i].value : 0};
            refuses(w, cd_water_set_hull(w, 0, 1, 1, 1, heights, 2), CD_ERROR_VALUE,
                    text_of("heights|[%zu]|%s|or -1 for no plate", k, no_height[i].shown));
        }
    refuses(w, cd_water_set_hull(w, 0, 1, 1, 1, (const double[]){-1, -1}, 2), CD_ERROR_VALUE, "heights");
    refuses_counts(cd_water_set_hull, 1, 1, 1, good);
    refuses_counts(cd_water_get_hull, n, n + 1, n + 2, n + 3, n + 4);
    refuses_each(w, cd_water_set_disc(w, 0, bad, 1), "mass", not_finite);
    refuses_each(w, cd_water_set_disc(w, 0, bad, 1), "mass", no_mass);
    refuses_each(w, cd_water_set_disc(w, 0, 1, bad), "radius", not_finite);
    refuses_each(w, cd_water_set_disc(w, 0, 1, bad), "radius", not_positive);
    refuses_each(w, cd_water_set_disc(w, 0, 1, bad), "radius", no_length);
    refuses_each(w, cd_water_launch_hull(w, 0, bad, 1, 1, 0), "x", not_finite);
    refuses_each(w, cd_water_launch_hull(w, 0, bad, 1, 1, 0), "x", no_place);
    refuses_each(w, cd_water_launch_hull(w, 0, 1, bad, 1, 0), "y", not_finite);
    refuses_each(w, cd_water_launch_hull(w, 0, 1, bad, 1, 0), "y", no_place);
    refuses_each(w, cd_water_launch_hull(w, 0, 1, 1, bad, 0), "ahead_x", not_finite);
    refuses_each(w, cd_water_launch_hull(w, 0, 1, 1, 0, bad), "ahead_y", not_finite);
    refuses(w, cd_water_launch_hull(w, 0, 1, 1, 0, 0), CD_ERROR_VALUE, "ahead_x|0");
    refuses(w, cd_water_launch_hull(w, 1, 1, 1, 1, 0), CD_ERROR_DISABLED, "hull 1");
    refuses_in(cd_water_set_hull_pose, good, 7, "pose", not_finite);
    for (size_t i = 0; i < COUNT(no_place); ++i) {
        const double x = no_place[i].value;
        refuses(w, cd_water_set_hull_pose(w, 0, (const double[]){x, 1, 0, 1, 0, 0, 0}, 7), CD_ERROR_VALUE, "pose|[0]");
        refuses(w, cd_water_set_hull_pose(w, 0, (const double[]){1, x, 0, 1, 0, 0, 0}, 7), CD_ERROR_VALUE, "pose|[1]");
    }
    refuses(w, cd_water_set_hull_pose(w, 0, (const double[]){1, 1, 0, 0, 0, 0, 0}, 7), CD_ERROR_VALUE, "pose|direction");
    refuses_in(cd_water_set_hull_velocity, good, 6, "velocity", not_finite);
    refuses_in(cd_water_set_hull_force, good, 6, "force", not_finite);
    refuses_in(cd_water_set_hull_force, good, 6, "force", no_drag);
    refuses_counts(cd_water_set_hull_pose, good);
    refuses_counts(cd_water_get_hull_pose, n);
    refuses_counts(cd_water_get_hull_floor, n);
    refuses_counts(cd_water_set_hull_velocity, good);
    refuses_counts(cd_water_get_hull_velocity, n);
    refuses_counts(cd_water_set_hull_force, good);
    refuses_counts(cd_water_get_hull_force, n);
    refuses_counts(cd_water_get_hull_load, n);
    refuses_each(w, cd_water_set_hull_drag(w, 0, bad, 1, 1), "along", not_finite);
    refuses_each(w, cd_water_set_hull_drag(w, 0, bad, 1, 1), "along", negative);
    refuses_each(w, cd_water_set_hull_drag(w, 0, 1, bad, 1), "across", not_finite);
    refuses_each(w, cd_water_set_hull_drag(w, 0, 1, bad, 1), "across", no_drag);
    refuses_each(w, cd_water_set_hull_drag(w, 0, 1, 1, bad), "friction", not_finite);
    refuses_each(w, cd_water_set_hull_drag(w, 0, 1, 1, bad), "friction", negative);
    refuses(w, cd_water_sample_heads(w, (const double[]){1, NAN}, 1, n), CD_ERROR_VALUE, "at|[1]|nan");
    refuses(w, cd_water_sample_heads(w, good, SIZE_MAX, n), CD_ERROR_RANGE, name_and_size("n", SIZE_MAX));
}

static void no_hull_is_found_beyond_the_last(void** state) {
    (void)state;
    double* const n = out.number;
    static const double good[8] = {1, 1, 0.5, 1, 0, 0.1, 0};
    cd_water* none = NULL;
    ok(cd_water_create(2, 2, 1, 1, CD_FLOAT32, NULL, &none));
    refuses(none, cd_water_set_disc(none, 0, 1, 1), CD_ERROR_RANGE, "index|0|no hulls yet|cd_water_set_hulls first");
    cd_water_destroy(none);
    refuses_index(cd_water_set_hull(w, 2, 1, 1, 1, NULL, 0));
    refuses_index(cd_water_set_disc(w, 2, 1, 1));
    refuses_index(cd_water_get_hull(w, 2, n, n, n, n, n, 2));
    refuses_index(cd_water_remove_hull(w, 2));
    refuses_index(cd_water_launch_hull(w, 2, 1, 1, 1, 0));
    refuses_index(cd_water_set_hull_pose(w, 2, good, 7));
    refuses_index(cd_water_get_hull_pose(w, 2, n, 7));
    refuses_index(cd_water_get_hull_floor(w, 2, n, 7));
    refuses_index(cd_water_set_hull_velocity(w, 2, good, 6));
    refuses_index(cd_water_get_hull_velocity(w, 2, n, 6));
    refuses_index(cd_water_set_hull_force(w, 2, good, 6));
    refuses_index(cd_water_get_hull_force(w, 2, n, 6));
    refuses_index(cd_water_set_hull_drag(w, 2, 1, 1, 1));
    refuses_index(cd_water_get_hull_drag(w, 2, n, n, n));
    refuses_index(cd_water_get_hull_load(w, 2, n, 6));
}

/* Any count of steps is good; the sizes of save and load are tried in test_water_keep.c, drawing's arguments in
 * test_water_bad_draw.c. */
static const char* const elsewhere[] = {
    "cd_water_step count",
    "cd_water_save size",
    "cd_water_load size",
    "cd_water_write_vertices size",
    "cd_water_write_vertices stride",
    "cd_water_write_vertices position_offset",
    "cd_water_write_vertices normal_offset",
    "cd_water_write_vertices depth_offset",
    "cd_water_get_index_count skip_dry",
    "cd_water_write_indices skip_dry",
    "cd_water_write_indices size",
    "cd_water_write_indices index_size",
};

static void every_number_in_the_header_was_tried(void** state) {
    (void)state;
    all_numbers_were_tried("water", elsewhere, COUNT(elsewhere));
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(no_parameter_takes_a_number_outside_its_range),
        cmocka_unit_test(no_step_is_made_of_what_is_no_time),
        cmocka_unit_test(no_side_takes_a_level_or_a_discharge_that_is_no_number),
        cmocka_unit_test(a_wall_and_a_periodic_side_take_any_value),
        cmocka_unit_test(nothing_is_done_beside_the_water),
        cmocka_unit_test(no_amount_is_taken_that_is_no_number),
        cmocka_unit_test(what_the_precision_cannot_hold_changes_nothing),
        cmocka_unit_test(no_array_takes_a_place_outside),
        cmocka_unit_test(no_number_is_taken_for_an_enumerator),
        cmocka_unit_test(no_shape_is_made_that_cannot_be),
        cmocka_unit_test(no_rectangle_of_cells_beyond_the_end_is_taken),
        cmocka_unit_test(no_hull_is_made_of_what_is_no_number),
        cmocka_unit_test(no_hull_is_found_beyond_the_last),
        cmocka_unit_test(every_number_in_the_header_was_tried),
    };
    return cmocka_run_group_tests(tests, set_up, tear_down);
}
