/* Cloth in air, moved by its edges and as a whole, and the order of its steps in time. */
#include <math.h>

#include "check.h"
#include "cloth.h"
#include "reference.h"
#include "sheet.h"

enum { MOST = 400 }; /* nodes */

/* A flat sheet of 0.2 kg and length_u x length_v that lies in x and y; half edges: as much mass per area everywhere. */
static cd_membrane* flat(size_t nu, size_t nv, double length_u, double length_v) {
    cd_membrane* m = cloth(nu, nv, 3, CD_FLOAT64);
    ok(cd_membrane_set_rest_length(m, length_u, length_v));
    ok(cd_membrane_set_mass_rule(m, CD_MASS_HALF_ENDS));
    ok(cd_membrane_set_mass(m, 0.2));
    ok(cd_membrane_set_stiffness(m, 2000, 2000));
    for (size_t v = 0; v <= nv; ++v)
        for (size_t u = 0; u <= nu; ++u) {
            const double x[3] = {length_u * (double)u / (double)nu, length_v * (double)v / (double)nv, 0};
            ok(cd_membrane_write_f64(m, CD_POSITION, u, v, 1, 1, x, 3));
        }
    return m;
}
static size_t numbers_of(const cd_membrane* m) { return cloth_extent(m, CD_POSITION).count; }

/* ---- air --------------------------------------------------------------------------------------------------------- */

/* All of a sheet's nodes fall alike, broadside and edgewise: v1 = v + dt (g - a v) / (1 + lambda dt a), with a the
 * resistance over mass per area. In the end g / a. Edgewise is not stable: rounding grows, in long steps to 1e-4 of the
 * speed. */
static void a_flat_sheet_falls_as_the_air_lets_it(void** state) {
    (void)state;
    static const double lambdas[] = {1, 0.75}, steps[] = {1e-3, 1 / 60.0, 1};
    const double along = 0.03, across = 1.7, density = 0.2 / (1.2 * 0.8), g = 9.81;
    double worst = 0, last = 0;
    for (size_t l = 0; l < COUNT(lambdas); ++l)
        for (size_t s = 0; s < COUNT(steps); ++s)
            for (int way = 0; way < 3; ++way) {
                const double dt = steps[s], h = lambdas[l] * dt, a = (way == 2 ? across : along) / density;
                double v = 0, gravity[3] = {0, 0, 0}, found[3 * MOST];
                gravity[way] = -g;
                cd_membrane* m = flat(6, 5, 1.2, 0.8);
                ok(cd_membrane_set_lambda(m, lambdas[l]));
                ok(cd_membrane_set_air(m, along, across));
                ok(cd_membrane_set_gravity(m, gravity, 3));
                ok(cd_membrane_set_effort(m, 20, 500));
                for (int n = 0; n < 200; ++n) {
                    ok(cd_membrane_step(m, dt, 1));
                    v += (-g - a * v) * dt / (1 + h * a);
                    if (n != 19 && n != 199) continue;
                    double off = 0;
                    cloth_read(m, CD_VELOCITY, found);
                    for (size_t i = 0; i < numbers_of(m); ++i)
                        off = fmax(off, fabs(found[i] - (i % 3 == (size_t)way ? v : 0)) / fabs(v));
                    if (n == 19 && (way == 2 || s < 2)) worst = fmax(worst, off);
                    else last = fmax(last, off);
                }
                if (s == 2) assert_near(v, -g / a, 1e-6, 0);
                cd_membrane_destroy(m);
            }
    print_message("flat sheets that fall through air: speeds to %.1e, after 200 steps to %.1e\n", worst, last);
    assert_true(worst < 1e-9);
    assert_true(last < 1e-3);
}

static void wind_carries_a_free_sheet_along(void** state) {
    (void)state;
    const double wind[3] = {3, -1, 2};
    for (int each = 0; each < 2; ++each) {
        double v[3 * MOST], off = 0;
        cd_membrane* m = flat(8, 8, 1, 1);
        ok(cd_membrane_set_air(m, 0.5, 2));
        if (each) {
            for (size_t i = 0; i < numbers_of(m); ++i) v[i] = wind[i % 3];
            ok(cd_membrane_enable_field(m, CD_WIND));
            cloth_write(m, CD_WIND, v);
        } else ok(cd_membrane_set_wind(m, wind, 3));
        cloth_shake(m, 0.02, 5);
        ok(cd_membrane_step(m, 1 / 60.0, 1200));
        cloth_read(m, CD_VELOCITY, v);
        for (size_t i = 0; i < numbers_of(m); ++i) off = fmax(off, fabs(v[i] - wind[i % 3]));
        print_message("in the wind for 20 s: to %.1e m/s\n", off);
        assert_true(off < 1e-3);
        cd_membrane_destroy(m);
    }
}

