// Thacker's planar oscillation, as the plan's prototype and the library do it, row by row.
#include <array>
#include <cmath>

#include "format.hpp"
#include "water_parts.hpp"
#include "water_waves.hpp"

namespace report {
namespace {

struct Row {
    Way way;
    std::size_t corrections, cells;
    double unit;    // the step, in dx / sqrt(g)
    double planned; // the prototype's error
};

// The tables of the plan, in its order.
std::vector<Row> rows() {
    std::vector<Row> rows;
    auto add = [&](Way way, std::size_t corrections, const std::vector<std::array<double, 3>>& cases) {
        for (const std::array<double, 3>& c : cases) rows.push_back({way, corrections, std::size_t(c[0]), c[1], c[2]});
    };
    add(Way::water_linear, 0,
        {{100, 0.5, 2.8e-2}, {200, 0.5, 1.9e-2}, {400, 0.5, 1.6e-2}, {200, 2, 2.7e-2}, {200, 8, 3.0e-1}});
    add(Way::water_one, 0,
        {{100, 0.5, 7.0e-2}, {200, 0.5, 4.2e-2}, {400, 0.5, 2.8e-2}, {200, 2, 1.1e-1}, {200, 8, 3.2e-1}});
    add(Way::water_advected, 0,
        {{100, 0.5, 1.4e-3}, {200, 0.5, 4.7e-4}, {400, 0.5, 1.1e-4}, {200, 2, 3.0e-3}, {200, 8, 2.0e-1}});
    add(Way::water_two_corrections, 1,
        {{100, 0.5, 2.7e-3},
         {200, 0.5, 1.4e-3},
         {400, 0.5, 6.2e-4},
         {200, 2, 8.8e-3},
         {200, 8, 2.1e-1},
         {400, 8, 2.3e-1},
         {200, 16, 2.9e-1}});
    add(Way::water_two_corrections, 2,
        {{100, 0.5, 1.1e-3},
         {200, 0.5, 5.0e-4},
         {400, 0.5, 1.7e-4},
         {200, 2, 7e-4},
         {200, 8, 3.3e-2},
         {400, 8, 1.3e-2},
         {200, 16, 2.0e-1}});
    add(Way::water_four_corrections, 4, {{200, 2, 1.0e-3}, {200, 8, 4.8e-3}, {400, 8, 2.5e-3}, {200, 16, 3.6e-2}});
    return rows;
}

} // namespace

void report_water_thacker(Report& report) {
    report.page.section("water-thacker", "Water: moving shores, against the plan");
    report.page.paragraph(
        "Thacker's planar oscillation over the bed 0.25 x² on [−3, 3], three periods, in the cells and steps of the "
        "plan that the library was built from, whose prototype gave the errors in the column before ours. The step is "
        "in units of dx / √g; a wave crosses about as many cells in one. Held back is the water that a cell would have "
        "given beyond what it had, in all steps together.");
    const double time = 3 * Thacker::period();
    struct Rocked {
        double error, volume_off, held; // over the volume
        std::string hash;
    };
    const auto rock = [&](const Row& row, std::size_t cells) -> Rocked {
        Method how = method(row.way);
        how.corrections = row.corrections;
        const WaterProblem problem = Thacker::problem(cells);
        Water water(problem.nx, 1, problem.dx, 1, precisions().front());
        water.set(how);
        set_up(problem, water);
        const std::size_t steps = std::size_t(std::ceil(time / (row.unit * problem.dx / std::sqrt(kEarth))));
        const double before = water.volume();
        check(cd_water_step(water.get(), time / double(steps), steps));
        double held = 0;
        check(cd_water_get_limited(water.get(), nullptr, &held));
        return {depth_error(water.read(CD_DEPTH), Thacker::depth(cells, time)), std::fabs(water.volume() / before - 1),
                held / before, hex(water.hash())};
    };
    Table table{{"method", "cells", "step", "the plan's error", "error", "with 2 cells less, more", "volume off by",
                 "held back"},
                {},
                {}};
    Csv csv(
        "method,corrections,cells,step,planned_error,error,error_2_less,error_2_more,volume_error,"
        "held_back_over_volume,hash");
    double worst = 0, off = 0;
    std::size_t better = 0, within = 0;
    for (const Row& row : rows()) {
        const Method& how = method(row.way);
        const std::string name = row.corrections == 0 ? how.name
                                 : row.corrections == 1
                                     ? std::string("large steps, 1 correction")
                                     : "large steps, " + std::to_string(row.corrections) + " corrections";
        const Rocked at = rock(row, row.cells);
        const double less = rock(row, row.cells - 2).error, more = rock(row, row.cells + 2).error;
        worst = std::fmax(worst, at.error / row.planned);
        better += at.error <= row.planned;
        within += std::fmin(at.error, std::fmin(less, more)) <= row.planned;
        off = std::fmax(off, at.volume_off);
        table.rows.push_back({name, count(double(row.cells)), plain(row.unit), number(row.planned, 2),
                              number(at.error, 2), number(less, 2) + ", " + number(more, 2),
                              at.volume_off == 0 ? "0" : number(at.volume_off, 1),
                              at.held < 1e-15 ? "none" : percent(at.held, 2)});
        csv.row(how.key, row.corrections, row.cells, row.unit, row.planned, at.error, less, more, at.volume_off,
                at.held, at.hash);
        const std::string key = "water.thacker." +
                                (row.corrections ? "corrections_" + std::to_string(row.corrections) : how.key) + ".n" +
                                std::to_string(row.cells) + ".step_" + plain(row.unit);
        report.summary(key, at.error);
        report.outcome(key, at.hash);
    }
    report.summary("water.thacker.worst_error_over_the_plans", worst);
    report.summary("water.thacker.rows_within_the_plan", double(better), "rows");
    report.summary("water.thacker.rows_within_the_plan_give_or_take_two_cells", double(within), "rows");
    report.summary("water.thacker.worst_volume_error", off);
    report.page.table(
        table, std::to_string(better) + " of " + std::to_string(table.rows.size()) +
                   " rows are as near as the plan's prototype or nearer, none is further off than " + number(worst, 3) +
                   " times. The errors are those of one instant; with two cells more "
                   "or less, " +
                   std::to_string(within) +
                   " rows come as near. Without large steps a step must not be much longer than a wave takes to "
                   "cross a few cells: with 8, water is held back all along the shore. With large steps "
                   "none is, and 4 corrections carry the shore across 8 cells a step.");
    report.save("water_thacker.csv", csv);
    report.progress("water: Thacker's tables");
}

} // namespace report
