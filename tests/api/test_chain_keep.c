/* What is kept of chains only: their settings at the ends of their ranges, and what ropes take of the bytes. */
#include <math.h>

#include "kept.h"
#include "scene.h"

enum { STRANDS = 2, SPRINGS = 12, COMPONENTS = 3 };

static void what_was_saved_can_be_loaded_at_the_ends_of_every_range(void** state) {
    (void)state;
    static const struct { double mass, other; } totals[] = {{1e-60, 1e60}, {1e60, 1e-60}, {1e-60, 0}, {1e60, 1e60}};
    for (size_t i = 0; i < COUNT(totals); ++i) {
        for (int32_t ring = 0; ring <= 1; ++ring) {
            cd_chain* chain = scene_chain(STRANDS, SPRINGS, COMPONENTS, CD_FLOAT32);
            ok(cd_chain_set_ring(chain, ring));
            ok(cd_chain_set_mass_rule(chain, CD_MASS_HALF_ENDS));
            ok(cd_chain_set_mass(chain, totals[i].mass));
            ok(cd_chain_set_stiffness(chain, totals[i].other));
            ok(cd_chain_set_bend(chain, totals[i].other));
            ok(cd_chain_set_drag(chain, totals[i].other));
            ok(cd_chain_set_stiffness_damping(chain, totals[i].other));
            ok(cd_chain_attach(chain, 0, 3, totals[i].other, totals[i].other, NULL, 0));
            for (cd_field field = CD_POSITION; field <= CD_TARGET; ++field) ok(cd_chain_enable_field(chain, field));
            kept_assert_all(&kept_kinds[CHAIN], chain, CD_FLOAT32);
            cd_chain_destroy(chain);
        }
    }
}

/* Whether springs have a length, or had: what is set for those that have it is kept all the same. */
static void what_is_set_for_ropes_is_kept_at_the_ends_of_every_range(void** state) {
    (void)state;
    static const struct {
        double length, stiffness, tolerance, each, tension;
        size_t most_iterations;
        int32_t push;
    } ropes[] = {{0, 3, 1e-14, 0, 0, 1, 1},
                 {0, 1e60, 0.5, 0, 0, 10000, 0},
                 {1e-60, 1e-60, 1e-6, 0, 1e60, 200, 0},
                 {1e60, 0, 1e-14, 1e60, -1e60, 10000, 1},
                 {1e60, INFINITY, 0.5, 1e-60, 1e-60, 1, 0}};
    for (size_t i = 0; i < COUNT(ropes); ++i) {
        cd_chain* chain = scene_chain(STRANDS, SPRINGS, COMPONENTS, CD_FLOAT32);
        ok(cd_chain_set_rest_length(chain, ropes[i].length));
        ok(cd_chain_set_stiffness(chain, ropes[i].stiffness));
        ok(cd_chain_set_tolerance(chain, ropes[i].tolerance, ropes[i].most_iterations));
        ok(cd_chain_set_push(chain, ropes[i].push));
        if (i > 0) ok(cd_chain_set_sleep(chain, i == 1 ? 1e60 : 5e-324, i == 2 ? 1e60 : 1e-30));
        if (ropes[i].each > 0) {
            ok(cd_chain_enable_field(chain, CD_REST_LENGTH));
            scene_set(chain, CD_REST_LENGTH, SPRINGS - 1, ropes[i].each);
        }
        if (ropes[i].length > 0) {
            const double wind[COMPONENTS] = {1e30, -1e30};
            scene_set(chain, CD_TENSION, SPRINGS - 1, ropes[i].tension);
            ok(cd_chain_set_air(chain, i == 3 ? 1e60 : 0, i == 4 ? 1e60 : 1e-300));
            ok(cd_chain_set_wind(chain, wind, COMPONENTS));
            if (i != 3) ok(cd_chain_enable_field(chain, CD_WIND));
            if (i != 4) ok(cd_chain_set_strength(chain, i == 3 ? 1e-60 : 1e60));
            if (i == 4) ok(cd_chain_enable_field(chain, CD_STRENGTH));
            const double far[COMPONENTS] = {1e60, -1e60, 1e60}, near[COMPONENTS] = {-1e60, 5e-324, -0.0};
            if (i != 2) ok(cd_chain_set_thickness(chain, i == 3 ? 1e60 : 5e-324));
            if (i != 3) ok(cd_chain_set_colliders(chain, 4096)); /* and thickness without any in this */
            if (i != 3) ok(cd_chain_set_plane(chain, 7, far, near, COMPONENTS, 1e60));
            if (i != 3) ok(cd_chain_set_capsule(chain, 4095, far, near, COMPONENTS, i == 2 ? 1e60 : 1e-60, 0));
            if (i != 3) ok(cd_chain_set_collider_velocity(chain, 4095, near, COMPONENTS));
        }
        kept_assert_all(&kept_kinds[CHAIN], chain, CD_FLOAT32);
        cd_chain_destroy(chain);
    }
}

