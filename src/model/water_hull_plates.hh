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
        for (int c = 0, end = any ? n * n : 0; c < end; ++c) // not a constant, for which compilers write it n n times
            if (weight[c] > 0) f(i[c % n], j[c / n], weight[c]);
    }
};

constexpr double kMostRounds = 1e6;    // times round a scene, of no hull
constexpr double kAlmostWhole = 1e-12; // of its length: a part of a plate may be longer than half a cell by so much

// Brings a number of cells along an axis into the scene's [0, cells]. What reaches past a side that is not periodic is
// mirrored there: a hull at a wall is borne by the water along it. False of what is far away, and of NaN.
inline bool bring_in(double& x, size_t cells, bool periodic) {
    const double length = double(cells), round = periodic ? length : 2 * length;
    if (x >= 0 && x <= length) return true; // most
    if (!(fabs(x) <= kMostRounds * round)) return false;
    x -= round * whole_below(x / round);
    if (x > length) x = periodic ? 0 : round - x;
    return true;
}

// The two of n places along an axis, at (k + offset) sizes, that a point lies between; beyond the last ones, the last one
// alone.
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

// Of weights along both axes those of the places that are there.
template <int n, class There>
void weigh(Around<n>& out, const double (&along)[n], const double (&across)[n], bool all, There there) {
    double sum = 0;
    for (int c = 0; c < n * n; ++c) {
        out.weight[c] = all || there(out.i[c % n], out.j[c / n]) ? along[c % n] * across[c / n] : 0;
        sum += out.weight[c];
    }
    out.any = sum > 0;
    if (!all && out.any)
        for (double& weight : out.weight) weight /= sum;
}

// The cells that bear what presses at a point, as far as they are there.
inline Around<3> cells_around(const Water& w, double x, double y) {
    Around<3> out{};
    double along[3], across[3];
    if (spline_around(x, w.size[kX], w.cells[kX], periodic(w, kX), out.i, along) &&
        spline_around(y, w.size[kY], w.cells[kY], periodic(w, kY), out.j, across))
        weigh(out, along, across, !w.mask, [&](size_t i, size_t j) { return present(w, i, j); });
    return out;
}

// The cells whose middles a point lies between, as far as they are there.
inline Around<2> cells_between(const Water& w, double x, double y) {
    Around<2> out{};
    double along[2], across[2];
    if (between(x, w.size[kX], 0.5, w.cells[kX], w.cells[kX], periodic(w, kX), out.i, along) &&
        between(y, w.size[kY], 0.5, w.cells[kY], w.cells[kY], periodic(w, kY), out.j, across))
        weigh(out, along, across, !w.mask, [&](size_t i, size_t j) { return present(w, i, j); });
    return out;
}

// Among the faces of an axis.
inline Around<2> faces_around(const Water& w, Axis a, double x, double y) {
    Around<2> out{};
    double along[2], across[2];
    if (between(x, w.size[kX], a == kX ? 0 : 0.5, w.cells[kX], faces_along(w, a, kX), periodic(w, kX), out.i, along) &&
        between(y, w.size[kY], a == kY ? 0 : 0.5, w.cells[kY], faces_along(w, a, kY), periodic(w, kY), out.j, across))
        weigh(out, along, across, true, [](size_t, size_t) { return true; });
    return out;
}

// f(i, j, weight) of the faces of an axis whose differences, over a cell's size, are the slope of what cells_around tells
// of a surface.
template <class F> void each_difference(const Water& w, Axis a, double x, double y, F f) {
    const Axis b = other(a);
    const double at[2] = {x, y};
    size_t faces[2], cells[3];
    double along[2], across[3];
    if (!between(at[a], w.size[a], 0, w.cells[a], faces_along(w, a, a), periodic(w, a), faces, along) ||
        !spline_around(at[b], w.size[b], w.cells[b], periodic(w, b), cells, across))
        return;
    for (int k = 0; k < 2; ++k)
        for (int c = 0; c < 3; ++c)
            f(a == kX ? faces[k] : cells[c], a == kX ? cells[c] : faces[k], along[k] * across[c]);
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
    double ahead, port;     // from the hull's middle [m]
    double height;          // above the keel
    double surface, bed, z; // surface: of the water; z: of the floor, as its skin is pressed

    double sunk() const { return surface > z ? surface - z : 0; }
    double head() const { return kStiff * sunk(); }
};

