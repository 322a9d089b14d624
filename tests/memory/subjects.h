/* Chains, membranes and waters as test_allocator.c sees them: their scenes, and calls that may need memory. */
#ifndef SUBJECTS_H
#define SUBJECTS_H

#include "check.h"
#include "cloth.h"
#include "kind.h"
#include "nothing_near.h"
#include "pool.h"
#include "scene.h"

struct made {
    const char* text; /* null: there is no call of that number */
    bool never;       /* never allocates, in any scene */
    cd_status status;
};

/* What the tests need to know of a kind. Of its scenes, `have_lengths` from number `lengths` on are of springs that
 * have a length, and with it more fields; the two after these are without anything, and the last of all is explicit, so
 * that it holds no factorization. */
struct subject {
    const struct kind* kind;
    bool (*has_field)(cd_field field, bool lengths);
    const char* (*build)(any* object, size_t scene); /* tells its name */
    struct made (*call)(any* object, size_t number);
    bool (*may_not_step)(const any* object, cd_status status);
    void (*surround)(any* object, bool on); /* one that has lengths; when no longer on, the lengths go too */
    size_t first, second;                   /* the shape of objects that calls are made on */
    size_t wide, high;                      /* the same of objects so large that a step is spread over several tasks */
    double dt;
    size_t scenes, lengths, have_lengths;
    size_t everything, other; /* scenes of objects that others load and copy */
};

/* In a function with a `number` and an `i` that starts at 0: the next call of a list, which is made if it is that of
 * the number. */
#define NAMED(text, never, call)              \
    if (i++ == number) return (struct made) { \
            text, never, call                 \
        }
#define CALL(call) NAMED(#call, false, call)
#define NEVER(call) NAMED(#call, true, call)

enum { COMPONENTS = 3 };
static const double target[COMPONENTS] = {1, 2, 3};
static const double hills[6] = {-9, -8, -9, -8, -9, -8};

/* For a chain of 9 springs. */
static struct made chain_call(any* c, size_t number) {
    size_t i = 0;
    CALL(cd_chain_set_bend(c, 0.01));
    CALL(cd_chain_set_bend(c, 0));
    CALL(cd_chain_set_ring(c, 1));
    CALL(cd_chain_set_ring(c, 0));
    CALL(cd_chain_set_end(c, CD_END_FIRST, CD_NODE_POSED));
    CALL(cd_chain_attach(c, 0, 2, 5, 1, target, COMPONENTS));
    CALL(cd_chain_cut(c, 0, 3));
    CALL(cd_chain_weld(c, 0, 6));
    CALL(cd_chain_set_rest_length(c, 0.9));
    CALL(cd_chain_set_rest_length(c, 0));
    CALL(cd_chain_set_air(c, 0.1, 0.2));
    CALL(cd_chain_set_rest_angle(c, 1));
    CALL(cd_chain_set_strength(c, 1e6));
    CALL(cd_chain_set_colliders(c, 1));
    CALL(cd_chain_set_colliders(c, 6));
    CALL(cd_chain_set_loads(c, 1));
    CALL(cd_chain_set_colliders(c, 0));
    CALL(cd_chain_set_capsule(c, 0, target, target, COMPONENTS, 0.5, 1));
    CALL(cd_chain_set_bed(c, 0, target, COMPONENTS, 3, 2, 1, 1, hills, 6, 0));
    CALL(cd_chain_set_bed(c, 0, target, COMPONENTS, 2, 2, 1, 1, hills, 4, 0));
    CALL(cd_chain_set_callback(c, 0, &nothing_near, target, COMPONENTS, 0));
    CALL(cd_chain_remove_collider(c, 0));
    NEVER(cd_chain_set_push(c, 1));
    NEVER(cd_chain_set_tolerance(c, 1e-7, 50));
    NEVER(cd_chain_set_thickness(c, 0.01));
    return (struct made){NULL, false, CD_OK};
}

/* For a membrane of 6 springs or more each way. */
static struct made membrane_call(any* m, size_t number) {
    size_t i = 0;
    CALL(cd_membrane_set_solver(m, CD_SOLVER_COUPLED));
    CALL(cd_membrane_set_solver(m, CD_SOLVER_ALTERNATING));
    CALL(cd_membrane_set_bend(m, 0.01));
    CALL(cd_membrane_set_bend(m, 0));
    CALL(cd_membrane_set_pressure(m, 0.5));
    CALL(cd_membrane_set_pressure(m, 0));
    CALL(cd_membrane_set_ring(m, 0, 1));
    CALL(cd_membrane_set_ring(m, 0, 0));
    CALL(cd_membrane_set_edge(m, CD_EDGE_U_FIRST, CD_NODE_PINNED));
    CALL(cd_membrane_set_edge(m, CD_EDGE_U_LAST, CD_NODE_MATCHED));
    CALL(cd_membrane_attach(m, 2, 2, 5, 1, target, COMPONENTS));
    CALL(cd_membrane_set_rest_length(m, 0.7, 0.6));
    CALL(cd_membrane_set_rest_length(m, 0, 0));
    CALL(cd_membrane_set_air(m, 0.125, 1));
    CALL(cd_membrane_set_air(m, 0, 0));
    CALL(cd_membrane_set_colliders(m, 1));
    CALL(cd_membrane_set_colliders(m, 6));
    CALL(cd_membrane_set_loads(m, 1));
    CALL(cd_membrane_set_colliders(m, 0));
    CALL(cd_membrane_set_capsule(m, 0, target, target, COMPONENTS, 0.5, 1));
    CALL(cd_membrane_set_bed(m, 0, target, COMPONENTS, 3, 2, 1, 1, hills, 6, 0));
    CALL(cd_membrane_set_bed(m, 0, target, COMPONENTS, 2, 2, 1, 1, hills, 4, 0));
    CALL(cd_membrane_set_callback(m, 0, &nothing_near, target, COMPONENTS, 0));
    CALL(cd_membrane_remove_collider(m, 0));
    CALL(cd_membrane_set_breaking_strain(m, 9));
    NEVER(cd_membrane_set_shear(m, 50));
    NEVER(cd_membrane_impulse(m, 3, 2, 2.5, target, COMPONENTS));
    return (struct made){NULL, false, CD_OK};
}

