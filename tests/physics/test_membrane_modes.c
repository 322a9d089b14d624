/* All modes of uniform sheets at once: the state after many steps equals the closed form, for every method and both
 * solvers. The alternating one is held to the closed form of its two factors, not to that of the system. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "check.h"
#include "grid.h"
#include "reference.h"
#include "sheet.h"

enum { COMPONENTS = 2, KINDS = 9, MOST_NODES = 20 * 15 };

/* What the tests go through: the edges, who counts half, bend. */
static const struct {
    const char* name;
    enum sheet_ends ends[2];
    cd_mass_rule rule;
    double bend;
} kinds[KINDS] = {
    {"free", {SHEET_FREE, SHEET_FREE}, CD_MASS_EQUAL, 0},
    {"free, half edges", {SHEET_FREE, SHEET_FREE}, CD_MASS_HALF_ENDS, 0},
    {"drum", {SHEET_FIXED, SHEET_FIXED}, CD_MASS_EQUAL, 0},
    {"drum, half edges", {SHEET_FIXED, SHEET_FIXED}, CD_MASS_HALF_ENDS, 0},
    {"flag", {SHEET_FIXED_FREE, SHEET_FREE}, CD_MASS_EQUAL, 0},
    {"flag, half edges", {SHEET_FIXED_FREE, SHEET_FREE}, CD_MASS_HALF_ENDS, 0},
    {"torus", {SHEET_RING, SHEET_RING}, CD_MASS_EQUAL, 0},
    {"hinged plate", {SHEET_FIXED, SHEET_FIXED}, CD_MASS_EQUAL, 2e-3},
    {"plate ring", {SHEET_RING, SHEET_FIXED}, CD_MASS_EQUAL, 2e-3},
};

static struct sheet sheet_of_kind(int kind, size_t columns, size_t rows) {
    return (struct sheet){.ends = {kinds[kind].ends[0], kinds[kind].ends[1]},
                          .nodes = {columns, rows},
                          .rule = kinds[kind].rule,
                          .mass = 1.3,
                          .stiffness = {0.7, 1.1},
                          .bend = kinds[kind].bend};
}

struct worst {
    double error;
    char what[160];
};

/* How far dt goes, in units of 1 / omega_max: see test_modes.c. */
static const double growing[] = {0.05, 0}, symplectic[] = {0.3, 1.7, 0}, implicit64[] = {0.3, 3, 50, 0};
static const double symplectic32[] = {0.3, 1.2, 0}, implicit32[] = {0.3, 1, 0};

static const double* reaches_of(const struct time_step* step, cd_precision precision) {
    if (step->grows) return growing;
    if (step->is_explicit) return precision == CD_FLOAT32 ? symplectic32 : symplectic;
    return precision == CD_FLOAT32 ? implicit32 : implicit64;
}

enum { MOST_SIDE = 20 };
typedef long double amplitudes[MOST_SIDE][MOST_SIDE]; /* of mode (p, q) at [q][p] */

/* out[v][u] = sum over the modes of amplitude times shape, first along u, then along v. */
static void add_up(const struct sheet* s, amplitudes a, long double* out, size_t stride) {
    static amplitudes rows;
    long double shape[2][MOST_SIDE][MOST_SIDE];
    for (int d = 0; d < 2; ++d)
        for (size_t j = sheet_first_mode(s, d); j <= sheet_last_mode(s, d); ++j)
            for (size_t i = 0; i < s->nodes[d]; ++i) shape[d][j][i] = sheet_line_shape(s, d, j, i);
    for (size_t q = sheet_first_mode(s, 1); q <= sheet_last_mode(s, 1); ++q)
        for (size_t u = 0; u < s->nodes[0]; ++u) {
            rows[q][u] = 0;
            for (size_t p = sheet_first_mode(s, 0); p <= sheet_last_mode(s, 0); ++p)
                rows[q][u] += a[q][p] * shape[0][p][u];
        }
    for (size_t i = 0; i < s->nodes[0] * s->nodes[1]; ++i) {
        long double sum = 0;
        for (size_t q = sheet_first_mode(s, 1); q <= sheet_last_mode(s, 1); ++q)
            sum += rows[q][i % s->nodes[0]] * shape[1][q][i / s->nodes[0]];
        out[i * stride] = sum;
    }
}

/* Every mode gets an amplitude and a velocity of its own, and moves by its own matrix: all of them together, before and
 * after. A velocity of omega times the amplitude; the shift is not pushed, so that it does not run away. */
