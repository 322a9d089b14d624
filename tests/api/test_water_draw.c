/* Vertices and triangles of a water, against what a plain reading of the header gives. */
#include <math.h>
#include <string.h>

#include "check.h"
#include "pool.h"

enum { NX = 9, NY = 6, CELLS = NX * NY, MOST = 6 * (NX - 1) * (NY - 1) };

/* Position, normal, depth, one after the other. */
static float vertex[CELLS][7];

static void draw(const cd_water* w) {
    ok(cd_water_write_vertices(w, vertex, sizeof vertex, sizeof vertex[0], 0, 12, 24));
}

static void vertices_lie_at_the_centres_on_the_surface_with_their_depth(void** state) {
    (void)state;
    for (size_t scene = 0; scene < POOLS; ++scene)
        for (cd_precision precision = CD_FLOAT32; precision <= CD_FLOAT64; ++precision) {
            cd_water* w = pool_of(scene, NX, NY, precision, 4);
            draw(w);
            for (size_t k = 0; k < CELLS; ++k) {
                const size_t i = k % NX, j = k / NX;
                const int there = !pool_has(w, CD_MASK) || pool_get(w, CD_MASK, i, j) == 1;
                assert_true(vertex[k][0] == (float)(((double)i + 0.5) * POOL_DX));
                assert_true(vertex[k][1] == (float)(((double)j + 0.5) * POOL_DY));
                assert_true(vertex[k][2] == (float)(pool_get(w, CD_BED, i, j) + pool_get(w, CD_DEPTH, i, j)));
                assert_true(vertex[k][6] == (there ? (float)pool_get(w, CD_DEPTH, i, j) : -1));
                const double square = pow(vertex[k][3], 2) + pow(vertex[k][4], 2) + pow(vertex[k][5], 2);
                assert_near(square, 1, 3e-7, 0);
                assert_true(vertex[k][5] > 0);
            }
            cd_water_destroy(w);
        }
}

static void only_the_floats_of_a_vertex_are_written(void** state) {
    (void)state;
    enum { LONGEST = 48, GUARD = 32 };
    static unsigned char buffer[CELLS * LONGEST + 2 * GUARD + 8], expected[sizeof buffer];
    cd_water* w = pool_of(POOL_EVERYTHING, NX, NY, CD_FLOAT32, 2);
    draw(w);
    for (size_t stride = 12; stride <= LONGEST; ++stride)
        for (size_t way = 0; way < 4; ++way) { /* bit 0: with a normal, bit 1: with a depth */
            const size_t needed = 12 + (way & 1 ? 12 : 0) + (way & 2 ? 4 : 0);
            if (needed > stride) continue;
            const size_t spare = stride - needed, first = spare / 2; /* odd offsets too */
            const size_t depth_at = way & 2 ? first : SIZE_MAX, normal_at = way & 1 ? stride - 12 : SIZE_MAX;
            const size_t at = first + (way & 2 ? 4 : 0);
            unsigned char* const start = buffer + GUARD + stride % 8; /* aligned and not */
            memset(buffer, 0x5A, sizeof buffer);
            memset(expected, 0x5A, sizeof expected);
            for (size_t k = 0; k < CELLS; ++k) {
                unsigned char* const to = expected + (start - buffer) + k * stride;
                memcpy(to + at, vertex[k], 12);
                if (way & 1) memcpy(to + normal_at, vertex[k] + 3, 12);
                if (way & 2) memcpy(to + depth_at, vertex[k] + 6, 4);
            }
            ok(cd_water_write_vertices(w, start, CELLS * stride, stride, at, normal_at, depth_at));
            assert_memory_equal(buffer, expected, sizeof buffer);
        }
    cd_water_destroy(w);
}

/* ---- normals ---- */

static void assert_normal(size_t k, double x, double y, double z, double tolerance) {
    const double length = sqrt(x * x + y * y + z * z);
    assert_near((double)vertex[k][3], x / length, tolerance, 1);
    assert_near((double)vertex[k][4], y / length, tolerance, 1);
    assert_near((double)vertex[k][5], z / length, tolerance, 1);
}

