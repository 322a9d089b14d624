/* What the drawing functions of membrane.h refuse, and that they leave the membrane as it is. Pointers:
 * tests/bindings/check_pointers.py. */
#include <stdlib.h>
#include <string.h>

#include "check.h"
#include "cloth.h"
#include "heap.h"
#include "refusals.h"

enum { NU = 7, NV = 5, NODES = (NU + 1) * (NV + 1), STRIDE = 24, INDICES = 6 * (NU * NV - 4) + 3 * 4 };

static cd_membrane* membrane;
static struct heap heap;

static unsigned char buffer[NODES * STRIDE + 4 * INDICES], untouched[sizeof buffer];

static int set_up(void** state) {
    (void)state;
    const cd_allocator allocator = heap_allocator(&heap);
    membrane = cloth_from(&allocator, NU, NV, 3, CD_FLOAT64);
    cloth_everything(membrane); /* one node inside is absent */
    memset(buffer, 0x5A, sizeof buffer);
    memset(untouched, 0x5A, sizeof untouched);
    return 0;
}

static int tear_down(void** state) {
    (void)state;
    cd_membrane_destroy(membrane);
    heap_free(&heap);
    return 0;
}

static void no_buffer_is_too_small(void** state) {
    (void)state;
    cd_membrane* const m = membrane;
    size_t count;
    ok(cd_membrane_get_index_count(m, &count));
    assert_int_equal(count, INDICES);
    const size_t sizes[] = {0, 1, NODES * STRIDE - 1};
    for (size_t i = 0; i < COUNT(sizes); ++i)
        refuses(m, cd_membrane_write_vertices(m, buffer, sizes[i], STRIDE, 0, 12), CD_ERROR_RANGE,
                name_and_size("size", sizes[i]));
    /* nodes * stride comes round to less than the size */
    const size_t strides[] = {SIZE_MAX, SIZE_MAX - 11, SIZE_MAX / 2 + 1, SIZE_MAX / NODES + 1, SIZE_MAX / NODES + 2};
    for (size_t i = 0; i < COUNT(strides); ++i)
        refuses(m, cd_membrane_write_vertices(m, buffer, sizeof buffer, strides[i], 0, 12), CD_ERROR_RANGE,
                text_of("size|%zu|%zu", sizeof buffer, strides[i]));
    for (size_t width = 2; width <= 4; width += 2)
        for (size_t less = 1; less <= width * INDICES; less += 7)
            refuses(m, cd_membrane_write_indices(m, buffer, width * INDICES - less, width), CD_ERROR_RANGE,
                    text_of("size|%zu|%zu", width * INDICES - less, width * INDICES));
    assert_memory_equal(buffer, untouched, sizeof buffer);
}

static void no_vertex_is_torn(void** state) {
    (void)state;
    cd_membrane* const m = membrane;
    static const struct {
        size_t stride, position, normal;
        const char* argument;
    } bad[] = {
        {0, 0, SIZE_MAX, "stride|0|12"},
        {11, 0, SIZE_MAX, "stride|11|12"},
        {12, 0, 0, "stride|12|24"},
        {23, 0, 12, "stride|23|24"},
        {12, 1, SIZE_MAX, "position_offset|1|12"},
        {24, 13, 0, "position_offset|13|24"},
        {24, 24, 0, "position_offset|24"},
        {24, SIZE_MAX, SIZE_MAX, "position_offset|24"}, /* only the normal may be left out so */
        {24, SIZE_MAX - 11, 0, "position_offset|24"},
        {24, 0, 13, "normal_offset|13|24"},
        {24, 0, SIZE_MAX - 1, "normal_offset|24"},
        {24, 0, SIZE_MAX - 11, "normal_offset|24"},
        {36, 12, 12, "normal_offset|12"},
        {36, 12, 1, "normal_offset|1|12"},
        {36, 12, 23, "normal_offset|23|12"},
    };
    for (size_t i = 0; i < COUNT(bad); ++i)
        refuses(m, cd_membrane_write_vertices(m, buffer, SIZE_MAX, bad[i].stride, bad[i].position, bad[i].normal),
                CD_ERROR_RANGE, bad[i].argument);
    assert_memory_equal(buffer, untouched, sizeof buffer);
}

static void no_index_is_cut_short(void** state) {
    (void)state;
    cd_membrane* const m = membrane;
    static const size_t bad[] = {0, 1, 3, 5, 8, SIZE_MAX, SIZE_MAX / 2 + 3};
    for (size_t i = 0; i < COUNT(bad); ++i)
        refuses(m, cd_membrane_write_indices(m, buffer, sizeof buffer, bad[i]), CD_ERROR_VALUE,
                name_and_size("index_size", bad[i]));
    assert_memory_equal(buffer, untouched, sizeof buffer);
    cd_membrane* large = cloth(255, 255, 1, CD_FLOAT32);
    refuses(large, cd_membrane_write_indices(large, buffer, SIZE_MAX, 2), CD_ERROR_UNSUPPORTED, "index_size|2|65536");
    cd_membrane_destroy(large);
}

static void the_least_that_suffices_is_taken(void** state) {
    (void)state;
    cd_membrane* const m = membrane;
    const uint64_t hash = hash_of(m);
    const size_t asked = heap.asked;
    ok(cd_membrane_write_vertices(m, buffer, NODES * STRIDE, STRIDE, 12, 0));
    ok(cd_membrane_write_vertices(m, buffer, NODES * 12, 12, 0, SIZE_MAX));
    ok(cd_membrane_write_indices(m, buffer, 2 * INDICES, 2));
    ok(cd_membrane_write_indices(m, buffer, 4 * INDICES, 4));
    assert_true(hash_of(m) == hash);
    assert_int_equal(heap.asked, asked);
}

static const char* const drawing[] = {"cd_membrane_write_vertices", "cd_membrane_write_indices"};

static void every_number_in_the_header_was_tried(void** state) {
    (void)state;
    static struct prototype functions[128];
    const size_t all = read_prototypes("membrane.h", functions, COUNT(functions));
    size_t found = 0;
    for (size_t i = 0; i < all; ++i) {
        bool draws = false;
        for (size_t d = 0; d < COUNT(drawing); ++d) draws |= strcmp(functions[i].name, drawing[d]) == 0;
        found += draws;
        for (size_t j = 0; draws && j < functions[i].count; ++j) {
            const struct parameter* p = &functions[i].parameters[j];
            const cd_status status = strcmp(p->name, "index_size") == 0 ? CD_ERROR_VALUE : CD_ERROR_RANGE;
            if (!strchr(p->type, '*') && !was_refused(functions[i].name, status, p->name))
                fail_msg("%s: nothing bad was tried for %s", functions[i].name, p->name);
        }
    }
    assert_int_equal(found, COUNT(drawing));
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(no_buffer_is_too_small),
        cmocka_unit_test(no_vertex_is_torn),
        cmocka_unit_test(no_index_is_cut_short),
        cmocka_unit_test(the_least_that_suffices_is_taken),
        cmocka_unit_test(every_number_in_the_header_was_tried),
    };
    return cmocka_run_group_tests(tests, set_up, tear_down);
}
