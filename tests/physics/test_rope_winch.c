/* Ropes that are reeled in and paid out while they swing: against the equations of a load on a massless rope, and no
 * energy but the work of the winch. */
#include <math.h>

#include "check.h"
#include "reference.h"

enum { SPRINGS = 8, NODES = SPRINGS + 1 };

/* A heavy load at the end of a light rope of fixed length, straight, at an angle to straight down; it swings at the
 * rate `swing`, and the winch already draws the rope in by `reel` a second. */
static cd_chain* load_on_a_winch(double length, double angle, double swing, double reel, double gravity) {
    const double g[2] = {0, -gravity}, way[2] = {sin(angle), -cos(angle)}, across[2] = {cos(angle), sin(angle)};
    double x[NODES][2], v[NODES][2], mass[NODES];
    cd_chain* c = NULL;
    ok(cd_chain_create(1, SPRINGS, 2, CD_FLOAT64, NULL, &c));
    ok(cd_chain_set_rest_length(c, length));
    ok(cd_chain_set_stiffness(c, INFINITY));
    ok(cd_chain_set_gravity(c, g, 2));
    ok(cd_chain_enable_field(c, CD_MASS));
    for (int i = 0; i < NODES; ++i) {
        const double part = (double)i / SPRINGS;
        mass[i] = i < SPRINGS ? 1e-3 : 70;
        for (int k = 0; k < 2; ++k)
            x[i][k] = part * length * way[k], v[i][k] = part * (length * swing * across[k] - reel * way[k]);
    }
    ok(cd_chain_write_f64(c, CD_MASS, 0, 1, 0, NODES, mass, NODES));
    ok(cd_chain_write_f64(c, CD_POSITION, 0, 1, 0, NODES, x[0], 2 * NODES));
    ok(cd_chain_set_end(c, CD_END_FIRST, CD_NODE_PINNED));
    ok(cd_chain_write_f64(c, CD_VELOCITY, 0, 1, 0, NODES, v[0], 2 * NODES));
    return c;
}
/* Where the load is, and how it moves. */
static void where(const cd_chain* c, double* x, double* v) {
    ok(cd_chain_read_f64(c, CD_POSITION, 0, 1, SPRINGS, 1, x, 2));
    ok(cd_chain_read_f64(c, CD_VELOCITY, 0, 1, SPRINGS, 1, v, 2));
}

/* Without gravity a load that spins keeps its angular momentum, whatever the tolerance and the step. */
static void a_load_that_spins_keeps_its_angular_momentum(void** state) {
    (void)state;
    static const double tolerances[] = {1e-5, 1e-6, 1e-7, 1e-8, 1e-9}, rates[] = {8, 15, 60, 240, 2400};
    for (size_t t = 0; t < COUNT(tolerances); ++t)
        for (size_t r = 0; r < COUNT(rates); ++r) {
            cd_chain* c = load_on_a_winch(3, 1, 4, 2, 0);
            double x[2], v[2];
            ok(cd_chain_set_tolerance(c, tolerances[t], 200));
            const int steps = (int)(rates[r] / 2);
            for (int step = 1; step <= steps; ++step) {
                ok(cd_chain_set_rest_length(c, 3 - 2 * step / rates[r]));
                ok(cd_chain_step(c, 1 / rates[r], 1));
            }
            where(c, x, v);
            const double kept = (x[0] * v[1] - x[1] * v[0]) / (3 * 3 * 4.0);
            if (!(fabs(kept - 1) < 1e-4))
                fail_msg("tolerance %g, %g steps a second: %.5f of it", tolerances[t], rates[r], kept);
            cd_chain_destroy(c);
        }
}

