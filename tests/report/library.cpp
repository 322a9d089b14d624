// How large the library file is with each part left out: the target library_sizes builds it so and writes a table.
#include <cmath>
#include <fstream>

#include "format.hpp"
#include "report.hpp"

namespace report {

void report_library(Report& report) {
    report.page.section("library-size", "Library: the size of its file without each part");
    std::ifstream file(report.sizes);
    std::string line;
    Table table{{"libcontdyn.so, stripped", "bytes", "of everything"}, {}, {}};
    Csv csv("variant,bytes");
    double all = 0, least = INFINITY;
    std::string least_name;
    std::getline(file, line);
    while (std::getline(file, line)) {
        const std::size_t comma = line.rfind(',');
        if (comma == std::string::npos) continue;
        const std::string name = line.substr(0, comma);
        const double bytes = std::strtod(line.c_str() + comma + 1, nullptr);
        if (all == 0) all = bytes;
        if (bytes < least) least = bytes, least_name = name;
        table.rows.push_back({name, count(bytes), percent(bytes / all, 3)});
        csv.row(name, bytes);
        std::string key = name;
        for (char& c : key)
            if (c == ' ') c = '_';
        report.summary("library.bytes." + key, bytes, "bytes");
    }
    if (table.rows.empty()) {
        report.page.paragraph(
            "The sizes were not measured: it takes some minutes and is a target of its own. cmake "
            "--build build --target library_sizes builds the library with each part left out; a "
            "report made afterwards has its table here.");
        return;
    }
    report.page.table(table, "All of the library is " + si(all, "B", 3) + ", " + least_name + " " + si(least, "B", 3) +
                                 ". Each row is a build of its own with CMake options switched off, release, by the "
                                 "compiler of the library. Kernels for wider vectors stand beside the plain ones, and "
                                 "are the larger part.");
    report.save("library_size.csv", csv);
}

} // namespace report
