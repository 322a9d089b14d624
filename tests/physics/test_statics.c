/* Constant forces: free fall and hanging ropes come out exactly, and stay so. */
#include <math.h>
#include <stdlib.h>

#include "check.h"
#include "modes.h"
#include "reference.h"

enum { NODES = 80, COMPONENTS = 2, NUMBERS = NODES * COMPONENTS };

/* A 60th of a second, less for a method that could not take it. */
static double usable_dt(const cd_chain* chain, const struct time_step* step) {
    double limit;
    ok(cd_chain_stable_dt(chain, &limit));
    if (step->grows) return 0.02 * limit;
    return step->is_explicit ? 0.9 * limit : 1.0 / 60;
}

/* After N steps of dt a fall from rest has covered g dt^2 (N^2 / 2 + (lambda - 1/2) N): the sum of (1 - lambda) v_old +
 * lambda v_new, with lambda = 0 and 1 for the forward and symplectic Euler steps; second order methods are exact. */
static void a_free_chain_falls_exactly(void** state) {
    (void)state;
    const double g[COMPONENTS] = {-9.81, 0.5}, n = 600;
    for (int p = 0; p < 2; ++p)
        for (int bend = 0; bend < 2; ++bend)
            for (size_t m = 0; m < TIME_STEPS; ++m) {
                const struct time_step* step = &time_steps[m];
                double lambda = step->lambda;
                if (step->method == CD_METHOD_SYMPLECTIC_EULER) lambda = 1;
                if (step->method == CD_METHOD_STIFF_SECOND) lambda = 0.5;
                cd_chain* chain = NULL;
                ok(cd_chain_create(1, NODES - 1, COMPONENTS, p ? CD_FLOAT64 : CD_FLOAT32, NULL, &chain));
                set_time_step(chain, step);
                ok(cd_chain_set_gravity(chain, g, COMPONENTS));
                if (bend) ok(cd_chain_set_bend(chain, 1e-3));
                const double dt = usable_dt(chain, step);
                ok(cd_chain_step(chain, dt, (size_t)n));
                double x[NUMBERS], v[NUMBERS];
                ok(cd_chain_read_f64(chain, CD_POSITION, 0, 1, 0, NODES, x, NUMBERS));
                ok(cd_chain_read_f64(chain, CD_VELOCITY, 0, 1, 0, NODES, v, NUMBERS));
                for (size_t i = 0; i < NUMBERS; ++i) {
                    const double a = g[i % COMPONENTS], allowed = p ? 1e-12 : 1e-4;
                    assert_near(v[i], a * n * dt, allowed, 0);
                    assert_near(x[i], a * dt * dt * (n * n / 2 + (lambda - 0.5) * n), allowed, 0);
                }
                cd_chain_destroy(chain);
            }
}

static void drag_makes_a_falling_chain_reach_its_final_speed(void** state) {
    (void)state;
    const double g[1] = {-9.81}, drag = 2;
    for (size_t m = 0; m < TIME_STEPS; ++m) {
        cd_chain* chain = NULL;
        double v[NODES];
        ok(cd_chain_create(1, NODES - 1, 1, CD_FLOAT64, NULL, &chain));
        set_time_step(chain, &time_steps[m]);
        ok(cd_chain_set_gravity(chain, g, 1));
        ok(cd_chain_set_drag(chain, drag));
        /* so short that drag wins over what forward Euler adds to rounding errors */
        const double dt = usable_dt(chain, &time_steps[m]) * (time_steps[m].grows ? 0.2 : 1);
        ok(cd_chain_step(chain, dt, (size_t)(20 / dt)));
        ok(cd_chain_read_f64(chain, CD_VELOCITY, 0, 1, 0, NODES, v, NODES));
        for (size_t i = 0; i < NODES; ++i) assert_near(v[i], g[0] / drag, 1e-9, 0);
        cd_chain_destroy(chain);
    }
}

static void forces_change_the_momentum_by_force_times_time(void** state) {
    (void)state;
    for (size_t m = 0; m < TIME_STEPS; ++m) {
        cd_chain* chain = NULL;
        double f[NUMBERS], sum[COMPONENTS] = {0, 0}, momentum[COMPONENTS];
        uint64_t seed = 8;
        for (size_t i = 0; i < NUMBERS; ++i) sum[i % COMPONENTS] += f[i] = 0.3 + random_number(&seed);
        ok(cd_chain_create(1, NODES - 1, COMPONENTS, CD_FLOAT64, NULL, &chain));
        set_time_step(chain, &time_steps[m]);
        ok(cd_chain_enable_field(chain, CD_FORCE));
        ok(cd_chain_write_f64(chain, CD_FORCE, 0, 1, 0, NODES, f, NUMBERS));
        const double dt = usable_dt(chain, &time_steps[m]);
        ok(cd_chain_step(chain, dt, 500));
        ok(cd_chain_get_momentum(chain, momentum, COMPONENTS));
        for (size_t c = 0; c < COMPONENTS; ++c) assert_near(momentum[c], sum[c] * 500 * dt, 1e-12, 0);
        cd_chain_destroy(chain);
    }
}

