/* Cutting and welding springs while the chain moves. */
#include <math.h>
#include <stdlib.h>

#include "check.h"
#include "scene.h"

enum { STRANDS = 2, SPRINGS = 8, NODES = SPRINGS + 1, COMPONENTS = 2, ALL = STRANDS * NODES * COMPONENTS };

static const struct way {
    cd_method method;
    double lambda;
    int bends, ring;
} ways[] = {{CD_METHOD_IMPLICIT, 0.5, 0, 0},     {CD_METHOD_IMPLICIT, 1, 0, 0},
            {CD_METHOD_IMPLICIT, 0.75, 1, 0},    {CD_METHOD_IMPLICIT, 0.5, 0, 1},
            {CD_METHOD_IMPLICIT, 1, 1, 1},       {CD_METHOD_FORWARD_EULER, 0.5, 0, 0},
            {CD_METHOD_STIFF_SECOND, 0.5, 0, 0}, {CD_METHOD_SYMPLECTIC_EULER, 0.5, 1, 0},
            {CD_METHOD_STIFF_SECOND, 0.5, 1, 1}, {CD_METHOD_SYMPLECTIC_EULER, 0.5, 0, 1},
            {CD_METHOD_IMPLICIT, 0, 0, 0}};

static double at(const double* values, size_t strand, size_t node, size_t component) {
    return values[(strand * NODES + node) * COMPONENTS + component];
}

/* A free chain of different masses and springs in motion. */
static cd_chain* free_chain(const struct way* way, cd_precision precision) {
    cd_chain* chain = scene_chain(STRANDS, SPRINGS, COMPONENTS, precision);
    ok(cd_chain_set_ring(chain, way->ring));
    ok(cd_chain_set_method(chain, way->method));
    ok(cd_chain_set_lambda(chain, way->lambda));
    if (way->bends) ok(cd_chain_set_bend(chain, 1e-3));
    ok(cd_chain_enable_field(chain, CD_MASS));
    for (size_t i = 0; i < NODES; ++i) scene_set(chain, CD_MASS, i, 0.5 + 0.25 * (double)i);
    scene_lay_out(chain, 0.5);
    scene_shake(chain, 0.25, 17);
    return chain;
}

static void momentum_of(const cd_chain* chain, double* out_momentum) {
    ok(cd_chain_get_momentum(chain, out_momentum, COMPONENTS));
}

/* To a few roundings: they are taken out again in the next step, and never add up. */
static void assert_one_velocity(const cd_chain* chain, const size_t* nodes, size_t count) {
    double v[ALL];
    cd_precision precision;
    ok(cd_chain_get_shape(chain, NULL, NULL, NULL, &precision));
    const double rounding = precision == CD_FLOAT64 ? 1e-15 : 5e-7;
    scene_read(chain, CD_VELOCITY, v);
    for (size_t s = 0; s < STRANDS; ++s)
        for (size_t c = 0; c < COMPONENTS; ++c)
            for (size_t i = 1; i < count; ++i) assert_near(at(v, s, nodes[i], c), at(v, s, nodes[0], c), rounding, 1);
}

static void welded_nodes_share_the_mean_velocity_at_once(void** state) {
    (void)state;
    for (cd_precision precision = CD_FLOAT32; precision <= CD_FLOAT64; ++precision) {
        cd_chain* chain = free_chain(&ways[0], precision);
        double v[ALL], before[COMPONENTS], after[COMPONENTS], welded[ALL];
        const size_t pair[] = {3, 4};
        scene_read(chain, CD_VELOCITY, v);
        momentum_of(chain, before);
        ok(cd_chain_weld(chain, 0, 3));
        assert_true(isinf(scene_get(chain, CD_STIFFNESS, 3)));
        momentum_of(chain, after);
        scene_read(chain, CD_VELOCITY, welded);
        const double m3 = scene_get(chain, CD_MASS, 3), m4 = scene_get(chain, CD_MASS, 4);
        const double rounding = precision == CD_FLOAT64 ? 1e-15 : 1e-7;
        for (size_t s = 0; s < STRANDS; ++s)
            for (size_t c = 0; c < COMPONENTS; ++c)
                for (size_t node = 0; node < NODES; ++node) {
                    const double mean = (m3 * at(v, s, 3, c) + m4 * at(v, s, 4, c)) / (m3 + m4);
                    if (node == 3 || node == 4) assert_near(at(welded, s, node, c), mean, rounding, 0.1);
                    else assert_true(at(welded, s, node, c) == at(v, s, node, c));
                }
        assert_one_velocity(chain, pair, 2);
        for (size_t c = 0; c < COMPONENTS; ++c) assert_near(after[c], before[c], 4 * rounding, 1);
        cd_chain_destroy(chain);
    }
}

