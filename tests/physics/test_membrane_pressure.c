/* Volume against exact shapes, and pressure as its gradient: forces on nodes, their sum, and a drum head that it
 * inflates. */
#include <math.h>
#include <stdlib.h>

#include "check.h"
#include "grid.h"
#include "reference.h"
#include "sheet.h"

static double volume_of(const cd_membrane* m) {
    double volume;
    ok(cd_membrane_get_volume(m, &volume));
    return volume;
}

static cd_membrane* make(size_t nu, size_t nv, int ring_u, int ring_v, cd_precision precision) {
    cd_membrane* m = NULL;
    ok(cd_membrane_create(nu, nv, 3, precision, NULL, &m));
    ok(cd_membrane_set_solver(m, CD_SOLVER_ALTERNATING));
    ok(cd_membrane_set_ring(m, ring_u, ring_v));
    return m;
}

/* Puts node (u, v) to shape(u, v). */
typedef void shape(double u, double v, double* out_x);
static void lay_out(cd_membrane* m, shape* place, double per_u, double per_v) {
    size_t nu, nv;
    ok(cd_membrane_get_shape(m, &nu, &nv, NULL, NULL));
    for (size_t v = 0; v <= nv; ++v)
        for (size_t u = 0; u <= nu; ++u) {
            double x[3];
            place((double)u / per_u, (double)v / per_v, x);
            ok(cd_membrane_write_f64(m, CD_POSITION, u, v, 1, 1, x, 3));
        }
}

/* ---- volume ------------------------------------------------------------------------------------------------------ */

static void level(double u, double v, double* x) { x[0] = 2 * u, x[1] = 3 * v, x[2] = 0.75; }
static void slope(double u, double v, double* x) { x[0] = 2 * u, x[1] = 3 * v, x[2] = 0.5 * u + 0.25 * v; }
static void tent(double u, double v, double* x) { x[0] = u, x[1] = v, x[2] = fmin(u, 1 - u) * 2; }
static void drum(double u, double v, double* x) { x[0] = u, x[1] = v, x[2] = 16 * u * (1 - u) * v * (1 - v); }
/* u goes round, v along the axis: the normal x_u x x_v points outwards. */
static void prism(double u, double v, double* x) {
    const double t = 2 * (double)PI * u;
    x[0] = 1.5 * cos(t), x[1] = 1.5 * sin(t), x[2] = 2 * v - 0.5;
}
static void ball(double u, double v, double* x) {
    const double t = 2 * (double)PI * u, p = (double)PI * (v - 0.5);
    x[0] = 1 + 2 * cos(t) * cos(p), x[1] = 2 * sin(t) * cos(p) - 3, x[2] = 2 * sin(p);
}
static void torus(double u, double v, double* x) {
    const double t = 2 * (double)PI * u, p = 2 * (double)PI * v, r = 2 + 0.5 * cos(p);
    x[0] = r * cos(t), x[1] = 5 + r * sin(t), x[2] = 0.5 * sin(p);
}

/* Over the square [0, 2] x [0, 3]: what lies between the sheet and the origin is a pyramid, a third of a prism; where
 * the rim lies in the plane of the origin, all that is under the sheet. Cylinders are pyramids over every face. */
static void volumes_of_flat_faced_shapes_are_exact(void** state) {
    (void)state;
    for (int p = 0; p < 2; ++p) {
        const cd_precision precision = p ? CD_FLOAT64 : CD_FLOAT32;
        const double allowed = p ? 1e-14 : 1e-6;
        cd_membrane* m = make(8, 5, 0, 0, precision);
        lay_out(m, level, 8, 5);
        assert_near(volume_of(m), 2 * 3 * 0.75 / 3, allowed, 0);
        lay_out(m, slope, 8, 5); /* the plane goes through the origin */
        assert_near(volume_of(m), 0, allowed, 1);
        lay_out(m, tent, 8, 5); /* 1/2 under it, less a third of its two gables: they are seen from the origin */
        assert_near(volume_of(m), 0.5 - 0.5 * 1 / 3, allowed, 0);
        cd_membrane_destroy(m);
        m = make(11, 4, 1, 0, precision);
        lay_out(m, prism, 12, 4);
        const double base = 12 * 1.5 * 1.5 / 2 * sin((double)PI / 6); /* of a polygon of 12 corners */
        assert_near(volume_of(m), 2 * base * 2 / 3, allowed, 0);
        cd_membrane_destroy(m);
    }
}