static void a_level_lake_has_upright_normals_over_any_bed(void** state) {
    (void)state;
    cd_water* w = pool(NX, NY, CD_FLOAT64);
    for (size_t k = 0; k < CELLS; ++k) pool_set(w, CD_BED, k % NX, k / NX, -0.5 * (double)(1 + k % 3));
    pool_fill(w, CD_SURFACE, 0);
    draw(w);
    for (size_t k = 0; k < CELLS; ++k) assert_normal(k, 0, 0, 1, 0);
    cd_water_destroy(w);
}

static void a_slope_has_one_normal_wet_or_dry(void** state) {
    (void)state;
    for (int wet = 0; wet <= 1; ++wet) {
        cd_water* w = pool(NX, NY, CD_FLOAT64);
        for (size_t k = 0; k < CELLS; ++k) {
            const double x = ((double)(k % NX) + 0.5) * POOL_DX, y = ((double)(k / NX) + 0.5) * POOL_DY;
            pool_set(w, CD_BED, k % NX, k / NX, 0.25 * x - 0.5 * y);
            if (wet) pool_set(w, CD_DEPTH, k % NX, k / NX, 1);
        }
        draw(w);
        for (size_t k = 0; k < CELLS; ++k) assert_normal(k, -0.25, 0.5, 1, 1e-7);
        cd_water_destroy(w);
    }
}

static int hole(size_t k) { return k == 2 * NX + 2 || k == 2 * NX + 6 || k == 3 * NX + 5; }
/* Beside an absent cell from one side, and up at it. */
static void a_slope_with_holes_has_one_normal_where_it_is(void** state) {
    (void)state;
    cd_water* w = pool(NX, NY, CD_FLOAT64);
    ok(cd_water_enable_field(w, CD_MASK));
    for (size_t k = 0; k < CELLS; ++k) {
        const double x = ((double)(k % NX) + 0.5) * POOL_DX, y = ((double)(k / NX) + 0.5) * POOL_DY;
        pool_set(w, CD_BED, k % NX, k / NX, hole(k) ? 100 : 0.25 * x - 0.5 * y);
        if (hole(k)) pool_set(w, CD_MASK, k % NX, k / NX, 0);
    }
    draw(w);
    for (size_t k = 0; k < CELLS; ++k)
        if (hole(k)) assert_normal(k, 0, 0, 1, 0);
        else assert_normal(k, -0.25, 0.5, 1, 1e-7);
    cd_water_destroy(w);
}

static void round_a_periodic_side_the_neighbour_is_at_the_other_end(void** state) {
    (void)state;
    cd_water* w = pool(NX, NY, CD_FLOAT64);
    ok(cd_water_set_side(w, CD_SIDE_X_LAST, CD_BORDER_PERIODIC, 0, 0));
    ok(cd_water_set_side(w, CD_SIDE_Y_LAST, CD_BORDER_PERIODIC, 0, 0));
    pool_vary(w, CD_DEPTH, 1, 0.5, 3);
    draw(w);
    for (size_t k = 0; k < CELLS; ++k) {
        const size_t i = k % NX, j = k / NX;
        const double x = pool_get(w, CD_SURFACE, (i + 1) % NX, j) - pool_get(w, CD_SURFACE, (i + NX - 1) % NX, j);
        const double y = pool_get(w, CD_SURFACE, i, (j + 1) % NY) - pool_get(w, CD_SURFACE, i, (j + NY - 1) % NY);
        assert_normal(k, -x / (2 * POOL_DX), -y / (2 * POOL_DY), 1, 1e-7);
    }
    cd_water_destroy(w);
}

