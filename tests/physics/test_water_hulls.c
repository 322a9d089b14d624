/* Hulls on water: what they displace, how they swing, drift, run aground, and what momentum they give. */
#include <math.h>

#include "check.h"
#include "pool.h"

enum { NX = 64, NY = 32, SAMPLES = 4000 };
#define DX 0.25
#define LENGTH (NX * DX)
#define WIDTH (NY * DX)
#define G 9.81
#define PI 3.14159265358979324

static cd_water* lake(size_t nx, size_t ny, double depth) {
    cd_water* w;
    ok(cd_water_create(nx, ny, DX, DX, CD_FLOAT64, NULL, &w));
    pool_fill(w, CD_DEPTH, depth);
    return w;
}

/* Waves that launched hulls made die out, and what motion they have. */
static void settle(cd_water* w) {
    size_t hulls;
    ok(cd_water_get_hulls(w, &hulls, NULL, NULL));
    for (size_t k = 0; k < hulls; ++k) ok(cd_water_set_hull_drag(w, k, 1000, 1000, 0));
    ok(cd_water_set_drag(w, 1));
    pool_step(w, 0.1, 500);
}

static double level_at(const cd_water* w, double x, double y) {
    double level;
    ok(cd_water_sample(w, (const double[]){x, y}, 1, CD_OUTSIDE_REFUSED, &level, NULL, NULL, NULL));
    return level;
}

/* Draft = mass / (density area), wherever it lies and however it is turned; and the water would be level without it. */
static void a_hull_that_lies_still_displaces_its_mass(void** state) {
    (void)state;
    double bow[64]; /* without one of its corners, so that how it lies along and across depend on each other */
    for (int j = 0; j < 8; ++j)
        for (int i = 0; i < 8; ++i) bow[8 * j + i] = i > 4 && j > 4 ? -1 : 0.05 * fabs(j - 3.5) + 0.02 * i;
    for (int shape = 0; shape < 4; ++shape)
        for (int turn = 0; turn < 2; ++turn) {
            cd_water* w = lake(NX, NY, 1);
            double floor[7], load[6], area, head;
            const int across = shape == 3 ? 1 : 8; /* 3: so narrow that it is a line */
            const double width = shape == 3 ? 0.1 : 1.6, mass = shape == 3 ? 100 : 1200;
            ok(cd_water_set_hulls(w, 1, 8, (size_t)across));
            if (shape == 0) ok(cd_water_set_hull(w, 0, 1200, 3, 1.6, NULL, 0));
            if (shape == 1) ok(cd_water_set_disc(w, 0, 1200, 1.2));
            if (shape >= 2) ok(cd_water_set_hull(w, 0, mass, 3, width, bow, 8 * (size_t)across));
            ok(cd_water_get_hull(w, 0, NULL, NULL, NULL, &area, NULL, 0));
            if (shape == 1) assert_near(area, 1.44 * PI, 1e-12, 0);
            ok(cd_water_launch_hull(w, 0, 8.1 + 0.03 * turn, 4.07, cos(turn), sin(turn)));
            settle(w);
            ok(cd_water_get_hull_floor(w, 0, floor, 7));
            ok(cd_water_get_hull_load(w, 0, load, 6));
            const double level = level_at(w, 0.5, 0.5);
            double displaced = area * (level - floor[2]), moments[2] = {0, 0};
            if (shape >= 2) {
                displaced = 0;
                for (int k = 0; k < 8 * across; ++k) {
                    const double ahead = 3 * ((k % 8 + 0.5) / 8 - 0.5), port = width * ((k / 8 + 0.5) / across - 0.5);
                    const double below = level - (floor[2] + floor[5] * ahead + floor[6] * port + bow[k]);
                    const double volume = bow[k] >= 0 && below > 0 ? below * 3 * width / (8 * across) : 0;
                    displaced += volume, moments[0] += volume * ahead, moments[1] += volume * port;
                }
                /* what it displaces lies under its middle */
                for (int k = 0; k < 2; ++k) assert_near(moments[k] / displaced, 0, 0.01, 1);
            }
            assert_near(1000 * displaced, mass, shape >= 2 ? 1e-4 : 1e-6, 0); /* plates are tilted a little */
            assert_near(load[2], mass * G, 1e-6, 0);
            ok(cd_water_sample_heads(w, (const double[]){8.1, 4.07}, 1, CD_OUTSIDE_REFUSED, &head));
            assert_near(head, level, 2e-5, 0);
            cd_water_destroy(w);
        }
}

