/* What Kass 1997 shows and claims: figure 2, and how fast a disturbance crosses. */
#include <math.h>
#include <stdlib.h>

#include "check.h"
#include "modes.h"

/* ---- figure 2: one implicit solve of an impulse ------------------------------------------------------------------ */

enum { LONG = 2001, MIDDLE = 1000 };

/* (1 + 2 s) x_i - s (x_{i-1} + x_{i+1}) = delta_{i0}, s = lambda^2 dt^2 k_i / m_i, on a line without ends:
 * x_i = q^|i| / sqrt(1 + 4 s), q = (1 + 2 s - sqrt(1 + 4 s)) / (2 s) = 2 s / (1 + 2 s + sqrt(1 + 4 s)). */
static double figure_2(double s, size_t distance) {
    const double root = sqrt(1 + 4 * s);
    return pow(2 * s / (1 + 2 * s + root), (double)distance) / root;
}

static double spread_error(cd_precision precision, double lambda, double s) {
    static double v[LONG];
    const double mass = 1.0 / LONG, spring = 3 * (LONG - 1), dt = sqrt(s * mass / spring) / lambda;
    cd_chain* chain = NULL;
    ok(cd_chain_create(1, LONG - 1, 1, precision, NULL, &chain));
    ok(cd_chain_set_stiffness(chain, 3));
    ok(cd_chain_set_lambda(chain, lambda));
    ok(cd_chain_impulse(chain, 0, MIDDLE, &mass, 1));
    ok(cd_chain_step(chain, dt, 1));
    ok(cd_chain_read_f64(chain, CD_VELOCITY, 0, 1, 0, LONG, v, LONG));
    cd_chain_destroy(chain);
    double error = 0;
    for (size_t i = 0; i < LONG; ++i) {
        /* the solve is of v + lambda dv, with v = 1 in the middle before the step */
        const double before = i == MIDDLE, solved = before + lambda * (v[i] - before);
        const double exact = figure_2(s, i > MIDDLE ? i - MIDDLE : MIDDLE - i);
        error = fmax(error, fabs(solved - exact) / figure_2(s, 0));
    }
    return error;
}

static void an_impulse_spreads_as_in_figure_2(void** state) {
    (void)state;
    static const double lambdas[] = {0.25, 0.5, 0.75, 1}, weights[] = {1e-3, 0.1, 1, 10, 100, 500};
    for (int p = 0; p < 2; ++p) {
        double worst = 0;
        for (size_t l = 0; l < COUNT(lambdas); ++l)
            for (size_t w = 0; w < COUNT(weights); ++w)
                worst = fmax(worst, spread_error(p ? CD_FLOAT64 : CD_FLOAT32, lambdas[l], weights[w]));
        print_message("float%d: figure 2 to %.1e of its peak\n", p ? 64 : 32, worst);
        assert_true(worst <= (p ? 1e-12 : 1e-5));
    }
}

/* The figure's two curves: after the forward filter alone the impulse trails to the right only, by the factor q; the
 * backward filter makes it even. The filters are the elimination's two recurrences (Kass 1997, eq. 31). */
static void the_forward_filter_trails_and_the_backward_filter_makes_it_even(void** state) {
    (void)state;
    static double w[LONG], p[LONG], y[LONG], x[LONG], v[LONG];
    const double s = 10, q = figure_2(s, 1) / figure_2(s, 0);
    double r = 1;
    for (size_t i = 0; i < LONG; ++i) {
        w[i] = i + 1 < LONG ? s / (r + s) : 0;
        p[i] = i + 1 < LONG ? 1 / (r + s) : 1 / r;
        y[i] = (i == MIDDLE) + (i > 0 ? w[i - 1] * y[i - 1] : 0);
        r = 1 + r * w[i];
    }
    for (size_t i = LONG; i-- > 0;) x[i] = p[i] * y[i] + (i + 1 < LONG ? w[i] * x[i + 1] : 0);
    const double mass = 1.0 / LONG, spring = LONG - 1;
    cd_chain* chain = NULL;
    ok(cd_chain_create(1, LONG - 1, 1, CD_FLOAT64, NULL, &chain));
    ok(cd_chain_set_lambda(chain, 1));
    ok(cd_chain_impulse(chain, 0, MIDDLE, &mass, 1));
    ok(cd_chain_step(chain, sqrt(s * mass / spring), 1));
    ok(cd_chain_read_f64(chain, CD_VELOCITY, 0, 1, 0, LONG, v, LONG));
    cd_chain_destroy(chain);
    for (size_t i = 0; i < 30; ++i) {
        assert_true(y[MIDDLE - 1 - i] == 0);
        assert_near(y[MIDDLE + i], pow(q, (double)i), 1e-12, 0);
        assert_near(x[MIDDLE - i], x[MIDDLE + i], 1e-12, 0);
        assert_near(v[MIDDLE - i], v[MIDDLE + i], 1e-12, 0);
        assert_near(v[MIDDLE + i], x[MIDDLE + i], 1e-12, 0);
    }
}

