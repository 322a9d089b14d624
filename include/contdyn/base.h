/* contdyn: what every object shares: status codes, enumerations, the callback tables, version.
 *
 * Conventions, the same in every header:
 *   - A function that can fail returns cd_status: CD_OK (0) or an error. cd_error_message() then tells what was wrong
 *     and gives the offending value. A call that fails changes nothing, but for steps that end with
 *     CD_ERROR_DIVERGED, CD_ERROR_TOLERANCE or CD_ERROR_CALLBACK: those have been made.
 *   - Outputs come last and are named out_*. Unless a comment says otherwise, an output pointer may not be null; an
 *     array of no numbers may.
 *   - A handle is valid from create to destroy. After that it may not be used: its memory is the allocator's again.
 *   - An object holds nothing of its user's but what callback tables point to.
 *   - Nothing here prints, aborts or throws. cd_*_destroy(NULL) does nothing.
 *   - Distinct objects may be used from different threads at once; one object from one thread at a time.
 *   - Calls expect floating point to be as C programs begin with it: rounded to nearest, and no exception trapped, as
 *     steps make infinities and NaN on their way. Delphi and Free Pascal trap some: SetExceptionMask turns that off.
 *     Whether the processor takes denormal numbers for 0 changes no bit.
 *   - Quantities are in SI units, or in any other consistent set: the library never converts.
 *   - Numbers that are no field's, such as places to sample, are double, whatever the object's precision.
 *   - All is there since 0.2.0, unless its comment names another version. Before 1.0 none of it is promised.
 */
#ifndef CONTDYN_BASE_H
#define CONTDYN_BASE_H

#include <stddef.h>
#include <stdint.h>

#include "export.h"