/* Normals are made in blocks of cells. */
static void waters_of_any_width_have_the_normals_of_their_neighbours(void** state) {
    (void)state;
    enum { ROWS = 3, WIDEST = 130 };
    static const size_t widths[] = {1, 2, 63, 64, 65, 129, WIDEST};
    static float wide[ROWS * WIDEST][6];
    for (size_t n = 0; n < COUNT(widths); ++n)
        for (int round = 0; round < 2; ++round) {
            const size_t nx = widths[n];
            cd_water* w = pool(nx, ROWS, CD_FLOAT64);
            if (round) ok(cd_water_set_side(w, CD_SIDE_X_LAST, CD_BORDER_PERIODIC, 0, 0));
            pool_vary(w, CD_DEPTH, 1, 0.5, 3);
            ok(cd_water_write_vertices(w, wide, sizeof wide, sizeof wide[0], 0, 12, SIZE_MAX));
            for (size_t k = 0; k < nx * ROWS; ++k) {
                const size_t i = k % nx, j = k / nx, right = i + 1 < nx ? i + 1 : round ? 0 : i;
                const size_t left = i > 0 ? i - 1 : round ? nx - 1 : i, below = j > 0 ? j - 1 : j;
                const size_t above = j + 1 < ROWS ? j + 1 : j, steps_x = round ? 2 : right - left;
                const double rise_x = pool_get(w, CD_SURFACE, right, j) - pool_get(w, CD_SURFACE, left, j);
                const double rise_y = pool_get(w, CD_SURFACE, i, above) - pool_get(w, CD_SURFACE, i, below);
                const double x = steps_x ? -rise_x / (POOL_DX * (double)steps_x) : 0;
                const double y = -rise_y / (POOL_DY * (double)(above - below)), length = sqrt(x * x + y * y + 1);
                assert_near((double)wide[k][3], x / length, 1e-7, 1);
                assert_near((double)wide[k][4], y / length, 1e-7, 1);
                assert_near((double)wide[k][5], 1 / length, 1e-7, 1);
            }
            cd_water_destroy(w);
        }
}

/* The squares of its slopes have no number. */
static void a_wall_of_water_has_a_level_normal(void** state) {
    (void)state;
    cd_water* w = pool(NX, NY, CD_FLOAT64);
    for (size_t k = 0; k < CELLS; ++k) pool_set(w, CD_DEPTH, k % NX, k / NX, k % NX < 4 ? 0 : 1e300);
    draw(w);
    for (size_t k = 0; k < CELLS; ++k)
        if (k % NX == 3 || k % NX == 4) assert_normal(k, -1, 0, 0, 0);
        else assert_normal(k, 0, 0, 1, 0);
    cd_water_destroy(w);
}

/* ---- triangles ---- */

/* Cells of a square in its order; those that are there come first. */
static size_t corners_there(const cd_water* w, size_t i, size_t j, uint32_t* out_corners, int* out_wet) {
    const size_t x[4] = {i, i + 1, i + 1, i}, y[4] = {j, j, j + 1, j + 1};
    size_t count = 0;
    *out_wet = 0;
    for (int c = 0; c < 4; ++c) {
        if (pool_has(w, CD_MASK) && pool_get(w, CD_MASK, x[c], y[c]) == 0) continue;
        out_corners[count++] = (uint32_t)(y[c] * NX + x[c]);
        *out_wet |= pool_get(w, CD_DEPTH, x[c], y[c]) > 0;
    }
    return count;
}

static double twice_area(const uint32_t* t) {
    const float *a = vertex[t[0]], *b = vertex[t[1]], *c = vertex[t[2]];
    return (double)((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]));
}

