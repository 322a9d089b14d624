#include "solve/sheet_system.hh"

#include <string.h>

namespace cd {

void SheetSystem::wrap(double* plane) const {
    if (!ring[0]) return;
    rows([&](size_t first, size_t count) { kernels->wrap(grid, plane, first, count); });
}

void SheetSystem::bend(const double* plane) const {
    if (!sheet.bends()) return;
    rows([&](size_t first, size_t count) { kernels->moments(grid, sheet, plane, first, count); });
    for (double* moment : sheet.moment) wrap(moment);
}

void SheetSystem::pull(double* x, double* r) const {
    wrap(x);
    bend(x);
    rows([&](size_t first, size_t count) { kernels->pull_general(grid, sheet, x, r, first, count); });
}

static double total(const double* sums, size_t rows) {
    double sum = 0;
    for (size_t r = 0; r < rows; ++r) sum += sums[r];
    return sum;
}

double SheetSystem::apply(double* z, double* out) const {
    wrap(z);
    bend(z);
    rows([&](size_t first, size_t count) { kernels->apply(grid, sheet, z, out, sums, first, count); });
    return total(sums, grid.rows);
}

double SheetSystem::dot(const double* a, const double* b) const {
    rows([&](size_t first, size_t count) { kernels->dot(grid, a, b, sums, first, count); });
    return total(sums, grid.rows);
}

void SheetSystem::clear(double* plane) const {
    rows([&](size_t first, size_t count) {
        memset(plane + first * grid.pitch, 0, count * grid.pitch * sizeof(double));
    });
}

void SheetSystem::copy(const double* from, double* to) const {
    rows([&](size_t first, size_t count) {
        memcpy(to + first * grid.pitch, from + first * grid.pitch, count * grid.pitch * sizeof(double));
    });
}

void SheetSystem::combine(double alpha, double* a, double beta, const double* b) const {
    rows([&](size_t first, size_t count) { kernels->combine(grid, alpha, a, beta, b, a, first, count); });
}

void SheetSystem::multiply(const double* a, const double* b, double* out) const {
    rows([&](size_t first, size_t count) { kernels->multiply(grid, a, b, out, first, count); });
}

void SheetSystem::turn(const double* from, double* to) const {
    rows([&](size_t first, size_t count) { kernels->transpose(grid, from, to, turned.pitch, first, count); });
}

void SheetSystem::turn_back(const double* from, double* to) const {
    columns([&](size_t first, size_t count) { kernels->transpose(turned, from, to, grid.pitch, first, count); });
}

void SheetSystem::project(double* const* planes, int n, const double* b, const double* taken, double* factors) const {
    for (int k = 0; k < n; ++k) wrap(planes[k]);
    rows([&](size_t first, size_t count) { kernels->energies(grid, sheet, planes, n, b, sums, first, count); });
    double all[kEnergies] = {}, g[kMostDirections][kMostDirections] = {}, c[kMostDirections];
    for (size_t r = 0; r < grid.rows; ++r)
        for (int i = 0; i < energies_of(n); ++i) all[i] += sums[r * kEnergies + size_t(i)];
    const double* next = all;
    for (int j = 0; j < n; ++j)
        for (int k = j; k < n; ++k) g[j][k] = g[k][j] = *next++;
    for (int k = 0; k < n; ++k) c[k] = *next++;

    // Cholesky's elimination. The plane that has most left of its energy, once the others' shares are taken away, comes
    // next: planes that hardly differ would otherwise leave their rounding in those that come later.
    constexpr double kNothing = 1e-12;
    double whole[kMostDirections];
    int order[kMostDirections], count = 0;
    bool done[kMostDirections] = {};
    for (int k = 0; k < n; ++k) whole[k] = g[k][k] + taken[k], factors[k] = 0;
    for (; count < n; ++count) {
        int a = -1;
        double most = kNothing;
        for (int k = 0; k < n; ++k)
            if (!done[k] && g[k][k] > most * whole[k]) a = k, most = g[k][k] / whole[k];
        if (a < 0) break;
        order[count] = a;
        done[a] = true;
        for (int b = 0; b < n; ++b) {
            if (done[b]) continue;
            const double share = g[a][b] / g[a][a];
            for (int d = 0; d < n; ++d)
                if (!done[d]) g[b][d] -= share * g[a][d];
            c[b] -= share * c[a];
        }
    }
    while (count-- > 0) {
        const int a = order[count];
        double sum = c[a];
        for (int k = 0; k < n; ++k)
            if (k != a) sum -= g[a][k] * factors[k];
        factors[a] = sum / g[a][a];
    }
}

} // namespace cd
