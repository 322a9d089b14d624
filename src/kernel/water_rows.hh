// What the steps of a line of water need of mathematics: a solver for its systems, friction, the way to dry faces.
#pragma once

#include "kernel/lanes.hh"
#include "kernel/lines.hh"

namespace cd {
namespace CD_ISA {

// ---- a line's system ------------------------------------------------------------------------------------------------

// A row: diagonal x_i - left x_{i-1} - right x_{i+1} = load, with diagonal = ground + to_left + to_right, where `to`
// tells apart what makes up the diagonal: the row's own left and right, or, where columns add up to the ground, what
// x_i gives to the rows beside it. None is negative.
template <int N> struct RowLanes { Lanes<N> ground, left, right, to_left, to_right, load; };

// Less than this grounds nothing: its inverse is no number.
constexpr double kNoGround = 0x1p-900;

// Solves rows [first, last), between x_{first-1} = before and x_last = after. Series-spring elimination, also where
// left and right differ: nothing is ever subtracted, own / whole is what grounds the row beside 1 (of its product with
// to_left only one factor waits for the division). Rows that nothing grounds, not even by way of others, give 0: the
// sign of their pull says where such rows end.
template <int N, class Row> inline void solve_rows(size_t first, size_t last, const Row& row, Lanes<N> before,
                                                   Lanes<N> after, double* x, double* pull) {
    using L = Lanes<N>;
    const L one = L::splat(1);
    L y = before, own = one, inverse = one;
    for (size_t i = first; i < last; ++i) {
        const RowLanes<N> r = row(i);
        const L behind = (r.to_left * own) * inverse, whole = (r.ground + r.to_right) + behind;
        const L counts = whole - L::splat(kNoGround);
        own = r.ground + behind;
        inverse = select(counts, one / whole, L{});
        y = (r.load + r.left * y) * inverse;
        y.store(x + i * N);
        select(counts, r.right * inverse, -one).store(pull + i * N);
    }
    L grounded = one;
    for (size_t i = last; i-- > first;) {
        const L p = L::load(pull + i * N);
        grounded = select(-p, L{}, select(one - p, one, grounded));
        after = select(grounded, L::load(x + i * N) + p * after, L{});
        after.store(x + i * N);
    }
}

// The same for rows [0, n) that go round, left of row 0 being row n - 1, whose diagonals are made of their own left and
// right. With row 0 held at 0, y answers the loads; held at 1 with no loads, 1 - c does, c the answer to loads that are
// the ground. rest: scratch.
template <int N, class Row> inline void solve_round(size_t n, const Row& row, double* x, double* rest, double* pull) {
    using L = Lanes<N>;
    solve_rows<N>(1, n, row, L{}, L{}, x, pull);
    const auto complement = [&](size_t i) {
        RowLanes<N> r = row(i);
        r.load = r.ground;
        return r;
    };
    solve_rows<N>(1, n, complement, L{}, L{}, rest, pull);
    const RowLanes<N> r = row(0);
    L ground = r.ground, load = r.load;
    if (n > 1) {
        const size_t end = (n - 1) * N;
        ground = ground + (r.left * L::load(rest + end) + r.right * L::load(rest + N));
        load = load + (r.left * L::load(x + end) + r.right * L::load(x + N));
    }
    const L at_0 = select(ground - L::splat(kNoGround), load / ground, L{});
    at_0.store(x);
    for (size_t i = 1; i < n; ++i) (L::load(x + i * N) + at_0 * (L::splat(1) - L::load(rest + i * N))).store(x + i * N);
}

// The same where columns add up to the ground. To row 0 held at 1 with no loads z answers, and the sum of all rows is
// what holds it there: what the ground takes of z. z: scratch.
template <int N, class Row>
inline void solve_columns_round(size_t n, const Row& row, double* x, double* z, double* pull) {
    using L = Lanes<N>;
    const L one = L::splat(1);
    solve_rows<N>(1, n, row, L{}, L{}, x, pull);
    const auto unloaded = [&](size_t i) {
        RowLanes<N> r = row(i);
        r.load = L{};
        return r;
    };
    solve_rows<N>(1, n, unloaded, one, one, z, pull);
    const RowLanes<N> r = row(0);
    L ground = r.ground, load = r.load;
    for (size_t i = 1; i < n; ++i) ground = ground + row(i).ground * L::load(z + i * N);
    if (n > 1) load = load + (r.left * L::load(x + (n - 1) * N) + r.right * L::load(x + N));
    const L at_0 = select(ground - L::splat(kNoGround), load / ground, L{});
    at_0.store(x);
    for (size_t i = 1; i < n; ++i) (L::load(x + i * N) + at_0 * L::load(z + i * N)).store(x + i * N);
}

// ---- friction -------------------------------------------------------------------------------------------------------

// a^(-1/3) of a normal number a > 0, by Newton's iteration from its exponent: 4 times squares an error of 4% away.
inline double inverse_cube_root(double a) {
    uint64_t bits;
    memcpy(&bits, &a, sizeof bits);
    bits = 0x553ef0ff289dd796u - bits / 3;
    double r;
    memcpy(&r, &bits, sizeof r);
    for (int k = 0; k < 4; ++k) r = r * ((4.0 / 3) - (a * (1.0 / 3)) * (r * r * r));
    return r;
}

// What friction leaves of a velocity, and of what is added to it, in a step over which it takes z = dt friction: by the
// trapezoidal rule, and from z = 2 on, where that would turn it round, all. What is at rest between push and friction
// stays so at any z.
template <int N> struct FrictionLanes {
    Lanes<N> keep, push;

    explicit FrictionLanes(Lanes<N> z) {
        using L = Lanes<N>;
        const L half = L::splat(1) + 0.5 * z;
        keep = positive(L::splat(1) - 0.5 * z) / half;
        push = L::splat(1) / larger(half, z);
    }
};

// dt times Manning's friction on water of depth h at what it leaves of a speed: k u with u + k u^2 = speed,
// k = manning h^(-4/3). manning: dt g times its square.
template <int N> inline Lanes<N> manning_drag(Lanes<N> h, Lanes<N> speed, double manning) {
    using L = Lanes<N>;
    const L r = each_lane(h, [](double a) { return a > Limits<double>::least ? inverse_cube_root(a) : 0; });
    const L k = manning * ((r * r) * (r * r));
    return (2 * (k * speed)) / (L::splat(1) + root(L::splat(1) + 4 * (k * speed)));
}

// The depth at which a discharge q [m^2/s] runs as fast as its own waves, (q^2 / g)^(1/3).
template <int N> inline Lanes<N> critical_depth(Lanes<N> q, double gravity) {
    if (!(gravity > 0)) return Lanes<N>{};
    return each_lane((1 / gravity) * (q * q), [](double a) {
        const double r = a > 0 ? inverse_cube_root(a) : 0;
        return a * (r * r);
    });
}

// ---- faces ----------------------------------------------------------------------------------------------------------

// How deep a face may be.
template <int N> struct FaceLanes {
    Lanes<N> mean; // of the cells where both are wet, else the gate, or more
    Lanes<N> gate; // how far the water stands over the higher bed
    Lanes<N> drop; // of the surface, where it is a film
    Lanes<N> film; // > 0 where the higher bed is wet above the lower one's surface
};
// Water that stands over a dry bed beside it wets it in the step: there the mean counts, too, where it is more than
// the gate. Not of water deeper than `most`, whose waves cross too many cells in a step.
template <int N>
inline FaceLanes<N> between_cells(Lanes<N> bed_l, Lanes<N> bed_r, Lanes<N> d_l, Lanes<N> d_r, Lanes<N> most) {
    using L = Lanes<N>;
    const L rise = bed_l - bed_r, both = smaller(d_l, d_r);
    const L high = select(rise, d_l, d_r), reach = select(rise, d_r - rise, d_l + rise); // over the higher bed
    const L gate = larger(high, reach), mean = 0.5 * (d_l + d_r);
    const L wets = smaller(gate, most - larger(d_l, d_r));
    return {select(both, mean, select(wets, larger(gate, mean), gate)), gate, high - reach, select(both, -reach, L{})};
}

// > 0 where faces differ in depth by less than a tenth.
template <int N> inline Lanes<N> even_depths(Lanes<N> least, Lanes<N> most) { return 1.1 * least - most; }

// ---- dry faces ------------------------------------------------------------------------------------------------------

constexpr double kFar = 1e300;

// The velocity and the depth of the last wet face that was passed, and how many faces ago.
template <int N> struct NearestLanes {
    Lanes<N> value, depth, distance;

    void pass(Lanes<N> wet, Lanes<N> here, Lanes<N> opening) {
        using L = Lanes<N>;
        value = select(wet, here, value);
        depth = select(wet, wet, depth);
        distance = select(wet, L{}, select(opening, distance + L::splat(1), L::splat(kFar)));
    }
    // How far it is; kFar if it does not come here in a step, and is no neighbour.
    Lanes<N> reach(Lanes<N> courant) const {
        using L = Lanes<N>;
        const L most = larger(L::splat(1.5), L::splat(1) + courant * size_of(value));
        return select(most - distance, distance, L::splat(kFar));
    }
};

} // namespace CD_ISA
} // namespace cd
