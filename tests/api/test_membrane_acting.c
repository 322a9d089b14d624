/* Acting on a membrane and measuring it: impulses, soft ties, samples, energy, momentum and volume, against their
 * definitions. */
#include <math.h>
#include <stdbool.h>

#include "check.h"
#include "cloth.h"
#include "scene.h"
#include "sheet.h"

enum { NU = 7, NV = 5, COLUMNS = NU + 1, ROWS = NV + 1, COMPONENTS = 3, ALL = COLUMNS * ROWS * COMPONENTS };

static cd_membrane* built(cloth_build* build, cd_precision precision) {
    cd_membrane* m = cloth(NU, NV, COMPONENTS, precision);
    build(m);
    return m;
}

static size_t at(size_t u, size_t v, size_t component) { return (v * COLUMNS + u) * COMPONENTS + component; }

static bool is_held(const cd_membrane* m, size_t u, size_t v) { return sheet_get(m, CD_PIN, u, v) != CD_NODE_FREE; }
static bool is_there(const cd_membrane* m, size_t u, size_t v) { return sheet_get(m, CD_MASK, u, v) == 1; }

/* (1 - (distance / radius)^2)^2, or 1 at the nearest node where no other is near enough */
static double weight(double u, double v, double radius, size_t i, size_t j) {
    const double x = ((double)i - u) / radius, y = ((double)j - v) / radius, rest = 1 - (x * x + y * y);
    return radius > 0 && rest > 0 ? rest * rest : 0;
}

static void an_impulse_is_spread_by_the_weights_of_the_header(void** state) {
    (void)state;
    static const double places[][3] = {{2, 3, 0},     {0, 0, 0},    {7, 5, 0},       {2.4, 2.6, 0},   {3, 3, 1},
                                       {3, 3, 1.5},   {3.25, 2, 2}, {0, 2.5, 3},     {6.75, 4.75, 4}, {3.5, 2.5, 0.5},
                                       {2.2, 1, 0.1}, {4, 2, 1e9},  {1.1, 3.2, 1.25}};
    const double impulse[COMPONENTS] = {0.75, -0.5, 2};
    cloth_build* const builds[] = {cloth_everything, cloth_everything_tube};
    for (size_t b = 0; b < COUNT(builds); ++b) {
        for (size_t p = 0; p < COUNT(places); ++p) {
            const double u = places[p][0], v = places[p][1], radius = places[p][2];
            cd_membrane* m = built(builds[b], CD_FLOAT64);
            double before[ALL], after[ALL], momentum[2][COMPONENTS], sum = 0, taken = 0;
            for (size_t i = 0; i < COLUMNS; ++i)
                for (size_t j = 0; j < ROWS; ++j) sum += weight(u, v, radius, i, j);
            const size_t nearest_u = (size_t)(u + 0.5), nearest_v = (size_t)(v + 0.5);
            cloth_read(m, CD_VELOCITY, before);
            ok(cd_membrane_get_momentum(m, momentum[0], COMPONENTS));
            ok(cd_membrane_impulse(m, u, v, radius, impulse, COMPONENTS));
            ok(cd_membrane_get_momentum(m, momentum[1], COMPONENTS));
            cloth_read(m, CD_VELOCITY, after);
            for (size_t i = 0; i < COLUMNS; ++i)
                for (size_t j = 0; j < ROWS; ++j) {
                    double share = sum > 0 ? weight(u, v, radius, i, j) / sum : i == nearest_u && j == nearest_v;
                    if (is_held(m, i, j) || !is_there(m, i, j)) share = 0;
                    taken += share;
                    for (size_t c = 0; c < COMPONENTS; ++c) {
                        const size_t k = at(i, j, c);
                        if (share == 0) assert_true(after[k] == before[k]);
                        else
                            assert_near(after[k], before[k] + share * impulse[c] / sheet_get(m, CD_MASS, i, j), 1e-14,
                                        1);
                    }
                }
            for (size_t c = 0; c < COMPONENTS; ++c)
                assert_near(momentum[1][c], momentum[0][c] + taken * impulse[c], 1e-13, 1);
            assert_true(taken <= 1 + 1e-14);
            cd_membrane_destroy(m);
        }
    }
}

