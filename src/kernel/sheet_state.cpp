#include "kernel/line_lanes.hh"
#include "kernel/sheet_rows.hh"

namespace cd {
namespace CD_ISA {

namespace {

struct Gather {
    const SheetGather& how;
    StateNumbers x, v;
    size_t row; // where it starts

    template <int N> void bundle(size_t u) const {
        using L = Lanes<N>;
        const size_t at = row + u;
        const L here = load_lanes<N>(v, at);
        L moving = how.free_share * here;
        if (how.mass) moving = select(L::load(how.mass + at), moving, how.held_share * here);
        (how.closing_rate * load_lanes<N>(x, at) + moving).store(how.x_scaled + at);
        if (how.v_free) select(L::load(how.mass + at), here, L{}).store(how.v_free + at);
    }
};

struct PushGeneral {
    const GeneralSheet& sheet;
    const SheetPush& push;
    StateNumbers x, v;
    double* out;
    size_t row;

    template <int N> void bundle(size_t u) const {
        using L = Lanes<N>;
        const size_t at = row + u;
        const L mass = L::load(sheet.mass + at);
        L sum = push.gravity * mass;
        if (push.forces) sum = sum + push.force * load_lanes<N>(push.forces, at);
        if (push.pressed) sum = sum + push.force * L::load(push.pressed + at);
        if (push.target) sum = sum + L::load(push.tie + at) * (load_lanes<N>(push.target, at) - load_lanes<N>(x, at));
        const L inertia = push.whole ? mass : mass - L::load(sheet.ground + at);
        (sum + inertia * load_lanes<N>(v, at)).store(out + at);
    }
};

// What along_row's bundles add to, so that only the end of a row is asked whether a number was too large.
struct Probe {
    Lanes<kWidest> wide{};
    Lanes<1> single{};

    template <int N> Lanes<N>& of() {
        if constexpr (N == 1) return single;
        else return wide;
    }
    bool finite() const { return !wide.any_nan() && !single.any_nan(); }
};

struct Mover {
    const SheetMove& move;
    StateNumbers x, v, to_x, to_v;
    size_t row;
    Probe probe{};

    template <int N> void bundle(size_t u) {
        using L = Lanes<N>;
        const size_t at = row + u;
        const L from = load_lanes<N>(v, at);
        L change = move.factor[0] * L::load(move.change[0] + at);
        for (int k = 1; k < move.changes; ++k) change = change + move.factor[k] * L::load(move.change[k] + at);
        const L new_v = from + move.overshoot * change,
                new_x = load_lanes<N>(x, at) + move.move * (from + move.follow * change);
        store_settled(new_v, to_v, at, probe.of<N>());
        store_settled(new_x, to_x, at, probe.of<N>());
    }
};

} // namespace

void gather(const Grid& grid, const SheetGather& how, const StateNumbers& x, const StateNumbers& v, size_t first,
            size_t count) {
    for (size_t r = first; r < first + count; ++r) along_row(0, grid.columns, Gather{how, x, v, r * grid.pitch});
}

void push_separable(const Grid& grid, const SeparableSheet& sheet, const SheetPush& push, const StateNumbers& v,
                    double* out, size_t first, size_t count) {
    for (size_t r = first; r < first + count; ++r)
        along_row(0, grid.columns, PushSeparable(grid, sheet, push, v, out + r * grid.pitch, r));
}

void push_general(const Grid& grid, const GeneralSheet& sheet, const SheetPush& push, const StateNumbers& x,
                  const StateNumbers& v, double* out, size_t first, size_t count) {
    for (size_t r = first; r < first + count; ++r)
        along_row(0, grid.columns, PushGeneral{sheet, push, x, v, out, r * grid.pitch});
}

bool move_nodes(const Grid& grid, const SheetMove& move, const StateNumbers& x, const StateNumbers& v,
                const StateNumbers& to_x, const StateNumbers& to_v, size_t first, size_t count) {
    bool finite = true;
    for (size_t r = first; r < first + count; ++r) {
        Mover bundles{move, x, v, to_x, to_v, r * grid.pitch};
        along_row(0, grid.columns, bundles);
        finite &= bundles.probe.finite();
    }
    return finite;
}

} // namespace CD_ISA
} // namespace cd
