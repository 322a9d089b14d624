/* Ropes that break, and what they pull with: against the weights that hang from them. */
#include <math.h>

#include "check.h"
#include "reference.h"

enum { NODES = 11, SPRINGS = NODES - 1, STRANDS = 5 };
static const double length = 2, mass = 0.4, weight = 9.81;

/* Strands that hang straight down from a pinned node, at rest, with CD_MASS_HALF_ENDS. */
static cd_chain* hanging(double stiffness) {
    const double gravity[3] = {0, -9.81, 0};
    double x[STRANDS][NODES][3];
    cd_chain* c = NULL;
    ok(cd_chain_create(STRANDS, SPRINGS, 3, CD_FLOAT64, NULL, &c));
    ok(cd_chain_set_rest_length(c, length));
    ok(cd_chain_set_stiffness(c, stiffness));
    ok(cd_chain_set_mass(c, mass));
    ok(cd_chain_set_mass_rule(c, CD_MASS_HALF_ENDS));
    ok(cd_chain_set_gravity(c, gravity, 3));
    ok(cd_chain_set_end(c, CD_END_FIRST, CD_NODE_PINNED));
    for (int s = 0; s < STRANDS; ++s)
        for (int i = 0; i < NODES; ++i) x[s][i][0] = s, x[s][i][1] = -length / SPRINGS * i, x[s][i][2] = 0;
    ok(cd_chain_write_f64(c, CD_POSITION, 0, STRANDS, 0, NODES, x[0][0], STRANDS * NODES * 3));
    return c;
}
/* The weight below spring i. */
static double below(int i) { return weight * mass / SPRINGS * (SPRINGS - i - 0.5); }

static size_t broken_in(cd_chain* c, double dt, size_t steps) {
    size_t broken = 99;
    ok(cd_chain_step(c, dt, steps));
    ok(cd_chain_get_broken(c, &broken));
    return broken;
}

static void a_rope_bears_its_strength_and_no_more(void** state) {
    (void)state;
    cd_chain *holds = hanging(INFINITY), *breaks = hanging(INFINITY);
    double k[SPRINGS], tension[SPRINGS], x;
    ok(cd_chain_set_strength(holds, below(0) * (1 + 1e-6)));
    ok(cd_chain_set_strength(breaks, below(0) * (1 - 1e-6)));
    assert_int_equal(broken_in(holds, 1 / 60.0, 600), 0);
    assert_int_equal(broken_in(breaks, 0.01, 1), STRANDS); /* the first spring of each */
    for (int s = 0; s < STRANDS; ++s) {
        ok(cd_chain_read_f64(breaks, CD_STIFFNESS, (size_t)s, 1, 0, SPRINGS, k, SPRINGS));
        ok(cd_chain_read_f64(breaks, CD_TENSION, (size_t)s, 1, 0, SPRINGS, tension, SPRINGS));
        for (int i = 0; i < SPRINGS; ++i) assert_true(i == 0 ? k[i] == 0 && tension[i] == 0 : isinf(k[i]));
    }
    assert_int_equal(broken_in(breaks, 0.01, 100), 0); /* what fell is free: x = -g t^2 / 2 */
    ok(cd_chain_read_f64(breaks, CD_POSITION, 2, 1, SPRINGS, 1, tension, 3));
    x = tension[1];
    assert_near(x, -length - 0.5 * weight * 1.0 * 1.0, 1e-9, 0);
    const double mended = INFINITY;
    ok(cd_chain_write_f64(breaks, CD_STIFFNESS, 3, 1, 0, 1, &mended, 1)); /* too long by now, and pulled back at once */
    assert_int_equal(broken_in(breaks, 0.01, 1), 1);
    cd_chain_destroy(holds);
    cd_chain_destroy(breaks);
}

