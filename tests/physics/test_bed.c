/* Ropes and cloth on beds of heights: the shape of the bed, rest, slopes, hollows, beds that move. The last component
 * is up. */
#include <math.h>
#include <string.h>

#include "check.h"
#include "cloth.h"
#include "reference.h"

enum { COLUMNS = 33, ROWS = 29, MOST = 441 };
static const double weight[3] = {0, 0, -9.81}, corner[3] = {-2, -1.75, 0.25}, along[2] = {0.125, 0.125};
static double heights[ROWS][COLUMNS];

/* ---- the beds ---------------------------------------------------------------------------------------------------- */

typedef double landscape(double x, double y);
static double hills(double x, double y) { return 0.3 * sin(3 * x) * cos(2 * y + 1); }
static double valley(double x, double y) { return 0.3 * fabs(x) + 0 * y; }
static double steps(double x, double y) { return 0.25 * fmod(floor(4 * (x + y) + 100), 2); }
static double slope(double x, double y) { return 0.4 * x + 0 * y; }

static void raise_bed(landscape* at) {
    for (int j = 0; j < ROWS; ++j)
        for (int i = 0; i < COLUMNS; ++i) heights[j][i] = at(corner[0] + along[0] * i, corner[1] + along[1] * j);
}

/* The integral from -infinity to x of the hat that is 1 at 0 and 0 from -1 and 1 on. */
static double under_hat(double x) {
    const double inside = fmin(fmax(x, -1), 1);
    return inside < 0 ? (1 + inside) * (1 + inside) / 2 : 1 - (1 - inside) * (1 - inside) / 2;
}
/* What height i of `count` counts for at this place: the mean of bilinear interpolation over a quarter of the spacing
 * either side, where beyond the border there are more of the same height. */
static double share_of(int i, int count, double place) {
    double sum = 0;
    for (int k = i == 0 ? -9 : i; k <= (i == count - 1 ? count + 8 : i); ++k)
        sum += (under_hat(place - k + 0.25) - under_hat(place - k - 0.25)) / 0.5;
    return sum;
}
static double height_at(double x, double y) {
    const double u = fmin(fmax((x - corner[0]) / along[0], -5), COLUMNS + 4);
    const double v = fmin(fmax((y - corner[1]) / along[1], -5), ROWS + 4);
    double sum = corner[2];
    for (int j = 0; j < ROWS; ++j) {
        const double share = share_of(j, ROWS, v);
        for (int i = 0; share > 0 && i < COLUMNS; ++i) sum += share * share_of(i, COLUMNS, u) * heights[j][i];
    }
    return sum;
}
/* How far above the bed, along its normal. */
static double gap_of(const double* x) {
    const double e = 1e-6, here = height_at(x[0], x[1]);
    const double a = (height_at(x[0] + e, x[1]) - height_at(x[0] - e, x[1])) / (2 * e);
    const double b = (height_at(x[0], x[1] + e) - height_at(x[0], x[1] - e)) / (2 * e);
    return (x[2] - here) / sqrt(1 + a * a + b * b);
}
static double least_gap(double (*x)[3], size_t nodes) {
    double least = INFINITY;
    for (size_t i = 0; i < nodes; ++i) least = fmin(least, gap_of(x[i]));
    return least;
}
static double fastest(double (*v)[3], size_t nodes) {
    double most = 0;
    for (size_t i = 0; i < nodes; ++i)
        most = fmax(most, sqrt(v[i][0] * v[i][0] + v[i][1] * v[i][1] + v[i][2] * v[i][2]));
    return most;
}

/* ---- ropes ------------------------------------------------------------------------------------------------------- */

