/* Making and releasing membranes, what a new one is, and what its getters tell. */
#include <math.h>
#include <string.h>

#include "check.h"
#include "cloth.h"
#include "heap.h"

static void a_membrane_tells_the_shape_it_was_given(void** state) {
    (void)state;
    static const struct {
        size_t nu, nv, components;
        cd_precision precision;
    } shapes[] = {{0, 0, 1, CD_FLOAT32}, {1, 0, 2, CD_FLOAT64},  {0, 9, 3, CD_FLOAT32},    {1, 1, 4, CD_FLOAT64},
                  {7, 3, 4, CD_FLOAT64}, {3, 12, 1, CD_FLOAT32}, {255, 511, 3, CD_FLOAT64}};
    for (size_t i = 0; i < COUNT(shapes); ++i) {
        cd_membrane* m = cloth(shapes[i].nu, shapes[i].nv, shapes[i].components, shapes[i].precision);
        size_t nu, nv, components;
        cd_precision precision;
        ok(cd_membrane_get_shape(m, &nu, &nv, &components, &precision));
        assert_int_equal(nu, shapes[i].nu);
        assert_int_equal(nv, shapes[i].nv);
        assert_int_equal(components, shapes[i].components);
        assert_int_equal(precision, shapes[i].precision);
        ok(cd_membrane_step(m, 0.01, 2));
        cd_membrane_destroy(m);
    }
}

static double number_of(cd_status (*get)(const cd_membrane*, double*), const cd_membrane* m) {
    double number = -77;
    ok(get(m, &number));
    return number;
}

static int32_t enum_of(cd_status (*get)(const cd_membrane*, int32_t*), const cd_membrane* m) {
    int32_t number = -77;
    ok(get(m, &number));
    return number;
}

static uint64_t count_of(cd_status (*get)(const cd_membrane*, uint64_t*), const cd_membrane* m) {
    uint64_t number = 77;
    ok(get(m, &number));
    return number;
}

static void a_new_membrane_has_the_defaults_of_the_header(void** state) {
    (void)state;
    for (cd_precision precision = CD_FLOAT32; precision <= CD_FLOAT64; ++precision) {
        cd_membrane* m = NULL;
        ok(cd_membrane_create(4, 3, 3, precision, NULL, &m));
        double a = -1, b = -1, gravity[3] = {-1, -1, -1};
        int32_t ring[2] = {-1, -1};
        size_t iterations = 77;
        assert_int_equal(enum_of(cd_membrane_get_method, m), CD_METHOD_IMPLICIT);
        assert_int_equal(enum_of(cd_membrane_get_solver, m), CD_SOLVER_AUTO);
        assert_int_equal(enum_of(cd_membrane_get_mass_rule, m), CD_MASS_EQUAL);
        assert_true(number_of(cd_membrane_get_lambda, m) == 0.5);
        assert_true(number_of(cd_membrane_get_mass, m) == 1);
        assert_true(number_of(cd_membrane_get_bend, m) == 0);
        assert_true(number_of(cd_membrane_get_drag, m) == 0);
        assert_true(number_of(cd_membrane_get_stiffness_damping, m) == 0);
        assert_true(number_of(cd_membrane_get_pressure, m) == 0);
        assert_true(number_of(cd_membrane_get_time, m) == 0);
        assert_true(number_of(cd_membrane_get_volume, m) == 0);
        assert_int_equal(count_of(cd_membrane_get_steps, m), 0);
        assert_int_equal(count_of(cd_membrane_get_factorizations, m), 0);
        ok(cd_membrane_get_stiffness(m, &a, &b));
        assert_true(a == 1 && b == 1);
        ok(cd_membrane_get_tolerance(m, &a, &iterations));
        assert_true(a == 1e-6 && iterations == 100);
        ok(cd_membrane_get_convergence(m, &iterations, &a));
        assert_true(a == 0 && iterations == 0);
        ok(cd_membrane_get_gravity(m, gravity, 3));
        for (int c = 0; c < 3; ++c) assert_true(gravity[c] == 0);
        for (cd_edge edge = CD_EDGE_U_FIRST; edge <= CD_EDGE_V_LAST; ++edge) {
            cd_node kind = -1;
            ok(cd_membrane_get_edge(m, edge, &kind));
            assert_int_equal(kind, CD_NODE_FREE);
        }
        ok(cd_membrane_get_ring(m, &ring[0], &ring[1]));
        assert_true(ring[0] == 0 && ring[1] == 0);
        cloth_assert_defaults(m);
        cd_membrane_destroy(m);
    }
}

