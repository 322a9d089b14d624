#include "jobs.h"

#include <pthread.h>

#include "cmocka_all.h"

static void run_reversed(void* user, size_t count, void (*task)(void*, size_t), void* context) {
    struct jobs* jobs = user;
    ++jobs->runs;
    jobs->tasks += count;
    for (size_t i = count; i-- > 0;) task(context, i);
}

struct queue {
    size_t next, count;
    void (*task)(void*, size_t);
    void* context;
};

static void* work(void* argument) {
    struct queue* queue = argument;
    for (size_t i; (i = __atomic_fetch_add(&queue->next, 1, __ATOMIC_RELAXED)) < queue->count;)
        queue->task(queue->context, i);
    return NULL;
}

static void run_on_threads(void* user, size_t count, void (*task)(void*, size_t), void* context) {
    struct jobs* jobs = user;
    ++jobs->runs;
    jobs->tasks += count;
    struct queue queue = {0, count, task, context};
    pthread_t threads[2];
    for (size_t i = 0; i < COUNT(threads); ++i) assert_int_equal(pthread_create(&threads[i], NULL, work, &queue), 0);
    for (size_t i = 0; i < COUNT(threads); ++i) assert_int_equal(pthread_join(threads[i], NULL), 0);
}

cd_parallel jobs_reversed(struct jobs* jobs) { return (cd_parallel){jobs, run_reversed}; }
cd_parallel jobs_threads(struct jobs* jobs) { return (cd_parallel){jobs, run_on_threads}; }