static cd_chain* rope_of(size_t strands, size_t nodes, double length, double friction) {
    cd_chain* c;
    ok(cd_chain_create(strands, nodes - 1, 3, CD_FLOAT64, NULL, &c));
    ok(cd_chain_set_rest_length(c, length));
    ok(cd_chain_set_stiffness(c, INFINITY));
    ok(cd_chain_set_lambda(c, 1));
    ok(cd_chain_set_gravity(c, weight, 3));
    ok(cd_chain_set_colliders(c, 1));
    ok(cd_chain_set_bed(c, 0, corner, 3, COLUMNS, ROWS, along[0], along[1], heights[0], ROWS * COLUMNS, friction));
    return c;
}
static void put(cd_chain* c, size_t nodes, double (*x)[3]) {
    ok(cd_chain_write_f64(c, CD_POSITION, 0, 1, 0, nodes, x[0], 3 * nodes));
}
static void get(const cd_chain* c, cd_field field, size_t nodes, double (*x)[3]) {
    ok(cd_chain_read_f64(c, field, 0, 1, 0, nodes, x[0], 3 * nodes));
}
static double energy_of(const cd_chain* c) {
    double e[3];
    ok(cd_chain_get_energy(c, &e[0], &e[1], &e[2]));
    return e[0] + e[1] + e[2];
}
/* A straight line from (x, y, z) along (0.8, 0.6, 0), a little slack. */
static void lay(cd_chain* c, size_t nodes, double length, double x, double y, double z) {
    double at[MOST][3];
    for (size_t i = 0; i < nodes; ++i) {
        const double s = 0.99 * length * (double)i / (double)(nodes - 1);
        at[i][0] = x + 0.8 * s, at[i][1] = y + 0.6 * s, at[i][2] = z;
    }
    put(c, nodes, at);
}

/* Strands of two nodes put on a rough bed stay where they are, and so show its shape: inside of its cells, on creases
 * and beyond its border. */
static void a_bed_is_bilinear_with_round_creases_and_goes_on_beyond_its_border(void** state) {
    (void)state;
    enum { STRANDS = 300 };
    uint64_t seed = 1;
    for (int j = 0; j < ROWS; ++j)
        for (int i = 0; i < COLUMNS; ++i) heights[j][i] = 0.1 * random_number(&seed);
    cd_chain* c = rope_of(STRANDS, 2, 100, 1e3);
    for (size_t s = 0; s < STRANDS; ++s) {
        double x[2][3];
        for (int n = 0; n < 2; ++n) {
            x[n][0] = 2.5 * random_number(&seed), x[n][1] = 2.5 * random_number(&seed);
            if (s % 3 == 0) x[n][0] = corner[0] + along[0] * floor(10 * (1 + random_number(&seed)));
            x[n][2] = height_at(x[n][0], x[n][1]) + 1e-4;
        }
        ok(cd_chain_write_f64(c, CD_POSITION, s, 1, 0, 2, x[0], 6));
    }
    ok(cd_chain_step(c, 1e-3, 200));
    for (size_t s = 0; s < STRANDS; ++s) {
        double x[2][3];
        ok(cd_chain_read_f64(c, CD_POSITION, s, 1, 0, 2, x[0], 6));
        for (int n = 0; n < 2; ++n) assert_near(x[n][2], height_at(x[n][0], x[n][1]), 1e-6, 1);
    }
    cd_chain_destroy(c);
}

/* From rest on a smooth bed a node begins to slide as on the plane that touches the bed there. */
static void the_normal_is_that_of_the_surface(void** state) {
    (void)state;
    enum { STRANDS = 100 };
    uint64_t seed = 2;
    const double dt = 1e-6;
    raise_bed(hills);
    cd_chain* c = rope_of(STRANDS, 2, 100, 0);
    double x[STRANDS][2][3], v[STRANDS][2][3];
    for (size_t s = 0; s < STRANDS; ++s)
        for (int n = 0; n < 2; ++n) {
            x[s][n][0] = 1.7 * random_number(&seed), x[s][n][1] = 1.7 * random_number(&seed);
            x[s][n][2] = height_at(x[s][n][0], x[s][n][1]);
        }
    ok(cd_chain_write_f64(c, CD_POSITION, 0, STRANDS, 0, 2, x[0][0], 6 * STRANDS));
    ok(cd_chain_step(c, dt, 1));
    ok(cd_chain_read_f64(c, CD_VELOCITY, 0, STRANDS, 0, 2, v[0][0], 6 * STRANDS));
    for (size_t s = 0; s < STRANDS; ++s)
        for (int n = 0; n < 2; ++n) {
            const double e = 1e-6, *at = x[s][n];
            const double a = (height_at(at[0] + e, at[1]) - height_at(at[0] - e, at[1])) / (2 * e);
            const double b = (height_at(at[0], at[1] + e) - height_at(at[0], at[1] - e)) / (2 * e);
            const double square = 1 + a * a + b * b, wanted[3] = {-a / square, -b / square, 1 / square - 1};
            for (int k = 0; k < 3; ++k) assert_near(v[s][n][k] / (9.81 * dt), wanted[k], 1e-4, 1);
        }
    cd_chain_destroy(c);
}

