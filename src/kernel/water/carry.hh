// Step 6: momentum goes with the fluxes. What runs through a cell takes the velocity of the face that it leaves to the
// one that it reaches: half of it, but no more than half of what the giver holds, the velocity of the step's beginning,
// the rest that of its end. Of what is left
//
//      (V after + what leaves) u = load + what comes (its donor's u)     (model.md, 40),
//
// is a system in which everything runs one way between two faces: one pass each way solves it, whatever the step. Every
// velocity is a mean of loads and of velocities carried there, with weights that are masses: momentum is kept, and no
// energy is made but by slopes (stream.hh), which short steps take along.
//
// The same carries the velocities of the other axis, which lie between lines (across.cpp).
#pragma once

#include "kernel/water/stream.hh"

namespace cd {
namespace CD_ISA {

constexpr double kNoVolume = 0x1p-900;       // [m]: has no inverse
constexpr double kUnmoved = __builtin_inf(); // [m]: what lies beyond an end or a closed face is not moved

// A face that carries, before the step.
template <int N> struct CarrierLanes {
    Lanes<N> volume, load; // depth; depth times velocity, with what pushes
    Lanes<N> speed;        // that goes with the first half
};

// What runs from one carrier to the next.
template <int N> struct PassingLanes {
    Lanes<N> early, late, momentum; // what goes with old velocities and with new ones, and the momentum that it brings

    // sloped: momentum that the slope of velocities adds.
    PassingLanes(Lanes<N> through, const CarrierLanes<N>& l, const CarrierLanes<N>& r, Lanes<N> sloped) {
        const Lanes<N> e = 0.5 * smaller(size_of(through), select(through, l.volume, r.volume));
        early = select(through, e, -e);
        late = through - early;
        momentum = early * select(through, l.speed, r.speed) + sloped;
    }
};

// Carriers 0 to m - 1, or round a ring. Work has
//   at(i)         carrier i; asked for in turn, the last one of a ring at first, too
//   outside(e)    what lies before the first (0) or behind the last (1) of a line
//   through(k)    the flux between carriers k - 1 and k, k from 0 to m, and sloped(k, through) what it adds
//   set(i, u)     takes a new velocity
// pull, around: scratch panels; answers: a panel, too, which may be what at(i) reads.
template <int N, class Work>
void carry_line(size_t m, bool ring, Work work, Panel<N> answers, Panel<N> pull, Panel<N> around) {
    using L = Lanes<N>;
    const L none{}, one = L::splat(1);
    if (m == 0) return;
    const CarrierLanes<N> first = work.at(0);
    CarrierLanes<N> here = first, last = ring ? work.at(m - 1) : work.outside(0);
    const auto passing = [&](size_t k, const CarrierLanes<N>& l, const CarrierLanes<N>& r) {
        const L through = work.through(k);
        return PassingLanes<N>(through, l, r, work.sloped(k, through));
    };
    PassingLanes<N> in = passing(0, last, here);
    L y = ring ? none : last.speed, share = one;
    for (size_t i = 0; i < m; ++i) {
        const CarrierLanes<N> next = i + 1 < m ? work.at(i + 1) : ring ? first : work.outside(1);
        const PassingLanes<N> out = passing(i + 1, here, next);
        const L from_l = positive(in.late), from_r = positive(-out.late);
        const L all = (here.volume + (in.early - out.early)) + (from_l + from_r);
        const L inverse = select(all - L::splat(kNoVolume), one / all, none);
        y = ((here.load + (in.momentum - out.momentum)) + from_l * y) * inverse;
        answers.put(i, y);
        pull.put(i, from_r * inverse);
        if (ring) {
            share = share * (from_l * inverse);
            around.put(i, share);
        }
        in = out, here = next;
    }
    L behind = here.speed;
    if (ring) { // what comes round, first one way and then the other: it is linear in itself
        const L round = select(one - share, y / (one - share), none);
        for (size_t i = 0; i < m; ++i) answers.put(i, answers[i] + around[i] * round);
        behind = none, share = one;
        for (size_t i = m; i-- > 0;) behind = answers[i] + pull[i] * behind, share = share * pull[i];
        behind = select(one - share, behind / (one - share), none);
    }
    for (size_t i = m; i-- > 0;) {
        behind = answers[i] + pull[i] * behind;
        work.set(i, behind);
    }
}

// The faces of a line, which carry what its cells pass on.
template <int N> struct FaceCarriers {
    using L = Lanes<N>;
    const WaterLine<N> line;
    const StepKind<N> kind;
    StreamAlong<N> stream;
    size_t first;
    bool any_bounded, any_limited;

    CD_INLINED CarrierLanes<N> at(size_t k) const {
        const size_t i = first + k;
        const auto l = line.cell(line.left(i)), r = line.cell(i);
        const auto l_after = line.cell_after(line.left(i)), r_after = line.cell_after(i);
        const L v0 = mean_depth(l, r), v1 = mean_depth(l_after, r_after), base = line.speed[i], u = line.velocity[i];
        const L late = line.push_of(i, kind) * line.rise_at(i, l_after, r_after);
        CarrierLanes<N> out{v0, v0 * base - v1 * late, u};
        if (any_limited) { // what does not go through gains nothing by the push
            const L push = v0 * (base - u) - v1 * late;
            const L less = v0 * u + line.pull[i] * push;
            out.load = select(smaller(line.limits, size_of(out.load) - size_of(less)), less, out.load);
        }
        if (kind.any_long) { // all of the push comes before
            out.speed = select(kind.is_long, any_bounded ? line.bounded(i, base - late) : base - late, out.speed);
            out.load = select(kind.is_long, v0 * out.speed, out.load);
        }
        if (!line.opening) return out;
        const L open = line.opening[i];
        return {select(open, v0, L::splat(kUnmoved)), open * out.load, open * out.speed};
    }
    CarrierLanes<N> outside(int e) const {
        const L far = L::splat(kUnmoved);
        return {far, far, line.speed[e ? line.n : 0]};
    }
    L through(size_t k) const { // a cell
        const size_t c = line.left(first + k);
        return 0.5 * (line.flux[c] + line.flux[c + 1]);
    }
    L sloped(size_t k, L through) const {
        L u[4];
        stream.beside(line.left(first + k), u);
        return stream.sloped(line.left(first + k), through, u);
    }
    void set(size_t k, L u) const {
        const size_t i = first + k;
        const L water = larger(line.after[line.left(i)], line.after[i]);
        line.speed.put(i, select(smaller(water, line.open(i)), u, L{}));
    }
};

template <int N> void WaterLine<N>::carry(const StepKind<N>& kind) {
    const FaceCarriers<N> faces{*this, kind, {*this, kind}, first_face(), any_positive(bounds), any_positive(limits)};
    carry_line<N>(n - first_face(), ring, faces, Panel<N>{speed.first + first_face() * N}, pull, spare[0]);
    if (ring) speed.put(n, speed[0]);
}

} // namespace CD_ISA
} // namespace cd
