/* Fields: what is written is what is read, in any range and either precision; switching on and off; views. */
#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "check.h"
#include "scene.h"

enum { STRANDS = 3, SPRINGS = 6, NODES = SPRINGS + 1, COMPONENTS = 2, ALL = STRANDS * NODES * COMPONENTS };

static const struct field {
    cd_field field;
    int optional, per_strand;
} fields[] = {{CD_POSITION, 0, 1}, {CD_VELOCITY, 0, 1},  {CD_FORCE, 1, 1}, {CD_TARGET, 1, 1},
              {CD_MASS, 1, 0},     {CD_STIFFNESS, 1, 0}, {CD_BEND, 1, 0},  {CD_PIN, 0, 0}};

static cd_chain* chain_with(cd_precision precision, cd_field field) {
    cd_chain* chain = scene_chain(STRANDS, SPRINGS, COMPONENTS, precision);
    ok(cd_chain_enable_field(chain, field));
    return chain;
}

/* Numbers that need more than 24 bits, valid in every field but the pins. */
static void fill(cd_field field, double* values, size_t count, uint64_t seed) {
    for (size_t i = 0; i < count; ++i) {
        const double noise = scene_noise(&seed);
        values[i] = field == CD_POSITION || field == CD_VELOCITY || field == CD_FORCE || field == CD_TARGET
                        ? noise * 1e3
                        : fabs(noise) + 1e-3;
        if (field == CD_PIN) values[i] = (double)(i % 3);
    }
}

/* What is left of a number that was written to a field of this chain. */
static double kept(const struct field* f, cd_precision precision, double value) {
    return f->per_strand && precision == CD_FLOAT32 ? (double)(float)value : value;
}

static void what_is_written_is_read_back_rounded_once(void** state) {
    (void)state;
    for (size_t i = 0; i < COUNT(fields); ++i) {
        for (cd_precision precision = CD_FLOAT32; precision <= CD_FLOAT64; ++precision) {
            const struct field* f = &fields[i];
            cd_chain* chain = chain_with(precision, f->field);
            const size_t strands = scene_field_strands(chain, f->field), items = scene_field_items(chain, f->field);
            const size_t count = scene_field_count(chain, f->field);
            double wide[ALL], wide_back[ALL];
            float narrow[ALL], narrow_back[ALL];
            fill(f->field, wide, count, 11);
            ok(cd_chain_write_f64(chain, f->field, 0, strands, 0, items, wide, count));
            ok(cd_chain_read_f64(chain, f->field, 0, strands, 0, items, wide_back, count));
            ok(cd_chain_read_f32(chain, f->field, 0, strands, 0, items, narrow_back, count));
            for (size_t j = 0; j < count; ++j) {
                assert_true(wide_back[j] == kept(f, precision, wide[j]));
                assert_true(narrow_back[j] == (float)wide[j]);
            }
            for (size_t j = 0; j < count; ++j) narrow[j] = (float)wide[count - 1 - j];
            ok(cd_chain_write_f32(chain, f->field, 0, strands, 0, items, narrow, count));
            ok(cd_chain_read_f32(chain, f->field, 0, strands, 0, items, narrow_back, count));
            ok(cd_chain_read_f64(chain, f->field, 0, strands, 0, items, wide_back, count));
            for (size_t j = 0; j < count; ++j)
                assert_true(narrow_back[j] == narrow[j] && wide_back[j] == (double)narrow[j]);
            cd_chain_destroy(chain);
        }
    }
}

