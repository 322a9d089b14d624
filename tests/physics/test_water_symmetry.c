/* Water does not know which way x runs, nor x from y, nor where a ring begins. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "basin.h"
#include "check.h"
#include "reference.h"

enum { NX = 14, NY = 11, CELLS = NX * NY, MOST = (NX + 1) * (NY + 1) };

enum view { TRANSPOSED, MIRRORED_X, MIRRORED_Y, ROLLED, VIEWS }; /* rolled: rings that begin somewhere else */
static const char* const view_names[VIEWS] = {"x and y swapped", "x reversed", "y reversed", "rolled"};
enum { ROLLED_BY_X = 5, ROLLED_BY_Y = 4 };

/* The field that `field` is when seen so, and whether its numbers change sign. */
static cd_field field_seen(enum view view, cd_field field) {
    if (view != TRANSPOSED) return field;
    static const cd_field pairs[][2] = {
        {CD_VELOCITY_X, CD_VELOCITY_Y}, {CD_FORCE_X, CD_FORCE_Y}, {CD_WALL_X, CD_WALL_Y}};
    for (size_t p = 0; p < COUNT(pairs); ++p)
        for (int k = 0; k < 2; ++k)
            if (field == pairs[p][k]) return pairs[p][1 - k];
    return field;
}
static double sign_seen(enum view view, cd_field field) {
    if (view == MIRRORED_X && (field == CD_VELOCITY_X || field == CD_FORCE_X)) return -1;
    return view == MIRRORED_Y && (field == CD_VELOCITY_Y || field == CD_FORCE_Y) ? -1 : 1;
}

/* Numbers of a field of n_x x n_y, as seen. */
static void see(enum view view, double sign, size_t n_x, size_t n_y, const double* from, double* to) {
    for (size_t j = 0; j < n_y; ++j)
        for (size_t i = 0; i < n_x; ++i) {
            size_t at = i * n_y + j, is = j * n_x + i;
            if (view == MIRRORED_X) at = j * n_x + n_x - 1 - i;
            if (view == MIRRORED_Y) at = (n_y - 1 - j) * n_x + i;
            if (view == ROLLED) at = is, is = (j + ROLLED_BY_Y) % NY * n_x + (i + ROLLED_BY_X) % NX;
            to[at] = sign * from[is] + 0.0; /* no -0 */
        }
}

static void extent(cd_field field, size_t* n_x, size_t* n_y) {
    *n_x = NX + (field == CD_VELOCITY_X || field == CD_FORCE_X || field == CD_WALL_X);
    *n_y = NY + (field == CD_VELOCITY_Y || field == CD_FORCE_Y || field == CD_WALL_Y);
}

static const cd_field copied[] = {CD_MASK,       CD_WALL_X, CD_WALL_Y,   CD_BED,     CD_DEPTH,  CD_VELOCITY_X,
                                  CD_VELOCITY_Y, CD_SOURCE, CD_PRESSURE, CD_FORCE_X, CD_FORCE_Y};

static int has(const cd_water* w, cd_field field) {
    double value;
    return cd_water_read_f64(w, field, 0, 0, 1, 1, &value, 1) == CD_OK;
}

/* What the scenes have besides a bed and water. */
enum extra { PLAIN, WET, RINGS, WET_RINGS, SIDES, PUSHED, WALLED, EXTRAS };
static const char* const extra_names[EXTRAS] = {"plain", "wet", "rings", "wet rings", "sides", "pushed", "walled"};