/* Crumpled sheets in air that stands, few iterations or many: no step adds to their energy. */
static void air_only_takes_energy(void** state) {
    (void)state;
    static const double steps[] = {1e-3, 1 / 60.0, 0.1, 1, 10}, lambdas[] = {1, 0.7, 0.5};
    double most = 0;
    for (uint64_t scene = 0; scene < 60; ++scene) {
        uint64_t seed = 77 + scene;
        cd_membrane* m = flat(9, 7, 0.9, 0.7);
        ok(cd_membrane_set_shear(m, 100));
        if (scene % 2) ok(cd_membrane_set_bend(m, 1e-3));
        ok(cd_membrane_set_air(m, scene % 3 ? 0.1 : 0, scene % 3 ? 3 : 1e4));
        ok(cd_membrane_set_lambda(m, lambdas[scene % 3]));
        if (scene % 4 == 1) ok(cd_membrane_set_effort(m, 1, 1));
        if (scene % 4 == 3) ok(cd_membrane_set_effort(m, 10, 100));
        double x[3 * MOST], v[3 * MOST];
        cloth_read(m, CD_POSITION, x);
        for (size_t i = 0; i < numbers_of(m); ++i) {
            if (scene < 30) x[i] *= 0.2;
            x[i] += 0.05 * random_number(&seed), v[i] = 5 * random_number(&seed);
        }
        cloth_write(m, CD_POSITION, x);
        cloth_write(m, CD_VELOCITY, v);
        double before = sheet_energy(m);
        const double size = before;
        for (int n = 0; n < 40; ++n) {
            ok(cd_membrane_step(m, steps[scene % 5], 1));
            const double now = sheet_energy(m);
            most = fmax(most, (now - before) / size);
            before = now;
        }
        cd_membrane_destroy(m);
    }
    print_message("60 crumpled sheets in air: a step adds at most %.1e of the energy\n", most);
    assert_true(most < 1e-12);
}

/* ---- what is posed, and moved as a whole ------------------------------------------------------------------------- */

static void posed_nodes_are_where_they_should_be(void** state) {
    (void)state;
    double x[3 * MOST];
    for (int single = 0; single < 2; ++single) {
        cd_membrane* m = flat(10, 8, 1, 0.8);
        ok(cd_membrane_set_gravity(m, (double[3]){0, -9.81, 1}, 3));
        ok(cd_membrane_set_shear(m, 100));
        if (single) {
            ok(cd_membrane_enable_field(m, CD_PIN));
            ok(cd_membrane_enable_field(m, CD_TARGET));
            for (size_t u = 2; u < 6; ++u) sheet_set(m, CD_PIN, u, 3, CD_NODE_POSED);
        } else ok(cd_membrane_set_edge(m, CD_EDGE_V_LAST, CD_NODE_POSED));
        const size_t first = single ? 2 : 0, count = single ? 4 : 11, row = single ? 3 : 8;
        for (int n = 1; n <= 60; ++n) {
            double to[3 * 11];
            for (size_t i = 0; i < count; ++i) {
                const double turned = 0.02 * n, way = 0.1 * (double)(first + i);
                to[3 * i] = way * cos(turned) + 0.05 * n, to[3 * i + 1] = 0.1 * (double)row + 0.3 * sin(0.3 * n);
                to[3 * i + 2] = way * sin(turned);
            }
            ok(cd_membrane_write_f64(m, CD_TARGET, first, row, count, 1, to, 3 * count));
            ok(cd_membrane_step(m, 1 / 240.0, (size_t)(1 + n % 4)));
            ok(cd_membrane_read_f64(m, CD_POSITION, first, row, count, 1, x, 3 * count));
            for (size_t i = 0; i < 3 * count; ++i) assert_near(x[i], to[i], 1e-14, 1);
        }
        ok(cd_membrane_read_f64(m, CD_POSITION, 5, 0, 1, 1, x, 3)); /* the rest came along */
        assert_true(x[0] > 2.2);
        cd_membrane_destroy(m);
    }
}

