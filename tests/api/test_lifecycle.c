/* Making and releasing chains, what a new one is, and what every object shares: version, statuses, message. */
#include <math.h>
#include <pthread.h>
#include <stdio.h>
#include <string.h>

#include "check.h"
#include "heap.h"
#include "scene.h"

static void a_chain_tells_the_shape_it_was_given(void** state) {
    (void)state;
    static const struct {
        size_t strands, springs, components;
        cd_precision precision;
    } shapes[] = {{1, 0, 1, CD_FLOAT32}, {1, 1, 2, CD_FLOAT64},     {3, 7, 3, CD_FLOAT32},   {37, 1, 4, CD_FLOAT64},
                  {1, 0, 4, CD_FLOAT64}, {1000, 12, 1, CD_FLOAT32}, {2, 4095, 3, CD_FLOAT64}};
    for (size_t i = 0; i < COUNT(shapes); ++i) {
        cd_chain* chain = scene_chain(shapes[i].strands, shapes[i].springs, shapes[i].components, shapes[i].precision);
        size_t strands, springs, components;
        cd_precision precision;
        ok(cd_chain_get_shape(chain, &strands, &springs, &components, &precision));
        assert_int_equal(strands, shapes[i].strands);
        assert_int_equal(springs, shapes[i].springs);
        assert_int_equal(components, shapes[i].components);
        assert_int_equal(precision, shapes[i].precision);
        ok(cd_chain_get_shape(chain, NULL, NULL, NULL, NULL));
        cd_chain_destroy(chain);
    }
}

static void a_new_chain_has_the_defaults_of_the_header(void** state) {
    (void)state;
    for (cd_precision precision = CD_FLOAT32; precision <= CD_FLOAT64; ++precision) {
        cd_chain* chain = scene_chain(2, 4, 3, precision);
        cd_method method = -1;
        cd_mass_rule rule = -1;
        cd_node kind = -1;
        int32_t ring = -1;
        double number = -1, gravity[3] = {-1, -1, -1};
        uint64_t count = 99;
        ok(cd_chain_get_method(chain, &method));
        assert_int_equal(method, CD_METHOD_IMPLICIT);
        ok(cd_chain_get_lambda(chain, &number));
        assert_true(number == 0.5);
        ok(cd_chain_get_mass(chain, &number));
        assert_true(number == 1);
        ok(cd_chain_get_mass_rule(chain, &rule));
        assert_int_equal(rule, CD_MASS_EQUAL);
        ok(cd_chain_get_stiffness(chain, &number));
        assert_true(number == 1);
        ok(cd_chain_get_bend(chain, &number));
        assert_true(number == 0);
        number = -1;
        ok(cd_chain_get_drag(chain, &number));
        assert_true(number == 0);
        number = -1;
        ok(cd_chain_get_stiffness_damping(chain, &number));
        assert_true(number == 0);
        ok(cd_chain_get_gravity(chain, gravity, 3));
        for (int c = 0; c < 3; ++c) assert_true(gravity[c] == 0);
        for (cd_end end = CD_END_FIRST; end <= CD_END_LAST; ++end) {
            ok(cd_chain_get_end(chain, end, &kind));
            assert_int_equal(kind, CD_NODE_FREE);
        }
        ok(cd_chain_get_ring(chain, &ring));
        assert_int_equal(ring, 0);
        number = -1;
        ok(cd_chain_get_rest_length(chain, &number));
        assert_true(number == 0);
        number = -1;
        ok(cd_chain_get_rest_angle(chain, &number));
        assert_true(number == 0);
        ring = -1;
        ok(cd_chain_get_push(chain, &ring));
        assert_int_equal(ring, 0);
        number = 0;
        ok(cd_chain_get_strength(chain, &number));
        assert_true(isinf(number));
        size_t broken = 9;
        ok(cd_chain_get_broken(chain, &broken));
        assert_int_equal(broken, 0);
        number = -1;
        ok(cd_chain_get_thickness(chain, &number));
        assert_true(number == 0);
        size_t colliders = 9;
        ok(cd_chain_get_colliders(chain, &colliders));
        assert_int_equal(colliders, 0);
        double air[2] = {1, 1};
        ok(cd_chain_get_air(chain, &air[0], &air[1]));
        assert_true(air[0] == 0 && air[1] == 0);
        gravity[0] = gravity[1] = gravity[2] = 1;
        ok(cd_chain_get_wind(chain, gravity, 3));
        for (int c = 0; c < 3; ++c) assert_true(gravity[c] == 0);
        size_t most = 0, iterations = 9;
        ok(cd_chain_get_tolerance(chain, &number, &most));
        assert_true(number == 1e-6 && most == 200);
        ok(cd_chain_get_convergence(chain, &iterations, &number));
        assert_true(number == 0 && iterations == 0);
        number = -1;
        ok(cd_chain_get_time(chain, &number));
        assert_true(number == 0);
        ok(cd_chain_get_steps(chain, &count));
        assert_int_equal(count, 0);
        count = 99;
        ok(cd_chain_get_factorizations(chain, &count));
        assert_int_equal(count, 0);
        cd_chain_destroy(chain);
    }
}

