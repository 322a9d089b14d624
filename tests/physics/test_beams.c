/* The bend energy is that of the natural spline: its frequencies converge to the beam's, omega = beta^2 sqrt(b / m). */
#include <math.h>
#include <stdlib.h>

#include "check.h"
#include "modes.h"
#include "reference.h"

enum { LARGEST = 257 };
enum beam { HINGED_HINGED, CLAMPED_FREE, FREE_BEAM, CLAMPED_CLAMPED, BEAMS };

static const struct {
    const char* name;
    double beta[3];
    int clamped_first, clamped_last;
} beams[BEAMS] = {{"hinged", {3.141592654, 6.283185307, 9.424777961}, 0, 0},
                  {"clamped-free", {1.875104069, 4.694091133, 7.854757438}, 1, 0},
                  {"free-free", {4.730040745, 7.853204624, 10.995607838}, 0, 0},
                  {"clamped-clamped", {4.730040745, 7.853204624, 10.995607838}, 1, 1}};

/* Half masses at the ends, mass 1, bend 1. A clamped end has its first two nodes pinned: x_0 = x_1 = 0 is a slope of 0
 * half way between them, so a clamp shortens the beam by half a spring. */
static cd_chain* make_beam(enum beam beam, size_t springs) {
    cd_chain* chain = NULL;
    ok(cd_chain_create(1, springs, 1, CD_FLOAT64, NULL, &chain));
    ok(cd_chain_set_stiffness(chain, 0));
    ok(cd_chain_set_bend(chain, 1));
    ok(cd_chain_set_mass_rule(chain, CD_MASS_HALF_ENDS));
    const double pinned[2] = {CD_NODE_PINNED, CD_NODE_PINNED};
    const int hinged = beam == HINGED_HINGED;
    if (hinged) ok(cd_chain_write_f64(chain, CD_PIN, 0, 1, 0, 1, pinned, 1));
    if (hinged) ok(cd_chain_write_f64(chain, CD_PIN, 0, 1, springs, 1, pinned, 1));
    if (beams[beam].clamped_first) ok(cd_chain_write_f64(chain, CD_PIN, 0, 1, 0, 2, pinned, 2));
    if (beams[beam].clamped_last) ok(cd_chain_write_f64(chain, CD_PIN, 0, 1, springs - 1, 2, pinned, 2));
    return chain;
}

static double node_mass(size_t i, size_t springs) { return (i == 0 || i == springs ? 0.5 : 1) / (double)springs; }

static void orthogonalize(double* x, double shapes[][LARGEST], size_t count, size_t springs) {
    for (size_t k = 0; k < count; ++k) {
        double dot = 0;
        for (size_t i = 0; i <= springs; ++i) dot += node_mass(i, springs) * x[i] * shapes[k][i];
        for (size_t i = 0; i <= springs; ++i) x[i] -= dot * shapes[k][i];
    }
}

static void normalize(double* x, size_t springs) {
    double square = 0;
    for (size_t i = 0; i <= springs; ++i) square += node_mass(i, springs) * x[i] * x[i];
    assert_true(square > 0);
    for (size_t i = 0; i <= springs; ++i) x[i] /= sqrt(square);
}

/* One step of lambda = 1 from rest is x <- (M + dt^2 K)^-1 M x: inverse iteration. The frequency is then the ratio of
 * the elastic energy of the shape as a position to its kinetic energy as a velocity. */
