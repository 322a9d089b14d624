/* Bad input to the functions of a membrane that take a field: enable, disable, write, read, view. */
#include <math.h>
#include <stdbool.h>

#include "check.h"
#include "cloth.h"
#include "refusals.h"
#include "sheet.h"

enum { NU = 6, NV = 4, COLUMNS = NU + 1, ROWS = NV + 1, COMPONENTS = 2, ALL = COLUMNS * ROWS * COMPONENTS };

static cd_membrane* m;     /* everything on */
static cd_membrane* plain; /* nothing on */
static cd_membrane* sail;  /* cloth with all that only cloth has */

static const cd_field optional[] = {CD_FORCE, CD_MASS, CD_PIN, CD_TARGET, CD_STIFFNESS_U, CD_STIFFNESS_V, CD_MASK};
static const cd_field single[] = {CD_MASS, CD_STIFFNESS_U, CD_STIFFNESS_V, CD_PIN, CD_MASK};
static const cd_field state_fields[] = {CD_POSITION, CD_VELOCITY, CD_FORCE, CD_TARGET};

static double values[ALL];
static float singles[ALL];

static int set_up(void** state) {
    (void)state;
    m = cloth(NU, NV, COMPONENTS, CD_FLOAT64);
    cloth_everything(m);
    plain = cloth(NU, NV, COMPONENTS, CD_FLOAT32);
    sail = cloth(NU, NV, 3, CD_FLOAT64);
    cloth_lengths(sail);
    return 0;
}

static int tear_down(void** state) {
    (void)state;
    cd_membrane_destroy(m);
    cd_membrane_destroy(plain);
    cd_membrane_destroy(sail);
    return 0;
}

/* All four transfers of one rectangle, each refused. */
#define refuses_transfers(membrane, field, first_u, first_v, n_u, n_v, count, status, text)                           \
    do {                                                                                                              \
        refuses(membrane, cd_membrane_write_f32(membrane, field, first_u, first_v, n_u, n_v, singles, count), status, \
                text);                                                                                                \
        refuses(membrane, cd_membrane_write_f64(membrane, field, first_u, first_v, n_u, n_v, values, count), status,  \
                text);                                                                                                \
        refuses(membrane, cd_membrane_read_f32(membrane, field, first_u, first_v, n_u, n_v, out.single, count),       \
                status, text);                                                                                        \
        refuses(membrane, cd_membrane_read_f64(membrane, field, first_u, first_v, n_u, n_v, out.number, count),       \
                status, text);                                                                                        \
    } while (0)

#define refuses_view(membrane, field, status, text)                                                              \
    refuses(membrane, cd_membrane_view(membrane, field, &out.pointer, &out.size[0], &out.size[1], &out.size[2]), \
            status, text)

#define refuses_field(field, status, text)                             \
    do {                                                               \
        refuses(m, cd_membrane_enable_field(m, field), status, text);  \
        refuses(m, cd_membrane_disable_field(m, field), status, text); \
        refuses_transfers(m, field, 0, 0, 1, 1, 1, status, text);      \
        refuses_view(m, field, status, text);                          \
    } while (0)

static void no_number_is_taken_for_a_field(void** state) {
    (void)state;
    static const cd_field none[] = {-1, 11, 12, 13, 14, 15, 16, 17, 18, 19,        20,       21,
                                    22, 23, 25, 26, 35, 36, 76, 77, 88, INT32_MAX, INT32_MIN};
    for (size_t i = 0; i < COUNT(none); ++i)
        refuses_field(none[i], CD_ERROR_ENUM, text_of("field|%d|must be 0 to 10, 24 or 27 to 34", none[i]));
}

static const cd_field of_cloth[] = {CD_BREAKING_STRAIN_U, CD_BREAKING_STRAIN_V, CD_WIND,
                                    CD_REST_LENGTH_U,     CD_REST_LENGTH_V,     CD_TENSION_U,
                                    CD_TENSION_V,         CD_STRAIN_U,          CD_STRAIN_V};
