/* Sheets in steps whose length changes from one to the next, as where a game steps by the time since its last frame.
 * What keeps the energy itself does so at any change. Where both directions are factored the energy so kept depends on
 * dt: membrane.h tells what comes of it. */
#include <math.h>
#include <stdlib.h>

#include "check.h"
#include "grid.h"
#include "reference.h"
#include "sheet.h"
#include "wild.h"

/* A sheet of stiffness over mass `ratio` / (0.016 s)^2, shaken; with lambda, undamped. */
static cd_membrane* shaken(enum wild kind, double ratio, double lambda, cd_solver solver, uint64_t seed) {
    cd_membrane* m = wild_membrane(kind, 12, 9, 1, CD_FLOAT64, ratio / (0.016 * 0.016), seed);
    ok(cd_membrane_set_lambda(m, lambda));
    ok(cd_membrane_set_solver(m, solver));
    wild_shake(m, 1, 1 / 0.016, seed);
    return m;
}

static void what_keeps_energy_does_so_in_uneven_steps(void** state) {
    (void)state;
    double worst = 0;
    for (int kind = 0; kind < WILD_KINDS; ++kind)
        for (int coupled = 0; coupled < 2; ++coupled)
            for (int k = 0; k < 12; ++k) {
                const double ratio = pow(10, k / 2 - 1), lambda = k % 2 ? 1 : 0.5;
                if (!coupled && wild_separates((enum wild)kind, 0)) continue;
                cd_membrane* m =
                    shaken((enum wild)kind, ratio, lambda, coupled ? CD_SOLVER_COUPLED : CD_SOLVER_ALTERNATING,
                           (uint64_t)(100 * kind + k));
                uint64_t seed = 7;
                const double start = sheet_swing_energy(m);
                double before = start;
                for (size_t step = 0; step < 60; ++step) {
                    const double any = 0.016 * pow(10, 3 * random_number(&seed));
                    sheet_step(m, step >= 30 ? any : step % 2 ? 0.017 : 0.016, 1);
                    const double now = sheet_swing_energy(m);
                    worst = fmax(worst, (lambda > 0.5 ? now - before : fabs(now - start)) / start);
                    before = now;
                }
                cd_membrane_destroy(m);
            }
    print_message("uneven steps: off by %.1e of the energy\n", worst);
    assert_true(worst <= 1e-6);
}

/* Where both directions are factored: by what part of itself the energy grows a step, in the later half of 800. */
static double growth(enum wild kind, double ratio, double lambda, cd_method method, double first, double second) {
    cd_membrane* m = shaken(kind, ratio, lambda, CD_SOLVER_ALTERNATING, 3);
    double highest[2] = {0, 0};
    ok(cd_membrane_set_method(m, method));
    for (size_t step = 0; step < 800; ++step) {
        sheet_step(m, step % 2 ? second : first, 1);
        highest[step / 400] = fmax(highest[step / 400], sheet_swing_energy(m));
    }
    cd_membrane_destroy(m);
    return expm1(log(highest[1] / highest[0]) / 400);
}

/* The figures of membrane.h: an eighth a step, and nothing with lambda = 1 or steps that are all alike. */
static void factored_sheets_gain_no_more_than_the_header_says(void** state) {
    (void)state;
    double half = 0, stiff = 0, whole = -1, even = -1;
    for (int kind = 0; kind < WILD_SEPARABLE; ++kind)
        for (double ratio = 0.1; ratio < 2e3; ratio *= 2) {
            const enum wild sheet = (enum wild)kind;
            half = fmax(half, growth(sheet, ratio, 0.5, CD_METHOD_IMPLICIT, 0.016, 0.017));
            stiff = fmax(stiff, growth(sheet, ratio, 0.5, CD_METHOD_STIFF_SECOND, 0.016, 0.017));
            whole = fmax(whole, growth(sheet, ratio, 1, CD_METHOD_IMPLICIT, 0.016, 0.017));
            even = fmax(even, growth(sheet, ratio, 0.5, CD_METHOD_IMPLICIT, 0.016, 0.016));
        }
    print_message(
        "factored: lambda 1/2 gains %.3f of its energy a step, the stiff method %.3f; lambda 1 %.0e; all in "
        "steps of one length %.0e\n",
        half, stiff, whole, even);
    assert_true(half <= 0.13 && stiff <= 0.13);
    assert_true(whole <= 0 && even <= 1e-3);
}

