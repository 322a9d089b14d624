/* What every method keeps: momentum, superposition, components that never mix, and that a shift feels no force. */
#include <math.h>
#include <stdlib.h>

#include "check.h"
#include "grid.h"
#include "reference.h"
#include "sheet.h"
#include "wild.h"

enum { COLUMNS = 13, ROWS = 10, NODES = COLUMNS * ROWS, COMPONENTS = 2, NUMBERS = NODES * COMPONENTS };
static const char* const solver_names[] = {"alternating", "coupled"};

static void fill(double* values, size_t count, uint64_t seed) {
    for (size_t i = 0; i < count; ++i) values[i] = random_number(&seed);
}

/* A step that the method can take, of a 60th of a second if it may. */
static double usable_dt(const cd_membrane* m, const struct time_step* step) {
    double limit;
    ok(cd_membrane_stable_dt(m, &limit));
    if (step->grows) return 0.03 * limit;
    return step->is_explicit ? 0.9 * limit : 1.0 / 60;
}

/* ---- momentum ---------------------------------------------------------------------------------------------------- */

/* Largest change over what there is of it in all nodes, whichever way they move. */
static double momentum_change(enum wild kind, const struct time_step* step, cd_solver solver, double ratio, int damped,
                              cd_precision precision) {
    cd_membrane* m = wild_membrane(kind, COLUMNS, ROWS, COMPONENTS, precision, ratio, 9);
    struct grid* g = grid_of(m);
    double x[NUMBERS], v[NUMBERS], before[COMPONENTS], after[COMPONENTS], change = 0, size = 0;
    sheet_set_time_step(m, step);
    ok(cd_membrane_set_solver(m, solver));
    if (damped) ok(cd_membrane_set_stiffness_damping(m, 1e-3));
    fill(x, NUMBERS, 1);
    fill(v, NUMBERS, 2);
    for (size_t i = 0; i < NUMBERS; ++i) v[i] = g->absent[i / COMPONENTS] ? 0 : v[i] + 0.5;
    sheet_write(m, CD_POSITION, x);
    sheet_write(m, CD_VELOCITY, v);
    const double dt = usable_dt(m, step);
    ok(cd_membrane_get_momentum(m, before, COMPONENTS));
    for (size_t k = 0; k < 5; ++k) {
        sheet_step(m, dt, 20);
        ok(cd_membrane_get_momentum(m, after, COMPONENTS));
        sheet_read(m, CD_VELOCITY, v);
        for (size_t c = 0; c < COMPONENTS; ++c) {
            double all = 0;
            for (size_t i = 0; i < NODES; ++i)
                if (!g->held[i]) all += (double)g->mass[i] * fabs(v[i * COMPONENTS + c]);
            size = fmax(size, all);
            change = fmax(change, fabs(after[c] - before[c]));
        }
    }
    grid_destroy(g);
    cd_membrane_destroy(m);
    return change / size;
}

/* What moves momentum between nodes in a step is about stiffness dt^2 / mass times the momenta there are: its rounding
 * is what is left of the sum. */
static void free_sheets_keep_their_momentum_with(cd_solver solver) {
    static const double ratios[] = {1, 1e4, 1e10};
    int missed = 0;
    for (int kind = 0; kind < WILD_KINDS; ++kind) {
        double worst[2] = {0, 0};
        if (!wild_drifts((enum wild)kind)) continue;
        for (int p = 0; p < 2; ++p)
            for (size_t r = 0; r < COUNT(ratios); ++r)
                for (size_t way = solver == CD_SOLVER_COUPLED ? LAMBDA_1_2 : 0; way < TIME_STEPS; ++way) {
                    const double change = momentum_change((enum wild)kind, &time_steps[way], solver, ratios[r],
                                                          way % 2 == 0, p ? CD_FLOAT64 : CD_FLOAT32);
                    const double allowed = p ? 1e-12 * (1 + ratios[r] / 3600) : 1e-5;
                    if (!(change <= allowed)) {
                        print_message("%s, %s, k/m = %g, float%d: %.2e\n", wild_names[kind], time_steps[way].name,
                                      ratios[r], p ? 64 : 32, change);
                        ++missed;
                    }
                    worst[p] = fmax(worst[p], change);
                }
        print_message("%-11s %-15s momentum changes in 100 steps by %.1e in float32, %.1e in float64\n",
                      solver_names[solver], wild_names[kind], worst[0], worst[1]);
    }
    assert_int_equal(missed, 0);
}

