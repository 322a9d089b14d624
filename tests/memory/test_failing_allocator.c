/* Every allocation of every call that may allocate, refused in turn, once and for good. */
#include <string.h>

#include "check.h"
#include "heap.h"
#include "nothing_near.h"
#include "scene.h"

enum { STRANDS = 2, SPRINGS = 9, COMPONENTS = 3 };

static const double target[COMPONENTS] = {1, 2, 3};

/* Calls on a chain; `source` is another with everything on, and `bytes` is what it saves. */
static cd_chain* source;
static unsigned char bytes[1 << 16];
static size_t size;
/* The same of one whose springs have a length. */
static cd_chain* rope;
static unsigned char rope_bytes[1 << 16];
static size_t rope_size;

static cd_status method(cd_chain* c) { return cd_chain_set_method(c, CD_METHOD_STIFF_SECOND); }
static cd_status explicit_method(cd_chain* c) { return cd_chain_set_method(c, CD_METHOD_SYMPLECTIC_EULER); }
static cd_status bend(cd_chain* c) { return cd_chain_set_bend(c, 0.01); }
static cd_status no_bend(cd_chain* c) { return cd_chain_set_bend(c, 0); }
static cd_status ring(cd_chain* c) { return cd_chain_set_ring(c, 1); }
static cd_status no_ring(cd_chain* c) { return cd_chain_set_ring(c, 0); }
static cd_status force(cd_chain* c) { return cd_chain_enable_field(c, CD_FORCE); }
static cd_status mass(cd_chain* c) { return cd_chain_enable_field(c, CD_MASS); }
static cd_status stiffness(cd_chain* c) { return cd_chain_enable_field(c, CD_STIFFNESS); }
static cd_status node_bend(cd_chain* c) { return cd_chain_enable_field(c, CD_BEND); }
static cd_status targets(cd_chain* c) { return cd_chain_enable_field(c, CD_TARGET); }
static cd_status no_stiffness(cd_chain* c) { return cd_chain_disable_field(c, CD_STIFFNESS); }
static cd_status no_node_bend(cd_chain* c) { return cd_chain_disable_field(c, CD_BEND); }
static cd_status attach(cd_chain* c) { return cd_chain_attach(c, 0, 2, 5, 1, target, COMPONENTS); }
static cd_status cut(cd_chain* c) { return cd_chain_cut(c, 0, 3); }
static cd_status weld(cd_chain* c) { return cd_chain_weld(c, 0, 6); }
static cd_status length(cd_chain* c) { return cd_chain_set_rest_length(c, 0.9); }
static cd_status no_length(cd_chain* c) { return cd_chain_set_rest_length(c, 0); }
static cd_status lengths(cd_chain* c) { return cd_chain_enable_field(c, CD_REST_LENGTH); }
static cd_status no_lengths(cd_chain* c) { return cd_chain_disable_field(c, CD_REST_LENGTH); }
static cd_status tension(cd_chain* c) { return cd_chain_enable_field(c, CD_TENSION); }
static cd_status push(cd_chain* c) { return cd_chain_set_push(c, 1); }
static cd_status air(cd_chain* c) { return cd_chain_set_air(c, 0.1, 0.2); }
static cd_status winds(cd_chain* c) { return cd_chain_enable_field(c, CD_WIND); }
static cd_status no_winds(cd_chain* c) { return cd_chain_disable_field(c, CD_WIND); }
static cd_status strength(cd_chain* c) { return cd_chain_set_strength(c, 1e6); }
static cd_status strengths(cd_chain* c) { return cd_chain_enable_field(c, CD_STRENGTH); }
static cd_status no_strengths(cd_chain* c) { return cd_chain_disable_field(c, CD_STRENGTH); }
static cd_status pose_end(cd_chain* c) { return cd_chain_set_end(c, CD_END_FIRST, CD_NODE_POSED); }
static cd_status strain(cd_chain* c) { return cd_chain_enable_field(c, CD_STRAIN); }
static cd_status one_collider(cd_chain* c) { return cd_chain_set_colliders(c, 1); }
static cd_status colliders(cd_chain* c) { return cd_chain_set_colliders(c, 6); }
static cd_status no_colliders(cd_chain* c) { return cd_chain_set_colliders(c, 0); }
static cd_status ball(cd_chain* c) { return cd_chain_set_capsule(c, 0, target, target, COMPONENTS, 0.5, 1); }
static const double hills[6] = {-9, -8, -9, -8, -9, -8};
static cd_status bed(cd_chain* c) {
    return cd_chain_set_bed(c, 0, target, COMPONENTS, 3, 2, 1, 1, hills, 6, 0);
}
static cd_status smaller_bed(cd_chain* c) {
    return cd_chain_set_bed(c, 0, target, COMPONENTS, 2, 2, 1, 1, hills, 4, 0);
}
static cd_status callback(cd_chain* c) { return cd_chain_set_callback(c, 0, &nothing_near, target, COMPONENTS, 0); }
static cd_status no_ball(cd_chain* c) { return cd_chain_remove_collider(c, 0); }
static cd_status thickness(cd_chain* c) { return cd_chain_set_thickness(c, 0.01); }
static cd_status tolerance(cd_chain* c) { return cd_chain_set_tolerance(c, 1e-7, 50); }
static cd_status load_rope(cd_chain* c) { return cd_chain_load(c, rope_bytes, rope_size); }
static cd_status copy_rope(cd_chain* c) { return cd_chain_copy_state(c, rope); }
static cd_status load(cd_chain* c) { return cd_chain_load(c, bytes, size); }
static cd_status copy(cd_chain* c) { return cd_chain_copy_state(c, source); }
static cd_status step(cd_chain* c) { return cd_chain_step(c, 0.001, 3); }
static cd_status reset(cd_chain* c) { return cd_chain_reset(c); }

