/* A membrane's hash sees every parameter, every number of every field and the clock, and nothing else. */
#include <math.h>
#include <string.h>

#include "check.h"
#include "cloth.h"
#include "jobs.h"
#include "sheet.h"

enum { NU = 6, NV = 5, COMPONENTS = 3, ALL = (NU + 1) * (NV + 1) * COMPONENTS };

static cd_membrane* everything(cd_precision precision) {
    cd_membrane* m = cloth(NU, NV, COMPONENTS, precision);
    cloth_everything(m);
    return m;
}

static cd_membrane* with_lengths(cd_precision precision) {
    cd_membrane* m = cloth(NU, NV, COMPONENTS, precision);
    cloth_lengths(m);
    return m;
}

static const double pull[3][COMPONENTS] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};

static void lambda(cd_membrane* m) { ok(cd_membrane_set_lambda(m, 0.9)); }
static void method_1(cd_membrane* m) { ok(cd_membrane_set_method(m, CD_METHOD_FORWARD_EULER)); }
static void method_2(cd_membrane* m) { ok(cd_membrane_set_method(m, CD_METHOD_SYMPLECTIC_EULER)); }
static void method_3(cd_membrane* m) { ok(cd_membrane_set_method(m, CD_METHOD_STIFF_SECOND)); }
static void solver(cd_membrane* m) { ok(cd_membrane_set_solver(m, CD_SOLVER_ALTERNATING)); }
static void tolerance(cd_membrane* m) { ok(cd_membrane_set_tolerance(m, 1e-8, 200)); }
static void most_iterations(cd_membrane* m) { ok(cd_membrane_set_tolerance(m, 1e-9, 201)); }
static void mass(cd_membrane* m) { ok(cd_membrane_set_mass(m, 3)); }
static void mass_rule(cd_membrane* m) { ok(cd_membrane_set_mass_rule(m, CD_MASS_EQUAL)); }
static void along_u(cd_membrane* m) { ok(cd_membrane_set_stiffness(m, 6, 4)); }
static void along_v(cd_membrane* m) { ok(cd_membrane_set_stiffness(m, 5, 6)); }
static void bend(cd_membrane* m) { ok(cd_membrane_set_bend(m, 0.005)); }
static void drag(cd_membrane* m) { ok(cd_membrane_set_drag(m, 0.5)); }
static void damping(cd_membrane* m) { ok(cd_membrane_set_stiffness_damping(m, 0.002)); }
static void pressure(cd_membrane* m) { ok(cd_membrane_set_pressure(m, 2)); }
static void no_pressure(cd_membrane* m) { ok(cd_membrane_set_pressure(m, 0)); }
static void gravity_0(cd_membrane* m) { ok(cd_membrane_set_gravity(m, pull[0], COMPONENTS)); }
static void gravity_1(cd_membrane* m) { ok(cd_membrane_set_gravity(m, pull[1], COMPONENTS)); }
static void gravity_2(cd_membrane* m) { ok(cd_membrane_set_gravity(m, pull[2], COMPONENTS)); }
static void edge_u(cd_membrane* m) { ok(cd_membrane_set_edge(m, CD_EDGE_U_LAST, CD_NODE_FREE)); }
static void edge_v(cd_membrane* m) { ok(cd_membrane_set_edge(m, CD_EDGE_V_LAST, CD_NODE_MATCHED)); }
static void ring_v(cd_membrane* m) { ok(cd_membrane_set_ring(m, 0, 1)); }
static void ring_u(cd_membrane* m) {
    ok(cd_membrane_set_edge(m, CD_EDGE_U_LAST, CD_NODE_FREE));
    ok(cd_membrane_set_ring(m, 1, 0));
}
static void no_force(cd_membrane* m) { ok(cd_membrane_disable_field(m, CD_FORCE)); }
static void no_mass(cd_membrane* m) { ok(cd_membrane_disable_field(m, CD_MASS)); }
static void no_along_u(cd_membrane* m) {
    (void)cd_membrane_disable_field(m, CD_BREAKING_STRAIN_U); /* of cloth */
    ok(cd_membrane_disable_field(m, CD_STIFFNESS_U));
}
static void no_along_v(cd_membrane* m) { ok(cd_membrane_disable_field(m, CD_STIFFNESS_V)); }
static void no_target(cd_membrane* m) { ok(cd_membrane_disable_field(m, CD_TARGET)); }
static void no_pin(cd_membrane* m) { ok(cd_membrane_disable_field(m, CD_PIN)); }
static void no_mask(cd_membrane* m) { ok(cd_membrane_disable_field(m, CD_MASK)); }
static void tie_stiffness(cd_membrane* m) { ok(cd_membrane_attach(m, 3, 2, 26, 0.25, NULL, 0)); }
static void tie_damping(cd_membrane* m) { ok(cd_membrane_attach(m, 3, 2, 25, 0.5, NULL, 0)); }
static void tie_target(cd_membrane* m) { ok(cd_membrane_attach(m, 3, 2, 25, 0.25, pull[0], COMPONENTS)); }
static void tie_another(cd_membrane* m) { ok(cd_membrane_attach(m, 2, 2, 25, 0.25, NULL, 0)); }
static void detach(cd_membrane* m) { ok(cd_membrane_detach(m, 3, 2)); }
static void impulse(cd_membrane* m) { ok(cd_membrane_impulse(m, 3, 3, 0, pull[0], COMPONENTS)); }
static void wide_impulse(cd_membrane* m) { ok(cd_membrane_impulse(m, 3, 3, 2, pull[0], COMPONENTS)); }
static void step(cd_membrane* m) { ok(cd_membrane_step(m, 0.001, 1)); }
static void longer_step(cd_membrane* m) { ok(cd_membrane_step(m, 0.002, 1)); }
static void two_steps(cd_membrane* m) { ok(cd_membrane_step(m, 0.001, 2)); }
static void reset(cd_membrane* m) { ok(cd_membrane_reset(m)); }

