/* Cloth in scenes that are hard for a solver: energy never rises by itself, whatever the step, the stiffness, the
 * masses and the effort; and numbers far beyond what a scene should have. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "check.h"
#include "cloth.h"
#include "reference.h"
#include "sheet.h"

enum { MOST_NODES = 256, MOST_NUMBERS = 3 * MOST_NODES };

static double share(uint64_t* seed) { return 0.5 + 0.5 * random_number(seed); } /* in [0, 1) */
static int chance(uint64_t* seed, double probability) { return share(seed) < probability; }
static double decades(uint64_t* seed, double from, double to) { return pow(10, from + (to - from) * share(seed)); }

static size_t nodes_of(const cd_membrane* m) { return cloth_extent(m, CD_MASS).count; }
static int is_on(const cd_membrane* m, cd_field field) {
    double values[3];
    return cd_membrane_read_f64(m, field, 0, 0, 1, 1, values, cloth_extent(m, field).components) == CD_OK;
}
/* A field of one number per node or spring, or this number where it is off. */
static void read_or(const cd_membrane* m, cd_field field, double otherwise, double* out) {
    if (is_on(m, field)) cloth_read(m, field, out);
    else
        for (size_t i = 0; i < nodes_of(m); ++i) out[i] = otherwise;
}

/* ---- energy ------------------------------------------------------------------------------------------------------ */

/* How deep a place lies in a collider. */
static double depth_in(const cd_membrane* m, size_t collider, const double* x) {
    double first[3], second[3], radius, thickness, along = 0, square = 0, away = 0;
    cd_shape shape;
    ok(cd_membrane_get_collider(m, collider, &shape, first, second, NULL, 3, &radius, NULL));
    ok(cd_membrane_get_thickness(m, &thickness));
    if (shape == CD_SHAPE_NONE) return -INFINITY;
    if (shape == CD_SHAPE_PLANE) {
        for (int k = 0; k < 3; ++k) away += second[k] * (x[k] - first[k]);
        return thickness - away;
    }
    for (int k = 0; k < 3; ++k)
        along += (second[k] - first[k]) * (x[k] - first[k]), square += (second[k] - first[k]) * (second[k] - first[k]);
    along = square > 0 ? fmin(fmax(along / square, 0), 1) : 0;
    for (int k = 0; k < 3; ++k) away += pow(x[k] - first[k] - along * (second[k] - first[k]), 2);
    return radius + thickness - sqrt(away);
}

struct energy {
    double sum, scale;           /* of its parts; and of each part's size */
    double pull, stiffness, far; /* at most, of springs and contacts together; the largest number of the positions.
                                  * What keeps cloth from crumpling is made up of two pulls by compression * length */
};

