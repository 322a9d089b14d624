// What a node and step costs: methods, solvers, components, precisions and sizes, in time and in memory.
#include <cmath>
#include <random>

#include "format.hpp"
#include "membrane_parts.hpp"
#include "textbook_sheet.hpp"
#include "timing.hpp"

namespace report {
namespace {

const double kFrame = 1.0 / 60;

struct Kind {
    Way way;
    std::size_t components;
    cd_precision precision;
    double stiffness;

    std::string name() const {
        return method(way).name +
               (stiffness > 1 ? ", stiffness over mass " + nearest_power_of_ten(stiffness) : std::string());
    }
    std::string key() const {
        return method(way).key + ".c" + std::to_string(components) + "." + name_of(precision) +
               (method(way).solver == CD_SOLVER_COUPLED ? ".k" + plain(stiffness) : "");
    }
};

std::vector<double> random_velocities(std::size_t n, std::size_t components) {
    std::mt19937 random(1);
    std::vector<double> velocity((n + 1) * (n + 1) * components);
    for (std::size_t k = 0; k < velocity.size(); ++k) {
        const std::size_t u = k / components % (n + 1), v = k / components / (n + 1);
        const double speed = double(random()) / 2147483648.0 - 1;
        if (u > 0 && v > 0 && u < n && v < n) velocity[k] = speed;
    }
    return velocity;
}

// One measured thing: something that steps, and what came of it.
struct Measured {
    std::unique_ptr<Sheet> sheet;
    std::unique_ptr<TextbookSheet<double>> textbook;
    std::size_t steps, bytes = 0;
    double nanoseconds = NAN;
    std::size_t iterations = 0;
};

Measured make(const Kind& kind, std::size_t n, const std::vector<double>& velocity, std::size_t steps) {
    Measured made;
    made.steps = steps;
    const Method& how = method(kind.way);
    if (how.textbook) {
        SheetProblem problem;
        problem.nu = problem.nv = n;
        problem.edges = Edges::held;
        made.textbook =
            std::make_unique<TextbookSheet<double>>(n + 1, n + 1, problem.mass_of_node(), problem.spring_along_u());
        for (std::size_t v = 0; v < n; ++v) made.textbook->along_v[v] = problem.spring_along_v(v);
        for (std::size_t k = 0; k < problem.nodes(); ++k)
            made.textbook->held[k] = problem.is_held(k % (n + 1), k / (n + 1));
        made.textbook->v = velocity;
        return made;
    }
    made.sheet = std::make_unique<Sheet>(n, n, kind.components, kind.precision);
    check(cd_membrane_set_stiffness(made.sheet->get(), kind.stiffness, kind.stiffness));
    made.sheet->pin_edges();
    made.sheet->write(CD_VELOCITY, velocity);
    made.sheet->set(how);
    return made;
}

std::vector<Kind> kinds() {
    std::vector<Kind> kinds;
    for (std::size_t components : {1, 3})
        for (Way way : {Way::symplectic_euler, Way::alternating_half})
            for (cd_precision precision : precisions()) kinds.push_back({way, components, precision, 1});
    for (std::size_t components : {1, 3}) kinds.push_back({Way::coupled_half, components, precisions().back(), 1});
    kinds.push_back({Way::coupled_half, 1, precisions().back(), 1e4});
    kinds.push_back({Way::textbook_symplectic, 1, CD_FLOAT64, 1});
    kinds.push_back({Way::textbook_half, 1, CD_FLOAT64, 1});
    return kinds;
}

}  // namespace

void report_membrane_cost(Report& report) {
    report.page.section("membrane-cost", "Membranes and cloth: what a node and step costs");
    report.page.paragraph(
        "A square sheet with all edges held, mass and stiffness 1 if nothing else is said, from random velocities, 60 "
        "steps a second (explicit methods: nine tenths of their limit), on one core. Of a sheet with 3 components a "
        "node has three numbers to move. Coupled is solved to a residual of 10⁻⁶, to which a random state takes the "
        "most iterations. The textbook has one component in float64.");
    std::vector<std::size_t> sides = {256, 1024};
    if (report.extent == Extent::sample) sides = {32, 64};
    Csv csv("side,method,components,precision,stiffness_over_mass,ns_per_node_step,iterations,bytes_per_node");
    Table table{{"method", "components", "precision"}, {}, {2}};
    std::vector<std::vector<std::string>> rows(kinds().size());
    for (std::size_t n : sides) {
        table.head.insert(table.head.end(),
                          {"ns per node and step, " + count(double(n)) + "²", "iterations", "bytes a node"});
        const double nodes = double((n + 1) * (n + 1));
        std::vector<Measured> measured;
        std::vector<Job> jobs;
        for (const Kind& kind : kinds()) {
            const Method& how = method(kind.way);
            const bool coupled = how.solver == CD_SOLVER_COUPLED;
            const std::size_t steps = coupled ? std::max<std::size_t>(1, std::size_t(2e5 / nodes))
                                              : std::max<std::size_t>(4, std::size_t(3e6 / nodes));
            measured.push_back(make(kind, n, random_velocities(n, kind.components), steps));
        }
        for (std::size_t i = 0; i < measured.size(); ++i) {
            const Kind kind = kinds()[i];
            const Method& how = method(kind.way);
            Measured* it = &measured[i];
            double dt = kFrame;
            if (how.is_explicit() && it->sheet) check(cd_membrane_stable_dt(it->sheet->get(), &dt));
            if (how.is_explicit()) dt = it->sheet ? 0.9 * dt : 0.6 / double(n);
            jobs.push_back({[] {},
                            [=] {
                                if (it->sheet) return check(cd_membrane_step(it->sheet->get(), dt, it->steps));
                                for (std::size_t s = 0; s < it->steps; ++s)
                                    how.is_explicit() ? it->textbook->explicit_step(dt, true)
                                                      : it->textbook->implicit_step(dt, how.lambda);
                            }});
        }
        time_in_turns(jobs, report.by_extent(1e-3, 0.1), report.by_extent<std::size_t>(1, 3), 21);
        for (std::size_t i = 0; i < measured.size(); ++i) {
            const Kind kind = kinds()[i];
            const Method& how = method(kind.way);
            Measured& it = measured[i];
            it.nanoseconds = jobs[i].least() / double(it.steps) / nodes * 1e9;
            if (it.sheet) {
                it.iterations = it.sheet->iterations();
                check(cd_membrane_get_memory(it.sheet->get(), &it.bytes));
            }
            const double bytes = double(it.bytes) / nodes;
            if (rows[i].empty())
                rows[i] = {kind.name(), std::to_string(kind.components), name_of(kind.precision)};
            rows[i].insert(rows[i].end(),
                           {number(it.nanoseconds, 3) + spread_words(jobs[i].spread()),
                            it.iterations ? std::to_string(it.iterations) : "",
                            it.bytes ? number(bytes, 3) : ""});
            csv.row(n, how.key, kind.components, name_of(kind.precision), kind.stiffness, it.nanoseconds, it.iterations,
                    bytes);
            const std::string key = ".n" + std::to_string(n) + "." + kind.key();
            report.summary("membrane.cost.ns_per_node_step" + key, it.nanoseconds, "ns");
            if (it.bytes) report.summary("membrane.cost.bytes_per_node" + key, bytes, "bytes");
            if (it.iterations) report.summary("membrane.cost.iterations" + key, double(it.iterations), "iterations");
        }
        report.progress("membrane cost: n = " + std::to_string(n));
    }
    table.rows = rows;
    report.page.table(table,
                      "Time and memory of a node. Coupled steps cost by the iteration, and those by how much the step "
                      "stiffens the sheet.");
    report.save("membrane_cost.csv", csv);
}

}  // namespace report
