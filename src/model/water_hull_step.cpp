// Steps of hulls: see water_hull.hh. (model.md, 52 to 56)
#include "base/sum.hh"
#include "model/water_hull_plates.hh"

namespace cd {

void inertia(const Hull& h, double (&out)[6]) {
    const double by_length = h.mass * (h.length * h.length) / 12, by_width = h.mass * (h.width * h.width) / 12;
    out[0] = out[1] = out[2] = h.mass;
    out[3] = by_length + by_width, out[4] = by_length, out[5] = by_width;
}

// ---- around the sweeps ----------------------------------------------------------------------------------------------

namespace {

template <class F> void each_hull(const Water& w, F f) {
    for (size_t k = 0; k < w.hull_shape.count; ++k)
        if (hull(w, k).mass > 0) f(k);
}

// By how much the water's head, its surface and what hulls press with, rises across a face, in the mean of before and
// after a sweep; beside a dry cell, which gives way to no load, the surface alone. Closed faces, and the scene's sides,
// have the same head on both sides.
template <class T>
double rise_across(const Water& w, const HullWork& work, const T* before, Axis a, size_t i, size_t j) {
    const size_t k = a == kX ? i : j, n = w.cells[a];
    if (!periodic(w, a) && (k == 0 || k == n)) return 0;
    if (!crossable(w, a, i, j)) return 0;
    const size_t behind = k > 0 ? k - 1 : n - 1, ahead = k < n ? k : 0;
    const size_t from = a == kX ? place(w, behind, j) : place(w, i, behind);
    const size_t to = a == kX ? place(w, ahead, j) : place(w, i, ahead);
    const T *const after = numbers<T>(w.depth), *const bed = numbers<T>(w.bed);
    const auto mean = [&](size_t at) { return 0.5 * (double(before[at]) + double(after[at])); };
    const auto load = [&](size_t at) { return work.load[at] + work.stiff[at] * mean(at); };
    const double surfaces = (double(bed[to]) + mean(to)) - (double(bed[from]) + mean(from));
    return mean(from) > 0 && mean(to) > 0 ? surfaces + (load(to) - load(from)) : surfaces;
}

} // namespace

void load_hulls(const Water& w, HullWork& work, bool first) {
    memset(work.load, 0, w.plane * sizeof(double));
    memset(work.stiff, 0, w.plane * sizeof(double));
    if (first) {
        memset(work.own[0], 0, w.plane * sizeof(double));
        memset(work.own[1], 0, w.plane * sizeof(double));
        memset(work.impulse, 0, w.hull_shape.count * 3 * sizeof(double));
    }
    memcpy(work.before, w.depth.data, w.depth.bytes());
    const StateNumbers depth = state_of(w, w.depth);
    CellBox box;
    each_hull(w, [&](size_t k) {
        press(w, k, w.depth.data, work.run, work.load, work.stiff, [&](size_t i, size_t j) { box.see(i, j); });
    });
    box.each([&](size_t i, size_t j) {
        const size_t at = place(w, i, j);
        work.load[at] -= work.stiff[at] * depth[at];
    });
}

void feel_water(const Water& w, HullWork& work, Axis a, double theta, double dt) {
    const StateNumbers before{work.before, is_wide(w)};
    each_hull(w, [&](size_t k) {
        const HullPose pose(hull(w, k));
        const double draft = draft_of(w, k);
        double* const impulse = work.impulse + 3 * k;
        each_plate(w, k, pose, work.before, [&](const Plate& p) {
            if (!near_water(p, draft, work.run)) return;
            double rise = 0, slope = 0;
            before.stored_state([&](const auto* was) {
                const auto* const is = static_cast<decltype(was)>(state_of(w, w.depth).data);
                p.cells.each([&](size_t i, size_t j, double weight) {
                    rise += weight * (double(is[place(w, i, j)]) - double(was[place(w, i, j)]));
                });
            });
            each_difference(w, a, p.x, p.y, [&](size_t i, size_t j, double weight) {
                const double here =
                    before.stored_state([&](const auto* was) { return rise_across(w, work, was, a, i, j); });
                slope += weight * here / w.size[a];
            });
            const double head = p.head() + theta * (kStiff * rise);
            const double push = -(w.density * w.gravity * dt) * (p.area * head * slope);
            impulse[a] += push;
            impulse[2] += (a == kX ? pose.y - p.y : p.x - pose.x) * push;
        });
    });
}

// ---- heave ----------------------------------------------------------------------------------------------------------

namespace {

constexpr int kMostHeaves = 40;        // iterations of heave
constexpr double kLeastGain = 0x1p-60; // of one, over the energies: less is rounding

// Solves the symmetric system of three, whose diagonal is positive, for x.
void solve(const double (&a)[6], const double (&b)[3], double (&x)[3]) {
    const double l10 = a[1] / a[0], l20 = a[2] / a[0], d1 = a[3] - l10 * a[1], e = a[4] - l10 * a[2], l21 = e / d1;
    const double d2 = (a[5] - l20 * a[2]) - l21 * e, y1 = b[1] - l10 * b[0], y2 = (b[2] - l20 * b[0]) - l21 * y1;
    x[2] = y2 / d2;
    x[1] = y1 / d1 - l21 * x[2];
    x[0] = (b[0] / a[0] - l10 * x[1]) - l20 * x[2];
}

} // namespace

// Minimizes inertia (v - v0)^2 / 2 - dt force v + energy(pose + dt v) by Newton's method, which the piecewise quadratic
// energy lets end after a few exact steps. One that does not lower the function is halved, as long as the slope that it
// begins with promises more than rounding: in the air it is that of the fall alone, which may end far below the bed.
void heave(const Water& w, size_t index, HullPose& pose, double (&v)[3], double dt) {
    const Hull& h = hull(w, index);
    double all[6];
    inertia(h, all);
    const double mass[3] = {all[2], all[4], all[5]}, v0[3] = {v[0], v[1], v[2]};
    const double force[3] = {h.force[2] - h.mass * w.gravity, h.force[4], h.force[5]};
    const auto pose_at = [&](const double (&u)[3]) {
        HullPose out = pose;
        out.z += dt * u[0], out.pitch += dt * u[1], out.roll += dt * u[2];
        return out;
    };
    const auto value = [&](const double (&u)[3], const HullContact& c) {
        double sum = c.energy;
        for (int k = 0; k < 3; ++k) sum += 0.5 * (mass[k] * (u[k] - v0[k]) * (u[k] - v0[k])) - dt * (force[k] * u[k]);
        return sum;
    };
    double moving = 0; // energy, to measure rounding by
    for (int k = 0; k < 3; ++k) moving += 0.5 * (mass[k] * (v0[k] * v0[k]));
    for (double& u : v) u = 0; // from where it is: a long step may lead so far that rounding hides the way back
    HullContact contact(w, index, pose);
    double now = value(v, contact);
    for (int iteration = 0; iteration < kMostHeaves; ++iteration) {
        double system[6], right[3], change[3], next[3];
        for (int k = 0; k < 6; ++k) system[k] = dt * dt * contact.slope[k];
        system[0] += mass[0], system[3] += mass[1], system[5] += mass[2];
        for (int k = 0; k < 3; ++k) right[k] = dt * (force[k] + contact.push[k]) - mass[k] * (v[k] - v0[k]);
        solve(system, right, change);
        double part = 1, gain = 0;
        for (int k = 0; k < 3; ++k) gain += 0.5 * (right[k] * change[k]);
        const double least = kLeastGain * (contact.energy + moving);
        if (!(gain > least)) break;
        bool better = false;
        for (; !better && part * gain > least; part /= 2) {
            for (int k = 0; k < 3; ++k) next[k] = v[k] + part * change[k];
            const HullContact there(w, index, pose_at(next));
            const double then = value(next, there);
            better = then < now;
            if (!better) continue;
            now = then, contact = there;
            for (int k = 0; k < 3; ++k) v[k] = next[k];
        }
        if (!better) break;
    }
    pose = pose_at(v);
}

// ---- along, across and round ----------------------------------------------------------------------------------------

namespace {

// The faces of an axis that a point lies between, of lines that no wall parts from it.
__attribute__((noinline)) Around<2> faces_around(const Water& w, Axis a, double x, double y) {
    Around<2> out{};
    double along[2], across[2];
    if (!between(x, w.size[kX], a == kX ? 0 : 0.5, w.cells[kX], faces_along(w, a, kX), periodic(w, kX), out.i, along) ||
        !between(y, w.size[kY], a == kY ? 0 : 0.5, w.cells[kY], faces_along(w, a, kY), periodic(w, kY), out.j, across))
        return out;
    const size_t *const faces = a == kX ? out.i : out.j, *const lines = a == kX ? out.j : out.i;
    double(&weight)[2] = a == kX ? across : along;
    if (lines[0] != lines[1] && walled_beside(w, a, faces[0], lines[1], false)) {
        weight[0] = weight[0] < 0.5 ? 0 : 1;
        weight[1] = 1 - weight[0];
    }
    weigh(out, along, across);
    return out;
}

// The water that a hull drags along an axis: how fast it runs, what mass an impulse on it moves.
struct Dragged {
    double speed = 0, inverse_mass = 0, sum = 0; // sum: of shares times depths
    CellBox box;
};

struct Mover {
    Water& w;
    HullWork& work;
    double dt;
    size_t index;
    Hull& h = hull(w, index);
    double mass[6] = {};
    double given[2] = {}; // impulse handed to the water
    Dragged water[2] = {};

