#include "scene.h"

#include <math.h>
#include <stdlib.h>

#include "check.h"

cd_chain* scene_chain_from(const cd_allocator* allocator, size_t strands, size_t springs, size_t components,
                           cd_precision precision) {
    cd_chain* chain = NULL;
    ok(cd_chain_create(strands, springs, components, precision, allocator, &chain));
    assert_non_null(chain);
    return chain;
}

cd_chain* scene_chain(size_t strands, size_t springs, size_t components, cd_precision precision) {
    return scene_chain_from(NULL, strands, springs, components, precision);
}

size_t scene_strands(const cd_chain* chain) {
    size_t strands;
    ok(cd_chain_get_shape(chain, &strands, NULL, NULL, NULL));
    return strands;
}

size_t scene_nodes(const cd_chain* chain) {
    size_t springs;
    ok(cd_chain_get_shape(chain, NULL, &springs, NULL, NULL));
    return springs + 1;
}

size_t scene_springs(const cd_chain* chain) {
    int32_t ring;
    ok(cd_chain_get_ring(chain, &ring));
    return scene_nodes(chain) - (ring ? 0 : 1);
}

size_t scene_components(const cd_chain* chain) {
    size_t components;
    ok(cd_chain_get_shape(chain, NULL, NULL, &components, NULL));
    return components;
}

static int is_per_strand(cd_field field) {
    return field == CD_POSITION || field == CD_VELOCITY || field == CD_FORCE || field == CD_TARGET || field == CD_WIND;
}

static int is_per_spring(cd_field field) {
    return field == CD_STIFFNESS || (field >= CD_REST_LENGTH && field != CD_WIND);
}

size_t scene_own_strands(const cd_chain* chain) {
    double length;
    ok(cd_chain_get_rest_length(chain, &length));
    return length > 0 ? scene_strands(chain) : 1;
}

size_t scene_field_strands(const cd_chain* chain, cd_field field) {
    return is_per_strand(field) ? scene_strands(chain) : scene_own_strands(chain);
}

size_t scene_field_items(const cd_chain* chain, cd_field field) {
    return is_per_spring(field) ? scene_springs(chain) : scene_nodes(chain);
}

size_t scene_field_count(const cd_chain* chain, cd_field field) {
    const size_t each = is_per_strand(field) ? scene_components(chain) : 1;
    return scene_field_strands(chain, field) * scene_field_items(chain, field) * each;
}

void scene_read(const cd_chain* chain, cd_field field, double* out_values) {
    ok(cd_chain_read_f64(chain, field, 0, scene_field_strands(chain, field), 0, scene_field_items(chain, field),
                         out_values, scene_field_count(chain, field)));
}

void scene_write(cd_chain* chain, cd_field field, const double* values) {
    ok(cd_chain_write_f64(chain, field, 0, scene_field_strands(chain, field), 0, scene_field_items(chain, field),
                          values, scene_field_count(chain, field)));
}

double scene_get(const cd_chain* chain, cd_field field, size_t item) {
    double value;
    ok(cd_chain_read_f64(chain, field, 0, 1, item, 1, &value, 1));
    return value;
}

void scene_set(cd_chain* chain, cd_field field, size_t item, double value) {
    for (size_t strand = 0; strand < scene_field_strands(chain, field); ++strand)
        ok(cd_chain_write_f64(chain, field, strand, 1, item, 1, &value, 1));
}

double scene_noise(uint64_t* seed) { /* splitmix64 */
    uint64_t z = (*seed += 0x9E3779B97F4A7C15u) ^ other_scenes();
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
    z ^= z >> 31;
    return (double)(int64_t)z * 0x1p-63;
}

static double* new_numbers(size_t count) {
    double* numbers = calloc(count ? count : 1, sizeof *numbers);
    assert_non_null(numbers);
    return numbers;
}

void scene_lay_out(cd_chain* chain, double spacing) {
    const size_t nodes = scene_nodes(chain), components = scene_components(chain);
    double* x = new_numbers(scene_field_count(chain, CD_POSITION));
    for (size_t strand = 0; strand < scene_strands(chain); ++strand) {
        for (size_t node = 0; node < nodes; ++node) {
            double* at = x + (strand * nodes + node) * components;
            at[0] = (double)node * spacing;
            if (components > 1) at[1] = (double)strand;
        }
    }
    scene_write(chain, CD_POSITION, x);
    free(x);
}

