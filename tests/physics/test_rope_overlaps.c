/* What ropes do that lie inside of colliders: on the axis of one, in several at once, and where no step can be solved. */
#include <math.h>
#include <string.h>

#include "check.h"
#include "reference.h"

static cd_chain* rope(size_t strands, size_t springs, size_t components, double lambda, size_t colliders) {
    cd_chain* c = NULL;
    ok(cd_chain_create(strands, springs, components, CD_FLOAT64, NULL, &c));
    ok(cd_chain_set_rest_length(c, 1));
    ok(cd_chain_set_stiffness(c, INFINITY));
    ok(cd_chain_set_lambda(c, lambda));
    ok(cd_chain_set_colliders(c, colliders));
    return c;
}

/* Ropes that lie along the axes of capsules leave them across, by the shortest way, and go nowhere along them. */
static void what_lies_on_an_axis_comes_out_across(void** state) {
    (void)state;
    static const double ways[][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0.6, 0.8, 0}, {0, -0.6, 0.8}, {-0.8, 0, 0.6}};
    enum { NODES = 11 };
    for (size_t n = 0; n < 9; ++n) {
        const double* const way = ways[n < 6 ? n : n - 6 + (n == 8)]; /* in the plane 0, 1 and 3 */
        const size_t components = n < 6 ? 3 : 2;
        double x[NODES * 3], first[3], last[3];
        cd_chain* c = rope(1, NODES - 1, components, 0.5, 1);
        for (size_t k = 0; k < components; ++k) {
            first[k] = -3 * way[k], last[k] = 5 * way[k];
            for (size_t i = 0; i < NODES; ++i) x[i * components + k] = (double)i / (NODES - 1) * way[k];
        }
        ok(cd_chain_write_f64(c, CD_POSITION, 0, 1, 0, NODES, x, components * NODES));
        ok(cd_chain_set_capsule(c, 0, first, last, components, 0.3, 0));
        ok(cd_chain_step(c, 1 / 60.0, 1));
        ok(cd_chain_read_f64(c, CD_POSITION, 0, 1, 0, NODES, x, components * NODES));
        for (size_t i = 0; i < NODES; ++i) {
            double along = 0, square = 0;
            for (size_t k = 0; k < components; ++k) along += way[k] * x[i * components + k];
            for (size_t k = 0; k < components; ++k) square += pow(x[i * components + k] - along * way[k], 2);
            assert_near(along, (double)i / (NODES - 1), 1e-6, 1);
            assert_near(sqrt(square), 0.3, 1e-6, 1);
        }
        cd_chain_destroy(c);
    }
}

/* Two or three planes that a rope lies inside of, which slides along all of them: it comes out and slides on as fast. The
 * planes lean to both sides by as much as the tangent `lean`: they are one plane, or the walls of a gutter. Further aside,
 * where they are steep, it lies in one wall only, and meets the other on its way out. */
static void what_leaves_several_colliders_leaves_them_together(void** state) {
    (void)state;
    static const double leans[] = {0, 0.1, 0.5, 1, 3, 0.003, 0.01, 0.03}, point[3] = {0, 0, 0};
    enum { NODES = 11, LEANS = (int)COUNT(leans) };
    for (int n = 0; n < 8 * LEANS; ++n) {
        const double lean = leans[n / 4 % LEANS], speed = 10, apart = n < 4 * LEANS ? 1 : 2; /* 2: none level between */
        const size_t planes = n % 2 ? 3 : 2;
        cd_chain* c = rope(1, NODES - 1, 3, n / 2 % 2 ? 0.5 : 1, planes);
        double x[NODES][3], v[NODES][3];
        for (size_t k = 0; k < planes; ++k) {
            const double normal[3] = {lean * (1 - apart * (double)k), 1, 0};
            ok(cd_chain_set_plane(c, k, point, normal, 3, 0));
        }
        for (int i = 0; i < NODES; ++i) {
            x[i][0] = v[i][0] = v[i][1] = 0, x[i][1] = -0.1, x[i][2] = i / (NODES - 1.0), v[i][2] = speed;
            if (planes == 2) x[i][0] = -0.01 * apart * lean; /* not by one way */
        }
        ok(cd_chain_write_f64(c, CD_POSITION, 0, 1, 0, NODES, x[0], 3 * NODES));
        ok(cd_chain_write_f64(c, CD_VELOCITY, 0, 1, 0, NODES, v[0], 3 * NODES));
        ok(cd_chain_step(c, 1 / 60.0, 1));
        ok(cd_chain_read_f64(c, CD_POSITION, 0, 1, 0, NODES, x[0], 3 * NODES));
        ok(cd_chain_read_f64(c, CD_VELOCITY, 0, 1, 0, NODES, v[0], 3 * NODES));
        for (int i = 0; i < NODES; ++i) {
            assert_true(x[i][1] > -1e-6 && fabs(x[i][0]) * lean < x[i][1] + 1e-6);
            assert_near(v[i][2], speed, 1e-3, 1);
            assert_true(hypot(v[i][0], v[i][1]) < 1e-3 * 0.1 * 60);
        }
        cd_chain_destroy(c);
    }
}

