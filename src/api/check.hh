// Checks of arguments that every public header's functions share. Each returns CD_OK or fails with the offending value.
#pragma once

#include <math.h>

#include "base/status.hh"

// Leaves the function with the status of a check that failed.
#define CD_CHECK(check)                                          \
    do {                                                         \
        if (const cd_status checked_ = (check)) return checked_; \
    } while (0)

// For a pointer argument that may not be null.
#define CD_NOT_NULL(pointer) CD_CHECK(::cd::not_null(__func__, #pointer, pointer))

namespace cd {

inline cd_status not_null(const char* function, const char* name, const void* pointer) {
    return pointer ? CD_OK : fail(CD_ERROR_NULL, function, "%s is null", name);
}

// part: what this call asks for and the build leaves out, "bend is" or the like; null: nothing.
inline cd_status is_built(const char* function, const char* part) {
    return part ? fail(CD_ERROR_UNSUPPORTED, function, "%s left out of this build", part) : CD_OK;
}

constexpr const char *kOrZero = " or 0", *kOrBothZero = " or both 0", *kOrInfinity = " or INFINITY";

// also: what else the caller takes.
inline cd_status in_range(const char* function, const char* name, double value, double least, double most,
                          const char* also = "") {
    if (value >= least && value <= most) return CD_OK;
    return fail(CD_ERROR_VALUE, function, "%s is %g, must be in [%g, %g]%s", name, value, least, most, also);
}

inline cd_status is_enum(const char* function, const char* name, int32_t value, int32_t last) {
    if (value >= 0 && value <= last) return CD_OK;
    return fail(CD_ERROR_ENUM, function, "%s is %d, must be 0 to %d", name, int(value), int(last));
}

inline cd_status is_count(const char* function, const char* name, size_t value, size_t expected) {
    if (value == expected) return CD_OK;
    return fail(CD_ERROR_RANGE, function, "%s is %zu, must be %zu", name, value, expected);
}

inline cd_status is_index(const char* function, const char* name, size_t value, size_t count) {
    if (value < count) return CD_OK;
    return fail(CD_ERROR_RANGE, function, "%s is %zu, must be less than %zu", name, value, count);
}

// Of things that there are none of before a call of set.
inline cd_status is_index(const char* function, size_t value, size_t count, const char* things, const char* set) {
    if (count > 0) return is_index(function, "index", value, count);
    fail(CD_ERROR_RANGE, function, "index is %zu, but there are no %s yet: call %s first", value, things, set);
    return CD_ERROR_RANGE; // see must_have_length
}

// [first, first + n) inside [0, count)
inline bool lies_within(size_t first, size_t n, size_t count) { return first <= count && n <= count - first; }
// from and many: the names of the arguments; things: what there are `count` of.
inline cd_status is_part(const char* function, const char* from, size_t first, const char* many, size_t n, size_t count,
                         const char* things) {
    if (lies_within(first, n, count)) return CD_OK;
    return fail(CD_ERROR_RANGE, function, "%s is %zu and %s is %zu, must add up to at most %zu, the number of %s", from,
                first, many, n, count, things);
}

// Each of `count` numbers at most `most` in size.
inline cd_status are_numbers(const char* function, const char* name, const double* values, size_t count, double most) {
    for (size_t i = 0; i < count; ++i)
        if (!(fabs(values[i]) <= most))
            return fail(CD_ERROR_VALUE, function, "%s[%zu] is %g, must be finite and at most %g in size", name, i,
                        values[i], most);
    return CD_OK;
}

} // namespace cd
