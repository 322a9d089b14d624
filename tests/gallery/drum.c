/* A drum, hit in the middle. */
#include <contdyn/contdyn.h>
#include <stdio.h>

int main(void) {
    cd_membrane* drum;
    const double kick = 0.02; /* N s */
    double height;
    if (cd_membrane_create(64, 64, 1, CD_FLOAT32, NULL, &drum)) return puts(cd_error_message()), 1;
    for (cd_edge edge = CD_EDGE_U_FIRST; edge <= CD_EDGE_V_LAST; ++edge)
        cd_membrane_set_edge(drum, edge, CD_NODE_PINNED);
    cd_membrane_set_mass(drum, 0.2);         /* kg */
    cd_membrane_set_stiffness(drum, 20, 20); /* N/m: its lowest note is sqrt(20 / 0.2 / 2) = 7.1 Hz */
    cd_membrane_set_drag(drum, 2);           /* 1/s */
    cd_membrane_impulse(drum, 32, 32, 8, &kick, 1);
    for (int frame = 0; frame <= 16; ++frame) {
        cd_membrane_read_f64(drum, CD_POSITION, 32, 32, 1, 1, &height, 1);
        if (frame % 4 == 0) printf("%.3f s: %7.4f\n", frame / 60.0, height);
        cd_membrane_step(drum, 1 / 240.0, 4);
    }
    cd_membrane_destroy(drum);
    return 0;
}
