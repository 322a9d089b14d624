/* A tide on a beach: the sea rises and falls by 0.8 m in ten minutes, and the shore with it, over sand that slopes up by
 * one in twenty. No water is made or lost: what came in over the open side is what there is more of. */
#include <contdyn/contdyn.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { kX = 100, kY = 40 };

static void must(cd_status status) {
    if (status == CD_OK) return;
    fprintf(stderr, "%s\n", cd_error_message());
    exit(1);
}

int main(void) {
    static double bed[kX * kY], surface[kX * kY];
    const double dx = 0.5, period = 600, turn = 6.283185307179586;
    double area, initial, in, out, volume;
    cd_water* beach;
    must(cd_water_create(kX, kY, dx, dx, CD_FLOAT64, NULL, &beach));
    for (int j = 0; j < kY; ++j)
        for (int i = 0; i < kX; ++i) { /* the sea is at x = 0; a hollow in the middle of the sand */
            const double x = (i + 0.5) * dx, y = (j + 0.5) * dx;
            bed[j * kX + i] = x / 20 - 1.5 - 0.3 * exp(-(x - 35) * (x - 35) / 20 - (y - 10) * (y - 10) / 20);
            surface[j * kX + i] = fmax(0, bed[j * kX + i]);
        }
    must(cd_water_write_f64(beach, CD_BED, 0, 0, kX, kY, bed, kX * kY));
    must(cd_water_write_f64(beach, CD_SURFACE, 0, 0, kX, kY, surface, kX * kY));
    must(cd_water_set_momentum(beach, CD_MOMENTUM_ADVECTED));
    must(cd_water_set_manning(beach, 0.03));
    printf("  time      sea      wet      volume    in less out\n");
    for (int second = 0; second <= 900; ++second) {
        const double level = 0.4 * sin(turn * second / period);
        if (second % 150 == 0) {
            must(cd_water_get_wet_area(beach, &area));
            must(cd_water_get_volume(beach, &volume));
            must(cd_water_get_account(beach, &initial, &in, &out, NULL));
            printf("%4.1f min  %3ld cm  %4.0f m^2  %6.1f m^3  %6.1f m^3\n", second / 60.0, lround(100 * level), area, volume, in - out);
        }
        must(cd_water_set_side(beach, CD_SIDE_X_FIRST, CD_BORDER_OPEN, level, 0));
        must(cd_water_step(beach, 0.1, 10));
    }
    cd_water_destroy(beach);
    return 0;
}
