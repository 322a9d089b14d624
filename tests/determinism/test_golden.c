/* Hashes of small scenes after 200 steps. They must not differ between machines, compilers or options.
 *
 * When the arithmetic is changed on purpose, put what this prints with CD_PRINT_GOLDEN=1 in its environment into
 * golden_hashes.h, and say in the change why the numbers moved. */
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>

#include "check.h"
#include "kernels.h"
#include "scene.h"

static const struct golden {
    size_t scene;
    cd_method method;
    uint64_t hash[2]; /* float32, float64 */
} golden[] = {
#include "golden_hashes.h"
};

static uint64_t run(size_t scene, cd_method method, cd_precision precision, cd_kernels kernels) {
    const int is_explicit = method == CD_METHOD_FORWARD_EULER || method == CD_METHOD_SYMPLECTIC_EULER;
    cd_chain* chain = scene_chain(3, 12, 3, precision);
    scenes[scene].build(chain);
    ok(cd_chain_set_kernels(chain, kernels));
    ok(cd_chain_set_method(chain, method));
    ok(cd_chain_step(chain, is_explicit ? 0.0005 : 0.01, 200));
    const uint64_t hash = hash_of(chain);
    cd_chain_destroy(chain);
    return hash;
}

static void print(void) {
    printf("/* Printed by test_golden.c: scene, method, {float32, float64}. */\n");
    for (size_t scene = 0; scene < SCENES; ++scene) {
        for (cd_method method = CD_METHOD_IMPLICIT; method <= CD_METHOD_STIFF_SECOND; ++method)
            printf("{%zu, %d, {0x%016" PRIx64 ", 0x%016" PRIx64 "}}, /* %s */\n", scene, method,
                   run(scene, method, CD_FLOAT32, CD_KERNELS_PLAIN), run(scene, method, CD_FLOAT64, CD_KERNELS_PLAIN),
                   scenes[scene].name);
    }
}

static void the_same_scenes_give_the_same_bits(void** state) {
    (void)state;
    size_t wrong = 0;
    for (size_t i = 0; i < COUNT(golden); ++i) {
        for (cd_precision precision = CD_FLOAT32; precision <= CD_FLOAT64; ++precision) {
            FOR_RUNNABLE(kernels) {
                const uint64_t hash = run(golden[i].scene, golden[i].method, precision, kernels);
                if (hash == golden[i].hash[precision]) continue;
                print_error("%s, method %d, float%d, %s: 0x%016" PRIx64 ", not 0x%016" PRIx64 "\n",
                            scenes[golden[i].scene].name, golden[i].method, precision == CD_FLOAT64 ? 64 : 32,
                            cd_kernels_name(kernels), hash, golden[i].hash[precision]);
                ++wrong;
            }
        }
    }
    assert_int_equal(wrong, 0);
}

static void every_scene_and_method_is_in_the_table(void** state) {
    (void)state;
    assert_int_equal(COUNT(golden), SCENES * 4);
    for (size_t i = 0; i < COUNT(golden); ++i) {
        assert_int_equal(golden[i].scene, i / 4);
        assert_int_equal(golden[i].method, i % 4);
    }
}

int main(void) {
    if (getenv("CD_PRINT_GOLDEN")) {
        print();
        return 0;
    }
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_same_scenes_give_the_same_bits),
        cmocka_unit_test(every_scene_and_method_is_in_the_table),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