/* What is laid over hills, a valley or steps comes to rest on them, and no step gives energy but what takes out of a
 * hollow what the step before went into: with friction none that shows. */
static void a_rope_comes_to_rest_on_hills(void** state) {
    (void)state;
    static landscape* const lands[] = {hills, valley, steps};
    static const double dts[] = {1 / 30.0, 1 / 60.0, 1 / 240.0};
    enum { NODES = 61 };
    double x[NODES][3], v[NODES][3];
    for (size_t l = 0; l < COUNT(lands); ++l)
        for (size_t d = 0; d < COUNT(dts); ++d)
            for (int way = 0; way < 2; ++way) {
                raise_bed(lands[l]);
                cd_chain* c = rope_of(1, NODES, 2, 0.5);
                const double thickness = way ? 0.02 : 0;
                ok(cd_chain_set_lambda(c, way ? 0.5 : 1));
                ok(cd_chain_set_thickness(c, thickness));
                lay(c, NODES, 2, -0.9, -0.7, 0.9);
                double before = energy_of(c), deepest = 0;
                for (int s = 0; s < (int)(6 / dts[d]); ++s) {
                    const cd_status status = cd_chain_step(c, dts[d], 1);
                    if (!(status == CD_OK || (status == CD_ERROR_TOLERANCE && l == 2))) ok(status);
                    const double now = energy_of(c);
                    if (!(now <= before + (l == 2 ? 2e-3 : 1e-6))) fail_msg("energy from %.9g to %.9g", before, now);
                    before = now;
                    if (s % 4) continue;
                    get(c, CD_POSITION, NODES, x);
                    deepest = fmax(deepest, thickness - least_gap(x, NODES));
                }
                get(c, CD_POSITION, NODES, x);
                get(c, CD_VELOCITY, NODES, v);
                print_message("land %zu, dt %.4f: at %.1e m/s, %.1e m inside at most, %.1e at last\n", l, dts[d],
                              fastest(v, NODES), deepest, thickness - least_gap(x, NODES));
                assert_true(fastest(v, NODES) < 2e-3); /* friction that holds creeps */
                assert_true(least_gap(x, NODES) > thickness - 1e-5);
                assert_true(deepest < 0.12);
                cd_chain_destroy(c);
            }
}

/* Without friction it slides through hollows for long. Of 9 J, it never has more by this than at any time before:
 * what went into a hollow is lifted out of it. */
static void hollows_give_no_energy(void** state) {
    (void)state;
    static landscape* const lands[] = {hills, valley};
    static const double dts[] = {1 / 30.0, 1 / 60.0, 1 / 240.0}, most[] = {3e-2, 1e-2, 2e-3};
    enum { NODES = 31 };
    for (size_t l = 0; l < COUNT(lands); ++l)
        for (size_t d = 0; d < COUNT(dts); ++d) {
            raise_bed(lands[l]);
            cd_chain* c = rope_of(1, NODES, 1, 0);
            ok(cd_chain_set_tolerance(c, 1e-9, 200));
            lay(c, NODES, 1, -0.9, -0.7, 0.9);
            double least = energy_of(c), risen = 0;
            for (int s = 0; s < (int)(10 / dts[d]); ++s) {
                ok(cd_chain_step(c, dts[d], 1));
                const double now = energy_of(c);
                risen = fmax(risen, now - least), least = fmin(least, now);
            }
            print_message("land %zu, dt %.4f: the energy rose by %.1e J\n", l, dts[d], risen);
            assert_true(risen < most[d]);
            cd_chain_destroy(c);
        }
}

