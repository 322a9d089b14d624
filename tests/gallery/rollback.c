/* Rollback, as online games do it: what the other player did is known 6 frames late. Each frame's state is kept in a ring
 * of objects; when a late input arrives, the state before it is taken back and the frames since are made again. The
 * outcome is that of a game without delay, to the last bit, whatever processors the players have. */
#include <contdyn/contdyn.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { kFrames = 240, kDelay = 6, kSprings = 40 };

static void must(cd_status status) {
    if (status == CD_OK) return;
    fprintf(stderr, "%s\n", cd_error_message());
    exit(1);
}

static cd_chain* make_rope(void) {
    const double gravity[3] = {0, -9.81, 0};
    double x[3 * (kSprings + 1)] = {0};
    cd_chain* rope;
    must(cd_chain_create(1, kSprings, 3, CD_FLOAT32, NULL, &rope));
    for (int i = 0; i <= kSprings; ++i) x[3 * i + 1] = -2.0 * i / kSprings;
    must(cd_chain_write_f64(rope, CD_POSITION, 0, 1, 0, kSprings + 1, x, 3 * (kSprings + 1)));
    must(cd_chain_set_rest_length(rope, 2));
    must(cd_chain_set_stiffness(rope, INFINITY));
    must(cd_chain_set_gravity(rope, gravity, 3));
    must(cd_chain_set_end(rope, CD_END_FIRST, CD_NODE_PINNED));
    return rope;
}

/* What the other player does in a frame: now and then a blow somewhere at the rope. */
static int input(int frame) { return frame % 17 == 5 ? 10 + frame % 30 : 0; }

static void play(cd_chain* rope, int node) {
    const double blow[3] = {0.02, 0, 0.01 * (node % 5 - 2)}; /* N s */
    if (node) must(cd_chain_impulse(rope, 0, (size_t)node, blow, 3));
    must(cd_chain_step(rope, 1 / 60.0, 1));
}

int main(void) {
    cd_chain *const here = make_rope(), *const there = make_rope(), *ring[kDelay + 1];
    uint64_t ours, theirs;
    int again = 0;
    for (int i = 0; i <= kDelay; ++i) ring[i] = make_rope();
    for (int frame = 0; frame < kFrames + kDelay; ++frame) {
        if (frame < kFrames) play(there, input(frame)); /* who knows it at once */
        const int late = frame - kDelay;                /* what is heard of now */
        if (late >= 0 && input(late)) {
            must(cd_chain_copy_state(here, ring[late % (kDelay + 1)]));
            for (int then = late; then < frame && then < kFrames; ++then, ++again) {
                must(cd_chain_copy_state(ring[then % (kDelay + 1)], here));
                play(here, then == late ? input(then) : 0);
            }
        }
        if (frame >= kFrames) continue;
        must(cd_chain_copy_state(ring[frame % (kDelay + 1)], here));
        play(here, 0); /* as if the other one did nothing */
    }
    must(cd_chain_hash(here, &ours));
    must(cd_chain_hash(there, &theirs));
    printf("%d frames, %d of them made again: the same bits: %s\n", kFrames, again, ours == theirs ? "yes" : "no");
    for (int i = 0; i <= kDelay; ++i) cd_chain_destroy(ring[i]);
    cd_chain_destroy(here);
    cd_chain_destroy(there);
    return ours != theirs;
}
