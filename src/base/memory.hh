// Memory of an object: everything it holds comes through here, zero-filled, counted, with checked sizes.
#pragma once

#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include "contdyn/base.h"

namespace cd {

constexpr size_t kAlignment = 64; // a cache line, and the widest vector

// a * b and a + b, or false if the result does not fit. out is written only on success.
inline bool multiply(size_t a, size_t b, size_t& out) {
    size_t product;
    return !__builtin_mul_overflow(a, b, &product) && product <= PTRDIFF_MAX && ((out = product), true);
}
inline bool add(size_t a, size_t b, size_t& out) {
    size_t sum;
    return !__builtin_add_overflow(a, b, &sum) && sum <= PTRDIFF_MAX && ((out = sum), true);
}

struct Memory {
    cd_allocator allocator;
    size_t bytes; // held now
};

// malloc and free behind the allocator's shape: what an object made without an allocator uses.
cd_allocator default_allocator();

// Zero-filled bytes, or null. size 0 gives null.
void* allocate(Memory& memory, size_t size);
void release(Memory& memory, void* pointer, size_t size);

// A run of numbers of one object. Empty: data is null.
template <class T> struct Array {
    T* data = nullptr;
    size_t count = 0;

    explicit operator bool() const { return data != nullptr; }
    T& operator[](size_t i) const { return data[i]; }
    size_t bytes() const { return count * sizeof(T); }
};

template <class T> bool allocate(Memory& memory, size_t count, Array<T>& out) {
    size_t bytes;
    if (!multiply(count, sizeof(T), bytes)) return false;
    void* data = allocate(memory, bytes);
    if (!data && bytes > 0) return false;
    out = {static_cast<T*>(data), count};
    return true;
}

template <class T> void release(Memory& memory, Array<T>& array) {
    release(memory, array.data, array.bytes());
    array = {};
}

// An array of whatever numbers, of `size` bytes each, for what is done alike with all: one text for all of them.
struct AnyArray {
    void* array;
    size_t size;

    template <class T> AnyArray(Array<T>& of) : array(&of), size(sizeof(T)) {}

    // The same numbers, counted as before; all arrays look alike in memory.
    Array<char> held() const {
        Array<char> as_bytes;
        memcpy(&as_bytes, array, sizeof as_bytes);
        return as_bytes;
    }
    void hold(const Array<char>& as_bytes) const { memcpy(array, &as_bytes, sizeof as_bytes); }
};

} // namespace cd
