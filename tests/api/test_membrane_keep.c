/* Saving, loading, copying and resetting a membrane: exact, all or nothing, and deaf to damaged bytes. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "check.h"
#include "cloth.h"
#include "scene.h"

enum { NU = 6, NV = 5, COMPONENTS = 3, NODES = (NU + 1) * (NV + 1), ALL = NODES * COMPONENTS };
enum { EVERYTHING = 8, LENGTHS = CLOTHS + 1, ALL_SCENES = CLOTHS + LENGTH_CLOTHS };

struct blob {
    unsigned char* bytes;
    size_t size;
};

static struct blob save(const cd_membrane* m) {
    struct blob blob = {0};
    size_t written = 0;
    ok(cd_membrane_save_size(m, &blob.size));
    assert_true(blob.size > 0);
    blob.bytes = malloc(blob.size);
    assert_non_null(blob.bytes);
    ok(cd_membrane_save(m, blob.bytes, blob.size, &written));
    assert_int_equal(written, blob.size);
    return blob;
}

static int has_lengths(size_t scene) { return scene >= CLOTHS; }

/* One of all scenes; those whose springs have a length have CD_METHOD_IMPLICIT. */
static cd_membrane* scene_of(size_t scene, cd_precision precision, cd_method method) {
    cd_membrane* m = cloth(NU, NV, COMPONENTS, precision);
    if (has_lengths(scene)) length_cloths[scene - CLOTHS].build(m);
    else cloths[scene].build(m);
    if (!has_lengths(scene)) ok(cd_membrane_set_method(m, method));
    ok(cd_membrane_step(m, 0.001, 7));
    return m;
}

static uint64_t hash_after(cd_membrane* m, size_t steps) {
    ok(cd_membrane_step(m, 0.001, steps));
    return hash_of(m);
}

