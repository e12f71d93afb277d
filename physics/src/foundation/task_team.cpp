// SPDX-License-Identifier: MIT
#include "foundation/task_team.h"

#include "foundation/fp_mode.h"

namespace jostle::physics {
namespace {

// Between two ranges of one step there are microseconds; between two steps milliseconds. Spin
// through the former only.
constexpr int spins_before_sleep = 4000;

void relax_cpu() {
#if defined(__SSE2__)
    _mm_pause();
#elif defined(__aarch64__)
    asm volatile("yield");
#endif
}

}  // namespace

TaskTeam::TaskTeam(int threads) : count_(threads), cursors_(static_cast<std::size_t>(threads)) {
    for (int self = 1; self < threads; self++) workers_.emplace_back([this, self] { work(self); });
}

TaskTeam::~TaskTeam() {
    quit_.store(true, std::memory_order_relaxed);
    epoch_.fetch_add(1, std::memory_order_release);
    epoch_.notify_all();
    for (std::thread& worker : workers_) worker.join();
}

void TaskTeam::share_out(int total, int grain, Call call, void* context) {
    call_ = call;
    context_ = context;
    grain_ = grain;
    for (int t = 0; t < count_; t++) {
        Cursor& cursor = cursors_[static_cast<std::size_t>(t)];
        cursor.next.store(static_cast<int>(static_cast<std::int64_t>(total) * t / count_),
                          std::memory_order_relaxed);
        cursor.end = static_cast<int>(static_cast<std::int64_t>(total) * (t + 1) / count_);
    }
    busy_.store(count_ - 1, std::memory_order_relaxed);
    epoch_.fetch_add(1, std::memory_order_release);
    epoch_.notify_all();
    take_grains(0);
    int spins = 0;
    while (busy_.load(std::memory_order_acquire) != 0) {
        relax_cpu();
        if (++spins > spins_before_sleep) std::this_thread::yield();
    }
}

void TaskTeam::take_grains(int self) {
    for (int k = 0; k < count_; k++) {
        Cursor& cursor = cursors_[static_cast<std::size_t>((self + k) % count_)];
        for (;;) {
            const int begin = cursor.next.fetch_add(grain_, std::memory_order_relaxed);
            if (begin >= cursor.end) break;
            const int end = begin + grain_ < cursor.end ? begin + grain_ : cursor.end;
            call_(context_, begin, end);
        }
    }
}

void TaskTeam::work(int self) {
    const FpModeScope fp_mode;
    std::uint32_t seen = 0;
    for (;;) {
        int spins = 0;
        while (epoch_.load(std::memory_order_acquire) == seen) {
            relax_cpu();
            if (++spins > spins_before_sleep) epoch_.wait(seen, std::memory_order_acquire);
        }
        seen++;
        if (quit_.load(std::memory_order_relaxed)) return;
        take_grains(self);
        busy_.fetch_sub(1, std::memory_order_release);
    }
}

}  // namespace jostle::physics