/* A hull that is launched on a lake lies there as it would in time: it displaces its mass, the lake stands higher by
 * that, no volume is lost, and hardly a wave is seen. On land it displaces nothing. */
static void a_launched_hull_lies_still(void** state) {
    (void)state;
    const double mass = 1000;
    for (int k = 0; k < 8; ++k) {
        cd_water* w;
        double bow[32], floor[7], load[6], before, after;
        const double turn = k & 1 ? 0.4 : 0;
        ok(cd_water_create(NX, NY, DX, DX, k & 2 ? CD_FLOAT32 : CD_FLOAT64, NULL, &w));
        pool_fill(w, CD_DEPTH, 1);
        for (int i = 0; i < 32; ++i) bow[i] = k & 4 ? 0.03 * fabs(i % 8 - 3.5) : 0;
        ok(cd_water_set_hulls(w, 1, 8, 4));
        ok(cd_water_set_hull(w, 0, mass, 4, 1.6, bow, 32));
        ok(cd_water_get_volume(w, &before));
        ok(cd_water_launch_hull(w, 0, 8.1, 4, cos(turn), sin(turn)));
        for (int step = 0; step <= 60; ++step) {
            ok(cd_water_get_volume(w, &after));
            assert_near(after, before, k & 2 ? 1e-7 : 1e-13, 0);
            double low = 2, high = 0, displaced = 0;
            for (size_t j = 0; j < NY; ++j) {
                low = fmin(low, pool_get(w, CD_DEPTH, 0, j)), high = fmax(high, pool_get(w, CD_DEPTH, 0, j));
            }
            assert_near(low, 1 + mass / 1000 / (LENGTH * WIDTH), 1e-5, 0);
            assert_near(high, low, 2e-5, 0);
            ok(cd_water_get_hull_floor(w, 0, floor, 7));
            for (int i = 0; i < 32; ++i) displaced += fmax(0, high - floor[2] - bow[i]) * 4 * 1.6 / 32;
            assert_near(1000 * displaced, mass, k & 4 ? 0.01 : 3e-4, 0);
            assert_near(floor[0], 8.1, 2e-3, 0);
            pool_step(w, 1 / 60.0, 1);
            ok(cd_water_get_hull_load(w, 0, load, 6));
            assert_near(load[2], mass * G, 1e-3, 0);
        }
        cd_water_destroy(w);
    }
    cd_water* land = lake(NX, NY, 0);
    double floor[7];
    ok(cd_water_set_hulls(land, 1, 1, 1));
    ok(cd_water_set_hull(land, 0, mass, 4, 1.6, NULL, 0));
    ok(cd_water_launch_hull(land, 0, 8, 4, 1, 0));
    ok(cd_water_get_hull_floor(land, 0, floor, 7));
    assert_near(floor[2], 0, 1e-12, 1);
    cd_water_destroy(land);
}

/* Steps a hull that can only heave, as on an upright rail. */
static void step_on_rail(cd_water* w, double dt) {
    double from[7], pose[7], velocity[6];
    ok(cd_water_get_hull_pose(w, 0, from, 7));
    pool_step(w, dt, 1);
    ok(cd_water_get_hull_pose(w, 0, pose, 7));
    ok(cd_water_get_hull_velocity(w, 0, velocity, 6));
    from[2] = pose[2];
    ok(cd_water_set_hull_pose(w, 0, from, 7));
    ok(cd_water_set_hull_velocity(w, 0, (const double[]){0, 0, velocity[2], 0, 0, 0}, 6));
}

/* A box as wide as its slice of a closed basin of twice its length heaves against the seiche of the gap: of a rigid
 * floor over depth d that rises by z, the water under it runs in with u = -x z_t / d, which is an added mass of
 * density L^3 / (3 d) per metre of a half box of length L against the wall; the gap, as long and D deep, swings with
 * k = w / sqrt(g D) and stands by L k cot(k L) z lower at the box's end:
 *     (draft + L^2 / (3 d)) w^2 = g (1 + k L cot(k L)). */
