// A water's steps give the same bits with the kernels of every instruction set this processor has.
extern "C" {
#include "cmocka_all.h"
#include "pool.h"
}
#include "contdyn/water.h"
#include "model/water.hh"

namespace {

uint64_t run(const pool_scene& scene, size_t nx, size_t ny, cd_precision precision, const cd::Kernels& kernels) {
    cd_water* const water = pool(nx, ny, precision);
    scene.build(water);
    reinterpret_cast<cd::Water*>(water)->kernels = &kernels;
    pool_step(water, scene.dt, 20);
    uint64_t hash = 0;
    assert_int_equal(cd_water_hash(water, &hash), CD_OK);
    cd_water_destroy(water);
    return hash;
}

void every_instruction_set_gives_the_same_bits(void**) {
    static const size_t shapes[][2] = {{18, 11}, {1, 9}, {9, 1}, {7, 17}};
    const cd::Kernels* sets[cd::kKernelSets];
    const size_t count = cd::runnable_kernels(sets);
    for (const pool_scene& scene : pools)
        for (const auto& shape : shapes)
            for (cd_precision precision = CD_FLOAT32; precision <= CD_FLOAT64; ++precision) {
                const uint64_t plain = run(scene, shape[0], shape[1], precision, *sets[0]);
                for (size_t k = 1; k < count; ++k)
                    if (run(scene, shape[0], shape[1], precision, *sets[k]) != plain)
                        fail_msg("%s, %zu x %zu: %s differs from %s", scene.name, shape[0], shape[1], sets[k]->name,
                                 sets[0]->name);
            }
    print_message("%zu sets of kernels\n", count);
}

} // namespace

int main() {
    const CMUnitTest tests[] = {cmocka_unit_test(every_instruction_set_gives_the_same_bits)};
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
