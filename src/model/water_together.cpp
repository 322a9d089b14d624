// Steps of a water that work on both axes at once: the explicit one, and coupled ones, in which the change of the
// surface solves the system of all cells,
//
//      x_c + sum over its faces of spring (x_c - x_neighbour) = what would flow into it if the surface stayed as it is
//
// a lattice of masses and springs, as a membrane has it, and solved by the same conjugate gradients.
#include "model/water_work.hh"

#include <string.h>

namespace cd {

namespace {

template <class Body> void in_rows(const Water& w, size_t rows, const Body& body) {
    in_parts(w.parallel, rows, w.cells[kX], body);
}

// The system's ground and springs from the faces' springs.
template <class T> double build_system(const WaterStepper<T>& s, WaterTogether& both) {
    const Water& w = s.w;
    const size_t nx = w.cells[kX], ny = w.cells[kY];
    double stiffest = 0;
    for (size_t j = 0; j < ny; ++j)
        for (size_t i = 0; i < nx; ++i) {
            const size_t at = j * w.pitch + i;
            const bool there = present(w, i, j);
            double ground = there ? 1 : 0, sum = 0;
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

} // namespace

// x = the change of the surface, in work.both.change.
template <class T> static void solve_surface(WaterStepper<T>& s) {
    Water& w = s.w;
    WaterTogether& both = s.work.both;
    const double stiffest = build_system(s, both);
    both.preconditioner.first.build();
    const Goal goal{w.tolerance, stiffest, 0, w.most_iterations};
    const Convergence reached =
        solve_coupled(both.system, both.preconditioner, goal, both.gradient, both.load, both.change);
    if (reached.iterations > s.worst.iterations) s.worst.iterations = reached.iterations;
    if (!(reached.residual <= s.worst.residual)) s.worst.residual = reached.residual;
    s.worst.reached &= reached.reached;
    ++w.factorizations;
}

// An explicit step as calm water makes it, with the planes as its place to work; false: it is not calm, and has not moved.
template <class T> static bool leap(const WaterStepper<T>& s) {
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
    in_rows(w, grid.rows, [&](size_t first, size_t count) {
        double *const through = planes[kX].transfer + first * w.pitch, *const before =
                                                                           planes[kY].transfer + first * w.pitch;
        if (!s.kernels().leap(axis, grid, through, before, first, count))
            __atomic_store_n(&calm, false, __ATOMIC_RELAXED);
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
    const WaterCells cells{w.cells[kX],
                           rows,
                           w.pitch,
                           {periodic(w, kX), periodic(w, kY)},
                           {both.planes[kX].transfer, both.planes[kY].transfer}};
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

    along_each(kernels().guess);
    if (work.coupled) {
        in_rows(w, rows, [&](size_t first, size_t count) { kernels().gather_loads(cells, both.load, first, count); });
        solve_surface(*this);
        along_each(kernels().finish);
    }

    double* const share = both.load;
    in_rows(w, rows, [&](size_t first, size_t count) {
        memset(work.tally + first * kTallies, 0, count * kTallies * sizeof(double));
        kernels().share(cells, numbers<T>(w.depth), share, work.tally, first, count);
    });
    count_up(rows);
    in_rows(w, rows + 1, [&](size_t first, size_t count) { kernels().limit(cells, share, first, count); });
    in_rows(w, rows, [&](size_t first, size_t count) {
        if (!kernels().fill(cells, numbers<T>(w.depth), work.held, first, count))
            __atomic_store_n(&finite, false, __ATOMIC_RELAXED);
    });

    for (Axis a : {kX, kY}) {
        along(a, kernels().keep);
        count_up(lines_of(w, a));
    }
    if (w.momentum == CD_MOMENTUM_ADVECTED)
        for (Axis a : {kX, kY}) carry(a);
}

#if CD_WITH_FLOAT32
template void WaterStepper<float>::step_together();
#endif
#if CD_WITH_FLOAT64
template void WaterStepper<double>::step_together();
#endif

} // namespace cd
