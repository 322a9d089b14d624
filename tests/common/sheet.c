#include "sheet.h"

#include <math.h>
#include <string.h>

#include "check.h"

static int is_half(const struct sheet* s) { return s->rule == CD_MASS_HALF_ENDS; }

/* Springs of one line, and lines that share a total: with half edges the two at the edges count as one. */
static long double springs_of(const struct sheet* s, int d) {
    return (long double)(s->ends[d] == SHEET_RING ? s->nodes[d] : s->nodes[d] - 1);
}
static long double parts_of(const struct sheet* s, int d) {
    const int whole = s->ends[d] == SHEET_RING || s->nodes[d] == 1 || !is_half(s);
    return (long double)(whole ? s->nodes[d] : s->nodes[d] - 1);
}

long double sheet_node_mass(const struct sheet* s) { return s->mass / (parts_of(s, 0) * parts_of(s, 1)); }

long double sheet_spring(const struct sheet* s, int d) {
    return springs_of(s, d) * s->stiffness[d] / parts_of(s, 1 - d);
}

long double sheet_bend(const struct sheet* s, int d) {
    const long double n = springs_of(s, d);
    return s->bend * n * n * n / parts_of(s, 1 - d);
}

cd_membrane* sheet_membrane(const struct sheet* s, size_t components, cd_precision precision) {
    cd_membrane* m = NULL;
    ok(cd_membrane_create(s->nodes[0] - 1, s->nodes[1] - 1, components, precision, NULL, &m));
    ok(cd_membrane_set_solver(m, CD_SOLVER_ALTERNATING));
    ok(cd_membrane_set_mass(m, s->mass));
    ok(cd_membrane_set_mass_rule(m, s->rule));
    ok(cd_membrane_set_stiffness(m, s->stiffness[0], s->stiffness[1]));
    ok(cd_membrane_set_ring(m, s->ends[0] == SHEET_RING, s->ends[1] == SHEET_RING));
    ok(cd_membrane_set_bend(m, s->bend));
    ok(cd_membrane_set_drag(m, s->drag));
    ok(cd_membrane_set_stiffness_damping(m, s->damping));
    for (int d = 0; d < 2; ++d) {
        const cd_edge first = d == 0 ? CD_EDGE_U_FIRST : CD_EDGE_V_FIRST;
        const cd_edge last = d == 0 ? CD_EDGE_U_LAST : CD_EDGE_V_LAST;
        if (s->ends[d] == SHEET_FIXED || s->ends[d] == SHEET_FIXED_FREE)
            ok(cd_membrane_set_edge(m, first, CD_NODE_PINNED));
        if (s->ends[d] == SHEET_FIXED) ok(cd_membrane_set_edge(m, last, CD_NODE_PINNED));
    }
    return m;
}

size_t sheet_nodes(const cd_membrane* membrane) {
    size_t nu, nv;
    ok(cd_membrane_get_shape(membrane, &nu, &nv, NULL, NULL));
    return (nu + 1) * (nv + 1);
}

size_t sheet_components(const cd_membrane* membrane) {
    size_t components;
    ok(cd_membrane_get_shape(membrane, NULL, NULL, &components, NULL));
    return components;
}

/* Columns, rows and numbers per place of a whole field. */
static void extent(const cd_membrane* membrane, cd_field field, size_t out[3]) {
    int32_t ring[2];
    ok(cd_membrane_get_shape(membrane, &out[0], &out[1], &out[2], NULL));
    ok(cd_membrane_get_ring(membrane, &ring[0], &ring[1]));
    if (field != CD_STIFFNESS_U || ring[0]) ++out[0];
    if (field != CD_STIFFNESS_V || ring[1]) ++out[1];
    if (field != CD_POSITION && field != CD_VELOCITY && field != CD_FORCE && field != CD_TARGET) out[2] = 1;
}

void sheet_read(const cd_membrane* membrane, cd_field field, double* out_values) {
    size_t n[3];
    extent(membrane, field, n);
    ok(cd_membrane_read_f64(membrane, field, 0, 0, n[0], n[1], out_values, n[0] * n[1] * n[2]));
}

void sheet_write(cd_membrane* membrane, cd_field field, const double* values) {
    size_t n[3];
    extent(membrane, field, n);
    ok(cd_membrane_write_f64(membrane, field, 0, 0, n[0], n[1], values, n[0] * n[1] * n[2]));
}

double sheet_get(const cd_membrane* membrane, cd_field field, size_t u, size_t v) {
    double value;
    ok(cd_membrane_read_f64(membrane, field, u, v, 1, 1, &value, 1));
    return value;
}

void sheet_set(cd_membrane* membrane, cd_field field, size_t u, size_t v, double value) {
    ok(cd_membrane_write_f64(membrane, field, u, v, 1, 1, &value, 1));
}

double sheet_energy(const cd_membrane* membrane) {
    double kinetic, elastic, gravity;
    ok(cd_membrane_get_energy(membrane, &kinetic, &elastic, &gravity));
    return kinetic + elastic + gravity;
}

double sheet_swing_energy(const cd_membrane* membrane) {
    double kinetic, elastic;
    ok(cd_membrane_get_energy(membrane, &kinetic, &elastic, NULL));
    return kinetic + elastic;
}

size_t sheet_first_mode(const struct sheet* s, int d) {
    return s->ends[d] == SHEET_FIXED || s->ends[d] == SHEET_FIXED_FREE;
}

size_t sheet_last_mode(const struct sheet* s, int d) { return s->nodes[d] - (s->ends[d] == SHEET_FIXED ? 2 : 1); }

