/* Every allocation of every call on a membrane that may allocate, refused in turn, once and for good. */
#include <string.h>

#include "check.h"
#include "cloth.h"
#include "heap.h"
#include "nothing_near.h"

enum { NU = 7, NV = 6, COMPONENTS = 3 };

static const double target[COMPONENTS] = {1, 2, 3};

/* Calls on a membrane; `source` is another with everything on, and `bytes` is what it saves. */
static cd_membrane* source;
static unsigned char bytes[1 << 16];
static size_t size;

/* The same of one whose springs have a length. */
static cd_membrane* sail;
static unsigned char sail_bytes[1 << 16];
static size_t sail_size;

static cd_status stiff(cd_membrane* m) { return cd_membrane_set_method(m, CD_METHOD_STIFF_SECOND); }
static cd_status explicit_method(cd_membrane* m) { return cd_membrane_set_method(m, CD_METHOD_SYMPLECTIC_EULER); }
static cd_status coupled(cd_membrane* m) { return cd_membrane_set_solver(m, CD_SOLVER_COUPLED); }
static cd_status alternating(cd_membrane* m) { return cd_membrane_set_solver(m, CD_SOLVER_ALTERNATING); }
static cd_status bend(cd_membrane* m) { return cd_membrane_set_bend(m, 0.01); }
static cd_status no_bend(cd_membrane* m) { return cd_membrane_set_bend(m, 0); }
static cd_status pressure(cd_membrane* m) { return cd_membrane_set_pressure(m, 0.5); }
static cd_status no_pressure(cd_membrane* m) { return cd_membrane_set_pressure(m, 0); }
static cd_status ring(cd_membrane* m) { return cd_membrane_set_ring(m, 0, 1); }
static cd_status no_ring(cd_membrane* m) { return cd_membrane_set_ring(m, 0, 0); }
static cd_status edge(cd_membrane* m) { return cd_membrane_set_edge(m, CD_EDGE_U_FIRST, CD_NODE_PINNED); }
static cd_status matched(cd_membrane* m) { return cd_membrane_set_edge(m, CD_EDGE_U_LAST, CD_NODE_MATCHED); }
static cd_status force(cd_membrane* m) { return cd_membrane_enable_field(m, CD_FORCE); }
static cd_status mass(cd_membrane* m) { return cd_membrane_enable_field(m, CD_MASS); }
static cd_status along_u(cd_membrane* m) { return cd_membrane_enable_field(m, CD_STIFFNESS_U); }
static cd_status along_v(cd_membrane* m) { return cd_membrane_enable_field(m, CD_STIFFNESS_V); }
static cd_status pins(cd_membrane* m) { return cd_membrane_enable_field(m, CD_PIN); }
static cd_status masks(cd_membrane* m) { return cd_membrane_enable_field(m, CD_MASK); }
static cd_status targets(cd_membrane* m) { return cd_membrane_enable_field(m, CD_TARGET); }
static cd_status lengths(cd_membrane* m) { return cd_membrane_set_rest_length(m, 0.7, 0.6); }
static cd_status no_lengths(cd_membrane* m) { return cd_membrane_set_rest_length(m, 0, 0); }
/* Of cloth only: all others refuse these, and that is the same whatever memory there is. */
static cd_status lengths_u(cd_membrane* m) { return cd_membrane_enable_field(m, CD_REST_LENGTH_U); }
static cd_status no_lengths_v(cd_membrane* m) { return cd_membrane_disable_field(m, CD_REST_LENGTH_V); }
static cd_status winds(cd_membrane* m) { return cd_membrane_enable_field(m, CD_WIND); }
static cd_status no_winds(cd_membrane* m) { return cd_membrane_disable_field(m, CD_WIND); }
static cd_status air(cd_membrane* m) { return cd_membrane_set_air(m, 0.125, 1); }
static cd_status no_air(cd_membrane* m) { return cd_membrane_set_air(m, 0, 0); }
static cd_status one_collider(cd_membrane* m) { return cd_membrane_set_colliders(m, 1); }
static cd_status colliders(cd_membrane* m) { return cd_membrane_set_colliders(m, 6); }
static cd_status no_colliders(cd_membrane* m) { return cd_membrane_set_colliders(m, 0); }
static cd_status ball(cd_membrane* m) { return cd_membrane_set_capsule(m, 0, target, target, COMPONENTS, 0.5, 1); }
static const double hills[6] = {-9, -8, -9, -8, -9, -8};
static cd_status bed(cd_membrane* m) {
    return cd_membrane_set_bed(m, 0, target, COMPONENTS, 3, 2, 1, 1, hills, 6, 0);
}
static cd_status smaller_bed(cd_membrane* m) {
    return cd_membrane_set_bed(m, 0, target, COMPONENTS, 2, 2, 1, 1, hills, 4, 0);
}
static cd_status callback(cd_membrane* m) { return cd_membrane_set_callback(m, 0, &nothing_near, target, COMPONENTS, 0); }
static cd_status no_ball(cd_membrane* m) { return cd_membrane_remove_collider(m, 0); }
static cd_status shear(cd_membrane* m) { return cd_membrane_set_shear(m, 50); }
static cd_status tears(cd_membrane* m) { return cd_membrane_set_breaking_strain(m, 9); }
static cd_status tears_u(cd_membrane* m) { return cd_membrane_enable_field(m, CD_BREAKING_STRAIN_U); }
static cd_status no_tears_v(cd_membrane* m) { return cd_membrane_disable_field(m, CD_BREAKING_STRAIN_V); }
static cd_status no_mass(cd_membrane* m) { return cd_membrane_disable_field(m, CD_MASS); }
static cd_status no_pins(cd_membrane* m) { return cd_membrane_disable_field(m, CD_PIN); }
static cd_status attach(cd_membrane* m) { return cd_membrane_attach(m, 2, 2, 5, 1, target, COMPONENTS); }
static cd_status load(cd_membrane* m) { return cd_membrane_load(m, bytes, size); }
static cd_status load_cloth(cd_membrane* m) { return cd_membrane_load(m, sail_bytes, sail_size); }
static cd_status copy(cd_membrane* m) { return cd_membrane_copy_state(m, source); }
static cd_status copy_cloth(cd_membrane* m) { return cd_membrane_copy_state(m, sail); }
static cd_status step(cd_membrane* m) { return cd_membrane_step(m, 0.001, 3); }
static cd_status reset(cd_membrane* m) { return cd_membrane_reset(m); }
static cd_status impulse(cd_membrane* m) { return cd_membrane_impulse(m, 3, 2, 2.5, target, COMPONENTS); }