static void a_box_heaves_in_the_period_of_shallow_water(void** state) {
    (void)state;
    const double depth = 1, l = 4, draft = 0.25, under = depth - draft / 2, beside = depth + draft / 2;
    for (int fine = 0; fine < 2; ++fine) {
        cd_water* w;
        const double dx = fine ? 0.0625 : 0.125;
        ok(cd_water_create((size_t)(2 * l / dx), 1, dx, dx, CD_FLOAT64, NULL, &w));
        pool_fill(w, CD_DEPTH, depth);
        ok(cd_water_set_hulls(w, 1, 1, 1));
        /* the half of it that lies in the basin, and its mirror image: a hull of twice the length in the wall */
        ok(cd_water_set_hull(w, 0, 1000 * draft * 2 * l * dx, 2 * l, dx, NULL, 0));
        ok(cd_water_launch_hull(w, 0, 0, dx / 2, 1, 0));
        ok(cd_water_set_drag(w, 1));
        for (int s = 0; s < 800; ++s) step_on_rail(w, 0.05);
        ok(cd_water_set_drag(w, 0));
        ok(cd_water_set_lambda(w, 0.5));
        double floor[7];
        const double v[6] = {0, 0, 0.01, 0, 0, 0}, dt = 0.01;
        ok(cd_water_get_hull_pose(w, 0, floor, 7));
        const double z0 = floor[2];
        ok(cd_water_set_hull_velocity(w, 0, v, 6));
        static double z[SAMPLES];
        for (int s = 0; s < SAMPLES; ++s) {
            step_on_rail(w, dt);
            ok(cd_water_get_hull_pose(w, 0, floor, 7));
            z[s] = floor[2] - z0;
        }
        double low = 0.1, high = 2.4; /* k L < pi */
        for (int k = 0; k < 60; ++k) {
            const double v = (low + high) / 2, kl = v / sqrt(G * beside) * l;
            if ((draft + l * l / (3 * under)) * v * v < G * (1 + kl / tan(kl))) low = v;
            else high = v;
        }
        double most = 0, found = 0; /* the frequency of the largest part of the motion */
        for (double v_k = 0.6 * low; v_k < 1.6 * low; v_k += 0.002 * low) {
            double c = 0, d = 0;
            for (int s = 0; s < SAMPLES; ++s) {
                const double t = dt * s, window = 1 - cos(2 * PI * s / SAMPLES);
                c += window * z[s] * cos(v_k * t), d += window * z[s] * sin(v_k * t);
            }
            if (c * c + d * d > most) most = c * c + d * d, found = v_k;
        }
        assert_near(found, low, 0.04, 0);
        cd_water_destroy(w);
    }
}

static void a_hull_drifts_with_a_stream(void** state) {
    (void)state;
    cd_water* w = lake(NX, NY, 1);
    ok(cd_water_set_side(w, CD_SIDE_X_FIRST, CD_BORDER_PERIODIC, 0, 0));
    ok(cd_water_set_momentum(w, CD_MOMENTUM_ADVECTED));
    pool_fill(w, CD_VELOCITY_X, 0.5);
    ok(cd_water_set_hulls(w, 1, 1, 1));
    ok(cd_water_set_hull(w, 0, 100, 2, 1, NULL, 0));
    ok(cd_water_set_hull_drag(w, 0, 200, 200, 0));
    ok(cd_water_launch_hull(w, 0, 2, WIDTH / 2, 1, 0));
    pool_step(w, 1 / 60.0, 1200);
    double velocity[6], pose[7];
    ok(cd_water_get_hull_velocity(w, 0, velocity, 6));
    ok(cd_water_get_hull_pose(w, 0, pose, 7));
    assert_near(velocity[0], 0.5, 0.05, 0);
    assert_near(velocity[1], 0, 0.01, 1);
    assert_near(pose[0] - 2, 0.5 * 20, 0.1, 0);
    cd_water_destroy(w);
}

