/* The triangles of a membrane: a surface without gaps, seams or overlaps. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "check.h"
#include "cloth.h"
#include "scene.h"
#include "sheet.h"

enum { MOST_TRIANGLES = 1 << 18 };

static uint32_t triangle[MOST_TRIANGLES][3];
static size_t triangles;

static void draw(const cd_membrane* m) {
    size_t indices;
    ok(cd_membrane_get_index_count(m, &indices));
    assert_int_equal(indices % 3, 0);
    triangles = indices / 3;
    assert_true(triangles <= MOST_TRIANGLES);
    ok(cd_membrane_write_indices(m, triangle, indices * 4, 4));
}

static cd_membrane* ring_cloth(size_t nu, size_t nv, size_t components, int ring_u, int ring_v) {
    cd_membrane* m = cloth(nu, nv, components, CD_FLOAT32);
    ok(cd_membrane_set_ring(m, ring_u, ring_v));
    return m;
}

enum { FEW = 128 };

/* How often an edge goes from one node to the other. */
static unsigned char edge[FEW][FEW];

struct surface {
    long edges, border, nodes; /* border: edges with a triangle on one side only; nodes: those in a triangle */
};

/* Fails if a triangle has a node twice, or two triangles do not agree on which side of their edge is up. */
static struct surface surface(void) {
    struct surface s = {0, 0, 0};
    unsigned char met[FEW] = {0};
    memset(edge, 0, sizeof edge);
    for (size_t t = 0; t < triangles; ++t)
        for (size_t k = 0; k < 3; ++k) {
            const uint32_t from = triangle[t][k], to = triangle[t][(k + 1) % 3];
            assert_true(from < FEW && to < FEW && from != to);
            assert_int_equal(edge[from][to]++, 0);
            s.nodes += !met[from];
            met[from] = 1;
        }
    for (size_t a = 0; a < FEW; ++a)
        for (size_t b = 0; b < a; ++b) {
            s.edges += edge[a][b] || edge[b][a];
            s.border += edge[a][b] != edge[b][a];
        }
    return s;
}

static void triangles_meet_edge_to_edge(void** state) {
    (void)state;
    for (size_t nu = 2; nu <= 9; ++nu)
        for (size_t nv = 2; nv <= 9; ++nv)
            for (int rings = 0; rings < 4; ++rings) {
                const int ring_u = rings & 1, ring_v = rings >> 1;
                cd_membrane* m = ring_cloth(nu, nv, 3, ring_u, ring_v);
                draw(m);
                const struct surface s = surface();
                assert_int_equal(s.nodes, (nu + 1) * (nv + 1));
                assert_int_equal(triangles, 2 * (nu + (size_t)ring_u) * (nv + (size_t)ring_v));
                /* Euler: a disc, a tube, a torus */
                assert_int_equal(s.nodes - s.edges + (long)triangles, rings == 0 ? 1 : 0);
                assert_int_equal(s.border,
                                 (ring_u ? 0 : 2 * (nv + (size_t)ring_v)) + (ring_v ? 0 : 2 * (nu + (size_t)ring_u)));
                cd_membrane_destroy(m);
            }
}

static void one_absent_node_leaves_four_triangles(void** state) {
    (void)state;
    cd_membrane* m = cloth(4, 4, 2, CD_FLOAT32);
    ok(cd_membrane_enable_field(m, CD_MASK));
    sheet_set(m, CD_MASK, 2, 2, 0);
    draw(m);
    assert_int_equal(triangles, 2 * (16 - 4) + 4);
    const struct surface s = surface();
    assert_int_equal(s.nodes, 24);
    assert_int_equal(s.border, 16 + 4);
    ok(cd_membrane_disable_field(m, CD_MASK));
    draw(m);
    assert_int_equal(triangles, 2 * 16);
    cd_membrane_destroy(m);
}

static void a_torn_sheet_has_no_overlaps(void** state) {
    (void)state;
    for (int rings = 0; rings < 4; ++rings) {
        cd_membrane* m = ring_cloth(9, 8, 2, rings & 1, rings >> 1);
        ok(cd_membrane_enable_field(m, CD_MASK));
        for (uint64_t round = 1; round <= 30; ++round) {
            uint64_t seed = round;
            double there[90];
            for (size_t i = 0; i < 90; ++i) there[i] = scene_noise(&seed) < 0.5;
            cloth_write(m, CD_MASK, there);
            draw(m);
            surface();
            for (size_t t = 0; t < triangles; ++t)
                for (size_t k = 0; k < 3; ++k) assert_true(there[triangle[t][k]] != 0);
        }
        cd_membrane_destroy(m);
    }
}

