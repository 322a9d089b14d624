/* Ropes that resist bending, rods and hair, against exact answers: the elastica, a beam's lowest mode, momentum and
 * energy of a free rod, what a clamp bears; and that strands are individuals. */
#include <math.h>
#include <string.h>

#include "check.h"
#include "reference.h"

#define PI 3.14159265358979323846
enum { MOST = 70 };

static const double down[3] = {0, -9.81, 0}, nowhere[3] = {0, 0, 0};

/* Where the end of a clamped beam of length 1 lies under its own weight, load = weight L^2 / EI: the angle t below the
 * level obeys t'' = -load (1 - s) cos t with t(0) = t'(1) = 0, which is shot for. */
static double shoot(double load, double bend, double* x, double* y) {
    enum { PARTS = 4000 };
    const double h = 1.0 / PARTS;
    double t = 0, k = bend;
    *x = *y = 0;
    for (int i = 0; i < PARTS; ++i) {
        const double s = i * h, m = s + h / 2, e = s + h;
        const double t1 = k, k1 = -load * (1 - s) * cos(t), t2 = k + h / 2 * k1,
                     k2 = -load * (1 - m) * cos(t + h / 2 * t1), t3 = k + h / 2 * k2,
                     k3 = -load * (1 - m) * cos(t + h / 2 * t2), t4 = k + h * k3,
                     k4 = -load * (1 - e) * cos(t + h * t3), middle = t + h / 2 * t2,
                     next = t + h / 6 * (t1 + 2 * t2 + 2 * t3 + t4);
        *x += h / 6 * (cos(t) + 4 * cos(middle) + cos(next));
        *y -= h / 6 * (sin(t) + 4 * sin(middle) + sin(next));
        t = next, k += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
    }
    return k;
}
static void elastica(double load, double* x, double* y) {
    double low = 0, high = load;
    for (int i = 0; i < 60; ++i) {
        const double bend = (low + high) / 2;
        if (shoot(load, bend, x, y) > 0) high = bend;
        else low = bend;
    }
}

/* A beam of 1 m and 1 kg along x in the first `components`, of `links` links beside the one that its clamp holds. The
 * joint at the clamp bends over half a link: it is twice as stiff as the others. */
static cd_chain* beam(size_t links, size_t components, double rigidity, int push) {
    const double h = 1.0 / (double)links, at_clamp = 2 * rigidity / (h * h * h), pins[] = {1, 1};
    cd_chain* chain = NULL;
    ok(cd_chain_create(1, links + 1, components, CD_FLOAT64, NULL, &chain));
    ok(cd_chain_set_rest_length(chain, 1 + h));
    ok(cd_chain_set_stiffness(chain, INFINITY));
    ok(cd_chain_set_push(chain, push));
    ok(cd_chain_set_mass_rule(chain, CD_MASS_HALF_ENDS));
    ok(cd_chain_set_mass(chain, 1 + h));
    ok(cd_chain_set_gravity(chain, down, components));
    ok(cd_chain_set_bend(chain, rigidity / pow(1 + h, 3)));
    ok(cd_chain_enable_field(chain, CD_BEND));
    ok(cd_chain_write_f64(chain, CD_BEND, 0, 1, 1, 1, &at_clamp, 1));
    for (size_t i = 0; i < links + 2; ++i) {
        const double x[3] = {((double)i - 1) * h, 0, 0};
        ok(cd_chain_write_f64(chain, CD_POSITION, 0, 1, i, 1, x, components));
    }
    ok(cd_chain_write_f64(chain, CD_PIN, 0, 1, 0, 2, pins, 2));
    return chain;
}

