/* The hash sees every parameter, every number of every field and the clock, and nothing else. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "check.h"
#include "jobs.h"
#include "nothing_near.h"
#include "scene.h"

enum { STRANDS = 2, SPRINGS = 9, NODES = SPRINGS + 1, COMPONENTS = 2, ALL = STRANDS * NODES * COMPONENTS };

static cd_chain* everything(cd_precision precision) {
    cd_chain* chain = scene_chain(STRANDS, SPRINGS, COMPONENTS, precision);
    scene_everything(chain);
    return chain;
}

static cd_chain* with_lengths(cd_precision precision) {
    cd_chain* chain = scene_chain(STRANDS, SPRINGS, COMPONENTS, precision);
    scene_lengths(chain);
    return chain;
}

static const double gravity[4][COMPONENTS] = {{1, 0}, {0, 1}, {1, 1}, {-1, 1}};

static void lambda(cd_chain* c) { ok(cd_chain_set_lambda(c, 0.9)); }
static void method_1(cd_chain* c) { ok(cd_chain_set_method(c, CD_METHOD_FORWARD_EULER)); }
static void method_2(cd_chain* c) { ok(cd_chain_set_method(c, CD_METHOD_SYMPLECTIC_EULER)); }
static void method_3(cd_chain* c) { ok(cd_chain_set_method(c, CD_METHOD_STIFF_SECOND)); }
static void mass(cd_chain* c) { ok(cd_chain_set_mass(c, 3)); }
static void mass_rule(cd_chain* c) { ok(cd_chain_set_mass_rule(c, CD_MASS_EQUAL)); }
static void stiffness(cd_chain* c) { ok(cd_chain_set_stiffness(c, 3)); }
static void bend(cd_chain* c) { ok(cd_chain_set_bend(c, 0.005)); }
static void drag(cd_chain* c) { ok(cd_chain_set_drag(c, 0.5)); }
static void damping(cd_chain* c) { ok(cd_chain_set_stiffness_damping(c, 0.002)); }
static void gravity_0(cd_chain* c) { ok(cd_chain_set_gravity(c, gravity[0], COMPONENTS)); }
static void gravity_1(cd_chain* c) { ok(cd_chain_set_gravity(c, gravity[1], COMPONENTS)); }
static void gravity_2(cd_chain* c) { ok(cd_chain_set_gravity(c, gravity[2], COMPONENTS)); }
static void end_free(cd_chain* c) { ok(cd_chain_set_end(c, CD_END_LAST, CD_NODE_FREE)); }
static void end_pinned(cd_chain* c) { ok(cd_chain_set_end(c, CD_END_LAST, CD_NODE_PINNED)); }
static void end_driven(cd_chain* c) { ok(cd_chain_set_end(c, CD_END_LAST, CD_NODE_DRIVEN)); }
static void no_force(cd_chain* c) { ok(cd_chain_disable_field(c, CD_FORCE)); }
static void no_mass(cd_chain* c) { ok(cd_chain_disable_field(c, CD_MASS)); }
static void no_stiffness(cd_chain* c) {
    if (scene_own_strands(c) > 1) ok(cd_chain_disable_field(c, CD_STRENGTH)); /* a rope's */
    ok(cd_chain_disable_field(c, CD_STIFFNESS));
}
static void end_posed(cd_chain* c) { ok(cd_chain_set_end(c, CD_END_LAST, CD_NODE_POSED)); }
static void shifted(cd_chain* c) { ok(cd_chain_teleport(c, 1, NULL, gravity[0], COMPONENTS)); }
static void turned(cd_chain* c) {
    const double turn[4] = {0, 1, -1, 0};
    ok(cd_chain_teleport(c, 1, turn, gravity[0], COMPONENTS));
}
static void no_bend(cd_chain* c) { ok(cd_chain_disable_field(c, CD_BEND)); }
static void no_target(cd_chain* c) { ok(cd_chain_disable_field(c, CD_TARGET)); }
static void attach_stiffness(cd_chain* c) { ok(cd_chain_attach(c, 0, 3, 26, 0.25, NULL, COMPONENTS)); }
static void attach_damping(cd_chain* c) { ok(cd_chain_attach(c, 0, 3, 25, 0.5, NULL, COMPONENTS)); }
static void attach_target(cd_chain* c) { ok(cd_chain_attach(c, 0, 3, 25, 0.25, gravity[0], COMPONENTS)); }
static void attach_another(cd_chain* c) { ok(cd_chain_attach(c, 0, 2, 25, 0.25, NULL, COMPONENTS)); }
static void detach(cd_chain* c) { ok(cd_chain_detach(c, 0, 3)); }
static void impulse(cd_chain* c) { ok(cd_chain_impulse(c, 1, 6, gravity[0], COMPONENTS)); }
static void cut(cd_chain* c) { ok(cd_chain_cut(c, 0, 1)); }
static void weld(cd_chain* c) { ok(cd_chain_weld(c, 0, 5)); }
static void step(cd_chain* c) { ok(cd_chain_step(c, 0.001, 1)); }
static void longer_step(cd_chain* c) { ok(cd_chain_step(c, 0.002, 1)); }
static void two_steps(cd_chain* c) { ok(cd_chain_step(c, 0.001, 2)); }
static void reset(cd_chain* c) { ok(cd_chain_reset(c)); }
static void ring(cd_chain* c) {
    ok(cd_chain_set_end(c, CD_END_LAST, CD_NODE_FREE));
    ok(cd_chain_set_ring(c, 1));
}

