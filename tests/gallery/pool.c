/* A pool, with something dropped into it. */
#include <contdyn/contdyn.h>
#include <stdio.h>

int main(void) {
    cd_water* pool;
    const double at[2] = {2, 1.5};
    double level, volume;
    if (cd_water_create(128, 96, 0.03125, 0.03125, CD_FLOAT32, NULL, &pool)) return puts(cd_error_message()), 1;
    cd_water_add_volume_rectangle(pool, 0, 0, 128, 96, 12 * 0.5, NULL); /* 4 m x 3 m, half a metre deep */
    cd_water_splash(pool, 2, 1.5, 0.3, 0.2);
    for (int frame = 0; frame <= 120; ++frame) {
        cd_water_sample(pool, at, 1, CD_OUTSIDE_REFUSED, &level, NULL, NULL, NULL);
        cd_water_get_volume(pool, &volume);
        if (frame % 30 == 0) printf("%.1f s: %.3f m, %.4f m^3\n", frame / 60.0, level, volume);
        cd_water_step(pool, 1 / 60.0, 1);
    }
    cd_water_destroy(pool);
    return 0;
}
