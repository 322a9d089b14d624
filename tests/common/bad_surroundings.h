/* What surrounds ropes and cloth, air and colliders: who has none, and what numbers do not go together; likewise of
 * sleep. A test program includes this once, for the functions of one object, and says before:
 *   BODY                       chain or membrane
 *   new_body()                 makes one of 12 nodes and 3 components whose springs have no length
 *   set_lengths(body, length)  gives it some, or none
 *   read_winds(body, numbers)  reads the whole field CD_WIND */
#include <math.h>
#include <string.h>

#include "check.h"

#define HANDLE_OF(body) cd_##body
#define HANDLE_OF_(body) HANDLE_OF(body)
#define HANDLE HANDLE_OF_(BODY)
#define CALL_OF(body, name) cd_##body##_##name
#define CALL_OF_(body, name) CALL_OF(body, name)
#define CALL(name) CALL_OF_(BODY, name)
#define TEXT_OF(words) #words
#define TEXT(words) TEXT_OF(words)
/* They name the function, not CALL. */
#define is_refused(call, status, text) refuses(b, call, status, text)
#define is_refused_by(body, call, status, text) refuses(body, call, status, text)

enum { WINDS = 12 * 3 };

/* With speed 0 seconds mean nothing. */
static void only_what_sleeps_needs_seconds(void** state) {
    (void)state;
    double speed = -1, seconds = -1;
    HANDLE* b = new_body();
    ok(CALL(get_sleep)(b, &speed, &seconds));
    assert_true(speed == 0 && seconds == 0);
    for (size_t i = 0; i < COUNT(not_finite); ++i)
        is_refused(CALL(set_sleep)(b, 1, not_finite[i].value), CD_ERROR_VALUE,
                   text_of("seconds|%s", not_finite[i].shown));
    is_refused(CALL(set_sleep)(b, 1, 0), CD_ERROR_VALUE, "seconds|0");
    ok(CALL(set_sleep)(b, 2, 1e-30));
    ok(CALL(set_sleep)(b, 1e60, 1e60));
    ok(CALL(get_sleep)(b, &speed, &seconds));
    assert_true(speed == 1e60 && seconds == 1e60);
    ok(CALL(set_sleep)(b, -0.0, (double)NAN));
    ok(CALL(get_sleep)(b, &speed, &seconds));
    assert_true(speed == 0 && !signbit(speed) && seconds == 0);
    CALL(destroy)(b);
}

static void only_springs_that_have_a_length_feel_air(void** state) {
    (void)state;
    const double wind[3] = {1, 2, 3}, gust[3] = {-4, 5, 0.5};
    double air[2], shown[3], of_nodes[WINDS];
    HANDLE* b = new_body();
    is_refused(CALL(set_air)(b, 0, 1), CD_ERROR_UNSUPPORTED, "air|rest length");
    is_refused(CALL(set_wind)(b, wind, 3), CD_ERROR_UNSUPPORTED, "air|rest length");
    set_lengths(b, 1);
    ok(CALL(set_air)(b, 0.25, 2));
    ok(CALL(set_wind)(b, wind, 3));
    ok(CALL(get_air)(b, &air[0], &air[1]));
    ok(CALL(get_wind)(b, shown, 3));
    assert_true(air[0] == 0.25 && air[1] == 2);
    assert_same_bits(shown, wind, 3);
    ok(CALL(enable_field)(b, CD_WIND));
    ok(read_winds(b, of_nodes));
    for (size_t k = 0; k < WINDS; ++k) assert_true(of_nodes[k] == wind[k % 3]);
    ok(CALL(set_wind)(b, gust, 3)); /* writes the field anew */
    ok(read_winds(b, of_nodes));
    for (size_t k = 0; k < WINDS; ++k) assert_true(of_nodes[k] == gust[k % 3]);
    set_lengths(b, 0); /* switches all of it off */
    set_lengths(b, 1);
    ok(CALL(get_air)(b, &air[0], &air[1]));
    ok(CALL(get_wind)(b, shown, 3));
    assert_true(air[0] == 0 && air[1] == 0 && shown[0] == 0 && shown[1] == 0 && shown[2] == 0);
    assert_int_equal(read_winds(b, of_nodes), CD_ERROR_DISABLED);
    CALL(destroy)(b);
}