static void free_sheets_keep_their_momentum_with_alternating(void** state) {
    (void)state;
    free_sheets_keep_their_momentum_with(CD_SOLVER_ALTERNATING);
}

static void free_sheets_keep_their_momentum_with_coupled(void** state) {
    (void)state;
    free_sheets_keep_their_momentum_with(CD_SOLVER_COUPLED);
}

/* Springs along u are cut at u = 7 and, of four parts, at u = 3 and all round node (10, 5). */
static void tear(cd_membrane* m, int parts) {
    ok(cd_membrane_enable_field(m, CD_STIFFNESS_U));
    ok(cd_membrane_enable_field(m, CD_STIFFNESS_V));
    for (size_t v = 0; v < ROWS; ++v) {
        sheet_set(m, CD_STIFFNESS_U, 7, v, 0);
        if (parts == 4) sheet_set(m, CD_STIFFNESS_U, 3, v, 0);
    }
    for (size_t k = 0; k < 2 && parts == 4; ++k) {
        sheet_set(m, CD_STIFFNESS_U, 9 + k, 5, 0);
        sheet_set(m, CD_STIFFNESS_V, 10, 4 + k, 0);
    }
}

static size_t part_of(size_t u, size_t v, int parts) {
    return parts == 4 && u == 10 && v == 5 ? 3 : parts == 4 && u < 4 ? 2 : u > 7;
}

static void each_part_of_a_torn_sheet_keeps_its_momentum(void** state) {
    (void)state;
    enum { MANY = 3, PARTS = 4 };
    static const enum wild kinds[] = {WILD_FREE, WILD_RANDOM_SPRINGS, WILD_RANDOM_MASSES};
    static const double ratios[] = {1, 1e4};
    static double x[NODES * MANY], v[2][NODES * MANY];
    for (int solver = 0; solver < 2; ++solver) {
        double worst = 0;
        for (size_t kind = 0; kind < COUNT(kinds); ++kind)
            for (int parts = 2; parts <= PARTS; parts += 2)
                for (size_t r = 0; r < COUNT(ratios); ++r)
                    for (size_t way = LAMBDA_1_2; way < TIME_STEPS; ++way) {
                        cd_membrane* m = wild_membrane(kinds[kind], COLUMNS, ROWS, MANY, CD_FLOAT64, ratios[r], 9);
                        tear(m, parts);
                        struct grid* g = grid_of(m);
                        sheet_set_time_step(m, &time_steps[way]);
                        ok(cd_membrane_set_solver(m, solver));
                        fill(x, COUNT(x), 1);
                        fill(v[0], COUNT(v[0]), 2);
                        sheet_write(m, CD_POSITION, x);
                        sheet_write(m, CD_VELOCITY, v[0]);
                        ok(cd_membrane_step(m, 1.0 / 60, 50));
                        sheet_read(m, CD_VELOCITY, v[1]);
                        long double change[PARTS][MANY] = {{0}}, size[PARTS][MANY] = {{0}};
                        for (size_t i = 0; i < NODES * MANY; ++i) {
                            const size_t node = i / MANY, part = part_of(node % COLUMNS, node / COLUMNS, parts);
                            change[part][i % MANY] += g->mass[node] * ((long double)v[1][i] - v[0][i]);
                            size[part][i % MANY] += g->mass[node] * fabs(v[0][i]);
                        }
                        for (int part = 0; part < parts; ++part)
                            for (size_t c = 0; c < MANY; ++c)
                                worst = fmax(worst, fabs((double)(change[part][c] / size[part][c])));
                        grid_destroy(g);
                        cd_membrane_destroy(m);
                    }
        print_message("%-11s parts' momenta change in 50 steps by %.1e\n", solver_names[solver], worst);
        assert_true(worst <= 1e-9);
    }
}

