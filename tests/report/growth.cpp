#include "growth.hpp"

#include <algorithm>
#include <cmath>

#include "format.hpp"
#include "modes.hpp"
#include "timing.hpp"

namespace report {

double Growth::exponent() const {
    double n = double(costs.size()), sx = 0, sy = 0, sxx = 0, sxy = 0;
    for (const Cost& cost : costs) {
        double x = std::log(double(cost.size)), y = std::log(cost.seconds);
        sx += x, sy += y, sxx += x * x, sxy += x * y;
    }
    return (n * sxy - sx * sy) / (n * sxx - sx * sx);
}

double Growth::per_node_step_at(std::size_t size) const {
    for (const Cost& cost : costs)
        if (cost.size == size) return cost.per_node_step();
    return NAN;
}

const Growth& find(const std::vector<Growth>& growths, Way way) {
    for (const Growth& growth : growths)
        if (growth.how == &method(way) && growth.precision == precisions().front()) return growth;
    return growths.front();
}

void measure_size(Report& report, const Sized& sized, std::vector<Growth>& growths) {
    std::vector<std::unique_ptr<Runner>> runners;
    std::vector<Job> jobs;
    for (Growth& growth : growths) {
        const Method& how = *growth.how;
        auto expected = [&](std::size_t steps) { return sized.expected_error(how, steps); };
        std::size_t steps =
            how.is_explicit() ? sized.limit : fewest_steps(expected, 0.999 * kGrowthTolerance, 1u << 22);
        std::size_t timed = std::min(steps, sized.affordable(how));
        growth.costs.push_back({sized.size, sized.nodes, steps, timed, 0, 0, NAN, NAN});
        runners.push_back(sized.make(how, growth.precision));
        Runner* runner = runners.back().get();
        const double dt = sized.time / double(steps);
        const std::size_t before = timed < steps ? 1 : 0;
        jobs.push_back({[=] { runner->reset(), runner->step(dt, before); }, [=] { runner->step(dt, timed); }});
    }
    time_in_turns(jobs, report.by_extent(1e-3, 0.1), report.by_extent<std::size_t>(1, 3), 21);
    for (std::size_t i = 0; i < growths.size(); ++i) {
        Cost& cost = growths[i].costs.back();
        cost.seconds = jobs[i].least() * double(cost.steps) / double(cost.timed_steps);
        cost.spread = jobs[i].spread();
        cost.iterations = runners[i]->iterations();
        if (cost.whole()) cost.error = relative_error(runners[i]->positions(), sized.exact);
    }
    report.progress("growth: n = " + std::to_string(sized.size));
}

std::string crossing(const Growth& explicit_steps, const Growth& implicit) {
    auto ratio = [&](std::size_t i) { return explicit_steps.costs[i].seconds / implicit.costs[i].seconds; };
    const std::size_t last = implicit.costs.size() - 1;
    auto size = [&](std::size_t i) { return "n = " + count(double(implicit.costs[i].size)); };
    for (std::size_t i = 0; i <= last; ++i)
        if (ratio(i) > 1)
            return implicit.how->name + " is the cheaper from " + size(i) + " on, and " + number(ratio(last), 2) +
                   " times cheaper at " + size(last) + ".";
    return "Explicit steps are cheaper than " + implicit.how->name + " at every n, " + number(1 / ratio(last), 2) +
           " times at " + size(last) + ".";
}

GrowthView view(Report& report, const std::vector<Growth>& growths, const GrowthNames& names) {
    GrowthView view{{},
                    {},
                    Csv(names.size + ",method,precision,textbook,steps,timed_steps,seconds,error,ns_per_node_step"),
                    {},
                    false};
    Plot total, per_node;
    total.title = "cost of one " + names.span;
    total.x = {names.label, Scale::log};
    total.y = {"run time of 1 simulated " + names.span, Scale::log, "s"};
    per_node.title = "cost of one " + names.node + " and step";
    per_node.x = total.x;
    per_node.y = {"time per " + names.node + " and step", Scale::log, "s"};
    const std::vector<Cost>& sizes = growths.front().costs;
    view.table.head = {"method", "steps at n = " + count(double(sizes.front().size)),
                       "steps at n = " + count(double(sizes.back().size)), "exponent fitted", "expected"};
    for (std::size_t size : names.at)
        view.table.head.push_back("ns per " + names.node + " and step, n = " + count(double(size)));
    for (const Growth& growth : growths) {
        Series seconds{growth.name(), style_of(*growth.how, growth.precision), {}, {}, {}}, each = seconds;
        for (const Cost& cost : growth.costs) {
            const double size = double(cost.size);
            view.csv.row(cost.size, growth.how->key, name_of(growth.precision), int(growth.how->textbook), cost.steps,
                         cost.timed_steps, cost.seconds, cost.error, cost.per_node_step() * 1e9);
            seconds.x.push_back(size), seconds.y.push_back(cost.seconds);
            each.x.push_back(size), each.y.push_back(cost.per_node_step());
            const std::string spread = spread_words(cost.spread);
            seconds.tips.push_back("n = " + count(size) + ": " + si(cost.seconds, "s") + spread + ", " +
                                   count(double(cost.steps)) + " steps" +
                                   (cost.whole() ? "" : " (timed over " + count(double(cost.timed_steps)) + ")"));
            each.tips.push_back("n = " + count(size) + ": " + si(cost.per_node_step(), "s") + spread);
            view.scaled = view.scaled || !cost.whole();
        }
        total.series.push_back(seconds);
        per_node.series.push_back(each);
        view.table.rows.push_back({growth.name(), count(double(growth.costs.front().steps)),
                                   count(double(growth.costs.back().steps)), number(growth.exponent(), 3),
                                   std::to_string(names.explicit_power - (growth.how->is_explicit() ? 0 : 1))});
        report.summary(names.key + ".exponent." + growth.key(), growth.exponent());
        for (std::size_t size : names.at) {
            const double nanoseconds = growth.per_node_step_at(size) * 1e9;
            view.table.rows.back().push_back(number(nanoseconds, 3));
            report.summary(names.key + ".ns_per_" + names.node + "_step.n" + std::to_string(size) + "." + growth.key(),
                           nanoseconds, "ns");
        }
    }
    view.panels = {render(total), render(per_node)};
    view.series = total.series;
    return view;
}

}  // namespace report
