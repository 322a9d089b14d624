// What acts on cloth from outside: air, and what it touches.
#include <math.h>
#include <utility>

#include "model/membrane_cloth.hh"

namespace cd {

namespace {

struct Vector3 {
    double k[3];

    double operator[](int i) const { return k[i]; }
};
Vector3 vector_at(double* const* planes, size_t at) { return {{planes[0][at], planes[1][at], planes[2][at]}}; }
Vector3 operator-(Vector3 a, Vector3 b) { return {{a[0] - b[0], a[1] - b[1], a[2] - b[2]}}; }
Vector3 operator*(double s, Vector3 a) { return {{s * a[0], s * a[1], s * a[2]}}; }
double dot(Vector3 a, Vector3 b) { return (a[0] * b[0] + a[1] * b[1]) + a[2] * b[2]; }

// planes += weight a a^T, in the order of ClothMatrix::ground.
void add_square(double* const* planes, size_t at, double weight, Vector3 a) {
    static constexpr int kRow[6] = {0, 1, 2, 0, 0, 1}, kColumn[6] = {0, 1, 2, 1, 2, 2};
    for (int k = 0; k < 6; ++k) planes[k][at] += weight * a[kRow[k]] * a[kColumn[k]];
}
void add_alike(double* const* planes, size_t at, double weight) {
    for (int k = 0; k < 3; ++k) planes[k][at] += weight;
}

} // namespace

bool solve_block(const double* matrix, const double* right, double* x) {
    const double xx = matrix[0], xy = matrix[3] / xx, xz = matrix[4] / xx, yy = matrix[1] - xy * matrix[3];
    const double rest = matrix[5] - xy * matrix[4], yz = rest / yy, zz = matrix[2] - xz * matrix[4] - yz * rest;
    if (!(xx > 0 && yy > 0 && zz > 0)) return false;
    const double y = right[1] - xy * right[0];
    x[2] = (right[2] - xz * right[0] - yz * y) / zz;
    x[1] = y / yy - yz * x[2];
    x[0] = right[0] / xx - xy * x[1] - xz * x[2];
    return true;
}

// ---- air ------------------------------------------------------------------------------------------------------------

// Each corner of a cell bears a quarter of its air. The cell's area is half the cross product of its diagonals.
void add_air(const Membrane& m, ClothWork& w, double h) {
    const ClothSettings& c = m.cloth;
    for (size_t v = 0; v < springs_along(m, kV); ++v)
        for (size_t u = 0; u < springs_along(m, kU); ++u) {
            const size_t next_u = after(m, kU, u), next_v = after(m, kV, v);
            const struct { size_t u, v; } corner[4] = {{u, v}, {next_u, v}, {u, next_v}, {next_u, next_v}};
            bool whole = true;
            for (const auto& at : corner) whole &= present(m, at.u, at.v);
            if (!whole || is_open(m, u, v)) continue;
            const auto x = [&](int k) { return vector_at(w.from, w.place(corner[k].u, corner[k].v)); };
            const Vector3 a = x(3) - x(0), b = x(2) - x(1);
            const Vector3 twice = {{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]}};
            const double size = sqrt(dot(twice, twice));
            if (!(size > 0)) continue;
            const Vector3 normal = 1 / size * twice;
            const double share = h * size / 8, along = share * c.along, more = share * c.across - along;
            for (const auto& at : corner) {
                const size_t place = w.place(at.u, at.v);
                Vector3 wind = {{c.wind[0], c.wind[1], c.wind[2]}};
                for (int k = 0; m.wind && k < 3; ++k)
                    wind.k[k] = get_number(m, m.wind, cd::place(m, at.u, at.v, size_t(k)));
                add_alike(w.own, place, along);
                add_square(w.own, place, more, normal);
                const double through = more * dot(normal, wind);
                for (int k = 0; k < 3; ++k) w.rhs[k][place] += along * wind[k] + through * normal[k];
            }
        }
}