static void (*const changes[])(cd_membrane*) = {
    lambda,   method_1,    method_2,     method_3,    solver,      tolerance,  most_iterations,
    mass,     mass_rule,   along_u,      along_v,     bend,        drag,       damping,
    pressure, no_pressure, gravity_0,    gravity_1,   gravity_2,   edge_u,     edge_v,
    ring_v,   ring_u,      no_force,     no_mass,     no_along_u,  no_along_v, no_target,
    no_pin,   no_mask,     tie_damping,  tie_target,  tie_another, detach,     tie_stiffness,
    impulse,  step,        wide_impulse, longer_step, two_steps,   reset};

static void every_change_gives_another_hash(void** state) {
    (void)state;
    for (cd_precision precision = CD_FLOAT32; precision <= CD_FLOAT64; ++precision) {
        uint64_t hashes[COUNT(changes) + 1];
        for (size_t i = 0; i < COUNT(hashes); ++i) {
            cd_membrane* m = everything(precision);
            if (i < COUNT(changes)) changes[i](m);
            hashes[i] = hash_of(m);
            for (size_t j = 0; j < i; ++j)
                if (hashes[i] == hashes[j]) fail_msg("changes %zu and %zu give the same hash", i, j);
            cd_membrane_destroy(m);
        }
    }
}

