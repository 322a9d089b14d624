// Planes of a sheet (kernel/sheet.hh) out of one run of numbers, and work on them spread over threads.
#pragma once

#include "base/memory.hh"
#include "contdyn/base.h"
#include "kernel/sheet.hh"

namespace cd {

// Rows are whole cache lines, an odd number of them: nodes below each other then fall into different sets of the cache.
inline bool grid_of(size_t columns, size_t rows, Grid& out) {
    size_t pitch;
    if (!add(columns, 4 + 7, pitch)) return false;
    const size_t lines = pitch / 8;
    out = {columns, rows, (lines % 2 == 1 ? lines : lines + 1) * 8};
    return true;
}

// Hands out runs of numbers, or, from null, counts how many there would be. A plane starts a cache line into its run,
// so that what lies beyond its first row is its own.
struct Carver {
    double* next;
    size_t taken = 0;
    bool fits = true;

    // Not inlined, as plane(): asked for dozens of planes in a row.
    [[gnu::noinline]] double* numbers(size_t count) {
        if (!next) {
            size_t whole;
            fits = fits && add(count, 7, whole) && add(taken, whole / 8 * 8, taken);
            return nullptr;
        }
        double* const run = next; // what has been counted fits
        const size_t whole = (count + 7) / 8 * 8;
        next += whole, taken += whole;
        return run;
    }
    [[gnu::noinline]] double* plane(const Grid& grid) {
        if (next) return numbers(grid.pitch * grid.rows + 2 * 8) + 8;
        size_t size;
        fits = fits && multiply(grid.pitch, grid.rows, size) && add(size, 2 * 8, size);
        return numbers(fits ? size : 0);
    }
    double* filtered_plane(const Grid& grid) { return plane({grid.columns, grid.filtered_rows(), grid.pitch}); }
};

// Lines of `length` numbers each in parts of at least `least` lines and about as many numbers as given.
struct Parts {
    size_t lines = 0, per_part = 1;

    Parts() = default;
    Parts(size_t lines_, size_t length, size_t least, size_t numbers = 1 << 14) : lines(lines_) {
        per_part = length < numbers ? numbers / length : 1;
        per_part = per_part < least ? least : (per_part + 7) / 8 * 8;
    }
    size_t count() const { return (lines + per_part - 1) / per_part; }

    // A body for parts of lines, behind a pointer: there is one text of it, and one of what goes through the parts.
    struct Body {
        const void* function;
        void (*call)(const void* function, size_t number, size_t first, size_t count);

        template <class F> Body(const F& f)
            : function(&f), call([](const void* of, size_t number, size_t first, size_t count) {
                  (*static_cast<const F*>(of))(number, first, count);
              }) {}
    };
    // body(number, first, count) for each, or for all lines at once where there are no threads (planes.cpp)
    void each(const cd_parallel& parallel, const Body& body) const;
};

// body(first, count) for parts of [0, lines), each line `length` numbers long.
template <class Body> void in_parts(const cd_parallel& parallel, size_t lines, size_t length, const Body& body) {
    Parts(lines, length, 8).each(parallel, [&](size_t, size_t first, size_t count) { body(first, count); });
}

} // namespace cd
