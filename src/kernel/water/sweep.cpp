// Sweeps of a water along one axis: lines between memory and panels, and the parts that they make their step in.
#include "kernel/water/sweep.hh"

#include "kernel/water/limiter.hh"
#include "kernel/water/surface.hh"
#include "kernel/water/velocity.hh"

namespace cd {
namespace CD_ISA {

namespace {

// A line makes its step in 1, 2, 4, ... parts, of which each moves its water by at most so many cells, as far as that
// takes no more than the most.
constexpr double kPartRun = 0.5;
constexpr int kMostParts = 64;

// Begins a part of a step from water that is at most so deep. In a long one waves cross more than a cell, and energy is
// bounded (velocity.hh); of advected momentum all parts of a step are long in whose time they do. Lines are bound as in a
// long step, too, in which hulls, or what pushes from outside by more than the water beside stands over its bed, may press
// a cell dry; winds on films do not count.
void begin_part(WaterLine& line, L deepest) {
    const WaterSweep& sweep = line.sweep;
    L waves = deepest, squeezed{}; // waves: the depth in which they would run as fast without hulls
    for (size_t i = 0; line.pressed() && i < line.n; ++i) {
        const L d = line.depth[i], stiff = line.stiff[i];
        waves = larger(d + stiff * d, waves);
        squeezed = larger(line.load[i] + (stiff - L::splat(2)) * d, squeezed);
    }
    for (size_t i = line.first_face(); line.acceleration && i < line.n; ++i) {
        const Beside c = line.beside(i);
        const L a = line.acceleration[i], over = select(a, c.r.surface() - c.l.bed, c.l.surface() - c.r.bed);
        const L d = larger(over, kRoughChange * waves);
        squeezed = larger(line.open(i) * size_of(a) - (sweep.gravity * sweep.courant) * d, squeezed);
    }
    line.courant = sweep.courant * line.share;
    line.full_push = sweep.theta * (sweep.gravity * line.courant);
    const L run = sweep.advected() ? L::splat(sweep.courant) : line.courant;
    const L square = (sweep.gravity * waves) * (run * run);
    line.is_long = sweep.implicit ? larger(square - L::splat(1), squeezed) : L{};
    line.any_long = any_positive(line.is_long);
}

// The speed at which water comes in at the ends of a line.
L coming_in(const WaterLine& line) {
    L most{};
    for (int e = 0; e < 2; ++e) {
        const WaterEnd& end = line.sweep.end[e];
        if (end.kind != End::kInflow) continue;
        const L deep = line.inflow_depth(end, line.depth[e ? line.n - 1 : 0]);
        most = larger(select(deep, size_of(L::splat(end.discharge)) / deep, L{}), most);
    }
    return most;
}

// The share of the step that the next part of a line makes, of which `left` is left: a step is made in two halves, and
// so is each of them, while its water runs too far in it.
L next_share(L left, L cells) {
    double todo[kLines], run[kLines], share[kLines];
    left.store(todo), cells.store(run);
    for (int k = 0; k < kLines; ++k) {
        const int parts = int(todo[k] * kMostParts);
        int next = parts & -parts; // as half of a half ends
        while (next > 1 && run[k] * next > kPartRun * kMostParts) next /= 2;
        share[k] = double(next) / kMostParts;
    }
    return L::load(share);
}

// Depths and velocities after it are in the panels `after` and `speed`. Returns what went through faces in all parts,
// in the panel `all` if there were several.
__attribute__((noinline)) Panel make_step(WaterLine& line, Reach speeds, Reach depths, Panel all) {
    const size_t n = line.n;
    bool several = false;
    for (L left = L::splat(1);;) {
        const L fastest = larger(larger(speeds.largest, -speeds.least), coming_in(line));
        line.share = next_share(left, line.sweep.courant * fastest);
        line.tally[kParts] = line.tally[kParts] + select(line.share, L::splat(1), L{});
        if (!all_positive(depths.least)) line.follow_water(line.share, line.depth, line.velocity, line.velocity);
        begin_part(line, depths.largest);
        line.step();
        const L goes_on = left;
        left = left - line.share;
        const bool more = any_positive(left), first = !several;
        several |= more;
        for (size_t i = 0; several && i <= n; ++i) { // in lines that have made their step nothing has moved
            line.speed.put(i, select(goes_on, line.speed[i], line.velocity[i]));
            all.put(i, first ? line.flux[i] : all[i] + line.flux[i]);
        }
        if (!line.sweep.closed()) {
            const L q0 = line.flux[0], q1 = line.flux[n];
            line.tally[kIn] = line.tally[kIn] + (positive(q0) + positive(-q1));
            line.tally[kOut] = line.tally[kOut] + (positive(-q0) + positive(q1));
        }
        if (!more) return several ? all : line.flux;
        // The next part begins with what this one has left.
        depths = speeds = {};
        for (size_t i = 0; i < n; ++i) {
            line.depth.put(i, settled(line.after[i], kDry));
            depths.see(line.depth[i]);
        }
        std::swap(line.velocity, line.speed);
        for (size_t i = 0; i <= n; ++i) speeds.see(line.velocity[i]);
    }
}

struct Sweep {
    const WaterSweep& sweep;
    const WaterLines& lines;
    double* work;

