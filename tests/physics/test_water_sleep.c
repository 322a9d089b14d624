/* Water that sleeps: it is what it was, it costs nothing, it wakes before waves reach it, and which parts of it sleep
 * follows from its state alone. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "basin.h"
#include "check.h"
#include "jobs.h"
#include "pool.h"
#include "scene.h"

enum { N = 160, M = 112, CELLS = N * M };
static const double height = 1e-3;

/* 1 m deep in the mean, with an island, or two at the sides. */
static double bumpy(double x, double y, const void* user) {
    (void)user;
    return -1 + 0.3 * cos(0.11 * x) * sin(0.07 * y) + 1.6 * exp(-((x - 120) * (x - 120) + (y - 30) * (y - 30)) / 90);
}
static double level(double x, double y, const void* user) { return (void)x, (void)y, (void)user, 0; }

static cd_water* lake(size_t n, size_t m, cd_precision precision, const struct way* way) {
    cd_water* w = basin(n, m, 1, 1, precision);
    basin_set_way(w, way);
    basin_fill(w, CD_BED, bumpy, NULL);
    basin_fill(w, CD_SURFACE, level, NULL);
    ok(cd_water_restart_account(w));
    return w;
}

/* 1 m deep everywhere. */
static void flatten(cd_water* w) {
    basin_fill(w, CD_BED, level, NULL);
    basin_fill(w, CD_DEPTH, level, NULL);
    ok(cd_water_add_volume_rectangle(w, 0, 0, N, M, CELLS, NULL));
}

static size_t awake(const cd_water* w) {
    size_t cells = SIZE_MAX;
    ok(cd_water_get_awake(w, &cells));
    return cells;
}

/* The largest difference of depths. */
static double apart(const cd_water* a, const cd_water* b) {
    static double here[CELLS], there[CELLS];
    double most = 0;
    basin_read(a, CD_DEPTH, here), basin_read(b, CD_DEPTH, there);
    for (size_t k = 0; k < basin_count(a, CD_DEPTH); ++k) most = fmax(most, fabs(here[k] - there[k]));
    return most;
}

static void a_lake_at_rest_sleeps(void** state) {
    (void)state;
    for (size_t way = 0; way < WAYS; ++way)
        for (cd_precision precision = CD_FLOAT32; precision <= CD_FLOAT64; ++precision) {
            cd_water* w = lake(N, M, precision, &ways[way]);
            basin_set(w, CD_DEPTH, 120, 31, height / 2); /* a film on the island */
            assert_int_equal(awake(w), CELLS);
            basin_step(w, 0.1, 1);
            assert_int_equal(awake(w), CELLS);
            ok(cd_water_set_sleep(w, height));
            uint64_t before = 0, after = 0;
            ok(cd_water_get_factorizations(w, &before));
            basin_step(w, 0.1, 40);
            ok(cd_water_get_factorizations(w, &after));
            assert_int_equal(awake(w), 0);
            assert_int_equal(after, before);
            for (int along_y = 0; along_y < 2; ++along_y) { /* what falls asleep stops, round a periodic side too */
                const cd_field field = along_y ? CD_VELOCITY_Y : CD_VELOCITY_X;
                if (precision) ok(cd_water_set_side(w, line_side(along_y, 0), CD_BORDER_PERIODIC, 0, 0));
                basin_set(w, field, 20, 20, height), basin_set(w, field, 90, 80, -height);
                if (precision) basin_set(w, field, along_y ? 20 : 0, along_y ? 0 : 20, height);
            }
            basin_step(w, 0.1, 1);
            assert_int_equal(awake(w), 0);
            assert_true(basin_largest(w, CD_VELOCITY_X) == 0 && basin_largest(w, CD_VELOCITY_Y) == 0);
            ok(cd_water_set_sleep(w, 0));
            basin_step(w, 0.1, 1);
            assert_int_equal(awake(w), CELLS);
            cd_water_destroy(w);
        }
}

