// What a feature costs: a node's bytes and nanoseconds with each switched on, beside none.
#ifndef REPORT_FEATURES_HPP
#define REPORT_FEATURES_HPP

#include <functional>
#include <string>
#include <vector>

#include "report.hpp"

namespace report {

struct FeatureCost {
    std::string key, name;
    std::function<void()> step; // some steps
    double node_steps;          // in them
    double bytes;               // that a node takes, of all that the object holds
};

// The first is the plain scene that others are compared with. Times all in turns; `caption` follows the finding.
void report_features(Report& report, const std::string& object, const std::vector<FeatureCost>& features,
                     const std::string& caption);

} // namespace report

#endif
