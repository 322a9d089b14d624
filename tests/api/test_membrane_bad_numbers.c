/* Numbers of membrane.h that are out of range together with others, or in a state of the membrane. What each may be by
 * itself is tried by tests/bindings/check_ranges.py; for the fields see test_membrane_bad_fields.c. */
#include <math.h>

#include "check.h"
#include "cloth.h"
#include "heap.h"
#include "refusals.h"
#include "sheet.h"

enum { NU = 7, NV = 5, COMPONENTS = 3 };

static cd_membrane* m;

static int set_up(void** state) {
    (void)state;
    m = cloth(NU, NV, COMPONENTS, CD_FLOAT32);
    cloth_everything(m);
    ok(cd_membrane_step(m, 0.001, 2));
    return 0;
}

static int tear_down(void** state) {
    (void)state;
    cd_membrane_destroy(m);
    return 0;
}

static cd_membrane* new_body(void) { return cloth(3, 2, 3, CD_FLOAT64); }
static void set_lengths(cd_membrane* c, double length) { ok(cd_membrane_set_rest_length(c, length, length)); }
static cd_status read_winds(const cd_membrane* c, double* winds) {
    return cd_membrane_read_f64(c, CD_WIND, 0, 0, 4, 3, winds, 36);
}
#define BODY membrane
#include "bad_surroundings.h"

static void only_cloth_tears_where_it_has_stiffnesses(void** state) {
    (void)state;
    double strain = 0;
    cd_membrane* c = new_body();
    refuses(c, cd_membrane_set_breaking_strain(c, 1), CD_ERROR_UNSUPPORTED, "tears|rest length");
    refuses(c, cd_membrane_set_breaking_strain(c, INFINITY), CD_ERROR_UNSUPPORTED, "tears|rest length");
    set_lengths(c, 1);
    refuses(c, cd_membrane_set_breaking_strain(c, -1), CD_ERROR_VALUE, "strain is -1|in [1e-60, 1e+60] or INFINITY");
    ok(cd_membrane_set_breaking_strain(c, INFINITY)); /* holds, and switches nothing on */
    refuses(c, cd_membrane_read_f64(c, CD_STIFFNESS_U, 0, 0, 1, 1, out.number, 1), CD_ERROR_DISABLED, "field|8");
    ok(cd_membrane_enable_field(c, CD_BREAKING_STRAIN_V)); /* of one direction only */
    assert_true(sheet_get(c, CD_STIFFNESS_V, 3, 1) > 0 && isinf(sheet_get(c, CD_BREAKING_STRAIN_V, 3, 1)));
    refuses(c, cd_membrane_read_f64(c, CD_STIFFNESS_U, 0, 0, 1, 1, out.number, 1), CD_ERROR_DISABLED, "field|8");
    refuses(c, cd_membrane_disable_field(c, CD_STIFFNESS_V), CD_ERROR_UNSUPPORTED, "CD_STIFFNESS_V|tear");
    ok(cd_membrane_disable_field(c, CD_STIFFNESS_U));
    ok(cd_membrane_set_breaking_strain(c, 1e60));
    ok(cd_membrane_set_breaking_strain(c, 1e-60));
    ok(cd_membrane_enable_field(c, CD_BREAKING_STRAIN_U));
    assert_true(sheet_get(c, CD_BREAKING_STRAIN_U, 2, 2) == 1e-60 && sheet_get(c, CD_BREAKING_STRAIN_V, 3, 1) == 1e-60);
    sheet_set(c, CD_BREAKING_STRAIN_U, 2, 2, INFINITY);
    ok(cd_membrane_set_breaking_strain(c, 5)); /* writes both fields anew */
    assert_true(sheet_get(c, CD_BREAKING_STRAIN_U, 2, 2) == 5);
    ok(cd_membrane_disable_field(c, CD_BREAKING_STRAIN_U));
    ok(cd_membrane_disable_field(c, CD_BREAKING_STRAIN_V));
    refuses(c, cd_membrane_disable_field(c, CD_STIFFNESS_U), CD_ERROR_UNSUPPORTED, "CD_STIFFNESS_U|tear");
    set_lengths(c, 0); /* switches all of it off */
    ok(cd_membrane_disable_field(c, CD_STIFFNESS_U));
    ok(cd_membrane_disable_field(c, CD_STIFFNESS_V));
    set_lengths(c, 1);
    ok(cd_membrane_get_breaking_strain(c, &strain));
    assert_true(isinf(strain));
    cd_membrane_destroy(c);
}