static void a_beam_bends_as_the_elastica_to_second_order(void** state) {
    (void)state;
    static const double loads[] = {0.5, 5, 50}, allowed[] = {2.6e-4, 2.4e-3, 7e-3};
    for (size_t k = 0; k < COUNT(loads); ++k) {
        double x, y, before = 0;
        elastica(loads[k], &x, &y);
        for (size_t links = 16; links <= 64; links *= 2) {
            double end[2];
            cd_chain* chain = beam(links, 2, 9.81 / loads[k], 1);
            ok(cd_chain_set_lambda(chain, 1));
            ok(cd_chain_set_drag(chain, 1));
            for (int i = 0; i < 300; ++i) ok(cd_chain_step(chain, i < 200 ? 0.1 : 10, 1));
            ok(cd_chain_read_f64(chain, CD_POSITION, 0, 1, links + 1, 1, end, 2));
            const double error = hypot(end[0] - x, end[1] - y);
            print_message("load %g, %zu links: end off by %.1e\n", loads[k], links, error);
            assert_true(error < allowed[k]);
            if (links > 16) assert_true(error < before / 3.5);
            before = error;
            cd_chain_destroy(chain);
        }
    }
}

/* The forces that the two held nodes bear: their sum is the weight of the free ones, and their moment is that of it. */
static void a_clamp_bears_weight_and_moment(void** state) {
    (void)state;
    enum { LINKS = 20 };
    cd_chain* chain = beam(LINKS, 3, 3, 0);
    double x[LINKS + 2][3], weight = 0, moment = 0, force[2][3];
    ok(cd_chain_set_lambda(chain, 1));
    ok(cd_chain_set_drag(chain, 1));
    ok(cd_chain_set_tolerance(chain, 1e-11, 200));
    for (int i = 0; i < 300; ++i) ok(cd_chain_step(chain, i < 200 ? 0.1 : 10, 1));
    ok(cd_chain_read_f64(chain, CD_POSITION, 0, 1, 0, LINKS + 2, x[0], sizeof x / sizeof(double)));
    for (int i = 2; i < LINKS + 2; ++i) {
        const double own = 9.81 / LINKS * (i == LINKS + 1 ? 0.5 : 1);
        weight += own, moment += own * x[i][0];
    }
    for (size_t i = 0; i < 2; ++i) ok(cd_chain_get_reaction(chain, 0, i, force[i], 3));
    assert_true(fabs(force[0][1] + force[1][1] + weight) < 1e-8 && fabs(force[0][0] + force[1][0]) < 1e-8);
    assert_true(fabs(x[0][0] * force[0][1] + x[1][0] * force[1][1] + moment) < 1e-8);
    cd_chain_destroy(chain);
}

static void a_beam_swings_at_its_lowest_frequency(void** state) {
    (void)state;
    enum { LINKS = 40 };
    const double rigidity = 2, frequency = 1.875104068711961 * 1.875104068711961 * sqrt(rigidity);
    cd_chain* chain = beam(LINKS, 2, rigidity, 1);
    ok(cd_chain_set_gravity(chain, nowhere, 2));
    for (size_t i = 2; i < LINKS + 2; ++i) { /* its mode, small */
        const double b = 1.875104068711961, s = (double)(i - 1) / LINKS, sigma = 0.734095513758;
        const double v[2] = {0, 1e-4 * (cosh(b * s) - cos(b * s) - sigma * (sinh(b * s) - sin(b * s)))};
        ok(cd_chain_write_f64(chain, CD_VELOCITY, 0, 1, i, 1, v, 2));
    }
    const double dt = 2 * PI / frequency / 200;
    double before = 0, turns = 0, last = 0, time = 0;
    for (int step = 0; step < 1000; ++step) {
        double end[2];
        ok(cd_chain_step(chain, dt, 1));
        time += dt;
        ok(cd_chain_read_f64(chain, CD_POSITION, 0, 1, LINKS + 1, 1, end, 2));
        if (before > 0 && end[1] <= 0) last = time - dt * end[1] / (end[1] - before), ++turns;
        before = end[1];
    }
    const double found = 2 * PI * (turns - 0.5) / last;
    print_message("lowest frequency %.6f, beam %.6f\n", found, frequency);
    assert_near(found / frequency, 1, 1e-3, 0);
    cd_chain_destroy(chain);
}