/* A load that swings: angle'' = -(2 length' angle' + g sin angle) / length. */
static void a_load_swings_to_second_order(double reel, double most) {
    const double start = 0.8, length = 8, seconds = 2.4, g = 9.81;
    double angle = start, swing = 0, errors[3];
    const int fine = 100000;
    const double h = seconds / fine;
    for (int i = 0; i < fine; ++i) { /* the midpoint rule */
        const double l = length - reel * h * i, middle = l - reel * h / 2;
        const double a = angle + h / 2 * swing, w = swing + h / 2 * (2 * reel * swing - g * sin(angle)) / l;
        angle += h * w, swing += h * (2 * reel * w - g * sin(a)) / middle;
    }
    const double last = length - reel * seconds;
    for (size_t k = 0; k < COUNT(errors); ++k) {
        const double rate = 30 * pow(2, (double)k);
        cd_chain* c = load_on_a_winch(length, start, 0, reel, g);
        double x[2], v[2];
        ok(cd_chain_set_tolerance(c, 1e-9, 200));
        for (int step = 1; step <= (int)(seconds * rate + 0.5); ++step) {
            ok(cd_chain_set_rest_length(c, length - reel * step / rate));
            ok(cd_chain_step(c, 1 / rate, 1));
        }
        where(c, x, v);
        errors[k] = hypot(x[0] - last * sin(angle), x[1] + last * cos(angle));
        cd_chain_destroy(c);
    }
    print_message("errors %.2e, %.2e, %.2e m\n", errors[0], errors[1], errors[2]);
    assert_true(errors[0] < most && errors[1] < 2 * most);
    for (int k = 0; k < 2; ++k) assert_true(errors[k] > 3 * errors[k + 1]);
}
static void a_load_that_swings_is_reeled_in_to_second_order(void** state) {
    (void)state;
    a_load_swings_to_second_order(2, 1e-3);
}
static void a_load_that_swings_is_paid_out_to_second_order(void** state) {
    (void)state;
    a_load_swings_to_second_order(-0.5, 2e-3);
}

/* A load that hangs at rest falls when its rope is paid out at once, is caught, and then goes down at the winch's speed,
 * without a jerk. */
static void a_load_is_let_down_at_an_even_speed(void** state) {
    (void)state;
    static const double rates[] = {30, 60, 240}, speeds[] = {0.1, 0.5, 2};
    for (size_t r = 0; r < COUNT(rates); ++r)
        for (size_t s = 0; s < COUNT(speeds); ++s) {
            cd_chain* c = load_on_a_winch(4, 0, 0, 0, 9.81);
            double x[2], v[2], tension;
            ok(cd_chain_set_tolerance(c, 1e-8, 200));
            ok(cd_chain_step(c, 1 / rates[r], 10));
            for (int step = 1; step <= (int)(2 * rates[r]); ++step) {
                ok(cd_chain_set_rest_length(c, 4 + speeds[s] * step / rates[r]));
                ok(cd_chain_step(c, 1 / rates[r], 1));
                if (step <= (int)rates[r]) continue; /* for 2 m/s it falls 0.2 s, and is caught within as much */
                where(c, x, v);
                ok(cd_chain_read_f64(c, CD_TENSION, 0, 1, SPRINGS - 1, 1, &tension, 1));
                if (!(fabs(v[1] + speeds[s]) < 0.01 * speeds[s] && fabs(tension / (70 * 9.81) - 1) < 0.1))
                    fail_msg("%g steps a second, paid out at %g m/s: %g m/s, tension %g N", rates[r], speeds[s], -v[1],
                             tension);
            }
            cd_chain_destroy(c);
        }
}

/* The rope shows the weight of a load that is reeled in or paid out at an even speed, at any step and tolerance; where a
 * load falls by little more than the tolerance in a step, in the mean. */