static void a_welded_pair_keeps_its_offset_and_the_chain_its_momentum(void** state) {
    (void)state;
    for (size_t w = 0; w < COUNT(ways); ++w) {
        for (cd_precision precision = CD_FLOAT32; precision <= CD_FLOAT64; ++precision) {
            cd_chain* chain = free_chain(&ways[w], precision);
            static const size_t pair[] = {2, 3}, run[] = {5, 6, 7};
            ok(cd_chain_weld(chain, 0, 2));
            ok(cd_chain_weld(chain, 0, 5));
            ok(cd_chain_weld(chain, 0, 6));
            double start[ALL], end[ALL], before[COMPONENTS], after[COMPONENTS];
            scene_read(chain, CD_POSITION, start);
            momentum_of(chain, before);
            const double dt = ways[w].method == CD_METHOD_FORWARD_EULER || ways[w].lambda == 0 ? 0.0005 : 0.01;
            for (int part = 0; part < 10; ++part) {
                ok(cd_chain_step(chain, dt, 100));
                assert_one_velocity(chain, pair, 2);
                assert_one_velocity(chain, run, 3);
            }
            scene_read(chain, CD_POSITION, end);
            momentum_of(chain, after);
            const double drift = precision == CD_FLOAT64 ? 1e-12 : 1e-3; /* 1000 roundings */
            for (size_t s = 0; s < STRANDS; ++s)
                for (size_t c = 0; c < COMPONENTS; ++c) {
                    assert_near(at(end, s, 3, c) - at(end, s, 2, c), at(start, s, 3, c) - at(start, s, 2, c), drift, 1);
                    assert_near(at(end, s, 7, c) - at(end, s, 5, c), at(start, s, 7, c) - at(start, s, 5, c), drift, 1);
                    assert_true(at(end, s, 0, c) != at(start, s, 0, c));
                }
            for (size_t c = 0; c < COMPONENTS; ++c) assert_near(after[c], before[c], drift, 1);
            cd_chain_destroy(chain);
        }
    }
}

static void a_chain_welded_all_along_moves_as_one_body(void** state) {
    (void)state;
    for (size_t w = 0; w < COUNT(ways); ++w) {
        cd_chain* chain = free_chain(&ways[w], CD_FLOAT64);
        static const size_t all[] = {0, 1, 2, 3, 4, 5, 6, 7, 8};
        const double gravity[COMPONENTS] = {0.5, -1};
        double momentum[COMPONENTS], after[COMPONENTS], mass = 0;
        for (size_t i = 0; i < NODES; ++i) mass += scene_get(chain, CD_MASS, i);
        momentum_of(chain, momentum);
        for (size_t i = 0; i < scene_springs(chain); ++i) ok(cd_chain_weld(chain, 0, (i * 5) % scene_springs(chain)));
        momentum_of(chain, after);
        for (size_t c = 0; c < COMPONENTS; ++c) assert_near(after[c], momentum[c], 1e-14, 1);
        ok(cd_chain_set_gravity(chain, gravity, COMPONENTS));
        ok(cd_chain_step(chain, 0.01, 200));
        assert_one_velocity(chain, all, NODES);
        momentum_of(chain, after);
        for (size_t c = 0; c < COMPONENTS; ++c)
            assert_near(after[c], momentum[c] + STRANDS * mass * gravity[c] * 2, 1e-12, 1);
        cd_chain_destroy(chain);
    }
}