/* Whatever a step combines its answer of, states that are 2^-20 times as large stay so, to the bit. */
static void a_torn_sheet_and_its_small_image_move_alike(void** state) {
    (void)state;
    const double scale = 1.0 / (1 << 20);
    static double x[2][NODES], v[2][NODES];
    for (int solver = 0; solver < 2; ++solver)
        for (int parts = 2; parts <= 4; parts += 2)
            for (size_t way = LAMBDA_1_2; way < TIME_STEPS; ++way) {
                for (int small = 0; small < 2; ++small) {
                    cd_membrane* m = wild_membrane(WILD_RANDOM_SPRINGS, COLUMNS, ROWS, 1, CD_FLOAT64, 10, 9);
                    tear(m, parts);
                    sheet_set_time_step(m, &time_steps[way]);
                    ok(cd_membrane_set_solver(m, solver));
                    fill(x[small], NODES, 1);
                    fill(v[small], NODES, 2);
                    for (size_t i = 0; i < NODES && small; ++i) x[1][i] *= scale, v[1][i] *= scale;
                    sheet_write(m, CD_POSITION, x[small]);
                    sheet_write(m, CD_VELOCITY, v[small]);
                    ok(cd_membrane_step(m, 1.0 / 60, 20));
                    sheet_read(m, CD_POSITION, x[small]);
                    cd_membrane_destroy(m);
                }
                for (size_t i = 0; i < NODES; ++i) assert_true(x[0][i] * scale == x[1][i]);
            }
}

/* ---- linearity --------------------------------------------------------------------------------------------------- */

/* Strips that nothing joins, as where a stiffness is 0: what is left of an answer once the strips' common motions are
 * taken out of it is mere rounding, and must not count. */
static void strips_fall_freely(void** state) {
    (void)state;
    static const size_t sizes[][2] = {{4, 4}, {16, 4}, {16, 16}, {5, 40}};
    static const double stiffness[][2] = {{1, 0}, {0, 1}, {0, 0}, {1e4, 0}};
    const double gravity = -10, dt = 0.125;
    for (size_t s = 0; s < COUNT(sizes); ++s)
        for (size_t k = 0; k < COUNT(stiffness); ++k)
            for (cd_solver solver = CD_SOLVER_ALTERNATING; solver <= CD_SOLVER_COUPLED; ++solver)
                for (cd_method method = CD_METHOD_IMPLICIT; method <= CD_METHOD_STIFF_SECOND; ++method) {
                    cd_membrane* m;
                    double v;
                    ok(cd_membrane_create(sizes[s][0], sizes[s][1], 1, CD_FLOAT64, NULL, &m));
                    ok(cd_membrane_set_solver(m, CD_SOLVER_ALTERNATING));
                    ok(cd_membrane_set_method(m, method));
                    ok(cd_membrane_set_solver(m, solver));
                    ok(cd_membrane_set_stiffness(m, stiffness[k][0], stiffness[k][1]));
                    ok(cd_membrane_set_gravity(m, &gravity, 1));
                    for (int step = 1; step <= 3; ++step) {
                        ok(cd_membrane_step(m, dt, 1));
                        ok(cd_membrane_read_f64(m, CD_VELOCITY, sizes[s][0] / 2, sizes[s][1] / 2, 1, 1, &v, 1));
                        assert_near(v, step * gravity * dt, 1e-13, 0);
                    }
                    cd_membrane_destroy(m);
                }
}

