// The water: what it consists of, and what is done with it. The equations are those of contdyn/water.h.
#pragma once

#include "contdyn/water.h"
#include "model/draw.hh"
#include "model/object.hh"
#include "model/water_sleep.hh"

namespace cd {

// The two directions of a water, as indices.
enum Axis { kX = 0, kY = 1 };
inline Axis other(Axis a) { return a == kX ? kY : kX; }

struct WaterSide {
    cd_border kind;
    double value, rate; // value: at time 0
};

// What came in and went out since `initial` was there [m^3].
struct Account {
    double initial, in, out;

    void add(double volume) { (volume > 0 ? in : out) += volume > 0 ? volume : -volume; }
};

struct WaterSettings : ObjectSettings {
    double size[2]; // dx, dy
    cd_momentum momentum;
    cd_bed_rule bed_rule;
    int32_t first;          // the axis that the next step sweeps first
    WaterSide side[4];      // by cd_side
    double inflow_depth[4]; // in which their discharges come in; 0: in that of the cell
    double gravity, density, drag, manning;
    double sleep; // the height below which waves let water fall asleep; 0: it never does
    Account account;
};

// Hulls that float on it, and plates of each: see water_hull.hh.
struct HullShape {
    size_t count, along, across;

    size_t plates() const { return along * across; }
    size_t numbers() const; // of each hull
};

struct Water : Object, WaterSettings {
    const WaterKernels* kernels;

    // shape. A number of cell or face (i, j) lies at j * pitch + i of its array, which has a row and a column more than
    // there are cells: faces need them. Bytes lie densely, at j * (cells[kX] + 1) + i.
    size_t cells[2], pitch, plane;

    // in the object's precision; depth, bed and velocity are always there, the others empty where switched off
    Array<char> depth, bed, velocity[2], source, pressure, force[2];
    Array<uint8_t> mask, wall[2];
    Array<double> hulls;
    HullShape hull_shape;

    // what the last call of step did
    uint64_t limited_cells;
    double limited_volume;
    size_t awake; // cells that its last step moved

    // which parts of it are asleep; surveyed: only what the tiles' marks tell has changed since they were looked at
    WaterTiles tiles;
    bool surveyed;

