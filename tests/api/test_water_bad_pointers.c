/* Null, foreign and released pointers: every pointer of every function of water.h. */
#include "check.h"
#include "cloth.h"
#include "heap.h"
#include "pool.h"
#include "refusals.h"
#include "scene.h"

enum { NX = 7, NY = 5 };

static cd_water *water, *dead;
static _Alignas(64) unsigned char foreign_bytes[8192] = {1, 2, 3};
static cd_water* const foreign = (cd_water*)(void*)foreign_bytes;
static struct heap heap = {.keeps = true};

static int set_up(void** state) {
    (void)state;
    const cd_allocator allocator = heap_allocator(&heap);
    water = pool_of(POOL_EVERYTHING, NX, NY, CD_FLOAT64, 3);
    ok(cd_water_set_hulls(water, 1, 2, 1));
    ok(cd_water_set_hull(water, 0, 100, 1, 1, NULL, 0));
    dead = pool_from(&allocator, NX, NY, CD_FLOAT64);
    cd_water_destroy(dead);
    return 0;
}

static int tear_down(void** state) {
    (void)state;
    cd_water_destroy(water);
    heap_free(&heap);
    return 0;
}

/* A function whose first argument is a water, and the arguments after it, all good. */
#define refuses_handles(function, ...)                                            \
    do {                                                                          \
        refuses(water, function(NULL, __VA_ARGS__), CD_ERROR_NULL, "water");      \
        refuses(water, function(foreign, __VA_ARGS__), CD_ERROR_HANDLE, "water"); \
        refuses(water, function(dead, __VA_ARGS__), CD_ERROR_HANDLE, "water");    \
    } while (0)

static const double numbers[8] = {0.5, 0.25};
static const float singles[8] = {0.5f, 0.25f};