static double water_momentum(const cd_water* w) {
    double sum = 0;
    for (size_t j = 0; j < NY; ++j)
        for (size_t i = 0; i < NX; ++i) {
            const double d = (pool_get(w, CD_DEPTH, i, j) + pool_get(w, CD_DEPTH, (i + NX - 1) % NX, j)) / 2;
            sum += 1000 * DX * DX * d * pool_get(w, CD_VELOCITY_X, i, j);
        }
    return sum;
}

/* Periodic along x, over a level bed, nothing but the hull's loads and drag acts on the water along x. What drag takes
 * the water gets; of what loads take as much as differences of the surface over a cell have of its slope. */
static void what_a_hull_loses_the_water_gets(void** state) {
    (void)state;
    for (int dragged = 0; dragged < 2; ++dragged) {
        cd_water* w = lake(NX, NY, 1);
        double velocity[6] = {1, 0, 0, 0, 0, 0};
        ok(cd_water_set_side(w, CD_SIDE_X_FIRST, CD_BORDER_PERIODIC, 0, 0));
        ok(cd_water_set_momentum(w, CD_MOMENTUM_ADVECTED));
        ok(cd_water_set_hulls(w, 1, 1, 1));
        ok(cd_water_set_hull(w, 0, 600, 3, 1, NULL, 0));
        ok(cd_water_launch_hull(w, 0, 4, WIDTH / 2, 1, 0));
        if (dragged) ok(cd_water_set_hull_drag(w, 0, 300, 300, 0));
        ok(cd_water_set_hull_velocity(w, 0, velocity, 6));
        const double before = 600 * velocity[0] + water_momentum(w);
        pool_step(w, 1 / 60.0, 180);
        ok(cd_water_get_hull_velocity(w, 0, velocity, 6));
        const double lost = before - 600 * velocity[0], got = water_momentum(w);
        assert_true(lost > (dragged ? 400 : 50));
        assert_near(got, lost, dragged ? 0.05 : 0.5, 0);
        cd_water_destroy(w);
    }
}

static void a_hull_over_a_high_bed_lies_on_it(void** state) {
    (void)state;
    cd_water* w = lake(NX, NY, 0);
    for (size_t j = 0; j < NY; ++j)
        for (size_t i = 0; i < NX; ++i) pool_set(w, CD_BED, i, j, i < NX / 2 ? -1 : 0.25);
    pool_fill(w, CD_SURFACE, 0);
    double floor[7];
    ok(cd_water_set_hulls(w, 2, 1, 1));
    for (size_t k = 0; k < 2; ++k) ok(cd_water_set_hull(w, k, 1000, 2, 1, NULL, 0));
    ok(cd_water_set_hull_drag(w, 1, 0, 0, 0.5));
    ok(cd_water_launch_hull(w, 0, 4, 4, 1, 0));
    ok(cd_water_launch_hull(w, 1, 12, 4, 1, 0));
    ok(cd_water_set_hull_velocity(w, 1, (const double[]){1, 0, 0, 0, 0, 0}, 6));
    pool_step(w, 0.01, 100);
    settle(w);
    ok(cd_water_get_hull_floor(w, 0, floor, 7));
    assert_near(floor[2], level_at(w, 0.5, 0.5) - 0.5, 1e-5, 1);
    ok(cd_water_get_hull_floor(w, 1, floor, 7));
    assert_near(floor[2], 0.25, 1e-9, 0);
    assert_near(floor[0] - 12, 1 / (2 * 0.5 * G), 0.25, 0); /* slides v^2 / (2 mu g) */
    cd_water_destroy(w);
}