static void run_rich(enum wild kind, const struct time_step* step, cd_solver solver, const double* x0, const double* v0,
                     const double* f, double* x, double* v) {
    cd_membrane* m = wild_membrane(kind, COLUMNS, ROWS, COMPONENTS, CD_FLOAT64, 300, 9);
    sheet_set_time_step(m, step);
    ok(cd_membrane_set_solver(m, solver));
    ok(cd_membrane_set_tolerance(m, 1e-14, 1000));
    ok(cd_membrane_set_stiffness_damping(m, 1e-4));
    ok(cd_membrane_enable_field(m, CD_FORCE));
    sheet_write(m, CD_POSITION, x0);
    sheet_write(m, CD_VELOCITY, v0);
    sheet_write(m, CD_FORCE, f);
    sheet_step(m, usable_dt(m, step), solver == CD_SOLVER_COUPLED ? 6 : 60);
    sheet_read(m, CD_POSITION, x);
    sheet_read(m, CD_VELOCITY, v);
    cd_membrane_destroy(m);
}

/* All but the alternating steps of sheets that cannot be factored: those weigh their answer, so that it depends on what
 * else moves. */
static void motions_add_up(void** state) {
    (void)state;
    double worst = 0;
    for (int kind = 0; kind < WILD_KINDS; ++kind)
        for (int solver = 0; solver < 2; ++solver)
            for (size_t way = solver == CD_SOLVER_COUPLED ? LAMBDA_1_2 : 0; way < TIME_STEPS; ++way) {
                const int weighs = kind >= WILD_SEPARABLE && solver == CD_SOLVER_ALTERNATING;
                if (weighs && sheet_solves(&time_steps[way])) continue;
                double x0[3][NUMBERS], v0[3][NUMBERS], f[3][NUMBERS], x[3][NUMBERS], v[3][NUMBERS];
                cd_membrane* m = wild_membrane((enum wild)kind, COLUMNS, ROWS, COMPONENTS, CD_FLOAT64, 300, 9);
                struct grid* g = grid_of(m);
                for (size_t k = 0; k < 2; ++k) {
                    fill(x0[k], NUMBERS, 10 + k);
                    fill(v0[k], NUMBERS, 20 + k);
                    fill(f[k], NUMBERS, 30 + k);
                    for (size_t i = 0; i < NUMBERS; ++i) v0[k][i] = g->held[i / COMPONENTS] ? 0 : v0[k][i];
                }
                for (size_t i = 0; i < NUMBERS; ++i) {
                    x0[2][i] = 2 * x0[0][i] - 3 * x0[1][i];
                    v0[2][i] = 2 * v0[0][i] - 3 * v0[1][i];
                    f[2][i] = 2 * f[0][i] - 3 * f[1][i];
                }
                for (size_t k = 0; k < 3; ++k)
                    run_rich((enum wild)kind, &time_steps[way], solver, x0[k], v0[k], f[k], x[k], v[k]);
                double size_x = 0, size_v = 0, off_x = 0, off_v = 0;
                for (size_t i = 0; i < NUMBERS; ++i) {
                    size_x = fmax(size_x, fabs(x[2][i]));
                    size_v = fmax(size_v, fabs(v[2][i]));
                    off_x = fmax(off_x, fabs(x[2][i] - 2 * x[0][i] + 3 * x[1][i]));
                    off_v = fmax(off_v, fabs(v[2][i] - 2 * v[0][i] + 3 * v[1][i]));
                }
                const double off = fmax(off_x / size_x, off_v / size_v);
                if (!(off <= 1e-10))
                    print_message("%s, %s, %s: %.1e\n", wild_names[kind], time_steps[way].name, solver_names[solver],
                                  off);
                worst = fmax(worst, off);
                grid_destroy(g);
                cd_membrane_destroy(m);
            }
    print_message("superposition holds to %.1e\n", worst);
    assert_true(worst <= 1e-10);
}

/* ---- components -------------------------------------------------------------------------------------------------- */

/* Each of three components as it would move alone, bit for bit; coupled solves go on until all are content, so that a
 * component may end closer than it would have alone. */
