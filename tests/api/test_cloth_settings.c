/* Membranes whose springs have a length: who has them, what is set for them and told of them, and what they refuse.
 * What they do as they move is tried in tests/physics. */
#include <math.h>
#include <string.h>

#include "check.h"
#include "cloth.h"
#include "sheet.h"

enum { NU = 6, NV = 4, COLUMNS = NU + 1, ROWS = NV + 1, NODES = COLUMNS * ROWS, ALL = 3 * NODES };

static cd_membrane* plain(cd_precision precision) {
    cd_membrane* m = cloth(NU, NV, 3, precision);
    cloth_lay_out(m, 0.25);
    return m;
}

/* Flat, at rest, each spring as long as it should be. */
static cd_membrane* flat(cd_precision precision) {
    cd_membrane* m = plain(precision);
    ok(cd_membrane_set_rest_length(m, 0.25 * NU, 0.25 * NV));
    return m;
}

static double lambda_of(const cd_membrane* m) {
    double lambda = -1;
    ok(cd_membrane_get_lambda(m, &lambda));
    return lambda;
}

static void getters_tell_what_was_set(void** state) {
    (void)state;
    for (cd_precision precision = CD_FLOAT32; precision <= CD_FLOAT64; ++precision) {
        cd_membrane* m = flat(precision);
        const double wind[3] = {1, -2, 0.5};
        double a, b, shown[3];
        size_t newton, gradient;
        ok(cd_membrane_get_rest_length(m, &a, &b));
        assert_true(a == 0.25 * NU && b == 0.25 * NV);
        ok(cd_membrane_set_shear(m, 12));
        ok(cd_membrane_get_shear(m, &a));
        assert_true(a == 12);
        ok(cd_membrane_set_compression(m, 13));
        ok(cd_membrane_get_compression(m, &a));
        assert_true(a == 13);
        ok(cd_membrane_set_effort(m, 3, 17));
        ok(cd_membrane_get_effort(m, &newton, &gradient));
        assert_true(newton == 3 && gradient == 17);
        ok(cd_membrane_set_air(m, 0.125, 1.5));
        ok(cd_membrane_get_air(m, &a, &b));
        assert_true(a == 0.125 && b == 1.5);
        ok(cd_membrane_set_wind(m, wind, 3));
        ok(cd_membrane_get_wind(m, shown, 3));
        assert_same_bits(shown, wind, 3);
        ok(cd_membrane_set_thickness(m, 0.0625));
        ok(cd_membrane_get_thickness(m, &a));
        assert_true(a == 0.0625);
        ok(cd_membrane_set_breaking_strain(m, 0.375));
        ok(cd_membrane_get_breaking_strain(m, &a));
        assert_true(a == 0.375);
        cd_membrane_destroy(m);
    }
}

static void has_effort(const cd_membrane* m, size_t newton, size_t gradient) {
    size_t out[2];
    ok(cd_membrane_get_effort(m, &out[0], &out[1]));
    assert_int_equal(out[0], newton);
    assert_int_equal(out[1], gradient);
}

static void an_effort_stays_until_lengths_go(void** state) {
    (void)state;
    cd_membrane* m = cloth(3, 4, 3, CD_FLOAT32);
    has_effort(m, 3, 0);
    ok(cd_membrane_set_rest_length(m, 1, 1));
    ok(cd_membrane_set_effort(m, 1, 2));
    ok(cd_membrane_set_rest_length(m, 2, 2));
    has_effort(m, 1, 2);
    ok(cd_membrane_set_effort(m, 1000, 10000));
    has_effort(m, 1000, 10000);
    ok(cd_membrane_set_effort(m, 2, 0));
    has_effort(m, 2, 0);
    ok(cd_membrane_set_rest_length(m, 0, 0));
    has_effort(m, 3, 0);
    ok(cd_membrane_set_rest_length(m, 1, 1));
    has_effort(m, 3, 0);
    cd_membrane_destroy(m);
}

