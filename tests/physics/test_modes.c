/* The state after 1000 steps equals the closed form of the lattice's mode, for every method and end condition. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "check.h"
#include "modes.h"

enum { STEPS = 1000, STRANDS = 2, COMPONENTS = 2, MODES = STRANDS * COMPONENTS };

struct worst {
    double error;
    char what[160];
};

/* How far dt goes, in units of 1 / omega_max. Explicit methods below their limit; those that grow, and the noise of the
 * fastest modes with them, so slowly that 1000 steps grow 150 times, in float32 3 times. */
static const double growing64[] = {0.1, 0}, growing32[] = {0.05, 0}, symplectic64[] = {0.3, 1.7, 0};
static const double symplectic32[] = {0.3, 1.2, 0}, implicit64[] = {0.3, 3, 50, 0}, implicit32[] = {0.3, 1, 0};

static const double* reaches_of(const struct time_step* step, cd_precision precision) {
    if (step->grows) return precision == CD_FLOAT32 ? growing32 : growing64;
    if (step->is_explicit) return precision == CD_FLOAT32 ? symplectic32 : symplectic64;
    return precision == CD_FLOAT32 ? implicit32 : implicit64;
}

/* Mode k of the four that ride in one object, from slow to fast. Rounding the start alone already makes errors: of
 * x, one of omega_max / omega times as much in v; of v, one of omega t times as much in x where nothing holds the
 * chain. Modes for which the two exceed 16 and 100 in float32, or 300 and 1e5 in float64, ask too much of their
 * numbers. */
static size_t mode_number(const struct lattice_chain* l, double dt, size_t k, cd_precision precision) {
    const long double fastest = lattice_omega_max(l), ratio = precision == CD_FLOAT32 ? 16 : 300;
    const long double turn = precision == CD_FLOAT32 ? 100 : 1e5L;
    size_t low = 1, high = lattice_last_mode(l);
    while (lattice_omega(l, low) * ratio < fastest) ++low;
    while (high > low && lattice_omega(l, high) * dt * STEPS > turn) --high;
    return low + (high - low) * k / (MODES - 1);
}

static void compare_one(const struct lattice_chain* l, const struct time_step* step, double dt, cd_precision precision,
                        struct worst* worst) {
    const size_t n = l->nodes, numbers = n * MODES;
    cd_chain* chain = make_lattice_chain(l, STRANDS, COMPONENTS, precision);
    set_time_step(chain, step);
    double* x = calloc(numbers, sizeof *x);
    double* v = calloc(numbers, sizeof *v);
    assert_non_null(x);
    assert_non_null(v);
    const long double x0[MODES] = {1, 0.25L, -0.5L, 0.125L}, v0[MODES] = {0.75L, -1, 0.5L, 0};
    for (size_t k = 0; k < MODES; ++k) {
        const size_t j = mode_number(l, dt, k, precision);
        const long double omega = lattice_omega(l, j);
        for (size_t i = 0; i < n; ++i) {
            const size_t at = (k / COMPONENTS * n + i) * COMPONENTS + k % COMPONENTS;
            x[at] = (double)(x0[k] * lattice_shape(l, j, i));
            v[at] = (double)(v0[k] * omega * lattice_shape(l, j, i));
        }
    }
    ok(cd_chain_write_f64(chain, CD_POSITION, 0, STRANDS, 0, n, x, numbers));
    ok(cd_chain_write_f64(chain, CD_VELOCITY, 0, STRANDS, 0, n, v, numbers));
    ok(cd_chain_step(chain, dt, STEPS));
    ok(cd_chain_read_f64(chain, CD_POSITION, 0, STRANDS, 0, n, x, numbers));
    ok(cd_chain_read_f64(chain, CD_VELOCITY, 0, STRANDS, 0, n, v, numbers));
    for (size_t k = 0; k < MODES; ++k) {
        const size_t j = mode_number(l, dt, k, precision);
        const long double omega = lattice_omega(l, j);
        const long double c = l->drag + l->stiffness_damping * omega * omega;
        const struct matrix2 g = matrix_power(step_matrix(step, dt, omega, c), STEPS);
        const long double xn = g.a[0][0] * x0[k] + g.a[0][1] * v0[k] * omega;
        const long double vn = g.a[1][0] * x0[k] + g.a[1][1] * v0[k] * omega;
        const long double size = fmaxl(hypotl(x0[k], v0[k]), hypotl(xn, vn / omega));
        long double error = 0;
        for (size_t i = 0; i < n; ++i) {
            const size_t at = (k / COMPONENTS * n + i) * COMPONENTS + k % COMPONENTS;
            const long double shape = lattice_shape(l, j, i);
            error = fmaxl(error, fabsl(x[at] - xn * shape) / size);
            error = fmaxl(error, fabsl(v[at] - vn * shape) / (omega * size));
        }
        if (!((double)error > worst->error) && error == error) continue;
        worst->error = (double)error;
        snprintf(worst->what, sizeof worst->what,
                 "%s, %zu nodes, mode %zu, omega_max dt = %.3g, drag dt = %.2g, damping / dt = %.2g", step->name, n, j,
                 (double)(lattice_omega_max(l) * dt), l->drag * dt, l->stiffness_damping / dt);
    }
    free(x);
    free(v);
    cd_chain_destroy(chain);
}

