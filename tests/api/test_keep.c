/* Saving, loading and copying the state: exact, all or nothing, and deaf to damaged bytes. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "check.h"
#include "scene.h"

enum { STRANDS = 2, SPRINGS = 12, COMPONENTS = 3, ALL_SCENES = SCENES + ROPE_SCENES };

struct blob {
    unsigned char* bytes;
    size_t size;
};

static struct blob save(const cd_chain* chain) {
    struct blob blob = {0};
    size_t written = 0;
    ok(cd_chain_save_size(chain, &blob.size));
    assert_true(blob.size > 0);
    blob.bytes = malloc(blob.size);
    assert_non_null(blob.bytes);
    ok(cd_chain_save(chain, blob.bytes, blob.size, &written));
    assert_int_equal(written, blob.size);
    return blob;
}

static int is_rope(size_t scene) { return scene >= SCENES; }

/* One of all scenes; ropes have CD_METHOD_IMPLICIT. */
static cd_chain* scene_of(size_t scene, cd_precision precision, cd_method method) {
    cd_chain* chain = scene_chain(STRANDS, SPRINGS, COMPONENTS, precision);
    if (is_rope(scene)) rope_scenes[scene - SCENES].build(chain);
    else scenes[scene].build(chain);
    if (!is_rope(scene)) ok(cd_chain_set_method(chain, method));
    ok(cd_chain_step(chain, 0.001, 7));
    return chain;
}

static uint64_t hash_after(cd_chain* chain, size_t steps) {
    ok(cd_chain_step(chain, 0.001, steps));
    return hash_of(chain);
}

