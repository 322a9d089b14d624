/* Cloth against exact answers: forces and energy, sheets that hang and that are pulled, free fall, shear, bend. */
#include <math.h>
#include <stdlib.h>

#include "check.h"
#include "cloth.h"
#include "reference.h"
#include "sheet.h"

enum { MOST = 400 }; /* nodes */

static double between(uint64_t* seed, double least, double most) {
    return least + (most - least) * (0.5 + 0.5 * random_number(seed));
}
static int one_in(uint64_t* seed, int n) { return between(seed, 0, n) < 1; }

/* What a spring of stiffness 1 and this length pulls by when it is this long, and the energy that it then holds. */
static double pull(double length, double now) {
    const double over = now - length, soft = 0.003 * length;
    return over <= 0 ? 0 : over <= 2 * soft ? over * over / (0.012 * length) : over - soft;
}
static double pull_energy(double length, double now) {
    const double over = now - length, soft = 0.003 * length;
    if (over <= 0) return 0;
    if (over <= 2 * soft) return over * over * over / (0.036 * length);
    return (over - soft) * (over - soft) / 2 + soft * soft / 6;
}

/* A sheet of cloth, flat and as large as it is: node (u, v) at (u length_u / nu, v length_v / nv, 0). */
static cd_membrane* flat(size_t nu, size_t nv, double length_u, double length_v) {
    cd_membrane* m = cloth(nu, nv, 3, CD_FLOAT64);
    ok(cd_membrane_set_rest_length(m, length_u, length_v));
    for (size_t v = 0; v <= nv; ++v)
        for (size_t u = 0; u <= nu; ++u) {
            const double x[3] = {length_u * (double)u / (double)nu, length_v * (double)v / (double)nv, 0};
            ok(cd_membrane_write_f64(m, CD_POSITION, u, v, 1, 1, x, 3));
        }
    return m;
}
static void gravity(cd_membrane* m, double x, double y, double z) {
    ok(cd_membrane_set_gravity(m, (double[3]){x, y, z}, 3));
}

/* ---- forces and energy ------------------------------------------------------------------------------------------- */

static void vary(cd_membrane* m, cd_field field, double part, uint64_t* seed) {
    double values[MOST];
    const size_t count = cloth_extent(m, field).count;
    ok(cd_membrane_enable_field(m, field));
    cloth_read(m, field, values);
    for (size_t i = 0; i < count; ++i) values[i] *= between(seed, 1 - part, 1 + part);
    cloth_write(m, field, values);
}
static void write_some(cd_membrane* m, cd_field field, double value, int one_of, uint64_t* seed) {
    const struct cloth_extent all = cloth_extent(m, field);
    ok(cd_membrane_enable_field(m, field));
    for (size_t v = 0; v < all.rows; ++v)
        for (size_t u = 0; u < all.columns; ++u)
            if (one_in(seed, one_of)) sheet_set(m, field, u, v, value);
}

/* Any sheet, tube or torus, at rest, with all that can be different in it, drawn out and crumpled by up to `noise` of
 * its springs. */