static void components_move_as_if_alone(void** state) {
    (void)state;
    enum { MANY = 3 };
    static double x0[NODES * MANY], v0[NODES * MANY], x[NODES * MANY], v[NODES * MANY], one_x[NODES], one_v[NODES];
    for (int kind = 0; kind < WILD_KINDS; ++kind)
        for (int p = 0; p < 2; ++p)
            for (int solver = 0; solver < 2; ++solver)
                for (size_t way = 0; way < TIME_STEPS; ++way) {
                    const cd_precision precision = p ? CD_FLOAT64 : CD_FLOAT32;
                    const int iterates = solver == CD_SOLVER_COUPLED && way > LAMBDA_0;
                    double dt = 0, apart = 0, size = 0;
                    for (size_t c = 0; c <= MANY; ++c) { /* 0: all of them */
                        cd_membrane* m = wild_membrane((enum wild)kind, COLUMNS, ROWS, c ? 1 : MANY, precision, 100, 9);
                        sheet_set_time_step(m, &time_steps[way]);
                        ok(cd_membrane_set_solver(m, solver));
                        ok(cd_membrane_set_tolerance(m, 1e-10, 1000));
                        dt = usable_dt(m, &time_steps[way]);
                        if (c == 0) {
                            wild_shake(m, 1, 1, 5);
                            sheet_read(m, CD_POSITION, x0);
                            sheet_read(m, CD_VELOCITY, v0);
                        } else {
                            for (size_t i = 0; i < NODES; ++i)
                                one_x[i] = x0[i * MANY + c - 1], one_v[i] = v0[i * MANY + c - 1];
                            sheet_write(m, CD_POSITION, one_x);
                            sheet_write(m, CD_VELOCITY, one_v);
                        }
                        ok(cd_membrane_step(m, dt, 6));
                        sheet_read(m, CD_POSITION, c ? one_x : x);
                        sheet_read(m, CD_VELOCITY, c ? one_v : v);
                        for (size_t i = 0; i < NODES && c > 0; ++i) {
                            apart = fmax(apart, fabs(one_x[i] - x[i * MANY + c - 1]));
                            apart = fmax(apart, fabs(one_v[i] - v[i * MANY + c - 1]) * dt);
                            size = fmax(size, fmax(fabs(one_x[i]), fabs(one_v[i]) * dt));
                        }
                        cd_membrane_destroy(m);
                    }
                    const double allowed = !iterates ? 0 : p ? 1e-8 : 1e-5;
                    if (!(apart <= allowed * size))
                        print_message("%s, %s, %s, float%d: apart by %.1e of %.1e\n", wild_names[kind],
                                      solver_names[solver], time_steps[way].name, p ? 64 : 32, apart, size);
                    assert_true(apart <= allowed * size);
                }
}

/* ---- what feels no force ----------------------------------------------------------------------------------------- */

/* Positions and velocities are multiples of 1/8 and dt of 1/64, so that nothing is rounded before the first force. A
 * step that weighs its answer against the old velocity finds 1 for the weight, but for rounding. */
static void a_sheet_drawn_to_one_place_feels_no_force(void** state) {
    (void)state;
    const double dt = 1.0 / 64;
    double x0[NUMBERS], v0[NUMBERS], x[NUMBERS], v[NUMBERS], elastic;
    for (size_t i = 0; i < NUMBERS; ++i) {
        x0[i] = 1024 - 100 * (double)(i % COMPONENTS);
        v0[i] = 0.75 + (double)(i % COMPONENTS);
    }
    for (int kind = 0; kind < WILD_KINDS; ++kind)
        for (int p = 0; p < 2; ++p)
            for (int solver = 0; solver < 2; ++solver)
                for (size_t way = 0; way < TIME_STEPS; ++way) {
                    if (!wild_drifts((enum wild)kind)) continue;
                    cd_membrane* m =
                        wild_membrane((enum wild)kind, COLUMNS, ROWS, COMPONENTS, p ? CD_FLOAT64 : CD_FLOAT32, 1e9, 9);
                    struct grid* g = grid_of(m);
                    const int weighs = (solver == CD_SOLVER_COUPLED || kind >= WILD_SEPARABLE) && way > LAMBDA_0;
                    const double allowed = way == STIFF_SECOND || weighs ? (p ? 1e-13 : 1e-4) : 0;
                    sheet_set_time_step(m, &time_steps[way]);
                    ok(cd_membrane_set_solver(m, solver));
                    for (size_t i = 0; i < NUMBERS; ++i) v[i] = g->absent[i / COMPONENTS] ? 0 : v0[i];
                    sheet_write(m, CD_POSITION, x0);
                    sheet_write(m, CD_VELOCITY, v);
                    sheet_step(m, dt, 64);
                    sheet_read(m, CD_POSITION, x);
                    sheet_read(m, CD_VELOCITY, v);
                    for (size_t i = 0; i < NUMBERS; ++i) {
                        if (g->absent[i / COMPONENTS]) continue;
                        const double off_v = fabs(v[i] - v0[i]), off_x = fabs(x[i] - x0[i] - 64 * dt * v0[i]);
                        if (!(off_v <= allowed * 1024 / dt) || !(off_x <= allowed * 1024))
                            print_message("%s, %s, %s, float%d: velocity off by %.1e, position by %.1e\n",
                                          wild_names[kind], solver_names[solver], time_steps[way].name, p ? 64 : 32,
                                          off_v, off_x);
                        assert_true(off_v <= allowed * 1024 / dt);
                        assert_true(off_x <= allowed * 1024);
                    }
                    ok(cd_membrane_get_energy(m, NULL, &elastic, NULL));
                    if (allowed == 0) assert_true(elastic == 0);
                    grid_destroy(g);
                    cd_membrane_destroy(m);
                }
}

