// What steps of cloth compute with, handed out from the membrane's two arrays in the order in which it is declared.
#pragma once

#include "kernel/cloth.hh"
#include "model/membrane.hh"
#include "solve/planes.hh"

namespace cd {

// A node and what it may touch in a step. (model.md, 47)
struct ClothContact {
    double at;          // place of the node in the planes
    double collider;    // its index
    double normal[3];   // of the collider where the step finds the node
    double gap;         // outside of it when the step begins [m]
    double room;        // how far the node may go against it [m], the collider's own motion counted
    double stiffness;   // [kg], of the impulse that keeps it out
    double friction;    // the coefficient
    double velocity[3]; // of the collider
    double push;        // the impulse by the last iteration, which friction goes by
    double met;         // 1 once an iteration has led into the collider
};

constexpr size_t kBefore = 8; // numbers of room before each row of a plane

struct ClothWork {
    Grid grid, turned;
    Parts parts, strips; // of rows, and of columns

    // coefficients: planes
    double *stiffness[kClothSprings], *length[kClothSprings], *compression[2], *bend[2], *twist;
    double *mass, *moves, *turned_moves;
    size_t* part; // of nodes that springs join, held ones among them: the place of the part's first node

    // scratch: planes, three for a vector
    double *from[3], *to[3];         // positions before and after the step
    double *w[3], *trial[3];         // the velocity that moves the nodes
    double *rhs[3], *residual[3];    // see ClothResidual
    double* given[3];                // rhs without springs against crumpling
    double* expected[3];             // velocities by which these expect to turn
    double *direction[3], *error[3]; // of Newton's method, and what is left of its system
    double *conjugate[3], *image[3]; // a conjugate direction and the matrix times it
    double *answer[3], *turned_z[3]; // of lines along v and along u
    double* recycled[2][3];          // what the last step changed, and Newton's last direction
    double* bound;                   // at a part's first node: 1 if it is held or has touched a collider
    double *inertia, *own[6];        // ground without contacts: all three the same, or with air symmetric blocks
    double* ground[6];               // with contacts
    double *curvature[kClothSprings][4], *turned_curvature[4], *block[6], *turned_block[6];
    double *rows, *sums; // kClothRows rows for each part; a number per row
    ClothContact* contacts;
    double* question; // of callbacks: places of nodes, gaps, normals

    ClothWork(const Membrane& m, const MembraneFeatures& f, Carver& coefficients, Carver& scratch);
    bool has_blocks() const { return own[3] != nullptr; }
    bool has_bend() const { return CD_WITH_BEND && twist; }
    ClothSprings springs() const;
    ClothMatrix matrix(double* const* with_ground) const;
    size_t place(size_t u, size_t v) const { return v * grid.pitch + u; }
    template <class F> void each_place(F f) const {
        for (size_t v = 0; v < grid.rows; ++v)
            for (size_t u = 0; u < grid.columns; ++u) f(place(u, v));
    }
};

// Makes the coefficients for steps of dt whose impulses are those of h.
void prepare(const Membrane& m, ClothWork& w, double h, double dt);

// Shifts w so that every part of the sheet that is free has the momentum that it should, and puts the velocity that
// such a part has as a whole into `error`, at the part's first node: springs cancel in its balance. Of any other part
// that is, along each axis, the least that all that holds or pushes it moves by. False if none is free.
bool share_momentum(const ClothWork& w, size_t contacts);

// Cuts springs that are beyond their breaking strain (membrane_cloth_tear.cpp); tells how many.
size_t tear_springs(Membrane& m, ClothWork& w);

// ---- what surrounds cloth (membrane_cloth_act.cpp) ----

// x with matrix x = right, by elimination: matrix is symmetric, of 3 rows in the order of ClothMatrix::ground. False if it
// is not positive definite.
bool solve_block(const double* matrix, const double* right, double* x);

// Adds the air to ground and right side for a step of impulses h.
void add_air(const Membrane& m, ClothWork& w, double h);
// The most contacts of a node in one step: with the nearest colliders.
constexpr size_t kMostTouched = 3;
inline size_t most_contacts(size_t colliders) { return colliders < kMostTouched ? colliders : kMostTouched; }
// These are there in builds with colliders only.
// Finds what nodes may touch in a step of dt that begins at the time `now`; tells how many contacts there are.
size_t find_contacts(Membrane& m, ClothWork& w, double now, double dt);
// Friction goes by the pushes at `velocity` from here on, where the residual without contacts is `rest`.
void take_pushes(const ClothWork& w, size_t contacts, double dt, double* const* velocity, double* const* rest);
// Finds in w what leads nodes that lie inside colliders out of there: `image` gets it, and `trial` the rest of w. False if
// none lies inside.
bool find_ways_out(const ClothWork& w, size_t contacts, double dt);
// Whether the velocities w lead into a collider; the parts that touch one are bound from here on.
bool touches(const ClothWork& w, size_t contacts, double dt);
// Widens the ranges of velocities at the first nodes of bound parts by those of the colliders that these have met.
void widen_by_contacts(const ClothWork& w, size_t contacts, double* const* least, double* const* most);
// residual += the contacts' impulses at `velocity`; ground, if not null, gets their stiffness.
void add_contacts(const ClothWork& w, size_t contacts, double dt, double* const* velocity, double* const* residual,
                  double* const* ground);
// What is pushed leaves a contact as fast as w has it, and what came out of a collider is not thrown. Of the residual it
// takes lambda times the momentum that this gives.
void settle_contacts(const ClothWork& w, size_t contacts, double dt, double lambda, double* const* velocity);
// Tells what nodes do to colliders: the residual is that of w without contacts, and `from` is where the step ends.
void tell_loads(const Membrane& m, const ClothWork& w, size_t contacts, double dt);

} // namespace cd
