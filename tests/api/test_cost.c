/* What a change costs: one factorization at the next step, and no memory. */
#include <math.h>

#include "check.h"
#include "heap.h"
#include "scene.h"

enum { STRANDS = 3, SPRINGS = 9, NODES = SPRINGS + 1, COMPONENTS = 2 };

static uint64_t factorizations(const cd_chain* chain) {
    uint64_t count;
    ok(cd_chain_get_factorizations(chain, &count));
    return count;
}

/* Every way to change the system that a step solves. */
static void lambda(cd_chain* chain) { ok(cd_chain_set_lambda(chain, 0.9)); }
static void method(cd_chain* chain) { ok(cd_chain_set_method(chain, CD_METHOD_STIFF_SECOND)); }
static void mass(cd_chain* chain) { ok(cd_chain_set_mass(chain, 3)); }
static void mass_rule(cd_chain* chain) { ok(cd_chain_set_mass_rule(chain, CD_MASS_EQUAL)); }
static void stiffness(cd_chain* chain) { ok(cd_chain_set_stiffness(chain, 3)); }
static void bend(cd_chain* chain) { ok(cd_chain_set_bend(chain, 0.005)); }
static void drag(cd_chain* chain) { ok(cd_chain_set_drag(chain, 0.5)); }
static void damping(cd_chain* chain) { ok(cd_chain_set_stiffness_damping(chain, 0.002)); }
static void end(cd_chain* chain) { ok(cd_chain_set_end(chain, CD_END_FIRST, CD_NODE_PINNED)); }
static void pin(cd_chain* chain) { scene_set(chain, CD_PIN, 2, CD_NODE_PINNED); }
static void node_mass(cd_chain* chain) { scene_set(chain, CD_MASS, 2, 9); }
static void spring_stiffness(cd_chain* chain) { scene_set(chain, CD_STIFFNESS, 2, 9); }
static void node_bend(cd_chain* chain) { scene_set(chain, CD_BEND, 2, 9); }
static void attach(cd_chain* chain) { ok(cd_chain_attach(chain, 0, 2, 1, 1, NULL, COMPONENTS)); }
static void detach(cd_chain* chain) { ok(cd_chain_detach(chain, 0, 3)); }
static void cut(cd_chain* chain) { ok(cd_chain_cut(chain, 0, 1)); }
static void weld(cd_chain* chain) { ok(cd_chain_weld(chain, 0, 5)); }

static void length(cd_chain* chain) { ok(cd_chain_set_rest_length(chain, 2)); }
static void spring_length(cd_chain* chain) { scene_set(chain, CD_REST_LENGTH, 2, 0.2); }
static void rigid(cd_chain* chain) { ok(cd_chain_set_stiffness(chain, INFINITY)); }
static void push(cd_chain* chain) { ok(cd_chain_set_push(chain, 1)); }
static void thickness(cd_chain* chain) { ok(cd_chain_set_thickness(chain, 0.002)); }
static void plane(cd_chain* chain) {
    const double low[3] = {-0.5, 0, 0}, up[3] = {1, 0, 0};
    ok(cd_chain_set_plane(chain, 2, low, up, COMPONENTS, 0.5));
}
static void no_plane(cd_chain* chain) { ok(cd_chain_remove_collider(chain, 0)); }
static void tolerance(cd_chain* chain) { ok(cd_chain_set_tolerance(chain, 1e-6, 50)); }

static const struct change {
    const char* name;
    void (*make)(cd_chain*);
} changes[] = {{"lambda", lambda},
               {"mass", mass},
               {"mass rule", mass_rule},
               {"stiffness", stiffness},
               {"bend", bend},
               {"drag", drag},
               {"damping", damping},
               {"end", end},
               {"pin", pin},
               {"node mass", node_mass},
               {"spring stiffness", spring_stiffness},
               {"node bend", node_bend},
               {"attach", attach},
               {"detach", detach},
               {"cut", cut},
               {"weld", weld}};

