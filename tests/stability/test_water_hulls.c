/* Random hulls in closed pools with waves, of masses a thousandth of the water's depth up to most of it, at any Courant
 * number: what is there in all, water, hulls and their skins, never has more energy than it had, or than the water
 * makes by itself. */
#include <math.h>

#include "check.h"
#include "pool.h"
#include "reference.h"

static double between(uint64_t* seed, double low, double high) {
    return low + (high - low) * 0.5 * (1 + random_number(seed));
}

static double energy(const cd_water* w) {
    double e[4];
    ok(cd_water_get_energy(w, &e[0], &e[1]));
    ok(cd_water_get_hull_energy(w, &e[2], &e[3]));
    return (e[0] + e[1]) + (e[2] + e[3]);
}

struct scene {
    size_t nx, ny;
    double dx, dy, depth;
};

static void add_hulls(cd_water* w, const struct scene* s, uint64_t* seed) {
    const size_t count = 1 + (size_t)between(seed, 0, 5);
    double room = 0.3 * s->depth * (double)s->nx * s->dx * (double)s->ny * s->dy;
    ok(cd_water_set_hulls(w, count, 4, 3));
    for (size_t k = 0; k < count; ++k) {
        const double length = s->dx * between(seed, 1, 8), width = length * between(seed, 0.3, 1);
        double draft = 0.7 * s->depth * pow(10, between(seed, -3, 0)), heights[12];
        if (length * width * draft > room) draft = room / (2 * length * width);
        room -= length * width * draft;
        for (int i = 0; i < 12; ++i) heights[i] = i && between(seed, 0, 1) < 0.1 ? -1 : i ? between(seed, 0, draft) : 0;
        const double mass = 1000 * length * width * draft, x = (double)s->nx * s->dx, y = (double)s->ny * s->dy;
        const double pose[7] = {
            between(seed, 0, x),       between(seed, 0, y),  s->depth * between(seed, 1, 1.3) - draft,
            between(seed, -1, 1),      between(seed, -1, 1), between(seed, -0.05, 0.05),
            between(seed, -0.05, 0.05)};
        double velocity[6];
        for (int i = 0; i < 6; ++i) velocity[i] = between(seed, i < 2 ? -1 : -0.3, i < 2 ? 1 : 0.3);
        ok(cd_water_set_hull(w, k, mass, length, width, k % 2 ? heights : NULL, 12));
        ok(cd_water_set_hull_pose(w, k, pose, 7));
        ok(cd_water_set_hull_velocity(w, k, velocity, 6));
        ok(cd_water_set_hull_drag(w, k, k % 3 ? 0 : mass, k % 3 ? 0 : 5 * mass, 0.3));
    }
}

/* The most energy beyond the start's, as a part of what it loses. */
static double gained(cd_momentum momentum, double courant, uint64_t seed) {
    struct scene s;
    s.nx = (size_t)between(&seed, 20, 40), s.ny = between(&seed, 0, 1) < 0.2 ? 1 : (size_t)between(&seed, 12, 30);
    s.dx = between(&seed, 0.1, 0.5), s.dy = s.dx * between(&seed, 0.7, 1.3), s.depth = s.dx * between(&seed, 1, 7);
    const double area = (double)s.nx * s.dx * (double)s.ny * s.dy, dt = courant * s.dx / sqrt(9.81 * s.depth);
    cd_water* w;
    ok(cd_water_create(s.nx, s.ny, s.dx, s.dy, CD_FLOAT64, NULL, &w));
    ok(cd_water_set_momentum(w, momentum));
    ok(cd_water_add_volume_rectangle(w, 0, 0, s.nx, s.ny, area * s.depth, NULL));
    for (int k = 0; k < 4; ++k)
        ok(cd_water_splash(w, between(&seed, 0, (double)s.nx * s.dx), between(&seed, 0, (double)s.ny * s.dy),
                           s.dx * between(&seed, 1, 5), s.depth * between(&seed, 0, 0.5)));
    add_hulls(w, &s, &seed);
    const double volume = pool_volume(w), start = energy(w);
    double most = -HUGE_VAL, least = start;
    for (int step = 0; step < 200; ++step) {
        pool_step(w, dt, 1);
        const double now = energy(w);
        most = fmax(most, now - start), least = fmin(least, now);
    }
    assert_near(pool_volume(w), volume, 1e-13, 0);
    cd_water_destroy(w);
    return most / (start - least);
}

