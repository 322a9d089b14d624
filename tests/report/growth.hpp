// How the cost of one simulated second grows with the size of a lattice.
#ifndef REPORT_GROWTH_HPP
#define REPORT_GROWTH_HPP

#include <functional>
#include <string>
#include <vector>

#include "report.hpp"
#include "runner.hpp"

namespace report {

const double kGrowthTolerance = 0.01;

// The same motion on a lattice of one size, over `time`.
struct Sized {
    std::size_t size, nodes;
    MakeRunner make;
    std::vector<double> exact;                                         // positions in the end
    std::size_t limit;                                                 // the fewest stable explicit steps
    std::function<double(const Method&, std::size_t)> expected_error;  // with so many steps, in exact arithmetic
    std::function<std::size_t(const Method&)> affordable;              // the most steps that may be timed
    double time = 1;  // simulated [s]
};

struct Cost {
    std::size_t size, nodes, steps, timed_steps, iterations;
    double seconds, error, spread;  // error NaN where only a part of the second was run
    bool whole() const { return timed_steps == steps; }
    double per_node_step() const { return seconds / double(steps) / double(nodes); }
};

struct Growth {
    const Method* how;
    cd_precision precision;
    std::vector<Cost> costs;

    std::string name() const { return how->name + ", " + name_of(precision); }
    std::string key() const { return how->key + "." + name_of(precision); }
    double exponent() const;                          // of seconds ~ size^p, by least squares over the logarithms
    double per_node_step_at(std::size_t size) const;  // NaN if there was no such size
};

const Growth& find(const std::vector<Growth>& growths, Way way);  // in the widest precision

// Adds a cost to each: explicit steps as long as they are stable, others as long as the error stays within 1%. What
// takes more steps than are affordable is timed without its first one and scaled up.
void measure_size(Report& report, const Sized& sized, std::vector<Growth>& growths);

// "symplectic Euler is cheaper up to ..., from ... on λ = 1/2 ...": which of the two pays where.
std::string crossing(const Growth& explicit_steps, const Growth& implicit);

struct GrowthNames {
    std::string key, size, label;  // "chain.growth"; in the CSV's head; of the axis
    std::size_t explicit_power;    // expected; of implicit steps it is one less
    std::vector<std::size_t> at;   // sizes whose time per node and step is told
    std::string node = "node", span = "second";
};

struct GrowthView {
    std::vector<std::string> panels;
    std::vector<Series> series;
    Csv csv;
    Table table;
    bool scaled;  // some runs were
};

// Also puts exponents and times per node and step into the summary.
GrowthView view(Report& report, const std::vector<Growth>& growths, const GrowthNames& names);

}  // namespace report

#endif