static void only_springs_that_have_a_length_touch_things(void** state) {
    (void)state;
    const double place[3] = {1, 2, 3}, none[3] = {0, -0.0, 0};
    double radius;
    size_t count;
    HANDLE* b = new_body();
    is_refused(CALL(set_colliders)(b, 1), CD_ERROR_UNSUPPORTED, "things|rest length");
    is_refused(CALL(set_thickness)(b, 1), CD_ERROR_UNSUPPORTED, "things|rest length");
    is_refused(CALL(set_loads)(b, 1), CD_ERROR_UNSUPPORTED, "things|rest length");
    is_refused(CALL(set_plane)(b, 0, place, place, 3, 0), CD_ERROR_UNSUPPORTED, "things|rest length");
    is_refused(CALL(set_capsule)(b, 0, place, place, 3, 1, 0), CD_ERROR_UNSUPPORTED, "things|rest length");
    is_refused(CALL(set_collider_velocity)(b, 0, place, 3), CD_ERROR_UNSUPPORTED, "things|rest length");
    is_refused(CALL(remove_collider)(b, 0), CD_ERROR_UNSUPPORTED, "things|rest length");
    set_lengths(b, 1);
    const char* none_yet = text_of("index|0|no colliders yet|%s first", TEXT(CALL(set_colliders)));
    is_refused(CALL(set_plane)(b, 0, place, place, 3, 0), CD_ERROR_RANGE, none_yet);
    is_refused(CALL(get_bed)(b, 0, &count, &count, NULL, 0), CD_ERROR_RANGE, none_yet);
    is_refused(CALL(get_collider)(b, 0, &out.i32, NULL, NULL, NULL, 3, &radius, &radius), CD_ERROR_RANGE, none_yet);
    is_refused(CALL(get_collider_load)(b, 0, out.number, 6), CD_ERROR_RANGE, none_yet);
    ok(CALL(set_colliders)(b, 2));
    is_refused(CALL(set_plane)(b, 0, place, none, 3, 0), CD_ERROR_VALUE, "normal|0");
    ok(CALL(set_thickness)(b, 0.25));
    set_lengths(b, 0); /* switches all of it off */
    set_lengths(b, 1);
    ok(CALL(get_colliders)(b, &count));
    ok(CALL(get_thickness)(b, &radius));
    assert_true(count == 0 && radius == 0);
    CALL(destroy)(b);
}

static void loads_are_told_to_who_asks(void** state) {
    (void)state;
    double load[6] = {1, 1, 1, 1, 1, 1};
    int32_t told = 7;
    HANDLE* b = new_body();
    set_lengths(b, 1);
    ok(CALL(set_colliders)(b, 2));
    ok(CALL(get_loads)(b, &told));
    assert_int_equal(told, 0);
    is_refused(CALL(get_collider_load)(b, 1, out.number, 6), CD_ERROR_DISABLED,
               text_of("loads|%s", TEXT(CALL(set_loads))));
    is_refused(CALL(set_loads)(b, 2), CD_ERROR_VALUE, "loads|2");
    is_refused(CALL(set_loads)(b, -1), CD_ERROR_VALUE, "loads|-1");
    ok(CALL(set_loads)(b, 1));
    ok(CALL(get_loads)(b, &told));
    assert_int_equal(told, 1);
    is_refused(CALL(get_collider_load)(b, 2, out.number, 6), CD_ERROR_RANGE, name_and_size("index", 2));
    is_refused(CALL(get_collider_load)(b, 1, out.number, 3), CD_ERROR_RANGE, name_and_size("count", 3));
    ok(CALL(get_collider_load)(b, 1, load, 6)); /* before any step */
    for (int k = 0; k < 6; ++k) assert_true(load[k] == 0 && !signbit(load[k]));
    ok(CALL(set_colliders)(b, 0)); /* they stay asked for */
    ok(CALL(get_loads)(b, &told));
    assert_int_equal(told, 1);
    set_lengths(b, 0);
    ok(CALL(get_loads)(b, &told));
    assert_int_equal(told, 0);
    CALL(destroy)(b);
}

