/* A sheet that nothing holds moves as a whole by what acts on it from outside, however stiff its springs are: its mean
 * motion is that of one body, and its energy is kept, though the springs' forces are rounded. */
#include <math.h>
#include <stdlib.h>

#include "check.h"
#include "sheet.h"

enum { COLUMNS = 9, ROWS = 7, NODES = COLUMNS * ROWS, SPLIT = 4, STEPS = 50 };

struct kind {
    const char* name;
    int ring[2], half_ends, varied_masses, varied_springs, is_cut, is_masked;
    double along_v, bend, damping; /* stiffness along v over that along u */
};
static const struct kind kinds[] = {
    {.name = "plain", .along_v = 1},
    {.name = "half masses at the edges", .half_ends = 1, .along_v = 1},
    {.name = "ring along u", .ring = {1, 0}, .along_v = 1},
    {.name = "ring along v", .ring = {0, 1}, .along_v = 1},
    {.name = "rings", .ring = {1, 1}, .along_v = 1},
    {.name = "soft along v", .along_v = 1e-9},
    {.name = "no springs along v", .along_v = 0},
    {.name = "damped springs", .along_v = 1, .damping = 0.3},
    {.name = "masses vary", .varied_masses = 1, .along_v = 1},
    {.name = "springs vary", .varied_springs = 1, .along_v = 1},
    {.name = "cut in two", .is_cut = 1, .along_v = 1},
    {.name = "a node is missing", .is_masked = 1, .along_v = 1},
    {.name = "bend", .along_v = 1, .bend = 0.3},
    {.name = "bend, rings", .ring = {1, 1}, .along_v = 1, .bend = 0.3},
    {.name = "bend, ring along u", .ring = {1, 0}, .along_v = 1, .bend = 0.3},
};

static double wave(size_t i) { return sin((double)(i * i)); }
static int is_first_part(const struct kind* k, size_t node) { return !k->is_cut || node % COLUMNS < SPLIT; }
static int is_there(const struct kind* k, size_t node) { return !k->is_masked || node != 20; }

/* ratio: stiffness over mass; masses, out: of the nodes */
static cd_membrane* make(const struct kind* k, cd_solver solver, cd_precision precision, double ratio, double* masses) {
    cd_membrane* m;
    double f[NODES];
    ok(cd_membrane_create(COLUMNS - 1, ROWS - 1, 1, precision, NULL, &m));
    ok(cd_membrane_set_solver(m, CD_SOLVER_ALTERNATING));
    if (k->half_ends) ok(cd_membrane_set_mass_rule(m, CD_MASS_HALF_ENDS));
    ok(cd_membrane_set_solver(m, solver));
    ok(cd_membrane_set_ring(m, k->ring[0], k->ring[1]));
    ok(cd_membrane_set_mass(m, 1));
    ok(cd_membrane_set_stiffness(m, ratio, ratio * k->along_v));
    ok(cd_membrane_set_stiffness_damping(m, k->damping));
    ok(cd_membrane_set_bend(m, ratio * k->bend));
    ok(cd_membrane_enable_field(m, CD_MASS));
    sheet_read(m, CD_MASS, masses);
    if (!k->varied_masses) ok(cd_membrane_disable_field(m, CD_MASS));
    for (size_t i = 0; i < NODES && k->varied_masses; ++i) masses[i] *= pow(10, 2 * wave(i));
    if (k->varied_masses) sheet_write(m, CD_MASS, masses);
    if (k->varied_springs || k->is_cut) {
        ok(cd_membrane_enable_field(m, CD_STIFFNESS_U));
        for (size_t v = 0; v < ROWS; ++v)
            for (size_t u = 0; u + 1 < COLUMNS; ++u)
                sheet_set(m, CD_STIFFNESS_U, u, v,
                          k->is_cut && u + 1 == SPLIT ? 0 : ratio * (k->varied_springs ? pow(10, 2 * wave(u + v)) : 1));
    }
    if (k->is_masked) {
        for (size_t i = 0; i < NODES; ++i) f[i] = is_there(k, i);
        ok(cd_membrane_enable_field(m, CD_MASK));
        sheet_write(m, CD_MASK, f);
    }
    for (size_t i = 0; i < NODES; ++i) f[i] = wave(i);
    sheet_write(m, CD_POSITION, f);
    return m;
}

/* Of the nodes of one part: by mass, of a field. */
static double mean(const struct kind* k, const cd_membrane* m, cd_field field, const double* masses, int part) {
    double values[NODES], sum = 0, whole = 0;
    sheet_read(m, field, values);
    for (size_t i = 0; i < NODES; ++i)
        if (is_first_part(k, i) == part && is_there(k, i)) sum += masses[i] * values[i], whole += masses[i];
    return sum / whole;
}

