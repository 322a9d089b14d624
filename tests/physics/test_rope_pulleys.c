/* Ropes with weights: over pulleys one at each end, Atwood's machine, and what lambda = 1 takes from it; and one that
 * swings down. */
#include <math.h>

#include "check.h"
#include "reference.h"

enum { NODES = 201 };
static const double radius = 0.2, apart = 2, hang = 2, gravity = 9.81;

static double length_over(int pulleys) { return 2 * hang + acos(-1) * radius + (pulleys == 2 ? apart : 0); }

/* Where a rope that hangs equally on both sides is, at `s` of its length. */
static void place(int pulleys, double s, double* x) {
    const double quarter = acos(-1) / 2 * radius, half = length_over(pulleys) / 2;
    const double flat = pulleys == 2 ? apart / 2 : 0, from = fabs(s - half), side = s < half ? -1 : 1;
    const double angle = fmin(fmax(from - flat, 0), quarter) / radius, below = fmax(from - flat - quarter, 0);
    x[0] = side * (fmin(from, flat) + radius * sin(angle));
    x[1] = radius * cos(angle) - below;
}

/* Tells how fast the heavier end moves after `seconds` at first at `speed`, and how far it went. */
static double run(int pulleys, double heavy, double light, double speed, double seconds, int steps, double* out_way) {
    const double g[2] = {0, -gravity}, length = length_over(pulleys);
    double x[NODES][2], v[NODES][2], mass[NODES], end[2], way[2];
    cd_chain* c = NULL;
    ok(cd_chain_create(1, NODES - 1, 2, CD_FLOAT64, NULL, &c));
    ok(cd_chain_set_rest_length(c, length));
    ok(cd_chain_set_stiffness(c, INFINITY));
    ok(cd_chain_set_gravity(c, g, 2));
    ok(cd_chain_set_colliders(c, (size_t)pulleys));
    for (int p = 0; p < pulleys; ++p) {
        const double at[2] = {pulleys == 2 ? (p - 0.5) * apart : 0, 0};
        ok(cd_chain_set_capsule(c, (size_t)p, at, at, 2, radius, 0));
    }
    for (int i = 0; i < NODES; ++i) {
        const double s = length * i / (NODES - 1), d = 1e-4;
        double before[2], after[2];
        place(pulleys, s, x[i]), place(pulleys, s - d, before), place(pulleys, s + d, after);
        for (int k = 0; k < 2; ++k) v[i][k] = speed * (before[k] - after[k]) / (2 * d);
        mass[i] = i == 0 ? heavy : i == NODES - 1 ? light : 1e-4;
    }
    ok(cd_chain_enable_field(c, CD_MASS));
    ok(cd_chain_write_f64(c, CD_MASS, 0, 1, 0, NODES, mass, NODES));
    ok(cd_chain_write_f64(c, CD_POSITION, 0, 1, 0, NODES, x[0], 2 * NODES));
    ok(cd_chain_write_f64(c, CD_VELOCITY, 0, 1, 0, NODES, v[0], 2 * NODES));
    ok(cd_chain_step(c, seconds / steps, (size_t)steps));
    ok(cd_chain_read_f64(c, CD_POSITION, 0, 1, 0, 1, end, 2));
    ok(cd_chain_read_f64(c, CD_VELOCITY, 0, 1, 0, 1, way, 2));
    *out_way = x[0][1] - end[1];
    cd_chain_destroy(c);
    return -way[1];
}

/* The weights speed up by (heavy - light) g / (heavy + light), to first order in the step. */
static void weights_over_two_pulleys_move_as_atwood_says(void** state) {
    (void)state;
    const double seconds = 0.5, exact = 0.5 * (2 - 1) / (2 + 1.0) * gravity * seconds * seconds;
    double way, last = INFINITY;
    for (int steps = 30; steps <= 480; steps *= 4) {
        run(2, 2, 1, 0, seconds, steps, &way);
        const double error = way / exact - 1;
        print_message("%d steps: %.4f\n", steps, error);
        assert_true(fabs(error) < last);
        last = fabs(error) / 2.5;
    }
    assert_true(last < 0.02 / 2.5);
}

