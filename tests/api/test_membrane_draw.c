/* Vertices of a membrane, and normals against exact ones and against sums over its triangles. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "check.h"
#include "cloth.h"
#include "scene.h"
#include "sheet.h"

enum { DENSE = 24, MOST_NODES = 2048 };

/* What the library draws: three floats of position and three of normal per node, and the triangles. */
static float vertex[MOST_NODES][6];
static uint32_t triangle[2 * MOST_NODES][3];
static size_t nodes, triangles;

static void draw(const cd_membrane* m) {
    nodes = sheet_nodes(m);
    assert_true(nodes <= MOST_NODES);
    ok(cd_membrane_write_vertices(m, vertex, nodes * DENSE, DENSE, 0, 12));
    size_t indices;
    ok(cd_membrane_get_index_count(m, &indices));
    assert_int_equal(indices % 3, 0);
    triangles = indices / 3;
    ok(cd_membrane_write_indices(m, triangle, indices * 4, 4));
}

static const float* normal(size_t node) { return vertex[node] + 3; }

static void check_vector(const float* got, double x, double y, double z, double tolerance) {
    assert_near((double)got[0], x, tolerance, 1);
    assert_near((double)got[1], y, tolerance, 1);
    assert_near((double)got[2], z, tolerance, 1);
}

static double length(const float* v) {
    return sqrt((double)v[0] * (double)v[0] + (double)v[1] * (double)v[1] + (double)v[2] * (double)v[2]);
}

/* Lays the sheet out as place(u, v), both in [0, 1], at the end of a ring before it. */
typedef void placing(double u, double v, double* out_x);

static void lay(cd_membrane* m, placing* place) {
    const struct cloth_extent all = cloth_extent(m, CD_POSITION), along_u = cloth_extent(m, CD_STIFFNESS_U),
                              along_v = cloth_extent(m, CD_STIFFNESS_V);
    double* x = calloc(all.count, sizeof *x);
    assert_non_null(x);
    for (size_t i = 0; i < all.columns * all.rows; ++i)
        place((double)(i % all.columns) / (double)along_u.columns, (double)(i / all.columns) / (double)along_v.rows,
              x + i * all.components);
    cloth_write(m, CD_POSITION, x);
    free(x);
}

static cd_membrane* ring_cloth(size_t nu, size_t nv, size_t components, cd_precision precision, int ring_u,
                               int ring_v) {
    cd_membrane* m = cloth(nu, nv, components, precision);
    ok(cd_membrane_set_ring(m, ring_u, ring_v));
    return m;
}

/* ---- vertices ---- */

static void vertices_lie_where_the_nodes_do(void** state) {
    (void)state;
    for (cd_precision precision = CD_FLOAT32; precision <= CD_FLOAT64; ++precision)
        for (size_t components = 1; components <= 4; ++components)
            for (int ring = 0; ring < 2; ++ring) {
                enum { NU = 6, NV = 4, COLUMNS = NU + 1, NODES = COLUMNS * (NV + 1) };
                cd_membrane* m = ring_cloth(NU, NV, components, precision, ring, 0);
                cloth_shake(m, 1, 20);
                double x[4 * NODES];
                cloth_read(m, CD_POSITION, x);
                draw(m);
                for (size_t i = 0; i < NODES; ++i) {
                    const double* at = x + i * components;
                    const double u = (double)(i % COLUMNS) / (NU + ring), v = (double)(i / COLUMNS) / NV;
                    const double one[] = {u, v, at[0]}, more[] = {at[0], at[1], components > 2 ? at[2] : 0};
                    for (size_t k = 0; k < 3; ++k)
                        assert_true(vertex[i][k] == (float)(components == 1 ? one : more)[k]);
                }
                cd_membrane_destroy(m);
            }
}