static void a_new_chain_lies_at_rest_at_the_origin_and_holds_nothing_optional(void** state) {
    (void)state;
    cd_chain* chain = scene_chain(2, 4, 3, CD_FLOAT32);
    static const cd_field always[] = {CD_POSITION, CD_VELOCITY, CD_PIN};
    static const cd_field optional[] = {CD_FORCE, CD_MASS, CD_STIFFNESS, CD_BEND, CD_TARGET};
    double values[30], number;
    for (size_t i = 0; i < COUNT(always); ++i) {
        memset(values, 0x33, sizeof values);
        scene_read(chain, always[i], values);
        for (size_t j = 0; j < scene_field_count(chain, always[i]); ++j) assert_true(values[j] == 0);
    }
    for (size_t i = 0; i < COUNT(optional); ++i)
        refuses(chain, cd_chain_read_f64(chain, optional[i], 0, 1, 0, 1, out.number, 3), CD_ERROR_DISABLED, "field");
    for (cd_field field = CD_REST_LENGTH; field <= CD_STRAIN; ++field)
        refuses(chain, cd_chain_read_f64(chain, field, 0, 1, 0, 1, out.number, 1), CD_ERROR_UNSUPPORTED, "field");
    double kinetic = 1, elastic = 1, gravity = 1, momentum[3] = {1, 1, 1}, damping = 1;
    ok(cd_chain_get_energy(chain, &kinetic, &elastic, &gravity));
    assert_true(kinetic == 0 && elastic == 0 && gravity == 0);
    ok(cd_chain_get_momentum(chain, momentum, 3));
    for (int c = 0; c < 3; ++c) assert_true(momentum[c] == 0);
    for (size_t node = 0; node < 5; ++node) {
        number = damping = 1;
        ok(cd_chain_get_attachment(chain, 0, node, &number, &damping));
        assert_true(number == 0 && damping == 0);
    }
    cd_chain_destroy(chain);
}

static void a_single_node_falls_freely(void** state) {
    (void)state;
    for (cd_precision precision = CD_FLOAT32; precision <= CD_FLOAT64; ++precision) {
        cd_chain* chain = scene_chain(1, 0, 2, precision);
        const double gravity[2] = {0, -8};
        double limit = 0, x[2], v[2], time;
        uint64_t steps;
        ok(cd_chain_stable_dt(chain, &limit));
        assert_true(isinf(limit) && limit > 0);
        ok(cd_chain_set_gravity(chain, gravity, 2));
        ok(cd_chain_step(chain, 0.25, 8)); /* powers of two: exact in either precision; lambda = 1/2 is exact for a
                                              constant force: -8 t^2 / 2 */
        scene_read(chain, CD_POSITION, x);
        scene_read(chain, CD_VELOCITY, v);
        assert_true(x[0] == 0 && x[1] == -16 && v[0] == 0 && v[1] == -16);
        ok(cd_chain_get_time(chain, &time));
        ok(cd_chain_get_steps(chain, &steps));
        assert_true(time == 2);
        assert_int_equal(steps, 8);
        cd_chain_destroy(chain);
    }
}

