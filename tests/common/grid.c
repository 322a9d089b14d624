#include "grid.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "check.h"
#include "sheet.h"

static void* zeros(size_t count, size_t size) {
    void* memory = calloc(count ? count : 1, size);
    assert_non_null(memory);
    return memory;
}

/* ---- terms ------------------------------------------------------------------------------------------------------- */

/* What the membrane's fields say, or null where they are off. */
static double* field_of(const cd_membrane* m, cd_field field, size_t nodes) {
    double* values = zeros(nodes * 4, sizeof *values);
    double probe[4];
    const int per_component = field == CD_FORCE || field == CD_TARGET;
    const cd_status status = cd_membrane_read_f64(m, field, 0, 0, 1, 1, probe, per_component ? sheet_components(m) : 1);
    if (status == CD_ERROR_DISABLED) {
        free(values);
        return NULL;
    }
    ok(status);
    sheet_read(m, field, values);
    return values;
}

struct builder {
    struct grid* g;
    size_t nu, nv; /* springs of one line */
    int ring[2], half;
    long double parts[2]; /* lines that share a total */
    double along_u, along_v, bend;
    double *spring_u, *spring_v;
};

/* The weight of line i of direction d: 1/2 at the edges where these count half. */
static long double line_weight(const struct builder* b, int d, size_t i) {
    const size_t n = d == 0 ? b->g->columns : b->g->rows;
    return b->half && !b->ring[d] && n > 1 && (i == 0 || i + 1 == n) ? 0.5L : 1;
}

static void add_term(struct grid* g, enum grid_kind kind, long double kappa, const size_t* node,
                     const long double* coefficient, int count) {
    for (int k = 0; k < count; ++k)
        if (g->absent[node[k]]) return;
    if (kappa == 0) return;
    struct grid_term* t = &g->term[g->terms++];
    *t = (struct grid_term){.kappa = kappa, .count = count, .kind = kind};
    memcpy(t->node, node, (size_t)count * sizeof *node);
    memcpy(t->coefficient, coefficient, (size_t)count * sizeof *coefficient);
}

/* Spring, bend and twist that start at node (u, v); lines that close go on at 0. */
static void add_terms_at(const struct builder* b, size_t u, size_t v) {
    static const long double difference[] = {-1, 1}, second[] = {1, -2, 1}, twist[] = {1, -1, -1, 1};
    struct grid* g = b->g;
    const size_t cu = g->columns, cv = g->rows;
    const long double nu = (long double)b->nu, nv = (long double)b->nv;
    const int next[2] = {b->ring[0] || u + 1 < cu, b->ring[1] || v + 1 < cv};
    const int two[2] = {b->ring[0] || u + 2 < cu, b->ring[1] || v + 2 < cv};
    const size_t u1 = (u + 1) % cu, u2 = (u + 2) % cu, v1 = (v + 1) % cv, v2 = (v + 2) % cv;
    const size_t line_u[3] = {v * cu + u, v * cu + u1, v * cu + u2}, line_v[3] = {v * cu + u, v1 * cu + u, v2 * cu + u};
    const size_t cell[4] = {v * cu + u, v * cu + u1, v1 * cu + u, v1 * cu + u1};
    long double ku = line_weight(b, 1, v) * nu * b->along_u / b->parts[1];
    long double kv = line_weight(b, 0, u) * nv * b->along_v / b->parts[0];
    if (b->spring_u) ku = b->spring_u[v * b->nu + u];
    if (b->spring_v) kv = b->spring_v[v * cu + u];
    const long double bu = nu * nu * nu * b->bend / b->parts[1], bv = nv * nv * nv * b->bend / b->parts[0];
    if (next[0]) add_term(g, GRID_ALONG_U, ku, line_u, difference, 2);
    if (next[1]) add_term(g, GRID_ALONG_V, kv, line_v, difference, 2);
    if (two[0] && cu > 2) add_term(g, GRID_ALONG_U, line_weight(b, 1, v) * bu, line_u, second, 3);
    if (two[1] && cv > 2) add_term(g, GRID_ALONG_V, line_weight(b, 0, u) * bv, line_v, second, 3);
    if (next[0] && next[1]) add_term(g, GRID_TWIST, 2 * sqrtl(bu * bv), cell, twist, 4);
}

