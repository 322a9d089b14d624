// The membrane's sections of the report, one file each.
#ifndef REPORT_MEMBRANE_PARTS_HPP
#define REPORT_MEMBRANE_PARTS_HPP

#include "membrane_runner.hpp"
#include "report.hpp"

namespace report {

void report_membrane_precision(Report& report);
void report_membrane_stiff(Report& report);
void report_membrane_sluggish(Report& report);
void report_cloth_drop(Report& report);
void report_membrane_growth(Report& report);
void report_membrane_atlas(Report& report);
void report_membrane_survival(Report& report);
void report_membrane_cost(Report& report);
void report_membrane_features(Report& report);
void report_membrane_iterations(Report& report);
void report_membrane_scenes(Report& report);

}  // namespace report

#endif
