/* Waves on sheets: the drum of the continuum, damping, edges that echo and edges that do not, driven edges, waves that
 * run round a torus. */
#include <math.h>
#include <stdlib.h>

#include "check.h"
#include "grid.h"
#include "reference.h"
#include "sheet.h"

static const char* const solver_names[] = {"alternating", "coupled"};

/* The part of the present positions along a shape, of 1 where they are the shape. */
static double part_along(const cd_membrane* m, const double* shape) {
    const size_t nodes = sheet_nodes(m);
    double* x = calloc(nodes, sizeof *x);
    double product = 0, square = 0;
    assert_non_null(x);
    sheet_read(m, CD_POSITION, x);
    for (size_t i = 0; i < nodes; ++i) product += x[i] * shape[i], square += shape[i] * shape[i];
    free(x);
    return product / square;
}

static double* shape_of(const struct sheet* s, size_t p, size_t q) {
    const size_t nodes = s->nodes[0] * s->nodes[1];
    double* shape = calloc(nodes, sizeof *shape);
    assert_non_null(shape);
    for (size_t i = 0; i < nodes; ++i) shape[i] = (double)sheet_shape(s, p, q, i % s->nodes[0], i / s->nodes[0]);
    return shape;
}

/* ---- a drum ------------------------------------------------------------------------------------------------------ */

/* omega = pi sqrt(p^2 c_u^2 + q^2 c_v^2), c^2 = stiffness / mass: after a whole number of periods, and a quarter more,
 * where every error of omega shows to first order. */
static void a_fine_drum_sounds_the_modes_of_the_continuum(void** state) {
    (void)state;
    static const size_t modes[][2] = {{1, 1}, {2, 1}, {1, 2}, {3, 2}};
    const struct sheet s = {.ends = {SHEET_FIXED, SHEET_FIXED},
                            .nodes = {97, 65},
                            .rule = CD_MASS_HALF_ENDS,
                            .mass = 1,
                            .stiffness = {1, 1.7}};
    for (int solver = 0; solver < 2; ++solver)
        for (size_t k = 0; k < COUNT(modes); ++k) {
            const size_t p = modes[k][0], q = modes[k][1], steps = 400;
            const double omega = (double)PI * sqrt((double)(p * p) * s.stiffness[0] + (double)(q * q) * s.stiffness[1]);
            const double time = 2.25 * 2 * (double)PI / omega;
            double* shape = shape_of(&s, p, q);
            cd_membrane* m = sheet_membrane(&s, 1, CD_FLOAT64);
            ok(cd_membrane_set_solver(m, solver));
            sheet_write(m, CD_POSITION, shape);
            ok(cd_membrane_step(m, time / (double)steps, steps));
            const double late = part_along(m, shape) / (omega * time); /* cos(omega time) = 0 */
            print_message("drum mode (%zu, %zu), %-11s frequency off by %+.1e\n", p, q, solver_names[solver], -late);
            assert_true(fabs(late) < 1e-3);
            free(shape);
            cd_membrane_destroy(m);
        }
}

/* A mode loses amplitude at the rate (drag + stiffness_damping omega^2) / 2: five periods later. */
static void modes_lose_amplitude_at_their_rates(void** state) {
    (void)state;
    static const struct { double drag, damping; } cases[] = {{0.3, 0}, {0, 0.004}, {0.2, 0.002}};
    static const size_t modes[][2] = {{1, 0}, {1, 1}, {3, 2}};
    for (size_t c = 0; c < COUNT(cases); ++c)
        for (int solver = 0; solver < 2; ++solver)
            for (size_t k = 0; k < COUNT(modes); ++k) {
                const struct sheet s = {.nodes = {17, 17},
                                        .rule = CD_MASS_HALF_ENDS,
                                        .mass = 1,
                                        .stiffness = {1, 1},
                                        .drag = cases[c].drag,
                                        .damping = cases[c].damping};
                const size_t p = modes[k][0], q = modes[k][1];
                const struct sheet_mode mode = sheet_mode(&s, p, q);
                const double w2 = (double)(sheet_omega(&mode) * sheet_omega(&mode));
                const double rate = (cases[c].drag + cases[c].damping * w2) / 2, omega = sqrt(w2 - rate * rate);
                const double time = 5 * 2 * (double)PI / omega;
                double* shape = shape_of(&s, p, q);
                cd_membrane* m = sheet_membrane(&s, 1, CD_FLOAT64);
                ok(cd_membrane_set_solver(m, solver));
                sheet_write(m, CD_POSITION, shape);
                ok(cd_membrane_step(m, time / 4000, 4000));
                const double measured = -log(part_along(m, shape)) / time;
                assert_near(measured, rate, 1e-3, 0);
                free(shape);
                cd_membrane_destroy(m);
            }
}

