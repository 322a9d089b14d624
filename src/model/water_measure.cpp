// What can be measured of the water, and what it is at a place.
#include "base/sum.hh"
#include "kernel/water/sweep.hh"
#include "model/water_hull.hh"

namespace cd {

namespace {

double gravity_over_square(const Water& w, Axis a) { return w.gravity / (w.size[a] * w.size[a]); }

// The depth of the water at a face, on a side that of the cell there.
double side_or_face_depth(const Water& w, Axis a, size_t i, size_t j) {
    const size_t at = a == kX ? i : j, n = w.cells[a];
    if (periodic(w, a) || (at > 0 && at < n)) return face_depth(w, a, i, j);
    if (!crossable(w, a, i, j)) return 0;
    const size_t inside = at > 0 ? n - 1 : 0;
    return a == kX ? depth_at(w, inside, j) : depth_at(w, i, inside);
}

// The depth of a face of the cell (i, j) on a side that has a level.
double open_depth(const Water& w, cd_side side, size_t i, size_t j) {
    if (!present(w, i, j)) return 0;
    const double outside = side_value(w.side[side], w.clock.time()) - bed_at(w, i, j);
    return (depth_at(w, i, j) + (outside > 0 ? outside : 0)) / 2;
}

} // namespace

// Small waves along an axis obey h'' = -A h, and the sweep of an explicit step is bounded up to dt = 2 / sqrt(largest
// eigenvalue of A). Row sums bound that: a face gives its cell's row twice g H / dx^2, once on the diagonal and once
// beside it; on an open side both on the diagonal, as the level outside is half a cell off. Axes are swept in turn, and
// what each of them keeps bounded alone they do together.
double stable_dt(const Water& w) {
    double most = 0;
    each_cell(w, [&](size_t i, size_t j) {
        for (Axis a : {kX, kY}) {
            if (periodic(w, a) && w.cells[a] == 1) continue; // its own neighbour: nothing swings
            double sum = 0;
            for (size_t after : {0, 1}) {
                const size_t x = i + (a == kX ? after : 0), y = j + (a == kY ? after : 0), at = a == kX ? x : y;
                const bool on_side = !periodic(w, a) && (at == 0 || at == w.cells[a]);
                if (on_side && !has_level(w.side[side_of(a, at > 0)].kind)) continue;
                const double depth = on_side ? open_depth(w, side_of(a, at > 0), i, j) : face_depth(w, a, x, y);
                sum += 2 * gravity_over_square(w, a) * depth;
            }
            if (sum > most) most = sum;
        }
    });
    return most > 0 ? 2 / sqrt(most) : HUGE_VAL;
}

double volume(const Water& w) {
    Sum depths;
    each_cell(w, [&](size_t i, size_t j) { depths.add(depth_at(w, i, j)); });
    return depths.value() * cell_area(w);
}

namespace {

// A line of cells and the faces between them, with the velocities that a step takes them to have (kernel/water/line.hh,
// 0.): half of a cell's water moves with each of its faces, also at a shore.
struct MovingLine {
    const Water& w;
    Axis a;
    size_t line, n;
    bool ring;

    size_t at(size_t k) const { return a == kX ? place(w, k, line) : place(w, line, k); }
    size_t before(size_t k) const { return k > 0 ? k - 1 : ring ? n - 1 : 0; }
    size_t behind(size_t k) const { return k + 1 < n ? k + 1 : ring ? 0 : k; }
    __attribute__((cold, noinline)) double number(const Array<char>& of, size_t k) const {
        return get_number(w, of, at(k));
    }
    double depth(size_t cell) const { return number(w.depth, cell); }
    double bed(size_t cell) const { return number(w.bed, cell); }
    double mean_depth(size_t face) const { return (depth(before(face)) + depth(face)) / 2; }
    bool conducts(size_t face) const { return face_depth(w, a, a == kX ? face : line, a == kX ? line : face) > 0; }
    // Of an inner face.
    double moves(size_t face) const {
        if (conducts(face)) return number(w.velocity[a], face);
        if (w.momentum == CD_MOMENTUM_LINEAR) return 0;
        const bool is_l = depth(before(face)) > 0;
        const size_t wet = is_l ? before(face) : face, dry = is_l ? face : before(face);
        const size_t beyond = is_l ? before(wet) : behind(wet), other = is_l ? wet : behind(face);
        if (beyond == wet || !conducts(other)) return 0; // beyond is a side, or no water
        const double part = (bed(wet) - bed(beyond)) / (kBeach * (bed(dry) - bed(wet)));
        return part > 0 ? (part < 1 ? part : 1) * number(w.velocity[a], other) : 0;
    }
};

// Depth times velocity^2. Cold: compiled to be small.
__attribute__((cold, noinline)) double moving_face(const Water& w, Axis a, size_t i, size_t j) {
    const size_t face = a == kX ? i : j, n = w.cells[a];
    const MovingLine line{w, a, a == kX ? j : i, n, periodic(w, a)};
    if (!crossable(w, a, i, j) || (line.ring && face == n)) return 0; // the last is the first
    const bool side = !line.ring && (face == 0 || face == n);         // half of a cell
    const double d = side ? line.depth(face > 0 ? n - 1 : 0) / 2 : line.mean_depth(face);
    const double u = side ? line.number(w.velocity[a], face) : line.moves(face);
    return d > 0 ? d * (u * u) : 0; // velocities of dry faces may be any
}

} // namespace

__attribute__((cold)) void energy(const Water& w, double& kinetic, double& potential) {
    Sum moving, lifted;
    for (Axis a : {kX, kY}) each_face(w, a, [&](size_t i, size_t j) { moving.add(moving_face(w, a, i, j)); });
    each_cell(w, [&](size_t i, size_t j) {
        const double d = depth_at(w, i, j);
        if (d != 0) lifted.add(d * (bed_at(w, i, j) + d / 2));
    });
    kinetic = w.density / 2 * cell_area(w) * moving.value();
    potential = w.density * w.gravity * cell_area(w) * lifted.value();
}

double wet_area(const Water& w) {
    size_t wet = 0;
    each_cell(w, [&](size_t i, size_t j) { wet += depth_at(w, i, j) > 0 ? 1 : 0; });
    return double(wet) * cell_area(w);
}

double courant(const Water& w, double dt) {
    double most = 0;
    for (Axis a : {kX, kY})
        each_face(w, a, [&](size_t i, size_t j) {
            const double depth = side_or_face_depth(w, a, i, j);
            if (!(depth > 0)) return;
            const double speed = fabs(get_number(w, w.velocity[a], place(w, i, j))) + sqrt(w.gravity * depth);
            const double number = speed * dt / w.size[a];
            if (number > most) most = number;
        });
    return most;
}

// ---- at a place -----------------------------------------------------------------------------------------------------

Vector normal_of(double slope_x, double slope_y) {
    if (!isfinite(slope_x) || !isfinite(slope_y)) return {0, 0, 1};
    const double of_two = fabs(slope_x) > fabs(slope_y) ? fabs(slope_x) : fabs(slope_y), most = of_two > 1 ? of_two : 1;
    const Vector even{0 - slope_x / most, 0 - slope_y / most, 1 / most}; // whose squares stay in double's range
    return even / length(even);
}

namespace {

// A place between lines 0 to n - 1, counted in their distance: on the way from one to the next by a part of it.
struct Between {
    size_t low, high;
    double part;

