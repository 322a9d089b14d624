// An explicit step of a uniform sheet in one pass over memory.
#include "kernel/sheet_rows.hh"

namespace cd {
namespace CD_ISA {

namespace {

// Pointers to where a row starts.
template <class T> struct ExplicitMove {
    Separable acting;
    T *x, *v;
    double move, follow;
    Probe probe{};

    template <int N> void bundle(size_t u) {
        using L = Lanes<N>;
        const L from = L::load(v + u), change = acting.acts<N>(u);
        store_settled(from + change, v + u, probe.of<N>());
        store_settled(L::load(x + u) + move * (from + follow * change), x + u, probe.of<N>());
    }
};

} // namespace

template <class T> void look_beyond(const Grid& grid, const UniformStage<T>& stage, const T* x, const T* v,
                                    double* looked, size_t first, size_t count) {
    StageRows<T, T>{grid, stage, x, v, looked, first, first + count}.look_beyond();
}

template <class T> bool step_rows(const Grid& grid, const UniformStage<T>& stage, const SheetMove& move, T* x, T* v,
                                  double* looked, size_t first, size_t count) {
    const StageRows<T, T> rows{grid, stage, x, v, looked, first, first + count};
    bool finite = true;
    rows.look(first, rows.at(first));
    for (size_t r = first; r < rows.end; ++r) {
        if (r + 1 < rows.end) rows.look(r + 1, rows.at(r + 1));
        const size_t row = r * grid.pitch;
        ExplicitMove<T> step{rows.acting(r, rows.pushes()), x + row, v + row, move.move, move.follow};
        along_row(0, grid.columns, step);
        finite &= step.probe.finite();
    }
    return finite;
}

#define CD_EXPLICIT(T)                                                                                           \
    template void look_beyond(const Grid&, const UniformStage<T>&, const T*, const T*, double*, size_t, size_t); \
    template bool step_rows(const Grid&, const UniformStage<T>&, const SheetMove&, T*, T*, double*, size_t, size_t);
#if CD_WITH_FLOAT32
CD_EXPLICIT(float)
#endif
#if CD_WITH_FLOAT64
CD_EXPLICIT(double)
#endif

} // namespace CD_ISA
} // namespace cd
