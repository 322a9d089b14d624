/* A dam breaks: water 1 m deep runs over dry ground, a channel of 60 m. Beside it Ritter's exact solution of 1892: the
 * depth at the dam stays 4/9 m, and the front runs ahead at twice the speed of waves. */
#include <contdyn/contdyn.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { kCells = 600 };

static void must(cd_status status) {
    if (status == CD_OK) return;
    fprintf(stderr, "%s\n", cd_error_message());
    exit(1);
}

int main(void) {
    const double dx = 60.0 / kCells, dam = 30;
    double depth[kCells], volume, initial, rounding;
    cd_water* channel;
    must(cd_water_create(kCells, 1, dx, dx, CD_FLOAT64, NULL, &channel));
    must(cd_water_set_momentum(channel, CD_MOMENTUM_ADVECTED));
    must(cd_water_add_volume_rectangle(channel, 0, 0, kCells / 2, 1, dam * dx, NULL));
    must(cd_water_restart_account(channel));
    printf("  time   depth at the dam   1 cm deep at   exact\n");
    for (int frame = 0; frame <= 180; ++frame) {
        if (frame > 0 && frame % 30 == 0) {
            const double time = frame / 60.0, wave = sqrt(9.81);
            int front = kCells - 1;
            must(cd_water_read_f64(channel, CD_DEPTH, 0, 0, kCells, 1, depth, kCells));
            while (front > 0 && depth[front] < 0.01) --front;
            printf("%4.1f s   %.3f m            %5.2f m       %5.2f m\n", time,
                   0.5 * (depth[kCells / 2 - 1] + depth[kCells / 2]), (front + 1) * dx,
                   dam + time * (2 * wave - 3 * sqrt(9.81 * 0.01))); /* where (2 c - (x - dam) / t)^2 / 9 g is 1 cm */
        }
        must(cd_water_step(channel, 1 / 60.0, 1));
    }
    must(cd_water_get_volume(channel, &volume));
    must(cd_water_get_account(channel, &initial, NULL, NULL, &rounding));
    printf("volume: %.6f m^3 of %.6f; rounding: %s\n", volume, initial, fabs(rounding) < 1e-12 ? "below 1e-12" : "more");
    cd_water_destroy(channel);
    return 0;
}
