/* What holds a node: ends that echo and one that does not, driven nodes, and springs to a target. */
#include <math.h>
#include <stdlib.h>

#include "check.h"
#include "modes.h"
#include "reference.h"

/* ---- echoes ------------------------------------------------------------------------------------------------------ */

/* A string of mass 1 and stiffness 1: waves run along it in 1 s. */
static double pulse(double s) { return exp(-s * s / (2 * 0.05 * 0.05)); }
static double pulse_slope(double s) { return -s / (0.05 * 0.05) * pulse(s); }

/* Sends a pulse from the middle to an end and reads the largest displacement, with its sign, 1 s later, when an echo
 * would be back in the middle. */
static double echo(cd_end end, cd_node kind, size_t springs, cd_mass_rule rule, cd_precision precision) {
    const size_t nodes = springs + 1;
    cd_chain* chain = NULL;
    ok(cd_chain_create(1, springs, 1, precision, NULL, &chain));
    ok(cd_chain_set_mass_rule(chain, rule));
    ok(cd_chain_set_end(chain, end, kind));
    double* x = calloc(nodes, sizeof *x);
    double* v = calloc(nodes, sizeof *v);
    assert_non_null(x);
    assert_non_null(v);
    const double way = end == CD_END_LAST ? 1 : -1;
    for (size_t i = 0; i < nodes; ++i) {
        const double s = (double)i / (double)springs - 0.5;
        const int held = i == (end == CD_END_LAST ? springs : 0) && kind == CD_NODE_PINNED;
        x[i] = held ? 0 : pulse(s);
        v[i] = held ? 0 : -way * pulse_slope(s);
    }
    ok(cd_chain_write_f64(chain, CD_POSITION, 0, 1, 0, nodes, x, nodes));
    ok(cd_chain_write_f64(chain, CD_VELOCITY, 0, 1, 0, nodes, v, nodes));
    ok(cd_chain_step(chain, 0.25 / (double)springs, 4 * springs));
    ok(cd_chain_read_f64(chain, CD_POSITION, 0, 1, 0, nodes, x, nodes));
    double largest = 0;
    for (size_t i = 0; i < nodes; ++i)
        if (fabs(x[i]) > fabs(largest)) largest = x[i];
    free(x);
    free(v);
    cd_chain_destroy(chain);
    return largest;
}

static void a_matched_end_sends_no_echo_and_others_send_all(void** state) {
    (void)state;
    for (int rule = CD_MASS_EQUAL; rule <= CD_MASS_HALF_ENDS; ++rule)
        for (int end = CD_END_FIRST; end <= CD_END_LAST; ++end)
            for (int p = 0; p < 2; ++p) {
                const cd_precision precision = p ? CD_FLOAT64 : CD_FLOAT32;
                double coarser = 0;
                for (size_t springs = 200; springs <= 800; springs *= 2) {
                    const double matched = echo(end, CD_NODE_MATCHED, springs, rule, precision);
                    const double free_end = echo(end, CD_NODE_FREE, springs, rule, precision);
                    const double pinned = echo(end, CD_NODE_PINNED, springs, rule, precision);
                    print_message(
                        "float%d %-12s end %d, %zu springs: echo of a matched end %+.4f, free %+.4f, pinned "
                        "%+.4f\n",
                        p ? 64 : 32, rule ? "half ends" : "equal masses", end, springs, matched, free_end, pinned);
                    assert_true(free_end > 0.95);
                    assert_true(pinned < -0.95);
                    /* half an end mass too much is a reflection of first order, the bare lattice one of second */
                    assert_true(fabs(matched) < (rule ? 0.01 : 0.1));
                    if (coarser > 0) assert_true(fabs(matched) < (rule ? 0.35 : 0.6) * coarser);
                    coarser = fabs(matched);
                }
            }
}