#if CD_WITH_CONTACT

// ---- contacts -------------------------------------------------------------------------------------------------------

namespace {

// How stiff a contact is, over the mass of its node; the speed e of v / (v + e) in friction [m/s]; and how much friction
// may resist, over the contact's stiffness: of any more, rounding would hold the node along the normal too.
constexpr double kContactStiffness = 1e4, kStickSpeed = 1e-3, kMostFriction = 1e6;
// What the product of two normals counts for, so that contacts that are as good as one have an answer.
constexpr double kParallel = 1 - 1e-8;

Vector3 operator+(Vector3 a, Vector3 b) { return {{a[0] + b[0], a[1] + b[1], a[2] + b[2]}}; }

struct Gap {
    Vector3 normal;
    double size;
};

// How far outside of a collider x lies at this time, and the way out.
Gap gap_to(const Obstacle& to, Vector3 x, double time) {
    if (to.shape == CD_SHAPE_BED) {
        Gap gap;
        gap.size = gap_to_bed(to, x.k, time, gap.normal.k);
        return gap;
    }
    const Vector3 at = {{to.place(0, time), to.place(1, time), to.place(2, time)}};
    const Vector3 way = {{to.way[0], to.way[1], to.way[2]}}, from = x - at;
    if (to.shape == CD_SHAPE_PLANE) return {way, dot(way, from) - to.radius};
    const double square = dot(way, way);
    const double along = square > 0 ? fmin(fmax(dot(way, from) / square, 0), 1) : 0;
    const Vector3 off = from - along * way;
    const double distance = sqrt(dot(off, off));
    Gap gap{1 / distance * off, distance - to.radius};
    if (!(distance > 0)) way_off_line(to.way, 3, gap.normal.k);
    return gap;
}

// The push against what comes nearer than there is room.
double push_of(const ClothContact& c, Vector3 velocity, double inverse_dt) {
    const Vector3 normal = {{c.normal[0], c.normal[1], c.normal[2]}};
    const double into = -(c.room * inverse_dt + dot(normal, velocity));
    return into > 0 ? c.stiffness * into : 0;
}
Vector3 normal_of(const ClothContact& c) { return {{c.normal[0], c.normal[1], c.normal[2]}}; }
Vector3 collider_velocity(const ClothContact& c) { return {{c.velocity[0], c.velocity[1], c.velocity[2]}}; }

// What the callback of a collider tells of all nodes: their gaps, and normals of three components each.
struct Answers {
    const double *gaps, *normals;

    Gap operator[](size_t node) const {
        const double* const n = normals + 3 * node;
        return {{{n[0], n[1], n[2]}}, gaps[node]};
    }
};
Answers ask_all(Membrane& m, const ClothWork& w, const Obstacle& to, double time) {
    double *const places = w.question, *const gaps = places + 3 * m.nodes, *const normals = gaps + m.nodes;
    for (size_t v = 0, i = 0; v < m.rows; ++v)
        for (size_t u = 0; u < m.columns; ++u)
            for (const double* plane : w.from) places[i++] = plane[w.place(u, v)];
    ask(to, time, m.nodes, 3, places, gaps, normals, m.bad_answer);
    return {gaps, normals};
}

// Puts a contact among those of its node that it would be deepest in if it went on by `way`, in that order.
void keep_deepest(ClothContact* of_node, size_t most, ClothContact contact, Vector3 way) {
    const auto left = [&](const ClothContact& c) { return c.room + dot(normal_of(c), way); };
    for (size_t j = 0; j < most; ++j)
        if (left(contact) < left(of_node[j])) std::swap(contact, of_node[j]);
}

} // namespace