/* And of cloth. */
static void lambda_1(cd_membrane* m) { ok(cd_membrane_set_lambda(m, 1)); }
static void length_u(cd_membrane* m) { ok(cd_membrane_set_rest_length(m, 0.61, 0.5)); }
static void length_v(cd_membrane* m) { ok(cd_membrane_set_rest_length(m, 0.6, 0.51)); }
static void no_length(cd_membrane* m) { ok(cd_membrane_set_rest_length(m, 0, 0)); }
static void no_length_u(cd_membrane* m) { ok(cd_membrane_disable_field(m, CD_REST_LENGTH_U)); }
static void no_length_v(cd_membrane* m) { ok(cd_membrane_disable_field(m, CD_REST_LENGTH_V)); }
static void may_sleep(cd_membrane* m) { ok(cd_membrane_set_sleep(m, 1e-9, 1)); }
static void may_sleep_faster(cd_membrane* m) { ok(cd_membrane_set_sleep(m, 2e-9, 1)); }
static void may_sleep_later(cd_membrane* m) { ok(cd_membrane_set_sleep(m, 1e-9, 2)); }
static void shear(cd_membrane* m) { ok(cd_membrane_set_shear(m, 151)); }
static void no_shear(cd_membrane* m) { ok(cd_membrane_set_shear(m, 0)); }
static void compression(cd_membrane* m) { ok(cd_membrane_set_compression(m, 7)); }
static void breaking(cd_membrane* m) { ok(cd_membrane_set_breaking_strain(m, 3)); }
static void breaking_later(cd_membrane* m) { ok(cd_membrane_set_breaking_strain(m, 4)); }
static void breaking_u(cd_membrane* m) { sheet_set(m, CD_BREAKING_STRAIN_U, 2, 2, INFINITY); }
static void breaking_v(cd_membrane* m) { sheet_set(m, CD_BREAKING_STRAIN_V, 2, 2, INFINITY); }
static void no_breaking_u(cd_membrane* m) { ok(cd_membrane_disable_field(m, CD_BREAKING_STRAIN_U)); }
static void no_breaking_v(cd_membrane* m) { ok(cd_membrane_disable_field(m, CD_BREAKING_STRAIN_V)); }
static void newton(cd_membrane* m) { ok(cd_membrane_set_effort(m, 4, 11)); }
static void gradient(cd_membrane* m) { ok(cd_membrane_set_effort(m, 3, 12)); }
static void air_along(cd_membrane* m) { ok(cd_membrane_set_air(m, 0.06, 0.75)); }
static void air_across(cd_membrane* m) { ok(cd_membrane_set_air(m, 0.05, 0.8)); }
static void wind_0(cd_membrane* m) { ok(cd_membrane_set_wind(m, pull[0], COMPONENTS)); }
static void wind_2(cd_membrane* m) { ok(cd_membrane_set_wind(m, pull[2], COMPONENTS)); }
static void no_winds(cd_membrane* m) { ok(cd_membrane_disable_field(m, CD_WIND)); }
static void thickness(cd_membrane* m) { ok(cd_membrane_set_thickness(m, 0.02)); }
static void loads(cd_membrane* m) { ok(cd_membrane_set_loads(m, 1)); }
static void no_colliders(cd_membrane* m) { ok(cd_membrane_set_colliders(m, 0)); }
static void collider_less(cd_membrane* m) { ok(cd_membrane_set_colliders(m, 3)); }
static void collider_more(cd_membrane* m) { ok(cd_membrane_set_colliders(m, 5)); }
static void no_plane(cd_membrane* m) { ok(cd_membrane_remove_collider(m, 0)); }
static void plane(cd_membrane* m) { ok(cd_membrane_set_plane(m, 0, pull[0], pull[2], COMPONENTS, 0.5)); }
static void plane_turned(cd_membrane* m) { ok(cd_membrane_set_plane(m, 0, pull[0], pull[1], COMPONENTS, 0.5)); }
static void plane_rough(cd_membrane* m) { ok(cd_membrane_set_plane(m, 0, pull[0], pull[2], COMPONENTS, 0.75)); }
static void capsule(cd_membrane* m) { ok(cd_membrane_set_capsule(m, 2, pull[0], pull[1], COMPONENTS, 0.5, 0)); }
static void capsule_thick(cd_membrane* m) { ok(cd_membrane_set_capsule(m, 2, pull[0], pull[1], COMPONENTS, 0.625, 0)); }
static void capsule_back(cd_membrane* m) { ok(cd_membrane_set_capsule(m, 2, pull[1], pull[0], COMPONENTS, 0.5, 0)); }
static const double hills[6] = {0.25, -0.5, 0.125, 0, 0.25, 0.5};
static void bed(cd_membrane* m) { ok(cd_membrane_set_bed(m, 2, pull[0], 3, 3, 2, 0.5, 1, hills, 6, 0)); }
static void bed_turned(cd_membrane* m) { ok(cd_membrane_set_bed(m, 2, pull[0], 3, 2, 3, 0.5, 1, hills, 6, 0)); }
static void bed_smaller(cd_membrane* m) { ok(cd_membrane_set_bed(m, 2, pull[0], 3, 2, 2, 0.5, 1, hills, 4, 0)); }
static void bed_longer(cd_membrane* m) { ok(cd_membrane_set_bed(m, 2, pull[0], 3, 3, 2, 0.5, 2, hills, 6, 0)); }
static void plane_moves(cd_membrane* m) { ok(cd_membrane_set_collider_velocity(m, 0, pull[0], COMPONENTS)); }
static void ball_moves(cd_membrane* m) { ok(cd_membrane_set_collider_velocity(m, 1, pull[0], COMPONENTS)); }
static void ball_falls(cd_membrane* m) { ok(cd_membrane_set_collider_velocity(m, 1, pull[1], COMPONENTS)); }

