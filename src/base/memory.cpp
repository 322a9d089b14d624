#include "base/memory.hh"

#ifdef _WIN32
#include <malloc.h>
#endif
#include <stdlib.h>
#include <string.h>

namespace cd {

#ifdef _WIN32
static void* plain_allocate(void*, size_t size, size_t alignment) { return _aligned_malloc(size, alignment); }

static void plain_release(void*, void* pointer, size_t, size_t) { _aligned_free(pointer); }
#else
static void* plain_allocate(void*, size_t size, size_t alignment) {
    void* pointer = nullptr;
    return posix_memalign(&pointer, alignment, size) == 0 ? pointer : nullptr;
}

static void plain_release(void*, void* pointer, size_t, size_t) { free(pointer); }
#endif

cd_allocator default_allocator() {
    static constexpr cd_allocator plain = {nullptr, plain_allocate, plain_release};
    return plain;
}

void* allocate(Memory& memory, size_t size) {
    if (size == 0) return nullptr;
    void* pointer = memory.allocator.allocate(memory.allocator.user, size, kAlignment);
    if (!pointer) return nullptr;
    memset(pointer, 0, size);
    memory.bytes += size;
    return pointer;
}

void release(Memory& memory, void* pointer, size_t size) {
    if (!pointer) return;
    memory.bytes -= size;
    memory.allocator.release(memory.allocator.user, pointer, size, kAlignment);
}

} // namespace cd
