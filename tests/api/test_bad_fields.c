/* Bad input to the functions that take a field: enable, disable, write, read, view. */
#include <math.h>

#include "check.h"
#include "refusals.h"
#include "scene.h"

enum { STRANDS = 3, SPRINGS = 9, NODES = SPRINGS + 1, COMPONENTS = 2, ALL = STRANDS * NODES * COMPONENTS };

static cd_chain* chain; /* everything on */
static cd_chain* plain; /* nothing on */
static cd_chain* rope;  /* with CD_REST_LENGTH on */

static const cd_field optional[] = {CD_FORCE, CD_MASS, CD_STIFFNESS, CD_BEND, CD_TARGET};
static const cd_field shared[] = {CD_MASS, CD_STIFFNESS, CD_BEND, CD_PIN};
static const cd_field of_ropes[] = {CD_REST_LENGTH, CD_TENSION, CD_WIND, CD_STRENGTH, CD_STRAIN, CD_REST_ANGLE};
static const cd_field per_strand[] = {CD_POSITION, CD_VELOCITY, CD_FORCE, CD_TARGET};

static double values[ALL];
static float singles[ALL];

static int set_up(void** state) {
    (void)state;
    chain = scene_chain(STRANDS, SPRINGS, COMPONENTS, CD_FLOAT64);
    scene_everything(chain);
    plain = scene_chain(STRANDS, SPRINGS, COMPONENTS, CD_FLOAT32);
    rope = scene_chain(STRANDS, SPRINGS, COMPONENTS, CD_FLOAT64);
    scene_lengths(rope);
    for (size_t i = 0; i < ALL; ++i) values[i] = singles[i] = 0;
    return 0;
}

static int tear_down(void** state) {
    (void)state;
    cd_chain_destroy(chain);
    cd_chain_destroy(plain);
    cd_chain_destroy(rope);
    return 0;
}

/* All four transfers of one range, each refused. */
#define refuses_transfers(chain, field, first_strand, strands, first, n, count, status, text)                       \
    do {                                                                                                            \
        refuses(chain, cd_chain_write_f32(chain, field, first_strand, strands, first, n, singles, count), status,   \
                text);                                                                                              \
        refuses(chain, cd_chain_write_f64(chain, field, first_strand, strands, first, n, values, count), status,    \
                text);                                                                                              \
        refuses(chain, cd_chain_read_f32(chain, field, first_strand, strands, first, n, out.single, count), status, \
                text);                                                                                              \
        refuses(chain, cd_chain_read_f64(chain, field, first_strand, strands, first, n, out.number, count), status, \
                text);                                                                                              \
    } while (0)

#define refuses_view(chain, field, status, text) \
    refuses(chain, cd_chain_view(chain, field, &out.pointer, &out.size[0], &out.size[1], &out.size[2]), status, text)

static void no_number_is_taken_for_a_field(void** state) {
    (void)state;
    static const cd_field none[] = {-1, 8,  9,  10, 11, 12, 13, 14, 15,        16,       17,
                                    18, 19, 20, 21, 27, 34, 36, 77, INT32_MAX, INT32_MIN};
    for (size_t i = 0; i < COUNT(none); ++i) {
        const char* text = text_of("field|%d|must be 0 to 7, 22 to 26 or 35", none[i]);
        for (int with_lengths = 0; with_lengths <= 1; ++with_lengths) {
            cd_chain* c = with_lengths ? rope : chain;
            refuses(c, cd_chain_enable_field(c, none[i]), CD_ERROR_ENUM, text);
            refuses(c, cd_chain_disable_field(c, none[i]), CD_ERROR_ENUM, text);
            refuses_transfers(c, none[i], 0, 1, 0, 1, 1, CD_ERROR_ENUM, text);
            refuses_view(c, none[i], CD_ERROR_ENUM, text);
        }
    }
}

