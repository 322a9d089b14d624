/* What every method keeps: momentum, superposition, and that rigid and linear shapes feel no force. */
#include <math.h>
#include <stdlib.h>

#include "check.h"
#include "modes.h"
#include "reference.h"

enum { NODES = 60, COMPONENTS = 2, NUMBERS = NODES * COMPONENTS };

static void fill(double* values, size_t count, uint64_t seed) {
    for (size_t i = 0; i < count; ++i) values[i] = random_number(&seed);
}

static void write_state(cd_chain* chain, const double* x, const double* v) {
    ok(cd_chain_write_f64(chain, CD_POSITION, 0, 1, 0, NODES, x, NUMBERS));
    ok(cd_chain_write_f64(chain, CD_VELOCITY, 0, 1, 0, NODES, v, NUMBERS));
}

static void read_state(const cd_chain* chain, double* x, double* v) {
    ok(cd_chain_read_f64(chain, CD_POSITION, 0, 1, 0, NODES, x, NUMBERS));
    ok(cd_chain_read_f64(chain, CD_VELOCITY, 0, 1, 0, NODES, v, NUMBERS));
}

/* ---- momentum ---------------------------------------------------------------------------------------------------- */

enum kind { PLAIN, RANDOM, WELDED_AND_CUT, STIFF, RING_KIND, BENT, BENT_RING, DAMPED, KINDS };
static const char* const kind_names[KINDS] = {"plain", "random", "welds and cuts", "stiff",
                                              "ring",  "bend",   "ring with bend", "stiffness damping"};

/* Returns a step that the method can take. */
static double make_free(enum kind kind, cd_precision precision, const struct time_step* step, cd_chain** out_chain) {
    cd_chain* chain = NULL;
    double values[NUMBERS], x[NUMBERS], v[NUMBERS];
    ok(cd_chain_create(1, NODES - 1, COMPONENTS, precision, NULL, &chain));
    set_time_step(chain, step);
    if (kind == RING_KIND || kind == BENT_RING) ok(cd_chain_set_ring(chain, 1));
    if (kind == BENT || kind == BENT_RING) ok(cd_chain_set_bend(chain, 0.01));
    if (kind == STIFF) ok(cd_chain_set_stiffness(chain, 1e12));
    if (kind == DAMPED) ok(cd_chain_set_stiffness_damping(chain, 1e-3));
    fill(x, NUMBERS, 1);
    fill(v, NUMBERS, 2);
    for (size_t i = 0; i < NUMBERS; ++i) v[i] += 0.5;
    write_state(chain, x, v);
    if (kind == RANDOM) {
        fill(values, NODES, 3);
        for (size_t i = 0; i < NODES; ++i) values[i] = exp(2 * values[i]);
        ok(cd_chain_enable_field(chain, CD_MASS));
        ok(cd_chain_write_f64(chain, CD_MASS, 0, 1, 0, NODES, values, NODES));
        fill(values, NODES, 4);
        for (size_t i = 0; i < NODES; ++i) values[i] = exp(5 * values[i]);
        ok(cd_chain_enable_field(chain, CD_STIFFNESS));
        ok(cd_chain_write_f64(chain, CD_STIFFNESS, 0, 1, 0, NODES - 1, values, NODES - 1));
    }
    double dt = 1.0 / 60;
    if (step->is_explicit || step->grows) {
        ok(cd_chain_stable_dt(chain, &dt));
        dt *= step->grows ? 0.03 : 0.9;
    }
    *out_chain = chain;
    return dt;
}

/* Largest change over what there is of it in all nodes, whichever way they move. */
static double momentum_change(enum kind kind, cd_precision precision, const struct time_step* step) {
    cd_chain* chain;
    const double dt = make_free(kind, precision, step, &chain);
    double before[COMPONENTS], after[COMPONENTS], mass[NODES], x[NUMBERS], v[NUMBERS], change = 0, size = 0;
    ok(cd_chain_enable_field(chain, CD_MASS));
    ok(cd_chain_read_f64(chain, CD_MASS, 0, 1, 0, NODES, mass, NODES));
    ok(cd_chain_get_momentum(chain, before, COMPONENTS));
    for (size_t k = 0; k < 10; ++k) {
        /* every now and then something is welded and something cut */
        if (kind == WELDED_AND_CUT) {
            ok(cd_chain_weld(chain, 0, 5 * k + 2));
            if (k % 3 == 0) ok(cd_chain_weld(chain, 0, 5 * k + 3));
            ok(cd_chain_cut(chain, 0, 4 * k + 1));
        }
        ok(cd_chain_step(chain, dt, 200));
        ok(cd_chain_get_momentum(chain, after, COMPONENTS));
        read_state(chain, x, v);
        for (size_t c = 0; c < COMPONENTS; ++c) {
            double all = 0;
            for (size_t i = 0; i < NODES; ++i) all += mass[i] * fabs(v[i * COMPONENTS + c]);
            size = fmax(size, all);
            change = fmax(change, fabs(after[c] - before[c]));
        }
    }
    cd_chain_destroy(chain);
    return change / size;
}

