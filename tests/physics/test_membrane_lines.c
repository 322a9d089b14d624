/* Sheets of a single row or column are chains, a sheet of one node is a particle, and a uniform sheet pulled evenly
 * along one direction is many chains side by side. */
#include <math.h>
#include <stdlib.h>

#include "check.h"
#include "reference.h"
#include "sheet.h"

enum { NODES = 21, COMPONENTS = 2, NUMBERS = NODES * COMPONENTS };
static const char* const solver_names[] = {"alternating", "coupled"};

struct line {
    const char* name;
    cd_node first, last;
    cd_mass_rule rule;
    int ring, fields;
    double stiffness, bend, drag, damping;
};
enum { DRIFTING_RING = 7 }; /* of the lines: a ring of springs */
static const struct line lines[] = {
    {"free", CD_NODE_FREE, CD_NODE_FREE, CD_MASS_EQUAL, 0, 0, 40, 0, 0, 0},
    {"half ends", CD_NODE_FREE, CD_NODE_FREE, CD_MASS_HALF_ENDS, 0, 0, 40, 0, 0, 0},
    {"pinned and free", CD_NODE_PINNED, CD_NODE_FREE, CD_MASS_EQUAL, 0, 0, 40, 0, 0.3, 0.01},
    {"pinned, half ends", CD_NODE_PINNED, CD_NODE_PINNED, CD_MASS_HALF_ENDS, 0, 0, 40, 0, 0, 0.01},
    {"matched", CD_NODE_PINNED, CD_NODE_MATCHED, CD_MASS_EQUAL, 0, 0, 40, 0, 0, 0},
    {"matched, half ends", CD_NODE_MATCHED, CD_NODE_MATCHED, CD_MASS_HALF_ENDS, 0, 0, 40, 0, 0, 0},
    {"driven", CD_NODE_DRIVEN, CD_NODE_FREE, CD_MASS_EQUAL, 0, 0, 40, 0, 0.1, 0},
    {"ring", CD_NODE_FREE, CD_NODE_FREE, CD_MASS_EQUAL, 1, 0, 40, 0, 0, 0.02},
    {"rod", CD_NODE_FREE, CD_NODE_FREE, CD_MASS_EQUAL, 0, 0, 5, 0.02, 0, 0},
    {"rod, half ends", CD_NODE_PINNED, CD_NODE_FREE, CD_MASS_HALF_ENDS, 0, 0, 0, 0.02, 0.2, 0.001},
    {"hinged rod", CD_NODE_PINNED, CD_NODE_PINNED, CD_MASS_EQUAL, 0, 0, 5, 0.02, 0, 0.001},
    {"ring rod", CD_NODE_FREE, CD_NODE_FREE, CD_MASS_EQUAL, 1, 0, 5, 0.02, 0.1, 0},
    {"fields", CD_NODE_FREE, CD_NODE_FREE, CD_MASS_EQUAL, 0, 1, 40, 0, 0.1, 0.01},
};

static const double gravity[COMPONENTS] = {0.5, -9.81};

/* Numbers for springs and nodes that differ. */
static void differ(double* springs, double* masses) {
    uint64_t seed = 3;
    for (size_t i = 0; i < NODES; ++i)
        springs[i] = exp(3 * random_number(&seed)), masses[i] = exp(random_number(&seed));
}

