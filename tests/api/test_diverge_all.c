/* A state that leaves the finite range is reported, with the step; objects of every kind can then be read, reset, kept
 * and used again. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "kept.h"
#include "unstable.h"

static void assert_told(const struct kind* kind, uint64_t first_bad) {
    const char *message = cd_error_message(), *start = text_of("cd_%s_step: ", kind->name);
    const char* const step = text_of(" %llu", (unsigned long long)first_bad);
    if (strncmp(message, start, strlen(start)) != 0 || !strstr(message, step))
        fail_msg("\"%s\" does not start with \"%s\" and hold%s", message, start, step);
}

static uint64_t steps_of(const struct kind* kind, const any* object) {
    uint64_t steps;
    ok(kind->get_steps(object, &steps));
    return steps;
}

static void divergence_is_reported_with_the_first_bad_step(void** state) {
    (void)state;
    FOR_UNSTABLE(u, i) {
        const struct kind* const kind = u->kind;
        const size_t early = u->good ? 0 : 5, many = u->stays ? 5000 : 1000;
        double dt, small, time;
        any* slow = unstable_new(u, i, &dt, &small);
        uint64_t first_bad = u->good;
        while (kind_is_finite(kind, slow)) {
            const cd_status status = kind->step(slow, dt, 1);
            ++first_bad;
            assert_true(first_bad < 5000 && (status == CD_OK || status == CD_ERROR_DIVERGED));
            if ((status == CD_OK) != kind_is_finite(kind, slow))
                fail_msg("%s %zu: step %d gives %s", kind->name, i, (int)first_bad, cd_status_name(status));
        }
        assert_true(first_bad > u->least);
        assert_told(kind, first_bad);
        assert_int_equal(steps_of(kind, slow), first_bad);
        kind->destroy(slow);

        any* fast = unstable_new(u, i, &dt, &small);
        ok(kind->step(fast, dt, early));
        assert_int_equal(kind->step(fast, dt, many), CD_ERROR_DIVERGED);
        assert_told(kind, first_bad);                /* counted from create, not from this call */
        const uint64_t all = u->good + early + many; /* are made */
        assert_int_equal(steps_of(kind, fast), all);
        ok(kind->get_time(fast, &time));
        assert_near(time, dt * (double)all, 1e-12, 0);
        if (u->stays) assert_false(kind_is_finite(kind, fast));
        kind->destroy(fast);
    }
}

static void a_diverged_object_makes_no_step_and_changes_nothing(void** state) {
    (void)state;
    FOR_UNSTABLE(u, i) {
        double dt, small;
        any* object = unstable_diverged(u, i, &dt, &small);
        const uint64_t steps = steps_of(u->kind, object);
        kind_refuses(u->kind, object, step, (object, dt, 1), CD_ERROR_DIVERGED, "");
        ok(u->kind->set_method(object, CD_METHOD_IMPLICIT));
        kind_refuses(u->kind, object, step, (object, dt, 1), CD_ERROR_DIVERGED, "");
        ok(u->kind->step(object, dt, 0));
        assert_int_equal(steps_of(u->kind, object), steps);
        u->kind->destroy(object);
    }
}

static void a_diverged_object_is_as_new_after_a_reset(void** state) {
    (void)state;
    FOR_UNSTABLE(u, i) {
        double dt, small;
        any* both[2] = {unstable_diverged(u, i, &dt, &small), unstable_new(u, i, &dt, &small)};
        for (int k = 0; k < 2; ++k) ok(u->kind->reset(both[k]));
        kind_assert_same(u->kind, both[0], both[1]);
        for (int k = 0; k < 2; ++k) {
            unstable_lay_out(u, both[k]);
            ok(u->kind->step(both[k], small, 20));
        }
        kind_assert_same(u->kind, both[0], both[1]);
        for (int k = 0; k < 2; ++k) u->kind->destroy(both[k]);
    }
}

static void set_drag(const struct kind* kind, any* object, double drag) {
    if (kind == &kinds[CHAIN]) ok(cd_chain_set_drag(object, drag));
    if (kind == &kinds[MEMBRANE]) ok(cd_membrane_set_drag(object, drag));
    if (kind == &kinds[WATER]) ok(cd_water_set_drag(object, drag));
}

/* And makes a water's account right again. */
static void write_state(const struct kind* kind, any* object, double value) {
    double values[20 * 10 * 2];
    const size_t count = kind_numbers(kind, object, kind->state);
    assert_true(count <= COUNT(values));
    for (size_t k = 0; k < count; ++k) values[k] = value;
    ok(kind->write(object, kind->state, values, count));
}

