#include "survival.hpp"

#include <cmath>

#include "format.hpp"
#include "timing.hpp"

namespace report {

std::string outcome_of(cd_status status) { return status == CD_OK ? "survives" : cd_status_name(status); }

void SurvivalSheet::finish(const std::string& error_is, const std::string& more) {
    std::vector<Job> jobs;
    std::vector<Trial*> timed;
    for (Trial& trial : trials_)
        if (trial.again) {
            jobs.push_back({[] {}, trial.again});
            timed.push_back(&trial);
        }
    time_in_turns(jobs, report_.by_extent(1e-3, 0.02), report_.by_extent<std::size_t>(1, 3), 15);
    for (std::size_t i = 0; i < jobs.size(); ++i) timed[i]->nanoseconds = jobs[i].least() / timed[i]->node_steps * 1e9;

    auto ordinary = [&](const Trial& of) {
        const Trial* found = nullptr;
        for (const Trial& trial : trials_)
            if (trial.precision == of.precision && (!found || (trial.how == of.how && found->how != of.how)))
                found = &trial;
        return found->nanoseconds;
    };
    Table table{{"extreme", "steps by", "precision", "outcome", "worst error", kept_ + " off by",
                 "ns per node and step", "of the ordinary"},
                {},
                {1, 2, 3}};
    Csv csv("extreme,method,precision,outcome,error,drift,ns_per_node_step,of_ordinary,hash");
    std::size_t alive = 0;
    double worst_error[2] = {0, 0}, worst_drift[2] = {0, 0}, slowest = 0;
    auto shown = [](double value) -> std::string {
        return std::isnan(value) ? "" : value < 1e-17 ? "0" : number(value, 2);
    };
    for (const Trial& trial : trials_) {
        const double ratio = trial.nanoseconds / ordinary(trial);
        table.rows.push_back({trial.extreme, trial.how, name_of(trial.precision), trial.outcome, shown(trial.error),
                              shown(trial.drift), shown(trial.nanoseconds),
                              std::isnan(ratio) ? "" : number(ratio, 2) + "×"});
        csv.row(trial.extreme, trial.how, name_of(trial.precision), trial.outcome, trial.error, trial.drift,
                trial.nanoseconds, ratio, hex(trial.hash));
        report_.outcome(object_ + ".survival " + trial.extreme + " " + trial.how + " " + name_of(trial.precision),
                        hex(trial.hash));
        alive += trial.survives();
        const bool narrow = trial.precision == CD_FLOAT32;
        worst_error[narrow] = std::fmax(worst_error[narrow], trial.error);
        worst_drift[narrow] = std::fmax(worst_drift[narrow], trial.drift);
        slowest = std::fmax(slowest, ratio);
    }
    std::string found = alive == trials_.size()
                            ? "All " + std::to_string(alive) + " survive"
                            : std::to_string(alive) + " of " + std::to_string(trials_.size()) + " survive";
    for (cd_precision precision : precisions()) {
        const bool narrow = precision == CD_FLOAT32;
        found += std::string(precision == precisions().front() ? ": " : "; ") + "in " + name_of(precision) +
                 " with errors up to " + number(worst_error[narrow], 2) + " and " + kept_ + " off by up to " +
                 number(worst_drift[narrow], 2);
        const std::string key = object_ + ".survival." + name_of(precision);
        report_.summary(key + ".worst_error", worst_error[narrow]);
        report_.summary(key + ".worst_drift", worst_drift[narrow]);
    }
    report_.page.table(table, found + ". " + error_is + " " + more);
    report_.save(object_ + "_survival.csv", csv);
    report_.summary(object_ + ".survival.survive", std::to_string(alive) + " of " + std::to_string(trials_.size()));
    report_.summary(object_ + ".survival.slowest_over_ordinary", slowest, "times");
    report_.progress(object_ + ": extremes");
}

} // namespace report
