/* Cloth that touches planes, spheres and capsules: at rest, on slopes, thrown, swept along, over bodies that move. */
#include <math.h>
#include <string.h>

#include "check.h"
#include "cloth.h"
#include "reference.h"
#include "sheet.h"

enum { MOST = 900 }; /* nodes */
static const double nowhere[3] = {0, 0, 0}, up[3] = {0, 1, 0}, weight[3] = {0, -9.81, 0};

/* A level square sheet of 1 m and 0.2 kg whose middle is at (0, height, 0), and so many colliders. */
static cd_membrane* level(size_t springs, double height, size_t colliders) {
    cd_membrane* m = cloth(springs, springs, 3, CD_FLOAT64);
    ok(cd_membrane_set_rest_length(m, 1, 1));
    ok(cd_membrane_set_mass(m, 0.2));
    ok(cd_membrane_set_stiffness(m, 3000, 3000));
    ok(cd_membrane_set_shear(m, 100));
    ok(cd_membrane_set_bend(m, 1e-5));
    ok(cd_membrane_set_gravity(m, weight, 3));
    ok(cd_membrane_set_colliders(m, colliders));
    for (size_t v = 0; v <= springs; ++v)
        for (size_t u = 0; u <= springs; ++u) {
            const double x[3] = {(double)u / (double)springs - 0.5, height, (double)v / (double)springs - 0.5};
            ok(cd_membrane_write_f64(m, CD_POSITION, u, v, 1, 1, x, 3));
        }
    return m;
}
static size_t nodes_of(const cd_membrane* m) { return cloth_extent(m, CD_POSITION).count / 3; }

/* Turns x and y round z by this angle. */
static void turn(cd_membrane* m, double angle) {
    const double c = cos(angle), s = sin(angle), rotation[9] = {c, -s, 0, s, c, 0, 0, 0, 1};
    ok(cd_membrane_teleport(m, rotation, nowhere, 3));
}
static void throw_at(cd_membrane* m, double x, double y, double z) {
    double v[MOST][3];
    for (size_t i = 0; i < nodes_of(m); ++i) v[i][0] = x, v[i][1] = y, v[i][2] = z;
    cloth_write(m, CD_VELOCITY, v[0]);
}
static double fastest(const cd_membrane* m) {
    double v[MOST][3], most = 0;
    cloth_read(m, CD_VELOCITY, v[0]);
    for (size_t i = 0; i < nodes_of(m); ++i)
        most = fmax(most, sqrt(v[i][0] * v[i][0] + v[i][1] * v[i][1] + v[i][2] * v[i][2]));
    return most;
}
static void middle_of(const cd_membrane* m, cd_field field, double* middle) {
    double x[MOST][3];
    const size_t nodes = nodes_of(m);
    cloth_read(m, field, x[0]);
    for (int k = 0; k < 3; ++k) {
        middle[k] = 0;
        for (size_t i = 0; i < nodes; ++i) middle[k] += x[i][k] / (double)nodes;
    }
}

/* How near the node comes that is nearest to a collider, or how deep the deepest is in it, below 0. */
static double least_gap(const cd_membrane* m) {
    double x[MOST][3], least = INFINITY;
    size_t count;
    cloth_read(m, CD_POSITION, x[0]);
    ok(cd_membrane_get_colliders(m, &count));
    for (size_t c = 0; c < count; ++c) {
        double a[3], b[3], radius;
        cd_shape shape;
        ok(cd_membrane_get_collider(m, c, &shape, a, b, NULL, 3, &radius, NULL));
        for (size_t i = 0; i < nodes_of(m); ++i) {
            double gap = 0, along = 0, whole = 0;
            for (int k = 0; k < 3; ++k) {
                const double way = shape == CD_SHAPE_PLANE ? b[k] : b[k] - a[k];
                along += way * (x[i][k] - a[k]), whole += way * way;
            }
            if (shape == CD_SHAPE_PLANE) gap = along / sqrt(whole);
            else {
                along = whole > 0 ? fmin(fmax(along / whole, 0), 1) : 0;
                for (int k = 0; k < 3; ++k) {
                    const double off = x[i][k] - a[k] - along * (b[k] - a[k]);
                    gap += off * off;
                }
                gap = sqrt(gap) - radius;
            }
            least = fmin(least, gap);
        }
    }
    return least;
}