/* Nodes at rest below two to five planes at random, steep or nearly level: they come out by the shortest way, onto one
 * plane, an edge or a corner, and are at rest again, while another one goes on above. */
static void what_leaves_an_edge_or_a_corner_is_at_rest(void** state) {
    (void)state;
    enum { NODES = 3, MOST_PLANES = 5, SCENES = 1000 };
    double fastest = 0;
    size_t short_of_it = 0;
    for (uint64_t scene = 0; scene < SCENES; ++scene) {
        uint64_t seed = 31 * scene + other_scenes();
        const size_t planes = 2 + scene % (MOST_PLANES - 1);
        const double lean = pow(10, -0.75 + 0.75 * random_number(&seed));
        double x[NODES][3] = {{0}}, v[NODES][3] = {{0}};
        cd_chain* c = rope(1, NODES - 1, 3, 1, planes);
        for (size_t k = 0; k < planes; ++k) {
            double point[3], normal[3];
            for (int i = 0; i < 3; ++i)
                normal[i] = i == 1 ? 1 : lean * random_number(&seed), point[i] = 0.02 * lean * random_number(&seed);
            ok(cd_chain_set_plane(c, k, point, normal, 3, 0));
        }
        for (int i = 0; i < NODES; ++i)
            for (int k = 0; k < 3; ++k) x[i][k] = k == 1 ? -0.1 : 0.03 * lean * random_number(&seed);
        x[NODES - 1][1] = 0.35, v[NODES - 1][0] = 0.3;
        ok(cd_chain_write_f64(c, CD_POSITION, 0, 1, 0, NODES, x[0], 3 * NODES));
        ok(cd_chain_write_f64(c, CD_VELOCITY, 0, 1, 0, NODES, v[0], 3 * NODES));
        const cd_status status = cd_chain_step(c, 1 / 60.0, 1);
        assert_true(status == CD_OK || status == CD_ERROR_TOLERANCE);
        short_of_it += status != CD_OK;
        ok(cd_chain_read_f64(c, CD_VELOCITY, 0, 1, 0, NODES, v[0], 3 * NODES));
        for (int k = 0; k < 3 * (NODES - 1) && status == CD_OK; ++k) fastest = fmax(fastest, fabs(v[k / 3][k % 3]));
        cd_chain_destroy(c);
    }
    print_message("%zu of %d steps ended short, others leave at most %.1e m/s\n", short_of_it, SCENES, fastest);
    assert_true(short_of_it < SCENES / 20);
    assert_true(fastest < 6e-3);
}

/* Between two or three walls that overlap by less than two tolerances a rope rests in all of them, in tolerance. */
static void what_lies_between_walls_stays_there(void** state) {
    (void)state;
    enum { NODES = 5 };
    static const double gravity[] = {0, -9.81, 0};
    static const double outward[][3][3] = {
        {{0, 1, 0}, {0, -1, 0}}, {{0, 1, 0}, {1e-5, -1, 0}}, {{0, 1, 0}, {0.75, -0.5, 0}, {-0.75, -0.5, 0}}};
    for (size_t way = 0; way < COUNT(outward); ++way) {
        const double tolerance = 1e-6, deep = 0.75 * tolerance / (NODES - 1);
        double x[NODES][3] = {{0}}, v[NODES][3];
        cd_chain* c = rope(1, NODES - 1, 3, 1, way < 2 ? 2 : 3);
        ok(cd_chain_set_tolerance(c, tolerance, 200));
        ok(cd_chain_set_gravity(c, gravity, 3));
        for (size_t k = 0; k < (way < 2 ? 2 : 3); ++k) {
            const double* const out = outward[way][k];
            const double point[3] = {deep * out[0], deep * out[1], 0};
            ok(cd_chain_set_plane(c, k, point, out, 3, 0));
        }
        for (int i = 0; i < NODES; ++i) x[i][2] = i / (NODES - 1.0);
        ok(cd_chain_write_f64(c, CD_POSITION, 0, 1, 0, NODES, x[0], 3 * NODES));
        ok(cd_chain_step(c, 1 / 60.0, 60));
        ok(cd_chain_read_f64(c, CD_VELOCITY, 0, 1, 0, NODES, v[0], 3 * NODES));
        for (int i = 0; i < 3 * NODES; ++i) assert_true(fabs(v[i / 3][i % 3]) < 1e-3);
        cd_chain_destroy(c);
    }
}