/* Of ropes. */
static const struct change rope_changes[] = {{"lambda", lambda},
                                             {"mass", mass},
                                             {"mass rule", mass_rule},
                                             {"stiffness", stiffness},
                                             {"drag", drag},
                                             {"end", end},
                                             {"pin", pin},
                                             {"node mass", node_mass},
                                             {"spring stiffness", spring_stiffness},
                                             {"attach", attach},
                                             {"detach", detach},
                                             {"cut", cut},
                                             {"weld", weld},
                                             {"rest length", length},
                                             {"spring length", spring_length},
                                             {"infinite stiffness", rigid},
                                             {"push", push},
                                             {"tolerance", tolerance},
                                             {"thickness", thickness},
                                             {"plane", plane},
                                             {"no plane", no_plane}};

static cd_chain* with_lengths(struct heap* heap) {
    const cd_allocator allocator = heap_allocator(heap);
    cd_chain* chain = scene_chain_from(&allocator, STRANDS, SPRINGS, COMPONENTS, CD_FLOAT64);
    scene_lengths(chain);
    return chain;
}

/* Steps of a rope are made, if not always within its tolerance. */
static void step_rope(cd_chain* chain) {
    const cd_status status = cd_chain_step(chain, 0.001, 1);
    if (status != CD_ERROR_TOLERANCE) ok(status);
}

static cd_chain* everything(struct heap* heap) {
    const cd_allocator allocator = heap_allocator(heap);
    cd_chain* chain = scene_chain_from(&allocator, STRANDS, SPRINGS, COMPONENTS, CD_FLOAT64);
    scene_everything(chain);
    return chain;
}

static void an_unchanged_chain_factors_once(void** state) {
    (void)state;
    for (size_t scene = 0; scene < SCENES; ++scene) {
        cd_chain* chain = scene_chain(STRANDS, SPRINGS, COMPONENTS, CD_FLOAT32);
        scenes[scene].build(chain);
        assert_int_equal(factorizations(chain), 0);
        for (uint64_t i = 0; i < 5; ++i) {
            ok(cd_chain_step(chain, 0.01, 10));
            assert_int_equal(factorizations(chain), 1);
        }
        cd_chain_destroy(chain);
    }
}

static void the_state_and_the_forces_are_no_change(void** state) {
    (void)state;
    struct heap heap = {0};
    cd_chain* chain = everything(&heap);
    const double gravity[COMPONENTS] = {1, 2};
    double values[STRANDS * NODES * COMPONENTS];
    static const cd_field fields[] = {CD_POSITION, CD_VELOCITY, CD_FORCE, CD_TARGET};
    ok(cd_chain_step(chain, 0.01, 1));
    for (size_t i = 0; i < COUNT(fields); ++i) {
        scene_read(chain, fields[i], values);
        scene_write(chain, fields[i], values);
    }
    ok(cd_chain_set_gravity(chain, gravity, COMPONENTS));
    ok(cd_chain_impulse(chain, 0, 2, gravity, COMPONENTS));
    ok(cd_chain_reset(chain));
    ok(cd_chain_step(chain, 0.01, 1));
    assert_int_equal(factorizations(chain), 1);
    cd_chain_destroy(chain);
    heap_free(&heap);
}

static void each_change_costs_one_factorization_at_the_next_step_and_no_memory(void** state) {
    (void)state;
    for (size_t i = 0; i < COUNT(changes); ++i) {
        struct heap heap = {0};
        cd_chain* chain = everything(&heap);
        ok(cd_chain_step(chain, 0.01, 2));
        const size_t allocations = heap.allocations, live = heap.live_bytes;
        changes[i].make(chain);
        assert_int_equal(factorizations(chain), 1);
        ok(cd_chain_step(chain, 0.01, 1));
        ok(cd_chain_step(chain, 0.01, 1));
        if (factorizations(chain) != 2) fail_msg("%s: %d factorizations", changes[i].name, (int)factorizations(chain));
        if (heap.allocations != allocations || heap.live_bytes != live)
            fail_msg("%s: %zu allocations", changes[i].name, heap.allocations - allocations);
        cd_chain_destroy(chain);
        heap_free(&heap);
    }
}