static void only_the_floats_of_a_vertex_are_written(void** state) {
    (void)state;
    enum { MOST = 64, GUARD = 32 };
    cd_membrane* m = cloth(3, 2, 3, CD_FLOAT64);
    cloth_lay_out(m, 0.5);
    cloth_shake(m, 0.2, 21);
    draw(m);
    static unsigned char buffer[12 * MOST + 2 * GUARD + 8], expected[sizeof buffer];
    for (size_t stride = 12; stride <= MOST; ++stride) {
        for (size_t at = 0; at + 12 <= stride; at += 1 + at % 3) {
            for (size_t way = 0; way < 3; ++way) { /* no normal; as far before or behind the position as it goes */
                const size_t normal_at = way == 0 ? SIZE_MAX : way == 1 ? 0 : stride - 12;
                if (way > 0 && (normal_at < at ? at - normal_at : normal_at - at) < 12) continue;
                unsigned char* const start = buffer + GUARD + stride % 8; /* aligned and not */
                memset(buffer, 0x5A, sizeof buffer);
                memset(expected, 0x5A, sizeof expected);
                for (size_t i = 0; i < nodes; ++i) {
                    unsigned char* const to = expected + (start - buffer) + i * stride;
                    memcpy(to + at, vertex[i], 12);
                    if (way > 0) memcpy(to + normal_at, normal(i), 12);
                }
                ok(cd_membrane_write_vertices(m, start, nodes * stride, stride, at, normal_at));
                assert_memory_equal(buffer, expected, sizeof buffer);
            }
        }
    }
    cd_membrane_destroy(m);
}

/* ---- normals against exact ones ---- */

static void tilted(double u, double v, double* x) {
    x[0] = 3 * u + v;
    x[1] = 2 * v - u;
    x[2] = 0.5 * u - 4 * v;
}

static void lying_flat(double u, double v, double* x) {
    x[0] = u;
    x[1] = 3 * v;
}
static void lying_turned(double u, double v, double* x) { lying_flat(-u, v, x); }

static void a_flat_sheet_has_one_normal(void** state) {
    (void)state;
    for (cd_precision precision = CD_FLOAT32; precision <= CD_FLOAT64; ++precision) {
        cd_membrane* m = cloth(9, 5, 3, precision);
        lay(m, tilted);
        draw(m);
        const double x = -1 * -4 - 0.5 * 2, y = 0.5 * 1 - 3 * -4, z = 3 * 2 - -1 * 1, n = sqrt(x * x + y * y + z * z);
        for (size_t i = 0; i < nodes; ++i) check_vector(normal(i), x / n, y / n, z / n, 2e-7);
        cd_membrane_destroy(m);

        for (size_t components = 2; components <= 4; ++components)
            for (int turned = 0; turned < 2; ++turned) {
                cd_membrane* lying = cloth(4, 7, components, precision);
                lay(lying, turned ? lying_turned : lying_flat);
                draw(lying);
                for (size_t i = 0; i < nodes; ++i) check_vector(normal(i), 0, 0, turned ? -1 : 1, 0);
                cd_membrane_destroy(lying);
            }
    }
}

static void slope(double u, double v, double* z) { z[0] = 2 * u - 0.75 * v; }
static void wave(double u, double v, double* z) {
    (void)v;
    z[0] = cos((double)(2 * PI) * u);
}

static void heights_have_the_normals_of_their_graph(void** state) {
    (void)state;
    cd_membrane* m = cloth(8, 5, 1, CD_FLOAT64);
    draw(m);
    for (size_t i = 0; i < nodes; ++i) check_vector(normal(i), 0, 0, 1, 0);
    lay(m, slope);
    draw(m);
    const double n = sqrt(2 * 2 + 0.75 * 0.75 + 1);
    for (size_t i = 0; i < nodes; ++i) check_vector(normal(i), -2 / n, 0.75 / n, 1 / n, 2e-7);
    cd_membrane_destroy(m);

    /* the crest of a wave, at the seam of a ring, is level: the sheet goes on there */
    m = ring_cloth(31, 3, 1, CD_FLOAT64, 1, 0);
    lay(m, wave);
    draw(m);
    for (size_t v = 0; v < 4; ++v) {
        check_vector(normal(32 * v), 0, 0, 1, 2e-7);
        check_vector(normal(32 * v + 16), 0, 0, 1, 2e-7);
    }
    cd_membrane_destroy(m);
}

