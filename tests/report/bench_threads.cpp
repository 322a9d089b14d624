// A parallel-for of two threads, one of them the caller's.
#include <atomic>
#include <condition_variable>
#include <mutex>
#include <thread>

#include "bench.hpp"

namespace report {
namespace {

class Pair {
public:
    ~Pair() {
        {
            std::lock_guard<std::mutex> lock(mutex_);
            ends_ = true;
        }
        wake_.notify_one();
        helper_.join();
    }

    void run(std::size_t count, void (*task)(void*, std::size_t), void* context) {
        task_ = task, context_ = context, count_ = count;
        next_ = 0;
        done_.store(false, std::memory_order_relaxed);
        {
            std::lock_guard<std::mutex> lock(mutex_);
            ++round_;
        }
        wake_.notify_one();
        take();
        while (!done_.load(std::memory_order_acquire)) std::this_thread::yield();
    }

private:
    void (*task_)(void*, std::size_t) = nullptr;
    void* context_ = nullptr;
    std::size_t count_ = 0;
    std::atomic<std::size_t> next_{0};
    std::atomic<bool> done_{true};
    std::mutex mutex_;
    std::condition_variable wake_;
    std::size_t round_ = 0;
    bool ends_ = false;
    std::thread helper_{[this] { help(); }}; // last: it uses the others

    void take() {
        for (std::size_t i; (i = next_.fetch_add(1, std::memory_order_relaxed)) < count_;) task_(context_, i);
    }
    void help() {
        for (std::size_t seen = 0;;) {
            {
                std::unique_lock<std::mutex> lock(mutex_);
                wake_.wait(lock, [&] { return ends_ || round_ != seen; });
                if (ends_) return;
                seen = round_;
            }
            take();
            done_.store(true, std::memory_order_release);
        }
    }
};

} // namespace

const cd_parallel& two_threads() {
    static Pair pair;
    static const cd_parallel kParallel = {
        &pair, [](void* user, std::size_t count, void (*task)(void*, std::size_t), void* context) {
            static_cast<Pair*>(user)->run(count, task, context);
        }};
    return kParallel;
}

} // namespace report
