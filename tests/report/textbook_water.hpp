// Water as the notes have it (Kass and Miller 1990, Kass 1997), in plain loops: the surface at two moments, faces as
// deep as the mean of their cells everywhere, rows and then columns by Numerical Recipes' elimination, and a surface
// that came out below the bed lifted onto it.
#ifndef REPORT_TEXTBOOK_WATER_HPP
#define REPORT_TEXTBOOK_WATER_HPP

#include <algorithm>

#include "textbook.hpp"

namespace report {

template <class Real> struct TextbookWater {
    std::size_t columns, rows;
    Real dx, dy, gravity;
    bool puts_back = false;             // the volume that a step gained or lost, evenly from all wet cells
    std::vector<Real> bed, now, before; // cell (i, j) at j * columns + i; the surface, and that a step ago

    TextbookWater(std::size_t column_count, std::size_t row_count, Real cell_x, Real cell_y, Real g)
        : columns(column_count),
          rows(row_count),
          dx(cell_x),
          dy(cell_y),
          gravity(g),
          bed(columns * rows),
          now(columns * rows),
          before(columns * rows),
          depth_(columns * rows),
          next_(columns * rows) {}

    double volume() const {
        double sum = 0;
        for (std::size_t k = 0; k < now.size(); ++k) sum += double(now[k]) - double(bed[k]);
        return sum * double(dx) * double(dy);
    }

    // (1 + A_x) (1 + A_y) next = 2 now - before
    void step(Real dt) {
        for (std::size_t k = 0; k < now.size(); ++k) {
            depth_[k] = now[k] - bed[k];
            next_[k] = 2 * now[k] - before[k];
        }
        const double kept = puts_back ? volume() : 0;
        if (columns > 1)
            for (std::size_t j = 0; j < rows; ++j) solve_line(j * columns, 1, columns, gravity * dt * dt / (dx * dx));
        if (rows > 1)
            for (std::size_t i = 0; i < columns; ++i) solve_line(i, columns, rows, gravity * dt * dt / (dy * dy));
        std::swap(before, now);
        for (std::size_t k = 0; k < now.size(); ++k) now[k] = std::max(next_[k], bed[k]);
        if (puts_back) put_back(kept);
    }

private:
    std::vector<Real> depth_, next_, lower_, diagonal_, upper_, right_, answer_, gamma_;

    void solve_line(std::size_t first, std::size_t stride, std::size_t n, Real scale) {
        for (std::vector<Real>* line : {&lower_, &diagonal_, &upper_, &right_, &answer_, &gamma_}) line->resize(n);
        for (std::size_t i = 0; i < n; ++i) {
            const std::size_t k = first + i * stride;
            lower_[i] = i > 0 ? -scale * (depth_[k - stride] + depth_[k]) / 2 : 0;
            upper_[i] = i + 1 < n ? -scale * (depth_[k] + depth_[k + stride]) / 2 : 0;
            diagonal_[i] = 1 - lower_[i] - upper_[i];
            right_[i] = next_[k];
        }
        tridag(lower_, diagonal_, upper_, right_, answer_, gamma_);
        for (std::size_t i = 0; i < n; ++i) next_[first + i * stride] = answer_[i];
    }

    void put_back(double kept) {
        std::size_t wet = 0;
        for (std::size_t k = 0; k < now.size(); ++k) wet += now[k] > bed[k];
        if (wet == 0) return;
        const double each = (kept - volume()) / (double(dx) * double(dy) * double(wet));
        for (std::size_t k = 0; k < now.size(); ++k)
            if (now[k] > bed[k]) now[k] = std::max(Real(now[k] + each), bed[k]);
    }
};

} // namespace report

#endif
