#include <cmath>
#include <cstdlib>
#include <functional>
#include <set>

#include "check.hpp"

namespace {

void water_errors_fall_at_their_order() {
    for (const std::string study : {"water.seiche", "water.pool"}) {
        expect_orders("water_work_precision.csv", study, {{"linear_half", 2}, {"advected", 2}, {"explicit", 2}});
        std::map<std::string, std::map<double, double>> errors; // by method and dt
        for (const Row& row : rows_of("water_work_precision.csv"))
            if (row.at("case") == study) errors[row.at("method")][real(row, "dt_s")] = real(row, "error");
        for (const std::string method : {"linear", "linear_one", "textbook"}) {
            expect(errors[method].size() > 3, study + ": " + method + " was hardly run");
            const auto finest = errors[method].begin(), coarser = std::next(finest);
            const double order = std::log(coarser->second / finest->second) / std::log(coarser->first / finest->first);
            expect(order > 0.6 && order < 1.3, study + ": " + method + " is of order " + std::to_string(order));
        }
        // In a slice the notes' two surfaces are lambda = 1.
        for (const auto& [dt, error] : errors["textbook"])
            if (study == "water.seiche" && errors["linear_one"].count(dt))
                expect(std::fabs(errors["linear_one"][dt] / error - 1) < 1e-3, "the textbook is not lambda = 1");
    }
}

// The largest errors that runs may have, by what they are of; all of them must be there.
using Bounds = std::map<std::string, double>;

void expect_within(const std::string& file, Bounds bounds, const std::function<std::string(const Row&)>& key) {
    for (const Row& row : rows_of(file)) {
        const auto bound = bounds.find(key(row));
        if (bound == bounds.end()) continue;
        expect(real(row, "error") < bound->second, bound->first + " errs by " + row.at("error"));
        bounds.erase(bound);
    }
    for (const auto& missing : bounds) expect(false, file + " lacks " + missing.first);
}

void moving_shores_are_followed_at_any_step() {
    const auto key = [](const Row& row) {
        return row.at("method") + " " + row.at("cells") + " at " + row.at("courant");
    };
    expect_within("water_thacker.csv",
                  {{"advected 100 at 0.5", 0.0011},
                   {"advected 100 at 2", 0.0011},
                   {"advected 100 at 8", 0.0018},
                   {"advected 200 at 0.5", 0.00054},
                   {"advected 200 at 2", 0.0004},
                   {"advected 200 at 8", 0.00055},
                   {"advected 400 at 0.5", 0.00013},
                   {"advected 400 at 2", 0.00011},
                   {"advected 400 at 8", 0.00014},
                   {"explicit_advected 100 at 0.5", 0.034},
                   {"explicit_advected 200 at 0.5", 0.012},
                   {"explicit_advected 400 at 0.5", 0.006},
                   {"linear 200 at 0.5", 0.029},
                   {"linear 200 at 2", 0.038},
                   {"linear 200 at 8", 0.039}},
                  key);
    for (const Row& row : rows_of("water_thacker.csv"))
        expect(std::fabs(real(row, "volume_error")) < 1e-13, key(row) + " changes the volume");
}

void dam_breaks_converge() {
    expect_within("water_dam.csv",
                  {{"stoker 200 at 0.5", 0.0054},
                   {"stoker 200 at 2", 0.0071},
                   {"stoker 200 at 8", 0.021},
                   {"stoker 800 at 0.5", 0.0015},
                   {"stoker 800 at 2", 0.0021},
                   {"stoker 800 at 8", 0.0067},
                   {"ritter 200 at 0.5", 0.0095},
                   {"ritter 200 at 2", 0.012},
                   {"ritter 200 at 8", 0.033},
                   {"ritter 800 at 0.5", 0.0021},
                   {"ritter 800 at 2", 0.0026},
                   {"ritter 800 at 8", 0.0097}},
                  [](const Row& row) { return row.at("case") + " " + row.at("cells") + " at " + row.at("courant"); });
    std::map<std::string, std::map<double, Row>> runs;
    for (const Row& row : rows_of("water_dam.csv"))
        runs[row.at("case") + " at " + row.at("courant")][real(row, "cells")] = row;
    expect(runs.size() == 6, "a dam break is missing");
    for (const auto& [name, of] : runs) {
        double coarser = INFINITY;
        for (const auto& [cells, row] : of) {
            expect(real(row, "error") < 0.75 * coarser, name + " does not converge at " + row.at("cells"));
            coarser = real(row, "error");
        }
    }
    for (const auto& [courant, shock_off] : Bounds{{"0.5", 0.01}, {"2", 0.012}, {"8", 0.05}}) {
        const Row& stoker = runs["stoker at " + courant].rbegin()->second;
        const double off = std::fabs(real(stoker, "front_m") / real(stoker, "exact_front_m") - 1);
        expect(off < shock_off, "Courant " + courant + ": the shock is elsewhere");
        const double plateau = real(stoker, "middle_depth_m");
        expect(std::fabs(plateau / 0.00253936 - 1) < 0.002, "Courant " + courant + ": not Stoker's plateau");
        expect(std::fabs(real(stoker, "exact_front_m") / (6 * 0.209963) - 1) < 1e-5, "not Stoker's shock");
    }
}

void the_notes_lake_gains_water_and_ours_does_not() {
    double gained = 0;
    for (const Row& row : rows_of("water_lake.csv")) {
        expect(std::fabs(real(row, "contdyn")) < 1e-13, "the lake changes its volume");
        expect(std::fabs(real(row, "textbook_put_back")) < 1e-9, "what is put back is not what was gained");
        gained = real(row, "textbook");
    }
    expect(gained > 0.03 && gained < 0.3, "the notes' lake gains " + std::to_string(gained));
}

void a_storm_is_accounted_for() {
    std::set<std::string> seen;
    for (const Row& row : rows_of("water_storm.csv")) {
        const std::string what = row.at("method") + ", " + row.at("precision");
        seen.insert(what);
        const double most = row.at("precision") == "float64" ? 1e-12 : 1e-7;
        expect(std::fabs(real(row, "error_over_volume")) < most, what + ": the account is off");
        if (row.at("steps") == "400") expect(real(row, "through_over_volume") > 0.1, what + ": hardly any water moved");
    }
    expect(seen.size() == 6, "a storm is missing");
}

void water_stays_down_at_any_step() {
    bool thrown = false, gained = false;
    int implicit = 0;
    for (const Row& row : rows_of("water_any_step.csv")) {
        const std::string what = row.at("method") + " at " + row.at("courant");
        const double over = real(row, "highest_m") / real(row, "highest_at_first_m");
        if (row.at("method") == "textbook") {
            gained = gained || real(row, "volume_error") > 1;
            continue;
        }
        expect(std::fabs(real(row, "volume_error")) < 1e-12, what + " changes the volume");
        if (row.at("method") == "explicit") {
            thrown = thrown || over > 1.5;
            continue;
        }
        ++implicit;
        expect(over < 1.5, what + " throws water up, " + std::to_string(over) + " times as high");
    }
    expect(implicit == 15, "a way to step is missing");
    expect(thrown && gained, "nothing goes wrong with the others, so that this comparison shows nothing");
}

void random_shores_gain_no_energy() {
    std::set<std::string> seen;
    for (const Row& row : rows_of("water_shores.csv")) {
        if (real(row, "courant") > 1001) continue; // in longer ones water runs across the whole scene
        seen.insert(row.at("method"));
        expect(real(row, "highest_energy_over_first") < 1.001,
               row.at("method") + " at " + row.at("courant") + " gains energy");
    }
    expect(seen.size() == 3, "a method is missing");
}

// What run time is made of: cells times steps, to the power of the side that is claimed.
void implicit_water_takes_as_many_steps_at_any_size() {
    std::map<std::string, std::map<double, double>> work;
    for (const Row& row : rows_of("water_growth.csv"))
        work[row.at("method")][real(row, "side")] = real(row, "steps") * std::pow(real(row, "side"), 2);
    for (const auto& [method, power] : std::map<std::string, double>{
             {"explicit", 3}, {"linear_half", 2}, {"linear", 2}, {"advected", 2}, {"textbook", 2}}) {
        expect(work[method].size() >= 3, method + " is missing");
        const auto first = *work[method].begin(), last = *work[method].rbegin();
        const double exponent = std::log(last.second / first.second) / std::log(last.first / first.first);
        expect(std::fabs(exponent - power) < 0.1, method + " grows with exponent " + std::to_string(exponent));
    }
    for (const Row& row : rows_of("water_growth.csv"))
        if (row.at("error") != "nan")
            expect(real(row, "error") < 0.0103, row.at("method") + " at " + row.at("side") + " errs by more than 1%");
}

void fields_cost_memory_only_when_on() {
    std::map<std::string, double> bytes;
    for (const Row& row : rows_of("water_cost.csv")) bytes[row.at("feature")] = real(row, "bytes_per_cell");
    for (const char* with : {"sources", "pressure", "force", "mask", "advected", "plain.float64"})
        expect(bytes[with] > bytes["plain"], std::string(with) + " costs no memory");
    for (const char* without : {"friction", "open", "beach", "explicit"})
        expect(bytes[without] == bytes["plain"], std::string(without) + " costs memory");
    expect(bytes["plain"] > 0 && bytes["plain"] < 64,
           "a plain cell takes " + std::to_string(bytes["plain"]) + " bytes");
}

} // namespace

Checks water_checks() {
    return {{"water_errors_fall_at_their_order", water_errors_fall_at_their_order},
            {"moving_shores_are_followed_at_any_step", moving_shores_are_followed_at_any_step},
            {"dam_breaks_converge", dam_breaks_converge},
            {"the_notes_lake_gains_water_and_ours_does_not", the_notes_lake_gains_water_and_ours_does_not},
            {"a_storm_is_accounted_for", a_storm_is_accounted_for},
            {"water_stays_down_at_any_step", water_stays_down_at_any_step},
            {"random_shores_gain_no_energy", random_shores_gain_no_energy},
            {"implicit_water_takes_as_many_steps_at_any_size", implicit_water_takes_as_many_steps_at_any_size},
            {"fields_cost_memory_only_when_on", fields_cost_memory_only_when_on}};
}