/* ---- how many steps a disturbance needs to cross ----------------------------------------------------------------- */

/* Steps until the last node has moved, after the first one was displaced. */
static size_t steps_to_cross(const struct time_step* step, size_t springs, double part_of_limit) {
    cd_chain* chain = NULL;
    ok(cd_chain_create(1, springs, 1, CD_FLOAT64, NULL, &chain));
    set_time_step(chain, step);
    double dt = 0, there = 0;
    const double one = 1;
    ok(cd_chain_stable_dt(chain, &dt));
    ok(cd_chain_write_f64(chain, CD_POSITION, 0, 1, 0, 1, &one, 1));
    size_t steps = 0;
    while (there == 0 && steps <= 3 * springs) {
        ok(cd_chain_step(chain, part_of_limit * dt, 1));
        ++steps;
        ok(cd_chain_read_f64(chain, CD_POSITION, 0, 1, springs, 1, &there, 1));
    }
    cd_chain_destroy(chain);
    return steps;
}

/* An explicit step takes a force from a node's neighbours only. Forward Euler moves a node with the velocity that it
 * had before, so position reaches the next node's velocity in one step and its position in another: 2 n steps.
 * Symplectic Euler moves it with the new one: n steps, however small dt is. An implicit step solves the whole line
 * at once. */
static void a_disturbance_needs_2n_euler_steps_or_one_implicit_step_to_cross(void** state) {
    (void)state;
    static const size_t sizes[] = {2, 10, 50};
    for (size_t k = 0; k < COUNT(sizes); ++k)
        for (size_t m = 0; m < TIME_STEPS; ++m) {
            const struct time_step* step = &time_steps[m];
            const size_t n = sizes[k], steps = steps_to_cross(step, n, 0.5);
            print_message("%2zu springs, %-16s: %zu steps\n", n, step->name, steps);
            if (step->method == CD_METHOD_FORWARD_EULER || (step->method == CD_METHOD_IMPLICIT && step->lambda == 0))
                assert_int_equal(steps, 2 * n);
            else if (step->method == CD_METHOD_SYMPLECTIC_EULER)
                assert_int_equal(steps, n);
            else
                assert_int_equal(steps, 1);
        }
}

/* The number is one of information, not of stability: a smaller step takes as many. */
static void a_smaller_step_takes_as_many_steps_to_cross(void** state) {
    (void)state;
    assert_int_equal(steps_to_cross(&time_steps[FORWARD_EULER], 20, 0.1), 40);
    assert_int_equal(steps_to_cross(&time_steps[SYMPLECTIC_EULER], 20, 0.1), 20);
    assert_int_equal(steps_to_cross(&time_steps[LAMBDA_1], 20, 0.1), 1);
}

/* "In the limit all the mass points move together": the stiffer the chain, the more alike are the velocities that one
 * push leaves behind. */
static void a_stiff_chain_moves_as_one_after_a_push(void** state) {
    (void)state;
    enum { NODES = 100 };
    double v[NODES], spread_before = INFINITY;
    for (double stiffness = 1; stiffness < 1e21; stiffness *= 1e4) {
        cd_chain* chain = NULL;
        ok(cd_chain_create(1, NODES - 1, 1, CD_FLOAT64, NULL, &chain));
        ok(cd_chain_set_stiffness(chain, stiffness));
        ok(cd_chain_set_lambda(chain, 1));
        const double push = 1;
        ok(cd_chain_impulse(chain, 0, 0, &push, 1));
        ok(cd_chain_step(chain, 1.0 / 60, 1));
        ok(cd_chain_read_f64(chain, CD_VELOCITY, 0, 1, 0, NODES, v, NODES));
        double least = v[0], most = v[0];
        for (size_t i = 0; i < NODES; ++i) least = fmin(least, v[i]), most = fmax(most, v[i]);
        print_message("stiffness %.0e: velocities from %.6g to %.6g\n", stiffness, least, most);
        assert_true(most - least <= spread_before);
        spread_before = fmax(most - least, 1e-13);
        if (stiffness > 1e15) assert_near(least, 1, 1e-12, 1);
        cd_chain_destroy(chain);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(an_impulse_spreads_as_in_figure_2),
        cmocka_unit_test(the_forward_filter_trails_and_the_backward_filter_makes_it_even),
        cmocka_unit_test(a_disturbance_needs_2n_euler_steps_or_one_implicit_step_to_cross),
        cmocka_unit_test(a_smaller_step_takes_as_many_steps_to_cross),
        cmocka_unit_test(a_stiff_chain_moves_as_one_after_a_push),
    };
    return cmocka_run_group_tests_name("notes", tests, NULL, NULL);
}
