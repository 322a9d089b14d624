// A step of water along one axis: what its lines have in common, where their numbers lie, and the kernels.
#pragma once

#include <stddef.h>
#include <stdint.h>

#include "kernel/lanes.hh"
#include "kernel/lines.hh"

namespace cd {

// Squares of cells that waves cross, from which on a step is no longer short, is long, and very long.
constexpr double kShortStep = 1.0 / 9, kLongStep = 2.5 * 2.5, kVeryLongStep = 1e4;

// What is at an end of the lines: see cd_border.
enum class End { kWall, kOpen, kInflow, kRing };
struct WaterEnd {
    End kind;
    double level;     // [m] of kOpen, at the time that counts for the step
    double discharge; // of kInflow, as the depth [m] that it adds to a cell in the step
};

struct WaterAxis {
    size_t cells;
    double courant;     // dt / the cell's size [s/m]
    double lambda;      // of the fluxes, and of the surface that pushes them
    double push_after;  // the surface's lambda: 0 in explicit steps, whatever the fluxes'
    double gravity;     // [m/s^2]
    double drag;        // dt drag
    double manning;     // dt g manning^2
    bool advected;      // momentum
    size_t corrections; // 0: depths as they come, else large steps
    bool thins;         // coupled steps: the surface is solved for with cells running dry
    WaterEnd end[2];