static void a_new_membrane_lies_at_rest_at_the_origin_and_holds_nothing_optional(void** state) {
    (void)state;
    enum { ALL = 5 * 4 * 3 };
    cd_membrane* m = cloth(4, 3, 3, CD_FLOAT32);
    static const cd_field optional[] = {CD_FORCE, CD_MASS, CD_PIN, CD_TARGET, CD_STIFFNESS_U, CD_STIFFNESS_V, CD_MASK};
    double values[ALL];
    for (cd_field field = CD_POSITION; field <= CD_VELOCITY; ++field) {
        memset(values, 0x33, sizeof values);
        cloth_read(m, field, values);
        for (size_t j = 0; j < ALL; ++j) assert_true(values[j] == 0);
    }
    for (size_t i = 0; i < COUNT(optional); ++i)
        refuses(m, cd_membrane_read_f64(m, optional[i], 0, 0, 1, 1, out.number, 3), CD_ERROR_DISABLED, "field");
    double energies[3] = {1, 1, 1}, momentum[3] = {1, 1, 1};
    ok(cd_membrane_get_energy(m, &energies[0], &energies[1], &energies[2]));
    ok(cd_membrane_get_momentum(m, momentum, 3));
    for (int c = 0; c < 3; ++c) assert_true(energies[c] == 0 && momentum[c] == 0);
    double stiffness = 1, damping = 1;
    ok(cd_membrane_get_attachment(m, 4, 3, &stiffness, &damping));
    assert_true(stiffness == 0 && damping == 0);
    cd_membrane_destroy(m);
}

static void getters_tell_what_was_set(void** state) {
    (void)state;
    cd_membrane* m = cloth(4, 3, 3, CD_FLOAT32);
    const double gravity[3] = {1, 2, 3};
    double a, b, told[3];
    size_t iterations;
    int32_t ring[2];
    for (cd_method method = CD_METHOD_STIFF_SECOND; method >= CD_METHOD_IMPLICIT; --method) {
        ok(cd_membrane_set_method(m, method));
        assert_int_equal(enum_of(cd_membrane_get_method, m), method);
    }
    for (cd_method method = CD_METHOD_IMPLICIT; method <= CD_METHOD_STIFF_SECOND; ++method) {
        ok(cd_membrane_set_method(m, method));
        for (cd_solver solver = CD_SOLVER_AUTO; solver >= CD_SOLVER_ALTERNATING; --solver) {
            ok(cd_membrane_set_solver(m, solver));
            assert_int_equal(enum_of(cd_membrane_get_solver, m), solver);
        }
    }
    ok(cd_membrane_set_mass_rule(m, CD_MASS_HALF_ENDS));
    assert_int_equal(enum_of(cd_membrane_get_mass_rule, m), CD_MASS_HALF_ENDS);
    static const struct {
        cd_status (*set)(cd_membrane*, double);
        cd_status (*get)(const cd_membrane*, double*);
    } numbers[] = {{cd_membrane_set_lambda, cd_membrane_get_lambda},
                   {cd_membrane_set_mass, cd_membrane_get_mass},
                   {cd_membrane_set_bend, cd_membrane_get_bend},
                   {cd_membrane_set_drag, cd_membrane_get_drag},
                   {cd_membrane_set_stiffness_damping, cd_membrane_get_stiffness_damping},
                   {cd_membrane_set_pressure, cd_membrane_get_pressure}};
    for (size_t i = 0; i < COUNT(numbers); ++i) ok(numbers[i].set(m, 0.125 * (double)(1 + i)));
    for (size_t i = 0; i < COUNT(numbers); ++i) assert_true(number_of(numbers[i].get, m) == 0.125 * (double)(1 + i));
    ok(cd_membrane_set_stiffness(m, 5, 6));
    ok(cd_membrane_get_stiffness(m, &a, &b));
    assert_true(a == 5 && b == 6);
    ok(cd_membrane_set_tolerance(m, 0.25, 7));
    ok(cd_membrane_get_tolerance(m, &a, &iterations));
    assert_true(a == 0.25 && iterations == 7);
    ok(cd_membrane_set_gravity(m, gravity, 3));
    ok(cd_membrane_get_gravity(m, told, 3));
    assert_same_bits(told, gravity, 3);
    ok(cd_membrane_set_ring(m, 0, 1));
    ok(cd_membrane_get_ring(m, &ring[0], &ring[1]));
    assert_true(ring[0] == 0 && ring[1] == 1);
    cd_membrane_destroy(m);
}

static void time_counts_the_steps(void** state) {
    (void)state;
    cd_membrane* m = cloth(4, 3, 1, CD_FLOAT32);
    ok(cd_membrane_step(m, 0.125, 3));
    ok(cd_membrane_step(m, 0.125, 5));
    ok(cd_membrane_step(m, 0.5, 2));
    assert_true(number_of(cd_membrane_get_time, m) == 2);
    assert_int_equal(count_of(cd_membrane_get_steps, m), 10);
    ok(cd_membrane_reset(m));
    assert_true(number_of(cd_membrane_get_time, m) == 0);
    assert_int_equal(count_of(cd_membrane_get_steps, m), 0);
    cd_membrane_destroy(m);
}

static void no_steps_and_no_time_do_nothing(void** state) {
    (void)state;
    cd_membrane* m = cloth(6, 5, 3, CD_FLOAT64);
    cloth_curtain(m);
    const uint64_t before = hash_of(m);
    ok(cd_membrane_step(m, 0.1, 0));
    ok(cd_membrane_step(m, 0, 5));
    ok(cd_membrane_step(m, -0.0, 1));
    assert_int_equal(hash_of(m), before);
    assert_int_equal(count_of(cd_membrane_get_factorizations, m), 0);
    cd_membrane_destroy(m);
}

