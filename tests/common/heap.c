#include "heap.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "cmocka_all.h"

enum { GUARD = 32, GUARD_BYTE = 0xEE, GARBAGE = 0xCD, DEAD = 0xDD };

static struct block* unused_block(struct heap* heap) {
    for (size_t i = 0; i < heap->used; ++i)
        if (!heap->blocks[i].base) return &heap->blocks[i];
    return heap->used < HEAP_BLOCKS ? &heap->blocks[heap->used++] : NULL;
}

static void* heap_allocate(void* user, size_t size, size_t alignment) {
    struct heap* heap = user;
    ++heap->allocations;
    ++heap->asked;
    if (size == 0 || alignment == 0 || alignment > 64 || (alignment & (alignment - 1)) != 0) ++heap->mistakes;
    if (heap->fail_at && (heap->asked == heap->fail_at || (heap->for_good && heap->asked > heap->fail_at))) {
        ++heap->refused;
        return NULL;
    }
    if (size > ((size_t)1 << 32)) return NULL;
    struct block* block = unused_block(heap);
    unsigned char* base = block ? malloc(size + 3 * alignment + GUARD) : NULL;
    if (!base) return NULL;
    unsigned char* pointer = base + (2 * alignment - (uintptr_t)base % (2 * alignment)) + alignment;
    memset(pointer, GARBAGE, size);
    memset(pointer + size, GUARD_BYTE, GUARD);
    *block = (struct block){base, pointer, size, alignment, true};
    heap->live_bytes += size;
    ++heap->live_blocks;
    return pointer;
}

static void heap_release(void* user, void* pointer, size_t size, size_t alignment) {
    struct heap* heap = user;
    for (size_t i = 0; i < heap->used; ++i) {
        struct block* block = &heap->blocks[i];
        if (!block->live || block->pointer != pointer) continue;
        if (block->size != size || block->alignment != alignment) ++heap->mistakes;
        for (size_t j = 0; j < GUARD; ++j)
            if (block->pointer[block->size + j] != GUARD_BYTE) ++heap->mistakes;
        heap->live_bytes -= block->size;
        --heap->live_blocks;
        block->live = false;
        if (heap->keeps) return;
        memset(block->pointer, DEAD, block->size);
        free(block->base);
        block->base = NULL;
        return;
    }
    ++heap->mistakes;
}

cd_allocator heap_allocator(struct heap* heap) { return (cd_allocator){heap, heap_allocate, heap_release}; }

void heap_fail(struct heap* heap, size_t at, bool for_good) {
    heap->fail_at = at;
    heap->for_good = for_good;
    heap->asked = heap->refused = 0;
}

void heap_free(struct heap* heap) {
    assert_int_equal(heap->mistakes, 0);
    assert_int_equal(heap->live_blocks, 0);
    assert_int_equal(heap->live_bytes, 0);
    for (size_t i = 0; i < heap->used; ++i)
        if (heap->blocks[i].base) free(heap->blocks[i].base);
    memset(heap->blocks, 0, sizeof heap->blocks);
    heap->used = 0;
}
