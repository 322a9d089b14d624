/* Basins that nothing feeds, pushes or drains: energy over the lowest bed does not grow. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "basin.h"
#include "check.h"
#include "modes.h"
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
 * h the depth of a face. A step sweeps along rows and columns, and along a line with fast water in parts, each of them
 * the two halves of another: what a part brings is a quarter of each face's change of depth times the squares of its
 * velocities, of faces across a line half of that change times the square of what they keep. */
struct line {
    double bed[4 * NX], depth[4 * NX], speed[4 * NX + 1];
    size_t n;
};

static double mean_depth(const struct line* s, size_t face) { return (s->depth[face - 1] + s->depth[face]) / 2; }

/* Of a face that no water can cross, which rests in a step: 0. */
static double square(const struct line* s, size_t face) {
    const double d = s->depth[face - 1], e = s->depth[face], climb = s->bed[face] - s->bed[face - 1];
    return fmax(d > 0 ? d - climb : 0, e > 0 ? e + climb : 0) > 0 || fmin(d, e) > 0 ? pow(s->speed[face], 2) : 0;
}

/* What has deepened under velocities between two states [J]; basins are a metre per cell, of density 1000. */
static double deepening(const struct line* s, const struct line* after) {
    double sum = 0;
    for (size_t i = 1; i < s->n; ++i)
        sum += 250 * (mean_depth(after, i) - mean_depth(s, i)) * (square(s, i) + square(after, i));
    return sum;
}

/* Steps a line by dt; what that brings is known where it is made in no more than `most` parts: where halves end as the
 * whole, 64 of them. Else it is told from the beginning and the end. */
static double bring(cd_water* water, struct line* line, double dt, uint64_t most, int* known) {
    uint64_t before, after;
    struct line whole = *line, halves = *line;
    basin_write(water, CD_BED, line->bed), basin_write(water, CD_DEPTH, line->depth);
    basin_write(water, CD_VELOCITY_X, line->speed);
    ok(cd_water_get_factorizations(water, &before));
    basin_step(water, dt, 1);
    ok(cd_water_get_factorizations(water, &after));
    basin_read(water, CD_DEPTH, whole.depth), basin_read(water, CD_VELOCITY_X, whole.speed);
    double brought = deepening(line, &whole);
    *known = after - before <= most;
    if (*known && after - before > 1) {
        const double first = bring(water, &halves, dt / 2, most / 2, known);
        const double second = *known ? bring(water, &halves, dt / 2, most / 2, known) : 0;
        if (*known) brought = first + second;
        for (size_t i = 0; *known && i < line->n; ++i) assert_near(halves.depth[i], whole.depth[i], 1e-14, 0);
    }
    *line = whole;
    return brought;
}

/* Steps a water by its lines, one by one, and tells what that brings; `line` is a water of one as long as any of its. */
static double bring_all(cd_water* w, cd_water* const* line, double dt, int first) {
    double bed[CELLS], depth[CELLS], velocity[2][(4 * NX + 1) * (NY + 1)], brought = 0;
    size_t n[2];
    struct line s;
    ok(cd_water_get_shape(w, &n[0], &n[1], NULL, NULL, NULL));
    basin_read(w, CD_BED, bed), basin_read(w, CD_DEPTH, depth);
    basin_read(w, CD_VELOCITY_X, velocity[0]), basin_read(w, CD_VELOCITY_Y, velocity[1]);
    for (int turn = 0; turn < 2; ++turn) {
        const int axis = first ^ turn;
        double swept[CELLS];
        memcpy(swept, depth, sizeof swept);
        for (int moved = 1; moved >= 0; --moved) /* along the lines, then the faces across them */
            for (size_t k = 0; k < n[moved ? !axis : axis]; ++k) {
                const int along = moved ? axis : !axis;
                const size_t cell = along ? n[0] : 1, face = along ? n[0] : 1;
                const size_t at = k * (along ? 1 : n[0]), from = k * (along ? 1 : n[0] + 1);
                s.n = n[along];
                struct line after;
                int known;
                for (size_t i = 0; i < s.n; ++i) s.bed[i] = bed[at + i * cell], s.depth[i] = depth[at + i * cell];
                for (size_t i = 0; i <= s.n; ++i) s.speed[i] = velocity[along][from + i * face];
                after = s;
                if (moved && s.n > 1) brought += bring(line[along], &after, dt, 64, &known);
                for (size_t i = 0; !moved && i < s.n; ++i) after.depth[i] = swept[at + i * cell];
                if (!moved) brought += deepening(&s, &after);
                for (size_t i = 0; moved && i < s.n; ++i) swept[at + i * cell] = after.depth[i];
                for (size_t i = 0; i <= s.n; ++i) velocity[along][from + i * face] = after.speed[i];
            }
        memcpy(depth, swept, sizeof depth);
    }
    basin_step(w, dt, 1);
    basin_read(w, CD_DEPTH, bed);
    for (size_t i = 0; i < n[0] * n[1]; ++i) assert_near(depth[i], bed[i], 1e-14, 0);
    return brought;
}

