// Volume: a lake beside a dry bank, a storm on a beach, and steps of any length.
#include <algorithm>
#include <cmath>
#include <random>

#include "format.hpp"
#include "plot.hpp"
#include "textbook_water.hpp"
#include "water_parts.hpp"

namespace report {
namespace {

Style smooth(Way way) {
    Style style = method(way).style;
    style.marker = Marker::none;
    return style;
}

// ---- a lake beside a dry bank ----

struct Lake {
    static constexpr std::size_t kCells = 100, kRate = 60, kSeconds = 10;
    static constexpr double kLength = 10, kLevel = 1;
    std::vector<double> bed, depth;

    Lake() {
        bed = along_x(kCells, kLength / kCells, [](double x) { return std::fmax(0, 0.4 * (x - 5)); });
        for (double b : bed) depth.push_back(std::fmax(0, kLevel - b));
    }
};

void lake(Report& report) {
    const Lake lake;
    const double dx = Lake::kLength / double(Lake::kCells);
    Water water(Lake::kCells, 1, dx, 1, precisions().front());
    water.write(CD_BED, lake.bed);
    water.write(CD_DEPTH, lake.depth);
    TextbookWater<double> loose(Lake::kCells, 1, dx, 1, kEarth), kept = loose;
    kept.puts_back = true;
    for (TextbookWater<double>* textbook : {&loose, &kept}) {
        textbook->bed = lake.bed;
        for (std::size_t i = 0; i < Lake::kCells; ++i)
            textbook->now[i] = textbook->before[i] = lake.bed[i] + lake.depth[i];
    }
    const double before = water.volume();
    Plot volume, profile;
    volume.title = "volume of the lake";
    volume.x = {"time [s]"};
    volume.y = {"gained", Scale::linear, "%"};
    Series ours{"contdyn", smooth(Way::water_linear), {}, {}, {}},
        theirs{method(Way::water_textbook).name, smooth(Way::water_textbook), {}, {}, {}},
        theirs_kept{method(Way::water_textbook_put_back).name, smooth(Way::water_textbook_put_back), {}, {}, {}};
    theirs.style.colour = 2, theirs_kept.style.colour = 4;
    Csv csv("time_s,contdyn,textbook,textbook_put_back");
    for (std::size_t step = 0; step <= Lake::kSeconds * Lake::kRate; ++step) {
        if (step > 0) {
            check(cd_water_step(water.get(), 1.0 / Lake::kRate, 1));
            loose.step(1.0 / Lake::kRate), kept.step(1.0 / Lake::kRate);
        }
        if (step % 10 > 0) continue;
        const double time = double(step) / Lake::kRate;
        const double gained[] = {water.volume() / before - 1, loose.volume() / before - 1, kept.volume() / before - 1};
        csv.row(time, gained[0], gained[1], gained[2]);
        std::size_t i = 0;
        for (Series* series : {&ours, &theirs, &theirs_kept})
            series->x.push_back(time), series->y.push_back(gained[i++]);
    }
    volume.series = {theirs, theirs_kept, ours};
    profile.title = "its surface after 10 s";
    profile.x = {"x [m], shore at 7.5"};
    profile.y = {"above its level", Scale::linear, "m"};
    const std::vector<double> x = along_x(Lake::kCells, dx, [](double at) { return at; });
    const std::vector<double> surface = water.read(CD_SURFACE), depth = water.read(CD_DEPTH);
    double moved = 0, swung = 0;
    auto above = [&](std::vector<double> h) {
        for (std::size_t i = 0; i < h.size(); ++i) h[i] = h[i] > lake.bed[i] ? h[i] - Lake::kLevel : NAN;
        return h;
    };
    for (std::size_t i = 0; i < Lake::kCells; ++i) {
        moved = std::fmax(moved, std::fabs(depth[i] - lake.depth[i]));
        if (lake.depth[i] > 0) swung = std::fmax(swung, std::fabs(kept.now[i] - Lake::kLevel));
    }
    const Series shown[] = {theirs, theirs_kept, ours};
    const std::vector<double> heights[] = {above(loose.now), above(kept.now), above(surface)};
    for (std::size_t i = 0; i < 3; ++i) profile.series.push_back({shown[i].name, shown[i].style, x, heights[i], {}});
    const double gained = loose.volume() / before - 1;
    report.summary("water.lake.textbook_gained", gained * 100, "%");
    report.summary("water.lake.textbook_put_back_surface_off", swung * 100, "cm");
    report.summary("water.lake.contdyn_gained", std::fabs(water.volume() / before - 1));
    report.summary("water.lake.contdyn_moved", moved, "m");
    report.outcome("water.lake", hex(water.hash()));
    report.page.figure(
        {render(volume), render(profile)}, legend(profile.series),
        "A lake beside a dry bank gains " + percent(gained, 2) +
            " of its volume in 10 s with the notes' face depths, and lies still with the library's. " +
            std::to_string(Lake::kCells) +
            " cells, 60 steps a second. The mean of a wet and a dry column pours water "
            "out of the dry bank into the lake. Put back evenly, the volume is right and the lake is not: its surface "
            "is off by " +
            si(swung, "m", 2) + ". The library's depths " +
            (moved == 0 ? std::string("do not change by a bit") : "are off by " + number(moved, 2) + " m") + ".");
    report.save("water_lake.csv", csv);
}

// ---- a storm on a beach ----

struct Storm {
    static constexpr std::size_t kX = 96, kY = 64;
    Water water;
    std::mt19937 random{7};
    double worst = 0;
    std::uint64_t limited = 0;

