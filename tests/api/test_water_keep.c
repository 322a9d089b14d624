/* Saving, loading, copying and resetting a water: exact, all or nothing, and deaf to damaged bytes. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "check.h"
#include "cloth.h"
#include "pool.h"
#include "scene.h"

enum { NX = 6, NY = 5, MOST = (NX + 1) * (NY + 1) };

struct blob {
    unsigned char* bytes;
    size_t size;
};

static struct blob save(const cd_water* w) {
    struct blob blob = {0};
    size_t written = 0;
    ok(cd_water_save_size(w, &blob.size));
    assert_true(blob.size > 0);
    blob.bytes = malloc(blob.size);
    assert_non_null(blob.bytes);
    ok(cd_water_save(w, blob.bytes, blob.size, &written));
    assert_int_equal(written, blob.size);
    return blob;
}

static cd_water* scene_of(size_t scene, cd_precision precision) { return pool_of(scene, NX, NY, precision, 7); }

static uint64_t hash_after(cd_water* w, double dt, size_t steps) {
    pool_step(w, dt, steps);
    return hash_of(w);
}

/* Everything that the getters and the fields tell. */
static void assert_same_in_all_that_can_be_read(const cd_water* a, const cd_water* b) {
    static cd_status (*const numbers[])(const cd_water*, double*) = {
        cd_water_get_lambda, cd_water_get_gravity, cd_water_get_density, cd_water_get_drag,     cd_water_get_manning,
        cd_water_get_time,   cd_water_stable_dt,   cd_water_get_volume,  cd_water_get_wet_area,
    };
    static cd_status (*const enums[])(const cd_water*, int32_t*) = {cd_water_get_method, cd_water_get_momentum,
                                                                    cd_water_get_first, cd_water_get_bed_rule};
    const cd_water* const both[2] = {a, b};
    for (size_t i = 0; i < COUNT(numbers); ++i) {
        double x[2];
        for (int k = 0; k < 2; ++k) ok(numbers[i](both[k], &x[k]));
        assert_same_bits(&x[0], &x[1], 1);
    }
    for (size_t i = 0; i < COUNT(enums); ++i) {
        int32_t x[2];
        for (int k = 0; k < 2; ++k) ok(enums[i](both[k], &x[k]));
        assert_int_equal(x[0], x[1]);
    }
    struct {
        double size[2], value[4], rate[4], account[4], energy[2], courant;
        int32_t kind[4];
        uint64_t steps;
    } told[2];
    memset(told, 0, sizeof told);
    for (int k = 0; k < 2; ++k) {
        ok(cd_water_get_shape(both[k], NULL, NULL, &told[k].size[0], &told[k].size[1], NULL));
        ok(cd_water_get_steps(both[k], &told[k].steps));
        ok(cd_water_get_energy(both[k], &told[k].energy[0], &told[k].energy[1]));
        ok(cd_water_get_courant(both[k], 0.1, &told[k].courant));
        double* const account = told[k].account;
        ok(cd_water_get_account(both[k], &account[0], &account[1], &account[2], &account[3]));
        for (cd_side side = CD_SIDE_X_FIRST; side <= CD_SIDE_Y_LAST; ++side)
            ok(cd_water_get_side(both[k], side, &told[k].kind[side], &told[k].value[side], &told[k].rate[side]));
    }
    assert_memory_equal(&told[0], &told[1], sizeof told[0]);
    for (cd_field field = CD_MASK; field <= CD_WALL_Y; ++field) {
        double x[2][MOST];
        assert_int_equal(pool_has(a, field), pool_has(b, field));
        if (!pool_has(a, field)) continue;
        for (int k = 0; k < 2; ++k) pool_read(both[k], field, x[k]);
        assert_same_bits(x[0], x[1], pool_extent(a, field).count);
    }
}

static void a_loaded_water_goes_on_bit_for_bit(void** state) {
    (void)state;
    for (size_t scene = 0; scene < POOLS; ++scene) {
        for (cd_precision precision = CD_FLOAT32; precision <= CD_FLOAT64; ++precision) {
            const double dt = pools[scene].dt;
            cd_water* w = scene_of(scene, precision);
            struct blob blob = save(w);
            cd_water* fresh = NULL;
            ok(cd_water_create(NX, NY, 3, 4, precision, NULL, &fresh)); /* takes the cells' size over */
            ok(cd_water_load(fresh, blob.bytes, blob.size));
            assert_int_equal(hash_of(fresh), hash_of(w));
            assert_same_in_all_that_can_be_read(fresh, w);
            assert_int_equal(hash_after(fresh, dt, 50), hash_after(w, dt, 50));
            assert_same_in_all_that_can_be_read(fresh, w);
            cd_water_destroy(fresh);
            cd_water_destroy(w);
            free(blob.bytes);
        }
    }
}

