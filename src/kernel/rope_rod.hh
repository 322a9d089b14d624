// Ropes that resist bending: rods. The elimination passes on the mobilities of a node and its link together.
// (model.md, 49, 50)
//
// A joint is a node with a link on either side. With r = w_{i+1} - w_i - G (w_i - w_{i-1}), the links' difference as it
// changes, and D what it is when the step begins, the joint gives the impulse p = -h B (D + h r): on node i + 1, against
// node i, and G^T times against the link before. G is the ratio of the links' rest lengths, times the turn by the rest
// angle: so a rod whose links are at these angles is at rest, and how it lies in the plane makes no difference.
//
// A node that joins what hangs on the left of it has the mobility R = 1 / m; the joint then takes its share of the
// variance of r, S = R + 1 / (h^2 B) + c, with c that of w_i + G u_i alone, u_i = w_i - w_{i-1}. What is left is
// written as products of R, 1 / S and what hangs, without the differences in which a stiff joint would lose its digits;
// and with 1 / S as h^2 B Z, so that a node without bend is a joint of B = 0.
#pragma once

#include "base/turn.hh"
#include "kernel/rope_elimination.hh"

namespace cd {
namespace CD_ISA {

constexpr size_t kByChange = 4; // iterations before a rod that touches nothing may be solved for what changes

// G times what the link before is.
template <int N> Vector<N> RopeBundle<N>::carried(const Joint& joint, V before) const {
    const V along = joint.ratio * before;
    return stage.curls ? joint.turn * along : along;
}

// The joints' stiffness per velocity, and G. A joint of a cut spring has no stiffness. To lanes that go from a strand's
// last node it turns the other way.
template <int N> void RopeBundle<N>::begin_joints() {
    const L h = stage.dt * lambda;
    double ways[N];
    for (int j = 0; j < N; ++j) ways[j] = comes_back[j] ? -1 : 1;
    for (size_t i = 1; i < ropes.nodes; ++i) {
        Joint& joint = joints[i];
        joint.stiffness = L{}, joint.ratio = one(), joint.turn = {one(), L{}}, joint.impulse = V{};
        if (i == 1) continue;
        const Spring &before = springs[i - 2], &link = springs[i - 1];
        const L mean = 0.5 * (before.length + link.length), share = mean * link.per_length;
        joint.ratio = link.length * before.per_length;
        joint.stiffness = select(uncut(before) * uncut(link), (h * share) * (h * share) * of_node(c.bend, i - 1), L{});
        if (!stage.curls) continue;
        const CosineAndSine<L> turn = turn_by(L::load(ways) * of_node(c.angle, i - 1), one());
        joint.turn = {turn.cosine, turn.sine};
    }
}

// The impulses of all joints if nothing moved, times dt, with lambda = 1.
template <int N> auto RopeBundle<N>::bent() const -> L {
    L sum{};
    for (size_t i = 2; i < ropes.nodes; ++i) {
        const V before = springs[i - 1].before - carried(joints[i], springs[i - 2].before);
        sum = sum + joints[i].stiffness * root(dot(before, before));
    }
    return sum;
}

// The energy that joints give by the guess beyond the work that their impulses took, and what rounding may make of it:
// forces add up to moments along the rod, and their roundings with them.
template <int N> void RopeBundle<N>::look_at_joints(Seen& seen) const {
    const double rounding = kRounding * double(ropes.nodes) * double(ropes.nodes) / stage.tolerance;
    const L per_h = L::splat(1 / stage.dt) * per_lambda;
    for (size_t i = 2; i < ropes.nodes; ++i) {
        const Joint& joint = joints[i];
        const V before = springs[i - 1].before - carried(joint, springs[i - 2].before);
        const V r = (nodes[i].w - nodes[i - 1].w) - carried(joint, nodes[i - 1].w - nodes[i - 2].w);
        const V change = L::splat(stage.dt) * r, after = before + change;
        const L stiffness = 0.5 * (per_h * per_h * joint.stiffness); // half of it
        seen.gained = seen.gained + stiffness * dot(change, before + after) + per_lambda * dot(joint.impulse, r);
        seen.rounding = seen.rounding + rounding * stiffness * (dot(before, before) + dot(after, after));
    }
}

// Node i joins what hangs on the node before.
template <int N> void RopeBundle<N>::join(size_t i, Hung& hung) {
    Joint& joint = joints[i];
    const Node& node = nodes[i];
    const L mobility = node.mobility, stiffness = joint.stiffness, ratio = stage.curls ? one() : joint.ratio;
    if (stage.curls) {
        hung.across = times_transposed(joint.ratio * hung.across, joint.turn);
        hung.back = joint.turn * (joint.ratio * hung.back);
        hung.link = joint.turn * times_transposed((joint.ratio * joint.ratio) * hung.link, joint.turn);
    }
    M all, both, &of_node = hung.across, &own = hung.back; // which become E and c - E
#pragma GCC unroll 1
    for (size_t k = 0; k < 3; ++k) {
        const V across = ratio * row(hung.across, k), back = ratio * row(hung.back, k);
        const V link = (ratio * ratio) * row(hung.link, k);
        row(of_node, k) = row(hung.c, k) + across, row(own, k) = back + link, row(both, k) = across + link;
        row(all, k) = row(of_node, k) + row(own, k), row(joint.reach, k) = row(hung.c, k) + back;
    }
    joint.reach = plus_diagonal(joint.reach, mobility);
    const M yielding = yields(stiffness, mobility, all); // Z
    const M stiff = joint.stiff = stiffness * yielding;
    const V bent = (L::splat(1 / stage.dt) * per_lambda) * (one() - by_change) *
                   (i > 1 ? springs[i - 1].before - carried(joint, springs[i - 2].before) : V{});
    const V wished = joint.wished = stiff * (((hung.y + carried(joint, hung.link_y)) - node.b) - bent);
    hung.link_y = (node.b - hung.y) + (mobility * wished + of_node * wished);
    hung.y = node.b + mobility * wished;
#pragma GCC unroll 1
    for (size_t k = 0; k < 3; ++k) {
        const V passed = mobility * (row(yielding, k) + transposed_times(both, row(stiff, k)));
        const V at_link = transposed_times(stiff, row(of_node, k));
        row(hung.link, k) = (passed + row(hung.c, k)) - transposed_times(joint.reach, at_link);
        row(hung.c, k) = mobility * (row(yielding, k) + transposed_times(all, row(stiff, k)));
        row(hung.across, k) = passed;
        row(hung.back, k) = mobility * (row(yielding, k) + transposed_times(stiff, row(own, k)));
    }
}

// The spring on the left of a node pulls at its link: by its transverse stiffness along x, y and z, whatever the way, and
// along itself.
template <int N> void RopeBundle<N>::pull(const Spring& s, Joint& joint, Hung& hung) const {
    M back = hung.back, link = hung.link;
    V link_y = hung.link_y;
    const auto act = [&](size_t k, V moves, L share, L wished, V by_node, V by_link) {
        const Resisted by{share * wished, share * by_node};
        by_link = share * by_link;
        link_y = link_y + by.wished * moves;
        take_from(back, moves, by.by), take_from(link, moves, by_link);
        joint.pulled[k] = by, joint.by_link[k] = by_link;
    };
#pragma GCC unroll 3
    for (size_t k = 0; k < 3; ++k) {
        const V moves = column(link, k);
        const L share = s.transverse / (one() + s.transverse * component(moves, k));
        act(k, moves, share, component(s.wish, k) - component(link_y, k), row(back, k), row(link, k));
    }
    const V moves = link * s.acting;
    const L axial = s.axial + positive(dot(s.along, moves));
    act(3, moves, select(s.taut * size_of(axial), s.taut / axial, L{}), s.wished - dot(s.along, link_y),
        transposed_times(back, s.along), transposed_times(link, s.along));
    hung.back = back, hung.link = link, hung.link_y = link_y;
    // A component of the node's velocity after the other: in each the impulses are the same.
#pragma GCC unroll 1
    for (size_t k = 0; k < 3; ++k) {
        V across = row(hung.across, k), c = row(hung.c, k);
        L y = component(hung.y, k);
#pragma GCC unroll 4
        for (size_t way = 0; way < 4; ++way) {
            const Resisted& by = joint.pulled[way];
            const L moves = way < 3 ? component(across, way) : dot(across, s.acting);
            y = y + by.wished * moves;
            c = c - moves * by.by, across = across - moves * joint.by_link[way];
        }
        row(hung.across, k) = across, row(hung.c, k) = c, component(hung.y, k) = y;
    }
}

template <int N> void RopeBundle<N>::eliminate_rod() {
    Hung hung{};
    hung.c = M::diagonal(nodes[0].mobility), hung.y = nodes[0].b;
    for (size_t i = 0; i < ropes.nodes; ++i) {
        if (i > 0) join(i, hung), pull(springs[i - 1], joints[i], hung);
        if (has_air()) resist(i, hung);
        if (has_contacts()) press(i, hung);
        nodes[i].c = hung.c, nodes[i].y = hung.y, joints[i].across = hung.across;
    }
    Impulses left{};
    for (size_t i = ropes.nodes; i-- > 0;) {
        Node& node = nodes[i];
        Joint& joint = joints[i];
        node.next = (node.y + node.c * left.phi) + joint.across * left.psi;
        if (has_contacts()) pressed(i, left);
        if (i == 0) return;
        if (has_air()) resisted(i, left);
        Spring& s = springs[i - 1];
        V impulse{};
        const V ways[4] = {{one(), L{}, L{}}, {L{}, one(), L{}}, {L{}, L{}, one()}, s.acting};
        for (size_t k = 4; k-- > 0;) {
            const V by = impulse_of(joint.pulled[k], &joint.by_link[k], left) * ways[k];
            left.psi = left.psi + by, impulse = impulse - by;
        }
        pulls(s, impulse);
        const V bend = joint.impulse = joint.wished - joint.stiff * (node.mobility * left.phi + joint.reach * left.psi);
        // A free node takes what makes its momentum right; where it is held, what is left is what its link does.
        left.phi = select(held(i), (V{} - left.psi) - bend, left.phi - node.ground * (node.next - node.b));
        left.psi = V{} - joint.ratio * (stage.curls ? transposed(joint.turn) * bend : bend);
    }
}

// The impulse of joint i by the guess.
template <int N> auto RopeBundle<N>::bends(size_t i) const -> V {
    const Joint& joint = joints[i];
    const V before = springs[i - 1].before - carried(joint, springs[i - 2].before);
    const V r = (nodes[i].w - nodes[i - 1].w) - carried(joint, nodes[i - 1].w - nodes[i - 2].w);
    return V{} - joint.stiffness * ((L::splat(1 / stage.dt) * per_lambda) * before + r);
}

// The same, but where all but energy is right, of what changes from the guess on: nodes begin with what is missing in
// their momentum by the guess, with all that joints give by it. What is passed on else is as large as the velocities by
// which a bent rod would be straight after the step, and of light nodes that are at rest their rounding would be left.
// While the guess moves fast, the rounding of what joints give is more, and of a free rod's momentum.
template <int N> void RopeBundle<N>::eliminate_change() {
    by_change = lengths_right;
    for (size_t i = 0; i < ropes.nodes; ++i) nodes[i].b = nodes[i].b - by_change * nodes[i].w;
    for (size_t i = 2; i < ropes.nodes; ++i) {
        const V p = by_change * bends(i), back = joints[i].ratio * (stage.curls ? transposed(joints[i].turn) * p : p);
        nodes[i].b = nodes[i].b + nodes[i].mobility * p;
        nodes[i - 1].b = nodes[i - 1].b - nodes[i - 1].mobility * (p + back);
        nodes[i - 2].b = nodes[i - 2].b + nodes[i - 2].mobility * back;
    }
    for (size_t i = 0; i < spring_count; ++i) {
        Spring& s = springs[i];
        const V dw = by_change * (nodes[i + 1].w - nodes[i].w);
        s.wish = s.wish - dw, s.wished = s.wished - dot(s.along, dw);
    }
    eliminate_rod();
    for (size_t i = 0; i < ropes.nodes; ++i) nodes[i].next = nodes[i].next + by_change * nodes[i].w;
    for (size_t i = 2; i < ropes.nodes; ++i) joints[i].impulse = joints[i].impulse + by_change * bends(i);
    by_change = L{};
    begin_alone();
}
template <int N> void RopeBundle<N>::eliminate_after(size_t iterations) {
    if (!is_rod()) eliminate();
    else if (iterations < kByChange || has_contacts()) eliminate_rod();
    else eliminate_change();
}

} // namespace CD_ISA
} // namespace cd