    // The faces under the hull in `work.own`, by how much of it presses on them.
    void find_water(const HullPose& pose) {
        bool touches = false;
        each_plate(w, index, pose, [&](const Plate& p) {
            if (!(p.sunk() > 0)) return;
            touches = true;
            for (Axis a : {kX, kY})
                faces_around(w, a, p.x, p.y).each([&](size_t i, size_t j, double weight) {
                    work.own[a][place(w, i, j)] += weight * p.area;
                    water[a].box.see(i, j);
                });
        });
        if (!touches) return;
        for (Axis a : {kX, kY}) {
            double squares = 0, moving = 0, sum = 0;
            each_share(a, [&](size_t at, double share, double depth) {
                sum += share * depth;
                squares += share * (share * depth);
                moving += share * (depth * get_number(w, w.velocity[a], at));
            });
            if (!(sum > 0)) continue;
            water[a].sum = sum, water[a].speed = moving / sum;
            water[a].inverse_mass = squares / (sum * sum * (w.density * cell_area(w)));
        }
    }
    // f(place, share, depth) of faces that water moves through.
    template <class F> void each_share(Axis a, F f) {
        water[a].box.each([&](size_t i, size_t j) {
            const double share = work.own[a][place(w, i, j)];
            if (!(share > 0)) return;
            if (const double depth = moving_depth(w, a, i, j); depth > 0) f(place(w, i, j), share, depth);
        });
    }
    // False if a velocity left the finite range.
    bool give_water() {
        bool finite = true;
        for (Axis a : {kX, kY}) {
            if (given[a] != 0 && water[a].sum > 0) {
                const double change = given[a] / (w.density * cell_area(w) * water[a].sum);
                each_share(a, [&](size_t at, double share, double) {
                    set_number(w, w.velocity[a], at, get_number(w, w.velocity[a], at) + change * share);
                    finite &= isfinite(get_number(w, w.velocity[a], at)) != 0;
                });
                if (periodic(w, a)) { // the faces 0 and n are one
                    const size_t n = w.cells[a], across = w.cells[other(a)];
                    for (size_t k = 0; k < across; ++k)
                        set_number(w, w.velocity[a], a == kX ? place(w, n, k) : place(w, k, n),
                                   get_number(w, w.velocity[a], a == kX ? place(w, 0, k) : place(w, k, 0)));
                }
            }
            water[a].box.each([&](size_t i, size_t j) { work.own[a][place(w, i, j)] = 0; });
        }
        return finite;
    }
    double inverse() const {
        const double x = water[kX].inverse_mass, y = water[kY].inverse_mass;
        return 1 / h.mass + (x > y ? x : y);
    }
    // Takes an impulse from the hull and gives it to the water; by inverse() that costs no less energy than it does.
    void exchange(double x, double y) {
        h.velocity[0] -= x / h.mass, h.velocity[1] -= y / h.mass;
        h.water[0] -= x / dt, h.water[1] -= y / dt;
        given[kX] += x, given[kY] += y;
        water[kX].speed += x * water[kX].inverse_mass, water[kY].speed += y * water[kY].inverse_mass;
    }