static void water_and_hulls_gain_no_energy(void** state) {
    (void)state;
    /* Of 35 a hull presses its cells nearly dry, of the last ones long steps throw the water far away from floors. */
    static const uint64_t seeds[] = {1, 2, 3, 4, 35, 435, 1812};
    for (cd_momentum momentum = CD_MOMENTUM_LINEAR; momentum <= CD_MOMENTUM_ADVECTED; ++momentum)
        for (double courant = 0.1; courant < 60; courant *= 5)
            for (size_t k = 0; k < COUNT(seeds); ++k) {
                const double by = gained(momentum, courant, seeds[k]);
                /* linear water makes h_t u^2 / 2 of its own in short steps */
                if (by > (momentum == CD_MOMENTUM_LINEAR && courant < 1 ? 0.7 : 0.01))
                    fail_msg("momentum %d, Courant number %g, seed %d: gains %g of what it loses", momentum, courant,
                             (int)seeds[k], by);
            }
}

/* One hull on a lake that is level but for it, from a thousandth of the water's mass under it to a thousand times: it
 * comes to rest on water or bed in steps of a second. */
static void a_hull_of_any_mass_comes_to_rest_in_long_steps(void** state) {
    (void)state;
    for (double draft = 1e-3; draft < 1e4; draft *= 10) {
        cd_water* w;
        double load[6], velocity[6];
        ok(cd_water_create(32, 24, 0.25, 0.25, CD_FLOAT64, NULL, &w));
        pool_fill(w, CD_DEPTH, 1);
        ok(cd_water_set_drag(w, 0.5));
        ok(cd_water_set_hulls(w, 1, 1, 1));
        ok(cd_water_set_hull(w, 0, 1000 * 2 * draft, 2, 1, NULL, 0));
        ok(cd_water_set_hull_drag(w, 0, 2000 * draft, 2000 * draft, 0.3));
        ok(cd_water_set_hull_pose(w, 0, (const double[]){4, 3, 2, 1, 0.5, 0.02, 0.01}, 7));
        pool_step(w, 1, 400);
        ok(cd_water_get_hull_load(w, 0, load, 6));
        ok(cd_water_get_hull_velocity(w, 0, velocity, 6));
        assert_near(load[2], 1000 * 2 * draft * 9.81, 5e-3, 0);
        for (int way = 0; way < 6; ++way) assert_near(velocity[way], 0, 1e-2, fmax(1, draft / 50));
        cd_water_destroy(w);
    }
}

/* In long steps gravity would take a hull in the air far below the bed: it comes down onto the water all the same, with
 * no more energy than would lift it by a centimetre. */
static void a_hull_that_leaves_the_water_comes_down_in_long_steps(void** state) {
    (void)state;
    static const double upward[] = {1e-4, 1e-3, 0.3, 10}, masses[] = {0.1, 1, 50, 500};
    for (double dt = 1; dt < 1e8; dt *= 7)
        for (size_t k = 0; k < COUNT(upward) * COUNT(masses); ++k) {
            const double mass = masses[k % COUNT(masses)], speed = upward[k / COUNT(masses)];
            cd_water* w;
            double velocity[6] = {0, 0, speed}, pose[7], load[6], most = -HUGE_VAL;
            ok(cd_water_create(30, 30, 1, 1, CD_FLOAT64, NULL, &w));
            pool_fill(w, CD_DEPTH, 1);
            ok(cd_water_set_hulls(w, 1, 4, 2));
            ok(cd_water_set_hull(w, 0, mass, 4, 2, NULL, 0));
            ok(cd_water_launch_hull(w, 0, 15.3, 14.8, 1, 0.2));
            ok(cd_water_get_hull_pose(w, 0, pose, 7));
            ok(cd_water_set_hull_velocity(w, 0, velocity, 6));
            const double start = energy(w), height = pose[2];
            for (int step = 0; step < 10; ++step) {
                pool_step(w, dt, 1);
                most = fmax(most, energy(w) - start);
            }
            ok(cd_water_get_hull_pose(w, 0, pose, 7));
            ok(cd_water_get_hull_load(w, 0, load, 6));
            if (!(most <= 0.01 * mass * 9.81) || !(pose[2] - height < 0.01) ||
                !(fabs(load[2] / (mass * 9.81) - 1) < 0.01))
                fail_msg("dt %g, %g kg, upward at %g m/s: %g J gained, %g m higher, %g of its weight is borne", dt,
                         mass, speed, most, pose[2] - height, load[2] / (mass * 9.81));
            cd_water_destroy(w);
        }
}

/* A hull on a wave of nearly half the depth, on water that goes round: what it may owe is part of what it had before the
 * wave pushed it, which in a long step gives a light one any speed. */
