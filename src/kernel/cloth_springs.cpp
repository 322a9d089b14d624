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

// The numbers one place before those of `now`, of which `before` has the first one; and one place after them.
template <int N> Lanes<N> behind(Lanes<N> before, Lanes<N> now) {
    if constexpr (N == 2) return {__builtin_shufflevector(before.v, now.v, 1, 2)};
    else if constexpr (N == 4) return {__builtin_shufflevector(before.v, now.v, 3, 4, 5, 6)};
    else return {__builtin_shufflevector(before.v, now.v, 7, 8, 9, 10, 11, 12, 13, 14)};
}
template <int N> Lanes<N> ahead(Lanes<N> now, Lanes<N> after) {
    if constexpr (N == 2) return {__builtin_shufflevector(now.v, after.v, 1, 2)};
    else if constexpr (N == 4) return {__builtin_shufflevector(now.v, after.v, 1, 2, 3, 4)};
    else return {__builtin_shufflevector(now.v, after.v, 1, 2, 3, 4, 5, 6, 7, 8)};
}
template <int N> Vector<N> behind(Vector<N> before, Vector<N> now) {
    return {behind(before.x, now.x), behind(before.y, now.y), behind(before.z, now.z)};
}

// Symmetric numbers in the order of ClothMatrix::ground, the last three null: they are 0.
template <int N> CD_INLINED inline Vector<N> times(const double* const* planes, size_t at, Vector<N> v) {
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
    double h, dt, ahead;
    const double* const* velocity;
    bool curves;

    template <int N> Vector<N> force(int number, ptrdiff_t at, ptrdiff_t under, Vector<N> way, bool keeps) const {
        using L = Lanes<N>;
        const L stiffness = L::load(springs.stiffness[number] + at), length = L::load(springs.length[number] + at);
        const L compression = number <= kAlongV ? L::load(springs.compression[number] + at) : L{};
        const L now = root(dot(way, way)), excess = now - length, per_length = L::splat(1) / length;
        const L taut = positive(excess), soft = smaller(taut, (2 * kSlackEnd) * length);
        const L tension = stiffness * ((1 / (4 * kSlackEnd)) * (soft * soft) * per_length + (taut - soft));
        const L per_now = L::splat(1) / larger(now, 0.5 * length), along = tension * per_now;
        if (curves && keeps) {
            // Looks ahead: what is nearly taut will be.
            const L rising = within((0.5 / kSlackEnd) * (excess * per_length) + L::splat(ahead), 0, 1);
            const L most = (h * dt) * (stiffness * rising), across = smaller((h * dt) * along, most);
            ((h * dt) * compression + across).store(matrix.spring[number].plane[0] + at);
            ((root(most - across) * per_now) * way).store(matrix.spring[number].plane + 1, at);
        }
        if (number > kAlongV) return (h * along) * way;
        const Vector<N> moves =
            Vector<N>::load(velocity, number == kAlongU ? at + 1 : under) - Vector<N>::load(velocity, at);
        return (h * along) * way + ((h * dt) * compression) * moves;
    }
};

// Where a spring leads after a step if it goes on as it does: `turn` further, by no more than its length, to `to`.
template <int N> struct Onward {
    Vector<N> turn, to;
    Lanes<N> now; // how long it is then, as far as that has a direction

    Onward(const double* const* velocity, double dt, size_t at, size_t next, Vector<N> way, Lanes<N> length) {
        using L = Lanes<N>;
        const Vector<N> moves = L::splat(dt) * (Vector<N>::load(velocity, next) - Vector<N>::load(velocity, at));
        turn = length / larger(root(dot(moves, moves)), length) * moves;
        to = way + turn;
        now = larger(root(dot(to, to)), kLeastDirection * length);
    }
};

// The product of a spring's curvature with a difference.
struct Product {
    const ClothMatrix& matrix;

    template <int N> Vector<N> force(int number, ptrdiff_t at, ptrdiff_t, Vector<N> way, bool) const {
        using L = Lanes<N>;
        const double* const* const plane = matrix.spring[number].plane;
        const Vector<N> a = Vector<N>::load(plane + 1, at);
        return L::load(plane[0] + at) * way + dot(a, way) * a;
    }
};