/* ---- edges ------------------------------------------------------------------------------------------------------- */

static double pulse(double s) { return exp(-s * s / (2 * 0.05 * 0.05)); }
static double pulse_slope(double s) { return -s / (0.05 * 0.05) * pulse(s); }

/* A wave straight at an edge, of a sheet on which waves run across in 1 s: the largest displacement, with its sign, 1 s
 * after it left the middle. */
static double echo(cd_edge edge, cd_node kind, size_t springs, cd_mass_rule rule, cd_solver solver) {
    const int along_v = edge >= CD_EDGE_V_FIRST, last = edge == CD_EDGE_U_LAST || edge == CD_EDGE_V_LAST;
    const size_t across = 4, nu = along_v ? across : springs, nv = along_v ? springs : across;
    cd_membrane* m = NULL;
    ok(cd_membrane_create(nu, nv, 1, CD_FLOAT64, NULL, &m));
    ok(cd_membrane_set_solver(m, CD_SOLVER_ALTERNATING));
    ok(cd_membrane_set_mass_rule(m, rule));
    ok(cd_membrane_set_edge(m, edge, kind));
    ok(cd_membrane_set_solver(m, solver));
    const size_t nodes = (nu + 1) * (nv + 1);
    double* x = calloc(nodes, sizeof *x);
    double* v = calloc(nodes, sizeof *v);
    assert_true(x && v);
    for (size_t i = 0; i < nodes; ++i) {
        const size_t at = along_v ? i / (nu + 1) : i % (nu + 1);
        const double s = (double)at / (double)springs - 0.5;
        const int held = kind == CD_NODE_PINNED && at == (last ? springs : 0);
        x[i] = held ? 0 : pulse(s), v[i] = held ? 0 : (last ? -1 : 1) * pulse_slope(s);
    }
    sheet_write(m, CD_POSITION, x);
    sheet_write(m, CD_VELOCITY, v);
    ok(cd_membrane_step(m, 0.25 / (double)springs, 4 * springs));
    sheet_read(m, CD_POSITION, x);
    double largest = 0;
    for (size_t i = 0; i < nodes; ++i)
        if (fabs(x[i]) > fabs(largest)) largest = x[i];
    free(x);
    free(v);
    cd_membrane_destroy(m);
    return largest;
}

static void a_plane_wave_leaves_through_a_matched_edge_and_returns_from_others(void** state) {
    (void)state;
    for (int rule = CD_MASS_EQUAL; rule <= CD_MASS_HALF_ENDS; ++rule)
        for (int solver = 0; solver < 2; ++solver)
            for (cd_edge edge = CD_EDGE_U_FIRST; edge <= CD_EDGE_V_LAST; ++edge) {
                double coarser = 0;
                if (solver == CD_SOLVER_COUPLED && (edge == CD_EDGE_U_LAST || edge == CD_EDGE_V_FIRST)) continue;
                for (size_t springs = 100; springs <= 200; springs *= 2) {
                    const double matched = echo(edge, CD_NODE_MATCHED, springs, rule, solver);
                    const double free_edge = echo(edge, CD_NODE_FREE, springs, rule, solver);
                    const double pinned = echo(edge, CD_NODE_PINNED, springs, rule, solver);
                    if (edge == CD_EDGE_U_FIRST)
                        print_message("%s, %-11s %zu springs: echo of a matched edge %+.4f, free %+.4f, pinned %+.4f\n",
                                      rule ? "half edges" : "equal masses", solver_names[solver], springs, matched,
                                      free_edge, pinned);
                    assert_true(free_edge > 0.9);
                    assert_true(pinned < -0.9);
                    assert_true(fabs(matched) < (rule ? 0.03 : 0.15));
                    if (coarser > 0) assert_true(fabs(matched) < (rule ? 0.35 : 0.6) * coarser);
                    coarser = fabs(matched);
                }
            }
}