    explicit Storm(const Method& how, cd_precision precision) : water(kX, kY, 1, 1, precision) {
        water.set(how);
        cd_water* w = water.get();
        const std::vector<double> bed = over_cells(kX, kY, 1, [](double x, double y) {
            return -2 + 3.5 * x / double(kX) + 0.4 * std::sin(0.21 * y) * std::cos(0.13 * x);
        });
        std::vector<double> depth;
        for (double b : bed) depth.push_back(std::fmax(0, -b));
        water.write(CD_BED, bed);
        water.write(CD_DEPTH, depth);
        check(cd_water_set_manning(w, 0.02));
        for (cd_field field : {CD_FORCE_X, CD_FORCE_Y, CD_SOURCE}) water.enable(field);
        check(cd_water_add_source_rectangle(w, 0, 0, kX, kY, 0.3)); // rain
        check(cd_water_add_source(w, 30, 20, 3, -0.5));             // a drain
    }

    // Gusts, a tide at the open side, a splash now and then.
    void step(std::size_t number, double dt) {
        cd_water* w = water.get();
        const double time = double(number) * dt;
        check(cd_water_set_side(w, CD_SIDE_X_FIRST, CD_BORDER_OPEN, 0.3 * std::sin(0.1 * time),
                                0.03 * std::cos(0.1 * time)));
        if (number % 40 == 0) {
            auto gust = [&](std::size_t n) {
                return std::vector<double>(n, 0.3 * (double(random()) / 2147483648.0 - 1));
            };
            water.write(CD_FORCE_X, gust((kX + 1) * kY));
            water.write(CD_FORCE_Y, gust(kX * (kY + 1)));
            const double x = double(random() % (kX / 2)), y = double(random() % kY);
            check(cd_water_splash(w, x, y, 4, 0.8));
        }
        check(cd_water_step(w, dt, 1));
        std::uint64_t cells = 0;
        check(cd_water_get_limited(w, &cells, nullptr));
        limited += cells;
    }