static int kind_of_node(const cd_membrane* m, const double* pin, size_t u, size_t v, size_t nu, size_t nv) {
    if (pin) return (int)pin[v * (nu + 1) + u];
    const cd_edge edges[4] = {CD_EDGE_U_FIRST, CD_EDGE_U_LAST, CD_EDGE_V_FIRST, CD_EDGE_V_LAST};
    const int on[4] = {u == 0, u == nu, v == 0, v == nv};
    int kind = CD_NODE_FREE;
    for (int e = 0; e < 4; ++e) {
        cd_node edge;
        ok(cd_membrane_get_edge(m, edges[e], &edge));
        if (on[e] && (edge == CD_NODE_PINNED || (edge == CD_NODE_DRIVEN && kind != CD_NODE_PINNED))) kind = edge;
    }
    return kind;
}

static void add_ties(struct grid* g, const cd_membrane* m) {
    static const long double one[] = {1};
    double* target = field_of(m, CD_TARGET, g->nodes);
    if (!target) return;
    for (size_t i = 0; i < g->nodes; ++i) {
        double stiffness, damping;
        ok(cd_membrane_get_attachment(m, i % g->columns, i / g->columns, &stiffness, &damping));
        const size_t before = g->terms;
        add_term(g, GRID_TIE, stiffness, &i, one, 1);
        if (!g->absent[i]) g->impedance[i] += damping;
        for (size_t c = 0; c < g->components && g->terms > before; ++c)
            g->term[before].target[c] = target[i * g->components + c];
    }
    free(target);
}

struct grid* grid_of(const cd_membrane* m) {
    struct grid* g = zeros(1, sizeof *g);
    struct builder b = {.g = g};
    size_t nu, nv;
    int32_t ring_u, ring_v;
    cd_mass_rule rule;
    double mass, drag, damping, gravity[4];
    ok(cd_membrane_get_shape(m, &nu, &nv, &g->components, NULL));
    ok(cd_membrane_get_ring(m, &ring_u, &ring_v));
    ok(cd_membrane_get_mass(m, &mass));
    ok(cd_membrane_get_mass_rule(m, &rule));
    ok(cd_membrane_get_stiffness(m, &b.along_u, &b.along_v));
    ok(cd_membrane_get_bend(m, &b.bend));
    ok(cd_membrane_get_drag(m, &drag));
    ok(cd_membrane_get_stiffness_damping(m, &damping));
    ok(cd_membrane_get_gravity(m, gravity, g->components));
    for (size_t c = 0; c < g->components; ++c) g->gravity[c] = gravity[c];
    g->drag = drag;
    g->damping = damping;
    g->columns = nu + 1;
    g->rows = nv + 1;
    const size_t n = g->nodes = (nu + 1) * (nv + 1);
    g->mass = zeros(n, sizeof *g->mass);
    g->impedance = zeros(n, sizeof *g->impedance);
    g->force = zeros(n * g->components, sizeof *g->force);
    g->held = zeros(n, 1);
    g->absent = zeros(n, 1);
    g->term = zeros(6 * n, sizeof *g->term);
    b.ring[0] = ring_u, b.ring[1] = ring_v, b.half = rule == CD_MASS_HALF_ENDS;
    b.nu = nu + (size_t)ring_u, b.nv = nv + (size_t)ring_v;
    b.parts[0] = (long double)(b.half && !ring_u && nu > 0 ? nu : nu + 1);
    b.parts[1] = (long double)(b.half && !ring_v && nv > 0 ? nv : nv + 1);
    b.spring_u = field_of(m, CD_STIFFNESS_U, n);
    b.spring_v = field_of(m, CD_STIFFNESS_V, n);
    double* masses = field_of(m, CD_MASS, n);
    double* pin = field_of(m, CD_PIN, n);
    double* mask = field_of(m, CD_MASK, n);
    double* force = field_of(m, CD_FORCE, n);
    for (size_t i = 0; i < n; ++i) {
        const size_t u = i % g->columns, v = i / g->columns;
        g->absent[i] = mask && mask[i] == 0;
        g->held[i] = g->absent[i] || kind_of_node(m, pin, u, v, nu, nv) != CD_NODE_FREE;
        g->mass[i] =
            masses ? masses[i] : line_weight(&b, 0, u) * line_weight(&b, 1, v) * mass / (b.parts[0] * b.parts[1]);
        for (size_t c = 0; c < g->components && force; ++c)
            g->force[i * g->components + c] = force[i * g->components + c];
    }
    for (size_t v = 0; v < g->rows; ++v)
        for (size_t u = 0; u < g->columns; ++u) add_terms_at(&b, u, v);
    add_ties(g, m);
    free(b.spring_u);
    free(b.spring_v);
    free(masses);
    free(pin);
    free(mask);
    free(force);
    return g;
}

