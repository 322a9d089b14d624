/* A boat on a pool in the rain: it floats, is driven in a circle, makes waves, and feels them. */
#include <contdyn/contdyn.h>
#include <stdio.h>

static unsigned seed = 1;
static double random_to(double most) { return most * ((seed = seed * 1664525u + 1013904223u) >> 8) / (1 << 24); }

int main(void) {
    cd_water* pool;
    double floor[7], velocity[6], load[6], kept, level, heights[8 * 4];
    const double engine[6] = {250, 0, 0, 200, 0, 0}; /* ahead, and round to port */
    if (cd_water_create(128, 96, 0.125, 0.125, CD_FLOAT32, NULL, &pool)) return puts(cd_error_message()), 1;
    cd_water_add_volume_rectangle(pool, 0, 0, 128, 96, 16 * 12 * 1.0, NULL); /* 16 m x 12 m, a metre deep */
    for (int j = 0; j < 4; ++j) /* the floor rises to the sides, and to bow and stern, which are narrow */
        for (int i = 0; i < 8; ++i) {
            const int outer = j == 0 || j == 3, end = i < 2 ? 2 - i : i > 5 ? i - 5 : 0;
            heights[8 * j + i] = end == 2 && outer ? -1 : 0.1 * (outer + end);
        }
    cd_water_set_hulls(pool, 1, 8, 4);
    cd_water_set_hull(pool, 0, 400, 2.4, 1, heights, 8 * 4); /* kg, m, m */
    cd_water_set_hull_drag(pool, 0, 60, 600, 0.3);
    cd_water_launch_hull(pool, 0, 4, 4, 1, 0);
    cd_water_set_hull_force(pool, 0, engine, 6);
    for (int frame = 0; frame <= 900; ++frame) {
        const double drop[2] = {random_to(16), random_to(12)}, aside[2] = {0.5, 11.5};
        if (frame % 150 == 0) {
            cd_water_get_hull_floor(pool, 0, floor, 7);
            cd_water_get_hull_velocity(pool, 0, velocity, 6);
            cd_water_get_hull_load(pool, 0, load, 6);
            cd_water_sample(pool, aside, 1, CD_OUTSIDE_REFUSED, &level, NULL, NULL, NULL);
            cd_water_get_account(pool, NULL, NULL, NULL, &kept);
            printf("%4.1f s: at (%4.1f, %4.1f), keel %.2f m, bow %+d mm/m, %.1f m/s; water bears %.0f N, aside %.2f m\n",
                   frame / 60.0, floor[0], floor[1], floor[2], (int)(1000 * floor[5]),
                   velocity[0] * floor[3] + velocity[1] * floor[4], load[2], level);
        }
        cd_water_add_volume(pool, drop[0], drop[1], 0.2, 0.002, NULL); /* two litres of rain at a time */
        cd_water_step(pool, 1 / 60.0, 1);
    }
    printf("no drop is lost: %s\n", kept < 1e-5 && kept > -1e-5 ? "true" : "false");
    cd_water_destroy(pool);
    return 0;
}
