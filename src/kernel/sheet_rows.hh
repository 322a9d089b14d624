// What acts on a row of a uniform sheet, bundle by bundle.
#pragma once

#include <type_traits>

#include "kernel/line_lanes.hh"
#include "kernel/sheet.hh"

namespace cd {
namespace CD_ISA {

namespace {

// Where planes are larger than what stays in the cache, memory is asked for so many bytes ahead, bundle by bundle: rows
// begin, and in strips end, where processors that look ahead by themselves do not expect them.
constexpr size_t kAhead = 4096;
inline bool leaves_cache(const Grid& grid) { return grid.rows * grid.pitch >= 1 << 17; }

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
    double inside_u, inside_gain_u; // of the columns between the first and the last one, where they are alike
    bool fetches;
    double after_v, before_v, gain_v;
    bool constant;
    double gravity;
    double* out; // where the row starts; holds the push, unless that is constant
    Rows x;

    Separable(const Grid& grid, const SeparableSheet& sheet, bool constant_, double gravity_, double* row_out,
              const Rows& rows, size_t row)
        : after_u(sheet.after[0]),
          before_u(sheet.before[0]),
          gain_u(sheet.gain[0]),
          inside_u(after_u[grid.columns > 1]),
          inside_gain_u(gain_u[grid.columns > 1]),
          fetches(leaves_cache(grid)),
          after_v(sheet.after[1][row]),
          before_v(sheet.before[1][row]),
          gain_v(sheet.gain[1][row]),
          constant(constant_),
          gravity(gravity_),
          out(row_out),
          x(rows) {}

    template <int N, bool kInside> Lanes<N> acts(size_t u) const {
        using L = Lanes<N>;
        const L here = at<N>(x.here, u);
        const L to_after = after<N>(x.here, u) - here, from_before = here - before<N>(x.here, u);
        const L along_u = kInside ? inside_u * to_after - inside_u * from_before
                                  : L::load(after_u + u) * to_after - L::load(before_u + u) * from_before;
        const L along_v = after_v * (at<N>(x.below, u) - here) - before_v * (here - at<N>(x.above, u));
        const L push = constant ? L::splat(gravity) : L::load(out + u);
        return gain_v * ((kInside ? L::splat(inside_gain_u) : L::load(gain_u + u)) * (push + (along_u + along_v)));
    }
    template <int N, bool kInside = false> void bundle(size_t u) const {
        if (N > 1 && fetches) __builtin_prefetch(out + u + kAhead / sizeof(double), 1);
        acts<N, kInside>(u).store(out + u);
    }
};

// Bundles of columns that all lie between the first and the last.
template <class F> struct InnerBundles {
    F& f;
    template <int N> void bundle(size_t u) const { f.template bundle<N, true>(u); }
};
// As along_whole_row, for all columns of what asks Separable.
template <class F> inline void along_springs(size_t columns, F&& f) {
    constexpr size_t n = kWidest;
    const size_t inner = columns > 2 * n ? (columns - 1) / n * n - n : 0, begins = inner > 0 ? n : 0;
    along_whole_row(0, begins, f);
    along_whole_row(begins, inner, InnerBundles<std::remove_reference_t<F>>{f});
    along_whole_row(begins + inner, columns - begins - inner, f);
}

struct PushSeparable {
    const SeparableSheet& sheet;
    const SheetPush& push;
    StateNumbers v;
    double* out;               // where the row starts
    size_t row;                // likewise, in planes
    double inverse_mass, drag; // of the row

    PushSeparable(const Grid& grid, const SeparableSheet& sheet_, const SheetPush& push_, const StateNumbers& v_,
                  double* row_out, size_t r)
        : sheet(sheet_),
          push(push_),
          v(v_),
          out(row_out),
          row(r * grid.pitch),
          inverse_mass(sheet.inverse_mass[1][r]),
          drag(sheet.drag[1] ? push.drag + sheet.drag[1][r] : push.drag) {}

    template <int N> void bundle(size_t u) const {
        using L = Lanes<N>;
        const size_t at = row + u;
        L sum = L::splat(push.gravity);
        if (push.forces || push.pressed) {
            L force{};
            if (push.forces) force = load_lanes<N>(push.forces, at);
            if (push.pressed) force = force + L::load(push.pressed + at);
            sum = sum + (push.force * inverse_mass) * (L::load(sheet.inverse_mass[0] + u) * force);
        }
        L rate = L::splat(drag);
        if (sheet.drag[0]) rate = rate + L::load(sheet.drag[0] + u);
        (sum - rate * load_lanes<N>(v, at)).store(out + u);
    }
};

template <class S> struct Look {
    bool fetches;
    double closing_rate, share;
    const S *x, *v;
    double* to;

    template <int N> void bundle(size_t u) const {
        using L = Lanes<N>;
        if (N > 1 && fetches) {
            __builtin_prefetch(x + u + kAhead / sizeof(S));
            __builtin_prefetch(v + u + kAhead / sizeof(S));
        }
        (closing_rate * L::load(x + u) + share * L::load(v + u)).store(to + u);
    }
};

// The rows of a stage in a sweep down the sheet. Of what springs look at the last three rows are held, and beside them
// the two beyond the sweep's part, which may be another thread's; then a row of pushes.
struct StageRows {
    const Grid& grid;
    const UniformStage& stage;
    StateNumbers x, v;
    double* looked; // kLookedRows rows
    size_t first, end;
    bool fetches = leaves_cache(grid);

    double* slot(size_t k) const { return looked + k * grid.pitch; }
    double* pushes() const { return slot(5); }
    double* at(size_t row) const { return slot(row % 3); }

    void look(size_t row, double* to) const {
        x.stored([&](auto* position) {
            using S = std::remove_pointer_t<decltype(position)>;
            const size_t start = row * grid.pitch;
            const Look<S> bundles{
                fetches, stage.closing_rate, stage.share, position + start, static_cast<const S*>(v.data) + start, to};
            along_whole_row(0, grid.columns, bundles);
        });
        if (!stage.ring_u) return;
        to[-1] = to[grid.columns - 1];
        to[grid.columns] = to[0];
    }
    void look_beyond() const {
        look(grid.above(first), slot(3));
        look(grid.below(end - 1), slot(4));
    }
    // What acts at a row, once the row after it is looked at; out: see Separable.
    Separable acting(size_t row, double* out) const {
        if (!stage.constant)
            along_whole_row(0, grid.columns, PushSeparable(grid, stage.sheet, stage.push, v, out, row));
        const Rows rows{at(row), row > first ? at(row - 1) : slot(3), row + 1 < end ? at(row + 1) : slot(4)};
        return {grid, stage.sheet, stage.constant, stage.push.gravity, out, rows, row};
    }
};

} // namespace

} // namespace CD_ISA
} // namespace cd
