/* Somebody of 60 kg jumps on a trampoline of 3 m. In the air the jumper falls freely; on the sheet the jumper is mass of
 * the nodes under the feet, whose momentum goes over at landing, and leaves them when they would pull. */
#include <contdyn/contdyn.h>
#include <stdio.h>
#include <stdlib.h>

enum { kSprings = 30, kNodes = kSprings + 1, kFeet = 3, kFirst = (kNodes - kFeet) / 2 };

static void must(cd_status status) {
    if (status == CD_OK) return;
    fprintf(stderr, "%s\n", cd_error_message());
    exit(1);
}

/* One number for each of the nodes under the feet. */
static void write_feet(cd_membrane* sheet, cd_field field, double value) {
    double values[kFeet * kFeet];
    for (int i = 0; i < kFeet * kFeet; ++i) values[i] = value;
    must(cd_membrane_write_f64(sheet, field, kFirst, kFirst, kFeet, kFeet, values, kFeet * kFeet));
}

static double mean_feet(cd_membrane* sheet, cd_field field) {
    double values[kFeet * kFeet], sum = 0;
    must(cd_membrane_read_f64(sheet, field, kFirst, kFirst, kFeet, kFeet, values, kFeet * kFeet));
    for (int i = 0; i < kFeet * kFeet; ++i) sum += values[i];
    return sum / (kFeet * kFeet);
}

int main(void) {
    const double dt = 1 / 480.0, g = 9.81, jumper = 60, under = kFeet * kFeet;
    double z = 1, v = 0, node, highest = 1, deepest = 0, hardest = 0, before = 0;
    int is_on = 0, jumps = 0;
    cd_membrane* sheet;
    must(cd_membrane_create(kSprings, kSprings, 1, CD_FLOAT64, NULL, &sheet));
    for (cd_edge edge = CD_EDGE_U_FIRST; edge <= CD_EDGE_V_LAST; ++edge)
        must(cd_membrane_set_edge(sheet, edge, CD_NODE_PINNED));
    must(cd_membrane_set_mass(sheet, 4));               /* kg */
    must(cd_membrane_set_stiffness(sheet, 2500, 2500)); /* N/m of tension */
    must(cd_membrane_set_drag(sheet, 0.5));             /* 1/s */
    must(cd_membrane_set_solver(sheet, CD_SOLVER_COUPLED));
    must(cd_membrane_enable_field(sheet, CD_MASS));
    must(cd_membrane_enable_field(sheet, CD_FORCE));
    must(cd_membrane_read_f64(sheet, CD_MASS, kFirst, kFirst, 1, 1, &node, 1));

    printf("jump  falls from  lowest    pushed by, at most\n");
    for (int step = 0; step < 20 * 480 && jumps < 8; ++step) {
        const double height = mean_feet(sheet, CD_POSITION), rising = mean_feet(sheet, CD_VELOCITY);
        if (!is_on && v < 0 && z <= height) { /* lands: the momentum is shared */
            write_feet(sheet, CD_MASS, node + jumper / under);
            write_feet(sheet, CD_FORCE, -jumper * g / under);
            write_feet(sheet, CD_VELOCITY, (node * under * rising + jumper * v) / (node * under + jumper));
            is_on = 1, before = v, deepest = hardest = 0;
        } else if (is_on) {
            const double pull = jumper * ((rising - before) / dt + g); /* by the sheet, upwards */
            before = rising, z = height, v = rising;
            if (z < deepest) deepest = z;
            if (pull > hardest) hardest = pull;
            if (pull < 0 && v > 0) { /* springs off */
                write_feet(sheet, CD_MASS, node);
                write_feet(sheet, CD_FORCE, 0);
                printf("%4d  %6.2f m   %6.2f m  %5.0f N\n", ++jumps, highest, deepest, hardest);
                is_on = 0, highest = z;
            }
        }
        if (!is_on) z += dt * (v - 0.5 * dt * g), v -= dt * g;
        if (!is_on && z > highest) highest = z;
        must(cd_membrane_step(sheet, dt, 1));
    }
    cd_membrane_destroy(sheet);
    return 0;
}
