#include "plot.hpp"

#include <algorithm>
#include <set>

#include "format.hpp"
#include "svg.hpp"

namespace report {
namespace {

std::string line_at(const char* kind, double x0, double y0, double x1, double y1) {
    return "<line" + attribute("class", kind) + attribute("x1", px(x0)) + attribute("y1", px(y0)) +
           attribute("x2", px(x1)) + attribute("y2", px(y1)) + "/>\n";
}

std::string dash_of(Dash dash) {
    return dash == Dash::dashed ? ";stroke-dasharray:6 4" : dash == Dash::dotted ? ";stroke-dasharray:1.5 4" : "";
}

std::string marker_at(const Style& style, double x, double y, const std::string& tip) {
    const double r = 3.6;
    std::string points;
    auto corner = [&](double dx, double dy) { points += px(x + dx * r) + "," + px(y + dy * r) + " "; };
    bool strokes = style.marker == Marker::cross || style.marker == Marker::plus;
    std::string fill = strokes ? "none" : style.hollow ? "var(--bg)" : colour(style.colour);
    std::string look = attribute("style", "fill:" + fill + ";stroke:" + colour(style.colour) + ";stroke-width:1.5");
    std::string inner = tip.empty() ? "" : "<title>" + escape(tip) + "</title>";
    auto closed = [&](const char* element, const std::string& geometry) {
        return std::string("<") + element + look + geometry + ">" + inner + "</" + element + ">\n";
    };
    switch (style.marker) {
    case Marker::none: return "";
    case Marker::circle:
        return closed("circle", attribute("cx", px(x)) + attribute("cy", px(y)) + attribute("r", px(r)));
    case Marker::square: corner(-.9, -.9), corner(.9, -.9), corner(.9, .9), corner(-.9, .9); break;
    case Marker::diamond: corner(0, -1.3), corner(1.3, 0), corner(0, 1.3), corner(-1.3, 0); break;
    case Marker::triangle: corner(0, -1.2), corner(1.15, .85), corner(-1.15, .85); break;
    case Marker::wedge: corner(0, 1.2), corner(1.15, -.85), corner(-1.15, -.85); break;
    case Marker::cross:
        return closed("path",
                      attribute("d", "M" + px(x - r) + " " + px(y - r) + "L" + px(x + r) + " " + px(y + r) + "M" +
                                         px(x - r) + " " + px(y + r) + "L" + px(x + r) + " " + px(y - r)));
    case Marker::plus:
        return closed("path", attribute("d", "M" + px(x - r) + " " + px(y) + "L" + px(x + r) + " " + px(y) + "M" +
                                                 px(x) + " " + px(y - r) + "L" + px(x) + " " + px(y + r)));
    }
    return closed("polygon", attribute("points", points));
}

// One axis laid out between two pixels: range, ticks, labels.
struct Ruler {
    Axis axis;
    double lo = 0, hi = 1, from = 0, to = 1;
    struct Tick {
        double value;
        std::string label;  // empty: a minor tick
    };
    std::vector<Tick> ticks;

    bool is_log() const { return axis.scale == Scale::log; }
    bool holds(double v) const { return std::isfinite(v) && (!is_log() || v > 0); }
    double at(double v) const {
        double t = is_log() ? std::log(v / lo) / std::log(hi / lo) : (v - lo) / (hi - lo);
        return from + t * (to - from);
    }
    std::string text(double v) const {
        if (!is_log() && std::fabs(v) < 1e-9 * (hi - lo)) v = 0;  // not -0
        if (axis.unit == "%") return v == 0 ? "0" : plain(std::round(v * 1e12) / 1e10) + "%";
        if (!axis.unit.empty()) {
            std::string label = si(v, axis.unit, 3);  // strip the zeros of 1.00 and 20.0
            std::size_t point = label.find('.'), space = label.find("\u00a0");
            if (point != std::string::npos && space != std::string::npos) {
                std::size_t last = label.find_last_not_of('0', space - 1);
                label.erase(last == point ? point : last + 1, space - (last == point ? point : last + 1));
            }
            return label;
        }
        if (is_log() && std::fabs(std::log10(v) - std::round(std::log10(v))) < 1e-9)
            return power_of_ten(int(std::lround(std::log10(v))));
        std::string label = plain(std::round(v * 1e9) / 1e9);
        return label[0] == '-' ? "−" + label.substr(1) : label;
    }

