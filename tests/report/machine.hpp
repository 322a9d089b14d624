// What numbers were measured on.
#ifndef REPORT_MACHINE_HPP
#define REPORT_MACHINE_HPP

#include <fstream>
#include <string>

namespace report {

inline std::string processor() {
    std::ifstream info("/proc/cpuinfo");
    for (std::string line; std::getline(info, line);)
        if (line.rfind("model name", 0) == 0) return line.substr(line.find(':') + 2);
    return "unknown processor";
}

#if defined(__clang__)
const char* const kCompiler = "Clang " __VERSION__;
#else
const char* const kCompiler = "GCC " __VERSION__;
#endif

} // namespace report

#endif