static void a_round_impulse_on_a_free_sheet_is_all_taken_and_does_not_reach_round_a_ring(void** state) {
    (void)state;
    cd_membrane* m = cloth(NU, NV, 1, CD_FLOAT64);
    const double one = 1;
    double momentum, v[COLUMNS * ROWS];
    ok(cd_membrane_set_ring(m, 1, 1));
    ok(cd_membrane_impulse(m, 0, 0, 2.5, &one, 1));
    ok(cd_membrane_get_momentum(m, &momentum, 1));
    assert_near(momentum, 1, 1e-14, 0);
    cloth_read(m, CD_VELOCITY, v);
    for (size_t u = 0; u < COLUMNS; ++u)
        for (size_t w = 0; w < ROWS; ++w) assert_true((v[w * COLUMNS + u] > 0) == (u * u + w * w < 6.25));
    cd_membrane_destroy(m);
}

struct one_node {
    double mass, stiffness, damping, drag, gravity; /* of a node tied to the origin */
};

/* A step of one node: the equations of membrane.h, with numbers for matrices. */
static void step_one_node(const struct one_node* p, cd_method method, double lambda, double dt, double* x, double* v) {
    const double C = p->drag * p->mass + p->damping, K = p->stiffness, f = p->mass * p->gravity;
    if (method != CD_METHOD_IMPLICIT) lambda = 0;
    const double resists = p->mass + lambda * dt * C + lambda * lambda * dt * dt * K;
    const double dv = dt * (f - K * (*x + lambda * dt * *v) - C * *v) / resists;
    *x += dt * (method == CD_METHOD_SYMPLECTIC_EULER ? *v + dv : *v + lambda * dv);
    *v += dv;
}

static void a_tied_node_moves_as_the_equation_says(void** state) {
    (void)state;
    static const struct {
        cd_method method;
        double lambda;
    } ways[] = {{CD_METHOD_IMPLICIT, 0.5},      {CD_METHOD_IMPLICIT, 1},           {CD_METHOD_IMPLICIT, 0.75},
                {CD_METHOD_FORWARD_EULER, 0.5}, {CD_METHOD_SYMPLECTIC_EULER, 0.5}, {CD_METHOD_IMPLICIT, 0}};
    const struct one_node p = {.mass = 0.5, .stiffness = 30, .damping = 0.75, .drag = 0.25, .gravity = -9.81};
    for (size_t i = 0; i < COUNT(ways); ++i) {
        for (cd_solver solver = CD_SOLVER_ALTERNATING; solver <= CD_SOLVER_COUPLED; ++solver) {
            cd_membrane* m = cloth(0, 0, 1, CD_FLOAT64);
            const double target = 3, start = 0.25;
            double x = start - target, v = 0, got;
            cloth_write(m, CD_POSITION, &start);
            ok(cd_membrane_set_mass(m, p.mass));
            ok(cd_membrane_set_drag(m, p.drag));
            ok(cd_membrane_set_gravity(m, &p.gravity, 1));
            ok(cd_membrane_attach(m, 0, 0, p.stiffness, p.damping, &target, 1));
            ok(cd_membrane_set_method(m, ways[i].method));
            ok(cd_membrane_set_lambda(m, ways[i].lambda));
            ok(cd_membrane_set_solver(m, solver));
            ok(cd_membrane_set_tolerance(m, 1e-14, 100));
            for (int step = 0; step < 50; ++step) {
                ok(cd_membrane_step(m, 0.01, 1));
                step_one_node(&p, ways[i].method, ways[i].lambda, 0.01, &x, &v);
                cloth_read(m, CD_POSITION, &got);
                assert_near(got, x + target, 1e-13, 1);
                cloth_read(m, CD_VELOCITY, &got);
                assert_near(got, v, 1e-12, 1);
            }
            cd_membrane_destroy(m);
        }
    }
}

