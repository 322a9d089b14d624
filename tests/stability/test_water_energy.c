/* Basins that nothing feeds, pushes or drains: energy over the lowest bed does not grow. */
#include <math.h>
#include <stdlib.h>

#include "basin.h"
#include "check.h"
#include "reference.h"

enum { NX = 16, NY = 12, CELLS = NX * NY };

/* Any heap of water on a random bed of heights in [0, 1], surface smooth or cell by cell, at rest or in motion. */
static cd_water* lively(const struct way* way, uint64_t seed, int smooth, double motion, int line) {
    cd_water* w = line ? basin(4 * NX, 1, 1, 1, CD_FLOAT64) : basin(NX, NY, 1, 1, CD_FLOAT64);
    const size_t count = basin_count(w, CD_DEPTH);
    double surface[CELLS];
    basin_set_way(w, way);
    basin_random_bed(w, 1, smooth ? 5 : 0, seed);
    basin_read(w, CD_BED, surface);
    if (smooth) {
        cd_water* other = line ? basin(4 * NX, 1, 1, 1, CD_FLOAT64) : basin(NX, NY, 1, 1, CD_FLOAT64);
        basin_random_bed(other, 1.5, 5, seed + 1000);
        basin_read(other, CD_BED, surface);
        cd_water_destroy(other);
    } else {
        for (size_t k = 0; k < count; ++k) surface[k] = 0.75 + 0.75 * random_number(&seed);
    }
    basin_write(w, CD_SURFACE, surface);
    for (int axis = 0; axis < 2; ++axis) {
        const size_t nx = line ? 4 * NX : NX, ny = line ? 1 : NY;
        for (size_t j = axis ? 1 : 0; j < ny; ++j)
            for (size_t i = axis ? 0 : 1; i < nx; ++i) {
                const double u = motion * (smooth ? sin(0.5 * (double)(i + j) + (double)axis) : random_number(&seed));
                basin_set(w, axis ? CD_VELOCITY_Y : CD_VELOCITY_X, i, j, u);
            }
    }
    return w;
}

/* ---- the balance of linear momentum ------------------------------------------------------------------------------ */

/* Without u u_x, water that deepens under a velocity gains: of the equations,
 *     d/dt (h u^2 / 2 + g surface^2 / 2) = h_t u^2 / 2 + what flows in,
 * h the depth of a face. Between two states that comes to a quarter of each face's change of depth times the squares of
 * its velocities. In explicit steps a surface lies between the velocities that it has been moved by and those that it
 * will push, and both make up its energy. */
struct state {
    double depth[CELLS], bed[CELLS], velocity[2][(4 * NX + 1) * (NY + 1)];
    size_t n[2];
};

static void take(const cd_water* w, struct state* out) {
    ok(cd_water_get_shape(w, &out->n[0], &out->n[1], NULL, NULL, NULL));
    basin_read(w, CD_DEPTH, out->depth);
    basin_read(w, CD_BED, out->bed);
    basin_read(w, CD_VELOCITY_X, out->velocity[0]);
    basin_read(w, CD_VELOCITY_Y, out->velocity[1]);
}

static double face_depth(const struct state* s, size_t low, size_t high) {
    const double d = s->depth[low], e = s->depth[high], b = s->bed[low], c = s->bed[high];
    return d > 0 && e > 0 ? (d + e) / 2 : d > 0 || e > 0 ? fmax(0, fmax(b + d, c + e) - fmax(b, c)) : 0;
}

/* Of three states in turn: the kinetic energy of an explicit step's first, and what deepens under velocities between
 * the first two; basins are a metre per cell, of density 1000. */
static void weigh(const struct state* s, int is_explicit, double* out_kinetic, double* out_deepens) {
    *out_kinetic = *out_deepens = 0;
    for (int axis = 0; axis < 2; ++axis)
        for (size_t j = axis ? 1 : 0; j < s->n[1]; ++j)
            for (size_t i = axis ? 0 : 1; i < s->n[0]; ++i) {
                const size_t cell = j * s->n[0] + i, face = j * (s->n[0] + (axis == 0)) + i;
                const size_t low = cell - (axis ? s->n[0] : 1);
                const double u = s[0].velocity[axis][face], v = s[1].velocity[axis][face];
                const double was = face_depth(&s[0], low, cell), more = face_depth(&s[1], low, cell) - was;
                *out_kinetic += 500 * was * (u * v);
                *out_deepens += 250 * more * (is_explicit ? v * (u + s[2].velocity[axis][face]) : u * u + v * v);
            }
}

/* The most that the energy is ever above that of the start, and above what deepening has brought since, as parts of it,
 * over many beds. */
