/* Saving, loading and copying the state of objects of every kind: exact, all or nothing, and deaf to damaged bytes. */
#include <stdlib.h>
#include <string.h>

#include "kept.h"
#include "scene.h"

#define FOR_KINDS(kept) for (const struct kept_kind* kept = kept_kinds; kept < kept_kinds + KINDS; ++kept)

/* Two objects take the state of a third one over, by its bytes and by copying: they are the same in all that can be
 * read, need the same memory, are saved as the same bytes, and go on bit for bit. Destroys all three. */
static void become_one(const struct kept_kind* kept, size_t scene, any* source, any* loaded, any* copied,
                       size_t steps) {
    const struct kind* const kind = kept->kind;
    const double dt = kept_dt(kept, scene);
    any* const others[2] = {loaded, copied};
    struct blob first = kind_save(kind, source);
    for (int by_copy = 0; by_copy < 2; ++by_copy) {
        kind_take(kind, others[by_copy], source, by_copy);
        kind_assert_same(kind, others[by_copy], source);
        assert_int_equal(kind_memory(kind, others[by_copy]), kind_memory(kind, source));
        struct blob again = kind_save(kind, others[by_copy]);
        assert_int_equal(first.size, again.size);
        assert_memory_equal(first.bytes, again.bytes, first.size);
        free(again.bytes);
    }
    ok(kind->step(source, dt, steps));
    for (int by_copy = 0; by_copy < 2; ++by_copy) {
        ok(kind->step(others[by_copy], dt, steps));
        kind_assert_same(kind, others[by_copy], source);
        kind->destroy(others[by_copy]);
    }
    kind->destroy(source), free(first.bytes);
}

static void a_loaded_or_copied_object_goes_on_bit_for_bit(void** state) {
    (void)state;
    FOR_KINDS(kept)
    for (size_t scene = 0; scene < kept->scenes; ++scene)
        for (cd_precision precision = CD_FLOAT32; precision <= CD_FLOAT64; ++precision)
            for (size_t method = 0; method < kept_methods(kept, scene); ++method)
                become_one(kept, scene, kept_scene(kept, scene, precision, (cd_method)method),
                           kept_new(kept, NULL, precision), kept_new(kept, NULL, precision),
                           kept->kind == &kinds[CHAIN] ? 100 : 50);
}

static void features_follow_the_bytes_and_the_source(void** state) {
    (void)state;
    FOR_KINDS(kept)
    for (size_t from = 0; from < kept->scenes; ++from)
        for (size_t to = is_brief() ? from % 4 : 0; to < kept->scenes; to += is_brief() ? 4 : 1)
            become_one(kept, from, kept_scene(kept, from, CD_FLOAT64, CD_METHOD_IMPLICIT),
                       kept_scene(kept, to, CD_FLOAT64, CD_METHOD_STIFF_SECOND),
                       kept_scene(kept, to, CD_FLOAT64, CD_METHOD_SYMPLECTIC_EULER), 20);
}

static void a_rollback_in_the_same_object_repeats_itself(void** state) {
    (void)state;
    FOR_KINDS(kept)
    for (size_t scene = 0; scene < kept->scenes; ++scene)
        for (int by_copy = 0; by_copy < 2; ++by_copy) {
            const struct kind* const kind = kept->kind;
            const double dt = kept_dt(kept, scene);
            any* object = kept_scene(kept, scene, CD_FLOAT32, CD_METHOD_IMPLICIT);
            any *before = kept_new(kept, NULL, CD_FLOAT32), *after = kept_new(kept, NULL, CD_FLOAT32);
            kind_take(kind, before, object, by_copy);
            ok(kind->step(object, dt, 30));
            assert_int_not_equal(kind_hash(kind, object), kind_hash(kind, before));
            kind_take(kind, after, object, by_copy);
            kind_take(kind, object, before, by_copy);
            kind_assert_same(kind, object, before);
            ok(kind->step(object, dt, 30));
            kind_assert_same(kind, object, after);
            kind_take(kind, object, object, by_copy);
            kind_assert_same(kind, object, after);
            kind->destroy(object), kind->destroy(before), kind->destroy(after);
        }
}

/* Other parameters, on which what steps have ready depends. */
static void stiffen(const struct kept_kind* kept, any* object, bool has_lengths) {
    switch (kept->kind->number) {
    case CD_KIND_CHAIN:
        ok(cd_chain_set_stiffness(object, 1e4));
        if (has_lengths) ok(cd_chain_set_rest_length(object, 0.75));
        break;
    case CD_KIND_MEMBRANE:
        ok(cd_membrane_set_stiffness(object, 1e4, 1e3));
        if (has_lengths) ok(cd_membrane_set_rest_length(object, 0.75, 0.5));
        break;
    default: ok(cd_water_set_gravity(object, 3)); ok(cd_water_set_density(object, 500));
    }
}