static const struct {
    size_t nu, nv;
    int ring_u, ring_v;
} closings[] = {{6, 4, 1, 0}, {6, 4, 0, 1}, {6, 4, 1, 1}};

static void over_the_unit_square_no_triangle_reaches_back(void** state) {
    (void)state;
    for (size_t i = 0; i < COUNT(closings); ++i) {
        cd_membrane* open = cloth(6, 4, 1, CD_FLOAT32);
        cd_membrane* closed = ring_cloth(6, 4, 1, closings[i].ring_u, closings[i].ring_v);
        static uint32_t expected[2 * 6 * 4][3];
        draw(open);
        assert_int_equal(triangles, COUNT(expected));
        memcpy(expected, triangle, sizeof expected);
        draw(closed);
        assert_int_equal(triangles, COUNT(expected));
        assert_memory_equal(triangle, expected, sizeof expected);
        cd_membrane_destroy(open);
        cd_membrane_destroy(closed);
    }
}

static void a_torus_is_closed_and_faces_outwards(void** state) {
    (void)state;
    enum { AROUND = 40, ACROSS = 24, NODES = AROUND * ACROSS };
    cd_membrane* m = ring_cloth(AROUND - 1, ACROSS - 1, 3, 1, 1);
    static double x[NODES][3];
    for (size_t i = 0; i < NODES; ++i) {
        const double a = (double)(2 * PI) * (double)(i % AROUND) / AROUND,
                     b = (double)(2 * PI) * (double)(i / AROUND) / ACROSS;
        x[i][0] = (2 + cos(b)) * cos(a) + 5;
        x[i][1] = (2 + cos(b)) * sin(a);
        x[i][2] = sin(b);
    }
    cloth_write(m, CD_POSITION, x[0]);
    static float vertex[NODES][6];
    ok(cd_membrane_write_vertices(m, vertex, sizeof vertex, sizeof vertex[0], 0, 12));
    draw(m);
    double volume = 0, all[3] = {0, 0, 0};
    for (size_t t = 0; t < triangles; ++t) {
        const float *p = vertex[triangle[t][0]], *q = vertex[triangle[t][1]], *r = vertex[triangle[t][2]];
        double area[3], up = 0;
        for (size_t k = 0; k < 3; ++k) {
            const size_t i = (k + 1) % 3, j = (k + 2) % 3;
            area[k] = ((double)q[i] - (double)p[i]) * ((double)r[j] - (double)p[j]) -
                      ((double)q[j] - (double)p[j]) * ((double)r[i] - (double)p[i]);
            up += area[k] * (double)p[3 + k];
            volume += area[k] * (double)p[k] / 6;
            all[k] += area[k];
        }
        assert_true(up > 0);
    }
    for (size_t k = 0; k < 3; ++k) assert_near(all[k], 0, 1e-12, 1);
    assert_near(volume, (double)(4 * PI * PI), 0.02, 0);
    double enclosed; /* the mean of both ways to cut the cells */
    ok(cd_membrane_get_volume(m, &enclosed));
    assert_near(volume, enclosed, 0.005, 0);
    cd_membrane_destroy(m);
}

static void both_widths_hold_the_same_numbers(void** state) {
    (void)state;
    cd_membrane* m = ring_cloth(254, 256, 2, 1, 0); /* 65535 nodes */
    draw(m);
    const size_t indices = 3 * triangles;
    unsigned char* const buffer = malloc(2 * indices + 9);
    assert_non_null(buffer);
    for (size_t at = 0; at < 8; at += 3) { /* aligned and not */
        memset(buffer, 0x5A, 2 * indices + 9);
        ok(cd_membrane_write_indices(m, buffer + at, 2 * indices, 2));
        uint32_t most = 0;
        for (size_t i = 0; i < indices; ++i) {
            uint16_t index;
            memcpy(&index, buffer + at + 2 * i, 2);
            assert_int_equal(index, triangle[i / 3][i % 3]);
            if (index > most) most = index;
        }
        assert_int_equal(most, 65534);
        for (size_t i = 0; i < 2 * indices + 9; ++i)
            if (i < at || i >= at + 2 * indices) assert_int_equal(buffer[i], 0x5A);
    }
    free(buffer);
    cd_membrane_destroy(m);
}

