// A sheet as the notes have it, in plain loops: the operator of section 9 in two factors, rows and then columns, each
// line by Numerical Recipes' elimination.
#ifndef REPORT_TEXTBOOK_SHEET_HPP
#define REPORT_TEXTBOOK_SHEET_HPP

#include "textbook.hpp"

namespace report {

template <class Real> struct TextbookSheet {
    std::size_t columns, rows;
    Real mass, along_u;         // per node, per spring
    std::vector<Real> along_v;  // of the springs after each row
    std::vector<Real> x, v;     // node (i, j) at j * columns + i
    std::vector<char> held;
    Real tie = 0;  // from node (0, 0) to the origin

    TextbookSheet(std::size_t column_count, std::size_t row_count, Real node_mass, Real spring_u)
        : columns(column_count),
          rows(row_count),
          mass(node_mass),
          along_u(spring_u),
          along_v(rows - 1),
          x(columns * rows),
          v(columns * rows),
          held(columns * rows),
          there_(columns * rows),
          force_(columns * rows) {}

    void explicit_step(Real dt, bool symplectic) {
        find_force(0);
        if (!symplectic)
            for (std::size_t k = 0; k < x.size(); ++k) x[k] += dt * v[k];
        for (std::size_t k = 0; k < x.size(); ++k) v[k] += dt * force_[k] / mass;
        if (symplectic)
            for (std::size_t k = 0; k < x.size(); ++k) x[k] += dt * v[k];
    }

    void implicit_step(Real dt, Real lambda) {
        const Real scale = lambda * lambda * dt * dt;
        find_force(lambda * dt);
        for (Real& f : force_) f *= dt;
        spring_.assign(columns - 1, scale * along_u);
        for (std::size_t j = 0; j < rows; ++j) solve_line(j * columns, 1, columns, scale * tie);
        for (Real& f : force_) f *= mass;
        spring_ = along_v;
        for (Real& s : spring_) s *= scale;
        for (std::size_t i = 0; i < columns; ++i) solve_line(i, columns, rows, 0);
        for (std::size_t k = 0; k < x.size(); ++k) {
            x[k] += dt * (v[k] + lambda * force_[k]);
            v[k] += force_[k];
        }
    }

private:
    std::vector<Real> there_, force_, spring_, lower_, diagonal_, upper_, right_, change_, gamma_;

    // - K (x + ahead v), 0 where nodes are held
    void find_force(Real ahead) {
        for (std::size_t k = 0; k < x.size(); ++k) there_[k] = x[k] + ahead * v[k], force_[k] = 0;
        for (std::size_t j = 0; j < rows; ++j)
            for (std::size_t i = 0; i < columns; ++i) {
                const std::size_t k = j * columns + i;
                if (i > 0) force_[k] += along_u * (there_[k - 1] - there_[k]);
                if (i + 1 < columns) force_[k] += along_u * (there_[k + 1] - there_[k]);
                if (j > 0) force_[k] += along_v[j - 1] * (there_[k - columns] - there_[k]);
                if (j + 1 < rows) force_[k] += along_v[j] * (there_[k + columns] - there_[k]);
            }
        force_[0] -= tie * there_[0];
        for (std::size_t k = 0; k < x.size(); ++k)
            if (held[k]) force_[k] = 0;
    }

    // One line of n nodes from `first` on, joined by spring_: force_ becomes the answer. The tie is node (0, 0)'s.
    void solve_line(std::size_t first, std::size_t stride, std::size_t n, Real scaled_tie) {
        for (std::vector<Real>* line : {&lower_, &diagonal_, &upper_, &right_, &change_, &gamma_}) line->resize(n);
        for (std::size_t i = 0; i < n; ++i) {
            const std::size_t k = first + i * stride;
            const Real before = i > 0 ? spring_[i - 1] : 0, after = i + 1 < n ? spring_[i] : 0;
            lower_[i] = held[k] ? 0 : -before;
            upper_[i] = held[k] ? 0 : -after;
            diagonal_[i] = held[k] ? 1 : mass + before + after + (k == 0 ? scaled_tie : 0);
            right_[i] = force_[k];
        }
        tridag(lower_, diagonal_, upper_, right_, change_, gamma_);
        for (std::size_t i = 0; i < n; ++i) force_[first + i * stride] = change_[i];
    }
};

}  // namespace report

#endif