/* Everything that the getters and the fields tell. */
static void assert_same_in_all_that_can_be_read(const cd_membrane* a, const cd_membrane* b) {
    static cd_status (*const numbers[])(const cd_membrane*, double*) = {
        cd_membrane_get_lambda,   cd_membrane_get_mass, cd_membrane_get_bend,   cd_membrane_get_drag,
        cd_membrane_get_pressure, cd_membrane_get_time, cd_membrane_get_volume, cd_membrane_get_stiffness_damping,
        cd_membrane_get_shear,    cd_membrane_get_compression, cd_membrane_get_thickness, cd_membrane_stable_dt,
        cd_membrane_get_breaking_strain};
    static cd_status (*const enums[])(const cd_membrane*, int32_t*) = {cd_membrane_get_method, cd_membrane_get_solver,
                                                                       cd_membrane_get_mass_rule};
    const cd_membrane* const both[2] = {a, b};
    for (size_t i = 0; i < COUNT(numbers); ++i) {
        double x[2] = {-7, -7};
        cd_status status[2];
        for (int k = 0; k < 2; ++k) status[k] = numbers[i](both[k], &x[k]);
        assert_int_equal(status[0], status[1]);
        assert_true(status[0] == CD_OK || numbers[i] == cd_membrane_stable_dt); /* which cloth has none of */
        assert_same_bits(&x[0], &x[1], 1);
    }
    for (size_t i = 0; i < COUNT(enums); ++i) {
        int32_t x[2];
        for (int k = 0; k < 2; ++k) ok(enums[i](both[k], &x[k]));
        assert_int_equal(x[0], x[1]);
    }
    struct {
        double stiffness[2], gravity[COMPONENTS], tolerance, length[2], air[2], wind[COMPONENTS];
        int32_t ring[2], edge[4];
        size_t most, newton, gradient, colliders;
        uint64_t steps;
    } told[2];
    memset(told, 0, sizeof told);
    for (int k = 0; k < 2; ++k) {
        ok(cd_membrane_get_stiffness(both[k], &told[k].stiffness[0], &told[k].stiffness[1]));
        ok(cd_membrane_get_gravity(both[k], told[k].gravity, COMPONENTS));
        ok(cd_membrane_get_tolerance(both[k], &told[k].tolerance, &told[k].most));
        ok(cd_membrane_get_ring(both[k], &told[k].ring[0], &told[k].ring[1]));
        ok(cd_membrane_get_steps(both[k], &told[k].steps));
        ok(cd_membrane_get_rest_length(both[k], &told[k].length[0], &told[k].length[1]));
        ok(cd_membrane_get_effort(both[k], &told[k].newton, &told[k].gradient));
        ok(cd_membrane_get_air(both[k], &told[k].air[0], &told[k].air[1]));
        ok(cd_membrane_get_wind(both[k], told[k].wind, COMPONENTS));
        ok(cd_membrane_get_colliders(both[k], &told[k].colliders));
        for (cd_edge edge = CD_EDGE_U_FIRST; edge <= CD_EDGE_V_LAST; ++edge)
            ok(cd_membrane_get_edge(both[k], edge, &told[k].edge[edge]));
    }
    assert_memory_equal(&told[0], &told[1], sizeof told[0]);
    for (size_t i = 0; i < told[0].colliders; ++i) {
        cd_shape shape[2];
        double x[2][3 * COMPONENTS + 2];
        for (int k = 0; k < 2; ++k)
            ok(cd_membrane_get_collider(both[k], i, &shape[k], x[k], x[k] + COMPONENTS, x[k] + 2 * COMPONENTS,
                                        COMPONENTS, x[k] + 3 * COMPONENTS, x[k] + 3 * COMPONENTS + 1));
        assert_int_equal(shape[0], shape[1]);
        assert_same_bits(x[0], x[1], COUNT(x[0]));
    }
    for (cd_field field = CD_POSITION; field <= CD_BREAKING_STRAIN_V; ++field) {
        double x[2][ALL];
        cd_status status[2];
        const struct cloth_extent e = cloth_extent(a, field);
        for (int k = 0; k < 2; ++k)
            status[k] = cd_membrane_read_f64(both[k], field, 0, 0, e.columns, e.rows, x[k], e.count);
        assert_int_equal(status[0], status[1]);
        if (status[0] == CD_OK) assert_same_bits(x[0], x[1], e.count);
    }
    for (size_t node = 0; node < NODES; ++node) {
        double x[2][2];
        for (int k = 0; k < 2; ++k)
            ok(cd_membrane_get_attachment(both[k], node % (NU + 1), node / (NU + 1), &x[k][0], &x[k][1]));
        assert_same_bits(x[0], x[1], 2);
    }
}

static void a_loaded_membrane_goes_on_bit_for_bit(void** state) {
    (void)state;
    for (size_t scene = 0; scene < ALL_SCENES; ++scene) {
        for (cd_precision precision = CD_FLOAT32; precision <= CD_FLOAT64; ++precision) {
            for (cd_method method = CD_METHOD_IMPLICIT; method <= CD_METHOD_STIFF_SECOND; ++method) {
                if (has_lengths(scene) && method != CD_METHOD_IMPLICIT) continue;
                cd_membrane* m = scene_of(scene, precision, method);
                struct blob blob = save(m);
                cd_membrane* fresh = cloth(NU, NV, COMPONENTS, precision);
                ok(cd_membrane_load(fresh, blob.bytes, blob.size));
                assert_int_equal(hash_of(fresh), hash_of(m));
                assert_same_in_all_that_can_be_read(fresh, m);
                assert_int_equal(hash_after(fresh, 40), hash_after(m, 40));
                assert_same_in_all_that_can_be_read(fresh, m);
                cd_membrane_destroy(fresh);
                cd_membrane_destroy(m);
                free(blob.bytes);
            }
        }
    }
}

