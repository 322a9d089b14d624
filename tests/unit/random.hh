// Numbers by chance, the same ones from the same seed.
#pragma once

#include <stddef.h>

#include <initializer_list>

// In [0, 1).
inline double random_number(unsigned& seed) {
    seed = seed * 1664525u + 1013904223u;
    return double(seed >> 8) / double(1u << 24);
}
inline double any_of(std::initializer_list<double> numbers, unsigned& seed) {
    return numbers.begin()[size_t(random_number(seed) * double(numbers.size()))];
}
