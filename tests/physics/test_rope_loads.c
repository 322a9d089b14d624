/* What ropes do to what they touch: Newton's third law, and what must bear a rope at rest. */
#include <math.h>
#include <string.h>

#include "check.h"
#include "loads.h"

enum { MOST = 9 * 24, COLLIDERS = 5 };

static void cross(const double* a, const double* b, double* out) {
    for (int k = 0; k < 3; ++k) out[k] = a[(k + 1) % 3] * b[(k + 2) % 3] - a[(k + 2) % 3] * b[(k + 1) % 3];
}
static void get_load(const cd_chain* chain, size_t index, double* out) {
    ok(cd_chain_get_collider_load(chain, index, out, 6));
}

/* The loads of all colliders together. */
static void get_sum(const cd_chain* chain, double* out) {
    size_t count;
    ok(cd_chain_get_colliders(chain, &count));
    memset(out, 0, 6 * sizeof *out);
    for (size_t i = 0; i < count; ++i) {
        double one[6];
        get_load(chain, i, one);
        add_load(out, one);
    }
}

/* ---- Newton's third law in random scenes -------------------------------------------------------------------------- */

static double ball_radius = 0.3;

struct scene {
    cd_chain* chain;
    size_t strands, nodes, components;
    double gravity[3];
    double x[MOST][3], v[MOST][3], mass[MOST];
};
static void read_state(struct scene* s) {
    const size_t all = s->strands * s->nodes, n = s->components;
    double x[MOST * 3], v[MOST * 3];
    ok(cd_chain_read_f64(s->chain, CD_POSITION, 0, s->strands, 0, s->nodes, x, all * n));
    ok(cd_chain_read_f64(s->chain, CD_VELOCITY, 0, s->strands, 0, s->nodes, v, all * n));
    for (size_t i = 0; i < all; ++i)
        for (size_t k = 0; k < 3; ++k) s->x[i][k] = k < n ? x[i * n + k] : 0, s->v[i][k] = k < n ? v[i * n + k] : 0;
}

