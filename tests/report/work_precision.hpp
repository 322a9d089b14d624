// Error against run time for one problem: run every method with every step size, time them in turns, find the
// cheapest way to each error.
#ifndef REPORT_WORK_PRECISION_HPP
#define REPORT_WORK_PRECISION_HPP

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "modes.hpp"
#include "report.hpp"
#include "runner.hpp"

namespace report {

struct Point {
    std::size_t steps;
    double error = 0, least_seconds = 0, median_seconds = 0, quartile_seconds = 0, spread = 0;
    std::uint64_t hash = 0;
};

struct Curve {
    const Method* how;
    cd_precision precision;
    std::vector<Point> points;  // by steps, ascending

    std::string name() const { return how->name + ", " + name_of(precision); }
};

// 10% to 0.01%.
const std::vector<double>& tolerances();

struct Study {
    std::string key;            // in the CSV and the summary
    std::string title;          // over the plot
    MakeRunner make;            // of the problem
    double time;                // simulated [s]
    std::vector<double> exact;  // positions then
    std::vector<Curve> curves;  // points with their steps; the rest is filled by measure
    double (*error)(const std::vector<double>&, const std::vector<double>&) = relative_error;  // of positions, exact
    std::string error_label = "relative error, greatest over the nodes";
    std::vector<double> tolerances = report::tolerances();
};


// Step numbers from `least` to `most`, doubling, and the fewest that `expected_error` needs for each tolerance,
// down to the least that is asked for.
std::vector<Point> points_between(std::size_t least, std::size_t most,
                                  const std::function<double(std::size_t)>& expected_error,
                                  double least_tolerance = 0);

void measure(Report& report, Study& study);

// The point of so many steps, in the widest precision; null if there is none.
const Point* find_point(const Study& study, Way way, std::size_t steps);

struct Best {
    const Curve* curve = nullptr;
    const Point* point = nullptr;
    explicit operator bool() const { return point != nullptr; }
    double seconds() const;       // NaN if there is none
    std::string text() const;     // "12 µs (+2%): λ = 1/2, float32, 60 steps" or "not reached"
};

enum class Kind { explicit_steps, implicit_steps, textbook };

// A run counts if all with shorter steps are about as good.
Best cheapest(const Study& study, double tolerance, Kind kind);

// "implicit, 3.1x cheaper": which of the two pays, and how much.
std::string verdict(const Best& implicit, const Best& explicit_steps);

// The same of the library's better one and the textbook.
std::string against_textbook(const Best& implicit, const Best& explicit_steps, const Best& textbook);

// The plot of a study; its series are appended to `for_legend`.
std::string draw(const Study& study, const std::string& time_label, std::vector<Series>& for_legend);

// Collects the rows of several studies, for the page and for the CSV files.
struct WorkTables {
    Csv points{"case,method,precision,textbook,steps,dt_s,error,seconds_min,seconds_median,seconds_upper_quartile,"
               "hash"};
    Csv cheapest{"case,tolerance,implicit,implicit_steps,implicit_seconds,explicit,explicit_steps,explicit_seconds,"
                 "textbook,textbook_steps,textbook_seconds"};
    Table table{
        {"case", "error", "best implicit", "best explicit", "of the two", "best textbook", "of library and textbook"},
        {},
        {1, 2, 3, 4, 5, 6}};

    // Also puts the ratios into the summary.
    void add(Report& report, const Study& study, const std::string& case_name);
};

}  // namespace report

#endif
