// One chain problem, run by the library or by the textbook, behind the same four verbs.
#ifndef REPORT_CHAIN_RUNNER_HPP
#define REPORT_CHAIN_RUNNER_HPP

#include <contdyn/contdyn.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "plot.hpp"

namespace report {

// Ends the program with the library's message: for calls that cannot fail unless the library is broken.
void check(cd_status status);

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

// The precisions that this build of the library has.
std::vector<cd_precision> precisions();
const char* name_of(cd_precision precision);

// A way to step. Textbook: plain loops and Numerical Recipes' elimination in place of the library.
struct Method {
    std::string key, name;
    cd_method method;
    double lambda;
    bool textbook;
    Style style;

    bool is_explicit() const { return method == CD_METHOD_FORWARD_EULER || method == CD_METHOD_SYMPLECTIC_EULER; }
};

enum class Way { forward_euler, symplectic_euler, half, backward, stiff_second, textbook_symplectic, textbook_half,
                 textbook_backward };
const Method& method(Way way);
const std::vector<Way>& library_ways();

// A method's style with float32 drawn hollow and dashed.
Style style_of(const Method& method, cd_precision precision);

struct Problem {
    std::size_t springs = 1;
    double mass = 1, stiffness = 1;  // totals; each node mass/(springs + 1), each spring stiffness * springs
    bool pin_first = false, pin_last = false;
    double gravity = 0;
    double tie = 0;                           // stiffness of a spring from the last node to the origin
    std::vector<double> node_mass;            // empty: from the total
    std::vector<double> position, velocity;   // empty: zero

    double mass_of_node() const { return mass / double(springs + 1); }
    double stiffness_of_spring() const { return stiffness * double(springs); }
};

class Runner {
public:
    virtual ~Runner() = default;
    virtual void reset() = 0;                                // the initial state; the next step factors anew
    virtual bool step(double dt, std::size_t count) = 0;     // false: left the finite range
    virtual std::vector<double> positions() const = 0;
    virtual std::vector<double> velocities() const = 0;
    virtual std::uint64_t hash() const = 0;
};

std::unique_ptr<Runner> make_runner(const Problem& problem, const Method& method, cd_precision precision);

// The longest stable step of the symplectic Euler method, from the library.
double stable_dt(const Problem& problem);

}  // namespace report

#endif
