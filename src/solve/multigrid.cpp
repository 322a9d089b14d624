#include "solve/multigrid.hh"

#include <string.h>

namespace cd {

namespace {

constexpr double kBlockiness = 1.8;

size_t halved(size_t n) { return (n + 1) / 2; }

// Of a level: what every line solver of it needs to know, in its own layout or turned.
void factor_level(MultigridLevel& at) {
    const Grid &grid = at.system.grid, &turned = at.system.turned;
    const GeneralSheet& sheet = at.system.sheet;
    const auto spring = [&](int d, size_t v, size_t u) { return sheet.spring[d][v * grid.pitch + u]; };
    // What grounds a node for a line along `other`'s opposite: its own ground and the springs across.
    const auto ground = [&](int across, size_t v, size_t u) {
        const double own = sheet.ground[v * grid.pitch + u];
        if (!(own > 0)) return 0.0;
        const size_t n = grid.columns;
        return across == 0 ? own + spring(0, v, u) + spring(0, v, (u > 0 ? u : n) - 1)
                           : own + spring(1, v, u) + spring(1, grid.above(v), u);
    };
    factor_lines(
        grid, [&](size_t v, size_t u) { return ground(0, v, u); }, [&](size_t v, size_t u) { return spring(1, v, u); },
        at.along[1]);
    factor_lines(
        turned, [&](size_t u, size_t v) { return ground(1, v, u); },
        [&](size_t u, size_t v) { return spring(0, v, u); }, at.along[0]);
    at.system.turn(sheet.spring[1], at.turned_spring);
    if (at.system.ring[1]) { // a turned row's beyond
        const size_t n = turned.columns;
        for (size_t u = 0; u < turned.rows; ++u) {
            double* const row = at.turned_spring + u * turned.pitch;
            row[-1] = row[n - 1];
        }
    }
}

// The level below: its ground, its springs, and how much of its ground comes from held nodes (in `pins`, both planes of
// `fine.residual` and `coarse.residual`).
void coarsen(const MultigridLevel& fine, bool first, MultigridLevel& coarse) {
    const Grid &f = fine.system.grid, &c = coarse.system.grid;
    const GeneralSheet& sheet = fine.system.sheet;
    const size_t across = f.columns == c.columns ? 1 : 2, down = f.rows == c.rows ? 1 : 2;
    const auto moves = [&](size_t v, size_t u) { return sheet.ground[v * f.pitch + u] > 0; };
    for (size_t i = 0; i < c.rows; ++i)
        for (size_t j = 0; j < c.columns; ++j) {
            const size_t to = i * c.pitch + j;
            double ground = 0, pins = 0, spring[2] = {};
            for (size_t v = i * down; v < (i + 1) * down && v < f.rows; ++v)
                for (size_t u = j * across; u < (j + 1) * across && u < f.columns; ++u) {
                    const size_t at = v * f.pitch + u, right = u + 1 < f.columns ? u + 1 : 0, below = f.below(v);
                    const size_t left = (u > 0 ? u : f.columns) - 1, above = f.above(v);
                    const double s_u = sheet.spring[0][at], s_v = sheet.spring[1][at];
                    if (!moves(v, u)) continue;
                    double own_pins = first ? 0 : fine.residual[at];
                    if (first) {
                        if (!moves(v, right)) own_pins += s_u;
                        if (!moves(v, left)) own_pins += sheet.spring[0][v * f.pitch + left];
                        if (!moves(below, u)) own_pins += s_v;
                        if (!moves(above, u)) own_pins += sheet.spring[1][above * f.pitch + u];
                        ground += sheet.ground[at];
                    } else {
                        ground += sheet.ground[at] - own_pins;
                    }
                    pins += own_pins / kBlockiness;
                    if (right / across != j && moves(v, right)) spring[0] += s_u / kBlockiness;
                    if (below / down != i && moves(below, u)) spring[1] += s_v / kBlockiness;
                }
            coarse.ground[to] = ground + pins;
            coarse.residual[to] = pins;
            coarse.spring[0][to] = spring[0];
            coarse.spring[1][to] = spring[1];
        }
    coarse.system.wrap(coarse.spring[0]);
}

void smooth(const SheetSystem& system, const Grid& lattice, bool ring_across, const LineFactors& factors,
            const double* cross, const double* b, int colour, double* x) {
    const auto lines = [&](const auto& body) { in_parts(*system.parallel, lattice.columns, lattice.rows, body); };
    lines([&](size_t first, size_t count) {
        system.kernels->smooth_lines(lattice, factors, cross, b, colour, x, first, count);
    });
    if (ring_across) system.kernels->wrap(lattice, x, 0, lattice.rows);
}

void smooth_u(const MultigridLevel& at, int colour) {
    smooth(at.system, at.system.turned, at.system.ring[1], at.along[0].factors(), at.turned_spring, at.turned_b, colour,
           at.turned_x);
}
void smooth_v(const MultigridLevel& at, const double* b, int colour, double* x) {
    smooth(at.system, at.system.grid, at.system.ring[0], at.along[1].factors(), at.system.sheet.spring[0], b, colour,
           x);
}

} // namespace

void Multigrid::carve(const SheetSystem& system, bool own, Carver& coefficients, Carver& scratch) {
    size_t columns = system.grid.columns, rows = system.grid.rows;
    levels = 1;
    for (size_t n = columns > rows ? columns : rows; n > 1; n = halved(n)) ++levels;
    static_assert(alignof(MultigridLevel) <= alignof(double), "levels lie among numbers");
    const size_t bytes = levels * sizeof(MultigridLevel);
    level = reinterpret_cast<MultigridLevel*>(coefficients.numbers((bytes + sizeof(double) - 1) / sizeof(double)));
    MultigridLevel counted; // stands for all of them while memory is only counted
    for (size_t l = 0; l < levels; ++l, columns = halved(columns), rows = halved(rows)) {
        MultigridLevel& at = level ? level[l] : counted;
        at = {};
        at.system = system;
        SheetSystem& here = at.system;
        if (l > 0) {
            here.ring[0] = system.ring[0] && columns > 1;
            here.ring[1] = system.ring[1] && rows > 1;
            grid_of(columns, rows, here.grid);
            grid_of(rows, columns, here.turned);
        }
        GeneralSheet& sheet = here.sheet;
        sheet = {};
        if (l > 0 || own) {
            at.x = scratch.plane(here.grid);
            at.b = scratch.plane(here.grid);
            sheet.ground = at.ground = coefficients.plane(here.grid);
            for (int d = 0; d < 2; ++d) sheet.spring[d] = at.spring[d] = coefficients.plane(here.grid);
        } else {
            sheet.ground = system.sheet.ground;
            for (int d = 0; d < 2; ++d) sheet.spring[d] = system.sheet.spring[d];
        }
        sheet.mass = sheet.ground;
        at.along[0] = LineRows(coefficients, here.turned, here.ring[0]);
        at.along[1] = LineRows(coefficients, here.grid, here.ring[1]);
        at.turned_spring = coefficients.plane(here.turned);
        at.residual = scratch.plane(here.grid);
        at.turned_x = scratch.plane(here.turned);
        at.turned_b = scratch.plane(here.turned);
    }
}

void Multigrid::build() {
    for (size_t l = 0; l < levels; ++l) {
        if (l > 0) coarsen(level[l - 1], l == 1, level[l]);
        factor_level(level[l]);
    }
}

void Multigrid::descend(size_t l, const double* b, double* x) const {
    const MultigridLevel& at = level[l];
    const SheetSystem& system = at.system;
    system.turn(b, at.turned_b);
    const Grid& turned = system.turned;
    const auto wrap_turned = [&] {
        if (system.ring[1]) system.kernels->wrap(turned, at.turned_x, 0, turned.rows);
    };
    memset(at.turned_x, 0, turned.rows * turned.pitch * sizeof(double));
    wrap_turned();
    smooth_u(at, 0);
    smooth_u(at, 1);
    system.turn_back(at.turned_x, x);
    system.wrap(x);
    smooth_v(at, b, 0, x);
    smooth_v(at, b, 1, x);
    if (l + 1 < levels) {
        const MultigridLevel& below = level[l + 1];
        const Grid &fine = system.grid, &coarse = below.system.grid;
        system.apply(x, at.residual);
        below.system.rows([&](size_t first, size_t count) {
            system.kernels->aggregate(coarse, fine, b, at.residual, below.b, first, count);
        });
        descend(l + 1, below.b, below.x);
        below.system.rows([&](size_t first, size_t count) {
            system.kernels->spread(coarse, fine, below.x, system.sheet.mass, x, first, count);
        });
        system.wrap(x);
    }
    smooth_v(at, b, 1, x);
    smooth_v(at, b, 0, x);
    system.turn(x, at.turned_x);
    wrap_turned();
    smooth_u(at, 1);
    smooth_u(at, 0);
    system.turn_back(at.turned_x, x);
}

} // namespace cd
