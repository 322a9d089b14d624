/* The three kinds of objects as one, with what chains, membranes and waters all can do: for tests that are the same. */
#ifndef KIND_H
#define KIND_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include <contdyn/contdyn.h>

#include "check.h"

typedef void any; /* a cd_chain, cd_membrane or cd_water */

struct kind {
    const char* name; /* "chain" */
    cd_kind number;
    cd_field state; /* positions, or depths: what tests write where they mean the state */
    /* `*out` must be set before, and is left alone on failure. */
    cd_status (*create)(size_t first, size_t second, size_t components, cd_precision precision,
                        const cd_allocator* allocator, any** out);
    void (*destroy)(any* object);
    cd_status (*step)(any* object, double dt, size_t count);
    cd_status (*reset)(any* object);
    cd_status (*get_time)(const any* object, double* out_time);
    cd_status (*get_steps)(const any* object, uint64_t* out_steps);
    cd_status (*get_memory)(const any* object, size_t* out_bytes);
    cd_status (*hash)(const any* object, uint64_t* out_hash);
    cd_status (*save_size)(const any* object, size_t* out_size);
    cd_status (*save)(const any* object, void* buffer, size_t size, size_t* out_written);
    cd_status (*load)(any* object, const void* bytes, size_t size);
    cd_status (*copy_state)(any* object, const any* source);
    cd_status (*enable_field)(any* object, cd_field field);
    cd_status (*disable_field)(any* object, cd_field field);
    cd_status (*set_method)(any* object, cd_method method);
    cd_status (*set_kernels)(any* object, cd_kernels kernels);
    cd_status (*set_parallel)(any* object, const cd_parallel* parallel);
    /* Of the whole field, with as many numbers as kind_numbers tells. */
    cd_status (*read)(const any* object, cd_field field, double* out_values, size_t count);
    cd_status (*write)(any* object, cd_field field, const double* values, size_t count);
};

enum { KINDS = 3 };
extern const struct kind kinds[KINDS];
enum { CHAIN, MEMBRANE, WATER }; /* places in `kinds` */

/* How many numbers a field of the object has; 0 if it is off, or the object has none of that name. */
size_t kind_numbers(const struct kind* kind, const any* object, cd_field field);

uint64_t kind_hash(const struct kind* kind, const any* object);
size_t kind_memory(const struct kind* kind, const any* object);

/* Whether all positions or depths and velocities are finite. */
bool kind_is_finite(const struct kind* kind, const any* object);

/* As `refuses` of check.h: kind_refuses(kind, object, load, (object, bytes, size), CD_ERROR_FORMAT, ""). */
#define kind_refuses(kind, object, call, arguments, status, text)                                               \
    do {                                                                                                        \
        const char* const name_ = text_of("cd_%s_%s", (kind)->name, #call);                                     \
        refusal_begin((object), kind_hash_function(kind), name_);                                               \
        const cd_status refused_ = (kind)->call arguments;                                                      \
        refusal_end((object), kind_hash_function(kind), refused_, (status), name_, (text), __FILE__, __LINE__); \
    } while (0)
hash_function* kind_hash_function(const struct kind* kind);

#endif
