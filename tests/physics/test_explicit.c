/* Explicit steps of uniform lattices compute in the state's own precision, where a rate or a dt that was rounded once
 * would make every wave a little too slow or too fast, more in every step. */
#include <math.h>

#include "check.h"
#include "reference.h"

enum { COLUMNS = 64, ROWS = 48, LENGTH = 301 };

static double bump(double x, double width) { return 0.1 * exp(-x * x / (width * width)); }

static double rms(const double* a, const double* b, size_t count) {
    double sum = 0;
    for (size_t i = 0; i < count; ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
    return sqrt(sum / (double)count);
}

/* Positions of a drum in each precision after many steps from the same start. */
static void drum(cd_precision precision, double stiffness, double* x) {
    cd_membrane* m;
    double dt;
    for (int v = 0; v < ROWS; ++v)
        for (int u = 0; u < COLUMNS; ++u)
            x[v * COLUMNS + u] = (float)(0.4 * sin(acos(-1) * u / (COLUMNS - 1)) * sin(acos(-1) * v / (ROWS - 1)) +
                                         bump(hypot(u - 20, v - 30), 4));
    ok(cd_membrane_create(COLUMNS - 1, ROWS - 1, 1, precision, NULL, &m));
    ok(cd_membrane_set_solver(m, CD_SOLVER_ALTERNATING));
    ok(cd_membrane_set_method(m, CD_METHOD_SYMPLECTIC_EULER));
    ok(cd_membrane_set_stiffness(m, stiffness, 0.7));
    for (cd_edge edge = CD_EDGE_U_FIRST; edge <= CD_EDGE_V_LAST; ++edge)
        ok(cd_membrane_set_edge(m, edge, CD_NODE_PINNED));
    ok(cd_membrane_write_f64(m, CD_POSITION, 0, 0, COLUMNS, ROWS, x, COLUMNS * ROWS));
    ok(cd_membrane_stable_dt(m, &dt));
    ok(cd_membrane_step(m, 0.45 * dt, 300000));
    ok(cd_membrane_read_f64(m, CD_POSITION, 0, 0, COLUMNS, ROWS, x, COLUMNS * ROWS));
    cd_membrane_destroy(m);
}

static void a_drum_in_float_keeps_its_frequencies(void** state) {
    (void)state;
    static double exact[COLUMNS * ROWS], rounded[COLUMNS * ROWS];
    for (int k = 0; k < 3; ++k) {
        drum(CD_FLOAT64, 1.4 + 0.1 * k, exact);
        drum(CD_FLOAT32, 1.4 + 0.1 * k, rounded);
        print_message("off by %.2e\n", rms(exact, rounded, COLUMNS * ROWS));
        assert_true(rms(exact, rounded, COLUMNS * ROWS) < 3e-6);
    }
}

/* A string between two pinned ends; of many strands the last. */
static void string(cd_precision precision, size_t strands, double stiffness, double* x) {
    cd_chain* c;
    double dt;
    ok(cd_chain_create(strands, LENGTH - 1, 1, precision, NULL, &c));
    ok(cd_chain_set_method(c, CD_METHOD_SYMPLECTIC_EULER));
    ok(cd_chain_set_stiffness(c, stiffness));
    for (cd_end end = CD_END_FIRST; end <= CD_END_LAST; ++end) ok(cd_chain_set_end(c, end, CD_NODE_PINNED));
    for (int i = 0; i < LENGTH; ++i)
        x[i] = (float)(0.4 * sin(acos(-1) * i / (LENGTH - 1)) + (i > 0 && i < LENGTH - 1 ? bump(i - 90, 20) : 0));
    for (size_t s = 0; s < strands; ++s) ok(cd_chain_write_f64(c, CD_POSITION, s, 1, 0, LENGTH, x, LENGTH));
    ok(cd_chain_stable_dt(c, &dt));
    ok(cd_chain_step(c, 0.45 * dt, 300000));
    ok(cd_chain_read_f64(c, CD_POSITION, strands - 1, 1, 0, LENGTH, x, LENGTH));
    cd_chain_destroy(c);
}

static void a_string_in_float_keeps_its_frequencies(void** state) {
    (void)state;
    double exact[LENGTH], rounded[LENGTH], beside[LENGTH];
    for (int k = 0; k < 3; ++k) {
        string(CD_FLOAT64, 1, 1.4 + 0.1 * k, exact);
        string(CD_FLOAT32, 1, 1.4 + 0.1 * k, rounded);
        print_message("off by %.2e\n", rms(exact, rounded, LENGTH));
        assert_true(rms(exact, rounded, LENGTH) < 6e-6);
    }
    string(CD_FLOAT32, 5, 1.6, beside);
    assert_memory_equal(beside, rounded, sizeof rounded);
}

/* Where rates or steps leave the range of float, steps are those of double, rounded at their end. */
static void any_stiffness_and_step_do_in_float(void** state) {
    (void)state;
    static const double scales[] = {1e-30, 1e-12, 1e-6, 1, 1e6, 1e12, 1e30};
    double x[2][LENGTH];
    for (size_t s = 0; s < COUNT(scales); ++s) {
        for (cd_precision precision = CD_FLOAT32; precision <= CD_FLOAT64; ++precision) {
            cd_chain* c;
            double dt, *const now = x[precision == CD_FLOAT64];
            ok(cd_chain_create(1, LENGTH - 1, 1, precision, NULL, &c));
            ok(cd_chain_set_method(c, CD_METHOD_SYMPLECTIC_EULER));
            ok(cd_chain_set_stiffness(c, scales[s]));
            for (int i = 0; i < LENGTH; ++i) now[i] = (float)bump(i - 90, 20);
            ok(cd_chain_write_f64(c, CD_POSITION, 0, 1, 0, LENGTH, now, LENGTH));
            ok(cd_chain_stable_dt(c, &dt));
            ok(cd_chain_step(c, 0.45 * dt, 1000));
            ok(cd_chain_read_f64(c, CD_POSITION, 0, 1, 0, LENGTH, now, LENGTH));
            cd_chain_destroy(c);
        }
        print_message("stiffness %g: off by %.2e\n", scales[s], rms(x[0], x[1], LENGTH));
        assert_true(rms(x[0], x[1], LENGTH) < 1e-7);
    }
}

/* Rates (stiffness over mass) that no float holds, of positions so small that velocities are floats again. */
static void rates_beyond_floats_do_too(void** state) {
    (void)state;
    enum { NODES = 9 };
    for (int way = 0; way < 2; ++way) {
        double x[NODES], v[2][NODES];
        for (cd_precision precision = CD_FLOAT32; precision <= CD_FLOAT64; ++precision) {
            cd_chain* c;
            ok(cd_chain_create(1, NODES - 1, 1, precision, NULL, &c));
            ok(cd_chain_set_method(c, CD_METHOD_SYMPLECTIC_EULER));
            ok(cd_chain_set_stiffness(c, way ? 1e-50 : 1e50));
            for (int i = 0; i < NODES; ++i) x[i] = (float)((way ? 1e30 : 1e-20) * i * i);
            ok(cd_chain_write_f64(c, CD_POSITION, 0, 1, 0, NODES, x, NODES));
            ok(cd_chain_step(c, way ? 1e6 : 1e-3, 1));
            ok(cd_chain_read_f64(c, CD_VELOCITY, 0, 1, 0, NODES, v[precision == CD_FLOAT64], NODES));
            cd_chain_destroy(c);
        }
        for (int i = 0; i < NODES; ++i) assert_near(v[0][i], v[1][i], 1e-6, 0);
    }
}

/* A sheet after some steps from a random start; with masses of their own, though alike, its nodes go another way. */
static void sheet(int columns, int rows, unsigned kind, cd_precision precision, int own_masses, double* x) {
    const size_t count = (size_t)columns * (size_t)rows;
    const double gravity = 0.3;
    uint64_t seed = 7;
    cd_membrane* m;
    double dt;
    ok(cd_membrane_create((size_t)columns - 1, (size_t)rows - 1, 1, precision, NULL, &m));
    ok(cd_membrane_set_solver(m, CD_SOLVER_ALTERNATING));
    ok(cd_membrane_set_method(m, CD_METHOD_SYMPLECTIC_EULER));
    ok(cd_membrane_set_stiffness(m, 1.3, 0.7));
    ok(cd_membrane_set_gravity(m, &gravity, 1));
    if (kind & 1) ok(cd_membrane_set_mass_rule(m, CD_MASS_HALF_ENDS));
    if (kind & 2) ok(cd_membrane_set_edge(m, CD_EDGE_U_LAST, CD_NODE_PINNED));
    if (kind & 4) ok(cd_membrane_set_edge(m, CD_EDGE_V_FIRST, CD_NODE_PINNED));
    if (kind & 8) ok(cd_membrane_set_ring(m, columns > 2 && !(kind & 2), rows > 2 && !(kind & 4)));
    for (size_t i = 0; i < count; ++i) x[i] = (float)random_number(&seed);
    ok(cd_membrane_write_f64(m, CD_POSITION, 0, 0, (size_t)columns, (size_t)rows, x, count));
    ok(cd_membrane_stable_dt(m, &dt));
    if (own_masses) ok(cd_membrane_enable_field(m, CD_MASS));
    ok(cd_membrane_step(m, isinf(dt) ? 0.01 : 0.45 * dt, 5));
    ok(cd_membrane_read_f64(m, CD_POSITION, 0, 0, (size_t)columns, (size_t)rows, x, count));
    cd_membrane_destroy(m);
}

static void a_uniform_sheet_of_any_shape_is_the_one_with_masses_of_its_own(void** state) {
    (void)state;
    static const int columns[] = {1, 2, 3, 5, 15, 16, 17, 18, 24, 31, 32, 33, 40, 47, 100}, rows[] = {1, 2, 3, 9};
    double x[2][100 * 9];
    for (cd_precision precision = CD_FLOAT32; precision <= CD_FLOAT64; ++precision)
        for (unsigned kind = 0; kind < 16; ++kind)
            for (size_t c = 0; c < COUNT(columns); ++c)
                for (size_t r = 0; r < COUNT(rows); ++r) {
                    const size_t count = (size_t)columns[c] * (size_t)rows[r];
                    sheet(columns[c], rows[r], kind, precision, 0, x[0]);
                    sheet(columns[c], rows[r], kind, precision, 1, x[1]);
                    for (size_t i = 0; i < count; ++i)
                        assert_near(x[0][i], x[1][i], precision == CD_FLOAT64 ? 1e-14 : 5e-7, 1);
                }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_drum_in_float_keeps_its_frequencies),
        cmocka_unit_test(a_string_in_float_keeps_its_frequencies),
        cmocka_unit_test(a_uniform_sheet_of_any_shape_is_the_one_with_masses_of_its_own),
        cmocka_unit_test(any_stiffness_and_step_do_in_float),
        cmocka_unit_test(rates_beyond_floats_do_too),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
