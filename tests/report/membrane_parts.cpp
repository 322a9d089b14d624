#include "membrane_parts.hpp"

namespace report {

void report_membrane(Report& report) {
    report_membrane_precision(report);
    report_membrane_stiff(report);
    report_membrane_sluggish(report);
#ifdef REPORT_CLOTH
    report_cloth_drop(report);
#endif
    report_membrane_atlas(report);
    report_membrane_survival(report);
    report_membrane_growth(report);
    report_membrane_cost(report);
    report_membrane_features(report);
    report_membrane_iterations(report);
    report_membrane_scenes(report);
}

}  // namespace report