/* Two hulls side by side, mirror images: they stay so. One alone on a level lake goes nowhere. */
static void two_hulls_stay_each_others_image(void** state) {
    (void)state;
    cd_water* w = lake(NX, NY, 1);
    double a[7], b[7];
    ok(cd_water_set_hulls(w, 2, 1, 1));
    for (size_t k = 0; k < 2; ++k) {
        ok(cd_water_set_hull(w, k, 500, 2, 1, NULL, 0));
        ok(cd_water_launch_hull(w, k, k ? LENGTH - 5 : 5, WIDTH / 2, k ? -1 : 1, 0));
    }
    for (int round = 0; round < 3; ++round) { /* one was launched on what the other had displaced, and drifts off */
        settle(w);
        for (size_t k = 0; k < 2; ++k) {
            ok(cd_water_get_hull_pose(w, k, a, 7));
            a[0] = k ? LENGTH - 5 : 5;
            ok(cd_water_set_hull_pose(w, k, a, 7));
        }
    }
    ok(cd_water_set_drag(w, 0));
    for (size_t k = 0; k < 2; ++k) {
        ok(cd_water_set_hull_drag(w, k, 0, 0, 0));
        ok(cd_water_set_hull_velocity(w, k, (const double[]){k ? -0.5 : 0.5, 0, 0, 0, 0, 0}, 6));
    }
    pool_step(w, 1 / 60.0, 120);
    ok(cd_water_get_hull_pose(w, 0, a, 7));
    ok(cd_water_get_hull_pose(w, 1, b, 7));
    assert_true(a[0] > 5.5);
    assert_near(a[0], LENGTH - b[0], 1e-6, 1);
    assert_near(a[2], b[2], 1e-6, 1);
    assert_near(a[5], b[5], 1e-9, 1);
    cd_water_destroy(w);
}

/* A boat of 3 m that runs as told for 4 s, its ends in the pool; then how far a push of 300 N brings it in 6 s. */
static double pushed(const double* start, const double* velocity, double push_x, double push_y) {
    cd_water* w = lake(NX, NY, 1);
    double pose[7];
    ok(cd_water_set_drag(w, 0.2));
    ok(cd_water_set_hulls(w, 1, 6, 3));
    ok(cd_water_set_hull(w, 0, 1200, 3, 1.2, NULL, 0));
    ok(cd_water_launch_hull(w, 0, start[0], start[1], start[2], start[3]));
    ok(cd_water_set_hull_velocity(w, 0, velocity, 6));
    for (int step = 0; step < 240; ++step) {
        pool_step(w, 1 / 60.0, 1);
        ok(cd_water_get_hull_pose(w, 0, pose, 7));
        for (int a = 0; a < 2; ++a) {
            const double half = 1.5 * fabs(pose[3 + a]) + 0.6 * fabs(pose[4 - a]) - 1e-9;
            assert_true(pose[a] >= half && pose[a] <= (a ? WIDTH : LENGTH) - half);
        }
    }
    const double x = pose[0], y = pose[1], c = pose[3], s = pose[4];
    ok(cd_water_set_hull_velocity(w, 0, (const double[6]){0}, 6));
    const double force[6] = {300 * (push_x * c + push_y * s), 300 * (push_y * c - push_x * s), 0, 0, 0, 0};
    ok(cd_water_set_hull_force(w, 0, force, 6));
    pool_step(w, 1 / 60.0, 360);
    ok(cd_water_get_hull_pose(w, 0, pose, 7));
    cd_water_destroy(w);
    return hypot(pose[0] - x, pose[1] - y);
}

static void a_hull_stops_with_its_end_at_a_wall_and_leaves_it(void** state) {
    (void)state;
    const double still[6] = {0}, on[6] = {-1}, up[6] = {0, 1}, slanting[6] = {-1, 0.3}, turning[6] = {-0.3, 0, 0, 1};
    const double free = pushed((const double[]){4, 4, 1, 0}, still, 1, 0);
    assert_true(free > 3);
    assert_near(pushed((const double[]){3, 4, 1, 0}, on, 1, 0), free, 0.15, 0);
    assert_near(pushed((const double[]){3, 4, -1, 0}, slanting, 1, 0), free, 0.15, 0);
    assert_near(pushed((const double[]){LENGTH / 2, WIDTH - 2, 0, 1}, up, 0, -1), free, 0.15, 0);
    pushed((const double[]){2, 4, 0, 1}, turning, 1, 0);
}

/* The water beyond a side is the mirror image of that before it: a hull whose middle lies on the side, and one half
 * beyond it, is pushed no way along it, and a mirrored half bears as much as the other. */