static cd_water* scene(const struct way* way, enum extra extra, uint64_t seed, cd_precision precision) {
    double values[MOST];
    size_t n_x, n_y;
    cd_water* w = basin(NX, NY, 0.5, 0.7, precision);
    basin_set_way(w, way);
    basin_random_bed(w, 1, 2, seed);
    if (extra == RINGS || extra == WET_RINGS) {
        ok(cd_water_set_side(w, CD_SIDE_X_FIRST, CD_BORDER_PERIODIC, 0, 0));
        ok(cd_water_set_side(w, CD_SIDE_Y_FIRST, CD_BORDER_PERIODIC, 0, 0));
    }
    if (extra == SIDES) {
        ok(cd_water_set_side(w, CD_SIDE_X_FIRST, CD_BORDER_OPEN, 0.7, 0.02));
        ok(cd_water_set_side(w, CD_SIDE_Y_FIRST, CD_BORDER_OPEN, 0.4, 0));
        ok(cd_water_set_side(w, CD_SIDE_Y_LAST, CD_BORDER_INFLOW, 0.1, 0.03));
        ok(cd_water_set_inflow_depth(w, CD_SIDE_Y_LAST, seed % 2 ? 0.05 : 0));
    }
    if (extra == PUSHED) {
        static const cd_field pushes[] = {CD_SOURCE, CD_PRESSURE, CD_FORCE_X, CD_FORCE_Y};
        for (size_t f = 0; f < COUNT(pushes); ++f) {
            extent(pushes[f], &n_x, &n_y);
            for (size_t k = 0; k < n_x * n_y; ++k)
                values[k] = random_number(&seed) * (f == 0 ? 0.05 : f == 1 ? 500 : 1);
            ok(cd_water_enable_field(w, pushes[f]));
            basin_write(w, pushes[f], values);
        }
        ok(cd_water_set_drag(w, 0.1));
        ok(cd_water_set_manning(w, 0.03));
    }
    if (extra == WALLED)
        for (cd_field f = CD_WALL_X; f <= CD_WALL_Y; ++f) {
            extent(f, &n_x, &n_y);
            for (size_t k = 0; k < n_x * n_y; ++k) {
                const size_t i = k % n_x, j = k / n_x;
                const int inside = f == CD_WALL_X ? i > 0 && i < NX : j > 0 && j < NY;
                values[k] = inside && random_number(&seed) > 0.7;
            }
            ok(cd_water_enable_field(w, f));
            basin_write(w, f, values);
        }
    if (extra == WALLED) {
        for (size_t k = 0; k < CELLS; ++k) values[k] = random_number(&seed) < 0.8;
        ok(cd_water_enable_field(w, CD_MASK));
        basin_write(w, CD_MASK, values);
    }
    for (size_t j = 0; j < NY; ++j)
        for (size_t i = 0; i < NX; ++i)
            basin_set(
                w, CD_SURFACE, i, j,
                (extra == WET || extra == WET_RINGS ? 2 : 0.6) + 0.3 * sin(0.9 * (double)i) * cos(0.7 * (double)j));
    for (int axis = 0; axis < 2; ++axis)
        for (size_t j = axis ? 1 : 0; j < NY; ++j)
            for (size_t i = axis ? 0 : 1; i < NX; ++i) {
                const double u = 0.8 * random_number(&seed);
                (void)cd_water_write_f64(w, axis ? CD_VELOCITY_Y : CD_VELOCITY_X, i, j, 1, 1, &u, 1);
            }
    return w;
}

static cd_water* view_of(const cd_water* from, enum view view, const struct way* way, cd_precision precision) {
    const int swap = view == TRANSPOSED;
    double values[MOST], as_seen[MOST], drag, manning;
    int32_t first;
    size_t n_x, n_y;
    cd_water* to = swap ? basin(NY, NX, 0.7, 0.5, precision) : basin(NX, NY, 0.5, 0.7, precision);
    basin_set_way(to, way);
    ok(cd_water_get_first(from, &first));
    ok(cd_water_set_first(to, swap ? 1 - first : first));
    ok(cd_water_get_drag(from, &drag));
    ok(cd_water_set_drag(to, drag));
    ok(cd_water_get_manning(from, &manning));
    ok(cd_water_set_manning(to, manning));
    for (cd_side s = 0; s < 4; ++s) {
        cd_border kind;
        double value, rate, depth;
        cd_side as = swap ? (s + 2) % 4 : s;
        if ((view == MIRRORED_X && s < 2) || (view == MIRRORED_Y && s >= 2)) as = s ^ 1;
        ok(cd_water_get_side(from, s, &kind, &value, &rate));
        if (kind != CD_BORDER_WALL) ok(cd_water_set_side(to, as, kind, value, rate));
        ok(cd_water_get_inflow_depth(from, s, &depth));
        ok(cd_water_set_inflow_depth(to, as, depth));
    }
    for (size_t f = 0; f < COUNT(copied); ++f) {
        if (!has(from, copied[f])) continue;
        const cd_field as = field_seen(view, copied[f]);
        extent(copied[f], &n_x, &n_y);
        basin_read(from, copied[f], values);
        see(view, sign_seen(view, copied[f]), n_x, n_y, values, as_seen);
        ok(cd_water_enable_field(to, as));
        basin_write(to, as, as_seen);
    }
    return to;
}

