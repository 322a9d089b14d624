#include "cloth.h"

#include <math.h>
#include <stdlib.h>

#include "check.h"
#include "scene.h"
#include "sheet.h"

cd_membrane* cloth_from(const cd_allocator* allocator, size_t nu, size_t nv, size_t components,
                        cd_precision precision) {
    cd_membrane* membrane = NULL;
    ok(cd_membrane_create(nu, nv, components, precision, allocator, &membrane));
    assert_non_null(membrane);
    ok(cd_membrane_set_solver(membrane, CD_SOLVER_ALTERNATING));
    return membrane;
}

cd_membrane* cloth(size_t nu, size_t nv, size_t components, cd_precision precision) {
    return cloth_from(NULL, nu, nv, components, precision);
}

struct cloth_extent cloth_extent(const cd_membrane* membrane, cd_field field) {
    size_t nu, nv, components;
    int32_t ring[2];
    ok(cd_membrane_get_shape(membrane, &nu, &nv, &components, NULL));
    ok(cd_membrane_get_ring(membrane, &ring[0], &ring[1]));
    struct cloth_extent extent = {nu + 1, nv + 1, 1, 0};
    if (field == CD_STIFFNESS_U || field == CD_REST_LENGTH_U || field == CD_TENSION_U || field == CD_STRAIN_U ||
        field == CD_BREAKING_STRAIN_U)
        extent.columns = nu + (size_t)ring[0];
    if (field == CD_STIFFNESS_V || field == CD_REST_LENGTH_V || field == CD_TENSION_V || field == CD_STRAIN_V ||
        field == CD_BREAKING_STRAIN_V)
        extent.rows = nv + (size_t)ring[1];
    if (field == CD_POSITION || field == CD_VELOCITY || field == CD_FORCE || field == CD_TARGET || field == CD_WIND)
        extent.components = components;
    extent.count = extent.columns * extent.rows * extent.components;
    return extent;
}

void cloth_read(const cd_membrane* membrane, cd_field field, double* out_values) {
    const struct cloth_extent all = cloth_extent(membrane, field);
    ok(cd_membrane_read_f64(membrane, field, 0, 0, all.columns, all.rows, out_values, all.count));
}

void cloth_write(cd_membrane* membrane, cd_field field, const double* values) {
    const struct cloth_extent all = cloth_extent(membrane, field);
    ok(cd_membrane_write_f64(membrane, field, 0, 0, all.columns, all.rows, values, all.count));
}

static double* new_numbers(size_t count) {
    double* numbers = calloc(count, sizeof *numbers);
    assert_non_null(numbers);
    return numbers;
}

void cloth_lay_out(cd_membrane* membrane, double spacing) {
    const struct cloth_extent all = cloth_extent(membrane, CD_POSITION);
    double* x = new_numbers(all.count);
    for (size_t i = 0; i < all.columns * all.rows; ++i) {
        x[i * all.components] = (double)(i % all.columns) * spacing;
        if (all.components > 1) x[i * all.components + 1] = (double)(i / all.columns) * spacing;
    }
    cloth_write(membrane, CD_POSITION, x);
    free(x);
}

void cloth_shake(cd_membrane* membrane, double size, uint64_t seed) {
    const struct cloth_extent all = cloth_extent(membrane, CD_POSITION);
    double* x = new_numbers(all.count);
    double* v = new_numbers(all.count);
    cloth_read(membrane, CD_POSITION, x);
    for (size_t i = 0; i < all.count; ++i) {
        x[i] += size * scene_noise(&seed);
        v[i] = size * scene_noise(&seed);
    }
    cloth_write(membrane, CD_POSITION, x);
    for (size_t node = 0; node < all.columns * all.rows; ++node) /* a pinned one refuses, and keeps its 0 */
        (void)cd_membrane_write_f64(membrane, CD_VELOCITY, node % all.columns, node / all.columns, 1, 1,
                                    v + node * all.components, all.components);
    free(x);
    free(v);
}

