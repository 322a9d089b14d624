/* Cloth keeps its size and falls, both at once, within the effort of a step: a solver that moves as through syrup
 * stretches little. */
#include <math.h>

#include "check.h"
#include "cloth.h"

enum { SPRINGS = 63, LARGE = 127, MOST = (LARGE + 1) * (LARGE + 1) };      /* along a line; nodes in all */
static const double weight[3] = {0, -9.81, 0}, dt = 1 / 60.0, kUsual = 80; /* the default compression */

/* A level sheet of 1 m and 0.2 kg, of springs of so many N/m. */
static cd_membrane* sheet_of(size_t count, double stiffness, double shear, double bend) {
    const double n = (double)(count + 1), springs = (double)count;
    cd_membrane* m = cloth(count, count, 3, CD_FLOAT64);
    ok(cd_membrane_set_rest_length(m, 1, 1));
    ok(cd_membrane_set_mass(m, 0.2));
    ok(cd_membrane_set_stiffness(m, stiffness * n / springs, stiffness * n / springs));
    ok(cd_membrane_set_shear(m, shear));
    ok(cd_membrane_set_bend(m, bend));
    ok(cd_membrane_set_gravity(m, weight, 3));
    for (size_t v = 0; v <= count; ++v)
        for (size_t u = 0; u <= count; ++u) {
            const double x[3] = {(double)u / springs, 0, (double)v / springs};
            ok(cd_membrane_write_f64(m, CD_POSITION, u, v, 1, 1, x, 3));
        }
    return m;
}
static cd_membrane* sheet(size_t count) {
    const double springs = (double)count;
    return sheet_of(count, 3000, 100, 0.05 * (springs + 1) / (springs * springs * springs));
}

struct stretch {
    double worst, mean; /* the mean is that of squares */
};
static struct stretch stretch_of(const cd_membrane* m) {
    static double strain[MOST];
    static const cd_field fields[2] = {CD_STRAIN_U, CD_STRAIN_V};
    struct stretch all = {0, 0};
    for (size_t d = 0; d < 2; ++d) {
        const size_t count = cloth_extent(m, fields[d]).count;
        cloth_read(m, fields[d], strain);
        for (size_t i = 0; i < count; ++i) {
            const double longer = fmax(strain[i], 0);
            all.worst = fmax(all.worst, longer), all.mean += longer * longer / (2 * (double)count);
        }
    }
    all.mean = sqrt(all.mean);
    return all;
}
static double mean_height(const cd_membrane* m) {
    static double x[MOST][3];
    const size_t nodes = cloth_extent(m, CD_MASS).count;
    double sum = 0;
    cloth_read(m, CD_POSITION, x[0]);
    for (size_t i = 0; i < nodes; ++i) sum += x[i][1];
    return sum / (double)nodes;
}

/* How many of all triples of neighbours along a line are folded by more than a right angle, and how long springs are on
 * average, over their length. */
static void folds_of(const cd_membrane* m, double* folded, double* length) {
    enum { NODES = SPRINGS + 1 };
    static double x[NODES * NODES][3];
    size_t triples = 0, folds = 0;
    double sum = 0;
    cloth_read(m, CD_POSITION, x[0]);
    for (size_t along = 0; along < 2; ++along)
        for (size_t line = 0; line < NODES; ++line)
            for (size_t i = 1; i < SPRINGS; ++i) {
                const size_t step = along ? NODES : 1, at = along ? i * NODES + line : line * NODES + i;
                double product = 0, square = 0;
                for (int k = 0; k < 3; ++k) {
                    const double way = x[at][k] - x[at - step][k];
                    product += way * (x[at + step][k] - x[at][k]), square += way * way;
                }
                ++triples, folds += product < 0;
                sum += sqrt(square) * SPRINGS;
            }
    *folded = (double)folds / (double)triples;
    *length = sum / (double)triples;
}

static void hold_corners(cd_membrane* m, size_t springs, size_t patch) {
    const double pinned = CD_NODE_PINNED;
    ok(cd_membrane_enable_field(m, CD_PIN));
    for (size_t v = 0; v < patch; ++v)
        for (size_t u = 0; u < patch; ++u) {
            ok(cd_membrane_write_f64(m, CD_PIN, u, v, 1, 1, &pinned, 1));
            ok(cd_membrane_write_f64(m, CD_PIN, springs - u, v, 1, 1, &pinned, 1));
        }
}

/* Held by two corners, patches of as many nodes as the sheet is finer, after 20 frames and until 40: with the effort of a
 * step as it is, and far more. */
