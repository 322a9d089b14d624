/* Constant forces: sheets fall exactly, come to rest where a direct solve says, whatever the step, and stay there. */
#include <math.h>
#include <stdlib.h>

#include "check.h"
#include "grid.h"
#include "reference.h"
#include "sheet.h"
#include "wild.h"

enum { COLUMNS = 17, ROWS = 13, COMPONENTS = 2, NUMBERS = COLUMNS * ROWS * COMPONENTS };
static const char* const solver_names[] = {"alternating", "coupled"};

/* After N steps of dt a fall from rest has covered g dt^2 (N^2 / 2 + (lambda - 1/2) N); see test_statics.c. */
static void a_free_sheet_falls_exactly(void** state) {
    (void)state;
    static const enum wild kinds[] = {WILD_FREE, WILD_HALF_EDGES, WILD_RANDOM_SPRINGS, WILD_ROUND, WILD_PLATE_FREE};
    const double g[COMPONENTS] = {-9.81, 0.5}, n = 300;
    for (size_t k = 0; k < COUNT(kinds); ++k)
        for (int solver = 0; solver < 2; ++solver)
            for (int p = 0; p < 2; ++p)
                for (size_t way = 0; way < TIME_STEPS; ++way) {
                    const struct time_step* step = &time_steps[way];
                    double lambda = step->lambda, dt = 1.0 / 60;
                    if (step->method == CD_METHOD_SYMPLECTIC_EULER) lambda = 1;
                    if (step->method == CD_METHOD_STIFF_SECOND) lambda = 0.5;
                    cd_membrane* m = wild_membrane(kinds[k], COLUMNS, ROWS, COMPONENTS, p ? CD_FLOAT64 : CD_FLOAT32,
                                                   step->grows || step->is_explicit ? 1 : 1e6, 3);
                    struct grid* sums = grid_of(m);
                    sheet_set_time_step(m, step);
                    ok(cd_membrane_set_solver(m, solver));
                    ok(cd_membrane_set_gravity(m, g, COMPONENTS));
                    ok(cd_membrane_step(m, dt, (size_t)n));
                    double x[NUMBERS], v[NUMBERS];
                    sheet_read(m, CD_POSITION, x);
                    sheet_read(m, CD_VELOCITY, v);
                    for (size_t i = 0; i < NUMBERS; ++i) {
                        const double a = g[i % COMPONENTS], allowed = p ? 1e-12 : 1e-4;
                        if (sums->absent[i / COMPONENTS]) {
                            assert_true(x[i] == 0 && v[i] == 0);
                            continue;
                        }
                        if (fabs(v[i] - a * n * dt) > allowed * fabs(a) * n * dt)
                            print_message("%s, %s, %s, float%d\n", wild_names[kinds[k]], solver_names[solver],
                                          step->name, p ? 64 : 32);
                        assert_near(v[i], a * n * dt, allowed, 0);
                        assert_near(x[i], a * dt * dt * (n * n / 2 + (lambda - 0.5) * n), allowed, 0);
                    }
                    grid_destroy(sums);
                    cd_membrane_destroy(m);
                }
}

/* Where the sheets rest that gravity, forces and ties pull at. */
static cd_membrane* make_loaded(enum wild kind, double ratio, cd_precision precision) {
    cd_membrane* m = wild_membrane(kind, COLUMNS, ROWS, COMPONENTS, precision, ratio, 21);
    const double gravity[COMPONENTS] = {0, -9.81}, target[COMPONENTS] = {0.5, 1};
    double force[NUMBERS], x[NUMBERS];
    uint64_t seed = 5;
    for (size_t i = 0; i < NUMBERS; ++i) force[i] = random_number(&seed), x[i] = random_number(&seed);
    ok(cd_membrane_set_gravity(m, gravity, COMPONENTS));
    ok(cd_membrane_enable_field(m, CD_FORCE));
    sheet_write(m, CD_FORCE, force);
    if (kind == WILD_TIED) ok(cd_membrane_attach(m, 3, 3, ratio, 0, target, COMPONENTS));
    sheet_write(m, CD_POSITION, x); /* where the pins are, too */
    return m;
}

