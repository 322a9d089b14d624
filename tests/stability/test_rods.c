/* Bend stiffness over mass from 1e-12 to 1e30: as exact as at 1, and a rod, however stiff, moves as a free body
 * does. */
#include <math.h>
#include <stdio.h>

#include "agreement.h"
#include "check.h"

static const double ratios[] = {1e-12, 1, 1e4, 1e8, 1e12, 1e20, 1e30};

/* Masses of about 1, bend of about `ratio`, springs of about `spring`, at random; random positions and velocities. */
static struct reference* make(size_t nodes, double ratio, double spring, int pinned) {
    struct reference* r = reference_create(nodes);
    uint64_t seed = 4;
    for (size_t i = 0; i < nodes; ++i) {
        r->mass[i] = exp2(random_number(&seed));
        r->stretch[i] = spring * exp2(random_number(&seed));
        r->bend[i] = ratio * exp2(random_number(&seed));
        r->x[i] = random_number(&seed);
        r->v[i] = random_number(&seed);
    }
    if (pinned) r->mass[nodes / 3] = INFINITY;
    return r;
}

static struct limits limits_of(cd_precision precision) {
    return precision == CD_FLOAT32 ? float32_rod_limits : float64_rod_limits;
}

/* The reference's own digits go with n^4: a long rod for float32, a short one for float64. */
static int missed_in(cd_precision precision, double dt) {
    const size_t nodes = precision == CD_FLOAT32 ? 200 : 30;
    int missed = 0;
    for (size_t k = 0; k < COUNT(ratios); ++k)
        for (int stretch = 0; stretch < 2; ++stretch)
            for (int pinned = 0; pinned < 2; ++pinned)
                for (size_t m = LAMBDA_1_2; m < TIME_STEPS; ++m) {
                    if (!is_taken(k + (size_t)stretch + (size_t)pinned + m, 2)) continue;
                    char what[80];
                    snprintf(what, sizeof what, "dt %.0e bend over mass %-5.0e%s%s", dt, ratios[k],
                             stretch ? " with springs" : "", pinned ? " pinned" : "");
                    struct reference* r = make(nodes, ratios[k], stretch ? 100 : 0, pinned);
                    missed += misses(what, r, precision, &time_steps[m], dt, limits_of(precision));
                    reference_destroy(r);
                }
    return missed;
}

static void float32_rods_agree_with_extended_precision(void** state) {
    (void)state;
    assert_int_equal(missed_in(CD_FLOAT32, 1.0 / 60), 0);
}

static void float64_rods_agree_with_extended_precision(void** state) {
    (void)state;
    assert_int_equal(missed_in(CD_FLOAT64, 1.0 / 60), 0);
}

static void rods_agree_at_tiny_steps(void** state) {
    (void)state;
    assert_int_equal(missed_in(CD_FLOAT32, 1e-9) + missed_in(CD_FLOAT64, 1e-9), 0);
}

static void rods_agree_at_huge_steps(void** state) {
    (void)state;
    assert_int_equal(missed_in(CD_FLOAT32, 1e6) + missed_in(CD_FLOAT64, 1e6), 0);
}

/* Straight, and turning about a point that moves: x_i and v_i linear in i, which nothing opposes. */
static void a_free_rod_keeps_its_straight_motion_however_stiff(void** state) {
    (void)state;
    int missed = 0;
    for (double bend = 1; bend < 1e31; bend *= 1e10)
        for (int p = 0; p < 2; ++p)
            for (size_t m = LAMBDA_1_2; m < TIME_STEPS; ++m) {
                enum { NODES = 64 };
                struct reference* r = reference_create(NODES);
                for (size_t i = 0; i < NODES; ++i) {
                    r->mass[i] = 1.0L / NODES;
                    r->stretch[i] = 0;
                    r->bend[i] = bend / NODES;
                    r->x[i] = 3 - (long double)i / 64;
                    r->v[i] = -0.25L + (long double)i / 256;
                }
                char what[80];
                snprintf(what, sizeof what, "straight rod, bend over mass %.0e", bend);
                const cd_precision precision = p ? CD_FLOAT64 : CD_FLOAT32;
                missed += misses(what, r, precision, &time_steps[m], 1.0 / 60, limits_of(precision));
                cd_chain* chain = chain_like(r, precision);
                double before, after;
                set_time_step(chain, &time_steps[m]);
                ok(cd_chain_get_momentum(chain, &before, 1));
                ok(cd_chain_step(chain, 1.0 / 60, 1000));
                ok(cd_chain_get_momentum(chain, &after, 1));
                /* of the momentum of the two halves, which move against each other */
                assert_near(before, after, p ? 1e-11 : 1e-4, 0.25);
                cd_chain_destroy(chain);
                reference_destroy(r);
            }
    assert_int_equal(missed, 0);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(float32_rods_agree_with_extended_precision),
        cmocka_unit_test(float64_rods_agree_with_extended_precision),
        cmocka_unit_test(rods_agree_at_tiny_steps),
        cmocka_unit_test(rods_agree_at_huge_steps),
        cmocka_unit_test(a_free_rod_keeps_its_straight_motion_however_stiff),
    };
    return cmocka_run_group_tests_name("rods", tests, NULL, NULL);
}