static double fall(size_t springs, double compression, size_t newton, size_t gradient, struct stretch* most) {
    cd_membrane* m = sheet(springs);
    double height = 0;
    ok(cd_membrane_set_compression(m, compression));
    hold_corners(m, springs, (springs + 1) / (SPRINGS + 1));
    if (newton > 0) ok(cd_membrane_set_effort(m, newton, gradient));
    *most = (struct stretch){0, 0};
    for (int frame = 1; frame <= 40; ++frame) {
        ok(cd_membrane_step(m, dt, 1));
        if (frame == 20) height = mean_height(m);
        if (frame < 20) continue;
        const struct stretch now = stretch_of(m);
        most->worst = fmax(most->worst, now.worst), most->mean = fmax(most->mean, now.mean);
    }
    cd_membrane_destroy(m);
    return height;
}
static void a_sheet_falls_and_keeps_its_size(void** state) {
    (void)state;
    const struct {
        double compression, worst, converged;
    } cases[] = {{10, 0.033, 0.033}, {kUsual, 0.035, 0.037}}; /* the livelier sheet swings further */
    for (size_t i = 0; i < COUNT(cases); ++i) {
        struct stretch usual, converged;
        const double height = fall(SPRINGS, cases[i].compression, 0, 0, &usual),
                     right = fall(SPRINGS, cases[i].compression, 10, 100, &converged);
        print_message("compression %g: height %.4f, converged %.4f; stretch %.4f and %.4f, converged %.4f and %.4f\n",
                      cases[i].compression, height, right, usual.worst, usual.mean, converged.worst, converged.mean);
        assert_true(fabs(height - right) < 0.0085 * fabs(right)); /* 0.014 if each step began at rest */
        assert_true(usual.worst < cases[i].worst && usual.mean < 0.003);
        assert_true(converged.worst < cases[i].converged && converged.mean < 0.0028);
    }
}

/* By default a step takes few iterations where they suffice, and many where they bring something: for stiff bend, for
 * stiff shear, for long lines. */
static void a_step_takes_as_many_iterations_as_bring_something(void** state) {
    (void)state;
    const double unit = 0.2 / (dt * dt * pow(SPRINGS, 4)); /* of bend: mass / (dt^2 n^4) */
    static const double compressions[2] = {10, kUsual};
    const struct {
        const char* name;
        size_t springs;
        double stiffness, shear, bend, converged[2],
            within[2];      /* converged: of 60 iterations by Newton's method, 300 each */
        double least, most; /* iterations a step */
    } cases[] = {
        {"soft", SPRINGS, 3000, 100, 0, {-0.3869, -0.3841}, {0.009, 0.009}, 33, 41},
        {"stiff", SPRINGS, 72000, 2400, 0, {-0.3790, -0.3767}, {0.03, 0.03}, 40, 70},
        {"very stiff", SPRINGS, 720000, 24000, 0, {-0.3782, -0.3748}, {0.1, 0.1}, 40, 90},
        {"stiff in shear", SPRINGS, 3000, 3000, 0, {-0.3810, -0.3782}, {0.032, 0.032}, 50, 70},
        {"stiff in bend", SPRINGS, 3000, 100, 300 * unit, {-0.3857, -0.3836}, {0.022, 0.028}, 90, 125},
        {"very stiff in bend", SPRINGS, 3000, 100, 3000 * unit, {-0.3777, -0.3767}, {0.025, 0.03}, 200, 280},
        {"few nodes", 15, 3000, 100, 0, {-0.3797, -0.3776}, {0.01, 0.01}, 15, 25},
    };
    for (size_t i = 0; i < COUNT(cases); ++i)
        for (size_t c = 0; c < COUNT(compressions); ++c) {
            cd_membrane* m = sheet_of(cases[i].springs, cases[i].stiffness, cases[i].shear, cases[i].bend);
            size_t iterations;
            double sum = 0;
            hold_corners(m, cases[i].springs, 1);
            ok(cd_membrane_set_compression(m, compressions[c]));
            for (int frame = 0; frame < 20; ++frame) {
                ok(cd_membrane_step(m, dt, 1));
                ok(cd_membrane_get_convergence(m, &iterations, NULL));
                sum += (double)iterations / 20;
            }
            const double behind = 1 - mean_height(m) / cases[i].converged[c];
            print_message("%s, compression %g: %.1f iterations a step, %.2f%% behind\n", cases[i].name, compressions[c],
                          sum, 100 * behind);
            assert_true(fabs(behind) < cases[i].within[c]);
            assert_true(sum > cases[i].least && sum < cases[i].most);
            cd_membrane_destroy(m);
        }
}

/* Springs push where Newton's iterations find that they lead, so that what keeps cloth from crumpling does not hold up
 * what turns evenly, in long steps either: a sheet falls as far as one that may crumple. */
static void a_fall_is_not_held_up(void** state) {
    (void)state;
    const double rates[] = {1, 10, kUsual};
    double height[1 + COUNT(rates)];
    for (size_t i = 0; i <= COUNT(rates); ++i) {
        cd_membrane* m = sheet(SPRINGS);
        hold_corners(m, SPRINGS, 1);
        ok(cd_membrane_set_compression(m, i == 0 ? 0 : rates[i - 1]));
        ok(cd_membrane_step(m, 2 * dt, 10));
        height[i] = mean_height(m);
        print_message("compression %g, 30 steps a second: falls to %.4f\n", i == 0 ? 0 : rates[i - 1], height[i]);
        assert_near(height[i], height[0], 0.006, 0); /* 0.04 where springs go by the step's start */
        cd_membrane_destroy(m);
    }
}

