// Lines run down the columns. They are worked on side by side in strips: a strip's row follows the row before it, so
// that memory is read in order, and a strip is narrow enough for its last row to stay in the nearest cache.
#include "kernel/lines.hh"
#include "kernel/sheet.hh"

namespace cd {
namespace CD_ISA {

namespace {

constexpr size_t kStrip = 128;

// A number on its way through a line, every 16th node without what is too small: see Limits.
template <class L> inline L on_way(L sum, size_t row) {
    return row % kSettleEvery == 0 ? settled(sum, Limits<double>::least) : sum;
}
template <class L> inline void store_on_way(L sum, size_t row, double* to) { on_way(sum, row).store(to); }

template <class Strip> void in_strips(size_t first, size_t count, const Strip& strip) {
    for (size_t done = 0; done < count; done += kStrip)
        strip(first + done, count - done < kStrip ? count - done : kStrip);
}

// x_r = b_r + pull_{r-1} x_{r-1}
struct Forward {
    const double *b, *pull; // pull: of the row before; null in the first row
    double* x;
    size_t pitch, row;

    template <int N> void bundle(size_t u) const {
        using L = Lanes<N>;
        const L sum = L::load(b + u);
        store_on_way(pull ? sum + L::load(pull + u) * L::load(x + u - pitch) : sum, row, x + u);
    }
};

// x_r = gain_r x_r + pull_r x_{r+1}
struct Backward {
    const double *gain, *pull;
    double* x;
    size_t pitch, row;
    bool last;

    template <int N> void bundle(size_t u) const {
        using L = Lanes<N>;
        const L own = L::load(gain + u) * L::load(x + u);
        store_on_way(last ? own : own + L::load(pull + u) * L::load(x + u + pitch), row, x + u);
    }
};

// 1 in the lanes of the colour's columns, else 0.
template <int N> inline Lanes<N> coloured(size_t u, int colour) {
    static constexpr double kAlternate[] = {1, 0, 1, 0, 1, 0, 1, 0, 1};
    static_assert(N < 9, "as many as there are");
    return Lanes<N>::load(kAlternate + ((u + size_t(colour)) & 1));
}

// The same for the columns of one colour, whose neighbours keep still, to the bit: which of them a bundle has already
// stored depends on how wide it is.
struct ForwardBeside {
    const double *b, *pull, *cross;
    double* x;
    size_t pitch, row;
    int colour;

    template <int N> void bundle(size_t u) const {
        using L = Lanes<N>;
        L sum =
            L::load(b + u) + (L::load(cross + u) * L::load(x + u + 1) + L::load(cross + u - 1) * L::load(x + u - 1));
        if (pull) sum = sum + L::load(pull + u) * L::load(x + u - pitch);
        select(coloured<N>(u, colour), on_way(sum, row), L::load(x + u)).store(x + u);
    }
};

struct BackwardBeside {
    const double *gain, *pull;
    double* x;
    size_t pitch, row;
    bool last;
    int colour;

    template <int N> void bundle(size_t u) const {
        using L = Lanes<N>;
        const L old = L::load(x + u);
        L sum = L::load(gain + u) * old;
        if (!last) sum = sum + L::load(pull + u) * L::load(x + u + pitch);
        select(coloured<N>(u, colour), on_way(sum, row), old).store(x + u);
    }
};

// Takes back what the open lines' answer x lacks of the closing spring of a ring.
struct Close {
    const Grid& grid;
    const LineFactors& factors;
    double* x;
    int colour; // -1: every column

    template <int N> void bundle(size_t u) const {
        using L = Lanes<N>;
        const size_t last = (grid.rows - 1) * grid.pitch + u;
        L strength = L::load(factors.closing + u) * (L::load(x + last) - L::load(x + u));
        if (colour >= 0) strength = select(coloured<N>(u, colour), strength, L{});
        for (size_t r = 0; r < grid.rows; ++r) {
            const size_t at = r * grid.pitch + u;
            (L::load(x + at) - strength * L::load(factors.around + at)).store(x + at);
        }
    }
};

// The filters of solve/spring_line.hh for lines that share their fractions.
struct SharedForward {
    const double* carry;
    double* x;
    size_t pitch, row;

    template <int N> void bundle(size_t u) const {
        using L = Lanes<N>;
        store_on_way(between(L::load(x + u), L::load(x + u - pitch), carry), row, x + u);
    }
};

struct SharedBackward {
    const double* pull;
    double* x;
    size_t pitch, row;

    template <int N> void bundle(size_t u) const {
        using L = Lanes<N>;
        store_on_way(between(L::load(x + u), L::load(x + u + pitch), pull), row, x + u);
    }
};

} // namespace

void solve_lines(const Grid& grid, const LineFactors& factors, const double* b, double* x, size_t first, size_t count) {
    in_strips(first, count, [&](size_t from, size_t columns) {
        for (size_t r = 0; r < grid.rows; ++r) {
            const size_t row = r * grid.pitch;
            Forward step{b + row, r > 0 ? factors.pull + row - grid.pitch : nullptr, x + row, grid.pitch, r};
            along_row(from, columns, step);
        }
        for (size_t r = grid.rows; r-- > 0;) {
            const size_t row = r * grid.pitch;
            Backward step{factors.gain + row, factors.pull + row, x + row, grid.pitch, r, r + 1 == grid.rows};
            along_row(from, columns, step);
        }
        Close close{grid, factors, x, -1};
        if (factors.around) along_row(from, columns, close);
    });
}

void smooth_lines(const Grid& grid, const LineFactors& factors, const double* cross, const double* b, int colour,
                  double* x, size_t first, size_t count) {
    // Bundles store what they found in columns of the other colour. At the ends of a part the next one reads these.
    const auto is_coloured = [&](size_t u) { return (u & 1) == size_t(colour); };
    size_t end = first + count;
    if (first > 0 && !is_coloured(first)) ++first;
    if (end > first && end < grid.columns && !is_coloured(end - 1)) --end;
    in_strips(first, end - first, [&](size_t from, size_t columns) {
        for (size_t r = 0; r < grid.rows; ++r) {
            const size_t row = r * grid.pitch;
            const double* const pull = r > 0 ? factors.pull + row - grid.pitch : nullptr;
            ForwardBeside step{b + row, pull, cross + row, x + row, grid.pitch, r, colour};
            along_row(from, columns, step);
        }
        for (size_t r = grid.rows; r-- > 0;) {
            const size_t row = r * grid.pitch;
            const bool last = r + 1 == grid.rows;
            BackwardBeside step{factors.gain + row, factors.pull + row, x + row, grid.pitch, r, last, colour};
            along_row(from, columns, step);
        }
        Close close{grid, factors, x, colour};
        if (factors.around) along_row(from, columns, close);
    });
}

void filter_lines(const Grid& grid, const double* carry, const double* pull, double* x, size_t first, size_t count) {
    in_strips(first, count, [&](size_t from, size_t columns) {
        for (size_t r = 1; r < grid.rows; ++r) {
            SharedForward step{carry + r, x + r * grid.pitch, grid.pitch, r};
            along_row(from, columns, step);
        }
        for (size_t r = grid.rows; r-- > 1;) {
            SharedBackward step{pull + r - 1, x + (r - 1) * grid.pitch, grid.pitch, r - 1};
            along_row(from, columns, step);
        }
    });
}

} // namespace CD_ISA
} // namespace cd
