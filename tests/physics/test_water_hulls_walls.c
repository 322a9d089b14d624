/* Walls within the water and cells that are not there stop hulls, and part them from what lies behind. */
#include <math.h>

#include "check.h"
#include "pool.h"

enum { NX = 40, NY = 24, MIDDLE = 20 };
#define DX 0.25
#define LENGTH (NX * DX)
#define WIDTH (NY * DX)
#define LONG 2.0
#define WIDE 1.0
#define MASS 400.0
#define DT (1 / 60.0)

static cd_water* lake(void) {
    cd_water* w;
    ok(cd_water_create(NX, NY, DX, DX, CD_FLOAT64, NULL, &w));
    pool_fill(w, CD_DEPTH, 1);
    ok(cd_water_set_hulls(w, 1, 4, 2));
    ok(cd_water_set_hull(w, 0, MASS, LONG, WIDE, NULL, 0));
    return w;
}

/* Across the lake at x = LENGTH / 2, rows [first, end): as a wall, or as a column of cells that are not there. */
enum closed { WALL, NO_CELLS, KINDS };
static void close(cd_water* w, enum closed kind, size_t first, size_t end) {
    const cd_field field = kind == WALL ? CD_WALL_X : CD_MASK;
    ok(cd_water_enable_field(w, field));
    for (size_t j = first; j < end; ++j) pool_set(w, field, MIDDLE, j, kind == WALL);
}

/* Half of what the hull takes along x, of a hull that lies as the pose says. */
static double half_of(const double* pose) { return 0.5 * (LONG * fabs(pose[3]) + WIDE * fabs(pose[4])); }

/* Of what lies behind the wall or the cells nothing moves. */
static void assert_still_behind(const cd_water* w, enum closed kind) {
    const double level = pool_get(w, CD_DEPTH, NX - 1, NY - 1);
    for (size_t j = 0; j < NY; ++j)
        for (size_t i = MIDDLE + kind; i < NX; ++i) {
            assert_true(pool_get(w, CD_VELOCITY_X, i, j) == 0 && pool_get(w, CD_VELOCITY_Y, i, j) == 0);
            assert_true(pool_get(w, CD_DEPTH, i, j) == level);
        }
}

/* A boat runs against it, slowly and by more than its own length in a step, straight and slanting. It ends a cell
 * before it, or nearer where it turns, and what is behind stays at rest; pushed back, it leaves. */
static void a_hull_stops_before_what_closes_its_way(void** state) {
    (void)state;
    for (enum closed kind = WALL; kind < KINDS; ++kind)
        for (int fast = 0; fast < 2; ++fast)
            for (int turn = 0; turn < 3; ++turn) {
                cd_water* w = lake();
                double pose[7], velocity[6];
                close(w, kind, 0, NY);
                ok(cd_water_launch_hull(w, 0, 2.9, 2.9, cos(turn), sin(turn)));
                pool_step(w, DT, 1);
                ok(cd_water_set_hull_velocity(w, 0, (const double[]){fast ? 300 : 2, 0, 0, 0, 0, 0}, 6));
                ok(cd_water_set_hull_force(w, 0, (const double[]){300 * cos(turn), -300 * sin(turn), 0, 0, 0, 0}, 6));
                double furthest = 0;
                for (int step = 0; step < 300; ++step) {
                    pool_step(w, DT, 1);
                    ok(cd_water_get_hull_pose(w, 0, pose, 7));
                    assert_true(pose[0] + half_of(pose) <= LENGTH / 2 + 1e-9);
                    furthest = fmax(furthest, pose[0] + half_of(pose));
                }
                assert_near(furthest, LENGTH / 2 - DX / 2, DX / 2 + 1e-9, 1);
                if (turn == 0) assert_near(furthest, LENGTH / 2 - DX, 0.02 * DX, 1);
                assert_still_behind(w, kind);
                const double x = pose[0];
                ok(cd_water_set_hull_velocity(w, 0, (const double[]){-0.5, 0, 0, 0, 0, 0}, 6));
                ok(cd_water_set_hull_force(w, 0, (const double[]){-300 * pose[3], 300 * pose[4], 0, 0, 0, 0}, 6));
                pool_step(w, DT, 90);
                ok(cd_water_get_hull_pose(w, 0, pose, 7));
                ok(cd_water_get_hull_velocity(w, 0, velocity, 6));
                assert_true(pose[0] < x - 0.5 && velocity[0] < 0);
                cd_water_destroy(w);
            }
}

