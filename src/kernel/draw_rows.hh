// What draw_sheet and draw_water have in common: numbers of a row side by side, and normals of it.
#pragma once

#include <string.h>

#include "kernel/draw.hh"

namespace cd {
namespace CD_ISA {

constexpr int kDrawnWide = 8;
using DrawnLanes = Lanes<kDrawnWide>;
// Numbers about a row's vertices, by whole lanes and what the last of them see beside.
constexpr size_t kDrawnNumbers = kDrawnTogether + 1 + kDrawnWide;

// n numbers of the state as doubles.
__attribute__((noinline)) static void take_numbers(const StateNumbers& from, size_t at, size_t n, double* to) {
    from.stored_state([&](const auto* numbers) {
        size_t c = 0;
        for (; c + kDrawnWide <= n; c += kDrawnWide) DrawnLanes::load(numbers + at + c).store(to + c);
        for (; c < n; ++c) to[c] = double(numbers[at + c]);
    });
}

// Writes those of kDrawnWide vectors that the block has from its vertex c on. in_range: > 0 where a vector is good;
// whether those that were written are.
inline bool put_normals(const DrawnLanes (&n)[3], DrawnLanes in_range, size_t c, const DrawnBlock& b,
                        unsigned char* row) {
    float lane[3][kDrawnWide];
    for (int k = 0; k < 3; ++k) n[k].store(lane[k]);
    const size_t several = b.count - c < kDrawnWide ? b.count - c : kDrawnWide;
    unsigned char* to = row + c * b.stride;
    for (size_t j = 0; j < several; ++j, to += b.stride)
        for (size_t k = 0; k < 3; ++k) memcpy(to + k * sizeof(float), &lane[k][j], sizeof(float));
    if (all_positive(in_range)) return true;
    double good[kDrawnWide];
    in_range.store(good);
    for (size_t j = 0; j < several; ++j)
        if (!(good[j] > 0)) return false;
    return true;
}

} // namespace CD_ISA
} // namespace cd
