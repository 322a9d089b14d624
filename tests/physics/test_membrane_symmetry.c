/* A sheet does not know which way is u, where a line begins, or which way time runs. */
#include <math.h>
#include <stdlib.h>

#include "check.h"
#include "grid.h"
#include "reference.h"
#include "sheet.h"
#include "wild.h"

enum { COLUMNS = 12, ROWS = 9, NODES = COLUMNS * ROWS };
static const char* const solver_names[] = {"alternating", "coupled"};

/* The sheet seen from behind: u and v change places, or either runs the other way. */
enum view { TRANSPOSED, MIRRORED_U, MIRRORED_V, VIEWS };
static const char* const view_names[VIEWS] = {"u and v swapped", "u reversed", "v reversed"};

/* Where number i of a field of columns x rows lies when seen so. */
static size_t seen(enum view view, size_t i, size_t columns, size_t rows) {
    const size_t u = i % columns, v = i / columns;
    if (view == TRANSPOSED) return u * rows + v;
    return view == MIRRORED_U ? v * columns + columns - 1 - u : (rows - 1 - v) * columns + u;
}

static void copy_field(const cd_membrane* from, cd_membrane* to, cd_field field, cd_field as, enum view view,
                       size_t columns, size_t rows) {
    double values[NODES], out[NODES];
    sheet_read(from, field, values);
    for (size_t i = 0; i < columns * rows; ++i) out[seen(view, i, columns, rows)] = values[i];
    ok(cd_membrane_enable_field(to, as));
    sheet_write(to, as, out);
}

static int has(const cd_membrane* m, cd_field field) {
    double value;
    return cd_membrane_read_f64(m, field, 0, 0, 1, 1, &value, 1) == CD_OK;
}

/* A sheet like `from`, of one component, seen so. */
static cd_membrane* view_of(const cd_membrane* from, enum view view, cd_precision precision) {
    const int swap = view == TRANSPOSED;
    double mass, k[2], bend, damping;
    int32_t ring[2];
    cd_mass_rule rule;
    cd_membrane* to = NULL;
    ok(cd_membrane_create(swap ? ROWS - 1 : COLUMNS - 1, swap ? COLUMNS - 1 : ROWS - 1, 1, precision, NULL, &to));
    ok(cd_membrane_set_solver(to, CD_SOLVER_ALTERNATING));
    ok(cd_membrane_get_mass(from, &mass));
    ok(cd_membrane_get_mass_rule(from, &rule));
    ok(cd_membrane_get_stiffness(from, &k[0], &k[1]));
    ok(cd_membrane_get_bend(from, &bend));
    ok(cd_membrane_get_stiffness_damping(from, &damping));
    ok(cd_membrane_get_ring(from, &ring[0], &ring[1]));
    ok(cd_membrane_set_mass(to, mass));
    ok(cd_membrane_set_mass_rule(to, rule));
    ok(cd_membrane_set_stiffness(to, k[swap], k[!swap]));
    ok(cd_membrane_set_ring(to, ring[swap], ring[!swap]));
    ok(cd_membrane_set_bend(to, bend));
    ok(cd_membrane_set_stiffness_damping(to, damping));
    for (int e = 0; e < 4; ++e) {
        cd_node node;
        int as = swap ? (e + 2) % 4 : e;
        if ((view == MIRRORED_U && e < 2) || (view == MIRRORED_V && e >= 2)) as = e ^ 1;
        ok(cd_membrane_get_edge(from, e, &node));
        ok(cd_membrane_set_edge(to, as, node));
    }
    const size_t su = COLUMNS - (ring[0] ? 0 : 1), sv = ROWS - (ring[1] ? 0 : 1);
    if (has(from, CD_MASS)) copy_field(from, to, CD_MASS, CD_MASS, view, COLUMNS, ROWS);
    if (has(from, CD_PIN)) copy_field(from, to, CD_PIN, CD_PIN, view, COLUMNS, ROWS);
    if (has(from, CD_MASK)) copy_field(from, to, CD_MASK, CD_MASK, view, COLUMNS, ROWS);
    if (has(from, CD_STIFFNESS_U))
        copy_field(from, to, CD_STIFFNESS_U, swap ? CD_STIFFNESS_V : CD_STIFFNESS_U, view, su, ROWS);
    if (has(from, CD_STIFFNESS_V))
        copy_field(from, to, CD_STIFFNESS_V, swap ? CD_STIFFNESS_U : CD_STIFFNESS_V, view, COLUMNS, sv);
    copy_field(from, to, CD_POSITION, CD_POSITION, view, COLUMNS, ROWS);
    copy_field(from, to, CD_VELOCITY, CD_VELOCITY, view, COLUMNS, ROWS);
    return to;
}

