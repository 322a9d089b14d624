// The library's implicit methods on a chain in long double, by series-spring elimination. Each step solves
// for
//     q = x + lambda dt v + lambda^2 dt dv,   (M + lambda^2 dt^2 K) q = M (x + lambda dt v),
// whose right side holds no stiffness and so loses nothing however stiff the springs are.
#ifndef REPORT_CHAIN_REFERENCE_HPP
#define REPORT_CHAIN_REFERENCE_HPP

#include <cmath>
#include <vector>

#include "method.hpp"

namespace report {

class Reference {
public:
    // Per node and per spring; all springs infinite: one body. Held: both ends.
    Reference(const std::vector<double>& mass, const std::vector<double>& spring, const std::vector<double>& position,
              const std::vector<double>& velocity, bool held = false)
        : x(position.begin(), position.end()),
          v(velocity.begin(), velocity.end()),
          mass_(mass.begin(), mass.end()),
          spring_(spring.begin(), spring.end()),
          held_(held) {}

    void step(const Method& how, long double dt) {
        if (std::isinf(spring_.front())) return move_rigidly(dt);
        if (how.method != CD_METHOD_STIFF_SECOND) return solve(how.lambda, dt);
        const long double gamma = 1 - std::sqrt(0.5L), h = gamma * dt, ratio = (1 - gamma) / gamma;
        std::vector<long double> x0 = x, v0 = v;
        solve(1, h);
        for (std::size_t i = 0; i < x.size(); ++i) {
            x[i] = x0[i] + ratio * (x[i] - x0[i]);
            v[i] = v0[i] + ratio * (v[i] - v0[i]);
        }
        solve(1, h);
    }

    std::vector<long double> x, v;

private:
    std::vector<long double> mass_, spring_;
    bool held_;

    void move_rigidly(long double dt) {
        long double mass = 0, momentum = 0;
        for (std::size_t i = 0; i < x.size(); ++i) mass += mass_[i], momentum += mass_[i] * v[i];
        for (std::size_t i = 0; i < x.size(); ++i) v[i] = momentum / mass, x[i] += dt * v[i];
    }

    // A held end is a spring from its neighbour to the ground, at 0 for what is solved for: that end lies at 0.
    void solve(long double lambda, long double dt) {
        const std::size_t n = x.size(), first = held_ ? 1 : 0, last = held_ ? n - 1 : n;
        const long double scale = lambda * lambda * dt * dt;
        std::vector<long double> w(n), p(n), q(n);
        long double grounding = mass_[first] + (held_ ? scale * spring_.front() : 0);
        for (std::size_t i = first; i < last; ++i) {
            q[i] = mass_[i] * (x[i] + lambda * dt * v[i]) + (i > first ? w[i - 1] * q[i - 1] : 0);
            const long double spring = i + 1 < n ? scale * spring_[i] : 0;
            w[i] = spring / (grounding + spring);
            p[i] = 1 / (grounding + spring);
            if (i + 1 < last) grounding = mass_[i + 1] + grounding * w[i];
        }
        for (std::size_t i = last; i-- > first;) q[i] = p[i] * q[i] + (i + 1 < last ? w[i] * q[i + 1] : 0);
        for (std::size_t i = first; i < last; ++i) {
            const long double change = (q[i] - x[i] - lambda * dt * v[i]) / (lambda * lambda * dt);
            x[i] += dt * (v[i] + lambda * change);
            v[i] += change;
        }
    }
};

} // namespace report

#endif