static void beam_frequencies(enum beam beam, size_t springs, double omega[3]) {
    static double shapes[5][LARGEST];
    const size_t nodes = springs + 1;
    static const double zeros[LARGEST];
    size_t known = 0;
    if (beam == FREE_BEAM)
        for (; known < 2; ++known) {
            for (size_t i = 0; i < nodes; ++i) shapes[known][i] = known == 0 ? 1 : (double)i - (double)springs / 2;
            normalize(shapes[known], springs);
        }
    cd_chain* chain = make_beam(beam, springs);
    ok(cd_chain_set_lambda(chain, 1));
    for (size_t mode = 0; mode < 3; ++mode, ++known) {
        double* x = shapes[known];
        uint64_t seed = 40 + mode;
        double pin[LARGEST], elastic, kinetic;
        ok(cd_chain_read_f64(chain, CD_PIN, 0, 1, 0, nodes, pin, nodes));
        for (size_t i = 0; i < nodes; ++i) x[i] = pin[i] == CD_NODE_PINNED ? 0 : random_number(&seed);
        for (int k = 0; k < 60; ++k) {
            ok(cd_chain_write_f64(chain, CD_POSITION, 0, 1, 0, nodes, x, nodes));
            ok(cd_chain_write_f64(chain, CD_VELOCITY, 0, 1, 0, nodes, zeros, nodes));
            ok(cd_chain_step(chain, 1, 1));
            ok(cd_chain_read_f64(chain, CD_POSITION, 0, 1, 0, nodes, x, nodes));
            orthogonalize(x, shapes, known, springs);
            normalize(x, springs);
        }
        ok(cd_chain_write_f64(chain, CD_POSITION, 0, 1, 0, nodes, x, nodes));
        ok(cd_chain_write_f64(chain, CD_VELOCITY, 0, 1, 0, nodes, x, nodes));
        ok(cd_chain_get_energy(chain, &kinetic, &elastic, NULL));
        omega[mode] = sqrt(elastic / kinetic);
    }
    /* the last shape, let go, swings at that frequency: lambda = 1/2 turns it by 2 atan(omega dt / 2) a step */
    const double* x = shapes[known - 1];
    double swung[LARGEST], size = 0;
    const double dt = 0.05 / omega[2];
    ok(cd_chain_set_lambda(chain, 0.5));
    ok(cd_chain_write_f64(chain, CD_POSITION, 0, 1, 0, nodes, x, nodes));
    ok(cd_chain_write_f64(chain, CD_VELOCITY, 0, 1, 0, nodes, zeros, nodes));
    ok(cd_chain_step(chain, dt, 300));
    ok(cd_chain_read_f64(chain, CD_POSITION, 0, 1, 0, nodes, swung, nodes));
    for (size_t i = 0; i < nodes; ++i) size = fmax(size, fabs(x[i]));
    for (size_t i = 0; i < nodes; ++i) assert_near(swung[i], x[i] * cos(300 * 2 * atan(0.05 / 2)), 1e-6, size);
    cd_chain_destroy(chain);
}

/* Errors of the frequency against beta^2: first order where an end is clamped, because its place is off by half a
 * spring, and second order once the beam is measured between its clamps. */
static void beam_frequencies_converge_to_beta_squared(void** state) {
    (void)state;
    for (int beam = 0; beam < BEAMS; ++beam) {
        double coarser[3] = {0, 0, 0}, coarser_fitted[3] = {0, 0, 0};
        const int clamps = beams[beam].clamped_first + beams[beam].clamped_last;
        for (size_t springs = 32; springs <= 128; springs *= 2) {
            double omega[3];
            beam_frequencies((enum beam)beam, springs, omega);
            for (int mode = 0; mode < 3; ++mode) {
                const double exact = beams[beam].beta[mode] * beams[beam].beta[mode];
                const double length = 1 - 0.5 * clamps / (double)springs;
                const double error = fabs(omega[mode] / exact - 1);
                const double fitted = fabs(omega[mode] * length * length / exact - 1);
                print_message("%-15s %3zu springs, mode %d: omega / beta^2 - 1 = %+.1e, between clamps %.1e\n",
                              beams[beam].name, springs, mode + 1, omega[mode] / exact - 1, fitted);
                if (coarser[mode] > 0) {
                    assert_true(log2(coarser[mode] / error) > (clamps ? 0.8 : 1.8));
                    assert_true(log2(coarser_fitted[mode] / fitted) > 1.8);
                }
                coarser[mode] = error;
                coarser_fitted[mode] = fitted;
            }
        }
        for (int mode = 0; mode < 3; ++mode) assert_true(coarser_fitted[mode] < 5e-3);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(beam_frequencies_converge_to_beta_squared)};
    return cmocka_run_group_tests_name("beams", tests, NULL, NULL);
}
