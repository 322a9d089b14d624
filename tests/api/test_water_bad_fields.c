/* Bad input to the functions of a water that take a field: enable, disable, write, read, view. */
#include <math.h>

#include "check.h"
#include "pool.h"
#include "refusals.h"

enum { NX = 6, NY = 4, ALL = (NX + 1) * (NY + 1) };

static cd_water* w;     /* everything on */
static cd_water* plain; /* nothing on */

static const cd_field fields[] = {CD_MASK,   CD_DEPTH,    CD_BED,     CD_SURFACE, CD_VELOCITY_X, CD_VELOCITY_Y,
                                  CD_SOURCE, CD_PRESSURE, CD_FORCE_X, CD_FORCE_Y, CD_WALL_X,     CD_WALL_Y};
static const cd_field optional[] = {CD_MASK, CD_SOURCE, CD_PRESSURE, CD_FORCE_X, CD_FORCE_Y, CD_WALL_X, CD_WALL_Y};

static double values[ALL];
static float singles[ALL];

static int set_up(void** state) {
    (void)state;
    w = pool_of(POOL_EVERYTHING, NX, NY, CD_FLOAT64, 2);
    plain = pool(NX, NY, CD_FLOAT32);
    return 0;
}

static int tear_down(void** state) {
    (void)state;
    cd_water_destroy(w);
    cd_water_destroy(plain);
    return 0;
}

/* All four transfers of one rectangle, each refused. */
#define refuses_transfers(water, field, first_x, first_y, n_x, n_y, count, status, text)                              \
    do {                                                                                                              \
        refuses(water, cd_water_write_f32(water, field, first_x, first_y, n_x, n_y, singles, count), status, text);   \
        refuses(water, cd_water_write_f64(water, field, first_x, first_y, n_x, n_y, values, count), status, text);    \
        refuses(water, cd_water_read_f32(water, field, first_x, first_y, n_x, n_y, out.single, count), status, text); \
        refuses(water, cd_water_read_f64(water, field, first_x, first_y, n_x, n_y, out.number, count), status, text); \
    } while (0)

#define refuses_view(water, field, status, text) \
    refuses(water, cd_water_view(water, field, &out.pointer, &out.size[0], &out.size[1]), status, text)

#define refuses_field(field, status, text)                          \
    do {                                                            \
        refuses(w, cd_water_enable_field(w, field), status, text);  \
        refuses(w, cd_water_disable_field(w, field), status, text); \
        refuses_transfers(w, field, 0, 0, 1, 1, 1, status, text);   \
        refuses_view(w, field, status, text);                       \
    } while (0)

static void no_number_is_taken_for_a_field(void** state) {
    (void)state;
    static const cd_field none[] = {-1, 22, 77, INT32_MAX, INT32_MIN};
    for (size_t i = 0; i < COUNT(none); ++i) refuses_field(none[i], CD_ERROR_ENUM, text_of("field|%d", none[i]));
}

static void the_fields_of_other_objects_are_unsupported_and_the_waters_are_named(void** state) {
    (void)state;
    for (cd_field field = CD_POSITION; field < CD_MASK; ++field)
        refuses_field(field, CD_ERROR_UNSUPPORTED, text_of("field|%d", field));
    refuses_field(CD_VELOCITY, CD_ERROR_UNSUPPORTED, "field|1|CD_VELOCITY|CD_VELOCITY_X|CD_VELOCITY_Y");
    refuses_field(CD_FORCE, CD_ERROR_UNSUPPORTED, "field|2|CD_FORCE|CD_FORCE_X|CD_FORCE_Y");
}

static void a_field_that_is_off_is_said_to_be_disabled(void** state) {
    (void)state;
    for (size_t i = 0; i < COUNT(optional); ++i)
        refuses_transfers(plain, optional[i], 0, 0, 1, 1, 1, CD_ERROR_DISABLED,
                          text_of("field|%d|cd_water_enable_field", optional[i]));
    for (cd_field field = CD_SOURCE; field <= CD_FORCE_Y; ++field)
        refuses_view(plain, field, CD_ERROR_DISABLED, text_of("field|%d|cd_water_enable_field", field));
}

