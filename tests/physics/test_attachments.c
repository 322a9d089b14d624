/* A node tied to a target by a spring with damping, as a mouse drag does. */
#include <math.h>
#include <stdio.h>

#include "agreement.h"
#include "check.h"

/* One node alone on its spring: x'' + (c / m + drag) x' + (k / m) (x - target) = 0. */
static double lone_node_error(const struct time_step* step, cd_precision precision, double z, double damping,
                              double drag) {
    const double mass = 0.4, stiffness = 9, target = 2, omega = sqrt(stiffness / mass), dt = z / omega;
    const double x0 = target + 1, v0 = 0.5 * omega;
    const unsigned long steps = 1000;
    cd_chain* chain = NULL;
    double x, v;
    ok(cd_chain_create(1, 0, 1, precision, NULL, &chain));
    set_time_step(chain, step);
    ok(cd_chain_set_mass(chain, mass));
    ok(cd_chain_set_drag(chain, drag));
    ok(cd_chain_attach(chain, 0, 0, stiffness, damping, &target, 1));
    ok(cd_chain_write_f64(chain, CD_POSITION, 0, 1, 0, 1, &x0, 1));
    ok(cd_chain_write_f64(chain, CD_VELOCITY, 0, 1, 0, 1, &v0, 1));
    ok(cd_chain_step(chain, dt, steps));
    ok(cd_chain_read_f64(chain, CD_POSITION, 0, 1, 0, 1, &x, 1));
    ok(cd_chain_read_f64(chain, CD_VELOCITY, 0, 1, 0, 1, &v, 1));
    cd_chain_destroy(chain);
    const struct matrix2 g = matrix_power(
        step_matrix(step, dt, sqrtl((long double)stiffness / mass), (long double)damping / mass + drag), steps);
    const long double xn = g.a[0][0] * (x0 - target) + g.a[0][1] * v0;
    const long double vn = g.a[1][0] * (x0 - target) + g.a[1][1] * v0;
    const long double size = fmaxl(2, hypotl(xn, vn / omega));
    return (double)fmaxl(fabsl(x - target - xn), fabsl(v - vn) / omega) / (double)size;
}

static void a_lone_node_swings_on_its_spring_in_closed_form(void** state) {
    (void)state;
    static const double zs[] = {0.02, 0.1, 1.5, 30};
    for (int p = 0; p < 2; ++p)
        for (size_t m = 0; m < TIME_STEPS; ++m) {
            double worst = 0;
            for (size_t k = 0; k < COUNT(zs); ++k) {
                if (time_steps[m].grows && zs[k] > 0.1) continue;
                if (time_steps[m].is_explicit && zs[k] > 2) continue;
                for (int damped = 0; damped < 4; ++damped)
                    worst = fmax(worst, lone_node_error(&time_steps[m], p ? CD_FLOAT64 : CD_FLOAT32, zs[k],
                                                        damped & 1 ? 0.02 : 0, damped & 2 ? 0.03 : 0));
            }
            print_message("float%d %-16s: lone node to %.1e\n", p ? 64 : 32, time_steps[m].name, worst);
            assert_true(worst <= (p ? 1e-10 : 1e-4));
        }
}

/* A chain whose every node is tied alike swings in its own modes with omega^2 + k / m. */
static void a_chain_tied_everywhere_swings_faster_by_the_known_amount(void** state) {
    (void)state;
    enum { NODES = 40, MODE = 7, STEPS = 1000 };
    const struct lattice_chain l = {.ends = FREE_FREE, .nodes = NODES, .mass = 2, .stiffness = 3};
    const double tie = 5, node_mass = l.mass / NODES;
    for (size_t m = 0; m < TIME_STEPS; ++m)
        for (int bend = 0; bend < 2; ++bend) {
            cd_chain* chain = make_lattice_chain(&l, 1, 1, CD_FLOAT64);
            set_time_step(chain, &time_steps[m]);
            /* bend that does not act takes the other line solver */
            if (bend) ok(cd_chain_set_bend(chain, 1e-30));
            double x[NODES];
            const double zero = 0;
            for (size_t i = 0; i < NODES; ++i) {
                x[i] = (double)lattice_shape(&l, MODE, i);
                ok(cd_chain_attach(chain, 0, i, tie, 0, &zero, 1));
            }
            ok(cd_chain_write_f64(chain, CD_POSITION, 0, 1, 0, NODES, x, NODES));
            const long double own = lattice_omega(&l, MODE), omega = sqrtl(own * own + (long double)tie / node_mass);
            const double dt = (time_steps[m].grows ? 0.05 : 0.3) / (double)omega;
            ok(cd_chain_step(chain, dt, STEPS));
            ok(cd_chain_read_f64(chain, CD_POSITION, 0, 1, 0, NODES, x, NODES));
            const struct matrix2 g = matrix_power(step_matrix(&time_steps[m], dt, omega, 0), STEPS);
            const double size = fmax(1, (double)hypotl(g.a[0][0], g.a[1][0] / omega));
            for (size_t i = 0; i < NODES; ++i)
                assert_near(x[i], (double)(g.a[0][0] * lattice_shape(&l, MODE, i)), 1e-10, size);
            cd_chain_destroy(chain);
        }
}