/* Also of constant forces and of the contacts, which push a node that is d deep like a spring of 1e4 m / dt^2. */
static struct energy energy_of(const cd_membrane* m, double dt) {
    static double x[MOST_NUMBERS], force[MOST_NUMBERS];
    static double mass[MOST_NODES], pin[MOST_NODES], mask[MOST_NODES], k[MOST_NODES];
    struct energy e = {0, 0, 0, 0, 0};
    double kinetic, elastic, gravity, g[3], lambda, total, shear;
    size_t colliders;
    ok(cd_membrane_get_energy(m, &kinetic, &elastic, &gravity));
    ok(cd_membrane_get_gravity(m, g, 3));
    ok(cd_membrane_get_lambda(m, &lambda));
    ok(cd_membrane_get_mass(m, &total));
    ok(cd_membrane_get_shear(m, &shear));
    ok(cd_membrane_get_colliders(m, &colliders));
    cloth_read(m, CD_POSITION, x);
    read_or(m, CD_MASS, total / (double)nodes_of(m), mass);
    read_or(m, CD_PIN, 0, pin);
    read_or(m, CD_MASK, 1, mask);
    memset(force, 0, sizeof force);
    if (is_on(m, CD_FORCE)) cloth_read(m, CD_FORCE, force);
    e.sum = kinetic + elastic + gravity;
    e.scale = kinetic + elastic;
    for (size_t i = 0; i < nodes_of(m); ++i) {
        for (int j = 0; j < 3; ++j) e.far = fmax(e.far, fabs(x[3 * i + (size_t)j]));
        if (pin[i] != CD_NODE_FREE || mask[i] == 0) continue;
        for (size_t j = 3 * i; j < 3 * i + 3; ++j) {
            e.sum -= force[j] * x[j];
            e.scale += fabs(force[j] * x[j]) + mass[i] * fabs(g[j % 3] * x[j]);
        }
        for (size_t c = 0; c < colliders; ++c) {
            const double depth = depth_in(m, c, x + 3 * i), stiffness = 1e4 * mass[i] / (lambda * dt * dt);
            if (!(depth > 0)) continue;
            e.stiffness += stiffness;
            e.sum += stiffness / 2 * depth * depth, e.scale += stiffness / 2 * depth * depth;
        }
    }
    double bend, compression, tie, damping, along[2], length[2];
    const struct cloth_extent all = cloth_extent(m, CD_POSITION);
    const double columns = (double)all.columns, rows = (double)all.rows;
    ok(cd_membrane_get_bend(m, &bend));
    ok(cd_membrane_get_rest_length(m, &length[0], &length[1]));
    ok(cd_membrane_get_compression(m, &compression));
    ok(cd_membrane_get_stiffness(m, &along[0], &along[1]));
    e.stiffness += shear * columns * rows + 16 * bend * (pow(columns, 3) + pow(rows, 3)) + 4 * compression * total;
    for (size_t i = 0; i < nodes_of(m) && is_on(m, CD_TARGET); ++i) {
        ok(cd_membrane_get_attachment(m, i % all.columns, i / all.columns, &tie, &damping));
        e.stiffness += tie;
    }
    for (cd_field field = CD_STIFFNESS_U; field <= CD_STIFFNESS_V; ++field) {
        read_or(m, field, 2 * along[field == CD_STIFFNESS_V], k);
        for (size_t i = 0; i < cloth_extent(m, field).count; ++i) e.stiffness += k[i];
    }
    e.pull = sqrt(2 * e.stiffness * e.scale) + 2 * compression * total * (length[0] + length[1]);
    return e;
}

/* The largest rise of energy in a step: over its scale; and over what is allowed, 1e-12 of the scale (1e-6 in float32)
 * and what a rounding of the positions is worth. */
struct run {
    double gain, of_allowed;
};
static struct run run(cd_membrane* m, double dt, int steps) {
    struct run run = {0, 0};
    cd_precision precision;
    ok(cd_membrane_get_shape(m, NULL, NULL, NULL, &precision));
    const int wide = precision == CD_FLOAT64;
    struct energy before = energy_of(m, dt);
    for (int step = 0; step < steps; ++step) {
        ok(cd_membrane_step(m, dt, 1));
        const struct energy after = energy_of(m, dt);
        assert_true(isfinite(after.sum));
        const double rise = after.sum - before.sum, scale = fmax(before.scale, after.scale);
        const double off = (wide ? 0x1p-53 : 0x1p-24) * fmax(before.far, after.far);
        const double worth = fmax(before.pull, after.pull) * off + fmax(before.stiffness, after.stiffness) * off * off;
        const double allowed = (wide ? 1e-12 : 1e-6) * scale + worth + 1e-300;
        run.gain = fmax(run.gain, rise / (scale + 1e-300));
        run.of_allowed = fmax(run.of_allowed, rise / allowed);
        before = after;
    }
    return run;
}

/* ---- scenes ------------------------------------------------------------------------------------------------------ */

