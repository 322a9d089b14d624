/* Ropes in air: exact answers for straight ones, second order for one that swings, and no energy from nothing. */
#include <math.h>
#include <string.h>

#include "check.h"
#include "reference.h"

enum { NODES = 9, SPRINGS = NODES - 1 };
static const double length = 2, mass = 0.3;

/* A straight rope of fixed length along `way`, whose nodes have the masses of their shares of it, with velocity v. */
static cd_chain* rope(const double* way, const double* v, double lambda) {
    cd_chain* chain = NULL;
    double x[NODES][3], velocity[NODES][3];
    ok(cd_chain_create(1, SPRINGS, 3, CD_FLOAT64, NULL, &chain));
    ok(cd_chain_set_rest_length(chain, length));
    ok(cd_chain_set_stiffness(chain, INFINITY));
    ok(cd_chain_set_mass(chain, mass));
    ok(cd_chain_set_mass_rule(chain, CD_MASS_HALF_ENDS));
    ok(cd_chain_set_lambda(chain, lambda));
    for (int i = 0; i < NODES; ++i)
        for (int k = 0; k < 3; ++k) x[i][k] = length / SPRINGS * i * way[k], velocity[i][k] = v[k];
    ok(cd_chain_write_f64(chain, CD_POSITION, 0, 1, 0, NODES, x[0], 3 * NODES));
    ok(cd_chain_write_f64(chain, CD_VELOCITY, 0, 1, 0, NODES, velocity[0], 3 * NODES));
    return chain;
}
static double dot(const double* a, const double* b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
static void random_vector(double* v, double size, uint64_t* seed) {
    for (int k = 0; k < 3; ++k) v[k] = size * random_number(seed);
}
static void random_way(double* way, uint64_t* seed) {
    double size = 0;
    while (!(size > 0.1)) random_vector(way, 1, seed), size = sqrt(dot(way, way));
    for (int k = 0; k < 3; ++k) way[k] /= size;
}

/* It moves as one, along itself and across as a point does: w = (v + lambda dt (g + r u)) / (1 + lambda dt r), where r is
 * the resistance of all of it over its mass. */
static void a_straight_rope_falls_as_air_lets_it(void** state) {
    (void)state;
    double worst = 0;
    for (int number = 0; number < 200; ++number) {
        uint64_t seed = 1 + (uint64_t)number;
        double way[3], v[3], wind[3], gravity[3], now[NODES][3];
        random_way(way, &seed);
        if (number < 3) way[0] = number == 0, way[1] = number == 1, way[2] = number == 2;
        random_vector(v, 3, &seed), random_vector(wind, 5, &seed), random_vector(gravity, 9.81, &seed);
        const double lambda = number % 3 == 0 ? 1 : 0.75 + 0.25 * random_number(&seed);
        const double resistance[2] = {pow(10, 3 * random_number(&seed)), pow(10, 3 * random_number(&seed))};
        const double dt = pow(10, 1.5 * random_number(&seed) - 1.5);
        cd_chain* chain = rope(way, v, lambda);
        ok(cd_chain_set_gravity(chain, gravity, 3));
        ok(cd_chain_set_air(chain, resistance[0], resistance[1]));
        ok(cd_chain_set_wind(chain, wind, 3));
        for (int step = 0; step < 2; ++step) {
            double parts[2][3], w[3];
            ok(cd_chain_step(chain, dt, 1));
            ok(cd_chain_read_f64(chain, CD_VELOCITY, 0, 1, 0, NODES, now[0], 3 * NODES));
            for (int k = 0; k < 3; ++k) w[k] = 0;
            for (int across = 0; across < 2; ++across) {
                const double h = lambda * dt, r = resistance[across] * length / mass;
                for (int k = 0; k < 3; ++k) parts[across][k] = (v[k] + h * (gravity[k] + r * wind[k])) / (1 + h * r);
                const double along = dot(parts[across], way);
                for (int k = 0; k < 3; ++k) w[k] += across ? parts[across][k] - along * way[k] : along * way[k];
            }
            double size = 1;
            for (int k = 0; k < 3; ++k) v[k] += (w[k] - v[k]) / lambda, size = fmax(size, fabs(v[k]));
            for (int i = 0; i < NODES; ++i)
                for (int k = 0; k < 3; ++k) worst = fmax(worst, fabs(now[i][k] - v[k]) / size);
        }
        cd_chain_destroy(chain);
    }
    print_message("velocities to %.1e\n", worst);
    assert_true(worst < 1e-11);
}

/* Hung up in a wind it comes to rest straight, where what blows across it holds its weight. */
static void a_rope_hangs_straight_in_a_steady_wind(void** state) {
    (void)state;
    static const double cases[][3] = {{0, 0.3, 2}, {0.05, 0.3, 8}, {0.3, 0.3, 3}, {0.5, 1, 8}, {0.4, 0.1, 1}};
    for (size_t i = 0; i < COUNT(cases); ++i) {
        const double along = cases[i][0], across = cases[i][1], blows = cases[i][2], g = 9.81, rest[3] = {0, 0, 0};
        const double down[3] = {0, 0, -1}, gravity[3] = {0, 0, -g}, wind[3] = {0.6 * blows, -0.8 * blows, 0};
        cd_chain* chain = rope(down, rest, 1);
        ok(cd_chain_set_end(chain, CD_END_FIRST, CD_NODE_PINNED));
        ok(cd_chain_set_gravity(chain, gravity, 3));
        ok(cd_chain_set_air(chain, along, across));
        ok(cd_chain_set_wind(chain, wind, 3));
        ok(cd_chain_set_tolerance(chain, 1e-12, 200));
        for (int step = 0; step < 4000; ++step) ok(cd_chain_step(chain, 0.1, 1));
        const double angle = atan(across * blows * length / (mass * g));
        double x[NODES][3], tension[SPRINGS];
        ok(cd_chain_read_f64(chain, CD_POSITION, 0, 1, 0, NODES, x[0], 3 * NODES));
        ok(cd_chain_read_f64(chain, CD_TENSION, 0, 1, 0, SPRINGS, tension, SPRINGS));
        for (int k = 0; k < NODES; ++k) {
            const double at = length / SPRINGS * k;
            assert_near(x[k][0], 0.6 * at * sin(angle), 1e-9, 0);
            assert_near(x[k][1], -0.8 * at * sin(angle), 1e-9, 0);
            assert_near(x[k][2], -at * cos(angle), 1e-9, 0);
        }
        for (int k = 0; k < SPRINGS; ++k) { /* all below, with half of the node's own share */
            const double below = (SPRINGS - k - 0.5) / SPRINGS;
            const double pull = below * (mass * g * cos(angle) + along * blows * sin(angle) * length);
            assert_near(tension[k], pull, 1e-8, 0);
        }
        cd_chain_destroy(chain);
    }
}

static void swing(double dt, double* tip) {
    const double way[3] = {0.8, 0, 0.6}, rest[3] = {0, 0, 0}, gravity[3] = {0, 0, -9.81}, wind[3] = {1, 2, 0};
    cd_chain* chain = rope(way, rest, 0.5);
    ok(cd_chain_set_end(chain, CD_END_FIRST, CD_NODE_PINNED));
    ok(cd_chain_set_push(chain, 1)); /* no jerk as slack ends */
    ok(cd_chain_set_gravity(chain, gravity, 3));
    ok(cd_chain_set_air(chain, 0.05, 0.4));
    ok(cd_chain_set_wind(chain, wind, 3));
    ok(cd_chain_set_tolerance(chain, 1e-11, 200));
    ok(cd_chain_step(chain, dt, (size_t)(0.5 / dt + 0.5)));
    ok(cd_chain_read_f64(chain, CD_POSITION, 0, 1, NODES - 1, 1, tip, 3));
    cd_chain_destroy(chain);
}
static void a_swing_in_air_is_of_second_order(void** state) {
    (void)state;
    double exact[3], tip[3], error[3];
    swing(1.0 / 15360, exact);
    for (int i = 0; i < 3; ++i) {
        swing(1.0 / (120 << i), tip);
        for (int k = 0; k < 3; ++k) tip[k] -= exact[k];
        error[i] = sqrt(dot(tip, tip));
    }
    print_message("tip wrong by %.2e, %.2e, %.2e m at 120, 240, 480 Hz\n", error[0], error[1], error[2]);
    assert_true(error[0] < 2e-3);
    for (int i = 1; i < 3; ++i) assert_true(error[i - 1] > 3.5 * error[i]);
}

/* A crumpled rope in any air, by any steps: its energy, as seen from the air, never rises. And five in which iterations
 * of the interior point would go round in a circle, and four in the thickest air, in which rounding made energy, or let
 * no step come to an end. */
static void air_takes_energy_at_any_dt(void** state) {
    (void)state;
    enum { RANDOM = 500 };
    static const int others[] = {1817, 5931, 10351, 11389, 11773, 2085, 2810, 3935, 6475};
    for (int scene = 0; scene < RANDOM + (int)COUNT(others); ++scene) {
        const int number = scene < RANDOM ? scene : others[scene - RANDOM];
        uint64_t seed = 5000 + (uint64_t)number;
        double x[NODES][3], v[NODES][3], wind[3], way[3] = {1, 0, 0}, none[3] = {0, 0, 0};
        const double lambda = number % 3 == 0 ? 1 : 0.75 + 0.25 * random_number(&seed);
        const double dt = pow(10, 5 * random_number(&seed));
        const double size = pow(10, (number % 5 == 0 ? 58 : 6) * random_number(&seed));
        cd_chain* chain = rope(way, none, lambda);
        x[0][0] = x[0][1] = x[0][2] = 0;
        for (int i = 0; i < NODES; ++i) {
            random_way(way, &seed);
            for (int k = 0; k < 3 && i > 0; ++k)
                x[i][k] = x[i - 1][k] + length / SPRINGS * fabs(random_number(&seed)) * way[k] / 2;
            random_vector(v[i], 10, &seed);
        }
        random_vector(wind, number % 2 ? 10 : 0, &seed);
        ok(cd_chain_write_f64(chain, CD_POSITION, 0, 1, 0, NODES, x[0], 3 * NODES));
        ok(cd_chain_write_f64(chain, CD_VELOCITY, 0, 1, 0, NODES, v[0], 3 * NODES));
        if (number % 2 == 0) ok(cd_chain_set_end(chain, CD_END_FIRST, CD_NODE_PINNED));
        ok(cd_chain_read_f64(chain, CD_VELOCITY, 0, 1, 0, NODES, v[0], 3 * NODES));
        ok(cd_chain_set_air(chain, size * fabs(random_number(&seed)), size));
        ok(cd_chain_set_wind(chain, wind, 3));
        double before = HUGE_VAL;
        for (int step = 0; step < 30; ++step) {
            double energy = 0, worth = 0, tension[SPRINGS];
            for (int i = 0; i < NODES; ++i)
                for (int k = 0; k < 3; ++k)
                    energy += 0.5 * mass / SPRINGS * (i % SPRINGS ? 1 : 0.5) * pow(v[i][k] - wind[k], 2);
            assert_true(energy <= before);
            ok(cd_chain_step(chain, dt, 1));
            ok(cd_chain_read_f64(chain, CD_VELOCITY, 0, 1, 0, NODES, v[0], 3 * NODES));
            ok(cd_chain_read_f64(chain, CD_TENSION, 0, 1, 0, SPRINGS, tension, SPRINGS));
            for (int i = 0; i < SPRINGS; ++i) worth += 4 * (tension[i] + mass * 20 / dt) * 1e-6 * length / SPRINGS;
            before = energy * (1 + 1e-12) + worth;
        }
        cd_chain_destroy(chain);
    }
}

/* What no number of it can: a rope that can't move across itself slides along itself. */
static void the_thickest_air_stops_what_moves_across(void** state) {
    (void)state;
    static const double sizes[] = {1e6, 1e12, 1e30, 1e60};
    for (size_t i = 0; i < COUNT(sizes); ++i)
        for (int number = 0; number < 20; ++number) {
            uint64_t seed = 7 + (uint64_t)number;
            double way[3], v[3], now[NODES][3];
            random_way(way, &seed), random_vector(v, 3, &seed);
            cd_chain* chain = rope(way, v, 1);
            ok(cd_chain_set_air(chain, 0, sizes[i]));
            ok(cd_chain_step(chain, 0.01, 1));
            ok(cd_chain_read_f64(chain, CD_VELOCITY, 0, 1, 0, NODES, now[0], 3 * NODES));
            const double along = dot(v, way);
            for (int k = 0; k < NODES; ++k)
                for (int c = 0; c < 3; ++c) assert_true(fabs(now[k][c] - along * way[c]) < 200 / sizes[i] + 1e-7);
            cd_chain_destroy(chain);
        }
}

/* Hung up, straight or bent, by its first node, its last one or both: links of fixed length and some that yield hold in
 * winds of all strengths, and nothing is much faster than the wind. */
static void ropes_hold_in_the_strongest_winds(void** state) {
    (void)state;
    double fastest = 0;
    for (int number = 0; number < 600; ++number) {
        uint64_t seed = 11 + (uint64_t)number;
        const double air = pow(10, number % 60 + 1), down[3] = {0, 0, -1}, rest[3] = {0, 0, 0};
        const double bent = 0.5 * (number % 4), gusts = number % 7 ? 0.5 : 0;
        const double wind[3] = {gusts * random_number(&seed), gusts * random_number(&seed), -5};
        double x[NODES][3] = {{0}}, v[NODES][3];
        cd_chain* chain = rope(down, rest, number % 2 ? 1 : 0.5);
        for (int i = 1; i < NODES; ++i) {
            const double way[3] = {bent * random_number(&seed), bent * random_number(&seed), -1};
            for (int k = 0; k < 3; ++k) x[i][k] = x[i - 1][k] + length / SPRINGS * way[k] / sqrt(dot(way, way));
        }
        const int by_last = number / 60 % 2;
        for (int i = 0; i < NODES; ++i)
            ok(cd_chain_write_f64(chain, CD_POSITION, 0, 1, (size_t)(by_last ? SPRINGS - i : i), 1, x[i], 3));
        ok(cd_chain_set_stiffness(chain, number % 3 ? INFINITY : 1e4));
        ok(cd_chain_set_end(chain, by_last ? CD_END_LAST : CD_END_FIRST, CD_NODE_PINNED));
        if (number % 5 == 0) ok(cd_chain_set_end(chain, by_last ? CD_END_FIRST : CD_END_LAST, CD_NODE_PINNED));
        ok(cd_chain_set_air(chain, number % 3 == 1 ? 0 : air, air));
        ok(cd_chain_set_wind(chain, wind, 3));
        for (int step = 0; step < 20; ++step) {
            ok(cd_chain_step(chain, 0.01, 1));
            ok(cd_chain_read_f64(chain, CD_VELOCITY, 0, 1, 0, NODES, v[0], 3 * NODES));
            for (int i = 0; i < NODES && number % 3 != 1; ++i) /* else it slides along itself as wedges do */
                fastest = fmax(fastest, sqrt(dot(v[i], v[i])));
        }
        cd_chain_destroy(chain);
    }
    print_message("the fastest node moves at %.2f m/s in a wind of 5 m/s\n", fastest);
    assert_true(fastest < 30);
}

static void nodes_between_cut_springs_feel_no_air(void** state) {
    (void)state;
    const double way[3] = {0, 1, 0}, v[3] = {1, 2, 3}, wind[3] = {9, 9, 9};
    double now[NODES][3];
    cd_chain* chain = rope(way, v, 0.5);
    ok(cd_chain_set_air(chain, 5, 7));
    ok(cd_chain_set_wind(chain, wind, 3));
    for (size_t i = 0; i < SPRINGS; ++i)
        if (i != 3) ok(cd_chain_cut(chain, 0, i));
    ok(cd_chain_step(chain, 0.01, 1));
    ok(cd_chain_read_f64(chain, CD_VELOCITY, 0, 1, 0, NODES, now[0], 3 * NODES));
    for (int i = 0; i < NODES; ++i)
        for (int k = 0; k < 3; ++k) assert_true((fabs(now[i][k] - v[k]) > 1e-12) == (i == 3 || i == 4));
    cd_chain_destroy(chain);
}

/* Nodes of some strands in winds of their own move as in ropes by themselves, to the bit. */
static void each_node_has_its_wind(void** state) {
    (void)state;
    enum { STRANDS = 11 };
    uint64_t seed = 3;
    static double x[STRANDS][NODES][3], wind[STRANDS][NODES][3], now[STRANDS][NODES][3], alone[NODES][3];
    const double way[3] = {1, 0, 0}, none[3] = {0, 0, 0}, gravity[3] = {0, -9.81, 0};
    cd_chain* all = NULL;
    ok(cd_chain_create(STRANDS, SPRINGS, 3, CD_FLOAT64, NULL, &all));
    ok(cd_chain_set_rest_length(all, length));
    ok(cd_chain_set_stiffness(all, INFINITY));
    ok(cd_chain_set_mass(all, mass));
    ok(cd_chain_set_mass_rule(all, CD_MASS_HALF_ENDS));
    for (int s = 0; s < STRANDS; ++s)
        for (int i = 0; i < NODES; ++i) {
            random_vector(wind[s][i], 5, &seed);
            for (int k = 0; k < 3; ++k) x[s][i][k] = length / SPRINGS * i * (k == 0) + 0.01 * random_number(&seed);
        }
    ok(cd_chain_write_f64(all, CD_POSITION, 0, STRANDS, 0, NODES, x[0][0], 3 * NODES * STRANDS));
    ok(cd_chain_set_gravity(all, gravity, 3));
    ok(cd_chain_set_air(all, 0.1, 0.6));
    ok(cd_chain_enable_field(all, CD_WIND));
    ok(cd_chain_write_f64(all, CD_WIND, 0, STRANDS, 0, NODES, wind[0][0], 3 * NODES * STRANDS));
    ok(cd_chain_step(all, 0.02, 20));
    ok(cd_chain_read_f64(all, CD_POSITION, 0, STRANDS, 0, NODES, now[0][0], 3 * NODES * STRANDS));
    for (int s = 0; s < STRANDS; ++s) {
        cd_chain* one = rope(way, none, 0.5);
        ok(cd_chain_write_f64(one, CD_POSITION, 0, 1, 0, NODES, x[s][0], 3 * NODES));
        ok(cd_chain_set_gravity(one, gravity, 3));
        ok(cd_chain_set_air(one, 0.1, 0.6));
        ok(cd_chain_enable_field(one, CD_WIND));
        ok(cd_chain_write_f64(one, CD_WIND, 0, 1, 0, NODES, wind[s][0], 3 * NODES));
        ok(cd_chain_step(one, 0.02, 20));
        ok(cd_chain_read_f64(one, CD_POSITION, 0, 1, 0, NODES, alone[0], 3 * NODES));
        assert_same_bits(alone[0], now[s][0], 3 * NODES);
        cd_chain_destroy(one);
    }
    cd_chain_destroy(all);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_straight_rope_falls_as_air_lets_it),
        cmocka_unit_test(a_rope_hangs_straight_in_a_steady_wind),
        cmocka_unit_test(a_swing_in_air_is_of_second_order),
        cmocka_unit_test(air_takes_energy_at_any_dt),
        cmocka_unit_test(the_thickest_air_stops_what_moves_across),
        cmocka_unit_test(ropes_hold_in_the_strongest_winds),
        cmocka_unit_test(nodes_between_cut_springs_feel_no_air),
        cmocka_unit_test(each_node_has_its_wind),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
