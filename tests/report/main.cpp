// contdyn_report: runs the library beside exact answers and a textbook, and writes what it finds as one HTML page, CSV
// files and a summary on stdout.
#include <contdyn/contdyn.h>

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <string>
#include <vector>

#include "format.hpp"
#include "machine.hpp"
#include "report.hpp"
#include "timing.hpp"

namespace {

const char* const kUsage =
    "usage: contdyn_report [--out DIR] [--only PART[,PART...]] [--full] [--csv] [--sizes FILE]\n"
    "  --out DIR     where to write index.html and the CSV files; default: report\n"
    "  --only PARTS  of: chain,membrane,water,notes,library\n"
    "  --full        all, in some ten minutes; default: a coarse sample of it, in one\n"
    "  --csv         no page\n"
    "  --sizes FILE  what the target library_sizes wrote; default: library_sizes.csv\n";

struct Part {
    const char* name;
    void (*run)(report::Report&);
};
const std::vector<Part> kParts = {
#ifdef REPORT_CHAIN
    {"chain", report::report_chain},
#endif
#ifdef REPORT_MEMBRANE
    {"membrane", report::report_membrane},
#endif
#ifdef REPORT_WATER
    {"water", report::report_water},
#endif
#ifdef REPORT_NOTES
    {"notes", report::report_notes},
#endif
    {"library", report::report_library},
};

struct Options {
    std::string folder = "report", sizes = "library_sizes.csv";
    std::vector<std::string> only;
    report::Extent extent = report::Extent::sample;
    bool page = true;
};

bool is_part(const std::string& name) {
    for (const Part& part : kParts)
        if (name == part.name) return true;
    return false;
}

bool split_parts(const std::string& list, std::vector<std::string>& parts) {
    for (std::size_t from = 0; from <= list.size();) {
        std::size_t comma = std::min(list.find(',', from), list.size());
        parts.push_back(list.substr(from, comma - from));
        if (!is_part(parts.back())) return false;
        from = comma + 1;
    }
    return true;
}

bool parse(int argc, char** argv, Options& options) {
    for (int i = 1; i < argc; ++i) {
        std::string argument = argv[i];
        bool more = i + 1 < argc;
        if (argument == "--out" && more) options.folder = argv[++i];
        else if (argument == "--sizes" && more) options.sizes = argv[++i];
        else if (argument == "--only" && more) {
            if (!split_parts(argv[++i], options.only)) return false;
        } else if (argument == "--full") options.extent = report::Extent::full;
        else if (argument == "--csv") options.page = false;
        else return false;
    }
    return true;
}

std::string today() {
    std::time_t seconds = std::time(nullptr);
    char text[32];
    std::strftime(text, sizeof text, "%Y-%m-%d", std::gmtime(&seconds));
    return text;
}

std::string spread_fact() {
    std::vector<double> all = report::spreads();
    if (all.empty()) return "Times are the least of several rounds; here each had too few to tell how they spread.";
    std::sort(all.begin(), all.end());
    auto at = [&](double share) { return report::percent(all[std::size_t(share * double(all.size() - 1))]); };
    return "Times are the least of several rounds in which all candidates take turns. A quarter of a timing's rounds "
           "took longer than that by " + at(0.5) + " and more (the middle one of " + report::count(double(all.size())) +
           " timings; by " + at(0.9) + " in the worst tenth). \"(+3%)\" behind a time tells it of that one.";
}

}  // namespace

int main(int argc, char** argv) {
    Options options;
    if (!parse(argc, argv, options)) {
        std::fputs(kUsage, stderr);
        return 2;
    }
    std::error_code error;
    std::filesystem::create_directories(options.folder, error);
    if (error) {
        std::fprintf(stderr, "contdyn_report: cannot make %s: %s\n", options.folder.c_str(), error.message().c_str());
        return 1;
    }

    report::Report report(options.extent, options.folder, options.sizes);
    double start = report::now();
    for (const Part& part : kParts) {
        bool wanted = options.only.empty();
        for (const std::string& name : options.only) wanted = wanted || name == part.name;
        if (wanted) part.run(report);
    }
    if (options.extent == report::Extent::full) report.summary("report.full", 1);
    report.save_text("outcomes.csv", report.outcomes().text());

    std::string summary;
    for (const std::string& line : report.summary_lines()) summary += line + "\n";
    report.save_text("summary.txt", summary);
    std::fputs(summary.c_str(), stdout);
    if (options.page) {
        std::vector<std::string> facts = {
            "Processor: " + report::processor() + ", one core used. Date: " + today() + ".",
            spread_fact(),
            "The textbook on this page: Michael Kass, An Introduction to Continuum Dynamics for Computer Graphics "
            "(1997), written as plain loops with the elimination of Numerical Recipes.",
            std::string("Library: ") + cd_build_info() + ".",
            std::string("This program and the textbook in it: ") + report::kCompiler + ", " + REPORT_FLAGS + ".",
            std::string(options.extent == report::Extent::full
                            ? "This is the whole report."
                            : "This page is a sample: its sweeps are coarse, its problems smaller, and timings are of "
                              "few rounds. What contdyn_report --full makes in some ten minutes has finer sweeps, and "
                              "sheets and water of up to 1024 × 1024."),
            "Run time of this report: " + report::number(report::now() - start, 2) + " s. Main figures: summary.txt; "
            "hashes of every final state, equal in every run: outcomes.csv."};
        const std::string html = report.page.html(
            "contdyn " + std::string(cd_version_string()) + ": how exact, how stable, how fast",
            "contdyn simulates ropes, cloth, drums and shallow water; this page measures how large its errors are for "
            "the run time spent, which stiffness, masses and step lengths it withstands, and what a scene that does "
            "not use a feature need not pay for.", facts);
        report.save_text("index.html", html);
        std::filesystem::path page = std::filesystem::absolute(std::filesystem::path(options.folder) / "index.html");
        std::printf("report: %s\n", page.lexically_normal().c_str());
        if (html.size() > report::kPageBudget) {
            std::fprintf(stderr, "contdyn_report: the page takes %zu bytes, more than %zu\n", html.size(),
                         report::kPageBudget);
            return 1;
        }
    }
    return 0;
}
