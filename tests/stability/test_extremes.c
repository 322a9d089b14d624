/* Sizes, steps, masses and springs far from ordinary: as exact as ordinary ones. */
#include <float.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "agreement.h"
#include "check.h"

enum { NODES = 200 };

/* Random springs and masses of about `spring` and 1, and a random state. */
static struct reference* ordinary(double spring, uint64_t seed) {
    struct reference* r = reference_create(NODES);
    for (size_t i = 0; i < NODES; ++i) {
        r->mass[i] = exp2(random_number(&seed));
        r->stretch[i] = spring * exp2(random_number(&seed));
        r->x[i] = random_number(&seed);
        r->v[i] = random_number(&seed);
    }
    return r;
}

/* All implicit methods in both precisions; takes the scene away. */
static int missed_by_any(const char* name, double value, struct reference* r, double dt) {
    int missed = 0;
    char what[80];
    snprintf(what, sizeof what, "%s %.0e", name, value);
    for (int p = 0; p < 2; ++p)
        for (size_t m = LAMBDA_1_2; m < TIME_STEPS; ++m)
            missed += misses(what, r, p ? CD_FLOAT64 : CD_FLOAT32, &time_steps[m], dt,
                             p ? float64_limits : float32_limits);
    reference_destroy(r);
    return missed;
}

static void steps_from_1e_9_to_1e6_seconds_are_exact(void** state) {
    (void)state;
    int missed = 0;
    for (double dt = 1e-9; dt < 2e6; dt *= 1e3) missed += missed_by_any("dt", dt, ordinary(100, 1), dt);
    assert_int_equal(missed, 0);
}

static void one_light_or_heavy_node_among_a_million_times_others_is_exact(void** state) {
    (void)state;
    int missed = 0;
    for (double factor = 1e-6; factor < 2e6; factor *= 1e12) {
        struct reference* r = ordinary(1e4, 2);
        r->mass[NODES / 3] = factor;
        missed += missed_by_any("mass of one node", factor, r, 1.0 / 60);
    }
    assert_int_equal(missed, 0);
}

static void one_spring_1e12_times_its_neighbours_is_exact(void** state) {
    (void)state;
    int missed = 0;
    for (double factor = 1e-12; factor < 2e12; factor *= 1e24) {
        struct reference* r = ordinary(100, 3);
        r->stretch[NODES / 3] = 100 * factor;
        missed += missed_by_any("one spring", factor, r, 1.0 / 60);
    }
    assert_int_equal(missed, 0);
}

/* ---- sizes ------------------------------------------------------------------------------------------------------- */

/* Two nodes are one oscillator, omega^2 = k (1 / m_0 + 1 / m_1), about a centre that moves on. */
static void one_and_two_nodes_move_in_closed_form(void** state) {
    (void)state;
    for (size_t m = 0; m < TIME_STEPS; ++m)
        for (int p = 0; p < 2; ++p) {
            const double allowed = p ? 1e-10 : 1e-4, dt = time_steps[m].grows ? 0.01 : 0.1;
            cd_chain* chain = NULL;
            double x[2] = {0.25, -1}, v[2] = {2, 0.5};
            ok(cd_chain_create(1, 0, 1, p ? CD_FLOAT64 : CD_FLOAT32, NULL, &chain));
            set_time_step(chain, &time_steps[m]);
            ok(cd_chain_write_f64(chain, CD_VELOCITY, 0, 1, 0, 1, v, 1));
            ok(cd_chain_step(chain, dt, 1000));
            ok(cd_chain_read_f64(chain, CD_POSITION, 0, 1, 0, 1, x, 1));
            assert_near(x[0], 2 * 1000 * dt, allowed, 0);
            cd_chain_destroy(chain);

            x[0] = 0.25;
            const double mass[2] = {1, 3};
            const long double omega = sqrtl(1 + 1 / 3.0L), d0 = x[1] - x[0], w0 = v[1] - v[0];
            const double centre = (x[0] + 3 * x[1]) / 4, drift = (v[0] + 3 * v[1]) / 4;
            ok(cd_chain_create(1, 1, 1, p ? CD_FLOAT64 : CD_FLOAT32, NULL, &chain));
            set_time_step(chain, &time_steps[m]);
            ok(cd_chain_enable_field(chain, CD_MASS));
            ok(cd_chain_write_f64(chain, CD_MASS, 0, 1, 0, 2, mass, 2));
            ok(cd_chain_write_f64(chain, CD_POSITION, 0, 1, 0, 2, x, 2));
            ok(cd_chain_write_f64(chain, CD_VELOCITY, 0, 1, 0, 2, v, 2));
            ok(cd_chain_step(chain, dt, 1000));
            ok(cd_chain_read_f64(chain, CD_POSITION, 0, 1, 0, 2, x, 2));
            const struct matrix2 g = matrix_power(step_matrix(&time_steps[m], dt, omega, 0), 1000);
            const double stretch = (double)(g.a[0][0] * d0 + g.a[0][1] * w0);
            assert_near((x[0] + 3 * x[1]) / 4, centre + drift * 1000 * dt, allowed, 1);
            assert_near(x[1] - x[0], stretch, allowed, 10);
            cd_chain_destroy(chain);
        }
}