/* Where the bed is a plane it is met as a plane is: it holds the same, and lets slide the same. Friction is what
 * iterations find, to 1%. */
static void a_sloping_bed_is_a_plane(void** state) {
    (void)state;
    static const double frictions[] = {0, 0.3, 0.5};
    enum { NODES = 21 };
    double x[2][NODES][3];
    raise_bed(slope);
    for (size_t f = 0; f < COUNT(frictions); ++f) {
        for (int plane = 0; plane < 2; ++plane) {
            cd_chain* c = rope_of(1, NODES, 1, frictions[f]);
            const double normal[3] = {-0.4, 0, 1};
            if (plane) ok(cd_chain_set_plane(c, 0, (double[3]){0, 0, corner[2]}, normal, 3, frictions[f]));
            ok(cd_chain_set_tolerance(c, 1e-10, 200));
            lay(c, NODES, 1, 0.7, -0.5, 1.2);
            ok(cd_chain_step(c, 1 / 60.0, 40));
            get(c, CD_POSITION, NODES, x[plane]);
            cd_chain_destroy(c);
        }
        assert_true(least_gap(x[0], NODES) > -1e-9 && least_gap(x[0], NODES) < 1e-3);
        for (size_t i = 0; i < NODES; ++i)
            for (int k = 0; k < 3; ++k) assert_near(x[0][i][k], x[1][i][k], f == 0 ? 1e-7 : 1e-4, 1);
    }
}

/* A bed that moves carries what lies on it, sideways and upwards, and is told where it has come to. */
static void a_moving_bed_carries_what_lies_on_it(void** state) {
    (void)state;
    enum { NODES = 31 };
    double x[2][NODES][3], v[NODES][3], first[3], second[3];
    const double velocity[3] = {0.5, -0.25, 0.125};
    raise_bed(hills);
    cd_chain* c = rope_of(1, NODES, 1, 1);
    lay(c, NODES, 1, -0.4, -0.3, 0.8);
    ok(cd_chain_step(c, 1 / 60.0, 300));
    get(c, CD_POSITION, NODES, x[0]);
    ok(cd_chain_set_collider_velocity(c, 0, velocity, 3));
    get(c, CD_VELOCITY, NODES, v);
    for (size_t i = 0; i < NODES; ++i)
        for (int k = 0; k < 3; ++k) v[i][k] += velocity[k];
    ok(cd_chain_write_f64(c, CD_VELOCITY, 0, 1, 0, NODES, v[0], 3 * NODES));
    ok(cd_chain_step(c, 1 / 60.0, 120));
    get(c, CD_POSITION, NODES, x[1]);
    for (size_t i = 0; i < NODES; ++i)
        for (int k = 0; k < 3; ++k) assert_near(x[1][i][k] - x[0][i][k], 2 * velocity[k], 5e-3, 1);
    ok(cd_chain_get_collider(c, 0, NULL, first, second, NULL, 3, NULL, NULL));
    for (int k = 0; k < 3; ++k) assert_near(first[k], corner[k] + 2 * velocity[k], 1e-12, 1);
    assert_true(second[0] == along[0] && second[1] == along[1] && second[2] == 0);
    cd_chain_destroy(c);
}

/* Thrown at hills at any speed and any way, none falls through. */
static void none_falls_through_however_fast(void** state) {
    (void)state;
    enum { NODES = 21 };
    uint64_t seed = 3;
    double x[NODES][3], v[NODES][3];
    raise_bed(hills);
    for (int round = 0; round < 20; ++round) {
        cd_chain* c = rope_of(1, NODES, 1, 0.4);
        const double speed = round % 2 ? 200 : 20;
        lay(c, NODES, 1, -0.4, -0.3, 0.8);
        for (size_t i = 0; i < NODES; ++i)
            for (int k = 0; k < 3; ++k) v[i][k] = (k == 2 ? -1 : 0.5) * speed * fabs(random_number(&seed));
        ok(cd_chain_write_f64(c, CD_VELOCITY, 0, 1, 0, NODES, v[0], 3 * NODES));
        for (int step = 0; step < 40; ++step) {
            const cd_status status = cd_chain_step(c, 1 / 30.0, 1);
            assert_true(status == CD_OK || status == CD_ERROR_TOLERANCE);
        }
        get(c, CD_POSITION, NODES, x);
        assert_true(least_gap(x, NODES) > -0.1); /* what slides fast through a hollow is inside a little */
        cd_chain_destroy(c);
    }
}