/* After a reset a sheet moves as a new one does: nothing is left of where its steps went. */
static void a_reset_leaves_nothing_of_what_was(void** state) {
    (void)state;
    const double g[3] = {1, -9, 2};
    uint64_t hash[2];
    for (int k = 0; k < 2; ++k) {
        double x[3 * MOST];
        cd_membrane* m = flat(9, 7, 0.9, 0.7);
        ok(cd_membrane_set_gravity(m, g, 3));
        ok(cd_membrane_set_edge(m, CD_EDGE_V_FIRST, CD_NODE_PINNED));
        cloth_read(m, CD_POSITION, x);
        if (k == 0) ok(cd_membrane_step(m, 1 / 60.0, 5));
        ok(cd_membrane_reset(m));
        cloth_write(m, CD_POSITION, x);
        ok(cd_membrane_step(m, 1 / 60.0, 3));
        ok(cd_membrane_hash(m, &hash[k]));
        cd_membrane_destroy(m);
    }
    assert_true(hash[0] == hash[1]);
}

/* With forces that turn with it, a sheet moves on as it would have, but turned and shifted. */
static void a_teleport_changes_nothing_but_the_place(void** state) {
    (void)state;
    const double turn[9] = {0.36, 0.48, -0.8, -0.8, 0.6, 0, 0.48, 0.64, 0.6}, shift[3] = {5, -3, 2}, g[3] = {1, -9, 2};
    for (int held = 0; held < 2; ++held) {
        cd_membrane* pair[2];
        double x[2][3 * MOST], v[2][3 * MOST], g1[3] = {0, 0, 0}, worst = 0;
        for (int k = 0; k < 2; ++k) {
            cd_membrane* m = pair[k] = flat(9, 7, 0.9, 0.7);
            ok(cd_membrane_set_shear(m, 60));
            ok(cd_membrane_set_bend(m, 1e-3));
            ok(cd_membrane_set_air(m, 0.1, 1));
            ok(cd_membrane_set_gravity(m, g, 3));
            if (held) ok(cd_membrane_set_edge(m, CD_EDGE_V_FIRST, CD_NODE_PINNED));
            cloth_shake(m, 0.005, 9);
            ok(cd_membrane_set_effort(m, 20, 300));
            ok(cd_membrane_step(m, 1 / 60.0, 20));
        }
        ok(cd_membrane_teleport(pair[1], turn, shift, 3));
        for (int i = 0; i < 9; ++i) g1[i / 3] += turn[i] * g[i % 3];
        ok(cd_membrane_set_gravity(pair[1], g1, 3));
        for (int k = 0; k < 2; ++k) {
            ok(cd_membrane_step(pair[k], 1 / 60.0, 10));
            if (k == 0) ok(cd_membrane_teleport(pair[k], turn, shift, 3));
            cloth_read(pair[k], CD_POSITION, x[k]);
            cloth_read(pair[k], CD_VELOCITY, v[k]);
        }
        for (size_t i = 0; i < numbers_of(pair[0]); ++i)
            worst = fmax(worst, fmax(fabs(x[0][i] - x[1][i]), fabs(v[0][i] - v[1][i])));
        print_message("teleported, %s: moves on to %.1e\n", held ? "held" : "free", worst);
        assert_true(worst < 1e-9);
        for (int k = 0; k < 2; ++k) cd_membrane_destroy(pair[k]);
    }
}

/* ---- order in time ----------------------------------------------------------------------------------------------- */

/* A sheet held at its four edges and drawn out by 3%, so that no spring is ever slack, swings across itself for 0.2 s:
 * where its nodes are. */
enum { SWING = 6 };
static void swing(double lambda, int steps, double* x) {
    cd_membrane* m = flat(SWING, SWING, 1, 1);
    ok(cd_membrane_set_mass(m, 0.5));
    ok(cd_membrane_set_stiffness(m, 200, 200));
    ok(cd_membrane_set_compression(m, 0));
    ok(cd_membrane_set_lambda(m, lambda));
    ok(cd_membrane_set_effort(m, 8, 60));
    for (cd_edge edge = CD_EDGE_U_FIRST; edge <= CD_EDGE_V_LAST; ++edge)
        ok(cd_membrane_set_edge(m, edge, CD_NODE_PINNED));
    for (size_t v = 0; v <= SWING; ++v)
        for (size_t u = 0; u <= SWING; ++u) {
            const double s = (double)u / SWING, t = (double)v / SWING, pi = acos(-1);
            const double at[3] = {1.03 * s, 1.03 * t, 0.05 * sin(pi * s) * sin(pi * t)};
            ok(cd_membrane_write_f64(m, CD_POSITION, u, v, 1, 1, at, 3));
        }
    ok(cd_membrane_step(m, 0.2 / steps, (size_t)steps));
    cloth_read(m, CD_POSITION, x);
    cd_membrane_destroy(m);
}