static void lengths_are_dealt_out_to_the_springs(void** state) {
    (void)state;
    cd_membrane* m = plain(CD_FLOAT32);
    double x[2][ALL], lengths[NODES], a, b;
    cloth_read(m, CD_POSITION, x[0]);
    ok(cd_membrane_set_rest_length(m, 3, 2));
    for (cd_field field = CD_REST_LENGTH_U; field <= CD_REST_LENGTH_V; ++field) {
        ok(cd_membrane_enable_field(m, field));
        cloth_read(m, field, lengths);
        for (size_t i = 0; i < cloth_extent(m, field).count; ++i) assert_true(lengths[i] == 0.5);
        sheet_set(m, field, 3, 2, 0.75);
        ok(cd_membrane_enable_field(m, field)); /* on already: nothing happens */
        assert_true(sheet_get(m, field, 3, 2) == 0.75);
    }
    ok(cd_membrane_get_rest_length(m, &a, &b)); /* the totals last set */
    assert_true(a == 3 && b == 2);
    ok(cd_membrane_set_mass(m, 5)); /* is no matter of lengths */
    ok(cd_membrane_set_mass_rule(m, CD_MASS_HALF_ENDS));
    assert_true(sheet_get(m, CD_REST_LENGTH_U, 3, 2) == 0.75);
    ok(cd_membrane_set_rest_length(m, 6, 8)); /* writes both fields anew */
    cloth_read(m, CD_REST_LENGTH_U, lengths);
    for (size_t i = 0; i < NU * ROWS; ++i) assert_true(lengths[i] == 1);
    cloth_read(m, CD_REST_LENGTH_V, lengths);
    for (size_t i = 0; i < COLUMNS * NV; ++i) assert_true(lengths[i] == 2);
    cloth_read(m, CD_POSITION, x[1]); /* nodes stay where they are */
    assert_same_bits(x[0], x[1], ALL);
    ok(cd_membrane_disable_field(m, CD_REST_LENGTH_U));
    refuses(m, cd_membrane_read_f64(m, CD_REST_LENGTH_U, 0, 0, 1, 1, out.number, 1), CD_ERROR_DISABLED, "field|27");
    ok(cd_membrane_set_rest_length(m, 0, 0));
    refuses(m, cd_membrane_read_f64(m, CD_REST_LENGTH_V, 0, 0, 1, 1, out.number, 1), CD_ERROR_UNSUPPORTED, "field|28");
    ok(cd_membrane_set_rest_length(m, 1, 1));
    refuses(m, cd_membrane_read_f64(m, CD_REST_LENGTH_V, 0, 0, 1, 1, out.number, 1), CD_ERROR_DISABLED, "field|28");
    cd_membrane_destroy(m);
}

static void lengths_in_a_ring_are_dealt_out_to_one_spring_more(void** state) {
    (void)state;
    cd_membrane* m = flat(CD_FLOAT64);
    for (cd_field field = CD_REST_LENGTH_U; field <= CD_REST_LENGTH_V; ++field) ok(cd_membrane_enable_field(m, field));
    for (cd_field field = CD_BREAKING_STRAIN_U; field <= CD_BREAKING_STRAIN_V; ++field)
        ok(cd_membrane_enable_field(m, field));
    ok(cd_membrane_set_breaking_strain(m, 8));
    sheet_set(m, CD_BREAKING_STRAIN_U, 0, 0, 5);
    ok(cd_membrane_set_rest_length(m, 21, 10));
    ok(cd_membrane_set_ring(m, 1, 1));
    for (size_t v = 0; v < ROWS; ++v)
        for (size_t u = 0; u < COLUMNS; ++u) {
            assert_true(sheet_get(m, CD_REST_LENGTH_U, u, v) == 3 && sheet_get(m, CD_REST_LENGTH_V, u, v) == 2);
            assert_true(sheet_get(m, CD_BREAKING_STRAIN_U, u, v) == 8 && sheet_get(m, CD_BREAKING_STRAIN_V, u, v) == 8);
        }
    assert_int_equal(cloth_extent(m, CD_STRAIN_U).columns, COLUMNS);
    double strain[NODES];
    cloth_read(m, CD_STRAIN_U, strain);
    cloth_read(m, CD_STRAIN_V, strain);
    sheet_set(m, CD_REST_LENGTH_U, NU, 2, 7);
    sheet_set(m, CD_BREAKING_STRAIN_U, NU, 2, 7);
    const uint64_t closed = hash_of(m);
    ok(cd_membrane_set_ring(m, 0, 1));
    for (size_t u = 0; u < NU; ++u) assert_true(sheet_get(m, CD_REST_LENGTH_U, u, 2) == 3.5);
    assert_true(sheet_get(m, CD_REST_LENGTH_V, 3, NV) == 2);
    assert_int_not_equal(hash_of(m), closed);
    cd_membrane* never = flat(CD_FLOAT64); /* what the closing spring was given is forgotten */
    for (cd_field field = CD_REST_LENGTH_U; field <= CD_REST_LENGTH_V; ++field)
        ok(cd_membrane_enable_field(never, field));
    for (cd_field field = CD_BREAKING_STRAIN_U; field <= CD_BREAKING_STRAIN_V; ++field)
        ok(cd_membrane_enable_field(never, field));
    ok(cd_membrane_set_breaking_strain(never, 8));
    ok(cd_membrane_set_rest_length(never, 21, 10));
    ok(cd_membrane_set_ring(never, 0, 1));
    assert_int_equal(hash_of(m), hash_of(never));
    cd_membrane_destroy(m);
    cd_membrane_destroy(never);
}

