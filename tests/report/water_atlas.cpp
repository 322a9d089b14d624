// The water's pages of the stability atlas: depth and step, two depths and step, streams and violent shores.
#include <cfloat>
#include <cmath>
#include <map>
#include <random>

#include "atlas.hpp"
#include "format.hpp"
#include "water_parts.hpp"

namespace report {
namespace {

const std::size_t kCells = 16;

// How fast the water moves at first, in units of the speed of its waves: as slow as the precision lets see.
double gentle(cd_precision precision) { return precision == CD_FLOAT64 ? 1e-6 : 1e-3; }

// A slice of cells of 1 m, half of it `left` and half `right` deep, level, its faces moving at random.
struct Slice {
    std::vector<double> depth, velocity;
    double top;

    Slice(double left, double right, double speed) : top(std::fmax(left, right)) {
        std::mt19937 random(7);
        for (std::size_t i = 0; i < kCells; ++i) depth.push_back(i < kCells / 2 ? left : right);
        velocity.assign(kCells + 1, 0);
        const double wave = std::sqrt(kEarth * std::fmin(left, right));
        for (std::size_t i = 1; i < kCells; ++i) velocity[i] = speed * wave * (double(random()) / 2147483648.0 - 1);
    }

    double face(std::size_t i) const { return (depth[i - 1] + depth[i]) / 2; }

    // What the rounding of every depth may hold.
    long double rounding(cd_precision precision) const {
        const long double last = precision == CD_FLOAT32 ? FLT_EPSILON : DBL_EPSILON;
        long double twice = 0;
        for (double d : depth) twice += kEarth * std::pow(last * d, 2);
        return twice / 2;
    }