static const struct call {
    const char* name;
    cd_status (*make)(cd_membrane*);
    int never; /* never allocates, in any scene */
} calls[] = {{"set_method", stiff, 0},         {"set_method explicit", explicit_method, 0},
             {"set_solver coupled", coupled, 0}, {"set_solver alternating", alternating, 0},
             {"set_bend", bend, 0},            {"set_bend 0", no_bend, 0},
             {"set_pressure", pressure, 0},    {"set_pressure 0", no_pressure, 0},
             {"set_ring", ring, 0},            {"set_ring 0", no_ring, 0},
             {"set_edge", edge, 0},            {"set_edge matched", matched, 0},
             {"enable force", force, 0},       {"enable mass", mass, 0},
             {"enable stiffness u", along_u, 0}, {"enable stiffness v", along_v, 0},
             {"enable pin", pins, 0},          {"enable mask", masks, 0},
             {"enable target", targets, 0},    {"disable mass", no_mass, 0},
             {"disable pin", no_pins, 0},      {"attach", attach, 0},
             {"load", load, 0},                {"copy_state", copy, 0},
             {"load cloth", load_cloth, 0},    {"copy cloth", copy_cloth, 0},
             {"set_rest_length", lengths, 0},  {"set_rest_length 0", no_lengths, 0},
             {"enable rest length u", lengths_u, 0}, {"disable rest length v", no_lengths_v, 0},
             {"enable wind", winds, 0},        {"disable wind", no_winds, 0},
             {"set_air", air, 0},              {"set_air 0", no_air, 0},
             {"set_colliders 1", one_collider, 0}, {"set_colliders 6", colliders, 0},
             {"set_colliders 0", no_colliders, 0}, {"set_capsule", ball, 0},
             {"set_bed", bed, 0},              {"set_bed, smaller", smaller_bed, 0},
             {"set_callback", callback, 0},    {"set_breaking_strain", tears, 0},
             {"enable breaking strain u", tears_u, 0}, {"disable breaking strain v", no_tears_v, 0},
             {"remove_collider", no_ball, 0},  {"set_shear", shear, 1},
             {"step", step, 1},                {"reset", reset, 1},
             {"impulse", impulse, 1}};

