/* Stiffness over mass from 1e-12 to 1e30 and infinity: as exact as at 1. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "agreement.h"
#include "check.h"

enum { NODES = 1001 };
static const double dt = 1.0 / 60;
static const double ratios[] = {1e-12, 1e-6, 1, 1e4, 1e6, 1e8, 1e12, 1e16, 1e22, 1e30, INFINITY};
static const size_t pins[] = {NODES, 0, NODES / 2};
static const char* const pin_names[] = {"free", "pinned at an end", "pinned inside"};

/* At random: positions and velocities. Kicked: drawn together, and with random velocities that cancel. An undamped
 * chain keeps the energy of random positions, and 1000 steps of lambda = 1/2 turn it into velocities of up to
 * 4000 x / dt, whose rounding alone shifts a free float32 chain by 1e-2 (see limits); one that was kicked keeps to 1e-4
 * with no such excuse. */
enum start { AT_RANDOM, KICKED };

/* Masses and springs at random within a factor 4, `ratio` a spring's stiffness over a node's mass. */
static struct reference* make(double ratio, size_t pinned, enum start start) {
    struct reference* r = reference_create(NODES);
    uint64_t seed = 17;
    long double total = 0, momentum = 0;
    for (size_t i = 0; i < NODES; ++i) {
        r->mass[i] = exp2(random_number(&seed)) / NODES;
        r->stretch[i] = ratio * exp2(random_number(&seed)) / NODES;
        r->x[i] = start == AT_RANDOM ? random_number(&seed) : 0;
        r->v[i] = random_number(&seed);
        total += r->mass[i];
        momentum += r->mass[i] * r->v[i];
    }
    for (size_t i = 0; i < NODES && start == KICKED; ++i) r->v[i] -= momentum / total;
    if (pinned < NODES) r->mass[pinned] = INFINITY;
    return r;
}

static void sweep(cd_precision precision, enum start start) {
    struct limits limits = precision == CD_FLOAT32 ? float32_limits : float64_limits;
    if (precision == CD_FLOAT32 && start == KICKED) limits.slack = 0;
    int missed = 0;
    for (size_t k = 0; k < COUNT(ratios); ++k)
        for (size_t p = 0; p < COUNT(pins); ++p)
            for (size_t m = LAMBDA_1_2; m < TIME_STEPS; ++m) {
                if (m == LAMBDA_3_4 || !is_taken(k + p + m, 3)) continue;
                char what[80];
                snprintf(what, sizeof what, "k/m %-5.0e %s", ratios[k], pin_names[p]);
                struct reference* r = make(ratios[k], pins[p], start);
                missed += misses(what, r, precision, &time_steps[m], dt, limits);
                reference_destroy(r);
            }
    assert_int_equal(missed, 0);
}

static void float32_from_a_random_state_agrees_with_extended_precision(void** state) {
    (void)state;
    sweep(CD_FLOAT32, AT_RANDOM);
}

static void float64_from_a_random_state_agrees_with_extended_precision(void** state) {
    (void)state;
    sweep(CD_FLOAT64, AT_RANDOM);
}

static void float32_after_a_kick_agrees_with_extended_precision(void** state) {
    (void)state;
    sweep(CD_FLOAT32, KICKED);
}

static void float64_after_a_kick_agrees_with_extended_precision(void** state) {
    (void)state;
    sweep(CD_FLOAT64, KICKED);
}

/* Each of these with something more than springs and masses. */
static void with(const char* name, void (*change)(struct reference* r, double ratio), enum start start) {
    int missed = 0;
    for (size_t k = 0; k < COUNT(ratios); ++k)
        for (size_t m = LAMBDA_1_2; m < TIME_STEPS; ++m) {
            if (!is_taken(k + m, 3)) continue;
            char what[80];
            snprintf(what, sizeof what, "k/m %-5.0e %s", ratios[k], name);
            struct reference* r = make(ratios[k], NODES, start);
            change(r, ratios[k]);
            missed += misses(what, r, CD_FLOAT32, &time_steps[m], dt, float32_limits);
            reference_destroy(r);
        }
    assert_int_equal(missed, 0);
}

static void damp(struct reference* r, double ratio) {
    (void)ratio;
    r->drag = 0.2L;
    r->stiffness_damping = 0.01L;
}

static void damped_chains_agree_with_extended_precision(void** state) {
    (void)state;
    with("damped", damp, AT_RANDOM);
}

static void weld_and_cut(struct reference* r, double ratio) {
    (void)ratio;
    for (size_t i = 4; i + 1 < NODES; i += 5) r->stretch[i] = INFINITY;
    for (size_t i = 96; i + 1 < NODES; i += 97) r->stretch[i] = 0;
}

static void welds_and_cuts_among_stiff_springs_agree_with_extended_precision(void** state) {
    (void)state;
    with("with welds and cuts", weld_and_cut, KICKED);
}

/* Springs from 1e-12 to the ratio, at random in their logarithm. */
static void scatter(struct reference* r, double ratio) {
    uint64_t seed = 23;
    if (isinf(ratio)) return;
    for (size_t i = 0; i + 1 < NODES; ++i) {
        const double part = 0.5 + random_number(&seed) / 2;
        r->stretch[i] = pow(10, -12 + part * (log10(ratio) + 12)) / NODES;
    }
}

static void scattered_stiffness_agrees_with_extended_precision(void** state) {
    (void)state;
    with("and all below it", scatter, AT_RANDOM);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(float32_from_a_random_state_agrees_with_extended_precision),
        cmocka_unit_test(float64_from_a_random_state_agrees_with_extended_precision),
        cmocka_unit_test(float32_after_a_kick_agrees_with_extended_precision),
        cmocka_unit_test(float64_after_a_kick_agrees_with_extended_precision),
        cmocka_unit_test(damped_chains_agree_with_extended_precision),
        cmocka_unit_test(welds_and_cuts_among_stiff_springs_agree_with_extended_precision),
        cmocka_unit_test(scattered_stiffness_agrees_with_extended_precision),
    };
    return cmocka_run_group_tests_name("stiff", tests, NULL, NULL);
}
