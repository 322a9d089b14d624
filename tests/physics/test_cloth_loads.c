/* What cloth does to what it touches: Newton's third law, and what must bear a sheet at rest. */
#include <math.h>
#include <string.h>

#include "check.h"
#include "cloth.h"
#include "loads.h"

enum { MOST = 16 * 16, COLLIDERS = 5 };
static const double gravity[3] = {0, 0, -9.81}, nowhere[3] = {0};
static double ball_radius = 0.25;

static void get_load(const cd_membrane* m, size_t index, double* out) {
    ok(cd_membrane_get_collider_load(m, index, out, 6));
}
/* The loads of all colliders together. */
static void get_sum(const cd_membrane* m, double* out) {
    size_t count;
    ok(cd_membrane_get_colliders(m, &count));
    memset(out, 0, 6 * sizeof *out);
    for (size_t i = 0; i < count; ++i) {
        double one[6];
        get_load(m, i, one);
        add_load(out, one);
    }
}

/* A level sheet of so many springs, of 1 m and 0.2 kg at this height. */
static cd_membrane* sheet(size_t springs, cd_precision precision, double height, double stiffness) {
    cd_membrane* const m = cloth(springs, springs, 3, precision);
    ok(cd_membrane_set_rest_length(m, 1, 1));
    ok(cd_membrane_set_stiffness(m, stiffness, stiffness));
    ok(cd_membrane_set_mass(m, 0.2));
    ok(cd_membrane_set_gravity(m, gravity, 3));
    double x[MOST][3];
    const size_t n = springs + 1;
    for (size_t i = 0; i < n * n; ++i)
        x[i][0] = (double)(i % n) / (double)springs, x[i][1] = (double)(i / n) / (double)springs, x[i][2] = height;
    cloth_write(m, CD_POSITION, x[0]);
    ok(cd_membrane_set_loads(m, 1));
    return m;
}

/* A sheet above bodies of every kind, in the air; by its first edge it may be held. */
static cd_membrane* scene(uint64_t seed, cd_precision precision, int held) {
    uint64_t draw = 7919 * seed + 1;
    const size_t springs = 4 + (size_t)(11 * part(&draw));
    cd_membrane* const m = sheet(springs, precision, 0.35, 300 * part(&draw));
    if (part(&draw) < 0.5) ok(cd_membrane_set_bend(m, 1e-3));
    if (part(&draw) < 0.5) ok(cd_membrane_set_shear(m, 10));
    ok(cd_membrane_set_lambda(m, held || part(&draw) < 0.5 ? 1 : 0.5 + 0.5 * part(&draw)));
    if (held) ok(cd_membrane_set_edge(m, CD_EDGE_U_FIRST, CD_NODE_PINNED));
    cloth_shake(m, 0.3 / (double)springs, seed);
    const double friction = part(&draw), a[3] = {0.2, 0.2, 0}, b[3] = {0.6, 0.2 + part(&draw), 0}, up[3] = {0.1, 0, 1};
    double heights[36];
    ok(cd_membrane_set_colliders(m, COLLIDERS)); /* number 3 stays none */
    ok(cd_membrane_set_plane(m, 0, nowhere, up, 3, friction));
    ok(cd_membrane_set_capsule(m, 1, a, b, 3, 0.1 + 0.2 * part(&draw), friction));
    const double velocity[3] = {part(&draw) - 0.5, part(&draw) - 0.5, 0.2}, origin[3] = {0.8, 0.8, 0};
    if (part(&draw) < 0.5) ok(cd_membrane_set_collider_velocity(m, 1, velocity, 3));
    ok(cd_membrane_set_callback(m, 2, &(cd_distance){&ball_radius, ball}, origin, 3, friction));
    for (int i = 0; i < 36; ++i) heights[i] = 0.2 * part(&draw);
    const double corner[3] = {-0.1, -0.1, -0.1};
    ok(cd_membrane_set_bed(m, 4, corner, 3, 6, 6, 0.25, 0.25, heights, 36, 0.3));
    return m;
}

static double momentum_of(const cd_membrane* m, double* out) {
    double energy;
    ok(cd_membrane_get_momentum(m, out, 3));
    ok(cd_membrane_get_energy(m, &energy, NULL, NULL));
    return sqrt(2 * 0.2 * energy); /* the most that its nodes' may be together */
}

