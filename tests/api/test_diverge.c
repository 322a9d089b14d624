/* A state that leaves the finite range is reported, with the step; the chain can be read, reset and used again. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "check.h"
#include "scene.h"

enum { STRANDS = 20, SPRINGS = 9, NODES = SPRINGS + 1, COMPONENTS = 2, ALL = STRANDS * NODES * COMPONENTS };

/* An explicit chain beyond its limit. Three strands move, far apart; the one in the middle
 * diverges first. */
static cd_chain* unstable(cd_precision precision, cd_method method, double* out_dt) {
    cd_chain* chain = scene_chain(STRANDS, SPRINGS, COMPONENTS, precision);
    ok(cd_chain_set_method(chain, method));
    const double v[COMPONENTS] = {1, -1}, less[COMPONENTS] = {1e-9, 1e-9};
    ok(cd_chain_write_f64(chain, CD_VELOCITY, STRANDS / 2, 1, 4, 1, v, COMPONENTS));
    ok(cd_chain_write_f64(chain, CD_VELOCITY, 0, 1, 4, 1, less, COMPONENTS));
    ok(cd_chain_write_f64(chain, CD_VELOCITY, STRANDS - 1, 1, 4, 1, less, COMPONENTS));
    ok(cd_chain_stable_dt(chain, out_dt));
    *out_dt *= 2;
    return chain;
}

static int is_finite(const cd_chain* chain) {
    double x[ALL], v[ALL];
    scene_read(chain, CD_POSITION, x);
    scene_read(chain, CD_VELOCITY, v);
    for (size_t i = 0; i < ALL; ++i)
        if (!isfinite(x[i]) || !isfinite(v[i])) return 0;
    return 1;
}

static const struct {
    cd_precision precision;
    cd_method method;
} cases[] = {{CD_FLOAT32, CD_METHOD_SYMPLECTIC_EULER},
             {CD_FLOAT64, CD_METHOD_SYMPLECTIC_EULER},
             {CD_FLOAT32, CD_METHOD_FORWARD_EULER},
             {CD_FLOAT64, CD_METHOD_FORWARD_EULER}};

static void divergence_is_reported_with_the_first_bad_step(void** state) {
    (void)state;
    for (size_t i = 0; i < COUNT(cases); ++i) {
        double dt;
        cd_chain* slow = unstable(cases[i].precision, cases[i].method, &dt);
        uint64_t first_bad = 0, steps;
        while (is_finite(slow)) {
            const cd_status status = cd_chain_step(slow, dt, 1);
            ++first_bad;
            assert_int_equal(status, is_finite(slow) ? CD_OK : CD_ERROR_DIVERGED);
        }
        assert_true(first_bad > 10);
        assert_non_null(strstr(cd_error_message(), text_of(" %llu", (unsigned long long)first_bad)));
        cd_chain_destroy(slow);

        cd_chain* fast = unstable(cases[i].precision, cases[i].method, &dt);
        ok(cd_chain_step(fast, dt, 5));
        assert_int_equal(cd_chain_step(fast, dt, 5000), CD_ERROR_DIVERGED);
        assert_non_null(strstr(cd_error_message(), "cd_chain_step: "));
        const char* shown = strstr(cd_error_message(), text_of(" %llu", (unsigned long long)first_bad));
        assert_non_null(shown); /* counted from create, not from this call */
        ok(cd_chain_get_steps(fast, &steps));
        assert_int_equal(steps, 5005); /* all steps are made */
        assert_false(is_finite(fast));
        cd_chain_destroy(fast);
    }
}

static void the_finite_strands_of_a_diverged_chain_are_as_ever(void** state) {
    (void)state;
    double dt, v[2 * NODES * COMPONENTS];
    cd_chain* chain = unstable(CD_FLOAT32, CD_METHOD_SYMPLECTIC_EULER, &dt);
    assert_int_equal(cd_chain_step(chain, dt, 5000), CD_ERROR_DIVERGED);
    ok(cd_chain_read_f64(chain, CD_VELOCITY, 1, 2, 0, NODES, v, COUNT(v)));
    for (size_t i = 0; i < COUNT(v); ++i) assert_true(v[i] == 0);
    cd_chain_destroy(chain);
}