static void destroy_leaves_null_and_foreign_memory_alone(void** state) {
    (void)state;
    cd_membrane_destroy(NULL);
    _Alignas(64) unsigned char foreign[4096], before[4096];
    for (size_t i = 0; i < sizeof foreign; ++i) foreign[i] = (unsigned char)(i * 7);
    memcpy(before, foreign, sizeof foreign);
    cd_membrane_destroy((cd_membrane*)(void*)foreign);
    assert_memory_equal(foreign, before, sizeof foreign);
}

static void a_released_membrane_is_refused_where_its_memory_can_still_be_read(void** state) {
    (void)state;
    struct heap heap = {.keeps = true};
    const cd_allocator allocator = heap_allocator(&heap);
    cd_membrane* m = cloth_from(&allocator, 3, 3, 1, CD_FLOAT64);
    cd_membrane_destroy(m);
    assert_int_equal(heap.live_bytes, 0);
    refuses(NULL, cd_membrane_step(m, 0.1, 1), CD_ERROR_HANDLE, "membrane");
    cd_membrane_destroy(m); /* the heap would call a second release a mistake */
    heap_free(&heap);
}

static void the_allocator_is_copied_and_gets_everything_back(void** state) {
    (void)state;
    struct heap heap = {0};
    cd_allocator allocator = heap_allocator(&heap);
    cd_membrane* m = cloth_from(&allocator, 6, 7, 3, CD_FLOAT32);
    memset(&allocator, 0xFF, sizeof allocator);
    cloth_everything(m);
    ok(cd_membrane_step(m, 0.01, 3));
    assert_true(heap.live_blocks > 0);
    cd_membrane_destroy(m);
    heap_free(&heap);
    struct heap of_cloth = {0};
    allocator = heap_allocator(&of_cloth);
    m = cloth_from(&allocator, 6, 7, 3, CD_FLOAT32);
    cloth_lengths(m);
    ok(cd_membrane_step(m, 0.01, 3));
    cd_membrane_destroy(m);
    heap_free(&of_cloth);
}

static void a_failed_create_leaves_the_output_alone(void** state) {
    (void)state;
    struct heap heap = {0};
    const cd_allocator allocator = heap_allocator(&heap);
    cd_membrane* const mark = (cd_membrane*)(void*)&heap;
    cd_membrane* made = mark;
    assert_int_equal(cd_membrane_create(1, 1, 0, CD_FLOAT32, &allocator, &made), CD_ERROR_VALUE);
    assert_ptr_equal(made, mark);
    heap_fail(&heap, 1, true);
    assert_int_equal(cd_membrane_create(1, 1, 1, CD_FLOAT32, &allocator, &made), CD_ERROR_MEMORY);
    assert_ptr_equal(made, mark);
    heap_free(&heap);
}

static void memory_grows_with_what_is_switched_on_only(void** state) {
    (void)state;
    enum { NU = 127, NV = 127, NODES = (NU + 1) * (NV + 1) };
    cd_membrane* m = cloth(NU, NV, 3, CD_FLOAT32);
    size_t plain, bytes;
    ok(cd_membrane_get_memory(m, &plain));
    assert_true(plain >= 2 * 3 * NODES * sizeof(float)); /* position and velocity */
    ok(cd_membrane_enable_field(m, CD_FORCE));
    ok(cd_membrane_get_memory(m, &bytes));
    assert_true(bytes - plain >= 3 * NODES * sizeof(float) && bytes - plain < 4 * NODES * sizeof(float));
    ok(cd_membrane_disable_field(m, CD_FORCE));
    ok(cd_membrane_set_pressure(m, 1));
    ok(cd_membrane_get_memory(m, &bytes));
    assert_true(bytes > plain);
    ok(cd_membrane_set_pressure(m, 0));
    ok(cd_membrane_set_bend(m, 1));
    ok(cd_membrane_set_bend(m, 0));
    ok(cd_membrane_get_memory(m, &bytes));
    assert_int_equal(bytes, plain);
    cd_membrane_destroy(m);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_membrane_tells_the_shape_it_was_given),
        cmocka_unit_test(a_new_membrane_has_the_defaults_of_the_header),
        cmocka_unit_test(a_new_membrane_lies_at_rest_at_the_origin_and_holds_nothing_optional),
        cmocka_unit_test(getters_tell_what_was_set),
        cmocka_unit_test(time_counts_the_steps),
        cmocka_unit_test(no_steps_and_no_time_do_nothing),
        cmocka_unit_test(destroy_leaves_null_and_foreign_memory_alone),
        cmocka_unit_test(a_released_membrane_is_refused_where_its_memory_can_still_be_read),
        cmocka_unit_test(the_allocator_is_copied_and_gets_everything_back),
        cmocka_unit_test(a_failed_create_leaves_the_output_alone),
        cmocka_unit_test(memory_grows_with_what_is_switched_on_only),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
