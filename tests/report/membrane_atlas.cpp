// The membrane's pages of the stability atlas: stiffness and step, one odd mass and step, both solvers.
#include <cmath>
#include <map>
#include <random>

#include "atlas.hpp"
#include "membrane_parts.hpp"

namespace report {
namespace {

const std::size_t kSide = 8, kLine = kSide + 1;

// All edges held, at rest in random positions.
struct Scene {
    SheetProblem problem;
    double odd_mass = 1;

    Scene(double stiffness, double odd) : odd_mass(odd) {
        problem.nu = problem.nv = kSide;
        problem.edges = Edges::held;
        problem.mass = double(kLine * kLine); // 1 a node
        problem.along_u = problem.along_v = stiffness * double(kLine) / double(kSide);
        std::mt19937 random(7);
        auto any = [&] { return double(float(double(random()) / 2147483648.0 - 1)); };
        problem.position.assign(problem.nodes(), 0), problem.velocity.assign(problem.nodes(), 0);
        for (std::size_t k = 0; k < problem.nodes(); ++k) {
            if (problem.is_held(k % kLine, k / kLine)) continue;
            problem.position[k] = any();
        }
    }

    double mass(std::size_t k) const { return k == kLine * (kSide / 2) + kSide / 2 ? odd_mass : 1; }