/* A free rod that tumbles and vibrates, at lambda = 1/2. */
static void a_free_rod_keeps_momentum_and_energy(void** state) {
    (void)state;
    enum { NODES = 33 };
    uint64_t seed = 7;
    for (int push = 0; push <= 1; ++push) {
        cd_chain* chain = NULL;
        double p[2][3], spin[2] = {0, 0}, kinetic, elastic, energy[2];
        ok(cd_chain_create(1, NODES - 1, 3, CD_FLOAT64, NULL, &chain));
        ok(cd_chain_set_rest_length(chain, 1));
        ok(cd_chain_set_stiffness(chain, INFINITY));
        ok(cd_chain_set_push(chain, push));
        ok(cd_chain_set_bend(chain, 0.3));
        ok(cd_chain_set_tolerance(chain, 1e-12, 200));
        for (size_t i = 0; i < NODES; ++i) {
            const double at = (double)i / (NODES - 1), x[3] = {at, 0, 0},
                         v[3] = {0, 4 * (at - 0.5) + 0.3, 2 * sin(3 * PI * at) + 0.1 * random_number(&seed)};
            ok(cd_chain_write_f64(chain, CD_POSITION, 0, 1, i, 1, x, 3));
            ok(cd_chain_write_f64(chain, CD_VELOCITY, 0, 1, i, 1, v, 3));
        }
        for (int when = 0; when < 2; ++when) {
            double x[NODES][3], v[NODES][3];
            for (int i = 0; i < 500 && when; ++i) ok(cd_chain_step(chain, 1e-3, 1));
            ok(cd_chain_get_momentum(chain, p[when], 3));
            ok(cd_chain_get_energy(chain, &kinetic, &elastic, NULL));
            energy[when] = kinetic + elastic;
            ok(cd_chain_read_f64(chain, CD_POSITION, 0, 1, 0, NODES, x[0], 3 * NODES));
            ok(cd_chain_read_f64(chain, CD_VELOCITY, 0, 1, 0, NODES, v[0], 3 * NODES));
            for (size_t i = 0; i < NODES; ++i) spin[when] += (x[i][0] * v[i][1] - x[i][1] * v[i][0]) / NODES;
        }
        print_message("push %d: energy %.9f of its start, spin off by %.1e\n", push, energy[1] / energy[0],
                      spin[1] - spin[0]);
        for (int k = 0; k < 3; ++k) assert_true(fabs(p[1][k] - p[0][k]) < 1e-12);
        assert_true(energy[1] <= energy[0] * (1 + 1e-9));
        /* springs that only pull lose a jerk now and then */
        if (push) assert_true(fabs(spin[1] - spin[0]) < 1e-9 && energy[1] > 0.99 * energy[0]);
        cd_chain_destroy(chain);
    }
}

