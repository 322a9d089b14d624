// The water's sections of the report.
#ifndef REPORT_WATER_PARTS_HPP
#define REPORT_WATER_PARTS_HPP

#include "report.hpp"
#include "water_runner.hpp"

namespace report {

class Atlas;

void report_water_precision(Report& report);
void report_water_thacker(Report& report);
void report_water_dam(Report& report);
void report_water_growth(Report& report);
void report_water_atlas(Report& report);
void report_water_survival(Report& report);
void report_water_cost(Report& report);
void report_water_volume(Report& report);
void report_water_scenes(Report& report);

// Streams, on a page of the atlas; violent shores.
void add_streams(Report& report, Atlas& atlas);
void report_shores(Report& report);

// A picture of the tide around an island, for the scenes.
void draw_island(Report& report);

// The side's values for cells along x, from their centres.
template <class Function> std::vector<double> along_x(std::size_t n, double dx, Function&& f) {
    std::vector<double> values;
    for (std::size_t i = 0; i < n; ++i) values.push_back(f((double(i) + 0.5) * dx));
    return values;
}

// f(x, y) at the centres of all cells.
template <class Function> std::vector<double> over_cells(std::size_t nx, std::size_t ny, double d, Function&& f) {
    std::vector<double> values;
    for (std::size_t j = 0; j < ny; ++j)
        for (std::size_t i = 0; i < nx; ++i) values.push_back(f((double(i) + 0.5) * d, (double(j) + 0.5) * d));
    return values;
}

} // namespace report

#endif
