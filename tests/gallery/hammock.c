/* A hammock between two trees: its cloth, the strings at both ends of that, the rings that these run to and the ropes
 * that the rings hang on are one sheet. Somebody sits down in it, is pushed, and gets up. */
#include <contdyn/contdyn.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { kAcross = 12, kRope = 6, kStrings = 8, kCloth = 24, kColumns = kAcross + 1, kMiddle = kAcross / 2 };
enum { kHem = kRope + kStrings, kAlong = 2 * kHem + kCloth, kRows = kAlong + 1, kCentre = kAlong / 2 };

static void must(cd_status status) {
    if (status == CD_OK) return;
    fprintf(stderr, "%s\n", cd_error_message());
    exit(1);
}

int main(void) {
    static double x[kRows][kColumns][3], there[kRows][kColumns], empty[kRows][kColumns], taken[kRows][kColumns];
    static double length[kRows][kAcross], stiffness[kRows][kAcross];
    const double gravity[3] = {0, 0, -9.81}, size = 0.08 * kAlong, width = 0.9, ring = 0.02, trees = 3.8, dt = 1 / 60.0;
    const double pinned = CD_NODE_PINNED, push[3] = {0, 2, 0}; /* N s for each node that somebody sits on */
    cd_membrane* hammock;
    for (int j = 0; j < kRows; ++j) {
        const int end = j < kCentre ? j : kAlong - j; /* rows from the nearer tree */
        const double spread = end < kRope ? 0 : end < kHem ? (double)(end - kRope) / kStrings : 1;
        for (int i = 0; i < kColumns; ++i) {
            const int sits = abs(j - kCentre) <= 4 && abs(i - kMiddle) <= 2;
            x[j][i][0] = trees * ((double)j / kAlong - 0.5), x[j][i][2] = 1.5;
            x[j][i][1] = (ring + spread * (width - ring)) * ((double)i / kAcross - 0.5);
            there[j][i] = end >= kRope || i == kMiddle; /* of a rope's rows one node is left */
            empty[j][i] = 0.003, taken[j][i] = sits ? 60 / 45.0 : 0.003;
            if (i == kAcross) continue;
            length[j][i] = (end == kRope ? ring : width) / kAcross;
            stiffness[j][i] = end == kRope || end >= kHem ? 1e5 : 0; /* strings are not tied to each other */
        }
    }
    must(cd_membrane_create(kAcross, kAlong, 3, CD_FLOAT64, NULL, &hammock));
    must(cd_membrane_write_f64(hammock, CD_POSITION, 0, 0, kColumns, kRows, x[0][0], kColumns * kRows * 3));
    must(cd_membrane_set_rest_length(hammock, width, size));
    must(cd_membrane_set_stiffness(hammock, 1e5, 1e5));
    must(cd_membrane_set_shear(hammock, 1e3));
    must(cd_membrane_set_gravity(hammock, gravity, 3));
    must(cd_membrane_set_lambda(hammock, 0.6));
    must(cd_membrane_enable_field(hammock, CD_MASK));
    must(cd_membrane_write_f64(hammock, CD_MASK, 0, 0, kColumns, kRows, there[0], kColumns * kRows));
    must(cd_membrane_enable_field(hammock, CD_STIFFNESS_U));
    must(cd_membrane_write_f64(hammock, CD_STIFFNESS_U, 0, 0, kAcross, kRows, stiffness[0], kAcross * kRows));
    must(cd_membrane_enable_field(hammock, CD_REST_LENGTH_U));
    must(cd_membrane_write_f64(hammock, CD_REST_LENGTH_U, 0, 0, kAcross, kRows, length[0], kAcross * kRows));
    must(cd_membrane_enable_field(hammock, CD_PIN));
    must(cd_membrane_write_f64(hammock, CD_PIN, kMiddle, 0, 1, 1, &pinned, 1));
    must(cd_membrane_write_f64(hammock, CD_PIN, kMiddle, kAlong, 1, 1, &pinned, 1));
    must(cd_membrane_enable_field(hammock, CD_MASS));
    must(cd_membrane_write_f64(hammock, CD_MASS, 0, 0, kColumns, kRows, empty[0], kColumns * kRows));

    printf("  time   middle: height   to the side   pull at a tree: along   down\n");
    for (int frame = 1; frame <= 600; ++frame) {
        const double* const mass = frame == 121 ? taken[0] : frame == 421 ? empty[0] : NULL;
        if (mass) must(cd_membrane_write_f64(hammock, CD_MASS, 0, 0, kColumns, kRows, mass, kColumns * kRows));
        for (int j = -4; j <= 4 && frame == 181; ++j)
            for (int i = -2; i <= 2; ++i)
                must(cd_membrane_impulse(hammock, (size_t)(kMiddle + i), (size_t)(kCentre + j), 1, push, 3));
        must(cd_membrane_step(hammock, dt, 1));
        if (frame % 30 != 0) continue;
        double middle[3], pull[3];
        must(cd_membrane_read_f64(hammock, CD_POSITION, kMiddle, kCentre, 1, 1, middle, 3));
        must(cd_membrane_get_reaction(hammock, kMiddle, 0, pull, 3));
        printf("%4.1f s         %5.2f m       %5.2f m                %4.0f N  %4.0f N\n", frame * dt, middle[2],
               middle[1], pull[0], -pull[2]);
    }
    cd_membrane_destroy(hammock);
    return 0;
}