static void set_gravity(cd_membrane* membrane, double down) {
    const double gravity[4] = {0.25, down, -0.5, 1};
    const size_t components = cloth_extent(membrane, CD_POSITION).components;
    ok(cd_membrane_set_gravity(membrane, components == 1 ? gravity + 1 : gravity, components));
}

static void hold(cd_membrane* membrane, cd_edge first, cd_edge last, cd_node kind) {
    for (cd_edge edge = first; edge <= last; ++edge) ok(cd_membrane_set_edge(membrane, edge, kind));
}

/* A different number, around `size`, everywhere. */
static void vary(cd_membrane* membrane, cd_field field, double size, uint64_t seed) {
    const size_t count = cloth_extent(membrane, field).count;
    double* values = new_numbers(count);
    for (size_t i = 0; i < count; ++i) values[i] = size * (1 + 0.5 * scene_noise(&seed));
    ok(cd_membrane_enable_field(membrane, field));
    cloth_write(membrane, field, values);
    free(values);
}

static void push(cd_membrane* membrane, double size, uint64_t seed) { vary(membrane, CD_FORCE, size, seed); }

static void drive(cd_membrane* membrane, cd_edge edge, double velocity) {
    const struct cloth_extent all = cloth_extent(membrane, CD_VELOCITY);
    ok(cd_membrane_set_edge(membrane, edge, CD_NODE_DRIVEN));
    double v[4];
    for (size_t k = 0; k < 4; ++k) v[k] = velocity * (double)(1 + k);
    for (size_t i = 1; i + 1 < all.rows; ++i)
        ok(cd_membrane_write_f64(membrane, CD_VELOCITY, edge == CD_EDGE_U_FIRST ? 0 : all.columns - 1, i, 1, 1, v,
                                 all.components));
}

void cloth_drum(cd_membrane* membrane) {
    ok(cd_membrane_set_mass_rule(membrane, CD_MASS_HALF_ENDS));
    ok(cd_membrane_set_stiffness(membrane, 2, 3));
    hold(membrane, CD_EDGE_U_FIRST, CD_EDGE_V_LAST, CD_NODE_PINNED);
    cloth_lay_out(membrane, 0.1);
    cloth_shake(membrane, 0.02, 1);
}

void cloth_curtain(cd_membrane* membrane) {
    ok(cd_membrane_set_mass(membrane, 0.5));
    ok(cd_membrane_set_stiffness(membrane, 40, 40));
    ok(cd_membrane_set_drag(membrane, 0.3));
    ok(cd_membrane_set_stiffness_damping(membrane, 0.002));
    set_gravity(membrane, -9.81);
    hold(membrane, CD_EDGE_V_FIRST, CD_EDGE_V_FIRST, CD_NODE_PINNED);
    cloth_lay_out(membrane, 0.1);
    cloth_shake(membrane, 0.01, 2);
}

void cloth_flag(cd_membrane* membrane) {
    ok(cd_membrane_set_stiffness(membrane, 5, 1));
    hold(membrane, CD_EDGE_U_FIRST, CD_EDGE_U_FIRST, CD_NODE_PINNED);
    cloth_lay_out(membrane, 0.05);
    cloth_shake(membrane, 0.01, 3);
    push(membrane, 0.01, 4);
    if (cloth_extent(membrane, CD_POSITION).components == 3) ok(cd_membrane_set_pressure(membrane, 0.5));
}

void cloth_plate(cd_membrane* membrane) {
    ok(cd_membrane_set_bend(membrane, 0.002));
    ok(cd_membrane_set_stiffness(membrane, 0.5, 0.25));
    hold(membrane, CD_EDGE_U_FIRST, CD_EDGE_V_LAST, CD_NODE_PINNED);
    cloth_lay_out(membrane, 0.1);
    cloth_shake(membrane, 0.02, 5);
}

