// Pictures: a drum's mode, a drum that was hit, and a cloth that falls from its two corners.
#include <algorithm>
#include <cmath>

#include "format.hpp"
#include "membrane_parts.hpp"
#include "plot.hpp"

namespace report {
namespace {

const double kGravity = 9.81;

// The sheet's own vertices, normals and triangles.
Surface surface_of(const Sheet& sheet, const std::string& title) {
    std::size_t nu = 0, nv = 0, indices = 0;
    check(cd_membrane_get_shape(sheet.get(), &nu, &nv, nullptr, nullptr));
    check(cd_membrane_get_index_count(sheet.get(), &indices));
    Surface surface{title, {}, {}, {}, {}, 0, 0, 0, 0, 0, 0};
    surface.vertices.resize(6 * (nu + 1) * (nv + 1));
    surface.triangles.resize(indices);
    check(cd_membrane_write_vertices(sheet.get(), surface.vertices.data(), surface.vertices.size() * sizeof(float),
                                     6 * sizeof(float), 0, 3 * sizeof(float)));
    check(cd_membrane_write_indices(sheet.get(), surface.triangles.data(), indices * sizeof(std::uint32_t),
                                    sizeof(std::uint32_t)));
    return surface;
}

std::string drum_picture(const Sheet& sheet, const std::string& title, double height) {
    Surface surface = surface_of(sheet, title);
    for (std::size_t i = 2; i < surface.vertices.size(); i += 6)
        surface.tint.push_back(std::clamp(surface.vertices[i] / height, -1.0, 1.0));
    surface.azimuth = 28, surface.elevation = 38;
    surface.x0 = -0.03, surface.x1 = 1.39, surface.y0 = -0.38, surface.y1 = 0.66;
    surface.width = 340;
    return render(surface);
}

void drums(Report& report) {
    const std::size_t n = 24, nodes = (n + 1) * (n + 1);
    Sheet mode(n, n, 1, precisions().front()), hit(n, n, 1, precisions().front());
    std::vector<double> shape(nodes);
    for (std::size_t v = 1; v < n; ++v)
        for (std::size_t u = 1; u < n; ++u)
            shape[v * (n + 1) + u] =
                0.14 * std::sin(3 * M_PI * double(u) / double(n)) * std::sin(2 * M_PI * double(v) / double(n));
    for (Sheet* sheet : {&mode, &hit}) sheet->pin_edges();
    mode.write(CD_POSITION, shape);
    const double impulse = -0.045;
    check(cd_membrane_impulse(hit.get(), 0.4 * double(n), 0.55 * double(n), 4, &impulse, 1));
    std::vector<std::string> panels = {drum_picture(mode, "mode (3, 2)", 0.14)};
    double time = 0;
    for (double moment : {0.12, 0.4}) {
        const std::size_t steps = std::size_t(std::lround((moment - time) * 200));
        check(cd_membrane_step(hit.get(), 1.0 / 200, steps));
        time = moment;
        panels.push_back(drum_picture(hit, si(moment, "s", 2) + " after a hit", 0.14));
    }
    panels.front() = report.page.show(panels.front(), "A mode of a drum");
    report.outcome("membrane.scene.drum", hex(hit.hash()));
    report.page.figure(
        panels, "",
        "A drum of " + std::to_string(n) + " × " + std::to_string(n) +
            " springs: a mode, and what a hit at a point becomes. Orange is up, blue is down; stiffness and mass are "
            "1, 200 steps a second of λ = 1/2, alternating. The ring runs outwards, and inside it the drum has not "
            "come back yet: in two dimensions a wave leaves a wake.",
        220);
}

// A cloth of 3 components, in the plane z = 0 at first, held at the corners of its edge y = 0.
struct Cloth {
    static constexpr std::size_t kSide = 24, kPeg = 2;
    static constexpr double kStiffness = 14;
    Sheet sheet{kSide, kSide, 3, precisions().back()};

    Cloth() {
        check(cd_membrane_set_stiffness(sheet.get(), kStiffness, kStiffness));
        check(cd_membrane_set_drag(sheet.get(), 0.3));
        const double gravity[] = {0, 0, -kGravity};
        check(cd_membrane_set_gravity(sheet.get(), gravity, 3));
        std::vector<double> start;
        for (std::size_t v = 0; v <= kSide; ++v)
            for (std::size_t u = 0; u <= kSide; ++u)
                start.insert(start.end(), {double(u) / double(kSide), double(v) / double(kSide), 0});
        sheet.write(CD_POSITION, start);
        sheet.enable(CD_PIN);
        const std::vector<double> pinned(kPeg * kPeg, CD_NODE_PINNED);
        for (std::size_t u : {std::size_t(0), kSide + 1 - kPeg})
            check(cd_membrane_write_f64(sheet.get(), CD_PIN, u, 0, kPeg, kPeg, pinned.data(), pinned.size()));
        sheet.enable(CD_FORCE);
        std::vector<double> force(3 * (kSide + 1) * (kSide + 1));
        for (std::size_t v = 0; v <= kSide; ++v) {
            const double share = kStiffness / double(kSide + 1);
            force[3 * v * (kSide + 1)] = -share;
            force[3 * (v * (kSide + 1) + kSide)] = share;
        }
        sheet.write(CD_FORCE, force);
        sheet.set(method(Way::coupled_half));
    }

    std::string draw(const std::string& title) const {
        Surface surface = surface_of(sheet, title);
        surface.pins = {0, kSide};
        surface.azimuth = 30, surface.elevation = 22;
        surface.x0 = -0.2, surface.x1 = 1.42, surface.y0 = -1.1, surface.y1 = 0.48;
        surface.width = 320;
        return render(surface);
    }
};

void cloth(Report& report) {
    Cloth cloth;
    cd_membrane* membrane = cloth.sheet.get();
    std::vector<std::string> panels;
    std::size_t steps = 0;
    for (std::size_t until : {30, 60}) {
        check(cd_membrane_step(membrane, 1.0 / 120, until - steps));
        steps = until;
        panels.push_back(cloth.draw(si(double(steps) / 120, "s", 2)));
    }
    panels.back() = report.page.show(panels.back(), "A cloth that falls, held by two corners");
    const std::size_t iterations = cloth.sheet.iterations();
    report.outcome("membrane.scene.cloth", hex(cloth.sheet.hash()));
    cloth.sheet.set(method(Way::coupled_backward));
    check(cd_membrane_step(membrane, 1e4, 1));
    panels.push_back(cloth.draw("at rest, after one step of 10 000 s"));
    double fastest = 0;
    for (double v : cloth.sheet.read(CD_VELOCITY)) fastest = std::fmax(fastest, std::fabs(v));
    report.outcome("membrane.scene.cloth at rest", hex(cloth.sheet.hash()));
    report.page.figure(
        panels, "",
        "A cloth falls from the horizontal, held at two corners, and comes to rest. " + std::to_string(Cloth::kSide) +
            " × " + std::to_string(Cloth::kSide) +
            " springs, 3 components, 120 steps a second of λ = 1/2, coupled, in at most " + std::to_string(iterations) +
            " iterations. The notes' springs have no rest length: forces along its two sides hold the cloth out to its "
            "width, and it hangs as a soft one. A single backward Euler step of 10 000 s finds where it comes to rest "
            "(greatest speed left: " +
            number(fastest, 1) + " m/s). Triangles and normals are the library's own.",
        220);
}

}  // namespace

void report_membrane_scenes(Report& report) {
    report.page.section("membrane-scenes", "Membranes and cloth: pictures");
    drums(report);
    cloth(report);
}

}  // namespace report
