/* Null, foreign and released pointers: every pointer of every function of chain.h. */
#include <string.h>

#include "check.h"
#include "heap.h"
#include "nothing_near.h"
#include "refusals.h"
#include "scene.h"

enum { STRANDS = 2, SPRINGS = 9, NODES = SPRINGS + 1, COMPONENTS = 2 };

static cd_chain *chain, *dead;
static _Alignas(64) unsigned char foreign_bytes[8192] = {1, 2, 3};
static cd_chain* const foreign = (cd_chain*)(void*)foreign_bytes;
static struct heap heap = {.keeps = true};

static int set_up(void** state) {
    (void)state;
    const cd_allocator allocator = heap_allocator(&heap);
    chain = scene_chain(STRANDS, SPRINGS, COMPONENTS, CD_FLOAT64);
    scene_everything(chain);
    dead = scene_chain_from(&allocator, STRANDS, SPRINGS, COMPONENTS, CD_FLOAT64);
    cd_chain_destroy(dead);
    return 0;
}

static int tear_down(void** state) {
    (void)state;
    cd_chain_destroy(chain);
    heap_free(&heap);
    return 0;
}

/* A function whose first argument is a chain, and the arguments after it, all good. */
#define refuses_handles(function, ...)                                                                                 \
    do {                                                                                                               \
        refuses(chain, function(NULL, __VA_ARGS__), CD_ERROR_NULL, "chain");                                           \
        refuses(chain, function(foreign, __VA_ARGS__), CD_ERROR_HANDLE, "chain");                           \
        refuses(chain, function(dead, __VA_ARGS__), CD_ERROR_HANDLE, "chain");                                         \
    } while (0)

static const double numbers[NODES * COMPONENTS] = {0.5, 0.25};
static const float singles[NODES * COMPONENTS] = {0.5f, 0.25f};