static void drop_factor(struct grid* g) {
    free(g->number);
    free(g->start);
    free(g->offset);
    free(g->factor);
    g->number = g->start = g->offset = NULL;
    g->factor = NULL;
}

struct grid* grid_of_bend(cd_membrane* m) {
    double along_u, along_v;
    ok(cd_membrane_get_stiffness(m, &along_u, &along_v));
    ok(cd_membrane_set_stiffness(m, 0, 0));
    struct grid* const bend = grid_of(m);
    ok(cd_membrane_set_stiffness(m, along_u, along_v));
    return bend;
}

void grid_destroy(struct grid* g) {
    drop_factor(g);
    free(g->mass);
    free(g->impedance);
    free(g->force);
    free(g->held);
    free(g->absent);
    free(g->term);
    free(g);
}

/* ---- sums over the terms ----------------------------------------------------------------------------------------- */

void grid_stiffness(const struct grid* g, enum grid_kind kind, const long double* x, long double* out) {
    for (size_t i = 0; i < g->nodes; ++i) out[i] = 0;
    for (size_t k = 0; k < g->terms; ++k) {
        const struct grid_term* t = &g->term[k];
        long double stretch = 0;
        if (kind != GRID_ALL && t->kind != kind) continue;
        for (int j = 0; j < t->count; ++j) stretch += t->coefficient[j] * x[t->node[j]];
        for (int j = 0; j < t->count; ++j) out[t->node[j]] += t->kappa * stretch * t->coefficient[j];
    }
    for (size_t i = 0; i < g->nodes; ++i)
        if (g->held[i]) out[i] = 0;
}

long double grid_elastic_energy(const struct grid* g, const double* x) {
    long double energy = 0;
    for (size_t k = 0; k < g->terms; ++k)
        for (size_t c = 0; c < g->components; ++c) {
            const struct grid_term* t = &g->term[k];
            long double stretch = -t->target[c];
            for (int j = 0; j < t->count; ++j) stretch += t->coefficient[j] * x[t->node[j] * g->components + c];
            energy += t->kappa * stretch * stretch / 2;
        }
    return energy;
}

long double grid_kinetic_energy(const struct grid* g, const double* v) {
    long double energy = 0;
    for (size_t i = 0; i < g->nodes * g->components; ++i)
        if (!g->held[i / g->components]) energy += g->mass[i / g->components] * (long double)v[i] * v[i] / 2;
    return energy;
}

static long double dampers(const struct grid* g, size_t i) { return g->drag * g->mass[i] + g->impedance[i]; }

/* f - K x of component c, targets and all. */
static void push(const struct grid* g, size_t c, const long double* x, long double* out) {
    for (size_t i = 0; i < g->nodes; ++i) out[i] = g->mass[i] * g->gravity[c] + g->force[i * g->components + c];
    for (size_t k = 0; k < g->terms; ++k) {
        const struct grid_term* t = &g->term[k];
        long double stretch = -t->target[c];
        for (int j = 0; j < t->count; ++j) stretch += t->coefficient[j] * x[t->node[j]];
        for (int j = 0; j < t->count; ++j) out[t->node[j]] -= t->kappa * stretch * t->coefficient[j];
    }
}

void grid_right_side(const struct grid* g, size_t c, long double h, const double* x, const double* v,
                     long double* out) {
    const size_t each = g->components;
    long double* one = zeros(g->nodes, sizeof *one);
    for (size_t i = 0; i < g->nodes; ++i) one[i] = x[i * each + c];
    push(g, c, one, out);
    for (size_t i = 0; i < g->nodes; ++i) out[i] = g->held[i] ? 0 : g->mass[i] * v[i * each + c] + h * out[i];
    free(one);
}

