#include "water_parts.hpp"

namespace report {

void report_water(Report& report) {
    report_water_precision(report);
    report_water_thacker(report);
    report_water_dam(report);
    report_water_atlas(report);
    report_water_survival(report);
    report_water_growth(report);
    report_water_volume(report);
    report_water_cost(report);
    report_water_scenes(report);
}

} // namespace report
