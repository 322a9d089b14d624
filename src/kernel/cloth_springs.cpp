// Sums over the springs of cloth: of their forces, and of a matrix's products.
#include <utility>

#include "kernel/cloth.hh"
#include "kernel/vectors.hh"

namespace cd {
namespace CD_ISA {

namespace {

constexpr int kLanes = kNative; // a spring's law takes all registers
using V = Vector<kLanes>;
constexpr ptrdiff_t kBefore = 8;

// Symmetric numbers in the order of ClothMatrix::ground, the last three null: they are 0.
template <int N> Vector<N> times(const double* const* planes, size_t at, Vector<N> v) {
    const auto of = [&](int k) { return Lanes<N>::load(planes[k] + at); };
    if (!planes[3]) return {of(0) * v.x, of(1) * v.y, of(2) * v.z};
    const Lanes<N> xy = of(3), xz = of(4), yz = of(5);
    return {of(0) * v.x + (xy * v.y + xz * v.z), of(1) * v.y + (xy * v.x + yz * v.z),
            of(2) * v.z + (xz * v.x + yz * v.y)};
}

// The force of spring `number` at `at`, whose ends are apart by `way`: how it pulls at its start.
struct Pull {
    const ClothSprings& springs;
    const ClothMatrix& matrix;
    double h, dt;
    bool curves;

    template <int N> Vector<N> force(int number, size_t at, Vector<N> way, bool keeps) const {
        using L = Lanes<N>;
        const L stiffness = L::load(springs.stiffness[number] + at), length = L::load(springs.length[number] + at);
        const L compression = number <= kAlongV ? L::load(springs.compression[number] + at) : L{};
        const L now = root(dot(way, way)), excess = now - length, per_length = L::splat(1) / length;
        const L taut = positive(excess), soft = smaller(taut, (2 * kSlackEnd) * length);
        const L tension = stiffness * ((1 / (4 * kSlackEnd)) * (soft * soft) * per_length + (taut - soft));
        const L per_now = L::splat(1) / larger(now, 0.5 * length), along = tension * per_now;
        if (curves && keeps) {
            // Looks ahead by half of the soft part: what is nearly taut will be.
            const L rising = within((0.5 / kSlackEnd) * (excess * per_length) + L::splat(0.5), 0, 1);
            const L most = (h * dt) * (stiffness * rising), across = smaller((h * dt) * along, most);
            ((h * dt) * compression + across).store(matrix.spring[number].plane[0] + at);
            ((root(most - across) * per_now) * way).store(matrix.spring[number].plane + 1, at);
        }
        return (h * (along + compression)) * way;
    }
};

// What keeps springs from crumpling pushes them towards their length: compression (l - L), of which the first part is
// Pull's and this one the second.
struct Unfold {
    const ClothSprings& springs;
    double h;

    template <int N> Vector<N> force(int number, size_t at, Vector<N> way, bool) const {
        using L = Lanes<N>;
        if (number > kAlongV) return Vector<N>{};
        const L length = L::load(springs.length[number] + at);
        const L now = larger(root(dot(way, way)), kLeastDirection * length);
        return (-h * (L::load(springs.compression[number] + at) * length) / now) * way;
    }
};

// The product of a spring's curvature with a difference.
struct Product {
    const ClothMatrix& matrix;