/* Ropes or rods of every kind above bodies of every kind, in the air. The last component is up. */
static void build(struct scene* s, uint64_t seed, cd_precision precision, int held) {
    uint64_t draw = seed * 7919 + 1;
    const size_t n = s->components = 2 + seed % 2, up = n - 1;
    s->strands = 1 + (size_t)(9 * part(&draw)), s->nodes = 3 + (size_t)(21 * part(&draw));
    cd_chain* c;
    ok(cd_chain_create(s->strands, s->nodes - 1, n, precision, NULL, &c));
    s->chain = c;
    const double length = 0.5 + part(&draw);
    ok(cd_chain_set_rest_length(c, length));
    ok(cd_chain_set_stiffness(c, part(&draw) < 0.5 ? INFINITY : 1e3));
    if (part(&draw) < 0.3) ok(cd_chain_set_bend(c, 0.1 * part(&draw)));
    const double lambdas[] = {0.5, 0.5, 0.7, 1};
    const double lambda = lambdas[(int)(4 * part(&draw))];
    ok(cd_chain_set_lambda(c, held ? 1 : lambda)); /* with less, tensions miss some of what they do */
    ok(cd_chain_set_tolerance(c, precision == CD_FLOAT64 ? 1e-9 : 1e-6, 2000));
    memset(s->gravity, 0, sizeof s->gravity);
    s->gravity[up] = -9.81;
    ok(cd_chain_set_gravity(c, s->gravity, n));
    ok(cd_chain_enable_field(c, CD_MASS));
    const size_t all = s->strands * s->nodes;
    for (size_t i = 0; i < all; ++i) s->mass[i] = 0.01 + 0.05 * part(&draw);
    ok(cd_chain_write_f64(c, CD_MASS, 0, s->strands, 0, s->nodes, s->mass, all));
    double x[MOST * 3], v[MOST * 3];
    for (size_t strand = 0; strand < s->strands; ++strand) {
        double at[3] = {part(&draw) - 0.5, part(&draw) - 0.5, 0}, way[3] = {0};
        at[up] = 0.3 + 0.3 * part(&draw);
        for (size_t i = 0; i < s->nodes; ++i)
            for (size_t k = 0; k < n; ++k) {
                const size_t to = (strand * s->nodes + i) * n + k;
                if (k == 0)
                    for (size_t j = 0; j < n; ++j) way[j] = (j == 0) + 0.6 * (part(&draw) - 0.5);
                x[to] = at[k];
                at[k] += way[k] / size_of(way) * length / (double)(s->nodes - 1);
                v[to] = 2 * (part(&draw) - 0.5);
            }
    }
    ok(cd_chain_write_f64(c, CD_POSITION, 0, s->strands, 0, s->nodes, x, all * n));
    ok(cd_chain_write_f64(c, CD_VELOCITY, 0, s->strands, 0, s->nodes, v, all * n));
    if (held) ok(cd_chain_set_end(c, CD_END_FIRST, CD_NODE_PINNED));
    ok(cd_chain_set_loads(c, 1));
    ok(cd_chain_set_colliders(c, COLLIDERS)); /* number 3 stays none */
    const double nowhere[3] = {0}, friction = part(&draw) < 0.7 ? part(&draw) : 0;
    double normal[3] = {0.2 * (part(&draw) - 0.5), 0, 0}, a[3] = {-0.2, 0, 0}, b[3] = {0.4, 0, 0};
    normal[up] = 1;
    ok(cd_chain_set_plane(c, 0, nowhere, normal, n, friction));
    b[1] = part(&draw) - 0.5;
    if (n == 2) b[1] = -fabs(b[1]); /* no rope lies across it, whose nodes would leave it on both sides */
    ok(cd_chain_set_capsule(c, 1, a, b, n, 0.1 + 0.2 * part(&draw), friction));
    double velocity[3] = {part(&draw) - 0.5, part(&draw) - 0.5, 0};
    if (part(&draw) < 0.5) ok(cd_chain_set_collider_velocity(c, 1, velocity, n));
    const double origin[3] = {0.7, 0, 0};
    ok(cd_chain_set_callback(c, 2, &(cd_distance){&ball_radius, ball}, origin, n, friction));
    double heights[36];
    for (int i = 0; i < 36; ++i) heights[i] = 0.2 * part(&draw);
    const double corner[3] = {-0.6, n == 3 ? -0.6 : -0.1, -0.1};
    ok(cd_chain_set_bed(c, 4, corner, n, 6, n == 3 ? 6 : 1, 0.25, 0.25, heights, n == 3 ? 36 : 6, 0.3));
    ok(cd_chain_set_thickness(c, 0.01));
}

/* How many steps were made, how many of these touched something or were not solved, and the largest error of momentum,
 * over what was given. */
struct tally {
    size_t steps, touched, unsolved;
    double worst;
};
static void check_scene(uint64_t seed, cd_precision precision, int held, double error, struct tally* t) {
    struct scene s, after;
    build(&s, seed, precision, held);
    const double dt = seed % 3 ? 1.0 / 60 : 1.0 / 200;
    for (int i = 0; i < 60; ++i) {
        double load[6], gains[3], given = 0;
        read_state(&s);
        const cd_status status = cd_chain_step(s.chain, dt, 1);
        ++t->steps;
        if (status == CD_ERROR_TOLERANCE) {
            ++t->unsolved;
            get_sum(s.chain, load);
            for (int k = 0; k < 6 && s.strands == 1; ++k) assert_true(load[k] == 0);
            continue;
        }
        ok(status);
        get_sum(s.chain, load);
        after = s;
        read_state(&after);
        for (int k = 0; k < 3; ++k) gains[k] = dt * load[k];
        for (size_t node = 0; node < s.strands * s.nodes; ++node) {
            if (held && node % s.nodes == 0) {
                double force[3] = {0};
                ok(cd_chain_get_reaction(s.chain, node / s.nodes, 0, force, s.components));
                for (int k = 0; k < 3; ++k) gains[k] += dt * force[k];
                given += dt * size_of(force);
                continue;
            }
            for (int k = 0; k < 3; ++k)
                gains[k] += s.mass[node] * (after.v[node][k] - s.v[node][k] - dt * s.gravity[k]);
            given += s.mass[node] * (size_of(after.v[node]) + size_of(s.v[node]) + dt * 9.81);
        }
        t->touched += size_of(load) > 0;
        t->worst = fmax(t->worst, size_of(gains) / given);
        if (!(size_of(gains) <= error * given))
            print_message("seed %llu, step %d: %g of %g\n", (unsigned long long)seed, i, size_of(gains), given);
        assert_near(size_of(gains), 0, error, given);
        double none[6];
        get_load(s.chain, 3, none);
        for (int k = 0; k < 6; ++k) assert_true(none[k] == 0);
    }
    cd_chain_destroy(s.chain);
}
static void what_ropes_gain_colliders_lose(void** state) {
    (void)state;
    struct tally wide = {0}, narrow = {0}, held = {0};
    const uint64_t most = is_long() ? 1000 : 100;
    for (uint64_t seed = other_scenes(); seed < other_scenes() + most; ++seed) {
        check_scene(seed, CD_FLOAT64, 0, 1e-10, &wide);
        check_scene(seed, CD_FLOAT32, 0, 1e-6, &narrow);
        check_scene(seed, CD_FLOAT64, 1, 1e-6, &held);
    }
    assert_true(wide.touched > wide.steps / 2 && wide.unsolved < wide.steps / 50);
}