static void no_steps_and_no_time_do_nothing(void** state) {
    (void)state;
    cd_chain* chain = scene_chain(2, 9, 3, CD_FLOAT64);
    const double target[3] = {1, 2, 3};
    uint64_t count;
    scene_rope(chain);
    ok(cd_chain_enable_field(chain, CD_TARGET));
    ok(cd_chain_set_end(chain, CD_END_FIRST, CD_NODE_POSED));
    ok(cd_chain_write_f64(chain, CD_TARGET, 0, 1, 0, 1, target, 3)); /* no pause goes there */
    const uint64_t before = hash_of(chain);
    ok(cd_chain_step(chain, 0.1, 0));
    ok(cd_chain_step(chain, 0, 5));
    ok(cd_chain_step(chain, -0.0, 1));
    assert_int_equal(hash_of(chain), before);
    ok(cd_chain_get_factorizations(chain, &count));
    assert_int_equal(count, 0);
    cd_chain_destroy(chain);
}

static void destroy_leaves_null_and_foreign_memory_alone(void** state) {
    (void)state;
    cd_chain_destroy(NULL);
    _Alignas(64) unsigned char foreign[4096], before[4096];
    for (size_t i = 0; i < sizeof foreign; ++i) foreign[i] = (unsigned char)(i * 7);
    memcpy(before, foreign, sizeof foreign);
    cd_chain_destroy((cd_chain*)(void*)foreign);
    assert_memory_equal(foreign, before, sizeof foreign);
}

static void a_released_chain_is_refused_where_its_memory_can_still_be_read(void** state) {
    (void)state;
    struct heap heap = {.keeps = true};
    const cd_allocator allocator = heap_allocator(&heap);
    cd_chain* chain = scene_chain_from(&allocator, 1, 3, 1, CD_FLOAT64);
    cd_chain_destroy(chain);
    assert_int_equal(heap.live_bytes, 0);
    refuses(NULL, cd_chain_step(chain, 0.1, 1), CD_ERROR_HANDLE, "chain");
    cd_chain_destroy(chain); /* the heap would call a second release a mistake */
    heap_free(&heap);
}

static void the_allocator_is_copied_and_gets_everything_back(void** state) {
    (void)state;
    struct heap heap = {0};
    cd_allocator allocator = heap_allocator(&heap);
    cd_chain* chain = scene_chain_from(&allocator, 2, 12, 3, CD_FLOAT32);
    memset(&allocator, 0xFF, sizeof allocator);
    scene_everything(chain);
    ok(cd_chain_step(chain, 0.01, 3));
    assert_true(heap.live_blocks > 0);
    cd_chain_destroy(chain);
    allocator = heap_allocator(&heap);
    chain = scene_chain_from(&allocator, 9, 12, 3, CD_FLOAT64);
    memset(&allocator, 0xFF, sizeof allocator);
    scene_lengths(chain);
    ok(cd_chain_step(chain, 0.001, 3));
    cd_chain_destroy(chain);
    heap_free(&heap);
}

static void a_failed_create_leaves_the_output_alone(void** state) {
    (void)state;
    struct heap heap = {0};
    const cd_allocator allocator = heap_allocator(&heap);
    cd_chain* const mark = (cd_chain*)(void*)&heap;
    cd_chain* made = mark;
    assert_int_equal(cd_chain_create(0, 1, 1, CD_FLOAT32, &allocator, &made), CD_ERROR_VALUE);
    assert_ptr_equal(made, mark);
    heap_fail(&heap, 1, true);
    assert_int_equal(cd_chain_create(1, 1, 1, CD_FLOAT32, &allocator, &made), CD_ERROR_MEMORY);
    assert_ptr_equal(made, mark);
    heap_free(&heap);
}

