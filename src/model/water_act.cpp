// Acting on the water: volumes, sources, splashes, impulses. What is added up is what the cells hold after rounding.
#include "model/water_shares.hh"

namespace cd {

bool nearest_cell(const Water& w, double x, double y, size_t& i, size_t& j) {
    double least = HUGE_VAL;
    each_cell(w, [&](size_t k, size_t l) {
        if (!present(w, k, l)) return;
        const double by_x = centre(w, kX, k) - x, by_y = centre(w, kY, l) - y, square = by_x * by_x + by_y * by_y;
        if (square < least) least = square, i = k, j = l;
    });
    return least < HUGE_VAL;
}

namespace {

double as_stored(const Water& w, double value) { return is_wide(w) ? value : double(float(value)); }

// Sets a depth, and tells by how much that changed it.
double change_depth(Water& w, size_t i, size_t j, double depth) {
    const double old = depth_at(w, i, j);
    set_number(w, w.depth, place(w, i, j), depth > 0 ? depth : 0);
    disturb(w, {i, j, 1, 1});
    return depth_at(w, i, j) - old;
}

} // namespace

bool add_volume(Water& w, const Shares& shares, double volume, double& added) {
    const auto each = [&](auto f) { // f(i, j, new depth)
        shares.each([&](size_t i, size_t j, double weight) {
            f(i, j, depth_at(w, i, j) + weight / shares.sum * (volume / cell_area(w)));
        });
    };
    bool good = true;
    each([&](size_t, size_t, double depth) { good &= depth <= most_of(w); });
    if (!good) return false;
    Sum change;
    each([&](size_t i, size_t j, double depth) { change.add(change_depth(w, i, j, depth)); });
    added = change.value() * cell_area(w);
    w.account.add(added);
    return true;
}

// f(place, new source) for each cell.
template <class F> static void each_source(const Water& w, const Shares& shares, double rate, F f) {
    shares.each([&](size_t i, size_t j, double weight) {
        const size_t at = place(w, i, j);
        f(at, (w.source ? get_number(w, w.source, at) : 0) + weight / shares.sum * (rate / cell_area(w)));
    });
}

bool can_add_source(const Water& w, const Shares& shares, double rate) {
    bool good = true;
    each_source(w, shares, rate, [&](size_t, double source) { good &= fabs(source) <= most_of(w); });
    return good;
}

void add_source(Water& w, const Shares& shares, double rate) {
    each_source(w, shares, rate, [&](size_t at, double source) { set_number(w, w.source, at, source); });
}

// ---- splash ---------------------------------------------------------------------------------------------------------

namespace {

// The wet cells around a disc that take what is dug out of it: those between once and twice its radius, the more the
// nearer the middle between the two. Where the lattice is too coarse to have a centre there, those next to a dug cell.
struct Ring {
    const Water& w;
    const Shares& dug;
    Run x, y;
    Disc disc;
    bool coarse = false;
    double sum = 0;

    Ring(const Water& water, const Shares& shares, const Disc& d)
        : w(water),
          dug(shares),
          x(d.x, 2 * d.radius, w.size[kX], 0.5, w.cells[kX]),
          y(d.y, 2 * d.radius, w.size[kY], 0.5, w.cells[kY]),
          disc(d) {
        coarse = !has_cells();
        if (coarse) {
            const CellRectangle& part = dug.part;
            x.first = part.first_x > 0 ? part.first_x - 1 : 0;
            y.first = part.first_y > 0 ? part.first_y - 1 : 0;
            x.end = least(part.first_x + part.n_x + 1, w.cells[kX]);
            y.end = least(part.first_y + part.n_y + 1, w.cells[kY]);
        }
        Sum weights;
        each([&](size_t, size_t, double weight) { weights.add(weight); });
        sum = weights.value();
    }

    static size_t least(size_t p, size_t q) { return p < q ? p : q; }