static void making_cloth_sets_lambda_and_no_other_length_does(void** state) {
    (void)state;
    cd_membrane* m = plain(CD_FLOAT64);
    assert_true(lambda_of(m) == 0.5);
    ok(cd_membrane_set_rest_length(m, 0, 0)); /* was none */
    assert_true(lambda_of(m) == 0.5);
    ok(cd_membrane_set_rest_length(m, 1, 1));
    assert_true(lambda_of(m) == 1);
    ok(cd_membrane_set_lambda(m, 0.75));
    ok(cd_membrane_set_rest_length(m, 2, 1));
    assert_true(lambda_of(m) == 0.75);
    ok(cd_membrane_set_rest_length(m, 0, 0));
    assert_true(lambda_of(m) == 0.75);
    cd_membrane_destroy(m);
}

static void only_sheets_of_three_components_with_springs_both_ways_are_cloth(void** state) {
    (void)state;
    static const struct {
        size_t nu, nv, components;
        const char* text;
    } none[] = {{3, 3, 1, "along_u|0.5|1 components|needs|3 components"},
                {3, 3, 2, "along_u|0.5|2 components"},
                {3, 3, 4, "along_u|0.5|4 components"},
                {0, 3, 3, "along_u|0.5|0 and 3 springs|needs springs both ways"},
                {3, 0, 3, "along_u|0.5|3 and 0 springs"}};
    for (size_t i = 0; i < COUNT(none); ++i) {
        cd_membrane* m = cloth(none[i].nu, none[i].nv, none[i].components, CD_FLOAT32);
        refuses(m, cd_membrane_set_rest_length(m, 0.5, 2), CD_ERROR_UNSUPPORTED, none[i].text);
        ok(cd_membrane_set_rest_length(m, 0, 0));
        refuses(m, cd_membrane_set_shear(m, 1), CD_ERROR_UNSUPPORTED, "~|shear|rest length");
        cloth_assert_defaults(m);
        ok(cd_membrane_step(m, 0.01, 1));
        cd_membrane_destroy(m);
    }
    cd_membrane* least = cloth(1, 1, 3, CD_FLOAT32);
    ok(cd_membrane_set_rest_length(least, 1, 1));
    cd_membrane_destroy(least);
}

/* Length 0 leaves nothing of cloth behind, and lengths that come again begin with the defaults. */
static void without_lengths_all_of_cloth_is_as_in_a_new_membrane(void** state) {
    (void)state;
    for (cd_precision precision = CD_FLOAT32; precision <= CD_FLOAT64; ++precision) {
        cd_membrane *m = plain(precision), *never = plain(precision);
        size_t bytes[2];
        for (int round = 0; round < 2; ++round) {
            ok(cd_membrane_set_rest_length(m, 1, 1));
            ok(cd_membrane_set_shear(m, 2));
            ok(cd_membrane_set_compression(m, 3));
            ok(cd_membrane_set_effort(m, 4, 5));
            ok(cd_membrane_set_air(m, 6, 7));
            cloth_meet(m);
            ok(cd_membrane_enable_field(m, CD_WIND));
            ok(cd_membrane_enable_field(m, CD_REST_LENGTH_U));
            ok(cd_membrane_enable_field(m, CD_REST_LENGTH_V));
            ok(cd_membrane_set_breaking_strain(m, 1e-3));
            ok(cd_membrane_enable_field(m, CD_BREAKING_STRAIN_U));
            ok(cd_membrane_enable_field(m, CD_BREAKING_STRAIN_V));
            ok(cd_membrane_set_rest_length(m, 0, -0.0));
            cloth_assert_defaults(m);
            ok(cd_membrane_disable_field(m, CD_STIFFNESS_U));
            ok(cd_membrane_disable_field(m, CD_STIFFNESS_V));
            ok(cd_membrane_set_lambda(m, 0.5));
            assert_int_equal(hash_of(m), hash_of(never));
            ok(cd_membrane_get_memory(m, &bytes[0]));
            ok(cd_membrane_get_memory(never, &bytes[1]));
            assert_int_equal(bytes[0], bytes[1]);
        }
        ok(cd_membrane_step(m, 0.01, 3));
        ok(cd_membrane_step(never, 0.01, 3));
        assert_int_equal(hash_of(m), hash_of(never));
        cd_membrane_destroy(m);
        cd_membrane_destroy(never);
    }
}

