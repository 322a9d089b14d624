/* A membrane's fields: exact transfer of any rectangle in both precisions, views, uniform values, switching. */
#include <math.h>
#include <stdbool.h>
#include <string.h>

#include "check.h"
#include "cloth.h"
#include "scene.h"
#include "sheet.h"

enum { NU = 5, NV = 3, COLUMNS = NU + 1, ROWS = NV + 1, COMPONENTS = 3, ALL = COLUMNS * ROWS * COMPONENTS };

static const struct field {
    cd_field field;
    bool is_state, optional;
} fields[] = {{CD_POSITION, true, false},
              {CD_VELOCITY, true, false},
              {CD_FORCE, true, true},
              {CD_TARGET, true, true},
              {CD_MASS, false, true},
              {CD_STIFFNESS_U, false, true},
              {CD_STIFFNESS_V, false, true},
              {CD_PIN, false, true},
              {CD_MASK, false, true},
              {CD_REST_LENGTH_U, false, true},
              {CD_REST_LENGTH_V, false, true},
              {CD_WIND, true, true},
              {CD_BREAKING_STRAIN_U, false, true},
              {CD_BREAKING_STRAIN_V, false, true}};
enum { OF_ALL = COUNT(fields) - 5 }; /* the rest are of cloth */

static void give_lengths_for(cd_membrane* m, cd_field field) {
    if (field > CD_MASK) ok(cd_membrane_set_rest_length(m, 1, 0.5));
    if (field == CD_BREAKING_STRAIN_U) ok(cd_membrane_enable_field(m, CD_STIFFNESS_U)); /* which it needs */
    if (field == CD_BREAKING_STRAIN_V) ok(cd_membrane_enable_field(m, CD_STIFFNESS_V));
}

static cd_membrane* membrane_with(cd_precision precision, cd_field field) {
    cd_membrane* m = cloth(NU, NV, COMPONENTS, precision);
    give_lengths_for(m, field);
    ok(cd_membrane_enable_field(m, field));
    return m;
}

/* Numbers that are valid in the field and, most of them, no float32 numbers. */
static void fill(cd_field field, double* values, size_t count, uint64_t seed) {
    for (size_t i = 0; i < count; ++i) {
        const double noise = scene_noise(&seed);
        values[i] = noise * 1e3;
        if (field == CD_MASS || field == CD_STIFFNESS_U || field == CD_STIFFNESS_V || field == CD_REST_LENGTH_U ||
            field == CD_REST_LENGTH_V || field == CD_BREAKING_STRAIN_U || field == CD_BREAKING_STRAIN_V)
            values[i] = fabs(noise) + 1e-3;
        if (field == CD_PIN) values[i] = noise > 0 ? CD_NODE_DRIVEN : CD_NODE_FREE;
        if (field == CD_MASK) values[i] = noise > 0;
    }
}

static double kept(const struct field* f, cd_precision precision, double value) {
    return f->is_state && precision == CD_FLOAT32 ? (double)(float)value : value;
}

static void what_is_written_is_read_back_rounded_once(void** state) {
    (void)state;
    for (size_t i = 0; i < COUNT(fields); ++i) {
        for (cd_precision precision = CD_FLOAT32; precision <= CD_FLOAT64; ++precision) {
            const struct field* f = &fields[i];
            cd_membrane* m = membrane_with(precision, f->field);
            const struct cloth_extent e = cloth_extent(m, f->field);
            double wide[ALL], wide_back[ALL];
            float narrow[ALL], narrow_back[ALL];
            fill(f->field, wide, e.count, 11);
            ok(cd_membrane_write_f64(m, f->field, 0, 0, e.columns, e.rows, wide, e.count));
            ok(cd_membrane_read_f64(m, f->field, 0, 0, e.columns, e.rows, wide_back, e.count));
            ok(cd_membrane_read_f32(m, f->field, 0, 0, e.columns, e.rows, narrow_back, e.count));
            for (size_t j = 0; j < e.count; ++j) {
                assert_true(wide_back[j] == kept(f, precision, wide[j]));
                assert_true(narrow_back[j] == (float)wide[j]);
            }
            for (size_t j = 0; j < e.count; ++j) narrow[j] = (float)wide[e.count - 1 - j];
            ok(cd_membrane_write_f32(m, f->field, 0, 0, e.columns, e.rows, narrow, e.count));
            ok(cd_membrane_read_f32(m, f->field, 0, 0, e.columns, e.rows, narrow_back, e.count));
            ok(cd_membrane_read_f64(m, f->field, 0, 0, e.columns, e.rows, wide_back, e.count));
            for (size_t j = 0; j < e.count; ++j)
                assert_true(narrow_back[j] == narrow[j] && wide_back[j] == (double)narrow[j]);
            cd_membrane_destroy(m);
        }
    }
}

