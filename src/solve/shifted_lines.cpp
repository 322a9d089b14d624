#include "solve/shifted_lines.hh"

#include <initializer_list>

namespace cd {

void ShiftedLines::carve(const Grid& grid, const HeldNodes* held_nodes, Carver& coefficients, Carver& scratch) {
    held = held_nodes;
    for (double*& plane : response) plane = held ? coefficients.plane(grid) : nullptr;
    const size_t nodes[2] = {grid.columns, grid.rows};
    for (int d = 0; d < 2; ++d) {
        stride[d] = (nodes[d] + 7) / 8 * 8;
        size_t all = 0;
        coefficients.fits = coefficients.fits && multiply(stride[d], kMostShifts, all);
        gain[d] = coefficients.numbers(all);
        carry[d] = coefficients.numbers(all);
        pull[d] = coefficients.numbers(all);
    }
    shift = coefficients.numbers(kMostShifts + 1);
    z = scratch.plane(grid);
    t = scratch.filtered_plane(grid);
    below = scratch.numbers(grid.columns);
}

void ShiftedLines::choose(double least, double greatest) {
    constexpr double kEnd = 1.08; // so far the outer ones lie inside, for the ends and what lies next to them alike
    for (const double step : {2.0, 4.0}) {
        size_t k = 0;
        double p = least * kEnd;
        for (; k < kMostShifts; p *= step) {
            shift[k++] = p;
            shift[k] = 0;
            if (p * kEnd >= greatest) return;
        }
    }
    shift[0] = 0;
}

void ShiftedLines::hold(const SheetSystem& system, const Parts& bands, const Parts& strips, double* r,
                        double* x) const {
    if (!held || held->count == 0) return;
    double moves[HeldNodes::kMost][HeldNodes::kMost];
    system.clear(r);
    for (size_t b = 0; b < held->count; ++b) {
        double* const to = keeps_responses() ? response[b] : x;
        r[held->place[b]] = 1;
        shift_all(system, bands, strips, r, to);
        r[held->place[b]] = 0;
        for (size_t a = 0; a < held->count; ++a) moves[a][b] = to[held->place[a]];
    }
    held->factor([&](size_t a, size_t b) { return moves[a][b]; });
}

void ShiftedLines::cycle(const SheetSystem& system, const Parts& bands, const Parts& strips, double* r,
                         double* x) const {
    if (!held || held->count == 0) return shift_all(system, bands, strips, r, x);
    double impulse[HeldNodes::kMost], own[HeldNodes::kMost]; // own: what acts there, 0 at held nodes
    const auto put = [&](const double* numbers) {
        for (size_t a = 0; a < held->count; ++a) r[held->place[a]] = numbers ? numbers[a] : 0;
    };
    for (size_t a = 0; a < held->count; ++a) own[a] = r[held->place[a]];
    put(nullptr);
    if (!keeps_responses()) shift_all(system, bands, strips, r, x);
    for (size_t a = 0; a < held->count; ++a)
        impulse[a] =
            held->compliance[a] * own[a] - (keeps_responses() ? system.dot(response[a], r) : x[held->place[a]]);
    held->balance(impulse);
    put(impulse);
    shift_all(system, bands, strips, r, x);
    put(own);
    held->clear(x);
}

void ShiftedLines::shift_all(const SheetSystem& system, const Parts& bands, const Parts& strips, const double* r,
                             double* x) const {
    const Grid& grid = system.grid;
    for (size_t k = 0; shift[k] > 0; ++k) {
        const bool last = !(shift[k + 1] > 0);
        const auto at = [&](double* const* rows, int d) { return rows[d] + k * stride[d]; };
        const ShiftedStep step{{inverse_mass[0], inverse_mass[1]},
                               {at(gain, 0), at(gain, 1)},
                               {{at(carry, 0), at(pull, 0)}, {at(carry, 1), at(pull, 1)}},
                               2 * shift[k],
                               last ? 0 : shift[k] + shift[k + 1],
                               k == 0,
                               last,
                               !system.parallel->run};
        bands.each(*system.parallel, [&](size_t, size_t first, size_t count) {
            system.kernels->shift_down(grid, step, r, z, t, first, count);
        });
        strips.each(*system.parallel, [&](size_t, size_t first, size_t count) {
            system.kernels->shift_up(grid, step, z, t, below, x, first, count);
        });
    }
}

} // namespace cd