/* On a plane, and on its thickness above it; it yields by the weight of a node, times dt^2 / 1e4 of its mass. */
static void a_dropped_sheet_comes_to_rest(void** state) {
    (void)state;
    static const double thicknesses[] = {0, 0.01}, steps[] = {1 / 60.0, 1 / 240.0, 0.1}, tilts[] = {0, 0.2};
    for (size_t t = 0; t < COUNT(thicknesses); ++t)
        for (size_t s = 0; s < COUNT(steps); ++s)
            for (size_t a = 0; a < COUNT(tilts); ++a) {
                cd_membrane* m = level(16, 0, 1);
                turn(m, tilts[a]);
                ok(cd_membrane_teleport(m, NULL, (double[3]){0, 0.3, 0}, 3));
                ok(cd_membrane_set_plane(m, 0, nowhere, up, 3, 0.4));
                ok(cd_membrane_set_thickness(m, thicknesses[t]));
                ok(cd_membrane_step(m, steps[s], (size_t)(8 / steps[s]) + 100));
                const double speed = fastest(m), gap = least_gap(m) - thicknesses[t];
                const double yields = 9.81 * steps[s] * steps[s] / 1e4;
                print_message("dropped, dt %.4f, tilt %g: at %.1e m/s, yields %.3f of what it may\n", steps[s],
                              tilts[a], speed, -gap / yields);
                assert_true(speed < (a == 0 ? 1e-6 : 1e-3)); /* what landed crumpled creeps against its friction */
                assert_true(gap > -1.01 * yields);
                if (a == 0) assert_near(gap, -yields, 1e-3, 0);
                cd_membrane_destroy(m);
            }
}

/* Of friction 1/2, whose share v / (v + 1e-3 m/s) of it acts at the speed v: how fast a body slides after so many steps
 * of lambda = 1, and how far it came. It creeps where friction holds it. */
static double slide(double slope, double dt, size_t steps, double* way) {
    const double along = 9.81 * sin(atan(slope)), most = 0.5 * 9.81 * cos(atan(slope)), e = 1e-3;
    double v = 0;
    *way = 0;
    for (size_t n = 0; n < steps; ++n) { /* v1 = v + dt (along - most v1 / (v1 + e)) */
        const double b = e + dt * (most - along) - v, c = -e * (v + dt * along);
        v = b > 0 ? -2 * c / (b + sqrt(b * b - 4 * c)) : (-b + sqrt(b * b - 4 * c)) / 2;
        *way += dt * v;
    }
    return v;
}

static void a_slope_holds_or_lets_slide(void** state) {
    (void)state;
    static const double slopes[] = {0.1, 0.4, 0.6, 0.8, 3};
    for (size_t s = 0; s < COUNT(slopes); ++s)
        for (int way = 0; way < 4; ++way) {
            const int little = way / 2; /* effort */
            const double angle = -atan(slopes[s]), dt = way % 2 ? 1 / 30.0 : 1 / 60.0;
            const double normal[3] = {-3 * sin(angle), 3 * cos(angle), 0}, down[2] = {cos(angle), sin(angle)};
            double before[3], after[3], v[3], wanted;
            cd_membrane* m = level(8, 0, 1);
            turn(m, angle);
            ok(cd_membrane_set_plane(m, 0, nowhere, normal, 3, 0.5));
            if (!little) ok(cd_membrane_set_effort(m, 30, 200));
            middle_of(m, CD_POSITION, before);
            const size_t steps = way % 2 ? 30 : 60;
            const double speed = slide(slopes[s], dt, steps, &wanted);
            ok(cd_membrane_step(m, dt, steps));
            middle_of(m, CD_POSITION, after);
            middle_of(m, CD_VELOCITY, v);
            const double moved = down[0] * (after[0] - before[0]) + down[1] * (after[1] - before[1]);
            const double found = down[0] * v[0] + down[1] * v[1];
            print_message("slope %g, dt %.4f, effort %s: moved %.5f m of %.5f m, at %.5f m/s of %.5f m/s\n", slopes[s],
                          dt, little ? "as it is" : "30 x 200", moved, wanted, found, speed);
            assert_true(least_gap(m) > -1e-5);
            if (!little || slopes[s] < 0.5) assert_near(found, speed, 1e-3, 0);
            if (!little) assert_near(moved, wanted, 1e-3, 0);
            else assert_true(moved > 0.4 * wanted && moved < 1.01 * wanted); /* few iterations start it late */
            cd_membrane_destroy(m);
        }
}

