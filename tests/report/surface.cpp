// Surfaces as SVG: triangles from the farthest to the nearest, each in one colour, neighbours of a colour in one path.
#include <algorithm>
#include <array>
#include <cstdio>
#include <numeric>

#include "plot.hpp"
#include "svg.hpp"

namespace report {
namespace {

using Vector = std::array<double, 3>;

double dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Vector scaled(const Vector& a, double factor) { return {a[0] * factor, a[1] * factor, a[2] * factor}; }

Vector mixed(const Vector& a, const Vector& b, double share) {
    return {a[0] + share * (b[0] - a[0]), a[1] + share * (b[1] - a[1]), a[2] + share * (b[2] - a[2])};
}

const Vector kLow = {38, 112, 184}, kMiddle = {226, 220, 206}, kHigh = {217, 92, 24};  // tints
const Vector kFront = {201, 84, 32}, kBack = {58, 118, 158};                           // of a cloth

struct Eye {
    Vector right, up, towards;  // towards the eye
    Vector light;

    Eye(double azimuth, double elevation) {
        const double a = azimuth * M_PI / 180, e = elevation * M_PI / 180;
        right = {std::cos(a), std::sin(a), 0};
        up = {-std::sin(a) * std::sin(e), std::cos(a) * std::sin(e), std::cos(e)};
        towards = {std::sin(a) * std::cos(e), -std::cos(a) * std::cos(e), std::sin(e)};
        for (int i = 0; i < 3; ++i) light[i] = -0.5 * right[i] + 0.6 * up[i] + 0.62 * towards[i];
    }
};

// Rounded to 4 levels in 256, so that neighbours share a path.
std::string hex_colour(const Vector& rgb) {
    int level[3];
    for (int i = 0; i < 3; ++i) level[i] = std::min(255, std::max(0, int(std::lround(rgb[i] / 4) * 4)));
    char text[16];
    std::snprintf(text, sizeof text, "#%02x%02x%02x", level[0], level[1], level[2]);
    return text;
}

std::string tenths(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.1f", value);
    return text;
}

}  // namespace

std::string render(const Surface& surface) {
    const Eye eye(surface.azimuth, surface.elevation);
    const double scale = surface.width / (surface.x1 - surface.x0), top = surface.title.empty() ? 4 : 26;
    const double height = scale * (surface.y1 - surface.y0) + top;
    auto vector = [&](std::uint32_t vertex, std::size_t at) {
        const float* numbers = surface.vertices.data() + 6 * vertex + at;
        return Vector{numbers[0], numbers[1], numbers[2]};
    };
    auto x_of = [&](const Vector& p) { return (dot(p, eye.right) - surface.x0) * scale; };
    auto y_of = [&](const Vector& p) { return top + (surface.y1 - dot(p, eye.up)) * scale; };

    std::vector<double> nearness(surface.triangles.size() / 3);
    for (std::size_t t = 0; t < nearness.size(); ++t)
        for (std::size_t c = 0; c < 3; ++c) nearness[t] += dot(vector(surface.triangles[3 * t + c], 0), eye.towards);
    std::vector<std::size_t> order(nearness.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return nearness[a] < nearness[b]; });

    std::string svg = open_svg(surface.width, height, surface.title) + text_at(2, 15, "title", "start", surface.title);
    svg += "<g style=\"fill:currentColor;stroke:currentColor;stroke-width:.7;stroke-linejoin:round\">\n";
    std::string last, path;
    auto flush = [&] {
        if (!path.empty()) svg += "<path" + attribute("color", last) + attribute("d", path) + "/>\n";
        path.clear();
    };
    for (std::size_t t : order) {
        const std::uint32_t* corner = surface.triangles.data() + 3 * t;
        Vector normal = {0, 0, 0};
        double tint = 0;
        for (int c = 0; c < 3; ++c) {
            const Vector n = vector(corner[c], 3);
            for (int i = 0; i < 3; ++i) normal[i] += n[i];
            if (!surface.tint.empty()) tint += surface.tint[corner[c]] / 3;
        }
        const double size = std::sqrt(dot(normal, normal));
        const bool behind = dot(normal, eye.towards) < 0;
        const double bright = size > 0 ? std::fmax(0, dot(normal, eye.light) / size * (behind ? -1 : 1)) : 0;
        const Vector base = surface.tint.empty()
                                ? (behind ? kBack : kFront)
                                : mixed(kMiddle, tint < 0 ? kLow : kHigh, std::fmin(1, std::fabs(tint)));
        const Vector shaded = scaled(base, 0.5 + 0.62 * bright);
        const std::string colour = hex_colour(mixed(shaded, {255, 255, 255}, 0.22 * std::pow(bright, 24)));
        if (colour != last) flush();
        last = colour;
        for (int c = 0; c < 3; ++c) {
            const Vector p = vector(corner[c], 0);
            path += (c ? "L" : "M") + tenths(x_of(p)) + " " + tenths(y_of(p));
        }
        path += "z";
    }
    flush();
    svg += "</g>\n";
    for (std::uint32_t pin : surface.pins) {
        const Vector p = vector(pin, 0);
        svg += "<circle" + attribute("cx", px(x_of(p))) + attribute("cy", px(y_of(p))) + attribute("r", "4") +
               attribute("style", "fill:var(--fg);stroke:var(--bg);stroke-width:1.2") + "/>\n";
    }
    return svg + "</svg>\n";
}

}  // namespace report
