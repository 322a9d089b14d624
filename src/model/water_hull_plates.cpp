// What hulls see of the water, plate by plate, and what that holds them up by: see water_hull_plates.hh. (model.md, 51)
#include "model/water_hull_plates.hh"

namespace cd {

namespace {

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

} // namespace

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
    Around<3> middle;
    find_cells(w, pose.x, pose.y, middle);
    if (!middle.any) return;
    Plate p;
    p.area = step_long * step_wide;
    const auto look = [&] {
        p.x = pose.x + (p.ahead * pose.heading[0] - p.port * pose.heading[1]);
        p.y = pose.y + (p.ahead * pose.heading[1] + p.port * pose.heading[0]);
        p.z = pose.z + ((pose.pitch * p.ahead + pose.roll * p.port) + p.height * (1 + 1 / kStiff));
        find_cells(w, p.x, p.y, p.cells);
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
