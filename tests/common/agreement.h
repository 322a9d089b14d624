/* How close a chain of the library stays to the reference integrator that starts from the very same numbers. */
#ifndef AGREEMENT_H
#define AGREEMENT_H

#include "modes.h"
#include "reference.h"

/* What is allowed: errors over the largest exact number, now or at the start, after 1 step and after 1000. Where 1000
 * steps err more, `slack` times the error of a chain that computes exactly and only rounds its state to the precision's
 * numbers after each step: no chain that keeps its state in them can be asked for more. slack 0: no such excuse. */
struct limits {
    double once, thousand, slack;
};
extern const struct limits float32_limits; /* 1e-5, 1e-4, 3: the library solves in float64 */
extern const struct limits float64_limits; /* 1e-13, 1e-10, 300: a rounding while solving reaches all nodes */

/* With bend a rounding at one node turns all that hangs beyond it, and so costs more than rounding the state. */
extern const struct limits float32_rod_limits; /* 1e-5, 1e-4, 30 */
extern const struct limits float64_rod_limits; /* 1e-12, 3e-9, 1000 */

/* A chain with the reference's parameters and state, one strand of one component. First the reference's own numbers are
 * rounded to the precision; afterwards it has the velocities that welding left in the chain. Free nodes of infinite
 * mass are pinned. */
cd_chain* chain_like(struct reference* r, cd_precision precision);

/* Runs both from `start`, which is left alone, and prints the figures with `what` before them. 0: within the limits. */
int misses(const char* what, const struct reference* start, cd_precision precision, const struct time_step* way,
           double dt, struct limits limits);

#endif