static void a_range_touches_what_it_names_and_nothing_else(void** state) {
    (void)state;
    for (size_t i = 0; i < COUNT(fields); ++i) {
        const struct field* f = &fields[i];
        cd_chain* chain = chain_with(CD_FLOAT64, f->field);
        const size_t strands = scene_field_strands(chain, f->field), items = scene_field_items(chain, f->field);
        const size_t count = scene_field_count(chain, f->field), each = count / strands / items;
        double model[ALL], part[ALL], back[ALL];
        fill(f->field, model, count, 21);
        scene_write(chain, f->field, model);
        uint64_t seed = 22;
        for (size_t first_strand = 0; first_strand < strands; ++first_strand)
            for (size_t some = 1; first_strand + some <= strands; ++some)
                for (size_t first = 0; first < items; ++first)
                    for (size_t n = 1; first + n <= items; ++n) {
                        const size_t size = some * n * each;
                        fill(f->field, part, size, seed++);
                        ok(cd_chain_write_f64(chain, f->field, first_strand, some, first, n, part, size));
                        for (size_t s = 0; s < some; ++s)
                            memcpy(&model[((first_strand + s) * items + first) * each], &part[s * n * each],
                                   n * each * sizeof *part);
                        scene_read(chain, f->field, back);
                        assert_same_bits(back, model, count);
                        memset(back, 0, sizeof back);
                        ok(cd_chain_read_f64(chain, f->field, first_strand, some, first, n, back, size));
                        assert_same_bits(back, part, size);
                    }
        cd_chain_destroy(chain);
    }
}

static void an_empty_range_is_no_error_and_does_nothing(void** state) {
    (void)state;
    cd_chain* chain = chain_with(CD_FLOAT64, CD_MASS);
    const uint64_t before = hash_of(chain);
    double none[1] = {NAN};
    for (size_t first = 0; first <= NODES; ++first) {
        ok(cd_chain_write_f64(chain, CD_POSITION, 0, STRANDS, first, 0, none, 0));
        ok(cd_chain_read_f64(chain, CD_POSITION, 0, STRANDS, first, 0, none, 0));
        ok(cd_chain_write_f64(chain, CD_MASS, 0, 0, first, 0, none, 0));
    }
    ok(cd_chain_write_f64(chain, CD_POSITION, STRANDS, 0, 0, NODES, none, 0));
    assert_int_equal(hash_of(chain), before);
    assert_true(isnan(none[0]));
    cd_chain_destroy(chain);
}

static void a_wide_chain_read_as_float32_overflows_to_infinity(void** state) {
    (void)state;
    cd_chain* chain = scene_chain(1, 0, 2, CD_FLOAT64);
    const double x[2] = {1e300, -1e39};
    float back[2];
    ok(cd_chain_write_f64(chain, CD_POSITION, 0, 1, 0, 1, x, 2));
    ok(cd_chain_read_f32(chain, CD_POSITION, 0, 1, 0, 1, back, 2));
    assert_true(isinf(back[0]) && back[0] > 0 && isinf(back[1]) && back[1] < 0);
    cd_chain_destroy(chain);
}

/* The largest number of each precision is one, and the next above it is none. */
static void the_largest_numbers_can_be_written(void** state) {
    (void)state;
    for (cd_precision precision = CD_FLOAT32; precision <= CD_FLOAT64; ++precision) {
        cd_chain* chain = scene_chain(1, 0, 2, precision);
        const double most = precision == CD_FLOAT32 ? (double)FLT_MAX : DBL_MAX;
        const double x[2] = {most, -most}, beyond[2] = {0, nextafter(most, INFINITY)};
        const float narrow[2] = {-FLT_MAX, FLT_MAX}, wide[2] = {0, INFINITY};
        double back[2];
        ok(cd_chain_write_f64(chain, CD_POSITION, 0, 1, 0, 1, x, 2));
        ok(cd_chain_read_f64(chain, CD_POSITION, 0, 1, 0, 1, back, 2));
        assert_same_bits(back, x, 2);
        assert_int_equal(cd_chain_write_f64(chain, CD_POSITION, 0, 1, 0, 1, beyond, 2), CD_ERROR_VALUE);
        ok(cd_chain_write_f32(chain, CD_POSITION, 0, 1, 0, 1, narrow, 2));
        assert_int_equal(cd_chain_write_f32(chain, CD_POSITION, 0, 1, 0, 1, wide, 2), CD_ERROR_VALUE);
        ok(cd_chain_read_f64(chain, CD_POSITION, 0, 1, 0, 1, back, 2));
        assert_true(back[0] == -(double)FLT_MAX && back[1] == (double)FLT_MAX);
        cd_chain_destroy(chain);
    }
}

