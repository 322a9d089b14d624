#include "modes.h"

#include <math.h>

#include "check.h"

const char* const lattice_names[LATTICES] = {"free-free", "fixed-free", "free-fixed",  "fixed-fixed",   "half ends",
                                             "ring",      "hinged",     "hinged both", "ring with bend"};

const struct time_step time_steps[TIME_STEPS] = {
    [FORWARD_EULER] = {"forward Euler", CD_METHOD_FORWARD_EULER, 0, 1, 1},
    [SYMPLECTIC_EULER] = {"symplectic Euler", CD_METHOD_SYMPLECTIC_EULER, 0, 0, 1},
    [LAMBDA_0] = {"lambda 0", CD_METHOD_IMPLICIT, 0, 1, 1},
    [LAMBDA_1_4] = {"lambda 1/4", CD_METHOD_IMPLICIT, 0.25, 1, 1},
    [LAMBDA_1_2] = {"lambda 1/2", CD_METHOD_IMPLICIT, 0.5, 0, 0},
    [LAMBDA_3_4] = {"lambda 3/4", CD_METHOD_IMPLICIT, 0.75, 0, 0},
    [LAMBDA_1] = {"lambda 1", CD_METHOD_IMPLICIT, 1, 0, 0},
    [STIFF_SECOND] = {"stiff second", CD_METHOD_STIFF_SECOND, 0, 0, 0},
};

static int is_ring(enum lattice ends) { return ends == RING || ends == RING_BOTH; }
static int has_bend(enum lattice ends) { return ends == HINGED || ends == HINGED_BOTH || ends == RING_BOTH; }
static int first_is_fixed(enum lattice ends) {
    return ends == FIXED_FREE || ends == FIXED_FIXED || ends == HINGED || ends == HINGED_BOTH;
}
static int last_is_fixed(enum lattice ends) {
    return ends == FREE_FIXED || ends == FIXED_FIXED || ends == HINGED || ends == HINGED_BOTH;
}

cd_chain* make_lattice_chain(const struct lattice_chain* l, size_t strands, size_t components, cd_precision precision) {
    cd_chain* chain = NULL;
    ok(cd_chain_create(strands, l->nodes - 1, components, precision, NULL, &chain));
    ok(cd_chain_set_mass(chain, l->mass));
    ok(cd_chain_set_stiffness(chain, l->ends == HINGED ? 0 : l->stiffness));
    if (has_bend(l->ends)) ok(cd_chain_set_bend(chain, l->bend));
    if (l->ends == HALF_ENDS) ok(cd_chain_set_mass_rule(chain, CD_MASS_HALF_ENDS));
    if (is_ring(l->ends)) ok(cd_chain_set_ring(chain, 1));
    if (first_is_fixed(l->ends)) ok(cd_chain_set_end(chain, CD_END_FIRST, CD_NODE_PINNED));
    if (last_is_fixed(l->ends)) ok(cd_chain_set_end(chain, CD_END_LAST, CD_NODE_PINNED));
    ok(cd_chain_set_drag(chain, l->drag));
    ok(cd_chain_set_stiffness_damping(chain, l->stiffness_damping));
    return chain;
}

int lattice_is_free(const struct lattice_chain* l) {
    return l->ends == FREE_FREE || l->ends == HALF_ENDS || is_ring(l->ends);
}

size_t lattice_last_mode(const struct lattice_chain* l) {
    const size_t springs = l->nodes - 1;
    switch (l->ends) {
    case FIXED_FIXED:
    case HINGED:
    case HINGED_BOTH: return springs - 1;
    case RING:
    case RING_BOTH: return l->nodes / 2;
    default: return springs;
    }
}

/* s_j: the eigenvalues of the path's Laplacian are 4 s_j^2. */
static long double half_sine(const struct lattice_chain* l, size_t j) {
    const long double n = (long double)(l->nodes - 1);
    switch (l->ends) {
    case FREE_FREE: return sinl((long double)j * PI / (2 * (n + 1)));
    case FIXED_FREE:
    case FREE_FIXED: return sinl((long double)(2 * j - 1) * PI / (2 * (2 * n + 1)));
    case RING:
    case RING_BOTH: return sinl((long double)j * PI / (n + 1));
    default: return sinl((long double)j * PI / (2 * n));
    }
}

/* Per spring k n, per node mass m / (n + 1) (half ends: m / n, and the half masses at the ends make the path's
 * Laplacian that of cosines between them), per bend term b n^3; in a ring of N nodes k N, m / N and b N^3. A bend
 * term is the square of the Laplacian: omega^2 = (4 s^2 k_i + 16 s^4 b_i) / m_i. (model.md, 5 and 6) */
