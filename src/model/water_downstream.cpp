// What coupled steps do in which cells may run dry. Water may cross many cells in them, so that a cell gives far more
// than it had; and momentum goes with the water of both axes at once. All is done in one order, whatever the threads.
#include "model/water_work.hh"

#include <math.h>

namespace cd {

namespace {

double positive(double a) { return a > 0 ? a : 0; }

// f(i, j) for all cells, or faces in the ranges, from the k-th corner; whether any call returned true.
template <class F> bool sweep_from(size_t k, size_t first_i, size_t end_i, size_t first_j, size_t end_j, const F& f) {
    bool any = false;
    for (size_t jj = first_j; jj < end_j; ++jj)
        for (size_t ii = first_i; ii < end_i; ++ii) {
            const size_t i = k & 1 ? end_i - 1 - (ii - first_i) : ii, j = k & 2 ? end_j - 1 - (jj - first_j) : jj;
            any |= f(i, j);
        }
    return any;
}

// Streams that waves do not outrun by far would let ripples grow from a cell a step on: the implicit surface damps them
// only where waves cross this many times the cells that water does. Lines that are swept carry on the change of the
// cell that gives (look_ahead), but a system with that in it is not symmetric, and conjugate gradients need that.
constexpr double kOutrun = 16;

// The water of a cell and what goes through its four faces, sorted like the directions of a path: before and behind
// along x, then along y.
template <class T> struct CellWater {
    const WaterCells& w;
    const T* depth;
    const WaterPlanes* planes;

    struct Way {
        size_t cell;      // at the other side of the face
        double* transfer; // through it, in the sense of the axis
        double* twin;     // the same face at the other end of a ring, else the face itself
        double sign;      // 1 where that is out of the cell
        bool open;        // water lies in the face, and a cell beyond
    };
    Way way(size_t at, int direction) const {
        const int a = direction / 2;
        const bool behind = direction % 2 == 1;
        const size_t step = a == 0 ? 1 : w.pitch, n = a == 0 ? w.columns : w.rows;
        const size_t place = a == 0 ? at % w.pitch : at / w.pitch;
        const bool at_end = place == (behind ? n - 1 : 0);
        const size_t face = behind ? at + step : at, round = (n - 1) * step, around = n * step;
        const size_t cell = !at_end ? (behind ? at + step : at - step) : behind ? at - round : at + round;
        double* const transfer = w.transfer[a] + face;
        double* const twin = !at_end ? transfer : behind ? transfer - around : transfer + around;
        const bool open = (!at_end || (w.ring[a] && n > 1)) && planes[a].face[face] > 0;
        return {cell, transfer, twin, behind ? 1.0 : -1.0, open};
    }
    // What is left in the cell.
    double left(size_t at) const {
        const double *const x = w.transfer[0] + at, *const y = w.transfer[1] + at;
        Sum sum;
        for (double part : {double(depth[at]), x[0], -x[1], y[0], -y[w.pitch]}) sum.add(part);
        return sum.value();
    }
};

} // namespace

// Holds streams back to a cell a step where ripples would grow on them: along even depths, not at shores.
template <class T> void WaterStepper<T>::hold_streams() {
    const T *const depth = numbers<T>(w.depth), *const velocity[2] = {numbers<T>(w.velocity[kX]),
                                                                      numbers<T>(w.velocity[kY])};
    double* const share = work.both.load;
    const double courant[2] = {dt / w.size[kX], dt / w.size[kY]};
    const double least = courant[kX] < courant[kY] ? courant[kX] : courant[kY];
    bool any = false;
    each_cell(w, [&](size_t i, size_t j) {
        const size_t at = place(w, i, j);
        double cells = 0; // that water runs across, out of this one
        for (Axis a : {kX, kY})
            cells += courant[a] * (positive(-double(velocity[a][at])) + positive(double(velocity[a][at + stride(a)])));
        const double waves = w.gravity * double(depth[at]) * (least * least);
        const bool holds = cells > 1 && waves < kOutrun * kOutrun * (cells * cells);
        share[at] = holds ? 1 / cells : 1;
        any |= holds;
    });
    if (!any) return;
    Sum held_back;
    for (Axis a : {kX, kY})
        each_face(w, a, [&](size_t i, size_t j) {
            const size_t place_along = a == kX ? i : j, n = w.cells[a], at = place(w, i, j);
            if ((place_along == 0 && !periodic(w, a)) || place_along == n) return;
            const size_t low = place_along > 0 ? at - stride(a) : at + (n - 1) * stride(a);
            T* const u = numbers<T>(w.velocity[a]) + at;
            const double gives = share[*u > 0 ? low : at], d_low = double(depth[low]), d = double(depth[at]);
            const bool alike = d < 2 * d_low && d_low < 2 * d;
            if (gives == 1 || *u == 0 || !alike) return;
            ++w.limited_cells;
            held_back.add((1 - gives) * courant[a] * fabs(double(*u)) * ((d_low + d) / 2));
            *u = T(gives * double(*u));
            if (place_along == 0) u[n * stride(a)] = *u;
        });
    w.limited_volume += held_back.value() * cell_area(w);
}

// What the solve left undone is too much or too little water in cells that shall be empty, or nearly are. It takes the
// way through open faces to the nearest cell that has enough, and what shall be empty is. False if some cell still
// gives more than it has and gets.
template <class T> bool WaterStepper<T>::settle_residual(const WaterCells& cells) {
    const WaterTogether& both = work.both;
    const CellWater<T> water{cells, numbers<T>(w.depth), both.planes};
    constexpr double kUnseen = -2, kEnough = -1;
    double *const way_out = both.gradient.start, *const queue = both.gradient.direction; // 0 to 3: where the way goes
    size_t begin = 0, end = 0;
    each_cell(w, [&](size_t i, size_t j) {
        const size_t at = place(w, i, j);
        way_out[at] = both.stores[at] == 1 && water.left(at) > 4 * both.noise ? kEnough : kUnseen;
    });
    const auto reach_from = [&](size_t at) {
        for (int d = 0; d < 4; ++d) {
            const auto way = water.way(at, d);
            if (!way.open || way_out[way.cell] != kUnseen) continue;
            way_out[way.cell] = d ^ 1;
            queue[end++] = double(way.cell);
        }
    };
    const auto reach_all = [&] {
        while (begin < end) reach_from(size_t(queue[begin++]));
    };
    each_cell(w, [&](size_t i, size_t j) {
        if (way_out[place(w, i, j)] == kEnough) reach_from(place(w, i, j));
    });
    reach_all();
    for (bool wet : {true, false}) // of water that has no such cell, one takes it all
        each_cell(w, [&](size_t i, size_t j) {
            const size_t at = place(w, i, j);
            if (way_out[at] != kUnseen || (wet && both.stores[at] < 1)) return;
            way_out[at] = kEnough;
            queue[end++] = double(at);
            reach_all();
        });
    for (size_t k = end; k-- > 0;) {
        const size_t at = size_t(queue[k]);
        const double left = water.left(at);
        if (way_out[at] == kEnough || (both.stores[at] == 1 && left >= 0)) continue;
        const auto way = water.way(at, int(way_out[at]));
        *way.twin = *way.transfer += way.sign * left;
    }
    bool enough = true;
    const auto check = [&](size_t at) {
        double all = double(water.depth[at]);
        for (int d = 0; d < 4; ++d) all += fabs(*water.way(at, d).transfer);
        enough &= water.left(at) >= -0x1p-48 * all;
    };
    for (size_t k = 0; k < end; ++k) {
        const size_t at = size_t(queue[k]);
        check(at);
        if (way_out[at] != kEnough) check(water.way(at, int(way_out[at])).cell);
    }
    return enough;
}

// What rounding took of rows that now are empty, the next cell takes that can: many times a row's water may have gone
// through it.
template <class T> void WaterStepper<T>::hand_on(const double* owed) {
    double rest = 0;
    for (int turn = 0; turn < 2; ++turn)
        for (size_t j = 0; j < w.cells[kY]; ++j) {
            if (turn == 0) rest += owed[j];
            T* const row = numbers<T>(w.depth) + j * w.pitch;
            for (size_t i = 0; i < w.cells[kX] && rest != 0; ++i) {
                if (!can_take(double(row[i]), rest)) continue;
                row[i] = stored_depth<T>(double(row[i]), rest);
                rest = 0;
            }
        }
}

// Momentum goes with the water: at a face, what was there mixes with what comes from the faces around it, at the speeds
// that those end with. Along one axis after the other, as in short steps, would not do: a face may get its water from
// one axis and give it to the other, many times what is there, and would make energy.
template <class T> void WaterStepper<T>::carry_at_once(const WaterCells& cells, Axis a) {
    const Axis across = other(a);
    const WaterPlanes& planes = work.both.planes[a];
    const double *const along = cells.transfer[a], *const over = cells.transfer[across];
    double* const u = planes.guess;
    const size_t step = stride(a), side = stride(across), n = w.cells[a], lines = w.cells[across];
    const bool ring = periodic(w, a), rings_across = periodic(w, across), closes = w.mask || w.wall[a];
    const size_t first = ring ? 0 : 1;
    double most = 0;
    const auto each_from = [&](size_t k, const auto& f) {
        return a == kX ? sweep_from(k, first, n, 0, lines, f) : sweep_from(k, 0, lines, first, n, f);
    };
    double* const start = work.both.load;
    const auto mix = [&](size_t i, size_t j) {
        const size_t along_at = a == kX ? i : j, line = a == kX ? j : i, at = place(w, i, j);
        if (closes && !crossable(w, a, i, j)) return false;
        const size_t low = along_at > 0 ? at - step : at + (n - 1) * step, right = at + step;
        const size_t before = line > 0 ? at - side : at + (lines - 1) * side;
        const size_t behind = line + 1 < lines ? at + side : at - (lines - 1) * side;
        const double from_left = positive(0.5 * (along[low] + along[low + step]));
        const double from_right = positive(-0.5 * (along[at] + along[right]));
        const bool has_before = line > 0 || rings_across, has_behind = line + 1 < lines || rings_across;
        const double from_before = has_before ? positive(0.5 * (over[low] + over[at])) : 0;
        const double from_behind = has_behind ? positive(-0.5 * (over[low + side] + over[at + side])) : 0;
        const double volume = 0.5 * (work.held[low] + work.held[at]);
        const double all = volume + ((from_left + from_right) + (from_before + from_behind)), was = u[at];
        if (!(all > 0)) return false; // a velocity that was carried there for what comes
        const double sum =
            (from_left * u[low] + from_right * u[right]) + (from_before * u[before] + from_behind * u[behind]);
        u[at] = (volume * start[at] + sum) / all;
        if (along_at == 0) u[at + n * step] = u[at];
        return fabs(u[at] - was) > w.tolerance * most;
    };
    constexpr size_t kSweepsPerIteration = 10; // they cost less than a tenth of one
    each_from(0, [&](size_t i, size_t j) {
        const size_t at = place(w, i, j);
        if (!(planes.face[at] > 0)) u[at] = planes.velocity[at];
        start[at] = u[at];
        most = fabs(u[at]) > most ? fabs(u[at]) : most;
        return false;
    });
    // Eddies that hand their water round many times in a step lose little of an error in a round of sweeps, and always
    // the same part of it in the end: what is still to come is the sum of a geometric series (Aitken 1926).
    constexpr size_t kRound = 4, kLookEvery = 40;
    double *const before_last = work.both.gradient.start, *const last = work.both.gradient.direction;
    const auto keep = [&](double* to) {
        each_from(0, [&](size_t i, size_t j) {
            to[place(w, i, j)] = u[place(w, i, j)];
            return false;
        });
    };
    const auto sum_ahead = [&] {
        Sum square, product;
        each_from(0, [&](size_t i, size_t j) {
            const size_t at = place(w, i, j);
            const double change = last[at] - before_last[at];
            square.add(change * change), product.add(change * (u[at] - last[at]));
            return false;
        });
        const double stays = product.value() / square.value();
        if (!(stays > 0 && stays < 1 - 0x1p-20)) return;
        each_from(0, [&](size_t i, size_t j) {
            const size_t at = place(w, i, j);
            u[at] += stays / (1 - stays) * (u[at] - last[at]);
            if ((a == kX ? i : j) == 0) u[at + n * step] = u[at];
            return false;
        });
    };
    bool changes = true;
    for (size_t k = 1; changes && (k - 1) / kSweepsPerIteration < w.most_iterations; ++k) {
        changes = each_from(k - 1, mix);
        const size_t after_look = k % kLookEvery;
        if (after_look == kLookEvery - 2 * kRound) keep(before_last);
        if (after_look == kLookEvery - kRound) keep(last);
        if (after_look == 0 && changes) sum_ahead();
    }
    worst.reached &= !changes;
}

#define CD_INSTANTIATE(T)                                                    \
    template void WaterStepper<T>::hold_streams();                           \
    template bool WaterStepper<T>::settle_residual(const WaterCells& cells); \
    template void WaterStepper<T>::hand_on(const double* owed);              \
    template void WaterStepper<T>::carry_at_once(const WaterCells& cells, Axis a);
#if CD_WITH_FLOAT32
CD_INSTANTIATE(float)
#endif
#if CD_WITH_FLOAT64
CD_INSTANTIATE(double)
#endif

} // namespace cd