static void only_a_living_chain_is_taken_for_one(void** state) {
    (void)state;
    refuses_handles(cd_chain_get_shape, &out.size[0], &out.size[1], &out.size[2], &out.i32);
    refuses_handles(cd_chain_set_method, CD_METHOD_IMPLICIT);
    refuses_handles(cd_chain_get_method, &out.i32);
    refuses_handles(cd_chain_set_lambda, 0.75);
    refuses_handles(cd_chain_get_lambda, out.number);
    refuses_handles(cd_chain_set_parallel, NULL);
    refuses_handles(cd_chain_set_kernels, CD_KERNELS_PLAIN);
    refuses_handles(cd_chain_get_kernels, &out.i32);
    refuses_handles(cd_chain_set_mass, 1.5);
    refuses_handles(cd_chain_get_mass, out.number);
    refuses_handles(cd_chain_set_mass_rule, CD_MASS_EQUAL);
    refuses_handles(cd_chain_get_mass_rule, &out.i32);
    refuses_handles(cd_chain_set_stiffness, 1.5);
    refuses_handles(cd_chain_get_stiffness, out.number);
    refuses_handles(cd_chain_set_bend, 1.5);
    refuses_handles(cd_chain_get_bend, out.number);
    refuses_handles(cd_chain_set_drag, 1.5);
    refuses_handles(cd_chain_get_drag, out.number);
    refuses_handles(cd_chain_set_stiffness_damping, 1.5);
    refuses_handles(cd_chain_get_stiffness_damping, out.number);
    refuses_handles(cd_chain_set_gravity, numbers, COMPONENTS);
    refuses_handles(cd_chain_get_gravity, out.number, COMPONENTS);
    refuses_handles(cd_chain_set_end, CD_END_FIRST, CD_NODE_PINNED);
    refuses_handles(cd_chain_get_end, CD_END_FIRST, &out.i32);
    refuses_handles(cd_chain_set_ring, 0);
    refuses_handles(cd_chain_get_ring, &out.i32);
    refuses_handles(cd_chain_set_rest_length, 1.5);
    refuses_handles(cd_chain_get_rest_length, out.number);
    refuses_handles(cd_chain_set_push, 1);
    refuses_handles(cd_chain_get_push, &out.i32);
    refuses_handles(cd_chain_set_strength, 1);
    refuses_handles(cd_chain_get_strength, out.number);
    refuses_handles(cd_chain_get_broken, out.size);
    refuses_handles(cd_chain_get_reaction, 0, 0, out.number, COMPONENTS);
    refuses_handles(cd_chain_set_air, 1, 1);
    refuses_handles(cd_chain_get_air, out.number, out.number + 1);
    refuses_handles(cd_chain_set_wind, numbers, COMPONENTS);
    refuses_handles(cd_chain_get_wind, out.number, COMPONENTS);
    refuses_handles(cd_chain_set_tolerance, 1e-3, 10);
    refuses_handles(cd_chain_get_tolerance, out.number, out.size);
    refuses_handles(cd_chain_get_convergence, out.size, out.number);
    refuses_handles(cd_chain_set_colliders, 1);
    refuses_handles(cd_chain_get_colliders, out.size);
    refuses_handles(cd_chain_set_plane, 0, numbers, numbers, COMPONENTS, 0.5);
    refuses_handles(cd_chain_set_capsule, 0, numbers, numbers, COMPONENTS, 1, 0.5);
    refuses_handles(cd_chain_set_bed, 0, numbers, COMPONENTS, 2, 2, 1, 1, numbers, 4, 0.5);
    refuses_handles(cd_chain_get_bed, 0, out.size, out.size + 1, out.number, 0);
    refuses_handles(cd_chain_set_callback, 0, &(cd_distance){0}, numbers, COMPONENTS, 0.5);
    refuses_handles(cd_chain_remove_collider, 0);
    refuses_handles(cd_chain_set_collider_velocity, 0, numbers, COMPONENTS);
    refuses_handles(cd_chain_get_collider, 0, &out.i32, out.number, out.number + 3, out.number + 6, COMPONENTS,
                    out.number + 9, out.number + 10);
    refuses_handles(cd_chain_set_thickness, 0.5);
    refuses_handles(cd_chain_get_thickness, out.number);
    refuses_handles(cd_chain_enable_field, CD_FORCE);
    refuses_handles(cd_chain_disable_field, CD_FORCE);
    refuses_handles(cd_chain_write_f32, CD_POSITION, 0, 1, 0, 1, singles, COMPONENTS);
    refuses_handles(cd_chain_write_f64, CD_POSITION, 0, 1, 0, 1, numbers, COMPONENTS);
    refuses_handles(cd_chain_read_f32, CD_POSITION, 0, 1, 0, 1, out.single, COMPONENTS);
    refuses_handles(cd_chain_read_f64, CD_POSITION, 0, 1, 0, 1, out.number, COMPONENTS);
    refuses_handles(cd_chain_view, CD_POSITION, &out.pointer, &out.size[0], &out.size[1], &out.size[2]);
    refuses_handles(cd_chain_impulse, 0, 2, numbers, COMPONENTS);
    refuses_handles(cd_chain_teleport, 0, NULL, numbers, COMPONENTS);
    refuses_handles(cd_chain_attach, 0, 2, 1.0, 1.0, numbers, COMPONENTS);
    refuses_handles(cd_chain_detach, 0, 3);
    refuses_handles(cd_chain_get_attachment, 0, 3, &out.number[0], &out.number[1]);
    refuses_handles(cd_chain_cut, 0, 2);
    refuses_handles(cd_chain_weld, 0, 2);
    refuses_handles(cd_chain_step, 0.01, 1);
    refuses_handles(cd_chain_stable_dt, out.number);
    refuses_handles(cd_chain_get_time, out.number);
    refuses_handles(cd_chain_get_steps, &out.u64);
    refuses_handles(cd_chain_get_factorizations, &out.u64);
    refuses_handles(cd_chain_get_energy, &out.number[0], &out.number[1], &out.number[2]);
    refuses_handles(cd_chain_get_momentum, out.number, COMPONENTS);
    refuses_handles(cd_chain_sample, 0, numbers, 2, CD_OUTSIDE_REFUSED, out.number, 2 * COMPONENTS);
    refuses_handles(cd_chain_get_memory, out.size);
    refuses_handles(cd_chain_hash, &out.u64);
    refuses_handles(cd_chain_save_size, out.size);
    refuses_handles(cd_chain_save, out.bytes, sizeof out.bytes, out.size);
    refuses_handles(cd_chain_load, numbers, sizeof numbers);
    refuses_handles(cd_chain_copy_state, chain);
    refuses(chain, cd_chain_reset(NULL), CD_ERROR_NULL, "chain");
    refuses(chain, cd_chain_reset(foreign), CD_ERROR_HANDLE, "chain");
    refuses(chain, cd_chain_reset(dead), CD_ERROR_HANDLE, "chain");
    refuses(chain, cd_chain_copy_state(chain, NULL), CD_ERROR_NULL, "source");
    refuses(chain, cd_chain_copy_state(chain, foreign), CD_ERROR_HANDLE, "source");
    refuses(chain, cd_chain_copy_state(chain, dead), CD_ERROR_HANDLE, "source");
}