/* An impulse in the middle of a chain as long as memory is cheap: figure 2's shape, and momentum. */
static void a_very_long_chain(size_t nodes, cd_precision precision) {
    const double s = 50, mass = 1.0 / (double)nodes, root = sqrt(1 + 4 * s), q = 2 * s / (1 + 2 * s + root);
    const double dt = sqrt(s * mass / (double)(nodes - 1));
    double v[201], momentum;
    cd_chain* chain = NULL;
    ok(cd_chain_create(1, nodes - 1, 1, precision, NULL, &chain));
    ok(cd_chain_set_lambda(chain, 1));
    ok(cd_chain_impulse(chain, 0, nodes / 2, &mass, 1));
    ok(cd_chain_step(chain, dt, 1));
    ok(cd_chain_read_f64(chain, CD_VELOCITY, 0, 1, nodes / 2 - 100, 201, v, 201));
    double error = 0;
    for (size_t i = 0; i < 201; ++i) error = fmax(error, fabs(v[i] * root - pow(q, fabs((double)i - 100))));
    ok(cd_chain_get_momentum(chain, &momentum, 1));
    ok(cd_chain_step(chain, dt, 10));
    double later, kinetic, elastic;
    ok(cd_chain_get_momentum(chain, &later, 1));
    ok(cd_chain_get_energy(chain, &kinetic, &elastic, NULL));
    print_message("%zu nodes, float%d: figure 2 to %.1e, momentum to %.1e and %.1e\n", nodes,
                  precision == CD_FLOAT32 ? 32 : 64, error, fabs(momentum / mass - 1), fabs(later / mass - 1));
    assert_true(error <= (precision == CD_FLOAT32 ? 1e-5 : 1e-12));
    assert_true(fabs(momentum / mass - 1) <= (precision == CD_FLOAT32 ? 1e-5 : 1e-12));
    assert_true(fabs(later / mass - 1) <= (precision == CD_FLOAT32 ? 1e-5 : 1e-12));
    assert_true(isfinite(kinetic + elastic) && kinetic + elastic <= mass / 2);
    cd_chain_destroy(chain);
}

static void a_million_nodes_are_as_exact_as_few(void** state) {
    (void)state;
    a_very_long_chain(1000000, CD_FLOAT32);
    a_very_long_chain(1000001, CD_FLOAT64);
    if (is_long()) a_very_long_chain(10000000, CD_FLOAT32);
}

/* ---- time -------------------------------------------------------------------------------------------------------- */

/* One mode over a million steps, against its closed form; and a chain that drifts, whose centre stays on its line. */
static void a_million_steps_do_not_drift(void** state) {
    (void)state;
    enum { FEW = 12, MANY = 1000000 };
    const struct lattice_chain l = {.ends = FREE_FREE, .nodes = FEW, .mass = 1.3, .stiffness = 0.7};
    const long double omega = lattice_omega(&l, 3);
    const double dt = 1.0 / 64;
    for (int p = 0; p < 2; ++p) {
        double x[FEW], v[FEW], centre = 0, error = 0, speed = 0;
        cd_chain* chain = make_lattice_chain(&l, 1, 1, p ? CD_FLOAT64 : CD_FLOAT32);
        for (size_t i = 0; i < FEW; ++i) x[i] = (double)lattice_shape(&l, 3, i), v[i] = 0;
        ok(cd_chain_write_f64(chain, CD_POSITION, 0, 1, 0, FEW, x, FEW));
        ok(cd_chain_step(chain, dt, MANY));
        ok(cd_chain_read_f64(chain, CD_POSITION, 0, 1, 0, FEW, x, FEW));
        ok(cd_chain_read_f64(chain, CD_VELOCITY, 0, 1, 0, FEW, v, FEW));
        const struct matrix2 g = matrix_power(step_matrix(&time_steps[LAMBDA_1_2], dt, omega, 0), MANY);
        double amplitude = 0;
        for (size_t i = 0; i < FEW; ++i) {
            centre += x[i] / FEW;
            speed += v[i] / FEW;
            error = fmax(error, fabs(x[i] - (double)(g.a[0][0] * lattice_shape(&l, 3, i))));
            amplitude = fmax(amplitude, hypot(x[i], v[i] / (double)omega));
        }
        print_message("float%d: after a million steps the mode is off by %.1e, its amplitude %.6f, the centre %.1e and "
                      "%.1e per s\n",
                      p ? 64 : 32, error, amplitude / fabs((double)lattice_shape(&l, 3, 0)), centre, speed);
        if (p) assert_true(error <= 1e-8);
        assert_true(fabs(amplitude / fabs((double)lattice_shape(&l, 3, 0)) - 1) <= (p ? 1e-9 : 1e-2));
        assert_true(fabs(speed) <= (p ? 1e-12 : 1e-4));
        cd_chain_destroy(chain);
    }
}

