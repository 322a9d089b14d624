// What hulls see of the water, plate by plate, and what that holds them up by: see water_hull_plates.hh. (model.md, 51)
#include "model/water_hull_plates.hh"

namespace cd {

namespace {

// Of cells that are not there none, in proportion.
template <int n> void keep_present(const Water& w, Around<n>& out) {
    if (!w.mask) return;
    double sum = 0;
    for (int c = 0; c < n * n; ++c) {
        if (!present(w, out.i[c % n], out.j[c / n])) out.weight[c] = 0;
        sum += out.weight[c];
    }
    out.any = sum > 0;
    for (int c = 0; c < n * n && out.any; ++c) out.weight[c] /= sum;
}

// Gives what cells behind walls would bear to their mirror images before them, as at the sides of a scene.
__attribute__((noinline)) void mirror_at_walls(const Water& w, Around<3>& cells) {
    const size_t i = cells.i[1], j = cells.j[1];
    const auto along_x = [&](int k, int row) {
        return k != 1 && cells.i[k] != i && walled(w, kX, i, cells.j[row], k == 2);
    };
    const auto along_y = [&](int k, int row) {
        return row != 1 && cells.j[row] != j && walled(w, kY, cells.i[k], j, row == 2);
    };
    for (int c = 0; c < 9; ++c) {
        const int k = c % 3, row = c / 3;
        const bool own_x = along_x(k, 1), own_y = along_y(1, row); // in the point's own lines
        const bool is_parted = (own_x || along_y(k, row)) && (own_y || along_x(k, row));
        if (!is_parted) continue;
        cells.weight[3 * (own_y || !own_x ? 1 : row) + (own_x || !own_y ? 1 : k)] += cells.weight[c];
        cells.weight[c] = 0;
    }
}

// The water over the cells that bear a plate. depth: a plane of the state's numbers.
template <class T> void look_at_water(const Water& w, const T* depth, Plate& p) {
    double beds = 0, depths = 0;
    for (int row = 0; row < 3; ++row) { // sums of rows need not wait for each other
        const double* const weight = p.cells.weight + 3 * row;
        double bed = 0, water = 0;
        for (int k = 0; k < 3; ++k) {
            const size_t at = place(w, p.cells.i[k], p.cells.j[row]);
            bed += weight[k] * double(numbers<T>(w.bed)[at]);
            water += weight[k] * double(depth[at]);
        }
        beds += bed, depths += water;
    }
    p.bed = beds, p.surface = beds + depths;
}

constexpr double kReach = 2; // cells that what bears a plate reaches from its middle

// The cells that lie so near to a hull along an axis: [first, end).
struct Span {
    size_t first, end;

