#include <cmath>
#include <set>

#include "check.hpp"

namespace {

void drum_errors_fall_at_their_order() {
    expect_orders("membrane_work_precision.csv", "membrane.drum.n64",
                  {{"symplectic_euler", 1}, {"alternating_half", 2}, {"alternating_stiff", 2}});
    std::map<std::string, std::map<std::string, double>> errors;  // by method and steps
    for (const Row& row : rows_of("membrane_work_precision.csv"))
        if (row.at("precision") == "float64") errors[row.at("method")][row.at("steps")] = real(row, "error");
    for (const auto& [steps, error] : errors["textbook_half"])
        expect(std::fabs(errors["alternating_half"][steps] / error - 1) < 1e-6,
               "not the textbook's: " + steps + " steps");
    expect(errors["textbook_half"].size() > 3, "the textbook was hardly run");
    expect(std::fabs(errors["coupled_half"]["64"] / errors["alternating_half"]["64"] - 1) < 0.1,
           "the two solvers disagree on a slow drum");
}

// lambda = 1/2 coupled: a quarter of the error with twice the steps, on every stiff sheet and in both precisions.
void stiff_sheets_need_few_coupled_steps() {
    std::set<std::string> seen;
    for (const std::string study : {"membrane.stiff", "membrane.stiff_pair", "membrane.stiff_along_u"})
        for (const std::string precision : {"float64", "float32"}) {
            double error[2] = {0, 0};
            for (const Row& row : rows_of("membrane_stiff_work_precision.csv"))
                if (row.at("case") == study && row.at("precision") == precision && row.at("method") == "coupled_half")
                    for (int i = 0; i < 2; ++i)
                        if (row.at("steps") == (i == 0 ? "64" : "128")) error[i] = real(row, "error");
            expect(error[0] > 0 && error[0] < 0.03,
                   study + ", " + precision + ": 64 coupled steps do not come within 3%");
            expect(std::fabs(error[0] / error[1] - 4) < 0.8, study + ", " + precision + ": not of second order");
        }
    for (const Row& row : rows_of("membrane_stiff_cheapest.csv"))
        if (real(row, "tolerance") == 0.01) {
            seen.insert(row.at("case"));
            expect(real(row, "explicit_steps") > 500 * real(row, "implicit_steps"),
                   row.at("case") + ": explicit steps are not five hundred times as many");
            expect(real(row, "implicit_steps") > 0, row.at("case") + ": no implicit run reaches 1%");
        }
    expect(seen.size() == 3, "a stiff sheet is missing");
}

void modes_swing_as_theory_says() {
    for (const Row& row : rows_of("membrane_frequencies.csv"))
        expect(std::fabs(real(row, "measured_over_true") / real(row, "theory_over_true") - 1) < 1e-8,
               row.at("solver") + " at " + row.at("lambda_dt_omega"));
}

void a_stiff_drum_gives_way_at_once_when_coupled() {
    bool slow = false;
    for (const Row& row : rows_of("membrane_load.csv")) {
        const double deflection = real(row, "deflection_over_static");
        if (row.at("step") != "6" || real(row, "stiffness_over_mass") < 1e6) continue;
        if (row.at("solver") == "coupled") expect(std::fabs(deflection - 1) < 1e-2, "coupled is not there");
        else slow = deflection < 0.05;
    }
    expect(slow, "alternating is not sluggish, so that this comparison shows nothing");
}

void the_notes_factors_blow_up_and_the_library_does_not() {
    std::set<std::string> lost;
    for (const Row& row : rows_of("membrane_blow_ups.csv")) {
        const double growth = real(row, "greatest_speed_over_first");
        const std::string what = row.at("method") + ", " + row.at("held") + ", " + row.at("stiffness_over_mass");
        if (row.at("textbook") == "0" || row.at("held") == "edges held") expect(growth < 10, what + " grows");
        else if (!(growth < 1e6)) lost.insert(row.at("held"));
    }
    expect(lost.size() == 3, "the notes' factors do not blow up, so that this comparison shows nothing");
}

void coupled_solves_take_few_iterations() {
    std::set<std::string> seen;
    for (const Row& row : rows_of("membrane_iterations.csv")) {
        seen.insert(row.at("sheet"));
        if (row.at("sheet") == "random") continue;
        expect(row.at("reached") == "1" && real(row, "iterations") <= 16,
               row.at("sheet") + " at " + row.at("stiffness_over_mass") + ": " + row.at("iterations") + " iterations");
    }
    expect(seen.size() == 5, "a kind of sheet is missing");
}

void cloth_keeps_its_size_and_falls_as_it_should() {
    std::size_t of_the_library = 0;
    for (const Row& row : rows_of("cloth_drop.csv")) {
        const std::string what = row.at("way") + " of " + row.at("nodes") + " nodes a side";
        const double worst = real(row, "worst_stretch"), fallen = real(row, "fallen_m");
        if (row.at("way") == "position_based.30x1")
            expect(worst > 0.1, what + " stretches as little, so that this comparison shows nothing");
        if (row.at("highest_rise_j").empty()) continue;
        ++of_the_library;
        expect(real(row, "highest_rise_j") < 1e-9, what + " gains energy in a step");
        if (row.at("way") != "one.default" || real(row, "nodes") > 64) continue;
        expect(worst < 0.05 && real(row, "rms_stretch") < 0.0035, what + " stretches");
        expect(std::fabs(fallen / real(row, "converged_fallen_m") - 1) < 0.04, what + " falls as through syrup");
    }
    expect(of_the_library >= 10, "a way is missing");
}

}  // namespace

Checks membrane_checks() {
    return {{"drum_errors_fall_at_their_order", drum_errors_fall_at_their_order},
            {"stiff_sheets_need_few_coupled_steps", stiff_sheets_need_few_coupled_steps},
            {"modes_swing_as_theory_says", modes_swing_as_theory_says},
            {"a_stiff_drum_gives_way_at_once_when_coupled", a_stiff_drum_gives_way_at_once_when_coupled},
            {"the_notes_factors_blow_up_and_the_library_does_not", the_notes_factors_blow_up_and_the_library_does_not},
            {"coupled_solves_take_few_iterations", coupled_solves_take_few_iterations},
            {"cloth_keeps_its_size_and_falls_as_it_should", cloth_keeps_its_size_and_falls_as_it_should}};
}
