/* A water's steps give the same bits with all kernels that this processor runs. */
#include "check.h"
#include "kernels.h"
#include "pool.h"

static uint64_t run(const struct pool_scene* scene, size_t nx, size_t ny, cd_precision precision, cd_kernels kernels) {
    cd_water* const water = pool(nx, ny, precision);
    scene->build(water);
    ok(cd_water_set_kernels(water, kernels));
    pool_step(water, scene->dt, 20);
    const uint64_t hash = hash_of(water);
    cd_water_destroy(water);
    return hash;
}

static void all_kernels_give_the_same_bits(void** state) {
    (void)state;
    static const size_t shapes[][2] = {{18, 11}, {1, 9}, {9, 1}, {7, 17}};
    for (const struct pool_scene* scene = pools; scene < pools + POOLS; ++scene)
        for (size_t s = 0; s < COUNT(shapes); ++s)
            for (cd_precision precision = CD_FLOAT32; precision <= CD_FLOAT64; ++precision) {
                const uint64_t plain = run(scene, shapes[s][0], shapes[s][1], precision, CD_KERNELS_PLAIN);
                FOR_RUNNABLE(kernels)
                if (run(scene, shapes[s][0], shapes[s][1], precision, kernels) != plain)
                    fail_msg("%s, %zu x %zu: %s differs", scene->name, shapes[s][0], shapes[s][1],
                             cd_kernels_name(kernels));
            }
}

static uint64_t run_lake(size_t nx, size_t ny, cd_precision precision, cd_kernels kernels) {
    cd_water* const water = pool(nx, ny, precision);
    pool_fill(water, CD_BED, -1);
    pool_vary(water, CD_DEPTH, 1, 0.05, nx + 100 * ny);
    ok(cd_water_set_kernels(water, kernels));
    ok(cd_water_step(water, 0.02, 3));
    const uint64_t hash = hash_of(water);
    cd_water_destroy(water);
    return hash;
}

/* However many lines are left over when those that go side by side are done. */
static void any_number_of_lines_gives_the_same_bits(void** state) {
    (void)state;
    for (size_t nx = 1; nx <= 40; nx += is_brief() ? 3 : 1)
        for (size_t ny = 1; ny <= 40; ny += nx % 3 + 1)
            for (cd_precision precision = CD_FLOAT32; precision <= CD_FLOAT64; ++precision) {
                const uint64_t plain = run_lake(nx, ny, precision, CD_KERNELS_PLAIN);
                FOR_RUNNABLE(kernels)
                if (run_lake(nx, ny, precision, kernels) != plain)
                    fail_msg("%zu x %zu: %s differs", nx, ny, cd_kernels_name(kernels));
            }
}

/* A force that finds no water does nothing, whether its line goes with wet ones or by itself. */
static void dry_lines_give_the_same_bits_beside_wet_ones(void** state) {
    (void)state;
    enum { NX = 13, NY = 7 };
    static const double friction[] = {0, 0.03};
    for (size_t f = 0; f < COUNT(friction); ++f)
        for (cd_momentum momentum = CD_MOMENTUM_LINEAR; momentum <= CD_MOMENTUM_ADVECTED; ++momentum) {
            uint64_t plain = 0;
            FOR_RUNNABLE(kernels) {
                cd_water* const water = pool(NX, NY, CD_FLOAT64);
                double depth[NX * NY], force[NX * (NY + 1)] = {0};
                for (size_t i = 0; i < COUNT(depth); ++i) depth[i] = i % NX < 5 ? 0 : 1;
                force[3 * NX + 2] = -1e300;
                ok(cd_water_set_kernels(water, kernels));
                ok(cd_water_set_momentum(water, momentum));
                ok(cd_water_set_manning(water, friction[f]));
                ok(cd_water_enable_field(water, CD_FORCE_Y));
                pool_write(water, CD_DEPTH, depth);
                pool_write(water, CD_FORCE_Y, force);
                ok(cd_water_step(water, 1e-20, 3));
                if (kernels == CD_KERNELS_PLAIN) plain = hash_of(water);
                if (hash_of(water) != plain) fail_msg("%s differs", cd_kernels_name(kernels));
                cd_water_destroy(water);
            }
        }
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(all_kernels_give_the_same_bits),
                                       cmocka_unit_test(any_number_of_lines_gives_the_same_bits),
                                       cmocka_unit_test(dry_lines_give_the_same_bits_beside_wet_ones)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
