/* Nodes that go to a pose over a call of step, and bodies that are teleported: chains, ropes and membranes. */
#include <math.h>
#include <string.h>

#include "check.h"
#include "scene.h"

enum { STRANDS = 3, SPRINGS = 11, NODES = SPRINGS + 1, COMPONENTS = 3, ALL = STRANDS * NODES * COMPONENTS };

static void lengths(cd_chain* c) {
    ok(cd_chain_set_rest_length(c, 0.2 * SPRINGS)); /* twice as long as it lies */
    ok(cd_chain_set_stiffness(c, INFINITY));
    ok(cd_chain_set_tolerance(c, 1e-12, 300));
}
static void bend(cd_chain* c) { ok(cd_chain_set_bend(c, 0.01)); }
static void explicit_steps(cd_chain* c) { ok(cd_chain_set_method(c, CD_METHOD_SYMPLECTIC_EULER)); }
static void forward(cd_chain* c) { ok(cd_chain_set_method(c, CD_METHOD_FORWARD_EULER)); }
static void two_stages(cd_chain* c) { ok(cd_chain_set_method(c, CD_METHOD_STIFF_SECOND)); }
static void backward(cd_chain* c) { ok(cd_chain_set_lambda(c, 1)); }
static void ring(cd_chain* c) { ok(cd_chain_set_ring(c, 1)); }
static void weld(cd_chain* c) { ok(cd_chain_weld(c, 0, 4)); }
static void nothing(cd_chain* c) { (void)c; }

static scene_build* const kinds[] = {nothing, backward, two_stages, explicit_steps, forward, bend, ring, weld, lengths};

/* With nodes 0 and 4 of every strand posed; of a rope's strand 1 node 5 instead of 4. */
static cd_chain* posed(scene_build* kind, cd_precision precision) {
    const double gravity[COMPONENTS] = {0, -9.81, 0}, pose = CD_NODE_POSED, free_node = CD_NODE_FREE;
    cd_chain* c = scene_chain(STRANDS, SPRINGS, COMPONENTS, precision);
    scene_lay_out(c, 0.1);
    kind(c);
    ok(cd_chain_set_gravity(c, gravity, COMPONENTS));
    ok(cd_chain_enable_field(c, CD_TARGET));
    for (size_t strand = 0; strand < scene_own_strands(c); ++strand) {
        ok(cd_chain_write_f64(c, CD_PIN, strand, 1, 0, 1, &pose, 1));
        ok(cd_chain_write_f64(c, CD_PIN, strand, 1, strand == 1 ? 5 : 4, 1, &pose, 1));
    }
    ok(cd_chain_write_f64(c, CD_PIN, 0, 1, 7, 1, &free_node, 1));
    return c;
}
static int is_posed(const cd_chain* c, size_t strand, size_t node) {
    double pin;
    ok(cd_chain_read_f64(c, CD_PIN, scene_own_strands(c) > 1 ? strand : 0, 1, node, 1, &pin, 1));
    return pin == CD_NODE_POSED;
}

/* After every call they are at their targets, with the velocity of the way there; the next call stops them. */
static void posed_nodes_are_where_their_targets_are(void** state) {
    (void)state;
    for (size_t kind = 0; kind < COUNT(kinds); ++kind)
        for (cd_precision precision = CD_FLOAT32; precision <= CD_FLOAT64; ++precision) {
            cd_chain* c = posed(kinds[kind], precision);
            const double rounding = precision == CD_FLOAT32 ? 1e-6 : 1e-14, dt = 1e-3;
            uint64_t seed = 3 + kind;
            for (int call = 0; call < 20; ++call) {
                const size_t steps = (size_t)(1 + call % 4);
                double before[ALL], target[ALL], after[ALL], v[ALL];
                scene_read(c, CD_POSITION, before);
                scene_read(c, CD_TARGET, target);
                for (size_t i = 0; i < ALL && call % 3 < 2; ++i) target[i] += 0.01 * scene_noise(&seed);
                scene_write(c, CD_TARGET, target);
                ok(cd_chain_step(c, dt, steps));
                scene_read(c, CD_TARGET, target); /* as they are stored */
                scene_read(c, CD_POSITION, after);
                scene_read(c, CD_VELOCITY, v);
                for (size_t strand = 0; strand < STRANDS; ++strand)
                    for (size_t node = 0; node < NODES; ++node)
                        for (size_t k = 0; k < COMPONENTS && is_posed(c, strand, node); ++k) {
                            const size_t at = (strand * NODES + node) * COMPONENTS + k;
                            const double speed = (target[at] - before[at]) / (dt * (double)steps);
                            assert_true(after[at] == target[at]);
                            assert_near(v[at], speed, 4 * rounding / dt, 1);
                            assert_true(call % 3 < 2 || v[at] == 0);
                        }
            }
            cd_chain_destroy(c);
        }
}

