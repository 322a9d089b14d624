#include "cmocka_all.h"

#include <stdio.h>
#include <string.h>

static jmp_buf end_of_test;

int _cmocka_run_group_tests(const char* group, const struct CMUnitTest* tests, size_t count, CMFixtureFunction setup,
                            CMFixtureFunction teardown) {
    static volatile size_t i, failed; /* longjmp leaves them as they are */
    static void* of_group;
    printf("%s: %zu tests\n", group, count);
    if (setup && (setjmp(end_of_test) || setup(&of_group))) return -1;
    for (i = 0, failed = 0; i < count; ++i) {
        void* state = tests[i].initial_state ? tests[i].initial_state : of_group;
        if (setjmp(end_of_test) == 0) {
            tests[i].test_func(&state);
            printf("passed: %s\n", tests[i].name);
        } else {
            printf("FAILED: %s\n", tests[i].name);
            ++failed;
        }
        fflush(stdout);
    }
    if (teardown && (setjmp(end_of_test) || teardown(&of_group))) return -1;
    return (int)failed;
}

void _fail(const char* file, int line) {
    printf("%s:%d: failed\n", file, line);
    longjmp(end_of_test, 1);
}

void fail_unless(int holds, const char* what, const char* file, int line) {
    if (holds) return;
    printf("should hold: %s\n", what);
    _fail(file, line);
}

void fail_unless_equal(unsigned long long a, unsigned long long b, int equal, const char* file, int line) {
    if ((a == b) == equal) return;
    printf("0x%llx should %sbe 0x%llx\n", a, equal ? "" : "not ", b);
    _fail(file, line);
}

void fail_unless_in_range(unsigned long long value, unsigned long long least, unsigned long long most, const char* file,
                          int line) {
    if (least <= value && value <= most) return;
    printf("0x%llx should be from 0x%llx to 0x%llx\n", value, least, most);
    _fail(file, line);
}

void fail_unless_same_text(const char* a, const char* b, const char* file, int line) {
    if (strcmp(a, b) == 0) return;
    printf("\"%s\" should be \"%s\"\n", a, b);
    _fail(file, line);
}

void fail_unless_same_bytes(const void* a, const void* b, size_t size, const char* file, int line) {
    if (memcmp(a, b, size) == 0) return;
    printf("%zu bytes are not the same\n", size);
    _fail(file, line);
}

void print_message(const char* format, ...) {
    va_list arguments;
    va_start(arguments, format);
    vprintf(format, arguments);
    va_end(arguments);
}

void print_error(const char* format, ...) {
    va_list arguments;
    va_start(arguments, format);
    vprintf(format, arguments);
    va_end(arguments);
}
