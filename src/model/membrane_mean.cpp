// The mean motion of a stiff sheet that nothing holds.
//
// A motion of all nodes alike stretches no spring. But the forces of springs cancel only to their own rounding, which
// moved such a sheet as a whole, the stiffer the faster: with stiffness over mass of 1e16 its energy grew 1e7 times in
// a hundred steps of 1 s. So its mean motion is computed apart, from the other forces alone: in membrane_parts.cpp for
// sheets of any kind. Alternating directions on a separable sheet also mix the rows' mean motions, of which each is as
// large as the forces, into all others. There the mean is taken out of each row before and after the filters along it,
// and the rows' means move as the nodes of a line, by
//
//      (1 + A_v / M')^-1 (e + s) - s,     s = x / (h + damping) + v,     e: what acts but springs
//
// in which no forces cancel.
#include <math.h>

#include "model/membrane_work.hh"

namespace cd {

bool is_stiff_and_afloat(const Membrane& m, const Work& w) {
    double stiffest = 0;
    if (w.held.count > 0) return false;
    for (Direction d : {kU, kV})
        for (size_t i = 0; i < nodes_along(m, d); ++i) {
            if (w.rows[d].holds[i] || w.rows[d].drag[i] > 0) return false;
            stiffest = fmax(stiffest, w.rows[d].before[i] + w.rows[d].after[i]);
        }
    return stiffest > kStiffSheet;
}

void change_rows(const Membrane& m, const Work& w, double h, const StateNumbers& x, const StateNumbers& v,
                 const Pushed& by) {
    const size_t step = w.line_of_rows.pitch;
    x.stored([&](auto* position) {
        const auto velocity = static_cast<decltype(position)>(v.data);
        for (size_t r = 0; r < w.grid.rows; ++r) {
            double looked = 0, pushed = 0, whole = 0;
            for (size_t u = 0; u < w.grid.columns; ++u) {
                const size_t at = r * w.grid.pitch + u;
                const double weight = line_weight(m, kU, u);
                looked += weight * (double(position[at]) / (h + m.damping) + double(velocity[at]));
                pushed += weight * ((by.pushed ? by.pushed[at] : 1) * (by.gain ? by.gain[at] : 1));
                whole += weight;
            }
            w.row_change[r] = looked / whole;
            w.row_plane[r * step] = by.scale * pushed / whole + looked / whole;
        }
    });
    w.shared[kV].solve(*m.kernels, cd_parallel{}, w.line_of_rows, w.row_plane, w.slope);
    for (size_t r = 0; r < w.grid.rows; ++r) w.row_change[r] = w.row_plane[r * step] - w.row_change[r];
}

void flatten_rows(const Grid& grid, const double* inverse_mass, double* plane, size_t first, size_t count) {
    for (size_t r = first; r < first + count; ++r) {
        double* const row = plane + r * grid.pitch;
        double sum = 0, whole = 0;
        for (size_t u = 0; u < grid.columns; ++u) sum += row[u] / inverse_mass[u], whole += 1 / inverse_mass[u];
        for (size_t u = 0; u < grid.columns; ++u) row[u] -= sum / whole;
    }
}

} // namespace cd
