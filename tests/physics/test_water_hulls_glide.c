/* A hull on still water is held nowhere by how its edges lie over the cells. */
#include <math.h>

#include "check.h"
#include "pool.h"

#define G 9.81
#define PI 3.14159265358979324
#define SECONDS 10.0

struct start {
    cd_precision precision;
    double dx, dy, length, width, mass, heading, off; /* off: of a cell */
    double push, moment, speed;                       /* push, speed: along x */
};

/* How far along x a hull gets, without drag; turned: by how much it turns. */
static double way(const struct start* s, double* turned) {
    cd_water* w;
    double pose[7];
    const double c = cos(s->heading), n = sin(s->heading), x = 2.4 + s->off * s->dx, y = 2.4 + s->off * s->dy;
    ok(cd_water_create((size_t)(4.8 / s->dx + 0.5), (size_t)(4.8 / s->dy + 0.5), s->dx, s->dy, s->precision, NULL, &w));
    pool_fill(w, CD_DEPTH, 1);
    ok(cd_water_set_hulls(w, 1, 8, 4));
    ok(cd_water_set_hull(w, 0, s->mass, s->length, s->width, NULL, 0));
    ok(cd_water_launch_hull(w, 0, x, y, c, n));
    ok(cd_water_set_hull_velocity(w, 0, (const double[]){s->speed, 0, 0, 0, 0, 0}, 6));
    ok(cd_water_set_hull_force(w, 0, (const double[]){s->push * c, -s->push * n, 0, s->moment, 0, 0}, 6));
    pool_step(w, 1 / 60.0, (size_t)(60 * SECONDS));
    ok(cd_water_get_hull_pose(w, 0, pose, 7));
    cd_water_destroy(w);
    *turned = atan2(pose[4] * c - pose[3] * n, pose[3] * c + pose[4] * n);
    return pose[0] - x;
}

static const double kCells[][2] = {{0.1, 0.1}, {0.2, 0.2}, {0.1, 0.15}};
static const double kSizes[][2] = {{2, 1}, {2.07, 1.03}}; /* whole numbers of cells, and not */
static const double kHeadings[] = {0, 0.3, PI / 4, PI / 2};
static const double kMasses[] = {50, 200, 400};
enum { CASES = 3 * 2 * 4 * 3 };

static struct start start_of(int k) {
    const int offs = k + k / 12 + k / 24; /* so that each meets each */
    const double *const cell = kCells[k / 24], *const size = kSizes[k / 12 % 2];
    return (struct start){.precision = (k + k / 3) % 2 ? CD_FLOAT32 : CD_FLOAT64,
                          .dx = cell[0],
                          .dy = cell[1],
                          .length = size[0],
                          .width = size[1],
                          .heading = kHeadings[k / 3 % 4],
                          .mass = kMasses[k % 3],
                          .off = offs % 4 * 0.25};
}

/* The water that goes along makes it slower than in the air: the heaviest, 0.2 m deep in 1 m of water, most. */
static void the_least_push_moves_a_hull(void** state) {
    (void)state;
    for (int k = 0; k < CASES; ++k) {
        if (!is_taken((size_t)k, 5)) continue;
        struct start s = start_of(k);
        double turned;
        s.push = 2e-4 * s.mass * G;
        const double free = s.push / s.mass * (SECONDS * SECONDS) / 2, part = way(&s, &turned) / free;
        if (!(part > 0.7 && part < 1.02)) print_message("case %d: %g of the way in the air\n", k, part);
        assert_true(part > 0.7 && part < 1.02);
    }
}

static void a_hull_adrift_goes_on(void** state) {
    (void)state;
    for (int k = 0; k < CASES; ++k) {
        if (!is_taken((size_t)k, 5)) continue;
        struct start s = start_of(k);
        double turned;
        s.speed = 0.1;
        const double part = way(&s, &turned) / (s.speed * SECONDS);
        if (!(part > 0.5 && part < 1.02)) print_message("case %d: %g of the way in the air\n", k, part);
        assert_true(part > 0.5 && part < 1.02);
    }
}