static const enum wild held[] = {WILD_DRUM, WILD_FLAG,         WILD_CORNERS,    WILD_PINS,
                                 WILD_CUT,  WILD_HINGED,       WILD_PLATE_RING, WILD_ROWS_HELD,
                                 WILD_TIED, WILD_CYLINDER_PIN, WILD_RANDOM_ALL};

static double farthest(const double* a, const double* b) {
    double far = 0;
    for (size_t i = 0; i < NUMBERS; ++i) far = fmax(far, fabs(a[i] - b[i]));
    return far;
}

static double largest(const double* a) {
    double size = 0;
    for (size_t i = 0; i < NUMBERS; ++i) size = fmax(size, fabs(a[i]));
    return size;
}

static void a_sheet_started_at_rest_in_balance_stays_there(void** state) {
    (void)state;
    static const size_t ways[] = {LAMBDA_1_2, LAMBDA_1, STIFF_SECOND};
    static const double ratios[] = {10, 1e4, 1e8}, dts[] = {1e-3, 1.0 / 60, 1, 1e3};
    double worst[2] = {0, 0};
    for (size_t k = 0; k < COUNT(held); ++k)
        for (size_t r = 0; r < COUNT(ratios); ++r)
            for (size_t d = 0; d < COUNT(dts); ++d)
                for (size_t w = 0; w < COUNT(ways); ++w) {
                    const cd_solver solver = (cd_solver)((k + r + d + w) % 2);
                    cd_membrane* m = make_loaded(held[k], ratios[r], CD_FLOAT64);
                    struct grid* g = grid_of(m);
                    double rest[NUMBERS], x[NUMBERS];
                    sheet_read(m, CD_POSITION, rest);
                    grid_rest(g, rest);
                    sheet_write(m, CD_POSITION, rest);
                    sheet_set_time_step(m, &time_steps[ways[w]]);
                    ok(cd_membrane_set_solver(m, solver));
                    sheet_step(m, dts[d], 100); /* a residual of rounding does not shrink by another 1e-6 */
                    sheet_read(m, CD_POSITION, x);
                    const double off = farthest(x, rest) / largest(rest);
                    if (!(off <= 1e-10))
                        print_message("%s, %s, %s, k/m %g, dt %g: leaves its rest by %.1e\n", wild_names[held[k]],
                                      solver_names[solver], time_steps[ways[w]].name, ratios[r], dts[d], off);
                    worst[solver] = fmax(worst[solver], off);
                    grid_destroy(g);
                    cd_membrane_destroy(m);
                }
    print_message("sheets started in balance leave it by %.1e (alternating), %.1e (coupled)\n", worst[0], worst[1]);
    assert_true(worst[0] <= 1e-10);
    assert_true(worst[1] <= 1e-10);
}

/* From anywhere, with lambda 1 and at most this many steps. Coupled is there almost at once; alternating takes the more
 * steps the larger k / m dt^2 is, and comes to the same place. */
static size_t steps_to_rest(enum wild kind, double ratio, double dt, cd_solver solver, size_t most, double* out_off) {
    cd_membrane* m = make_loaded(kind, ratio, CD_FLOAT64);
    struct grid* g = grid_of(m);
    double rest[NUMBERS], x[NUMBERS];
    size_t steps = 0;
    sheet_read(m, CD_POSITION, rest);
    grid_rest(g, rest);
    ok(cd_membrane_set_lambda(m, 1));
    ok(cd_membrane_set_solver(m, solver));
    do {
        const size_t more = steps < 16 ? 1 : steps / 8;
        sheet_step(m, dt, more);
        steps += more;
        sheet_read(m, CD_POSITION, x);
        *out_off = farthest(x, rest) / largest(rest);
    } while (!(*out_off <= 1e-8) && steps < most);
    grid_destroy(g);
    cd_membrane_destroy(m);
    return steps;
}

