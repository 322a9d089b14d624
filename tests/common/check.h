/* Calls that must succeed, and calls that must be refused.
 *
 *   ok(cd_chain_set_mass(chain, 2.0));
 *   refuses(chain, cd_chain_set_mass(chain, NAN), CD_ERROR_VALUE, "mass|nan");
 *
 * A refused call returns the status, leaves the object's hash as it was, leaves every byte of `out` alone (point the
 * call's outputs into it), and sets a message that names the function and holds every piece of the text between bars.
 * The first piece is the argument's name; after a ~ the message may do without it. What was refused is remembered: see
 * refusals.h. */
#ifndef CHECK_H
#define CHECK_H

#include "cmocka_all.h"

#include <contdyn/contdyn.h>
#include <stdio.h>

/* Where the outputs of refused calls point: one of each type, and room for arrays. */
struct outputs {
    double number[16];
    float single[16];
    size_t size[4];
    int32_t i32;
    const void* pointer;
    cd_chain* chain;
    cd_membrane* membrane;
    cd_water* water;
};
extern struct outputs out;

void check_ok(cd_status status, const char* call, const char* file, int line);
typedef uint64_t hash_function(const void* object);
void refusal_begin(const void* object, hash_function* hash, const char* call);
void refusal_end(const void* object, hash_function* hash, cd_status got, cd_status wanted, const char* call,
                 const char* text, const char* file, int line);

/* Whether sweeps are to be whole: CD_LONG=1 in the environment. Else they take a part of it, each time the same. */
int is_long(void);
/* Or as short as where every instruction is watched: CD_BRIEF=1. Only sweeps that are long there ask. */
int is_brief(void);
/* What all seeds of random scenes are changed by: CD_SEED in the environment, 0 without it. */
uint64_t other_scenes(void);
/* Of the things that a sweep counts from 0 on, those that are looked at: each, or without CD_LONG one of `part`. */
int is_taken(size_t number, size_t part);

#define ok(call) check_ok((call), #call, __FILE__, __LINE__)

#define refuses(object, call, status, text)                                                                     \
    do {                                                                                                        \
        refusal_begin((object), hash_function_of(object), #call);                                               \
        const cd_status refused_ = (call);                                                                      \
        refusal_end((object), hash_function_of(object), refused_, (status), #call, (text), __FILE__, __LINE__); \
    } while (0)

/* Numbers that are out of some range, and how a message shows them. */
struct bad_number {
    double value;
    const char* shown;
};
enum { NOT_FINITE = 3, NEGATIVE = 2, TOO_LARGE = 2, TOO_SMALL = 2 };
extern const struct bad_number not_finite[NOT_FINITE], negative[NEGATIVE], too_large[TOO_LARGE], too_small[TOO_SMALL];

/* A call with `bad` among its arguments, for each bad number in the table. */
#define refuses_each(object, call, argument, table)                                             \
    for (size_t i_ = 0; i_ < COUNT(table); ++i_) {                                              \
        const double bad = (table)[i_].value;                                                   \
        refuses((object), call, CD_ERROR_VALUE, text_of("%s|%s", argument, (table)[i_].shown)); \
    }

#ifdef __MINGW_PRINTF_FORMAT /* C's formats, which GCC on Windows does not take for granted */
#define FORMAT_OF_PRINTF __MINGW_PRINTF_FORMAT
#else
#define FORMAT_OF_PRINTF printf
#endif

/* Text by printf's rules, good for the next 8 calls; name_and_size gives "name|18446744073709551615". */
const char* text_of(const char* format, ...) __attribute__((format(FORMAT_OF_PRINTF, 1, 2)));
const char* name_and_size(const char* name, size_t value);

/* The hash of a chain's, a membrane's or a water's state; fails the test if there is none. Of NULL: 0. */
#define hash_of(object) (hash_function_of(object)(object))
#define hash_function_of(object) \
    _Generic((object), cd_chain*: hash_of_chain, const cd_chain*: hash_of_chain, cd_membrane*: hash_of_membrane,       \
             const cd_membrane*: hash_of_membrane, cd_water*: hash_of_water, const cd_water*: hash_of_water,           \
             void*: hash_of_nothing)
hash_function hash_of_chain, hash_of_membrane, hash_of_water, hash_of_nothing;

/* The same numbers, bit for bit (0 and -0 differ, a NaN equals itself). */
#define assert_same_bits(a, b, count) assert_memory_equal((a), (b), (count) * sizeof *(a))

/* |a - b| <= tolerance * max(|a|, |b|, size), with both numbers in the failure's text. */
void check_near(double a, double b, double tolerance, double size, const char* what, const char* file, int line);
#define assert_near(a, b, tolerance, size) check_near((a), (b), (tolerance), (size), #a " and " #b, __FILE__, __LINE__)

#endif
