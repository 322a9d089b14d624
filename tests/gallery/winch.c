/* A grappling hook with a winch: someone of 70 kg swings on a rope that is reeled in meanwhile. What the winch does
 * against the pull becomes height and speed. The rope does not stretch, however hard it pulls. */
#include <contdyn/contdyn.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { kSprings = 32 };

static void must(cd_status status) {
    if (status == CD_OK) return;
    fprintf(stderr, "%s\n", cd_error_message());
    exit(1);
}

int main(void) {
    const double gravity[2] = {0, -9.81}, person = 70;
    double x[2 * (kSprings + 1)], end[2], v[2], pull[2], length = 12;
    cd_chain* rope;
    must(cd_chain_create(1, kSprings, 2, CD_FLOAT64, NULL, &rope));
    for (int i = 0; i <= kSprings; ++i) { /* taut, 60 degrees from the vertical */
        x[2 * i] = length * i / kSprings * 0.8660254;
        x[2 * i + 1] = -length * i / kSprings * 0.5;
    }
    must(cd_chain_write_f64(rope, CD_POSITION, 0, 1, 0, kSprings + 1, x, 2 * (kSprings + 1)));
    must(cd_chain_set_mass(rope, 1.5)); /* kg */
    must(cd_chain_enable_field(rope, CD_MASS));
    must(cd_chain_write_f64(rope, CD_MASS, 0, 1, kSprings, 1, &person, 1));
    must(cd_chain_set_rest_length(rope, length));
    must(cd_chain_set_stiffness(rope, INFINITY));
    must(cd_chain_set_gravity(rope, gravity, 2));
    must(cd_chain_set_end(rope, CD_END_FIRST, CD_NODE_PINNED)); /* the hook */

    printf("  time   rope     from the hook      speed    pull\n");
    for (int frame = 0; frame <= 360; ++frame) {
        if (frame % 45 == 0) {
            must(cd_chain_read_f64(rope, CD_POSITION, 0, 1, kSprings, 1, end, 2));
            must(cd_chain_read_f64(rope, CD_VELOCITY, 0, 1, kSprings, 1, v, 2));
            must(cd_chain_get_reaction(rope, 0, 0, pull, 2));
            printf("%5.2f s  %5.2f m  %6.2f %6.2f m  %5.2f m/s  %5.0f N\n", frame / 60.0, length, end[0], end[1],
                   hypot(v[0], v[1]), hypot(pull[0], pull[1]));
        }
        if (frame >= 90 && length > 4) { /* 2 m/s, after one and a half seconds */
            length = fmax(4, length - 2 / 60.0);
            must(cd_chain_set_rest_length(rope, length));
        }
        must(cd_chain_step(rope, 1 / 60.0, 1));
    }
    cd_chain_destroy(rope);
    return 0;
}
