/* A ball flies into a goal. The net is cloth that meets the ball as a moving collider, and tells what that bears; the ball
 * is a body of this program's own, as it would be of another engine. */
#include <contdyn/contdyn.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { kWide = 36, kHigh = 22, kColumns = kWide + 1, kRows = kHigh + 1, kParts = 4 };

static void must(cd_status status) {
    if (status == CD_OK) return;
    fprintf(stderr, "%s\n", cd_error_message());
    exit(1);
}

int main(void) {
    static double x[kRows][kColumns][3];
    const double gravity[3] = {0, 0, -9.81}, width = 3.6, height = 2, slack = 1.1, dt = 1.0 / (60 * kParts);
    const double radius = 0.11, mass = 0.43; /* the ball's [m, kg] */
    const double up[3] = {0, 0, 1}, ground[3] = {0, 0, 0};
    double at[3] = {0.2, -1.5, 0.9}, velocity[3] = {1, 25, 2}, hardest = 0;
    cd_membrane* net;
    must(cd_membrane_create(kWide, kHigh, 3, CD_FLOAT32, NULL, &net));
    for (int j = 0; j < kRows; ++j)
        for (int i = 0; i < kColumns; ++i) {
            x[j][i][0] = width * ((double)i / kWide - 0.5), x[j][i][1] = 0.15 * sin(3.14159265 * i / kWide);
            x[j][i][2] = height * (1 - (double)j / kHigh);
        }
    must(cd_membrane_write_f64(net, CD_POSITION, 0, 0, kColumns, kRows, x[0][0], kColumns * kRows * 3));
    must(cd_membrane_set_mass(net, 2));
    must(cd_membrane_set_rest_length(net, slack * width, slack * height));
    must(cd_membrane_set_stiffness(net, 3e4, 3e4));
    must(cd_membrane_set_gravity(net, gravity, 3));
    must(cd_membrane_set_drag(net, 0.5));
    for (cd_edge edge = CD_EDGE_U_FIRST; edge <= CD_EDGE_V_FIRST; ++edge)
        must(cd_membrane_set_edge(net, edge, CD_NODE_PINNED)); /* posts and bar; it hangs free at the ground */
    must(cd_membrane_set_colliders(net, 2));
    must(cd_membrane_set_loads(net, 1));
    must(cd_membrane_set_plane(net, 1, ground, up, 3, 0.5));

    printf("  time   the ball: behind the line, height   its speed   force of the net\n");
    for (int frame = 1; frame <= 42; ++frame) {
        double load[6];
        for (int part = 0; part < kParts; ++part) {
            must(cd_membrane_set_capsule(net, 0, at, at, 3, radius, 0.3));
            must(cd_membrane_set_collider_velocity(net, 0, velocity, 3));
            must(cd_membrane_step(net, dt, 1));
            must(cd_membrane_get_collider_load(net, 0, load, 6)); /* in the step, in which the ball went straight on */
            for (int k = 0; k < 3; ++k) at[k] += dt * velocity[k], velocity[k] += dt * (gravity[k] + load[k] / mass);
            if (at[2] < radius && velocity[2] < 0) velocity[2] *= -0.5; /* bounces */
            hardest = fmax(hardest, hypot(hypot(load[0], load[1]), load[2]));
        }
        if (frame % 3 != 0) continue;
        printf("%5.2f s               %5.2f m      %5.2f m     %4.1f m/s    at most %3.0f N\n", frame / 60.0, at[1],
               at[2], hypot(hypot(velocity[0], velocity[1]), velocity[2]), hardest);
        hardest = 0;
    }
    cd_membrane_destroy(net);
    return 0;
}