static void features_follow_the_bytes_and_the_source(void** state) {
    (void)state;
    for (size_t from = 0; from < ALL_SCENES; ++from) {
        for (size_t to = 0; to < ALL_SCENES; ++to) {
            cd_membrane* source = scene_of(from, CD_FLOAT64, CD_METHOD_IMPLICIT);
            cd_membrane* loaded = scene_of(to, CD_FLOAT64, CD_METHOD_STIFF_SECOND);
            cd_membrane* copied = scene_of(to, CD_FLOAT64, CD_METHOD_SYMPLECTIC_EULER);
            struct blob blob = save(source);
            ok(cd_membrane_load(loaded, blob.bytes, blob.size));
            ok(cd_membrane_copy_state(copied, source));
            assert_same_in_all_that_can_be_read(loaded, source);
            assert_same_in_all_that_can_be_read(copied, source);
            size_t bytes[3];
            ok(cd_membrane_get_memory(source, &bytes[0]));
            ok(cd_membrane_get_memory(loaded, &bytes[1]));
            ok(cd_membrane_get_memory(copied, &bytes[2]));
            assert_int_equal(bytes[1], bytes[0]);
            assert_int_equal(bytes[2], bytes[0]);
            const uint64_t wanted = hash_after(source, 20);
            assert_int_equal(hash_after(loaded, 20), wanted);
            assert_int_equal(hash_after(copied, 20), wanted);
            cd_membrane_destroy(source);
            cd_membrane_destroy(loaded);
            cd_membrane_destroy(copied);
            free(blob.bytes);
        }
    }
}

static void a_rollback_of(size_t scene) {
    cd_membrane* m = scene_of(scene, CD_FLOAT32, CD_METHOD_IMPLICIT);
    cd_membrane* snapshot = cloth(NU, NV, COMPONENTS, CD_FLOAT32);
    ok(cd_membrane_copy_state(snapshot, m));
    const uint64_t first = hash_after(m, 30);
    assert_int_not_equal(first, hash_of(snapshot));
    ok(cd_membrane_copy_state(m, snapshot));
    assert_int_equal(hash_of(m), hash_of(snapshot));
    assert_int_equal(hash_after(m, 30), first);
    ok(cd_membrane_copy_state(m, m));
    assert_int_equal(hash_of(m), first);
    cd_membrane_destroy(m);
    cd_membrane_destroy(snapshot);
}

static void a_rollback_in_the_same_membrane_repeats_itself(void** state) {
    (void)state;
    a_rollback_of(EVERYTHING);
    a_rollback_of(LENGTHS);
}

static void the_parameters_of_the_source_act_at_once(void** state) {
    (void)state;
    for (int by_copy = 0; by_copy <= 3; ++by_copy) {
        const size_t scene = by_copy < 2 ? 1 : CLOTHS;
        cd_membrane* soft = scene_of(scene, CD_FLOAT64, CD_METHOD_IMPLICIT);
        cd_membrane* stiff = scene_of(scene, CD_FLOAT64, CD_METHOD_IMPLICIT);
        ok(cd_membrane_set_stiffness(stiff, 1e4, 1e3));
        if (has_lengths(scene)) ok(cd_membrane_set_rest_length(stiff, 0.75, 0.5));
        ok(cd_membrane_step(stiff, 0.001, 1)); /* factored for the dt to come, as is the other */
        struct blob blob = save(stiff);
        if (by_copy % 2) ok(cd_membrane_copy_state(soft, stiff));
        else ok(cd_membrane_load(soft, blob.bytes, blob.size));
        assert_int_equal(hash_after(soft, 5), hash_after(stiff, 5));
        free(blob.bytes);
        cd_membrane_destroy(soft);
        cd_membrane_destroy(stiff);
    }
}