/* As it is: nothing on. */
static void nothing(cd_membrane* m) { cloth_lay_out(m, 0.1); }

/* Explicit: no factorization is held. */
static void unfactored(cd_membrane* m) {
    nothing(m);
    ok(cd_membrane_set_method(m, CD_METHOD_FORWARD_EULER));
}

static const struct cloth_scene beginnings[] = {{"nothing", nothing}, {"unfactored", unfactored},
                                                {"drum", cloth_drum}, {"flag", cloth_flag},
                                                {"plate", cloth_plate}, {"tube", cloth_tube},
                                                {"torn", cloth_torn}, {"everything", cloth_everything_tube},
                                                {"sail", cloth_sail}, {"lengths", cloth_lengths_tube}};

static int set_up(void** state) {
    (void)state;
    source = cloth(NU, NV, COMPONENTS, CD_FLOAT64);
    cloth_everything(source);
    ok(cd_membrane_step(source, 0.001, 3));
    ok(cd_membrane_save(source, bytes, sizeof bytes, &size));
    sail = cloth(NU, NV, COMPONENTS, CD_FLOAT64);
    cloth_lengths(sail);
    ok(cd_membrane_step(sail, 0.001, 3));
    ok(cd_membrane_save(sail, sail_bytes, sizeof sail_bytes, &sail_size));
    return 0;
}

static int tear_down(void** state) {
    (void)state;
    cd_membrane_destroy(source);
    cd_membrane_destroy(sail);
    return 0;
}

static cd_membrane* begin(struct heap* heap, const struct cloth_scene* beginning) {
    const cd_allocator allocator = heap_allocator(heap);
    cd_membrane* m = cloth_from(&allocator, NU, NV, COMPONENTS, CD_FLOAT64);
    beginning->build(m);
    ok(cd_membrane_step(m, 0.001, 2));
    return m;
}

/* Steps that a membrane makes, if it can: cloth has not every method, and no matched edge. */
static void go_on(cd_membrane* m, size_t count) {
    double length[2];
    ok(cd_membrane_get_rest_length(m, &length[0], &length[1]));
    const cd_status status = cd_membrane_step(m, 0.001, count);
    if (length[0] == 0 || status != CD_ERROR_UNSUPPORTED) ok(status);
}

static void assert_accounts_for(const cd_membrane* m, const struct heap* heap) {
    size_t held;
    ok(cd_membrane_get_memory(m, &held));
    assert_int_equal(held, heap->live_bytes);
    assert_int_equal(heap->mistakes, 0);
}

/* The hash after the call and some steps, when memory does not run out; and how often the call asks for it. */
static uint64_t undisturbed(const struct cloth_scene* beginning, const struct call* call, cd_status* out_status,
                            size_t* out_asked) {
    struct heap heap = {0};
    cd_membrane* m = begin(&heap, beginning);
    heap_fail(&heap, 0, false);
    *out_status = call->make(m);
    *out_asked = heap.asked;
    assert_accounts_for(m, &heap);
    go_on(m, 4);
    const uint64_t hash = hash_of(m);
    cd_membrane_destroy(m);
    heap_free(&heap);
    return hash;
}