/* A rope of fixed length lies across a body, which its nodes would leave on both sides: no step is solved, and none tells
 * a load. */
static void what_a_body_tears_apart_tells_no_load(void** state) {
    (void)state;
    const double first[2] = {-1, 0.01}, last[2] = {1, 0.01}; /* the rope goes from below to above it */
    for (int far = 0; far < 2; ++far) {
        double load[6], x[2 * 12];
        cd_chain* c;
        ok(cd_chain_create(1, 11, 2, CD_FLOAT64, NULL, &c));
        ok(cd_chain_set_rest_length(c, 1));
        ok(cd_chain_set_stiffness(c, INFINITY));
        for (int i = 0; i < 12; ++i) x[2 * i] = far ? 3 : 0, x[2 * i + 1] = i / 11.0 - 0.5;
        ok(cd_chain_write_f64(c, CD_POSITION, 0, 1, 0, 12, x, 24));
        ok(cd_chain_set_loads(c, 1));
        ok(cd_chain_set_colliders(c, 1));
        ok(cd_chain_set_capsule(c, 0, first, last, 2, 0.3, 0.5));
        for (int step = 0; step < 5; ++step) {
            assert_int_equal(cd_chain_step(c, 1.0 / 60, 1), far ? CD_OK : CD_ERROR_TOLERANCE);
            get_load(c, 0, load);
            for (int k = 0; k < 6; ++k) assert_true(load[k] == 0);
        }
        cd_chain_destroy(c);
    }
}

/* ---- ropes at rest ------------------------------------------------------------------------------------------------ */

static const double nowhere[3] = {0}, weight[3] = {0, 0, -9.81};

/* Some strands of 0.5 kg and 1 m side by side, level at this height. */
static cd_chain* level(size_t strands, size_t nodes, cd_precision precision, double height) {
    cd_chain* c;
    double x[MOST * 3];
    ok(cd_chain_create(strands, nodes - 1, 3, precision, NULL, &c));
    ok(cd_chain_set_rest_length(c, 1));
    ok(cd_chain_set_stiffness(c, INFINITY));
    ok(cd_chain_set_mass(c, 0.5));
    ok(cd_chain_set_gravity(c, weight, 3));
    for (size_t i = 0; i < strands * nodes; ++i)
        x[3 * i] = (double)(i % nodes) / (double)(nodes - 1), x[3 * i + 1] = 0.1 * (double)(i / nodes),
              x[3 * i + 2] = height;
    ok(cd_chain_write_f64(c, CD_POSITION, 0, strands, 0, nodes, x, 3 * strands * nodes));
    ok(cd_chain_set_loads(c, 1));
    return c;
}
/* The moment of the weight of all nodes, which weigh the same. */
static void moment_of_weight(const cd_chain* c, size_t strands, size_t nodes, double* out) {
    double x[MOST * 3], middle[3] = {0}, force[3];
    ok(cd_chain_read_f64(c, CD_POSITION, 0, strands, 0, nodes, x, 3 * strands * nodes));
    for (size_t i = 0; i < 3 * strands * nodes; ++i) middle[i % 3] += x[i] / (double)(strands * nodes);
    for (int k = 0; k < 3; ++k) force[k] = 0.5 * (double)strands * weight[k];
    cross(middle, force, out);
}

