#include "kept.h"

#include <stdlib.h>
#include <string.h>

#include "cloth.h"
#include "pool.h"
#include "scene.h"

size_t kind_saved_size(const struct kind* kind, const any* object) {
    size_t size = 0;
    ok(kind->save_size(object, &size));
    return size;
}

struct blob kind_save(const struct kind* kind, const any* object) {
    struct blob blob = {NULL, kind_saved_size(kind, object)};
    size_t written = 0;
    assert_true(blob.size > 0);
    blob.bytes = malloc(blob.size);
    assert_non_null(blob.bytes);
    ok(kind->save(object, blob.bytes, blob.size, &written));
    assert_int_equal(written, blob.size);
    return blob;
}

void kind_take(const struct kind* kind, any* object, const any* source, int by_copy) {
    struct blob blob = kind_save(kind, source);
    if (by_copy) ok(kind->copy_state(object, source));
    else ok(kind->load(object, blob.bytes, blob.size));
    free(blob.bytes);
}

/* ---- scenes ---- */

static any* build_chain(any* chain, size_t scene) {
    if (scene >= SCENES) rope_scenes[scene - SCENES].build(chain);
    else scenes[scene].build(chain);
    return chain;
}

static any* build_membrane(any* membrane, size_t scene) {
    if (scene >= CLOTHS) length_cloths[scene - CLOTHS].build(membrane);
    else cloths[scene].build(membrane);
    return membrane;
}

static any* build_water(any* water, size_t scene) {
    pools[scene].build(water);
    return water;
}

const struct kept_kind kept_kinds[KINDS] = {
    {&kinds[CHAIN], {2, 12, 3}, SCENES + ROPE_SCENES, {8, SCENES}, {3, 0}, build_chain},
    {&kinds[MEMBRANE], {6, 5, 3}, CLOTHS + LENGTH_CLOTHS, {8, CLOTHS + 1}, {3, 0}, build_membrane},
    {&kinds[WATER], {6, 5, 1}, POOLS, {POOL_EVERYTHING, POOLS - 2}, {0, 1}, build_water},
};

any* kept_new(const struct kept_kind* kept, const size_t* shape, cd_precision precision) {
    any* object = NULL;
    const size_t* const s = shape ? shape : kept->shape;
    ok(kept->kind->create(s[0], s[1], s[2], precision, NULL, &object));
    return object;
}

size_t kept_methods(const struct kept_kind* kept, size_t scene) {
    const size_t with_any = kept->kind == &kinds[CHAIN] ? SCENES : kept->kind == &kinds[MEMBRANE] ? CLOTHS : 0;
    return scene < with_any ? CD_METHOD_STIFF_SECOND + 1 : 1;
}

double kept_dt(const struct kept_kind* kept, size_t scene) {
    return kept->kind == &kinds[WATER] ? pools[scene].dt : 0.001;
}

any* kept_scene(const struct kept_kind* kept, size_t scene, cd_precision precision, cd_method method) {
    any* object = NULL;
    if (kept->kind == &kinds[WATER]) object = pool(kept->shape[0], kept->shape[1], precision);
    else object = kept_new(kept, NULL, precision);
    kept->build(object, scene);
    if (kept_methods(kept, scene) > 1) ok(kept->kind->set_method(object, method));
    ok(kept->kind->step(object, kept_dt(kept, scene), 7));
    return object;
}

/* ---- all that can be read ---- */

union slot {
    double number;
    uint64_t steps;
    size_t size;
    int32_t whole;
};
enum { SLOTS = 1 << 17 };
static struct {
    union slot slots[SLOTS];
    const char* calls[SLOTS]; /* that told them */
    size_t count;
} both[2], *told;

static union slot* room(const char* call, size_t count) {
    union slot* const first = told->slots + told->count;
    assert_true(told->count + count <= SLOTS);
    memset(first, 0, count * sizeof *first);
    for (size_t i = 0; i < count; ++i) told->calls[told->count++] = call;
    return first;
}

/* Calls with one output, and room for the outputs of a call. */
#define NUMBER(call) ok(call(o, NUMBERS(call, 1)))
#define WHOLE(call) ok(call(o, WHOLES(call)))
#define NUMBERS(call, count) (&room(#call, (count))->number)
#define WHOLES(call) (&room(#call, 1)->whole)
#define SIZES(call) (&room(#call, 1)->size)

