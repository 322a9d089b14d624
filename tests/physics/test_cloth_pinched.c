/* Nodes of cloth that colliders meet from both sides: what comes out sideways is not thrown, and gains nothing. */
#include <math.h>

#include "check.h"
#include "cloth.h"
#include "reference.h"

static const double dt = 1 / 60.0;

/* Nodes of 1/4 kg that nothing joins, all in (0, 0, 0), of which the first one has this velocity. */
static cd_membrane* node(size_t planes, double lambda, const double* velocity) {
    cd_membrane* m = cloth(1, 1, 3, CD_FLOAT64);
    ok(cd_membrane_set_rest_length(m, 1, 1));
    ok(cd_membrane_set_stiffness(m, 0, 0));
    ok(cd_membrane_set_lambda(m, lambda));
    ok(cd_membrane_set_colliders(m, planes));
    ok(cd_membrane_write_f64(m, CD_VELOCITY, 0, 0, 1, 1, velocity, 3));
    return m;
}
/* The node begins this far outside, in units of the normal's length. */
static void set_plane(cd_membrane* m, size_t index, double gap, const double* normal) {
    double point[3];
    for (int k = 0; k < 3; ++k) point[k] = -gap * normal[k];
    ok(cd_membrane_set_plane(m, index, point, normal, 3, 0));
}
static double dot(const double* a, const double* b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/* A node that lies inside one or more of two or three planes that lean towards each other comes out sideways. */
static void what_is_caught_between_planes_is_not_thrown(void** state) {
    (void)state;
    uint64_t seed = 1;
    int thrown = 0;
    for (int n = 0; n < 6000; ++n) {
        const size_t planes = n % 3 ? 2 : 3;
        double way[3], before[3], after[3];
        for (int k = 0; k < 3; ++k) way[k] = random_number(&seed), before[k] = random_number(&seed);
        cd_membrane* m = node(planes, n % 2 ? 0.5 : 1, before);
        for (size_t c = 0; c < planes; ++c) {
            double normal[3];
            for (int k = 0; k < 3; ++k) normal[k] = (c == 1 ? -1 : 1) * way[k] + 0.3 * random_number(&seed);
            set_plane(m, c, 0.05 * random_number(&seed), normal);
        }
        ok(cd_membrane_step(m, dt, 4));
        ok(cd_membrane_read_f64(m, CD_VELOCITY, 0, 0, 1, 1, after, 3));
        thrown += dot(after, after) > 1.02 * dot(before, before);
        cd_membrane_destroy(m);
    }
    print_message("of 6000 nodes between planes %d are thrown\n", thrown);
    assert_true(thrown < 120); /* 2900 where what each of them gave is taken by itself, one after the other */
}

/* Two planes that are nearly one meet a node that has slid between them: what it leaves each of them with, alone no more
 * than it had, together would be. */
static void what_slides_between_planes_gains_nothing(void** state) {
    (void)state;
    const double way[3] = {-0.1993310314489833, 18.936027791227673, 7.491470271513441};
    const double normals[2][3] = {{0.18731900569795987, -0.8954166538761945, 0.40390667989708584},
                                  {-0.19864975984146135, 0.8941222970865521, -0.4013522028936643}};
    double before[3], after[3];
    cd_membrane* m = node(2, 0.6, way);
    set_plane(m, 0, 2.6604768050476905e-05, normals[0]);
    set_plane(m, 1, 4.5391487498681986e-05, normals[1]);
    ok(cd_membrane_step(m, dt, 1));
    ok(cd_membrane_read_f64(m, CD_VELOCITY, 0, 0, 1, 1, before, 3));
    ok(cd_membrane_step(m, dt, 1));
    ok(cd_membrane_read_f64(m, CD_VELOCITY, 0, 0, 1, 1, after, 3));
    print_message("between two planes energy rises by %.1e of it\n", dot(after, after) / dot(before, before) - 1);
    assert_true(dot(after, after) < (1 + 1e-6) * dot(before, before));
    cd_membrane_destroy(m);
}

/* Two planes that move push a node along their normals alone, so that its change of velocity tells what each gave, and
 * with the planes' velocities the work that they did: a node that was outside of both gains no more than that, and where
 * both give something most go as both planes do. */
static void what_moving_planes_give_is_their_work(void** state) {
    (void)state;
    uint64_t seed = 1;
    double worst = -1;
    int met = 0, unlike = 0;
    for (int n = 0; n < 20000; ++n) {
        double way[3], before[3], after[3], change[3], normals[2][3], velocities[2][3];
        for (int k = 0; k < 3; ++k) way[k] = random_number(&seed), before[k] = random_number(&seed);
        cd_membrane* m = node(2, 0.5, before);
        for (size_t c = 0; c < 2; ++c) {
            for (int k = 0; k < 3; ++k) normals[c][k] = (c ? -1 : 1) * way[k] + 0.03 * random_number(&seed);
            const double length = sqrt(dot(normals[c], normals[c]));
            for (int k = 0; k < 3; ++k) normals[c][k] /= length, velocities[c][k] = random_number(&seed);
            set_plane(m, c, 0.01 * fabs(random_number(&seed)), normals[c]);
            ok(cd_membrane_set_collider_velocity(m, c, velocities[c], 3));
        }
        ok(cd_membrane_step(m, dt, 4));
        ok(cd_membrane_read_f64(m, CD_VELOCITY, 0, 0, 1, 1, after, 3));
        cd_membrane_destroy(m);
        for (int k = 0; k < 3; ++k) change[k] = after[k] - before[k];
        const double along = dot(normals[0], normals[1]), first = dot(change, normals[0]),
                     second = dot(change, normals[1]);
        const double give[2] = {(first - along * second) / (1 - along * along),
                                (second - along * first) / (1 - along * along)};
        double gain = (dot(after, after) - dot(before, before)) / 2, off = 0;
        for (int c = 0; c < 2; ++c) {
            gain -= give[c] * dot(normals[c], velocities[c]);
            off = fmax(off, fabs(dot(normals[c], after) - dot(normals[c], velocities[c])));
        }
        worst = fmax(worst, gain / (dot(after, after) + dot(before, before)));
        if (give[0] > 0 && give[1] > 0) ++met, unlike += off > 0.01;
    }
    print_message("%d nodes between planes that move gain at most %.1e beside their work, %d go another way\n", met,
                  worst, unlike);
    assert_true(worst < 1e-12);
    assert_true(unlike < 0.3 * met); /* 0.32 of them where the energy is that of the first plane alone */
}

/* A ball that moves into a floor has soft cloth between: that goes aside, and is then at rest. */
static void a_ball_presses_cloth_aside(void** state) {
    (void)state;
    static const double up[3] = {0, 1, 0}, floor[3] = {0, 0, 0}, first[3] = {0.5, 0.5, 0.5}, down[3] = {0, -0.5, 0};
    static const double lambdas[] = {0.5, 1}, weight[3] = {0, -9.81, 0}, step = 1 / 240.0;
    for (size_t l = 0; l < COUNT(lambdas); ++l) {
        double fastest = 0, v[17 * 17 * 3];
        cd_membrane* m = cloth(16, 16, 3, CD_FLOAT64);
        ok(cd_membrane_set_rest_length(m, 1, 1));
        ok(cd_membrane_set_mass(m, 0.2));
        ok(cd_membrane_set_stiffness(m, 100, 100));
        ok(cd_membrane_set_shear(m, 100));
        ok(cd_membrane_set_bend(m, 1e-5));
        ok(cd_membrane_set_lambda(m, lambdas[l]));
        ok(cd_membrane_set_gravity(m, weight, 3));
        for (size_t i = 0; i < 17 * 17; ++i) {
            const double x[3] = {(double)(i % 17) / 16, 0.005, (double)(i / 17) / 16};
            ok(cd_membrane_write_f64(m, CD_POSITION, i % 17, i / 17, 1, 1, x, 3));
        }
        ok(cd_membrane_set_colliders(m, 2));
        ok(cd_membrane_set_thickness(m, 0.005));
        ok(cd_membrane_set_plane(m, 0, floor, up, 3, 0.4));
        ok(cd_membrane_set_capsule(m, 1, first, first, 3, 0.3, 0.4));
        ok(cd_membrane_set_collider_velocity(m, 1, down, 3));
        for (int n = 0; n < 480; ++n) {
            if (n == 120) ok(cd_membrane_set_collider_velocity(m, 1, floor, 3)); /* it is 5 cm in the floor */
            ok(cd_membrane_step(m, step, 1));
            cloth_read(m, CD_VELOCITY, v);
            for (size_t i = 0; i < COUNT(v); ++i) fastest = fmax(fastest, fabs(v[i]));
        }
        print_message("lambda %g: a ball at 0.5 m/s presses cloth aside, at %.2f m/s at most\n", lambdas[l], fastest);
        assert_true(fastest < 4); /* 11 and 200 m/s where what each collider gave is taken by itself */
        cd_membrane_destroy(m);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_is_caught_between_planes_is_not_thrown),
        cmocka_unit_test(what_slides_between_planes_gains_nothing),
        cmocka_unit_test(what_moving_planes_give_is_their_work),
        cmocka_unit_test(a_ball_presses_cloth_aside),
    };
    return cmocka_run_group_tests_name("cloth between colliders", tests, NULL, NULL);
}