/* The largest difference of depths between the water and its view; -1 if every bit is the same, velocities included: on
 * a film that is there but for rounding, or not, a velocity may be anything. */
static double apart(const struct way* way, enum extra extra, enum view view, uint64_t seed, double dt, int steps,
                    cd_precision precision) {
    cd_water* w = scene(way, extra, seed, precision);
    cd_water* other = view_of(w, view, way, precision);
    double values[MOST], as_seen[MOST], seen[MOST], off = 0;
    int same = 1;
    size_t n_x, n_y;
    for (int s = 0; s < steps; ++s) basin_step(w, dt, 1), basin_step(other, dt, 1);
    for (cd_field f = CD_DEPTH; f <= CD_VELOCITY_Y; ++f) {
        if (f == CD_BED || f == CD_SURFACE) continue;
        extent(f, &n_x, &n_y);
        basin_read(w, f, values);
        see(view, sign_seen(view, f), n_x, n_y, values, as_seen);
        basin_read(other, field_seen(view, f), seen);
        for (size_t k = 0; k < n_x * n_y; ++k) same &= as_seen[k] == seen[k];
        for (size_t k = 0; k < n_x * n_y && f == CD_DEPTH; ++k) off = fmax(off, fabs(as_seen[k] - seen[k]));
    }
    cd_water_destroy(w);
    cd_water_destroy(other);
    return same ? -1 : off;
}

/* Transposed scenes that begin the other way round. */
static void a_transposed_scene_is_the_same_to_the_bit(void** state) {
    (void)state;
    for (size_t k = 0; k < WAYS; ++k)
        for (int extra = 0; extra < EXTRAS; ++extra)
            for (uint64_t seed = 1; seed <= 5; ++seed) {
                const double dt = basin_is_explicit(&ways[k]) ? 0.03 : seed % 2 ? 0.1 : 1;
                const cd_precision precision = seed == 4 ? CD_FLOAT32 : CD_FLOAT64;
                const double off = apart(&ways[k], (enum extra)extra, TRANSPOSED, seed, dt, 100, precision);
                if (off > -1)
                    print_message("%s, %s, number %d: apart by %.1e\n", ways[k].name, extra_names[extra], (int)seed,
                                  off);
                assert_true(off == -1);
            }
}

static void mirrored_scenes_stay_each_others_image(void** state) {
    (void)state;
    for (size_t k = 0; k < WAYS; ++k)
        for (int view = MIRRORED_X; view <= MIRRORED_Y; ++view)
            for (int extra = 0; extra < EXTRAS; ++extra) {
                double worst = 0;
                for (uint64_t seed = 1; seed <= 5; ++seed) {
                    const double dt = basin_is_explicit(&ways[k]) ? 0.03 : 0.05;
                    const double off = apart(&ways[k], (enum extra)extra, (enum view)view, seed, dt, 20, CD_FLOAT64);
                    worst = fmax(worst, off);
                }
                if (worst > 1e-9)
                    print_message("%-17s %-7s %s: apart by %.1e\n", ways[k].name, extra_names[extra], view_names[view],
                                  worst);
                /* at shores a face may be wet or not but for rounding, and what goes with the water changes with that */
                const int wet = extra == WET || extra == WET_RINGS, plain = wet || extra == PLAIN || extra == RINGS;
                assert_true(worst <= (wet ? 1e-12 : plain ? 1e-7 : 1e-5));
            }
}

