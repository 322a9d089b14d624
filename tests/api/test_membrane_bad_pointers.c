/* Null, foreign and released pointers: every pointer of every function of membrane.h. */
#include "check.h"
#include "cloth.h"
#include "heap.h"
#include "nothing_near.h"
#include "refusals.h"
#include "scene.h"

enum { NU = 7, NV = 5, COMPONENTS = 3 };

static cd_membrane *membrane, *dead;
static _Alignas(64) unsigned char foreign_bytes[8192] = {1, 2, 3};
static cd_membrane* const foreign = (cd_membrane*)(void*)foreign_bytes;
static struct heap heap = {.keeps = true};

static int set_up(void** state) {
    (void)state;
    const cd_allocator allocator = heap_allocator(&heap);
    membrane = cloth(NU, NV, COMPONENTS, CD_FLOAT64);
    cloth_everything(membrane);
    dead = cloth_from(&allocator, NU, NV, COMPONENTS, CD_FLOAT64);
    cd_membrane_destroy(dead);
    return 0;
}

static int tear_down(void** state) {
    (void)state;
    cd_membrane_destroy(membrane);
    heap_free(&heap);
    return 0;
}

/* A function whose first argument is a membrane, and the arguments after it, all good. */
#define refuses_handles(function, ...)                                                  \
    do {                                                                                \
        refuses(membrane, function(NULL, __VA_ARGS__), CD_ERROR_NULL, "membrane");      \
        refuses(membrane, function(foreign, __VA_ARGS__), CD_ERROR_HANDLE, "membrane"); \
        refuses(membrane, function(dead, __VA_ARGS__), CD_ERROR_HANDLE, "membrane");    \
    } while (0)

static const double numbers[8] = {0.5, 0.25};
static const float singles[8] = {0.5f, 0.25f};