enum { SWITCHED = 5 }; /* of them; what cloth tells is always on, and to be read only */

static void only_cloth_has_the_fields_of_cloth(void** state) {
    (void)state;
    for (size_t i = 0; i < COUNT(of_cloth); ++i) {
        const cd_field f = of_cloth[i];
        const char* text = text_of("field|%d|rest length", f);
        const size_t count = cloth_extent(sail, f).components;
        refuses(m, cd_membrane_enable_field(m, f), CD_ERROR_UNSUPPORTED, text);
        refuses_transfers(m, f, 0, 0, 1, 1, cloth_extent(m, f).components, CD_ERROR_UNSUPPORTED, text);
        refuses_view(m, f, CD_ERROR_UNSUPPORTED, text_of("field|%d", f));
        refuses_view(sail, f, CD_ERROR_UNSUPPORTED, text_of("field|%d|view", f));
        ok(cd_membrane_enable_field(sail, f));
        if (i < SWITCHED) {
            ok(cd_membrane_disable_field(m, f)); /* is off */
            ok(cd_membrane_disable_field(sail, f));
            refuses_transfers(sail, f, 0, 0, 1, 1, count, CD_ERROR_DISABLED,
                              text_of("field|%d|cd_membrane_enable_field", f));
            ok(cd_membrane_enable_field(sail, f));
            ok(cd_membrane_read_f64(sail, f, 0, 0, 1, 1, values, count));
            continue;
        }
        text = text_of("field|%d|always on", f);
        refuses(m, cd_membrane_disable_field(m, f), CD_ERROR_UNSUPPORTED, text);
        refuses(sail, cd_membrane_disable_field(sail, f), CD_ERROR_UNSUPPORTED, text);
        text = text_of("field|%d|read only", f);
        refuses(sail, cd_membrane_write_f64(sail, f, 0, 0, 1, 1, values, 1), CD_ERROR_UNSUPPORTED, text);
        refuses(sail, cd_membrane_write_f32(sail, f, 0, 0, 1, 1, singles, 1), CD_ERROR_UNSUPPORTED, text);
        ok(cd_membrane_read_f64(sail, f, 0, 0, 1, 1, values, 1));
        ok(cd_membrane_read_f32(sail, f, 0, 0, 1, 1, singles, 1));
    }
}

static void the_chains_fields_are_unsupported_and_the_membranes_are_named(void** state) {
    (void)state;
    refuses_field(CD_STIFFNESS, CD_ERROR_UNSUPPORTED, "field|4|CD_STIFFNESS|CD_STIFFNESS_U|CD_STIFFNESS_V");
    refuses_field(CD_BEND, CD_ERROR_UNSUPPORTED, "field|5|CD_BEND");
}

static void a_field_that_is_off_is_said_to_be_disabled(void** state) {
    (void)state;
    for (size_t i = 0; i < COUNT(optional); ++i)
        refuses_transfers(plain, optional[i], 0, 0, 1, 1, cloth_extent(plain, optional[i]).components,
                          CD_ERROR_DISABLED, text_of("field|%d|cd_membrane_enable_field", optional[i]));
    refuses_view(plain, CD_FORCE, CD_ERROR_DISABLED, "field");
    refuses_view(plain, CD_TARGET, CD_ERROR_DISABLED, "field");
}

static void what_has_no_view_or_no_switch_is_unsupported(void** state) {
    (void)state;
    for (size_t i = 0; i < COUNT(single); ++i) refuses_view(m, single[i], CD_ERROR_UNSUPPORTED, "field");
    refuses(m, cd_membrane_disable_field(m, CD_POSITION), CD_ERROR_UNSUPPORTED, "field");
    refuses(m, cd_membrane_disable_field(m, CD_VELOCITY), CD_ERROR_UNSUPPORTED, "field");
}

