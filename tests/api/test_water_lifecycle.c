/* Making and releasing waters, what a new one is, and what its getters tell. */
#include <math.h>
#include <string.h>

#include "check.h"
#include "heap.h"
#include "pool.h"

static void a_water_tells_the_shape_it_was_given(void** state) {
    (void)state;
    static const struct {
        size_t nx, ny;
        double dx, dy;
        cd_precision precision;
    } shapes[] = {{1, 1, 1, 1, CD_FLOAT32},        {1, 9, 0.5, 3, CD_FLOAT64},    {9, 1, 1e-30, 1e30, CD_FLOAT32},
                  {2, 2, 1e30, 1e-30, CD_FLOAT64}, {7, 3, 0.1, 0.2, CD_FLOAT64},  {3, 12, 7, 0.3, CD_FLOAT32},
                  {255, 511, 2, 2, CD_FLOAT64},    {1023, 63, 10, 20, CD_FLOAT32}};
    for (size_t i = 0; i < COUNT(shapes); ++i) {
        cd_water* w = NULL;
        ok(cd_water_create(shapes[i].nx, shapes[i].ny, shapes[i].dx, shapes[i].dy, shapes[i].precision, NULL, &w));
        size_t nx, ny;
        double dx, dy;
        cd_precision precision;
        ok(cd_water_get_shape(w, &nx, &ny, &dx, &dy, &precision));
        assert_int_equal(nx, shapes[i].nx);
        assert_int_equal(ny, shapes[i].ny);
        assert_true(dx == shapes[i].dx && dy == shapes[i].dy);
        assert_int_equal(precision, shapes[i].precision);
        ok(cd_water_step(w, 0.01, 2));
        cd_water_destroy(w);
    }
}

static double number_of(cd_status (*get)(const cd_water*, double*), const cd_water* w) {
    double number = -77;
    ok(get(w, &number));
    return number;
}

static int32_t enum_of(cd_status (*get)(const cd_water*, int32_t*), const cd_water* w) {
    int32_t number = -77;
    ok(get(w, &number));
    return number;
}

static uint64_t count_of(cd_status (*get)(const cd_water*, uint64_t*), const cd_water* w) {
    uint64_t number = 77;
    ok(get(w, &number));
    return number;
}

static void a_new_water_has_the_defaults_of_the_header(void** state) {
    (void)state;
    for (cd_precision precision = CD_FLOAT32; precision <= CD_FLOAT64; ++precision) {
        cd_water* w = pool(4, 3, precision);
        assert_int_equal(enum_of(cd_water_get_method, w), CD_METHOD_IMPLICIT);
        assert_int_equal(enum_of(cd_water_get_momentum, w), CD_MOMENTUM_LINEAR);
        assert_int_equal(enum_of(cd_water_get_bed_rule, w), CD_BED_LIFTS_WATER);
        assert_int_equal(enum_of(cd_water_get_first, w), 0);
        assert_true(number_of(cd_water_get_lambda, w) == 0.55);
        assert_true(number_of(cd_water_get_gravity, w) == 9.81);
        assert_true(number_of(cd_water_get_density, w) == 1000);
        assert_true(number_of(cd_water_get_drag, w) == 0);
        assert_true(number_of(cd_water_get_manning, w) == 0);
        assert_true(number_of(cd_water_get_time, w) == 0);
        assert_true(number_of(cd_water_get_volume, w) == 0);
        assert_true(number_of(cd_water_get_wet_area, w) == 0);
        assert_true(number_of(cd_water_stable_dt, w) == INFINITY);
        assert_int_equal(count_of(cd_water_get_steps, w), 0);
        assert_int_equal(count_of(cd_water_get_factorizations, w), 0);
        double a = -1, b = -1, account[4] = {-1, -1, -1, -1};
        uint64_t cells = 77;
        ok(cd_water_get_limited(w, &cells, &a));
        assert_true(a == 0 && cells == 0);
        ok(cd_water_get_energy(w, &a, &b));
        assert_true(a == 0 && b == 0);
        ok(cd_water_get_courant(w, 5, &a));
        assert_true(a == 0);
        ok(cd_water_get_account(w, &account[0], &account[1], &account[2], &account[3]));
        for (int k = 0; k < 4; ++k) assert_true(account[k] == 0);
        for (cd_side side = CD_SIDE_X_FIRST; side <= CD_SIDE_Y_LAST; ++side) {
            cd_border kind = -1;
            ok(cd_water_get_side(w, side, &kind, &a, &b));
            assert_int_equal(kind, CD_BORDER_WALL);
            assert_true(a == 0 && b == 0);
        }
        cd_water_destroy(w);
    }
}