/* Waves are those of water that never sleeps, but for some of the height; no volume is lost and no energy gained. */
static void waves_wake_what_is_ahead_of_them(void** state) {
    (void)state;
    static const double courants[] = {0.1, 0.5, 2, 20};
    for (size_t way = 0; way < WAYS; ++way)
        for (cd_precision precision = CD_FLOAT32; precision <= CD_FLOAT64; ++precision)
            for (size_t c = 0; c < COUNT(courants); ++c) {
                const double dt = courants[c] / sqrt(9.81);
                if (basin_is_explicit(&ways[way]) && courants[c] > 0.5) continue;
                if (!is_taken(way + c + (size_t)precision, 2)) continue;
                cd_water *w = lake(N, M, precision, &ways[way]), *never = lake(N, M, precision, &ways[way]);
                if (courants[c] > 1) flatten(w), flatten(never); /* the energy bound of long steps is one of runs */
                ok(cd_water_set_sleep(w, height));
                const double radius = courants[c] < 1 ? 5 : 12;
                ok(cd_water_splash(w, 30, 40, radius, 0.5));
                ok(cd_water_splash(never, 30, 40, radius, 0.5));
                const double energy = basin_energy(w);
                basin_step(w, dt, 1), basin_step(never, dt, 1);
                if (courants[c] < 1) assert_true(awake(w) > 0 && awake(w) <= CELLS / 3);
                const size_t steps = (size_t)ceil(20 / courants[c]) + 2;
                for (size_t s = 0; s < steps; ++s) {
                    basin_step(w, dt, 1), basin_step(never, dt, 1);
                    const double off = apart(w, never);
                    if (off > height)
                        fail_msg("%s, float%d, Courant %g, step %zu: %g m apart", ways[way].name, precision ? 64 : 32,
                                 courants[c], s, off);
                }
                assert_true(fabs(basin_volume_off(w)) < (precision ? 1e-13 : 1e-7));
                if (ways[way].momentum == CD_MOMENTUM_ADVECTED)
                    assert_true(basin_energy(w) <= energy + 1e-9 * fabs(energy));
                cd_water_destroy(w);
                cd_water_destroy(never);
            }
}

/* Water that runs many cells in a step wakes all that it runs into: waves in it cross less than one. */
static void fast_water_wakes_what_it_runs_into(void** state) {
    (void)state;
    static const double runs[] = {0.5, 14, 31}, gravities[] = {0, 0.01};
    for (size_t way = 0; way < WAYS; ++way)
        for (size_t r = 0; r < COUNT(runs) * COUNT(gravities); ++r)
            for (int back = 0; back < 2; ++back) {
                static double u[(N + 1) * M], depth[CELLS];
                cd_water* w[2];
                for (int b = 0; b < 2; ++b) {
                    w[b] = lake(N, M, CD_FLOAT64, &ways[way]);
                    ok(cd_water_set_gravity(w[b], gravities[r % COUNT(gravities)]));
                    basin_fill(w[b], CD_BED, level, NULL);
                    for (size_t k = 0; k < COUNT(u); ++k) {
                        const size_t i = back ? N - k % (N + 1) : k % (N + 1), j = k / (N + 1);
                        u[k] = i >= 20 && i <= 40 && j < 5 ? (back ? -1 : 1) * runs[r / COUNT(gravities)] : 0;
                    }
                    for (size_t k = 0; k < CELLS; ++k) depth[k] = u[k / N * (N + 1) + k % N] != 0 ? 1 : 0.02;
                    basin_write(w[b], CD_DEPTH, depth);
                    basin_write(w[b], CD_VELOCITY_X, u);
                    if (b == 0) ok(cd_water_set_sleep(w[b], height));
                }
                for (int s = 0; s < 6; ++s) {
                    basin_step(w[0], 1, 1), basin_step(w[1], 1, 1);
                    assert_true(awake(w[0]) > 0 && (!basin_is_explicit(&ways[way]) || awake(w[0]) < CELLS));
                    if (apart(w[0], w[1]) > height)
                        fail_msg("%s, %g cells, step %d: %g m apart", ways[way].name, runs[r / COUNT(gravities)], s,
                                 apart(w[0], w[1]));
                }
                cd_water_destroy(w[0]);
                cd_water_destroy(w[1]);
            }
}