static void free_chains_keep_their_momentum(void** state) {
    (void)state;
    for (int kind = 0; kind < KINDS; ++kind) {
        double worst[2] = {0, 0};
        for (int p = 0; p < 2; ++p)
            for (size_t m = 0; m < TIME_STEPS; ++m) {
                const double change = momentum_change((enum kind)kind, p ? CD_FLOAT64 : CD_FLOAT32, &time_steps[m]);
                if (!(change <= (p ? 1e-12 : 1e-5)))
                    print_message("%s, %s: %.2e\n", kind_names[kind], time_steps[m].name, change);
                worst[p] = fmax(worst[p], change);
            }
        print_message("%-18s momentum changes in 2000 steps by %.1e in float32, %.1e in float64\n", kind_names[kind],
                      worst[0], worst[1]);
        assert_true(worst[0] <= 1e-5);
        assert_true(worst[1] <= 1e-12);
    }
}

/* ---- linearity --------------------------------------------------------------------------------------------------- */

/* A chain with something of everything that acts on a chain linearly. */
static cd_chain* make_rich(const struct time_step* step, int with_bend) {
    cd_chain* chain = NULL;
    ok(cd_chain_create(1, NODES - 1, COMPONENTS, CD_FLOAT64, NULL, &chain));
    set_time_step(chain, step);
    if (with_bend) ok(cd_chain_set_bend(chain, 1e-4));
    ok(cd_chain_set_drag(chain, 0.2));
    ok(cd_chain_set_stiffness_damping(chain, 1e-4));
    ok(cd_chain_set_end(chain, CD_END_LAST, CD_NODE_PINNED));
    ok(cd_chain_enable_field(chain, CD_FORCE));
    const double target[COMPONENTS] = {0, 0};
    ok(cd_chain_attach(chain, 0, 20, 3, 0.1, target, COMPONENTS));
    ok(cd_chain_weld(chain, 0, 30));
    ok(cd_chain_cut(chain, 0, 40));
    return chain;
}

static void run_rich(const struct time_step* step, int with_bend, const double* x0, const double* v0, const double* f,
                     double* x, double* v) {
    cd_chain* chain = make_rich(step, with_bend);
    double dt;
    ok(cd_chain_stable_dt(chain, &dt));
    write_state(chain, x0, v0);
    ok(cd_chain_write_f64(chain, CD_FORCE, 0, 1, 0, NODES, f, NUMBERS));
    ok(cd_chain_step(chain, (step->is_explicit || step->grows ? 0.1 : 4) * dt, 500));
    read_state(chain, x, v);
    cd_chain_destroy(chain);
}

static void motions_add_up(void** state) {
    (void)state;
    double worst = 0;
    for (int bend = 0; bend < 2; ++bend)
        for (size_t m = 0; m < TIME_STEPS; ++m) {
            double x0[3][NUMBERS], v0[3][NUMBERS], f[3][NUMBERS], x[3][NUMBERS], v[3][NUMBERS];
            for (size_t k = 0; k < 2; ++k) {
                fill(x0[k], NUMBERS, 10 + k);
                fill(v0[k], NUMBERS, 20 + k);
                fill(f[k], NUMBERS, 30 + k);
                for (size_t c = 0; c < COMPONENTS; ++c) {
                    v0[k][NUMBERS - 1 - c] = 0;
                    v0[k][31 * COMPONENTS + c] = v0[k][30 * COMPONENTS + c];
                }
            }
            for (size_t i = 0; i < NUMBERS; ++i) {
                x0[2][i] = 2 * x0[0][i] - 3 * x0[1][i];
                v0[2][i] = 2 * v0[0][i] - 3 * v0[1][i];
                f[2][i] = 2 * f[0][i] - 3 * f[1][i];
            }
            for (size_t k = 0; k < 3; ++k) run_rich(&time_steps[m], bend, x0[k], v0[k], f[k], x[k], v[k]);
            double size_x = 0, size_v = 0, error_x = 0, error_v = 0;
            for (size_t i = 0; i < NUMBERS; ++i) {
                size_x = fmax(size_x, fabs(x[2][i]));
                size_v = fmax(size_v, fabs(v[2][i]));
                error_x = fmax(error_x, fabs(x[2][i] - 2 * x[0][i] + 3 * x[1][i]));
                error_v = fmax(error_v, fabs(v[2][i] - 2 * v[0][i] + 3 * v[1][i]));
            }
            worst = fmax(worst, fmax(error_x / size_x, error_v / size_v));
        }
    print_message("superposition holds to %.1e\n", worst);
    assert_true(worst <= 1e-10);
}

