#include "reference.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "check.h"

enum { ANCHOR, STRETCH, BEND };

static void* zeros(size_t count, size_t size) {
    void* memory = calloc(count ? count : 1, size);
    assert_non_null(memory);
    return memory;
}

static size_t arrays_of(struct reference* r, long double** out[11]) {
    long double** const arrays[11] = {
        &r->x,      &r->v,      &r->mass, &r->stretch,          &r->bend,          &r->force,
        &r->target, &r->weight, &r->a,    &r->anchor_stiffness, &r->anchor_damping};
    memcpy(out, arrays, sizeof arrays);
    return COUNT(arrays);
}

struct reference* reference_create(size_t nodes) {
    struct reference* r = zeros(1, sizeof *r);
    long double** arrays[11];
    const size_t count = arrays_of(r, arrays);
    r->nodes = nodes;
    for (size_t k = 0; k < count; ++k) *arrays[k] = zeros(nodes, sizeof(long double));
    for (size_t i = 0; i < nodes; ++i) r->mass[i] = r->stretch[i] = 1;
    return r;
}

struct reference* reference_copy(const struct reference* r) {
    struct reference* copy = reference_create(r->nodes);
    struct reference from = *r;
    long double **to_arrays[11], **from_arrays[11];
    const size_t count = arrays_of(copy, to_arrays);
    arrays_of(&from, from_arrays);
    for (size_t k = 0; k < count; ++k) memcpy(*to_arrays[k], *from_arrays[k], r->nodes * sizeof(long double));
    copy->ring = r->ring;
    copy->drag = r->drag;
    copy->stiffness_damping = r->stiffness_damping;
    return copy;
}

void reference_changed(struct reference* r) {
    free(r->row);
    free(r->band);
    free(r->tau);
    r->row = NULL;
    r->band = r->tau = NULL;
    r->factored_for = 0;
}

void reference_destroy(struct reference* r) {
    long double** arrays[11];
    const size_t count = arrays_of(r, arrays);
    reference_changed(r);
    for (size_t k = 0; k < count; ++k) free(*arrays[k]);
    free(r);
}

static int is_held(const struct reference* r, size_t i) { return isinf(r->mass[i]); }

/* Rows are ordered by the node they start at, so that only near ones share a node. Between held nodes alone a row
 * moves nothing. */
static void add_row(struct reference* r, int kind, long double kappa, const size_t* node,
                    const long double* coefficient, int terms) {
    int moves = 0;
    for (int k = 0; k < terms; ++k) moves |= !is_held(r, node[k]);
    if (kappa == 0 || !moves) return;
    struct reference_row* row = &r->row[r->rows++];
    *row = (struct reference_row){.kappa = kappa, .terms = terms, .kind = kind};
    if (kind == ANCHOR) row->target = r->target[node[0]];
    memcpy(row->node, node, (size_t)terms * sizeof *node);
    memcpy(row->coefficient, coefficient, (size_t)terms * sizeof *coefficient);
}

static int share_a_node(const struct reference_row* a, const struct reference_row* b) {
    for (int i = 0; i < a->terms; ++i)
        for (int j = 0; j < b->terms; ++j)
            if (a->node[i] == b->node[j]) return 1;
    return 0;
}

/* Of an open line at most three rows start at a node and one reaches two nodes on: the band is narrow. */
static void make_rows(struct reference* r) {
    static const long double one[] = {1}, difference[] = {-1, 1}, second[] = {1, -2, 1};
    const size_t n = r->nodes;
    r->rows = 0;
    r->row = zeros(3 * n, sizeof *r->row);
    for (size_t i = 0; i < n; ++i) {
        const size_t node[3] = {i, (i + 1) % n, (i + 2) % n};
        add_row(r, ANCHOR, r->anchor_stiffness[i], node, one, 1);
        if (r->ring || i + 1 < n) add_row(r, STRETCH, r->stretch[i], node, difference, 2);
        if (r->ring || i + 2 < n) add_row(r, BEND, r->bend[node[1]], node, second, 3);
    }
    r->width = 0;
    for (size_t p = 0; p < r->rows; ++p)
        for (size_t q = r->ring || p < 8 ? 0 : p - 8; q < p; ++q)
            if (share_a_node(&r->row[p], &r->row[q]) && p - q > r->width) r->width = p - q;
}

static long double along(const struct reference_row* row, const long double* values) {
    long double sum = 0;
    for (int k = 0; k < row->terms; ++k) sum += row->coefficient[k] * values[row->node[k]];
    return sum;
}

#define AT(p, q) band[(p) * (w + 1) + (q) + w - (p)]

static int all_stretch(const struct reference* r) {
    for (size_t p = 0; p < r->rows; ++p)
        if (r->row[p].kind != STRETCH) return 0;
    return 1;
}

/* Of an open line of springs alone the system is itself a path of springs: rows that share a node are joined by its
 * weight, and what a row has beyond that goes to ground. Pivots are then sums: no digit is lost to n^2. */
static void factor_path(struct reference* r) {
    const size_t w = 1;
    long double* const band = r->band;
    long double hanging = 0;
    for (size_t p = 0; p < r->rows; ++p) {
        const struct reference_row* row = &r->row[p];
        const long double before = p > 0 ? -AT(p, p - 1) : 0, after = p + 1 < r->rows ? -AT(p + 1, p) : 0;
        long double ground = row->pull / row->kappa + hanging;
        if (before == 0) ground += r->weight[row->node[0]];
        if (after == 0) ground += r->weight[row->node[1]];
        AT(p, p) = ground + after;
        if (p > 0) AT(p, p - 1) = -before / AT(p - 1, p - 1);
        hanging = after > 0 ? ground * (after / (ground + after)) : 0;
    }
}

