/* Small chains that many tests share, and whole fields in one call. Everything here must succeed: if it does not, the
 * test fails. */
#ifndef SCENE_H
#define SCENE_H

#include <contdyn/chain.h>

#include <stddef.h>
#include <stdint.h>

/* A chain as cd_chain_create makes it, from malloc. */
cd_chain* scene_chain(size_t strands, size_t springs, size_t components, cd_precision precision);

/* The same from an allocator, which may be null. */
cd_chain* scene_chain_from(const cd_allocator* allocator, size_t strands, size_t springs, size_t components,
                           cd_precision precision);

size_t scene_strands(const cd_chain* chain);
size_t scene_nodes(const cd_chain* chain);
size_t scene_springs(const cd_chain* chain); /* a ring's last one too */
size_t scene_components(const cd_chain* chain);

/* How many strands have pins, masses and the like of their own: all of a rope. */
size_t scene_own_strands(const cd_chain* chain);

/* How many strands, items (nodes or springs) and numbers a whole field has. */
size_t scene_field_strands(const cd_chain* chain, cd_field field);
size_t scene_field_items(const cd_chain* chain, cd_field field);
size_t scene_field_count(const cd_chain* chain, cd_field field);

/* A whole field; the buffer holds scene_field_count numbers. */
void scene_read(const cd_chain* chain, cd_field field, double* out_values);
void scene_write(cd_chain* chain, cd_field field, const double* values);

/* One value of a field that has one per node or spring: mass, stiffness, bend, pin, rest length, tension; of the first
 * strand, and of all. */
double scene_get(const cd_chain* chain, cd_field field, size_t item);
void scene_set(cd_chain* chain, cd_field field, size_t item, double value);

/* Numbers in [-1, 1) that look random and are the same everywhere. */
double scene_noise(uint64_t* seed);

/* Node i of every strand at (i * spacing, strand, 0, 0). */
void scene_lay_out(cd_chain* chain, double spacing);

/* Adds noise of this size to all positions, and gives all nodes but the held ones velocities of this size. */
void scene_shake(cd_chain* chain, double size, uint64_t seed);

/* Scenes for a chain that is new, with 8 nodes or more; any number of strands and components. */
typedef void scene_build(cd_chain* chain);

scene_build scene_rope;            /* hangs by its first end */
scene_build scene_net;             /* both ends pinned, half-end masses, a force on every node */
scene_build scene_hair;            /* bend, first two nodes pinned, damped */
scene_build scene_ring;            /* a free ring */
scene_build scene_bent_ring;       /* the same with bend */
scene_build scene_welded;          /* a run of welds, a single weld, a cut */
scene_build scene_attached;        /* soft ties to targets */
scene_build scene_driven;          /* one end driven, the other matched */
scene_build scene_everything;      /* every field and parameter at once, open */
scene_build scene_everything_ring; /* and closed */

struct scene {
    const char* name;
    scene_build* build;
};
enum { SCENES = 10 };
extern const struct scene scenes[SCENES];

/* Springs that have a length: up to 3 components, and CD_METHOD_IMPLICIT. */
scene_build scene_lengths; /* every field and parameter that ropes may have */
scene_build scene_links;   /* of fixed length, hangs by its first end */
scene_build scene_curls;   /* resists bending, about rest angles where there are 2 components */
enum { ROPE_SCENES = 3 };
extern const struct scene rope_scenes[ROPE_SCENES];

#endif