/* What is absent or stands behind a wall does not act: cells of a larger lattice that are cut off from the rest, by
 * absent cells or by walls, are a water of their own, to the bit where they are wet. */
static void what_is_cut_off_is_a_water_of_its_own(void** state) {
    (void)state;
    enum { BEFORE_X = 3, ALL_X = NX + 5, ALL = (ALL_X + 1) * (NY + 5) };
    static const char* const names[] = {"absent cells", "walls", "walls along y"};
    for (size_t k = 0; k < WAYS * COUNT(names) * 5; ++k) {
        const struct way* const way = &ways[k % WAYS];
        const int by = k / WAYS % COUNT(names), longer = !by && !basin_is_explicit(way);
        const size_t before_y = by == 2 ? 0 : 2, all_y = NY + 2 * before_y, count = ALL_X * all_y;
        uint64_t seed = 1 + k / WAYS / COUNT(names);
        double values[ALL], seen[MOST], ones[MOST];
        size_t n_x, n_y;
        cd_water* w = scene(way, WET, seed, CD_FLOAT64);
        cd_water* all = basin(ALL_X, all_y, 0.5, 0.7, CD_FLOAT64);
        basin_set_way(all, way);
        for (size_t i = 0; i < ALL; ++i) values[i] = 0.5 + 0.5 * random_number(&seed);
        for (size_t i = 0; i < MOST; ++i) ones[i] = 1;
        ok(cd_water_write_f64(all, CD_BED, 0, 0, ALL_X, all_y, values, count));
        if (by) ok(cd_water_write_f64(all, CD_DEPTH, 0, 0, ALL_X, all_y, values, count));
        ok(cd_water_write_f64(all, CD_VELOCITY_Y, 0, 1, ALL_X, all_y - 1, values, count - ALL_X));
        for (size_t i = 0; i < ALL; ++i) values[i] = 0;
        if (!by) {
            ok(cd_water_enable_field(all, CD_MASK));
            ok(cd_water_write_f64(all, CD_MASK, 0, 0, ALL_X, all_y, values, count));
            ok(cd_water_write_f64(all, CD_MASK, BEFORE_X, before_y, NX, NY, ones, CELLS));
        }
        for (size_t f = 0; f < COUNT(copied); ++f) {
            if (!has(w, copied[f])) continue;
            extent(copied[f], &n_x, &n_y);
            basin_read(w, copied[f], values);
            ok(cd_water_write_f64(all, copied[f], BEFORE_X, before_y, n_x, n_y, values, n_x * n_y));
        }
        for (size_t last = 0; by && last < 2; ++last) {
            ok(cd_water_enable_field(all, CD_WALL_X));
            ok(cd_water_write_f64(all, CD_WALL_X, BEFORE_X + last * NX, before_y, 1, NY, ones, NY));
            if (by == 2) continue;
            ok(cd_water_enable_field(all, CD_WALL_Y));
            ok(cd_water_write_f64(all, CD_WALL_Y, BEFORE_X, before_y + last * NY, NX, 1, ones, NX));
        }
        for (int n = 0; n < 20; ++n) basin_step(w, longer ? 0.3 : 0.03, 1), basin_step(all, longer ? 0.3 : 0.03, 1);
        int same = 1;
        for (cd_field f = CD_DEPTH; f <= CD_VELOCITY_Y; ++f) {
            if (f == CD_BED || f == CD_SURFACE) continue;
            extent(f, &n_x, &n_y);
            basin_read(w, f, seen);
            ok(cd_water_read_f64(all, f, BEFORE_X, before_y, n_x, n_y, values, n_x * n_y));
            for (size_t i = 0; i < n_x * n_y; ++i) same &= values[i] == seen[i];
        }
        if (!same) print_message("%s, cut off by %s: not the same\n", way->name, names[by]);
        assert_true(same);
        cd_water_destroy(w);
        cd_water_destroy(all);
    }
}

