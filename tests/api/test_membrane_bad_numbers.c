/* Numbers that are no numbers, out of range, or none of an enumeration's: every argument of membrane.h that is passed
 * by value or as an array of numbers, but for the fields (test_membrane_bad_fields.c). */
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

/* A number that must be at least 0, at most 1e60. */
#define refuses_parameters_of(m, call, argument)    \
    do {                                            \
        refuses_each(m, call, argument, not_finite) \
        refuses_each(m, call, argument, negative)   \
        refuses_each(m, call, argument, too_large)  \
    } while (0)
#define refuses_parameters(call, argument) refuses_parameters_of(m, call, argument)

static void no_parameter_takes_a_number_outside_its_range(void** state) {
    (void)state;
    refuses_each(m, cd_membrane_set_lambda(m, bad), "lambda", not_finite);
    refuses_each(m, cd_membrane_set_lambda(m, bad), "lambda", not_a_share);
    refuses_each(m, cd_membrane_set_mass(m, bad), "mass", not_finite);
    refuses_each(m, cd_membrane_set_mass(m, bad), "mass", not_positive);
    refuses_each(m, cd_membrane_set_mass(m, bad), "mass", too_large);
    refuses_each(m, cd_membrane_set_mass(m, bad), "mass", too_small);
    refuses_parameters(cd_membrane_set_stiffness(m, bad, 1), "along_u");
    refuses_parameters(cd_membrane_set_stiffness(m, 1, bad), "along_v");
    refuses_parameters(cd_membrane_set_bend(m, bad), "bend");
    refuses_parameters(cd_membrane_set_drag(m, bad), "drag");
    refuses_parameters(cd_membrane_set_stiffness_damping(m, bad), "seconds");
    refuses_parameters(cd_membrane_attach(m, 2, 3, bad, 1, NULL, COMPONENTS), "stiffness");
    refuses_parameters(cd_membrane_attach(m, 2, 3, 1, bad, NULL, COMPONENTS), "damping");
    refuses_each(m, cd_membrane_set_pressure(m, bad), "pressure", not_finite);
    refuses_each(m, cd_membrane_set_pressure(m, bad), "pressure", too_large);
    refuses_each(m, cd_membrane_set_pressure(m, -bad), "pressure", too_large);
    refuses_each(m, cd_membrane_step(m, bad, 1), "dt", not_finite);
    refuses_each(m, cd_membrane_step(m, bad, 1), "dt", not_positive);
    refuses_each(m, cd_membrane_step(m, bad, 1), "dt", not_a_step);
    refuses_each(m, cd_membrane_step(m, bad, 0), "dt", not_finite);
    static const struct bad_number no_tolerance[] = {{0.9e-14, "9e-15"}, {0.75, "0.75"}, {0, "0"}, {-1e-6, "-1e-06"}};
    refuses_each(m, cd_membrane_set_tolerance(m, bad, 10), "tolerance", not_finite);
    refuses_each(m, cd_membrane_set_tolerance(m, bad, 10), "tolerance", no_tolerance);
    refuses(m, cd_membrane_set_tolerance(m, 1e-6, 0), CD_ERROR_VALUE, "most_iterations|0");
}

static cd_membrane* new_body(void) { return cloth(3, 2, 3, CD_FLOAT64); }
static void set_lengths(cd_membrane* c, double length) { ok(cd_membrane_set_rest_length(c, length, length)); }
static cd_status read_winds(const cd_membrane* c, double* winds) {
    return cd_membrane_read_f64(c, CD_WIND, 0, 0, 4, 3, winds, 36);
}
#define BODY membrane
#define THICKNESS "distance"
#include "bad_surroundings.h"

