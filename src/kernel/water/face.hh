// A face between two cells: whether water can cross it, friction there, and how deep it is.
#pragma once

#include "kernel/water/panels.hh"

namespace cd {
namespace CD_ISA {

struct Cell {
    L bed, depth;

    L surface() const { return bed + depth; }
};

// The cells beside a face.
struct Beside {
    Cell l, r;

    L mean_depth() const { return 0.5 * (l.depth + r.depth); }
    // > 0: water can cross the face: both cells are wet, or one stands higher than the other's bed.
    L conducts() const {
        return larger(smaller(l.depth, r.depth), larger(l.surface(), r.surface()) - larger(l.bed, r.bed));
    }
};

// ---- friction -------------------------------------------------------------------------------------------------------

// a^(-1/3) of normal numbers > 0, and 0 of what is less, by Newton's iteration from the exponent: 4 times squares an error
// of 4% away.
template <int N> inline Lanes<N> inverse_cube_root(Lanes<N> a) {
    Lanes<N> r = each_lane(a, [](double x) {
        uint64_t bits;
        memcpy(&bits, &x, sizeof bits);
        bits = 0x553ef0ff289dd796u - bits / 3;
        double guess;
        memcpy(&guess, &bits, sizeof guess);
        return x > Limits<double>::least ? guess : 0;
    });
    for (int k = 0; k < 4; ++k) r = r * (Lanes<N>::splat(4.0 / 3) - ((1.0 / 3) * a) * (r * r * r));
    return r;
}

// dt times Manning's friction on water of depth h that runs at `across` along the other axis, at what it leaves of a
// speed: k s with u + k s u = speed, s^2 = u^2 + across^2, k = manning h^(-4/3). manning: dt g times its square. With the
// direction of (u, across) this is a quadratic equation, whose answer is the next one's direction: from water that runs
// along the axis three are right to 1e-6.
constexpr int kDirections = 3;
__attribute__((noinline)) inline L manning_drag(L h, L speed, L across, L manning) {
    const L one = L::splat(1);
    const L r = inverse_cube_root(h);
    const L k = manning * ((r * r) * (r * r));
    L s{}, along = one, aside{}; // the direction
    for (int n = 0; n < kDirections; ++n) {
        const L by_aside = one + k * (aside * across);
        const L u = (2 * speed) / (by_aside + root(by_aside * by_aside + 4 * (k * (along * speed))));
        s = root(u * u + across * across);
        if (!any_positive(across)) break;
        along = select(s, u / s, one), aside = select(s, across / s, L{});
    }
    return select(k, k * s, L{}); // s may be infinite where a force finds no water
}

// The depth at which a discharge q [m^2/s] runs as fast as its own waves, (q^2 / g)^(1/3).
inline double critical_depth(double q, double gravity) {
    if (!(gravity > 0)) return 0;
    const double cube = q * q / gravity, r = inverse_cube_root(Lanes<1>{cube}).v;
    return cube * (r * r);
}

// ---- the face's depth -----------------------------------------------------------------------------------------------

// What a cell that runs dry gives of its water. What it keeps is far above rounding, so that rounding does not decide
// whether it is wet; the next steps take it.
constexpr double kGives = 1 - 0x1p-40;

// The depth of a face that water crosses with the speed `speed`; the giver is the cell it comes from, the taker the
// other. It is the mean of the two depths V but
//
//   giver shallower than taker    at most twice the giver's depth and what the bed drops (and no more than lets the
//                                 giver run dry in the step, which is told by `dries`)
//   giver deeper than taker       at least what the surface falls, as far as the giver stands over the higher bed
//   giver's surface below the     at most how far it stands over the middle of the two beds, and how far its heads of
//   taker's bed                   speed lift it over the taker's
//
// all of which agree where they meet. On a flat bed: V up to a ratio of depths of 3, then nearer the giver's.
// Water climbs as far as so many heads of its speed, speed^2 / 2 g, lift it, and not at all from rest.
constexpr double kClimbedHeads = 8;

struct FaceDepth {
    L depth, closed; // closed > 0: nothing crosses the face, whatever the step brings

    // run: of the speed, and what a fall of the surface adds to it [s]: lambda dt / cell, and g times its square. head:
    // speed^2 / 2 g.
    FaceDepth(const Beside& c, L speed, const L* dries, L run, L run_by_fall, L head) {
        const Cell &l = c.l, &r = c.r;
        const L none{}, rightward = select(size_of(speed), speed, l.surface() - r.surface());
        const L give = select(rightward, l.depth, r.depth), take = select(rightward, r.depth, l.depth);
        const L bed = select(rightward, l.bed, r.bed), next_bed = select(rightward, r.bed, l.bed);
        const L mean = c.mean_depth(), fall = (bed - next_bed) + (give - take);
        const L climb = next_bed - bed, over = give - positive(climb);

        L most = 2 * give + positive(-climb);
        if (dries) {
            const L out = run * size_of(speed) + run_by_fall * positive(fall);
            const L whole = larger(2 * give, smaller(most, (kGives * give) / larger(out, L::splat(0x1p-900))));
            most = select(*dries, whole, most);
        }
        const L shallower = smaller(mean, most), deeper = larger(mean, smaller(fall, over));
        const L above = positive(smaller(give - 0.5 * climb, over + kClimbedHeads * head));
        const L uphill = select(over, none, climb);
        depth = select(uphill, smaller(mean, above), select(take - give, shallower, deeper));
        depth = select(give, depth, none);
        closed = select(above, none, uphill);
    }
};

} // namespace CD_ISA
} // namespace cd
