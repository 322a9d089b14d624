// A sheet, and the problems of one component that the library and the textbook both run.
#ifndef REPORT_MEMBRANE_RUNNER_HPP
#define REPORT_MEMBRANE_RUNNER_HPP

#include <cstddef>
#include <cstdint>
#include <vector>

#include "runner.hpp"

namespace report {

class Sheet {
public:
    Sheet(std::size_t nu, std::size_t nv, std::size_t components, cd_precision precision);
    ~Sheet() { cd_membrane_destroy(membrane_); }
    Sheet(const Sheet&) = delete;
    Sheet& operator=(const Sheet&) = delete;

    cd_membrane* get() const { return membrane_; }
    void enable(cd_field field) { check(cd_membrane_enable_field(membrane_, field)); }
    void write(cd_field field, const std::vector<double>& values);  // of all nodes (springs) and components
    std::vector<double> read(cd_field field) const;                 // of all nodes and components
    void set(const Method& method);
    void pin_edges();  // all four
    std::uint64_t hash() const;
    std::size_t iterations() const;

private:
    std::size_t nu_, nv_, components_;
    cd_membrane* membrane_ = nullptr;
};

enum class Edges { free, held, held_along_v };  // held_along_v: the two at the ends of v

struct SheetProblem {
    std::size_t nu = 1, nv = 1;
    double mass = 1, along_u = 1, along_v = 1;  // totals
    Edges edges = Edges::free;
    double tie = 0;                          // stiffness of a spring from node (0, 0) to the origin
    double seam = 0;                         // not 0: that of all springs together that cross the middle of v
    std::vector<double> position, velocity;  // empty: zero

    std::size_t nodes() const { return (nu + 1) * (nv + 1); }
    double mass_of_node() const { return mass / double(nodes()); }
    double spring_along_u() const { return double(nu) * along_u / double(nv + 1); }
    double spring_along_v(std::size_t v) const {
        return seam > 0 && v == nv / 2 ? seam / double(nu + 1) : double(nv) * along_v / double(nu + 1);
    }
    bool is_held(std::size_t u, std::size_t v) const {
        return (edges != Edges::free && (v == 0 || v == nv)) || (edges == Edges::held && (u == 0 || u == nu));
    }
};

std::unique_ptr<Runner> make_runner(const SheetProblem& problem, const Method& method, cd_precision precision);
MakeRunner runners_of(const SheetProblem& problem);

// The longest stable step of the symplectic Euler method, from the library.
double stable_dt(const SheetProblem& problem);

}  // namespace report

#endif