/* A rope eliminates anew in every iteration and has no factorization to keep. */
static void no_change_of_a_rope_costs_memory_or_a_factorization(void** state) {
    (void)state;
    for (size_t i = 0; i < COUNT(rope_changes); ++i) {
        struct heap heap = {0};
        cd_chain* chain = with_lengths(&heap);
        step_rope(chain);
        step_rope(chain);
        const size_t allocations = heap.allocations, live = heap.live_bytes;
        rope_changes[i].make(chain);
        step_rope(chain);
        step_rope(chain);
        assert_int_equal(factorizations(chain), 0);
        if (heap.allocations != allocations || heap.live_bytes != live)
            fail_msg("%s: %zu allocations", rope_changes[i].name, heap.allocations - allocations);
        cd_chain_destroy(chain);
        heap_free(&heap);
    }
}

/* Ropes take memory for a tension per strand and spring, and for what their steps need, and give it back. */
static void lengths_take_memory_and_give_it_back(void** state) {
    (void)state;
    enum { MANY = 64, LONG = 999 };
    struct heap heap = {0};
    const cd_allocator allocator = heap_allocator(&heap);
    cd_chain* chain = scene_chain_from(&allocator, MANY, LONG, 3, CD_FLOAT32);
    const size_t plain = heap.live_bytes;
    ok(cd_chain_set_rest_length(chain, 2));
    const size_t rope = heap.live_bytes;
    assert_true(rope > plain + MANY * LONG * sizeof(double));
    size_t allocations = heap.allocations;
    ok(cd_chain_set_rest_length(chain, 3)); /* another length costs nothing more */
    ok(cd_chain_set_push(chain, 1));
    ok(cd_chain_set_push(chain, 0));
    ok(cd_chain_enable_field(chain, CD_TENSION)); /* is on */
    assert_int_equal(heap.allocations, allocations);
    assert_int_equal(heap.live_bytes, rope);
    ok(cd_chain_enable_field(chain, CD_REST_LENGTH));
    assert_true(heap.live_bytes >= rope + MANY * LONG * sizeof(double));
    assert_true(heap.live_bytes < rope + MANY * LONG * sizeof(double) + 4096);
    ok(cd_chain_disable_field(chain, CD_REST_LENGTH));
    assert_int_equal(heap.live_bytes, rope);
    ok(cd_chain_set_air(chain, 0, 2)); /* scratch for those that are stepped at once, now from one end alone */
    assert_true(heap.live_bytes > rope && heap.live_bytes < rope + MANY * (LONG + 1) * 48 * sizeof(double));
    const size_t air = heap.live_bytes;
    ok(cd_chain_set_air(chain, 1, 3));
    assert_int_equal(heap.live_bytes, air);
    ok(cd_chain_set_air(chain, 0, 0));
    assert_int_equal(heap.live_bytes, rope);
    ok(cd_chain_enable_field(chain, CD_WIND));
    assert_true(heap.live_bytes >= rope + 3 * MANY * (LONG + 1) * sizeof(float));
    ok(cd_chain_disable_field(chain, CD_WIND));
    assert_int_equal(heap.live_bytes, rope);
    ok(cd_chain_enable_field(chain, CD_WIND));
    ok(cd_chain_set_air(chain, 1, 0));
    ok(cd_chain_enable_field(chain, CD_REST_LENGTH));
    ok(cd_chain_set_rest_length(chain, 0));
    assert_int_equal(heap.live_bytes, plain);
    allocations = heap.allocations;
    ok(cd_chain_disable_field(chain, CD_REST_LENGTH));
    assert_int_equal(heap.allocations, allocations);
    cd_chain_destroy(chain);
    heap_free(&heap);
}