static void only_ropes_have_the_fields_of_ropes(void** state) {
    (void)state;
    for (size_t i = 0; i < COUNT(of_ropes); ++i) {
        const cd_field f = of_ropes[i];
        const char* text = text_of("field|%d|rest length", f);
        refuses(chain, cd_chain_enable_field(chain, f), CD_ERROR_UNSUPPORTED, text);
        refuses_transfers(chain, f, 0, 1, 0, 1, 1, CD_ERROR_UNSUPPORTED, text);
        refuses_view(chain, f, CD_ERROR_UNSUPPORTED, text_of("field|%d", f));
        refuses_view(rope, f, CD_ERROR_UNSUPPORTED, text_of("field|%d|view", f));
        ok(cd_chain_enable_field(rope, f));
    }
    ok(cd_chain_disable_field(chain, CD_REST_LENGTH)); /* is off */
    refuses(chain, cd_chain_disable_field(chain, CD_TENSION), CD_ERROR_UNSUPPORTED, "field|23");
    refuses(rope, cd_chain_disable_field(rope, CD_TENSION), CD_ERROR_UNSUPPORTED, "field|23|CD_TENSION");
    ok(cd_chain_disable_field(rope, CD_REST_LENGTH));
    refuses_transfers(rope, CD_REST_LENGTH, 0, 1, 0, 1, 1, CD_ERROR_DISABLED, "field|22|CD_REST_LENGTH");
    ok(cd_chain_enable_field(rope, CD_REST_LENGTH));
    ok(cd_chain_disable_field(rope, CD_WIND));
    refuses_transfers(rope, CD_WIND, 0, 1, 0, 1, COMPONENTS, CD_ERROR_DISABLED, "field|24|CD_WIND");
    ok(cd_chain_enable_field(rope, CD_WIND));
    const double strain[2] = {0.5, 0.5};
    refuses(rope, cd_chain_write_f64(rope, CD_STRAIN, 0, 1, 0, 2, strain, 2), CD_ERROR_UNSUPPORTED,
            "26|CD_STRAIN|read");
    refuses(rope, cd_chain_disable_field(rope, CD_STRAIN), CD_ERROR_UNSUPPORTED, "field|26|CD_STRAIN");
    refuses(rope, cd_chain_disable_field(rope, CD_STIFFNESS), CD_ERROR_UNSUPPORTED, "field|4|CD_STIFFNESS");
    ok(cd_chain_disable_field(rope, CD_STRENGTH));
    refuses_transfers(rope, CD_STRENGTH, 0, 1, 0, 1, 1, CD_ERROR_DISABLED, "field|25|CD_STRENGTH");
    ok(cd_chain_disable_field(rope, CD_STIFFNESS));
    ok(cd_chain_enable_field(rope, CD_STRENGTH));
    ok(cd_chain_read_f64(rope, CD_STIFFNESS, 0, 1, 0, 1, out.number, 1));
}

static void a_field_that_is_off_is_said_to_be_disabled(void** state) {
    (void)state;
    for (size_t i = 0; i < COUNT(optional); ++i) {
        const size_t count = optional[i] == CD_FORCE || optional[i] == CD_TARGET ? COMPONENTS : 1;
        refuses_transfers(plain, optional[i], 0, 1, 0, 1, count, CD_ERROR_DISABLED, "field");
    }
    refuses_view(plain, CD_FORCE, CD_ERROR_DISABLED, "field");
    refuses_view(plain, CD_TARGET, CD_ERROR_DISABLED, "field");
}

static void what_has_no_view_or_no_switch_is_unsupported(void** state) {
    (void)state;
    for (size_t i = 0; i < COUNT(shared); ++i) refuses_view(chain, shared[i], CD_ERROR_UNSUPPORTED, "field");
    refuses(chain, cd_chain_disable_field(chain, CD_POSITION), CD_ERROR_UNSUPPORTED, "field");
    refuses(chain, cd_chain_disable_field(chain, CD_VELOCITY), CD_ERROR_UNSUPPORTED, "field");
    refuses(chain, cd_chain_disable_field(chain, CD_PIN), CD_ERROR_UNSUPPORTED, "field");
}