/* Friction ends it all, the shores too. */
static void it_falls_asleep_again(void** state) {
    (void)state;
    for (size_t way = 0; way < WAYS; ++way) {
        if (basin_is_explicit(&ways[way])) continue;
        cd_water* w = lake(64, 48, CD_FLOAT64, &ways[way]);
        ok(cd_water_set_sleep(w, height));
        ok(cd_water_set_drag(w, 0.2));
        ok(cd_water_splash(w, 30, 20, 8, 0.5));
        basin_step(w, 0.2, 1);
        assert_true(awake(w) > 0);
        size_t steps = 0;
        for (; awake(w) > 0 && steps < 2000; ++steps) basin_step(w, 0.2, 1);
        if (awake(w) > 0) fail_msg("%s: %zu cells are awake after 400 s", ways[way].name, awake(w));
        double surface[64 * 48];
        basin_read(w, CD_SURFACE, surface);
        for (size_t k = 0; k < COUNT(surface); ++k)
            if (basin_get(w, CD_DEPTH, k % 64, k / 64) > 0.1 && fabs(surface[k]) > 4 * height)
                fail_msg("%s: %g m from level", ways[way].name, surface[k]);
        ok(cd_water_splash(w, 50, 40, 3, 0.3));
        basin_step(w, 0.2, 1);
        assert_true(awake(w) > 0);
        cd_water_destroy(w);
    }
}

/* ---- what sleeps follows from the state ---- */

/* Something that happens to a water, the same for the same number. */
static void happens(cd_water* w, uint64_t which) {
    uint64_t seed = which;
    size_t n, m;
    ok(cd_water_get_shape(w, &n, &m, NULL, NULL, NULL));
    double number[4];
    for (size_t k = 0; k < COUNT(number); ++k) number[k] = (scene_noise(&seed) + 1) / 2;
    const double x = number[0] * (double)n * POOL_DX, y = number[1] * (double)m * POOL_DY, size = 1 + 2 * number[2];
    const size_t i = (size_t)(number[0] * (double)(n - 1)), j = (size_t)(number[1] * (double)(m - 1));
    switch (which % 11) {
    case 0: ok(cd_water_splash(w, x, y, size, 0.2)); break;
    case 1: ok(cd_water_add_volume(w, x, y, size, number[3] - 0.5, NULL)); break;
    case 2: ok(cd_water_add_volume_rectangle(w, i, j, 1, 1, 0.2, NULL)); break;
    case 3: ok(cd_water_impulse(w, x, y, size, 500 * number[3], -300)); break;
    case 4: pool_set(w, CD_BED, i, j, pool_get(w, CD_BED, i, j) + 0.1 * number[3]); break;
    case 5: (void)cd_water_write_f64(w, CD_VELOCITY_X, i + 1, j, 1, 1, &number[3], 1); break; /* closed: refused */
    case 6: (void)cd_water_write_f64(w, CD_VELOCITY_Y, i, 0, 1, 1, &number[3], 1); break;
    case 7: (void)cd_water_write_f64(w, CD_DEPTH, i, j, 1, 1, &number[3], 1); break; /* absent: refused */
    case 8:
        ok(cd_water_enable_field(w, CD_MASK));
        pool_set(w, CD_MASK, i, j, number[3] < 0.5);
        break;
    default: break;
    }
}