/* Everything that the getters and the fields tell. */
static void assert_same_in_all_that_can_be_read(const cd_chain* a, const cd_chain* b) {
    static const struct {
        cd_status (*get)(const cd_chain*, double*);
    } numbers[] = {{cd_chain_get_lambda}, {cd_chain_get_mass},  {cd_chain_get_stiffness},         {cd_chain_get_bend},
                   {cd_chain_get_drag},   {cd_chain_get_time}, {cd_chain_get_stiffness_damping}, {cd_chain_stable_dt},
                   {cd_chain_get_rest_length}};
    for (size_t i = 0; i < COUNT(numbers); ++i) {
        double x = 0, y = 0;
        const cd_status status = numbers[i].get(a, &x);
        assert_true(status == CD_OK || (status == CD_ERROR_UNSUPPORTED && numbers[i].get == cd_chain_stable_dt));
        assert_int_equal(numbers[i].get(b, &y), status);
        assert_same_bits(&x, &y, 1);
    }
    double tolerances[2];
    size_t most[2];
    ok(cd_chain_get_tolerance(a, &tolerances[0], &most[0]));
    ok(cd_chain_get_tolerance(b, &tolerances[1], &most[1]));
    assert_same_bits(&tolerances[0], &tolerances[1], 1);
    assert_int_equal(most[0], most[1]);
    double gravity_a[COMPONENTS], gravity_b[COMPONENTS];
    ok(cd_chain_get_gravity(a, gravity_a, COMPONENTS));
    ok(cd_chain_get_gravity(b, gravity_b, COMPONENTS));
    assert_same_bits(gravity_a, gravity_b, COMPONENTS);
    int32_t enums_a[4], enums_b[4];
    uint64_t steps_a, steps_b;
    ok(cd_chain_get_method(a, &enums_a[0]));
    ok(cd_chain_get_method(b, &enums_b[0]));
    ok(cd_chain_get_mass_rule(a, &enums_a[1]));
    ok(cd_chain_get_mass_rule(b, &enums_b[1]));
    ok(cd_chain_get_ring(a, &enums_a[2]));
    ok(cd_chain_get_ring(b, &enums_b[2]));
    ok(cd_chain_get_push(a, &enums_a[3]));
    ok(cd_chain_get_push(b, &enums_b[3]));
    double air_a[2], air_b[2], wind_a[COMPONENTS], wind_b[COMPONENTS];
    ok(cd_chain_get_air(a, &air_a[0], &air_a[1]));
    ok(cd_chain_get_air(b, &air_b[0], &air_b[1]));
    assert_same_bits(air_a, air_b, 2);
    ok(cd_chain_get_wind(a, wind_a, COMPONENTS));
    ok(cd_chain_get_wind(b, wind_b, COMPONENTS));
    assert_same_bits(wind_a, wind_b, COMPONENTS);
    ok(cd_chain_get_steps(a, &steps_a));
    ok(cd_chain_get_steps(b, &steps_b));
    assert_same_bits(enums_a, enums_b, 4);
    assert_int_equal(steps_a, steps_b);
    double strengths[2];
    ok(cd_chain_get_strength(a, &strengths[0]));
    ok(cd_chain_get_strength(b, &strengths[1]));
    assert_same_bits(&strengths[0], &strengths[1], 1);
    size_t colliders[2];
    double thickness[2];
    ok(cd_chain_get_thickness(a, &thickness[0]));
    ok(cd_chain_get_thickness(b, &thickness[1]));
    assert_same_bits(&thickness[0], &thickness[1], 1);
    ok(cd_chain_get_colliders(a, &colliders[0]));
    ok(cd_chain_get_colliders(b, &colliders[1]));
    assert_int_equal(colliders[0], colliders[1]);
    for (size_t i = 0; i < colliders[0]; ++i) {
        cd_shape shape[2];
        double told[2][3 * COMPONENTS + 2];
        for (int k = 0; k < 2; ++k)
            ok(cd_chain_get_collider(k ? b : a, i, &shape[k], told[k], told[k] + COMPONENTS, told[k] + 2 * COMPONENTS,
                                     COMPONENTS, told[k] + 3 * COMPONENTS, told[k] + 3 * COMPONENTS + 1));
        assert_int_equal(shape[0], shape[1]);
        assert_same_bits(told[0], told[1], COUNT(told[0]));
    }
    for (cd_field field = CD_POSITION; field <= CD_STRAIN; ++field) {
        if (field > CD_TARGET && field < CD_REST_LENGTH) continue;
        double x[STRANDS * (SPRINGS + 1) * COMPONENTS], y[STRANDS * (SPRINGS + 1) * COMPONENTS];
        const size_t strands = scene_field_strands(a, field), items = scene_field_items(a, field);
        const size_t count = scene_field_count(a, field);
        const cd_status status_a = cd_chain_read_f64(a, field, 0, strands, 0, items, x, count);
        const cd_status status_b = cd_chain_read_f64(b, field, 0, strands, 0, items, y, count);
        assert_int_equal(status_a, status_b);
        if (status_a == CD_OK) assert_same_bits(x, y, count);
    }
    for (size_t node = 0; node <= SPRINGS; ++node) {
        double x[2], y[2];
        ok(cd_chain_get_attachment(a, 0, node, &x[0], &x[1]));
        ok(cd_chain_get_attachment(b, 0, node, &y[0], &y[1]));
        assert_same_bits(x, y, 2);
    }
}

static void a_loaded_chain_goes_on_bit_for_bit(void** state) {
    (void)state;
    for (size_t scene = 0; scene < ALL_SCENES; ++scene) {
        for (cd_precision precision = CD_FLOAT32; precision <= CD_FLOAT64; ++precision) {
            for (cd_method method = CD_METHOD_IMPLICIT; method <= CD_METHOD_STIFF_SECOND; ++method) {
                if (is_rope(scene) && method != CD_METHOD_IMPLICIT) continue;
                cd_chain* chain = scene_of(scene, precision, method);
                struct blob blob = save(chain);
                cd_chain* fresh = scene_chain(STRANDS, SPRINGS, COMPONENTS, precision);
                ok(cd_chain_load(fresh, blob.bytes, blob.size));
                assert_int_equal(hash_of(fresh), hash_of(chain));
                assert_same_in_all_that_can_be_read(fresh, chain);
                assert_int_equal(hash_after(fresh, 100), hash_after(chain, 100));
                assert_same_in_all_that_can_be_read(fresh, chain);
                cd_chain_destroy(fresh);
                cd_chain_destroy(chain);
                free(blob.bytes);
            }
        }
    }
}