/* x_0 -k- x_1 =weld= x_2 -k- x_3: the pair is one mass pulled by both its neighbours. */
static void a_weld_in_an_explicit_step_makes_one_mass_of_two(void** state) {
    (void)state;
    static const cd_method explicit_methods[] = {CD_METHOD_FORWARD_EULER, CD_METHOD_SYMPLECTIC_EULER};
    for (size_t i = 0; i < COUNT(explicit_methods); ++i) {
        cd_chain* chain = scene_chain(1, 3, 1, CD_FLOAT64);
        double x[4] = {0, 1, 1.5, 4}, v[4] = {0.5, 0.25, 0.25, -1}, got[4];
        const double k = 3, m = 0.25, dt = 0.01; /* of totals 1 */
        ok(cd_chain_set_method(chain, explicit_methods[i]));
        scene_write(chain, CD_POSITION, x);
        scene_write(chain, CD_VELOCITY, v);
        ok(cd_chain_weld(chain, 0, 1));
        for (int step = 0; step < 20; ++step) {
            const double left = k * (x[1] - x[0]), right = k * (x[3] - x[2]);
            const double a[4] = {left / m, (right - left) / (2 * m), (right - left) / (2 * m), -right / m};
            for (int j = 0; j < 4; ++j) {
                const double old = v[j];
                v[j] += dt * a[j];
                x[j] += dt * (explicit_methods[i] == CD_METHOD_SYMPLECTIC_EULER ? v[j] : old);
            }
            ok(cd_chain_step(chain, dt, 1));
            scene_read(chain, CD_POSITION, got);
            for (int j = 0; j < 4; ++j) assert_near(got[j], x[j], 1e-13, 1);
            scene_read(chain, CD_VELOCITY, got);
            for (int j = 0; j < 4; ++j) assert_near(got[j], v[j], 1e-13, 1);
        }
        cd_chain_destroy(chain);
    }
}

static void what_is_welded_to_a_held_node_moves_with_it(void** state) {
    (void)state;
    for (size_t w = 0; w < COUNT(ways); ++w) {
        for (cd_node kind = CD_NODE_PINNED; kind <= CD_NODE_DRIVEN; ++kind) {
            cd_chain* chain = free_chain(&ways[w], CD_FLOAT64);
            const size_t group[] = {3, 4, 5};
            scene_set(chain, CD_PIN, 4, kind);
            double told[STRANDS * COMPONENTS] = {0.25, -0.5, 0, 1}, v[ALL], start[ALL], end[ALL];
            for (size_t j = 0; j < COUNT(told) && kind == CD_NODE_PINNED; ++j) told[j] = 0;
            ok(cd_chain_write_f64(chain, CD_VELOCITY, 0, STRANDS, 4, 1, told, COUNT(told)));
            ok(cd_chain_weld(chain, 0, 3));
            ok(cd_chain_weld(chain, 0, 4));
            assert_one_velocity(chain, group, 3);
            scene_read(chain, CD_POSITION, start);
            ok(cd_chain_step(chain, 0.0078125, 128));
            scene_read(chain, CD_VELOCITY, v);
            scene_read(chain, CD_POSITION, end);
            for (size_t j = 0; j < COUNT(told); ++j)
                for (size_t i = 0; i < COUNT(group); ++i) {
                    const size_t s = j / COMPONENTS, c = j % COMPONENTS;
                    assert_near(at(v, s, group[i], c), told[j], 1e-15, 1);
                    assert_near(at(end, s, group[i], c), at(start, s, group[i], c) + told[j], 1e-13, 1);
                }
            cd_chain_destroy(chain);
        }
    }
}

static void a_velocity_written_to_a_welded_node_goes_to_its_whole_group(void** state) {
    (void)state;
    for (int all_round = 0; all_round <= 1; ++all_round) {
        cd_chain* chain = free_chain(&ways[all_round ? 3 : 0], CD_FLOAT64);
        const size_t group[] = {3, 4, 0, 1, 2, 5, 6, 7, 8}, members = all_round ? NODES : 2;
        const double fast[COMPONENTS] = {8, -8};
        double v[ALL], mass = 0, mean = 0;
        for (size_t i = 0; i < (all_round ? NODES : 1); ++i) ok(cd_chain_weld(chain, 0, (i + 3) % NODES));
        scene_read(chain, CD_VELOCITY, v);
        for (size_t i = 0; i < members; ++i) {
            const double m = scene_get(chain, CD_MASS, group[i]);
            mean += m * (i == 0 ? fast[0] : at(v, 1, group[i], 0));
            mass += m;
        }
        mean /= mass;
        ok(cd_chain_write_f64(chain, CD_VELOCITY, 1, 1, 3, 1, fast, COMPONENTS));
        assert_one_velocity(chain, group, members);
        scene_read(chain, CD_VELOCITY, v);
        assert_near(at(v, 1, 3, 0), mean, 1e-14, 1);
        cd_chain_destroy(chain);
    }
}