static cd_chain* make_chain(const struct line* l, cd_precision precision) {
    cd_chain* c = NULL;
    ok(cd_chain_create(1, NODES - 1, COMPONENTS, precision, NULL, &c));
    ok(cd_chain_set_mass(c, 1.5));
    ok(cd_chain_set_mass_rule(c, l->rule));
    ok(cd_chain_set_stiffness(c, l->stiffness));
    if (l->bend > 0) ok(cd_chain_set_bend(c, l->bend));
    ok(cd_chain_set_drag(c, l->drag));
    ok(cd_chain_set_stiffness_damping(c, l->damping));
    ok(cd_chain_set_gravity(c, gravity, COMPONENTS));
    ok(cd_chain_set_ring(c, l->ring));
    ok(cd_chain_set_end(c, CD_END_FIRST, l->first));
    ok(cd_chain_set_end(c, CD_END_LAST, l->last));
    if (!l->fields) return c;
    double springs[NODES], masses[NODES];
    differ(springs, masses);
    ok(cd_chain_enable_field(c, CD_STIFFNESS));
    ok(cd_chain_enable_field(c, CD_MASS));
    ok(cd_chain_write_f64(c, CD_STIFFNESS, 0, 1, 0, NODES - 1, springs, NODES - 1));
    ok(cd_chain_write_f64(c, CD_MASS, 0, 1, 0, NODES, masses, NODES));
    return c;
}

/* The same in a single row or column. */
static cd_membrane* make_line(const struct line* l, int column, cd_precision precision) {
    cd_membrane* m = NULL;
    ok(cd_membrane_create(column ? 0 : NODES - 1, column ? NODES - 1 : 0, COMPONENTS, precision, NULL, &m));
    ok(cd_membrane_set_solver(m, CD_SOLVER_ALTERNATING));
    ok(cd_membrane_set_mass(m, 1.5));
    ok(cd_membrane_set_mass_rule(m, l->rule));
    ok(cd_membrane_set_stiffness(m, column ? 7 : l->stiffness, column ? l->stiffness : 7));
    ok(cd_membrane_set_bend(m, l->bend));
    ok(cd_membrane_set_drag(m, l->drag));
    ok(cd_membrane_set_stiffness_damping(m, l->damping));
    ok(cd_membrane_set_gravity(m, gravity, COMPONENTS));
    ok(cd_membrane_set_ring(m, !column && l->ring, column && l->ring));
    ok(cd_membrane_set_edge(m, column ? CD_EDGE_V_FIRST : CD_EDGE_U_FIRST, l->first));
    ok(cd_membrane_set_edge(m, column ? CD_EDGE_V_LAST : CD_EDGE_U_LAST, l->last));
    if (!l->fields) return m;
    double springs[NODES], masses[NODES];
    differ(springs, masses);
    ok(cd_membrane_enable_field(m, column ? CD_STIFFNESS_V : CD_STIFFNESS_U));
    ok(cd_membrane_enable_field(m, CD_MASS));
    sheet_write(m, column ? CD_STIFFNESS_V : CD_STIFFNESS_U, springs);
    sheet_write(m, CD_MASS, masses);
    return m;
}

static void random_state(const struct line* l, double* x, double* v) {
    uint64_t seed = 8;
    for (size_t i = 0; i < NUMBERS; ++i) x[i] = random_number(&seed), v[i] = random_number(&seed);
    for (size_t c = 0; c < COMPONENTS; ++c) {
        if (l->first == CD_NODE_PINNED) v[c] = 0;
        if (l->last == CD_NODE_PINNED) v[NUMBERS - 1 - c] = 0;
    }
}