static void the_parameters_of_the_source_act_at_once(void** state) {
    (void)state;
    FOR_KINDS(kept)
    for (size_t scene = 0; scene < kept->scenes; ++scene) {
        any* objects[3];
        for (int k = 0; k < 3; ++k) objects[k] = kept_scene(kept, scene, CD_FLOAT64, CD_METHOD_IMPLICIT);
        stiffen(kept, objects[0], kept_methods(kept, scene) == 1);
        ok(kept->kind->step(objects[0], kept_dt(kept, scene), 1)); /* factored for the dt to come, as are the others */
        become_one(kept, scene, objects[0], objects[1], objects[2], 5);
    }
}

/* The two fullest scenes in both precisions. */
#define FOR_FULLEST(kept, k) \
    FOR_KINDS(kept)          \
    for (int k = 0; k < 4; ++k)

static any* fullest(const struct kept_kind* kept, int k) {
    return kept_scene(kept, kept->fullest[k / 2], k % 2 ? CD_FLOAT64 : CD_FLOAT32, CD_METHOD_IMPLICIT);
}

static any* other(const struct kept_kind* kept, int k) {
    return kept_scene(kept, kept->others[k / 2], k % 2 ? CD_FLOAT64 : CD_FLOAT32, CD_METHOD_IMPLICIT);
}

static void save_writes_what_it_says_and_no_more(void** state) {
    (void)state;
    FOR_FULLEST(kept, k) {
        const struct kind* const kind = kept->kind;
        any* object = fullest(kept, k);
        struct blob blob = kind_save(kind, object);
        unsigned char* large = malloc(blob.size + 64);
        assert_non_null(large);
        memset(large, 0x5A, blob.size + 64);
        size_t written = 0;
        ok(kind->save(object, large, blob.size + 64, &written));
        assert_int_equal(written, blob.size);
        assert_memory_equal(large, blob.bytes, blob.size);
        for (size_t i = 0; i < 64; ++i) assert_int_equal(large[blob.size + i], 0x5A);
        memset(large, 0x5A, blob.size);
        const size_t too_few[] = {0, 1, 8, 64, blob.size - 1};
        for (size_t i = 0; i < COUNT(too_few); ++i)
            kind_refuses(kind, object, save, (object, large, too_few[i], out.size), CD_ERROR_RANGE,
                         name_and_size("size", too_few[i]));
        for (size_t i = 0; i < blob.size; ++i) assert_int_equal(large[i], 0x5A);
        free(large), free(blob.bytes);
        kind->destroy(object);
    }
}

static void no_damaged_byte_goes_unseen(void** state) {
    (void)state;
    static const unsigned char flips[] = {0x01, 0x80, 0xFF, 0x10};
    FOR_FULLEST(kept, k) {
        const struct kind* const kind = kept->kind;
        any *source = fullest(kept, k), *object = other(kept, k);
        const uint64_t before = kind_hash(kind, object);
        struct blob blob = kind_save(kind, source);
        assert_true(blob.size > 500);
        bool said_version = false, said_kind = false;
        for (size_t i = 0; i < blob.size; i += is_brief() && i >= 64 ? 11 : 1) {
            for (size_t j = 0; j < COUNT(flips); ++j) {
                blob.bytes[i] ^= flips[j];
                if (kind->load(object, blob.bytes, blob.size) != CD_ERROR_FORMAT)
                    fail_msg("%s: byte %zu of %zu, flipped by 0x%02x: %s", kind->name, i, blob.size, flips[j],
                             cd_error_message());
                said_version |= strstr(cd_error_message(), "version") != NULL;
                said_kind |= strstr(cd_error_message(), "kind") != NULL;
                blob.bytes[i] ^= flips[j];
            }
            if (kind_hash(kind, object) != before)
                fail_msg("%s: damage to byte %zu of %zu is refused, and yet changes the object", kind->name, i,
                         blob.size);
        }
        assert_true(said_version && said_kind); /* refused for what they are, not as damaged */
        for (size_t i = 0; i + 8 < blob.size; i += is_brief() ? 33 : 3) { /* two bytes exchanged */
            const unsigned char a = blob.bytes[i], b = blob.bytes[i + 8];
            if (a == b) continue;
            blob.bytes[i] = b, blob.bytes[i + 8] = a;
            assert_int_equal(kind->load(object, blob.bytes, blob.size), CD_ERROR_FORMAT);
            blob.bytes[i] = a, blob.bytes[i + 8] = b;
        }
        assert_int_equal(kind_hash(kind, object), before);
        ok(kind->load(object, blob.bytes, blob.size));
        kind_assert_same(kind, object, source);
        free(blob.bytes);
        kind->destroy(source), kind->destroy(object);
    }
}