    Span(const Water& w, size_t index, const HullPose& pose, Axis a, double cells) {
        const Hull& h = hull(w, index);
        const double at = (a == kX ? pose.x : pose.y) / w.size[a], n = double(w.cells[a]);
        const double reach = 0.5 * (h.length + h.width) / w.size[a] + cells;
        const double low = at - reach, high = at + reach;
        const bool all = periodic(w, a) && !(low >= 0 && high < n);
        first = !all && low > 0 && low < n ? size_t(low) : 0;
        end = !all && high >= 0 && high < n ? size_t(high) + 1 : w.cells[a];
    }
};

bool is_near(const Water& w, size_t index, const HullPose& pose, double cells, bool closed) {
    const Span x(w, index, pose, kX, cells), y(w, index, pose, kY, cells);
    const auto has = [&](const Array<uint8_t>& bytes, int byte) {
        bool found = false;
        for (size_t j = y.first; bytes && !found && j < y.end; ++j)
            found = memchr(&bytes[byte_place(w, x.first, j)], byte, x.end - x.first) != nullptr;
        return found;
    };
    return has(w.wall[kX], 1) || has(w.wall[kY], 1) || (closed && has(w.mask, 0));
}

} // namespace

bool is_near_walls(const Water& w, size_t index, const HullPose& pose, double cells) {
    return is_near(w, index, pose, cells, false);
}

bool is_near_closed(const Water& w, size_t index, const HullPose& pose, double cells) {
    return is_near(w, index, pose, cells, true);
}

void find_cells(const Water& w, double x, double y, bool walls, Around<3>& out) {
    double along[3], across[3];
    out.any = spline_around(x, w.size[kX], w.cells[kX], periodic(w, kX), out.i, along) &&
              spline_around(y, w.size[kY], w.cells[kY], periodic(w, kY), out.j, across);
    if (!out.any) return;
    weigh(out, along, across);
    if (walls) mirror_at_walls(w, out);
    keep_present(w, out);
}

Around<2> cells_between(const Water& w, double x, double y) {
    Around<2> out{};
    double along[2], across[2];
    if (between(x, w.size[kX], 0.5, w.cells[kX], w.cells[kX], periodic(w, kX), out.i, along) &&
        between(y, w.size[kY], 0.5, w.cells[kY], w.cells[kY], periodic(w, kY), out.j, across))
        weigh(out, along, across), keep_present(w, out);
    return out;
}

void walk_plates(const Water& w, size_t index, const HullPose& pose, const void* depth,
                 void (*see)(void* to, const Plate& p), void* to) {
    const Hull& h = hull(w, index);
    const HullShape& shape = w.hull_shape;
    const double* const floors = plate_heights(w, index);
    const double most = 0.5 * cell_size(w.size, w.cells);
    const double long_of = h.length / double(shape.along), wide = h.width / double(shape.across);
    const auto parts = [&](double length) { // none longer than half a cell
        const double enough = -whole_below(length / most * (kAlmostWhole - 1));
        return enough > 1 ? size_t(enough) : 1;
    };
    const size_t n = parts(long_of), m = parts(wide);
    const double step_long = long_of / double(n), step_wide = wide / double(m);
    const bool walls = is_near_walls(w, index, pose, kReach);
    Around<3> middle;
    find_cells(w, pose.x, pose.y, walls, middle);
    if (!middle.any) return;
    Plate p;
    p.area = step_long * step_wide;
    p.half[0] = 0.5 * step_long, p.half[1] = 0.5 * step_wide;
    const auto look = [&] {
        p.x = pose.x + (p.ahead * pose.heading[0] - p.port * pose.heading[1]);
        p.y = pose.y + (p.ahead * pose.heading[1] + p.port * pose.heading[0]);
        p.z = pose.z + ((pose.pitch * p.ahead + pose.roll * p.port) + p.height * (1 + 1 / kStiff));
        find_cells(w, p.x, p.y, walls, p.cells);
        if (!p.cells.any) p.cells = middle;
        by_precision(w, [&](auto zero) { look_at_water(w, static_cast<const decltype(zero)*>(depth), p); });
        see(to, p);
    };
    for (size_t j = 0; j < shape.across; ++j)
        for (size_t i = 0; i < shape.along; ++i) {
            p.height = floors[j * shape.along + i];
            if (p.height < 0) continue;
            for (size_t l = 0; l < m; ++l) {
                p.port = (double(j * m + l) + 0.5) * step_wide - 0.5 * h.width;
                for (size_t k = 0; k < n; ++k) {
                    p.ahead = (double(i * n + k) + 0.5) * step_long - 0.5 * h.length;
                    look();
                }
            }
        }
}

HullContact::HullContact(const Water& w, size_t index, const HullPose& pose) {
    const double head = w.density * w.gravity;
    each_plate(w, index, pose, [&](const Plate& p) {
        const double sunk = p.sunk();
        if (!(sunk > 0)) return;
        const double stiff = head * (kStiff * p.area), force = stiff * sunk;
        energy += 0.5 * (force * sunk);
        push[0] += force, push[1] += force * p.ahead, push[2] += force * p.port;
        slope[0] += stiff, slope[1] += stiff * p.ahead, slope[2] += stiff * p.port;
        slope[3] += stiff * (p.ahead * p.ahead), slope[4] += stiff * (p.ahead * p.port);
        slope[5] += stiff * (p.port * p.port);
        if (p.bed > p.z) by_bed += stiff * (p.bed - p.z);
    });
}

} // namespace cd
