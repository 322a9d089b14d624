/* What saved bytes tell of themselves. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "check.h"

#include <contdyn/contdyn.h>

enum { HEADER = 24, AT_KIND = 12, AT_SUM = 16, AT_PRECISION = HEADER + 24 };

struct shape {
    cd_kind kind;
    size_t first, second, components;
    cd_precision precision;
};
struct saved {
    unsigned char* bytes;
    size_t size;
};

static struct saved save_one(const struct shape* of) {
    struct saved saved = {NULL, 0};
    size_t written = 0;
    cd_chain* chain = NULL;
    cd_membrane* membrane = NULL;
    cd_water* water = NULL;
    switch (of->kind) {
    case CD_KIND_CHAIN:
        ok(cd_chain_create(of->first, of->second, of->components, of->precision, NULL, &chain));
        ok(cd_chain_save_size(chain, &saved.size));
        assert_non_null(saved.bytes = malloc(saved.size));
        ok(cd_chain_save(chain, saved.bytes, saved.size, &written));
        break;
    case CD_KIND_MEMBRANE:
        ok(cd_membrane_create(of->first, of->second, of->components, of->precision, NULL, &membrane));
        ok(cd_membrane_save_size(membrane, &saved.size));
        assert_non_null(saved.bytes = malloc(saved.size));
        ok(cd_membrane_save(membrane, saved.bytes, saved.size, &written));
        break;
    default:
        ok(cd_water_create(of->first, of->second, 0.5, 2, of->precision, NULL, &water));
        ok(cd_water_save_size(water, &saved.size));
        assert_non_null(saved.bytes = malloc(saved.size));
        ok(cd_water_save(water, saved.bytes, saved.size, &written));
    }
    cd_chain_destroy(chain), cd_membrane_destroy(membrane), cd_water_destroy(water);
    assert_int_equal(written, saved.size);
    return saved;
}

/* Makes an object of what the bytes tell, and loads them. */
static cd_status load_one(const struct shape* of, const struct saved* saved) {
    cd_chain* chain = NULL;
    cd_membrane* membrane = NULL;
    cd_water* water = NULL;
    cd_status status = CD_OK;
    if (of->kind == CD_KIND_CHAIN) {
        ok(cd_chain_create(of->first, of->second, of->components, of->precision, NULL, &chain));
        status = cd_chain_load(chain, saved->bytes, saved->size);
    } else if (of->kind == CD_KIND_MEMBRANE) {
        ok(cd_membrane_create(of->first, of->second, of->components, of->precision, NULL, &membrane));
        status = cd_membrane_load(membrane, saved->bytes, saved->size);
    } else {
        ok(cd_water_create(of->first, of->second, 1, 1, of->precision, NULL, &water));
        status = cd_water_load(water, saved->bytes, saved->size);
    }
    cd_chain_destroy(chain), cd_membrane_destroy(membrane), cd_water_destroy(water);
    return status;
}

static cd_status tell(const struct saved* saved, struct shape* out) {
    return cd_saved_shape(saved->bytes, saved->size, &out->kind, &out->first, &out->second, &out->components,
                          &out->precision);
}

static const struct shape shapes[] = {
    {CD_KIND_CHAIN, 3, 8, 2, CD_FLOAT32},    {CD_KIND_CHAIN, 1, 0, 4, CD_FLOAT64},
    {CD_KIND_MEMBRANE, 6, 4, 3, CD_FLOAT64}, {CD_KIND_MEMBRANE, 0, 5, 1, CD_FLOAT32},
    {CD_KIND_WATER, 7, 2, 1, CD_FLOAT32},    {CD_KIND_WATER, 1, 9, 1, CD_FLOAT64},
};

static void objects_can_be_made_of_what_they_tell(void** state) {
    (void)state;
    for (size_t i = 0; i < COUNT(shapes); ++i) {
        const struct shape* of = &shapes[i];
        struct saved saved = save_one(of);
        struct shape told = {0, 0, 0, 0, -1};
        ok(tell(&saved, &told));
        assert_int_equal(told.kind, of->kind);
        assert_int_equal(told.first, of->first);
        assert_int_equal(told.second, of->second);
        assert_int_equal(told.components, of->components);
        assert_int_equal(told.precision, of->precision);
        ok(load_one(&told, &saved));
        ok(cd_saved_shape(saved.bytes, saved.size, NULL, NULL, NULL, NULL, NULL));
        free(saved.bytes);
    }
}

static void refused_and_told_nothing(const struct saved* saved) {
    struct shape told = {77, 78, 79, 80, 81};
    assert_int_equal(tell(saved, &told), CD_ERROR_FORMAT);
    assert_true(told.kind == 77 && told.first == 78 && told.second == 79 && told.components == 80 &&
                told.precision == 81);
}

static void damaged_bytes_are_refused(void** state) {
    (void)state;
    for (size_t i = 0; i < COUNT(shapes); ++i) {
        struct saved saved = save_one(&shapes[i]);
        for (size_t at = 0; at < saved.size; ++at) {
            if (at >= AT_KIND && at < AT_SUM) continue; /* the kind has no checksum */
            saved.bytes[at] ^= 0x10;
            refused_and_told_nothing(&saved);
            saved.bytes[at] ^= 0x10;
        }
        const size_t size = saved.size;
        for (saved.size = 0; saved.size < size; ++saved.size) refused_and_told_nothing(&saved);
        free(saved.bytes);
    }
}

/* As the library makes it. */
static void put_checksum_right(struct saved* saved) {
    uint64_t sum = (0xcbf29ce484222325 ^ (saved->size - HEADER)) * 0x9e3779b97f4a7c15;
    sum ^= sum >> 29;
    for (size_t i = HEADER; i < saved->size; i += 8) {
        uint64_t word = 0;
        for (size_t k = 0; k < 8 && i + k < saved->size; ++k) word |= (uint64_t)saved->bytes[i + k] << 8 * k;
        sum = (sum ^ word) * 0x9e3779b97f4a7c15;
        sum ^= sum >> 29;
    }
    for (size_t k = 0; k < 8; ++k) saved->bytes[AT_SUM + k] = (unsigned char)(sum >> 8 * k);
}

static void crafted_bytes_tell_nothing_that_there_is_not(void** state) {
    (void)state;
    struct saved saved = save_one(&shapes[0]);
    struct shape told;
    put_checksum_right(&saved);
    ok(tell(&saved, &told));
    for (unsigned char kind = 0; kind < 9; kind += 4) { /* 0, 4 and 8 are none */
        saved.bytes[AT_KIND] = kind;
        refused_and_told_nothing(&saved);
    }
    saved.bytes[AT_KIND] = CD_KIND_CHAIN;
    saved.bytes[AT_PRECISION] = 2;
    put_checksum_right(&saved);
    refused_and_told_nothing(&saved);
    saved.bytes[AT_PRECISION] = CD_FLOAT32;
    saved.size = HEADER + 20; /* no whole shape, and its checksum */
    put_checksum_right(&saved);
    refused_and_told_nothing(&saved);
    free(saved.bytes);
}

static void null_bytes_are_refused(void** state) {
    (void)state;
    const struct saved none = {NULL, 100};
    struct shape told;
    assert_int_equal(tell(&none, &told), CD_ERROR_NULL);
    assert_non_null(strstr(cd_error_message(), "bytes"));
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(objects_can_be_made_of_what_they_tell),
        cmocka_unit_test(damaged_bytes_are_refused),
        cmocka_unit_test(crafted_bytes_tell_nothing_that_there_is_not),
        cmocka_unit_test(null_bytes_are_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
