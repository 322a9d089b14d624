/* What the tests share of what ropes and cloth do to bodies. */
#ifndef LOADS_H
#define LOADS_H

#include <math.h>

#include <contdyn/base.h>

#include "reference.h"

static inline double size_of(const double* a) { return sqrt(a[0] * a[0] + a[1] * a[1] + a[2] * a[2]); }
static inline double part(uint64_t* draw) { return 0.5 * (random_number(draw) + 1); } /* from 0 to 1 */

/* Adds one collider's load to a sum. */
static inline void add_load(double* sum, const double* load) {
    for (int k = 0; k < 6; ++k) sum[k] += load[k];
}

/* A ball about the collider's origin, as a callback, of the radius that `user` points to. */
static inline void ball(void* user, double time, size_t count, size_t components, const double* x, double* distances,
                        double* normals) {
    (void)time;
    for (size_t i = 0; i < count; ++i) {
        double square = 0;
        for (size_t k = 0; k < components; ++k) square += x[i * components + k] * x[i * components + k];
        const double r = sqrt(square);
        distances[i] = r - *(const double*)user;
        for (size_t k = 0; k < components; ++k)
            normals[i * components + k] = r > 0 ? x[i * components + k] / r : k == 0;
    }
}

#endif
