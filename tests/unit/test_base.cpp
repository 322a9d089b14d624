// Checked sizes, sums, the walk that saves, loads and hashes, and messages.
#include <math.h>

#include <initializer_list>

#include "base/archive.hh"
#include "base/memory.hh"
#include "base/sum.hh"
#include "model/keep.hh"

extern "C" {
#include "cmocka_all.h" // last: it makes a macro of the name fail
}
#undef fail

namespace {

void sizes_that_do_not_fit_are_refused(void**) {
    size_t out = 7;
    assert_true(cd::multiply(1000, 1000, out) && out == 1000000);
    assert_false(cd::multiply(SIZE_MAX / 2, 3, out));
    assert_false(cd::multiply(size_t(1) << 40, size_t(1) << 40, out));
    assert_false(cd::multiply(SIZE_MAX / 2 + 1, 1, out)); // more than a pointer difference holds
    assert_false(cd::add(SIZE_MAX, 1, out));
    assert_true(out == 1000000);
    assert_true(cd::add(2, 3, out) && out == 5);
}

void memory_is_counted_zeroed_and_aligned(void**) {
    cd::Memory memory{cd::default_allocator(), 0};
    cd::Array<double> array;
    assert_true(cd::allocate(memory, 1001, array));
    assert_true(memory.bytes == 1001 * sizeof(double) && uintptr_t(array.data) % cd::kAlignment == 0);
    for (size_t i = 0; i < array.count; ++i) assert_true(array[i] == 0);
    cd::Array<double> too_much;
    assert_false(cd::allocate(memory, SIZE_MAX / 4, too_much));
    assert_false(bool(too_much));
    cd::release(memory, array);
    assert_true(memory.bytes == 0 && !array);
}

// Plain addition of these terms is off by more than the sum itself.
void sums_keep_what_plain_addition_loses(void**) {
    cd::Sum sum;
    for (double term : {1.0, 1e100, 1.0, -1e100}) sum.add(term);
    assert_true(sum.value() == 2);
    sum.add(double(INFINITY));
    assert_true(isinf(sum.value()));
}

void numbers_come_back_from_bytes_little_end_first(void**) {
    unsigned char bytes[32];
    double number = -1.5e-7;
    float single = 0.1f;
    uint32_t whole = 0x01020304;
    cd::Writer writer{bytes};
    cd::walk(writer, whole), cd::walk(writer, number), cd::walk(writer, single);
    assert_true(writer.to == bytes + 16 && bytes[0] == 4 && bytes[3] == 1);
    double number_back = 0;
    float single_back = 0;
    uint32_t whole_back = 0;
    cd::Reader reader{bytes, bytes + 16};
    cd::walk(reader, whole_back), cd::walk(reader, number_back), cd::walk(reader, single_back);
    assert_true(reader.whole && whole_back == whole && number_back == number && single_back == single);
    cd::walk(reader, whole_back);
    assert_false(reader.whole);
}

void messages_are_whole_or_say_that_they_are_not(void**) {
    const cd::Kind kind = {CD_KIND_MEMBRANE, "membrane", {"springs along u", "springs along v"}};
    const cd::Shape most = {{UINT64_MAX, UINT64_MAX}, UINT64_MAX, -2147483647};
    assert_int_equal(cd::shapes_differ("cd_membrane_copy_state", kind, "the saved one", most, most), CD_ERROR_MISMATCH);
    assert_non_null(strstr(cd::last_message(), "18446744073709551615, -2147483647"));
    char text[1000];
    memset(text, 'x', sizeof text);
    text[sizeof text - 1] = 0;
    assert_int_equal(cd::fail(CD_ERROR_VALUE, "f", "%s", text), CD_ERROR_VALUE);
    const size_t length = strlen(cd::last_message());
    assert_true(length < sizeof text && strcmp(cd::last_message() + length - 3, "...") == 0);
    text[length - 3] = 0; // what just fits stands as it is
    assert_int_equal(cd::fail(CD_ERROR_VALUE, "f", "%s", text), CD_ERROR_VALUE);
    assert_true(strlen(cd::last_message()) == length && cd::last_message()[length - 1] == 'x');
}

} // namespace

int main() {
    const CMUnitTest tests[] = {
        cmocka_unit_test(sizes_that_do_not_fit_are_refused),
        cmocka_unit_test(memory_is_counted_zeroed_and_aligned),
        cmocka_unit_test(sums_keep_what_plain_addition_loses),
        cmocka_unit_test(numbers_come_back_from_bytes_little_end_first),
        cmocka_unit_test(messages_are_whole_or_say_that_they_are_not),
    };
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
