/* Implicit steps with lambda >= 1/2 never gain energy, whatever the stiffness and the step; divergence is reported. */
#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "check.h"
#include "modes.h"
#include "reference.h"

enum { NODES = 40 };

static double energy_of(const cd_chain* chain) {
    double kinetic, elastic;
    ok(cd_chain_get_energy(chain, &kinetic, &elastic, NULL));
    return kinetic + elastic;
}

/* Springs from 1e-6 to 1e12, masses within a factor 1e4, all at random; by turns a plain chain, a ring, a hanging
 * chain, a rod held at both ends, a damped chain. None drifts away: far from the origin stretches are known to few
 * digits. */
enum kind { PLAIN, CLOSED, HANGING, ROD, DAMPED, KINDS };

static cd_chain* make_wild(cd_precision precision, enum kind kind, uint64_t seed) {
    cd_chain* chain = NULL;
    double mass[NODES], values[NODES], momentum = 0, total = 0;
    ok(cd_chain_create(1, NODES - 1, 1, precision, NULL, &chain));
    if (kind == CLOSED) ok(cd_chain_set_ring(chain, 1));
    ok(cd_chain_enable_field(chain, CD_MASS));
    for (size_t i = 0; i < NODES; ++i) mass[i] = pow(10, 2 * random_number(&seed));
    ok(cd_chain_write_f64(chain, CD_MASS, 0, 1, 0, NODES, mass, NODES));
    ok(cd_chain_enable_field(chain, CD_STIFFNESS));
    const size_t springs = kind == CLOSED ? NODES : NODES - 1;
    for (size_t i = 0; i < springs; ++i) values[i] = pow(10, 3 + 9 * random_number(&seed));
    ok(cd_chain_write_f64(chain, CD_STIFFNESS, 0, 1, 0, springs, values, springs));
    if (kind == HANGING || kind == ROD) ok(cd_chain_set_end(chain, CD_END_FIRST, CD_NODE_PINNED));
    if (kind == ROD) {
        ok(cd_chain_set_end(chain, CD_END_LAST, CD_NODE_PINNED));
        ok(cd_chain_enable_field(chain, CD_BEND));
        for (size_t i = 0; i < NODES; ++i) values[i] = pow(10, 3 + 9 * random_number(&seed));
        ok(cd_chain_write_f64(chain, CD_BEND, 0, 1, 1, NODES - 2, values, NODES - 2));
    }
    if (kind == DAMPED) {
        ok(cd_chain_set_drag(chain, pow(10, 3 * random_number(&seed))));
        ok(cd_chain_set_stiffness_damping(chain, pow(10, 3 * random_number(&seed))));
    }
    for (size_t i = 0; i < NODES; ++i) values[i] = random_number(&seed);
    ok(cd_chain_write_f64(chain, CD_POSITION, 0, 1, 0, NODES, values, NODES));
    for (size_t i = 0; i < NODES; ++i) values[i] = random_number(&seed);
    for (size_t i = 0; i < NODES; ++i) momentum += mass[i] * values[i], total += mass[i];
    for (size_t i = 0; i < NODES; ++i) values[i] -= momentum / total;
    if (kind == HANGING || kind == ROD) values[0] = 0;
    if (kind == ROD) values[NODES - 1] = 0;
    ok(cd_chain_write_f64(chain, CD_VELOCITY, 0, 1, 0, NODES, values, NODES));
    return chain;
}

static void implicit_steps_never_gain_energy_at_any_stiffness_and_step(void** state) {
    (void)state;
    for (int p = 0; p < 2; ++p) {
        double worst = 0;
        unsigned kind = 0;
        for (size_t m = LAMBDA_1_2; m < TIME_STEPS; ++m)
            for (double dt = 1e-6; dt < 2e6; dt *= 10)
                for (int repeat = 0; repeat < 5; ++repeat, ++kind) {
                    cd_chain* chain = make_wild(p ? CD_FLOAT64 : CD_FLOAT32, (enum kind)(kind % KINDS), 1000 + kind);
                    set_time_step(chain, &time_steps[m]);
                    const double start = energy_of(chain);
                    double highest = 0;
                    for (int k = 0; k < 20; ++k) {
                        ok(cd_chain_step(chain, dt, 50));
                        highest = fmax(highest, energy_of(chain) / start);
                    }
                    worst = fmax(worst, highest);
                    if (!(highest <= 1 + (p ? 1e-9 : 1e-3)))
                        print_message("%s dt %.0e kind %u float%d: energy x %.9g\n", time_steps[m].name, dt,
                                      kind % KINDS, p ? 64 : 32, highest);
                    assert_true(highest <= 1 + (p ? 1e-9 : 1e-3));
                    cd_chain_destroy(chain);
                }
        print_message("float%d: highest energy over the starting energy 1 %+.1e\n", p ? 64 : 32, worst - 1);
    }
}