static void cylinder(double u, double v, double* x) {
    x[0] = cos((double)(2 * PI) * u);
    x[1] = sin((double)(2 * PI) * u);
    x[2] = 3 * v;
}
static void sphere(double u, double v, double* x) { /* a patch of it, from 45 degrees south to 45 north */
    const double height = (double)(PI / 2) * (v - 0.5);
    x[0] = cos(height) * cos(2 * u);
    x[1] = cos(height) * sin(2 * u);
    x[2] = sin(height);
}
static void torus(double u, double v, double* x) {
    const double a = (double)(2 * PI) * u, b = (double)(2 * PI) * v;
    x[0] = (2 + 0.5 * cos(b)) * cos(a);
    x[1] = (2 + 0.5 * cos(b)) * sin(a);
    x[2] = 0.5 * sin(b);
}
static void out_of_torus(double u, double v, double* n) {
    const double a = (double)(2 * PI) * u, b = (double)(2 * PI) * v;
    n[0] = cos(b) * cos(a);
    n[1] = cos(b) * sin(a);
    n[2] = sin(b);
}

/* The largest error of a normal, at nodes with cells all round, of n by n springs. */
static double worst_normal(size_t n, int ring, placing* place, placing* out_of) {
    cd_membrane* m = ring_cloth(n - (size_t)ring, n - (size_t)ring, 3, CD_FLOAT64, ring, ring);
    lay(m, place);
    draw(m);
    const size_t lines = n + 1 - (size_t)ring, edge = ring ? 0 : 1;
    double worst = 0;
    for (size_t v = edge; v + edge < lines; ++v)
        for (size_t u = edge; u + edge < lines; ++u) {
            double exact[3];
            out_of((double)u / (double)n, (double)v / (double)n, exact);
            for (size_t k = 0; k < 3; ++k) worst = fmax(worst, fabs((double)normal(v * lines + u)[k] - exact[k]));
        }
    cd_membrane_destroy(m);
    return worst;
}

static void a_curved_sheet_has_the_normals_of_its_surface(void** state) {
    (void)state;
    for (cd_precision precision = CD_FLOAT32; precision <= CD_FLOAT64; ++precision) {
        cd_membrane* tube = ring_cloth(11, 4, 3, precision, 1, 0);
        lay(tube, cylinder);
        draw(tube);
        for (size_t i = 0; i < nodes; ++i) /* exact: the cells lie in mirror images on either side */
            check_vector(normal(i), cos((double)(PI / 6) * (double)(i % 12)), sin((double)(PI / 6) * (double)(i % 12)),
                         0, 3e-7);
        cd_membrane_destroy(tube);
    }
    static const struct {
        placing *place, *out_of;
        int ring;
    } surfaces[] = {{sphere, sphere, 0}, {torus, out_of_torus, 1}};
    for (size_t i = 0; i < COUNT(surfaces); ++i) {
        const double coarse = worst_normal(16, surfaces[i].ring, surfaces[i].place, surfaces[i].out_of);
        const double fine = worst_normal(32, surfaces[i].ring, surfaces[i].place, surfaces[i].out_of);
        assert_true(coarse < 0.03);
        assert_near(coarse / fine, 4, 0.1, 0); /* second order */
    }
}

/* ---- normals against sums over triangles ---- */

struct shape {
    size_t nu, nv, components;
    int ring_u, ring_v;
};
static const struct shape shapes[] = {{6, 4, 3, 0, 0},  {6, 4, 3, 1, 0},  {5, 4, 3, 0, 1},  {4, 6, 3, 1, 1},
                                      {2, 2, 3, 1, 1},  {1, 1, 3, 0, 0},  {5, 4, 2, 0, 0},  {5, 4, 4, 1, 0},
                                      {5, 4, 1, 0, 0},  {75, 5, 3, 0, 0}, {66, 4, 3, 1, 0}, {70, 4, 2, 0, 1},
                                      {64, 8, 1, 0, 0}, {63, 4, 3, 0, 0}, {64, 3, 3, 1, 0}};

