// SPDX-License-Identifier: MIT
//
// Processor time of a thread, read by another thread. Time in which the thread waits, or in which
// the machine or the process is stopped, does not count.
#pragma once

#include <atomic>
#include <chrono>
#include <optional>

#include <pthread.h>
#include <time.h>

namespace jostle::server {

class ThreadCpuTime {
public:
    // The thread to measure. It may end at any time.
    void use_this_thread() {
        clockid_t clock{};
        if (pthread_getcpuclockid(pthread_self(), &clock) == 0) clock_.store(clock);
    }
    // Any thread: the processor time since the start of that thread. Nothing: there is no thread,
    // or it has ended.
    std::optional<std::chrono::nanoseconds> now() const {
        timespec time{};
        const clockid_t clock = clock_.load();
        if (clock == none || clock_gettime(clock, &time) != 0) return std::nullopt;
        return std::chrono::seconds(time.tv_sec) + std::chrono::nanoseconds(time.tv_nsec);
    }

private:
    static constexpr clockid_t none = -1;
    std::atomic<clockid_t> clock_{none};
};

}  // namespace jostle::server