void cloth_tube(cd_membrane* membrane) {
    ok(cd_membrane_set_ring(membrane, 1, 0));
    ok(cd_membrane_set_bend(membrane, 0.001));
    hold(membrane, CD_EDGE_V_LAST, CD_EDGE_V_LAST, CD_NODE_PINNED);
    set_gravity(membrane, -1);
    cloth_lay_out(membrane, 0.1);
    cloth_shake(membrane, 0.05, 6);
}

void cloth_torus(cd_membrane* membrane) {
    ok(cd_membrane_set_mass_rule(membrane, CD_MASS_HALF_ENDS));
    ok(cd_membrane_set_ring(membrane, 1, 1));
    ok(cd_membrane_set_drag(membrane, 0.1));
    cloth_lay_out(membrane, 0.1);
    cloth_shake(membrane, 0.1, 7);
}

void cloth_torn(cd_membrane* membrane) {
    hold(membrane, CD_EDGE_V_FIRST, CD_EDGE_V_FIRST, CD_NODE_PINNED);
    set_gravity(membrane, -1);
    cloth_lay_out(membrane, 0.1);
    cloth_shake(membrane, 0.05, 8);
    vary(membrane, CD_MASS, 0.03, 9);
    vary(membrane, CD_STIFFNESS_V, 2, 10);
    for (size_t u = 0; u < 3; ++u) sheet_set(membrane, CD_STIFFNESS_V, u, 2, 0);
    ok(cd_membrane_enable_field(membrane, CD_MASK));
    sheet_set(membrane, CD_MASK, 3, 3, 0);
    sheet_set(membrane, CD_MASK, 4, 1, 0);
}

void cloth_tied(cd_membrane* membrane) {
    const double target[4] = {0.5, -0.5, 0.25, 1};
    const struct cloth_extent all = cloth_extent(membrane, CD_POSITION);
    hold(membrane, CD_EDGE_U_LAST, CD_EDGE_U_LAST, CD_NODE_MATCHED);
    cloth_lay_out(membrane, 0.1);
    cloth_shake(membrane, 0.1, 11);
    drive(membrane, CD_EDGE_U_FIRST, -0.2);
    ok(cd_membrane_attach(membrane, 2, 2, 30, 0.5, NULL, 0));
    ok(cd_membrane_attach(membrane, all.columns - 2, 3, 8, 0, target, all.components));
    set_gravity(membrane, -2);
}

static void all_fields(cd_membrane* membrane) {
    const size_t components = cloth_extent(membrane, CD_POSITION).components;
    ok(cd_membrane_set_mass(membrane, 2));
    ok(cd_membrane_set_mass_rule(membrane, CD_MASS_HALF_ENDS));
    ok(cd_membrane_set_stiffness(membrane, 5, 4));
    ok(cd_membrane_set_bend(membrane, 0.002));
    ok(cd_membrane_set_drag(membrane, 0.2));
    ok(cd_membrane_set_stiffness_damping(membrane, 0.001));
    ok(cd_membrane_set_lambda(membrane, 0.625));
    ok(cd_membrane_set_solver(membrane, CD_SOLVER_COUPLED));
    ok(cd_membrane_set_tolerance(membrane, 1e-9, 200));
    if (components == 3) ok(cd_membrane_set_pressure(membrane, -0.25));
    set_gravity(membrane, -9.81);
    drive(membrane, CD_EDGE_U_FIRST, 0.1);
    ok(cd_membrane_set_edge(membrane, CD_EDGE_U_LAST, CD_NODE_MATCHED));
    ok(cd_membrane_set_edge(membrane, CD_EDGE_V_FIRST, CD_NODE_PINNED));
    cloth_lay_out(membrane, 0.1);
    cloth_shake(membrane, 0.05, 12);
    vary(membrane, CD_MASS, 0.05, 13);
    vary(membrane, CD_STIFFNESS_U, 4, 14);
    vary(membrane, CD_STIFFNESS_V, 3, 15);
    push(membrane, 0.2, 16);
    ok(cd_membrane_enable_field(membrane, CD_PIN));
    sheet_set(membrane, CD_PIN, 2, 3, CD_NODE_PINNED);
    ok(cd_membrane_attach(membrane, 3, 2, 25, 0.25, NULL, components));
    sheet_set(membrane, CD_STIFFNESS_U, 1, 1, 0);
    ok(cd_membrane_enable_field(membrane, CD_MASK));
    sheet_set(membrane, CD_MASK, 1, 3, 0);
}

