/* What is kept of membranes only: their settings at the ends of their ranges, what cloth takes of the bytes, and what a
 * reset leaves. */
#include <math.h>

#include "cloth.h"
#include "kept.h"

enum { NU = 6, NV = 5, COMPONENTS = 3, NODES = (NU + 1) * (NV + 1), ALL = NODES * COMPONENTS };

static void what_was_saved_can_be_loaded_at_the_ends_of_every_range(void** state) {
    (void)state;
    static const struct {
        double mass, other, tolerance;
        size_t most;
    } totals[] = {{1e-60, 1e60, 1e-14, 1}, {1e60, 1e-60, 0.5, SIZE_MAX}, {1e-60, 0, 0.5, 1}, {1e60, 1e60, 1e-14, 7}};
    for (size_t i = 0; i < COUNT(totals); ++i) {
        for (int32_t ring = 0; ring <= 1; ++ring) {
            cd_membrane* m = cloth(NU, NV, COMPONENTS, CD_FLOAT32);
            const double other = totals[i].other;
            ok(cd_membrane_set_ring(m, ring, 1 - ring));
            ok(cd_membrane_set_mass_rule(m, CD_MASS_HALF_ENDS));
            ok(cd_membrane_set_mass(m, totals[i].mass));
            ok(cd_membrane_set_stiffness(m, other, other));
            ok(cd_membrane_set_bend(m, other));
            ok(cd_membrane_set_drag(m, other));
            ok(cd_membrane_set_stiffness_damping(m, other));
            ok(cd_membrane_set_pressure(m, ring ? other : -other));
            ok(cd_membrane_set_tolerance(m, totals[i].tolerance, totals[i].most));
            ok(cd_membrane_set_edge(m, ring ? CD_EDGE_V_LAST : CD_EDGE_U_FIRST, CD_NODE_MATCHED));
            ok(cd_membrane_attach(m, 3, 2, other, other, NULL, 0));
            for (cd_field field = CD_POSITION; field <= CD_MASK; ++field)
                if (field != CD_STIFFNESS && field != CD_BEND) ok(cd_membrane_enable_field(m, field));
            kept_assert_all(&kept_kinds[MEMBRANE], m, CD_FLOAT32);
            cd_membrane_destroy(m);
        }
    }
}

static void what_is_set_for_cloth_is_kept_at_the_ends_of_every_range(void** state) {
    (void)state;
    static const struct {
        double along_u, along_v, each, shear, compression, along, across, thickness, breaking;
        size_t newton, gradient, colliders;
    } kept[] = {{1e-60, 1e60, 1e-60, 0, 0, 1e60, 0, 1e60, INFINITY, 1, 10000, 0},
                {1e60, 1e-60, 1e60, 1e60, 1e60, 0, 1e60, 0, 1e60, 1000, 1, 4096},
                {1e-60, 1e-60, 0, 5e-324, 5e-324, 5e-324, 0, 5e-324, 1e-60, 1, 1, 1},
                {1e60, 1e60, 0, 0, 5, 0, 0, 0, INFINITY, 2, 14, 2}};
    const double far[3] = {1e60, -1e60, 1e60}, near[3] = {-1e60, 5e-324, -0.0}, wind[3] = {1e30, -1e30, 5e-324};
    for (size_t i = 0; i < COUNT(kept); ++i) {
        cd_membrane* m = cloth(NU, NV, COMPONENTS, CD_FLOAT32);
        ok(cd_membrane_set_ring(m, i % 2, i / 2));
        ok(cd_membrane_set_rest_length(m, kept[i].along_u, kept[i].along_v));
        ok(cd_membrane_set_shear(m, kept[i].shear));
        ok(cd_membrane_set_compression(m, kept[i].compression));
        if (i > 0) ok(cd_membrane_set_sleep(m, i == 1 ? 1e60 : 5e-324, i == 2 ? 1e60 : 1e-30));
        ok(cd_membrane_set_breaking_strain(m, kept[i].breaking));
        ok(cd_membrane_set_effort(m, kept[i].newton, kept[i].gradient));
        ok(cd_membrane_set_air(m, kept[i].along, kept[i].across));
        ok(cd_membrane_set_wind(m, wind, 3));
        ok(cd_membrane_set_thickness(m, kept[i].thickness));
        ok(cd_membrane_set_colliders(m, kept[i].colliders));
        if (i % 2) ok(cd_membrane_set_plane(m, 0, far, near, 3, 1e60));
        if (i % 2) ok(cd_membrane_set_capsule(m, kept[i].colliders - 1, far, near, 3, i == 1 ? 1e60 : 1e-60, 0));
        if (i % 2) ok(cd_membrane_set_collider_velocity(m, 0, near, 3));
        for (cd_field field = CD_WIND; field <= CD_BREAKING_STRAIN_V && kept[i].each > 0; ++field) {
            if (field != CD_WIND && field < CD_REST_LENGTH_U) continue;
            if (field >= CD_TENSION_U && field <= CD_STRAIN_V) continue;
            ok(cd_membrane_enable_field(m, field));
            if (field != CD_WIND) ok(cd_membrane_write_f64(m, field, NU - 1, NV - 1, 1, 1, &kept[i].each, 1));
        }
        kept_assert_all(&kept_kinds[MEMBRANE], m, CD_FLOAT32);
        cd_membrane_destroy(m);
    }
}