enum scene { DROP, HEAVY_CORNER, CRUMPLED, STRETCHED, FREE, ON_A_SPHERE, SCENES };
static const char* const names[SCENES] = {"dropped, held at two corners",
                                          "a corner 1000 times heavier",
                                          "crumpled in 5 cm at 10 m/s",
                                          "three times too long",
                                          "free",
                                          "onto a sphere on the floor"};

/* A sheet of 1 m^2 and 0.2 kg. */
static cd_membrane* make(enum scene scene, size_t n, double stiffness) {
    double x[MOST_NUMBERS] = {0}, v[MOST_NUMBERS] = {0};
    const double down[3] = {0, -9.81, 0}, up[3] = {0, 1, 0}, floor[3] = {0, -0.75, 0}, ball[3] = {0.5, -0.3, 0.5};
    const double nodes = (double)(n * n), springs = (double)(n - 1);
    uint64_t seed = 5;
    cd_membrane* m = cloth(n - 1, n - 1, 3, CD_FLOAT64);
    ok(cd_membrane_set_rest_length(m, 1, 1));
    ok(cd_membrane_set_mass(m, 0.2));
    ok(cd_membrane_set_stiffness(m, stiffness * (double)n / springs, stiffness * (double)n / springs));
    ok(cd_membrane_set_shear(m, stiffness / 30));
    ok(cd_membrane_set_bend(m, 1e-5));
    if (scene != FREE) ok(cd_membrane_set_gravity(m, down, 3));
    for (size_t i = 0; i < n * n; ++i) {
        x[3 * i] = (double)(i % n) / springs, x[3 * i + 2] = (double)(i / n) / springs;
        for (size_t k = 3 * i; k < 3 * i + 3; ++k) {
            if (scene == CRUMPLED) x[k] = 0.05 * random_number(&seed), v[k] = 10 * random_number(&seed);
            if (scene == STRETCHED) x[k] *= 3;
        }
        if (scene == FREE) v[3 * i] = 3 * (double)i / nodes, v[3 * i + 1] = 2 * sin(6.0 * (double)(i % n) / (double)n);
    }
    cloth_write(m, CD_POSITION, x), cloth_write(m, CD_VELOCITY, v);
    if (scene == DROP || scene == HEAVY_CORNER || scene == STRETCHED) {
        ok(cd_membrane_enable_field(m, CD_PIN));
        sheet_set(m, CD_PIN, 0, 0, CD_NODE_PINNED), sheet_set(m, CD_PIN, n - 1, 0, CD_NODE_PINNED);
    }
    if (scene == HEAVY_CORNER) {
        ok(cd_membrane_enable_field(m, CD_MASS));
        sheet_set(m, CD_MASS, n - 1, n - 1, 1000 * sheet_get(m, CD_MASS, n - 1, n - 1));
    }
    if (scene == ON_A_SPHERE) {
        ok(cd_membrane_set_colliders(m, 2));
        ok(cd_membrane_set_capsule(m, 0, ball, ball, 3, 0.25, 0.4));
        ok(cd_membrane_set_plane(m, 1, floor, up, 3, 0.4));
        ok(cd_membrane_set_thickness(m, 0.004));
    }
    return m;
}

