/* Explicit steps of sheets: bounded below stable_dt, diverging above it where it is exact. */
#include <math.h>

#include "check.h"
#include "reference.h"
#include "sheet.h"
#include "wild.h"

enum { COLUMNS = 24, ROWS = 20, STEPS = 2000, WINDOW = 50 };

static double stable_dt(const cd_membrane* m) {
    double dt = 0;
    ok(cd_membrane_stable_dt(m, &dt));
    assert_true(dt > 0 && isfinite(dt));
    return dt;
}

/* Highest energy over the next WINDOW steps. */
static double highest_energy(cd_membrane* m, double dt) {
    double highest = 0;
    for (int k = 0; k < WINDOW; ++k) {
        ok(cd_membrane_step(m, dt, 1));
        highest = fmax(highest, sheet_swing_energy(m));
    }
    return highest;
}

enum extra { NOTHING, DRAG, STIFFNESS_DAMPING, TIE, DAMPED_TIE, MATCHED, EXTRAS };
static const char* const extra_names[EXTRAS] = {
    "", ", drag", ", stiffness damping", ", tied", ", tied and damped", ", matched"};

/* Returns 0 for a sheet that cannot have it. */
static int add(cd_membrane* m, enum extra extra, enum wild kind) {
    if (extra == DRAG) ok(cd_membrane_set_drag(m, 5));
    if (extra == STIFFNESS_DAMPING) ok(cd_membrane_set_stiffness_damping(m, 0.2));
    if (extra == TIE) ok(cd_membrane_attach(m, 7, 8, 90, 0, NULL, 0));
    if (extra == DAMPED_TIE) ok(cd_membrane_attach(m, 7, 8, 9, 3, NULL, 0));
    if (extra != MATCHED) return 1;
    if (kind == WILD_TORUS || kind == WILD_CYLINDER_PIN || kind == WILD_PLATE_RING) return 0;
    ok(cd_membrane_set_edge(m, CD_EDGE_U_LAST, CD_NODE_MATCHED));
    return 1;
}

/* At 0.999 of the limit the fastest mode's energy swings by up to 1 / (1 - 0.999^2) = 500 times, and no more. */
static void symplectic_euler_is_bounded_at_0_999_of_the_limit(void** state) {
    (void)state;
    for (int kind = 0; kind < WILD_KINDS; ++kind)
        for (int extra = 0; extra < EXTRAS; ++extra)
            for (int p = 0; p < 2; ++p) {
                cd_membrane* m = wild_membrane((enum wild)kind, COLUMNS, ROWS, 1, p ? CD_FLOAT64 : CD_FLOAT32, 1.3, 17);
                ok(cd_membrane_set_method(m, CD_METHOD_SYMPLECTIC_EULER));
                if (!add(m, (enum extra)extra, (enum wild)kind) || (p == 0 && extra != NOTHING)) {
                    cd_membrane_destroy(m);
                    continue;
                }
                wild_shake(m, 1, 1, 18);
                const double dt = 0.999 * stable_dt(m), start = sheet_swing_energy(m);
                const double early = highest_energy(m, dt);
                ok(cd_membrane_step(m, dt, STEPS - 2 * WINDOW));
                const double late = highest_energy(m, dt);
                if (early > 100 * start || !(late <= early))
                    print_message("%s%s, float%d: energy x %.3g early, x %.3g after %d steps\n", wild_names[kind],
                                  extra_names[extra], p ? 64 : 32, early / start, late / start, STEPS);
                assert_true(early <= 1000 * start);
                assert_true(late <= 2 * early);
                cd_membrane_destroy(m);
            }
}

/* The limit of uniform sheets is that of a mode that turns from node to node, which edges only come near to. */
static void symplectic_euler_diverges_not_far_above_the_limit_of_uniform_sheets(void** state) {
    (void)state;
    static const enum sheet_ends ends[][2] = {{SHEET_FREE, SHEET_FREE},
                                              {SHEET_FIXED, SHEET_FIXED},
                                              {SHEET_FIXED_FREE, SHEET_FREE},
                                              {SHEET_RING, SHEET_RING},
                                              {SHEET_FIXED, SHEET_RING}};
    for (size_t k = 0; k < COUNT(ends); ++k)
        for (int rule = 0; rule < 2; ++rule)
            for (int damped = 0; damped < 3; ++damped) {
                const struct sheet s = {.ends = {ends[k][0], ends[k][1]},
                                        .nodes = {COLUMNS, ROWS},
                                        .rule = rule,
                                        .mass = 1.7,
                                        .stiffness = {0.6, 0.8},
                                        .bend = ends[k][0] == SHEET_FIXED ? 1e-3 : 0,
                                        .drag = damped == 1 ? 3 : 0,
                                        .damping = damped == 2 ? 0.01 : 0};
                cd_membrane* m = sheet_membrane(&s, 1, CD_FLOAT64);
                ok(cd_membrane_set_method(m, CD_METHOD_SYMPLECTIC_EULER));
                wild_shake(m, 1, 1, 19);
                const double dt = 1.03 * stable_dt(m), start = sheet_swing_energy(m);
                const cd_status status = cd_membrane_step(m, dt, STEPS);
                if (status != CD_ERROR_DIVERGED) {
                    ok(status);
                    const double growth = sheet_swing_energy(m) / start; /* or too large a number to square */
                    if (growth <= 1e12)
                        print_message("ends %d %d, rule %d: energy x %.3g after %d steps\n", ends[k][0], ends[k][1],
                                      rule, growth, STEPS);
                    assert_false(growth <= 1e12);
                }
                cd_membrane_destroy(m);
            }
}