static void a_single_row_or_column_moves_as_the_chain(void** state) {
    (void)state;
    double worst[2] = {0, 0};
    for (size_t k = 0; k < COUNT(lines); ++k)
        for (int column = 0; column < 2; ++column)
            for (int solver = 0; solver < 2; ++solver)
                for (size_t way = 0; way < TIME_STEPS; ++way)
                    for (int p = 0; p < 2; ++p) {
                        double x[NUMBERS], v[NUMBERS], cx[NUMBERS], cv[NUMBERS], dt = 0.02, off = 0;
                        const double allowed = p ? 1e-11 : 1e-5;
                        cd_chain* c = make_chain(&lines[k], p ? CD_FLOAT64 : CD_FLOAT32);
                        cd_membrane* m = make_line(&lines[k], column, p ? CD_FLOAT64 : CD_FLOAT32);
                        set_time_step(c, &time_steps[way]);
                        sheet_set_time_step(m, &time_steps[way]);
                        ok(cd_membrane_set_solver(m, solver));
                        ok(cd_membrane_set_tolerance(m, 1e-13, 1000));
                        if (time_steps[way].is_explicit || time_steps[way].grows) {
                            ok(cd_chain_stable_dt(c, &dt));
                            dt *= 0.1;
                        }
                        random_state(&lines[k], x, v);
                        ok(cd_chain_write_f64(c, CD_POSITION, 0, 1, 0, NODES, x, NUMBERS));
                        ok(cd_chain_write_f64(c, CD_VELOCITY, 0, 1, 0, NODES, v, NUMBERS));
                        sheet_write(m, CD_POSITION, x);
                        sheet_write(m, CD_VELOCITY, v);
                        ok(cd_chain_step(c, dt, 50));
                        for (int call = 0; call < 5; ++call) sheet_step(m, dt, 10);
                        ok(cd_chain_read_f64(c, CD_POSITION, 0, 1, 0, NODES, cx, NUMBERS));
                        ok(cd_chain_read_f64(c, CD_VELOCITY, 0, 1, 0, NODES, cv, NUMBERS));
                        sheet_read(m, CD_POSITION, x);
                        sheet_read(m, CD_VELOCITY, v);
                        double size_x = 1, size_v = 1, off_x = 0, off_v = 0;
                        for (size_t i = 0; i < NUMBERS; ++i) {
                            size_x = fmax(size_x, fabs(cx[i])), off_x = fmax(off_x, fabs(x[i] - cx[i]));
                            size_v = fmax(size_v, fabs(cv[i])), off_v = fmax(off_v, fabs(v[i] - cv[i]));
                        }
                        off = fmax(off_x / size_x, off_v / size_v);
                        if (!(off <= allowed))
                            print_message("%s, %s, %s, %s, float%d: off by %.1e\n", lines[k].name,
                                          column ? "column" : "row", solver_names[solver], time_steps[way].name,
                                          p ? 64 : 32, off);
                        worst[p] = fmax(worst[p], off);
                        double ours[3], chains[3];
                        ok(cd_membrane_get_energy(m, &ours[0], &ours[1], &ours[2]));
                        ok(cd_chain_get_energy(c, &chains[0], &chains[1], &chains[2]));
                        const double size = chains[0] + chains[1] + fabs(chains[2]);
                        for (int e = 0; e < 3 && off <= allowed; ++e)
                            assert_near(ours[e], chains[e], 100 * allowed, size);
                        cd_chain_destroy(c);
                        cd_membrane_destroy(m);
                    }
    print_message("single rows and columns are chains to %.1e in float32, %.1e in float64\n", worst[0], worst[1]);
    assert_true(worst[0] <= 1e-5);
    assert_true(worst[1] <= 1e-11);
}

/* Where a ring that drifts has nearly come to rest, its velocity, a drift, and the change of a step are nearly one motion.
 * The step keeps its digits even so. */
