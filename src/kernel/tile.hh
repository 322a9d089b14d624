// A square tile of numbers in registers: as many rows as a register has lanes. Turned over, lanes that held neighbours
// along a row hold neighbours down a column.
#pragma once

#include <utility>

#include "kernel/lanes.hh"

namespace cd {
namespace CD_ISA {

// Lanes of two registers, by their numbers: those of b follow those of a.
template <class V, size_t... I> inline V pick(V a, V b) {
#ifdef __clang__
    return __builtin_shufflevector(a, b, int(I)...);
#else
    typedef long long Numbers __attribute__((vector_size(sizeof(V))));
    return __builtin_shuffle(a, b, Numbers{(long long)(I)...});
#endif
}

// Exchanges the squares of `size` beside the diagonal, in each pair of rows `size` apart.
template <int N, size_t size, size_t... I>
inline void exchange_squares(Lanes<N>& a, Lanes<N>& b, std::index_sequence<I...>) {
    const auto upper = pick<decltype(a.v), (I & size ? size_t(N) + I - size : I)...>(a.v, b.v);
    const auto lower = pick<decltype(a.v), (I & size ? size_t(N) + I : I + size)...>(a.v, b.v);
    a.v = upper;
    b.v = lower;
}
template <int N, size_t size> inline void turn_squares(Lanes<N>* rows) {
    if constexpr (size > 0) {
#pragma GCC unroll 8
        for (size_t r = 0; r < size_t(N); ++r)
            if ((r & size) == 0)
                exchange_squares<N, size>(rows[r], rows[r + size], std::make_index_sequence<size_t(N)>());
        turn_squares<N, size / 2>(rows);
    }
}
template <int N> inline void turn_tile(Lanes<N>* rows) { turn_squares<N, size_t(N) / 2>(rows); }

// The lanes moved on by one, towards the end (the first stays where it was too) or the start (likewise the last).
template <int N, size_t... I> inline Lanes<N> moved_up(Lanes<N> a, std::index_sequence<I...>) {
    return {pick<decltype(a.v), (I > 0 ? I - 1 : 0)...>(a.v, a.v)};
}
template <int N, size_t... I> inline Lanes<N> moved_down(Lanes<N> a, std::index_sequence<I...>) {
    return {pick<decltype(a.v), (I + 1 < size_t(N) ? I + 1 : I)...>(a.v, a.v)};
}
template <int N> inline Lanes<N> moved_up(Lanes<N> a) {
    if constexpr (N == 1) return a;
    else return moved_up(a, std::make_index_sequence<size_t(N)>());
}
template <int N> inline Lanes<N> moved_down(Lanes<N> a) {
    if constexpr (N == 1) return a;
    else return moved_down(a, std::make_index_sequence<size_t(N)>());
}

} // namespace CD_ISA
} // namespace cd