static void (*const cloth_changes[])(cd_membrane*) = {may_sleep,
                                                      may_sleep_faster,
                                                      may_sleep_later,
                                                      lambda_1,
                                                      length_u,
                                                      length_v,
                                                      no_length,
                                                      no_length_u,
                                                      no_length_v,
                                                      shear,
                                                      no_shear,
                                                      compression,
                                                      newton,
                                                      gradient,
                                                      air_along,
                                                      air_across,
                                                      wind_0,
                                                      wind_2,
                                                      no_winds,
                                                      thickness,
                                                      loads,
                                                      no_colliders,
                                                      collider_less,
                                                      collider_more,
                                                      no_plane,
                                                      plane,
                                                      plane_turned,
                                                      plane_rough,
                                                      capsule,
                                                      capsule_back,
                                                      capsule_thick,
                                                      plane_moves,
                                                      ball_moves,
                                                      ball_falls,
                                                      mass,
                                                      bend,
                                                      pressure,
                                                      ring_v,
                                                      no_force,
                                                      no_along_u,
                                                      no_pin,
                                                      no_mask,
                                                      tie_stiffness,
                                                      impulse,
                                                      step,
                                                      two_steps,
                                                      reset,
                                                      bed,
                                                      bed_turned,
                                                      bed_smaller,
                                                      bed_longer,
                                                      breaking,
                                                      breaking_u,
                                                      breaking_v,
                                                      breaking_later,
                                                      no_breaking_u,
                                                      no_breaking_v};

static void every_change_of_cloth_gives_another_hash(void** state) {
    (void)state;
    for (cd_precision precision = CD_FLOAT32; precision <= CD_FLOAT64; ++precision) {
        uint64_t hashes[COUNT(cloth_changes) + 1];
        for (size_t i = 0; i < COUNT(hashes); ++i) {
            cd_membrane* m = with_lengths(precision);
            if (i < COUNT(cloth_changes)) cloth_changes[i](m);
            hashes[i] = hash_of(m);
            for (size_t j = 0; j < i; ++j)
                if (hashes[i] == hashes[j]) fail_msg("changes %zu and %zu give the same hash", i, j);
            cd_membrane_destroy(m);
        }
    }
}

static void every_number_of_every_field_is_in_the_hash(void** state) {
    (void)state;
    for (int i = 0; i < 4; ++i) {
        const cd_precision precision = i % 2 ? CD_FLOAT64 : CD_FLOAT32;
        cd_membrane* m = i < 2 ? everything(precision) : with_lengths(precision);
        double free[ALL] = {0}, values[ALL];
        cloth_write(m, CD_PIN, free); /* all may move */
        sheet_set(m, CD_MASK, 1, 3, 1);
        const uint64_t before = hash_of(m);
        for (cd_field field = CD_POSITION; field <= CD_BREAKING_STRAIN_V; ++field) {
            if (field == CD_STIFFNESS || field == CD_BEND || (field > CD_MASK && i < 2)) continue;
            if (field > CD_MASK && field != CD_WIND && field < CD_REST_LENGTH_U) continue;
            if (field >= CD_TENSION_U && field <= CD_STRAIN_V) continue;
            const size_t count = cloth_extent(m, field).count;
            cloth_read(m, field, values);
            for (size_t at = 0; at < count && field != CD_MASK; ++at) {
                const double old = values[at];
                values[at] = field == CD_PIN ? CD_NODE_DRIVEN : old * 1.000001 + 1e-6;
                cloth_write(m, field, values);
                if (hash_of(m) == before) fail_msg("number %zu of field %d is not in the hash", at, field);
                values[at] = old;
            }
            cloth_write(m, field, values);
            assert_int_equal(hash_of(m), before);
        }
        double v[ALL] = {0};
        cloth_write(m, CD_VELOCITY, v);
        const uint64_t at_rest = hash_of(m);
        for (size_t node = 0; node < cloth_extent(m, CD_MASK).count; ++node) { /* an absent node is stopped */
            sheet_set(m, CD_MASK, node % (NU + 1), node / (NU + 1), 0);
            assert_int_not_equal(hash_of(m), at_rest);
            sheet_set(m, CD_MASK, node % (NU + 1), node / (NU + 1), 1);
        }
        assert_int_equal(hash_of(m), at_rest);
        cd_membrane_destroy(m);
    }
}