static void a_cut_leaves_two_chains(void** state) {
    (void)state;
    for (size_t w = 0; w < COUNT(ways); ++w) {
        if (ways[w].bends || ways[w].ring) continue; /* bend is not cut with the spring */
        cd_chain* chain = free_chain(&ways[w], CD_FLOAT64);
        cd_chain* left = scene_chain(STRANDS, 3, COMPONENTS, CD_FLOAT64);
        double x[ALL], v[ALL], y[STRANDS * 4 * COMPONENTS];
        ok(cd_chain_cut(chain, 0, 3));
        assert_true(scene_get(chain, CD_STIFFNESS, 3) == 0);
        scene_read(chain, CD_POSITION, x);
        scene_read(chain, CD_VELOCITY, v);
        ok(cd_chain_set_method(left, ways[w].method));
        ok(cd_chain_set_lambda(left, ways[w].lambda));
        ok(cd_chain_enable_field(left, CD_MASS));
        ok(cd_chain_enable_field(left, CD_STIFFNESS));
        for (size_t i = 0; i < 4; ++i) scene_set(left, CD_MASS, i, scene_get(chain, CD_MASS, i));
        for (size_t i = 0; i < 3; ++i) scene_set(left, CD_STIFFNESS, i, scene_get(chain, CD_STIFFNESS, i));
        for (size_t s = 0; s < STRANDS; ++s) {
            ok(cd_chain_write_f64(left, CD_POSITION, s, 1, 0, 4, x + s * NODES * COMPONENTS, 4 * COMPONENTS));
            ok(cd_chain_write_f64(left, CD_VELOCITY, s, 1, 0, 4, v + s * NODES * COMPONENTS, 4 * COMPONENTS));
        }
        ok(cd_chain_step(chain, 0.001, 100));
        ok(cd_chain_step(left, 0.001, 100));
        ok(cd_chain_read_f64(chain, CD_POSITION, 0, STRANDS, 0, 4, x, STRANDS * 4 * COMPONENTS));
        scene_read(left, CD_POSITION, y);
        for (size_t i = 0; i < COUNT(y); ++i) assert_near(x[i], y[i], 1e-13, 1);
        cd_chain_destroy(chain);
        cd_chain_destroy(left);
    }
}

static void a_weld_comes_loose_when_it_gets_a_stiffness_again(void** state) {
    (void)state;
    cd_chain* chain = free_chain(&ways[0], CD_FLOAT64);
    ok(cd_chain_weld(chain, 0, 3));
    ok(cd_chain_step(chain, 0.01, 10));
    scene_set(chain, CD_STIFFNESS, 3, 5);
    ok(cd_chain_step(chain, 0.01, 10));
    double v[ALL];
    scene_read(chain, CD_VELOCITY, v);
    assert_true(at(v, 0, 3, 0) != at(v, 0, 4, 0));
    ok(cd_chain_weld(chain, 0, 3));
    ok(cd_chain_disable_field(chain, CD_STIFFNESS));
    ok(cd_chain_step(chain, 0.01, 10));
    scene_read(chain, CD_VELOCITY, v);
    assert_true(at(v, 0, 3, 0) != at(v, 0, 4, 0));
    cd_chain_destroy(chain);
}

/* Whatever the method, with bend or without, and where a weld is the spring that closes a ring. */
static void welded_nodes_share_one_velocity_to_the_bit(void** state) {
    (void)state;
    enum { SIZE = 21, LAST = SIZE - 1 };
    static const size_t welds[] = {5, 6, 12, LAST};
    for (int kind = 0; kind < 32; ++kind) {
        const int ring = kind / 16;
        cd_chain* chain = scene_chain(1, LAST, 1, kind % 2 ? CD_FLOAT64 : CD_FLOAT32);
        double x[SIZE], v[SIZE];
        for (size_t i = 0; i < SIZE; ++i) {
            x[i] = (double)(i * 7919 % 101) / 100;
            v[i] = (double)(i * 104729 % 97) / 97 - 0.5;
        }
        ok(cd_chain_set_ring(chain, ring));
        ok(cd_chain_set_method(chain, kind / 2 % 4));
        ok(cd_chain_set_stiffness(chain, 0.01));
        if (kind / 8 % 2) ok(cd_chain_set_bend(chain, 1e-7));
        scene_write(chain, CD_POSITION, x);
        scene_write(chain, CD_VELOCITY, v);
        for (size_t k = 0; k < COUNT(welds) - (ring ? 0 : 1); ++k) ok(cd_chain_weld(chain, 0, welds[k]));
        for (int step = 0; step < 50; ++step) {
            ok(cd_chain_step(chain, 0.003, 1));
            scene_read(chain, CD_VELOCITY, v);
            for (size_t k = 0; k < COUNT(welds) - (ring ? 0 : 1); ++k)
                assert_true(v[welds[k]] == v[(welds[k] + 1) % SIZE]);
        }
        cd_chain_destroy(chain);
    }
}