/* Decaying for a million steps ends in numbers that are 0 or ordinary, never subnormal: those would make a step many
 * times slower. */
static void a_decayed_chain_holds_no_subnormal_numbers(void** state) {
    (void)state;
    enum { FEW = 8, MANY = 1000000 };
    for (int p = 0; p < 2; ++p)
        for (int bend = 0; bend < 2; ++bend)
            for (size_t m = 0; m < TIME_STEPS; ++m) {
                cd_chain* chain = NULL;
                double x[FEW], v[FEW], dt, last = 0;
                ok(cd_chain_create(1, FEW - 1, 1, p ? CD_FLOAT64 : CD_FLOAT32, NULL, &chain));
                set_time_step(chain, &time_steps[m]);
                ok(cd_chain_set_end(chain, CD_END_FIRST, CD_NODE_PINNED));
                if (bend) ok(cd_chain_set_bend(chain, 1e-3));
                ok(cd_chain_set_drag(chain, 2));
                ok(cd_chain_stable_dt(chain, &dt));
                /* what forward Euler adds, omega^2 dt / 2, stays below half of what drag takes away */
                dt = time_steps[m].grows ? fmin(0.8 * dt, dt * dt / 8) : 0.8 * dt;
                uint64_t seed = 9;
                for (size_t i = 0; i < FEW; ++i) x[i] = i ? random_number(&seed) : 0;
                ok(cd_chain_write_f64(chain, CD_POSITION, 0, 1, 0, FEW, x, FEW));
                for (size_t made = 0; made < MANY;) {
                    /* looks often while numbers shrink: 400 e-foldings in float32, 2000 in float64 */
                    const size_t count = made < MANY / 10 ? 500 : MANY / 10;
                    ok(cd_chain_step(chain, dt, count));
                    made += count;
                    ok(cd_chain_read_f64(chain, CD_POSITION, 0, 1, 0, FEW, x, FEW));
                    ok(cd_chain_read_f64(chain, CD_VELOCITY, 0, 1, 0, FEW, v, FEW));
                    last = 0;
                    for (size_t i = 0; i < FEW; ++i) {
                        assert_true(x[i] == 0 || fabs(x[i]) >= (p ? DBL_MIN : FLT_MIN));
                        assert_true(v[i] == 0 || fabs(v[i]) >= (p ? DBL_MIN : FLT_MIN));
                        last = fmax(last, fmax(fabs(x[i]), fabs(v[i])));
                    }
                }
                if (!(last < (p ? 1e-100 : 1e-15)))
                    print_message("float%d bend %d %s dt %.1e: still %.1e\n", p ? 64 : 32, bend, time_steps[m].name, dt,
                                  last);
                assert_true(last < (p ? 1e-100 : 1e-15));
                cd_chain_destroy(chain);
            }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(steps_from_1e_9_to_1e6_seconds_are_exact),
        cmocka_unit_test(one_light_or_heavy_node_among_a_million_times_others_is_exact),
        cmocka_unit_test(one_spring_1e12_times_its_neighbours_is_exact),
        cmocka_unit_test(one_and_two_nodes_move_in_closed_form),
        cmocka_unit_test(a_million_nodes_are_as_exact_as_few),
        cmocka_unit_test(a_million_steps_do_not_drift),
        cmocka_unit_test(a_decayed_chain_holds_no_subnormal_numbers),
    };
    return cmocka_run_group_tests_name("extremes", tests, NULL, NULL);
}