static void features_follow_the_bytes_and_the_source(void** state) {
    (void)state;
    for (size_t from = 0; from < ALL_SCENES; ++from) {
        for (size_t to = 0; to < ALL_SCENES; ++to) {
            cd_chain* source = scene_of(from, CD_FLOAT64, CD_METHOD_IMPLICIT);
            cd_chain* loaded = scene_of(to, CD_FLOAT64, CD_METHOD_STIFF_SECOND);
            cd_chain* copied = scene_of(to, CD_FLOAT64, CD_METHOD_SYMPLECTIC_EULER);
            struct blob blob = save(source);
            ok(cd_chain_load(loaded, blob.bytes, blob.size));
            ok(cd_chain_copy_state(copied, source));
            assert_same_in_all_that_can_be_read(loaded, source);
            assert_same_in_all_that_can_be_read(copied, source);
            size_t bytes[3];
            ok(cd_chain_get_memory(source, &bytes[0]));
            ok(cd_chain_get_memory(loaded, &bytes[1]));
            ok(cd_chain_get_memory(copied, &bytes[2]));
            assert_int_equal(bytes[1], bytes[0]);
            assert_int_equal(bytes[2], bytes[0]);
            const uint64_t wanted = hash_after(source, 20);
            assert_int_equal(hash_after(loaded, 20), wanted);
            assert_int_equal(hash_after(copied, 20), wanted);
            cd_chain_destroy(source);
            cd_chain_destroy(loaded);
            cd_chain_destroy(copied);
            free(blob.bytes);
        }
    }
}

static void a_rollback_in_the_same_chain_repeats_itself(void** state) {
    (void)state;
    cd_chain* chain = scene_of(8, CD_FLOAT32, CD_METHOD_IMPLICIT);
    cd_chain* snapshot = scene_chain(STRANDS, SPRINGS, COMPONENTS, CD_FLOAT32);
    ok(cd_chain_copy_state(snapshot, chain));
    const uint64_t first = hash_after(chain, 30);
    assert_int_not_equal(first, hash_of(snapshot));
    ok(cd_chain_copy_state(chain, snapshot));
    assert_int_equal(hash_of(chain), hash_of(snapshot));
    assert_int_equal(hash_after(chain, 30), first);
    ok(cd_chain_copy_state(chain, chain));
    assert_int_equal(hash_of(chain), first);
    cd_chain_destroy(chain);
    cd_chain_destroy(snapshot);
}

static void the_parameters_of_the_source_act_at_once(void** state) {
    (void)state;
    for (int by_copy = 0; by_copy <= 1; ++by_copy) {
        cd_chain* soft = scene_of(0, CD_FLOAT64, CD_METHOD_IMPLICIT);
        cd_chain* stiff = scene_of(0, CD_FLOAT64, CD_METHOD_IMPLICIT);
        ok(cd_chain_set_stiffness(stiff, 1e4));
        ok(cd_chain_step(stiff, 0.001, 1)); /* factored for the dt to come, as is the other */
        struct blob blob = save(stiff);
        if (by_copy) ok(cd_chain_copy_state(soft, stiff));
        else ok(cd_chain_load(soft, blob.bytes, blob.size));
        assert_int_equal(hash_after(soft, 5), hash_after(stiff, 5));
        free(blob.bytes);
        cd_chain_destroy(soft);
        cd_chain_destroy(stiff);
    }
}

