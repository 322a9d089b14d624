#include "chain_parts.hpp"

#include <cmath>

namespace report {

std::vector<double> gaussian_bump(std::size_t springs) {
    std::vector<double> x(springs + 1);
    for (std::size_t i = 1; i < springs; ++i) {
        double s = (double(i) / double(springs) - 0.4) / 0.05;
        x[i] = std::exp(-0.5 * s * s);
    }
    return x;
}

void report_chain(Report& report) {
    report_chain_precision(report);
    report_chain_stiff(report);
#ifdef REPORT_ROPES
    report_chain_swing(report);
#endif
    report_chain_growth(report);
    report_chain_figure2(report);
    report_chain_atlas(report);
    report_chain_survival(report);
    report_chain_extremes(report);
    report_chain_cost(report);
    report_chain_scenes(report);
}

}  // namespace report
