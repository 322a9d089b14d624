// A chain with bend as the notes have it, in plain loops: the pentadiagonal matrix formed as it stands, and Gauss's
// elimination of its five diagonals.
#ifndef REPORT_TEXTBOOK_ROD_HPP
#define REPORT_TEXTBOOK_ROD_HPP

#include <array>
#include <cstddef>
#include <vector>

namespace report {

template <class Real> struct TextbookRod {
    std::size_t nodes;
    Real mass, stiffness, bend; // of each node, spring and inner node
    std::vector<Real> x, v;

    TextbookRod(std::size_t node_count, Real node_mass, Real spring_stiffness, Real node_bend)
        : nodes(node_count),
          mass(node_mass),
          stiffness(spring_stiffness),
          bend(node_bend),
          x(nodes),
          v(nodes),
          there_(nodes),
          change_(nodes),
          rows_(nodes) {}

    void implicit_step(Real dt, Real lambda) {
        find_force(lambda * dt);
        form_matrix(lambda * lambda * dt * dt);
        for (Real& f : change_) f *= dt;
        eliminate();
        for (std::size_t i = 0; i < nodes; ++i) {
            x[i] += dt * (v[i] + lambda * change_[i]);
            v[i] += change_[i];
        }
    }

private:
    std::vector<Real> there_, change_;
    std::vector<std::array<Real, 5>> rows_; // of the matrix: columns i - 2 to i + 2

    // - K (x + ahead v)
    void find_force(Real ahead) {
        for (std::size_t i = 0; i < nodes; ++i) there_[i] = x[i] + ahead * v[i], change_[i] = 0;
        for (std::size_t i = 0; i + 1 < nodes; ++i) {
            const Real tension = stiffness * (there_[i + 1] - there_[i]);
            change_[i] += tension;
            change_[i + 1] -= tension;
        }
        for (std::size_t i = 1; i + 1 < nodes; ++i) {
            const Real moment = bend * (there_[i - 1] - 2 * there_[i] + there_[i + 1]);
            change_[i - 1] -= moment;
            change_[i] += 2 * moment;
            change_[i + 1] -= moment;
        }
    }

    // M + scale K
    void form_matrix(Real scale) {
        for (auto& row : rows_) row = {0, 0, mass, 0, 0};
        const Real s = scale * stiffness, b = scale * bend;
        for (std::size_t i = 0; i + 1 < nodes; ++i) {
            rows_[i][2] += s, rows_[i + 1][2] += s;
            rows_[i][3] -= s, rows_[i + 1][1] -= s;
        }
        for (std::size_t i = 1; i + 1 < nodes; ++i) {
            const Real weights[3] = {1, -2, 1};
            for (std::size_t p = 0; p < 3; ++p)
                for (std::size_t q = 0; q < 3; ++q) rows_[i - 1 + p][2 + q - p] += b * weights[p] * weights[q];
        }
    }

    // change_: the right side, then the answer.
    void eliminate() {
        for (std::size_t i = 0; i + 1 < nodes; ++i)
            for (std::size_t k = 1; k < 3 && i + k < nodes; ++k) {
                auto& row = rows_[i + k];
                const Real factor = row[2 - k] / rows_[i][2];
                for (std::size_t j = 1; j < 3; ++j) row[2 - k + j] -= factor * rows_[i][2 + j];
                change_[i + k] -= factor * change_[i];
            }
        for (std::size_t i = nodes; i-- > 0;) {
            for (std::size_t j = 1; j < 3 && i + j < nodes; ++j) change_[i] -= rows_[i][2 + j] * change_[i + j];
            change_[i] /= rows_[i][2];
        }
    }
};

} // namespace report

#endif
