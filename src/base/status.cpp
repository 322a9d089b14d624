#include "base/status.hh"

#include <stdarg.h>
#include <string.h>

namespace cd {

constexpr size_t kRoom = 400; // bytes: every message of ours fits, with numbers of 20 digits
static thread_local char message[kRoom];

cd_status fail(cd_status status, const char* function, const char* format, ...) {
    const int used = snprintf(message, kRoom, "%.100s: ", function);
    va_list arguments;
    va_start(arguments, format);
    const int wanted = vsnprintf(message + used, kRoom - size_t(used), format, arguments);
    va_end(arguments);
    if (used + wanted >= int(kRoom)) memcpy(message + kRoom - 4, "...", 4); // cut short
    return status;
}

const char* last_message() { return message; }

} // namespace cd
