#include "wild.h"

#include <math.h>
#include <stdlib.h>

#include "check.h"
#include "grid.h"
#include "reference.h"
#include "sheet.h"

const char* const wild_names[WILD_KINDS] = {
    [WILD_FREE] = "free",
    [WILD_HALF_EDGES] = "half edges",
    [WILD_DRUM] = "drum",
    [WILD_FLAG] = "flag",
    [WILD_TORUS] = "torus",
    [WILD_ROWS_HELD] = "rows held inside",
    [WILD_ANISOTROPIC] = "anisotropic 1e4",
    [WILD_HINGED] = "hinged plate",
    [WILD_PLATE_RING] = "plate ring",
    [WILD_CORNERS] = "two corners pinned",
    [WILD_PINS] = "pins inside",
    [WILD_ROUND] = "round mask",
    [WILD_CUT] = "cut",
    [WILD_RANDOM_SPRINGS] = "random springs",
    [WILD_RANDOM_MASSES] = "random masses",
    [WILD_RANDOM_ALL] = "random, pins, mask",
    [WILD_TIED] = "tied",
    [WILD_CYLINDER_PIN] = "cylinder, one pin",
    [WILD_PLATE_FREE] = "free plate",
    [WILD_PLATE_CORNERS] = "plate, two corners",
    [WILD_PLATE_ROUND] = "round plate",
};

int wild_separates(enum wild kind, double stiffest) {
    const int singles = kind == WILD_CORNERS || kind == WILD_PINS || kind == WILD_CYLINDER_PIN || kind == WILD_TIED;
    return kind < WILD_SEPARABLE || (singles && stiffest <= 1e4);
}

int wild_has_bend(enum wild kind) {
    return kind == WILD_HINGED || kind == WILD_PLATE_RING || kind == WILD_PLATE_FREE || kind == WILD_PLATE_CORNERS ||
           kind == WILD_PLATE_ROUND;
}

int wild_drifts(enum wild kind) {
    return kind == WILD_FREE || kind == WILD_HALF_EDGES || kind == WILD_TORUS || kind == WILD_ANISOTROPIC ||
           kind == WILD_ROUND || kind == WILD_RANDOM_SPRINGS || kind == WILD_RANDOM_MASSES || kind == WILD_PLATE_FREE ||
           kind == WILD_PLATE_ROUND;
}

/* Numbers from size / spread to size * spread, at random in their logarithm. */
static void vary(cd_membrane* m, cd_field field, size_t columns, size_t rows, double size, double spread,
                 uint64_t* seed) {
    ok(cd_membrane_enable_field(m, field));
    for (size_t v = 0; v < rows; ++v)
        for (size_t u = 0; u < columns; ++u) sheet_set(m, field, u, v, size * pow(spread, random_number(seed)));
}

static void vary_springs(cd_membrane* m, size_t columns, size_t rows, double size, double spread, uint64_t* seed) {
    vary(m, CD_STIFFNESS_U, columns - 1, rows, size, spread, seed);
    vary(m, CD_STIFFNESS_V, columns, rows - 1, size, spread, seed);
}

static void pin(cd_membrane* m, size_t u, size_t v) {
    ok(cd_membrane_enable_field(m, CD_PIN));
    sheet_set(m, CD_PIN, u, v, CD_NODE_PINNED);
}

static void pin_corners(cd_membrane* m, size_t columns, size_t rows) {
    pin(m, 0, rows - 1);
    pin(m, columns - 1, rows - 1);
}

static void mask_round(cd_membrane* m, size_t columns, size_t rows) {
    ok(cd_membrane_enable_field(m, CD_MASK));
    for (size_t v = 0; v < rows; ++v)
        for (size_t u = 0; u < columns; ++u) {
            const double x = ((double)u + 0.5) / (double)columns * 2 - 1, y = ((double)v + 0.5) / (double)rows * 2 - 1;
            if (x * x + y * y > 1) sheet_set(m, CD_MASK, u, v, 0);
        }
}