/* What a message of a rectangle holds: "first_u is 3 and n_u is 1, must add up to at most 3, the number of ...". */
static const char* part_text(const char* argument, const char* direction, size_t value) {
    return text_of("%s|%s is %zu|must add up to at most|along %s", argument, argument, value, direction);
}

static void no_rectangle_beyond_the_end_is_taken(void** state) {
    (void)state;
    static const cd_field fields[] = {CD_POSITION,
                                      CD_VELOCITY,
                                      CD_FORCE,
                                      CD_TARGET,
                                      CD_MASS,
                                      CD_PIN,
                                      CD_STIFFNESS_U,
                                      CD_STIFFNESS_V,
                                      CD_MASK,
                                      CD_REST_LENGTH_U,
                                      CD_REST_LENGTH_V,
                                      CD_TENSION_U,
                                      CD_TENSION_V,
                                      CD_STRAIN_U,
                                      CD_STRAIN_V,
                                      CD_WIND,
                                      CD_BREAKING_STRAIN_U,
                                      CD_BREAKING_STRAIN_V};
    const size_t most = SIZE_MAX;
    for (size_t i = 0; i < 2 * COUNT(fields); ++i) {
        const cd_field f = fields[i / 2];
        cd_membrane* const b = i % 2 ? sail : m;
        if (b == m && f > CD_MASK) continue;
        const struct cloth_extent all = cloth_extent(b, f);
        const size_t c = all.components, columns = all.columns, rows = all.rows;
        const bool along_u = f == CD_STIFFNESS_U || f == CD_REST_LENGTH_U || f == CD_TENSION_U || f == CD_STRAIN_U ||
                             f == CD_BREAKING_STRAIN_U;
        const bool along_v = f == CD_STIFFNESS_V || f == CD_REST_LENGTH_V || f == CD_TENSION_V || f == CD_STRAIN_V ||
                             f == CD_BREAKING_STRAIN_V;
        assert_int_equal(columns, along_u ? NU : COLUMNS);
        assert_int_equal(rows, along_v ? NV : ROWS);
        const char* first_u = "first_u";
        const char* first_v = "first_v";
        refuses_transfers(b, f, columns, 0, 1, 1, c, CD_ERROR_RANGE, part_text(first_u, "u", columns));
        refuses_transfers(b, f, columns - 1, 0, 2, 1, 2 * c, CD_ERROR_RANGE, part_text(first_u, "u", columns - 1));
        refuses_transfers(b, f, most, 0, 1, 1, c, CD_ERROR_RANGE, part_text(first_u, "u", most));
        refuses_transfers(b, f, most, 0, 2, 1, 2 * c, CD_ERROR_RANGE, part_text(first_u, "u", most));
        refuses_transfers(b, f, 0, 0, columns + 1, 1, 8 * c, CD_ERROR_RANGE, part_text("n_u", "u", columns + 1));
        refuses_transfers(b, f, 1, 0, most, 1, most * c, CD_ERROR_RANGE, part_text("n_u", "u", most));
        refuses_transfers(b, f, 0, 0, most / 2 + 1, 1, 0, CD_ERROR_RANGE, part_text("n_u", "u", most / 2 + 1));
        refuses_transfers(b, f, 0, rows, 1, 1, c, CD_ERROR_RANGE, part_text(first_v, "v", rows));
        refuses_transfers(b, f, 0, rows - 1, 1, 2, 2 * c, CD_ERROR_RANGE, part_text(first_v, "v", rows - 1));
        refuses_transfers(b, f, 0, most, 1, 1, c, CD_ERROR_RANGE, part_text(first_v, "v", most));
        refuses_transfers(b, f, 0, most, 1, 2, 2 * c, CD_ERROR_RANGE, part_text(first_v, "v", most));
        refuses_transfers(b, f, 0, 0, 1, rows + 1, 8 * c, CD_ERROR_RANGE, part_text("n_v", "v", rows + 1));
        refuses_transfers(b, f, 0, 1, 1, most, most * c, CD_ERROR_RANGE, part_text("n_v", "v", most));
        refuses_transfers(b, f, 0, 0, 2, most / 2 + 1, 0, CD_ERROR_RANGE, part_text("n_v", "v", most / 2 + 1));
    }
}

