/* Closed forms of uniform sheets: modes that are products of a line's modes along u and along v, and what a time step
 * does to one of them, with the system solved as it is or factored into the two directions. Long double. */
#ifndef SHEET_H
#define SHEET_H

#include <contdyn/membrane.h>

#include "modes.h"

/* What holds the two ends of a direction. */
enum sheet_ends { SHEET_FREE, SHEET_FIXED, SHEET_FIXED_FREE, SHEET_RING };

struct sheet {
    enum sheet_ends ends[2]; /* along u and along v; with bend fixed or ring: the edges are hinged */
    size_t nodes[2];
    cd_mass_rule rule;
    double mass, stiffness[2], bend; /* totals */
    double drag, damping;
};

/* A membrane of the library with these edges and parameters, and its whole state: one number per node and component. */
cd_membrane* sheet_membrane(const struct sheet* sheet, size_t components, cd_precision precision);
size_t sheet_nodes(const cd_membrane* membrane);
size_t sheet_components(const cd_membrane* membrane);
void sheet_read(const cd_membrane* membrane, cd_field field, double* out_values);
void sheet_write(cd_membrane* membrane, cd_field field, const double* values);

/* Nothing is read or written through these but a field of one number per node or spring. */
double sheet_get(const cd_membrane* membrane, cd_field field, size_t u, size_t v);
void sheet_set(cd_membrane* membrane, cd_field field, size_t u, size_t v, double value);

/* Energies added up; kinetic + elastic leaves gravity out. */
double sheet_energy(const cd_membrane* membrane);
double sheet_swing_energy(const cd_membrane* membrane);

/* Per node and per spring, for the lines inside the sheet. */
long double sheet_node_mass(const struct sheet* sheet);
long double sheet_spring(const struct sheet* sheet, int direction);
long double sheet_bend(const struct sheet* sheet, int direction);

/* Modes first .. last of a direction. Where nothing holds it the first is 0, the shift. */
size_t sheet_first_mode(const struct sheet* sheet, int direction);
size_t sheet_last_mode(const struct sheet* sheet, int direction);

/* The shape of line mode j at node i, and of mode (p, q) at node (u, v). */
long double sheet_line_shape(const struct sheet* sheet, int direction, size_t j, size_t i);
long double sheet_shape(const struct sheet* sheet, size_t p, size_t q, size_t u, size_t v);

/* omega^2 of a mode, by where it comes from: each direction's stretch and bend, of that its bend, and the twist. */
struct sheet_mode {
    long double along[2], bend[2], twist;
};
struct sheet_mode sheet_mode(const struct sheet* sheet, size_t p, size_t q);
long double sheet_omega(const struct sheet_mode* mode);

/* The highest omega that the lattice could have: omega dt = 2 is the explicit limit. */
long double sheet_omega_max(const struct sheet* sheet);

/* (x, v) after a step is this times (x, v). */
struct matrix2 sheet_step_matrix(const struct sheet* sheet, const struct sheet_mode* mode, const struct time_step* step,
                                 cd_solver solver, long double dt);

void sheet_set_time_step(cd_membrane* membrane, const struct time_step* step);
int sheet_solves(const struct time_step* step); /* whether a step of this kind has a system to solve */

/* Steps, and takes it that a tolerance asks for more than rounding leaves: returns whether it was met. */
int sheet_step(cd_membrane* membrane, double dt, size_t count);

#endif