/* A rod of uneven links rests where it is straight, whatever its stiffness; and bent, it comes back to that. */
static void uneven_links_rest_where_they_are_straight(void** state) {
    (void)state;
    enum { LINKS = 12 };
    cd_chain* chain = NULL;
    double length[LINKS], x[LINKS + 1][2] = {{0, 0}}, found[LINKS + 1][2], pins[2] = {1, 1};
    uint64_t seed = 3;
    ok(cd_chain_create(1, LINKS, 2, CD_FLOAT64, NULL, &chain));
    ok(cd_chain_set_rest_length(chain, 1));
    ok(cd_chain_set_stiffness(chain, INFINITY));
    ok(cd_chain_set_bend(chain, 10));
    ok(cd_chain_set_lambda(chain, 1));
    ok(cd_chain_enable_field(chain, CD_REST_LENGTH));
    for (int i = 0; i < LINKS; ++i) {
        length[i] = pow(10, 0.7 * random_number(&seed));
        x[i + 1][0] = x[i][0] + 0.6 * length[i], x[i + 1][1] = x[i][1] + 0.8 * length[i];
    }
    ok(cd_chain_write_f64(chain, CD_REST_LENGTH, 0, 1, 0, LINKS, length, LINKS));
    ok(cd_chain_write_f64(chain, CD_POSITION, 0, 1, 0, LINKS + 1, x[0], 2 * (LINKS + 1)));
    ok(cd_chain_write_f64(chain, CD_PIN, 0, 1, 0, 2, pins, 2));
    ok(cd_chain_step(chain, 0.1, 20));
    ok(cd_chain_read_f64(chain, CD_POSITION, 0, 1, 0, LINKS + 1, found[0], 2 * (LINKS + 1)));
    for (int i = 0; i <= LINKS; ++i) assert_true(hypot(found[i][0] - x[i][0], found[i][1] - x[i][1]) < 1e-11);
    const double kick[2] = {2, -1.5};
    ok(cd_chain_impulse(chain, 0, LINKS, kick, 2));
    ok(cd_chain_step(chain, 0.01, 5));
    ok(cd_chain_read_f64(chain, CD_POSITION, 0, 1, 0, LINKS + 1, found[0], 2 * (LINKS + 1)));
    assert_true(hypot(found[LINKS][0] - x[LINKS][0], found[LINKS][1] - x[LINKS][1]) > 1e-3);
    ok(cd_chain_set_drag(chain, 1));
    for (int i = 0; i < 400; ++i) ok(cd_chain_step(chain, 1, 1));
    ok(cd_chain_read_f64(chain, CD_POSITION, 0, 1, 0, LINKS + 1, found[0], 2 * (LINKS + 1)));
    for (int i = 0; i <= LINKS; ++i) assert_true(hypot(found[i][0] - x[i][0], found[i][1] - x[i][1]) < 1e-6);
    cd_chain_destroy(chain);
}

/* A rod of masses from 1e-3 to 1e3 kg, crumpled, in which every sixth node is held: it is slack and comes to rest bent,
 * by forces of which its lightest nodes feel the rounding most. Each step reaches its tolerance. One that nothing holds
 * keeps its momentum: each step rounds each node's share of it, by a few of the last digits. */
static void what_is_held_bent_comes_to_rest(void** state) {
    (void)state;
    enum { NODES = 31 };
    const double held = CD_NODE_PINNED;
    for (uint64_t number = 0; number < 60; ++number) {
        const int is_free = number % 3 == 0;
        uint64_t seed = 100 + number;
        cd_chain* chain = NULL;
        double x[NODES][2], v[NODES][2], mass[NODES], end[2], kinetic, elastic, rounded = 0;
        ok(cd_chain_create(1, NODES - 1, 2, CD_FLOAT64, NULL, &chain));
        ok(cd_chain_set_rest_length(chain, NODES - 1));
        ok(cd_chain_set_stiffness(chain, INFINITY));
        ok(cd_chain_set_bend(chain, 1e6));
        ok(cd_chain_set_lambda(chain, 1));
        ok(cd_chain_enable_field(chain, CD_MASS));
        for (int i = 0; i < NODES; ++i) {
            mass[i] = pow(10, 3 * random_number(&seed));
            x[i][0] = 0.5 * i, x[i][1] = random_number(&seed);
        }
        ok(cd_chain_write_f64(chain, CD_MASS, 0, 1, 0, NODES, mass, NODES));
        ok(cd_chain_write_f64(chain, CD_POSITION, 0, 1, 0, NODES, x[0], 2 * NODES));
        for (size_t i = 0; i < NODES && !is_free; i += 6) ok(cd_chain_write_f64(chain, CD_PIN, 0, 1, i, 1, &held, 1));
        for (int step = 0; step < (is_free ? 5 : 100); ++step) {
            ok(cd_chain_step(chain, 0.5, 1));
            ok(cd_chain_read_f64(chain, CD_VELOCITY, 0, 1, 0, NODES, v[0], 2 * NODES));
            for (int i = 0; i < NODES; ++i) rounded += 4 * 0x1p-53 * mass[i] * hypot(v[i][0], v[i][1]);
        }
        ok(cd_chain_get_momentum(chain, end, 2));
        ok(cd_chain_get_energy(chain, &kinetic, &elastic, NULL));
        if (is_free) assert_true(hypot(end[0], end[1]) < rounded);
        else assert_true(kinetic < 1e-12 * elastic);
        cd_chain_destroy(chain);
    }
}

