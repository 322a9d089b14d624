#include "water_waves.hpp"

#include <algorithm>
#include <array>

#include "modes.hpp"

namespace report {
namespace {

// What a step makes of a mode: its height h, and what its velocities along x and y, scaled alike, add to it per second.
using Matrix = std::array<std::array<double, 3>, 3>;

Matrix product(const Matrix& a, const Matrix& b) {
    Matrix c{};
    for (int i = 0; i < 3; ++i)
        for (int k = 0; k < 3; ++k)
            for (int j = 0; j < 3; ++j) c[i][j] += a[i][k] * b[k][j];
    return c;
}

Matrix power(Matrix base, std::size_t exponent) {
    Matrix result{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    for (; exponent > 0; exponent /= 2, base = product(base, base))
        if (exponent % 2) result = product(result, base);
    return result;
}

// A sweep along axis a (1: x, 2: y): v' = v - w^2 dt (h + lambda (h' - h)), h' = h + dt (v + lambda (v' - v)).
// Explicit: h' with v; or, of second order, half of the push, the height, and the other half.
Matrix sweep(int a, double omega, double dt, const Method& how) {
    const double w = omega * omega * dt, lambda = how.is_explicit() ? 0 : how.lambda;
    const double factor = 1 / (1 + lambda * lambda * w * dt);
    Matrix m{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    if (how.method == CD_METHOD_SYMPLECTIC_EULER) {
        Matrix move = m;
        m[a][0] = -w / 2, move[0][a] = dt;
        return product(m, product(move, m));
    }
    m[a][0] = -w * factor;
    m[a][a] = 1 - w * lambda * dt * factor;
    m[0][0] = 1 + dt * lambda * m[a][0];
    m[0][a] = dt * (1 + lambda * (m[a][a] - 1));
    return m;
}

// The height of a mode that would swing to height 1, after so many steps, x first, from its passage through 0.
double height_after(const Method& how, double omega_x, double omega_y, double dt, std::size_t steps) {
    const double omega = std::hypot(omega_x, omega_y);
    if (how.textbook) { // (1 + a) (1 + b) next = 2 now - before
        const double factor = 1 / ((1 + std::pow(omega_x * dt, 2)) * (1 + std::pow(omega_y * dt, 2)));
        return -dt * omega * power({{{2 * factor, -factor, 0}, {1, 0, 0}, {0, 0, 0}}}, steps)[0][1];
    }
    const Matrix x = sweep(1, omega_x, dt, how), y = sweep(2, omega_y, dt, how);
    const Matrix first = product(y, x), second = product(x, y);
    Matrix all = power(product(second, first), steps / 2);
    if (steps % 2) all = product(first, all);
    return (all[0][1] * omega_x * omega_x + all[0][2] * omega_y * omega_y) / omega;
}

double omega_of(std::size_t mode, std::size_t n, double d, double depth) {
    return std::sqrt(kEarth * depth) * 2 * std::sin(double(mode) * M_PI / (2 * double(n))) / d;
}

} // namespace

Seiches::Seiches(std::size_t nx, std::size_t ny, double length_x, double length_y, double depth,
                 std::vector<Mode> modes)
    : nx_(nx),
      ny_(ny),
      dx_(length_x / double(nx)),
      dy_(length_y / double(ny)),
      depth_(depth),
      modes_(std::move(modes)) {
    for (const Mode& mode : modes_) {
        omega_x_.push_back(omega_of(mode.p, nx, dx_, depth));
        omega_y_.push_back(omega_of(mode.q, ny, dy_, depth));
    }
}

static std::vector<double> cosines(std::size_t mode, std::size_t n, std::size_t stride) {
    std::vector<double> values;
    for (std::size_t i = 0; i < n; i += stride)
        values.push_back(std::cos(double(mode) * M_PI * (double(i) + 0.5) / double(n)));
    return values;
}

std::vector<double> Seiches::sum(const std::vector<double>& height, std::size_t stride_x, std::size_t stride_y) const {
    std::vector<double> surface;
    for (std::size_t m = 0; m < modes_.size(); ++m) {
        const std::vector<double> x = cosines(modes_[m].p, nx_, stride_x), y = cosines(modes_[m].q, ny_, stride_y);
        surface.resize(x.size() * y.size());
        for (std::size_t k = 0; k < surface.size(); ++k) surface[k] += height[m] * x[k % x.size()] * y[k / x.size()];
    }
    return surface;
}

std::vector<double> Seiches::heights(double t) const {
    std::vector<double> heights;
    for (std::size_t m = 0; m < modes_.size(); ++m) heights.push_back(modes_[m].height * std::sin(omega(m) * t));
    return heights;
}

std::vector<double> Seiches::at(double t) const { return sum(heights(t), 1, 1); }

double Seiches::expected_error(const Method& method, double t, std::size_t steps) const {
    std::vector<double> made;
    for (std::size_t m = 0; m < modes_.size(); ++m)
        made.push_back(modes_[m].height * height_after(method, omega_x_[m], omega_y_[m], t / double(steps), steps));
    const std::size_t x = std::max<std::size_t>(1, nx_ / 64), y = std::max<std::size_t>(1, ny_ / 64);
    return relative_error(sum(made, x, y), sum(heights(t), x, y));
}

// The surface at rest is at 0. Velocities: g / omega times the slope of a mode at its greatest height.
WaterProblem Seiches::problem() const {
    WaterProblem problem;
    problem.nx = nx_, problem.ny = ny_;
    problem.dx = dx_, problem.dy = dy_;
    problem.still = depth_;
    problem.bed.assign(nx_ * ny_, -depth_);
    problem.depth.assign(nx_ * ny_, depth_);
    problem.velocity_x.assign((nx_ + 1) * ny_, 0);
    problem.velocity_y.assign(nx_ * (ny_ + 1), 0);
    std::vector<double> rates;
    for (std::size_t m = 0; m < modes_.size(); ++m) {
        const std::vector<double> x = cosines(modes_[m].p, nx_, 1), y = cosines(modes_[m].q, ny_, 1);
        const double scale = kEarth * modes_[m].height / omega(m);
        for (std::size_t j = 0; j < ny_; ++j)
            for (std::size_t i = 1; i < nx_; ++i)
                problem.velocity_x[j * (nx_ + 1) + i] += scale * (x[i] - x[i - 1]) / dx_ * y[j];
        for (std::size_t j = 1; j < ny_; ++j)
            for (std::size_t i = 0; i < nx_; ++i)
                problem.velocity_y[j * nx_ + i] += scale * (y[j] - y[j - 1]) / dy_ * x[i];
        rates.push_back(omega(m) * modes_[m].height);
    }
    problem.rate = sum(rates, 1, 1);
    return problem;
}

double small_height() { return precisions().front() == CD_FLOAT64 ? 1e-7 : 1e-3; }

double Thacker::omega() { return std::sqrt(2 * kEarth * kCurve); }
double Thacker::period() { return 2 * M_PI / omega(); }

std::vector<double> Thacker::depth(std::size_t n, double t) {
    const double w = omega(), slope = kSlope * std::cos(w * t),
                 middle = 1 - kEarth * kSlope * kSlope / (4 * w * w) * std::cos(2 * w * t);
    std::vector<double> depth;
    for (std::size_t i = 0; i < n; ++i) {
        const double x = kLength * ((double(i) + 0.5) / double(n) - 0.5);
        depth.push_back(std::fmax(0, middle + slope * x - kCurve * x * x));
    }
    return depth;
}

std::size_t Thacker::steps(std::size_t n, double courant) {
    return std::size_t(std::ceil(3 * period() * std::sqrt(kEarth) * double(n) / (courant * kLength)));
}

WaterProblem Thacker::problem(std::size_t n) {
    WaterProblem problem;
    problem.nx = n;
    problem.dx = kLength / double(n);
    for (std::size_t i = 0; i < n; ++i)
        problem.bed.push_back(kCurve * std::pow(kLength * ((double(i) + 0.5) / double(n) - 0.5), 2));
    problem.depth = depth(n, 0);
    return problem;
}

double depth_error(const std::vector<double>& depth, const std::vector<double>& exact) {
    double apart = 0, volume = 0;
    for (std::size_t i = 0; i < depth.size(); ++i) apart += std::fabs(depth[i] - exact[i]), volume += exact[i];
    return std::isfinite(apart) ? apart / volume : INFINITY;
}

// Behind the shock: the fan's 2 (c_left - c) = u, and the shock's balance of mass and momentum.
DamBreak::DamBreak(double left_depth, double right_depth) : left(left_depth), right(right_depth) {
    if (right <= 0) return;
    auto excess = [&](double d) {
        return 2 * (std::sqrt(kEarth * left) - std::sqrt(kEarth * d)) -
               (d - right) * std::sqrt(kEarth * (d + right) / (2 * d * right));
    };
    double low = right, high = left;
    for (int i = 0; i < 200; ++i) {
        const double middle = (low + high) / 2;
        (excess(middle) > 0 ? low : high) = middle;
    }
    plateau = low;
    speed = 2 * (std::sqrt(kEarth * left) - std::sqrt(kEarth * plateau));
    shock = plateau * speed / (plateau - right);
}

WaterProblem DamBreak::problem(std::size_t n) const {
    WaterProblem problem;
    problem.nx = n;
    problem.dx = kLength / double(n);
    for (std::size_t i = 0; i < n; ++i) problem.depth.push_back(2 * i < n ? left : right);
    return problem;
}

std::vector<double> DamBreak::depths(std::size_t n) const {
    std::vector<double> depths;
    for (std::size_t i = 0; i < n; ++i) depths.push_back(depth(kLength * ((double(i) + 0.5) / double(n) - 0.5), kTime));
    return depths;
}

std::size_t DamBreak::steps(std::size_t n, double courant) const {
    return std::size_t(std::ceil(kTime * std::sqrt(kEarth * left) * double(n) / (courant * kLength)));
}

double DamBreak::depth(double x, double t) const {
    const double c = std::sqrt(kEarth * left), s = x / t;
    if (s >= front()) return right;
    if (s <= -c) return left;
    return std::fmax(plateau, std::pow(2 * c - s, 2) / (9 * kEarth));
}

} // namespace report
