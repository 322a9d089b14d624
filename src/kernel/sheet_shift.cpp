// A shifted step of alternating directions (solve/shifted_lines.hh) in two passes over memory: see sheet_sweep.cpp.
#include "kernel/sheet_filters.hh"

namespace cd {
namespace CD_ISA {

namespace {

// t = gain (r / mass - z). Pointers to where a row starts.
struct ShiftRight {
    const double *inverse_u, *gain_u;
    double inverse_v;
    bool first; // z = 0
    const double *r, *z;
    double* t;

    template <int N> void bundle(size_t u) const {
        using L = Lanes<N>;
        L sum = inverse_v * (L::load(inverse_u + u) * L::load(r + u));
        if (!first) sum = sum - L::load(z + u);
        (L::load(gain_u + u) * sum).store(t + u);
    }
};

// z += twice t, t = gain z
struct ShiftDown {
    double twice, gain;
    bool first;
    double *z, *t;

    template <int N> void bundle(size_t u) const {
        using L = Lanes<N>;
        L sum = twice * L::load(t + u);
        if (!first) sum = L::load(z + u) + sum;
        sum.store(z + u);
        (gain * sum).store(t + u);
    }
};

// The filter's way back; then z -= next x, or at the last step out = x.
struct ShiftUp {
    bool ends; // no row lies below
    double pull;
    const double* t;
    double* below;
    bool settles, last;
    double next;
    double *z, *out;

    template <int N> void bundle(size_t u) const {
        using L = Lanes<N>;
        L x = L::load(t + u);
        if (!ends) x = between(x, L::load(below + u), &pull);
        if (settles && !ends) x = settled(x, Limits<double>::least);
        x.store(below + u);
        if (last) x.store(out + u);
        else (L::load(z + u) - next * x).store(z + u);
    }
};

} // namespace

void shift_down(const Grid& grid, const ShiftedStep& step, const double* r, double* z, double* t, size_t first,
                size_t count) {
    for (size_t done = 0; done < count; done += kBlock) {
        const size_t row = first + done, rows = count - done < kBlock ? count - done : kBlock;
        for (size_t v = row; v < row + rows; ++v) {
            const size_t at = v * grid.pitch;
            along_row(0, grid.columns,
                      ShiftRight{step.inverse_mass[0], step.gain[0], step.inverse_mass[1][v], step.first, r + at,
                                 z + at, t + at});
            for (size_t u = grid.columns; u % size_t(kNative) != 0; ++u) t[at + u] = 0;
        }
        filter_rows(grid, step.along[0], t, row, rows);
        for (size_t v = row; v < row + rows; ++v) {
            const size_t at = v * grid.pitch;
            along_row(0, grid.columns, ShiftDown{step.twice, step.gain[1][v], step.first, z + at, t + at});
            if (step.carries && v > 0) along_row(0, grid.columns, CarryDown(grid, step.along[1], t, v));
        }
    }
}

void shift_up(const Grid& grid, const ShiftedStep& step, double* z, double* t, double* below, double* x, size_t first,
              size_t count) {
    const SharedFilter& filter = step.along[1];
    for (size_t r = 1; r < grid.rows && !step.carries; ++r) along_row(first, count, CarryDown(grid, filter, t, r));
    for (size_t r = grid.rows; r-- > 0;) {
        const size_t at = r * grid.pitch;
        along_row(first, count,
                  ShiftUp{r + 1 == grid.rows, filter.pull[r], t + at, below, r % kSettleEvery == 0, step.last,
                          step.next, z + at, x + at});
    }
}

} // namespace CD_ISA
} // namespace cd
