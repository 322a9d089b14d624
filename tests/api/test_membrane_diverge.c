/* A sheet whose solves end short of their tolerance is reported with what is left, and goes on; and what of sheets only
 * may diverge or not. */
#include <string.h>

#include "check.h"
#include "cloth.h"
#include "kernels.h"

enum { COMPONENTS = 2 };

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
        cmocka_unit_test(a_solve_that_ends_short_of_its_tolerance_is_told_and_the_steps_are_made),
        cmocka_unit_test(a_sheet_that_falls_far_is_finite_as_long_as_its_nodes_are),
        cmocka_unit_test(a_diverged_membrane_is_as_new_after_a_reset_with_other_kernels_too),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