static void what_was_saved_can_be_loaded_at_the_ends_of_every_range(void** state) {
    (void)state;
    static const struct {
        double mass, other, tolerance;
        size_t most;
    } totals[] = {{1e-60, 1e60, 1e-14, 1}, {1e60, 1e-60, 0.5, SIZE_MAX}, {1e-60, 0, 0.5, 1}, {1e60, 1e60, 1e-14, 7}};
    for (size_t i = 0; i < COUNT(totals); ++i) {
        for (int32_t ring = 0; ring <= 1; ++ring) {
            cd_membrane* m = cloth(NU, NV, COMPONENTS, CD_FLOAT32);
            cd_membrane* fresh = cloth(NU, NV, COMPONENTS, CD_FLOAT32);
            const double other = totals[i].other;
            ok(cd_membrane_set_ring(m, ring, 1 - ring));
            ok(cd_membrane_set_mass_rule(m, CD_MASS_HALF_ENDS));
            ok(cd_membrane_set_mass(m, totals[i].mass));
            ok(cd_membrane_set_stiffness(m, other, other));
            ok(cd_membrane_set_bend(m, other));
            ok(cd_membrane_set_drag(m, other));
            ok(cd_membrane_set_stiffness_damping(m, other));
            ok(cd_membrane_set_pressure(m, ring ? other : -other));
            ok(cd_membrane_set_tolerance(m, totals[i].tolerance, totals[i].most));
            ok(cd_membrane_set_edge(m, ring ? CD_EDGE_V_LAST : CD_EDGE_U_FIRST, CD_NODE_MATCHED));
            ok(cd_membrane_attach(m, 3, 2, other, other, NULL, 0));
            for (cd_field field = CD_POSITION; field <= CD_MASK; ++field)
                if (field != CD_STIFFNESS && field != CD_BEND) ok(cd_membrane_enable_field(m, field));
            struct blob blob = save(m);
            ok(cd_membrane_load(fresh, blob.bytes, blob.size));
            assert_int_equal(hash_of(fresh), hash_of(m));
            assert_same_in_all_that_can_be_read(fresh, m);
            free(blob.bytes);
            cd_membrane_destroy(m);
            cd_membrane_destroy(fresh);
        }
    }
}

static void what_is_set_for_cloth_is_kept_at_the_ends_of_every_range(void** state) {
    (void)state;
    static const struct {
        double along_u, along_v, each, shear, compression, along, across, thickness, breaking;
        size_t newton, gradient, colliders;
    } kept[] = {{1e-60, 1e60, 1e-60, 0, 0, 1e60, 0, 1e60, INFINITY, 1, 10000, 0},
                {1e60, 1e-60, 1e60, 1e60, 1e60, 0, 1e60, 0, 1e60, 1000, 1, 4096},
                {1e-60, 1e-60, 0, 5e-324, 5e-324, 5e-324, 0, 5e-324, 1e-60, 1, 1, 1},
                {1e60, 1e60, 0, 0, 5, 0, 0, 0, INFINITY, 2, 14, 2}};
    const double far[3] = {1e60, -1e60, 1e60}, near[3] = {-1e60, 5e-324, -0.0}, wind[3] = {1e30, -1e30, 5e-324};
    for (size_t i = 0; i < COUNT(kept); ++i) {
        cd_membrane* m = cloth(NU, NV, COMPONENTS, CD_FLOAT32);
        cd_membrane* fresh = cloth(NU, NV, COMPONENTS, CD_FLOAT32);
        cd_membrane* copied = cloth(NU, NV, COMPONENTS, CD_FLOAT32);
        cloth_lengths(copied);
        ok(cd_membrane_set_ring(m, i % 2, i / 2));
        ok(cd_membrane_set_rest_length(m, kept[i].along_u, kept[i].along_v));
        ok(cd_membrane_set_shear(m, kept[i].shear));
        ok(cd_membrane_set_compression(m, kept[i].compression));
        ok(cd_membrane_set_breaking_strain(m, kept[i].breaking));
        ok(cd_membrane_set_effort(m, kept[i].newton, kept[i].gradient));
        ok(cd_membrane_set_air(m, kept[i].along, kept[i].across));
        ok(cd_membrane_set_wind(m, wind, 3));
        ok(cd_membrane_set_thickness(m, kept[i].thickness));
        ok(cd_membrane_set_colliders(m, kept[i].colliders));
        if (i % 2) ok(cd_membrane_set_plane(m, 0, far, near, 3, 1e60));
        if (i % 2) ok(cd_membrane_set_capsule(m, kept[i].colliders - 1, far, near, 3, i == 1 ? 1e60 : 1e-60, 0));
        if (i % 2) ok(cd_membrane_set_collider_velocity(m, 0, near, 3));
        for (cd_field field = CD_WIND; field <= CD_BREAKING_STRAIN_V && kept[i].each > 0; ++field) {
            if (field != CD_WIND && field < CD_REST_LENGTH_U) continue;
            if (field >= CD_TENSION_U && field <= CD_STRAIN_V) continue;
            ok(cd_membrane_enable_field(m, field));
            if (field != CD_WIND) ok(cd_membrane_write_f64(m, field, NU - 1, NV - 1, 1, 1, &kept[i].each, 1));
        }
        struct blob blob = save(m);
        ok(cd_membrane_load(fresh, blob.bytes, blob.size));
        ok(cd_membrane_copy_state(copied, m));
        assert_int_equal(hash_of(fresh), hash_of(m));
        assert_same_in_all_that_can_be_read(fresh, m);
        assert_int_equal(hash_of(copied), hash_of(m));
        assert_same_in_all_that_can_be_read(copied, m);
        free(blob.bytes);
        cd_membrane_destroy(m);
        cd_membrane_destroy(fresh);
        cd_membrane_destroy(copied);
    }
}