/* The largest difference between the sheet and its view after some steps, over the largest number. */
static double apart(enum wild kind, enum view view, cd_solver solver, const struct time_step* step, size_t steps) {
    cd_membrane* m = wild_membrane(kind, COLUMNS, ROWS, 1, CD_FLOAT64, 200, 31);
    double dt = 1.0 / 60, off = 0;
    wild_shake(m, 1, 1, 32);
    cd_membrane* other = view_of(m, view, CD_FLOAT64);
    if (step->is_explicit || step->grows) {
        ok(cd_membrane_stable_dt(m, &dt));
        dt *= step->grows ? 0.03 : 0.9;
    }
    cd_membrane* both[2] = {m, other};
    double state[2][2][NODES];
    for (int k = 0; k < 2; ++k) {
        sheet_set_time_step(both[k], step);
        ok(cd_membrane_set_solver(both[k], solver));
        ok(cd_membrane_set_tolerance(both[k], 1e-13, 1000));
        sheet_step(both[k], dt, steps);
        sheet_read(both[k], CD_POSITION, state[k][0]);
        sheet_read(both[k], CD_VELOCITY, state[k][1]);
        cd_membrane_destroy(both[k]);
    }
    for (int field = 0; field < 2; ++field) {
        double size = 1, far = 0; /* it starts with 1, and what has died out is compared with that */
        for (size_t i = 0; i < NODES; ++i) {
            size = fmax(size, fabs(state[0][field][i]));
            far = fmax(far, fabs(state[0][field][i] - state[1][field][seen(view, i, COLUMNS, ROWS)]));
        }
        off = fmax(off, far / size);
    }
    return off;
}

/* Explicit steps bit for bit, rings too, wherever their seam is. Alternating solves that weigh their answer make more
 * of every rounding from step to step, as anything may that is not linear: few steps of those. */
static void a_sheet_moves_as_its_mirror_images_do(void** state) {
    (void)state;
    double worst[2][VIEWS] = {{0}};
    for (int kind = 0; kind < WILD_KINDS; ++kind)
        for (int view = 0; view < VIEWS; ++view)
            for (int solver = 0; solver < 2; ++solver)
                for (size_t way = 0; way < TIME_STEPS; ++way) {
                    const int implicit = way > LAMBDA_0;
                    const int weighs = implicit && solver == CD_SOLVER_ALTERNATING && kind >= WILD_SEPARABLE;
                    if (kind == WILD_TIED) continue;
                    if (solver == CD_SOLVER_COUPLED && !implicit) continue;
                    const double off =
                        apart((enum wild)kind, (enum view)view, solver, &time_steps[way], weighs ? 10 : 50);
                    /* sums of forces go along u first; of stretches alone they come out the same either way */
                    const int exact = !implicit && !(view == TRANSPOSED && wild_has_bend((enum wild)kind));
                    if (!(off <= (exact ? 0 : 1e-9)))
                        print_message("%s, %s, %s, %s: apart by %.1e\n", wild_names[kind], view_names[view],
                                      solver_names[solver], time_steps[way].name, off);
                    assert_true(!exact || off == 0);
                    worst[solver][view] = fmax(worst[solver][view], off);
                }
    for (int view = 0; view < VIEWS; ++view) {
        print_message("%-15s apart by %.1e (alternating), %.1e (coupled)\n", view_names[view], worst[0][view],
                      worst[1][view]);
        assert_true(worst[0][view] <= 1e-9);
        assert_true(worst[1][view] <= 1e-9);
    }
}

/* lambda 1/2 without damping: velocities turned around lead back to the start. Alternating solves that weigh their
 * answer against the velocity they start from are not the same seen backwards, and are left out. */
