// The extremes sheet: scenes at the ends of what can be asked for, beside an ordinary one of the same kind.
#ifndef REPORT_SURVIVAL_HPP
#define REPORT_SURVIVAL_HPP

#include <functional>
#include <string>
#include <vector>

#include "report.hpp"
#include "runner.hpp"

namespace report {

struct Trial {
    std::string extreme, how;
    cd_precision precision;
    std::string outcome = "survives"; // or what the library said
    double error = NAN;               // the worst, relative; NaN where no exact answer is known
    double drift = NAN;               // of what must be kept, relative to it
    std::uint64_t hash = 0;
    double node_steps = 0;            // of one call of `again`
    std::function<void()> again = {}; // goes on stepping; empty: not timed
    double nanoseconds = NAN;         // a node and step, by finish

    bool survives() const { return outcome == "survives"; }
};

class SurvivalSheet {
public:
    SurvivalSheet(Report& report, std::string object, std::string kept)
        : report_(report), object_(std::move(object)), kept_(std::move(kept)) {}

    // Others are timed against the first trial of their precision and method, which is the ordinary scene; or, without
    // one, of their precision.
    void add(Trial trial) { trials_.push_back(std::move(trial)); }

    // Times all in turns; writes the table and the CSV. `error_is` and `more` tell what the columns are of.
    void finish(const std::string& error_is, const std::string& more);

private:
    Report& report_;
    std::string object_, kept_;
    std::vector<Trial> trials_;
};

// "survives", or the status's name.
std::string outcome_of(cd_status status);

} // namespace report

#endif