static cd_membrane* any_sheet(uint64_t* seed, double noise) {
    const size_t nu = (size_t)between(seed, 1, 7), nv = (size_t)between(seed, 1, 7);
    const int ring[2] = {nu > 1 && one_in(seed, 3), nv > 1 && one_in(seed, 3)};
    const double pi = acos(-1), spacing[2] = {between(seed, 0.05, 0.2), between(seed, 0.05, 0.2)};
    cd_membrane* m = cloth(nu, nv, 3, CD_FLOAT64);
    ok(cd_membrane_set_ring(m, ring[0], ring[1]));
    ok(cd_membrane_set_mass_rule(m, one_in(seed, 2) ? CD_MASS_EQUAL : CD_MASS_HALF_ENDS));
    ok(cd_membrane_set_rest_length(m, spacing[0] * (double)(nu + (size_t)ring[0]),
                                   spacing[1] * (double)(nv + (size_t)ring[1])));
    ok(cd_membrane_set_mass(m, between(seed, 0.5, 2)));
    ok(cd_membrane_set_stiffness(m, between(seed, 100, 300), between(seed, 100, 300)));
    if (one_in(seed, 2)) ok(cd_membrane_set_shear(m, between(seed, 50, 200)));
    if (one_in(seed, 2)) ok(cd_membrane_set_bend(m, between(seed, 0.1, 1)));
    ok(cd_membrane_set_compression(m, one_in(seed, 3) ? 0 : between(seed, 5, 100)));
    gravity(m, random_number(seed), random_number(seed), random_number(seed));
    ok(cd_membrane_set_lambda(m, 1));
    ok(cd_membrane_set_effort(m, 20, 500));
    if (one_in(seed, 2)) vary(m, CD_MASS, 0.5, seed);
    if (one_in(seed, 2)) vary(m, CD_REST_LENGTH_U, 0.2, seed);
    if (one_in(seed, 2)) vary(m, CD_REST_LENGTH_V, 0.2, seed);
    if (one_in(seed, 2)) vary(m, CD_STIFFNESS_U, 0.5, seed), write_some(m, CD_STIFFNESS_U, 0, 9, seed);
    if (one_in(seed, 2)) vary(m, CD_STIFFNESS_V, 0.5, seed), write_some(m, CD_STIFFNESS_V, 0, 9, seed);
    if (one_in(seed, 3)) write_some(m, CD_MASK, 0, 12, seed);
    if (one_in(seed, 3)) write_some(m, CD_PIN, CD_NODE_PINNED, 8, seed);
    for (size_t v = 0; v <= nv; ++v)
        for (size_t u = 0; u <= nu; ++u) {
            const double a = 2 * pi * (double)u / (double)(nu + 1), b = 2 * pi * (double)v / (double)(nv + 1);
            const double r[2] = {spacing[0] * (double)(nu + 1) / (2 * pi), spacing[1] * (double)(nv + 1) / (2 * pi)};
            double x[3] = {spacing[0] * (double)u, spacing[1] * (double)v, 0};
            if (ring[0]) x[0] = r[0] * cos(a), x[2] = r[0] * sin(a);
            if (ring[1] && !ring[0]) x[1] = r[1] * cos(b), x[2] = r[1] * sin(b);
            if (ring[1] && ring[0])
                x[0] += r[1] * cos(b) * cos(a), x[2] += r[1] * cos(b) * sin(a), x[1] = r[1] * sin(b);
            for (int k = 0; k < 3; ++k) x[k] += noise * spacing[0] * random_number(seed);
            ok(cd_membrane_write_f64(m, CD_POSITION, u, v, 1, 1, x, 3));
            if (one_in(seed, 10)) {
                const double to[3] = {x[0] + 0.1 * random_number(seed), x[1], x[2] + 0.1};
                ok(cd_membrane_attach(m, u, v, between(seed, 0, 100), between(seed, 0, 1), to, 3));
            }
        }
    return m;
}

/* From rest m v / dt is the force: what the energy loses per way that a node goes, at every node. */
static void what_a_step_does_is_the_gradient_of_the_energy(void** state) {
    (void)state;
    static const double noises[] = {0.003, 0.03, 0.3, 1};
    double worst = 0;
    for (uint64_t scene = 1; scene <= 160; ++scene) {
        uint64_t seed = scene;
        cd_membrane* m = any_sheet(&seed, noises[scene % COUNT(noises)]);
        const struct cloth_extent all = cloth_extent(m, CD_POSITION);
        const double dt = 1e-9, reach = 1e-7;
        double force[MOST], largest = 1e-3, off = 0;
        for (size_t i = 0; i < all.count; ++i) {
            const size_t u = i / 3 % all.columns, v = i / 3 / all.columns;
            double x[3], e[2];
            ok(cd_membrane_read_f64(m, CD_POSITION, u, v, 1, 1, x, 3));
            const double middle = x[i % 3];
            for (int side = 0; side < 2; ++side) {
                x[i % 3] = middle + (side ? reach : -reach);
                ok(cd_membrane_write_f64(m, CD_POSITION, u, v, 1, 1, x, 3));
                e[side] = sheet_energy(m);
            }
            x[i % 3] = middle;
            ok(cd_membrane_write_f64(m, CD_POSITION, u, v, 1, 1, x, 3));
            force[i] = (e[0] - e[1]) / (2 * reach);
            largest = fmax(largest, fabs(force[i]));
        }
        ok(cd_membrane_enable_field(m, CD_MASS));
        ok(cd_membrane_enable_field(m, CD_PIN));
        ok(cd_membrane_enable_field(m, CD_MASK));
        ok(cd_membrane_step(m, dt, 1));
        for (size_t i = 0; i < all.count; ++i) {
            const size_t u = i / 3 % all.columns, v = i / 3 / all.columns;
            double velocity[3];
            ok(cd_membrane_read_f64(m, CD_VELOCITY, u, v, 1, 1, velocity, 3));
            const int held = sheet_get(m, CD_PIN, u, v) != CD_NODE_FREE || sheet_get(m, CD_MASK, u, v) == 0;
            const double found = sheet_get(m, CD_MASS, u, v) * velocity[i % 3] / dt;
            if (held) assert_true(found == 0);
            else off = fmax(off, fabs(found - force[i]) / largest);
        }
        if (off > 1e-6)
            fail_msg("scene %d of %zu x %zu nodes: off by %.1e of %.3g N", (int)scene, all.columns, all.rows, off,
                     largest);
        worst = fmax(worst, off);
        cd_membrane_destroy(m);
    }
    print_message("160 sheets: forces are the gradient of the energy to %.1e of the largest\n", worst);
}

