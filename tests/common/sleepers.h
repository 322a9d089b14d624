/* Ropes, chains and sheets that come to rest, and what is asked of them: for tests of sleep, which include this once. */
#include <math.h>
#include <string.h>

#include "check.h"
#include "cloth.h"
#include "kept.h"
#include "scene.h"

enum { STRANDS = 5, SPRINGS = 6, NODES = SPRINGS + 1, SIDE = 7, MOST = 3 * SIDE * SIDE };
static const double dt = 1.0 / 64, speed = 1e-3, seconds = 0.5, gravity[3] = {0, -9.81, 0};

/* A body that swings where it hangs and, damped, comes to rest. */
typedef any* make_body(cd_precision precision);

static any* strands_of(cd_precision precision, double length) {
    const double pinned = CD_NODE_PINNED;
    cd_chain* c = scene_chain(STRANDS, SPRINGS, 3, precision);
    scene_lay_out(c, 0.1);
    ok(cd_chain_set_rest_length(c, length));
    ok(cd_chain_set_stiffness(c, 100));
    ok(cd_chain_set_lambda(c, 1));
    ok(cd_chain_set_drag(c, 6));
    ok(cd_chain_set_gravity(c, gravity, 3));
    for (size_t strand = 0; strand < scene_own_strands(c); ++strand)
        ok(cd_chain_write_f64(c, CD_PIN, strand, 1, 0, 1, &pinned, 1));
    return c;
}
static any* ropes(cd_precision precision) { return strands_of(precision, 0.1 * SPRINGS); }
static any* chains(cd_precision precision) { return strands_of(precision, 0); }
static any* sheet(cd_solver solver, cd_precision precision, double length) {
    cd_membrane* m = cloth(SIDE - 1, SIDE - 1, 3, precision);
    cloth_lay_out(m, 0.1);
    ok(cd_membrane_set_rest_length(m, length, length));
    ok(cd_membrane_set_solver(m, solver));
    ok(cd_membrane_set_stiffness(m, 100, 100));
    ok(cd_membrane_set_lambda(m, 1));
    ok(cd_membrane_set_drag(m, 6));
    ok(cd_membrane_set_gravity(m, gravity, 3));
    ok(cd_membrane_set_edge(m, CD_EDGE_V_FIRST, CD_NODE_PINNED));
    return m;
}
static any* alternating(cd_precision precision) { return sheet(CD_SOLVER_ALTERNATING, precision, 0); }
static any* coupled(cd_precision precision) { return sheet(CD_SOLVER_COUPLED, precision, 0); }
static any* hung_cloth(cd_precision precision) { return sheet(CD_SOLVER_AUTO, precision, 0.6); }
static any* explicit_sheet(cd_precision precision) {
    any* const m = alternating(precision);
    ok(cd_membrane_set_method(m, CD_METHOD_SYMPLECTIC_EULER));
    ok(cd_membrane_set_stiffness(m, 10, 10)); /* stable at this dt */
    return m;
}

static const struct body {
    int kind; /* place in `kinds` */
    make_body* make;
    size_t parts, nodes; /* that sleep one by one, and of each */
} bodies[] = {{CHAIN, ropes, STRANDS, NODES},
              {CHAIN, chains, 1, STRANDS* NODES},
              {MEMBRANE, alternating, 1, SIDE* SIDE},
              {MEMBRANE, coupled, 1, SIDE* SIDE},
              {MEMBRANE, explicit_sheet, 1, SIDE* SIDE},
              {MEMBRANE, hung_cloth, 1, SIDE* SIDE}};
enum { ROPES = 0, COUPLED = 3, CLOTH = 5 }; /* places in `bodies` */
#define FOR_BODIES(body, precision)                                               \
    for (const struct body* body = bodies; body < bodies + COUNT(bodies); ++body) \
        for (cd_precision precision = CD_FLOAT32; precision <= CD_FLOAT64; ++precision)

static cd_status set_sleep(const struct body* body, any* x, double slowest, double time) {
    return body->kind == CHAIN ? cd_chain_set_sleep(x, slowest, time) : cd_membrane_set_sleep(x, slowest, time);
}
static size_t awake(const struct body* body, const any* x) {
    size_t nodes = SIZE_MAX;
    ok(body->kind == CHAIN ? cd_chain_get_awake(x, &nodes) : cd_membrane_get_awake(x, &nodes));
    return nodes;
}
static void step(const struct body* body, any* x, size_t count) { ok(kinds[body->kind].step(x, dt, count)); }
static void read_all(const struct body* body, const any* x, cd_field field, double* out_values) {
    ok(kinds[body->kind].read(x, field, out_values, kind_numbers(&kinds[body->kind], x, field)));
}
/* Steps until all of it sleeps, one after the other; tells how many. */
static size_t rest(const struct body* body, any* x) {
    size_t steps = 0;
    for (; awake(body, x) > 0 && steps < 4000; ++steps) step(body, x, 1);
    assert_int_equal(awake(body, x), 0);
    return steps;
}

/* A collider far above. */
static void far_away(void* user, double time, size_t count, size_t components, const double* positions,
                     double* out_distances, double* out_normals) {
    (void)user, (void)time, (void)positions;
    for (size_t i = 0; i < count; ++i) out_distances[i] = 100;
    for (size_t i = 0; i < count * components; ++i) out_normals[i] = i % components == 1 ? -1 : 0;
}
static const cd_distance answer = {NULL, far_away};
