// A cloth that hangs by two corners falls from level: how far it stretches, how far it has come after a third of a
// second, and what a frame costs, beside position-based dynamics with compliance in the same program.
#include <algorithm>
#include <cmath>
#include <ctime>
#include <numeric>

#include "cloth_xpbd.hpp"
#include "format.hpp"
#include "membrane_parts.hpp"
#include "plot.hpp"

namespace report {
namespace {

const double kFrame = 1.0 / 60, kBend = 0.05;  // bend: times the nodes along a side over its springs, cubed
const std::size_t kFrames = 60, kSettled = 19, // stretch counts from the one on, the fall at the other
    kFallen = 20;

class Cloth {
public:
    explicit Cloth(const ClothScene& scene) : scene(scene) {}
    virtual ~Cloth() = default;
    virtual void reset() = 0;
    virtual void frame() = 0;
    virtual std::vector<double> positions() const = 0; // x, y, z of node v * side + u
    virtual double energy() const { return NAN; }
    virtual std::string hash() const { return ""; }

    const ClothScene scene;
};

class LibraryCloth : public Cloth {
public:
    LibraryCloth(const ClothScene& scene, double lambda, std::size_t newton, std::size_t gradient)
        : Cloth(scene), sheet_(scene.side - 1, scene.side - 1, 3, precisions().back()) {
        cd_membrane* const membrane = sheet_.get();
        const double nodes = double(scene.side), springs = nodes - 1, total = scene.stiffness * nodes / springs;
        const double gravity[3] = {0, -scene.gravity, 0}, pinned = CD_NODE_PINNED;
        check(cd_membrane_set_rest_length(membrane, 1, 1));
        check(cd_membrane_set_mass(membrane, scene.mass));
        check(cd_membrane_set_stiffness(membrane, total, total));
        check(cd_membrane_set_shear(membrane, scene.shear));
        check(cd_membrane_set_bend(membrane, kBend * nodes / std::pow(springs, 3)));
        check(cd_membrane_set_gravity(membrane, gravity, 3));
        check(cd_membrane_set_lambda(membrane, lambda));
        check(cd_membrane_set_effort(membrane, newton, gradient));
        sheet_.enable(CD_PIN);
        for (std::size_t u : {std::size_t(0), scene.side - 1})
            check(cd_membrane_write_f64(membrane, CD_PIN, u, 0, 1, 1, &pinned, 1));
    }
    void reset() override {
        std::vector<double> x;
        for (std::size_t v = 0; v < scene.side; ++v)
            for (std::size_t u = 0; u < scene.side; ++u)
                x.insert(x.end(), {double(u) * scene.length(), 0, double(v) * scene.length()});
        check(cd_membrane_reset(sheet_.get()));
        sheet_.write(CD_POSITION, x);
    }
    void frame() override { check(cd_membrane_step(sheet_.get(), kFrame, 1)); }
    std::vector<double> positions() const override { return sheet_.read(CD_POSITION); }
    double energy() const override {
        double kinetic = 0, elastic = 0, gravity = 0;
        check(cd_membrane_get_energy(sheet_.get(), &kinetic, &elastic, &gravity));
        return kinetic + elastic + gravity;
    }
    std::string hash() const override { return hex(sheet_.hash()); }

private:
    Sheet sheet_;
};

class PositionBasedCloth : public Cloth {
public:
    PositionBasedCloth(const ClothScene& scene, int substeps, int iterations)
        : Cloth(scene), cloth_(scene, substeps, iterations) {}
    void reset() override { cloth_.reset(); }
    void frame() override { cloth_.frame(kFrame); }
    std::vector<double> positions() const override {
        std::vector<double> x;
        for (std::size_t v = 0; v < scene.side; ++v)
            for (std::size_t u = 0; u < scene.side; ++u)
                for (std::size_t k = 0; k < 3; ++k) x.push_back(cloth_.at(u, v, k));
        return x;
    }

private:
    XpbdCloth cloth_;
};

// Frames of some milliseconds lose their turn where other programs run: what counts is the processor's time.
double processor_time() { return double(std::clock()) / CLOCKS_PER_SEC; }

// What runs came to. Stretch: of the springs along u and v, of which slack ones count as 0.
struct Outcome {
    double worst = 0, mean_square = 0; // the greatest of all frames
    double fallen = 0;                 // the mean node, after kFallen frames
    double rise = -INFINITY;           // of the energy, the greatest of all frames
    std::vector<double> seconds;       // of each frame, the least of all runs

