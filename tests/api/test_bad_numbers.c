/* Numbers that are no numbers, out of range, or none of an enumeration's: every argument of chain.h that is passed by
 * value or as an array of numbers, but for the fields (test_bad_fields.c). */
#include <math.h>

#include "check.h"
#include "heap.h"
#include "refusals.h"
#include "scene.h"

enum { STRANDS = 3, SPRINGS = 9, NODES = SPRINGS + 1, COMPONENTS = 2 };

static cd_chain* chain;

static int set_up(void** state) {
    (void)state;
    chain = scene_chain(STRANDS, SPRINGS, COMPONENTS, CD_FLOAT32);
    scene_everything(chain);
    ok(cd_chain_step(chain, 0.001, 2));
    return 0;
}

static int tear_down(void** state) {
    (void)state;
    cd_chain_destroy(chain);
    return 0;
}

static void no_parameter_takes_a_number_outside_its_range(void** state) {
    (void)state;
    refuses_each(chain, cd_chain_set_lambda(chain, bad), "lambda", not_finite);
    refuses_each(chain, cd_chain_set_lambda(chain, bad), "lambda", not_a_share);
    refuses_each(chain, cd_chain_set_mass(chain, bad), "mass", not_finite);
    refuses_each(chain, cd_chain_set_mass(chain, bad), "mass", not_positive);
    refuses_each(chain, cd_chain_set_mass(chain, bad), "mass", too_large);
    refuses_each(chain, cd_chain_set_mass(chain, bad), "mass", too_small);
    refuses_each(chain, cd_chain_set_stiffness(chain, bad), "stiffness", not_finite);
    refuses_each(chain, cd_chain_set_stiffness(chain, bad), "stiffness", negative);
    refuses_each(chain, cd_chain_set_stiffness(chain, bad), "stiffness", too_large);
    refuses_each(chain, cd_chain_set_bend(chain, bad), "bend", not_finite);
    refuses_each(chain, cd_chain_set_bend(chain, bad), "bend", negative);
    refuses_each(chain, cd_chain_set_bend(chain, bad), "bend", too_large);
    refuses_each(chain, cd_chain_set_drag(chain, bad), "drag", not_finite);
    refuses_each(chain, cd_chain_set_drag(chain, bad), "drag", negative);
    refuses_each(chain, cd_chain_set_drag(chain, bad), "drag", too_large);
    refuses_each(chain, cd_chain_set_stiffness_damping(chain, bad), "seconds", not_finite);
    refuses_each(chain, cd_chain_set_stiffness_damping(chain, bad), "seconds", negative);
    refuses_each(chain, cd_chain_set_stiffness_damping(chain, bad), "seconds", too_large);
    static const struct bad_number no_tolerance[] = {{0.9e-14, "9e-15"}, {0.75, "0.75"}, {0, "0"}, {-1e-6, "-1e-06"}};
    refuses_each(chain, cd_chain_set_rest_length(chain, bad), "length", not_finite);
    refuses_each(chain, cd_chain_set_rest_length(chain, bad), "length", negative);
    refuses_each(chain, cd_chain_set_rest_length(chain, bad), "length", too_large);
    refuses_each(chain, cd_chain_set_rest_length(chain, bad), "length", too_small);
    refuses_each(chain, cd_chain_set_tolerance(chain, bad, 10), "tolerance", not_finite);
    refuses_each(chain, cd_chain_set_tolerance(chain, bad, 10), "tolerance", no_tolerance);
    refuses(chain, cd_chain_set_tolerance(chain, 1e-6, 0), CD_ERROR_VALUE, "most_iterations|0");
    refuses(chain, cd_chain_set_tolerance(chain, 1e-6, 10001), CD_ERROR_VALUE, "most_iterations|10001");
    refuses_each(chain, cd_chain_step(chain, bad, 1), "dt", not_finite);
    refuses_each(chain, cd_chain_step(chain, bad, 1), "dt", not_positive);
    refuses_each(chain, cd_chain_step(chain, bad, 1), "dt", not_a_step);
    refuses_each(chain, cd_chain_step(chain, bad, 0), "dt", not_finite);
    refuses_each(chain, cd_chain_attach(chain, 0, 2, bad, 1, NULL, COMPONENTS), "stiffness", not_finite);
    refuses_each(chain, cd_chain_attach(chain, 0, 2, bad, 1, NULL, COMPONENTS), "stiffness", negative);
    refuses_each(chain, cd_chain_attach(chain, 0, 2, bad, 1, NULL, COMPONENTS), "stiffness", too_large);
    refuses_each(chain, cd_chain_attach(chain, 0, 2, 1, bad, NULL, COMPONENTS), "damping", not_finite);
    refuses_each(chain, cd_chain_attach(chain, 0, 2, 1, bad, NULL, COMPONENTS), "damping", negative);
    refuses_each(chain, cd_chain_attach(chain, 0, 2, 1, bad, NULL, COMPONENTS), "damping", too_large);
}

