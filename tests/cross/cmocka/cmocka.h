/* The part of cmocka that the tests use, for processors and systems that cmocka itself is not packaged for: the same
 * names and meaning. What fails ends its test, and the others go on. */
#ifndef SMALL_CMOCKA_H
#define SMALL_CMOCKA_H

#ifdef __cplusplus
extern "C" {
#endif

typedef void (*CMUnitTestFunction)(void** state);
typedef int (*CMFixtureFunction)(void** state); /* of a group; none of the tests has one of its own */

struct CMUnitTest {
    const char* name;
    CMUnitTestFunction test_func;
    CMFixtureFunction setup_func, teardown_func;
    void* initial_state;
};

/* Returns how many tests failed, or -1 if the group cannot be set up or torn down. */
int _cmocka_run_group_tests(const char* group, const struct CMUnitTest* tests, size_t count, CMFixtureFunction setup,
                            CMFixtureFunction teardown);

/* Prints where and what, and ends the test. */
void _fail(const char* file, int line);
void fail_unless(int holds, const char* what, const char* file, int line);
void fail_unless_equal(unsigned long long a, unsigned long long b, int equal, const char* file, int line);
void fail_unless_in_range(unsigned long long value, unsigned long long least, unsigned long long most, const char* file,
                          int line);
void fail_unless_same_text(const char* a, const char* b, const char* file, int line);
void fail_unless_same_bytes(const void* a, const void* b, size_t size, const char* file, int line);

void print_message(const char* format, ...);
void print_error(const char* format, ...);

#ifdef __cplusplus
}
#endif

#define cmocka_unit_test(function) {#function, function, NULL, NULL, NULL}
#define cmocka_run_group_tests_name(group, tests, setup, teardown) \
    _cmocka_run_group_tests(group, tests, sizeof(tests) / sizeof((tests)[0]), setup, teardown)
#define cmocka_run_group_tests(tests, setup, teardown) cmocka_run_group_tests_name(#tests, tests, setup, teardown)

#define fail() _fail(__FILE__, __LINE__)
#define fail_msg(...) (print_error("ERROR: " __VA_ARGS__), print_error("\n"), fail())
#define assert_true(c) fail_unless((c) ? 1 : 0, #c, __FILE__, __LINE__)
#define assert_false(c) fail_unless((c) ? 0 : 1, "not " #c, __FILE__, __LINE__)
#define assert_non_null(p) fail_unless((p) ? 1 : 0, #p " is not null", __FILE__, __LINE__)
#define assert_null(p) fail_unless((p) ? 0 : 1, #p " is null", __FILE__, __LINE__)
#define assert_ptr_equal(a, b) fail_unless((const void*)(a) == (const void*)(b), #a " is " #b, __FILE__, __LINE__)
#define assert_int_equal(a, b) \
    fail_unless_equal((unsigned long long)(a), (unsigned long long)(b), 1, __FILE__, __LINE__)
#define assert_int_not_equal(a, b) \
    fail_unless_equal((unsigned long long)(a), (unsigned long long)(b), 0, __FILE__, __LINE__)
#define assert_in_range(value, least, most)                                                                    \
    fail_unless_in_range((unsigned long long)(value), (unsigned long long)(least), (unsigned long long)(most), \
                         __FILE__, __LINE__)
#define assert_string_equal(a, b) fail_unless_same_text(a, b, __FILE__, __LINE__)
#define assert_memory_equal(a, b, size) fail_unless_same_bytes(a, b, size, __FILE__, __LINE__)

#endif