static void only_a_living_membrane_is_taken_for_one(void** state) {
    (void)state;
    refuses_handles(cd_membrane_get_shape, &out.size[0], &out.size[1], &out.size[2], &out.i32);
    refuses_handles(cd_membrane_set_method, CD_METHOD_IMPLICIT);
    refuses_handles(cd_membrane_get_method, &out.i32);
    refuses_handles(cd_membrane_set_lambda, 0.75);
    refuses_handles(cd_membrane_get_lambda, out.number);
    refuses_handles(cd_membrane_set_solver, CD_SOLVER_COUPLED);
    refuses_handles(cd_membrane_get_solver, &out.i32);
    refuses_handles(cd_membrane_set_tolerance, 1e-3, 10);
    refuses_handles(cd_membrane_get_tolerance, out.number, out.size);
    refuses_handles(cd_membrane_get_convergence, out.size, out.number);
    refuses_handles(cd_membrane_set_parallel, NULL);
    refuses_handles(cd_membrane_set_kernels, CD_KERNELS_PLAIN);
    refuses_handles(cd_membrane_get_kernels, &out.i32);
    refuses_handles(cd_membrane_set_mass, 1.5);
    refuses_handles(cd_membrane_get_mass, out.number);
    refuses_handles(cd_membrane_set_mass_rule, CD_MASS_EQUAL);
    refuses_handles(cd_membrane_get_mass_rule, &out.i32);
    refuses_handles(cd_membrane_set_stiffness, 1.5, 2.5);
    refuses_handles(cd_membrane_get_stiffness, &out.number[0], &out.number[1]);
    refuses_handles(cd_membrane_set_bend, 1.5);
    refuses_handles(cd_membrane_get_bend, out.number);
    refuses_handles(cd_membrane_set_drag, 1.5);
    refuses_handles(cd_membrane_get_drag, out.number);
    refuses_handles(cd_membrane_set_stiffness_damping, 1.5);
    refuses_handles(cd_membrane_get_stiffness_damping, out.number);
    refuses_handles(cd_membrane_set_gravity, numbers, COMPONENTS);
    refuses_handles(cd_membrane_get_gravity, out.number, COMPONENTS);
    refuses_handles(cd_membrane_set_pressure, 0.5);
    refuses_handles(cd_membrane_get_pressure, out.number);
    refuses_handles(cd_membrane_set_edge, CD_EDGE_U_FIRST, CD_NODE_PINNED);
    refuses_handles(cd_membrane_get_edge, CD_EDGE_U_FIRST, &out.i32);
    refuses_handles(cd_membrane_set_ring, 0, 0);
    refuses_handles(cd_membrane_get_ring, &out.i32, &out.i32);
    refuses_handles(cd_membrane_set_rest_length, 1.0, 1.0);
    refuses_handles(cd_membrane_get_rest_length, &out.number[0], &out.number[1]);
    refuses_handles(cd_membrane_set_shear, 1.0);
    refuses_handles(cd_membrane_get_shear, out.number);
    refuses_handles(cd_membrane_set_compression, 1.0);
    refuses_handles(cd_membrane_get_compression, out.number);
    refuses_handles(cd_membrane_set_breaking_strain, 1.0);
    refuses_handles(cd_membrane_get_breaking_strain, out.number);
    refuses_handles(cd_membrane_get_broken, out.size);
    refuses_handles(cd_membrane_set_effort, 1, 1);
    refuses_handles(cd_membrane_get_effort, &out.size[0], &out.size[1]);
    refuses_handles(cd_membrane_set_air, 1.0, 1.0);
    refuses_handles(cd_membrane_get_air, &out.number[0], &out.number[1]);
    refuses_handles(cd_membrane_set_wind, numbers, COMPONENTS);
    refuses_handles(cd_membrane_get_wind, out.number, COMPONENTS);
    refuses_handles(cd_membrane_set_colliders, 1);
    refuses_handles(cd_membrane_get_colliders, out.size);
    refuses_handles(cd_membrane_set_plane, 0, numbers, numbers, COMPONENTS, 0.5);
    refuses_handles(cd_membrane_set_capsule, 0, numbers, numbers, COMPONENTS, 1.0, 0.5);
    refuses_handles(cd_membrane_set_bed, 0, numbers, COMPONENTS, 2, 2, 1, 1, numbers, 4, 0.5);
    refuses_handles(cd_membrane_get_bed, 0, out.size, out.size + 1, out.number, 0);
    refuses_handles(cd_membrane_set_callback, 0, &(cd_distance){0}, numbers, COMPONENTS, 0.5);
    refuses_handles(cd_membrane_remove_collider, 0);
    refuses_handles(cd_membrane_set_collider_velocity, 0, numbers, COMPONENTS);
    refuses_handles(cd_membrane_get_collider, 0, &out.i32, out.number, out.number + 3, out.number + 6, COMPONENTS,
                    out.number + 9, out.number + 10);
    refuses_handles(cd_membrane_set_thickness, 1.0);
    refuses_handles(cd_membrane_get_thickness, out.number);
    refuses_handles(cd_membrane_enable_field, CD_FORCE);
    refuses_handles(cd_membrane_disable_field, CD_FORCE);
    refuses_handles(cd_membrane_write_f32, CD_POSITION, 0, 0, 1, 1, singles, COMPONENTS);
    refuses_handles(cd_membrane_write_f64, CD_POSITION, 0, 0, 1, 1, numbers, COMPONENTS);
    refuses_handles(cd_membrane_read_f32, CD_POSITION, 0, 0, 1, 1, out.single, COMPONENTS);
    refuses_handles(cd_membrane_read_f64, CD_POSITION, 0, 0, 1, 1, out.number, COMPONENTS);
    refuses_handles(cd_membrane_view, CD_POSITION, &out.pointer, &out.size[0], &out.size[1], &out.size[2]);
    refuses_handles(cd_membrane_impulse, 1.0, 2.0, 1.5, numbers, COMPONENTS);
    refuses_handles(cd_membrane_teleport, NULL, numbers, COMPONENTS);
    refuses_handles(cd_membrane_attach, 2, 3, 1.0, 1.0, numbers, COMPONENTS);
    refuses_handles(cd_membrane_detach, 3, 2);
    refuses_handles(cd_membrane_get_attachment, 3, 2, &out.number[0], &out.number[1]);
    refuses_handles(cd_membrane_step, 0.01, 1);
    refuses_handles(cd_membrane_stable_dt, out.number);
    refuses_handles(cd_membrane_get_time, out.number);
    refuses_handles(cd_membrane_get_steps, &out.u64);
    refuses_handles(cd_membrane_get_factorizations, &out.u64);
    refuses_handles(cd_membrane_get_energy, &out.number[0], &out.number[1], &out.number[2]);
    refuses_handles(cd_membrane_get_momentum, out.number, COMPONENTS);
    refuses_handles(cd_membrane_get_volume, out.number);
    refuses_handles(cd_membrane_sample, numbers, 2, CD_OUTSIDE_REFUSED, out.number, 2 * COMPONENTS);
    refuses_handles(cd_membrane_get_memory, out.size);
    refuses_handles(cd_membrane_hash, &out.u64);
    refuses_handles(cd_membrane_save_size, out.size);
    refuses_handles(cd_membrane_save, out.bytes, sizeof out.bytes, out.size);
    refuses_handles(cd_membrane_load, numbers, sizeof numbers);
    refuses_handles(cd_membrane_copy_state, membrane);
    refuses(membrane, cd_membrane_reset(NULL), CD_ERROR_NULL, "membrane");
    refuses(membrane, cd_membrane_reset(foreign), CD_ERROR_HANDLE, "membrane");
    refuses(membrane, cd_membrane_reset(dead), CD_ERROR_HANDLE, "membrane");
    refuses(membrane, cd_membrane_copy_state(membrane, NULL), CD_ERROR_NULL, "source");
    refuses(membrane, cd_membrane_copy_state(membrane, foreign), CD_ERROR_HANDLE, "source");
    refuses(membrane, cd_membrane_copy_state(membrane, dead), CD_ERROR_HANDLE, "source");
}

