/* Orders of accuracy of sheets, measured by halving the step and doubling the lattice, and the error that the
 * alternating solver adds to what is fast along both directions. */
#include <math.h>
#include <stdlib.h>

#include "check.h"
#include "grid.h"
#include "sheet.h"

static const char* const solver_names[] = {"alternating", "coupled"};

/* ---- in time: against the exact motion of the same lattice ------------------------------------------------------- */

enum { COLUMNS = 9, ROWS = 7, NODES = COLUMNS * ROWS };

/* x and v at time t of x'' + c x' + omega^2 x = 0. */
static void swing(long double omega, long double c, long double t, long double x0, long double v0, long double* x,
                  long double* v) {
    const long double g = c / 2, w = sqrtl(omega * omega - g * g), decay = expl(-g * t);
    const long double s = sinl(w * t) / w, co = cosl(w * t);
    *x = decay * (x0 * (co + g * s) + v0 * s);
    *v = decay * (v0 * (co - g * s) - x0 * omega * omega * s);
}

/* Largest error in x and v at time 1 of a sheet that swings in four modes. */
static double time_error(const struct sheet* s, const struct time_step* step, cd_solver solver, size_t steps) {
    static const size_t modes[][2] = {{1, 1}, {2, 1}, {1, 2}, {2, 2}};
    double x[NODES] = {0}, v[NODES] = {0};
    long double exact_x[NODES] = {0}, exact_v[NODES] = {0};
    for (size_t k = 0; k < COUNT(modes); ++k) {
        const struct sheet_mode mode = sheet_mode(s, modes[k][0], modes[k][1]);
        const long double omega = sheet_omega(&mode), c = s->drag + s->damping * omega * omega;
        const long double x0 = 1.0L / (long double)(k + 1), v0 = k % 2 ? 1 : -1;
        long double xt, vt;
        swing(omega, c, 1, x0, v0, &xt, &vt);
        for (size_t i = 0; i < NODES; ++i) {
            const long double shape = sheet_shape(s, modes[k][0], modes[k][1], i % COLUMNS, i / COLUMNS);
            x[i] += (double)(x0 * shape), v[i] += (double)(v0 * shape);
            exact_x[i] += xt * shape, exact_v[i] += vt * shape;
        }
    }
    cd_membrane* m = sheet_membrane(s, 1, CD_FLOAT64);
    sheet_set_time_step(m, step);
    ok(cd_membrane_set_solver(m, solver));
    ok(cd_membrane_set_tolerance(m, 1e-12, 100));
    sheet_write(m, CD_POSITION, x);
    sheet_write(m, CD_VELOCITY, v);
    ok(cd_membrane_step(m, 1 / (double)steps, steps));
    sheet_read(m, CD_POSITION, x);
    sheet_read(m, CD_VELOCITY, v);
    cd_membrane_destroy(m);
    double error = 0;
    for (size_t i = 0; i < NODES; ++i)
        error = fmax(error, fmax(fabs(x[i] - (double)exact_x[i]), fabs(v[i] - (double)exact_v[i])));
    return error;
}

static int order_of(const struct time_step* step) {
    return step->lambda == 0.5 || step->method == CD_METHOD_STIFF_SECOND ? 2 : 1;
}