static void what_has_no_view_or_no_switch_is_unsupported(void** state) {
    (void)state;
    static const cd_field unseen[] = {CD_SURFACE, CD_MASK, CD_WALL_X, CD_WALL_Y};
    for (size_t i = 0; i < COUNT(unseen); ++i) {
        refuses_view(w, unseen[i], CD_ERROR_UNSUPPORTED, "field");
        refuses_view(plain, unseen[i], CD_ERROR_UNSUPPORTED, "field");
    }
    for (cd_field field = CD_DEPTH; field <= CD_VELOCITY_Y; ++field) {
        refuses(w, cd_water_disable_field(w, field), CD_ERROR_UNSUPPORTED, text_of("field|%d", field));
        ok(cd_water_enable_field(w, field));
    }
}

/* What a message of a rectangle holds: "first_x is 3 and n_x is 1, must add up to at most 3, the number of ...". */
static const char* part_text(const char* argument, size_t value) {
    return text_of("%s|%s is %zu|must add up to at most", argument, argument, value);
}

static void no_rectangle_beyond_the_end_is_taken(void** state) {
    (void)state;
    const size_t most = SIZE_MAX;
    for (size_t i = 0; i < COUNT(fields); ++i) {
        const cd_field f = fields[i];
        const struct pool_extent all = pool_extent(w, f);
        const size_t columns = all.columns, rows = all.rows;
        const char* first_x = "first_x";
        const char* first_y = "first_y";
        refuses_transfers(w, f, columns, 0, 1, 1, 1, CD_ERROR_RANGE, part_text(first_x, columns));
        refuses_transfers(w, f, columns - 1, 0, 2, 1, 2, CD_ERROR_RANGE, part_text(first_x, columns - 1));
        refuses_transfers(w, f, most, 0, 1, 1, 1, CD_ERROR_RANGE, part_text(first_x, most));
        refuses_transfers(w, f, most, 0, 2, 1, 2, CD_ERROR_RANGE, part_text(first_x, most));
        refuses_transfers(w, f, 0, 0, columns + 1, 1, 8, CD_ERROR_RANGE, part_text("n_x", columns + 1));
        refuses_transfers(w, f, 1, 0, most, 1, most, CD_ERROR_RANGE, part_text("n_x", most));
        refuses_transfers(w, f, 0, 0, most / 2 + 1, 1, 0, CD_ERROR_RANGE, part_text("n_x", most / 2 + 1));
        refuses_transfers(w, f, 0, rows, 1, 1, 1, CD_ERROR_RANGE, part_text(first_y, rows));
        refuses_transfers(w, f, 0, rows - 1, 1, 2, 2, CD_ERROR_RANGE, part_text(first_y, rows - 1));
        refuses_transfers(w, f, 0, most, 1, 1, 1, CD_ERROR_RANGE, part_text(first_y, most));
        refuses_transfers(w, f, 0, most, 1, 2, 2, CD_ERROR_RANGE, part_text(first_y, most));
        refuses_transfers(w, f, 0, 0, 1, rows + 1, 8, CD_ERROR_RANGE, part_text("n_y", rows + 1));
        refuses_transfers(w, f, 0, 1, 1, most, most, CD_ERROR_RANGE, part_text("n_y", most));
        refuses_transfers(w, f, 0, 0, 2, most / 2 + 1, 0, CD_ERROR_RANGE, part_text("n_y", most / 2 + 1));
        pool_get(w, f, columns - 1, rows - 1); /* the last one is there */
    }
}

static void no_buffer_of_another_length_is_taken(void** state) {
    (void)state;
    static const size_t wrong[] = {0, 1, 5, 7, 77, SIZE_MAX};
    for (size_t i = 0; i < COUNT(fields); ++i)
        for (size_t k = 0; k < COUNT(wrong); ++k)
            refuses_transfers(w, fields[i], 1, 1, 2, 3, wrong[k], CD_ERROR_RANGE, name_and_size("count", wrong[k]));
}

static const struct {
    double value;
    const char* shown;
} none_finite[] = {{NAN, "nan"}, {INFINITY, "inf"}, {-INFINITY, "-inf"}};