/* ---- at rest ----------------------------------------------------------------------------------------------------- */

/* How long a spring is that bears this load, `push` the stiffness of what keeps it from crumpling. */
static double length_under(double load, double stiffness, double push, double length) {
    double least = length, most = length * 1.01 + load / stiffness;
    for (int i = 0; i < 200; ++i) {
        const double now = 0.5 * (least + most);
        if (stiffness * pull(length, now) + push * (now - length) < load) least = now;
        else most = now;
    }
    return least;
}
static void settle(cd_membrane* m) {
    ok(cd_membrane_set_effort(m, 20, 500));
    for (int i = 0; i < 300; ++i) ok(cd_membrane_step(m, i < 150 ? 0.05 : 1, 1));
}

/* Hung by its edge v = 0, of 0.8 m x 0.6 m, 9 x 7 nodes: a column's spring bears what hangs below it. */
static void a_sheet_hangs_as_long_as_its_springs_make_it(void** state) {
    (void)state;
    static const double stiffness[] = {20, 200, 2e4, 1e7}, rates[] = {0, 5, 500};
    enum { NU = 8, NV = 6 };
    for (size_t k = 0; k < COUNT(stiffness); ++k)
        for (size_t r = 0; r < COUNT(rates); ++r)
            for (int half = 0; half < 2; ++half) {
                const double mass = 0.3, length = 0.1, columns = half ? NU : NU + 1, rows = half ? NV : NV + 1;
                double worst = 0, worst_tension = 0, tension[(NU + 1) * NV], across[NU * (NV + 1)], borne = 0;
                cd_membrane* m = flat(NU, NV, NU * length, NV * length);
                ok(cd_membrane_set_mass_rule(m, half ? CD_MASS_HALF_ENDS : CD_MASS_EQUAL));
                ok(cd_membrane_set_mass(m, mass));
                ok(cd_membrane_set_stiffness(m, 3 * stiffness[k], stiffness[k]));
                ok(cd_membrane_set_compression(m, rates[r]));
                ok(cd_membrane_set_edge(m, CD_EDGE_V_FIRST, CD_NODE_PINNED));
                gravity(m, 0, 9.81, 0);
                settle(m);
                cloth_read(m, CD_TENSION_V, tension);
                cloth_read(m, CD_TENSION_U, across);
                for (size_t u = 0; u <= NU; ++u) {
                    const double part = half && (u == 0 || u == NU) ? 0.5 : 1;
                    double y = 0;
                    for (size_t v = 0; v < NV; ++v) {
                        const double below = (double)(NV - v) - (half ? 0.5 : 0);
                        const double load = part * below * mass * 9.81 / (columns * rows), deal = part * NV / columns;
                        y += length_under(load, deal * stiffness[k], deal * rates[r] * mass, length);
                        double x[3];
                        ok(cd_membrane_read_f64(m, CD_POSITION, u, v + 1, 1, 1, x, 3));
                        worst = fmax(worst, fmax(fabs(x[1] - y), fmax(fabs(x[0] - (double)u * length), fabs(x[2]))));
                        worst_tension = fmax(worst_tension, fabs(tension[v * (NU + 1) + u] / load - 1));
                        if (v == 0) borne += tension[u];
                    }
                }
                for (size_t i = 0; i < COUNT(across); ++i) assert_near(across[i], 0, 1e-9, 1);
                assert_near(borne, mass * 9.81 * (NV + (half ? -0.5 : 0)) / rows, 1e-9, 0);
                print_message("hung, %g N/m, rate %g, half edges %d: nodes to %.1e m, tensions to %.1e\n", stiffness[k],
                              rates[r], half, worst, worst_tension);
                assert_true(worst < 1e-9);
                assert_true(worst_tension < 1e-7);
                cd_membrane_destroy(m);
            }
}

