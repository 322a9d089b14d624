// From the opaque handle to the chain behind it.
#pragma once

#include <string.h>

#include "api/check.hh"
#include "model/chain.hh"

// Checks `chain` and declares `c`, the chain behind it.
#define CD_THE_CHAIN(type)                     \
    CD_CHECK(::cd::is_chain(__func__, chain)); \
    type& c = *reinterpret_cast<type*>(const_cast<cd_chain*>(chain))

namespace cd {

inline cd_status is_chain(const char* function, const cd_chain* chain, const char* name = "chain") {
    CD_CHECK(not_null(function, name, chain));
    uint64_t tag;
    memcpy(&tag, chain, sizeof tag);
    return tag == kChainTag ? CD_OK
                            : fail(CD_ERROR_HANDLE, function, "%s, %p, is no living chain", name, (const void*)chain);
}

// The largest number that the chain's precision holds.
inline double most_of(const Chain& c) {
    return c.precision == CD_FLOAT64 ? 1.7976931348623157e308 : 3.4028234663852886e38;
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