static void set_colliders(cd_chain* chain) {
    const double place[3] = {1, 2, 3}, way[3] = {0, 0, 2}, velocity[3] = {4, 5, 6};
    ok(cd_chain_set_plane(chain, 0, place, way, 3, 0.5));
    ok(cd_chain_set_capsule(chain, 1, place, way, 3, 0.25, 0.75));
    ok(cd_chain_set_collider_velocity(chain, 1, velocity, 3));
}
static void assert_has_these_colliders(const cd_chain* chain, size_t count) {
    cd_shape shape;
    double first[3], second[3], velocity[3], radius, friction;
    size_t all;
    ok(cd_chain_get_colliders(chain, &all));
    assert_int_equal(all, count);
    for (size_t i = 0; i < count; ++i) {
        ok(cd_chain_get_collider(chain, i, &shape, first, second, velocity, 3, &radius, &friction));
        const bool capsule = i == 1, some = i <= 1;
        assert_int_equal(shape, i == 0 ? CD_SHAPE_PLANE : capsule ? CD_SHAPE_CAPSULE : CD_SHAPE_NONE);
        assert_true(first[0] == some && first[1] == 2 * some && first[2] == 3 * some);
        assert_true(second[0] == 0 && second[1] == 0 && second[2] == (capsule ? 2 : some));
        assert_true(velocity[0] == 4 * capsule && velocity[1] == 5 * capsule && velocity[2] == 6 * capsule);
        assert_true(radius == 0.25 * capsule && friction == (capsule ? 0.75 : 0.5 * some));
    }
}

/* Colliders take memory for what they are and for scratch, keep what they are, and give it back. */
static void colliders_take_memory_and_give_it_back(void** state) {
    (void)state;
    enum { MANY = 5, LONG = 99 };
    struct heap heap = {0};
    const cd_allocator allocator = heap_allocator(&heap);
    cd_chain* chain = scene_chain_from(&allocator, MANY, LONG, 3, CD_FLOAT32);
    const size_t plain = heap.live_bytes;
    ok(cd_chain_set_rest_length(chain, 2));
    const size_t rope = heap.live_bytes;
    ok(cd_chain_set_colliders(chain, 2));
    const size_t two = heap.live_bytes;
    assert_true(two > rope && two < rope + 2 * 8 * (LONG + 1) * 32 * sizeof(double));
    size_t allocations = heap.allocations;
    set_colliders(chain);
    ok(cd_chain_set_colliders(chain, 2));
    ok(cd_chain_set_thickness(chain, 0.125));
    assert_int_equal(heap.allocations, allocations);
    ok(cd_chain_set_colliders(chain, 5));
    assert_has_these_colliders(chain, 5);
    assert_true(heap.live_bytes > two);
    ok(cd_chain_set_colliders(chain, 1));
    assert_has_these_colliders(chain, 1);
    ok(cd_chain_set_colliders(chain, 2)); /* the second is a new one */
    ok(cd_chain_remove_collider(chain, 0));
    for (size_t i = 0; i < 2; ++i) {
        cd_shape shape;
        double numbers[3 * 3 + 2];
        ok(cd_chain_get_collider(chain, i, &shape, numbers, numbers + 3, numbers + 6, 3, numbers + 9, numbers + 10));
        assert_int_equal(shape, CD_SHAPE_NONE);
        for (size_t k = 0; k < COUNT(numbers); ++k) assert_true(numbers[k] == 0);
    }
    assert_int_equal(heap.live_bytes, two);
    set_colliders(chain);
    scene_lay_out(chain, 0.01);
    allocations = heap.allocations;
    heap_fail(&heap, 1, true);
    const cd_status status = cd_chain_step(chain, 0.01, 3);
    if (status != CD_ERROR_TOLERANCE) ok(status);
    heap_fail(&heap, 0, false);
    assert_int_equal(heap.allocations, allocations);
    assert_int_equal(heap.live_bytes, two);
    ok(cd_chain_set_colliders(chain, 0));
    assert_int_equal(heap.live_bytes, rope);
    ok(cd_chain_set_colliders(chain, 4096));
    ok(cd_chain_set_rest_length(chain, 0));
    assert_int_equal(heap.live_bytes, plain);
    cd_chain_destroy(chain);
    heap_free(&heap);
}