    double root_mean_square() const { return std::sqrt(mean_square); }
    double total() const { return std::accumulate(seconds.begin(), seconds.end(), 0.0); }
    double frame() const {
        std::vector<double> sorted = seconds;
        std::sort(sorted.begin(), sorted.end());
        return sorted[sorted.size() / 2];
    }
};

void measure_stretch(const std::vector<double>& x, const ClothScene& scene, Outcome& outcome) {
    const std::size_t n = scene.side;
    double sum = 0;
    for (std::size_t v = 0; v < n; ++v)
        for (std::size_t u = 0; u < n; ++u)
            for (std::size_t along = 0; along < 2; ++along) {
                if ((along == 0 ? u : v) + 1 == n) continue;
                const double *const a = &x[3 * (v * n + u)], *const b = a + 3 * (along == 0 ? 1 : n);
                const double length =
                    std::sqrt(std::pow(b[0] - a[0], 2) + std::pow(b[1] - a[1], 2) + std::pow(b[2] - a[2], 2));
                const double stretch = std::max(0.0, length / scene.length() - 1);
                outcome.worst = std::max(outcome.worst, stretch);
                sum += stretch * stretch;
            }
    outcome.mean_square = std::max(outcome.mean_square, sum / double(2 * n * (n - 1)));
}

double fallen(const std::vector<double>& x) {
    double sum = 0;
    for (std::size_t i = 1; i < x.size(); i += 3) sum -= x[i];
    return sum / double(x.size() / 3);
}

void run(Cloth& cloth, Outcome& outcome) {
    cloth.reset();
    outcome.seconds.resize(kFrames, INFINITY);
    double energy = cloth.energy();
    for (std::size_t f = 1; f <= kFrames; ++f) {
        const double begin = processor_time();
        cloth.frame();
        double& least = outcome.seconds[f - 1];
        least = std::min(least, processor_time() - begin);
        const double before = energy;
        energy = cloth.energy();
        outcome.rise = std::max(outcome.rise, energy - before);
        const std::vector<double> x = cloth.positions();
        if (f >= kSettled) measure_stretch(x, cloth.scene, outcome);
        if (f == kFallen) outcome.fallen = fallen(x);
    }
}

// How far the sheet falls if each step finds its answer.
double converged_fall(const ClothScene& scene, double lambda) {
    LibraryCloth cloth(scene, lambda, 10, 200);
    cloth.reset();
    for (std::size_t f = 0; f < kFallen; ++f) cloth.frame();
    return fallen(cloth.positions());
}

struct Setting {
    std::string key, name;
    double lambda; // of the library; 0: position-based dynamics
    std::size_t outer, inner;

