// Status of the last failed call on this thread: api/ fails through here, every layer may.
#pragma once

#include "contdyn/base.h"

namespace cd {

// Writes "function: message" to the thread's error message and returns status.
cd_status fail(cd_status status, const char* function, const char* format, ...) __attribute__((format(printf, 3, 4)));

const char* last_message();

} // namespace cd