/* Membranes that are no cloth, or no longer, are saved as they always were. */
static void cloth_takes_no_bytes_where_there_is_none(void** state) {
    (void)state;
    cd_membrane* m = cloth(NU, NV, COMPONENTS, CD_FLOAT64);
    const uint64_t hash = hash_of(m);
    const size_t before = kind_saved_size(&kinds[MEMBRANE], m), bytes = kind_memory(&kinds[MEMBRANE], m);
    ok(cd_membrane_set_rest_length(m, 2, 3));
    const size_t during = kind_saved_size(&kinds[MEMBRANE], m);
    assert_true(during > before);
    ok(cd_membrane_set_colliders(m, 3));
    assert_int_equal(kind_saved_size(&kinds[MEMBRANE], m), during + 3 * 13 * sizeof(double));
    ok(cd_membrane_set_colliders(m, 0));
    ok(cd_membrane_set_breaking_strain(m, INFINITY)); /* is none */
    assert_int_equal(kind_saved_size(&kinds[MEMBRANE], m), during);
    ok(cd_membrane_set_breaking_strain(m, 1)); /* switches the stiffnesses on too */
    assert_int_equal(kind_saved_size(&kinds[MEMBRANE], m), during + (1 + 2 * NODES) * sizeof(double));
    for (cd_field field = CD_REST_LENGTH_U; field <= CD_BREAKING_STRAIN_V; ++field)
        ok(cd_membrane_enable_field(m, field));
    ok(cd_membrane_enable_field(m, CD_WIND));
    cloth_meet(m);
    ok(cd_membrane_set_shear(m, 1));
    ok(cd_membrane_set_compression(m, 1));
    ok(cd_membrane_set_effort(m, 1, 1));
    ok(cd_membrane_set_air(m, 1, 1));
    ok(cd_membrane_set_rest_length(m, -0.0, 0)); /* is 0 */
    ok(cd_membrane_disable_field(m, CD_STIFFNESS_U)), ok(cd_membrane_disable_field(m, CD_STIFFNESS_V));
    ok(cd_membrane_set_lambda(m, 0.5));
    assert_int_equal(kind_saved_size(&kinds[MEMBRANE], m), before);
    assert_int_equal(kind_memory(&kinds[MEMBRANE], m), bytes);
    assert_int_equal(hash_of(m), hash);
    cd_membrane_destroy(m);
}

static void reset_goes_back_to_the_start(size_t scene) {
    cd_membrane* m = kept_scene(&kept_kinds[MEMBRANE], scene, CD_FLOAT64, CD_METHOD_IMPLICIT);
    cd_membrane* same = kept_scene(&kept_kinds[MEMBRANE], scene, CD_FLOAT64, CD_METHOD_IMPLICIT);
    double x[ALL], y[ALL], time;
    ok(cd_membrane_reset(m));
    ok(cd_membrane_get_time(m, &time));
    assert_true(time == 0);
    for (cd_field field = CD_POSITION; field <= CD_VELOCITY; ++field) {
        cloth_read(m, field, x);
        for (size_t i = 0; i < ALL; ++i) assert_true(x[i] == 0);
        cloth_write(same, field, x); /* the same zeros by hand */
    }
    double length[2];
    ok(cd_membrane_get_rest_length(m, &length[0], &length[1]));
    if (length[0] > 0) ok(cd_membrane_reset(same)); /* where the last step of cloth went no write reaches */
    ok(cd_membrane_step(m, 0.001, 40));
    ok(cd_membrane_step(same, 0.001, 40));
    cloth_read(m, CD_POSITION, x);
    cloth_read(same, CD_POSITION, y);
    assert_same_bits(x, y, ALL);
    cd_membrane_destroy(m);
    cd_membrane_destroy(same);
}

static void reset_goes_back_to_the_start_and_keeps_the_rest(void** state) {
    (void)state;
    for (size_t scene = 0; scene < kept_kinds[MEMBRANE].scenes; ++scene)
        reset_goes_back_to_the_start(scene); /* colliders too go on from where they are */
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_was_saved_can_be_loaded_at_the_ends_of_every_range),
        cmocka_unit_test(what_is_set_for_cloth_is_kept_at_the_ends_of_every_range),
        cmocka_unit_test(cloth_takes_no_bytes_where_there_is_none),
        cmocka_unit_test(reset_goes_back_to_the_start_and_keeps_the_rest),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
