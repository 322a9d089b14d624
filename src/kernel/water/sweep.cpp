// Sweeps of a water along one axis: lines between memory and panels, and the parts that they make their step in.
#include "kernel/water/sweep.hh"

#include "kernel/water/carry.hh"
#include "kernel/water/limiter.hh"
#include "kernel/water/surface.hh"
#include "kernel/water/velocity.hh"

namespace cd {
namespace CD_ISA {

namespace {

// What a line's step was: what came in and went out at its ends, in how many parts it was made, what faces let through.
template <int N> struct WaterStep {
    Lanes<N> in, out, parts;
    Panel<N> moved;
};

// > 0 in lines in which hulls, or what pushes from outside by more than the water beside stands over its bed, may press
// a cell dry; winds on films do not count.
template <int N> Lanes<N> squeezed(const WaterLine<N>& line, Lanes<N> deepest) {
    Lanes<N> most{};
    for (size_t i = 0; line.pressed() && i < line.n; ++i) most = larger(line.squeezed_in(i), most);
    for (size_t i = line.first_face(); line.acceleration && i < line.n; ++i) {
        const auto l = line.cell(line.left(i)), r = line.cell(i);
        const Lanes<N> a = line.acceleration[i], over = select(a, r.surface() - l.bed, l.surface() - r.bed);
        const Lanes<N> d = larger(over, kRoughChange * deepest);
        most = larger(line.open(i) * size_of(a) - (line.sweep.gravity * line.sweep.courant) * d, most);
    }
    return most;
}

// Depths and velocities after it are in the panels `after` and `speed`. all: for what went through faces in all parts.
template <int N> __attribute__((noinline)) WaterStep<N> make_step(WaterLine<N>& line, Lanes<N> fastest,
                                                                  Lanes<N> deepest, Lanes<N> shallowest, Panel<N> all) {
    using L = Lanes<N>;
    const WaterSweep& sweep = line.sweep;
    const size_t n = line.n;
    const L none{}, parts = StepKind<N>::parts_of(sweep, fastest);
    const size_t most = size_t(largest_in(parts));
    WaterStep<N> out{none, none, parts, most > 1 ? all : line.flux};
    for (size_t part = 0; part < most; ++part) {
        const L goes_on = parts - L::splat(double(part)); // > 0: makes this part
        if (part > 0) {                                   // from what the last one has left
            deepest = none, shallowest = L::splat(1);
            for (size_t i = 0; i < n; ++i) {
                const L d = settled(line.after[i], kDry);
                line.depth.put(i, d);
                deepest = larger(line.waves_in(i), deepest), shallowest = smaller(d, shallowest);
            }
            const Panel<N> velocity = line.velocity;
            line.velocity = line.speed, line.speed = velocity;
        }
        if (!all_positive(shallowest)) line.follow_water(goes_on);
        StepKind<N> kind(sweep, parts, goes_on, deepest);
        if ((line.pressed() || line.acceleration) && sweep.implicit) kind.bind(squeezed(line, deepest));
        line.step(kind);
        if (most > 1) {
            for (size_t i = 0; i <= n; ++i) {
                line.speed.put(i, select(goes_on, line.speed[i], line.velocity[i]));
                line.flux.put(i, select(goes_on, line.flux[i], none));
                all.put(i, part == 0 ? line.flux[i] : all[i] + line.flux[i]);
            }
            for (size_t i = 0; i < n; ++i) line.after.put(i, select(goes_on, line.after[i], line.depth[i]));
        }
        if (sweep.closed()) continue;
        const L q0 = line.flux[0], q1 = line.flux[n];
        out.in = out.in + (positive(q0) + positive(-q1));
        out.out = out.out + (positive(-q0) + positive(q1));
    }
    return out;
}

struct Sweep {
    const WaterSweep& sweep;
    const WaterLines& lines;
    double* work;

    template <int N> bool bundle(size_t first) const {
        using L = Lanes<N>;
        const size_t n = sweep.cells;
        const Place p = place_of(lines, first, N);
        Panels<N> panel{work, n};
        WaterLine<N> line{sweep, n, sweep.ring()};
        for (Panel<N>* one : {&line.bed, &line.depth, &line.velocity, &line.flux, &line.after, &line.speed, &line.pull,
                              &line.push, &line.spare[0], &line.spare[1]})
            *one = panel();
        if (lines.mask || lines.wall) fetch_openings(p, line.opening = panel());
        if (lines.force || lines.pressure) fetch_acceleration(p, line.acceleration = panel(), line.flux);
        fetch(p, n, lines.bed, line.bed);
        const Reach<N> depths = fetch(p, n, lines.depth, line.depth, {L::splat(1), L{}}); // 1: as far as it matters
        const Reach<N> speeds = fetch(p, n + 1, lines.velocity, line.velocity);
        const L deepest = depths.largest, fastest = larger(speeds.largest, -speeds.least);
        L waves = deepest;
        if (CD_WITH_HULL && lines.load) {
            fetch(p, n, lines.load, line.load = panel());
            fetch(p, n, lines.stiff, line.stiff = panel());
            for (size_t i = 0; i < n; ++i) waves = larger(line.waves_in(i), waves);
        }
        const WaterStep<N> step = make_step(line, larger(fastest, coming_in(line)), waves, depths.least, panel());

        round_depths(line.after, deepest);
        L probe = 0.0 * (step.in + step.out);
        probe = probe + put(p, n, line.after, lines.depth);
        probe = probe + put(p, n + 1, line.speed, lines.velocity, lines.velocity.range().least);
        if (lines.moved) put(p, n + 1, step.moved, lines.moved);
        put_tally(p, {step.in, step.out, line.held_back, line.limited, step.parts});
        return !probe.any_nan();
    }