/* Each spring and strand has a strength of its own; one spring of a strand breaks at a time. */
static void the_spring_most_beyond_its_strength_breaks_first(void** state) {
    (void)state;
    for (int elastic = 0; elastic <= 1; ++elastic) {
        cd_chain* c = hanging(elastic ? 1e7 : INFINITY);
        double strength[STRANDS][SPRINGS], k[SPRINGS];
        ok(cd_chain_enable_field(c, CD_STRENGTH));
        ok(cd_chain_read_f64(c, CD_STRENGTH, 0, STRANDS, 0, SPRINGS, strength[0], STRANDS * SPRINGS));
        for (int s = 0; s < STRANDS; ++s)
            for (int i = 0; i < SPRINGS; ++i) {
                assert_true(isinf(strength[s][i]));
                strength[s][i] = 2 * below(i);
            }
        strength[1][4] = 0.8 * below(4), strength[1][7] = 0.7 * below(7); /* 7, and then 4 bears */
        strength[2][2] = 0.9 * below(2), strength[2][8] = 0.2 * below(8); /* 8, and then 2 bears a fifth less, but .. */
        strength[4][5] = 0.5 * below(5);
        ok(cd_chain_write_f64(c, CD_STRENGTH, 0, STRANDS, 0, SPRINGS, strength[0], STRANDS * SPRINGS));
        const size_t first = broken_in(c, 0.01, 1);
        assert_int_equal(first, 3);
        static const int cut[STRANDS] = {-1, 7, 8, -1, 5};
        for (int s = 0; s < STRANDS; ++s) {
            ok(cd_chain_read_f64(c, CD_STIFFNESS, (size_t)s, 1, 0, SPRINGS, k, SPRINGS));
            for (int i = 0; i < SPRINGS; ++i) assert_true((k[i] == 0) == (i == cut[s]));
        }
        /* Spring 4 of strand 1 now bears what lies between 4 and 7: less than its strength. */
        assert_true(below(4) - below(7) < strength[1][4] && below(2) - below(8) < strength[2][2]);
        assert_int_equal(broken_in(c, 0.01, 50), 0);
        cd_chain_destroy(c);
    }
}

/* A rope that is jerked taut bears the same all along: it snaps in one place. */
static void a_jerked_rope_snaps_in_one_place(void** state) {
    (void)state;
    cd_chain* c = NULL;
    double x[NODES][2], v[NODES][2];
    ok(cd_chain_create(1, SPRINGS, 2, CD_FLOAT64, NULL, &c));
    ok(cd_chain_set_rest_length(c, 1));
    ok(cd_chain_set_stiffness(c, 1000));
    ok(cd_chain_set_lambda(c, 1));
    ok(cd_chain_set_end(c, CD_END_FIRST, CD_NODE_PINNED));
    ok(cd_chain_set_end(c, CD_END_LAST, CD_NODE_DRIVEN));
    for (int i = 0; i < NODES; ++i) x[i][0] = 0.1 * i, x[i][1] = v[i][0] = v[i][1] = 0;
    v[SPRINGS][0] = 0.05;
    ok(cd_chain_write_f64(c, CD_POSITION, 0, 1, 0, NODES, x[0], 2 * NODES));
    ok(cd_chain_write_f64(c, CD_VELOCITY, 0, 1, 0, NODES, v[0], 2 * NODES));
    ok(cd_chain_set_strength(c, 50));
    size_t broken = 0;
    for (int step = 0; step < 200; ++step) broken += broken_in(c, 0.02, 1); /* a wave crosses it in two steps */
    assert_int_equal(broken, 1);
    cd_chain_destroy(c);
}

/* What no tension holds breaks: a rope of fixed length between ends that are driven apart, at its weakest spring, in each
 * strand by itself. One of infinite strength holds, and one that is let go. */