static void only_a_living_water_is_taken_for_one(void** state) {
    (void)state;
    double* const n = out.number;
    refuses_handles(cd_water_get_shape, &out.size[0], &out.size[1], &n[0], &n[1], &out.i32);
    refuses_handles(cd_water_set_method, CD_METHOD_IMPLICIT);
    refuses_handles(cd_water_get_method, &out.i32);
    refuses_handles(cd_water_set_lambda, 0.75);
    refuses_handles(cd_water_get_lambda, n);
    refuses_handles(cd_water_set_momentum, CD_MOMENTUM_LINEAR);
    refuses_handles(cd_water_get_momentum, &out.i32);
    refuses_handles(cd_water_set_first, 1);
    refuses_handles(cd_water_get_first, &out.i32);
    refuses_handles(cd_water_set_parallel, NULL);
    refuses_handles(cd_water_set_kernels, CD_KERNELS_PLAIN);
    refuses_handles(cd_water_get_kernels, &out.i32);
    refuses_handles(cd_water_set_gravity, 1.5);
    refuses_handles(cd_water_get_gravity, n);
    refuses_handles(cd_water_set_density, 1.5);
    refuses_handles(cd_water_get_density, n);
    refuses_handles(cd_water_set_drag, 1.5);
    refuses_handles(cd_water_get_drag, n);
    refuses_handles(cd_water_set_manning, 0.5);
    refuses_handles(cd_water_get_manning, n);
    refuses_handles(cd_water_set_side, CD_SIDE_X_FIRST, CD_BORDER_OPEN, 1.0, 0.0);
    refuses_handles(cd_water_get_side, CD_SIDE_X_FIRST, &out.i32, &n[0], &n[1]);
    refuses_handles(cd_water_set_bed_rule, CD_BED_LIFTS_WATER);
    refuses_handles(cd_water_get_bed_rule, &out.i32);
    refuses_handles(cd_water_enable_field, CD_FORCE_X);
    refuses_handles(cd_water_disable_field, CD_FORCE_X);
    refuses_handles(cd_water_write_f32, CD_DEPTH, 0, 0, 1, 1, singles, 1);
    refuses_handles(cd_water_write_f64, CD_DEPTH, 0, 0, 1, 1, numbers, 1);
    refuses_handles(cd_water_read_f32, CD_DEPTH, 0, 0, 1, 1, out.single, 1);
    refuses_handles(cd_water_read_f64, CD_DEPTH, 0, 0, 1, 1, n, 1);
    refuses_handles(cd_water_view, CD_DEPTH, &out.pointer, &out.size[0], &out.size[1]);
    refuses_handles(cd_water_add_volume, 1.0, 1.0, 1.0, 0.5, n);
    refuses_handles(cd_water_add_volume_rectangle, 0, 0, 1, 1, 0.5, n);
    refuses_handles(cd_water_add_source, 1.0, 1.0, 1.0, 0.5);
    refuses_handles(cd_water_add_source_rectangle, 0, 0, 1, 1, 0.5);
    refuses_handles(cd_water_splash, 1.0, 1.0, 1.0, 0.5);
    refuses_handles(cd_water_impulse, 1.0, 1.0, 1.0, 0.5, 0.5);
    refuses_handles(cd_water_step, 0.01, 1);
    refuses_handles(cd_water_stable_dt, n);
    refuses_handles(cd_water_get_time, n);
    refuses_handles(cd_water_get_steps, &out.u64);
    refuses_handles(cd_water_get_factorizations, &out.u64);
    refuses_handles(cd_water_get_limited, &out.u64, n);
    refuses_handles(cd_water_get_volume, n);
    refuses_handles(cd_water_get_account, &n[0], &n[1], &n[2], &n[3]);
    refuses_handles(cd_water_get_energy, &n[0], &n[1]);
    refuses_handles(cd_water_get_wet_area, n);
    refuses_handles(cd_water_get_courant, 0.1, n);
    refuses_handles(cd_water_sample, numbers, 1, CD_OUTSIDE_REFUSED, &n[0], &n[1], &n[2], &n[5]);
    refuses_handles(cd_water_get_memory, out.size);
    refuses_handles(cd_water_set_hulls, 2, 2, 1);
    refuses_handles(cd_water_get_hulls, &out.size[0], &out.size[1], &out.size[2]);
    refuses_handles(cd_water_set_hull, 0, 1, 1, 1, numbers, 2);
    refuses_handles(cd_water_set_disc, 0, 1, 1);
    refuses_handles(cd_water_get_hull, 0, &n[0], &n[1], &n[2], &n[3], &n[4], 2);
    refuses_handles(cd_water_remove_hull, 0);
    refuses_handles(cd_water_launch_hull, 0, 1, 1, 1, 0);
    refuses_handles(cd_water_set_hull_pose, 0, numbers, 7);
    refuses_handles(cd_water_get_hull_pose, 0, n, 7);
    refuses_handles(cd_water_set_hull_velocity, 0, numbers, 6);
    refuses_handles(cd_water_get_hull_velocity, 0, n, 6);
    refuses_handles(cd_water_get_hull_floor, 0, n, 7);
    refuses_handles(cd_water_set_hull_force, 0, numbers, 6);
    refuses_handles(cd_water_get_hull_force, 0, n, 6);
    refuses_handles(cd_water_set_hull_drag, 0, 1, 1, 1);
    refuses_handles(cd_water_get_hull_drag, 0, &n[0], &n[1], &n[2]);
    refuses_handles(cd_water_get_hull_load, 0, n, 6);
    refuses_handles(cd_water_get_hull_energy, &n[0], &n[1]);
    refuses_handles(cd_water_sample_heads, numbers, 1, CD_OUTSIDE_REFUSED, n);
    refuses_handles(cd_water_hash, &out.u64);
    refuses_handles(cd_water_save_size, out.size);
    refuses_handles(cd_water_save, out.bytes, sizeof out.bytes, out.size);
    refuses_handles(cd_water_load, numbers, sizeof numbers);
    refuses_handles(cd_water_copy_state, water);
    cd_water* const none[] = {NULL, foreign, dead};
    for (size_t i = 0; i < COUNT(none); ++i) {
        const cd_status status = none[i] ? CD_ERROR_HANDLE : CD_ERROR_NULL;
        refuses(water, cd_water_reset(none[i]), status, "water");
        refuses(water, cd_water_restart_account(none[i]), status, "water");
        refuses(water, cd_water_copy_state(water, none[i]), status, "source");
    }
}