static void ties_are_told_and_loosened(void** state) {
    (void)state;
    for (int how = 0; how < 2; ++how) {
        cd_membrane* m = built(cloth_curtain, CD_FLOAT64);
        cd_membrane* never = built(cloth_curtain, CD_FLOAT64);
        double stiffness = -1, damping = -1, x[ALL], target[ALL], y[ALL];
        ok(cd_membrane_attach(m, 4, 2, 12, 0.5, NULL, COMPONENTS));
        ok(cd_membrane_get_attachment(m, 4, 2, &stiffness, &damping));
        assert_true(stiffness == 12 && damping == 0.5);
        ok(cd_membrane_get_attachment(m, 2, 4, &stiffness, &damping));
        assert_true(stiffness == 0 && damping == 0);
        cloth_read(m, CD_POSITION, x);
        cloth_read(m, CD_TARGET, target);
        for (size_t c = 0; c < COMPONENTS; ++c) assert_true(target[at(4, 2, c)] == x[at(4, 2, c)]);
        const double elsewhere[COMPONENTS] = {1, 2, 3};
        ok(cd_membrane_attach(m, 4, 2, 10, 0.25, elsewhere, COMPONENTS)); /* again: other numbers */
        ok(cd_membrane_get_attachment(m, 4, 2, &stiffness, &damping));
        assert_true(stiffness == 10 && damping == 0.25);
        cloth_read(m, CD_TARGET, target);
        assert_same_bits(&target[at(4, 2, 0)], elsewhere, COMPONENTS);
        if (how == 0) ok(cd_membrane_detach(m, 4, 2));
        else ok(cd_membrane_disable_field(m, CD_TARGET));
        ok(cd_membrane_detach(m, 4, 2)); /* nothing is tied there: no error */
        ok(cd_membrane_get_attachment(m, 4, 2, &stiffness, &damping));
        assert_true(stiffness == 0 && damping == 0);
        ok(cd_membrane_step(m, 0.01, 50));
        ok(cd_membrane_step(never, 0.01, 50));
        cloth_read(m, CD_POSITION, x);
        cloth_read(never, CD_POSITION, y);
        for (size_t i = 0; i < ALL; ++i) assert_near(x[i], y[i], 1e-11, 1);
        cd_membrane_destroy(m);
        cd_membrane_destroy(never);
    }
}

static void samples_are_bilinear_between_nodes(void** state) {
    (void)state;
    enum { PARTS = 4 };
    static const int32_t rings[][2] = {{0, 0}, {1, 0}, {0, 1}, {1, 1}};
    for (size_t r = 0; r < COUNT(rings); ++r) {
        for (cd_precision precision = CD_FLOAT32; precision <= CD_FLOAT64; ++precision) {
            cd_membrane* m = built(cloth_drum, precision);
            ok(cd_membrane_set_ring(m, rings[r][0], rings[r][1]));
            const size_t last_u = (size_t)(NU + rings[r][0]) * PARTS, last_v = (size_t)(NV + rings[r][1]) * PARTS;
            double x[ALL];
            cloth_read(m, CD_POSITION, x);
            for (size_t i = 0; i <= last_u; ++i)
                for (size_t j = 0; j <= last_v; ++j) {
                    const double place[2] = {(double)i / PARTS, (double)j / PARTS};
                    double sampled[COMPONENTS];
                    ok(cd_membrane_sample(m, place, 1, CD_OUTSIDE_REFUSED, sampled, COMPONENTS));
                    const size_t u = i / PARTS, v = j / PARTS;
                    const double s = place[0] - (double)u, t = place[1] - (double)v;
                    for (size_t c = 0; c < COMPONENTS; ++c) {
                        double mean = 0;
                        for (size_t corner = 0; corner < 4; ++corner)
                            mean += (corner % 2 ? s : 1 - s) * (corner / 2 ? t : 1 - t) *
                                    x[at((u + corner % 2) % COLUMNS, (v + corner / 2) % ROWS, c)];
                        if (s == 0 && t == 0) assert_true(sampled[c] == x[at(u % COLUMNS, v % ROWS, c)]);
                        else assert_near(sampled[c], mean, 1e-15, 1);
                    }
                }
            const double several[6] = {0.5, 0.5, NU, NV, 2, 3.25};
            double together[3 * COMPONENTS], alone[COMPONENTS];
            ok(cd_membrane_sample(m, several, 3, CD_OUTSIDE_REFUSED, together, 3 * COMPONENTS));
            for (size_t k = 0; k < 3; ++k) {
                ok(cd_membrane_sample(m, several + 2 * k, 1, CD_OUTSIDE_REFUSED, alone, COMPONENTS));
                assert_same_bits(alone, together + k * COMPONENTS, COMPONENTS);
            }
            const double outside[6] = {0.5, -3, 1e300, -INFINITY, 2, 1e9};
            const double nearest[6] = {0.5, 0, NU + rings[r][0], 0, 2, NV + rings[r][1]};
            ok(cd_membrane_sample(m, nearest, 3, CD_OUTSIDE_REFUSED, together, 3 * COMPONENTS));
            for (size_t k = 0; k < 3; ++k) {
                ok(cd_membrane_sample(m, outside + 2 * k, 1, CD_OUTSIDE_NEAREST, alone, COMPONENTS));
                assert_same_bits(alone, together + k * COMPONENTS, COMPONENTS);
                refuses(m, cd_membrane_sample(m, outside + 2 * k, 1, CD_OUTSIDE_REFUSED, alone, COMPONENTS),
                        CD_ERROR_VALUE, "at");
            }
            cd_membrane_destroy(m);
        }
    }
    cd_membrane* one = cloth(0, 0, 1, CD_FLOAT32);
    const double x = 3.5, origin[2] = {0, 0};
    double sampled;
    cloth_write(one, CD_POSITION, &x);
    ok(cd_membrane_sample(one, origin, 1, CD_OUTSIDE_REFUSED, &sampled, 1));
    assert_true(sampled == 3.5);
    cd_membrane_destroy(one);
}

