// Parts of a water that are asleep (contdyn/water.h, cd_water_set_sleep): square tiles that steps leave alone, because
// whatever stirs, in them and as far around them as a step carries it, is lower than a height that the user has set.
//
// Which tiles those are follows from the state alone, so nothing of it is kept with the state, and any order of calls
// leads to the same bits. How much each tile stirs is remembered from step to step, as long as only steps change the
// water: then a tile that sleeps need not be looked at.
//
// What stirs at a face is measured as g times the square of a height: of the rise of the surface across a tile, were it
// everywhere as steep as there, and of the wave whose water runs as fast, sqrt(depth / g) |u|. Where water stands less
// than the height over the higher bed, none does.
#pragma once

#include "base/memory.hh"
#include "kernel/kernels.hh"

namespace cd {

struct Water;
struct CellRectangle;

constexpr size_t kTile = kWaterPack; // cells along each side: the lines that sweeps take together

struct TileStir {
    double stir, deepest, fastest; // [m^3/s^2], [m], [m/s]

    void add(const TileStir& other) {
        stir = other.stir > stir ? other.stir : stir;
        deepest = other.deepest > deepest ? other.deepest : deepest;
        fastest = other.fastest > fastest ? other.fastest : fastest;
    }
};

// What is known of a tile. kReached: see spread in water_sleep.cpp.
enum TileMark : uint8_t {
    kAwake = 1,   // the last step moved it
    kStill = 2,   // nothing moves on its faces
    kChanged = 4, // by something else than a step, since it was looked at
    kReached = 8
};

struct WaterTiles {
    size_t count[2];      // along the axes
    Array<TileStir> stir; // of each tile, row by row; empty where nothing sleeps
    Array<uint8_t> marks;
    bool all_awake;

    size_t size() const { return count[0] * count[1]; }
    // Of a line of tiles along an axis, the one at `tile`.
    size_t at(int along, size_t tile, size_t line) const {
        return along == 0 ? line * count[0] + tile : tile * count[0] + line;
    }
    bool awake(size_t tile) const { return (marks[tile] & kAwake) != 0; }
    // f(first cell, end) for each run of tiles that are awake, in a line of tiles as long as so many cells.
    template <class F> void each_run(int along, size_t line, size_t cells, F f) const {
        const size_t tiles = count[along];
        for (size_t t = 0; t < tiles; ++t) {
            if (!awake(at(along, t, line))) continue;
            const size_t first = t * kTile;
            while (t < tiles && awake(at(along, t, line))) ++t;
            f(first, t * kTile < cells ? t * kTile : cells);
        }
    }
};

// What acts from outside, a source, a force, a hull or what is beyond an open side, may raise waves of so many times
// the height in one step before a step reflects them at tiles that still sleep.
constexpr double kStrong = 1024;
double stir_of_acting(const Water& w);

inline size_t tiles_of(size_t cells) { return (cells + kTile - 1) / kTile; }

// See disturb.
void mark_changed(Water& w, const CellRectangle& cells);
// Measures how much tiles with a mark stir, and those behind them, which the faces between belong to.
void survey_marked(const Water& w, uint8_t mark);
// Before a step of dt: which tiles it moves. Water falls still on the faces of those that fall asleep; `moved` is the
// plane of what has gone through faces, see WaterLines, and is 0 there too.
void choose_awake(Water& w, StateNumbers moved, double dt);
// After it: how much they stir.
void survey_awake(Water& w);
// Cells of tiles that are awake.
size_t awake_cells(const Water& w);

} // namespace cd