/* A boat made fast to a quay, a tenth of a cell away: it neither presses nor feels nor drags what is behind, and lies as
 * the boat at the side of a lake that ends there. */
static void a_wall_parts_a_hull_from_the_water_behind(void** state) {
    (void)state;
    for (int scene = 0; scene < 3; ++scene) {
        const int running = scene == 1, slopes = scene == 2; /* what is behind slopes */
        double ends[2][7], loads[2][6];
        for (int walled = 0; walled < 2; ++walled) {
            cd_water* w;
            ok(cd_water_create(walled ? NX : MIDDLE, NY, DX, DX, CD_FLOAT64, NULL, &w));
            pool_fill(w, CD_DEPTH, 1);
            if (walled) close(w, WALL, 0, NY);
            for (size_t i = MIDDLE; walled && slopes && i < NX; ++i)
                for (size_t j = 0; j < NY; ++j) pool_set(w, CD_DEPTH, i, j, 1 + 0.02 * (double)j);
            ok(cd_water_set_hulls(w, 1, 4, 2));
            ok(cd_water_set_hull(w, 0, MASS, LONG, WIDE, NULL, 0));
            ok(cd_water_set_hull_drag(w, 0, 200, 400, 0));
            const double x = LENGTH / 2 - WIDE / 2 - 0.1 * DX;
            ok(cd_water_set_hull_pose(w, 0, (const double[]){x, WIDTH / 2, 0.7, 0, 1, 0, 0}, 7));
            ok(cd_water_set_hull_velocity(w, 0, (const double[]){0, running, 0, 0, 0, 0}, 6));
            pool_step(w, DT, 60);
            ok(cd_water_get_hull_pose(w, 0, ends[walled], 7));
            ok(cd_water_get_hull_load(w, 0, loads[walled], 6));
            if (walled && !slopes) assert_still_behind(w, WALL);
            cd_water_destroy(w);
        }
        for (int k = 0; k < 7; ++k) assert_near(ends[1][k], ends[0][k], 1e-9, 1);
        for (int k = 0; k < 6; ++k) assert_near(loads[1][k], loads[0][k], 1e-9 * MASS * 9.81, 1);
    }
}

/* No plate of a boat that turns beside a wall comes through it, and it turns back. */
static void no_hull_swings_through_a_wall(void** state) {
    (void)state;
    for (enum closed kind = WALL; kind < KINDS; ++kind)
        for (int fast = 0; fast < 2; ++fast) {
            cd_water* w = lake();
            double pose[7], turned = 0;
            close(w, kind, 0, NY);
            ok(cd_water_launch_hull(w, 0, LENGTH / 2 - WIDE / 2 - 1.1 * DX, WIDTH / 2, 0, 1));
            ok(cd_water_set_hull_velocity(w, 0, (const double[]){0, 0, 0, fast ? -40 : -0.5, 0, 0}, 6));
            for (int step = 0; step < 240; ++step) {
                pool_step(w, DT, 1);
                ok(cd_water_get_hull_pose(w, 0, pose, 7));
                assert_true(pose[0] + half_of(pose) <= LENGTH / 2 + 1e-9);
                turned = fmax(turned, fabs(pose[3]));
            }
            assert_true(fast || turned > 0.2);
            ok(cd_water_set_hull_velocity(w, 0, (const double[]){0, 0, 0, 0.5, 0, 0}, 6));
            pool_step(w, DT, 30);
            const double before = pose[3];
            ok(cd_water_get_hull_pose(w, 0, pose, 7));
            assert_true(pose[3] < before - 0.1);
            cd_water_destroy(w);
        }
}

