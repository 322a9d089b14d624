// What a node and step costs, measured side by side: the library, the textbook, and a copy of the state.
#ifndef REPORT_BENCH_HPP
#define REPORT_BENCH_HPP

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "runner.hpp"

namespace report {

// Something that makes steps of all nodes of a case.
struct Subject {
    std::string name;
    std::function<void()> step;
    std::function<std::uint64_t()> hash = nullptr;
    std::function<std::size_t()> factorizations = nullptr; // so far
};

struct Case {
    std::string name;
    std::size_t nodes = 0;
    std::vector<Subject> subjects;
    std::string reach = ""; // the aim
    std::size_t calls = 1;  // of the library a step
};

// Cases are made when their turn comes, and gone when it is over.
struct Bench {
    std::string name;
    std::function<Case()> make;
};

std::vector<Bench> chain_benches();
std::vector<Bench> sheet_benches();
std::vector<Bench> water_benches();
std::vector<Bench> frame_benches();

inline std::vector<double> random_numbers(std::size_t count, double size) {
    std::mt19937 random(1);
    std::vector<double> numbers(count);
    for (double& x : numbers) x = size * (double(random()) / 2147483648.0 - 1);
    return numbers;
}

// The floor: reads and writes `count` numbers once, in place.
template <class Real> Subject traffic(std::size_t count) {
    const auto state = std::make_shared<std::vector<Real>>(count, Real(1));
    return {"copy", [state] {
                Real* const numbers = state->data();
                const std::size_t n = state->size();
                for (std::size_t i = 0; i < n; ++i) numbers[i] = -numbers[i];
            }};
}
// Beside explicit steps of both precisions: what these cost beyond the caches is what their copies do.
inline Subject wide_traffic(std::size_t count) {
    Subject copy = traffic<double>(count);
    copy.name = "copy of float64";
    return copy;
}

// Of many textbook objects, each with an x.
template <class Object> std::uint64_t hash_of_all(const std::vector<Object>& objects) {
    std::uint64_t hash = kHashStart;
    for (const Object& object : objects) hash = hash_of(object.x, hash);
    return hash;
}

// A subject for each of the kernels that the processor runs, the plain ones first: subject(kernels) makes it.
template <class Make> std::vector<Subject> of_each_kernels(Make subject) {
    std::vector<Subject> all;
    for (cd_kernels kernels = CD_KERNELS_PLAIN; cd_runnable_kernels() >> kernels; ++kernels)
        if (cd_runnable_kernels() >> kernels & 1) all.push_back(subject(kernels));
    return all;
}

// Two threads, one of them the caller's: see bench_threads.cpp.
const cd_parallel& two_threads();
// They meet: ns_per_call tells how far apart in the machine they are.
Subject meeting();

} // namespace report

#endif
