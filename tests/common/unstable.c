#include "unstable.h"

#include "cloth.h"
#include "pool.h"
#include "scene.h"

#define BOTH(method) \
    {CD_FLOAT32, method}, { CD_FLOAT64, method }
#define EXPLICIT BOTH(CD_METHOD_SYMPLECTIC_EULER), BOTH(CD_METHOD_FORWARD_EULER)

const struct unstable unstables[KINDS] = {
    {&kinds[CHAIN], 4, {EXPLICIT}, 0, 10, true},
    {&kinds[MEMBRANE], 4, {EXPLICIT}, 0, 10, true},
    {&kinds[WATER], 6, {EXPLICIT, BOTH(CD_METHOD_IMPLICIT)}, UNSTABLE_GOOD, UNSTABLE_GOOD, false},
};

static any* unstable_chain(cd_precision precision, cd_method method, double* out_limit) {
    enum { STRANDS = 20 };
    cd_chain* chain = scene_chain(STRANDS, 9, 2, precision);
    ok(cd_chain_set_method(chain, method));
    const double v[2] = {1, -1}, less[2] = {1e-9, 1e-9};
    ok(cd_chain_write_f64(chain, CD_VELOCITY, STRANDS / 2, 1, 4, 1, v, 2));
    ok(cd_chain_write_f64(chain, CD_VELOCITY, 0, 1, 4, 1, less, 2));
    ok(cd_chain_write_f64(chain, CD_VELOCITY, STRANDS - 1, 1, 4, 1, less, 2));
    ok(cd_chain_stable_dt(chain, out_limit));
    return chain;
}

static any* unstable_membrane(cd_precision precision, cd_method method, double* out_limit) {
    cd_membrane* m = cloth(6, 5, 2, precision);
    ok(cd_membrane_set_method(m, method));
    const double v[2] = {1, -1};
    ok(cd_membrane_write_f64(m, CD_VELOCITY, 3, 2, 1, 1, v, 2));
    ok(cd_membrane_stable_dt(m, out_limit));
    return m;
}

static any* unbounded_water(cd_precision precision, cd_method method, double dt) {
    cd_water* w = pool(9, 6, precision);
    ok(cd_water_set_method(w, method));
    pool_fill(w, CD_DEPTH, 1);
    ok(cd_water_enable_field(w, CD_SOURCE));
    ok(cd_water_step(w, dt, UNSTABLE_GOOD));
    pool_set(w, CD_SOURCE, 4, 3, precision ? 1e307 : 1e37);
    return w;
}

any* unstable_new(const struct unstable* u, size_t i, double* out_dt, double* out_small) {
    const cd_precision precision = u->list[i].precision;
    const cd_method method = u->list[i].method;
    double limit = 4;
    any* object;
    if (u->kind == &kinds[CHAIN]) object = unstable_chain(precision, method, &limit);
    else if (u->kind == &kinds[MEMBRANE]) object = unstable_membrane(precision, method, &limit);
    else object = unbounded_water(precision, method, 2 * limit);
    *out_dt = 2 * limit;
    *out_small = u->kind == &kinds[WATER] ? 0.01 : limit / 4;
    return object;
}

any* unstable_diverged(const struct unstable* u, size_t i, double* out_dt, double* out_small) {
    any* object = unstable_new(u, i, out_dt, out_small);
    const cd_status status = u->stays ? u->kind->step(object, *out_dt, 5000) : CD_ERROR_DIVERGED;
    if (status != CD_ERROR_DIVERGED) fail_msg("%s %zu: 5000 steps give %s", u->kind->name, i, cd_status_name(status));
    while (kind_is_finite(u->kind, object)) (void)u->kind->step(object, *out_dt, 1);
    return object;
}

void unstable_calm(const struct unstable* u, any* object) {
    if (u->kind == &kinds[WATER]) pool_fill(object, CD_SOURCE, 0);
}

void unstable_lay_out(const struct unstable* u, any* object) {
    static const cd_field fields[] = {CD_VELOCITY, CD_VELOCITY_X, CD_VELOCITY_Y};
    static const double zeros[20 * 10 * 2];
    unstable_calm(u, object);
    if (u->kind == &kinds[CHAIN]) scene_lay_out(object, 0.1);
    if (u->kind == &kinds[MEMBRANE]) cloth_lay_out(object, 0.1);
    if (u->kind == &kinds[WATER]) pool_beach(object);
    for (size_t f = 0; f < COUNT(fields); ++f) {
        const size_t count = kind_numbers(u->kind, object, fields[f]);
        assert_true(count <= COUNT(zeros));
        if (count) ok(u->kind->write(object, fields[f], zeros, count));
    }
}