static void energy_of_hard_scenes_never_rises(void** state) {
    (void)state;
    static const double dts[] = {1.0 / 240, 1.0 / 60, 1.0 / 30, 0.1, 1}, stiffnesses[] = {10, 3000, 1e6, 1e9};
    static const double lambdas[] = {0.5, 0.7, 1};
    static const size_t efforts[][2] = {{1, 1}, {2, 5}, {2, 20}};
    for (int scene = 0; scene < SCENES; ++scene) {
        struct run all = {0, 0};
        for (size_t d = 0; d < COUNT(dts); ++d)
            for (size_t s = 0; s < COUNT(stiffnesses); ++s)
                for (size_t l = 0; l < COUNT(lambdas); ++l)
                    for (size_t e = 0; e < COUNT(efforts); ++e) {
                        if (!is_taken((size_t)scene + d + s + l + e, 2)) continue;
                        cd_membrane* m = make((enum scene)scene, 10, stiffnesses[s]);
                        ok(cd_membrane_set_lambda(m, lambdas[l]));
                        ok(cd_membrane_set_effort(m, efforts[e][0], efforts[e][1]));
                        const struct run r = run(m, dts[d], 40);
                        all.gain = fmax(all.gain, r.gain), all.of_allowed = fmax(all.of_allowed, r.of_allowed);
                        if (r.of_allowed > 1)
                            print_message("%s, dt %.3g, stiffness %g, lambda %g, effort %zu x %zu: gain %.1e\n",
                                          names[scene], dts[d], stiffnesses[s], lambdas[l], efforts[e][0],
                                          efforts[e][1], r.gain);
                        cd_membrane_destroy(m);
                    }
        print_message("%-30s gain %.1e of the scale, %.2f of what is allowed\n", names[scene], all.gain,
                      all.of_allowed);
        assert_true(all.of_allowed <= 1);
    }
}

/* ---- random sheets ----------------------------------------------------------------------------------------------- */

/* Numbers around `size`, up to so many decades away; each of them 0 by this chance. */
static void vary(cd_membrane* m, cd_field field, double size, double away, double none, uint64_t* seed) {
    double values[MOST_NUMBERS];
    ok(cd_membrane_enable_field(m, field));
    for (size_t i = 0; i < cloth_extent(m, field).count; ++i)
        values[i] = chance(seed, none) ? 0 : size * decades(seed, -away, away);
    cloth_write(m, field, values);
}

static void vary_fields(cd_membrane* m, double spring, uint64_t* seed) {
    const size_t nodes = nodes_of(m);
    double values[MOST_NUMBERS];
    const double away = 3 * share(seed), none = chance(seed, 0.5) ? 0 : 0.15;
    vary(m, CD_MASS, decades(seed, -3, 1), chance(seed, 0.5) ? away : 0, 0, seed); /* see energy_of */
    if (chance(seed, 0.3)) vary(m, CD_STIFFNESS_U, decades(seed, 0, 7), away, none, seed);
    if (chance(seed, 0.3)) vary(m, CD_STIFFNESS_V, decades(seed, 0, 7), away, none, seed);
    if (chance(seed, 0.3)) vary(m, CD_REST_LENGTH_U, spring, 0.5, 0, seed);
    if (chance(seed, 0.3)) vary(m, CD_REST_LENGTH_V, spring, 1, 0, seed);
    if (chance(seed, 0.3)) {
        ok(cd_membrane_enable_field(m, CD_FORCE));
        for (size_t i = 0; i < 3 * nodes; ++i) values[i] = 0.1 * random_number(seed);
        cloth_write(m, CD_FORCE, values);
    }
    for (cd_field field = CD_PIN; field <= CD_MASK; ++field) {
        const int mask = field == CD_MASK;
        if (!chance(seed, 0.3)) continue;
        ok(cd_membrane_enable_field(m, field));
        for (size_t i = 0; i < nodes; ++i) values[i] = mask ? !chance(seed, 0.1) : chance(seed, 0.1);
        cloth_write(m, field, values);
    }
    for (size_t k = (size_t)(4 * share(seed)); k > 0 && chance(seed, 0.5); --k) {
        const struct cloth_extent all = cloth_extent(m, CD_POSITION);
        const size_t node = (size_t)(share(seed) * (double)nodes);
        const double stiffness = decades(seed, -1, 6), damping = chance(seed, 0.5) ? 0 : decades(seed, -2, 3);
        const double target[3] = {random_number(seed), random_number(seed), random_number(seed)};
        ok(cd_membrane_attach(m, node % all.columns, node / all.columns, stiffness, damping, target, 3));
    }
}

