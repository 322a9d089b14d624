#include "work_precision.hpp"

#include <algorithm>
#include <cmath>

#include "format.hpp"
#include "modes.hpp"
#include "timing.hpp"

namespace report {

const std::vector<double>& tolerances() {
    static const std::vector<double> kTolerances = {1e-1, 1e-2, 1e-3, 1e-4};
    return kTolerances;
}

std::vector<Point> points_between(std::size_t least, std::size_t most,
                                  const std::function<double(std::size_t)>& expected_error, double least_tolerance) {
    std::vector<std::size_t> numbers;
    for (std::size_t steps = least; steps <= most; steps *= 2) numbers.push_back(steps);
    for (double tolerance : tolerances()) {
        if (tolerance < least_tolerance) continue;
        std::size_t steps = fewest_steps(expected_error, 0.995 * tolerance, most);
        if (steps <= most && steps >= least) numbers.push_back(steps);
    }
    std::sort(numbers.begin(), numbers.end());
    numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
    std::vector<Point> points;
    for (std::size_t steps : numbers) points.push_back({steps});
    return points;
}

void measure(Report& report, Study& study) {
    std::vector<std::unique_ptr<Runner>> runners;
    std::vector<Job> jobs;
    std::vector<Point*> targets;
    for (Curve& curve : study.curves) {
        runners.push_back(study.make(*curve.how, curve.precision));
        Runner* runner = runners.back().get();
        for (Point& point : curve.points) {
            const std::size_t steps = point.steps;
            const double dt = study.time / double(steps);
            runner->reset();
            const double start = now();
            bool finite = runner->step(dt, steps);
            const double first = now() - start;
            point.error = finite ? study.error(runner->positions(), study.exact) : INFINITY;
            point.hash = runner->hash();
            report.outcome(study.key + " " + curve.how->key + " " + name_of(curve.precision) + " " +
                               std::to_string(steps), hex(point.hash));
            jobs.push_back({[runner] { runner->reset(); }, [=] { runner->step(dt, steps); }, first});
            targets.push_back(&point);
        }
        report.progress(study.key + ": errors of " + curve.name());
    }
    report.progress(study.key + ": timing " + std::to_string(jobs.size()) + " runs in turns");
    time_in_turns(jobs, report.by_extent(1e-3, 0.02), report.by_extent<std::size_t>(1, 3),
                  report.by_extent<std::size_t>(5, 31));
    for (std::size_t i = 0; i < jobs.size(); ++i) {
        targets[i]->least_seconds = jobs[i].least();
        targets[i]->median_seconds = jobs[i].median();
        targets[i]->quartile_seconds = jobs[i].upper_quartile();
        targets[i]->spread = jobs[i].spread();
    }
}

const Point* find_point(const Study& study, Way way, std::size_t steps) {
    for (const Curve& curve : study.curves)
        for (const Point& point : curve.points)
            if (curve.how == &method(way) && point.steps == steps) return &point;
    return nullptr;
}

double Best::seconds() const { return point ? point->least_seconds : NAN; }

std::string Best::text() const {
    if (!point) return "not reached";
    return si(point->least_seconds, "s") + spread_words(point->spread) + ": " + curve->name() + ", " +
           count(double(point->steps)) + " steps";
}

// By luck a coarse run may come near the exact answer: all finer ones must be about as good.
static bool reaches(const Curve& curve, std::size_t at, double tolerance) {
    for (std::size_t i = at + 1; i < curve.points.size(); ++i)
        if (!(curve.points[i].error <= 2 * tolerance)) return false;
    return curve.points[at].error <= tolerance;
}

Best cheapest(const Study& study, double tolerance, Kind kind) {
    Best best;
    for (const Curve& curve : study.curves) {
        Kind its = curve.how->textbook ? Kind::textbook
                   : curve.how->is_explicit() ? Kind::explicit_steps : Kind::implicit_steps;
        if (its != kind) continue;
        for (std::size_t i = 0; i < curve.points.size(); ++i)
            if (reaches(curve, i, tolerance) && (!best || curve.points[i].least_seconds < best.seconds()))
                best = {&curve, &curve.points[i]};
    }
    return best;
}

std::string verdict(const Best& implicit, const Best& explicit_steps) {
    if (!implicit && !explicit_steps) return "neither";
    if (!explicit_steps) return "implicit alone gets there";
    if (!implicit) return "explicit alone gets there";
    double ratio = explicit_steps.seconds() / implicit.seconds();
    return ratio >= 1 ? "implicit, " + number(ratio, 2) + "× cheaper"
                      : "explicit, " + number(1 / ratio, 2) + "× cheaper";
}

std::string against_textbook(const Best& implicit, const Best& explicit_steps, const Best& textbook) {
    double library = std::fmin(implicit.seconds(), explicit_steps.seconds());
    if (!textbook) return std::isnan(library) ? "neither" : "library alone gets there";
    if (std::isnan(library)) return "textbook alone gets there";
    double ratio = textbook.seconds() / library;
    return ratio >= 1 ? "library, " + number(ratio, 2) + "× cheaper"
                      : "textbook, " + number(1 / ratio, 2) + "× cheaper";
}

std::string draw(const Study& study, const std::string& time_label, std::vector<Series>& for_legend) {
    Plot plot;
    plot.title = study.title;
    plot.x = {study.error_label, Scale::log, "", NAN, 1.5};
    plot.y = {time_label, Scale::log, "s"};
    for (const Curve& curve : study.curves) {
        Series series;
        series.name = curve.name();
        series.style = style_of(*curve.how, curve.precision);
        for (const Point& point : curve.points) {
            if (!(point.error <= 1.5)) continue;
            series.x.push_back(point.error);
            series.y.push_back(point.least_seconds);
            series.tips.push_back(count(double(point.steps)) + " steps: error " + number(point.error, 2) + ", " +
                                  si(point.least_seconds, "s") + spread_words(point.spread));
        }
        if (!series.x.empty()) plot.series.push_back(series);
    }
    for (double tolerance : study.tolerances)
        plot.guides.push_back({tolerance, NAN, tolerance, NAN, percent(tolerance, 1)});
    for_legend.insert(for_legend.end(), plot.series.begin(), plot.series.end());
    return render(plot);
}

void WorkTables::add(Report& report, const Study& study, const std::string& case_name) {
    for (const Curve& curve : study.curves)
        for (const Point& p : curve.points)
            points.row(study.key, curve.how->key, name_of(curve.precision), int(curve.how->textbook), p.steps,
                       study.time / double(p.steps), p.error, p.least_seconds, p.median_seconds,
                       p.quartile_seconds, hex(p.hash));
    auto name = [](const Best& b) { return b ? b.curve->how->key + " " + name_of(b.curve->precision) : "none"; };
    auto steps = [](const Best& b) { return b ? b.point->steps : std::size_t(0); };
    for (double tolerance : study.tolerances) {
        Best implicit = report::cheapest(study, tolerance, Kind::implicit_steps);
        Best explicit_steps = report::cheapest(study, tolerance, Kind::explicit_steps);
        Best textbook = report::cheapest(study, tolerance, Kind::textbook);
        table.rows.push_back({case_name, percent(tolerance, 1), implicit.text(), explicit_steps.text(),
                              verdict(implicit, explicit_steps),
                              textbook.text(), against_textbook(implicit, explicit_steps, textbook)});
        cheapest.row(study.key, tolerance, name(implicit), steps(implicit), implicit.seconds(), name(explicit_steps),
                     steps(explicit_steps), explicit_steps.seconds(), name(textbook), steps(textbook),
                     textbook.seconds());
        std::string key = study.key + ".at_" + plain(tolerance * 100) + "_percent";
        if (implicit && explicit_steps)
            report.summary(key + ".explicit_over_implicit", explicit_steps.seconds() / implicit.seconds(), "times");
        if (implicit && textbook)
            report.summary(key + ".textbook_over_library",
                           textbook.seconds() / std::fmin(implicit.seconds(), explicit_steps.seconds()), "times");
    }
}

}  // namespace report