/* Steps a scene, and checks that its momentum changes as it should, but for `error` times what it is given. */
static size_t check_scene(uint64_t seed, cd_precision precision, int held, double error) {
    cd_membrane* const m = scene(seed, precision, held);
    const double dt = seed % 2 ? 1.0 / 60 : 1.0 / 200;
    const struct cloth_extent nodes = cloth_extent(m, CD_POSITION);
    const double moving = held ? (double)(nodes.columns - 1) / (double)nodes.columns : 1;
    size_t touched = 0;
    if (held) ok(cd_membrane_set_compression(m, 0)); /* whose forces are those of where a step begins */
    if (held) ok(cd_membrane_set_effort(m, 200, 2000));
    for (int i = 0; i < 40; ++i) {
        double before[3], after[3], load[6], none[6], gains[3], given = dt * 0.2 * 9.81;
        given += momentum_of(m, before);
        ok(cd_membrane_step(m, dt, 1));
        given += momentum_of(m, after);
        get_sum(m, load);
        for (int k = 0; k < 3; ++k) gains[k] = after[k] - before[k] - dt * (0.2 * moving * gravity[k] - load[k]);
        for (size_t v = 0; v < nodes.rows && held; ++v) {
            double force[3];
            ok(cd_membrane_get_reaction(m, 0, v, force, 3));
            for (int k = 0; k < 3; ++k) gains[k] += dt * force[k];
        }
        touched += size_of(load) > 0;
        if (!(size_of(gains) <= error * given))
            print_message("seed %llu, step %d: %g of %g\n", (unsigned long long)seed, i, size_of(gains), given);
        assert_near(size_of(gains), 0, error, given);
        get_load(m, 3, none);
        for (int k = 0; k < 6; ++k) assert_true(none[k] == 0);
    }
    cd_membrane_destroy(m);
    return touched;
}
static void what_cloth_gains_colliders_lose(void** state) {
    (void)state;
    size_t touched = 0, steps = 0;
    const uint64_t most = is_long() ? 400 : 40;
    for (uint64_t seed = other_scenes(); seed < other_scenes() + most; ++seed) {
        touched += check_scene(seed, CD_FLOAT64, 0, 1e-12), steps += 40;
        check_scene(seed, CD_FLOAT32, 0, 1e-5);
        if (seed % 4 == 0) check_scene(seed, CD_FLOAT64, 1, 1e-3);
    }
    assert_true(touched > steps / 2);
}

/* A sheet that lies on a plane, level or a slope that holds it, and one draped over a ball. */
static void what_rests_bears_with_its_weight(void** state) {
    (void)state;
    for (int precision = CD_FLOAT32; precision <= CD_FLOAT64; ++precision)
        for (int slope = 0; slope <= 1; ++slope) {
            cd_membrane* const m = sheet(8, precision, 0.3, 100);
            const double normal[3] = {slope ? 0.2 : 0, 0, 1}, error = precision == CD_FLOAT64 ? 1e-9 : 1e-5;
            double load[6], x[81][3], middle[2] = {0};
            ok(cd_membrane_set_colliders(m, 2));
            ok(cd_membrane_set_thickness(m, 0.01));
            ok(cd_membrane_set_plane(m, 1, nowhere, normal, 3, 0.8));
            ok(cd_membrane_step(m, 1.0 / 60, 900));
            get_load(m, 1, load);
            cloth_read(m, CD_POSITION, x[0]);
            for (int i = 0; i < 81; ++i) middle[0] += x[i][0] / 81, middle[1] += x[i][1] / 81;
            const double force = 0.2 * 9.81;
            for (int k = 0; k < 3; ++k) assert_near(load[k], k == 2 ? -force : 0, slope ? 1e-5 : error, force);
            assert_near(load[3], -middle[1] * force, slope ? 1e-5 : error, force);
            assert_near(load[4], middle[0] * force, slope ? 1e-5 : error, force);
            assert_near(load[5], 0, slope ? 1e-5 : error, force);
            cd_membrane_destroy(m);
        }
    cd_membrane* const m = sheet(12, CD_FLOAT64, 0.3, 100);
    const double at[3] = {0.5, 0.5, 0};
    double load[6];
    ok(cd_membrane_set_drag(m, 5));
    ok(cd_membrane_set_colliders(m, 1));
    ok(cd_membrane_set_capsule(m, 0, at, at, 3, 0.25, 0.8));
    ok(cd_membrane_step(m, 1.0 / 60, 600));
    get_load(m, 0, load);
    for (int k = 0; k < 3; ++k) assert_near(load[k], k == 2 ? -0.2 * 9.81 : 0, 1e-2, 0.2 * 9.81);
    cd_membrane_destroy(m);
}

/* A sheet that slides down a smooth slope against a wall: each bears what it should, and nothing else. (In 20 s it would
 * fall over aside: what is pressed buckles, and nothing damps that.) */