static void the_extremes_of_the_header_are_taken(void** state) {
    (void)state;
    static cd_status (*const setters[])(cd_chain*, double) = {cd_chain_set_mass, cd_chain_set_stiffness,
                                                              cd_chain_set_bend, cd_chain_set_drag,
                                                              cd_chain_set_stiffness_damping};
    cd_chain* c = scene_chain(1, 5, 1, CD_FLOAT32);
    for (size_t i = 0; i < COUNT(setters); ++i) {
        ok(setters[i](c, 1e60));
        ok(setters[i](c, 1e-60));
        if (setters[i] != cd_chain_set_mass) ok(setters[i](c, 0));
    }
    ok(cd_chain_set_lambda(c, 0));
    ok(cd_chain_set_lambda(c, 1));
    ok(cd_chain_attach(c, 0, 0, 1e60, 1e60, NULL, 1));
    ok(cd_chain_step(c, 1e-30, 1));
    ok(cd_chain_step(c, 1e30, 1));
    ok(cd_chain_set_tolerance(c, 1e-14, 1));
    ok(cd_chain_set_tolerance(c, 0.5, 10000));
    ok(cd_chain_set_rest_length(c, 1e60));
    ok(cd_chain_set_rest_length(c, 1e-60));
    ok(cd_chain_set_stiffness(c, INFINITY));
    ok(cd_chain_set_stiffness(c, 1));
    ok(cd_chain_set_air(c, 1e60, 0));
    ok(cd_chain_set_air(c, 0, 1e60));
    ok(cd_chain_set_strength(c, 1e60));
    ok(cd_chain_set_strength(c, 1e-60));
    ok(cd_chain_set_strength(c, INFINITY));
    const double most = 1e60, least = -1e60, tiny = 5e-324;
    ok(cd_chain_set_colliders(c, 4096));
    ok(cd_chain_set_plane(c, 4095, &most, &least, 1, 1e60));
    ok(cd_chain_set_plane(c, 4094, &least, &tiny, 1, 0));
    ok(cd_chain_set_capsule(c, 0, &most, &least, 1, 1e60, 1e60));
    ok(cd_chain_set_capsule(c, 1, &most, &most, 1, 1e-60, 0));
    ok(cd_chain_set_collider_velocity(c, 1, &least, 1));
    ok(cd_chain_set_thickness(c, 1e60));
    ok(cd_chain_set_thickness(c, 0));
    ok(cd_chain_set_colliders(c, 0));
    ok(cd_chain_set_rest_length(c, 0));
    cd_chain_destroy(c);
}