/* A rod's solve keeps welds to rounding, which is taken out again; what is saved after any step can be loaded. */
static void welded_nodes_of_a_rod_share_one_velocity_whatever_holds_them(void** state) {
    (void)state;
    enum { MOST = 40 };
    static unsigned char bytes[100000];
    for (cd_node held = CD_NODE_FREE; held <= CD_NODE_DRIVEN; ++held)
        for (size_t n = 4; n < MOST; ++n) {
            cd_chain* chain = scene_chain(1, n - 1, 1, CD_FLOAT64);
            double v[MOST];
            size_t size, written;
            for (size_t i = 0; i < n; ++i) v[i] = held == CD_NODE_PINNED && i == n - 3 ? 0 : (double)(i * 7 % 11) / 10;
            ok(cd_chain_set_bend(chain, 0.01));
            scene_write(chain, CD_VELOCITY, v);
            scene_set(chain, CD_PIN, n - 3, held);
            ok(cd_chain_weld(chain, 0, n - 3));
            ok(cd_chain_step(chain, 0.1, 4));
            scene_read(chain, CD_VELOCITY, v);
            assert_true(v[n - 3] == v[n - 2]);
            ok(cd_chain_save_size(chain, &size));
            assert_true(size <= sizeof bytes);
            ok(cd_chain_save(chain, bytes, size, &written));
            ok(cd_chain_load(chain, bytes, size));
            cd_chain_destroy(chain);
        }
}

/* A lambda of nearly 0 makes of what is too small to be kept, and differs, what is not. */
static void welded_nodes_share_one_velocity_at_any_lambda(void** state) {
    (void)state;
    enum { NODES = 138 };
    for (cd_precision precision = CD_FLOAT32; precision <= CD_FLOAT64; ++precision)
        for (double lambda = 0; lambda<1; lambda = lambda> 0 ? 1e15 * lambda : 1e-61) {
            cd_chain* chain = scene_chain(1, NODES - 1, 1, precision);
            double v[NODES] = {0};
            for (size_t i = 0; i < 9; ++i) v[40 + i] = v[51 + i] = pow(0.1, 140 - 5.0 * (double)i);
            scene_write(chain, CD_VELOCITY, v);
            ok(cd_chain_set_lambda(chain, lambda));
            ok(cd_chain_weld(chain, 0, 48));
            for (int s = 0; s < 40; ++s) {
                if (cd_chain_step(chain, 164.6, 1) != CD_OK) break;
                scene_read(chain, CD_VELOCITY, v);
                assert_true(v[48] == v[49]);
            }
            cd_chain_destroy(chain);
        }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(welded_nodes_share_one_velocity_at_any_lambda),
        cmocka_unit_test(welded_nodes_share_one_velocity_to_the_bit),
        cmocka_unit_test(welded_nodes_of_a_rod_share_one_velocity_whatever_holds_them),
        cmocka_unit_test(welded_nodes_share_the_mean_velocity_at_once),
        cmocka_unit_test(a_welded_pair_keeps_its_offset_and_the_chain_its_momentum),
        cmocka_unit_test(a_chain_welded_all_along_moves_as_one_body),
        cmocka_unit_test(a_weld_in_an_explicit_step_makes_one_mass_of_two),
        cmocka_unit_test(what_is_welded_to_a_held_node_moves_with_it),
        cmocka_unit_test(a_velocity_written_to_a_welded_node_goes_to_its_whole_group),
        cmocka_unit_test(a_cut_leaves_two_chains),
        cmocka_unit_test(a_weld_comes_loose_when_it_gets_a_stiffness_again),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