/* Membranes that are no cloth, or no longer, are saved as they always were. */
static void cloth_takes_no_bytes_where_there_is_none(void** state) {
    (void)state;
    cd_membrane* m = cloth(NU, NV, COMPONENTS, CD_FLOAT64);
    size_t before, during, after, bytes[2];
    const uint64_t hash = hash_of(m);
    ok(cd_membrane_save_size(m, &before));
    ok(cd_membrane_get_memory(m, &bytes[0]));
    ok(cd_membrane_set_rest_length(m, 2, 3));
    ok(cd_membrane_save_size(m, &during));
    assert_true(during > before);
    ok(cd_membrane_set_colliders(m, 3));
    ok(cd_membrane_save_size(m, &after));
    assert_int_equal(after, during + 3 * 13 * sizeof(double));
    ok(cd_membrane_set_colliders(m, 0));
    ok(cd_membrane_set_breaking_strain(m, INFINITY)); /* is none */
    ok(cd_membrane_save_size(m, &after));
    assert_int_equal(after, during);
    ok(cd_membrane_set_breaking_strain(m, 1));
    ok(cd_membrane_save_size(m, &after));
    assert_int_equal(after, during + (1 + 2 * NODES) * sizeof(double)); /* and the stiffnesses */
    for (cd_field field = CD_REST_LENGTH_U; field <= CD_BREAKING_STRAIN_V; ++field)
        ok(cd_membrane_enable_field(m, field));
    ok(cd_membrane_enable_field(m, CD_WIND));
    cloth_meet(m);
    ok(cd_membrane_set_shear(m, 1));
    ok(cd_membrane_set_compression(m, 1));
    ok(cd_membrane_set_effort(m, 1, 1));
    ok(cd_membrane_set_air(m, 1, 1));
    ok(cd_membrane_set_rest_length(m, -0.0, 0)); /* is 0 */
    ok(cd_membrane_disable_field(m, CD_STIFFNESS_U)), ok(cd_membrane_disable_field(m, CD_STIFFNESS_V));
    ok(cd_membrane_set_lambda(m, 0.5));
    ok(cd_membrane_save_size(m, &after));
    ok(cd_membrane_get_memory(m, &bytes[1]));
    assert_int_equal(after, before);
    assert_int_equal(bytes[1], bytes[0]);
    assert_int_equal(hash_of(m), hash);
    cd_membrane_destroy(m);
}

static void save_writes_what_it_says_and_no_more(void** state) {
    (void)state;
    cd_membrane* m = scene_of(EVERYTHING, CD_FLOAT64, CD_METHOD_IMPLICIT);
    struct blob blob = save(m);
    unsigned char* large = malloc(blob.size + 64);
    assert_non_null(large);
    memset(large, 0x5A, blob.size + 64);
    size_t written = 0;
    ok(cd_membrane_save(m, large, blob.size + 64, &written));
    assert_int_equal(written, blob.size);
    assert_memory_equal(large, blob.bytes, blob.size);
    for (size_t i = 0; i < 64; ++i) assert_int_equal(large[blob.size + i], 0x5A);
    memset(large, 0x5A, blob.size);
    const size_t too_small[] = {0, 1, 8, 64, blob.size - 1};
    for (size_t i = 0; i < COUNT(too_small); ++i)
        refuses(m, cd_membrane_save(m, large, too_small[i], out.size), CD_ERROR_RANGE,
                name_and_size("size", too_small[i]));
    for (size_t i = 0; i < blob.size; ++i) assert_int_equal(large[i], 0x5A);
    free(large);
    free(blob.bytes);
    cd_membrane_destroy(m);
}

