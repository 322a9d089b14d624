/* Closed forms of the regular lattice: the modes of a uniform chain under each end condition, and what each time step
 * does to one mode. Long double, so that they are exact beside what is tested. */
#ifndef MODES_H
#define MODES_H

#include <contdyn/contdyn.h>

#define PI 3.14159265358979323846264338327950288L

enum lattice {
    FREE_FREE,
    FIXED_FREE,
    FREE_FIXED,
    FIXED_FIXED,
    HALF_ENDS, /* free, with half masses at the ends */
    RING,
    HINGED,      /* bend only, both ends pinned */
    HINGED_BOTH, /* bend and stretch, both ends pinned */
    RING_BOTH,   /* bend and stretch */
    LATTICES
};
extern const char* const lattice_names[LATTICES];

struct lattice_chain {
    enum lattice ends;
    size_t nodes;
    double mass, stiffness, bend; /* totals; stiffness and bend act where the lattice has them */
    double drag, stiffness_damping;
};

/* A chain of the library with these ends and parameters. */
cd_chain* make_lattice_chain(const struct lattice_chain* lattice, size_t strands, size_t components,
                             cd_precision precision);

/* Modes 1 to lattice_last_mode swing; where nothing holds the chain, mode 0 is the shift of all of it. */
int lattice_is_free(const struct lattice_chain* lattice);
size_t lattice_last_mode(const struct lattice_chain* lattice);

/* Angular frequency of mode j without damping [1/s], and its shape at node i. */
long double lattice_omega(const struct lattice_chain* lattice, size_t j);
long double lattice_shape(const struct lattice_chain* lattice, size_t j, size_t i);

/* The highest omega that the lattice could have: omega dt = 2 is the explicit limit. */
long double lattice_omega_max(const struct lattice_chain* lattice);

/* A way of stepping. */
struct time_step {
    const char* name;
    cd_method method;
    double lambda;
    int grows;       /* an undamped mode grows at every dt */
    int is_explicit; /* needs no solve */
};
enum {
    FORWARD_EULER,
    SYMPLECTIC_EULER,
    LAMBDA_0,
    LAMBDA_1_4,
    LAMBDA_1_2, /* from here on no step is too long */
    LAMBDA_3_4,
    LAMBDA_1,
    STIFF_SECOND,
    TIME_STEPS
};
extern const struct time_step time_steps[TIME_STEPS];

void set_time_step(cd_chain* chain, const struct time_step* step);

/* (x, v) after a step is this times (x, v), for x'' + c x' + omega^2 x = 0. */
struct matrix2 {
    long double a[2][2];
};
struct matrix2 step_matrix(const struct time_step* step, long double dt, long double omega, long double c);
struct matrix2 matrix_times(struct matrix2 a, struct matrix2 b);
struct matrix2 matrix_power(struct matrix2 a, unsigned long n);

#endif