static void what_was_saved_can_be_loaded_at_the_ends_of_every_range(void** state) {
    (void)state;
    static const struct {
        double mass, other;
    } totals[] = {{1e-60, 1e60}, {1e60, 1e-60}, {1e-60, 0}, {1e60, 1e60}};
    for (size_t i = 0; i < COUNT(totals); ++i) {
        for (int32_t ring = 0; ring <= 1; ++ring) {
            cd_chain* chain = scene_chain(STRANDS, SPRINGS, COMPONENTS, CD_FLOAT32);
            cd_chain* fresh = scene_chain(STRANDS, SPRINGS, COMPONENTS, CD_FLOAT32);
            ok(cd_chain_set_ring(chain, ring));
            ok(cd_chain_set_mass_rule(chain, CD_MASS_HALF_ENDS));
            ok(cd_chain_set_mass(chain, totals[i].mass));
            ok(cd_chain_set_stiffness(chain, totals[i].other));
            ok(cd_chain_set_bend(chain, totals[i].other));
            ok(cd_chain_set_drag(chain, totals[i].other));
            ok(cd_chain_set_stiffness_damping(chain, totals[i].other));
            ok(cd_chain_attach(chain, 0, 3, totals[i].other, totals[i].other, NULL, 0));
            for (cd_field field = CD_POSITION; field <= CD_TARGET; ++field) ok(cd_chain_enable_field(chain, field));
            struct blob blob = save(chain);
            ok(cd_chain_load(fresh, blob.bytes, blob.size));
            assert_int_equal(hash_of(fresh), hash_of(chain));
            free(blob.bytes);
            cd_chain_destroy(chain);
            cd_chain_destroy(fresh);
        }
    }
}

/* Whether springs have a length, or had: what is set for those that have it is kept all the same. */
static void what_is_set_for_ropes_is_kept_at_the_ends_of_every_range(void** state) {
    (void)state;
    static const struct {
        double length, stiffness, tolerance, each, tension;
        size_t most_iterations;
        int32_t push;
    } ropes[] = {{0, 3, 1e-14, 0, 0, 1, 1},
                 {0, 1e60, 0.5, 0, 0, 10000, 0},
                 {1e-60, 1e-60, 1e-6, 0, 1e60, 200, 0},
                 {1e60, 0, 1e-14, 1e60, -1e60, 10000, 1},
                 {1e60, INFINITY, 0.5, 1e-60, 1e-60, 1, 0}};
    for (size_t i = 0; i < COUNT(ropes); ++i) {
        cd_chain* chain = scene_chain(STRANDS, SPRINGS, COMPONENTS, CD_FLOAT32);
        cd_chain* fresh = scene_chain(STRANDS, SPRINGS, COMPONENTS, CD_FLOAT32);
        cd_chain* copied = scene_chain(STRANDS, SPRINGS, COMPONENTS, CD_FLOAT32);
        scene_lengths(copied);
        ok(cd_chain_set_rest_length(chain, ropes[i].length));
        ok(cd_chain_set_stiffness(chain, ropes[i].stiffness));
        ok(cd_chain_set_tolerance(chain, ropes[i].tolerance, ropes[i].most_iterations));
        ok(cd_chain_set_push(chain, ropes[i].push));
        if (ropes[i].each > 0) {
            ok(cd_chain_enable_field(chain, CD_REST_LENGTH));
            scene_set(chain, CD_REST_LENGTH, SPRINGS - 1, ropes[i].each);
        }
        if (ropes[i].length > 0) {
            const double wind[COMPONENTS] = {1e30, -1e30};
            scene_set(chain, CD_TENSION, SPRINGS - 1, ropes[i].tension);
            ok(cd_chain_set_air(chain, i == 3 ? 1e60 : 0, i == 4 ? 1e60 : 1e-300));
            ok(cd_chain_set_wind(chain, wind, COMPONENTS));
            if (i != 3) ok(cd_chain_enable_field(chain, CD_WIND));
            if (i != 4) ok(cd_chain_set_strength(chain, i == 3 ? 1e-60 : 1e60));
            if (i == 4) ok(cd_chain_enable_field(chain, CD_STRENGTH));
            const double far[COMPONENTS] = {1e60, -1e60, 1e60}, near[COMPONENTS] = {-1e60, 5e-324, -0.0};
            if (i != 2) ok(cd_chain_set_thickness(chain, i == 3 ? 1e60 : 5e-324));
            if (i != 3) ok(cd_chain_set_colliders(chain, 4096)); /* and thickness without any in this */
            if (i != 3) ok(cd_chain_set_plane(chain, 7, far, near, COMPONENTS, 1e60));
            if (i != 3) ok(cd_chain_set_capsule(chain, 4095, far, near, COMPONENTS, i == 2 ? 1e60 : 1e-60, 0));
            if (i != 3) ok(cd_chain_set_collider_velocity(chain, 4095, near, COMPONENTS));
        }
        struct blob blob = save(chain);
        ok(cd_chain_load(fresh, blob.bytes, blob.size));
        ok(cd_chain_copy_state(copied, chain));
        assert_int_equal(hash_of(fresh), hash_of(chain));
        assert_same_in_all_that_can_be_read(fresh, chain);
        assert_int_equal(hash_of(copied), hash_of(chain));
        assert_same_in_all_that_can_be_read(copied, chain);
        free(blob.bytes);
        cd_chain_destroy(chain);
        cd_chain_destroy(fresh);
        cd_chain_destroy(copied);
    }
}

