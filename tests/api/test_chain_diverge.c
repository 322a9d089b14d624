/* What diverges, and what does not, in chains only: strands beside others, pins, welds and targets. */
#include <math.h>

#include "scene.h"
#include "unstable.h"

enum { STRANDS = 20, NODES = 10, COMPONENTS = 2, ALL = STRANDS * NODES * COMPONENTS };

#define FOR_CASES(i) for (size_t i = 0; i < unstables[CHAIN].cases; ++i)

static cd_chain* unstable(size_t i, double* out_dt) {
    double small;
    return unstable_new(&unstables[CHAIN], i, out_dt, &small);
}

static void the_finite_strands_of_a_diverged_chain_are_as_ever(void** state) {
    (void)state;
    double dt, v[2 * NODES * COMPONENTS];
    cd_chain* chain = unstable(0, &dt);
    assert_int_equal(cd_chain_step(chain, dt, 5000), CD_ERROR_DIVERGED);
    ok(cd_chain_read_f64(chain, CD_VELOCITY, 1, 2, 0, NODES, v, COUNT(v)));
    for (size_t i = 0; i < COUNT(v); ++i) assert_true(v[i] == 0);
    cd_chain_destroy(chain);
}

static void what_is_pinned_is_still_in_a_diverged_chain(void** state) {
    (void)state;
    FOR_CASES(i) {
        double dt, v[ALL];
        cd_chain* chain = unstable(i, &dt);
        ok(cd_chain_set_end(chain, CD_END_FIRST, CD_NODE_PINNED));
        assert_int_equal(cd_chain_step(chain, dt, 100000), CD_ERROR_DIVERGED);
        scene_read(chain, CD_VELOCITY, v);
        for (size_t s = 0; s < STRANDS; ++s)
            for (size_t k = 0; k < COMPONENTS; ++k) assert_true(v[s * NODES * COMPONENTS + k] == 0);
        cd_chain_destroy(chain);
    }
}

/* Two welded nodes, the others free; masses and ties as they come. Symplectic Euler moves welded nodes apart from its
 * sweep, where numbers may overflow too. */
static void no_infinite_state_goes_without_a_status(void** state) {
    (void)state;
    const double masses[5] = {35.6, 0.0986, 0.2477, 0.2456, 15.3}, start[5] = {1, 0.3, -0.2, 0.5, 1};
    const double target = 0;
    for (cd_precision precision = CD_FLOAT32; precision <= CD_FLOAT64; ++precision)
        for (cd_method method = CD_METHOD_IMPLICIT; method <= CD_METHOD_STIFF_SECOND; ++method)
            for (double dt = 1; dt < 1e30; dt *= 3.7)
                for (size_t count = 1; count < 40; count += 3) {
                    cd_chain* chain = scene_chain(1, 4, 1, precision);
                    double x[5], v[5];
                    ok(cd_chain_weld(chain, 0, 0));
                    ok(cd_chain_enable_field(chain, CD_MASS));
                    scene_write(chain, CD_MASS, masses);
                    scene_write(chain, CD_POSITION, start);
                    ok(cd_chain_attach(chain, 0, 0, 5371.29, 0, &target, 1));
                    ok(cd_chain_set_method(chain, method));
                    const cd_status status = cd_chain_step(chain, dt, count);
                    scene_read(chain, CD_POSITION, x);
                    scene_read(chain, CD_VELOCITY, v);
                    int finite = 1;
                    for (size_t i = 0; i < 5; ++i) finite &= isfinite(x[i]) && isfinite(v[i]);
                    if (status == CD_OK && !finite)
                        fail_msg("method %d, dt %g, %zu steps: not finite, CD_OK", (int)method, dt, count);
                    cd_chain_destroy(chain);
                }
}

/* What a step makes of nodes that are welded to one that is held does not count. */
static void what_is_welded_to_a_pinned_node_does_not_diverge(void** state) {
    (void)state;
    const double target = 1;
    for (cd_precision precision = CD_FLOAT32; precision <= CD_FLOAT64; ++precision)
        for (cd_method method = CD_METHOD_IMPLICIT; method <= CD_METHOD_STIFF_SECOND; ++method)
            for (int bends = 0; bends <= 1; ++bends) {
                cd_chain* chain = scene_chain(3, 3, 1, precision);
                double v[12];
                ok(cd_chain_set_end(chain, CD_END_LAST, CD_NODE_PINNED));
                ok(cd_chain_set_mass(chain, 1e-60));
                ok(cd_chain_attach(chain, 0, 2, 1e60, 0, &target, 1));
                if (bends) ok(cd_chain_set_bend(chain, 1));
                for (size_t spring = 0; spring < 3; ++spring) ok(cd_chain_weld(chain, 0, spring));
                ok(cd_chain_set_method(chain, method));
                ok(cd_chain_step(chain, precision ? 1e30 : 1, 2));
                scene_read(chain, CD_VELOCITY, v);
                for (size_t i = 0; i < 12; ++i) assert_true(v[i] == 0);
                cd_chain_destroy(chain);
            }
}

static void the_mean_velocity_of_a_weld_does_not_overflow(void** state) {
    (void)state;
    static const double masses[] = {1, 1e60, 1e-60}, speeds[] = {1e300, 1.7e308, 1};
    for (size_t i = 0; i < COUNT(masses); ++i)
        for (size_t j = 0; j < COUNT(speeds); ++j) {
            cd_chain* chain = scene_chain(1, 1, 1, CD_FLOAT64);
            double v[2] = {speeds[j], -speeds[j]};
            ok(cd_chain_set_mass(chain, masses[i]));
            ok(cd_chain_write_f64(chain, CD_VELOCITY, 0, 1, 0, 2, v, 2));
            ok(cd_chain_weld(chain, 0, 0));
            ok(cd_chain_read_f64(chain, CD_VELOCITY, 0, 1, 0, 2, v, 2));
            assert_true(v[0] == 0 && v[1] == 0);
            cd_chain_destroy(chain);
        }
}

static void targets_are_never_taken_from_a_diverged_state(void** state) {
    (void)state;
    double dt;
    const double target[COMPONENTS] = {0, 0};
    cd_chain* chain = unstable(2, &dt);
    assert_int_equal(cd_chain_step(chain, dt, 5000), CD_ERROR_DIVERGED);
    refuses(chain, cd_chain_enable_field(chain, CD_TARGET), CD_ERROR_DIVERGED, "");
    refuses(chain, cd_chain_attach(chain, 0, 3, 1, 0, NULL, 0), CD_ERROR_DIVERGED, "");
    refuses(chain, cd_chain_attach(chain, 0, 3, 1, 0, target, COMPONENTS), CD_ERROR_DIVERGED, "");
    ok(cd_chain_reset(chain));
    ok(cd_chain_attach(chain, 0, 3, 1, 0, NULL, 0));
    ok(cd_chain_step(chain, dt / 8, 1));
    cd_chain_destroy(chain);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_finite_strands_of_a_diverged_chain_are_as_ever),
        cmocka_unit_test(what_is_pinned_is_still_in_a_diverged_chain),
        cmocka_unit_test(no_infinite_state_goes_without_a_status),
        cmocka_unit_test(what_is_welded_to_a_pinned_node_does_not_diverge),
        cmocka_unit_test(the_mean_velocity_of_a_weld_does_not_overflow),
        cmocka_unit_test(targets_are_never_taken_from_a_diverged_state),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
