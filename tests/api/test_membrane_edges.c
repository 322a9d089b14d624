/* What holds nodes: edges and the field CD_PIN; pinned nodes rest, driven ones move as told, absent ones count for
 * nothing. */
#include <math.h>
#include <stdbool.h>

#include "check.h"
#include "cloth.h"
#include "sheet.h"

enum { NU = 6, NV = 5, COLUMNS = NU + 1, ROWS = NV + 1, COMPONENTS = 2, ALL = COLUMNS * ROWS * COMPONENTS };

static const struct {
    cd_method method;
    double lambda;
    cd_solver solver;
} ways[] = {{CD_METHOD_IMPLICIT, 0.5, CD_SOLVER_ALTERNATING},         {CD_METHOD_IMPLICIT, 0.5, CD_SOLVER_COUPLED},
            {CD_METHOD_IMPLICIT, 1, CD_SOLVER_ALTERNATING},           {CD_METHOD_IMPLICIT, 0, CD_SOLVER_COUPLED},
            {CD_METHOD_IMPLICIT, 0.6875, CD_SOLVER_COUPLED},          {CD_METHOD_FORWARD_EULER, 0.5, 0},
            {CD_METHOD_SYMPLECTIC_EULER, 0.5, CD_SOLVER_ALTERNATING}, {CD_METHOD_STIFF_SECOND, 0.5, CD_SOLVER_COUPLED},
            {CD_METHOD_STIFF_SECOND, 0.5, CD_SOLVER_ALTERNATING}};

static void set_way(cd_membrane* m, size_t i) {
    ok(cd_membrane_set_method(m, ways[i].method));
    ok(cd_membrane_set_lambda(m, ways[i].lambda));
    ok(cd_membrane_set_solver(m, ways[i].solver));
}

static cd_membrane* moving(cd_precision precision) {
    cd_membrane* m = cloth(NU, NV, COMPONENTS, precision);
    cloth_lay_out(m, 0.5);
    cloth_shake(m, 0.25, 3);
    return m;
}

static size_t at(size_t u, size_t v, size_t component) { return (v * COLUMNS + u) * COMPONENTS + component; }

static bool on_edge(cd_edge edge, size_t u, size_t v) {
    return edge == CD_EDGE_U_FIRST   ? u == 0
           : edge == CD_EDGE_U_LAST  ? u == NU
           : edge == CD_EDGE_V_FIRST ? v == 0
                                     : v == NV;
}

/* What the edges make of a node, by the header: pinned if either of its edges is, else driven if either is. */
static cd_node kind_by_edges(const cd_node* edges, size_t u, size_t v) {
    cd_node kind = CD_NODE_FREE;
    for (cd_edge edge = CD_EDGE_U_FIRST; edge <= CD_EDGE_V_LAST; ++edge) {
        if (!on_edge(edge, u, v) || edges[edge] == CD_NODE_MATCHED) continue;
        if (edges[edge] == CD_NODE_PINNED || kind == CD_NODE_FREE) kind = edges[edge];
    }
    return kind;
}