static void a_chain_or_a_membrane_is_no_water(void** state) {
    (void)state;
    cd_chain* chain = scene_chain(2, 9, 3, CD_FLOAT64);
    cd_membrane* membrane = cloth(NX, NY, 3, CD_FLOAT64);
    cd_water* const wrong[] = {(cd_water*)(void*)chain, (cd_water*)(void*)membrane};
    for (size_t i = 0; i < COUNT(wrong); ++i) {
        refuses(chain, cd_water_set_gravity(wrong[i], 2), CD_ERROR_HANDLE, "water");
        refuses(membrane, cd_water_step(wrong[i], 0.1, 1), CD_ERROR_HANDLE, "water");
        refuses(water, cd_water_copy_state(water, wrong[i]), CD_ERROR_HANDLE, "source");
        cd_water_destroy(wrong[i]); /* leaves it alive */
    }
    refuses(water, cd_chain_set_mass((cd_chain*)(void*)water, 2), CD_ERROR_HANDLE, "chain");
    refuses(water, cd_membrane_set_mass((cd_membrane*)(void*)water, 2), CD_ERROR_HANDLE, "membrane");
    hash_of(chain);
    hash_of(membrane);
    cd_chain_destroy(chain);
    cd_membrane_destroy(membrane);
}

static void no_other_pointer_may_be_null(void** state) {
    (void)state;
    const cd_allocator whole = heap_allocator(&heap);
    cd_allocator without_allocate = whole, without_release = whole;
    without_allocate.allocate = NULL;
    without_release.release = NULL;
    const cd_parallel without_run = {NULL, NULL};
    cd_water* const w = water;
    refuses(w, cd_water_create(1, 1, 1, 1, CD_FLOAT32, NULL, NULL), CD_ERROR_NULL, "out_water");
    refuses(w, cd_water_create(1, 1, 1, 1, CD_FLOAT32, &without_allocate, &out.water), CD_ERROR_NULL, "allocate");
    refuses(w, cd_water_create(1, 1, 1, 1, CD_FLOAT32, &without_release, &out.water), CD_ERROR_NULL, "release");
    refuses(w, cd_water_set_parallel(w, &without_run), CD_ERROR_NULL, "run");
    refuses(w, cd_water_get_method(w, NULL), CD_ERROR_NULL, "out_method");
    refuses(w, cd_water_get_kernels(w, NULL), CD_ERROR_NULL, "out_kernels");
    refuses(w, cd_water_get_lambda(w, NULL), CD_ERROR_NULL, "out_lambda");
    refuses(w, cd_water_get_momentum(w, NULL), CD_ERROR_NULL, "out_momentum");
    refuses(w, cd_water_get_first(w, NULL), CD_ERROR_NULL, "out_along_y");
    refuses(w, cd_water_get_gravity(w, NULL), CD_ERROR_NULL, "out_gravity");
    refuses(w, cd_water_get_density(w, NULL), CD_ERROR_NULL, "out_density");
    refuses(w, cd_water_get_drag(w, NULL), CD_ERROR_NULL, "out_drag");
    refuses(w, cd_water_get_manning(w, NULL), CD_ERROR_NULL, "out_manning");
    refuses(w, cd_water_get_bed_rule(w, NULL), CD_ERROR_NULL, "out_rule");
    refuses(w, cd_water_write_f32(w, CD_DEPTH, 0, 0, 1, 1, NULL, 1), CD_ERROR_NULL, "values");
    refuses(w, cd_water_write_f64(w, CD_DEPTH, 0, 0, 1, 1, NULL, 1), CD_ERROR_NULL, "values");
    refuses(w, cd_water_read_f32(w, CD_DEPTH, 0, 0, 1, 1, NULL, 1), CD_ERROR_NULL, "out_values");
    refuses(w, cd_water_read_f64(w, CD_DEPTH, 0, 0, 1, 1, NULL, 1), CD_ERROR_NULL, "out_values");
    refuses(w, cd_water_view(w, CD_DEPTH, NULL, &out.size[0], &out.size[1]), CD_ERROR_NULL, "out_data");
    refuses(w, cd_water_view(w, CD_DEPTH, &out.pointer, NULL, &out.size[1]), CD_ERROR_NULL, "out_x_stride");
    refuses(w, cd_water_view(w, CD_DEPTH, &out.pointer, &out.size[0], NULL), CD_ERROR_NULL, "out_y_stride");
    refuses(w, cd_water_stable_dt(w, NULL), CD_ERROR_NULL, "out_dt");
    refuses(w, cd_water_get_time(w, NULL), CD_ERROR_NULL, "out_time");
    refuses(w, cd_water_get_steps(w, NULL), CD_ERROR_NULL, "out_steps");
    refuses(w, cd_water_get_factorizations(w, NULL), CD_ERROR_NULL, "out_count");
    refuses(w, cd_water_get_volume(w, NULL), CD_ERROR_NULL, "out_volume");
    refuses(w, cd_water_get_wet_area(w, NULL), CD_ERROR_NULL, "out_area");
    refuses(w, cd_water_get_courant(w, 1, NULL), CD_ERROR_NULL, "out_courant");
    refuses(
        w,
        cd_water_sample(w, NULL, 1, CD_OUTSIDE_REFUSED, &out.number[0], &out.number[1], &out.number[2], &out.number[5]),
        CD_ERROR_NULL, "at");
    refuses(w, cd_water_get_memory(w, NULL), CD_ERROR_NULL, "out_bytes");
    double* const n = out.number;
    refuses(w, cd_water_set_hull_pose(w, 0, NULL, 7), CD_ERROR_NULL, "pose");
    refuses(w, cd_water_get_hull_pose(w, 0, NULL, 7), CD_ERROR_NULL, "out_pose");
    refuses(w, cd_water_set_hull_velocity(w, 0, NULL, 6), CD_ERROR_NULL, "velocity");
    refuses(w, cd_water_get_hull_velocity(w, 0, NULL, 6), CD_ERROR_NULL, "out_velocity");
    refuses(w, cd_water_get_hull_floor(w, 0, NULL, 7), CD_ERROR_NULL, "out_pose");
    refuses(w, cd_water_set_hull_force(w, 0, NULL, 6), CD_ERROR_NULL, "force");
    refuses(w, cd_water_get_hull_force(w, 0, NULL, 6), CD_ERROR_NULL, "out_force");
    refuses(w, cd_water_get_hull_drag(w, 0, NULL, n, n), CD_ERROR_NULL, "out_along");
    refuses(w, cd_water_get_hull_drag(w, 0, n, NULL, n), CD_ERROR_NULL, "out_across");
    refuses(w, cd_water_get_hull_drag(w, 0, n, n, NULL), CD_ERROR_NULL, "out_friction");
    refuses(w, cd_water_get_hull_load(w, 0, NULL, 6), CD_ERROR_NULL, "out_load");
    refuses(w, cd_water_sample_heads(w, NULL, 1, CD_OUTSIDE_REFUSED, n), CD_ERROR_NULL, "at");
    refuses(w, cd_water_sample_heads(w, numbers, 1, CD_OUTSIDE_REFUSED, NULL), CD_ERROR_NULL, "out_heads");
    refuses(w, cd_water_hash(w, NULL), CD_ERROR_NULL, "out_hash");
    refuses(w, cd_water_save_size(w, NULL), CD_ERROR_NULL, "out_size");
    static unsigned char buffer[1 << 16];
    refuses(w, cd_water_save(w, NULL, sizeof buffer, out.size), CD_ERROR_NULL, "buffer");
    refuses(w, cd_water_save(w, buffer, sizeof buffer, NULL), CD_ERROR_NULL, "out_written");
    refuses(w, cd_water_load(w, NULL, sizeof buffer), CD_ERROR_NULL, "bytes");
}

