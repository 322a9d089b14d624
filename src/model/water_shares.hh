// How what is done to a part of the water is shared out among its cells that are there: those of a disc by the weights
// (1 - (distance / radius)^2)^2 of their centres, or, where it has none, all to the nearest one; those of a rectangle
// evenly.
#pragma once

#include "base/sum.hh"
#include "model/water.hh"

namespace cd {

// The numbers k in [first, end), within [0, n), at which (k + offset) * size may lie less than `radius` from a place.
struct Run {
    size_t first, end;

    Run(double at, double radius, double size, double offset, size_t n) : first(0), end(n) {
        const double low = (at - radius) / size - offset, high = (at + radius) / size - offset;
        if (low >= 1) first = low < double(n) ? size_t(low) - 1 : n; // one further out, for rounding
        if (high < double(n) - 2) end = high > 0 ? size_t(high) + 2 : 2;
    }
};

// Squared, in radii, how far a place of the scene lies from the middle of a disc.
inline double square_away(const Disc& disc, double x, double y) {
    const double by_x = (x - disc.x) / disc.radius, by_y = (y - disc.y) / disc.radius;
    return by_x * by_x + by_y * by_y;
}
inline double disc_weight(double square) { return square < 1 ? (1 - square) * (1 - square) : 0; }
inline double centre(const Water& w, Axis a, size_t i) { return (double(i) + 0.5) * w.size[a]; }
inline double square_away(const Water& w, const Disc& disc, size_t i, size_t j) {
    return square_away(disc, centre(w, kX, i), centre(w, kY, j));
}

// The cell that is there nearest to a place; false if none is there at all.
bool nearest_cell(const Water& w, double x, double y, size_t& i, size_t& j);

struct Shares {
    const Water& w;
    bool even;
    Disc disc;
    CellRectangle part; // that no other cells have a share in
    double sum;

    Shares(const Water& water, const CellRectangle& rectangle)
        : w(water), even(true), disc{}, part(rectangle), sum(sum_of_weights()) {}
    Shares(const Water& water, const Disc& d) : w(water), even(false), disc(d) {
        const Run x(d.x, d.radius, w.size[kX], 0.5, w.cells[kX]), y(d.y, d.radius, w.size[kY], 0.5, w.cells[kY]);
        part = {x.first, y.first, x.end - x.first, y.end - y.first};
        sum = sum_of_weights();
        if (sum > 0) return;
        even = true;
        part = {0, 0, 1, 1};
        if (!nearest_cell(w, d.x, d.y, part.first_x, part.first_y)) part = {};
        sum = sum_of_weights();
    }

    // Of a cell in the part; 0 of one that is not there.
    double weight(size_t i, size_t j) const {
        if (!present(w, i, j)) return 0;
        return even ? 1 : disc_weight(square_away(w, disc, i, j));
    }
    // f(i, j, weight) for the cells that have one; they sum to `sum`
    template <class F> void each(F f) const {
        for (size_t j = part.first_y; j < part.first_y + part.n_y; ++j)
            for (size_t i = part.first_x; i < part.first_x + part.n_x; ++i)
                if (const double own = weight(i, j); own > 0) f(i, j, own);
    }

private:
    double sum_of_weights() const {
        Sum weights;
        each([&](size_t, size_t, double own) { weights.add(own); });
        return weights.value();
    }
};

} // namespace cd
