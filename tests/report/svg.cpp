#include "svg.hpp"

#include <cstdio>

#include "format.hpp"

namespace report {

std::string px(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.2f", value);
    return text;
}

std::string colour(int index) { return "var(--c" + std::to_string(index) + ")"; }

std::string attribute(const char* name, const std::string& value) {
    return std::string(" ") + name + "=\"" + value + "\"";
}

std::string text_at(double x, double y, const char* kind, const char* anchor, const std::string& text) {
    return "<text" + attribute("class", kind) + attribute("x", px(x)) + attribute("y", px(y)) +
           attribute("text-anchor", anchor) + ">" + escape(text) + "</text>\n";
}

std::string open_svg(double width, double height, const std::string& title) {
    return "<svg" + attribute("viewBox", "0 0 " + px(width) + " " + px(height)) + attribute("role", "img") +
           attribute("aria-label", escape(title)) + attribute("style", "max-width:" + px(width * 1.25) + "px") + ">\n";
}

}  // namespace report