static void tolerance(cd_chain* c) { ok(cd_chain_set_tolerance(c, 1e-8, 100)); }
static void most_iterations(cd_chain* c) { ok(cd_chain_set_tolerance(c, 1e-9, 101)); }
static void push(cd_chain* c) { ok(cd_chain_set_push(c, 1)); }
static void may_sleep(cd_chain* c) { ok(cd_chain_set_sleep(c, 1e-9, 1)); }
static void may_sleep_faster(cd_chain* c) { ok(cd_chain_set_sleep(c, 2e-9, 1)); }
static void may_sleep_later(cd_chain* c) { ok(cd_chain_set_sleep(c, 1e-9, 2)); }
static void length(cd_chain* c) { ok(cd_chain_set_rest_length(c, 2)); }
static void rest_angle(cd_chain* c) { ok(cd_chain_set_rest_angle(c, 2)); }
static void rest_angle_back(cd_chain* c) { ok(cd_chain_set_rest_angle(c, -2)); }
static void no_rest_angles(cd_chain* c) { ok(cd_chain_disable_field(c, CD_REST_ANGLE)); }
static void strength(cd_chain* c) { ok(cd_chain_set_strength(c, 1e4)); }
static const double low[COMPONENTS] = {-3, -3}, lower[COMPONENTS] = {-3, -4}, left[COMPONENTS] = {-0.5, 0};
static void thickness(cd_chain* c) { ok(cd_chain_set_thickness(c, 0.005)); }
static void loads(cd_chain* c) { ok(cd_chain_set_loads(c, 1)); }
static void no_colliders(cd_chain* c) { ok(cd_chain_set_colliders(c, 0)); }
static void collider_less(cd_chain* c) { ok(cd_chain_set_colliders(c, 3)); }
static void collider_more(cd_chain* c) { ok(cd_chain_set_colliders(c, 5)); }
static void no_plane(cd_chain* c) { ok(cd_chain_remove_collider(c, 0)); }
static void no_capsule(cd_chain* c) { ok(cd_chain_remove_collider(c, 1)); }
static void plane(cd_chain* c) { ok(cd_chain_set_plane(c, 2, low, gravity[1], COMPONENTS, 0)); }
static void plane_lower(cd_chain* c) { ok(cd_chain_set_plane(c, 2, lower, gravity[1], COMPONENTS, 0)); }
static void plane_turned(cd_chain* c) { ok(cd_chain_set_plane(c, 2, low, gravity[2], COMPONENTS, 0)); }
static void plane_rough(cd_chain* c) { ok(cd_chain_set_plane(c, 2, low, gravity[1], COMPONENTS, 0.5)); }
static void capsule(cd_chain* c) { ok(cd_chain_set_capsule(c, 2, low, left, COMPONENTS, 0.25, 0)); }
static void capsule_back(cd_chain* c) { ok(cd_chain_set_capsule(c, 2, left, low, COMPONENTS, 0.25, 0)); }
static void capsule_longer(cd_chain* c) { ok(cd_chain_set_capsule(c, 2, lower, left, COMPONENTS, 0.25, 0)); }
static void capsule_thicker(cd_chain* c) { ok(cd_chain_set_capsule(c, 2, low, left, COMPONENTS, 0.26, 0)); }
static void capsule_rough(cd_chain* c) { ok(cd_chain_set_capsule(c, 2, low, left, COMPONENTS, 0.25, 0.5)); }
static void sphere(cd_chain* c) { ok(cd_chain_set_capsule(c, 2, low, low, COMPONENTS, 0.25, 0)); }
static const double hills[3] = {0.25, -0.5, 0.125}, valley[3] = {0.25, -0.5, 0.25};
static void bed(cd_chain* c) { ok(cd_chain_set_bed(c, 2, low, COMPONENTS, 3, 1, 0.5, 1, hills, 3, 0)); }
static void bed_higher(cd_chain* c) { ok(cd_chain_set_bed(c, 2, low, COMPONENTS, 3, 1, 0.5, 1, valley, 3, 0)); }
static void bed_shorter(cd_chain* c) { ok(cd_chain_set_bed(c, 2, low, COMPONENTS, 2, 1, 0.5, 1, hills, 2, 0)); }
static void bed_wider(cd_chain* c) { ok(cd_chain_set_bed(c, 2, low, COMPONENTS, 3, 1, 0.75, 1, hills, 3, 0)); }
static void bed_lower(cd_chain* c) { ok(cd_chain_set_bed(c, 2, lower, COMPONENTS, 3, 1, 0.5, 1, hills, 3, 0)); }
static void bed_rough(cd_chain* c) { ok(cd_chain_set_bed(c, 2, low, COMPONENTS, 3, 1, 0.5, 1, hills, 3, 0.5)); }
static void callback(cd_chain* c) { ok(cd_chain_set_callback(c, 2, &nothing_near, low, COMPONENTS, 0)); }
static void callback_lower(cd_chain* c) { ok(cd_chain_set_callback(c, 2, &nothing_near, lower, COMPONENTS, 0)); }
static void callback_rough(cd_chain* c) { ok(cd_chain_set_callback(c, 2, &nothing_near, low, COMPONENTS, 0.5)); }
static void another_plane(cd_chain* c) { ok(cd_chain_set_plane(c, 3, low, gravity[1], COMPONENTS, 0)); }
static void plane_moves(cd_chain* c) { ok(cd_chain_set_collider_velocity(c, 0, gravity[0], COMPONENTS)); }
static void capsule_moves(cd_chain* c) { ok(cd_chain_set_collider_velocity(c, 1, gravity[0], COMPONENTS)); }
static void capsule_falls(cd_chain* c) { ok(cd_chain_set_collider_velocity(c, 1, gravity[1], COMPONENTS)); }
static void capsule_moves_on(cd_chain* c) {
    capsule_moves(c);
    step(c);
}
static void distant_plane_moves_on(cd_chain* c) {
    another_plane(c);
    ok(cd_chain_set_collider_velocity(c, 3, gravity[0], COMPONENTS));
    step(c);
}
static void distant_plane_and_a_step(cd_chain* c) {
    another_plane(c);
    step(c);
}
static void no_strengths(cd_chain* c) { ok(cd_chain_disable_field(c, CD_STRENGTH)); }
static void no_length(cd_chain* c) { /* strands must agree in what they will share */
    ok(cd_chain_disable_field(c, CD_STRENGTH));
    for (cd_field field = CD_MASS; field <= CD_TARGET; ++field)
        if (field != CD_PIN) ok(cd_chain_disable_field(c, field));
    for (size_t i = 0; i < scene_nodes(c); ++i) scene_set(c, CD_PIN, i, CD_NODE_FREE);
    ok(cd_chain_set_rest_length(c, 0));
}
static void pin_in_one_strand(cd_chain* c) {
    const double pin = CD_NODE_PINNED;
    ok(cd_chain_write_f64(c, CD_PIN, 1, 1, 2, 1, &pin, 1));
}
static void mass_in_one_strand(cd_chain* c) {
    const double m = 0.5;
    ok(cd_chain_write_f64(c, CD_MASS, 1, 1, 2, 1, &m, 1));
}
static void cut_in_one_strand(cd_chain* c) { ok(cd_chain_cut(c, 1, 1)); }
static void attach_in_one_strand(cd_chain* c) { ok(cd_chain_attach(c, 1, 2, 25, 0.25, NULL, COMPONENTS)); }
static void no_lengths(cd_chain* c) { ok(cd_chain_disable_field(c, CD_REST_LENGTH)); }
static void air_along(cd_chain* c) { ok(cd_chain_set_air(c, 0.04, 0.8)); }
static void air_across(cd_chain* c) { ok(cd_chain_set_air(c, 0.03, 0.9)); }
static void wind_0(cd_chain* c) {
    const double wind[3] = {1, 0, 0};
    ok(cd_chain_set_wind(c, wind, COMPONENTS));
}
static void wind_last(cd_chain* c) {
    const double wind[3] = {0, 1, 0};
    ok(cd_chain_set_wind(c, wind, COMPONENTS));
}
static void no_winds(cd_chain* c) { ok(cd_chain_disable_field(c, CD_WIND)); }
static void rigid(cd_chain* c) { ok(cd_chain_set_stiffness(c, (double)INFINITY)); }