/* The total stiffness of a rope may be infinite, and nothing else is out of range that was not before. */
static void a_rope_takes_no_other_stiffness_outside_the_range(void** state) {
    (void)state;
    static const struct bad_number no_number[] = {{NAN, "nan"}, {-INFINITY, "-inf"}};
    cd_chain* c = scene_chain(2, 5, 3, CD_FLOAT64);
    refuses(c, cd_chain_set_stiffness(c, INFINITY), CD_ERROR_VALUE, "stiffness|inf|no rest length: set one first");
    ok(cd_chain_set_rest_length(c, 1));
    ok(cd_chain_set_stiffness(c, INFINITY));
    refuses_each(c, cd_chain_set_stiffness(c, bad), "stiffness", no_number);
    refuses_each(c, cd_chain_set_stiffness(c, bad), "stiffness", negative);
    refuses_each(c, cd_chain_set_stiffness(c, bad), "stiffness", too_large);
    cd_chain_destroy(c);
}

static cd_chain* new_body(void) { return scene_chain(2, 5, 3, CD_FLOAT64); }
static void set_lengths(cd_chain* c, double length) { ok(cd_chain_set_rest_length(c, length)); }
static cd_status read_winds(const cd_chain* c, double* winds) {
    return cd_chain_read_f64(c, CD_WIND, 0, 2, 0, 6, winds, 36);
}
#define BODY chain
#define THICKNESS "radius"
#include "bad_surroundings.h"

static void only_ropes_break_at_strengths_in_the_range(void** state) {
    (void)state;
    static const struct bad_number no_number[] = {{NAN, "nan"}, {-INFINITY, "-inf"}, {0, "0"}, {9e-61, "9e-61"}};
    double strength, force[3] = {7, 7, 7};
    cd_chain* c = scene_chain(2, 5, 3, CD_FLOAT64);
    refuses(c, cd_chain_set_strength(c, 1), CD_ERROR_UNSUPPORTED, "break|rest length");
    refuses(c, cd_chain_get_reaction(c, 0, 0, force, 3), CD_ERROR_UNSUPPORTED, "tensions|rest length");
    ok(cd_chain_set_rest_length(c, 1));
    refuses_each(c, cd_chain_set_strength(c, bad), "strength", no_number);
    refuses_each(c, cd_chain_set_strength(c, bad), "strength", negative);
    refuses_each(c, cd_chain_set_strength(c, bad), "strength", too_large);
    refuses(c, cd_chain_get_reaction(c, 2, 0, force, 3), CD_ERROR_RANGE, name_and_size("strand", 2));
    refuses(c, cd_chain_get_reaction(c, 0, 6, force, 3), CD_ERROR_RANGE, name_and_size("node", 6));
    refuses(c, cd_chain_get_reaction(c, 0, 0, force, 2), CD_ERROR_RANGE, name_and_size("count", 2));
    assert_true(force[0] == 7 && force[1] == 7 && force[2] == 7);
    ok(cd_chain_set_strength(c, 4));
    ok(cd_chain_enable_field(c, CD_STRENGTH));
    assert_true(scene_get(c, CD_STRENGTH, 3) == 4);
    scene_set(c, CD_STRENGTH, 3, INFINITY);
    ok(cd_chain_set_strength(c, 5)); /* writes the field anew */
    assert_true(scene_get(c, CD_STRENGTH, 3) == 5);
    ok(cd_chain_disable_field(c, CD_STRENGTH));
    refuses(c, cd_chain_disable_field(c, CD_STIFFNESS), CD_ERROR_UNSUPPORTED, "CD_STIFFNESS");
    ok(cd_chain_set_rest_length(c, 0)); /* switches all of it off */
    ok(cd_chain_disable_field(c, CD_STIFFNESS));
    ok(cd_chain_set_rest_length(c, 1));
    ok(cd_chain_get_strength(c, &strength));
    assert_true(isinf(strength));
    cd_chain_destroy(c);
}