static void what_is_saved_again_is_the_same(void** state) {
    (void)state;
    for (size_t scene = 0; scene < POOLS; ++scene) {
        cd_water* w = scene_of(scene, CD_FLOAT32);
        cd_water* fresh = pool(NX, NY, CD_FLOAT32);
        struct blob first = save(w);
        ok(cd_water_load(fresh, first.bytes, first.size));
        struct blob second = save(fresh);
        assert_int_equal(first.size, second.size);
        assert_memory_equal(first.bytes, second.bytes, first.size);
        free(first.bytes);
        free(second.bytes);
        cd_water_destroy(w);
        cd_water_destroy(fresh);
    }
}

static void features_follow_the_bytes_and_the_source(void** state) {
    (void)state;
    for (size_t from = 0; from < POOLS; ++from) {
        for (size_t to = 0; to < POOLS; ++to) {
            const double dt = pools[from].dt;
            cd_water* source = scene_of(from, CD_FLOAT64);
            cd_water* loaded = scene_of(to, CD_FLOAT64);
            cd_water* copied = scene_of(to, CD_FLOAT64);
            struct blob blob = save(source);
            ok(cd_water_load(loaded, blob.bytes, blob.size));
            ok(cd_water_copy_state(copied, source));
            assert_same_in_all_that_can_be_read(loaded, source);
            assert_same_in_all_that_can_be_read(copied, source);
            size_t bytes[3];
            ok(cd_water_get_memory(source, &bytes[0]));
            ok(cd_water_get_memory(loaded, &bytes[1]));
            ok(cd_water_get_memory(copied, &bytes[2]));
            assert_int_equal(bytes[1], bytes[0]);
            assert_int_equal(bytes[2], bytes[0]);
            const uint64_t wanted = hash_after(source, dt, 20);
            assert_int_equal(hash_after(loaded, dt, 20), wanted);
            assert_int_equal(hash_after(copied, dt, 20), wanted);
            cd_water_destroy(source);
            cd_water_destroy(loaded);
            cd_water_destroy(copied);
            free(blob.bytes);
        }
    }
}

static void a_rollback_in_the_same_water_repeats_itself(void** state) {
    (void)state;
    for (size_t scene = 0; scene < POOLS; ++scene) {
        const double dt = pools[scene].dt;
        cd_water* w = scene_of(scene, CD_FLOAT32);
        cd_water* snapshot = pool(NX, NY, CD_FLOAT32);
        ok(cd_water_copy_state(snapshot, w));
        const uint64_t first = hash_after(w, dt, 30);
        assert_int_not_equal(first, hash_of(snapshot));
        ok(cd_water_copy_state(w, snapshot));
        assert_int_equal(hash_of(w), hash_of(snapshot));
        assert_int_equal(hash_after(w, dt, 30), first);
        ok(cd_water_copy_state(w, w));
        assert_int_equal(hash_of(w), first);
        cd_water_destroy(w);
        cd_water_destroy(snapshot);
    }
}

static void what_was_saved_can_be_loaded_at_the_ends_of_every_range(void** state) {
    (void)state;
    static const struct {
        double cell, lambda, gravity, density, drag, manning, value;
    } ends[] = {{1e-30, 0, 0, 1e-6, 0, 0, -1e60}, {1e30, 1, 1e6, 1e6, 1e60, 1e3, 1e60}};
    for (size_t i = 0; i < COUNT(ends); ++i) {
        cd_water *w = NULL, *fresh = pool(NX, NY, CD_FLOAT64);
        ok(cd_water_create(NX, NY, ends[i].cell, ends[1 - i].cell, CD_FLOAT64, NULL, &w));
        ok(cd_water_set_momentum(w, CD_MOMENTUM_ADVECTED));
        ok(cd_water_set_lambda(w, ends[i].lambda));
        ok(cd_water_set_gravity(w, ends[i].gravity));
        ok(cd_water_set_density(w, ends[i].density));
        ok(cd_water_set_drag(w, ends[i].drag));
        ok(cd_water_set_manning(w, ends[i].manning));
        ok(cd_water_step(w, i ? 1e30 : 1e-30, 3)); /* dry: only time runs */
        ok(cd_water_set_side(w, CD_SIDE_X_FIRST, CD_BORDER_INFLOW, ends[i].value, -ends[i].value));
        ok(cd_water_set_side(w, CD_SIDE_X_LAST, CD_BORDER_OPEN, ends[i].value, ends[i].value));
        ok(cd_water_set_side(w, CD_SIDE_Y_LAST, CD_BORDER_PERIODIC, 0, 0));
        for (cd_field field = CD_MASK; field <= CD_WALL_Y; ++field) {
            ok(cd_water_enable_field(w, field));
            if (field >= CD_SOURCE && field <= CD_FORCE_Y) pool_fill(w, field, i ? 1e308 : -1e308);
        }
        pool_fill(w, CD_BED, -1e307);
        pool_fill(w, CD_DEPTH, 1e307);
        pool_fill(w, CD_VELOCITY_Y, -1e308);
        struct blob blob = save(w);
        ok(cd_water_load(fresh, blob.bytes, blob.size));
        assert_int_equal(hash_of(fresh), hash_of(w));
        free(blob.bytes);
        cd_water_destroy(w);
        cd_water_destroy(fresh);
    }
}

