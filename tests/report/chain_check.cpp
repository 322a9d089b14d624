#include <cmath>
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

void the_hanging_rope_stretches_as_it_should() {
    for (const Row& row : rows_of("chain_hanging.csv")) {
        double of_exact = real(row, "mean_stretch") / real(row, "exact_stretch");
        const std::string& method = row.at("method");
        if (method == "implicit_one" || method == "one_step_of_1e4_s")
            expect(std::fabs(of_exact - 1) < 2e-3, method + " hangs at the wrong length, n = " + row.at("springs"));
        if (method == "position_based" && row.at("springs") == "1000")
            expect(of_exact > 5, "the position-based rope is not too soft, so that this comparison shows nothing");
    }
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
            {"the_hanging_rope_stretches_as_it_should", the_hanging_rope_stretches_as_it_should},
            {"figure_2_is_exact", figure_2_is_exact},
            {"a_disturbance_crosses_as_claimed", a_disturbance_crosses_as_claimed}};
}