/* Whether it is cloth or not: what is out of range is so whoever asks. */
static void no_cloth_takes_numbers_outside_their_range(void** state) {
    (void)state;
    static const struct bad_number none[] = {{0, "0"}, {-0.0, "0"}};
    cd_membrane* c = new_body();
    for (int is_cloth = 0; is_cloth <= 1; ++is_cloth) {
        refuses_each(c, cd_membrane_set_rest_length(c, bad, 1), "along_u", none); /* both or none */
        refuses_each(c, cd_membrane_set_rest_length(c, 1, bad), "along_v", none);
        refuses_each(c, cd_membrane_set_rest_length(c, bad, 0), "along_u", not_finite);
        refuses(c, cd_membrane_set_rest_length(c, 1, 0), CD_ERROR_VALUE, "along_v is 0|in [1e-60, 1e+60] or both 0");
        refuses_each(c, cd_membrane_set_shear(c, bad), "stiffness", negative);
        refuses_each(c, cd_membrane_set_compression(c, bad), "rate", negative);
        refuses(c, cd_membrane_set_effort(c, 0, 1), CD_ERROR_VALUE, "newton|0|1000");
        refuses(c, cd_membrane_set_effort(c, 1, 10001), CD_ERROR_VALUE, "gradient|10001|0 to 10000");
        if (is_cloth) continue;
        refuses(c, cd_membrane_set_shear(c, 1), CD_ERROR_UNSUPPORTED, "shear|rest length");
        refuses(c, cd_membrane_set_compression(c, 1), CD_ERROR_UNSUPPORTED, "crumples|rest length");
        refuses(c, cd_membrane_set_effort(c, 1, 1), CD_ERROR_UNSUPPORTED, "effort|rest length");
        ok(cd_membrane_set_rest_length(c, 1e60, 1e-60));
        ok(cd_membrane_set_rest_length(c, 1e-60, 1e60));
    }
    cd_membrane_destroy(c);
}

static void an_impulse_too_strong_for_the_precision_changes_nothing(void** state) {
    (void)state;
    cd_membrane* one = cloth(3, 3, 1, CD_FLOAT32);
    const double huge = 1e40;
    refuses(one, cd_membrane_impulse(one, 1, 1, 2, &huge, 1), CD_ERROR_VALUE, "impulse|1e+40");
    refuses(one, cd_membrane_impulse(one, 1, 1, 0, &huge, 1), CD_ERROR_VALUE, "impulse|1e+40");
    ok(cd_membrane_set_edge(one, CD_EDGE_U_FIRST, CD_NODE_PINNED));
    ok(cd_membrane_impulse(one, 0, 1, 0, &huge, 1)); /* lost in the pin */
    cd_membrane_destroy(one);
}

static void no_time_is_too_short_for_no_steps(void** state) {
    (void)state;
    refuses_each(m, cd_membrane_step(m, bad, 0), "dt", not_finite);
    refuses(m, cd_membrane_step(m, -1, 1), CD_ERROR_VALUE, "dt is -1|0 or in [1e-30, 1e+30]");
}

static void no_more_places_are_sampled_than_fit_in_memory(void** state) {
    (void)state;
    static const size_t most[] = {SIZE_MAX, SIZE_MAX / 2 + 3, SIZE_MAX / 4 + 1};
    const double places[4] = {0.5, 0.5, 0.5, 0.5};
    for (size_t i = 0; i < COUNT(most); ++i)
        refuses(m, cd_membrane_sample(m, places, most[i], CD_OUTSIDE_REFUSED, out.number, 6), CD_ERROR_RANGE,
                name_and_size("n", most[i]));
}