static void a_rectangle_touches_what_it_names_and_nothing_else(void** state) {
    (void)state;
    for (size_t i = 0; i < COUNT(fields); ++i) {
        const struct field* f = &fields[i];
        cd_membrane* m = membrane_with(CD_FLOAT64, f->field);
        const struct cloth_extent e = cloth_extent(m, f->field);
        double model[ALL], part[ALL], back[ALL];
        fill(f->field, model, e.count, 21);
        cloth_write(m, f->field, model);
        uint64_t seed = 22;
        for (size_t u = 0; u < e.columns; ++u)
            for (size_t v = 0; v < e.rows; ++v)
                for (size_t n_u = 1; u + n_u <= e.columns; ++n_u)
                    for (size_t n_v = 1; v + n_v <= e.rows; ++n_v) {
                        const size_t size = n_u * n_v * e.components;
                        fill(f->field, part, size, seed++);
                        ok(cd_membrane_write_f64(m, f->field, u, v, n_u, n_v, part, size));
                        for (size_t row = 0; row < n_v; ++row)
                            memcpy(&model[((v + row) * e.columns + u) * e.components], &part[row * n_u * e.components],
                                   n_u * e.components * sizeof *part);
                        cloth_read(m, f->field, back);
                        assert_same_bits(back, model, e.count);
                        memset(back, 0, sizeof back);
                        ok(cd_membrane_read_f64(m, f->field, u, v, n_u, n_v, back, size));
                        assert_same_bits(back, part, size);
                    }
        cd_membrane_destroy(m);
    }
}

static void fields_do_not_touch_each_other(void** state) {
    (void)state;
    for (cd_precision precision = CD_FLOAT32; precision <= CD_FLOAT64; ++precision) {
        cd_membrane* m = cloth(NU, NV, COMPONENTS, precision);
        double values[COUNT(fields)][ALL], back[ALL];
        give_lengths_for(m, CD_WIND);
        for (size_t i = 0; i < COUNT(fields); ++i) ok(cd_membrane_enable_field(m, fields[i].field));
        for (size_t i = 0; i < COUNT(fields); ++i) {
            const size_t count = cloth_extent(m, fields[i].field).count;
            fill(fields[i].field, values[i], count, 30 + i);
            for (size_t j = 0; j < count; ++j) values[i][j] = (double)(float)values[i][j];
            cloth_write(m, fields[i].field, values[i]);
        }
        for (size_t j = 0; j < ALL; ++j) /* absent nodes stand still */
            if (sheet_get(m, CD_MASK, j / COMPONENTS % COLUMNS, j / COMPONENTS / COLUMNS) == 0) values[1][j] = 0;
        for (size_t i = 0; i < COUNT(fields); ++i) {
            cloth_read(m, fields[i].field, back);
            assert_same_bits(back, values[i], cloth_extent(m, fields[i].field).count);
        }
        cd_membrane_destroy(m);
    }
}