/* Also where it is heavy and lies on few cells, so that its way is uneven, wherever it begins among them. */
static void a_hull_of_few_cells_goes_on(void** state) {
    (void)state;
    for (int k = 0; k < 16; ++k) {
        struct start s = {.dx = 0.2, .dy = 0.2, .length = 2, .width = 1, .speed = 0.1};
        s.precision = k & 1 ? CD_FLOAT32 : CD_FLOAT64;
        s.heading = k & 2 ? PI / 2 : 0, s.mass = k & 4 ? 800 : 400, s.off = k & 8 ? 0.5 : 0.25;
        double turned;
        const double part = way(&s, &turned) / (s.speed * SECONDS);
        if (!(part > 0.6 && part < 1.02)) print_message("case %d: %g of the way in the air\n", k, part);
        assert_true(part > 0.6 && part < 1.02);
    }
}

static void the_least_moment_turns_a_hull(void** state) {
    (void)state;
    for (int k = 0; k < CASES; ++k) {
        if (!is_taken((size_t)k, 5)) continue;
        struct start s = start_of(k);
        double turned;
        const double inertia = s.mass * (s.length * s.length + s.width * s.width) / 12, free = 0.1;
        s.moment = 2 * free * inertia / (SECONDS * SECONDS);
        way(&s, &turned);
        if (!(turned > 0.4 * free && turned < 1.02 * free)) print_message("case %d: %g rad\n", k, turned);
        assert_true(turned > 0.4 * free && turned < 1.02 * free);
    }
}

/* A push of 100 N brings a boat of 1000 kg, which lies still, two thirds as far in 4 s as without water, or farther:
 * wherever it lies among the cells, whatever way it heads, in long steps and short ones. */
static void a_small_push_moves_a_boat_wherever_it_lies(void** state) {
    (void)state;
    const double push = 100, mass = 1000, seconds = 4, free = push / mass * seconds * seconds / 2;
    for (int k = 0; k < 16; ++k) {
        if (!is_taken((size_t)(k + k / 4 + k / 8), 2)) continue;
        cd_water* w;
        double from[7], to[7];
        ok(cd_water_create(64, 32, 0.25, 0.25, CD_FLOAT64, NULL, &w));
        pool_fill(w, CD_DEPTH, 1);
        const double turn = k & 8 ? 0.4 : 0;
        ok(cd_water_set_hulls(w, 1, 8, 4));
        ok(cd_water_set_hull(w, 0, mass, 3, 1.6, NULL, 0));
        ok(cd_water_launch_hull(w, 0, 8 + 0.25 / 4 * (k & 3), 4.07, cos(turn), sin(turn)));
        ok(cd_water_set_hull_drag(w, 0, 1000, 1000, 0));
        ok(cd_water_set_drag(w, 1));
        pool_step(w, 0.1, 500);
        ok(cd_water_set_drag(w, 0));
        ok(cd_water_set_hull_drag(w, 0, 0, 0, 0));
        ok(cd_water_get_hull_pose(w, 0, from, 7));
        ok(cd_water_set_hull_force(w, 0, (const double[]){push, 0, 0, 0, 0, 0}, 6));
        const size_t steps = k & 4 ? 960 : 240;
        pool_step(w, seconds / (double)steps, steps);
        ok(cd_water_get_hull_pose(w, 0, to, 7));
        const double ahead = (to[0] - from[0]) * cos(turn) + (to[1] - from[1]) * sin(turn);
        assert_near(ahead, 0.85 * free, 0.2, 0);
        cd_water_destroy(w);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_least_push_moves_a_hull),
        cmocka_unit_test(a_hull_adrift_goes_on),
        cmocka_unit_test(a_hull_of_few_cells_goes_on),
        cmocka_unit_test(the_least_moment_turns_a_hull),
        cmocka_unit_test(a_small_push_moves_a_boat_wherever_it_lies),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