/* Spring i carries every node below it: x_{i+1} - x_i = g (m_{i+1} + ... + m_n) / k_i. */
static cd_chain* make_hanging(double stiffness, cd_precision precision, int random, double* rest) {
    const double g = -9.81;
    double mass[NODES], spring[NODES];
    uint64_t seed = 5;
    for (size_t i = 0; i < NODES; ++i) {
        mass[i] = random ? exp(random_number(&seed)) : 2.0 / NODES;
        spring[i] = random ? stiffness * exp(2 * random_number(&seed)) : stiffness * (NODES - 1);
    }
    cd_chain* chain = NULL;
    ok(cd_chain_create(1, NODES - 1, 1, precision, NULL, &chain));
    ok(cd_chain_set_mass(chain, 2));
    ok(cd_chain_set_stiffness(chain, stiffness));
    ok(cd_chain_set_gravity(chain, &g, 1));
    ok(cd_chain_set_end(chain, CD_END_FIRST, CD_NODE_PINNED));
    if (random) {
        ok(cd_chain_enable_field(chain, CD_MASS));
        ok(cd_chain_enable_field(chain, CD_STIFFNESS));
        ok(cd_chain_write_f64(chain, CD_MASS, 0, 1, 0, NODES, mass, NODES));
        ok(cd_chain_write_f64(chain, CD_STIFFNESS, 0, 1, 0, NODES - 1, spring, NODES - 1));
    }
    long double below[NODES + 1] = {0};
    for (size_t i = NODES; i-- > 0;) below[i] = mass[i] + (i + 1 < NODES ? below[i + 1] : 0);
    long double x = 0;
    for (size_t i = 0; i < NODES; ++i) {
        rest[i] = (double)x;
        if (i + 1 < NODES) x += g * below[i + 1] / spring[i];
    }
    return chain;
}

static double distance_from(const cd_chain* chain, const double* rest) {
    double x[NODES], error = 0;
    ok(cd_chain_read_f64(chain, CD_POSITION, 0, 1, 0, NODES, x, NODES));
    for (size_t i = 0; i < NODES; ++i) error = fmax(error, fabs(x[i] - rest[i]));
    return error / fabs(rest[NODES - 1]);
}

static void a_rope_that_hangs_at_rest_stays_there(void** state) {
    (void)state;
    static const double stiffnesses[] = {1, 1e4, 1e20};
    for (int p = 0; p < 2; ++p)
        for (int random = 0; random < 2; ++random)
            for (size_t k = 0; k < COUNT(stiffnesses); ++k)
                for (size_t m = 0; m < TIME_STEPS; ++m) {
                    const struct time_step* step = &time_steps[m];
                    double rest[NODES];
                    cd_chain* chain = make_hanging(stiffnesses[k], p ? CD_FLOAT64 : CD_FLOAT32, random, rest);
                    set_time_step(chain, step);
                    ok(cd_chain_write_f64(chain, CD_POSITION, 0, 1, 0, NODES, rest, NODES));
                    ok(cd_chain_step(chain, usable_dt(chain, step), 2000));
                    const double error = distance_from(chain, rest);
                    if (!(error <= (p ? 1e-11 : 1e-4)))
                        print_message("float%d k %.0e random %d %s: %.2e\n", p ? 64 : 32, stiffnesses[k], random,
                                      step->name, error);
                    assert_true(error <= (p ? 1e-11 : 1e-4));
                    cd_chain_destroy(chain);
                }
}

static void a_rope_let_go_settles_where_it_hangs(void** state) {
    (void)state;
    static const double stiffnesses[] = {1, 1e4, 1e20};
    for (int p = 0; p < 2; ++p)
        for (int random = 0; random < 2; ++random)
            for (size_t k = 0; k < COUNT(stiffnesses); ++k)
                for (size_t m = LAMBDA_1; m <= STIFF_SECOND; ++m) {
                    double rest[NODES];
                    cd_chain* chain = make_hanging(stiffnesses[k], p ? CD_FLOAT64 : CD_FLOAT32, random, rest);
                    set_time_step(chain, &time_steps[m]);
                    ok(cd_chain_step(chain, 1000, 2000));
                    const double error = distance_from(chain, rest);
                    print_message("float%d k %.0e %s masses, %-12s: settles within %.1e\n", p ? 64 : 32,
                                  stiffnesses[k], random ? "random" : "equal", time_steps[m].name, error);
                    assert_true(error <= (p ? 1e-11 : 1e-4));
                    cd_chain_destroy(chain);
                }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_free_chain_falls_exactly),
        cmocka_unit_test(drag_makes_a_falling_chain_reach_its_final_speed),
        cmocka_unit_test(forces_change_the_momentum_by_force_times_time),
        cmocka_unit_test(a_rope_that_hangs_at_rest_stays_there),
        cmocka_unit_test(a_rope_let_go_settles_where_it_hangs),
    };
    return cmocka_run_group_tests_name("statics", tests, NULL, NULL);
}
