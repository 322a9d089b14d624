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

// Whether every welded group would hold one held node at the most, if springs and nodes were as the functions say.
template <class Welded, class Held> bool groups_are_sound(const Chain& c, Welded is_welded, Held is_held) {
    const size_t springs = springs_in_all(c);
    size_t start = 0;
    while (c.ring && start < c.nodes && is_welded(start > 0 ? start - 1 : springs - 1)) ++start;
    if (start == c.nodes) start = 0;
    int held_here = 0;
    for (size_t k = 0, i = start; k < c.nodes; ++k, i = i + 1 < c.nodes ? i + 1 : 0) {
        held_here += is_held(i) ? 1 : 0;
        if (held_here > 1) return false;
        if (i >= springs || !is_welded(i)) held_here = 0;
    }
    return true;
}

} // namespace cd