static void a_stiff_sheet_keeps_its_energy_and_its_place(void** state) {
    (void)state;
    static const double ratios[] = {1e5, 1e8, 1e12, 1e16, 1e20, 1e25, 1e30};
    double worst_gain[2] = {0}, worst_drift[2] = {0};
    for (size_t n = 0; n < COUNT(kinds); ++n)
        for (int solver = 0; solver < 2; ++solver)
            for (int p = 0; p < 2; ++p)
                for (size_t r = 0; r < COUNT(ratios); ++r) {
                    const struct kind* k = &kinds[n];
                    double masses[NODES];
                    if (!solver && ratios[r] > 1e20) continue; /* see cd_solver */
                    cd_membrane* m = make(k, solver, p ? CD_FLOAT64 : CD_FLOAT32, ratios[r], masses);
                    const double energy = sheet_swing_energy(m), place = mean(k, m, CD_POSITION, masses, 1);
                    double gain = 0, drift = 0;
                    for (int step = 0; step < STEPS; ++step) {
                        sheet_step(m, 1, 1);
                        gain = fmax(gain, sheet_swing_energy(m) / energy - 1);
                        drift = fmax(drift, fabs(mean(k, m, CD_POSITION, masses, 1) - place));
                    }
                    worst_gain[p] = fmax(worst_gain[p], gain), worst_drift[p] = fmax(worst_drift[p], drift);
                    if (!(gain <= (p ? 1e-6 : 1e-2)) || !(drift <= (p ? 1e-5 : 3e-3)))
                        fail_msg("%s, %s, float%d, stiffness over mass %.0e: energy gains %.3g, mean moves by %.3g",
                                 k->name, solver ? "coupled" : "alternating", p ? 64 : 32, ratios[r], gain, drift);
                    cd_membrane_destroy(m);
                }
    for (int p = 0; p < 2; ++p)
        print_message("float%d: energy gains at most %.1e, the mean moves by %.1e\n", p ? 64 : 32, worst_gain[p],
                      worst_drift[p]);
}

/* With gravity, drag, and other forces on each part; lambda 1/2: 2 w = v0 + v1, (1 + drag h / 2) w = v0 + a h / 2. */
static void a_stiff_sheet_falls_as_one_body(void** state) {
    (void)state;
    const double dt = 0.1, gravity = -9.81, drag = 0.2;
    for (size_t n = 0; n < COUNT(kinds); ++n)
        for (int solver = 0; solver < 2; ++solver)
            for (int by_force = 0; by_force < 2; ++by_force) {
                const struct kind* k = &kinds[n];
                double masses[NODES], force[NODES], total[2] = {0}, pushed[2] = {0}, speed[2] = {0};
                cd_membrane* m = make(k, solver, CD_FLOAT64, 1e16, masses);
                ok(cd_membrane_set_gravity(m, &gravity, 1));
                if (by_force) {
                    ok(cd_membrane_set_drag(m, drag));
                    ok(cd_membrane_enable_field(m, CD_FORCE));
                    for (size_t i = 0; i < NODES; ++i) force[i] = 1 + wave(i + 3);
                    sheet_write(m, CD_FORCE, force);
                }
                for (size_t i = 0; i < NODES; ++i) {
                    const int part = is_first_part(k, i);
                    if (!is_there(k, i)) continue;
                    total[part] += masses[i];
                    if (by_force) pushed[part] += force[i];
                }
                for (int step = 1; step <= STEPS; ++step) {
                    sheet_step(m, dt, 1);
                    for (int part = k->is_cut ? 0 : 1; part < 2; ++part) {
                        const double by = gravity + pushed[part] / total[part], resist = by_force ? drag : 0;
                        speed[part] = 2 * (speed[part] + by * dt / 2) / (1 + resist * dt / 2) - speed[part];
                        const double off = mean(k, m, CD_VELOCITY, masses, part) / speed[part] - 1;
                        if (!(fabs(off) <= 1e-6))
                            fail_msg("%s, %s, %s, step %d: part %d falls at %.9g times its speed", k->name,
                                     solver ? "coupled" : "alternating", by_force ? "forces" : "gravity", step, part,
                                     1 + off);
                    }
                }
                cd_membrane_destroy(m);
            }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_stiff_sheet_keeps_its_energy_and_its_place),
        cmocka_unit_test(a_stiff_sheet_falls_as_one_body),
    };
    return cmocka_run_group_tests_name("membrane afloat", tests, NULL, NULL);
}
