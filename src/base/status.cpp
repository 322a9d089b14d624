#include "base/status.hh"

#include <stdarg.h>

namespace cd {

static thread_local char message[256];

cd_status fail(cd_status status, const char* function, const char* format, ...) {
    const int used = snprintf(message, sizeof message, "%s: ", function);
    va_list arguments;
    va_start(arguments, format);
    if (used >= 0 && used < int(sizeof message))
        vsnprintf(message + used, sizeof message - size_t(used), format, arguments);
    va_end(arguments);
    return status;
}

const char* last_message() { return message; }

} // namespace cd