static void an_empty_rectangle_is_no_error_and_does_nothing(void** state) {
    (void)state;
    cd_membrane* m = membrane_with(CD_FLOAT64, CD_MASS);
    const uint64_t before = hash_of(m);
    double none[1] = {NAN};
    for (size_t u = 0; u <= COLUMNS; ++u) {
        ok(cd_membrane_write_f64(m, CD_POSITION, u, 0, 0, ROWS, none, 0));
        ok(cd_membrane_read_f64(m, CD_POSITION, u, ROWS, 0, 0, none, 0));
        ok(cd_membrane_write_f64(m, CD_MASS, u, 0, 0, 0, NULL, 0));
    }
    ok(cd_membrane_write_f64(m, CD_POSITION, 0, ROWS, COLUMNS, 0, none, 0));
    assert_int_equal(hash_of(m), before);
    assert_true(isnan(none[0]));
    cd_membrane_destroy(m);
}

static void a_view_shows_the_fields_own_memory(void** state) {
    (void)state;
    for (size_t i = 0; i < COUNT(fields); ++i) {
        const bool has_view = fields[i].is_state && fields[i].field != CD_WIND;
        for (cd_precision precision = CD_FLOAT32; precision <= CD_FLOAT64 && has_view; ++precision) {
            cd_membrane* m = membrane_with(precision, fields[i].field);
            const void* data;
            size_t stride[3];
            ok(cd_membrane_view(m, fields[i].field, &data, &stride[0], &stride[1], &stride[2]));
            const size_t number = precision == CD_FLOAT64 ? sizeof(double) : sizeof(float);
            assert_int_equal(stride[0], number); /* a row of one component lies side by side */
            assert_true(stride[1] >= COLUMNS * number && stride[2] >= ROWS * stride[1]);
            double values[ALL];
            fill(fields[i].field, values, ALL, 41);
            cloth_write(m, fields[i].field, values);
            if (fields[i].field != CD_FORCE) ok(cd_membrane_step(m, 0.01, 2));
            cloth_read(m, fields[i].field, values);
            for (size_t j = 0; j < ALL; ++j) {
                const size_t u = j / COMPONENTS % COLUMNS, v = j / COMPONENTS / COLUMNS, c = j % COMPONENTS;
                const char* at = (const char*)data + u * stride[0] + v * stride[1] + c * stride[2];
                double seen;
                if (precision == CD_FLOAT64) memcpy(&seen, at, sizeof seen);
                else {
                    float narrow;
                    memcpy(&narrow, at, sizeof narrow);
                    seen = narrow;
                }
                assert_true(seen == values[j]);
            }
            cd_membrane_destroy(m);
        }
    }
}

/* Of a sheet of 5 x 3 springs with mass 3, stiffness 2 along u and 4 along v, under both rules and all rings. */
static const struct dealt {
    cd_mass_rule rule;
    int32_t ring[2];
    double mass, along_u, along_v; /* inside */
    double at_u, at_v;             /* the share of a line at the end of u, and of v */
} dealt[] = {
    {CD_MASS_EQUAL, {0, 0}, 3.0 / 24, 2 * 5.0 / 4, 4 * 3.0 / 6, 1, 1},
    {CD_MASS_EQUAL, {1, 0}, 3.0 / 24, 2 * 6.0 / 4, 4 * 3.0 / 6, 1, 1},
    {CD_MASS_EQUAL, {1, 1}, 3.0 / 24, 2 * 6.0 / 4, 4 * 4.0 / 6, 1, 1},
    {CD_MASS_HALF_ENDS, {0, 0}, 3.0 / 15, 2 * 5.0 / 3, 4 * 3.0 / 5, 0.5, 0.5},
    {CD_MASS_HALF_ENDS, {1, 0}, 3.0 / 18, 2 * 6.0 / 3, 4 * 3.0 / 6, 1, 0.5},
    {CD_MASS_HALF_ENDS, {0, 1}, 3.0 / 20, 2 * 5.0 / 4, 4 * 4.0 / 5, 0.5, 1},
    {CD_MASS_HALF_ENDS, {1, 1}, 3.0 / 24, 2 * 6.0 / 4, 4 * 4.0 / 6, 1, 1},
};