static void a_ring_has_a_spring_more_and_no_other_field_grows(void** state) {
    (void)state;
    cd_membrane* ring = cloth(NU, NV, 1, CD_FLOAT64);
    for (size_t i = 0; i < COUNT(optional); ++i) ok(cd_membrane_enable_field(ring, optional[i]));
    ok(cd_membrane_set_ring(ring, 1, 0));
    ok(cd_membrane_read_f64(ring, CD_STIFFNESS_U, NU, NV, 1, 1, values, 1));
    refuses_transfers(ring, CD_STIFFNESS_U, COLUMNS, 0, 1, 1, 1, CD_ERROR_RANGE, part_text("first_u", "u", COLUMNS));
    refuses_transfers(ring, CD_STIFFNESS_V, 0, NV, 1, 1, 1, CD_ERROR_RANGE, part_text("first_v", "v", NV));
    refuses_transfers(ring, CD_POSITION, COLUMNS, 0, 1, 1, 1, CD_ERROR_RANGE, part_text("first_u", "u", COLUMNS));
    ok(cd_membrane_set_ring(ring, 0, 1));
    ok(cd_membrane_read_f64(ring, CD_STIFFNESS_V, NU, NV, 1, 1, values, 1));
    refuses_transfers(ring, CD_STIFFNESS_U, NU, 0, 1, 1, 1, CD_ERROR_RANGE, part_text("first_u", "u", NU));
    cd_membrane_destroy(ring);
}

static void no_buffer_of_another_length_is_taken(void** state) {
    (void)state;
    static const size_t wrong[] = {0, 1, 11, 13, 77, SIZE_MAX};
    for (size_t i = 0; i < COUNT(wrong); ++i) {
        refuses_transfers(m, CD_POSITION, 1, 1, 2, 3, wrong[i], CD_ERROR_RANGE, name_and_size("count", wrong[i]));
        refuses_transfers(m, CD_MASS, 1, 1, 4, 3, wrong[i], CD_ERROR_RANGE, name_and_size("count", wrong[i]));
    }
}