static void a_wave_gives_a_light_hull_no_more_than_it_has(void** state) {
    (void)state;
    enum { N = 24 };
    static const double masses[] = {0.1, 1, 10, 100};
    for (cd_momentum momentum = CD_MOMENTUM_LINEAR; momentum <= CD_MOMENTUM_ADVECTED; ++momentum)
        for (double courant = 0.5; courant < 1e4; courant *= 5)
            for (size_t k = 0; k < COUNT(masses); ++k) {
                const double dx = 0.4, depth = 2;
                double most = -HUGE_VAL;
                cd_water* w;
                ok(cd_water_create(N, 1, dx, dx, CD_FLOAT64, NULL, &w));
                ok(cd_water_set_momentum(w, momentum));
                ok(cd_water_set_side(w, CD_SIDE_X_FIRST, CD_BORDER_PERIODIC, 0, 0));
                for (size_t i = 0; i < N; ++i)
                    pool_set(w, CD_DEPTH, i, 0, depth + 0.8 * sin(2 * 3.14159265358979324 * ((double)i + 0.5) / N));
                ok(cd_water_set_hulls(w, 1, 1, 1));
                ok(cd_water_set_hull(w, 0, masses[k], 2, dx, NULL, 0));
                ok(cd_water_launch_hull(w, 0, N / 2 * dx, dx / 2, 1, 0));
                const double start = energy(w);
                for (int step = 0; step < 10; ++step) {
                    pool_step(w, courant * dx / sqrt(9.81 * depth), 1);
                    most = fmax(most, energy(w) - start);
                }
                if (!(most <= 0))
                    fail_msg("momentum %d, Courant number %g, %g kg: gains %g J", momentum, courant, masses[k], most);
                cd_water_destroy(w);
            }
}

/* Hulls that move and turn every way, in steps that would take them a million metres away: they and the water gain no
 * energy, beyond a tenth that linear water makes. */
static void hulls_that_turn_stay_bounded_in_any_step(void** state) {
    (void)state;
    static const double steps[] = {1e3, 1e6, 1e8, 1e10};
    for (cd_momentum momentum = CD_MOMENTUM_LINEAR; momentum <= CD_MOMENTUM_ADVECTED; ++momentum)
        for (size_t k = 0; k < COUNT(steps); ++k)
            for (uint64_t scene = 1; scene <= 40; ++scene) {
                enum { N = 14, M = 10 };
                uint64_t seed = scene;
                const double depth = between(&seed, 0.3, 3), length = between(&seed, 1, 6), speed = sqrt(9.81 * depth);
                const double mass = 500 * length * depth * pow(10, between(&seed, -3, 0));
                double velocity[6];
                cd_water* w;
                ok(cd_water_create(N, M, 1, 1, CD_FLOAT64, NULL, &w));
                ok(cd_water_set_momentum(w, momentum));
                pool_vary(w, CD_BED, 0.4 * depth, 0.4 * depth, scene);
                pool_fill(w, CD_SURFACE, depth);
                ok(cd_water_set_hulls(w, 1, 3, 2));
                ok(cd_water_set_hull(w, 0, mass, length, 1, NULL, 6));
                ok(cd_water_set_hull_pose(w, 0, (const double[]){7.3, 4.6, 0.9 * depth, 1, 0.3, 0, 0}, 7));
                for (int way = 0; way < 6; ++way)
                    velocity[way] = between(&seed, -1, 1) * (way < 3 ? speed : 0.1 * speed / length);
                ok(cd_water_set_hull_velocity(w, 0, velocity, 6));
                const double start = energy(w);
                for (int step = 0; step < 12; ++step) {
                    pool_step(w, (step % 2 ? between(&seed, 0.1, 1) : steps[k]) * sqrt(depth / 9.81), 1);
                    if (!(energy(w) <= 1.1 * start))
                        fail_msg("momentum %d, dt %g, scene %d, step %d: %g of the energy", momentum, steps[k],
                                 (int)scene, step, energy(w) / start);
                }
                cd_water_destroy(w);
            }
}

/* Over beds that rise out of the water at random, in long steps: hulls press water against land that lies dry, empty
 * cells and lie at shores. Water and hulls gain no more in a step than what hulls may owe, and cells that are not there stay closed. */
