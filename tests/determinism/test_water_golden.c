/* Hashes of small waters after 60 steps. They must not differ between machines, compilers or options: see
 * test_golden.c, and put what this prints with CD_PRINT_GOLDEN=1 into golden_water_hashes.h. */
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>

#include "check.h"
#include "kernels.h"
#include "pool.h"

static const struct golden {
    size_t scene, nx, ny;
    uint64_t hash[2]; /* float32, float64 */
} golden[] = {
#include "golden_water_hashes.h"
};

/* Odd ones, single lines, and lines around a multiple of those that are worked on together. */
static const struct { size_t nx, ny; } shapes[] = {{13, 9}, {1, 17}, {17, 1}, {16, 7}, {2, 16}};

static uint64_t run(size_t scene, size_t nx, size_t ny, cd_precision precision, cd_kernels kernels) {
    cd_water* water = pool_of(scene, nx, ny, precision, 0);
    ok(cd_water_set_kernels(water, kernels));
    pool_step(water, pools[scene].dt, 60);
    const uint64_t hash = hash_of(water);
    cd_water_destroy(water);
    return hash;
}

static void print(void) {
    printf("/* Printed by test_water_golden.c: scene, cells along x and y, {float32, float64}. */\n");
    for (size_t scene = 0; scene < POOLS; ++scene)
        for (size_t s = 0; s < COUNT(shapes); ++s)
            printf("{%zu, %zu, %zu, {0x%016" PRIx64 ", 0x%016" PRIx64 "}}, /* %s */\n", scene, shapes[s].nx,
                   shapes[s].ny, run(scene, shapes[s].nx, shapes[s].ny, CD_FLOAT32, CD_KERNELS_PLAIN),
                   run(scene, shapes[s].nx, shapes[s].ny, CD_FLOAT64, CD_KERNELS_PLAIN), pools[scene].name);
}

static void the_same_waters_give_the_same_bits(void** state) {
    (void)state;
    size_t wrong = 0;
    for (size_t i = 0; i < COUNT(golden); ++i) {
        for (cd_precision precision = CD_FLOAT32; precision <= CD_FLOAT64; ++precision) {
            FOR_RUNNABLE(kernels) {
                const uint64_t hash = run(golden[i].scene, golden[i].nx, golden[i].ny, precision, kernels);
                if (hash == golden[i].hash[precision]) continue;
                print_error("%s, %zu x %zu, float%d, %s: 0x%016" PRIx64 ", not 0x%016" PRIx64 "\n",
                            pools[golden[i].scene].name, golden[i].nx, golden[i].ny, precision == CD_FLOAT64 ? 64 : 32,
                            cd_kernels_name(kernels), hash, golden[i].hash[precision]);
                ++wrong;
            }
        }
    }
    assert_int_equal(wrong, 0);
}

static void every_water_and_shape_is_in_the_table(void** state) {
    (void)state;
    assert_int_equal(COUNT(golden), POOLS * COUNT(shapes));
    for (size_t i = 0; i < COUNT(golden); ++i) {
        assert_int_equal(golden[i].scene, i / COUNT(shapes));
        assert_int_equal(golden[i].nx, shapes[i % COUNT(shapes)].nx);
        assert_int_equal(golden[i].ny, shapes[i % COUNT(shapes)].ny);
    }
}

int main(void) {
    if (getenv("CD_PRINT_GOLDEN")) {
        print();
        return 0;
    }
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_same_waters_give_the_same_bits),
        cmocka_unit_test(every_water_and_shape_is_in_the_table),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