/* However much friction there is, what lies inside comes out, and then stays where it is, steep as the slope may be. */
static void any_friction_lets_out_and_holds(void** state) {
    (void)state;
    static const double frictions[] = {1e3, 1e6, 1e12, 1e20, 1e60};
    for (size_t f = 0; f < COUNT(frictions); ++f) {
        const double angle = -1.3, depth = 0.05, normal[3] = {-sin(angle), cos(angle), 0};
        const double point[3] = {depth * normal[0], depth * normal[1], 0};
        double before[3], after[3];
        cd_membrane* m = level(8, 0, 1);
        turn(m, angle);
        ok(cd_membrane_set_plane(m, 0, point, normal, 3, frictions[f]));
        middle_of(m, CD_POSITION, before);
        ok(cd_membrane_step(m, 1 / 60.0, 60));
        middle_of(m, CD_POSITION, after);
        const double moved = cos(angle) * (after[0] - before[0]) + sin(angle) * (after[1] - before[1]);
        print_message("friction %g: %.1e m deep, moved %.1e m\n", frictions[f], -least_gap(m), moved);
        assert_true(least_gap(m) > -1e-5);
        assert_true(fabs(moved) < fmax(1e-8, 4e-3 / frictions[f]));
        cd_membrane_destroy(m);
    }
}

/* A belt under the sheet: it comes along by friction g / 2, until it goes as the belt does. */
static void a_belt_takes_the_sheet_along(void** state) {
    (void)state;
    const double dt = 1 / 120.0, along[3] = {1.5, 0, 0.5}, speed = hypot(1.5, 0.5);
    double v[3];
    cd_membrane* m = level(12, 0, 1);
    ok(cd_membrane_set_plane(m, 0, nowhere, up, 3, 0.5));
    ok(cd_membrane_set_collider_velocity(m, 0, along, 3));
    ok(cd_membrane_step(m, dt, 24));
    middle_of(m, CD_VELOCITY, v);
    print_message("belt: after 0.2 s at %.4f m/s of %.4f m/s\n", hypot(v[0], v[2]), 0.2 * 0.5 * 9.81);
    assert_near(hypot(v[0], v[2]), 0.2 * 0.5 * 9.81, 0.03, 0);
    ok(cd_membrane_step(m, dt, 120));
    middle_of(m, CD_VELOCITY, v);
    assert_near(v[0], along[0], 1e-3, speed);
    assert_near(v[2], along[2], 1e-3, speed);
    cd_membrane_destroy(m);
}

/* At 50 m/s, at a plane, a sphere, a thin capsule: no node is in them after any step, but for what a contact yields
 * that stops so much in a step, and those that met the plane stay on its side. */
