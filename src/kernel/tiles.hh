// Tiles: eight numbers from each of eight streams, turned so that a bundle of lanes holds one number of every stream.
// Turned in squares of a register's width, in the precision of what is stored.
#pragma once

#include <utility>

#include "kernel/lanes.hh"

namespace cd {
namespace CD_ISA {

constexpr int kTile = 8;

// A register of what is stored, and what takes part of it together with another: of two rows that are `kStep` apart in
// a square, the columns that belong to the first (or, kUpper, the second) once the square is turned.
template <class T> struct Square {
    static constexpr int kSide = kNative;
    typedef T Row __attribute__((vector_size(kSide * sizeof(T))));

    template <int kStep, bool kUpper, int... kColumns>
    static Row exchange(Row a, Row b, std::integer_sequence<int, kColumns...>) {
        return __builtin_shufflevector(a, b,
                                       ((kColumns & kStep) ? (kUpper ? kSide + kColumns : kSide + kColumns - kStep)
                                                           : (kUpper ? kColumns + kStep : kColumns))...);
    }
    template <int kStep> static void turn(Row* rows) {
        if constexpr (kStep > 0) {
            constexpr std::make_integer_sequence<int, kSide> columns{};
            for (int i = 0; i < kSide; ++i) {
                if (i & kStep) continue;
                const Row a = rows[i], b = rows[i + kStep];
                rows[i] = exchange<kStep, false>(a, b, columns);
                rows[i + kStep] = exchange<kStep, true>(a, b, columns);
            }
            turn<kStep / 2>(rows);
        }
    }
    static void turn(Row* rows) { turn<kSide / 2>(rows); }
};

// to[c * to_pitch + r] = from[r * from_pitch + c], the two apart. The last squares lie over those before them.
template <class T>
inline void turn(size_t rows, size_t columns, const T* from, size_t from_pitch, T* to, size_t to_pitch) {
    using S = Square<T>;
    constexpr size_t kSide = S::kSide;
    if (rows < kSide || columns < kSide) {
        for (size_t r = 0; r < rows; ++r)
            for (size_t c = 0; c < columns; ++c) to[c * to_pitch + r] = from[r * from_pitch + c];
        return;
    }
    for (size_t column = 0; column < columns; column += kSide)
        for (size_t row = 0; row < rows; row += kSide) {
            const size_t c = column + kSide < columns ? column : columns - kSide;
            const size_t r = row + kSide < rows ? row : rows - kSide;
            typename S::Row square[kSide];
#pragma GCC unroll 8
            for (size_t i = 0; i < kSide; ++i) memcpy(&square[i], from + (r + i) * from_pitch + c, sizeof square[i]);
            S::turn(square);
#pragma GCC unroll 8
            for (size_t i = 0; i < kSide; ++i) memcpy(to + (c + i) * to_pitch + r, &square[i], sizeof square[i]);
        }
}

template <int N> inline Lanes<N> join(const Lanes<kNative>* parts) {
    if constexpr (N == kNative) return *parts;
    else return {join<N / 2>(parts), join<N / 2>(parts + N / 2 / kNative)};
}
template <int N> inline void split(Lanes<N> whole, Lanes<kNative>* parts) {
    if constexpr (N == kNative) *parts = whole;
    else split(whole.a, parts), split(whole.b, parts + N / 2 / kNative);
}

// Streams lie `stride` apart.
template <class T> CD_INLINED inline void load_tile(const T* from, size_t stride, Lanes<kTile>* out) {
    using S = Square<T>;
    typename S::Row rows[S::kSide];
    Lanes<kNative> parts[kTile][kTile / kNative];
    for (int number = 0; number < kTile; number += S::kSide)
        for (int stream = 0; stream < kTile; stream += S::kSide) {
            for (int i = 0; i < S::kSide; ++i)
                memcpy(&rows[i], from + size_t(stream + i) * stride + number, sizeof rows[i]);
            S::turn(rows);
            for (int i = 0; i < S::kSide; ++i)
                parts[number + i][stream / S::kSide] = {converted<decltype(Lanes<kNative>::v)>(rows[i])};
        }
    for (int i = 0; i < kTile; ++i) out[i] = join<kTile>(parts[i]);
}
template <class T> CD_INLINED inline void store_tile(const Lanes<kTile>* in, T* to, size_t stride) {
    using S = Square<T>;
    typename S::Row rows[S::kSide];
    Lanes<kNative> parts[kTile][kTile / kNative];
    for (int i = 0; i < kTile; ++i) split<kTile>(in[i], parts[i]);
    for (int number = 0; number < kTile; number += S::kSide)
        for (int stream = 0; stream < kTile; stream += S::kSide) {
            for (int i = 0; i < S::kSide; ++i)
                rows[i] = converted<typename S::Row>(parts[number + i][stream / S::kSide].v);
            S::turn(rows);
            for (int i = 0; i < S::kSide; ++i)
                memcpy(to + size_t(stream + i) * stride + number, &rows[i], sizeof rows[i]);
        }
}

// `count` numbers of every stream: tiles, and one by one what fills none.
template <class T>
__attribute__((noinline)) void load_numbers(const T* from, size_t stride, size_t count, Lanes<kTile>* out) {
    size_t m = 0;
    for (; m + kTile <= count; m += kTile) load_tile(from + m, stride, out + m);
    for (; m < count; ++m) {
        double numbers[kTile];
        for (size_t k = 0; k < size_t(kTile); ++k) numbers[k] = double(from[k * stride + m]);
        out[m] = Lanes<kTile>::load(numbers);
    }
}
template <class T>
__attribute__((noinline)) void store_numbers(const Lanes<kTile>* in, T* to, size_t stride, size_t count) {
    size_t m = 0;
    for (; m + kTile <= count; m += kTile) store_tile(in + m, to + m, stride);
    for (; m < count; ++m) {
        T numbers[kTile];
        in[m].store(numbers);
        for (size_t k = 0; k < size_t(kTile); ++k) to[k * stride + m] = numbers[k];
    }
}

// Long lines, which do not stay in the cache, want what lies two tiles on asked for: while it works on one of several
// lines, the processor does not look that far.
constexpr size_t kFetchedNumbers = 1 << 18; // of all lines
// numbers: of a row, or of a tile of several lines.
inline void fetch_tile(const double* numbers, size_t count = kTile * kTile) {
#pragma GCC unroll 1
    for (size_t i = 0; i < count; i += 64 / sizeof(double)) __builtin_prefetch(numbers + i);
}

} // namespace CD_ISA
} // namespace cd