static void a_hull_halfway_beyond_a_side_is_its_own_image(void** state) {
    (void)state;
    for (int side = 0; side < 4; ++side) {
        cd_water* w = lake(NX, NY, 1);
        const int along = side < 2 ? 0 : 1;
        const double at[2] = {along ? LENGTH / 2 : side * LENGTH, along ? (side - 2) * WIDTH : WIDTH / 2};
        double load[6];
        ok(cd_water_set_hulls(w, 1, 8, 4));
        ok(cd_water_set_hull(w, 0, 1000, 4, 1.6, NULL, 0));
        ok(cd_water_launch_hull(w, 0, at[0], at[1], along ? 0 : 1, along));
        for (int step = 0; step < 30; ++step) {
            pool_step(w, 1 / 60.0, 1);
            ok(cd_water_get_hull_load(w, 0, load, 6));
            assert_near(load[along], 0, 1e-6 * 1000 * G, 1);
            assert_near(load[2], 1000 * G, 1e-2, 0);
        }
        cd_water_destroy(w);
    }
}

/* A post of 1 m that is moved through a lake: the water gives way to it, before it it rises, and none is lost. */
static void a_post_that_is_moved_presses_the_water_away(void** state) {
    (void)state;
    const double masses[] = {1000, 1e9}, depth = 1, speed = 0.5;
    for (size_t k = 0; k < COUNT(masses); ++k) {
        cd_water* w = lake(NX, NY, depth);
        double pose[7] = {4, WIDTH / 2, -depth / 3, 1, 0, 0, 0}, before, after, inside;
        const double velocity[6] = {speed, 0, 0, 0, 0, 0};
        ok(cd_water_set_hulls(w, 1, 1, 1));
        ok(cd_water_set_hull(w, 0, masses[k], 1, 1, NULL, 0));
        ok(cd_water_get_volume(w, &before));
        for (int step = 0; step < 480; ++step) {
            ok(cd_water_set_hull_pose(w, 0, pose, 7));
            ok(cd_water_set_hull_velocity(w, 0, velocity, 6));
            pool_step(w, 1 / 60.0, 1);
            ok(cd_water_sample(w, pose, 1, CD_OUTSIDE_REFUSED, NULL, &inside, NULL, NULL));
            if (step > 60) assert_true(inside < 0.02 * depth);
            if (step == 120) assert_true(level_at(w, pose[0] + 1, pose[1]) > level_at(w, pose[0] - 1, pose[1]) + 0.01);
            pose[0] += speed / 60;
        }
        ok(cd_water_get_volume(w, &after));
        assert_near(after, before, 1e-12, 0);
        cd_water_destroy(w);
    }
}

/* On land: friction holds a hull on a slope, and a drag of water does nothing. */
static void a_hull_on_dry_land_feels_the_bed_alone(void** state) {
    (void)state;
    for (int slope = 0; slope < 2; ++slope) {
        cd_water* w = lake(NX, NY, 0);
        double pose[7], velocity[6];
        for (size_t j = 0; j < NY; ++j)
            for (size_t i = 0; i < NX; ++i) pool_set(w, CD_BED, i, j, 0.2 * slope * DX * (double)i);
        ok(cd_water_set_hulls(w, 1, 4, 2));
        ok(cd_water_set_hull(w, 0, 500, 2, 1, NULL, 0));
        ok(cd_water_set_hull_drag(w, 0, 800, 800, slope ? 0.4 : 0));
        ok(cd_water_launch_hull(w, 0, 8, 4, 1, 0.3));
        ok(cd_water_set_hull_velocity(w, 0, (const double[]){slope ? 0 : 0.5, 0, 0, slope ? 0 : 0.1, 0, 0}, 6));
        pool_step(w, 0.05, 200);
        ok(cd_water_get_hull_pose(w, 0, pose, 7));
        ok(cd_water_get_hull_velocity(w, 0, velocity, 6));
        assert_near(pose[0], slope ? 8 : 13, slope ? 1e-3 : 1e-9, 0);
        assert_near(velocity[0], slope ? 0 : 0.5, 1e-9, 1);
        assert_near(velocity[3], slope ? 0 : 0.1, 1e-9, 1);
        if (slope) { /* what has held it does not hold back a push, down the slope against friction */
            const double push = 3000, rate = push / 500 + 0.2 * G - 0.4 * G;
            const double force[6] = {-push * pose[3], push * pose[4], 0, 0, 0, 0}, from = pose[0];
            ok(cd_water_set_hull_force(w, 0, force, 6));
            pool_step(w, 0.05, 20);
            ok(cd_water_get_hull_pose(w, 0, pose, 7));
            assert_near(from - pose[0], rate / 2, 0.1, 0);
        }
        cd_water_destroy(w);
    }
}