/* A step takes the springs' pull where it ends, at any lambda: with w = omega dt a swing's amplitude falls by
 * 1 / sqrt(1 + lambda w^2) in each. Halving dt halves what is missed, and lambda = 1/2 misses half of what 1 does. */
static void a_taut_sheet_swings_to_first_order(void** state) {
    (void)state;
    static double x[2][3 * MOST];
    double off[2][4] = {{0}};
    for (int whole = 0; whole < 2; ++whole) {
        swing(whole ? 1 : 0.5, 100, x[0]);
        for (int r = 0; r < 4; ++r) {
            double *const now = x[(r + 1) % 2], *const before = x[r % 2];
            swing(whole ? 1 : 0.5, 200 << r, now);
            for (size_t i = 0; i < (size_t)3 * (SWING + 1) * (SWING + 1); ++i)
                off[whole][r] = fmax(off[whole][r], fabs(now[i] - before[i]));
        }
        const double* const e = off[whole];
        print_message("swing, lambda %g, from 100 to 200, 400, 800, 1600 steps: %.2e, %.2e, %.2e, %.2e m\n",
                      whole ? 1 : 0.5, e[0], e[1], e[2], e[3]);
        for (int r = 0; r < 3; ++r) assert_true(e[r + 1] > 0.45 * e[r] && e[r + 1] < 0.6 * e[r]);
    }
    assert_near(off[0][3], 0.5 * off[1][3], 0.1, 0);
}

/* A stiff free sheet that drifts with the air, its nodes' velocities at random, with few iterations: as seen from the air
 * its energy never rises, and beside a collider that it does not touch, or in next to no air, it keeps its momentum. */
static void who_drifts_along_sees_the_same(void** state) {
    (void)state;
    static const double stiffnesses[] = {100, 3000, 1e5};
    for (int n = 0; n < 9; ++n) {
        const double drift = 10, wind[3] = {drift, 0, 0}, below[3] = {0, 0, -1e5}, up[3] = {0, 0, 1};
        double v[3 * 256], before = INFINITY, energy, first[3], last[3];
        uint64_t seed = (uint64_t)n;
        cd_membrane* m = flat(15, 15, 1, 1);
        ok(cd_membrane_set_stiffness(m, stiffnesses[n % 3], stiffnesses[n % 3]));
        ok(cd_membrane_set_compression(m, 0));
        ok(cd_membrane_set_mass_rule(m, CD_MASS_EQUAL));
        ok(cd_membrane_set_gravity(m, (double[3]){0, 0, 0}, 3));
        assert_int_equal(numbers_of(m), 3 * 256);
        for (size_t i = 0; i < 3 * 256; ++i) v[i] = (i % 3 == 0 ? drift : 0) + random_number(&seed);
        cloth_write(m, CD_VELOCITY, v);
        ok(cd_membrane_set_wind(m, wind, 3));
        if (n / 3 == 0) ok(cd_membrane_set_air(m, 0.02, 1.2));
        if (n / 3 == 1) ok(cd_membrane_set_air(m, 0, 1e-14));
        if (n / 3 == 2) {
            ok(cd_membrane_set_colliders(m, 2));
            ok(cd_membrane_set_plane(m, 0, below, up, 3, 0.3));
        }
        ok(cd_membrane_get_momentum(m, first, 3));
        for (int frame = 0; frame < 60; ++frame) {
            ok(cd_membrane_step(m, 1 / 60.0, 1));
            ok(cd_membrane_get_energy(m, NULL, &energy, NULL));
            cloth_read(m, CD_VELOCITY, v);
            for (size_t i = 0; i < 3 * 256; ++i) energy += 0.5 * 0.2 / 256 * pow(v[i] - (i % 3 == 0 ? drift : 0), 2);
            assert_true(energy < before * (1 + 1e-9));
            before = energy;
        }
        ok(cd_membrane_get_momentum(m, last, 3));
        for (int k = 0; k < 3 && n / 3 > 0; ++k) assert_near(last[k], first[k], 1e-10, 1);
        cd_membrane_destroy(m);
    }
}

