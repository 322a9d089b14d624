/* What the drawing functions of water.h refuse, and that they leave the water as it is. Pointers:
 * tests/bindings/check_pointers.py. */
#include <string.h>

#include "check.h"
#include "heap.h"
#include "pool.h"
#include "refusals.h"

enum { NX = 7, NY = 5, CELLS = NX * NY, STRIDE = 28, MOST = 6 * (NX - 1) * (NY - 1) };

static cd_water* water;
static struct heap heap;

static unsigned char buffer[CELLS * STRIDE + 4 * MOST], untouched[sizeof buffer];

static int set_up(void** state) {
    (void)state;
    const cd_allocator allocator = heap_allocator(&heap);
    water = pool_from(&allocator, NX, NY, CD_FLOAT64);
    pool_everything(water);
    memset(buffer, 0x5A, sizeof buffer);
    memset(untouched, 0x5A, sizeof untouched);
    return 0;
}

static int tear_down(void** state) {
    (void)state;
    cd_water_destroy(water);
    heap_free(&heap);
    return 0;
}

static void no_buffer_is_too_small(void** state) {
    (void)state;
    cd_water* const w = water;
    const size_t sizes[] = {0, 1, CELLS * STRIDE - 1};
    for (size_t i = 0; i < COUNT(sizes); ++i)
        refuses(w, cd_water_write_vertices(w, buffer, sizes[i], STRIDE, 0, 12, 24), CD_ERROR_RANGE,
                name_and_size("size", sizes[i]));
    /* cells * stride comes round to less than the size */
    const size_t strides[] = {SIZE_MAX, SIZE_MAX - 11, SIZE_MAX / 2 + 1, SIZE_MAX / CELLS + 1, SIZE_MAX / CELLS + 2};
    for (size_t i = 0; i < COUNT(strides); ++i)
        refuses(w, cd_water_write_vertices(w, buffer, sizeof buffer, strides[i], 0, 12, 24), CD_ERROR_RANGE,
                text_of("size|%zu|%zu", sizeof buffer, strides[i]));
    for (int32_t skip_dry = 0; skip_dry <= 1; ++skip_dry) {
        size_t count;
        ok(cd_water_get_index_count(w, skip_dry, &count));
        assert_true(count > 0 && count < MOST);
        for (size_t width = 2; width <= 4; width += 2)
            for (size_t less = 1; less <= width * count; less += 7)
                refuses(w, cd_water_write_indices(w, skip_dry, buffer, width * count - less, width), CD_ERROR_RANGE,
                        text_of("size|%zu|%zu", width * count - less, width * count));
    }
    assert_memory_equal(buffer, untouched, sizeof buffer);
}

static void no_vertex_is_torn(void** state) {
    (void)state;
    cd_water* const w = water;
    const size_t none = SIZE_MAX;
    const struct {
        size_t stride, position, normal, depth;
        const char* argument;
    } bad[] = {
        {0, 0, none, none, "stride|0|12"},
        {11, 0, none, none, "stride|11|12"},
        {12, 1, none, none, "position_offset|1|12"},
        {24, 13, 0, none, "position_offset|13|24"},
        {24, 24, 0, none, "position_offset|24"},
        {24, none, none, none, "position_offset|24"}, /* only normal and depth may be left out so */
        {24, none - 11, 0, none, "position_offset|24"},
        {24, 0, 13, none, "normal_offset|13|24"},
        {24, 0, none - 1, none, "normal_offset|24"},
        {24, 0, none - 11, none, "normal_offset|24"},
        {36, 12, 12, none, "normal_offset|12"},
        {36, 12, 1, none, "normal_offset|1|12"},
        {36, 12, 23, none, "normal_offset|23|12"},
        {15, 0, none, 12, "stride|15|16"},
        {24, 0, none, 21, "depth_offset|21|24"},
        {24, 0, none, none - 1, "depth_offset|24"},
        {24, 0, none, none - 3, "depth_offset|24"},
        {40, 12, none, 9, "depth_offset|9|12"},
        {40, 12, none, 12, "depth_offset|12"},
        {40, 12, none, 23, "depth_offset|23|12"},
        {40, 0, 20, 17, "depth_offset|17|20"},
        {40, 0, 20, 31, "depth_offset|31|20"},
    };
    for (size_t i = 0; i < COUNT(bad); ++i)
        refuses(w,
                cd_water_write_vertices(w, buffer, none, bad[i].stride, bad[i].position, bad[i].normal, bad[i].depth),
                CD_ERROR_RANGE, bad[i].argument);
    assert_memory_equal(buffer, untouched, sizeof buffer);
}