/* At rest, and three at most, so that a node heeds all of them. */
static void meet(cd_membrane* m, double size, uint64_t* seed) {
    const size_t count = 1 + (size_t)(3 * share(seed));
    ok(cd_membrane_set_colliders(m, count));
    for (size_t i = 0; i < count; ++i) {
        double first[3], last[3];
        for (int k = 0; k < 3; ++k) first[k] = size * random_number(seed), last[k] = size * random_number(seed);
        const double radius = size * decades(seed, -2, 0), friction = chance(seed, 0.4) ? 0 : share(seed);
        if (chance(seed, 0.3)) ok(cd_membrane_set_plane(m, i, first, last, 3, friction));
        else ok(cd_membrane_set_capsule(m, i, first, chance(seed, 0.5) ? first : last, 3, radius, friction));
    }
    if (chance(seed, 0.5)) ok(cd_membrane_set_thickness(m, 0.02 * size));
}

static void lay_out(cd_membrane* m, double size, uint64_t* seed) {
    const struct cloth_extent all = cloth_extent(m, CD_POSITION);
    double x[MOST_NUMBERS], v[MOST_NUMBERS];
    const int kind = (int)(4 * share(seed)); /* flat, stretched, random, in one point */
    const double spacing = size / (double)(all.columns + all.rows) * (kind == 1 ? 3 : 1), speed = decades(seed, -2, 2);
    const double noise = kind == 2 ? size : kind == 3 ? 0 : size * decades(seed, -6, -1);
    for (size_t i = 0; i < all.count; ++i) {
        const size_t node = i / 3, place = i % 3 == 0 ? node % all.columns : i % 3 == 1 ? node / all.columns : 0;
        x[i] = (kind < 2 ? spacing * (double)place : 0) + noise * random_number(seed);
        v[i] = speed * random_number(seed);
    }
    cloth_write(m, CD_POSITION, x);
    for (size_t i = 0; i < all.columns * all.rows; ++i) /* a held node refuses */
        (void)cd_membrane_write_f64(m, CD_VELOCITY, i % all.columns, i / all.columns, 1, 1, v + 3 * i, 3);
}

static cd_membrane* random_sheet(uint64_t* seed, cd_precision precision) {
    const size_t nu = 1 + (size_t)(9 * share(seed)), nv = 1 + (size_t)(9 * share(seed));
    const double size = decades(seed, -1, 1), spring = size / (double)(nu > nv ? nu : nv);
    double gravity[3];
    cd_membrane* m = cloth(nu, nv, 3, precision);
    ok(cd_membrane_set_ring(m, nu > 1 && chance(seed, 0.2), nv > 1 && chance(seed, 0.2)));
    ok(cd_membrane_set_rest_length(m, spring * (double)nu, spring * (double)nv));
    ok(cd_membrane_set_lambda(m, chance(seed, 0.3) ? 1 : chance(seed, 0.3) ? 0.5 : 0.5 + 0.5 * share(seed)));
    ok(cd_membrane_set_effort(m, 1 + (size_t)(3 * share(seed)), 1 + (size_t)(25 * share(seed))));
    ok(cd_membrane_set_mass_rule(m, chance(seed, 0.3) ? CD_MASS_HALF_ENDS : CD_MASS_EQUAL));
    ok(cd_membrane_set_mass(m, decades(seed, -3, 3)));
    const double along_u = chance(seed, 0.1) ? 0 : decades(seed, 0, 8);
    ok(cd_membrane_set_stiffness(m, along_u, chance(seed, 0.7) ? along_u : decades(seed, 0, 8)));
    if (chance(seed, 0.6)) ok(cd_membrane_set_shear(m, decades(seed, -1, 6)));
    if (chance(seed, 0.5)) ok(cd_membrane_set_bend(m, decades(seed, -7, 2)));
    if (chance(seed, 0.5)) ok(cd_membrane_set_compression(m, chance(seed, 0.3) ? 0 : decades(seed, -1, 4)));
    if (chance(seed, 0.2)) ok(cd_membrane_set_drag(m, decades(seed, -2, 3)));
    for (int k = 0; k < 3; ++k) gravity[k] = chance(seed, 0.5) ? 0 : 10 * random_number(seed);
    ok(cd_membrane_set_gravity(m, gravity, 3));
    for (cd_edge edge = CD_EDGE_U_FIRST; edge <= CD_EDGE_V_LAST; ++edge)
        if (chance(seed, 0.1)) ok(cd_membrane_set_edge(m, edge, CD_NODE_PINNED));
    if (chance(seed, 0.3)) ok(cd_membrane_set_air(m, decades(seed, -3, 1), decades(seed, -2, 3)));
    lay_out(m, size, seed);
    vary_fields(m, spring, seed);
    if (chance(seed, 0.5)) meet(m, size, seed);
    return m;
}

