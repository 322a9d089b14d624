/* lambda = 1/2 keeps energy over a million steps, and runs backwards. */
#include <math.h>
#include <stdlib.h>

#include "check.h"
#include "modes.h"
#include "reference.h"

enum { NODES = 10, STEPS = 1000000, SAMPLES = 2000 };

/* Small chains of every kind, all of them without damping. Those that nothing holds stay where they are: a chain that
 * drifts to 1e6 has positions, and so stretches, known to 1e6 roundings only. */
enum kind { FREE, PINNED, HANGING, RANDOM, CLOSED, BENT, WELDED, TIED, KINDS };
static const char* const kind_names[KINDS] = {"free", "both ends pinned", "hanging", "random masses and springs",
                                              "ring", "with bend",        "with welds and a cut",
                                              "tied to a target"};

static void stop_drift(cd_chain* chain, size_t first, size_t count) {
    double v[NODES], mass[NODES], momentum = 0, total = 0;
    ok(cd_chain_enable_field(chain, CD_MASS));
    ok(cd_chain_read_f64(chain, CD_MASS, 0, 1, first, count, mass, count));
    ok(cd_chain_read_f64(chain, CD_VELOCITY, 0, 1, first, count, v, count));
    for (size_t i = 0; i < count; ++i) momentum += mass[i] * v[i], total += mass[i];
    for (size_t i = 0; i < count; ++i) v[i] -= momentum / total;
    ok(cd_chain_write_f64(chain, CD_VELOCITY, 0, 1, first, count, v, count));
}

static cd_chain* make(enum kind kind, cd_precision precision) {
    cd_chain* chain = NULL;
    double x[NODES], v[NODES], values[NODES];
    uint64_t seed = 100 + (uint64_t)kind;
    for (size_t i = 0; i < NODES; ++i) x[i] = random_number(&seed), v[i] = random_number(&seed);
    ok(cd_chain_create(1, NODES - 1, 1, precision, NULL, &chain));
    ok(cd_chain_set_stiffness(chain, 2));
    if (kind == CLOSED) ok(cd_chain_set_ring(chain, 1));
    if (kind == BENT) ok(cd_chain_set_bend(chain, 0.01));
    if (kind == PINNED || kind == HANGING) {
        ok(cd_chain_set_end(chain, CD_END_FIRST, CD_NODE_PINNED));
        v[0] = 0;
    }
    if (kind == PINNED) {
        ok(cd_chain_set_end(chain, CD_END_LAST, CD_NODE_PINNED));
        v[NODES - 1] = 0;
    }
    const double down = -9.81;
    if (kind == HANGING) ok(cd_chain_set_gravity(chain, &down, 1));
    if (kind == RANDOM) {
        ok(cd_chain_enable_field(chain, CD_MASS));
        ok(cd_chain_enable_field(chain, CD_STIFFNESS));
        for (size_t i = 0; i < NODES; ++i) values[i] = exp(random_number(&seed));
        ok(cd_chain_write_f64(chain, CD_MASS, 0, 1, 0, NODES, values, NODES));
        for (size_t i = 0; i < NODES; ++i) values[i] = exp(4 * random_number(&seed));
        ok(cd_chain_write_f64(chain, CD_STIFFNESS, 0, 1, 0, NODES - 1, values, NODES - 1));
    }
    ok(cd_chain_write_f64(chain, CD_POSITION, 0, 1, 0, NODES, x, NODES));
    ok(cd_chain_write_f64(chain, CD_VELOCITY, 0, 1, 0, NODES, v, NODES));
    if (kind == WELDED) {
        ok(cd_chain_weld(chain, 0, 2));
        ok(cd_chain_weld(chain, 0, 3));
        ok(cd_chain_weld(chain, 0, 7));
        ok(cd_chain_cut(chain, 0, 5));
        stop_drift(chain, 0, 6);
        stop_drift(chain, 6, NODES - 6);
    }
    if (kind == FREE || kind == RANDOM || kind == CLOSED || kind == BENT) stop_drift(chain, 0, NODES);
    const double target = 0.5;
    if (kind == TIED) ok(cd_chain_attach(chain, 0, 3, 7, 0, &target, 1));
    return chain;
}

static double energy_of(const cd_chain* chain) {
    double kinetic, elastic, gravity;
    ok(cd_chain_get_energy(chain, &kinetic, &elastic, &gravity));
    return kinetic + elastic + gravity;
}

/* Largest kinetic + elastic energy is what the errors are relative to: with gravity the sum may pass through 0. */
static double size_of_energy(const cd_chain* chain) {
    double kinetic, elastic, gravity;
    ok(cd_chain_get_energy(chain, &kinetic, &elastic, &gravity));
    return kinetic + elastic + fabs(gravity);
}

struct record {
    double largest;     /* |E - E0| / size */
    double first, last; /* mean of (E - E0) / size over the first and the last tenth */
    double slope;       /* of the line fitted to (E - E0) / size, over the whole run */
};