void scene_shake(cd_chain* chain, double size, uint64_t seed) {
    const size_t nodes = scene_nodes(chain), components = scene_components(chain);
    const size_t count = scene_field_count(chain, CD_POSITION);
    double* x = new_numbers(count);
    double* v = new_numbers(count);
    double* pin = new_numbers(scene_field_count(chain, CD_PIN));
    scene_read(chain, CD_POSITION, x);
    scene_read(chain, CD_VELOCITY, v);
    scene_read(chain, CD_PIN, pin);
    for (size_t i = 0; i < count; ++i) {
        const double kind = pin[i / components % (nodes * scene_own_strands(chain))];
        x[i] += size * scene_noise(&seed);
        if (kind == CD_NODE_FREE || kind == CD_NODE_MATCHED) v[i] += size * scene_noise(&seed);
    }
    scene_write(chain, CD_POSITION, x);
    scene_write(chain, CD_VELOCITY, v);
    free(x);
    free(v);
    free(pin);
}

static void set_gravity(cd_chain* chain, double down) {
    const double gravity[4] = {0.25, down, -0.5, 1};
    const size_t components = scene_components(chain);
    ok(cd_chain_set_gravity(chain, components == 1 ? gravity + 1 : gravity, components));
}

/* A different number, around 1, at every node or spring. */
static void vary(cd_chain* chain, cd_field field, double size, uint64_t seed) {
    ok(cd_chain_enable_field(chain, field));
    for (size_t i = 0; i < scene_field_items(chain, field); ++i) {
        if (field == CD_BEND && scene_get(chain, field, i) == 0) continue; /* the ends have none */
        scene_set(chain, field, i, size * (1 + 0.5 * scene_noise(&seed)));
    }
}

/* Other numbers at every node of every strand: of forces, or of the wind. */
static void scatter(cd_chain* chain, cd_field field, double size, uint64_t seed) {
    const size_t count = scene_field_count(chain, field);
    double* numbers = new_numbers(count);
    for (size_t i = 0; i < count; ++i) numbers[i] = size * scene_noise(&seed);
    ok(cd_chain_enable_field(chain, field));
    scene_write(chain, field, numbers);
    free(numbers);
}
static void push(cd_chain* chain, double size, uint64_t seed) { scatter(chain, CD_FORCE, size, seed); }

static void drive(cd_chain* chain, size_t node, double velocity) {
    const size_t strands = scene_strands(chain), components = scene_components(chain);
    double* v = new_numbers(strands * components);
    for (size_t i = 0; i < strands * components; ++i) v[i] = velocity * (double)(1 + i % components);
    scene_set(chain, CD_PIN, node, CD_NODE_DRIVEN);
    ok(cd_chain_write_f64(chain, CD_VELOCITY, 0, strands, node, 1, v, strands * components));
    free(v);
}

void scene_rope(cd_chain* chain) {
    ok(cd_chain_set_mass(chain, 0.5));
    ok(cd_chain_set_stiffness(chain, 40));
    set_gravity(chain, -9.81);
    ok(cd_chain_set_end(chain, CD_END_FIRST, CD_NODE_PINNED));
    scene_lay_out(chain, 0.1);
    scene_shake(chain, 0.01, 1);
}

void scene_net(cd_chain* chain) {
    ok(cd_chain_set_mass_rule(chain, CD_MASS_HALF_ENDS));
    ok(cd_chain_set_stiffness(chain, 3));
    ok(cd_chain_set_end(chain, CD_END_FIRST, CD_NODE_PINNED));
    ok(cd_chain_set_end(chain, CD_END_LAST, CD_NODE_PINNED));
    scene_lay_out(chain, 0.05);
    scene_shake(chain, 0.02, 2);
    push(chain, 0.1, 3);
}

void scene_hair(cd_chain* chain) {
    ok(cd_chain_set_stiffness(chain, 20));
    ok(cd_chain_set_bend(chain, 0.01));
    ok(cd_chain_set_drag(chain, 0.3));
    ok(cd_chain_set_stiffness_damping(chain, 0.002));
    set_gravity(chain, -9.81);
    scene_set(chain, CD_PIN, 0, CD_NODE_PINNED);
    scene_set(chain, CD_PIN, 1, CD_NODE_PINNED);
    scene_lay_out(chain, 0.02);
    scene_shake(chain, 0.005, 4);
}