/* Held at an edge and pulled at the one across from it, along u and along v, which differ. */
static void a_pulled_edge_comes_as_far_as_the_springs_let_it(void** state) {
    (void)state;
    static const double pulls[] = {1e-3, 0.1, 5, 300};
    enum { NU = 6, NV = 4 };
    const double length[2] = {0.05, 0.125}, stiffness[2] = {400, 1500}, mass = 0.2, rate = 5;
    for (size_t p = 0; p < COUNT(pulls); ++p)
        for (int way = 0; way < 2; ++way) {
            const size_t springs = way ? NV : NU, lines = way ? NU + 1 : NV + 1;
            cd_membrane* m = flat(NU, NV, NU * length[0], NV * length[1]);
            ok(cd_membrane_set_mass(m, mass));
            ok(cd_membrane_set_stiffness(m, stiffness[0], stiffness[1]));
            ok(cd_membrane_set_compression(m, rate));
            ok(cd_membrane_set_edge(m, way ? CD_EDGE_V_FIRST : CD_EDGE_U_FIRST, CD_NODE_PINNED));
            ok(cd_membrane_enable_field(m, CD_FORCE));
            for (size_t i = 0; i < lines; ++i) {
                double force[3] = {0, 0, 0};
                force[way] = pulls[p] / (double)lines;
                ok(cd_membrane_write_f64(m, CD_FORCE, way ? i : NU, way ? NV : i, 1, 1, force, 3));
            }
            settle(m);
            const double deal = (double)springs / (double)lines;
            const double now =
                length_under(pulls[p] / (double)lines, deal * stiffness[way], deal * rate * mass, length[way]);
            for (size_t i = 0; i < lines; ++i)
                for (size_t j = 0; j < springs; ++j) {
                    const size_t u = way ? i : j, v = way ? j : i;
                    double x[3];
                    ok(cd_membrane_read_f64(m, CD_POSITION, way ? u : u + 1, way ? v + 1 : v, 1, 1, x, 3));
                    assert_near(x[way], (double)(j + 1) * now, 1e-9, 1);
                    assert_near(sheet_get(m, way ? CD_STRAIN_V : CD_STRAIN_U, u, v), now / length[way] - 1, 1e-8, 1);
                    assert_near(sheet_get(m, way ? CD_TENSION_V : CD_TENSION_U, u, v), pulls[p] / (double)lines, 1e-8,
                                pulls[p]);
                }
            cd_membrane_destroy(m);
        }
}

/* ---- what is free ------------------------------------------------------------------------------------------------ */

static void middle_of(const cd_membrane* m, double* middle) { /* of mass, where all nodes weigh the same */
    double x[3 * MOST];
    const size_t count = cloth_extent(m, CD_POSITION).count;
    cloth_read(m, CD_POSITION, x);
    for (size_t k = 0; k < 3; ++k) {
        middle[k] = 0;
        for (size_t i = k; i < count; i += 3) middle[k] += x[i] / (double)(count / 3);
    }
}