/* What a range's message holds: "first is 3 and n is 1, must add up to at most 3, the number of nodes". */
static const char* part_text(const char* argument, size_t value) {
    return text_of("%s|%s is %zu|must add up to at most", argument, argument, value);
}

static void no_range_beyond_the_end_is_taken(void** state) {
    (void)state;
    const size_t most = SIZE_MAX;
    for (size_t i = 0; i < COUNT(per_strand); ++i) {
        const cd_field f = per_strand[i];
        refuses_transfers(chain, f, STRANDS, 1, 0, 1, 2, CD_ERROR_RANGE, part_text("first_strand", STRANDS));
        refuses_transfers(chain, f, 0, STRANDS + 1, 0, 1, 8, CD_ERROR_RANGE, part_text("strands", STRANDS + 1));
        refuses_transfers(chain, f, 2, 2, 0, 1, 4, CD_ERROR_RANGE, part_text("first_strand", 2));
        refuses_transfers(chain, f, most, 1, 0, 1, 2, CD_ERROR_RANGE, part_text("first_strand", most));
        refuses_transfers(chain, f, most, 2, 0, 1, 4, CD_ERROR_RANGE, part_text("first_strand", most));
        refuses_transfers(chain, f, 1, most, 0, 1, most * 2, CD_ERROR_RANGE, part_text("strands", most));
        refuses_transfers(chain, f, 2, most - 1, 0, 1, most * 2, CD_ERROR_RANGE, part_text("strands", most - 1));
        refuses_transfers(chain, f, 0, most / 2 + 1, 0, 1, 0, CD_ERROR_RANGE, part_text("strands", most / 2 + 1));
        refuses_transfers(chain, f, 0, 1, NODES, 1, 2, CD_ERROR_RANGE, part_text("first", NODES));
        refuses_transfers(chain, f, 0, 1, 0, NODES + 1, 22, CD_ERROR_RANGE, part_text("n", NODES + 1));
        refuses_transfers(chain, f, 0, 1, 8, 3, 6, CD_ERROR_RANGE, part_text("first", 8));
        refuses_transfers(chain, f, 0, 1, most, 1, 2, CD_ERROR_RANGE, part_text("first", most));
        refuses_transfers(chain, f, 0, 1, most, 2, 4, CD_ERROR_RANGE, part_text("first", most));
        refuses_transfers(chain, f, 0, 1, 1, most, most * 2, CD_ERROR_RANGE, part_text("n", most));
        refuses_transfers(chain, f, 0, 1, 4, most - 3, 2, CD_ERROR_RANGE, part_text("n", most - 3));
        refuses_transfers(chain, f, 0, 2, 0, most / 2 + 1, 0, CD_ERROR_RANGE, part_text("n", most / 2 + 1));
    }
}

static void fields_that_the_strands_share_have_strand_0_only(void** state) {
    (void)state;
    for (size_t i = 0; i < COUNT(shared); ++i) {
        const cd_field f = shared[i];
        const size_t items = f == CD_STIFFNESS ? SPRINGS : NODES;
        refuses_transfers(chain, f, 1, 1, 0, 1, 1, CD_ERROR_RANGE, part_text("first_strand", 1));
        refuses_transfers(chain, f, 0, STRANDS, 0, 1, STRANDS, CD_ERROR_RANGE, part_text("strands", STRANDS));
        refuses_transfers(chain, f, SIZE_MAX, 1, 0, 1, 1, CD_ERROR_RANGE, part_text("first_strand", SIZE_MAX));
        refuses_transfers(chain, f, 0, 1, items, 1, 1, CD_ERROR_RANGE, part_text("first", items));
        refuses_transfers(chain, f, 0, 1, 0, items + 1, items + 1, CD_ERROR_RANGE, part_text("n", items + 1));
        refuses_transfers(chain, f, 0, 1, SIZE_MAX, 2, 2, CD_ERROR_RANGE, part_text("first", SIZE_MAX));
        refuses_transfers(chain, f, 0, 1, 0, 1, COMPONENTS, CD_ERROR_RANGE, name_and_size("count", COMPONENTS));
    }
}

