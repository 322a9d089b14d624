// What nodes of ropes touch. A node that would be inside a collider at the end of the step is kept out by an impulse
// along the normal, which only pushes; friction holds it there, or, where that would take more than its share of the
// push, resists its motion by just that share. Which of these holds is found by the iterations, as which springs are
// taut is; each takes its part of the node's mobility within the elimination, as the air does.
#pragma once

#include "kernel/rope_bundle.hh"

namespace cd {
namespace CD_ISA {

// Of a collider, where it is at the end of the step, and of a place x there: how far outside it lies, and the way out.
template <int N> void RopeBundle<N>::look_at_gap(const Collider& to, V x, Contact& contact) const {
    const double moved = stage.time_before + stage.dt;
    const auto at = [&](const double* point) {
        return V{L::splat(point[0] + moved * to.velocity[0]), L::splat(point[1] + moved * to.velocity[1]),
                 L::splat(point[2] + moved * to.velocity[2])};
    };
    const V way{L::splat(to.way[0]), L::splat(to.way[1]), L::splat(to.way[2])}, from = x - at(to.point);
    if (to.shape == CD_SHAPE_PLANE) {
        contact.normal = way;
        contact.gap = dot(way, from) - L::splat(to.radius);
        return;
    }
    const double square = to.way[0] * to.way[0] + to.way[1] * to.way[1] + to.way[2] * to.way[2];
    const L along = square > 0 ? smaller(positive(L::splat(1 / square) * dot(way, from)), one()) : L{};
    const V off = from - along * way;
    const L distance = root(dot(off, off));
    contact.normal =
        direction(off, distance - L::splat(kNoDirection * to.radius), one() / distance, axes(V{one(), L{}, L{}}).side);
    contact.gap = distance - L::splat(to.radius);
}

// The longer of the springs at node i, by which the tolerance is counted.
template <int N> Lanes<N> RopeBundle<N>::length_at(size_t i) const {
    const L left = i > 0 ? springs[i - 1].length : L{}, right = i + 1 < ropes.nodes ? springs[i].length : L{};
    return larger(left, right);
}

// The resistance of friction by the guess.
template <int N> void RopeBundle<N>::set_friction(const Collider& to, size_t i, Contact& c) const {
    const V slip = nodes[i].w - velocity_of(to), across = slip - dot(c.normal, slip) * c.normal;
    const L speed = root(dot(across, across)) + L::splat(kStickSpeed);
    c.sticks = select(c.on, (to.friction * positive(c.push)) / speed, L{});
}

// Looks at what node i touches by the guess; tells its error, and 1 where what holds it is to be solved for anew.
// first: nothing has been solved yet.
template <int N> Lanes<N> RopeBundle<N>::touch(size_t i, bool first) {
    const V w = nodes[i].w, x = load(ropes.position, i) + L::splat(stage.dt) * w;
    const L room = stage.tolerance * length_at(i), free = opposite(held(i));
    L error{};
    for (size_t k = 0; k < stage.collider_count; ++k) {
        const Collider& to = stage.colliders[k];
        Contact& c = contacts[i * stage.collider_count + k];
        const L was = c.on;
        look_at_gap(to, x, c);
        const L inside = select(room + c.gap, L{}, one()); // deeper than the tolerance
        if (first) {
            c.on = free * select(room - c.gap, one(), L{});
            const L leaves = dot(c.normal, w) - L::splat(1 / stage.dt) * c.gap;
            c.push = c.on * (nodes[i].ground * positive(leaves - dot(c.normal, nodes[i].b)));
            c.sticks = L{};
            set_friction(to, i, c);
            continue;
        }
        c.on = free * larger(was * select(c.push, one(), L{}), inside);
        const L used = c.sticks;
        set_friction(to, i, c);
        const L wrong = select(size_of(used - c.sticks) - kFrictionError * c.sticks, one(), L{});
        const L changed = free * larger(inside * opposite(was), was * opposite(c.on));
        error = larger(error, larger(changed, c.on * wrong));
        error = larger(error, free * select(c.on, size_of(positive(L{} - c.gap)) / length_at(i), L{}));
    }
    return error;
}

template <int N> void RopeBundle<N>::press(size_t i, M& mobility, V& y) {
    for (size_t k = 0; k < stage.collider_count; ++k) {
        Contact& c = contacts[i * stage.collider_count + k];
        c.pressed = c.across[0] = c.across[1] = Resisted{};
        if (!any_positive(c.on)) continue;
        const Axes to = axes(c.normal);
        const V w = nodes[i].w, u = velocity_of(stage.colliders[k]);
        const L leaves = dot(to.way, w) - L::splat(1 / stage.dt) * c.gap;
        hold(c.on * weight_of_all, to.way, leaves + c.push / weight_of_all, mobility, y, c.pressed);
        const V ways[2] = {to.side, to.normal};
        for (int a = 0; a < 2; ++a) hold(c.sticks, ways[a], dot(ways[a], u), mobility, y, c.across[a]);
    }
}
// Keeps n . w at `speed` in the lanes where `on` is 1, by an impulse that is held.wished - held.by . phi.
template <int N> void RopeBundle<N>::hold(L k, V n, L speed, M& mobility, V& y, Resisted& held) {
    const V right = mobility * n, left = transposed_times(mobility, n);
    const L share = k / (one() + k * dot(n, right));
    held = {share * (speed - dot(n, y)), share * left};
    y = y + held.wished * right;
    mobility.x = mobility.x - right.x * held.by;
    mobility.y = mobility.y - right.y * held.by;
    mobility.z = mobility.z - right.z * held.by;
}
// What is left of the impulse phi from the right, at node i.
template <int N> Vector<N> RopeBundle<N>::pressed(size_t i, V phi) {
    for (size_t k = stage.collider_count; k-- > 0;) {
        Contact& c = contacts[i * stage.collider_count + k];
        if (!any_positive(c.on)) {
            c.push = L{}, c.friction = V{};
            continue;
        }
        const Axes to = axes(c.normal);
        const L other = c.across[1].wished - dot(c.across[1].by, phi);
        phi = phi + other * to.normal;
        const L side = c.across[0].wished - dot(c.across[0].by, phi);
        phi = phi + side * to.side;
        c.push = c.pressed.wished - dot(c.pressed.by, phi);
        phi = phi + c.push * to.way;
        c.friction = side * to.side + other * to.normal;
    }
    return phi;
}

} // namespace CD_ISA
} // namespace cd