static void a_fine_sheet_falls_and_keeps_its_size(void** state) {
    (void)state;
    const double converged = -0.3812; /* of 30 iterations by Newton's method with 300 each */
    struct stretch usual;
    const double height = fall(LARGE, kUsual, 0, 0, &usual);
    print_message("fine sheet: height %.4f; stretch %.4f and %.4f\n", height, usual.worst, usual.mean);
    assert_true(fabs(height - converged) < 0.025 * fabs(converged));
    assert_true(usual.worst < 0.05 && usual.mean < 0.003);
}

/* What the last step did is all of what a free sheet does: the first of Newton's iterations has nothing to add. */
static void a_free_fall_is_what_the_last_step_was(void** state) {
    (void)state;
    const size_t newton = 3, gradient = 12;
    size_t iterations;
    cd_membrane* m = sheet(SPRINGS);
    ok(cd_membrane_set_effort(m, newton, gradient));
    for (int step = 1; step <= 8; ++step) {
        ok(cd_membrane_step(m, 1 / 60.0, 1));
        ok(cd_membrane_get_convergence(m, &iterations, NULL));
        print_message("free fall, step %d: %zu iterations\n", step, iterations);
        if (step == 1) assert_true(iterations == newton * gradient);
        else assert_true(iterations <= (newton - 1) * gradient);
    }
    cd_membrane_destroy(m);
}

/* Over a ball, with friction: into folds, and not into needles or onto a crumpled heap. */
static void a_tablecloth_hangs_in_folds(void** state) {
    (void)state;
    const double ball[3] = {0.5, -0.3, 0.5};
    cd_membrane* m = sheet(SPRINGS);
    struct stretch most = {0, 0};
    double folded, length;
    ok(cd_membrane_set_colliders(m, 1));
    ok(cd_membrane_set_capsule(m, 0, ball, ball, 3, 0.25, 0.4));
    ok(cd_membrane_set_thickness(m, 0.004));
    for (int frame = 1; frame <= 60; ++frame) {
        ok(cd_membrane_step(m, dt, 1));
        if (frame == 5)
            assert_near(mean_height(m), -9.81 * dt * dt * 15, 1e-3, 0); /* it falls as if nothing were there */
        const struct stretch now = stretch_of(m);
        most.worst = fmax(most.worst, now.worst);
    }
    folds_of(m, &folded, &length);
    print_message("tablecloth: stretch %.4f, folded %.2f%%, springs %.3f of their length, height %.3f\n", most.worst,
                  100 * folded, length, mean_height(m));
    assert_true(most.worst < 0.012);
    assert_true(folded < 0.005);
    assert_true(length > 0.98);
    cd_membrane_destroy(m);
}

/* Flags in the wind wave without folding from node to node. */
static void flags_fly_without_needles(void** state) {
    (void)state;
    const struct {
        double speed, aside, frames; /* [m/s], a part of it, a second */
    } winds[] = {{6, 0.15, 60}, {8, 0.15, 60}, {11, 0.1, 60}, {12, 0.15, 30}};
    for (size_t i = 0; i < COUNT(winds); ++i) {
        const double speed = winds[i].speed, wind[3] = {speed, 0, winds[i].aside * speed};
        cd_membrane* m = sheet(SPRINGS);
        double most = 0, least = 1;
        ok(cd_membrane_set_edge(m, CD_EDGE_U_FIRST, CD_NODE_PINNED));
        ok(cd_membrane_set_air(m, 0.02 * speed, 1.2 * speed));
        ok(cd_membrane_set_wind(m, wind, 3));
        for (int frame = 1; frame <= 4 * winds[i].frames; ++frame) {
            double folded, length;
            ok(cd_membrane_step(m, 1 / winds[i].frames, 1));
            folds_of(m, &folded, &length);
            if (frame > winds[i].frames) most = fmax(most, folded), least = fmin(least, length);
        }
        print_message(
            "flag at %g m/s, %g frames a second: folded %.3f%% at most, springs %.3f of their length at least\n", speed,
            winds[i].frames, 100 * most, least);
        assert_true(most < 1e-3);
        assert_true(least > 0.95);
        cd_membrane_destroy(m);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_sheet_falls_and_keeps_its_size),
        cmocka_unit_test(a_step_takes_as_many_iterations_as_bring_something),
        cmocka_unit_test(a_fall_is_not_held_up),
        cmocka_unit_test(a_fine_sheet_falls_and_keeps_its_size),
        cmocka_unit_test(a_free_fall_is_what_the_last_step_was),
        cmocka_unit_test(a_tablecloth_hangs_in_folds),
        cmocka_unit_test(flags_fly_without_needles),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