static void a_field_switched_on_holds_the_uniform_values(void** state) {
    (void)state;
    for (size_t i = 0; i < COUNT(dealt); ++i) {
        const struct dealt* d = &dealt[i];
        cd_membrane* m = cloth(NU, NV, COMPONENTS, CD_FLOAT64);
        cloth_lay_out(m, 0.25);
        ok(cd_membrane_set_mass(m, 3));
        ok(cd_membrane_set_mass_rule(m, d->rule));
        ok(cd_membrane_set_stiffness(m, 2, 4));
        ok(cd_membrane_set_ring(m, d->ring[0], d->ring[1]));
        for (size_t j = 0; j < OF_ALL; ++j) ok(cd_membrane_enable_field(m, fields[j].field));
        double x[ALL], target[ALL], force[ALL];
        cloth_read(m, CD_POSITION, x);
        cloth_read(m, CD_TARGET, target);
        cloth_read(m, CD_FORCE, force);
        assert_same_bits(x, target, ALL);
        for (size_t j = 0; j < ALL; ++j) assert_true(force[j] == 0);
        double total = 0;
        for (size_t v = 0; v < ROWS; ++v)
            for (size_t u = 0; u < COLUMNS; ++u) {
                const double at_u = u == 0 || u == NU ? d->at_u : 1, at_v = v == 0 || v == NV ? d->at_v : 1;
                assert_near(sheet_get(m, CD_MASS, u, v), d->mass * at_u * at_v, 1e-15, 0);
                total += sheet_get(m, CD_MASS, u, v);
                assert_true(sheet_get(m, CD_PIN, u, v) == CD_NODE_FREE && sheet_get(m, CD_MASK, u, v) == 1);
                if (u < cloth_extent(m, CD_STIFFNESS_U).columns)
                    assert_near(sheet_get(m, CD_STIFFNESS_U, u, v), d->along_u * at_v, 1e-15, 0);
                if (v < cloth_extent(m, CD_STIFFNESS_V).rows)
                    assert_near(sheet_get(m, CD_STIFFNESS_V, u, v), d->along_v * at_u, 1e-15, 0);
            }
        assert_near(total, 3, 1e-14, 0);
        cd_membrane_destroy(m);
    }
}

static void sheets_without_springs_along_a_direction_have_their_masses(void** state) {
    (void)state;
    static const struct {
        size_t nu, nv;
        double first, inside; /* of mass 6 with half edges */
    } shapes[] = {{0, 0, 6, 6}, {3, 0, 1, 2}, {0, 3, 1, 2}, {1, 0, 3, 3}};
    for (size_t i = 0; i < COUNT(shapes); ++i) {
        cd_membrane* m = cloth(shapes[i].nu, shapes[i].nv, 1, CD_FLOAT32);
        ok(cd_membrane_set_mass(m, 6));
        ok(cd_membrane_set_mass_rule(m, CD_MASS_HALF_ENDS));
        ok(cd_membrane_enable_field(m, CD_MASS));
        ok(cd_membrane_enable_field(m, CD_STIFFNESS_U));
        ok(cd_membrane_enable_field(m, CD_STIFFNESS_V));
        assert_true(sheet_get(m, CD_MASS, 0, 0) == shapes[i].first);
        assert_true(sheet_get(m, CD_MASS, shapes[i].nu / 2, shapes[i].nv / 2) == shapes[i].inside);
        for (size_t u = 0; u < shapes[i].nu; ++u) assert_true(sheet_get(m, CD_STIFFNESS_U, u, 0) == shapes[i].nu);
        for (size_t v = 0; v < shapes[i].nv; ++v) assert_true(sheet_get(m, CD_STIFFNESS_V, 0, v) == shapes[i].nv);
        cloth_lay_out(m, 0.5);
        ok(cd_membrane_step(m, 0.01, 3));
        cd_membrane_destroy(m);
    }
}

