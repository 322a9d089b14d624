/* A river round an island: 2 m^2/s come in above over the whole width, friction and slope settle the depth, and it leaves
 * below at a level that is held. Beside it the depth in which Manning's formula has it run where nothing is in the way. */
#include <contdyn/contdyn.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { kX = 150, kY = 40, kPlaces = 4 };

static void must(cd_status status) {
    if (status == CD_OK) return;
    fprintf(stderr, "%s\n", cd_error_message());
    exit(1);
}

int main(void) {
    static double bed[kX * kY], depth[kX * kY], speed[(kX + 1) * kY];
    const double dx = 2, slope = 0.002, manning = 0.03, inflow = 2, width = kY * dx;
    const double normal = 1.193; /* m: (inflow manning / sqrt(slope))^(3/5) */
    const double places[kPlaces] = {50, 125, 150, 250};
    const char* const names[kPlaces] = {"above it", "at its head", "beside it", "far below"};
    cd_water* river;
    must(cd_water_create(kX, kY, dx, dx, CD_FLOAT64, NULL, &river));
    for (int j = 0; j < kY; ++j)
        for (int i = 0; i < kX; ++i) {
            const double x = (i + 0.5) * dx, y = (j + 0.5) * dx, along = (x - 150) / 25, across = (y - 40) / 12;
            const double island = fmax(0, 3 * (1 - along * along - across * across));
            bed[j * kX + i] = slope * (kX * dx - x) + island;
            depth[j * kX + i] = fmax(0, normal - island);
        }
    must(cd_water_write_f64(river, CD_BED, 0, 0, kX, kY, bed, kX * kY));
    must(cd_water_write_f64(river, CD_DEPTH, 0, 0, kX, kY, depth, kX * kY));
    must(cd_water_set_momentum(river, CD_MOMENTUM_ADVECTED));
    must(cd_water_set_manning(river, manning));
    must(cd_water_set_side(river, CD_SIDE_X_FIRST, CD_BORDER_INFLOW, inflow, 0));
    must(cd_water_set_side(river, CD_SIDE_X_LAST, CD_BORDER_LEVEL, normal, 0));

    for (int minute = 0; minute <= 30; minute += 10) {
        must(cd_water_read_f64(river, CD_DEPTH, 0, 0, kX, kY, depth, kX * kY));
        must(cd_water_read_f64(river, CD_VELOCITY_X, 0, 0, kX + 1, kY, speed, (kX + 1) * kY));
        printf("after %d min\n", minute);
        for (int k = 0; k < kPlaces; ++k) { /* at the cell before the place; a face has the mean of its cells' depths */
            const int i = (int)(places[k] / dx) - 1;
            double deep = 0, wet = 0, through = 0, fastest = 0;
            for (int j = 0; j < kY; ++j) {
                const double u = speed[j * (kX + 1) + i + 1], d = 0.5 * (depth[j * kX + i] + depth[j * kX + i + 1]);
                if (d > 0.01) wet += dx, deep += dx * d;
                through += dx * u * d, fastest = fmax(fastest, u);
            }
            printf("  %-12s %2.0f m wide, %4.2f m deep, at most %4.2f m/s, %3.0f m^3/s\n", names[k], wet, deep / wet,
                   fastest, through);
        }
        must(cd_water_step(river, 0.25, minute < 30 ? 2400 : 0));
    }
    printf("%.0f m^3/s come in; undisturbed it is %.2f m deep\n", inflow * width, normal);
    cd_water_destroy(river);
    return 0;
}