static void no_other_length_is_loaded(void** state) {
    (void)state;
    FOR_FULLEST(kept, k) {
        const struct kind* const kind = kept->kind;
        any *source = fullest(kept, k), *object = other(kept, k);
        const uint64_t before = kind_hash(kind, object);
        struct blob blob = kind_save(kind, source);
        for (size_t size = 0; size < blob.size; size += is_brief() ? 11 : 1) {
            unsigned char* cut = malloc(size ? size : 1); /* its own block, so that a read past it is seen */
            assert_non_null(cut);
            memcpy(cut, blob.bytes, size);
            if (kind->load(object, cut, size) != CD_ERROR_FORMAT || kind_hash(kind, object) != before)
                fail_msg("%s: %zu bytes of %zu: %s", kind->name, size, blob.size, cd_error_message());
            free(cut);
        }
        unsigned char* longer = calloc(blob.size + 16, 1);
        assert_non_null(longer);
        memcpy(longer, blob.bytes, blob.size);
        kind_refuses(kind, object, load, (object, longer, blob.size + 1), CD_ERROR_FORMAT, "followed by others");
        kind_refuses(kind, object, load, (object, longer, blob.size + 16), CD_ERROR_FORMAT, "followed by others");
        free(longer), free(blob.bytes);
        kind->destroy(source), kind->destroy(object);
    }
}

static void foreign_bytes_are_refused(void** state) {
    (void)state;
    FOR_FULLEST(kept, k) {
        any* object = fullest(kept, k);
        struct blob blob = kind_save(kept->kind, object);
        uint64_t seed = 5;
        for (int what = 0; what < 20; ++what) {
            const unsigned char same = what == 0 ? 0 : 0xFF;
            for (size_t i = 0; i < blob.size; ++i)
                blob.bytes[i] = what < 2 ? same : (unsigned char)(int64_t)(scene_noise(&seed) * 0x1p40);
            kind_refuses(kept->kind, object, load, (object, blob.bytes, blob.size), CD_ERROR_FORMAT, "");
        }
        free(blob.bytes);
        kept->kind->destroy(object);
    }
}

static void bytes_of_another_kind_are_refused(void** state) {
    (void)state;
    FOR_FULLEST(from, k) {
        any* source = fullest(from, k);
        struct blob blob = kind_save(from->kind, source);
        FOR_KINDS(to) {
            if (to == from) continue;
            any* object = kept_new(to, from->shape, k % 2 ? CD_FLOAT64 : CD_FLOAT32);
            kind_refuses(to->kind, object, load, (object, blob.bytes, blob.size), CD_ERROR_FORMAT,
                         text_of("bytes|kind|%d|%s|%s|%d", (int)from->kind->number, from->kind->name, to->kind->name,
                                 (int)to->kind->number));
            to->kind->destroy(object);
        }
        free(blob.bytes);
        from->kind->destroy(source);
    }
}

static void another_shape_or_precision_is_a_mismatch(void** state) {
    (void)state;
    enum { SHAPES = 8, WITH_SCENES = 4 };
    FOR_KINDS(kept) {
        const struct kind* const kind = kept->kind;
        const size_t a = kept->shape[0], b = kept->shape[1], c = kept->shape[2];
        const size_t shapes[SHAPES][3] = {{a + 1, b, c}, {a, b + 1, c}, {a, b, c}, {a, b, c + 1},
                                          {1, b, c},     {b, a, c},     {1, 1, c}, {c, b, a > 4 ? 1 : a}};
        any* source = kept_scene(kept, kept->fullest[0], CD_FLOAT64, CD_METHOD_IMPLICIT);
        struct blob blob = kind_save(kind, source);
        for (size_t i = 0; i < SHAPES; ++i) {
            const size_t* const s = shapes[i];
            if (i == 3 && kind == &kinds[WATER]) continue; /* which has no components */
            any* object = kept_new(kept, s, i == 2 || i == 4 ? CD_FLOAT32 : CD_FLOAT64);
            if (i < WITH_SCENES) kept->build(object, 5);
            const char* const told = text_of("|%s|%zu|%zu|%zu|%zu", kind->name, a, b, s[0], s[1]);
            kind_refuses(kind, object, load, (object, blob.bytes, blob.size), CD_ERROR_MISMATCH,
                         text_of("bytes%s", told));
            kind_refuses(kind, object, copy_state, (object, source), CD_ERROR_MISMATCH, text_of("source%s", told));
            kind->destroy(object);
        }
        free(blob.bytes);
        kind->destroy(source);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_loaded_or_copied_object_goes_on_bit_for_bit),
        cmocka_unit_test(features_follow_the_bytes_and_the_source),
        cmocka_unit_test(a_rollback_in_the_same_object_repeats_itself),
        cmocka_unit_test(the_parameters_of_the_source_act_at_once),
        cmocka_unit_test(save_writes_what_it_says_and_no_more),
        cmocka_unit_test(no_damaged_byte_goes_unseen),
        cmocka_unit_test(no_other_length_is_loaded),
        cmocka_unit_test(foreign_bytes_are_refused),
        cmocka_unit_test(bytes_of_another_kind_are_refused),
        cmocka_unit_test(another_shape_or_precision_is_a_mismatch),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