static void forward(cd_membrane* m) { ok(cd_membrane_set_method(m, CD_METHOD_FORWARD_EULER)); }
static void symplectic(cd_membrane* m) { ok(cd_membrane_set_method(m, CD_METHOD_SYMPLECTIC_EULER)); }
static void stiff_second(cd_membrane* m) { ok(cd_membrane_set_method(m, CD_METHOD_STIFF_SECOND)); }
static void implicit(cd_membrane* m) { ok(cd_membrane_set_method(m, CD_METHOD_IMPLICIT)); }
static void explicit_lambda(cd_membrane* m) { ok(cd_membrane_set_lambda(m, 0)); }
static void low_lambda(cd_membrane* m) { ok(cd_membrane_set_lambda(m, nextafter(0.5, 0))); }
static void half(cd_membrane* m) { ok(cd_membrane_set_lambda(m, 0.5)); }
static void damping(cd_membrane* m) { ok(cd_membrane_set_stiffness_damping(m, 1e-3)); }
static void no_damping(cd_membrane* m) { ok(cd_membrane_set_stiffness_damping(m, 0)); }
static void u_matched(cd_membrane* m) { ok(cd_membrane_set_edge(m, CD_EDGE_U_FIRST, CD_NODE_MATCHED)); }
static void u_free(cd_membrane* m) { ok(cd_membrane_set_edge(m, CD_EDGE_U_FIRST, CD_NODE_FREE)); }
static void v_matched(cd_membrane* m) { ok(cd_membrane_set_edge(m, CD_EDGE_V_LAST, CD_NODE_MATCHED)); }
static void v_free(cd_membrane* m) { ok(cd_membrane_set_edge(m, CD_EDGE_V_LAST, CD_NODE_FREE)); }

static const struct lack {
    void (*make)(cd_membrane*);
    void (*undo)(cd_membrane*);
    const char* text;
} lacks[] = {
    {forward, implicit, "~|length|CD_METHOD_IMPLICIT: see cd_membrane_set_method"},
    {symplectic, implicit, "~|length|CD_METHOD_IMPLICIT: see cd_membrane_set_method"},
    {stiff_second, implicit, "~|length|CD_METHOD_IMPLICIT: see cd_membrane_set_method"},
    {explicit_lambda, half, "~|length|lambda below 1/2: see cd_membrane_set_lambda"},
    {low_lambda, half, "~|length|lambda below 1/2: see cd_membrane_set_lambda"},
    {damping, no_damping, "~|length|stiffness damping: see cd_membrane_set_stiffness_damping"},
    {u_matched, u_free, "~|length|matched edge: see cd_membrane_set_edge"},
    {v_matched, v_free, "~|length|matched edge: see cd_membrane_set_edge"},
};

/* It is the step that says so, unless it makes no steps. */
static void what_cloth_cannot_have_is_told_by_the_step(void** state) {
    (void)state;
    for (size_t i = 0; i < COUNT(lacks); ++i) {
        cd_membrane* m = flat(CD_FLOAT64);
        lacks[i].make(m);
        refuses(m, cd_membrane_step(m, 1e-3, 1), CD_ERROR_UNSUPPORTED, lacks[i].text);
        refuses(m, cd_membrane_step(m, 1e-3, 1000), CD_ERROR_UNSUPPORTED, lacks[i].text);
        ok(cd_membrane_step(m, 1e-3, 0));
        refuses(m, cd_membrane_step(m, NAN, 1), CD_ERROR_VALUE, "dt|nan");
        lacks[i].undo(m);
        ok(cd_membrane_step(m, 1e-3, 1));
        lacks[i].make(m);
        ok(cd_membrane_set_rest_length(m, 0, 0));
        ok(cd_membrane_step(m, 1e-4, 1));
        cd_membrane_destroy(m);
    }
}