/* It is the same as to drive the node with the velocity that leads there, and to put it there in the end, which rounding
 * may miss; without targets, too. */
static void a_posed_node_moves_as_a_driven_one(void** state) {
    (void)state;
    for (size_t kind = 0; kind < COUNT(kinds); ++kind) {
        cd_chain *c = posed(kinds[kind], CD_FLOAT64), *driven = posed(kinds[kind], CD_FLOAT64);
        for (size_t strand = 0; strand < scene_own_strands(c); ++strand)
            for (size_t node = 0; node < NODES; ++node) {
                const double drive = CD_NODE_DRIVEN;
                if (is_posed(c, strand, node)) ok(cd_chain_write_f64(driven, CD_PIN, strand, 1, node, 1, &drive, 1));
            }
        uint64_t seed = 9;
        for (int call = 0; call < 12; ++call) {
            if (call == 8) { /* from here on as driven nodes */
                ok(cd_chain_disable_field(c, CD_TARGET));
                ok(cd_chain_disable_field(driven, CD_TARGET));
            }
            for (size_t strand = 0; strand < STRANDS && call < 8; ++strand)
                for (size_t node = 0; node < NODES; ++node) {
                    double x[COMPONENTS], v[COMPONENTS];
                    if (!is_posed(c, strand, node)) continue;
                    ok(cd_chain_read_f64(c, CD_POSITION, strand, 1, node, 1, x, COMPONENTS));
                    for (size_t k = 0; k < COMPONENTS; ++k) {
                        const double target = x[k] + 0.01 * scene_noise(&seed);
                        v[k] = (target - x[k]) / (0.004 * 3);
                        x[k] = target;
                    }
                    ok(cd_chain_write_f64(c, CD_TARGET, strand, 1, node, 1, x, COMPONENTS));
                    ok(cd_chain_write_f64(driven, CD_VELOCITY, strand, 1, node, 1, v, COMPONENTS));
                }
            const cd_status status = cd_chain_step(c, 0.004, 3);
            assert_int_equal(status, cd_chain_step(driven, 0.004, 3));
            for (size_t strand = 0; strand < STRANDS && call < 8; ++strand)
                for (size_t node = 0; node < NODES; ++node) {
                    double x[COMPONENTS];
                    if (!is_posed(c, strand, node)) continue;
                    ok(cd_chain_read_f64(c, CD_TARGET, strand, 1, node, 1, x, COMPONENTS));
                    ok(cd_chain_write_f64(driven, CD_POSITION, strand, 1, node, 1, x, COMPONENTS));
                }
            double x[2][ALL];
            scene_read(c, CD_POSITION, x[0]);
            scene_read(driven, CD_POSITION, x[1]);
            assert_same_bits(x[0], x[1], ALL);
        }
        cd_chain_destroy(c);
        cd_chain_destroy(driven);
    }
}

static void posing_an_end_makes_targets_of_where_it_is(void** state) {
    (void)state;
    for (int with_lengths = 0; with_lengths <= 1; ++with_lengths) {
        cd_chain* c = scene_chain(STRANDS, SPRINGS, COMPONENTS, CD_FLOAT64);
        double x[ALL], target[ALL];
        scene_lay_out(c, 0.1);
        if (with_lengths) lengths(c);
        ok(cd_chain_set_end(c, CD_END_LAST, CD_NODE_POSED));
        for (size_t strand = 0; strand < STRANDS; ++strand) assert_true(is_posed(c, strand, SPRINGS));
        scene_read(c, CD_POSITION, x);
        scene_read(c, CD_TARGET, target);
        assert_same_bits(x, target, ALL);
        cd_chain_destroy(c);
    }
    cd_chain* c = scene_chain(1, 2, 1, CD_FLOAT64); /* two held nodes can't be welded */
    ok(cd_chain_set_end(c, CD_END_FIRST, CD_NODE_PINNED));
    ok(cd_chain_weld(c, 0, 0));
    ok(cd_chain_weld(c, 0, 1));
    refuses(c, cd_chain_set_end(c, CD_END_LAST, CD_NODE_POSED), CD_ERROR_UNSUPPORTED, "welded");
    refuses(c, cd_chain_read_f64(c, CD_TARGET, 0, 1, 0, 1, out.number, 1), CD_ERROR_DISABLED, "CD_TARGET");
    cd_chain_destroy(c);
}

