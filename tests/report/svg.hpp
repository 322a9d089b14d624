// The pieces that all pictures are put together from.
#ifndef REPORT_SVG_HPP
#define REPORT_SVG_HPP

#include <string>

namespace report {

std::string px(double value);   // two decimals
std::string colour(int index);  // the page's --c0, --c1, ...
std::string attribute(const char* name, const std::string& value);
std::string text_at(double x, double y, const char* kind, const char* anchor, const std::string& text);
std::string open_svg(double width, double height, const std::string& title);

}  // namespace report

#endif