/* A level floor 1 m below the origin; or, where a number says so, answers that are none. */
static void tell_floor(void* user, double time, size_t count, size_t components, const double* positions,
                       double* distances, double* normals) {
    const double* const wrong = user;
    (void)time;
    for (size_t i = 0; i < count; ++i) {
        distances[i] = positions[i * components + 1] + 1 + (wrong ? wrong[0] : 0);
        for (size_t k = 0; k < components; ++k) normals[i * components + k] = k == 1 ? 1 + (wrong ? wrong[1] : 0) : 0;
    }
}

static void beds_have_as_many_heights_as_places(void** state) {
    (void)state;
    const double place[3] = {1, 2, 3}, heights[6] = {1, 2, 3, 4, 5, 6};
    double told[6], second[3];
    size_t columns = 7, rows = 7;
    HANDLE* b = new_body();
    is_refused(CALL(set_bed)(b, 0, place, 3, 3, 2, 1, 1, heights, 6, 0), CD_ERROR_UNSUPPORTED, "things|rest length");
    set_lengths(b, 1);
    is_refused(CALL(set_bed)(b, 0, place, 3, 3, 2, 1, 1, heights, 6, 0), CD_ERROR_RANGE, name_and_size("index", 0));
    is_refused(CALL(get_bed)(b, 0, &out.size[0], &out.size[1], out.number, 0), CD_ERROR_RANGE,
               name_and_size("index", 0));
    ok(CALL(set_colliders)(b, 3));
    is_refused(CALL(set_bed)(b, 0, NULL, 3, 3, 2, 1, 1, heights, 6, 0), CD_ERROR_NULL, "origin");
    is_refused(CALL(set_bed)(b, 0, place, 3, 3, 2, 1, 1, NULL, 6, 0), CD_ERROR_NULL, "heights");
    is_refused(CALL(set_bed)(b, 0, place, 3, 3, 2, 1, 1, heights, 5, 0), CD_ERROR_RANGE, "height_count|5|3|2");
    is_refused(CALL(set_bed)(b, 0, place, 3, SIZE_MAX / 2, 4, 1, 1, heights, 6, 0), CD_ERROR_RANGE, "height_count|6");
    ok(CALL(get_bed)(b, 1, &columns, &rows, told, 0));
    assert_true(columns == 0 && rows == 0); /* of what is none */
    const double turned[6] = {6, 5, 4, 3, 2, 1};
    ok(CALL(set_bed)(b, 2, place, 3, 2, 3, 0.25, 0.5, turned, 6, 0.75)); /* and one before it */
    ok(CALL(set_bed)(b, 0, place, 3, 3, 2, 4, 5, heights, 6, 0));
    ok(CALL(get_bed)(b, 2, &columns, &rows, told, 6));
    assert_true(columns == 2 && rows == 3);
    assert_same_bits(told, turned, 6);
    ok(CALL(get_bed)(b, 0, &columns, NULL, NULL, 99));
    assert_true(columns == 3);
    is_refused(CALL(get_bed)(b, 0, &out.size[0], &out.size[1], out.number, 5), CD_ERROR_RANGE,
               name_and_size("height_count", 5));
    ok(CALL(set_plane)(b, 0, place, place, 3, 0)); /* is no bed any more, and leaves the others */
    ok(CALL(get_bed)(b, 0, &columns, NULL, told, 0));
    assert_true(columns == 0);
    ok(CALL(get_bed)(b, 2, &columns, &rows, told, 6));
    assert_same_bits(told, turned, 6);
    cd_shape shape;
    double friction;
    ok(CALL(get_collider)(b, 2, &shape, told, second, NULL, 3, NULL, &friction));
    assert_true(shape == CD_SHAPE_BED && friction == 0.75 && second[0] == 0.25 && second[1] == 0.5 && second[2] == 0);
    assert_same_bits(told, place, 3);
    ok(CALL(set_colliders)(b, 2)); /* what goes takes its heights along */
    ok(CALL(set_colliders)(b, 3));
    ok(CALL(get_bed)(b, 2, &columns, &rows, NULL, 0));
    assert_true(columns == 0 && rows == 0);
    CALL(destroy)(b);
}