static void no_shape_is_made_that_cannot_be(void** state) {
    (void)state;
    struct heap heap = {0}; /* refuses what is too large without trying the machine's memory */
    const cd_allocator allocator = heap_allocator(&heap);
    static const size_t big = (size_t)1 << (sizeof(size_t) == 8 ? 40 : 24), most = SIZE_MAX;
    static const struct {
        size_t nu, nv, components;
        cd_status status;
        const char* argument;
        size_t shown;
    } bad[] = {
        {1, 1, 0, CD_ERROR_VALUE, "components", 0},
        {1, 1, 5, CD_ERROR_VALUE, "components", 5},
        {1, 1, SIZE_MAX, CD_ERROR_VALUE, "components", SIZE_MAX},
        {SIZE_MAX, 1, 1, CD_ERROR_SIZE, "nu", SIZE_MAX},
        {SIZE_MAX - 1, 1, 1, CD_ERROR_SIZE, "nu", SIZE_MAX - 1},
        {1, SIZE_MAX, 1, CD_ERROR_SIZE, "nv", SIZE_MAX},
        {0, SIZE_MAX - 1, 1, CD_ERROR_SIZE, "nv", SIZE_MAX - 1},
        {SIZE_MAX / 2 - 20, 0, 1, CD_ERROR_SIZE, "nu", SIZE_MAX / 2 - 20},
        {SIZE_MAX, SIZE_MAX, 4, CD_ERROR_SIZE, "nu", SIZE_MAX},
        {0, SIZE_MAX / 64, 1, CD_ERROR_SIZE, "nv", SIZE_MAX / 64},
        {SIZE_MAX / 64, 0, 1, CD_ERROR_SIZE, "nu", SIZE_MAX / 64},
    };
    for (size_t i = 0; i < COUNT(bad); ++i)
        for (cd_precision precision = CD_FLOAT32; precision <= CD_FLOAT64; ++precision)
            refuses(m,
                    cd_membrane_create(bad[i].nu, bad[i].nv, bad[i].components, precision, &allocator, &out.membrane),
                    bad[i].status, name_and_size(bad[i].argument, bad[i].shown));
    refuses(m, cd_membrane_create(big, big, 4, CD_FLOAT64, &allocator, &out.membrane), CD_ERROR_SIZE,
            name_and_size("nu", big));
    refuses(m, cd_membrane_create(big, 0, 1, CD_FLOAT64, &allocator, &out.membrane), CD_ERROR_MEMORY, "");
    refuses(m, cd_membrane_create(0, big, 1, CD_FLOAT32, &allocator, &out.membrane), CD_ERROR_MEMORY, "");
    assert_true(most > big);
    heap_free(&heap);
}

static void forces_are_of_nodes_and_of_all_components(void** state) {
    (void)state;
    cd_membrane* m = cloth(1, 7, 2, CD_FLOAT64);
    refuses(m, cd_membrane_get_reaction(m, 2, 0, out.number, 2), CD_ERROR_RANGE, "u is 2");
    refuses(m, cd_membrane_get_reaction(m, 0, 8, out.number, 2), CD_ERROR_RANGE, "v is 8");
    refuses(m, cd_membrane_get_reaction(m, 0, 0, out.number, 3), CD_ERROR_RANGE, "count|3|2");
    ok(cd_membrane_get_reaction(m, 1, 7, out.number, 2));
    cd_membrane_destroy(m);
}

static void what_the_membrane_cannot_do_is_said_to_be_unsupported(void** state) {
    (void)state;
    cd_membrane* small = cloth(1, 7, 2, CD_FLOAT64);
    refuses(small, cd_membrane_set_ring(small, 1, 0), CD_ERROR_UNSUPPORTED, "along_u|2");
    refuses(small, cd_membrane_set_ring(small, 1, 1), CD_ERROR_UNSUPPORTED, "along_u|2");
    refuses(small, cd_membrane_set_pressure(small, 1), CD_ERROR_UNSUPPORTED, "pressure|1|2");
    refuses(small, cd_membrane_get_volume(small, out.number), CD_ERROR_UNSUPPORTED, "2");
    ok(cd_membrane_set_pressure(small, 0));
    for (cd_edge edge = CD_EDGE_V_FIRST; edge <= CD_EDGE_V_LAST; ++edge) {
        ok(cd_membrane_set_edge(small, edge, CD_NODE_MATCHED));
        refuses(small, cd_membrane_set_ring(small, 0, 1), CD_ERROR_UNSUPPORTED, text_of("along_v|%d", edge));
        ok(cd_membrane_set_edge(small, edge, CD_NODE_FREE));
    }
    ok(cd_membrane_set_edge(small, CD_EDGE_U_LAST, CD_NODE_MATCHED)); /* across the ring: no hindrance */
    ok(cd_membrane_set_ring(small, 0, 1));
    for (cd_edge edge = CD_EDGE_V_FIRST; edge <= CD_EDGE_V_LAST; ++edge)
        refuses(small, cd_membrane_set_edge(small, edge, CD_NODE_MATCHED), CD_ERROR_UNSUPPORTED, "kind");
    cd_membrane_destroy(small);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        SURROUNDINGS_TESTS,
        cmocka_unit_test(no_cloth_takes_numbers_outside_their_range),
        cmocka_unit_test(only_what_sleeps_needs_seconds),
        cmocka_unit_test(only_cloth_tears_where_it_has_stiffnesses),
        cmocka_unit_test(an_impulse_too_strong_for_the_precision_changes_nothing),
        cmocka_unit_test(no_time_is_too_short_for_no_steps),
        cmocka_unit_test(no_more_places_are_sampled_than_fit_in_memory),
        cmocka_unit_test(no_shape_is_made_that_cannot_be),
        cmocka_unit_test(forces_are_of_nodes_and_of_all_components),
        cmocka_unit_test(what_the_membrane_cannot_do_is_said_to_be_unsupported),
    };
    return cmocka_run_group_tests(tests, set_up, tear_down);
}