void scene_ring(cd_chain* chain) {
    ok(cd_chain_set_ring(chain, 1));
    ok(cd_chain_set_stiffness(chain, 2));
    scene_lay_out(chain, 0.1);
    scene_shake(chain, 0.1, 5);
}

void scene_bent_ring(cd_chain* chain) {
    scene_ring(chain);
    ok(cd_chain_set_bend(chain, 0.003));
    ok(cd_chain_set_drag(chain, 0.1));
}

void scene_welded(cd_chain* chain) {
    const size_t springs = scene_springs(chain);
    ok(cd_chain_set_end(chain, CD_END_LAST, CD_NODE_PINNED));
    set_gravity(chain, -1);
    scene_lay_out(chain, 0.1);
    scene_shake(chain, 0.05, 6);
    for (size_t spring = 1; spring < springs / 2; ++spring) ok(cd_chain_weld(chain, 0, spring));
    ok(cd_chain_weld(chain, 0, springs - 1));
    ok(cd_chain_cut(chain, 0, springs / 2 + 1));
}

void scene_attached(cd_chain* chain) {
    const double target[4] = {0.5, -0.5, 0.25, 1};
    const size_t components = scene_components(chain);
    scene_lay_out(chain, 0.1);
    scene_shake(chain, 0.1, 7);
    ok(cd_chain_attach(chain, 0, 0, 30, 0.5, NULL, components));
    ok(cd_chain_attach(chain, 0, scene_nodes(chain) / 2, 8, 0, target, components));
    set_gravity(chain, -2);
}

void scene_driven(cd_chain* chain) {
    ok(cd_chain_set_mass_rule(chain, CD_MASS_HALF_ENDS));
    ok(cd_chain_set_end(chain, CD_END_LAST, CD_NODE_MATCHED));
    scene_lay_out(chain, 0.1);
    drive(chain, 0, -0.2);
}

static void all_fields(cd_chain* chain) {
    const size_t nodes = scene_nodes(chain);
    ok(cd_chain_set_mass(chain, 2));
    ok(cd_chain_set_mass_rule(chain, CD_MASS_HALF_ENDS));
    ok(cd_chain_set_stiffness(chain, 5));
    ok(cd_chain_set_bend(chain, 0.002));
    ok(cd_chain_set_drag(chain, 0.2));
    ok(cd_chain_set_stiffness_damping(chain, 0.001));
    ok(cd_chain_set_lambda(chain, 0.625));
    set_gravity(chain, -9.81);
    scene_lay_out(chain, 0.1);
    scene_shake(chain, 0.05, 8);
    vary(chain, CD_MASS, 0.2, 9);
    vary(chain, CD_STIFFNESS, 40, 10);
    vary(chain, CD_BEND, 1, 11);
    push(chain, 0.5, 12);
    scene_set(chain, CD_PIN, nodes / 2, CD_NODE_PINNED);
    drive(chain, 1, 0.1);
    ok(cd_chain_attach(chain, 0, 3, 25, 0.25, NULL, scene_components(chain)));
    ok(cd_chain_weld(chain, 0, nodes - 3));
    ok(cd_chain_cut(chain, 0, 3));
}

void scene_everything(cd_chain* chain) {
    ok(cd_chain_set_end(chain, CD_END_LAST, CD_NODE_MATCHED));
    all_fields(chain);
}

void scene_everything_ring(cd_chain* chain) {
    ok(cd_chain_set_ring(chain, 1));
    all_fields(chain);
}

/* A plane before the first nodes, a bar that moves between nodes 3 and 4 of all strands, a place that is free, and a
 * ball that nodes lie in. */
static void meet(cd_chain* chain) {
    const size_t components = scene_components(chain);
    const double edge[3] = {-0.02, 0.5, -0.25}, out_of[3] = {2, 0, 0.5}, ball[3] = {0.62, 0.01, 0.02};
    const double first[3] = {0.35, -1, 0}, last[3] = {0.35, 40, 0.25}, slow[3] = {0.1, 0.02, -0.01};
    ok(cd_chain_set_thickness(chain, 0.004));
    ok(cd_chain_set_colliders(chain, 4));
    ok(cd_chain_set_plane(chain, 0, edge, out_of, components, 0.5));
    ok(cd_chain_set_capsule(chain, 1, first, last, components, 0.045, 0.25));
    ok(cd_chain_set_collider_velocity(chain, 1, slow, components));
    ok(cd_chain_set_capsule(chain, 3, ball, ball, components, 0.03, 1));
}