static long double omega_at(const struct lattice_chain* l, long double s) {
    const long double springs = (long double)(is_ring(l->ends) ? l->nodes : l->nodes - 1);
    const long double parts = l->ends == HALF_ENDS ? springs : (long double)l->nodes;
    const long double mass = l->mass / parts;
    const long double stretch = l->ends == HINGED ? 0 : l->stiffness * springs;
    const long double bend = has_bend(l->ends) ? l->bend * springs * springs * springs : 0;
    const long double d = 4 * s * s;
    return sqrtl((stretch * d + bend * d * d) / mass);
}

long double lattice_omega(const struct lattice_chain* l, size_t j) { return omega_at(l, half_sine(l, j)); }

long double lattice_omega_max(const struct lattice_chain* l) { return omega_at(l, 1); }

long double lattice_shape(const struct lattice_chain* l, size_t j, size_t i) {
    const long double n = (long double)(l->nodes - 1), at = (long double)i;
    switch (l->ends) {
    case FREE_FREE: return cosl((long double)j * PI * (at + 0.5L) / (n + 1));
    case FIXED_FREE: return sinl((long double)(2 * j - 1) * PI * at / (2 * n + 1));
    case FREE_FIXED: return sinl((long double)(2 * j - 1) * PI * (n - at) / (2 * n + 1));
    case HALF_ENDS: return cosl((long double)j * PI * at / n);
    case RING:
    case RING_BOTH: return cosl(2 * PI * (long double)j * at / (n + 1) + 0.3L);
    default: return i == 0 || i == l->nodes - 1 ? 0 : sinl((long double)j * PI * at / n);
    }
}

void set_time_step(cd_chain* chain, const struct time_step* step) {
    ok(cd_chain_set_method(chain, step->method));
    ok(cd_chain_set_lambda(chain, step->lambda));
}

struct matrix2 matrix_times(struct matrix2 a, struct matrix2 b) {
    struct matrix2 c;
    for (int i = 0; i < 2; ++i)
        for (int j = 0; j < 2; ++j) c.a[i][j] = a.a[i][0] * b.a[0][j] + a.a[i][1] * b.a[1][j];
    return c;
}

struct matrix2 matrix_power(struct matrix2 a, unsigned long n) {
    struct matrix2 result = {{{1, 0}, {0, 1}}};
    for (; n > 0; n /= 2, a = matrix_times(a, a))
        if (n % 2) result = matrix_times(result, a);
    return result;
}

/* I + s L of the mode's equation (x, v)' = L (x, v), L = (0, 1; -omega^2, -c). */
static struct matrix2 shifted(long double s, long double omega, long double c) {
    return (struct matrix2){{{1, s}, {-s * omega * omega, 1 - s * c}}};
}

/* (I - s L)^-1: its determinant 1 + s c + s^2 omega^2 is the implicit system, one mode of it. */
static struct matrix2 inverse_shifted(long double s, long double omega, long double c) {
    const long double w2 = omega * omega, d = 1 + s * c + s * s * w2;
    return (struct matrix2){{{(1 + s * c) / d, s / d}, {-s * w2 / d, 1 / d}}};
}

/* Forward Euler           Y' = (I + dt L) Y.
 * Symplectic Euler        v' = v - dt (omega^2 x + c v), then x' = x + dt v'.
 * lambda                  (1 + h c + h^2 w^2) delta = h (-w^2 (x + h v) - c v) with h = lambda dt, v' = v + delta /
 *                         lambda, x' = x + dt (v + delta): the same as (I - h L) Y' = (I + (dt - h) L) Y.
 * Stiff second (SDIRK2)   stages (g) and (1 - g, g), g = 1 - 1/sqrt 2; for a linear right side they multiply to
 *                         (I - g dt L)^2 Y' = (I + (1 - 2 g) dt L) Y. */
struct matrix2 step_matrix(const struct time_step* step, long double dt, long double omega, long double c) {
    const long double w2 = omega * omega;
    switch (step->method) {
    case CD_METHOD_FORWARD_EULER: return shifted(dt, omega, c);
    case CD_METHOD_SYMPLECTIC_EULER:
        return (struct matrix2){{{1 - dt * dt * w2, dt - dt * dt * c}, {-dt * w2, 1 - dt * c}}};
    case CD_METHOD_STIFF_SECOND: {
        const long double g = 1 - sqrtl(0.5L);
        const struct matrix2 stage = inverse_shifted(g * dt, omega, c);
        return matrix_times(stage, matrix_times(stage, shifted((1 - 2 * g) * dt, omega, c)));
    }
    default:
        return matrix_times(inverse_shifted(step->lambda * dt, omega, c), shifted((1 - step->lambda) * dt, omega, c));
    }
}