static void what_no_tension_holds_breaks_at_its_weakest(void** state) {
    (void)state;
    static const double speeds[] = {1e-3, 0.1, 1, 10, 100};
    for (int way = 0; way < 8 * (int)COUNT(speeds); ++way) {
        const double speed = speeds[way / 8];
        cd_chain* c = NULL;
        double x[STRANDS][NODES][2], v[2] = {speed, 0}, strength[STRANDS][SPRINGS], k[SPRINGS];
        const double gravity[2] = {0, way % 2 ? -9.81 : 0};
        ok(cd_chain_create(STRANDS, SPRINGS, 2, way / 4 % 2 ? CD_FLOAT32 : CD_FLOAT64, NULL, &c));
        ok(cd_chain_set_rest_length(c, length));
        ok(cd_chain_set_stiffness(c, INFINITY));
        ok(cd_chain_set_tolerance(c, 1e-5, 200));
        ok(cd_chain_set_lambda(c, way / 2 % 2 ? 1 : 0.5));
        ok(cd_chain_set_gravity(c, gravity, 2));
        ok(cd_chain_set_strength(c, 1e9));
        ok(cd_chain_enable_field(c, CD_STRENGTH));
        ok(cd_chain_read_f64(c, CD_STRENGTH, 0, STRANDS, 0, SPRINGS, strength[0], STRANDS * SPRINGS));
        for (int s = 0; s < STRANDS; ++s)
            for (int i = 0; i < NODES; ++i) x[s][i][0] = length / SPRINGS * i, x[s][i][1] = s;
        strength[1][4] = 1e8, strength[2][0] = 1e8;
        for (int i = 0; i < SPRINGS; ++i) strength[3][i] = INFINITY;
        ok(cd_chain_write_f64(c, CD_POSITION, 0, STRANDS, 0, NODES, x[0][0], STRANDS * NODES * 2));
        ok(cd_chain_write_f64(c, CD_STRENGTH, 0, STRANDS, 0, SPRINGS, strength[0], STRANDS * SPRINGS));
        ok(cd_chain_set_end(c, CD_END_FIRST, CD_NODE_PINNED));
        ok(cd_chain_set_end(c, CD_END_LAST, CD_NODE_DRIVEN));
        for (size_t s = 0; s < STRANDS - 1; ++s) ok(cd_chain_write_f64(c, CD_VELOCITY, s, 1, SPRINGS, 1, v, 2));
        v[0] = -0.1; /* the last one is let go */
        ok(cd_chain_write_f64(c, CD_VELOCITY, STRANDS - 1, 1, SPRINGS, 1, v, 2));
        size_t broken = 0, all = 0;
        for (int step = 0; step < 10; ++step) {
            const cd_status status = cd_chain_step(c, 0.1, 1); /* strand 3 can't be solved */
            assert_true(status == CD_OK || status == CD_ERROR_TOLERANCE);
            ok(cd_chain_get_broken(c, &broken));
            all += broken;
        }
        assert_int_equal(all, 3);
        static const int cut[STRANDS] = {-2, 4, 0, -1, -1}; /* -2: any one */
        for (int s = 0; s < STRANDS; ++s) {
            int gone = 0;
            ok(cd_chain_read_f64(c, CD_STIFFNESS, (size_t)s, 1, 0, SPRINGS, k, SPRINGS));
            for (int i = 0; i < SPRINGS; ++i) gone += k[i] == 0;
            assert_int_equal(gone, cut[s] != -1);
            if (cut[s] >= 0) assert_true(k[cut[s]] == 0);
        }
        cd_chain_destroy(c);
    }
}

/* Broken springs take what energy they held with them: none comes from nothing. */
static void no_energy_comes_of_breaking(void** state) {
    (void)state;
    size_t all_broken = 0;
    for (uint64_t number = 0; number < 100; ++number) {
        uint64_t seed = 1000 + number;
        cd_chain* c = hanging(number % 2 ? INFINITY : 1e4);
        double v[STRANDS * NODES * 3] = {0}, energy[3], before = INFINITY;
        for (int i = 0; i < STRANDS * NODES * 3; ++i) v[i] = i / 3 % NODES > 0 ? 3 * random_number(&seed) : 0;
        ok(cd_chain_write_f64(c, CD_VELOCITY, 0, STRANDS, 0, NODES, v, STRANDS * NODES * 3));
        ok(cd_chain_set_lambda(c, number % 3 ? 0.5 : 1));
        ok(cd_chain_set_tolerance(c, 1e-9, 300));
        ok(cd_chain_set_strength(c, below(0) * pow(10, random_number(&seed))));
        for (int step = 0; step < 100; ++step) {
            all_broken += broken_in(c, 1 / 60.0, 1);
            ok(cd_chain_get_energy(c, &energy[0], &energy[1], &energy[2]));
            const double now = energy[0] + energy[1] + energy[2];
            if (!(now <= before + 1e-6 * mass * weight * length))
                fail_msg("rope %d: energy from %.12g to %.12g in step %d", (int)number, before, now, step);
            before = now;
        }
        cd_chain_destroy(c);
    }
    assert_true(all_broken > 500);
}