/* What is told is what the step left: nothing, of a node alone. */
static void what_is_left_is_told(void** state) {
    (void)state;
    size_t iterations;
    double left;
    cd_membrane* m = flat(1, 1, 1, 1);
    ok(cd_membrane_set_stiffness(m, 0, 0));
    ok(cd_membrane_set_effort(m, 1, 20));
    ok(cd_membrane_set_gravity(m, (double[3]){0, 0, -9.81}, 3));
    ok(cd_membrane_step(m, 1 / 60.0, 1));
    ok(cd_membrane_get_convergence(m, &iterations, &left));
    assert_true(left < 1e-12);
    cd_membrane_destroy(m);
}

/* With effort enough a step of a small sheet in wind leaves nothing, in whatever shape it is. */
static void what_is_asked_for_is_found(void** state) {
    (void)state;
    double worst = 0;
    for (uint64_t seed = 1; seed <= 40; ++seed) {
        cd_membrane* m = flat(1, 1, 1, 1.3);
        cloth_shake(m, 0.02, seed);
        ok(cd_membrane_set_mass(m, 0.2));
        ok(cd_membrane_set_stiffness(m, 800, 500));
        ok(cd_membrane_set_shear(m, 20));
        ok(cd_membrane_set_gravity(m, (double[3]){0, 0, -9.81}, 3));
        ok(cd_membrane_set_air(m, 0.05, 1));
        ok(cd_membrane_set_wind(m, (double[3]){1, 2, 3}, 3));
        ok(cd_membrane_set_effort(m, 100, 100));
        for (int step = 0; step < 30; ++step) {
            double left;
            ok(cd_membrane_step(m, 1 / 60.0, 1));
            ok(cd_membrane_get_convergence(m, NULL, &left));
            worst = fmax(worst, left);
        }
        cd_membrane_destroy(m);
    }
    print_message("left of the gradient: %.1e at most\n", worst);
    assert_true(worst < 1e-11); /* 2e-4 if a search among slopes of rounding went nowhere */
}

/* However much keeps a flat sheet from crumpling, what it moves by is the noise that it begins with. */
static void what_does_not_crumple_lies_still(void** state) {
    (void)state;
    for (int way = 0; way < 8; ++way) {
        const double dt = way % 2 ? 1 : 1 / 60.0, rate = pow(10, 4 + way / 2 * 4) / (dt * dt), noise = 1e-12;
        double x[3 * MOST], most = 0;
        cd_membrane* m = flat(15, 15, 8, 8);
        uint64_t random = 1;
        cloth_read(m, CD_POSITION, x);
        for (size_t i = 0; i < numbers_of(m); ++i) x[i] += noise * random_number(&random);
        cloth_write(m, CD_POSITION, x);
        ok(cd_membrane_set_compression(m, rate));
        for (int n = 0; n < 60; ++n) {
            ok(cd_membrane_step(m, dt, 1));
            cloth_read(m, CD_VELOCITY, x);
            for (size_t i = 0; i < numbers_of(m); ++i) most = fmax(most, fabs(x[i]) * dt);
        }
        print_message("compression %g, dt %.4f: moves by %.1e m a step\n", rate, dt, most);
        assert_true(most < 1e-9);
        cd_membrane_destroy(m);
    }
}

/* A crumpled tube moves alike whether it goes round along u or along v: what lies beyond the ends of its rows is what
 * lies round the ring, in velocities too. */