static void no_damaged_byte_goes_unseen(void** state) {
    (void)state;
    static const unsigned char flips[] = {0x01, 0x80, 0xFF};
    for (int i = 0; i < 4; ++i) {
        const cd_precision precision = i % 2 ? CD_FLOAT64 : CD_FLOAT32;
        cd_membrane* source = scene_of(i < 2 ? EVERYTHING : LENGTHS, precision, CD_METHOD_IMPLICIT);
        cd_membrane* m = scene_of(3, precision, CD_METHOD_IMPLICIT);
        const uint64_t before = hash_of(m);
        struct blob blob = save(source);
        assert_true(blob.size > 500);
        int said_version = 0, said_kind = 0;
        for (size_t at = 0; at < blob.size; ++at) {
            for (size_t j = 0; j < COUNT(flips); ++j) {
                blob.bytes[at] ^= flips[j];
                if (cd_membrane_load(m, blob.bytes, blob.size) != CD_ERROR_FORMAT)
                    fail_msg("byte %zu of %zu, flipped by 0x%02x: %s", at, blob.size, flips[j], cd_error_message());
                said_version |= strstr(cd_error_message(), "version") != NULL;
                said_kind |= strstr(cd_error_message(), "kind") != NULL;
                blob.bytes[at] ^= flips[j];
            }
        }
        assert_true(said_version && said_kind); /* refused for what they are, not as damaged */
        assert_int_equal(hash_of(m), before);
        ok(cd_membrane_load(m, blob.bytes, blob.size));
        assert_int_equal(hash_of(m), hash_of(source));
        free(blob.bytes);
        cd_membrane_destroy(source);
        cd_membrane_destroy(m);
    }
}

static void no_other_length_is_loaded_of(size_t scene) {
    cd_membrane* source = scene_of(scene, CD_FLOAT32, CD_METHOD_IMPLICIT);
    cd_membrane* m = scene_of(0, CD_FLOAT32, CD_METHOD_IMPLICIT);
    const uint64_t before = hash_of(m);
    struct blob blob = save(source);
    for (size_t size = 0; size < blob.size; ++size) {
        unsigned char* cut = malloc(size ? size : 1); /* its own block, so that a read past it is seen */
        assert_non_null(cut);
        memcpy(cut, blob.bytes, size);
        if (cd_membrane_load(m, cut, size) != CD_ERROR_FORMAT)
            fail_msg("%zu bytes of %zu: %s", size, blob.size, cd_error_message());
        free(cut);
    }
    assert_int_equal(hash_of(m), before);
    unsigned char* longer = calloc(blob.size + 16, 1);
    assert_non_null(longer);
    memcpy(longer, blob.bytes, blob.size);
    refuses(m, cd_membrane_load(m, longer, blob.size + 1), CD_ERROR_FORMAT, "");
    refuses(m, cd_membrane_load(m, longer, blob.size + 16), CD_ERROR_FORMAT, "");
    free(longer);
    free(blob.bytes);
    cd_membrane_destroy(source);
    cd_membrane_destroy(m);
}

static void no_other_length_is_loaded(void** state) {
    (void)state;
    no_other_length_is_loaded_of(EVERYTHING);
    no_other_length_is_loaded_of(LENGTHS);
}

static void a_chain_is_not_loaded_as_a_membrane_nor_the_other_way_round(void** state) {
    (void)state;
    cd_membrane* m = scene_of(EVERYTHING, CD_FLOAT64, CD_METHOD_IMPLICIT);
    cd_chain* chain = scene_chain(NU, NV, COMPONENTS, CD_FLOAT64);
    struct blob blob = save(m);
    refuses(chain, cd_chain_load(chain, blob.bytes, blob.size), CD_ERROR_FORMAT, "~|kind|2|chain|1");
    size_t size;
    ok(cd_chain_save_size(chain, &size));
    unsigned char* bytes = malloc(size);
    assert_non_null(bytes);
    ok(cd_chain_save(chain, bytes, size, &size));
    refuses(m, cd_membrane_load(m, bytes, size), CD_ERROR_FORMAT, "~|kind|1|membrane|2");
    free(bytes);
    free(blob.bytes);
    cd_chain_destroy(chain);
    cd_membrane_destroy(m);
}

