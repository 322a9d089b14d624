/* Objects of every kind that leave the finite range. */
#ifndef UNSTABLE_H
#define UNSTABLE_H

#include "kind.h"

enum { UNSTABLE_CASES = 6, UNSTABLE_GOOD = 3 };

/* Explicit chains of 20 strands, 9 springs and 2 components, of which the strand in the middle diverges first, and
 * membranes of 6 x 5 springs, in steps beyond their limit; and a lake of 9 x 6 cells that a source fills beyond all
 * bounds, after UNSTABLE_GOOD steps have gone well. */
struct unstable {
    const struct kind* kind;
    size_t cases;
    struct {
        cd_precision precision;
        cd_method method;
    } list[UNSTABLE_CASES];
    uint64_t good;  /* steps that a new one has made */
    uint64_t least; /* the first bad step is later than this one */
    bool stays;     /* whatever later steps make of it; else numbers may become finite again */
};
extern const struct unstable unstables[KINDS];

#define FOR_UNSTABLE(u, i)                                                 \
    for (const struct unstable* u = unstables; u < unstables + KINDS; ++u) \
        for (size_t i = 0; i < u->cases; ++i)

/* Before it diverges, and after; steps of out_dt are those in which it does, of out_small far less. */
any* unstable_new(const struct unstable* u, size_t i, double* out_dt, double* out_small);
any* unstable_diverged(const struct unstable* u, size_t i, double* out_dt, double* out_small);

/* Takes away what makes a water diverge. */
void unstable_calm(const struct unstable* u, any* object);

/* Lays it out anew, at rest and calm. */
void unstable_lay_out(const struct unstable* u, any* object);

#endif