static void cloth_has_no_longest_step_and_no_factorization(void** state) {
    (void)state;
    cd_membrane* m = flat(CD_FLOAT64);
    double dt = 0;
    uint64_t made = 9;
    refuses(m, cd_membrane_stable_dt(m, &out.number[0]), CD_ERROR_UNSUPPORTED, "~|length");
    ok(cd_membrane_step(m, 0.01, 2));
    ok(cd_membrane_get_factorizations(m, &made));
    assert_int_equal(made, 0);
    ok(cd_membrane_set_rest_length(m, 0, 0));
    ok(cd_membrane_stable_dt(m, &dt));
    assert_true(dt > 0);
    ok(cd_membrane_step(m, 0.01, 2));
    ok(cd_membrane_get_factorizations(m, &made));
    assert_int_equal(made, 1);
    cd_membrane_destroy(m);
}

static void is_told(const cd_membrane* m, size_t index, cd_shape shape, const double* first, const double* second,
                    const double* velocity, double radius, double friction) {
    cd_shape told_shape = -1;
    double told[3][3], told_radius = -1, told_friction = -1;
    ok(cd_membrane_get_collider(m, index, &told_shape, told[0], told[1], told[2], 3, &told_radius, &told_friction));
    assert_int_equal(told_shape, shape);
    assert_true(told_radius == radius && told_friction == friction);
    for (int k = 0; k < 3; ++k) {
        assert_near(told[0][k], first[k], 1e-15, 1);
        assert_near(told[1][k], second[k], 1e-15, 1);
        assert_true(told[2][k] == velocity[k]);
    }
}

static void colliders_are_told_where_they_are(void** state) {
    (void)state;
    static const double zero[3] = {0, 0, 0}, point[3] = {1, 2, 3}, long_normal[3] = {0, 3e59, 4e59};
    static const double normal[3] = {0, 0.6, 0.8}, last[3] = {2, 2, 5}, slow[3] = {0.5, 0, -0.25};
    cd_membrane* m = flat(CD_FLOAT32);
    size_t count = 9;
    ok(cd_membrane_get_colliders(m, &count));
    assert_int_equal(count, 0);
    ok(cd_membrane_set_colliders(m, 3));
    ok(cd_membrane_get_colliders(m, &count));
    assert_int_equal(count, 3);
    for (size_t i = 0; i < 3; ++i) is_told(m, i, CD_SHAPE_NONE, zero, zero, zero, 0, 0);
    ok(cd_membrane_set_plane(m, 0, point, long_normal, 3, 0.5));
    ok(cd_membrane_set_capsule(m, 1, point, last, 3, 0.25, 0.125));
    is_told(m, 0, CD_SHAPE_PLANE, point, normal, zero, 0, 0.5);
    is_told(m, 1, CD_SHAPE_CAPSULE, point, last, zero, 0.25, 0.125);
    ok(cd_membrane_set_collider_velocity(m, 1, slow, 3));
    is_told(m, 1, CD_SHAPE_CAPSULE, point, last, slow, 0.25, 0.125);
    ok(cd_membrane_step(m, 0.5, 4)); /* moves it by 2 s of its velocity */
    static const double first_now[3] = {2, 2, 2.5}, last_now[3] = {3, 2, 4.5};
    is_told(m, 0, CD_SHAPE_PLANE, point, normal, zero, 0, 0.5);
    is_told(m, 1, CD_SHAPE_CAPSULE, first_now, last_now, slow, 0.25, 0.125);
    ok(cd_membrane_reset(m)); /* there it stays when time begins anew */
    is_told(m, 1, CD_SHAPE_CAPSULE, first_now, last_now, slow, 0.25, 0.125);
    const double offset[3] = {7, 7, 7};
    ok(cd_membrane_teleport(m, NULL, offset, 3)); /* moves the sheet only */
    is_told(m, 1, CD_SHAPE_CAPSULE, first_now, last_now, slow, 0.25, 0.125);
    ok(cd_membrane_set_colliders(m, 5)); /* those that stay keep what they are */
    is_told(m, 0, CD_SHAPE_PLANE, point, normal, zero, 0, 0.5);
    is_told(m, 1, CD_SHAPE_CAPSULE, first_now, last_now, slow, 0.25, 0.125);
    is_told(m, 4, CD_SHAPE_NONE, zero, zero, zero, 0, 0);
    ok(cd_membrane_set_plane(m, 1, point, long_normal, 3, 0)); /* goes on as fast as it went */
    is_told(m, 1, CD_SHAPE_PLANE, point, normal, slow, 0, 0);
    ok(cd_membrane_remove_collider(m, 1));
    is_told(m, 1, CD_SHAPE_NONE, zero, zero, zero, 0, 0);
    ok(cd_membrane_set_colliders(m, 1));
    is_told(m, 0, CD_SHAPE_PLANE, point, normal, zero, 0, 0.5);
    ok(cd_membrane_get_collider(m, 0, NULL, NULL, NULL, NULL, 3, NULL, NULL));
    cd_membrane_destroy(m);
}

