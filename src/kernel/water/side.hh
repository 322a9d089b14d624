// What crosses a side of the scene: the discharge as a function of the depth of the cell there, by the invariants
// u + 2 c and u - 2 c, c = sqrt(g d), that simple waves carry (Stoker 1957, chapter 10). Outside an open side water
// rests at a level; a level side holds its level under what flows out.
//
// Of linear momentum the invariants have no closed form; u = c (1 - d_out / d) is that of u - 2 c up to the third order
// of a wave's height.
#pragma once

#include "kernel/water/face.hh"

namespace cd {
namespace CD_ISA {

struct SideFlow {
    double discharge = 0, slope = 0; // outward [m^2/s]; per change of the cell's depth, see SideWaves [m/s]
    double depth = 0;                // of what crosses [m]
    double half_cell = 0;            // 0.5: the side's depth is the cell's when the wave was there, half a cell before
};

// What there is at a side before the step; outward is > 0.
struct SideCell {
    double depth, velocity; // of the cell there; one face inside
    double discharge;       // one face inside
    double crossed;         // velocity at the side
};

// The slope is the tangent of the discharge as a function of the depth; where water comes in, the secant to where it no
// longer does, which is steeper: so that a long step ends there.
struct SideWaves {
    double gravity;
    bool advected;

    double speed(double depth) const { return __builtin_sqrt(gravity * depth); }

    // Beside water of a depth d_out at rest.
    SideFlow open(const SideCell& cell, double d_out) const {
        const double d = cell.depth, u = cell.velocity, c_here = speed(d);
        if (advected && u > c_here && d > d_out) return falls(d, u);
        if (!advected) {
            const double depth = d > d_out / 3 ? d : d_out / 3, c = speed(depth); // comes in by a third at the least
            if (depth > d || !(c > 0)) return fills(d, d_out, c * (d_out - depth), depth);
            const double tangent = c * (1.5 - d_out / (2 * depth));
            return {c * (depth - d_out), c > tangent ? c : tangent, depth, 0.5};
        }
        const double depth = d > d_out * (4.0 / 9) ? d : d_out * (4.0 / 9), c = speed(depth), c_out = speed(d_out);
        const double wave = 2 * (c - c_out);
        if (wave > c) return falls(d, u);
        if (depth > d) return fills(d, d_out, -depth * wave, depth);
        const double tangent = 3 * c - 2 * c_out, secant = 2 * c * c / (c + c_out); // 0 / 0 where all is dry
        return {depth * wave, secant > tangent ? secant : tangent, depth, 0.5};
    }

    // As much comes in as can.
    static SideFlow fills(double d, double d_out, double most, double depth) {
        return {-most, d_out > d ? most / (d_out - d) : 0, depth};
    }

    // Advected water that comes in from a level has its speed U from it: with C the speed of its waves, U + 2 C is the
    // invariant, and C^2 + U^2 / 2 = c_out^2. At most it is critical, U = -C. Else two levels over an uneven bed would
    // drive a stream without end.
    SideFlow comes_in(double invariant, double c_out) const {
        const double critical = __builtin_sqrt(2.0 / 3) * c_out, sum = invariant > critical ? invariant : critical;
        const double root = __builtin_sqrt(3 * (c_out * c_out) - 0.5 * (sum * sum)), c = (sum + root) / 3;
        const double depth = c * c / gravity;
        return {depth * ((sum - 2 * root) / 3), 0, depth};
    }

    // What part of a change crosses a level side by the time theta of a step, as fast as waves cross half a cell.
    double follows(double d_out, double courant, double theta) const {
        const double run = courant * speed(d_out), part = run / (0.5 + (1 - theta) * run);
        return part < 1 ? part : 1;
    }

    // Beside a side that holds the depth d_out there. The discharge one face inside crosses the side in the depth that is
    // held, or, of advected water, in that of a lower cell. What crossed it before changes by `part` to what the invariant
    // says. To raise the cell with the level takes `fill` [m^2/s].
    SideFlow level(const SideCell& cell, double d_out, double fill, double part) const {
        const double d = cell.depth, u = cell.velocity, c = speed(d), c_out = speed(d_out), most = c_out * d_out;
        const double depth = advected && d < d_out ? d : d_out;
        const double invariant = depth > 0 ? (cell.discharge - fill) / depth + 2 * c : 2 * c;
        const bool in = advected && c_out > 0 && invariant < 2 * c_out;
        const SideFlow says = in ? comes_in(invariant, c_out) : SideFlow{d_out * (invariant - 2 * c_out), 0, d_out};
        const double before = cell.crossed * (d > says.depth ? d : says.depth);
        const double flow = (1 - part) * before + part * says.discharge;
        if (u > c || flow > most || (!(d_out > 0) && u > -2 * c)) return falls(d, u);
        const bool is_most = !(flow > -most);
        const double bounded = is_most ? -most : flow;
        if (bounded < 0 && d < d_out && (is_most || !(d > 0))) return fills(d, d_out, -bounded, says.depth);
        return {bounded, d > 0 ? part * (d_out * c / d) : 0, says.depth};
    }

    // What runs faster than its waves leaves as it comes, all else at its critical depth.
    SideFlow falls(double d, double u) const {
        const double c = speed(d);
        if (u > c) return {u * d, u, d};
        return {c * d, 1.5 * c, d};
    }
};

} // namespace CD_ISA
} // namespace cd