static void a_winch_shows_the_weight_in_short_steps(void** state) {
    (void)state;
    static const double rates[] = {60, 240, 960}, tolerances[] = {1e-6, 1e-8}, lambdas[] = {0.5, 0.75};
    for (int way = 0; way < 24; ++way) {
        const double rate = rates[way % 3], tolerance = tolerances[way / 3 % 2], reel = way / 6 % 2 ? 0.5 : -0.5;
        const double falls = 9.81 / rate / rate, weight = 70 * 9.81;
        double sum = 0, worst = 0, tension;
        cd_chain* c = load_on_a_winch(4, 0, 0, reel, 9.81);
        ok(cd_chain_set_lambda(c, lambdas[way / 12]));
        ok(cd_chain_set_tolerance(c, tolerance, 200));
        for (int step = 1; step <= (int)(2 * rate); ++step) {
            ok(cd_chain_set_rest_length(c, 4 - reel * step / rate));
            ok(cd_chain_step(c, 1 / rate, 1));
            if (step <= (int)rate) continue;
            ok(cd_chain_read_f64(c, CD_TENSION, 0, 1, SPRINGS - 1, 1, &tension, 1));
            sum += tension / weight / rate, worst = fmax(worst, fabs(tension / weight - 1));
        }
        print_message("%g steps a second, tolerance %g, reel %g: mean %.5f, off by up to %.1e\n", rate, tolerance, reel,
                      sum, worst);
        assert_near(sum, 1, 3e-3, 0);
        assert_true(worst < 1e-3 || (reel < 0 && falls < 5 * tolerance * 4));
        cd_chain_destroy(c);
    }
}

/* Ropes of constant length that turn far in a step, to loose tolerances: errors of length that the step before left are
 * no winch, and explain no energy but their own. */
static void errors_of_length_are_no_winch(void** state) {
    (void)state;
    enum { MOST = 8 };
    double worst = 0;
    for (int scene = 0; scene < 2000; ++scene) {
        uint64_t seed = 100 + (uint64_t)scene;
        const size_t n = 1 + (size_t)(MOST * fabs(random_number(&seed))) % MOST;
        const double tolerance = pow(10, -2.5 + random_number(&seed)), turns = 10 * pow(10, random_number(&seed));
        double x[MOST + 1][2] = {{0}}, v[MOST + 1][2] = {{0}}, tension[2][MOST] = {{0}}, before, now;
        for (size_t i = 0; i <= n; ++i) {
            const double way = 3.14 * random_number(&seed);
            if (i > 0) x[i][0] = x[i - 1][0] + cos(way), x[i][1] = x[i - 1][1] + sin(way);
            for (int k = 0; k < 2 && (i > 0 || scene % 2); ++k)
                v[i][k] = turns * ((k ? x[i][0] : -x[i][1]) + random_number(&seed));
        }
        cd_chain* c = NULL;
        ok(cd_chain_create(1, n, 2, CD_FLOAT64, NULL, &c));
        ok(cd_chain_set_rest_length(c, (double)n));
        ok(cd_chain_set_stiffness(c, INFINITY));
        ok(cd_chain_set_mass(c, (double)(n + 1)));
        ok(cd_chain_write_f64(c, CD_POSITION, 0, 1, 0, n + 1, x[0], 2 * (n + 1)));
        ok(cd_chain_write_f64(c, CD_VELOCITY, 0, 1, 0, n + 1, v[0], 2 * (n + 1)));
        if (scene % 2 == 0) ok(cd_chain_set_end(c, CD_END_FIRST, CD_NODE_PINNED));
        ok(cd_chain_set_tolerance(c, tolerance, 200));
        ok(cd_chain_get_energy(c, &before, NULL, NULL));
        for (int step = 0; step < 40; ++step) {
            size_t iterations;
            ok(cd_chain_step(c, 1, 1));
            ok(cd_chain_get_convergence(c, &iterations, NULL));
            ok(cd_chain_get_energy(c, &now, NULL, NULL));
            ok(cd_chain_read_f64(c, CD_TENSION, 0, 1, 0, n, tension[step % 2], n));
            const double highest = fmax(before, now);
            double room = iterations > 8 ? 4 * sqrt(2 * (double)(n + 1) * highest) : 0;
            for (size_t i = 0; i < n; ++i) room += 2 * (tension[0][i] + tension[1][i]);
            worst = fmax(worst, (now - before - tolerance * room) / highest);
            before = now;
        }
        cd_chain_destroy(c);
    }
    print_message("energy from nothing: %.2e of what there is\n", worst);
    assert_true(worst < 1e-9);
}