/* Pointers that water.h allows to be null; the drawing functions have tests of their own. */
static const char* const nullable[] = {
    "cd_water_create allocator",
    "cd_water_destroy water",
    "cd_water_get_shape out_nx",
    "cd_water_get_shape out_ny",
    "cd_water_get_shape out_dx",
    "cd_water_get_shape out_dy",
    "cd_water_get_shape out_precision",
    "cd_water_set_parallel parallel",
    "cd_water_get_side out_kind",
    "cd_water_get_side out_value",
    "cd_water_get_side out_rate",
    "cd_water_add_volume out_added",
    "cd_water_add_volume_rectangle out_added",
    "cd_water_get_limited out_cells",
    "cd_water_get_limited out_volume",
    "cd_water_get_account out_initial",
    "cd_water_get_account out_in",
    "cd_water_get_account out_out",
    "cd_water_get_account out_error",
    "cd_water_get_energy out_kinetic",
    "cd_water_get_energy out_potential",
    "cd_water_get_hulls out_count",
    "cd_water_get_hulls out_n_along",
    "cd_water_get_hulls out_n_across",
    "cd_water_set_hull heights",
    "cd_water_get_hull out_mass",
    "cd_water_get_hull out_length",
    "cd_water_get_hull out_width",
    "cd_water_get_hull out_area",
    "cd_water_get_hull out_heights",
    "cd_water_get_hull_energy out_kinetic",
    "cd_water_get_hull_energy out_potential",
    "cd_water_sample out_surface",
    "cd_water_sample out_depth",
    "cd_water_sample out_normal",
    "cd_water_sample out_velocity",
    "cd_water_write_vertices water",
    "cd_water_write_vertices buffer",
    "cd_water_get_index_count water",
    "cd_water_get_index_count out_count",
    "cd_water_write_indices water",
    "cd_water_write_indices buffer",
};

