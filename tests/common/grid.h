/* A second way to write down a sheet, in long double: as a list of terms 1/2 kappa |B x|^2, one for every spring, bend,
 * twist and tie, each with at most four coefficients. Forces, energies and residuals are sums over it, and systems are
 * solved as a whole by Cholesky's method. Nothing in it is shared with the library's line solvers. Made from what a
 * membrane's getters tell, by the rules of membrane.h. */
#ifndef GRID_H
#define GRID_H

#include <contdyn/membrane.h>

#include "modes.h"

enum grid_kind { GRID_ALONG_U = 0, GRID_ALONG_V = 1, GRID_TWIST = 2, GRID_TIE = 3, GRID_ALL = 4 };

struct grid_term {
    size_t node[4];
    long double coefficient[4], kappa, target[4]; /* ties: one target per component */
    int count;
    enum grid_kind kind; /* bends are of the direction that they lie in */
};

struct grid {
    size_t columns, rows, nodes, components;
    long double *mass, *impedance; /* per node; impedance: dampers of ties and matched edges [N s/m] */
    unsigned char* held;           /* pinned, driven or absent: its velocity stays */
    unsigned char* absent;
    long double drag, damping, gravity[4];
    long double* force; /* of CD_FORCE: per node and component */
    struct grid_term* term;
    size_t terms;
    /* the factors of diagonal + s K between the nodes that are free: row i from column start[i] on */
    size_t *number, *start, *offset, unknowns;
    long double* factor;
};

struct grid* grid_of(const cd_membrane* membrane);
struct grid* grid_of_bend(cd_membrane* membrane); /* of its bend alone */
void grid_destroy(struct grid* grid);

/* out = K x of one component, ties to targets at 0; with a kind other than GRID_ALL that part of it. 0 where held. */
void grid_stiffness(const struct grid* grid, enum grid_kind kind, const long double* x, long double* out);

/* Energies of all components; x and v as the library lists them. */
long double grid_elastic_energy(const struct grid* grid, const double* x);
long double grid_kinetic_energy(const struct grid* grid, const double* v);

/* The implicit stage's system of length h: b = M v + h (f - K x) of one component, the dampers of ties pulling to rest,
 * and S w = (M + h C + h^2 K) w. Held nodes get 0: what drives them is in S w of the others. */
void grid_right_side(const struct grid* grid, size_t component, long double h, const double* x, const double* v,
                     long double* out);
void grid_system(const struct grid* grid, long double h, const long double* w, long double* out);
/* The diagonal of S; of held nodes 1. */
void grid_diagonal(const struct grid* grid, long double h, long double* out);

/* Solves K x = side between the free nodes, in place; x of the held nodes is what `side` says there. */
void grid_solve_static(struct grid* grid, long double* side);

/* Where the sheet comes to rest under its gravity, forces and ties; x of the held nodes stays. */
void grid_rest(struct grid* grid, double* x);

/* `count` steps of this length, every system solved to rounding. Not for pressure. */
void grid_step(struct grid* grid, const struct time_step* step, long double dt, size_t count, double* x, double* v);

#endif