/* All 256 ways to hold the four edges, with CD_PIN switched on after, before, and not at all. */
static void edges_hold_their_nodes_with_and_without_the_pin_field(void** state) {
    (void)state;
    for (int all = 0; all < 256; ++all) {
        const cd_node edges[4] = {all % 4, all / 4 % 4, all / 16 % 4, all / 64};
        cd_membrane* m = moving(CD_FLOAT64);
        cd_membrane* before = moving(CD_FLOAT64);
        ok(cd_membrane_enable_field(before, CD_PIN));
        double v0[ALL], v[ALL];
        cloth_read(m, CD_VELOCITY, v0);
        for (cd_edge edge = CD_EDGE_U_FIRST; edge <= CD_EDGE_V_LAST; ++edge) {
            ok(cd_membrane_set_edge(m, edge, edges[edge]));
            ok(cd_membrane_set_edge(before, edge, edges[edge]));
        }
        for (cd_edge edge = CD_EDGE_U_FIRST; edge <= CD_EDGE_V_LAST; ++edge) {
            cd_node told = -1;
            ok(cd_membrane_get_edge(m, edge, &told));
            assert_int_equal(told, edges[edge]);
        }
        cloth_read(m, CD_VELOCITY, v);
        for (size_t i = 0; i < ALL; ++i) { /* pinning stops, all else leaves velocities */
            const size_t u = i / COMPONENTS % COLUMNS, w = i / COMPONENTS / COLUMNS;
            assert_true(v[i] == (kind_by_edges(edges, u, w) == CD_NODE_PINNED ? 0 : v0[i]));
        }
        double momentum[2][COMPONENTS], energy[2];
        ok(cd_membrane_get_momentum(m, momentum[0], COMPONENTS));
        ok(cd_membrane_get_energy(m, &energy[0], NULL, NULL));
        ok(cd_membrane_enable_field(m, CD_PIN));
        ok(cd_membrane_get_momentum(m, momentum[1], COMPONENTS));
        ok(cd_membrane_get_energy(m, &energy[1], NULL, NULL));
        assert_same_bits(momentum[0], momentum[1], COMPONENTS);
        assert_same_bits(&energy[0], &energy[1], 1);
        assert_int_equal(hash_of(m), hash_of(before));
        for (size_t u = 0; u < COLUMNS; ++u)
            for (size_t w = 0; w < ROWS; ++w) assert_true(sheet_get(m, CD_PIN, u, w) == kind_by_edges(edges, u, w));
        cd_membrane_destroy(m);
        cd_membrane_destroy(before);
    }
}

static void an_edge_is_written_over_pins_along_it_and_nowhere_else(void** state) {
    (void)state;
    cd_membrane* m = moving(CD_FLOAT32);
    ok(cd_membrane_enable_field(m, CD_PIN));
    sheet_set(m, CD_PIN, 3, 0, CD_NODE_PINNED);
    sheet_set(m, CD_PIN, 3, 2, CD_NODE_DRIVEN);
    cd_node kind = -1;
    ok(cd_membrane_get_edge(m, CD_EDGE_V_FIRST, &kind));
    assert_int_equal(kind, CD_NODE_FREE); /* what was set, whatever was written since */
    ok(cd_membrane_set_edge(m, CD_EDGE_V_FIRST, CD_NODE_FREE));
    assert_true(sheet_get(m, CD_PIN, 3, 0) == CD_NODE_FREE && sheet_get(m, CD_PIN, 3, 2) == CD_NODE_DRIVEN);
    cd_membrane_destroy(m);
}

static void edges_hold_again_when_the_pin_field_goes(void** state) {
    (void)state;
    cd_membrane* m = moving(CD_FLOAT64);
    const double v[COMPONENTS] = {1, 2};
    double back[COMPONENTS];
    ok(cd_membrane_set_edge(m, CD_EDGE_U_FIRST, CD_NODE_PINNED));
    ok(cd_membrane_enable_field(m, CD_PIN));
    sheet_set(m, CD_PIN, 0, 2, CD_NODE_FREE);
    sheet_set(m, CD_PIN, 4, 2, CD_NODE_PINNED);
    ok(cd_membrane_write_f64(m, CD_VELOCITY, 0, 2, 1, 1, v, COMPONENTS));
    ok(cd_membrane_disable_field(m, CD_PIN));
    ok(cd_membrane_read_f64(m, CD_VELOCITY, 0, 2, 1, 1, back, COMPONENTS));
    assert_true(back[0] == 0 && back[1] == 0);                            /* pinned again, and so at rest */
    ok(cd_membrane_write_f64(m, CD_VELOCITY, 4, 2, 1, 1, v, COMPONENTS)); /* free again */
    cd_membrane_destroy(m);
}