static void callbacks_are_functions_that_tell_distances(void** state) {
    (void)state;
    static const struct {
        double wrong[2];
        const char* shown;
    } answers[] = {{{NAN, 0}, "distance of nan|length 1"},
                   {{INFINITY, 0}, "distance of inf"},
                   {{-1e61, 0}, "-1e+61"},
                   {{0, 0.002}, "length 1.002"},
                   {{0, -1}, "length 0"},
                   {{0, NAN}, "length nan"}};
    const double place[3] = {0.5, 0, 0};
    const cd_distance floor = {NULL, tell_floor}, none = {NULL, NULL};
    HANDLE* b = new_body();
    is_refused(CALL(set_callback)(b, 0, &floor, place, 3, 0), CD_ERROR_UNSUPPORTED, "things|rest length");
    set_lengths(b, 1);
    is_refused(CALL(set_callback)(b, 0, &floor, place, 3, 0), CD_ERROR_RANGE, name_and_size("index", 0));
    ok(CALL(set_colliders)(b, 2));
    is_refused(CALL(set_callback)(b, 1, NULL, place, 3, 0), CD_ERROR_NULL, "distance");
    is_refused(CALL(set_callback)(b, 1, &none, place, 3, 0), CD_ERROR_NULL, "distance->distance|null");
    is_refused(CALL(set_callback)(b, 1, &floor, NULL, 3, 0), CD_ERROR_NULL, "origin");
    ok(CALL(set_callback)(b, 1, &floor, place, 3, 0.5));
    ok(CALL(set_lambda)(b, 1));
    ok(CALL(step)(b, 0.01, 2));
    for (size_t i = 0; i < COUNT(answers); ++i) { /* the steps are made, and nothing that is not finite comes of them */
        const cd_distance wrong = {(void*)answers[i].wrong, tell_floor};
        double time[2], first[3];
        ok(CALL(get_time)(b, &time[0]));
        ok(CALL(set_callback)(b, 1, &wrong, NULL, 0, 99));
        assert_int_equal(CALL(step)(b, 0.01, 3), CD_ERROR_CALLBACK);
        assert_non_null(strstr(cd_error_message(), "collider 1"));
        for (const char *piece = answers[i].shown, *end; *piece; piece = *end ? end + 1 : end) {
            end = piece + strcspn(piece, "|");
            assert_non_null(strstr(cd_error_message(), text_of("%.*s", (int)(end - piece), piece)));
        }
        ok(CALL(get_time)(b, &time[1]));
        assert_near(time[1] - time[0], 0.03, 1e-9, 0);
        double winds[WINDS];
        ok(CALL(enable_field)(b, CD_WIND));
        ok(read_winds(b, winds));
        ok(CALL(get_collider)(b, 1, NULL, first, NULL, NULL, 3, NULL, &time[0]));
        assert_true(time[0] == 0.5 && first[0] == 0.5); /* what it was set with stays */
    }
    ok(CALL(set_callback)(b, 1, &floor, NULL, 0, 0));
    ok(CALL(step)(b, 0.01, 2));
    CALL(destroy)(b);
}