/* Hair on its root: stiff hair stands, soft hair falls over; a blow bends it, and it comes back. */
static void stiff_hair_stands_and_soft_hair_falls(void** state) {
    (void)state;
    enum { LINKS = 20, STRANDS = 2 };
    static const double bends[STRANDS] = {5, 0.01};
    cd_chain* chain = NULL;
    double bend[STRANDS][LINKS + 1], pins[STRANDS][2] = {{1, 1}, {1, 1}}, end[STRANDS][3];
    ok(cd_chain_create(STRANDS, LINKS, 3, CD_FLOAT64, NULL, &chain));
    ok(cd_chain_set_rest_length(chain, 1));
    ok(cd_chain_set_stiffness(chain, INFINITY));
    ok(cd_chain_set_gravity(chain, down, 3));
    ok(cd_chain_set_push(chain, 1));
    ok(cd_chain_set_lambda(chain, 1));
    ok(cd_chain_enable_field(chain, CD_BEND));
    for (size_t s = 0; s < STRANDS; ++s)
        for (size_t i = 0; i <= LINKS; ++i) {
            const double x[3] = {(double)s + 1e-3 * (double)(i * i) / (LINKS * LINKS), (double)i / LINKS, 0};
            bend[s][i] = bends[s] * pow(LINKS, 3);
            ok(cd_chain_write_f64(chain, CD_POSITION, s, 1, i, 1, x, 3));
        }
    ok(cd_chain_write_f64(chain, CD_BEND, 0, STRANDS, 0, LINKS + 1, bend[0], STRANDS * (LINKS + 1)));
    ok(cd_chain_write_f64(chain, CD_PIN, 0, STRANDS, 0, 2, pins[0], 2 * STRANDS));
    for (int blow = 0; blow < 2; ++blow) {
        for (int i = 0; i < 600; ++i) ok(cd_chain_step(chain, 1.0 / 60, 1));
        ok(cd_chain_read_f64(chain, CD_POSITION, 0, STRANDS, LINKS, 1, end[0], 3 * STRANDS));
        print_message("ends at height %.3f and %.3f\n", end[0][1], end[1][1]);
        assert_true(end[0][1] > 0.85 && fabs(end[0][0]) < 0.05 && fabs(end[0][2]) < 0.05);
        assert_true(end[1][1] < 0);
        const double kick[3] = {0, 0, 0.5};
        ok(cd_chain_impulse(chain, 0, LINKS, kick, 3));
        ok(cd_chain_step(chain, 1.0 / 60, 3));
        ok(cd_chain_read_f64(chain, CD_POSITION, 0, 1, LINKS, 1, end[0], 3));
        assert_true(end[0][2] > 0.05);
    }
    cd_chain_destroy(chain);
}

