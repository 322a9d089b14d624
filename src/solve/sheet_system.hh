// The system of one implicit stage of any sheet, S w = b with S = ground + springs + bend, and what solvers do with it.
#pragma once

#include "kernel/kernels.hh"
#include "solve/planes.hh"

namespace cd {

struct SheetSystem {
    const SheetKernels* kernels;
    const cd_parallel* parallel;
    Grid grid, turned; // turned: rows and columns exchanged
    bool ring[2];      // along u and v
    GeneralSheet sheet;
    double* sums;                   // kEnergies numbers per row
    const double* inverse_diagonal; // of S, 0 where nothing moves; for coupled solves

    template <class Body> void rows(const Body& body) const { in_parts(*parallel, grid.rows, grid.columns, body); }
    template <class Body> void columns(const Body& body) const { in_parts(*parallel, grid.columns, grid.rows, body); }

    // Makes good what lies beyond the rows; every plane that springs look at needs it.
    void wrap(double* plane) const;
    // The moments of the bend at a wrapped plane; without bend, nothing.
    void bend(const double* plane) const;
    // r += pull of springs and bend at x, 0 where nothing moves.
    void pull(double* x, double* r) const;
    // out = S z; returns z S z.
    double apply(double* z, double* out) const;
    double dot(const double* a, const double* b) const;
    void clear(double* plane) const;
    void copy(const double* from, double* to) const;
    // a = alpha a + beta b
    void combine(double alpha, double* a, double beta, const double* b) const;
    void multiply(const double* a, const double* b, double* out) const;
    void turn(const double* from, double* to) const;      // to the turned layout
    void turn_back(const double* from, double* to) const; // from it

    // The w in the span of n <= kMostDirections planes that comes nearest to S w = b in energy: the residual is then
    // orthogonal to it. Planes that add nothing new to the others, or to what has been taken out of them before,
    // of which `taken` has the energy, get the factor 0.
    void project(double* const* planes, int n, const double* b, const double* taken, double* factors) const;
};

} // namespace cd
