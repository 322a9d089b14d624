/* A flag of 1.5 m by 1 m in a wind of 8 m/s that turns round after six seconds, held by its edge at the pole. */
#include <contdyn/contdyn.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { kAlong = 48, kDown = 32, kColumns = kAlong + 1, kRows = kDown + 1 };

static void must(cd_status status) {
    if (status == CD_OK) return;
    fprintf(stderr, "%s\n", cd_error_message());
    exit(1);
}

int main(void) {
    static double x[kRows][kColumns][3], strain[kRows * kAlong];
    const double gravity[3] = {0, 0, -9.81}, speed = 8, dt = 1 / 60.0;
    cd_membrane* flag;
    must(cd_membrane_create(kAlong, kDown, 3, CD_FLOAT32, NULL, &flag));
    for (int j = 0; j < kRows; ++j)
        for (int i = 0; i < kColumns; ++i) { /* hanging out from the pole, with a slight wave to begin with */
            x[j][i][0] = 1.5 * i / kAlong;
            x[j][i][1] = 0.02 * sin(9.0 * i / kAlong + 4.0 * j / kDown) * i / kAlong;
            x[j][i][2] = 1 - 1.0 * j / kDown;
        }
    must(cd_membrane_write_f64(flag, CD_POSITION, 0, 0, kColumns, kRows, x[0][0], kColumns * kRows * 3));
    must(cd_membrane_set_mass(flag, 0.2));            /* 130 g a square metre */
    must(cd_membrane_set_rest_length(flag, 1.5, 1));  /* it is cloth from here on */
    must(cd_membrane_set_stiffness(flag, 2000, 4500)); /* 3000 N a metre of width */
    must(cd_membrane_set_shear(flag, 100));
    must(cd_membrane_set_bend(flag, 1e-5));
    must(cd_membrane_set_gravity(flag, gravity, 3));
    must(cd_membrane_set_edge(flag, CD_EDGE_U_FIRST, CD_NODE_PINNED));
    must(cd_membrane_set_air(flag, 0.02 * speed, 1.2 * speed)); /* along the cloth, and across it */

    printf("  time   wind   the free edge lies at          it moves at   stretch\n");
    for (int frame = 1; frame <= 720; ++frame) {
        const double wind[3] = {frame <= 360 ? speed : -speed, 0.15 * speed, 0};
        must(cd_membrane_set_wind(flag, wind, 3));
        must(cd_membrane_step(flag, dt, 1));
        if (frame % 60 != 0) continue;
        double middle[3] = {0, 0, 0}, velocity[kRows][3], motion = 0, longest = 0;
        must(cd_membrane_read_f64(flag, CD_POSITION, 0, 0, kColumns, kRows, x[0][0], kColumns * kRows * 3));
        must(cd_membrane_read_f64(flag, CD_VELOCITY, kAlong, 0, 1, kRows, velocity[0], kRows * 3));
        must(cd_membrane_read_f64(flag, CD_STRAIN_U, 0, 0, kAlong, kRows, strain, kRows * kAlong));
        for (int j = 0; j < kRows; ++j)
            for (int k = 0; k < 3; ++k) {
                middle[k] += x[j][kAlong][k] / kRows;
                motion += velocity[j][k] * velocity[j][k] / kRows;
            }
        for (int s = 0; s < kRows * kAlong; ++s) longest = fmax(longest, strain[s]);
        printf("%4.0f s   %4.0f   %6.2f %6.2f %6.2f m   %8.2f m/s   %6.1f%%\n", frame * dt, wind[0], middle[0],
               middle[1], middle[2], sqrt(motion), 100 * longest);
    }
    cd_membrane_destroy(flag);
    return 0;
}
