// Hulls that float on a water. (model.md, 51 to 56)
//
// A hull is a rectangle of small plates, each with its floor at a height above the keel; it moves as a rigid body, with
// small slopes of pitch and roll. A plate of area a at (x, y) whose floor lies at z presses where it lies below the
// water's surface h, as if a skin between the two were kStiff times as stiff as the water's own surface: with the head
//
//      p = kStiff (h(x, y) - z)+ [m],      energy density gravity a p^2 / (2 kStiff),
//
// h a quadratic B-spline of the cells' surfaces, and the same weights hand the plate's load on to the cells, so that
// force and load are derivatives of one energy. What lies on the bed, where h is the bed, is carried by it by the same
// law.
//
// A step is a series of steps of which each takes energy from the whole, or leaves it:
//
//   sweeps   with the hulls held where they are. A cell's surface answers as 1 + stiff times itself, stiff the
//            sum of its plates' shares, kStiff a / cell, which is at least as stiff as the plates are together: the
//            line's fluxes are solved for with that at once.
//   heave    with the water held: height, pitch and roll by backward Euler, to the minimum of a convex function.
//   drift    along x and y and round, by the slope of the water's head in the sweeps, which unlike that of the energy
//            is level in still water, however a hull lies over the cells; the energy by which that and the way across
//            the surface differ is owed (Hull::owed), and taken as drag once it is much.
//
// Each holds at any dt and any ratio of masses, and so does all of it. A skin that gives way
// lets the body lie deeper than its floor on the water (settle_hulls), which is what is drawn.
#pragma once

#include <initializer_list>

#include "model/water_shares.hh"

namespace cd {

constexpr double kStiff = 3;
constexpr size_t kMostHulls = 4096, kMostPlates = 256; // along and across

// Numbers of a hull; its floor's heights follow them, a row along it after the other; < 0: no plate.
struct Hull {
    double mass;          // 0: there is none
    double length, width; // of all plates along it and across
    double x, y, z, heading[2], pitch, roll;
    double velocity[6]; // along x, y, z; yaw, pitch, roll
    double force[6];    // from outside: ahead, to port, up; moments of yaw, pitch, roll
    double drag[2], friction;
    double lies[3]; // height, pitch and roll of its floor on the water, see settle_hulls
    double owed;     // energy that drifting has made [J]
    double water[6]; // what the water and the bed did in the last step, as velocity
};
constexpr double kLeastHull = 1e-12, kMostHull = 1e15; // masses [kg]
constexpr double kLeastHullSize = 1e-60;               // [m]: smaller, moments of inertia and drafts leave double
constexpr double kMostHullCells = 512;                 // how long and wide a hull may be
constexpr double kMostHullForce = 1e30;                // and drag [N], [N m], [N s/m]
constexpr double kHeadingError = 1e-6;                 // of the square of its length, which is 1
constexpr size_t kHullNumbers = sizeof(Hull) / sizeof(double);

inline size_t HullShape::numbers() const { return kHullNumbers + plates(); }

inline Hull& hull(const Water& w, size_t index) {
    return *reinterpret_cast<Hull*>(w.hulls.data + index * w.hull_shape.numbers());
}
inline double* plate_heights(const Water& w, size_t index) {
    return w.hulls.data + index * w.hull_shape.numbers() + kHullNumbers;
}
// Along the velocity's six ways: what it takes to change it.
void inertia(const Hull& h, double (&out)[6]);

// The size of the cells that hulls are measured by: the smaller one, of the axes that have more than one cell.
inline double cell_size(const double* size, const size_t* cells) {
    const bool both = (cells[kX] > 1) == (cells[kY] > 1);
    return both ? (size[kX] < size[kY] ? size[kX] : size[kY]) : size[cells[kX] > 1 ? kX : kY];
}
// Of what is saved.
inline bool is_off(const Hull& h) { return h.mass == 0; }
inline bool valid_hull(const Hull& h, const double* size, const size_t* cells) {
    const double most = kMostHullCells * cell_size(size, cells);
    const auto fits = [&](double length) { return length > 0 && length <= most; };
    // The direction of the bow has length 1, or is no number, or there never was one.
    const double square = h.heading[0] * h.heading[0] + h.heading[1] * h.heading[1];
    const bool has_none = h.heading[0] == 0 && h.heading[1] == 0;
    bool good = has_none ? is_off(h) : !(fabs(square - 1) > kHeadingError);
    for (double force : h.force) good &= fabs(force) <= kMostHullForce;
    for (double resists : {h.drag[0], h.drag[1], h.friction}) good &= resists >= 0 && resists <= kMostHullForce;
    if (is_off(h)) return good && isfinite(h.length) && isfinite(h.width);
    return good && h.mass >= kLeastHull && h.mass <= kMostHull && fits(h.length) && fits(h.width);
}

// Scratch of steps with hulls, and of a launch.
struct HullWork {
    double *load, *stiff; // planes: see kernel/water/sweep.hh
    double* own[2];       // planes of one hull, 0 between uses
    double* before;       // depths before the sweep, a plane of the state's numbers
    double* impulse;      // three numbers a hull: along x, y, round z
    double run;           // the square of the cells that waves of a metre of depth cross in the step
};

HullWork hull_work(const Water& w);

// ---- what is set and told (water_hull.cpp) -------------------------------------------------------------------------

double hull_area(const Water& w, size_t index);
// How deep a hull with a flat floor lies [m].
double draft_of(const Water& w, size_t index);
// How far its plates reach along an axis from its middle, backward and forward.
void hull_extent(const Water& w, size_t index, const double (&heading)[2], Axis a, double (&out)[2]);
// Sets height, pitch and roll at which the water as it lies carries a hull's weight; false where nothing can.
bool lay_on_water(Water& w, size_t index);
// Likewise, with the water giving way to it: what it displaces goes to all that stands about as high as the water under
// it. False where nothing can carry it, and nothing has changed.
bool launch(Water& w, size_t index, const HullWork& work);
// The energy of the hulls' motion, of their height, and of what they press.
void hull_energy(const Water& w, double& kinetic, double& potential);
// The water's surface at a place, had no hull pressed it down.
double head_at(const Water& w, double x, double y);

bool hulls_finite(const Water& w);
void reset_hulls(Water& w); // back to where new ones lie, at rest

// ---- steps (water_hull_step.cpp) -----------------------------------------------------------------------------------

// Before a sweep: what hulls press. After it: what that did to them.
void load_hulls(const Water& w, HullWork& work, bool first);
void feel_water(const Water& w, HullWork& work, Axis a, double theta, double dt);
// After both. False if what they gave the water left the finite range.
bool move_hulls(Water& w, HullWork& work, double dt);
// How their floors lie on the water: where the head of a level lake, surface and load, is as far above them as they
// press, in the mean of the plates that touch the water and in their slopes. So a hull that lies still displaces its
// own mass, however its edges lie over the cells.
void settle_hulls(Water& w, const HullWork& work);

} // namespace cd
