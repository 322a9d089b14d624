/* Implicit steps of sheets with lambda >= 1/2 never gain energy, whatever the stiffness, the step and the solver. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "check.h"
#include "grid.h"
#include "reference.h"
#include "sheet.h"
#include "wild.h"

static const char* const solver_names[] = {"alternating", "coupled"};
static const struct time_step ways[] = {{"lambda 1/2", CD_METHOD_IMPLICIT, 0.5, 0, 0},
                                        {"lambda 0.6", CD_METHOD_IMPLICIT, 0.6, 0, 0},
                                        {"lambda 1", CD_METHOD_IMPLICIT, 1, 0, 0},
                                        {"stiff second", CD_METHOD_STIFF_SECOND, 0, 0, 0}};

static long double stage_of(const struct time_step* way, double dt) {
    return (way->method == CD_METHOD_STIFF_SECOND ? 1 - sqrtl(0.5L) : way->lambda) * dt;
}

/* h (h + damping) */
static double square_of(const cd_membrane* m, const struct time_step* way, double dt) {
    double damping;
    ok(cd_membrane_get_stiffness_damping(m, &damping));
    const double h = (double)stage_of(way, dt);
    return h * (h + damping);
}

/* The energy that a step cannot raise. B (w - v) = b - S v with B = S + R is, for constant R, the step with the true
 * system of a sheet whose mass is M + R: factoring leaves R = A_u M'^-1 A_v + b_u + b_v - t, with M' = M (1 + h drag),
 * t and b_d the twist and the bends times h (h + damping), and in A_d the bends counted twice. So 1/2 v (M + R) v + E
 * stands for the energy where both directions are factored, single nodes that are held or not, and the energy itself
 * everywhere else. */
static double kept_energy(cd_membrane* m, const struct time_step* way, double dt, int factored) {
    double energy = sheet_swing_energy(m);
    if (!factored) return energy;
    struct grid *g = grid_of(m), *bend = grid_of_bend(m);
    const size_t n = g->nodes, each = g->components;
    const long double h = stage_of(way, dt), h2 = h * (h + g->damping);
    double* v = calloc(n * each, sizeof *v);
    enum { ONE, ALONG_V, BEND_U, BEND_V, TWIST, BOTH, AGAIN, PARTS };
    long double* part[PARTS];
    for (int k = 0; k < PARTS; ++k) assert_non_null(part[k] = calloc(n, sizeof **part));
    assert_non_null(v);
    sheet_read(m, CD_VELOCITY, v);
    memset(g->held, 0, n); /* single held nodes are factored as the others are, and stand still */
    memset(bend->held, 0, n);
    for (size_t c = 0; c < each; ++c) {
        for (size_t i = 0; i < n; ++i) part[ONE][i] = v[i * each + c];
        grid_stiffness(g, GRID_TWIST, part[ONE], part[TWIST]);
        grid_stiffness(g, GRID_ALONG_V, part[ONE], part[ALONG_V]);
        grid_stiffness(bend, GRID_ALONG_U, part[ONE], part[BEND_U]);
        grid_stiffness(bend, GRID_ALONG_V, part[ONE], part[BEND_V]);
        for (size_t i = 0; i < n; ++i)
            part[ALONG_V][i] = h2 * (part[ALONG_V][i] + part[BEND_V][i]) / (g->mass[i] * (1 + h * g->drag));
        grid_stiffness(g, GRID_ALONG_U, part[ALONG_V], part[BOTH]);
        grid_stiffness(bend, GRID_ALONG_U, part[ALONG_V], part[AGAIN]);
        for (size_t i = 0; i < n; ++i) {
            const long double left =
                part[BOTH][i] + part[AGAIN][i] + part[BEND_U][i] + part[BEND_V][i] - part[TWIST][i];
            energy += (double)(part[ONE][i] * h2 * left / 2);
        }
    }
    for (int k = 0; k < PARTS; ++k) free(part[k]);
    free(v);
    grid_destroy(g);
    grid_destroy(bend);
    return energy;
}

struct extremes {
    double highest, lowest; /* energy over that of the start */
};

static struct extremes run(cd_membrane* m, const struct time_step* way, double dt, int factored, int samples,
                           size_t steps) {
    const double start = kept_energy(m, way, dt, factored);
    struct extremes e = {0, INFINITY};
    for (int k = 0; k < samples; ++k) {
        sheet_step(m, dt, steps);
        const double energy = kept_energy(m, way, dt, factored) / start;
        assert_true(isfinite(energy));
        e.highest = fmax(e.highest, energy), e.lowest = fmin(e.lowest, energy);
    }
    return e;
}

enum damping { NONE, DRAG, STIFFNESS_DAMPING, BOTH, DAMPINGS };
static const char* const damping_names[DAMPINGS] = {"no damping", "drag", "stiffness damping", "both dampings"};

static void damp(cd_membrane* m, enum damping damping, double dt, uint64_t seed) {
    if (damping == DRAG || damping == BOTH) ok(cd_membrane_set_drag(m, pow(10, 2 * random_number(&seed)) / dt));
    if (damping == STIFFNESS_DAMPING || damping == BOTH)
        ok(cd_membrane_set_stiffness_damping(m, pow(10, 2 * random_number(&seed)) * dt));
}

/* What energy may gain by rounding. Positions and velocities known to `unit` give the forces of stiff springs, and what
 * they do in a step, errors of unit k / m dt^2. */
static double rounding_of(cd_precision precision, double ratio) {
    if (precision == CD_FLOAT32) return 1e-3;
    return ratio < 1e7 ? 1e-9 : 1e-5;
}