static void (*const rope_changes[])(cd_chain*) = {may_sleep,
                                                  may_sleep_faster,
                                                  may_sleep_later,
                                                  tolerance,
                                                  most_iterations,
                                                  push,
                                                  length,
                                                  no_length,
                                                  no_lengths,
                                                  rigid,
                                                  lambda,
                                                  method_1,
                                                  mass,
                                                  stiffness,
                                                  bend,
                                                  drag,
                                                  damping,
                                                  no_force,
                                                  no_mass,
                                                  no_stiffness,
                                                  no_target,
                                                  detach,
                                                  impulse,
                                                  cut,
                                                  weld,
                                                  step,
                                                  longer_step,
                                                  two_steps,
                                                  reset,
                                                  air_along,
                                                  air_across,
                                                  wind_0,
                                                  wind_last,
                                                  no_winds,
                                                  pin_in_one_strand,
                                                  mass_in_one_strand,
                                                  cut_in_one_strand,
                                                  attach_in_one_strand,
                                                  strength,
                                                  rest_angle,
                                                  rest_angle_back,
                                                  no_rest_angles,
                                                  no_strengths,
                                                  end_posed,
                                                  shifted,
                                                  turned,
                                                  thickness,
                                                  loads,
                                                  no_colliders,
                                                  collider_less,
                                                  collider_more,
                                                  no_plane,
                                                  no_capsule,
                                                  plane,
                                                  plane_lower,
                                                  plane_turned,
                                                  plane_rough,
                                                  capsule,
                                                  capsule_back,
                                                  capsule_longer,
                                                  capsule_thicker,
                                                  capsule_rough,
                                                  sphere,
                                                  another_plane,
                                                  plane_moves,
                                                  capsule_moves,
                                                  capsule_falls,
                                                  capsule_moves_on,
                                                  distant_plane_moves_on,
                                                  distant_plane_and_a_step,
                                                  bed,
                                                  bed_higher,
                                                  bed_shorter,
                                                  bed_wider,
                                                  bed_lower,
                                                  bed_rough,
                                                  callback,
                                                  callback_lower,
                                                  callback_rough};

