// Advected momentum.
//
// In step 3 velocities of the step's beginning tell what a stream will do to the velocity of a face: it takes that of
// the face that it comes from through the cell to the one that it reaches, and where depths are even, half of the
// limited slope of velocities too (second order; minmod, van Leer 1979). Fluxes have a steady stream's discharge only if
// this acceleration counts in them as the push does.
//
// In step 6 momentum goes with the fluxes. What runs through a cell takes the velocity of the face that it leaves to
// the one that it reaches: half of it, but no more than half of what the giver holds, the velocity of the step's
// beginning, the rest that of its end. Of what is left
//
//      (V after + what leaves) u = load + what comes (its donor's u)     (model.md, 40),
//
// is a system in which everything runs one way between two faces: one pass each way solves it, whatever the step. Every
// velocity is a mean of loads and of velocities carried there, with weights that are masses: momentum is kept, and no
// energy is made but by slopes. The same carries the velocities of the other axis, which lie between lines (across.cpp).
//
// The surface pushes the water that there is: in short steps what there was by the slope before and what there is after
// by the slope after, in long ones what there is at theta by the slope at theta, as the two slopes are then large and
// opposite. Over a flat bed either adds up to 0 round a ring, so that waves make no current.
#pragma once

#include "kernel/water/line.hh"

namespace cd {
namespace CD_ISA {

// ---- by velocities of the step's beginning --------------------------------------------------------------------------

// Depths of a cell and its neighbours are even from this ratio of the least to the largest on, in full; none below the
// other: at steps of the bed, bores and shores a slope of velocities would make energy.
constexpr double kEven = 0.9, kUneven = 0.8;

// Half of the limited slope of velocities from a place to the next, by those one before and one behind.
inline L half_slope(L through, const Panel& u, const Neighbours& places, size_t l, size_t r) {
    const L across = u[r] - u[l];
    const L behind = select(through, u[l] - u[places.before(l)], u[places.behind(r)] - u[r]);
    return 0.5 * larger(smaller(across, behind), smaller(larger(across, behind), L{})); // the middle one of these and 0
}

// The depth that slopes move with: 0 where depths are not even. What stands behind a wall is not looked at.
inline L WaterLine::even_depth(size_t cell) const {
    const L d = depth[cell], l = select(open(cell), depth[cells().before(cell)], d);
    const L r = select(open(cell + 1), depth[cells().behind(cell)], d);
    const L least = smaller(smaller(l, r), d), most = larger(larger(l, r), d);
    return positive(smaller(least, (1 / (kEven - kUneven)) * (least - kUneven * most)));
}

// What momentum the slope adds to the flux that a cell passes on.
inline L WaterLine::sloped(size_t cell, L through) const {
    const size_t next = faces().behind(cell);
    const L run = courant * positive(select(through, velocity[cell], -velocity[next])); // cells
    const L part = smaller(smaller(run, positive(L::splat(1) - run)) * even[cell], size_of(through));
    return part * half_slope(through, velocity, faces(), cell, next);
}

// What velocities of the beginning will be changed by at faces, one after the other along a line.
struct StreamAcceleration {
    const WaterLine line; // a copy: see line.hh
    struct Passed {
        L flux{}, speed{}, sloped{};
    } before;      // by the cell before the next face
    L flow_into{}; // the cell behind that face