static void a_refused_allocation_changes_nothing_and_the_membrane_still_works(void** state) {
    (void)state;
    size_t refused = 0;
    for (size_t b = 0; b < COUNT(beginnings); ++b) {
        for (size_t i = 0; i < COUNT(calls); ++i) {
            cd_status wanted;
            size_t asked;
            const uint64_t after = undisturbed(&beginnings[b], &calls[i], &wanted, &asked);
            if (calls[i].never) assert_int_equal(asked, 0);
            for (int for_good = 0; for_good <= 1; ++for_good) {
                for (size_t at = 1; at <= asked; ++at) {
                    struct heap heap = {0};
                    cd_membrane* m = begin(&heap, &beginnings[b]);
                    const uint64_t before = hash_of(m);
                    const size_t live = heap.live_bytes, blocks = heap.live_blocks;
                    heap_fail(&heap, at, for_good);
                    const cd_status status = calls[i].make(m);
                    if (status != CD_ERROR_MEMORY)
                        fail_msg("%s, %s, request %zu refused: %s", beginnings[b].name, calls[i].name, at,
                                 cd_status_name(status));
                    assert_true(heap.refused > 0);
                    ++refused;
                    assert_non_null(strstr(cd_error_message(), "cd_membrane_"));
                    assert_int_equal(hash_of(m), before);
                    assert_int_equal(heap.live_bytes, live);
                    assert_int_equal(heap.live_blocks, blocks);
                    assert_accounts_for(m, &heap);
                    heap_fail(&heap, 0, false); /* memory is back: the same call now does what it always did */
                    assert_int_equal(calls[i].make(m), wanted);
                    go_on(m, 4);
                    assert_int_equal(hash_of(m), after);
                    assert_accounts_for(m, &heap);
                    cd_membrane_destroy(m);
                    heap_free(&heap);
                }
            }
        }
    }
    assert_true(refused > 100);
}

static void a_membrane_steps_on_as_before_after_a_refused_call(void** state) {
    (void)state;
    for (size_t b = 0; b < COUNT(beginnings); ++b) {
        struct heap heap = {0}, calm = {0};
        cd_membrane* m = begin(&heap, &beginnings[b]);
        cd_membrane* undisturbed_one = begin(&calm, &beginnings[b]);
        for (size_t i = 0; i < COUNT(calls); ++i) {
            if (calls[i].never) continue;
            cd_membrane* copy_of = cloth(NU, NV, COMPONENTS, CD_FLOAT64);
            ok(cd_membrane_copy_state(copy_of, m));
            heap_fail(&heap, 1, true);
            const cd_status status = calls[i].make(m);
            const size_t asked = heap.asked;
            heap_fail(&heap, 0, false);
            assert_int_equal(status == CD_ERROR_MEMORY, asked > 0);
            if (asked == 0) ok(cd_membrane_copy_state(m, copy_of)); /* needed none: take it back */
            cd_membrane_destroy(copy_of);
        }
        ok(cd_membrane_step(m, 0.001, 20));
        ok(cd_membrane_step(undisturbed_one, 0.001, 20));
        assert_int_equal(hash_of(m), hash_of(undisturbed_one));
        cd_membrane_destroy(m);
        cd_membrane_destroy(undisturbed_one);
        heap_free(&heap);
        heap_free(&calm);
    }
}

