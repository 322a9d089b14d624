// Which parts of a water are asleep: see water_sleep.hh. How much they stir is measured in water_survey.cpp.
#include "model/water_hull.hh"

namespace cd {

namespace {

double square(double x) { return x * x; }
double larger(double x, double y) { return x > y ? x : y; }

double stir_of(const Water& w, double height) { return w.gravity * square(height); }

// How much of what a step moves at an end of a run of tiles reaches a tile beyond it, `cells` away: of the implicit
// step the solution of (1 - (theta c)^2 d_xx) x = 0 that dies out, c the Courant number.
double reaching(double theta, double courant, size_t cells) {
    const double stiff = square(theta * courant);
    if (!(stiff > 0)) return 0;
    const double half = 0.5 / stiff, root = sqrt(half * half + 2 * half);
    double factor = 1 / (1 + half + root), power = 1;
    for (size_t bits = cells; bits > 0; bits /= 2, factor *= factor)
        if (bits % 2 == 1) power *= factor;
    return power;
}

// Of a line of tiles: those no further than `reach` from one that is marked `from` are marked `to`.
void spread(uint8_t* marks, size_t step, size_t n, size_t reach, uint8_t from, uint8_t to) {
    for (const bool back : {false, true}) {
        size_t left = 0;
        for (size_t k = 0; k < n; ++k) {
            uint8_t& mark = marks[(back ? n - 1 - k : k) * step];
            if ((mark & from) != 0) left = reach + 1;
            if (left > 0) mark |= to, --left;
        }
    }
}

struct Chooser {
    Water& w;
    double dt, limit = stir_of(w, w.sleep);
    WaterTiles& tiles = w.tiles;
    TileStir most{};

    void mark_stirring() {
        for (size_t k = 0; k < tiles.size(); ++k) {
            const TileStir& here = tiles.stir[k];
            const bool stirs = here.stir > limit;
            const uint8_t kept = (tiles.marks[k] & kChanged) != 0 ? 0 : tiles.marks[k] & kStill;
            tiles.marks[k] = uint8_t(kept | (stirs ? kReached : 0));
            most.add(stirs ? here : TileStir{0, here.deepest, 0});
        }
    }
    // Tiles of cells [first, end), as far as they are in the scene.
    void mark_acting(const double (&first)[2], const double (&end)[2]) {
        size_t from[2], to[2];
        for (Axis a : {kX, kY}) {
            const double n = double(w.cells[a]);
            if (!(end[a] > 0) || !(first[a] < n)) return;
            from[a] = size_t(larger(first[a], 0)) / kTile;
            to[a] = end[a] < n ? size_t(end[a]) / kTile + 1 : tiles.count[a];
            to[a] = to[a] < tiles.count[a] ? to[a] : tiles.count[a];
        }
        for (size_t y = from[kY]; y < to[kY]; ++y)
            for (size_t x = from[kX]; x < to[kX]; ++x) tiles.marks[tiles.at(kX, x, y)] |= kReached;
        most.stir = larger(stir_of_acting(w), most.stir);
    }
    void mark_sides() {
        for (Axis a : {kX, kY})
            for (const bool at_last : {false, true}) {
                if (!has_value(w.side[side_of(a, at_last)].kind)) continue;
                double first[2] = {0, 0}, end[2] = {double(w.cells[kX]), double(w.cells[kY])};
                if (at_last) first[a] = end[a] - 1;
                else end[a] = 1;
                mark_acting(first, end);
            }
    }
    void mark_hulls() {
        for (size_t k = 0; CD_WITH_HULL && k < w.hull_shape.count; ++k) {
            const Hull& h = hull(w, k);
            if (is_off(h)) continue;
            double first[2], end[2];
            for (Axis a : {kX, kY}) { // plates, and what they share with cells beside them
                const double middle = a == kX ? h.x : h.y, reach = (h.length + h.width) / 2 + fabs(h.velocity[a]) * dt;
                first[a] = (middle - reach) / w.size[a] - 2;
                end[a] = (middle + reach) / w.size[a] + 2;
            }
            mark_acting(first, end);
        }
    }

    // How far a step carries what stirs before it is as weak as what sleeps.
    size_t reach(Axis a) const {
        const double courant = (sqrt(w.gravity * most.deepest) + most.fastest) * dt / w.size[a];
        const double theta = w.method == CD_METHOD_IMPLICIT ? w.lambda : 0, part = reaching(theta, courant, kTile);
        const double weakest = sqrt(limit / most.stir);
        const double run = most.fastest * dt / (w.size[a] * double(kTile)), all = double(tiles.count[a]);
        size_t tiles_along = 1 + size_t(run < all ? run : all); // as far as water runs, the tile that it reaches too
        for (double left = part; left > weakest && tiles_along < tiles.count[a]; left *= part) ++tiles_along;
        return tiles_along;
    }