static cd_membrane* make(const struct shape* shape, cd_precision precision) {
    cd_membrane* m = ring_cloth(shape->nu, shape->nv, shape->components, precision, shape->ring_u, shape->ring_v);
    cloth_lay_out(m, 0.5);
    cloth_shake(m, 0.4, 22);
    return m;
}

/* Takes about a third of the nodes out or one in a hundred, and tells which are there. */
static void tear(cd_membrane* m, uint64_t seed, double* out_there) {
    const double share = seed % 2 == 0 ? 0.4 : 0.98;
    for (size_t i = 0; i < sheet_nodes(m); ++i) out_there[i] = scene_noise(&seed) < share;
    ok(cd_membrane_enable_field(m, CD_MASK));
    cloth_write(m, CD_MASK, out_there);
}

static void add_triangle(long double (*sum)[3], size_t a, size_t b, size_t c) {
    long double p[3], q[3];
    for (size_t k = 0; k < 3; ++k) {
        p[k] = (long double)vertex[b][k] - (long double)vertex[a][k];
        q[k] = (long double)vertex[c][k] - (long double)vertex[a][k];
    }
    for (size_t k = 0; k < 3; ++k) {
        const size_t i = (k + 1) % 3, j = (k + 2) % 3;
        (*sum)[k] += p[i] * q[j] - p[j] * q[i];
    }
}

/* Draws the sheet and compares triangles and normals with those of its cells, written down once more. The sheet's
 * positions must be floats. */
static void check_drawing(const cd_membrane* m, const struct shape* shape, const double* there) {
    static long double sum[MOST_NODES][3];
    const size_t columns = shape->nu + 1, rows = shape->nv + 1;
    draw(m);
    memset(sum, 0, nodes * sizeof *sum);
    size_t at = 0;
    for (size_t j = 0; j < shape->nv + (size_t)shape->ring_v; ++j)
        for (size_t i = 0; i < shape->nu + (size_t)shape->ring_u; ++i) {
            const size_t right = (i + 1) % columns, above = (j + 1) % rows;
            const size_t all[4] = {j * columns + i, j * columns + right, above * columns + right, above * columns + i};
            size_t corner[4], corners = 0;
            for (size_t k = 0; k < 4; ++k)
                if (!there || there[all[k]] != 0) corner[corners++] = all[k];
            for (size_t t = 0; t + 2 < corners; ++t, ++at) {
                assert_true(at < triangles);
                assert_int_equal(triangle[at][0], corner[0]);
                assert_int_equal(triangle[at][1], corner[t + 1]);
                assert_int_equal(triangle[at][2], corner[t + 2]);
                for (size_t k = 0; k < corners; ++k)
                    add_triangle(&sum[corner[k]], corner[0], corner[t + 1], corner[t + 2]);
            }
        }
    assert_int_equal(at, triangles);
    for (size_t i = 0; i < nodes; ++i) {
        const long double* n = sum[i];
        const long double size = sqrtl(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]), by = size > 0 ? 1 / size : 0;
        check_vector(normal(i), (double)(n[0] * by), (double)(n[1] * by), (double)(n[2] * by), 2e-7);
    }
}

/* Rounds positions to floats, so that what is drawn is where the nodes are. */
static void round_positions(cd_membrane* m) {
    const struct cloth_extent all = cloth_extent(m, CD_POSITION);
    static float x[MOST_NODES * 4];
    ok(cd_membrane_read_f32(m, CD_POSITION, 0, 0, all.columns, all.rows, x, all.count));
    ok(cd_membrane_write_f32(m, CD_POSITION, 0, 0, all.columns, all.rows, x, all.count));
}

static void normals_are_sums_over_the_cells_that_are_there(void** state) {
    (void)state;
    for (cd_precision precision = CD_FLOAT32; precision <= CD_FLOAT64; ++precision)
        for (size_t s = 0; s < COUNT(shapes); ++s) {
            double there[MOST_NODES];
            cd_membrane* m = make(&shapes[s], precision);
            round_positions(m);
            check_drawing(m, &shapes[s], NULL);
            for (uint64_t seed = 1; seed <= 20; ++seed) {
                tear(m, seed, there);
                check_drawing(m, &shapes[s], there);
            }
            ok(cd_membrane_disable_field(m, CD_MASK));
            check_drawing(m, &shapes[s], NULL);
            cd_membrane_destroy(m);
        }
}

