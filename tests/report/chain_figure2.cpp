// The notes' figure 2: what one implicit step makes of an impulse, and how many steps a disturbance needs to cross.
#include <algorithm>
#include <cmath>

#include "chain_parts.hpp"
#include "format.hpp"
#include "modes.hpp"
#include "plot.hpp"

namespace report {
namespace {

const std::size_t kSprings = 400, kMiddle = 200;
const double kWeight = 25;  // s = dt^2 k_spring / m_node

// The velocity after one backward Euler step from a unit of momentum at the middle node: the library's answer.
std::vector<double> whole_filter() {
    Chain chain(kSprings, 1, precisions().front());
    check(cd_chain_set_lambda(chain.get(), 1));
    const double mass = 1.0 / double(kSprings + 1);
    check(cd_chain_impulse(chain.get(), 0, kMiddle, &mass, 1));
    check(cd_chain_step(chain.get(), std::sqrt(kWeight / (double(kSprings) * double(kSprings + 1))), 1));
    return chain.read(CD_VELOCITY);
}

// y_{i+1} = b_{i+1} + w_i y_i alone (series-spring elimination), scaled to unit sum.
std::vector<double> forward_filter() {
    std::vector<double> y(kSprings + 1);
    double grounding = 1, last = 0, sum = 0;
    for (std::size_t i = 0; i <= kSprings; ++i) {
        y[i] = last + (i == kMiddle ? 1 : 0);
        sum += y[i];
        double share = kWeight / (grounding + kWeight);
        last = share * y[i];
        grounding = 1 + grounding * share;
    }
    for (double& value : y) value /= sum;
    return y;
}

Plot filter_plot(const std::string& title, Axis y, const std::vector<Series>& series, double reach) {
    Plot plot;
    plot.title = title;
    plot.x = {"nodes from the impulse", Scale::linear, "", -reach, reach};
    plot.y = std::move(y);
    plot.series = series;
    plot.guides = {{0, NAN, 0, NAN, "impulse"}};
    return plot;
}

// Steps until the far end of a free chain has moved, after an impulse at the near one; 0 if not within `most`.
std::size_t steps_to_cross(std::size_t springs, const Method& how, double dt, std::size_t most) {
    Chain chain(springs, 1, precisions().front());
    check(cd_chain_set_method(chain.get(), how.method));
    if (how.method == CD_METHOD_IMPLICIT) check(cd_chain_set_lambda(chain.get(), how.lambda));
    const double impulse = 1;
    check(cd_chain_impulse(chain.get(), 0, 0, &impulse, 1));
    for (std::size_t steps = 1; steps <= most; ++steps) {
        double far_end = 0;
        check(cd_chain_step(chain.get(), dt, 1));
        check(cd_chain_read_f64(chain.get(), CD_POSITION, 0, 1, springs, 1, &far_end, 1));
        if (far_end != 0) return steps;
    }
    return 0;
}

void report_crossing(Report& report) {
    // Short enough that neither the front, (dt^2 k/m)^n, nor forward Euler's growth leaves the numbers' range.
    const bool wide = precisions().front() == CD_FLOAT64;
    const std::vector<std::size_t> sizes =
        wide ? std::vector<std::size_t>{10, 100, 300} : std::vector<std::size_t>{10, 20, 30};
    Table table{{"method", "step"}, {}, {1}};
    for (std::size_t springs : sizes) table.head.push_back("n = " + std::to_string(springs));
    table.head.push_back("as n");
    Csv csv("method,springs,dt_s,steps_to_cross,steps_per_spring");
    std::string per_spring[2];
    std::size_t slowest_implicit = 0;
    for (Way way : library_ways()) {
        const Method& how = method(way);
        std::vector<std::string> row = {how.name, how.is_explicit() ? "0.7 of the limit" : wide ? "1/60 s" : "1/10 s"};
        std::size_t steps = 0;
        for (std::size_t springs : sizes) {
            Problem problem;
            problem.springs = springs;
            double dt = how.is_explicit() ? 0.7 * stable_dt(problem) : wide ? 1.0 / 60 : 0.1;
            steps = steps_to_cross(springs, how, dt, 4 * springs);
            if (!how.is_explicit()) slowest_implicit = std::max(slowest_implicit, steps > 0 ? steps : 4 * springs);
            row.push_back(steps > 0 ? std::to_string(steps) : "not seen");
            csv.row(how.key, springs, dt, steps, double(steps) / double(springs));
            report.summary("chain.crossing.n" + std::to_string(springs) + "." + how.key, double(steps), "steps");
        }
        std::string law =
            how.is_explicit() ? number(double(steps) / double(sizes.back()), 3) + " n" : std::to_string(steps);
        row.push_back(law);
        if (how.method == CD_METHOD_FORWARD_EULER) per_spring[0] = law;
        if (how.method == CD_METHOD_SYMPLECTIC_EULER) per_spring[1] = law;
        table.rows.push_back(row);
    }
    report.page.table(table,
                      "Steps until the far end of a free chain moves after an impulse at the near one: the claim of 2n "
                      "Euler steps holds for forward Euler (" + per_spring[0] + "), and " +
                      (slowest_implicit == 1 ? "one implicit step does" : "implicit steps are not always one") +
                      ". Symplectic Euler, whose new velocity moves the position at once, needs " + per_spring[1] +
                      ", so 2n there is the way across and back.");
    report.save("chain_crossing.csv", csv);
}

}  // namespace

void report_chain_figure2(Report& report) {
    report.page.section("chain-figure2", "Chains: what one implicit step does to an impulse");
    report.page.paragraph(
        "An implicit step is a low-pass filter run along the chain and back. One backward Euler step from an impulse, "
        "with dt² k/m = 25 between neighbours: the forward pass spreads it one way, the backward pass makes it "
        "symmetric. On a long chain the outcome is q^|i| / √(1 + 4s) with q = (1 + 2s − √(1 + 4s)) / (2s), s = 25.");
    const double root = std::sqrt(1 + 4 * kWeight), q = (1 + 2 * kWeight - root) / (2 * kWeight);
    const std::vector<double> whole = whole_filter(), forward = forward_filter();
    Series forward_series{"after the forward pass (formula)", {2, Marker::none, Dash::dashed}, {}, {}, {}};
    Series whole_series{"after both passes (library)", {1, Marker::circle, Dash::solid, true, false}, {}, {}, {}};
    Series exact_series{"exact, q^|i| / √(1 + 4s)", {1, Marker::none}, {}, {}, {}};
    Csv csv("node_from_impulse,forward_pass,both_passes,exact");
    double error = 0;
    for (int i = -60; i <= 60; ++i) {
        std::size_t node = std::size_t(int(kMiddle) + i);
        double exact = std::pow(q, std::abs(i)) / root;
        forward_series.x.push_back(i), forward_series.y.push_back(forward[node]);
        whole_series.x.push_back(i), whole_series.y.push_back(whole[node]);
        exact_series.x.push_back(i), exact_series.y.push_back(exact);
        error = std::fmax(error, std::fabs(whole[node] / exact - 1));
        csv.row(i, forward[node], whole[node], exact);
    }
    double sum = 0;
    for (double value : whole) sum += value;
    std::vector<Series> series = {forward_series, exact_series, whole_series};
    report.page.figure(
        {render(filter_plot("linear", {"share of the impulse", Scale::linear, "", 0, 0.2}, series, 30)),
         render(filter_plot("logarithmic", {"share of the impulse", Scale::log, "", 1e-7, 1}, series, 60))},
        legend(series),
        "The library's step is the exact filter: at all of the 121 nodes within " + number(error, 2) +
            " of it, relative to each node's own value. The shares sum to 1 " +
            (sum == 1 ? std::string("exactly") : "within " + number(std::fabs(sum - 1), 2)) +
            ": momentum is kept. On the logarithmic scale both flanks are straight lines; the forward pass "
            "alone has only the right one.");
    report.save("chain_figure2.csv", csv);
    report.summary("chain.figure2.largest_relative_error", error);
    report_crossing(report);
}

}  // namespace report
