/* A water's result depends neither on who runs the tasks and in what order, nor on how steps share calls, nor on the
 * rows beside. */
#include <stdlib.h>

#include "check.h"
#include "jobs.h"
#include "pool.h"

/* Large enough to be dealt out in several parts. */
static void the_job_system_leaves_no_trace(void** state) {
    (void)state;
    for (size_t scene = 0; scene < POOLS; ++scene)
        for (cd_precision precision = CD_FLOAT32; precision <= CD_FLOAT64; ++precision) {
            if (is_brief() && (scene + precision) % 2) continue;
            uint64_t hashes[3];
            size_t tasks = 0;
            for (size_t how = 0; how < 3; ++how) {
                struct jobs jobs = {0};
                const cd_parallel parallel = how == 1 ? jobs_reversed(&jobs) : jobs_threads(&jobs);
                cd_water* w = pool(67, 61, precision);
                pools[scene].build(w);
                ok(cd_water_set_parallel(w, how == 0 ? NULL : &parallel));
                pool_step(w, pools[scene].dt, 2);
                hashes[how] = hash_of(w);
                tasks = jobs.tasks;
                cd_water_destroy(w);
            }
            assert_true(tasks > 10);
            assert_int_equal(hashes[1], hashes[0]);
            assert_int_equal(hashes[2], hashes[0]);
        }
}

static void steps_at_once_are_steps_one_by_one(void** state) {
    (void)state;
    for (size_t scene = 0; scene < POOLS; scene += is_brief() ? 5 : 1)
        for (cd_precision precision = CD_FLOAT32; precision <= CD_FLOAT64; ++precision) {
            cd_water* at_once = pool_of(scene, 9, 12, precision, 0);
            cd_water* singly = pool_of(scene, 9, 12, precision, 0);
            const double dt = 0.7 * pools[scene].dt; /* whose multiples round */
            pool_step(at_once, dt, 30);
            for (int i = 0; i < 30; ++i) pool_step(singly, dt, 1);
            if (hash_of(at_once) != hash_of(singly)) fail_msg("%s, float%d", pools[scene].name, precision ? 64 : 32);
            cd_water_destroy(at_once);
            cd_water_destroy(singly);
        }
}

/* Of a level that changes, in which part of a step its value is taken counts too: lambda of it. */
static void a_level_that_changes_is_the_same_in_steps_one_by_one(void** state) {
    (void)state;
    for (int part = 0; part < 50; part += is_brief() ? 7 : 1) {
        uint64_t hashes[2];
        for (int singly = 0; singly < 2; ++singly) {
            cd_water* w = pool(20, 1, CD_FLOAT64);
            pool_fill(w, CD_DEPTH, 1);
            ok(cd_water_set_lambda(w, 0.5 + 0.01 * part));
            ok(cd_water_set_side(w, CD_SIDE_X_FIRST, CD_BORDER_OPEN, 1, 1));
            for (int calls = 0; calls < 20 * (singly ? 3 : 1); ++calls) pool_step(w, 0.1, singly ? 1 : 3);
            hashes[singly] = hash_of(w);
            cd_water_destroy(w);
        }
        if (hashes[0] != hashes[1]) fail_msg("lambda %g", 0.5 + 0.01 * part);
    }
}

/* ---- rows that have nothing to do with each other ---- */

enum { NX = 21, ROWS = 19, MOST = (NX + 1) * (ROWS + 1) };

/* Walls between all rows, and in each what the slice has. */
static cd_water* many_rows(const cd_water* slice, cd_precision precision) {
    cd_water* w = pool(NX, ROWS, precision);
    double row[NX + 1], all[MOST];
    cd_momentum momentum;
    ok(cd_water_get_momentum(slice, &momentum));
    double lambda, manning, drag;
    ok(cd_water_get_lambda(slice, &lambda));
    ok(cd_water_get_manning(slice, &manning));
    ok(cd_water_get_drag(slice, &drag));
    cd_method method;
    ok(cd_water_get_method(slice, &method));
    ok(cd_water_set_momentum(w, momentum));
    ok(cd_water_set_method(w, method));
    ok(cd_water_set_lambda(w, lambda));
    ok(cd_water_set_manning(w, manning));
    ok(cd_water_set_drag(w, drag));
    for (cd_side side = CD_SIDE_X_FIRST; side <= CD_SIDE_X_LAST; ++side) {
        cd_border kind;
        double value, rate;
        ok(cd_water_get_side(slice, side, &kind, &value, &rate));
        ok(cd_water_set_side(w, side, kind, value, rate));
    }
    ok(cd_water_enable_field(w, CD_WALL_Y));
    for (size_t k = 0; k < MOST; ++k) all[k] = 1;
    pool_write(w, CD_WALL_Y, all);
    static const cd_field fields[] = {CD_BED, CD_DEPTH, CD_VELOCITY_X, CD_FORCE_X};
    for (size_t f = 0; f < COUNT(fields); ++f) {
        if (!pool_has(slice, fields[f])) continue;
        const size_t columns = pool_extent(slice, fields[f]).columns;
        ok(cd_water_enable_field(w, fields[f]));
        pool_read(slice, fields[f], row);
        for (size_t k = 0; k < columns * ROWS; ++k) all[k] = row[k % columns];
        pool_write(w, fields[f], all);
    }
    return w;
}

static void a_slice_goes_as_each_of_many_rows_apart(void** state) {
    (void)state;
    static const struct {
        pool_build* build;
        double dt;
    } slices[] = {{pool_beach, 0.1},     {pool_dam, 0.05}, {pool_flood, 0.5},  {pool_explicit, 0.02},
                  {pool_forward, 0.002}, {pool_tide, 0.1}, {pool_river, 0.05}, {pool_torus, 0.1}};
    for (size_t s = 0; s < COUNT(slices); s += is_brief() ? 3 : 1)
        for (cd_precision precision = CD_FLOAT32; precision <= CD_FLOAT64; ++precision) {
            cd_water* slice = pool(NX, 1, precision);
            slices[s].build(slice);
            ok(cd_water_set_side(slice, CD_SIDE_Y_FIRST, CD_BORDER_WALL, 0, 0));
            ok(cd_water_set_side(slice, CD_SIDE_Y_LAST, CD_BORDER_WALL, 0, 0));
            ok(cd_water_disable_field(slice, CD_FORCE_Y));
            cd_water* rows = many_rows(slice, precision);
            pool_step(slice, slices[s].dt, 40);
            pool_step(rows, slices[s].dt, 40);
            static const cd_field fields[] = {CD_DEPTH, CD_VELOCITY_X};
            for (size_t f = 0; f < COUNT(fields); ++f) {
                const size_t columns = pool_extent(slice, fields[f]).columns;
                double alone[NX + 1], among[MOST];
                pool_read(slice, fields[f], alone);
                pool_read(rows, fields[f], among);
                for (size_t k = 0; k < columns * ROWS; ++k)
                    if (among[k] != alone[k % columns])
                        fail_msg("slice %zu, float%d: %.17g alone, %.17g in row %zu", s, precision ? 64 : 32,
                                 alone[k % columns], among[k], k / columns);
            }
            cd_water_destroy(slice);
            cd_water_destroy(rows);
        }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_job_system_leaves_no_trace),
        cmocka_unit_test(steps_at_once_are_steps_one_by_one),
        cmocka_unit_test(a_level_that_changes_is_the_same_in_steps_one_by_one),
        cmocka_unit_test(a_slice_goes_as_each_of_many_rows_apart),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
