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
    rows([&](size_t first, size_t count) { kernels->combine(grid, alpha, a, beta, b, first, count); });
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
        for (int k = j; k < n; ++k) g[j][k] = *next++;
    for (int k = 0; k < n; ++k) c[k] = *next++;

    // Cholesky's elimination, by rows of the upper half. What is left of a plane's energy once the others' share is
    // taken away tells whether it adds anything.
    constexpr double kNothing = 1e-12;
    bool adds[kMostDirections];
    for (int a = 0; a < n; ++a) {
        double whole = g[a][a] + taken[a];
        for (int k = 0; k < a; ++k) whole += adds[k] ? g[k][a] * g[k][a] / g[k][k] : 0;
        adds[a] = g[a][a] > kNothing * whole;
        if (!adds[a]) continue;
        for (int b = a + 1; b < n; ++b) {
            const double share = g[a][b] / g[a][a];
            for (int d = b; d < n; ++d) g[b][d] -= share * g[a][d];
            c[b] -= share * c[a];
        }
    }
    for (int a = n; a-- > 0;) {
        factors[a] = 0;
        if (!adds[a]) continue;
        double sum = c[a];
        for (int b = a + 1; b < n; ++b) sum -= g[a][b] * factors[b];
        factors[a] = sum / g[a][a];
    }
}

} // namespace cd