#ifdef __cplusplus
extern "C" {
#endif

/* ---- status ------------------------------------------------------------------------------------------------- */

typedef int32_t cd_status;
enum {
    CD_OK = 0,
    CD_ERROR_NULL = 1,        /* a pointer that may not be null is null */
    CD_ERROR_HANDLE = 2,      /* the handle is of another kind of object */
    CD_ERROR_VALUE = 3,       /* a number outside its valid range, or NaN or infinity where it has no meaning */
    CD_ERROR_ENUM = 4,        /* not one of the enumeration's values */
    CD_ERROR_RANGE = 5,       /* an index, a range or a buffer length that does not fit the object */
    CD_ERROR_SIZE = 6,        /* a size that cannot be represented in memory */
    CD_ERROR_MEMORY = 7,      /* the allocator returned null */
    CD_ERROR_DISABLED = 8,    /* the field is not switched on: see cd_*_enable_field */
    CD_ERROR_UNSUPPORTED = 9, /* what this object cannot do, or what was left out of this build: see cd_build_info */
    CD_ERROR_DIVERGED = 10,   /* the state left the finite range during a step, or has not come back to it */
    CD_ERROR_FORMAT = 11,     /* the bytes to load are damaged, or of a later version or another kind */
    CD_ERROR_MISMATCH = 12,   /* the two objects, or the object and the bytes, differ in shape or precision */
    CD_ERROR_TOLERANCE = 13,  /* steps were made, but an iterative solve ended short of its tolerance */
    CD_ERROR_CALLBACK = 14    /* steps were made, but a callback gave numbers that it may not */
};

/* Name of a status, such as "CD_ERROR_VALUE"; "CD_ERROR_UNKNOWN" for a number that is none. A static string. */
CD_API const char* cd_status_name(cd_status status);

/* Why the last failed call on this thread failed: the function, the argument, its value, what would be valid.
 * Empty before the first failure; successful calls leave it as it is. The string belongs to the library and stays
 * valid until the next failure on the same thread. The library tells nothing else, and has no hook for messages. */
CD_API const char* cd_error_message(void);

/* ---- enumerations shared by the objects -------------------------------------------------------------------------- */

/* What an object stores its state in; chosen when it is made. Steps compute in double precision whatever it is, but for
 * those that an object's header names. */
typedef int32_t cd_precision;
enum { CD_FLOAT32 = 0, CD_FLOAT64 = 1 };

/* How a step advances the state by dt. CD_METHOD_IMPLICIT is the default, with lambda = 1/2. Bounds hold, and energy is
 * kept, to rounding: in a step a node's position may be wrong by some 1e-15 of the distance that its velocity covers in
 * dt, in a ring or with bend also by 1e-15 of the distance that it would fall in dt, which shows where dt is longer
 * than 1e12 times the time of the fastest swing. */
typedef int32_t cd_method;
enum {
    CD_METHOD_IMPLICIT = 0,         /* Kass 1997, eq. 21: lambda = 1/2 keeps energy and is second order, lambda = 1 is
                                       backward Euler; for lambda >= 1/2 bounded at every dt */
    CD_METHOD_FORWARD_EULER = 1,    /* Kass 1997, eq. 13; without damping it grows at every dt */
    CD_METHOD_SYMPLECTIC_EULER = 2, /* the new velocity moves the position, of water in its symmetric form
                                       (velocity Verlet); bounded up to cd_*_stable_dt */
    CD_METHOD_STIFF_SECOND = 3      /* two implicit stages with gamma = 1 - 1/sqrt(2) (SDIRK2): second order, and
                                       L-stable: motion too fast for dt dies out */
};

/* How the two-dimensional system of a membrane's implicit step is solved. */
typedef int32_t cd_solver;
enum {
    CD_SOLVER_ALTERNATING = 0, /* rows, then columns: Kass 1997, section 9 */
    CD_SOLVER_COUPLED = 1,     /* both at once, to a tolerance */
    CD_SOLVER_AUTO = 2         /* the first where that is right for the step, else the second */
};

/* How the total mass is dealt out to the nodes. */
typedef int32_t cd_mass_rule;
enum {
    CD_MASS_EQUAL = 0,    /* every node the same: the notes' rule, first order in space */
    CD_MASS_HALF_ENDS = 1 /* nodes on a border half as heavy as those inside: second order in space */
};

/* The instructions that steps are made of. All give the same bits as long as all numbers are finite; how far infinity
 * and NaN spread in steps that end with CD_ERROR_DIVERGED may differ. A new object has the fastest that its processor
 * runs. */
typedef int32_t cd_kernels;
enum {
    CD_KERNELS_PLAIN = 0, /* what every processor of the target has: SSE2 on x86-64, NEON on AArch64, and on WebAssembly
                             SIMD128 where that was built with -msimd128 */
    CD_KERNELS_AVX2 = 1,
    CD_KERNELS_AVX512 = 2 /* the parts F and DQ of AVX-512 */
};

/* What holds a node. The values are also those of the field CD_PIN. */
typedef int32_t cd_node;
enum {
    CD_NODE_FREE = 0,
    CD_NODE_PINNED = 1,  /* infinite mass, at rest */
    CD_NODE_DRIVEN = 2,  /* infinite mass, moves with the velocity written to it */
    CD_NODE_MATCHED = 3, /* border nodes only: free, with the impedance sqrt(stiffness mass) that sends no echo back */
    CD_NODE_POSED = 4    /* infinite mass; each call of cd_*_step moves it to where CD_TARGET is, evenly, and there it
                            stays until CD_TARGET is written again. Without that field as CD_NODE_DRIVEN: it stands
                            still where no velocity has been written */
};

/* What a collider of ropes and cloth is. */
typedef int32_t cd_shape;
enum { CD_SHAPE_NONE = 0, CD_SHAPE_PLANE = 1, CD_SHAPE_CAPSULE = 2, CD_SHAPE_BED = 3, CD_SHAPE_CALLBACK = 4 };

/* What becomes of places outside of an object that it is sampled at. */
typedef int32_t cd_outside;
enum {
    CD_OUTSIDE_REFUSED = 0, /* CD_ERROR_VALUE, and nothing is told of the other places either */
    CD_OUTSIDE_NEAREST = 1  /* they stand for the nearest place in the object; only NaN is refused */
};

/* Per-node and per-spring data; each object's header lists those that it has. They are in one list, since a field that
 * several objects have means the same in each. All hold numbers, pins and masks too, for one read and one write. */
typedef int32_t cd_field;
enum {
    CD_POSITION = 0,
    CD_VELOCITY = 1,
    CD_FORCE = 2,
    CD_MASS = 3,
    CD_STIFFNESS = 4,
    CD_BEND = 5,
    CD_PIN = 6,
    CD_TARGET = 7,
    CD_STIFFNESS_U = 8,
    CD_STIFFNESS_V = 9,
    CD_MASK = 10,
    CD_DEPTH = 11,
    CD_BED = 12,
    CD_SURFACE = 13,
    CD_VELOCITY_X = 14,
    CD_VELOCITY_Y = 15,
    CD_SOURCE = 16,
    CD_PRESSURE = 17,
    CD_FORCE_X = 18,
    CD_FORCE_Y = 19,
    CD_WALL_X = 20,
    CD_WALL_Y = 21,
    CD_REST_LENGTH = 22,
    CD_TENSION = 23,
    CD_WIND = 24,
    CD_STRENGTH = 25,
    CD_STRAIN = 26,
    CD_REST_LENGTH_U = 27,
    CD_REST_LENGTH_V = 28,
    CD_TENSION_U = 29,
    CD_TENSION_V = 30,
    CD_STRAIN_U = 31,
    CD_STRAIN_V = 32,
    CD_BREAKING_STRAIN_U = 33,
    CD_BREAKING_STRAIN_V = 34,
    CD_REST_ANGLE = 35
};

/* ---- callbacks ------------------------------------------------------------------------------------------------- */

/* These tables keep their members: what a later version asks of the caller will be in another table. No function tells
 * which table an object has. */

/* Memory from the caller. allocate returns `size` bytes aligned to `alignment` (a power of two, at most 64), or null;
 * release gets back what allocate gave, with the same size and alignment. Both are called only from inside a call on
 * the object, on the caller's thread, never from a step, a read or a write. Copied at create. */
typedef struct cd_allocator {
    void* user;
    void* (*allocate)(void* user, size_t size, size_t alignment);
    void (*release)(void* user, void* pointer, size_t size, size_t alignment);
} cd_allocator;

/* Parallel work from the caller. run calls task(context, i) once for every i in [0, count), in any order, on any
 * threads, and returns when all are done. Results do not depend on it, bit for bit, as long as they are finite. Copied
 * when it is set. */
typedef struct cd_parallel {
    void* user;
    void (*run)(void* user, size_t count, void (*task)(void* context, size_t index), void* context);
} cd_parallel;

/* A shape from the caller, of a collider of ropes and cloth. distance is given `count` positions, each of `components`
 * numbers and relative to the collider's origin, and the time [s]. To out_distances[i] it writes how far outside of the
 * shape each is [m], less than 0 inside, at most 1e60 in size; to out_normals[i][component] the unit vector along which
 * that distance grows fastest, of a length within 1e-3 of 1. It is called from steps, from any thread of cd_parallel and
 * from several at once. The same position must get the same answer at the same time, whatever others are asked with it,
 * and it may call no function on the object. A shape that moves as a whole should do so by the collider's velocity: one
 * that changes with time by itself is met where it was when the step began. Copied when it is set. */
typedef struct cd_distance {
    void* user;
    void (*distance)(void* user, double time, size_t count, size_t components, const double* positions,
                     double* out_distances, double* out_normals);
} cd_distance;

/* ---- saved states ------------------------------------------------------------------------------------------------ */

/* What 0.2.0 or a later version has saved, every later one loads. */

/* The kinds of objects. */
typedef int32_t cd_kind;
enum { CD_KIND_CHAIN = 1, CD_KIND_MEMBRANE = 2, CD_KIND_WATER = 3 };

/* What cd_*_save made these bytes of: the kind of object, and what its create function has to be given so that it loads
 * them: of a chain strands and springs, of a membrane nu and nv, of water nx and ny; components, of water 1; and the
 * precision. Water's dx and dy, allocators and callbacks may be others. Each output may be null, and is left alone on
 * failure. Errors: CD_ERROR_FORMAT for bytes that are damaged, cut short or of a later version. */
CD_API cd_status cd_saved_shape(const void* bytes, size_t size, cd_kind* out_kind, size_t* out_first,
                                size_t* out_second, size_t* out_components, cd_precision* out_precision);

/* ---- kernels ------------------------------------------------------------------------------------------------- */

/* The kernels that this build has and this processor runs: the sum of 1 << k for each of them, k a cd_kernels. The
 * largest k is the fastest. CD_KERNELS_PLAIN is always there. */
CD_API uint32_t cd_runnable_kernels(void);

/* The instructions' name, such as "AVX-512"; of CD_KERNELS_PLAIN those that it was built with: "SSE2", "NEON",
 * "SIMD128", or "plain" for one number at a time. "unknown" for a number that is no cd_kernels. A static string. */
CD_API const char* cd_kernels_name(cd_kernels kernels);

/* ---- version ------------------------------------------------------------------------------------------------- */

#define CD_VERSION_MAJOR 0
#define CD_VERSION_MINOR 2
#define CD_VERSION_PATCH 0

/* Version of the library that runs: major * 1000000 + minor * 1000 + patch. The macros tell that of the header. */
CD_API uint32_t cd_version(void);

/* The same as text, "0.2.0". A static string. */
CD_API const char* cd_version_string(void);

/* Compiler, target, and which objects, features, precisions and kernels this build has, in one line: options of the
 * build leave parts out, and what asks for one that is not there says CD_ERROR_UNSUPPORTED. A static string. */
CD_API const char* cd_build_info(void);

#ifdef __cplusplus
}
#endif

#endif