static const struct call {
    const char* name;
    cd_status (*make)(cd_chain*);
    int never; /* never allocates, in any scene */
} calls[] = {{"set_method", method, 0},
             {"set_method explicit", explicit_method, 0},
             {"set_bend", bend, 0},
             {"set_bend 0", no_bend, 0},
             {"set_ring 1", ring, 0},
             {"set_ring 0", no_ring, 0},
             {"enable force", force, 0},
             {"enable mass", mass, 0},
             {"enable stiffness", stiffness, 0},
             {"enable bend", node_bend, 0},
             {"enable target", targets, 0},
             {"disable stiffness", no_stiffness, 0},
             {"disable bend", no_node_bend, 0},
             {"attach", attach, 0},
             {"cut", cut, 0},
             {"weld", weld, 0},
             {"load", load, 0},
             {"copy_state", copy, 0},
             {"set_rest_length", length, 0},
             {"set_rest_length 0", no_length, 0},
             {"enable rest length", lengths, 0},
             {"disable rest length", no_lengths, 0},
             {"enable tension", tension, 1},
             {"set_push", push, 1},
             {"set_tolerance", tolerance, 1},
             {"set_air", air, 0},
             {"enable wind", winds, 0},
             {"disable wind", no_winds, 0},
             {"set_strength", strength, 0},
             {"enable strength", strengths, 0},
             {"disable strength", no_strengths, 0},
             {"enable strain", strain, 1},
             {"pose an end", pose_end, 0},
             {"set_colliders 1", one_collider, 0},
             {"set_colliders 6", colliders, 0},
             {"set_colliders 0", no_colliders, 0},
             {"set_capsule", ball, 0},
             {"set_bed", bed, 0},
             {"set_bed, smaller", smaller_bed, 0},
             {"set_callback", callback, 0},
             {"remove_collider", no_ball, 0},
             {"set_thickness", thickness, 1},
             {"load rope", load_rope, 0},
             {"copy rope", copy_rope, 0},
             {"step", step, 1},
             {"reset", reset, 1}};

/* As it is: nothing on. */
static void nothing(cd_chain* chain) { scene_lay_out(chain, 0.1); }

/* Explicit: no factorization is held. */
static void unfactored(cd_chain* chain) {
    nothing(chain);
    ok(cd_chain_set_method(chain, CD_METHOD_FORWARD_EULER));
}

static const struct scene beginnings[] = {{"nothing", nothing},       {"unfactored", unfactored},
                                          {"ring", scene_ring},       {"bent ring", scene_bent_ring},
                                          {"hair", scene_hair},       {"welded", scene_welded},
                                          {"everything", scene_everything_ring},
                                          {"lengths", scene_lengths}, {"links", scene_links}};

static int set_up(void** state) {
    (void)state;
    source = scene_chain(STRANDS, SPRINGS, COMPONENTS, CD_FLOAT64);
    scene_everything(source);
    ok(cd_chain_step(source, 0.001, 3));
    ok(cd_chain_save(source, bytes, sizeof bytes, &size));
    rope = scene_chain(STRANDS, SPRINGS, COMPONENTS, CD_FLOAT64);
    scene_lengths(rope);
    ok(cd_chain_step(rope, 0.001, 3));
    ok(cd_chain_save(rope, rope_bytes, sizeof rope_bytes, &rope_size));
    return 0;
}