static void methods_keep_their_orders_in_time_with_both_solvers(void** state) {
    (void)state;
    static const enum sheet_ends ends[][2] = {
        {SHEET_FREE, SHEET_FREE}, {SHEET_FIXED_FREE, SHEET_FREE}, {SHEET_RING, SHEET_RING}, {SHEET_FIXED, SHEET_FIXED}};
    for (size_t k = 0; k < COUNT(ends); ++k)
        for (int damped = 0; damped < 2; ++damped)
            for (int solver = 0; solver < 2; ++solver)
                for (size_t m = 0; m < TIME_STEPS; ++m) {
                    if (solver == CD_SOLVER_COUPLED && m < LAMBDA_1_4) continue;
                    const int plate = ends[k][0] == SHEET_FIXED;
                    const struct sheet s = {.ends = {ends[k][0], ends[k][1]},
                                            .nodes = {COLUMNS, ROWS},
                                            .mass = 1.5,
                                            .stiffness = {2, 1.5},
                                            .bend = plate ? 2e-3 : 0,
                                            .drag = damped ? 0.4 : 0,
                                            .damping = damped ? 0.01 : 0};
                    size_t steps = 250;
                    double error = time_error(&s, &time_steps[m], solver, steps), measured = 0;
                    for (int halving = 0; halving < 3; ++halving) {
                        const double finer = time_error(&s, &time_steps[m], solver, steps *= 2);
                        measured = log2(error / finer);
                        error = finer;
                    }
                    if (m == LAMBDA_1_2 || m == STIFF_SECOND)
                        print_message("ends %d %d, %-12s %-11s damped %d: order %.3f, error %.1e at dt = 1/%zu\n",
                                      ends[k][0], ends[k][1], time_steps[m].name, solver_names[solver], damped,
                                      measured, error, steps);
                    /* factors that count the twist as bend of both directions count its damping so, to first order */
                    const int twisted = plate && damped && solver == CD_SOLVER_ALTERNATING;
                    if (twisted && order_of(&time_steps[m]) == 2) assert_true(measured > 0.95 && measured < 2.05);
                    else assert_true(fabs(measured - order_of(&time_steps[m])) < 0.05);
                }
}

/* Hung by two corners a sheet has no modes in closed form: it is let go from where it would rest if pushed, and
 * followed with much shorter steps of a direct solver, whose own error is then taken out. */
static void let_go(cd_membrane* m, size_t columns, size_t rows) {
    const double down = -1;
    ok(cd_membrane_set_stiffness(m, 2, 1.5));
    ok(cd_membrane_set_mass_rule(m, CD_MASS_HALF_ENDS));
    ok(cd_membrane_enable_field(m, CD_PIN));
    sheet_set(m, CD_PIN, 0, rows - 1, CD_NODE_PINNED);
    sheet_set(m, CD_PIN, columns - 1, rows - 1, CD_NODE_PINNED);
    ok(cd_membrane_set_gravity(m, &down, 1));
}

static void a_sheet_hung_by_two_corners_is_followed_to_second_order(void** state) {
    (void)state;
    static const double end = 2;
    double start[NODES] = {0}, exact[2][NODES], coarse[2][NODES];
    cd_membrane* m = NULL;
    ok(cd_membrane_create(COLUMNS - 1, ROWS - 1, 1, CD_FLOAT64, NULL, &m));
    ok(cd_membrane_set_solver(m, CD_SOLVER_ALTERNATING));
    let_go(m, COLUMNS, ROWS);
    struct grid* g = grid_of(m);
    grid_rest(g, start);
    g->gravity[0] = 0;
    for (int k = 0; k < 2; ++k) {
        const size_t steps = k ? 8192 : 4096;
        for (size_t i = 0; i < NODES; ++i) exact[0][i] = start[i], exact[1][i] = 0;
        grid_step(g, &time_steps[LAMBDA_1_2], end / (long double)steps, steps, exact[0], exact[1]);
        for (size_t i = 0; i < NODES && k == 0; ++i) coarse[0][i] = exact[0][i], coarse[1][i] = exact[1][i];
    }
    for (size_t i = 0; i < NODES; ++i)
        for (int k = 0; k < 2; ++k) exact[k][i] += (exact[k][i] - coarse[k][i]) / 3;
    const double none = 0;
    ok(cd_membrane_set_gravity(m, &none, 1));
    for (int solver = 0; solver < 2; ++solver)
        for (size_t way = LAMBDA_1_2; way <= STIFF_SECOND; ++way) {
            double before = 0, order = 0, error = 0;
            if (way == LAMBDA_3_4 || way == LAMBDA_1) continue;
            ok(cd_membrane_set_solver(m, solver));
            ok(cd_membrane_set_tolerance(m, 1e-10, 100));
            sheet_set_time_step(m, &time_steps[way]);
            for (size_t steps = 64; steps <= 512; steps *= 2) {
                double x[NODES], v[NODES];
                ok(cd_membrane_reset(m));
                sheet_write(m, CD_POSITION, start);
                ok(cd_membrane_step(m, end / (double)steps, steps));
                sheet_read(m, CD_POSITION, x);
                sheet_read(m, CD_VELOCITY, v);
                error = 0;
                for (size_t i = 0; i < NODES; ++i)
                    error = fmax(error, fmax(fabs(x[i] - exact[0][i]), fabs(v[i] - exact[1][i])));
                order = log2(before / error);
                before = error;
            }
            print_message("hung by two corners, %-12s %-11s order %.2f, error %.1e at dt = 1/256\n",
                          time_steps[way].name, solver_names[solver], order, error);
            assert_true(error < 1e-2);
            assert_true(fabs(order - 2) < 0.2);
        }
    grid_destroy(g);
    cd_membrane_destroy(m);
}

