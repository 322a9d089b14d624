/* Kernels chosen by hand: what can be chosen, what is refused, and what a choice does not touch. */
#include "check.h"
#include "cloth.h"
#include "kernels.h"
#include "pool.h"
#include "scene.h"

static int is_runnable(cd_kernels kernels) { return (int)(cd_runnable_kernels() >> kernels & 1); }

static cd_kernels fastest(void) {
    cd_kernels last = CD_KERNELS_PLAIN;
    FOR_RUNNABLE(kernels) last = kernels;
    return last;
}

static void plain_kernels_run_everywhere_and_all_have_names(void** state) {
    (void)state;
    assert_true(is_runnable(CD_KERNELS_PLAIN));
    assert_int_equal(cd_runnable_kernels() >> (CD_KERNELS_AVX512 + 1), 0);
    assert_int_not_equal(cd_kernels_name(CD_KERNELS_PLAIN)[0], 0);
    assert_string_equal(cd_kernels_name(CD_KERNELS_AVX2), "AVX2");
    assert_string_equal(cd_kernels_name(CD_KERNELS_AVX512), "AVX-512");
    assert_string_equal(cd_kernels_name(-1), "unknown");
    assert_string_equal(cd_kernels_name(3), "unknown");
    print_message("runnable: 0x%x, plain ones are %s\n", cd_runnable_kernels(), cd_kernels_name(CD_KERNELS_PLAIN));
}

/* One of the three kinds: `make` gives an object that moves. */
#define KIND(kind, make, dt)                                                                      \
    static cd_kernels kernels_of_##kind(const cd_##kind* object) {                                \
        cd_kernels kernels = -1;                                                                  \
        ok(cd_##kind##_get_kernels(object, &kernels));                                            \
        return kernels;                                                                           \
    }                                                                                             \
                                                                                                  \
    static void any_runnable_kernels_can_be_chosen_for_a_##kind(void** state) {                   \
        (void)state;                                                                              \
        cd_##kind* object = make;                                                                 \
        assert_int_equal(kernels_of_##kind(object), fastest());                                   \
        for (cd_kernels kernels = CD_KERNELS_AVX512; kernels >= CD_KERNELS_PLAIN; --kernels) {    \
            const cd_kernels before = kernels_of_##kind(object);                                  \
            if (is_runnable(kernels)) ok(cd_##kind##_set_kernels(object, kernels));               \
            else                                                                                  \
                refuses(object, cd_##kind##_set_kernels(object, kernels), CD_ERROR_UNSUPPORTED,   \
                        text_of("kernels|%d|%s", kernels, cd_kernels_name(kernels)));             \
            assert_int_equal(kernels_of_##kind(object), is_runnable(kernels) ? kernels : before); \
        }                                                                                         \
        refuses(object, cd_##kind##_set_kernels(object, 3), CD_ERROR_ENUM, "kernels|3");          \
        assert_int_equal(kernels_of_##kind(object), CD_KERNELS_PLAIN);                            \
        cd_##kind##_destroy(object);                                                              \
    }                                                                                             \
                                                                                                  \
    /* Changed between steps, with what steps prepared kept. */                                   \
    static void a_##kind##_may_change_kernels_as_it_moves(void** state) {                         \
        (void)state;                                                                              \
        cd_##kind *object = make, *other = make;                                                  \
        uint64_t factorizations, of_other;                                                        \
        for (int step = 0; step < 4; ++step) {                                                    \
            FOR_RUNNABLE(kernels) {                                                               \
                ok(cd_##kind##_set_kernels(object, kernels));                                     \
                ok(cd_##kind##_step(object, dt, 1));                                              \
                ok(cd_##kind##_step(other, dt, 1));                                               \
            }                                                                                     \
        }                                                                                         \
        assert_int_equal(hash_of(object), hash_of(other));                                        \
        ok(cd_##kind##_get_factorizations(object, &factorizations));                              \
        ok(cd_##kind##_get_factorizations(other, &of_other));                                     \
        assert_int_equal(factorizations, of_other);                                               \
                                                                                                  \
        /* no part of the state */                                                                \
        ok(cd_##kind##_set_kernels(object, CD_KERNELS_PLAIN));                                    \
        assert_int_equal(hash_of(object), hash_of(other));                                        \
        ok(cd_##kind##_copy_state(object, other));                                                \
        assert_int_equal(kernels_of_##kind(object), CD_KERNELS_PLAIN);                            \
        assert_int_equal(kernels_of_##kind(other), fastest());                                    \
        cd_##kind##_destroy(object);                                                              \
        cd_##kind##_destroy(other);                                                               \
    }

static cd_membrane* torn(void) {
    cd_membrane* membrane = cloth(18, 11, 3, CD_FLOAT32);
    cloth_torn(membrane);
    ok(cd_membrane_set_solver(membrane, CD_SOLVER_COUPLED)); /* the one whose levels know the kernels too */
    return membrane;
}
static cd_chain* any_chain(void) {
    cd_chain* chain = scene_chain(3, 12, 3, CD_FLOAT32);
    scenes[0].build(chain);
    return chain;
}

KIND(chain, any_chain(), 0.01)
KIND(membrane, torn(), 0.01)
KIND(water, pool_of(3, 18, 11, CD_FLOAT64, 1), pools[3].dt)

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(plain_kernels_run_everywhere_and_all_have_names),
        cmocka_unit_test(any_runnable_kernels_can_be_chosen_for_a_chain),
        cmocka_unit_test(any_runnable_kernels_can_be_chosen_for_a_membrane),
        cmocka_unit_test(any_runnable_kernels_can_be_chosen_for_a_water),
        cmocka_unit_test(a_chain_may_change_kernels_as_it_moves),
        cmocka_unit_test(a_membrane_may_change_kernels_as_it_moves),
        cmocka_unit_test(a_water_may_change_kernels_as_it_moves),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
