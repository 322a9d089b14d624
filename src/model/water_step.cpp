// Steps of a water (model.md, 32 and 33): sources, then a sweep along each axis (kernel/water/line.hh tells the step of
// a line), and, of advected momentum, what each sweep carries of the other axis' velocities.
#include "base/parallel.hh"
#include "base/sum.hh"
#include "model/water_hull.hh"
#include "solve/planes.hh"

namespace cd {

static size_t lines_of(const Water& w, Axis a) { return w.cells[other(a)]; }

// ---- memory ---------------------------------------------------------------------------------------------------------

namespace {

constexpr size_t kMostTasks = 16; // that share a sweep: each needs a place to work

// What steps work with: runs of the scratch memory.
struct WaterWork {
    size_t tasks[2], per_task = 0; // along each axis; numbers
    double *task, *tally;          // tasks lie per_task numbers apart; kTallies numbers per line
    double* moved = nullptr;       // a plane of the state's numbers: through faces, where velocities are carried across
    HullWork hulls{};

    WaterWork(const Water& w, const WaterFeatures& f, Carver& scratch) {
        const size_t panels = kWaterPanels + (f.hulls.count > 0 ? kHullPanels : 0);
        size_t most = 1;
        for (Axis a : {kX, kY}) {
            size_t size = 0;
            scratch.fits =
                scratch.fits && add(w.cells[a], kWaterRoom, size) && multiply(size, panels * kWaterLanes, size);
            per_task = size > per_task ? size : per_task;
            const size_t packs = water_packs(lines_of(w, a));
            tasks[a] = !f.parallel ? 1 : packs < kMostTasks ? packs : kMostTasks;
            most = tasks[a] > most ? tasks[a] : most;
        }
        size_t size = 0, lines = w.cells[kX] > w.cells[kY] ? w.cells[kX] : w.cells[kY];
        scratch.fits = scratch.fits && multiply(per_task, most, size) && multiply(lines, kTallies, lines);
        task = scratch.numbers(size);
        tally = scratch.numbers(lines);
        if (CD_WITH_ADVECTED && f.momentum == CD_MOMENTUM_ADVECTED)
            moved = scratch.numbers(w.plane * number_size(w) / sizeof(double) + 1);
        if (f.hulls.count == 0) return;
        for (double** plane : {&hulls.load, &hulls.stiff, &hulls.own[0], &hulls.own[1]})
            *plane = scratch.numbers(w.plane);
        hulls.before = scratch.numbers(w.plane * number_size(w) / sizeof(double) + 1);
        hulls.impulse = scratch.numbers(3 * f.hulls.count);
    }
};

} // namespace

bool needs_of(const Water& w, const WaterFeatures& f, size_t& scratch) {
    Carver carver{nullptr};
    WaterWork work(w, f, carver);
    scratch = carver.taken;
    return carver.fits;
}

HullWork hull_work(const Water& w) {
    Carver scratch{w.scratch.data};
    return WaterWork(w, features(w), scratch).hulls;
}

// ---- steps ----------------------------------------------------------------------------------------------------------

namespace {

struct Stepper {
    Water& w;
    WaterWork& work;
    double dt;
    double done = 0; // steps made in this call
    bool finite = true;

    const WaterKernels& kernels() const { return *w.kernels; }
    StateNumbers moved() const { return {work.moved, is_wide(w)}; }
    // Whether what moves along an axis carries velocities of the other one: there are faces between its lines, or of a
    // ring of one line from it to itself.
    bool carries(Axis a) const {
        return work.moved && w.cells[a] > 1 && (w.cells[other(a)] > 1 || periodic(w, other(a)));
    }
    size_t stride(Axis a) const { return a == kX ? 1 : w.pitch; }
    size_t byte_stride(Axis a) const { return a == kX ? 1 : w.cells[kX] + 1; }

    // Makes a step. False if a number left the finite range.
    bool step() {
        finite = true;
        if (CD_WITH_SLEEP && w.sleep > 0) choose_awake(w, moved(), dt);
        else w.tiles.all_awake = true;
        w.awake = !CD_WITH_SLEEP || w.tiles.all_awake ? w.cells[kX] * w.cells[kY] : awake_cells(w);
        if (w.source) add_sources();
        const Axis first = Axis(w.first);
        sweep_under_hulls(first, true);
        sweep_under_hulls(other(first), false);
        if constexpr (CD_WITH_HULL)
            if (w.hull_shape.count > 0) {
                finite &= move_hulls(w, work.hulls, dt);
                settle_hulls(w, work.hulls);
                finite &= hulls_finite(w);
            }
        if (CD_WITH_SLEEP && w.sleep > 0) survey_awake(w);
        w.first = other(first);
        done += 1;
        return finite;
    }

