/* A sheet that leaves the finite range is reported with the step, and one whose solves end short of their tolerance
 * with what is left; both can be read, and used again. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "check.h"
#include "cloth.h"
#include "kernels.h"

enum { NU = 6, NV = 5, COMPONENTS = 2, ALL = (NU + 1) * (NV + 1) * COMPONENTS };

/* An explicit sheet beyond its limit. */
static cd_membrane* unstable(cd_precision precision, cd_method method, double* out_dt) {
    cd_membrane* m = cloth(NU, NV, COMPONENTS, precision);
    ok(cd_membrane_set_method(m, method));
    const double v[COMPONENTS] = {1, -1};
    ok(cd_membrane_write_f64(m, CD_VELOCITY, 3, 2, 1, 1, v, COMPONENTS));
    ok(cd_membrane_stable_dt(m, out_dt));
    *out_dt *= 2;
    return m;
}

static int is_finite(const cd_membrane* m) {
    double x[ALL], v[ALL];
    cloth_read(m, CD_POSITION, x);
    cloth_read(m, CD_VELOCITY, v);
    for (size_t i = 0; i < ALL; ++i)
        if (!isfinite(x[i]) || !isfinite(v[i])) return 0;
    return 1;
}

static const struct {
    cd_precision precision;
    cd_method method;
} cases[] = {{CD_FLOAT32, CD_METHOD_SYMPLECTIC_EULER},
             {CD_FLOAT64, CD_METHOD_SYMPLECTIC_EULER},
             {CD_FLOAT32, CD_METHOD_FORWARD_EULER},
             {CD_FLOAT64, CD_METHOD_FORWARD_EULER}};

static void divergence_is_reported_with_the_first_bad_step(void** state) {
    (void)state;
    for (size_t i = 0; i < COUNT(cases); ++i) {
        double dt;
        cd_membrane* slow = unstable(cases[i].precision, cases[i].method, &dt);
        uint64_t first_bad = 0, steps;
        while (is_finite(slow)) {
            const cd_status status = cd_membrane_step(slow, dt, 1);
            ++first_bad;
            assert_int_equal(status, is_finite(slow) ? CD_OK : CD_ERROR_DIVERGED);
        }
        assert_true(first_bad > 10);
        assert_non_null(strstr(cd_error_message(), text_of(" %llu", (unsigned long long)first_bad)));
        cd_membrane_destroy(slow);

        cd_membrane* fast = unstable(cases[i].precision, cases[i].method, &dt);
        ok(cd_membrane_step(fast, dt, 5));
        assert_int_equal(cd_membrane_step(fast, dt, 5000), CD_ERROR_DIVERGED);
        assert_non_null(strstr(cd_error_message(), "cd_membrane_step: "));
        /* counted from create, not from this call */
        assert_non_null(strstr(cd_error_message(), text_of(" %llu", (unsigned long long)first_bad)));
        ok(cd_membrane_get_steps(fast, &steps));
        assert_int_equal(steps, 5005); /* all steps are made */
        assert_false(is_finite(fast));
        cd_membrane_destroy(fast);
    }
}

static void a_diverged_membrane_makes_no_step_and_changes_nothing(void** state) {
    (void)state;
    for (size_t i = 0; i < COUNT(cases); ++i) {
        double dt;
        cd_membrane* m = unstable(cases[i].precision, cases[i].method, &dt);
        assert_int_equal(cd_membrane_step(m, dt, 5000), CD_ERROR_DIVERGED);
        refuses(m, cd_membrane_step(m, dt, 1), CD_ERROR_DIVERGED, "");
        ok(cd_membrane_set_method(m, CD_METHOD_IMPLICIT));
        refuses(m, cd_membrane_step(m, dt, 1), CD_ERROR_DIVERGED, "");
        cd_membrane_destroy(m);
    }
}

static void a_diverged_membrane_is_as_new_after_a_reset(void** state) {
    (void)state;
    for (size_t i = 0; i < COUNT(cases); ++i) {
        double dt, unused;
        cd_membrane* m = unstable(cases[i].precision, cases[i].method, &dt);
        cd_membrane* fresh = unstable(cases[i].precision, cases[i].method, &unused);
        assert_int_equal(cd_membrane_step(m, dt, 5000), CD_ERROR_DIVERGED);
        ok(cd_membrane_reset(m));
        ok(cd_membrane_reset(fresh));
        assert_int_equal(hash_of(m), hash_of(fresh));
        cloth_lay_out(m, 0.1);
        cloth_lay_out(fresh, 0.1);
        ok(cd_membrane_step(m, dt / 8, 20));
        ok(cd_membrane_step(fresh, dt / 8, 20));
        assert_int_equal(hash_of(m), hash_of(fresh));
        cd_membrane_destroy(m);
        cd_membrane_destroy(fresh);
    }
}

