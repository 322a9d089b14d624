// What a stream does to velocities as it runs through the cells of a line, by velocities of the step's beginning: it
// takes the velocity of the face that it comes from to the one that it reaches, and in steps that resolve waves, where
// depths are even, half of the limited slope of velocities too (second order; minmod, van Leer 1979).
//
// Fluxes have a steady stream's discharge only if this acceleration counts in them as the push does.
#pragma once

#include "kernel/water/line.hh"

namespace cd {
namespace CD_ISA {

// Depths of a cell and its neighbours are even from this ratio of the least to the largest on, in full; none below the
// other: at steps of the bed, bores and shores a slope of velocities would make energy.
constexpr double kEven = 0.9, kUneven = 0.8;

// Half of the limited slope of velocities across a cell: of the faces one before it, beside it, and one behind.
template <int N> inline Lanes<N> half_slope(Lanes<N> through, const Lanes<N> (&u)[4]) {
    using L = Lanes<N>;
    const L none{}, across = u[2] - u[1], behind = select(through, u[1] - u[0], u[3] - u[2]);
    return 0.5 * (larger(smaller(across, behind), none) + smaller(larger(across, behind), none));
}

template <int N> struct StreamAlong {
    using L = Lanes<N>;
    const WaterLine<N> line; // copies: see line.hh
    const StepKind<N> kind;

    // Velocities of the faces one before a cell, beside it, and one behind, as far as the line goes.
    void beside(size_t cell, L (&u)[4]) const {
        const size_t last = line.ring ? line.n - 1 : line.n;
        const size_t far = cell > 0 ? cell - 1 : line.ring ? last : 0, next = cell < last ? cell + 1 : 0;
        const size_t over = next < last ? next + 1 : line.ring ? 0 : last;
        u[0] = line.velocity[far], u[1] = line.velocity[cell], u[2] = line.velocity[next], u[3] = line.velocity[over];
    }
    // The depth that slopes move with: 0 where depths are not even.
    L even_depth(size_t cell) const {
        const size_t n = line.n, before = cell > 0 ? cell - 1 : line.ring ? n - 1 : 0;
        const size_t behind = cell + 1 < n ? cell + 1 : line.ring ? 0 : cell;
        const L a = line.depth[before], d = line.depth[cell], b = line.depth[behind];
        const L least = smaller(smaller(a, b), d), most = larger(larger(a, b), d);
        return positive(smaller(least, (1 / (kEven - kUneven)) * (least - kUneven * most)));
    }
    // What momentum the slope adds to the flux that a cell passes on, u the velocities beside it.
    L sloped(size_t cell, L through, const L (&u)[4]) const {
        const L run = kind.courant * select(through, positive(u[1]), positive(-u[2])); // cells
        const L part = smaller(run, positive(L::splat(1) - run)) * even_depth(cell);
        return (kind.resolves * smaller(part, size_of(through))) * half_slope(through, u);
    }
};

// What velocities of the beginning will be changed by at faces, one after the other along a line.
template <int N> struct StreamAcceleration {
    using L = Lanes<N>;
    const StreamAlong<N> stream;
    struct Passed {
        L flux{}, speed{}, sloped{};
    } before; // by the cell before the next face

    StreamAcceleration(const WaterLine<N>& line, const StepKind<N>& kind) : stream{line, kind} {
        if (line.sweep.advected() && line.n > 1) before = through(line.ring ? line.n - 1 : 0);
    }
    L flow(size_t face) const {
        const WaterLine<N>& line = stream.line;
        const L run = stream.kind.courant * line.velocity[face];
        if (!line.ring && (face == 0 || face == line.n)) return run * line.depth[face == 0 ? 0 : line.n - 1];
        return run * mean_depth(line.cell(line.left(face)), line.cell(face < line.n ? face : 0));
    }
    Passed through(size_t cell) const {
        L u[4];
        stream.beside(cell, u);
        const L flux = 0.5 * (flow(cell) + flow(cell + 1));
        return {flux, select(flux, u[1], u[2]), stream.sloped(cell, flux, u)};
    }
    // Of the next face, a depth times a velocity; 0 unless it lies between wet cells.
    L next(size_t i) {
        const WaterLine<N>& line = stream.line;
        const Passed behind = through(i);
        const L d_l = line.depth[line.left(i)], d_r = line.depth[i], mean = 0.5 * (d_l + d_r), u = line.velocity[i];
        const L from_l = smaller(positive(before.flux), mean), from_r = smaller(positive(-behind.flux), mean);
        const L carried = from_l * (before.speed - u) + from_r * (behind.speed - u);
        const L change = carried + (before.sloped - behind.sloped);
        before = behind;
        return select(smaller(d_l, d_r), stream.kind.resolves * change, L{});
    }
};

} // namespace CD_ISA
} // namespace cd
