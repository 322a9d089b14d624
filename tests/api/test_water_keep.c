/* What is kept of waters only: their settings at the ends of their ranges, and what a reset leaves. */
#include "kept.h"
#include "pool.h"

enum { NX = 6, NY = 5, MOST = (NX + 1) * (NY + 1) };

static void what_was_saved_can_be_loaded_at_the_ends_of_every_range(void** state) {
    (void)state;
    static const struct {
        double cell, lambda, gravity, density, drag, manning, value, depth;
    } ends[] = {{1e-30, 0, 0, 1e-6, 0, 0, -1e60, 1e-6}, {1e30, 1, 1e6, 1e6, 1e60, 1e3, 1e60, 1e30}};
    for (size_t i = 0; i < COUNT(ends); ++i) {
        cd_water* w = NULL;
        ok(cd_water_create(NX, NY, ends[i].cell, ends[1 - i].cell, CD_FLOAT64, NULL, &w));
        ok(cd_water_set_momentum(w, CD_MOMENTUM_ADVECTED));
        ok(cd_water_set_lambda(w, ends[i].lambda));
        ok(cd_water_set_gravity(w, ends[i].gravity));
        ok(cd_water_set_density(w, ends[i].density));
        ok(cd_water_set_drag(w, ends[i].drag));
        ok(cd_water_set_manning(w, ends[i].manning));
        ok(cd_water_step(w, i ? 1e30 : 1e-30, 3)); /* dry: only time runs */
        ok(cd_water_set_side(w, CD_SIDE_X_FIRST, CD_BORDER_INFLOW, ends[i].value, -ends[i].value));
        ok(cd_water_set_inflow_depth(w, CD_SIDE_X_FIRST, ends[i].depth));
        ok(cd_water_set_side(w, CD_SIDE_X_LAST, CD_BORDER_OPEN, ends[i].value, ends[i].value));
        ok(cd_water_set_side(w, CD_SIDE_Y_LAST, CD_BORDER_PERIODIC, 0, 0));
        for (cd_field field = CD_MASK; field <= CD_WALL_Y; ++field) {
            ok(cd_water_enable_field(w, field));
            if (field >= CD_SOURCE && field <= CD_FORCE_Y) pool_fill(w, field, i ? 1e308 : -1e308);
        }
        pool_fill(w, CD_BED, -1e307);
        pool_fill(w, CD_DEPTH, 1e307);
        pool_fill(w, CD_VELOCITY_Y, -1e308);
        kept_assert_all(&kept_kinds[WATER], w, CD_FLOAT64);
        cd_water_destroy(w);
    }
}

static void reset_goes_back_to_the_start_and_keeps_the_rest(void** state) {
    (void)state;
    for (size_t scene = 0; scene < POOLS; ++scene) {
        cd_water* w = pool_of(scene, NX, NY, CD_FLOAT64, 7);
        cd_water* before = pool_of(scene, NX, NY, CD_FLOAT64, 7);
        ok(cd_water_reset(w));
        double x[2][MOST], account[4];
        for (cd_field field = CD_MASK; field <= CD_WALL_Y; ++field) {
            if (!pool_has(w, field) || field == CD_SURFACE) continue;
            const int state_field = field == CD_DEPTH || field == CD_VELOCITY_X || field == CD_VELOCITY_Y;
            pool_read(w, field, x[0]);
            pool_read(before, field, x[1]);
            for (size_t k = 0; k < pool_extent(w, field).count; ++k)
                assert_true(x[0][k] == (state_field ? 0 : x[1][k]));
        }
        ok(cd_water_get_account(w, &account[0], &account[1], &account[2], &account[3]));
        for (int k = 0; k < 4; ++k) assert_true(account[k] == 0);
        cd_water* same = pool_of(scene, NX, NY, CD_FLOAT64, 7);
        pool_step(same, pools[scene].dt, 3); /* wherever it stands */
        ok(cd_water_reset(same));
        for (cd_side side = CD_SIDE_X_FIRST; side <= CD_SIDE_Y_LAST; ++side) {
            cd_border kind;
            ok(cd_water_get_side(w, side, &kind, NULL, NULL));
            if (kind == CD_BORDER_PERIODIC) continue;
            ok(cd_water_set_side(w, side, kind, 0.1, 0));
            ok(cd_water_set_side(same, side, kind, 0.1, 0));
        }
        pool_step(w, pools[scene].dt, 10);
        pool_step(same, pools[scene].dt, 10);
        assert_int_equal(hash_of(w), hash_of(same));
        cd_water_destroy(w);
        cd_water_destroy(before);
        cd_water_destroy(same);
    }
}

/* Parameters stay: a tide is what it was at the beginning of time, which is where a reset goes. */
static void a_tide_begins_again_with_time(void** state) {
    (void)state;
    cd_water* w = pool(NX, NY, CD_FLOAT64);
    ok(cd_water_set_side(w, CD_SIDE_X_FIRST, CD_BORDER_OPEN, 0.5, 0.25));
    ok(cd_water_step(w, 0.5, 4));
    double value, rate;
    ok(cd_water_get_side(w, CD_SIDE_X_FIRST, NULL, &value, &rate));
    assert_true(value == 1 && rate == 0.25);
    ok(cd_water_reset(w));
    ok(cd_water_get_side(w, CD_SIDE_X_FIRST, NULL, &value, &rate));
    assert_true(value == 0.5 && rate == 0.25);
    cd_water_destroy(w);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_was_saved_can_be_loaded_at_the_ends_of_every_range),
        cmocka_unit_test(reset_goes_back_to_the_start_and_keeps_the_rest),
        cmocka_unit_test(a_tide_begins_again_with_time),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