static void volumes_of_round_shapes_are_second_order(void** state) {
    (void)state;
    static const struct {
        const char* name;
        shape* place;
        int ring_u, ring_v;
        double exact;
    } shapes[] = {{"drum head", drum, 0, 0, 16.0 / 36},
                  {"ball", ball, 1, 0, 32 * 3.14159265358979323846 / 3},
                  {"torus", torus, 1, 1, 3.14159265358979323846 * 3.14159265358979323846}};
    for (size_t k = 0; k < COUNT(shapes); ++k) {
        double before = 0, order = 0, error = 0;
        for (size_t n = 8; n <= 64; n *= 2) {
            cd_membrane* m = make(shapes[k].ring_u ? n - 1 : n, shapes[k].ring_v ? n - 1 : n, shapes[k].ring_u,
                                  shapes[k].ring_v, CD_FLOAT64);
            lay_out(m, shapes[k].place, (double)n, (double)n);
            error = fabs(volume_of(m) - shapes[k].exact) / shapes[k].exact;
            order = log2(before / error);
            before = error;
            cd_membrane_destroy(m);
        }
        print_message("%-9s volume to %.1e with 64 x 64 springs, order %.2f\n", shapes[k].name, error, order);
        assert_true(fabs(order - 2) < 0.1);
    }
}

/* Moved away from the origin a closed surface holds the same volume; turned inside out, minus that. */
static void a_closed_surface_holds_its_volume_wherever_it_is(void** state) {
    (void)state;
    enum { N = 9, COUNT_X = N * N * 3 };
    cd_membrane* m = make(N - 1, N - 1, 1, 1, CD_FLOAT64);
    double x[COUNT_X], y[COUNT_X];
    uint64_t seed = 4;
    lay_out(m, torus, N, N);
    sheet_read(m, CD_POSITION, x);
    for (size_t i = 0; i < COUNT_X; ++i) x[i] += 0.2 * random_number(&seed);
    sheet_write(m, CD_POSITION, x);
    const double volume = volume_of(m);
    assert_true(volume > 1);
    for (size_t i = 0; i < COUNT_X; ++i) y[i] = x[i] + 10 * (double)(1 + i % 3);
    sheet_write(m, CD_POSITION, y);
    assert_near(volume_of(m), volume, 1e-11, 0);
    for (size_t i = 0; i < COUNT_X; ++i) y[i] = -x[i];
    sheet_write(m, CD_POSITION, y);
    assert_near(volume_of(m), -volume, 1e-13, 0);
    cd_membrane_destroy(m);
}

/* ---- the force of pressure --------------------------------------------------------------------------------------- */

enum { NU = 7, NV = 5 };

/* A random sheet, some of it masked away, open or closed. */
static cd_membrane* make_crumpled(int ring_u, int ring_v, int masked) {
    cd_membrane* m = make(NU, NV, ring_u, ring_v, CD_FLOAT64);
    double x[(NU + 1) * (NV + 1) * 3];
    uint64_t seed = 6;
    for (size_t i = 0; i < COUNT(x); ++i) x[i] = random_number(&seed);
    sheet_write(m, CD_POSITION, x);
    if (masked) {
        ok(cd_membrane_enable_field(m, CD_MASK));
        sheet_set(m, CD_MASK, 0, 0, 0);
        sheet_set(m, CD_MASK, 4, 3, 0);
    }
    return m;
}

/* Whether all cells around a node are there: at a border the volume changes with the cone over the border as well,
 * which is no part of the sheet and is not pushed. */