static void what_rests_bears_with_its_weight(void** state) {
    (void)state;
    for (int precision = CD_FLOAT32; precision <= CD_FLOAT64; ++precision)
        for (size_t strands = 1; strands <= 9; strands += 4)
            for (int slope = 0; slope <= 1; ++slope) {
                const double normal[3] = {slope ? 0.3 : 0, 0, 1}, start[3] = {1e3, 0, 0};
                cd_chain* const c = level(strands, 12, precision, 0.4);
                double load[6], moment[3];
                ok(cd_chain_set_colliders(c, 3));
                ok(cd_chain_set_thickness(c, 0.02));
                ok(cd_chain_set_plane(c, 2, nowhere, normal, 3, 0.9));
                ok(cd_chain_set_capsule(c, 0, start, start, 3, 1, 0)); /* far away */
                ok(cd_chain_step(c, 1.0 / 60, 600));
                get_load(c, 2, load);
                moment_of_weight(c, strands, 12, moment);
                const double force = 0.5 * 9.81 * (double)strands, error = precision == CD_FLOAT64 ? 1e-9 : 1e-5;
                for (int k = 0; k < 3; ++k) {
                    assert_near(load[k], k == 2 ? -force : 0, error, force);
                    assert_near(load[3 + k], moment[k], error, force);
                }
                get_load(c, 0, load);
                for (int k = 0; k < 6; ++k) assert_true(load[k] == 0);
                cd_chain_destroy(c);
            }
}

/* A rope between two held ends over a rough peg: along it the tensions differ, and the peg bears both. */
static void a_peg_bears_both_tensions(void** state) {
    (void)state;
    enum { NODES = 41 };
    const double a[3] = {0, -1, 0}, b[3] = {0, 1, 0};
    cd_chain* c;
    double x[NODES][3], load[6], first[3], last[3], tension[NODES - 1];
    ok(cd_chain_create(1, NODES - 1, 3, CD_FLOAT64, NULL, &c));
    ok(cd_chain_set_rest_length(c, 2));
    ok(cd_chain_set_stiffness(c, 1e3));
    ok(cd_chain_set_mass(c, 1e-3));
    ok(cd_chain_set_drag(c, 5));
    ok(cd_chain_set_lambda(c, 1));
    ok(cd_chain_set_tolerance(c, 1e-11, 1000));
    ok(cd_chain_set_loads(c, 1));
    ok(cd_chain_set_colliders(c, 1));
    ok(cd_chain_set_capsule(c, 0, a, b, 3, 0.2, 0.4));
    for (int i = 0; i < NODES; ++i) {
        const double s = i / (NODES - 1.0) - 0.5; /* an arc that lies on the peg in its middle */
        x[i][0] = 1.6 * s, x[i][1] = 0, x[i][2] = 0.25 - 0.5 * fabs(s);
    }
    ok(cd_chain_write_f64(c, CD_POSITION, 0, 1, 0, NODES, x[0], 3 * NODES));
    ok(cd_chain_set_end(c, CD_END_FIRST, CD_NODE_DRIVEN));
    ok(cd_chain_set_end(c, CD_END_LAST, CD_NODE_DRIVEN));
    const double down[3] = {-0.2, 0, -0.4}, away[3] = {0.2, 0, -0.1}, still[3] = {0};
    ok(cd_chain_write_f64(c, CD_VELOCITY, 0, 1, 0, 1, down, 3));
    ok(cd_chain_write_f64(c, CD_VELOCITY, 0, 1, NODES - 1, 1, away, 3));
    ok(cd_chain_step(c, 1.0 / 240, 240));
    ok(cd_chain_write_f64(c, CD_VELOCITY, 0, 1, 0, 1, still, 3));
    ok(cd_chain_write_f64(c, CD_VELOCITY, 0, 1, NODES - 1, 1, still, 3));
    ok(cd_chain_step(c, 1.0 / 240, 2400));
    get_load(c, 0, load);
    ok(cd_chain_get_reaction(c, 0, 0, first, 3));
    ok(cd_chain_get_reaction(c, 0, NODES - 1, last, 3));
    ok(cd_chain_read_f64(c, CD_TENSION, 0, 1, 0, NODES - 1, tension, NODES - 1));
    assert_true(tension[0] > 1.1 * tension[NODES - 2] && tension[NODES - 2] > 10);
    for (int k = 0; k < 3; ++k) assert_near(load[k], -(first[k] + last[k]), 1e-6, tension[0]);
    /* About the peg's axis it is turned by their difference, at its radius. */
    ok(cd_chain_read_f64(c, CD_POSITION, 0, 1, 0, NODES, x[0], 3 * NODES));
    double of_first[3], of_last[3];
    cross(x[0], first, of_first), cross(x[NODES - 1], last, of_last);
    for (int k = 0; k < 3; ++k) assert_near(load[3 + k], -(of_first[k] + of_last[k]), 1e-6, tension[0]);
    assert_near(fabs(load[4]), 0.2 * (tension[0] - tension[NODES - 2]), 0.01, tension[0]);
    cd_chain_destroy(c);
}

