/* Thin plates: frequencies of hinged and clamped ones, and steps where twist weighs most. */
#include <math.h>
#include <stdlib.h>

#include "check.h"
#include "grid.h"
#include "reference.h"
#include "sheet.h"

static const char* const solver_names[] = {"alternating", "coupled"};

/* Angular frequency of a sheet that swings in nearly one mode, from x_{n+1} + x_{n-1} = 2 cos(angle) x_n of its part
 * along that shape; lambda 1/2 turns a mode by 2 atan(omega dt / 2). */
static double frequency(cd_membrane* m, const double* shape, double dt, size_t steps) {
    const size_t nodes = sheet_nodes(m);
    double* x = calloc(nodes, sizeof *x);
    assert_non_null(x);
    double before = 0, now = 0, next = 0, products = 0, squares = 0;
    sheet_write(m, CD_POSITION, shape);
    for (size_t step = 0; step <= steps; ++step) {
        if (step > 0) sheet_step(m, dt, 1);
        sheet_read(m, CD_POSITION, x);
        before = now, now = next, next = 0;
        for (size_t i = 0; i < nodes; ++i) next += shape[i] * x[i];
        if (step > 1) products += now * (next + before), squares += 2 * now * now;
    }
    free(x);
    return 2 / dt * tan(acos(products / squares) / 2);
}

/* Of mass 1 and bend D over the unit square: omega = pi^2 (p^2 + q^2) sqrt(D). */
static void hinged_plates_swing_at_their_frequencies_to_second_order(void** state) {
    (void)state;
    static const size_t modes[][2] = {{1, 1}, {2, 1}, {2, 2}, {3, 1}};
    const double d = 0.3;
    for (size_t k = 0; k < COUNT(modes); ++k)
        for (int solver = 0; solver < 2; ++solver) {
            const size_t p = modes[k][0], q = modes[k][1];
            const double exact = (double)(PI * PI) * (double)(p * p + q * q) * sqrt(d);
            double before = 0, order = 0, error = 0;
            for (size_t n = 8; n <= 32; n *= 2) {
                const struct sheet s = {.ends = {SHEET_FIXED, SHEET_FIXED},
                                        .nodes = {n + 1, n + 1},
                                        .rule = CD_MASS_HALF_ENDS,
                                        .mass = 1,
                                        .bend = d};
                double* shape = calloc((n + 1) * (n + 1), sizeof *shape);
                assert_non_null(shape);
                for (size_t i = 0; i < (n + 1) * (n + 1); ++i)
                    shape[i] = (double)sheet_shape(&s, p, q, i % (n + 1), i / (n + 1));
                cd_membrane* m = sheet_membrane(&s, 1, CD_FLOAT64);
                ok(cd_membrane_set_solver(m, solver));
                ok(cd_membrane_set_tolerance(m, 1e-10, 200));
                error = fabs(frequency(m, shape, 0.01 / exact, 200) / exact - 1);
                order = log2(before / error);
                before = error;
                free(shape);
                cd_membrane_destroy(m);
            }
            print_message("hinged plate (%zu, %zu), %-11s frequency to %.1e with 32 x 32 springs, order %.2f\n", p, q,
                          solver_names[solver], error, order);
            assert_true(fabs(order - 2) < 0.1);
        }
}

/* Clamped: two rows of nodes are pinned all round, so that half-way between them neither place nor slope can change:
 * there is the rim. The lowest mode has omega sqrt(mass / D) = 35.985 on the unit square, to the accuracy of tables. */
static void a_clamped_square_plate_swings_at_35_985(void** state) {
    (void)state;
    for (int solver = 0; solver < 2; ++solver) {
        double before = 0, order = 0, error = 0;
        for (size_t n = 12; n <= 48; n *= 2) {
            const size_t side = n + 2, nodes = side * side;
            const double inside = (double)n, all = (double)(n + 1), d = 0.5;
            cd_membrane* m = NULL;
            double* shape = calloc(nodes, sizeof *shape);
            assert_non_null(shape);
            ok(cd_membrane_create(n + 1, n + 1, 1, CD_FLOAT64, NULL, &m));
            ok(cd_membrane_set_solver(m, CD_SOLVER_ALTERNATING));
            ok(cd_membrane_set_mass_rule(m, CD_MASS_HALF_ENDS));
            /* per node 1 / n^2, and n^2 D per bend, as a plate of n x n springs would have */
            ok(cd_membrane_set_mass(m, all * all / (inside * inside)));
            ok(cd_membrane_set_stiffness(m, 0, 0));
            ok(cd_membrane_set_bend(m, d * inside * inside / (all * all)));
            ok(cd_membrane_enable_field(m, CD_PIN));
            for (size_t i = 0; i < nodes; ++i) {
                const size_t u = i % side, v = i / side;
                const int rim = u < 2 || v < 2 || u + 2 >= side || v + 2 >= side;
                const double s = ((double)u - 0.5) / inside, t = ((double)v - 0.5) / inside;
                if (rim) sheet_set(m, CD_PIN, u, v, CD_NODE_PINNED);
                const double bump = sin((double)PI * s) * sin((double)PI * t);
                shape[i] = rim ? 0 : bump * bump;
            }
            ok(cd_membrane_set_solver(m, solver));
            ok(cd_membrane_set_tolerance(m, 1e-10, 300));
            const double exact = 35.985 * sqrt(d);
            error = frequency(m, shape, 0.05 / exact, 1500) / exact - 1;
            order = log2(before / fabs(error));
            before = fabs(error);
            free(shape);
            cd_membrane_destroy(m);
        }
        print_message("clamped plate, %-11s frequency off by %+.1e with 48 springs a side, order %.2f\n",
                      solver_names[solver], error, order);
        assert_true(fabs(error) < 0.005);
        assert_true(order > 1.5);
    }
}

