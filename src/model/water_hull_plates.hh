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

// Four places of the lattice around a point, and their weights, which sum to 1, or are 0 all: nothing is there.
struct Corner4 {
    size_t i[2], j[2];
    double weight[4]; // low and high i at low j, then at high j
    bool any;

    // f(i, j, weight)
    template <class F> void each(F f) const {
        for (int c = 0; c < 4; ++c)
            if (weight[c] > 0) f(i[c & 1], j[c >> 1], weight[c]);
    }
};

constexpr double kMostRounds = 1e6;    // times round a scene, of no hull
constexpr double kAlmostWhole = 1e-12; // of its length: a part of a plate may be longer than half a cell by so much

// Of n places along an axis, at (k + offset) sizes; beyond the last ones, the last one alone. What reaches past a side
// that is not periodic is mirrored there: a hull at a wall is borne by the water along it.
inline bool between(double at, double size, double offset, size_t cells, size_t n, bool periodic, size_t (&k)[2],
                    double& part) {
    double x = at / size;
    const double inside = x - offset, last = double((periodic ? cells : n) - 1);
    if (inside >= 0 && inside < last) { // most
        k[0] = size_t(inside), k[1] = k[0] + 1;
        part = inside - double(k[0]);
        return true;
    }
    const double length = double(cells), round = periodic ? length : 2 * length;
    if (!(fabs(x) <= kMostRounds * round)) return false; // nor NaN
    x -= round * whole_below(x / round);
    if (x > length) x = periodic ? 0 : round - x;
    x -= offset;
    const double low = whole_below(x);
    part = x - low;
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

// Around a point among the cells' centres that are there.
inline Corner4 cells_around(const Water& w, double x, double y) {
    Corner4 out{};
    double part[2];
    if (!between(x, w.size[kX], 0.5, w.cells[kX], w.cells[kX], periodic(w, kX), out.i, part[0]) ||
        !between(y, w.size[kY], 0.5, w.cells[kY], w.cells[kY], periodic(w, kY), out.j, part[1]))
        return out;
    double sum = 0;
    for (int c = 0; c < 4; ++c) {
        const double of = (c & 1 ? part[0] : 1 - part[0]) * (c & 2 ? part[1] : 1 - part[1]);
        out.weight[c] = !w.mask || present(w, out.i[c & 1], out.j[c >> 1]) ? of : 0;
        sum += out.weight[c];
    }
    out.any = sum > 0;
    if (w.mask && out.any && sum < 1)
        for (double& weight : out.weight) weight /= sum;
    return out;
}

// Among the faces of an axis.
inline Corner4 faces_around(const Water& w, Axis a, double x, double y) {
    Corner4 out{};
    double part[2];
    if (!between(x, w.size[kX], a == kX ? 0 : 0.5, w.cells[kX], faces_along(w, a, kX), periodic(w, kX), out.i,
                 part[0]) ||
        !between(y, w.size[kY], a == kY ? 0 : 0.5, w.cells[kY], faces_along(w, a, kY), periodic(w, kY), out.j,
                 part[1]))
        return out;
    for (int c = 0; c < 4; ++c)
        out.weight[c] = (c & 1 ? part[0] : 1 - part[0]) * (c & 2 ? part[1] : 1 - part[1]);
    out.any = true;
    return out;
}

struct Plate {
    Corner4 cells;
    double x, y, area;
    double ahead, port;     // from the hull's middle [m]
    double height;          // above the keel
    double surface, bed, z; // surface: of the water; z: of the floor, as its skin is pressed

    double sunk() const { return surface > z ? surface - z : 0; }
    double head() const { return kStiff * sunk(); }
};

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
    const T* const bed = numbers<T>(w.bed);
    const Corner4 middle = cells_around(w, pose.x, pose.y);
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
                    p.x = pose.x + (p.ahead * pose.heading[0] - p.port * pose.heading[1]);
                    p.y = pose.y + (p.ahead * pose.heading[1] + p.port * pose.heading[0]);
                    p.cells = cells_around(w, p.x, p.y);
                    if (!p.cells.any) p.cells = middle;
                    p.z = pose.z + ((pose.pitch * p.ahead + pose.roll * p.port) + height * (1 + 1 / kStiff));
                    p.surface = p.bed = 0;
                    p.cells.each([&](size_t x, size_t y, double weight) {
                        const double b = double(bed[place(w, x, y)]);
                        p.bed += weight * b;
                        p.surface += weight * (b + double(depth[place(w, x, y)]));
                    });
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
