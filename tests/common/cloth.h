/* Small membranes that many tests share, and whole fields in one call; scene.h does the same for chains. Everything
 * here must succeed: if it does not, the test fails. */
#ifndef CLOTH_H
#define CLOTH_H

#include <contdyn/membrane.h>

/* A membrane as cd_membrane_create makes it, from malloc; and from an allocator, which may be null. */
cd_membrane* cloth(size_t nu, size_t nv, size_t components, cd_precision precision);
cd_membrane* cloth_from(const cd_allocator* allocator, size_t nu, size_t nv, size_t components, cd_precision precision);

/* The rectangle of a whole field: columns and rows of nodes or springs, and numbers in all. */
struct cloth_extent {
    size_t columns, rows, components, count;
};
struct cloth_extent cloth_extent(const cd_membrane* membrane, cd_field field);

/* A whole field, in the order of the header. */
void cloth_read(const cd_membrane* membrane, cd_field field, double* out_values);
void cloth_write(cd_membrane* membrane, cd_field field, const double* values);

/* Node (u, v) at (u, v, 0, 0) * spacing. */
void cloth_lay_out(cd_membrane* membrane, double spacing);

/* Adds noise of this size to all positions, and gives all nodes but pinned ones velocities of this size. */
void cloth_shake(cd_membrane* membrane, double size, uint64_t seed);

/* Scenes for a membrane that is new, with 5 x 5 nodes or more, any number of components. */
typedef void cloth_build(cd_membrane* membrane);

cloth_build cloth_drum;            /* all edges pinned, half edges */
cloth_build cloth_curtain;         /* hangs by its first row, damped */
cloth_build cloth_flag;            /* held at its first column, blown at: forces, and pressure in 3 components */
cloth_build cloth_plate;           /* bend, hinged all round */
cloth_build cloth_tube;            /* a ring along u with bend, pinned at one end */
cloth_build cloth_torus;           /* closed both ways, half edges set and without meaning */
cloth_build cloth_torn;            /* springs cut, nodes absent, masses vary */
cloth_build cloth_tied;            /* soft ties, one edge driven, one matched */
cloth_build cloth_everything;      /* every field and parameter at once, open */
cloth_build cloth_everything_tube; /* and closed along v */

struct cloth_scene {
    const char* name;
    cloth_build* build;
};
enum { CLOTHS = 10 };
extern const struct cloth_scene cloths[CLOTHS];

/* Scenes for a membrane of 3 components whose springs then have a length, and what surrounds it. */
cloth_build cloth_sail;         /* nothing but lengths and wind, held at two corners */
cloth_build cloth_lengths;      /* every field and parameter of cloth at once, open */
cloth_build cloth_lengths_tube; /* and closed along v */
enum { LENGTH_CLOTHS = 3 };
extern const struct cloth_scene length_cloths[LENGTH_CLOTHS];

/* Fails unless a membrane's cloth is as in a new one: there is none. */
void cloth_assert_defaults(const cd_membrane* membrane);

/* Four colliders: a plane, a sphere that moves, one that is none, and a capsule; and a thickness. */
void cloth_meet(cd_membrane* membrane);

#endif
