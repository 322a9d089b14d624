/* Rods with rest angles against exact answers: a curved beam under a small load, the polygon that they are at rest, and
 * the force as the slope of the energy; wherever they lie in the plane. */
#include <math.h>
#include <string.h>

#include "check.h"
#include "reference.h"

#define PI 3.14159265358979323846
enum { MOST = 140 };

/* A rod of fixed links that push, at rest: its links are turned by `angle` at each node, the first one along `way`. */
struct rod {
    size_t links;
    double way, length[MOST], angle[MOST + 1], x[MOST + 1][2];
};
static void lay_out(struct rod* r) {
    double way = r->way;
    memset(r->x, 0, sizeof r->x);
    for (size_t i = 0; i < r->links; ++i) {
        way += i > 0 ? r->angle[i] : 0;
        r->x[i + 1][0] = r->x[i][0] + r->length[i] * cos(way);
        r->x[i + 1][1] = r->x[i][1] + r->length[i] * sin(way);
    }
}
static cd_chain* make(const struct rod* r, double bend) {
    cd_chain* chain = NULL;
    ok(cd_chain_create(1, r->links, 2, CD_FLOAT64, NULL, &chain));
    ok(cd_chain_set_rest_length(chain, 1));
    ok(cd_chain_set_stiffness(chain, INFINITY));
    ok(cd_chain_set_push(chain, 1));
    ok(cd_chain_set_bend(chain, bend));
    ok(cd_chain_enable_field(chain, CD_REST_LENGTH));
    ok(cd_chain_enable_field(chain, CD_REST_ANGLE));
    ok(cd_chain_write_f64(chain, CD_REST_LENGTH, 0, 1, 0, r->links, r->length, r->links));
    ok(cd_chain_write_f64(chain, CD_REST_ANGLE, 0, 1, 0, r->links + 1, r->angle, r->links + 1));
    ok(cd_chain_write_f64(chain, CD_POSITION, 0, 1, 0, r->links + 1, r->x[0], 2 * (r->links + 1)));
    return chain;
}
/* Uneven links, and angles up to `most`. */
static void draw(struct rod* r, size_t links, double most, uint64_t* seed) {
    r->links = links, r->way = PI * random_number(seed);
    for (size_t i = 0; i < links; ++i) r->length[i] = 0.1 * pow(4, random_number(seed));
    for (size_t i = 0; i <= links; ++i) r->angle[i] = most * random_number(seed);
    lay_out(r);
}
static void read_positions(const cd_chain* chain, const struct rod* r, double x[MOST + 1][2]) {
    ok(cd_chain_read_f64(chain, CD_POSITION, 0, 1, 0, r->links + 1, x[0], 2 * (r->links + 1)));
}

/* A quarter of a circle of radius R, clamped at its lower end, where it is level, with a load P at the other one: P R^3
 * / (E I) times 3 pi / 4 - 2 is how far that goes down, times 1/2 how far along. (Castigliano) */
static void a_curved_beam_yields_to_second_order(void** state) {
    (void)state;
    const double load = 1e-5, exact[2] = {0.5, 0.75 * PI - 2};
    double before = 0;
    for (size_t links = 16; links <= 64; links *= 2) {
        static struct rod r;
        const double angle = PI / 2 / (double)links, pins[2] = {1, 1}, force[2] = {0, -load};
        r.links = links + 1, r.way = -angle / 2;
        for (size_t i = 0; i <= links; ++i) r.length[i] = 2 * sin(angle / 2), r.angle[i] = angle;
        lay_out(&r);
        const double h = r.length[0];
        cd_chain* chain = make(&r, 1 / pow(h * (double)r.links, 3));
        const double at_clamp = 2 / (h * h * h); /* over half a link */
        ok(cd_chain_enable_field(chain, CD_BEND));
        ok(cd_chain_write_f64(chain, CD_BEND, 0, 1, 1, 1, &at_clamp, 1));
        ok(cd_chain_write_f64(chain, CD_PIN, 0, 1, 0, 2, pins, 2));
        ok(cd_chain_enable_field(chain, CD_FORCE));
        ok(cd_chain_write_f64(chain, CD_FORCE, 0, 1, r.links, 1, force, 2));
        ok(cd_chain_set_lambda(chain, 1));
        ok(cd_chain_set_tolerance(chain, 1e-13, 200));
        for (int i = 0; i < 100; ++i) ok(cd_chain_step(chain, 10, 1));
        double x[MOST + 1][2], error = 0;
        read_positions(chain, &r, x);
        for (int k = 0; k < 2; ++k) {
            const double moved = fabs(x[r.links][k] - r.x[r.links][k]) / load;
            error = fmax(error, fabs(moved / exact[k] - 1));
        }
        print_message("%zu links: off by %.1e\n", links, error);
        assert_true(error < 0.3 / pow((double)links / 4, 2));
        if (links > 16) assert_true(error < before / 3.5);
        before = error;
        cd_chain_destroy(chain);
    }
}