/* By default: from the first step on that differs a sheet keeps what energy it has, whatever it took before. */
static void by_default_uneven_steps_gain_nothing(void** state) {
    (void)state;
    double worst = 0;
    size_t alternated = 0;
    for (int kind = 0; kind < WILD_SEPARABLE; ++kind)
        for (double ratio = 0.01; ratio < 2e3; ratio *= 4)
            for (size_t even = 1; even <= 6; even += 5) {
                cd_membrane* m = shaken((enum wild)kind, ratio, 0.5, CD_SOLVER_AUTO, 5);
                uint64_t seed = 11 + (uint64_t)kind;
                cd_solver taken;
                ok(cd_membrane_set_tolerance(m, 1e-10, 1000));
                for (int again = 0; again < 2; ++again) {
                    sheet_step(m, 0.016, even);
                    ok(cd_membrane_get_solver_taken(m, &taken));
                    alternated += taken == CD_SOLVER_ALTERNATING;
                    sheet_step(m, 0.017, 1);
                    const double start = sheet_swing_energy(m);
                    for (size_t step = 0; step < 100; ++step) {
                        sheet_step(m, step % 10 == 9 ? 0.032 : 0.016 + 0.001 * random_number(&seed), 1);
                        worst = fmax(worst, fabs(sheet_swing_energy(m) / start - 1));
                    }
                    ok(cd_membrane_reset(m)); /* after which it alternates as before */
                    wild_shake(m, 1, 1 / 0.016, 6);
                }
                cd_membrane_destroy(m);
            }
    print_message("by default: off by %.1e of the energy; it had alternated in %zu scenes\n", worst, alternated);
    assert_true(worst <= 1e-6);
    assert_true(alternated > 0 && alternated % 4 == 0); /* after a reset as before */
}

/* What makes steps unlike though all are of one length: none of it does work. */
enum { LAMBDA, METHOD, DRAG, DAMPING, SOLVER, PIN, EDGE, TIE, FIELD, CAUSES };

static void change(cd_membrane* m, int cause, int on) {
    if (cause == LAMBDA) ok(cd_membrane_set_lambda(m, on ? 1 : 0.5));
    if (cause == METHOD) ok(cd_membrane_set_method(m, on ? CD_METHOD_STIFF_SECOND : CD_METHOD_IMPLICIT));
    if (cause == DRAG) ok(cd_membrane_set_drag(m, on ? 100 : 0));
    if (cause == DAMPING) ok(cd_membrane_set_stiffness_damping(m, on ? 0.02 : 0));
    if (cause == SOLVER) ok(cd_membrane_set_solver(m, on ? CD_SOLVER_COUPLED : CD_SOLVER_AUTO));
    if (cause == PIN && on) ok(cd_membrane_enable_field(m, CD_PIN));
    if (cause == PIN) sheet_set(m, CD_PIN, 5, 4, on ? CD_NODE_PINNED : CD_NODE_FREE);
    if (cause == EDGE) ok(cd_membrane_set_edge(m, CD_EDGE_V_FIRST, on ? CD_NODE_PINNED : CD_NODE_FREE));
    if (cause == TIE && on) ok(cd_membrane_attach(m, 5, 4, 1e6, 0, NULL, 0)); /* to where the node is */
    if (cause == TIE && !on) ok(cd_membrane_detach(m, 5, 4));
    if (cause == FIELD && on) ok(cd_membrane_enable_field(m, CD_MASS)); /* the same masses, as each node's own */
    if (cause == FIELD && !on) ok(cd_membrane_disable_field(m, CD_MASS));
}

/* By what part the energy is higher in the later half of 200 steps than in the first. Who takes over the state on the
 * way has the same bits. */
static double gained(int cause, double ratio, size_t every, int* alternated) {
    cd_membrane* const m = shaken(WILD_FREE, ratio, 0.5, CD_SOLVER_AUTO, 5);
    cd_membrane* const other = wild_membrane(WILD_FREE, 12, 9, 1, CD_FLOAT64, 1, 1);
    double highest[2] = {0, 0};
    uint64_t hash, others;
    cd_solver taken;
    sheet_step(m, 0.016, 1);
    ok(cd_membrane_get_solver_taken(m, &taken));
    *alternated += taken == CD_SOLVER_ALTERNATING;
    for (size_t step = 0; step < 200; ++step) {
        if (step % every == 0) change(m, cause, step / every % 2 == 0);
        if (step == every) ok(cd_membrane_copy_state(other, m)); /* changed, but not stepped */
        if (step > every && step % every == 0) change(other, cause, step / every % 2 == 0);
        sheet_step(m, 0.016, 1);
        if (step >= every) sheet_step(other, 0.016, 1);
        highest[step / 100] = fmax(highest[step / 100], sheet_swing_energy(m));
    }
    ok(cd_membrane_hash(m, &hash));
    ok(cd_membrane_hash(other, &others));
    assert_true(hash == others);
    cd_membrane_destroy(m);
    cd_membrane_destroy(other);
    return highest[1] / highest[0] - 1;
}

static void by_default_steps_that_are_not_alike_gain_nothing(void** state) {
    (void)state;
    for (int cause = 0; cause < CAUSES; ++cause) {
        double worst = -1;
        int alternated = 0;
        for (double ratio = 0.5; ratio < 20; ratio *= 1.4)
            for (size_t every = 1; every <= 4; every += 3)
                worst = fmax(worst, gained(cause, ratio, every, &alternated));
        print_message("cause %d gained %.1e; %d scenes had alternated\n", cause, worst, alternated);
        assert_true(worst <= 1e-6);
        assert_true(alternated > 4);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_keeps_energy_does_so_in_uneven_steps),
        cmocka_unit_test(factored_sheets_gain_no_more_than_the_header_says),
        cmocka_unit_test(by_default_uneven_steps_gain_nothing),
        cmocka_unit_test(by_default_steps_that_are_not_alike_gain_nothing),
    };
    return cmocka_run_group_tests_name("membrane uneven", tests, NULL, NULL);
}