void cloth_everything(cd_membrane* membrane) { all_fields(membrane); }

void cloth_everything_tube(cd_membrane* membrane) {
    ok(cd_membrane_set_ring(membrane, 0, 1));
    all_fields(membrane);
}

/* Springs as long as a sheet laid out by this spacing has them. */
static void give_lengths(cd_membrane* membrane, double spacing) {
    size_t nu, nv;
    ok(cd_membrane_get_shape(membrane, &nu, &nv, NULL, NULL));
    ok(cd_membrane_set_rest_length(membrane, spacing * (double)nu, spacing * (double)nv));
}

void cloth_meet(cd_membrane* membrane) {
    const double low[3] = {0, 0.25, -0.25}, up[3] = {0.125, -0.25, 2}, ball[3] = {0.25, 0.125, -0.125};
    const double arm[3] = {0.5, 0.25, -0.25}, hand[3] = {0.375, 0.5, -0.125}, slow[3] = {0.25, -0.125, 0.5};
    ok(cd_membrane_set_colliders(membrane, 4));
    ok(cd_membrane_set_plane(membrane, 0, low, up, 3, 0.5));
    ok(cd_membrane_set_capsule(membrane, 1, ball, ball, 3, 0.1, 0.25));
    ok(cd_membrane_set_collider_velocity(membrane, 1, slow, 3));
    ok(cd_membrane_set_capsule(membrane, 3, arm, hand, 3, 0.0625, 0));
    ok(cd_membrane_set_thickness(membrane, 0.015625));
}

void cloth_assert_defaults(const cd_membrane* membrane) {
    double length[2] = {-1, -1}, shear = -1, rate = -1, air[2] = {-1, -1}, wind[4] = {-1, -1, -1, -1}, thickness = -1;
    double breaking = -1;
    size_t components, newton = 0, gradient = 0, colliders = 9, broken = 9;
    ok(cd_membrane_get_shape(membrane, NULL, NULL, &components, NULL));
    ok(cd_membrane_get_rest_length(membrane, &length[0], &length[1]));
    ok(cd_membrane_get_shear(membrane, &shear));
    ok(cd_membrane_get_compression(membrane, &rate));
    ok(cd_membrane_get_effort(membrane, &newton, &gradient));
    ok(cd_membrane_get_air(membrane, &air[0], &air[1]));
    ok(cd_membrane_get_wind(membrane, wind, components));
    ok(cd_membrane_get_colliders(membrane, &colliders));
    ok(cd_membrane_get_thickness(membrane, &thickness));
    ok(cd_membrane_get_breaking_strain(membrane, &breaking));
    ok(cd_membrane_get_broken(membrane, &broken));
    assert_true(length[0] == 0 && length[1] == 0 && shear == 0 && rate == 80 && newton == 3 && gradient == 0);
    assert_true(air[0] == 0 && air[1] == 0 && colliders == 0 && thickness == 0);
    assert_true(isinf(breaking) && breaking > 0 && broken == 0);
    for (size_t k = 0; k < components; ++k) assert_true(wind[k] == 0);
}

