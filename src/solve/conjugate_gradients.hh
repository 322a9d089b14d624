// Conjugate gradients for the system of a sheet, preconditioned by V-cycles.
#pragma once

#include "solve/multigrid.hh"
#include "solve/shifted_lines.hh"

namespace cd {

struct Convergence {
    size_t iterations = 0;
    double residual = 0; // as a fraction of what it is measured by
    bool reached = true;
};

// Of a separable sheet shifted lines, where shifts cover its rates, else V-cycles. With bend, (G + p L) (G + q L), G
// the root of the ground, stands for the system: a V-cycle for each factor.
struct Preconditioner {
    ShiftedLines lines;
    Parts bands, strips;
    Multigrid first, second;
    bool two;

    // x = S^-1 r, nearly. Two V-cycles after each other are not symmetric where G differs from node to node, as G and L
    // do not commute there; both_ways: the sum of their two orders, which is, at twice the cost.
    void operator()(const SheetSystem& system, bool both_ways, double* r, double* x) const;
};

// Scratch, planes of the system. steep: the preconditioned residual.
struct GradientPlanes {
    double *start = nullptr, *direction = nullptr, *steep = nullptr, *applied = nullptr;

    GradientPlanes() = default;
    GradientPlanes(const SheetSystem& system, Carver& carve)
        : start(carve.plane(system.grid)),
          direction(carve.plane(system.grid)),
          steep(carve.plane(system.grid)),
          applied(carve.plane(system.grid)) {}
};

// What a solve has to reach: a residual of `relative` times the first one, or of what double precision leaves of it:
// that precision times the size of x and of what r was made from, `size`.
struct Goal {
    double relative, size;
    size_t most_iterations;
};

// Solves S x = r. r: in, the right side; out, what is left of it.
Convergence solve_coupled(const SheetSystem& system, const Preconditioner& preconditioner, const Goal& goal,
                          const GradientPlanes& planes, double* r, double* x);

} // namespace cd
