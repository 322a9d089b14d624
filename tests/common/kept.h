/* Objects of every kind in the middle of a scene, all that can be read of them, and their bytes. */
#ifndef KEPT_H
#define KEPT_H

#include "kind.h"

struct blob {
    unsigned char* bytes; /* to be freed */
    size_t size;
};
size_t kind_saved_size(const struct kind* kind, const any* object);
struct blob kind_save(const struct kind* kind, const any* object);

/* Gives an object the state of another one, by its bytes or by copying. */
void kind_take(const struct kind* kind, any* object, const any* source, int by_copy);

/* Fails unless all getters, fields and hashes tell the same. */
void kind_assert_same(const struct kind* kind, const any* a, const any* b);

struct kept_kind {
    const struct kind* kind;
    size_t shape[3];   /* two numbers and the components */
    size_t scenes;     /* how many */
    size_t fullest[2]; /* scenes with every field and parameter; the second has what the first can't have */
    size_t others[2];  /* scenes unlike them */
    any* (*build)(any* object, size_t scene);
};
extern const struct kept_kind kept_kinds[KINDS];

/* A new object, of this shape or that of the scenes. */
any* kept_new(const struct kept_kind* kept, const size_t* shape, cd_precision precision);

/* How many methods steps may have; of waters, and where springs have a length, the scene says which. */
size_t kept_methods(const struct kept_kind* kept, size_t scene);
double kept_dt(const struct kept_kind* kept, size_t scene);

/* An object after 7 steps of a scene. */
any* kept_scene(const struct kept_kind* kept, size_t scene, cd_precision precision, cd_method method);

/* Fails unless a new object, and one with other things in it, become the same as this one by loading and by copying. */
void kept_assert_all(const struct kept_kind* kept, const any* object, cd_precision precision);

#endif
