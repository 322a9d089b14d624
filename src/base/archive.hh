// An object as a row of numbers: one walk over them counts, hashes, writes or reads it (model/chain_keep.cpp).
#pragma once

#include <stddef.h>
#include <stdint.h>
#include <string.h>

namespace cd {

// FNV-1a's idea on 64-bit words: equal on every machine because it sees numbers, not memory.
struct Hasher {
    uint64_t state = 0xcbf29ce484222325;

    void word(uint64_t bits, int) {
        state = (state ^ bits) * 0x9e3779b97f4a7c15;
        state ^= state >> 29;
    }
};

struct Counter {
    size_t size = 0;

    void word(uint64_t, int bytes) { size += size_t(bytes); }
};

// Little-endian bytes.
struct Writer {
    unsigned char* to;

    void word(uint64_t bits, int bytes) {
        for (int k = 0; k < bytes; ++k) *to++ = (unsigned char)(bits >> (8 * k));
    }
};

struct Reader {
    const unsigned char *from, *end;
    bool whole = true; // false once something was missing

    void word(uint64_t& bits, int bytes) {
        bits = 0;
        if (end - from < bytes) {
            whole = false;
            return;
        }
        for (int k = 0; k < bytes; ++k) bits |= uint64_t(*from++) << (8 * k);
    }
};

// Passes one number through a walker of any kind; a Reader sets it.
// Every NaN is walked over as the same one: processors differ in the sign they give it.
template <class Walker, class Number> void walk(Walker& walker, Number& number) {
    uint64_t bits = 0;
    if (number != number) number = Number(__builtin_nan(""));
    memcpy(&bits, &number, sizeof number); // numbers fill the low bytes on little-endian machines
#if __BYTE_ORDER__ == __ORDER_BIG_ENDIAN__
    bits >>= 64 - 8 * sizeof number;
#endif
    walker.word(bits, int(sizeof number));
#if __BYTE_ORDER__ == __ORDER_BIG_ENDIAN__
    bits <<= 64 - 8 * sizeof number;
#endif
    memcpy(&number, &bits, sizeof number);
}

} // namespace cd
