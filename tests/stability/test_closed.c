/* Rings, and chains held at both ends, of random masses, springs and bends: against extended precision as far as the
 * reference has digits for them (reference.h); at any stiffness the uniform ones are in test_lattices.c. */
#include <math.h>
#include <stdio.h>

#include "agreement.h"
#include "check.h"

enum { NODES = 60 };
enum { HELD = 1, BENT = 2, DAMPED = 4, WELDED = 8, TIED = 16, KINDS = 32 };

static struct reference* make(double ratio, int kind, uint64_t seed) {
    struct reference* r = reference_create(NODES);
    r->ring = !(kind & HELD);
    for (size_t i = 0; i < NODES; ++i) {
        r->mass[i] = exp2(random_number(&seed));
        r->stretch[i] = ratio * exp2(random_number(&seed));
        r->bend[i] = kind & BENT ? ratio * exp2(random_number(&seed)) : 0;
        r->x[i] = random_number(&seed);
        r->v[i] = random_number(&seed);
    }
    if (kind & HELD) r->mass[0] = r->mass[NODES - 1] = INFINITY;
    if (kind & DAMPED) r->drag = 0.3L, r->stiffness_damping = 1e-3L;
    if (kind & WELDED) {
        for (size_t i = 5; i < NODES; i += 9) r->stretch[i] = INFINITY;
        r->stretch[12] = 0;
    }
    if (kind & TIED) r->anchor_stiffness[20] = ratio, r->anchor_damping[30] = 2, r->target[20] = 0.5L;
    return r;
}

static int missed(cd_precision precision) {
    static const double ratios[] = {1e-12, 1, 1e4, 1e8};
    int count = 0;
    for (int kind = 0; kind < KINDS; ++kind)
        for (size_t k = 0; k < COUNT(ratios); ++k) {
            const size_t m = LAMBDA_1_2 + ((size_t)kind + k) % (TIME_STEPS - LAMBDA_1_2);
            char what[100];
            snprintf(what, sizeof what, "k/m %.0e %s%s%s%s%s", ratios[k], kind & HELD ? "held" : "ring",
                     kind & BENT ? ", bent" : "", kind & DAMPED ? ", damped" : "", kind & WELDED ? ", welded" : "",
                     kind & TIED ? ", tied" : "");
            struct reference* r = make(ratios[k], kind, 7);
            /* a ring is closed by the rods' solver */
            count += misses(what, r, precision, &time_steps[m], 1.0 / 60,
                            precision == CD_FLOAT32 ? float32_rod_limits : float64_rod_limits);
            reference_destroy(r);
        }
    return count;
}

static void float32_rings_and_held_chains_agree_with_extended_precision(void** state) {
    (void)state;
    assert_int_equal(missed(CD_FLOAT32), 0);
}

static void float64_rings_and_held_chains_agree_with_extended_precision(void** state) {
    (void)state;
    assert_int_equal(missed(CD_FLOAT64), 0);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(float32_rings_and_held_chains_agree_with_extended_precision),
        cmocka_unit_test(float64_rings_and_held_chains_agree_with_extended_precision),
    };
    return cmocka_run_group_tests_name("closed", tests, NULL, NULL);
}