void grid_system(const struct grid* g, long double h, const long double* w, long double* out) {
    long double* tie = zeros(g->nodes, sizeof *tie);
    grid_stiffness(g, GRID_ALL, w, out);
    grid_stiffness(g, GRID_TIE, w, tie); /* their damping is their own: stiffness_damping is that of stretch and bend */
    for (size_t i = 0; i < g->nodes; ++i)
        if (!g->held[i])
            out[i] = (g->mass[i] + h * dampers(g, i)) * w[i] + h * (h + g->damping) * out[i] - h * g->damping * tie[i];
    free(tie);
}

void grid_diagonal(const struct grid* g, long double h, long double* out) {
    for (size_t i = 0; i < g->nodes; ++i) out[i] = g->held[i] ? 1 : g->mass[i] + h * dampers(g, i);
    for (size_t k = 0; k < g->terms; ++k) {
        const struct grid_term* t = &g->term[k];
        const long double share = h * (t->kind == GRID_TIE ? h : h + g->damping);
        for (int i = 0; i < t->count; ++i)
            if (!g->held[t->node[i]]) out[t->node[i]] += share * t->kappa * t->coefficient[i] * t->coefficient[i];
    }
}

/* ---- solving ----------------------------------------------------------------------------------------------------- */

#define AT(i, j) (g->factor[g->offset[i] + (j)-g->start[i]])

/* Each row of the lower triangle begins at its first neighbour and is full from there on; L L^T in place. A weight per
 * kind: ties have no stiffness damping. */
static void factor(struct grid* g, const long double* diagonal, long double weight, long double tie_weight) {
    drop_factor(g);
    g->number = zeros(g->nodes, sizeof *g->number);
    g->start = zeros(g->nodes, sizeof *g->start);
    g->offset = zeros(g->nodes + 1, sizeof *g->offset);
    size_t n = 0;
    for (size_t i = 0; i < g->nodes; ++i)
        if (!g->held[i]) g->start[n] = n, g->number[i] = n++;
    g->unknowns = n;
    for (size_t k = 0; k < g->terms; ++k)
        for (int i = 0; i < g->term[k].count; ++i)
            for (int j = 0; j < g->term[k].count; ++j) {
                const size_t a = g->term[k].node[i], b = g->term[k].node[j];
                if (!g->held[a] && !g->held[b] && g->number[b] < g->start[g->number[a]])
                    g->start[g->number[a]] = g->number[b];
            }
    for (size_t i = 0; i < n; ++i) g->offset[i + 1] = g->offset[i] + i - g->start[i] + 1;
    g->factor = zeros(g->offset[n], sizeof *g->factor);
    for (size_t i = 0; i < g->nodes; ++i)
        if (!g->held[i]) AT(g->number[i], g->number[i]) = diagonal[i];
    for (size_t k = 0; k < g->terms; ++k) {
        const struct grid_term* t = &g->term[k];
        const long double kappa = t->kappa * (t->kind == GRID_TIE ? tie_weight : weight);
        for (int i = 0; i < t->count; ++i)
            for (int j = 0; j < t->count; ++j) {
                if (g->held[t->node[i]] || g->held[t->node[j]]) continue;
                const size_t a = g->number[t->node[i]], b = g->number[t->node[j]];
                if (b <= a) AT(a, b) += kappa * t->coefficient[i] * t->coefficient[j];
            }
    }
    for (size_t i = 0; i < n; ++i) {
        for (size_t j = g->start[i]; j <= i; ++j) {
            long double sum = AT(i, j);
            for (size_t k = g->start[i] > g->start[j] ? g->start[i] : g->start[j]; k < j; ++k)
                sum -= AT(i, k) * AT(j, k);
            AT(i, j) = j < i ? sum / AT(j, j) : sqrtl(sum);
        }
        assert_true(AT(i, i) > 0);
    }
}

static void solve(const struct grid* g, long double* b) {
    for (size_t i = 0; i < g->unknowns; ++i) {
        for (size_t j = g->start[i]; j < i; ++j) b[i] -= AT(i, j) * b[j];
        b[i] /= AT(i, i);
    }
    for (size_t i = g->unknowns; i-- > 0;) {
        b[i] /= AT(i, i);
        for (size_t j = g->start[i]; j < i; ++j) b[j] -= AT(i, j) * b[i];
    }
}