static void pinning_by_the_field_stops_a_node_and_driving_leaves_its_velocity(void** state) {
    (void)state;
    for (cd_precision precision = CD_FLOAT32; precision <= CD_FLOAT64; ++precision) {
        cd_membrane* m = moving(precision);
        double before[ALL], after[ALL];
        cloth_read(m, CD_VELOCITY, before);
        ok(cd_membrane_enable_field(m, CD_PIN));
        sheet_set(m, CD_PIN, 3, 2, CD_NODE_PINNED);
        sheet_set(m, CD_PIN, 2, 3, CD_NODE_DRIVEN);
        cloth_read(m, CD_VELOCITY, after);
        for (size_t i = 0; i < ALL; ++i) assert_true(after[i] == (i / COMPONENTS == 2 * COLUMNS + 3 ? 0 : before[i]));
        cd_membrane_destroy(m);
    }
}

static void pinned_nodes_rest_and_driven_ones_move_as_told(void** state) {
    (void)state;
    const double dt = 0x1p-7;
    for (size_t i = 0; i < COUNT(ways); ++i) {
        for (int by_field = 0; by_field <= 1; ++by_field) {
            for (int bends = 0; bends <= 1; ++bends) {
                cd_membrane* m = moving(CD_FLOAT64);
                if (by_field) ok(cd_membrane_enable_field(m, CD_PIN));
                if (bends) ok(cd_membrane_set_bend(m, 1e-5));
                ok(cd_membrane_set_drag(m, 0.5));
                ok(cd_membrane_set_edge(m, CD_EDGE_V_LAST, CD_NODE_PINNED));
                ok(cd_membrane_set_edge(m, CD_EDGE_U_FIRST, CD_NODE_DRIVEN));
                set_way(m, i);
                double told[COMPONENTS] = {0.25, -0.75}, x0[ALL], x[ALL], v[ALL];
                for (size_t w = 0; w < NV; ++w) ok(cd_membrane_write_f64(m, CD_VELOCITY, 0, w, 1, 1, told, COMPONENTS));
                cloth_read(m, CD_POSITION, x0);
                ok(cd_membrane_step(m, dt, 32));
                cloth_read(m, CD_POSITION, x);
                cloth_read(m, CD_VELOCITY, v);
                for (size_t u = 0; u < COLUMNS; ++u)
                    for (size_t w = 0; w < ROWS; ++w)
                        for (size_t c = 0; c < COMPONENTS; ++c) {
                            const size_t k = at(u, w, c);
                            if (w == NV) assert_true(x[k] == x0[k] && v[k] == 0);
                            else if (u == 0) {
                                assert_true(v[k] == told[c]);
                                assert_near(x[k], x0[k] + 32 * dt * told[c], 1e-14, 1);
                            } else assert_true(x[k] != x0[k]);
                        }
                cd_membrane_destroy(m);
            }
        }
    }
}

static void absent_nodes_stand_still_and_pull_at_nothing(void** state) {
    (void)state;
    const double gravity[COMPONENTS] = {0.5, -2};
    for (size_t i = 0; i < COUNT(ways); ++i) {
        for (int bends = 0; bends <= 1; ++bends) {
            double x[2][ALL], v[2][ALL], x0[ALL];
            for (int run = 0; run < 2; ++run) { /* in the second the absent nodes are far away */
                cd_membrane* m = moving(CD_FLOAT64);
                if (bends) ok(cd_membrane_set_bend(m, 1e-5));
                ok(cd_membrane_set_gravity(m, gravity, COMPONENTS));
                set_way(m, i);
                ok(cd_membrane_enable_field(m, CD_MASK));
                const double far[COMPONENTS] = {50, -70};
                for (size_t u = 1; u < 4; ++u) {
                    sheet_set(m, CD_MASK, u, 2, 0);
                    if (run) ok(cd_membrane_write_f64(m, CD_POSITION, u, 2, 1, 1, far, COMPONENTS));
                }
                cloth_read(m, CD_POSITION, x0);
                ok(cd_membrane_step(m, 0.01, 20));
                cloth_read(m, CD_POSITION, x[run]);
                cloth_read(m, CD_VELOCITY, v[run]);
                for (size_t u = 1; u < 4; ++u) {
                    assert_same_bits(&x[run][at(u, 2, 0)], &x0[at(u, 2, 0)], COMPONENTS);
                    for (size_t c = 0; c < COMPONENTS; ++c) assert_true(v[run][at(u, 2, c)] == 0);
                }
                cd_membrane_destroy(m);
            }
            for (size_t k = 0; k < ALL; ++k) {
                const size_t u = k / COMPONENTS % COLUMNS, w = k / COMPONENTS / COLUMNS;
                if (w == 2 && u >= 1 && u < 4) continue;
                assert_near(x[0][k], x[1][k], 1e-12, 1);
                assert_near(v[0][k], v[1][k], 1e-11, 1);
            }
        }
    }
}