static void free_fall_is_exact(void** state) {
    (void)state;
    static const double lambdas[] = {1, 0.7, 0.5}, steps[] = {1e-3, 1 / 60.0, 0.1}, g[3] = {1, -9.81, 2};
    for (int crumpled = 0; crumpled < 2; ++crumpled)
        for (size_t l = 0; l < COUNT(lambdas); ++l)
            for (size_t s = 0; s < COUNT(steps); ++s) {
                const double dt = steps[s];
                double before[3], after[3], x0[3 * MOST], x1[3 * MOST], worst = 0;
                cd_membrane* m = flat(12, 9, 1.2, 0.9);
                ok(cd_membrane_set_stiffness(m, 2000, 2000));
                ok(cd_membrane_set_shear(m, 100));
                ok(cd_membrane_set_bend(m, 0.001));
                ok(cd_membrane_set_lambda(m, lambdas[l]));
                gravity(m, g[0], g[1], g[2]);
                if (crumpled) cloth_shake(m, 0.2, 3);
                double p[3];
                ok(cd_membrane_get_momentum(m, p, 3)); /* mass 1: the velocity of the middle */
                cloth_read(m, CD_POSITION, x0);
                middle_of(m, before);
                for (int n = 1; n <= 30; ++n) {
                    ok(cd_membrane_step(m, dt, 1));
                    cloth_read(m, CD_POSITION, x1);
                    middle_of(m, after);
                    for (size_t k = 0; k < 3; ++k) {
                        const double fallen = p[k] * n * dt + g[k] * dt * dt * (0.5 * n * (n - 1) + lambdas[l] * n);
                        const double size = 1 + fabs(fallen);
                        worst = fmax(worst, fabs(after[k] - before[k] - fallen) / size);
                        for (size_t i = k; i < 3 * 130 && !crumpled; i += 3)
                            worst = fmax(worst, fabs(x1[i] - x0[i] - fallen) / size);
                    }
                }
                print_message("free fall, %s, lambda %g, dt %g: to %.1e\n", crumpled ? "crumpled" : "flat", lambdas[l],
                              dt, worst);
                assert_true(worst < 1e-12);
                cd_membrane_destroy(m);
            }
}

/* Any sheet that nothing holds keeps its momentum; drag takes the part d dt / (1 + lambda d dt) of it in each step. */
static void a_free_sheet_keeps_its_momentum(void** state) {
    (void)state;
    static const double drags[] = {0, 0.3, 20};
    double worst = 0;
    for (uint64_t scene = 1; scene <= 60; ++scene) {
        uint64_t seed = 1000 + scene;
        cd_membrane* m = any_sheet(&seed, 0.3);
        const double lambda = scene % 4 ? 1 : 0.6, drag = drags[scene % 3], dt = scene % 5 ? 1 / 60.0 : 1;
        gravity(m, 0, 0, 0);
        ok(cd_membrane_disable_field(m, CD_TARGET));
        ok(cd_membrane_disable_field(m, CD_PIN));
        cloth_shake(m, 0.01, scene);
        ok(cd_membrane_set_lambda(m, lambda));
        ok(cd_membrane_set_drag(m, drag));
        if (scene % 2) ok(cd_membrane_set_effort(m, 2, 20));
        double before[3], after[3], left = 1;
        ok(cd_membrane_get_momentum(m, before, 3));
        for (int n = 1; n <= 20; ++n) {
            ok(cd_membrane_step(m, dt, 1));
            ok(cd_membrane_get_momentum(m, after, 3));
            left *= 1 - dt * drag / (1 + lambda * dt * drag);
            for (int k = 0; k < 3; ++k) worst = fmax(worst, fabs(after[k] - left * before[k]));
        }
        if (worst > 1e-12) fail_msg("scene %d: momentum off by %.1e", (int)scene, worst);
        cd_membrane_destroy(m);
    }
    print_message("60 free sheets: momentum to %.1e\n", worst);
}

/* ---- shear and bend ---------------------------------------------------------------------------------------------- */

/* Cells of length_u x length_v as diamonds, leaning by this angle: springs along u and v keep their lengths. */
enum { SU = 5, SV = 4 };
static void lean(cd_membrane* m, const double* length, double angle) {
    for (size_t v = 0; v <= SV; ++v)
        for (size_t u = 0; u <= SU; ++u) {
            const double up = (double)v * length[1];
            const double x[3] = {(double)u * length[0] + up * sin(angle), up * cos(angle), 0};
            ok(cd_membrane_write_f64(m, CD_POSITION, u, v, 1, 1, x, 3));
        }
}
static double elastic(const cd_membrane* m) {
    double e;
    ok(cd_membrane_get_energy(m, NULL, &e, NULL));
    return e;
}
static double leaning_energy(const double* length, double angle) { /* of a cell with shear 1 */
    const double whole = hypot(length[0], length[1]), a = length[0], b = length[1];
    const double wide = sqrt(a * a + b * b + 2 * a * b * sin(angle));
    const double narrow = sqrt(a * a + b * b - 2 * a * b * sin(angle));
    return pull_energy(whole, wide) + pull_energy(whole, narrow);
}