static void a_drifting_ring_comes_to_rest_as_the_chain(void** state) {
    (void)state;
    const double turn = 2 * acos(-1) / NODES;
    double worst = 0;
    for (int column = 0; column < 2; ++column)
        for (int solver = 0; solver < 2; ++solver)
            for (double wave = 1e-1; wave > 1e-9; wave *= 0.3)
                for (double ripple = 1e-1; ripple > 1e-9; ripple *= 0.3) {
                    double x[NUMBERS], v[NUMBERS], w[NUMBERS];
                    cd_chain* c = make_chain(&lines[DRIFTING_RING], CD_FLOAT64);
                    cd_membrane* m = make_line(&lines[DRIFTING_RING], column, CD_FLOAT64);
                    for (size_t i = 0; i < NUMBERS; ++i) {
                        const double at = turn * (double)(i / COMPONENTS) + (double)(i % COMPONENTS);
                        const double shape = wave * (sin(at) + ripple * sin(2 * at));
                        x[i] = 0.3 - shape, v[i] = 0.2 + shape;
                    }
                    ok(cd_chain_set_lambda(c, 0.75));
                    ok(cd_membrane_set_lambda(m, 0.75));
                    ok(cd_membrane_set_solver(m, solver));
                    ok(cd_membrane_set_tolerance(m, 1e-13, 1000));
                    ok(cd_chain_write_f64(c, CD_POSITION, 0, 1, 0, NODES, x, NUMBERS));
                    ok(cd_chain_write_f64(c, CD_VELOCITY, 0, 1, 0, NODES, v, NUMBERS));
                    sheet_write(m, CD_POSITION, x);
                    sheet_write(m, CD_VELOCITY, v);
                    ok(cd_chain_step(c, 0.02, 3));
                    sheet_step(m, 0.02, 3);
                    ok(cd_chain_read_f64(c, CD_VELOCITY, 0, 1, 0, NODES, v, NUMBERS));
                    sheet_read(m, CD_VELOCITY, w);
                    for (size_t i = 0; i < NUMBERS; ++i) worst = fmax(worst, fabs(w[i] - v[i]));
                    cd_chain_destroy(c);
                    cd_membrane_destroy(m);
                }
    print_message("rings that drift and have nearly come to rest are chains to %.1e\n", worst);
    assert_true(worst <= 2e-10);
}

/* The limits of explicit steps agree, too. */
static void a_single_row_or_column_has_the_chains_stable_dt(void** state) {
    (void)state;
    for (size_t k = 0; k < COUNT(lines); ++k)
        for (int column = 0; column < 2; ++column) {
            cd_chain* c = make_chain(&lines[k], CD_FLOAT64);
            cd_membrane* m = make_line(&lines[k], column, CD_FLOAT64);
            double chains, ours;
            ok(cd_chain_stable_dt(c, &chains));
            ok(cd_membrane_stable_dt(m, &ours));
            if (!(ours <= chains * (1 + 1e-9)) || !(ours >= 0.9 * chains))
                print_message("%s, %s: stable_dt %.9g, the chain's is %.9g\n", lines[k].name, column ? "column" : "row",
                              ours, chains);
            assert_true(ours <= chains * 1.02); /* both are bounds */
            assert_true(ours >= 0.5 * chains);
            cd_chain_destroy(c);
            cd_membrane_destroy(m);
        }
}

/* A sheet whose rows all start alike stays so, each row a chain with its share of the totals; likewise its columns. */
static void rows_that_start_alike_move_as_chains_side_by_side(void** state) {
    (void)state;
    enum { ACROSS = 6 };
    for (int rule = 0; rule < 2; ++rule)
        for (int transposed = 0; transposed < 2; ++transposed)
            for (int solver = 0; solver < 2; ++solver)
                for (size_t way = LAMBDA_1_2; way < TIME_STEPS; ++way) {
                    cd_chain* c = NULL;
                    cd_membrane* m = NULL;
                    double x[NODES], all[NODES * ACROSS];
                    uint64_t seed = 5;
                    const size_t nu = transposed ? ACROSS - 1 : NODES - 1, nv = transposed ? NODES - 1 : ACROSS - 1;
                    ok(cd_chain_create(1, NODES - 1, 1, CD_FLOAT64, NULL, &c));
                    ok(cd_membrane_create(nu, nv, 1, CD_FLOAT64, NULL, &m));
                    ok(cd_membrane_set_solver(m, CD_SOLVER_ALTERNATING));
                    ok(cd_chain_set_mass_rule(c, rule));
                    ok(cd_membrane_set_mass_rule(m, rule));
                    ok(cd_chain_set_mass(c, 2));
                    ok(cd_membrane_set_mass(m, 2));
                    ok(cd_chain_set_stiffness(c, 30));
                    ok(cd_membrane_set_stiffness(m, transposed ? 4 : 30, transposed ? 30 : 4));
                    set_time_step(c, &time_steps[way]);
                    sheet_set_time_step(m, &time_steps[way]);
                    ok(cd_membrane_set_solver(m, solver));
                    ok(cd_membrane_set_tolerance(m, 1e-13, 1000));
                    for (size_t i = 0; i < NODES; ++i) x[i] = random_number(&seed);
                    for (size_t i = 0; i < NODES * ACROSS; ++i) all[i] = x[transposed ? i / ACROSS : i % NODES];
                    ok(cd_chain_write_f64(c, CD_POSITION, 0, 1, 0, NODES, x, NODES));
                    sheet_write(m, CD_POSITION, all);
                    ok(cd_chain_step(c, 0.03, 50));
                    sheet_step(m, 0.03, 50);
                    ok(cd_chain_read_f64(c, CD_POSITION, 0, 1, 0, NODES, x, NODES));
                    sheet_read(m, CD_POSITION, all);
                    for (size_t i = 0; i < NODES * ACROSS; ++i)
                        assert_near(all[i], x[transposed ? i / ACROSS : i % NODES], 1e-10, 1);
                    cd_chain_destroy(c);
                    cd_membrane_destroy(m);
                }
}

