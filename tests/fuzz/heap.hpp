// The allocator that objects get, and a watch for calls of malloc from inside the library.
#ifndef FUZZ_HEAP_HPP
#define FUZZ_HEAP_HPP

#include <contdyn/base.h>

#include <vector>

#if defined(__SANITIZE_ADDRESS__)
#define FUZZ_HAS_ASAN 1
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
#define FUZZ_HAS_ASAN 1
#endif
#endif
#ifndef FUZZ_HAS_ASAN
#define FUZZ_HAS_ASAN 0
#endif

namespace fuzz {

// Counts what is held and fails when told to. Memory comes filled with garbage.
class Heap {
public:
    Heap() = default;
    Heap(const Heap&) = delete;
    Heap& operator=(const Heap&) = delete;
    ~Heap();

    cd_allocator table() { return {this, allocate, release}; }

    size_t bytes = 0;       // held now
    size_t fail_in = 0;     // the how manieth allocation from now on fails; 0: none
    bool forbidden = false; // the call that runs may neither allocate nor release

    bool has_failed = false;     // an allocation was made to fail
    bool broke_the_ban = false;  // was called while forbidden
    bool called_wrongly = false; // with an odd alignment, or to release what it never gave, or in another size

private:
    struct Block {
        void* at;
        size_t size, alignment;
    };
    std::vector<Block> blocks;

    static void* allocate(void* user, size_t size, size_t alignment);
    static void release(void* user, void* pointer, size_t size, size_t alignment);
};

// Only AddressSanitizer lets malloc be watched; without it the library is never seen to call it.
namespace malloc_watch {

void install();
void begin(); // from here on malloc may not be called
bool end();   // whether it was

// While one lives, code of the caller's runs, which may call malloc.
class Pause {
public:
    Pause();
    ~Pause();
    bool paused_a_watch() const { return was_on; }

private:
    bool was_on;
};

// Inside a Pause: the library runs again.
class Resume {
public:
    explicit Resume(const Pause& pause);
    ~Resume();
};

} // namespace malloc_watch
} // namespace fuzz

#endif