/* ---- what feels no force ----------------------------------------------------------------------------------------- */

/* Positions and velocities are multiples of 1/8 and dt of 1/64, so that nothing is rounded before the first force.
 * Where `allowed`, of positions over dt, is 0, velocities stay bit for bit. */
static void check_forceless(cd_chain* chain, double slope, const struct time_step* step, double allowed) {
    const double dt = 1.0 / 64;
    double x0[NUMBERS], v0[NUMBERS], x[NUMBERS], v[NUMBERS], elastic;
    for (size_t i = 0; i < NODES; ++i)
        for (size_t c = 0; c < COMPONENTS; ++c) {
            x0[i * COMPONENTS + c] = 1024 - 100 * (double)c + slope * (double)i;
            v0[i * COMPONENTS + c] = 0.75 + (double)c - slope / 2 * (double)i;
        }
    set_time_step(chain, step);
    write_state(chain, x0, v0);
    ok(cd_chain_step(chain, dt, 256));
    read_state(chain, x, v);
    for (size_t i = 0; i < NUMBERS; ++i) {
        const double exact = x0[i] + 256 * dt * v0[i];
        if (fabs(v[i] - v0[i]) > allowed * 1024 / dt || fabs(x[i] - exact) > allowed * 1024)
            print_message("%s: velocity off by %.1e, position by %.1e\n", step->name, v[i] - v0[i], x[i] - exact);
        assert_true(fabs(v[i] - v0[i]) <= allowed * 1024 / dt);
        assert_true(fabs(x[i] - exact) <= allowed * 1024);
    }
    ok(cd_chain_get_energy(chain, NULL, &elastic, NULL));
    if (allowed == 0) assert_true(elastic == 0);
    cd_chain_destroy(chain);
}

/* All nodes at one place: whatever is rounded is rounded alike. */
static void a_shifted_chain_feels_no_force(void** state) {
    (void)state;
    for (int p = 0; p < 2; ++p)
        for (int ring = 0; ring < 2; ++ring)
            for (int bend = 0; bend < 2; ++bend)
                for (size_t m = 0; m < TIME_STEPS; ++m) {
                    cd_chain* chain = NULL;
                    ok(cd_chain_create(1, NODES - 1, COMPONENTS, p ? CD_FLOAT64 : CD_FLOAT32, NULL, &chain));
                    ok(cd_chain_set_ring(chain, ring));
                    if (bend) ok(cd_chain_set_bend(chain, 0.1));
                    ok(cd_chain_set_stiffness(chain, 1e9));
                    /* the stages of the stiff step lie at irrational times */
                    const double rounding = m == STIFF_SECOND ? (p ? 1e-13 : 1e-4) : 0;
                    check_forceless(chain, 0, &time_steps[m], rounding);
                }
}

/* Explicit steps see differences that are 0; the rod's elimination and the stiff step's stages round. */
static void a_straight_rod_feels_no_bend(void** state) {
    (void)state;
    for (int p = 0; p < 2; ++p)
        for (size_t m = 0; m < TIME_STEPS; ++m) {
            cd_chain* chain = NULL;
            ok(cd_chain_create(1, NODES - 1, COMPONENTS, p ? CD_FLOAT64 : CD_FLOAT32, NULL, &chain));
            ok(cd_chain_set_stiffness(chain, 0));
            ok(cd_chain_set_bend(chain, 1e6));
            check_forceless(chain, 0.25, &time_steps[m], m <= LAMBDA_0 ? 0 : p ? 1e-13 : 1e-6);
        }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(free_chains_keep_their_momentum),
        cmocka_unit_test(motions_add_up),
        cmocka_unit_test(a_shifted_chain_feels_no_force),
        cmocka_unit_test(a_straight_rod_feels_no_bend),
    };
    return cmocka_run_group_tests_name("invariants", tests, NULL, NULL);
}