/* Heavy and light nodes among bodies that leave them no room, in steps that few iterations are for: most end short. */
enum { STRANDS = 8, LINKS = 5, MOST = 2 * (LINKS + 1), SCENES = 120, STEPS = 12 };
static const double pull = -9.81;
static cd_chain* crowd(size_t strands, size_t components, uint64_t seed) {
    const double lambda = 0.75 + 0.25 * random_number(&seed), gravity[2] = {pull, 0};
    cd_chain* c = rope(strands, LINKS, components, lambda, 4);
    for (size_t k = 0; k < 4; ++k) {
        double a[2], b[2];
        for (int i = 0; i < 2; ++i) a[i] = random_number(&seed), b[i] = random_number(&seed);
        if (k < 2) ok(cd_chain_set_capsule(c, k, a, b, components, 0.2, 0.3));
        else ok(cd_chain_set_plane(c, k, a, b, components, 0.5));
    }
    ok(cd_chain_set_gravity(c, gravity, components));
    ok(cd_chain_set_tolerance(c, 1e-6, seed % 4 ? 200 : 3));
    ok(cd_chain_enable_field(c, CD_MASS));
    return c;
}
static void place(cd_chain* c, size_t strand, size_t components, int tied, uint64_t seed) {
    double x[MOST] = {0}, v[MOST], mass[LINKS + 1];
    for (size_t i = 0; i <= LINKS; ++i) {
        const double angle = components > 1 ? 3 * random_number(&seed) : 0, way[2] = {cos(angle), sin(angle)};
        for (size_t k = 0; k < components; ++k) {
            const size_t at = i * components + k;
            if (i > 0) x[at] = x[at - components] + way[k] / LINKS;
            v[at] = random_number(&seed);
        }
        mass[i] = pow(10, random_number(&seed));
    }
    ok(cd_chain_write_f64(c, CD_POSITION, strand, 1, 0, LINKS + 1, x, components * (LINKS + 1)));
    ok(cd_chain_write_f64(c, CD_VELOCITY, strand, 1, 0, LINKS + 1, v, components * (LINKS + 1)));
    ok(cd_chain_write_f64(c, CD_MASS, strand, 1, 0, LINKS + 1, mass, LINKS + 1));
    if (tied) ok(cd_chain_attach(c, strand, 2, 1e4, 0, NULL, 0));
}
/* Twice the kinetic energy of a strand, and what its nodes would have alone after a step of dt more. */
static double kinetic_of(const cd_chain* c, size_t components, double dt) {
    double v[MOST], mass[LINKS + 1], sum = 0;
    ok(cd_chain_read_f64(c, CD_VELOCITY, 0, 1, 0, LINKS + 1, v, components * (LINKS + 1)));
    ok(cd_chain_read_f64(c, CD_MASS, 0, 1, 0, LINKS + 1, mass, LINKS + 1));
    for (size_t i = 0; i <= LINKS; ++i)
        for (size_t k = 0; k < components; ++k)
            sum += mass[i] * pow(v[i * components + k] + (k == 0 ? dt * pull : 0), 2);
    return sum;
}

/* What the failed step's last iteration pushed by is no number at times: no strand feels that of others, and none has
 * more energy than its nodes alone. */
static void a_failed_step_leaves_nothing_of_its_pushes(void** state) {
    (void)state;
    size_t failed = 0, made = 0;
    for (uint64_t scene = 0; scene < SCENES; ++scene) {
        const uint64_t seed = 100 * scene + other_scenes();
        const size_t components = 1 + scene % 2, count = components * (LINKS + 1);
        const int tied = scene / 2 % 2; /* then more moves a node than its weight */
        const double dt = 1 / 60.0;
        cd_chain *together = crowd(STRANDS, components, seed), *alone[STRANDS];
        for (size_t s = 0; s < STRANDS; ++s) {
            alone[s] = crowd(1, components, seed);
            place(together, s, components, tied, seed + s + 1);
            place(alone[s], 0, components, tied, seed + s + 1);
        }
        for (int step = 0; step < STEPS; ++step) {
            const cd_status status = cd_chain_step(together, dt, 1);
            assert_true(status == CD_OK || status == CD_ERROR_TOLERANCE);
            for (size_t s = 0; s < STRANDS; ++s) {
                const double most = kinetic_of(alone[s], components, dt);
                const int solved = cd_chain_step(alone[s], dt, 1) == CD_OK;
                ++made, failed += !solved;
                if (!solved && !tied) assert_true(kinetic_of(alone[s], components, 0) <= most * (1 + 1e-9));
                for (cd_field field = CD_POSITION; field <= CD_VELOCITY; ++field) {
                    double a[MOST], b[MOST];
                    ok(cd_chain_read_f64(together, field, s, 1, 0, LINKS + 1, a, count));
                    ok(cd_chain_read_f64(alone[s], field, 0, 1, 0, LINKS + 1, b, count));
                    assert_memory_equal(a, b, count * sizeof *a);
                }
            }
        }
        cd_chain_destroy(together);
        for (size_t s = 0; s < STRANDS; ++s) cd_chain_destroy(alone[s]);
    }
    print_message("%zu of %zu steps ended short\n", failed, made);
    assert_true(failed > made / 100);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_lies_on_an_axis_comes_out_across),
        cmocka_unit_test(what_leaves_several_colliders_leaves_them_together),
        cmocka_unit_test(what_leaves_an_edge_or_a_corner_is_at_rest),
        cmocka_unit_test(what_lies_between_walls_stays_there),
        cmocka_unit_test(a_failed_step_leaves_nothing_of_its_pushes),
    };
    return cmocka_run_group_tests_name("rope overlaps", tests, NULL, NULL);
}
