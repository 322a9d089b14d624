/* Rings, and chains held at both ends, of random masses, springs and bends: against extended precision as far as the
 * reference has digits for them (reference.h); at any stiffness the uniform ones are in test_lattices.c. Rings that fall
 * to pieces: their energy. */
#include <math.h>
#include <stdio.h>

#include "agreement.h"
#include "check.h"

enum { NODES = 60, MOST_NODES = 12 };
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
            if (!is_taken((size_t)kind / 2 + k, 2)) continue;
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

/* The energy of a ring of `nodes` after one step over that before it. Each spring is cut or not at random, so that pieces
 * of the ring turn about each other, held by bend alone. */
static double gained_energy(size_t nodes, double lambda, double dt, uint64_t seed) {
    double x[MOST_NODES], v[MOST_NODES], stiffness[MOST_NODES], momentum = 0, before[2], after[2];
    cd_chain* ring = NULL;
    for (size_t i = 0; i < nodes; ++i) {
        x[i] = random_number(&seed);
        momentum += v[i] = random_number(&seed);
        stiffness[i] = random_number(&seed) > -0.2 ? 0 : (double)nodes;
    }
    for (size_t i = 0; i < nodes; ++i) v[i] -= momentum / (double)nodes;
    ok(cd_chain_create(1, nodes - 1, 1, CD_FLOAT64, NULL, &ring));
    ok(cd_chain_set_ring(ring, 1));
    ok(cd_chain_set_bend(ring, 0.1));
    ok(cd_chain_set_lambda(ring, lambda));
    ok(cd_chain_enable_field(ring, CD_STIFFNESS));
    ok(cd_chain_write_f64(ring, CD_STIFFNESS, 0, 1, 0, nodes, stiffness, nodes));
    ok(cd_chain_write_f64(ring, CD_POSITION, 0, 1, 0, nodes, x, nodes));
    ok(cd_chain_write_f64(ring, CD_VELOCITY, 0, 1, 0, nodes, v, nodes));
    ok(cd_chain_get_energy(ring, &before[0], &before[1], NULL));
    ok(cd_chain_step(ring, dt, 1));
    ok(cd_chain_get_energy(ring, &after[0], &after[1], NULL));
    cd_chain_destroy(ring);
    return (after[0] + after[1]) / (before[0] + before[1]);
}

static void pieces_of_a_ring_gain_no_energy_in_steps_of_any_length(void** state) {
    (void)state;
    double worst[2] = {0, 0};
    for (int damped = 0; damped < 2; ++damped)
        for (double dt = 1; dt < 1e9; dt *= 1.7)
            for (uint64_t seed = 1; seed <= 300; ++seed) {
                const double gained = gained_energy(3 + seed % 10, damped ? 1 : 0.5, dt, seed);
                assert_true(isfinite(gained));
                worst[damped] = fmax(worst[damped], gained);
            }
    print_message("energy of rings after a step, at most: %.5f (lambda 1/2), %.5f (1)\n", worst[0], worst[1]);
    assert_true(worst[0] < 1.02);
    assert_true(worst[1] < 1);
}

static double log_uniform(double least, double most, uint64_t* seed) {
    return least * pow(most / least, (random_number(seed) + 1) / 2);
}

/* The most that 20 steps of lambda = 1/2 gain: energy over that at the start, less 1. A ring of springs of any stiffness,
 * some of them cut, so that pieces hang by soft springs, ties and held nodes; no bend. */
static double gained_by_springs(uint64_t seed) {
    const size_t nodes = 3 + (size_t)((random_number(&seed) + 1) * 4.5);
    const double most = log_uniform(1e-3, 1e8, &seed), dt = log_uniform(1e-4, 1e12, &seed);
    double before[2], after[2], gained = 0;
    cd_chain* ring = NULL;
    ok(cd_chain_create(1, nodes - 1, 1, CD_FLOAT64, NULL, &ring));
    ok(cd_chain_set_ring(ring, 1));
    ok(cd_chain_set_mass(ring, log_uniform(1e-3, 1e3, &seed)));
    ok(cd_chain_enable_field(ring, CD_STIFFNESS));
    for (size_t i = 0; i < nodes; ++i) {
        const double x = random_number(&seed), kind = random_number(&seed), any = log_uniform(1e-6, 1e9, &seed);
        const double stiffness = kind < -0.6 ? 0 : kind < -0.1 ? any : most;
        ok(cd_chain_write_f64(ring, CD_POSITION, 0, 1, i, 1, &x, 1));
        ok(cd_chain_write_f64(ring, CD_STIFFNESS, 0, 1, i, 1, &stiffness, 1));
        if (random_number(&seed) < 0.7) continue;
        const double target = random_number(&seed);
        ok(cd_chain_attach(ring, 0, i, log_uniform(1e-4, 1e8, &seed), 0, &target, 1));
    }
    if (random_number(&seed) < 0) ok(cd_chain_set_end(ring, CD_END_FIRST, CD_NODE_PINNED));
    if (random_number(&seed) < -0.6) ok(cd_chain_set_end(ring, CD_END_LAST, CD_NODE_PINNED));
    ok(cd_chain_get_energy(ring, &before[0], &before[1], NULL));
    for (int step = 0; step < 20 && before[1] > 0; ++step) {
        ok(cd_chain_step(ring, dt, 1));
        ok(cd_chain_get_energy(ring, &after[0], &after[1], NULL));
        gained = fmax(gained, (after[0] + after[1]) / (before[0] + before[1]) - 1);
    }
    cd_chain_destroy(ring);
    return gained;
}

static void rings_of_springs_keep_their_energy_in_steps_of_any_length(void** state) {
    (void)state;
    double worst = 0;
    for (uint64_t seed = 1; seed <= 20000; ++seed) worst = fmax(worst, gained_by_springs(seed * 7919));
    print_message("energy gained by rings of springs, at most: %.1e\n", worst);
    assert_true(worst < 1e-9);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(float32_rings_and_held_chains_agree_with_extended_precision),
        cmocka_unit_test(float64_rings_and_held_chains_agree_with_extended_precision),
        cmocka_unit_test(pieces_of_a_ring_gain_no_energy_in_steps_of_any_length),
        cmocka_unit_test(rings_of_springs_keep_their_energy_in_steps_of_any_length),
    };
    return cmocka_run_group_tests_name("closed", tests, NULL, NULL);
}
