#include <cmath>
#include <cstdlib>
#include <map>
#include <set>

#include "check.hpp"

namespace {

void errors_fall_at_their_order() {
    expect_orders("chain_work_precision.csv", "chain.wave.n100",
                  {{"forward_euler", 1},
                   {"symplectic_euler", 1},
                   {"implicit_half", 2},
                   {"implicit_one", 1},
                   {"stiff_second", 2},
                   {"textbook_half", 2}});
}

void stiff_chains_agree_and_the_textbook_does_not() {
    for (const Row& row : rows_of("chain_extremes.csv")) {
        double stiffness = real(row, "stiffness_over_mass");
        double position = real(row, "position_error"), velocity = real(row, "velocity_error");
        bool one_step = row.at("steps") == "1";
        std::string what = row.at("method") + " at " + row.at("stiffness_over_mass") + " after " + row.at("steps");
        if (row.at("textbook") == "0") {
            expect(position < (one_step ? 1e-5 : 1e-4), what + ": position");
            // lambda = 1/2 keeps as motion what rounding puts into stiff springs
            if (one_step || row.at("method") != "implicit_half")
                expect(velocity < (one_step ? 3e-5 : 1e-3), what + ": velocity");
        } else if (stiffness >= 1e16) {
            expect(!(position < 0.1), what + " works, so that this comparison shows nothing");
        }
    }
}

void explicit_steps_need_many_on_a_stiff_chain() {
    double explicit_steps = 0, implicit_steps = 0;
    for (const Row& row : rows_of("chain_stiff_cheapest.csv"))
        if (real(row, "tolerance") == 0.01)
            explicit_steps = real(row, "explicit_steps"), implicit_steps = real(row, "implicit_steps");
    expect(implicit_steps > 0 && implicit_steps < 200, "no implicit run of under 200 steps reaches 1%");
    expect(explicit_steps > 1000 * implicit_steps, "explicit steps are not a thousand times as many");
}

void a_swinging_rope_keeps_its_length() {
    std::map<std::string, double> missed, stretch;
    for (const Row& row : rows_of("chain_swing.csv")) {
        if (row.at("springs") != "100" || row.at("strands") != "1") continue;
        missed[row.at("way")] = real(row, "end_missed_m");
        stretch[row.at("way")] = real(row, "stretch");
    }
    for (const char* tolerance : {"1e-1", "1e-2", "1e-3", "1e-6"})
        for (const char* lambda : {"one.", "half."})
            expect(stretch[std::string(lambda) + tolerance] <= 1.001 * std::atof(tolerance),
                   std::string(lambda) + tolerance + " is longer than it may be");
    expect(missed["half.1e-6"] < 5e-3, "the end is not where it should be");
    expect(stretch["position_based.20x1"] > 1e-2 && missed["position_based.20x1"] > 2e-2,
           "position-based dynamics is as good, so that this comparison shows nothing");
}

void figure_2_is_exact() {
    double sum = 0;
    for (const Row& row : rows_of("chain_figure2.csv")) {
        double exact = real(row, "exact");
        sum += exact;
        expect(std::fabs(real(row, "both_passes") - exact) <= 1e-10 * exact, "node " + row.at("node_from_impulse"));
        if (real(row, "node_from_impulse") < 0)
            expect(real(row, "forward_pass") == 0, "the forward pass runs backward");
    }
    expect(std::fabs(sum - 1) < 1e-4, "the exact filter does not sum to 1");
}

void a_disturbance_crosses_as_claimed() {
    std::set<std::string> seen;
    for (const Row& row : rows_of("chain_crossing.csv")) {
        const std::string& method = row.at("method");
        double n = real(row, "springs"), steps = real(row, "steps_to_cross");
        seen.insert(method);
        if (method == "forward_euler") expect(std::fabs(steps - 2 * n) <= 1, "forward Euler does not need 2n steps");
        else if (method == "symplectic_euler")
            expect(std::fabs(steps - n) <= 1, "symplectic Euler does not need n steps");
        else expect(steps == 1, method + " does not cross in one step");
    }
    expect(seen.size() == 5, "a method is missing");
}

}  // namespace

Checks chain_checks() {
    return {{"errors_fall_at_their_order", errors_fall_at_their_order},
            {"stiff_chains_agree_and_the_textbook_does_not", stiff_chains_agree_and_the_textbook_does_not},
            {"explicit_steps_need_many_on_a_stiff_chain", explicit_steps_need_many_on_a_stiff_chain},
            {"a_swinging_rope_keeps_its_length", a_swinging_rope_keeps_its_length},
            {"figure_2_is_exact", figure_2_is_exact},
            {"a_disturbance_crosses_as_claimed", a_disturbance_crosses_as_claimed}};
}