/* Ropes that yield, whose nodes are written where springs are long: none gains energy, but for what errors of length are
 * worth. A state has no tension for what was just written, as for what a winch catches. */
static void what_is_written_long_gains_nothing(void** state) {
    (void)state;
    enum { SCENES = 400, STEPS = 8, MOST = 6 };
    double most = 0;
    for (uint64_t scene = 0; scene < SCENES; ++scene) {
        uint64_t seed = 100 * scene + 3 + other_scenes();
        const size_t springs = 2 + scene % 5, components = 1 + scene / 5 % 3, nodes = springs + 1;
        const double tolerance = 1e-6, length = 1 / (double)springs, dt = pow(10, -2.5 + random_number(&seed));
        double x[(MOST + 1) * 3] = {0}, v[(MOST + 1) * 3], tension[MOST], before = 0, worth_before = 0;
        cd_chain* c = NULL;
        ok(cd_chain_create(1, springs, components, CD_FLOAT64, NULL, &c));
        ok(cd_chain_set_rest_length(c, 1));
        ok(cd_chain_set_stiffness(c, pow(10, 2 + 2 * random_number(&seed))));
        ok(cd_chain_set_lambda(c, 0.5));
        for (size_t i = 0; i < nodes; ++i) {
            double way[3], square = 0;
            for (size_t k = 0; k < components; ++k) way[k] = random_number(&seed), square += way[k] * way[k];
            const double far = length * (1.4 + 0.8 * random_number(&seed)) / sqrt(square);
            for (size_t k = 0; k < components; ++k) {
                const size_t at = i * components + k;
                if (i > 0) x[at] = x[at - components] + far * way[k];
                v[at] = scene % 2 ? 0.3 * random_number(&seed) : 0;
            }
        }
        ok(cd_chain_write_f64(c, CD_POSITION, 0, 1, 0, nodes, x, components * nodes));
        ok(cd_chain_write_f64(c, CD_VELOCITY, 0, 1, 0, nodes, v, components * nodes));
        for (int step = 0; step <= STEPS; ++step) {
            double kinetic, elastic, worth = 0;
            if (step > 0) ok(cd_chain_step(c, dt, 1));
            ok(cd_chain_get_energy(c, &kinetic, &elastic, NULL));
            ok(cd_chain_read_f64(c, CD_TENSION, 0, 1, 0, springs, tension, springs));
            for (size_t i = 0; i < springs; ++i) worth += 2 * fabs(tension[i]) * tolerance * length;
            const double energy = kinetic + elastic;
            if (step > 0) most = fmax(most, (energy - before - worth - worth_before) / energy);
            before = energy, worth_before = worth;
        }
        cd_chain_destroy(c);
    }
    print_message("written long: a step gains at most %.1e of the energy\n", most);
    assert_true(most < 1e-9);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_is_written_long_gains_nothing),
        cmocka_unit_test(a_load_that_spins_keeps_its_angular_momentum),
        cmocka_unit_test(a_load_that_swings_is_reeled_in_to_second_order),
        cmocka_unit_test(a_load_that_swings_is_paid_out_to_second_order),
        cmocka_unit_test(a_load_is_let_down_at_an_even_speed),
        cmocka_unit_test(a_winch_shows_the_weight_in_short_steps),
        cmocka_unit_test(errors_of_length_are_no_winch),
    };
    return cmocka_run_group_tests_name("rope winches", tests, NULL, NULL);
}
