// What rows-then-columns costs in truth: how much too slowly a drum's modes swing, how long a stiff drum takes to give
// way to a load, and where the notes' two factors blow up.
#include <algorithm>
#include <cmath>
#include <random>

#include "format.hpp"
#include "membrane_modes.hpp"
#include "membrane_parts.hpp"
#include "textbook_sheet.hpp"

namespace report {
namespace {

const double kFrame = 1.0 / 60;

// ---- a mode's frequency ---------------------------------------------------------------------------------------------

// A mode of a square drum with stiffness 1 along u and less along v.
struct DrumMode {
    std::size_t n = 32, waves = 3;
    double along_v;
    double omega_u, omega_v, omega;
    std::vector<double> shape;

    explicit DrumMode(double stiffness_along_v) : along_v(stiffness_along_v), shape((n + 1) * (n + 1)) {
        const double k = double(waves) * M_PI / double(n);
        omega_u = 2 * std::sqrt(double(n * (n + 1))) * std::sin(k / 2);
        omega_v = omega_u * std::sqrt(along_v);
        omega = std::sqrt(omega_u * omega_u + omega_v * omega_v);
        for (std::size_t v = 1; v < n; ++v)
            for (std::size_t u = 1; u < n; ++u)
                shape[v * (n + 1) + u] = std::sin(k * double(u)) * std::sin(k * double(v));
    }

