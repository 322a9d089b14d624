/* Nodes tied to targets: where a sheet comes to rest on its ties, what a damper takes, following, and letting go. */
#include <math.h>
#include <stdlib.h>

#include "check.h"
#include "grid.h"
#include "reference.h"
#include "sheet.h"

enum { COLUMNS = 10, ROWS = 7, NODES = COLUMNS * ROWS, COMPONENTS = 2, NUMBERS = NODES * COMPONENTS };
static const char* const solver_names[] = {"alternating", "coupled"};

static cd_membrane* make(cd_solver solver, cd_precision precision) {
    const struct sheet s = {.nodes = {COLUMNS, ROWS}, .mass = 2, .stiffness = {60, 80}};
    cd_membrane* m = sheet_membrane(&s, COMPONENTS, precision);
    ok(cd_membrane_set_solver(m, solver));
    return m;
}

/* Held by two ties alone the sheet's weight is what they carry: their pulls add up to it, and each node is where a
 * direct solve says. */
static void a_sheet_comes_to_rest_on_its_ties(void** state) {
    (void)state;
    const double gravity[COMPONENTS] = {0.5, -9.81}, targets[2][COMPONENTS] = {{-1, 2}, {1.5, 3}},
                 stiffness[2] = {30, 70};
    static const size_t at[2][2] = {{0, ROWS - 1}, {COLUMNS - 1, 2}};
    for (int solver = 0; solver < 2; ++solver) {
        cd_membrane* m = make(solver, CD_FLOAT64);
        double x[NUMBERS], rest[NUMBERS] = {0}, size = 0;
        ok(cd_membrane_set_gravity(m, gravity, COMPONENTS));
        ok(cd_membrane_set_lambda(m, 1));
        for (int k = 0; k < 2; ++k)
            ok(cd_membrane_attach(m, at[k][0], at[k][1], stiffness[k], 0, targets[k], COMPONENTS));
        struct grid* g = grid_of(m);
        grid_rest(g, rest);
        sheet_step(m, 0.2, 5000);
        sheet_read(m, CD_POSITION, x);
        for (size_t i = 0; i < NUMBERS; ++i) size = fmax(size, fabs(rest[i]));
        for (size_t i = 0; i < NUMBERS; ++i) assert_near(x[i], rest[i], 1e-9, size);
        for (size_t c = 0; c < COMPONENTS; ++c) {
            double pull = 0;
            for (int k = 0; k < 2; ++k)
                pull += stiffness[k] * (targets[k][c] - x[(at[k][1] * COLUMNS + at[k][0]) * COMPONENTS + c]);
            assert_near(pull, -2 * gravity[c], 1e-8, 0);
        }
        grid_destroy(g);
        cd_membrane_destroy(m);
    }
}

/* Without dampers lambda 1/2 keeps the energy, alternating with what is in the extra mass, which is none at the start; a
 * damper at one node takes it from the whole sheet. */
static void ties_keep_energy_and_dampers_take_it(void** state) {
    (void)state;
    for (int solver = 0; solver < 2; ++solver)
        for (int p = 0; p < 2; ++p)
            for (int damped = 0; damped < 2; ++damped) {
                cd_membrane* m = make(solver, p ? CD_FLOAT64 : CD_FLOAT32);
                const double target[COMPONENTS] = {0.25, -0.5};
                double x[NUMBERS];
                uint64_t seed = 3;
                for (size_t i = 0; i < NUMBERS; ++i) x[i] = random_number(&seed);
                sheet_write(m, CD_POSITION, x);
                ok(cd_membrane_attach(m, 3, 2, 50, damped ? 4 : 0, target, COMPONENTS));
                const double start = sheet_swing_energy(m);
                double before = start;
                for (int k = 0; k < 20; ++k) {
                    sheet_step(m, 1.0 / 60, 30);
                    const double now = sheet_swing_energy(m);
                    const double allowed = p ? 1e-10 : 1e-4;
                    if (solver == 0) assert_true(now <= start * (1 + allowed));
                    else if (damped) assert_true(now < before);
                    else assert_near(now, start, allowed, 0);
                    before = now;
                }
                if (damped)
                    print_message("%s: a damper leaves %.2g of the energy after 10 s\n", solver_names[solver],
                                  before / start);
                if (damped) assert_true(before < 0.7 * start);
                cd_membrane_destroy(m);
            }
}

/* A target that moves at a constant velocity, with the sheet moving along, is a target at rest. */
static void a_sheet_follows_a_target_that_moves_on(void** state) {
    (void)state;
    const double speed = 0.5, dt = 1.0 / 64;
    for (int solver = 0; solver < 2; ++solver) {
        double x[2][NUMBERS], v[NUMBERS];
        for (int moves = 0; moves < 2; ++moves) {
            cd_membrane* m = make(solver, CD_FLOAT64);
            double target[COMPONENTS] = {1, 2};
            uint64_t seed = 3;
            ok(cd_membrane_set_tolerance(m, 1e-13, 200));
            for (size_t i = 0; i < NUMBERS; ++i) x[moves][i] = random_number(&seed), v[i] = moves ? speed : 0;
            sheet_write(m, CD_POSITION, x[moves]);
            sheet_write(m, CD_VELOCITY, v);
            ok(cd_membrane_attach(m, 3, 2, 50, 0, target, COMPONENTS));
            for (int k = 0; k < 64; ++k) {
                /* a step of lambda 1/2 sees the spring half-way */
                for (size_t c = 0; c < COMPONENTS; ++c)
                    target[c] = 1 + (double)c + (moves ? speed * dt * (k + 0.5) : 0);
                ok(cd_membrane_write_f64(m, CD_TARGET, 3, 2, 1, 1, target, COMPONENTS));
                sheet_step(m, dt, 1);
            }
            sheet_read(m, CD_POSITION, x[moves]);
            cd_membrane_destroy(m);
        }
        if (solver == CD_SOLVER_COUPLED)
            for (size_t i = 0; i < NUMBERS; ++i) assert_near(x[1][i], x[0][i] + speed, 1e-10, 1);
        else /* the answer is weighed against the velocity, which is another one: alike, not the same */
            for (size_t i = 0; i < NUMBERS; ++i) assert_near(x[1][i], x[0][i] + speed, 0.2, 1);
    }
}

static void a_sheet_let_go_keeps_its_momentum(void** state) {
    (void)state;
    for (int solver = 0; solver < 2; ++solver) {
        cd_membrane* m = make(solver, CD_FLOAT64);
        const double target[COMPONENTS] = {3, -1};
        double before[COMPONENTS], after[COMPONENTS];
        ok(cd_membrane_attach(m, 5, 5, 20, 0.1, target, COMPONENTS));
        sheet_step(m, 0.02, 20);
        ok(cd_membrane_detach(m, 5, 5));
        ok(cd_membrane_get_momentum(m, before, COMPONENTS));
        assert_true(fabs(before[0]) > 0.1);
        sheet_step(m, 0.02, 100);
        ok(cd_membrane_get_momentum(m, after, COMPONENTS));
        for (size_t c = 0; c < COMPONENTS; ++c) assert_near(after[c], before[c], 1e-11, 0);
        cd_membrane_destroy(m);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_sheet_comes_to_rest_on_its_ties),
        cmocka_unit_test(ties_keep_energy_and_dampers_take_it),
        cmocka_unit_test(a_sheet_follows_a_target_that_moves_on),
        cmocka_unit_test(a_sheet_let_go_keeps_its_momentum),
    };
    return cmocka_run_group_tests_name("membrane attachments", tests, NULL, NULL);
}