static void a_field_switched_on_holds_the_uniform_values(void** state) {
    (void)state;
    static const struct {
        cd_mass_rule rule;
        int32_t ring;
        double end_mass, mass, stiffness, bend; /* of totals 2, 3 and 0.5 on 6 springs, in a ring 7 */
    } cases[] = {{CD_MASS_EQUAL, 0, 2.0 / 7, 2.0 / 7, 18, 108},
                 {CD_MASS_HALF_ENDS, 0, 1.0 / 6, 2.0 / 6, 18, 108},
                 {CD_MASS_EQUAL, 1, 2.0 / 7, 2.0 / 7, 21, 171.5},
                 {CD_MASS_HALF_ENDS, 1, 2.0 / 7, 2.0 / 7, 21, 171.5}};
    for (size_t i = 0; i < COUNT(cases); ++i) {
        cd_chain* chain = scene_chain(STRANDS, SPRINGS, COMPONENTS, CD_FLOAT64);
        scene_lay_out(chain, 0.25);
        ok(cd_chain_set_mass(chain, 2));
        ok(cd_chain_set_mass_rule(chain, cases[i].rule));
        ok(cd_chain_set_stiffness(chain, 3));
        ok(cd_chain_set_bend(chain, 0.5));
        ok(cd_chain_set_ring(chain, cases[i].ring));
        for (size_t j = 0; j < COUNT(fields); ++j) ok(cd_chain_enable_field(chain, fields[j].field));
        double x[ALL], target[ALL], force[ALL];
        scene_read(chain, CD_POSITION, x);
        scene_read(chain, CD_TARGET, target);
        scene_read(chain, CD_FORCE, force);
        assert_same_bits(x, target, ALL);
        for (size_t j = 0; j < ALL; ++j) assert_true(force[j] == 0);
        for (size_t node = 0; node < NODES; ++node) {
            const int end = node == 0 || node == NODES - 1;
            assert_near(scene_get(chain, CD_MASS, node), end ? cases[i].end_mass : cases[i].mass, 1e-15, 0);
            if (!end || cases[i].ring) assert_near(scene_get(chain, CD_BEND, node), cases[i].bend, 1e-15, 0);
        }
        assert_int_equal(scene_field_items(chain, CD_STIFFNESS), cases[i].ring ? 7 : 6);
        for (size_t spring = 0; spring < scene_springs(chain); ++spring)
            assert_near(scene_get(chain, CD_STIFFNESS, spring), cases[i].stiffness, 1e-15, 0);
        cd_chain_destroy(chain);
    }
}

static void a_single_node_has_all_the_mass(void** state) {
    (void)state;
    for (cd_mass_rule rule = CD_MASS_EQUAL; rule <= CD_MASS_HALF_ENDS; ++rule) {
        cd_chain* chain = scene_chain(1, 0, 1, CD_FLOAT64);
        ok(cd_chain_set_mass(chain, 3));
        ok(cd_chain_set_mass_rule(chain, rule));
        ok(cd_chain_enable_field(chain, CD_MASS));
        assert_true(scene_get(chain, CD_MASS, 0) == 3);
        cd_chain_destroy(chain);
    }
}

static void a_single_node_has_no_spring_to_switch_on(void** state) {
    (void)state;
    cd_chain* chain = scene_chain(1, 0, 2, CD_FLOAT32);
    double nothing = 7;
    ok(cd_chain_enable_field(chain, CD_STIFFNESS));
    ok(cd_chain_write_f64(chain, CD_STIFFNESS, 0, 1, 0, 0, NULL, 0));
    ok(cd_chain_read_f64(chain, CD_STIFFNESS, 0, 1, 0, 0, &nothing, 0));
    assert_true(nothing == 7);
    refuses(chain, cd_chain_read_f64(chain, CD_STIFFNESS, 0, 1, 0, 1, &nothing, 1), CD_ERROR_RANGE, "springs");
    cd_chain_destroy(chain);
}