static struct made water_call(any* w, size_t number) {
    size_t i = 0;
    CALL(cd_water_set_momentum(w, CD_MOMENTUM_LINEAR));
    CALL(cd_water_set_momentum(w, CD_MOMENTUM_ADVECTED));
    CALL(cd_water_add_source(w, 1, 1, 1, 0.125));
    CALL(cd_water_add_source_rectangle(w, 1, 1, 3, 2, 0.125));
    CALL(cd_water_set_hulls(w, 5, 8, 3));
    CALL(cd_water_set_hulls(w, 0, 0, 0));
    CALL(cd_water_set_sleep(w, 0.001));
    CALL(cd_water_set_sleep(w, 0));
    NEVER(cd_water_set_side(w, CD_SIDE_X_FIRST, CD_BORDER_OPEN, 0.125, 0));
    NEVER(cd_water_set_side(w, CD_SIDE_Y_FIRST, CD_BORDER_PERIODIC, 0, 0));
    NEVER(cd_water_set_inflow_depth(w, CD_SIDE_X_FIRST, 0.125));
    NEVER(cd_water_add_volume(w, 1, 1, 1, 0.125, NULL));
    NEVER(cd_water_splash(w, 1, 1, 1, 0.125));
    NEVER(cd_water_impulse(w, 1, 1, 1, 0.125, 1));
    return (struct made){NULL, false, CD_OK};
}

/* ---- chains */

static bool chain_has_field(cd_field field, bool lengths) {
    return field <= CD_TARGET || (lengths && field >= CD_REST_LENGTH && field <= CD_STRAIN);
}

static const char* chain_build(any* c, size_t scene) {
    if (scene >= SCENES + ROPE_SCENES) return scene_lay_out(c, 0.1), "nothing";
    const struct scene* of = scene < SCENES ? &scenes[scene] : &rope_scenes[scene - SCENES];
    return of->build(c), of->name;
}

/* A rope has no ring, and not every method. */
static bool chain_may_not_step(const any* c, cd_status status) {
    double length;
    ok(cd_chain_get_rest_length(c, &length));
    return length != 0 && (status == CD_ERROR_UNSUPPORTED || status == CD_ERROR_TOLERANCE);
}

static void chain_surround(any* c, bool on) {
    if (on) ok(cd_chain_set_colliders(c, 9));
    if (on) return;
    ok(cd_chain_set_stiffness(c, 1));
    for (size_t i = 0; i < scene_nodes(c); ++i) scene_set(c, CD_PIN, i, CD_NODE_FREE);
    ok(cd_chain_set_rest_length(c, 0));
}

/* ---- membranes */

static bool membrane_has_field(cd_field field, bool lengths) {
    if (field <= CD_MASK) return field != CD_STIFFNESS && field != CD_BEND;
    return lengths && (field == CD_WIND || (field >= CD_REST_LENGTH_U && field <= CD_BREAKING_STRAIN_V));
}

static const char* membrane_build(any* m, size_t scene) {
    if (scene >= CLOTHS + LENGTH_CLOTHS) return cloth_lay_out(m, 0.1), "nothing";
    const struct cloth_scene* of = scene < CLOTHS ? &cloths[scene] : &length_cloths[scene - CLOTHS];
    return of->build(m), of->name;
}

/* Cloth has not every method, and no matched edge. */
static bool membrane_may_not_step(const any* m, cd_status status) {
    double length[2];
    ok(cd_membrane_get_rest_length(m, &length[0], &length[1]));
    return length[0] != 0 && status == CD_ERROR_UNSUPPORTED;
}

static void membrane_surround(any* m, bool on) {
    ok(cd_membrane_set_colliders(m, on ? 9 : 0));
    if (!on) ok(cd_membrane_set_rest_length(m, 0, 0));
}

/* ---- waters */

static bool water_has_field(cd_field field, bool lengths) {
    (void)lengths;
    return field >= CD_MASK && field <= CD_WALL_Y;
}

static const char* water_build(any* w, size_t scene) {
    if (scene >= POOLS) return pool_fill(w, CD_DEPTH, 1), "nothing";
    return pools[scene].build(w), pools[scene].name;
}

static bool water_may_not_step(const any* w, cd_status status) {
    (void)w, (void)status;
    return false;
}

static void water_surround(any* w, bool on) { (void)w, (void)on; }

#define SUBJECT(number, kind, ...) \
    { &kinds[number], kind##_has_field, kind##_build, kind##_call, kind##_may_not_step, kind##_surround, __VA_ARGS__ }

static const struct subject subjects[KINDS] = {
    SUBJECT(0, chain, 2, 9, 500, 9, 0.001, SCENES + ROPE_SCENES + 2, SCENES, ROPE_SCENES, 8, SCENES),
    SUBJECT(1, membrane, 7, 6, 150, 120, 0.001, CLOTHS + LENGTH_CLOTHS + 2, CLOTHS, LENGTH_CLOTHS, 8, CLOTHS + 1),
    SUBJECT(2, water, 9, 7, 33, 31, 0.002, POOLS + 2, POOLS, 0, POOL_EVERYTHING, POOL_TORUS)};

#endif