static int tear_down(void** state) {
    (void)state;
    cd_chain_destroy(source);
    cd_chain_destroy(rope);
    return 0;
}

static cd_chain* begin(struct heap* heap, const struct scene* beginning) {
    const cd_allocator allocator = heap_allocator(heap);
    cd_chain* chain = scene_chain_from(&allocator, STRANDS, SPRINGS, COMPONENTS, CD_FLOAT64);
    beginning->build(chain);
    ok(cd_chain_step(chain, 0.001, 2));
    return chain;
}

/* Steps that a chain makes, if it can: a rope has no ring, and not every method. */
static void go_on(cd_chain* chain, size_t steps) {
    const cd_status status = cd_chain_step(chain, 0.001, steps);
    double length;
    ok(cd_chain_get_rest_length(chain, &length));
    if (length == 0 || (status != CD_ERROR_UNSUPPORTED && status != CD_ERROR_TOLERANCE)) ok(status);
}

static void assert_accounts_for(const cd_chain* chain, const struct heap* heap) {
    size_t held;
    ok(cd_chain_get_memory(chain, &held));
    assert_int_equal(held, heap->live_bytes);
    assert_int_equal(heap->mistakes, 0);
}

/* The hash after the call and some steps, when memory does not run out; and how often the call asks for it. */
static uint64_t undisturbed(const struct scene* beginning, const struct call* call, cd_status* out_status,
                            size_t* out_asked) {
    struct heap heap = {0};
    cd_chain* chain = begin(&heap, beginning);
    heap_fail(&heap, 0, false);
    *out_status = call->make(chain);
    *out_asked = heap.asked;
    assert_accounts_for(chain, &heap);
    go_on(chain, 4);
    const uint64_t hash = hash_of(chain);
    cd_chain_destroy(chain);
    heap_free(&heap);
    return hash;
}

static void a_refused_allocation_changes_nothing_and_the_chain_still_works(void** state) {
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
                    cd_chain* chain = begin(&heap, &beginnings[b]);
                    const uint64_t before = hash_of(chain);
                    const size_t live = heap.live_bytes, blocks = heap.live_blocks;
                    heap_fail(&heap, at, for_good);
                    const cd_status status = calls[i].make(chain);
                    if (status != CD_ERROR_MEMORY)
                        fail_msg("%s, %s, request %zu refused: %s", beginnings[b].name, calls[i].name, at,
                                 cd_status_name(status));
                    assert_true(heap.refused > 0);
                    ++refused;
                    assert_non_null(strstr(cd_error_message(), "cd_chain_"));
                    assert_int_equal(hash_of(chain), before);
                    assert_int_equal(heap.live_bytes, live);
                    assert_int_equal(heap.live_blocks, blocks);
                    assert_accounts_for(chain, &heap);
                    heap_fail(&heap, 0, false); /* memory is back: the same call now does what it always did */
                    assert_int_equal(calls[i].make(chain), wanted);
                    go_on(chain, 4);
                    assert_int_equal(hash_of(chain), after);
                    assert_accounts_for(chain, &heap);
                    cd_chain_destroy(chain);
                    heap_free(&heap);
                }
            }
        }
    }
    assert_true(refused > 100);
}

static void a_chain_steps_on_as_before_after_a_refused_call(void** state) {
    (void)state;
    for (size_t b = 0; b < COUNT(beginnings); ++b) {
        struct heap heap = {0}, calm = {0};
        cd_chain* chain = begin(&heap, &beginnings[b]);
        cd_chain* undisturbed_chain = begin(&calm, &beginnings[b]);
        heap_fail(&heap, 1, true);
        for (size_t i = 0; i < COUNT(calls); ++i) {
            if (calls[i].make == reset || calls[i].make == step) continue;
            const size_t before = heap.asked;
            cd_chain* copy_of = scene_chain(STRANDS, SPRINGS, COMPONENTS, CD_FLOAT64);
            ok(cd_chain_copy_state(copy_of, chain));
            if (calls[i].make(chain) != CD_ERROR_MEMORY) { /* needed none: take it back */
                assert_int_equal(heap.asked, before);
                heap_fail(&heap, 0, false);
                ok(cd_chain_copy_state(chain, copy_of));
                heap_fail(&heap, 1, true);
            }
            cd_chain_destroy(copy_of);
        }
        go_on(chain, 50);
        go_on(undisturbed_chain, 50);
        assert_int_equal(hash_of(chain), hash_of(undisturbed_chain));
        cd_chain_destroy(chain);
        cd_chain_destroy(undisturbed_chain);
        heap_free(&heap);
        heap_free(&calm);
    }
}