static void switching_on_what_is_on_keeps_its_values(void** state) {
    (void)state;
    cd_membrane* m = cloth(NU, NV, COMPONENTS, CD_FLOAT32);
    cloth_everything(m);
    const uint64_t before = hash_of(m);
    size_t bytes, bytes_after;
    ok(cd_membrane_get_memory(m, &bytes));
    for (size_t i = 0; i < OF_ALL; ++i) ok(cd_membrane_enable_field(m, fields[i].field));
    ok(cd_membrane_get_memory(m, &bytes_after));
    assert_int_equal(hash_of(m), before);
    assert_int_equal(bytes_after, bytes);
    cd_membrane_destroy(m);
}

static void a_field_switched_off_gives_its_memory_back_and_its_values_up(void** state) {
    (void)state;
    for (size_t i = 0; i < COUNT(fields); ++i) {
        if (!fields[i].optional) continue;
        cd_membrane* m = cloth(NU, NV, COMPONENTS, CD_FLOAT64);
        cd_membrane* never = cloth(NU, NV, COMPONENTS, CD_FLOAT64);
        const double at_rest[ALL] = {0}; /* or else absent nodes would be stopped */
        cloth_drum(m);
        cloth_drum(never);
        cloth_write(m, CD_VELOCITY, at_rest);
        cloth_write(never, CD_VELOCITY, at_rest);
        give_lengths_for(m, fields[i].field);
        give_lengths_for(never, fields[i].field);
        size_t before, with, after;
        ok(cd_membrane_get_memory(m, &before));
        ok(cd_membrane_enable_field(m, fields[i].field));
        ok(cd_membrane_get_memory(m, &with));
        assert_true(with > before);
        if (fields[i].field == CD_TARGET) ok(cd_membrane_attach(m, 2, 1, 10, 1, NULL, COMPONENTS));
        double values[ALL];
        fill(fields[i].field, values, cloth_extent(m, fields[i].field).count, 31);
        cloth_write(m, fields[i].field, values);
        assert_int_not_equal(hash_of(m), hash_of(never));
        ok(cd_membrane_disable_field(m, fields[i].field));
        ok(cd_membrane_get_memory(m, &after));
        assert_int_equal(after, before);
        ok(cd_membrane_disable_field(m, fields[i].field)); /* off already */
        ok(cd_membrane_step(m, 0.01, 3));
        ok(cd_membrane_step(never, 0.01, 3));
        assert_int_equal(hash_of(m), hash_of(never));
        cd_membrane_destroy(m);
        cd_membrane_destroy(never);
    }
}

static void setting_a_total_writes_its_field_anew(void** state) {
    (void)state;
    cd_membrane* m = cloth(NU, NV, 1, CD_FLOAT32);
    double number;
    for (size_t i = 0; i < OF_ALL; ++i) ok(cd_membrane_enable_field(m, fields[i].field));
    sheet_set(m, CD_MASS, 3, 1, 9);
    sheet_set(m, CD_STIFFNESS_U, 3, 1, 9);
    sheet_set(m, CD_STIFFNESS_V, 3, 1, 9);
    ok(cd_membrane_get_mass(m, &number));
    assert_true(number == 1); /* the total last set, not the sum */
    ok(cd_membrane_set_mass(m, 48));
    assert_true(sheet_get(m, CD_MASS, 3, 1) == 2 && sheet_get(m, CD_STIFFNESS_U, 3, 1) == 9);
    ok(cd_membrane_set_stiffness(m, 4, 6));
    assert_true(sheet_get(m, CD_STIFFNESS_U, 3, 1) == 5 && sheet_get(m, CD_STIFFNESS_V, 3, 1) == 3);
    sheet_set(m, CD_STIFFNESS_U, 3, 1, 9);
    ok(cd_membrane_set_mass(m, 30));
    assert_true(sheet_get(m, CD_STIFFNESS_U, 3, 1) == 9);
    ok(cd_membrane_set_mass_rule(m, CD_MASS_HALF_ENDS)); /* deals all of them out anew */
    assert_true(sheet_get(m, CD_MASS, 3, 1) == 2 && sheet_get(m, CD_MASS, 0, 1) == 1);
    assert_true(sheet_get(m, CD_MASS, 0, 0) == 0.5);
    assert_near(sheet_get(m, CD_STIFFNESS_U, 3, 1), 4 * 5.0 / 3, 1e-15, 0);
    assert_near(sheet_get(m, CD_STIFFNESS_U, 3, 0), 2 * 5.0 / 3, 1e-15, 0);
    assert_near(sheet_get(m, CD_STIFFNESS_V, NU, 2), 3 * 3.0 / 5, 1e-15, 0);
    cd_membrane_destroy(m);
}