    template <int N> Vector<N> force(int number, size_t at, Vector<N> way, bool) const {
        using L = Lanes<N>;
        const double* const* const plane = matrix.spring[number].plane;
        const Vector<N> a = Vector<N>::load(plane + 1, at);
        return L::load(plane[0] + at) * way + dot(a, way) * a;
    }
};

// node(at, pull) for every node of these rows, in bundles, pull the sum of what `law` says that its springs pull by, at
// x. Forces lie in rows of scratch until both ends of a spring have had them.
template <class Law, class Node> void sum_springs(const Grid& grid, const Law& law, const double* const* x,
                                                  double* scratch, size_t first, size_t count, const Node& node) {
    double *force[kClothSprings][3], *carried[3];
    for (int k = 0; k < 3; ++k) {
        for (int number = 0; number < kClothSprings; ++number)
            force[number][k] = scratch + (size_t(number) * 3 + size_t(k)) * grid.pitch + kBefore;
        carried[k] = scratch + (12 + size_t(k)) * grid.pitch + kBefore;
    }
    const ptrdiff_t columns = ptrdiff_t(grid.columns);
    const auto look = [&](size_t row, bool keeps) {
        const size_t here = row * grid.pitch, below = grid.below(row) * grid.pitch;
        for (ptrdiff_t u = -kBefore; u < columns; u += kLanes) {
            const size_t at = here + size_t(u), under = below + size_t(u);
            const V self = V::load(x, at), right = V::load(x, at + 1), down = V::load(x, under),
                    across = V::load(x, under + 1);
            const V way[kClothSprings] = {right - self, down - self, across - self, down - right};
            for (int number = 0; number < kClothSprings; ++number)
                law.template force<kLanes>(number, at, way[number], keeps).store(force[number], size_t(u));
        }
    };
    const auto carry = [&](ptrdiff_t u) {
        const auto of = [&](ClothSpring number, ptrdiff_t i) { return V::load(force[number], size_t(i)); };
        (of(kAlongV, u) + of(kDiagonal, u - 1) + of(kCounterDiagonal, u)).store(carried, size_t(u));
    };
    look(grid.above(first), false);
    for (ptrdiff_t u = 0; u < columns; u += kLanes) carry(u);
    for (size_t row = first; row < first + count; ++row) {
        look(row, true);
        for (ptrdiff_t u = 0; u < columns; u += kLanes) {
            const auto of = [&](ClothSpring number, ptrdiff_t i) { return V::load(force[number], size_t(i)); };
            const V starting = of(kAlongU, u) + of(kAlongV, u) + of(kDiagonal, u) + of(kCounterDiagonal, u - 1),
                    ending = of(kAlongU, u - 1) + V::load(carried, size_t(u));
            node(row * grid.pitch + size_t(u), starting - ending);
            carry(u);
        }
    }
}

} // namespace

void cloth_residual(const Grid& grid, const ClothSprings& springs, const ClothMatrix& matrix, const ClothResidual& with,
                    const double* const* y, double* const* r, bool curves, double* scratch, size_t first,
                    size_t count) {
    using L = Lanes<kLanes>;
    sum_springs(grid, Pull{springs, matrix, with.h, with.dt, curves}, y, scratch, first, count, [&](size_t at, V pull) {
        const V own = times<kLanes>(matrix.ground, at, V::load(with.w, at));
        (L::load(matrix.moves + at) * ((V::load(with.rhs, at) - own) + pull)).store(r, at);
    });
}

void cloth_unfold(const Grid& grid, const ClothSprings& springs, double h, const double* const* y, double* const* out,
                  double* scratch, size_t first, size_t count) {
    sum_springs(grid, Unfold{springs, h}, y, scratch, first, count,
                [&](size_t at, V pull) { (V::load(out, at) + pull).store(out, at); });
}

void cloth_apply(const Grid& grid, const ClothMatrix& matrix, const double* const* p, double* const* q, double* scratch,
                 size_t first, size_t count) {
    using L = Lanes<kLanes>;
    sum_springs(grid, Product{matrix}, p, scratch, first, count, [&](size_t at, V pull) {
        (L::load(matrix.moves + at) * (times<kLanes>(matrix.ground, at, V::load(p, at)) - pull)).store(q, at);
    });
}

// With m_i = b_i (p_{i-1} - 2 p_i + p_{i+1}) the bend of a line is m_{i-1} - 2 m_i + m_{i+1} at node i; with
// t = twist (p_00 - p_10 - p_01 + p_11) of a cell the twist is t at two corners and -t at the others. Moments lie in
// rows of scratch: of one row along u, of three rows along v, of the cells of two rows.
void cloth_bend(const Grid& grid, const ClothMatrix& matrix, double factor, const double* const* p, double* const* q,
                double* scratch, size_t first, size_t count) {
    using L = Lanes<kLanes>;
    const ptrdiff_t columns = ptrdiff_t(grid.columns);
    double* moment[6];
    for (int k = 0; k < 6; ++k) moment[k] = scratch + size_t(k) * grid.pitch + kBefore;
    for (int k = 0; k < 3; ++k) {
        const double* const x = p[k];
        double *const along_u = moment[0], *along_v[3] = {moment[1], moment[2], moment[3]};
        double* cells[2] = {moment[4], moment[5]};
        const auto load = [](const double* row, ptrdiff_t u) { return L::load(row + u); };
        const auto find_along_v = [&](size_t row, double* out) {
            const double *const here = x + row * grid.pitch, *const above = x + grid.above(row) * grid.pitch,
                                *const below = x + grid.below(row) * grid.pitch;
            const double* const bend = matrix.bend[1] + row * grid.pitch;
            for (ptrdiff_t u = 0; u < columns; u += kLanes) {
                const L middle = load(here, u);
                (load(bend, u) * ((load(above, u) - middle) + (load(below, u) - middle))).store(out + u);
            }
        };
        const auto find_cells = [&](size_t row, double* out) {
            const double *const here = x + row * grid.pitch, *const below = x + grid.below(row) * grid.pitch;
            const double* const twist = matrix.twist + row * grid.pitch;
            for (ptrdiff_t u = -kBefore; u < columns; u += kLanes)
                (load(twist, u) * ((load(below, u + 1) - load(below, u)) - (load(here, u + 1) - load(here, u))))
                    .store(out + u);
        };
        find_along_v(grid.above(first), along_v[1]);
        find_along_v(first, along_v[2]);
        find_cells(grid.above(first), cells[1]);
        for (size_t row = first; row < first + count; ++row) {
            double* const oldest = along_v[0];
            along_v[0] = along_v[1], along_v[1] = along_v[2], along_v[2] = oldest;
            std::swap(cells[0], cells[1]);
            find_along_v(grid.below(row), along_v[2]);
            find_cells(row, cells[1]);
            const double *const here = x + row * grid.pitch, *const bend = matrix.bend[0] + row * grid.pitch;
            for (ptrdiff_t u = -kBefore; u < columns + 1; u += kLanes) {
                const L middle = load(here, u);
                (load(bend, u) * ((load(here, u - 1) - middle) + (load(here, u + 1) - middle))).store(along_u + u);
            }
            const double* const moves = matrix.moves + row * grid.pitch;
            double* const out = q[k] + row * grid.pitch;
            for (ptrdiff_t u = 0; u < columns; u += kLanes) {
                const L middle_u = load(along_u, u), middle_v = load(along_v[1], u);
                const L bent = ((load(along_u, u - 1) - middle_u) + (load(along_u, u + 1) - middle_u)) +
                               ((load(along_v[0], u) - middle_v) + (load(along_v[2], u) - middle_v));
                const L twisted =
                    (load(cells[1], u) - load(cells[1], u - 1)) - (load(cells[0], u) - load(cells[0], u - 1));
                (load(out, u) + factor * (load(moves, u) * (bent + twisted))).store(out + u);
            }
        }
    }
}

void cloth_blocks(const Grid& grid, const ClothMatrix& matrix, double* const* out, size_t first, size_t count) {
    using L = Lanes<kLanes>;
    static constexpr int kRow[6] = {1, 2, 3, 1, 1, 2}, kColumn[6] = {1, 2, 3, 2, 3, 3};
    for (size_t row = first; row < first + count; ++row) {
        const size_t above = grid.above(row) * grid.pitch, below = grid.below(row) * grid.pitch;
        for (size_t u = 0; u < grid.columns; u += size_t(kLanes)) {
            const size_t at = row * grid.pitch + u, over = above + u;
            // The springs that end or start at a node: number and place.
            const struct {
                int number;
                size_t at;
            } touching[8] = {{kAlongU, at},
                             {kAlongU, at - 1},
                             {kAlongV, at},
                             {kAlongV, over},
                             {kDiagonal, at},
                             {kDiagonal, over - 1},
                             {kCounterDiagonal, at - 1},
                             {kCounterDiagonal, over}};
            L alike{};
            for (const auto& t : touching) alike = alike + L::load(matrix.spring[t.number].plane[0] + t.at);
            if (CD_WITH_BEND && matrix.twist) {
                const auto number = [&](const double* plane, size_t i) { return L::load(plane + i); };
                alike = alike + ((number(matrix.bend[0], at - 1) + number(matrix.bend[0], at + 1)) +
                                 (number(matrix.bend[1], over) + number(matrix.bend[1], below + u)));
                alike = alike + 4 * (number(matrix.bend[0], at) + number(matrix.bend[1], at));
                alike = alike + ((number(matrix.twist, at) + number(matrix.twist, at - 1)) +
                                 (number(matrix.twist, over) + number(matrix.twist, over - 1)));
            }
            for (int k = 0; k < 6; ++k) {
                L sum = k < 3              ? L::load(matrix.ground[k] + at) + alike
                        : matrix.ground[k] ? L::load(matrix.ground[k] + at)
                                           : L{};
                for (const auto& t : touching) {
                    const double* const* const plane = matrix.spring[t.number].plane;
                    sum = sum + L::load(plane[kRow[k]] + t.at) * L::load(plane[kColumn[k]] + t.at);
                }
                sum.store(out[k] + at);
            }
        }
    }
}

} // namespace CD_ISA
} // namespace cd