static void a_cell_that_leans_is_pulled_by_its_diagonals(void** state) {
    (void)state;
    static const double lengths[][2] = {{0.1, 0.1}, {0.05, 0.2}}, angles[] = {0.004, 0.02, 0.3, -0.3, 1};
    const double shear = 70;
    for (size_t l = 0; l < COUNT(lengths); ++l) {
        cd_membrane* m = flat(SU, SV, SU * lengths[l][0], SV * lengths[l][1]);
        ok(cd_membrane_set_stiffness(m, 1e3, 1e3));
        lean(m, lengths[l], 0.3);
        assert_near(elastic(m), 0, 1e-12, 1);
        ok(cd_membrane_set_shear(m, shear));
        for (size_t a = 0; a < COUNT(angles); ++a) {
            lean(m, lengths[l], angles[a]);
            assert_near(elastic(m), SU * SV * shear * leaning_energy(lengths[l], angles[a]), 1e-9, 1e-5);
        }
        cd_membrane_destroy(m);
    }
    /* Square cells that lean little: as a solid of half that shear modulus, of the angle beyond the slack. */
    cd_membrane* m = flat(SU, SV, SU * 0.1, SV * 0.1);
    ok(cd_membrane_set_shear(m, shear));
    double e[3];
    const double step = 1e-3;
    for (int i = 0; i < 3; ++i) lean(m, lengths[0], 0.02 + (i - 1) * step), e[i] = elastic(m);
    const double modulus = (e[0] - 2 * e[1] + e[2]) / (step * step) / (SU * SV * 0.01);
    print_message("shear modulus %.4f of the stiffness\n", modulus / shear);
    assert_near(modulus, shear / 2, 0.03, 0);
    cd_membrane_destroy(m);
}

static void a_cut_takes_the_shear_of_its_cells_with_it(void** state) {
    (void)state;
    const double length[2] = {0.1, 0.1}, cell = 70 * leaning_energy(length, 0.3);
    cd_membrane* m = flat(SU, SV, SU * 0.1, SV * 0.1);
    ok(cd_membrane_set_shear(m, 70));
    ok(cd_membrane_enable_field(m, CD_STIFFNESS_U));
    ok(cd_membrane_enable_field(m, CD_STIFFNESS_V));
    lean(m, length, 0.3);
    assert_near(elastic(m), SU * SV * cell, 1e-10, 0);
    sheet_set(m, CD_STIFFNESS_U, 2, 0, 0); /* on the edge: one cell */
    assert_near(elastic(m), (SU * SV - 1) * cell, 1e-10, 0);
    sheet_set(m, CD_STIFFNESS_U, 2, 2, 0); /* inside: two */
    assert_near(elastic(m), (SU * SV - 3) * cell, 1e-10, 0);
    sheet_set(m, CD_STIFFNESS_V, 3, 1, 0); /* two, of which one is cut already */
    assert_near(elastic(m), (SU * SV - 4) * cell, 1e-10, 0);
    sheet_set(m, CD_STIFFNESS_V, SU, 3, 0);
    assert_near(elastic(m), (SU * SV - 5) * cell, 1e-10, 0);
    ok(cd_membrane_enable_field(m, CD_MASK));
    sheet_set(m, CD_MASK, 1, 1, 0); /* the four round a node that goes */
    assert_near(elastic(m), (SU * SV - 9) * cell, 1e-10, 0);
    cd_membrane_destroy(m);
}

/* A strip held at its first two nodes, a clamp between them, that sags a little under its weight w per length, as a
 * beam does: w l^4 / 8 b at its end. Returns how far off its end is. */
static double strip_misses_by(size_t nu) {
    const double b = 0.02, mass = 0.1, g = 1e-4, h = 1 / (double)nu, free_length = 1 - h / 2;
    cd_membrane* m = flat(nu, 2, 1, 0.1);
    ok(cd_membrane_set_mass_rule(m, CD_MASS_HALF_ENDS));
    ok(cd_membrane_set_mass(m, mass));
    ok(cd_membrane_set_stiffness(m, 100, 100));
    ok(cd_membrane_set_bend(m, b));
    ok(cd_membrane_set_compression(m, 0));
    ok(cd_membrane_enable_field(m, CD_PIN));
    for (size_t v = 0; v <= 2; ++v)
        for (size_t u = 0; u < 2; ++u) sheet_set(m, CD_PIN, u, v, CD_NODE_PINNED);
    gravity(m, 0, 0, -g);
    ok(cd_membrane_set_effort(m, 20, 2000));
    ok(cd_membrane_step(m, 1e3, 30));
    const double wanted = mass * g * pow(free_length, 4) / (8 * b);
    double x[3];
    ok(cd_membrane_read_f64(m, CD_POSITION, nu, 1, 1, 1, x, 3));
    cd_membrane_destroy(m);
    return fabs(x[2] / -wanted - 1);
}