static void two_matched_ends_let_all_energy_out(void** state) {
    (void)state;
    enum { SPRINGS = 400 };
    cd_chain* chain = NULL;
    double x[SPRINGS + 1], kinetic, elastic, before;
    ok(cd_chain_create(1, SPRINGS, 1, CD_FLOAT64, NULL, &chain));
    ok(cd_chain_set_mass_rule(chain, CD_MASS_HALF_ENDS));
    ok(cd_chain_set_end(chain, CD_END_FIRST, CD_NODE_MATCHED));
    ok(cd_chain_set_end(chain, CD_END_LAST, CD_NODE_MATCHED));
    for (size_t i = 0; i <= SPRINGS; ++i) x[i] = pulse((double)i / SPRINGS - 0.4);
    ok(cd_chain_write_f64(chain, CD_POSITION, 0, 1, 0, SPRINGS + 1, x, SPRINGS + 1));
    ok(cd_chain_get_energy(chain, &kinetic, &elastic, NULL));
    before = kinetic + elastic;
    for (int k = 0; k < 3; ++k) {
        ok(cd_chain_step(chain, 0.001, 1000));
        ok(cd_chain_get_energy(chain, &kinetic, &elastic, NULL));
        print_message("energy left after %d s: %.1e of it\n", k + 1, (kinetic + elastic) / before);
        if (k == 0) assert_true((kinetic + elastic) / before < 1e-3);
        if (k == 2) assert_true((kinetic + elastic) / before < 1e-5);
    }
    cd_chain_destroy(chain);
}

/* A chain of unlike masses whose first end is matched, and its mirror image, whose last end is. */
static void both_ends_are_matched_alike(void** state) {
    (void)state;
    enum { SPRINGS = 12 };
    cd_chain* chains[2] = {NULL, NULL};
    double x[2][SPRINGS + 1];
    for (int last = 0; last < 2; ++last) {
        double mass[SPRINGS + 1];
        for (int i = 0; i <= SPRINGS; ++i) {
            const int at = last ? SPRINGS - i : i;
            x[last][at] = 0.1 * i * i - i;
            mass[at] = 0.05 + 0.02 * i;
        }
        ok(cd_chain_create(1, SPRINGS, 1, CD_FLOAT64, NULL, &chains[last]));
        ok(cd_chain_enable_field(chains[last], CD_MASS));
        ok(cd_chain_write_f64(chains[last], CD_MASS, 0, 1, 0, SPRINGS + 1, mass, SPRINGS + 1));
        ok(cd_chain_write_f64(chains[last], CD_POSITION, 0, 1, 0, SPRINGS + 1, x[last], SPRINGS + 1));
        ok(cd_chain_set_end(chains[last], last ? CD_END_LAST : CD_END_FIRST, CD_NODE_MATCHED));
        ok(cd_chain_step(chains[last], 0.02, 50));
        ok(cd_chain_read_f64(chains[last], CD_POSITION, 0, 1, 0, SPRINGS + 1, x[last], SPRINGS + 1));
        cd_chain_destroy(chains[last]);
    }
    for (int i = 0; i <= SPRINGS; ++i) assert_near(x[0][i], x[1][SPRINGS - i], 1e-12, 0);
}

/* ---- driven nodes ------------------------------------------------------------------------------------------------ */

enum { NODES = 30 };
struct motion {
    double x[NODES], v[NODES];
};

/* 1000 steps from a random state that moves at u as a whole, with node `place` held at rest or driven at u. */
static struct motion held(size_t place, double u, int bend, const struct time_step* step, double* out_time) {
    struct motion motion;
    cd_chain* chain = NULL;
    ok(cd_chain_create(1, NODES - 1, 1, CD_FLOAT64, NULL, &chain));
    set_time_step(chain, step);
    if (bend) ok(cd_chain_set_bend(chain, 1e-3));
    double dt;
    ok(cd_chain_stable_dt(chain, &dt));
    dt *= step->grows ? 0.05 : 0.9;
    const double kind = u != 0 ? CD_NODE_DRIVEN : CD_NODE_PINNED;
    ok(cd_chain_write_f64(chain, CD_PIN, 0, 1, place, 1, &kind, 1));
    uint64_t seed = 4;
    for (size_t i = 0; i < NODES; ++i) {
        motion.x[i] = random_number(&seed);
        motion.v[i] = (i == place ? 0 : random_number(&seed)) + u;
    }
    ok(cd_chain_write_f64(chain, CD_POSITION, 0, 1, 0, NODES, motion.x, NODES));
    ok(cd_chain_write_f64(chain, CD_VELOCITY, 0, 1, 0, NODES, motion.v, NODES));
    ok(cd_chain_step(chain, dt, 1000));
    ok(cd_chain_read_f64(chain, CD_POSITION, 0, 1, 0, NODES, motion.x, NODES));
    ok(cd_chain_read_f64(chain, CD_VELOCITY, 0, 1, 0, NODES, motion.v, NODES));
    ok(cd_chain_get_time(chain, out_time));
    cd_chain_destroy(chain);
    return motion;
}

