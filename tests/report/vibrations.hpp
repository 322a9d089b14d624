// What a method makes of the energy of a small linear lattice, in exact arithmetic: the lattice taken apart into its
// modes, each of which a step maps by a 2 x 2 matrix.
#ifndef REPORT_VIBRATIONS_HPP
#define REPORT_VIBRATIONS_HPP

#include <cstddef>
#include <vector>

#include "modes.hpp"

namespace report {

// How a run's energy goes, by the logarithm to base 10 of its ratio to that at the start.
struct Course {
    double highest = -INFINITY, last = 0;
    double largest = -INFINITY, force = -INFINITY; // of theory: log10 of the largest position or velocity and of w^2 x
    bool finite = true;
};

// The numbers of steps after which the energy of a run is looked at.
const std::vector<std::size_t>& looks();

struct Vibration {
    double omega_u, omega_v;        // from the two directions of a sheet, or from one
    double x, w;                    // position and velocity / omega, of a mode of unit mass
    double weight;                  // its energy is weight (x^2 + w^2)
    std::vector<double> shape = {}; // at each node

    double omega() const { return std::hypot(omega_u, omega_v); }
};

Course course_of(const std::vector<Vibration>& modes, const Method& how, double dt);

// Positions of all nodes after so many steps.
std::vector<double> positions_after(const std::vector<Vibration>& modes, const Method& how, double dt,
                                    std::size_t steps);

// The modes of `stiffness` (square, symmetric, row after row) and `mass` with their share of x and v, by Jacobi
// rotations. What does not swing is left out.
std::vector<Vibration> vibrations_of(std::vector<long double> stiffness, const std::vector<double>& mass,
                                     const std::vector<double>& x, const std::vector<double>& v);

// The same of nodes joined by springs, some of them held. A held node has no share of any shape.
struct Lattice {
    struct Spring {
        std::size_t a, b;
        double stiffness;
    };
    std::vector<double> mass;
    std::vector<bool> held;
    std::vector<Spring> springs;

    std::vector<Vibration> vibrations(const std::vector<double>& x, const std::vector<double>& v) const;
    long double energy(const std::vector<double>& x, const std::vector<double>& v) const;
};

// The course of a run, from its energies. `energy` may be as large as long double holds.
class Watch {
public:
    explicit Watch(long double first) : first_(first) {}
    void see(long double energy);
    void lose() { course_.finite = false; }
    const Course& course() const { return course_; }

private:
    long double first_;
    Course course_;
};

} // namespace report

#endif
