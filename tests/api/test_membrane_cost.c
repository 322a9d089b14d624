/* What a change of a membrane costs: one factorization at the next step, and no memory. */
#include "check.h"
#include "cloth.h"
#include "heap.h"
#include "sheet.h"

enum { NU = 7, NV = 6, COMPONENTS = 3, ALL = (NU + 1) * (NV + 1) * COMPONENTS };

static uint64_t factorizations(const cd_membrane* m) {
    uint64_t count;
    ok(cd_membrane_get_factorizations(m, &count));
    return count;
}

/* Every way to change the system that a step solves. */
static void lambda(cd_membrane* m) { ok(cd_membrane_set_lambda(m, 0.9)); }
static void mass(cd_membrane* m) { ok(cd_membrane_set_mass(m, 3)); }
static void mass_rule(cd_membrane* m) { ok(cd_membrane_set_mass_rule(m, CD_MASS_EQUAL)); }
static void stiffness(cd_membrane* m) { ok(cd_membrane_set_stiffness(m, 3, 2)); }
static void bend(cd_membrane* m) { ok(cd_membrane_set_bend(m, 0.005)); }
static void drag(cd_membrane* m) { ok(cd_membrane_set_drag(m, 0.5)); }
static void damping(cd_membrane* m) { ok(cd_membrane_set_stiffness_damping(m, 0.002)); }
static void edge(cd_membrane* m) { ok(cd_membrane_set_edge(m, CD_EDGE_V_LAST, CD_NODE_PINNED)); }
static void matched(cd_membrane* m) { ok(cd_membrane_set_edge(m, CD_EDGE_V_LAST, CD_NODE_MATCHED)); }
static void pin(cd_membrane* m) { sheet_set(m, CD_PIN, 3, 3, CD_NODE_PINNED); }
static void mask(cd_membrane* m) { sheet_set(m, CD_MASK, 5, 3, 0); }
static void node_mass(cd_membrane* m) { sheet_set(m, CD_MASS, 2, 1, 9); }
static void along_u(cd_membrane* m) { sheet_set(m, CD_STIFFNESS_U, 2, 1, 9); }
static void along_v(cd_membrane* m) { sheet_set(m, CD_STIFFNESS_V, 2, 1, 9); }
static void attach(cd_membrane* m) { ok(cd_membrane_attach(m, 2, 2, 1, 1, NULL, 0)); }
static void detach(cd_membrane* m) { ok(cd_membrane_detach(m, 3, 2)); }

static const struct change {
    const char* name;
    void (*make)(cd_membrane*);
} changes[] = {{"lambda", lambda},
               {"mass", mass},
               {"mass rule", mass_rule},
               {"stiffness", stiffness},
               {"bend", bend},
               {"drag", drag},
               {"damping", damping},
               {"edge", edge},
               {"matched edge", matched},
               {"pin", pin},
               {"mask", mask},
               {"node mass", node_mass},
               {"spring along u", along_u},
               {"spring along v", along_v},
               {"attach", attach},
               {"detach", detach}};

static cd_membrane* everything(struct heap* heap, cd_solver solver) {
    const cd_allocator allocator = heap_allocator(heap);
    cd_membrane* m = cloth_from(&allocator, NU, NV, COMPONENTS, CD_FLOAT64);
    cloth_everything(m);
    ok(cd_membrane_set_solver(m, solver));
    return m;
}

static void an_unchanged_membrane_factors_once(void** state) {
    (void)state;
    for (size_t scene = 0; scene < CLOTHS; ++scene) {
        cd_membrane* m = cloth(NU, NV, COMPONENTS, CD_FLOAT32);
        cloths[scene].build(m);
        assert_int_equal(factorizations(m), 0);
        for (uint64_t i = 0; i < 3; ++i) {
            ok(cd_membrane_step(m, 0.01, 4));
            assert_int_equal(factorizations(m), 1);
        }
        cd_membrane_destroy(m);
    }
}

static void the_state_and_the_forces_are_no_change(void** state) {
    (void)state;
    struct heap heap = {0};
    cd_membrane* m = everything(&heap, CD_SOLVER_COUPLED);
    const double gravity[COMPONENTS] = {1, 2, 3};
    double values[ALL];
    static const cd_field fields[] = {CD_POSITION, CD_VELOCITY, CD_FORCE, CD_TARGET};
    ok(cd_membrane_step(m, 0.01, 1));
    for (size_t i = 0; i < COUNT(fields); ++i) {
        cloth_read(m, fields[i], values);
        cloth_write(m, fields[i], values);
    }
    ok(cd_membrane_set_gravity(m, gravity, COMPONENTS));
    ok(cd_membrane_impulse(m, 2, 2, 2, gravity, COMPONENTS));
    ok(cd_membrane_set_pressure(m, 0.5));
    ok(cd_membrane_set_tolerance(m, 1e-5, 50));
    ok(cd_membrane_reset(m));
    ok(cd_membrane_step(m, 0.01, 1));
    assert_int_equal(factorizations(m), 1);
    cd_membrane_destroy(m);
    heap_free(&heap);
}

