// The notes as anyone would write them: plain loops, and the tridiagonal elimination of Numerical Recipes with the
// diagonal m + lambda^2 dt^2 (k_left + k_right) formed as it stands. The baseline that everyone can recognise.
#ifndef REPORT_TEXTBOOK_HPP
#define REPORT_TEXTBOOK_HPP

#include <cstddef>
#include <vector>

namespace report {

// Numerical Recipes' elimination of n equations with lower a, diagonal b, upper c and right side r; gamma is scratch.
template <class Real>
void tridag(const std::vector<Real>& a, const std::vector<Real>& b, const std::vector<Real>& c,
            const std::vector<Real>& r, std::vector<Real>& u, std::vector<Real>& gamma) {
    const std::size_t n = b.size();
    Real bet = b[0];
    u[0] = r[0] / bet;
    for (std::size_t j = 1; j < n; ++j) {
        gamma[j] = c[j - 1] / bet;
        bet = b[j] - a[j] * gamma[j];
        u[j] = (r[j] - a[j] * u[j - 1]) / bet;
    }
    for (std::size_t j = n - 1; j-- > 0;) u[j] -= gamma[j + 1] * u[j + 1];
}

template <class Real>
struct TextbookChain {
    std::size_t nodes;
    std::vector<Real> mass, stiffness;  // per node, per spring
    std::vector<Real> x, v;
    bool pin_first = false, pin_last = false;
    Real gravity = 0, drag = 0, tie = 0;

    TextbookChain(std::size_t node_count, Real node_mass, Real spring_stiffness)
        : nodes(node_count), mass(nodes, node_mass), stiffness(nodes - 1, spring_stiffness), x(nodes), v(nodes),
          there_(nodes), force_(nodes), lower_(nodes), diagonal_(nodes), upper_(nodes), change_(nodes), gamma_(nodes) {}

    void explicit_step(Real dt, bool symplectic) {
        find_force(0);
        if (!symplectic)
            for (std::size_t i = 0; i < nodes; ++i) x[i] += dt * v[i];
        for (std::size_t i = 0; i < nodes; ++i) v[i] += dt * force_[i] / mass[i];
        hold_ends();
        if (symplectic)
            for (std::size_t i = 0; i < nodes; ++i) x[i] += dt * v[i];
    }

    void implicit_step(Real dt, Real lambda) {
        find_force(lambda * dt);
        Real scale = lambda * lambda * dt * dt;
        for (std::size_t i = 0; i < nodes; ++i) {
            Real left = i > 0 ? stiffness[i - 1] : 0, right = i + 1 < nodes ? stiffness[i] : tie;
            lower_[i] = -scale * left;
            upper_[i] = i + 1 < nodes ? -scale * right : 0;
            diagonal_[i] = mass[i] * (1 + lambda * dt * drag) + scale * (left + right);
            force_[i] *= dt;
        }
        if (pin_first) hold_row(0);
        if (pin_last) hold_row(nodes - 1);
        tridag(lower_, diagonal_, upper_, force_, change_, gamma_);
        for (std::size_t i = 0; i < nodes; ++i) {
            x[i] += dt * (v[i] + lambda * change_[i]);
            v[i] += change_[i];
        }
    }

private:
    std::vector<Real> there_, force_, lower_, diagonal_, upper_, change_, gamma_;

    // m g - K (x + ahead v) - drag m v
    void find_force(Real ahead) {
        const std::size_t last = nodes - 1;
        for (std::size_t i = 0; i < nodes; ++i) there_[i] = x[i] + ahead * v[i];
        for (std::size_t i = 1; i < last; ++i)
            force_[i] = mass[i] * gravity + stiffness[i] * (there_[i + 1] - there_[i]) -
                        stiffness[i - 1] * (there_[i] - there_[i - 1]);
        force_[0] = mass[0] * gravity + stiffness[0] * (there_[1] - there_[0]);
        force_[last] =
            mass[last] * gravity - stiffness[last - 1] * (there_[last] - there_[last - 1]) - tie * there_[last];
        if (drag > 0)
            for (std::size_t i = 0; i < nodes; ++i) force_[i] -= mass[i] * drag * v[i];
    }

    void hold_ends() {
        if (pin_first) v[0] = 0;
        if (pin_last) v[nodes - 1] = 0;
    }

    void hold_row(std::size_t i) {
        lower_[i] = upper_[i] = force_[i] = 0;
        diagonal_[i] = 1;
    }
};

}  // namespace report

#endif
