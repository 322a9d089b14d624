// Surfaces as SVG: patches of two triangles from the farthest to the nearest, each in one colour. Patches about as far
// are drawn by their colours, those of a colour in one path.
#include <algorithm>
#include <array>
#include <cstdio>
#include <tuple>

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

// Rounded to multiples of 8, so that neighbours share a path.
std::string hex_colour(const Vector& rgb) {
    int level[3];
    for (int i = 0; i < 3; ++i) level[i] = std::min(255, std::max(0, int(std::lround(rgb[i] / 8) * 8)));
    char text[16];
    std::snprintf(text, sizeof text, "#%02x%02x%02x", level[0], level[1], level[2]);
    return text;
}

struct Patch {
    std::vector<std::uint32_t> corners;
    long layer = 0;  // by distance, the farthest first
    std::string colour;
};

// A triangle and the next one of the list are one patch if they share an edge, as the two of a lattice's cell do.
std::vector<Patch> patches_of(const std::vector<std::uint32_t>& triangles) {
    std::vector<Patch> patches;
    for (std::size_t t = 0; t + 2 < triangles.size(); t += 3) {
        const std::uint32_t* a = triangles.data() + t;
        Patch patch;
        patch.corners.assign(a, a + 3);
        const std::uint32_t *b = a + 3, *end = t + 5 < triangles.size() ? b + 3 : b;
        auto is_shared = [&](std::uint32_t corner) { return std::find(b, end, corner) != end; };
        for (int apart = 0; apart < 3; ++apart) {
            const std::uint32_t next = a[(apart + 1) % 3], last = a[(apart + 2) % 3];
            if (is_shared(a[apart]) || !is_shared(next) || !is_shared(last)) continue;
            const std::uint32_t other =
                *std::find_if(b, end, [&](std::uint32_t corner) { return corner != next && corner != last; });
            patch.corners = {a[apart], next, other, last};
            t += 3;
            break;
        }
        patches.push_back(patch);
    }
    return patches;
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

    std::string svg = open_svg(surface.width, height, surface.title) + text_at(2, 15, "title", "start", surface.title);
    svg += "<g style=\"fill:currentColor;stroke:currentColor;stroke-width:.7;stroke-linejoin:round\">\n";
    // Layers about as thick as a patch is wide.
    const double layer = (surface.x1 - surface.x0) / std::sqrt(double(surface.triangles.size()) / 6);
    std::vector<Patch> patches = patches_of(surface.triangles);
    for (Patch& patch : patches) {
        Vector normal = {0, 0, 0};
        double tint = 0, near = 0;
        const double share = 1 / double(patch.corners.size());
        for (std::uint32_t corner : patch.corners) {
            const Vector n = vector(corner, 3);
            for (int i = 0; i < 3; ++i) normal[i] += n[i];
            near += share * dot(vector(corner, 0), eye.towards);
            if (!surface.tint.empty()) tint += share * surface.tint[corner];
        }
        const double size = std::sqrt(dot(normal, normal));
        const bool behind = dot(normal, eye.towards) < 0;
        const double bright = size > 0 ? std::fmax(0, dot(normal, eye.light) / size * (behind ? -1 : 1)) : 0;
        const Vector base = surface.tint.empty()
                                ? (behind ? kBack : kFront)
                                : mixed(kMiddle, tint < 0 ? kLow : kHigh, std::fmin(1, std::fabs(tint)));
        const Vector shaded = scaled(base, 0.5 + 0.62 * bright);
        patch.colour = hex_colour(mixed(shaded, {255, 255, 255}, 0.22 * std::pow(bright, 24)));
        patch.layer = std::lround(near / layer);
    }
    std::stable_sort(patches.begin(), patches.end(), [](const Patch& a, const Patch& b) {
        return std::tie(a.layer, a.colour) < std::tie(b.layer, b.colour);
    });
    for (std::size_t p = 0; p < patches.size();) {
        const std::string& colour = patches[p].colour;
        Pen pen(0.5);
        for (; p < patches.size() && patches[p].colour == colour; ++p) {
            const std::vector<std::uint32_t>& corners = patches[p].corners;
            for (std::size_t c = 0; c < corners.size(); ++c) {
                const Vector at = vector(corners[c], 0);
                c ? pen.line(x_of(at), y_of(at)) : pen.move(x_of(at), y_of(at));
            }
            pen.close();
        }
        svg += "<path" + attribute("color", colour) + attribute("d", pen.text()) + "/>\n";
    }
    svg += "</g>\n";
    for (std::uint32_t pin : surface.pins) {
        const Vector p = vector(pin, 0);
        svg += "<circle" + attribute("cx", px(x_of(p))) + attribute("cy", px(y_of(p))) + attribute("r", "4") +
               attribute("style", "fill:var(--fg);stroke:var(--bg);stroke-width:1.2") + "/>\n";
    }
    return svg + "</svg>\n";
}

}  // namespace report