// node(at, pull) for every node of these rows, in bundles, pull the sum of what `law` says that its springs pull by, at
// x. What the springs that end in a row pull by lies in a row of scratch until it is met.
template <class Law, class Node> void sum_springs(const Grid& grid, const Law& law, const double* const* x,
                                                  double* scratch, size_t first, size_t count, const Node& node) {
    double* const carried[3] = {scratch + kBefore, scratch + grid.pitch + kBefore, scratch + 2 * grid.pitch + kBefore};
    // sums(at, what the springs that start in this row pull by, at both their ends in it, what to carry)
    const auto walk = [&](size_t row, bool keeps, const auto& sums) {
        const ptrdiff_t here = ptrdiff_t(row * grid.pitch), below = ptrdiff_t(grid.below(row) * grid.pitch);
        V left[kClothSprings] = {};
        for (ptrdiff_t u = -kLanes; u < ptrdiff_t(grid.columns); u += kLanes) {
            const ptrdiff_t at = here + u, under = below + u;
            const V self = V::load(x, at), right = V::load(x, at + 1), down = V::load(x, under),
                    across = V::load(x, under + 1);
            const V way[kClothSprings] = {right - self, down - self, across - self, down - right};
            V force[kClothSprings];
            for (int number = 0; number < kClothSprings; ++number)
                force[number] = law.template force<kLanes>(number, at, under, way[number], keeps);
            const auto before = [&](ClothSpring number) { return behind(left[number], force[number]); };
            if (u >= 0)
                sums(size_t(u), force[kAlongU] + force[kAlongV] + force[kDiagonal] + before(kCounterDiagonal),
                     before(kAlongU), force[kAlongV] + before(kDiagonal) + force[kCounterDiagonal]);
            for (ClothSpring number : {kAlongU, kDiagonal, kCounterDiagonal}) left[number] = force[number];
        }
    };
    walk(grid.above(first), false, [&](size_t u, V, V, V carry) { carry.store(carried, u); });
    for (size_t row = first; row < first + count; ++row)
        walk(row, true, [&](size_t u, V starting, V along, V carry) {
            node(row * grid.pitch + u, starting - (along + V::load(carried, u)));
            carry.store(carried, u);
        });
}

} // namespace

void cloth_residual(const Grid& grid, const ClothSprings& springs, const ClothMatrix& matrix, const ClothResidual& with,
                    const double* const* y, double* const* r, bool curves, double* scratch, size_t first,
                    size_t count) {
    using L = Lanes<kLanes>;
    sum_springs(grid, Pull{springs, matrix, with.h, with.dt, with.ahead, with.w, curves}, y, scratch, first, count,
                [&](size_t at, V pull) {
                    const V own = times<kLanes>(matrix.ground, at, V::load(with.w, at));
                    (L::load(matrix.moves + at) * ((V::load(with.rhs, at) - own) + pull)).store(r, at);
                });
}

namespace {

// turns(along, at, next) for every bundle of springs along u and v that start in these rows.
template <class Turns> void each_spring(const Grid& grid, size_t first, size_t count, const Turns& turns) {
    for (size_t i = 2 * first; i < 2 * (first + count); ++i) {
        const size_t row = i / 2, along = i % 2, here = row * grid.pitch;
        const size_t beside = along == kAlongU ? here + 1 : grid.below(row) * grid.pitch;
        for (size_t u = 0; u < grid.columns; u += kLanes) turns(along, here + u, beside + u);
    }
}

} // namespace

// What keeps springs from crumpling pushes them towards their length: compression (D - L n), D their way as a step finds
// it and n the direction that they are expected to go on to, and as D changes otherwise, which is Pull's. As compression
// D and compression L n, which cancel, it would be lost in rounding.
void cloth_unfold(const Grid& grid, const ClothSprings& springs, double h, double dt, const double* const* y,
                  const double* const* expected, double* const* along_u, double* const* along_v, size_t first,
                  size_t count) {
    using L = Lanes<kLanes>;
    each_spring(grid, first, count, [&](size_t along, size_t at, size_t next) {
        const L length = L::load(springs.length[along] + at), c = h * L::load(springs.compression[along] + at);
        const Onward<kLanes> onward(expected, dt, at, next, V::load(y, next) - V::load(y, at), length);
        const V push = (c * (L::splat(1) - length / onward.now)) * onward.to - c * onward.turn;
        push.store(along == kAlongU ? along_u : along_v, at);
    });
}