static void save_writes_what_it_says_and_no_more(void** state) {
    (void)state;
    cd_water* w = scene_of(POOL_EVERYTHING, CD_FLOAT64);
    struct blob blob = save(w);
    unsigned char* large = malloc(blob.size + 64);
    assert_non_null(large);
    memset(large, 0x5A, blob.size + 64);
    size_t written = 0;
    ok(cd_water_save(w, large, blob.size + 64, &written));
    assert_int_equal(written, blob.size);
    assert_memory_equal(large, blob.bytes, blob.size);
    for (size_t i = 0; i < 64; ++i) assert_int_equal(large[blob.size + i], 0x5A);
    memset(large, 0x5A, blob.size);
    const size_t too_small[] = {0, 1, 8, 64, blob.size - 1};
    for (size_t i = 0; i < COUNT(too_small); ++i)
        refuses(w, cd_water_save(w, large, too_small[i], out.size), CD_ERROR_RANGE,
                name_and_size("size", too_small[i]));
    for (size_t i = 0; i < blob.size; ++i) assert_int_equal(large[i], 0x5A);
    free(large);
    free(blob.bytes);
    cd_water_destroy(w);
}

static void no_damaged_byte_goes_unseen(void** state) {
    (void)state;
    static const unsigned char flips[] = {0x01, 0x80, 0xFF};
    for (cd_precision precision = CD_FLOAT32; precision <= CD_FLOAT64; ++precision) {
        cd_water* source = scene_of(POOL_EVERYTHING, precision);
        cd_water* w = scene_of(0, precision);
        const uint64_t before = hash_of(w);
        struct blob blob = save(source);
        assert_true(blob.size > 500);
        int said_version = 0, said_kind = 0;
        for (size_t i = 0; i < blob.size; ++i) {
            for (size_t j = 0; j < COUNT(flips); ++j) {
                blob.bytes[i] ^= flips[j];
                if (cd_water_load(w, blob.bytes, blob.size) != CD_ERROR_FORMAT)
                    fail_msg("byte %zu of %zu, flipped by 0x%02x: %s", i, blob.size, flips[j], cd_error_message());
                said_version |= strstr(cd_error_message(), "version") != NULL;
                said_kind |= strstr(cd_error_message(), "kind") != NULL;
                blob.bytes[i] ^= flips[j];
            }
        }
        assert_true(said_version && said_kind); /* refused for what they are, not as damaged */
        assert_int_equal(hash_of(w), before);
        ok(cd_water_load(w, blob.bytes, blob.size));
        assert_int_equal(hash_of(w), hash_of(source));
        free(blob.bytes);
        cd_water_destroy(source);
        cd_water_destroy(w);
    }
}

static void no_other_length_is_loaded(void** state) {
    (void)state;
    cd_water* source = scene_of(POOL_EVERYTHING, CD_FLOAT32);
    cd_water* w = scene_of(0, CD_FLOAT32);
    const uint64_t before = hash_of(w);
    struct blob blob = save(source);
    for (size_t size = 0; size < blob.size; ++size) {
        unsigned char* cut = malloc(size ? size : 1); /* its own block, so that a read past it is seen */
        assert_non_null(cut);
        memcpy(cut, blob.bytes, size);
        if (cd_water_load(w, cut, size) != CD_ERROR_FORMAT)
            fail_msg("%zu bytes of %zu: %s", size, blob.size, cd_error_message());
        free(cut);
    }
    assert_int_equal(hash_of(w), before);
    unsigned char* longer = calloc(blob.size + 16, 1);
    assert_non_null(longer);
    memcpy(longer, blob.bytes, blob.size);
    refuses(w, cd_water_load(w, longer, blob.size + 1), CD_ERROR_FORMAT, "");
    refuses(w, cd_water_load(w, longer, blob.size + 16), CD_ERROR_FORMAT, "");
    free(longer);
    free(blob.bytes);
    cd_water_destroy(source);
    cd_water_destroy(w);
}

