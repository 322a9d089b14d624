/* What sleeps beside colliders: it wakes before one that moves could touch it, and no sooner. */
#include "sleepers.h"

/* Of ropes and of cloth. */
static any* with_colliders(const struct body* body, size_t count) {
    any* const x = body->make(CD_FLOAT64);
    ok(body->kind == CHAIN ? cd_chain_set_colliders(x, count) : cd_membrane_set_colliders(x, count));
    return x;
}
static void set_plane(const struct body* body, any* x, const double* point, const double* normal) {
    ok(body->kind == CHAIN ? cd_chain_set_plane(x, 1, point, normal, 3, 0)
                           : cd_membrane_set_plane(x, 1, point, normal, 3, 0));
}
static void set_velocity(const struct body* body, any* x, size_t index, const double* velocity) {
    ok(body->kind == CHAIN ? cd_chain_set_collider_velocity(x, index, velocity, 3)
                           : cd_membrane_set_collider_velocity(x, index, velocity, 3));
}

static double place_of(const struct body* body, const any* x, size_t index) { /* its height */
    double first[3], second[3], v[3], radius, friction;
    cd_shape shape;
    ok(body->kind == CHAIN ? cd_chain_get_collider(x, index, &shape, first, second, v, 3, &radius, &friction)
                           : cd_membrane_get_collider(x, index, &shape, first, second, v, 3, &radius, &friction));
    return first[1];
}
static double lowest(const struct body* body, const any* x) {
    double positions[MOST], least = INFINITY;
    read_all(body, x, CD_POSITION, positions);
    for (size_t i = 1; i < kind_numbers(&kinds[body->kind], x, CD_POSITION); i += 3) least = fmin(least, positions[i]);
    return least;
}

/* Those that move here are beyond any part's reach, but no one can tell where they are. */
static void callbacks_and_beds_that_move_keep_awake(void** state) {
    (void)state;
    const double far[3] = {0, -50, -60}, creeps[3] = {0, 1e-9, 0}, flat[4] = {0, 0, 0, 0};
    for (size_t b = ROPES; b <= CLOTH; b += CLOTH - ROPES)
        for (int is_bed = 0; is_bed <= 1; ++is_bed) {
            const struct body* const body = &bodies[b];
            any* const x = with_colliders(body, 2);
            ok(set_sleep(body, x, speed, seconds));
            rest(body, x); /* so that it would sleep again soon */
            if (is_bed) {
                ok(b == ROPES ? cd_chain_set_bed(x, 1, far, 3, 2, 2, 1, 1, flat, 4, 0)
                              : cd_membrane_set_bed(x, 1, far, 3, 2, 2, 1, 1, flat, 4, 0));
                rest(body, x); /* beside one that stands */
                set_velocity(body, x, 1, creeps);
            } else {
                ok(b == ROPES ? cd_chain_set_callback(x, 1, &answer, far, 3, 0)
                              : cd_membrane_set_callback(x, 1, &answer, far, 3, 0));
            }
            for (int i = 0; i < 200; ++i) {
                step(body, x, 1);
                assert_int_equal(awake(body, x), body->parts * body->nodes);
            }
            ok(b == ROPES ? cd_chain_remove_collider(x, 1) : cd_membrane_remove_collider(x, 1));
            assert_true(rest(body, x) > 0);
            kinds[body->kind].destroy(x);
        }
}

/* A plane rises from far below. What sleeps does so until the next step could touch it, and none is run through; and
 * one that is none, but would move, wakes nobody. */
static void what_comes_near_wakes_before_it_touches(void** state) {
    (void)state;
    const double below[3] = {0, -3, 0}, up[3] = {0, 1, 0}, rises[3] = {0, 1.5, 0}, aside[3] = {0.125, 0, 0};
    const double thick = 0.0625;
    for (size_t b = ROPES; b <= CLOTH; b += CLOTH - ROPES)
        for (size_t calls = 1; calls <= 4; calls += 3) {
            const struct body* const body = &bodies[b];
            any* const x = with_colliders(body, 2);
            set_velocity(body, x, 0, aside);
            ok(body->kind == CHAIN ? cd_chain_set_thickness(x, thick) : cd_membrane_set_thickness(x, thick));
            ok(set_sleep(body, x, speed, seconds));
            rest(body, x);
            set_plane(body, x, below, up);
            set_velocity(body, x, 1, rises);
            rest(body, x);
            const double still = lowest(body, x);
            size_t slept = 0;
            for (; awake(body, x) == 0 && slept < 4000; slept += calls) step(body, x, calls);
            assert_true(slept > 20);
            const double gap = still - place_of(body, x, 1) - thick, next = rises[1] * dt * (1 + 1e-9);
            assert_true(gap < next && gap > next - rises[1] * dt * (double)calls - 1e-9);
            for (size_t i = 0; i < 16; i += calls) { /* it is not yet at what is held */
                step(body, x, calls);
                assert_true(lowest(body, x) > place_of(body, x, 1) - 0.01);
            }
            assert_true(awake(body, x) > 0);
            kinds[body->kind].destroy(x);
        }
}

/* A bar that rises across ropes, which hang one above the other, wakes one after the other; one that rises beside them,
 * in line with them but out of reach, wakes none. */
static void a_bar_wakes_strands_one_by_one(void** state) {
    (void)state;
    const double from[3] = {-3, -2, 0}, to[3] = {-0.05, -2, 0}, rises[3] = {0, 0.25, 0};
    const double beside[3] = {5, -1, 0}, end[3] = {6, -1, 0};
    for (size_t calls = 1; calls <= 8; calls += 7) {
        const struct body* const body = &bodies[ROPES];
        any *const x = with_colliders(body, 2), *const never = with_colliders(body, 2);
        ok(set_sleep(body, x, speed, seconds));
        rest(body, x);
        ok(cd_chain_set_capsule(x, 0, from, to, 3, 0.1, 0)), ok(cd_chain_set_collider_velocity(x, 0, rises, 3));
        ok(cd_chain_set_capsule(x, 1, beside, end, 3, 0.1, 0)), ok(cd_chain_set_collider_velocity(x, 1, rises, 3));
        ok(cd_chain_copy_state(never, x));
        ok(set_sleep(body, never, 0, 0));
        size_t most = 0, woken = 0;
        for (int i = 0; i < 2048; i += (int)calls) {
            const size_t before = awake(body, x);
            step(body, x, calls), step(body, never, calls);
            if (i < 48) continue; /* all were awake when it was set */
            most = awake(body, x) > most ? awake(body, x) : most;
            woken += awake(body, x) > before;
        }
        assert_int_equal(woken, STRANDS);
        assert_true(most <= 3 * NODES);
        assert_int_equal(awake(body, x), 0);
        double here[MOST], there[MOST];
        read_all(body, x, CD_POSITION, here), read_all(body, never, CD_POSITION, there);
        for (size_t i = 0; i < 3 * STRANDS * NODES; ++i) assert_true(fabs(here[i] - there[i]) < 1e-3);
        kinds[CHAIN].destroy(x), kinds[CHAIN].destroy(never);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(callbacks_and_beds_that_move_keep_awake),
        cmocka_unit_test(what_comes_near_wakes_before_it_touches),
        cmocka_unit_test(a_bar_wakes_strands_one_by_one),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