static void a_sheet_started_elsewhere_comes_to_rest_in_the_same_place_at_any_dt(void** state) {
    (void)state;
    static const struct { double ratio, dt; } cases[] = {{1e4, 1.0 / 60}, {10, 1}, {1, 10}, {1e8, 1}};
    for (size_t k = 0; k < COUNT(held); ++k)
        for (size_t c = 0; c < COUNT(cases); ++c)
            for (int solver = 0; solver < 2; ++solver) {
                double off;
                const double at = cases[c].ratio * cases[c].dt * cases[c].dt;
                const double most = held[k] == WILD_RANDOM_ALL ? 30 : 1000; /* beyond, too many steps */
                if (solver == CD_SOLVER_ALTERNATING ? at > most : at < 30) continue;
                const size_t steps = steps_to_rest(held[k], cases[c].ratio, cases[c].dt, solver, 100000, &off);
                print_message("%-18s %-11s k/m dt^2 = %-6.3g within %.1e of its rest after %zu steps\n",
                              wild_names[held[k]], solver_names[solver], at, off, steps);
                assert_true(off <= 1e-8);
            }
}

/* The drum that gravity pulls at: a series for Poisson's equation u_xx + u_yy = -1 on the unit square. */
static double poisson(double x, double y) {
    double sum = 0;
    for (int n = 1; n < 400; n += 2) {
        const double t = n * (double)PI, far = t * (y - 0.5);
        /* cosh(t (y - 1/2)) / cosh(t / 2), with no overflow */
        const double decay = (exp(far - t / 2) + exp(-far - t / 2)) / (1 + exp(-t));
        sum += 4 / (t * t * t) * sin(t * x) * (1 - decay);
    }
    return sum;
}

static void a_drum_sags_as_poisson_says_to_second_order(void** state) {
    (void)state;
    const double down = -1;
    for (int rule = 0; rule < 2; ++rule) {
        double before = 0, order = 0, error = 0;
        for (size_t springs = 8; springs <= 32; springs *= 2) {
            const struct sheet s = {.ends = {SHEET_FIXED, SHEET_FIXED},
                                    .nodes = {springs + 1, springs + 1},
                                    .rule = rule,
                                    .mass = 3,
                                    .stiffness = {2, 2}};
            /* equal masses make all of the sheet a little lighter than it is: (springs + 1)^2 nodes share the mass of
             * springs^2 cells, and as many rows the stiffness of springs of them */
            const double n = (double)springs, heavier = rule == CD_MASS_HALF_ENDS ? 1 : (n + 1) / n;
            cd_membrane* m = sheet_membrane(&s, 1, CD_FLOAT64);
            ok(cd_membrane_set_gravity(m, &down, 1));
            ok(cd_membrane_set_lambda(m, 1));
            ok(cd_membrane_set_solver(m, CD_SOLVER_COUPLED));
            ok(cd_membrane_step(m, 1000, 10));
            error = 0;
            for (size_t i = 0; i < s.nodes[0] * s.nodes[1]; ++i) {
                const size_t u = i % s.nodes[0], v = i / s.nodes[0];
                const double exact = -s.mass / s.stiffness[0] * poisson((double)u / n, (double)v / n);
                error = fmax(error, fabs(sheet_get(m, CD_POSITION, u, v) * heavier - exact));
            }
            order = log2(before / error);
            before = error;
            cd_membrane_destroy(m);
        }
        print_message("%-12s a drum sags as Poisson says to %.1e, order %.2f\n", rule ? "half edges" : "equal masses",
                      error, order);
        assert_true(error < 1e-3);
        assert_true(fabs(order - 2) < 0.1);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_free_sheet_falls_exactly),
        cmocka_unit_test(a_sheet_started_at_rest_in_balance_stays_there),
        cmocka_unit_test(a_sheet_started_elsewhere_comes_to_rest_in_the_same_place_at_any_dt),
        cmocka_unit_test(a_drum_sags_as_poisson_says_to_second_order),
    };
    return cmocka_run_group_tests_name("membrane statics", tests, NULL, NULL);
}
