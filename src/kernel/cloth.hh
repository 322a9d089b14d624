// What the kernels of cloth share: a sheet whose springs have a length, so that they act along themselves and the three
// components of a node move together. (model.md, 42 to 48)
//
// Four springs start at a node: along u, along v, and the two diagonals of the cell that starts there, of which the
// second leads from the next node along u to the next one along v. Planes are those of sheet.hh, with eight numbers of
// room before each row and as many after its last whole bundle; there, as at every spring that is none, a stiffness is
// 0 and a length 1. Round a ring the two columns beyond each end hold what lies there.
#pragma once

#include "kernel/sheet.hh"

namespace cd {

constexpr int kClothSprings = 4;
enum ClothSpring { kAlongU = 0, kAlongV = 1, kDiagonal = 2, kCounterDiagonal = 3 };

// Cloth is slack up to its length L and has all of its stiffness from (1 + 2 kSlackEnd) L on.
constexpr double kSlackEnd = 0.003;
// Below this part of its length a spring that resists crumpling does so less and less: it has no direction at 0.
constexpr double kLeastDirection = 1e-6;

struct ClothSprings {
    const double* stiffness[kClothSprings];
    const double* length[kClothSprings]; // both diagonals have the same
    const double* compression[2];        // of springs along u and v: stiffness towards their length, from both sides
};

// A curvature s 1 + a a^T of each spring: planes of s and of the components of a.
struct ClothCurvature {
    double* plane[4];
};

// The matrix of a Newton iteration: ground, springs, bend.
struct ClothMatrix {
    const double* ground[6]; // xx yy zz xy xz yz; the last three null: they are 0
    ClothCurvature spring[kClothSprings];
    const double *bend[2], *twist; // null: none. Of a node along u and v, of the cell that starts at a node
    const double* moves;           // 1 where a node moves, else 0
};

// What the springs' impulses are added to: rhs - ground w, w the velocities, which what resists crumpling also goes by.
struct ClothResidual {
    double h, dt; // of impulses, and of motion
    double ahead; // how far curvatures look ahead of a spring's length, over that of the soft part of its law
    const double *rhs[3], *w[3];
};

// Numbers of scratch that a part of the rows needs, in rows of a plane.
constexpr size_t kClothRows = 9;

namespace CD_ISA {

// r = moves (rhs - ground w + h the pull of the springs at y). Where matrix.spring has planes and `curves`, they get
// the springs' curvatures, of h dt.
void cloth_residual(const Grid& grid, const ClothSprings& springs, const ClothMatrix& matrix, const ClothResidual& with,
                    const double* const* y, double* const* r, bool curves, double* scratch, size_t first, size_t count);
// to = what velocities are on average around each node: what springs expect to go on, but for needles.
void cloth_smooth(const Grid& grid, const ClothSprings& springs, const double* const* from, double* const* to,
                  size_t first, size_t count);
// h times what springs against crumpling push by at y, as far as it does not depend on where a step of dt leads: at
// their starts, and as much the other way at their ends.
void cloth_unfold(const Grid& grid, const ClothSprings& springs, double h, double dt, const double* const* y,
                  const double* const* expected, double* const* along_u, double* const* along_v, size_t first,
                  size_t count);
// out = over its stiffness, the energy that each spring against crumpling gains in a step of dt from y by the velocities
// w, beyond what its impulse takes, where it expected others: along u and along v.
void cloth_gains(const Grid& grid, const ClothSprings& springs, double dt, const double* const* y,
                 const double* const* expected, const double* const* w, double* const* out, size_t first, size_t count);
// q = moves (ground + springs) p
void cloth_apply(const Grid& grid, const ClothMatrix& matrix, const double* const* p, double* const* q, double* scratch,
                 size_t first, size_t count);
// q += factor moves (bend and twist of p)
void cloth_bend(const Grid& grid, const ClothMatrix& matrix, double factor, const double* const* p, double* const* q,
                double* scratch, size_t first, size_t count);
// The diagonal blocks of the matrix, as ground is laid out.
void cloth_blocks(const Grid& grid, const ClothMatrix& matrix, double* const* out, size_t first, size_t count);
// Factors lines down the columns: blocks become the inverses of what is left of them. Parts are of the columns.
void cloth_factor(const Grid& grid, const ClothCurvature& spring, const double* moves, double* const* blocks,
                  size_t first, size_t count);
// z = the answer of such lines to `right`, which may be z itself.
void cloth_solve(const Grid& grid, const ClothCurvature& spring, double* const* blocks, const double* const* right,
                 double* const* z, size_t first, size_t count);

} // namespace CD_ISA
} // namespace cd
