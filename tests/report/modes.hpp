// The exact motion of a uniform chain with both ends held, released from rest, by its sine modes: shape sin(j pi i/n),
// omega_j = 2 sqrt(n (n+1) k/m) sin(j pi/(2n)). Exact for the chain of n springs, not for its continuum limit, so that
// what is measured against it is the error of the time steps alone.
#ifndef REPORT_MODES_HPP
#define REPORT_MODES_HPP

#include <cstddef>
#include <functional>
#include <vector>

#include "method.hpp"

namespace report {

class SineModes {
public:
    // Modes 1 .. min(springs - 1, modes) of the positions; a smooth shape needs few.
    SineModes(std::size_t springs, double stiffness_over_mass, const std::vector<double>& position, std::size_t modes);

    // Positions of every `stride`-th node at time t.
    std::vector<double> at(double t, std::size_t stride = 1) const;

    // What a method makes of them in exact arithmetic after `steps` steps of dt.
    std::vector<double> stepped(const Method& method, double dt, std::size_t steps, std::size_t stride = 1) const;

    // The error a method makes, in exact arithmetic, with `steps` steps over [0, t], taken over some 500 nodes.
    double expected_error(const Method& method, double t, std::size_t steps) const;

    // By j = mode - 1; and the shape of a mode at node i.
    const std::vector<double>& amplitude() const { return amplitude_; }
    const std::vector<double>& omega() const { return omega_; }
    double shape(std::size_t j, std::size_t i) const { return sine_[i * (j + 1) % (2 * springs_)]; }

private:
    std::size_t springs_;
    std::vector<double> sine_;                  // sin(pi k / n), k = 0 .. 2n-1
    std::vector<double> amplitude_, omega_;     // of mode j + 1

    std::vector<double> sum(const std::vector<double>& amplitude, std::size_t stride) const;
};

// What one step makes of a mode's (x, v/omega), where u = omega_u dt and v = omega_v dt: (a x + b v, c x + d v).
struct StepMatrix {
    double a, b, c, d;
};
StepMatrix one_step(const Method& method, double u, double v);

// What a method, in exact arithmetic, makes of a mode of amplitude 1 released from rest: its amplitude after `steps`.
// The mode's angular frequency is sqrt(omega_u^2 + omega_v^2), from the two directions of a sheet, or from one.
double mode_after(const Method& method, double omega_u, double omega_v, double dt, std::size_t steps);

// The angular frequency it moves at, from the eigenvalues of a step; NaN where it does not swing.
double frequency_of(const Method& method, double omega_u, double omega_v, double dt);

// The fewest steps for which `error` stays within the tolerance, to 1%; most + 1 if more than `most` are needed.
std::size_t fewest_steps(const std::function<double(std::size_t)>& error, double tolerance, std::size_t most);

// max |a - b| / max |b|; infinite if a is not finite.
double relative_error(const std::vector<double>& a, const std::vector<double>& b);

}  // namespace report

#endif
