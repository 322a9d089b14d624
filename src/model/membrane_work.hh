// What steps of a membrane compute with: coefficients, made anew when dt or a parameter changes, and scratch for one
// component at a time. Both are handed out from the membrane's two arrays in the order in which they are declared here.
//
// A sheet whose two directions separate (membrane_held.cpp) has one factorization per direction. Of any other sheet
// every line has its own, and there are planes of masses and springs.
#pragma once

#include "model/membrane.hh"
#include "model/stages.hh"
#include "solve/conjugate_gradients.hh"
#include "solve/held_nodes.hh"
#include "solve/shared_lines.hh"

namespace cd {

// One direction of a separable sheet.
struct DirectionRows {
    double *before, *after, *gain, *inverse_mass, *drag;
    uint8_t* holds; // whether the whole line across a node is held
};

// The parts of a sheet: see membrane_parts.cpp.
struct SheetParts {
    size_t* of = nullptr;      // plane: the part of a node, from 1 on; 0 where nothing moves
    double* pull = nullptr;    // plane: the system times the motion of all nodes alike
    double* energy = nullptr;  // per part, [0] of none: of its own nodes' motion alike
    uint8_t* afloat = nullptr; // per part: whether nothing held is joined to it
    double* sums = nullptr;    // per part: scratch
    double* outer = nullptr;   // likewise: what acts on it, but for springs and bend

    SheetParts() = default;
    SheetParts(const Membrane& m, const Grid& grid, Carver& coefficients, Carver& scratch);
};

struct Work {
    bool implicit, coupled, general, bends;
    // Of the system with bend there are two, each of springs.
    int factors() const { return CD_WITH_BEND && bends ? 2 : 1; }
    // Uniform sheets without bend, coupled or not at all: explicit steps are one pass over memory, implicit stages two,
    // unless there are rings (kernel/sheet_explicit.cpp, sheet_sweep.cpp).
    bool uniform, swept;
    Grid grid, turned;
    Parts bands, strips; // of rows and columns, where they are swept

    DirectionRows rows[2];
    SharedLines shared[2];
    double *mass, *ground, *spring[2], *bend[2], *twist, *inverse, *tie, *one; // planes; null where not needed
    SheetParts parts;
    HeldNodes held;
    // Of an alternating sheet with held nodes: per direction the response of a line to an impulse at each of them, and
    // what grounds it there; room for one such plane; e of held_nodes.hh, for the component at hand.
    Grid across[2];
    double *response[2], *grounded[2], *across_plane, *across_slope, *wish;
    LineRows line[2][2]; // of both factors (with bend), along u and v
    SheetSystem system;
    Preconditioner preconditioner;

    double *kept_x, *kept_v;        // between two stages
    double *scaled, *residual;      // x / (h + damping) + v; what solvers start from
    double* looked;                 // kLookedRows rows per band
    Grid line_of_rows;              // a column with a node for each row
    double *row_plane, *row_change; // a plane of it, scratch; per row, how its mean velocity changes
    double *turned_plane, *free_v;  // free_v: v where nodes move, else 0
    double *answer[3], *slope;
    GradientPlanes gradient;

    Work(const Membrane& m, const MembraneFeatures& f, Carver& coefficients, Carver& scratch);
};

// Makes the coefficients for steps of dt.
void prepare(Membrane& m, Work& work, double dt);

// ---- sheets whose directions separate (membrane_held.cpp) ----

// What steps of dt take, from with.solver: with.solver and with.likeness.
void choose_way(const Membrane& m, double dt, MembraneFeatures& with);
// Of a sheet that separates: which whole columns and rows are held, and which nodes beside them. Leaves m.held.
void find_held(Membrane& m, Work& w, double h);
// Whether springs or bend are so stiff for a step, whose h (h + damping) is sigma, that the impulses on nodes side by
// side are lost in rounding.
bool is_too_stiff(const Membrane& m, double sigma);
// For alternating solves; h: the stage's share of dt.
void prepare_held(const Membrane& m, const Work& w, double h);
// Takes what acts on single nodes out of a plane that solves start from, and makes it w.wish, ties and all.
void take_wishes(const Work& w, double* plane);
// Between the solves along u and those along v: adds to the plane what keeps the held nodes where they are.
void hold(const Membrane& m, const Work& w, double* plane);

// Finds the parts of the sheet, m.parts of them, and makes w.one: 1 where nodes move.
void prepare_parts(Membrane& m, Work& work);
// parts.outer, of a plane of what acts on the nodes
void find_outer(const Membrane& m, const Work& w, const double* acts);
// For a sheet of several parts: makes n planes orthogonal in energy to every motion that moves one part alike. Into
// w.one goes what those motions themselves have to do for this residual, less `share` of what the first plane loses;
// into `taken` the energy that each plane loses.
void separate_parts(const Membrane& m, const Work& w, double* const* planes, int n, double share,
                    const double* residual, double* taken);

// ---- the mean motion of a stiff sheet that nothing holds (membrane_mean.cpp) ----

// It is computed apart where the largest diagonal entry of the system is so many times the least mass.
constexpr double kStiffSheet = 1e4;
// Of a separable sheet; others: see prepare.
bool is_stiff_and_afloat(const Membrane& m, const Work& w);
// What acts on the nodes but springs, as a change of velocity: pushed[i] gain[i] scale; null: 1.
struct Pushed {
    const double *pushed, *gain;
    double scale;
};
// w.row_change = how the mean velocity of each row of a separable sheet changes.
void change_rows(const Membrane& m, const Work& w, double h, const StateNumbers& x, const StateNumbers& v,
                 const Pushed& by);
// Takes from every row its mean, columns counted by their mass.
void flatten_rows(const Grid& grid, const double* inverse_mass, double* plane, size_t first, size_t count);

// The force of the pressure on every node, into m.pressed.
void press(Membrane& m);

} // namespace cd
