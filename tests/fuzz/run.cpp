#include "run.hpp"

#include <stdarg.h>
#include <stdio.h>
#include <sys/time.h>
#include <unistd.h>

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

// Of a call and what is checked after it, which take milliseconds. 16 steps of 127 ropes that come to no answer, made
// twice under sanitizers, have taken a minute: what ends is over long before.
constexpr int kMostProcessorSeconds = 240, kMostSeconds = 1800;

static void limit_time() {
    itimerval limit = {};
    limit.it_value.tv_sec = kMostProcessorSeconds;
    setitimer(ITIMER_PROF, &limit, nullptr);
    alarm(kMostSeconds); // what waits for ever takes no processor's time
}

void trace(const std::string& call) {
    if (!run.tracing) limit_time();
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
