// The springs of cloth: what a step computes with, their energy, tension and strain. (model.md, 42)
#include "model/membrane_cloth.hh"

#include <math.h>

#include "model/joiner.hh"

namespace cd {

namespace {

bool cloth_grid(size_t columns, size_t rows, Grid& out) {
    size_t wide;
    if (!add(columns, 2 * kBefore - 4, wide) || !grid_of(wide, rows, out)) return false;
    out.columns = columns;
    return true;
}

// Whether the cell that starts at a node has all of its four springs.
bool whole_cell(const Membrane& m, size_t u, size_t v) {
    if (u >= springs_along(m, kU) || v >= springs_along(m, kV)) return false;
    const size_t next_u = after(m, kU, u), next_v = after(m, kV, v);
    return stiffness_of(m, kU, u, v) > 0 && stiffness_of(m, kU, u, next_v) > 0 && stiffness_of(m, kV, u, v) > 0 &&
           stiffness_of(m, kV, next_u, v) > 0;
}
double diagonal_length(const Membrane& m, size_t u, size_t v) {
    const size_t next_u = after(m, kU, u), next_v = after(m, kV, v);
    const double along_u = 0.5 * (length_of(m, kU, u, v) + length_of(m, kU, u, next_v));
    const double along_v = 0.5 * (length_of(m, kV, u, v) + length_of(m, kV, next_u, v));
    return sqrt(along_u * along_u + along_v * along_v);
}
double shear_of(const Membrane& m, size_t u, size_t v) {
    return m.cloth.shear > 0 && whole_cell(m, u, v) ? m.cloth.shear : 0;
}
// Bend of a node between two springs, twist of a whole cell.
double cloth_bend_of(const Membrane& m, Direction d, size_t u, size_t v) {
    const double bend = bend_of(m, d, u, v);
    if (!(bend > 0)) return 0;
    const size_t last_u = d == kU ? before(m, kU, u) : u, last_v = d == kV ? before(m, kV, v) : v;
    return stiffness_of(m, d, u, v) > 0 && stiffness_of(m, d, last_u, last_v) > 0 ? bend : 0;
}
double cloth_twist_of(const Membrane& m, size_t u, size_t v) { return whole_cell(m, u, v) ? twist_of(m, u, v) : 0; }

// What pushes a spring towards its length [N/m].
double compression_of(const Membrane& m, Direction d, size_t u, size_t v) {
    if (!(stiffness_of(m, d, u, v) > 0)) return 0;
    return per_spring(m, d, m.cloth.compression * m.mass) * line_weight(m, other(d), d == kU ? v : u);
}

} // namespace

// ---- memory and coefficients ----------------------------------------------------------------------------------------

ClothWork::ClothWork(const Membrane& m, const MembraneFeatures& f, Carver& coefficients, Carver& scratch)
    : parts(m.rows, m.columns, 8), strips(m.columns, m.rows, 8) {
    coefficients.fits &= cloth_grid(m.columns, m.rows, grid) && cloth_grid(m.rows, m.columns, turned);
    const auto plane = [&] { return coefficients.plane(grid); };
    const auto vector = [&](double** out, const Grid& of, int count = 3) {
        for (int k = 0; k < count; ++k) out[k] = scratch.plane(of);
    };
    for (int s = 0; s < kClothSprings; ++s) stiffness[s] = plane();
    for (int s = 0; s < 3; ++s) length[s] = plane();
    length[kCounterDiagonal] = length[kDiagonal];
    for (Direction d : {kU, kV}) {
        compression[d] = plane();
        bend[d] = f.bend ? plane() : nullptr;
    }
    twist = f.bend ? plane() : nullptr;
    mass = plane();
    moves = plane();
    turned_moves = coefficients.plane(turned);
    part = reinterpret_cast<size_t*>(coefficients.plane(grid));

    for (double** planes : {from, to, w, trial, rhs, residual, direction, error, conjugate, image, answer})
        vector(planes, grid);
    for (double** planes : recycled) vector(planes, grid);
    vector(turned_z, turned);
    bound = scratch.plane(grid);
    inertia = scratch.plane(grid);
    const bool blocks = f.air || f.colliders.count > 0;
    for (int k = 0; k < 6; ++k) {
        own[k] = blocks ? scratch.plane(grid) : k < 3 ? inertia : nullptr;
        ground[k] = f.colliders.count > 0 ? scratch.plane(grid) : own[k];
    }
    for (auto& planes : curvature) vector(planes, grid, 4);
    vector(turned_curvature, turned, 4);
    vector(block, grid, 6);
    vector(turned_block, turned, 6);
    size_t numbers = 0, contact_numbers = 0, question_numbers = 0;
    constexpr size_t kContactNumbers = sizeof(ClothContact) / sizeof(double), kQuestionNumbers = 7;
    scratch.fits = scratch.fits && multiply(parts.count(), kClothRows * grid.pitch, numbers) &&
                   multiply(m.nodes, most_contacts(f.colliders.count) * kContactNumbers, contact_numbers) &&
                   multiply(m.nodes, f.colliders.callbacks > 0 ? kQuestionNumbers : 0, question_numbers);
    rows = scratch.numbers(numbers);
    sums = scratch.numbers(m.rows);
    contacts = reinterpret_cast<ClothContact*>(scratch.numbers(contact_numbers));
    question = scratch.numbers(question_numbers);
}

ClothSprings ClothWork::springs() const {
    return {{stiffness[0], stiffness[1], stiffness[2], stiffness[3]},
            {length[0], length[1], length[2], length[3]},
            {compression[0], compression[1]}};
}

ClothMatrix ClothWork::matrix(double* const* with_ground) const {
    ClothMatrix out{};
    for (int k = 0; k < 6; ++k) out.ground[k] = with_ground[k];
    for (int s = 0; s < kClothSprings; ++s)
        for (int k = 0; k < 4; ++k) out.spring[s].plane[k] = curvature[s][k];
    out.bend[0] = bend[0], out.bend[1] = bend[1], out.twist = twist, out.moves = moves;
    return out;
}

bool cloth_needs_of(const Membrane& m, const MembraneFeatures& f, MembraneNeeds& out) {
    Carver coefficients{nullptr}, scratch{nullptr};
    const ClothWork counted(m, f, coefficients, scratch);
    out = {coefficients.taken, scratch.taken};
    return coefficients.fits && scratch.fits;
}

const char* what_cloth_lacks(const Membrane& m) {
    if (m.method != CD_METHOD_IMPLICIT) return "method but CD_METHOD_IMPLICIT: see cd_membrane_set_method";
    if (m.lambda < 0.5) return "lambda below 1/2: see cd_membrane_set_lambda";
    if (m.damping > 0) return "stiffness damping: see cd_membrane_set_stiffness_damping";
    for (cd_node edge : m.edge)
        if (edge == CD_NODE_MATCHED) return "matched edge: see cd_membrane_set_edge";
    return nullptr;
}

namespace {

void find_parts(const Membrane& m, ClothWork& w) {
    const Joiner joiner{w.part};
    const auto each_node = [&](auto f) {
        for (size_t v = 0; v < m.rows; ++v)
            for (size_t u = 0; u < m.columns; ++u) f(u, v, w.place(u, v));
    };
    each_node([&](size_t, size_t, size_t at) { w.part[at] = at + 1; });
    each_node([&](size_t u, size_t v, size_t at) {
        if (w.stiffness[kAlongU][at] > 0) joiner.join(at, w.place(after(m, kU, u), v));
        if (w.stiffness[kAlongV][at] > 0) joiner.join(at, w.place(u, after(m, kV, v)));
    });
    each_node([&](size_t, size_t, size_t at) { w.part[at] = joiner.first_of(at) + 1; });
    each_node([&](size_t, size_t, size_t at) { --w.part[at]; });
}

} // namespace

void prepare(const Membrane& m, ClothWork& w, double h, double dt) {
    for (double* length : {w.length[kAlongU], w.length[kAlongV], w.length[kDiagonal]})
        for (size_t i = 0; i < w.grid.pitch * w.grid.rows + 2 * kBefore; ++i) length[ptrdiff_t(i - kBefore)] = 1;
    for (size_t v = 0; v < m.rows; ++v)
        for (size_t u = 0; u < m.columns; ++u) {
            const size_t at = w.place(u, v);
            const bool moves = present(m, u, v) && !held(m, u, v);
            w.mass[at] = moves ? mass_of(m, u, v) : 0;
            w.moves[at] = w.turned_moves[u * w.turned.pitch + v] = moves ? 1 : 0;
            for (Direction d : {kU, kV}) {
                const double k = stiffness_of(m, d, u, v);
                w.stiffness[d][at] = k;
                w.compression[d][at] = compression_of(m, d, u, v);
                if (k > 0) w.length[d][at] = length_of(m, d, u, v);
                if (w.has_bend()) w.bend[d][at] = h * dt * cloth_bend_of(m, d, u, v);
            }
            if (w.has_bend()) w.twist[at] = h * dt * cloth_twist_of(m, u, v);
            const double shear = shear_of(m, u, v);
            w.stiffness[kDiagonal][at] = w.stiffness[kCounterDiagonal][at] = shear;
            if (shear > 0) w.length[kDiagonal][at] = diagonal_length(m, u, v);
        }
    find_parts(m, w);
    if (!m.ring[kU]) return;
    const auto wrap = [&](double* plane) { m.kernels->sheet.wrap(w.grid, plane, 0, w.grid.rows); };
    for (double* plane : w.stiffness) wrap(plane);
    for (double* plane : {w.length[kAlongU], w.length[kAlongV], w.length[kDiagonal]}) wrap(plane);
    for (Direction d : {kU, kV}) {
        wrap(w.compression[d]);
        if (w.has_bend()) wrap(w.bend[d]);
    }
    if (w.has_bend()) wrap(w.twist);
}

// ---- measuring ------------------------------------------------------------------------------------------------------

namespace {

// The vector of a spring from (u, v) to another node, and how long it is.
double distance(const Membrane& m, size_t u, size_t v, size_t to_u, size_t to_v) {
    double square = 0;
    for (size_t k = 0; k < 3; ++k) {
        const double way =
            get_number(m, m.position, place(m, to_u, to_v, k)) - get_number(m, m.position, place(m, u, v, k));
        square += way * way;
    }
    return sqrt(square);
}
double length_now(const Membrane& m, Direction d, size_t u, size_t v) {
    return d == kU ? distance(m, u, v, after(m, kU, u), v) : distance(m, u, v, u, after(m, kV, v));
}

// Of a spring of stiffness 1 that is longer than its length by `excess`.
double pull_of(double length, double excess) {
    const double soft = kSlackEnd * length;
    return excess <= 0 ? 0 : excess <= 2 * soft ? excess * excess / (4 * soft) : excess - soft;
}
double energy_of(double length, double excess) {
    const double soft = kSlackEnd * length, beyond = excess - soft;
    if (excess <= 0) return 0;
    if (excess <= 2 * soft) return excess * excess * excess / (12 * soft);
    return 2 * soft * soft / 3 + (beyond * beyond - soft * soft) / 2;
}
// Of a spring of stiffness 1 against crumpling: (now - length)^2 / 2, but next to 0.
double crumpling_energy(double length, double now) {
    const double least = kLeastDirection * length;
    if (now > least) return (now - length) * (now - length) / 2;
    return now * now / 2 - length * (now * now / (2 * least) + least / 2) + length * length / 2;
}

} // namespace

double strain_of(const Membrane& m, Direction d, size_t u, size_t v) {
    return length_now(m, d, u, v) / length_of(m, d, u, v) - 1;
}

double tension_of(const Membrane& m, Direction d, size_t u, size_t v) {
    const double stiffness = stiffness_of(m, d, u, v), length = length_of(m, d, u, v);
    if (!(stiffness > 0)) return 0;
    const double excess = length_now(m, d, u, v) - length;
    return stiffness * pull_of(length, excess) + compression_of(m, d, u, v) * excess;
}

double cloth_elastic(const Membrane& m) {
    double sum = 0;
    const auto x = [&](size_t u, size_t v, size_t k) { return get_number(m, m.position, place(m, u, v, k)); };
    for (size_t v = 0; v < m.rows; ++v)
        for (size_t u = 0; u < m.columns; ++u) {
            const size_t next_u = after(m, kU, u), next_v = after(m, kV, v);
            for (Direction d : {kU, kV}) {
                const double stiffness = stiffness_of(m, d, u, v);
                if (stiffness > 0) {
                    const double length = length_of(m, d, u, v), now = length_now(m, d, u, v);
                    sum += stiffness * energy_of(length, now - length) +
                           compression_of(m, d, u, v) * crumpling_energy(length, now);
                }
                const double bend = cloth_bend_of(m, d, u, v);
                const size_t last_u = d == kU ? before(m, kU, u) : u, last_v = d == kV ? before(m, kV, v) : v;
                const size_t end_u = d == kU ? next_u : u, end_v = d == kV ? next_v : v;
                for (size_t k = 0; k < 3 && bend > 0; ++k) {
                    const double curve = (x(last_u, last_v, k) - x(u, v, k)) + (x(end_u, end_v, k) - x(u, v, k));
                    sum += bend / 2 * (curve * curve);
                }
            }
            const double shear = shear_of(m, u, v), twist = cloth_twist_of(m, u, v);
            if (shear > 0) {
                const double length = diagonal_length(m, u, v);
                sum += shear * (energy_of(length, distance(m, u, v, next_u, next_v) - length) +
                                energy_of(length, distance(m, next_u, v, u, next_v) - length));
            }
            for (size_t k = 0; k < 3 && twist > 0; ++k) {
                const double change = (x(next_u, next_v, k) - x(u, next_v, k)) - (x(next_u, v, k) - x(u, v, k));
                sum += twist / 2 * (change * change);
            }
        }
    return sum;
}

} // namespace cd