    bool ring() const { return end[0].kind == End::kRing; }
    bool rubs() const { return drag > 0 || manning > 0; }
    // Faces look ahead with the velocities of the step's end, which an explicit step has from the start.
    bool looks_late() const { return push_after == 0 && lambda > 0; }
    // Momentum goes with the water of both axes at once.
    bool carried_at_once() const { return thins && advected; }
};

// The numbers of lines along an axis: those of line k at cell or face i lie at i * along + k * across. Null: not there.
template <class T> struct WaterLines {
    size_t lines, along, across;
    T *depth, *velocity;
    const T *bed, *pressure, *force;
    double force_share, pressure_share; // from force to velocity, and from a difference of pressures
    const uint8_t *mask, *wall;         // at i * byte_along + k * byte_across
    size_t byte_along, byte_across;
    double *held, *moved; // out, for what is carried across: depths before the sweep, and through faces [m]
    double* tally;        // out: kTallies numbers per line
};

// Whether such lines can be calm: linear, between walls, with nothing that pushes or closes faces.
template <class T> bool may_be_calm(const WaterAxis& axis, const WaterLines<T>& lines) {
    const bool walled = axis.end[0].kind == End::kWall && axis.end[1].kind == End::kWall;
    const bool plain = !axis.advected && axis.corrections == 0 && !(axis.manning > 0) && axis.lambda > 0;
    return walled && plain && !lines.mask && !lines.wall && !lines.force && !lines.pressure;
}

// What a line lets in and out at its ends, what had to be held back, all as depths [m], and in how many cells.
enum WaterTally { kIn, kOut, kHeldBack, kLimited, kSolves, kTallies };

// How lines along an axis carry the velocities of the other axis with them, which lie on the faces between lines of
// cells: before them and behind.
template <class T> struct WaterCarried {
    size_t nodes, lines, along, across;
    bool ring; // along the axis
    T* velocity;
    const double *held[2], *moved[2];
    // what closes faces, see WaterLines: the cells before and behind them, walls on them
    const uint8_t *mask[2], *wall;
    size_t byte_along, byte_across;
};

// What lies between the parts of a step that works on both axes at once: planes of numbers of the faces of one axis,
// laid out like the state; change and held of the cells.
struct WaterPlanes {
    double *velocity, *face, *guess, *transfer;
    double *gain, *spring; // null: not needed
    const double *change, *held;
};

// The cells that share their water out to the faces of both axes.
struct WaterCells {
    size_t columns, rows, pitch;
    bool ring[2];
    double* transfer[2];
    bool passes; // on what it gets: what is left may be the rounding of much more
};

// Where both axes move water at once, a face is as deep in the middle of the step as what leaves the cells beside it
// along the other axis makes it, too: without, small waves on a slanting current grow, see look_ahead.
template <class T> struct WaterBeside {
    const WaterCells& cells;
    const WaterPlanes* planes; // of the faces of both axes, as after guess_water
    double courant[2];
    bool late; // the water leaves with the velocities of the step's end, else those of its beginning
    const T *depth, *bed;
    double* leaves[2]; // planes of cells
};

// Along a row of cells that are filled at once, rounding is handed on in so many chains, whatever a register holds.
constexpr size_t kRowChains = 8;
static inline double sum_of_chains(const double* c) {
    return ((c[0] + c[1]) + (c[2] + c[3])) + ((c[4] + c[5]) + (c[6] + c[7]));
}
static inline bool can_take(double depth, double owed) { return depth + 2 * owed > 0 && depth > 0; } // see Rounding

// A depth as it will be stored, with what rounding has taken of others if it can take that; what is left is owed.
template <class T> static inline T stored_depth(double now, double& owed) {
    const bool takes = can_take(now, owed);
    const double exact = takes ? now + owed : now;
    const T stored = T(exact < double(Limits<T>::least) ? 0 : exact);
    owed = (takes ? 0 : owed) + (exact - double(stored));
    return stored;
}

// A water's cells, what of it an explicit step needs, and where its results go, laid out like the state.
template <class T> struct WaterGrid {
    size_t columns, rows, pitch;
    const T *bed, *depth, *velocity[2];
    T *next_depth, *next_velocity[2];
};

// Lines that are worked on side by side, and the panels of numbers they need for it; lines handed out together.
constexpr size_t kWaterLanes = 8, kWaterPanels = 18, kWaterPack = 16;

namespace CD_ISA {

// Makes the step along packs [first, first + count) of lines; work: kWaterPanels * (cells + 2) numbers for each lane.
// False if a number left the finite range.
template <class T>
bool sweep_water(const WaterAxis& axis, const WaterLines<T>& lines, double* work, size_t first, size_t count);

// The same for what is carried. work: the same.
template <class T> bool carry_across(const WaterCarried<T>& carried, double* work, size_t first, size_t count);

// Both axes at once (water_apart.cpp), lines as in a sweep: faces as they will be if the surface stays as it is; what
// the change of the surface does to them; and what velocities they keep, from what the limits left of transfers, or,
// where momentum is carried at once, in two parts: before that, and after.
template <class T> void guess_water(const WaterAxis& axis, const WaterLines<T>& lines, const WaterPlanes& planes,
                                    double* work, size_t first, size_t count);
template <class T> void finish_water(const WaterAxis& axis, const WaterLines<T>& lines, const WaterPlanes& planes,
                                     double* work, size_t first, size_t count);
template <class T> bool keep_water(const WaterAxis& axis, const WaterLines<T>& lines, const WaterPlanes& planes,
                                   double* work, size_t first, size_t count);
template <class T> bool settle_water(const WaterAxis& axis, const WaterLines<T>& lines, const WaterPlanes& planes,
                                     double* work, size_t first, size_t count);
// Rows of cells, for faces that look ahead across, see WaterBeside: what leaves cells along each axis on balance; and
// faces and what they will move, once that is known of all cells.
template <class T> void balance_water(const WaterBeside<T>& beside, size_t first, size_t count);
template <class T> void look_beside(const WaterBeside<T>& beside, size_t first, size_t count);
// Rows of cells. load = what transfers add; share: of what a cell is asked for, how much it can give, and tallies, per
// row; transfers limited by that (faces: a row more than cells); depth = what is left, held = what was, owed = what
// rounding took of each row that none of its cells could take; false if a number left the finite range.
void gather_loads(const WaterCells& cells, double* load, size_t first, size_t count);
template <class T>
void share_water(const WaterCells& cells, const T* depth, double* share, double* tally, size_t first, size_t count);
void limit_water(const WaterCells& cells, const double* share, size_t first, size_t count);
template <class T>
bool fill_water(const WaterCells& cells, T* depth, double* held, double* owed, size_t first, size_t count);

// An explicit step of calm water (water_leap.cpp), rows [first, first + count); axis: x and y; work: 16 rows of faces.
// False: it is not calm, and the results are none.
template <class T>
bool leap_water(const WaterAxis* axis, const WaterGrid<T>& grid, double* work, size_t first, size_t count);

} // namespace CD_ISA

// Lanes of a bundle: objects of a single line need but one.
inline size_t water_lanes(size_t lines) { return lines == 1 ? 1 : kWaterLanes; }
inline size_t water_packs(size_t lines) { return (lines + kWaterPack - 1) / kWaterPack; }

} // namespace cd
