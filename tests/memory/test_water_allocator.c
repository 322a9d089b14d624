/* Every allocation of every call on a water that may allocate, refused in turn, once and for good. */
#include <string.h>

#include "check.h"
#include "heap.h"
#include "jobs.h"
#include "pool.h"

enum { NX = 9, NY = 7 };

/* Calls on a water; `source` is another with everything on, and `bytes` is what it saves. */
static cd_water* source;
static unsigned char bytes[1 << 16];
static size_t size;
static struct jobs jobs;

static cd_status explicit_method(cd_water* w) { return cd_water_set_method(w, CD_METHOD_SYMPLECTIC_EULER); }
static cd_status forward(cd_water* w) { return cd_water_set_method(w, CD_METHOD_FORWARD_EULER); }
static cd_status implicit(cd_water* w) { return cd_water_set_method(w, CD_METHOD_IMPLICIT); }
static cd_status linear(cd_water* w) { return cd_water_set_momentum(w, CD_MOMENTUM_LINEAR); }
static cd_status advected(cd_water* w) { return cd_water_set_momentum(w, CD_MOMENTUM_ADVECTED); }
static cd_status parallel(cd_water* w) {
    const cd_parallel reversed = jobs_reversed(&jobs);
    return cd_water_set_parallel(w, &reversed);
}
static cd_status single(cd_water* w) { return cd_water_set_parallel(w, NULL); }
static cd_status side(cd_water* w) { return cd_water_set_side(w, CD_SIDE_X_FIRST, CD_BORDER_OPEN, 0.125, 0); }
static cd_status periodic(cd_water* w) { return cd_water_set_side(w, CD_SIDE_Y_FIRST, CD_BORDER_PERIODIC, 0, 0); }
static cd_status enable_mask(cd_water* w) { return cd_water_enable_field(w, CD_MASK); }
static cd_status enable_source(cd_water* w) { return cd_water_enable_field(w, CD_SOURCE); }
static cd_status enable_pressure(cd_water* w) { return cd_water_enable_field(w, CD_PRESSURE); }
static cd_status enable_force_x(cd_water* w) { return cd_water_enable_field(w, CD_FORCE_X); }
static cd_status enable_force_y(cd_water* w) { return cd_water_enable_field(w, CD_FORCE_Y); }
static cd_status enable_wall_x(cd_water* w) { return cd_water_enable_field(w, CD_WALL_X); }
static cd_status enable_wall_y(cd_water* w) { return cd_water_enable_field(w, CD_WALL_Y); }
static cd_status disable_source(cd_water* w) { return cd_water_disable_field(w, CD_SOURCE); }
static cd_status disable_mask(cd_water* w) { return cd_water_disable_field(w, CD_MASK); }
static cd_status add_source(cd_water* w) { return cd_water_add_source(w, 1, 1, 1, 0.125); }
static cd_status add_sources(cd_water* w) { return cd_water_add_source_rectangle(w, 1, 1, 3, 2, 0.125); }
static cd_status hulls(cd_water* w) { return cd_water_set_hulls(w, 5, 8, 3); }
static cd_status no_hulls(cd_water* w) { return cd_water_set_hulls(w, 0, 0, 0); }
static cd_status load(cd_water* w) { return cd_water_load(w, bytes, size); }
static cd_status copy(cd_water* w) { return cd_water_copy_state(w, source); }
static cd_status step(cd_water* w) { return cd_water_step(w, 0.002, 3); }
static cd_status reset(cd_water* w) { return cd_water_reset(w); }
static cd_status add_volume(cd_water* w) { return cd_water_add_volume(w, 1, 1, 1, 0.125, NULL); }
static cd_status splash(cd_water* w) { return cd_water_splash(w, 1, 1, 1, 0.125); }
static cd_status impulse(cd_water* w) { return cd_water_impulse(w, 1, 1, 1, 0.125, 1); }

