// Error against run time on water: small waves in a slice and in a pool, and Thacker's planar oscillation.
#include <algorithm>
#include <cmath>

#include "format.hpp"
#include "water_parts.hpp"
#include "water_waves.hpp"
#include "work_precision.hpp"

namespace report {
namespace {

// About what a cell and step costs [s].
double guess(const Method& how, bool slice) { return 1e-9 * (how.textbook ? 20 : slice ? 30 : 8); }

Study seiche_study(const Report& report, const std::string& key, const std::string& title, std::size_t nx,
                   std::size_t ny, const std::vector<Seiches::Mode>& modes, const std::vector<Way>& ways) {
    const double length = 20, depth = 1;
    const bool slice = ny == 1;
    const Seiches seiches(nx, ny, length, slice ? 1 : length, depth, modes);
    Study study;
    study.key = key;
    study.title = title;
    study.time = 12;
    study.tolerances = {1e-1, 1e-2, 1e-3};
    study.error_label = "relative error, greatest over the cells";
    const WaterProblem problem = seiches.problem();
    study.make = runners_of(problem);
    study.exact = seiches.at(study.time);
    const std::size_t limit = std::size_t(std::ceil(study.time / (0.9999 * stable_dt(problem))));
    for (Way way : ways) {
        const Method& how = method(way);
        const double seconds = report.by_extent(0.02, slice ? 0.03 : 0.08) * (how.textbook ? 6 : 1);
        const std::size_t affordable = std::size_t(seconds / (guess(how, slice) * double(problem.cells())));
        study.curves.push_back(
            {&how, precisions().front(),
             points_between(
                 how.is_explicit() ? limit : 8, std::max(how.is_explicit() ? 8 * limit : 64, affordable),
                 [&](std::size_t steps) { return seiches.expected_error(how, study.time, steps); }, 1e-3)});
    }
    return study;
}

// Shores that move and dams that break, in steps in which waves cross 32 cells and, halved again and again, down to a
// quarter of a cell or less; explicit ones from their limit on.
Study exact_study(const Report& report, const std::string& key, const std::string& title, const WaterProblem& problem,
                  double time, const std::vector<double>& exact, std::size_t steps_at_1, const std::vector<Way>& ways) {
    Study study;
    study.key = key;
    study.title = title;
    study.time = time;
    study.error = depth_error;
    study.tolerances = {1e-1, 1e-2, 1e-3};
    study.error_label = "error of the depth in L1, relative to the volume";
    study.make = runners_of(problem);
    study.exact = exact;
    const std::size_t stable = std::size_t(std::ceil(1.4 * study.time / stable_dt(problem)));
    for (Way way : ways)
        for (cd_precision precision : precisions()) {
            const Method& how = method(way);
            if (precision != precisions().front() && (way == Way::water_one || way == Way::water_explicit)) continue;
            study.curves.push_back(
                {&how, precision,
                 points_between(how.is_explicit() ? stable : std::max<std::size_t>(1, steps_at_1 / 32),
                                steps_at_1 * report.by_extent<std::size_t>(2, 4),
                                [](std::size_t) { return INFINITY; })});
        }
    return study;
}

Study thacker_study(const Report& report, std::size_t n) {
    return exact_study(report, "water.thacker", "Thacker, " + std::to_string(n) + " cells", Thacker::problem(n),
                       3 * Thacker::period(), Thacker::depth(n, 3 * Thacker::period()), Thacker::steps(n, 1),
                       {Way::water_linear, Way::water_one, Way::water_advected, Way::water_explicit,
                        Way::water_explicit_advected, Way::water_textbook, Way::water_textbook_put_back});
}

Study dam_study(const Report& report, const std::string& who, double right, std::size_t n) {
    const DamBreak dam(0.005, right);
    return exact_study(
        report, who == "Stoker" ? "water.stoker" : "water.ritter",
        who + "'s dam break, " + std::to_string(n) + " cells", dam.problem(n), DamBreak::kTime, dam.depths(n),
        dam.steps(n, 1),
        {Way::water_linear, Way::water_advected, Way::water_explicit_advected, Way::water_textbook_put_back});
}

void add(Report& report, WorkTables& tables, Study& study, std::vector<std::string>& panels,
         std::vector<Series>& series, std::vector<std::string>& findings) {
    measure(report, study);
    tables.add(report, study, study.title);
    panels.push_back(draw(study, "run time of " + number(study.time, 3) + " simulated seconds", series));
    const Best implicit = cheapest(study, 1e-2, Kind::implicit_steps),
               explicit_steps = cheapest(study, 1e-2, Kind::explicit_steps);
    findings.push_back(study.title + " " + verdict(implicit, explicit_steps));
}

} // namespace

void report_water_precision(Report& report) {
    report.page.section("water-precision", "Water: error against run time");
    report.page.paragraph(
        "Small waves in a pool 20 m long and 1 m deep with walls around, level and in motion at first and followed for "
        "12 s: a sum of two (slice) or four (pool) slow seiches, or one that runs aslant, " +
        si(small_height(), "m", 2) +
        " high so that nothing but the time step errs: the error is against the exact motion on the same cells. "
        "Thacker's planar oscillation: water in a parabola rocks as a plane surface, its two shores running up and "
        "down the banks, three times to and fro. And two dams that break, over water and over dry ground. In these "
        "the error is against the continuum, so that the cells err too. Explicit is velocity Verlet. The textbook is "
        "the water of the notes (Kass and Miller 1990) in plain loops: the surface at two moments, faces as deep as "
        "the mean of their cells, Numerical Recipes' elimination; with the volume that a step gained or lost put back "
        "evenly, or not.");
    WorkTables tables;
    std::vector<std::string> panels, findings;
    std::vector<Series> series;
    const std::size_t side = report.by_extent<std::size_t>(32, 64),
                      long_side = report.by_extent<std::size_t>(100, 400),
                      cells = report.by_extent<std::size_t>(100, 200);
    const double height = small_height();
    const std::vector<Way> of_pools = {Way::water_linear,   Way::water_half,     Way::water_one,
                                       Way::water_advected, Way::water_explicit, Way::water_textbook};
    std::vector<Way> of_slices = of_pools;
    of_slices.push_back(Way::water_forward);
    const std::string square = std::to_string(side) + " × " + std::to_string(side) + " cells";
    Study slice = seiche_study(report, "water.seiche", "seiche in a slice of " + std::to_string(long_side) + " cells",
                               long_side, 1, {{1, 0, height}, {2, 0, height / 2}}, of_slices);
    Study pool = seiche_study(report, "water.pool", "pool of " + square, side, side,
                              {{1, 0, height}, {1, 1, height}, {2, 1, height / 2}, {0, 2, height / 2}}, of_pools);
    Study aslant =
        seiche_study(report, "water.aslant", "slanting waves on " + square, side, side, {{2, 2, height}}, of_pools);
    Study thacker = thacker_study(report, cells);
    Study stoker = dam_study(report, "Stoker", 0.001, 2 * cells), ritter = dam_study(report, "Ritter", 0, 2 * cells);
    for (Study* study : {&slice, &pool, &aslant, &thacker, &stoker, &ritter})
        add(report, tables, *study, panels, series, findings);

    const Best one = cheapest(pool, 1e-2, Kind::implicit_steps), many = cheapest(pool, 1e-2, Kind::textbook),
               steps = cheapest(pool, 1e-2, Kind::explicit_steps);
    const double best = std::fmin(one.seconds(), steps.seconds());
    if (std::isfinite(best) && many)
        report.page.headline(si(best, "s", 2), "simulates 12 s of small waves in a " + pool.title + " to 1%; the " +
                                                   "notes' water in plain loops takes " + si(many.seconds(), "s", 2));
    std::vector<std::string> limits;
    for (Way way : {Way::water_linear, Way::water_advected, Way::water_textbook, Way::water_textbook_put_back}) {
        double least = INFINITY;
        for (const Curve& curve : thacker.curves)
            if (curve.how == &method(way))
                for (const Point& point : curve.points) least = std::fmin(least, point.error);
        report.summary("water.thacker.least_error." + method(way).key, least * 100, "%");
        limits.push_back(method(way).name + " " + percent(least, 2));
    }
    report.page.figure(
        panels, legend(series),
        "Cheapest to 1%: " + list_words(findings) +
            ". Left and down is better. λ = 1/2 is of second order in the step, λ = 0.55 and λ = 1 of first. With "
            "moving shores, how near a method comes to the exact depth at any step is " +
            list_words(limits) +
            ": the linear mode has no inertia beyond a face, and its shore follows late. The small waves are run in " +
            name_of(precisions().front()) +
            ": float32 would see the rounding of a depth ten million times their height.");
    report.page.table(tables.table,
                      "Water: the cheapest run that reaches each error. A run counts if all with shorter steps are as "
                      "good: none is taken for its luck.");
    report.save("water_work_precision.csv", tables.points);
    report.save("water_cheapest.csv", tables.cheapest);
}

} // namespace report
