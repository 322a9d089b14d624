/* Parts of a sheet that are not there: what is left moves as if it had never been larger, and two parts move as two. */
#include <math.h>
#include <stdlib.h>

#include "check.h"
#include "grid.h"
#include "reference.h"
#include "sheet.h"

enum { COLUMNS = 15, ROWS = 11, NODES = COLUMNS * ROWS };
static const char* const solver_names[] = {"alternating", "coupled"};

struct window {
    size_t u, v, columns, rows;
};

/* The sheet in a window of a large one, of masses and springs at random: the same numbers in all that share a place.
 * All have these fields on. */
static double value_at(cd_field field, size_t u, size_t v) {
    uint64_t seed = 1000 * (uint64_t)field + 37 * v + u;
    return field == CD_MASS ? exp(random_number(&seed)) : 30 * exp(2 * random_number(&seed));
}

static cd_membrane* new_sheet(struct window at) {
    static const cd_field fields[] = {CD_MASS, CD_STIFFNESS_U, CD_STIFFNESS_V};
    cd_membrane* m = NULL;
    ok(cd_membrane_create(at.columns - 1, at.rows - 1, 1, CD_FLOAT64, NULL, &m));
    ok(cd_membrane_set_solver(m, CD_SOLVER_ALTERNATING));
    ok(cd_membrane_set_stiffness_damping(m, 1e-3));
    ok(cd_membrane_set_drag(m, 0.1));
    for (size_t k = 0; k < COUNT(fields); ++k) {
        ok(cd_membrane_enable_field(m, fields[k]));
        for (size_t v = 0; v + (fields[k] == CD_STIFFNESS_V) < at.rows; ++v)
            for (size_t u = 0; u + (fields[k] == CD_STIFFNESS_U) < at.columns; ++u)
                sheet_set(m, fields[k], u, v, value_at(fields[k], at.u + u, at.v + v));
    }
    return m;
}

/* The numbers of the nodes in the window; velocities of those that are there. */
static void write_state(cd_membrane* m, struct window at, const double* x, const double* v) {
    double mask;
    for (size_t row = 0; row < at.rows; ++row)
        for (size_t u = 0; u < at.columns; ++u) {
            const size_t from = (at.v + row) * COLUMNS + at.u + u;
            const int absent = cd_membrane_read_f64(m, CD_MASK, u, row, 1, 1, &mask, 1) == CD_OK && mask == 0;
            ok(cd_membrane_write_f64(m, CD_POSITION, u, row, 1, 1, x + from, 1));
            if (!absent) ok(cd_membrane_write_f64(m, CD_VELOCITY, u, row, 1, 1, v + from, 1));
        }
}

static void configure(cd_membrane* m, const struct time_step* step, cd_solver solver) {
    sheet_set_time_step(m, step);
    ok(cd_membrane_set_solver(m, solver));
    ok(cd_membrane_set_tolerance(m, 1e-13, 1000));
}

static const struct window whole = {0, 0, COLUMNS, ROWS};

static void random_state(double* x, double* v) {
    uint64_t seed = 21;
    for (size_t i = 0; i < NODES; ++i) x[i] = random_number(&seed), v[i] = random_number(&seed);
}

/* The largest difference between the part of `large` in the window and `small`. */
static double apart(const cd_membrane* large, const cd_membrane* small, struct window at) {
    double far = 0;
    for (size_t v = 0; v < at.rows; ++v)
        for (size_t u = 0; u < at.columns; ++u) {
            far = fmax(far,
                       fabs(sheet_get(large, CD_POSITION, at.u + u, at.v + v) - sheet_get(small, CD_POSITION, u, v)));
            far = fmax(far,
                       fabs(sheet_get(large, CD_VELOCITY, at.u + u, at.v + v) - sheet_get(small, CD_VELOCITY, u, v)));
        }
    return far;
}