static void a_ring_may_begin_anywhere(void** state) {
    (void)state;
    for (size_t k = 0; k < WAYS; ++k)
        for (enum extra extra = RINGS; extra <= WET_RINGS; ++extra)
            for (int longer = 0; longer < 2; ++longer) {
                double worst = 0;
                for (uint64_t seed = 1; seed <= 5; ++seed) {
                    const double dt = basin_is_explicit(&ways[k]) ? 0.03 : longer ? 0.5 : 0.05;
                    worst = fmax(worst, apart(&ways[k], extra, ROLLED, seed, dt, 20, CD_FLOAT64));
                }
                if (worst > 1e-14)
                    print_message("%-17s %-9s %s steps: apart by %.1e\n", ways[k].name, extra_names[extra],
                                  longer ? "long" : "short", worst);
                assert_true(worst <= (extra == WET_RINGS ? 1e-13 : 1e-7));
            }
}

/* A ring whose cells give more in a step than they have, and the same ring written down twice. */
static void twice_the_ring_is_the_same_ring(void** state) {
    (void)state;
    enum { MOST = 5 };
    /* decades of depths, mean speed and how far others are from it, dt; at most 60 cells a step */
    static const double scenes[][4] = {{4, 0.2, 0.19, 5}, {2, 3, 2.9, 10}, {1, 30, 20, 0.1}};
    for (size_t k = 0; k < WAYS * COUNT(scenes); ++k) {
        const double* const scene = scenes[k % COUNT(scenes)];
        const struct way* const way = &ways[k / COUNT(scenes)];
        if (basin_is_explicit(way)) continue;
        double worst = 0;
        for (size_t n = 2; n <= MOST; ++n)
            for (uint64_t seed = 1; seed <= 20; ++seed) {
                double depth[MOST] = {0};
                for (int twice = 0; twice < 2; ++twice) {
                    uint64_t random = seed;
                    cd_water* w = basin(n * (size_t)(1 + twice), 1, 1, 1, CD_FLOAT64);
                    basin_set_way(w, way);
                    ok(cd_water_set_side(w, CD_SIDE_X_FIRST, CD_BORDER_PERIODIC, 0, 0));
                    for (size_t i = 0; i < n; ++i) {
                        const double d = pow(10, scene[0] * (random_number(&random) - 1));
                        const double u = scene[1] + scene[2] * random_number(&random);
                        for (size_t at = i; at < n * (size_t)(1 + twice); at += n)
                            basin_set(w, CD_DEPTH, at, 0, d), basin_set(w, CD_VELOCITY_X, at, 0, u);
                    }
                    basin_step(w, scene[3], 3);
                    for (size_t i = 0; i < n; ++i) {
                        const double now = basin_get(w, CD_DEPTH, i, 0);
                        if (twice) worst = fmax(worst, fabs(now - depth[i]));
                        depth[i] = now;
                    }
                    cd_water_destroy(w);
                }
            }
        print_message("%-17s the ring twice over: apart by %.1e\n", way->name, worst);
        assert_true(worst < 1e-12);
    }
}

/* ---- sides ------------------------------------------------------------------------------------------------------- */

