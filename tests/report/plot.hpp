// Pictures as inline SVG: plots with linear or logarithmic axes, heat maps, scenes of polylines, and surfaces.
//
// Colours are the CSS variables --c0 .. --c8 (and --fg, --muted, --grid) that page.cpp defines for light and dark. They
// are told apart by colour-blind readers too, and a series is never told by its colour alone: it also has its marker
// and its dash. Everything scales with the page: each picture is a viewBox that its column stretches.
#ifndef REPORT_PLOT_HPP
#define REPORT_PLOT_HPP

#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

namespace report {

enum class Scale { linear, log };
enum class Marker { none, circle, square, diamond, triangle, wedge, cross, plus };
enum class Dash { solid, dashed, dotted };

struct Axis {
    std::string label;
    Scale scale = Scale::linear;
    std::string unit = "";                  // not empty: ticks carry an SI prefix and this unit; "%": percentages
    double lo = std::nan(""), hi = std::nan("");  // NaN: from the data
};

struct Style {
    int colour = 0;
    Marker marker = Marker::none;
    Dash dash = Dash::solid;
    bool hollow = false;
    bool line = true;
    double width = 1.8;
};

struct Series {
    std::string name;
    Style style;
    std::vector<double> x, y;       // a NaN breaks the line
    std::vector<std::string> tips;  // shown when the pointer rests on a marker; the name, when on the line
};

// A reference line from (x0, y0) to (x1, y1); NaN stands for the plot's edge on that side.
struct Guide {
    double x0, y0, x1, y1;
    std::string label;
};

struct Plot {
    std::string title;
    Axis x, y;
    std::vector<Series> series;
    std::vector<Guide> guides;
    double width = 450, height = 350;
};

struct HeatMap {
    std::string title, x_label, y_label;
    std::vector<std::string> columns, rows;  // a column's name may have two lines
    std::vector<double> shade;       // row after row, 0 (calm) to 1 (alarming)
    std::vector<std::string> cells;  // printed in each cell, as many
    std::vector<std::string> tips;   // may be empty
    double cell_width = 34, cell_height = 26, row_label_width = 150;
};

struct Polyline {
    std::vector<double> x, y;
    int colour = 0;
    double opacity = 1, width = 1.6;
};

struct Dot {
    double x, y, radius;  // radius in units of the viewBox
    int colour;
};

struct Label {
    double x, y;
    std::string text;
    int colour = 0;
    const char* anchor = "start";
};

// A scene with equal scales along x and y; y points up.
struct Picture {
    std::string title;
    double x0, y0, x1, y1;
    std::vector<Polyline> lines;
    std::vector<Dot> dots;
    std::vector<Label> labels;
    double width = 450;
};

// A surface of triangles seen from afar and lit from the upper left. Its colours are its own, alike in light and dark.
struct Surface {
    std::string title;
    std::vector<float> vertices;           // x, y, z and the unit normal of each; z points up
    std::vector<std::uint32_t> triangles;  // vertex numbers
    std::vector<double> tint;              // of each vertex, -1 (blue) to 1 (orange); empty: cloth with two sides
    std::vector<std::uint32_t> pins;       // vertices with a dot
    double azimuth, elevation;             // from where it is seen, in degrees; azimuth 0: along y
    double x0, y0, x1, y1;                 // the window, to the right and up in the plane of sight
    double width = 450;
};

std::string render(const Plot& plot);
std::string render(const HeatMap& map);
std::string render(const Picture& picture);
std::string render(const Surface& surface);  // surface.cpp

// An HTML list of the series' strokes, markers and names; series without a name or with one seen before are left out.
std::string legend(const std::vector<Series>& series);

}  // namespace report

#endif