static void no_spring_beyond_the_end_of_a_rope_is_taken(void** state) {
    (void)state;
    static const cd_field fields[] = {CD_STIFFNESS, CD_REST_LENGTH, CD_TENSION, CD_STRENGTH};
    for (size_t k = 0; k < COUNT(fields); ++k) {
        const cd_field f = fields[k];
        const size_t all = STRANDS, most = SIZE_MAX;
        refuses_transfers(rope, f, all, 1, 0, 1, 1, CD_ERROR_RANGE, part_text("first_strand", all));
        refuses_transfers(rope, f, 0, all + 1, 0, 1, all + 1, CD_ERROR_RANGE, part_text("strands", all + 1));
        refuses_transfers(rope, f, most, 1, 0, 1, 1, CD_ERROR_RANGE, part_text("first_strand", most));
        refuses_transfers(rope, f, 0, 1, SPRINGS, 1, 1, CD_ERROR_RANGE, part_text("first", SPRINGS));
        refuses_transfers(rope, f, 0, 1, 0, NODES, NODES, CD_ERROR_RANGE, part_text("n", NODES));
        refuses_transfers(rope, f, 0, 1, most, 2, 2, CD_ERROR_RANGE, part_text("first", most));
        refuses_transfers(rope, f, 0, 1, 0, 1, COMPONENTS, CD_ERROR_RANGE, name_and_size("count", COMPONENTS));
    }
}

static void no_buffer_of_another_length_is_taken(void** state) {
    (void)state;
    static const size_t wrong[] = {0, 1, 11, 13, 77, SIZE_MAX};
    for (size_t i = 0; i < COUNT(wrong); ++i)
        refuses_transfers(chain, CD_POSITION, 0, 3, 1, 2, wrong[i], CD_ERROR_RANGE, name_and_size("count", wrong[i]));
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
    {CD_MASS, -INFINITY, "-inf"},
    {CD_STIFFNESS, NAN, "nan"},
    {CD_STIFFNESS, -0.5, "-0.5"},
    {CD_STIFFNESS, -INFINITY, "-inf"},
    {CD_BEND, NAN, "nan"},
    {CD_BEND, -0.5, "-0.5"},
    {CD_BEND, -INFINITY, "-inf"},
    {CD_BEND, INFINITY, "inf"},
    {CD_PIN, NAN, "nan"},
    {CD_PIN, 0.5, "0.5"},
    {CD_PIN, -1, "-1"},
    {CD_PIN, 5, "5"},
    {CD_PIN, 1e30, "1e+30"},
    {CD_PIN, INFINITY, "inf"},
    {CD_PIN, CD_NODE_MATCHED, "3"},
    {CD_REST_LENGTH, NAN, "nan"},
    {CD_REST_LENGTH, 0, "0"},
    {CD_REST_LENGTH, INFINITY, "inf"},
    {CD_REST_LENGTH, -0.5, "-0.5"},
    {CD_TENSION, NAN, "nan"},
    {CD_TENSION, INFINITY, "inf"},
    {CD_TENSION, -INFINITY, "-inf"},
    {CD_WIND, NAN, "nan"},
    {CD_WIND, INFINITY, "inf"},
    {CD_STRENGTH, NAN, "nan"},
    {CD_STRENGTH, 0, "0"},
    {CD_STRENGTH, -0.5, "-0.5"},
    {CD_STRENGTH, -INFINITY, "-inf"},
    {CD_REST_ANGLE, NAN, "nan"},
    {CD_REST_ANGLE, 3.1416, "3.1416"},
    {CD_REST_ANGLE, -3.1416, "-3.1416"},
    {CD_REST_ANGLE, INFINITY, "inf"},
};