/* Chains that never were ropes are saved as they always were: what is set for ropes takes no bytes until it is. */
static void what_is_as_in_a_new_chain_takes_no_bytes(void** state) {
    (void)state;
    cd_chain* chain = scene_chain(STRANDS, SPRINGS, COMPONENTS, CD_FLOAT64);
    size_t before, during, after;
    const uint64_t hash = hash_of(chain);
    ok(cd_chain_save_size(chain, &before));
    ok(cd_chain_set_rest_length(chain, 2));
    ok(cd_chain_save_size(chain, &during));
    assert_true(during >= before + STRANDS * SPRINGS * sizeof(double));
    ok(cd_chain_set_air(chain, 0, -0.0)); /* is none */
    ok(cd_chain_save_size(chain, &after));
    assert_int_equal(after, during);
    ok(cd_chain_set_air(chain, 0, 1));
    ok(cd_chain_save_size(chain, &after));
    assert_true(after > during);
    ok(cd_chain_set_strength(chain, INFINITY)); /* is none */
    ok(cd_chain_set_air(chain, 0, 0));
    ok(cd_chain_save_size(chain, &after));
    assert_int_equal(after, during);
    ok(cd_chain_set_strength(chain, 1));
    ok(cd_chain_disable_field(chain, CD_REST_LENGTH)); /* is off */
    ok(cd_chain_save_size(chain, &after));
    assert_true(after > during);
    const size_t until_then = after;
    ok(cd_chain_set_thickness(chain, -0.0)); /* is none */
    ok(cd_chain_set_colliders(chain, 3));
    ok(cd_chain_save_size(chain, &after));
    assert_true(after > until_then);
    ok(cd_chain_set_colliders(chain, 0));
    ok(cd_chain_save_size(chain, &after));
    assert_int_equal(after, until_then);
    ok(cd_chain_set_thickness(chain, 0.5));
    ok(cd_chain_save_size(chain, &after));
    assert_true(after > until_then);
    ok(cd_chain_set_colliders(chain, 2));
    ok(cd_chain_set_rest_length(chain, -0.0)); /* is 0 */
    ok(cd_chain_disable_field(chain, CD_STIFFNESS));
    ok(cd_chain_save_size(chain, &after));
    assert_int_equal(after, before);
    assert_int_equal(hash_of(chain), hash);
    ok(cd_chain_set_push(chain, 1));
    const uint64_t pushes = hash_of(chain);
    struct blob blob = save(chain);
    ok(cd_chain_load(chain, blob.bytes, blob.size));
    assert_int_equal(hash_of(chain), pushes);
    cd_chain* other = scene_chain(STRANDS, SPRINGS, COMPONENTS, CD_FLOAT64);
    ok(cd_chain_set_push(other, 1));
    assert_int_equal(hash_of(other), pushes);
    free(blob.bytes);
    cd_chain_destroy(chain);
    cd_chain_destroy(other);
}