/* A bad value in a 2 x 2 square, the others good, so that a half-done write would show. */
static void refuses_in_a_square(cd_field field, double bad, const char* shown) {
    const double good = field == CD_MASK || field == CD_WALL_X || field == CD_WALL_Y ? 1 : 0;
    const double doubles[4] = {good, good, bad, good};
    const float floats[4] = {(float)good, (float)good, (float)bad, (float)good};
    refuses(w, cd_water_write_f64(w, field, 3, 1, 2, 2, doubles, 4), CD_ERROR_VALUE, text_of("values|2|%s", shown));
    if (isfinite(floats[2]) == isfinite(bad) && floats[2] != 0)
        refuses(w, cd_water_write_f32(w, field, 3, 1, 2, 2, floats, 4), CD_ERROR_VALUE, text_of("values|2|%s", shown));
}

static void a_number_that_is_not_finite_is_found_before_anything_is_written(void** state) {
    (void)state;
    for (size_t i = 0; i < COUNT(fields); ++i)
        for (size_t k = 0; k < COUNT(none_finite); ++k)
            refuses_in_a_square(fields[i], none_finite[k].value, none_finite[k].shown);
}

static void a_depth_is_not_negative_and_a_bit_is_0_or_1(void** state) {
    (void)state;
    refuses_in_a_square(CD_DEPTH, -0.5, "-0.5");
    refuses_in_a_square(CD_DEPTH, -0x1p-1074, "-4.94066e-324");
    static const cd_field bits[] = {CD_MASK, CD_WALL_X, CD_WALL_Y};
    for (size_t i = 0; i < COUNT(bits); ++i) {
        refuses_in_a_square(bits[i], 0.5, "0.5");
        refuses_in_a_square(bits[i], 2, "2");
        refuses_in_a_square(bits[i], -1, "-1");
        refuses_in_a_square(bits[i], 256, "256");
    }
}

static void an_absent_cell_takes_no_depth(void** state) {
    (void)state;
    const double zero = 0, some = 0.25;
    const float some32 = 0.25f;
    pool_set(w, CD_MASK, 2, 2, 0);
    refuses(w, cd_water_write_f64(w, CD_DEPTH, 2, 2, 1, 1, &some, 1), CD_ERROR_VALUE, "values|0|0.25|only 0 of absent");
    refuses(w, cd_water_write_f32(w, CD_DEPTH, 2, 2, 1, 1, &some32, 1), CD_ERROR_VALUE, "values|0|0.25");
    ok(cd_water_write_f64(w, CD_DEPTH, 2, 2, 1, 1, &zero, 1));
    ok(cd_water_write_f64(w, CD_SURFACE, 2, 2, 1, 1, &some, 1)); /* nothing changes */
    assert_true(pool_get(w, CD_DEPTH, 2, 2) == 0);
}

/* Each face closed in turn by what can close it; the one beside it is open. */
static void a_closed_face_takes_no_velocity(void** state) {
    (void)state;
    for (int why = 0; why < 5; ++why)
        for (int along_y = 0; along_y <= 1; ++along_y) {
            cd_water* water = pool(NX, NY, CD_FLOAT64);
            const cd_field velocity = along_y ? CD_VELOCITY_Y : CD_VELOCITY_X;
            size_t i = 2, j = 2;
            ok(cd_water_enable_field(water, CD_MASK));
            ok(cd_water_enable_field(water, CD_WALL_X));
            ok(cd_water_enable_field(water, CD_WALL_Y));
            if (why == 0) pool_set(water, along_y ? CD_WALL_Y : CD_WALL_X, i, j, 1);
            if (why == 1) pool_set(water, CD_MASK, i, j, 0);
            if (why == 2) pool_set(water, CD_MASK, i - (along_y ? 0 : 1), j - (along_y ? 1 : 0), 0);
            if (why >= 3) *(along_y ? &j : &i) = why == 3 ? 0 : along_y ? NY : NX; /* sides that are walls */
            const double zero = 0, minus_zero = -0.0, some = -0.25;
            refuses(water, cd_water_write_f64(water, velocity, i, j, 1, 1, &some, 1), CD_ERROR_VALUE,
                    "values|0|-0.25|only 0 of faces that no water can cross");
            ok(cd_water_write_f64(water, velocity, i, j, 1, 1, &zero, 1));
            ok(cd_water_write_f64(water, velocity, i, j, 1, 1, &minus_zero, 1));
            ok(cd_water_write_f64(water, velocity, 4, 3, 1, 1, &some, 1));
            cd_water_destroy(water);
        }
}

