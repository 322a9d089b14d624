/* How long `calls` calls of cd_*_step(object, dt, 1) take, in seconds. */
#include <stddef.h>
#include <stdint.h>
#include <time.h>

double time_steps(int32_t (*step)(void*, double, size_t), void* object, double dt, size_t calls) {
    struct timespec begin, end;
    clock_gettime(CLOCK_MONOTONIC, &begin);
    for (size_t i = 0; i < calls; ++i)
        if (step(object, dt, 1)) return -1;
    clock_gettime(CLOCK_MONOTONIC, &end);
    return (double)(end.tv_sec - begin.tv_sec) + 1e-9 * (double)(end.tv_nsec - begin.tv_nsec);
}
