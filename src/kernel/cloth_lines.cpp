// Lines of cloth down the columns, eliminated by blocks of three: with the block G_j of a node and the curvature S_j of
// the spring to the next one, what is left of G_j is D_j = G_j - S_{j-1} D_{j-1}^-1 S_{j-1}. Where a node does not
// move, 0 stands for the inverse. (model.md, 47)
#include "kernel/cloth.hh"
#include "kernel/vectors.hh"

namespace cd {
namespace CD_ISA {

namespace {

constexpr int kLanes = kNative;
using L = Lanes<kLanes>;
using V = Vector<kLanes>;

// Symmetric: xx yy zz xy xz yz.
struct Block {
    L xx, yy, zz, xy, xz, yz;

    static Block load(double* const* planes, size_t at) {
        const auto of = [&](int k) { return L::load(planes[k] + at); };
        return {of(0), of(1), of(2), of(3), of(4), of(5)};
    }
    void store(double* const* planes, size_t at) const {
        const L* const number[6] = {&xx, &yy, &zz, &xy, &xz, &yz};
        for (int k = 0; k < 6; ++k) number[k]->store(planes[k] + at);
    }
    V times(V v) const {
        return {xx * v.x + (xy * v.y + xz * v.z), yy * v.y + (xy * v.x + yz * v.z), zz * v.z + (xz * v.x + yz * v.y)};
    }
};

V product(const ClothCurvature& spring, size_t at, V v) {
    const V a = V::load(spring.plane + 1, at);
    return L::load(spring.plane[0] + at) * v + dot(a, v) * a;
}

// With S = s 1 + a a^T and P symmetric: S P S = s^2 P + a h^T + h a^T, h = s P a + (a P a) / 2 a.
Block hanging(L s, V a, const Block& p) {
    const V pa = p.times(a), h = s * pa + (0.5 * dot(a, pa)) * a;
    const L square = s * s;
    return {square * p.xx + 2 * (a.x * h.x),         square * p.yy + 2 * (a.y * h.y),
            square * p.zz + 2 * (a.z * h.z),         square * p.xy + (a.x * h.y + a.y * h.x),
            square * p.xz + (a.x * h.z + a.z * h.x), square * p.yz + (a.y * h.z + a.z * h.y)};
}

} // namespace

// Rows on the outside: the bundles of a row do not wait for each other.
void cloth_factor(const Grid& grid, const ClothCurvature& spring, const double* moves, double* const* blocks,
                  size_t first, size_t count) {
    for (size_t row = 0; row < grid.rows; ++row)
        for (size_t u = first; u < first + count; u += size_t(kLanes)) {
            const size_t at = row * grid.pitch + u;
            Block g = Block::load(blocks, at);
            if (row > 0) {
                const size_t over = at - grid.pitch;
                const Block less = hanging(L::load(spring.plane[0] + over), V::load(spring.plane + 1, over),
                                           Block::load(blocks, over));
                g = {g.xx - less.xx, g.yy - less.yy, g.zz - less.zz, g.xy - less.xy, g.xz - less.xz, g.yz - less.yz};
            }
            const L x = g.yy * g.zz - g.yz * g.yz, y = g.xz * g.yz - g.xy * g.zz, z = g.xy * g.yz - g.xz * g.yy;
            const L there = L::load(moves + at), determinant = g.xx * x + (g.xy * y + g.xz * z);
            const L by = there / select(there, determinant, L::splat(1));
            const Block inverse{by * x, by * (g.xx * g.zz - g.xz * g.xz), by * (g.xx * g.yy - g.xy * g.xy), by * y,
                                by * z, by * (g.xy * g.xz - g.xx * g.yz)};
            inverse.store(blocks, at);
        }
}

void cloth_solve(const Grid& grid, const ClothCurvature& spring, double* const* blocks, const double* const* right,
                 double* const* z, size_t first, size_t count) {
    for (size_t row = 0; row < grid.rows; ++row)
        for (size_t u = first; u < first + count; u += size_t(kLanes)) {
            const size_t at = row * grid.pitch + u;
            V sum = V::load(right, at);
            if (row > 0) sum = sum + product(spring, at - grid.pitch, V::load(z, at - grid.pitch));
            Block::load(blocks, at).times(sum).store(z, at);
        }
    for (size_t row = grid.rows - 1; row-- > 0;)
        for (size_t u = first; u < first + count; u += size_t(kLanes)) {
            const size_t at = row * grid.pitch + u;
            const V pulled = product(spring, at, V::load(z, at + grid.pitch));
            (V::load(z, at) + Block::load(blocks, at).times(pulled)).store(z, at);
        }
}

} // namespace CD_ISA
} // namespace cd
