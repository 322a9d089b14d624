/* What diverges, and what does not, in waters only; a diverged one can be looked at. */
#include <math.h>

#include "kept.h"
#include "pool.h"
#include "reference.h"
#include "unstable.h"

enum { NX = 9, NY = 6, MOST = (NX + 1) * (NY + 1) };

static void a_diverged_water_can_be_looked_at(void** state) {
    (void)state;
    for (size_t i = 0; i < unstables[WATER].cases; ++i) {
        double dt, small;
        cd_water* w = unstable_diverged(&unstables[WATER], i, &dt, &small);
        const double at[] = {0, 0, 2.2, 2.6, 4.5, 4.5};
        float vertices[NX * NY][7];
        uint32_t indices[6 * NX * NY];
        double a, b, number[4 * 3];
        ok(cd_water_sample(w, at, 3, CD_OUTSIDE_REFUSED, number, number + 3, NULL, NULL));
        ok(cd_water_sample(w, at, 3, CD_OUTSIDE_REFUSED, NULL, NULL, number, NULL));
        for (int k = 0; k < 3; ++k) /* normals are unit vectors all the same */
            assert_near(number[3 * k] * number[3 * k] + number[3 * k + 1] * number[3 * k + 1] +
                            number[3 * k + 2] * number[3 * k + 2],
                        1, 1e-14, 0);
        ok(cd_water_write_vertices(w, vertices, sizeof vertices, sizeof vertices[0], 0, 12, 24));
        ok(cd_water_write_indices(w, 1, indices, sizeof indices, 4));
        ok(cd_water_get_volume(w, &a));
        ok(cd_water_get_energy(w, &a, &b));
        ok(cd_water_get_wet_area(w, &a));
        ok(cd_water_get_courant(w, 1, &a));
        ok(cd_water_stable_dt(w, &a));
        ok(cd_water_get_account(w, &a, NULL, NULL, &b));
        hash_of(w);
        cd_water_destroy(w);
    }
}

static void enormous_depths_and_velocities_either_step_or_diverge(void** state) {
    (void)state;
    for (size_t s = 0; s < POOLS; ++s)
        for (cd_precision precision = CD_FLOAT32; precision <= CD_FLOAT64; ++precision)
            for (int fast = 0; fast <= 1; ++fast) {
                const struct pool_scene* scene = &pools[s];
                cd_water* w = pool_of(s, NX, NY, precision, 2);
                const double most = precision ? 1.7976931348623157e308 : 0x1.fffffep+127;
                pool_set(w, CD_DEPTH, 5, 2, most);
                pool_set(w, CD_DEPTH, 6, 2, most / 2);
                if (fast) (void)cd_water_write_f64(w, CD_VELOCITY_X, 6, 2, 1, 1, &most, 1);
                const cd_status status = cd_water_step(w, scene->dt, 3);
                assert_true(status == CD_OK || status == CD_ERROR_DIVERGED || status == CD_ERROR_TOLERANCE);
                assert_true(status == CD_ERROR_DIVERGED || kind_is_finite(&kinds[WATER], w));
                uint64_t steps;
                ok(cd_water_get_steps(w, &steps));
                assert_int_equal(steps, 5);
                ok(cd_water_reset(w));
                pool_fill(w, CD_BED, 0);
                pool_step(w, scene->dt, 3);
                assert_true(kind_is_finite(&kinds[WATER], w));
                cd_water_destroy(w);
            }
}

static void a_source_that_overflows_a_single_cell_is_told(void** state) {
    (void)state;
    cd_water* w = pool(1, 1, CD_FLOAT32);
    ok(cd_water_add_source_rectangle(w, 0, 0, 1, 1, 1e19));
    assert_int_equal(cd_water_step(w, 1e28, 1), CD_ERROR_DIVERGED);
    cd_water_destroy(w);
}

