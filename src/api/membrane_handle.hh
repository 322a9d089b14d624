// From the opaque handle to the membrane behind it, and what both files of its functions use.
#pragma once

#include "api/shared.hh"
#include "model/membrane.hh"

namespace cd {

template <> struct Behind<cd_membrane> {
    using Object = Membrane;
    static constexpr uint64_t tag = kMembraneTag;
    static constexpr const char* name = "membrane";
};

inline cd_status is_field(const char* function, const Membrane&, cd_field field) {
    CD_CHECK(is_enum(function, "field", field, CD_MASK));
    if (field != CD_STIFFNESS && field != CD_BEND) return CD_OK;
    return fail(CD_ERROR_UNSUPPORTED, function, "field %d, %s, is none of a membrane's%s", int(field),
                field_name(field), field == CD_STIFFNESS ? ": it has CD_STIFFNESS_U and CD_STIFFNESS_V" : "");
}
inline bool is_always_on(const Membrane&, cd_field field) { return field == CD_POSITION || field == CD_VELOCITY; }
inline void switch_own(MembraneFeatures& wanted, cd_field field, bool on) {
    if (field == CD_STIFFNESS_U) wanted.spring_stiffness[kU] = on;
    if (field == CD_STIFFNESS_V) wanted.spring_stiffness[kV] = on;
    if (field == CD_PIN) wanted.pin = on;
    if (field == CD_MASK) wanted.mask = on;
}

} // namespace cd