/* ---- in space: against the wave equation ------------------------------------------------------------------------- */

/* cos(p pi u) cos(q pi v) swings at pi sqrt(p^2 c_u^2 + q^2 c_v^2). The error after about a period, with dt as short
 * against the lattice each time. */
static double space_error(cd_mass_rule rule, cd_solver solver, size_t p, size_t q, size_t springs) {
    const struct sheet s = {
        .nodes = {springs + 1, springs * 3 / 4 + 1}, .rule = rule, .mass = 2, .stiffness = {1.5, 2.5}};
    const size_t nodes = s.nodes[0] * s.nodes[1], steps = 4 * springs;
    const double nu = (double)springs, nv = (double)(s.nodes[1] - 1), time = 2;
    const double cu2 = s.stiffness[0] / s.mass, cv2 = s.stiffness[1] / s.mass;
    const double omega = (double)PI * sqrt((double)(p * p) * cu2 + (double)(q * q) * cv2);
    double* x = calloc(nodes, sizeof *x);
    assert_non_null(x);
    cd_membrane* m = sheet_membrane(&s, 1, CD_FLOAT64);
    ok(cd_membrane_set_solver(m, solver));
    ok(cd_membrane_set_tolerance(m, 1e-9, 100));
    for (size_t i = 0; i < nodes; ++i) {
        const double u = (double)(i % s.nodes[0]) / nu, v = (double)(i / s.nodes[0]) / nv;
        x[i] = cos((double)PI * (double)p * u) * cos((double)PI * (double)q * v);
    }
    sheet_write(m, CD_POSITION, x);
    ok(cd_membrane_step(m, time / (double)steps, steps));
    double error = 0;
    for (size_t i = 0; i < nodes; ++i) {
        const double exact = x[i] * cos(omega * time);
        double now;
        ok(cd_membrane_read_f64(m, CD_POSITION, i % s.nodes[0], i / s.nodes[0], 1, 1, &now, 1));
        error = fmax(error, fabs(now - exact));
    }
    cd_membrane_destroy(m);
    free(x);
    return error;
}

static void half_edges_are_second_order_in_space_and_equal_masses_first(void** state) {
    (void)state;
    static const size_t modes[][2] = {{1, 0}, {0, 2}, {1, 1}, {2, 1}};
    for (int rule = CD_MASS_EQUAL; rule <= CD_MASS_HALF_ENDS; ++rule)
        for (int solver = 0; solver < 2; ++solver)
            for (size_t k = 0; k < COUNT(modes); ++k) {
                double before = 0, order = 0, error = 0;
                for (size_t springs = 16; springs <= 128; springs *= 2) {
                    error = space_error(rule, solver, modes[k][0], modes[k][1], springs);
                    order = log2(before / error);
                    before = error;
                }
                print_message("%-12s %-11s mode (%zu, %zu): order %.2f, error %.1e at 128 x 96\n",
                              rule ? "half edges" : "equal masses", solver_names[solver], modes[k][0], modes[k][1],
                              order, error);
                assert_true(fabs(order - (rule ? 2 : 1)) < (rule ? 0.1 : 0.25));
            }
}

/* ---- what factoring costs ---------------------------------------------------------------------------------------- */