size_t find_contacts(Membrane& m, ClothWork& w, double now, double dt) {
    const size_t most = most_contacts(collider_count(m)), places = most * m.nodes;
    for (size_t i = 0; i < places; ++i) w.contacts[i].room = HUGE_VAL; // none
    each_obstacle(m, m.cloth.thickness, [&](const Obstacle& to) {
        const Vector3 velocity = {{to.velocity[0], to.velocity[1], to.velocity[2]}};
        const Answers told = to.callback ? ask_all(m, w, to, now) : Answers();
        for (size_t v = 0, node = 0; v < m.rows; ++v)
            for (size_t u = 0; u < m.columns; ++u, ++node) {
                const size_t at = w.place(u, v);
                if (!(w.moves[at] > 0)) continue;
                const Gap gap = to.callback ? told[node] : gap_to(to, vector_at(w.from, at), now);
                const Vector3 out = gap.normal;
                const ClothContact contact{double(at),
                                           double(to.index),
                                           {out[0], out[1], out[2]},
                                           gap.size,
                                           gap.size - dt * dot(out, velocity),
                                           kContactStiffness * w.mass[at],
                                           to.friction,
                                           {velocity[0], velocity[1], velocity[2]},
                                           0,
                                           0};
                keep_deepest(w.contacts + node * most, most, contact, dt * vector_at(w.w, at));
            }
    });
    size_t found = 0;
    for (size_t i = 0; i < places; ++i)
        if (w.contacts[i].room < HUGE_VAL) w.contacts[found++] = w.contacts[i];
    return found;
}

namespace {

// The resistance of a contact's friction: coefficient times push over the slip, whose direction it takes.
double resistance_of(const ClothContact& c, Vector3 velocity, Vector3& slip) {
    const Vector3 through = velocity - collider_velocity(c), normal = normal_of(c);
    slip = through - dot(normal, through) * normal;
    const double most = kMostFriction * c.stiffness,
                 wanted = c.friction * c.push / (sqrt(dot(slip, slip)) + kStickSpeed);
    return wanted < most ? wanted : most;
}

// The pushes that friction goes by: those of the contacts at this velocity, but no more than would keep the node out if it
// alone gave way. `rest` is its residual without contacts. At the minimum of Phi both are the same; before, the first are
// off by as much as contacts are stiffer than what else acts on the node.
void take_pushes_on(ClothContact* of_node, size_t count, double inertia, Vector3 velocity, Vector3 rest,
                    double inverse_dt) {
    Vector3 slip, change = 1 / inertia * rest;
    for (size_t j = 0; j < count; ++j) {
        const double resistance = resistance_of(of_node[j], velocity, slip);
        change = change - resistance / inertia * slip;
    }
    double matrix[6] = {1, 1, 1};
    double* const planes[6] = {matrix, matrix + 1, matrix + 2, matrix + 3, matrix + 4, matrix + 5};
    Vector3 pushed = change, by{};
    bool meets[kMostTouched];
    for (size_t j = 0; j < count; ++j) {
        const Vector3 normal = normal_of(of_node[j]);
        const double into = -(of_node[j].room * inverse_dt + dot(normal, velocity));
        const double stiffness = of_node[j].stiffness / inertia;
        meets[j] = into > dot(normal, change);
        if (!meets[j]) continue;
        add_square(planes, 0, stiffness, normal);
        pushed = pushed + stiffness * into * normal;
    }
    const bool solved = solve_block(matrix, pushed.k, by.k);
    for (size_t j = 0; j < count; ++j) {
        const double now = push_of(of_node[j], velocity, inverse_dt);
        of_node[j].push = solved && meets[j] ? fmin(now, push_of(of_node[j], velocity + by, inverse_dt)) : 0;
    }
}

} // namespace

// How many contacts from number i on are of one node.
static size_t contacts_of_node(const ClothWork& w, size_t i, size_t contacts) {
    size_t count = 1;
    while (i + count < contacts && w.contacts[i + count].at == w.contacts[i].at) ++count;
    return count;
}

void take_pushes(const ClothWork& w, size_t contacts, double dt, double* const* velocity, double* const* rest) {
    for (size_t i = 0, count; i < contacts; i += count) {
        count = contacts_of_node(w, i, contacts);
        const size_t at = size_t(w.contacts[i].at);
        take_pushes_on(w.contacts + i, count, w.inertia[at], vector_at(velocity, at), vector_at(rest, at), 1 / dt);
    }
}