/* A drop in the middle of a sheet matched all round: what meets the edges at an angle t is sent back by (1 - cos t) /
 * (1 + cos t), a few percent of the energy at first, next to nothing after some crossings. */
static void four_matched_edges_let_a_drop_leave(void** state) {
    (void)state;
    enum { N = 81 };
    for (int solver = 0; solver < 2; ++solver) {
        cd_membrane* m = NULL;
        static double x[N * N];
        ok(cd_membrane_create(N - 1, N - 1, 1, CD_FLOAT64, NULL, &m));
        ok(cd_membrane_set_solver(m, CD_SOLVER_ALTERNATING));
        ok(cd_membrane_set_mass_rule(m, CD_MASS_HALF_ENDS));
        ok(cd_membrane_set_solver(m, solver));
        for (cd_edge e = CD_EDGE_U_FIRST; e <= CD_EDGE_V_LAST; ++e) ok(cd_membrane_set_edge(m, e, CD_NODE_MATCHED));
        for (size_t i = 0; i < N * N; ++i) {
            const double u = (double)(i % N) / (N - 1) - 0.5, v = (double)(i / N) / (N - 1) - 0.5;
            x[i] = pulse(sqrt(u * u + v * v));
        }
        sheet_write(m, CD_POSITION, x);
        const double start = sheet_swing_energy(m);
        ok(cd_membrane_step(m, 0.005, 240)); /* the corners are 0.71 away */
        const double early = sheet_swing_energy(m) / start;
        ok(cd_membrane_step(m, 0.005, 600));
        const double late = sheet_swing_energy(m) / start;
        print_message("%s: energy left after 1.2 s %.1e, after 4.2 s %.1e\n", solver_names[solver], early, late);
        assert_true(early < 0.05);
        assert_true(late < 1e-4);
        cd_membrane_destroy(m);
    }
}

/* ---- driven edges ------------------------------------------------------------------------------------------------ */

enum { COLUMNS = 14, ROWS = 9, NODES = COLUMNS * ROWS };
struct motion {
    double x[NODES], v[NODES];
};

static struct motion held(cd_edge edge, double speed, cd_solver solver, const struct time_step* step,
                          double* out_time) {
    struct motion motion;
    cd_membrane* m = NULL;
    double dt = 1.0 / 60;
    ok(cd_membrane_create(COLUMNS - 1, ROWS - 1, 1, CD_FLOAT64, NULL, &m));
    ok(cd_membrane_set_solver(m, CD_SOLVER_ALTERNATING));
    ok(cd_membrane_set_solver(m, solver));
    ok(cd_membrane_set_tolerance(m, 1e-13, 200));
    ok(cd_membrane_set_stiffness(m, 30, 20));
    ok(cd_membrane_set_stiffness_damping(m, 1e-4));
    ok(cd_membrane_set_edge(m, edge, speed != 0 ? CD_NODE_DRIVEN : CD_NODE_PINNED));
    sheet_set_time_step(m, step);
    if (step->is_explicit || step->grows) {
        ok(cd_membrane_stable_dt(m, &dt));
        dt *= step->grows ? 0.05 : 0.9;
    }
    uint64_t seed = 4;
    for (size_t i = 0; i < NODES; ++i) {
        const size_t u = i % COLUMNS, v = i / COLUMNS;
        const int on[4] = {u == 0, u == COLUMNS - 1, v == 0, v == ROWS - 1};
        motion.x[i] = random_number(&seed);
        motion.v[i] = (on[edge] ? 0 : random_number(&seed)) + speed;
    }
    sheet_write(m, CD_POSITION, motion.x);
    sheet_write(m, CD_VELOCITY, motion.v);
    sheet_step(m, dt, 100);
    sheet_read(m, CD_POSITION, motion.x);
    sheet_read(m, CD_VELOCITY, motion.v);
    ok(cd_membrane_get_time(m, out_time));
    cd_membrane_destroy(m);
    return motion;
}