/* Started at rest no plate ever holds more energy than then: from far below the step that mode (4, 4) can take to far
 * above, with drag from none to much. The twist joins the directions, so that no factor of one of them holds it. */
static void plates_never_gain_energy_at_any_step_and_drag(void** state) {
    (void)state;
    static const struct time_step ways[] = {{"lambda 1/2", CD_METHOD_IMPLICIT, 0.5, 0, 0},
                                            {"lambda 0.6", CD_METHOD_IMPLICIT, 0.6, 0, 0},
                                            {"lambda 1", CD_METHOD_IMPLICIT, 1, 0, 0},
                                            {"stiff second", CD_METHOD_STIFF_SECOND, 0, 0, 0}};
    enum { N = 13 };
    double worst = 0;
    for (int solver = 0; solver < 2; ++solver)
        for (size_t w = 0; w < COUNT(ways); ++w)
            for (double reach = 0.5; reach < 200; reach *= 1.5)
                for (double drag = 0.001; drag < 2000; drag *= 100) {
                    struct sheet s = {.ends = {SHEET_FIXED, SHEET_FIXED}, .nodes = {N, N}, .mass = 1, .bend = 1};
                    const struct sheet_mode mode = sheet_mode(&s, 4, 4);
                    const double dt = reach / (double)sheet_omega(&mode);
                    double x[N * N];
                    uint64_t seed = 9;
                    s.drag = drag < 0.005 ? 0 : drag / dt;
                    for (size_t i = 0; i < N * N; ++i) {
                        const int rim = i % N == 0 || i % N == N - 1 || i / N == 0 || i / N == N - 1;
                        x[i] = rim ? 0 : random_number(&seed);
                    }
                    cd_membrane* m = sheet_membrane(&s, 1, CD_FLOAT64);
                    sheet_set_time_step(m, &ways[w]);
                    ok(cd_membrane_set_solver(m, solver));
                    sheet_write(m, CD_POSITION, x);
                    const double start = sheet_swing_energy(m);
                    double highest = 0;
                    for (int call = 0; call < (solver ? 4 : 20); ++call) {
                        sheet_step(m, dt, 10);
                        highest = fmax(highest, sheet_swing_energy(m) / start);
                    }
                    if (!(highest <= 1 + 1e-9))
                        print_message("hinged plate, %s, %s, omega_44 dt = %.3g, drag dt = %g: energy x %.9g\n",
                                      solver_names[solver], ways[w].name, reach, s.drag * dt, highest);
                    worst = fmax(worst, highest);
                    cd_membrane_destroy(m);
                }
    assert_true(worst <= 1 + 1e-9);
}

/* Where (h omega_u) (h omega_v) is 1 the twist weighs as much as mass and factors together: a mode that would be
 * without any mass, were the twist on the right side alone, and run away. */
static void a_plate_does_not_run_away_where_twist_weighs_most(void** state) {
    (void)state;
    enum { N = 13 };
    const struct sheet s = {.ends = {SHEET_FIXED, SHEET_FIXED}, .nodes = {N, N}, .mass = 1, .bend = 1};
    const struct sheet_mode mode = sheet_mode(&s, 4, 4);
    const double dt = 4 / (double)sheet_omega(&mode); /* (dt / 2)^2 omega_u^2 = (dt / 2)^2 omega_v^2 = 1 */
    double x[N * N];
    for (size_t i = 0; i < N * N; ++i) x[i] = (double)sheet_shape(&s, 4, 4, i % N, i / N);
    for (int solver = 0; solver < 2; ++solver) {
        cd_membrane* m = sheet_membrane(&s, 1, CD_FLOAT64);
        ok(cd_membrane_set_solver(m, solver));
        sheet_write(m, CD_POSITION, x);
        const double start = sheet_swing_energy(m);
        sheet_step(m, dt, 1000);
        assert_true(sheet_swing_energy(m) <= (1 + 1e-9) * start);
        cd_membrane_destroy(m);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(hinged_plates_swing_at_their_frequencies_to_second_order),
        cmocka_unit_test(a_clamped_square_plate_swings_at_35_985),
        cmocka_unit_test(plates_never_gain_energy_at_any_step_and_drag),
        cmocka_unit_test(a_plate_does_not_run_away_where_twist_weighs_most),
    };
    return cmocka_run_group_tests_name("membrane plates", tests, NULL, NULL);
}