/* What the header's sums come to, node by node, in long double. */
struct sums {
    long double kinetic, stretch, bend, ties, fall, momentum[COMPONENTS];
};

static struct sums sums_of(const cd_membrane* m, const double* x, const double* v, const double* target) {
    struct sums s = {0};
    double g[COMPONENTS], b;
    int32_t ring[2];
    cd_mass_rule rule;
    ok(cd_membrane_get_gravity(m, g, COMPONENTS));
    ok(cd_membrane_get_bend(m, &b));
    ok(cd_membrane_get_ring(m, &ring[0], &ring[1]));
    ok(cd_membrane_get_mass_rule(m, &rule));
    const bool half[2] = {rule == CD_MASS_HALF_ENDS && !ring[0], rule == CD_MASS_HALF_ENDS && !ring[1]};
    const long double nu = NU + ring[0], nv = NV + ring[1];
    const long double bend_u = b * nu * nu * nu / (half[1] ? NV : ROWS);
    const long double bend_v = b * nv * nv * nv / (half[0] ? NU : COLUMNS);
    for (size_t j = 0; j < ALL; ++j) {
        const size_t c = j % COMPONENTS, u = j / COMPONENTS % COLUMNS, w = j / COMPONENTS / COLUMNS;
        const size_t right = (u + 1) % COLUMNS, left = (u + COLUMNS - 1) % COLUMNS;
        const size_t below = (w + 1) % ROWS, above = (w + ROWS - 1) % ROWS;
        if (!is_there(m, u, w)) continue;
        const long double mass = sheet_get(m, CD_MASS, u, w), half_u = half[0] && (u == 0 || u == NU) ? 0.5 : 1;
        const long double half_v = half[1] && (w == 0 || w == NV) ? 0.5 : 1;
        if (!is_held(m, u, w)) {
            s.kinetic += 0.5 * mass * v[j] * v[j];
            s.fall -= mass * g[c] * x[j];
            s.momentum[c] += mass * v[j];
        }
        const bool has_right = ring[0] || u < NU, has_below = ring[1] || w < NV;
        const long double across = (long double)x[at(right, w, c)] - x[j];
        const long double down = (long double)x[at(u, below, c)] - x[j];
        if (has_right && is_there(m, right, w)) s.stretch += 0.5 * sheet_get(m, CD_STIFFNESS_U, u, w) * across * across;
        if (has_below && is_there(m, u, below)) s.stretch += 0.5 * sheet_get(m, CD_STIFFNESS_V, u, w) * down * down;
        const long double curve_u = across - (x[j] - (long double)x[at(left, w, c)]);
        const long double curve_v = down - (x[j] - (long double)x[at(u, above, c)]);
        if (has_right && (ring[0] || u > 0) && is_there(m, right, w) && is_there(m, left, w))
            s.bend += 0.5 * bend_u * half_v * curve_u * curve_u;
        if (has_below && (ring[1] || w > 0) && is_there(m, u, below) && is_there(m, u, above))
            s.bend += 0.5 * bend_v * half_u * curve_v * curve_v;
        if (has_right && has_below && is_there(m, right, w) && is_there(m, u, below) && is_there(m, right, below)) {
            const long double twist = (long double)x[at(right, below, c)] - x[at(u, below, c)] - across;
            s.bend += 0.5 * 2 * sqrtl(bend_u * bend_v) * twist * twist;
        }
        double k, damping;
        ok(cd_membrane_get_attachment(m, u, w, &k, &damping));
        s.ties += 0.5 * k * ((long double)x[j] - target[j]) * ((long double)x[j] - target[j]);
    }
    return s;
}

