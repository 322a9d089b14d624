/* What version 0.2.0 has saved is loaded by every later version: saved_by_0.2 holds objects with all their fields and
 * parameters, and what they then had for positions and velocities. It is written anew, by CD_WRITE_SAVED=1, only when
 * the promise begins anew. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <contdyn/contdyn.h>

#include "check.h"
#include "cloth.h"
#include "pool.h"
#include "scene.h"

static const char kPath[] = CD_INCLUDE_DIR "/../tests/api/saved_by_0.2";

struct object {
    cd_chain* chain;
    cd_membrane* membrane;
    cd_water* water;
};

static void destroy(struct object* o) {
    cd_chain_destroy(o->chain), cd_membrane_destroy(o->membrane), cd_water_destroy(o->water);
}

enum { KINDS = 5 };

static struct object object_of(int kind, cd_precision precision) {
    struct object o = {NULL, NULL, NULL};
    switch (kind) {
    case 0: scene_everything(o.chain = scene_chain(2, 6, 3, precision)); break;
    case 1: scene_lengths(o.chain = scene_chain(2, 6, 3, precision)); break;
    case 2: cloth_everything(o.membrane = cloth(4, 3, 3, precision)); break;
    case 3: cloth_sail(o.membrane = cloth(4, 4, 3, precision)), cloth_meet(o.membrane); break;
    default:
        o.water = pool_of(POOL_EVERYTHING, 6, 5, precision, 2);
        ok(cd_water_set_hulls(o.water, 1, 2, 1));
        ok(cd_water_set_hull(o.water, 0, 2, 1, 0.5, NULL, 0));
    }
    return o;
}

static uint64_t add_numbers(uint64_t sum, const double* numbers, size_t count) {
    for (size_t i = 0; i < count; ++i) {
        uint64_t bits;
        memcpy(&bits, &numbers[i], sizeof bits);
        sum = (sum ^ bits) * 0x9e3779b97f4a7c15;
        sum ^= sum >> 29;
    }
    return sum;
}

/* A sum over positions and velocities, of water depths and velocities. */
static uint64_t state_of(const struct object* o) {
    double x[128];
    uint64_t sum = 1;
    size_t a, b, components;
    if (o->water) {
        ok(cd_water_get_shape(o->water, &a, &b, NULL, NULL, NULL));
        ok(cd_water_read_f64(o->water, CD_DEPTH, 0, 0, a, b, x, a * b));
        sum = add_numbers(sum, x, a * b);
        ok(cd_water_read_f64(o->water, CD_VELOCITY_X, 0, 0, a + 1, b, x, (a + 1) * b));
        return add_numbers(sum, x, (a + 1) * b);
    }
    for (cd_field field = CD_POSITION; field <= CD_VELOCITY; ++field) {
        size_t count;
        if (o->chain) {
            ok(cd_chain_get_shape(o->chain, &a, &b, &components, NULL));
            ok(cd_chain_read_f64(o->chain, field, 0, a, 0, b + 1, x, count = a * (b + 1) * components));
        } else {
            ok(cd_membrane_get_shape(o->membrane, &a, &b, &components, NULL));
            count = (a + 1) * (b + 1) * components;
            ok(cd_membrane_read_f64(o->membrane, field, 0, 0, a + 1, b + 1, x, count));
        }
        sum = add_numbers(sum, x, count);
    }
    return sum;
}

static void write_number(FILE* file, uint64_t number) {
    for (int k = 0; k < 8; ++k) assert_true(fputc((int)(number >> 8 * k & 255), file) != EOF);
}
static uint64_t read_number(FILE* file) {
    uint64_t number = 0;
    for (int k = 0; k < 8; ++k) {
        const int byte = fgetc(file);
        assert_true(byte != EOF);
        number |= (uint64_t)byte << 8 * k;
    }
    return number;
}

static void write_all(void) {
    static unsigned char bytes[1 << 16];
    FILE* file = fopen(kPath, "wb");
    assert_non_null(file);
    for (int kind = 0; kind < KINDS; ++kind)
        for (cd_precision precision = CD_FLOAT32; precision <= CD_FLOAT64; ++precision) {
            struct object o = object_of(kind, precision);
            size_t size = 0;
            if (o.chain) ok(cd_chain_save(o.chain, bytes, sizeof bytes, &size));
            else if (o.membrane) ok(cd_membrane_save(o.membrane, bytes, sizeof bytes, &size));
            else ok(cd_water_save(o.water, bytes, sizeof bytes, &size));
            write_number(file, size), write_number(file, state_of(&o));
            assert_int_equal(fwrite(bytes, 1, size, file), size);
            destroy(&o);
        }
    assert_int_equal(fclose(file), 0);
}

static void what_an_earlier_version_has_saved_is_loaded(void** state) {
    (void)state;
    static unsigned char bytes[1 << 16];
    if (getenv("CD_WRITE_SAVED")) write_all();
    FILE* file = fopen(kPath, "rb");
    assert_non_null(file);
    for (int i = 0; i < 2 * KINDS; ++i) {
        const uint64_t size = read_number(file), was = read_number(file);
        assert_true(size <= sizeof bytes);
        assert_int_equal(fread(bytes, 1, (size_t)size, file), size);
        struct object o = {NULL, NULL, NULL};
        cd_kind kind;
        size_t first, second, components;
        cd_precision precision;
        ok(cd_saved_shape(bytes, (size_t)size, &kind, &first, &second, &components, &precision));
        if (kind == CD_KIND_CHAIN) {
            ok(cd_chain_create(first, second, components, precision, NULL, &o.chain));
            ok(cd_chain_load(o.chain, bytes, (size_t)size));
        } else if (kind == CD_KIND_MEMBRANE) {
            ok(cd_membrane_create(first, second, components, precision, NULL, &o.membrane));
            ok(cd_membrane_load(o.membrane, bytes, (size_t)size));
        } else {
            ok(cd_water_create(first, second, 1, 1, precision, NULL, &o.water));
            ok(cd_water_load(o.water, bytes, (size_t)size));
        }
        assert_true(state_of(&o) == was);
        destroy(&o);
    }
    assert_int_equal(fgetc(file), EOF);
    fclose(file);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(what_an_earlier_version_has_saved_is_loaded)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
