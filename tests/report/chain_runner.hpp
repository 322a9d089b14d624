// A chain, and the problems of one component that the library and the textbook both run.
#ifndef REPORT_CHAIN_RUNNER_HPP
#define REPORT_CHAIN_RUNNER_HPP

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "runner.hpp"

namespace report {

class Chain {
public:
    Chain(std::size_t springs, std::size_t components, cd_precision precision, std::size_t strands = 1);
    ~Chain() { cd_chain_destroy(chain_); }
    Chain(const Chain&) = delete;
    Chain& operator=(const Chain&) = delete;

    cd_chain* get() const { return chain_; }
    void write(cd_field field, const std::vector<double>& values);  // of all strands, nodes and components
    std::vector<double> read(cd_field field) const;
    std::uint64_t hash() const;

private:
    std::size_t strands_, springs_, components_;
    cd_chain* chain_ = nullptr;
};

// The library's ways to step a chain.
const std::vector<Way>& library_ways();

struct Problem {
    std::size_t springs = 1;
    double mass = 1, stiffness = 1;  // totals; each node mass/(springs + 1), each spring stiffness * springs
    bool pin_first = false, pin_last = false;
    double gravity = 0, drag = 0;
    double tie = 0;                           // stiffness of a spring from the last node to the origin
    std::vector<double> node_mass;            // empty: from the total
    std::vector<double> position, velocity;   // empty: zero

    double mass_of_node() const { return mass / double(springs + 1); }
    double stiffness_of_spring() const { return stiffness * double(springs); }
};

std::unique_ptr<Runner> make_runner(const Problem& problem, const Method& method, cd_precision precision);
MakeRunner runners_of(const Problem& problem);

// The longest stable step of the symplectic Euler method, from the library.
double stable_dt(const Problem& problem);

}  // namespace report

#endif
