// The ways to step that the report compares, and what every call of the library from it needs.
#ifndef REPORT_METHOD_HPP
#define REPORT_METHOD_HPP

#include <contdyn/contdyn.h>

#include <string>
#include <vector>

#include "plot.hpp"

namespace report {

// Ends the program with the library's message: for calls that cannot fail unless the library is broken.
void check(cd_status status);

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
    cd_solver solver = CD_SOLVER_ALTERNATING;   // of sheets
    cd_momentum momentum = CD_MOMENTUM_LINEAR;  // of water
    bool puts_back = false;                     // the textbook's lost and gained volume

    bool is_explicit() const { return method == CD_METHOD_FORWARD_EULER || method == CD_METHOD_SYMPLECTIC_EULER; }
};

enum class Way {
    forward_euler,
    symplectic_euler,
    half,
    backward,
    stiff_second,
    textbook_symplectic,
    textbook_half,
    textbook_backward,
    alternating_half,
    alternating_backward,
    alternating_stiff,
    coupled_half,
    coupled_backward,
    coupled_stiff,
    water_linear,
    water_half,
    water_one,
    water_advected,
    water_forward,
    water_explicit,
    water_explicit_advected,
    water_textbook,
    water_textbook_put_back
};
const Method& method(Way way);

// A method's style with float32 drawn hollow and dashed.
Style style_of(const Method& method, cd_precision precision);

}  // namespace report

#endif