/* Strands of different bends, each as if it were alone, to the bit; also where air resists and they lie on a ball. */
static void strands_bend_each_as_if_alone(void** state) {
    (void)state;
    enum { LINKS = 15, STRANDS = 11 };
    static const double centre[3] = {0.5, -0.4, 0.1};
    for (int lambda = 1; lambda <= 2; ++lambda) {
        cd_chain *all = NULL, *one = NULL;
        for (size_t s = 0; s <= STRANDS; ++s) {
            const size_t strands = s < STRANDS ? 1 : STRANDS;
            cd_chain* chain = NULL;
            ok(cd_chain_create(strands, LINKS, 3, CD_FLOAT64, NULL, &chain));
            ok(cd_chain_set_rest_length(chain, 1));
            ok(cd_chain_set_stiffness(chain, INFINITY));
            ok(cd_chain_set_gravity(chain, down, 3));
            ok(cd_chain_set_lambda(chain, 0.5 * lambda));
            ok(cd_chain_set_air(chain, 0.01, 0.2));
            ok(cd_chain_set_colliders(chain, 1));
            ok(cd_chain_set_capsule(chain, 0, centre, centre, 3, 0.2, 0.4));
            ok(cd_chain_enable_field(chain, CD_BEND));
            ok(cd_chain_set_end(chain, CD_END_FIRST, CD_NODE_PINNED));
            for (size_t k = 0; k < strands; ++k) {
                const size_t which = s < STRANDS ? s : k;
                double bend[LINKS + 1];
                for (size_t i = 0; i <= LINKS; ++i) {
                    const double x[3] = {(double)i / LINKS, 0, 0.02 * (double)which};
                    bend[i] = which % 4 == 0 ? 0 : pow(10, (double)which - 4);
                    ok(cd_chain_write_f64(chain, CD_POSITION, k, 1, i, 1, x, 3));
                }
                ok(cd_chain_write_f64(chain, CD_BEND, k, 1, 0, LINKS + 1, bend, LINKS + 1));
            }
            for (int i = 0; i < 60; ++i) ok(cd_chain_step(chain, 1.0 / 60, 1));
            if (s == STRANDS) all = chain;
            else if (s == 6) one = chain;
            else cd_chain_destroy(chain);
        }
        double together[LINKS + 1][3], alone[LINKS + 1][3];
        ok(cd_chain_read_f64(all, CD_POSITION, 6, 1, 0, LINKS + 1, together[0], 3 * (LINKS + 1)));
        ok(cd_chain_read_f64(one, CD_POSITION, 0, 1, 0, LINKS + 1, alone[0], 3 * (LINKS + 1)));
        assert_memory_equal(together, alone, sizeof alone);
        cd_chain_destroy(all);
        cd_chain_destroy(one);
    }
}

/* Two posed nodes that clamp a strand are as far apart as float32 lets them be, which is no fault of the step. */
static void what_is_posed_may_be_rounded(void** state) {
    (void)state;
    enum { LINKS = 15 };
    cd_chain* chain = NULL;
    const float pins[2] = {CD_NODE_POSED, CD_NODE_POSED};
    ok(cd_chain_create(1, LINKS, 3, CD_FLOAT32, NULL, &chain));
    ok(cd_chain_set_rest_length(chain, 0.25));
    ok(cd_chain_set_stiffness(chain, INFINITY));
    ok(cd_chain_set_bend(chain, 1e-6));
    ok(cd_chain_set_lambda(chain, 1));
    for (size_t i = 0; i <= LINKS; ++i) {
        const double x[3] = {3 + 0.25 * (double)i / LINKS, 0.6, 0};
        ok(cd_chain_write_f64(chain, CD_POSITION, 0, 1, i, 1, x, 3));
    }
    ok(cd_chain_enable_field(chain, CD_TARGET));
    ok(cd_chain_write_f32(chain, CD_PIN, 0, 1, 0, 2, pins, 2));
    for (int frame = 0; frame < 200; ++frame) {
        const double turn = 0.01 * frame,
                     root[2][3] = {{3, 0.6, 0}, {3 + 0.25 / LINKS * cos(turn), 0.6 + 0.25 / LINKS * sin(turn), 0}};
        ok(cd_chain_write_f64(chain, CD_TARGET, 0, 1, 0, 2, root[0], 6));
        ok(cd_chain_step(chain, 1.0 / 60, 1));
    }
    cd_chain_destroy(chain);
}

/* A bent rod that is cut: its halves know nothing of each other any more. */
static void a_cut_takes_the_bend_at_its_ends_with_it(void** state) {
    (void)state;
    enum { LINKS = 9 };
    cd_chain* chain = NULL;
    ok(cd_chain_create(1, LINKS, 2, CD_FLOAT64, NULL, &chain));
    ok(cd_chain_set_rest_length(chain, 1));
    ok(cd_chain_set_stiffness(chain, INFINITY));
    ok(cd_chain_set_bend(chain, 10));
    double angle = 0, at[2] = {0, 0}, v[LINKS + 1][2];
    for (size_t i = 0; i <= LINKS; ++i) {
        ok(cd_chain_write_f64(chain, CD_POSITION, 0, 1, i, 1, at, 2));
        at[0] += cos(angle) / LINKS, at[1] += sin(angle) / LINKS, angle += 0.2;
    }
    ok(cd_chain_cut(chain, 0, 4));
    for (int i = 0; i < 20; ++i) ok(cd_chain_step(chain, 1e-3, 1));
    ok(cd_chain_read_f64(chain, CD_VELOCITY, 0, 1, 0, LINKS + 1, v[0], 2 * (LINKS + 1)));
    double left[2] = {0, 0}, right[2] = {0, 0}, fastest = 0;
    for (int i = 0; i <= LINKS; ++i)
        for (int k = 0; k < 2; ++k) (i <= 4 ? left : right)[k] += v[i][k], fastest = fmax(fastest, fabs(v[i][k]));
    assert_true(fastest > 0.1);
    for (int k = 0; k < 2; ++k) assert_true(fabs(left[k]) < 1e-11 * fastest && fabs(right[k]) < 1e-11 * fastest);
    cd_chain_destroy(chain);
}

