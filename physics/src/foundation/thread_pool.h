// SPDX-License-Identifier: MIT
//
// Thread pool that processes one range at a time. Each thread first takes grains from its own part
// of the range, so that the records of the previous pass are still in its cache, then helps the
// other threads. The assignment of grains to threads is nondeterministic, so the result of a grain
// must not depend on it.
//
// Used by the one thread that steps a world. Workers spin briefly between ranges, then sleep until
// the next step. Without thread support (WebAssembly, unless built with threads) the pool has one
// thread, regardless of the requested number.
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

    // Number of threads that take part in the next range.
    int size() const { return single_threaded_ ? 1 : count_; }
    // If true, the calling thread does all work and the workers stay asleep.
    void set_single_threaded(bool alone) { single_threaded_ = alone; }

    // Handling of the part of a thread that has started but not finished when the other threads are
    // done.
    enum class Split {
        free,  // the other threads help
        // The other threads leave it alone while the owner makes progress. For passes that are
        // repeated over the same records: a record processed by another thread must be transferred
        // back from that thread's cache, which takes longer than a kernel.
        fixed,
    };

    // Calls fn(begin, end) over [0, total) in grains on all threads, and returns when all are done.
    // Short ranges stay on the calling thread, because handing them over costs more than processing
    // them.
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

    // Calls fn(k) for each k in [0, count). Each thread starts with the elements of its own part of
    // the range in order, which is the same assignment as in the previous step, then helps the
    // others.
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

    // Wakes the workers before the first range, because waking takes as long as the step of a small
    // scene.
    void wake();

    // Starts a job on a free worker while this thread continues, also through ranges. Without
    // workers, runs it immediately. One job at a time: call finish() before the next start().
    void start(std::function<void()> job);
    // Waits for the job, if there is one. Runs it on this thread if no worker has started it.
    void finish();

private:
    using Call = void (*)(void* context, int begin, int end);
    struct alignas(64) Cursor {
        std::atomic<int> next{0};
        int end = 0;
        std::atomic<bool> owned{false};  // the owning thread has started
    };

    // Processes a range in grains; each thread starts with its own part.
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
    // State of the current range: number of workers inside, whether more may enter, and a count of
    // ranges. A worker enters by incrementing the value if it has not changed in the meantime.
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