/* The band of B W B^T + 1 / (kappa h (h + beta)), row p from column p - width to p, and its L D L^T in place. */
static void factor(struct reference* r, long double h) {
    const size_t w = r->width;
    r->band = zeros(r->rows * (w + 1), sizeof *r->band);
    r->tau = zeros(r->rows, sizeof *r->tau);
    long double* const band = r->band;
    for (size_t i = 0; i < r->nodes; ++i)
        r->weight[i] = is_held(r, i) ? 0 : 1 / (r->mass[i] * (1 + h * r->drag) + h * r->anchor_damping[i]);
    for (size_t p = 0; p < r->rows; ++p) {
        struct reference_row* a = &r->row[p];
        a->lag = a->kind == ANCHOR ? h : h + r->stiffness_damping;
        a->pull = 1 / (h * a->lag);
        for (size_t q = p > w ? p - w : 0; q <= p; ++q) {
            const struct reference_row* b = &r->row[q];
            long double sum = 0;
            for (int i = 0; i < a->terms; ++i)
                for (int j = 0; j < b->terms; ++j)
                    if (a->node[i] == b->node[j]) sum += a->coefficient[i] * b->coefficient[j] * r->weight[a->node[i]];
            AT(p, q) = sum;
        }
        AT(p, p) += a->pull / a->kappa;
    }
    if (w == 1 && all_stretch(r)) {
        factor_path(r);
        return;
    }
    for (size_t p = 0; p < r->rows; ++p) {
        for (size_t q = p > w ? p - w : 0; q < p; ++q) {
            long double sum = AT(p, q);
            for (size_t k = p > w ? p - w : 0; k < q; ++k) sum -= AT(p, k) * AT(q, k);
            AT(p, q) = sum;
        }
        for (size_t q = p > w ? p - w : 0; q < p; ++q) {
            const long double scaled = AT(p, q) / AT(q, q);
            AT(p, p) -= AT(p, q) * scaled;
            AT(p, q) = scaled;
        }
    }
}

static void solve(const struct reference* r, long double* t) {
    const size_t w = r->width;
    const long double* const band = r->band;
    for (size_t p = 0; p < r->rows; ++p)
        for (size_t q = p > w ? p - w : 0; q < p; ++q) t[p] -= AT(p, q) * t[q];
    for (size_t p = 0; p < r->rows; ++p) t[p] /= AT(p, p);
    for (size_t p = r->rows; p-- > 0;)
        for (size_t q = p > w ? p - w : 0; q < p; ++q) t[q] -= AT(p, q) * t[p];
}

#undef AT

/* a such that  m a = f - C (v + h a) - K (x + h v + h^2 a):
 * a = W (f - alpha m v - c v - B^T tau)  and  tau = kappa (B (x + (h + beta) v) - target + h (h + beta) B a).
 * A weld asks for B (v + h a) = 0 instead: its offset stays. */
static void stage(struct reference* r, long double h) {
    if (!r->row) make_rows(r);
    if (r->factored_for != h) {
        free(r->band);
        free(r->tau);
        factor(r, h);
        r->factored_for = h;
    }
    for (size_t i = 0; i < r->nodes; ++i) {
        const long double push =
            is_held(r, i) ? 0 : r->force[i] - (r->drag * r->mass[i] + r->anchor_damping[i]) * r->v[i];
        r->a[i] = r->weight[i] * push;
    }
    for (size_t p = 0; p < r->rows; ++p) {
        const struct reference_row* row = &r->row[p];
        const long double v = along(row, r->v);
        const long double e = isinf(row->kappa) ? v / h : (along(row, r->x) - row->target + row->lag * v) * row->pull;
        r->tau[p] = e + along(row, r->a);
    }
    solve(r, r->tau);
    for (size_t p = 0; p < r->rows; ++p) {
        const struct reference_row* row = &r->row[p];
        for (int k = 0; k < row->terms; ++k)
            r->a[row->node[k]] -= r->weight[row->node[k]] * row->coefficient[k] * r->tau[p];
    }
}

/* What has died out is 0: processors are slow on subnormal numbers. */
static long double settled(long double a) { return fabsl(a) < LDBL_MIN / (LDBL_EPSILON * LDBL_EPSILON) ? 0 : a; }

/* x += s (v + h a), v += s a: s = dt for the lambda step; the stiff step's first stage serves twice. */
static void move(struct reference* r, long double h, long double s) {
    for (size_t i = 0; i < r->nodes; ++i) {
        r->x[i] = settled(r->x[i] + s * (r->v[i] + h * r->a[i]));
        r->v[i] = settled(r->v[i] + s * r->a[i]);
    }
}

void reference_step(struct reference* r, cd_method method, double lambda, long double dt, size_t count) {
    const long double g = 1 - sqrtl(0.5L);
    const int stiff = method == CD_METHOD_STIFF_SECOND;
    const long double h = stiff ? g * dt : lambda * dt;
    assert_true(h > 0);
    for (size_t k = 0; k < count; ++k) {
        stage(r, h);
        if (stiff) {
            move(r, h, (1 - g) * dt);
            stage(r, h);
        }
        move(r, h, stiff ? g * dt : dt);
    }
}

double random_number(uint64_t* state) {
    uint64_t z = (*state += 0x9E3779B97F4A7C15u) ^ other_scenes();
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
    return (double)((z ^ (z >> 31)) >> 11) * 0x1p-52 - 1;
}