/* Driving an edge at a constant velocity is pinning it, seen from something that moves the other way. */
static void a_driven_edge_is_a_pinned_one_seen_in_motion(void** state) {
    (void)state;
    const double speed = 0.75;
    double worst = 0;
    for (cd_edge edge = CD_EDGE_U_FIRST; edge <= CD_EDGE_V_LAST; ++edge)
        for (int solver = 0; solver < 2; ++solver)
            for (size_t way = 0; way < TIME_STEPS; ++way) {
                double time, size = 1;
                const struct motion pinned = held(edge, 0, solver, &time_steps[way], &time);
                const struct motion driven = held(edge, speed, solver, &time_steps[way], &time);
                for (size_t i = 0; i < NODES; ++i) size = fmax(size, fmax(fabs(driven.x[i]), fabs(driven.v[i])));
                for (size_t i = 0; i < NODES; ++i) {
                    worst = fmax(worst, fabs(driven.x[i] - pinned.x[i] - speed * time) / size);
                    worst = fmax(worst, fabs(driven.v[i] - pinned.v[i] - speed) / size);
                }
                const size_t corner = edge == CD_EDGE_U_FIRST || edge == CD_EDGE_V_FIRST ? 0 : NODES - 1;
                assert_true(driven.v[corner] == speed);
                assert_true(pinned.v[corner] == 0);
            }
    print_message("driven and pinned edges differ by %.1e\n", worst);
    assert_true(worst <= 1e-10);
}

/* What moves a driven edge is outside: neither its momentum nor its kinetic energy is the sheet's. */
static void a_driven_edge_counts_in_no_momentum_and_kinetic_energy(void** state) {
    (void)state;
    cd_membrane* m = NULL;
    double v[NODES], momentum, kinetic, sum = 0, energy = 0;
    uint64_t seed = 6;
    ok(cd_membrane_create(COLUMNS - 1, ROWS - 1, 1, CD_FLOAT64, NULL, &m));
    ok(cd_membrane_set_solver(m, CD_SOLVER_ALTERNATING));
    ok(cd_membrane_set_mass(m, NODES));
    ok(cd_membrane_set_edge(m, CD_EDGE_V_LAST, CD_NODE_DRIVEN));
    for (size_t i = 0; i < NODES; ++i) {
        v[i] = random_number(&seed);
        if (i < NODES - COLUMNS) sum += v[i], energy += v[i] * v[i] / 2;
    }
    sheet_write(m, CD_VELOCITY, v);
    ok(cd_membrane_get_momentum(m, &momentum, 1));
    ok(cd_membrane_get_energy(m, &kinetic, NULL, NULL));
    assert_near(momentum, sum, 1e-13, 1);
    assert_near(kinetic, energy, 1e-13, 1);
    cd_membrane_destroy(m);
}

/* An edge that moves as sin(w t), the one across fixed: sin(w (1 - s)) / sin(w) sin(w t), of second order. */
static void a_driven_edge_makes_a_standing_wave(void** state) {
    (void)state;
    const double w = 2;
    for (int solver = 0; solver < 2; ++solver) {
        double before = 0, order = 0, error = 0;
        for (size_t springs = 20; springs <= 80; springs *= 2) {
            enum { ACROSS = 5 };
            cd_membrane* m = NULL;
            const double dt = 1 / (double)springs;
            const size_t steps = 3 * springs, nodes = (springs + 1) * ACROSS;
            double* x = calloc(nodes, sizeof *x);
            double speed[ACROSS];
            assert_non_null(x);
            ok(cd_membrane_create(springs, ACROSS - 1, 1, CD_FLOAT64, NULL, &m));
            ok(cd_membrane_set_solver(m, CD_SOLVER_ALTERNATING));
            ok(cd_membrane_set_mass_rule(m, CD_MASS_HALF_ENDS));
            ok(cd_membrane_set_edge(m, CD_EDGE_U_FIRST, CD_NODE_DRIVEN));
            ok(cd_membrane_set_edge(m, CD_EDGE_U_LAST, CD_NODE_PINNED));
            ok(cd_membrane_set_solver(m, solver));
            ok(cd_membrane_set_tolerance(m, 1e-9, 200));
            for (size_t i = 0; i < nodes; ++i) {
                const size_t u = i % (springs + 1);
                x[i] = u == springs ? 0 : w * sin(w * (1 - (double)u / (double)springs)) / sin(w);
            }
            sheet_write(m, CD_VELOCITY, x);
            for (size_t k = 0; k < steps; ++k) {
                const double t = (double)k * dt;
                for (size_t v = 0; v < ACROSS; ++v) speed[v] = (sin(w * (t + dt)) - sin(w * t)) / dt;
                ok(cd_membrane_write_f64(m, CD_VELOCITY, 0, 0, 1, ACROSS, speed, ACROSS));
                sheet_step(m, dt, 1);
            }
            sheet_read(m, CD_POSITION, x);
            assert_near(x[0], sin(w * (double)steps * dt), 1e-12, 1);
            error = 0;
            for (size_t i = 0; i < nodes; ++i) {
                const double s = (double)(i % (springs + 1)) / (double)springs;
                error = fmax(error, fabs(x[i] - sin(w * (1 - s)) / sin(w) * sin(w * (double)steps * dt)));
            }
            order = log2(before / error);
            before = error;
            free(x);
            cd_membrane_destroy(m);
        }
        print_message("%s: standing wave to %.1e with 80 springs, order %.2f\n", solver_names[solver], error, order);
        assert_true(error < 1e-2);
        assert_true(order > 1.8);
    }
}