/* Turns and shifts of what cannot be reached, or is no turn. */
static void nothing_moves_that_cannot_be_teleported(void** state) {
    (void)state;
    const double offset[COMPONENTS] = {1, -1}, turn[4] = {0.6, -0.8, 0.8, 0.6};
    const double skew[4] = {0.6, -0.8, 0.8, 0.600002}, larger[4] = {1.000001, 0, 0, 1};
    for (size_t at = 0; at < COMPONENTS; ++at)
        for (size_t i = 0; i < COUNT(not_finite); ++i) {
            double numbers[4] = {1, 0, 0, 1};
            numbers[at] = not_finite[i].value;
            const char* shown = not_finite[i].shown;
            refuses(chain, cd_chain_teleport(chain, 1, NULL, numbers, COMPONENTS), CD_ERROR_VALUE,
                    text_of("offset|[%zu]|%s", at, shown));
            refuses(chain, cd_chain_teleport(chain, 1, numbers, offset, COMPONENTS), CD_ERROR_VALUE,
                    text_of("rotation|[%zu]|%s", at, shown));
        }
    refuses(chain, cd_chain_teleport(chain, 1, skew, offset, COMPONENTS), CD_ERROR_VALUE, "rotation|orthogonal|rows 0 and 1");
    refuses(chain, cd_chain_teleport(chain, 1, larger, offset, COMPONENTS), CD_ERROR_VALUE, "rotation|orthogonal|rows 0 and 0");
    refuses(chain, cd_chain_teleport(chain, 99, turn, offset, COMPONENTS), CD_ERROR_RANGE, name_and_size("strand", 99));
    refuses(chain, cd_chain_teleport(chain, 1, turn, offset, 3), CD_ERROR_RANGE, name_and_size("count", 3));
    cd_chain* c = scene_chain(1, 2, 2, CD_FLOAT32);
    const double far[6] = {3e38, 0, -3e38, 3e38, 1, 1}, further[2] = {1e38, 0}, nowhere[2] = {0, 0};
    scene_write(c, CD_POSITION, far);
    refuses(c, cd_chain_teleport(c, 0, NULL, further, 2), CD_ERROR_VALUE, "finite");
    refuses(c, cd_chain_teleport(c, 0, turn, nowhere, 2), CD_ERROR_VALUE, "finite");
    cd_chain_destroy(c);
}

static void no_array_takes_what_is_not_finite(void** state) {
    (void)state;
    for (size_t at = 0; at < COMPONENTS; ++at) {
        for (size_t i = 0; i < COUNT(not_finite); ++i) {
            double numbers[COMPONENTS] = {0.5, 0.5};
            numbers[at] = not_finite[i].value;
            const char* shown = not_finite[i].shown;
            refuses(chain, cd_chain_set_gravity(chain, numbers, COMPONENTS), CD_ERROR_VALUE,
                    text_of("gravity|[%zu]|%s", at, shown));
            refuses(chain, cd_chain_impulse(chain, 1, 2, numbers, COMPONENTS), CD_ERROR_VALUE,
                    text_of("impulse|[%zu]|%s", at, shown));
            refuses(chain, cd_chain_attach(chain, 0, 2, 1, 1, numbers, COMPONENTS), CD_ERROR_VALUE,
                    text_of("target|[%zu]|%s", at, shown));
            refuses(chain, cd_chain_sample(chain, 1, numbers, 2, out.number, 2 * COMPONENTS), CD_ERROR_VALUE,
                    text_of("at|[%zu]|%s", at, shown));
        }
    }
    const double before[] = {1, -0.125}, behind[] = {SPRINGS + 0.125, 1};
    refuses(chain, cd_chain_sample(chain, 0, before, 2, out.number, 2 * COMPONENTS), CD_ERROR_VALUE, "at|[1]|-0.125");
    refuses(chain, cd_chain_sample(chain, 0, behind, 2, out.number, 2 * COMPONENTS), CD_ERROR_VALUE, "at|[0]|9.125");
}