static void only_cloth_tears_at_strains_in_the_range(void** state) {
    (void)state;
    static const struct bad_number no_number[] = {{NAN, "nan"}, {-INFINITY, "-inf"}, {0, "0"}, {9e-61, "9e-61"}};
    double strain = 0;
    cd_membrane* c = new_body();
    refuses(c, cd_membrane_set_breaking_strain(c, 1), CD_ERROR_UNSUPPORTED, "tears|rest length");
    refuses(c, cd_membrane_set_breaking_strain(c, INFINITY), CD_ERROR_UNSUPPORTED, "tears|rest length");
    set_lengths(c, 1);
    refuses_each(c, cd_membrane_set_breaking_strain(c, bad), "strain", no_number);
    refuses_each(c, cd_membrane_set_breaking_strain(c, bad), "strain", negative);
    refuses_each(c, cd_membrane_set_breaking_strain(c, bad), "strain", too_large);
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
        refuses_parameters_of(c, cd_membrane_set_rest_length(c, bad, 1), "along_u");
        refuses_parameters_of(c, cd_membrane_set_rest_length(c, 1, bad), "along_v");
        refuses_each(c, cd_membrane_set_rest_length(c, bad, 1), "along_u", too_small);
        refuses_each(c, cd_membrane_set_rest_length(c, 1, bad), "along_v", too_small);
        refuses_each(c, cd_membrane_set_rest_length(c, bad, 1), "along_u", none); /* both or none */
        refuses_each(c, cd_membrane_set_rest_length(c, 1, bad), "along_v", none);
        refuses_each(c, cd_membrane_set_rest_length(c, bad, 0), "along_u", not_finite);
        refuses_parameters_of(c, cd_membrane_set_shear(c, bad), "stiffness");
        refuses_parameters_of(c, cd_membrane_set_compression(c, bad), "rate");
        refuses(c, cd_membrane_set_effort(c, 0, 1), CD_ERROR_VALUE, "newton|0|1000");
        refuses(c, cd_membrane_set_effort(c, 1001, 1), CD_ERROR_VALUE, "newton|1001|1000");
        refuses(c, cd_membrane_set_effort(c, SIZE_MAX, 1), CD_ERROR_VALUE, name_and_size("newton", SIZE_MAX));
        refuses(c, cd_membrane_set_effort(c, 1, 0), CD_ERROR_VALUE, "gradient|0|10000");
        refuses(c, cd_membrane_set_effort(c, 1, 10001), CD_ERROR_VALUE, "gradient|10001|10000");
        refuses(c, cd_membrane_set_effort(c, 1, SIZE_MAX), CD_ERROR_VALUE, name_and_size("gradient", SIZE_MAX));
        if (is_cloth) continue;
        refuses(c, cd_membrane_set_shear(c, 1), CD_ERROR_UNSUPPORTED, "shear|rest length");
        refuses(c, cd_membrane_set_compression(c, 1), CD_ERROR_UNSUPPORTED, "crumples|rest length");
        refuses(c, cd_membrane_set_effort(c, 1, 1), CD_ERROR_UNSUPPORTED, "effort|rest length");
        ok(cd_membrane_set_rest_length(c, 1e60, 1e-60));
        ok(cd_membrane_set_rest_length(c, 1e-60, 1e60));
    }
    ok(cd_membrane_set_shear(c, 1e60));
    ok(cd_membrane_set_shear(c, 0));
    ok(cd_membrane_set_compression(c, 1e60));
    ok(cd_membrane_set_compression(c, 0));
    ok(cd_membrane_set_effort(c, 1000, 10000));
    ok(cd_membrane_set_effort(c, 1, 1));
    ok(cd_membrane_set_air(c, 1e60, 1e60));
    ok(cd_membrane_set_thickness(c, 1e60));
    ok(cd_membrane_set_colliders(c, 4096));
    cd_membrane_destroy(c);
}

static void no_impulse_is_given_beside_the_sheet(void** state) {
    (void)state;
    const double one[COMPONENTS] = {1, 1, 1};
    static const struct bad_number beside_u[] = {{-0.125, "-0.125"}, {NU + 0.125, "7.125"}, {1e300, "1e+300"}};
    static const struct bad_number beside_v[] = {{-0.125, "-0.125"}, {NV + 0.125, "5.125"}, {1e300, "1e+300"}};
    refuses_each(m, cd_membrane_impulse(m, bad, 1, 1, one, COMPONENTS), "u", beside_u);
    refuses_each(m, cd_membrane_impulse(m, bad, 1, 1, one, COMPONENTS), "u", not_finite);
    refuses_each(m, cd_membrane_impulse(m, 1, bad, 1, one, COMPONENTS), "v", beside_v);
    refuses_each(m, cd_membrane_impulse(m, 1, bad, 1, one, COMPONENTS), "v", not_finite);
    refuses_parameters(cd_membrane_impulse(m, 1, 1, bad, one, COMPONENTS), "radius");
}