static void add_modes(const struct sheet* s, const struct time_step* step, cd_solver solver, double dt, size_t steps,
                      size_t c, long double* x0, long double* v0, long double* x1, long double* v1) {
    static amplitudes x, v, xn, vn;
    uint64_t seed = 40 + c;
    for (size_t q = sheet_first_mode(s, 1); q <= sheet_last_mode(s, 1); ++q)
        for (size_t p = sheet_first_mode(s, 0); p <= sheet_last_mode(s, 0); ++p) {
            const struct sheet_mode mode = sheet_mode(s, p, q);
            const struct matrix2 g = matrix_power(sheet_step_matrix(s, &mode, step, solver, dt), steps);
            x[q][p] = random_number(&seed), v[q][p] = random_number(&seed) * sheet_omega(&mode);
            xn[q][p] = g.a[0][0] * x[q][p] + g.a[0][1] * v[q][p];
            vn[q][p] = g.a[1][0] * x[q][p] + g.a[1][1] * v[q][p];
        }
    add_up(s, x, x0 + c, COMPONENTS);
    add_up(s, v, v0 + c, COMPONENTS);
    add_up(s, xn, x1 + c, COMPONENTS);
    add_up(s, vn, v1 + c, COMPONENTS);
}

/* The largest error over the largest number, velocities in units of omega_max. Where nothing holds the sheet, what its
 * momentum loses by rounding, about (omega_max dt)^2 times what velocities do, shifts it for the rest of the run. */
static void compare_one(const struct sheet* s, const char* name, const struct time_step* step, cd_solver solver,
                        double dt, size_t steps, cd_precision precision, struct worst* worst) {
    static long double x0[MOST_NODES * COMPONENTS], v0[MOST_NODES * COMPONENTS];
    static long double x1[MOST_NODES * COMPONENTS], v1[MOST_NODES * COMPONENTS];
    static double x[MOST_NODES * COMPONENTS], v[MOST_NODES * COMPONENTS];
    const size_t numbers = s->nodes[0] * s->nodes[1] * COMPONENTS;
    const long double fastest = sheet_omega_max(s);
    for (size_t c = 0; c < COMPONENTS; ++c) add_modes(s, step, solver, dt, steps, c, x0, v0, x1, v1);
    for (size_t i = 0; i < numbers; ++i) x[i] = (double)x0[i], v[i] = (double)v0[i];
    cd_membrane* m = sheet_membrane(s, COMPONENTS, precision);
    sheet_set_time_step(m, step);
    ok(cd_membrane_set_solver(m, solver));
    ok(cd_membrane_set_tolerance(m, precision == CD_FLOAT32 ? 1e-8 : 1e-13, 100));
    sheet_write(m, CD_POSITION, x);
    sheet_write(m, CD_VELOCITY, v);
    sheet_step(m, dt, steps); /* what is left when all but one mode has died out is rounding, and does not shrink */
    sheet_read(m, CD_POSITION, x);
    sheet_read(m, CD_VELOCITY, v);
    cd_membrane_destroy(m);
    long double size = 0, error = 0;
    for (size_t i = 0; i < numbers; ++i) {
        size = fmaxl(size, fmaxl(fabsl(x0[i]), fabsl(v0[i]) / fastest));
        size = fmaxl(size, fmaxl(fabsl(x1[i]), fabsl(v1[i]) / fastest));
        error = fmaxl(error, fmaxl(fabsl(x[i] - x1[i]), fabsl(v[i] - v1[i]) / fastest));
    }
    const long double reach = fastest * dt;
    error /= size * (sheet_first_mode(s, 0) + sheet_first_mode(s, 1) == 0 ? 1 + reach * reach / 25 : 1);
    if (!((double)error > worst->error) && error == error) return;
    worst->error = (double)error;
    snprintf(worst->what, sizeof worst->what,
             "%s, %s, %s, %zu x %zu, omega_max dt = %.3g, drag dt = %.2g, damping / dt = %.2g", name, step->name,
             solver == CD_SOLVER_COUPLED ? "coupled" : "alternating", s->nodes[0], s->nodes[1], (double)(fastest * dt),
             s->drag * dt, s->damping / dt);
}

/* Without damping, with some of both kinds, and, where no limit forbids it, with so much that fast modes creep. */
static void compare_damped(struct sheet s, const char* name, const struct time_step* step, cd_solver solver,
                           cd_precision precision, struct worst* worst) {
    const double fastest = (double)sheet_omega_max(&s);
    const size_t steps = precision == CD_FLOAT32 ? 200 : 1000;
    for (const double* reach = reaches_of(step, precision); *reach > 0; ++reach) {
        const double dt = *reach / fastest;
        const struct {
            double drag, damping;
        } dampings[] = {{0, 0}, {1e-3 / dt, 0.02 / (fastest * fastest * dt)}, {0.01 / dt, 3 * dt}};
        for (size_t d = 0; d < COUNT(dampings) - (step->is_explicit ? 1 : 0); ++d) {
            s.drag = dampings[d].drag;
            s.damping = dampings[d].damping;
            compare_one(&s, name, step, solver, dt, solver == CD_SOLVER_COUPLED ? 20 : steps, precision, worst);
        }
    }
}

