// Status of the last failed call on this thread: api/ fails through here, every layer may.
#pragma once

#include <stdio.h>

#include "contdyn/base.h"

// Formats are C's, which on Windows is not what the compiler takes for granted.
#ifdef __MINGW_PRINTF_FORMAT
#define CD_PRINTF __MINGW_PRINTF_FORMAT
#else
#define CD_PRINTF printf
#endif

namespace cd {

// Writes "function: message" to the thread's error message and returns status.
cd_status fail(cd_status status, const char* function, const char* format, ...) __attribute__((format(CD_PRINTF, 3, 4)));

const char* last_message();

} // namespace cd