static void an_absent_node_counts_in_no_energy_and_no_momentum(void** state) {
    (void)state;
    cd_membrane* m = cloth(2, 2, 1, CD_FLOAT64);
    const double gravity = -3, v = 5, x = 2;
    double kinetic, elastic, fall, momentum;
    ok(cd_membrane_set_gravity(m, &gravity, 1));
    ok(cd_membrane_write_f64(m, CD_VELOCITY, 1, 1, 1, 1, &v, 1));
    ok(cd_membrane_write_f64(m, CD_POSITION, 1, 1, 1, 1, &x, 1));
    ok(cd_membrane_attach(m, 1, 1, 4, 0, &gravity, 1));
    ok(cd_membrane_set_bend(m, 0.5));
    ok(cd_membrane_enable_field(m, CD_MASK));
    sheet_set(m, CD_MASK, 1, 1, 0);
    ok(cd_membrane_get_energy(m, &kinetic, &elastic, &fall));
    ok(cd_membrane_get_momentum(m, &momentum, 1));
    assert_true(kinetic == 0 && elastic == 0 && fall == 0 && momentum == 0);
    sheet_set(m, CD_MASK, 1, 1, 1); /* back again, at rest */
    ok(cd_membrane_get_energy(m, &kinetic, &elastic, &fall));
    assert_true(kinetic == 0 && elastic > 0 && fall > 0);
    cd_membrane_destroy(m);
}

static void a_node_let_go_moves_again(void** state) {
    (void)state;
    for (size_t i = 0; i < COUNT(ways); ++i) {
        cd_membrane* m = moving(CD_FLOAT64);
        set_way(m, i);
        ok(cd_membrane_set_edge(m, CD_EDGE_V_FIRST, CD_NODE_PINNED));
        ok(cd_membrane_step(m, 0.01, 5));
        ok(cd_membrane_set_edge(m, CD_EDGE_V_FIRST, CD_NODE_FREE));
        double before[ALL], after[ALL];
        cloth_read(m, CD_POSITION, before);
        ok(cd_membrane_step(m, 0.01, 5));
        cloth_read(m, CD_POSITION, after);
        for (size_t u = 0; u < COLUMNS; ++u) assert_true(after[at(u, 0, 0)] != before[at(u, 0, 0)]);
        cd_membrane_destroy(m);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(edges_hold_their_nodes_with_and_without_the_pin_field),
        cmocka_unit_test(an_edge_is_written_over_pins_along_it_and_nowhere_else),
        cmocka_unit_test(edges_hold_again_when_the_pin_field_goes),
        cmocka_unit_test(pinning_by_the_field_stops_a_node_and_driving_leaves_its_velocity),
        cmocka_unit_test(pinned_nodes_rest_and_driven_ones_move_as_told),
        cmocka_unit_test(absent_nodes_stand_still_and_pull_at_nothing),
        cmocka_unit_test(an_absent_node_counts_in_no_energy_and_no_momentum),
        cmocka_unit_test(a_node_let_go_moves_again),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
