// Maps of what becomes of a scene over two logarithmic parameters.
#ifndef REPORT_FATE_MAP_HPP
#define REPORT_FATE_MAP_HPP

#include <string>
#include <vector>

namespace report {

enum class Fate { bounded, damped, growing, not_finite };
const char* name_of(Fate fate);

struct FateMap {
    std::string title, x_label, y_label;
    std::vector<double> x, y;  // the cells' middles, evenly spaced in their logarithms
    std::vector<Fate> fates;   // of the cell (i, j) at j * x.size() + i
    std::vector<bool> differs; // marked with a cross
    struct Point {
        double x, y;
    };
    std::vector<std::vector<Point>> limits; // theory's, as lines
    double width = 330, height = 250;
};

std::string render(const FateMap& map);

// An HTML list of the colours and marks.
std::string fate_legend();

} // namespace report

#endif