static void switching_on_what_is_on_keeps_its_values(void** state) {
    (void)state;
    cd_chain* chain = scene_chain(STRANDS, 9, COMPONENTS, CD_FLOAT32);
    scene_everything(chain);
    const uint64_t before = hash_of(chain);
    size_t bytes, bytes_after;
    ok(cd_chain_get_memory(chain, &bytes));
    for (size_t i = 0; i < COUNT(fields); ++i) ok(cd_chain_enable_field(chain, fields[i].field));
    ok(cd_chain_get_memory(chain, &bytes_after));
    assert_int_equal(hash_of(chain), before);
    assert_int_equal(bytes_after, bytes);
    cd_chain_destroy(chain);
}

static void a_field_switched_off_gives_its_memory_back_and_its_values_up(void** state) {
    (void)state;
    for (size_t i = 0; i < COUNT(fields); ++i) {
        if (!fields[i].optional) continue;
        cd_chain* chain = scene_chain(STRANDS, SPRINGS, COMPONENTS, CD_FLOAT64);
        cd_chain* never = scene_chain(STRANDS, SPRINGS, COMPONENTS, CD_FLOAT64);
        ok(cd_chain_set_bend(chain, 0.01));
        ok(cd_chain_set_bend(never, 0.01));
        scene_lay_out(chain, 0.1);
        scene_lay_out(never, 0.1);
        size_t before, with, after;
        ok(cd_chain_get_memory(chain, &before));
        ok(cd_chain_enable_field(chain, fields[i].field));
        ok(cd_chain_get_memory(chain, &with));
        assert_true(with > before);
        if (fields[i].field == CD_TARGET) ok(cd_chain_attach(chain, 0, 2, 10, 1, NULL, COMPONENTS));
        double values[ALL];
        fill(fields[i].field, values, scene_field_count(chain, fields[i].field), 31);
        scene_write(chain, fields[i].field, values);
        assert_int_not_equal(hash_of(chain), hash_of(never));
        ok(cd_chain_disable_field(chain, fields[i].field));
        ok(cd_chain_get_memory(chain, &after));
        assert_int_equal(after, before);
        ok(cd_chain_disable_field(chain, fields[i].field)); /* off already */
        ok(cd_chain_step(chain, 0.01, 3));
        ok(cd_chain_step(never, 0.01, 3));
        assert_int_equal(hash_of(chain), hash_of(never));
        cd_chain_destroy(chain);
        cd_chain_destroy(never);
    }
}

static void setting_a_total_writes_its_field_anew(void** state) {
    (void)state;
    cd_chain* chain = scene_chain(1, SPRINGS, 1, CD_FLOAT32);
    double number;
    for (size_t i = 0; i < COUNT(fields); ++i) ok(cd_chain_enable_field(chain, fields[i].field));
    scene_set(chain, CD_MASS, 3, 9);
    scene_set(chain, CD_STIFFNESS, 3, 9);
    scene_set(chain, CD_BEND, 3, 9);
    ok(cd_chain_get_mass(chain, &number));
    assert_true(number == 1); /* the total last set, not the sum */
    ok(cd_chain_set_mass(chain, 14));
    assert_true(scene_get(chain, CD_MASS, 3) == 2 && scene_get(chain, CD_STIFFNESS, 3) == 9);
    ok(cd_chain_set_stiffness(chain, 0.5));
    assert_true(scene_get(chain, CD_STIFFNESS, 3) == 3 && scene_get(chain, CD_BEND, 3) == 9);
    ok(cd_chain_set_bend(chain, 0.25));
    assert_true(scene_get(chain, CD_BEND, 3) == 54);
    ok(cd_chain_set_mass_rule(chain, CD_MASS_HALF_ENDS));
    assert_near(scene_get(chain, CD_MASS, 0), 14.0 / 12, 1e-15, 0);
    assert_near(scene_get(chain, CD_MASS, 3), 14.0 / 6, 1e-15, 0);
    ok(cd_chain_set_mass(chain, 12));
    assert_true(scene_get(chain, CD_MASS, 0) == 1 && scene_get(chain, CD_MASS, 3) == 2);
    cd_chain_destroy(chain);
}

