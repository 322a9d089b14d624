// Exact motions of sheets of one component: a drum by its modes, and the slowest modes of a sheet on a soft spring.
// Exact for the lattice, not for its continuum limit, so that what is measured against them is the error of the time
// steps.
#ifndef REPORT_MEMBRANE_MODES_HPP
#define REPORT_MEMBRANE_MODES_HPP

#include <functional>
#include <vector>

#include "membrane_runner.hpp"
#include "modes.hpp"

namespace report {

// A square drum of n springs a side, mass and stiffness 1, all edges held, let go from rest as a bump of height 1 and
// standard deviation 1/12 off its middle, made of 32 x 32 modes sin(p pi u/n) sin(q pi v/n). Their squared angular
// frequencies are the sums of those of a chain along u and one along v.
class DrumModes {
public:
    explicit DrumModes(std::size_t n);

    // Positions of every `stride`-th node of every `stride`-th row at time t.
    std::vector<double> at(double t, std::size_t stride = 1) const;

    // The error a method makes, in exact arithmetic, with `steps` steps over [0, t], taken over some 48 x 48 nodes.
    double expected_error(const Method& method, double t, std::size_t steps) const;

private:
    std::size_t n_;
    SineModes u_, v_;

    // The sum of all modes, each moved on by a factor that depends on its two angular frequencies.
    std::vector<double> sum(const std::function<double(double, double)>& factor, std::size_t stride) const;
};

SheetProblem drum(std::size_t n, const DrumModes& modes);

struct SheetMode {
    double omega;
    std::vector<double> shape;  // sum of squares 1
};

// The `count` slowest modes of a sheet without held nodes, by inverse iteration with a banded elimination in extended
// precision.
std::vector<SheetMode> slowest_modes(const SheetProblem& problem, std::size_t count);

}  // namespace report

#endif
