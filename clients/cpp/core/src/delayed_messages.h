// SPDX-License-Identifier: MIT
//
// Messages in transit in one direction of a simulated network: each one leaves at the time that the
// network simulator determines, in order. One thread at a time.
#pragma once

#include <deque>
#include <optional>
#include <string>

#include "jostle/client/clock_sync.h"
#include "jostle/client/network_simulator.h"

namespace jostle::client {

class DelayedMessages {
public:
    explicit DelayedMessages(const NetworkConditions& settings) : link_(settings) {}

    void push(std::string bytes, Clock::time_point now) {
        const std::int64_t due_us = link_.arrival_us(static_cast<std::int64_t>(to_us(now)));
        queue_.push_back({std::move(bytes), due_us});
    }
    // Returns the next message that has arrived.
    std::optional<std::string> take(Clock::time_point now) {
        if (queue_.empty() || queue_.front().due_us > static_cast<std::int64_t>(to_us(now)))
            return std::nullopt;
        std::string bytes = std::move(queue_.front().bytes);
        queue_.pop_front();
        return bytes;
    }
    bool empty() const { return queue_.empty(); }

private:
    struct DelayedMessage {
        std::string bytes;
        std::int64_t due_us;
    };
    NetworkSimulator link_;
    std::deque<DelayedMessage> queue_;
};

}  // namespace jostle::client
