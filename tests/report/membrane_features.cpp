// What a membrane's features cost, each switched on alone.
#include <cmath>
#include <memory>

#include "features.hpp"
#include "membrane_parts.hpp"

namespace report {
namespace {

struct Feature {
    std::string key, name;
    std::function<void(Sheet&)> add;
    std::size_t components = 1;
    cd_precision precision = precisions().back();
    double dt = 1.0 / 60;
};

std::vector<Feature> features(std::size_t n) {
    auto field = [](cd_field which) { return [which](Sheet& s) { s.enable(which); }; };
    std::vector<Feature> all = {
        {"plain", "λ = 1/2 alternating, all edges held, uniform, undamped", [](Sheet&) {}},
        {"gravity", "gravity",
         [](Sheet& s) {
             const double g = -9.81;
             check(cd_membrane_set_gravity(s.get(), &g, 1));
         }},
        {"drag", "drag", [](Sheet& s) { check(cd_membrane_set_drag(s.get(), 0.1)); }},
        {"stiffness_damping", "stiffness damping",
         [](Sheet& s) { check(cd_membrane_set_stiffness_damping(s.get(), 1e-3)); }},
        {"bend", "bend", [](Sheet& s) { check(cd_membrane_set_bend(s.get(), 1e-6)); }},
        {"half_edges", "half masses at the edges",
         [](Sheet& s) { check(cd_membrane_set_mass_rule(s.get(), CD_MASS_HALF_ENDS)); }},
        {"force", "forces", field(CD_FORCE)},
        {"mass", "masses of their own", field(CD_MASS)},
        {"stiffness", "springs of their own", [](Sheet& s) { s.enable(CD_STIFFNESS_U), s.enable(CD_STIFFNESS_V); }},
        {"pin", "a node inside pinned",
         [n](Sheet& s) {
             const double pinned = CD_NODE_PINNED;
             s.enable(CD_PIN);
             check(cd_membrane_write_f64(s.get(), CD_PIN, n / 2, n / 2, 1, 1, &pinned, 1));
         }},
        {"mask", "a hole",
         [n](Sheet& s) {
             const std::vector<double> absent(n * n / 16);
             s.enable(CD_MASK);
             check(cd_membrane_write_f64(s.get(), CD_MASK, n / 4, n / 4, n / 4, n / 4, absent.data(), absent.size()));
         }},
        {"attachment", "a node tied to a target",
         [n](Sheet& s) { check(cd_membrane_attach(s.get(), n / 2, n / 2, 10, 0.1, nullptr, 0)); }},
        {"symplectic_euler", "symplectic Euler", [](Sheet& s) { s.set(method(Way::symplectic_euler)); }, 1,
         precisions().back(), 0.5 / double(n)},
        {"stiff_second", "stiff second order", [](Sheet& s) { s.set(method(Way::alternating_stiff)); }},
        {"coupled", "λ = 1/2 coupled", [](Sheet& s) { s.set(method(Way::coupled_half)); }},
        {"components_3", "3 components", [](Sheet&) {}, 3}};
    if (precisions().size() > 1) all.push_back({"float64", "float64", [](Sheet&) {}, 1, precisions().front()});
    return all;
}

} // namespace

void report_membrane_features(Report& report) {
    const std::size_t n = report.by_extent<std::size_t>(32, 128), nodes = (n + 1) * (n + 1);
    report.page.section("membrane-features", "Membranes and cloth: what each feature costs");
    report.page.paragraph("A square sheet of " + std::to_string(n) + " × " + std::to_string(n) + " springs in " +
                          name_of(precisions().back()) +
                          ", one component, 60 steps a second, if nothing else is said; "
                          "each feature is switched on alone.");
    std::vector<FeatureCost> costs;
    for (const Feature& feature : features(n)) {
        auto sheet = std::make_shared<Sheet>(n, n, feature.components, feature.precision);
        sheet->pin_edges();
        std::vector<double> v(nodes * feature.components);
        for (std::size_t k = 0; k < v.size(); ++k) {
            const std::size_t i = k / feature.components % (n + 1), j = k / feature.components / (n + 1);
            if (i > 0 && j > 0 && i < n && j < n) v[k] = std::sin(0.2 * double(i)) * std::sin(0.15 * double(j));
        }
        sheet->write(CD_VELOCITY, v);
        sheet->set(method(Way::alternating_half));
        feature.add(*sheet);
        const double dt = feature.dt;
        const std::size_t steps = feature.key == "coupled" ? 2 : report.by_extent<std::size_t>(4, 20);
        check(cd_membrane_step(sheet->get(), dt, 1));
        std::size_t bytes = 0;
        check(cd_membrane_get_memory(sheet->get(), &bytes));
        costs.push_back({feature.key, feature.name, [=] { check(cd_membrane_step(sheet->get(), dt, steps)); },
                         double(nodes * steps), double(bytes) / double(nodes)});
    }
    report_features(report, "membrane", costs,
                    "What makes rows or columns differ (a hole, masses or springs of their own, a tie) "
                    "takes the dearer steps that are safe on any sheet.");
}

} // namespace report
