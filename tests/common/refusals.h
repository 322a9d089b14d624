/* What the tests of this program have refused so far, held against the prototypes in the public header.
 *
 * Reading the header is what makes a new function, or a new argument, without a test fail. */
#ifndef REFUSALS_H
#define REFUSALS_H

#include <stdbool.h>
#include <stddef.h>

#include <contdyn/base.h>

enum { PARAMETERS = 12 };

struct parameter {
    char type[64]; /* "const cd_chain*", "size_t" */
    char name[32];
};

struct prototype {
    char name[48];
    struct parameter parameters[PARAMETERS];
    size_t count;
};

/* The functions that include/contdyn/<header> declares. Fails the test if the header cannot be read. */
size_t read_prototypes(const char* header, struct prototype* out_prototypes, size_t capacity);

/* Was a call of `function` refused with `status`, by a message whose first piece is `argument`? */
bool was_refused(const char* function, cd_status status, const char* argument);

/* Fails the test if a bad field, range or value is still to be tried for an argument of a function of fields in
 * include/contdyn/<object>.h. Other numbers: tests/bindings/check_ranges.py; pointers: check_pointers.py there. */
void all_field_arguments_were_tried(const char* object);

/* Remembers one; called by refuses(). */
void remember_refusal(const char* function, cd_status status, const char* text);

#endif
