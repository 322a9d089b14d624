// The springs of cloth: what a step computes with. (model.md, 42)
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

} // namespace

// ---- what a sheet's energy is made of (membrane.hh) ----------------------------------------------------------------

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
double cloth_bend_of(const Membrane& m, Direction d, size_t u, size_t v) {
    const double bend = bend_of(m, d, u, v);
    if (!(bend > 0)) return 0;
    const size_t last_u = d == kU ? before(m, kU, u) : u, last_v = d == kV ? before(m, kV, v) : v;
    return stiffness_of(m, d, u, v) > 0 && stiffness_of(m, d, last_u, last_v) > 0 ? bend : 0;
}

double compression_of(const Membrane& m, Direction d, size_t u, size_t v) {
    if (!(stiffness_of(m, d, u, v) > 0)) return 0;
    return per_spring(m, d, m.cloth.compression * m.mass) * line_weight(m, other(d), d == kU ? v : u);
}

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

    for (double** planes :
         {from, to, w, trial, rhs, residual, given, expected, direction, error, conjugate, image, answer})
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
            const bool whole = whole_cell(m, u, v);
            if (w.has_bend()) w.twist[at] = whole ? h * dt * twist_of(m, u, v) : 0;
            const double shear = whole ? m.cloth.shear : 0;
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

} // namespace cd