bool find_ways_out(const ClothWork& w, size_t contacts, double dt) {
    bool any = false;
    for (const ClothContact* c = w.contacts; c < w.contacts + contacts; ++c) {
        if (!(c->gap < 0)) continue;
        const size_t at = size_t(c->at);
        const auto each = [&](size_t i) {
            for (int k = 0; k < 3; ++k) w.trial[k][i] = w.w[k][i], w.image[k][i] = 0;
        };
        if (!any) w.each_place(each);
        any = true;
        const double out =
            fmax(0, fmin(dot({{c->normal[0], c->normal[1], c->normal[2]}}, vector_at(w.trial, at)), -c->gap / dt));
        for (int k = 0; k < 3; ++k) w.trial[k][at] -= out * c->normal[k], w.image[k][at] += out * c->normal[k];
    }
    return any;
}

bool touches(const ClothWork& w, size_t contacts, double dt) {
    bool any = false;
    for (size_t i = 0; i < contacts; ++i) {
        const size_t at = size_t(w.contacts[i].at);
        if (push_of(w.contacts[i], vector_at(w.w, at), 1 / dt) > 0)
            w.contacts[i].met = w.bound[w.part[at]] = 1, any = true;
    }
    return any;
}

void widen_by_contacts(const ClothWork& w, size_t contacts, double* const* least, double* const* most) {
    for (size_t i = 0; i < contacts; ++i) {
        const ClothContact& c = w.contacts[i];
        const size_t part = w.part[size_t(c.at)];
        double speed = 0; // with which it pushes: friction may drag along as much, or nothing
        for (int k = 0; k < 3; ++k) speed += c.normal[k] * c.velocity[k];
        for (int k = 0; k < 3 && c.met > 0; ++k) {
            const double pushed = speed * c.normal[k];
            least[k][part] = fmin(least[k][part], pushed);
            most[k][part] = fmax(most[k][part], pushed);
        }
    }
}

void add_contacts(const ClothWork& w, size_t contacts, double dt, double* const* velocity, double* const* residual,
                  double* const* ground) {
    const double inverse_dt = 1 / dt;
    for (size_t i = 0; i < contacts; ++i) {
        const ClothContact& c = w.contacts[i];
        const size_t at = size_t(c.at);
        const Vector3 own = vector_at(velocity, at), normal = normal_of(c);
        const double push = push_of(c, own, inverse_dt);
        if (!(push > 0) && !(c.push > 0)) continue;
        for (int k = 0; k < 3; ++k) residual[k][at] += push * normal[k];
        if (ground && push > 0) add_square(ground, at, c.stiffness, normal);
        Vector3 slip;
        const double resistance = resistance_of(c, own, slip);
        for (int k = 0; k < 3; ++k) residual[k][at] -= resistance * slip[k];
        if (!ground) continue;
        add_alike(ground, at, resistance);
        add_square(ground, at, -resistance, normal);
    }
}