struct gain {
    double made, own;
};
static struct gain highest(const struct way* way, int line, int smooth, double courant, int steps, uint64_t seeds) {
    static struct state s[3];
    struct gain worst = {0, 0};
    const int centred = basin_is_explicit(way) && way->momentum == CD_MOMENTUM_LINEAR;
    for (uint64_t seed = 1; seed <= seeds; ++seed) {
        const double motion = (double)(seed % 3) * 1.5, dt = courant / sqrt(9.81);
        cd_water* w = lively(way, seed, smooth, motion, line);
        double total[2], potential[2], start = basin_energy(w), brought = 0, deepens, kinetic;
        for (int k = 0; k < 2; ++k) {
            if (k > 0) basin_step(w, dt, 1);
            take(w, &s[k]);
            total[k] = basin_energy(w), potential[k] = total[k] - basin_kinetic(w);
        }
        for (int k = 0; k < steps; ++k) {
            if (centred) basin_step(w, dt, 1), take(w, &s[2]);
            weigh(s, centred, &kinetic, &deepens);
            if (centred && k == 0) start = kinetic + potential[0];
            const double now = centred ? kinetic + potential[0] : total[0];
            worst.made = fmax(worst.made, now / start - 1);
            worst.own = fmax(worst.own, (now - brought) / start - 1);
            brought += deepens;
            s[0] = s[1], total[0] = total[1], potential[0] = potential[1];
            if (centred) s[1] = s[2];
            else basin_step(w, dt, 1), take(w, &s[1]);
            total[1] = basin_energy(w), potential[1] = total[1] - basin_kinetic(w);
        }
        cd_water_destroy(w);
    }
    return worst;
}

static struct gain highest_of_kinds(const struct way* way, double courant, int steps, uint64_t seeds) {
    struct gain worst = {0, 0};
    for (int kind = 0; kind < 4; ++kind) {
        const struct gain g = highest(way, kind / 2, kind % 2, courant, steps, seeds);
        worst.made = fmax(worst.made, g.made), worst.own = fmax(worst.own, g.own);
    }
    print_message("%-17s courant %5g: energy above its start by at most %.1e of it", way->name, courant, worst.made);
    if (way->momentum == CD_MOMENTUM_LINEAR) print_message(", but for deepening by %.1e", worst.own);
    print_message("\n");
    return worst;
}

/* Courant numbers are for a metre of depth. A closed form of what is kept exists for water all wet and small waves only
 * (see the seiches). Advected momentum makes what a face between a wet cell and one that just turned wet has more of
 * than its gate had; linear momentum what its equations make, and beyond that nothing where lambda damps. Lambda 1/2
 * and explicit steps make some ten-thousandths of their own; in long steps there is no balance to compare with, as
 * depths change in them as much as they are. */
static void no_energy_is_made_but_by_linear_momentum_that_deepens(void** state) {
    (void)state;
    static const double courants[] = {0.1, 0.3, 0.5, 1, 3, 10, 100, 1000, 5000};
    static const double most[WAYS][COUNT(courants)] = {
        [LINEAR] = {0.1, 0.1, 0.1, 0.1},
        [LINEAR_HALF] = {0.1, 0.1, 0.1, 0.1},
        [LINEAR_ONE] = {0.05, 0.02, 0.02},
        [ADVECTED] = {4e-3, 4e-3, 4e-3, 4e-3},
        [LARGE_1] = {4e-3, 4e-3, 4e-3, 4e-3},
        [LARGE_2] = {4e-3, 4e-3, 4e-3, 4e-3},
        [LARGE_4] = {4e-3, 4e-3, 4e-3, 4e-3},
        [COUPLED] = {0.1, 0.1, 0.1, 0.1},
        [COUPLED_ADVECTED] = {4e-3, 4e-3, 4e-3, 4e-3},
        [EXPLICIT] = {0.1, 0.1},
        [EXPLICIT_ADVECTED] = {4e-3, 4e-3},
    };
    /* of its own; 0 where not given, and in long steps of lambda 1/2 not looked at */
    static const double own[WAYS][COUNT(courants)] = {
        [LINEAR_HALF] = {2e-4, 5e-4, 1e-3, 1e-2, 1, 1, 1, 1, 1},
        [EXPLICIT] = {1e-3, 5e-3},
    };
    /* of 60 beds some gain in the first long step of lambda 1/2 from rest: what comes to a face takes on its speed */
    static const double from_rest[COUNT(courants)] = {0, 0, 0, 0, 3e-3, 1e-2, 2e-2, 1e-4, 1e-5};
    const int many = getenv("CD_LONG") != NULL;
    for (size_t k = 0; k < WAYS; ++k)
        for (size_t c = 0; c < COUNT(courants); ++c) {
            if (basin_is_explicit(&ways[k]) && courants[c] > 0.3) continue;
            const struct gain worst = highest_of_kinds(&ways[k], courants[c], 101, many ? 60 : 9);
            assert_true(worst.made <= (many && k == LINEAR_HALF ? fmax(from_rest[c], most[k][c]) : most[k][c]));
            if (ways[k].momentum == CD_MOMENTUM_LINEAR) assert_true(worst.own <= own[k][c] + 1e-14);
        }
}

