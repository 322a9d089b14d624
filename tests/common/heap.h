/* An allocator for tests: counts what is live, fails when told to, and gives as little as the contract allows.
 *
 * Memory comes filled with garbage, at the alignment asked for and at no better one, with guard bytes behind it; a
 * release with another size or alignment, of an unknown pointer, or after a write past the end is a mistake. */
#ifndef HEAP_H
#define HEAP_H

#include <stdbool.h>
#include <stddef.h>

#include <contdyn/base.h>

enum { HEAP_BLOCKS = 256 };

struct heap {
    size_t live_bytes, live_blocks;
    size_t allocations; /* asked for, refused ones too */
    size_t fail_at;     /* refuse request number fail_at, counted from 1 after heap_fail; 0: none */
    bool for_good;      /* and all that follow */
    size_t asked;       /* since heap_fail */
    size_t refused;     /* since heap_fail */
    size_t mistakes;
    bool keeps; /* a released block stays readable until heap_free, so that a dead handle can be tried */
    struct block {
        unsigned char* base;
        unsigned char* pointer;
        size_t size, alignment;
        bool live;
    } blocks[HEAP_BLOCKS];
    size_t used;
};

/* The table that allocates from `heap`, which must be zeroed first and must outlive it. */
cd_allocator heap_allocator(struct heap* heap);

/* From now on request number `at` is refused, and with for_good every later one too. 0 stops that. */
void heap_fail(struct heap* heap, size_t at, bool for_good);

/* Nothing lives and no mistake was made; fails the test otherwise. Frees what was kept. */
void heap_free(struct heap* heap);

#endif
