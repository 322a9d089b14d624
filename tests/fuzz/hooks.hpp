// Ways to run an object's parallel work, for cd_*_set_parallel.
#ifndef FUZZ_HOOKS_HPP
#define FUZZ_HOOKS_HPP

#include <contdyn/base.h>

namespace fuzz {

enum class Order { none, backwards, shuffled, threads };

struct Hook {
    Order order = Order::none;
    cd_parallel table() { return {this, run_tasks}; }

private:
    static void run_tasks(void* user, size_t count, void (*task)(void*, size_t), void* context);
};

} // namespace fuzz

#endif