static void a_chain_is_no_membrane(void** state) {
    (void)state;
    cd_chain* chain = scene_chain(2, 9, COMPONENTS, CD_FLOAT64);
    cd_membrane* const wrong = (cd_membrane*)(void*)chain;
    refuses(chain, cd_membrane_set_mass(wrong, 2), CD_ERROR_HANDLE, "membrane");
    refuses(chain, cd_membrane_step(wrong, 0.1, 1), CD_ERROR_HANDLE, "membrane");
    refuses(membrane, cd_membrane_copy_state(membrane, wrong), CD_ERROR_HANDLE, "source");
    refuses(membrane, cd_chain_set_mass((cd_chain*)(void*)membrane, 2), CD_ERROR_HANDLE, "chain");
    cd_membrane_destroy(wrong);
    hash_of(chain); /* still lives */
    cd_chain_destroy(chain);
}

static void no_other_pointer_may_be_null(void** state) {
    (void)state;
    const cd_allocator whole = heap_allocator(&heap);
    cd_allocator without_allocate = whole, without_release = whole;
    without_allocate.allocate = NULL;
    without_release.release = NULL;
    const cd_parallel without_run = {NULL, NULL};
    cd_membrane* const m = membrane;
    refuses(m, cd_membrane_create(1, 1, 1, CD_FLOAT32, NULL, NULL), CD_ERROR_NULL, "out_membrane");
    refuses(m, cd_membrane_create(1, 1, 1, CD_FLOAT32, &without_allocate, &out.membrane), CD_ERROR_NULL, "allocate");
    refuses(m, cd_membrane_create(1, 1, 1, CD_FLOAT32, &without_release, &out.membrane), CD_ERROR_NULL, "release");
    refuses(m, cd_membrane_set_parallel(m, &without_run), CD_ERROR_NULL, "run");
    refuses(m, cd_membrane_get_method(m, NULL), CD_ERROR_NULL, "out_method");
    refuses(m, cd_membrane_get_kernels(m, NULL), CD_ERROR_NULL, "out_kernels");
    refuses(m, cd_membrane_get_lambda(m, NULL), CD_ERROR_NULL, "out_lambda");
    refuses(m, cd_membrane_get_solver(m, NULL), CD_ERROR_NULL, "out_solver");
    refuses(m, cd_membrane_get_tolerance(m, NULL, out.size), CD_ERROR_NULL, "out_tolerance");
    refuses(m, cd_membrane_get_tolerance(m, out.number, NULL), CD_ERROR_NULL, "out_most_iterations");
    refuses(m, cd_membrane_get_mass(m, NULL), CD_ERROR_NULL, "out_mass");
    refuses(m, cd_membrane_get_mass_rule(m, NULL), CD_ERROR_NULL, "out_rule");
    refuses(m, cd_membrane_get_stiffness(m, NULL, out.number), CD_ERROR_NULL, "out_along_u");
    refuses(m, cd_membrane_get_stiffness(m, out.number, NULL), CD_ERROR_NULL, "out_along_v");
    refuses(m, cd_membrane_get_bend(m, NULL), CD_ERROR_NULL, "out_bend");
    refuses(m, cd_membrane_get_drag(m, NULL), CD_ERROR_NULL, "out_drag");
    refuses(m, cd_membrane_get_stiffness_damping(m, NULL), CD_ERROR_NULL, "out_seconds");
    refuses(m, cd_membrane_set_gravity(m, NULL, COMPONENTS), CD_ERROR_NULL, "gravity");
    refuses(m, cd_membrane_get_gravity(m, NULL, COMPONENTS), CD_ERROR_NULL, "out_gravity");
    refuses(m, cd_membrane_get_pressure(m, NULL), CD_ERROR_NULL, "out_pressure");
    refuses(m, cd_membrane_get_edge(m, CD_EDGE_V_LAST, NULL), CD_ERROR_NULL, "out_kind");
    refuses(m, cd_membrane_get_ring(m, NULL, &out.i32), CD_ERROR_NULL, "out_along_u");
    refuses(m, cd_membrane_get_ring(m, &out.i32, NULL), CD_ERROR_NULL, "out_along_v");
    refuses(m, cd_membrane_get_rest_length(m, NULL, out.number), CD_ERROR_NULL, "out_along_u");
    refuses(m, cd_membrane_get_rest_length(m, out.number, NULL), CD_ERROR_NULL, "out_along_v");
    refuses(m, cd_membrane_get_shear(m, NULL), CD_ERROR_NULL, "out_stiffness");
    refuses(m, cd_membrane_get_compression(m, NULL), CD_ERROR_NULL, "out_rate");
    refuses(m, cd_membrane_get_breaking_strain(m, NULL), CD_ERROR_NULL, "out_strain");
    refuses(m, cd_membrane_get_broken(m, NULL), CD_ERROR_NULL, "out_springs");
    refuses(m, cd_membrane_get_effort(m, NULL, out.size), CD_ERROR_NULL, "out_newton");
    refuses(m, cd_membrane_get_effort(m, out.size, NULL), CD_ERROR_NULL, "out_gradient");
    refuses(m, cd_membrane_get_air(m, NULL, out.number), CD_ERROR_NULL, "out_along");
    refuses(m, cd_membrane_get_air(m, out.number, NULL), CD_ERROR_NULL, "out_across");
    refuses(m, cd_membrane_set_wind(m, NULL, COMPONENTS), CD_ERROR_NULL, "velocity");
    refuses(m, cd_membrane_get_wind(m, NULL, COMPONENTS), CD_ERROR_NULL, "out_velocity");
    refuses(m, cd_membrane_get_colliders(m, NULL), CD_ERROR_NULL, "out_count");
    refuses(m, cd_membrane_get_thickness(m, NULL), CD_ERROR_NULL, "out_distance");
    cd_membrane* sail = cloth(4, 4, COMPONENTS, CD_FLOAT32);
    cloth_sail(sail);
    ok(cd_membrane_set_colliders(sail, 1));
    refuses(sail, cd_membrane_set_plane(sail, 0, NULL, numbers, COMPONENTS, 0.5), CD_ERROR_NULL, "point");
    refuses(sail, cd_membrane_set_plane(sail, 0, numbers, NULL, COMPONENTS, 0.5), CD_ERROR_NULL, "normal");
    refuses(sail, cd_membrane_set_capsule(sail, 0, NULL, numbers, COMPONENTS, 1, 0.5), CD_ERROR_NULL, "first");
    refuses(sail, cd_membrane_set_capsule(sail, 0, numbers, NULL, COMPONENTS, 1, 0.5), CD_ERROR_NULL, "last");
    refuses(sail, cd_membrane_set_collider_velocity(sail, 0, NULL, COMPONENTS), CD_ERROR_NULL, "velocity");
    refuses(sail, cd_membrane_set_bed(sail, 0, NULL, COMPONENTS, 2, 2, 1, 1, numbers, 4, 0), CD_ERROR_NULL, "origin");
    refuses(sail, cd_membrane_set_bed(sail, 0, numbers, COMPONENTS, 2, 2, 1, 1, NULL, 4, 0), CD_ERROR_NULL, "heights");
    refuses(sail, cd_membrane_set_callback(sail, 0, NULL, numbers, COMPONENTS, 0), CD_ERROR_NULL, "distance");
    cd_membrane_destroy(sail);
    refuses(m, cd_membrane_write_f32(m, CD_POSITION, 0, 0, 1, 1, NULL, COMPONENTS), CD_ERROR_NULL, "values");
    refuses(m, cd_membrane_write_f64(m, CD_POSITION, 0, 0, 1, 1, NULL, COMPONENTS), CD_ERROR_NULL, "values");
    refuses(m, cd_membrane_read_f32(m, CD_POSITION, 0, 0, 1, 1, NULL, COMPONENTS), CD_ERROR_NULL, "out_values");
    refuses(m, cd_membrane_read_f64(m, CD_POSITION, 0, 0, 1, 1, NULL, COMPONENTS), CD_ERROR_NULL, "out_values");
    const void** const data = &out.pointer;
    size_t* const stride = out.size;
    refuses(m, cd_membrane_view(m, CD_POSITION, NULL, stride, stride, stride), CD_ERROR_NULL, "out_data");
    refuses(m, cd_membrane_view(m, CD_POSITION, data, NULL, stride, stride), CD_ERROR_NULL, "out_u_stride");
    refuses(m, cd_membrane_view(m, CD_POSITION, data, stride, NULL, stride), CD_ERROR_NULL, "out_v_stride");
    refuses(m, cd_membrane_view(m, CD_POSITION, data, stride, stride, NULL), CD_ERROR_NULL, "out_component_stride");
    refuses(m, cd_membrane_impulse(m, 1, 2, 1, NULL, COMPONENTS), CD_ERROR_NULL, "impulse");
    refuses(m, cd_membrane_teleport(m, NULL, NULL, COMPONENTS), CD_ERROR_NULL, "offset");
    refuses(m, cd_membrane_get_attachment(m, 3, 2, NULL, out.number), CD_ERROR_NULL, "out_stiffness");
    refuses(m, cd_membrane_get_attachment(m, 3, 2, out.number, NULL), CD_ERROR_NULL, "out_damping");
    refuses(m, cd_membrane_stable_dt(m, NULL), CD_ERROR_NULL, "out_dt");
    refuses(m, cd_membrane_get_time(m, NULL), CD_ERROR_NULL, "out_time");
    refuses(m, cd_membrane_get_steps(m, NULL), CD_ERROR_NULL, "out_steps");
    refuses(m, cd_membrane_get_factorizations(m, NULL), CD_ERROR_NULL, "out_count");
    refuses(m, cd_membrane_get_momentum(m, NULL, COMPONENTS), CD_ERROR_NULL, "out_momentum");
    refuses(m, cd_membrane_get_volume(m, NULL), CD_ERROR_NULL, "out_volume");
    refuses(m, cd_membrane_sample(m, NULL, 2, CD_OUTSIDE_REFUSED, out.number, 2 * COMPONENTS), CD_ERROR_NULL, "at");
    refuses(m, cd_membrane_sample(m, numbers, 2, CD_OUTSIDE_REFUSED, NULL, 2 * COMPONENTS), CD_ERROR_NULL,
            "out_positions");
    refuses(m, cd_membrane_get_memory(m, NULL), CD_ERROR_NULL, "out_bytes");
    refuses(m, cd_membrane_hash(m, NULL), CD_ERROR_NULL, "out_hash");
    refuses(m, cd_membrane_save_size(m, NULL), CD_ERROR_NULL, "out_size");
    static unsigned char buffer[1 << 16];
    refuses(m, cd_membrane_save(m, NULL, sizeof buffer, out.size), CD_ERROR_NULL, "buffer");
    refuses(m, cd_membrane_save(m, buffer, sizeof buffer, NULL), CD_ERROR_NULL, "out_written");
    refuses(m, cd_membrane_load(m, NULL, sizeof buffer), CD_ERROR_NULL, "bytes");
}

