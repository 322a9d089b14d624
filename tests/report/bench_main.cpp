// contdyn_bench: what a node and step costs beside the textbook and a copy of the state, as CSV on stdout. The subjects
// of a case take turns in one process, a call of the library is one step, and the hash is that of the state after the
// first four steps, none of which is timed.
#include <algorithm>
#include <cstdio>
#include <cstring>

#include "bench.hpp"
#include "csv.hpp"
#include "machine.hpp"
#include "timing.hpp"

namespace {

const char* const kUsage =
    "usage: contdyn_bench [--only WORD[,WORD...]] [--short] [--list]\n"
    "  --only WORDS  cases with one of these in their names\n"
    "  --short       a few rounds of each: to see that it runs\n"
    "  --list        the names of the cases\n";

struct Options {
    std::vector<std::string> only;
    bool brief = false, list = false;
};

bool parse(int argc, char** argv, Options& options) {
    for (int i = 1; i < argc; ++i) {
        const std::string argument = argv[i];
        if (argument == "--short") options.brief = true;
        else if (argument == "--list") options.list = true;
        else if (argument == "--only" && i + 1 < argc) {
            for (char* word = std::strtok(argv[++i], ","); word; word = std::strtok(nullptr, ","))
                options.only.push_back(word);
        } else return false;
    }
    return true;
}

bool is_wanted(const Options& options, const std::string& name) {
    const auto in_name = [&](const std::string& word) { return name.find(word) != std::string::npos; };
    return options.only.empty() || std::any_of(options.only.begin(), options.only.end(), in_name);
}

std::string short_number(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.4g", value);
    return text;
}
// Empty where there is nothing to compare with.
std::string ratio(double above, double below) {
    return above > 0 && below > 0 ? short_number(above / below) : std::string();
}

void run(const report::Case& it, bool brief) {
    using report::Job;
    // A run is long enough for the clock and no longer: with others on the machine, short runs find quiet moments.
    const std::size_t steps = std::max<std::size_t>(1, 100000 / it.nodes);
    std::vector<std::string> hashes;
    std::vector<std::size_t> factorizations;
    std::vector<Job> jobs;
    for (const report::Subject& subject : it.subjects) {
        for (int i = 0; i < 4; ++i) subject.step();
        hashes.push_back(subject.hash ? report::hex(subject.hash()) : "");
        factorizations.push_back(subject.factorizations ? subject.factorizations() : 0);
        jobs.push_back({[] {},
                        [&subject, steps] {
                            for (std::size_t i = 0; i < steps; ++i) subject.step();
                        }});
    }
    report::time_in_turns(jobs, brief ? 1e-3 : 0.25, brief ? 1 : 7, brief ? 3 : 301);
    double textbook = 0, copy = 0;
    const auto least = [&](std::size_t i) { return jobs[i].least() / double(steps) / double(it.nodes) * 1e9; };
    for (std::size_t i = 0; i < jobs.size(); ++i) {
        if (it.subjects[i].name == "textbook") textbook = least(i);
        if (it.subjects[i].name == "copy") copy = least(i);
    }
    for (std::size_t i = 0; i < jobs.size(); ++i) {
        const report::Subject& subject = it.subjects[i];
        const std::string anew =
            subject.factorizations ? std::to_string(subject.factorizations() - factorizations[i]) : "";
        const std::string line = report::Csv::line(
            it.name, subject.name, it.nodes, short_number(least(i)),
            short_number(jobs[i].median() / double(steps) / double(it.nodes) * 1e9),
            short_number(least(i) * double(it.nodes) / double(it.calls)), ratio(textbook, least(i)),
            ratio(least(i), least(0)), ratio(least(i), copy), anew, hashes[i], i == 0 ? it.reach : "");
        std::fputs(line.c_str(), stdout);
    }
    std::fflush(stdout);
}

} // namespace

int main(int argc, char** argv) {
    Options options;
    if (!parse(argc, argv, options)) {
        std::fputs(kUsage, stderr);
        return 2;
    }
    if (!options.list)
        std::printf(
            "# contdyn %s on %s; %s; baselines: %s %s\n"
            "case,subject,nodes,ns_per_node_least,ns_per_node_median,ns_per_call_least,textbook_over_it,"
            "it_over_first,it_over_copy,factorizations,hash,reach\n",
            cd_version_string(), report::processor().c_str(), cd_build_info(), report::kCompiler, REPORT_FLAGS);
    for (const auto& part :
         {report::chain_benches, report::sheet_benches, report::water_benches, report::frame_benches})
        for (const report::Bench& bench : part()) {
            if (!is_wanted(options, bench.name)) continue;
            if (options.list) std::puts(bench.name.c_str());
            else run(bench.make(), options.brief);
        }
    return 0;
}
