// What a chain's features cost, each switched on alone.
#include <cmath>
#include <memory>

#include "chain_parts.hpp"
#include "features.hpp"

namespace report {
namespace {

struct Feature {
    std::string key, name;
    std::function<void(cd_chain*)> add;
    std::size_t components = 1, strands = 1;
    cd_precision precision = precisions().back();
    double dt = 1.0 / 60;
};

void enable(cd_chain* chain, cd_field field) { check(cd_chain_enable_field(chain, field)); }

std::vector<Feature> features(std::size_t springs) {
    const std::size_t middle = springs / 2;
    std::vector<Feature> all = {
        {"plain", "λ = 1/2, uniform, undamped", [](cd_chain*) {}},
        {"pinned_end", "an end pinned", [](cd_chain* c) { check(cd_chain_set_end(c, CD_END_FIRST, CD_NODE_PINNED)); }},
        {"pinned_inside", "a node inside pinned",
         [=](cd_chain* c) {
             const double pinned = CD_NODE_PINNED;
             check(cd_chain_write_f64(c, CD_PIN, 0, 1, middle, 1, &pinned, 1));
         }},
        {"matched_end", "an end without echo",
         [](cd_chain* c) { check(cd_chain_set_end(c, CD_END_FIRST, CD_NODE_MATCHED)); }},
        {"ring", "a ring", [](cd_chain* c) { check(cd_chain_set_ring(c, 1)); }},
        {"half_ends", "half masses at the ends",
         [](cd_chain* c) { check(cd_chain_set_mass_rule(c, CD_MASS_HALF_ENDS)); }},
        {"gravity", "gravity",
         [](cd_chain* c) {
             const double g = -9.81;
             check(cd_chain_set_gravity(c, &g, 1));
         }},
        {"drag", "drag", [](cd_chain* c) { check(cd_chain_set_drag(c, 0.1)); }},
        {"stiffness_damping", "stiffness damping", [](cd_chain* c) { check(cd_chain_set_stiffness_damping(c, 1e-3)); }},
        {"bend", "bend", [](cd_chain* c) { check(cd_chain_set_bend(c, 1e-3)); }},
        {"mass", "masses of their own", [](cd_chain* c) { enable(c, CD_MASS); }},
        {"stiffness", "springs of their own", [](cd_chain* c) { enable(c, CD_STIFFNESS); }},
        {"bend_field", "bends of their own",
         [](cd_chain* c) {
             check(cd_chain_set_bend(c, 1e-3));
             enable(c, CD_BEND);
         }},
        {"force", "forces", [](cd_chain* c) { enable(c, CD_FORCE); }},
        {"attachment", "a node tied to a target",
         [=](cd_chain* c) { check(cd_chain_attach(c, 0, middle, 10, 0.1, nullptr, 0)); }},
        {"weld", "a spring welded", [=](cd_chain* c) { check(cd_chain_weld(c, 0, middle)); }},
        {"cut", "a spring cut", [=](cd_chain* c) { check(cd_chain_cut(c, 0, middle)); }},
        {"symplectic_euler", "symplectic Euler",
         [](cd_chain* c) { check(cd_chain_set_method(c, CD_METHOD_SYMPLECTIC_EULER)); }, 1, 1, precisions().back(),
         0.5 / double(springs)},
        {"stiff_second", "stiff second order",
         [](cd_chain* c) { check(cd_chain_set_method(c, CD_METHOD_STIFF_SECOND)); }},
        {"components_3", "3 components", [](cd_chain*) {}, 3},
        {"strands_16", "16 strands", [](cd_chain*) {}, 1, 16}};
    if (precisions().size() > 1) all.push_back({"float64", "float64", [](cd_chain*) {}, 1, 1, precisions().front()});
    return all;
}

} // namespace

void report_chain_cost(Report& report) {
    const std::size_t springs = 1000, steps = report.by_extent<std::size_t>(20, 200);
    report.page.section("chain-cost", "Chains: what each feature costs");
    report.page.paragraph("A chain of 1000 springs in " + std::string(name_of(precisions().back())) +
                          ", one component, λ = 1/2, 60 steps a second, if nothing else is said; each feature is "
                          "switched on alone.");
    std::vector<FeatureCost> costs;
    for (const Feature& feature : features(springs)) {
        auto chain = std::make_shared<Chain>(springs, feature.components, feature.precision, feature.strands);
        const std::size_t nodes = (springs + 1) * feature.strands;
        std::vector<double> x(nodes * feature.components);
        for (std::size_t i = 0; i < x.size(); ++i) x[i] = std::sin(0.05 * double(i));
        chain->write(CD_POSITION, x);
        feature.add(chain->get());
        const double dt = feature.dt;
        check(cd_chain_step(chain->get(), dt, 1));
        std::size_t bytes = 0;
        check(cd_chain_get_memory(chain->get(), &bytes));
        costs.push_back({feature.key, feature.name, [=] { check(cd_chain_step(chain->get(), dt, steps)); },
                         double(nodes * steps), double(bytes) / double(nodes)});
    }
    report_features(report, "chain", costs,
                    "Strands share their factorization and fill the vector's lanes; components "
                    "are numbers of one node, which is counted once.");
}

} // namespace report