void cloth_sail(cd_membrane* membrane) {
    const double wind[3] = {0.5, 0, 4};
    cloth_lay_out(membrane, 0.1);
    give_lengths(membrane, 0.1);
    ok(cd_membrane_set_mass(membrane, 0.25));
    ok(cd_membrane_set_stiffness(membrane, 300, 300));
    ok(cd_membrane_set_shear(membrane, 100));
    ok(cd_membrane_set_air(membrane, 0.05, 1.25));
    ok(cd_membrane_set_wind(membrane, wind, 3));
    ok(cd_membrane_enable_field(membrane, CD_PIN));
    sheet_set(membrane, CD_PIN, 0, 0, CD_NODE_PINNED);
    sheet_set(membrane, CD_PIN, cloth_extent(membrane, CD_PIN).columns - 1, 0, CD_NODE_PINNED);
}

static void all_of_cloth(cd_membrane* membrane) {
    ok(cd_membrane_set_mass(membrane, 2));
    ok(cd_membrane_set_mass_rule(membrane, CD_MASS_HALF_ENDS));
    ok(cd_membrane_set_stiffness(membrane, 500, 400));
    ok(cd_membrane_set_bend(membrane, 0.002));
    ok(cd_membrane_set_drag(membrane, 0.2));
    ok(cd_membrane_set_pressure(membrane, -0.25));
    set_gravity(membrane, -9.81);
    give_lengths(membrane, 0.1);
    ok(cd_membrane_set_lambda(membrane, 0.875));
    ok(cd_membrane_set_shear(membrane, 150));
    ok(cd_membrane_set_compression(membrane, 6));
    ok(cd_membrane_set_effort(membrane, 3, 11));
    drive(membrane, CD_EDGE_U_FIRST, 0.1);
    ok(cd_membrane_set_edge(membrane, CD_EDGE_V_FIRST, CD_NODE_PINNED));
    cloth_lay_out(membrane, 0.1);
    cloth_shake(membrane, 0.01, 17);
    vary(membrane, CD_MASS, 0.05, 18);
    vary(membrane, CD_STIFFNESS_U, 400, 19);
    vary(membrane, CD_STIFFNESS_V, 300, 20);
    vary(membrane, CD_REST_LENGTH_U, 0.1, 21);
    vary(membrane, CD_REST_LENGTH_V, 0.09, 22);
    vary(membrane, CD_BREAKING_STRAIN_U, 1, 25); /* some tear in the first steps */
    vary(membrane, CD_BREAKING_STRAIN_V, 1, 26);
    push(membrane, 0.2, 23);
    ok(cd_membrane_enable_field(membrane, CD_PIN));
    sheet_set(membrane, CD_PIN, 2, 3, CD_NODE_PINNED);
    ok(cd_membrane_attach(membrane, 3, 2, 25, 0.25, NULL, 3));
    sheet_set(membrane, CD_STIFFNESS_U, 1, 1, 0);
    ok(cd_membrane_enable_field(membrane, CD_MASK));
    sheet_set(membrane, CD_MASK, 1, 3, 0);
    ok(cd_membrane_set_air(membrane, 0.05, 0.75));
    vary(membrane, CD_WIND, 2, 24);
    cloth_meet(membrane);
}

void cloth_lengths(cd_membrane* membrane) { all_of_cloth(membrane); }

void cloth_lengths_tube(cd_membrane* membrane) {
    ok(cd_membrane_set_ring(membrane, 0, 1));
    all_of_cloth(membrane);
}

const struct cloth_scene length_cloths[LENGTH_CLOTHS] = {
    {"sail", cloth_sail},
    {"lengths", cloth_lengths},
    {"lengths, tube", cloth_lengths_tube},
};

const struct cloth_scene cloths[CLOTHS] = {
    {"drum", cloth_drum},
    {"curtain", cloth_curtain},
    {"flag", cloth_flag},
    {"plate", cloth_plate},
    {"tube", cloth_tube},
    {"torus", cloth_torus},
    {"torn", cloth_torn},
    {"tied", cloth_tied},
    {"everything", cloth_everything},
    {"everything, tube", cloth_everything_tube},
};
