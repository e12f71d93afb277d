// SPDX-License-Identifier: MIT
//
// The state of a world: running, paused, stopped, failed or replaced. Any thread reads it;
// WorldHost changes it. Only the pause can be cleared.
#pragma once

#include <atomic>
#include <mutex>
#include <optional>
#include <string>
#include <utility>

#include "server/util/clock.h"

namespace jostle::server {

class WorldLifecycle {
public:
    explicit WorldLifecycle(std::optional<std::string> paused) : paused_(std::move(paused)) {}

    // A paused world publishes frames and lets clients leave, but takes no steps and no inputs.
    void pause(std::string reason) {
        const std::lock_guard lock(mutex_);
        paused_ = std::move(reason);
    }
    void clear_pause() {
        const std::lock_guard lock(mutex_);
        paused_.reset();
    }
    // The reason; nothing: the world is not paused.
    std::optional<std::string> paused() const {
        const std::lock_guard lock(mutex_);
        return paused_;
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

    // The start of the running tick; nothing between two ticks.
    std::optional<Clock::time_point> tick_began() const {
        const Clock::rep began = tick_began_.load(std::memory_order_relaxed);
        if (began == 0) return std::nullopt;
        return Clock::time_point(Clock::duration(began));
    }
    void begin_tick(Clock::time_point now) {
        tick_began_.store(now.time_since_epoch().count(), std::memory_order_relaxed);
    }
    void end_tick() { tick_began_.store(0, std::memory_order_relaxed); }

private:
    mutable std::mutex mutex_;
    std::optional<std::string> paused_;
    std::atomic<bool> stopped_{false}, failed_{false}, was_replaced_{false};
    std::atomic<Clock::rep> tick_began_{0};  // 0: between two ticks
};

}  // namespace jostle::server