/* Along a periodic direction the last faces are the first. */
static void ends_are_one(const cd_water* w) {
    static double u[2 * CELLS];
    for (int along_y = 0; along_y < 2; ++along_y) {
        cd_border kind;
        ok(cd_water_get_side(w, along_y ? CD_SIDE_Y_FIRST : CD_SIDE_X_FIRST, &kind, NULL, NULL));
        if (kind != CD_BORDER_PERIODIC) continue;
        const struct pool_extent all = pool_extent(w, along_y ? CD_VELOCITY_Y : CD_VELOCITY_X);
        pool_read(w, along_y ? CD_VELOCITY_Y : CD_VELOCITY_X, u);
        const size_t lines = along_y ? all.columns : all.rows, across = along_y ? 1 : all.columns;
        const size_t last = along_y ? all.columns * (all.rows - 1) : all.columns - 1;
        for (size_t k = 0; k < lines; ++k)
            if (u[k * across] != u[k * across + last]) fail_msg("two velocities on one face");
    }
}

/* One water has only what happens to it, one is also looked at anew before each step; one goes on as a copy, and one
 * is run by threads. */
static void which_parts_sleep_follows_from_the_state(void** state) {
    (void)state;
    static const double heights[] = {0.003, 0.05};
    size_t part_asleep = 0;
    for (size_t scene = 0; scene < POOLS; ++scene)
        for (size_t h = 0; h < COUNT(heights); ++h) {
            if (!is_taken(scene + h, 2)) continue;
            struct jobs jobs = {0};
            const cd_parallel parallel = jobs_threads(&jobs);
            const cd_precision precision = (cd_precision)((scene + h) % 2);
            enum { ONE, LOOKED_AT, COPIED, SHARED, HOW };
            cd_water* w[HOW];
            for (int how = 0; how < HOW; ++how) {
                w[how] = pool(100, 70, precision);
                pools[scene].build(w[how]);
                ok(cd_water_set_drag(w[how], 1));
                ok(cd_water_set_sleep(w[how], heights[h]));
                if (how == SHARED) ok(cd_water_set_parallel(w[how], &parallel));
            }
            for (uint64_t step = 0; step < 60; ++step) {
                if (step % 5 == 3)
                    for (int how = 0; how < HOW; ++how) happens(w[how], step * 7 + scene);
                double gravity;
                ok(cd_water_get_gravity(w[LOOKED_AT], &gravity));
                ok(cd_water_set_gravity(w[LOOKED_AT], gravity));
                if (step % 7 == 2) ok(cd_water_copy_state(w[COPIED], w[ONE]));
                for (int how = 0; how < HOW; ++how) {
                    pool_step(w[how], pools[scene].dt, 1);
                    if (hash_of(w[how]) != hash_of(w[ONE]) || awake(w[how]) != awake(w[ONE]))
                        fail_msg("%s, height %g, water %d, step %d: another one, %zu of %zu cells awake",
                                 pools[scene].name, heights[h], how, (int)step, awake(w[how]), awake(w[ONE]));
                }
                ends_are_one(w[ONE]);
                if (awake(w[ONE]) > 0 && awake(w[ONE]) < 7000) ++part_asleep;
            }
            for (int how = 0; how < HOW; ++how) cd_water_destroy(w[how]);
        }
    assert_true(part_asleep > 100); /* of 900 steps, 1800 in all */
}

/* All awake, steps are those of water that never sleeps. */
static void awake_it_moves_as_ever(void** state) {
    (void)state;
    for (size_t scene = 0; scene < POOLS; ++scene) {
        cd_water *w = pool(37, 21, CD_FLOAT64), *never = pool(37, 21, CD_FLOAT64);
        pools[scene].build(w), pools[scene].build(never);
        ok(cd_water_set_sleep(w, 1e-30));
        pool_step(w, pools[scene].dt, 12), pool_step(never, pools[scene].dt, 12);
        const size_t all = awake(w);
        ok(cd_water_set_sleep(w, 0));
        if (all == 37 * 21) assert_int_equal(hash_of(w), hash_of(never));
        else if (strcmp(pools[scene].name, "dam") != 0) fail_msg("%s: %zu cells are awake", pools[scene].name, all);
        cd_water_destroy(w);
        cd_water_destroy(never);
    }
}