    void mark_awake() {
        if (most.stir == 0) return;
        const size_t across = reach(kX), along = reach(kY);
        for (size_t y = 0; y < tiles.count[kY]; ++y)
            spread(tiles.marks.data + tiles.at(kX, 0, y), 1, tiles.count[kX], across, kReached, kAwake);
        for (size_t k = 0; k < tiles.size(); ++k)
            tiles.marks[k] = uint8_t((tiles.marks[k] & kStill) | ((tiles.marks[k] & kAwake) != 0 ? kReached : 0));
        for (size_t x = 0; x < tiles.count[kX]; ++x)
            spread(tiles.marks.data + x, tiles.count[kX], tiles.count[kY], along, kReached, kAwake);
        if (meets_seam()) wake_all();
    }
    // Lines cannot be cut into runs of cells across a side that is the opposite one too.
    bool meets_seam() const {
        for (Axis a : {kX, kY})
            for (size_t line = 0; periodic(w, a) && line < tiles.count[other(a)]; ++line)
                if (tiles.awake(tiles.at(a, 0, line)) || tiles.awake(tiles.at(a, tiles.count[a] - 1, line)))
                    return true;
        return false;
    }
    void wake_all() {
        for (size_t k = 0; k < tiles.size(); ++k) tiles.marks[k] |= kAwake;
    }

    void put_to_sleep(size_t x, size_t y, StateNumbers moved) {
        const size_t first = x * kTile;
        const size_t columns =
            first + kTile < w.cells[kX] ? kTile : w.cells[kX] + 1 - first; // the last side's faces too
        const size_t end = (y + 1) * kTile < w.cells[kY] ? (y + 1) * kTile : w.cells[kY] + 1;
        for (size_t j = y * kTile; j < end; ++j) {
            const size_t from = place(w, first, j);
            for (const StateNumbers v : {state_of(w, w.velocity[kX]), state_of(w, w.velocity[kY]), moved})
                if (v) memset(v.from(from).data, 0, columns * v.number_size());
        }
    }
};

} // namespace

// More than nothing without gravity, too.
double stir_of_acting(const Water& w) { return stir_of(w, kStrong * w.sleep) + 1e-300; }

void mark_changed(Water& w, const CellRectangle& cells) {
    if (!w.tiles.marks || cells.n_x == 0 || cells.n_y == 0) return;
    const auto tile = [&](Axis a, size_t cell) { // faces there are one more than cells
        return (cell < w.cells[a] ? cell : w.cells[a] - 1) / kTile;
    };
    const size_t end_x = tile(kX, cells.first_x + cells.n_x - 1), end_y = tile(kY, cells.first_y + cells.n_y - 1);
    for (size_t y = tile(kY, cells.first_y); y <= end_y; ++y)
        for (size_t x = tile(kX, cells.first_x); x <= end_x; ++x) w.tiles.marks[w.tiles.at(kX, x, y)] |= kChanged;
}

void choose_awake(Water& w, StateNumbers moved, double dt) {
    WaterTiles& tiles = w.tiles;
    if (!w.surveyed) memset(tiles.marks.data, kChanged, tiles.size());
    w.surveyed = true;
    survey_marked(w, kChanged);
    Chooser chooser{w, dt};
    chooser.mark_stirring();
    chooser.mark_sides();
    chooser.mark_hulls();
    chooser.mark_awake();
    tiles.all_awake = true;
    for (size_t y = 0; y < tiles.count[kY]; ++y)
        for (size_t x = 0; x < tiles.count[kX]; ++x) {
            uint8_t& mark = tiles.marks[tiles.at(kX, x, y)];
            if ((mark & kAwake) != 0) mark &= uint8_t(~kStill);
            else if ((mark & kStill) == 0) chooser.put_to_sleep(x, y, moved), mark |= kStill;
            tiles.all_awake &= (mark & kAwake) != 0;
        }
}

void survey_awake(Water& w) { survey_marked(w, kAwake); }

size_t awake_cells(const Water& w) {
    size_t cells = 0;
    for (size_t y = 0; y < w.tiles.count[kY]; ++y)
        w.tiles.each_run(kX, y, w.cells[kX], [&](size_t first, size_t end) {
            cells += (end - first) * (y * kTile + kTile < w.cells[kY] ? kTile : w.cells[kY] - y * kTile);
        });
    return cells;
}

} // namespace cd
