// From the opaque handle to the chain behind it, and what both files of its functions use.
#pragma once

#include "api/shared.hh"
#include "model/chain.hh"

namespace cd {

template <> struct Behind<cd_chain> {
    using Object = Chain;
    static constexpr uint64_t tag = kChainTag;
    static constexpr const char* name = "chain";
};

inline cd_status is_field(const char* function, const Chain&, cd_field field) {
    return is_enum(function, "field", field, CD_TARGET);
}
inline bool is_always_on(const Chain&, cd_field field) {
    return field == CD_POSITION || field == CD_VELOCITY || field == CD_PIN;
}
inline void switch_own(Features& wanted, cd_field field, bool on) {
    if (field == CD_STIFFNESS) wanted.spring_stiffness = on;
    if (field == CD_BEND) wanted.node_bend = on;
}

} // namespace cd