/* A single strand's scratch is no larger than it needs, and many strands share that of a few. */
static void a_rope_takes_no_more_scratch_than_its_tasks(void** state) {
    (void)state;
    static const size_t strands[] = {1, 8, 128, 4096};
    size_t of_step[COUNT(strands)];
    for (size_t i = 0; i < COUNT(strands); ++i) {
        size_t plain, rope;
        cd_chain* chain = scene_chain(strands[i], 99, 3, CD_FLOAT32);
        ok(cd_chain_set_method(chain, CD_METHOD_SYMPLECTIC_EULER)); /* no scratch */
        ok(cd_chain_get_memory(chain, &plain));
        ok(cd_chain_set_rest_length(chain, 1));
        ok(cd_chain_get_memory(chain, &rope));
        of_step[i] = rope - plain - strands[i] * 99 * sizeof(double) - (strands[i] - 1) * 100 - /* tensions, pins */
                     strands[i] * sizeof(double); /* the iterations of a strand's last step */
        cd_chain_destroy(chain);
    }
    assert_true(of_step[0] < 100 * 64 * sizeof(double));
    assert_true(of_step[1] < 8 * 100 * 64 * sizeof(double));
    assert_true(of_step[2] < 128 * 100 * 64 * sizeof(double));
    assert_int_equal(of_step[3], of_step[2]);
}

/* A method may need other memory, which it takes when it is chosen. */
static void a_change_of_method_costs_one_factorization_and_no_memory_in_the_step(void** state) {
    (void)state;
    struct heap heap = {0};
    cd_chain* chain = everything(&heap);
    ok(cd_chain_step(chain, 0.01, 2));
    method(chain);
    const size_t allocations = heap.allocations;
    ok(cd_chain_step(chain, 0.01, 2));
    assert_int_equal(factorizations(chain), 2);
    assert_int_equal(heap.allocations, allocations);
    cd_chain_destroy(chain);
    heap_free(&heap);
}

static void each_change_of_dt_costs_one_factorization(void** state) {
    (void)state;
    cd_chain* chain = scene_chain(STRANDS, SPRINGS, COMPONENTS, CD_FLOAT64);
    scene_rope(chain);
    static const double dts[] = {0.01, 0.02, 0.02, 0.01, 0.01, 0.03};
    static const uint64_t wanted[] = {1, 2, 2, 3, 3, 4};
    for (size_t i = 0; i < COUNT(dts); ++i) {
        ok(cd_chain_step(chain, dts[i], 3));
        assert_int_equal(factorizations(chain), wanted[i]);
    }
    cd_chain_destroy(chain);
}

static void several_changes_before_a_step_cost_one_factorization(void** state) {
    (void)state;
    struct heap heap = {0};
    cd_chain* chain = everything(&heap);
    ok(cd_chain_step(chain, 0.01, 1));
    for (size_t i = 0; i < COUNT(changes); ++i) changes[i].make(chain);
    ok(cd_chain_step(chain, 0.02, 4));
    assert_int_equal(factorizations(chain), 2);
    cd_chain_destroy(chain);
    heap_free(&heap);
}

static void explicit_methods_factor_nothing(void** state) {
    (void)state;
    for (cd_method m = CD_METHOD_FORWARD_EULER; m <= CD_METHOD_SYMPLECTIC_EULER; ++m) {
        struct heap heap = {0};
        cd_chain* chain = everything(&heap);
        ok(cd_chain_set_method(chain, m));
        ok(cd_chain_step(chain, 0.0001, 3));
        ok(cd_chain_set_stiffness(chain, 2));
        ok(cd_chain_step(chain, 0.0002, 3));
        assert_int_equal(factorizations(chain), 0);
        cd_chain_destroy(chain);
        heap_free(&heap);
    }
}

