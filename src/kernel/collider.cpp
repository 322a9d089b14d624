// Beds, callbacks, ways out: the same for all instructions, since this file is compiled once.
#include "kernel/collider.hh"

#include <math.h>

namespace cd {

namespace {

constexpr double kFar = 1e60;         // as far as places are
constexpr double kAsked = 0.1 * kFar; // as far along an axis as callbacks are asked: they can tell how far that is
constexpr double kNormalError = 1e-3; // of a callback's normal, in its length

// Normals are parallel, or all in one plane, where their volume, or the square of their area, is less than this.
constexpr double kFlat = 1e-6;

// Of the three heights about a place along one axis, what their differences from the middle one count for: the height
// beyond the middle one, and its slope per spacing.
struct Weights {
    size_t at[3];
    double height[2], slope[2]; // of the left and of the right one

    Weights(double place, size_t count) {
        const double end = double(count) - 0.5;
        const double inside = place > -0.5 ? (place < end ? place : end) : -0.5; // beyond it the bed is level
        const size_t nearest = size_t(inside + 0.5), i = nearest < count ? nearest : count - 1;
        const double f = inside - double(i);
        const bool round = fabs(f) < kRoundCrease;
        const double share = round ? (f * f + kRoundCrease * kRoundCrease) / (4 * kRoundCrease) : fabs(f) / 2;
        const double turn = round ? f / (2 * kRoundCrease) : f < 0 ? -0.5 : 0.5;
        at[0] = i > 0 ? i - 1 : 0, at[1] = i, at[2] = i + 1 < count ? i + 1 : i;
        height[0] = share - f / 2, height[1] = share + f / 2;
        slope[0] = turn - 0.5, slope[1] = turn + 0.5;
    }
    double height_of(const double* values) const {
        return values[1] + (height[0] * (values[0] - values[1]) + height[1] * (values[2] - values[1]));
    }
    double slope_of(const double* values) const {
        return slope[0] * (values[0] - values[1]) + slope[1] * (values[2] - values[1]);
    }
};

} // namespace

double gap_to_bed(const Obstacle& bed, const double* x, double time, double* normal) {
    const int up = bed.rows > 1 ? 2 : 1;
    const auto along = [&](int k) { return (x[k] - bed.place(k, time)) / bed.way[k]; };
    const Weights of_columns(along(0), bed.columns), of_rows(up == 2 ? along(1) : 0, bed.rows);
    double heights[3], slopes[3]; // of the three rows
    for (int j = 0; j < 3; ++j) {
        const double* const row = bed.heights + of_rows.at[j] * bed.columns;
        const double values[3] = {row[of_columns.at[0]], row[of_columns.at[1]], row[of_columns.at[2]]};
        heights[j] = of_columns.height_of(values), slopes[j] = of_columns.slope_of(values);
    }
    const double slope[2] = {of_rows.height_of(slopes) / bed.way[0],
                             up == 2 ? of_rows.slope_of(heights) / bed.way[1] : 0};
    const double upward = 1 / sqrt(1 + (slope[0] * slope[0] + slope[1] * slope[1]));
    normal[1] = normal[2] = 0;
    for (int k = 0; k < up; ++k) normal[k] = -slope[k] * upward;
    normal[up] = upward;
    return ((x[up] - bed.place(up, time)) - of_rows.height_of(heights)) * upward - bed.radius;
}

__attribute__((cold)) void way_off_line(const double* way, size_t components, double* out) {
    size_t least = 0;
    double square = 0, left = 0;
    for (size_t k = 0; k < components; ++k) {
        square += way[k] * way[k];
        if (fabs(way[k]) < fabs(way[least])) least = k;
    }
    for (size_t k = 0; k < components; ++k) out[k] = k == least ? 1 : 0;
    if (!(square > 0) || components == 1) return;
    const double share = way[least] / square;
    for (size_t k = 0; k < components; ++k) out[k] -= share * way[k], left += out[k] * out[k];
    for (size_t k = 0; k < components; ++k) out[k] = 1 / sqrt(left) * out[k];
}

__attribute__((cold)) void add_force(double* load, const double* force, const double* x) {
    const double all[kLoadNumbers] = {force[0],
                                      force[1],
                                      force[2],
                                      x[1] * force[2] - x[2] * force[1],
                                      x[2] * force[0] - x[0] * force[2],
                                      x[0] * force[1] - x[1] * force[0]};
    for (size_t k = 0; k < kLoadNumbers; ++k)
        if (isfinite(load[k] + all[k])) load[k] += all[k];
}

// What a node forgot of its velocity has not been given by what it came out of, nor what its strand then lost: that is
// shared out by masses and how far inside they were. (Whatever touches steps with lambda = 1, so w is the velocity before.)
__attribute__((cold)) void add_loads(const PushedStrand& of, const Obstacle* colliders, double* loads) {
    double weights = 0, slowed[3] = {};
    const auto each = [&](auto f) { // f(node, contact, push, collider, mass times how far inside it was)
        for (size_t lane = 0; lane < of.of_strand; ++lane)
            for (size_t i = 0; i < of.node_count; ++i)
                for (size_t k = 0; k < of.collider_count; ++k) {
                    const size_t node = lane + i * of.node_step, at = i * of.collider_count + k;
                    const size_t contact = lane + at * of.contact_step;
                    const double depth = of.before[contact] < 0 ? -of.before[contact] : 0;
                    f(node, contact, lane + at * kPushNumbers * of.lanes, k, of.mass[node] * of.on[contact] * depth);
                }
    };
    each([&](size_t node, size_t contact, size_t, size_t k, double weight) {
        weights += weight;
        const double mass = k == 0 && of.mobility[node] > 0 ? of.mass[node] : 0;
        for (size_t c = 0; c < 3; ++c)
            slowed[c] += mass * (of.w[node + c * of.lanes] - of.next[node + c * of.lanes]) -
                         of.rate * weight * of.normal[contact + c * of.lanes];
    });
    each([&](size_t node, size_t contact, size_t push, size_t k, double weight) {
        double force[3], x[3];
        for (size_t c = 0; c < 3; ++c) {
            const double less =
                of.rate * weight * of.normal[contact + c * of.lanes] + (weight > 0 ? weight / weights * slowed[c] : 0);
            force[c] = of.per_impulse * (less - of.push[push + c * of.lanes]);
            x[c] = of.y[node + c * of.lanes];
        }
        add_force(loads + colliders[k].index * kLoadNumbers, force, x);
    });
}

// Contacts are counted in one after the other: where what takes the node out of those before does not take it out of
// this one, the least that does lies in its plane; where that does not take it out of one before, on the edge of both,
// and then in a corner of three (Seidel 1991).
__attribute__((cold)) static void least_way_out(const Touching& of, size_t lane, double* out) {
    struct Way {
        double x, y, z;
    };
    const auto dot = [](Way a, Way b) { return (a.x * b.x + a.y * b.y) + a.z * b.z; };
    const auto cross = [](Way a, Way b) {
        return Way{a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
    };
    const auto normal = [&](size_t k) {
        const double* const n = of.normal + k * of.contact_step + lane;
        return Way{n[0], n[of.lanes], n[2 * of.lanes]};
    };
    const auto speed = [&](size_t k) { return -of.rate * of.before[k * of.contact_step + lane]; };
    Way way = {};
    const auto lacks = [&](size_t k, double allowed) {
        return of.on[k * of.contact_step + lane] > 0 && speed(k) - dot(normal(k), way) > allowed;
    };
    const double error = of.error[lane];
    for (size_t a = 0; a < of.count; ++a) {
        if (!lacks(a, dot(way, way) > 0 ? error : 0)) continue;
        const Way n = normal(a);
        way = {speed(a) * n.x, speed(a) * n.y, speed(a) * n.z};
        for (size_t b = 0; b < a; ++b) {
            if (!lacks(b, error)) continue;
            const Way m = normal(b), edge = cross(n, m);
            for (size_t c = 0; c <= b; ++c) { // at first their edge, then corners with one before
                if (c > 0 && !lacks(c - 1, error)) continue;
                const Way o = c == 0 ? edge : normal(c - 1), mo = cross(m, o), on = cross(o, n);
                const double volume = dot(n, mo), third = c == 0 ? 0 : speed(c - 1);
                if (!(fabs(volume) > kFlat)) continue;
                const double p = speed(a) / volume, q = speed(b) / volume, r = third / volume;
                way = {(p * mo.x + q * on.x) + r * edge.x, (p * mo.y + q * on.y) + r * edge.y,
                       (p * mo.z + q * on.z) + r * edge.z};
            }
        }
    }
    out[lane] = way.x, out[lane + of.lanes] = way.y, out[lane + 2 * of.lanes] = way.z;
}
void least_ways_out(const Touching& of, double* out) {
    for (size_t lane = 0; lane < of.lanes; ++lane) least_way_out(of, lane, out);
}

void ask(const Obstacle& of, double time, size_t count, size_t components, double* places, double* distances,
         double* normals, BadAnswer& bad) {
    const size_t numbers = count * components;
    for (size_t i = 0; i < numbers; ++i) {
        const double from = places[i] - of.place(int(i % components), time);
        // Of a guess that is nowhere near, so far; and of a state that is no number.
        places[i] = fabs(from) <= kAsked ? from : isnan(from) ? 0 : copysign(kAsked, from);
        normals[i] = NAN;
    }
    for (size_t i = 0; i < count; ++i) distances[i] = NAN;
    of.callback->distance(of.callback->user, time, count, components, places, distances, normals);
    for (size_t i = 0; i < count; ++i) {
        double* const normal = normals + i * components;
        double square = 0;
        for (size_t k = 0; k < components; ++k) square += normal[k] * normal[k];
        const double length = sqrt(square);
        if (fabs(distances[i]) <= kFar && fabs(length - 1) <= kNormalError) {
            for (size_t k = 0; k < components; ++k) normal[k] = normal[k] / length;
            distances[i] = distances[i] - of.radius;
            continue;
        }
        if (bad.collider == SIZE_MAX) bad = {of.index, distances[i], length};
        for (size_t k = 0; k < components; ++k) normal[k] = k == 0 ? 1 : 0;
        distances[i] = kFar;
    }
}

} // namespace cd