__attribute__((cold)) void settle_contacts(const ClothWork& w, size_t contacts, double dt, double lambda,
                                           double* const* velocity) {
    for (size_t i = 0, count; i < contacts; i += count) {
        count = contacts_of_node(w, i, contacts);
        const size_t at = size_t(w.contacts[i].at);
        const Vector3 moved = vector_at(w.w, at), before = vector_at(velocity, at);
        // The least change that does what all of the contacts want: a sum of normals, whose products are the matrix.
        double matrix[6] = {1, 1, 1}, wants[3] = {}, faster[3] = {}, sizes[3];
        Vector3 normals[3] = {}, change{};
        bool pushed = false;
        for (size_t j = 0; j < count; ++j) {
            const ClothContact& c = w.contacts[i + j];
            if (!(push_of(c, moved, 1 / dt) > 0)) continue;
            const Vector3 normal = normal_of(c);
            const double overlap = c.gap < 0 ? -c.gap / dt : 0, own = dot(normal, collider_velocity(c));
            const double now = dot(normal, before), out = dot(normal, moved);
            wants[j] = fmax(out - overlap, fmin(out, own)) - now; // the way out is no more than it went
            normals[j] = normal, faster[j] = own - now, pushed = true;
        }
        if (!pushed) continue;
        matrix[3] = kParallel * dot(normals[0], normals[1]);
        matrix[4] = kParallel * dot(normals[0], normals[2]);
        matrix[5] = kParallel * dot(normals[1], normals[2]);
        if (!solve_block(matrix, wants, sizes)) continue;
        double falls = 0; // the energy beside what the colliders' velocities do, by the change's first power
        for (size_t j = 0; j < count; ++j) change = change + sizes[j] * normals[j], falls += sizes[j] * faster[j];
        const double square = dot(change, change);
        const double share = square <= 2 * falls ? 1 : falls > 0 ? falls / square : 0; // or it would gain energy
        for (int k = 0; k < 3; ++k) velocity[k][at] += share * change[k];
        for (int k = 0; k < 3; ++k) w.residual[k][at] -= lambda * w.mass[at] * (share * change[k]);
    }
}

// What a node that has met colliders lacks of the momentum that it has, they have given it: so that with few iterations,
// too, the sum is right, where contacts as stiff as these are far off. What the others lack, of a part of the sheet that
// nothing holds, has come from there too: each that has met one has its share by mass. Of several colliders of a node all
// but the one that pushes most take what they push by, and that one the rest.
__attribute__((cold)) void tell_loads(const Membrane& m, const ClothWork& w, size_t contacts, double dt) {
    clear_loads(m);
    double *const *const missing = w.image, *const bears = w.answer[0], *const met = w.answer[1]; // of parts; of nodes
    w.each_place([&](size_t at) { missing[0][at] = missing[1][at] = missing[2][at] = bears[at] = met[at] = 0; });
    for (size_t i = 0; i < contacts; ++i) met[size_t(w.contacts[i].at)] += w.contacts[i].met;
    w.each_place([&](size_t at) {
        const size_t part = w.part[at];
        if (!(w.moves[at] > 0)) bears[part] = HUGE_VAL;
        else if (met[at] > 0) bears[part] += w.mass[at];
        else
            for (int k = 0; k < 3; ++k) missing[k][part] += w.residual[k][at];
    });
    for (size_t i = 0, count; i < contacts; i += count) {
        count = contacts_of_node(w, i, contacts);
        const size_t at = size_t(w.contacts[i].at);
        const Vector3 moved = vector_at(w.w, at), x = vector_at(w.from, at);
        const size_t part = w.part[at];
        Vector3 left = vector_at(w.residual, at) + w.mass[at] / bears[part] * vector_at(missing, part);
        const auto load = [&](const ClothContact& c, Vector3 impulse) {
            const Vector3 force = 1 / (m.lambda * dt) * impulse;
            add_force(m.loads.data + size_t(c.collider) * kLoadNumbers, force.k, x.k);
        };
        const auto push = [&](const ClothContact& c) { return fmin(c.push, push_of(c, moved, 1 / dt)); };
        const ClothContact* most = nullptr;
        for (size_t j = i; j < i + count; ++j)
            if (w.contacts[j].met > 0 && (!most || push(w.contacts[j]) > push(*most))) most = &w.contacts[j];
        for (size_t j = i; j < i + count && most; ++j) {
            const ClothContact& c = w.contacts[j];
            if (&c == most || !(c.met > 0)) continue;
            Vector3 slip;
            const double resistance = resistance_of(c, moved, slip);
            const Vector3 taken = resistance * slip - push(c) * normal_of(c);
            load(c, taken);
            left = left - taken;
        }
        if (most) load(*most, left);
    }
}

#endif

} // namespace cd