/* Mass times acceleration is what acts, its weight and the load that is told, in steps of any length. */
static void the_load_is_what_moves_a_hull(void** state) {
    (void)state;
    for (int k = 0; k < 4; ++k) {
        const double mass = k % 2 ? 1000 : 10, dt = k / 2 ? 3 : 0.2, round = mass * (3 * 3 + 1.6 * 1.6) / 12;
        double before[6], now[6], load[6], pose[7];
        cd_water* w = lake(NX, NY, 1);
        for (size_t i = 0; i < NX * NY; ++i) pool_set(w, CD_DEPTH, i % NX, i / NX, 1 + 0.1 * sin((double)i));
        ok(cd_water_set_hulls(w, 1, 8, 4) || cd_water_set_hull(w, 0, mass, 3, 1.6, NULL, 0));
        ok(cd_water_launch_hull(w, 0, 8, 4, 1, 0.4));
        for (int step = 0; step < 60; ++step) {
            ok(cd_water_get_hull_velocity(w, 0, before, 6));
            pool_step(w, dt, 1);
            ok(cd_water_get_hull_velocity(w, 0, now, 6));
            ok(cd_water_get_hull_load(w, 0, load, 6));
            load[2] -= mass * G;
            for (int way = 0; way < 4; ++way)
                assert_near((way < 3 ? mass : round) * (now[way] - before[way]) / dt, load[way], 1e-6 * mass * G, 1);
        }
        ok(cd_water_get_hull_floor(w, 0, pose, 7));
        assert_true(fabs(pose[0] - 8) < 2 && fabs(pose[1] - 4) < 1.5); /* it met no side */
        cd_water_destroy(w);
    }
}

/* What moved before does not hold back a hull whose velocity is set: as if its pose had been set as well. */
static void a_velocity_that_is_set_begins_anew(void** state) {
    (void)state;
    double pose[2][7];
    for (int posed = 0; posed < 2; ++posed) {
        cd_water* w = lake(NX, NY, 1);
        const double velocity[6] = {-1, 0.5, 0, 0.2, 0, 0};
        ok(cd_water_set_hulls(w, 1, 6, 3));
        ok(cd_water_set_hull(w, 0, 1200, 3, 1.2, NULL, 0));
        ok(cd_water_launch_hull(w, 0, 6, 4, 1, 0));
        ok(cd_water_set_hull_velocity(w, 0, (const double[]){3, 0, 0, 1, 0, 0}, 6));
        pool_step(w, 0.2, 4);
        ok(cd_water_get_hull_pose(w, 0, pose[posed], 7));
        if (posed) ok(cd_water_set_hull_pose(w, 0, pose[posed], 7));
        ok(cd_water_set_hull_velocity(w, 0, velocity, 6));
        pool_step(w, 0.2, 4);
        ok(cd_water_get_hull_pose(w, 0, pose[posed], 7));
        cd_water_destroy(w);
    }
    for (int k = 0; k < 7; ++k) assert_near(pose[0][k], pose[1][k], 1e-9, 1);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_hull_that_lies_still_displaces_its_mass),
        cmocka_unit_test(a_launched_hull_lies_still),
        cmocka_unit_test(a_box_heaves_in_the_period_of_shallow_water),
        cmocka_unit_test(a_hull_drifts_with_a_stream),
        cmocka_unit_test(what_a_hull_loses_the_water_gets),
        cmocka_unit_test(a_hull_over_a_high_bed_lies_on_it),
        cmocka_unit_test(two_hulls_stay_each_others_image),
        cmocka_unit_test(a_hull_stops_with_its_end_at_a_wall_and_leaves_it),
        cmocka_unit_test(a_hull_halfway_beyond_a_side_is_its_own_image),
        cmocka_unit_test(a_post_that_is_moved_presses_the_water_away),
        cmocka_unit_test(a_hull_on_dry_land_feels_the_bed_alone),
        cmocka_unit_test(the_load_is_what_moves_a_hull),
        cmocka_unit_test(a_velocity_that_is_set_begins_anew),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
