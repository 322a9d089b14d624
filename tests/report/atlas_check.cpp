#include <cmath>
#include <set>

#include "check.hpp"

namespace {

// Every cell as theory has it, or for a reason that the page tells; nothing of what was to be run is missing.
void every_cell_of_the_atlas_agrees_with_theory() {
    const std::map<std::string, std::size_t> charts = {{"chain", 22}, {"membrane", 28}, {"water", 28}};
    for (const auto& [object, expected] : charts) {
        std::set<std::string> seen, fates;
        std::map<std::string, std::pair<double, double>> spans[2]; // of each sweep, along x and y
        bool textbook_differs = false;
        for (const Row& row : rows_of(object + "_atlas.csv")) {
            const std::string chart = row.at("sweep") + ", " + row.at("method") + ", " + row.at("precision");
            const std::string where = object + ", " + chart + " at " + row.at("x") + ", " + row.at("y");
            for (int axis = 0; axis < 2; ++axis) {
                const double at = real(row, axis ? "y" : "x");
                auto& span = spans[axis].insert({row.at("sweep"), {at, at}}).first->second;
                span = {std::fmin(span.first, at), std::fmax(span.second, at)};
            }
            if (row.at("judged") == "0") {
                textbook_differs = textbook_differs || row.at("agrees") == "0";
                continue;
            }
            seen.insert(chart);
            fates.insert(row.at("practice"));
            expect(row.at("agrees") == "1" || !row.at("finding").empty(),
                   where + ": " + row.at("practice") + " instead of " + row.at("theory"));
            if (object == "chain") expect(row.at("agrees") == "1", where + " is no finding that is known of chains");
            if (row.at("sweep") == "stream" && real(row, "x") * real(row, "y") < 32) // cells a step
                expect(row.at("agrees") == "1", where + ": a stream grows ripples");
        }
        expect(seen.size() == expected, object + " has " + std::to_string(seen.size()) + " charts");
        expect(fates.size() >= (object == "water" ? 3 : 4),
               object + ": not every fate is met, so that nothing is shown");
        if (object == "chain")
            expect(textbook_differs, "the textbook is as good, so that this comparison shows nothing");
        for (const auto& axis : spans)
            for (const auto& [sweep, span] : axis)
                expect(span.second / span.first >= (sweep == "stream" ? 0.99e6 : 0.99e12),
                       object + ", " + sweep + ": an axis is too short");
    }
}

void extremes_are_survived() {
    for (const std::string object : {"chain", "membrane", "water"}) {
        std::map<std::string, std::size_t> rows; // by precision
        for (const Row& row : rows_of(object + "_survival.csv")) {
            const std::string what =
                object + ", " + row.at("extreme") + ", " + row.at("method") + ", " + row.at("precision");
            const bool narrow = row.at("precision") == "float32";
            ++rows[row.at("precision")];
            expect(row.at("outcome") == "survives", what + ": " + row.at("outcome"));
            // Coupled: so stiff that the last place of a velocity moves a node by a part of its displacement; or one
            // spring so stiff that the residual is its alone, and all others are solved for to what that leaves.
            const bool coupled = row.at("method") == "λ = 1/2 coupled";
            if (coupled && row.at("extreme") == "stiffness over mass 10³⁰") continue;
            if (coupled && row.at("extreme") == "one spring 10¹² times stiffer") {
                expect(real(row, "error") < 1e-2, what + ": error");
                continue;
            }
            if (row.at("error") != "nan") expect(real(row, "error") < (narrow ? 1e-4 : 1e-6), what + ": error");
            if (row.at("drift") != "nan")
                expect(real(row, "drift") < (narrow ? 1e-4 : object == "membrane" ? 1e-6 : 1e-10), what + ": drift");
        }
        expect(rows.size() == 2 && rows["float32"] == rows["float64"] && rows["float32"] >= 15,
               object + ": an extreme is missing");
    }
}

void plucks_and_settling_ropes_come_out_right() {
    expect_orders("chain_work_precision.csv", "chain.settling.n100", {{"symplectic_euler", 1}});
    std::map<std::string, double> least, settled;
    for (const Row& row : rows_of("chain_work_precision.csv"))
        if (row.at("case") == "chain.settling.n100" && row.at("precision") == "float64")
            settled[row.at("method")] = real(row, "error"); // of the shortest step
    for (const char* method : {"implicit_half", "stiff_second", "textbook_half"})
        expect(settled[method] < 1e-5, std::string(method) + " does not settle where it should");
    for (const Row& row : rows_of("chain_work_precision.csv"))
        if (row.at("case") == "chain.pluck.n300" && row.at("precision") == "float64") {
            double& error = least.insert({row.at("method"), INFINITY}).first->second;
            expect(real(row, "error") < 1.1 * error || row.at("method") == "forward_euler",
                   row.at("method") + ": a pluck's error does not fall with the step");
            error = std::fmin(error, real(row, "error"));
        }
    for (const char* method : {"symplectic_euler", "implicit_half", "stiff_second"})
        expect(least[method] < 1e-3, std::string(method) + " does not come near a pluck");
}

void features_cost_memory_only_when_on() {
    const std::map<std::string, std::vector<std::string>> with = {
        {"chain", {"ring", "bend", "mass", "stiffness", "force", "attachment", "components_3", "float64"}},
        {"membrane", {"bend", "mass", "stiffness", "force", "pin", "mask", "coupled", "components_3", "float64"}}};
    for (const auto& [object, features] : with) {
        std::map<std::string, double> bytes;
        for (const Row& row : rows_of(object + "_features.csv")) bytes[row.at("feature")] = real(row, "bytes_per_node");
        for (const std::string& feature : features)
            expect(bytes[feature] > bytes["plain"], object + ": " + feature + " costs no memory");
        for (const char* free : {"gravity", "drag", "stiffness_damping"})
            expect(bytes[free] == bytes["plain"], object + ": " + free + " costs memory");
        expect(bytes["symplectic_euler"] < bytes["plain"],
               object + ": an explicit step needs a factorization's memory");
    }
}

// Exponents are of times, and so not judged.
void the_notes_are_checked() {
    const std::set<std::string> wrong = {"forward_euler_growth", "growth_by_two_factors", "textbook_lake_gained"};
    std::size_t claims = 0;
    for (const char* file : {"notes_claims.csv", "notes_misprints.csv"})
        for (const Row& row : rows_of(file)) {
            ++claims;
            const std::string& claim = row.at("claim");
            if (claim.find("exponent") != std::string::npos && claim != "stable_dt_exponent") continue;
            expect((row.at("within") == "1") == (wrong.count(claim) == 0), claim + ": the verdict has changed");
        }
    expect(claims == 20, "a claim was not checked");
}

} // namespace

Checks atlas_checks() {
    return {{"every_cell_of_the_atlas_agrees_with_theory", every_cell_of_the_atlas_agrees_with_theory},
            {"extremes_are_survived", extremes_are_survived},
            {"plucks_and_settling_ropes_come_out_right", plucks_and_settling_ropes_come_out_right},
            {"features_cost_memory_only_when_on", features_cost_memory_only_when_on},
            {"the_notes_are_checked", the_notes_are_checked}};
}