    double moving_energy() const {
        const double *const v = h.velocity;
        return 0.5 * (mass[0] * (v[0] * v[0] + v[1] * v[1]) + mass[3] * (v[3] * v[3]));
    }

    void push(double x, double y, double round) {
        h.velocity[0] += x / mass[0], h.velocity[1] += y / mass[1], h.velocity[3] += round / mass[3];
    }

    // Friction on the bed, as far as the bed bears the hull: Coulomb's. Tells what energy it took.
    double rub(double borne) {
        const double before = moving_energy();
        const double speed = sqrt(h.velocity[0] * h.velocity[0] + h.velocity[1] * h.velocity[1]);
        const double reach = (h.length + h.width) / 6, most = h.friction * borne * dt;
        if (!(most > 0)) return 0;
        const double slower = speed * h.mass > most ? most / (speed * h.mass) : 1;
        h.water[0] -= slower * h.velocity[0] * h.mass / dt, h.water[1] -= slower * h.velocity[1] * h.mass / dt;
        h.velocity[0] -= slower * h.velocity[0], h.velocity[1] -= slower * h.velocity[1];
        const double turning = fabs(h.velocity[3]) * mass[3];
        const double less = turning > most * reach ? most * reach / turning : 1;
        h.water[3] -= less * h.velocity[3] * mass[3] / dt;
        h.velocity[3] -= less * h.velocity[3];
        return before - moving_energy();
    }