static void no_number_is_taken_for_an_enumerator(void** state) {
    (void)state;
    static const int32_t none[] = {-1, 5, 99, INT32_MAX, INT32_MIN};
    for (size_t i = 0; i < COUNT(none); ++i) {
        const int bad = none[i];
        refuses(chain, cd_chain_create(1, 1, 1, bad, NULL, &out.chain), CD_ERROR_ENUM, text_of("precision|%d", bad));
        refuses(chain, cd_chain_set_method(chain, bad), CD_ERROR_ENUM, text_of("method|%d", bad));
        refuses(chain, cd_chain_set_kernels(chain, bad), CD_ERROR_ENUM, text_of("kernels|%d", bad));
        refuses(chain, cd_chain_set_mass_rule(chain, bad), CD_ERROR_ENUM, text_of("rule|%d", bad));
        refuses(chain, cd_chain_set_end(chain, CD_END_LAST, bad), CD_ERROR_ENUM, text_of("kind|%d", bad));
        refuses(chain, cd_chain_set_end(chain, bad, CD_NODE_FREE), CD_ERROR_ENUM, text_of("end|%d", bad));
        refuses(chain, cd_chain_get_end(chain, bad, &out.i32), CD_ERROR_ENUM, text_of("end|%d", bad));
        refuses(chain, cd_chain_set_ring(chain, bad), CD_ERROR_VALUE, text_of("ring|%d", bad));
        refuses(chain, cd_chain_set_push(chain, bad), CD_ERROR_VALUE, text_of("push|%d", bad));
    }
    refuses(chain, cd_chain_create(1, 1, 1, 2, NULL, &out.chain), CD_ERROR_ENUM, "precision|2");
    refuses(chain, cd_chain_set_mass_rule(chain, 2), CD_ERROR_ENUM, "rule|2");
    refuses(chain, cd_chain_set_method(chain, 4), CD_ERROR_ENUM, "method|4");
    refuses(chain, cd_chain_set_kernels(chain, 3), CD_ERROR_ENUM, "kernels|3");
    refuses(chain, cd_chain_set_end(chain, 2, CD_NODE_FREE), CD_ERROR_ENUM, "end|2");
    refuses(chain, cd_chain_get_end(chain, 2, &out.i32), CD_ERROR_ENUM, "end|2");
    refuses(chain, cd_chain_set_ring(chain, 2), CD_ERROR_VALUE, "ring|2");
    refuses(chain, cd_chain_set_push(chain, 2), CD_ERROR_VALUE, "push|2");
}

static void no_shape_is_made_that_cannot_be(void** state) {
    (void)state;
    struct heap heap = {0}; /* refuses what is too large without trying the machine's memory */
    const cd_allocator allocator = heap_allocator(&heap);
    static const size_t big = (size_t)1 << (sizeof(size_t) == 8 ? 40 : 26), most = SIZE_MAX;
    static const struct {
        size_t strands, springs, components;
        cd_status status;
        const char* argument;
        size_t shown;
    } bad[] = {
        {0, 1, 1, CD_ERROR_VALUE, "strands", 0},
        {1, 1, 0, CD_ERROR_VALUE, "components", 0},
        {1, 1, 5, CD_ERROR_VALUE, "components", 5},
        {1, 1, SIZE_MAX, CD_ERROR_VALUE, "components", SIZE_MAX},
        {1, SIZE_MAX, 1, CD_ERROR_SIZE, "springs", SIZE_MAX},
        {1, SIZE_MAX - 1, 1, CD_ERROR_SIZE, "springs", SIZE_MAX - 1},
        {SIZE_MAX, 1, 1, CD_ERROR_SIZE, "strands", SIZE_MAX},
        {SIZE_MAX, 0, 4, CD_ERROR_SIZE, "strands", SIZE_MAX},
        {SIZE_MAX, SIZE_MAX, 4, CD_ERROR_SIZE, "strands", SIZE_MAX},
        {SIZE_MAX / 2 + 1, 1, 1, CD_ERROR_SIZE, "strands", SIZE_MAX / 2 + 1},
        {SIZE_MAX / 4 + 1, 3, 1, CD_ERROR_SIZE, "strands", SIZE_MAX / 4 + 1},
        {1, SIZE_MAX / 8, 1, CD_ERROR_SIZE, "springs", SIZE_MAX / 8},
    };
    for (size_t i = 0; i < COUNT(bad); ++i)
        for (cd_precision precision = CD_FLOAT32; precision <= CD_FLOAT64; ++precision)
            refuses(chain,
                    cd_chain_create(bad[i].strands, bad[i].springs, bad[i].components, precision, &allocator,
                                    &out.chain),
                    bad[i].status, name_and_size(bad[i].argument, bad[i].shown));
    refuses(chain, cd_chain_create(big, big, 4, CD_FLOAT64, &allocator, &out.chain), CD_ERROR_SIZE,
            name_and_size("springs", big));
    refuses(chain, cd_chain_create(1, big, 1, CD_FLOAT64, &allocator, &out.chain), CD_ERROR_MEMORY, "");
    refuses(chain, cd_chain_create(big, 1, 1, CD_FLOAT32, &allocator, &out.chain), CD_ERROR_MEMORY, "");
    assert_true(most > big);
    heap_free(&heap);
}

