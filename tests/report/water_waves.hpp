// Exact motions of water.
#ifndef REPORT_WATER_WAVES_HPP
#define REPORT_WATER_WAVES_HPP

#include <cmath>
#include <vector>

#include "water_runner.hpp"

namespace report {

// The lengths of steps that errors are told for: cells that waves cross in one.
const std::vector<double> kCourants = {0.5, 2, 8};

// So low that motion is linear, and still well above the rounding of the depth [m].
double small_height();

// Small waves in a pool of one depth with walls around, level and in motion at first: a sum of seiches
// height sin(omega t) cos(p pi x / length_x) cos(q pi y / length_y). Exact for the lattice of cells, where along x
// their squared angular frequency is g depth (2 sin(p pi / (2 nx)) / dx)^2, and not for its continuum limit: what is
// measured against it is the error of the time steps.
class Seiches {
public:
    struct Mode {
        std::size_t p, q;
        double height;
    };
    Seiches(std::size_t nx, std::size_t ny, double length_x, double length_y, double depth, std::vector<Mode> modes);

    // The surface above rest at time t.
    std::vector<double> at(double t) const;

    // The error a method makes, in exact arithmetic, with `steps` steps over [0, t], taken over some 64 x 64 cells.
    double expected_error(const Method& method, double t, std::size_t steps) const;

    WaterProblem problem() const;

private:
    std::size_t nx_, ny_;
    double dx_, dy_, depth_;
    std::vector<Mode> modes_;
    std::vector<double> omega_x_, omega_y_;

    double omega(std::size_t mode) const { return std::hypot(omega_x_[mode], omega_y_[mode]); }
    std::vector<double> heights(double t) const;
    std::vector<double> sum(const std::vector<double>& height, std::size_t stride_x, std::size_t stride_y) const;
};

// Thacker's planar oscillation (1981) on [-3, 3] over the bed 0.25 x^2: a plane surface that rocks. Exact with and
// without advected momentum, since all its water moves alike.
struct Thacker {
    static constexpr double kLength = 6, kCurve = 0.25, kSlope = 0.2;
    static double omega();
    static double period();
    static WaterProblem problem(std::size_t n);
    static std::vector<double> depth(std::size_t n, double t);
    // Of three periods, in each of which a wave where it is 1 m deep crosses `courant` cells.
    static std::size_t steps(std::size_t n, double courant);
};

// The L1 distance of two depths, relative to the volume of the second; infinite if the first is not finite.
double depth_error(const std::vector<double>& depth, const std::vector<double>& exact);

// A dam at x = 0 that breaks at t = 0, `left` metres deep on its left, `right` on its right (Stoker 1957; Ritter 1892
// where it is 0): the depth at x and the time t > 0.
struct DamBreak {
    static constexpr double kLength = 10, kTime = 6; // of the canal, and after which it is looked at
    double left, right;
    double plateau = 0, speed = 0, shock = 0; // depth and velocity behind the shock, and its own velocity; of Ritter 0

    DamBreak(double left_depth, double right_depth);
    double depth(double x, double t) const;
    WaterProblem problem(std::size_t n) const;
    std::vector<double> depths(std::size_t n) const;        // after kTime
    std::size_t steps(std::size_t n, double courant) const; // in each the fastest wave crosses so many cells
    double front() const { return right > 0 ? shock : 2 * std::sqrt(kEarth * left); }
};

} // namespace report

#endif
