#include "kernel/row_sum.hh"
#include "kernel/sheet.hh"
#include "kernel/tiles.hh"

namespace cd {
namespace CD_ISA {

namespace {

struct Combine {
    double alpha, beta;
    const double *a, *b;
    double* out;

    template <int N> void bundle(size_t u) const {
        using L = Lanes<N>;
        (alpha * L::load(a + u) + beta * L::load(b + u)).store(out + u);
    }
};

struct Multiply {
    const double *a, *b;
    double* out;

    template <int N> void bundle(size_t u) const {
        using L = Lanes<N>;
        (L::load(a + u) * L::load(b + u)).store(out + u);
    }
};

struct Product {
    const double *a, *b;

    template <int N> Lanes<N> operator()(size_t u) const { return Lanes<N>::load(a + u) * Lanes<N>::load(b + u); }
};

} // namespace

void transpose(const Grid& grid, const double* from, double* to, size_t to_pitch, size_t first, size_t count) {
    constexpr size_t kBlock = 8; // a cache line of each row
    for (size_t r = first; r < first + count; r += kBlock) {
        const size_t rows = first + count - r < kBlock ? first + count - r : kBlock;
        turn(rows, grid.columns, from + r * grid.pitch, grid.pitch, to + r, to_pitch);
    }
}

void combine(const Grid& grid, double alpha, const double* a, double beta, const double* b, double* out, size_t first,
             size_t count) {
    for (size_t r = first; r < first + count; ++r) {
        Combine bundles{alpha, beta, a + r * grid.pitch, b + r * grid.pitch, out + r * grid.pitch};
        along_row(0, grid.columns, bundles);
    }
}

void multiply(const Grid& grid, const double* a, const double* b, double* out, size_t first, size_t count) {
    for (size_t r = first; r < first + count; ++r) {
        Multiply bundles{a + r * grid.pitch, b + r * grid.pitch, out + r * grid.pitch};
        along_row(0, grid.columns, bundles);
    }
}

void wrap(const Grid& grid, double* a, size_t first, size_t count) {
    const size_t n = grid.columns;
    for (size_t r = first; r < first + count; ++r) {
        double* const row = a + r * grid.pitch;
        for (size_t k = 0; k < 2; ++k) {
            row[n + k] = row[k % n];
            row[ptrdiff_t(k) - 2] = row[(n - 2 + k + n) % n];
        }
    }
}

void dot(const Grid& grid, const double* a, const double* b, double* sums, size_t first, size_t count) {
    for (size_t r = first; r < first + count; ++r)
        sums[r] = row_sum(grid.columns, Product{a + r * grid.pitch, b + r * grid.pitch});
}

void aggregate(const Grid& coarse, const Grid& fine, const double* from, const double* minus, double* to, size_t first,
               size_t count) {
    const size_t across = fine.columns == coarse.columns ? 1 : 2, down = fine.rows == coarse.rows ? 1 : 2;
    for (size_t r = first; r < first + count; ++r) {
        double* const sums = to + r * coarse.pitch;
        for (size_t u = 0; u < coarse.columns; ++u) sums[u] = 0;
        for (size_t v = r * down; v < (r + 1) * down && v < fine.rows; ++v) {
            const double *const a = from + v * fine.pitch, *const b = minus + v * fine.pitch;
            const size_t pairs = across == 2 ? fine.columns / 2 : 0;
            for (size_t u = 0; u < pairs; ++u) sums[u] += (a[2 * u] - b[2 * u]) + (a[2 * u + 1] - b[2 * u + 1]);
            for (size_t u = pairs * across; u < fine.columns; ++u) sums[u / across] += a[u] - b[u];
        }
    }
}

void spread(const Grid& coarse, const Grid& fine, const double* from, const double* gain, double* to, size_t first,
            size_t count) {
    const size_t across = fine.columns == coarse.columns ? 1 : 2, down = fine.rows == coarse.rows ? 1 : 2;
    for (size_t r = first * down; r < (first + count) * down && r < fine.rows; ++r) {
        const double *const add = from + (r / down) * coarse.pitch, *const moves = gain + r * fine.pitch;
        double* const sums = to + r * fine.pitch;
        const size_t pairs = across == 2 ? fine.columns / 2 : 0;
        for (size_t u = 0; u < pairs; ++u) {
            sums[2 * u] += moves[2 * u] > 0 ? add[u] : 0;
            sums[2 * u + 1] += moves[2 * u + 1] > 0 ? add[u] : 0;
        }
        for (size_t u = pairs * across; u < fine.columns; ++u) sums[u] += moves[u] > 0 ? add[u / across] : 0;
    }
}

} // namespace CD_ISA
} // namespace cd