static const struct {
    cd_field field;
    double value;
    const char* shown;
} bad_values[] = {
    {CD_POSITION, NAN, "nan"},
    {CD_POSITION, INFINITY, "inf"},
    {CD_POSITION, -INFINITY, "-inf"},
    {CD_VELOCITY, NAN, "nan"},
    {CD_VELOCITY, INFINITY, "inf"},
    {CD_VELOCITY, -INFINITY, "-inf"},
    {CD_FORCE, NAN, "nan"},
    {CD_FORCE, INFINITY, "inf"},
    {CD_FORCE, -INFINITY, "-inf"},
    {CD_TARGET, NAN, "nan"},
    {CD_TARGET, INFINITY, "inf"},
    {CD_TARGET, -INFINITY, "-inf"},
    {CD_MASS, NAN, "nan"},
    {CD_MASS, INFINITY, "inf"},
    {CD_MASS, 0, "0"},
    {CD_MASS, -0.5, "-0.5"},
    {CD_MASS, 1e61, "1e+61"},
    {CD_MASS, 1e-61, "1e-61"},
    {CD_STIFFNESS_U, NAN, "nan"},
    {CD_STIFFNESS_U, -0.5, "-0.5"},
    {CD_STIFFNESS_U, INFINITY, "inf"},
    {CD_STIFFNESS_V, NAN, "nan"},
    {CD_STIFFNESS_V, -0.5, "-0.5"},
    {CD_STIFFNESS_V, INFINITY, "inf"},
    {CD_STIFFNESS_V, 1e61, "1e+61"},
    {CD_PIN, NAN, "nan"},
    {CD_PIN, 0.5, "0.5"},
    {CD_PIN, -1, "-1"},
    {CD_PIN, 5, "5"},
    {CD_PIN, 1e30, "1e+30"},
    {CD_PIN, CD_NODE_MATCHED, "3"},
    {CD_MASK, NAN, "nan"},
    {CD_MASK, 0.5, "0.5"},
    {CD_MASK, 2, "2"},
    {CD_MASK, -1, "-1"},
    {CD_MASK, 256, "256"},
    {CD_REST_LENGTH_U, NAN, "nan"},
    {CD_REST_LENGTH_U, INFINITY, "inf"},
    {CD_REST_LENGTH_U, 0, "0"},
    {CD_REST_LENGTH_U, -0.5, "-0.5"},
    {CD_REST_LENGTH_U, 1e61, "1e+61"},
    {CD_REST_LENGTH_U, 1e-61, "1e-61"},
    {CD_REST_LENGTH_V, NAN, "nan"},
    {CD_REST_LENGTH_V, -INFINITY, "-inf"},
    {CD_REST_LENGTH_V, 0, "0"},
    {CD_REST_LENGTH_V, -0.5, "-0.5"},
    {CD_REST_LENGTH_V, 1e61, "1e+61"},
    {CD_REST_LENGTH_V, 1e-61, "1e-61"},
    {CD_BREAKING_STRAIN_U, NAN, "nan"},
    {CD_BREAKING_STRAIN_U, 0, "0"},
    {CD_BREAKING_STRAIN_U, 1e61, "1e+61"},
    {CD_BREAKING_STRAIN_U, 1e-61, "1e-61"},
    {CD_BREAKING_STRAIN_V, -0.5, "-0.5"},
    {CD_BREAKING_STRAIN_V, -INFINITY, "-inf"},
    {CD_WIND, NAN, "nan"},
    {CD_WIND, INFINITY, "inf"},
    {CD_WIND, -INFINITY, "-inf"},
};

/* The bad value in a 2 x 2 square, the others good, so that a half-done write would show. */
static void a_bad_value_is_found_before_anything_is_written(void** state) {
    (void)state;
    for (size_t i = 0; i < COUNT(bad_values); ++i) {
        const cd_field field = bad_values[i].field;
        cd_membrane* const b = field > CD_MASK ? sail : m;
        const size_t each = cloth_extent(b, field).components, count = 4 * each;
        double doubles[4 * 3];
        float floats[4 * 3];
        for (size_t j = 0; j < count; ++j) {
            const bool positive = field == CD_MASS || field == CD_STIFFNESS_U || field >= CD_REST_LENGTH_U;
            const double good = positive ? 0.75 : field == CD_PIN ? 1 : 0;
            doubles[j] = j == 2 * each ? bad_values[i].value : good;
            floats[j] = (float)doubles[j];
        }
        const char* text = text_of("values|%zu|%s", 2 * each, bad_values[i].shown);
        refuses(b, cd_membrane_write_f64(b, field, 4, 1, 2, 2, doubles, count), CD_ERROR_VALUE, text);
        if (isfinite(floats[2 * each]) == isfinite(doubles[2 * each]) && floats[2 * each] != 0)
            refuses(b, cd_membrane_write_f32(b, field, 4, 1, 2, 2, floats, count), CD_ERROR_VALUE, "values");
    }
}

