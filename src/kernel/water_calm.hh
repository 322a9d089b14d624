// A line of water (water_line.hh): the step of a calm one, with the same bits, in two passes.
//
// Most water of most scenes is calm: wet from wall to wall, linear, with nothing that pushes, rubs or closes faces, no
// film above its neighbour, no stream of more than a cell, no step so long that cells may run dry. Then every part of
// the step asks for neighbours only: faces, guesses and the elimination go right in one loop; the surface, what it
// moves, what cells hold and what faces keep go left in another. A line that turns out not to be calm has lost nothing
// but time: its state is still there.
#pragma once

#include <utility>

#include "kernel/water_line.hh"

namespace cd {
namespace CD_ISA {

template <int N> bool WaterLine<N>::step_calm() {
    const bool walled = axis.end[0].kind == End::kWall && axis.end[1].kind == End::kWall;
    if (axis.advected || axis.corrections > 0 || axis.rubs() || !(axis.lambda > 0)) return false;
    if (!walled || open || push) return false;
    const double lambda = axis.lambda, courant = axis.courant, wave_gain = axis.gravity * courant;
    const L one = L::splat(1), gain = L::splat(wave_gain * lambda);
    L wild{}; // > 0: not calm, or nearly not

    L b = at(bed, 0), d = at(depth, 0), l{}, from_l{}, y{}, e = one;
    for (size_t i = 0; i < n; ++i) {
        L r{}, to_r{};
        if (i + 1 < n) {
            const L b_r = at(bed, i + 1), d_r = at(depth, i + 1), u = at(velocity, i + 1);
            const FaceLanes<N> f = between_cells<N>(b, b_r, d, d_r);
            const L cells = courant * u;
            wild = larger(wild, select(smaller(d, d_r), f.film, one));
            wild = larger(wild, larger(wave() * f.mean - L::splat(kLongStep), size_of(cells) - one));
            const L h = f.mean - 0.5 * (cells * (d_r - d)), w = u + -(wave_gain * ((b_r - b) + (d_r - d)));
            r = (courant * lambda) * (gain * h);
            to_r = courant * (h * (lambda * w + (1 - lambda) * u));
            put(face, i + 1, h);
            put(guess, i + 1, w);
            b = b_r, d = d_r;
        }
        const L own = one + l * e, inverse = one / (own + r); // see solve_rows
        y = ((from_l - to_r) + l * y) * inverse;
        e = own * inverse;
        put(x, i, y);
        put(pull, i, r * inverse);
        l = r, from_l = to_r;
        if (i % 32 == 31 && any_positive(wild)) return false;
    }
    if (any_positive(wild)) return false;

    L change = at(x, n - 1), out{}, after_r{};
    const auto fill = [&](size_t i, L in) {
        const L left = left_in(at(depth, i), in, out);
        put(after, i, left);
        wild = larger(wild, larger(-left, wave() * left - L::splat(kVeryLongStep)));
        if (i + 1 < n) {
            const L u = at(guess, i + 1), d = (1 + 0x1p-30) * larger(left, after_r);
            wild = larger(wild, smaller(wave() * d - one, u * u - (axis.gravity / 4) * d)); // see slowed_by_newcomers
            put(guess, i + 1, select(larger(positive(left), after_r), u, L{}));
        }
        after_r = left, out = in;
    };
    for (size_t i = n - 1; i-- > 0;) {
        const L change_r = change, u = at(velocity, i + 1);
        change = at(x, i) + at(pull, i) * change;
        const L w = at(guess, i + 1) - gain * (change_r - change);
        put(guess, i + 1, w);
        fill(i + 1, courant * (at(face, i + 1) * (lambda * w + (1 - lambda) * u)));
    }
    fill(0, L{});
    if (any_positive(wild)) return false;
    for (size_t i : {size_t(0), n}) put(guess, i, L{});
    std::swap(velocity, guess);
    tally[kSolves] = one;
    return true;
}

} // namespace CD_ISA
} // namespace cd