static void energy_of_random_sheets_never_rises(void** state) {
    (void)state;
    const int count = is_long() ? 20000 : 2000;
    for (cd_precision precision = CD_FLOAT32; precision <= CD_FLOAT64; ++precision) {
        const int bits = precision == CD_FLOAT32 ? 32 : 64;
        double gain = 0, of_allowed = 0;
        for (int number = 0; number < (bits == 32 ? count / 4 : count); ++number) {
            uint64_t seed = 1000 + (uint64_t)number;
            cd_membrane* m = random_sheet(&seed, precision);
            const double most = bits == 32 || chance(&seed, 0.7) ? 1 : 20;
            const double dt = chance(&seed, 0.5) ? 1.0 / 60 : decades(&seed, -3, most);
            const struct run r = run(m, dt, 25);
            cd_membrane_destroy(m);
            gain = fmax(gain, r.gain), of_allowed = fmax(of_allowed, r.of_allowed);
            if (r.of_allowed > 1)
                print_message("float%d, sheet %d, dt %.3g: %.2g of what is allowed\n", bits, number, dt, r.of_allowed);
        }
        print_message("random, float%d: gain %.1e of the scale, %.2f of what is allowed\n", bits, gain, of_allowed);
        assert_true(of_allowed <= 1);
    }
}

/* Sheets that begin inside a resting plane, up to 10 cm deep, come out of it in a step; and no node is faster then than
 * it was, but by the little that springs which came out unevenly give. */
static void what_begins_inside_comes_out_and_is_not_thrown(void** state) {
    (void)state;
    static const double floor[3] = {0, 0, 0}, up[3] = {0, 1, 0}, lambdas[] = {0.5, 0.7, 1};
    for (size_t l = 0; l < COUNT(lambdas); ++l)
        for (int uneven = 0; uneven < 2; ++uneven) {
            double x[MOST_NUMBERS], v[MOST_NUMBERS], highest = -1, lowest = 1, fastest = 0;
            cd_membrane* m = make(FREE, 9, 1000);
            const size_t count = cloth_extent(m, CD_POSITION).count;
            uint64_t seed = 3;
            ok(cd_membrane_set_lambda(m, lambdas[l]));
            cloth_read(m, CD_POSITION, x);
            for (size_t i = 1; i < count; i += 3) x[i] = uneven ? -0.1 * share(&seed) : -0.1;
            memset(v, 0, sizeof v);
            cloth_write(m, CD_POSITION, x), cloth_write(m, CD_VELOCITY, v);
            ok(cd_membrane_set_colliders(m, 1));
            ok(cd_membrane_set_plane(m, 0, floor, up, 3, 0.5));
            const struct run r = run(m, 1.0 / 60, 10);
            cloth_read(m, CD_POSITION, x), cloth_read(m, CD_VELOCITY, v);
            for (size_t i = 0; i < count; ++i) {
                fastest = fmax(fastest, fabs(v[i]));
                if (i % 3 == 1) highest = fmax(highest, x[i]), lowest = fmin(lowest, x[i]);
            }
            print_message("lambda %g, %s: from %.1e to %.1e m high, at %.1e m/s at most\n", lambdas[l],
                          uneven ? "uneven" : "level", lowest, highest, fastest);
            assert_true(r.of_allowed <= 1);
            assert_true(lowest > -1e-3);
            if (!uneven) assert_true(highest < 1e-3 && fastest < 1e-6);
            else assert_true(highest < 0.01 && fastest < 0.05);
            cd_membrane_destroy(m);
        }
}