/* 4 - 2 dt c - dt^2 w^2 > 0 with c = drag + damping w^2. */
static double limit_of(const struct sheet* s, long double omega) {
    const long double w2 = omega * omega, c = s->drag + s->damping * w2;
    return (double)(4 / (c + sqrtl(c * c + 4 * w2)));
}

static int has_no_free_end(enum sheet_ends ends) { return ends == SHEET_FIXED || ends == SHEET_RING; }

/* Never above that of the fastest mode the sheet has, never below that of the fastest it could have. */
static void stable_dt_of_uniform_sheets_lies_between_two_closed_forms(void** state) {
    (void)state;
    static const enum sheet_ends all[] = {SHEET_FREE, SHEET_FIXED, SHEET_FIXED_FREE, SHEET_RING};
    static const size_t sizes[][2] = {{3, 3}, {4, 7}, {10, 5}, {101, 64}};
    for (size_t k = 0; k < COUNT(all) * COUNT(all); ++k)
        for (size_t size = 0; size < COUNT(sizes); ++size)
            for (int rule = 0; rule < 2; ++rule)
                for (int damped = 0; damped < 2; ++damped)
                    for (int bend = 0; bend < 2; ++bend) {
                        struct sheet s = {.ends = {all[k % COUNT(all)], all[k / COUNT(all)]},
                                          .nodes = {sizes[size][0], sizes[size][1]},
                                          .rule = rule,
                                          .mass = 1.3,
                                          .stiffness = {0.8, 0.5},
                                          .bend = bend ? 1e-3 : 0,
                                          .drag = damped ? 0.5 : 0,
                                          .damping = damped ? 1e-3 : 0};
                        if (bend && !(has_no_free_end(s.ends[0]) && has_no_free_end(s.ends[1]))) continue;
                        const struct sheet_mode fastest =
                            sheet_mode(&s, s.ends[0] == SHEET_RING ? s.nodes[0] / 2 : sheet_last_mode(&s, 0),
                                       s.ends[1] == SHEET_RING ? s.nodes[1] / 2 : sheet_last_mode(&s, 1));
                        const double most = limit_of(&s, sheet_omega(&fastest));
                        const double least = limit_of(&s, sheet_omega_max(&s));
                        cd_membrane* m = sheet_membrane(&s, 1, CD_FLOAT64);
                        const double got = stable_dt(m);
                        if (!(got <= most * (1 + 1e-9)) || !(got >= least * (1 - 1e-9)))
                            print_message(
                                "ends %d %d, %zu x %zu, rule %d, damped %d, bend %d: %.12g, not in [%.12g, "
                                "%.12g]\n",
                                s.ends[0], s.ends[1], s.nodes[0], s.nodes[1], rule, damped, bend, got, least, most);
                        assert_true(got <= most * (1 + 1e-9));
                        assert_true(got >= least * (1 - 1e-9));
                        cd_membrane_destroy(m);
                    }
}

static void stable_dt_is_infinite_where_nothing_swings(void** state) {
    (void)state;
    cd_membrane* m = NULL;
    double dt = 0;
    ok(cd_membrane_create(0, 0, 2, CD_FLOAT64, NULL, &m));
    ok(cd_membrane_set_solver(m, CD_SOLVER_ALTERNATING));
    ok(cd_membrane_stable_dt(m, &dt));
    assert_true(isinf(dt));
    cd_membrane_destroy(m);
    ok(cd_membrane_create(3, 3, 1, CD_FLOAT64, NULL, &m));
    ok(cd_membrane_set_solver(m, CD_SOLVER_ALTERNATING));
    ok(cd_membrane_set_stiffness(m, 0, 0));
    ok(cd_membrane_stable_dt(m, &dt));
    assert_true(isinf(dt));
    cd_membrane_destroy(m);
}

/* Without damping every mode's energy grows by |1 + i omega dt|^2 a step, however small dt is. */
static void forward_euler_grows_by_the_exact_factor_at_every_dt(void** state) {
    (void)state;
    const struct sheet s = {.nodes = {COLUMNS, ROWS}, .mass = 1.3, .stiffness = {0.8, 0.5}};
    double x[COLUMNS * ROWS];
    for (int lambda0 = 0; lambda0 < 2; ++lambda0)
        for (size_t j = 1; j < ROWS; j += 5)
            for (double z = 1e-3; z < 5; z *= 10) {
                const struct sheet_mode mode = sheet_mode(&s, j, j / 2);
                cd_membrane* m = sheet_membrane(&s, 1, CD_FLOAT64);
                sheet_set_time_step(m, &time_steps[lambda0 ? LAMBDA_0 : FORWARD_EULER]);
                for (size_t i = 0; i < COLUMNS * ROWS; ++i)
                    x[i] = (double)sheet_shape(&s, j, j / 2, i % COLUMNS, i / COLUMNS);
                sheet_write(m, CD_POSITION, x);
                const int steps = z > 0.5 ? 4 : 20;
                const double start = sheet_swing_energy(m), expected = pow(1 + z * z, steps);
                ok(cd_membrane_step(m, z / (double)sheet_omega(&mode), (size_t)steps));
                assert_true(expected > 1);
                assert_near(sheet_swing_energy(m) / start, expected, 1e-11, 0);
                cd_membrane_destroy(m);
            }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(symplectic_euler_is_bounded_at_0_999_of_the_limit),
        cmocka_unit_test(symplectic_euler_diverges_not_far_above_the_limit_of_uniform_sheets),
        cmocka_unit_test(stable_dt_of_uniform_sheets_lies_between_two_closed_forms),
        cmocka_unit_test(stable_dt_is_infinite_where_nothing_swings),
        cmocka_unit_test(forward_euler_grows_by_the_exact_factor_at_every_dt),
    };
    return cmocka_run_group_tests_name("membrane limits", tests, NULL, NULL);
}
