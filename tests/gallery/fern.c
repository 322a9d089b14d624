/* Ferns that unroll and then sway in a wind: in a plane, where a rod may have rest angles. Each frond is clamped in the
 * ground by its first two nodes. Its rest angles grow towards the tip, so that it is a spiral, and become smaller as it
 * opens: it is they that move it. */
#include <contdyn/contdyn.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { kFronds = 7, kSprings = 40, kNodes = kSprings + 1 };

static void must(cd_status status) {
    if (status == CD_OK) return;
    fprintf(stderr, "%s\n", cd_error_message());
    exit(1);
}

/* By how much a frond is rolled up from end to end [rad]: at first by 12; from second 0 to 5 it opens. */
static double rolled_up(double t) {
    const double opened = t < 0 ? 0 : t < 5 ? 0.5 - 0.5 * cos(3.141592653589793 * t / 5) : 1;
    return 12 - 11 * opened;
}
/* How far node i is turned by that at rest, clockwise: more towards the tip. */
static double angle_at(int i, double all) {
    const double part = (double)i / kSprings;
    return -all * part * part / (kSprings / 3.0);
}

int main(void) {
    static double x[kFronds][kNodes][2], angle[kFronds][kNodes];
    const double gravity[2] = {0, -9.81}, length = 0.6, dt = 1 / 60.0, turn = 6.283185307179586;
    const double pins[2] = {CD_NODE_PINNED, CD_NODE_PINNED}, stiff = 0.02;
    cd_chain* fern;
    must(cd_chain_create(kFronds, kSprings, 2, CD_FLOAT32, NULL, &fern));
    for (int f = 0; f < kFronds; ++f) { /* rolled up */
        double way = turn / 4;
        x[f][0][0] = 0.25 * f;
        for (int i = 1; i < kNodes; ++i) {
            way += i > 1 ? angle_at(i - 1, rolled_up(0)) : 0;
            x[f][i][0] = x[f][i - 1][0] + length / kSprings * cos(way);
            x[f][i][1] = x[f][i - 1][1] + length / kSprings * sin(way);
        }
    }
    must(cd_chain_write_f64(fern, CD_POSITION, 0, kFronds, 0, kNodes, x[0][0], kFronds * kNodes * 2));
    must(cd_chain_set_mass(fern, 1e-3)); /* kg a frond */
    must(cd_chain_set_rest_length(fern, length));
    must(cd_chain_set_stiffness(fern, INFINITY));
    must(cd_chain_set_push(fern, 1)); /* it stands */
    must(cd_chain_set_bend(fern, stiff));
    must(cd_chain_enable_field(fern, CD_BEND));
    const double clamp = 2 * stiff * kSprings * kSprings * kSprings; /* twice the bend of the others at node 1 */
    for (int f = 0; f < kFronds; ++f) {
        must(cd_chain_write_f64(fern, CD_BEND, (size_t)f, 1, 1, 1, &clamp, 1));
        must(cd_chain_write_f64(fern, CD_PIN, (size_t)f, 1, 0, 2, pins, 2));
    }
    must(cd_chain_enable_field(fern, CD_REST_ANGLE));
    must(cd_chain_set_gravity(fern, gravity, 2));
    must(cd_chain_set_air(fern, 0.002, 0.02)); /* along it and across */
    must(cd_chain_set_lambda(fern, 1));

    printf("  time      wind    first: turns   height of the tips, lowest and highest\n");
    for (int frame = 1; frame <= 600; ++frame) {
        const double t = frame * dt, wind[2] = {t < 5 ? 0 : 2 * sin(turn * (t - 5) / 3), 0};
        for (int f = 0; f < kFronds; ++f) /* one after the other */
            for (int i = 0; i < kNodes; ++i) angle[f][i] = angle_at(i, rolled_up(t - 0.2 * f));
        must(cd_chain_write_f64(fern, CD_REST_ANGLE, 0, kFronds, 0, kNodes, angle[0], kFronds * kNodes));
        must(cd_chain_set_wind(fern, wind, 2));
        must(cd_chain_step(fern, dt, 1));
        if (frame % 75 != 0) continue;
        double lowest = 1, highest = 0;
        must(cd_chain_read_f64(fern, CD_POSITION, 0, kFronds, kSprings, 1, x[0][0], kFronds * 2));
        for (int f = 0; f < kFronds; ++f)
            lowest = fmin(lowest, (&x[0][0][1])[2 * f]), highest = fmax(highest, (&x[0][0][1])[2 * f]);
        printf("%5.2f s  %4.1f m/s       %5.2f      %4.1f to %4.1f cm\n", t, wind[0], rolled_up(t) / turn, 100 * lowest,
               100 * highest);
    }
    cd_chain_destroy(fern);
    return 0;
}