    void fit(double data_lo, double data_hi) {
        if (!(data_lo <= data_hi)) data_lo = is_log() ? 1 : 0, data_hi = is_log() ? 10 : 1;
        if (is_log()) {
            double pad = std::pow(data_hi / data_lo, 0.04) * 1.02;
            lo = std::isnan(axis.lo) ? data_lo / pad : axis.lo;
            hi = std::isnan(axis.hi) ? data_hi * pad : axis.hi;
            if (hi / lo < 1.5) lo /= 1.5, hi *= 1.5;
        } else {
            double pad = data_hi > data_lo ? 0.05 * (data_hi - data_lo) : 0.5 * std::fabs(data_hi) + 1e-12;
            lo = std::isnan(axis.lo) ? data_lo - pad : axis.lo;
            hi = std::isnan(axis.hi) ? data_hi + pad : axis.hi;
        }
    }

    void make_ticks(int wanted) {
        ticks.clear();
        if (!is_log()) {
            double raw = (hi - lo) / wanted, unit = std::pow(10, std::floor(std::log10(raw)));
            double step = raw / unit < 1.5   ? unit
                          : raw / unit < 3.5 ? 2 * unit
                          : raw / unit < 7.5 ? 5 * unit
                                             : 10 * unit;
            for (double k = std::ceil(lo / step - 1e-9); k * step <= hi + 1e-9 * step; ++k)
                ticks.push_back({k * step, text(k * step)});
            return;
        }
        int first = int(std::floor(std::log10(lo) - 1e-9)), last = int(std::ceil(std::log10(hi) + 1e-9));
        int inside = int(std::floor(std::log10(hi) + 1e-9)) - int(std::ceil(std::log10(lo) - 1e-9)) + 1;
        int every = std::max(1, int(std::ceil(inside / double(wanted + 2))));
        for (int e = first; e <= last; ++e) {
            bool labelled = ((e % every) + every) % every == 0;
            for (int d = 1; d <= (every == 1 && inside < 8 ? 9 : 1); ++d) {
                double v = d * std::pow(10.0, e);
                if (v < lo * (1 - 1e-9) || v > hi * (1 + 1e-9)) continue;
                bool named = d == 1 ? labelled : inside < 2 && (d == 2 || d == 5);
                ticks.push_back({v, named ? text(v) : std::string()});
            }
        }
    }
};

void widen(double& lo, double& hi, const Ruler& ruler, double v) {
    if (!ruler.holds(v)) return;
    lo = std::min(lo, v);
    hi = std::max(hi, v);
}

int clip_number = 0;

std::string path_of(const Series& series, const Ruler& x, const Ruler& y) {
    std::string d;
    bool pen_down = false;
    for (std::size_t i = 0; i < series.x.size(); ++i) {
        bool here = x.holds(series.x[i]) && y.holds(series.y[i]);
        if (here) d += (pen_down ? "L" : "M") + px(x.at(series.x[i])) + " " + px(y.at(series.y[i]));
        pen_down = here;
    }
    return d;
}

// An upright guide is named above the frame, where no curve runs.
bool is_upright(const Guide& guide) { return guide.x0 == guide.x1; }

std::string draw_guide(const Guide& guide, const Ruler& x, const Ruler& y) {
    double x0 = std::isnan(guide.x0) ? x.from : x.at(guide.x0), x1 = std::isnan(guide.x1) ? x.to : x.at(guide.x1);
    double y0 = std::isnan(guide.y0) ? y.from : y.at(guide.y0), y1 = std::isnan(guide.y1) ? y.to : y.at(guide.y1);
    std::string svg = line_at("guide", x0, y0, x1, y1);
    if (guide.label.empty()) return svg;
    return svg + (is_upright(guide) ? text_at(x1, y.to - 6, "note", "middle", guide.label)
                                    : text_at(x1 - 4, y1 - 5, "note", "end", guide.label));
}

}  // namespace

std::string render(const Plot& plot) {
    Ruler x, y;
    x.axis = plot.x;
    y.axis = plot.y;
    double x_lo = INFINITY, x_hi = -INFINITY, y_lo = INFINITY, y_hi = -INFINITY;
    for (const Series& s : plot.series)
        for (std::size_t i = 0; i < s.x.size(); ++i)
            if (x.holds(s.x[i]) && y.holds(s.y[i])) widen(x_lo, x_hi, x, s.x[i]), widen(y_lo, y_hi, y, s.y[i]);
    x.fit(x_lo, x_hi);
    y.fit(y_lo, y_hi);
    y.make_ticks(5);
    std::size_t longest = 0;  // in characters, UTF-8 continuation bytes apart
    for (const Ruler::Tick& tick : y.ticks)
        longest = std::max(longest, std::size_t(std::count_if(tick.label.begin(), tick.label.end(),
                                                              [](char c) { return (c & 0xc0) != 0x80; })));
    x.from = 12 + 7.6 * double(longest), x.to = plot.width - 14;
    y.from = plot.height - 46;
    y.to = std::any_of(plot.guides.begin(), plot.guides.end(), is_upright) ? 60 : 46;
    x.make_ticks(5);

    std::string svg = open_svg(plot.width, plot.height, plot.title);
    svg += text_at(2, 15, "title", "start", plot.title) + text_at(2, 34, "axis", "start", plot.y.label);
    svg += text_at((x.from + x.to) / 2, plot.height - 8, "axis", "middle", plot.x.label);
    for (const Ruler::Tick& t : x.ticks) {
        svg += line_at(t.label.empty() ? "minor" : "grid", x.at(t.value), y.from, x.at(t.value), y.to);
        if (!t.label.empty()) svg += text_at(x.at(t.value), y.from + 17, "tick", "middle", t.label);
    }
    for (const Ruler::Tick& t : y.ticks) {
        svg += line_at(t.label.empty() ? "minor" : "grid", x.from, y.at(t.value), x.to, y.at(t.value));
        if (!t.label.empty()) svg += text_at(x.from - 6, y.at(t.value) + 4, "tick", "end", t.label);
    }
    svg += line_at("frame", x.from, y.from, x.to, y.from);
    for (const Guide& guide : plot.guides) svg += draw_guide(guide, x, y);
    std::string clip = "clip" + std::to_string(++clip_number);
    svg += "<clipPath" + attribute("id", clip) + "><rect" + attribute("x", px(x.from - 5)) +
           attribute("y", px(y.to - 5)) + attribute("width", px(x.to - x.from + 10)) +
           attribute("height", px(y.from - y.to + 10)) + "/></clipPath>\n<g" +
           attribute("clip-path", "url(#" + clip + ")") + ">\n";
    for (const Series& s : plot.series)
        if (s.style.line)
            svg += "<path" + attribute("d", path_of(s, x, y)) +
                   attribute("style", "fill:none;stroke:" + colour(s.style.colour) + ";stroke-width:" +
                                          px(s.style.width) + ";stroke-linejoin:round" + dash_of(s.style.dash)) +
                   "/>\n";
    for (const Series& s : plot.series)
        for (std::size_t i = 0; i < s.x.size(); ++i)
            if (x.holds(s.x[i]) && y.holds(s.y[i]))
                svg += marker_at(s.style, x.at(s.x[i]), y.at(s.y[i]), i < s.tips.size() ? s.tips[i] : "");
    return svg + "</g>\n</svg>\n";
}

std::string render(const HeatMap& map) {
    double left = map.row_label_width, top = 44;
    double width = left + map.cell_width * double(map.columns.size()) + 4;
    double height = top + map.cell_height * double(map.rows.size()) + (map.x_label.empty() ? 42 : 56);
    std::string svg = open_svg(width, height, map.title);
    svg += text_at(2, 15, "title", "start", map.title) + text_at(2, 34, "axis", "start", map.y_label);
    for (std::size_t r = 0; r < map.rows.size(); ++r) {
        double y = top + map.cell_height * double(r), middle = y + map.cell_height / 2 + 4;
        svg += text_at(left - 8, middle, "tick", "end", map.rows[r]);
        for (std::size_t c = 0; c < map.columns.size(); ++c) {
            std::size_t k = r * map.columns.size() + c;
            double x = left + map.cell_width * double(c), shade = std::min(1.0, std::max(0.0, map.shade[k]));
            svg += "<g>" + (k < map.tips.size() ? "<title>" + escape(map.tips[k]) + "</title>" : std::string());
            svg += "<rect" + attribute("x", px(x + 1)) + attribute("y", px(y + 1)) +
                   attribute("width", px(map.cell_width - 2)) + attribute("height", px(map.cell_height - 2)) +
                   attribute("rx", "2") +
                   attribute("style", "fill:var(--heat);fill-opacity:" + px(0.06 + 0.94 * shade)) + "/>\n";
            svg += text_at(x + map.cell_width / 2, middle, shade > 0.55 ? "cell hot" : "cell", "middle", map.cells[k]) +
                   "</g>\n";
        }
    }
    for (std::size_t c = 0; c < map.columns.size(); ++c) {
        double x = left + map.cell_width * (double(c) + 0.5);
        std::size_t cut = std::min(map.columns[c].find('\n'), map.columns[c].size());
        svg +=
            text_at(x, height - 25 - (map.x_label.empty() ? 0 : 14), "tick", "middle", map.columns[c].substr(0, cut));
        if (cut < map.columns[c].size())
            svg += text_at(x, height - 10 - (map.x_label.empty() ? 0 : 14), "tick", "middle",
                           map.columns[c].substr(cut + 1));
    }
    svg += text_at(left + map.cell_width * double(map.columns.size()) / 2, height - 6, "axis", "middle", map.x_label);
    return svg + "</svg>\n";
}

std::string render(const Picture& picture) {
    double scale = picture.width / (picture.x1 - picture.x0), top = picture.title.empty() ? 4 : 26;
    double height = scale * (picture.y1 - picture.y0) + top;
    auto x_of = [&](double x) { return (x - picture.x0) * scale; };
    auto y_of = [&](double y) { return top + (picture.y1 - y) * scale; };
    std::string svg = open_svg(picture.width, height, picture.title) + text_at(2, 15, "title", "start", picture.title);
    for (const Polyline& line : picture.lines) {
        std::string d;
        for (std::size_t i = 0; i < line.x.size(); ++i)
            d += (i ? "L" : "M") + px(x_of(line.x[i])) + " " + px(y_of(line.y[i]));
        svg +=
            "<path" + attribute("d", d) +
            attribute("style", "fill:none;stroke:" + colour(line.colour) + ";stroke-opacity:" + px(line.opacity) +
                                   ";stroke-width:" + px(line.width) + ";stroke-linejoin:round;stroke-linecap:round") +
            "/>\n";
    }
    for (const Dot& dot : picture.dots)
        svg += "<circle" + attribute("cx", px(x_of(dot.x))) + attribute("cy", px(y_of(dot.y))) +
               attribute("r", px(dot.radius)) + attribute("style", "fill:" + colour(dot.colour)) + "/>\n";
    for (const Label& label : picture.labels)
        svg += text_at(x_of(label.x), y_of(label.y), "note", label.anchor, label.text);
    return svg + "</svg>\n";
}

std::string legend(const std::vector<Series>& series) {
    std::string html = "<ul class=\"legend\">\n";
    std::set<std::string> seen;
    for (const Series& s : series) {
        if (s.name.empty() || !seen.insert(s.name).second) continue;
        html += "<li><svg viewBox=\"0 0 34 14\" aria-hidden=\"true\">";
        if (s.style.line)
            html += "<path d=\"M1 7L33 7\"" +
                    attribute("style", "fill:none;stroke:" + colour(s.style.colour) + ";stroke-width:2" +
                                           dash_of(s.style.dash)) + "/>";
        html += marker_at(s.style, 17, 7, "") + "</svg>" + escape(s.name) + "</li>\n";
    }
    return html + "</ul>\n";
}

}  // namespace report
