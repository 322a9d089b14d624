#include "method.hpp"

#include <cstdio>
#include <cstdlib>

namespace report {

void check(cd_status status) {
    if (status == CD_OK) return;
    std::fprintf(stderr, "contdyn_report: %s: %s\n", cd_status_name(status), cd_error_message());
    std::exit(1);
}

std::vector<cd_precision> precisions() {
    std::vector<cd_precision> there;
    for (cd_precision precision : {CD_FLOAT64, CD_FLOAT32}) {
#ifdef REPORT_CHAIN
        cd_chain* probe = nullptr;
        if (cd_chain_create(1, 1, 1, precision, nullptr, &probe) == CD_OK) there.push_back(precision);
        cd_chain_destroy(probe);
#elif defined REPORT_MEMBRANE
        cd_membrane* probe = nullptr;
        if (cd_membrane_create(1, 1, 1, precision, nullptr, &probe) == CD_OK) there.push_back(precision);
        cd_membrane_destroy(probe);
#else
        cd_water* probe = nullptr;
        if (cd_water_create(1, 1, 1, 1, precision, nullptr, &probe) == CD_OK) there.push_back(precision);
        cd_water_destroy(probe);
#endif
    }
    return there;
}

const char* name_of(cd_precision precision) { return precision == CD_FLOAT32 ? "float32" : "float64"; }

// Water with advected momentum.
static Method water(const char* key, const char* name, const Style& style, cd_method method) {
    Method made{key, name, method, 0.5, false, style};
    made.momentum = CD_MOMENTUM_ADVECTED;
    return made;
}

static Method textbook_that_puts_volume_back() {
    Method made{"textbook_put_back", "textbook, volume put back", CD_METHOD_IMPLICIT, 1, true,
                {0, Marker::plus, Dash::dotted, true}};
    made.puts_back = true;
    return made;
}

const Method& method(Way way) {
    static const Method kMethods[] = {
        {"forward_euler", "forward Euler", CD_METHOD_FORWARD_EULER, 0, false, {4, Marker::triangle}},
        {"symplectic_euler", "symplectic Euler", CD_METHOD_SYMPLECTIC_EULER, 0, false, {2, Marker::square}},
        {"implicit_half", "λ = 1/2", CD_METHOD_IMPLICIT, 0.5, false, {1, Marker::circle}},
        {"implicit_one", "λ = 1", CD_METHOD_IMPLICIT, 1, false, {5, Marker::diamond}},
        {"stiff_second", "stiff second order", CD_METHOD_STIFF_SECOND, 0, false, {3, Marker::wedge}},
        {"textbook_symplectic",
         "textbook symplectic Euler",
         CD_METHOD_SYMPLECTIC_EULER,
         0,
         true,
         {0, Marker::plus, Dash::dotted}},
        {"textbook_half", "textbook λ = 1/2", CD_METHOD_IMPLICIT, 0.5, true, {0, Marker::cross, Dash::dotted}},
        {"textbook_one", "textbook λ = 1", CD_METHOD_IMPLICIT, 1, true, {0, Marker::diamond, Dash::dotted, true}},
        {"alternating_half", "λ = 1/2 alternating", CD_METHOD_IMPLICIT, 0.5, false, {1, Marker::circle}},
        {"alternating_one", "λ = 1 alternating", CD_METHOD_IMPLICIT, 1, false, {5, Marker::diamond}},
        {"alternating_stiff", "stiff 2nd alternating", CD_METHOD_STIFF_SECOND, 0, false, {3, Marker::wedge}},
        {"coupled_half", "λ = 1/2 coupled", CD_METHOD_IMPLICIT, 0.5, false, {7, Marker::circle}, CD_SOLVER_COUPLED},
        {"coupled_one", "λ = 1 coupled", CD_METHOD_IMPLICIT, 1, false, {8, Marker::diamond}, CD_SOLVER_COUPLED},
        {"coupled_stiff", "stiff 2nd coupled", CD_METHOD_STIFF_SECOND, 0, false, {6, Marker::wedge}, CD_SOLVER_COUPLED},
        {"linear", "linear λ = 0.55", CD_METHOD_IMPLICIT, 0.55, false, {1, Marker::circle}},
        {"linear_half", "linear λ = 1/2", CD_METHOD_IMPLICIT, 0.5, false, {6, Marker::circle}},
        {"linear_one", "linear λ = 1", CD_METHOD_IMPLICIT, 1, false, {5, Marker::diamond}},
        water("advected", "advected", {3, Marker::wedge}, CD_METHOD_IMPLICIT),
        {"forward", "forward Euler", CD_METHOD_FORWARD_EULER, 0, false, {4, Marker::triangle}},
        {"explicit", "explicit", CD_METHOD_SYMPLECTIC_EULER, 0, false, {2, Marker::square}},
        water("explicit_advected", "explicit advected", {8, Marker::triangle}, CD_METHOD_SYMPLECTIC_EULER),
        {"textbook", "textbook", CD_METHOD_IMPLICIT, 1, true, {0, Marker::cross, Dash::dotted}},
        textbook_that_puts_volume_back(),
    };
    return kMethods[int(way)];
}

Style style_of(const Method& method, cd_precision precision) {
    Style style = method.style;
    if (precision == CD_FLOAT32) style.hollow = true, style.dash = Dash::dashed;
    return style;
}

}  // namespace report
