/* What surrounds ropes and cloth, air and colliders: who has none, and the numbers that none takes. A test program
 * includes this once, for the functions of one object, and says before:
 *   BODY                       chain or membrane
 *   THICKNESS                  the name of what its set_thickness takes
 *   new_body()                 makes one of 12 nodes and 3 components whose springs have no length
 *   set_lengths(body, length)  gives it some, or none
 *   read_winds(body, numbers)  reads the whole field CD_WIND */
#include <math.h>

#include "check.h"

#define HANDLE_OF(body) cd_##body
#define HANDLE_OF_(body) HANDLE_OF(body)
#define HANDLE HANDLE_OF_(BODY)
#define CALL_OF(body, name) cd_##body##_##name
#define CALL_OF_(body, name) CALL_OF(body, name)
#define CALL(name) CALL_OF_(BODY, name)
#define is_refused(call, status, text) refuses(b, call, status, text) /* names the function, not CALL */

enum { WINDS = 12 * 3 };

static void only_springs_that_have_a_length_feel_air_of_numbers_in_the_range(void** state) {
    (void)state;
    const double wind[3] = {1, 2, 3}, gust[3] = {-4, 5, 0.5};
    double air[2], shown[3], of_nodes[WINDS];
    HANDLE* b = new_body();
    is_refused(CALL(set_air)(b, 0, 1), CD_ERROR_UNSUPPORTED, "air|rest length");
    is_refused(CALL(set_wind)(b, wind, 3), CD_ERROR_UNSUPPORTED, "air|rest length");
    set_lengths(b, 1);
    refuses_each(b, CALL(set_air)(b, bad, 1), "along", not_finite);
    refuses_each(b, CALL(set_air)(b, bad, 1), "along", negative);
    refuses_each(b, CALL(set_air)(b, bad, 1), "along", too_large);
    refuses_each(b, CALL(set_air)(b, 1, bad), "across", not_finite);
    refuses_each(b, CALL(set_air)(b, 1, bad), "across", negative);
    refuses_each(b, CALL(set_air)(b, 1, bad), "across", too_large);
    for (size_t i = 0; i < COUNT(not_finite); ++i) {
        const double numbers[3] = {0.5, not_finite[i].value, 0.5};
        is_refused(CALL(set_wind)(b, numbers, 3), CD_ERROR_VALUE, text_of("velocity|[1]|%s", not_finite[i].shown));
    }
    is_refused(CALL(set_wind)(b, wind, 2), CD_ERROR_RANGE, name_and_size("count", 2));
    is_refused(CALL(get_wind)(b, shown, 2), CD_ERROR_RANGE, name_and_size("count", 2));
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

static void only_springs_that_have_a_length_touch_things_of_numbers_in_the_range(void** state) {
    (void)state;
    const double place[3] = {1, 2, 3}, none[3] = {0, -0.0, 0}, far[3] = {0, 1.5e60, 0};
    double radius;
    size_t count;
    HANDLE* b = new_body();
    is_refused(CALL(set_colliders)(b, 1), CD_ERROR_UNSUPPORTED, "things|rest length");
    is_refused(CALL(set_thickness)(b, 1), CD_ERROR_UNSUPPORTED, "things|rest length");
    is_refused(CALL(set_plane)(b, 0, place, place, 3, 0), CD_ERROR_UNSUPPORTED, "things|rest length");
    is_refused(CALL(set_capsule)(b, 0, place, place, 3, 1, 0), CD_ERROR_UNSUPPORTED, "things|rest length");
    is_refused(CALL(set_collider_velocity)(b, 0, place, 3), CD_ERROR_UNSUPPORTED, "things|rest length");
    is_refused(CALL(remove_collider)(b, 0), CD_ERROR_UNSUPPORTED, "things|rest length");
    set_lengths(b, 1);
    is_refused(CALL(set_plane)(b, 0, place, place, 3, 0), CD_ERROR_RANGE, name_and_size("index", 0));
    is_refused(CALL(set_colliders)(b, 4097), CD_ERROR_VALUE, name_and_size("count", 4097));
    is_refused(CALL(set_colliders)(b, SIZE_MAX), CD_ERROR_VALUE, name_and_size("count", SIZE_MAX));
    ok(CALL(set_colliders)(b, 2));
    refuses_each(b, CALL(set_thickness)(b, bad), THICKNESS, not_finite);
    refuses_each(b, CALL(set_thickness)(b, bad), THICKNESS, negative);
    refuses_each(b, CALL(set_thickness)(b, bad), THICKNESS, too_large);
    refuses_each(b, CALL(set_plane)(b, 0, place, place, 3, bad), "friction", not_finite);
    refuses_each(b, CALL(set_plane)(b, 0, place, place, 3, bad), "friction", negative);
    refuses_each(b, CALL(set_plane)(b, 0, place, place, 3, bad), "friction", too_large);
    refuses_each(b, CALL(set_capsule)(b, 0, place, place, 3, 1, bad), "friction", not_finite);
    refuses_each(b, CALL(set_capsule)(b, 0, place, place, 3, 1, bad), "friction", negative);
    refuses_each(b, CALL(set_capsule)(b, 0, place, place, 3, 1, bad), "friction", too_large);
    refuses_each(b, CALL(set_capsule)(b, 0, place, place, 3, bad, 0), "radius", not_finite);
    refuses_each(b, CALL(set_capsule)(b, 0, place, place, 3, bad, 0), "radius", not_positive);
    refuses_each(b, CALL(set_capsule)(b, 0, place, place, 3, bad, 0), "radius", too_small);
    refuses_each(b, CALL(set_capsule)(b, 0, place, place, 3, bad, 0), "radius", too_large);
    is_refused(CALL(set_plane)(b, 0, place, none, 3, 0), CD_ERROR_VALUE, "normal|0");
    is_refused(CALL(set_plane)(b, 0, far, place, 3, 0), CD_ERROR_VALUE, "point|[1]|1.5e+60");
    for (size_t at = 0; at < 3; ++at)
        for (size_t i = 0; i < COUNT(not_finite); ++i) {
            double numbers[3] = {0.5, 0.5, 0.5};
            numbers[at] = not_finite[i].value;
            const char* text = text_of("[%zu]|%s", at, not_finite[i].shown);
            is_refused(CALL(set_plane)(b, 0, numbers, place, 3, 0), CD_ERROR_VALUE, text_of("point|%s", text));
            is_refused(CALL(set_plane)(b, 0, place, numbers, 3, 0), CD_ERROR_VALUE, text_of("normal|%s", text));
            is_refused(CALL(set_capsule)(b, 0, numbers, place, 3, 1, 0), CD_ERROR_VALUE, text_of("first|%s", text));
            is_refused(CALL(set_capsule)(b, 0, place, numbers, 3, 1, 0), CD_ERROR_VALUE, text_of("last|%s", text));
            is_refused(CALL(set_collider_velocity)(b, 0, numbers, 3), CD_ERROR_VALUE, text_of("velocity|%s", text));
        }
    static const size_t beyond[] = {2, 3, 4096, SIZE_MAX / 2, SIZE_MAX};
    for (size_t i = 0; i < COUNT(beyond); ++i) {
        const size_t index = beyond[i], n = i == 0 ? 2 : index + 1;
        const char *at = name_and_size("index", index), *of = name_and_size("count", n);
        is_refused(CALL(set_plane)(b, index, place, place, 3, 0), CD_ERROR_RANGE, at);
        is_refused(CALL(set_capsule)(b, index, place, place, 3, 1, 0), CD_ERROR_RANGE, at);
        is_refused(CALL(set_collider_velocity)(b, index, place, 3), CD_ERROR_RANGE, at);
        is_refused(CALL(remove_collider)(b, index), CD_ERROR_RANGE, at);
        is_refused(CALL(get_collider)(b, index, &out.i32, out.number, out.number + 3, out.number + 6, 3,
                                      out.number + 9, out.number + 10), CD_ERROR_RANGE, at);
        is_refused(CALL(set_plane)(b, 1, place, place, n, 0), CD_ERROR_RANGE, of);
        is_refused(CALL(set_capsule)(b, 1, place, place, n, 1, 0), CD_ERROR_RANGE, of);
        is_refused(CALL(set_collider_velocity)(b, 1, place, n), CD_ERROR_RANGE, of);
        is_refused(CALL(get_collider)(b, 1, &out.i32, out.number, out.number + 3, out.number + 6, n,
                                      out.number + 9, out.number + 10), CD_ERROR_RANGE, of);
    }
    ok(CALL(set_thickness)(b, 0.25));
    set_lengths(b, 0); /* switches all of it off */
    set_lengths(b, 1);
    ok(CALL(get_colliders)(b, &count));
    ok(CALL(get_thickness)(b, &radius));
    assert_true(count == 0 && radius == 0);
    CALL(destroy)(b);
}

#define SURROUNDINGS_TESTS                                                                                             \
    cmocka_unit_test(only_springs_that_have_a_length_feel_air_of_numbers_in_the_range),                                \
        cmocka_unit_test(only_springs_that_have_a_length_touch_things_of_numbers_in_the_range)