static void a_tube_moves_alike_along_u_and_v(void** state) {
    (void)state;
    enum { ROUND = 16, ALONG = 11, COUNT_OF = 3 * ROUND * (ALONG + 1) };
    double x[2][COUNT_OF], moved = 0, apart = 0;
    for (int turned = 0; turned < 2; ++turned) {
        const size_t columns = turned ? ALONG + 1 : ROUND, rows = turned ? ROUND : ALONG + 1;
        double start[COUNT_OF];
        cd_membrane* m;
        ok(cd_membrane_create(turned ? ALONG : ROUND, turned ? ROUND : ALONG, 3, CD_FLOAT64, NULL, &m));
        ok(cd_membrane_set_ring(m, !turned, turned));
        ok(cd_membrane_set_rest_length(m, turned ? 1 : 6.28, turned ? 6.28 : 1));
        ok(cd_membrane_set_stiffness(m, 1000, 1000));
        ok(cd_membrane_set_compression(m, 1e4));
        for (size_t v = 0; v < rows; ++v)
            for (size_t u = 0; u < columns; ++u) {
                const size_t i = turned ? v : u, j = turned ? u : v;
                const double angle = 2 * 3.14159265358979324 * (double)i / ROUND;
                const double at[3] = {cos(angle), sin(angle), (double)j / ALONG};
                for (size_t k = 0; k < 3; ++k)
                    start[3 * (v * columns + u) + k] = at[k] + 0.02 * sin(13 * (double)(j * ROUND + i) + 7 * (double)k);
            }
        ok(cd_membrane_write_f64(m, CD_POSITION, 0, 0, columns, rows, start, COUNT_OF));
        ok(cd_membrane_step(m, 1 / 60.0, 10));
        ok(cd_membrane_read_f64(m, CD_POSITION, 0, 0, columns, rows, x[turned], COUNT_OF));
        for (size_t n = 0; n < COUNT_OF; ++n) moved = fmax(moved, fabs(x[turned][n] - start[n]));
        cd_membrane_destroy(m);
    }
    for (size_t j = 0; j <= ALONG; ++j)
        for (size_t i = 0; i < ROUND; ++i)
            for (size_t k = 0; k < 3; ++k)
                apart = fmax(apart, fabs(x[0][3 * (j * ROUND + i) + k] - x[1][3 * (i * (ALONG + 1) + j) + k]));
    print_message("a tube along u and along v: %.1e m apart, %.1e m moved\n", apart, moved);
    assert_true(moved > 1e-3 && apart < 1e-9 * moved);
}

/* Of a stiff sheet that is torn into a strip that hangs, one that falls and one that meets a bar, the second falls as a
 * whole as a free sheet does, however few iterations a step takes. */
static void what_is_torn_off_falls_as_it_should(void** state) {
    (void)state;
    enum { LONG = 12, SHORT = 7, STRIP = LONG / 3, NODES = STRIP * SHORT, STEPS = 20 };
    static const double down[3] = {0, 0, -9.81}, dt = 1 / 60.0;
    for (int along_v = 0; along_v < 2; ++along_v) {
        const cd_field field = along_v ? CD_STIFFNESS_V : CD_STIFFNESS_U;
        cd_membrane* m =
            along_v ? cloth(SHORT - 1, LONG - 1, 3, CD_FLOAT64) : cloth(LONG - 1, SHORT - 1, 3, CD_FLOAT64);
        double bar[2][3] = {{0, 0, -0.1}, {0, 0, -0.1}}, v[2][3] = {{0}}, one[3], lowest = 0;
        bar[0][along_v] = bar[1][along_v] = 0.1 * (LONG - 2), bar[1][!along_v] = 0.1 * SHORT;
        ok(cd_membrane_set_rest_length(m, 0.1 * (along_v ? SHORT - 1 : LONG - 1),
                                       0.1 * (along_v ? LONG - 1 : SHORT - 1)));
        ok(cd_membrane_set_stiffness(m, 1e6, 1e6));
        ok(cd_membrane_set_effort(m, 1, 1));
        ok(cd_membrane_set_gravity(m, down, 3));
        ok(cd_membrane_set_edge(m, along_v ? CD_EDGE_V_FIRST : CD_EDGE_U_FIRST, CD_NODE_PINNED));
        ok(cd_membrane_set_colliders(m, 1));
        ok(cd_membrane_set_capsule(m, 0, bar[0], bar[1], 3, 0.08, 0.3));
        ok(cd_membrane_enable_field(m, field));
        for (size_t i = 0; i < SHORT; ++i)
            for (size_t cut = STRIP - 1; cut < LONG - 1; cut += STRIP)
                sheet_set(m, field, along_v ? i : cut, along_v ? cut : i, 0);
        cloth_lay_out(m, 0.1);
        cloth_shake(m, 0.01, 3);
        for (int after = 0; after < 2; ++after) {
            if (after) ok(cd_membrane_step(m, dt, STEPS));
            for (size_t i = 0; i < NODES; ++i) {
                const size_t across = i % SHORT, along = STRIP + i / SHORT;
                ok(cd_membrane_read_f64(m, CD_VELOCITY, along_v ? across : along, along_v ? along : across, 1, 1, one,
                                        3));
                for (int k = 0; k < 3; ++k) v[after][k] += one[k] / NODES;
            }
        }
        for (int k = 0; k < 3; ++k) assert_near(v[1][k], v[0][k] + STEPS * dt * down[k], 1e-12, 1);
        for (size_t i = 0; i < SHORT; ++i) { /* the bar bears the last strip */
            ok(cd_membrane_read_f64(m, CD_POSITION, along_v ? i : LONG - 2, along_v ? LONG - 2 : i, 1, 1, one, 3));
            lowest = fmin(lowest, one[2]);
        }
        assert_true(lowest > -0.1);
        cd_membrane_destroy(m);
    }
}