    // Above that of the water at rest.
    long double energy(const std::vector<double>& d, const std::vector<double>& u) const {
        long double twice = 0;
        for (std::size_t i = 0; i < kCells; ++i) twice += kEarth * std::pow((long double)d[i] - depth[i], 2);
        for (std::size_t i = 1; i < kCells; ++i) twice += face(i) * (long double)u[i] * u[i];
        return twice / 2;
    }
};

Course run(const Slice& slice, const Method& how, cd_precision precision, double dt) {
    Water water(kCells, 1, 1, 1, precision);
    water.set(how);
    std::vector<double> bed;
    for (double d : slice.depth) bed.push_back(-d); // the surface is at 0, to the bit
    water.write(CD_BED, bed);
    water.write(CD_DEPTH, slice.depth);
    water.write(CD_VELOCITY_X, slice.velocity);
    Watch watch(slice.energy(slice.depth, slice.velocity) + slice.rounding(precision));
    std::size_t made = 0;
    for (std::size_t look : looks()) {
        const cd_status status = cd_water_step(water.get(), dt, look - made);
        if (status == CD_ERROR_DIVERGED) {
            watch.lose();
            break;
        }
        check(status);
        watch.see(slice.energy(water.read(CD_DEPTH), water.read(CD_VELOCITY_X)));
        made = look;
    }
    return watch.course();
}

// Of heights h and what moves them, h'' = -K h, K = g D' H D: faces count as deep as the mean of their cells. An energy
// is g (h^2 + (h'/omega)^2) / 2.
std::vector<Vibration> modes_of(const Slice& slice) {
    std::vector<long double> stiffness(kCells * kCells);
    std::vector<double> rate(kCells);
    for (std::size_t i = 1; i < kCells; ++i) {
        const double pull = kEarth * slice.face(i), flow = slice.face(i) * slice.velocity[i];
        stiffness[(i - 1) * kCells + i - 1] += pull, stiffness[i * kCells + i] += pull;
        stiffness[(i - 1) * kCells + i] -= pull, stiffness[i * kCells + i - 1] -= pull;
        rate[i - 1] -= flow, rate[i] += flow;
    }
    std::vector<Vibration> modes =
        vibrations_of(stiffness, std::vector<double>(kCells, 1), std::vector<double>(kCells), rate);
    for (Vibration& mode : modes) mode.weight = 1;
    return modes;
}

// Theory is of small waves. Where they have grown large, water runs far in a step, or the deep half rounds away what
// the shallow one does, all it says is whether they grow.
Expected expected(const Slice& slice, const std::vector<Vibration>& modes, const Method& how, cd_precision precision,
                  double dt, double speed) {
    const Course course = course_of(modes, how, dt);
    Expected small(course, precision);
    const bool grows = small.likeliest() == Fate::growing || small.likeliest() == Fate::not_finite;
    const double courant = dt * std::sqrt(kEarth * slice.top);
    const bool seen = slice.rounding(precision) < 1e-3L * slice.energy(slice.depth, slice.velocity);
    if (grows && seen) return Expected({Fate::growing, Fate::not_finite});
    if (grows) return Expected({Fate::growing, Fate::not_finite, Fate::bounded, Fate::damped});
    if (speed * courant > 0.05 || !seen) return Expected({small.likeliest(), Fate::bounded, Fate::damped});
    return small;
}

AtlasCase chart(const std::string& sweep, const Method& how, cd_precision precision, const AtlasAxis& x,
                const AtlasAxis& y, const std::function<Slice(double)>& slice_at) {
    AtlasCase made{"water", sweep, how, precision, x, y, {}, {}};
    std::map<double, std::pair<Slice, std::vector<Vibration>>> known;
    for (double value : x.values) known.insert({value, {slice_at(value), modes_of(slice_at(value))}});
    made.practice = [=](double value, double dt) { return run(known.at(value).first, how, precision, dt); };
    made.theory = [=](double value, double dt) {
        const auto& [slice, modes] = known.at(value);
        return expected(slice, modes, how, precision, dt, gentle(precision));
    };
    made.finding = [=](double value, double) -> std::string {
        if (sweep != "depth ratio") return "";
        if (precision == CD_FLOAT32 && value < 100 * FLT_EPSILON)
            return "the film is thinner than a few roundings of the deep water beside it";
        const bool low = precision == CD_FLOAT32 || value > 1e4 * std::pow(gentle(precision), 2);
        return low ? "" : "waves in the deep half are higher than a hundredth of the film's depth";
    };
    return made;
}

} // namespace

void report_water_atlas(Report& report) {
    report.page.section("water-atlas", "Water: which steps are stable");
    report.page.paragraph(
        "The same for a slice of 16 cells of 1 m, walled in, whose water is level and moves slowly at random. Depth "
        "is water's stiffness: waves run at √(g d).");
    Atlas atlas(report, "water");
    const AtlasAxis depth{"depth", "depth [m]", decades(-12, 4, report.by_extent(4.0, 1.0))},
        ratio{"ratio", "depth of one half / the other's, 1 m", decades(-12, 0, report.by_extent(3.0, 1.0))},
        step{"dt", "time step [s]", decades(-9, 6, report.by_extent(1.5, 0.5))};
    std::vector<std::string> deep, stepped;
    for (Way way : {Way::water_forward, Way::water_explicit, Way::water_half, Way::water_linear, Way::water_one,
                    Way::water_advected})
        for (cd_precision precision : precisions()) {
            const std::string map = atlas.add(chart("depth", method(way), precision, depth, step,
                                                    [=](double d) { return Slice(d, d, gentle(precision)); }));
            if (precision == precisions().front()) deep.push_back(map);
        }
    for (Way way : {Way::water_explicit, Way::water_half, Way::water_linear, Way::water_one, Way::water_advected})
        for (cd_precision precision : precisions()) {
            const std::string map = atlas.add(chart("depth ratio", method(way), precision, ratio, step,
                                                    [=](double r) { return Slice(1, r, gentle(precision)); }));
            if (precision == precisions().front()) stepped.push_back(map);
        }
    report.page.figure(deep, fate_legend(),
                       "Depth and step: " + atlas.agreement() + "; drawn is " + name_of(precisions().front()) +
                           ". Explicit steps are bounded below dt = 2/ω; above it they grow, until the limiter, which "
                           "lets no cell give more than it has, holds them. λ = 1/2 is bounded, and λ = 0.55 and λ = 1 "
                           "damp what is too fast for the step.",
                       300);
    report.page.figure(stepped, fate_legend(),
                       "A step in the bed, from no step at all to a film of 10⁻¹² m beside water 1 m deep: the deep "
                       "half sets the explicit limit, and implicit steps do not mind.",
                       300);
    add_streams(report, atlas);
    atlas.finish();
    report_shores(report);
}

} // namespace report
