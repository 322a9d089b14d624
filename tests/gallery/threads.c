/* Steps on the caller's threads: 4096 strands of hair, stepped by one thread and by four, with the same bits. The hook
 * takes whatever pool of threads a program has; this one starts four for each call, which is only simple. */
#include <contdyn/contdyn.h>
#include <math.h>
#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>

enum { kThreads = 4, kStrands = 4096, kSprings = 15 };

static void must(cd_status status) {
    if (status == CD_OK) return;
    fprintf(stderr, "%s\n", cd_error_message());
    exit(1);
}

typedef struct part {
    size_t first, count;
    void (*task)(void* context, size_t index);
    void* context;
} part;

static void* work(void* argument) {
    const part* const mine = argument;
    for (size_t i = mine->first; i < mine->count; i += kThreads) mine->task(mine->context, i);
    return NULL;
}

/* Every task once, on any thread, in any order; returns when all are done. */
static void run(void* user, size_t count, void (*task)(void* context, size_t index), void* context) {
    pthread_t threads[kThreads];
    part parts[kThreads];
    int started[kThreads];
    (void)user;
    for (size_t t = 0; t < kThreads; ++t) {
        const part mine = {t, count, task, context};
        parts[t] = mine;
        started[t] = pthread_create(&threads[t], NULL, work, &parts[t]) == 0;
        if (!started[t]) work(&parts[t]);
    }
    for (size_t t = 0; t < kThreads; ++t)
        if (started[t]) pthread_join(threads[t], NULL);
}

static uint64_t hash_after_a_second(const cd_parallel* parallel) {
    const double gravity[3] = {0, 0, -9.81};
    float* const x = malloc(sizeof *x * kStrands * (kSprings + 1) * 3);
    uint64_t hash;
    cd_chain* hair;
    if (!x) exit(1);
    for (size_t s = 0; s < kStrands; ++s)
        for (size_t i = 0; i <= kSprings; ++i) {
            float* const at = x + 3 * (s * (kSprings + 1) + i);
            const double angle = 0.1 * (double)s, out = 0.1 + 0.2 * (double)i / kSprings;
            at[0] = (float)(out * cos(angle)), at[1] = (float)(out * sin(angle)), at[2] = (float)(2e-5 * (double)s);
        }
    must(cd_chain_create(kStrands, kSprings, 3, CD_FLOAT32, NULL, &hair));
    must(cd_chain_write_f32(hair, CD_POSITION, 0, kStrands, 0, kSprings + 1, x, kStrands * (kSprings + 1) * 3));
    must(cd_chain_set_rest_length(hair, 0.2));
    must(cd_chain_set_stiffness(hair, INFINITY));
    must(cd_chain_set_gravity(hair, gravity, 3));
    must(cd_chain_set_end(hair, CD_END_FIRST, CD_NODE_PINNED));
    must(cd_chain_set_parallel(hair, parallel));
    for (int frame = 0; frame < 60; ++frame) must(cd_chain_step(hair, 1 / 60.0, 1));
    must(cd_chain_hash(hair, &hash));
    cd_chain_destroy(hair);
    free(x);
    return hash;
}

int main(void) {
    const cd_parallel four = {NULL, run};
    const uint64_t alone = hash_after_a_second(NULL), together = hash_after_a_second(&four);
    printf("by one thread and by %d: the same bits: %s\n", kThreads, alone == together ? "yes" : "no");
    return alone != together;
}