    void sweep_under_hulls(Axis a, bool first) {
        if (!CD_WITH_HULL || w.hull_shape.count == 0) return sweep(a);
        if constexpr (CD_WITH_HULL) {
            const double courant = dt / (w.size[kX] < w.size[kY] ? w.size[kX] : w.size[kY]);
            work.hulls.run = w.gravity * (courant * courant);
            load_hulls(w, work.hulls, first);
            sweep(a);
            feel_water(w, work.hulls, a, w.method == CD_METHOD_IMPLICIT ? w.lambda : 0.5, dt);
        }
    }

    void sweep(Axis a) {
        if (w.awake == 0) return;
        const WaterSweep along = sweep_along(a);
        if (along.cells == 1 && along.closed() && !along.ring()) return; // nothing moves
        WaterLines lines = lines_along(a);
        memset(lines.tally, 0, lines.lines * kTallies * sizeof(double));
        in_runs(a, along, lines, kernels().sweep);
        count_up(lines.lines);
        if (!CD_WITH_ADVECTED || !carries(a)) return;
        // It carries the velocities across it, too, which lie on the faces between the lines.
        lines.velocity = state_of(w, w.velocity[other(a)]), lines.wall_between = w.wall[other(a)].data;
        lines.seam = all_awake(w) && periodic(w, other(a));
        in_runs(a, along, lines, kernels().carry_across);
        for (size_t i = 0; lines.seam && i < along.cells; ++i) // the faces 0 and n are one
            lines.velocity.put(i * stride(a) + lines.lines * stride(other(a)), lines.velocity[i * stride(a)]);
    }

    // A pass over packs of lines, both kinds of which have the same arguments, of all that is awake: each run of awake
    // tiles is a line of its own, with a wall where it meets tiles that sleep.
    void in_runs(Axis a, const WaterSweep& along, const WaterLines& lines, decltype(WaterKernels::sweep) pass) {
        const size_t packs = water_packs(lines_of(w, a)), tasks = work.tasks[a] < packs ? work.tasks[a] : packs;
        auto task = [&](size_t t) {
            const size_t first = packs * t / tasks, end = packs * (t + 1) / tasks;
            double* const place = work.task + t * work.per_task;
            bool good = true;
            if (all_awake(w)) good = pass(along, lines, place, first, end - first);
            for (size_t pack = first; pack < end && !all_awake(w); ++pack)
                w.tiles.each_run(a, pack, along.cells, [&](size_t from, size_t to) {
                    WaterSweep run = along;
                    run.first = from, run.cells = to - from;
                    if (from > 0) run.end[0] = {End::kWall, 0, 0, 0, 0};
                    if (to < along.cells) run.end[1] = {End::kWall, 0, 0, 0, 0};
                    good &= pass(run, lines, place, pack, 1);
                });
            if (!good) __atomic_store_n(&finite, false, __ATOMIC_RELAXED);
        };
        parallel_for(w.parallel, tasks, task);
    }

    WaterSweep sweep_along(Axis a) const {
        const bool implicit = w.method == CD_METHOD_IMPLICIT;
        const double theta = implicit ? w.lambda : w.method == CD_METHOD_FORWARD_EULER ? 0 : 0.5;
        const double time = time_at(theta);
        return {0,
                w.cells[a],
                dt,
                dt / w.size[a],
                theta,
                implicit,
                w.gravity,
                w.drag,
                w.gravity * w.manning * w.manning,
                w.momentum == CD_MOMENTUM_ADVECTED,
                {end_of(a, false, time), end_of(a, true, time)}};
    }

    // In a part of the step, as the clock counts however steps share calls: of whole steps the sum does not round.
    double time_at(double part) const {
        if (w.clock.dt != dt) return w.clock.time() + (done + part) * dt;
        return w.clock.start + ((double(w.clock.counted) + done) + part) * dt;
    }