static void the_extremes_of_the_header_are_taken(void** state) {
    (void)state;
    static cd_status (*const setters[])(cd_membrane*, double) = {cd_membrane_set_mass, cd_membrane_set_bend,
                                                                 cd_membrane_set_drag,
                                                                 cd_membrane_set_stiffness_damping};
    cd_membrane* c = cloth(5, 3, 3, CD_FLOAT32);
    const double one[3] = {1, 1, 1};
    for (size_t i = 0; i < COUNT(setters); ++i) {
        ok(setters[i](c, 1e60));
        ok(setters[i](c, 1e-60));
        if (setters[i] != cd_membrane_set_mass) ok(setters[i](c, 0));
    }
    ok(cd_membrane_set_mass(c, 1));
    ok(cd_membrane_set_stiffness(c, 1e60, 0));
    ok(cd_membrane_set_stiffness(c, 0, 1e60));
    ok(cd_membrane_set_stiffness(c, 1e-60, 1e-60));
    ok(cd_membrane_set_pressure(c, 1e60));
    ok(cd_membrane_set_pressure(c, -1e60));
    ok(cd_membrane_set_pressure(c, 0));
    ok(cd_membrane_set_lambda(c, 0));
    ok(cd_membrane_set_lambda(c, 1));
    ok(cd_membrane_set_tolerance(c, 1e-14, 1));
    ok(cd_membrane_set_tolerance(c, 0.5, SIZE_MAX));
    ok(cd_membrane_impulse(c, 0, 0, 0, one, 3));
    ok(cd_membrane_impulse(c, 5, 3, 1e60, one, 3));
    ok(cd_membrane_attach(c, 0, 3, 1e60, 1e60, NULL, 3));
    ok(cd_membrane_step(c, 1e-30, 1));
    ok(cd_membrane_step(c, 1e30, 1));
    cd_membrane_destroy(c);
}