/* ---- what ropes pull with ---------------------------------------------------------------------------------------- */

static void a_held_node_feels_the_weight_that_hangs_from_it(void** state) {
    (void)state;
    for (int elastic = 0; elastic <= 1; ++elastic) {
        cd_chain* c = hanging(elastic ? 1e7 : INFINITY);
        double f[3], strain[SPRINGS];
        ok(cd_chain_set_drag(c, 5));
        ok(cd_chain_step(c, 0.01, 2000));
        for (size_t s = 0; s < STRANDS; ++s) {
            ok(cd_chain_get_reaction(c, s, 0, f, 3));
            assert_near(f[1], -below(0), 1e-6, 0);
            assert_near(f[0], 0, 1e-9, 1), assert_near(f[2], 0, 1e-9, 1);
            for (size_t i = 1; i < NODES; ++i) { /* inside, and at the free end, they bear the node's own weight */
                ok(cd_chain_get_reaction(c, s, i, f, 3));
                assert_near(f[1], weight * mass / SPRINGS * (i < SPRINGS ? 1 : 0.5), 1e-6, 0);
            }
            ok(cd_chain_read_f64(c, CD_STRAIN, s, 1, 0, SPRINGS, strain, SPRINGS));
            for (int i = 0; i < SPRINGS; ++i) /* k_i = k SPRINGS, length_i = length / SPRINGS */
                assert_near(strain[i], elastic ? below(i) / (1e7 * length) : 0, 2e-14, 1);
        }
        cd_chain_destroy(c);
    }
}

/* A straight rope that a driven end would stretch: no step is solved, and tensions are no larger than what the springs
 * did to the nodes, which is what holds them against gravity and what little they move. */
static void tensions_of_unsolved_steps_are_of_the_size_of_the_forces(void** state) {
    (void)state;
    for (int way = 0; way < 4; ++way) {
        const double dt = 1 / 600.0, v[3] = {0, -0.02, 0};
        cd_chain* c = hanging(INFINITY);
        double most = 0, tension[STRANDS * SPRINGS];
        int told = 0;
        ok(cd_chain_set_lambda(c, way % 2 ? 1 : 0.5));
        ok(cd_chain_set_end(c, CD_END_LAST, CD_NODE_DRIVEN));
        for (size_t s = 0; s < STRANDS; ++s) ok(cd_chain_write_f64(c, CD_VELOCITY, s, 1, SPRINGS, 1, v, 3));
        for (int step = 0; step < 60; ++step) {
            told += cd_chain_step(c, way / 2 ? dt : 10 * dt, 1) == CD_ERROR_TOLERANCE;
            ok(cd_chain_read_f64(c, CD_TENSION, 0, STRANDS, 0, SPRINGS, tension, STRANDS * SPRINGS));
            for (int i = 0; i < STRANDS * SPRINGS; ++i) most = fmax(most, tension[i]);
        }
        print_message("%d of 60 steps ended short; tensions up to %.3g weights\n", told, most / (mass * weight));
        assert_true(told == 60);
        assert_true(most < 100 * mass * weight);
        cd_chain_destroy(c);
    }
}