static void what_is_pinned_is_still_in_a_diverged_chain(void** state) {
    (void)state;
    for (size_t i = 0; i < COUNT(cases); ++i) {
        double dt, v[ALL];
        cd_chain* chain = unstable(cases[i].precision, cases[i].method, &dt);
        ok(cd_chain_set_end(chain, CD_END_FIRST, CD_NODE_PINNED));
        assert_int_equal(cd_chain_step(chain, dt, 100000), CD_ERROR_DIVERGED);
        scene_read(chain, CD_VELOCITY, v);
        for (size_t s = 0; s < STRANDS; ++s)
            for (size_t k = 0; k < COMPONENTS; ++k) assert_true(v[s * NODES * COMPONENTS + k] == 0);
        cd_chain_destroy(chain);
    }
}

static void a_diverged_chain_makes_no_step_and_changes_nothing(void** state) {
    (void)state;
    for (size_t i = 0; i < COUNT(cases); ++i) {
        double dt;
        cd_chain* chain = unstable(cases[i].precision, cases[i].method, &dt);
        assert_int_equal(cd_chain_step(chain, dt, 5000), CD_ERROR_DIVERGED);
        refuses(chain, cd_chain_step(chain, dt, 1), CD_ERROR_DIVERGED, "");
        ok(cd_chain_set_method(chain, CD_METHOD_IMPLICIT));
        refuses(chain, cd_chain_step(chain, dt, 1), CD_ERROR_DIVERGED, "");
        cd_chain_destroy(chain);
    }
}

static void a_diverged_chain_is_as_new_after_a_reset(void** state) {
    (void)state;
    for (size_t i = 0; i < COUNT(cases); ++i) {
        double dt, unused;
        cd_chain* chain = unstable(cases[i].precision, cases[i].method, &dt);
        cd_chain* fresh = unstable(cases[i].precision, cases[i].method, &unused);
        assert_int_equal(cd_chain_step(chain, dt, 5000), CD_ERROR_DIVERGED);
        ok(cd_chain_reset(chain));
        ok(cd_chain_reset(fresh));
        assert_int_equal(hash_of(chain), hash_of(fresh));
        scene_lay_out(chain, 0.1);
        scene_lay_out(fresh, 0.1);
        ok(cd_chain_step(chain, dt / 8, 20));
        ok(cd_chain_step(fresh, dt / 8, 20));
        assert_int_equal(hash_of(chain), hash_of(fresh));
        cd_chain_destroy(chain);
        cd_chain_destroy(fresh);
    }
}

static void a_diverged_chain_goes_on_once_finite_numbers_are_written(void** state) {
    (void)state;
    for (size_t i = 0; i < COUNT(cases); ++i) {
        double dt, zeros[ALL] = {0};
        cd_chain* chain = unstable(cases[i].precision, cases[i].method, &dt);
        assert_int_equal(cd_chain_step(chain, dt, 5000), CD_ERROR_DIVERGED);
        scene_write(chain, CD_POSITION, zeros);
        refuses(chain, cd_chain_step(chain, dt, 1), CD_ERROR_DIVERGED, ""); /* velocities are still wrong */
        scene_write(chain, CD_VELOCITY, zeros);
        ok(cd_chain_step(chain, dt, 3));
        assert_true(is_finite(chain));
        cd_chain_destroy(chain);
    }
}

