// What nodes of ropes touch. A node that would be inside a collider at the end of the step is kept out by an impulse
// that only pushes, and friction resists its motion along the surface. Both are stiff resistances within the
// elimination, as the air's are; which nodes touch, and how friction depends on push and speed, the iterations find.
//
// The push acts along the normal n0 that the collider has where the step finds the node. From there all of a convex
// body lies behind n0, so that n0 . (x1 - x0) <= 0: what does not move takes energy and gives none. Along the normal n1
// at the end of the step, which tells what keeps the node out, it would give some wherever a node slides round a body.
#pragma once

#include "kernel/rope_bundle.hh"

namespace cd {
namespace CD_ISA {

// How stiff contacts are, over the mass of the strand: the push that is known already makes up for the rest.
constexpr double kContactStiffness = 1e4;
// At the speed v friction is that of Coulomb times v / (v + this) [m/s].
constexpr double kStickSpeed = 1e-4;
// How far friction may be off, over what it should be; from this iteration on it is that of the push found by then.
constexpr double kFrictionError = 1e-2;
constexpr size_t kGripIterations = 50;

// Of a place x and a collider at this time: the way out of it, and how far outside x lies.
template <int N> void RopeBundle<N>::look_at_gap(const Collider& to, V x, double time, V& normal, L& gap) const {
    const auto at = [&](int k) { return L::splat(to.place(k, time)); };
    const V way{L::splat(to.way[0]), L::splat(to.way[1]), L::splat(to.way[2])}, from = x - V{at(0), at(1), at(2)};
    const L radius = L::splat(to.radius);
    if (to.shape == CD_SHAPE_PLANE) {
        normal = way, gap = dot(way, from) - radius;
        return;
    }
    const double square = (to.way[0] * to.way[0] + to.way[1] * to.way[1]) + to.way[2] * to.way[2];
    const L along = square > 0 ? smaller(positive((1 / square) * dot(way, from)), one()) : L{};
    const V off = from - along * way;
    const L distance = root(dot(off, off));
    normal = direction(off, distance - kNoDirection * radius, one() / distance, V{one(), L{}, L{}});
    gap = distance - radius;
}

// The longer of the springs at node i, by which the tolerance is counted.
template <int N> Lanes<N> RopeBundle<N>::length_at(size_t i) const {
    const L left = i > 0 ? springs[i - 1].length : L{}, right = i + 1 < ropes.nodes ? springs[i].length : L{};
    return larger(left, right);
}

// The speed at which node i would leave the collider, if nothing but the guess's gap made it.
template <int N> Lanes<N> RopeBundle<N>::leaving(size_t i, const Contact& c) const {
    return dot(c.normal, nodes[i].w) - (1 / stage.dt) * c.gap;
}

// Coulomb's friction by the guess, as a resistance.
template <int N> void RopeBundle<N>::set_friction(const Collider& to, size_t i, Contact& c) const {
    const V slip = nodes[i].w - velocity_of(to), across = slip - dot(c.normal, slip) * c.normal;
    const L speed = root(dot(across, across)) + L::splat(kStickSpeed);
    c.friction = select(c.on, (to.friction * positive(c.grip)) / speed, L{});
}

// Looks at what node i touches by the guess; tells its error, 1 where other contacts or frictions are to be solved for.
// iteration: how many came before, 0 where nothing has been solved yet.
template <int N> Lanes<N> RopeBundle<N>::touch(size_t i, size_t iteration) {
    const V before = load(ropes.position, i), x = before + L::splat(stage.dt) * nodes[i].w;
    const L length = length_at(i), room = stage.tolerance * length, free = opposite(held(i));
    L error{};
    for (size_t k = 0; k < stage.collider_count; ++k) {
        const Collider& to = stage.colliders[k];
        Contact& c = contacts[i * stage.collider_count + k];
        if (iteration == 0) look_at_gap(to, before, stage.time_before, c.acting, c.before);
        look_at_gap(to, x, stage.time_after, c.normal, c.gap);
        const L was = c.on, used = c.friction;
        if (iteration == 0) {
            const L alone = nodes[i].ground * positive(leaving(i, c) - dot(c.normal, nodes[i].b));
            c.on = select(open, free * select(room - c.gap, one(), L{}), c.on);
            c.push = select(open, c.on * alone, c.push);
            c.grip = c.push;
            set_friction(to, i, c);
            continue;
        }
        const L inside = free * select(room + c.gap, L{}, one()); // deeper than the tolerance
        c.on = select(open, larger(was * select(c.push, one(), L{}), inside), c.on);
        c.push = select(open, was * c.push, c.push);
        if (iteration < kGripIterations) c.grip = c.push;
        set_friction(to, i, c);
        const L changed = larger(inside * opposite(was), was * opposite(c.on));
        const L other = c.on * select(size_of(used - c.friction) - kFrictionError * c.friction, one(), L{});
        const L depth = free * positive(L{} - c.gap) / length;
        error = larger(error, larger(larger(changed, other), depth));
    }
    return error;
}

// 1 for the strands that touch something.
template <int N> Lanes<N> RopeBundle<N>::touches() const {
    L any{};
    for (size_t k = 0; k < ropes.nodes * stage.collider_count; ++k) any = larger(any, contacts[k].on);
    return any;
}

// Keeps node i out of what it touches: of its mobility, and of y where it would go by itself.
template <int N> void RopeBundle<N>::press(size_t i, M& mobility, V& y) {
    for (size_t k = 0; k < stage.collider_count; ++k) {
        Contact& c = contacts[i * stage.collider_count + k];
        if (!any_positive(c.on)) continue;
        const Axes to = axes(c.normal);
        const V u = velocity_of(stage.colliders[k]);
        const L stiffness = kContactStiffness * heavy, speed = leaving(i, c) + c.push / stiffness;
        resist(c.on * stiffness, to.way, c.acting, speed * to.way, mobility, y, c.pressed);
        resist(c.friction, to.side, to.side, u, mobility, y, c.across[0]);
        resist(c.friction, to.normal, to.normal, u, mobility, y, c.across[1]);
    }
}
// What is left of the impulse phi from the right, at node i.
template <int N> Vector<N> RopeBundle<N>::pressed(size_t i, V phi) {
    for (size_t k = stage.collider_count; k-- > 0;) {
        Contact& c = contacts[i * stage.collider_count + k];
        if (!any_positive(c.on)) continue;
        const Axes to = axes(c.normal);
        phi = phi + (c.across[1].wished - dot(c.across[1].by, phi)) * to.normal;
        phi = phi + (c.across[0].wished - dot(c.across[0].by, phi)) * to.side;
        const L push = c.on * (c.pressed.wished - dot(c.pressed.by, phi));
        c.push = select(open, push, c.push);
        phi = phi + push * c.acting;
    }
    return phi;
}

// What lay inside a collider before the step comes out of it, but is not thrown.
template <int N> void RopeBundle<N>::forget_overlaps() {
    for (size_t i = 0; i < ropes.nodes; ++i)
        for (size_t k = 0; k < stage.collider_count; ++k) {
            const Contact& c = contacts[i * stage.collider_count + k];
            nodes[i].next = nodes[i].next - ((1 / stage.dt) * (c.on * positive(L{} - c.before))) * c.normal;
        }
}

} // namespace CD_ISA
} // namespace cd