/* "... step 175 ..." or the like: the number as a word of its own. */
static int names_step(const char* message, uint64_t step) {
    char number[32];
    const size_t length = (size_t)snprintf(number, sizeof number, "%llu", (unsigned long long)step);
    for (const char* at = strstr(message, number); at; at = strstr(at + 1, number))
        if (!isdigit((unsigned char)at[length]) && (at == message || !isdigit((unsigned char)at[-1]))) return 1;
    print_error("step %s is missing in: %s\n", number, message);
    return 0;
}

/* Steps far too long for an explicit method: the first one whose numbers leave the range is found by stepping one at a
 * time, and a whole run reports the same one. */
static void divergence_is_reported_with_its_step_and_the_chain_works_again(void** state) {
    (void)state;
    static const double dt = 1;
    for (int p = 0; p < 2; ++p)
        for (int m = 0; m < 2; ++m)
            for (int bend = 0; bend < 2; ++bend) {
                cd_chain* chain = NULL;
                ok(cd_chain_create(1, NODES - 1, 1, p ? CD_FLOAT64 : CD_FLOAT32, NULL, &chain));
                ok(cd_chain_set_method(chain, m ? CD_METHOD_SYMPLECTIC_EULER : CD_METHOD_FORWARD_EULER));
                if (bend) ok(cd_chain_set_bend(chain, 0.1));
                double x[NODES] = {0}, v[NODES] = {0};
                x[NODES / 2] = 1;
                ok(cd_chain_write_f64(chain, CD_POSITION, 0, 1, 0, NODES, x, NODES));
                uint64_t first = 0, steps = 0;
                while (cd_chain_step(chain, dt, 1) == CD_OK) assert_true(++first < 10000);
                ++first;
                assert_int_equal(cd_chain_step(chain, dt, 1), CD_ERROR_DIVERGED);
                ok(cd_chain_read_f64(chain, CD_POSITION, 0, 1, 0, NODES, x, NODES));
                ok(cd_chain_read_f64(chain, CD_VELOCITY, 0, 1, 0, NODES, v, NODES));
                int finite = 1;
                for (size_t i = 0; i < NODES; ++i) finite &= isfinite(x[i]) && isfinite(v[i]);
                assert_false(finite);

                ok(cd_chain_reset(chain));
                memset(x, 0, sizeof x);
                x[NODES / 2] = 1;
                ok(cd_chain_write_f64(chain, CD_POSITION, 0, 1, 0, NODES, x, NODES));
                assert_int_equal(cd_chain_step(chain, dt, 2000), CD_ERROR_DIVERGED);
                assert_true(names_step(cd_error_message(), first));
                ok(cd_chain_get_steps(chain, &steps));
                assert_int_equal(steps, 2000);

                ok(cd_chain_reset(chain));
                x[NODES / 2] = 1;
                ok(cd_chain_write_f64(chain, CD_POSITION, 0, 1, 0, NODES, x, NODES));
                ok(cd_chain_set_method(chain, CD_METHOD_IMPLICIT));
                ok(cd_chain_step(chain, dt, 100));
                assert_true(isfinite(energy_of(chain)));
                cd_chain_destroy(chain);
            }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(implicit_steps_never_gain_energy_at_any_stiffness_and_step),
        cmocka_unit_test(divergence_is_reported_with_its_step_and_the_chain_works_again),
    };
    return cmocka_run_group_tests_name("implicit", tests, NULL, NULL);
}
