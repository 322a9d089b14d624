/* One step after another against sums over all springs and a direct solve: whatever is switched on, a coupled step is
 * the step to its tolerance, an explicit one to rounding, and the energies told are those of the terms. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "check.h"
#include "grid.h"
#include "reference.h"
#include "sheet.h"
#include "wild.h"

enum { COLUMNS = 11, ROWS = 8, COMPONENTS = 2, NUMBERS = COLUMNS * ROWS * COMPONENTS };

/* Gravity, a force at every node and damping of both kinds, on top of the kind's own. */
static void load(cd_membrane* m, double dt) {
    const double gravity[COMPONENTS] = {0.5, -9.81};
    double force[NUMBERS];
    uint64_t seed = 77;
    for (size_t i = 0; i < NUMBERS; ++i) force[i] = 3 * random_number(&seed);
    ok(cd_membrane_set_gravity(m, gravity, COMPONENTS));
    ok(cd_membrane_enable_field(m, CD_FORCE));
    sheet_write(m, CD_FORCE, force);
    ok(cd_membrane_set_drag(m, 0.1 / dt));
    ok(cd_membrane_set_stiffness_damping(m, 0.3 * dt));
}

static void tie(cd_membrane* m) {
    const double target[COMPONENTS] = {0.5, -0.25};
    ok(cd_membrane_attach(m, 4, 5, 2, 0.5, target, COMPONENTS));
}

/* The largest difference after `steps` steps over the largest number of either kind. */
static double difference(cd_membrane* m, const struct time_step* step, double dt, size_t steps) {
    double x[NUMBERS], v[NUMBERS], gx[NUMBERS], gv[NUMBERS], size_x = 0, size_v = 0, off_x = 0, off_v = 0;
    struct grid* g = grid_of(m);
    sheet_read(m, CD_POSITION, gx);
    sheet_read(m, CD_VELOCITY, gv);
    sheet_set_time_step(m, step);
    for (size_t i = 0; i < NUMBERS; ++i) size_x = fmax(size_x, fabs(gx[i])), size_v = fmax(size_v, fabs(gv[i]));
    grid_step(g, step, dt, steps, gx, gv);
    sheet_step(m, dt, steps);
    sheet_read(m, CD_POSITION, x);
    sheet_read(m, CD_VELOCITY, v);
    for (size_t i = 0; i < NUMBERS; ++i) {
        size_x = fmax(size_x, fabs(gx[i])), off_x = fmax(off_x, fabs(x[i] - gx[i]));
        size_v = fmax(size_v, fabs(gv[i])), off_v = fmax(off_v, fabs(v[i] - gv[i]));
    }
    grid_destroy(g);
    return fmax(off_x / size_x, off_v / size_v);
}

/* After a step, or five in float64, over what is allowed: a residual of 1e-13 is the larger an error the stiffer the
 * sheet. Bend with free edges is hard on the preconditioner: where the status says so, -1. */
static double coupled_error(enum wild kind, const struct time_step* step, double ratio, int loaded,
                            cd_precision precision) {
    const int p = precision == CD_FLOAT64;
    const double dt = 1, allowed = p ? 1e-10 + 1e-12 * ratio : 1e-6;
    cd_membrane* m = wild_membrane(kind, COLUMNS, ROWS, COMPONENTS, precision, ratio, 5);
    size_t iterations;
    double residual;
    ok(cd_membrane_set_solver(m, CD_SOLVER_COUPLED));
    ok(cd_membrane_set_tolerance(m, 1e-13, 1000));
    if (loaded) load(m, dt), tie(m);
    wild_shake(m, 1, 1, 6);
    const double off = difference(m, step, dt, p ? 5 : 1);
    ok(cd_membrane_get_convergence(m, &iterations, &residual));
    cd_membrane_destroy(m);
    if (kind >= WILD_PLATE_FREE && residual > 1e-11) return -1;
    if (!(off <= allowed))
        print_message("%s, %s, k/m dt^2 = %g, loaded %d, float%d: off by %.1e, residual %.1e after %zu iterations\n",
                      wild_names[kind], step->name, ratio, loaded, p ? 64 : 32, off, residual, iterations);
    return off / allowed;
}