static void steps_reads_and_writes_never_allocate(void** state) {
    (void)state;
    for (size_t scene = 0; scene < SCENES + ROPE_SCENES; ++scene) {
        for (cd_method m = CD_METHOD_IMPLICIT; m <= CD_METHOD_STIFF_SECOND; ++m) {
            if (scene >= SCENES && m != CD_METHOD_IMPLICIT) continue;
            struct heap heap = {0};
            const cd_allocator allocator = heap_allocator(&heap);
            cd_chain* chain = scene_chain_from(&allocator, STRANDS, SPRINGS, COMPONENTS, CD_FLOAT32);
            if (scene < SCENES) scenes[scene].build(chain);
            else rope_scenes[scene - SCENES].build(chain);
            ok(cd_chain_set_method(chain, m));
            const size_t allocations = heap.allocations, live = heap.live_bytes;
            heap_fail(&heap, 1, true);
            double values[STRANDS * NODES * COMPONENTS];
            size_t size, written;
            static unsigned char bytes[1 << 16];
            for (int round = 0; round < 3; ++round) {
                ok(cd_chain_step(chain, 0.0001 * (1 + round), 5));
                for (cd_field field = CD_POSITION; field <= CD_TENSION; ++field) {
                    const size_t strands = scene_field_strands(chain, field), count = scene_field_count(chain, field);
                    const size_t items = scene_field_items(chain, field);
                    if (cd_chain_read_f64(chain, field, 0, strands, 0, items, values, count) != CD_OK) continue;
                    scene_write(chain, field, values);
                }
                ok(cd_chain_save_size(chain, &size));
                assert_true(size <= sizeof bytes);
                ok(cd_chain_save(chain, bytes, sizeof bytes, &written));
                ok(cd_chain_load(chain, bytes, written)); /* the fields that are on already */
                hash_of(chain);
            }
            assert_int_equal(heap.allocations, allocations);
            assert_int_equal(heap.live_bytes, live);
            cd_chain_destroy(chain);
            heap_free(&heap);
        }
    }
}

/* One strand stores each coefficient once per number: position, velocity, a row of scratch, pins, and six rows. */
static void a_plain_strand_holds_six_rows_of_coefficients(void** state) {
    (void)state;
    size_t plain;
    cd_chain* chain = scene_chain(1, 9999, 1, CD_FLOAT32);
    ok(cd_chain_get_memory(chain, &plain));
    const size_t per_node = 2 * sizeof(float) + sizeof(double) + 1 + 6 * sizeof(double);
    assert_true(plain >= 10000 * per_node && plain < 10000 * per_node + 2048);
    cd_chain_destroy(chain);
}

static void a_plain_chain_costs_no_more_than_its_state_and_one_factorization(void** state) {
    (void)state;
    size_t plain, with_field;
    cd_chain* chain = scene_chain(64, 999, 3, CD_FLOAT32);
    const size_t numbers = 64 * 1000 * 3;
    ok(cd_chain_get_memory(chain, &plain));
    const size_t state_and_scratch = numbers * (2 * sizeof(float) + sizeof(double));
    assert_true(plain >= state_and_scratch && (double)plain < (double)state_and_scratch * 1.15);
    static const cd_field shared[] = {CD_MASS, CD_STIFFNESS};
    for (size_t i = 0; i < COUNT(shared); ++i) {
        ok(cd_chain_enable_field(chain, shared[i]));
        ok(cd_chain_get_memory(chain, &with_field));
        assert_true(with_field > plain && with_field < plain + 1000 * 3 * sizeof(double) + 4096);
        plain = with_field;
    }
    cd_chain_destroy(chain);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(an_unchanged_chain_factors_once),
        cmocka_unit_test(the_state_and_the_forces_are_no_change),
        cmocka_unit_test(each_change_costs_one_factorization_at_the_next_step_and_no_memory),
        cmocka_unit_test(no_change_of_a_rope_costs_memory_or_a_factorization),
        cmocka_unit_test(lengths_take_memory_and_give_it_back),
        cmocka_unit_test(colliders_take_memory_and_give_it_back),
        cmocka_unit_test(a_rope_takes_no_more_scratch_than_its_tasks),
        cmocka_unit_test(a_change_of_method_costs_one_factorization_and_no_memory_in_the_step),
        cmocka_unit_test(each_change_of_dt_costs_one_factorization),
        cmocka_unit_test(several_changes_before_a_step_cost_one_factorization),
        cmocka_unit_test(explicit_methods_factor_nothing),
        cmocka_unit_test(steps_reads_and_writes_never_allocate),
        cmocka_unit_test(a_plain_strand_holds_six_rows_of_coefficients),
        cmocka_unit_test(a_plain_chain_costs_no_more_than_its_state_and_one_factorization),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