static void (*const changes[])(cd_chain*) = {lambda,         method_1,
                                             method_2,       method_3,
                                             mass,           mass_rule,
                                             stiffness,      bend,
                                             drag,           damping,
                                             gravity_0,      gravity_1,
                                             gravity_2,      end_free,
                                             end_pinned,     end_driven,
                                             no_force,       no_mass,
                                             no_stiffness,   no_bend,
                                             no_target,      attach_stiffness,
                                             attach_damping, attach_target,
                                             attach_another, detach,
                                             impulse,        cut,
                                             weld,           step,
                                             longer_step,    two_steps,
                                             reset,          ring,
                                             end_posed,      shifted,
                                             turned};

static void every_change_gives_another_hash(void** state) {
    (void)state;
    for (cd_precision precision = CD_FLOAT32; precision <= CD_FLOAT64; ++precision) {
        uint64_t hashes[COUNT(changes) + 1];
        for (size_t i = 0; i < COUNT(hashes); ++i) {
            cd_chain* chain = everything(precision);
            if (i < COUNT(changes)) changes[i](chain);
            hashes[i] = hash_of(chain);
            for (size_t j = 0; j < i; ++j)
                if (hashes[i] == hashes[j]) fail_msg("changes %zu and %zu give the same hash", i, j);
            cd_chain_destroy(chain);
        }
    }
}

