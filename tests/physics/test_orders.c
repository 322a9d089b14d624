/* Orders of accuracy, measured by halving the step and doubling the lattice. */
#include <math.h>
#include <stdlib.h>

#include "check.h"
#include "modes.h"

/* ---- in time: against the exact motion of the same lattice ------------------------------------------------------- */

enum { NODES = 12, HALVINGS = 6 };

/* x and v of x'' + c x' + omega^2 x = 0 at time t, from x0 and v0; c < 2 omega. */
static void swing(long double omega, long double c, long double t, long double x0, long double v0, long double* x,
                  long double* v) {
    const long double g = c / 2, w = sqrtl(omega * omega - g * g), decay = expl(-g * t);
    const long double s = sinl(w * t) / w, co = cosl(w * t);
    *x = decay * (x0 * (co + g * s) + v0 * s);
    *v = decay * (v0 * (co - g * s) - x0 * omega * omega * s);
}

/* Largest error in x and v at time 1 of a chain that swings in four modes. */
static double time_error(const struct lattice_chain* l, const struct time_step* step, size_t steps) {
    const size_t n = l->nodes;
    double x[NODES] = {0}, v[NODES] = {0};
    long double exact_x[NODES] = {0}, exact_v[NODES] = {0};
    for (size_t j = 1; j <= 4; ++j) {
        const long double omega = lattice_omega(l, j), c = l->drag + l->stiffness_damping * omega * omega;
        const long double x0 = 1.0L / (long double)j, v0 = j % 2 ? 1 : -1;
        long double xt, vt;
        swing(omega, c, 1, x0, v0, &xt, &vt);
        for (size_t i = 0; i < n; ++i) {
            const long double shape = lattice_shape(l, j, i);
            x[i] += (double)(x0 * shape);
            v[i] += (double)(v0 * shape);
            exact_x[i] += xt * shape;
            exact_v[i] += vt * shape;
        }
    }
    cd_chain* chain = make_lattice_chain(l, 1, 1, CD_FLOAT64);
    set_time_step(chain, step);
    ok(cd_chain_write_f64(chain, CD_POSITION, 0, 1, 0, n, x, n));
    ok(cd_chain_write_f64(chain, CD_VELOCITY, 0, 1, 0, n, v, n));
    ok(cd_chain_step(chain, 1 / (double)steps, steps));
    ok(cd_chain_read_f64(chain, CD_POSITION, 0, 1, 0, n, x, n));
    ok(cd_chain_read_f64(chain, CD_VELOCITY, 0, 1, 0, n, v, n));
    cd_chain_destroy(chain);
    double error = 0;
    for (size_t i = 0; i < n; ++i)
        error = fmax(error, fmax(fabs(x[i] - (double)exact_x[i]), fabs(v[i] - (double)exact_v[i])));
    return error;
}

static void check_time_order(const struct lattice_chain* l, const struct time_step* step) {
    const int order = step->lambda == 0.5 || step->method == CD_METHOD_STIFF_SECOND ? 2 : 1;
    size_t steps = 250;
    double error = time_error(l, step, steps), measured = 0, ratio = 0;
    for (int k = 1; k < HALVINGS; ++k) {
        const double finer = time_error(l, step, steps *= 2);
        ratio = error / finer;
        error = finer;
        measured = log2(ratio);
    }
    print_message("%-15s %-16s damped %d: order %.3f, error %.1e at dt = 1/%zu\n", lattice_names[l->ends], step->name,
                  l->drag > 0, measured, error, steps);
    assert_true(fabs(measured - order) < 0.05);
}

static void time_steps_have_orders_1_1_1_2_and_2(void** state) {
    (void)state;
    static const enum lattice lattices[] = {FREE_FREE, FIXED_FREE, RING, HINGED_BOTH};
    for (size_t k = 0; k < COUNT(lattices); ++k)
        for (int damped = 0; damped < 2; ++damped)
            for (size_t m = 0; m < TIME_STEPS; ++m) {
                const struct lattice_chain l = {.ends = lattices[k],
                                                .nodes = NODES,
                                                .mass = 1.5,
                                                .stiffness = 2,
                                                .bend = 0.001,
                                                .drag = damped ? 0.4 : 0,
                                                .stiffness_damping = damped ? 0.01 : 0};
                check_time_order(&l, &time_steps[m]);
            }
}

/* ---- in space: against d'Alembert's solution --------------------------------------------------------------------- */

/* A string of mass 1 and stiffness 1 with free, fixed or mixed ends, and the exact motion of its first modes. Time
 * error is kept 200 times smaller by lambda 1/2 at a twentieth of the time a wave takes from node to node. */
enum string_ends { BOTH_FREE, BOTH_FIXED, FIRST_FIXED };