static void a_diverged_membrane_goes_on_once_finite_numbers_are_written(void** state) {
    (void)state;
    for (size_t i = 0; i < 2 * COUNT(cases); ++i) {
        double dt, unused, zeros[ALL] = {0};
        cd_membrane* m = unstable(cases[i / 2].precision, cases[i / 2].method, &dt);
        cd_membrane* fresh = unstable(cases[i / 2].precision, cases[i / 2].method, &unused);
        const double drag = i % 2 ? 0.1 : 0;
        ok(cd_membrane_set_drag(m, drag));
        ok(cd_membrane_set_drag(fresh, drag));
        assert_int_equal(cd_membrane_step(m, dt, 5000), CD_ERROR_DIVERGED);
        cloth_write(m, CD_POSITION, zeros);
        refuses(m, cd_membrane_step(m, dt, 1), CD_ERROR_DIVERGED, ""); /* velocities are still wrong */
        cloth_write(m, CD_VELOCITY, zeros);
        ok(cd_membrane_step(m, dt, 3));
        assert_true(is_finite(m));
        /* and like one that never was */
        static const cd_method methods[] = {CD_METHOD_SYMPLECTIC_EULER, CD_METHOD_IMPLICIT};
        cd_membrane* const both[] = {m, fresh};
        for (size_t way = 0; way < COUNT(methods); ++way) {
            double x[ALL], fresh_x[ALL];
            for (size_t k = 0; k < COUNT(both); ++k) {
                cloth_lay_out(both[k], 0.1);
                cloth_write(both[k], CD_VELOCITY, zeros);
                ok(cd_membrane_set_method(both[k], methods[way]));
                ok(cd_membrane_step(both[k], dt / 8, 20));
            }
            cloth_read(m, CD_POSITION, x);
            cloth_read(fresh, CD_POSITION, fresh_x);
            assert_memory_equal(x, fresh_x, sizeof x);
        }
        cd_membrane_destroy(m);
        cd_membrane_destroy(fresh);
    }
}

static void a_diverged_state_can_be_kept_and_stays_diverged_until_another_is_loaded(void** state) {
    (void)state;
    for (int by_copy = 0; by_copy <= 1; ++by_copy) {
        double dt, unused;
        cd_membrane* m = unstable(CD_FLOAT32, CD_METHOD_SYMPLECTIC_EULER, &dt);
        cd_membrane* other = unstable(CD_FLOAT32, CD_METHOD_SYMPLECTIC_EULER, &unused);
        cd_membrane* good = unstable(CD_FLOAT32, CD_METHOD_SYMPLECTIC_EULER, &unused);
        assert_int_equal(cd_membrane_step(m, dt, 5000), CD_ERROR_DIVERGED);
        size_t size, written;
        ok(cd_membrane_save_size(m, &size));
        unsigned char* bytes = malloc(size);
        assert_non_null(bytes);
        ok(cd_membrane_save(m, bytes, size, &written));
        if (by_copy) ok(cd_membrane_copy_state(other, m));
        else ok(cd_membrane_load(other, bytes, size));
        assert_int_equal(hash_of(other), hash_of(m));
        refuses(other, cd_membrane_step(other, dt, 1), CD_ERROR_DIVERGED, "");
        ok(cd_membrane_step(good, dt / 8, 7));
        ok(cd_membrane_save(good, bytes, size, &written));
        if (by_copy) ok(cd_membrane_copy_state(other, good));
        else ok(cd_membrane_load(other, bytes, size));
        ok(cd_membrane_step(other, dt / 8, 7));
        ok(cd_membrane_step(good, dt / 8, 7));
        assert_int_equal(hash_of(other), hash_of(good));
        free(bytes);
        cd_membrane_destroy(m);
        cd_membrane_destroy(other);
        cd_membrane_destroy(good);
    }
}

/* A stiff sheet whose coupled solves get one iteration. */
static cd_membrane* hurried(size_t most_iterations) {
    cd_membrane* m = cloth(31, 31, COMPONENTS, CD_FLOAT64);
    cloth_lay_out(m, 0.1);
    cloth_shake(m, 0.1, 5);
    ok(cd_membrane_set_edge(m, CD_EDGE_V_FIRST, CD_NODE_PINNED));
    ok(cd_membrane_set_stiffness(m, 1e4, 3e5));
    ok(cd_membrane_set_solver(m, CD_SOLVER_COUPLED));
    ok(cd_membrane_set_tolerance(m, 1e-12, most_iterations));
    return m;
}