/* The end of a wall that points at a boat stops it as a wall across its way does, and one beside its way does not. */
static void a_hull_meets_the_end_of_a_wall(void** state) {
    (void)state;
    for (int beside = 0; beside < 2; ++beside) {
        cd_water* w = lake();
        double pose[7];
        ok(cd_water_enable_field(w, CD_WALL_Y));
        for (size_t i = MIDDLE; i < NX; ++i) pool_set(w, CD_WALL_Y, i, NY / 2, 1);
        const double y = WIDTH / 2 + (beside ? WIDE / 2 + DX / 2 : 0.03);
        ok(cd_water_launch_hull(w, 0, 2.9, y, 1, 0));
        ok(cd_water_set_hull_velocity(w, 0, (const double[]){2, 0, 0, 0, 0, 0}, 6));
        ok(cd_water_set_hull_force(w, 0, (const double[]){100, 0, 0, 0, 0, 0}, 6));
        pool_step(w, DT, 180);
        ok(cd_water_get_hull_pose(w, 0, pose, 7));
        if (beside) assert_true(pose[0] > LENGTH / 2 + 1);
        else assert_near(pose[0] + half_of(pose), LENGTH / 2 - DX, 0.2 * DX, 1);
        cd_water_destroy(w);
    }
}

/* On a ring a wall at the seam stops what comes from either side. */
static void a_wall_at_the_seam_of_a_ring_stops_hulls(void** state) {
    (void)state;
    for (int way = -1; way <= 1; way += 2) {
        cd_water* w = lake();
        double pose[7];
        ok(cd_water_set_side(w, CD_SIDE_X_FIRST, CD_BORDER_PERIODIC, 0, 0));
        ok(cd_water_enable_field(w, CD_WALL_X));
        for (size_t j = 0; j < NY; ++j) pool_set(w, CD_WALL_X, 0, j, 1);
        ok(cd_water_launch_hull(w, 0, LENGTH / 2, WIDTH / 2, 1, 0));
        ok(cd_water_set_hull_velocity(w, 0, (const double[]){2 * way, 0, 0, 0, 0, 0}, 6));
        ok(cd_water_set_hull_force(w, 0, (const double[]){300 * way, 0, 0, 0, 0, 0}, 6));
        for (int step = 0; step < 300; ++step) {
            pool_step(w, DT, 1);
            ok(cd_water_get_hull_pose(w, 0, pose, 7));
            assert_true(pose[0] > 1 && pose[0] < LENGTH - 1);
        }
        assert_near(pose[0], way > 0 ? LENGTH - 1 - DX : 1 + DX, 0.5 * DX, 1);
        cd_water_destroy(w);
    }
}

/* A boat that runs aslant into a corner of cells that are not there, and the same with x and y exchanged. */
static void a_corner_stops_a_hull_either_way_round(void** state) {
    (void)state;
    enum { N = 24 };
    double ends[2][7];
    for (int turned = 0; turned < 2; ++turned) {
        cd_water* w;
        ok(cd_water_create(N, N, DX, DX, CD_FLOAT64, NULL, &w));
        pool_fill(w, CD_DEPTH, 1);
        ok(cd_water_enable_field(w, CD_MASK));
        for (size_t k = 0; k < 36; ++k) pool_set(w, CD_MASK, 12 + k % 6, 12 + k / 6, 0);
        ok(cd_water_set_hulls(w, 1, 1, 1));
        ok(cd_water_set_hull(w, 0, 300, WIDE, WIDE, NULL, 0));
        const double at[2] = {1.5, 1.4}, speed[2] = {30, 31};
        ok(cd_water_launch_hull(w, 0, at[turned], at[1 - turned], 1 - turned, turned));
        ok(cd_water_set_hull_velocity(w, 0, (const double[]){speed[turned], speed[1 - turned], 0, 0, 0, 0}, 6));
        ok(cd_water_set_first(w, turned));
        pool_step(w, DT, 20);
        ok(cd_water_get_hull_pose(w, 0, ends[turned], 7));
        assert_true(fmin(ends[turned][0], ends[turned][1]) < 12 * DX - WIDE / 2);
        cd_water_destroy(w);
    }
    assert_near(ends[1][0], ends[0][1], 1e-9, 1);
    assert_near(ends[1][1], ends[0][0], 1e-9, 1);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_hull_stops_before_what_closes_its_way),
        cmocka_unit_test(a_wall_parts_a_hull_from_the_water_behind),
        cmocka_unit_test(no_hull_swings_through_a_wall),
        cmocka_unit_test(a_hull_meets_the_end_of_a_wall),
        cmocka_unit_test(a_wall_at_the_seam_of_a_ring_stops_hulls),
        cmocka_unit_test(a_corner_stops_a_hull_either_way_round),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
