/* Hashes of small membranes after 60 steps. They must not differ between machines, compilers or options: see
 * test_golden.c, and put what this prints with CD_PRINT_GOLDEN=1 into golden_membrane_hashes.h. */
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>

#include "check.h"
#include "cloth.h"
#include "kernels.h"

static const struct golden {
    size_t scene;
    cd_method method;
    cd_solver solver;
    uint64_t hash[2]; /* float32, float64 */
} golden[] = {
#include "golden_membrane_hashes.h"
};

/* Cloth comes last. */
static const struct cloth_scene* scene_of(size_t scene) {
    return scene < CLOTHS ? &cloths[scene] : &length_cloths[scene - CLOTHS];
}

static uint64_t run(size_t scene, cd_method method, cd_solver solver, cd_precision precision, cd_kernels kernels) {
    const int is_explicit = method == CD_METHOD_FORWARD_EULER || method == CD_METHOD_SYMPLECTIC_EULER;
    cd_membrane* membrane = cloth(13, 9, 3, precision);
    scene_of(scene)->build(membrane);
    ok(cd_membrane_set_kernels(membrane, kernels));
    ok(cd_membrane_set_method(membrane, method));
    ok(cd_membrane_set_solver(membrane, solver));
    const cd_status status = cd_membrane_step(membrane, is_explicit ? 0.0002 : 0.01, 60);
    assert_true(status == CD_OK || status == CD_ERROR_TOLERANCE);
    const uint64_t hash = hash_of(membrane);
    cd_membrane_destroy(membrane);
    return hash;
}

/* Methods 0 .. 3 with the alternating solver, then the implicit ones with the coupled. Cloth has the first alone. */
enum { RUNS = 6 };
static const struct {
    cd_method method;
    cd_solver solver;
} runs[RUNS] = {
    {CD_METHOD_IMPLICIT, CD_SOLVER_ALTERNATING},
    {CD_METHOD_FORWARD_EULER, CD_SOLVER_ALTERNATING},
    {CD_METHOD_SYMPLECTIC_EULER, CD_SOLVER_ALTERNATING},
    {CD_METHOD_STIFF_SECOND, CD_SOLVER_ALTERNATING},
    {CD_METHOD_IMPLICIT, CD_SOLVER_COUPLED},
    {CD_METHOD_STIFF_SECOND, CD_SOLVER_COUPLED},
};

static void print(void) {
    printf("/* Printed by test_membrane_golden.c: scene, method, solver, {float32, float64}. */\n");
    for (size_t scene = 0; scene < CLOTHS + LENGTH_CLOTHS; ++scene)
        for (size_t r = 0; r < (scene < CLOTHS ? RUNS : 1); ++r)
            printf("{%zu, %d, %d, {0x%016" PRIx64 ", 0x%016" PRIx64 "}}, /* %s */\n", scene, runs[r].method,
                   runs[r].solver, run(scene, runs[r].method, runs[r].solver, CD_FLOAT32, CD_KERNELS_PLAIN),
                   run(scene, runs[r].method, runs[r].solver, CD_FLOAT64, CD_KERNELS_PLAIN), scene_of(scene)->name);
}

static void the_same_membranes_give_the_same_bits(void** state) {
    (void)state;
    size_t wrong = 0;
    for (size_t i = 0; i < COUNT(golden); ++i) {
        for (cd_precision precision = CD_FLOAT32; precision <= CD_FLOAT64; ++precision) {
            FOR_RUNNABLE(kernels) {
                const uint64_t hash = run(golden[i].scene, golden[i].method, golden[i].solver, precision, kernels);
                if (hash == golden[i].hash[precision]) continue;
                print_error("%s, method %d, solver %d, float%d, %s: 0x%016" PRIx64 ", not 0x%016" PRIx64 "\n",
                            scene_of(golden[i].scene)->name, golden[i].method, golden[i].solver,
                            precision == CD_FLOAT64 ? 64 : 32, cd_kernels_name(kernels), hash,
                            golden[i].hash[precision]);
                ++wrong;
            }
        }
    }
    assert_int_equal(wrong, 0);
}

static void every_membrane_method_and_solver_is_in_the_table(void** state) {
    (void)state;
    assert_int_equal(COUNT(golden), CLOTHS * RUNS + LENGTH_CLOTHS);
    for (size_t i = 0; i < COUNT(golden); ++i) {
        const int cloth = i >= CLOTHS * RUNS;
        assert_int_equal(golden[i].scene, cloth ? i - CLOTHS * RUNS + CLOTHS : i / RUNS);
        assert_int_equal(golden[i].method, runs[cloth ? 0 : i % RUNS].method);
        assert_int_equal(golden[i].solver, runs[cloth ? 0 : i % RUNS].solver);
    }
}

int main(void) {
    if (getenv("CD_PRINT_GOLDEN")) {
        print();
        return 0;
    }
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_same_membranes_give_the_same_bits),
        cmocka_unit_test(every_membrane_method_and_solver_is_in_the_table),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