static void each_change_costs_one_factorization_at_the_next_step_and_no_memory(void** state) {
    (void)state;
    for (cd_solver solver = CD_SOLVER_ALTERNATING; solver <= CD_SOLVER_COUPLED; ++solver) {
        for (size_t i = 0; i < COUNT(changes); ++i) {
            struct heap heap = {0};
            cd_membrane* m = everything(&heap, solver);
            ok(cd_membrane_step(m, 0.01, 2));
            const size_t allocations = heap.allocations, live = heap.live_bytes;
            changes[i].make(m);
            assert_int_equal(factorizations(m), 1);
            ok(cd_membrane_step(m, 0.01, 1));
            ok(cd_membrane_step(m, 0.01, 1));
            if (factorizations(m) != 2) fail_msg("%s: %d factorizations", changes[i].name, (int)factorizations(m));
            if (heap.allocations != allocations || heap.live_bytes != live)
                fail_msg("%s: %zu allocations", changes[i].name, heap.allocations - allocations);
            cd_membrane_destroy(m);
            heap_free(&heap);
        }
    }
}

/* A method or solver may need other memory, which it takes when it is chosen. */
static void a_change_of_method_or_solver_costs_one_factorization_and_no_memory_in_the_step(void** state) {
    (void)state;
    for (int which = 0; which < 2; ++which) {
        struct heap heap = {0};
        cd_membrane* m = everything(&heap, CD_SOLVER_ALTERNATING);
        ok(cd_membrane_step(m, 0.01, 2));
        if (which) ok(cd_membrane_set_method(m, CD_METHOD_STIFF_SECOND));
        else ok(cd_membrane_set_solver(m, CD_SOLVER_COUPLED));
        const size_t allocations = heap.allocations;
        ok(cd_membrane_step(m, 0.01, 2));
        assert_int_equal(factorizations(m), 2);
        assert_int_equal(heap.allocations, allocations);
        cd_membrane_destroy(m);
        heap_free(&heap);
    }
}

static void each_change_of_dt_costs_one_factorization(void** state) {
    (void)state;
    cd_membrane* m = cloth(NU, NV, COMPONENTS, CD_FLOAT64);
    cloth_curtain(m);
    static const double dts[] = {0.01, 0.02, 0.02, 0.01, 0.01, 0.03};
    static const uint64_t wanted[] = {1, 2, 2, 3, 3, 4};
    for (size_t i = 0; i < COUNT(dts); ++i) {
        ok(cd_membrane_step(m, dts[i], 3));
        assert_int_equal(factorizations(m), wanted[i]);
    }
    cd_membrane_destroy(m);
}

static void explicit_methods_factor_nothing(void** state) {
    (void)state;
    for (cd_method method = CD_METHOD_FORWARD_EULER; method <= CD_METHOD_SYMPLECTIC_EULER; ++method) {
        struct heap heap = {0};
        cd_membrane* m = everything(&heap, CD_SOLVER_COUPLED);
        ok(cd_membrane_set_method(m, method));
        for (size_t i = 0; i < COUNT(changes); ++i) {
            changes[i].make(m);
            ok(cd_membrane_step(m, 1e-6, 1));
        }
        assert_int_equal(factorizations(m), 0);
        cd_membrane_destroy(m);
        heap_free(&heap);
    }
}

static void steps_reads_and_writes_never_allocate(void** state) {
    (void)state;
    static unsigned char bytes[1 << 16];
    static double values[ALL];
    for (size_t scene = 0; scene < CLOTHS; ++scene) {
        for (cd_method method = CD_METHOD_IMPLICIT; method <= CD_METHOD_STIFF_SECOND; ++method) {
            struct heap heap = {0};
            const cd_allocator allocator = heap_allocator(&heap);
            cd_membrane* m = cloth_from(&allocator, NU, NV, COMPONENTS, CD_FLOAT32);
            cloths[scene].build(m);
            ok(cd_membrane_set_method(m, method));
            const size_t allocations = heap.allocations, live = heap.live_bytes;
            size_t size, written;
            for (int round = 0; round < 3; ++round) {
                ok(cd_membrane_step(m, 0.0001 * (1 + round), 3));
                for (cd_field field = CD_POSITION; field <= CD_MASK; ++field) {
                    const struct cloth_extent e = cloth_extent(m, field);
                    if (cd_membrane_read_f64(m, field, 0, 0, e.columns, e.rows, values, e.count) != CD_OK) continue;
                    cloth_write(m, field, values);
                }
                ok(cd_membrane_save_size(m, &size));
                assert_true(size <= sizeof bytes);
                ok(cd_membrane_save(m, bytes, sizeof bytes, &written));
                ok(cd_membrane_load(m, bytes, written)); /* the fields that are on already */
                hash_of(m);
            }
            assert_int_equal(heap.allocations, allocations);
            assert_int_equal(heap.live_bytes, live);
            cd_membrane_destroy(m);
            heap_free(&heap);
        }
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(an_unchanged_membrane_factors_once),
        cmocka_unit_test(the_state_and_the_forces_are_no_change),
        cmocka_unit_test(each_change_costs_one_factorization_at_the_next_step_and_no_memory),
        cmocka_unit_test(a_change_of_method_or_solver_costs_one_factorization_and_no_memory_in_the_step),
        cmocka_unit_test(each_change_of_dt_costs_one_factorization),
        cmocka_unit_test(explicit_methods_factor_nothing),
        cmocka_unit_test(steps_reads_and_writes_never_allocate),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