static void a_clamped_strip_bends_as_a_beam(void** state) {
    (void)state;
    double off[4];
    for (int r = 0; r < 4; ++r) off[r] = strip_misses_by((size_t)4 << r);
    print_message("strip of 4, 8, 16, 32 springs: sag of its end off by %.2e, %.2e, %.2e, %.2e\n", off[0], off[1],
                  off[2], off[3]);
    for (int r = 0; r < 3; ++r) assert_true(off[r + 1] < 0.3 * off[r]);
    assert_true(off[3] < 2e-3);
}

/* Folded sharply along u = 2: the bend of that line's nodes holds the energy, and goes with springs beside it. */
static void a_cut_takes_the_bend_of_its_ends_with_it(void** state) {
    (void)state;
    enum { NU = 4, NV = 4 };
    const double b = 0.3, node = b * NU * NU * NU / (NV + 1), curve = 2 * 0.1 * 0.1 / 2; /* half of |x_uu|^2 there */
    cd_membrane* m = flat(NU, NV, NU * 0.1, NV * 0.1);
    ok(cd_membrane_set_bend(m, b));
    for (size_t v = 0; v <= NV; ++v)
        for (size_t u = 0; u <= NU; ++u) {
            const double x[3] = {u < 2 ? 0.1 * (double)u : 0.2, 0.1 * (double)v, u < 2 ? 0 : 0.1 * (double)(u - 2)};
            ok(cd_membrane_write_f64(m, CD_POSITION, u, v, 1, 1, x, 3));
        }
    assert_near(elastic(m), (NV + 1) * node * curve, 1e-10, 0);
    ok(cd_membrane_enable_field(m, CD_STIFFNESS_U));
    sheet_set(m, CD_STIFFNESS_U, 1, 0, 0);
    assert_near(elastic(m), NV * node * curve, 1e-10, 0);
    sheet_set(m, CD_STIFFNESS_U, 2, 3, 0);
    assert_near(elastic(m), (NV - 1) * node * curve, 1e-10, 0);
    sheet_set(m, CD_STIFFNESS_U, 0, 2, 0); /* not beside the fold */
    assert_near(elastic(m), (NV - 1) * node * curve, 1e-10, 0);
    cd_membrane_destroy(m);
}

/* Next to no length the energy of springs that are pressed together goes on as before. */
static void a_sheet_in_one_point_holds_all_its_energy(void** state) {
    (void)state;
    double before = 0, elastic;
    for (double size = 1; size > 1e-9; size /= 3) {
        cd_membrane* m = flat(3, 4, 1, 1.5);
        double x[60];
        ok(cd_membrane_read_f64(m, CD_POSITION, 0, 0, 4, 5, x, 60));
        for (size_t i = 0; i < 60; ++i) x[i] *= size;
        ok(cd_membrane_write_f64(m, CD_POSITION, 0, 0, 4, 5, x, 60));
        ok(cd_membrane_get_energy(m, NULL, &elastic, NULL));
        if (size < 1e-3) assert_near(elastic, before, 2.1e-3, 0);
        assert_true(elastic >= before);
        before = elastic;
        cd_membrane_destroy(m);
    }
    assert_true(before > 0);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_a_step_does_is_the_gradient_of_the_energy),
        cmocka_unit_test(a_sheet_hangs_as_long_as_its_springs_make_it),
        cmocka_unit_test(a_pulled_edge_comes_as_far_as_the_springs_let_it),
        cmocka_unit_test(free_fall_is_exact),
        cmocka_unit_test(a_free_sheet_keeps_its_momentum),
        cmocka_unit_test(a_cell_that_leans_is_pulled_by_its_diagonals),
        cmocka_unit_test(a_cut_takes_the_shear_of_its_cells_with_it),
        cmocka_unit_test(a_cut_takes_the_bend_of_its_ends_with_it),
        cmocka_unit_test(a_clamped_strip_bends_as_a_beam),
        cmocka_unit_test(a_sheet_in_one_point_holds_all_its_energy),
    };
    return cmocka_run_group_tests_name("cloth", tests, NULL, NULL);
}