    // Drag against the water, along the hull and across it, implicit; by the part of the hull that the water bears.
    void drag(double part) {
        const double rel[2] = {h.velocity[0] - water[kX].speed, h.velocity[1] - water[kY].speed};
        const double c = h.heading[0], s = h.heading[1], own[2] = {rel[0] * c + rel[1] * s, rel[1] * c - rel[0] * s};
        double taken[2];
        const double by[2] = {part * h.drag[0] * dt, part * h.drag[1] * dt};
        for (int k = 0; k < 2; ++k) taken[k] = by[k] * own[k] / (1 + by[k] * inverse());
        exchange(taken[0] * c - taken[1] * s, taken[0] * s + taken[1] * c);
        const double turning = (by[1] * (h.length * h.length) + by[0] * (h.width * h.width)) / 12;
        const double slower = turning / (mass[3] + turning) * h.velocity[3];
        h.velocity[3] -= slower;
        h.water[3] -= slower * mass[3] / dt;
    }

    // Where a part of a step leads; stops: along which axes, and whether round, a side or a closed face is in the way.
    // Plates come no nearer to a side than its gap, or than they were, unless the hull is as long as the scene. The
    // middle does not leave the scene.
    HullPose after(const HullPose& pose, double time, bool (&stops)[3]) const {
        HullPose out = pose;
        for (bool& stop : stops) stop = false;
        if (!(time > 0)) return out; // a side is not met by what does not move: rounding would tell
        turn(out, time);
        const bool closed = is_near_closed(w, index, pose, cells_ahead(time));
        if (closed && !can_turn(w, index, pose, out)) {
            stops[kRound] = true;
            for (Axis a : {kX, kY}) out.heading[a] = pose.heading[a];
        }
        double* const at[2] = {&out.x, &out.y};
        for (Axis a : {Axis(w.first), other(Axis(w.first))}) { // the transpose of a scene goes the other way first
            const double length = double(w.cells[a]) * w.size[a], was = *at[a], wish = was + time * h.velocity[a];
            const double free = closed ? free_way(w, index, out, a, wish - was) : wish - was;
            const double to = free == wish - was ? wish : was + free;
            double stop = to;
            if (periodic(w, a)) {
                *at[a] = to - length * whole_below(to / length);
            } else {
                double before[2], now[2];
                hull_extent(w, index, pose.heading, a, before), hull_extent(w, index, out.heading, a, now);
                if (const double room = 0.5 * (length - (now[0] + now[1])); room > 0) {
                    const double gap = kHullGap * w.size[a] < room ? kHullGap * w.size[a] : room;
                    const double low = now[0] + gap - positive(before[0] + gap - was);
                    const double high = length - (now[1] + gap) + positive(before[1] + gap - (length - was));
                    stop = to > low ? (to < high ? to : high) : low;
                }
                *at[a] = stop = stop > 0 ? (stop < length ? stop : length) : 0;
            }
            stops[a] = stop != wish;
            if (cells_between(w, out.x, out.y).any) continue;
            stops[a] = true, *at[a] = was;
        }
        return out;
    }