void scene_lengths(cd_chain* chain) {
    const size_t nodes = scene_nodes(chain);
    ok(cd_chain_set_mass(chain, 2));
    ok(cd_chain_set_mass_rule(chain, CD_MASS_HALF_ENDS));
    ok(cd_chain_set_rest_length(chain, 0.1 * (double)scene_springs(chain)));
    ok(cd_chain_set_tolerance(chain, 1e-9, 200));
    ok(cd_chain_set_drag(chain, 0.2));
    ok(cd_chain_set_lambda(chain, 0.625));
    set_gravity(chain, -9.81);
    scene_lay_out(chain, 0.1);
    scene_shake(chain, 0.01, 13);
    vary(chain, CD_MASS, 0.2, 14);
    vary(chain, CD_STIFFNESS, 4000, 15);
    vary(chain, CD_REST_LENGTH, 0.1, 16);
    push(chain, 0.5, 17);
    scene_set(chain, CD_PIN, nodes / 2, CD_NODE_PINNED);
    drive(chain, 1, 0.1);
    for (size_t strand = 0; strand < scene_strands(chain); ++strand) {
        const double free_node = CD_NODE_FREE;
        if (strand % 4 != 2) ok(cd_chain_attach(chain, strand, 3, 25, 0.25, NULL, scene_components(chain)));
        if (strand % 5 != 3) ok(cd_chain_weld(chain, strand, nodes - 3));
        ok(cd_chain_cut(chain, strand, strand % 3 == 2 ? 2 : 3));
        if (strand % 4 == 1) ok(cd_chain_write_f64(chain, CD_PIN, strand, 1, nodes / 2, 1, &free_node, 1));
    }
    ok(cd_chain_set_air(chain, 0.03, 0.8));
    scatter(chain, CD_WIND, 2, 19);
    vary(chain, CD_STRENGTH, 1000, 20);
    if (scene_components(chain) == 2) {
        ok(cd_chain_set_rest_angle(chain, -1));
        vary(chain, CD_REST_ANGLE, 0.2, 21);
    }
    meet(chain);
}

void scene_links(cd_chain* chain) {
    set_gravity(chain, -9.81);
    scene_lay_out(chain, 0.1);
    ok(cd_chain_set_end(chain, CD_END_FIRST, CD_NODE_PINNED));
    scene_shake(chain, 0.001, 18);
    ok(cd_chain_set_rest_length(chain, 0.1 * (double)scene_springs(chain)));
    ok(cd_chain_set_stiffness(chain, INFINITY));
    ok(cd_chain_set_push(chain, 1));
    const double wind[3] = {1, -2, 0.5};
    ok(cd_chain_set_air(chain, 0.2, 0.1));
    ok(cd_chain_set_wind(chain, wind, scene_components(chain)));
}

void scene_curls(cd_chain* chain) {
    scene_links(chain);
    ok(cd_chain_set_bend(chain, 0.01));
    ok(cd_chain_set_lambda(chain, 0.75));
    if (scene_components(chain) != 2) return;
    ok(cd_chain_set_rest_angle(chain, 4));
    ok(cd_chain_enable_field(chain, CD_REST_ANGLE));
    for (size_t i = 0; i < scene_nodes(chain); i += 3) scene_set(chain, CD_REST_ANGLE, i, 0.3 * (double)i - 1);
}

const struct scene rope_scenes[ROPE_SCENES] = {
    {"lengths", scene_lengths}, {"links", scene_links}, {"curls", scene_curls}};

const struct scene scenes[SCENES] = {
    {"rope", scene_rope},
    {"net", scene_net},
    {"hair", scene_hair},
    {"ring", scene_ring},
    {"bent ring", scene_bent_ring},
    {"welded", scene_welded},
    {"attached", scene_attached},
    {"driven", scene_driven},
    {"everything", scene_everything},
    {"everything, ring", scene_everything_ring},
};