/* What does not change the springs' numbers makes no coefficients anew, and what does acts in the very next step: a
 * membrane that is set in several ways steps as one that is so from the start. */
static void what_is_set_acts_in_the_next_step(void** state) {
    (void)state;
    cd_membrane *m = cloth(NU, NV, 3, CD_FLOAT64), *fresh = cloth(NU, NV, 3, CD_FLOAT64);
    const double gust[3] = {0, 3, -1};
    cloth_lengths(m);
    for (int change = 0; change < 12; ++change) {
        ok(cd_membrane_step(m, 0.01, 1));
        if (change == 0) ok(cd_membrane_set_shear(m, 40));
        if (change == 1) ok(cd_membrane_set_compression(m, 50));
        if (change == 2) ok(cd_membrane_set_effort(m, 1, 3));
        if (change == 3) ok(cd_membrane_set_air(m, 0, 0));
        if (change == 4) ok(cd_membrane_set_air(m, 0.5, 2));
        if (change == 5) ok(cd_membrane_set_wind(m, gust, 3));
        if (change == 6) ok(cd_membrane_set_colliders(m, 2));
        if (change == 7) sheet_set(m, CD_REST_LENGTH_V, 2, 2, 0.0625);
        if (change == 8) ok(cd_membrane_set_rest_length(m, 0.5, 0.375));
        if (change == 9) sheet_set(m, CD_BREAKING_STRAIN_V, 4, 1, 1e-3);
        if (change == 10) ok(cd_membrane_set_breaking_strain(m, 1e-3));
        if (change == 11) ok(cd_membrane_set_stiffness(m, 300, 200)); /* mends them */
        ok(cd_membrane_copy_state(fresh, m));
        ok(cd_membrane_step(m, 0.01, 1));
        ok(cd_membrane_step(fresh, 0.01, 1));
        if (hash_of(m) != hash_of(fresh)) fail_msg("change %d: another step than a fresh copy's", change);
    }
    cd_membrane_destroy(m);
    cd_membrane_destroy(fresh);
}

/* Velocities whose squares are beyond all numbers leave a finite state, and a residual that is none. */
static void a_residual_that_is_no_number_is_told_as_infinite(void** state) {
    (void)state;
    cd_membrane* m = flat(CD_FLOAT64);
    double v[ALL], residual = 0;
    for (int i = 0; i < ALL; ++i) v[i] = 1e160 * (i % 7 - 3);
    ok(cd_membrane_write_f64(m, CD_VELOCITY, 0, 0, COLUMNS, ROWS, v, ALL));
    ok(cd_membrane_step(m, 1e-3, 1));
    ok(cd_membrane_get_convergence(m, NULL, &residual));
    assert_true(isinf(residual));
    cd_membrane_destroy(m);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(getters_tell_what_was_set),
        cmocka_unit_test(an_effort_stays_until_lengths_go),
        cmocka_unit_test(lengths_are_dealt_out_to_the_springs),
        cmocka_unit_test(lengths_in_a_ring_are_dealt_out_to_one_spring_more),
        cmocka_unit_test(making_cloth_sets_lambda_and_no_other_length_does),
        cmocka_unit_test(only_sheets_of_three_components_with_springs_both_ways_are_cloth),
        cmocka_unit_test(without_lengths_all_of_cloth_is_as_in_a_new_membrane),
        cmocka_unit_test(what_cloth_cannot_have_is_told_by_the_step),
        cmocka_unit_test(cloth_has_no_longest_step_and_no_factorization),
        cmocka_unit_test(colliders_are_told_where_they_are),
        cmocka_unit_test(what_is_set_acts_in_the_next_step),
        cmocka_unit_test(a_residual_that_is_no_number_is_told_as_infinite),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