static void every_change_of_a_rope_gives_another_hash(void** state) {
    (void)state;
    uint64_t hashes[COUNT(rope_changes) + 1];
    for (size_t i = 0; i < COUNT(hashes); ++i) {
        cd_chain* chain = with_lengths(CD_FLOAT64);
        if (i < COUNT(rope_changes)) rope_changes[i](chain);
        hashes[i] = hash_of(chain);
        for (size_t j = 0; j < i; ++j)
            if (hashes[i] == hashes[j]) fail_msg("changes %zu and %zu give the same hash", i, j);
        cd_chain_destroy(chain);
    }
}

/* Nor does it matter what a callback computes, or in which order beds were made. */
static void callbacks_and_orders_are_not_in_the_hash(void** state) {
    (void)state;
    int thing;
    const cd_distance other = {&thing, tell_nothing};
    cd_chain *a = with_lengths(CD_FLOAT64), *b = with_lengths(CD_FLOAT64);
    callback(a);
    ok(cd_chain_set_callback(b, 2, &other, low, COMPONENTS, 0));
    assert_int_equal(hash_of(a), hash_of(b));
    bed(a);
    ok(cd_chain_set_bed(a, 0, low, COMPONENTS, 2, 1, 0.5, 1, valley, 2, 0));
    ok(cd_chain_set_bed(b, 0, low, COMPONENTS, 3, 1, 0.5, 1, valley, 3, 0));
    bed(b);
    ok(cd_chain_set_bed(b, 0, low, COMPONENTS, 2, 1, 0.5, 1, valley, 2, 0));
    assert_int_equal(hash_of(a), hash_of(b));
    cd_chain_destroy(a);
    cd_chain_destroy(b);
}

static void every_number_of_every_field_is_in_the_hash(void** state) {
    (void)state;
    for (int k = 0; k < 4; ++k) {
        const cd_precision precision = k % 2;
        cd_chain* chain = k < 2 ? everything(precision) : with_lengths(precision);
        for (size_t node = 0; node < NODES; ++node) scene_set(chain, CD_PIN, node, CD_NODE_FREE); /* all may move */
        no_stiffness(chain);
        ok(cd_chain_enable_field(chain, k < 2 ? CD_STIFFNESS : CD_STRENGTH));
        if (k >= 2) ok(cd_chain_set_strength(chain, 100)); /* numbers to change */
        const uint64_t before = hash_of(chain);
        for (cd_field field = CD_POSITION; field <= (k < 2 ? CD_TARGET : CD_REST_ANGLE); ++field) {
            const int of_others =
                (field > CD_TARGET && field < CD_REST_LENGTH) || (field > CD_STRENGTH && field < CD_REST_ANGLE);
            if ((k >= 2 && field == CD_BEND) || of_others) continue;
            double values[ALL];
            const size_t count = scene_field_count(chain, field);
            scene_read(chain, field, values);
            for (size_t i = 0; i < count; ++i) {
                const double old = values[i];
                values[i] = field == CD_PIN ? CD_NODE_DRIVEN : old * 1.000001 + copysign(1e-6, old);
                scene_write(chain, field, values);
                if (hash_of(chain) == before) fail_msg("number %zu of field %d is not in the hash", i, field);
                values[i] = old;
            }
            scene_write(chain, field, values);
            assert_int_equal(hash_of(chain), before);
        }
        cd_chain_destroy(chain);
    }
}