static struct record run(cd_chain* chain, double dt) {
    static double e[SAMPLES];
    const double start = energy_of(chain), size = size_of_energy(chain);
    struct record r = {0, 0, 0, 0};
    double sum_te = 0, sum_tt = 0, sum_e = 0;
    for (int k = 0; k < SAMPLES; ++k) {
        ok(cd_chain_step(chain, dt, STEPS / SAMPLES));
        e[k] = (energy_of(chain) - start) / size;
        r.largest = fmax(r.largest, fabs(e[k]));
        if (k < SAMPLES / 10) r.first += e[k] / (SAMPLES / 10);
        if (k >= SAMPLES - SAMPLES / 10) r.last += e[k] / (SAMPLES / 10);
        sum_e += e[k] / SAMPLES;
    }
    for (int k = 0; k < SAMPLES; ++k) {
        const double t = (k + 0.5) / SAMPLES - 0.5;
        sum_te += t * (e[k] - sum_e);
        sum_tt += t * t;
    }
    r.slope = sum_te / sum_tt;
    return r;
}

static void float64_keeps_energy_to_1e_9_over_a_million_steps(void** state) {
    (void)state;
    static const double dts[] = {0.02, 1};
    for (int kind = 0; kind < KINDS; ++kind)
        for (size_t d = 0; d < COUNT(dts); ++d) {
            cd_chain* chain = make((enum kind)kind, CD_FLOAT64);
            const struct record r = run(chain, dts[d]);
            print_message("float64 %-26s dt %-4g: energy within %.1e, fitted drift %+.1e\n", kind_names[kind], dts[d],
                          r.largest, r.slope);
            assert_true(r.largest <= 1e-9);
            cd_chain_destroy(chain);
        }
}

static void float32_keeps_energy_without_a_trend_over_a_million_steps(void** state) {
    (void)state;
    for (int kind = 0; kind < KINDS; ++kind) {
        cd_chain* chain = make((enum kind)kind, CD_FLOAT32);
        const struct record r = run(chain, 0.02);
        print_message("float32 %-26s energy within %.1e, first tenth %+.1e, last tenth %+.1e, fitted drift %+.1e\n",
                      kind_names[kind], r.largest, r.first, r.last, r.slope);
        assert_true(r.largest <= 5e-4);
        assert_true(fabs(r.last - r.first) <= 2e-4);
        assert_true(fabs(r.slope) <= 2e-4);
        cd_chain_destroy(chain);
    }
}

/* A step of -dt is no input, but a chain whose velocities are turned around runs back to where it started. A
 * rounding of the velocities shifts a free chain by as much times the time that passes: no long steps for float32. */
static void turning_the_velocities_around_leads_back_to_the_start(void** state) {
    (void)state;
    static const double dts[] = {0.02, 0.5, 30};
    for (int kind = 0; kind < KINDS; ++kind)
        for (size_t d = 0; d < COUNT(dts); ++d)
            for (int p = dts[d] > 0.1; p < 2; ++p) {
                cd_chain* chain = make((enum kind)kind, p ? CD_FLOAT64 : CD_FLOAT32);
                double x0[NODES], v0[NODES], x[NODES], v[NODES], size_x = 0, size_v = 0, far = 0, error = 0;
                ok(cd_chain_read_f64(chain, CD_POSITION, 0, 1, 0, NODES, x0, NODES));
                ok(cd_chain_read_f64(chain, CD_VELOCITY, 0, 1, 0, NODES, v0, NODES));
                for (int way = 0; way < 2; ++way) {
                    ok(cd_chain_step(chain, dts[d], 1000));
                    ok(cd_chain_read_f64(chain, CD_POSITION, 0, 1, 0, NODES, x, NODES));
                    ok(cd_chain_read_f64(chain, CD_VELOCITY, 0, 1, 0, NODES, v, NODES));
                    for (size_t i = 0; i < NODES; ++i) {
                        if (way == 0) far = fmax(far, fabs(x[i] - x0[i]));
                        size_x = fmax(size_x, fabs(x[i]));
                        size_v = fmax(size_v, fabs(v[i]));
                        v[i] = -v[i];
                    }
                    ok(cd_chain_write_f64(chain, CD_VELOCITY, 0, 1, 0, NODES, v, NODES));
                }
                for (size_t i = 0; i < NODES; ++i)
                    error = fmax(error, fmax(fabs(x[i] - x0[i]) / size_x, fabs(v[i] - v0[i]) / size_v));
                print_message("float%d %-26s dt %-4g: back to %.1e\n", p ? 64 : 32, kind_names[kind], dts[d], error);
                assert_true(far > 0.1);
                assert_true(error <= (p ? 1e-9 : 1e-3));
                cd_chain_destroy(chain);
            }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(float64_keeps_energy_to_1e_9_over_a_million_steps),
        cmocka_unit_test(float32_keeps_energy_without_a_trend_over_a_million_steps),
        cmocka_unit_test(turning_the_velocities_around_leads_back_to_the_start),
    };
    return cmocka_run_group_tests_name("energy", tests, NULL, NULL);
}