static void a_membrane_is_not_loaded_as_a_water_nor_the_other_way_round(void** state) {
    (void)state;
    cd_water* w = scene_of(POOL_EVERYTHING, CD_FLOAT64);
    cd_membrane* membrane = cloth(NX, NY, 1, CD_FLOAT64);
    cd_chain* chain = scene_chain(NX, NY, 1, CD_FLOAT64);
    struct blob blob = save(w);
    refuses(membrane, cd_membrane_load(membrane, blob.bytes, blob.size), CD_ERROR_FORMAT, "~|kind|3|membrane|2");
    refuses(chain, cd_chain_load(chain, blob.bytes, blob.size), CD_ERROR_FORMAT, "~|kind|3|chain|1");
    size_t size;
    ok(cd_membrane_save_size(membrane, &size));
    unsigned char* bytes = malloc(size);
    assert_non_null(bytes);
    ok(cd_membrane_save(membrane, bytes, size, &size));
    refuses(w, cd_water_load(w, bytes, size), CD_ERROR_FORMAT, "~|kind|2|water|3");
    free(bytes);
    free(blob.bytes);
    cd_chain_destroy(chain);
    cd_membrane_destroy(membrane);
    cd_water_destroy(w);
}

static void another_shape_or_precision_is_a_mismatch(void** state) {
    (void)state;
    static const struct {
        size_t nx, ny;
        cd_precision precision;
    } other[] = {{NX + 1, NY, CD_FLOAT64},
                 {NX, NY + 1, CD_FLOAT64},
                 {NX, NY, CD_FLOAT32},
                 {NY, NX, CD_FLOAT64},
                 {1, 1, CD_FLOAT64}};
    cd_water* source = scene_of(POOL_EVERYTHING, CD_FLOAT64);
    struct blob blob = save(source);
    for (size_t i = 0; i < COUNT(other); ++i) {
        cd_water* w = pool_of(1, other[i].nx, other[i].ny, other[i].precision, 2);
        refuses(w, cd_water_load(w, blob.bytes, blob.size), CD_ERROR_MISMATCH, "");
        refuses(w, cd_water_copy_state(w, source), CD_ERROR_MISMATCH, "~source|water");
        cd_water_destroy(w);
    }
    free(blob.bytes);
    cd_water_destroy(source);
}

static void reset_goes_back_to_the_start_and_keeps_the_rest(void** state) {
    (void)state;
    for (size_t scene = 0; scene < POOLS; ++scene) {
        cd_water* w = scene_of(scene, CD_FLOAT64);
        cd_water* before = scene_of(scene, CD_FLOAT64);
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
        cd_water* same = scene_of(scene, CD_FLOAT64);
        pool_step(same, pools[scene].dt, 3); /* wherever it stands */
        ok(cd_water_reset(same));
        for (cd_side side = CD_SIDE_X_FIRST; side <= CD_SIDE_Y_LAST; ++side) {
            cd_border kind;
            ok(cd_water_get_side(w, side, &kind, NULL, NULL));
            if (kind == CD_BORDER_PERIODIC) continue;
            ok(cd_water_set_side(w, side, kind, 0.1, 0));
            ok(cd_water_set_side(same, side, kind, 0.1, 0));
        }
        assert_int_equal(hash_after(w, pools[scene].dt, 10), hash_after(same, pools[scene].dt, 10));
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
        cmocka_unit_test(a_loaded_water_goes_on_bit_for_bit),
        cmocka_unit_test(what_is_saved_again_is_the_same),
        cmocka_unit_test(features_follow_the_bytes_and_the_source),
        cmocka_unit_test(a_rollback_in_the_same_water_repeats_itself),
        cmocka_unit_test(what_was_saved_can_be_loaded_at_the_ends_of_every_range),
        cmocka_unit_test(save_writes_what_it_says_and_no_more),
        cmocka_unit_test(no_damaged_byte_goes_unseen),
        cmocka_unit_test(no_other_length_is_loaded),
        cmocka_unit_test(a_membrane_is_not_loaded_as_a_water_nor_the_other_way_round),
        cmocka_unit_test(another_shape_or_precision_is_a_mismatch),
        cmocka_unit_test(reset_goes_back_to_the_start_and_keeps_the_rest),
        cmocka_unit_test(a_tide_begins_again_with_time),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
