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

std::string fill_of(Fate fate) { return "fill:var(--f" + std::to_string(int(fate)) + ")"; }

std::string box(double x, double y, double width, double height, const std::string& style) {
    return "<rect" + attribute("x", px(x)) + attribute("y", px(y)) + attribute("width", px(width)) +
           attribute("height", px(height)) + attribute("shape-rendering", "crispEdges") + attribute("style", style) +
           "/>\n";
}

std::string cross_at(double x, double y, double r) {
    return "<path" + attribute("class", "odd") +
           attribute("d", "M" + px(x - r) + " " + px(y - r) + "L" + px(x + r) + " " + px(y + r) + "M" + px(x - r) +
                              " " + px(y + r) + "L" + px(x + r) + " " + px(y - r)) +
           "/>\n";
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
    for (std::size_t j = 0; j < map.y.size(); ++j)
        for (std::size_t i = 0, end; i < columns; i = end) { // a box for a run of cells alike
            const Fate fate = map.fates[j * columns + i];
            for (end = i + 1; end < columns && map.fates[j * columns + end] == fate;) ++end;
            svg += box(x.at(map.x[i]) - x.cell() / 2, y.at(map.y[j]) - y.cell() / 2, x.cell() * double(end - i) + 0.3,
                       y.cell() + 0.3, fill_of(fate));
        }
    for (std::size_t k = 0; k < map.differs.size(); ++k)
        if (map.differs[k])
            svg += cross_at(x.at(map.x[k % columns]), y.at(map.y[k / columns]), std::min(x.cell(), y.cell()) * 0.35);
    for (const std::vector<FateMap::Point>& limit : map.limits) {
        std::string d;
        for (std::size_t i = 0; i < limit.size(); ++i)
            d += (i ? "L" : "M") + px(x.at(limit[i].x)) + " " + px(y.at(limit[i].y));
        svg += "<path" + attribute("class", "limit") + attribute("d", d) + "/>\n";
    }
    for (int e : x.ticks(7)) svg += text_at(x.at(std::pow(10, e)), bottom + 16, "tick", "middle", power_of_ten(e));
    for (int e : y.ticks(7)) svg += text_at(left - 5, y.at(std::pow(10, e)) + 4, "tick", "end", power_of_ten(e));
    return svg + text_at((left + right) / 2, map.height - 8, "axis", "middle", map.x_label) + "</svg>\n";
}

std::string fate_legend() {
    std::string html = "<ul class=\"legend\">\n";
    auto item = [&](const std::string& drawing, const std::string& name) {
        html += "<li><svg viewBox=\"0 0 34 14\" aria-hidden=\"true\">" + drawing + "</svg>" + name + "</li>\n";
    };
    for (Fate fate : {Fate::bounded, Fate::damped, Fate::growing, Fate::not_finite})
        item(box(4, 1, 26, 12, fill_of(fate)), name_of(fate));
    item("<path class=\"limit\" d=\"M1 7L33 7\"/>", "theory's limit");
    item(box(4, 1, 26, 12, fill_of(Fate::bounded)) + cross_at(17, 7, 4), "differs from theory");
    return html + "</ul>\n";
}

} // namespace report