static void save_writes_what_it_says_and_no_more(void** state) {
    (void)state;
    cd_chain* chain = scene_of(8, CD_FLOAT64, CD_METHOD_IMPLICIT);
    struct blob blob = save(chain);
    unsigned char* large = malloc(blob.size + 64);
    assert_non_null(large);
    memset(large, 0x5A, blob.size + 64);
    size_t written = 0;
    ok(cd_chain_save(chain, large, blob.size + 64, &written));
    assert_int_equal(written, blob.size);
    assert_memory_equal(large, blob.bytes, blob.size);
    for (size_t i = 0; i < 64; ++i) assert_int_equal(large[blob.size + i], 0x5A);
    memset(large, 0x5A, blob.size);
    static const size_t too_small[] = {0, 1, 8, 64};
    for (size_t i = 0; i < COUNT(too_small); ++i)
        refuses(chain, cd_chain_save(chain, large, too_small[i], out.size), CD_ERROR_RANGE,
                name_and_size("size", too_small[i]));
    refuses(chain, cd_chain_save(chain, large, blob.size - 1, out.size), CD_ERROR_RANGE,
            name_and_size("size", blob.size - 1));
    for (size_t i = 0; i < blob.size; ++i) assert_int_equal(large[i], 0x5A);
    free(large);
    free(blob.bytes);
    cd_chain_destroy(chain);
}

static void no_damaged_byte_goes_unseen(void** state) {
    (void)state;
    static const unsigned char flips[] = {0x01, 0x80, 0xFF, 0x10};
    static const size_t sources[] = {8, SCENES};
    for (int k = 0; k < 4; ++k) {
        const cd_precision precision = k % 2;
        cd_chain* source = scene_of(sources[k / 2], precision, CD_METHOD_IMPLICIT);
        cd_chain* chain = scene_of(3, precision, CD_METHOD_IMPLICIT);
        const uint64_t before = hash_of(chain);
        struct blob blob = save(source);
        assert_true(blob.size > 500);
        int said_version = 0, said_kind = 0;
        for (size_t i = 0; i < blob.size; ++i) {
            for (size_t j = 0; j < COUNT(flips); ++j) {
                blob.bytes[i] ^= flips[j];
                if (cd_chain_load(chain, blob.bytes, blob.size) != CD_ERROR_FORMAT || hash_of(chain) != before)
                    fail_msg("byte %zu of %zu, flipped by 0x%02x: %s", i, blob.size, flips[j], cd_error_message());
                said_version |= strstr(cd_error_message(), "version") != NULL;
                said_kind |= strstr(cd_error_message(), "kind") != NULL;
                blob.bytes[i] ^= flips[j];
            }
        }
        assert_true(said_version && said_kind); /* refused for what they are, not as damaged */
        for (size_t i = 0; i + 8 < blob.size; i += 3) { /* two bytes exchanged */
            const unsigned char a = blob.bytes[i], b = blob.bytes[i + 8];
            if (a == b) continue;
            blob.bytes[i] = b, blob.bytes[i + 8] = a;
            assert_int_equal(cd_chain_load(chain, blob.bytes, blob.size), CD_ERROR_FORMAT);
            blob.bytes[i] = a, blob.bytes[i + 8] = b;
        }
        assert_int_equal(hash_of(chain), before);
        ok(cd_chain_load(chain, blob.bytes, blob.size));
        assert_int_equal(hash_of(chain), hash_of(source));
        free(blob.bytes);
        cd_chain_destroy(source);
        cd_chain_destroy(chain);
    }
}

