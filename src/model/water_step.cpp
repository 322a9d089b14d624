// Steps of a water: sources, then a sweep along each axis (kernel/water_line.hh has the equations, model.md section 5
// their origin), and, of advected momentum, what each sweep carries of the other axis' velocities. Or both axes at
// once: water_together.cpp.
#include "model/water_work.hh"

namespace cd {

// ---- memory ---------------------------------------------------------------------------------------------------------

namespace {

constexpr size_t kMostTasks = 16; // that share a sweep: each needs a place to work

// Numbers for one task, of either axis.
bool task_size(const Water& w, size_t& out) {
    out = 0;
    for (Axis a : {kX, kY}) {
        size_t size;
        if (!add(w.cells[a], 2, size) || !multiply(size, kWaterPanels * water_lanes(lines_of(w, a)), size))
            return false;
        out = size > out ? size : out;
    }
    return true;
}

void carve_together(const Water& w, const Grid& grid, bool coupled, WaterTogether& both, Carver& coefficients,
                    Carver& scratch) {
    for (WaterPlanes& planes : both.planes) {
        for (double** plane : {&planes.velocity, &planes.face, &planes.guess, &planes.transfer})
            *plane = scratch.plane(grid);
        if (coupled)
            for (double** plane : {&planes.gain, &planes.spring}) *plane = scratch.plane(grid);
    }
    both.load = scratch.plane(grid);
    if (!coupled) return;
    both.change = scratch.plane(grid);
    for (double** plane : {&both.ground, &both.spring[kX], &both.spring[kY]}) *plane = coefficients.plane(grid);
    for (WaterPlanes& planes : both.planes) planes.change = both.change;

    // Every direction is a ring, joined by a spring of 0 where no side is periodic: a change of sides needs no memory.
    SheetSystem& system = both.system;
    system.kernels = &w.kernels->sheet;
    system.parallel = &w.parallel;
    system.grid = {w.cells[kX], w.cells[kY], grid.pitch};
    scratch.fits &= grid_of(w.cells[kY], w.cells[kX], system.turned);
    for (Axis a : {kX, kY}) system.ring[a] = w.cells[a] > 1;
    system.sheet.mass = system.sheet.ground = both.ground;
    for (Axis a : {kX, kY}) system.sheet.spring[a] = both.spring[a];
    size_t pairs = 0;
    scratch.fits = scratch.fits && multiply(w.cells[kY], kPairs, pairs);
    system.sums = scratch.numbers(pairs);
    both.gradient = GradientPlanes(system, scratch);
    both.preconditioner.first.carve(system, false, coefficients, scratch);
}

} // namespace

WaterWork::WaterWork(const Water& w, const WaterFeatures& f, Carver& coefficients, Carver& scratch)
    : together(f.method == CD_METHOD_SYMPLECTIC_EULER || f.solver == CD_SOLVER_COUPLED),
      coupled(f.method == CD_METHOD_IMPLICIT && f.solver == CD_SOLVER_COUPLED),
      grid{w.cells[kX] + 1, w.cells[kY] + 1, w.pitch},
      per_task(0),
      held(nullptr),
      moved{},
      both{} {
    scratch.fits = scratch.fits && task_size(w, per_task);
    size_t most = 1;
    for (Axis a : {kX, kY}) {
        const size_t packs = water_packs(lines_of(w, a));
        tasks[a] = !f.parallel ? 1 : packs < kMostTasks ? packs : kMostTasks;
        most = tasks[a] > most ? tasks[a] : most;
    }
    size_t size = 0, lines = w.cells[kX] > w.cells[kY] ? w.cells[kX] : w.cells[kY];
    per_task = (per_task + 7) / 8 * 8;
    scratch.fits = scratch.fits && multiply(per_task, most, size) && multiply(lines, kTallies, lines);
    task = scratch.numbers(size);
    tally = scratch.numbers(lines);
    if (together) carve_together(w, grid, coupled, both, coefficients, scratch);
    if (f.momentum == CD_MOMENTUM_ADVECTED || together) held = scratch.plane(grid);
    if (f.momentum == CD_MOMENTUM_ADVECTED && !together) moved[kX] = moved[kY] = scratch.plane(grid);
    both.stores = held; // until depths are filled in
    if (together)
        for (Axis a : {kX, kY}) {
            moved[a] = both.planes[a].transfer;
            both.planes[a].held = held;
        }
}

bool needs_of(const Water& w, const WaterFeatures& f, size_t& coefficients, size_t& scratch) {
    Carver coefficient_carver{nullptr}, scratch_carver{nullptr};
    WaterWork work(w, f, coefficient_carver, scratch_carver);
    coefficients = coefficient_carver.taken;
    scratch = scratch_carver.taken;
    return coefficient_carver.fits && scratch_carver.fits;
}

// ---- steps ----------------------------------------------------------------------------------------------------------

namespace {

template <class T> struct Stepper : WaterStepper<T> {
    using Base = WaterStepper<T>;
    using Base::dt, Base::w, Base::work;

    // Makes a step. False if a number left the finite range.
    bool step() {
        this->finite = true;
        if (w.source) add_sources();
        const Axis first = Axis(w.first);
        if (work.together) {
            this->step_together();
        } else {
            sweep(first);
            sweep(other(first));
        }
        w.first = other(first);
        return this->finite;
    }

    void sweep(Axis a) {
        const WaterAxis axis = this->axis_of_step(a);
        WaterLines<T> lines = this->lines_along(a);
        lines.held = work.held, lines.moved = work.moved[a];
        this->in_tasks(a, lines.lines, [&](double* place, size_t first, size_t count) {
            return this->kernels().sweep(axis, lines, place, first, count);
        });
        this->count_up(lines.lines);
        if (axis.advected) this->carry(a);
    }

    // What rounding takes from a cell the next wet one gets, line by line: small sources are not lost on deep water.
    void add_sources() {
        Sum in, out;
        const Axis along = Axis(w.first);
        double owed = 0;
        for (size_t line = 0; line < lines_of(w, along); ++line) {
            for (size_t k = 0; k < w.cells[along]; ++k) {
                const size_t i = along == kX ? k : line, j = along == kX ? line : k, at = place(w, i, j);
                const double source = double(numbers<T>(w.source)[at]), d = double(numbers<T>(w.depth)[at]);
                if (source == 0 || !present(w, i, j)) continue;
                const double added = dt * source > -d ? dt * source : -d, now = d + added;
                (added > 0 ? in : out).add(added > 0 ? added : -added);
                numbers<T>(w.depth)[at] = stored_depth<T>(now, owed);
            }
        }
        w.account.in += in.value() * cell_area(w);
        w.account.out += out.value() * cell_area(w);
    }
};

template <class T> WaterOutcome step(Water& w, double dt, size_t count) {
    Carver coefficients{w.coefficients.data}, scratch{w.scratch.data};
    WaterWork work(w, features(w), coefficients, scratch);
    w.limited_cells = 0;
    w.limited_volume = 0;
    Stepper<T> stepper{{w, work, dt, {}}};
    uint64_t bad = 0;
    for (size_t s = 0; s < count; ++s) {
        work.done = double(s);
        if (!stepper.step() && bad == 0) bad = w.clock.steps + s + 1;
    }
    w.iterations = stepper.worst.iterations;
    w.residual = stepper.worst.residual;
    return {bad, stepper.worst.reached};
}

} // namespace

WaterOutcome step_water(Water& w, double dt, size_t count) {
    WaterOutcome outcome{};
#if CD_WITH_FLOAT64
    if (w.precision == CD_FLOAT64) outcome = step<double>(w, dt, count);
#endif
#if CD_WITH_FLOAT32
    if (w.precision == CD_FLOAT32) outcome = step<float>(w, dt, count);
#endif
    w.clock.advance(dt, count);
    w.diverged = outcome.diverged_at != 0;
    return outcome;
}

} // namespace cd