    double account_error() const {
        double error = 0;
        check(cd_water_get_account(water.get(), nullptr, nullptr, nullptr, &error));
        return std::fabs(error) / water.volume();
    }
};

void storm(Report& report) {
    const std::size_t steps = report.by_extent<std::size_t>(400, 4000);
    const double dt = 1.0 / 20;
    Plot plot;
    plot.title = "volume against the account";
    plot.x = {"steps", Scale::log};
    plot.y = {"off by, relative to the volume", Scale::log};
    Csv csv("method,precision,steps,error_over_volume,through_over_volume,limited_cells");
    double worst[2] = {0, 0}; // float64, float32
    for (Way way : {Way::water_linear, Way::water_advected, Way::water_explicit})
        for (cd_precision precision : precisions()) {
            const Method& how = method(way);
            Storm storm(how, precision);
            Series series{how.name + ", " + name_of(precision), style_of(how, precision), {}, {}, {}};
            for (std::size_t step = 1; step <= steps; ++step) {
                storm.step(step, dt);
                if (step % (steps / 20) > 0) continue;
                double in = 0, out = 0;
                check(cd_water_get_account(storm.water.get(), nullptr, &in, &out, nullptr));
                const double off = storm.account_error(), through = (in + out) / storm.water.volume();
                storm.worst = std::fmax(storm.worst, off);
                series.x.push_back(double(step)), series.y.push_back(std::fmax(off, 1e-17));
                csv.row(how.key, name_of(precision), step, off, through, double(storm.limited));
            }
            plot.series.push_back(series);
            report.summary("water.storm.worst_account_error." + how.key + "." + name_of(precision), storm.worst);
            report.outcome("water.storm " + how.key + " " + name_of(precision), hex(storm.water.hash()));
            double& most = worst[precision == CD_FLOAT32];
            most = std::fmax(most, storm.worst);
        }
    report.page.figure({render(plot)}, legend(plot.series),
                       "A storm on a beach, and every drop is accounted for. " + std::to_string(Storm::kX) + " × " +
                           std::to_string(Storm::kY) + " cells, " + count(double(steps)) +
                           " steps: gusts, rain, a drain, splashes, and a tide at an open side that floods the beach "
                           "and bares it. Volume differs from what was there, came in and went out by at most, "
                           "relative to the volume: " +
                           number(worst[0], 1) + " in float64 and " + number(worst[1], 1) + " in float32.");
    report.save("water_storm.csv", csv);
    report.progress("water: storm");
}

// ---- steps of any length ----

void steps_of_any_length(Report& report) {
    const std::size_t n = 48, steps = report.by_extent<std::size_t>(100, 600);
    std::mt19937 random(3);
    WaterProblem problem;
    problem.nx = problem.ny = n;
    problem.bed = over_cells(n, n, 1, [&](double x, double y) {
        return 1.6 * std::exp(-(std::pow(x - 30, 2) + std::pow(y - 24, 2)) / 60) + (x > 44 ? 0.5 * (x - 44) : 0);
    });
    for (double b : problem.bed)
        problem.depth.push_back(b < 1.2 ? std::fmax(0, 1 - b) * (0.5 + double(random()) / 4294967296.0) : 0);
    double highest = 0;
    for (std::size_t k = 0; k < problem.cells(); ++k)
        if (problem.depth[k] > 0) highest = std::fmax(highest, problem.bed[k] + problem.depth[k]);
    const std::vector<double> courants = {0.5, 5, 50, 500, 5000};
    Table table{{"highest water in " + count(double(steps)) + " steps"}, {}, {}};
    for (double courant : courants) table.head.push_back("Courant " + plain(courant));
    Csv csv("method,courant,highest_m,highest_at_first_m,volume_error,finite");
    double worst = 0, off = 0, textbook_off = 0, explicit_worst = 0;
    for (Way way : {Way::water_linear, Way::water_one, Way::water_advected, Way::water_explicit, Way::water_textbook}) {
        const Method& how = method(way);
        std::vector<std::string> cells = {how.name};
        for (double courant : courants) {
            const double dt = courant / std::sqrt(kEarth * 1.5);
            std::unique_ptr<Runner> runner = make_runner(problem, how, precisions().front());
            double high = 0, volume = 0, first = 0;
            bool finite = true;
            for (double d : problem.depth) first += d;
            for (std::size_t step = 0; finite && step < steps; ++step) {
                finite = runner->step(dt, 1);
                if (step % 20 < 19 && step + 1 < steps) continue;
                volume = 0;
                const std::vector<double> depth = runner->positions();
                for (std::size_t k = 0; k < depth.size(); ++k) {
                    volume += depth[k];
                    if (depth[k] > 1e-6) high = std::fmax(high, depth[k] + problem.bed[k]);
                }
            }
            const double lost = std::fabs(volume / first - 1);
            if (how.textbook) {
                textbook_off = std::fmax(textbook_off, lost);
            } else {
                double& most = how.is_explicit() ? explicit_worst : worst;
                most = std::fmax(most, finite ? high : INFINITY);
                off = std::fmax(off, lost);
            }
            cells.push_back(!finite ? "lost"
                                    : si(high, "m", 3) + (how.textbook ? ", volume off " + percent(lost, 2) : ""));
            csv.row(how.key, courant, finite ? high : INFINITY, highest, finite ? lost : INFINITY, int(finite));
        }
        table.rows.push_back(cells);
    }
    report.summary("water.any_step.highest_water_over_first", worst / highest);
    report.summary("water.any_step.worst_volume_error", off);
    report.summary("water.any_step.textbook_worst_volume_error", textbook_off * 100, "%");
    std::string caption = "Steps of any length keep the water down: from random depths, " + si(highest, "m", 3) +
                          " at the highest, no implicit step takes it beyond " + si(worst, "m", 3) +
                          ", and every way to step keeps its volume to " + number(off, 1) +
                          ". A pool with an island and a beach, " + std::to_string(n) + " × " + std::to_string(n) +
                          " cells; the Courant number of a step is how many cells a wave crosses in it. "
                          "Explicit steps beyond their limit throw it up to " +
                          si(explicit_worst, "m", 3) + ". ";
    report.page.table(table, caption + "The notes' steps change the volume, the more the longer they are.");
    report.save("water_any_step.csv", csv);
    report.progress("water: steps of any length");
}

} // namespace

void report_water_volume(Report& report) {
    report.page.section("water-volume", "Water: kept volume, and steps of any length");
    report.page.paragraph(
        "The notes claim that their water keeps its volume, that it is stable at large steps, and that a step's cost "
        "is "
        "linear in the cells. The last is measured above; here are the other two, for the notes' scheme as printed, "
        "with volume put back and not, and for the library, which keeps depths and flows instead of two surfaces, and "
        "an account of all that comes and goes.");
    lake(report);
    storm(report);
    steps_of_any_length(report);
}

} // namespace report