static void a_create_that_runs_out_of_memory_gives_all_of_it_back(void** state) {
    (void)state;
    for (cd_precision precision = CD_FLOAT32; precision <= CD_FLOAT64; ++precision) {
        struct heap heap = {0};
        const cd_allocator allocator = heap_allocator(&heap);
        cd_membrane* m = NULL;
        heap_fail(&heap, 0, false);
        ok(cd_membrane_create(NU, NV, COMPONENTS, precision, &allocator, &m));
        const size_t asked = heap.asked;
        assert_true(asked > 0);
        assert_accounts_for(m, &heap);
        cd_membrane_destroy(m);
        for (int for_good = 0; for_good <= 1; ++for_good) {
            for (size_t at = 1; at <= asked; ++at) {
                heap_fail(&heap, at, for_good);
                refuses(NULL, cd_membrane_create(NU, NV, COMPONENTS, precision, &allocator, &out.membrane),
                        CD_ERROR_MEMORY, "");
                assert_int_equal(heap.live_bytes, 0);
                assert_int_equal(heap.live_blocks, 0);
            }
        }
        heap_fail(&heap, asked + 1, true);
        ok(cd_membrane_create(NU, NV, COMPONENTS, precision, &allocator, &m));
        cd_membrane_destroy(m);
        heap_free(&heap);
    }
}

static void the_memory_told_is_the_memory_held(void** state) {
    (void)state;
    for (size_t scene = 0; scene < CLOTHS + LENGTH_CLOTHS; ++scene) {
        const int has_lengths = scene >= CLOTHS;
        for (cd_precision precision = CD_FLOAT32; precision <= CD_FLOAT64; ++precision) {
            struct heap heap = {0};
            const cd_allocator allocator = heap_allocator(&heap);
            const size_t components = has_lengths ? 3 : 1 + scene % 4;
            cd_membrane* m = cloth_from(&allocator, 5 + scene, 17 - scene, components, precision);
            assert_accounts_for(m, &heap);
            if (has_lengths) length_cloths[scene - CLOTHS].build(m);
            else cloths[scene].build(m);
            assert_accounts_for(m, &heap);
            for (cd_method method = CD_METHOD_STIFF_SECOND; method >= CD_METHOD_IMPLICIT; --method) {
                for (cd_solver solver = CD_SOLVER_AUTO; solver >= CD_SOLVER_ALTERNATING; --solver) {
                    ok(cd_membrane_set_method(m, method));
                    ok(cd_membrane_set_solver(m, solver));
                    assert_accounts_for(m, &heap);
                    if (!has_lengths || method == CD_METHOD_IMPLICIT) ok(cd_membrane_step(m, 0.0001, 2));
                    assert_accounts_for(m, &heap);
                }
            }
            for (int on = 1; on >= 0; --on) {
                for (cd_field field = CD_BREAKING_STRAIN_U; has_lengths && field <= CD_BREAKING_STRAIN_V; ++field) {
                    ok(on ? cd_membrane_enable_field(m, field) : cd_membrane_disable_field(m, field));
                    assert_accounts_for(m, &heap);
                }
                for (cd_field field = CD_FORCE; field <= (has_lengths ? CD_REST_LENGTH_V : CD_MASK); ++field) {
                    if (field == CD_STIFFNESS || field == CD_BEND) continue;
                    if (field > CD_MASK && field != CD_WIND && field < CD_REST_LENGTH_U) continue;
                    ok(on ? cd_membrane_enable_field(m, field) : cd_membrane_disable_field(m, field));
                    assert_accounts_for(m, &heap);
                    ok(cd_membrane_step(m, 0.0001, 1));
                }
                if (has_lengths) ok(cd_membrane_set_colliders(m, on ? 9 : 0));
                assert_accounts_for(m, &heap);
            }
            if (has_lengths) ok(cd_membrane_set_rest_length(m, 0, 0));
            assert_accounts_for(m, &heap);
            cd_membrane_destroy(m);
            heap_free(&heap);
        }
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_refused_allocation_changes_nothing_and_the_membrane_still_works),
        cmocka_unit_test(a_membrane_steps_on_as_before_after_a_refused_call),
        cmocka_unit_test(a_create_that_runs_out_of_memory_gives_all_of_it_back),
        cmocka_unit_test(the_memory_told_is_the_memory_held),
    };
    return cmocka_run_group_tests(tests, set_up, tear_down);
}
