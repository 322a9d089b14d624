/* A second way to make the implicit steps, in long double: the chain as rows of spring forces.
 *
 * Each spring, bend term and attachment is a row r with a stiffness kappa_r and at most three coefficients B_r. The
 * unknowns are the rows' forces tau, not the nodes' velocities:
 *
 *     (1 / (kappa h (h + beta)) + B W B^T) tau = right side,      W = 1 / (m (1 + h alpha) + h c)
 *
 * A spring stiffer than anything is a row whose 1 / kappa is 0: the system's condition is that of the lattice (n^2,
 * with bend n^4) however stiff it is, and nothing in it is shared with the library's elimination. Where stiff rows fix
 * more than the nodes can give (springs between two held nodes, stretch and bend both stiff), 1 / kappa alone decides
 * how they share the load, and digits are lost as kappa h^2 / m grows. */
#ifndef REFERENCE_H
#define REFERENCE_H

#include <stddef.h>
#include <stdint.h>

#include <contdyn/contdyn.h>

struct reference {
    size_t nodes;
    int ring;
    long double *x, *v;
    long double* mass;    /* INFINITY: pinned, or driven by its v */
    long double* stretch; /* spring i joins node i and i + 1, in a ring the last one closes it; INFINITY: welded */
    long double* bend;    /* of the node in the middle */
    long double* force;   /* gravity included */
    long double *anchor_stiffness, *anchor_damping, *target;
    long double drag, stiffness_damping;

    size_t rows, width; /* of the band */
    struct reference_row {
        size_t node[3];
        long double coefficient[3], kappa, target;
        int terms, kind;
        long double lag, pull; /* h + beta, and 1 / (h (h + beta)) */
    } * row;
    long double *weight, *band, *tau, *a;
    long double factored_for;
};

/* One line, all free, mass 1 and stretch 1 per node and spring, the rest 0. */
struct reference* reference_create(size_t nodes);
struct reference* reference_copy(const struct reference* r);
void reference_destroy(struct reference* r);

/* Call after any change of a parameter. */
void reference_changed(struct reference* r);

/* lambda in (0, 1], or stiff second order with lambda = 0. */
void reference_step(struct reference* r, cd_method method, double lambda, long double dt, size_t count);

/* Reproducible numbers in [-1, 1). */
double random_number(uint64_t* state);

#endif