    bool library() const { return lambda > 0; }
    std::size_t curve() const { return lambda == 1 ? 0 : library() ? 1 : inner == 1 ? 2 : 3; }
};

std::vector<Setting> settings() {
    std::vector<Setting> all;
    using Pairs = std::vector<std::pair<std::size_t, std::size_t>>;
    for (double lambda : {1.0, 0.7})
        for (const auto& [newton, gradient] : Pairs{{1, 14}, {2, 10}, {3, 0}, {3, 28}, {6, 40}}) {
            const std::string iterations = std::to_string(newton) + "x" + std::to_string(gradient);
            const std::string effort = gradient == 0
                                           ? "default effort"
                                           : "effort " + std::to_string(newton) + " × " + std::to_string(gradient);
            all.push_back({(lambda == 1 ? "one." : "seven_tenths.") + (gradient == 0 ? "default" : iterations),
                           "library, λ = " + number(lambda, 1) + ", " + effort, lambda, newton, gradient});
        }
    for (const auto& [substeps, iterations] : Pairs{{10, 1}, {30, 1}, {100, 1}, {200, 1}, {400, 1}, {10, 10}})
        all.push_back({"position_based." + std::to_string(substeps) + "x" + std::to_string(iterations),
                       "XPBD, " + std::to_string(substeps) + " × " + std::to_string(iterations), 0, substeps,
                       iterations});
    return all;
}

std::unique_ptr<Cloth> make(const Setting& way, const ClothScene& scene) {
    if (way.library()) return std::make_unique<LibraryCloth>(scene, way.lambda, way.outer, way.inner);
    return std::make_unique<PositionBasedCloth>(scene, int(way.outer), int(way.inner));
}

std::vector<Series> empty_curves() {
    return {{"library, λ = 1", {0, Marker::circle}, {}, {}, {}},
            {"library, λ = 0.7", {1, Marker::circle, Dash::dashed, true}, {}, {}, {}},
            {"XPBD, one iteration a substep", {2, Marker::square}, {}, {}, {}},
            {"XPBD, ten iterations a substep", {3, Marker::diamond}, {}, {}, {}}};
}

struct Results {
    Csv rows{"nodes,way,worst_stretch,rms_stretch,fallen_m,converged_fallen_m,highest_rise_j,ms_per_frame"};
    Table table{{"nodes a side", "way", "worst stretch", "root mean square", "fallen after 1/3 s", "converged step",
                 "time of a frame"},
                {},
                {1}};
    double rise = -INFINITY;
    std::string finding;
};

std::string compared(const std::string& size, const Outcome& ours, const std::map<std::string, Outcome>& all) {
    const Outcome &same = all.at("position_based.100x1"), &more = all.at("position_based.200x1");
    auto stretches = [](const Outcome& o) { return percent(o.worst) + " and " + percent(o.root_mean_square()); };
    return "At " + size + " nodes the library's default effort takes " + si(ours.frame(), "s", 2) +
           " a frame for a worst and root mean square stretch of " + stretches(ours) + "; XPBD takes " +
           si(same.frame(), "s", 2) + " for " + stretches(same) + ", and " + si(more.frame(), "s", 2) + " for " +
           stretches(more) + ". ";
}

// All ways at one size, in turns: once, and more often what is done in a moment.
std::vector<Series> measure(Report& report, std::size_t side, Results& results) {
    const ClothScene scene{side};
    const std::vector<Setting> ways = settings();
    std::vector<std::unique_ptr<Cloth>> cloths;
    std::vector<Outcome> outcomes(ways.size());
    for (const Setting& way : ways) cloths.push_back(make(way, scene));
    const double moment = report.by_extent(0.0, 0.04);
    for (std::size_t round = 0; round < 2; ++round)
        for (std::size_t i = 0; i < ways.size(); ++i)
            if (round == 0 || outcomes[i].total() < moment) run(*cloths[i], outcomes[i]);
    const double converged[2] = {converged_fall(scene, 1), converged_fall(scene, 0.7)};

    std::vector<Series> curves = empty_curves();
    const std::string base = "membrane.cloth.n" + std::to_string(side) + ".";
    std::map<std::string, Outcome> by_key;
    for (std::size_t i = 0; i < ways.size(); ++i) {
        const Setting& way = ways[i];
        const Outcome& outcome = outcomes[i];
        const double exact = converged[way.lambda == 0.7 ? 1 : 0], ms = outcome.frame() * 1e3;
        by_key[way.key] = outcome;
        results.rows.row(side, way.key, outcome.worst, outcome.root_mean_square(), outcome.fallen, exact,
                         way.library() ? plain(outcome.rise) : "", ms);
        results.table.rows.push_back({std::to_string(side), way.name, percent(outcome.worst, 2),
                                      percent(outcome.root_mean_square(), 2), number(outcome.fallen) + " m",
                                      way.library() ? number(exact) + " m" : "", si(outcome.frame(), "s", 3)});
        report.summary(base + way.key + ".worst_stretch", outcome.worst * 100, "%");
        report.summary(base + way.key + ".rms_stretch", outcome.root_mean_square() * 100, "%");
        report.summary(base + way.key + ".fallen", outcome.fallen, "m");
        report.summary(base + way.key + ".ms_per_frame", ms, "ms");
        if (way.library()) {
            report.outcome(base + way.key, cloths[i]->hash());
            results.rise = std::max(results.rise, outcome.rise);
        }
        Series& curve = curves[way.curve()];
        curve.x.push_back(outcome.frame()), curve.y.push_back(outcome.worst), curve.tips.push_back(way.name);
    }
    report.summary(base + "one.converged.fallen", converged[0], "m");
    report.summary(base + "seven_tenths.converged.fallen", converged[1], "m");
    const std::string size = std::to_string(side) + " × " + std::to_string(side);
    if (side <= 64) results.finding = compared(size, by_key.at("one.default"), by_key);
    report.progress("cloth: " + size + " nodes");
    return curves;
}

} // namespace

void report_cloth_drop(Report& report) {
    report.page.section("membrane-cloth", "Membranes and cloth: a cloth that keeps its size");
    report.page.paragraph(
        "A sheet of 1 m and 0.2 kg with springs of 3000 N/m and shear of 100 N/m lies level, is held by two corners "
        "and let go, 60 frames a second. It should hardly stretch, and fall as it would if each step found its answer: "
        "a solver that has not got there keeps its size by falling as through syrup. Position-based dynamics with "
        "compliance (XPBD) is written for this page, of the same springs, which only pull, without bend, and compiled "
        "for each width of vectors in float32; it is given by its substeps a frame and its iterations a substep. The "
        "library makes one step a frame, with bend; its effort is Newton iterations and those of conjugate gradients "
        "in each. Stretch is that of the springs along the sides, the greatest of all frames from 0.3 s to 1 s; "
        "the time is the processor's, of the median frame.");
    std::vector<std::size_t> sizes = {33};
    if (report.extent == Extent::full) sizes.push_back(64);
    Results results;
    std::vector<std::string> panels;
    std::vector<Series> all;
    for (std::size_t side : sizes) {
        Plot plot;
        plot.title = std::to_string(side) + " × " + std::to_string(side) + " nodes";
        plot.x = {"time of a frame", Scale::log, "s"};
        plot.y = {"worst stretch", Scale::log, "%"};
        plot.series = measure(report, side, results);
        panels.push_back(render(plot));
        all.insert(all.end(), plot.series.begin(), plot.series.end());
    }
    report.page.figure(panels, legend(all),
                       results.finding +
                           "With 400 substeps float32 rounds off much of what gravity adds in one, so that more gain "
                           "little and the sheet falls wrongly. Each marker is an effort of the library, or a number "
                           "of substeps; left and down is better.");
    const std::string energy = results.rise > 0
                                   ? "The library's energy rises by at most " + si(results.rise, "J", 2) + " in a step."
                                   : "The library's energy falls in every step.";
    report.page.table(results.table,
                      "The cloth that falls: how far its mean node is below the start after 20 frames, "
                      "beside that of steps of effort 10 × 200. " +
                          energy);
    report.save("cloth_drop.csv", results.rows);
    report.summary("membrane.cloth.highest_rise_of_energy", results.rise, "J");
}

} // namespace report