/* Stiffness times dt^2 over mass from 1e-6 to 1e12, for every kind of sheet and every way to step; dampings and states
 * by turns at random. In float32 the stiffest start from rest, with energy enough that rounding positions adds none to
 * speak of; where directions are factored all do, and lambda 1/2 stops at 1e6: rounding the velocity kicks what
 * factoring makes heavy, by a b times the energy of the kick. */
static void sweep(cd_solver solver, cd_precision precision) {
    const double dt = 1.0 / 64;
    double worst = 0, drift = 0;
    unsigned number = solver == CD_SOLVER_COUPLED ? 7 : 0;
    int missed = 0;
    for (int kind = 0; kind < WILD_KINDS; ++kind)
        for (size_t w = 0; w < COUNT(ways); ++w)
            for (double ratio = 1e-6; ratio < 2e12; ratio *= 1e3, ++number) {
                const int single = precision == CD_FLOAT32, alternates = solver == CD_SOLVER_ALTERNATING;
                if (single && alternates && kind < WILD_SEPARABLE && w == 0 && ratio > 1e7) continue;
                const enum damping damping = (enum damping)(number % DAMPINGS);
                cd_membrane* m = wild_membrane((enum wild)kind, 9, 7, 2, precision, ratio / (dt * dt), 1000 + number);
                sheet_set_time_step(m, &ways[w]);
                ok(cd_membrane_set_solver(m, solver));
                damp(m, damping, dt, 2000 + number);
                const int factored =
                    alternates && wild_separates((enum wild)kind, 2 * square_of(m, &ways[w], dt) * ratio / (dt * dt));
                const int at_rest = number % 3 == 1 || (single && (factored || ratio > 1e7));
                wild_shake(m, !at_rest && number % 3 == 0 ? 0 : 1, at_rest ? 0 : 1 / dt, number);
                const struct extremes e = run(m, &ways[w], dt, factored && !single, 10, 4);
                const int keeps = w == 0 && damping == NONE && !(factored && single);
                const double allowed = rounding_of(precision, ratio);
                if (!(e.highest <= 1 + allowed) || (keeps && !(e.lowest >= 1 - allowed))) {
                    print_message("%s, %s, %s, %s, k/m dt^2 = %.0e: energy from x %.9g to x %.9g\n", wild_names[kind],
                                  solver_names[solver], ways[w].name, damping_names[damping], ratio, e.lowest,
                                  e.highest);
                    ++missed;
                }
                worst = fmax(worst, e.highest - 1);
                if (keeps) drift = fmax(drift, fmax(e.highest - 1, 1 - e.lowest));
                cd_membrane_destroy(m);
            }
    print_message("%s, float%d: energy at most x 1 %+.1e; undamped with lambda 1/2 within %.1e\n", solver_names[solver],
                  precision == CD_FLOAT32 ? 32 : 64, worst, drift);
    assert_int_equal(missed, 0);
}

static void alternating_float64_never_gains_energy_at_any_stiffness(void** state) {
    (void)state;
    sweep(CD_SOLVER_ALTERNATING, CD_FLOAT64);
}

static void alternating_float32_never_gains_energy_at_any_stiffness(void** state) {
    (void)state;
    sweep(CD_SOLVER_ALTERNATING, CD_FLOAT32);
}

static void coupled_float64_never_gains_energy_at_any_stiffness(void** state) {
    (void)state;
    sweep(CD_SOLVER_COUPLED, CD_FLOAT64);
}

static void coupled_float32_never_gains_energy_at_any_stiffness(void** state) {
    (void)state;
    sweep(CD_SOLVER_COUPLED, CD_FLOAT32);
}

/* The last thing a coupled solve does is to weigh its answer against the old velocity by the energy: lambda 1/2 keeps
 * the energy however soon it stops, and more only takes from it. */
static void coupled_never_gains_energy_whatever_its_tolerance(void** state) {
    (void)state;
    static const double tolerances[] = {0.5, 1e-2, 1e-6, 1e-12};
    for (int kind = 0; kind < WILD_KINDS; ++kind)
        for (size_t w = 0; w < COUNT(ways); ++w)
            for (size_t k = 0; k < COUNT(tolerances); ++k)
                for (size_t most = 1; most <= 1000; most *= 1000) {
                    const double dt = 1.0 / 64;
                    cd_membrane* m = wild_membrane((enum wild)kind, 12, 9, 1, CD_FLOAT64, 1e4 / (dt * dt), 3);
                    sheet_set_time_step(m, &ways[w]);
                    ok(cd_membrane_set_solver(m, CD_SOLVER_COUPLED));
                    ok(cd_membrane_set_tolerance(m, tolerances[k], most));
                    wild_shake(m, 1, 1 / dt, 4);
                    const struct extremes e = run(m, &ways[w], dt, 0, 5, 4);
                    const double least = w == 0 ? 1 - 1e-10 : 0;
                    if (!(e.highest <= 1 + 1e-10 && e.lowest >= least))
                        print_message("%s, %s, tolerance %g, at most %zu: energy from x %.12g to x %.12g\n",
                                      wild_names[kind], ways[w].name, tolerances[k], most, e.lowest, e.highest);
                    assert_true(e.highest <= 1 + 1e-10 && e.lowest >= least);
                    cd_membrane_destroy(m);
                }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(alternating_float64_never_gains_energy_at_any_stiffness),
        cmocka_unit_test(alternating_float32_never_gains_energy_at_any_stiffness),
        cmocka_unit_test(coupled_float64_never_gains_energy_at_any_stiffness),
        cmocka_unit_test(coupled_float32_never_gains_energy_at_any_stiffness),
        cmocka_unit_test(coupled_never_gains_energy_whatever_its_tolerance),
    };
    return cmocka_run_group_tests_name("membrane implicit", tests, NULL, NULL);
}