/* ---- what keeps it awake ---- */

static void what_acts_keeps_it_awake(void** state) {
    (void)state;
    static const cd_field fields[] = {CD_SOURCE, CD_FORCE_X, CD_FORCE_Y, CD_PRESSURE};
    for (size_t k = 0; k < COUNT(fields); ++k) {
        cd_water *w = lake(N, M, CD_FLOAT64, &ways[ADVECTED]), *never = lake(N, M, CD_FLOAT64, &ways[ADVECTED]);
        const double value = fields[k] == CD_PRESSURE ? 2000 : 0.05;
        cd_water* both[2] = {w, never};
        for (int b = 0; b < 2; ++b) {
            ok(cd_water_enable_field(both[b], fields[k]));
            ok(cd_water_write_f64(both[b], fields[k], 31, 50, 1, 1, &value, 1)); /* at the end of a part */
        }
        ok(cd_water_set_sleep(w, height));
        for (int s = 0; s < 60; ++s) {
            basin_step(w, 0.1, 1), basin_step(never, 0.1, 1);
            assert_true(awake(w) > 0 && awake(w) < CELLS);
            if (apart(w, never) > height) fail_msg("field %d, step %d: %g m apart", fields[k], s, apart(w, never));
        }
        cd_water_destroy(w);
        cd_water_destroy(never);
    }
}

/* Without gravity only what moves is awake, and what acts. */
static void without_gravity_sources_act(void** state) {
    (void)state;
    cd_water* w = lake(N, M, CD_FLOAT64, &ways[LINEAR]);
    ok(cd_water_set_gravity(w, 0));
    ok(cd_water_set_sleep(w, height));
    basin_step(w, 0.1, 1);
    assert_int_equal(awake(w), 0);
    ok(cd_water_add_source(w, 40, 40, 3, 2));
    const double before = basin_volume(w);
    basin_step(w, 0.1, 10);
    assert_true(awake(w) > 0 && awake(w) < CELLS);
    assert_true(fabs(basin_volume(w) - before - 2) < 1e-3);
    ok(cd_water_disable_field(w, CD_SOURCE));
    basin_step(w, 0.1, 1);
    assert_int_equal(awake(w), 0);
    ok(cd_water_impulse(w, 40, 40, 3, 100, 0));
    basin_step(w, 0.1, 1);
    assert_true(awake(w) > 0 && awake(w) < CELLS);
    cd_water_destroy(w);
}

/* A surface that pressure holds aslant is at rest. */
static void what_pressure_holds_aslant_sleeps(void** state) {
    (void)state;
    cd_water* w = lake(N, M, CD_FLOAT64, &ways[LINEAR]);
    static double aslant[CELLS], pressure[CELLS];
    for (size_t k = 0; k < CELLS; ++k) {
        aslant[k] = 0.05 * (double)(k % N) / N;
        pressure[k] = 9810 * (0.05 - aslant[k]);
    }
    basin_fill(w, CD_BED, level, NULL);
    basin_write(w, CD_DEPTH, aslant);
    ok(cd_water_add_volume_rectangle(w, 0, 0, N, M, CELLS, NULL));
    ok(cd_water_set_sleep(w, height));
    basin_step(w, 0.1, 1);
    assert_int_equal(awake(w), CELLS);
    basin_write(w, CD_DEPTH, aslant);
    ok(cd_water_add_volume_rectangle(w, 0, 0, N, M, CELLS, NULL));
    basin_fill(w, CD_VELOCITY_X, level, NULL);
    basin_fill(w, CD_VELOCITY_Y, level, NULL);
    ok(cd_water_enable_field(w, CD_PRESSURE));
    basin_write(w, CD_PRESSURE, pressure);
    basin_step(w, 0.1, 1);
    assert_int_equal(awake(w), 0);
    cd_water_destroy(w);
}