static void no_other_pointer_may_be_null(void** state) {
    (void)state;
    const cd_allocator whole = heap_allocator(&heap);
    cd_allocator without_allocate = whole, without_release = whole;
    without_allocate.allocate = NULL;
    without_release.release = NULL;
    const cd_parallel without_run = {NULL, NULL};
    refuses(chain, cd_chain_create(1, 1, 1, CD_FLOAT32, NULL, NULL), CD_ERROR_NULL, "out_chain");
    refuses(chain, cd_chain_create(1, 1, 1, CD_FLOAT32, &without_allocate, &out.chain), CD_ERROR_NULL, "allocate");
    refuses(chain, cd_chain_create(1, 1, 1, CD_FLOAT32, &without_release, &out.chain), CD_ERROR_NULL, "release");
    refuses(chain, cd_chain_set_parallel(chain, &without_run), CD_ERROR_NULL, "run");
    refuses(chain, cd_chain_get_method(chain, NULL), CD_ERROR_NULL, "out_method");
    refuses(chain, cd_chain_get_kernels(chain, NULL), CD_ERROR_NULL, "out_kernels");
    refuses(chain, cd_chain_get_lambda(chain, NULL), CD_ERROR_NULL, "out_lambda");
    refuses(chain, cd_chain_get_mass(chain, NULL), CD_ERROR_NULL, "out_mass");
    refuses(chain, cd_chain_get_mass_rule(chain, NULL), CD_ERROR_NULL, "out_rule");
    refuses(chain, cd_chain_get_stiffness(chain, NULL), CD_ERROR_NULL, "out_stiffness");
    refuses(chain, cd_chain_get_bend(chain, NULL), CD_ERROR_NULL, "out_bend");
    refuses(chain, cd_chain_get_drag(chain, NULL), CD_ERROR_NULL, "out_drag");
    refuses(chain, cd_chain_get_stiffness_damping(chain, NULL), CD_ERROR_NULL, "out_seconds");
    refuses(chain, cd_chain_set_gravity(chain, NULL, COMPONENTS), CD_ERROR_NULL, "gravity");
    refuses(chain, cd_chain_get_gravity(chain, NULL, COMPONENTS), CD_ERROR_NULL, "out_gravity");
    refuses(chain, cd_chain_get_end(chain, CD_END_FIRST, NULL), CD_ERROR_NULL, "out_kind");
    refuses(chain, cd_chain_get_ring(chain, NULL), CD_ERROR_NULL, "out_ring");
    refuses(chain, cd_chain_get_rest_length(chain, NULL), CD_ERROR_NULL, "out_length");
    refuses(chain, cd_chain_get_push(chain, NULL), CD_ERROR_NULL, "out_push");
    cd_chain* rope = scene_chain(1, 1, COMPONENTS, CD_FLOAT32);
    ok(cd_chain_set_rest_length(rope, 1));
    refuses(rope, cd_chain_get_reaction(rope, 0, 0, NULL, COMPONENTS), CD_ERROR_NULL, "out_force");
    ok(cd_chain_set_colliders(rope, 1));
    refuses(rope, cd_chain_set_plane(rope, 0, NULL, numbers, COMPONENTS, 0.5), CD_ERROR_NULL, "point");
    refuses(rope, cd_chain_set_plane(rope, 0, numbers, NULL, COMPONENTS, 0.5), CD_ERROR_NULL, "normal");
    refuses(rope, cd_chain_set_capsule(rope, 0, NULL, numbers, COMPONENTS, 1, 0.5), CD_ERROR_NULL, "first");
    refuses(rope, cd_chain_set_capsule(rope, 0, numbers, NULL, COMPONENTS, 1, 0.5), CD_ERROR_NULL, "last");
    refuses(rope, cd_chain_set_collider_velocity(rope, 0, NULL, COMPONENTS), CD_ERROR_NULL, "velocity");
    refuses(rope, cd_chain_set_bed(rope, 0, NULL, COMPONENTS, 2, 1, 1, 1, numbers, 2, 0), CD_ERROR_NULL, "origin");
    refuses(rope, cd_chain_set_bed(rope, 0, numbers, COMPONENTS, 2, 1, 1, 1, NULL, 2, 0), CD_ERROR_NULL, "heights");
    refuses(rope, cd_chain_set_callback(rope, 0, NULL, numbers, COMPONENTS, 0), CD_ERROR_NULL, "distance");
    cd_chain_destroy(rope);
    refuses(chain, cd_chain_get_strength(chain, NULL), CD_ERROR_NULL, "out_strength");
    refuses(chain, cd_chain_get_broken(chain, NULL), CD_ERROR_NULL, "out_springs");
    refuses(chain, cd_chain_get_colliders(chain, NULL), CD_ERROR_NULL, "out_count");
    refuses(chain, cd_chain_get_thickness(chain, NULL), CD_ERROR_NULL, "out_radius");
    refuses(chain, cd_chain_teleport(chain, 0, NULL, NULL, COMPONENTS), CD_ERROR_NULL, "offset");
    refuses(chain, cd_chain_get_air(chain, NULL, out.number), CD_ERROR_NULL, "out_along");
    refuses(chain, cd_chain_get_air(chain, out.number, NULL), CD_ERROR_NULL, "out_across");
    refuses(chain, cd_chain_set_wind(chain, NULL, COMPONENTS), CD_ERROR_NULL, "velocity");
    refuses(chain, cd_chain_get_wind(chain, NULL, COMPONENTS), CD_ERROR_NULL, "out_velocity");
    refuses(chain, cd_chain_get_tolerance(chain, NULL, out.size), CD_ERROR_NULL, "out_tolerance");
    refuses(chain, cd_chain_get_tolerance(chain, out.number, NULL), CD_ERROR_NULL, "out_most_iterations");
    refuses(chain, cd_chain_write_f32(chain, CD_POSITION, 0, 1, 0, 1, NULL, COMPONENTS), CD_ERROR_NULL, "values");
    refuses(chain, cd_chain_write_f64(chain, CD_POSITION, 0, 1, 0, 1, NULL, COMPONENTS), CD_ERROR_NULL, "values");
    refuses(chain, cd_chain_read_f32(chain, CD_POSITION, 0, 1, 0, 1, NULL, COMPONENTS), CD_ERROR_NULL, "out_values");
    refuses(chain, cd_chain_read_f64(chain, CD_POSITION, 0, 1, 0, 1, NULL, COMPONENTS), CD_ERROR_NULL, "out_values");
    refuses(chain, cd_chain_view(chain, CD_POSITION, NULL, &out.size[0], &out.size[1], &out.size[2]), CD_ERROR_NULL,
            "out_data");
    refuses(chain, cd_chain_view(chain, CD_POSITION, &out.pointer, NULL, &out.size[1], &out.size[2]), CD_ERROR_NULL,
            "out_strand_stride");
    refuses(chain, cd_chain_view(chain, CD_POSITION, &out.pointer, &out.size[0], NULL, &out.size[2]), CD_ERROR_NULL,
            "out_node_stride");
    refuses(chain, cd_chain_view(chain, CD_POSITION, &out.pointer, &out.size[0], &out.size[1], NULL), CD_ERROR_NULL,
            "out_component_stride");
    refuses(chain, cd_chain_impulse(chain, 0, 2, NULL, COMPONENTS), CD_ERROR_NULL, "impulse");
    refuses(chain, cd_chain_get_attachment(chain, 0, 3, NULL, &out.number[1]), CD_ERROR_NULL, "out_stiffness");
    refuses(chain, cd_chain_get_attachment(chain, 0, 3, &out.number[0], NULL), CD_ERROR_NULL, "out_damping");
    refuses(chain, cd_chain_stable_dt(chain, NULL), CD_ERROR_NULL, "out_dt");
    refuses(chain, cd_chain_get_time(chain, NULL), CD_ERROR_NULL, "out_time");
    refuses(chain, cd_chain_get_steps(chain, NULL), CD_ERROR_NULL, "out_steps");
    refuses(chain, cd_chain_get_factorizations(chain, NULL), CD_ERROR_NULL, "out_count");
    refuses(chain, cd_chain_get_momentum(chain, NULL, COMPONENTS), CD_ERROR_NULL, "out_momentum");
    refuses(chain, cd_chain_sample(chain, 0, NULL, 2, CD_OUTSIDE_REFUSED, out.number, 2 * COMPONENTS), CD_ERROR_NULL, "at");
    refuses(chain, cd_chain_sample(chain, 0, numbers, 2, CD_OUTSIDE_REFUSED, NULL, 2 * COMPONENTS), CD_ERROR_NULL, "out_positions");
    refuses(chain, cd_chain_get_memory(chain, NULL), CD_ERROR_NULL, "out_bytes");
    refuses(chain, cd_chain_hash(chain, NULL), CD_ERROR_NULL, "out_hash");
    refuses(chain, cd_chain_save_size(chain, NULL), CD_ERROR_NULL, "out_size");
    static unsigned char buffer[1 << 16];
    refuses(chain, cd_chain_save(chain, NULL, sizeof buffer, out.size), CD_ERROR_NULL, "buffer");
    refuses(chain, cd_chain_save(chain, buffer, sizeof buffer, NULL), CD_ERROR_NULL, "out_written");
    refuses(chain, cd_chain_load(chain, NULL, sizeof buffer), CD_ERROR_NULL, "bytes");
}

