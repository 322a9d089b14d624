/* Sheets with everything that makes them differ from a uniform one, for tests that go through all kinds. */
#ifndef WILD_H
#define WILD_H

#include <contdyn/membrane.h>

#include <stdint.h>

enum wild {
    WILD_FREE, /* up to WILD_SEPARABLE both directions of these can be factored, whatever the step */
    WILD_HALF_EDGES,
    WILD_DRUM,
    WILD_FLAG,
    WILD_TORUS,
    WILD_ROWS_HELD, /* two rows inside are pinned from end to end */
    WILD_ANISOTROPIC,
    WILD_HINGED, /* with bend */
    WILD_PLATE_RING,
    WILD_SEPARABLE,
    WILD_CORNERS = WILD_SEPARABLE, /* two corners pinned */
    WILD_PINS,                     /* some nodes inside are pinned */
    WILD_ROUND,                    /* the corners are masked away */
    WILD_CUT,                      /* a row of springs is cut */
    WILD_RANDOM_SPRINGS,
    WILD_RANDOM_MASSES,
    WILD_RANDOM_ALL, /* masses, springs, pins, mask */
    WILD_TIED,
    WILD_CYLINDER_PIN, /* a ring with one pinned node */
    WILD_PLATE_FREE,
    WILD_PLATE_CORNERS,
    WILD_PLATE_ROUND,
    WILD_KINDS
};
extern const char* const wild_names[WILD_KINDS];

/* A membrane of this kind, with no gravity; stiffness is that of a spring over the mass of a node, bend likewise. */
cd_membrane* wild_membrane(enum wild kind, size_t columns, size_t rows, size_t components, cd_precision precision,
                           double stiffness_over_mass, uint64_t seed);

/* Whether both directions are factored in steps for which twice a spring's stiffness times h (h + damping) is so many
 * times a node's mass: with single pins or ties up to 1e4. */
int wild_separates(enum wild kind, double stiffest);
int wild_has_bend(enum wild kind);
int wild_drifts(enum wild kind); /* nothing holds it */

/* Random positions and velocities of these sizes; 0 velocity where held. Momentum 0 where nothing holds the sheet. */
void wild_shake(cd_membrane* membrane, double position, double velocity, uint64_t seed);

#endif