/* The tide rises at one side, waves go out through another, and run round through a periodic one. */
static void sides_keep_it_awake(void** state) {
    (void)state;
    static const cd_border kinds[] = {CD_BORDER_OPEN, CD_BORDER_LEVEL, CD_BORDER_INFLOW, CD_BORDER_PERIODIC};
    for (size_t k = 0; k < COUNT(kinds); ++k)
        for (cd_side side = CD_SIDE_X_FIRST; side <= CD_SIDE_Y_LAST; ++side) {
            cd_water *w = lake(N, M, CD_FLOAT64, &ways[ADVECTED]), *never = lake(N, M, CD_FLOAT64, &ways[ADVECTED]);
            cd_water* both[2] = {w, never};
            for (int b = 0; b < 2; ++b) {
                flatten(both[b]);
                ok(cd_water_set_side(both[b], side, kinds[k], kinds[k] == CD_BORDER_INFLOW ? 0 : 1,
                                     kinds[k] == CD_BORDER_INFLOW ? 0.1 : 0.02));
                const double off = kinds[k] == CD_BORDER_PERIODIC ? 50 : 20;
                const double x = side == CD_SIDE_X_FIRST ? off : side == CD_SIDE_X_LAST ? N - off : N / 2;
                const double y = side == CD_SIDE_Y_FIRST ? off : side == CD_SIDE_Y_LAST ? M - off : M / 2;
                ok(cd_water_splash(both[b], x, y, 4, 0.3));
            }
            ok(cd_water_set_sleep(w, height));
            size_t least = CELLS;
            for (int s = 0; s < 80; ++s) {
                basin_step(w, 0.2, 1), basin_step(never, 0.2, 1);
                least = awake(w) < least ? awake(w) : least;
                if (apart(w, never) > height)
                    fail_msg("kind %d, side %d, step %d: %g m apart", kinds[k], side, s, apart(w, never));
            }
            assert_true(least < CELLS * 2 / 3);
            if (kinds[k] == CD_BORDER_PERIODIC) assert_int_equal(awake(w), CELLS);
            cd_water_destroy(w);
            cd_water_destroy(never);
        }
}

/* A boat crosses a lake that sleeps before and beside it; left alone, only its own place stays awake. */
static void a_boat_wakes_its_own_place(void** state) {
    (void)state;
    cd_water *w = lake(N, M, CD_FLOAT64, &ways[LINEAR]), *never = lake(N, M, CD_FLOAT64, &ways[LINEAR]);
    cd_water* both[2] = {w, never};
    const double force[6] = {3000, 0, 0, 0, 0, 0};
    for (int b = 0; b < 2; ++b) {
        flatten(both[b]);
        ok(cd_water_set_hulls(both[b], 2, 6, 3));
        ok(cd_water_set_hull(both[b], 0, 1500, 6, 2.5, NULL, 18));
        ok(cd_water_launch_hull(both[b], 0, 30, 50, 1, 0.2));
        ok(cd_water_set_hull_force(both[b], 0, force, 6));
        ok(cd_water_set_drag(both[b], 0.2));
    }
    ok(cd_water_set_sleep(w, height));
    double pose[2][7];
    for (int s = 0; s < 300; ++s) {
        if (s == 100) /* another one is set down where all is flat */
            for (int b = 0; b < 2; ++b) {
                static const double far[7] = {120, 90, 0.9, 0, 1, 0, 0};
                ok(cd_water_set_hull(both[b], 1, 800, 5, 2, NULL, 18));
                ok(cd_water_set_hull_pose(both[b], 1, far, 7));
            }
        basin_step(w, 0.05, 1), basin_step(never, 0.05, 1);
        assert_true(awake(w) > 0);
        if (apart(w, never) > 2 * height) fail_msg("step %d: %g m apart", s, apart(w, never));
    }
    assert_true(awake(w) < CELLS);
    for (int b = 0; b < 2; ++b) ok(cd_water_get_hull_pose(both[b], 0, pose[b], 7));
    assert_true(pose[0][0] > 40);
    for (int k = 0; k < 2; ++k) assert_true(fabs(pose[0][k] - pose[1][k]) < 0.02);
    const double none[6] = {0}, way[2] = {1000, 1000};
    ok(cd_water_set_hull_force(w, 0, none, 6));
    ok(cd_water_set_hull_drag(w, 0, way[0], way[1], 0));
    for (int s = 0; s < 3000; ++s) basin_step(w, 0.05, 1);
    if (awake(w) == 0 || awake(w) > 16 * 16 * 30) fail_msg("%zu cells are awake", awake(w));
    cd_water_destroy(w);
    cd_water_destroy(never);
}