    Between(double at, size_t n, bool wraps) : low(0), high(0), part(0) {
        const double last = double(n - 1);
        if (at >= 0 && at <= last) {
            if (n == 1) return;
            low = at < last ? size_t(at) : n - 2;
            high = low + 1;
            part = at - double(low);
        } else if (wraps) {
            low = n - 1;
            part = at < 0 ? at + 1 : at - last;
        } else if (!(at < 0)) {
            low = high = n - 1;
        }
    }
};

// Numbers at the corners of a cell between centres or faces: low and high x at low y, then at high y.
struct Corners {
    double value[4];

    // What stands at corners that are left out: what their neighbours have, in the mean; what lies level stays so.
    void fill(const bool* there) {
        for (int c = 0; c < 4; ++c) {
            if (there[c]) continue;
            const bool along_x = there[c ^ 1], along_y = there[c ^ 2];
            value[c] = along_x && along_y ? (value[c ^ 1] + value[c ^ 2]) / 2
                       : along_x          ? value[c ^ 1]
                       : along_y          ? value[c ^ 2]
                                          : value[c ^ 3];
        }
    }
    static double mix(double p, double q, double part) { return p + part * (q - p); }
    double at(double x, double y) const { return mix(mix(value[0], value[1], x), mix(value[2], value[3], x), y); }
    double rise_x(double y) const { return mix(value[1] - value[0], value[3] - value[2], y); }
    double rise_y(double x) const { return mix(value[2] - value[0], value[3] - value[1], x); }
};

template <class F> void each_corner(const Between& x, const Between& y, F f) {
    for (int c = 0; c < 4; ++c) f(c, c & 1 ? x.high : x.low, c & 2 ? y.high : y.low);
}

} // namespace

// The surface is that of the wet corners, so that it stays level up to the shore, or the bed where that is higher.
WaterSample sample(const Water& w, double place_x, double place_y) {
    const double at[2] = {place_x / w.size[kX], place_y / w.size[kY]};
    const Between x(at[kX] - 0.5, w.cells[kX], periodic(w, kX)), y(at[kY] - 0.5, w.cells[kY], periodic(w, kY));

    bool there[4], wet[4];
    Corners depth, bed, surface;
    each_corner(x, y, [&](int c, size_t i, size_t j) {
        there[c] = present(w, i, j);
        depth.value[c] = depth_at(w, i, j);
        bed.value[c] = bed_at(w, i, j);
        surface.value[c] = bed.value[c] + depth.value[c];
        wet[c] = depth.value[c] > 0;
    });
    if (there[0] || there[1] || there[2] || there[3]) {
        depth.fill(there);
        bed.fill(there);
    }
    WaterSample out{};
    out.depth = depth.at(x.part, y.part);
    const double ground = bed.at(x.part, y.part);
    if (wet[0] || wet[1] || wet[2] || wet[3]) surface.fill(wet);
    const double level = surface.at(x.part, y.part);
    const bool afloat = out.depth > 0 && level > ground;
    const Corners& top = afloat ? surface : bed;
    out.surface = afloat ? level : ground;
    const Vector normal = normal_of(top.rise_x(y.part) / w.size[kX], top.rise_y(x.part) / w.size[kY]);
    out.normal[0] = normal.x;
    out.normal[1] = normal.y;
    out.normal[2] = normal.z;

    for (Axis a : {kX, kY}) {
        Corners velocity;
        const Between along(at[a], w.cells[a] + 1, false);
        const Between &face_x = a == kX ? along : x, &face_y = a == kX ? y : along;
        each_corner(face_x, face_y, [&](int c, size_t i, size_t j) {
            velocity.value[c] = get_number(w, w.velocity[a], place(w, i, j));
        });
        out.velocity[a] = velocity.at(face_x.part, face_y.part);
    }
    return out;
}

} // namespace cd