/* ---- round a torus ----------------------------------------------------------------------------------------------- */

/* cos(2 pi (p u / N_u + q v / N_v) - turn) keeps its shape; each step turns it by 2 atan(h omega / sqrt(1 + a b)), with
 * a b only where the directions are factored. */
static void a_travelling_wave_keeps_its_shape_round_a_torus(void** state) {
    (void)state;
    enum { NU = 24, NV = 15 };
    static const size_t waves[][2] = {{1, 0}, {0, 2}, {2, 1}, {5, 4}};
    static const double dts[] = {0.02, 0.5};
    const struct sheet s = {.ends = {SHEET_RING, SHEET_RING}, .nodes = {NU, NV}, .mass = 2, .stiffness = {3, 1}};
    for (int solver = 0; solver < 2; ++solver)
        for (size_t k = 0; k < COUNT(waves); ++k)
            for (size_t d = 0; d < COUNT(dts); ++d) {
                const double dt = dts[d], steps = 200;
                const struct sheet_mode mode = sheet_mode(&s, waves[k][0], waves[k][1]);
                const double a = (double)mode.along[0] * dt * dt / 4, b = (double)mode.along[1] * dt * dt / 4;
                const double heavy = solver == CD_SOLVER_ALTERNATING ? 1 + a * b : 1;
                const double omega = (double)sheet_omega(&mode) / sqrt(heavy), turn = 2 * atan(omega * dt / 2) * steps;
                double x[NU * NV], v[NU * NV];
                for (size_t i = 0; i < NU * NV; ++i) {
                    const double phase =
                        2 * (double)PI *
                        ((double)(waves[k][0] * (i % NU)) / NU + (double)(waves[k][1] * (i / NU)) / NV);
                    x[i] = cos(phase), v[i] = omega * sin(phase);
                }
                cd_membrane* m = sheet_membrane(&s, 1, CD_FLOAT64);
                ok(cd_membrane_set_solver(m, solver));
                ok(cd_membrane_set_tolerance(m, 1e-13, 200));
                sheet_write(m, CD_POSITION, x);
                sheet_write(m, CD_VELOCITY, v);
                sheet_step(m, dt, (size_t)steps / 2);
                sheet_step(m, dt, (size_t)steps / 2);
                for (size_t i = 0; i < NU * NV; ++i) {
                    const double phase =
                        2 * (double)PI *
                        ((double)(waves[k][0] * (i % NU)) / NU + (double)(waves[k][1] * (i / NU)) / NV);
                    assert_near(sheet_get(m, CD_POSITION, i % NU, i / NU), cos(phase - turn), 1e-9, 1);
                }
                cd_membrane_destroy(m);
            }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_fine_drum_sounds_the_modes_of_the_continuum),
        cmocka_unit_test(modes_lose_amplitude_at_their_rates),
        cmocka_unit_test(a_plane_wave_leaves_through_a_matched_edge_and_returns_from_others),
        cmocka_unit_test(four_matched_edges_let_a_drop_leave),
        cmocka_unit_test(a_driven_edge_is_a_pinned_one_seen_in_motion),
        cmocka_unit_test(a_driven_edge_counts_in_no_momentum_and_kinetic_energy),
        cmocka_unit_test(a_driven_edge_makes_a_standing_wave),
        cmocka_unit_test(a_travelling_wave_keeps_its_shape_round_a_torus),
    };
    return cmocka_run_group_tests_name("membrane waves", tests, NULL, NULL);
}
