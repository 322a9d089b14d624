/* The kernels that this processor runs, one after the other. */
#ifndef KERNELS_H
#define KERNELS_H

#include <contdyn/base.h>

/* A loop in which `kernels` is a cd_kernels. */
#define FOR_RUNNABLE(kernels)                                                                \
    for (cd_kernels kernels = CD_KERNELS_PLAIN; cd_runnable_kernels() >> kernels; ++kernels) \
        if (cd_runnable_kernels() >> kernels & 1)

#endif
