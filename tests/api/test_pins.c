/* What holds a node: the field CD_PIN and the two ends say the same; pinned nodes rest, driven ones move as told. */
#include <math.h>
#include <stdlib.h>

#include "check.h"
#include "scene.h"

enum { STRANDS = 3, SPRINGS = 8, NODES = SPRINGS + 1, COMPONENTS = 2, ALL = STRANDS * NODES * COMPONENTS };

static const struct {
    cd_method method;
    double lambda;
} methods[] = {{CD_METHOD_IMPLICIT, 0.5},    {CD_METHOD_IMPLICIT, 1},        {CD_METHOD_IMPLICIT, 0},
               {CD_METHOD_IMPLICIT, 0.6875}, {CD_METHOD_FORWARD_EULER, 0.5}, {CD_METHOD_SYMPLECTIC_EULER, 0.5},
               {CD_METHOD_STIFF_SECOND, 0.5}};

static cd_chain* moving_chain(cd_precision precision) {
    cd_chain* chain = scene_chain(STRANDS, SPRINGS, COMPONENTS, precision);
    scene_lay_out(chain, 0.5);
    scene_shake(chain, 0.25, 3);
    return chain;
}

static double at(const double* values, size_t strand, size_t node, size_t component) {
    return values[(strand * NODES + node) * COMPONENTS + component];
}

static void the_ends_and_the_pin_field_say_the_same(void** state) {
    (void)state;
    static const size_t node_of[] = {0, NODES - 1};
    for (cd_end end = CD_END_FIRST; end <= CD_END_LAST; ++end) {
        for (cd_node kind = CD_NODE_FREE; kind <= CD_NODE_MATCHED; ++kind) {
            cd_chain* by_end = moving_chain(CD_FLOAT64);
            cd_chain* by_field = moving_chain(CD_FLOAT64);
            cd_node told = -1;
            ok(cd_chain_set_end(by_end, end, kind));
            assert_true(scene_get(by_end, CD_PIN, node_of[end]) == kind);
            assert_true(scene_get(by_end, CD_PIN, node_of[!end]) == CD_NODE_FREE);
            scene_set(by_field, CD_PIN, node_of[end], kind);
            ok(cd_chain_get_end(by_field, end, &told));
            assert_int_equal(told, kind);
            ok(cd_chain_get_end(by_field, !end, &told));
            assert_int_equal(told, CD_NODE_FREE);
            assert_int_equal(hash_of(by_end), hash_of(by_field));
            ok(cd_chain_set_end(by_end, end, CD_NODE_FREE));
            ok(cd_chain_get_end(by_end, end, &told));
            assert_int_equal(told, CD_NODE_FREE);
            cd_chain_destroy(by_end);
            cd_chain_destroy(by_field);
        }
    }
}

static void the_one_node_of_a_chain_is_both_its_ends(void** state) {
    (void)state;
    cd_chain* chain = scene_chain(1, 0, 1, CD_FLOAT64);
    cd_node kind = -1;
    ok(cd_chain_set_end(chain, CD_END_LAST, CD_NODE_PINNED));
    ok(cd_chain_get_end(chain, CD_END_FIRST, &kind));
    assert_int_equal(kind, CD_NODE_PINNED);
    cd_chain_destroy(chain);
}

static void only_nodes_on_a_border_can_be_matched(void** state) {
    (void)state;
    cd_chain* chain = moving_chain(CD_FLOAT64);
    const double matched = CD_NODE_MATCHED;
    for (size_t node = 0; node < NODES; ++node) {
        if (node == 0 || node == NODES - 1) scene_set(chain, CD_PIN, node, matched);
        else refuses(chain, cd_chain_write_f64(chain, CD_PIN, 0, 1, node, 1, &matched, 1), CD_ERROR_VALUE, "values|3");
    }
    cd_chain_destroy(chain);
}

static void pinning_stops_a_node_in_every_strand_and_driving_leaves_its_velocity(void** state) {
    (void)state;
    for (cd_precision precision = CD_FLOAT32; precision <= CD_FLOAT64; ++precision) {
        cd_chain* chain = moving_chain(precision);
        double before[ALL], after[ALL];
        scene_read(chain, CD_VELOCITY, before);
        ok(cd_chain_set_end(chain, CD_END_FIRST, CD_NODE_PINNED));
        scene_set(chain, CD_PIN, 3, CD_NODE_PINNED);
        ok(cd_chain_set_end(chain, CD_END_LAST, CD_NODE_DRIVEN));
        scene_set(chain, CD_PIN, 5, CD_NODE_DRIVEN);
        scene_read(chain, CD_VELOCITY, after);
        for (size_t i = 0; i < ALL; ++i) {
            const size_t node = i / COMPONENTS % NODES;
            assert_true(before[i] != 0);
            assert_true(after[i] == (node == 0 || node == 3 ? 0 : before[i]));
        }
        cd_chain_destroy(chain);
    }
}

