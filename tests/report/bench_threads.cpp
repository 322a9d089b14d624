// A parallel-for of two threads, one of them the caller's.
#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <thread>

#include "bench.hpp"

namespace report {
namespace {

// Tells the processor that this thread waits for another.
inline void pause() {
#if defined(__x86_64__) || defined(__i386__)
    __builtin_ia32_pause();
#elif defined(__aarch64__)
    __asm__ volatile("yield");
#endif
}

// Indices that nobody has taken yet, from both ends: first in the low half, what is beyond the last in the high one.
class Range {
public:
    void fill(std::uint32_t first, std::uint32_t end) { both_ = std::uint64_t(end) << 32 | first; }
    bool empty() const { return is_empty(both_); }
    bool take_first(std::size_t& index) {
        return take([](std::uint64_t both) { return both + 1; }, [](std::uint64_t both) { return std::uint32_t(both); },
                    index);
    }
    bool take_last(std::size_t& index) {
        return take([](std::uint64_t both) { return both - (std::uint64_t(1) << 32); },
                    [](std::uint64_t both) { return (both >> 32) - 1; }, index);
    }

private:
    std::atomic<std::uint64_t> both_{0};

    static bool is_empty(std::uint64_t both) { return std::uint32_t(both) >= both >> 32; }
    template <class Less, class Taken> bool take(Less less, Taken taken, std::size_t& index) {
        std::uint64_t both = both_;
        do {
            if (is_empty(both)) return false;
        } while (!both_.compare_exchange_weak(both, less(both)));
        index = taken(both);
        return true;
    }
};

// Each thread has half of the indices, the same ones whenever the count is the same, so that what it works on is still
// in its cache; who is done helps the other. Neither waits for one that has nothing of its work: the caller does all of
// it while the helper still wakes up, and looks around a little before it sleeps or gives way.
class Pair {
public:
    ~Pair() {
        ends_ = true;
        wake();
        helper_.join();
    }

    void run(std::size_t count, void (*task)(void*, std::size_t), void* context) {
        task_ = task, context_ = context;
        done_.store(0, std::memory_order_relaxed);
        halves_[1].of.fill(std::uint32_t(count / 2), std::uint32_t(count));
        halves_[0].of.fill(0, std::uint32_t(count / 2));
        if (sleeps_) wake();
        work(0);
        for (int turn = 0; done_.load(std::memory_order_acquire) < count; ++turn)
            if (turn < kTurns) pause();
            else std::this_thread::yield();
    }

private:
    static constexpr int kTurns = 2000;       // some 20 us
    static constexpr std::size_t kLine = 128; // what processors may fetch together

    void (*task_)(void*, std::size_t) = nullptr; // read only by who has taken an index
    void* context_ = nullptr;
    struct alignas(kLine) Half {
        Range of;
    } halves_[2];
    alignas(kLine) std::atomic<std::size_t> done_{0};
    alignas(kLine) std::atomic<bool> sleeps_{false}, ends_{false};
    std::mutex mutex_;
    std::condition_variable wake_;
    std::thread helper_{[this] { help(); }}; // last: it uses the others

    void work(int own) {
        for (std::size_t i; halves_[own].of.take_first(i) || halves_[1 - own].of.take_last(i);) {
            task_(context_, i);
            done_.fetch_add(1, std::memory_order_release);
        }
    }
    void wake() {
        { std::lock_guard<std::mutex> lock(mutex_); } // who is about to sleep sees the change, or is asleep by now
        wake_.notify_one();
    }
    void help() {
        const auto wanted = [this] { return ends_ || !halves_[0].of.empty() || !halves_[1].of.empty(); };
        while (!ends_) {
            work(1);
            for (int turn = 0; turn < kTurns && !wanted(); ++turn) pause();
            if (wanted()) continue;
            std::unique_lock<std::mutex> lock(mutex_);
            sleeps_ = true;
            wake_.wait(lock, wanted);
            sleeps_ = false;
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

Subject meeting() {
    const auto meet = [](void* context, std::size_t) {
        auto& arrived = *static_cast<std::atomic<int>*>(context);
        ++arrived;
        while (arrived < 2) pause();
    };
    return {"meeting", [meet] {
                std::atomic<int> arrived{0};
                two_threads().run(two_threads().user, 2, meet, &arrived);
            }};
}

} // namespace report