/* A callback is no state: where there was one it goes on, and elsewhere it must be set again. */
static void callbacks_are_not_kept(void** state) {
    (void)state;
    const double place[3] = {0.5, 0, 0}, heights[4] = {-2, -3, -2, -3};
    const cd_distance floor = {NULL, tell_floor};
    unsigned char bytes[1 << 16];
    size_t size, columns;
    HANDLE *b = new_body(), *other = new_body(), *copy = new_body();
    set_lengths(b, 1);
    ok(CALL(set_lambda)(b, 1));
    ok(CALL(set_colliders)(b, 3));
    ok(CALL(set_callback)(b, 1, &floor, place, 3, 0.5));
    ok(CALL(set_bed)(b, 2, place, 3, 2, 2, 1, 1, heights, 4, 0.5));
    ok(CALL(save)(b, bytes, sizeof bytes, &size));
    const uint64_t hash = hash_of(b);
    ok(CALL(step)(b, 0.01, 3));
    ok(CALL(load)(b, bytes, size)); /* back in time: the same callback */
    assert_true(hash_of(b) == hash);
    ok(CALL(step)(b, 0.01, 3));
    ok(CALL(load)(other, bytes, size));
    ok(CALL(copy_state)(copy, other));
    for (int which = 0; which < 2; ++which) {
        HANDLE* const fresh = which ? copy : other;
        assert_true(hash_of(fresh) == hash);
        ok(CALL(get_bed)(fresh, 2, &columns, NULL, NULL, 0));
        assert_true(columns == 2);
        is_refused_by(fresh, CALL(step)(fresh, 0.01, 3), CD_ERROR_UNSUPPORTED, "collider 1|callback");
        ok(CALL(set_callback)(fresh, 1, &floor, NULL, 0, 0));
        assert_true(hash_of(fresh) == hash);
        ok(CALL(step)(fresh, 0.01, 3));
        assert_true(hash_of(fresh) == hash_of(b));
    }
    ok(CALL(remove_collider)(b, 1)); /* and what was removed in between is lost */
    ok(CALL(load)(b, bytes, size));
    is_refused(CALL(step)(b, 0.01, 3), CD_ERROR_UNSUPPORTED, "collider 1|callback");
    CALL(destroy)(b), CALL(destroy)(other), CALL(destroy)(copy);
}

/* What takes memory while it is there, and gives all of it back. */
static void beds_and_callbacks_give_their_memory_back(void** state) {
    (void)state;
    const double place[3] = {0.5, 0, 0};
    static const double heights[1000];
    const cd_distance floor = {NULL, tell_floor};
    size_t none, beds, more;
    HANDLE* b = new_body();
    set_lengths(b, 1);
    ok(CALL(set_lambda)(b, 1));
    ok(CALL(set_colliders)(b, 3));
    ok(CALL(get_memory)(b, &none));
    ok(CALL(set_bed)(b, 1, place, 3, 100, 10, 1, 1, heights, 1000, 0));
    ok(CALL(get_memory)(b, &beds));
    assert_int_equal(beds, none + (1000 + 2) * sizeof(double));
    ok(CALL(set_bed)(b, 1, place, 3, 10, 100, 1, 1, heights, 1000, 0)); /* in the same memory */
    ok(CALL(set_callback)(b, 0, &floor, place, 3, 0));
    ok(CALL(get_memory)(b, &more));
    assert_true(more > beds);
    for (int i = 0; i < 5; ++i) {
        size_t now;
        ok(CALL(step)(b, 0.01, 2));
        ok(CALL(set_callback)(b, 0, &floor, place, 3, 0));
        ok(CALL(set_collider_velocity)(b, 1, place, 3));
        ok(CALL(get_memory)(b, &now));
        assert_int_equal(now, more);
    }
    ok(CALL(remove_collider)(b, 0));
    ok(CALL(get_memory)(b, &more));
    assert_int_equal(more, beds);
    ok(CALL(set_capsule)(b, 1, place, place, 3, 1, 0));
    ok(CALL(get_memory)(b, &more));
    assert_int_equal(more, none);
    CALL(destroy)(b);
}

#define SURROUNDINGS_TESTS                                                                                            \
    cmocka_unit_test(only_springs_that_have_a_length_feel_air),                                                       \
        cmocka_unit_test(only_springs_that_have_a_length_touch_things), cmocka_unit_test(loads_are_told_to_who_asks), \
        cmocka_unit_test(beds_have_as_many_heights_as_places),                                                        \
        cmocka_unit_test(callbacks_are_functions_that_tell_distances), cmocka_unit_test(callbacks_are_not_kept),      \
        cmocka_unit_test(beds_and_callbacks_give_their_memory_back)
