#include "modes.hpp"

#include <algorithm>
#include <cmath>

namespace report {
namespace {

const long double kPi = 3.141592653589793238462643383279502884L;

using Matrix = StepMatrix;

Matrix operator*(const Matrix& p, const Matrix& q) {
    return {p.a * q.a + p.b * q.c, p.a * q.b + p.b * q.d, p.c * q.a + p.d * q.c, p.c * q.b + p.d * q.d};
}

Matrix power(Matrix base, std::size_t exponent) {
    Matrix result = {1, 0, 0, 1};
    for (; exponent > 0; exponent >>= 1, base = base * base)
        if (exponent & 1) result = result * base;
    return result;
}

// dw = -dt w^2 (x + h v) / D in each stage of h = lambda dt, with a = (h w_u)^2, b = (h w_v)^2: coupled D = 1 + a + b,
// alternating D = (1 + a)(1 + b). What is left of x is 1 - lambda^2 w^2 dt^2 / D = (D - a - b) / D.
Matrix implicit_step(const Method& method, double lambda, double u, double v) {
    const double squared = u * u + v * v, z = std::sqrt(squared);
    const double a = lambda * lambda * u * u, b = lambda * lambda * v * v;
    const double left = method.solver == CD_SOLVER_COUPLED ? 1 : 1 + a * b, d = left + a + b, pull = squared / d;
    return {1 - lambda * pull, z * (left / d), -z / d, 1 - lambda * pull};
}

}  // namespace

StepMatrix one_step(const Method& method, double u, double v) {
    const double squared = u * u + v * v, z = std::sqrt(squared);
    if (method.method == CD_METHOD_FORWARD_EULER) return {1, z, -z, 1};
    if (method.method == CD_METHOD_SYMPLECTIC_EULER) return {1 - squared, z, -z, 1};
    if (method.method != CD_METHOD_STIFF_SECOND) return implicit_step(method, method.lambda, u, v);
    const double gamma = 1 - std::sqrt(0.5), on = (1 - gamma) / gamma;  // a backward step of gamma dt, drawn out
    const Matrix b = implicit_step(method, 1, gamma * u, gamma * v);
    return b * Matrix{1 + on * (b.a - 1), on * b.b, on * b.c, 1 + on * (b.d - 1)};
}

SineModes::SineModes(std::size_t springs, double stiffness_over_mass, const std::vector<double>& position,
                     std::size_t modes)
    : springs_(springs), sine_(2 * springs) {
    const std::size_t n = springs;
    for (std::size_t k = 0; k < 2 * n; ++k) sine_[k] = double(std::sin(kPi * (long double)k / (long double)n));
    for (std::size_t j = 1; j <= std::min(modes, n - 1); ++j) {
        double sum = 0;
        for (std::size_t i = 1; i < n; ++i) sum += position[i] * sine_[i * j % (2 * n)];
        amplitude_.push_back(2 * sum / double(n));
        long double s = std::sin((long double)j * kPi / (2 * (long double)n));
        omega_.push_back(double(2 * std::sqrt((long double)n * (n + 1) * stiffness_over_mass) * s));
    }
}

std::vector<double> SineModes::sum(const std::vector<double>& amplitude, std::size_t stride) const {
    std::vector<double> position;
    for (std::size_t i = 0; i <= springs_; i += stride) {
        double x = 0;
        for (std::size_t j = 1; j <= amplitude.size(); ++j) x += amplitude[j - 1] * sine_[i * j % (2 * springs_)];
        position.push_back(x);
    }
    return position;
}

std::vector<double> SineModes::at(double t, std::size_t stride) const {
    std::vector<double> amplitude = amplitude_;
    for (std::size_t j = 0; j < amplitude.size(); ++j) amplitude[j] *= std::cos(omega_[j] * t);
    return sum(amplitude, stride);
}

std::vector<double> SineModes::stepped(const Method& method, double dt, std::size_t steps, std::size_t stride) const {
    std::vector<double> amplitude = amplitude_;
    for (std::size_t j = 0; j < amplitude.size(); ++j) amplitude[j] *= mode_after(method, omega_[j], 0, dt, steps);
    return sum(amplitude, stride);
}

double SineModes::expected_error(const Method& method, double t, std::size_t steps) const {
    const std::size_t stride = std::max<std::size_t>(1, springs_ / 500);
    return relative_error(stepped(method, t / double(steps), steps, stride), at(t, stride));
}

double mode_after(const Method& method, double omega_u, double omega_v, double dt, std::size_t steps) {
    return power(one_step(method, omega_u * dt, omega_v * dt), steps).a;
}

double frequency_of(const Method& method, double omega_u, double omega_v, double dt) {
    const Matrix m = one_step(method, omega_u * dt, omega_v * dt);
    const double half_trace = (m.a + m.d) / 2, determinant = m.a * m.d - m.b * m.c;
    const double under = determinant - half_trace * half_trace;
    return under > 0 ? std::atan2(std::sqrt(under), half_trace) / dt : NAN;
}

std::size_t fewest_steps(const std::function<double(std::size_t)>& error, double tolerance, std::size_t most) {
    std::size_t high = 1;
    while (high < most && !(error(high) <= tolerance)) high *= 2;
    high = std::min(high, most);
    if (!(error(high) <= tolerance)) return most + 1;
    std::size_t low = high / 2;  // too few
    while (high - low > std::max<std::size_t>(1, high / 100)) {
        std::size_t middle = low + (high - low) / 2;
        (error(middle) <= tolerance ? high : low) = middle;
    }
    return high;
}

double relative_error(const std::vector<double>& a, const std::vector<double>& b) {
    double error = 0, size = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        if (!std::isfinite(a[i])) return INFINITY;
        error = std::max(error, std::fabs(a[i] - b[i]));
        size = std::max(size, std::fabs(b[i]));
    }
    return error / size;
}

}  // namespace report