/* Which not all have: ropes and cloth no limit, membranes in a plane no volume. */
#define NUMBER_IF_ANY(call) is_any(*WHOLES(call) = call(o, NUMBERS(call, 1)))
static void is_any(cd_status status) { assert_true(status == CD_OK || status == CD_ERROR_UNSUPPORTED); }
static void is_told(cd_status status) { assert_true(status == CD_OK || status == CD_ERROR_DISABLED); }

#define BODY(body)                                                                                                  \
    do {                                                                                                            \
        size_t components, colliders;                                                                               \
        ok(cd_##body##_get_shape(o, NULL, NULL, &components, NULL));                                                \
        ok(cd_##body##_get_colliders(o, &colliders));                                                               \
        *SIZES(cd_##body##_get_colliders) = colliders;                                                              \
        NUMBER(cd_##body##_get_lambda), NUMBER(cd_##body##_get_mass), NUMBER(cd_##body##_get_bend);                 \
        NUMBER(cd_##body##_get_drag), NUMBER(cd_##body##_get_stiffness_damping), NUMBER(cd_##body##_get_thickness); \
        WHOLE(cd_##body##_get_method), WHOLE(cd_##body##_get_mass_rule), WHOLE(cd_##body##_get_loads);              \
        NUMBER_IF_ANY(cd_##body##_stable_dt);                                                                       \
        ok(cd_##body##_get_tolerance(o, NUMBERS(get_tolerance, 1), SIZES(get_tolerance)));                          \
        ok(cd_##body##_get_gravity(o, NUMBERS(get_gravity, components), components));                               \
        ok(cd_##body##_get_wind(o, NUMBERS(get_wind, components), components));                                     \
        ok(cd_##body##_get_air(o, NUMBERS(get_air, 1), NUMBERS(get_air, 1)));                                       \
        ok(cd_##body##_get_sleep(o, NUMBERS(get_sleep, 1), NUMBERS(get_sleep, 1)));                                 \
        ok(cd_##body##_get_awake(o, SIZES(get_awake)));                                                             \
        for (size_t i = 0; i < colliders; ++i) {                                                                    \
            double* const x = NUMBERS(get_collider, 3 * components + 2);                                            \
            double *const second = x + components, *const v = second + components, *const radius = v + components;  \
            ok(cd_##body##_get_collider(o, i, WHOLES(get_collider), x, second, v, components, radius, radius + 1)); \
            is_told(cd_##body##_get_collider_load(o, i, NUMBERS(get_collider_load, 6), 6));                         \
        }                                                                                                           \
    } while (0)

static void tell_chain(const cd_chain* o) {
    const size_t nodes = scene_nodes(o);
    BODY(chain);
    NUMBER(cd_chain_get_stiffness), NUMBER(cd_chain_get_rest_length), NUMBER(cd_chain_get_strength);
    NUMBER(cd_chain_get_rest_angle);
    WHOLE(cd_chain_get_ring), WHOLE(cd_chain_get_push);
    for (size_t k = 0; k < scene_own_strands(o) * nodes; ++k) {
        double* const attached = NUMBERS(cd_chain_get_attachment, 2);
        ok(cd_chain_get_attachment(o, k / nodes, k % nodes, attached, attached + 1));
    }
}

static void tell_membrane(const cd_membrane* o) {
    size_t nu, nv, components;
    BODY(membrane);
    NUMBER(cd_membrane_get_pressure), NUMBER_IF_ANY(cd_membrane_get_volume), NUMBER(cd_membrane_get_shear);
    NUMBER(cd_membrane_get_compression), NUMBER(cd_membrane_get_breaking_strain), WHOLE(cd_membrane_get_solver);
    ok(cd_membrane_get_stiffness(o, NUMBERS(get_stiffness, 1), NUMBERS(get_stiffness, 1)));
    ok(cd_membrane_get_rest_length(o, NUMBERS(get_rest_length, 1), NUMBERS(get_rest_length, 1)));
    ok(cd_membrane_get_ring(o, WHOLES(get_ring), WHOLES(get_ring)));
    ok(cd_membrane_get_effort(o, SIZES(get_effort), SIZES(get_effort)));
    for (cd_edge edge = CD_EDGE_U_FIRST; edge <= CD_EDGE_V_LAST; ++edge)
        ok(cd_membrane_get_edge(o, edge, WHOLES(get_edge)));
    ok(cd_membrane_get_shape(o, &nu, &nv, &components, NULL));
    for (size_t k = 0; k < (nu + 1) * (nv + 1); ++k) {
        double* const attached = NUMBERS(cd_membrane_get_attachment, 2);
        ok(cd_membrane_get_attachment(o, k % (nu + 1), k / (nu + 1), attached, attached + 1));
        ok(cd_membrane_get_reaction(o, k % (nu + 1), k / (nu + 1), NUMBERS(cd_membrane_get_reaction, 4), components));
    }
}

static void tell_water(const cd_water* o) {
    NUMBER(cd_water_get_lambda), NUMBER(cd_water_get_gravity), NUMBER(cd_water_get_density), NUMBER(cd_water_get_drag);
    NUMBER(cd_water_get_manning), NUMBER(cd_water_stable_dt), NUMBER(cd_water_get_volume);
    NUMBER(cd_water_get_wet_area);
    WHOLE(cd_water_get_method), WHOLE(cd_water_get_momentum), WHOLE(cd_water_get_first), WHOLE(cd_water_get_bed_rule);
    ok(cd_water_get_shape(o, NULL, NULL, NUMBERS(get_shape, 1), NUMBERS(get_shape, 1), NULL));
    ok(cd_water_get_energy(o, NUMBERS(get_energy, 1), NUMBERS(get_energy, 1)));
    ok(cd_water_get_courant(o, 0.1, NUMBERS(get_courant, 1)));
    double* const account = NUMBERS(get_account, 4);
    ok(cd_water_get_account(o, account, account + 1, account + 2, account + 3));
    for (cd_side side = CD_SIDE_X_FIRST; side <= CD_SIDE_Y_LAST; ++side)
        ok(cd_water_get_side(o, side, WHOLES(get_side), NUMBERS(get_side, 1), NUMBERS(get_side, 1)));
    for (cd_side side = CD_SIDE_X_FIRST; side <= CD_SIDE_Y_LAST; ++side)
        ok(cd_water_get_inflow_depth(o, side, NUMBERS(get_inflow_depth, 1)));
}

static void tell(const struct kind* kind, const any* o) {
    told->count = 0;
    if (kind == &kinds[CHAIN]) tell_chain(o);
    if (kind == &kinds[MEMBRANE]) tell_membrane(o);
    if (kind == &kinds[WATER]) tell_water(o);
    NUMBER(kind->get_time);
    ok(kind->get_steps(o, &room("get_steps", 1)->steps));
    for (cd_field field = CD_POSITION; field <= CD_BREAKING_STRAIN_V; ++field) {
        const size_t count = kind_numbers(kind, o, field);
        room("number of a field's numbers", 1)->size = count;
        if (count) ok(kind->read(o, field, NUMBERS(a field, count), count));
    }
}

void kind_assert_same(const struct kind* kind, const any* a, const any* b) {
    for (int k = 0; k < 2; ++k) {
        told = &both[k];
        tell(kind, k ? b : a);
    }
    for (size_t i = 0; i < both[0].count && i < both[1].count; ++i) {
        const union slot* const x[2] = {&both[0].slots[i], &both[1].slots[i]};
        if (memcmp(x[0], x[1], sizeof *x[0]) != 0)
            fail_msg("two %ss differ in %s: %.17g and %.17g, or as whole numbers %llu and %llu", kind->name,
                     both[0].calls[i], x[0]->number, x[1]->number, (unsigned long long)x[0]->steps,
                     (unsigned long long)x[1]->steps);
    }
    assert_int_equal(both[0].count, both[1].count);
    if (kind_hash(kind, a) != kind_hash(kind, b)) fail_msg("two %ss differ in nothing but their hashes", kind->name);
}

void kept_assert_all(const struct kept_kind* kept, const any* object, cd_precision precision) {
    const struct kind* const kind = kept->kind;
    for (int by_copy = 0; by_copy < 2; ++by_copy)
        for (int fresh = 0; fresh < 2; ++fresh) {
            any* other = kept_new(kept, NULL, precision);
            if (!fresh) kept->build(other, kept->fullest[1]);
            kind_take(kind, other, object, by_copy);
            kind_assert_same(kind, other, object);
            kind->destroy(other);
        }
}
