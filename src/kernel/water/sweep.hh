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

// What is at an end of the lines: see cd_border.
enum class End { kWall, kOpen, kLevel, kInflow, kRing };
struct WaterEnd {
    End kind;
    double level;     // [m] of the water outside, of kOpen and kLevel
    double rise;      // [m] of that level in the step
    double discharge; // [m^2/s] that comes in, of kInflow
};

struct WaterSweep {
    size_t cells;
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

// The numbers of lines along an axis: those of line k at cell or face i lie at i * along + k * across. Null: not there.
struct WaterLines {
    size_t lines, along, across;
    StateNumbers depth, velocity, bed, pressure, force;
    StateNumbers load, stiff;   // of hulls, in cells: the head that presses [m] is load + stiff depth
    double pressure_share;      // from a difference of pressures to an acceleration
    const uint8_t *mask, *wall; // at i * byte_along + k * byte_across
    size_t byte_along, byte_across;
    StateNumbers moved; // out, for carry_across: what went through faces, as depths [m]
    double* tally;      // out: kTallies numbers per line

    // The same from a cell on.
    WaterLines from(size_t cell) const {
        WaterLines part = *this;
        for (StateNumbers* numbers : {&part.depth, &part.velocity, &part.bed, &part.pressure, &part.force, &part.load,
                                      &part.stiff, &part.moved})
            if (*numbers) *numbers = numbers->from(cell * along);
        if (mask) part.mask += cell * byte_along;
        if (wall) part.wall += cell * byte_along;
        return part;
    }
};

// What a line let in and out at its ends, what the limiter held back, all as depths [m]; in how many cells; and the
// parts that it made its step in.
enum WaterTally { kIn, kOut, kHeldBack, kLimited, kParts, kTallies };

// How what a sweep has moved along its lines carries the velocities of the other axis, which lie on the faces between
// lines of cells: before them and behind.
struct WaterAcross {
    size_t cells, lines, along, across;
    bool ring; // along the lines
    StateNumbers velocity, depth[2], moved[2];
    // what closes faces, see WaterLines: the cells before and behind them, walls on them
    const uint8_t *mask[2], *wall;
    size_t byte_along, byte_across;

    // Of cells [first, end) of each line, with walls at both ends.
    WaterAcross run(size_t first, size_t end) const {
        WaterAcross part = *this;
        part.cells = end - first, part.ring = false;
        for (StateNumbers* numbers : {&part.velocity, &part.depth[0], &part.depth[1], &part.moved[0], &part.moved[1]})
            *numbers = numbers->from(first * along);
        for (const uint8_t** bytes : {&part.mask[0], &part.mask[1], &part.wall})
            if (*bytes) *bytes += first * byte_along;
        return part;
    }
};

// Lines that are worked on side by side, the panels of numbers that they need, and what panels have room for beside
// their cells; two more with hulls. Tasks take packs of lines: whole lines of the cache.
constexpr size_t kWaterLanes = 8, kWaterPanels = 14, kHullPanels = 2, kWaterRoom = 1, kWaterPack = 16;
inline size_t water_packs(size_t lines) { return (lines + kWaterPack - 1) / kWaterPack; }

namespace CD_ISA {

// Depths as they will be stored, cell after cell. What rounding takes from a wet cell the next one gets that can take
// it, and the other way round; depths below the least are 0.
template <int N> struct Rounding {
    using L = Lanes<N>;
    bool is_float64;
    L owed{};

    L operator()(L now) {
        now = settled(now, kDry);
        if (is_float64) return now;
        const L none{}, takes = select(now, now + 2 * owed, none), exact = select(takes, now + owed, now);
        const L stored = settled(exact, kDry).template rounded_to<float>();
        owed = select(takes, none, owed) + (exact - stored);
        return stored;
    }
};

// Makes the step along packs [first, first + count) of lines; work: kWaterPanels * (cells + kWaterRoom) * kWaterLanes
// numbers, more with hulls. False if a number left the finite range.
bool sweep_water(const WaterSweep& sweep, const WaterLines& lines, double* work, size_t first, size_t count);

// The same for what is carried across.
bool carry_across(const WaterAcross& across, double* work, size_t first, size_t count);

} // namespace CD_ISA

} // namespace cd