/* m x'' = m g - drag m x': each way to step, once more by hand. */
static void a_sheet_of_one_node_is_a_free_particle(void** state) {
    (void)state;
    const double g[3] = {0, -9.81, 1}, dt = 1.0 / 64, n = 256;
    for (int solver = 0; solver < 2; ++solver)
        for (int p = 0; p < 2; ++p)
            for (size_t way = 0; way < TIME_STEPS; ++way) {
                const struct time_step* step = &time_steps[way];
                double lambda = step->lambda, x[3] = {1, 2, 3}, v[3] = {0.5, -0.25, 2};
                const double x0[3] = {1, 2, 3}, v0[3] = {0.5, -0.25, 2};
                if (step->method == CD_METHOD_SYMPLECTIC_EULER) lambda = 1;
                if (step->method == CD_METHOD_STIFF_SECOND) lambda = 0.5;
                cd_membrane* m = NULL;
                ok(cd_membrane_create(0, 0, 3, p ? CD_FLOAT64 : CD_FLOAT32, NULL, &m));
                ok(cd_membrane_set_solver(m, CD_SOLVER_ALTERNATING));
                ok(cd_membrane_set_bend(m, 3));
                ok(cd_membrane_set_stiffness(m, 1e6, 1e6));
                ok(cd_membrane_set_stiffness_damping(m, 1));
                ok(cd_membrane_set_gravity(m, g, 3));
                ok(cd_membrane_set_solver(m, solver));
                sheet_set_time_step(m, step);
                sheet_write(m, CD_POSITION, x);
                sheet_write(m, CD_VELOCITY, v);
                sheet_step(m, dt, (size_t)n);
                sheet_read(m, CD_POSITION, x);
                sheet_read(m, CD_VELOCITY, v);
                for (int c = 0; c < 3; ++c) {
                    const double fall = g[c] * dt * dt * (n * n / 2 + (lambda - 0.5) * n);
                    assert_near(v[c], v0[c] + g[c] * n * dt, p ? 1e-12 : 1e-5, 1);
                    assert_near(x[c], x0[c] + v0[c] * n * dt + fall, p ? 1e-12 : 1e-4, 1);
                }
                cd_membrane_destroy(m);
            }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_single_row_or_column_moves_as_the_chain),
        cmocka_unit_test(a_drifting_ring_comes_to_rest_as_the_chain),
        cmocka_unit_test(a_single_row_or_column_has_the_chains_stable_dt),
        cmocka_unit_test(rows_that_start_alike_move_as_chains_side_by_side),
        cmocka_unit_test(a_sheet_of_one_node_is_a_free_particle),
    };
    return cmocka_run_group_tests_name("membrane lines", tests, NULL, NULL);
}
