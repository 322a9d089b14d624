// Closes a ring: the response of the open line to the forces of the constraints that close it.
//
// The ring is the open line A and up to three constraints U (the closing spring and, with bend, the bend terms at the
// last node and the first), each with a stiffness s:  (A + U s U') w = b + U s wish. With w_0 the open line's
// answer and W = A^-1 U (model.md, 19),
//      w = w_0 + W f,   f = C^-1 (wish - U' w_0),   C = 1/s + U' W.
// Each U is a sum of tensions of the open line's springs (the closing pull is a pull of -1 in every one of them), and
// U' w the sum of the same tensions times the differences, which rod_line.hh gives without cancellation. So C keeps
// its digits when the springs are stiff: it is the sum of their compliances.
#pragma once

#include "kernel/advance.hh"
#include "kernel/rod_sweep.hh"
#include "solve/rod_line.hh"

namespace cd {

constexpr double kLeastPivot = 1e-12; // of a constraint that adds some compliance, over its own

// Solves the open line under tension(i) in spring i, i in [0, nodes - 1). w: the answer. slope: scratch. Both `nodes`
// long, w in its place. differences(i, d): told w[i + 1] - w[i].
template <class System, class Place, class Tension, class Differences>
void pull_line(size_t nodes, const System& system, const RodRows& rows, Place place, Tension tension, double* w,
               double* slope, bool bends, Differences differences) {
    // A spring softer than its nodes' grounding passes its tension on as loads. Between two such springs, or an end, lies
    // a piece; without bend what it is pulled by acts at its most grounded node, from where tensions of its springs pass
    // it on: a load on a light node, which the others hold, would leave no digits of how it moves. With bend the pieces
    // hold each other, and their outermost nodes take the loads.
    const auto soft = [&](size_t i) { return system.spring(i) < system.ground(i) + system.ground(i + 1); };
    size_t last = 0, from = 0, to = 0; // the piece's last node, and those that take the loads of the soft springs
    double before = 0, after = 0;      // these springs' tensions
    const auto enter_piece = [&](size_t first) {
        size_t anchor = last = first;
        for (; last + 1 < nodes && !soft(last); ++last)
            if (system.ground(last + 1) > system.ground(anchor)) anchor = last + 1;
        from = bends ? first : anchor, to = bends ? last : anchor;
        before = first > 0 ? tension(first - 1) : 0, after = last + 1 < nodes ? tension(last) : 0;
    };
    const auto own = [&](size_t i) { return ((i == from ? before : 0) - (i == to ? after : 0)) / system.ground(i); };
    const auto rest = [&](size_t i) { return tension(i) - (i < from ? before : 0) - (i >= to ? after : 0); };
    using One = Lanes<1>;
    enter_piece(0);
    One u{own(0)}, d{0};
    w[place(0)] = u.v;
    slope[0] = 0;
    for (size_t i = 1; i < nodes; ++i) {
        One wish{0};
        if (i > last) enter_piece(i);
        else wish = One{rest(i - 1) / system.spring(i - 1)};
        rod_reach(rows, place(i), d, wish, One{own(i)}, u, d);
        w[place(i)] = u.v;
        slope[i] = d.v;
    }
    for (size_t i = nodes - 1; i > 0; --i) {
        differences(i - 1, d.v);
        u = u - d;
        if (system.ground(i - 1) - system.ground(i - 1) != 0) u = One{0};
        const size_t at = place(i - 1);
        if (i > 1) d = rod_leave(rows, at, u, One{w[at]}, One{slope[i - 1]}, d - One{slope[i - 1]});
        w[at] = u.v;
    }
}

// C^-1 by bordering: constraint r joins those before it. One that adds no compliance of its own (a cut one has none to
// add, and in a rigid line they coincide to rounding) is already kept by the others, and left out. out.compliance is U' W,
// of which one half is read.
[[gnu::noinline]] inline void invert_compliance(const double* stiffness, RingClosure& out) {
    auto& c = out.compliance;
    for (auto& row : out.inverse)
        for (double& entry : row) entry = 0;
    for (int r = 0; r < out.constraints; ++r) {
        if (!(stiffness[r] > 0)) continue;
        c[r][r] += 1 / stiffness[r];
        double column[3] = {}, pivot = c[r][r];
        const double least = kLeastPivot * pivot;
        for (int a = 0; a < r; ++a) c[r][a] = c[a][r];
        for (int a = 0; a < r; ++a)
            for (int b = 0; b < r; ++b) column[a] += out.inverse[a][b] * c[b][r];
        for (int a = 0; a < r; ++a) pivot -= c[a][r] * column[a];
        if (!(pivot > least)) continue;
        for (int a = 0; a < r; ++a) {
            for (int b = 0; b < r; ++b) out.inverse[a][b] += column[a] * column[b] / pivot;
            out.inverse[a][r] = out.inverse[r][a] = -column[a] / pivot;
        }
        out.inverse[r][r] = 1 / pivot;
    }
}

// response: constraints arrays of `nodes`, filled here. scratch: nodes. stiffness: of the constraints, 0 leaves one
// out.
template <class System, class Place = InOrder>
void factor_ring(size_t nodes, const System& system, const RodRows& rows, int constraints, const double* stiffness,
                 double* const* response, double* scratch, RingClosure& out, Place place = {}) {
    const auto tension = [&](int r, size_t i) -> double { // U_r as tensions of the open line's springs
        if (r == 0) return -1;
        if (r == 1) return i + 2 == nodes ? -2 : -1;
        return i == 0 ? 2 : 1;
    };
    auto& c = out.compliance;
    for (auto& row : c)
        for (double& entry : row) entry = 0;
    for (int s = 0; s < constraints; ++s) {
        pull_line(
            nodes, system, rows, place, [&](size_t i) { return tension(s, i); }, response[s], scratch, constraints > 1,
            [&](size_t i, double d) {
                for (int r = 0; r < constraints; ++r) c[r][s] += tension(r, i) * d;
            });
        out.response[s] = response[s];
    }
    out.constraints = constraints;
    invert_compliance(stiffness, out);
}

} // namespace cd