static const struct call {
    const char* name;
    cd_status (*make)(cd_water*);
    int never; /* never allocates, in any scene */
} calls[] = {
    {"set_method explicit", explicit_method, 0},
    {"set_method forward", forward, 0},
    {"set_method implicit", implicit, 0},
    {"set_momentum linear", linear, 0},
    {"set_momentum advected", advected, 0},
    {"set_parallel", parallel, 0},
    {"set_parallel null", single, 0},
    {"set_side open", side, 1},
    {"set_side periodic", periodic, 1},
    {"enable mask", enable_mask, 0},
    {"enable source", enable_source, 0},
    {"enable pressure", enable_pressure, 0},
    {"enable force x", enable_force_x, 0},
    {"enable force y", enable_force_y, 0},
    {"enable wall x", enable_wall_x, 0},
    {"enable wall y", enable_wall_y, 0},
    {"disable source", disable_source, 0},
    {"disable mask", disable_mask, 0},
    {"add_source", add_source, 0},
    {"add_source_rectangle", add_sources, 0},
    {"set_hulls", hulls, 0},
    {"set_hulls none", no_hulls, 0},
    {"load", load, 0},
    {"copy_state", copy, 0},
    {"step", step, 1},
    {"reset", reset, 1},
    {"add_volume", add_volume, 1},
    {"splash", splash, 1},
    {"impulse", impulse, 1},
};

static int set_up(void** state) {
    (void)state;
    source = pool_of(POOL_EVERYTHING, NX, NY, CD_FLOAT64, 3);
    ok(cd_water_save(source, bytes, sizeof bytes, &size));
    return 0;
}

static int tear_down(void** state) {
    (void)state;
    cd_water_destroy(source);
    return 0;
}

static cd_water* begin(struct heap* heap, size_t scene) {
    const cd_allocator allocator = heap_allocator(heap);
    cd_water* w = pool_from(&allocator, NX, NY, CD_FLOAT64);
    pools[scene].build(w);
    pool_step(w, 0.002, 2);
    return w;
}

static void assert_accounts_for(const cd_water* w, const struct heap* heap) {
    size_t held;
    ok(cd_water_get_memory(w, &held));
    assert_int_equal(held, heap->live_bytes);
    assert_int_equal(heap->mistakes, 0);
}

/* The hash after the call and some steps, when memory does not run out; and how often the call asks for it. */
static uint64_t undisturbed(size_t scene, const struct call* call, cd_status* out_status, size_t* out_asked) {
    struct heap heap = {0};
    cd_water* w = begin(&heap, scene);
    heap_fail(&heap, 0, false);
    *out_status = call->make(w);
    *out_asked = heap.asked;
    assert_accounts_for(w, &heap);
    pool_step(w, 0.002, 4);
    const uint64_t hash = hash_of(w);
    cd_water_destroy(w);
    heap_free(&heap);
    return hash;
}

static void refuse_request(size_t scene, const struct call* call, size_t at, bool for_good, cd_status wanted,
                           uint64_t after) {
    struct heap heap = {0};
    cd_water* w = begin(&heap, scene);
    const uint64_t before = hash_of(w);
    const size_t live = heap.live_bytes, blocks = heap.live_blocks;
    heap_fail(&heap, at, for_good);
    const cd_status status = call->make(w);
    if (status != CD_ERROR_MEMORY)
        fail_msg("%s, %s, request %zu refused: %s", pools[scene].name, call->name, at, cd_status_name(status));
    assert_true(heap.refused > 0);
    assert_non_null(strstr(cd_error_message(), "cd_water_"));
    assert_int_equal(hash_of(w), before);
    assert_int_equal(heap.live_bytes, live);
    assert_int_equal(heap.live_blocks, blocks);
    assert_accounts_for(w, &heap);
    heap_fail(&heap, 0, false); /* memory is back: the same call now does what it always did */
    assert_int_equal(call->make(w), wanted);
    pool_step(w, 0.002, 4);
    assert_int_equal(hash_of(w), after);
    assert_accounts_for(w, &heap);
    cd_water_destroy(w);
    heap_free(&heap);
}

static void a_refused_allocation_changes_nothing_and_the_water_still_works(void** state) {
    (void)state;
    size_t refused = 0;
    for (size_t scene = 0; scene < POOLS; ++scene) {
        for (size_t i = 0; i < COUNT(calls); ++i) {
            cd_status wanted;
            size_t asked;
            const uint64_t after = undisturbed(scene, &calls[i], &wanted, &asked);
            if (calls[i].never) assert_int_equal(asked, 0);
            for (int for_good = 0; for_good <= 1; ++for_good)
                for (size_t at = 1; at <= asked; ++at, ++refused)
                    refuse_request(scene, &calls[i], at, for_good, wanted, after);
        }
    }
    assert_true(refused > 200);
}

