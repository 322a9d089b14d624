#include "run.hpp"

#include <stdarg.h>
#include <stdio.h>

namespace fuzz {

Totals* totals;
Run run;
static std::string traced;

static std::string formatted(const char* format, va_list arguments) {
    char line[600];
    vsnprintf(line, sizeof line, format, arguments);
    return line;
}

std::string text(const char* format, ...) {
    va_list arguments;
    va_start(arguments, format);
    const std::string line = formatted(format, arguments);
    va_end(arguments);
    return line;
}

void trace_detail(const std::string& detail) {
    if (run.tracing) printf("%s\n", detail.c_str()), fflush(stdout);
}

void trace(const std::string& call) {
    trace_detail(call);
    traced += call + "; ";
    if (traced.size() > 3000) traced.erase(0, traced.size() - 1500);
}

void forget_trace() { traced.clear(); }

void problem(const char* format, ...) {
    va_list arguments;
    va_start(arguments, format);
    const std::string line = formatted(format, arguments);
    va_end(arguments);
    if (totals->problems++ == 0) {
        unsigned sum = 0;
        for (const char* f = format; *f; ++f) sum = sum * 31 + static_cast<unsigned char>(*f);
        run.first_kind = 10 + int(sum % 200);
    }
    const size_t shown = traced.size() < 500 ? traced.size() : 500;
    printf("PROBLEM seed %llu sequence %llu: %s || last calls: %s\n", static_cast<unsigned long long>(run.seed),
           static_cast<unsigned long long>(run.sequence), line.c_str(), traced.c_str() + traced.size() - shown);
    fflush(stdout);
    run.broken = true;
}

} // namespace fuzz
