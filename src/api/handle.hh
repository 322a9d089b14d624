// From an opaque handle to the object behind it.
#pragma once

#include <string.h>

#include "api/check.hh"

namespace cd {

// What is behind a handle: Behind<cd_chain> has the type Object, its tag, and its name for messages.
template <class Handle> struct Behind;

template <class Handle>
cd_status is_living(const char* function, const Handle* handle, const char* name = Behind<Handle>::name) {
    CD_CHECK(not_null(function, name, handle));
    uint64_t tag;
    memcpy(&tag, handle, sizeof tag);
    if (tag == Behind<Handle>::tag) return CD_OK;
    return fail(CD_ERROR_HANDLE, function, "%s, %p, is no living %s", name, (const void*)handle, Behind<Handle>::name);
}

template <class Handle> auto& behind(Handle* handle) {
    return *reinterpret_cast<typename Behind<Handle>::Object*>(handle);
}
template <class Handle> const auto& behind(const Handle* handle) {
    return *reinterpret_cast<const typename Behind<Handle>::Object*>(handle);
}

} // namespace cd

// Checks a handle and declares `name`, the object behind it.
#define CD_OPEN(handle, name)                    \
    CD_CHECK(::cd::is_living(__func__, handle)); \
    auto& name = ::cd::behind(handle)