static void nothing_goes_through_however_fast(void** state) {
    (void)state;
    double deepest = 0;
    for (int way = 0; way < 12; ++way) {
        const double dt = way % 2 ? 1 / 30.0 : 1 / 60.0, speed = 50;
        cd_membrane* m = level(20, 1.2, 1);
        if (way % 6 >= 4) turn(m, 0.3);
        if (way / 6) ok(cd_membrane_set_thickness(m, 0.02));
        if (way % 6 < 2) ok(cd_membrane_set_plane(m, 0, nowhere, up, 3, 0.3));
        else if (way % 6 < 4) ok(cd_membrane_set_capsule(m, 0, nowhere, nowhere, 3, 0.5, 0.3));
        else ok(cd_membrane_set_capsule(m, 0, (double[3]){-2, 0, 0}, (double[3]){2, 0, 0}, 3, 0.05, 0.3));
        throw_at(m, 0, -speed, 0);
        double through = -1;
        for (int n = 0; n < 30; ++n) {
            ok(cd_membrane_step(m, dt, 1));
            const double depth = (way / 6 ? 0.02 : 0) - least_gap(m);
            through = fmax(through, depth);
        }
        double x[3];
        ok(cd_membrane_read_f64(m, CD_POSITION, 10, 10, 1, 1, x, 3)); /* its middle, that hits */
        print_message("thrown, way %d: deepest %.1e m, middle at %.3f m\n", way, through, x[1]);
        deepest = fmax(deepest, through);
        assert_true(x[1] > -0.01);
        assert_true(through < 4e-3); /* a few nodes stop all of the sheet */
        cd_membrane_destroy(m);
    }
    print_message("thrown with 50 m/s: deepest %.1e m\n", deepest);
}

/* Down a shaft onto a bar: the four walls are nearer than the bar, until a step goes past it. */
static void what_lies_ahead_counts_before_what_is_near(void** state) {
    (void)state;
    for (int way = 0; way < 8; ++way) {
        const double dt = way % 2 ? 1 / 30.0 : 1 / 60.0, speed = 5 << way / 2;
        cd_membrane* m = level(8, 0, 5);
        for (size_t wall = 0; wall < 4; ++wall) {
            double point[3] = {0, 0, 0}, inwards[3] = {0, 0, 0};
            const size_t axis = wall / 2 * 2;
            inwards[axis] = wall % 2 ? 1 : -1;
            point[axis] = -0.52 * inwards[axis];
            ok(cd_membrane_set_plane(m, wall, point, inwards, 3, 0));
        }
        ok(cd_membrane_set_capsule(m, 4, (double[3]){-1, -0.8, 0}, (double[3]){1, -0.8, 0}, 3, 0.1, 0));
        throw_at(m, 0, -speed, 0);
        double deepest = 0, middle[3];
        for (int n = 0; n < 15; ++n) ok(cd_membrane_step(m, dt, 1)), deepest = fmax(deepest, -least_gap(m));
        ok(cd_membrane_read_f64(m, CD_POSITION, 4, 4, 1, 1, middle, 3)); /* above the bar */
        print_message("down a shaft at %g m/s, dt %.4f: %.1e m deep, middle at %.3f m\n", speed, dt, deepest,
                      middle[1]);
        assert_true(deepest < 4e-3);
        assert_true(middle[1] > -0.8);
        cd_membrane_destroy(m);
    }
}

/* An upright bar that moves through where a sheet stands: no node passes it, and in the end all go with it. */
static void a_bar_that_moves_sweeps_the_sheet_along(void** state) {
    (void)state;
    for (int way = 0; way < 2; ++way) {
        const double dt = way ? 1 / 30.0 : 1 / 60.0, velocity[3] = {3, 0, 0}, radius = 0.2;
        double v[3], x[3], deepest = 0;
        cd_membrane* m = level(16, 0, 1);
        ok(cd_membrane_set_gravity(m, nowhere, 3));
        turn(m, acos(-1) / 2);
        ok(cd_membrane_teleport(m, NULL, (double[3]){0.5, 0, 0}, 3));
        ok(cd_membrane_set_air(m, 0.05, 1));
        ok(cd_membrane_set_capsule(m, 0, (double[3]){0, -5, 0}, (double[3]){0, 5, 0}, 3, radius, 0.3));
        ok(cd_membrane_set_collider_velocity(m, 0, velocity, 3));
        for (int n = 0; n < (way ? 60 : 120); ++n) {
            ok(cd_membrane_step(m, dt, 1));
            deepest = fmax(deepest, -least_gap(m));
        }
        assert_true(deepest < (way ? 2.5e-3 : 1e-3)); /* of 0.1 m a step with way = 1 */
        middle_of(m, CD_VELOCITY, v);
        ok(cd_membrane_read_f64(m, CD_POSITION, 8, 8, 1, 1, x, 3));
        print_message("swept for 2 s at 3 m/s: its middle at %.4f m, all at %.3f m/s, deepest %.1e m\n", x[0], v[0],
                      deepest);
        assert_near(x[0], 6 + radius, 1e-3, 1);
        assert_near(v[0], 3, 0.05, 0);
        cd_membrane_destroy(m);
    }
}