/* Nodes of a rod lie a hundred to ten million of its lengths apart. What rounding makes of its joints' energy then is
 * large beside the work of its springs, and excuses no wrong one: a step that is CD_OK leaves each as long as its tension
 * makes it. One that is shorter by a part s of its rest length may keep a tension of tolerance / s times the mean tension
 * or the mean force on the nodes (chain.h), which is what takes their momentum m v away in a step, or gives it. */
static void a_rod_that_was_torn_apart_comes_back_or_says_that_it_does_not(void** state) {
    (void)state;
    enum { LINKS = 38, RODS = 30 };
    const double length = 0.17, tolerance = 1e-10, per_link = LINKS; /* stiffness of a strand is 1 */
    static const double dts[] = {4e-5, 0.04, 1.5};
    size_t right = 0;
    uint64_t seed = 1;
    for (int k = 0; k < RODS; ++k) {
        const double far = length * pow(10, 2 + 5.0 * k / RODS);
        cd_chain* chain = NULL;
        ok(cd_chain_create(1, LINKS, 1, CD_FLOAT64, NULL, &chain));
        ok(cd_chain_set_rest_length(chain, length));
        ok(cd_chain_set_bend(chain, 0.004));
        ok(cd_chain_set_tolerance(chain, tolerance, 75));
        double x[LINKS + 1], tension[LINKS];
        for (int i = 0; i <= LINKS; ++i) x[i] = far * random_number(&seed);
        ok(cd_chain_write_f64(chain, CD_POSITION, 0, 1, 0, LINKS + 1, x, LINKS + 1));
        for (int step = 0; step < 4; ++step) {
            const double dt = dts[k % COUNT(dts)];
            double largest = 0, v[LINKS + 1], force = 0, pull = 0;
            for (int i = 0; i <= LINKS; ++i) largest = fmax(largest, fabs(x[i]));
            ok(cd_chain_read_f64(chain, CD_VELOCITY, 0, 1, 0, LINKS + 1, v, LINKS + 1));
            for (int i = 0; i <= LINKS; ++i) force += fabs(v[i]) / (LINKS + 1) / (LINKS + 1) / dt; /* of 1 kg in all */
            const cd_status status = cd_chain_step(chain, dt, 1);
            assert_true(status == CD_OK || status == CD_ERROR_TOLERANCE);
            ok(cd_chain_read_f64(chain, CD_POSITION, 0, 1, 0, LINKS + 1, x, LINKS + 1));
            ok(cd_chain_read_f64(chain, CD_TENSION, 0, 1, 0, LINKS, tension, LINKS));
            for (int i = 0; i <= LINKS; ++i) largest = fmax(largest, fabs(x[i]));
            for (int i = 0; i < LINKS; ++i) pull += tension[i] / LINKS;
            for (int i = 0; i < LINKS && status == CD_OK; ++i) {
                const double over = fabs(x[i + 1] - x[i]) - length / LINKS - tension[i] / per_link;
                if (tension[i] == 0 && over < 0) continue;
                const int keeps = over < 0 && -over * tension[i] <= tolerance * length / LINKS * fmax(force, pull);
                assert_true(keeps || fabs(over) <= 2 * tolerance * length / LINKS + 1e-13 * largest);
                ++right;
            }
        }
        cd_chain_destroy(chain);
    }
    print_message("%zu springs were right\n", right);
    assert_true(right > 500);
}

