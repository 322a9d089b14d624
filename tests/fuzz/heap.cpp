#include "heap.hpp"

#include <stdlib.h>
#include <string.h>

#include <atomic>

#if FUZZ_HAS_ASAN // GCC has the function, but no header for it
extern "C" int __sanitizer_install_malloc_and_free_hooks(void (*on_malloc)(const volatile void*, size_t),
                                                         void (*on_free)(const volatile void*));
#endif

namespace fuzz {

Heap::~Heap() {
    for (Block& block : blocks) free(block.at);
}

void* Heap::allocate(void* user, size_t size, size_t alignment) {
    const malloc_watch::Pause pause;
    Heap& heap = *static_cast<Heap*>(user);
    if (heap.forbidden) heap.broke_the_ban = true;
    if (alignment == 0 || alignment > 64 || (alignment & (alignment - 1)) != 0) heap.called_wrongly = true;
    if (heap.fail_in > 0 && --heap.fail_in == 0) {
        heap.has_failed = true;
        return nullptr;
    }
    const size_t most = size_t(1) << 30;
    void* at = nullptr;
    if (size >= most || posix_memalign(&at, alignment < sizeof(void*) ? sizeof(void*) : alignment, size) != 0)
        return nullptr;
    memset(at, 0xa5, size);
    heap.bytes += size;
    heap.blocks.push_back({at, size, alignment});
    return at;
}

void Heap::release(void* user, void* pointer, size_t size, size_t alignment) {
    const malloc_watch::Pause pause;
    Heap& heap = *static_cast<Heap*>(user);
    if (heap.forbidden) heap.broke_the_ban = true;
    for (Block& block : heap.blocks) {
        if (block.at != pointer) continue;
        if (block.size != size || block.alignment != alignment) heap.called_wrongly = true;
        memset(pointer, 0xdd, block.size);
        free(pointer);
        heap.bytes -= block.size;
        block = heap.blocks.back();
        heap.blocks.pop_back();
        return;
    }
    heap.called_wrongly = true;
}

namespace malloc_watch {

static std::atomic<bool> is_on, has_seen;

#if FUZZ_HAS_ASAN
static void on_malloc(const volatile void*, size_t) {
    if (is_on) has_seen = true;
}
static void on_free(const volatile void*) {}
void install() { __sanitizer_install_malloc_and_free_hooks(on_malloc, on_free); }
#else
void install() {}
#endif

void begin() { has_seen = false, is_on = true; }
bool end() {
    is_on = false;
    return has_seen;
}

Pause::Pause() : was_on(is_on) { is_on = false; }
Pause::~Pause() { is_on = was_on; }
Resume::Resume(const Pause& pause) { is_on = pause.paused_a_watch(); }
Resume::~Resume() { is_on = false; }

} // namespace malloc_watch
} // namespace fuzz
