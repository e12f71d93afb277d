// SPDX-License-Identifier: MIT
#include "physics/src/foundation/thread_pool.h"

#include <utility>

#include "physics/src/foundation/fp_mode.h"

namespace jostle::physics {
namespace {

// Ranges of one step are microseconds apart, steps are milliseconds apart. Spin only between
// ranges.
constexpr int spins_before_sleep = 4000;
// Equal parts end within microseconds of each other. A thread that takes longer than this has lost
// its processor.
constexpr int spins_before_help = 1000;

void relax_cpu() {
#if defined(__SSE2__)
    _mm_pause();
#elif defined(__aarch64__)
    asm volatile("yield");
#endif
}

}  // namespace

#if defined(JOSTLE_NO_THREADS)
ThreadPool::ThreadPool(int) : count_(1), cursors_(1) {}
ThreadPool::~ThreadPool() = default;
#else
ThreadPool::ThreadPool(int threads) : count_(threads), cursors_(static_cast<std::size_t>(threads)) {
    for (int self = 1; self < threads; self++) workers_.emplace_back([this, self] { work(self); });
}

ThreadPool::~ThreadPool() {
    if (workers_.empty()) return;
    quit_.store(true, std::memory_order_relaxed);
    gate_.fetch_add(one_range, std::memory_order_release);
    gate_.notify_all();
    for (std::thread& worker : workers_) worker.join();
}
#endif

void ThreadPool::parallel_for(int total, int grain, Split split, Call call, void* context) {
    call_ = call;
    context_ = context;
    grain_ = grain;
    split_ = split;
    const auto begin_of = [&](int t) {
        return static_cast<int>(static_cast<std::int64_t>(total) * t / count_);
    };
    for (int t = 0; t < count_; t++) {
        Cursor& cursor = cursors_[static_cast<std::size_t>(t)];
        cursor.next.store(begin_of(t), std::memory_order_relaxed);
        cursor.end = begin_of(t + 1);
        cursor.owned.store(false, std::memory_order_relaxed);
    }
    gate_.fetch_add(one_range | open, std::memory_order_release);
    gate_.notify_all();
    run_grains(0);
    // Closes the gate: a worker that has not entered by now cannot enter, so no thread waits for a
    // sleeping worker.
    gate_.fetch_and(~open, std::memory_order_relaxed);
    int spins = 0;
    while ((gate_.load(std::memory_order_acquire) & inside) != 0) {
        relax_cpu();
        if (++spins == spins_before_help)
            for (Cursor& cursor : cursors_) run_grains_of(cursor, false);
        if (spins > spins_before_sleep) yield_thread();
    }
}

// Starts with the thread's own part. Polling the other parts earlier would transfer their cursors
// between caches.
void ThreadPool::run_grains(int self) {
    cursors_[static_cast<std::size_t>(self)].owned.store(true, std::memory_order_relaxed);
    for (int k = 0; k < count_; k++)
        run_grains_of(cursors_[static_cast<std::size_t>((self + k) % count_)],
                      k > 0 && split_ == Split::fixed);
}

void ThreadPool::run_grains_of(Cursor& cursor, bool leave_to_owner) {
    for (;;) {
        if (leave_to_owner && cursor.owned.load(std::memory_order_relaxed)) return;
        const int begin = cursor.next.fetch_add(grain_, std::memory_order_relaxed);
        if (begin >= cursor.end) return;
        const int end = begin + grain_ < cursor.end ? begin + grain_ : cursor.end;
        call_(context_, begin, end);
    }
}

void ThreadPool::wake() {
    if (size() == 1) return;
    gate_.fetch_add(one_range, std::memory_order_release);
    gate_.notify_all();
}

void ThreadPool::start(std::function<void()> job) {
    if (size() == 1) return job();
    job_ = std::move(job);
    job_state_.store(Job::waiting, std::memory_order_release);
    // Changing the gate wakes the waiting workers, which then check for a job.
    gate_.fetch_add(one_range, std::memory_order_release);
    gate_.notify_all();
}

bool ThreadPool::run_job() {
    Job waiting = Job::waiting;
    if (!job_state_.compare_exchange_strong(waiting, Job::taken, std::memory_order_acquire))
        return false;
    job_();
    job_state_.store(Job::idle, std::memory_order_release);
    return true;
}

void ThreadPool::finish() {
    if (run_job()) return;
    int spins = 0;
    while (job_state_.load(std::memory_order_acquire) != Job::idle) {
        relax_cpu();
        if (++spins > spins_before_sleep) yield_thread();
    }
}

void ThreadPool::work(int self) {
    const FpModeScope fp_mode;
    std::uint64_t seen = 0;  // last range that this worker entered or found closed
    int spins = 0;
    for (;;) {
        // Load the gate first. A worker that sees the change caused by a job or by shutdown then
        // also sees the job or the shutdown. In the other order it could miss the shutdown and wait
        // for a change after the last one.
        std::uint64_t gate = gate_.load(std::memory_order_acquire);
        if (quit_.load(std::memory_order_relaxed)) return;
        if (job_state_.load(std::memory_order_relaxed) == Job::waiting && run_job()) spins = 0;
        if (gate / one_range == seen || (gate & open) == 0) {
            relax_cpu();
            if (++spins > spins_before_sleep) {
                gate_.wait(gate, std::memory_order_acquire);
                spins = 0;
            }
            continue;
        }
        spins = 0;
        if (!gate_.compare_exchange_weak(gate, gate + 1, std::memory_order_acquire)) continue;
        seen = gate / one_range;
        run_grains(self);
        gate_.fetch_sub(1, std::memory_order_release);
    }
}

}  // namespace jostle::physics