/* How much of the spin of a square sheet is left after half a second. */
static double spin_left(double rate, double dt, double lambda) {
    cd_membrane* m = flat(16, 16, 1, 1);
    double x[3 * MOST], v[3 * MOST], spin[2] = {0, 0};
    ok(cd_membrane_set_compression(m, rate));
    ok(cd_membrane_set_lambda(m, lambda));
    cloth_read(m, CD_POSITION, x);
    for (size_t i = 0; i < numbers_of(m); i += 3) v[i] = 0.5 - x[i + 1], v[i + 1] = x[i] - 0.5, v[i + 2] = 0;
    cloth_write(m, CD_VELOCITY, v);
    for (int after = 0; after < 2; ++after) {
        if (after) ok(cd_membrane_step(m, dt, (size_t)lround(0.5 / dt)));
        cloth_read(m, CD_POSITION, x), cloth_read(m, CD_VELOCITY, v);
        for (size_t i = 0; i < numbers_of(m); i += 3) {
            const double weight = (i / 3 % 17 % 16 ? 1 : 0.5) * (i / 3 / 17 % 16 ? 1 : 0.5);
            spin[after] += weight * ((x[i] - 0.5) * v[i + 1] - (x[i + 1] - 0.5) * v[i]);
        }
    }
    cd_membrane_destroy(m);
    return spin[1] / spin[0];
}

/* What keeps cloth from crumpling lets it turn. */
static void what_does_not_crumple_turns(void** state) {
    (void)state;
    static const double rates[] = {1, 10, 100, 1000}, dts[] = {1 / 60.0, 1 / 240.0}, lambdas[] = {0.5, 0.7, 1};
    for (size_t r = 0; r < COUNT(rates); ++r)
        for (size_t d = 0; d < COUNT(dts); ++d)
            for (size_t l = 0; l < COUNT(lambdas); ++l) {
                const double with = spin_left(rates[r], dts[d], lambdas[l]),
                             lost = spin_left(0, dts[d], lambdas[l]) - with;
                print_message("compression %g, dt %.4f, lambda %g: %.5f of the spin is left, %.5f less for it\n",
                              rates[r], dts[d], lambdas[l], with, lost);
                assert_true(lost < 1e-4 && lost > (rates[r] > 100 ? -8e-3 : d == 0 ? -4e-3 : -1e-5) && with < 1);
            }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_flat_sheet_falls_as_the_air_lets_it),
        cmocka_unit_test(wind_carries_a_free_sheet_along),
        cmocka_unit_test(air_only_takes_energy),
        cmocka_unit_test(who_drifts_along_sees_the_same),
        cmocka_unit_test(what_is_left_is_told),
        cmocka_unit_test(what_is_asked_for_is_found),
        cmocka_unit_test(posed_nodes_are_where_they_should_be),
        cmocka_unit_test(a_reset_leaves_nothing_of_what_was),
        cmocka_unit_test(a_teleport_changes_nothing_but_the_place),
        cmocka_unit_test(a_taut_sheet_swings_to_first_order),
        cmocka_unit_test(what_does_not_crumple_lies_still),
        cmocka_unit_test(a_tube_moves_alike_along_u_and_v),
        cmocka_unit_test(what_is_torn_off_falls_as_it_should),
        cmocka_unit_test(what_does_not_crumple_turns),
    };
    return cmocka_run_group_tests_name("cloth that moves", tests, NULL, NULL);
}