static void statuses_have_names(void** state) {
    (void)state;
    static const struct {
        cd_status status;
        const char* name;
    } names[] = {{CD_OK, "CD_OK"},
                 {CD_ERROR_NULL, "CD_ERROR_NULL"},
                 {CD_ERROR_HANDLE, "CD_ERROR_HANDLE"},
                 {CD_ERROR_VALUE, "CD_ERROR_VALUE"},
                 {CD_ERROR_ENUM, "CD_ERROR_ENUM"},
                 {CD_ERROR_RANGE, "CD_ERROR_RANGE"},
                 {CD_ERROR_SIZE, "CD_ERROR_SIZE"},
                 {CD_ERROR_MEMORY, "CD_ERROR_MEMORY"},
                 {CD_ERROR_DISABLED, "CD_ERROR_DISABLED"},
                 {CD_ERROR_UNSUPPORTED, "CD_ERROR_UNSUPPORTED"},
                 {CD_ERROR_DIVERGED, "CD_ERROR_DIVERGED"},
                 {CD_ERROR_FORMAT, "CD_ERROR_FORMAT"},
                 {CD_ERROR_MISMATCH, "CD_ERROR_MISMATCH"},
                 {CD_ERROR_TOLERANCE, "CD_ERROR_TOLERANCE"},
                 {CD_ERROR_CALLBACK, "CD_ERROR_CALLBACK"}};
    static const cd_status none[] = {-1, (cd_status)COUNT(names), 1000, INT32_MAX, INT32_MIN};
    for (size_t i = 0; i < COUNT(names); ++i) {
        assert_int_equal(names[i].status, i);
        assert_string_equal(cd_status_name(names[i].status), names[i].name);
    }
    for (size_t i = 0; i < COUNT(none); ++i) assert_string_equal(cd_status_name(none[i]), "CD_ERROR_UNKNOWN");
}

static void the_version_is_that_of_the_header(void** state) {
    (void)state;
    char text[32];
    snprintf(text, sizeof text, "%d.%d.%d", CD_VERSION_MAJOR, CD_VERSION_MINOR, CD_VERSION_PATCH);
    assert_string_equal(cd_version_string(), text);
    assert_int_equal(cd_version(), CD_VERSION_MAJOR * 1000000 + CD_VERSION_MINOR * 1000 + CD_VERSION_PATCH);
    assert_true(strlen(cd_build_info()) > 0);
    assert_null(strchr(cd_build_info(), '\n'));
}

static void* fail_on_another_thread(void* result) {
    static char first[8];
    strncpy(first, cd_error_message(), sizeof first - 1);
    cd_chain_get_mass(NULL, NULL);
    *(const char**)result = first;
    return strncmp(cd_error_message(), "cd_chain_get_mass:", 18) == 0 ? result : NULL;
}

static void each_thread_has_its_own_message_and_success_leaves_it(void** state) {
    (void)state;
    cd_chain* chain = scene_chain(1, 1, 1, CD_FLOAT32);
    assert_int_equal(cd_chain_set_mass(chain, -3), CD_ERROR_VALUE);
    char mine[256];
    snprintf(mine, sizeof mine, "%s", cd_error_message());
    assert_non_null(strstr(mine, "-3"));
    ok(cd_chain_set_mass(chain, 3));
    assert_string_equal(cd_error_message(), mine);
    pthread_t thread;
    const char* first = NULL;
    void* result = NULL;
    assert_int_equal(pthread_create(&thread, NULL, fail_on_another_thread, &first), 0);
    assert_int_equal(pthread_join(thread, &result), 0);
    assert_non_null(result);
    assert_string_equal(first, ""); /* nothing had failed there before */
    assert_string_equal(cd_error_message(), mine);
    cd_chain_destroy(chain);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_chain_tells_the_shape_it_was_given),
        cmocka_unit_test(a_new_chain_has_the_defaults_of_the_header),
        cmocka_unit_test(a_new_chain_lies_at_rest_at_the_origin_and_holds_nothing_optional),
        cmocka_unit_test(a_single_node_falls_freely),
        cmocka_unit_test(no_steps_and_no_time_do_nothing),
        cmocka_unit_test(destroy_leaves_null_and_foreign_memory_alone),
        cmocka_unit_test(a_released_chain_is_refused_where_its_memory_can_still_be_read),
        cmocka_unit_test(the_allocator_is_copied_and_gets_everything_back),
        cmocka_unit_test(a_failed_create_leaves_the_output_alone),
        cmocka_unit_test(statuses_have_names),
        cmocka_unit_test(the_version_is_that_of_the_header),
        cmocka_unit_test(each_thread_has_its_own_message_and_success_leaves_it),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