static void a_ring_deals_the_totals_out_anew(void** state) {
    (void)state;
    cd_membrane* m = cloth(NU, NV, 1, CD_FLOAT64);
    ok(cd_membrane_set_mass(m, 24));
    for (size_t i = 0; i < OF_ALL; ++i) ok(cd_membrane_enable_field(m, fields[i].field));
    sheet_set(m, CD_MASS, 2, 1, 9);
    sheet_set(m, CD_STIFFNESS_U, 2, 1, 9);
    sheet_set(m, CD_STIFFNESS_V, 2, 1, 9);
    ok(cd_membrane_set_ring(m, 1, 0));
    assert_true(sheet_get(m, CD_MASS, 2, 1) == 1);
    for (size_t u = 0; u < COLUMNS; ++u)
        for (size_t v = 0; v < ROWS; ++v) assert_true(sheet_get(m, CD_STIFFNESS_U, u, v) == 1.5);
    assert_true(sheet_get(m, CD_STIFFNESS_V, 2, 1) != 9);
    sheet_set(m, CD_STIFFNESS_U, 2, 1, 9);
    ok(cd_membrane_set_ring(m, 1, 0)); /* one already: nothing happens */
    assert_true(sheet_get(m, CD_STIFFNESS_U, 2, 1) == 9);
    sheet_set(m, CD_STIFFNESS_U, NU, 1, 9);
    ok(cd_membrane_set_ring(m, 0, 1));
    for (size_t u = 0; u < NU; ++u) assert_true(sheet_get(m, CD_STIFFNESS_U, u, 1) == 1.25);
    for (size_t v = 0; v < ROWS; ++v) assert_near(sheet_get(m, CD_STIFFNESS_V, 2, v), 4.0 / 6, 1e-15, 0);
    cd_membrane_destroy(m);
}

/* A number that was given to the closing spring is forgotten when the ring opens. */
static void what_is_not_there_leaves_no_trace_in_the_hash(void** state) {
    (void)state;
    cd_membrane* m = cloth(NU, NV, 1, CD_FLOAT64);
    cd_membrane* never = cloth(NU, NV, 1, CD_FLOAT64);
    ok(cd_membrane_enable_field(m, CD_STIFFNESS_U));
    ok(cd_membrane_enable_field(never, CD_STIFFNESS_U));
    ok(cd_membrane_set_ring(m, 1, 0));
    sheet_set(m, CD_STIFFNESS_U, NU, 2, 7);
    ok(cd_membrane_set_ring(m, 0, 0));
    assert_int_equal(hash_of(m), hash_of(never));
    cd_membrane_destroy(m);
    cd_membrane_destroy(never);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_is_written_is_read_back_rounded_once),
        cmocka_unit_test(a_rectangle_touches_what_it_names_and_nothing_else),
        cmocka_unit_test(fields_do_not_touch_each_other),
        cmocka_unit_test(an_empty_rectangle_is_no_error_and_does_nothing),
        cmocka_unit_test(a_view_shows_the_fields_own_memory),
        cmocka_unit_test(a_field_switched_on_holds_the_uniform_values),
        cmocka_unit_test(sheets_without_springs_along_a_direction_have_their_masses),
        cmocka_unit_test(switching_on_what_is_on_keeps_its_values),
        cmocka_unit_test(a_field_switched_off_gives_its_memory_back_and_its_values_up),
        cmocka_unit_test(setting_a_total_writes_its_field_anew),
        cmocka_unit_test(a_ring_deals_the_totals_out_anew),
        cmocka_unit_test(what_is_not_there_leaves_no_trace_in_the_hash),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