static void a_corner_shares_what_lies_in_it(void** state) {
    (void)state;
    const double side[3] = {-3, 0, -9.81}, up[3] = {0, 0, 1}, out[3] = {1, 0, 0};
    cd_membrane* const m = sheet(4, CD_FLOAT64, 0, 100);
    double load[6];
    ok(cd_membrane_set_gravity(m, side, 3));
    ok(cd_membrane_set_compression(m, 1000)); /* or it would crumple */
    ok(cd_membrane_set_drag(m, 5));
    ok(cd_membrane_set_colliders(m, 2));
    ok(cd_membrane_set_plane(m, 0, nowhere, up, 3, 0));
    ok(cd_membrane_set_plane(m, 1, nowhere, out, 3, 0));
    ok(cd_membrane_step(m, 1.0 / 60, 300));
    get_load(m, 0, load);
    for (int k = 0; k < 3; ++k) assert_near(load[k], k == 2 ? -0.2 * 9.81 : 0, 1e-6, 1);
    get_load(m, 1, load);
    for (int k = 0; k < 3; ++k) assert_near(load[k], k == 0 ? -0.2 * 3 : 0, 1e-6, 1);
    cd_membrane_destroy(m);
}

/* A stiff sheet that is held and comes to lie on a ball's top: what the step leaves of the sheet's fall is no load. */
static void a_held_sheet_bears_by_what_touches(void** state) {
    (void)state;
    const double at[3] = {0.5, 0.5, 0};
    double load[2][6];
    for (int all = 0; all < 2; ++all) {
        cd_membrane* const m = sheet(12, CD_FLOAT64, 0.3, 3000);
        ok(cd_membrane_set_edge(m, CD_EDGE_U_FIRST, CD_NODE_PINNED));
        ok(cd_membrane_set_colliders(m, 1));
        ok(cd_membrane_set_capsule(m, 0, at, at, 3, 0.3, 0.3));
        if (all) ok(cd_membrane_set_effort(m, 100, 2000));
        ok(cd_membrane_step(m, 1.0 / 60, 2));
        get_load(m, 0, load[all]);
        cd_membrane_destroy(m);
    }
    for (int k = 0; k < 3; ++k) assert_near(load[0][k], load[1][k], 0.01, 0.2 * 9.81);
}

/* What sleeps bears as before; loads are a part of the state, and go with it. */
static void what_sleeps_bears_on(void** state) {
    (void)state;
    static unsigned char bytes[1 << 16];
    const double up[3] = {0, 0, 1};
    size_t size, awake;
    double load[6], told[6];
    cd_membrane *const m = sheet(5, CD_FLOAT64, 0.1, 100), *const other = cloth(5, 5, 3, CD_FLOAT64),
                       *const copy = cloth(5, 5, 3, CD_FLOAT64);
    ok(cd_membrane_set_colliders(m, 2));
    ok(cd_membrane_set_plane(m, 1, nowhere, up, 3, 0.5));
    ok(cd_membrane_set_sleep(m, 0.01, 0.5));
    ok(cd_membrane_step(m, 1.0 / 60, 300));
    ok(cd_membrane_get_awake(m, &awake));
    assert_true(awake == 0);
    get_load(m, 1, load);
    assert_near(load[2], -0.2 * 9.81, 1e-6, 1);
    ok(cd_membrane_save(m, bytes, sizeof bytes, &size));
    ok(cd_membrane_load(other, bytes, size));
    ok(cd_membrane_copy_state(copy, m));
    for (int which = 0; which < 3; ++which) {
        cd_membrane* const o = which == 0 ? m : which == 1 ? copy : other;
        ok(cd_membrane_step(o, 1.0 / 60, 1));
        get_load(o, 1, told);
        assert_same_bits(told, load, 6);
        ok(cd_membrane_reset(o));
        get_load(o, 1, told);
        for (int k = 0; k < 6; ++k) assert_true(told[k] == 0);
        cd_membrane_destroy(o);
    }
}

/* What is noted changes nothing. */
static void loads_change_no_step(void** state) {
    (void)state;
    for (uint64_t seed = 0; seed < 10; ++seed) {
        cd_membrane *const m = scene(seed, CD_FLOAT64, 0), *const untold = scene(seed, CD_FLOAT64, 0);
        ok(cd_membrane_set_loads(untold, 0));
        ok(cd_membrane_step(m, 1.0 / 60, 20));
        ok(cd_membrane_step(untold, 1.0 / 60, 20));
        ok(cd_membrane_set_loads(m, 0));
        assert_true(hash_of(m) == hash_of(untold));
        cd_membrane_destroy(m), cd_membrane_destroy(untold);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_cloth_gains_colliders_lose),    cmocka_unit_test(what_rests_bears_with_its_weight),
        cmocka_unit_test(a_corner_shares_what_lies_in_it),    cmocka_unit_test(what_sleeps_bears_on),
        cmocka_unit_test(a_held_sheet_bears_by_what_touches), cmocka_unit_test(loads_change_no_step),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
