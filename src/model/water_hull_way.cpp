// Where closed faces stop a hull, those of walls and of cells that are not there: see water_hull_plates.hh.
#include "model/water_hull_plates.hh"

namespace cd {

namespace {

// The lattice without end that the scene is a part of, of which a ring repeats and all beyond other sides is open: at
// those hulls stop by themselves. Cells are numbered as there.
struct Lattice {
    const Water& w;

    // Brings the number of a cell into the scene. False beyond a side.
    bool bring(Axis a, int64_t& k) const {
        const int64_t n = int64_t(w.cells[a]);
        if (k >= 0 && k < n) return true;
        k = k % n + (k < 0 && k % n ? n : 0);
        return periodic(w, a);
    }
    bool there(Axis a, int64_t k, int64_t line) const {
        if (!bring(a, k) || !bring(other(a), line)) return true;
        return a == kX ? present(w, size_t(k), size_t(line)) : present(w, size_t(line), size_t(k));
    }
    // Whether water can cross the face between the cells k - 1 and k of a line.
    bool opens(Axis a, int64_t k, int64_t line) const {
        const bool at_side = !periodic(w, a) && (k <= 0 || k >= int64_t(w.cells[a]));
        if (at_side || !bring(a, k) || !bring(other(a), line)) return true;
        return a == kX ? crossable(w, a, size_t(k), size_t(line)) : crossable(w, a, size_t(line), size_t(k));
    }
};

// How far a plate reaches from its middle along an axis.
double reach_of(const Plate& p, const double (&heading)[2], Axis a) {
    return fabs(heading[a]) * p.half[0] + fabs(heading[other(a)]) * p.half[1];
}

// The lines of cells along an axis that a plate lies over, and the cell along it in which its middle lies.
struct Track {
    Lattice lattice;
    Axis a;
    double at; // of its middle, in cells
    int64_t cell = 0, first = 0, end = 0;
    bool seen = false; // else far away

    Track(const Water& w, Axis along, const double (&middle)[2], double reach) : lattice{w}, a(along) {
        const Axis b = other(a);
        at = middle[a] / w.size[a];
        const double low = (middle[b] - reach) / w.size[b], high = (middle[b] + reach) / w.size[b];
        if (!near(a, at) || !near(b, low) || !near(b, high)) return;
        seen = true;
        cell = int64_t(whole_below(at)), first = int64_t(whole_below(low)), end = -int64_t(whole_below(-high));
    }
    bool near(Axis axis, double k) const { return fabs(k) <= kMostRounds * double(lattice.w.cells[axis]); }
    // Whether all cells k of its lines are there, with no walls between them.
    bool whole(int64_t k) const {
        bool good = true;
        for (int64_t line = first; line < end; ++line)
            good = good && lattice.there(a, k, line) && (line == first || lattice.opens(other(a), line, k));
        return good;
    }
    bool opens(int64_t k) const {
        bool good = true;
        for (int64_t line = first; line < end; ++line) good = good && lattice.opens(a, k, line);
        return good;
    }
    // How far ahead, or behind, the next closed face is, if nearer than `most`, in cells from its middle.
    double free(bool ahead, double most) const {
        double way = ahead ? double(cell + 1) - at : at - double(cell);
        if (!whole(cell)) return most; // it lies over one: what of the hull does not tells
        for (int64_t k = cell, left = int64_t(lattice.w.cells[a]); way < most && left >= 0; way += 1, --left) {
            if (!opens(ahead ? k + 1 : k)) return way;
            k += ahead ? 1 : -1;
            if (!whole(k)) return way;
        }
        return most;
    }
};

// Whether the way from one cell to another, first along an axis and then across it, is open.
bool leads(const Lattice& lattice, Axis a, const int64_t (&from)[2], const int64_t (&to)[2]) {
    const Axis b = other(a);
    const auto open = [&](Axis axis, int64_t line) {
        const int64_t low = from[axis] < to[axis] ? from[axis] : to[axis];
        const int64_t high = from[axis] < to[axis] ? to[axis] : from[axis];
        bool good = true;
        for (int64_t k = low + 1; good && k <= high; ++k) good = lattice.opens(axis, k, line);
        return good;
    };
    return open(a, from[b]) && open(b, to[a]);
}

} // namespace

double free_way(const Water& w, size_t index, const HullPose& pose, Axis a, double way) {
    const double size = w.size[a], wish = fabs(way) / size;
    if (!(wish > 0)) return way;
    double most = wish;
    each_plate(w, index, pose, [&](const Plate& p) {
        const Track track(w, a, {p.x, p.y}, reach_of(p, pose.heading, other(a)));
        const double gap = reach_of(p, pose.heading, a) / size + kHullGap;
        if (!track.seen || !(most > 0)) return;
        const double free = track.free(way > 0, most + gap) - gap;
        most = free > 0 ? (free < most ? free : most) : 0;
    });
    return most < wish ? (way > 0 ? most : -most) * size : way;
}

bool can_turn(const Water& w, size_t index, const HullPose& from, const HullPose& to) {
    const Lattice lattice{w};
    bool can = true;
    each_plate(w, index, to, [&](const Plate& p) {
        const double was[2] = {from.x + (p.ahead * from.heading[0] - p.port * from.heading[1]),
                               from.y + (p.ahead * from.heading[1] + p.port * from.heading[0])};
        const double now[2] = {p.x, p.y};
        int64_t left[2], reached[2];
        bool free = true;
        for (Axis a : {kX, kY}) {
            const Track before(w, a, was, reach_of(p, from.heading, other(a)));
            const Track after(w, a, now, reach_of(p, to.heading, other(a)));
            if (!can || !before.seen || !after.seen || !before.whole(before.cell)) return;
            left[a] = before.cell, reached[a] = after.cell;
            free = free && after.whole(after.cell);
        }
        can = free && (leads(lattice, kX, left, reached) || leads(lattice, kY, left, reached));
    });
    return can;
}

} // namespace cd
