// What a sweep of water along one axis is given, and its kernels. The step of a line is told in line.hh.
#pragma once

#include <stddef.h>
#include <stdint.h>

#include <initializer_list>

#include "kernel/lanes.hh"
#include "kernel/lines.hh"

namespace cd {

// Water that is shallower is none [m].
constexpr double kDry = 0x1p-80;

// A face that water cannot cross, with one wet cell beside it, moves as on a beach with the velocity of that cell's
// other face, in full where the bed falls to the cell beyond by this part or more of the step up to the dry one, and in
// proportion where it falls by less: where it does not fall, the face rests as at a wall. Of linear momentum it rests.
constexpr double kBeach = 0.5;

// What is at an end of the lines: see cd_border.
enum class End { kWall, kOpen, kLevel, kInflow, kRing };
struct WaterEnd {
    End kind;
    double level;     // [m] of the water outside, of kOpen and kLevel
    double rise;      // [m] of that level in the step
    double discharge; // [m^2/s] that comes in, of kInflow
    double depth;     // [m] it comes in as fast as in that depth; 0: in that of the cell, but not below critical depth
};

struct WaterSweep {
    size_t first, cells;  // of each line
    double dt, courant;   // courant: dt / the cell's size [s/m]
    double theta;         // how much the end of the step counts against its beginning
    bool implicit;        // fluxes answer to the surface of the step's end
    double gravity;       // [m/s^2]
    double drag, manning; // drag [1/s]; gravity times manning^2
    bool is_advected;     // momentum
    WaterEnd end[2];

    bool ring() const { return end[0].kind == End::kRing; }
    bool closed() const { return ring() || (end[0].kind == End::kWall && end[1].kind == End::kWall); }
    bool advected() const { return CD_WITH_ADVECTED && is_advected; }
    bool rubs() const { return drag > 0 || manning > 0; }
};

// How far numbers lie apart: along lines, and from line to line.
struct Strides {
    size_t along, across;
};

// The numbers of lines along an axis. Null: not there.
struct WaterLines {
    size_t lines;
    Strides numbers, bytes; // of the state and of mask and wall
    StateNumbers depth, velocity, bed, pressure, force;
    StateNumbers across;      // velocities of the other axis, of sweeps with manning
    StateNumbers load, stiff; // of hulls, in cells: the head that presses [m] is load + stiff depth
    double pressure_share;    // from a difference of pressures to an acceleration
    const uint8_t *mask, *wall;
    const uint8_t* wall_between; // of carry_across: walls between lines
    bool seam;                   // of carry_across: line 0 lies behind the last one
    StateNumbers moved;          // out, and for carry_across: what went through faces, as depths [m]
    double* tally;               // out: kTallies numbers per line, to which runs of its cells add

    bool has_closed_faces() const { return mask || wall; }
    bool there(size_t byte) const { return !mask || mask[byte] != 0; }
    bool walled(size_t byte) const { return wall && wall[byte] != 0; }
    bool walled_between(size_t byte) const { return wall_between && wall_between[byte] != 0; }
};

// What a line let in and out at its ends, what the limiter held back, all as depths [m]; in how many cells; and the
// parts that it made its step in.
enum WaterTally { kIn, kOut, kHeldBack, kLimited, kParts, kTallies };

// Lines that are worked on side by side, the panels of numbers that they need, and what panels have room for beside
// their cells; two more with hulls. Tasks take packs of lines: whole lines of the cache.
constexpr size_t kWaterLanes = 8, kWaterPanels = 16, kHullPanels = 2, kWaterRoom = 1, kWaterPack = 16;
inline size_t water_packs(size_t lines) { return (lines + kWaterPack - 1) / kWaterPack; }

namespace CD_ISA {

// Neighbours among `count` places on a line, or round a ring; at an end of a line itself.
struct Neighbours {
    size_t count;
    bool ring;

    size_t before(size_t i) const { return i > 0 ? i - 1 : ring ? count - 1 : 0; }
    size_t behind(size_t i) const { return i + 1 < count ? i + 1 : ring ? 0 : i; }
};

// Depths as they will be stored, cell after cell. What rounding takes from a wet cell the next one gets that can take
// it, and the other way round; depths below the least are 0.
template <int N> struct Rounding {
    using L = Lanes<N>;
    bool is_float64;
    L owed{};

    L operator()(L now) {
        now = settled(now, kDry);
        if (is_float64) return now;
        // What is taken waits for the cell before: what can be known of this one is computed while it does.
        const L none{}, room = select(now, 0.5 * now, L::splat(-__builtin_inf()));
        const L takes = owed + room, exact = select(takes, now + owed, now);
        const L stored = select(L::splat(kDry) - exact, none, exact.template rounded_to<float>());
        owed = select(takes, none, owed) + (exact - stored);
        return stored;
    }
};

// Makes the step along packs [first, first + count) of lines; work: kWaterPanels * (cells + kWaterRoom) * kWaterLanes
// numbers, more with hulls. False if a number left the finite range.
bool sweep_water(const WaterSweep& sweep, const WaterLines& lines, double* work, size_t first, size_t count);

// How what the sweep has moved along its lines carries the velocities of the other axis, which lie on the faces between
// lines: `velocity` and `wall_between` of line k are those of the face before it.
bool carry_across(const WaterSweep& sweep, const WaterLines& lines, double* work, size_t first, size_t count);

} // namespace CD_ISA

} // namespace cd