    explicit StreamAcceleration(const WaterLine& of) : line(of) {
        if (!line.sweep.advected()) return;
        const size_t cell = line.cells().before(0);
        flow_into = flow(cell), before = through(cell);
    }
    L flow(size_t face) const {
        const L l = line.depth[line.left(face)], r = line.depth[line.right(face)], u = line.velocity[face];
        return select(select(u, l, r), (line.courant * u) * (0.5 * (l + r)), L{}); // a dry cell gives none
    }
    Passed through(size_t cell) {
        const L flow_out = flow(cell + 1), flux = 0.5 * (flow_into + flow_out);
        flow_into = flow_out;
        line.even.put(cell, line.even_depth(cell)); // for carry(), too
        const L u_l = line.velocity[cell], u_r = line.velocity[line.faces().behind(cell)];
        return {flux, select(flux, u_l, u_r), line.sloped(cell, flux)};
    }
    // Of the next face, a depth times a velocity; 0 unless it lies between wet cells.
    L next(size_t i) {
        const Passed behind = through(i);
        const L d_l = line.depth[line.left(i)], d_r = line.depth[i], mean = 0.5 * (d_l + d_r), u = line.velocity[i];
        const L from_l = smaller(positive(before.flux), mean), from_r = smaller(positive(-behind.flux), mean);
        const L carried = from_l * (before.speed - u) + from_r * (behind.speed - u);
        const L change = carried + (before.sloped - behind.sloped);
        before = behind;
        return select(smaller(d_l, d_r), change, L{});
    }
};

// ---- with the fluxes ------------------------------------------------------------------------------------------------

constexpr double kNoVolume = 0x1p-900;       // [m]: has no inverse
constexpr double kUnmoved = __builtin_inf(); // [m]: what lies beyond an end or a closed face is not moved

// A face that carries, before the step.
struct FaceVolume {
    L volume, load; // depth; depth times velocity, with what pushes
    L speed;        // that goes with the first half
};

// Carriers 0 to m - 1, or round a ring. Work has
//   at(i)         carrier i; asked for in turn, the last one of a ring at first, too
//   outside(e)    what lies before the first (0) or behind the last (1) of a line
//   through(k)    the flux between carriers k - 1 and k, k from 0 to m, and sloped(k, through) what it adds
//   set(i, u)     takes a new velocity
// pull, around: scratch panels; answers: a panel, too, which may be what at(i) reads.
template <class Work> void carry_line(size_t m, bool ring, Work work, Panel answers, Panel pull, Panel around) {
    const L none{}, one = L::splat(1);
    if (m == 0) return;
    FaceVolume here = ring ? work.at(m - 1) : work.outside(0), first = here;
    struct {
        L early{}, late{},
            momentum{}; // what goes with old velocities and with new ones, and the momentum that it brings
    } in, out;          // of a carrier, from the one before and to the next
    Donors donors{answers, pull, around, ring, ring ? none : here.speed};
    for (size_t k = 0; k <= m; ++k) { // what goes to carrier k, after which all is known of the one before
        const FaceVolume next = k < m ? work.at(k) : ring ? first : work.outside(1);
        const L through = work.through(k);
        out.early = 0.5 * larger(smaller(through, here.volume), -next.volume), out.late = through - out.early;
        out.momentum = out.early * select(through, here.speed, next.speed) + work.sloped(k, through);
        if (k == 0) first = next;
        else {
            const L from_l = positive(in.late), from_r = positive(-out.late);
            const L all = (here.volume + (in.early - out.early)) + (from_l + from_r);
            const L inverse = select(all - L::splat(kNoVolume), one / all, none);
            donors.row(k - 1, here.load + (in.momentum - out.momentum), from_l, from_r, inverse);
        }
        in = out, here = next;
    }
    donors.solve(m, here.speed, [&](size_t i, L u) { work.set(i, u); });
}

// The faces of a line, which carry what its cells pass on.
struct FaceCarriers {
    const WaterLine line;
    size_t first;
    bool any_bounded, any_limited;

    CD_INLINED FaceVolume at(size_t k) const {
        const size_t i = first + k;
        const Beside after = line.beside_after(i);
        const L v0 = line.beside(i).mean_depth(), v1 = after.mean_depth(), base = line.speed[i], u = line.velocity[i];
        const L late = line.late_push(i) * line.pushing_rise(i, after), pushed = base - late;
        L w = pushed, push = v0 * (base - u) - v1 * late;
        if (line.any_long) {
            const double theta = line.sweep.theta;
            const L early = line.early_push(i) * line.pushing_rise(i, line.beside(i));
            if (any_bounded) w = line.bounded(i, pushed);
            push = select(line.is_long, v0 * (w - u) + theta * (v1 - v0) * (w - (pushed + (early + late))), push);
        }
        FaceVolume out{v0, v0 * u + push, u};
        if (any_limited) { // what does not go through gains nothing by the push
            const L less = v0 * u + line.pull[i] * push;
            const L held = smaller(line.limits, size_of(out.load) - size_of(less));
            out.load = select(held, less, out.load), w = select(held, u + line.pull[i] * (w - u), w);
        }
        if (line.pushed) line.pushed.put(i, w);
        if (!line.opening) return out;
        const L open = line.opening[i];
        return {select(open, v0, L::splat(kUnmoved)), open * out.load, open * out.speed};
    }
    FaceVolume outside(int e) const {
        const L far = L::splat(kUnmoved);
        return {far, far, line.speed[e ? line.n : 0]};
    }
    L through(size_t k) const { // a cell
        const size_t c = line.left(first + k);
        return 0.5 * (line.flux[c] + line.flux[c + 1]);
    }
    L sloped(size_t k, L through) const { return line.sloped(line.left(first + k), through); }
    void set(size_t k, L u) const {
        const size_t i = first + k;
        const L water = larger(line.after[line.left(i)], line.after[i]);
        if (line.pushed) { // friction leaves as much of what was carried there as of a push
            const L w = line.pushed[i];
            u = w + line.push[i] * (u - w);
        }
        line.speed.put(i, select(smaller(water, line.open(i)), u, L{}));
    }
};

inline void WaterLine::carry() {
    const FaceCarriers faces{*this, first_face(), any_positive(bounds), any_positive(limits)};
    carry_line(n - first_face(), ring, faces, Panel{speed.first + first_face() * kLines}, pull, spare[0]);
    if (any_long) keep_energy();
}

} // namespace CD_ISA
} // namespace cd