static void squares_are_two_triangles_counter_clockwise_and_three_cells_are_one(void** state) {
    (void)state;
    for (size_t scene = 0; scene < POOLS; ++scene)
        for (int32_t skip_dry = 0; skip_dry <= 1; ++skip_dry) {
            cd_water* w = pool_of(scene, NX, NY, CD_FLOAT32, 4);
            uint32_t index[MOST];
            uint16_t narrow[MOST];
            size_t count = 0, at = 0;
            draw(w);
            ok(cd_water_get_index_count(w, skip_dry, &count));
            ok(cd_water_write_indices(w, skip_dry, index, count * 4, 4));
            ok(cd_water_write_indices(w, skip_dry, narrow, count * 2, 2));
            for (size_t k = 0; k < count; ++k) assert_true(narrow[k] == index[k]);
            for (size_t j = 0; j + 1 < NY; ++j)
                for (size_t i = 0; i + 1 < NX; ++i) {
                    uint32_t there[4];
                    int wet;
                    const size_t corners = corners_there(w, i, j, there, &wet);
                    if (corners < 3 || (skip_dry && !wet)) continue;
                    double area = 0;
                    for (size_t t = 0; t < corners - 2; ++t, at += 3) {
                        assert_true(at < count);
                        for (int v = 0; v < 3; ++v) { /* corners of this square */
                            size_t same = 0;
                            for (size_t c = 0; c < corners; ++c) same += there[c] == index[at + (size_t)v];
                            assert_int_equal(same, 1);
                        }
                        assert_true(twice_area(index + at) > 0);
                        area += twice_area(index + at);
                    }
                    assert_near(area, (double)(corners - 2) * POOL_DX * POOL_DY, 1e-6, 0);
                }
            assert_int_equal(at, count);
            cd_water_destroy(w);
        }
}

static void the_count_follows_the_water_only_where_dry_squares_are_skipped(void** state) {
    (void)state;
    cd_water* w = pool(NX, NY, CD_FLOAT32);
    size_t all = 77, wet = 77;
    ok(cd_water_get_index_count(w, 0, &all));
    ok(cd_water_get_index_count(w, 1, &wet));
    assert_true(all == MOST && wet == 0);
    pool_set(w, CD_DEPTH, 4, 3, 0x1p-70); /* one cell has four squares */
    ok(cd_water_get_index_count(w, 0, &all));
    ok(cd_water_get_index_count(w, 1, &wet));
    assert_true(all == MOST && wet == 4 * 6);
    pool_set(w, CD_DEPTH, 0, 0, 1);
    ok(cd_water_get_index_count(w, 1, &wet));
    assert_int_equal(wet, 5 * 6);
    ok(cd_water_enable_field(w, CD_MASK));
    pool_set(w, CD_MASK, 1, 1, 0);
    ok(cd_water_get_index_count(w, 0, &all));
    ok(cd_water_get_index_count(w, 1, &wet));
    assert_int_equal(all, MOST - 4 * 3);
    assert_int_equal(wet, 4 * 6 + 3);
    cd_water_destroy(w);
}

static void a_slice_has_vertices_and_no_triangles(void** state) {
    (void)state;
    cd_water* w = pool(NX, 1, CD_FLOAT64);
    pool_fill(w, CD_DEPTH, 1);
    size_t count = 77;
    ok(cd_water_get_index_count(w, 0, &count));
    assert_int_equal(count, 0);
    ok(cd_water_write_vertices(w, vertex, NX * sizeof vertex[0], sizeof vertex[0], 0, 12, 24));
    for (size_t i = 0; i < NX; ++i) assert_normal(i, 0, 0, 1, 0);
    cd_water_destroy(w);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(vertices_lie_at_the_centres_on_the_surface_with_their_depth),
        cmocka_unit_test(only_the_floats_of_a_vertex_are_written),
        cmocka_unit_test(a_level_lake_has_upright_normals_over_any_bed),
        cmocka_unit_test(a_slope_has_one_normal_wet_or_dry),
        cmocka_unit_test(a_slope_with_holes_has_one_normal_where_it_is),
        cmocka_unit_test(round_a_periodic_side_the_neighbour_is_at_the_other_end),
        cmocka_unit_test(waters_of_any_width_have_the_normals_of_their_neighbours),
        cmocka_unit_test(a_wall_of_water_has_a_level_normal),
        cmocka_unit_test(squares_are_two_triangles_counter_clockwise_and_three_cells_are_one),
        cmocka_unit_test(the_count_follows_the_water_only_where_dry_squares_are_skipped),
        cmocka_unit_test(a_slice_has_vertices_and_no_triangles),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