/* Between two pins: the reactions bear the weight, and pull at each other. */
static void a_hung_rope_pulls_its_pins_together_and_down(void** state) {
    (void)state;
    cd_chain* c = hanging(INFINITY);
    double x[NODES][3], first[3], last[3];
    for (int i = 0; i < NODES; ++i) x[i][0] = 0.7 * length / SPRINGS * i, x[i][1] = x[i][2] = 0;
    for (size_t s = 0; s < STRANDS; ++s) ok(cd_chain_write_f64(c, CD_POSITION, s, 1, 0, NODES, x[0], 3 * NODES));
    ok(cd_chain_set_end(c, CD_END_LAST, CD_NODE_PINNED));
    ok(cd_chain_set_lambda(c, 1));
    ok(cd_chain_set_drag(c, 2));
    ok(cd_chain_step(c, 0.1, 500));
    ok(cd_chain_get_reaction(c, 3, 0, first, 3));
    ok(cd_chain_get_reaction(c, 3, SPRINGS, last, 3));
    const double free_mass = mass / SPRINGS * (SPRINGS - 1);
    assert_near(first[1] + last[1], -weight * free_mass, 1e-6, 0);
    assert_near(first[1], last[1], 1e-6, 0);
    assert_near(first[0], -last[0], 1e-6, 0);
    assert_true(first[0] > 0.1);
    cd_chain_destroy(c);
}

/* A spring without length has no direction, and overlong ones no overflow. */
static void reactions_and_strains_of_odd_springs(void** state) {
    (void)state;
    cd_chain* c = NULL;
    const double x[3][2] = {{0, 0}, {0, 0}, {3e200, 4e200}}, tension[2] = {5, 7};
    double f[2], strain[2];
    ok(cd_chain_create(1, 2, 2, CD_FLOAT64, NULL, &c));
    ok(cd_chain_set_rest_length(c, 2));
    ok(cd_chain_write_f64(c, CD_POSITION, 0, 1, 0, 3, x[0], 6));
    ok(cd_chain_write_f64(c, CD_TENSION, 0, 1, 0, 2, tension, 2));
    ok(cd_chain_get_reaction(c, 0, 0, f, 2));
    assert_true(f[0] == 0 && f[1] == 0);
    ok(cd_chain_get_reaction(c, 0, 1, f, 2));
    assert_near(f[0], 4.2, 1e-15, 0), assert_near(f[1], 5.6, 1e-15, 0);
    ok(cd_chain_read_f64(c, CD_STRAIN, 0, 1, 0, 2, strain, 2));
    assert_true(strain[0] == -1);
    assert_near(strain[1], 5e200, 1e-15, 0);
    cd_chain_destroy(c);

    const double triangle[3][2] = {{0, 0}, {3, 0}, {3, 4}}, tensions[3] = {1, 2, 5}; /* of a ring */
    double strains[3];
    ok(cd_chain_create(1, 2, 2, CD_FLOAT64, NULL, &c));
    ok(cd_chain_set_ring(c, 1));
    ok(cd_chain_set_rest_length(c, 3));
    ok(cd_chain_write_f64(c, CD_POSITION, 0, 1, 0, 3, triangle[0], 6));
    ok(cd_chain_write_f64(c, CD_TENSION, 0, 1, 0, 3, tensions, 3));
    ok(cd_chain_read_f64(c, CD_STRAIN, 0, 1, 0, 3, strains, 3));
    assert_true(strains[0] == 2 && strains[1] == 3 && strains[2] == 4);
    ok(cd_chain_get_reaction(c, 0, 0, f, 2));
    assert_near(f[0], 1 + 3, 1e-15, 0), assert_near(f[1], 4, 1e-15, 0);
    ok(cd_chain_get_reaction(c, 0, 2, f, 2));
    assert_near(f[0], -3, 1e-15, 0), assert_near(f[1], -2 - 4, 1e-15, 0);
    cd_chain_destroy(c);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_rope_bears_its_strength_and_no_more),
        cmocka_unit_test(the_spring_most_beyond_its_strength_breaks_first),
        cmocka_unit_test(a_jerked_rope_snaps_in_one_place),
        cmocka_unit_test(what_no_tension_holds_breaks_at_its_weakest),
        cmocka_unit_test(no_energy_comes_of_breaking),
        cmocka_unit_test(a_held_node_feels_the_weight_that_hangs_from_it),
        cmocka_unit_test(tensions_of_unsolved_steps_are_of_the_size_of_the_forces),
        cmocka_unit_test(a_hung_rope_pulls_its_pins_together_and_down),
        cmocka_unit_test(reactions_and_strains_of_odd_springs),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