    // From rest at amplitude 1; of three positions in a row x0 + x2 = 2 x1 cos(omega dt), as lambda = 1/2 keeps
    // amplitudes.
    double measured(const Method& how, double dt) const {
        Sheet sheet(n, n, 1, precisions().front());
        check(cd_membrane_set_stiffness(sheet.get(), 1, along_v));
        check(cd_membrane_set_tolerance(sheet.get(), 1e-12, 100));
        sheet.pin_edges();
        sheet.write(CD_POSITION, shape);
        sheet.set(how);
        double x[3] = {1, 0, 0};
        for (int i = 1; i <= 2; ++i) {
            check(cd_membrane_step(sheet.get(), dt, 1));
            const std::vector<double> now = sheet.read(CD_POSITION);
            double product = 0, squares = 0;
            for (std::size_t k = 0; k < now.size(); ++k) product += now[k] * shape[k], squares += shape[k] * shape[k];
            x[i] = product / squares;
        }
        return std::acos(std::clamp((x[0] + x[2]) / (2 * x[1]), -1.0, 1.0)) / dt;
    }
};

struct Slowness {
    std::string name;
    Way way;
    double along_v;
    Style style;
};

// How many times more slowly than with the coupled solver a mode swings that is as fast along u as along v.
double slower(double lambda_dt_omega) {
    const double each = 1 / std::sqrt(2), dt = 2 * lambda_dt_omega;
    return frequency_of(method(Way::coupled_half), each, each, dt) /
           frequency_of(method(Way::alternating_half), each, each, dt);
}

std::string report_frequencies(Report& report, std::vector<Series>& for_legend) {
    const std::vector<Slowness> kinds = {
        {"coupled", Way::coupled_half, 1, {7, Marker::circle}},
        {"alternating, ω the same along u and v", Way::alternating_half, 1, {1, Marker::square}},
        {"alternating, ω 1/10 along v", Way::alternating_half, 0.01, {3, Marker::diamond}}};
    Plot plot;
    plot.title = "how fast a drum's mode swings";
    plot.x = {"λ dt ω, λ = 1/2", Scale::log};
    plot.y = {"frequency over the true one (lines: theory; marks: library)", Scale::log, "", NAN, 1.5};
    Csv csv("solver,omega_v_over_omega_u,lambda_dt_omega,measured_over_true,theory_over_true");
    double furthest = 0;
    for (const Slowness& kind : kinds) {
        const DrumMode mode(kind.along_v);
        Series line{"", kind.style, {}, {}, {}}, marks{kind.name, kind.style, {}, {}, {}};
        line.style.marker = Marker::none;
        marks.style.line = false;
        for (int i = 0; i <= 60; ++i) {
            const double z = 0.05 * std::pow(2000, double(i) / 60), dt = 2 * z / mode.omega;
            const double theory = frequency_of(method(kind.way), mode.omega_u, mode.omega_v, dt) / mode.omega;
            line.x.push_back(z), line.y.push_back(theory);
            if (i % 6 != 0) continue;
            const double measured = mode.measured(method(kind.way), dt) / mode.omega;
            marks.x.push_back(z), marks.y.push_back(measured);
            furthest = std::fmax(furthest, std::fabs(measured / theory - 1));
            csv.row(kind.way == Way::coupled_half ? "coupled" : "alternating", std::sqrt(kind.along_v), z, measured,
                    theory);
        }
        plot.series.push_back(line);
        plot.series.push_back(marks);
    }
    report.save("membrane_frequencies.csv", csv);
    report.summary("membrane.sluggish.frequency_against_theory", furthest);
    for (double z : {0.5, 1.0, 3.0, 10.0})
        report.summary("membrane.sluggish.coupled_over_alternating_frequency.at_" + plain(z), slower(z), "times");
    for_legend = plot.series;
    return render(plot);
}

// ---- a load on a stiff drum -----------------------------------------------------------------------------------------

// The middle's deflection under gravity 1 after so many steps of backward Euler, over the static one.
struct Load {
    std::size_t n;
    double stiffness, rest;
    std::vector<double> frames, sag;
    std::size_t to_1_percent = 0;  // steps; 0: not within those made
};

double static_sag(std::size_t n, double stiffness) {
    Sheet sheet(n, n, 1, precisions().front());
    check(cd_membrane_set_stiffness(sheet.get(), stiffness, stiffness));
    const double gravity = 1;
    check(cd_membrane_set_gravity(sheet.get(), &gravity, 1));
    check(cd_membrane_set_tolerance(sheet.get(), 1e-12, 100));
    sheet.pin_edges();
    sheet.set(method(Way::coupled_backward));
    check(cd_membrane_step(sheet.get(), 1e9, 1));
    return sheet.read(CD_POSITION)[(n / 2) * (n + 1) + n / 2];
}

Load load(std::size_t n, double stiffness, Way way, std::size_t most) {
    Load load{n, stiffness, static_sag(n, stiffness), {}, {}};
    Sheet sheet(n, n, 1, precisions().front());
    check(cd_membrane_set_stiffness(sheet.get(), stiffness, stiffness));
    const double gravity = 1;
    check(cd_membrane_set_gravity(sheet.get(), &gravity, 1));
    sheet.pin_edges();
    sheet.set(method(way));
    std::size_t done = 0, last_outside = 0;
    auto look = [&] {
        double middle = 0;
        check(cd_membrane_read_f64(sheet.get(), CD_POSITION, n / 2, n / 2, 1, 1, &middle, 1));
        if (std::fabs(middle / load.rest - 1) > 0.01) last_outside = done;
        return middle / load.rest;
    };
    while (done < most) {
        const std::size_t more = std::max<std::size_t>(1, done / 50);  // the time to 1% is known to 2%
        check(cd_membrane_step(sheet.get(), kFrame, more));
        done += more;
        load.frames.push_back(double(done));
        load.sag.push_back(look());
    }
    if (last_outside < done) load.to_1_percent = last_outside + 1;
    return load;
}

std::string report_loads(Report& report, std::vector<Series>& for_legend, std::string& finding) {
    Plot plot;
    plot.title = "a stiff drum gives way to a load";
    plot.x = {"time at 60 steps a second", Scale::log, "s", NAN, 30};
    plot.y = {"deflection of the middle over the static one", Scale::linear, "%"};
    plot.guides = {{NAN, 1, NAN, 1, ""}};
    Csv csv("solver,stiffness_over_mass,step,deflection_over_static");
    const std::size_t n = 32, most = report.by_extent<std::size_t>(2000, 20000);
    std::vector<std::string> words;
    for (double stiffness : {1e2, 1e4, 1e6})
        for (Way way : {Way::coupled_backward, Way::alternating_backward}) {
            const bool coupled = way == Way::coupled_backward;
            const Load run = load(n, stiffness, way, coupled ? 200 : most);
            const int colour = stiffness < 1e3 ? 3 : stiffness < 1e5 ? 1 : 4;
            Series series{(coupled ? "coupled, " : "alternating, ") + std::string("stiffness over mass ") +
                              nearest_power_of_ten(stiffness),
                          {colour, Marker::none, coupled ? Dash::dashed : Dash::solid},
                          {},
                          {},
                          {}};
            for (std::size_t i = 0; i < run.frames.size(); ++i) {
                series.x.push_back(run.frames[i] * kFrame), series.y.push_back(run.sag[i]);
                csv.row(coupled ? "coupled" : "alternating", stiffness, run.frames[i], run.sag[i]);
            }
            plot.series.push_back(series);
            const std::string key = "membrane.sluggish.load.steps_to_1_percent." +
                                    std::string(coupled ? "coupled" : "alternating") + ".k" + plain(stiffness);
            if (run.to_1_percent > 0) report.summary(key, double(run.to_1_percent), "steps");
            if (stiffness > 1e3)
                words.push_back(
                    (run.to_1_percent ? count(double(run.to_1_percent)) : "more than " + count(double(most))) +
                    (coupled ? " coupled" : " alternating"));
        }
    finding = "at stiffness over mass 10⁴ it is there, to 1%, after " + words[0] + " and " + words[1] +
              " steps, at 10⁶ after " + words[2] + " and " + words[3];
    report.save("membrane_load.csv", csv);
    for_legend = plot.series;
    return render(plot);
}

// ---- where the two factors blow up ----------------------------------------------------------------------------------

struct Holding {
    std::string name;
    std::function<bool(std::size_t u, std::size_t v, std::size_t n)> held;
};

const std::vector<Holding>& holdings() {
    static const std::vector<Holding> kHoldings = {
        {"edges held",
         [](std::size_t u, std::size_t v, std::size_t n) { return u == 0 || v == 0 || u == n || v == n; }},
        {"two corners", [](std::size_t u, std::size_t v, std::size_t n) { return v == n && (u == 0 || u == n); }},
        {"the middle", [](std::size_t u, std::size_t v, std::size_t n) { return u == n / 2 && v == n / 2; }},
        {"a round rim", [](std::size_t u, std::size_t v, std::size_t n) {
             const double half = double(n) / 2;
             return std::hypot(double(u) - half, double(v) - half) > half + 0.01;
         }}};
    return kHoldings;
}

double greatest(const std::vector<double>& x) {
    double most = 0;
    for (double value : x) most = std::isfinite(value) ? std::fmax(most, std::fabs(value)) : INFINITY;
    return most;
}

// The greatest speed after 600 steps over that at the start, a random one.
double growth_of(const Holding& holding, double stiffness, const Method& how) {
    const std::size_t n = 32, nodes = (n + 1) * (n + 1);
    std::mt19937 random(1);
    std::vector<double> pins(nodes), velocity(nodes);
    for (std::size_t k = 0; k < nodes; ++k) {
        const double speed = double(random()) / 2147483648.0 - 1;
        pins[k] = holding.held(k % (n + 1), k / (n + 1), n) ? CD_NODE_PINNED : CD_NODE_FREE;
        velocity[k] = pins[k] == CD_NODE_FREE ? speed : 0;
    }
    const double start = greatest(velocity);
    if (how.textbook) {
        SheetProblem problem;
        problem.nu = problem.nv = n;
        problem.along_u = problem.along_v = stiffness;
        TextbookSheet<double> sheet(n + 1, n + 1, problem.mass_of_node(), problem.spring_along_u());
        for (std::size_t v = 0; v < n; ++v) sheet.along_v[v] = problem.spring_along_v(v);
        for (std::size_t k = 0; k < nodes; ++k) sheet.held[k] = pins[k] != CD_NODE_FREE;
        sheet.v = velocity;
        for (int step = 0; step < 600; ++step) sheet.implicit_step(kFrame, how.lambda);
        return greatest(sheet.v) / start;
    }
    Sheet sheet(n, n, 1, precisions().front());
    check(cd_membrane_set_stiffness(sheet.get(), stiffness, stiffness));
    if (&holding == &holdings().front()) sheet.pin_edges();
    else sheet.enable(CD_PIN), sheet.write(CD_PIN, pins);
    sheet.write(CD_VELOCITY, velocity);
    sheet.set(how);
    const cd_status status = cd_membrane_step(sheet.get(), kFrame, 600);
    if (status == CD_ERROR_DIVERGED) return INFINITY;
    check(status);
    return greatest(sheet.read(CD_VELOCITY)) / start;
}

void report_blow_ups(Report& report) {
    const std::vector<double> stiffnesses = {1, 1e2, 1e4, 1e6, 1e8};
    Csv csv("held,stiffness_over_mass,method,textbook,greatest_speed_over_first");
    std::vector<std::string> panels;
    double worst = 0;
    for (Way way : {Way::textbook_half, Way::alternating_half, Way::coupled_half}) {
        const Method& how = method(way);
        HeatMap map;
        map.title = how.textbook               ? "textbook: the notes' two factors"
                    : way == Way::coupled_half ? "library, coupled"
                                               : "library, alternating";
        map.y_label = "held";
        map.x_label = "stiffness over mass, 1/s²";
        map.cell_width = 62, map.row_label_width = 92;
        for (double stiffness : stiffnesses) map.columns.push_back(nearest_power_of_ten(stiffness));
        for (const Holding& holding : holdings()) {
            map.rows.push_back(holding.name);
            for (double stiffness : stiffnesses) {
                const double growth = growth_of(holding, stiffness, how);
                map.shade.push_back(std::isfinite(growth) ? std::clamp(std::log10(growth) / 8, 0.0, 1.0) : 1);
                map.cells.push_back(std::isfinite(growth) ? number(growth, 2) : "lost");
                csv.row(holding.name, stiffness, how.key, int(how.textbook), growth);
                if (how.textbook && holding.name == std::string("two corners") && stiffness == 1e4)
                    report.summary("membrane.safe.textbook_growth_of_speed.two_corners.k10000", growth, "times");
                if (!how.textbook) worst = std::fmax(worst, growth);
            }
        }
        panels.push_back(render(map));
    }
    report.page.figure(
        panels, "",
        "The notes' two factors are safe where whole edges are held, and blow up elsewhere. The greatest speed after "
        "600 steps of λ = 1/2 at 60 a second, over that at the start, which is random. The directions must commute: "
        "one held corner is enough for them not to. The library takes the two factors where they are safe, and "
        "elsewhere the best that rows and columns can give, measured by the system's own energy: its speeds grow by no "
        "more than " +
            number(worst, 2) + ".",
        320);
    report.save("membrane_blow_ups.csv", csv);
    report.summary("membrane.safe.library_greatest_growth_of_speed", worst, "times");
}

}  // namespace

void report_membrane_sluggish(Report& report) {
    report.page.section("membrane-sluggish", "Membranes and cloth: which solver to choose");
    std::vector<Series> frequencies, loads;
    std::string finding;
    const std::string first = report_frequencies(report, frequencies), second = report_loads(report, loads, finding);
    report.page.paragraph(
        "Rows, then columns, is not the two-dimensional system: the product of the two factors, (1 + a)(1 + b), has a "
        "term a b that the sum 1 + a + b has not, where a and b are (λ dt ω)² along u and along v. On a uniform sheet "
        "with whole edges held it acts as mass: a mode moves as if it were 1 + a b times as heavy. It does nothing to "
        "motion along one direction, nor to motion that is slow for the step; and what would be unresolved anyway "
        "becomes slower still. It hurts where a stiff sheet has to follow something: a load, a driven edge, a "
        "neighbour.");
    report.page.figure({first, second}, legend(frequencies) + legend(loads),
                       "What is too fast for the step along both directions, alternating makes slower still. Left: a "
                       "drum's mode, with steps from short to long; at λ dt ω = 1/2 alternating swings " +
                           percent(slower(0.5) - 1, 1) + " more slowly than coupled, at 3 it does " +
                           number(slower(3), 2) + " times more slowly, at 10 it does " + number(slower(10), 2) +
                           " times. Right: a stiff drum of 32 × 32 springs begins to carry a load, λ = 1 at 60 steps a "
                           "second: " +
                           finding +
                           ". Where it comes to rest is the same.");
    report_blow_ups(report);
    report.page.paragraph(
        "Take alternating for drums, flags and soft cloth, for sheets that are stiff along one direction, and for "
        "stiff sheets that swing as one piece: wherever the motion to be seen has λ dt ω of at most about 1 along u or "
        "along v. Take coupled for stiff sheets that bear loads, are driven or pulled at points, or are made of parts "
        "that move against each other, and to check the other. In doubt step a second with both: where they agree, "
        "alternating is right.");
}

}  // namespace report