/* However stiff, and however few iterations a step takes: what moves into a sheet takes it along, and so does a held edge. */
static void a_stiff_sheet_goes_along(void** state) {
    (void)state;
    static const double stiffnesses[] = {1e4, 1e6, 1e8}, normal[3] = {0.6, 0.64, 0.48}, dt = 1 / 60.0, speed = 8;
    double deepest = 0, slowest = speed, fastest_one = 0;
    for (size_t s = 0; s < COUNT(stiffnesses); ++s)
        for (size_t newton = 1; newton < 6; ++newton) {
            const double velocity[3] = {speed * normal[0], speed * normal[1], speed * normal[2]};
            cd_membrane *pushed = level(12, 0, 1), *held = level(12, 0, 0);
            double v[3], all[MOST][3] = {{0}};
            ok(cd_membrane_set_plane(pushed, 0, (double[3]){-0.6, -0.64, -0.48}, normal, 3, 0.5));
            ok(cd_membrane_set_collider_velocity(pushed, 0, velocity, 3));
            ok(cd_membrane_set_edge(held, CD_EDGE_V_FIRST, CD_NODE_DRIVEN));
            for (size_t i = 0; i < 13; ++i) memcpy(all[i], velocity, sizeof velocity);
            cloth_write(held, CD_VELOCITY, all[0]);
            for (int k = 0; k < 2; ++k) {
                cd_membrane* m = k ? held : pushed;
                ok(cd_membrane_set_gravity(m, nowhere, 3));
                ok(cd_membrane_set_stiffness(m, stiffnesses[s], stiffnesses[s]));
                ok(cd_membrane_set_effort(m, newton, newton % 2));
                for (int n = 0; n < 60; ++n) {
                    ok(cd_membrane_step(m, dt, 1));
                    if (!k) deepest = fmax(deepest, -least_gap(m));
                }
                middle_of(m, CD_VELOCITY, v);
                const double along = v[0] * normal[0] + v[1] * normal[1] + v[2] * normal[2];
                slowest = fmin(slowest, along), fastest_one = fmax(fastest_one, along);
                cd_membrane_destroy(m);
            }
        }
    print_message("taken along at 8 m/s: by %.2f to %.2f m/s, at most %.3f of a step's way deep\n", slowest,
                  fastest_one, deepest / (speed * dt));
    assert_true(deepest < 0.1 * speed * dt);
    assert_true(slowest > 0.9 * speed && fastest_one < 1.25 * speed);
}

static void what_starts_inside_comes_out_and_is_not_thrown(void** state) {
    (void)state;
    for (int way = 0; way < 4; ++way) {
        const double dt = way % 2 ? 1 / 60.0 : 1e-3;
        cd_membrane* m = level(12, way < 2 ? -0.05 : 0.45, 1);
        ok(cd_membrane_set_gravity(m, nowhere, 3));
        if (way < 2) ok(cd_membrane_set_plane(m, 0, nowhere, up, 3, 0.3));
        else ok(cd_membrane_set_capsule(m, 0, nowhere, nowhere, 3, 0.5, 0.3)); /* its top comes out by 5 cm */
        double fast = 0;
        ok(cd_membrane_step(m, dt, 1));
        const double first = -least_gap(m);
        for (int n = 0; n < 60; ++n) ok(cd_membrane_step(m, dt, 1)), fast = fmax(fast, fastest(m));
        const double then = -least_gap(m);
        print_message("began inside, way %d: %.1e m deep after a step, %.1e m after more, at most %.1e m/s\n", way,
                      first, then, fast);
        if (way < 2) assert_true(first < 1.01 * 0.05 / 1e4);
        assert_true(then < 1e-5);
        assert_true(fast < (way < 2 ? 1e-5 : 0.2 * 0.05 / dt)); /* the springs that are drawn out pull */
        cd_membrane_destroy(m);
    }
}