static void a_create_that_runs_out_of_memory_gives_all_of_it_back(void** state) {
    (void)state;
    for (cd_precision precision = CD_FLOAT32; precision <= CD_FLOAT64; ++precision) {
        struct heap heap = {0};
        const cd_allocator allocator = heap_allocator(&heap);
        cd_chain* chain = NULL;
        heap_fail(&heap, 0, false);
        ok(cd_chain_create(STRANDS, SPRINGS, COMPONENTS, precision, &allocator, &chain));
        const size_t asked = heap.asked;
        assert_true(asked > 0);
        assert_accounts_for(chain, &heap);
        cd_chain_destroy(chain);
        for (int for_good = 0; for_good <= 1; ++for_good) {
            for (size_t at = 1; at <= asked; ++at) {
                heap_fail(&heap, at, for_good);
                refuses(NULL, cd_chain_create(STRANDS, SPRINGS, COMPONENTS, precision, &allocator, &out.chain),
                        CD_ERROR_MEMORY, "");
                assert_int_equal(heap.live_bytes, 0);
                assert_int_equal(heap.live_blocks, 0);
            }
        }
        heap_fail(&heap, asked + 1, true);
        ok(cd_chain_create(STRANDS, SPRINGS, COMPONENTS, precision, &allocator, &chain));
        cd_chain_destroy(chain);
        heap_free(&heap);
    }
}

static bool has_field(cd_field field, bool is_rope) {
    return field <= CD_TARGET || (is_rope && field >= CD_REST_LENGTH);
}

static void the_memory_told_is_the_memory_held(void** state) {
    (void)state;
    for (size_t scene = 0; scene < SCENES + ROPE_SCENES; ++scene) {
        const bool is_rope = scene >= SCENES;
        for (cd_precision precision = CD_FLOAT32; precision <= CD_FLOAT64; ++precision) {
            struct heap heap = {0};
            const cd_allocator allocator = heap_allocator(&heap);
            const size_t components = 1 + scene % (is_rope ? 3 : 4);
            cd_chain* chain = scene_chain_from(&allocator, 1 + scene, 8 + scene, components, precision);
            assert_accounts_for(chain, &heap);
            if (is_rope) rope_scenes[scene - SCENES].build(chain);
            else scenes[scene].build(chain);
            assert_accounts_for(chain, &heap);
            for (cd_method m = CD_METHOD_STIFF_SECOND; m >= CD_METHOD_IMPLICIT; --m) {
                ok(cd_chain_set_method(chain, m));
                assert_accounts_for(chain, &heap);
                go_on(chain, 2);
                assert_accounts_for(chain, &heap);
            }
            for (cd_field field = CD_POSITION; field <= CD_STRAIN; ++field) {
                if (!has_field(field, is_rope)) continue;
                ok(cd_chain_enable_field(chain, field));
                assert_accounts_for(chain, &heap);
            }
            if (is_rope) ok(cd_chain_set_colliders(chain, 9));
            assert_accounts_for(chain, &heap);
            if (is_rope) ok(cd_chain_disable_field(chain, CD_STRENGTH));
            for (cd_field field = CD_FORCE; field <= CD_REST_LENGTH; ++field) {
                if (has_field(field, is_rope) && field != CD_PIN) ok(cd_chain_disable_field(chain, field));
                assert_accounts_for(chain, &heap);
            }
            if (is_rope) ok(cd_chain_set_stiffness(chain, 1));
            for (size_t i = 0; i < scene_nodes(chain) && is_rope; ++i) scene_set(chain, CD_PIN, i, CD_NODE_FREE);
            ok(cd_chain_set_rest_length(chain, 0));
            assert_accounts_for(chain, &heap);
            cd_chain_destroy(chain);
            heap_free(&heap);
        }
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_refused_allocation_changes_nothing_and_the_chain_still_works),
        cmocka_unit_test(a_chain_steps_on_as_before_after_a_refused_call),
        cmocka_unit_test(a_create_that_runs_out_of_memory_gives_all_of_it_back),
        cmocka_unit_test(the_memory_told_is_the_memory_held),
    };
    return cmocka_run_group_tests(tests, set_up, tear_down);
}
