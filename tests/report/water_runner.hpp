// A water, and the problems that the library and the textbook both run.
#ifndef REPORT_WATER_RUNNER_HPP
#define REPORT_WATER_RUNNER_HPP

#include <cstddef>
#include <cstdint>
#include <vector>

#include "runner.hpp"

namespace report {

const double kEarth = 9.81;

class Water {
public:
    Water(std::size_t nx, std::size_t ny, double dx, double dy, cd_precision precision);
    ~Water() { cd_water_destroy(water_); }
    Water(const Water&) = delete;
    Water& operator=(const Water&) = delete;

    cd_water* get() const { return water_; }
    void enable(cd_field field) { check(cd_water_enable_field(water_, field)); }
    void write(cd_field field, const std::vector<double>& values); // of all cells or faces
    std::vector<double> read(cd_field field) const;
    void set(const Method& method);
    double volume() const;
    double energy() const; // kinetic and potential
    std::uint64_t hash() const;

private:
    std::size_t nx_, ny_;
    cd_water* water_ = nullptr;

    std::size_t columns(cd_field field) const { return nx_ + (field == CD_VELOCITY_X || field == CD_FORCE_X); }
    std::size_t rows(cd_field field) const { return ny_ + (field == CD_VELOCITY_Y || field == CD_FORCE_Y); }
};

// Water, walled in.
struct WaterProblem {
    std::size_t nx = 1, ny = 1;
    double dx = 1, dy = 1;
    double still = 0;                                 // a depth that positions() are told above
    std::vector<double> bed, depth;                   // bed empty: 0
    std::vector<double> velocity_x, velocity_y, rate; // of faces, and what they add to each cell [m/s]; empty: 0

    std::size_t cells() const { return nx * ny; }
};

void set_up(const WaterProblem& problem, Water& water); // bed, depth, velocities

// positions() are depths above problem.still; velocities() are empty.
std::unique_ptr<Runner> make_runner(const WaterProblem& problem, const Method& method, cd_precision precision);
MakeRunner runners_of(const WaterProblem& problem);

// The longest stable explicit step, from the library.
double stable_dt(const WaterProblem& problem);

} // namespace report

#endif