static void triangles_stay_while_the_sheet_moves(void** state) {
    (void)state;
    cd_membrane* m = cloth(8, 8, 3, CD_FLOAT64);
    cloth_everything(m);
    draw(m);
    const size_t before = triangles;
    static uint32_t expected[128][3];
    assert_true(before <= COUNT(expected));
    memcpy(expected, triangle, before * sizeof *triangle);
    ok(cd_membrane_step(m, 0.01, 50));
    ok(cd_membrane_set_stiffness(m, 0, 0));
    ok(cd_membrane_set_mass_rule(m, CD_MASS_EQUAL));
    draw(m);
    assert_int_equal(triangles, before);
    assert_memory_equal(triangle, expected, before * sizeof *triangle);
    cd_membrane_destroy(m);
}

/* Of cloth: what has lost two of its springs is open, whatever the way that the tear runs. */
static void open_cells_of_cloth_have_no_triangles(void** state) {
    (void)state;
    for (int rings = 0; rings < 4; ++rings) {
        cd_membrane* m = ring_cloth(7, 6, 3, rings & 1, rings >> 1);
        ok(cd_membrane_set_rest_length(m, 1, 1));
        draw(m);
        const size_t before = triangles, columns = cloth_extent(m, CD_STIFFNESS_U).columns;
        const size_t rows = cloth_extent(m, CD_STIFFNESS_V).rows;
        assert_int_equal(before, 2 * columns * rows);
        for (cd_field field = CD_STIFFNESS_U; field <= CD_STIFFNESS_V; ++field) ok(cd_membrane_enable_field(m, field));
        uint64_t seed = 1 + (uint64_t)rings;
        for (int cuts = 0; cuts < 100; ++cuts) {
            const cd_field field = scene_noise(&seed) > 0 ? CD_STIFFNESS_U : CD_STIFFNESS_V;
            const struct cloth_extent all = cloth_extent(m, field);
            const size_t at = (size_t)((0.5 + 0.4999 * scene_noise(&seed)) * (double)all.count);
            sheet_set(m, field, at % all.columns, at / all.columns, 0);
            draw(m);
            size_t expected = 0;
            for (size_t v = 0; v < rows; ++v)
                for (size_t u = 0; u < columns; ++u) {
                    const size_t next_u = (u + 1) % 8, next_v = (v + 1) % 7;
                    const int left =
                        (sheet_get(m, CD_STIFFNESS_U, u, v) > 0) + (sheet_get(m, CD_STIFFNESS_U, u, next_v) > 0) +
                        (sheet_get(m, CD_STIFFNESS_V, u, v) > 0) + (sheet_get(m, CD_STIFFNESS_V, next_u, v) > 0);
                    if (left <= 2) continue;
                    const uint32_t first[3] = {(uint32_t)(v * 8 + u), (uint32_t)(v * 8 + next_u),
                                               (uint32_t)(next_v * 8 + next_u)};
                    assert_memory_equal(triangle[expected], first, sizeof first);
                    expected += 2;
                }
            assert_int_equal(triangles, expected);
        }
        assert_true(triangles < before / 2);
        ok(cd_membrane_set_rest_length(m, 0, 0)); /* no cloth: as ever */
        draw(m);
        assert_int_equal(triangles, before);
        cd_membrane_destroy(m);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(triangles_meet_edge_to_edge),
        cmocka_unit_test(one_absent_node_leaves_four_triangles),
        cmocka_unit_test(a_torn_sheet_has_no_overlaps),
        cmocka_unit_test(over_the_unit_square_no_triangle_reaches_back),
        cmocka_unit_test(a_torus_is_closed_and_faces_outwards),
        cmocka_unit_test(both_widths_hold_the_same_numbers),
        cmocka_unit_test(triangles_stay_while_the_sheet_moves),
        cmocka_unit_test(open_cells_of_cloth_have_no_triangles),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