static void a_ring_deals_the_totals_out_anew(void** state) {
    (void)state;
    cd_chain* chain = scene_chain(1, SPRINGS, 1, CD_FLOAT64);
    ok(cd_chain_set_mass(chain, 14));
    ok(cd_chain_set_mass_rule(chain, CD_MASS_HALF_ENDS));
    for (size_t i = 0; i < COUNT(fields); ++i) ok(cd_chain_enable_field(chain, fields[i].field));
    ok(cd_chain_set_bend(chain, 1));
    scene_set(chain, CD_STIFFNESS, 2, 9);
    ok(cd_chain_set_ring(chain, 1));
    for (size_t i = 0; i <= SPRINGS; ++i) assert_true(scene_get(chain, CD_STIFFNESS, i) == 7);
    for (size_t i = 0; i < NODES; ++i) {
        assert_true(scene_get(chain, CD_MASS, i) == 2);
        assert_true(scene_get(chain, CD_BEND, i) == 343);
    }
    scene_set(chain, CD_STIFFNESS, 2, 9);
    ok(cd_chain_set_ring(chain, 1)); /* one already: nothing happens */
    assert_true(scene_get(chain, CD_STIFFNESS, 2) == 9);
    scene_set(chain, CD_STIFFNESS, SPRINGS, 9);
    ok(cd_chain_set_ring(chain, 0));
    for (size_t i = 0; i < SPRINGS; ++i) assert_true(scene_get(chain, CD_STIFFNESS, i) == 6);
    refuses(chain, cd_chain_read_f64(chain, CD_STIFFNESS, 0, 1, SPRINGS, 1, out.number, 1), CD_ERROR_RANGE,
            name_and_size("first", SPRINGS));
    cd_chain_destroy(chain);
}

static void a_view_shows_the_fields_own_memory(void** state) {
    (void)state;
    for (size_t i = 0; i < COUNT(fields); ++i) {
        for (cd_precision precision = CD_FLOAT32; precision <= CD_FLOAT64 && fields[i].per_strand; ++precision) {
            cd_chain* chain = chain_with(precision, fields[i].field);
            const void* data;
            size_t stride[3];
            ok(cd_chain_view(chain, fields[i].field, &data, &stride[0], &stride[1], &stride[2]));
            double values[ALL];
            fill(fields[i].field, values, ALL, 41);
            scene_write(chain, fields[i].field, values);
            if (fields[i].field != CD_FORCE) ok(cd_chain_step(chain, 0.01, 2));
            scene_read(chain, fields[i].field, values);
            for (size_t j = 0; j < ALL; ++j) {
                const size_t strand = j / (NODES * COMPONENTS), node = j / COMPONENTS % NODES, c = j % COMPONENTS;
                const char* at = (const char*)data + strand * stride[0] + node * stride[1] + c * stride[2];
                double seen;
                if (precision == CD_FLOAT64) memcpy(&seen, at, sizeof seen);
                else {
                    float narrow;
                    memcpy(&narrow, at, sizeof narrow);
                    seen = narrow;
                }
                assert_true(seen == values[j]);
            }
            cd_chain_destroy(chain);
        }
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_is_written_is_read_back_rounded_once),
        cmocka_unit_test(a_range_touches_what_it_names_and_nothing_else),
        cmocka_unit_test(an_empty_range_is_no_error_and_does_nothing),
        cmocka_unit_test(a_wide_chain_read_as_float32_overflows_to_infinity),
        cmocka_unit_test(the_largest_numbers_can_be_written),
        cmocka_unit_test(a_field_switched_on_holds_the_uniform_values),
        cmocka_unit_test(a_single_node_has_all_the_mass),
        cmocka_unit_test(a_single_node_has_no_spring_to_switch_on),
        cmocka_unit_test(switching_on_what_is_on_keeps_its_values),
        cmocka_unit_test(a_field_switched_off_gives_its_memory_back_and_its_values_up),
        cmocka_unit_test(setting_a_total_writes_its_field_anew),
        cmocka_unit_test(a_ring_deals_the_totals_out_anew),
        cmocka_unit_test(a_view_shows_the_fields_own_memory),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