    static constexpr int kRound = 2;
    // How many cells away what may stop a hull is at most: as far as it goes and its gap reach, and a cell more.
    double cells_ahead(double time) const {
        const double x = fabs(h.velocity[0]) / w.size[kX], y = fabs(h.velocity[1]) / w.size[kY];
        return time * (x > y ? x : y) + kHullGap + 1;
    }
    static double positive(double x) { return x > 0 ? x : 0; }
    void turn(HullPose& pose, double time) const {
        const double t = 0.5 * (time * h.velocity[3]), down = 1 / (1 + t * t); // a turn by 2 atan t
        const double turn_c = (1 - t * t) * down, turn_s = 2 * (t * down), c = pose.heading[0], s = pose.heading[1];
        const double new_c = c * turn_c - s * turn_s, new_s = s * turn_c + c * turn_s;
        const double size = sqrt(new_c * new_c + new_s * new_s);
        pose.heading[0] = new_c / size, pose.heading[1] = new_s / size;
    }

    // What drag can take at most between the hull and the water under it.
    double removable() const {
        const double x = h.velocity[0] - water[kX].speed, y = h.velocity[1] - water[kY].speed;
        return (x * x + y * y) / (2 * inverse());
    }
    // Tells how much it was.
    double remove(double energy) {
        const double x = h.velocity[0] - water[kX].speed, y = h.velocity[1] - water[kY].speed, by = inverse();
        const double rel = sqrt(x * x + y * y), left = rel * rel - 2 * (energy * by);
        if (!(rel > 0)) return 0;
        const double impulse = (rel - (left > 0 ? sqrt(left) : 0)) / by;
        exchange(impulse * (x / rel), impulse * (y / rel));
        return left > 0 ? energy : rel * rel / (2 * by);
    }

    // Of a push that led nowhere, which the water must not get: takes up to an energy of the hull's own motion, and
    // tells how much.
    double lose(double energy) {
        const double moving = moving_energy(), lost = energy < moving ? energy : moving;
        const double keeps = moving > 0 ? sqrt((moving - lost) / moving) : 0;
        for (int way : {0, 1, 3}) {
            h.water[way] -= (1 - keeps) * h.velocity[way] * mass[way] / dt;
            h.velocity[way] *= keeps;
        }
        return lost;
    }

    // Energies: had in motion before the water's push, made by that, rubbed off by friction.
    void drift(HullPose& pose, double had, double made, double rubbed, double energy) {
        const double credit = kCredit * (had + energy);
        double time = dt, due = 0;
        bool stops[3];
        HullPose to = pose;
        for (int half = 0; half <= kHalvings; ++half, time /= 2) {
            if (half == kHalvings) time = 0;
            to = after(pose, time, stops);
            double more = made + (time > 0 ? HullContact(w, index, to).energy - energy : 0);
            if (more > 0) more = positive(more - rubbed); // friction keeps nothing for later
            due = h.owed + more;
            if (due <= removable() + credit) break;
        }
        pose = to;
        const double moving = moving_energy();
        for (int k = 0; k < 3; ++k)
            if (stops[k]) h.velocity[k == kRound ? 3 : k] = 0;
        if (due > 0) due = positive(due - (moving - moving_energy())); // what stops it pays for what it owes
        // Nothing is paid of a small debt, all of one that reaches the credit.
        double taken = due < credit ? positive(due - kPaysFrom * credit) / (1 - kPaysFrom) : due;
        if (taken > removable() + credit) taken = lose(due);
        else if (taken > 0) taken = remove(taken);
        h.owed = due > 0 ? due - taken : due < -credit ? -credit : due;
        if (!isfinite(h.owed)) h.owed = 0; // velocities whose squares are no numbers have no energy to owe
    }
    static constexpr int kHalvings = 8;
    static constexpr double kCredit = 0.05;   // of a hull's energy, before the push, that may be owed, or kept
    static constexpr double kPaysFrom = 0.75; // of the credit

    bool stand_still() { // nothing is under its middle
        for (int way = 0; way < 6; ++way) h.velocity[way] = h.water[way] = 0;
        return true;
    }