static void a_create_that_runs_out_of_memory_gives_all_of_it_back(void** state) {
    (void)state;
    for (cd_precision precision = CD_FLOAT32; precision <= CD_FLOAT64; ++precision) {
        struct heap heap = {0};
        const cd_allocator allocator = heap_allocator(&heap);
        cd_water* w = NULL;
        heap_fail(&heap, 0, false);
        ok(cd_water_create(NX, NY, 1, 1, precision, &allocator, &w));
        const size_t asked = heap.asked;
        assert_true(asked > 0);
        assert_accounts_for(w, &heap);
        cd_water_destroy(w);
        for (int for_good = 0; for_good <= 1; ++for_good) {
            for (size_t at = 1; at <= asked; ++at) {
                heap_fail(&heap, at, for_good);
                refuses(NULL, cd_water_create(NX, NY, 1, 1, precision, &allocator, &out.water), CD_ERROR_MEMORY, "");
                assert_int_equal(heap.live_bytes, 0);
                assert_int_equal(heap.live_blocks, 0);
            }
        }
        heap_fail(&heap, asked + 1, true);
        ok(cd_water_create(NX, NY, 1, 1, precision, &allocator, &w));
        cd_water_destroy(w);
        heap_free(&heap);
    }
}

static void the_memory_told_is_the_memory_held(void** state) {
    (void)state;
    for (size_t scene = 0; scene < POOLS; ++scene) {
        for (cd_precision precision = CD_FLOAT32; precision <= CD_FLOAT64; ++precision) {
            struct heap heap = {0};
            const cd_allocator allocator = heap_allocator(&heap);
            cd_water* w = pool_from(&allocator, 1 + scene, 15 - scene, precision);
            assert_accounts_for(w, &heap);
            pools[scene].build(w);
            assert_accounts_for(w, &heap);
            for (size_t i = 0; i < COUNT(calls); ++i) {
                (void)calls[i].make(w); /* those that do not go together are refused */
                assert_accounts_for(w, &heap);
                pool_step(w, 0.0002, 1);
                assert_accounts_for(w, &heap);
            }
            for (cd_field field = CD_MASK; field <= CD_WALL_Y; ++field) {
                if (field >= CD_DEPTH && field <= CD_VELOCITY_Y) continue;
                ok(cd_water_disable_field(w, field));
                assert_accounts_for(w, &heap);
            }
            cd_water_destroy(w);
            heap_free(&heap);
        }
    }
}

static void steps_reads_and_writes_never_allocate(void** state) {
    (void)state;
    static double values[(NX + 1) * (NY + 1)];
    static unsigned char kept[1 << 16];
    for (size_t scene = 0; scene < POOLS; ++scene)
        for (int spread = 0; spread <= 1; ++spread) {
            struct heap heap = {0};
            const cd_allocator allocator = heap_allocator(&heap);
            cd_water* w = pool_from(&allocator, NX, NY, CD_FLOAT32);
            pools[scene].build(w);
            if (spread) ok(parallel(w));
            const size_t allocations = heap.allocations, live = heap.live_bytes;
            for (int round = 0; round < 3; ++round) {
                pool_step(w, 0.001 * (1 + round), 3);
                for (cd_field field = CD_MASK; field <= CD_WALL_Y; ++field) {
                    if (!pool_has(w, field)) continue;
                    pool_read(w, field, values);
                    pool_write(w, field, values);
                }
                size_t written;
                ok(cd_water_save(w, kept, sizeof kept, &written));
                ok(cd_water_load(w, kept, written)); /* the fields that are on already */
                hash_of(w);
            }
            assert_int_equal(heap.allocations, allocations);
            assert_int_equal(heap.live_bytes, live);
            cd_water_destroy(w);
            heap_free(&heap);
        }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_refused_allocation_changes_nothing_and_the_water_still_works),
        cmocka_unit_test(a_create_that_runs_out_of_memory_gives_all_of_it_back),
        cmocka_unit_test(the_memory_told_is_the_memory_held),
        cmocka_unit_test(steps_reads_and_writes_never_allocate),
    };
    return cmocka_run_group_tests(tests, set_up, tear_down);
}
