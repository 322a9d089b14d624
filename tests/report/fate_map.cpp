#include "fate_map.hpp"

#include <algorithm>
#include <cmath>

#include "format.hpp"
#include "svg.hpp"

namespace report {

const char* name_of(Fate fate) {
    static const char* const kNames[] = {"bounded", "damped", "growing", "not finite"};
    return kNames[int(fate)];
}

namespace {

const int kFates = 4;

// A stroke as wide as the row of cells that it runs along.
std::string band(Fate fate, double width, const Pen& pen) {
    if (pen.text().empty()) return "";
    return "<path" + attribute("class", "f" + std::to_string(int(fate))) + attribute("stroke-width", px(width)) +
           attribute("d", pen.text()) + "/>\n";
}

void add_cross(Pen& pen, double x, double y, double r) {
    pen.move(x - r, y - r), pen.line(x + r, y + r);
    pen.move(x - r, y + r), pen.line(x + r, y - r);
}

std::string path_of(const char* kind, const Pen& pen) {
    return pen.text().empty() ? "" : "<path" + attribute("class", kind) + attribute("d", pen.text()) + "/>\n";
}

// One logarithmic axis between two pixels, cells centred on its values.
struct Scale {
    double first, last, half, from, to; // of the logarithms

    Scale(const std::vector<double>& values, double from, double to)
        : first(std::log10(values.front())), last(std::log10(values.back())), half(0), from(from), to(to) {
        half = (last - first) / (2 * double(values.size() - 1));
    }
    double at(double value) const {
        return from + (std::log10(value) - first + half) / (last - first + 2 * half) * (to - from);
    }
    double cell() const { return std::fabs(to - from) * 2 * half / (last - first + 2 * half); }
    std::vector<int> ticks(int wanted) const {
        int every = 1;
        while ((last - first) / every > wanted) every += every < 3 ? 1 : 3;
        std::vector<int> found;
        for (int e = int(std::ceil(first / every - 1e-9)) * every; e <= last + 1e-9; e += every) found.push_back(e);
        return found;
    }
};

} // namespace

std::string render(const FateMap& map) {
    const double left = 44, right = map.width - 8, top = 42, bottom = map.height - 42;
    const Scale x(map.x, left, right), y(map.y, bottom, top);
    std::string svg = open_svg(map.width, map.height, map.title);
    svg += text_at(2, 15, "title", "start", map.title) + text_at(2, 34, "axis", "start", map.y_label);
    const std::size_t columns = map.x.size();
    Pen bands[kFates] = {Pen(0.5), Pen(0.5), Pen(0.5), Pen(0.5)}, crosses(0.5), limits;
    const auto number_of = [&](int fate) { return std::count(map.fates.begin(), map.fates.end(), Fate(fate)); };
    int usual = 0;  // what most cells are is drawn once, below the others
    for (int fate = 1; fate < kFates; ++fate)
        if (number_of(fate) > number_of(usual)) usual = fate;
    Pen all;
    all.move(left, (top + bottom) / 2), all.line(right, (top + bottom) / 2);
    svg += band(Fate(usual), bottom - top, all);
    for (std::size_t j = 0; j < map.y.size(); ++j)
        for (std::size_t i = 0, end; i < columns; i = end) { // a stroke for a run of cells alike
            const Fate fate = map.fates[j * columns + i];
            for (end = i + 1; end < columns && map.fates[j * columns + end] == fate;) ++end;
            if (int(fate) == usual) continue;
            const double from = x.at(map.x[i]) - x.cell() / 2;
            bands[int(fate)].move(from, y.at(map.y[j]));
            bands[int(fate)].line(from + x.cell() * double(end - i) + 0.6, y.at(map.y[j]));
        }
    for (int fate = 0; fate < kFates; ++fate) svg += band(Fate(fate), y.cell() + 0.6, bands[fate]);
    for (std::size_t k = 0; k < map.differs.size(); ++k)
        if (map.differs[k])
            add_cross(crosses, x.at(map.x[k % columns]), y.at(map.y[k / columns]),
                      std::min(x.cell(), y.cell()) * 0.35);
    for (const std::vector<FateMap::Point>& limit : map.limits) {
        std::vector<std::pair<double, double>> points;
        for (const FateMap::Point& point : limit) points.push_back({x.at(point.x), y.at(point.y)});
        limits.polyline(points);
    }
    svg += path_of("odd", crosses) + path_of("limit", limits);
    Labels below("tick", "middle"), beside("tick", "end");
    for (int e : x.ticks(7)) below.add(x.at(std::pow(10, e)), bottom + 16, power_of_ten(e));
    for (int e : y.ticks(7)) beside.add(left - 5, y.at(std::pow(10, e)) + 4, power_of_ten(e));
    return svg + below.svg() + beside.svg() +
           text_at((left + right) / 2, map.height - 8, "axis", "middle", map.x_label) + "</svg>\n";
}

std::string fate_legend() {
    std::string html = "<ul class=\"legend\">\n";
    auto item = [&](const std::string& drawing, const std::string& name) {
        html += "<li><svg viewBox=\"0 0 34 14\" aria-hidden=\"true\">" + drawing + "</svg>" + name + "</li>\n";
    };
    Pen swatch, cross;
    swatch.move(4, 7), swatch.line(30, 7);
    add_cross(cross, 17, 7, 4);
    for (int fate = 0; fate < kFates; ++fate) item(band(Fate(fate), 12, swatch), name_of(Fate(fate)));
    item("<path class=\"limit\" d=\"M1 7h32\"/>", "theory's limit");
    item(band(Fate::bounded, 12, swatch) + path_of("odd", cross), "differs from theory");
    return html + "</ul>\n";
}

} // namespace report
