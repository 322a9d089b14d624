// What this run of the fuzzer is at, what it counts, and how it tells what it found.
#ifndef FUZZ_RUN_HPP
#define FUZZ_RUN_HPP

#include <stddef.h>
#include <stdint.h>

#include <atomic>
#include <string>

namespace fuzz {

// Counts of all sequences; they lie in memory that the parent shares with its children.
struct Totals {
    std::atomic<uint64_t> next_sequence, sequences, calls, refused, steps, diverged, short_of_tolerance, out_of_memory,
        bytes_refused, bytes_taken, problems, deaths;
};
extern Totals* totals;

struct Run {
    uint64_t seed = 1, sequence = 0;
    bool tracing = false; // every call is printed
    bool sane = false;    // in this sequence valid numbers are moderate, so that more can be expected of what they do
    double bad = 0;       // how often an argument is bad
    bool broken = false;  // a problem was found: the rest of the sequence means nothing
    int first_kind = 0;   // which kind of problem was the first one, 10 to 209
};
extern Run run;

// The text that printf would print.
std::string text(const char* format, ...) __attribute__((format(printf, 1, 2)));

// Remembers a call, for the report of a problem; prints it when tracing, and else sees to it that it ends some time.
void trace(const std::string& call);
void trace_detail(const std::string& detail); // what a call did; is only printed
void forget_trace();

// Reports a problem and ends the sequence. Problems of the same format are of one kind.
void problem(const char* format, ...) __attribute__((format(printf, 1, 2)));

} // namespace fuzz

#endif