static void what_overflows_in_the_membranes_precision_is_refused(void** state) {
    (void)state;
    const double huge = 1e300, most = 0x1.fffffep+127, beyond = 0x1.ffffffp+127; /* ties to 2^128: infinity */
    cd_membrane* one = cloth(0, 0, 1, CD_FLOAT32);
    for (size_t i = 0; i < COUNT(state_fields); ++i) {
        const cd_field f = state_fields[i];
        ok(cd_membrane_enable_field(one, f));
        refuses(one, cd_membrane_write_f64(one, f, 0, 0, 1, 1, &huge, 1), CD_ERROR_VALUE, "values|1e+300");
        refuses(one, cd_membrane_write_f64(one, f, 0, 0, 1, 1, &beyond, 1), CD_ERROR_VALUE, "values");
        ok(cd_membrane_write_f64(one, f, 0, 0, 1, 1, &most, 1));
    }
    refuses(one, cd_membrane_set_gravity(one, &huge, 1), CD_ERROR_VALUE, "gravity|1e+300");
    refuses(one, cd_membrane_impulse(one, 0, 0, 0, &huge, 1), CD_ERROR_VALUE, "impulse|1e+300");
    refuses(one, cd_membrane_attach(one, 0, 0, 1, 1, &huge, 1), CD_ERROR_VALUE, "target|1e+300");
    cd_membrane_destroy(one);
}

static void a_pinned_or_absent_node_takes_no_velocity(void** state) {
    (void)state;
    const double v[COMPONENTS] = {0, 0.25}, zero[COMPONENTS] = {0, 0};
    const float v32[COMPONENTS] = {0, 0.25f};
    assert_true(sheet_get(m, CD_PIN, 2, 3) == CD_NODE_PINNED);
    refuses(m, cd_membrane_write_f64(m, CD_VELOCITY, 2, 3, 1, 1, v, 2), CD_ERROR_VALUE, "values|1|0.25");
    refuses(m, cd_membrane_write_f32(m, CD_VELOCITY, 2, 3, 1, 1, v32, 2), CD_ERROR_VALUE, "values|1|0.25");
    ok(cd_membrane_write_f64(m, CD_VELOCITY, 2, 3, 1, 1, zero, 2));
    assert_true(sheet_get(m, CD_MASK, 1, 3) == 0);
    refuses(m, cd_membrane_write_f64(m, CD_VELOCITY, 1, 3, 1, 1, v, 2), CD_ERROR_VALUE, "values|1|0.25");
    ok(cd_membrane_write_f64(m, CD_VELOCITY, 1, 3, 1, 1, zero, 2));
    ok(cd_membrane_set_edge(plain, CD_EDGE_U_LAST, CD_NODE_PINNED));
    refuses(plain, cd_membrane_write_f64(plain, CD_VELOCITY, NU, 2, 1, 1, v, 2), CD_ERROR_VALUE, "values|1|0.25");
    ok(cd_membrane_write_f64(plain, CD_VELOCITY, NU - 1, 2, 1, 1, v, 2));
    ok(cd_membrane_set_edge(plain, CD_EDGE_U_LAST, CD_NODE_FREE));
}

static void every_field_argument_in_the_header_was_tried(void** state) {
    (void)state;
    all_field_arguments_were_tried("membrane");
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(no_number_is_taken_for_a_field),
        cmocka_unit_test(only_cloth_has_the_fields_of_cloth),
        cmocka_unit_test(the_chains_fields_are_unsupported_and_the_membranes_are_named),
        cmocka_unit_test(a_field_that_is_off_is_said_to_be_disabled),
        cmocka_unit_test(what_has_no_view_or_no_switch_is_unsupported),
        cmocka_unit_test(no_rectangle_beyond_the_end_is_taken),
        cmocka_unit_test(a_ring_has_a_spring_more_and_no_other_field_grows),
        cmocka_unit_test(no_buffer_of_another_length_is_taken),
        cmocka_unit_test(a_bad_value_is_found_before_anything_is_written),
        cmocka_unit_test(what_overflows_in_the_membranes_precision_is_refused),
        cmocka_unit_test(a_pinned_or_absent_node_takes_no_velocity),
        cmocka_unit_test(every_field_argument_in_the_header_was_tried),
    };
    return cmocka_run_group_tests(tests, set_up, tear_down);
}