    // f(array, array of another water...) for each field, in the order in which they are kept; and for every array.
    template <class F, class... W> static void each_field(F f, W&... w) {
        f(w.mask...), f(w.wall[kX]...), f(w.wall[kY]...);
        f(w.depth...), f(w.bed...), f(w.velocity[kX]...), f(w.velocity[kY]...), f(w.source...), f(w.pressure...);
        f(w.force[kX]...), f(w.force[kY]...), f(w.hulls...);
    }
    template <class F> static void each_array(F f, Water& w) {
        each_field(f, w);
        f(w.scratch), f(w.tiles.stir), f(w.tiles.marks);
    }
};

constexpr uint64_t kWaterTag = 0x3172746157644331; // "1CdWatr1"
constexpr double kLinearLambda = 0.55;             // the default
constexpr double kLeastCell = 1e-30, kMostCell = 1e30, kLeastGravity = 1e-60, kMostGravity = 1e6, kMostManning = 1e3;
constexpr double kLeastInflowDepth = 1e-6, kMostInflowDepth = 1e30; // [m]
constexpr double kLeastDensity = 1e-6, kMostDensity = 1e6;

// What costs memory, in one value, so that features change all together or not at all.
struct WaterFeatures {
    cd_method method;
    cd_momentum momentum;
    bool source, pressure, force[2], mask, wall[2], parallel;
    HullShape hulls;
    bool sleep;
};

// ---- shape and parameters (water.cpp) -------------------------------------------------------------------------------

inline Layout layout_of(const Water& w) { return {w.cells[kY] + 1, w.cells[kX] + 1, w.pitch}; }
inline size_t place(const Water& w, size_t i, size_t j) { return j * w.pitch + i; }
inline size_t byte_place(const Water& w, size_t i, size_t j) { return j * (w.cells[kX] + 1) + i; }
inline double cell_area(const Water& w) { return w.size[kX] * w.size[kY]; }

inline Axis axis_of(cd_side side) { return side < CD_SIDE_Y_FIRST ? kX : kY; }
inline cd_side side_of(Axis a, bool at_last) { return cd_side(2 * a + (at_last ? 1 : 0)); }
inline bool periodic(const Water& w, Axis a) { return w.side[2 * a].kind == CD_BORDER_PERIODIC; }
// Whether a side of that kind has a level or a discharge; and that at a time.
inline bool has_level(cd_border kind) { return kind == CD_BORDER_OPEN || kind == CD_BORDER_LEVEL; }
inline bool has_value(cd_border kind) { return kind == CD_BORDER_INFLOW || has_level(kind); }
inline double side_value(const WaterSide& side, double time) { return side.value + side.rate * time; }

// Faces of an axis there are along a direction.
inline size_t faces_along(const Water& w, Axis a, Axis along) { return w.cells[along] + (a == along ? 1 : 0); }
// f(i, j) for every cell, and for every face of an axis, row by row.
template <class F> void each_cell(const Water& w, F f) {
    for (size_t j = 0; j < w.cells[kY]; ++j)
        for (size_t i = 0; i < w.cells[kX]; ++i) f(i, j);
}
template <class F> void each_face(const Water& w, Axis a, F f) {
    for (size_t j = 0; j < faces_along(w, a, kY); ++j)
        for (size_t i = 0; i < faces_along(w, a, kX); ++i) f(i, j);
}

inline bool present(const Water& w, size_t i, size_t j) { return !w.mask || w.mask[byte_place(w, i, j)] != 0; }
inline double depth_at(const Water& w, size_t i, size_t j) { return get_number(w, w.depth, place(w, i, j)); }
inline double bed_at(const Water& w, size_t i, size_t j) { return get_number(w, w.bed, place(w, i, j)); }
// Whether water can cross the face (i, j) of an axis: no wall, cells there on both sides, or a side that is not a wall.
// there(i, j) and wall(axis, i, j) tell of cells and walls.
template <class There, class Wall>
bool crossable(const size_t* cells, const WaterSide* side, Axis a, size_t i, size_t j, There there, Wall wall) {
    const size_t at = a == kX ? i : j, n = cells[a];
    const auto cell = [&](size_t k) { return a == kX ? there(k, j) : there(i, k); };
    if (side[2 * a].kind != CD_BORDER_PERIODIC && (at == 0 || at == n))
        return side[side_of(a, at == n)].kind != CD_BORDER_WALL && cell(at == n ? n - 1 : 0);
    return !wall(a, i, j) && cell(at > 0 ? at - 1 : n - 1) && cell(at < n ? at : 0);
}
bool crossable(const Water& w, Axis a, size_t i, size_t j);
// The depth of the water at a face, as Courant numbers count it: the mean of two wet cells, else how deep the water
// stands over the higher bed. 0 of faces on a side that is not periodic.
double face_depth(const Water& w, Axis a, size_t i, size_t j);
// Of a face that water crosses, the depth that moves with it, as energies count it: the mean of its cells'. Else 0.
double moving_depth(const Water& w, Axis a, size_t i, size_t j);

// ---- life and features (water.cpp) ----------------------------------------------------------------------------------

cd_status create_water(const char* function, size_t nx, size_t ny, double dx, double dy, cd_precision precision,
                       const cd_allocator& allocator, Water*& out);
WaterFeatures features(const Water& w);
// Takes the memory that the features need and releases what they do not; new masks are 1, all else is 0. False for want
// of memory: nothing has changed.
bool set_features(Water& w, const WaterFeatures& wanted);
inline const char* left_out(const WaterFeatures& f) {
    if (!CD_WITH_HULL && f.hulls.count > 0) return "hulls are";
    if (!CD_WITH_ADVECTED && f.momentum == CD_MOMENTUM_ADVECTED) return "advected momentum is";
    if (!CD_WITH_SLEEP && f.sleep) return "sleep is";
    return nullptr;
}
inline bool all_awake(const Water& w) { return !CD_WITH_SLEEP || w.tiles.all_awake; }
// Something has changed cells, or the faces before or below them; or anything.
inline void disturb(Water& w, const CellRectangle& cells) {
    if (CD_WITH_SLEEP) mark_changed(w, cells);
}
inline void disturb(Water& w) { w.surveyed = false; }
// Sets what is at a side, and at the opposite one where one of them is or was periodic.
void set_side(Water& w, cd_side side, const WaterSide& wanted);
// Depth, velocities, time, account and the axis to sweep first back to 0.
void clear_state(Water& w);
bool all_finite(const Water& w);
// Stops the water on faces that it can no longer cross and takes it from cells that are no longer there.
void stop_closed(Water& w);
void restart_account(Water& w);

// ---- time (water_step.cpp) ------------------------------------------------------------------------------------------

// Numbers that steps with these features need; false if too many to count.
bool needs_of(const Water& w, const WaterFeatures& f, size_t& scratch);

// Returns the number of the first step at which a number left the finite range, or 0.
uint64_t step_water(Water& w, double dt, size_t count);

// ---- measuring (water_measure.cpp) ----------------------------------------------------------------------------------

double stable_dt(const Water& w);
double volume(const Water& w);
void energy(const Water& w, double& kinetic, double& potential);
double wet_area(const Water& w);
double courant(const Water& w, double dt);

// The unit vector across a surface that climbs by these slopes.
Vector normal_of(double slope_x, double slope_y);

// The water at a place of the scene.
struct WaterSample {
    double surface, depth, normal[3], velocity[2];
};
WaterSample sample(const Water& w, double x, double y);

// ---- acting on it (water_act.cpp) -----------------------------------------------------------------------------------
// What returns false has changed nothing: a number would have left the range of the water's precision.

struct Disc {
    double x, y, radius;
};
struct CellRectangle {
    size_t first_x, first_y, n_x, n_y;
};
struct Shares; // of the cells of a part of the scene: see water_shares.hh

// Volume [m^3] added by shares; negative: taken, as far as there is water. `added` is what it came to, and what the
// account counts.
bool add_volume(Water& w, const Shares& shares, double volume, double& added);
// A rate [m^3/s] added to the sources, which must be on; and whether it can be, were they on.
bool can_add_source(const Water& w, const Shares& shares, double rate);
void add_source(Water& w, const Shares& shares, double rate);
bool splash(Water& w, const Disc& disc, double height);
bool impulse(Water& w, const Disc& disc, double x, double y);

// ---- drawing (water_draw.cpp) ---------------------------------------------------------------------------------------

// depth_offset SIZE_MAX: no depth
struct WaterVertexFormat : VertexFormat {
    size_t depth_offset;
};
void write_vertices(const Water& w, unsigned char* out, const WaterVertexFormat& format);
size_t index_count(const Water& w, bool skip_dry);
void write_indices(const Water& w, bool skip_dry, unsigned char* out, size_t index_size); // 2 or 4

// ---- keeping (water_keep.cpp) ---------------------------------------------------------------------------------------
// Numbers and bytes of the spare row and column, of which no cell or face is, are kept too: 0, and 1 in the mask.

uint64_t hash(const Water& w);
size_t save_size(const Water& w);
void save(const Water& w, unsigned char* out);
cd_status load(const char* function, Water& w, const unsigned char* bytes, size_t size);
cd_status copy(const char* function, Water& w, const Water& source);

} // namespace cd
