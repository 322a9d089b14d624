// What resists the nodes of ropes: the air, and what contacts are made of. A resistance takes from what hangs on a node
// a part of rank one, and of the impulses from the right what it does against them on the way back.
#pragma once

#include "kernel/rope_bundle.hh"

namespace cd {
namespace CD_ISA {

// The most that the air resists a node, over what that resists itself: of what it would move by an impulse without air,
// this leaves some digits, and more resistance would leave none.
constexpr double kMostAir = 1e10;

template <int N> typename RopeBundle<N>::Axes RopeBundle<N>::axes(V way) {
    const V x{one(), L{}, L{}}, y{L{}, one(), L{}}; // one of them is 45 degrees off at least
    const V off = cross(way, select(size_of(way.x) - L::splat(0.7), y, x));
    const V side = (one() / root(dot(off, off))) * off;
    return {way, side, cross(way, side)};
}

// Takes from what hangs on a node what resists it, along the unit vector n as it moves and along `acting` as it pushes
// back, by an impulse k (n . u - n . w), which is resisted.wished - resisted.by . phi.
template <int N> void RopeBundle<N>::resist(L k, const V& n, const V& acting, const V& u, Hung& hung,
                                            Resisted& resisted, V* by_link) const {
    const V right = hung.c * acting;
    const L share = k / (one() + k * dot(n, right)), wished = share * dot(n, u - hung.y);
    const V by = share * transposed_times(hung.c, n);
    resisted = {wished, by};
    hung.y = hung.y + wished * right;
    take_from(hung.c, right, by);
    if (!is_rod()) return;
    const V right_link = hung.back * acting, link = share * transposed_times(hung.across, n);
    *by_link = link;
    hung.link_y = hung.link_y + wished * right_link;
#pragma GCC unroll 1
    for (size_t i = 0; i < 3; ++i) {
        const L of_node = component(right, i), of_link = component(right_link, i);
        row(hung.across, i) = row(hung.across, i) - of_node * link;
        row(hung.back, i) = row(hung.back, i) - of_link * by, row(hung.link, i) = row(hung.link, i) - of_link * link;
    }
}
template <int N> void RopeBundle<N>::take_from(M& a, const V& column, const V& row) {
    a.x = a.x - column.x * row;
    a.y = a.y - column.y * row;
    a.z = a.z - column.z * row;
}
template <int N>
Lanes<N> RopeBundle<N>::impulse_of(const Resisted& resisted, const V* by_link, const Impulses& from_right) const {
    const L impulse = resisted.wished - dot(resisted.by, from_right.phi);
    return is_rod() ? impulse - dot(*by_link, from_right.psi) : impulse;
}

// ---- the air --------------------------------------------------------------------------------------------------------

// The way of the rope at node i, by the guess that its neighbours go on as they are.
template <int N> Vector<N> RopeBundle<N>::way_at(size_t i) const {
    V left = nodes[i].w, right = left, before{}, after{};
    if (i > 0) {
        const L there = uncut(springs[i - 1]);
        left = select(there, nodes[i - 1].w, left), before = select(there, springs[i - 1].before, V{});
    }
    if (i < spring_count) {
        const L there = uncut(springs[i]);
        right = select(there, nodes[i + 1].w, right), after = select(there, springs[i].before, V{});
    }
    const V chord = ((stage.dt * lambda) * (right - left) + before) + after;
    const L size = root(dot(chord, chord));
    return direction(chord, size - kNoDirection * share_of(i), one() / size, V{one(), L{}, L{}});
}
// The length of the rope that feels the air at node i [m].
template <int N> Lanes<N> RopeBundle<N>::share_of(size_t i) const {
    const auto half = [&](size_t k) { return k < spring_count ? uncut(springs[k]) * (0.5 * springs[k].length) : L{}; };
    return i > 0 ? half(i) + half(i - 1) : half(i);
}
// The air's resistance at node i [kg], of a coefficient of it; 0 of what is held. And its velocity there.
template <int N> Lanes<N> RopeBundle<N>::resistance(size_t i, double coefficient) const {
    return smaller(((coefficient * stage.dt) * share_of(i)) * lambda, kMostAir * nodes[i].ground);
}
template <int N> Vector<N> RopeBundle<N>::wind(size_t i) const {
    if (ropes.wind.data) return load(ropes.wind, i);
    return {L::splat(stage.wind[0]), L::splat(stage.wind[1]), L::splat(stage.wind[2])};
}
template <int N> void RopeBundle<N>::resist(size_t i, Hung& hung) {
    InAir& n = in_air[i];
    const L along = resistance(i, stage.along), across = resistance(i, stage.across);
    const V u = wind(i) - by_change * nodes[i].w;
    const Axes to = axes(n.way);
    resist(along, to.way, to.way, u, hung, n.along, links_of_air(i));
    resist(across, to.side, to.side, u, hung, n.side, links_of_air(i) + 1);
    resist(across, to.normal, to.normal, u, hung, n.normal, links_of_air(i) + 2);
}
// What is left of the impulses from the right, at node i.
template <int N> void RopeBundle<N>::resisted(size_t i, Impulses& left) const {
    const InAir& n = in_air[i];
    const Axes to = axes(n.way);
    left.phi = left.phi + impulse_of(n.normal, links_of_air(i) + 2, left) * to.normal;
    left.phi = left.phi + impulse_of(n.side, links_of_air(i) + 1, left) * to.side;
    left.phi = left.phi + impulse_of(n.along, links_of_air(i), left) * to.way;
}

} // namespace CD_ISA
} // namespace cd
