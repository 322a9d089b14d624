// The plates of a hull over the water's lattice, cut into parts of at most half a cell so that it has no holes there.
#pragma once

#include "base/whole.hh"
#include "model/water_hull.hh"

namespace cd {

// Where a hull is.
struct HullPose {
    double x, y, heading[2], z, pitch, roll;

    explicit HullPose(const Hull& h)
        : x(h.x), y(h.y), heading{h.heading[0], h.heading[1]}, z(h.z), pitch(h.pitch), roll(h.roll) {}
};

// Places of the lattice around a point, n along each axis, and their weights, which sum to 1, or are 0 all: nothing is
// there.
template <int n> struct Around {
    size_t i[n], j[n];
    double weight[n * n]; // along x, row by row
    bool any;

    // f(i, j, weight)
    template <class F> void each(F f) const {
        for (int row = 0, c = 0; row < n; ++row)
            for (int k = 0; k < n; ++k, ++c)
                if (weight[c] > 0) f(i[k], j[row], weight[c]);
    }
};

constexpr double kMostRounds = 1e6;    // times round a scene, of no hull
constexpr double kAlmostWhole = 1e-12; // of its length: a part of a plate may be longer than half a cell by so much

// Brings a number of cells along an axis into the scene's [0, cells]. What reaches past a side that is not periodic is
// mirrored there: a hull at a wall is borne by the water along it. False of what is far away, and of NaN.
__attribute__((always_inline)) inline bool bring_in(double& x, size_t cells, bool periodic) {
    const double length = double(cells), round = periodic ? length : 2 * length;
    if (x >= 0 && x <= length) return true; // most
    if (!(fabs(x) <= kMostRounds * round)) return false;
    x -= round * whole_below(x / round);
    if (x > length) x = periodic ? 0 : round - x;
    return true;
}

// The two of n places along an axis, at (k + offset) sizes, that a point lies between; beyond the last ones the last
// one alone.
inline bool between(double at, double size, double offset, size_t cells, size_t n, bool periodic, size_t (&k)[2],
                    double (&weight)[2]) {
    double x = at / size;
    if (!bring_in(x, cells, periodic)) return false;
    x -= offset;
    const double low = whole_below(x);
    weight[1] = x - low, weight[0] = 1 - weight[1];
    if (periodic) {
        k[0] = low < 0 ? cells - 1 : low < double(cells) ? size_t(low) : cells - 1;
        k[1] = k[0] + 1 < cells ? k[0] + 1 : 0;
        return true;
    }
    if (low < 0) k[0] = k[1] = 0;
    else if (low < double(n - 1)) k[0] = size_t(low), k[1] = k[0] + 1;
    else k[0] = k[1] = n - 1;
    return true;
}

// The cell along an axis that a point lies in, and those beside it, by the quadratic B-spline. Weights with a corner,
// those of `between`, would hold a hull fast where its ends lie between cells in one way and not in another.
inline bool spline_around(double at, double size, size_t cells, bool periodic, size_t (&k)[3], double (&weight)[3]) {
    double x = at / size;
    if (!bring_in(x, cells, periodic)) return false;
    const size_t in = x < double(cells) ? size_t(x) : cells - 1;
    const double off = x - (double(in) + 0.5);
    k[0] = in > 0 ? in - 1 : periodic ? cells - 1 : 0;
    k[1] = in;
    k[2] = in + 1 < cells ? in + 1 : periodic ? 0 : cells - 1;
    weight[0] = 0.5 * ((0.5 - off) * (0.5 - off)), weight[1] = 0.75 - off * off;
    weight[2] = 0.5 * ((0.5 + off) * (0.5 + off));
    return true;
}

// The products of weights along both axes.
template <int n> void weigh(Around<n>& out, const double (&along)[n], const double (&across)[n]) {
    out.any = true;
    for (int row = 0; row < n; ++row)
        for (int k = 0; k < n; ++k) out.weight[row * n + k] = along[k] * across[row];
}

// Whether a wall stands at a cell, on the face behind it or ahead of it.
inline bool walled(const Water& w, Axis a, size_t i, size_t j, bool ahead) {
    if (!w.wall[a]) return false;
    size_t& at = a == kX ? i : j;
    if (ahead && ++at == w.cells[a]) at = 0;
    return w.wall[a][byte_place(w, i, j)] != 0;
}
// Between two lines along an axis, at the cell ahead of a face: on the side of the line before or after it.
inline bool walled_beside(const Water& w, Axis a, size_t face, size_t line, bool after) {
    const size_t in = face < w.cells[a] ? face : w.cells[a] - 1;
    return a == kX ? walled(w, kY, in, line, after) : walled(w, kX, line, in, after);
}
// Whether there may be walls, or cells that are not there, as near as so many cells to a hull.
bool is_near_walls(const Water& w, size_t index, const HullPose& pose, double cells);
bool is_near_closed(const Water& w, size_t index, const HullPose& pose, double cells);

// The cells that bear what presses at a point, as far as they are there; walls, where there are some, are mirrors, as the
// sides of a scene are.
void find_cells(const Water& w, double x, double y, bool walls, Around<3>& out);
// The cells whose middles a point lies between, as far as they are there.
Around<2> cells_between(const Water& w, double x, double y);

// In the mirror images of the scene beyond its sides -1, elsewhere 1.
inline double facing(double at, double size, size_t cells, bool periodic) {
    const double x = at / (double(cells) * size);
    if (periodic || (x >= 0 && x <= 1)) return 1;
    const double image = whole_below(x);
    return image - 2 * whole_below(0.5 * image) > 0 ? -1 : 1;
}

// f(i, j, weight) of the faces of an axis whose differences, over a cell's size, are the slope at a point of a surface
// as find_cells weighs it.
template <class F> void each_difference(const Water& w, Axis a, double x, double y, F f) {
    const Axis b = other(a);
    const double at[2] = {x, y}, sign = facing(at[a], w.size[a], w.cells[a], periodic(w, a));
    size_t faces[2], cells[3];
    double along[2], across[3];
    if (!between(at[a], w.size[a], 0, w.cells[a], faces_along(w, a, a), periodic(w, a), faces, along) ||
        !spline_around(at[b], w.size[b], w.cells[b], periodic(w, b), cells, across))
        return;
    for (int c : {0, 2})
        if (w.wall[b] && cells[c] != cells[1] && walled_beside(w, a, faces[0], cells[1], c == 2)) cells[c] = cells[1];
    for (int k = 0; k < 2; ++k)
        for (int c = 0; c < 3; ++c)
            f(a == kX ? faces[k] : cells[c], a == kX ? cells[c] : faces[k], sign * (along[k] * across[c]));
}

// The cells that were seen.
struct CellBox {
    size_t low[2] = {SIZE_MAX, SIZE_MAX}, end[2] = {0, 0};

