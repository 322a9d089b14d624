// Thacker's planar oscillation: shores that move, refined, in steps of three lengths.
#include <cmath>

#include "format.hpp"
#include "water_parts.hpp"
#include "water_waves.hpp"

namespace report {

void report_water_thacker(Report& report) {
    report.page.section("water-thacker", "Water: a shore that moves");
    report.page.paragraph(
        "Thacker's planar oscillation over the bed 0.25 x² on [−3, 3], three periods, in steps in which a wave crosses "
        "half a cell, 2 cells and 8 where the water is 1 m deep. Errors are those of the depth in L1, relative to the "
        "volume.");
    const double time = 3 * Thacker::period();
    Table table{{"method", "cells"}, {}, {}};
    for (double courant : kCourants) table.head.push_back("error at Courant " + plain(courant));
    Csv csv("method,cells,courant,error,volume_error,held_back_over_volume,hash");
    double off = 0;
    for (Way way : {Way::water_advected, Way::water_explicit_advected, Way::water_linear})
        for (std::size_t n : {100, 200, 400}) {
            const Method& how = method(way);
            std::vector<std::string> cells = {how.name, count(double(n))};
            for (double courant : kCourants) {
                if (how.is_explicit() && courant > 1) {
                    cells.push_back("beyond its limit");
                    continue;
                }
                Water water(n, 1, Thacker::kLength / double(n), 1, precisions().front());
                water.set(how);
                set_up(Thacker::problem(n), water);
                const std::size_t steps = Thacker::steps(n, courant);
                const double before = water.volume();
                check(cd_water_step(water.get(), time / double(steps), steps));
                double held = 0;
                check(cd_water_get_limited(water.get(), nullptr, &held));
                const double error = depth_error(water.read(CD_DEPTH), Thacker::depth(n, time)),
                             volume_off = std::fabs(water.volume() / before - 1);
                off = std::fmax(off, volume_off);
                cells.push_back(number(error, 2));
                csv.row(how.key, n, courant, error, volume_off, held / before, hex(water.hash()));
                const std::string key =
                    "water.thacker." + how.key + ".n" + std::to_string(n) + ".courant_" + plain(courant);
                report.summary(key, error);
                report.outcome(key, hex(water.hash()));
            }
            table.rows.push_back(cells);
        }
    report.summary("water.thacker.worst_volume_error", off);
    report.page.table(table,
                      "Advected water carries its shores across many cells a step, and comes nearer as cells "
                      "get smaller at any of these Courant numbers. Linear water has no inertia beyond its own "
                      "face, and its shore comes late. The volume is off by at most " +
                          number(off, 1) + " of itself.");
    report.save("water_thacker.csv", csv);
    report.progress("water: Thacker's shores");
}

} // namespace report
