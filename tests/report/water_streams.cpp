// Streams, whose ripples must not grow, and violent shores, which must gain no energy.
#include <cmath>
#include <random>

#include "atlas.hpp"
#include "format.hpp"
#include "water_parts.hpp"

namespace report {
namespace {

const std::size_t kCells = 32;
const double kRipple = 1e-6, kMostParts = 64; // of the depth; that a step is made in (see water.h)

// A stream round a ring of cells of 1 m in steps of 1 s, in which waves cross `courant` cells in still water.
Course stream(const Method& how, cd_precision precision, double froude, double courant) {
    Water water(kCells, 1, 1, 1, precision);
    water.set(how);
    check(cd_water_set_side(water.get(), CD_SIDE_X_FIRST, CD_BORDER_PERIODIC, 0, 0));
    const double run = froude * courant, deep = courant * courant / kEarth;
    std::mt19937 random(7);
    std::vector<double> depth;
    for (std::size_t i = 0; i < kCells; ++i)
        depth.push_back(deep * (1 + kRipple * (double(random()) / 2147483648.0 - 1)));
    water.write(CD_DEPTH, depth);
    water.write(CD_VELOCITY_X, std::vector<double>(kCells + 1, run));
    auto energy = [&] {
        const std::vector<double> d = water.read(CD_DEPTH), u = water.read(CD_VELOCITY_X);
        long double twice = 0;
        for (std::size_t i = 0; i < kCells; ++i)
            twice += kEarth * std::pow((long double)d[i] - deep, 2) + deep * std::pow((long double)u[i] - run, 2);
        return twice / 2;
    };
    Watch watch(energy());
    std::size_t made = 0;
    for (std::size_t look : looks()) {
        const cd_status status = cd_water_step(water.get(), 1, look - made);
        if (status == CD_ERROR_DIVERGED) {
            watch.lose();
            break;
        }
        check(status);
        watch.see(energy());
        made = look;
    }
    return watch.course();
}

// ---- violent shores ----

const std::size_t kSide = 24;

struct Shore {
    std::vector<double> bed, depth;
    double first = 0; // energy above that of the same water at rest, over density

    Shore() {
        std::mt19937 random(11);
        double volume = 0;
        bed = over_cells(kSide, kSide, 1, [](double x, double y) {
            return 1.5 * std::exp(-(std::pow(x - 15, 2) + std::pow(y - 12, 2)) / 16) + (x > 20 ? 0.4 * (x - 20) : 0);
        });
        for (double b : bed) {
            depth.push_back(b < 1.2 ? std::fmax(0, 1 - b) * (0.5 + double(random()) / 4294967296.0) : 0);
            volume += depth.back();
        }
        double low = 0, high = 10;
        for (int i = 0; i < 100; ++i) {
            level_ = (low + high) / 2;
            double held = 0;
            for (double b : bed) held += std::fmax(0, level_ - b);
            (held < volume ? low : high) = level_;
        }
        first = above_rest(depth, {}, {});
    }