/* Over a ball on a floor: no node is nearer than the thickness, and no energy comes from nothing. */
static void a_tablecloth_keeps_its_thickness_and_gains_no_energy(void** state) {
    (void)state;
    static const double steps[] = {1 / 240.0, 1 / 60.0, 0.1};
    for (size_t s = 0; s < COUNT(steps); ++s)
        for (int way = 0; way < 2; ++way) {
            const double thickness = 0.01, below[3] = {0, -0.45, 0};
            cd_membrane* m = level(24, 0.35, 2);
            ok(cd_membrane_set_capsule(m, 0, nowhere, nowhere, 3, 0.25, 0.4));
            ok(cd_membrane_set_plane(m, 1, below, up, 3, 0.4));
            ok(cd_membrane_set_thickness(m, thickness));
            if (way) ok(cd_membrane_set_effort(m, 1, 4));
            double before = sheet_energy(m), deepest = -1, risen = 0;
            for (double t = 0; t < 2; t += steps[s]) {
                ok(cd_membrane_step(m, steps[s], 1));
                const double now = sheet_energy(m);
                risen = fmax(risen, now - before);
                before = now;
                deepest = fmax(deepest, thickness - least_gap(m));
            }
            print_message("tablecloth, dt %.4f, effort %d: %.1e m too near, energy rose by %.1e J\n", steps[s], way,
                          deepest, risen);
            assert_true(deepest < (way ? 4e-3 : steps[s] > 0.05 ? 2.5e-3 : 1e-3));
            assert_true(risen < 1e-12);
            cd_membrane_destroy(m);
        }
}

/* Two planes that meet: what one pushes out of itself does not go into the other. */
static void a_sheet_in_a_gutter_enters_neither_side(void** state) {
    (void)state;
    const double left[3] = {1, 1, 0}, right[3] = {-1, 1, 0};
    cd_membrane* m = level(16, 0.6, 2);
    double deepest = 0;
    ok(cd_membrane_set_plane(m, 0, nowhere, left, 3, 0.1));
    ok(cd_membrane_set_plane(m, 1, nowhere, right, 3, 0.1));
    for (int frame = 0; frame < 120; ++frame) {
        ok(cd_membrane_step(m, 1 / 60.0, 1));
        deepest = fmin(deepest, least_gap(m));
    }
    print_message("in a gutter: %.2e m deep at most\n", -deepest);
    assert_true(deepest > -2e-3); /* 7.6e-3 where nodes heed one plane only */
    cd_membrane_destroy(m);
}

/* Thrown along a plane that it falls onto, with the default effort: friction takes mu g t of its speed. Its nodes are at
 * first as fast as noise has them, across the plane and along. */
static void what_lands_sliding_loses_what_friction_takes(void** state) {
    (void)state;
    static const double speeds[] = {1, 3, 10}, coefficients[] = {0.05, 0.2, 0.5}, noises[] = {0, 0.01, 0.2};
    for (int n = 0; n < 27; ++n) {
        const double fast = speeds[n % 3], mu = coefficients[n / 3 % 3], noise = noises[n / 9];
        const int steps = 30;
        double v[3], before[3], x[MOST][3];
        uint64_t seed = (uint64_t)n;
        cd_membrane* m = level(15, 0.02, 1);
        ok(cd_membrane_set_plane(m, 0, nowhere, up, 3, mu));
        for (size_t i = 0; i < nodes_of(m); ++i)
            for (int k = 0; k < 3; ++k) x[i][k] = (k == 0 ? fast : 0) + noise * random_number(&seed);
        cloth_write(m, CD_VELOCITY, x[0]);
        middle_of(m, CD_VELOCITY, before);
        ok(cd_membrane_step(m, 1 / 60.0, (size_t)steps));
        middle_of(m, CD_VELOCITY, v);
        const double taken = fmin(mu * (9.81 * steps / 60.0 + before[1]), before[0]), off = v[0] - (before[0] - taken);
        print_message("lands at %g m/s, noise %g, friction %g: %.3f m/s too fast, of %.3f that friction takes\n", fast,
                      noise, mu, off, taken);
        assert_true(fabs(off) < 0.05 * taken + 0.01);
        cd_membrane_destroy(m);
    }
}

