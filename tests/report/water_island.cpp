// A map of the tide around an island: depths in classes of colour, alike in light and dark, and the shore as a line.
#include <algorithm>
#include <cmath>

#include "format.hpp"
#include "svg.hpp"
#include "water_parts.hpp"

namespace report {
namespace {

const std::size_t kX = 132, kY = 88;
const double kShore = 0.02; // a depth [m]: what is shallower counts as dry
const double kCell = 25, kTide = 1.6, kPeriod = 44700, kStep = 15;

const char* const kWater[] = {"#cfe6ea", "#a9d3df", "#7fbcd2", "#57a2c4", "#3586b3", "#1f6a9c", "#15507f"};
const char* const kLand[] = {"#d9c9a0", "#c3b98a", "#a3aa74", "#83975f", "#6a824f"};

std::vector<double> island() {
    return over_cells(kX, kY, kCell, [](double x, double y) {
        auto hill = [&](double at_x, double at_y, double width, double height) {
            return height * std::exp(-(std::pow(x - at_x, 2) + std::pow(y - at_y, 2)) / (2 * width * width));
        };
        const double ripples = 0.25 * std::sin(x / 90) * std::sin(y / 70 + x / 260);
        return -5 + hill(1500, 1150, 420, 9) + hill(2050, 1450, 250, 4.6) + hill(1050, 700, 240, 5.0) -
               hill(1650, 950, 130, 4.5) + hill(2500, 700, 260, 3.9) + ripples;
    });
}

// The line on which numbers at cell centres are `level`, as one path of short straight pieces.
Pen contour(const std::vector<double>& values, double level, double scale, double top) {
    Pen line;
    for (std::size_t j = 0; j + 1 < kY; ++j)
        for (std::size_t i = 0; i + 1 < kX; ++i) {
            const std::size_t corner[] = {j * kX + i, j * kX + i + 1, (j + 1) * kX + i + 1, (j + 1) * kX + i};
            const double at_x[] = {0, 1, 1, 0}, at_y[] = {0, 0, 1, 1};
            bool down = false;
            for (int c = 0; c < 4; ++c) {
                const double a = values[corner[c]] - level, b = values[corner[(c + 1) % 4]] - level;
                if ((a > 0) == (b > 0)) continue;
                const double t = a / (a - b), x = double(i) + 0.5 + at_x[c] + t * (at_x[(c + 1) % 4] - at_x[c]),
                             y = double(j) + 0.5 + at_y[c] + t * (at_y[(c + 1) % 4] - at_y[c]);
                const double to_x = x * scale, to_y = top + (double(kY) - y) * scale;
                down ? line.line(to_x, to_y) : line.move(to_x, to_y);
                down = !down;
            }
        }
    return line;
}

std::string map_of(const Water& water, const std::string& title, const std::vector<double>& other_shore) {
    const double scale = 3.4, top = 26;
    const std::vector<double> depth = water.read(CD_DEPTH), bed = water.read(CD_BED);
    std::string svg =
        open_svg(scale * double(kX), top + scale * double(kY), title) + text_at(2, 15, "title", "start", title);
    auto class_of = [&](std::size_t k) {
        if (depth[k] < kShore) return std::clamp(int(std::floor((bed[k] + 1.6) / 1.4)), 0, 4);
        return 5 + std::clamp(int(std::floor(depth[k])), 0, 6);
    };
    Pen bands[12];  // strokes as wide as a row of cells
    for (std::size_t j = 0; j < kY; ++j)
        for (std::size_t i = 0, end; i < kX; i = end) {
            const int kind = class_of(j * kX + i);
            for (end = i + 1; end < kX && class_of(j * kX + end) == kind;) ++end;
            const double y = top + (double(kY - j) - 0.5) * scale;
            bands[kind].move(double(i) * scale, y), bands[kind].line(double(end) * scale + 0.3, y);
        }
    auto draw = [&](const Pen& pen, const char* colour, double width) {
        if (!pen.text().empty())
            svg += "<path" + attribute("class", "line") + attribute("stroke", colour) +
                   attribute("stroke-width", px(width)) + attribute("d", pen.text()) + "/>\n";
    };
    for (int kind = 0; kind < 12; ++kind) draw(bands[kind], kind < 5 ? kLand[kind] : kWater[kind - 5], scale + 0.3);
    if (!other_shore.empty()) draw(contour(other_shore, kShore, scale, top), "#5b3a1c", 1);
    draw(contour(depth, kShore, scale, top), "#22303a", 1.4);
    return svg + "</svg>\n";
}

double wet_area(const std::vector<double>& depth) {
    return kCell * kCell * double(std::count_if(depth.begin(), depth.end(), [](double d) { return d >= kShore; }));
}

std::string swatches() {
    std::string html = "<ul class=\"legend\">\n";
    auto add = [&](const char* colour, const std::string& text) {
        html += std::string(
                    "<li><svg viewBox=\"0 0 34 14\" aria-hidden=\"true\"><rect x=\"8\" y=\"1\" width=\"18\" "
                    "height=\"12\"") +
                attribute("style", std::string("fill:") + colour) + "/></svg>" + escape(text) + "</li>\n";
    };
    add(kLand[0], "dry, bared by the tide"), add(kLand[4], "dry, hills");
    add(kWater[0], "less than 1 m deep"), add(kWater[3], "3 to 4 m"), add(kWater[6], "more than 6 m");
    return html + "</ul>\n";
}

} // namespace

void draw_island(Report& report) {
    Water water(kX, kY, kCell, kCell, precisions().back());
    const std::vector<double> bed = island();
    std::vector<double> depth;
    for (double b : bed) depth.push_back(std::fmax(0, -b));
    water.write(CD_BED, bed);
    water.write(CD_DEPTH, depth);
    check(cd_water_set_manning(water.get(), 0.03));
    const double w = 2 * M_PI / kPeriod;
    double low = 0, high = 0;
    std::vector<double> low_depth;
    Water at_low(kX, kY, kCell, kCell, precisions().back());
    const std::size_t period = std::size_t(kPeriod / kStep);
    for (std::size_t step = 0; step < 2 * period; ++step) {
        const double time = double(step) * kStep;
        for (cd_side side : {CD_SIDE_X_FIRST, CD_SIDE_X_LAST}) {
            const double phase = w * time - (side == CD_SIDE_X_LAST ? 0.15 : 0);
            check(cd_water_set_side(water.get(), side, CD_BORDER_OPEN, kTide * std::sin(phase),
                                    kTide * w * std::cos(phase)));
        }
        check(cd_water_step(water.get(), kStep, 1));
        if (step == std::size_t(0.77 * double(period))) {
            low_depth = water.read(CD_DEPTH);
            low = wet_area(low_depth);
            check(cd_water_copy_state(at_low.get(), water.get()));
        }
        if (step == std::size_t(1.27 * double(period))) break;
    }
    high = wet_area(water.read(CD_DEPTH));
    double in = 0, out = 0, off = 0;
    check(cd_water_get_account(water.get(), nullptr, &in, &out, &off));
    const double relative = std::fabs(off) / water.volume();
    report.summary("water.island.bared_area", (high - low) * 1e-4, "ha");
    report.summary("water.island.account_error", relative);
    report.outcome("water.scene.island", hex(water.hash()));
    report.page.figure(
        {map_of(at_low, "low water", {}),
         report.page.show(map_of(water, "high water", low_depth), "The tide around an island")},
        swatches(),
        "The tide bares " + number((high - low) * 1e-4, 3) +
            " ha of banks around an island and fills its lagoon again. 3.3 km × 2.2 km in cells of 25 m, "
            "tides of 1.6 m at the open sides left and right, later on the right; one tide is " +
            count(double(period)) + " linear steps of 15 s in " + name_of(precisions().back()) +
            ". The thick line is the shore, the thin one that of low water; of " + number((in + out) * 1e-6, 2) +
            " million m³ that came and went, the account misses " + number(std::fabs(off), 1) + " m³.",
        330);
}

} // namespace report
