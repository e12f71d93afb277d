// SPDX-License-Identifier: MIT
//
// Threads that share one range at a time. Each thread first takes grains from its own part of the
// range, so that the records it worked on in the last pass are still in its cache, then helps the
// others. Which thread runs which grain is a race; what a grain computes must not depend on it.
//
// Used by the one thread that steps a world. Workers spin briefly between ranges, then sleep until
// the next step. Where there are no threads (WebAssembly, unless built with them) a team is of one,
// however many are asked for.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <type_traits>
#include <vector>

#include "physics/src/foundation/threads.h"

namespace jostle::physics {

class ThreadPool {
public:
    explicit ThreadPool(int threads);
    ~ThreadPool();
    ThreadPool(const ThreadPool&) = delete;
    ThreadPool& operator=(const ThreadPool&) = delete;

    // How many threads share what comes next.
    int size() const { return single_threaded_ ? 1 : count_; }
    // From now on the calling thread does everything itself; the workers sleep on.
    void set_single_threaded(bool alone) { single_threaded_ = alone; }

    // What happens to the share of a thread that is there but not done when others are.
    enum class Split {
        free,   // they help it
        fixed,  // they leave it alone, for as long as it seems to get on. For passes that come
                // again and again over the same records: one that another thread took has to come
                // back from that thread's cache, which takes longer than a kernel does.
    };

    // Calls fn(begin, end) over [0, total) in grains, on all threads, and returns when all are
    // done. Short ranges stay on the calling thread: a hand-over costs more than they do.
    template <class F>
    void run(int total, int grain, F&& fn, Split split = Split::free) {
        if (total <= 0) return;
        if (size() == 1 || total < 4 * grain) {
            fn(0, total);
            return;
        }
        using Fn = std::remove_reference_t<F>;
        parallel_for(
            total, grain, split,
            [](void* context, int begin, int end) { (*static_cast<Fn*>(context))(begin, end); },
            const_cast<void*>(static_cast<const void*>(&fn)));
    }

    // Calls fn(k) for each of [0, count), one at a time on each thread: a thread begins with those
    // of its part of the range, in their order, as in the step before, and then helps the others.
    template <class F>
    void run_tasks(int count, F&& fn) {
        const auto each = [&fn](int begin, int end) {
            for (int k = begin; k < end; k++) fn(k);
        };
        if (size() == 1 || count < 2) return each(0, count);
        parallel_for(
            count, 1, Split::free,
            [](void* context, int begin, int end) {
                (*static_cast<decltype(&each)>(context))(begin, end);
            },
            const_cast<void*>(static_cast<const void*>(&each)));
    }

    // Tells the workers that there will be ranges soon: to wake takes as long as a small scene's
    // step.
    void wake();

    // Has a free worker do a job while this thread goes on, also through ranges; without workers it
    // is done at once. One at a time: finish() comes before the next.
    void start(std::function<void()> job);
    // Returns when the job is done, if there is one: does it itself if nobody has begun it.
    void finish();

private:
    using Call = void (*)(void* context, int begin, int end);
    struct alignas(64) Cursor {
        std::atomic<int> next{0};
        int end = 0;
        std::atomic<bool> owned{false};  // its thread is there
    };

    // In grains, each thread its own part of the range first.
    void parallel_for(int total, int grain, Split split, Call call, void* context);
    void run_grains(int self);
    void run_grains_of(Cursor& cursor, bool leave_to_owner);
    void work(int self);
    bool run_job();

    int count_;
    bool single_threaded_ = false;
    std::vector<Cursor> cursors_;
#if !defined(JOSTLE_NO_THREADS)
    std::vector<std::thread> workers_;
#endif
    // How many workers are in the present range, whether more may come in, and how many ranges
    // there have been. A worker comes in by adding one, if it has not changed meanwhile.
    static constexpr std::uint64_t inside = 0xffff, open = 0x10000, one_range = 0x20000;
    alignas(64) std::atomic<std::uint64_t> gate_{0};
    alignas(64) std::atomic<bool> quit_{false};
    Call call_ = nullptr;
    void* context_ = nullptr;
    int grain_ = 1;
    Split split_ = Split::free;
    enum class Job { idle, waiting, taken };
    alignas(64) std::atomic<Job> job_state_{Job::idle};
    std::function<void()> job_;
};

}  // namespace jostle::physics