static void lengths_beyond_their_range_are_refused(void** state) {
    (void)state;
    for (size_t i = 0; i < COUNT(too_small); ++i)
        refuses(rope, cd_chain_write_f64(rope, CD_REST_LENGTH, 0, 1, 3, 1, &too_small[i].value, 1), CD_ERROR_VALUE,
                text_of("values|0|%s|CD_REST_LENGTH takes numbers from 1e-60 to 1e60", too_small[i].shown));
    for (size_t i = 0; i < COUNT(too_large); ++i) {
        const double large = too_large[i].value;
        refuses(rope, cd_chain_write_f64(rope, CD_REST_LENGTH, 0, 1, 3, 1, &large, 1), CD_ERROR_VALUE,
                text_of("values|0|%s", too_large[i].shown));
    }
    static const double extremes[] = {1e60, 1e-60};
    for (size_t i = 0; i < COUNT(extremes); ++i) {
        scene_set(rope, CD_REST_LENGTH, 3, extremes[i]);
        assert_true(scene_get(rope, CD_REST_LENGTH, 3) == extremes[i]);
    }
    scene_set(rope, CD_REST_LENGTH, 3, 0.1);
}

/* The bad value as the second of three: good ones around it, so that a half-done write would show. */
static void a_bad_value_is_found_before_anything_is_written(void** state) {
    (void)state;
    for (size_t i = 0; i < COUNT(bad_values); ++i) {
        const cd_field field = bad_values[i].field;
        cd_chain* const c = field >= CD_REST_LENGTH ? rope : chain;
        const size_t each =
            field == CD_POSITION || field == CD_VELOCITY || field == CD_FORCE || field == CD_TARGET || field == CD_WIND
                ? COMPONENTS
                : 1;
        double doubles[3 * COMPONENTS];
        float floats[3 * COMPONENTS];
        for (size_t j = 0; j < 3 * each; ++j) {
            double good = field == CD_MASS || field == CD_STIFFNESS ? 0.75 : field == CD_BEND ? 0.25 : 0;
            if (field == CD_POSITION || field == CD_VELOCITY || field == CD_REST_LENGTH || field == CD_STRENGTH)
                good = 0.125;
            doubles[j] = j == each ? bad_values[i].value : good;
            floats[j] = (float)doubles[j];
        }
        const char* text = text_of("values|%zu|%s", each, bad_values[i].shown);
        refuses(c, cd_chain_write_f64(c, field, 0, 1, 6, 3, doubles, 3 * each), CD_ERROR_VALUE, text);
        refuses(c, cd_chain_write_f32(c, field, 0, 1, 6, 3, floats, 3 * each), CD_ERROR_VALUE, text);
    }
}

static void what_overflows_in_the_chains_precision_is_refused(void** state) {
    (void)state;
    const double huge = 1e300, most = 0x1.fffffep+127, beyond = 0x1.ffffffp+127; /* ties to 2^128: infinity */
    for (size_t i = 0; i < COUNT(per_strand); ++i) {
        cd_chain* single = scene_chain(1, 0, 1, CD_FLOAT32);
        ok(cd_chain_enable_field(single, per_strand[i]));
        refuses(single, cd_chain_write_f64(single, per_strand[i], 0, 1, 0, 1, &huge, 1), CD_ERROR_VALUE,
                "values|1e+300");
        refuses(single, cd_chain_write_f64(single, per_strand[i], 0, 1, 0, 1, &beyond, 1), CD_ERROR_VALUE, "values");
        ok(cd_chain_write_f64(single, per_strand[i], 0, 1, 0, 1, &most, 1));
        cd_chain_destroy(single);
    }
    cd_chain* single = scene_chain(1, 0, 1, CD_FLOAT32);
    refuses(single, cd_chain_set_gravity(single, &huge, 1), CD_ERROR_VALUE, "gravity|1e+300");
    refuses(single, cd_chain_impulse(single, 0, 0, &huge, 1), CD_ERROR_VALUE, "impulse|1e+300");
    refuses(single, cd_chain_impulse(single, 0, 0, &(const double){1e50}, 1), CD_ERROR_VALUE,
            "impulse[0]|1e+50|velocity");
    refuses(single, cd_chain_attach(single, 0, 0, 1, 1, &huge, 1), CD_ERROR_VALUE, "target|1e+300");
    cd_chain_destroy(single);
}