static int is_surrounded(int kind, size_t node) {
    const int ring_u = kind & 1, ring_v = kind >> 1 & 1, masked = kind >> 2;
    const int u = (int)(node % (NU + 1)), v = (int)(node / (NU + 1)), away[2][2] = {{0, 0}, {4, 3}};
    if (!ring_u && (u == 0 || u == NU)) return 0;
    if (!ring_v && (v == 0 || v == NV)) return 0;
    for (int k = 0; k < 2 && masked; ++k) {
        const int du = abs(u - away[k][0]), dv = abs(v - away[k][1]);
        if ((du < 2 || (ring_u && du == NU)) && (dv < 2 || (ring_v && dv == NV))) return 0;
    }
    return 1;
}

/* With no springs a step of dt = 1 from rest gives every node a velocity of force / mass. The volume is linear in each
 * node's place, so that a difference over any distance is its gradient. */
static void pressure_pushes_along_the_gradient_of_volume(void** state) {
    (void)state;
    for (int kind = 0; kind < 8; ++kind)
        for (int solver = 0; solver < 2; ++solver) {
            cd_membrane* m = make_crumpled(kind & 1, kind >> 1 & 1, kind >> 2);
            const double pressure = -1.75;
            size_t nu, nv;
            ok(cd_membrane_get_shape(m, &nu, &nv, NULL, NULL));
            ok(cd_membrane_set_stiffness(m, 0, 0));
            ok(cd_membrane_set_mass(m, (double)((nu + 1) * (nv + 1))));
            double x[(NU + 1) * (NV + 1) * 3], v[(NU + 1) * (NV + 1) * 3];
            sheet_read(m, CD_POSITION, x);
            double gradient[(NU + 1) * (NV + 1) * 3];
            for (size_t i = 0; i < COUNT(x); ++i) {
                double there[2];
                for (int way = 0; way < 2; ++way) {
                    const double before = x[i];
                    x[i] += way ? 0.5 : -0.5;
                    sheet_write(m, CD_POSITION, x);
                    there[way] = volume_of(m);
                    x[i] = before;
                }
                gradient[i] = there[1] - there[0];
            }
            sheet_write(m, CD_POSITION, x);
            ok(cd_membrane_set_pressure(m, pressure));
            ok(cd_membrane_set_solver(m, solver));
            sheet_step(m, 1, 1);
            sheet_read(m, CD_VELOCITY, v);
            double largest = 0;
            for (size_t i = 0; i < COUNT(x); ++i) largest = fmax(largest, fabs(pressure * gradient[i]));
            for (size_t i = 0; i < COUNT(x); ++i)
                if (is_surrounded(kind, i / 3)) assert_near(v[i], pressure * gradient[i], 1e-12, largest);
            cd_membrane_destroy(m);
        }
}

/* A closed surface is not pushed anywhere; an open one by pressure times the area of its rim's shadow. */
static void the_forces_of_pressure_add_up(void** state) {
    (void)state;
    const double pressure = 3, dt = 1.0 / 64;
    double momentum[3];
    for (int p = 0; p < 2; ++p) {
        cd_membrane* m = make(15, 15, 1, 1, p ? CD_FLOAT64 : CD_FLOAT32);
        lay_out(m, torus, 16, 16);
        ok(cd_membrane_set_pressure(m, pressure));
        ok(cd_membrane_step(m, dt, 1));
        ok(cd_membrane_get_momentum(m, momentum, 3));
        for (int c = 0; c < 3; ++c) assert_near(momentum[c], 0, p ? 1e-12 : 1e-5, pressure * dt);
        cd_membrane_destroy(m);
        m = make(16, 10, 0, 0, p ? CD_FLOAT64 : CD_FLOAT32);
        lay_out(m, slope, 16, 10); /* over [0, 2] x [0, 3], slopes 1/4 and 1/12 */
        ok(cd_membrane_set_pressure(m, pressure));
        ok(cd_membrane_step(m, dt, 1));
        ok(cd_membrane_get_momentum(m, momentum, 3));
        const double area[3] = {-6 * 0.25, -6 * 0.25 / 3, 6};
        double third[3]; /* the rim is seen from the origin, in whose plane the sheet lies: no force from there */
        for (int c = 0; c < 3; ++c) third[c] = pressure * dt * area[c];
        for (int c = 0; c < 3; ++c) assert_near(momentum[c], third[c], p ? 1e-12 : 1e-5, pressure * dt);
        cd_membrane_destroy(m);
    }
}

