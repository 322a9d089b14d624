#include "vibrations.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace report {

const std::vector<std::size_t>& looks() {
    static const std::vector<std::size_t> kLooks = {1, 2, 3, 5, 8, 13, 21, 34, 55, 89, 144, 200};
    return kLooks;
}

namespace {

// (x, w) times 10^exponent: a mode that grows by 1e20 a step would leave the range of any number.
struct Moving {
    StepMatrix step;
    double x, w, weight, omega;
    double exponent = 0;

    void advance() {
        const double next = step.a * x + step.b * w;
        w = step.c * x + step.d * w;
        x = next;
        const double size = std::fmax(std::fabs(x), std::fabs(w));
        if (size > 0 && (size > 1e30 || size < 1e-30)) x /= size, w /= size, exponent += std::log10(size);
    }
    double log_energy() const { return std::log10(weight * (x * x + w * w)) + 2 * exponent; }
    double log_size() const {
        return std::log10(std::fmax(std::fabs(x), std::fabs(w) * std::fmax(1, omega))) + exponent;
    }
};

// log10 of the sum of 10^l.
double sum_of(const std::vector<double>& logarithms) {
    const double most = *std::max_element(logarithms.begin(), logarithms.end());
    if (std::isinf(most)) return most;
    double sum = 0;
    for (double l : logarithms) sum += std::pow(10, l - most);
    return most + std::log10(sum);
}

} // namespace

Course course_of(const std::vector<Vibration>& modes, const Method& how, double dt) {
    std::vector<Moving> moving;
    std::vector<double> energies;
    for (const Vibration& m : modes) {
        moving.push_back({one_step(how, m.omega_u * dt, m.omega_v * dt), m.x, m.w, m.weight, m.omega()});
        energies.push_back(moving.back().log_energy());
    }
    const double first = sum_of(energies);
    Course course;
    std::size_t made = 0;
    for (std::size_t look : looks()) {
        for (; made < look; ++made)
            for (Moving& mode : moving) mode.advance();
        for (std::size_t i = 0; i < moving.size(); ++i) {
            energies[i] = moving[i].log_energy();
            course.largest = std::fmax(course.largest, moving[i].log_size());
            course.force = std::fmax(course.force, moving[i].log_size() + 2 * std::log10(moving[i].omega));
        }
        course.last = sum_of(energies) - first;
        course.highest = std::fmax(course.highest, course.last);
    }
    return course;
}

std::vector<Vibration> vibrations_of(std::vector<long double> a, const std::vector<double>& mass,
                                     const std::vector<double>& x, const std::vector<double>& v) {
    const std::size_t n = mass.size();
    std::vector<long double> root(n), vectors(n * n);
    for (std::size_t i = 0; i < n; ++i) root[i] = std::sqrt((long double)mass[i]), vectors[i * n + i] = 1;
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = 0; j < n; ++j) a[i * n + j] /= root[i] * root[j];
    auto turn = [](long double& p, long double& q, long double c, long double s) {
        const long double before = p;
        p = c * before - s * q;
        q = s * before + c * q;
    };
    for (int sweep = 0; sweep < 40; ++sweep) {
        bool done = true;
        for (std::size_t p = 0; p < n; ++p)
            for (std::size_t q = p + 1; q < n; ++q) {
                const long double off = a[p * n + q];
                if (std::fabs(off) <= 1e-19L * std::sqrt(std::fabs(a[p * n + p] * a[q * n + q]))) continue;
                done = false;
                const long double t2 = (a[q * n + q] - a[p * n + p]) / (2 * off);
                const long double t = (t2 < 0 ? -1 : 1) / (std::fabs(t2) + std::sqrt(t2 * t2 + 1));
                const long double c = 1 / std::sqrt(t * t + 1), s = t * c;
                for (std::size_t k = 0; k < n; ++k) turn(a[k * n + p], a[k * n + q], c, s);
                for (std::size_t k = 0; k < n; ++k) turn(a[p * n + k], a[q * n + k], c, s);
                for (std::size_t k = 0; k < n; ++k) turn(vectors[k * n + p], vectors[k * n + q], c, s);
            }
        if (done) break;
    }
    long double fastest = 0;
    for (std::size_t j = 0; j < n; ++j) fastest = std::fmax(fastest, a[j * n + j]);
    std::vector<Vibration> modes;
    for (std::size_t j = 0; j < n; ++j) {
        const long double squared = a[j * n + j];
        if (squared <= 1e-17L * fastest) continue;
        long double of_x = 0, of_v = 0;
        for (std::size_t i = 0; i < n; ++i) {
            of_x += vectors[i * n + j] * root[i] * (long double)x[i];
            of_v += vectors[i * n + j] * root[i] * (long double)v[i];
        }
        const long double omega = std::sqrt(squared);
        modes.push_back({double(omega), 0, double(of_x), double(of_v / omega), double(squared)});
        for (std::size_t i = 0; i < n; ++i) modes.back().shape.push_back(double(vectors[i * n + j] / root[i]));
    }
    return modes;
}

std::vector<double> positions_after(const std::vector<Vibration>& modes, const Method& how, double dt,
                                    std::size_t steps) {
    std::vector<double> positions(modes.front().shape.size());
    for (const Vibration& m : modes) {
        Moving mode{one_step(how, m.omega_u * dt, m.omega_v * dt), m.x, m.w, m.weight, m.omega()};
        for (std::size_t step = 0; step < steps; ++step) mode.advance();
        const double x = mode.x * std::pow(10, mode.exponent);
        for (std::size_t i = 0; i < positions.size(); ++i) positions[i] += x * m.shape[i];
    }
    return positions;
}

std::vector<Vibration> Lattice::vibrations(const std::vector<double>& x, const std::vector<double>& v) const {
    std::vector<std::size_t> number(mass.size(), SIZE_MAX), node;
    for (std::size_t i = 0; i < mass.size(); ++i)
        if (!held[i]) number[i] = node.size(), node.push_back(i);
    const std::size_t n = node.size();
    std::vector<long double> stiffness(n * n);
    std::vector<double> m(n), px(n), pv(n);
    for (const Spring& s : springs) {
        const std::size_t a = number[s.a], b = number[s.b];
        if (a < n) stiffness[a * n + a] += s.stiffness;
        if (b < n) stiffness[b * n + b] += s.stiffness;
        if (a < n && b < n) stiffness[a * n + b] -= s.stiffness, stiffness[b * n + a] -= s.stiffness;
    }
    for (std::size_t i = 0; i < n; ++i) m[i] = mass[node[i]], px[i] = x[node[i]], pv[i] = v[node[i]];
    std::vector<Vibration> modes = vibrations_of(stiffness, m, px, pv);
    for (Vibration& mode : modes) {
        std::vector<double> shape(mass.size());
        for (std::size_t i = 0; i < n; ++i) shape[node[i]] = mode.shape[i];
        mode.shape = shape;
    }
    return modes;
}

long double Lattice::energy(const std::vector<double>& x, const std::vector<double>& v) const {
    long double twice = 0;
    for (std::size_t i = 0; i < mass.size(); ++i) twice += (long double)mass[i] * v[i] * v[i];
    for (const Spring& s : springs) {
        const long double stretch = (long double)x[s.b] - x[s.a];
        twice += s.stiffness * stretch * stretch;
    }
    return twice / 2;
}

void Watch::see(long double energy) {
    course_.last = double(std::log10(energy / first_));
    course_.highest = std::fmax(course_.highest, course_.last);
}

} // namespace report