/* Pointers that chain.h allows to be null. */
static const char* const nullable[] = {
    "cd_chain_create allocator",         "cd_chain_destroy chain",          "cd_chain_get_shape out_strands",
    "cd_chain_get_shape out_springs",    "cd_chain_get_shape out_components", "cd_chain_get_shape out_precision",
    "cd_chain_set_parallel parallel",    "cd_chain_attach target",          "cd_chain_get_energy out_kinetic",
    "cd_chain_get_energy out_elastic",   "cd_chain_get_energy out_gravity",   "cd_chain_get_convergence out_iterations",
    "cd_chain_get_convergence out_residual", "cd_chain_teleport rotation",  "cd_chain_get_bed out_columns",
    "cd_chain_get_bed out_rows",         "cd_chain_get_bed out_heights",    "cd_chain_set_callback origin",
    "cd_chain_get_collider out_shape",
    "cd_chain_get_collider out_first",   "cd_chain_get_collider out_second", "cd_chain_get_collider out_velocity",
    "cd_chain_get_collider out_radius",  "cd_chain_get_collider out_friction",
};

static void what_may_be_null_is_taken_as_null(void** state) {
    (void)state;
    const double target[COMPONENTS] = {0};
    cd_chain* other = scene_chain_from(NULL, 1, 1, COMPONENTS, CD_FLOAT32);
    ok(cd_chain_get_shape(other, NULL, NULL, NULL, NULL));
    ok(cd_chain_set_parallel(other, NULL));
    ok(cd_chain_get_energy(other, NULL, NULL, NULL));
    ok(cd_chain_get_convergence(other, NULL, NULL));
    ok(cd_chain_attach(other, 0, 0, 1, 1, target, COMPONENTS));
    ok(cd_chain_teleport(other, 0, NULL, target, COMPONENTS));
    ok(cd_chain_attach(other, 0, 1, 1, 1, NULL, COMPONENTS));
    ok(cd_chain_attach(other, 0, 1, 1, 1, NULL, 0)); /* then count means nothing */
    ok(cd_chain_attach(other, 0, 1, 1, 1, NULL, SIZE_MAX));
    ok(cd_chain_set_rest_length(other, 1));
    ok(cd_chain_set_colliders(other, 1));
    ok(cd_chain_get_collider(other, 0, NULL, NULL, NULL, NULL, COMPONENTS, NULL, NULL));
    ok(cd_chain_get_bed(other, 0, NULL, NULL, NULL, 0));
    ok(cd_chain_get_bed(other, 0, NULL, NULL, NULL, SIZE_MAX)); /* then height_count means nothing */
    ok(cd_chain_set_callback(other, 0, &nothing_near, target, COMPONENTS, 0));
    ok(cd_chain_set_callback(other, 0, &nothing_near, NULL, SIZE_MAX, -1)); /* then count and friction mean nothing */
    cd_chain_destroy(other);
    cd_chain_destroy(NULL);
}

static void every_pointer_in_the_header_was_tried(void** state) {
    (void)state;
    all_pointers_were_tried("chain", nullable, COUNT(nullable));
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(only_a_living_chain_is_taken_for_one),
        cmocka_unit_test(no_other_pointer_may_be_null),
        cmocka_unit_test(what_may_be_null_is_taken_as_null),
        cmocka_unit_test(every_pointer_in_the_header_was_tried),
    };
    return cmocka_run_group_tests(tests, set_up, tear_down);
}
