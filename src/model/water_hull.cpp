// What hulls are, where they lie, and the water's surface without them: see water_hull.hh.
#include "base/sum.hh"
#include "model/water_hull_plates.hh"

namespace cd {

double hull_area(const Water& w, size_t index) {
    const Hull& h = hull(w, index);
    size_t there = 0;
    for (size_t k = 0; k < w.hull_shape.plates(); ++k) there += plate_heights(w, index)[k] >= 0 ? 1 : 0;
    return h.length * h.width * (double(there) / double(w.hull_shape.plates()));
}

double draft_of(const Water& w, size_t index) { return hull(w, index).mass / (w.density * hull_area(w, index)); }

void hull_extent(const Water& w, size_t index, const double (&heading)[2], Axis a, double (&out)[2]) {
    const Hull& h = hull(w, index);
    const HullShape& shape = w.hull_shape;
    const double ahead = a == kX ? heading[0] : heading[1], port = a == kX ? -heading[1] : heading[0];
    const double long_of = h.length / double(shape.along), wide = h.width / double(shape.across);
    const double half = 0.5 * (fabs(ahead) * long_of + fabs(port) * wide);
    out[0] = out[1] = 0;
    for (size_t j = 0; j < shape.across; ++j)
        for (size_t i = 0; i < shape.along; ++i) {
            if (plate_heights(w, index)[j * shape.along + i] < 0) continue;
            const double middle = ahead * ((double(i) + 0.5) * long_of - 0.5 * h.length) +
                                  port * ((double(j) + 0.5) * wide - 0.5 * h.width);
            if (half - middle > out[0]) out[0] = half - middle;
            if (half + middle > out[1]) out[1] = half + middle;
        }
}

bool lay_on_water(Water& w, size_t index) {
    Hull& h = hull(w, index);
    h.pitch = h.roll = 0;
    double low = HUGE_VAL, area = 0;
    each_plate(w, index, HullPose(h), [&](const Plate& p) {
        if (p.surface - (p.z - h.z) < low) low = p.surface - (p.z - h.z);
        area += p.area;
    });
    if (!(area > 0) || !(w.gravity > 0)) return false;
    const double sunk = h.mass / (w.density * area * kStiff); // once all plates bear it
    h.z = low - sunk;
    // Steps that last long for what its weight and stiffness are, from rest each: they end where all is in balance.
    HullPose pose(h);
    const double dt = 1e3 * sqrt(sunk / w.gravity), outside[3] = {h.force[2], h.force[4], h.force[5]};
    h.force[2] = h.force[4] = h.force[5] = 0;
    for (int k = 0; k < 8; ++k) {
        double v[3] = {0, 0, 0};
        heave(w, index, pose, v, dt);
    }
    h.force[2] = outside[0], h.force[4] = outside[1], h.force[5] = outside[2];
    h.z = pose.z, h.pitch = pose.pitch, h.roll = pose.roll;
    h.lies[0] = h.z + sunk, h.lies[1] = h.pitch, h.lies[2] = h.roll;
    return true;
}

namespace {

constexpr int kLaunchings = 32; // of which each leaves at most kStiff / (1 + kStiff) of what is not in balance

// Lets a hull press the water down as it does in time, from the depths in work.before. work.load: by how much less
// there is now.
void sink(Water& w, size_t index, const HullWork& work) {
    const StateNumbers depth = state_of(w, w.depth), before{work.before, is_wide(w)};
    memset(work.load, 0, w.plane * sizeof(double));
    for (int k = 0; k < kLaunchings; ++k) {
        CellBox box;
        press(w, index, w.depth.data, 0, work.own[0], work.own[1], [&](size_t i, size_t j) { box.see(i, j); });
        box.each([&](size_t i, size_t j) {
            const size_t at = place(w, i, j);
            const double all = before[at], more = (work.own[0][at] - work.load[at]) / (1 + kStiff);
            const double less = work.load[at] + more;
            work.load[at] = less < all ? less : all;
            depth.put(at, all - work.load[at]);
            work.own[0][at] = work.own[1][at] = 0;
        });
        lay_on_water(w, index);
    }
}

// Hands what the water has lost since `before` to all that stood within a height of a level. False where that leaves
// the range of depths.
bool hand_on(Water& w, double level, double height, const HullWork& work) {
    const StateNumbers depth = state_of(w, w.depth), before{work.before, is_wide(w)}, bed = state_of(w, w.bed);
    const auto each_that_takes = [&](auto f) {
        each_cell(w, [&](size_t i, size_t j) {
            const size_t at = place(w, i, j);
            if (before[at] > 0 && fabs(bed[at] + before[at] - level) <= height) f(at);
        });
    };
    Sum lost;
    double count = 0;
    each_cell(w, [&](size_t i, size_t j) { lost.add(before[place(w, i, j)] - depth[place(w, i, j)]); });
    each_that_takes([&](size_t) { count += 1; });
    if (!(lost.value() > 0)) return true;
    const double more = lost.value() / count;
    bool good = count > 0;
    each_that_takes([&](size_t at) { good &= depth[at] + more <= most_of(w); });
    if (!good) return false;
    double left = 0; // of what goes to one cell rounding leaves to the next, or takes from it as far as there is water
    each_that_takes([&](size_t at) {
        const double had = depth[at], has = had + (more + left);
        depth.put(at, has > 0 ? has : 0);
        left -= depth[at] - (had + more);
    });
    w.account.add(-left * cell_area(w));
    return true;
}

} // namespace

bool launch(Water& w, size_t index, const HullWork& work) {
    if (!lay_on_water(w, index)) return false;
    memcpy(work.before, w.depth.data, w.depth.bytes());
    for (double* own : work.own) memset(own, 0, w.plane * sizeof(double)); // no step may have been made
    double level = 0;
    each_plate(w, index, HullPose(hull(w, index)), [&](const Plate& p) { level += p.area * p.surface; });
    level /= hull_area(w, index);
    sink(w, index, work);
    if (!hand_on(w, level, draft_of(w, index), work)) memcpy(w.depth.data, work.before, w.depth.bytes());
    lay_on_water(w, index);
    settle_hulls(w, work);
    return true;
}

void hull_energy(const Water& w, double& kinetic, double& potential) {
    Sum moving, lying;
    for (size_t k = 0; k < w.hull_shape.count; ++k) {
        const Hull& h = hull(w, k);
        if (!(h.mass > 0)) continue;
        double mass[6];
        inertia(h, mass);
        for (int way = 0; way < 6; ++way) moving.add(0.5 * (mass[way] * (h.velocity[way] * h.velocity[way])));
        lying.add(h.mass * (w.gravity * h.z));
        lying.add(HullContact(w, k, HullPose(h)).energy);
    }
    kinetic = moving.value(), potential = lying.value();
}

double head_at(const Water& w, double x, double y) {
    // The plates' loads lie in cells, as steps hand them on.
    const Around<2> around = cells_between(w, x, y);
    double sum = sample(w, x, y).surface;
    if (!around.any) return sum;
    for (size_t k = 0; k < w.hull_shape.count; ++k) {
        if (!(hull(w, k).mass > 0)) continue;
        each_plate(w, k, HullPose(hull(w, k)), [&](const Plate& p) {
            const double head = p.head() * (p.area / cell_area(w));
            if (!(head > 0)) return;
            p.cells.each([&](size_t i, size_t j, double weight) {
                around.each([&](size_t m, size_t n, double own) {
                    if (i == m && j == n) sum += own * (weight * head);
                });
            });
        });
    }
    return sum;
}

bool hulls_finite(const Water& w) {
    bool finite = true;
    for (size_t k = 0; k < w.hull_shape.count; ++k) {
        const double* const numbers = w.hulls.data + k * w.hull_shape.numbers();
        for (size_t i = 0; i < kHullNumbers; ++i) finite &= isfinite(numbers[i]) != 0;
    }
    return finite;
}

void reset_hulls(Water& w) {
    for (size_t k = 0; k < w.hull_shape.count; ++k) {
        Hull& h = hull(w, k);
        for (int way = 0; way < 6; ++way) h.velocity[way] = h.water[way] = 0;
        h.lies[0] = h.lies[1] = h.lies[2] = 0;
        h.owed = h.x = h.y = h.z = h.pitch = h.roll = h.heading[1] = 0;
        h.heading[0] = 1;
    }
}

} // namespace cd
