// A sequence of random calls on one to four objects.
#ifndef FUZZ_SEQUENCE_HPP
#define FUZZ_SEQUENCE_HPP

#include <stddef.h>
#include <stdint.h>

#include <vector>

namespace fuzz {

constexpr size_t kMostCalls = 200; // of a sequence

// Runs a sequence but for the calls that are marked in `left_out`. All that happens in it follows from its number and
// the run's seed.
void run_sequence(uint64_t sequence, const std::vector<bool>& left_out);

} // namespace fuzz

#endif