/* Laid out straight it turns into its shape; which is what any rod of these angles is at rest in. */
static void a_rod_takes_the_shape_of_its_angles(void** state) {
    (void)state;
    uint64_t seed = 5 + other_scenes();
    for (int k = 0; k < 6; ++k) {
        static struct rod r, straight;
        draw(&r, 2 + 3 * (size_t)k, k % 2 ? 2.5 : 0.5, &seed);
        straight = r;
        memset(straight.angle, 0, sizeof straight.angle);
        lay_out(&straight);
        memcpy(straight.angle, r.angle, sizeof r.angle);
        cd_chain* chain = make(&straight, 0.01);
        ok(cd_chain_set_lambda(chain, 1));
        ok(cd_chain_set_drag(chain, 1));
        for (int i = 0; i < 2000; ++i) ok(cd_chain_step(chain, i < 1000 ? 0.01 : 10, 1));
        double x[MOST + 1][2], elastic, worst = 0;
        read_positions(chain, &r, x);
        for (size_t i = 1; i < r.links; ++i) {
            const double turned = atan2(x[i + 1][1] - x[i][1], x[i + 1][0] - x[i][0]) -
                                  atan2(x[i][1] - x[i - 1][1], x[i][0] - x[i - 1][0]);
            worst = fmax(worst, fabs(remainder(turned - r.angle[i], 2 * PI)));
        }
        ok(cd_chain_get_energy(chain, NULL, &elastic, NULL));
        print_message("%zu links: angles off by %.1e, energy left %.1e\n", r.links, worst, elastic);
        assert_true(worst < 1e-6 && elastic < 1e-9);
        cd_chain_destroy(chain);
    }
}

/* Wherever it lies and however stiff it is, it stays as it is, still or moving evenly. */
static void what_is_in_its_shape_rests(void** state) {
    (void)state;
    uint64_t seed = 9 + other_scenes();
    for (int k = 0; k < 60; ++k) {
        static struct rod r;
        draw(&r, 2 + (size_t)k % 25, k % 4 ? PI : 1e-9, &seed);
        if (k % 5 == 0) r.angle[1] = k % 2 ? PI : -PI, lay_out(&r);
        const double bend = pow(10, 5 * random_number(&seed)), v[2] = {k % 3 ? 0.0 : 2.0, k % 3 ? 0.0 : -1.0};
        double x[MOST + 1][2], elastic, worst = 0;
        cd_chain* chain = make(&r, bend);
        ok(cd_chain_set_lambda(chain, k % 2 ? 0.5 : 1));
        for (size_t i = 0; i <= r.links; ++i) ok(cd_chain_write_f64(chain, CD_VELOCITY, 0, 1, i, 1, v, 2));
        ok(cd_chain_get_energy(chain, NULL, &elastic, NULL));
        ok(cd_chain_step(chain, 0.1, 20));
        read_positions(chain, &r, x);
        for (size_t i = 0; i <= r.links; ++i)
            for (int j = 0; j < 2; ++j) worst = fmax(worst, fabs(x[i][j] - r.x[i][j] - 2 * v[j]));
        if (!(worst < 1e-8 && elastic < 1e-25 * bend * pow((double)r.links, 3)))
            fail_msg("rod %d of %zu links, bend %g: moved by %g, energy %g", k, r.links, bend, worst, elastic);
        cd_chain_destroy(chain);
    }
}

/* A free one that tumbles and vibrates, at lambda = 1/2. */
static void a_free_curl_keeps_momentum_spin_and_energy(void** state) {
    (void)state;
    static struct rod r;
    uint64_t seed = 7;
    r.links = 32;
    for (size_t i = 0; i < r.links; ++i) r.length[i] = 1.0 / 32, r.angle[i] = 0.2;
    lay_out(&r);
    cd_chain* chain = make(&r, 0.3);
    ok(cd_chain_set_tolerance(chain, 1e-12, 200));
    for (size_t i = 0; i <= r.links; ++i) {
        const double v[2] = {0.3 - 4 * r.x[i][1], 4 * r.x[i][0] + 0.1 * random_number(&seed)};
        ok(cd_chain_write_f64(chain, CD_VELOCITY, 0, 1, i, 1, v, 2));
    }
    ok(cd_chain_step(chain, 1e-3, 1)); /* the links' ends now move as rigid links let them */
    double p[2][2], spin[2] = {0, 0}, energy[2];
    for (int when = 0; when < 2; ++when) {
        double x[MOST + 1][2], v[MOST + 1][2], kinetic, elastic;
        for (int i = 0; i < 1000 && when; ++i) ok(cd_chain_step(chain, 1e-3, 1));
        ok(cd_chain_get_momentum(chain, p[when], 2));
        ok(cd_chain_get_energy(chain, &kinetic, &elastic, NULL));
        energy[when] = kinetic + elastic;
        read_positions(chain, &r, x);
        ok(cd_chain_read_f64(chain, CD_VELOCITY, 0, 1, 0, r.links + 1, v[0], 2 * (r.links + 1)));
        for (size_t i = 0; i <= r.links; ++i) spin[when] += (x[i][0] * v[i][1] - x[i][1] * v[i][0]) / 33;
    }
    print_message("energy %.9f of its start, spin off by %.1e\n", energy[1] / energy[0], spin[1] - spin[0]);
    for (int k = 0; k < 2; ++k) assert_true(fabs(p[1][k] - p[0][k]) < 1e-12);
    assert_true(fabs(spin[1] - spin[0]) < 1e-9);
    assert_true(energy[1] <= energy[0] * (1 + 1e-9) && energy[1] > 0.99 * energy[0]);
    cd_chain_destroy(chain);
}