/* The most that the energy is ever above that of the start, and above what deepening has brought since, as parts of it,
 * over many beds; where it is little anyway, the same. */
struct gain {
    double made, own;
};
static const double little = 2e-3;
static struct gain highest(const struct way* way, int line, int smooth, double courant, int steps, uint64_t seeds) {
    struct gain worst = {0, 0};
    for (uint64_t seed = 1; seed <= seeds; ++seed) {
        double made = 0, own = 0;
        for (int apart = 0; apart < (made > little && way->momentum == CD_MOMENTUM_LINEAR ? 2 : 1); ++apart) {
            cd_water* w = lively(way, seed, smooth, (double)(seed % 3) * 1.5, line);
            cd_water* lines[2] = {basin(line ? 4 * NX : NX, 1, 1, 1, CD_FLOAT64), basin(NY, 1, 1, 1, CD_FLOAT64)};
            basin_set_way(lines[0], way), basin_set_way(lines[1], way);
            const double start = basin_energy(w), dt = courant / sqrt(9.81);
            double brought = 0, most = 0;
            for (int k = 0; k < steps; ++k) {
                if (apart) brought += bring_all(w, lines, dt, k & 1);
                else basin_step(w, dt, 1);
                most = fmax(most, (basin_energy(w) - brought) / start - 1);
            }
            made = apart ? made : most, own = most;
            cd_water_destroy(w), cd_water_destroy(lines[0]), cd_water_destroy(lines[1]);
        }
        worst.made = fmax(worst.made, made), worst.own = fmax(worst.own, fmin(made, own));
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

/* Courant numbers are for a metre of depth. Advected momentum makes none, but a little at shores in very short steps;
 * linear momentum what its equations make. CD_LONG looks at ten times as many beds. */
static void no_energy_is_made_but_by_linear_momentum_that_deepens(void** state) {
    (void)state;
    static const double courants[] = {0.01, 0.1, 0.3, 0.5, 1, 3, 10, 100, 1000, 1e4};
    const uint64_t seeds = is_long() ? 60 : 6;
    for (size_t k = 0; k < WAYS; ++k)
        for (size_t c = 0; c < COUNT(courants); ++c) {
            if (basin_is_explicit(&ways[k]) && courants[c] > 0.3) continue;
            const struct gain worst = highest_of_kinds(&ways[k], courants[c], courants[c] < 0.1 ? 1000 : 101, seeds);
            if (ways[k].momentum) assert_true(worst.made <= (courants[c] < 0.1 ? 5e-3 : 1e-5));
            else assert_true(worst.made <= 0.1 && worst.own <= 2 * little);
        }
}

/* In long steps advected momentum makes none at all, at shores either. */
static void long_advected_steps_make_no_energy(void** state) {
    (void)state;
    static const double courants[] = {1.5, 3, 10, 100, 1e4};
    for (size_t c = 0; c < COUNT(courants); ++c)
        for (int kind = 0; kind < 4; ++kind)
            assert_true(highest(&ways[ADVECTED], kind / 2, kind % 2, courants[c], 5, 60).made <= 1e-9);
}

/* What faces keep that no water crosses [J]. */
static double kept_at_dry_faces(cd_water* w) {
    double bed[CELLS], depth[CELLS], velocity[(4 * NX + 1) * (NY + 1)], sum = 0;
    size_t nx, ny;
    ok(cd_water_get_shape(w, &nx, &ny, NULL, NULL, NULL));
    basin_read(w, CD_BED, bed), basin_read(w, CD_DEPTH, depth);
    for (size_t axis = 0; axis < 2; ++axis) {
        basin_read(w, axis ? CD_VELOCITY_Y : CD_VELOCITY_X, velocity);
        for (size_t j = axis; j < ny; ++j)
            for (size_t i = 1 - axis; i < nx; ++i) {
                const size_t r = j * nx + i, l = axis ? r - nx : r - 1, face = axis ? r : r + j;
                const double high = fmax(bed[l] + depth[l], bed[r] + depth[r]) - fmax(bed[l], bed[r]);
                const double u = fmin(depth[l], depth[r]) > 0 || high > 0 ? 0 : velocity[face];
                sum += 250 * (depth[l] + depth[r]) * u * u;
            }
    }
    return sum;
}

/* Nor where the bed rubs, whether that takes a part of velocities in a step or all: once energy is lost it stays so. But
 * a face beside a cell that a sweep across dries keeps its speed, which counts again as the next sweep wets it. In the
 * shortest steps, fast water's parts are so short that waves cross less than a cell in each. */
static void long_steps_that_rub_make_no_energy(void** state) {
    (void)state;
    static const double drags[] = {0, 1, 100}, mannings[] = {0, 0.02, 3};
    static const struct { double courant, most; } rows[] = {{1.5, 1e-12}, {10, 1e-11}, {100, 1e-11}, {1e4, 1e-11}};
    for (size_t r = 0; r < COUNT(rows); ++r) {
        double worst = 0;
        for (int n = 0; n < (r == 0 ? 360 : 108); ++n) {
            cd_water* w = lively(&ways[ADVECTED], 1 + (uint64_t)n + 90 * r, n % 2, n / 2 % 3, n / 6 % 2);
            ok(cd_water_set_drag(w, drags[n / 12 % 3]));
            ok(cd_water_set_manning(w, mannings[n / 36 % 3]));
            const double start = basin_energy(w);
            double least = start + kept_at_dry_faces(w);
            for (int k = 0; k < 60; ++k) {
                basin_step(w, rows[r].courant / sqrt(9.81), 1);
                const double now = basin_energy(w);
                worst = fmax(worst, (now - least) / start);
                least = fmin(least, now + kept_at_dry_faces(w));
            }
            cd_water_destroy(w);
        }
        print_message("courant %5g: water that rubs gains at most %.1e of its energy after it has lost more\n",
                      rows[r].courant, worst);
        assert_true(worst <= rows[r].most);
    }
}

/* Advected water among cliffs, of beds that are 0 or 1 cell by cell, or anything up to 2 or 4, at rest or in motion
 * where it is wet on both sides of a face: what runs at a cliff's foot is no more than what came there, and films that
 * fall into it from beyond do not move its water up the cliff. In motion at dry faces too, its first step makes some. */
static void water_among_cliffs_makes_little_energy(void** state) {
    (void)state;
    static const double courants[] = {0.01, 0.1, 0.3, 0.5, 1, 10, 1000};
    static const int which[] = {ADVECTED, EXPLICIT_ADVECTED};
    const uint64_t seeds = is_long() ? 100 : 12;
    for (size_t k = 0; k < COUNT(which) * COUNT(courants); ++k) {
        const struct way* way = &ways[which[k / COUNT(courants)]];
        const double courant = courants[k % COUNT(courants)];
        double worst = 0, worst_dry = 0, leap = 0;
        if (basin_is_explicit(way) && courant > 0.3) continue;
        for (uint64_t scene = 0; scene < 5 * seeds; ++scene) {
            const int line = scene & 1, blocks = scene >> 1 & 1, dry_too = scene >= 4 * seeds;
            uint64_t seed = 1 + scene;
            cd_water* w = lively(way, seed, 0, 1.5 * (double)(scene / 4 % 3), line);
            const size_t nx = line ? 4 * NX : NX, ny = line ? 1 : NY;
            for (size_t i = 0; i < nx * ny; ++i) {
                const double high = random_number(&seed), surface = blocks ? 0.5 : 0.75;
                const double bed = blocks ? (high > 0 ? 1 : 0) : (line ? 2 : 1) * (1 + high);
                basin_set(w, CD_BED, i % nx, i / nx, bed);
                basin_set(w, CD_SURFACE, i % nx, i / nx, surface * (1 + random_number(&seed)));
            }
            for (size_t i = 0; i < nx * ny; ++i)
                if (!dry_too && !(basin_get(w, CD_DEPTH, i % nx, i / nx) > 0))
                    for (size_t side = 0; side < 2; ++side) {
                        basin_set(w, CD_VELOCITY_X, i % nx + side, i / nx, 0);
                        basin_set(w, CD_VELOCITY_Y, i % nx, i / nx + side, 0);
                    }
            double start = basin_energy(w);
            if (dry_too) {
                basin_step(w, courant / sqrt(9.81), 1);
                leap = fmax(leap, basin_energy(w) / start - 1), start = basin_energy(w);
            }
            for (int s = 0; s < (courant < 0.1 ? 1000 : 101); ++s) {
                basin_step(w, courant / sqrt(9.81), 1);
                double* const most = dry_too ? &worst_dry : &worst;
                *most = fmax(*most, basin_energy(w) / start - 1);
            }
            cd_water_destroy(w);
        }
        print_message("%-17s courant %5g: among cliffs at most %.1e; in motion at dry faces %.1e first, then %.1e\n",
                      way->name, courant, worst, leap, worst_dry);
        /* few of the scenes of the long sweep make more than a tenth of what they may */
        assert_true(worst <= (is_long() ? 5e-3 : 5e-4) && leap <= 1e-2 && worst_dry <= 5e-3);
    }
}

/* ---- cliffs and air ---------------------------------------------------------------------------------------------- */

/* What comes to a cell in a step climbs no cliff behind it, whether the cell was dry or wet by a film: where it was dry,
 * a face between two dry cells carried a part of what came on, up any cliff. */
static void what_comes_to_dry_ground_climbs_no_cliff(void** state) {
    (void)state;
    static const double courants[] = {0.3, 0.9, 1, 2, 8}, films[] = {0, 1e-20, 1e-10}, cliffs[] = {0.3, 2, 50};
    for (size_t k = 0; k < WAYS; ++k)
        for (size_t c = 0; c < COUNT(courants) * COUNT(films) * COUNT(cliffs); ++c)
            for (int at_last = 0; at_last < 2; ++at_last) {
                enum { N = 3 };
                const double courant = courants[c / COUNT(films) % COUNT(courants)], film = films[c % COUNT(films)];
                const double cliff = cliffs[c / COUNT(films) / COUNT(courants)];
                const double bed[N] = {1 + cliff, 1, 0}, depth[N] = {0, film, 1.05}, speed[N] = {0, -0.2, -0.1};
                if (basin_is_explicit(&ways[k]) && courant > 0.9) continue;
                cd_water* w = basin(N, 1, 1, 1, CD_FLOAT64);
                basin_set_way(w, &ways[k]);
                for (size_t i = 0; i < N; ++i) basin_set(w, CD_BED, at_last ? N - 1 - i : i, 0, bed[i]);
                for (size_t i = 0; i < N; ++i) basin_set(w, CD_DEPTH, at_last ? N - 1 - i : i, 0, depth[i]);
                for (size_t i = 1; i < N; ++i)
                    basin_set(w, CD_VELOCITY_X, at_last ? N - i : i, 0, at_last ? -speed[i] : speed[i]);
                double up = 0, most = 0;
                for (int step = 0; step < 4; ++step) {
                    basin_step(w, courant / sqrt(9.81), 1);
                    up = fmax(up, basin_get(w, CD_DEPTH, at_last ? N - 1 : 0, 0));
                    most = fmax(most, basin_get(w, CD_DEPTH, 1, 0));
                }
                if (!(up <= 0) || !(most > 1e-3))
                    fail_msg("%s, courant %g, film %g: %g m before a cliff of %g m and %g m on it", ways[k].name,
                             courant, film, most, cliff, up);
                cd_water_destroy(w);
            }
}

/* Air that presses cells dry, on flat beds and rough ones: the energy that there is in all, with what the pressure has
 * to give, rises by little more than what the pressure had, and by half of that of advected water. */
static void air_that_presses_water_dry_makes_little_energy(void** state) {
    (void)state;
    static const double heads[] = {2, 8, 50}, courants[] = {0.05, 0.3, 0.8, 2, 6, 30};
    for (int k = LINEAR; k <= ADVECTED; ++k)
        for (size_t c = 0; c < COUNT(heads) * COUNT(courants); ++c) {
            double worst = -HUGE_VAL;
            for (uint64_t scene = 1; scene <= 12; ++scene) {
                const size_t ny = scene % 3 ? 1 : NY, cells = NX * ny;
                const double courant = courants[c / COUNT(heads)], head = 9810 * heads[c % COUNT(heads)];
                double press[CELLS], depth[CELLS], start = 0, had = 0;
                uint64_t seed = scene;
                cd_water* w = basin(NX, ny, 0.5, 0.5, CD_FLOAT64);
                basin_set_way(w, &ways[k]);
                if (scene % 2) basin_random_bed(w, 0, 0.5, scene);
                for (size_t i = 0; i < cells; ++i) depth[i] = 1;
                basin_write(w, CD_SURFACE, depth);
                const size_t from = (size_t)(4 + 4 * random_number(&seed)), to = from + 1 + scene % 7;
                for (size_t i = 0; i < cells; ++i)
                    press[i] = i % NX >= from && i % NX < to && i / NX < 6 ? head * (1 - (double)(scene % 5) / 8) : 0;
                ok(cd_water_enable_field(w, CD_PRESSURE));
                basin_write(w, CD_PRESSURE, press);
                for (int step = 0; step <= 150; ++step) {
                    double given = 0;
                    if (step > 0) basin_step(w, courant * 0.5 / sqrt(9.81), 1);
                    basin_read(w, CD_DEPTH, depth);
                    for (size_t i = 0; i < cells; ++i) given += 0.25 * press[i] * depth[i];
                    if (step == 0) start = basin_energy(w) + given, had = given;
                    worst = fmax(worst, (basin_energy(w) + given - start) / had);
                }
                cd_water_destroy(w);
            }
            if (!(worst <= (k == ADVECTED ? 0.5 : 1.5)))
                fail_msg("%s, %g times the depth, courant %g: %g of what the pressure had", ways[k].name,
                         heads[c % COUNT(heads)], courants[c / COUNT(heads)], worst);
        }
}

/* ---- long runs --------------------------------------------------------------------------------------------------- */

static void a_lively_basin_calms_down_in_a_hundred_thousand_steps(void** state) {
    (void)state;
    static const int which[] = {LINEAR, ADVECTED, EXPLICIT_ADVECTED};
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
            assert_true(basin_kinetic(w) <= (p ? 1e-4 : 1e-3) * start);
            assert_near(basin_volume(w), volume, p ? 1e-12 : 4e-6, 0);
            cd_water_destroy(w);
        }
}

/* Steps in which waves cross ten thousand cells, over hills of all sizes: nothing is left that could lift water. */
static void water_among_hills_rests_after_steps_of_an_hour(void** state) {
    (void)state;
    enum { NX = 24, NY = 16 };
    for (size_t k = 0; k < WAYS; ++k)
        for (uint64_t seed = 1; seed <= 40; ++seed) {
            if (basin_is_explicit(&ways[k]) || !is_taken(seed + k, 3)) continue;
            uint64_t chance = seed * 77777;
            const double along = 0.7 + 0.5 * random_number(&chance), across = 0.7 + 0.5 * random_number(&chance);
            const double phase = 3 * random_number(&chance);
            double kinetic, potential, start;
            cd_water* w = basin(NX, NY, 1, 1, CD_FLOAT64);
            basin_set_way(w, &ways[k]);
            for (size_t c = 0; c < NX * NY; ++c) {
                const double x = (double)(c % NX), y = (double)(c / NX);
                const double bed = 1.5 * sin(along * x + phase) * cos(across * y) + 0.15 * (1 + random_number(&chance));
                basin_set(w, CD_BED, c % NX, c / NX, bed);
                basin_set(w, CD_DEPTH, c % NX, c / NX, fmax(0, 0.5 * sin(0.3 * x + phase) - bed));
            }
            ok(cd_water_get_energy(w, &kinetic, &start));
            double most = 0;
            for (int s = 0; s < 60; ++s) {
                basin_step(w, 2600, 1);
                ok(cd_water_get_energy(w, &kinetic, &potential));
                most = fmax(most, kinetic / fabs(start));
            }
            if (most > 0.1)
                print_message("%s, number %d: kinetic energy %.2g of the potential\n", ways[k].name, (int)seed, most);
            assert_true(most <= 0.1);
            cd_water_destroy(w);
        }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(water_among_hills_rests_after_steps_of_an_hour),
        cmocka_unit_test(no_energy_is_made_but_by_linear_momentum_that_deepens),
        cmocka_unit_test(long_advected_steps_make_no_energy),
        cmocka_unit_test(long_steps_that_rub_make_no_energy),
        cmocka_unit_test(water_among_cliffs_makes_little_energy),
        cmocka_unit_test(what_comes_to_dry_ground_climbs_no_cliff),
        cmocka_unit_test(air_that_presses_water_dry_makes_little_energy),
        cmocka_unit_test(a_lively_basin_calms_down_in_a_hundred_thousand_steps),
    };
    return cmocka_run_group_tests_name("water energy", tests, NULL, NULL);
}