static void hulls_among_islands_gain_no_more_than_they_owe(void** state) {
    (void)state;
    enum { N = 20, M = 14, HULLS = 3 };
    static const uint64_t seeds[] = {2627, 2739, 222, 517, 2637, 2613, 1463, 1};
    for (size_t k = 0; k < COUNT(seeds); ++k) {
        uint64_t seed = seeds[k];
        const double depth = between(&seed, 0.1, 0.6), dx = 0.3, courant = pow(10, between(&seed, 1, 3));
        cd_water* w;
        ok(cd_water_create(N, M, dx, dx, CD_FLOAT64, NULL, &w));
        ok(cd_water_set_momentum(w, CD_MOMENTUM_ADVECTED));
        pool_vary(w, CD_BED, 0.65 * depth, 0.65 * depth, seeds[k]);
        pool_fill(w, CD_SURFACE, depth);
        double there[N], across[N];
        for (size_t i = 0; i < N; ++i) there[i] = k < 2 || i % 3 != 0; /* all in some scenes */
        ok(cd_water_enable_field(w, CD_MASK));
        ok(cd_water_write_f64(w, CD_MASK, 0, M / 2, N, 1, there, N));
        ok(cd_water_set_hulls(w, HULLS, 1, 1));
        for (size_t hull = 0; hull < HULLS; ++hull) {
            const double length = dx * pow(10, between(&seed, -0.3, 1)), width = length * between(&seed, 0.2, 1);
            const double x = between(&seed, 0, N * dx), y = between(&seed, 0, M * dx);
            const double mass = 1000 * length * width * depth * pow(10, between(&seed, -3, 0));
            ok(cd_water_set_hull(w, hull, mass, length, width, NULL, 0));
            ok(cd_water_launch_hull(w, hull, x, y, between(&seed, -1, 1), between(&seed, -1, 1)));
            ok(cd_water_set_hull_drag(w, hull, mass, 5 * mass, 0.3));
        }
        for (int step = 0; step < 30; ++step) {
            double may_owe, pressing, pose[7], mass, before = energy(w);
            ok(cd_water_get_hull_energy(w, &may_owe, &pressing));
            for (size_t hull = 0; hull < HULLS; ++hull) {
                ok(cd_water_get_hull_pose(w, hull, pose, 7));
                ok(cd_water_get_hull(w, hull, &mass, NULL, NULL, NULL, NULL, 0));
                pressing -= mass * 9.81 * pose[2];
            }
            may_owe = 0.05 * (may_owe + pressing);
            pool_step(w, courant * dx / sqrt(9.81 * depth), 1);
            if (!(energy(w) - before <= may_owe + 1e-12 * before))
                fail_msg("scene %d, step %d: gains %g J, may owe %g J", (int)seeds[k], step, energy(w) - before,
                         may_owe);
            ok(cd_water_read_f64(w, CD_VELOCITY_Y, 0, M / 2, N, 1, across, N));
            for (size_t i = 0; i < N; ++i) assert_true(across[i] == 0 || there[i] == 1);
        }
        cd_water_destroy(w);
    }
}

/* A light hull at a shore that the water laps over by a millionth of its depth and that it keeps dry: to drag the water
 * along it has to move half of what the last wet cell holds. */
static void a_hull_at_a_shore_gives_no_more_than_it_loses(void** state) {
    (void)state;
    enum { N = 12, SHORE = 6 };
    for (cd_momentum momentum = CD_MOMENTUM_LINEAR; momentum <= CD_MOMENTUM_ADVECTED; ++momentum) {
        const double dx = 0.5, depth = 0.5, mass = 1;
        cd_water* w;
        ok(cd_water_create(N, 1, dx, dx, CD_FLOAT64, NULL, &w));
        ok(cd_water_set_momentum(w, momentum));
        for (size_t i = SHORE; i < N; ++i) pool_set(w, CD_BED, i, 0, depth * (1 - 1e-6));
        for (size_t i = 0; i < SHORE; ++i) pool_set(w, CD_DEPTH, i, 0, depth);
        ok(cd_water_set_hulls(w, 1, 1, 1));
        ok(cd_water_set_hull(w, 0, mass, dx / 4, dx / 4, NULL, 0));
        ok(cd_water_set_hull_pose(w, 0, (const double[]){(SHORE + 0.3) * dx, dx / 2, 0.98 * depth, 1, 0, 0, 0}, 7));
        ok(cd_water_set_hull_velocity(w, 0, (const double[]){-1, 0, 0, 0, 0, 0}, 6));
        ok(cd_water_set_hull_drag(w, 0, 1e6, 1e6, 0));
        const double start = energy(w);
        for (int step = 0; step < 10; ++step) {
            pool_step(w, 0.01, 1);
            assert_true(energy(w) <= start);
        }
        cd_water_destroy(w);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(water_and_hulls_gain_no_energy),
        cmocka_unit_test(a_wave_gives_a_light_hull_no_more_than_it_has),
        cmocka_unit_test(a_hull_of_any_mass_comes_to_rest_in_long_steps),
        cmocka_unit_test(hulls_among_islands_gain_no_more_than_they_owe),
        cmocka_unit_test(a_hull_at_a_shore_gives_no_more_than_it_loses),
        cmocka_unit_test(hulls_that_turn_stay_bounded_in_any_step),
        cmocka_unit_test(a_hull_that_leaves_the_water_comes_down_in_long_steps),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
