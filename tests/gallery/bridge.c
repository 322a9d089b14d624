/* A rope bridge of 10 m between two cliffs, and walkers who cross it, each heavier than the one before: how far it sags
 * under them, how hard it pulls at the cliffs, and which of them it does not bear. */
#include <contdyn/contdyn.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { kPlanks = 40 };

static void must(cd_status status) {
    if (status == CD_OK) return;
    fprintf(stderr, "%s\n", cd_error_message());
    exit(1);
}

/* The weight of a walker, `at` metres from the near cliff, shared by the two nodes beside: zeros elsewhere. */
static void carry(cd_chain* bridge, double weight, double at) {
    double force[2 * (kPlanks + 1)] = {0};
    const double place = at / 10 * kPlanks;
    const int node = place < kPlanks ? (int)place : kPlanks - 1;
    force[2 * node + 1] = -weight * (1 - (place - node));
    force[2 * node + 3] = -weight * (place - node);
    must(cd_chain_write_f64(bridge, CD_FORCE, 0, 1, 0, kPlanks + 1, force, 2 * (kPlanks + 1)));
}

int main(void) {
    const double gravity[2] = {0, -9.81};
    double x[2 * (kPlanks + 1)], near_cliff[2], far_cliff[2];
    size_t broken = 0;
    cd_chain* bridge;
    must(cd_chain_create(1, kPlanks, 2, CD_FLOAT64, NULL, &bridge));
    for (int i = 0; i <= kPlanks; ++i) x[2 * i] = 10.0 * i / kPlanks, x[2 * i + 1] = 0;
    must(cd_chain_write_f64(bridge, CD_POSITION, 0, 1, 0, kPlanks + 1, x, 2 * (kPlanks + 1)));
    must(cd_chain_set_mass(bridge, 120));          /* kg, planks and all */
    must(cd_chain_set_rest_length(bridge, 10.4));  /* m: it hangs through a little */
    must(cd_chain_set_stiffness(bridge, 4e5));     /* N/m */
    must(cd_chain_set_drag(bridge, 0.5));          /* 1/s */
    must(cd_chain_set_gravity(bridge, gravity, 2));
    must(cd_chain_set_lambda(bridge, 1));          /* what it is not about dies out */
    must(cd_chain_set_end(bridge, CD_END_FIRST, CD_NODE_PINNED));
    must(cd_chain_set_end(bridge, CD_END_LAST, CD_NODE_PINNED));
    must(cd_chain_enable_field(bridge, CD_FORCE));
    must(cd_chain_step(bridge, 1 / 60.0, 600)); /* it comes to rest */
    must(cd_chain_set_strength(bridge, 5000));  /* N; the jerk at the beginning was more */

    printf("  kg    deepest   near cliff   far cliff\n");
    for (int kg = 0; kg <= 240 && !broken; kg += 60) {
        double deepest = 0, near_most = 0, far_most = 0;
        for (int frame = 0; frame <= 600 && !broken; ++frame) { /* at 1 m/s */
            carry(bridge, kg * 9.81, frame / 60.0);
            must(cd_chain_step(bridge, 1 / 60.0, 1));
            must(cd_chain_get_broken(bridge, &broken));
            must(cd_chain_read_f64(bridge, CD_POSITION, 0, 1, 0, kPlanks + 1, x, 2 * (kPlanks + 1)));
            for (int i = 0; i <= kPlanks; ++i) deepest = fmin(deepest, x[2 * i + 1]);
            must(cd_chain_get_reaction(bridge, 0, 0, near_cliff, 2));
            must(cd_chain_get_reaction(bridge, 0, kPlanks, far_cliff, 2));
            near_most = fmax(near_most, hypot(near_cliff[0], near_cliff[1]));
            far_most = fmax(far_most, hypot(far_cliff[0], far_cliff[1]));
        }
        if (broken) printf("%4d    breaks\n", kg);
        else printf("%4d  %6.2f m  %8.0f N  %8.0f N\n", kg, deepest, near_most, far_most);
    }
    cd_chain_destroy(bridge);
    return 0;
}