/* ---- normals of sheets of any size, and of none ---- */

static void scale_positions(cd_membrane* m, const double* x, size_t count, double by) {
    double* scaled = malloc(count * sizeof *scaled);
    assert_non_null(scaled);
    for (size_t i = 0; i < count; ++i) scaled[i] = x[i] * by;
    cloth_write(m, CD_POSITION, scaled);
    free(scaled);
}

static void normals_do_not_depend_on_the_size_of_the_sheet(void** state) {
    (void)state;
    static const int powers[] = {-980, -600, -450, -300, -130, -100, 100, 120, 300, 480, 520, 600, 1000, 1023};
    for (cd_precision precision = CD_FLOAT32; precision <= CD_FLOAT64; ++precision) {
        cd_membrane* m = cloth(5, 4, 3, precision);
        cloth_lay_out(m, 0.125);
        cloth_shake(m, 0.1, 23);
        round_positions(m);
        double x[90];
        cloth_read(m, CD_POSITION, x);
        draw(m);
        float expected[30][6];
        memcpy(expected, vertex, sizeof expected);
        for (size_t p = 0; p < COUNT(powers); ++p) {
            if (precision == CD_FLOAT32 && abs(powers[p]) > 120) continue;
            scale_positions(m, x, COUNT(x), ldexp(1, powers[p]));
            draw(m);
            for (size_t i = 0; i < nodes; ++i) assert_same_bits(normal(i), expected[i] + 3, 3);
        }
        for (int e = -30; e <= 30; e += 10) {
            scale_positions(m, x, COUNT(x), pow(10, e));
            draw(m);
            for (size_t i = 0; i < nodes; ++i)
                check_vector(normal(i), (double)expected[i][3], (double)expected[i][4], (double)expected[i][5], 1e-6);
        }
        cd_membrane_destroy(m);
    }
}

static void nodes_far_away_spoil_no_normals_but_their_neighbours(void** state) {
    (void)state;
    const double far[3] = {1e308, -1e307, 1.7e308}, opposite[3] = {-1e308, 1e307, -1.7e308};
    cd_membrane* m = cloth(9, 9, 3, CD_FLOAT64);
    lay(m, lying_flat);
    ok(cd_membrane_write_f64(m, CD_POSITION, 4, 4, 1, 1, far, 3));
    ok(cd_membrane_write_f64(m, CD_POSITION, 5, 5, 1, 1, opposite, 3));
    draw(m);
    for (size_t i = 0; i < nodes; ++i) {
        const size_t u = i % 10, v = i / 10;
        if (u < 3 || u > 6 || v < 3 || v > 6) check_vector(normal(i), 0, 0, 1, 0);
        else if (labs((long)u - (long)v) < 3) assert_near(length(normal(i)), 1, 3e-7, 0);
    }
    cd_membrane_destroy(m);
}

static void tiny_and_far(double u, double v, double* x) {
    x[0] = 0x1p300;
    x[1] = 0x1p-460 * u;
    x[2] = 0x1p-460 * v;
}
static void sheared(double u, double v, double* x) {
    x[0] = u + 0x1p33 * v;
    x[1] = v;
    x[2] = 0;
}

static void thin_and_tiny_sheets_have_normals(void** state) {
    (void)state;
    cd_membrane* m = cloth(8, 4, 3, CD_FLOAT64);
    lay(m, tiny_and_far);
    draw(m);
    for (size_t i = 0; i < nodes; ++i) check_vector(normal(i), 1, 0, 0, 0);
    lay(m, sheared);
    draw(m);
    for (size_t i = 0; i < nodes; ++i) check_vector(normal(i), 0, 0, 1, 0);
    cd_membrane_destroy(m);
}

static void upright(double u, double v, double* x) {
    x[0] = 0;
    x[1] = u;
    x[2] = v;
}

