// The pieces that all pictures are put together from. A picture is some hundreds wide, and tenths are enough.
#ifndef REPORT_SVG_HPP
#define REPORT_SVG_HPP

#include <string>
#include <utility>
#include <vector>

namespace report {

std::string decimal(double value, int digits);  // no zeros at the end, none before the point
std::string px(double value);                   // one digit after the point
std::string attribute(const char* name, const std::string& value);

// Classes of the page: strokes and fills of its colours --c0, --c1, ...
std::string stroke_class(int colour);
std::string fill_class(int colour);

// `kind` is a class of the page, `anchor` is start, middle or end.
std::string text_at(double x, double y, const char* kind, const std::string& anchor, const std::string& text);

// Ticks' labels, which share what they look like.
class Labels {
public:
    Labels(const char* kind, const std::string& anchor);
    void add(double x, double y, const std::string& text);
    std::string svg() const { return texts_.empty() ? "" : open_ + texts_ + "</g>\n"; }

private:
    std::string open_, texts_;
};

std::string open_svg(double width, double height, const std::string& title);

// The `d` of a path: each point is told by how far it is from the one before, and roundings do not add up.
class Pen {
public:
    explicit Pen(double unit = 0.1) : unit_(unit) {}  // what coordinates are whole multiples of

    void move(double x, double y);
    void line(double x, double y);
    void close();

    // A move and lines; points within two tenths of the straight line between those that stay are left out.
    void polyline(const std::vector<std::pair<double, double>>& points);

    const std::string& text() const { return text_; }

private:
    void go(char command, double x, double y);
    void number(long units);

    double unit_;
    std::string text_;
    char command_ = ' ';  // what numbers without a letter before them would mean
    long x_ = 0, y_ = 0, first_x_ = 0, first_y_ = 0;
};

}  // namespace report

#endif
