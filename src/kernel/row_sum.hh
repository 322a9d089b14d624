// The sum of a row of terms in an order that no instruction set changes: eight sums side by side, added in pairs.
#pragma once

#include "kernel/lanes.hh"

namespace cd {
namespace CD_ISA {

// to[k] for k < count: the sum of the terms that terms.each<N>(u, add) adds as add(k, lanes), those at u to u + N - 1.
template <int kMost, class Terms> inline void row_sums(size_t columns, int count, const Terms& terms, double* to) {
    constexpr int kSide = 8;
    Lanes<kSide> side[kMost] = {};
    double sums[kMost][kSide];
    size_t u = 0;
    for (; u + kSide <= columns; u += kSide)
        terms.template each<kSide>(u, [&](int k, const Lanes<kSide>& term) { side[k] = side[k] + term; });
    for (int k = 0; k < count; ++k) side[k].store(sums[k]);
    for (int i = 0; u < columns; ++u, ++i)
        terms.template each<1>(u, [&](int k, const Lanes<1>& term) { sums[k][i] += term.v; });
    for (int k = 0; k < count; ++k) {
        const double* const s = sums[k];
        to[k] = ((s[0] + s[1]) + (s[2] + s[3])) + ((s[4] + s[5]) + (s[6] + s[7]));
    }
}

template <class Term> struct SingleSum {
    const Term& term;
    template <int N, class Add> void each(size_t u, const Add& add) const { add(0, term.template operator()<N>(u)); }
};

// term<N>(u): the terms at u to u + N - 1, as lanes.
template <class Term> inline double row_sum(size_t columns, const Term& term) {
    double sum;
    row_sums<1>(columns, 1, SingleSum<Term>{term}, &sum);
    return sum;
}

} // namespace CD_ISA
} // namespace cd
