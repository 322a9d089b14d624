#include "report.hpp"

#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "format.hpp"
#include "timing.hpp"

namespace report {

void Report::save(const std::string& name, const Csv& csv) {
    save_text(name, csv.text());
    page.file(name);
}

void Report::save_text(const std::string& name, const std::string& text) const {
    std::string path = folder_ + "/" + name;
    std::FILE* file = std::fopen(path.c_str(), "wb");
    bool written = file && std::fwrite(text.data(), 1, text.size(), file) == text.size();
    if (file && std::fclose(file) != 0) written = false;
    if (written) return;
    std::fprintf(stderr, "contdyn_report: cannot write %s\n", path.c_str());
    std::exit(1);
}

void Report::summary(const std::string& key, double value, const std::string& unit) {
    figures_[key] = value;
    char text[64];
    const bool whole = value == std::floor(value) && std::fabs(value) < 1e9;
    std::snprintf(text, sizeof text, whole ? "%.0f" : "%.4g", value);
    summary(key, text + (unit.empty() ? "" : " " + unit));
}

void Report::summary(const std::string& key, const std::string& value) { summary_.push_back(key + ": " + value); }

double Report::figure(const std::string& key) const {
    auto found = figures_.find(key);
    return found == figures_.end() ? NAN : found->second;
}

void Report::progress(const std::string& what) const {
    static const double kStart = now();
    std::fprintf(stderr, "[%5.1f s] %s\n", now() - kStart, what.c_str());
}

}  // namespace report
