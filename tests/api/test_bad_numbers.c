/* Numbers of chain.h that are out of range together with others, or in a state of the chain. What each may be by itself
 * is tried by tests/bindings/check_ranges.py; for the fields see test_bad_fields.c. */
#include <math.h>

#include "check.h"
#include "heap.h"
#include "refusals.h"
#include "scene.h"

enum { STRANDS = 3, SPRINGS = 9, COMPONENTS = 2 };

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

static cd_chain* new_body(void) { return scene_chain(2, 5, 3, CD_FLOAT64); }
static void set_lengths(cd_chain* c, double length) { ok(cd_chain_set_rest_length(c, length)); }
static cd_status read_winds(const cd_chain* c, double* winds) {
    return cd_chain_read_f64(c, CD_WIND, 0, 2, 0, 6, winds, 36);
}
#define BODY chain
#include "bad_surroundings.h"

static void only_ropes_in_a_plane_have_rest_angles(void** state) {
    (void)state;
    enum { JOINTS = 13 }; /* as many half turns, dealt out, round to more than one */
    const double most = JOINTS * 3.141592653589793;
    double angle = 1;
    cd_chain *c = scene_chain(2, JOINTS + 1, 2, CD_FLOAT64), *in_space = scene_chain(2, JOINTS + 1, 3, CD_FLOAT64);
    refuses(c, cd_chain_set_rest_angle(c, 1), CD_ERROR_UNSUPPORTED, "rest angles|rest length");
    refuses(in_space, cd_chain_set_rest_angle(in_space, 0), CD_ERROR_UNSUPPORTED, "rest angles|rest length");
    ok(cd_chain_set_rest_length(c, 1));
    ok(cd_chain_set_rest_length(in_space, 1));
    refuses(in_space, cd_chain_set_rest_angle(in_space, 1), CD_ERROR_UNSUPPORTED, "2 components|3");
    ok(cd_chain_set_rest_angle(in_space, 0)); /* which is what it has */
    refuses(in_space, cd_chain_enable_field(in_space, CD_REST_ANGLE), CD_ERROR_UNSUPPORTED, "2 components|3");
    for (int sign = -1; sign <= 1; sign += 2) {
        refuses(c, cd_chain_set_rest_angle(c, sign * nextafter(most, 100)), CD_ERROR_VALUE, "angle|40.8407");
        ok(cd_chain_set_rest_angle(c, sign * most));
    }
    refuses(c, cd_chain_set_rest_angle(c, NAN), CD_ERROR_VALUE, "angle|nan");
    ok(cd_chain_enable_field(c, CD_REST_ANGLE));
    assert_true(scene_get(c, CD_REST_ANGLE, 2) == 3.141592653589793);
    scene_set(c, CD_REST_ANGLE, 2, 0.5);
    ok(cd_chain_set_rest_angle(c, -6.5)); /* writes the field anew */
    assert_true(scene_get(c, CD_REST_ANGLE, 2) == -0.5);
    ok(cd_chain_set_rest_length(c, 0)); /* switches all of it off */
    ok(cd_chain_get_rest_angle(c, &angle));
    assert_true(angle == 0);
    ok(cd_chain_set_rest_length(c, 1));
    refuses(c, cd_chain_read_f64(c, CD_REST_ANGLE, 0, 1, 0, 1, out.number, 1), CD_ERROR_DISABLED, "CD_REST_ANGLE");
    cd_chain_destroy(c);
    cd_chain_destroy(in_space);
    c = scene_chain(1, 1, 2, CD_FLOAT64); /* without a joint */
    ok(cd_chain_set_rest_length(c, 1));
    ok(cd_chain_set_rest_angle(c, 0));
    refuses(c, cd_chain_set_rest_angle(c, 1e-300), CD_ERROR_VALUE, "angle|in [0, 0]");
    cd_chain_destroy(c);
}

static void only_ropes_break(void** state) {
    (void)state;
    double strength;
    cd_chain* c = scene_chain(2, 5, 3, CD_FLOAT64);
    refuses(c, cd_chain_set_strength(c, 1), CD_ERROR_UNSUPPORTED, "break|rest length");
    refuses(c, cd_chain_get_reaction(c, 0, 0, out.number, 3), CD_ERROR_UNSUPPORTED, "tensions|rest length");
    ok(cd_chain_set_rest_length(c, 1));
    refuses(c, cd_chain_set_strength(c, -1), CD_ERROR_VALUE, "strength is -1|in [1e-60, 1e+60] or INFINITY");
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
    refuses(chain, cd_chain_teleport(chain, 1, skew, offset, COMPONENTS), CD_ERROR_VALUE,
            "rotation|orthogonal|rows 0 and 1");
    refuses(chain, cd_chain_teleport(chain, 1, larger, offset, COMPONENTS), CD_ERROR_VALUE,
            "rotation|orthogonal|rows 0 and 0");
    const double mirror[4] = {0.6, 0.8, 0.8, -0.6};
    ok(cd_chain_teleport(chain, 1, mirror, offset, COMPONENTS));
    ok(cd_chain_set_rest_length(chain, 1));
    ok(cd_chain_set_rest_angle(chain, 1)); /* which would turn the wrong way */
    refuses(chain, cd_chain_teleport(chain, 1, mirror, offset, COMPONENTS), CD_ERROR_VALUE, "rotation|mirror|angles");
    ok(cd_chain_teleport(chain, 1, turn, offset, COMPONENTS));
    cd_chain* c = scene_chain(1, 2, 2, CD_FLOAT32);
    const double far[6] = {3e38, 0, -3e38, 3e38, 1, 1}, further[2] = {1e38, 0}, nowhere[2] = {0, 0};
    scene_write(c, CD_POSITION, far);
    refuses(c, cd_chain_teleport(c, 0, NULL, further, 2), CD_ERROR_VALUE, "finite");
    refuses(c, cd_chain_teleport(c, 0, turn, nowhere, 2), CD_ERROR_VALUE, "finite");
    cd_chain_destroy(c);
}