    // False if a velocity of the water left the finite range.
    bool move() {
        inertia(h, mass);
        HullPose pose(h);
        if (!cells_between(w, h.x, h.y).any) return stand_still();
        double v[3] = {h.velocity[2], h.velocity[4], h.velocity[5]};
        heave(w, index, pose, v, dt);
        h.velocity[2] = v[0], h.velocity[4] = v[1], h.velocity[5] = v[2];
        const HullContact contact(w, index, pose);
        const double* const impulse = work.impulse + 3 * index;
        h.water[0] = impulse[0] / dt, h.water[1] = impulse[1] / dt, h.water[3] = impulse[2] / dt;
        h.water[2] = contact.push[0], h.water[4] = contact.push[1], h.water[5] = contact.push[2];

        find_water(pose);
        const double c = h.heading[0], s = h.heading[1];
        push(dt * (h.force[0] * c - h.force[1] * s), dt * (h.force[0] * s + h.force[1] * c), dt * h.force[3]);
        if (contact.push[0] > 0) drag(1 - contact.by_bed / contact.push[0]);
        const double before = moving_energy();
        push(impulse[0], impulse[1], impulse[2]);
        const double made = moving_energy() - before, rubbed = rub(contact.by_bed);
        drift(pose, before, made, rubbed, contact.energy);
        h.x = pose.x, h.y = pose.y, h.heading[0] = pose.heading[0], h.heading[1] = pose.heading[1];
        h.z = pose.z, h.pitch = pose.pitch, h.roll = pose.roll;
        return give_water();
    }
};

constexpr double kLeastSpread = 1e-9; // of plates along and across, of what their sums are, to have a slope

void lie(Water& w, size_t index, const double* heads) {
    Hull& h = hull(w, index);
    const HullPose pose(h);
    h.lies[0] = h.z, h.lies[1] = h.pitch, h.lies[2] = h.roll;
    // The plane of least squares: sums over the plates, by area, of the unit, ahead and port times each other.
    double area = 0, height_sum = 0, first[2] = {}, second[3] = {}, products[2] = {};
    each_plate(w, index, pose, [&](const Plate& p) {
        if (!(p.sunk() > 0)) return;
        double height = (p.surface - p.height) - pose.z; // above the body's keel, so that the sums do not cancel
        if (p.bed < p.z) { // not on the bed, which does not give way
            height -= p.head();
            p.cells.each([&](size_t i, size_t j, double weight) { height += weight * heads[place(w, i, j)]; });
        }
        area += p.area, height_sum += p.area * height;
        first[0] += p.area * p.ahead, first[1] += p.area * p.port;
        second[0] += p.area * (p.ahead * p.ahead), second[1] += p.area * (p.ahead * p.port);
        second[2] += p.area * (p.port * p.port);
        products[0] += p.area * (p.ahead * height), products[1] += p.area * (p.port * height);
    });
    if (!(area > 0)) return;
    // Along a line of plates the slope across it is anything: the least.
    const double least = kLeastSpread * (second[0] + second[2]), mean[2] = {first[0] / area, first[1] / area};
    const double xx = second[0] - mean[0] * first[0] + least, xy = second[1] - mean[0] * first[1];
    const double yy = second[2] - mean[1] * first[1] + least, whole = xx * yy - xy * xy;
    const double x = products[0] - mean[0] * height_sum, y = products[1] - mean[1] * height_sum;
    h.lies[1] = whole > 0 ? (x * yy - y * xy) / whole : 0;
    h.lies[2] = whole > 0 ? (y * xx - x * xy) / whole : 0;
    h.lies[0] = pose.z + (height_sum / area - (h.lies[1] * mean[0] + h.lies[2] * mean[1]));
}

} // namespace

bool move_hulls(Water& w, HullWork& work, double dt) {
    bool finite = true;
    each_hull(w, [&](size_t k) { finite &= Mover{w, work, dt, k}.move(); });
    return finite;
}

void settle_hulls(Water& w, const HullWork& work) {
    CellBox box;
    each_hull(w, [&](size_t k) {
        press(w, k, w.depth.data, 0, work.own[0], work.own[1], [&](size_t i, size_t j) { box.see(i, j); });
    });
    each_hull(w, [&](size_t k) { lie(w, k, work.own[0]); });
    box.each([&](size_t i, size_t j) { work.own[0][place(w, i, j)] = work.own[1][place(w, i, j)] = 0; });
}

} // namespace cd
