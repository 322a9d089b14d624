// What the kernels of sheets share. They work on planes: one number per node of a lattice in rows of columns, in
// double, whatever the state is stored in. A plane has room for the two columns that lie beyond each end of a row; they
// hold what lies there round the ring, and where there is no ring, springs of stiffness 0 lead there.
//
// Kernels take the part [first, first + count) of the rows (of the columns where lines run down the columns), so that
// parts can go to different threads; sums come out as one number per row, to be added in order.
#pragma once

#include <stddef.h>

#include "kernel/lanes.hh"
#include "kernel/lines.hh"

namespace cd {

struct Grid {
    size_t columns, rows, pitch;

    // The rows above and below, round the ring.
    size_t above(size_t row) const { return (row > 0 ? row : rows) - 1; }
    size_t below(size_t row) const { return row + 1 < rows ? row + 1 : 0; }
    // The rows that filters along them take (sheet_filters.hh): eights of them, as far as there are eight. What lies in
    // those beyond the last one does not matter.
    size_t filtered_rows() const { return rows < 8 ? rows : (rows + 7) / 8 * 8; }
};

// A sheet whose two directions separate: mass(u, v) = mass_u(u) mass_v(v), springs likewise. One number per column
// (direction 0) or row (1), each divided by the mass: [1] as all springs of a step, stiffness times a time squared.
struct SeparableSheet {
    const double *before[2], *after[2]; // the spring before and after a node
    const double* gain[2];              // of all that acts on a node, 0 where held
    const double* inverse_mass[2];      // their product: 1 / mass
    const double* drag[2];              // of the velocity, beside SheetPush::drag; null: none
};

// Any sheet. Planes; mass is 0 where nodes are held or absent, and so are the springs from one such node to another.
struct GeneralSheet {
    const double *mass, *ground;   // ground: mass and what else resists there
    const double* spring[2];       // of the spring that starts at a node along u and along v
    const double *bend[2], *twist; // null: no bend. Of a node along u and v, of the cell that starts at a node
    double* moment[3];             // scratch for bend