static void numbers_that_change_places_change_the_hash(void** state) {
    (void)state;
    cd_chain* chain = everything(CD_FLOAT64);
    double x[ALL], v[ALL];
    scene_read(chain, CD_POSITION, x);
    const uint64_t before = hash_of(chain);
    for (size_t i = 1; i < ALL; ++i) {
        double swapped[ALL];
        memcpy(swapped, x, sizeof x);
        swapped[0] = x[i], swapped[i] = x[0];
        scene_write(chain, CD_POSITION, swapped);
        assert_int_not_equal(hash_of(chain), before);
    }
    scene_read(chain, CD_VELOCITY, v);
    scene_write(chain, CD_POSITION, x);
    assert_int_equal(hash_of(chain), before);
    cd_chain_destroy(chain);
}

static void shapes_and_precisions_differ_in_the_hash(void** state) {
    (void)state;
    static const struct {
        size_t strands, springs, components;
        cd_precision precision;
    } shapes[] = {{1, 0, 1, CD_FLOAT32}, {1, 0, 1, CD_FLOAT64}, {2, 0, 1, CD_FLOAT32}, {1, 0, 2, CD_FLOAT32},
                  {1, 1, 1, CD_FLOAT32}, {3, 5, 2, CD_FLOAT32}, {2, 5, 3, CD_FLOAT32}, {6, 5, 1, CD_FLOAT32}};
    uint64_t hashes[COUNT(shapes)];
    for (size_t i = 0; i < COUNT(shapes); ++i) {
        cd_chain* chain = scene_chain(shapes[i].strands, shapes[i].springs, shapes[i].components, shapes[i].precision);
        hashes[i] = hash_of(chain);
        for (size_t j = 0; j < i; ++j) assert_int_not_equal(hashes[i], hashes[j]);
        cd_chain_destroy(chain);
    }
}

static void what_is_not_state_is_not_in_the_hash(void** state) {
    (void)state;
    cd_chain* chain = everything(CD_FLOAT64);
    cd_chain* same = everything(CD_FLOAT64);
    const uint64_t before = hash_of(chain);
    struct jobs jobs = {0};
    const cd_parallel parallel = jobs_reversed(&jobs);
    ok(cd_chain_set_parallel(chain, &parallel));
    ok(cd_chain_set_method(chain, CD_METHOD_STIFF_SECOND));
    ok(cd_chain_set_method(chain, CD_METHOD_IMPLICIT));
    assert_int_equal(hash_of(chain), before);
    /* one refactors at every step, the other does not */
    for (int i = 0; i < 5; ++i) {
        ok(cd_chain_set_drag(chain, 1));
        ok(cd_chain_set_drag(chain, 0.2));
        ok(cd_chain_step(chain, 0.01, 1));
    }
    ok(cd_chain_step(same, 0.01, 5));
    assert_int_equal(hash_of(chain), hash_of(same));
    cd_chain_destroy(chain);
    cd_chain_destroy(same);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_change_gives_another_hash),
        cmocka_unit_test(every_change_of_a_rope_gives_another_hash),
        cmocka_unit_test(callbacks_and_orders_are_not_in_the_hash),
        cmocka_unit_test(every_number_of_every_field_is_in_the_hash),
        cmocka_unit_test(numbers_that_change_places_change_the_hash),
        cmocka_unit_test(shapes_and_precisions_differ_in_the_hash),
        cmocka_unit_test(what_is_not_state_is_not_in_the_hash),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
