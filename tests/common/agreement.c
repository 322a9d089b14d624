#include "agreement.h"

#include <math.h>
#include <stdlib.h>

#include "check.h"

const struct limits float32_limits = {1e-5, 1e-4, 3}, float64_limits = {1e-13, 1e-10, 300};
const struct limits float32_rod_limits = {1e-5, 1e-4, 30}, float64_rod_limits = {1e-12, 3e-9, 1000};

static void round_all(long double* values, size_t count, cd_precision precision) {
    for (size_t i = 0; i < count; ++i) values[i] = precision == CD_FLOAT32 ? (float)values[i] : (double)values[i];
}

static void write_field(cd_chain* chain, cd_field field, const long double* values, size_t first, size_t count) {
    double* numbers = calloc(count + 1, sizeof *numbers);
    assert_non_null(numbers);
    for (size_t i = 0; i < count; ++i) numbers[i] = (double)values[i];
    ok(cd_chain_enable_field(chain, field));
    ok(cd_chain_write_f64(chain, field, 0, 1, first, count, numbers, count));
    free(numbers);
}

static int any(const long double* values, size_t count) {
    for (size_t i = 0; i < count; ++i)
        if (values[i] != 0) return 1;
    return 0;
}

static void read_state(const cd_chain* chain, size_t n, double* x, double* v) {
    ok(cd_chain_read_f64(chain, CD_POSITION, 0, 1, 0, n, x, n));
    ok(cd_chain_read_f64(chain, CD_VELOCITY, 0, 1, 0, n, v, n));
}

cd_chain* chain_like(struct reference* r, cd_precision precision) {
    const size_t n = r->nodes, springs = r->ring ? n : n - 1;
    long double* const rounded[] = {r->x, r->v, r->mass, r->stretch, r->bend, r->force, r->target};
    for (size_t k = 0; k < COUNT(rounded); ++k) round_all(rounded[k], n, precision);
    cd_chain* chain = NULL;
    ok(cd_chain_create(1, n - 1, 1, precision, NULL, &chain));
    if (r->ring) ok(cd_chain_set_ring(chain, 1));
    ok(cd_chain_set_drag(chain, (double)r->drag));
    ok(cd_chain_set_stiffness_damping(chain, (double)r->stiffness_damping));
    long double* mass = calloc(n, sizeof *mass);
    assert_non_null(mass);
    for (size_t i = 0; i < n; ++i) mass[i] = isinf(r->mass[i]) ? 1 : r->mass[i];
    write_field(chain, CD_MASS, mass, 0, n);
    free(mass);
    write_field(chain, CD_POSITION, r->x, 0, n);
    for (size_t i = 0; i < n; ++i) {
        const double pinned = CD_NODE_PINNED;
        if (!isinf(r->mass[i])) continue;
        r->v[i] = 0;
        ok(cd_chain_write_f64(chain, CD_PIN, 0, 1, i, 1, &pinned, 1));
    }
    write_field(chain, CD_VELOCITY, r->v, 0, n);
    write_field(chain, CD_STIFFNESS, r->stretch, 0, springs);
    if (any(r->bend, n)) write_field(chain, CD_BEND, r->bend + !r->ring, !r->ring, r->ring ? n : n - 2);
    if (any(r->force, n)) write_field(chain, CD_FORCE, r->force, 0, n);
    for (size_t i = 0; i < n; ++i) {
        const double target = (double)r->target[i];
        if (r->anchor_stiffness[i] == 0 && r->anchor_damping[i] == 0) continue;
        ok(cd_chain_attach(chain, 0, i, (double)r->anchor_stiffness[i], (double)r->anchor_damping[i], &target, 1));
    }
    double* x = calloc(2 * n, sizeof *x);
    assert_non_null(x);
    read_state(chain, n, x, x + n);
    for (size_t i = 0; i < n; ++i) r->v[i] = x[n + i];
    free(x);
    return chain;
}

struct sizes {
    long double x, v;
};

static struct sizes sizes_of(const struct reference* r) {
    struct sizes s = {0, 0};
    for (size_t i = 0; i < r->nodes; ++i) {
        s.x = fmaxl(s.x, fabsl(r->x[i]));
        s.v = fmaxl(s.v, fabsl(r->v[i]));
    }
    return s;
}

/* What has died out is compared with what there was at the start, and a position at least with the way that the first
 * velocities cover in a step. */
static double error_of(const double* x, const double* v, const struct reference* r, struct sizes start, double dt) {
    const struct sizes now = sizes_of(r);
    const long double size_v = fmaxl(now.v, start.v), size_x = fmaxl(fmaxl(now.x, start.x), dt * start.v);
    long double error_x = 0, error_v = 0;
    for (size_t i = 0; i < r->nodes; ++i) {
        if (!isfinite(x[i]) || !isfinite(v[i])) return INFINITY;
        error_x = fmaxl(error_x, fabsl(x[i] - r->x[i]));
        error_v = fmaxl(error_v, fabsl(v[i] - r->v[i]));
    }
    return (double)fmaxl(size_x > 0 ? error_x / size_x : error_x, size_v > 0 ? error_v / size_v : error_v);
}

int misses(const char* what, const struct reference* start, cd_precision precision, const struct time_step* way,
           double dt, struct limits limits) {
    const size_t n = start->nodes;
    double* x = calloc(2 * n, sizeof *x);
    double* v = x + n;
    assert_non_null(x);
    struct reference* exact = reference_copy(start);
    cd_chain* chain = chain_like(exact, precision);
    set_time_step(chain, way);
    struct reference* rounding = reference_copy(exact);
    const struct sizes size = sizes_of(exact);

    ok(cd_chain_step(chain, dt, 1));
    reference_step(exact, way->method, way->lambda, dt, 1);
    read_state(chain, n, x, v);
    const double once = error_of(x, v, exact, size, dt);
    ok(cd_chain_step(chain, dt, 999));
    reference_step(exact, way->method, way->lambda, dt, 999);
    read_state(chain, n, x, v);
    const double thousand = error_of(x, v, exact, size, dt);

    double alone = 0;
    if (!(thousand <= limits.thousand)) {
        for (int k = 0; k < 1000; ++k) {
            reference_step(rounding, way->method, way->lambda, dt, 1);
            round_all(rounding->x, n, precision);
            round_all(rounding->v, n, precision);
        }
        for (size_t i = 0; i < n; ++i) x[i] = (double)rounding->x[i], v[i] = (double)rounding->v[i];
        alone = error_of(x, v, exact, size, dt);
    }
    const int missed = !(once <= limits.once && thousand <= fmax(limits.thousand, limits.slack * alone));
    print_message("%s, float%d %-12s: 1 step %.1e, 1000 steps %.1e", what, precision == CD_FLOAT32 ? 32 : 64, way->name,
                  once, thousand);
    if (alone > 0) print_message(" (rounding the state alone %.1e)", alone);
    print_message("%s\n", missed ? "  <- too far" : "");
    reference_destroy(rounding);
    reference_destroy(exact);
    cd_chain_destroy(chain);
    free(x);
    return missed;
}