static void no_array_takes_what_is_not_finite(void** state) {
    (void)state;
    for (size_t at = 0; at < COMPONENTS; ++at) {
        for (size_t i = 0; i < COUNT(not_finite); ++i) {
            double numbers[2 * COMPONENTS] = {0.5, 0.5, 0.5};
            numbers[at] = not_finite[i].value;
            const char* shown = not_finite[i].shown;
            refuses(m, cd_membrane_set_gravity(m, numbers, COMPONENTS), CD_ERROR_VALUE,
                    text_of("gravity|[%zu]|%s", at, shown));
            refuses(m, cd_membrane_impulse(m, 1, 2, 1.5, numbers, COMPONENTS), CD_ERROR_VALUE,
                    text_of("impulse|[%zu]|%s", at, shown));
            const double turn[9] = {1, 0, 0, 0, at == 1 ? numbers[1] : 1, 0, 0, 0, at == 2 ? numbers[2] : 1};
            refuses(m, cd_membrane_teleport(m, NULL, numbers, COMPONENTS), CD_ERROR_VALUE,
                    text_of("offset|[%zu]|%s", at, shown));
            if (at > 0)
                refuses(m, cd_membrane_teleport(m, turn, numbers + COMPONENTS, COMPONENTS), CD_ERROR_VALUE,
                        text_of("rotation|[%zu]|%s", 4 * at, shown));
            refuses(m, cd_membrane_attach(m, 2, 1, 1, 1, numbers, COMPONENTS), CD_ERROR_VALUE,
                    text_of("target|[%zu]|%s", at, shown));
        }
    }
    for (size_t at = 0; at < 4; ++at) {
        for (size_t i = 0; i < COUNT(not_finite); ++i) {
            double places[4] = {0.5, 0.5, 0.5, 0.5};
            places[at] = not_finite[i].value;
            refuses(m, cd_membrane_sample(m, places, 2, out.number, 2 * COMPONENTS), CD_ERROR_VALUE,
                    text_of("at|[%zu]|%s", at, not_finite[i].shown));
        }
    }
    const double before[] = {1, -0.125}, behind_u[] = {NU + 0.125, 1}, behind_v[] = {1, NV + 0.125};
    refuses(m, cd_membrane_sample(m, before, 1, out.number, COMPONENTS), CD_ERROR_VALUE, "at|[1]|-0.125");
    refuses(m, cd_membrane_sample(m, behind_u, 1, out.number, COMPONENTS), CD_ERROR_VALUE, "at|[0]|7.125");
    refuses(m, cd_membrane_sample(m, behind_v, 1, out.number, COMPONENTS), CD_ERROR_VALUE, "at|[1]|5.125");
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

static void no_number_is_taken_for_an_enumerator(void** state) {
    (void)state;
    static const int32_t none[] = {-1, 5, 99, INT32_MAX, INT32_MIN};
    for (size_t i = 0; i < COUNT(none); ++i) {
        const int bad = none[i];
        refuses(m, cd_membrane_create(1, 1, 1, bad, NULL, &out.membrane), CD_ERROR_ENUM, text_of("precision|%d", bad));
        refuses(m, cd_membrane_set_method(m, bad), CD_ERROR_ENUM, text_of("method|%d", bad));
        refuses(m, cd_membrane_set_kernels(m, bad), CD_ERROR_ENUM, text_of("kernels|%d", bad));
        refuses(m, cd_membrane_set_solver(m, bad), CD_ERROR_ENUM, text_of("solver|%d", bad));
        refuses(m, cd_membrane_set_mass_rule(m, bad), CD_ERROR_ENUM, text_of("rule|%d", bad));
        refuses(m, cd_membrane_set_edge(m, CD_EDGE_V_LAST, bad), CD_ERROR_ENUM, text_of("kind|%d", bad));
        refuses(m, cd_membrane_set_edge(m, bad, CD_NODE_FREE), CD_ERROR_ENUM, text_of("edge|%d", bad));
        refuses(m, cd_membrane_get_edge(m, bad, &out.i32), CD_ERROR_ENUM, text_of("edge|%d", bad));
        refuses(m, cd_membrane_set_ring(m, bad, 0), CD_ERROR_VALUE, text_of("along_u|%d", bad));
        refuses(m, cd_membrane_set_ring(m, 0, bad), CD_ERROR_VALUE, text_of("along_v|%d", bad));
    }
    refuses(m, cd_membrane_create(1, 1, 1, 2, NULL, &out.membrane), CD_ERROR_ENUM, "precision|2");
    refuses(m, cd_membrane_set_mass_rule(m, 2), CD_ERROR_ENUM, "rule|2");
    refuses(m, cd_membrane_set_method(m, 4), CD_ERROR_ENUM, "method|4");
    refuses(m, cd_membrane_set_edge(m, 4, CD_NODE_FREE), CD_ERROR_ENUM, "edge|4");
    refuses(m, cd_membrane_set_solver(m, 2), CD_ERROR_ENUM, "solver|2");
    refuses(m, cd_membrane_set_ring(m, 1, 2), CD_ERROR_VALUE, "along_v|2");
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

static void no_index_beyond_the_end_is_taken(void** state) {
    (void)state;
    static const size_t beyond[] = {0, 1, 1000, SIZE_MAX / 2, SIZE_MAX / 8 + 2};
    const double numbers[COMPONENTS] = {0.5, 0.5, 0.5};
    for (size_t i = 0; i <= COUNT(beyond); ++i) {
        const size_t u = i < COUNT(beyond) ? NU + 1 + beyond[i] : SIZE_MAX;
        const size_t v = i < COUNT(beyond) ? NV + 1 + beyond[i] : SIZE_MAX;
        refuses(m, cd_membrane_attach(m, u, 0, 1, 1, numbers, COMPONENTS), CD_ERROR_RANGE, name_and_size("u", u));
        refuses(m, cd_membrane_attach(m, 0, v, 1, 1, NULL, COMPONENTS), CD_ERROR_RANGE, name_and_size("v", v));
        refuses(m, cd_membrane_detach(m, u, 0), CD_ERROR_RANGE, name_and_size("u", u));
        refuses(m, cd_membrane_detach(m, 0, v), CD_ERROR_RANGE, name_and_size("v", v));
        refuses(m, cd_membrane_get_attachment(m, u, 0, &out.number[0], &out.number[1]), CD_ERROR_RANGE,
                name_and_size("u", u));
        refuses(m, cd_membrane_get_attachment(m, 0, v, &out.number[0], &out.number[1]), CD_ERROR_RANGE,
                name_and_size("v", v));
    }
}

static void no_buffer_of_another_length_is_taken(void** state) {
    (void)state;
    static const size_t wrong[] = {1, 2, 77, SIZE_MAX};
    double numbers[4] = {0.5, 0.5, 0.5, 0.5};
    for (size_t i = 0; i < COUNT(wrong); ++i) {
        const size_t count = wrong[i];
        const char* text = name_and_size("count", count);
        refuses(m, cd_membrane_set_gravity(m, numbers, count), CD_ERROR_RANGE, text);
        refuses(m, cd_membrane_get_gravity(m, out.number, count), CD_ERROR_RANGE, text);
        refuses(m, cd_membrane_impulse(m, 0, 2, 1, numbers, count), CD_ERROR_RANGE, text);
        refuses(m, cd_membrane_teleport(m, NULL, numbers, count), CD_ERROR_RANGE, text);
        refuses(m, cd_membrane_attach(m, 2, 1, 1, 1, numbers, count), CD_ERROR_RANGE, text);
        refuses(m, cd_membrane_get_momentum(m, out.number, count), CD_ERROR_RANGE, text);
        refuses(m, cd_membrane_sample(m, numbers, 2, out.number, count), CD_ERROR_RANGE,
                name_and_size("out_count", count));
    }
    static const size_t most[] = {SIZE_MAX, SIZE_MAX / 2 + 3, SIZE_MAX / 4 + 1};
    for (size_t i = 0; i < COUNT(most); ++i)
        refuses(m, cd_membrane_sample(m, numbers, most[i], out.number, 6), CD_ERROR_RANGE, name_and_size("n", most[i]));
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

/* Any count of steps is good; the sizes of save and load are tried in test_membrane_keep.c, those of drawing in
 * test_membrane_bad_draw.c. */
static const char* const elsewhere[] = {
    "cd_membrane_step count",
    "cd_membrane_save size",
    "cd_membrane_load size",
    "cd_membrane_write_vertices size",
    "cd_membrane_write_vertices stride",
    "cd_membrane_write_vertices position_offset",
    "cd_membrane_write_vertices normal_offset",
    "cd_membrane_write_indices size",
    "cd_membrane_write_indices index_size",
};

static void every_number_in_the_header_was_tried(void** state) {
    (void)state;
    all_numbers_were_tried("membrane", elsewhere, COUNT(elsewhere));
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(no_parameter_takes_a_number_outside_its_range),
        SURROUNDINGS_TESTS,
        cmocka_unit_test(no_cloth_takes_numbers_outside_their_range),
        cmocka_unit_test(only_cloth_tears_at_strains_in_the_range),
        cmocka_unit_test(no_impulse_is_given_beside_the_sheet),
        cmocka_unit_test(the_extremes_of_the_header_are_taken),
        cmocka_unit_test(no_array_takes_what_is_not_finite),
        cmocka_unit_test(an_impulse_too_strong_for_the_precision_changes_nothing),
        cmocka_unit_test(no_number_is_taken_for_an_enumerator),
        cmocka_unit_test(no_shape_is_made_that_cannot_be),
        cmocka_unit_test(no_index_beyond_the_end_is_taken),
        cmocka_unit_test(no_buffer_of_another_length_is_taken),
        cmocka_unit_test(what_the_membrane_cannot_do_is_said_to_be_unsupported),
        cmocka_unit_test(every_number_in_the_header_was_tried),
    };
    return cmocka_run_group_tests(tests, set_up, tear_down);
}