    bool is_dug(size_t i, size_t j) const {
        const CellRectangle& part = dug.part;
        return i >= part.first_x && i - part.first_x < part.n_x && j >= part.first_y && j - part.first_y < part.n_y &&
               dug.weight(i, j) > 0;
    }
    bool next_to_dug(size_t i, size_t j) const { // beyond the first line, i - 1 wraps to a number that is in no part
        return is_dug(i - 1, j) || is_dug(i + 1, j) || is_dug(i, j - 1) || is_dug(i, j + 1);
    }
    // 0 of a cell that is not in the ring or not there, however wet. A disc without a centre has dug one beyond it.
    double weight(size_t i, size_t j) const {
        if (!present(w, i, j) || (dug.even && is_dug(i, j))) return 0;
        if (coarse) return !is_dug(i, j) && next_to_dug(i, j) ? 1 : 0;
        const double square = square_away(w, disc, i, j);
        if (!(square > 1 && square < 4)) return 0;
        const double out = sqrt(square) - 1, both = out * (1 - out);
        return both * both;
    }
    bool has_cells() const {
        for (size_t j = y.first; j < y.end; ++j)
            for (size_t i = x.first; i < x.end; ++i)
                if (weight(i, j) > 0) return true;
        return false;
    }
    // f(i, j, weight) for the wet ones; they sum to `sum`
    template <class F> void each(F f) const {
        for (size_t j = y.first; j < y.end; ++j)
            for (size_t i = x.first; i < x.end; ++i)
                if (depth_at(w, i, j) > 0)
                    if (const double own = weight(i, j); own > 0) f(i, j, own);
    }
};

} // namespace

bool splash(Water& w, const Disc& disc, double height) {
    const Shares dug(w, disc);
    const Ring ring(w, dug, disc);
    if (!(ring.sum > 0)) return true;
    const auto left_of = [&](size_t i, size_t j, double weight) {
        const double left = depth_at(w, i, j) - weight * height;
        return left > 0 ? as_stored(w, left) : 0;
    };
    Sum dug_out;
    dug.each([&](size_t i, size_t j, double weight) { dug_out.add(depth_at(w, i, j) - left_of(i, j, weight)); });
    const double taken = dug_out.value();
    bool good = true;
    ring.each([&](size_t i, size_t j, double weight) {
        good &= depth_at(w, i, j) + weight / ring.sum * taken <= most_of(w);
    });
    if (!good) return false;

    dug.each([&](size_t i, size_t j, double weight) { change_depth(w, i, j, left_of(i, j, weight)); });
    // What rounding keeps from one cell goes to the next.
    Sum weights, given;
    ring.each([&](size_t i, size_t j, double weight) {
        weights.add(weight);
        const double due = weights.value() / ring.sum * taken - given.value();
        given.add(change_depth(w, i, j, depth_at(w, i, j) + due));
    });
    return true;
}

// ---- impulse --------------------------------------------------------------------------------------------------------

namespace {

// The faces of an axis in a disc, by the weights of where they lie; where none lies in it, those of the nearest cell.
struct FaceDisc {
    const Water& w;
    Axis a;
    Disc disc;
    Run x, y;
    bool even = false;

    FaceDisc(const Water& water, Axis axis, const Disc& d)
        : w(water),
          a(axis),
          disc(d),
          x(d.x, d.radius, w.size[kX], a == kX ? 0 : 0.5, faces_along(w, a, kX)),
          y(d.y, d.radius, w.size[kY], a == kY ? 0 : 0.5, faces_along(w, a, kY)) {
        bool any = false;
        each_weight([&](size_t, size_t, double) { any = true; });
        if (any) return;
        even = true;
        x.end = x.first = y.end = y.first = 0;
        if (!nearest_cell(w, d.x, d.y, x.first, y.first)) return;
        x.end = x.first + 1 + (a == kX ? 1 : 0);
        y.end = y.first + 1 + (a == kY ? 1 : 0);
    }

    double weight(size_t i, size_t j) const {
        if (even) return 1;
        return disc_weight(square_away(disc, a == kX ? double(i) * w.size[kX] : centre(w, kX, i),
                                       a == kY ? double(j) * w.size[kY] : centre(w, kY, j)));
    }
    template <class F> void each_weight(F f) const {
        for (size_t j = y.first; j < y.end; ++j)
            for (size_t i = x.first; i < x.end; ++i)
                if (const double own = weight(i, j); own > 0) f(i, j, own);
    }
    // f(i, j, weight, mass) for each that has water
    template <class F> void each(F f) const {
        each_weight([&](size_t i, size_t j, double own) {
            const double mass = w.density * cell_area(w) * moving_depth(w, a, i, j);
            if (mass > 0) f(i, j, own, mass);
        });
    }
};

// The place of the face that is the same one on the opposite side, or its own.
size_t same_face(const Water& w, Axis a, size_t i, size_t j) {
    const size_t at = a == kX ? i : j, n = w.cells[a];
    if (!periodic(w, a) || (at > 0 && at < n)) return place(w, i, j);
    const size_t opposite = n - at;
    return a == kX ? place(w, opposite, j) : place(w, i, opposite);
}

} // namespace

bool impulse(Water& w, const Disc& disc, double x, double y) {
    const double wanted[2] = {x, y};
    // f(axis, i, j, change of velocity)
    const auto each = [&](auto f) {
        for (Axis a : {kX, kY}) {
            const FaceDisc faces(w, a, disc);
            Sum sum;
            faces.each([&](size_t, size_t, double weight, double mass) { sum.add(weight * mass); });
            const double whole = sum.value();
            faces.each([&](size_t i, size_t j, double weight, double) { f(a, i, j, weight / whole * wanted[a]); });
        }
    };
    // A face that is on two sides may be moved twice.
    bool good = true;
    each([&](Axis a, size_t i, size_t j, double change) {
        const size_t at = place(w, i, j);
        const double times = same_face(w, a, i, j) == at ? 1 : 2;
        good &= fabs(get_number(w, w.velocity[a], at) + times * change) <= most_of(w);
    });
    if (!good) return false;
    each([&](Axis a, size_t i, size_t j, double change) {
        const size_t at = place(w, i, j);
        set_number(w, w.velocity[a], at, get_number(w, w.velocity[a], at) + change);
        set_number(w, w.velocity[a], same_face(w, a, i, j), get_number(w, w.velocity[a], at));
        if (same_face(w, a, i, j) == at) disturb(w, {i, j, 1, 1});
        else disturb(w);
    });
    return true;
}

} // namespace cd