    void see(size_t i, size_t j) {
        if (i < low[kX]) low[kX] = i;
        if (j < low[kY]) low[kY] = j;
        if (i >= end[kX]) end[kX] = i + 1;
        if (j >= end[kY]) end[kY] = j + 1;
    }
    template <class F> void each(F f) const {
        for (size_t j = low[kY]; j < end[kY]; ++j)
            for (size_t i = low[kX]; i < end[kX]; ++i) f(i, j);
    }
};

struct Plate {
    Around<3> cells;
    double x, y, area;
    double half[2];         // of its length and width [m]
    double ahead, port;     // from the hull's middle [m]
    double height;          // above the keel
    double surface, bed, z; // surface: of the water; z: of the floor, as its skin is pressed

    double sunk() const { return surface > z ? surface - z : 0; }
    double head() const { return kStiff * sunk(); }
};

// see(to, plate) for each part; those over cells that are not there are borne by those under the hull's middle. None
// where the middle has none. depth: a plane of the state's numbers.
void walk_plates(const Water& w, size_t index, const HullPose& pose, const void* depth,
                 void (*see)(void* to, const Plate& p), void* to);

// f(plate), likewise. Its code is there once, whatever is done with plates.
template <class F> void each_plate(const Water& w, size_t index, const HullPose& pose, const void* depth, F f) {
    walk_plates(w, index, pose, depth, [](void* to, const Plate& p) { (*static_cast<F*>(to))(p); }, &f);
}
template <class F> void each_plate(const Water& w, size_t index, const HullPose& pose, F f) {
    each_plate(w, index, pose, w.depth.data, f);
}

// Whether a plate's cells shall answer as if it touched them: also where a sweep may lift the water to it. In a long
// step, in which waves cross more than a cell, that is by as much as the water is deep: what the first sweep throws far
// away from a floor comes back in the second.
inline bool near_water(const Plate& p, double draft, double run) {
    const double depth = p.surface - p.bed, less = draft < depth ? draft : depth, more = draft < depth ? depth : draft;
    return p.surface + (run * depth <= 1 ? less : more) > p.z;
}

// Adds what a hull presses with, as heads in cells, and how that answers to their depths; see(i, j) for those cells.
template <class F>
void press(const Water& w, size_t index, const void* depth, double run, double* heads, double* stiff, F see) {
    const double draft = draft_of(w, index), per_cell = 1 / cell_area(w);
    each_plate(w, index, HullPose(hull(w, index)), depth, [&](const Plate& p) {
        if (!near_water(p, draft, run)) return;
        const double head = p.head();
        p.cells.each([&](size_t i, size_t j, double weight) {
            const double share = weight * (p.area * per_cell);
            heads[place(w, i, j)] += share * head;
            stiff[place(w, i, j)] += share * kStiff;
            see(i, j);
        });
    });
}

// How far a hull may go along an axis, of `way` at most: plates come no nearer than kHullGap to the next face that walls,
// or cells that are not there, close to water, or than they were. And whether it may turn from one pose to the other,
// which lies at the same place: no plate goes through such a face. (water_hull_way.cpp)
double free_way(const Water& w, size_t index, const HullPose& pose, Axis a, double way);
bool can_turn(const Water& w, size_t index, const HullPose& from, const HullPose& to);

constexpr double kHullGap = 1; // cells of water between a hull and what stops it: with none nothing presses it away

// What holds a hull up, and how that changes with height, pitch and roll.
struct HullContact {
    double energy = 0, push[3] = {}, slope[6] = {}; // slope: 00, 01, 02, 11, 12, 22
    double by_bed = 0;                              // of push[0], what the bed bears

    HullContact(const Water& w, size_t index, const HullPose& pose);
};

// A step of backward Euler of height, pitch and roll, with the water held; from velocities v of the three.
void heave(const Water& w, size_t index, HullPose& pose, double (&v)[3], double dt);

} // namespace cd