#undef AT

/* One vector over all nodes, solved between the free ones. */
static void solve_free(const struct grid* g, long double* side) {
    long double* b = zeros(g->nodes, sizeof *b);
    for (size_t i = 0; i < g->nodes; ++i)
        if (!g->held[i]) b[g->number[i]] = side[i];
    solve(g, b);
    for (size_t i = 0; i < g->nodes; ++i)
        if (!g->held[i]) side[i] = b[g->number[i]];
    free(b);
}

void grid_solve_static(struct grid* g, long double* side) {
    long double* nothing = zeros(g->nodes, sizeof *nothing);
    long double* pull = zeros(g->nodes, sizeof *pull);
    for (size_t i = 0; i < g->nodes; ++i) nothing[i] = g->held[i] ? side[i] : 0;
    grid_stiffness(g, GRID_ALL, nothing, pull);
    for (size_t i = 0; i < g->nodes; ++i) side[i] -= g->held[i] ? 0 : pull[i], nothing[i] = 0;
    factor(g, nothing, 1, 1);
    solve_free(g, side);
    free(nothing);
    free(pull);
}

void grid_rest(struct grid* g, double* x) {
    const size_t each = g->components;
    long double* held = zeros(g->nodes, sizeof *held);
    long double* side = zeros(g->nodes, sizeof *side);
    factor(g, side, 1, 1);
    for (size_t c = 0; c < each; ++c) {
        for (size_t i = 0; i < g->nodes; ++i) held[i] = g->held[i] ? x[i * each + c] : 0;
        push(g, c, held, side);
        solve_free(g, side);
        for (size_t i = 0; i < g->nodes; ++i)
            if (!g->held[i]) x[i * each + c] = (double)side[i];
    }
    free(held);
    free(side);
}

/* The stage's rate of change: S a = f - C v - K (x + h v), so that w = v + h a. */
static void rate(const struct grid* g, size_t c, long double h, const double* x, const double* v, long double* out) {
    const size_t n = g->nodes;
    long double *ahead = zeros(n, sizeof *ahead), *one = zeros(n, sizeof *one);
    long double *all = zeros(n, sizeof *all), *tie = zeros(n, sizeof *tie);
    for (size_t i = 0; i < n; ++i) {
        one[i] = v[i * g->components + c];
        ahead[i] = x[i * g->components + c] + h * one[i];
    }
    push(g, c, ahead, out);
    grid_stiffness(g, GRID_ALL, one, all);
    grid_stiffness(g, GRID_TIE, one, tie);
    for (size_t i = 0; i < n; ++i)
        out[i] = g->held[i] ? 0 : out[i] - dampers(g, i) * one[i] - g->damping * (all[i] - tie[i]);
    solve_free(g, out);
    free(ahead);
    free(one);
    free(all);
    free(tie);
}

void grid_step(struct grid* g, const struct time_step* step, long double dt, size_t count, double* x, double* v) {
    const long double gamma = 1 - sqrtl(0.5L);
    const int stiff = step->method == CD_METHOD_STIFF_SECOND, symplectic = step->method == CD_METHOD_SYMPLECTIC_EULER;
    const long double h = stiff ? gamma * dt : !sheet_solves(step) ? 0 : step->lambda * dt;
    long double* a = zeros(g->nodes, sizeof *a);
    for (size_t i = 0; i < g->nodes; ++i) a[i] = g->mass[i] + h * dampers(g, i);
    factor(g, a, h * (h + g->damping), h * h);
    for (size_t k = 0; k < count; ++k)
        for (int stage = 0; stage < (stiff ? 2 : 1); ++stage) {
            const long double s = !stiff ? dt : stage == 0 ? (1 - gamma) * dt : gamma * dt;
            for (size_t c = 0; c < g->components; ++c) {
                rate(g, c, h, x, v, a);
                for (size_t i = 0; i < g->nodes; ++i) {
                    const size_t at = i * g->components + c;
                    if (g->absent[i]) continue;
                    const long double moved = v[at] + (symplectic ? s : h) * a[i];
                    x[at] = (double)(x[at] + s * moved);
                    v[at] = (double)(v[at] + s * a[i]);
                }
            }
        }
    free(a);
}
