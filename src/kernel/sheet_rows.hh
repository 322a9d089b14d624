// What acts on a row of a uniform sheet, bundle by bundle.
#pragma once

#include "kernel/sheet.hh"

namespace cd {
namespace CD_ISA {

namespace {

// One row of a plane, and the rows above and below it.
struct Rows {
    const double *here, *above, *below;

    Rows(const double* here_, const double* above_, const double* below_) : here(here_), above(above_), below(below_) {}
    Rows(const Grid& grid, const double* plane, size_t row)
        : here(plane + row * grid.pitch),
          above(plane + grid.above(row) * grid.pitch),
          below(plane + grid.below(row) * grid.pitch) {}
};

template <int N> inline Lanes<N> at(const double* row, size_t u) { return Lanes<N>::load(row + u); }
// The number before u, which may lie beyond the row's start.
template <int N> inline Lanes<N> before(const double* row, size_t u) { return Lanes<N>::load(row + u - 1); }
template <int N> inline Lanes<N> after(const double* row, size_t u) { return Lanes<N>::load(row + u + 1); }

// Everything by value: the compiler cannot know that what is stored is none of it.
struct Separable {
    const double *after_u, *before_u, *gain_u;
    double after_v, before_v, gain_v;
    bool constant;
    double gravity;
    double* out; // where the row starts
    Rows x;

    Separable(const SeparableSheet& sheet, bool constant_, double gravity_, double* row_out, const Rows& rows,
              size_t row)
        : after_u(sheet.after[0]),
          before_u(sheet.before[0]),
          gain_u(sheet.gain[0]),
          after_v(sheet.after[1][row]),
          before_v(sheet.before[1][row]),
          gain_v(sheet.gain[1][row]),
          constant(constant_),
          gravity(gravity_),
          out(row_out),
          x(rows) {}

    template <int N> void bundle(size_t u) const {
        using L = Lanes<N>;
        const L here = at<N>(x.here, u);
        const L along_u =
            L::load(after_u + u) * (after<N>(x.here, u) - here) - L::load(before_u + u) * (here - before<N>(x.here, u));
        const L along_v = after_v * (at<N>(x.below, u) - here) - before_v * (here - at<N>(x.above, u));
        const L push = constant ? L::splat(gravity) : L::load(out + u);
        (gain_v * (L::load(gain_u + u) * (push + (along_u + along_v)))).store(out + u);
    }
};

template <class S, class T> struct PushSeparable {
    const SeparableSheet& sheet;
    const SheetPush<T>& push;
    const S* v;
    double* out;               // where the row starts
    size_t row;                // likewise, in planes
    double inverse_mass, drag; // of the row

    template <int N> void bundle(size_t u) const {
        using L = Lanes<N>;
        const size_t at = row + u;
        L sum = L::splat(push.gravity);
        if (push.forces || push.pressed) {
            L force{};
            if (push.forces) force = L::load(push.forces + at);
            if (push.pressed) force = force + L::load(push.pressed + at);
            sum = sum + (push.force * inverse_mass) * (L::load(sheet.inverse_mass[0] + u) * force);
        }
        L rate = L::splat(drag);
        if (sheet.drag[0]) rate = rate + L::load(sheet.drag[0] + u);
        (sum - rate * L::load(v + at)).store(out + u);
    }
};

} // namespace

} // namespace CD_ISA
} // namespace cd