/* Driving a node at a constant velocity u is pinning it, seen from something that moves at -u. */
static void a_driven_node_is_a_pinned_one_seen_in_motion(void** state) {
    (void)state;
    static const size_t places[] = {0, 11, NODES - 1};
    const double u = 0.75;
    double worst = 0;
    for (size_t k = 0; k < COUNT(places); ++k)
        for (int bend = 0; bend < 2; ++bend)
            for (size_t m = 0; m < TIME_STEPS; ++m) {
                double time;
                const struct motion pinned = held(places[k], 0, bend, &time_steps[m], &time);
                const struct motion driven = held(places[k], u, bend, &time_steps[m], &time);
                double size = 1;
                for (size_t i = 0; i < NODES; ++i) size = fmax(size, fmax(fabs(driven.x[i]), fabs(driven.v[i])));
                for (size_t i = 0; i < NODES; ++i) {
                    worst = fmax(worst, fabs(driven.x[i] - pinned.x[i] - u * time) / size);
                    worst = fmax(worst, fabs(driven.v[i] - pinned.v[i] - u) / size);
                }
                if (driven.v[places[k]] != u)
                    print_message("node %zu, bend %d, %s: driven at %.17g\n", places[k], bend, time_steps[m].name,
                                  driven.v[places[k]]);
                assert_true(driven.v[places[k]] == u);
                assert_true(pinned.v[places[k]] == 0);
            }
    print_message("driven and pinned motions differ by %.1e\n", worst);
    assert_true(worst <= 1e-11);
}

/* A string whose first end moves as sin(w t), the last one fixed, swings as sin(w (1 - s)) / sin(w) sin(w t). The
 * driven velocity of a step is the mean over it, so that the end is always where it should be. */
static double standing_wave_error(size_t springs, const struct time_step* step) {
    const double w = 2;
    const size_t nodes = springs + 1, steps = 3 * springs;
    const double dt = 1 / (double)springs;
    cd_chain* chain = NULL;
    ok(cd_chain_create(1, springs, 1, CD_FLOAT64, NULL, &chain));
    set_time_step(chain, step);
    ok(cd_chain_set_mass_rule(chain, CD_MASS_HALF_ENDS));
    ok(cd_chain_set_end(chain, CD_END_FIRST, CD_NODE_DRIVEN));
    ok(cd_chain_set_end(chain, CD_END_LAST, CD_NODE_PINNED));
    double* x = calloc(nodes, sizeof *x);
    assert_non_null(x);
    for (size_t i = 0; i < springs; ++i) x[i] = w * sin(w * (1 - (double)i / (double)springs)) / sin(w);
    ok(cd_chain_write_f64(chain, CD_VELOCITY, 0, 1, 0, nodes, x, nodes));
    for (size_t k = 0; k < steps; ++k) {
        const double t = (double)k * dt, speed = (sin(w * (t + dt)) - sin(w * t)) / dt;
        ok(cd_chain_write_f64(chain, CD_VELOCITY, 0, 1, 0, 1, &speed, 1));
        ok(cd_chain_step(chain, dt, 1));
    }
    ok(cd_chain_read_f64(chain, CD_POSITION, 0, 1, 0, nodes, x, nodes));
    cd_chain_destroy(chain);
    assert_near(x[0], sin(w * (double)steps * dt), 1e-12, 1);
    double error = 0;
    for (size_t i = 0; i < nodes; ++i) {
        const double s = (double)i / (double)springs;
        error = fmax(error, fabs(x[i] - sin(w * (1 - s)) / sin(w) * sin(w * (double)steps * dt)));
    }
    free(x);
    return error;
}

static void a_driven_end_makes_a_standing_wave(void** state) {
    (void)state;
    static const size_t steps[] = {LAMBDA_1_2, STIFF_SECOND};
    for (size_t m = 0; m < COUNT(steps); ++m) {
        double coarser = 0, order = 0;
        for (size_t springs = 50; springs <= 400; springs *= 2) {
            const double error = standing_wave_error(springs, &time_steps[steps[m]]);
            order = coarser > 0 ? log2(coarser / error) : 0;
            print_message("%-12s %3zu springs: standing wave to %.1e, order %.2f\n", time_steps[steps[m]].name, springs,
                          error, order);
            coarser = error;
        }
        assert_true(coarser < 1e-3);
        assert_true(order > 1.8);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_matched_end_sends_no_echo_and_others_send_all),
        cmocka_unit_test(two_matched_ends_let_all_energy_out),
        cmocka_unit_test(both_ends_are_matched_alike),
        cmocka_unit_test(a_driven_node_is_a_pinned_one_seen_in_motion),
        cmocka_unit_test(a_driven_end_makes_a_standing_wave),
    };
    return cmocka_run_group_tests_name("ends", tests, NULL, NULL);
}