static void turning_the_velocities_around_leads_back_to_the_start(void** state) {
    (void)state;
    static const double ratios[] = {1, 1e3};
    double worst[2] = {0, 0};
    for (int kind = 0; kind < WILD_KINDS; ++kind)
        for (int solver = 0; solver < 2; ++solver)
            for (size_t r = 0; r < COUNT(ratios); ++r) {
                if (solver == CD_SOLVER_ALTERNATING && kind >= WILD_SEPARABLE) continue;
                double x0[NODES], v0[NODES], x[NODES], v[NODES], size_x = 0, size_v = 0, far = 0, off = 0;
                cd_membrane* m = wild_membrane((enum wild)kind, COLUMNS, ROWS, 1, CD_FLOAT64, ratios[r], 31);
                const double dt = 1.0 / 30;
                ok(cd_membrane_set_solver(m, solver));
                ok(cd_membrane_set_tolerance(m, 1e-14, 1000));
                wild_shake(m, 1, 1, 33);
                sheet_read(m, CD_POSITION, x0);
                sheet_read(m, CD_VELOCITY, v0);
                for (int way = 0; way < 2; ++way) {
                    sheet_step(m, dt, solver == CD_SOLVER_COUPLED ? 50 : 500);
                    sheet_read(m, CD_POSITION, x);
                    sheet_read(m, CD_VELOCITY, v);
                    for (size_t i = 0; i < NODES; ++i) {
                        if (way == 0) far = fmax(far, fabs(x[i] - x0[i]));
                        size_x = fmax(size_x, fabs(x[i]));
                        size_v = fmax(size_v, fabs(v[i]));
                        v[i] = -v[i];
                    }
                    sheet_write(m, CD_VELOCITY, v);
                }
                for (size_t i = 0; i < NODES; ++i)
                    off = fmax(off, fmax(fabs(x[i] - x0[i]) / size_x, fabs(v[i] - v0[i]) / size_v));
                if (!(off <= 1e-9))
                    print_message("%s, %s, k/m = %g: back to %.1e\n", wild_names[kind], solver_names[solver], ratios[r],
                                  off);
                worst[solver] = fmax(worst[solver], off);
                assert_true(far > 0.1);
                cd_membrane_destroy(m);
            }
    print_message("backwards in time: to %.1e of the start (alternating), %.1e (coupled)\n", worst[0], worst[1]);
    assert_true(worst[0] <= 1e-9);
    assert_true(worst[1] <= 1e-9);
}

/* Nothing but where it is changes when a free sheet starts elsewhere. */
static void a_free_sheet_moves_the_same_wherever_it_is(void** state) {
    (void)state;
    for (int kind = 0; kind < WILD_KINDS; ++kind)
        for (int solver = 0; solver < 2; ++solver)
            for (size_t way = LAMBDA_1_2; way < TIME_STEPS; ++way) {
                double x[2][NODES], v[2][NODES];
                const double shift = 64;
                if (!wild_drifts((enum wild)kind)) continue;
                for (int k = 0; k < 2; ++k) {
                    cd_membrane* m = wild_membrane((enum wild)kind, COLUMNS, ROWS, 1, CD_FLOAT64, 200, 31);
                    sheet_set_time_step(m, &time_steps[way]);
                    ok(cd_membrane_set_solver(m, solver));
                    ok(cd_membrane_set_tolerance(m, 1e-12, 1000));
                    wild_shake(m, 1, 1, 34);
                    sheet_read(m, CD_POSITION, x[k]);
                    for (size_t i = 0; i < NODES && k == 1; ++i) x[k][i] += shift;
                    sheet_write(m, CD_POSITION, x[k]);
                    sheet_step(m, 1.0 / 60, 50);
                    sheet_read(m, CD_POSITION, x[k]);
                    sheet_read(m, CD_VELOCITY, v[k]);
                    cd_membrane_destroy(m);
                }
                for (size_t i = 0; i < NODES; ++i) {
                    if (x[0][i] == x[1][i] - shift && v[0][i] == v[1][i]) continue; /* absent */
                    assert_near(x[1][i] - shift, x[0][i], 1e-10, shift);
                    assert_near(v[1][i], v[0][i], 1e-10, shift * 60);
                }
            }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_sheet_moves_as_its_mirror_images_do),
        cmocka_unit_test(turning_the_velocities_around_leads_back_to_the_start),
        cmocka_unit_test(a_free_sheet_moves_the_same_wherever_it_is),
    };
    return cmocka_run_group_tests_name("membrane symmetry", tests, NULL, NULL);
}
