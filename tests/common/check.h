/* Calls that must succeed, and calls that must be refused.
 *
 *   ok(cd_chain_set_mass(chain, 2.0));
 *   refuses(chain, cd_chain_set_mass(chain, NAN), CD_ERROR_VALUE, "mass|nan");
 *
 * A refused call returns the status, leaves the chain's hash as it was, leaves every byte of `out` alone (point the
 * call's outputs into it), and sets a message that names the function and holds every piece of the text between bars.
 * The first piece is the argument's name; after a ~ the message may do without it. What was refused is remembered: see
 * refusals.h. */
#ifndef CHECK_H
#define CHECK_H

#include "cmocka_all.h"

#include <contdyn/contdyn.h>

/* Where the outputs of refused calls point: one of each type, and room for arrays. */
struct outputs {
    double number[16];
    float single[16];
    size_t size[4];
    uint64_t u64;
    int32_t i32;
    const void* pointer;
    cd_chain* chain;
    unsigned char bytes[64];
};
extern struct outputs out;

void check_ok(cd_status status, const char* call, const char* file, int line);
void refusal_begin(const cd_chain* chain, const char* call);
void refusal_end(const cd_chain* chain, cd_status got, cd_status wanted, const char* call, const char* text,
                 const char* file, int line);

#define ok(call) check_ok((call), #call, __FILE__, __LINE__)

#define refuses(chain, call, status, text)                                                                             \
    do {                                                                                                               \
        refusal_begin((chain), #call);                                                                                 \
        const cd_status refused_ = (call);                                                                             \
        refusal_end((chain), refused_, (status), #call, (text), __FILE__, __LINE__);                                   \
    } while (0)

/* Text by printf's rules, good for the next 8 calls; name_and_size gives "name|18446744073709551615". */
const char* text_of(const char* format, ...) __attribute__((format(printf, 1, 2)));
const char* name_and_size(const char* name, size_t value);

/* The state's hash; fails the test if there is none. */
uint64_t hash_of(const cd_chain* chain);

/* The same numbers, bit for bit (0 and -0 differ, a NaN equals itself). */
#define assert_same_bits(a, b, count) assert_memory_equal((a), (b), (count) * sizeof *(a))

/* |a - b| <= tolerance * max(|a|, |b|, size), with both numbers in the failure's text. */
void check_near(double a, double b, double tolerance, double size, const char* what, const char* file, int line);
#define assert_near(a, b, tolerance, size) check_near((a), (b), (tolerance), (size), #a " and " #b, __FILE__, __LINE__)

#endif