/* Pointers that membrane.h allows to be null; the drawing functions have tests of their own. */
static const char* const nullable[] = {
    "cd_membrane_create allocator",
    "cd_membrane_destroy membrane",
    "cd_membrane_get_shape out_nu",
    "cd_membrane_get_shape out_nv",
    "cd_membrane_get_shape out_components",
    "cd_membrane_get_shape out_precision",
    "cd_membrane_get_convergence out_iterations",
    "cd_membrane_get_convergence out_residual",
    "cd_membrane_set_parallel parallel",
    "cd_membrane_attach target",
    "cd_membrane_teleport rotation",
    "cd_membrane_get_energy out_kinetic",
    "cd_membrane_get_energy out_elastic",
    "cd_membrane_get_energy out_gravity",
    "cd_membrane_get_bed out_columns",
    "cd_membrane_get_bed out_rows",
    "cd_membrane_get_bed out_heights",
    "cd_membrane_set_callback origin",
    "cd_membrane_get_collider out_shape",
    "cd_membrane_get_collider out_first",
    "cd_membrane_get_collider out_second",
    "cd_membrane_get_collider out_velocity",
    "cd_membrane_get_collider out_radius",
    "cd_membrane_get_collider out_friction",
    "cd_membrane_write_vertices membrane",
    "cd_membrane_write_vertices buffer",
    "cd_membrane_get_index_count membrane",
    "cd_membrane_get_index_count out_count",
    "cd_membrane_write_indices membrane",
    "cd_membrane_write_indices buffer",
};