static void what_is_not_finite_has_no_normal(void** state) {
    (void)state;
    cd_membrane* m = cloth(6, 6, 3, CD_FLOAT64);
    cloth_lay_out(m, 0.1);
    cloth_shake(m, 0.05, 24);
    ok(cd_membrane_set_method(m, CD_METHOD_FORWARD_EULER));
    assert_int_equal(cd_membrane_step(m, 1e4, 1000), CD_ERROR_DIVERGED);
    draw(m);
    for (size_t i = 0; i < nodes; ++i) check_vector(normal(i), 0, 0, 0, 0);
    cd_membrane_destroy(m);

    const double away[3] = {1e30, 0, 0};
    m = cloth(6, 6, 3, CD_FLOAT32);
    lay(m, upright);
    draw(m);
    for (size_t i = 0; i < nodes; ++i) check_vector(normal(i), 1, 0, 0, 0);
    ok(cd_membrane_set_stiffness(m, 0, 0));
    ok(cd_membrane_set_gravity(m, away, 3));
    assert_int_equal(cd_membrane_step(m, 1e30, 1), CD_ERROR_DIVERGED); /* along x alone */
    draw(m);
    for (size_t i = 0; i < nodes; ++i) check_vector(normal(i), 0, 0, 0, 0);
    cd_membrane_destroy(m);
}

static void ridge(double u, double v, double* x) { /* folded flat on itself */
    x[0] = fabs(u - 0.5);
    x[1] = v;
    x[2] = 0;
}

static void where_there_is_no_area_there_is_no_normal(void** state) {
    (void)state;
    static const size_t bare[][2] = {{0, 0}, {5, 0}, {0, 5}};
    for (size_t s = 0; s < COUNT(bare); ++s)
        for (size_t components = 1; components <= 3; ++components) {
            cd_membrane* line = cloth(bare[s][0], bare[s][1], components, CD_FLOAT32);
            cloth_shake(line, 1, 25);
            draw(line);
            assert_int_equal(triangles, 0);
            for (size_t i = 0; i < nodes; ++i) check_vector(normal(i), 0, 0, 0, 0);
            ok(cd_membrane_write_indices(line, NULL, 0, 2));
            cd_membrane_destroy(line);
        }
    cd_membrane* m = cloth(8, 6, 3, CD_FLOAT64);
    draw(m); /* all at the origin */
    for (size_t i = 0; i < nodes; ++i) check_vector(normal(i), 0, 0, 0, 0);
    double x[189], along = 0;
    uint64_t seed = 25;
    for (size_t i = 0; i < COUNT(x);
         ++i) { /* all in a line, to the bit, and as far apart as rounds their differences */
        if (i % 3 == 0) along = ldexp(floor(0x1p24 * scene_noise(&seed)), (int)(i / 3 * 7 % 30));
        x[i] = along * (i % 3 == 0 ? 0x1.999999p-4 : i % 3 == 1 ? 0x1.333333p-2 : 0x1.666667p-1);
    }
    cloth_write(m, CD_POSITION, x);
    draw(m);
    for (size_t i = 0; i < nodes; ++i) check_vector(normal(i), 0, 0, 0, 0);
    lay(m, ridge);
    draw(m);
    for (size_t i = 0; i < nodes; ++i) check_vector(normal(i), 0, 0, i % 9 < 4 ? -1 : i % 9 > 4 ? 1 : 0, 0);
    cd_membrane_destroy(m);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(vertices_lie_where_the_nodes_do),
        cmocka_unit_test(only_the_floats_of_a_vertex_are_written),
        cmocka_unit_test(a_flat_sheet_has_one_normal),
        cmocka_unit_test(heights_have_the_normals_of_their_graph),
        cmocka_unit_test(a_curved_sheet_has_the_normals_of_its_surface),
        cmocka_unit_test(normals_are_sums_over_the_cells_that_are_there),
        cmocka_unit_test(normals_do_not_depend_on_the_size_of_the_sheet),
        cmocka_unit_test(nodes_far_away_spoil_no_normals_but_their_neighbours),
        cmocka_unit_test(thin_and_tiny_sheets_have_normals),
        cmocka_unit_test(what_is_not_finite_has_no_normal),
        cmocka_unit_test(where_there_is_no_area_there_is_no_normal),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
