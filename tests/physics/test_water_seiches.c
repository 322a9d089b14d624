/* Small waves on water of one depth: closed forms of the lattice, mode by mode and step by step, compared to rounding.
 * Mode (p, q) of a walled basin is cos(p pi (i + 1/2) / nx) cos(q pi (j + 1/2) / ny); with A = 4 g d (dt / size)^2
 * sin^2(p pi / 2 n), a line's step of (surface, dt velocity's slope) is the 2 x 2 matrix of a lambda step of omega^2
 * dt^2 = A. Alternating steps are two such steps one after the other that share the surface. */
#include <math.h>
#include <stdlib.h>

#include "basin.h"
#include "check.h"
#include "modes.h"

static const double gravity = 9.81, deep = 2.5;

/* Amplitudes: of the surface, and of each axis' velocity over what turns it into the surface's change in a step. */
struct amplitudes {
    long double a[3];
};

/* x' = x + s ((1 - lambda) y + lambda y'), y' = y - s ((1 - lambda) x + lambda x'), s = omega dt, by eliminating: the
 * library's implicit step. An explicit one is half of the push, the move, and the other half. */
static void half_step(long double s, long double lambda, int is_explicit, long double* x, long double* y) {
    if (is_explicit) {
        *y -= s / 2 * *x;
        *x += s * *y;
        *y -= s / 2 * *x;
        return;
    }
    /* guess: y - s x; then y' = y - s (x + lambda (x' - x)) and x' = x + s (lambda y' + (1 - lambda) y) */
    const long double x_new = (*x + s * (*y - lambda * s * (1 - lambda) * *x)) / (1 + lambda * lambda * s * s);
    const long double y_new = *y - s * (*x + lambda * (x_new - *x));
    *x = x_new, *y = y_new;
}

struct seiche {
    size_t n[2], mode[2];
    double size[2], dt;
    int ring[2];
};

/* omega dt of a mode along an axis */
static long double turn(const struct seiche* m, int axis) {
    const long double c = sqrtl((long double)gravity * deep) * m->dt / m->size[axis];
    const long double phase = PI * (long double)m->mode[axis] * (m->ring[axis] ? 2 : 1) / (long double)m->n[axis];
    return 2 * c * sinl(phase / 2);
}

static double cell_shape(const struct seiche* m, int axis, size_t i) {
    const long double phase = PI * (long double)m->mode[axis] * (m->ring[axis] ? 2 : 1) / (long double)m->n[axis];
    return (double)cosl(phase * ((long double)i + 0.5L));
}

/* The part of the water's surface along a mode, and what is not. */
static double part_of(const cd_water* w, const struct seiche* m, double* out_rest) {
    const size_t nx = m->n[0], ny = m->n[1];
    double product = 0, square = 0;
    for (size_t j = 0; j < ny; ++j)
        for (size_t i = 0; i < nx; ++i) {
            const double shape = cell_shape(m, 0, i) * cell_shape(m, 1, j);
            product += shape * (basin_get(w, CD_DEPTH, i, j) - deep), square += shape * shape;
        }
    *out_rest = 0;
    for (size_t j = 0; j < ny; ++j)
        for (size_t i = 0; i < nx; ++i) {
            const double shape = cell_shape(m, 0, i) * cell_shape(m, 1, j);
            *out_rest = fmax(*out_rest, fabs(basin_get(w, CD_DEPTH, i, j) - deep - product / square * shape));
        }
    return product / square;
}

/* The largest difference from the closed form over some steps, as a part of the amplitude. The waves are a 1e-7th of
 * the depth: what they do to the faces' depths shows at 1e-7, and rounding of the depth at 1e-9. Those that are carried
 * along are half as high: what carries them goes with their height and with the way that they have run. */
static double off_by(const struct way* way, const struct seiche* m, size_t steps) {
    const double height = (way->momentum == CD_MOMENTUM_ADVECTED ? 5e-8 : 1e-7) * deep;
    cd_water* w = basin(m->n[0], m->n[1], m->size[0], m->size[1], CD_FLOAT64);
    basin_set_way(w, way);
    for (int axis = 0; axis < 2; ++axis)
        if (m->ring[axis]) ok(cd_water_set_side(w, 2 * axis, CD_BORDER_PERIODIC, 0, 0));
    for (size_t j = 0; j < m->n[1]; ++j)
        for (size_t i = 0; i < m->n[0]; ++i)
            basin_set(w, CD_DEPTH, i, j, deep + height * cell_shape(m, 0, i) * cell_shape(m, 1, j));
    long double x = height, y[2] = {0, 0}, s[2] = {turn(m, 0), turn(m, 1)};
    double worst = 0;
    for (size_t k = 0; k < steps; ++k) {
        basin_step(w, m->dt, 1);
        const int first = (int)(k % 2);
        half_step(s[first], way->lambda, basin_is_explicit(way), &x, &y[first]);
        half_step(s[1 - first], way->lambda, basin_is_explicit(way), &x, &y[1 - first]);
        double rest;
        const double part = part_of(w, m, &rest);
        worst = fmax(worst, fmax(fabs(part - (double)x), rest) / height);
    }
    cd_water_destroy(w);
    return worst;
}

static void seiches_swing_as_the_lattice_does(void** state) {
    (void)state;
    static const struct seiche scenes[] = {
        {{24, 1}, {1, 0}, {0.5, 1}, 0.02, {0, 0}},    {{24, 1}, {5, 0}, {0.5, 1}, 0.02, {0, 0}},
        {{24, 1}, {23, 0}, {0.5, 1}, 0.02, {0, 0}},   {{1, 24}, {0, 3}, {0.5, 0.5}, 0.02, {0, 0}},
        {{24, 1}, {3, 0}, {0.5, 1}, 0.5, {0, 0}},     {{12, 10}, {1, 1}, {0.5, 0.7}, 0.02, {0, 0}},
        {{12, 10}, {3, 2}, {0.5, 0.7}, 0.02, {0, 0}}, {{12, 10}, {11, 9}, {0.5, 0.7}, 0.02, {0, 0}},
        {{12, 10}, {3, 2}, {0.5, 0.7}, 0.5, {0, 0}},  {{12, 10}, {3, 2}, {0.5, 0.7}, 5, {0, 0}},
        {{12, 10}, {3, 2}, {0.5, 0.7}, 0.02, {1, 0}}, {{12, 10}, {2, 3}, {0.5, 0.7}, 0.3, {1, 1}},
    };
    for (size_t k = 0; k < WAYS; ++k) {
        double worst = 0;
        for (size_t s = 0; s < COUNT(scenes); ++s) {
            if (basin_is_explicit(&ways[k]) && scenes[s].dt > 0.02) continue;
            const double off = off_by(&ways[k], &scenes[s], 200);
            worst = fmax(worst, off);
        }
        print_message("%-17s off the lattice's own waves by %.1e\n", ways[k].name, worst);
        assert_true(worst <=
                    (ways[k].momentum == CD_MOMENTUM_ADVECTED ? 1e-5 : 1e-6)); /* the waves are not quite small */
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(seiches_swing_as_the_lattice_does),
    };
    return cmocka_run_group_tests_name("water seiches", tests, NULL, NULL);
}