static void a_diverged_chain_goes_on_after_a_load_or_a_copy(void** state) {
    (void)state;
    for (size_t i = 0; i < COUNT(cases); ++i) {
        for (int by_copy = 0; by_copy <= 1; ++by_copy) {
            double dt, unused;
            cd_chain* chain = unstable(cases[i].precision, cases[i].method, &dt);
            cd_chain* good = unstable(cases[i].precision, cases[i].method, &unused);
            size_t size, written;
            ok(cd_chain_step(good, dt / 8, 7));
            ok(cd_chain_save_size(good, &size));
            unsigned char* bytes = malloc(size);
            assert_non_null(bytes);
            ok(cd_chain_save(good, bytes, size, &written));
            assert_int_equal(cd_chain_step(chain, dt, 5000), CD_ERROR_DIVERGED);
            if (by_copy) ok(cd_chain_copy_state(chain, good));
            else ok(cd_chain_load(chain, bytes, size));
            ok(cd_chain_step(chain, dt / 8, 20));
            ok(cd_chain_step(good, dt / 8, 20));
            assert_int_equal(hash_of(chain), hash_of(good));
            free(bytes);
            cd_chain_destroy(chain);
            cd_chain_destroy(good);
        }
    }
}

static void a_diverged_state_can_be_kept_and_stays_diverged(void** state) {
    (void)state;
    for (int by_copy = 0; by_copy <= 1; ++by_copy) {
        double dt, unused;
        cd_chain* chain = unstable(CD_FLOAT32, CD_METHOD_SYMPLECTIC_EULER, &dt);
        cd_chain* other = unstable(CD_FLOAT32, CD_METHOD_SYMPLECTIC_EULER, &unused);
        assert_int_equal(cd_chain_step(chain, dt, 5000), CD_ERROR_DIVERGED);
        size_t size, written;
        ok(cd_chain_save_size(chain, &size));
        unsigned char* bytes = malloc(size);
        assert_non_null(bytes);
        ok(cd_chain_save(chain, bytes, size, &written));
        if (by_copy) ok(cd_chain_copy_state(other, chain));
        else ok(cd_chain_load(other, bytes, size));
        assert_int_equal(hash_of(other), hash_of(chain));
        refuses(other, cd_chain_step(other, dt, 1), CD_ERROR_DIVERGED, "");
        free(bytes);
        cd_chain_destroy(chain);
        cd_chain_destroy(other);
    }
}

static void a_chain_within_the_limit_never_diverges(void** state) {
    (void)state;
    for (cd_precision precision = CD_FLOAT32; precision <= CD_FLOAT64; ++precision) {
        double dt;
        cd_chain* chain = unstable(precision, CD_METHOD_SYMPLECTIC_EULER, &dt);
        ok(cd_chain_step(chain, dt * 0.499, 20000));
        ok(cd_chain_set_method(chain, CD_METHOD_IMPLICIT));
        ok(cd_chain_step(chain, dt * 1e6, 20000));
        assert_true(is_finite(chain));
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
    cd_chain* chain = unstable(CD_FLOAT32, CD_METHOD_FORWARD_EULER, &dt);
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
        cmocka_unit_test(divergence_is_reported_with_the_first_bad_step),
        cmocka_unit_test(the_finite_strands_of_a_diverged_chain_are_as_ever),
        cmocka_unit_test(what_is_pinned_is_still_in_a_diverged_chain),
        cmocka_unit_test(a_diverged_chain_makes_no_step_and_changes_nothing),
        cmocka_unit_test(a_diverged_chain_is_as_new_after_a_reset),
        cmocka_unit_test(a_diverged_chain_goes_on_once_finite_numbers_are_written),
        cmocka_unit_test(a_diverged_chain_goes_on_after_a_load_or_a_copy),
        cmocka_unit_test(a_diverged_state_can_be_kept_and_stays_diverged),
        cmocka_unit_test(a_chain_within_the_limit_never_diverges),
        cmocka_unit_test(no_infinite_state_goes_without_a_status),
        cmocka_unit_test(what_is_welded_to_a_pinned_node_does_not_diverge),
        cmocka_unit_test(the_mean_velocity_of_a_weld_does_not_overflow),
        cmocka_unit_test(targets_are_never_taken_from_a_diverged_state),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
