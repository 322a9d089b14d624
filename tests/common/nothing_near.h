/* A callback of a collider that nothing comes near to. */
#ifndef NOTHING_NEAR_H
#define NOTHING_NEAR_H

#include <contdyn/base.h>

static void tell_nothing(void* user, double time, size_t count, size_t components, const double* positions,
                         double* distances, double* normals) {
    (void)user, (void)time, (void)positions;
    for (size_t i = 0; i < count; ++i) {
        distances[i] = 1;
        for (size_t k = 0; k < components; ++k) normals[i * components + k] = k == 0;
    }
}
static const cd_distance nothing_near = {NULL, tell_nothing};

#endif
