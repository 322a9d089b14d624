/* Ropes that end on cloth are lines of its nodes whose neighbours are absent: what they carry, and their energy. */
#include <math.h>

#include "check.h"
#include "cloth.h"
#include "sheet.h"

/* Cloth of CLOTH x CLOTH springs, and a rope of ROPE springs that goes on from its middle column. */
enum { CLOTH = 6, ROPE = 8, COLUMNS = CLOTH + 1, ROWS = CLOTH + ROPE + 1, MIDDLE = CLOTH / 2 };

static const double kSpring = 0.1, kGravity = 9.81; /* m, m/s^2 */

static cd_membrane* cloth_with_a_rope(double stiffness, double load) {
    const double gravity[3] = {0, 0, -kGravity};
    cd_membrane* m = cloth(CLOTH, ROWS - 1, 3, CD_FLOAT64);
    for (size_t v = 0; v < ROWS; ++v)
        for (size_t u = 0; u < COLUMNS; ++u) {
            const double x[3] = {kSpring * (double)u, 0, -kSpring * (double)v};
            ok(cd_membrane_write_f64(m, CD_POSITION, u, v, 1, 1, x, 3));
        }
    ok(cd_membrane_set_rest_length(m, kSpring * CLOTH, kSpring * (ROWS - 1)));
    ok(cd_membrane_set_stiffness(m, 2000, 2000));
    ok(cd_membrane_set_shear(m, 100));
    ok(cd_membrane_set_bend(m, 1e-5));
    ok(cd_membrane_set_gravity(m, gravity, 3));
    ok(cd_membrane_enable_field(m, CD_MASK));
    ok(cd_membrane_enable_field(m, CD_MASS));
    ok(cd_membrane_enable_field(m, CD_STIFFNESS_V));
    for (size_t v = 0; v < ROWS; ++v)
        for (size_t u = 0; u < COLUMNS; ++u) {
            if (v > CLOTH && u != MIDDLE) sheet_set(m, CD_MASK, u, v, 0);
            sheet_set(m, CD_MASS, u, v, 0.002);
        }
    for (size_t v = CLOTH; v < ROWS - 1; ++v) sheet_set(m, CD_STIFFNESS_V, MIDDLE, v, stiffness);
    sheet_set(m, CD_MASS, MIDDLE, ROWS - 1, load);
    return m;
}

/* Cloth that hangs by its first row carries, by a rope that may be as stiff as 10^5 times the cloth, loads of up to 5000
 * times a node's mass. Each spring of the rope pulls by the weight below it, and what holds the cloth by all of it. */
static void a_rope_pulls_by_what_hangs_on_it(void** state) {
    (void)state;
    static const struct {
        double stiffness, load;
    } ropes[] = {{200, 1e-4}, {200, 10}, {2e4, 0.01}, {2e8, 1e-4}, {2e8, 10}};
    double worst = 0;
    for (size_t r = 0; r < COUNT(ropes); ++r) {
        cd_membrane* m = cloth_with_a_rope(ropes[r].stiffness, ropes[r].load);
        ok(cd_membrane_set_edge(m, CD_EDGE_V_FIRST, CD_NODE_PINNED));
        ok(cd_membrane_set_bend(m, 0)); /* that carries a little, too, where springs stretch differently */
        ok(cd_membrane_set_drag(m, 3));
        ok(cd_membrane_step(m, 1 / 60.0, 2000));
        double below = ropes[r].load * kGravity, held = 0;
        const double all = below + 0.002 * kGravity * (COLUMNS * CLOTH + ROPE - 1);
        for (size_t v = ROWS - 1; v-- > CLOTH; below += 0.002 * kGravity)
            worst = fmax(worst, fabs(sheet_get(m, CD_TENSION_V, MIDDLE, v) / below - 1));
        for (size_t u = 0; u < COLUMNS; ++u) {
            double pull[3];
            ok(cd_membrane_get_reaction(m, u, 0, pull, 3));
            held -= pull[2];
        }
        worst = fmax(worst, fabs(held / all - 1));
        cd_membrane_destroy(m);
    }
    print_message("ropes that end on cloth carry their loads to %.1e\n", worst);
    assert_true(worst < 1e-6);
}

/* Thrown about, held by two corners or by none, in any step and with any effort. */
static void a_load_on_a_rope_makes_no_energy(void** state) {
    (void)state;
    static const double steps[] = {1 / 240.0, 1 / 60.0, 0.1, 1}, stiffness[] = {20, 2e4, 1e9},
                        loads[] = {1e-6, 0.01, 100};
    static const size_t efforts[][2] = {{1, 1}, {3, 0}, {8, 40}};
    double most = 0, drift = 0;
    for (uint64_t scene = 0; scene < 72; ++scene) {
        const double load = loads[scene / 4 % 3];
        cd_membrane* m = cloth_with_a_rope(stiffness[scene / 12 % 3], load);
        const int held = scene % 2;
        ok(cd_membrane_set_effort(m, efforts[scene % 3][0], efforts[scene % 3][1]));
        ok(cd_membrane_set_lambda(m, scene % 5 ? 1 : 0.6));
        cloth_shake(m, 0.03, 40 + scene);
        if (held) {
            ok(cd_membrane_enable_field(m, CD_PIN));
            sheet_set(m, CD_PIN, 0, 0, CD_NODE_PINNED);
            sheet_set(m, CD_PIN, CLOTH, 0, CD_NODE_PINNED);
        }
        const double throws[3] = {3 * load, 2 * load, -4 * load};
        ok(cd_membrane_impulse(m, MIDDLE, ROWS - 1, 1, throws, 3));
        double before = sheet_energy(m), p[2][3];
        const double scale = fabs(before) + 100 * (load + 0.002 * COLUMNS * ROWS), dt = steps[scene % 4];
        ok(cd_membrane_get_momentum(m, p[0], 3));
        for (int n = 0; n < 100; ++n) {
            ok(cd_membrane_step(m, dt, 1));
            const double now = sheet_energy(m);
            most = fmax(most, (now - before) / scale);
            before = now;
        }
        ok(cd_membrane_get_momentum(m, p[1], 3));
        const double mass = load + 0.002 * (COLUMNS * COLUMNS + ROPE - 1), falls = mass * kGravity * 100 * dt;
        for (int k = 0; k < 3 && !held; ++k)
            drift = fmax(drift, fabs(p[1][k] - p[0][k] + (k == 2 ? falls : 0)) / (mass * (4 + kGravity * 100 * dt)));
        cd_membrane_destroy(m);
    }
    print_message("loads on ropes on cloth: energy rises by %.1e of its scale at most, momentum is kept to %.1e\n",
                  most, drift);
    assert_true(most < 1e-12);
    assert_true(drift < 1e-12);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_rope_pulls_by_what_hangs_on_it),
        cmocka_unit_test(a_load_on_a_rope_makes_no_energy),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