static void absent_cells_of_a_diverged_water_are_dry_and_its_bytes_are_taken(void** state) {
    (void)state;
    enum { COLUMNS = 14, CELLS = 2 * COLUMNS };
    static const size_t absent[] = {10, 14, 17, 26};
    cd_water* w;
    double mask[CELLS], depth[CELLS];
    ok(cd_water_create(COLUMNS, 2, 6, 6, CD_FLOAT32, NULL, &w));
    for (size_t k = 0; k < CELLS; ++k) mask[k] = 1;
    for (size_t k = 0; k < COUNT(absent); ++k) mask[absent[k]] = 0;
    ok(cd_water_add_source_rectangle(w, 9, 0, 3, 1, 1e40));
    ok(cd_water_enable_field(w, CD_MASK));
    ok(cd_water_write_f64(w, CD_MASK, 0, 0, COLUMNS, 2, mask, CELLS));
    assert_int_equal(cd_water_step(w, 65, 15), CD_ERROR_DIVERGED);
    ok(cd_water_read_f64(w, CD_DEPTH, 0, 0, COLUMNS, 2, depth, CELLS));
    for (size_t k = 0; k < COUNT(absent); ++k) assert_true(depth[absent[k]] == 0);
    kind_take(&kinds[WATER], w, w, 0);
    cd_water_destroy(w);
}

/* Whatever has become of the others. */
static void no_depth_of_a_water_that_diverged_is_negative(void** state) {
    (void)state;
    size_t diverged = 0;
    for (int kind = 0; kind < 2; ++kind)
        for (uint64_t seed = 1; seed <= 300; ++seed) {
            uint64_t chance = seed;
            double depth[MOST];
            cd_water* w = pool(NX, NY, CD_FLOAT64);
            if (kind) ok(cd_water_set_momentum(w, CD_MOMENTUM_ADVECTED));
            for (size_t j = 0; j < NY; ++j)
                for (size_t i = 0; i < NX; ++i) {
                    const double size = 300 * random_number(&chance); /* 1e-300 to 1e300 */
                    pool_set(w, CD_DEPTH, i, j, pow(10, size));
                }
            diverged += cd_water_step(w, 0.3, 1) == CD_ERROR_DIVERGED;
            pool_read(w, CD_DEPTH, depth);
            for (size_t k = 0; k < NX * NY; ++k) assert_true(!(depth[k] < 0));
            cd_water_destroy(w);
        }
    assert_true(diverged > 0);
}

/* Pools with a source that drain over a low side in explicit steps far beyond their limit. What moves between cells
 * that have run dry is no number, but nobody keeps it. */
static void what_is_finite_has_not_diverged(void** state) {
    (void)state;
    size_t diverged = 0;
    for (uint64_t seed = 1; seed <= 600; ++seed) {
        uint64_t chance = seed;
        const double size = pow(10, -1 + random_number(&chance)); /* 0.01 to 1 m */
        const size_t nx = 8 + (size_t)fabs(6 * random_number(&chance)),
                     ny = 5 + (size_t)fabs(3 * random_number(&chance));
        const double x = size * (double)nx * random_number(&chance), y = size * (double)ny * random_number(&chance);
        cd_water* w;
        ok(cd_water_create(nx, ny, size, size, CD_FLOAT32, NULL, &w));
        ok(cd_water_add_source(w, fabs(x), fabs(y), 2 * size, 0.05));
        ok(cd_water_step(w, 30, 2));
        ok(cd_water_set_momentum(w, CD_MOMENTUM_ADVECTED));
        ok(cd_water_set_method(w, CD_METHOD_SYMPLECTIC_EULER));
        ok(cd_water_step(w, 1e-4, 1));
        ok(cd_water_set_side(w, CD_SIDE_Y_LAST, CD_BORDER_OPEN, -0.75, 0));
        const cd_status status = cd_water_step(w, pow(10, 4 + 2 * random_number(&chance)), 1);
        assert_int_equal(status == CD_OK, kind_is_finite(&kinds[WATER], w));
        diverged += status != CD_OK;
        cd_water_destroy(w);
    }
    assert_in_range(diverged, 1, 599);
}