/* A cell between two sides is the mirror image of itself between them the other way round. */
static void a_single_cell_between_two_sides_is_its_own_image(void** state) {
    (void)state;
    for (size_t k = 0; k < WAYS; ++k)
        for (uint64_t scene = 1; scene <= 60; ++scene)
            for (int along_y = 0; along_y < 2; ++along_y) {
                const size_t kinds[2] = {scene % 3, scene / 3 % 3};
                static const cd_border all[] = {CD_BORDER_OPEN, CD_BORDER_LEVEL, CD_BORDER_INFLOW};
                uint64_t seed = scene;
                const double depth = 0.6 + 0.5 * random_number(&seed);
                const double values[2] = {random_number(&seed), random_number(&seed)};
                cd_water* w[2];
                for (int back = 0; back < 2; ++back) {
                    w[back] = basin(1, 1, 1, 1, CD_FLOAT64);
                    basin_set_way(w[back], &ways[k]);
                    basin_set(w[back], CD_DEPTH, 0, 0, depth);
                    for (int last = 0; last < 2; ++last)
                        ok(cd_water_set_side(w[back], line_side(along_y, last), all[kinds[last ^ back]],
                                             values[last ^ back], 0.05));
                }
                for (int step = 0; step < 40; ++step) {
                    const double dt = (1.2 + random_number(&seed)) * (basin_is_explicit(&ways[k]) ? 0.05 : 0.2);
                    const cd_field u = line_field(along_y, CD_VELOCITY_X);
                    basin_step(w[0], dt, 1), basin_step(w[1], dt, 1);
                    assert_near(basin_get(w[1], CD_DEPTH, 0, 0), basin_get(w[0], CD_DEPTH, 0, 0), 1e-12, 1);
                    for (size_t face = 0; face < 2; ++face)
                        assert_near(-basin_get(w[1], u, along_y ? 0 : face, along_y ? face : 0),
                                    basin_get(w[0], u, along_y ? 0 : 1 - face, along_y ? 1 - face : 0), 1e-12, 1);
                }
                cd_water_destroy(w[0]);
                cd_water_destroy(w[1]);
            }
}

/* A low heap in a cell between two open sides falls as waves leave through both: by exp(-2 c t / dx). */
static void a_cell_between_two_open_sides_empties_in_time(void** state) {
    (void)state;
    for (size_t k = 0; k < WAYS; ++k) {
        const double c = sqrt(9.81), heap = 1e-4, dt = 0.01 / c;
        cd_water* w = basin(1, 1, 1, 1, CD_FLOAT64);
        basin_set_way(w, &ways[k]);
        basin_set(w, CD_DEPTH, 0, 0, 1 + heap);
        for (int last = 0; last < 2; ++last) ok(cd_water_set_side(w, line_side(0, last), CD_BORDER_OPEN, 1, 0));
        basin_step(w, dt, 50);
        assert_near((basin_get(w, CD_DEPTH, 0, 0) - 1) / heap, exp(-1), 0.02, 0);
        cd_water_destroy(w);
    }
}

/* Cells between a side of any kind and a wall within the water are those of a water that ends at the wall, to the bit: a
 * single one too. */
static void what_a_wall_cuts_off_at_a_side_is_a_water_of_its_own(void** state) {
    (void)state;
    static const cd_border kinds[] = {CD_BORDER_OPEN, CD_BORDER_LEVEL, CD_BORDER_INFLOW};
    for (size_t k = 0; k < WAYS * COUNT(kinds) * 24; ++k) {
        const struct way* const way = &ways[k % WAYS];
        const cd_border kind = kinds[k / WAYS % COUNT(kinds)];
        uint64_t seed = 1 + k / WAYS / COUNT(kinds);
        const int last = seed % 2, along_y = seed / 2 % 2;
        const size_t cells = 1 + seed % 3, behind = 3;
        const double side = random_number(&seed), dt = basin_is_explicit(way) ? 0.03 : 0.3;
        cd_water* w[2];
        for (int walled = 0; walled < 2; ++walled) {
            const size_t n = walled ? cells + behind : cells;
            w[walled] = along_y ? basin(1, n, 1, 0.5, CD_FLOAT64) : basin(n, 1, 0.5, 1, CD_FLOAT64);
            basin_set_way(w[walled], way);
            ok(cd_water_set_side(w[walled], line_side(along_y, last), kind, side, 0.05));
            const size_t wall = last ? behind : cells;
            if (!walled) continue;
            ok(cd_water_enable_field(w[1], line_field(along_y, CD_WALL_X)));
            basin_set(w[1], line_field(along_y, CD_WALL_X), along_y ? 0 : wall, along_y ? wall : 0, 1);
        }
        const size_t off = last ? behind : 0;
        for (size_t i = 0; i < cells; ++i) {
            const double depth = 0.6 + 0.5 * random_number(&seed);
            basin_set(w[0], CD_DEPTH, along_y ? 0 : i, along_y ? i : 0, depth);
            basin_set(w[1], CD_DEPTH, along_y ? 0 : off + i, along_y ? off + i : 0, depth);
        }
        for (int step = 0; step < 20; ++step) {
            basin_step(w[0], dt, 1), basin_step(w[1], dt, 1);
            for (size_t i = 0; i < cells; ++i)
                assert_true(basin_get(w[0], CD_DEPTH, along_y ? 0 : i, along_y ? i : 0) ==
                            basin_get(w[1], CD_DEPTH, along_y ? 0 : off + i, along_y ? off + i : 0));
        }
        cd_water_destroy(w[0]);
        cd_water_destroy(w[1]);
    }
}

