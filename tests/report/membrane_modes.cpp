#include "membrane_modes.hpp"

#include <algorithm>
#include <cmath>

namespace report {

namespace {

const std::size_t kModes = 32;

std::vector<double> bump(std::size_t n, double centre) {
    std::vector<double> x(n + 1);
    for (std::size_t i = 1; i < n; ++i) {
        const double s = (double(i) / double(n) - centre) * 12;
        x[i] = std::exp(-0.5 * s * s);
    }
    return x;
}

}  // namespace

DrumModes::DrumModes(std::size_t n) : n_(n), u_(n, 1, bump(n, 0.4), kModes), v_(n, 1, bump(n, 0.45), kModes) {}

std::vector<double> DrumModes::sum(const std::function<double(double, double)>& factor, std::size_t stride) const {
    const std::size_t modes_u = u_.omega().size(), modes_v = v_.omega().size(), side = n_ / stride + 1;
    std::vector<double> along_u(modes_v * side), x(side * side);  // of mode q at column i, summed over p
    for (std::size_t q = 0; q < modes_v; ++q)
        for (std::size_t p = 0; p < modes_u; ++p) {
            const double amplitude = u_.amplitude()[p] * v_.amplitude()[q] * factor(u_.omega()[p], v_.omega()[q]);
            for (std::size_t i = 0; i < side; ++i) along_u[q * side + i] += amplitude * u_.shape(p, i * stride);
        }
    for (std::size_t j = 0; j < side; ++j)
        for (std::size_t q = 0; q < modes_v; ++q) {
            const double shape = v_.shape(q, j * stride);
            for (std::size_t i = 0; i < side; ++i) x[j * side + i] += shape * along_u[q * side + i];
        }
    return x;
}

std::vector<double> DrumModes::at(double t, std::size_t stride) const {
    return sum([t](double u, double v) { return std::cos(std::sqrt(u * u + v * v) * t); }, stride);
}

double DrumModes::expected_error(const Method& method, double t, std::size_t steps) const {
    const std::size_t stride = std::max<std::size_t>(1, n_ / 48);
    const double dt = t / double(steps);
    return relative_error(sum([&](double u, double v) { return mode_after(method, u, v, dt, steps); }, stride),
                          at(t, stride));
}

SheetProblem drum(std::size_t n, const DrumModes& modes) {
    SheetProblem problem;
    problem.nu = problem.nv = n;
    problem.edges = Edges::held;
    problem.position = modes.at(0);
    return problem;
}

namespace {

// K of a sheet without held nodes as L D L^T: entry(i, d) is that of node i with node i - d, D where d = 0.
class BandedStiffness {
public:
    explicit BandedStiffness(const SheetProblem& problem)
        : n_(problem.nodes()), band_(problem.nu + 1), entries_(n_ * (band_ + 1)) {
        for (std::size_t i = 0; i < n_; ++i) {
            if (i % band_ > 0) join(i, 1, problem.spring_along_u());
            if (i >= band_) join(i, band_, problem.spring_along_v(i / band_ - 1));
        }
        entry(0, 0) += problem.tie;
        for (std::size_t i = 0; i < n_; ++i) {
            const std::size_t width = std::min(band_, i);
            for (std::size_t d = width; d > 0; --d)  // L D
                for (std::size_t e = d + 1; e <= width; ++e) entry(i, d) -= entry(i, e) * entry(i - d, e - d);
            for (std::size_t d = 1; d <= width; ++d) {
                const long double scaled = entry(i, d);
                entry(i, d) /= entry(i - d, 0);
                entry(i, 0) -= scaled * entry(i, d);
            }
        }
    }

    void solve(std::vector<long double>& x) const {
        for (std::size_t i = 0; i < n_; ++i)
            for (std::size_t d = 1; d <= std::min(band_, i); ++d) x[i] -= entry(i, d) * x[i - d];
        for (std::size_t i = n_; i-- > 0;) {
            x[i] /= entry(i, 0);
            for (std::size_t d = 1; d <= band_ && i + d < n_; ++d) x[i] -= entry(i + d, d) * x[i + d];
        }
    }

private:
    std::size_t n_, band_;
    std::vector<long double> entries_;

    long double& entry(std::size_t i, std::size_t d) { return entries_[i * (band_ + 1) + d]; }
    const long double& entry(std::size_t i, std::size_t d) const { return entries_[i * (band_ + 1) + d]; }
    void join(std::size_t i, std::size_t d, long double spring) {
        entry(i, d) -= spring;
        entry(i, 0) += spring;
        entry(i - d, 0) += spring;
    }
};

long double dot(const std::vector<long double>& a, const std::vector<long double>& b) {
    long double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
    return sum;
}

}  // namespace

std::vector<SheetMode> slowest_modes(const SheetProblem& problem, std::size_t count) {
    const BandedStiffness stiffness(problem);
    std::vector<std::vector<long double>> shapes(count, std::vector<long double>(problem.nodes()));
    std::vector<SheetMode> modes(count);
    for (std::size_t k = 0; k < count; ++k)
        for (std::size_t i = 0; i < problem.nodes(); ++i)
            shapes[k][i] = k == 0 ? 1 : std::cos((long double)k * 3 * (long double)i / (long double)problem.nodes());
    for (int round = 0; round < 50; ++round)
        for (std::size_t k = 0; k < count; ++k) {
            std::vector<long double>& x = shapes[k];
            stiffness.solve(x);
            for (std::size_t j = 0; j < k; ++j) {
                const long double share = dot(x, shapes[j]);
                for (std::size_t i = 0; i < x.size(); ++i) x[i] -= share * shapes[j][i];
            }
            const long double size = std::sqrt(dot(x, x));
            for (long double& value : x) value /= size;
            modes[k].omega = double(std::sqrt(1 / (size * problem.mass_of_node())));
        }
    for (std::size_t k = 0; k < count; ++k) modes[k].shape.assign(shapes[k].begin(), shapes[k].end());
    return modes;
}

}  // namespace report