static void a_new_water_is_dry_at_rest_over_a_bed_at_0_and_holds_nothing_optional(void** state) {
    (void)state;
    cd_water* w = pool(4, 3, CD_FLOAT32);
    for (cd_field field = CD_DEPTH; field <= CD_VELOCITY_Y; ++field) {
        double values[5 * 4];
        memset(values, 0x33, sizeof values);
        pool_read(w, field, values);
        for (size_t k = 0; k < pool_extent(w, field).count; ++k) assert_true(values[k] == 0);
    }
    for (cd_field field = CD_SOURCE; field <= CD_WALL_Y; ++field)
        refuses(w, cd_water_read_f64(w, field, 0, 0, 1, 1, out.number, 1), CD_ERROR_DISABLED, "field");
    refuses(w, cd_water_read_f64(w, CD_MASK, 0, 0, 1, 1, out.number, 1), CD_ERROR_DISABLED, "field");
    cd_water_destroy(w);
}

static void getters_tell_what_was_set(void** state) {
    (void)state;
    cd_water* w = pool(4, 3, CD_FLOAT32);
    static const struct {
        cd_status (*set)(cd_water*, double);
        cd_status (*get)(const cd_water*, double*);
        double least, most;
    } numbers[] = {{cd_water_set_lambda, cd_water_get_lambda, 0, 1},
                   {cd_water_set_gravity, cd_water_get_gravity, 0, 1e6},
                   {cd_water_set_density, cd_water_get_density, 1e-6, 1e6},
                   {cd_water_set_drag, cd_water_get_drag, 0, 1e60},
                   {cd_water_set_manning, cd_water_get_manning, 0, 1e3}};
    for (size_t i = 0; i < COUNT(numbers); ++i) {
        ok(numbers[i].set(w, numbers[i].least));
        assert_true(number_of(numbers[i].get, w) == numbers[i].least);
        ok(numbers[i].set(w, numbers[i].most));
        assert_true(number_of(numbers[i].get, w) == numbers[i].most);
    }
    for (size_t i = 0; i < COUNT(numbers); ++i) ok(numbers[i].set(w, 0.125 * (double)(1 + i)));
    for (size_t i = 0; i < COUNT(numbers); ++i) assert_true(number_of(numbers[i].get, w) == 0.125 * (double)(1 + i));
    static const struct {
        cd_status (*set)(cd_water*, int32_t);
        cd_status (*get)(const cd_water*, int32_t*);
        int32_t last;
    } enums[] = {{cd_water_set_method, cd_water_get_method, CD_METHOD_SYMPLECTIC_EULER},
                 {cd_water_set_momentum, cd_water_get_momentum, CD_MOMENTUM_ADVECTED},
                 {cd_water_set_bed_rule, cd_water_get_bed_rule, CD_BED_KEEPS_SURFACE},
                 {cd_water_set_first, cd_water_get_first, 1}};
    for (size_t i = 0; i < COUNT(enums); ++i)
        for (int32_t value = enums[i].last; value >= 0; --value) {
            ok(enums[i].set(w, value));
            assert_int_equal(enum_of(enums[i].get, w), value);
        }
    cd_water_destroy(w);
}

static void the_momentum_sets_lambda_to_what_suits_it(void** state) {
    (void)state;
    cd_water* w = pool(4, 3, CD_FLOAT64);
    ok(cd_water_set_momentum(w, CD_MOMENTUM_ADVECTED));
    assert_true(number_of(cd_water_get_lambda, w) == 0.5);
    ok(cd_water_set_lambda(w, 0.75));
    ok(cd_water_set_momentum(w, CD_MOMENTUM_ADVECTED)); /* again: sets it again */
    assert_true(number_of(cd_water_get_lambda, w) == 0.5);
    ok(cd_water_set_lambda(w, 0.75));
    ok(cd_water_set_momentum(w, CD_MOMENTUM_LINEAR));
    assert_true(number_of(cd_water_get_lambda, w) == 0.55);
    cd_water_destroy(w);
}

static void time_counts_the_steps_and_every_step_turns_the_sweeps_round(void** state) {
    (void)state;
    cd_water* w = pool(4, 3, CD_FLOAT32);
    ok(cd_water_step(w, 0.125, 3));
    assert_int_equal(enum_of(cd_water_get_first, w), 1);
    ok(cd_water_step(w, 0.125, 5));
    assert_int_equal(enum_of(cd_water_get_first, w), 0);
    ok(cd_water_step(w, 0.5, 2));
    assert_true(number_of(cd_water_get_time, w) == 2);
    assert_int_equal(count_of(cd_water_get_steps, w), 10);
    ok(cd_water_step(w, 0.5, 1));
    ok(cd_water_reset(w));
    assert_true(number_of(cd_water_get_time, w) == 0);
    assert_int_equal(count_of(cd_water_get_steps, w), 0);
    assert_int_equal(enum_of(cd_water_get_first, w), 0);
    cd_water_destroy(w);
}