static void a_coupled_step_is_the_step_of_a_direct_solve(void** state) {
    (void)state;
    static const size_t ways[] = {LAMBDA_1_4, LAMBDA_1_2, LAMBDA_1, STIFF_SECOND};
    static const double ratios[] = {1e-3, 1, 1e4};
    double worst[2] = {0, 0};
    int fell_short = 0;
    for (int kind = 0; kind < WILD_KINDS; ++kind)
        for (size_t k = 0; k < COUNT(ways) * COUNT(ratios); ++k)
            for (int loaded = 0; loaded < 2; ++loaded)
                for (int p = 0; p < 2; ++p) {
                    const struct time_step* way = &time_steps[ways[k / COUNT(ratios)]];
                    const double error = coupled_error((enum wild)kind, way, ratios[k % COUNT(ratios)], loaded,
                                                       p ? CD_FLOAT64 : CD_FLOAT32);
                    fell_short += error < 0;
                    worst[p] = fmax(worst[p], error);
                }
    print_message("coupled steps: off by %.2g (float32), %.2g (float64) of what is allowed; %d plates fell short\n",
                  worst[0], worst[1], fell_short);
    assert_true(worst[0] <= 1);
    assert_true(worst[1] <= 1);
    assert_true(fell_short <= 24);
}

static void an_explicit_step_is_the_sum_over_all_springs(void** state) {
    (void)state;
    double worst[2] = {0, 0};
    for (int kind = 0; kind < WILD_KINDS; ++kind)
        for (size_t k = FORWARD_EULER; k <= LAMBDA_0; ++k)
            for (int loaded = 0; loaded < 2; ++loaded)
                for (int p = 0; p < 2; ++p) {
                    cd_membrane* m =
                        wild_membrane((enum wild)kind, COLUMNS, ROWS, COMPONENTS, p ? CD_FLOAT64 : CD_FLOAT32, 1, 5);
                    const double dt = 0.1;
                    if (loaded) load(m, dt), tie(m);
                    wild_shake(m, 1, 1, 6);
                    const double off = difference(m, &time_steps[k], dt, p ? 5 : 1);
                    if (!(off <= (p ? 1e-13 : 1e-6)))
                        print_message("%s, %s, loaded %d, float%d: off by %.1e\n", wild_names[kind], time_steps[k].name,
                                      loaded, p ? 64 : 32, off);
                    worst[p] = fmax(worst[p], off);
                    cd_membrane_destroy(m);
                }
    print_message("explicit steps: off by %.1e in float32, %.1e in float64\n", worst[0], worst[1]);
    assert_true(worst[0] <= 1e-6);
    assert_true(worst[1] <= 1e-13);
}

/* B (w - v) = b - S v: factoring adds the product of the directions to B, of order dt^4, with stiffness damping dt^2.
 * The twist of plates is missing from it, of order dt^2, with stiffness damping dt. w - v and, as the sheet starts at
 * rest, v itself are of order dt. Other sheets search the best w near the factored one. */