    bool bends() const { return CD_WITH_BEND && twist; }
};

// What acts on a sheet beside its springs.
struct SheetPush {
    double gravity;              // h g
    double force;                // h, of force and pressed
    double drag;                 // h drag, of separable sheets
    StateNumbers forces, target; // null: none
    const double* pressed;       // null: none
    const double* tie;           // h times the stiffness that ties to the target
    bool whole;                  // of general sheets: what there is in all, S v included, and not what changes v
};

// The filters of lines that share one factorization (solve/spring_line.hh); 0 up to a whole cache line.
struct SharedFilter {
    const double *carry, *pull;
};

// A stage of a uniform sheet. Its springs look at closing_rate x + share v.
struct UniformStage {
    const SeparableSheet& sheet;
    const SheetPush& push;
    double closing_rate, share;
    bool ring_u;
    bool constant;                 // beside springs only gravity acts
    SharedFilter along_u, along_v; // of implicit stages
    bool carries;                  // see sweep_down
    // Single nodes: their places in planes, and their compliance: on those of 0, which are held, nothing acts.
    size_t singles;
    const size_t* single;
    const double* compliance;
    // null, or what makes rows' means 0 before and after the filters along them
    void (*flatten)(const Grid& grid, const double* inverse_mass, double* plane, size_t first, size_t count);
};
constexpr size_t kLookedRows = 6; // of scratch: see StageRows

// What the springs of a stage look at: x_scaled = closing_rate x + share v, the share that of free or of held nodes
// (mass 0; without masses all count as free). v_free, if not null: v where nodes are free, else 0.
struct SheetGather {
    double closing_rate, free_share, held_share;
    const double* mass;
    double *x_scaled, *v_free;
};

// Factors of the lines' systems (solve/sheet_lines.hh): forward y_i = b_i + pull_{i-1} y_{i-1}, back x_i = gain_i y_i +
// pull_i x_{i+1}.
struct LineFactors {
    const double *pull, *gain;
    const double *around,
        *closing; // of rings, else null: the response to a pull of the closing spring, and its strength
};

// One shift of alternating directions for a separable sheet: see solve/shifted_lines.hh.
struct ShiftedStep {
    const double* inverse_mass[2]; // per column and row
    const double* gain[2];         // 1 / what grounds a line's node per mass, 0 where held
    SharedFilter along[2];
    double twice, next; // 2 p, p and the shift after it
    bool first, last;
    bool carries; // see sweep_down
};

// The most planes whose energies can be asked for, and how many numbers tell them: see energies.
constexpr int kMostDirections = 5;
constexpr int energies_of(int planes) { return planes * (planes + 1) / 2 + planes; }
constexpr int kEnergies = energies_of(kMostDirections);

// Where a node starts from and what it is moved by: dw = sum of factor[k] change[k], w = v + dw,
//     v <- v + overshoot dw,    x <- x + move (v + follow dw).
struct SheetMove {
    double overshoot, move, follow;
    const double* change[5];
    double factor[5];
    int changes;
};

namespace CD_ISA {

// As for_each_bundle, for rows: what is left of a row at its end is taken one by one, which keeps the kernels small.
template <class F> inline void along_row(size_t first, size_t count, F&& f) {
    for (; count >= size_t(kWidest); first += kWidest, count -= kWidest) f.template bundle<kWidest>(first);
    for (; count > 0; ++first, --count) f.template bundle<1>(first);
}
// In whole bundles: for rows beyond whose end, up to a whole cache line, there is room and nothing that counts.
template <class F> inline void along_whole_row(size_t first, size_t count, F&& f) {
    for (size_t u = first; u < first + count; u += size_t(kWidest)) f.template bundle<kWidest>(u);
}

// ---- the state (sheet_state.cpp) ---- A stage starts from the state, or from the doubles between two stages.

void gather(const Grid& grid, const SheetGather& how, const StateNumbers& x, const StateNumbers& v, size_t first,
            size_t count);
// out = what acts on the nodes beside springs: on a separable sheet [m/s], else [kg m/s].
void push_separable(const Grid& grid, const SeparableSheet& sheet, const SheetPush& push, const StateNumbers& v,
                    double* out, size_t first, size_t count);
void push_general(const Grid& grid, const GeneralSheet& sheet, const SheetPush& push, const StateNumbers& x,
                  const StateNumbers& v, double* out, size_t first, size_t count);
// False if a number left the finite range. to_x and to_v may be x and v.
bool move_nodes(const Grid& grid, const SheetMove& move, const StateNumbers& x, const StateNumbers& v,
                const StateNumbers& to_x, const StateNumbers& to_v, size_t first, size_t count);

// ---- a stage of a uniform sheet (sheet_sweep.cpp) ----

// plane = the filters along the rows, and with `carries` the first one down the columns, of what acts on the nodes that
// start from x and v. looked: scratch, kLookedRows rows. With `carries`, all rows at once.
void sweep_down(const Grid& grid, const UniformStage& stage, const StateNumbers& x, const StateNumbers& v,
                double* plane, double* looked, size_t first, size_t count);
// The filters down the columns, but for the first one if it is `carried`; moves by that, and by a number per row, unless
// that is null. below: scratch, a row. Parts are of the columns.
bool sweep_up(const Grid& grid, const SharedFilter& filter, bool carried, const SheetMove& move, const double* of_row,
              double* plane, double* below, const StateNumbers& x, const StateNumbers& v, const StateNumbers& to_x,
              const StateNumbers& to_v, size_t first, size_t count);

// ---- an explicit step of a uniform sheet (sheet_explicit.cpp) ----

// What a part needs of its neighbours, into looked, before any part is stepped.
void look_beyond(const Grid& grid, const UniformStage& stage, const SheetMove& move, const StateNumbers& x,
                 const StateNumbers& v, double* looked, size_t first, size_t count);
bool step_rows(const Grid& grid, const UniformStage& stage, const SheetMove& move, const StateNumbers& x,
               const StateNumbers& v, double* looked, size_t first, size_t count);

// ---- a shifted step of alternating directions (sheet_shift.cpp) ----

// From the right side r and z, along the rows; t: scratch. With step.carries, all rows at once.
void shift_down(const Grid& grid, const ShiftedStep& step, const double* r, double* z, double* t, size_t first,
                size_t count);
// Down the columns; at the last step x, else the next z. below: scratch, a row.
void shift_up(const Grid& grid, const ShiftedStep& step, double* z, double* t, double* below, double* x, size_t first,
              size_t count);

// ---- springs (sheet_springs.cpp) ----

// out = gain (out, or with `constant` h g alone, + the pull of the springs at x).
void pull_separable(const Grid& grid, const SeparableSheet& sheet, const double* x, bool constant, double gravity,
                    double* out, size_t first, size_t count);
// out += the pull of springs and bend at x; 0 where mass is 0. Bend: after `moments` of all rows.
void pull_general(const Grid& grid, const GeneralSheet& sheet, const double* x, double* out, size_t first,
                  size_t count);
// out = S z, energy[row]: that row's part of z S z.
void apply(const Grid& grid, const GeneralSheet& sheet, const double* z, double* out, double* energy, size_t first,
           size_t count);
void moments(const Grid& grid, const GeneralSheet& sheet, const double* x, size_t first, size_t count);
// sums[row]: z_a S z_b for a <= b of n planes, in the order 00 01 02 ... 11 12 ..., then z_a b.
void energies(const Grid& grid, const GeneralSheet& sheet, const double* const* z, int n, const double* b, double* sums,
              size_t first, size_t count);

// ---- lines down the columns (sheet_lines.cpp) ----

void solve_lines(const Grid& grid, const LineFactors& factors, const double* b, double* x, size_t first, size_t count);
// Lines that share one factorization (solve/spring_line.hh): x becomes the answer where it was each node's own wish.
void filter_lines(const Grid& grid, const double* carry, const double* pull, double* x, size_t first, size_t count);
// Solves every second line, from `colour`, for given neighbours: cross is the spring that starts at a node and leads to
// the next column. x: in and out, its beyond too.
void smooth_lines(const Grid& grid, const LineFactors& factors, const double* cross, const double* b, int colour,
                  double* x, size_t first, size_t count);

// ---- planes (sheet_planes.cpp) ----

void transpose(const Grid& grid, const double* from, double* to, size_t to_pitch, size_t first, size_t count);
// out = alpha a + beta b; out may be a.
void combine(const Grid& grid, double alpha, const double* a, double beta, const double* b, double* out, size_t first,
             size_t count);
void multiply(const Grid& grid, const double* a, const double* b, double* out, size_t first, size_t count);
void wrap(const Grid& grid, double* a, size_t first, size_t count); // fills what lies beyond the rows
void dot(const Grid& grid, const double* a, const double* b, double* sums, size_t first, size_t count);
// Between a lattice and one of half as many rows and columns, each node of which stands for up to 2 x 2. Rows are those
// of the coarse one. coarse = sums of fine - minus; fine += coarse where it moves (gain > 0).
void aggregate(const Grid& coarse, const Grid& fine, const double* from, const double* minus, double* to, size_t first,
               size_t count);
void spread(const Grid& coarse, const Grid& fine, const double* from, const double* gain, double* to, size_t first,
            size_t count);

} // namespace CD_ISA
} // namespace cd