/* Explicit steps, bit for bit; where systems are solved, sums run over more numbers. */
static void what_a_mask_leaves_moves_as_a_smaller_sheet(void** state) {
    (void)state;
    static const struct window windows[] = {{3, 2, 8, 5}, {0, 0, 9, 9}, {6, 4, 9, 7},
                                            {5, 5, 1, 1}, {2, 3, 7, 1}, {4, 1, 1, 8}};
    double x[NODES], v[NODES], worst[2] = {0, 0};
    random_state(x, v);
    for (size_t w = 0; w < COUNT(windows); ++w)
        for (int solver = 0; solver < 2; ++solver)
            for (size_t way = 0; way < TIME_STEPS; ++way) {
                const double dt = time_steps[way].is_explicit ? 0.002 : 0.2;
                cd_membrane* large = new_sheet(whole);
                cd_membrane* small = new_sheet(windows[w]);
                ok(cd_membrane_enable_field(large, CD_MASK));
                for (size_t i = 0; i < NODES; ++i) {
                    const size_t u = i % COLUMNS - windows[w].u, row = i / COLUMNS - windows[w].v; /* wraps below 0 */
                    if (u >= windows[w].columns || row >= windows[w].rows)
                        sheet_set(large, CD_MASK, i % COLUMNS, i / COLUMNS, 0);
                }
                configure(large, &time_steps[way], solver);
                configure(small, &time_steps[way], solver);
                write_state(large, whole, x, v);
                write_state(small, windows[w], x, v);
                sheet_step(large, dt, 20);
                sheet_step(small, dt, 20);
                const double far = apart(large, small, windows[w]);
                if (windows[w].v + windows[w].rows < ROWS)
                    assert_true(sheet_get(large, CD_POSITION, 0, ROWS - 1) == x[(ROWS - 1) * COLUMNS]);
                if (!(far <= (sheet_solves(&time_steps[way]) ? 1e-9 : 0)))
                    print_message("window %zu, %s, %s: apart by %.1e\n", w, solver_names[solver], time_steps[way].name,
                                  far);
                worst[sheet_solves(&time_steps[way])] = fmax(worst[sheet_solves(&time_steps[way])], far);
                assert_near(sheet_swing_energy(large), sheet_swing_energy(small), 1e-9, 1);
                cd_membrane_destroy(large);
                cd_membrane_destroy(small);
            }
    print_message("masked sheets and smaller ones are apart by %.1e (explicit), %.1e (implicit)\n", worst[0], worst[1]);
    assert_true(worst[0] == 0);
    assert_true(worst[1] <= 1e-9);
}

/* A column in the middle is masked away, or the springs across it are cut. Alternating steps of such a sheet weigh all
 * of it at once: there only a half that is still is promised to stay so. */
/* Alternating takes the best for the whole sheet: its parts then feel each other, but for one that is at rest. */
static void a_sheet_cut_in_two_moves_as_two(void** state) {
    (void)state;
    static const struct window left = {0, 0, 7, ROWS}, right = {8, 0, 7, ROWS};
    double x[NODES], v[NODES], worst = 0;
    random_state(x, v);
    for (int cut = 0; cut < 2; ++cut)
        for (int solver = 0; solver < 2; ++solver)
            for (size_t way = 0; way < TIME_STEPS; ++way) {
                const int solves = sheet_solves(&time_steps[way]);
                const double dt = time_steps[way].is_explicit ? 0.002 : 0.2;
                if (solves && solver == CD_SOLVER_ALTERNATING) continue;
                cd_membrane* both = new_sheet(whole);
                cd_membrane* one = new_sheet(left);
                cd_membrane* two = new_sheet(right);
                cd_membrane* all[3] = {both, one, two};
                if (!cut) ok(cd_membrane_enable_field(both, CD_MASK));
                for (size_t row = 0; row < ROWS; ++row) {
                    if (!cut) sheet_set(both, CD_MASK, 7, row, 0);
                    if (cut) sheet_set(both, CD_STIFFNESS_U, 6, row, 0);
                    if (cut) sheet_set(both, CD_STIFFNESS_U, 7, row, 0);
                }
                for (int k = 0; k < 3; ++k) configure(all[k], &time_steps[way], solver);
                write_state(both, whole, x, v);
                write_state(one, left, x, v);
                write_state(two, right, x, v);
                for (int k = 0; k < 3; ++k) sheet_step(all[k], dt, 20);
                const double far = fmax(apart(both, one, left), apart(both, two, right));
                if (!(far <= (solves ? 1e-9 : 0)))
                    print_message("cut %d, %s, %s: apart by %.1e\n", cut, solver_names[solver], time_steps[way].name,
                                  far);
                assert_true(solves || far == 0);
                worst = fmax(worst, far);
                for (int k = 0; k < 3; ++k) cd_membrane_destroy(all[k]);
                random_state(x, v);
            }
    print_message("halves and sheets of their own are apart by %.1e\n", worst);
    assert_true(worst <= 1e-9);
}