/* s_j: the eigenvalues of the line's Laplacian are 4 s_j^2. Half an end mass makes a free end the mirror of a node. */
static long double half_sine(const struct sheet* s, int d, size_t j) {
    const long double n = (long double)(s->nodes[d] - 1), t = (long double)j * PI;
    if (s->nodes[d] == 1) return 0;
    switch (s->ends[d]) {
    case SHEET_FREE: return sinl(t / (2 * (is_half(s) ? n : n + 1)));
    case SHEET_FIXED: return sinl(t / (2 * n));
    case SHEET_FIXED_FREE: return sinl((t - PI / 2) / (is_half(s) ? 2 * n : 2 * n + 1));
    default: return sinl(t / (n + 1));
    }
}

long double sheet_line_shape(const struct sheet* s, int d, size_t j, size_t i) {
    const long double n = (long double)(s->nodes[d] - 1), t = (long double)j * PI, at = (long double)i;
    if (s->nodes[d] == 1) return 1;
    switch (s->ends[d]) {
    case SHEET_FREE: return is_half(s) ? cosl(t * at / n) : cosl(t * (at + 0.5L) / (n + 1));
    case SHEET_FIXED: return i == 0 || i + 1 == s->nodes[d] ? 0 : sinl(t * at / n);
    case SHEET_FIXED_FREE: return sinl((2 * t - PI) * at / (is_half(s) ? 2 * n : 2 * n + 1));
    default: return sqrtl(2) * sinl(2 * t * at / (n + 1) + PI / 4); /* cos + sin: N of them make a basis */
    }
}

long double sheet_shape(const struct sheet* s, size_t p, size_t q, size_t u, size_t v) {
    return sheet_line_shape(s, 0, p, u) * sheet_line_shape(s, 1, q, v);
}

/* Along a line k d / m + b d^2 / m with d = 4 s^2; across, twice the geometric mean of the two bends times d_u d_v:
 * together (sqrt(b_u) d_u + sqrt(b_v) d_v)^2. */
static struct sheet_mode mode_at(const struct sheet* s, long double su, long double sv) {
    const long double mass = sheet_node_mass(s), half[2] = {su, sv};
    struct sheet_mode mode;
    for (int d = 0; d < 2; ++d) {
        const long double laplacian = 4 * half[d] * half[d];
        mode.bend[d] = sheet_bend(s, d) * laplacian * laplacian / mass;
        mode.along[d] = sheet_spring(s, d) * laplacian / mass + mode.bend[d];
    }
    mode.twist = 2 * sqrtl(mode.bend[0]) * sqrtl(mode.bend[1]);
    return mode;
}

struct sheet_mode sheet_mode(const struct sheet* s, size_t p, size_t q) {
    return mode_at(s, half_sine(s, 0, p), half_sine(s, 1, q));
}

long double sheet_omega(const struct sheet_mode* mode) { return sqrtl(mode->along[0] + mode->along[1] + mode->twist); }

long double sheet_omega_max(const struct sheet* s) {
    const struct sheet_mode mode = mode_at(s, s->nodes[0] > 1, s->nodes[1] > 1);
    return sheet_omega(&mode);
}

/* The rate of change a of an implicit stage of length h is (1 + h c + h^2 w^2) a = -w^2 (x + h v) - c v. Factored, with
 * m = 1 + h drag and a_d = h (h + damping) w_d^2, the bracket becomes (m + a_u) (m + a_v) / m; a sheet that can twist
 * counts the bend twice in each a_d. Then x += s (v + h a) and v += s a: once with s = dt, or, stiff second order,
 * h = g dt, with s = (1 - g) dt and then with s = g dt. */
struct matrix2 sheet_step_matrix(const struct sheet* sheet, const struct sheet_mode* mode, const struct time_step* step,
                                 cd_solver solver, long double dt) {
    const long double omega = sheet_omega(mode), w2 = omega * omega, c = sheet->drag + sheet->damping * w2;
    if (!sheet_solves(step)) return step_matrix(step, dt, omega, c);
    const int stiff = step->method == CD_METHOD_STIFF_SECOND;
    const long double g = 1 - sqrtl(0.5L), h = (stiff ? g : step->lambda) * dt;
    const long double m = 1 + h * sheet->drag, h2 = h * (h + sheet->damping);
    const int twists = sheet->nodes[0] > 1 && sheet->nodes[1] > 1;
    const long double a_u = h2 * (mode->along[0] + twists * mode->bend[0]);
    const long double a_v = h2 * (mode->along[1] + twists * mode->bend[1]);
    const long double factored = (m + a_u) * (m + a_v) / m;
    const long double system = solver == CD_SOLVER_ALTERNATING ? factored : 1 + h * c + h * h * w2;
    const long double ax = -w2 / system, av = -(h * w2 + c) / system;
    struct matrix2 result = {{{1, 0}, {0, 1}}};
    for (int k = 0; k < (stiff ? 2 : 1); ++k) {
        const long double s = !stiff ? dt : k == 0 ? (1 - g) * dt : g * dt;
        const struct matrix2 stage = {{{1 + s * h * ax, s + s * h * av}, {s * ax, 1 + s * av}}};
        result = matrix_times(stage, result);
    }
    return result;
}

int sheet_solves(const struct time_step* step) {
    return step->method == CD_METHOD_STIFF_SECOND || (step->method == CD_METHOD_IMPLICIT && step->lambda > 0);
}

int sheet_step(cd_membrane* membrane, double dt, size_t count) {
    const cd_status status = cd_membrane_step(membrane, dt, count);
    if (status != CD_ERROR_TOLERANCE) ok(status);
    return status == CD_OK;
}

void sheet_set_time_step(cd_membrane* membrane, const struct time_step* step) {
    ok(cd_membrane_set_method(membrane, step->method));
    ok(cd_membrane_set_lambda(membrane, step->lambda));
}
