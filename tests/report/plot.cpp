#include "plot.hpp"

#include <algorithm>
#include <set>

#include "format.hpp"
#include "svg.hpp"

namespace report {
namespace {

void straight(Pen& pen, double x0, double y0, double x1, double y1) { pen.move(x0, y0), pen.line(x1, y1); }

std::string path_at(const std::string& kind, const Pen& pen) {
    return pen.text().empty() ? "" : "<path" + attribute("class", kind) + attribute("d", pen.text()) + "/>\n";
}

std::string line_class(const Style& style) {
    const char* dash = style.dash == Dash::dashed ? " dash" : style.dash == Dash::dotted ? " dots" : "";
    return "line " + stroke_class(style.colour) + dash;
}

// What all markers of a style share; they stand between this and "</g>".
std::string open_markers(const Style& style) {
    const bool strokes = style.marker == Marker::cross || style.marker == Marker::plus;
    const std::string fill = strokes ? "none" : style.hollow ? "hollow" : fill_class(style.colour);
    return "<g" + attribute("class", "mark " + fill + " " + stroke_class(style.colour)) + ">";
}

std::string marker_at(Marker marker, double x, double y, const std::string& tip) {
    const double r = 3.6;
    auto element = [&](const std::string& name, const std::string& geometry) {
        if (tip.empty()) return "<" + name + geometry + "/>";
        return "<" + name + geometry + "><title>" + escape(tip) + "</title></" + name + ">\n";
    };
    Pen pen;
    auto outline = [&](const std::vector<std::pair<double, double>>& corners) {
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const double at_x = x + corners[i].first * r, at_y = y + corners[i].second * r;
            i ? pen.line(at_x, at_y) : pen.move(at_x, at_y);
        }
        pen.close();
    };
    switch (marker) {
    case Marker::none: return "";
    case Marker::circle:
        return element("circle", attribute("cx", px(x)) + attribute("cy", px(y)) + attribute("r", px(r)));
    case Marker::square: outline({{-.9, -.9}, {.9, -.9}, {.9, .9}, {-.9, .9}}); break;
    case Marker::diamond: outline({{0, -1.3}, {1.3, 0}, {0, 1.3}, {-1.3, 0}}); break;
    case Marker::triangle: outline({{0, -1.2}, {1.15, .85}, {-1.15, .85}}); break;
    case Marker::wedge: outline({{0, 1.2}, {1.15, -.85}, {-1.15, -.85}}); break;
    case Marker::cross: straight(pen, x - r, y - r, x + r, y + r), straight(pen, x - r, y + r, x + r, y - r); break;
    case Marker::plus: straight(pen, x - r, y, x + r, y), straight(pen, x, y - r, x, y + r); break;
    }
    return element("path", attribute("d", pen.text()));
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
            for (int d : {1, 2, 5}) {
                if (d > 1 && (every > 1 || inside >= 8)) break;
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

Pen line_of(const Series& series, const Ruler& x, const Ruler& y) {
    Pen pen;
    std::vector<std::pair<double, double>> points;
    for (std::size_t i = 0; i < series.x.size(); ++i) {
        if (x.holds(series.x[i]) && y.holds(series.y[i])) {
            points.push_back({x.at(series.x[i]), y.at(series.y[i])});
        } else {
            pen.polyline(points);
            points.clear();
        }
    }
    pen.polyline(points);
    return pen;
}

// An upright guide is named above the frame, where no curve runs.
bool is_upright(const Guide& guide) { return guide.x0 == guide.x1; }

std::string draw_guide(const Guide& guide, const Ruler& x, const Ruler& y) {
    double x0 = std::isnan(guide.x0) ? x.from : x.at(guide.x0), x1 = std::isnan(guide.x1) ? x.to : x.at(guide.x1);
    double y0 = std::isnan(guide.y0) ? y.from : y.at(guide.y0), y1 = std::isnan(guide.y1) ? y.to : y.at(guide.y1);
    Pen pen;
    straight(pen, x0, y0, x1, y1);
    std::string svg = path_at("guide", pen);
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
    Labels below("tick", "middle"), beside("tick", "end");
    Pen frame, grid, minor;
    for (const Ruler::Tick& t : x.ticks) {
        straight(t.label.empty() ? minor : grid, x.at(t.value), y.from, x.at(t.value), y.to);
        below.add(x.at(t.value), y.from + 17, t.label);
    }
    for (const Ruler::Tick& t : y.ticks) {
        straight(t.label.empty() ? minor : grid, x.from, y.at(t.value), x.to, y.at(t.value));
        beside.add(x.from - 6, y.at(t.value) + 4, t.label);
    }
    straight(frame, x.from, y.from, x.to, y.from);
    svg += path_at("minor", minor) + path_at("grid", grid) + path_at("frame", frame) + below.svg() + beside.svg();
    for (const Guide& guide : plot.guides) svg += draw_guide(guide, x, y);
    std::string clip = "clip" + std::to_string(++clip_number);
    svg += "<clipPath" + attribute("id", clip) + "><rect" + attribute("x", px(x.from - 5)) +
           attribute("y", px(y.to - 5)) + attribute("width", px(x.to - x.from + 10)) +
           attribute("height", px(y.from - y.to + 10)) + "/></clipPath>\n<g" +
           attribute("clip-path", "url(#" + clip + ")") + ">\n";
    for (const Series& s : plot.series)
        if (s.style.line)
            svg += "<path" + attribute("class", line_class(s.style)) + attribute("stroke-width", px(s.style.width)) +
                   attribute("d", line_of(s, x, y).text()) +
                   (s.name.empty() ? "/>\n" : "><title>" + escape(s.name) + "</title></path>\n");
    for (const Series& s : plot.series) {
        if (s.style.marker == Marker::none) continue;
        svg += open_markers(s.style);
        for (std::size_t i = 0; i < s.x.size(); ++i)
            if (x.holds(s.x[i]) && y.holds(s.y[i]))
                svg += marker_at(s.style.marker, x.at(s.x[i]), y.at(s.y[i]), i < s.tips.size() ? s.tips[i] : "");
        svg += "</g>\n";
    }
    return svg + "</g>\n</svg>\n";
}

std::string render(const HeatMap& map) {
    double left = map.row_label_width, top = 44;
    double width = left + map.cell_width * double(map.columns.size()) + 4;
    double height = top + map.cell_height * double(map.rows.size()) + (map.x_label.empty() ? 42 : 56);
    std::string svg = open_svg(width, height, map.title);
    svg += text_at(2, 15, "title", "start", map.title) + text_at(2, 34, "axis", "start", map.y_label);
    Labels rows("tick", "end"), cold("cell", "middle"), hot("cell hot", "middle");
    svg += "<g class=\"heat\">";
    for (std::size_t r = 0; r < map.rows.size(); ++r) {
        double y = top + map.cell_height * double(r), middle = y + map.cell_height / 2 + 4;
        rows.add(left - 8, middle, map.rows[r]);
        for (std::size_t c = 0; c < map.columns.size(); ++c) {
            std::size_t k = r * map.columns.size() + c;
            double x = left + map.cell_width * double(c), shade = std::min(1.0, std::max(0.0, map.shade[k]));
            Pen box;
            box.move(x + 1, y + 1), box.line(x + map.cell_width - 1, y + 1);
            box.line(x + map.cell_width - 1, y + map.cell_height - 1), box.line(x + 1, y + map.cell_height - 1);
            box.close();
            svg += "<path" + attribute("d", box.text()) + attribute("fill-opacity", decimal(0.06 + 0.94 * shade, 2)) +
                   (k < map.tips.size() ? "><title>" + escape(map.tips[k]) + "</title></path>\n" : "/>\n");
            (shade > 0.55 ? hot : cold).add(x + map.cell_width / 2, middle, map.cells[k]);
        }
    }
    svg += "</g>\n" + rows.svg() + cold.svg() + hot.svg();
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
    auto alike = [](const Polyline& a, const Polyline& b) {
        return a.colour == b.colour && a.opacity == b.opacity && a.width == b.width;
    };
    for (std::size_t l = 0; l < picture.lines.size();) {  // lines alike, one after the other, are one path
        const Polyline& line = picture.lines[l];
        Pen pen;
        for (; l < picture.lines.size() && alike(picture.lines[l], line); ++l) {
            std::vector<std::pair<double, double>> points;
            for (std::size_t i = 0; i < picture.lines[l].x.size(); ++i)
                points.push_back({x_of(picture.lines[l].x[i]), y_of(picture.lines[l].y[i])});
            pen.polyline(points);
        }
        svg += "<path" + attribute("class", "line round " + stroke_class(line.colour)) +
               attribute("stroke-opacity", decimal(line.opacity, 2)) + attribute("stroke-width", px(line.width)) +
               attribute("d", pen.text()) + "/>\n";
    }
    for (const Dot& dot : picture.dots)
        svg += "<circle" + attribute("cx", px(x_of(dot.x))) + attribute("cy", px(y_of(dot.y))) +
               attribute("r", px(dot.radius)) + attribute("class", fill_class(dot.colour)) + "/>\n";
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
            html += "<path d=\"M1 7h32\"" + attribute("class", line_class(s.style)) + " stroke-width=\"2\"/>";
        if (s.style.marker != Marker::none)
            html += open_markers(s.style) + marker_at(s.style.marker, 17, 7, "") + "</g>";
        html += "</svg>" + escape(s.name) + "</li>\n";
    }
    return html + "</ul>\n";
}

}  // namespace report