static void a_part_at_rest_stays_at_rest(void** state) {
    (void)state;
    double x[NODES], v[NODES];
    for (int cut = 0; cut < 2; ++cut)
        for (int wide = 0; wide < 2; ++wide) /* which of the two parts is the heavier */
            for (size_t way = 0; way < TIME_STEPS; ++way) {
                const size_t seam = wide ? 11 : 3;
                cd_membrane* m = new_sheet(whole);
                ok(cd_membrane_enable_field(m, cut ? CD_STIFFNESS_U : CD_MASK));
                for (size_t row = 0; row < ROWS; ++row) sheet_set(m, cut ? CD_STIFFNESS_U : CD_MASK, seam, row, 0);
                random_state(x, v);
                for (size_t i = 0; i < NODES; ++i)
                    if (i % COLUMNS >= seam + (cut ? 1 : 0)) x[i] = v[i] = 0;
                configure(m, &time_steps[way], CD_SOLVER_ALTERNATING);
                ok(cd_membrane_set_gravity(m, (const double[1]){0}, 1));
                write_state(m, whole, x, v);
                sheet_step(m, time_steps[way].is_explicit ? 0.002 : 0.2, 20);
                sheet_read(m, CD_POSITION, x);
                for (size_t i = 0; i < NODES; ++i)
                    if (i % COLUMNS > seam) assert_true(x[i] == 0);
                cd_membrane_destroy(m);
            }
}

/* A mask that hides nothing, and fields that hold the uniform values, change nothing but the way to the answer. */
static void fields_of_uniform_values_change_nothing(void** state) {
    (void)state;
    static const cd_field fields[] = {CD_MASS, CD_STIFFNESS_U, CD_STIFFNESS_V, CD_MASK, CD_PIN, CD_TARGET};
    for (int rule = 0; rule < 2; ++rule)
        for (size_t k = 0; k < COUNT(fields); ++k)
            for (size_t way = 0; way < TIME_STEPS; ++way) {
                double x[2][NODES], v[2][NODES];
                random_state(x[0], v[0]);
                for (int with = 1; with >= 0; --with) {
                    const struct sheet s = {.ends = {SHEET_FIXED_FREE, SHEET_FREE},
                                            .nodes = {COLUMNS, ROWS},
                                            .rule = rule,
                                            .mass = 3,
                                            .stiffness = {5, 8},
                                            .drag = 0.1,
                                            .damping = 0.01};
                    cd_membrane* m = sheet_membrane(&s, 1, CD_FLOAT64);
                    if (with) ok(cd_membrane_enable_field(m, fields[k]));
                    configure(m, &time_steps[way], CD_SOLVER_COUPLED);
                    for (size_t i = 0; i < NODES; i += COLUMNS) v[0][i] = 0;
                    sheet_write(m, CD_POSITION, x[0]);
                    sheet_write(m, CD_VELOCITY, v[0]);
                    sheet_step(m, time_steps[way].is_explicit ? 0.005 : 0.2, 20);
                    sheet_read(m, CD_POSITION, x[with]);
                    sheet_read(m, CD_VELOCITY, v[with]);
                    cd_membrane_destroy(m);
                }
                for (size_t i = 0; i < NODES; ++i) {
                    assert_near(x[1][i], x[0][i], 1e-10, 1);
                    assert_near(v[1][i], v[0][i], 1e-10, 10);
                }
            }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_a_mask_leaves_moves_as_a_smaller_sheet),
        cmocka_unit_test(a_sheet_cut_in_two_moves_as_two),
        cmocka_unit_test(a_part_at_rest_stays_at_rest),
        cmocka_unit_test(fields_of_uniform_values_change_nothing),
    };
    return cmocka_run_group_tests_name("membrane mask", tests, NULL, NULL);
}