/* A boat near a side moves as its mirror image does at the opposite one, in steps of any length. */
static void a_boat_at_a_side_is_its_own_image(void** state) {
    (void)state;
    enum { N = 16, M = 12 };
    const double size = 0.5, length = N * size;
    for (int k = LINEAR; k <= ADVECTED; ++k)
        for (uint64_t scene = 1; scene <= 60; ++scene) {
            cd_water* w[2];
            double pose[2][7], heights[2];
            uint64_t seed = 0;
            for (int back = 0; back < 2; ++back) {
                const double sign = back ? -1 : 1;
                seed = scene;
                w[back] = basin(N, M, size, size, CD_FLOAT64);
                basin_set_way(w[back], &ways[k]);
                ok(cd_water_add_volume_rectangle(w[back], 0, 0, N, M, N * M * size * size, NULL));
                const double x = (0.5 + 0.5 * random_number(&seed)) * length;
                ok(cd_water_splash(w[back], back ? length - x : x, 2, 1, 0.5));
                const double long_by = 1.5 + random_number(&seed), from = 0.7 + 0.7 * random_number(&seed);
                const double to_x = random_number(&seed), to_y = random_number(&seed), mass = 100 * pow(10, to_x);
                const double at[7] = {back ? length - from : from, 3, 0.9, sign * to_x, to_y, 0.05, sign * 0.03};
                const double speed[6] = {sign * 2 * random_number(&seed), 0.5, -0.2, sign * random_number(&seed)};
                ok(cd_water_set_hulls(w[back], 1, 4, 2));
                ok(cd_water_set_hull(w[back], 0, mass, long_by, 0.8, NULL, 8));
                ok(cd_water_set_hull_pose(w[back], 0, at, 7));
                ok(cd_water_set_hull_velocity(w[back], 0, speed, 6));
            }
            for (int step = 0; step < 8; ++step) {
                const double dt = 0.15 * pow(4, random_number(&seed));
                for (int back = 0; back < 2; ++back) {
                    basin_step(w[back], dt, 1);
                    ok(cd_water_get_hull_pose(w[back], 0, pose[back], 7));
                    heights[back] = basin_get(w[back], CD_DEPTH, back ? N - 1 : 0, 6);
                }
                assert_near(length - pose[1][0], pose[0][0], 1e-7, 1);
                for (int number = 1; number < 7; ++number)
                    assert_near((number == 3 || number == 6 ? -1 : 1) * pose[1][number], pose[0][number], 1e-7, 1);
                assert_near(heights[1], heights[0], 1e-7, 1);
            }
            cd_water_destroy(w[0]);
            cd_water_destroy(w[1]);
        }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_transposed_scene_is_the_same_to_the_bit),
        cmocka_unit_test(mirrored_scenes_stay_each_others_image),
        cmocka_unit_test(what_is_cut_off_is_a_water_of_its_own),
        cmocka_unit_test(a_ring_may_begin_anywhere),
        cmocka_unit_test(twice_the_ring_is_the_same_ring),
        cmocka_unit_test(a_single_cell_between_two_sides_is_its_own_image),
        cmocka_unit_test(a_cell_between_two_open_sides_empties_in_time),
        cmocka_unit_test(what_a_wall_cuts_off_at_a_side_is_a_water_of_its_own),
        cmocka_unit_test(a_boat_at_a_side_is_its_own_image),
    };
    return cmocka_run_group_tests_name("water symmetry", tests, NULL, NULL);
}