static void energy_and_momentum_are_the_sums_of_the_header(void** state) {
    (void)state;
    cloth_build* const builds[] = {cloth_everything, cloth_everything_tube};
    for (size_t b = 0; b < COUNT(builds); ++b) {
        for (cd_precision precision = CD_FLOAT32; precision <= CD_FLOAT64; ++precision) {
            cd_membrane* m = built(builds[b], precision);
            ok(cd_membrane_step(m, 0.01, 5));
            double x[ALL], v[ALL], target[ALL], told[3], momentum[COMPONENTS], alone = -1;
            cloth_read(m, CD_POSITION, x);
            cloth_read(m, CD_VELOCITY, v);
            cloth_read(m, CD_TARGET, target);
            const struct sums s = sums_of(m, x, v, target);
            ok(cd_membrane_get_energy(m, &told[0], &told[1], &told[2]));
            ok(cd_membrane_get_momentum(m, momentum, COMPONENTS));
            assert_true(s.kinetic > 0 && s.stretch > 0 && s.bend > 0 && s.ties > 0 && s.fall != 0);
            assert_near(told[0], (double)s.kinetic, 1e-14, 0);
            assert_near(told[1], (double)(s.stretch + s.bend + s.ties), 1e-13, 0);
            assert_near(told[2], (double)s.fall, 1e-13, 1);
            for (size_t c = 0; c < COMPONENTS; ++c) assert_near(momentum[c], (double)s.momentum[c], 1e-13, 1);
            ok(cd_membrane_get_energy(m, NULL, &alone, NULL));
            assert_true(alone == told[1]);
            cd_membrane_destroy(m);
        }
    }
}

/* A sheet stretched evenly along one direction holds k d^2 / 2, under both rules. */
static void an_even_stretch_holds_the_energy_of_the_totals(void** state) {
    (void)state;
    for (cd_mass_rule rule = CD_MASS_EQUAL; rule <= CD_MASS_HALF_ENDS; ++rule) {
        cd_membrane* m = cloth(NU, NV, 2, CD_FLOAT64);
        double x[COLUMNS * ROWS * 2], elastic;
        ok(cd_membrane_set_mass_rule(m, rule));
        ok(cd_membrane_set_stiffness(m, 3, 5));
        for (size_t i = 0; i < COUNT(x); i += 2) {
            x[i] = 2.0 * (double)(i / 2 % COLUMNS) / NU;
            x[i + 1] = 4.0 * (double)(i / 2 / COLUMNS) / NV;
        }
        cloth_write(m, CD_POSITION, x);
        ok(cd_membrane_get_energy(m, NULL, &elastic, NULL));
        assert_near(elastic, 3 * 2 * 2 / 2.0 + 5 * 4 * 4 / 2.0, 1e-14, 0);
        cd_membrane_destroy(m);
    }
}