static void a_pinned_node_takes_no_velocity(void** state) {
    (void)state;
    const double v[COMPONENTS] = {0, 0.25}, zero[COMPONENTS] = {0, 0};
    const float v32[COMPONENTS] = {0, 0.25f};
    const size_t pinned = NODES / 2; /* in scene_everything */
    assert_true(scene_get(chain, CD_PIN, pinned) == CD_NODE_PINNED);
    refuses(chain, cd_chain_write_f64(chain, CD_VELOCITY, 1, 1, pinned, 1, v, 2), CD_ERROR_VALUE, "values|1|0.25");
    refuses(chain, cd_chain_write_f32(chain, CD_VELOCITY, 1, 1, pinned, 1, v32, 2), CD_ERROR_VALUE, "values|1|0.25");
    ok(cd_chain_write_f64(chain, CD_VELOCITY, 1, 1, pinned, 1, zero, 2));
}

static void held_nodes_are_not_joined_by_a_weld(void** state) {
    (void)state;
    const double weld = INFINITY, welds[3] = {INFINITY, INFINITY, INFINITY};
    for (cd_node a = CD_NODE_PINNED; a <= CD_NODE_DRIVEN; ++a) {
        for (cd_node b = CD_NODE_PINNED; b <= CD_NODE_DRIVEN; ++b) {
            cd_chain* c = scene_chain(1, 5, 1, CD_FLOAT64);
            ok(cd_chain_enable_field(c, CD_STIFFNESS));
            scene_set(c, CD_PIN, 1, a);
            scene_set(c, CD_PIN, 2, b);
            refuses(c, cd_chain_weld(c, 0, 1), CD_ERROR_UNSUPPORTED, "spring|1");
            scene_set(c, CD_PIN, 2, CD_NODE_FREE);
            scene_set(c, CD_PIN, 4, b);
            ok(cd_chain_weld(c, 0, 1));
            ok(cd_chain_weld(c, 0, 2));
            refuses(c, cd_chain_weld(c, 0, 3), CD_ERROR_UNSUPPORTED, "spring|3"); /* through the welds between */
            refuses(c, cd_chain_write_f64(c, CD_STIFFNESS, 0, 1, 3, 1, &weld, 1), CD_ERROR_UNSUPPORTED, "");
            refuses(c, cd_chain_write_f64(c, CD_STIFFNESS, 0, 1, 1, 3, welds, 3), CD_ERROR_UNSUPPORTED, "");
            scene_set(c, CD_PIN, 4, CD_NODE_FREE);
            ok(cd_chain_weld(c, 0, 3));
            const double kind = b;
            refuses(c, cd_chain_write_f64(c, CD_PIN, 0, 1, 4, 1, &kind, 1), CD_ERROR_UNSUPPORTED, "");
            cd_chain_destroy(c);
        }
    }
}

static void every_field_argument_in_the_header_was_tried(void** state) {
    (void)state;
    all_field_arguments_were_tried("chain");
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(no_number_is_taken_for_a_field),
        cmocka_unit_test(only_ropes_have_the_fields_of_ropes),
        cmocka_unit_test(a_field_that_is_off_is_said_to_be_disabled),
        cmocka_unit_test(what_has_no_view_or_no_switch_is_unsupported),
        cmocka_unit_test(no_range_beyond_the_end_is_taken),
        cmocka_unit_test(fields_that_the_strands_share_have_strand_0_only),
        cmocka_unit_test(no_spring_beyond_the_end_of_a_rope_is_taken),
        cmocka_unit_test(no_buffer_of_another_length_is_taken),
        cmocka_unit_test(a_bad_value_is_found_before_anything_is_written),
        cmocka_unit_test(lengths_beyond_their_range_are_refused),
        cmocka_unit_test(what_overflows_in_the_chains_precision_is_refused),
        cmocka_unit_test(a_pinned_node_takes_no_velocity),
        cmocka_unit_test(held_nodes_are_not_joined_by_a_weld),
        cmocka_unit_test(every_field_argument_in_the_header_was_tried),
    };
    return cmocka_run_group_tests(tests, set_up, tear_down);
}