static void no_index_beyond_the_end_is_taken(void** state) {
    (void)state;
    static const size_t beyond[] = {0, 1, 1000, SIZE_MAX / 2, SIZE_MAX / 8 + 2};
    const double numbers[2] = {0.5, 0.5};
    for (size_t i = 0; i <= COUNT(beyond); ++i) {
        const size_t strand = i < COUNT(beyond) ? STRANDS + beyond[i] : SIZE_MAX;
        const size_t node = i < COUNT(beyond) ? NODES + beyond[i] : SIZE_MAX;
        const size_t spring = i < COUNT(beyond) ? SPRINGS + beyond[i] : SIZE_MAX;
        refuses(chain, cd_chain_impulse(chain, strand, 2, numbers, 2), CD_ERROR_RANGE, name_and_size("strand", strand));
        refuses(chain, cd_chain_impulse(chain, 0, node, numbers, 2), CD_ERROR_RANGE, name_and_size("node", node));
        refuses(chain, cd_chain_attach(chain, 0, node, 1, 1, numbers, 2), CD_ERROR_RANGE, name_and_size("node", node));
        refuses(chain, cd_chain_attach(chain, 0, node, 1, 1, NULL, 2), CD_ERROR_RANGE, name_and_size("node", node));
        refuses(chain, cd_chain_detach(chain, 0, node), CD_ERROR_RANGE, name_and_size("node", node));
        refuses(chain, cd_chain_get_attachment(chain, 0, node, &out.number[0], &out.number[1]), CD_ERROR_RANGE,
                name_and_size("node", node));
        refuses(chain, cd_chain_cut(chain, 0, spring), CD_ERROR_RANGE, name_and_size("spring", spring));
        refuses(chain, cd_chain_weld(chain, 0, spring), CD_ERROR_RANGE, name_and_size("spring", spring));
        for (int is_rope = 0; is_rope <= 1; ++is_rope) { /* what strands share they all have: there is but strand 0 */
            const size_t s = is_rope ? strand : strand - STRANDS + 1;
            if (is_rope) ok(cd_chain_set_rest_length(chain, 1));
            refuses(chain, cd_chain_attach(chain, s, 2, 1, 1, numbers, 2), CD_ERROR_RANGE, name_and_size("strand", s));
            refuses(chain, cd_chain_detach(chain, s, 2), CD_ERROR_RANGE, name_and_size("strand", s));
            refuses(chain, cd_chain_get_attachment(chain, s, 2, &out.number[0], &out.number[1]), CD_ERROR_RANGE,
                    name_and_size("strand", s));
            refuses(chain, cd_chain_cut(chain, s, 2), CD_ERROR_RANGE, name_and_size("strand", s));
            refuses(chain, cd_chain_weld(chain, s, 2), CD_ERROR_RANGE, name_and_size("strand", s));
            ok(cd_chain_set_rest_length(chain, 0));
        }
        refuses(chain, cd_chain_sample(chain, strand, numbers, 2, out.number, 4), CD_ERROR_RANGE,
                name_and_size("strand", strand));
    }
}