/* What chain.h says: a rope that slides at the speed v is braked as by a friction of v dt / radius, on half a turn by a
 * pull of pi times that. Between equal weights the speed then falls at the rate pi g dt / (2 radius). */
static void sliding_round_a_body_brakes_as_the_header_says(void** state) {
    (void)state;
    static const double speeds[] = {0.5, 1, 2};
    static const int rates[] = {30, 60, 240};
    for (size_t i = 0; i < COUNT(speeds); ++i)
        for (size_t r = 0; r < COUNT(rates); ++r) {
            const double seconds = 0.3, braking = acos(-1) * gravity / rates[r] / (2 * radius);
            double way;
            const double kept = run(1, 1, 1, speeds[i], seconds, (int)(seconds * rates[r]), &way) / speeds[i];
            print_message("%g m/s, %d steps a second: %.4f\n", speeds[i], rates[r], -log(kept) / seconds / braking);
            assert_near(-log(kept) / seconds, braking, 0.1, 0);
        }
}

/* A load at the end of a level rope of hardly any mass falls along a circle, in short steps too, in which the interior
 * point solves what Newton's method can't: it loses little energy. */
static void a_heavy_load_swings_down_as_it_should(void** state) {
    (void)state;
    enum { MOST = 401 };
    static const struct {
        int springs;
        double ratio, lambda;
    } cases[] = {{100, 1e9, 1}, {200, 1e9, 0.5}, {400, 1e6, 0.5}, {400, 1e9, 0.5}, {400, 1e9, 1}};
    for (size_t k = 0; k < COUNT(cases); ++k) {
        const size_t n = (size_t)cases[k].springs;
        const double g[2] = {0, -gravity}, length = 10, load = cases[k].ratio, dt = 1 / 960.0, fell = 0.783846;
        double x[MOST][2] = {{0}}, mass[MOST], before, now, end[2];
        cd_chain* c = NULL;
        ok(cd_chain_create(1, n, 2, CD_FLOAT64, NULL, &c));
        ok(cd_chain_set_lambda(c, cases[k].lambda));
        ok(cd_chain_set_rest_length(c, length));
        ok(cd_chain_set_stiffness(c, INFINITY));
        ok(cd_chain_set_gravity(c, g, 2));
        ok(cd_chain_enable_field(c, CD_MASS));
        for (size_t i = 0; i <= n; ++i)
            x[i][0] = length * (double)i / (double)n, mass[i] = i < n ? 1 / (n + 1.0) : load;
        ok(cd_chain_write_f64(c, CD_MASS, 0, 1, 0, n + 1, mass, n + 1));
        ok(cd_chain_write_f64(c, CD_POSITION, 0, 1, 0, n + 1, x[0], 2 * (n + 1)));
        ok(cd_chain_set_end(c, CD_END_FIRST, CD_NODE_PINNED));
        ok(cd_chain_get_energy(c, NULL, NULL, &before));
        ok(cd_chain_step(c, dt, 384)); /* 0.4 s */
        double kinetic, potential;
        ok(cd_chain_get_energy(c, &kinetic, NULL, &potential));
        now = kinetic + potential;
        ok(cd_chain_read_f64(c, CD_POSITION, 0, 1, n, 1, end, 2));
        const double lost = (before - now) / (load * gravity * length);
        print_message("%zu springs, load of %g, lambda %g: %.1e lost, fell %.5f m\n", n, load, cases[k].lambda, lost,
                      -end[1]);
        assert_true(fabs(lost) < 5e-4 && fabs(-end[1] - fell) < 5e-3 * fell);
        cd_chain_destroy(c);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(weights_over_two_pulleys_move_as_atwood_says),
        cmocka_unit_test(sliding_round_a_body_brakes_as_the_header_says),
        cmocka_unit_test(a_heavy_load_swings_down_as_it_should),
    };
    return cmocka_run_group_tests_name("rope pulleys", tests, NULL, NULL);
}