/* The angle that a mode turns by in one step, from x_{n+1} + x_{n-1} = 2 cos(angle) x_n, over the step's omega dt. */
static double turn(const struct sheet* s, size_t p, size_t q, cd_solver solver, double dt) {
    const size_t nodes = s->nodes[0] * s->nodes[1];
    double* shape = calloc(nodes, sizeof *shape);
    double* x = calloc(nodes, sizeof *x);
    assert_non_null(shape);
    assert_non_null(x);
    for (size_t i = 0; i < nodes; ++i) shape[i] = (double)sheet_shape(s, p, q, i % s->nodes[0], i / s->nodes[0]);
    cd_membrane* m = sheet_membrane(s, 1, CD_FLOAT64);
    ok(cd_membrane_set_solver(m, solver));
    ok(cd_membrane_set_tolerance(m, 1e-13, 100));
    sheet_write(m, CD_POSITION, shape);
    double before = 0, now = 0, next = 0, products = 0, squares = 0;
    for (size_t i = 0; i < nodes; ++i) next += shape[i] * shape[i];
    for (int step = 0; step < 60; ++step) {
        before = now, now = next, next = 0;
        ok(cd_membrane_step(m, dt, 1));
        sheet_read(m, CD_POSITION, x);
        for (size_t i = 0; i < nodes; ++i) next += shape[i] * x[i];
        if (step > 0) products += now * (next + before), squares += 2 * now * now;
    }
    free(shape);
    free(x);
    cd_membrane_destroy(m);
    const struct sheet_mode mode = sheet_mode(s, p, q);
    return acos(products / squares) / (double)(sheet_omega(&mode) * dt);
}

/* lambda 1/2 turns a mode by 2 atan(sqrt(a + b)), with a and b the directions' (omega dt / 2)^2. Factored it is
 * 2 atan(sqrt((a + b) / (1 + a b))): the same along one direction, slower across. */
static void only_what_is_fast_along_both_directions_is_slowed_by_alternating(void** state) {
    (void)state;
    const struct sheet s = {.nodes = {33, 33}, .rule = CD_MASS_HALF_ENDS, .mass = 1, .stiffness = {1, 1}};
    static const double dts[] = {0.05, 0.2, 1};
    for (size_t p = 1; p <= 8; p *= 2)
        for (size_t d = 0; d < COUNT(dts); ++d) {
            const double dt = dts[d];
            const struct sheet_mode mode = sheet_mode(&s, p, p);
            const double a = (double)mode.along[0] * dt * dt / 4, omega = sqrt((double)mode.along[0]);
            const double along = turn(&s, p, 0, CD_SOLVER_ALTERNATING, dt),
                         along_coupled = turn(&s, p, 0, CD_SOLVER_COUPLED, dt);
            const double both = turn(&s, p, p, CD_SOLVER_ALTERNATING, dt),
                         both_coupled = turn(&s, p, p, CD_SOLVER_COUPLED, dt);
            const double expected = 2 * atan(sqrt(2 * a / (1 + a * a))) / (sqrt(2) * omega * dt);
            print_message("mode (%zu, 0) dt %-4g speed %.6f alternating, %.6f coupled; (%zu, %zu) %.6f and %.6f\n", p,
                          dt, along, along_coupled, p, p, both, both_coupled);
            assert_near(along, along_coupled, 1e-9, 0);
            assert_near(along, 2 * atan(sqrt(a)) / (omega * dt), 1e-9, 0);
            assert_near(both_coupled, 2 * atan(sqrt(2 * a)) / (sqrt(2) * omega * dt), 1e-9, 0);
            assert_near(both, expected, 1e-9, 0);
            assert_true(both < both_coupled);
        }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(methods_keep_their_orders_in_time_with_both_solvers),
        cmocka_unit_test(a_sheet_hung_by_two_corners_is_followed_to_second_order),
        cmocka_unit_test(half_edges_are_second_order_in_space_and_equal_masses_first),
        cmocka_unit_test(only_what_is_fast_along_both_directions_is_slowed_by_alternating),
    };
    return cmocka_run_group_tests_name("membrane orders", tests, NULL, NULL);
}