/* Per node a mass of 1 and per spring the stiffness, where fields do not say otherwise. */
static struct sheet uniform(enum wild kind, size_t columns, size_t rows, double ratio) {
    const double cu = (double)columns, cv = (double)rows;
    struct sheet s = {.nodes = {columns, rows}, .mass = cu * cv};
    if (kind == WILD_HALF_EDGES || kind == WILD_PLATE_ROUND) s.rule = CD_MASS_HALF_ENDS;
    if (kind == WILD_DRUM || kind == WILD_HINGED) s.ends[0] = s.ends[1] = SHEET_FIXED;
    if (kind == WILD_FLAG) s.ends[0] = SHEET_FIXED_FREE;
    if (kind == WILD_TORUS) s.ends[0] = s.ends[1] = SHEET_RING;
    if (kind == WILD_CYLINDER_PIN || kind == WILD_PLATE_RING) s.ends[0] = SHEET_RING;
    if (kind == WILD_PLATE_RING) s.ends[1] = SHEET_FIXED;
    s.stiffness[0] = ratio * cv / cu;
    s.stiffness[1] = ratio * cu / cv;
    if (kind == WILD_ANISOTROPIC) s.stiffness[1] /= 1e4;
    if (wild_has_bend(kind)) s.bend = ratio / (cu * cv);
    return s;
}

cd_membrane* wild_membrane(enum wild kind, size_t columns, size_t rows, size_t components, cd_precision precision,
                           double ratio, uint64_t seed) {
    const struct sheet s = uniform(kind, columns, rows, ratio);
    cd_membrane* m = sheet_membrane(&s, components, precision);
    switch (kind) {
    case WILD_ROWS_HELD:
        for (size_t u = 0; u < columns; ++u) pin(m, u, rows / 3), pin(m, u, rows / 2);
        break;
    case WILD_CORNERS:
    case WILD_PLATE_CORNERS: pin_corners(m, columns, rows); break;
    case WILD_CYLINDER_PIN: pin(m, columns / 2, rows / 2); break;
    case WILD_PINS:
        for (size_t k = 1; k < 4; ++k) pin(m, k * columns / 4, k * k * rows / 16);
        break;
    case WILD_ROUND:
    case WILD_PLATE_ROUND: mask_round(m, columns, rows); break;
    case WILD_CUT:
        pin_corners(m, columns, rows);
        ok(cd_membrane_enable_field(m, CD_STIFFNESS_V));
        for (size_t u = 0; u < columns * 2 / 3; ++u) sheet_set(m, CD_STIFFNESS_V, u, rows / 2, 0);
        break;
    case WILD_RANDOM_SPRINGS: vary_springs(m, columns, rows, ratio, 30, &seed); break;
    case WILD_RANDOM_MASSES: vary(m, CD_MASS, columns, rows, 1, 30, &seed); break;
    case WILD_RANDOM_ALL:
        vary_springs(m, columns, rows, ratio, 1000, &seed);
        vary(m, CD_MASS, columns, rows, 1, 30, &seed);
        pin(m, columns / 2, rows / 2);
        pin(m, 0, 0);
        mask_round(m, columns, rows);
        break;
    case WILD_TIED:
        for (size_t k = 0; k < 3; ++k)
            ok(cd_membrane_attach(m, k * (columns - 1) / 2, k * (rows - 1) / 2, ratio / 3, 0, NULL, 0));
        break;
    default: break;
    }
    return m;
}

void wild_shake(cd_membrane* m, double position, double velocity, uint64_t seed) {
    struct grid* g = grid_of(m);
    const size_t each = g->components;
    double* x = calloc(g->nodes * each, sizeof *x);
    double* v = calloc(g->nodes * each, sizeof *v);
    assert_non_null(x);
    assert_non_null(v);
    int drifts = 1;
    for (size_t i = 0; i < g->nodes * each; ++i) {
        x[i] = position * random_number(&seed);
        v[i] = g->held[i / each] ? 0 : velocity * random_number(&seed);
        if (g->held[i / each] && !g->absent[i / each]) drifts = 0;
    }
    for (size_t c = 0; c < each && drifts; ++c) {
        long double momentum = 0, mass = 0;
        for (size_t i = 0; i < g->nodes; ++i)
            if (!g->absent[i]) mass += g->mass[i], momentum += g->mass[i] * v[i * each + c];
        for (size_t i = 0; i < g->nodes; ++i)
            if (!g->absent[i]) v[i * each + c] -= (double)(momentum / mass);
    }
    sheet_write(m, CD_POSITION, x);
    sheet_write(m, CD_VELOCITY, v);
    free(x);
    free(v);
    grid_destroy(g);
}