static double string_shape(enum string_ends ends, int j, double s) {
    switch (ends) {
    case BOTH_FREE: return cos(j * (double)PI * s);
    case BOTH_FIXED: return sin(j * (double)PI * s);
    default: return sin((j - 0.5) * (double)PI * s);
    }
}

static double space_error(enum string_ends ends, cd_mass_rule rule, size_t springs) {
    const size_t nodes = springs + 1;
    const double time = 0.7;
    cd_chain* chain = NULL;
    ok(cd_chain_create(1, springs, 1, CD_FLOAT64, NULL, &chain));
    ok(cd_chain_set_mass_rule(chain, rule));
    if (ends != BOTH_FREE) ok(cd_chain_set_end(chain, CD_END_FIRST, CD_NODE_PINNED));
    if (ends == BOTH_FIXED) ok(cd_chain_set_end(chain, CD_END_LAST, CD_NODE_PINNED));
    double* x = calloc(nodes, sizeof *x);
    double* exact = calloc(nodes, sizeof *exact);
    assert_non_null(x);
    assert_non_null(exact);
    for (int j = 1; j <= 3; ++j) {
        const double omega = (ends == FIRST_FIXED ? j - 0.5 : j) * (double)PI;
        for (size_t i = 0; i < nodes; ++i) {
            const double s = (double)i / (double)springs, shape = string_shape(ends, j, s) / j;
            const int held = (i == 0 && ends != BOTH_FREE) || (i == springs && ends == BOTH_FIXED);
            x[i] += held ? 0 : shape;
            exact[i] += held ? 0 : shape * cos(omega * time);
        }
    }
    ok(cd_chain_write_f64(chain, CD_POSITION, 0, 1, 0, nodes, x, nodes));
    const size_t steps = 14 * springs;
    ok(cd_chain_step(chain, time / (double)steps, steps));
    ok(cd_chain_read_f64(chain, CD_POSITION, 0, 1, 0, nodes, x, nodes));
    cd_chain_destroy(chain);
    double error = 0;
    for (size_t i = 0; i < nodes; ++i) error = fmax(error, fabs(x[i] - exact[i]));
    free(x);
    free(exact);
    return error;
}

static void space_has_order_1_with_equal_masses_and_2_with_half_ends(void** state) {
    (void)state;
    static const char* const names[] = {"both ends free", "both fixed", "first fixed"};
    for (int ends = BOTH_FREE; ends <= FIRST_FIXED; ++ends)
        for (int half = 0; half < 2; ++half) {
            const cd_mass_rule rule = half ? CD_MASS_HALF_ENDS : CD_MASS_EQUAL;
            double error = 0, measured = 0;
            for (size_t springs = 64; springs <= 512; springs *= 2) {
                const double finer = space_error((enum string_ends)ends, rule, springs);
                measured = log2(error / finer);
                error = finer;
            }
            print_message("%-14s %-12s: order %.3f, error %.1e with 512 springs\n", names[ends],
                          half ? "half ends" : "equal masses", measured, error);
            assert_true(fabs(measured - (half ? 2 : 1)) < 0.05);
        }
}

/* Equal masses make waves sqrt((n + 1) / n) too fast: the error above is that and nothing else. */
static void equal_masses_are_fast_by_the_known_factor(void** state) {
    (void)state;
    for (size_t nodes = 11; nodes < 200; nodes = 2 * nodes - 1) {
        const struct lattice_chain equal = {.ends = FIXED_FIXED, .nodes = nodes, .mass = 1, .stiffness = 1};
        const struct lattice_chain half = {.ends = HALF_ENDS, .nodes = nodes, .mass = 1, .stiffness = 1};
        const double n = (double)nodes - 1;
        assert_near((double)(lattice_omega(&equal, 1) / lattice_omega(&half, 1)), sqrt((n + 1) / n), 1e-14, 0);
        cd_chain* chain = make_lattice_chain(&equal, 1, 1, CD_FLOAT64);
        double dt = 0, half_dt = 0;
        ok(cd_chain_stable_dt(chain, &dt));
        ok(cd_chain_set_mass_rule(chain, CD_MASS_HALF_ENDS));
        ok(cd_chain_stable_dt(chain, &half_dt));
        assert_near(half_dt / dt, sqrt((n + 1) / n), 1e-12, 0);
        cd_chain_destroy(chain);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(time_steps_have_orders_1_1_1_2_and_2),
        cmocka_unit_test(space_has_order_1_with_equal_masses_and_2_with_half_ends),
        cmocka_unit_test(equal_masses_are_fast_by_the_known_factor),
    };
    return cmocka_run_group_tests_name("orders", tests, NULL, NULL);
}