static void numbers_that_change_places_change_the_hash(void** state) {
    (void)state;
    cd_membrane* m = everything(CD_FLOAT64);
    double x[ALL], swapped[ALL];
    cloth_read(m, CD_POSITION, x);
    const uint64_t before = hash_of(m);
    for (size_t i = 1; i < ALL; ++i) {
        memcpy(swapped, x, sizeof x);
        swapped[0] = x[i], swapped[i] = x[0];
        cloth_write(m, CD_POSITION, swapped);
        assert_int_not_equal(hash_of(m), before);
    }
    cloth_write(m, CD_POSITION, x);
    assert_int_equal(hash_of(m), before);
    cd_membrane_destroy(m);
}

static void shapes_and_precisions_differ_in_the_hash(void** state) {
    (void)state;
    static const struct {
        size_t nu, nv, components;
        cd_precision precision;
    } shapes[] = {{0, 0, 1, CD_FLOAT32}, {0, 0, 1, CD_FLOAT64}, {1, 0, 1, CD_FLOAT32}, {0, 1, 1, CD_FLOAT32},
                  {0, 0, 2, CD_FLOAT32}, {5, 2, 1, CD_FLOAT32}, {2, 5, 1, CD_FLOAT32}, {2, 2, 2, CD_FLOAT32}};
    uint64_t hashes[COUNT(shapes)];
    for (size_t i = 0; i < COUNT(shapes); ++i) {
        cd_membrane* m = cloth(shapes[i].nu, shapes[i].nv, shapes[i].components, shapes[i].precision);
        hashes[i] = hash_of(m);
        for (size_t j = 0; j < i; ++j) assert_int_not_equal(hashes[i], hashes[j]);
        cd_membrane_destroy(m);
    }
}

static void what_is_not_state_is_not_in_the_hash(void** state) {
    (void)state;
    cd_membrane* m = everything(CD_FLOAT64);
    cd_membrane* same = everything(CD_FLOAT64);
    const uint64_t before = hash_of(m);
    struct jobs jobs = {0};
    const cd_parallel parallel = jobs_reversed(&jobs);
    ok(cd_membrane_set_parallel(m, &parallel));
    ok(cd_membrane_set_method(m, CD_METHOD_STIFF_SECOND));
    ok(cd_membrane_set_method(m, CD_METHOD_IMPLICIT));
    ok(cd_membrane_set_solver(m, CD_SOLVER_ALTERNATING));
    ok(cd_membrane_set_solver(m, CD_SOLVER_COUPLED));
    assert_int_equal(hash_of(m), before);
    /* one refactors at every step, the other does not */
    for (int i = 0; i < 5; ++i) {
        ok(cd_membrane_set_drag(m, 1));
        ok(cd_membrane_set_drag(m, 0.2));
        ok(cd_membrane_step(m, 0.01, 1));
    }
    ok(cd_membrane_step(same, 0.01, 5));
    assert_int_equal(hash_of(m), hash_of(same));
    cd_membrane_destroy(m);
    cd_membrane_destroy(same);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_change_gives_another_hash),
        cmocka_unit_test(every_change_of_cloth_gives_another_hash),
        cmocka_unit_test(every_number_of_every_field_is_in_the_hash),
        cmocka_unit_test(numbers_that_change_places_change_the_hash),
        cmocka_unit_test(shapes_and_precisions_differ_in_the_hash),
        cmocka_unit_test(what_is_not_state_is_not_in_the_hash),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
