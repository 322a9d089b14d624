#include "features.hpp"

#include <cmath>

#include "format.hpp"
#include "timing.hpp"

namespace report {

void report_features(Report& report, const std::string& object, const std::vector<FeatureCost>& features,
                     const std::string& caption) {
    std::vector<Job> jobs;
    for (const FeatureCost& feature : features) jobs.push_back({[] {}, feature.step});
    time_in_turns(jobs, report.by_extent(1e-3, 0.05), report.by_extent<std::size_t>(1, 5), 31);
    Table table{{"feature", "ns per node and step", "of the plain", "bytes a node", "more than the plain"}, {}, {}};
    Csv csv("feature,ns_per_node_step,over_plain,bytes_per_node");
    auto nanoseconds = [&](std::size_t i) { return jobs[i].least() / features[i].node_steps * 1e9; };
    for (std::size_t i = 0; i < features.size(); ++i) {
        const FeatureCost& feature = features[i];
        const double more = feature.bytes - features[0].bytes;
        table.rows.push_back({feature.name, number(nanoseconds(i), 3) + spread_words(jobs[i].spread()),
                              number(nanoseconds(i) / nanoseconds(0), 2) + "×",
                              number(feature.bytes, 3),
                              i == 0 ? "" : (more < 0 ? "−" : "+") + number(std::fabs(more), 3)});
        csv.row(feature.key, nanoseconds(i), nanoseconds(i) / nanoseconds(0), feature.bytes);
        report.summary(object + ".feature.ns_per_node_step." + feature.key, nanoseconds(i), "ns");
        report.summary(object + ".feature.bytes_per_node." + feature.key, feature.bytes, "bytes");
    }
    report.page.table(table, "A node of the plain " + object + " takes " + number(features[0].bytes, 3) +
                                 " bytes and " + number(nanoseconds(0), 2) +
                                 " ns a step, and a feature costs only where it is switched on. " + caption +
                                 " Memory is all that the object holds. All in one process, in turns.");
    report.save(object + "_features.csv", csv);
    report.progress(object + ": what features cost");
}

} // namespace report
