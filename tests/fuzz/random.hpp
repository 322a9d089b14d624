// Choices by chance: the same ones from the same seed.
#ifndef FUZZ_RANDOM_HPP
#define FUZZ_RANDOM_HPP

#include <stddef.h>
#include <stdint.h>

namespace fuzz {

// From here on choices depend on these three numbers alone, so that a call can be left out and all others stay as they
// were.
void seed_random(uint64_t seed, uint64_t sequence, uint64_t call);

uint64_t random_bits();
size_t below(size_t n); // 0 to n - 1; 0 if n is 0
bool chance(double probability);
double uniform(double from, double to);
double decades(double from, double to); // 10^from to 10^to, evenly in the exponent

// What a careless or hostile caller may give.
double wild_number();
size_t wild_size(size_t n); // near n, huge, or such that sums and products with n wrap
int32_t wild_enum(int32_t last);

} // namespace fuzz

#endif