/* Beyond the edges there is neither spring, bend nor twist: a sheet too large for squares has infinite energy. */
static void energies_too_large_for_numbers_are_infinite(void** state) {
    (void)state;
    cd_membrane* m = cloth(NU, NV, 1, CD_FLOAT64);
    double x[COLUMNS * ROWS], targets[COLUMNS * ROWS] = {0}, elastic;
    for (size_t i = 0; i < COUNT(x); ++i) x[i] = 1e300 * (double)(i * i % 7);
    cloth_write(m, CD_POSITION, x);
    ok(cd_membrane_set_bend(m, 1));
    ok(cd_membrane_enable_field(m, CD_TARGET));
    cloth_write(m, CD_TARGET, targets);
    ok(cd_membrane_get_energy(m, NULL, &elastic, NULL));
    assert_true(elastic == HUGE_VAL);
    ok(cd_membrane_set_bend(m, 0));
    ok(cd_membrane_set_stiffness(m, 0, 0));
    ok(cd_membrane_get_energy(m, NULL, &elastic, NULL));
    assert_true(elastic == 0);
    cd_membrane_destroy(m);
}

/* Six times the volume between the origin and the triangle of three corners of a cell. */
static double wedge(const double (*x)[3], int a, int b, int c) {
    return x[a][0] * (x[b][1] * x[c][2] - x[b][2] * x[c][1]) + x[a][1] * (x[b][2] * x[c][0] - x[b][0] * x[c][2]) +
           x[a][2] * (x[b][0] * x[c][1] - x[b][1] * x[c][0]);
}

static void the_volume_of_a_bent_cell_is_the_mean_of_its_two_triangulations(void** state) {
    (void)state;
    const double x[4][3] = {{1, 2, 3}, {2.5, 2, 4}, {1.5, 3, 7}, {3, 4, -2}}; /* (0, 0), (1, 0), (0, 1), (1, 1) */
    const double one_way = wedge(x, 0, 1, 3) + wedge(x, 0, 3, 2), other_way = wedge(x, 0, 1, 2) + wedge(x, 1, 3, 2);
    cd_membrane* m = cloth(1, 1, 3, CD_FLOAT64);
    double volume;
    cloth_write(m, CD_POSITION, x[0]);
    ok(cd_membrane_get_volume(m, &volume));
    assert_true(fabs(one_way - other_way) > 1);
    assert_near(volume, (one_way + other_way) / 12, 1e-14, 1);
    cd_membrane_destroy(m);
}

/* Whose parts are infinities of both signs. */
static void volumes_too_large_for_numbers_are_infinite(void** state) {
    (void)state;
    static const struct {
        double size, height; /* of the roof, at an angle of an eighth turn, and of its prism */
        double volume;
    } roofs[] = {{1e100, 1e100, 0.75e300 / 3}, {1e155, 1e-20, 0.75e290 / 3}, {1e155, 1, INFINITY},
                 {1e155, -1, -INFINITY},       {1e300, 1e300, INFINITY},     {1e300, -1e300, -INFINITY}};
    cd_membrane* m = cloth(NU, NV, COMPONENTS, CD_FLOAT64);
    for (size_t r = 0; r < COUNT(roofs); ++r) {
        double x[ALL], volume;
        for (size_t i = 0; i < COLUMNS * ROWS; ++i) {
            const double u = (double)(i % COLUMNS) / NU, v = (double)(i / COLUMNS) / NV;
            x[3 * i] = roofs[r].size * (u - v) * 0.5;
            x[3 * i + 1] = roofs[r].size * (u + v);
            x[3 * i + 2] = roofs[r].height * 0.75;
        }
        cloth_write(m, CD_POSITION, x);
        ok(cd_membrane_get_volume(m, &volume));
        if (isinf(roofs[r].volume)) assert_true(volume == roofs[r].volume);
        else assert_near(volume, roofs[r].volume, 1e-13, 0);
    }
    cd_membrane_destroy(m);
}

