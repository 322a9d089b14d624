// How the cost of one simulated second grows with the number of springs.
#include <algorithm>
#include <cmath>

#include "chain_parts.hpp"
#include "format.hpp"
#include "modes.hpp"
#include "plot.hpp"
#include "timing.hpp"

namespace report {
namespace {

const double kTolerance = 0.01;

struct Cost {
    std::size_t springs, steps, timed_steps;
    double seconds, error;  // error NaN where only a part of the second was run
    bool whole() const { return timed_steps == steps; }
    double per_node_step() const { return seconds / double(steps) / double(springs + 1); }
};

struct Growth {
    Way way;
    cd_precision precision;
    std::vector<Cost> costs;

    std::string name() const { return method(way).name + ", " + name_of(precision); }
    std::string key() const { return method(way).key + "." + name_of(precision); }

    // Exponent of seconds ~ n^p by least squares over the logarithms.
    double exponent() const {
        double n = double(costs.size()), sx = 0, sy = 0, sxx = 0, sxy = 0;
        for (const Cost& cost : costs) {
            double x = std::log(double(cost.springs)), y = std::log(cost.seconds);
            sx += x, sy += y, sxx += x * x, sxy += x * y;
        }
        return (n * sxy - sx * sy) / (n * sxx - sx * sx);
    }
};

std::vector<std::size_t> sizes(const Report& report) {
    if (report.extent == Extent::brief) return {100, 300, 1000};
    return {100, 300, 1000, 3000, 10000, 30000, 100000};
}

void measure_size(const Report& report, std::size_t springs, std::vector<Growth>& growths) {
    Problem problem;
    problem.springs = springs;
    problem.pin_first = problem.pin_last = true;
    problem.position = gaussian_bump(springs);
    const SineModes modes(springs, 1, problem.position, 150);
    const std::vector<double> exact = modes.at(1);
    const std::size_t limit = std::size_t(std::ceil(1 / (0.9999 * stable_dt(problem))));
    const double affordable = report.by_extent(1e6, 2e7, 1e11);  // node steps in one run

    std::vector<std::unique_ptr<Runner>> runners;
    std::vector<Job> jobs;
    for (Growth& growth : growths) {
        const Method& how = method(growth.way);
        auto expected = [&](std::size_t steps) { return modes.expected_error(how, 1, steps); };
        std::size_t steps = how.is_explicit() ? limit : fewest_steps(expected, 0.999 * kTolerance, 1u << 22);
        std::size_t timed = std::min(steps, std::max<std::size_t>(16, std::size_t(affordable / double(springs))));
        growth.costs.push_back({springs, steps, timed, 0, NAN});
        runners.push_back(make_runner(problem, how, growth.precision));
        Runner* runner = runners.back().get();
        jobs.push_back({[=] { runner->reset(); }, [=] { runner->step(1 / double(steps), timed); }});
    }
    time_in_turns(jobs, report.by_extent(1e-3, 0.1, 1.0), report.by_extent<std::size_t>(1, 3, 1), 21);
    for (std::size_t i = 0; i < growths.size(); ++i) {
        Cost& cost = growths[i].costs.back();
        cost.seconds = jobs[i].least() * double(cost.steps) / double(cost.timed_steps);
        if (cost.whole()) cost.error = relative_error(runners[i]->positions(), exact);
    }
    report.progress("growth: n = " + std::to_string(springs));
}

Style styled(const Growth& growth) {
    return style_of(method(growth.way), growth.precision);
}

// From which n on the implicit step is the cheaper one.
std::string crossing(const std::vector<Growth>& growths) {
    const Growth *explicit_steps = nullptr, *implicit = nullptr;
    for (const Growth& growth : growths) {
        if (growth.precision != precisions().front()) continue;
        if (growth.way == Way::symplectic_euler) explicit_steps = &growth;
        if (growth.way == Way::half) implicit = &growth;
    }
    for (std::size_t i = 0; i < implicit->costs.size(); ++i) {
        double ratio = explicit_steps->costs[i].seconds / implicit->costs[i].seconds;
        if (ratio > 1)
            return "λ = 1/2 is the cheaper from n = " + count(double(implicit->costs[i].springs)) +
                   " on, and " + number(explicit_steps->costs.back().seconds / implicit->costs.back().seconds, 2) +
                   " times cheaper at n = " + count(double(implicit->costs.back().springs)) + ".";
    }
    return "Explicit steps are the cheaper at every n.";
}

}  // namespace

void report_chain_growth(Report& report) {
    report.page.section("chain-growth", "Chain: growth of run time with n");
    report.page.paragraph(
        "The same smooth wave on finer and finer chains, 1 s simulated. Explicit steps are the longest stable ones, "
        "and shorten as 1/n; implicit steps are the longest that keep the error within 1%, and hardly depend on n. "
        "The notes expect a cost that grows as n² for the one and as n for the other.");
    std::vector<Growth> growths;
    for (Way way : {Way::symplectic_euler, Way::half, Way::stiff_second, Way::backward})
        for (cd_precision precision : precisions()) {
            if (precision == CD_FLOAT32 && (way == Way::backward || way == Way::stiff_second)) continue;
            growths.push_back({way, precision, {}});
        }
    for (Way way : {Way::textbook_symplectic, Way::textbook_half})
        growths.push_back({way, precisions().front(), {}});
    for (std::size_t springs : sizes(report)) measure_size(report, springs, growths);

    Csv csv("springs,method,precision,textbook,steps,timed_steps,seconds,error,ns_per_node_step");
    Plot total, per_node;
    total.title = "cost of one second";
    total.x = {"number of springs n", Scale::log};
    total.y = {"run time of 1 simulated second", Scale::log, "s"};
    per_node.title = "cost of one node and step";
    per_node.x = total.x;
    per_node.y = {"time per node and step", Scale::log, "s"};
    Table table{{"method", "steps at n = " + count(double(sizes(report).front())),
                 "steps at n = " + count(double(sizes(report).back())), "exponent fitted", "the notes",
                 "ns per node and step, n = 1000"}, {}, {}};
    bool scaled = false;
    std::string implicit_exponent, explicit_exponent, range;
    for (const Growth& growth : growths) {
        Series seconds{growth.name(), styled(growth), {}, {}, {}}, each = seconds;
        double at_1000 = NAN;
        for (const Cost& cost : growth.costs) {
            csv.row(cost.springs, method(growth.way).key, name_of(growth.precision), int(method(growth.way).textbook),
                    cost.steps, cost.timed_steps, cost.seconds, cost.error, cost.per_node_step() * 1e9);
            seconds.x.push_back(double(cost.springs)), seconds.y.push_back(cost.seconds);
            each.x.push_back(double(cost.springs)), each.y.push_back(cost.per_node_step());
            seconds.tips.push_back(growth.name() + ", n = " + count(double(cost.springs)) + ": " +
                                   si(cost.seconds, "s") + ", " + count(double(cost.steps)) + " steps" +
                                   (cost.whole() ? "" : " (timed over " + count(double(cost.timed_steps)) + ")"));
            scaled = scaled || !cost.whole();
            if (cost.springs == 1000) at_1000 = cost.per_node_step();
        }
        total.series.push_back(seconds);
        per_node.series.push_back(each);
        double p = growth.exponent();
        table.rows.push_back({growth.name(), count(double(growth.costs.front().steps)),
                              count(double(growth.costs.back().steps)), number(p, 3),
                              method(growth.way).is_explicit() ? "2" : "1", number(at_1000 * 1e9, 3)});
        report.summary("chain.growth.exponent." + growth.key(), p);
        report.summary("chain.growth.ns_per_node_step.n1000." + growth.key(), at_1000 * 1e9, "ns");
        if (growth.way == Way::half && growth.precision == precisions().front()) {
            auto by_cost = [](const Cost& a, const Cost& b) { return a.per_node_step() < b.per_node_step(); };
            auto least_most = std::minmax_element(growth.costs.begin(), growth.costs.end(), by_cost);
            range = si(least_most.first->per_node_step(), "s", 2) + " at the least and " +
                    si(least_most.second->per_node_step(), "s", 2) + " at the most";
            implicit_exponent = number(p, 3);
        }
        if (growth.way == Way::symplectic_euler && growth.precision == precisions().front())
            explicit_exponent = number(p, 3);
    }
    report.page.headline(implicit_exponent,
                         "is the exponent of n in the cost of a second at 1% error with λ = 1/2; with explicit "
                         "steps it is " + explicit_exponent);
    report.page.figure({render(total), render(per_node)}, legend(total.series),
                       "The cost of one second grows with exponent " + explicit_exponent + " with explicit steps and " +
                       implicit_exponent + " with λ = 1/2 at 1% error. " + crossing(growths) +
                       " One node and step of λ = 1/2 costs " + range + "." +
                       (scaled ? " The longest runs were timed over their first part and scaled up; chain_growth.csv "
                                 "says which." : ""));
    report.page.table(table, "Exponents fitted over n = " + count(double(sizes(report).front())) + " to " +
                             count(double(sizes(report).back())) + ". At its stability limit symplectic Euler is off "
                             "by about 10/n, so that at n = 100 it is not within 1%.");
    report.save("chain_growth.csv", csv);
}

}  // namespace report