/* With two components the bed is a line of heights. */
static void a_line_of_heights_carries_a_rope_in_the_plane(void** state) {
    (void)state;
    enum { NODES = 41 };
    const double origin[2] = {-1, 0.5}, line[5] = {0.5, 0, 0.25, 0, 0.5}, down[2] = {0, -9.81};
    double x[NODES][2];
    cd_chain* c;
    ok(cd_chain_create(1, NODES - 1, 2, CD_FLOAT64, NULL, &c));
    ok(cd_chain_set_rest_length(c, 1.5));
    ok(cd_chain_set_gravity(c, down, 2));
    ok(cd_chain_set_stiffness(c, 1e4));
    ok(cd_chain_set_colliders(c, 1));
    ok(cd_chain_set_bed(c, 0, origin, 2, 5, 1, 0.5, 0, line, 5, 0.6));
    for (size_t i = 0; i < NODES; ++i) x[i][0] = -0.7 + 1.4 * (double)i / (NODES - 1), x[i][1] = 1.5;
    ok(cd_chain_write_f64(c, CD_POSITION, 0, 1, 0, NODES, x[0], 2 * NODES));
    ok(cd_chain_step(c, 1 / 60.0, 400));
    ok(cd_chain_read_f64(c, CD_POSITION, 0, 1, 0, NODES, x[0], 2 * NODES));
    for (size_t i = 0; i < NODES; ++i) {
        double height = origin[1];
        for (int k = 0; k < 5; ++k) height += line[k] * share_of(k, 5, (x[i][0] - origin[0]) / 0.5);
        assert_true(x[i][1] > height - 1e-5 && x[i][1] < height + 0.3);
    }
    cd_chain_destroy(c);
}

/* ---- cloth ------------------------------------------------------------------------------------------------------- */

/* A square sheet of 1 m and 0.2 kg around (0, 0, height). */
static cd_membrane* sheet_at(size_t springs, double height, double friction) {
    cd_membrane* m = cloth(springs, springs, 3, CD_FLOAT64);
    ok(cd_membrane_set_rest_length(m, 1, 1));
    ok(cd_membrane_set_mass(m, 0.2));
    ok(cd_membrane_set_stiffness(m, 1000, 1000));
    ok(cd_membrane_set_shear(m, 100));
    ok(cd_membrane_set_gravity(m, weight, 3));
    ok(cd_membrane_set_colliders(m, 1));
    ok(cd_membrane_set_bed(m, 0, corner, 3, COLUMNS, ROWS, along[0], along[1], heights[0], ROWS * COLUMNS, friction));
    for (size_t v = 0; v <= springs; ++v)
        for (size_t u = 0; u <= springs; ++u) {
            const double x[3] = {(double)u / (double)springs - 0.5, (double)v / (double)springs - 0.5, height};
            ok(cd_membrane_write_f64(m, CD_POSITION, u, v, 1, 1, x, 3));
        }
    return m;
}
static double energy_of_sheet(const cd_membrane* m) {
    double e[3];
    ok(cd_membrane_get_energy(m, &e[0], &e[1], &e[2]));
    return e[0] + e[1] + e[2];
}

