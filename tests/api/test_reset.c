/* Reset: back to the start, and what it keeps. */
#include <string.h>

#include "check.h"
#include "scene.h"

enum { STRANDS = 2, SPRINGS = 12, COMPONENTS = 3 };

static cd_chain* moving(scene_build* build) {
    cd_chain* chain = scene_chain(STRANDS, SPRINGS, COMPONENTS, CD_FLOAT64);
    build(chain);
    ok(cd_chain_step(chain, 0.001, 7));
    return chain;
}

static void goes_back_to_the_start_and_keeps_the_rest(scene_build* build, int is_rope) {
    cd_chain* chain = moving(build);
    cd_chain* same = moving(build);
    double x[STRANDS * (SPRINGS + 1) * COMPONENTS], time;
    uint64_t steps;
    ok(cd_chain_reset(chain));
    ok(cd_chain_get_time(chain, &time));
    ok(cd_chain_get_steps(chain, &steps));
    assert_true(time == 0);
    assert_int_equal(steps, 0);
    for (cd_field field = CD_POSITION; field <= CD_VELOCITY; ++field) {
        scene_read(chain, field, x);
        for (size_t i = 0; i < COUNT(x); ++i) assert_true(x[i] == 0);
    }
    if (is_rope) {
        scene_read(chain, CD_TENSION, x);
        for (size_t i = 0; i < scene_field_count(chain, CD_TENSION); ++i) assert_true(x[i] == 0);
    }
    /* what it keeps is all that a fresh chain set up alike has: put the same zeros there by hand */
    memset(x, 0, sizeof x);
    scene_write(same, CD_POSITION, x);
    scene_write(same, CD_VELOCITY, x);
    if (is_rope) scene_write(same, CD_TENSION, x);
    double far[STRANDS * (SPRINGS + 1) * COMPONENTS], near[STRANDS * (SPRINGS + 1) * COMPONENTS];
    ok(cd_chain_step(chain, 0.001, 40));
    ok(cd_chain_step(same, 0.001, 40));
    scene_read(chain, CD_POSITION, far);
    scene_read(same, CD_POSITION, near);
    assert_same_bits(far, near, COUNT(far));
    cd_chain_destroy(chain);
    cd_chain_destroy(same);
}

static void reset_goes_back_to_the_start_and_keeps_the_rest(void** state) {
    (void)state;
    goes_back_to_the_start_and_keeps_the_rest(scene_everything, 0);
    goes_back_to_the_start_and_keeps_the_rest(scene_lengths, 1);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(reset_goes_back_to_the_start_and_keeps_the_rest),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