static void another_shape_or_precision_is_a_mismatch(void** state) {
    (void)state;
    static const struct {
        size_t nu, nv, components;
        cd_precision precision;
    } other[] = {{NU + 1, NV, COMPONENTS, CD_FLOAT64}, {NU, NV + 1, COMPONENTS, CD_FLOAT64},
                 {NU, NV, COMPONENTS + 1, CD_FLOAT64}, {NU, NV, COMPONENTS, CD_FLOAT32},
                 {NV, NU, COMPONENTS, CD_FLOAT64}};
    cd_membrane* source = scene_of(EVERYTHING, CD_FLOAT64, CD_METHOD_IMPLICIT);
    struct blob blob = save(source);
    for (size_t i = 0; i < COUNT(other); ++i) {
        cd_membrane* m = cloth(other[i].nu, other[i].nv, other[i].components, other[i].precision);
        cloth_torn(m);
        refuses(m, cd_membrane_load(m, blob.bytes, blob.size), CD_ERROR_MISMATCH, "");
        refuses(m, cd_membrane_copy_state(m, source), CD_ERROR_MISMATCH, "~source|membrane");
        cd_membrane_destroy(m);
    }
    free(blob.bytes);
    cd_membrane_destroy(source);
}

static void reset_goes_back_to_the_start(size_t scene) {
    cd_membrane* m = scene_of(scene, CD_FLOAT64, CD_METHOD_IMPLICIT);
    cd_membrane* same = scene_of(scene, CD_FLOAT64, CD_METHOD_IMPLICIT);
    double x[ALL], y[ALL], time;
    ok(cd_membrane_reset(m));
    ok(cd_membrane_get_time(m, &time));
    assert_true(time == 0);
    for (cd_field field = CD_POSITION; field <= CD_VELOCITY; ++field) {
        cloth_read(m, field, x);
        for (size_t i = 0; i < ALL; ++i) assert_true(x[i] == 0);
        cloth_write(same, field, x); /* the same zeros by hand */
    }
    ok(cd_membrane_step(m, 0.001, 40));
    ok(cd_membrane_step(same, 0.001, 40));
    cloth_read(m, CD_POSITION, x);
    cloth_read(same, CD_POSITION, y);
    assert_same_bits(x, y, ALL);
    cd_membrane_destroy(m);
    cd_membrane_destroy(same);
}

static void reset_goes_back_to_the_start_and_keeps_the_rest(void** state) {
    (void)state;
    reset_goes_back_to_the_start(EVERYTHING);
    reset_goes_back_to_the_start(LENGTHS); /* colliders too go on from where they are */
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_loaded_membrane_goes_on_bit_for_bit),
        cmocka_unit_test(features_follow_the_bytes_and_the_source),
        cmocka_unit_test(a_rollback_in_the_same_membrane_repeats_itself),
        cmocka_unit_test(the_parameters_of_the_source_act_at_once),
        cmocka_unit_test(what_was_saved_can_be_loaded_at_the_ends_of_every_range),
        cmocka_unit_test(what_is_set_for_cloth_is_kept_at_the_ends_of_every_range),
        cmocka_unit_test(cloth_takes_no_bytes_where_there_is_none),
        cmocka_unit_test(save_writes_what_it_says_and_no_more),
        cmocka_unit_test(no_damaged_byte_goes_unseen),
        cmocka_unit_test(no_other_length_is_loaded),
        cmocka_unit_test(a_chain_is_not_loaded_as_a_membrane_nor_the_other_way_round),
        cmocka_unit_test(another_shape_or_precision_is_a_mismatch),
        cmocka_unit_test(reset_goes_back_to_the_start_and_keeps_the_rest),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
