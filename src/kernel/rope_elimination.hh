// The elimination of a rope: the mobility of what hangs on the left of a node, from node to node, in both halves at
// once; the spring in the middle, which joins what hangs on both; and the ways back. (model.md, 24 to 26)
#pragma once

#include "kernel/rope_contact.hh"

namespace cd {
namespace CD_ISA {

// Solves the linear system: phi_i = s (dw - e) + u tau, c . (dw - e) = axial tau, into `next`.
template <int N> void RopeBundle<N>::eliminate() {
    Hung hung;
    M& mobility = hung.c;
    V& y = hung.y;
    mobility = M::diagonal(nodes[0].mobility), y = nodes[0].b;
    const bool resists = has_air();
    if (resists) resist(0, hung);
    if (has_contacts()) press(0, hung);
    nodes[0].c = mobility, nodes[0].y = y;
    for (size_t i = 0; i + 1 < node_count; ++i) {
        const Spring& s = springs[i];
        Node& node = nodes[i + 1];
        const L m = node.ground, stiff = s.transverse, ms = m * stiff, diagonal = m + stiff;
        M a{ms * mobility.x, ms * mobility.y, ms * mobility.z};
        a.x.x = a.x.x + diagonal, a.y.y = a.y.y + diagonal, a.z.z = a.z.z + diagonal;
        const M share = inverse(a);
        const V right = share * s.acting, left = transposed_times(share, s.along);
        const L yields = s.axial + dot(s.along, right + m * (mobility * right));
        const L pull = s.taut / yields;
        const V q = stiff * (share * ((y - node.b) + s.wish));
        const L tau = (dot(s.along, (q + m * (mobility * q)) + (node.b - y)) - s.wished) * pull;
        y = (node.b + q) - tau * right;
        const V l = pull * left;
        const V sx = stiff * share.x, sy = stiff * share.y, sz = stiff * share.z;
        const auto row = [&](V own, V scaled, L r) { return (own + transposed_times(mobility, scaled)) - r * l; };
        mobility = {row(share.x, sx, right.x), row(share.y, sy, right.y), row(share.z, sz, right.z)};
        const L fixed = held(i + 1);
        if (any_positive(fixed)) {
            mobility = {select(fixed, V{}, mobility.x), select(fixed, V{}, mobility.y), select(fixed, V{}, mobility.z)};
            y = select(fixed, node.b, y);
        }
        if (resists) resist(i + 1, hung);
        if (has_contacts()) press(i + 1, hung);
        node.c = mobility;
        node.y = y;
    }
    Impulses left{};
    V& phi = left.phi;
    if (halved) {
        Spring& middle = springs[spring_count - 1];
        phi = impulse_between(middle, mobility + pairs_exchanged(mobility), y, pairs_exchanged(y));
        pulls(middle, phi);
    }
    for (size_t i = node_count; i-- > 0;) {
        Node& node = nodes[i];
        node.next = node.y + node.c * phi;
        if (has_contacts()) pressed(i, left);
        if (i == 0) break;
        Spring& s = springs[i - 1];
        if (resists) resisted(i, left);
        phi = phi - node.ground * (node.next - node.b);
        const L fixed = held(i);
        if (any_positive(fixed))
            phi = select(fixed, impulse_between(s, nodes[i - 1].c, nodes[i - 1].y, node.next), phi);
        pulls(s, phi);
    }
}

// What a spring of so much stiffness [kg] leaves of a velocity difference, by the mobilities of what it joins.
template <int N>
__attribute__((noinline)) Matrix<N> yields(Lanes<N> stiffness, Lanes<N> mobility, const Matrix<N>& other) {
    return inverse(plus_diagonal(stiffness * plus_diagonal(other, mobility), Lanes<N>::splat(1)));
}

// The impulse of a spring between what would move by itself at the velocities `left` and `right`. mobility: of both
// together.
template <int N> __attribute__((noinline)) Vector<N> RopeBundle<N>::impulse_between(const Spring& s, const M& mobility,
                                                                                    V left, V right) const {
    const M share = yields(s.transverse, L{}, mobility);
    const V way = right - left, q = s.transverse * (share * (way - s.wish)), u = share * s.acting;
    const L yields = s.axial + dot(s.along, mobility * u);
    const L pull = select(size_of(yields), s.taut / yields, L{}); // 0 between two held nodes
    const L tau = (dot(s.along, way - mobility * q) - s.wished) * pull;
    return q + tau * u;
}

} // namespace CD_ISA
} // namespace cd
