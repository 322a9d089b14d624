// The sum of a row of terms in an order that no instruction set changes: eight sums side by side, added in pairs.
#pragma once

#include "kernel/lanes.hh"

namespace cd {
namespace CD_ISA {

// term<N>(u): the terms at u to u + N - 1, as lanes.
template <class Term> inline double row_sum(size_t columns, const Term& term) {
    constexpr int kSide = 8;
    Lanes<kSide> side{};
    double sums[kSide];
    size_t u = 0;
    for (; u + kSide <= columns; u += kSide) side = side + term.template operator()<kSide>(u);
    side.store(sums);
    for (int k = 0; u < columns; ++u, ++k) sums[k] += term.template operator()<1>(u).v;
    return ((sums[0] + sums[1]) + (sums[2] + sums[3])) + ((sums[4] + sums[5]) + (sums[6] + sums[7]));
}

} // namespace CD_ISA
} // namespace cd
