/* A rope of mass 2 and stiffness 9.81, hung up by its first node under gravity 9.81: at rest its last node hangs
 * mass g / (2 stiffness) = 1 below. And a curtain like it, hung up by its first row. */
#include <contdyn/contdyn.h>

#include <stdio.h>
#include <stdlib.h>

static void check(cd_status status) {
    if (status == CD_OK) return;
    fprintf(stderr, "%s: %s\n", cd_status_name(status), cd_error_message());
    exit(1);
}

static double curtain(void) {
    const double gravity = -9.81;
    double corner;
    cd_membrane* membrane = NULL;

    check(cd_membrane_create(8, 12, 1, CD_FLOAT64, NULL, &membrane));
    check(cd_membrane_set_mass(membrane, 2.0));
    check(cd_membrane_set_stiffness(membrane, 1.0, 9.81));
    check(cd_membrane_set_gravity(membrane, &gravity, 1));
    check(cd_membrane_set_edge(membrane, CD_EDGE_V_FIRST, CD_NODE_PINNED));
    check(cd_membrane_set_lambda(membrane, 1.0));
    check(cd_membrane_step(membrane, 100.0, 20));
    check(cd_membrane_read_f64(membrane, CD_POSITION, 8, 12, 1, 1, &corner, 1));
    cd_membrane_destroy(membrane);
    return corner;
}

int main(void) {
    const double gravity[2] = {0.0, -9.81};
    const size_t springs = 16;
    double last[2];
    cd_chain* chain = NULL;

    check(cd_chain_create(1, springs, 2, CD_FLOAT64, NULL, &chain));
    check(cd_chain_set_mass(chain, 2.0));
    check(cd_chain_set_stiffness(chain, 9.81));
    check(cd_chain_set_gravity(chain, gravity, 2));
    check(cd_chain_set_end(chain, CD_END_FIRST, CD_NODE_PINNED));
    check(cd_chain_set_lambda(chain, 1.0));
    check(cd_chain_step(chain, 100.0, 20));
    check(cd_chain_read_f64(chain, CD_POSITION, 0, 1, springs, 1, last, 2));
    cd_chain_destroy(chain);

    printf("contdyn %s: rope down to %.6f %.6f, curtain down to %.6f\n", cd_version_string(), last[0] + 0.0, last[1],
           curtain());
    return 0;
}