static void no_steps_and_no_time_do_nothing(void** state) {
    (void)state;
    for (size_t scene = 0; scene < POOLS; ++scene) {
        cd_water* w = pool_of(scene, 6, 5, CD_FLOAT64, 1);
        const uint64_t before = hash_of(w), solves = count_of(cd_water_get_factorizations, w);
        uint64_t cells[2];
        double volume[2];
        ok(cd_water_get_limited(w, &cells[0], &volume[0]));
        ok(cd_water_step(w, 0.1, 0));
        ok(cd_water_step(w, 0, 5));
        ok(cd_water_step(w, -0.0, 1));
        ok(cd_water_get_limited(w, &cells[1], &volume[1]));
        assert_int_equal(hash_of(w), before);
        assert_int_equal(count_of(cd_water_get_factorizations, w), solves);
        assert_true(cells[0] == cells[1] && volume[0] == volume[1]);
        cd_water_destroy(w);
    }
}

/* Each direction counts once however many lines there are, and of lines that make their step in parts the most. */
static void solves_are_counted_by_direction(void** state) {
    (void)state;
    static const struct {
        pool_build* build;
        uint64_t each; /* step */
    } wanted[] = {{pool_beach, 2}, {pool_torus, 2}, {pool_explicit, 2}, {pool_forward, 2}};
    for (size_t i = 0; i < COUNT(wanted); ++i) {
        cd_water* w = pool(6, 5, CD_FLOAT64);
        wanted[i].build(w);
        pool_step(w, 0.001, 7);
        assert_int_equal(count_of(cd_water_get_factorizations, w), 7 * wanted[i].each);
        cd_water_destroy(w);
    }
}

static void destroy_leaves_null_and_foreign_memory_alone(void** state) {
    (void)state;
    cd_water_destroy(NULL);
    _Alignas(64) unsigned char foreign[4096], before[4096];
    for (size_t i = 0; i < sizeof foreign; ++i) foreign[i] = (unsigned char)(i * 7);
    memcpy(before, foreign, sizeof foreign);
    cd_water_destroy((cd_water*)(void*)foreign);
    assert_memory_equal(foreign, before, sizeof foreign);
}

static void a_released_water_is_refused_where_its_memory_can_still_be_read(void** state) {
    (void)state;
    struct heap heap = {.keeps = true};
    const cd_allocator allocator = heap_allocator(&heap);
    cd_water* w = pool_from(&allocator, 3, 3, CD_FLOAT64);
    cd_water_destroy(w);
    assert_int_equal(heap.live_bytes, 0);
    refuses(NULL, cd_water_step(w, 0.1, 1), CD_ERROR_HANDLE, "water");
    cd_water_destroy(w); /* the heap would call a second release a mistake */
    heap_free(&heap);
}

static void the_allocator_is_copied_and_gets_everything_back(void** state) {
    (void)state;
    for (size_t scene = 0; scene < POOLS; ++scene) {
        struct heap heap = {0};
        cd_allocator allocator = heap_allocator(&heap);
        cd_water* w = pool_from(&allocator, 6, 7, CD_FLOAT32);
        memset(&allocator, 0xFF, sizeof allocator);
        pools[scene].build(w);
        pool_step(w, pools[scene].dt, 3);
        assert_true(heap.live_blocks > 0);
        cd_water_destroy(w);
        heap_free(&heap);
    }
}

static void a_failed_create_leaves_the_output_alone(void** state) {
    (void)state;
    struct heap heap = {0};
    const cd_allocator allocator = heap_allocator(&heap);
    cd_water* const mark = (cd_water*)(void*)&heap;
    cd_water* made = mark;
    assert_int_equal(cd_water_create(0, 1, 1, 1, CD_FLOAT32, &allocator, &made), CD_ERROR_VALUE);
    assert_ptr_equal(made, mark);
    heap_fail(&heap, 1, true);
    assert_int_equal(cd_water_create(1, 1, 1, 1, CD_FLOAT32, &allocator, &made), CD_ERROR_MEMORY);
    assert_ptr_equal(made, mark);
    heap_free(&heap);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_water_tells_the_shape_it_was_given),
        cmocka_unit_test(a_new_water_has_the_defaults_of_the_header),
        cmocka_unit_test(a_new_water_is_dry_at_rest_over_a_bed_at_0_and_holds_nothing_optional),
        cmocka_unit_test(getters_tell_what_was_set),
        cmocka_unit_test(the_momentum_sets_lambda_to_what_suits_it),
        cmocka_unit_test(time_counts_the_steps_and_every_step_turns_the_sweeps_round),
        cmocka_unit_test(no_steps_and_no_time_do_nothing),
        cmocka_unit_test(solves_are_counted_by_direction),
        cmocka_unit_test(destroy_leaves_null_and_foreign_memory_alone),
        cmocka_unit_test(a_released_water_is_refused_where_its_memory_can_still_be_read),
        cmocka_unit_test(the_allocator_is_copied_and_gets_everything_back),
        cmocka_unit_test(a_failed_create_leaves_the_output_alone),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
