/* A flood in time-lapse: after a cloudburst a river of 300 m^3/s comes down a valley of 8 km by 3 km for two hours, and
 * leaves it at the lower end. A step may be half a minute, in which waves cross many cells: the flood arrives as it does
 * with steps of two seconds and is as deep to some per cent, only its thin edges run further; no water is lost. */
#include <contdyn/contdyn.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { kX = 160, kY = 60 };

static void must(cd_status status) {
    if (status == CD_OK) return;
    fprintf(stderr, "%s\n", cd_error_message());
    exit(1);
}

static cd_water* make_valley(void) {
    static double bed[kX * kY];
    const double dx = 50, turn = 6.283185307179586;
    cd_water* valley;
    must(cd_water_create(kX, kY, dx, dx, CD_FLOAT64, NULL, &valley));
    for (int j = 0; j < kY; ++j)
        for (int i = 0; i < kX; ++i) { /* falls by 1 m a kilometre; the bottom of the valley winds */
            const double x = (i + 0.5) * dx, y = (j + 0.5) * dx - 1500 - 400 * sin(turn * x / 4000);
            bed[j * kX + i] = 8 - x / 1000 + 20 * (y / 1500) * (y / 1500) + 0.3 * sin(turn * x / 700) * sin(turn * y / 500);
        }
    must(cd_water_write_f64(valley, CD_BED, 0, 0, kX, kY, bed, kX * kY));
    must(cd_water_set_manning(valley, 0.05)); /* fields and hedges */
    must(cd_water_set_lambda(valley, 1));
    must(cd_water_set_side(valley, CD_SIDE_X_LAST, CD_BORDER_OPEN, -10, 0));
    return valley;
}

int main(void) {
    const double steps[2] = {2, 30};
    cd_water* valley[2];
    for (int k = 0; k < 2; ++k) valley[k] = make_valley();
    printf("           steps of 2 s                      steps of 30 s\n");
    printf("  time       wet        water      deepest     wet        water      deepest\n");
    for (int half_hour = 1; half_hour <= 10; ++half_hour) {
        printf("%4.1f h", half_hour / 2.0);
        for (int k = 0; k < 2; ++k) {
            static double depth[kX * kY];
            double area, volume, deepest = 0;
            if (half_hour == 1) must(cd_water_add_source(valley[k], 200, 1620, 150, 300)); /* m^3/s */
            if (half_hour == 5) must(cd_water_add_source(valley[k], 200, 1620, 150, -300));
            must(cd_water_step(valley[k], steps[k], (size_t)(1800 / steps[k])));
            must(cd_water_get_wet_area(valley[k], &area));
            must(cd_water_get_volume(valley[k], &volume));
            must(cd_water_read_f64(valley[k], CD_DEPTH, 0, 0, kX, kY, depth, kX * kY));
            for (int i = 0; i < kX * kY; ++i) deepest = fmax(deepest, depth[i]);
            printf("   %5.2f km^2  %4.2f Mm^3  %5.2f m", area / 1e6, volume / 1e6, deepest);
        }
        printf("\n");
    }
    for (int k = 0; k < 2; ++k) {
        double initial, in, out, volume;
        must(cd_water_get_account(valley[k], &initial, &in, &out, NULL));
        must(cd_water_get_volume(valley[k], &volume));
        printf("steps of %2.0f s: %.3f Mm^3 came in, %.3f went out, %.3f m^3 are lost\n", steps[k], in / 1e6, out / 1e6,
               fabs(initial + in - out - volume));
        cd_water_destroy(valley[k]);
    }
    return 0;
}
