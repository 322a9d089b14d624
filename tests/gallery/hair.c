/* Hair on a moving head: 200 strands of 25 cm, rooted in a head that shakes from side to side for three seconds and then
 * holds still. The first two nodes of a strand go from pose to pose, which clamps it; the rest bends, and comes back. The
 * head is a sphere that the hair lies on. */
#include <contdyn/contdyn.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { kStrands = 200, kSprings = 15, kNodes = kSprings + 1 };

static void must(cd_status status) {
    if (status == CD_OK) return;
    fprintf(stderr, "%s\n", cd_error_message());
    exit(1);
}

int main(void) {
    static double x[kStrands][kNodes][3], way[kStrands][3];
    const double gravity[3] = {0, 0, -9.81}, head = 0.1, length = 0.25, dt = 1 / 60.0, turn = 6.283185307179586;
    double centre[3] = {0, 0, 0};
    cd_chain* hair;
    must(cd_chain_create(kStrands, kSprings, 3, CD_FLOAT32, NULL, &hair));
    for (int s = 0; s < kStrands; ++s) { /* on the upper half of the head, evenly, standing off it */
        const double z = 1 - 0.9 * (s + 0.5) / kStrands, around = 2.399963229728653 * s;
        way[s][0] = sqrt(1 - z * z) * cos(around), way[s][1] = sqrt(1 - z * z) * sin(around), way[s][2] = z;
        for (int i = 0; i < kNodes; ++i)
            for (int k = 0; k < 3; ++k) x[s][i][k] = way[s][k] * (head + length * i / kSprings);
    }
    must(cd_chain_write_f64(hair, CD_POSITION, 0, kStrands, 0, kNodes, x[0][0], kStrands * kNodes * 3));
    must(cd_chain_set_mass(hair, 1e-4)); /* kg a strand */
    must(cd_chain_set_rest_length(hair, length));
    must(cd_chain_set_stiffness(hair, INFINITY));
    must(cd_chain_set_bend(hair, 1e-3)); /* bends under its weight, and keeps some of its shape */
    must(cd_chain_enable_field(hair, CD_BEND));
    const double clamp = 2 * 1e-3 * kSprings * kSprings * kSprings; /* twice the bend of the others at node 1 */
    for (int s = 0; s < kStrands; ++s) must(cd_chain_write_f64(hair, CD_BEND, (size_t)s, 1, 1, 1, &clamp, 1));
    must(cd_chain_set_gravity(hair, gravity, 3));
    must(cd_chain_set_air(hair, 1e-4, 1e-3)); /* along it and across */
    must(cd_chain_enable_field(hair, CD_TARGET));
    for (int s = 0; s < kStrands; ++s) {
        const float posed[2] = {CD_NODE_POSED, CD_NODE_POSED};
        must(cd_chain_write_f32(hair, CD_PIN, (size_t)s, 1, 0, 2, posed, 2));
    }
    must(cd_chain_set_colliders(hair, 1));
    must(cd_chain_set_capsule(hair, 0, centre, centre, 3, 0.99 * head, 0.3));

    printf("  time    head    lowest tip   longest strand   deepest in the head\n");
    for (int frame = 1; frame <= 360; ++frame) {
        const double t = frame * dt, next = t < 3 ? 0.15 * sin(turn * t) : 0;
        const double velocity[3] = {(next - centre[0]) / dt, 0, 0};
        for (int s = 0; s < kStrands; ++s) { /* where the roots are at the end of the frame */
            const double first = head, second = head + length / kSprings;
            const double root[2][3] = {{next + first * way[s][0], first * way[s][1], first * way[s][2]},
                                       {next + second * way[s][0], second * way[s][1], second * way[s][2]}};
            must(cd_chain_write_f64(hair, CD_TARGET, (size_t)s, 1, 0, 2, root[0], 6));
        }
        must(cd_chain_set_collider_velocity(hair, 0, velocity, 3));
        must(cd_chain_step(hair, dt, 1));
        centre[0] = next;
        if (frame % 45 != 0) continue;
        double lowest = 1, longest = 0, deepest = 0;
        must(cd_chain_read_f64(hair, CD_POSITION, 0, kStrands, 0, kNodes, x[0][0], kStrands * kNodes * 3));
        for (int s = 0; s < kStrands; ++s) {
            double along = 0;
            for (int i = 0; i < kNodes; ++i) {
                const double* const a = x[s][i];
                const double out = sqrt((a[0] - next) * (a[0] - next) + a[1] * a[1] + a[2] * a[2]);
                deepest = fmax(deepest, 0.99 * head - out);
                if (i == 0) continue;
                const double* const b = x[s][i - 1];
                along += sqrt((a[0] - b[0]) * (a[0] - b[0]) + (a[1] - b[1]) * (a[1] - b[1]) + (a[2] - b[2]) * (a[2] - b[2]));
            }
            longest = fmax(longest, along);
            lowest = fmin(lowest, x[s][kSprings][2]);
        }
        printf("%5.2f s  %4.0f cm    %6.1f cm       %6.2f cm             %4.2f mm\n", t, 100 * next, 100 * lowest,
               100 * longest, 1000 * deepest);
    }
    cd_chain_destroy(hair);
    return 0;
}
