// A membrane's steps give the same bits with the kernels of every instruction set this processor has.
extern "C" {
#include "cloth.h"
#include "cmocka_all.h"
}
#include "contdyn/membrane.h"
#include "model/membrane.hh"

namespace {

uint64_t run(const cloth_scene& scene, cd_precision precision, cd_method method, cd_solver solver,
             const cd::Kernels& kernels) {
    cd_membrane* const membrane = cloth(18, 11, 3, precision);
    scene.build(membrane);
    reinterpret_cast<cd::Membrane*>(membrane)->kernels = &kernels;
    assert_int_equal(cd_membrane_set_method(membrane, method), CD_OK);
    assert_int_equal(cd_membrane_set_solver(membrane, solver), CD_OK);
    const cd_status status = cd_membrane_step(membrane, method == CD_METHOD_IMPLICIT ? 0.01 : 1e-4, 5);
    assert_true(status == CD_OK || status == CD_ERROR_TOLERANCE);
    uint64_t hash = 0;
    assert_int_equal(cd_membrane_hash(membrane, &hash), CD_OK);
    cd_membrane_destroy(membrane);
    return hash;
}

void every_instruction_set_gives_the_same_bits(void**) {
    const cd::Kernels* sets[cd::kKernelSets];
    const size_t count = cd::runnable_kernels(sets);
    for (const cloth_scene& scene : cloths)
        for (cd_precision precision = CD_FLOAT32; precision <= CD_FLOAT64; ++precision)
            for (cd_method method = CD_METHOD_IMPLICIT; method <= CD_METHOD_STIFF_SECOND; ++method)
                for (cd_solver solver = CD_SOLVER_ALTERNATING; solver <= CD_SOLVER_COUPLED; ++solver) {
                    const uint64_t plain = run(scene, precision, method, solver, *sets[0]);
                    for (size_t k = 1; k < count; ++k)
                        if (run(scene, precision, method, solver, *sets[k]) != plain)
                            fail_msg("%s, method %d, solver %d: %s differs from %s", scene.name, int(method),
                                     int(solver), sets[k]->name, sets[0]->name);
                }
    print_message("%zu sets of kernels\n", count);
}

} // namespace

int main() {
    const CMUnitTest tests[] = {cmocka_unit_test(every_instruction_set_gives_the_same_bits)};
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