/* ---- extremes ---------------------------------------------------------------------------------------------------- */

static int all_finite(const cd_membrane* m) {
    double x[MOST_NUMBERS];
    for (cd_field field = CD_POSITION; field <= CD_VELOCITY; ++field) {
        cloth_read(m, field, x);
        for (size_t i = 0; i < cloth_extent(m, field).count; ++i)
            if (!isfinite(x[i])) return 0;
    }
    return 1;
}

struct extreme {
    double mass, stiffness, length, dt, size, speed;
    int features; /* bits: shear and bend; a ring; colliders; air; a drag and ties; lambda 1/2 */
    cd_precision precision;
};
enum { NU = 4, NV = 3, ALL = 3 * (NU + 1) * (NV + 1), FEATURES = 64 };

static cd_membrane* new_extreme(const struct extreme* e) {
    const double near = fmin(e->size, 1e60), gravity[3] = {0, -9.81, 1};
    const double first[3] = {0, 0, 0}, last[3] = {near, 0, 0}, up[3] = {0, 1, 0.5};
    cd_membrane* m = cloth(NU, NV, 3, e->precision);
    ok(cd_membrane_set_ring(m, 0, e->features >> 1 & 1));
    ok(cd_membrane_set_rest_length(m, e->length, e->length));
    ok(cd_membrane_set_mass(m, e->mass));
    ok(cd_membrane_set_stiffness(m, e->stiffness, e->stiffness));
    ok(cd_membrane_set_gravity(m, gravity, 3));
    if (e->features & 1) ok(cd_membrane_set_shear(m, e->stiffness)), ok(cd_membrane_set_bend(m, e->stiffness));
    if (e->features & 4) {
        ok(cd_membrane_set_colliders(m, 2));
        ok(cd_membrane_set_plane(m, 0, first, up, 3, 0.5));
        ok(cd_membrane_set_capsule(m, 1, first, last, 3, fmax(near, 1e-60), 0.5));
    }
    if (e->features & 8) ok(cd_membrane_set_air(m, 1e-3, 1)), ok(cd_membrane_set_wind(m, up, 3));
    if (e->features & 16) {
        ok(cd_membrane_set_drag(m, 1));
        ok(cd_membrane_attach(m, 2, 2, e->stiffness, 1, up, 3));
    }
    if (e->features & 32) ok(cd_membrane_set_lambda(m, 0.5));
    ok(cd_membrane_enable_field(m, CD_PIN));
    sheet_set(m, CD_PIN, 1, 1, CD_NODE_PINNED);
    return m;
}

/* Positions and velocities of this size; 0: all nodes in one point. Node (1, 1) is held. */
static void place_extreme(cd_membrane* m, const struct extreme* e) {
    double x[ALL], v[ALL];
    uint64_t seed = 7;
    for (size_t i = 0; i < ALL; ++i) {
        x[i] = e->size * random_number(&seed);
        v[i] = i / 3 == NU + 2 ? 0 : e->speed * random_number(&seed);
    }
    cloth_write(m, CD_POSITION, x), cloth_write(m, CD_VELOCITY, v);
}

static void print_extreme(const struct extreme* e, const char* what) {
    print_error("%s: mass %g, stiffness %g, length %g, dt %g, size %g, speed %g, features %d, float%d\n", what, e->mass,
                e->stiffness, e->length, e->dt, e->size, e->speed, e->features, e->precision == CD_FLOAT64 ? 64 : 32);
}

