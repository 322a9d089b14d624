#include "atlas.hpp"

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <map>
#include <set>

#include "format.hpp"

namespace report {
namespace {

const double kGrown = 3, kDamped = -1; // log10 of the energy's ratio
const double kSlack = 0.02;                         // what rounding may move it by

Fate fate_at(double highest, double last) {
    return highest >= kGrown ? Fate::growing : last <= kDamped ? Fate::damped : Fate::bounded;
}

const char* const kTextbook = "the stiffness is added to the mass, which is rounded away";

double thousandths(double value) { return std::round(value * 1e3) / 1e3; }

// Where, along y and with x fixed, theory's likeliest fate changes: to a fiftieth of a decade.
double border(const AtlasCase& chart, double x, double low, double high) {
    const Fate below = chart.theory(x, low).likeliest();
    while (high / low > 1.05) {
        const double middle = std::sqrt(low * high);
        (chart.theory(x, middle).likeliest() == below ? low : high) = middle;
    }
    return std::sqrt(low * high);
}

// Each change of fate of a column is joined to the nearest change of the same kind in the column before.
std::vector<std::vector<FateMap::Point>> limits_of(const AtlasCase& chart, const std::vector<Fate>& theory) {
    struct End {
        Fate below, above;
        double y;
        std::size_t line;
    };
    const double far = chart.x.values[1] / chart.x.values[0];  // steeper it is another line
    std::vector<std::vector<FateMap::Point>> lines;
    std::vector<End> before;
    const std::size_t columns = chart.x.values.size();
    for (std::size_t i = 0; i < columns; ++i) {
        std::vector<End> here;
        for (std::size_t j = 0; j + 1 < chart.y.values.size(); ++j) {
            const Fate below = theory[j * columns + i], above = theory[(j + 1) * columns + i];
            if (below == above) continue;
            const double y = border(chart, chart.x.values[i], chart.y.values[j], chart.y.values[j + 1]);
            auto distance = [y](const End& end) { return std::fabs(std::log(end.y / y)); };
            auto nearest = before.end();
            for (auto end = before.begin(); end != before.end(); ++end)
                if (end->below == below && end->above == above && distance(*end) < std::log(far) &&
                    (nearest == before.end() || distance(*end) < distance(*nearest)))
                    nearest = end;
            here.push_back({below, above, y, nearest == before.end() ? lines.size() : nearest->line});
            if (nearest == before.end()) lines.push_back({});
            else before.erase(nearest);
            lines[here.back().line].push_back({chart.x.values[i], y});
        }
        before = here;
    }
    return lines;
}

// The wrong cells of a chart in words: what is there instead of what, over which range.
std::string whereabouts(const AtlasCase& chart, const std::vector<Fate>& practice, const std::vector<Fate>& theory,
                        const std::vector<bool>& differs) {
    struct Range {
        std::size_t cells = 0;
        double x[2] = {INFINITY, 0}, y[2] = {INFINITY, 0};
    };
    std::map<std::pair<Fate, Fate>, Range> ranges;
    for (std::size_t k = 0; k < differs.size(); ++k) {
        if (!differs[k]) continue;
        const double x = chart.x.values[k % chart.x.values.size()], y = chart.y.values[k / chart.x.values.size()];
        Range& range = ranges[{practice[k], theory[k]}];
        ++range.cells;
        range.x[0] = std::fmin(range.x[0], x), range.x[1] = std::fmax(range.x[1], x);
        range.y[0] = std::fmin(range.y[0], y), range.y[1] = std::fmax(range.y[1], y);
    }
    std::vector<std::string> words;
    auto span = [](const double* range) {
        return range[0] == range[1] ? number(range[0], 2) : number(range[0], 2) + " to " + number(range[1], 2);
    };
    for (const auto& [fates, range] : ranges)
        words.push_back(count(double(range.cells)) + " " + name_of(fates.first) + " instead of " +
                        name_of(fates.second) + ", " + chart.x.label + " " + span(range.x) + ", " + chart.y.label +
                        " " + span(range.y));
    return list_words(words);
}

} // namespace

Fate fate_of(const Course& course) { return course.finite ? fate_at(course.highest, course.last) : Fate::not_finite; }

// Lost beyond the precision's range; within three decades of it, which nodes add up decides. Forces are in double.
Expected::Expected(const Course& course, cd_precision precision) {
    const double range = precision == CD_FLOAT32 ? FLT_MAX_10_EXP : DBL_MAX_10_EXP;
    if (course.largest > range) open_.push_back(Fate::not_finite);
    if (course.largest > range + 3) return;
    open_.push_back(fate_at(course.highest, course.last));
    if (course.largest > range - 3 || course.force > DBL_MAX_10_EXP - 3) open_.push_back(Fate::not_finite);
    for (double by : {-kSlack, kSlack}) open_.push_back(fate_at(course.highest + by, course.last + by));
}

bool Expected::allows(Fate fate) const { return std::find(open_.begin(), open_.end(), fate) != open_.end(); }

std::vector<double> decades(double first, double last, double step) {
    std::vector<double> values;
    for (double e = first; e <= last + 1e-9; e += step) values.push_back(std::pow(10, e));
    return values;
}

std::string Atlas::add(const AtlasCase& chart) {
    FateMap map;
    map.title = chart.how.name + ", " + name_of(chart.precision);
    map.x_label = chart.x.label, map.y_label = chart.y.label;
    map.x = chart.x.values, map.y = chart.y.values;
    std::vector<Fate> theory;
    std::size_t differ = 0, known = 0;
    std::set<std::string> reasons;
    for (double y : chart.y.values)
        for (double x : chart.x.values) {
            const Course course = chart.practice(x, y);
            const Expected expected = chart.theory(x, y);
            const Fate fate = fate_of(course);
            const bool agrees = expected.allows(fate);
            const std::string why = agrees || !chart.finding ? "" : chart.finding(x, y);
            map.fates.push_back(fate);
            map.differs.push_back(!agrees);
            theory.push_back(expected.likeliest());
            differ += !agrees;
            known += !why.empty();
            if (!agrees) reasons.insert(why);
            csv_.row(chart.object, chart.sweep, chart.how.key, name_of(chart.precision), int(chart.judged), x, y,
                     name_of(fate), name_of(expected.likeliest()), int(agrees), why, thousandths(course.highest),
                     thousandths(course.last));
        }
    map.limits = limits_of(chart, theory);
    if (differ)
        table_.rows.push_back({chart.sweep, chart.how.name, name_of(chart.precision), count(double(theory.size())),
                               count(double(differ)), whereabouts(chart, map.fates, theory, map.differs),
                               chart.judged ? list_words(reasons) : kTextbook});
    if (chart.judged) cells_ += theory.size(), differ_ += differ, known_ += known;
    report_.progress("atlas: " + chart.object + ", " + chart.sweep + ", " + map.title);
    return render(map);
}

std::string Atlas::agreement() const {
    const std::string where = precisions().size() > 1 ? ", in both precisions" : "";
    if (differ_ == 0) return "all " + count(double(cells_)) + " cells are as theory has them" + where;
    return count(double(cells_ - differ_)) + " of " + count(double(cells_)) + " cells are as theory has them" + where;
}

void Atlas::finish() {
    if (!table_.rows.empty())
        report_.page.table(table_, "Every cell where practice and theory differ. One by one they stand in " + object_ +
                                       "_atlas.csv, with agrees = 0.");
    report_.save(object_ + "_atlas.csv", csv_);
    report_.summary(object_ + ".atlas.cells", double(cells_), "cells");
    report_.summary(object_ + ".atlas.differ_from_theory", double(differ_), "cells");
    report_.summary(object_ + ".atlas.differ_unexplained", double(differ_ - known_), "cells");
}

} // namespace report
