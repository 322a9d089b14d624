// The stability atlas: what becomes of a scene's energy over two parameters, beside what theory says.
#ifndef REPORT_ATLAS_HPP
#define REPORT_ATLAS_HPP

#include <functional>
#include <string>
#include <vector>

#include "fate_map.hpp"
#include "report.hpp"
#include "vibrations.hpp"

namespace report {

// Growing: 1000 times the energy of the start, or more. Damped: a tenth of it in the end, or less.
Fate fate_of(const Course& course);

// What theory says: a course, and the fates it leaves open where its numbers are within rounding of a limit.
class Expected {
public:
    Expected(const Course& course, cd_precision precision);
    explicit Expected(std::vector<Fate> open) : open_(std::move(open)) {} // no numbers, but what must not happen

    Fate likeliest() const { return open_.front(); }
    bool allows(Fate fate) const;
    void allow(Fate fate) { open_.push_back(fate); }

private:
    std::vector<Fate> open_;
};

struct AtlasAxis {
    std::string key, label; // in the CSV; on the map
    std::vector<double> values;
};

// From 10^first to 10^last.
std::vector<double> decades(double first, double last, double step);

struct AtlasCase {
    std::string object, sweep; // "chain", "stiffness"
    Method how;
    cd_precision precision;
    AtlasAxis x, y;
    std::function<Course(double, double)> practice;
    std::function<Expected(double, double)> theory;
    std::function<std::string(double, double)> finding = {}; // why a cell is known to differ; empty: it must not
    bool judged = true; // false: how the textbook differs is no fault of the library's
};

class Atlas {
public:
    Atlas(Report& report, std::string object) : report_(report), object_(std::move(object)) {}

    // Runs every cell; returns the map.
    std::string add(const AtlasCase& chart);

    // "all 18 000 cells are as theory has them, in both precisions", of those so far.
    std::string agreement() const;

    // A table of the cells that differ, and what is saved.
    void finish();

private:
    Report& report_;
    std::string object_;
    Csv csv_{"object,sweep,method,precision,judged,x,y,practice,theory,agrees,finding,highest_log10,last_log10"};
    Table table_{{"sweep", "method", "precision", "cells", "differ", "where", "why"}, {}, {1, 2, 5, 6}, true};
    std::size_t cells_ = 0, differ_ = 0, known_ = 0;
};

} // namespace report

#endif