/* Edges and single nodes of a sheet, with both solvers. */
static void a_posed_edge_carries_the_sheet(void** state) {
    (void)state;
    enum { NU = 5, NV = 4, COLUMNS = NU + 1, ROWS = NV + 1, COUNT_ALL = COLUMNS * ROWS * 3 };
    for (int way = 0; way < 4; ++way) {
        cd_membrane* m = NULL;
        double x[COUNT_ALL], target[COUNT_ALL], v[COUNT_ALL], pin = 0;
        const double gravity[3] = {0, -9.81, 0};
        ok(cd_membrane_create(NU, NV, 3, way % 2 ? CD_FLOAT64 : CD_FLOAT32, NULL, &m));
        ok(cd_membrane_set_gravity(m, gravity, 3));
        ok(cd_membrane_set_solver(m, way < 2 ? CD_SOLVER_ALTERNATING : CD_SOLVER_COUPLED));
        ok(cd_membrane_set_edge(m, CD_EDGE_U_LAST, CD_NODE_PINNED));
        ok(cd_membrane_set_edge(m, CD_EDGE_V_FIRST, CD_NODE_POSED));
        if (way >= 2) { /* and a node inside */
            ok(cd_membrane_enable_field(m, CD_PIN));
            ok(cd_membrane_read_f64(m, CD_PIN, NU, 0, 1, 1, &pin, 1));
            assert_true(pin == CD_NODE_PINNED); /* the corner */
            pin = CD_NODE_POSED;
            ok(cd_membrane_write_f64(m, CD_PIN, 2, 3, 1, 1, &pin, 1));
        }
        uint64_t seed = 5;
        for (int call = 0; call < 10; ++call) {
            ok(cd_membrane_read_f64(m, CD_TARGET, 0, 0, COLUMNS, ROWS, target, COUNT_ALL));
            for (size_t i = 0; i < COUNT_ALL && call < 8; ++i) target[i] += 0.1 * scene_noise(&seed);
            ok(cd_membrane_write_f64(m, CD_TARGET, 0, 0, COLUMNS, ROWS, target, COUNT_ALL));
            ok(cd_membrane_step(m, 0.002, 3));
            ok(cd_membrane_read_f64(m, CD_TARGET, 0, 0, COLUMNS, ROWS, target, COUNT_ALL)); /* as they are stored */
            ok(cd_membrane_read_f64(m, CD_POSITION, 0, 0, COLUMNS, ROWS, x, COUNT_ALL));
            ok(cd_membrane_read_f64(m, CD_VELOCITY, 0, 0, COLUMNS, ROWS, v, COUNT_ALL));
            for (size_t i = 0; i < COUNT_ALL; ++i) {
                const size_t u = i / 3 % COLUMNS, row = i / 3 / COLUMNS;
                const int is_pinned = u == NU, is_there = row == 0 || (way >= 2 && u == 2 && row == 3);
                if (is_pinned) assert_true(x[i] == 0 && v[i] == 0);
                else if (is_there) assert_true(x[i] == target[i]);
                if (is_there && call >= 9) assert_true(v[i] == 0);
            }
        }
        assert_true(fabs(x[3 * (COLUMNS + 1) + 1]) > 1e-4); /* what is free has moved */
        cd_membrane_destroy(m);
    }
}

/* ---- teleport ---------------------------------------------------------------------------------------------------- */

/* R x + shift of many vectors. */
static void turned(const double* rotation, const double* shift, double* numbers, size_t count) {
    for (size_t at = 0; at < count; at += 3) {
        double to[3];
        for (int k = 0; k < 3; ++k) {
            to[k] = shift[k];
            for (int j = 0; j < 3; ++j) to[k] += rotation[3 * k + j] * numbers[at + (size_t)j];
        }
        memcpy(numbers + at, to, sizeof to);
    }
}
static const double rotation[9] = {0.36, 0.48, -0.8, -0.8, 0.6, 0, 0.48, 0.64, 0.6}; /* by 0.6 twice */
static const double shift[3] = {100, -20, 7}, nowhere[3] = {0, 0, 0};