/* u_xx + u_yy = -1 on the unit square, 0 on its rim: a series that converges like exp(-pi n). */
static double poisson(double x, double y) {
    double sum = 0;
    for (int n = 1; n < 400; n += 2) {
        const double t = n * (double)PI, far = t * (y - 0.5);
        const double decay = (exp(far - t / 2) + exp(-far - t / 2)) / (1 + exp(-t)); /* cosh over cosh */
        sum += 4 / (t * t * t) * sin(t * x) * (1 - decay);
    }
    return sum;
}

static void flat(double u, double v, double* x) { x[0] = u, x[1] = v, x[2] = 0; }

/* Stretched flat over the unit square with its rim pinned, tension 2 each way: a slight pressure p lifts it by p / 2
 * times the solution of Poisson's equation, at any dt and with both solvers. */
static void a_pressed_drum_rises_as_poisson_says_to_second_order(void** state) {
    (void)state;
    const double pressure = 1e-4, tension = 2;
    for (int solver = 0; solver < 2; ++solver) {
        double before = 0, order = 0, error = 0, volume = 0;
        for (size_t n = 8; n <= 32; n *= 2) {
            cd_membrane* m = make(n, n, 0, 0, CD_FLOAT64);
            ok(cd_membrane_set_mass_rule(m, CD_MASS_HALF_ENDS));
            ok(cd_membrane_set_stiffness(m, tension, tension));
            ok(cd_membrane_set_lambda(m, 1));
            ok(cd_membrane_set_solver(m, solver));
            for (cd_edge e = CD_EDGE_U_FIRST; e <= CD_EDGE_V_LAST; ++e) ok(cd_membrane_set_edge(m, e, CD_NODE_PINNED));
            lay_out(m, flat, (double)n, (double)n);
            ok(cd_membrane_set_pressure(m, pressure));
            sheet_step(m, solver ? 100 : 0.05, solver ? 20 : 1000);
            error = 0;
            for (size_t v = 0; v <= n; ++v)
                for (size_t u = 0; u <= n; ++u) {
                    double x[3];
                    ok(cd_membrane_read_f64(m, CD_POSITION, u, v, 1, 1, x, 3));
                    const double exact = poisson((double)u / (double)n, (double)v / (double)n);
                    error = fmax(error, fabs(x[2] * tension / pressure - exact));
                }
            volume = volume_of(m) * tension / pressure;
            order = log2(before / error);
            before = error;
            cd_membrane_destroy(m);
        }
        print_message("%s: pressed drum to %.1e of 0.0737 at 32 x 32, order %.2f, volume %.5f of 0.03514\n",
                      solver ? "coupled" : "alternating", error, order, volume);
        assert_true(fabs(order - 2) < 0.1);
        assert_true(error < 1e-4);
        assert_near(volume, 0.0351443, 5e-3, 0);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(volumes_of_flat_faced_shapes_are_exact),
        cmocka_unit_test(volumes_of_round_shapes_are_second_order),
        cmocka_unit_test(a_closed_surface_holds_its_volume_wherever_it_is),
        cmocka_unit_test(pressure_pushes_along_the_gradient_of_volume),
        cmocka_unit_test(the_forces_of_pressure_add_up),
        cmocka_unit_test(a_pressed_drum_rises_as_poisson_says_to_second_order),
    };
    return cmocka_run_group_tests_name("membrane pressure", tests, NULL, NULL);
}
