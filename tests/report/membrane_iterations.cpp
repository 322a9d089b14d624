// How many iterations the coupled solver takes, on sheets of every kind.
#include <cmath>
#include <random>

#include "format.hpp"
#include "membrane_parts.hpp"

namespace report {
namespace {

struct SheetKind {
    std::string key, name;
    double anisotropy;  // stiffness along u over that along v
    std::function<void(Sheet&, std::size_t n, double stiffness)> change;
};

std::vector<double> at_random(std::size_t count, const std::function<double(double)>& of_share) {
    std::mt19937 random(1);
    std::vector<double> values;
    for (std::size_t i = 0; i < count; ++i) values.push_back(of_share(double(random()) / 4294967296.0));
    return values;
}

void pin_corners(Sheet& sheet, std::size_t n, double) {
    sheet.enable(CD_PIN);
    for (std::size_t u : {std::size_t(0), n}) {
        const double pinned = CD_NODE_PINNED;
        check(cd_membrane_write_f64(sheet.get(), CD_PIN, u, n, 1, 1, &pinned, 1));
    }
}

void cut_round(Sheet& sheet, std::size_t n, double) {
    std::vector<double> mask;
    for (std::size_t v = 0; v <= n; ++v)
        for (std::size_t u = 0; u <= n; ++u)
            mask.push_back(std::hypot(double(u) - 0.5 * double(n), double(v) - 0.5 * double(n)) <=
                           0.5 * double(n) + 0.01);
    sheet.enable(CD_MASK);
    sheet.write(CD_MASK, mask);
}

void scatter_springs(Sheet& sheet, std::size_t n, double stiffness) {
    for (cd_field field : {CD_STIFFNESS_U, CD_STIFFNESS_V}) {
        sheet.enable(field);
        sheet.write(field,
                    at_random(n * (n + 1), [=](double share) { return stiffness * std::pow(10, 6 * share - 6); }));
    }
}

void nothing(Sheet&, std::size_t, double) {}

const std::vector<SheetKind>& sheet_kinds() {
    static const std::vector<SheetKind> kKinds = {{"uniform", "uniform, free", 1, nothing},
                                                  {"corners", "two corners pinned", 1, pin_corners},
                                                  {"round", "cut round", 1, cut_round},
                                                  {"anisotropic", "stiffer along u, 10⁴ times", 1e4, nothing},
                                                  {"random", "springs at random, 10⁶ apart", 1, scatter_springs}};
    return kKinds;
}

struct Convergence {
    std::size_t iterations;
    double residual;
    bool reached;
};

// Of one step of lambda = 1/2 at 60 a second from random velocities.
Convergence convergence(const SheetKind& kind, std::size_t n, double stiffness) {
    Sheet sheet(n, n, 1, precisions().front());
    check(cd_membrane_set_stiffness(sheet.get(), stiffness, stiffness / kind.anisotropy));
    kind.change(sheet, n, stiffness);
    std::vector<double> velocity = at_random((n + 1) * (n + 1), [](double share) { return 2 * share - 1; });
    velocity[n * (n + 1)] = velocity[n * (n + 1) + n] = 0;  // where corners are pinned
    if (kind.key == "round") {
        const std::vector<double> mask = sheet.read(CD_MASK);
        for (std::size_t k = 0; k < velocity.size(); ++k) velocity[k] *= mask[k];
    }
    sheet.write(CD_VELOCITY, velocity);
    sheet.set(method(Way::coupled_half));
    const cd_status status = cd_membrane_step(sheet.get(), 1.0 / 60, 1);
    if (status != CD_ERROR_TOLERANCE) check(status);
    Convergence found{0, 0, status == CD_OK};
    check(cd_membrane_get_convergence(sheet.get(), &found.iterations, &found.residual));
    return found;
}

}  // namespace

void report_membrane_iterations(Report& report) {
    report.page.section("membrane-iterations", "Membranes and cloth: iterations of the coupled solver");
    report.page.paragraph(
        "One step of λ = 1/2 at 60 a second from random velocities, to a residual of 10⁻⁶, in " +
        std::string(name_of(precisions().front())) +
        ". Stiffness over mass is that of the sheet as a whole [1/s²]; between two nodes it is the square of the side "
        "times as much. Conjugate gradients, preconditioned by one multigrid cycle; at most 100 iterations, the "
        "default.");
    std::vector<std::size_t> sides = {32, 64, 128, 256, 512};
    std::vector<double> stiffnesses = {1, 1e2, 1e4, 1e6, 1e8};
    if (report.extent == Extent::sample) sides = {32, 64}, stiffnesses = {1, 1e4, 1e8};
    Csv csv("sheet,side,stiffness_over_mass,iterations,residual,reached");
    std::vector<std::string> panels;
    std::size_t most = 0, unreached = 0;
    double worst_residual = 0;
    for (const SheetKind& kind : sheet_kinds()) {
        HeatMap map;
        map.title = kind.name;
        map.y_label = "springs a side";
        map.x_label = "stiffness over mass, 1/s²";
        map.cell_width = 58, map.row_label_width = 60;
        for (double stiffness : stiffnesses) map.columns.push_back(nearest_power_of_ten(stiffness));
        for (std::size_t n : sides) {
            map.rows.push_back(std::to_string(n));
            for (double stiffness : stiffnesses) {
                const Convergence found = convergence(kind, n, stiffness);
                map.shade.push_back(std::log(double(std::max<std::size_t>(found.iterations, 1))) / std::log(100.0));
                map.cells.push_back(found.reached ? std::to_string(found.iterations) : "> 100");
                map.tips.push_back("residual " + number(found.residual, 2));
                csv.row(kind.key, n, stiffness, found.iterations, found.residual, int(found.reached));
                if (found.reached && kind.key != "random") most = std::max(most, found.iterations);
                if (!found.reached) ++unreached, worst_residual = std::fmax(worst_residual, found.residual);
                if ((n == sides.back() || n == 64) && (stiffness == 1 || stiffness == 1e4 || stiffness == 1e8))
                    report.summary(
                        "membrane.iterations." + kind.key + ".n" + std::to_string(n) + ".k" + plain(stiffness),
                        double(found.iterations), "iterations");
            }
        }
        panels.push_back(render(map));
        report.progress("membrane iterations: " + kind.name);
    }
    report.page.figure(panels, "",
                       "Sheets of one kind, however held, cut or stretched, take at most " + std::to_string(most) +
                           " iterations. " +
                           (unreached ? std::to_string(unreached) +
                                            " of the solves with springs at random ended short of their tolerance, "
                                            "with a residual of up to " +
                                            number(worst_residual, 2) + "; the step then says so."
                                      : std::string("Springs at random over six decades are the hardest; all solves "
                                                    "reached their tolerance.")),
                       320);
    report.save("membrane_iterations.csv", csv);
    report.summary("membrane.iterations.most_but_for_random_springs", double(most), "iterations");
    report.summary("membrane.iterations.short_of_tolerance", double(unreached), "solves");
}

}  // namespace report