static void what_may_be_null_is_taken_as_null(void** state) {
    (void)state;
    const double at[2] = {0.25, 0.25};
    cd_water* other = pool(1, 1, CD_FLOAT32);
    ok(cd_water_get_shape(other, NULL, NULL, NULL, NULL, NULL));
    ok(cd_water_set_parallel(other, NULL));
    ok(cd_water_get_side(other, CD_SIDE_X_FIRST, NULL, NULL, NULL));
    ok(cd_water_add_volume(other, 0, 0, 0, 1, NULL));
    ok(cd_water_add_volume_rectangle(other, 0, 0, 1, 1, 1, NULL));
    ok(cd_water_get_limited(other, NULL, NULL));
    ok(cd_water_get_account(other, NULL, NULL, NULL, NULL));
    ok(cd_water_get_energy(other, NULL, NULL));
    ok(cd_water_sample(other, at, 1, CD_OUTSIDE_REFUSED, NULL, NULL, NULL, NULL));
    ok(cd_water_sample(other, NULL, 0, CD_OUTSIDE_REFUSED, NULL, NULL, NULL, NULL));
    ok(cd_water_sample_heads(other, NULL, 0, CD_OUTSIDE_REFUSED, NULL));
    ok(cd_water_get_hulls(other, NULL, NULL, NULL));
    ok(cd_water_get_hull_energy(other, NULL, NULL));
    ok(cd_water_set_hulls(other, 1, 1, 1));
    ok(cd_water_set_hull(other, 0, 1, 1, 1, NULL, 7));
    ok(cd_water_get_hull(other, 0, NULL, NULL, NULL, NULL, NULL, 7));
    ok(cd_water_write_f64(other, CD_DEPTH, 0, 0, 0, 1, NULL, 0));
    ok(cd_water_read_f32(other, CD_DEPTH, 1, 1, 0, 0, NULL, 0));
    ok(cd_water_write_indices(other, 0, NULL, 0, 4));
    cd_water_destroy(other);
    cd_water_destroy(NULL);
}

static void every_pointer_in_the_header_was_tried(void** state) {
    (void)state;
    all_pointers_were_tried("water", nullable, COUNT(nullable));
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(only_a_living_water_is_taken_for_one),  cmocka_unit_test(a_chain_or_a_membrane_is_no_water),
        cmocka_unit_test(no_other_pointer_may_be_null),          cmocka_unit_test(what_may_be_null_is_taken_as_null),
        cmocka_unit_test(every_pointer_in_the_header_was_tried),
    };
    return cmocka_run_group_tests(tests, set_up, tear_down);
}
