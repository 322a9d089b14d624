// Stiff sheets with a slow motion of interest: one that swings as a whole on a soft spring, and a cloth that is stiff
// along one direction while waves run along the other.
#include <algorithm>
#include <cmath>
#include <numeric>

#include "format.hpp"
#include "membrane_modes.hpp"
#include "membrane_parts.hpp"
#include "work_precision.hpp"

namespace report {
namespace {

const double kStiffness = 1e8, kTie = 50;

struct Case {
    Study study;
    SheetProblem problem;
    std::function<double(const Method&, std::size_t)> expected_error;
};

// A free sheet that hangs on a soft spring at a corner, let go with all its nodes in one place: the sum of its slowest
// modes, but for some tie / stiffness that goes into the others.
Case swinging(SheetProblem problem, std::size_t slow, const std::string& key, const std::string& title) {
    Case made;
    made.study.key = key;
    made.study.title = title;
    made.study.time = 1;
    problem.along_u = problem.along_v = kStiffness;
    problem.tie = kTie;
    problem.position.assign(problem.nodes(), 1);
    std::vector<SheetMode> modes = slowest_modes(problem, slow);
    for (SheetMode& mode : modes) {
        const double share = std::accumulate(mode.shape.begin(), mode.shape.end(), 0.0);
        for (double& x : mode.shape) x *= share;
    }
    auto sum = [modes](const std::function<double(double)>& factor) {
        std::vector<double> x(modes.front().shape.size());
        for (const SheetMode& mode : modes) {
            const double share = factor(mode.omega);
            for (std::size_t i = 0; i < x.size(); ++i) x[i] += share * mode.shape[i];
        }
        return x;
    };
    const std::vector<double> exact = sum([](double omega) { return std::cos(omega); });
    made.study.exact = exact;
    made.problem = problem;
    made.expected_error = [=](const Method& how, std::size_t steps) {
        return relative_error(sum([&](double omega) { return mode_after(how, omega, 0, 1 / double(steps), steps); }),
                              exact);
    };
    return made;
}

Case plate(std::size_t n) {
    SheetProblem problem;
    problem.nu = problem.nv = n;
    return swinging(problem, 1, "membrane.stiff", "one stiff plate");
}

// Two square plates, joined along an edge.
Case two_plates(std::size_t n) {
    SheetProblem problem;
    problem.nu = n;
    problem.nv = 2 * n + 1;
    problem.seam = kTie;
    return swinging(problem, 2, "membrane.stiff_pair", "two stiff plates, joined by a soft seam");
}

// Stiff threads along u, a bump that runs along v between two held edges.
Case ruled(std::size_t n) {
    Case made;
    made.study.key = "membrane.stiff_along_u";
    made.study.title = "stiff along u, a wave along v";
    made.study.time = 1;
    SheetProblem& problem = made.problem;
    problem.nu = problem.nv = n;
    problem.along_u = kStiffness;
    problem.edges = Edges::held_along_v;
    std::vector<double> bump(n + 1);
    for (std::size_t v = 1; v < n; ++v) bump[v] = std::exp(-72 * std::pow(double(v) / double(n) - 0.4, 2));
    const SineModes modes(n, 1, bump, n);
    auto spread = [n](const std::vector<double>& along_v) {
        std::vector<double> sheet;
        for (double x : along_v) sheet.insert(sheet.end(), n + 1, x);
        return sheet;
    };
    problem.position = spread(bump);
    made.study.exact = spread(modes.at(made.study.time));
    made.expected_error = [modes](const Method& how, std::size_t steps) { return modes.expected_error(how, 1, steps); };
    return made;
}

void add_curves(const Report& report, Case& of, const std::vector<Way>& ways) {
    of.study.make = runners_of(of.problem);
    const std::size_t limit = std::size_t(std::ceil(of.study.time / (0.9999 * stable_dt(of.problem))));
    for (Way way : ways)
        for (cd_precision precision : precisions()) {
            const Method& how = method(way);
            if (precision != precisions().front() && way != Way::coupled_half && way != Way::alternating_half) continue;
            const std::size_t most = how.solver == CD_SOLVER_COUPLED ? report.by_extent<std::size_t>(128, 600)
                                                                     : report.by_extent<std::size_t>(512, 4096);
            auto expected = [&](std::size_t steps) { return of.expected_error(how, steps); };
            of.study.curves.push_back(
                {&how, precision,
                 points_between(how.is_explicit() ? limit : 8, how.is_explicit() ? limit : most, expected)});
        }
}

// "λ = 1/2 errs by 1% coupled, ..." with 64 steps.
std::string errors_at_64(Report& report, const Study& study) {
    std::vector<std::string> words;
    for (Way way : {Way::coupled_half, Way::alternating_half, Way::textbook_half}) {
        const Point& point = *find_point(study, way, 64);
        report.summary(study.key + ".error_at_64_steps." + method(way).key, point.error * 100, "%");
        words.push_back(percent(point.error) + (way == Way::textbook_half      ? " in the textbook"
                                                : way == Way::alternating_half ? " alternating"
                                                                               : " coupled"));
    }
    return list_words(words);
}

}  // namespace

void report_membrane_stiff(Report& report) {
    const std::size_t n = report.by_extent<std::size_t>(10, 20);
    Case one = plate(n), pair = two_plates(n), threads = ruled(n);
    add_curves(
        report, one,
        {Way::symplectic_euler, Way::alternating_half, Way::alternating_backward, Way::alternating_stiff,
         Way::coupled_half, Way::coupled_backward, Way::coupled_stiff, Way::textbook_symplectic, Way::textbook_half});
    for (Case* of : {&pair, &threads})
        add_curves(report, *of,
                   {Way::symplectic_euler, Way::alternating_half, Way::alternating_stiff, Way::coupled_half,
                    Way::textbook_symplectic, Way::textbook_half});
    const std::string side = std::to_string(n) + " × " + std::to_string(n);
    report.page.section("membrane-stiff", "Membranes and cloth: stiff springs and a slow motion");
    report.page.paragraph(
        "Stiffness over mass 10⁸, as of cloth or tin that must not stretch; its own waves cross it in " +
        si(1 / std::sqrt(kStiffness), "s") + ", nobody wants to see them, yet an explicit step must be shorter than " +
        si(stable_dt(one.problem), "s") + " to survive them. A square plate of " + side +
        " springs is let go at rest from a soft spring at one corner and swings as a whole; two such plates, joined by "
        "a soft seam, swing and move against each other; a sheet that is stiff along u carries a wave along v, where "
        "its stiffness over mass is 1. The error is the greatest over all nodes after 1 s, relative to the greatest "
        "displacement, against the slow modes, found by inverse iteration in extended precision (what a plate's own "
        "waves have of the motion is below 10⁻⁵), and for the wave against the chain's modes.");
    WorkTables tables;
    std::vector<std::string> panels, findings;
    std::vector<Series> series;
    for (Case* of : {&one, &pair, &threads}) {
        measure(report, of->study);
        tables.add(report, of->study, of->study.title);
        panels.push_back(draw(of->study, "run time of 1 simulated second", series));
        const Best implicit = cheapest(of->study, 1e-2, Kind::implicit_steps),
                   explicit_steps = cheapest(of->study, 1e-2, Kind::explicit_steps);
        findings.push_back(of->study.title + " (" + (implicit ? implicit.curve->how->name + ": " : "") +
                           verdict(implicit, explicit_steps) + ")");
        if (of == &pair && implicit && explicit_steps)
            report.page.headline(number(explicit_steps.seconds() / implicit.seconds(), 2) + "×",
                                 "cheaper than explicit steps on stiff plates with a soft seam, at 1% error, by " +
                                     implicit.curve->how->name);
    }
    std::vector<std::string> errors;
    for (Case* of : {&one, &pair, &threads}) errors.push_back(errors_at_64(report, of->study));
    const Point* few = find_point(pair.study, Way::textbook_half, 16);
    report.page.figure(
        panels, legend(series),
        "Cheapest to 1%: " + list_words(findings) + ". With 64 steps λ = 1/2 errs on one plate by " + errors[0] +
            ", on the pair by " + errors[1] + ", with stiff threads by " + errors[2] +
            ". The textbook's two factors fit a sheet whose rows and columns are all alike but for one soft seam; with "
            "16 steps on the pair they err by " +
            percent(few->error) +
            ", and on other sheets they blow up (see below). The explicit runs stand at the one step that their "
            "stability allows.");
    report.page.table(tables.table,
                      "Stiff sheets: the cheapest run that reaches each error. A run counts if all with shorter steps "
                      "are as good: none is taken for its luck.");
    report.save("membrane_stiff_work_precision.csv", tables.points);
    report.save("membrane_stiff_cheapest.csv", tables.cheapest);
    report.summary("membrane.stiff.stable_dt", stable_dt(one.problem), "s");
}

}  // namespace report