static void goes_on_once_finite_numbers_are_written(const struct unstable* u, size_t i, double drag) {
    static const cd_method methods[] = {CD_METHOD_SYMPLECTIC_EULER, CD_METHOD_IMPLICIT};
    const struct kind* const kind = u->kind;
    double dt, small, x[2][20 * 10 * 2], error;
    any* both[2] = {unstable_diverged(u, i, &dt, &small), unstable_new(u, i, &dt, &small)};
    for (int k = 0; k < 2; ++k) set_drag(kind, both[k], drag);
    any* const object = both[0];
    write_state(kind, object, 1);
    if (u->stays) kind_refuses(kind, object, step, (object, dt, 1), CD_ERROR_DIVERGED, ""); /* for its velocities */
    unstable_lay_out(u, object);
    write_state(kind, object, 1);
    ok(kind->step(object, u->stays ? dt : small, 3));
    assert_true(kind_is_finite(kind, object));
    if (kind == &kinds[WATER]) {
        ok(cd_water_get_account(object, NULL, NULL, NULL, &error));
        assert_true(fabs(error) < 1e-5);
    }
    for (size_t way = 0; way < COUNT(methods); ++way) { /* and like one that never was */
        const size_t count = kind_numbers(kind, object, kind->state);
        for (int k = 0; k < 2; ++k) {
            unstable_lay_out(u, both[k]);
            ok(kind->set_method(both[k], methods[way]));
            ok(kind->step(both[k], small, 20));
            ok(kind->read(both[k], kind->state, x[k], count));
        }
        assert_same_bits(x[0], x[1], count);
    }
    for (int k = 0; k < 2; ++k) kind->destroy(both[k]);
}

static void a_diverged_object_goes_on_once_finite_numbers_are_written(void** state) {
    (void)state;
    FOR_UNSTABLE(u, i)
    for (int drags = 0; drags < 2; ++drags) goes_on_once_finite_numbers_are_written(u, i, drags ? 0.1 : 0);
}

static void a_diverged_state_can_be_kept_and_stays_diverged_until_another_is_loaded(void** state) {
    (void)state;
    FOR_UNSTABLE(u, i)
    for (int by_copy = 0; by_copy < 2; ++by_copy) {
        const struct kind* const kind = u->kind;
        double dt, small;
        any* both[2] = {unstable_diverged(u, i, &dt, &small), unstable_new(u, i, &dt, &small)};
        any* good = unstable_new(u, i, &dt, &small);
        kind_take(kind, both[1], both[0], by_copy);
        assert_int_equal(kind_hash(kind, both[1]), kind_hash(kind, both[0])); /* signs of NaN are not kept */
        kind_refuses(kind, both[1], step, (both[1], dt, 1), CD_ERROR_DIVERGED, "");
        unstable_calm(u, good);
        ok(kind->step(good, small, 7));
        for (int k = 0; k < 2; ++k) {
            kind_take(kind, both[k], good, by_copy);
            ok(kind->step(both[k], small, 20));
        }
        ok(kind->step(good, small, 20));
        for (int k = 0; k < 2; ++k) {
            kind_assert_same(kind, both[k], good);
            kind->destroy(both[k]);
        }
        kind->destroy(good);
    }
}

static void what_acts_on_a_diverged_object_says_that_its_state_is_not_finite(void** state) {
    (void)state;
    static const double push[2] = {1, 1};
    static const char why[] = "the state after step|is not finite";
    FOR_UNSTABLE(u, i) {
        double dt, small;
        any* object = unstable_diverged(u, i, &dt, &small);
        if (kind_is_finite(u->kind, object)) {
            u->kind->destroy(object);
            continue;
        }
        if (u->kind == &kinds[CHAIN])
            refuses((cd_chain*)object, cd_chain_impulse(object, 10, 4, push, 2), CD_ERROR_DIVERGED, why);
        else if (u->kind == &kinds[MEMBRANE])
            refuses((cd_membrane*)object, cd_membrane_impulse(object, 3, 2, 1, push, 2), CD_ERROR_DIVERGED, why);
        else {
            cd_water* const w = object;
            refuses(w, cd_water_impulse(w, 4.5, 3.5, 1, 1, 1), CD_ERROR_DIVERGED, why);
            refuses(w, cd_water_splash(w, 4.5, 3.5, 1, 0.1), CD_ERROR_DIVERGED, why);
            refuses(w, cd_water_add_volume(w, 4.5, 3.5, 1, 1, NULL), CD_ERROR_DIVERGED, why);
            refuses(w, cd_water_add_volume_rectangle(w, 0, 0, 9, 6, 1, NULL), CD_ERROR_DIVERGED, why);
        }
        u->kind->destroy(object);
    }
}

static void an_object_within_the_limit_never_diverges(void** state) {
    (void)state;
    FOR_UNSTABLE(u, i) {
        if (!u->stays || u->list[i].method != CD_METHOD_SYMPLECTIC_EULER) continue;
        const bool sheet = u->kind == &kinds[MEMBRANE];
        double dt, small;
        any* object = unstable_new(u, i, &dt, &small);
        ok(u->kind->step(object, dt * 0.499, 20000));
        ok(u->kind->set_method(object, CD_METHOD_IMPLICIT));
        ok(u->kind->step(object, dt * 1e6, sheet ? 2000 : 20000));
        assert_true(kind_is_finite(u->kind, object));
        if (sheet) {
            ok(cd_membrane_set_solver(object, CD_SOLVER_COUPLED));
            ok(u->kind->step(object, dt * 1e6, 100));
            assert_true(kind_is_finite(u->kind, object));
        }
        u->kind->destroy(object);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(divergence_is_reported_with_the_first_bad_step),
        cmocka_unit_test(a_diverged_object_makes_no_step_and_changes_nothing),
        cmocka_unit_test(a_diverged_object_is_as_new_after_a_reset),
        cmocka_unit_test(a_diverged_object_goes_on_once_finite_numbers_are_written),
        cmocka_unit_test(a_diverged_state_can_be_kept_and_stays_diverged_until_another_is_loaded),
        cmocka_unit_test(what_acts_on_a_diverged_object_says_that_its_state_is_not_finite),
        cmocka_unit_test(an_object_within_the_limit_never_diverges),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
