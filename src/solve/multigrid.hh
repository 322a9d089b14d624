// A V-cycle for the system of a sheet: an approximate answer whose error has no smooth part left.
//
// Every level is again a lattice of masses and springs: 2 x 2 nodes become one, masses and parallel springs add. What
// moves a block as a whole is right then, but a smooth answer costs too much energy, all of it at the blocks' borders:
// springs between blocks, and springs to held nodes, are divided by 1.8 (2 would be right in the smooth limit). Each
// level is smoothed by solving every second line for given neighbours, then the others: lines along u, then v, going
// down, and in the opposite order coming up, which makes the cycle symmetric. The only solver is the line's.
// (see contdyn/membrane.h: coupled.)
#pragma once

#include "solve/sheet_lines.hh"
#include "solve/sheet_system.hh"

namespace cd {

struct MultigridLevel {
    SheetSystem system;         // its sheet: ground and springs of the level, mass > 0 where it moves
    double *ground, *spring[2]; // what system.sheet reads; null where that is the caller's
    double* turned_spring;      // springs along v, turned
    LineRows along[2];          // factors of the lines along u (turned) and v, neighbours as ground
    double *x, *b;              // not of the first level, unless it is its own
    double *residual, *turned_x, *turned_b;
};

struct Multigrid {
    MultigridLevel* level;
    size_t levels;

    // Takes memory for the system's levels. own: the first level has ground and springs of its own, for the caller to
    // fill.
    void carve(const SheetSystem& system, bool own, Carver& coefficients, Carver& scratch);
    // Builds all levels from the first one's ground (0 where nothing moves) and springs.
    void build();
    // x = S^-1 b, nearly. Planes of the first level.
    void cycle(const double* b, double* x) const { descend(0, b, x); }

private:
    void descend(size_t l, const double* b, double* x) const;
};

} // namespace cd