static void a_pinned_node_rests_whatever_pulls_at_it(void** state) {
    (void)state;
    for (size_t i = 0; i < COUNT(methods); ++i) {
        for (cd_precision precision = CD_FLOAT32; precision <= CD_FLOAT64; ++precision) {
            cd_chain* chain = scene_chain(STRANDS, SPRINGS, COMPONENTS, precision);
            scene_everything(chain);
            ok(cd_chain_set_method(chain, methods[i].method));
            ok(cd_chain_set_lambda(chain, methods[i].lambda));
            const size_t pinned = NODES / 2;
            double before[ALL], after[ALL], v[ALL];
            scene_read(chain, CD_POSITION, before);
            ok(cd_chain_step(chain, 0.001, 50));
            scene_read(chain, CD_POSITION, after);
            scene_read(chain, CD_VELOCITY, v);
            size_t moved = 0;
            for (size_t j = 0; j < ALL; ++j) {
                if (j / COMPONENTS % NODES == pinned) assert_true(after[j] == before[j] && v[j] == 0);
                else moved += after[j] != before[j];
            }
            assert_int_equal(moved, ALL - STRANDS * COMPONENTS);
            cd_chain_destroy(chain);
        }
    }
}

static void a_driven_node_moves_with_the_velocity_written_to_it(void** state) {
    (void)state;
    for (size_t i = 0; i < COUNT(methods); ++i) {
        for (int bends = 0; bends <= 1; ++bends) {
            cd_chain* chain = moving_chain(CD_FLOAT64);
            ok(cd_chain_set_drag(chain, 0.5));
            if (bends) ok(cd_chain_set_bend(chain, 1e-4));
            ok(cd_chain_set_method(chain, methods[i].method));
            ok(cd_chain_set_lambda(chain, methods[i].lambda));
            scene_set(chain, CD_PIN, 3, CD_NODE_DRIVEN);
            double x0[ALL], x[ALL], v[ALL];
            scene_read(chain, CD_POSITION, x0);
            double told[STRANDS * COMPONENTS];
            const double dt = 0x1p-7;
            for (size_t leg = 0; leg < 3; ++leg) { /* dyadic numbers: x0 + t v has no rounding but x0's */
                for (size_t j = 0; j < COUNT(told); ++j) told[j] = (double)(1 + j) * 0.25 - (double)leg;
                ok(cd_chain_write_f64(chain, CD_VELOCITY, 0, STRANDS, 3, 1, told, COUNT(told)));
                ok(cd_chain_step(chain, dt, 64));
                scene_read(chain, CD_POSITION, x);
                scene_read(chain, CD_VELOCITY, v);
                for (size_t j = 0; j < COUNT(told); ++j) {
                    const size_t strand = j / COMPONENTS, c = j % COMPONENTS;
                    assert_true(at(v, strand, 3, c) == told[j]);
                    assert_near(at(x, strand, 3, c), at(x0, strand, 3, c) + 64 * dt * told[j], 1e-14, 1);
                }
                scene_read(chain, CD_POSITION, x0);
            }
            cd_chain_destroy(chain);
        }
    }
}

static void a_node_let_go_moves_again(void** state) {
    (void)state;
    cd_chain* chain = moving_chain(CD_FLOAT64);
    scene_set(chain, CD_PIN, 4, CD_NODE_PINNED);
    ok(cd_chain_step(chain, 0.01, 5));
    scene_set(chain, CD_PIN, 4, CD_NODE_FREE);
    double before[ALL], after[ALL];
    scene_read(chain, CD_POSITION, before);
    ok(cd_chain_step(chain, 0.01, 5));
    scene_read(chain, CD_POSITION, after);
    for (size_t strand = 0; strand < STRANDS; ++strand)
        for (size_t c = 0; c < COMPONENTS; ++c) assert_true(at(after, strand, 4, c) != at(before, strand, 4, c));
    cd_chain_destroy(chain);
}

/* -0 is a stiffness of 0: nothing is joined by it. */
static void a_pinned_node_rests_whatever_the_sign_of_a_stiffness_of_zero(void** state) {
    (void)state;
    const double kick = -400;
    for (size_t springs = 2; springs < 152; springs += 15)
        for (int bends = 0; bends <= 1; ++bends) {
            cd_chain* chain = scene_chain(1, springs, 1, CD_FLOAT64);
            double v;
            ok(cd_chain_set_end(chain, CD_END_FIRST, CD_NODE_PINNED));
            if (bends) ok(cd_chain_set_bend(chain, 1e-9));
            ok(cd_chain_impulse(chain, 0, springs / 3, &kick, 1));
            ok(cd_chain_step(chain, 74, 1));
            ok(cd_chain_set_stiffness(chain, -0.0));
            if (bends) ok(cd_chain_set_bend(chain, -0.0));
            ok(cd_chain_step(chain, 6.4e-5, 2));
            ok(cd_chain_read_f64(chain, CD_VELOCITY, 0, 1, 0, 1, &v, 1));
            assert_true(v == 0);
            cd_chain_destroy(chain);
        }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_ends_and_the_pin_field_say_the_same),
        cmocka_unit_test(the_one_node_of_a_chain_is_both_its_ends),
        cmocka_unit_test(only_nodes_on_a_border_can_be_matched),
        cmocka_unit_test(pinning_stops_a_node_in_every_strand_and_driving_leaves_its_velocity),
        cmocka_unit_test(a_pinned_node_rests_whatever_pulls_at_it),
        cmocka_unit_test(a_driven_node_moves_with_the_velocity_written_to_it),
        cmocka_unit_test(a_node_let_go_moves_again),
        cmocka_unit_test(a_pinned_node_rests_whatever_the_sign_of_a_stiffness_of_zero),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