    WaterEnd end_of(Axis a, bool at_last, double time) const {
        const WaterSide& side = w.side[side_of(a, at_last)];
        const double value = side_value(side, time);
        const bool carries = CD_WITH_ADVECTED && w.momentum == CD_MOMENTUM_ADVECTED;
        switch (side.kind) {
        case CD_BORDER_OPEN: return {End::kOpen, value, dt * side.rate, 0, 0};
        case CD_BORDER_LEVEL: return {End::kLevel, value, dt * side.rate, 0, 0};
        case CD_BORDER_INFLOW:
            return {End::kInflow, 0, 0, value, value > 0 && carries ? w.inflow_depth[side_of(a, at_last)] : 0};
        case CD_BORDER_PERIODIC: return {End::kRing, 0, 0, 0, 0};
        default: return {End::kWall, 0, 0, 0, 0};
        }
    }

    WaterLines lines_along(Axis a) const {
        WaterLines lines{};
        lines.lines = lines_of(w, a);
        lines.numbers = {stride(a), stride(other(a))}, lines.bytes = {byte_stride(a), byte_stride(other(a))};
        lines.depth = state_of(w, w.depth), lines.bed = state_of(w, w.bed);
        lines.velocity = state_of(w, w.velocity[a]), lines.force = state_of(w, w.force[a]);
        lines.pressure = state_of(w, w.pressure), lines.across = state_of(w, w.velocity[other(a)]);
        lines.pressure_share = dt / (w.density * w.size[a]);
        lines.load = {work.hulls.load, true}, lines.stiff = {work.hulls.stiff, true};
        lines.mask = w.mask.data, lines.wall = w.wall[a].data;
        if (carries(a)) lines.moved = moved();
        lines.tally = work.tally;
        return lines;
    }

    // Adds up what `lines` lines have to tell; of their parts the most.
    void count_up(size_t lines) {
        Sum sums[kParts];
        double parts = 0;
        for (size_t k = 0; k < lines; ++k) {
            const double* const t = work.tally + k * kTallies;
            for (int which = 0; which < kParts; ++which)
                if (t[which] != 0) sums[which].add(t[which]); // seldom
            parts = t[kParts] > parts ? t[kParts] : parts;
        }
        w.account.in += sums[kIn].value() * cell_area(w);
        w.account.out += sums[kOut].value() * cell_area(w);
        w.limited_volume += sums[kHeldBack].value() * cell_area(w);
        w.limited_cells += uint64_t(sums[kLimited].value());
        w.factorizations += uint64_t(parts);
    }

    // f(cell) for those of a line that are awake, as all are that have sources.
    template <class F> void each_awake(Axis along, size_t line, F f) const {
        const auto run = [&](size_t first, size_t end) {
            for (size_t k = first; k < end; ++k) f(k);
        };
        if (all_awake(w)) run(0, w.cells[along]);
        else w.tiles.each_run(along, line / kTile, w.cells[along], run);
    }

    // What rounding takes from a cell the next wet one gets, line by line: small sources are not lost on deep water.
    void add_sources() {
        Sum in, out;
        const Axis along = Axis(w.first);
        const StateNumbers depth = state_of(w, w.depth), sources = state_of(w, w.source);
        Rounding<1> rounding{depth.wide()};
        const auto add_to = [&](size_t i, size_t j) {
            const size_t at = place(w, i, j);
            const double source = sources[at], d = depth[at];
            if (source == 0 || !present(w, i, j)) return;
            const double added = dt * source > -d ? dt * source : -d;
            (added > 0 ? in : out).add(added > 0 ? added : -added);
            depth.put(at, rounding({d + added}).v);
            finite &= depth[at] <= most_of(w);
        };
        for (size_t line = 0; line < lines_of(w, along); ++line)
            each_awake(along, line, [&](size_t k) { along == kX ? add_to(k, line) : add_to(line, k); });
        w.account.in += in.value() * cell_area(w);
        w.account.out += out.value() * cell_area(w);
    }
};

} // namespace

uint64_t step_water(Water& w, double dt, size_t count) {
    Carver scratch{w.scratch.data};
    WaterWork work(w, features(w), scratch);
    w.limited_cells = 0;
    w.limited_volume = 0;
    Stepper stepper{w, work, dt};
    uint64_t diverged_at = 0;
    for (size_t s = 0; s < count; ++s)
        if (!stepper.step() && diverged_at == 0) diverged_at = w.clock.steps + s + 1;
    w.clock.advance(dt, count);
    w.diverged = diverged_at != 0;
    if (w.diverged) stop_closed(w); // what is not finite leaks over walls
    return diverged_at;
}

} // namespace cd