static void what_overflows_in_the_waters_precision_is_refused(void** state) {
    (void)state;
    const double huge = 1e300, most = 0x1.fffffep+127, beyond = 0x1.ffffffp+127; /* ties to 2^128: infinity */
    static const cd_field numbers[] = {CD_DEPTH,  CD_BED,      CD_VELOCITY_X, CD_VELOCITY_Y,
                                       CD_SOURCE, CD_PRESSURE, CD_FORCE_X,    CD_FORCE_Y};
    for (size_t i = 0; i < COUNT(numbers); ++i) {
        cd_water* one = pool(2, 2, CD_FLOAT32);
        const cd_field f = numbers[i];
        const size_t x = f == CD_VELOCITY_X, y = f == CD_VELOCITY_Y;
        ok(cd_water_enable_field(one, f));
        refuses(one, cd_water_write_f64(one, f, x, y, 1, 1, &huge, 1), CD_ERROR_VALUE, "values|1e+300|precision");
        refuses(one, cd_water_write_f64(one, f, x, y, 1, 1, &beyond, 1), CD_ERROR_VALUE, "values");
        ok(cd_water_write_f64(one, f, x, y, 1, 1, &most, 1));
        assert_true(pool_get(one, f, x, y) == most);
        cd_water_destroy(one);
    }
}

/* The depth that follows from a surface or a bed must be a number too. */
static void a_depth_that_would_overflow_is_refused_too(void** state) {
    (void)state;
    const double most = 0x1.fffffep+127, deep = -0x1.fffffep+127;
    cd_water* one = pool(2, 2, CD_FLOAT32);
    pool_set(one, CD_BED, 0, 0, deep);
    refuses(one, cd_water_write_f64(one, CD_SURFACE, 0, 0, 1, 1, &most, 1), CD_ERROR_VALUE, "values|0");
    ok(cd_water_set_bed_rule(one, CD_BED_KEEPS_SURFACE));
    pool_set(one, CD_DEPTH, 1, 1, most);
    refuses(one, cd_water_write_f64(one, CD_BED, 1, 1, 1, 1, &deep, 1), CD_ERROR_VALUE, "values|0");
    ok(cd_water_write_f64(one, CD_BED, 0, 1, 1, 1, &deep, 1)); /* dry */
    cd_water_destroy(one);
}

static void every_field_argument_in_the_header_was_tried(void** state) {
    (void)state;
    all_field_arguments_were_tried("water");
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(no_number_is_taken_for_a_field),
        cmocka_unit_test(the_fields_of_other_objects_are_unsupported_and_the_waters_are_named),
        cmocka_unit_test(a_field_that_is_off_is_said_to_be_disabled),
        cmocka_unit_test(what_has_no_view_or_no_switch_is_unsupported),
        cmocka_unit_test(no_rectangle_beyond_the_end_is_taken),
        cmocka_unit_test(no_buffer_of_another_length_is_taken),
        cmocka_unit_test(a_number_that_is_not_finite_is_found_before_anything_is_written),
        cmocka_unit_test(a_depth_is_not_negative_and_a_bit_is_0_or_1),
        cmocka_unit_test(an_absent_cell_takes_no_depth),
        cmocka_unit_test(a_closed_face_takes_no_velocity),
        cmocka_unit_test(what_overflows_in_the_waters_precision_is_refused),
        cmocka_unit_test(a_depth_that_would_overflow_is_refused_too),
        cmocka_unit_test(every_field_argument_in_the_header_was_tried),
    };
    return cmocka_run_group_tests(tests, set_up, tear_down);
}
