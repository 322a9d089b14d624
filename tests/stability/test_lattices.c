/* Every lattice whose modes are known, at any stiffness. */
#include <math.h>

#include "check.h"
#include "modes.h"
#include "reference.h"

/* A random state is a sum of modes, and each moves by its own closed form. Two pins, rings and pure bend, which the
 * reference integrator cannot follow to 1e30, are among them. lambda = 1/2 never forgets what random positions do to
 * a stiff chain (see test_stiff.c): it starts with a kick. */
enum { NODES = 101 };

static double lattice_error(const struct lattice_chain* l, const struct time_step* step, double dt, size_t steps,
                            cd_precision precision) {
    const size_t n = l->nodes, last = lattice_last_mode(l);
    const int kicked = step->lambda == 0.5;
    static double x[NODES], v[NODES];
    static long double exact_x[NODES], exact_v[NODES];
    uint64_t seed = 29;
    for (size_t i = 0; i < n; ++i) x[i] = v[i] = 0, exact_x[i] = exact_v[i] = 0;
    for (size_t j = lattice_is_free(l) && !kicked ? 0 : 1; j <= last; ++j) {
        const long double a = kicked ? 0 : random_number(&seed) / 8, b = random_number(&seed) / 8;
        const struct matrix2 g = matrix_power(step_matrix(step, dt, lattice_omega(l, j), 0), steps);
        for (size_t i = 0; i < n; ++i) {
            const long double shape = lattice_shape(l, j, i);
            x[i] += (double)(a * shape);
            v[i] += (double)(b * shape);
            exact_x[i] += (g.a[0][0] * a + g.a[0][1] * b) * shape;
            exact_v[i] += (g.a[1][0] * a + g.a[1][1] * b) * shape;
        }
    }
    /* what has died out is compared with what there was, and a position with the way of a step */
    long double ex = 0, ev = 0, sx = 0, sv = 0;
    for (size_t i = 0; i < n; ++i) {
        sx = fmaxl(sx, fmaxl(fmaxl(fabs(x[i]), dt * fabs(v[i])), fabsl(exact_x[i])));
        sv = fmaxl(sv, fmaxl(fabs(v[i]), fabsl(exact_v[i])));
    }
    cd_chain* chain = make_lattice_chain(l, 1, 1, precision);
    set_time_step(chain, step);
    ok(cd_chain_write_f64(chain, CD_POSITION, 0, 1, 0, n, x, n));
    ok(cd_chain_write_f64(chain, CD_VELOCITY, 0, 1, 0, n, v, n));
    ok(cd_chain_step(chain, dt, steps));
    ok(cd_chain_read_f64(chain, CD_POSITION, 0, 1, 0, n, x, n));
    ok(cd_chain_read_f64(chain, CD_VELOCITY, 0, 1, 0, n, v, n));
    cd_chain_destroy(chain);
    for (size_t i = 0; i < n; ++i) {
        if (!isfinite(x[i]) || !isfinite(v[i])) return INFINITY;
        ex = fmaxl(ex, fabsl(x[i] - exact_x[i]));
        ev = fmaxl(ev, fabsl(v[i] - exact_v[i]));
    }
    return (double)fmaxl(ex / sx, ev / sv);
}

static void every_lattice_moves_as_its_modes_do_at_every_stiffness(void** state) {
    (void)state;
    static const double ratios[] = {1e-12, 1e-4, 1e4, 1e8, 1e12, 1e20, 1e30};
    static const struct {
        cd_precision precision;
        size_t steps;
        double allowed;
    } runs[] = {{CD_FLOAT32, 1, 1e-5}, {CD_FLOAT32, 1000, 1e-4}, {CD_FLOAT64, 1, 1e-12}, {CD_FLOAT64, 1000, 3e-9}};
    int missed = 0;
    for (int ends = 0; ends < LATTICES; ++ends)
        for (size_t m = LAMBDA_1_2; m < TIME_STEPS; ++m)
            for (size_t run = 0; run < COUNT(runs); ++run) {
                double worst = 0, at = 0;
                for (size_t k = 0; k < COUNT(ratios); ++k) {
                    /* totals such that a spring, or a bend term, over a node's mass is the ratio */
                    const double s = ends >= RING ? NODES : NODES - 1;
                    struct lattice_chain l = {.ends = (enum lattice)ends, .nodes = NODES, .mass = 2};
                    l.stiffness = ratios[k] * l.mass / NODES / s;
                    l.bend = ratios[k] * l.mass / NODES / (s * s * s);
                    const double error = lattice_error(&l, &time_steps[m], 1.0 / 60, runs[run].steps,
                                                       runs[run].precision);
                    if (!(error <= worst)) worst = error, at = ratios[k];
                }
                /* what a rod's float64 gets more is said in test_rods.c */
                const int chain64 = ends <= RING && runs[run].precision == CD_FLOAT64 && runs[run].steps > 1;
                const int misses = !(worst <= (chain64 ? 1e-10 : runs[run].allowed));
                print_message("%-15s %-12s float%d, %4zu steps: %.1e (at %.0e)%s\n", lattice_names[ends],
                              time_steps[m].name, runs[run].precision == CD_FLOAT32 ? 32 : 64, runs[run].steps, worst,
                              at, misses ? "  <- too far" : "");
                missed += misses;
            }
    assert_int_equal(missed, 0);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(every_lattice_moves_as_its_modes_do_at_every_stiffness)};
    return cmocka_run_group_tests_name("lattices", tests, NULL, NULL);
}