/* Over the same time. */
static void shorter_linear_steps_make_no_more_of_their_own(void** state) {
    (void)state;
    static const int which[] = {LINEAR_HALF, EXPLICIT};
    static const double courants[] = {0.3, 0.1, 0.03};
    for (size_t k = 0; k < COUNT(which); ++k)
        for (size_t c = 0; c < COUNT(courants); ++c)
            assert_true(highest_of_kinds(&ways[which[k]], courants[c], (int)(30 / courants[c]), 9).own <= 5e-4);
}

/* A face that wets counts the mean of its cells in short steps only: one bed of sixty tells. */
static void large_steps_make_none_at_any_of_sixty_shores(void** state) {
    (void)state;
    assert_true(highest_of_kinds(&ways[LARGE_2], 10, 101, 60).made <= 0);
}

/* Films that run dry in a step must not drag others after them: it took steps a hundred times shorter than waves need
 * for a cell to make 40 times the energy of that. */
static void very_short_steps_make_no_energy_either(void** state) {
    (void)state;
    static const int which[] = {ADVECTED, LARGE_1, LARGE_2, LARGE_4, COUPLED_ADVECTED, EXPLICIT_ADVECTED};
    for (size_t k = 0; k < COUNT(which); ++k)
        assert_true(highest_of_kinds(&ways[which[k]], 0.01, 1000, 9).made <= 0.0025);
}

/* A film that springs up there runs down a slope and falls into a lake, which rises to the slope's foot: the lake stays
 * calm, and no water gets faster than by the fall. */
static void a_film_does_not_throw_the_lake_that_it_falls_into(void** state) {
    (void)state;
    enum { N = 12 };
    static const int which[] = {ADVECTED, LARGE_2, COUPLED_ADVECTED, EXPLICIT_ADVECTED};
    static const double bed[N] = {1, 0.98, 0.96, 0.94, 0.92, 0.9, 0.55, 0.1, 0.1, 0.1, 0.1, 0.1};
    for (size_t k = 0; k < COUNT(which); ++k)
        for (int down = 0; down < 2; ++down) {
            cd_water* w = basin(N, 1, 1, 1, CD_FLOAT64);
            double fastest = 0, lake = 0, depth[N], b[N], u[N + 1], source[N] = {0};
            basin_set_way(w, &ways[which[k]]);
            for (size_t i = 0; i < N; ++i) {
                const size_t at = down ? N - 1 - i : i;
                b[at] = bed[i], depth[at] = bed[i] < 0.5 ? 0.445 : bed[i] < 0.6 ? 0 : 1e-6;
                source[at] = bed[i] < 0.5 ? 1e-4 : i == 0 ? 1e-7 : 0;
            }
            ok(cd_water_enable_field(w, CD_SOURCE));
            basin_write(w, CD_BED, b), basin_write(w, CD_DEPTH, depth), basin_write(w, CD_SOURCE, source);
            for (int s = 0; s < 4000; ++s) {
                basin_step(w, 0.03, 1);
                basin_read(w, CD_VELOCITY_X, u), basin_read(w, CD_DEPTH, depth);
                for (size_t i = 1; i < N; ++i) {
                    const size_t place = down ? N - i : i; /* of the face, from the top of the slope */
                    if (depth[i - 1] > 0 && depth[i] > 0 && depth[i - 1] + depth[i] > 1e-9)
                        fastest = fmax(fastest, fabs(u[i]));
                    if (place > 7) lake = fmax(lake, fabs(u[i]));
                }
            }
            print_message("%-17s fastest %.2f m/s, in the lake %.1e m/s\n", ways[which[k]].name, fastest, lake);
            assert_true(fastest <= sqrt(2 * 9.81 * 0.9));
            assert_true(lake <= 0.1);
            cd_water_destroy(w);
        }
}

/* A heap on still water, all wet, at the tolerance a new water has: it comes to rise again, never above what it was but
 * for what a tolerance leaves. */
