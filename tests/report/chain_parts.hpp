// The chain's sections of the report, one file each, and what several of them start from.
#ifndef REPORT_CHAIN_PARTS_HPP
#define REPORT_CHAIN_PARTS_HPP

#include <vector>

#include "chain_runner.hpp"
#include "report.hpp"

namespace report {

void report_chain_precision(Report& report);
void report_chain_stiff(Report& report);
void report_chain_swing(Report& report);
void report_chain_growth(Report& report);
void report_chain_figure2(Report& report);
void report_chain_extremes(Report& report);
void report_chain_atlas(Report& report);
void report_chain_survival(Report& report);
void report_chain_cost(Report& report);
void report_chain_scenes(Report& report);

// A bump of height 1 and standard deviation 1/20 at two fifths of the chain; exactly 0 at both ends.
std::vector<double> gaussian_bump(std::size_t springs);

}  // namespace report

#endif