static void compare(int kind, cd_solver solver, cd_precision precision, double allowed) {
    static const size_t sizes[][2] = {{5, 4}, {9, 13}, {20, 15}};
    struct worst worst = {0, ""};
    for (size_t k = 0; k < COUNT(sizes) - (solver == CD_SOLVER_COUPLED ? 1 : 0); ++k)
        for (size_t m = 0; m < TIME_STEPS; ++m) {
            if (solver == CD_SOLVER_COUPLED && !sheet_solves(&time_steps[m])) continue;
            compare_damped(sheet_of_kind(kind, sizes[k][0], sizes[k][1]), kinds[kind].name, &time_steps[m], solver,
                           precision, &worst);
        }
    print_message("%-17s float%d: largest error %.2e of %.0e (%s)\n", kinds[kind].name,
                  precision == CD_FLOAT32 ? 32 : 64, worst.error, allowed, worst.what);
    assert_true(worst.error <= allowed);
}

static void alternating_matches_its_factors_in_float64(void** state) {
    compare(*(const int*)*state, CD_SOLVER_ALTERNATING, CD_FLOAT64, 1e-10);
}

static void alternating_matches_its_factors_in_float32(void** state) {
    compare(*(const int*)*state, CD_SOLVER_ALTERNATING, CD_FLOAT32, 1e-4);
}

static void coupled_matches_the_system_in_float64(void** state) {
    compare(*(const int*)*state, CD_SOLVER_COUPLED, CD_FLOAT64, 1e-10);
}

static void coupled_matches_the_system_in_float32(void** state) {
    compare(*(const int*)*state, CD_SOLVER_COUPLED, CD_FLOAT32, 1e-4);
}

/* The closed forms against sums over springs, bends and twists: K shape = omega^2 M shape, whole and by directions. */
static void the_closed_forms_are_those_of_the_sheets(void** state) {
    (void)state;
    long double x[MOST_NODES], force[MOST_NODES];
    for (int kind = 0; kind < KINDS; ++kind) {
        const struct sheet s = sheet_of_kind(kind, 7, 6);
        cd_membrane* m = sheet_membrane(&s, 1, CD_FLOAT64);
        struct grid* g = grid_of(m);
        const long double scale = sheet_omega_max(&s) * sheet_omega_max(&s) * sheet_node_mass(&s);
        long double worst = 0;
        for (size_t q = sheet_first_mode(&s, 1); q <= sheet_last_mode(&s, 1); ++q)
            for (size_t p = sheet_first_mode(&s, 0); p <= sheet_last_mode(&s, 0); ++p) {
                const struct sheet_mode mode = sheet_mode(&s, p, q);
                const long double parts[] = {mode.along[0], mode.along[1], mode.twist, 0,
                                             mode.along[0] + mode.along[1] + mode.twist};
                for (size_t i = 0; i < g->nodes; ++i) x[i] = sheet_shape(&s, p, q, i % 7, i / 7);
                for (int part = GRID_ALONG_U; part <= GRID_ALL; ++part) {
                    grid_stiffness(g, (enum grid_kind)part, x, force);
                    for (size_t i = 0; i < g->nodes; ++i)
                        worst = fmaxl(worst, fabsl(force[i] - parts[part] * g->mass[i] * x[i]) / scale);
                }
            }
        print_message("%-17s closed forms and sums agree to %.1Le\n", kinds[kind].name, worst);
        assert_true(worst < 1e-15L);
        grid_destroy(g);
        cd_membrane_destroy(m);
    }
}

int main(void) {
    static const struct {
        const char* name;
        CMUnitTestFunction function;
    } parts[] = {{"alternating_matches_its_factors_in_float64", alternating_matches_its_factors_in_float64},
                 {"alternating_matches_its_factors_in_float32", alternating_matches_its_factors_in_float32},
                 {"coupled_matches_the_system_in_float64", coupled_matches_the_system_in_float64},
                 {"coupled_matches_the_system_in_float32", coupled_matches_the_system_in_float32}};
    static int numbers[KINDS];
    static char names[KINDS][COUNT(parts)][80];
    struct CMUnitTest tests[KINDS * COUNT(parts) + 1];
    size_t count = 1;
    tests[0] = (struct CMUnitTest)cmocka_unit_test(the_closed_forms_are_those_of_the_sheets);
    for (int kind = 0; kind < KINDS; ++kind)
        for (size_t k = 0; k < COUNT(parts); ++k) {
            numbers[kind] = kind;
            snprintf(names[kind][k], sizeof names[kind][k], "%s: %s", parts[k].name, kinds[kind].name);
            tests[count++] = (struct CMUnitTest){names[kind][k], parts[k].function, NULL, NULL, &numbers[kind]};
        }
    return _cmocka_run_group_tests("membrane modes", tests, count, NULL, NULL);
}