static void an_alternating_step_tends_to_the_coupled_one_as_dt_goes_to_0(void** state) {
    (void)state;
    for (int k = 0; k < 2 * WILD_KINDS; ++k) {
        const int kind = k / 2, damped = k % 2;
        const int bends = wild_has_bend((enum wild)kind), searched = kind >= WILD_SEPARABLE && !bends;
        const double least = (damped ? 2 : 4) / (bends ? 2 : 1) - (searched ? 1.2 : 0.2);
        double before = 0, order = 0, off = 0;
        for (double dt = 0.2; dt > 0.02; dt /= 2) {
            cd_membrane* m = wild_membrane((enum wild)kind, COLUMNS, ROWS, COMPONENTS, CD_FLOAT64, 0.1, 5);
            load(m, 1);
            if (!damped) ok(cd_membrane_set_stiffness_damping(m, 0));
            wild_shake(m, 1, 0, 6);
            off = difference(m, &time_steps[LAMBDA_1_2], dt, 1);
            order = log2(before / off);
            before = off;
            cd_membrane_destroy(m);
        }
        if (!(order > least))
            print_message("%s, damped %d: order %.2f, off by %.1e\n", wild_names[kind], damped, order, off);
        assert_true(order > least || off < 1e-12);
    }
}

/* However small lambda is, velocities change by what springs do: the change is not lost in what is nearly the same. */
static void a_tiny_lambda_is_as_good_as_0(void** state) {
    (void)state;
    static const double lambdas[] = {1e-12, 1e-50};
    for (int kind = 0; kind < WILD_KINDS; ++kind)
        for (size_t k = 0; k < COUNT(lambdas); ++k) {
            const struct time_step step = {"tiny lambda", CD_METHOD_IMPLICIT, lambdas[k], 1, 1};
            cd_membrane* m = wild_membrane((enum wild)kind, COLUMNS, ROWS, COMPONENTS, CD_FLOAT64, 1, 5);
            load(m, 1);
            ok(cd_membrane_set_drag(m, 0));
            wild_shake(m, 1, 1, 6);
            const double off = difference(m, &step, 0.01, 5);
            const double allowed = wild_has_bend((enum wild)kind) ? 1e-6 : 1e-10; /* two factors for a line's bend */
            if (!(off <= allowed)) print_message("%s, lambda %g: off by %.1e\n", wild_names[kind], lambdas[k], off);
            assert_true(off <= allowed);
            cd_membrane_destroy(m);
        }
}

static void energies_are_those_of_the_springs_bends_and_ties(void** state) {
    (void)state;
    for (int kind = 0; kind < WILD_KINDS; ++kind)
        for (int loaded = 0; loaded < 2; ++loaded) {
            cd_membrane* m = wild_membrane((enum wild)kind, COLUMNS, ROWS, COMPONENTS, CD_FLOAT64, 3, 5);
            double x[NUMBERS], v[NUMBERS], kinetic, elastic, gravity;
            if (loaded) load(m, 1), tie(m);
            wild_shake(m, 1, 1, 8);
            struct grid* g = grid_of(m);
            sheet_read(m, CD_POSITION, x);
            sheet_read(m, CD_VELOCITY, v);
            ok(cd_membrane_get_energy(m, &kinetic, &elastic, &gravity));
            long double fall = 0, heights = 0;
            for (size_t i = 0; i < NUMBERS; ++i)
                if (!g->held[i / COMPONENTS]) {
                    const long double part = g->mass[i / COMPONENTS] * g->gravity[i % COMPONENTS] * x[i];
                    fall -= part, heights += fabsl(part);
                }
            assert_near(kinetic, (double)grid_kinetic_energy(g, v), 1e-13, 0);
            assert_near(elastic, (double)grid_elastic_energy(g, x), 1e-13, 0);
            assert_near(gravity, (double)fall, 1e-13, (double)heights);
            grid_destroy(g);
            cd_membrane_destroy(m);
        }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_coupled_step_is_the_step_of_a_direct_solve),
        cmocka_unit_test(an_explicit_step_is_the_sum_over_all_springs),
        cmocka_unit_test(an_alternating_step_tends_to_the_coupled_one_as_dt_goes_to_0),
        cmocka_unit_test(a_tiny_lambda_is_as_good_as_0),
        cmocka_unit_test(energies_are_those_of_the_springs_bends_and_ties),
    };
    return cmocka_run_group_tests_name("membrane agreement", tests, NULL, NULL);
}