    // Exact, since volume is kept: d (b + d/2) summed, less the same of the level lake, plus what moves.
    double above_rest(const std::vector<double>& d, const std::vector<double>& u, const std::vector<double>& v) const {
        double sum = 0;
        for (std::size_t k = 0; k < d.size(); ++k) {
            const double rest = std::fmax(0, level_ - bed[k]);
            sum += kEarth * (d[k] * (bed[k] + d[k] / 2) - rest * (bed[k] + rest / 2));
        }
        for (std::size_t j = 0; j < kSide; ++j)
            for (std::size_t i = 1; i < kSide; ++i) {
                if (!u.empty())
                    sum += (d[j * kSide + i - 1] + d[j * kSide + i]) / 4 * std::pow(u[j * (kSide + 1) + i], 2);
                if (!v.empty()) sum += (d[(i - 1) * kSide + j] + d[i * kSide + j]) / 4 * std::pow(v[i * kSide + j], 2);
            }
        return sum;
    }

private:
    double level_ = 0;
};

// The highest energy over 200 steps, over that at the start.
double highest(const Shore& shore, const Method& how, cd_precision precision, double dt) {
    Water water(kSide, kSide, 1, 1, precision);
    water.set(how);
    water.write(CD_BED, shore.bed);
    water.write(CD_DEPTH, shore.depth);
    double most = 0;
    for (std::size_t step = 0; step < 200; ++step) {
        const cd_status status = cd_water_step(water.get(), dt, 1);
        if (status == CD_ERROR_DIVERGED) return INFINITY;
        check(status);
        most = std::fmax(most,
                         shore.above_rest(water.read(CD_DEPTH), water.read(CD_VELOCITY_X), water.read(CD_VELOCITY_Y)));
    }
    return most / shore.first;
}

} // namespace

void add_streams(Report& report, Atlas& atlas) {
    const AtlasAxis froude{"froude", "Froude number", decades(-3, 3, report.by_extent(1.0, 0.5))},
        courant{"courant", "Courant number", decades(-3, 3, report.by_extent(1.0, 0.5))};
    std::vector<std::string> maps;
    for (Way way : {Way::water_half, Way::water_linear, Way::water_one, Way::water_advected, Way::water_explicit,
                    Way::water_explicit_advected}) {
        AtlasCase chart{"water", "stream", method(way), precisions().front(), froude, courant, {}, {}};
        chart.practice = [way](double f, double c) { return stream(method(way), precisions().front(), f, c); };
        // Explicit steps are bounded where waves cross less than a cell in each part that they are made in.
        chart.theory = [way](double f, double c) {
            double parts = 1;
            while (parts < kMostParts && parts < 2 * f * c) parts *= 2;
            if (!method(way).is_explicit() || c < 0.99 * parts) return Expected({Fate::bounded, Fate::damped});
            return Expected({Fate::growing, Fate::not_finite, Fate::bounded, Fate::damped});
        };
        chart.finding = [](double f, double c) -> std::string {
            return 2 * f * c > kMostParts ? "the stream runs more than 32 cells in a step (see water.h)" : "";
        };
        maps.push_back(atlas.add(chart));
    }
    report.page.figure(maps, fate_legend(),
                       "Streams: water runs round a ring of " + std::to_string(kCells) + " cells with ripples of " +
                           number(kRipple, 1) +
                           " of its depth. The Froude number is its speed over that of its waves, the Courant number "
                           "how many cells these would cross in a step if it stood still. The equations let ripples "
                           "run and never grow.",
                       300);
}

void report_shores(Report& report) {
    const Shore shore;
    Plot plot;
    plot.title = "energy at its highest in 200 steps";
    plot.x = {"Courant number: cells a wave 1 m deep runs in a step", Scale::log};
    plot.y = {"over that at the start, above rest", Scale::log};
    plot.guides = {{NAN, 1, NAN, 1, ""}};
    Csv csv("method,courant,highest_energy_over_first");
    std::vector<std::string> words;
    for (Way way : {Way::water_linear, Way::water_one, Way::water_advected}) {
        const Method& how = method(way);
        Series series{how.name, how.style, {}, {}, {}};
        double most = 0, at = 0;
        for (double courant : decades(-1, 5, report.by_extent(1.0, 0.5))) {
            const double ratio = highest(shore, how, precisions().front(), courant / std::sqrt(kEarth));
            series.x.push_back(courant), series.y.push_back(ratio);
            csv.row(how.key, courant, ratio);
            if (ratio > most) most = ratio, at = courant;
        }
        plot.series.push_back(series);
        words.push_back(how.name + " " + number(most, 2) + " times, at " + number(at, 2));
        report.summary("water.shores.highest_energy_over_first." + how.key, most, "times");
    }
    report.page.figure({render(plot)}, legend(plot.series),
                       "Violent shores: energy rises at most, by method and Courant number: " + list_words(words) +
                           ". A lake with an island and a beach whose depth is random from cell to cell; no energy "
                           "comes in, and so none should be more than 1.");
    report.save("water_shores.csv", csv);
    report.progress("water: violent shores");
}

} // namespace report
