/* Whoever looks from a function of the caller's sees all that called it, up to main: in each of the callbacks, with each
 * set of kernels. Debuggers and what writes crash reports look so, and so does an exception that passes. The library's
 * functions that call none of the caller's need not have what it takes, and kernels but those of ropes do without. */
#include <string.h>

#include "heap.h"
#include "kernels.h"
#include "subjects.h"

#ifdef _WIN32
enum { IS_LOOKED_AT = 0 }; /* Windows has its own tables, which no function can be without */
#else
#include <unwind.h>
enum { IS_LOOKED_AT = 1 };

int main(void);

static _Unwind_Reason_Code look_for_main(struct _Unwind_Context* context, void* is_seen) {
    if (_Unwind_GetRegionStart(context) != (uintptr_t)main) return _URC_NO_REASON;
    *(bool*)is_seen = true;
    return _URC_END_OF_STACK;
}
#endif

static bool sees_main(void) {
    bool is_seen = !IS_LOOKED_AT;
#ifndef _WIN32
    _Unwind_Backtrace(look_for_main, &is_seen);
#endif
    return is_seen;
}

/* How often each callback was called, and how often it did not see main. */
enum { ALLOCATE, RELEASE, RUN, DISTANCE, CALLBACKS };
static size_t called[CALLBACKS], blind[CALLBACKS];
static const char* const names[] = {"allocate", "release", "run", "distance"};

static void look(int callback) {
    ++called[callback];
    if (!sees_main()) ++blind[callback];
}

static void* allocate(void* user, size_t size, size_t alignment) {
    look(ALLOCATE);
    const cd_allocator inner = heap_allocator(user);
    return inner.allocate(inner.user, size, alignment);
}

static void release(void* user, void* pointer, size_t size, size_t alignment) {
    look(RELEASE);
    const cd_allocator inner = heap_allocator(user);
    inner.release(inner.user, pointer, size, alignment);
}

static void run(void* user, size_t count, void (*task)(void*, size_t), void* context) {
    (void)user;
    look(RUN);
    for (size_t i = 0; i < count; ++i) task(context, i);
}

static void distance(void* user, double time, size_t count, size_t components, const double* positions,
                     double* distances, double* normals) {
    (void)user;
    look(DISTANCE);
    tell_nothing(NULL, time, count, components, positions, distances, normals);
}

/* Where not even the test sees main, for no one built the libraries that call it so, there is nothing to compare with:
 * but on these systems all are. */
static bool can_look(void) {
    if (sees_main()) return IS_LOOKED_AT;
#if defined(__linux__) && (defined(__x86_64__) || defined(__aarch64__))
    fail_msg("not even a test sees main");
#endif
    return false;
}

static bool has_lengths(const struct subject* s, size_t scene) { return scene - s->lengths < s->have_lengths; }

/* What is near to nothing: of a rope or of cloth. */
static void surround(const struct subject* s, any* object, const cd_distance* shape) {
    s->surround(object, true);
    if (s->kind->number == CD_KIND_CHAIN) ok(cd_chain_set_callback(object, 0, shape, target, COMPONENTS, 0));
    else ok(cd_membrane_set_callback(object, 0, shape, target, COMPONENTS, 0));
}

/* Of the smallest objects too, whose steps are not spread, and of the largest ones. */
static void every_callback_sees_main(void** state) {
    const struct subject* s = *state;
    if (!can_look()) {
        print_message("not looked at: not even this test sees main\n");
        return;
    }
    size_t in_all[CALLBACKS] = {0};
    for (size_t scene = 0; scene < 2 * s->scenes; ++scene) {
        struct heap heap = {0};
        const cd_allocator allocator = {&heap, allocate, release};
        const cd_parallel parallel = {NULL, run};
        const cd_distance shape = {NULL, distance};
        const bool is_large = scene % 2, lengths = has_lengths(s, scene / 2);
        any* object = NULL;
        memset(called, 0, sizeof called), memset(blind, 0, sizeof blind);
        ok(s->kind->create(is_large ? s->wide : s->first, is_large ? s->high : s->second, lengths ? COMPONENTS : 1,
                           CD_FLOAT64, &allocator, &object));
        const char* const name = s->build(object, scene / 2);
        if (is_large) ok(s->kind->set_parallel(object, &parallel));
        if (lengths) surround(s, object, &shape);
        FOR_RUNNABLE(kernels) {
            const size_t before[] = {called[RUN], called[DISTANCE]};
            ok(s->kind->set_kernels(object, kernels));
            const cd_status status = s->kind->step(object, s->dt, 1);
            assert_true(status == CD_OK || s->may_not_step(object, status));
            if (is_large) assert_true(called[RUN] > before[0]);
            if (lengths) assert_true(called[DISTANCE] > before[1]);
        }
        s->kind->destroy(object);
        for (int i = 0; i < CALLBACKS; ++i) {
            if (blind[i] > 0) fail_msg("%s, %s: %s does not see main", s->kind->name, name, names[i]);
            in_all[i] += called[i];
        }
        heap_free(&heap);
    }
    assert_true(in_all[ALLOCATE] > 0 && in_all[RELEASE] > 0);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        {.name = "chain", .test_func = every_callback_sees_main, .initial_state = (void*)&subjects[0]},
        {.name = "membrane", .test_func = every_callback_sees_main, .initial_state = (void*)&subjects[1]},
        {.name = "water", .test_func = every_callback_sees_main, .initial_state = (void*)&subjects[2]},
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
