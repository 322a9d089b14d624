// An object as a row of numbers: one walk over them counts, hashes, writes or reads it (model/keep.hh).
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

// How far the bits of a number of this type stand from the low end of a word that they were copied into.
template <class Number> constexpr int high_end() {
#if __BYTE_ORDER__ == __ORDER_BIG_ENDIAN__
    return int(64 - 8 * sizeof(Number));
#else
    return 0;
#endif
}

// A number's bits, at the low end of a word. Every NaN is shown as the same one: processors differ in the sign they give
// it.
template <class Number> uint64_t bits_of(const Number& number) {
    const Number shown = number == number ? number : Number(__builtin_nan(""));
    uint64_t bits = 0;
    memcpy(&bits, &shown, sizeof shown);
    return bits >> high_end<Number>();
}
template <class Number> void set_bits(Number& number, uint64_t bits) {
    bits <<= high_end<Number>();
    memcpy(&number, &bits, sizeof number);
}

// Shows a walker one number.
template <class Walker, class Number> void walk(Walker& walker, const Number& number) {
    walker.word(bits_of(number), int(sizeof number));
}

// Reads one number.
template <class Number> void walk(Reader& reader, Number& number) {
    uint64_t bits;
    reader.word(bits, int(sizeof number));
    set_bits(number, bits);
}

// Any of them, for what is walked once: one text then counts, hashes, writes and reads it.
struct AnyWalker {
    void* walker;
    void (*word)(void* walker, uint64_t& bits, int bytes);

    template <class Walker> explicit AnyWalker(Walker& of)
        : walker(&of), word([](void* w, uint64_t& bits, int bytes) { static_cast<Walker*>(w)->word(bits, bytes); }) {}
};
template <class Number> void walk(AnyWalker& any, Number& number) {
    uint64_t bits = bits_of(number);
    any.word(any.walker, bits, int(sizeof number));
    set_bits(number, bits);
}

} // namespace cd
