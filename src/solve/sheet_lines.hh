// Factors the lines of a sheet one by one, each with its own masses and springs, by series-spring elimination
// (spring_line.hh), for solvers that need the answer of a line and not its last digits.
#pragma once

#include "kernel/sheet.hh"
#include "solve/planes.hh"
#include "solve/series.hh"

namespace cd {

struct LineRows {
    double *pull = nullptr, *gain = nullptr, *around = nullptr, *closing = nullptr; // the last two only of rings

    LineRows() = default;
    LineRows(Carver& carve, const Grid& grid, bool ring)
        : pull(carve.plane(grid)),
          gain(carve.plane(grid)),
          around(ring ? carve.plane(grid) : nullptr),
          closing(ring ? carve.numbers(grid.columns) : nullptr) {}
    LineFactors factors() const { return {pull, gain, around, closing}; }
};

// Lines run down the columns of `grid`. ground(row, column): what grounds a node, 0 where it does not move;
// spring(row, column): the spring from there to the next row, of the last row the ring's.
template <class Ground, class Spring>
void factor_lines(const Grid& grid, Ground ground, Spring spring, const LineRows& out) {
    for (size_t u = 0; u < grid.columns; ++u) {
        const auto at = [&](size_t r) { return r * grid.pitch + u; };
        double hanging = 0;
        for (size_t r = 0; r < grid.rows; ++r) {
            const double own = ground(r, u), s = r + 1 < grid.rows ? spring(r, u) : 0;
            const bool moves = own > 0;
            const double grounded = own + hanging;
            out.pull[at(r)] = moves ? share(s, grounded) : 0;
            out.gain[at(r)] = moves ? 1 / (grounded + s) : 0;
            hanging = moves ? series(grounded, s) : s;
        }
        if (!out.around) continue;
        // The response to the closing spring's unit pull, from the last node to the first, and the strength with which
        // it then pulls: s / (1 + s stretch).
        const double s = grid.rows > 1 ? spring(grid.rows - 1, u) : 0;
        double sum = 0, answer = 0;
        for (size_t r = 0; r < grid.rows; ++r) {
            const double load = r == 0 ? -1 : r + 1 == grid.rows ? 1 : 0;
            sum = (out.gain[at(r)] > 0 ? load : 0) + (r > 0 ? out.pull[at(r - 1)] : 0) * sum;
            out.around[at(r)] = sum;
        }
        for (size_t r = grid.rows; r-- > 0;) {
            answer = out.gain[at(r)] * out.around[at(r)] + out.pull[at(r)] * answer;
            out.around[at(r)] = answer;
        }
        const double stretch = out.around[at(grid.rows - 1)] - out.around[at(0)];
        out.closing[u] = s > 0 && stretch > 0 ? 1 / (1 / s + stretch) : 0;
    }
}

} // namespace cd