/* Of a rod that has moved nowhere yet only bends pull, by the slope of the energy; also at the smallest of angles. */
static void it_pulls_by_the_slope_of_its_energy(void** state) {
    (void)state;
    uint64_t seed = 21 + other_scenes();
    for (int k = 0; k < 40; ++k) {
        static struct rod r;
        const double size = pow(10, -(double)(k % 8)); /* the energy is a square: a slope is right at any step */
        draw(&r, 2 + (size_t)k % 6, size, &seed);
        for (size_t i = 0; i <= r.links; ++i)
            for (int j = 0; j < 2; ++j) r.x[i][j] += size * 0.1 * random_number(&seed);
        cd_chain* chain = make(&r, 1);
        const double step = 0.1 * size;
        double largest = 0;
        for (size_t node = 0; node <= r.links; ++node)
            for (int j = 0; j < 2; ++j) {
                double energy[2], force[2];
                ok(cd_chain_get_reaction(chain, 0, node, force, 2));
                largest = fmax(largest, fabs(force[j]));
                for (int way = 0; way < 2; ++way) {
                    double x[2] = {r.x[node][0], r.x[node][1]};
                    x[j] += way ? step : -step;
                    ok(cd_chain_write_f64(chain, CD_POSITION, 0, 1, node, 1, x, 2));
                    ok(cd_chain_get_energy(chain, NULL, &energy[way], NULL));
                }
                ok(cd_chain_write_f64(chain, CD_POSITION, 0, 1, node, 1, r.x[node], 2));
                const double slope = (energy[0] - energy[1]) / (2 * step);
                if (!(fabs(slope - force[j]) < 1e-5 * largest + 1e-4 * fabs(slope)))
                    fail_msg("rod %d, node %zu: pulls by %g, slope %g", k, node, force[j], slope);
            }
        assert_true(largest > 0);
        cd_chain_destroy(chain);
    }
}

/* Strands that are stepped one after the other have the same memory, which holds infinite numbers where springs are cut:
 * a curl beside some in pieces moves as it does alone, to the bit, however many links there are. */
static void what_others_leave_behind_changes_no_curl(void** state) {
    (void)state;
    enum { STRANDS = 5, STEPS = 2 };
    for (size_t links = 2; links <= 48; ++links)
        for (cd_kernels kernels = 0; kernels <= CD_KERNELS_AVX512; ++kernels) {
            double moved[2][2 * MOST];
            if (!(cd_runnable_kernels() >> kernels & 1)) continue;
            for (int alone = 0; alone < 2; ++alone) {
                const size_t strands = alone ? 1 : STRANDS;
                const double gravity[2] = {0, -9.81}, cut[MOST] = {0};
                cd_chain* chain = NULL;
                ok(cd_chain_create(strands, links, 2, CD_FLOAT64, NULL, &chain));
                ok(cd_chain_set_kernels(chain, kernels));
                ok(cd_chain_set_rest_length(chain, 1));
                ok(cd_chain_set_stiffness(chain, 1000));
                ok(cd_chain_set_bend(chain, 1e-3));
                ok(cd_chain_set_rest_angle(chain, 1));
                ok(cd_chain_set_gravity(chain, gravity, 2));
                ok(cd_chain_enable_field(chain, CD_STIFFNESS));
                for (size_t s = 0; s < strands; ++s) {
                    for (size_t i = 0; i <= links; ++i) {
                        const double x[2] = {(double)i / (double)links, 0};
                        ok(cd_chain_write_f64(chain, CD_POSITION, s, 1, i, 1, x, 2));
                    }
                    if (s + 1 < strands) ok(cd_chain_write_f64(chain, CD_STIFFNESS, s, 1, 0, links, cut, links));
                }
                ok(cd_chain_set_end(chain, CD_END_FIRST, CD_NODE_PINNED));
                ok(cd_chain_step(chain, 1.0 / 60, STEPS));
                ok(cd_chain_read_f64(chain, CD_VELOCITY, strands - 1, 1, 0, links + 1, moved[alone], 2 * (links + 1)));
                cd_chain_destroy(chain);
            }
            assert_same_bits(moved[0], moved[1], 2 * (links + 1));
        }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_curved_beam_yields_to_second_order),
        cmocka_unit_test(a_rod_takes_the_shape_of_its_angles),
        cmocka_unit_test(what_is_in_its_shape_rests),
        cmocka_unit_test(a_free_curl_keeps_momentum_spin_and_energy),
        cmocka_unit_test(it_pulls_by_the_slope_of_its_energy),
        cmocka_unit_test(what_others_leave_behind_changes_no_curl),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
