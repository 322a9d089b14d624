/* A membrane's steps give the same bits with all kernels that this processor runs. */
#include "check.h"
#include "cloth.h"
#include "kernels.h"

static uint64_t run(const struct cloth_scene* scene, cd_precision precision, cd_method method, cd_solver solver,
                    cd_kernels kernels) {
    cd_membrane* const membrane = cloth(18, 11, 3, precision);
    scene->build(membrane);
    ok(cd_membrane_set_kernels(membrane, kernels));
    ok(cd_membrane_set_method(membrane, method));
    ok(cd_membrane_set_solver(membrane, solver));
    const cd_status status = cd_membrane_step(membrane, method == CD_METHOD_IMPLICIT ? 0.01 : 1e-4, 5);
    assert_true(status == CD_OK || status == CD_ERROR_TOLERANCE);
    const uint64_t hash = hash_of(membrane);
    cd_membrane_destroy(membrane);
    return hash;
}

static void all_kernels_give_the_same_bits(void** state) {
    (void)state;
    for (const struct cloth_scene* scene = cloths; scene < cloths + CLOTHS; ++scene)
        for (cd_precision precision = CD_FLOAT32; precision <= CD_FLOAT64; ++precision)
            for (cd_method method = CD_METHOD_IMPLICIT; method <= CD_METHOD_STIFF_SECOND; ++method)
                for (cd_solver solver = CD_SOLVER_ALTERNATING; solver <= CD_SOLVER_COUPLED; ++solver) {
                    const uint64_t plain = run(scene, precision, method, solver, CD_KERNELS_PLAIN);
                    FOR_RUNNABLE(kernels)
                    if (run(scene, precision, method, solver, kernels) != plain)
                        fail_msg("%s, method %d, solver %d: %s differs", scene->name, method, solver,
                                 cd_kernels_name(kernels));
                }
}

static void cloth_of_any_shape_gives_the_same_bits(void** state) {
    (void)state;
    for (const struct cloth_scene* scene = length_cloths; scene < length_cloths + LENGTH_CLOTHS; ++scene)
        for (size_t nu = 5; nu <= 34; nu += is_brief() ? 5 : 1)
            for (size_t nv = 5; nv <= 34; nv += nu % 3 + 5)
                for (cd_precision precision = CD_FLOAT32; precision <= CD_FLOAT64; ++precision) {
                    uint64_t plain = 0;
                    FOR_RUNNABLE(kernels) {
                        cd_membrane* const membrane = cloth(nu, nv, 3, precision);
                        scene->build(membrane);
                        ok(cd_membrane_set_kernels(membrane, kernels));
                        ok(cd_membrane_step(membrane, 0.01, 3));
                        const uint64_t hash = hash_of(membrane);
                        cd_membrane_destroy(membrane);
                        if (kernels == CD_KERNELS_PLAIN) plain = hash;
                        if (hash != plain)
                            fail_msg("%s, %zu x %zu: %s differs", scene->name, nu, nv, cd_kernels_name(kernels));
                    }
                }
}

static uint64_t run_uniform(size_t nu, size_t nv, cd_precision precision, cd_method method, cd_kernels kernels) {
    cd_membrane* const membrane = cloth(nu, nv, 1, precision);
    cloth_lay_out(membrane, 0.1);
    cloth_shake(membrane, 0.02, nu + 100 * nv);
    ok(cd_membrane_set_drag(membrane, 0.1));
    ok(cd_membrane_set_kernels(membrane, kernels));
    ok(cd_membrane_set_method(membrane, method));
    ok(cd_membrane_step(membrane, 1e-3, 3));
    const uint64_t hash = hash_of(membrane);
    cd_membrane_destroy(membrane);
    return hash;
}

/* However many nodes and rows are left over when those that go side by side are done. */
static void uniform_sheets_of_any_shape_give_the_same_bits(void** state) {
    (void)state;
    for (size_t nu = 0; nu <= 34; nu += is_brief() ? 2 : 1)
        for (size_t nv = 0; nv <= 34; nv += nu % 3 + 1)
            for (cd_precision precision = CD_FLOAT32; precision <= CD_FLOAT64; ++precision)
                for (cd_method method = CD_METHOD_IMPLICIT; method <= CD_METHOD_STIFF_SECOND; ++method) {
                    const uint64_t plain = run_uniform(nu, nv, precision, method, CD_KERNELS_PLAIN);
                    FOR_RUNNABLE(kernels)
                    if (run_uniform(nu, nv, precision, method, kernels) != plain)
                        fail_msg("%zu x %zu, method %d: %s differs", nu, nv, method, cd_kernels_name(kernels));
                }
}

static uint64_t run_tiny(double size, cd_kernels kernels) {
    enum { ALL = 2 * 15 * 3 };
    double x[ALL], v[ALL];
    cd_membrane* const membrane = cloth(1, 14, 3, CD_FLOAT64);
    for (size_t i = 0; i < ALL; ++i) {
        x[i] = size * ((double)(i * 7919 % 101) / 50 - 1);
        v[i] = size * ((double)(i * 104729 % 97) / 48 - 1);
    }
    cloth_write(membrane, CD_POSITION, x);
    cloth_write(membrane, CD_VELOCITY, v);
    ok(cd_membrane_attach(membrane, 0, 7, 0.5, 0.03, NULL, 0));
    ok(cd_membrane_set_solver(membrane, CD_SOLVER_COUPLED));
    ok(cd_membrane_set_lambda(membrane, 1));
    ok(cd_membrane_set_kernels(membrane, kernels));
    (void)cd_membrane_step(membrane, 7.4, 4); /* whether it comes to its tolerance does not matter */
    const uint64_t hash = hash_of(membrane);
    cd_membrane_destroy(membrane);
    return hash;
}

/* Where some numbers are taken for 0 on the way. */
static void sheets_that_come_to_rest_give_the_same_bits(void** state) {
    (void)state;
    for (double size = 1e-120; size > 1e-165; size /= 3) {
        const uint64_t plain = run_tiny(size, CD_KERNELS_PLAIN);
        FOR_RUNNABLE(kernels)
        if (run_tiny(size, kernels) != plain) fail_msg("%g: %s differs", size, cd_kernels_name(kernels));
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(all_kernels_give_the_same_bits),
                                       cmocka_unit_test(cloth_of_any_shape_gives_the_same_bits),
                                       cmocka_unit_test(uniform_sheets_of_any_shape_give_the_same_bits),
                                       cmocka_unit_test(sheets_that_come_to_rest_give_the_same_bits)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