static void what_may_be_null_is_taken_as_null(void** state) {
    (void)state;
    const double target[2] = {0};
    cd_membrane* other = cloth(1, 1, 2, CD_FLOAT32);
    ok(cd_membrane_get_shape(other, NULL, NULL, NULL, NULL));
    ok(cd_membrane_get_convergence(other, NULL, NULL));
    ok(cd_membrane_set_parallel(other, NULL));
    ok(cd_membrane_get_energy(other, NULL, NULL, NULL));
    ok(cd_membrane_attach(other, 0, 1, 1, 1, target, 2));
    ok(cd_membrane_teleport(other, NULL, target, 2));
    ok(cd_membrane_attach(other, 1, 0, 1, 1, NULL, 2));
    ok(cd_membrane_attach(other, 1, 0, 1, 1, NULL, SIZE_MAX)); /* then count means nothing */
    ok(cd_membrane_sample(other, NULL, 0, CD_OUTSIDE_REFUSED, NULL, 0));
    cd_membrane_destroy(other);
    cd_membrane* sail = cloth(4, 4, COMPONENTS, CD_FLOAT32);
    cloth_sail(sail);
    cloth_meet(sail);
    ok(cd_membrane_get_collider(sail, 0, NULL, NULL, NULL, NULL, COMPONENTS, NULL, NULL));
    ok(cd_membrane_get_bed(sail, 0, NULL, NULL, NULL, SIZE_MAX));
    ok(cd_membrane_set_callback(sail, 0, &nothing_near, numbers, COMPONENTS, 0));
    ok(cd_membrane_set_callback(sail, 0, &nothing_near, NULL, SIZE_MAX, -1)); /* then count and friction mean nothing */
    cd_membrane_destroy(sail);
    cd_membrane_destroy(NULL);
}

static void every_pointer_in_the_header_was_tried(void** state) {
    (void)state;
    all_pointers_were_tried("membrane", nullable, COUNT(nullable));
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(only_a_living_membrane_is_taken_for_one),
        cmocka_unit_test(a_chain_is_no_membrane),
        cmocka_unit_test(no_other_pointer_may_be_null),
        cmocka_unit_test(what_may_be_null_is_taken_as_null),
        cmocka_unit_test(every_pointer_in_the_header_was_tried),
    };
    return cmocka_run_group_tests(tests, set_up, tear_down);
}