// A spring whose way goes from D0 to D1 gains 1/2 c (l1 - L)^2 - 1/2 c (l0 - L)^2 and takes (D1 - D0) . c (D1 - L n).
void cloth_gains(const Grid& grid, const ClothSprings& springs, double dt, const double* const* y,
                 const double* const* expected, const double* const* w, double* const* out, size_t first,
                 size_t count) {
    using L = Lanes<kLanes>;
    each_spring(grid, first, count, [&](size_t along, size_t at, size_t next) {
        const auto way_of = [&](const double* const* planes) { return V::load(planes, next) - V::load(planes, at); };
        const V way = way_of(y), goes = L::splat(dt) * way_of(w), to = way + goes;
        const L length = L::load(springs.length[along] + at);
        const Onward<kLanes> onward(expected, dt, at, next, way, length);
        const L least = kLeastDirection * length, before = root(dot(way, way)), after = root(dot(to, to));
        const L sides = before + after;
        const auto rounded = [&](L now) { // what a spring of next to no length holds as if it were longer
            const L shorter = positive(least - now);
            return shorter * shorter / (2 * least);
        };
        const L longer = select(sides, dot(way + to, goes) / sides, L{}) + (rounded(after) - rounded(before));
        (length * (dot(onward.to, goes) / onward.now - longer) - 0.5 * dot(goes, goes)).store(out[along] + at);
    });
}

// (1 2 1) / 4 along u and then along v, where two springs meet in line.
void cloth_smooth(const Grid& grid, const ClothSprings& springs, const double* const* from, double* const* to,
                  size_t first, size_t count) {
    using L = Lanes<kLanes>;
    const auto quarter = [](L before, L after) { return select(smaller(before, after), L::splat(0.25), L{}); };
    for (size_t row = first; row < first + count; ++row)
        for (size_t u = 0; u < grid.columns; u += kLanes) {
            const auto along_u = [&](size_t of) {
                const size_t at = of * grid.pitch + u;
                const V here = V::load(from, at),
                        aside = (V::load(from, at - 1) - here) + (V::load(from, at + 1) - here);
                const double* const c = springs.compression[kAlongU] + at;
                return here + quarter(L::load(c - 1), L::load(c)) * aside;
            };
            const size_t above = grid.above(row), at = row * grid.pitch + u;
            const double* const c = springs.compression[kAlongV];
            const V here = along_u(row), aside = (along_u(above) - here) + (along_u(grid.below(row)) - here);
            (here + quarter(L::load(c + above * grid.pitch + u), L::load(c + at)) * aside).store(to, at);
        }
}

void cloth_apply(const Grid& grid, const ClothMatrix& matrix, const double* const* p, double* const* q, double* scratch,
                 size_t first, size_t count) {
    using L = Lanes<kLanes>;
    sum_springs(grid, Product{matrix}, p, scratch, first, count, [&](size_t at, V pull) {
        (L::load(matrix.moves + at) * (times<kLanes>(matrix.ground, at, V::load(p, at)) - pull)).store(q, at);
    });
}