static void cloth_comes_to_rest_on_hills(void** state) {
    (void)state;
    static landscape* const lands[] = {hills, valley, steps};
    static const double dts[] = {1 / 30.0, 1 / 60.0, 1 / 240.0};
    double x[MOST][3], v[MOST][3];
    for (size_t l = 0; l < COUNT(lands); ++l)
        for (size_t d = 0; d < COUNT(dts); ++d) {
            if (!is_taken(l + 2 * d, 3)) continue;
            raise_bed(lands[l]);
            cd_membrane* m = sheet_at(20, 0.9, 1.2);
            const double thickness = d == 1 ? 0.01 : 0;
            ok(cd_membrane_set_thickness(m, thickness));
            double before = energy_of_sheet(m), risen = 0, deepest = 0;
            for (int s = 0; s < (int)(12 / dts[d]); ++s) {
                ok(cd_membrane_step(m, dts[d], 1));
                const double now = energy_of_sheet(m);
                risen = fmax(risen, now - before), before = now;
                if (s % 10) continue;
                cloth_read(m, CD_POSITION, x[0]);
                deepest = fmax(deepest, thickness - least_gap(x, 441));
            }
            cloth_read(m, CD_POSITION, x[0]);
            cloth_read(m, CD_VELOCITY, v[0]);
            print_message("cloth, land %zu, dt %.4f: at %.1e m/s, %.1e m inside at most, %.1e at last, risen %.1e J\n",
                          l, dts[d], fastest(v, 441), deepest, thickness - least_gap(x, 441), risen);
            assert_true(fastest(v, 441) < (l == 2 ? 0.1 : 0.01)); /* what hangs over steps sinks on for long */
            assert_true(least_gap(x, 441) > thickness - 1e-4);
            assert_true(risen < 1e-3);
            cd_membrane_destroy(m);
        }
}

static void cloth_on_a_sloping_bed_is_on_a_plane(void** state) {
    (void)state;
    static const double frictions[] = {0, 0.3, 0.6};
    double x[2][MOST][3];
    raise_bed(slope);
    for (size_t f = 0; f < COUNT(frictions); ++f) {
        for (int plane = 0; plane < 2; ++plane) {
            cd_membrane* m = sheet_at(8, 0.6, frictions[f]);
            const double normal[3] = {-0.4, 0, 1};
            if (plane) ok(cd_membrane_set_plane(m, 0, (double[3]){0, 0, corner[2]}, normal, 3, frictions[f]));
            ok(cd_membrane_step(m, 1 / 60.0, 30));
            cloth_read(m, CD_POSITION, x[plane][0]);
            cd_membrane_destroy(m);
        }
        for (size_t i = 0; i < 81; ++i)
            for (int k = 0; k < 3; ++k) assert_near(x[0][i][k], x[1][i][k], 1e-9, 1);
    }
}

static void a_moving_bed_carries_cloth(void** state) {
    (void)state;
    const double velocity[3] = {0.25, -0.125, 0.0625};
    double x[2][MOST][3];
    raise_bed(hills);
    cd_membrane* m = sheet_at(10, 0.8, 1);
    ok(cd_membrane_step(m, 1 / 60.0, 600));
    cloth_read(m, CD_POSITION, x[0][0]);
    ok(cd_membrane_set_collider_velocity(m, 0, velocity, 3));
    ok(cd_membrane_step(m, 1 / 60.0, 240));
    cloth_read(m, CD_POSITION, x[1][0]);
    double moved[3] = {0, 0, 0};
    for (size_t i = 0; i < 121; ++i)
        for (int k = 0; k < 3; ++k) moved[k] += (x[1][i][k] - x[0][i][k]) / 121;
    print_message("carried by %g %g %g\n", moved[0], moved[1], moved[2]);
    for (int k = 0; k < 3; ++k) assert_near(moved[k], 4 * velocity[k], 0.03, 1);
    cd_membrane_destroy(m);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_bed_is_bilinear_with_round_creases_and_goes_on_beyond_its_border),
        cmocka_unit_test(the_normal_is_that_of_the_surface),
        cmocka_unit_test(a_rope_comes_to_rest_on_hills),
        cmocka_unit_test(hollows_give_no_energy),
        cmocka_unit_test(a_sloping_bed_is_a_plane),
        cmocka_unit_test(a_moving_bed_carries_what_lies_on_it),
        cmocka_unit_test(none_falls_through_however_fast),
        cmocka_unit_test(a_line_of_heights_carries_a_rope_in_the_plane),
        cmocka_unit_test(cloth_comes_to_rest_on_hills),
        cmocka_unit_test(cloth_on_a_sloping_bed_is_on_a_plane),
        cmocka_unit_test(a_moving_bed_carries_cloth),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