/* A plate that nothing stretches is flat in any plane: bends and twists of a u + b v are 0. */
static void a_tilted_plate_feels_no_bend(void** state) {
    (void)state;
    for (int p = 0; p < 2; ++p)
        for (int solver = 0; solver < 2; ++solver)
            for (size_t way = 0; way < TIME_STEPS; ++way) {
                const double dt = 1.0 / 64, allowed = p ? 1e-11 : 1e-5;
                double x0[NODES], v0[NODES], x[NODES], v[NODES];
                cd_membrane* m = NULL;
                ok(cd_membrane_create(COLUMNS - 1, ROWS - 1, 1, p ? CD_FLOAT64 : CD_FLOAT32, NULL, &m));
                ok(cd_membrane_set_solver(m, CD_SOLVER_ALTERNATING));
                ok(cd_membrane_set_stiffness(m, 0, 0));
                ok(cd_membrane_set_bend(m, time_steps[way].grows || time_steps[way].is_explicit ? 1e-3 : 10));
                for (size_t i = 0; i < NODES; ++i) {
                    x0[i] = 0.25 * (double)(i % COLUMNS) - 0.5 * (double)(i / COLUMNS);
                    v0[i] = 0.75 - 0.125 * (double)(i % COLUMNS) + 0.25 * (double)(i / COLUMNS);
                }
                sheet_set_time_step(m, &time_steps[way]);
                ok(cd_membrane_set_solver(m, solver));
                sheet_write(m, CD_POSITION, x0);
                sheet_write(m, CD_VELOCITY, v0);
                sheet_step(m, dt, 64);
                sheet_read(m, CD_POSITION, x);
                sheet_read(m, CD_VELOCITY, v);
                for (size_t i = 0; i < NODES; ++i) {
                    assert_near(v[i], v0[i], allowed, 4);
                    assert_near(x[i], x0[i] + 64 * dt * v0[i], allowed, 4);
                }
                cd_membrane_destroy(m);
            }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(free_sheets_keep_their_momentum_with_alternating),
        cmocka_unit_test(free_sheets_keep_their_momentum_with_coupled),
        cmocka_unit_test(each_part_of_a_torn_sheet_keeps_its_momentum),
        cmocka_unit_test(a_torn_sheet_and_its_small_image_move_alike),
        cmocka_unit_test(strips_fall_freely),
        cmocka_unit_test(motions_add_up),
        cmocka_unit_test(components_move_as_if_alone),
        cmocka_unit_test(a_sheet_drawn_to_one_place_feels_no_force),
        cmocka_unit_test(a_tilted_plate_feels_no_bend),
    };
    return cmocka_run_group_tests_name("membrane invariants", tests, NULL, NULL);
}
