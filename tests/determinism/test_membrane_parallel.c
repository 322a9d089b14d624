/* A membrane's result depends neither on who runs the tasks and in what order, nor on how steps share calls, nor on the
 * other components. */
#include <stdlib.h>

#include "check.h"
#include "cloth.h"
#include "jobs.h"

static void step(cd_membrane* membrane, double dt, size_t count) {
    const cd_status status = cd_membrane_step(membrane, dt, count);
    assert_true(status == CD_OK || status == CD_ERROR_TOLERANCE);
}

static const struct way {
    cd_method method;
    cd_solver solver;
    double dt;
} ways[] = {
    {CD_METHOD_IMPLICIT, CD_SOLVER_ALTERNATING, 0.01},
    {CD_METHOD_IMPLICIT, CD_SOLVER_COUPLED, 0.01},
    {CD_METHOD_SYMPLECTIC_EULER, CD_SOLVER_ALTERNATING, 1e-5},
    {CD_METHOD_STIFF_SECOND, CD_SOLVER_COUPLED, 0.01},
};

/* Cloth comes last; it has the first way alone. */
enum { SCENES = CLOTHS + LENGTH_CLOTHS };
static size_t ways_of(size_t scene) { return scene < CLOTHS ? COUNT(ways) : 1; }

static cd_membrane* begin(size_t scene, size_t nu, size_t nv, size_t components, cd_precision precision,
                          const struct way* way) {
    cd_membrane* membrane = cloth(nu, nv, scene < CLOTHS ? components : 3, precision);
    (scene < CLOTHS ? &cloths[scene] : &length_cloths[scene - CLOTHS])->build(membrane);
    ok(cd_membrane_set_method(membrane, way->method));
    ok(cd_membrane_set_solver(membrane, way->solver));
    return membrane;
}

/* Large enough to be dealt out in several parts. */
static void the_job_system_leaves_no_trace(void** state) {
    (void)state;
    for (size_t scene = 0; scene < SCENES; ++scene)
        for (size_t w = 0; w < ways_of(scene); ++w) {
            if (!is_taken(scene + w, is_brief() ? 7 : 2)) continue;
            uint64_t hashes[3];
            size_t tasks = 0;
            for (size_t how = 0; how < 3; ++how) {
                struct jobs jobs = {0};
                const cd_parallel parallel = how == 1 ? jobs_reversed(&jobs) : jobs_threads(&jobs);
                cd_membrane* membrane = begin(scene, 260, 200, 1, w % 2 ? CD_FLOAT32 : CD_FLOAT64, &ways[w]);
                ok(cd_membrane_set_parallel(membrane, how == 0 ? NULL : &parallel));
                step(membrane, ways[w].dt, 1);
                hashes[how] = hash_of(membrane);
                tasks = jobs.tasks;
                cd_membrane_destroy(membrane);
            }
            assert_true(tasks > 10);
            assert_int_equal(hashes[1], hashes[0]);
            assert_int_equal(hashes[2], hashes[0]);
        }
}

static void ten_steps_at_once_are_ten_steps(void** state) {
    (void)state;
    for (size_t scene = 0; scene < SCENES; scene += is_brief() ? 5 : 1)
        for (cd_precision precision = CD_FLOAT32; precision <= CD_FLOAT64; ++precision)
            for (size_t w = 0; w < ways_of(scene); ++w) {
                cd_membrane* at_once = begin(scene, 9, 12, 3, precision, &ways[w]);
                cd_membrane* singly = begin(scene, 9, 12, 3, precision, &ways[w]);
                step(at_once, ways[w].dt, 10);
                for (int i = 0; i < 10; ++i) step(singly, ways[w].dt, 1);
                assert_int_equal(hash_of(at_once), hash_of_membrane(singly));
                cd_membrane_destroy(at_once);
                cd_membrane_destroy(singly);
            }
}

/* But for the pressure, which acts along the normal, and is left out. */
static void components_do_not_mix(void** state) {
    (void)state;
    enum { NU = 9, NV = 7, NODES = (NU + 1) * (NV + 1), COMPONENTS = 3 };
    for (size_t scene = 0; scene < CLOTHS; scene += is_brief() ? 5 : 1)
        for (size_t w = 0; w < COUNT(ways); ++w) {
            double x[2][NODES * COMPONENTS];
            for (size_t i = 0; i < 2; ++i) {
                cd_membrane* membrane = begin(scene, NU, NV, COMPONENTS, CD_FLOAT32, &ways[w]);
                ok(cd_membrane_set_pressure(membrane, 0));
                cloth_read(membrane, CD_POSITION, x[i]);
                for (size_t node = 0; node < NODES && i == 1; ++node) x[1][node * COMPONENTS + 1] *= 3;
                cloth_write(membrane, CD_POSITION, x[i]);
                step(membrane, ways[w].dt, 10);
                cloth_read(membrane, CD_POSITION, x[i]);
                cd_membrane_destroy(membrane);
            }
            size_t moved = 0;
            for (size_t j = 0; j < COUNT(x[0]); ++j) {
                if (j % COMPONENTS == 1) moved += x[0][j] != x[1][j];
                else assert_same_bits(&x[0][j], &x[1][j], 1);
            }
            assert_true(moved > 0);
        }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_job_system_leaves_no_trace),
        cmocka_unit_test(ten_steps_at_once_are_ten_steps),
        cmocka_unit_test(components_do_not_mix),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