/* Free rods and ropes that begin crumpled, whose springs go slack and jerk taut: none gains energy, but for what errors of
 * length are worth. */
static void what_goes_slack_and_taut_gains_nothing(void** state) {
    (void)state;
    enum { SCENES = 600, STEPS = 30 };
    for (uint64_t scene = 0; scene < SCENES; ++scene) {
        uint64_t seed = 1000 * scene + 7 + other_scenes();
        const size_t springs = 4 + scene % 5, components = 2 + scene / 5 % 2, nodes = springs + 1;
        const double tolerance = 1e-6, length = 1 / (double)springs, dt = 1 / 60.0;
        double x[MOST * 3] = {0}, v[MOST * 3], tension[MOST], before = 0, worth_before = 0;
        cd_chain* c = NULL;
        ok(cd_chain_create(1, springs, components, CD_FLOAT64, NULL, &c));
        ok(cd_chain_set_rest_length(c, 1));
        ok(cd_chain_set_stiffness(c, INFINITY));
        ok(cd_chain_set_bend(c, scene % 4 == 3 ? 0 : pow(10, random_number(&seed))));
        for (size_t i = 0; i < nodes; ++i) {
            double way[3], square = 0;
            for (size_t k = 0; k < components; ++k) way[k] = random_number(&seed), square += way[k] * way[k];
            for (size_t k = 0; k < components; ++k) {
                const size_t at = i * components + k;
                if (i > 0) x[at] = x[at - components] + length * way[k] / sqrt(square);
                v[at] = 3 * random_number(&seed);
            }
        }
        ok(cd_chain_write_f64(c, CD_POSITION, 0, 1, 0, nodes, x, components * nodes));
        ok(cd_chain_write_f64(c, CD_VELOCITY, 0, 1, 0, nodes, v, components * nodes));
        for (int step = 0; step <= STEPS; ++step) {
            double kinetic, elastic, worth = 0;
            size_t iterations = 0;
            if (step > 0) ok(cd_chain_step(c, dt, 1));
            ok(cd_chain_get_energy(c, &kinetic, &elastic, NULL));
            ok(cd_chain_read_f64(c, CD_TENSION, 0, 1, 0, springs, tension, springs));
            ok(cd_chain_get_convergence(c, &iterations, NULL));
            for (size_t i = 0; i < springs; ++i) worth += 2 * fabs(tension[i]) * tolerance * length;
            const double energy = kinetic + elastic, mean = 3 / dt; /* the force on the nodes, 1 kg at 3 m/s, is less */
            const double room = worth + worth_before + (iterations > 8 ? 4 * mean * tolerance : 0) + 1e-12 * energy;
            if (step > 0) assert_true(energy - before <= room);
            before = energy, worth_before = worth;
        }
        cd_chain_destroy(c);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_beam_bends_as_the_elastica_to_second_order),
        cmocka_unit_test(a_clamp_bears_weight_and_moment),
        cmocka_unit_test(a_beam_swings_at_its_lowest_frequency),
        cmocka_unit_test(a_free_rod_keeps_momentum_and_energy),
        cmocka_unit_test(uneven_links_rest_where_they_are_straight),
        cmocka_unit_test(what_is_held_bent_comes_to_rest),
        cmocka_unit_test(stiff_hair_stands_and_soft_hair_falls),
        cmocka_unit_test(strands_bend_each_as_if_alone),
        cmocka_unit_test(what_is_posed_may_be_rounded),
        cmocka_unit_test(a_cut_takes_the_bend_at_its_ends_with_it),
        cmocka_unit_test(a_rod_that_was_torn_apart_comes_back_or_says_that_it_does_not),
        cmocka_unit_test(what_goes_slack_and_taut_gains_nothing),
    };
    return cmocka_run_group_tests_name("ropes that bend", tests, NULL, NULL);
}