static void no_other_length_is_loaded(void** state) {
    (void)state;
    cd_chain* source = scene_of(8, CD_FLOAT64, CD_METHOD_IMPLICIT);
    cd_chain* chain = scene_of(0, CD_FLOAT64, CD_METHOD_IMPLICIT);
    const uint64_t before = hash_of(chain);
    struct blob blob = save(source);
    for (size_t size = 0; size < blob.size; ++size) {
        unsigned char* cut = malloc(size ? size : 1); /* its own block, so that a read past it is seen */
        assert_non_null(cut);
        memcpy(cut, blob.bytes, size);
        if (cd_chain_load(chain, cut, size) != CD_ERROR_FORMAT || hash_of(chain) != before)
            fail_msg("%zu bytes of %zu: %s", size, blob.size, cd_error_message());
        free(cut);
    }
    unsigned char* longer = calloc(blob.size + 16, 1);
    assert_non_null(longer);
    memcpy(longer, blob.bytes, blob.size);
    refuses(chain, cd_chain_load(chain, longer, blob.size + 1), CD_ERROR_FORMAT, "");
    refuses(chain, cd_chain_load(chain, longer, blob.size + 16), CD_ERROR_FORMAT, "");
    free(longer);
    free(blob.bytes);
    cd_chain_destroy(source);
    cd_chain_destroy(chain);
}

static void foreign_bytes_are_refused(void** state) {
    (void)state;
    cd_chain* chain = scene_of(8, CD_FLOAT64, CD_METHOD_IMPLICIT);
    size_t size;
    ok(cd_chain_save_size(chain, &size));
    unsigned char* bytes = malloc(size);
    assert_non_null(bytes);
    uint64_t seed = 5;
    for (int kind = 0; kind < 20; ++kind) {
        for (size_t i = 0; i < size; ++i)
            bytes[i] = (unsigned char)(kind == 0 ? 0 : kind == 1 ? 0xFF : (uint64_t)(scene_noise(&seed) * 0x1p40));
        refuses(chain, cd_chain_load(chain, bytes, size), CD_ERROR_FORMAT, "");
    }
    free(bytes);
    cd_chain_destroy(chain);
}

static void another_shape_or_precision_is_a_mismatch(void** state) {
    (void)state;
    static const struct {
        size_t strands, springs, components;
        cd_precision precision;
    } other[] = {{STRANDS + 1, SPRINGS, COMPONENTS, CD_FLOAT64}, {STRANDS, SPRINGS + 1, COMPONENTS, CD_FLOAT64},
                 {STRANDS, SPRINGS, COMPONENTS + 1, CD_FLOAT64}, {STRANDS, SPRINGS, COMPONENTS, CD_FLOAT32},
                 {COMPONENTS, SPRINGS, STRANDS, CD_FLOAT64},     {1, SPRINGS, COMPONENTS, CD_FLOAT32}};
    cd_chain* source = scene_of(8, CD_FLOAT64, CD_METHOD_IMPLICIT);
    struct blob blob = save(source);
    for (size_t i = 0; i < COUNT(other); ++i) {
        cd_chain* chain =
            scene_chain(other[i].strands, other[i].springs, other[i].components, other[i].precision);
        scene_welded(chain);
        refuses(chain, cd_chain_load(chain, blob.bytes, blob.size), CD_ERROR_MISMATCH, "");
        refuses(chain, cd_chain_copy_state(chain, source), CD_ERROR_MISMATCH, "");
        cd_chain_destroy(chain);
    }
    free(blob.bytes);
    cd_chain_destroy(source);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_loaded_chain_goes_on_bit_for_bit),
        cmocka_unit_test(features_follow_the_bytes_and_the_source),
        cmocka_unit_test(a_rollback_in_the_same_chain_repeats_itself),
        cmocka_unit_test(the_parameters_of_the_source_act_at_once),
        cmocka_unit_test(what_was_saved_can_be_loaded_at_the_ends_of_every_range),
        cmocka_unit_test(what_is_set_for_ropes_is_kept_at_the_ends_of_every_range),
        cmocka_unit_test(what_is_as_in_a_new_chain_takes_no_bytes),
        cmocka_unit_test(save_writes_what_it_says_and_no_more),
        cmocka_unit_test(no_damaged_byte_goes_unseen),
        cmocka_unit_test(no_other_length_is_loaded),
        cmocka_unit_test(foreign_bytes_are_refused),
        cmocka_unit_test(another_shape_or_precision_is_a_mismatch),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