/* Cells of 2e25 m by 5 m, a source that fills them, steps as long, and a boat: the velocities that it gives the water
 * leave the range of float32. */
static void what_a_hull_gives_the_water_is_judged_too(void** state) {
    (void)state;
    const float depth[27] = {0.59306785669283901f, 1.011950261893237f,
                             0.95867509928062355f, 0,
                             2.1288886136858336f,  1.0523368791203083f,
                             1.8837638239862244f,  2.1075816741086566f,
                             2.5629686078862153f,  1.3564952787044269f,
                             0.22011217339757905f, 0.11549387736820937f,
                             0.37117429381308198f, 2.5703327207724165f,
                             1.8604645540334439f,  2.4648855394069114f,
                             2.4059943325013413f,  0.20561999373790629f,
                             2.2534886120887845f,  0.080862358768355791f,
                             2.9311822222613526f,  2.5138805036421559f,
                             2.5693048926134376f,  0.20469868534172453f,
                             0.24375540069374002f, 0,
                             1.3113046664035455f};
    size_t diverged = 0;
    for (int n = 0; n < 30; ++n) {
        cd_water* w;
        ok(cd_water_create(3, 9, 2.4610161216819493e+25, 4.7590447617187364, CD_FLOAT32, NULL, &w));
        ok(cd_water_set_first(w, 1));
        ok(cd_water_step(w, 0.0072212395556954263, 19));
        ok(cd_water_step(w, 1.103008377861721e+27, 1));
        ok(cd_water_write_f32(w, CD_DEPTH, 0, 0, 3, 9, depth, 27));
        ok(cd_water_step(w, 2.7200387109441727e-22, 1));
        ok(cd_water_set_side(w, CD_SIDE_Y_FIRST, CD_BORDER_PERIODIC, 0, 0));
        ok(cd_water_step(w, 0.00051940634242299386, 3));
        ok(cd_water_set_hulls(w, 1, 5, 4));
        ok(cd_water_step(w, 3.5015370244059104e-10, 17));
        ok(cd_water_set_hull(w, 0, 1521.7050576534295, 39.291291219271713, 31.557785495741484, NULL, 0));
        ok(cd_water_set_lambda(w, 0.25));
        ok(cd_water_set_side(w, CD_SIDE_X_LAST, CD_BORDER_OPEN, -0.13728154446905294, 0));
        ok(cd_water_step(w, 173.37636742735293, 4));
        ok(cd_water_step(w, 1.1645622989477834e-06, 1));
        ok(cd_water_step(w, 3.7856260226592164e-26, 3));
        ok(cd_water_step(w, 0.62716375407628355, 1));
        ok(cd_water_add_source_rectangle(w, 2, 3, 1, 3, 9.4244593735184653e+25));
        ok(cd_water_launch_hull(w, 0, 4.31909198678421e+25, 11.762093958652859, -0.17541514244922385,
                                0.62204846913594602));
        const cd_status status = cd_water_step(w, 1.2152804681559582e+26 * pow(1.3, n), 1);
        assert_int_equal(status == CD_OK, kind_is_finite(&kinds[WATER], w));
        diverged += status != CD_OK;
        cd_water_destroy(w);
    }
    assert_in_range(diverged, 1, 29);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_diverged_water_can_be_looked_at),
        cmocka_unit_test(enormous_depths_and_velocities_either_step_or_diverge),
        cmocka_unit_test(a_source_that_overflows_a_single_cell_is_told),
        cmocka_unit_test(absent_cells_of_a_diverged_water_are_dry_and_its_bytes_are_taken),
        cmocka_unit_test(no_depth_of_a_water_that_diverged_is_negative),
        cmocka_unit_test(what_is_finite_has_not_diverged),
        cmocka_unit_test(what_a_hull_gives_the_water_is_judged_too),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