static void coupled_steps_of_any_length_do_not_heap_water_up(void** state) {
    (void)state;
    enum { N = 32 };
    static const double courants[] = {10, 100, 1000, 5000, 1e5, 1e6};
    for (size_t k = COUPLED; k <= COUPLED_ADVECTED; ++k)
        for (size_t c = 0; c < COUNT(courants); ++c) {
            const double height = 0.5;
            double surface[N * N], most = 0;
            size_t iterations = 0;
            cd_water* w = basin(N, N, 1, 1, CD_FLOAT64);
            basin_set_way(w, &ways[k]);
            for (size_t i = 0; i < N * N; ++i) {
                const double x = (double)(i % N) - 12, y = (double)(i / N) - 17;
                surface[i] = 1 + height * exp(-(x * x + y * y) / 9);
            }
            basin_write(w, CD_SURFACE, surface);
            for (int s = 0; s < 100; ++s) {
                size_t took;
                ok(cd_water_step(w, courants[c] / sqrt(9.81), 1));
                ok(cd_water_get_convergence(w, &took, NULL));
                basin_read(w, CD_SURFACE, surface);
                for (size_t i = 0; i < N * N; ++i) most = fmax(most, surface[i] - 1);
                iterations = took > iterations ? took : iterations;
            }
            print_message("%-17s courant %5g: at most %.3f of its height, %zu iterations\n", ways[k].name, courants[c],
                          most / height, iterations);
            assert_true(most <= 1.1 * height);
            assert_true(iterations <= 20);
            cd_water_destroy(w);
        }
}

/* Water that goes round many times in a step mixes slowly: all of it is solved for, in the sweeps there are. */
static void eddies_of_long_coupled_steps_come_to_the_tolerance(void** state) {
    (void)state;
    for (uint64_t seed = 1; seed <= 60; ++seed)
        for (int smooth = 0; smooth < 2; ++smooth) {
            cd_water* w = lively(&ways[COUPLED_ADVECTED], seed, smooth, (double)(seed % 3) * 1.5, 0);
            for (int s = 0; s < 2; ++s) assert_true(basin_step(w, 5000 / sqrt(9.81), 1));
            cd_water_destroy(w);
        }
}

/* ---- long runs --------------------------------------------------------------------------------------------------- */

static void a_lively_basin_calms_down_in_a_hundred_thousand_steps(void** state) {
    (void)state;
    static const int which[] = {LINEAR, ADVECTED, LARGE_2, EXPLICIT_ADVECTED};
    for (size_t k = 0; k < COUNT(which); ++k)
        for (int p = 0; p < 2; ++p) {
            const struct way* way = &ways[which[k]];
            cd_water* w = lively(way, 4, 1, 2, 0);
            double bed[CELLS], surface[CELLS], most = 0;
            const double dt = basin_is_explicit(way) ? 0.05 : 0.1;
            if (!p) {
                cd_water* single = basin(NX, NY, 1, 1, CD_FLOAT32);
                basin_set_way(single, way);
                basin_read(w, CD_BED, bed);
                basin_read(w, CD_SURFACE, surface);
                basin_write(single, CD_BED, bed);
                basin_write(single, CD_SURFACE, surface);
                cd_water_destroy(w);
                w = single;
            }
            const double start = basin_energy(w), volume = basin_volume(w);
            for (int part = 0; part < 1000; ++part) {
                basin_step(w, dt, 100);
                most = fmax(most, basin_energy(w) / start - 1);
            }
            print_message("%-17s %s: above the start by %.1e, %.1e of it in motion at the end\n", way->name,
                          p ? "float64" : "float32", most, basin_kinetic(w) / start);
            assert_true(most <= 0);
            assert_true(basin_kinetic(w) <= 1e-4 * start);
            assert_near(basin_volume(w), volume, p ? 1e-12 : 4e-6, 0);
            cd_water_destroy(w);
        }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(no_energy_is_made_but_by_linear_momentum_that_deepens),
        cmocka_unit_test(shorter_linear_steps_make_no_more_of_their_own),
        cmocka_unit_test(large_steps_make_none_at_any_of_sixty_shores),
        cmocka_unit_test(very_short_steps_make_no_energy_either),
        cmocka_unit_test(a_film_does_not_throw_the_lake_that_it_falls_into),
        cmocka_unit_test(coupled_steps_of_any_length_do_not_heap_water_up),
        cmocka_unit_test(eddies_of_long_coupled_steps_come_to_the_tolerance),
        cmocka_unit_test(a_lively_basin_calms_down_in_a_hundred_thousand_steps),
    };
    return cmocka_run_group_tests_name("water energy", tests, NULL, NULL);
}