/* What sleeps bears as before; loads are a part of the state, and go with it. */
static void what_sleeps_bears_on(void** state) {
    (void)state;
    const double up[3] = {0, 0, 1};
    unsigned char bytes[1 << 14];
    size_t size, awake;
    double load[6], told[6];
    cd_chain* const c = level(3, 8, CD_FLOAT64, 0.1);
    ok(cd_chain_set_colliders(c, 2));
    ok(cd_chain_set_plane(c, 1, nowhere, up, 3, 0.5));
    ok(cd_chain_set_sleep(c, 0.01, 0.5));
    ok(cd_chain_step(c, 1.0 / 60, 300));
    ok(cd_chain_get_awake(c, &awake));
    assert_true(awake == 0);
    get_load(c, 1, load);
    assert_near(load[2], -0.5 * 9.81 * 3, 1e-6, 1);
    ok(cd_chain_step(c, 1.0 / 60, 10));
    get_load(c, 1, told);
    assert_same_bits(told, load, 6);
    ok(cd_chain_save(c, bytes, sizeof bytes, &size));
    cd_chain *other, *copy;
    ok(cd_chain_create(3, 7, 3, CD_FLOAT64, NULL, &other));
    ok(cd_chain_create(3, 7, 3, CD_FLOAT64, NULL, &copy));
    ok(cd_chain_load(other, bytes, size));
    ok(cd_chain_copy_state(copy, c));
    for (int which = 0; which < 2; ++which) {
        cd_chain* const o = which ? copy : other;
        int32_t loads;
        ok(cd_chain_get_loads(o, &loads));
        assert_int_equal(loads, 1);
        ok(cd_chain_step(o, 1.0 / 60, 1));
        get_load(o, 1, told);
        assert_same_bits(told, load, 6);
        assert_true(hash_of(o) != 0);
    }
    /* One that hangs in the air from now on bears nothing, the others what they did. */
    const double higher[3] = {0, 0, 3};
    ok(cd_chain_teleport(c, 1, NULL, higher, 3));
    ok(cd_chain_step(c, 1.0 / 60, 1));
    get_load(c, 1, told);
    assert_near(told[2], load[2] * 2 / 3, 1e-6, 1);
    ok(cd_chain_reset(c));
    get_load(c, 1, told);
    for (int k = 0; k < 6; ++k) assert_true(told[k] == 0);
    cd_chain_destroy(c), cd_chain_destroy(other), cd_chain_destroy(copy);
}

/* What is noted changes nothing, and costs nothing where nobody asks. */
static void loads_change_no_step(void** state) {
    (void)state;
    for (uint64_t seed = 0; seed < 20; ++seed) {
        struct scene s, untold;
        build(&s, seed, seed % 3 ? CD_FLOAT64 : CD_FLOAT32, 0);
        build(&untold, seed, seed % 3 ? CD_FLOAT64 : CD_FLOAT32, 0);
        ok(cd_chain_set_loads(untold.chain, 0));
        cd_chain_step(s.chain, 1.0 / 60, 30);
        cd_chain_step(untold.chain, 1.0 / 60, 30);
        ok(cd_chain_set_loads(s.chain, 0));
        assert_true(hash_of(s.chain) == hash_of(untold.chain));
        cd_chain_destroy(s.chain), cd_chain_destroy(untold.chain);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_ropes_gain_colliders_lose),
        cmocka_unit_test(what_a_body_tears_apart_tells_no_load),
        cmocka_unit_test(what_rests_bears_with_its_weight),
        cmocka_unit_test(a_peg_bears_both_tensions),
        cmocka_unit_test(what_sleeps_bears_on),
        cmocka_unit_test(loads_change_no_step),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