/* Without damping, with some of both kinds, and, where no limit forbids it, with so much that fast modes creep. */
static void compare_damped(struct lattice_chain l, const struct time_step* step, cd_precision precision,
                           struct worst* worst) {
    const double fastest = (double)lattice_omega_max(&l);
    for (const double* reach = reaches_of(step, precision); *reach > 0; ++reach) {
        const double dt = *reach / fastest;
        const struct {
            double drag, stiffness_damping;
        } dampings[] = {{0, 0}, {1e-3 / dt, 0}, {1e-3 / dt, 0.02 / (fastest * fastest * dt)}, {0.01 / dt, 3 * dt}};
        for (size_t d = 0; d < COUNT(dampings) - (step->is_explicit ? 1 : 0); ++d) {
            l.drag = dampings[d].drag;
            l.stiffness_damping = dampings[d].stiffness_damping;
            compare_one(&l, step, dt, precision, worst);
        }
    }
}

static void compare(enum lattice ends, cd_precision precision, double allowed) {
    static const size_t sizes[] = {20, 65, 200};
    struct worst worst = {0, ""};
    for (size_t s = 0; s < COUNT(sizes); ++s)
        for (size_t m = 0; m < TIME_STEPS; ++m) {
            const struct lattice_chain l = {
                .ends = ends, .nodes = sizes[s], .mass = 1.3, .stiffness = 0.7, .bend = ends == HINGED ? 0.9 : 0.02};
            compare_damped(l, &time_steps[m], precision, &worst);
        }
    print_message("%-15s float%d: largest error %.2e of %.0e (%s)\n", lattice_names[ends],
                  precision == CD_FLOAT32 ? 32 : 64, worst.error, allowed, worst.what);
    assert_true(worst.error <= allowed);
}

static void float64_matches(void** state) {
    compare(*(const enum lattice*)*state, CD_FLOAT64, 1e-10);
}

static void float32_matches(void** state) {
    compare(*(const enum lattice*)*state, CD_FLOAT32, 1e-4);
}

/* One mode matrix, checked by hand: lambda 1/2 turns by 2 atan(z / 2) and keeps the length. */
static void the_closed_form_itself_turns_and_grows_as_derived(void** state) {
    (void)state;
    const long double omega = 3, dt = 0.4L, z = omega * dt;
    for (size_t m = 0; m < TIME_STEPS; ++m) {
        const struct time_step* step = &time_steps[m];
        const struct matrix2 g = step_matrix(step, dt, omega, 0);
        const long double trace = g.a[0][0] + g.a[1][1];
        const long double determinant = g.a[0][0] * g.a[1][1] - g.a[0][1] * g.a[1][0];
        const long double l = step->lambda;
        if (step->method == CD_METHOD_SYMPLECTIC_EULER) {
            assert_true(fabsl(determinant - 1) < 1e-18L && fabsl(trace - (2 - z * z)) < 1e-18L);
        } else if (step->method != CD_METHOD_STIFF_SECOND) {
            const long double growth = (1 + (1 - l) * (1 - l) * z * z) / (1 + l * l * z * z);
            assert_true(fabsl(determinant - growth) < 1e-17L);
        } else {
            assert_true(determinant > 0 && determinant < 1);
        }
        if (l == 0.5L) assert_true(fabsl(trace - 2 * cosl(2 * atanl(z / 2))) < 1e-17L);
    }
}

int main(void) {
    static enum lattice ends[LATTICES];
    static char names[LATTICES][2][80];
    struct CMUnitTest tests[2 * LATTICES + 1];
    tests[0] = (struct CMUnitTest)cmocka_unit_test(the_closed_form_itself_turns_and_grows_as_derived);
    size_t count = 1;
    for (int k = 0; k < LATTICES; ++k)
        for (int single = 0; single < 2; ++single) {
            ends[k] = (enum lattice)k;
            snprintf(names[k][single], sizeof names[k][single], "every_method_matches_the_closed_form: %s, float%d",
                     lattice_names[k], single ? 32 : 64);
            tests[count++] = (struct CMUnitTest){names[k][single], single ? float32_matches : float64_matches, NULL,
                                                 NULL, &ends[k]};
        }
    return _cmocka_run_group_tests("modes", tests, count, NULL, NULL);
}