static void only_ropes_are_rigid(void** state) {
    (void)state;
    cd_chain* c = scene_chain(2, 5, 3, CD_FLOAT64);
    refuses(c, cd_chain_set_stiffness(c, INFINITY), CD_ERROR_VALUE, "stiffness|inf|no rest length: set one first");
    refuses(c, cd_chain_set_rest_length(c, -1), CD_ERROR_VALUE, "length is -1|in [1e-60, 1e+60] or 0");
    ok(cd_chain_set_rest_length(c, 1));
    refuses(c, cd_chain_set_stiffness(c, -1), CD_ERROR_VALUE, "stiffness is -1|in [0, 1e+60] or INFINITY");
    ok(cd_chain_set_stiffness(c, INFINITY));
    cd_chain_destroy(c);
}

static void no_time_is_too_short_for_no_steps(void** state) {
    (void)state;
    refuses_each(chain, cd_chain_step(chain, bad, 0), "dt", not_finite);
    refuses(chain, cd_chain_step(chain, -1, 1), CD_ERROR_VALUE, "dt is -1|0 or in [1e-30, 1e+30]");
}

static void a_bed_is_no_shape_on_a_line(void** state) {
    (void)state;
    cd_chain* line = scene_chain(1, 2, 1, CD_FLOAT64);
    ok(cd_chain_set_rest_length(line, 1));
    ok(cd_chain_set_colliders(line, 1));
    refuses(line, cd_chain_set_bed(line, 0, &(const double){0}, 1, 2, 1, 1, 1, (const double[]){0, 0}, 2, 0),
            CD_ERROR_UNSUPPORTED, "components|1");
    cd_chain_destroy(line);
}

/* Of other components and precision than those of tests/bindings/check_ranges.py. */
static void the_extremes_of_the_header_are_taken(void** state) {
    (void)state;
    cd_chain* c = scene_chain(1, 5, 1, CD_FLOAT32);
    const double most = 1e60, least = -1e60, tiny = 5e-324;
    ok(cd_chain_step(c, 1e-30, 1));
    ok(cd_chain_step(c, 1e30, 1));
    ok(cd_chain_set_rest_length(c, 1));
    ok(cd_chain_set_colliders(c, 4096));
    ok(cd_chain_set_plane(c, 4095, &most, &least, 1, 1e60));
    ok(cd_chain_set_plane(c, 4094, &least, &tiny, 1, 0));
    ok(cd_chain_set_capsule(c, 0, &most, &least, 1, 1e60, 1e60));
    ok(cd_chain_set_capsule(c, 1, &most, &most, 1, 1e-60, 0));
    cd_chain_destroy(c);
}

static void no_more_places_are_sampled_than_fit_in_memory(void** state) {
    (void)state;
    static const size_t most[] = {SIZE_MAX, SIZE_MAX / 2 + 3, SIZE_MAX / 4 + 1};
    const double places[2] = {0.5, 0.5};
    for (size_t i = 0; i < COUNT(most); ++i) /* n * COMPONENTS comes round to 4 in the second */
        refuses(chain, cd_chain_sample(chain, 0, places, most[i], CD_OUTSIDE_REFUSED, out.number, 4), CD_ERROR_RANGE,
                name_and_size("n", most[i]));
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
            refuses(
                chain,
                cd_chain_create(bad[i].strands, bad[i].springs, bad[i].components, precision, &allocator, &out.chain),
                bad[i].status, name_and_size(bad[i].argument, bad[i].shown));
    refuses(chain, cd_chain_create(big, big, 4, CD_FLOAT64, &allocator, &out.chain), CD_ERROR_SIZE,
            name_and_size("springs", big));
    refuses(chain, cd_chain_create(7, SIZE_MAX, 2, CD_FLOAT64, &allocator, &out.chain), CD_ERROR_SIZE,
            "7 strands of |springs with 2 components");
    refuses(chain, cd_chain_create(1, big, 1, CD_FLOAT64, &allocator, &out.chain), CD_ERROR_MEMORY, "");
    refuses(chain, cd_chain_create(big, 1, 1, CD_FLOAT32, &allocator, &out.chain), CD_ERROR_MEMORY, "");
    assert_true(most > big);
    heap_free(&heap);
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

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(only_what_sleeps_needs_seconds),
        cmocka_unit_test(only_ropes_break),
        cmocka_unit_test(only_ropes_in_a_plane_have_rest_angles),
        SURROUNDINGS_TESTS,
        cmocka_unit_test(nothing_moves_that_cannot_be_teleported),
        cmocka_unit_test(only_ropes_are_rigid),
        cmocka_unit_test(no_time_is_too_short_for_no_steps),
        cmocka_unit_test(a_bed_is_no_shape_on_a_line),
        cmocka_unit_test(the_extremes_of_the_header_are_taken),
        cmocka_unit_test(no_more_places_are_sampled_than_fit_in_memory),
        cmocka_unit_test(no_shape_is_made_that_cannot_be),
        cmocka_unit_test(what_the_chain_cannot_do_is_said_to_be_unsupported),
    };
    return cmocka_run_group_tests(tests, set_up, tear_down);
}