static void volumes_are_those_of_the_shapes(void** state) {
    (void)state;
    double x[ALL], volume;
    for (cd_precision precision = CD_FLOAT32; precision <= CD_FLOAT64; ++precision) {
        const double rounding = precision == CD_FLOAT64 ? 1e-14 : 1e-6;
        cd_membrane* m = cloth(NU, NV, COMPONENTS, precision);
        for (size_t i = 0; i < COLUMNS * ROWS; ++i) { /* a flat roof over the unit square: a third of its prism */
            x[3 * i] = (double)(i % COLUMNS) / NU;
            x[3 * i + 1] = (double)(i / COLUMNS) / NV;
            x[3 * i + 2] = 0.75;
        }
        cloth_write(m, CD_POSITION, x);
        ok(cd_membrane_get_volume(m, &volume));
        assert_near(volume, 0.75 / 3, rounding, 0);
        ok(cd_membrane_enable_field(m, CD_MASK));
        sheet_set(m, CD_MASK, 2, 2, 0); /* four cells gone */
        ok(cd_membrane_get_volume(m, &volume));
        assert_near(volume, 0.25 * (1 - 4.0 / (NU * NV)), rounding, 0);
        for (size_t i = 2; i < ALL; i += 3) x[i] = 0; /* in a plane through the origin */
        cloth_write(m, CD_POSITION, x);
        ok(cd_membrane_get_volume(m, &volume));
        assert_true(volume == 0);
        cd_membrane_destroy(m);

        cd_membrane* torus = cloth(63, 31, COMPONENTS, precision); /* 2 pi^2 R r^2 */
        static double t[64 * 32 * 3];
        for (size_t i = 0; i < 64 * 32; ++i) {
            const double a = 2 * (double)PI * (double)(i % 64) / 64, b = 2 * (double)PI * (double)(i / 64) / 32;
            t[3 * i] = (3 + cos(b)) * cos(a) + 10; /* wherever it lies */
            t[3 * i + 1] = (3 + cos(b)) * sin(a) - 4;
            t[3 * i + 2] = sin(b) + 1;
        }
        cloth_write(torus, CD_POSITION, t);
        ok(cd_membrane_set_ring(torus, 1, 1));
        ok(cd_membrane_get_volume(torus, &volume));
        const double exact = 2 * (double)(PI * PI) * 3;
        assert_true(volume > 0.98 * exact && volume < exact);
        for (size_t i = 0; i < COUNT(t); ++i) t[i] = t[i] + 1;
        cloth_write(torus, CD_POSITION, t);
        double moved;
        ok(cd_membrane_get_volume(torus, &moved));
        assert_near(moved, volume, 10 * rounding, exact);
        cd_membrane_destroy(torus);
    }
}

static void forces_act_until_they_are_overwritten(void** state) {
    (void)state;
    cd_membrane* m = cloth(0, 0, 2, CD_FLOAT64);
    const double force[2] = {3, -1}, none[2] = {0, 0};
    double v[2];
    ok(cd_membrane_set_mass(m, 0.5));
    ok(cd_membrane_enable_field(m, CD_FORCE));
    cloth_write(m, CD_FORCE, force);
    ok(cd_membrane_step(m, 0.125, 8));
    cloth_read(m, CD_VELOCITY, v);
    assert_true(v[0] == 6 && v[1] == -2);
    cloth_write(m, CD_FORCE, none);
    ok(cd_membrane_step(m, 0.125, 8));
    cloth_read(m, CD_VELOCITY, v);
    assert_true(v[0] == 6 && v[1] == -2);
    cd_membrane_destroy(m);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(an_impulse_is_spread_by_the_weights_of_the_header),
        cmocka_unit_test(a_round_impulse_on_a_free_sheet_is_all_taken_and_does_not_reach_round_a_ring),
        cmocka_unit_test(a_tied_node_moves_as_the_equation_says),
        cmocka_unit_test(ties_are_told_and_loosened),
        cmocka_unit_test(samples_are_bilinear_between_nodes),
        cmocka_unit_test(energy_and_momentum_are_the_sums_of_the_header),
        cmocka_unit_test(an_even_stretch_holds_the_energy_of_the_totals),
        cmocka_unit_test(energies_too_large_for_numbers_are_infinite),
        cmocka_unit_test(the_volume_of_a_bent_cell_is_the_mean_of_its_two_triangulations),
        cmocka_unit_test(volumes_too_large_for_numbers_are_infinite),
        cmocka_unit_test(volumes_are_those_of_the_shapes),
        cmocka_unit_test(forces_act_until_they_are_overwritten),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
