// SPDX-License-Identifier: MIT
//
// The state of a world: running, paused, stopped, failed or replaced. Any thread reads it;
// WorldHost changes it. Only the pause can be cleared.
#pragma once

#include <atomic>
#include <chrono>
#include <mutex>
#include <optional>
#include <string>
#include <utility>

#include "server/util/clock.h"
#include "server/util/thread_cpu_time.h"

namespace jostle::server {

class WorldLifecycle {
public:
    // Length of the first pause of an overloaded world. Each further pause is twice as long, up to
    // the maximum, until the world has run for `overload_reset` without one.
    static constexpr Clock::duration overload_pause = std::chrono::seconds(1);
    static constexpr Clock::duration overload_pause_max = std::chrono::seconds(60);
    static constexpr Clock::duration overload_reset = std::chrono::seconds(60);

    explicit WorldLifecycle(std::optional<std::string> paused) : paused_(std::move(paused)) {}

    // A paused world publishes frames and lets clients leave, but takes no steps and no inputs.
    void pause(std::string reason) {
        const std::lock_guard lock(mutex_);
        paused_ = std::move(reason);
        resume_at_.reset();
    }
    // Pauses an overloaded world for a limited time, which it appends to the reason. False: the
    // world is paused already.
    bool pause_overloaded(std::string reason, Clock::time_point now);
    // Clears the pause of an overloaded world whose time has passed. False: there is none.
    bool resume_if_due(Clock::time_point now);
    void clear_pause() {
        const std::lock_guard lock(mutex_);
        paused_.reset();
        resume_at_.reset();
    }
    // The reason; nothing: the world is not paused.
    std::optional<std::string> paused() const {
        const std::lock_guard lock(mutex_);
        return paused_;
    }
    // Whether the world resumes without an operator.
    bool resumes_by_itself() const {
        const std::lock_guard lock(mutex_);
        return resume_at_.has_value();
    }

    // Stopped on purpose, or ended by an error that the world could not survive.
    bool stopped() const { return stopped_.load(std::memory_order_relaxed); }
    bool failed() const { return failed_.load(std::memory_order_relaxed); }
    // Stopped because another host continues the world; its clients should reconnect.
    bool was_replaced() const { return was_replaced_.load(); }
    void set_stopped() { stopped_.store(true); }
    void set_failed() {
        failed_.store(true);
        stopped_.store(true);
    }
    // The replacement is set before the stop, so that no reader sees only the stop.
    void set_replaced() {
        was_replaced_.store(true);
        stopped_.store(true);
    }

    // The running tick, so far.
    struct TickUse {
        Clock::duration wall{}, cpu{};  // elapsed, and processor time of the tick thread
    };
    // Nothing between two ticks.
    std::optional<TickUse> running_tick(Clock::time_point now) const;
    // The tick thread.
    void begin_tick(Clock::time_point now);
    void end_tick() { tick_began_.store(0); }
    bool is_in_tick() const { return tick_began_.load(std::memory_order_relaxed) != 0; }

private:
    mutable std::mutex mutex_;
    std::optional<std::string> paused_;
    std::optional<Clock::time_point> resume_at_;  // of the pause of an overloaded world
    Clock::duration next_pause_ = overload_pause;
    Clock::time_point last_resumed_{};
    std::atomic<bool> stopped_{false}, failed_{false}, was_replaced_{false};
    ThreadCpuTime tick_thread_;
    std::atomic<Clock::rep> tick_began_{0};  // 0: between two ticks
    std::atomic<std::chrono::nanoseconds::rep> tick_cpu_began_{0};
};

}  // namespace jostle::server