/* Moving the target and the chain with it changes nothing; a node let go again is as if it had never been tied. */
static void a_moved_target_moves_the_motion_and_a_loosened_node_is_free(void** state) {
    (void)state;
    enum { NODES = 20 };
    for (size_t m = 0; m < TIME_STEPS; ++m) {
        double x[2][NODES], dt;
        for (int moved = 0; moved < 2; ++moved) {
            const double shift = moved ? 16 : 0;
            cd_chain* chain = NULL;
            ok(cd_chain_create(1, NODES - 1, 1, CD_FLOAT64, NULL, &chain));
            set_time_step(chain, &time_steps[m]);
            uint64_t seed = 6;
            for (size_t i = 0; i < NODES; ++i) x[moved][i] = shift + random_number(&seed);
            ok(cd_chain_write_f64(chain, CD_POSITION, 0, 1, 0, NODES, x[moved], NODES));
            ok(cd_chain_attach(chain, 0, 4, 20, 0.1, NULL, 1));
            ok(cd_chain_stable_dt(chain, &dt));
            dt *= time_steps[m].grows ? 0.05 : 0.5;
            ok(cd_chain_step(chain, dt, 100));
            const double target = shift + 3;
            ok(cd_chain_write_f64(chain, CD_TARGET, 0, 1, 4, 1, &target, 1));
            ok(cd_chain_step(chain, dt, 100));
            double before, after;
            ok(cd_chain_detach(chain, 0, 4));
            ok(cd_chain_get_momentum(chain, &before, 1));
            ok(cd_chain_step(chain, dt, 100));
            ok(cd_chain_get_momentum(chain, &after, 1));
            assert_near(before, after, 1e-12, 1);
            assert_true(fabs(before) > 1e-3);
            ok(cd_chain_read_f64(chain, CD_POSITION, 0, 1, 0, NODES, x[moved], NODES));
            cd_chain_destroy(chain);
        }
        for (size_t i = 0; i < NODES; ++i) assert_near(x[1][i] - 16, x[0][i], 1e-11, 1);
    }
}

/* Ties from loose to far stiffer than the chain, damped ones too, against extended precision. */
static void ties_of_any_stiffness_agree_with_extended_precision(void** state) {
    (void)state;
    enum { NODES = 100 };
    static const double stiffnesses[] = {1e-6, 1, 1e6, 1e12, 1e20};
    int missed = 0;
    for (size_t k = 0; k < COUNT(stiffnesses); ++k)
        for (int bend = 0; bend < 2; ++bend)
            for (size_t m = LAMBDA_1_2; m < TIME_STEPS; ++m)
                for (int p = 0; p < 2; ++p) {
                    struct reference* r = reference_create(NODES);
                    uint64_t seed = 12 + k;
                    for (size_t i = 0; i < NODES; ++i) {
                        r->x[i] = random_number(&seed);
                        r->v[i] = random_number(&seed);
                        r->mass[i] = 1.0L / NODES;
                        r->stretch[i] = NODES - 1;
                        if (bend) r->bend[i] = 1;
                    }
                    r->target[30] = r->target[60] = 0.25L;
                    r->anchor_stiffness[30] = stiffnesses[k];
                    r->anchor_stiffness[60] = 2;
                    r->anchor_damping[60] = 0.5L;
                    char what[80];
                    snprintf(what, sizeof what, "tie %.0e%s", stiffnesses[k], bend ? ", with bend" : "");
                    missed += misses(what, r, p ? CD_FLOAT64 : CD_FLOAT32, &time_steps[m], 1.0 / 64,
                                     p ? float64_limits : float32_limits);
                    reference_destroy(r);
                }
    assert_int_equal(missed, 0);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_lone_node_swings_on_its_spring_in_closed_form),
        cmocka_unit_test(a_chain_tied_everywhere_swings_faster_by_the_known_amount),
        cmocka_unit_test(a_moved_target_moves_the_motion_and_a_loosened_node_is_free),
        cmocka_unit_test(ties_of_any_stiffness_agree_with_extended_precision),
    };
    return cmocka_run_group_tests_name("attachments", tests, NULL, NULL);
}