static void no_index_is_cut_short(void** state) {
    (void)state;
    cd_water* const w = water;
    static const size_t bad[] = {0, 1, 3, 5, 8, SIZE_MAX, SIZE_MAX / 2 + 3};
    for (size_t i = 0; i < COUNT(bad); ++i)
        refuses(w, cd_water_write_indices(w, 0, buffer, sizeof buffer, bad[i]), CD_ERROR_VALUE,
                name_and_size("index_size", bad[i]));
    static const int32_t no_choice[] = {-1, 2, INT32_MAX, INT32_MIN};
    for (size_t i = 0; i < COUNT(no_choice); ++i) {
        refuses(w, cd_water_write_indices(w, no_choice[i], buffer, sizeof buffer, 4), CD_ERROR_VALUE,
                text_of("skip_dry|%d", no_choice[i]));
        refuses(w, cd_water_get_index_count(w, no_choice[i], out.size), CD_ERROR_VALUE,
                text_of("skip_dry|%d", no_choice[i]));
    }
    assert_memory_equal(buffer, untouched, sizeof buffer);
}

static void short_indices_number_65535_vertices(void** state) {
    (void)state;
    static uint16_t index[6 * 254 * 256];
    cd_water* most = pool(255, 257, CD_FLOAT32); /* 65535 cells */
    ok(cd_water_write_indices(most, 0, index, sizeof index, 2));
    uint16_t last = 0;
    for (size_t k = 0; k < COUNT(index); ++k) last = index[k] > last ? index[k] : last;
    assert_int_equal(last, 65534);
    cd_water_destroy(most);
    cd_water* more = pool(256, 256, CD_FLOAT32);
    refuses(more, cd_water_write_indices(more, 0, buffer, SIZE_MAX, 2), CD_ERROR_UNSUPPORTED, "index_size|2|65536");
    ok(cd_water_write_indices(more, 1, NULL, 0, 4)); /* dry: none */
    cd_water_destroy(more);
}

static void the_least_that_suffices_is_taken(void** state) {
    (void)state;
    cd_water* const w = water;
    const uint64_t hash = hash_of(w);
    const size_t asked = heap.asked;
    size_t count;
    ok(cd_water_get_index_count(w, 0, &count));
    ok(cd_water_write_vertices(w, buffer, CELLS * STRIDE, STRIDE, 16, 4, 0));
    ok(cd_water_write_vertices(w, buffer, CELLS * 12, 12, 0, SIZE_MAX, SIZE_MAX));
    ok(cd_water_write_vertices(w, buffer, CELLS * 16, 16, 4, SIZE_MAX, 0));
    ok(cd_water_write_indices(w, 0, buffer, 2 * count, 2));
    ok(cd_water_write_indices(w, 0, buffer, 4 * count, 4));
    assert_true(hash_of(w) == hash);
    assert_int_equal(heap.asked, asked);
}

static void what_has_no_triangles_is_drawn_into_null(void** state) {
    (void)state;
    cd_water* one = pool(1, 1, CD_FLOAT32); /* a cell alone */
    ok(cd_water_write_indices(one, 0, NULL, 0, 4));
    cd_water_destroy(one);
}

static const char* const drawing[] = {"cd_water_write_vertices", "cd_water_get_index_count", "cd_water_write_indices"};

static void every_number_in_the_header_was_tried(void** state) {
    (void)state;
    static struct prototype functions[128];
    const size_t all = read_prototypes("water.h", functions, COUNT(functions));
    size_t found = 0;
    for (size_t i = 0; i < all; ++i) {
        bool draws = false;
        for (size_t d = 0; d < COUNT(drawing); ++d) draws |= strcmp(functions[i].name, drawing[d]) == 0;
        found += draws;
        for (size_t j = 0; draws && j < functions[i].count; ++j) {
            const struct parameter* p = &functions[i].parameters[j];
            const int chosen = strcmp(p->name, "index_size") == 0 || strcmp(p->name, "skip_dry") == 0;
            const cd_status status = chosen ? CD_ERROR_VALUE : CD_ERROR_RANGE;
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
        cmocka_unit_test(short_indices_number_65535_vertices),
        cmocka_unit_test(the_least_that_suffices_is_taken),
        cmocka_unit_test(what_has_no_triangles_is_drawn_into_null),
        cmocka_unit_test(every_number_in_the_header_was_tried),
    };
    return cmocka_run_group_tests(tests, set_up, tear_down);
}