/* A strand that was moved goes on as it would have, had everything moved with it; the others are left alone. */
static void a_teleported_strand_goes_on_as_it_was(void** state) {
    (void)state;
    for (size_t kind = 0; kind < COUNT(kinds); ++kind)
        for (int turns = 0; turns <= 1; ++turns) {
            cd_chain *c = posed(kinds[kind], CD_FLOAT64), *moved = posed(kinds[kind], CD_FLOAT64);
            ok(cd_chain_attach(c, 0, 8, 20, 0.1, NULL, 0));
            ok(cd_chain_step(c, 0.002, 40));
            ok(cd_chain_copy_state(moved, c));
            const double whole[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1}, *const turn = turns ? rotation : whole;
            double gravity[3], x[2][ALL];
            for (size_t strand = 0; strand < STRANDS; ++strand)
                ok(cd_chain_teleport(moved, strand, turns ? rotation : NULL, shift, COMPONENTS));
            ok(cd_chain_get_gravity(moved, gravity, COMPONENTS));
            turned(turn, nowhere, gravity, 3);
            ok(cd_chain_set_gravity(moved, gravity, COMPONENTS));
            ok(cd_chain_step(c, 0.002, 25));
            ok(cd_chain_step(moved, 0.002, 25));
            for (cd_field field = CD_POSITION; field <= CD_TARGET; field += CD_TARGET - CD_POSITION) {
                scene_read(c, field, x[0]);
                scene_read(moved, field, x[1]);
                turned(turn, shift, x[0], ALL);
                for (size_t i = 0; i < ALL; ++i) assert_near(x[1][i], x[0][i], 1e-9, 1);
            }
            scene_read(c, CD_VELOCITY, x[0]);
            scene_read(moved, CD_VELOCITY, x[1]);
            turned(turn, nowhere, x[0], ALL);
            for (size_t i = 0; i < ALL; ++i) assert_near(x[1][i], x[0][i], 1e-7, 1);
            cd_chain_destroy(c);
            cd_chain_destroy(moved);
        }
}

static void one_strand_is_teleported_and_no_other(void** state) {
    (void)state;
    cd_chain* c = posed(lengths, CD_FLOAT64);
    ok(cd_chain_step(c, 0.002, 40));
    double x[2][ALL], tension[2][STRANDS * SPRINGS];
    scene_read(c, CD_POSITION, x[0]);
    scene_read(c, CD_TENSION, tension[0]);
    ok(cd_chain_teleport(c, 1, NULL, shift, COMPONENTS));
    scene_read(c, CD_POSITION, x[1]);
    scene_read(c, CD_TENSION, tension[1]);
    assert_same_bits(tension[0], tension[1], STRANDS * SPRINGS);
    for (size_t i = 0; i < ALL; ++i)
        assert_true(x[1][i] == x[0][i] + (i / (NODES * COMPONENTS) == 1 ? shift[i % COMPONENTS] : 0));
    cd_chain_destroy(c);
}

static void a_teleported_sheet_goes_on_as_it_was(void** state) {
    (void)state;
    enum { NU = 6, NV = 5, COUNT_ALL = (NU + 1) * (NV + 1) * 3 };
    for (cd_solver solver = CD_SOLVER_ALTERNATING; solver <= CD_SOLVER_COUPLED; ++solver) {
        cd_membrane* m[2];
        double x[2][COUNT_ALL], gravity[2][3] = {{0, -9.81, 0}, {0, -9.81, 0}};
        turned(rotation, nowhere, gravity[1], 3);
        for (int i = 0; i < 2; ++i) {
            ok(cd_membrane_create(NU, NV, 3, CD_FLOAT64, NULL, &m[i]));
            ok(cd_membrane_set_gravity(m[i], gravity[0], 3));
            ok(cd_membrane_set_solver(m[i], solver));
            ok(cd_membrane_set_tolerance(m[i], 1e-13, 200));
            ok(cd_membrane_set_bend(m[i], 0.01));
            ok(cd_membrane_set_edge(m[i], CD_EDGE_U_FIRST, CD_NODE_POSED));
            ok(cd_membrane_step(m[i], 0.01, 20));
        }
        ok(cd_membrane_teleport(m[1], rotation, shift, 3));
        ok(cd_membrane_set_gravity(m[1], gravity[1], 3));
        for (int i = 0; i < 2; ++i) {
            ok(cd_membrane_step(m[i], 0.01, 20));
            ok(cd_membrane_read_f64(m[i], CD_POSITION, 0, 0, NU + 1, NV + 1, x[i], COUNT_ALL));
        }
        turned(rotation, shift, x[0], COUNT_ALL);
        for (size_t i = 0; i < COUNT_ALL; ++i) assert_near(x[1][i], x[0][i], 1e-9, 1);
        for (int i = 0; i < 2; ++i) cd_membrane_destroy(m[i]);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(posed_nodes_are_where_their_targets_are),
        cmocka_unit_test(a_posed_node_moves_as_a_driven_one),
        cmocka_unit_test(posing_an_end_makes_targets_of_where_it_is),
        cmocka_unit_test(a_posed_edge_carries_the_sheet),
        cmocka_unit_test(a_teleported_strand_goes_on_as_it_was),
        cmocka_unit_test(one_strand_is_teleported_and_no_other),
        cmocka_unit_test(a_teleported_sheet_goes_on_as_it_was),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