static void rest_angles_are_kept_at_the_ends_of_their_range(void** state) {
    (void)state;
    enum { JOINTS = 13 };
    struct kept_kind in_a_plane = kept_kinds[CHAIN];
    in_a_plane.shape[0] = STRANDS, in_a_plane.shape[1] = JOINTS + 1, in_a_plane.shape[2] = 2;
    for (int k = 0; k < 6; ++k) {
        cd_chain* chain = scene_chain(STRANDS, JOINTS + 1, 2, k % 2 ? CD_FLOAT64 : CD_FLOAT32);
        ok(cd_chain_set_rest_length(chain, 1));
        ok(cd_chain_set_bend(chain, 1));
        ok(cd_chain_set_rest_angle(chain, (k / 2 == 1 ? -1 : 1) * JOINTS * 3.141592653589793));
        if (k > 1) ok(cd_chain_enable_field(chain, CD_REST_ANGLE));
        if (k > 3) ok(cd_chain_set_rest_angle(chain, 0)); /* of each node alone */
        if (k > 3) scene_set(chain, CD_REST_ANGLE, 3, 5e-324);
        kept_assert_all(&in_a_plane, chain, k % 2 ? CD_FLOAT64 : CD_FLOAT32);
        cd_chain_destroy(chain);
    }
}

/* Chains that never were ropes are saved as they always were: what is set for ropes takes no bytes until it is. */
static void what_is_as_in_a_new_chain_takes_no_bytes(void** state) {
    (void)state;
    cd_chain* chain = scene_chain(STRANDS, SPRINGS, COMPONENTS, CD_FLOAT64);
    const uint64_t hash = hash_of(chain);
    const size_t before = kind_saved_size(&kinds[CHAIN], chain);
    ok(cd_chain_set_sleep(chain, 1, 2));
    assert_true(kind_saved_size(&kinds[CHAIN], chain) == before + 3 * sizeof(double)); /* and how calm it is */
    ok(cd_chain_set_sleep(chain, 0, 2));
    assert_int_equal(kind_saved_size(&kinds[CHAIN], chain), before);
    ok(cd_chain_set_rest_length(chain, 2));
    const size_t during = kind_saved_size(&kinds[CHAIN], chain);
    assert_true(during >= before + STRANDS * SPRINGS * sizeof(double));
    ok(cd_chain_set_air(chain, 0, -0.0)); /* is none */
    assert_int_equal(kind_saved_size(&kinds[CHAIN], chain), during);
    ok(cd_chain_set_air(chain, 0, 1));
    assert_true(kind_saved_size(&kinds[CHAIN], chain) > during);
    ok(cd_chain_set_strength(chain, INFINITY)); /* is none */
    ok(cd_chain_set_air(chain, 0, 0));
    assert_int_equal(kind_saved_size(&kinds[CHAIN], chain), during);
    ok(cd_chain_set_strength(chain, 1));
    ok(cd_chain_disable_field(chain, CD_REST_LENGTH)); /* is off */
    const size_t until_then = kind_saved_size(&kinds[CHAIN], chain);
    assert_true(until_then > during);
    ok(cd_chain_set_thickness(chain, -0.0)); /* is none */
    ok(cd_chain_set_colliders(chain, 3));
    assert_true(kind_saved_size(&kinds[CHAIN], chain) > until_then);
    ok(cd_chain_set_colliders(chain, 0));
    assert_int_equal(kind_saved_size(&kinds[CHAIN], chain), until_then);
    ok(cd_chain_set_thickness(chain, 0.5));
    assert_true(kind_saved_size(&kinds[CHAIN], chain) > until_then);
    ok(cd_chain_set_colliders(chain, 2));
    ok(cd_chain_set_rest_length(chain, -0.0)); /* is 0 */
    ok(cd_chain_disable_field(chain, CD_STIFFNESS));
    assert_int_equal(kind_saved_size(&kinds[CHAIN], chain), before);
    assert_int_equal(hash_of(chain), hash);
    ok(cd_chain_set_push(chain, 1));
    const uint64_t pushes = hash_of(chain);
    kind_take(&kinds[CHAIN], chain, chain, 0);
    assert_int_equal(hash_of(chain), pushes);
    cd_chain* other = scene_chain(STRANDS, SPRINGS, COMPONENTS, CD_FLOAT64);
    ok(cd_chain_set_push(other, 1));
    assert_int_equal(hash_of(other), pushes);
    cd_chain_destroy(chain);
    cd_chain_destroy(other);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_was_saved_can_be_loaded_at_the_ends_of_every_range),
        cmocka_unit_test(what_is_set_for_ropes_is_kept_at_the_ends_of_every_range),
        cmocka_unit_test(rest_angles_are_kept_at_the_ends_of_their_range),
        cmocka_unit_test(what_is_as_in_a_new_chain_takes_no_bytes),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