/* Saved and loaded, it sleeps below the same height; of saved bytes without one it does not. */
static void the_height_is_kept(void** state) {
    (void)state;
    cd_water *w = lake(40, 40, CD_FLOAT32, &ways[LINEAR]), *other = lake(40, 40, CD_FLOAT32, &ways[LINEAR]);
    for (int sleeps = 1; sleeps >= 0; --sleeps) {
        ok(cd_water_set_sleep(w, sleeps ? 0.25 : 0));
        size_t size = 0, written;
        ok(cd_water_save_size(w, &size));
        void* bytes = malloc(size);
        assert_non_null(bytes);
        ok(cd_water_save(w, bytes, size, &written));
        ok(cd_water_load(other, bytes, size));
        double kept = -1;
        ok(cd_water_get_sleep(other, &kept));
        assert_true(kept == (sleeps ? 0.25 : 0));
        assert_int_equal(hash_of(other), hash_of(w));
        free(bytes);
    }
    cd_water_destroy(w);
    cd_water_destroy(other);
}

/* All are awake before the first step, and where nothing sleeps, whatever slept before. */
static void all_are_awake_before_a_step_and_without_sleep(void** state) {
    (void)state;
    cd_water *w = lake(N, M, CD_FLOAT64, &ways[LINEAR]), *never = lake(N, M, CD_FLOAT64, &ways[LINEAR]);
    for (int how = 0; how < 3; ++how) {
        ok(cd_water_set_sleep(w, height));
        if (how == 0) assert_int_equal(awake(w), CELLS);
        basin_step(w, 0.1, 1);
        assert_int_equal(awake(w), 0);
        if (how == 0) ok(cd_water_set_sleep(w, 0));
        if (how == 1) ok(cd_water_copy_state(w, never));
        if (how == 2) ok(cd_water_reset(w));
        assert_int_equal(awake(w), CELLS);
    }
    cd_water_destroy(w);
    cd_water_destroy(never);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_lake_at_rest_sleeps),
        cmocka_unit_test(waves_wake_what_is_ahead_of_them),
        cmocka_unit_test(fast_water_wakes_what_it_runs_into),
        cmocka_unit_test(it_falls_asleep_again),
        cmocka_unit_test(which_parts_sleep_follows_from_the_state),
        cmocka_unit_test(awake_it_moves_as_ever),
        cmocka_unit_test(what_acts_keeps_it_awake),
        cmocka_unit_test(sides_keep_it_awake),
        cmocka_unit_test(a_boat_wakes_its_own_place),
        cmocka_unit_test(without_gravity_sources_act),
        cmocka_unit_test(the_height_is_kept),
        cmocka_unit_test(what_pressure_holds_aslant_sleeps),
        cmocka_unit_test(all_are_awake_before_a_step_and_without_sleep),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