static void a_solve_that_ends_short_of_its_tolerance_is_told_and_the_steps_are_made(void** state) {
    (void)state;
    size_t iterations = 0;
    double residual = 0;
    uint64_t steps;
    cd_membrane* m = hurried(1);
    assert_int_equal(cd_membrane_step(m, 0.05, 3), CD_ERROR_TOLERANCE);
    ok(cd_membrane_get_convergence(m, &iterations, &residual));
    assert_int_equal(iterations, 1);
    assert_true(residual > 1e-12);
    const char* message = cd_error_message();
    assert_non_null(strstr(message, "cd_membrane_step: "));
    assert_non_null(strstr(message, text_of("%g", residual)));
    assert_non_null(strstr(message, text_of(" %zu iterations", iterations)));
    assert_non_null(strstr(message, "1e-12"));
    ok(cd_membrane_get_steps(m, &steps));
    assert_int_equal(steps, 3);
    assert_int_equal(cd_membrane_step(m, 0.05, 1), CD_ERROR_TOLERANCE); /* and goes on */
    ok(cd_membrane_set_tolerance(m, 1e-9, 1000));
    ok(cd_membrane_step(m, 0.05, 1));
    ok(cd_membrane_get_convergence(m, &iterations, &residual));
    assert_true(iterations > 1 && iterations <= 1000 && residual <= 1e-9);
    ok(cd_membrane_set_solver(m, CD_SOLVER_ALTERNATING));
    ok(cd_membrane_step(m, 0.05, 1));
    ok(cd_membrane_get_convergence(m, &iterations, &residual));
    assert_true(iterations == 0 && residual == 0);
    cd_membrane_destroy(m);
}

static void a_sheet_within_the_limit_never_diverges(void** state) {
    (void)state;
    for (cd_precision precision = CD_FLOAT32; precision <= CD_FLOAT64; ++precision) {
        double dt;
        cd_membrane* m = unstable(precision, CD_METHOD_SYMPLECTIC_EULER, &dt);
        ok(cd_membrane_step(m, dt * 0.499, 20000));
        for (cd_solver solver = CD_SOLVER_ALTERNATING; solver <= CD_SOLVER_COUPLED; ++solver) {
            ok(cd_membrane_set_method(m, CD_METHOD_IMPLICIT));
            ok(cd_membrane_set_solver(m, solver));
            ok(cd_membrane_step(m, dt * 1e6, solver ? 100 : 2000));
            assert_true(is_finite(m));
        }
        cd_membrane_destroy(m);
    }
}

/* Whatever lies beside the sheet in its memory, where it serves wider registers. */
static void a_sheet_that_falls_far_is_finite_as_long_as_its_nodes_are(void** state) {
    (void)state;
    const double gravity = -9.81;
    for (size_t count = 1; count <= 6; ++count) {
        cd_membrane* m = cloth(2, 28, 1, CD_FLOAT32);
        ok(cd_membrane_set_gravity(m, &gravity, 1));
        ok(cd_membrane_set_method(m, CD_METHOD_SYMPLECTIC_EULER));
        for (size_t steps = 0; steps < 6; steps += count) ok(cd_membrane_step(m, 1e9, count));
        cd_membrane_destroy(m);
    }
}

static void a_diverged_membrane_is_as_new_after_a_reset_with_other_kernels_too(void** state) {
    (void)state;
    const double gravity = -9.81;
    FOR_RUNNABLE(before)
    FOR_RUNNABLE(after)
    for (size_t nu = 0; nu < 23; ++nu) {
        cd_membrane* m = cloth(nu, 20, 1, CD_FLOAT32);
        ok(cd_membrane_set_gravity(m, &gravity, 1));
        ok(cd_membrane_set_kernels(m, before));
        assert_int_equal(cd_membrane_step(m, 1.27e24, 3), CD_ERROR_DIVERGED);
        ok(cd_membrane_set_kernels(m, after));
        ok(cd_membrane_reset(m));
        ok(cd_membrane_step(m, 1e-3, 2));
        cd_membrane_destroy(m);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(divergence_is_reported_with_the_first_bad_step),
        cmocka_unit_test(a_diverged_membrane_makes_no_step_and_changes_nothing),
        cmocka_unit_test(a_diverged_membrane_is_as_new_after_a_reset),
        cmocka_unit_test(a_diverged_membrane_goes_on_once_finite_numbers_are_written),
        cmocka_unit_test(a_diverged_state_can_be_kept_and_stays_diverged_until_another_is_loaded),
        cmocka_unit_test(a_solve_that_ends_short_of_its_tolerance_is_told_and_the_steps_are_made),
        cmocka_unit_test(a_sheet_within_the_limit_never_diverges),
        cmocka_unit_test(a_sheet_that_falls_far_is_finite_as_long_as_its_nodes_are),
        cmocka_unit_test(a_diverged_membrane_is_as_new_after_a_reset_with_other_kernels_too),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