/* Sheets that lie in the plane exactly: one that slopes without friction, and one that goes and has some. */
static void what_lies_flat_begins_to_slide(void** state) {
    (void)state;
    for (uint64_t scene = 1; scene <= 800; ++scene) {
        uint64_t seed = 40 + scene % 400;
        const int belt = scene % 2 != 0;
        const double velocity[3] = {-1, 0, 0};
        double pull[3] = {belt ? 0 : 1, -8 + 2 * random_number(&seed), 0}, v[3];
        cd_membrane* m = level(1 + scene % 10, 0, 1);
        const double stiffness = pow(10, 2.5 + 1.5 * random_number(&seed));
        ok(cd_membrane_set_stiffness(m, stiffness, stiffness));
        ok(cd_membrane_set_shear(m, 0));
        ok(cd_membrane_set_bend(m, 0));
        ok(cd_membrane_set_gravity(m, pull, 3));
        ok(cd_membrane_set_plane(m, 0, nowhere, up, 3, belt ? 0.3 : 0));
        if (belt) ok(cd_membrane_set_collider_velocity(m, 0, velocity, 3));
        if (scene > 400) ok(cd_membrane_set_effort(m, 3, 12));
        ok(cd_membrane_step(m, 1 / 60.0, 60));
        middle_of(m, CD_VELOCITY, v);
        assert_near(v[0], belt ? -1 : 1, 0.5, 0);
        cd_membrane_destroy(m);
    }
}

/* Nodes exactly on the axis of a capsule that lies along x, y or z, and in the middle of a sphere. */
static void what_lies_on_an_axis_comes_out(void** state) {
    (void)state;
    for (int axis = 0; axis < 4; ++axis) {
        double a[3] = {0, 0, 0}, b[3] = {0, 0, 0};
        cd_membrane* m = level(1, 0, 1);
        if (axis < 3) a[axis] = -5, b[axis] = 5;
        for (size_t u = 0; u < 4; ++u) {
            const double x[3] = {u == 0 ? 0 : 50, u == 0 ? 0 : 50 + (double)u, 0};
            ok(cd_membrane_write_f64(m, CD_POSITION, u % 2, u / 2, 1, 1, x, 3));
        }
        ok(cd_membrane_set_stiffness(m, 0, 0));
        ok(cd_membrane_set_shear(m, 0));
        ok(cd_membrane_set_gravity(m, nowhere, 3));
        ok(cd_membrane_set_capsule(m, 0, a, b, 3, 0.1, 0));
        ok(cd_membrane_step(m, 1 / 60.0, 1));
        assert_true(least_gap(m) > -1e-4);
        cd_membrane_destroy(m);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_dropped_sheet_comes_to_rest),
        cmocka_unit_test(a_slope_holds_or_lets_slide),
        cmocka_unit_test(any_friction_lets_out_and_holds),
        cmocka_unit_test(a_belt_takes_the_sheet_along),
        cmocka_unit_test(what_lands_sliding_loses_what_friction_takes),
        cmocka_unit_test(what_lies_flat_begins_to_slide),
        cmocka_unit_test(what_lies_on_an_axis_comes_out),
        cmocka_unit_test(nothing_goes_through_however_fast),
        cmocka_unit_test(what_lies_ahead_counts_before_what_is_near),
        cmocka_unit_test(a_stiff_sheet_goes_along),
        cmocka_unit_test(a_bar_that_moves_sweeps_the_sheet_along),
        cmocka_unit_test(what_starts_inside_comes_out_and_is_not_thrown),
        cmocka_unit_test(a_sheet_in_a_gutter_enters_neither_side),
        cmocka_unit_test(a_tablecloth_keeps_its_thickness_and_gains_no_energy),
    };
    return cmocka_run_group_tests_name("cloth that touches", tests, NULL, NULL);
}
