/* Fixed and varying time steps: a rope swings for ten seconds, shown at 30, 60 and 144 frames a second. With a fixed step
 * and what is left over kept for the next frame it moves by the same bits at any frame rate, and so can be replayed.
 * Steps as long as the frames are as stable, and cost one step a frame, but every frame rate has its own motion. */
#include <contdyn/contdyn.h>
#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { kSprings = 50 };

static void must(cd_status status) {
    if (status == CD_OK) return;
    fprintf(stderr, "%s\n", cd_error_message());
    exit(1);
}

static cd_chain* make_rope(void) {
    const double gravity[2] = {0, -9.81};
    double x[2 * (kSprings + 1)];
    cd_chain* rope;
    must(cd_chain_create(1, kSprings, 2, CD_FLOAT64, NULL, &rope));
    for (int i = 0; i <= kSprings; ++i) x[2 * i] = 2.0 * i / kSprings, x[2 * i + 1] = 0; /* 2 m, level */
    must(cd_chain_write_f64(rope, CD_POSITION, 0, 1, 0, kSprings + 1, x, 2 * (kSprings + 1)));
    must(cd_chain_set_rest_length(rope, 2));
    must(cd_chain_set_stiffness(rope, INFINITY));
    must(cd_chain_set_gravity(rope, gravity, 2));
    must(cd_chain_set_air(rope, 0.01, 0.1));
    must(cd_chain_set_end(rope, CD_END_FIRST, CD_NODE_PINNED));
    return rope;
}

/* A game's loop: frames of unequal lengths, rate of them a second in the mean. fixed: the time step, or 0 for steps as
 * long as the frames. */
static void play(double rate, double fixed) {
    cd_chain* const rope = make_rope();
    double now = 0, left_over = 0, end[2], time;
    uint64_t steps, hash;
    for (int frame = 0; now < 10; ++frame) {
        const double stretch = 1 + 0.5 * sin(1.7 * frame); /* what else the machine does */
        const double passed = fmin(stretch / rate, 10 - now);
        now += passed;
        if (fixed == 0) {
            must(cd_chain_step(rope, passed, 1));
            continue;
        }
        left_over += passed;
        const size_t due = (size_t)(left_over / fixed + 1e-9);
        must(cd_chain_step(rope, fixed, due)); /* none is no error */
        left_over -= (double)due * fixed;
    }
    must(cd_chain_read_f64(rope, CD_POSITION, 0, 1, kSprings, 1, end, 2));
    must(cd_chain_get_time(rope, &time));
    must(cd_chain_get_steps(rope, &steps));
    must(cd_chain_hash(rope, &hash));
    printf("%3.0f frames/s  %-14s  %5" PRIu64 " steps  %6.3f s  end at %6.3f %6.3f m  state %016" PRIx64 "\n", rate,
           fixed == 0 ? "one a frame" : "fixed, 1/120 s", steps, time, end[0], end[1], hash);
    cd_chain_destroy(rope);
}

int main(void) {
    const double rates[3] = {30, 60, 144};
    for (int i = 0; i < 3; ++i) play(rates[i], 1 / 120.0);
    for (int i = 0; i < 3; ++i) play(rates[i], 0);
    return 0;
}
