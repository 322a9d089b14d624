// What all parts of the report share: options, the page, the CSV files, the summary, progress.
#ifndef REPORT_REPORT_HPP
#define REPORT_REPORT_HPP

#include <map>
#include <string>
#include <vector>

#include "csv.hpp"
#include "page.hpp"

namespace report {

// How much to run: coarse sweeps of smaller problems, or what the figures of the README were taken from.
enum class Extent { sample, full };

class Report {
public:
    Report(Extent extent, std::string folder, std::string sizes)
        : extent(extent), sizes(std::move(sizes)), folder_(std::move(folder)) {}

    const Extent extent;
    const std::string sizes;  // the file that the target library_sizes writes; it need not be there
    Page page;

    template <class Value>
    Value by_extent(Value sample, Value full) const {
        return extent == Extent::sample ? sample : full;
    }

    // Writes a CSV into the folder and lists it in the page's present section.
    void save(const std::string& name, const Csv& csv);
    void save_text(const std::string& name, const std::string& text) const;

    // A main figure, printed at the end as `key: value unit`. Keys are stable: other texts quote them.
    void summary(const std::string& key, double value, const std::string& unit = "");
    void summary(const std::string& key, const std::string& value);
    const std::vector<std::string>& summary_lines() const { return summary_; }
    double figure(const std::string& key) const;  // NaN if it has not been printed

    // The hash of an outcome that must repeat in every run.
    void outcome(const std::string& what, const std::string& hash) { outcomes_.row(what, hash); }
    const Csv& outcomes() const { return outcomes_; }

    // On stderr.
    void progress(const std::string& what) const;

private:
    std::string folder_;
    std::vector<std::string> summary_;
    std::map<std::string, double> figures_;
    Csv outcomes_{"outcome,hash"};
};

// The parts, in the order of the page. A further object adds its own line here and in main.cpp.
void report_chain(Report& report);
void report_membrane(Report& report);
void report_water(Report& report);
void report_notes(Report& report);
void report_library(Report& report);

}  // namespace report

#endif