// The water over the cells that bear a plate. depth: a plane of the state's numbers.
template <class T> void look_at_water(const Water& w, const T* depth, Plate& p) {
    const T* const bed = numbers<T>(w.bed);
    p.surface = p.bed = 0;
    p.cells.each([&](size_t x, size_t y, double weight) {
        const double b = double(bed[place(w, x, y)]);
        p.bed += weight * b;
        p.surface += weight * (b + double(depth[place(w, x, y)]));
    });
}

// Where a plate lies, ahead and to port of the hull's middle, and what is there.
template <class T>
__attribute__((noinline)) void look_at_plate(const Water& w, const HullPose& pose, const T* depth, Plate& p) {
    p.x = pose.x + (p.ahead * pose.heading[0] - p.port * pose.heading[1]);
    p.y = pose.y + (p.ahead * pose.heading[1] + p.port * pose.heading[0]);
    p.z = pose.z + ((pose.pitch * p.ahead + pose.roll * p.port) + p.height * (1 + 1 / kStiff));
    p.cells = cells_around(w, p.x, p.y);
    look_at_water(w, depth, p);
}

// f(plate) for each part; those over cells that are not there are borne by those under the hull's middle. None where
// the middle has none. depth: a plane of the state's numbers.
template <class T, class F>
void each_plate(const Water& w, size_t index, const HullPose& pose, const T* depth, F f) {
    const Hull& h = hull(w, index);
    const HullShape& shape = w.hull_shape;
    const double* const floors = plate_heights(w, index);
    const double most = 0.5 * cell_size(w.size, w.cells);
    const double long_of = h.length / double(shape.along), wide = h.width / double(shape.across);
    const auto parts = [&](double length) { // none longer than half a cell
        const double enough = -whole_below(length / most * (kAlmostWhole - 1));
        return enough > 1 ? size_t(enough) : 1;
    };
    const size_t n = parts(long_of), m = parts(wide);
    const double step_long = long_of / double(n), step_wide = wide / double(m);
    const Around<3> middle = cells_around(w, pose.x, pose.y);
    if (!middle.any) return;
    Plate p;
    p.area = step_long * step_wide;
    for (size_t j = 0; j < shape.across; ++j)
        for (size_t i = 0; i < shape.along; ++i) {
            const double height = floors[j * shape.along + i];
            if (height < 0) continue;
            for (size_t l = 0; l < m; ++l)
                for (size_t k = 0; k < n; ++k) {
                    p.height = height;
                    p.ahead = (double(i * n + k) + 0.5) * step_long - 0.5 * h.length;
                    p.port = (double(j * m + l) + 0.5) * step_wide - 0.5 * h.width;
                    look_at_plate(w, pose, depth, p);
                    if (!p.cells.any) p.cells = middle, look_at_water(w, depth, p);
                    f(p);
                }
        }
}
template <class F> void each_plate(const Water& w, size_t index, const HullPose& pose, F f) {
    by_precision(w, [&](auto zero) {
        using T = decltype(zero);
        each_plate(w, index, pose, const_cast<const T*>(numbers<T>(w.depth)), f);
    });
}

// What holds a hull up, and how that changes with height, pitch and roll.
struct HullContact {
    double energy = 0, push[3] = {}, slope[6] = {}; // slope: 00, 01, 02, 11, 12, 22
    double by_bed = 0;                              // of push[0], what the bed bears

    HullContact(const Water& w, size_t index, const HullPose& pose) {
        const double head = w.density * w.gravity;
        each_plate(w, index, pose, [&](const Plate& p) {
            const double sunk = p.sunk();
            if (!(sunk > 0)) return;
            const double stiff = head * (kStiff * p.area), force = stiff * sunk;
            energy += 0.5 * (force * sunk);
            push[0] += force, push[1] += force * p.ahead, push[2] += force * p.port;
            slope[0] += stiff, slope[1] += stiff * p.ahead, slope[2] += stiff * p.port;
            slope[3] += stiff * (p.ahead * p.ahead), slope[4] += stiff * (p.ahead * p.port);
            slope[5] += stiff * (p.port * p.port);
            if (p.bed > p.z) by_bed += stiff * (p.bed - p.z);
        });
    }
};

// A step of backward Euler of height, pitch and roll, with the water held; from velocities v of the three.
void heave(const Water& w, size_t index, HullPose& pose, double (&v)[3], double dt);

} // namespace cd