// With m_i = b_i (p_{i-1} - 2 p_i + p_{i+1}) the bend of a line is m_{i-1} - 2 m_i + m_{i+1} at node i; with
// t = twist (p_00 - p_10 - p_01 + p_11) of a cell the twist is t at two corners and -t at the others. In rows of scratch
// lie, for each component, the moments along v of two rows and the twists of the row of cells above.
void cloth_bend(const Grid& grid, const ClothMatrix& matrix, double factor, const double* const* p, double* const* q,
                double* scratch, size_t first, size_t count) {
    using L = Lanes<kLanes>;
    const ptrdiff_t columns = ptrdiff_t(grid.columns);
    const auto start = [&](size_t row) { return ptrdiff_t(row * grid.pitch); };
    const auto right = [](const double* x, ptrdiff_t u) { return L::load(x + u + 1) - L::load(x + u); };
    // The moments of a row along v.
    struct Moments {
        const double *bend, *here, *above, *below;

        L at(ptrdiff_t u) const {
            const L x = L::load(here + u);
            return L::load(bend + u) * ((L::load(above + u) - x) + (L::load(below + u) - x));
        }
    };
    const auto along_v = [&](const double* x, size_t row) {
        return Moments{matrix.bend[1] + start(row), x + start(row), x + start(grid.above(row)),
                       x + start(grid.below(row))};
    };
    double *above[3], *here[3], *twisted[3];
    for (int k = 0; k < 3; ++k) {
        const auto row = [&](int i) { return scratch + size_t(3 * k + i) * grid.pitch + kBefore; };
        above[k] = row(0), here[k] = row(1), twisted[k] = row(2);
        const size_t before = grid.above(first);
        const Moments of_before = along_v(p[k], before), of_first = along_v(p[k], first);
        const double* const twist = matrix.twist + start(before);
        const auto cell = [&](ptrdiff_t u) {
            return L::load(twist + u) * (right(of_before.below, u) - right(of_before.here, u));
        };
        L left = cell(-kLanes);
        for (ptrdiff_t u = 0; u < columns; u += kLanes) {
            of_before.at(u).store(above[k] + u);
            of_first.at(u).store(here[k] + u);
            const L now = cell(u);
            (now - behind(left, now)).store(twisted[k] + u);
            left = now;
        }
    }
    for (size_t row = first; row < first + count; ++row)
        for (int k = 0; k < 3; ++k) {
            const Moments of_next = along_v(p[k], grid.below(row));
            const double *const x = p[k] + start(row), *const bend = matrix.bend[0] + start(row),
                                *const twist = matrix.twist + start(row), *const moves = matrix.moves + start(row);
            double *const out = q[k] + start(row), *const moments_above = above[k], *const moments = here[k],
                          *const twisted_above = twisted[k];
            const auto along_u = [&](ptrdiff_t u, L before, L now) {
                return L::load(bend + u) * (now - behind(before, now));
            };
            const auto cell = [&](ptrdiff_t u, L step) { return L::load(twist + u) * (right(of_next.here, u) - step); };
            L step = right(x, 0), before_step = right(x, -kLanes);
            L before = along_u(-kLanes, L{}, before_step), now = along_u(0, before_step, step);
            L left = cell(-kLanes, before_step);
            for (ptrdiff_t u = 0; u < columns; u += kLanes) {
                const L next_step = right(x, u + kLanes), next = along_u(u + kLanes, step, next_step);
                const L middle = L::load(moments + u), below = of_next.at(u);
                const L twists = cell(u, step), turned = twists - behind(left, twists);
                const L bent = ((behind(before, now) - now) + (ahead(now, next) - now)) +
                               ((L::load(moments_above + u) - middle) + (below - middle));
                const L sum = bent + (turned - L::load(twisted_above + u));
                (L::load(out + u) + factor * (L::load(moves + u) * sum)).store(out + u);
                below.store(moments_above + u);
                turned.store(twisted_above + u);
                before = now, now = next, step = next_step, left = twists;
            }
            std::swap(above[k], here[k]);
        }
}

void cloth_blocks(const Grid& grid, const ClothMatrix& matrix, double* const* out, size_t first, size_t count) {
    using L = Lanes<kLanes>;
    static constexpr int kRow[6] = {1, 2, 3, 1, 1, 2}, kColumn[6] = {1, 2, 3, 2, 3, 3};
    for (size_t row = first; row < first + count; ++row) {
        const ptrdiff_t here = ptrdiff_t(row * grid.pitch), above = ptrdiff_t(grid.above(row) * grid.pitch),
                        below = ptrdiff_t(grid.below(row) * grid.pitch);
        for (ptrdiff_t u = 0; u < ptrdiff_t(grid.columns); u += kLanes) {
            const ptrdiff_t at = here + u, over = above + u;
            // The springs that end or start at a node: number and place.
            const struct {
                int number;
                ptrdiff_t at;
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
                const auto number = [&](const double* plane, ptrdiff_t i) { return L::load(plane + i); };
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
