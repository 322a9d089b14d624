/* A banner of 3 m by 1 m between two poles, with a seam down its middle that tears at a tenth of what the cloth bears. A
 * runner comes through it, and stops behind it. */
#include <contdyn/contdyn.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { kAlong = 48, kDown = 16, kColumns = kAlong + 1, kRows = kDown + 1, kSeam = kAlong / 2 };

static void must(cd_status status) {
    if (status == CD_OK) return;
    fprintf(stderr, "%s\n", cd_error_message());
    exit(1);
}

int main(void) {
    static double x[kRows][kColumns][3], tension[kRows * kAlong], weak[kRows];
    const double gravity[3] = {0, 0, -9.81}, speed = 5, stops = 0.9, dt = 1 / 120.0;
    const double velocity[3] = {0, speed, 0}, still[3] = {0}, feet[3] = {0.1, -2, 0.3}, head[3] = {0.1, -2, 1.6};
    size_t all = 0;
    cd_membrane* banner;
    must(cd_membrane_create(kAlong, kDown, 3, CD_FLOAT32, NULL, &banner));
    for (int j = 0; j < kRows; ++j)
        for (int i = 0; i < kColumns; ++i) x[j][i][0] = 3.0 * i / kAlong - 1.5, x[j][i][2] = 1.8 - 1.0 * j / kDown;
    must(cd_membrane_write_f64(banner, CD_POSITION, 0, 0, kColumns, kRows, x[0][0], kColumns * kRows * 3));
    must(cd_membrane_set_mass(banner, 0.3));
    must(cd_membrane_set_rest_length(banner, 3, 1));
    must(cd_membrane_set_stiffness(banner, 700, 6000)); /* 2000 N a metre of width */
    must(cd_membrane_set_shear(banner, 100));
    must(cd_membrane_set_bend(banner, 1e-5));
    must(cd_membrane_set_gravity(banner, gravity, 3));
    must(cd_membrane_set_air(banner, 0.05, 2));
    must(cd_membrane_set_edge(banner, CD_EDGE_U_FIRST, CD_NODE_PINNED));
    must(cd_membrane_set_edge(banner, CD_EDGE_U_LAST, CD_NODE_PINNED));
    must(cd_membrane_set_breaking_strain(banner, 0.3));
    must(cd_membrane_enable_field(banner, CD_BREAKING_STRAIN_U));
    for (int j = 0; j < kRows; ++j) weak[j] = 0.03;
    must(cd_membrane_write_f64(banner, CD_BREAKING_STRAIN_U, kSeam, 0, 1, kRows, weak, kRows));
    must(cd_membrane_set_colliders(banner, 1));
    must(cd_membrane_set_thickness(banner, 0.02));
    must(cd_membrane_set_capsule(banner, 0, feet, head, 3, 0.2, 0.3));
    must(cd_membrane_set_collider_velocity(banner, 0, velocity, 3));

    printf("  time   the runner is at   a pole holds   torn   in all\n");
    for (int step = 1; step <= 300; ++step) {
        size_t torn;
        double pull = 0;
        if (step == (int)(stops / dt)) must(cd_membrane_set_collider_velocity(banner, 0, still, 3));
        must(cd_membrane_step(banner, dt, 1));
        must(cd_membrane_get_broken(banner, &torn));
        all += torn;
        if (torn == 0 && step % 60 != 0) continue;
        must(cd_membrane_read_f64(banner, CD_TENSION_U, 0, 0, kAlong, kRows, tension, kRows * kAlong));
        for (int j = 0; j < kRows; ++j) pull += fmax(tension[j * kAlong], 0);
        printf("%5.3f s   %11.2f m   %8.0f N   %7zu     %4zu\n", step * dt, feet[1] + speed * fmin(step * dt, stops), pull,
               torn, all);
    }
    cd_membrane_destroy(banner);
    return 0;
}