    // In chains of cells, since one waits long for the next; what they owe at last goes to the last cells that take it.
    // Of water as deep in all cells of a line, but for a factor of 2, none is left but for what double rounds.
    template <int N> void round_depths(Panel<N> depth, Lanes<N> deepest) const {
        using L = Lanes<N>;
        constexpr size_t kChains = 4;
        constexpr double kNoise = 0x1p-44; // of the deepest cell
        const bool wide = lines.depth.wide();
        Rounding<N> chain[kChains] = {{wide}, {wide}, {wide}, {wide}}, rest{wide};
        const size_t n = sweep.cells;
        for (size_t i = 0; i < n; i += kChains)
            for (size_t k = 0; k < kChains && i + k < n; ++k)
                depth.put(i + k, chain[k](larger(L{}, depth[i + k]))); // NaN hides what is < 0
        for (const auto& one : chain) rest.owed = rest.owed + one.owed;
        for (size_t i = n; i-- > 0;) {
            const L more = size_of(rest.owed) - kNoise * deepest;
            if (!any_positive(more)) break;
            rest.owed = select(more, rest.owed, L{});
            depth.put(i, rest(depth[i]));
        }
    }

    // The speed at which water comes in at the ends of a line.
    template <int N> Lanes<N> coming_in(const WaterLine<N>& line) const {
        using L = Lanes<N>;
        L most{};
        for (int e = 0; e < 2; ++e) {
            const WaterEnd& end = sweep.end[e];
            if (end.kind != End::kInflow) continue;
            const L deep =
                larger(line.depth[e ? line.n - 1 : 0], L::splat(critical_depth(end.discharge, sweep.gravity)));
            most = larger(select(deep, size_of(L::splat(end.discharge)) / deep, L{}), most);
        }
        return most;
    }

    // What lets water cross faces: 1, or 0 beside cells that are not there and on walls.
    template <int N> void fetch_openings(const Place& p, Panel<N> to) const {
        const size_t n = sweep.cells;
        const Place bytes{lines.byte_along, lines.byte_across, p.line, p.lanes};
        const bool ring = sweep.ring();
        for (size_t i = 0; i <= n; ++i)
            for (size_t lane = 0; lane < N; ++lane) {
                const auto there = [&](size_t cell) { return !lines.mask || lines.mask[bytes.at(cell, lane)] != 0; };
                bool is_open = true;
                if (i > 0 || ring) is_open = is_open && there(i > 0 ? i - 1 : n - 1);
                if (i < n || ring) is_open = is_open && there(i < n ? i : 0);
                if (lines.wall && ((i > 0 && i < n) || ring))
                    is_open = is_open && lines.wall[bytes.at(i < n ? i : 0, lane)] == 0;
                to.first[i * N + lane] = is_open ? 1 : 0;
            }
    }

    // What forces and pressures add to velocities in the step. pressure: scratch.
    template <int N> void fetch_acceleration(const Place& p, Panel<N> to, Panel<N> pressure) const {
        using L = Lanes<N>;
        const size_t n = sweep.cells;
        if (lines.force) fetch(p, n + 1, lines.force, to);
        for (size_t i = 0; i <= n; ++i) to.put(i, lines.force ? sweep.dt * to[i] : L{});
        if (!lines.pressure) return;
        fetch(p, n, lines.pressure, pressure);
        for (size_t i = sweep.ring() ? 0 : 1; i < n; ++i)
            to.put(i, to[i] - lines.pressure_share * (pressure[i] - pressure[i > 0 ? i - 1 : n - 1]));
    }

    template <int N> void put_tally(const Place& p, const Lanes<N> (&tally)[kTallies]) const { // by WaterTally
        double sums[kTallies][N];
        for (int t = 0; t < kTallies; ++t) tally[t].store(sums[t]);
        for (size_t k = 0; k < p.lanes; ++k)
            for (int t = 0; t < kTallies; ++t) lines.tally[(p.line + k) * kTallies + size_t(t)] = sums[t][k];
    }
};

} // namespace

bool sweep_water(const WaterSweep& sweep, const WaterLines& lines, double* work, size_t first, size_t count) {
    return in_bundles(Sweep{sweep, lines, work}, lines.lines, first, count);
}

} // namespace CD_ISA
} // namespace cd
