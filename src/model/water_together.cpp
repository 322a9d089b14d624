// Steps of a water that work on both axes at once: the explicit one, and coupled ones, in which the change of the
// surface solves the system of all cells,
//
//      x_c + sum over its faces of spring (x_c - x_neighbour) = what would flow into it if the surface stayed as it is
//
// a lattice of masses and springs, as a membrane has it, and solved by the same conjugate gradients.
#include "model/water_work.hh"

#include <math.h>
#include <string.h>

namespace cd {

namespace {

template <class Body> void in_rows(const Water& w, size_t rows, const Body& body) {
    in_parts(w.parallel, rows, w.cells[kX], body);
}

// The system's ground and springs from the faces' springs, and from what cells store.
template <class T> double build_system(const WaterStepper<T>& s, WaterTogether& both) {
    const Water& w = s.w;
    const size_t nx = w.cells[kX], ny = w.cells[kY];
    double stiffest = 0;
    for (size_t j = 0; j < ny; ++j)
        for (size_t i = 0; i < nx; ++i) {
            const size_t at = j * w.pitch + i;
            const bool there = present(w, i, j);
            double ground = there ? both.stores[at] : 0, sum = 0;
            for (Axis a : {kX, kY}) {
                const size_t along = a == kX ? i : j, n = w.cells[a], next = at + s.stride(a);
                const double *const spring = both.planes[a].spring, before = spring[at], behind = spring[next];
                const bool ring = periodic(w, a);
                both.spring[a][at] = along + 1 < n || ring ? behind : 0;
                // to the water outside, which stays where it is
                if (along == 0 && !ring) ground += before;
                if (along + 1 == n && !ring) ground += behind;
                sum += before + behind;
            }
            both.ground[at] = there ? ground : 0;
            stiffest = ground + sum > stiffest ? ground + sum : stiffest;
        }
    both.system.wrap(both.spring[kX]);
    return stiffest;
}

// A step in which waves cross so many cells somewhere that water may run dry on the way.
template <class T> bool is_long(const WaterStepper<T>& s) {
    const Water& w = s.w;
    double deepest = 0;
    each_cell(w, [&](size_t i, size_t j) {
        const double d = double(numbers<T>(w.depth)[place(w, i, j)]);
        deepest = d > deepest ? d : deepest;
    });
    const double courant = s.dt / (w.size[kX] < w.size[kY] ? w.size[kX] : w.size[kY]);
    return w.gravity * (courant * courant) * deepest > kLongStep;
}

// Hardly anything is what a cell stores that runs dry; it moves all the same.
constexpr double kHardly = 0x1p-40;

// Newton's method, as of a line (water_surface.hh): cells that would come out below empty store nothing; those which a
// step of it took out by mistake may return in the first 8. Whether any changed.
template <class T> bool wet_set_changes(const WaterStepper<T>& s, WaterTogether& both, size_t pass) {
    const Water& w = s.w;
    const double *const x = both.planes[kX].face, *const y = both.planes[kY].face;
    bool changes = false;
    each_cell(w, [&](size_t i, size_t j) {
        const size_t at = place(w, i, j);
        const double d = double(numbers<T>(w.depth)[at]), stored = d + both.change[at];
        const double all = d + ((x[at] + x[at + 1]) + (y[at] + y[at + w.pitch]));
        const bool stores = both.stores[at] == 1, now = stores ? stored >= 0 : pass < 8 && stored > 0x1p-20 * all;
        changes |= now != stores;
        both.stores[at] = now ? 1 : kHardly;
    });
    return changes;
}

// What comes into cells if the surface stays as it is; and all of the water of those that shall be empty.
template <class T> void load_system(const WaterStepper<T>& s, const WaterCells& cells, WaterTogether& both) {
    const Water& w = s.w;
    in_rows(w, w.cells[kY], [&](size_t first, size_t count) {
        s.kernels().gather_loads(cells, both.load, first, count);
        for (size_t j = first; s.work.thins && j < first + count; ++j)
            for (size_t i = 0; i < w.cells[kX]; ++i) {
                const size_t at = place(w, i, j);
                if (both.stores[at] < 1) both.load[at] += double(numbers<T>(w.depth)[at]);
            }
    });
}

} // namespace

// x = the change of the surface, in work.both.change. What is left of the loads is depth that goes astray: it shall
// stay far below the change, which in very long steps asks for more than the tolerance does.
template <class T> static void solve_surface(WaterStepper<T>& s, const WaterCells& cells) {
    Water& w = s.w;
    WaterTogether& both = s.work.both;
    for (size_t k = 0; k < w.pitch * w.cells[kY]; ++k) both.stores[k] = 1;
    Convergence reached;
    bool changes = true;
    for (size_t pass = 0; changes; ++pass) {
        load_system(s, cells, both);
        const double stiffest = build_system(s, both);
        if (pass == 0) both.preconditioner.first.build(); // it need not know which cells run dry
        const Goal goal{w.tolerance, stiffest, 0, w.most_iterations, sqrt(w.tolerance), pass > 0};
        reached = solve_coupled(both.system, both.preconditioner, goal, both.gradient, both.load, both.change);
        if (reached.iterations > s.worst.iterations) s.worst.iterations = reached.iterations;
        ++w.factorizations;
        changes = s.work.thins && wet_set_changes(s, both, pass);
    }
    if (!(reached.residual <= s.worst.residual)) s.worst.residual = reached.residual;
    s.worst.reached &= reached.reached;
    both.noise = reached.left;
}

// Not in steps in which waves cross many cells: there it would make energy.
template <class T> static void look_beside(const WaterStepper<T>& s, const WaterCells& cells) {
    const Water& w = s.w;
    if (s.work.thins || cells.columns == 1 || cells.rows == 1) return;
    const WaterBeside<T> beside{cells,
                                s.work.both.planes,
                                {s.dt / w.size[kX], s.dt / w.size[kY]},
                                !s.work.coupled,
                                numbers<T>(w.depth),
                                numbers<T>(w.bed),
                                {s.work.both.load, s.work.both.stores}};
    const auto in_all = [&](auto kernel) {
        in_rows(w, cells.rows, [&](size_t first, size_t count) { kernel(beside, first, count); });
    };
    in_all(s.kernels().balance);
    in_all(s.kernels().look_beside);
}

// An explicit step as calm water makes it, with the planes to work in. False: it is not calm, and has not moved.
template <class T> static bool leap(WaterStepper<T>& s) {
    Water& w = s.w;
    const WaterAxis axis[] = {s.axis_of_step(kX), s.axis_of_step(kY)};
    for (Axis a : {kX, kY})
        if (!may_be_calm(axis[a], s.lines_along(a))) return false;
    const WaterPlanes* const planes = s.work.both.planes;
    T *const depth = numbers<T>(w.depth), *const u = numbers<T>(w.velocity[kX]), *const v = numbers<T>(w.velocity[kY]);
    const WaterGrid<T> grid{w.cells[kX],
                            w.cells[kY],
                            w.pitch,
                            numbers<T>(w.bed),
                            depth,
                            {u, v},
                            reinterpret_cast<T*>(planes[kX].velocity),
                            {reinterpret_cast<T*>(planes[kX].guess), reinterpret_cast<T*>(planes[kY].guess)}};
    bool calm = true;
    s.in_tasks(kX, grid.rows, [&](double* place, size_t first, size_t count) {
        const size_t begin = first * kWaterPack, end = begin + count * kWaterPack;
        if (!s.kernels().leap(axis, grid, place, begin, (end < grid.rows ? end : grid.rows) - begin))
            __atomic_store_n(&calm, false, __ATOMIC_RELAXED);
        return true;
    });
    if (!calm) return false;
    in_rows(w, grid.rows, [&](size_t first, size_t count) {
        for (size_t at = first * w.pitch; at < (first + count) * w.pitch; at += w.pitch) {
            memcpy(depth + at, grid.next_depth + at, grid.columns * sizeof(T));
            memcpy(u + at, grid.next_velocity[kX] + at, (grid.columns + 1) * sizeof(T));
            memcpy(v + at, grid.next_velocity[kY] + at, grid.columns * sizeof(T));
        }
    });
    memset(v + grid.rows * w.pitch, 0, grid.columns * sizeof(T));
    return true;
}

template <class T> void WaterStepper<T>::step_together() {
    if (!work.coupled && leap(*this)) return;
    WaterTogether& both = work.both;
    const size_t rows = w.cells[kY];
    work.thins = work.coupled && is_long(*this);
    const WaterCells cells{w.cells[kX],
                           rows,
                           w.pitch,
                           {periodic(w, kX), periodic(w, kY)},
                           {both.planes[kX].transfer, both.planes[kY].transfer},
                           work.thins};
    const auto along = [&](Axis a, auto kernel) {
        const WaterAxis axis = axis_of_step(a);
        const WaterLines<T> lines = lines_along(a);
        in_tasks(a, lines.lines, [&](double* place, size_t first, size_t count) {
            return kernel(axis, lines, both.planes[a], place, first, count);
        });
    };
    const auto along_each = [&](auto kernel) {
        for (Axis a : {kX, kY}) along(a, [&](const auto&... arguments) { return kernel(arguments...), true; });
    };

    if (work.thins) hold_streams();
    along_each(kernels().guess);
    look_beside(*this, cells);
    if (work.coupled) {
        solve_surface(*this, cells);
        along_each(kernels().finish);
    }

    double* const share = both.load;
    if (!work.thins || !settle_residual(cells)) {
        in_rows(w, rows, [&](size_t first, size_t count) {
            memset(work.tally + first * kTallies, 0, count * kTallies * sizeof(double));
            kernels().share(cells, numbers<T>(w.depth), share, work.tally, first, count);
        });
        count_up(rows);
        in_rows(w, rows + 1, [&](size_t first, size_t count) { kernels().limit(cells, share, first, count); });
    }
    in_rows(w, rows, [&](size_t first, size_t count) {
        if (!kernels().fill(cells, numbers<T>(w.depth), work.held, work.tally, first, count))
            __atomic_store_n(&finite, false, __ATOMIC_RELAXED);
    });
    if (work.thins) hand_on(work.tally);

    for (Axis a : {kX, kY}) {
        along(a, kernels().keep);
        count_up(lines_of(w, a));
    }
    if (w.momentum != CD_MOMENTUM_ADVECTED) return;
    for (Axis a : {kX, kY}) {
        if (!work.thins) {
            carry(a);
            continue;
        }
        carry_at_once(cells, a);
        along(a, kernels().settle);
    }
}

#if CD_WITH_FLOAT32
template void WaterStepper<float>::step_together();
#endif
#if CD_WITH_FLOAT64
template void WaterStepper<double>::step_together();
#endif

} // namespace cd