    Lattice lattice() const {
        Lattice lattice;
        for (std::size_t k = 0; k < problem.nodes(); ++k) {
            lattice.mass.push_back(mass(k));
            lattice.held.push_back(problem.is_held(k % kLine, k / kLine));
            if (k % kLine < kSide) lattice.springs.push_back({k, k + 1, problem.spring_along_u()});
            if (k / kLine < kSide) lattice.springs.push_back({k, k + kLine, problem.spring_along_u()});
        }
        return lattice;
    }
};

// A solve that ends short of its tolerance goes on.
Course run(const Scene& scene, const Method& how, cd_precision precision, double dt) {
    const Lattice lattice = scene.lattice();
    Watch watch(lattice.energy(scene.problem.position, scene.problem.velocity));
    std::unique_ptr<Runner> textbook;
    Sheet sheet(kSide, kSide, 1, precision);
    if (how.textbook) {
        textbook = make_runner(scene.problem, how, precision);
    } else {
        check(cd_membrane_set_mass(sheet.get(), scene.problem.mass));
        check(cd_membrane_set_stiffness(sheet.get(), scene.problem.along_u, scene.problem.along_v));
        sheet.pin_edges();
        if (scene.odd_mass != 1) {
            std::vector<double> mass;
            for (std::size_t k = 0; k < scene.problem.nodes(); ++k) mass.push_back(scene.mass(k));
            sheet.enable(CD_MASS);
            sheet.write(CD_MASS, mass);
        }
        sheet.write(CD_POSITION, scene.problem.position);
        sheet.write(CD_VELOCITY, scene.problem.velocity);
        sheet.set(how);
    }
    std::size_t made = 0;
    for (std::size_t look : looks()) {
        bool finite = true;
        if (textbook) {
            finite = textbook->step(dt, look - made);
        } else {
            const cd_status status = cd_membrane_step(sheet.get(), dt, look - made);
            finite = status != CD_ERROR_DIVERGED;
            if (finite && status != CD_ERROR_TOLERANCE) check(status);
        }
        if (!finite) {
            watch.lose();
            break;
        }
        watch.see(textbook ? lattice.energy(textbook->positions(), textbook->velocities())
                           : lattice.energy(sheet.read(CD_POSITION), sheet.read(CD_VELOCITY)));
        made = look;
    }
    return watch.course();
}

// sin(p pi i / n) sin(q pi j / n), of unit mass: what the two directions add to the squared frequency is told apart.
std::vector<Vibration> uniform_modes(const Scene& scene) {
    const double n = double(kSide), k = scene.problem.spring_along_u();
    std::vector<Vibration> modes;
    for (std::size_t q = 1; q < kSide; ++q)
        for (std::size_t p = 1; p < kSide; ++p) {
            Vibration mode{2 * std::sqrt(k) * std::sin(double(p) * M_PI / (2 * n)),
                           2 * std::sqrt(k) * std::sin(double(q) * M_PI / (2 * n)), 0, 0, 0};
            for (std::size_t at = 0; at < scene.problem.nodes(); ++at) {
                const double shape = 2 / n * std::sin(double(p * (at % kLine)) * M_PI / n) *
                                     std::sin(double(q * (at / kLine)) * M_PI / n);
                mode.x += shape * scene.problem.position[at];
                mode.w += shape * scene.problem.velocity[at] / mode.omega();
            }
            mode.weight = mode.omega() * mode.omega();
            modes.push_back(mode);
        }
    return modes;
}

std::vector<Vibration> modes_of(const Scene& scene) {
    if (scene.odd_mass == 1) return uniform_modes(scene);
    return scene.lattice().vibrations(scene.problem.position, scene.problem.velocity);
}

AtlasCase chart(const std::string& sweep, const Method& how, cd_precision precision, const AtlasAxis& x,
                const AtlasAxis& y, const std::function<Scene(double)>& scene_at) {
    AtlasCase made{"membrane", sweep, how, precision, x, y, {}, {}, {}, !how.textbook};
    std::map<double, std::pair<Scene, std::vector<Vibration>>> known;
    for (double value : x.values) known.insert({value, {scene_at(value), modes_of(scene_at(value))}});
    made.practice = [=](double value, double dt) { return run(known.at(value).first, how, precision, dt); };
    made.theory = [=](double value, double dt) {
        // Where the directions do not commute, alternating takes the best that lines can give: no modes tell how much.
        const bool open =
            known.at(value).first.odd_mass != 1 && !how.is_explicit() && how.solver == CD_SOLVER_ALTERNATING;
        if (open) return Expected({Fate::bounded, Fate::damped});
        return Expected(course_of(known.at(value).second, how, dt), precision);
    };
    return made;
}

} // namespace

void report_membrane_atlas(Report& report) {
    report.page.section("membrane-atlas", "Membranes and cloth: which steps are stable");
    report.page.paragraph(
        "The same for a sheet of 8 × 8 springs with all edges held, let go from rest in random positions. Theory knows "
        "alternating steps of a uniform sheet mode by mode too; with an odd mass, rows and columns no longer commute, "
        "and all it says of alternating steps is that energy must not grow. (What they keep is an energy in which the "
        "modes that they make heavier count more: from rest, the sheet's own energy cannot rise above its start.)");
    Atlas atlas(report, "membrane");
    const AtlasAxis stiffness{"stiffness", "stiffness over mass [1/s²]",
                              decades(-12, 30, report.by_extent(6.0, 1.5))},
        mass{"mass", "mass of one node / the others'", decades(-12, 12, report.by_extent(4.0, 1.0))},
        step{"dt", "time step [s]", decades(-9, 6, report.by_extent(1.5, 0.5))};
    std::vector<std::string> stiff, odd;
    for (Way way : {Way::forward_euler, Way::symplectic_euler, Way::alternating_half, Way::alternating_backward,
                    Way::alternating_stiff, Way::coupled_half, Way::coupled_backward, Way::coupled_stiff})
        for (cd_precision precision : precisions()) {
            const std::string map = atlas.add(
                chart("stiffness", method(way), precision, stiffness, step, [](double k) { return Scene(k, 1); }));
            if (precision == precisions().back()) stiff.push_back(map);
        }
    for (Way way : {Way::symplectic_euler, Way::alternating_half, Way::alternating_backward, Way::alternating_stiff,
                    Way::coupled_half, Way::coupled_backward})
        for (cd_precision precision : precisions()) {
            const std::string map = atlas.add(
                chart("mass ratio", method(way), precision, mass, step, [](double r) { return Scene(1, r); }));
            if (precision == precisions().back()) odd.push_back(map);
        }
    report.page.figure(stiff, fate_legend(),
                       "Stiffness and step: " + atlas.agreement() + "; drawn is " + name_of(precisions().back()) +
                           ". Every implicit step is bounded or damps, alternating ones less where they make modes "
                           "heavy.",
                       300);
    report.page.figure(odd, fate_legend(),
                       "One odd mass in the middle, stiffness over mass 1: a light node sets the explicit limit of the "
                       "whole sheet, and no implicit step minds.",
                       300);
    atlas.finish();
}

} // namespace report
