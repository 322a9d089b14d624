#include "hooks.hpp"

#include <stdint.h>

#include <atomic>
#include <numeric>
#include <thread>
#include <utility>
#include <vector>

#include "heap.hpp"

namespace fuzz {

// The same order every time, and not from the generator that picks calls: how often it is asked may depend on kernels.
static std::vector<size_t> shuffled(size_t count) {
    std::vector<size_t> order(count);
    std::iota(order.begin(), order.end(), size_t(0));
    uint64_t state = count * 0x9e3779b97f4a7c15;
    for (size_t i = count; i > 1; --i) {
        state = state * 6364136223846793005u + 1442695040888963407u;
        std::swap(order[i - 1], order[(state >> 33) % i]);
    }
    return order;
}

void Hook::run_tasks(void* user, size_t count, void (*task)(void*, size_t), void* context) {
    const malloc_watch::Pause pause;
    const auto run_one = [&](size_t i) {
        const malloc_watch::Resume resume(pause);
        task(context, i);
    };
    switch (static_cast<Hook*>(user)->order) {
    case Order::none:
        for (size_t i = 0; i < count; ++i) run_one(i);
        break;
    case Order::backwards:
        for (size_t i = count; i-- > 0;) run_one(i);
        break;
    case Order::shuffled:
        for (size_t i : shuffled(count)) run_one(i);
        break;
    case Order::threads: {
        std::atomic<size_t> next{0};
        const auto work = [&] {
            for (size_t i; (i = next++) < count;) task(context, i);
        };
        std::thread first(work), second(work);
        work();
        first.join();
        second.join();
    }
    }
}

} // namespace fuzz
