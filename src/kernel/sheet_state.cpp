#include "kernel/line_lanes.hh"
#include "kernel/sheet_rows.hh"

namespace cd {
namespace CD_ISA {

namespace {

template <class S> struct Gather {
    const SheetGather& how;
    const S *x, *v;
    size_t row; // where it starts

    template <int N> void bundle(size_t u) const {
        using L = Lanes<N>;
        const size_t at = row + u;
        const L here = L::load(v + at);
        L moving = how.free_share * here;
        if (how.mass) moving = select(L::load(how.mass + at), moving, how.held_share * here);
        (how.closing_rate * L::load(x + at) + moving).store(how.x_scaled + at);
        if (how.v_free) select(L::load(how.mass + at), here, L{}).store(how.v_free + at);
    }
};

template <class S, class T> struct PushGeneral {
    const GeneralSheet& sheet;
    const SheetPush<T>& push;
    const S *x, *v;
    double* out;
    size_t row;

    template <int N> void bundle(size_t u) const {
        using L = Lanes<N>;
        const size_t at = row + u;
        const L mass = L::load(sheet.mass + at);
        L sum = push.gravity * mass;
        if (push.forces) sum = sum + push.force * L::load(push.forces + at);
        if (push.pressed) sum = sum + push.force * L::load(push.pressed + at);
        if (push.target) sum = sum + L::load(push.tie + at) * (L::load(push.target + at) - L::load(x + at));
        const L inertia = push.whole ? mass : mass - L::load(sheet.ground + at);
        (sum + inertia * L::load(v + at)).store(out + at);
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

template <class S, class T> struct Mover {
    const SheetMove& move;
    const S *x, *v;
    T *to_x, *to_v;
    size_t row;
    Probe probe{};

    template <int N> void bundle(size_t u) {
        using L = Lanes<N>;
        const size_t at = row + u;
        const L from = L::load(v + at);
        L change = move.factor[0] * L::load(move.change[0] + at);
        for (int k = 1; k < move.changes; ++k) change = change + move.factor[k] * L::load(move.change[k] + at);
        const L new_v = from + move.overshoot * change,
                new_x = L::load(x + at) + move.move * (from + move.follow * change);
        store_settled(new_v, to_v + at, probe.of<N>());
        store_settled(new_x, to_x + at, probe.of<N>());
    }
};

} // namespace

template <class S>
void gather(const Grid& grid, const SheetGather& how, const S* x, const S* v, size_t first, size_t count) {
    for (size_t r = first; r < first + count; ++r) {
        Gather<S> bundles{how, x, v, r * grid.pitch};
        along_row(0, grid.columns, bundles);
    }
}

template <class S, class T> void push_separable(const Grid& grid, const SeparableSheet& sheet, const SheetPush<T>& push,
                                                const S* v, double* out, size_t first, size_t count) {
    for (size_t r = first; r < first + count; ++r) {
        const double drag = sheet.drag[1] ? push.drag + sheet.drag[1][r] : push.drag;
        PushSeparable<S, T> bundles{sheet, push, v, out + r * grid.pitch, r * grid.pitch, sheet.inverse_mass[1][r],
                                    drag};
        along_row(0, grid.columns, bundles);
    }
}

template <class S, class T> void push_general(const Grid& grid, const GeneralSheet& sheet, const SheetPush<T>& push,
                                              const S* x, const S* v, double* out, size_t first, size_t count) {
    for (size_t r = first; r < first + count; ++r) {
        PushGeneral<S, T> bundles{sheet, push, x, v, out, r * grid.pitch};
        along_row(0, grid.columns, bundles);
    }
}

template <class S, class T> bool move_nodes(const Grid& grid, const SheetMove& move, const S* x, const S* v, T* to_x,
                                            T* to_v, size_t first, size_t count) {
    bool finite = true;
    for (size_t r = first; r < first + count; ++r) {
        Mover<S, T> bundles{move, x, v, to_x, to_v, r * grid.pitch};
        along_row(0, grid.columns, bundles);
        finite &= bundles.probe.finite();
    }
    return finite;
}

#define CD_STARTS_AT(S) template void gather(const Grid&, const SheetGather&, const S*, const S*, size_t, size_t);
#define CD_STATE(S, T)                                                                                               \
    template void push_separable(const Grid&, const SeparableSheet&, const SheetPush<T>&, const S*, double*, size_t, \
                                 size_t);                                                                            \
    template void push_general(const Grid&, const GeneralSheet&, const SheetPush<T>&, const S*, const S*, double*,   \
                               size_t, size_t);                                                                      \
    template bool move_nodes(const Grid&, const SheetMove&, const S*, const S*, T*, T*, size_t, size_t);
CD_STARTS_AT(double)
#if CD_WITH_FLOAT32
CD_STARTS_AT(float)
CD_STATE(float, float)
CD_STATE(double, float)
template bool move_nodes(const Grid&, const SheetMove&, const float*, const float*, double*, double*, size_t, size_t);
#endif
#if CD_WITH_FLOAT64
CD_STATE(double, double)
#elif CD_WITH_FLOAT32
template bool move_nodes(const Grid&, const SheetMove&, const double*, const double*, double*, double*, size_t, size_t);
#endif

} // namespace CD_ISA
} // namespace cd