/* Returns how many things are wrong. */
static size_t step_extreme(const struct extreme* e, size_t* diverged) {
    size_t wrong = 0;
    const struct extreme calm = {1, 1000, 1, 1.0 / 60, 1, 1, 0, e->precision};
    cd_membrane *m = new_extreme(e), *fresh = new_extreme(e);
    double held[2][3], v[3];
    uint64_t hash[2];
    place_extreme(m, e);
    ok(cd_membrane_read_f64(m, CD_POSITION, 1, 1, 1, 1, held[0], 3));
    for (int step = 0; step < 4; ++step) {
        const cd_status status = cd_membrane_step(m, e->dt, 1 + (size_t)(step == 3));
        const int finite = all_finite(m);
        if (status != (finite ? CD_OK : CD_ERROR_DIVERGED)) print_extreme(e, cd_status_name(status)), ++wrong;
        ok(cd_membrane_read_f64(m, CD_POSITION, 1, 1, 1, 1, held[1], 3));
        ok(cd_membrane_read_f64(m, CD_VELOCITY, 1, 1, 1, 1, v, 3));
        int still = 1;
        for (int k = 0; k < 3; ++k) still &= held[1][k] == held[0][k] && v[k] == 0;
        if (!still) print_extreme(e, finite ? "a held node has moved" : "a held node has moved, diverged"), ++wrong;
        if (!finite) break;
        *diverged -= step == 3;
    }
    ++*diverged;
    for (int k = 0; k < 2; ++k) {
        cd_membrane* const one = k ? fresh : m;
        if (k == 0) ok(cd_membrane_reset(one));
        place_extreme(one, &calm);
        (void)cd_membrane_step(one, 1.0 / 60, 3);
        hash[k] = hash_of(one);
    }
    if (all_finite(fresh) && hash[0] != hash[1]) print_extreme(e, "another hash after a reset"), ++wrong;
    cd_membrane_destroy(m);
    cd_membrane_destroy(fresh);
    return wrong;
}

static void extremes_end_and_tell_what_they_are(void** state) {
    (void)state;
    static const double masses[] = {1e-60, 1, 1e60}, stiffnesses[] = {0, 1e-60, 1000, 1e60};
    static const double lengths[] = {1e-60, 1, 1e60}, dts[] = {1e-30, 1e-3, 1, 1e30};
    static const double sizes[] = {0, 1e-60, 1, 1e20, 1e150, 1e300}, speeds[] = {0, 1, 1e150};
    size_t wrong = 0, diverged = 0, count = 0;
    uint64_t seed = 1;
    for (size_t a = 0; a < COUNT(masses); ++a)
        for (size_t b = 0; b < COUNT(stiffnesses); ++b)
            for (size_t c = 0; c < COUNT(lengths); ++c)
                for (size_t d = 0; d < COUNT(dts); ++d)
                    for (size_t f = 0; f < COUNT(sizes); ++f)
                        for (size_t g = 0; g < COUNT(speeds); ++g) {
                            const int narrow = sizes[f] < 1e30 && speeds[g] < 1e30 && chance(&seed, 0.3);
                            const struct extreme e = {masses[a], stiffnesses[b], lengths[c],
                                                      dts[d],    sizes[f],       speeds[g],
                                                      (int)(FEATURES * share(&seed)),
                                                      narrow ? CD_FLOAT32 : CD_FLOAT64};
                            wrong += step_extreme(&e, &diverged), ++count;
                            if (wrong > 200) fail();
                        }
    print_message("%zu scenes, of which %zu left the finite range\n", count, diverged);
    assert_int_equal(wrong, 0);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(extremes_end_and_tell_what_they_are),
        cmocka_unit_test(what_begins_inside_comes_out_and_is_not_thrown),
        cmocka_unit_test(energy_of_hard_scenes_never_rises),
        cmocka_unit_test(energy_of_random_sheets_never_rises),
    };
    return cmocka_run_group_tests_name("cloth", tests, NULL, NULL);
}