    bool bundle(size_t first, size_t lanes) const {
        const size_t n = sweep.cells;
        const Place p = place_of(sweep, lines.numbers, first, lanes);
        double* free = work;
        const auto panel = [&] { return take_panel(free, n); };
        WaterLine line{sweep, n, sweep.ring()};
        for (Panel* one : {&line.bed, &line.depth, &line.velocity, &line.flux, &line.after, &line.speed, &line.pull,
                           &line.spare[0], &line.spare[1]})
            *one = panel();
        const Reach depths = fetch(p, n, lines.depth, line.depth);
        const Reach speeds = fetch(p, n + 1, lines.velocity, line.velocity);
        if (is_dry(line, depths)) {
            if (lines.moved) put(p, n + 1, line.velocity, lines.moved); // 0
            return true;
        }
        if (lines.has_closed_faces())
            fetch_openings(place_of(sweep, lines.bytes, first, lanes), lines, line.cells(), line.opening = panel());
        if (line.opening || sweep.rubs()) line.push = panel();
        if (sweep.rubs() && sweep.advected()) line.pushed = panel();
        if (sweep.advected()) line.even = panel();
        if (lines.force || lines.pressure) fetch_acceleration(p, line, line.acceleration = panel());
        if (sweep.manning > 0) fetch_across(p, first, lanes, line.flux, line.across = panel());
        fetch(p, n, lines.bed, line.bed);
        if (CD_WITH_HULL && lines.load) {
            fetch(p, n, lines.load, line.load = panel());
            fetch(p, n, lines.stiff, line.stiff = panel());
        }
        const Panel moved = make_step(line, speeds, depths, panel());

        round_depths(line.after, moved, depths.largest);
        L probe = 0.0 * (line.tally[kIn] + line.tally[kOut]);
        probe = probe + put(p, n, line.after, lines.depth);
        probe = probe + put(p, n + 1, line.speed, lines.velocity, lines.velocity.range().least);
        if (lines.moved) put(p, n + 1, moved, lines.moved);
        add_tally(first, lanes, line.tally);
        return !probe.any_nan();
    }

    // Whether there is no water, and none comes in: nothing moves.
    bool is_dry(const WaterLine& line, Reach depths) const {
        if (!sweep.closed() || any_positive(depths.largest)) return false;
        L all = size_of(line.velocity[line.n]); // NaN is no water either
        for (size_t i = 0; i < line.n; ++i) all = all + (size_of(line.depth[i]) + size_of(line.velocity[i]));
        return !any_positive(all) && !all.any_nan();
    }

    // In chains of cells, since one waits long for the next. What they owe where water that flows ends goes to the last
    // cells before that take it, so that nothing of it crosses dry land or a wall.
    void round_depths(Panel depth, Panel moved, L deepest) const {
        constexpr size_t kChains = 4;
        const bool wide = lines.depth.wide();
        Rounding<kLines> chain[kChains] = {{wide}, {wide}, {wide}, {wide}};
        const size_t n = sweep.cells;
        const auto hand_back = [&](size_t end, L stops) {
            Rounding<kLines> rest{wide};
            for (auto& one : chain) {
                rest.owed = rest.owed + select(stops, one.owed, L{});
                one.owed = select(stops, L{}, one.owed);
            }
            chain[0].owed = chain[0].owed + round_back(depth, end, rest, deepest);
        };
        L flowed{};
        for (size_t i = 0; i < n; i += kChains)
            for (size_t k = 0; k < kChains && i + k < n; ++k) {
                const L flows = size_of(moved[i + k]), stops = select(flows, L{}, flowed);
                if (!all_positive(flows) && any_positive(stops) && !wide) hand_back(i + k, stops);
                flowed = flows;
                depth.put(i + k, chain[k](larger(L{}, depth[i + k]))); // NaN hides what is < 0
            }
        hand_back(n, L::splat(1));
    }

    // From cell `end` on to the first. Of water as deep in all cells of a line, but for a factor of 2, none is left but for
    // what double rounds.
    [[gnu::noinline]] static L round_back(Panel depth, size_t end, Rounding<kLines> rest, L deepest) {
        constexpr double kNoise = 0x1p-44; // of the deepest cell
        for (size_t i = end; i-- > 0;) {
            const L more = size_of(rest.owed) - kNoise * deepest;
            rest.owed = select(more, rest.owed, L{});
            if (!any_positive(more)) break;
            depth.put(i, rest(depth[i]));
        }
        return rest.owed;
    }

    // Velocities of the other axis lie on the faces beside the line.
    void fetch_across(const Place& p, size_t first, size_t lanes, Panel behind, Panel to) const {
        fetch(p, sweep.cells, lines.across, to);
        fetch(place_of(sweep, lines.numbers, first + 1, lanes), sweep.cells, lines.across, behind);
        for (size_t i = 0; i < sweep.cells; ++i) to.put(i, 0.5 * (to[i] + behind[i]));
    }

    // What forces and pressures add to velocities in the step.
    void fetch_acceleration(const Place& p, const WaterLine& line, Panel to) const {
        const size_t n = line.n;
        const Panel pressure = line.flux; // for now
        if (lines.force) fetch(p, n + 1, lines.force, to);
        for (size_t i = 0; i <= n; ++i) to.put(i, lines.force ? sweep.dt * to[i] : L{});
        if (!lines.pressure) return;
        fetch(p, n, lines.pressure, pressure);
        for (size_t i = line.first_face(); i < n; ++i)
            to.put(i, to[i] - lines.pressure_share * (pressure[i] - pressure[line.left(i)]));
    }

    void add_tally(size_t first, size_t lanes, const L (&tally)[kTallies]) const {
        for (int t = 0; t < kTallies; ++t) {
            double more[kLines];
            tally[t].store(more);
            for (size_t k = 0; k < lanes; ++k) {
                double& sum = lines.tally[(first + k) * kTallies + size_t(t)];
                sum = t != kParts ? sum + more[k] : more[k] > sum ? more[k] : sum;
            }
        }
    }
};

} // namespace

bool sweep_water(const WaterSweep& sweep, const WaterLines& lines, double* work, size_t first, size_t count) {
    return in_bundles(Sweep{sweep, lines, work}, lines.lines, first, count);
}

} // namespace CD_ISA
} // namespace cd
