#include "svg.hpp"

#include <cmath>
#include <cstdio>

#include "format.hpp"

namespace report {

static const double kStraight = 0.2;

std::string decimal(double value, int digits) {
    char buffer[64];
    std::snprintf(buffer, sizeof buffer, "%.*f", digits, value);
    std::string text = buffer;
    if (text.find('.') != std::string::npos) {
        text.erase(text.find_last_not_of('0') + 1);
        if (text.back() == '.') text.pop_back();
    }
    if (text == "-0") return "0";
    const std::size_t first = text[0] == '-' ? 1 : 0;
    if (text.compare(first, 2, "0.") == 0) text.erase(first, 1);
    return text;
}

std::string px(double value) { return decimal(value, 1); }

std::string attribute(const char* name, const std::string& value) {
    return std::string(" ") + name + "=\"" + value + "\"";
}

std::string stroke_class(int colour) { return "s" + std::to_string(colour); }
std::string fill_class(int colour) { return "p" + std::to_string(colour); }

static std::string look(const char* kind, const std::string& anchor) {
    return attribute("class", kind + std::string(anchor == "middle" ? " m" : anchor == "end" ? " e" : ""));
}

static std::string place(double x, double y, const std::string& text) {
    return attribute("x", decimal(x, 0)) + attribute("y", decimal(y, 0)) + ">" + escape(text) + "</text>\n";
}

std::string text_at(double x, double y, const char* kind, const std::string& anchor, const std::string& text) {
    return text.empty() ? "" : "<text" + look(kind, anchor) + place(x, y, text);
}

Labels::Labels(const char* kind, const std::string& anchor) : open_("<g" + look(kind, anchor) + ">") {}

void Labels::add(double x, double y, const std::string& text) {
    if (!text.empty()) texts_ += "<text" + place(x, y, text);
}

std::string open_svg(double width, double height, const std::string& title) {
    return "<svg" + attribute("viewBox", "0 0 " + px(width) + " " + px(height)) + attribute("role", "img") +
           attribute("aria-label", escape(title)) + attribute("style", "max-width:" + px(width * 1.25) + "px") + ">\n";
}

void Pen::number(long units) {
    const bool follows_digit = !text_.empty() && text_.back() >= '0' && text_.back() <= '9';
    if (units >= 0 && follows_digit) text_ += ' ';
    text_ += px(double(units) * unit_);
}

void Pen::go(char command, double x, double y) {
    const long to_x = std::lround(x / unit_), to_y = std::lround(y / unit_);
    if (command == 'l' && to_x == x_ && to_y == y_ && command_ == 'l') return;
    if (command == 'l' && to_y == y_) {
        text_ += command_ = 'h';
        number(to_x - x_);
    } else if (command == 'l' && to_x == x_) {
        text_ += command_ = 'v';
        number(to_y - y_);
    } else {
        if (command != command_) text_ += command;
        number(to_x - x_), number(to_y - y_);
        command_ = 'l';  // after a move, too
    }
    x_ = to_x, y_ = to_y;
}

void Pen::move(double x, double y) {
    command_ = ' ';
    go('m', x, y);
    first_x_ = x_, first_y_ = y_;
}

void Pen::line(double x, double y) { go('l', x, y); }

void Pen::close() {
    text_ += command_ = 'z';
    x_ = first_x_, y_ = first_y_;
}

void Pen::polyline(const std::vector<std::pair<double, double>>& points) {
    if (points.empty()) return;
    // Of the points between two that stay, the farthest from their line stays too if it is off it (Douglas, Peucker).
    std::vector<bool> stays(points.size(), false);
    std::vector<std::pair<std::size_t, std::size_t>> open = {{0, points.size() - 1}};
    stays.front() = stays.back() = true;
    while (!open.empty()) {
        const auto [from, to] = open.back();
        open.pop_back();
        const auto [x0, y0] = points[from];
        const double dx = points[to].first - x0, dy = points[to].second - y0, length = std::hypot(dx, dy);
        double farthest = kStraight;
        std::size_t at = from;
        for (std::size_t i = from + 1; i < to; ++i) {
            const double x = points[i].first - x0, y = points[i].second - y0;
            const double along = length > 0 ? (x * dx + y * dy) / length : 0;
            const double off = along < 0 || length == 0 ? std::hypot(x, y)
                               : along > length         ? std::hypot(x - dx, y - dy)
                                                        : std::fabs(x * dy - y * dx) / length;
            if (off > farthest) farthest = off, at = i;
        }
        if (at == from) continue;
        stays[at] = true;
        open.push_back({from, at}), open.push_back({at, to});
    }
    move(points[0].first, points[0].second);
    for (std::size_t i = 1; i < points.size(); ++i)
        if (stays[i]) line(points[i].first, points[i].second);
}

}  // namespace report
