/* A cape on somebody who runs, stops and runs back: its collar goes from pose to pose with the shoulders, and the body is
 * a capsule that it lies on. */
#include <contdyn/contdyn.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { kAcross = 24, kDown = 36, kColumns = kAcross + 1, kRows = kDown + 1 };

static void must(cd_status status) {
    if (status == CD_OK) return;
    fprintf(stderr, "%s\n", cd_error_message());
    exit(1);
}

int main(void) {
    static double x[kRows][kColumns][3];
    const double gravity[3] = {0, 0, -9.81}, body = 0.2, dt = 1 / 60.0;
    double at = 0; /* where the body is along y; the cape hangs behind it, on the side of smaller y */
    cd_membrane* cape;
    must(cd_membrane_create(kAcross, kDown, 3, CD_FLOAT32, NULL, &cape));
    for (int j = 0; j < kRows; ++j)
        for (int i = 0; i < kColumns; ++i) {
            const double round = 3.0 * (i - kAcross / 2) / kAcross, out = body + 0.01;
            x[j][i][0] = out * sin(round), x[j][i][1] = -out * cos(round), x[j][i][2] = 1.5 - 1.1 * j / kDown;
        }
    must(cd_membrane_write_f64(cape, CD_POSITION, 0, 0, kColumns, kRows, x[0][0], kColumns * kRows * 3));
    must(cd_membrane_set_mass(cape, 0.3));
    must(cd_membrane_set_rest_length(cape, 3.0 * (body + 0.01), 1.1));
    must(cd_membrane_set_stiffness(cape, 3000, 1500));
    must(cd_membrane_set_shear(cape, 100));
    must(cd_membrane_set_bend(cape, 3e-5));
    must(cd_membrane_set_gravity(cape, gravity, 3));
    must(cd_membrane_set_air(cape, 0.05, 2));
    must(cd_membrane_set_edge(cape, CD_EDGE_V_FIRST, CD_NODE_POSED));
    must(cd_membrane_set_colliders(cape, 1));
    must(cd_membrane_set_thickness(cape, 0.005));

    printf("  time   the body is at   the hem hangs   behind it by   nearest to the body's axis\n");
    for (int frame = 1; frame <= 360; ++frame) {
        const double t = frame * dt, next = t < 2 ? 2 * t : t < 3 ? 4 : t < 5 ? 4 - 2 * (t - 3) : 0;
        const double first[3] = {0, at, 0.2}, last[3] = {0, at, 1.4}, velocity[3] = {0, (next - at) / dt, 0};
        double collar[kColumns][3];
        for (int i = 0; i < kColumns; ++i) { /* where the collar is at the end of the frame */
            const double round = 3.0 * (i - kAcross / 2) / kAcross, out = body + 0.01;
            collar[i][0] = out * sin(round), collar[i][1] = next - out * cos(round), collar[i][2] = 1.5;
        }
        must(cd_membrane_write_f64(cape, CD_TARGET, 0, 0, kColumns, 1, collar[0], kColumns * 3));
        must(cd_membrane_set_capsule(cape, 0, first, last, 3, body, 0.3));
        must(cd_membrane_set_collider_velocity(cape, 0, velocity, 3));
        must(cd_membrane_step(cape, dt, 1));
        at = next;
        if (frame % 30 != 0) continue;
        double hem[3] = {0, 0, 0}, nearest = 1;
        must(cd_membrane_read_f64(cape, CD_POSITION, 0, 0, kColumns, kRows, x[0][0], kColumns * kRows * 3));
        for (int i = 0; i < kColumns; ++i)
            for (int k = 0; k < 3; ++k) hem[k] += x[kDown][i][k] / kColumns;
        for (int j = 0; j < kRows; ++j)
            for (int i = 0; i < kColumns; ++i)
                nearest = fmin(nearest, hypot(x[j][i][0], x[j][i][1] - at));
        printf("%4.1f s   %8.2f m     %6.2f m     %6.2f m        %5.1f cm\n", t, at, hem[2], at - hem[1], 100 * nearest);
    }
    cd_membrane_destroy(cape);
    return 0;
}