static void no_buffer_of_another_length_is_taken(void** state) {
    (void)state;
    static const size_t wrong[] = {1, 3, 77, SIZE_MAX};
    double numbers[4] = {0.5, 0.5, 0.5, 0.5};
    for (size_t i = 0; i < COUNT(wrong); ++i) {
        const size_t count = wrong[i];
        refuses(chain, cd_chain_set_gravity(chain, numbers, count), CD_ERROR_RANGE, name_and_size("count", count));
        refuses(chain, cd_chain_get_gravity(chain, out.number, count), CD_ERROR_RANGE, name_and_size("count", count));
        refuses(chain, cd_chain_impulse(chain, 0, 2, numbers, count), CD_ERROR_RANGE, name_and_size("count", count));
        refuses(chain, cd_chain_attach(chain, 0, 2, 1, 1, numbers, count), CD_ERROR_RANGE,
                name_and_size("count", count));
        refuses(chain, cd_chain_get_momentum(chain, out.number, count), CD_ERROR_RANGE, name_and_size("count", count));
        refuses(chain, cd_chain_sample(chain, 0, numbers, 2, out.number, count), CD_ERROR_RANGE,
                name_and_size("out_count", count));
    }
    static const size_t most[] = {SIZE_MAX, SIZE_MAX / 2 + 3, SIZE_MAX / 4 + 1};
    for (size_t i = 0; i < COUNT(most); ++i) /* n * COMPONENTS comes round to 4 in the second */
        refuses(chain, cd_chain_sample(chain, 0, numbers, most[i], out.number, 4), CD_ERROR_RANGE,
                name_and_size("n", most[i]));
}

static void what_the_chain_cannot_do_is_said_to_be_unsupported(void** state) {
    (void)state;
    cd_chain* pair = scene_chain(1, 1, 1, CD_FLOAT64);
    refuses(pair, cd_chain_set_ring(pair, 1), CD_ERROR_UNSUPPORTED, "2");
    cd_chain_destroy(pair);

    cd_chain* ring = scene_chain(1, 8, 1, CD_FLOAT64);
    ok(cd_chain_set_end(ring, CD_END_LAST, CD_NODE_MATCHED));
    refuses(ring, cd_chain_set_ring(ring, 1), CD_ERROR_UNSUPPORTED, "");
    ok(cd_chain_set_end(ring, CD_END_LAST, CD_NODE_FREE));
    ok(cd_chain_set_ring(ring, 1));
    for (cd_end end = CD_END_FIRST; end <= CD_END_LAST; ++end)
        refuses(ring, cd_chain_set_end(ring, end, CD_NODE_MATCHED), CD_ERROR_UNSUPPORTED, "kind");
    cd_chain_destroy(ring);
}

/* Any count of steps is good; the sizes of save and load are tried in test_keep.c. */
static const char* const elsewhere[] = {"cd_chain_step count", "cd_chain_save size", "cd_chain_load size"};

static void every_number_in_the_header_was_tried(void** state) {
    (void)state;
    all_numbers_were_tried("chain", elsewhere, COUNT(elsewhere));
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(no_parameter_takes_a_number_outside_its_range),
        cmocka_unit_test(the_extremes_of_the_header_are_taken),
        cmocka_unit_test(a_rope_takes_no_other_stiffness_outside_the_range),
        cmocka_unit_test(only_ropes_break_at_strengths_in_the_range),
        SURROUNDINGS_TESTS,
        cmocka_unit_test(nothing_moves_that_cannot_be_teleported),
        cmocka_unit_test(no_array_takes_what_is_not_finite),
        cmocka_unit_test(no_number_is_taken_for_an_enumerator),
        cmocka_unit_test(no_shape_is_made_that_cannot_be),
        cmocka_unit_test(no_index_beyond_the_end_is_taken),
        cmocka_unit_test(no_buffer_of_another_length_is_taken),
        cmocka_unit_test(what_the_chain_cannot_do_is_said_to_be_unsupported),
        cmocka_unit_test(every_number_in_the_header_was_tried),
    };
    return cmocka_run_group_tests(tests, set_up, tear_down);
}
